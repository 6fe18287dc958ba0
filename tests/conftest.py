"""What holds for every test."""

from hypothesis import settings

# every run of a commit sees the same examples: a failure is the change's, not the day's
settings.register_profile("same", derandomize=True, deadline=None)
settings.load_profile("same")

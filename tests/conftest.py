"""What holds for every test."""

from hypothesis import HealthCheck, settings

# every run of a commit sees the same examples: a failure is the change's, not the day's
# and no test fails because the machine is busy
settings.register_profile("same", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("same")

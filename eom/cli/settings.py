"""Parameter settings of the command line."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from eom.errors import EomError
from eom.vehicle.load import Vehicle, load


class UsageError(EomError):
    """A command line that says something wrong."""


def parse_settings(settings: Iterable[str]) -> dict[str, str]:
    """``NAME=VALUE`` texts as a mapping; every malformed one is named."""
    pairs = [text.partition("=") for text in settings]
    wrong = [f"--set {name}: expected NAME=VALUE, such as U=110km/h" for name, _, value in pairs if not value.strip()]
    names = [name.strip() for name, _, _ in pairs]
    wrong += [f"--set {name}: is given twice" for name in dict.fromkeys(names) if names.count(name) > 1]
    if wrong:
        raise UsageError("\n".join(wrong))
    return {name: value.strip() for name, (_, _, value) in zip(names, pairs, strict=True)}


def load_with(file: Path, settings: Sequence[str], swept: Mapping[str, str | float] | None = None) -> Vehicle:
    """The vehicle of a file with the command line's settings, and the value that a sweep has reached."""
    return load(file, **{**parse_settings(settings), **(swept or {})})

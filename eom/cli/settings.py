"""Parameter settings of the command line."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from eom.errors import EomError
from eom.vehicle.load import Vehicle, load


class UsageError(EomError):
    """A command line that says something wrong."""


def parse_settings(settings: Iterable[str]) -> dict[str, str]:
    """``NAME=VALUE`` texts as a mapping; every malformed one is named."""
    pairs = [text.partition("=") for text in settings]
    wrong = [f"--set {name}: expected NAME=VALUE, such as U=110km/h" for name, _, value in pairs if not value.strip()]
    if wrong:
        raise UsageError("\n".join(wrong))
    return {name.strip(): value.strip() for name, _, value in pairs}


def load_with(file: Path, settings: Sequence[str], **more: str | float) -> Vehicle:
    """The vehicle of a file with the command line's settings."""
    return load(file, **{**parse_settings(settings), **more})

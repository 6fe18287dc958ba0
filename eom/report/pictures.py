"""Figures as files."""

from pathlib import Path
from typing import TYPE_CHECKING

from eom.errors import EomError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = (".png", ".svg")


def check_picture(path: Path) -> None:
    """Raise `EomError` for a name whose ending tells no format."""
    if path.suffix.lower() not in FORMATS:
        raise EomError(f"{path}: expected a picture's name that ends in {' or '.join(FORMATS)}")


def save(figure: "Figure", path: Path) -> None:
    """Write a figure as its name's ending says; the same figure gives the same file."""
    import matplotlib as mpl  # noqa: PLC0415  slow to import

    with mpl.rc_context({"svg.hashsalt": "eom"}):
        figure.savefig(path, dpi=150, metadata={"Date": None} if path.suffix.lower() == ".svg" else None)

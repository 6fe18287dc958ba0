""".tir files: tyres of the Magic Formula as tyre makers and multibody programs exchange them."""

import dataclasses
import math
import stat
from collections.abc import Mapping
from dataclasses import dataclass, field
from decimal import Context, Decimal
from fractions import Fraction
from numbers import Real
from pathlib import Path
from typing import Any, NoReturn

from eom.errors import DescriptionError, Mistake, TyreError
from eom.tyre.tir.keys import Tyre, fields_of
from eom.tyre.tir.numbers import Place
from eom.tyre.tir.text import number, parse
from eom.tyre.tir.tyre import read_tyre
from eom.tyre.tir.write import write_whole

MAX_BYTES, HEAD_BYTES = 1_000_000, 4096
MAX_DIGITS = 30


@dataclass(frozen=True)
class TirFile:
    """A .tir file that was read.

    Attributes
    ----------
    file : str
        Its name as the user gave it.
    tyre : MagicFormula61 or MagicFormula52
        The tyre, in SI units.
    notes : tuple of Mistake
        What is worth knowing and no mistake, such as keys that are not modelled, each with its line and column.
    text : str
        The text as it was read, byte by byte in Latin-1.
    """

    file: str
    tyre: Tyre
    notes: tuple[Mistake, ...]
    text: str = field(repr=False)
    places: Mapping[str, Place] = field(repr=False)

    def text_with(self, **changes: float) -> str:
        """The text with other numbers, all else as it is: comments, order, units, keys that were not read.

        Parameters
        ----------
        **changes : float
            Coefficients by name, in SI units.

        Raises
        ------
        TyreError
            For a name that is no coefficient or not in the file, and for values that the tyre cannot have.
        """
        self.check_names(changes)
        new: dict[str, Any] = {name: plain(name, value) for name, value in changes.items()}
        changed = dataclasses.replace(self.tyre, **new)
        pieces: list[tuple[int, int, str]] = []
        for name, value in new.items():
            entries, factor = self.places[name]
            pieces += [(entry.start, len(entry.value), written(value, factor)) for entry in entries]
        text = self.text
        # from behind, so that places before stay where they are
        for start, length, piece in sorted(pieces, reverse=True):
            text = text[:start] + piece + text[start + length :]
        written_tyre = read_text(text, self.file).tyre
        names = [item.name for item in dataclasses.fields(changed)]
        other = [name for name in names if getattr(written_tyre, name) != getattr(changed, name)]
        if other:
            raise TyreError(
                f"{self.file}: {', '.join(other)} is not in the file and would change as well: use write_tir"
            )
        return text

    def write(self, path: str | Path, **changes: float) -> None:
        """Write the text with other numbers to a file; raises `TyreError` as `text_with` does, or if it cannot."""
        write_whole(path, self.text_with(**changes))

    def check_names(self, changes: Mapping[str, float]) -> None:
        """Raise `TyreError` for a name that is no number of the file."""
        for name in changes:
            if name not in fields_of(type(self.tyre)):
                raise TyreError(f"{self.file}: {name} is no coefficient of a {type(self.tyre).__name__}")
            if name not in self.places:
                raise TyreError(f"{self.file}: {name} is not given in the file: write_tir writes a complete one")


def read_tir(path: str | Path) -> TirFile:
    """Read a .tir file of the Magic Formula 6.1, 6.0 or 6.2 (FITTYP 61, 60, 62), or 5.2 (FITTYP 6, PAC2002).

    Parameters
    ----------
    path : str or Path
        The file, of at most 1 MB.

    Returns
    -------
    TirFile
        The tyre in SI units, notes, and the text.

    Raises
    ------
    DescriptionError
        With every mistake of the file, each with its line and column: unknown, missing and contradictory keys, text
        where a number is needed, numbers out of their bounds, another kind of tyre; or a file that is not text, too
        large or cannot be read.
    """
    return read_text(read_bytes(path).decode("latin-1"), str(path))


def read_text(text: str, file: str) -> TirFile:
    """Read the text of a .tir file; *file* is its name in messages. Raises `DescriptionError` as `read_tir` does."""
    reading = read_tyre(parse(text, file))
    return TirFile(file, reading.tyre, reading.notes, text, reading.places)


def read_bytes(path: str | Path) -> bytes:
    """The bytes of a regular file of text that is not too large; it is not read otherwise."""
    try:
        status = Path(path).stat()
        if stat.S_ISDIR(status.st_mode):
            refuse(path, "is a folder, expected a .tir file")
        if not stat.S_ISREG(status.st_mode):
            refuse(path, "is no regular file, expected a .tir file")
        if status.st_size > MAX_BYTES:
            refuse(path, f"has {status.st_size} bytes; a .tir file has at most {MAX_BYTES}")
        with Path(path).open("rb") as stream:
            head = stream.read(HEAD_BYTES)
            content = b"\0" if b"\0" in head else head + stream.read(MAX_BYTES)
    except (OSError, ValueError) as error:
        refuse(path, f"cannot be read: {error.strerror if isinstance(error, OSError) else error}")
    if b"\0" in content:
        refuse(path, "is a binary file or has two bytes per letter; a .tir file is text of one byte per letter")
    return content


def refuse(path: str | Path, what: str) -> NoReturn:
    """Raise the one mistake about a file as a whole."""
    raise DescriptionError([Mistake(str(path), 0, 0, "", what)])


def plain(name: str, value: object) -> float:
    """A finite number as a float."""
    try:
        scalar = float(value) if isinstance(value, Real) else math.nan
    except OverflowError:
        scalar = math.inf
    if not math.isfinite(scalar):
        raise TyreError(f"{name} = {value}: expected a finite number")
    return scalar


def written(value: float, factor: Fraction) -> str:
    """The number in a file's unit with the fewest digits that reads as *value* in SI."""
    exact = Fraction(value) / factor
    numerator, denominator = Decimal(exact.numerator), Decimal(exact.denominator)
    for digits in range(1, MAX_DIGITS):
        rounded = Context(prec=digits).divide(numerator, denominator)
        # as Python writes floats, but for numbers that are beyond them in the file's unit
        short = repr(float(rounded)) if Decimal(repr(float(rounded))) == rounded else str(rounded)
        if reads_as(short, factor) == value:
            return short
    return str(Context(prec=MAX_DIGITS).divide(numerator, denominator))


def reads_as(text: str, factor: Fraction) -> float:
    """The number of a text in SI units; infinite beyond floats."""
    try:
        return float((number(text) or 0) * factor)
    except OverflowError:
        return math.inf

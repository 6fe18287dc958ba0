"""A tyre to the text of a complete .tir file in SI units, and files that are written whole or not at all."""

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from eom.errors import TyreError
from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61
from eom.tyre.tir.keys import SECTION_OF, SECTIONS, Tyre, fields_of
from eom.tyre.tir.model import USES

HEAD = """\
[MDI_HEADER]
FILE_TYPE                = 'tir'
FILE_VERSION             = 3.0
FILE_FORMAT              = 'ASCII'
[UNITS]
LENGTH                   = 'meter'
FORCE                    = 'newton'
ANGLE                    = 'radian'
MASS                     = 'kg'
TIME                     = 'second'
PRESSURE                 = 'pascal'
"""


def write_tir(tyre: Tyre, path: str | Path) -> None:
    """Write a tyre as a complete .tir file in SI units, from which `read_tir` gives an equal tyre.

    Parameters
    ----------
    tyre : MagicFormula61 or MagicFormula52
        One tyre: each coefficient a number.
    path : str or Path
        The file; one that is there is replaced once the new one is complete.

    Raises
    ------
    TyreError
        For another tyre, or for several in one object, and for a file that cannot be written.
    """
    write_whole(path, tir_text(tyre))


def tir_text(tyre: Tyre) -> str:
    """The text of a complete .tir file in SI units; raises `TyreError` as `write_tir` does."""
    if not isinstance(tyre, MagicFormula61 | MagicFormula52):
        raise TyreError(f"a .tir file holds a MagicFormula61 or MagicFormula52, not a {type(tyre).__name__}")
    several = [name for name in fields_of(type(tyre)) if np.ndim(getattr(tyre, name))]
    if several:
        raise TyreError(f"a .tir file holds one tyre: {', '.join(several)} should be numbers, not arrays")
    return HEAD + "".join(f"{line}\n" for line in body(tyre))


def body(tyre: Tyre) -> Iterator[str]:
    """The lines of the sections that hold the tyre."""
    fields = fields_of(type(tyre))
    for section in SECTIONS:
        own = [item for name, item in fields.items() if SECTION_OF[name] == section]
        if own:
            yield f"[{section}]"
        if section == "MODEL":
            yield from model(tyre)
        for item in own:
            value = float(getattr(tyre, item.name))
            unit = item.metadata.get("limit_unit", item.metadata.get("unit"))
            # a range without an end has no key
            if math.isfinite(value):
                comment = f"{unit}, {item.metadata['meaning']}" if unit else item.metadata["meaning"]
                yield f"{item.name:<24} = {value!r:<24} $ {comment}"


def model(tyre: Tyre) -> Iterator[str]:
    """The lines that say which equations are used and how."""
    newer = isinstance(tyre, MagicFormula61)
    mode = next(digit for digit, use in USES.items() if use == tyre.use)
    yield f"PROPERTY_FILE_FORMAT     = '{'MF-TYRE' if newer else 'PAC2002'}'"
    yield f"FITTYP                   = {61 if newer else 6}"
    yield f"USE_MODE                 = {-mode if tyre.mirror else mode}"
    yield f"TYRESIDE                 = '{(tyre.side or 'unknown').upper()}'"
    if isinstance(tyre, MagicFormula61) and tyre.form == "book":
        yield "FORM                     = 'book'                   $ equations as in Pacejka's book"


def write_whole(path: str | Path, text: str) -> None:
    """Write a text of Latin-1 beside the file, then put it in its place."""
    try:
        target = Path(path).resolve()
        draft = target.with_name(f"{target.name}.part")
        try:
            draft.write_bytes(text.encode("latin-1"))
            draft.replace(target)
        finally:
            draft.unlink(missing_ok=True)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise TyreError(f"{path} cannot be written: {reason}") from None

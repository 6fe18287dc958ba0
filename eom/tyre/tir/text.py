"""Text of a .tir file to its entries: sections, keys, values and where they stand; no meaning yet."""

import re
from dataclasses import dataclass, field
from fractions import Fraction

from eom.errors import Mistake

BYTE_ORDER_MARK = "\u00ef\u00bb\u00bf"
"""The mark of UTF-8 as Latin-1 shows it."""
LINE = re.compile(r"([^\r\n]*)(?:\r\n|\r|\n|$)")
COMMENT = re.compile(r"[$!]")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][-+]?\d{1,4})?", re.ASCII)
MAX_NUMBER, MAX_EXPONENT, MAX_SHOWN = 60, 400, 40


@dataclass(frozen=True)
class Entry:
    """A key with its value.

    Attributes
    ----------
    section, key : str
        In upper case.
    value : str
        Without quotes, comment and blanks around it.
    quoted : bool
        Whether it stands in quotes.
    line, column, value_column : int
        Where the key and its value stand, counted from 1.
    start : int
        Where the value starts in the text, without its quote, counted from 0.
    """

    section: str
    key: str
    value: str
    quoted: bool
    line: int
    column: int
    value_column: int
    start: int

    @property
    def blank(self) -> bool:
        """Whether it has no value, which says as little as no key."""
        return not self.value and not self.quoted

    @property
    def where(self) -> str:
        """The path of the key."""
        return f"{self.section}.{self.key}"


@dataclass
class TirText:
    """What a text says: its entries in order, the line of each section, rows of tables; and what it says wrong."""

    file: str
    entries: list[Entry] = field(default_factory=list)
    sections: dict[str, int] = field(default_factory=dict)
    rows: dict[str, list[tuple[int, int, str]]] = field(default_factory=dict)
    mistakes: list[Mistake] = field(default_factory=list)
    notes: list[Mistake] = field(default_factory=list)

    def report(self, place: tuple[int, int], where: str, what: str) -> None:
        """Add a mistake at a line and column."""
        self.mistakes.append(Mistake(self.file, *place, where, what))

    def report_value(self, entry: Entry, what: str) -> None:
        """Add a mistake at the value of an entry."""
        self.report((entry.line, entry.value_column), entry.where, what)

    def report_key(self, entry: Entry, what: str) -> None:
        """Add a mistake at the key of an entry."""
        self.report((entry.line, entry.column), entry.where, what)

    def note(self, place: tuple[int, int], where: str, what: str) -> None:
        """Add what is worth knowing and no mistake."""
        self.notes.append(Mistake(self.file, *place, where, what))

    def note_key(self, entry: Entry, what: str) -> None:
        """Add a note at the key of an entry."""
        self.note((entry.line, entry.column), entry.where, what)


def number(text: str) -> Fraction | None:
    """The exact number that a text says, in Fortran's notation too; None if it says none, or a monstrous one.

    >>> number("+1.5D-01"), number("1,5")
    (Fraction(3, 20), None)
    """
    if len(text) > MAX_NUMBER or not NUMBER.fullmatch(text):
        return None
    mantissa, _, exponent = text.upper().replace("D", "E").partition("E")
    power = int(exponent or 0)
    if abs(power) > MAX_EXPONENT:
        return None
    return Fraction(mantissa) * Fraction(10) ** power


def parse(text: str, file: str) -> TirText:
    """The entries of a text, in order, with a mistake for every line that is none; in linear time."""
    found = TirText(file)
    section, start = "", len(BYTE_ORDER_MARK) if text.startswith(BYTE_ORDER_MARK) else 0
    for count, match in enumerate(LINE.finditer(text, start), start=1):
        line = match[1]
        content = line.strip()
        place = (count, len(line) - len(line.lstrip()) + 1)
        if content.startswith("["):
            section = read_section(found, content, place) or section
        elif content and content[0] not in "$!{":
            read_line(found, section, line, place, match.start())
    return found


def read_section(found: TirText, content: str, place: tuple[int, int]) -> str:
    """The name of a section, empty if the line is not one."""
    name, closed, rest = content[1:].partition("]")
    name, rest = name.strip().upper(), rest.strip()
    if not name or not closed or (rest and rest[0] not in "$!"):
        found.report(place, "", f"expected a section such as [MODEL], got {shown(content)}")
        return ""
    found.sections.setdefault(name, place[0])
    return name


def read_line(found: TirText, section: str, line: str, place: tuple[int, int], position: int) -> None:
    """Add the entry or the row of a table that a line is."""
    key, equals, after = line.partition("=")
    name = key.strip().upper()
    if not section:
        found.report(place, "", f"expected a section such as [MODEL] first, got {shown(line.strip())}")
    elif not equals or not name or COMMENT.search(name):
        found.rows.setdefault(section, []).append((*place, line.strip()))
    else:
        blanks = len(after) - len(after.lstrip())
        value = read_value(after.strip())
        quoted = after[blanks : blanks + 1] in {"'", '"'}
        # a value that is not there would stand before the comment and its blanks
        column = len(key) + 1 + (blanks if value or quoted else min(blanks, 1))
        if value is None:
            what = f"expected a value in closed quotes, then at most a comment, got {shown(after.strip())}"
            found.report((place[0], column + 1), f"{section}.{name}", what)
        else:
            start = position + column + quoted
            found.entries.append(Entry(section, name, value, quoted, *place, column + 1, start))


def read_value(after: str) -> str | None:
    """The value without quotes and comment; None if the quotes are not closed or text follows them."""
    if after[:1] not in {"'", '"'}:
        return COMMENT.split(after, maxsplit=1)[0].strip()
    value, closed, rest = after[1:].partition(after[0])
    return value.strip() if closed and (not rest.strip() or rest.strip()[0] in "$!") else None


def shown(text: str) -> str:
    """Text of a file as a message shows it: in quotes, printable, and not too long."""
    printable = "".join(sign if sign.isprintable() else " " for sign in text[: MAX_SHOWN + 1])
    return f"'{printable[: MAX_SHOWN - 3]}...'" if len(printable) > MAX_SHOWN else f"'{printable}'"

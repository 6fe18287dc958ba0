"""Text of a vehicle file to plain data in which every key and value knows its line and column.

YAML's traps are closed here: anchors that explode, tags that run code, duplicate keys, merge keys, `off` as
false, leading zeros, sexagesimals, numbers like 1e6 read as text, numbers beyond range.
"""

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NoReturn

import yaml

from eom.errors import DescriptionError, Mistake

if TYPE_CHECKING:
    from yaml._yaml import Mark as CMark

Path = tuple[str | int, ...]
Data = dict[str, "Data"] | list["Data"] | str | float | bool | None

MAX_BYTES, MAX_DEPTH, MAX_VALUES, MAX_KEY = 1_000_000, 30, 60_000, 60
NUMBER = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
LEADING_ZERO = re.compile(r"[-+]?0\d")
EMPTY = {"", "~", "null", "Null", "NULL"}
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclass
class Source:
    """A file's data, the place of each of its keys and values, and the mistakes found while reading."""

    file: str
    data: dict[str, Data] = field(default_factory=dict)
    marks: dict[Path, tuple[int, int]] = field(default_factory=dict)
    keys: dict[Path, tuple[int, int]] = field(default_factory=dict)
    mistakes: list[Mistake] = field(default_factory=list)

    def mark(self, path: Path) -> tuple[int, int]:
        """Line and column of *path*, or of the nearest key above it."""
        while path and path not in self.marks:
            path = path[:-1]
        return self.marks.get(path, (1, 1))

    def mistake(self, path: Path, what: str) -> Mistake:
        """A mistake at *path*."""
        return self.mistake_at(self.mark(path), path, what)

    def mistake_at(self, place: tuple[int, int], path: Path, what: str) -> Mistake:
        """A mistake about *path* at a line and column."""
        line, column = place
        return Mistake(self.file, line, column, ".".join(map(str, path)), what)

    def report(self, path: Path, what: str) -> None:
        """Add a mistake at *path*."""
        self.mistakes.append(self.mistake(path, what))

    def report_key(self, path: Path, what: str) -> None:
        """Add a mistake at the key, not at its value."""
        self.mistakes.append(self.mistake_at(self.keys.get(path) or self.mark(path), path, what))


def read_source(text: str, file: str) -> Source:
    """Parse the text; raises `DescriptionError` if it is no YAML mapping or too large to be a vehicle."""
    source = Source(file)
    if len(text) > MAX_BYTES:
        refuse(source, f"the file has {len(text)} characters; a vehicle file has at most {MAX_BYTES}")
    try:
        check_events(text, source)
        root = yaml.compose(text, Loader=LOADER)
    except yaml.MarkedYAMLError as error:
        place = place_of(error.problem_mark or error.context_mark)
        raise DescriptionError([source.mistake_at(place, (), yaml_problem(error, text))]) from None
    except yaml.reader.ReaderError as error:
        before = text[: error.position].splitlines() or [""]
        refuse(source, f"not readable as text: {error.reason}", (len(before), len(before[-1]) + 1))
    if not isinstance(root, yaml.MappingNode):
        refuse(source, "a vehicle file is a mapping of keys such as 'bodies:' and 'parameters:'")
    data = Reader(source).plain(root, ())
    if not isinstance(data, dict):
        raise DescriptionError(source.mistakes)
    source.data = data
    return source


def refuse(source: Source, what: str, place: tuple[int, int] = (1, 1)) -> NoReturn:
    """Raise the one mistake that makes reading on pointless."""
    raise DescriptionError([source.mistake_at(place, (), what)])


def place_of(mark: "yaml.Mark | CMark | None") -> tuple[int, int]:
    """Line and column of a YAML mark, counted from 1."""
    return (mark.line + 1, mark.column + 1) if mark else (1, 1)


def yaml_problem(error: yaml.MarkedYAMLError, text: str) -> str:
    """The sentence for text that YAML cannot read, with the place where the broken part began."""
    line, column = place_of(error.problem_mark)
    if "nesting depth" in str(error.problem):
        return f"nested more than {MAX_DEPTH} deep"
    if "\t" in "".join(text.splitlines()[line - 1 : line])[:column]:
        return "not readable as YAML: indent with spaces, not with tabs"
    began = place_of(error.context_mark)
    since = f" {error.context}, begun in line {began[0]} column {began[1]}" if error.context_mark else ""
    return f"not readable as YAML: {error.problem or error.context}{since}"


def check_events(text: str, source: Source) -> None:
    """Bound depth and size before anything recursive sees the text, and refuse tags and several documents."""
    depth = count = documents = 0
    for event in yaml.parse(text, Loader=LOADER):
        place = place_of(event.start_mark)
        if isinstance(event, yaml.DocumentStartEvent):
            documents += 1
            if documents > 1:
                refuse(source, "a vehicle file is one document: '---' starts a second one", place)
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > MAX_DEPTH:
                refuse(source, f"nested more than {MAX_DEPTH} deep", place)
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
        if isinstance(event, yaml.NodeEvent):
            count += 1
            if count > MAX_VALUES:
                refuse(source, f"more than {MAX_VALUES} keys and values", place)
        tag = getattr(event, "tag", None)
        if tag is not None:
            refuse(source, f"the tag '{tag[:60]}' is not read: write plain keys and values", place)


class Reader:
    """Walks the node tree, expanding anchors within a budget."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.values = 0

    def plain(self, node: yaml.Node, path: Path) -> Data:
        """The data of *node*; marks and mistakes go to the source."""
        self.values += 1
        place = place_of(node.start_mark)
        if self.values > MAX_VALUES or len(path) > MAX_DEPTH:
            refuse(self.source, "its anchors repeat without end or measure", place)
        self.source.marks[path] = place
        if isinstance(node, yaml.MappingNode):
            entries = dict(self.entries(node, path))
            # what a merge key would have added is missing, so that nothing can be said about the rest
            return None if any(key.value == "<<" for key, _ in node.value) else entries
        if isinstance(node, yaml.SequenceNode):
            return [self.plain(child, (*path, k)) for k, child in enumerate(node.value)]
        return self.scalar(str(node.value), quoted=getattr(node, "style", None) in {"'", '"', "|", ">"}, path=path)

    def entries(self, node: yaml.MappingNode, path: Path) -> Iterator[tuple[str, Data]]:
        """Key and value pairs; the mark of each is its key's."""
        seen: dict[str, int] = {}
        for key_node, value_node in node.value:
            place = place_of(key_node.start_mark)
            problem = self.key_problem(key_node, seen)
            if problem:
                here = (*path, key_node.value) if "twice" in problem else path
                self.source.mistakes.append(self.source.mistake_at(place, here, problem))
                continue
            key = key_node.value
            here = (*path, key)
            seen[key] = place[0]
            value = self.plain(value_node, here)
            self.source.keys[here] = place
            # a mistake about an entry points at its key, one about a plain value at the value
            if not isinstance(value_node, yaml.ScalarNode):
                self.source.marks[here] = place
            yield key, value

    def key_problem(self, node: yaml.Node, seen: Mapping[str, int]) -> str:
        """The sentence for a key that cannot be read, empty for a good one."""
        if not isinstance(node, yaml.ScalarNode):
            return "a key must be a plain name"
        key = node.value
        if len(key) > MAX_KEY:
            return f"the key '{key[:20]}...' has {len(key)} characters, at most {MAX_KEY} are read"
        if key == "<<":
            return "merge keys are not read: use a template or a parameter"
        if key in seen:
            return f"the key '{key}' stands here twice, first in line {seen[key]}: keep one"
        return ""

    def scalar(self, text: str, *, quoted: bool, path: Path) -> Data:
        """A number, true, false, or text; all else that YAML would guess stays text. None: a reported mistake."""
        if quoted or text in {"true", "false"}:
            return text if quoted else text == "true"
        if not NUMBER.fullmatch(text):
            if text not in EMPTY:
                return text
            self.source.report(path, "has no value")
        elif LEADING_ZERO.match(text):
            self.source.report(path, f"'{text[:60]}' has a leading zero, which YAML reads as octal: write it without")
        elif math.isfinite(float(text)):
            return float(text)
        else:
            self.source.report(path, f"'{text[:60]}' is too large for a number")
        return None

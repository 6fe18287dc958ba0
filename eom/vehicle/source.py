"""Text of a vehicle file to plain data in which every key and value knows its line and column.

YAML's traps are closed here: anchors that explode, tags that run code, duplicate keys, merge keys, `off` as
false, leading zeros, sexagesimals, numbers like 1e6 read as text, numbers beyond range.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NoReturn

import yaml

from eom.errors import DescriptionError, Mistake

Path = tuple[str | int, ...]
Data = dict[str, "Data"] | list["Data"] | str | float | bool | None

MAX_BYTES, MAX_DEPTH, MAX_VALUES = 1_000_000, 30, 20_000
NUMBER = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")
LEADING_ZERO = re.compile(r"[-+]?0\d")
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclass
class Source:
    """A file's data, the place of each of its keys and values, and the mistakes found while reading."""

    file: str
    data: dict[str, Data] = field(default_factory=dict)
    marks: dict[Path, tuple[int, int]] = field(default_factory=dict)
    mistakes: list[Mistake] = field(default_factory=list)

    def mark(self, path: Path) -> tuple[int, int]:
        """Line and column of *path*, or of the nearest key above it."""
        while path and path not in self.marks:
            path = path[:-1]
        return self.marks.get(path, (1, 1))

    def mistake(self, path: Path, what: str) -> Mistake:
        """A mistake at *path*."""
        line, column = self.mark(path)
        return Mistake(self.file, line, column, ".".join(map(str, path)), what)

    def report(self, path: Path, what: str) -> None:
        """Add a mistake at *path*."""
        self.mistakes.append(self.mistake(path, what))


def read_source(text: str, file: str) -> Source:
    """Parse the text; raises `DescriptionError` if it is no YAML mapping or too large to be a vehicle."""
    source = Source(file)
    if len(text) > MAX_BYTES:
        refuse(source, f"the file has {len(text)} characters; a vehicle file has at most {MAX_BYTES}")
    try:
        check_events(text, source)
        root = yaml.compose(text, Loader=LOADER)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
        problem = f"not readable as YAML: {error.problem or error.context}"
        raise DescriptionError([Mistake(file, line, column, "", problem)]) from None
    except yaml.reader.ReaderError as error:
        refuse(source, f"not readable as text: {error.reason} at position {error.position}")
    if not isinstance(root, yaml.MappingNode):
        refuse(source, "a vehicle file is a mapping of keys such as 'bodies:' and 'parameters:'")
    reader = Reader(source)
    data = reader.plain(root, ())
    if isinstance(data, dict):
        source.data = data
    return source


def refuse(source: Source, what: str, line: int = 1, column: int = 1) -> NoReturn:
    """Raise the one mistake that makes reading on pointless."""
    raise DescriptionError([Mistake(source.file, line, column, "", what)])


def check_events(text: str, source: Source) -> None:
    """Bound depth and size before anything recursive sees the text, and refuse tags and several documents."""
    depth = count = documents = 0
    for event in yaml.parse(text, Loader=LOADER):
        mark = event.start_mark
        line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
        if isinstance(event, yaml.DocumentStartEvent):
            documents += 1
            if documents > 1:
                refuse(source, "a vehicle file is one document: '---' starts a second one", line, column)
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > MAX_DEPTH:
                refuse(source, f"nested more than {MAX_DEPTH} deep", line, column)
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
        if isinstance(event, yaml.NodeEvent):
            count += 1
            if count > MAX_VALUES:
                refuse(source, f"more than {MAX_VALUES} keys and values", line, column)
        tag = getattr(event, "tag", None)
        if tag is not None:
            refuse(source, f"the tag '{tag[:60]}' is not read: write plain keys and values", line, column)


class Reader:
    """Walks the node tree, expanding anchors within a budget."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.values = 0

    def plain(self, node: yaml.Node, path: Path) -> Data:
        """The data of *node*; marks and mistakes go to the source."""
        self.values += 1
        mark = node.start_mark
        if self.values > MAX_VALUES or len(path) > MAX_DEPTH:
            refuse(self.source, "its anchors repeat without end or measure", mark.line + 1, mark.column + 1)
        self.source.marks[path] = (mark.line + 1, mark.column + 1)
        if isinstance(node, yaml.MappingNode):
            return dict(self.entries(node, path))
        if isinstance(node, yaml.SequenceNode):
            return [self.plain(child, (*path, k)) for k, child in enumerate(node.value)]
        return self.scalar(node, path) if isinstance(node, yaml.ScalarNode) else None

    def entries(self, node: yaml.MappingNode, path: Path) -> Iterator[tuple[str, Data]]:
        """Key and value pairs; the mark of each is its key's."""
        seen: dict[str, int] = {}
        for key_node, value_node in node.value:
            mark = key_node.start_mark
            place = (mark.line + 1, mark.column + 1)
            if not isinstance(key_node, yaml.ScalarNode):
                self.source.mistakes.append(
                    Mistake(self.source.file, *place, ".".join(map(str, path)), "a key must be a plain name")
                )
                continue
            key = key_node.value
            here = (*path, key)
            if key in seen:
                what = f"the key '{key}' stands here twice, first in line {seen[key]}: keep one"
                self.source.mistakes.append(Mistake(self.source.file, *place, ".".join(map(str, here)), what))
                continue
            seen[key] = place[0]
            value = self.plain(value_node, here)
            # a mistake about an entry points at its key, one about a plain value at the value
            if not isinstance(value_node, yaml.ScalarNode):
                self.source.marks[here] = place
            if key == "<<":
                self.source.report(here, "merge keys are not read: use a template or a parameter")
                continue
            yield key, value

    def scalar(self, node: yaml.ScalarNode, path: Path) -> Data:
        """A number, true, false, or text; everything else that YAML would guess stays text."""
        text = str(node.value)
        if node.style in {"'", '"', "|", ">"}:
            return text
        if LEADING_ZERO.match(text) and NUMBER.fullmatch(text):
            self.source.report(path, f"'{text}' has a leading zero, which YAML reads as octal: write it without")
            return 0.0
        if NUMBER.fullmatch(text):
            value = float(text)
            if not math.isfinite(value):
                self.source.report(path, f"'{text[:60]}' is too large for a number")
                return 0.0
            return value
        if text in {"true", "false"}:
            return text == "true"
        if text in {"", "~", "null"}:
            self.source.report(path, "has no value")
            return None
        return text

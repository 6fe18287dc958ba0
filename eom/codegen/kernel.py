"""The part of `eom` that a generated module carries: from some names, everything that they need, by file."""

import ast
import functools
import inspect
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import NamedTuple

PACKAGE = "eom"


class Definition(NamedTuple):
    """Functions, classes or constants that one piece of source defines, and the names that it refers to."""

    names: tuple[str, ...]
    text: str
    needs: frozenset[str]


@dataclass(frozen=True)
class File:
    """A file of the kernel.

    Attributes
    ----------
    title : str
        First line of its docstring.
    definitions : tuple of Definition
        In order.
    imported : dict
        (module, name) of every name from another file of `eom`.
    others : dict
        Import statement of every other name, as (module, name); the name is empty for a module.
    """

    title: str
    definitions: tuple[Definition, ...]
    imported: dict[str, tuple[str, str]]
    others: dict[str, tuple[str, str]]


class Kernel(NamedTuple):
    """Sections (title, source) in an order in which Python can run them, and imports by name; see `File.others`."""

    sections: tuple[tuple[str, str], ...]
    imports: dict[str, tuple[str, str]]


def kernel(roots: Collection[tuple[str, str]], given: Collection[str] = ()) -> Kernel:
    """What *roots*, as (module, name), need; *given* names are written by the generated module itself."""
    wanted: dict[str, set[str]] = {}
    order: list[str] = []
    imports: dict[str, tuple[str, str]] = {}
    pending = list(roots)
    while pending:
        module, name = pending.pop()
        if name in given or name in wanted.setdefault(module, set()):
            continue
        file = parsed(module)
        wanted[module].add(name)
        for need in definition_of(file, module, name).needs:
            if need in file.imported:
                pending.append(file.imported[need])
            elif need in file.others:
                imports[need] = file.others[need]
            elif any(need in item.names for item in file.definitions):
                pending.append((module, need))
    for module in sorted(wanted):
        visit(module, wanted, order)
    sections = [(parsed(module).title, section(parsed(module), wanted[module])) for module in order]
    return Kernel(tuple(item for item in sections if item[1]), imports)


def visit(module: str, wanted: Collection[str], order: list[str]) -> None:
    """Append a file after those that it imports."""
    if module in order or module not in wanted:
        return
    for other in sorted({source for source, _ in parsed(module).imported.values()}):
        visit(other, wanted, order)
    order.append(module)


def section(file: File, names: Collection[str]) -> str:
    """Source of those definitions of a file that are wanted."""
    kept = [item.text for item in file.definitions if set(item.names) & set(names)]
    return "".join(kept).strip()


def definition_of(file: File, module: str, name: str) -> Definition:
    """The definition of a name."""
    for item in file.definitions:
        if name in item.names:
            return item
    message = f"{module} does not define {name}"
    raise LookupError(message)


def defined(sections: Collection[tuple[str, str]]) -> list[str]:
    """All names that sections define, as often as they do."""
    return [name for _, text in sections for node in ast.parse(text).body for name in names_of(node)]


@functools.cache
def parsed(module: str) -> File:
    """A file of `eom` in parts."""
    owner = import_module(module)
    lines = inspect.getsource(owner).splitlines(keepends=True)
    body = ast.parse("".join(lines)).body
    imported: dict[str, tuple[str, str]] = {}
    others: dict[str, tuple[str, str]] = {}
    end = body[0].end_lineno or 1
    pieces: list[tuple[tuple[str, ...], int, int, set[str]]] = []
    for node in body[1:]:
        match node:
            case ast.ImportFrom(module=str(source)):
                into = imported if source.startswith(PACKAGE) else others
                into |= {alias.asname or alias.name: (source, alias.name) for alias in node.names}
            case ast.Import():
                others |= {alias.asname or alias.name: (alias.name, "") for alias in node.names}
            case ast.Expr() if pieces:
                # a docstring belongs to the constant above it
                names, start, _, needs = pieces[-1]
                pieces[-1] = (names, start, node.end_lineno or 0, needs)
            case _:
                pieces.append((tuple(names_of(node)), end, node.end_lineno or 0, set(used(node))))
        end = node.end_lineno or 0
    definitions = tuple(
        Definition(names, "".join(lines[start:stop]), frozenset(needs)) for names, start, stop, needs in pieces
    )
    return File((owner.__doc__ or "").splitlines()[0], definitions, imported, others)


def names_of(node: ast.stmt) -> Iterator[str]:
    """The names that a statement defines."""
    match node:
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            yield name
        case ast.Assign(targets=targets):
            for target in targets:
                yield from (part.id for part in ast.walk(target) if isinstance(part, ast.Name))
        case ast.AnnAssign(target=ast.Name(id=name)):
            yield name


def used(node: ast.AST) -> Iterator[str]:
    """The names that source refers to, in annotations that are texts too."""
    for part in ast.walk(node):
        if isinstance(part, ast.Name):
            yield part.id
        elif isinstance(part, ast.Constant) and isinstance(part.value, str) and part.value.isprintable():
            try:
                inner = ast.parse(part.value, mode="eval")
            except SyntaxError:
                continue
            yield from (name.id for name in ast.walk(inner) if isinstance(name, ast.Name))

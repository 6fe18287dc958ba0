"""What a generated module carries besides the vehicle: the kernel that its text calls, and imports."""

import ast
from collections.abc import Iterable, Mapping, Sequence

from eom.codegen.kernel import kernel, names_of, parsed, used

OTHERS: Mapping[str, tuple[str, str]] = {
    "Any": ("typing", "Any"),
    "ArrayLike": ("numpy.typing", "ArrayLike"),
    "Callable": ("collections.abc", "Callable"),
    "Mapping": ("collections.abc", "Mapping"),
    "NamedTuple": ("typing", "NamedTuple"),
    "lru_cache": ("functools", "lru_cache"),
    "math": ("math", ""),
    "np": ("numpy", ""),
}
"""Names that the text of a module may use of other packages."""


def carried(text: str, modules: Sequence[str]) -> tuple[tuple[tuple[str, str], ...], str]:
    """Sections (title, source) of the kernel that the *text* of a module needs of *modules*, and its imports."""
    tree = ast.parse(text)
    own = {name for node in tree.body for name in names_of(node)}
    needed = set(used(tree)) - own
    roots = [
        (module, name)
        for module in modules
        for item in parsed(module).definitions
        for name in item.names
        if name in needed
    ]
    found = kernel(roots, own)
    return found.sections, import_text({**found.imports, **{k: v for k, v in OTHERS.items() if k in needed}})


def import_text(imports: Mapping[str, tuple[str, str]]) -> str:
    """Import statements: the standard library's, then NumPy's."""
    numpy = {key: item for key, item in imports.items() if item[0].startswith("numpy")}
    standard = {key: item for key, item in imports.items() if key not in numpy}
    return "\n\n".join("\n".join(statements(group)) for group in (standard, numpy) if group)


def statements(imports: Mapping[str, tuple[str, str]]) -> Iterable[str]:
    """Statements in the order in which tools sort them."""
    for name, (module, _) in sorted(imports.items(), key=lambda item: item[1]):
        if not imports[name][1]:
            yield f"import {module}" + (f" as {name}" if name != module else "")
    for module in sorted({module for module, name in imports.values() if name}):
        names = sorted((name for source, name in imports.values() if source == module and name), key=kind_and_name)
        yield f"from {module} import {', '.join(names)}"


def kind_and_name(name: str) -> tuple[int, str]:
    """Constants before classes before functions, each by name."""
    return (0 if name.isupper() else 1 if name[0].isupper() else 2), name

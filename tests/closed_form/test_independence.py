"""The oracle shares nothing with what it checks."""

import ast
from pathlib import Path

import pytest

import eom.closed_form

FILES = sorted(Path(eom.closed_form.__path__[0]).glob("*.py"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_closed_form_imports_nothing_of_eom_but_its_exception(file: Path) -> None:
    imported = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            imported.add(node.module or "")
        elif isinstance(node, ast.Import):
            imported |= {name.name for name in node.names}
    own = {name for name in imported if name.split(".")[0] == "eom"}
    assert all(name == "eom.errors" or name.startswith("eom.closed_form") for name in own)
    assert not imported & {"scipy", "sympy", "matplotlib"}

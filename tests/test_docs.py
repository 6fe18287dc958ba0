"""What the documentation shows is what the program does: its commands and snippets run, their outputs are theirs."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAGES = (
    "simulation",
    "index",
    "tutorial",
    "commands",
    "module",
    "python",
    "kinematics",
    "symbols",
    "b-train",
    "responses",
    "closed-form",
    "nonlinear",
    "modes",
    "tir-files",
    "tyres",
)
BLOCK = re.compile(r"```(sh|python|yaml|text)\n(.*?)```", flags=re.DOTALL)
ENVIRONMENT = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}", "COLUMNS": "200"}


def output(command: list[str], folder: Path) -> str:
    """What a command prints."""
    done = subprocess.run(command, cwd=folder, env=ENVIRONMENT, check=True, capture_output=True, text=True)
    return done.stdout


def commands(block: str) -> list[list[str]]:
    """The commands of a shell block, without their comments."""
    return [words for line in block.splitlines() if (words := shlex.split(line, comments=True))]


@pytest.mark.parametrize("page", PAGES)
def test_a_page_shows_what_its_commands_and_snippets_print(page: str, tmp_path: Path) -> None:
    (tmp_path / "vehicles").symlink_to(ROOT / "vehicles")
    for command in (["check", "b_train_yaw_roll"], ["build", "b_train_yaw_roll"]):
        output(["eom", command[0], f"vehicles/{command[1]}.yaml"], tmp_path)
    blocks = BLOCK.findall((ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8"))
    printed, code = "", ""
    for k, (kind, block) in enumerate(blocks):
        if kind == "yaml" and block.startswith("name:"):
            # the next command names the file that the page has the reader write
            following = next(text for later, text in blocks[k:] if later == "sh")
            (tmp_path / commands(following)[0][2]).write_text(block, encoding="utf-8")
        elif kind == "sh":
            printed = "".join(output(command, tmp_path) for command in commands(block))
        elif kind == "python":
            before = output([sys.executable, "-c", code], tmp_path)
            code += block
            printed = output([sys.executable, "-c", code], tmp_path).removeprefix(before)
        elif kind == "text" and k and blocks[k - 1][0] in {"sh", "python"}:
            shown = [line.rstrip() for line in block.splitlines()]
            assert set(shown) <= {line.rstrip() for line in printed.splitlines()}, (page, block)

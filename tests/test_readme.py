"""The README's commands and snippets do what they say."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
BLOCKS = re.findall(r"```(sh|python)\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), flags=re.DOTALL)
COMMANDS = [line for kind, block in BLOCKS if kind == "sh" for line in block.splitlines() if line.strip()]
SNIPPETS = [block for kind, block in BLOCKS if kind == "python"]


@pytest.fixture(scope="module")
def workplace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the vehicles in which the README's commands have been run."""
    folder = tmp_path_factory.mktemp("readme")
    (folder / "vehicles").symlink_to(ROOT / "vehicles")
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    for command in COMMANDS:
        subprocess.run(shlex.split(command), cwd=folder, env=environment, check=True, capture_output=True)
    return folder


def test_the_commands_run_and_write_their_files(workplace: Path) -> None:
    assert len(COMMANDS) >= 4
    written = {path.name for path in (workplace / "build").iterdir()}
    assert {f"b_train.{suffix}" for suffix in ("py", "npz", "mat", "txt")} <= written
    assert {"b_train_yaw_roll_U.csv", "b_train_yaw_roll_U.png", "b_train_yaw_roll_U.svg"} <= written


@pytest.mark.parametrize("snippet", SNIPPETS)
def test_the_snippets_run(workplace: Path, snippet: str) -> None:
    done = subprocess.run([sys.executable, "-c", snippet], cwd=workplace, check=True, capture_output=True, text=True)
    assert done.stdout


def test_the_picture_is_there() -> None:
    for target in re.findall(r"\]\((docs/[^)]+)\)", (ROOT / "README.md").read_text(encoding="utf-8")):
        assert (ROOT / target).exists(), target

"""A copy of the project with invented things in it, each added as its recipe in CONTRIBUTING.md says."""

from __future__ import annotations

import re
import shutil
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from support.cli import run_program

ROOT = Path(__file__).parents[2]
FOLDERS = ("ev3proto", "dissector", "exports", "docs", "benchmarks")


class Change(NamedTuple):
    """A text in a file that becomes a longer one; a new file, if there is no text.

    path    of the file, from the project's folder
    before  what is there, once
    after   what is written instead
    """

    path: str
    before: str
    after: str

    def make(self, root: Path) -> None:
        """Makes the change in a copy of the project."""
        file = root / self.path
        if not self.before:
            file.parent.mkdir(exist_ok=True)
            file.write_text(self.after, encoding="utf-8")
            return
        text = file.read_text(encoding="utf-8")
        assert text.count(self.before) == 1, f"{self.path} has {text.count(self.before)} times: {self.before}"
        file.write_text(text.replace(self.before, self.after), encoding="utf-8")


def copied(root: Path, changes: Iterable[Change]) -> str:
    """Copies the project, makes the changes and generates everything again. Returns what was generated."""
    for name in FOLDERS:
        shutil.copytree(ROOT / name, root / name)
    shutil.copy2(ROOT / "CHANGELOG.md", root)
    for change in changes:
        change.make(root)
    return run_in(root, "-m", "ev3proto.generate")


def run_in(root: Path, *arguments: object, status: int = 0) -> str:
    """Returns the output of Python that imports from a copy first, or what it says of a failure."""
    done = run_program(sys.executable, *arguments, cwd=root, env={"PYTHONPATH": str(root)})
    assert done.returncode == status, done.stderr
    return done.stderr if status else done.stdout


def _recipes() -> str:
    return (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("\n## Recipes\n")[1].split("\n## ")[0]


def titles() -> list[str]:
    """Returns the titles of all recipes."""
    return re.findall(r"^### (.*)", _recipes(), re.MULTILINE)


def files_of(recipe: str) -> list[str]:
    """Returns the files that a recipe lists; words in capitals are any name."""
    section = _recipes().split(f"### {recipe}\n")[1].split("\n### ")[0]
    return re.findall(r"^\d\. `(.*?)`", section, re.MULTILINE)


def is_in(path: str, listed: str) -> bool:
    """Returns whether a path is one that a recipe lists."""
    return re.fullmatch(re.sub(r"\b[A-Z]{3,}\b(?!\.md)", r"\\w+", listed), path) is not None

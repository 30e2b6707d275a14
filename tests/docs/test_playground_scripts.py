"""The JavaScript of the playground: linted, its types checked, and what needs no browser tested in node."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from support.built import built_export
from support.scripts import PLAYGROUND, node_modules

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the scripts beside the packages that check them."""
    folder = tmp_path_factory.mktemp("scripts") / "playground"
    shutil.copytree(PLAYGROUND, folder, ignore=shutil.ignore_patterns("bridge", "__pycache__", "node_modules"))
    for name in ("ev3-decode", "ev3-texts"):
        for suffix in (".mjs", ".d.ts", ".d.mts"):
            shutil.copy(built_export(name + suffix), folder)
    (folder / "node_modules").symlink_to(node_modules())
    # Linted, too; what the playground takes from it has its types in types/brick.d.ts.
    shutil.copytree(ROOT / "ev3proto" / "brick" / "servers" / "page" / "static", folder / "brick")
    return folder


def _finds_nothing(folder: Path, *command: str) -> None:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_the_linter_finds_nothing(folder: Path) -> None:
    _finds_nothing(folder, "node_modules/.bin/eslint", "--max-warnings=0", ".")


@pytest.mark.parametrize("project", ["tsconfig.json", "tsconfig.workers.json"])
def test_types_fit(folder: Path, project: str) -> None:
    _finds_nothing(folder, "node_modules/.bin/tsc", "-p", project)


def test_what_needs_no_browser(folder: Path) -> None:
    tests = sorted(str(file) for file in Path(__file__).parent.glob("playground_*.test.mjs"))
    streams = Path(__file__).parents[1] / "support" / "deflate_raw.cjs"
    environment = {
        "PLAYGROUND": str(folder),
        "PATH": "/usr/bin:/bin:/usr/local/bin",
        "NODE_OPTIONS": f"--require={streams}",
    }
    done = subprocess.run(["node", "--test", *tests], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert "# fail 0" in done.stdout
    assert "# pass 0" not in done.stdout

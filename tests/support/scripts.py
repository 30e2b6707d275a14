"""The tools with which JavaScript is checked, from npm: what docs/playground/package-lock.json names."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[2]
PLAYGROUND = ROOT / "docs" / "playground"
FOLDER = ROOT / "build" / "npm_checks"  # build/npm is the build of the page's: it has fewer packages
DESCRIPTIONS = ("package.json", "package-lock.json")


def node_modules() -> Path:
    """Returns the folder of the packages, which bin/setup installs."""
    installed = FOLDER / "installed"
    there = installed.read_bytes() if installed.exists() else b""
    assert there == b"".join((PLAYGROUND / name).read_bytes() for name in DESCRIPTIONS), "run bin/setup test"
    return FOLDER / "node_modules"

"""The tools with which JavaScript is checked, from npm: what docs/playground/package-lock.json names."""

from __future__ import annotations

import fcntl
import shutil
import subprocess
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PLAYGROUND = ROOT / "docs" / "playground"
FOLDER = ROOT / "build" / "npm_checks"  # build/npm is the build of the page's: it has fewer packages
DESCRIPTIONS = ("package.json", "package-lock.json")


@cache
def node_modules() -> Path:
    """Returns the folder of the packages, which are installed if they are not there, or are others."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    with (FOLDER / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        wanted = [(PLAYGROUND / name).read_bytes() for name in DESCRIPTIONS]
        there = FOLDER / "installed"
        if not there.exists() or there.read_bytes() != b"".join(wanted):
            for name in DESCRIPTIONS:
                shutil.copy(PLAYGROUND / name, FOLDER / name)
            command = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"]
            subprocess.run(command, cwd=FOLDER, check=True, capture_output=True)
            there.write_bytes(b"".join(wanted))
    return FOLDER / "node_modules"

"""The documentation with the playground, built once for all tests of it, and again only if a file of it has changed."""

from __future__ import annotations

import fcntl
import hashlib
import shutil
import subprocess
import sys
from collections.abc import Iterator
from importlib.metadata import distributions
from pathlib import Path

ROOT = Path(__file__).parents[2]

_BUILT = ROOT / "build" / "tests" / "sites"
_INPUTS = ("docs", "ev3proto", "captures", "bin/addresses", *("*.md", "fuzz/*.md", "LICENSE"))
_NOT_READ = {"__pycache__", "node_modules"}


def built_site() -> Path:
    """Returns the folder of the documentation, built by the command in CONTRIBUTING.md."""
    folder = _BUILT / _digest()
    _BUILT.mkdir(parents=True, exist_ok=True)
    with (_BUILT / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            # Those of other states of the sources, and what an interrupted build left. npm's packages are beside them.
            for old in _BUILT.iterdir():
                if old.is_dir() and old.name != "npm":
                    shutil.rmtree(old)
            new = _BUILT / "new"
            command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", str(ROOT / "docs"), str(new)]
            done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
            assert (done.returncode, done.stderr) == (0, "")
            new.rename(folder)
    return folder


def _digest() -> str:
    """Returns a name for all that the site is made from: the files, Python, and what is installed.

    A distribution counts once, however often the paths of modules lead to it, which differ by who asks.
    """
    digest = hashlib.sha256(sys.version.encode())
    digest.update(repr(sorted({(each.name, each.version) for each in distributions()})).encode())
    for path in _inputs():
        digest.update(f"\n{path.relative_to(ROOT)}\n".encode() + path.read_bytes())
    return digest.hexdigest()[:16]


def _inputs() -> Iterator[Path]:
    for pattern in _INPUTS:
        for found in sorted(ROOT.glob(pattern)):
            for path in sorted(found.rglob("*")) if found.is_dir() else [found]:
                if path.is_file() and _NOT_READ.isdisjoint(path.parts):
                    yield path

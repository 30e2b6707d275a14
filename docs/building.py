"""Builds the documentation with the playground, unless it was built from the same files.

`python docs/building.py build/docs`: a change of a file's time does not count.
"""

from __future__ import annotations

import hashlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ("docs", "ev3proto", "exports", "dissector", "captures", "fuzz", "bin", "pyproject.toml")
"""All that pages include, link to or are built by, besides the Markdown files of the top folder."""
IGNORED = {"__pycache__", "node_modules"}


def build(folder: Path) -> None:
    """Builds the documentation in a folder, if it is missing or out of date.

    Args:
        folder: The output folder; npm installs packages beside it.

    Raises:
        subprocess.CalledProcessError: Sphinx failed, and said why.
    """
    stamp, digest = folder / ".sources", _digest()
    if stamp.exists() and stamp.read_text() == digest:
        return
    print("building the documentation; the first time that takes some two minutes", file=sys.stderr)
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", str(ROOT / "docs"), str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, stdout=sys.stderr)
    stamp.write_text(digest)


def _digest() -> str:
    """Returns a digest of the names and contents of all sources."""
    digest = hashlib.sha256()
    for path in sorted(_sources()):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(ROOT).as_posix()} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def _sources() -> Iterator[Path]:
    yield from ROOT.glob("*.md")
    for name in SOURCES:
        for path in (ROOT / name, *(ROOT / name).rglob("*")):
            if path.is_file() and not IGNORED & set(path.relative_to(ROOT).parts):
                yield path


if __name__ == "__main__":
    try:
        build(Path(sys.argv[1]))
    except subprocess.CalledProcessError as error:
        sys.exit(error.returncode)

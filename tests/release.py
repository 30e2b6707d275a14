"""Tries the files of bin/release: checksums, the wheel in a clean environment, the contents of the source distribution.

python tests/release.py dist

It needs Python and git, and runs on Linux, macOS and Windows.
"""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
import tarfile
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).parents[1]

LEFT_OUT = {".ci/run", ".gitignore"}
"""Files of the repository that the source distribution does not need."""

EXPORTED = {
    "ev3proto.h": "c-header",
    "ev3.ksy": "kaitai",
    "ev3.mjs": "javascript",
    "ev3-decode.mjs": "javascript --decoder",
    "ev3-texts.mjs": "javascript --texts",
}
"""The arguments of `ev3proto export` that print each file."""


def main(dist: Path) -> None:
    """Checks a folder; prints what is wrong and exits with status 1."""
    for line in (dist / "SHA256SUMS").read_text().splitlines():
        total, name = line.split(maxsplit=1)
        expect(hashlib.sha256((dist / name).read_bytes()).hexdigest() == total, f"the checksum of {name} is wrong")
        print(f"{name}: checksum ok")
    (wheel,) = dist.glob("*.whl")
    (source,) = dist.glob("*.tar.gz")
    with tarfile.open(source) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    lacking = {*run("git", "ls-files", cwd=ROOT).splitlines()} - names - LEFT_OUT
    expect(not lacking, f"{source.name} lacks {', '.join(sorted(lacking))}: MANIFEST.in names what it has")
    print(f"{source.name}: {len(names)} files, the tests among them")
    with tempfile.TemporaryDirectory() as folder:
        try_wheel(wheel.resolve(), dist.resolve(), Path(folder))


def try_wheel(wheel: Path, dist: Path, folder: Path) -> None:
    """Installs the wheel into a clean environment, and runs it there as in README.md."""
    venv.create(folder / "environment", with_pip=True)
    programs = folder / "environment" / ("Scripts" if os.name == "nt" else "bin")
    python = programs / "python"
    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", wheel, cwd=folder)
    ev3proto = programs / "ev3proto"
    version = run(ev3proto, "--version", cwd=folder)
    print(version.strip())
    expect(version.split()[-1] in wheel.name, f"{wheel.name} has another version: {version}")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    block = re.search(r"^\$ bin/ev3proto (decode \S+) \| head -n (\d+)\n(.*?)^```", readme, re.DOTALL | re.MULTILINE)
    assert block is not None
    words, count, shown = block.groups()
    printed = run(ev3proto, *words.split(), cwd=ROOT).splitlines(keepends=True)
    expect("".join(printed[: int(count)]) == shown, f"ev3proto {words} prints something else than README.md says")
    print(f"ev3proto {words}: as README.md shows it")
    program = re.search(r"^```python\n(.*?)^```", readme, re.DOTALL | re.MULTILINE)
    assert program is not None
    run(python, "-c", program[1], cwd=folder)
    print("the program in README.md: ok")
    run(ev3proto, "dissector", "install", "--dir", folder / "plugins", cwd=folder)
    made = {name: run(ev3proto, "export", *words.split(), cwd=folder) for name, words in EXPORTED.items()}
    made |= {file.name: file.read_text(encoding="utf-8") for file in (folder / "plugins").glob("*.lua")}
    expect(len(made) == len(EXPORTED) + 2, f"the wheel makes only {', '.join(made)}")
    for name, text in made.items():
        expect((dist / name).read_text(encoding="utf-8") == text, f"the wheel makes another {name}")
        print(f"{name}: as the wheel makes it")


def run(*words: str | Path, cwd: Path) -> str:
    """Returns the output of a command, or exits if it fails. The environment of this program does not influence it."""
    environment = {name: text for name, text in os.environ.items() if not name.startswith("PYTHONPATH")}
    done = subprocess.run(
        [str(word) for word in words], cwd=cwd, env=environment, capture_output=True, text=True, encoding="utf-8"
    )
    expect(done.returncode == 0, f"{' '.join(map(str, words))} fails: {done.stderr}")
    return done.stdout


def expect(is_so: bool, sentence: str) -> None:
    """Exits with a message unless something is true."""
    if not is_so:
        sys.exit(f"tests/release.py: {sentence}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "dist"))

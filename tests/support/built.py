"""Generated files as the sources build them now: what is checked in may be older, and `test_generated` compares it."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

from ev3proto.generate.dissector import build as dissector
from ev3proto.generate.exported import EXPORTED

_FOLDER = Path(__file__).parents[2] / "build" / "tests"


@cache
def built_dissector() -> Path:
    """Returns the path of ev3.lua, with ev3_statistics.lua beside it."""
    paths = [_written(name, text) for name, text in dissector.files().items()]
    return paths[0]


@cache
def built_export(name: str) -> Path:
    """Returns the path of an exported file, by its name in `exports`."""
    return _written(name, EXPORTED[name]())


def _written(name: str, text: str) -> Path:
    """Writes a file at once: other processes may run the same tests."""
    _FOLDER.mkdir(parents=True, exist_ok=True)
    path, new = _FOLDER / name, _FOLDER / f"{name}.{os.getpid()}"
    new.write_bytes(text.encode())
    new.replace(path)
    return path

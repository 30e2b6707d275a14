"""Everything that is generated and checked in: the files, their contents, and writing them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from ev3proto.generate import modules
from ev3proto.generate.dissector import build as dissector
from ev3proto.generate.exported import EXPORTED
from ev3proto.generate.modules.source import MARK
from ev3proto.generate.pages import build as pages
from ev3proto.generate.pages.markdown import PAGE_MARK

COMMAND = "python -m ev3proto.generate"
"""The command that regenerates everything."""


def build(more: Mapping[str, str]) -> dict[str, str]:
    """Generates all files; the same text every time."""
    return {
        **modules.build(),
        **{f"dissector/{name}": text for name, text in dissector.files().items()},
        **{f"exports/{name}": make() for name, make in EXPORTED.items()},
        **pages.build(),
        **more,
    }


def outdated(root: Path, more: Mapping[str, str]) -> Iterator[str]:
    """Lists the paths of files that differ from what the tables say: to be written, or to be deleted."""
    files = build(more)
    yield from _changed(root, files)
    yield from _left_over(root, files)


def _changed(root: Path, files: dict[str, str]) -> Iterator[str]:
    for path, text in files.items():
        file = root / path
        if not file.is_file() or file.read_bytes() != text.encode():
            yield path


def write_modules(root: Path) -> list[str]:
    """Regenerates the package's own modules, before they are imported. Returns the path of each that changed."""
    return list(_write(root, modules.build()))


def write(root: Path, more: Mapping[str, str]) -> Iterator[str]:
    """Regenerates all files; yields the path of each that changed."""
    files = build(more)
    yield from _write(root, files)
    for path in list(_left_over(root, files)):
        (root / path).unlink()
        yield path


def _write(root: Path, files: dict[str, str]) -> Iterator[str]:
    for path in list(_changed(root, files)):
        file = root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(files[path].encode())
        yield path


def _left_over(root: Path, files: dict[str, str]) -> Iterator[str]:
    """Returns generated modules and pages that no table backs any more."""
    kinds = [*((folder, "*.py", MARK) for folder in modules.FOLDERS), (pages.FOLDER, "*.md", PAGE_MARK)]
    for folder, pattern, mark in kinds:
        for file in sorted((root / folder).rglob(pattern)):
            path = file.relative_to(root).as_posix()
            if path not in files and mark in file.read_text(encoding="utf-8"):
                yield path

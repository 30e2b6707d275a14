"""Each word has one meaning: no two classes of a package have the same name, and no class is imported under another."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "ev3proto"

BY_NAME = {"Reader", "Writer"}
"""Each module of a folder has its own, by which it is found: see "A carrier" in CONTRIBUTING.md."""


def _parsed() -> Iterator[tuple[Path, ast.Module]]:
    for path in sorted(PACKAGE.rglob("*.py")):
        yield path.relative_to(PACKAGE), ast.parse(path.read_text(encoding="utf-8"))


def test_a_class_name_is_used_once_in_a_package() -> None:
    found = defaultdict(list)
    for path, tree in _parsed():
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_") and node.name not in BY_NAME:
                found[path.parts[0], node.name].append(path.as_posix())
    twice = {name: paths for (_, name), paths in found.items() if len(paths) > 1}
    assert not twice


def test_no_class_is_imported_under_another_name() -> None:
    aliases = [
        f"{path.as_posix()}: {each.name} as {each.asname}"
        for path, tree in _parsed()
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("ev3proto")
        for each in node.names
        if each.asname not in (None, each.name, *BY_NAME) and not each.name.isupper() and each.name[0].isupper()
    ]
    assert not aliases

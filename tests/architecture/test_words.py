"""Each word has one meaning: a class, function or constant shares its name with no other one of its package.

Functions and constants count if other files import them. No class is imported under another name.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "ev3proto"

BY_NAME = {"Reader", "Writer", "FILE_NAME", "build"}
"""Each module of a folder has its own, by which it is found: see "A carrier" and "An export" in CONTRIBUTING.md."""


@cache
def _parsed() -> list[tuple[Path, ast.Module]]:
    paths = sorted(PACKAGE.rglob("*.py"))
    return [(path.relative_to(PACKAGE), ast.parse(path.read_text(encoding="utf-8"))) for path in paths]


def test_a_class_name_is_used_once_in_a_package() -> None:
    found = defaultdict(list)
    for path, tree in _parsed():
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_") and node.name not in BY_NAME:
                found[path.parts[0], node.name].append(path.as_posix())
    twice = {name: paths for (_, name), paths in found.items() if len(paths) > 1}
    assert not twice


def _defined(tree: ast.Module) -> Iterator[str]:
    """The functions and constants of a module."""
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (target.id for target in targets if isinstance(target, ast.Name))


def test_a_name_that_is_imported_is_used_once_in_a_package() -> None:
    imported = {
        f"{node.module}.{each.name}"
        for _, tree in _parsed()
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for each in node.names
    }
    found = defaultdict(set)
    for path, tree in _parsed():
        module = ".".join(("ev3proto", *path.with_suffix("").parts)).removesuffix(".__init__")
        for name in _defined(tree):
            if f"{module}.{name}" in imported and name not in BY_NAME:
                found[path.parts[0], name].add(path.as_posix())
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

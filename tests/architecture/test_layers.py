"""The layers of the architecture, as in CONTRIBUTING.md: files import from lower layers only, and never in a circle."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "ev3proto"

LAYERS = (
    {"tables", "errors", "version", "temporary", "whole_files", "bounded", "extras"},
    {"messages"},
    {"schema", "enums"},
    {"stream", "system"},
    {"semantics"},
    {"compose", "dialogue", "ops"},
    {"checking"},
    {"text", "scapy"},
    {"program"},
    {"testing", "sampling"},
    {"capture"},
    {"generate"},
    {"pyshark"},
    {"brick"},
    {"link"},
    {"cli"},
    {"__main__"},
)
"""Lowest first. Packages of one layer do not import each other."""


def _module(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


FILES = {_module(path): path for path in sorted(PACKAGE.rglob("*.py"))}


def _imports(path: Path) -> Iterator[str]:
    """The modules of the project that a file imports: at its top, in functions and for type checkers."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            assert node.level == 0, f"{path}: relative imports are not followed here"
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            continue
        for name in names:
            # An import names a module, or a name in one.
            found = name if name in FILES else name.rpartition(".")[0]
            if found in FILES:
                yield found


IMPORTS = {module: set(_imports(path)) - {module} for module, path in FILES.items()}


def _package(module: str) -> str:
    return module.split(".")[1] if "." in module else ""


def test_every_package_has_a_layer() -> None:
    placed = [package for layer in LAYERS for package in layer]
    assert len(placed) == len(set(placed))
    # ev3proto itself exports names of all layers.
    assert {_package(module) for module in FILES} == {"", *placed}


def test_the_layers_are_those_of_contributing() -> None:
    table = re.findall(r"^\| (\d+) \| (`.*?) \|", (ROOT / "CONTRIBUTING.md").read_text(), re.MULTILINE)
    listed = {int(number): set(re.findall(r"`(\w+)`", packages)) for number, packages in table}
    assert listed == dict(enumerate(LAYERS))


def test_files_import_from_lower_layers_only() -> None:
    height = {package: number for number, layer in enumerate(LAYERS) for package in layer}
    upward = [
        f"{module} imports {other}"
        for module, others in IMPORTS.items()
        for other in others
        if _package(module) not in ("", _package(other))
        and height.get(_package(other), len(LAYERS)) >= height[_package(module)]
    ]
    assert upward == []


def test_no_files_import_each_other_in_a_circle() -> None:
    try:
        TopologicalSorter(IMPORTS).prepare()
    except CycleError as error:
        raise AssertionError(" -> ".join(reversed(error.args[1]))) from None

"""The layers of the architecture: files import from lower layers only, and never in a circle."""

from __future__ import annotations

import ast
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
    {"reading"},
    {"cli"},
    {"__main__"},
)
"""Lowest first. Packages of one layer do not import each other. CONTRIBUTING.md has a picture of what they import."""


def _module(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def _package(module: str) -> str:
    """The package of a module; a `__main__` is a program, above all packages, and no file imports it."""
    parts = module.split(".")
    return parts[-1] if parts[-1] == "__main__" else parts[1] if "." in module else ""


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


def _named(path: Path) -> Iterator[str]:
    """The modules of the project whose full names are in a file as texts, for `import_module` and the like."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Constant) and node.value in FILES:
            yield node.value


def _changed(path: Path) -> Iterator[str]:
    """The objects of other packages that a file changes when it is loaded, such as a registry of functions."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    imported = {
        alias.asname or alias.name: f"{node.module}.{alias.name}"
        for node in tree.body
        if isinstance(node, ast.ImportFrom) and node.module is not None
        for alias in node.names
        if node.module.startswith("ev3proto.") and _package(node.module) != _package(_module(path))
    }
    for node in tree.body:
        changed: list[ast.expr] = []
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            changed = node.decorator_list
        elif isinstance(node, ast.Assign):
            parts = [part for target in node.targets for part in getattr(target, "elts", [target])]
            changed = [part for part in parts if not isinstance(part, ast.Name)]
        for root in changed:
            while not isinstance(root, ast.Name):
                root = root.func if isinstance(root, ast.Call) else root.value  # type: ignore[attr-defined]
            if root.id in imported:
                yield imported[root.id]


IMPORTS = {module: set(_imports(path)) - {module} for module, path in FILES.items()}
NAMED = {module: set(_named(path)) - {module, "ev3proto"} for module, path in FILES.items()}

UPWARD = {
    # Message.build: a message is what the readers of schema return, and they also build it.
    ("ev3proto.messages", "ev3proto.schema.frame"),
    # Report.fixed and Report.nearest: a fix and a suggestion are checked again, which makes another report.
    ("ev3proto.checking.report", "ev3proto.checking.fixing"),
    ("ev3proto.checking.report", "ev3proto.checking.nearest"),
    # str(report) and str(fix): text renders reports, and checking prints nothing.
    ("ev3proto.checking.report", "ev3proto.text.diagnostics"),
}
"""The only calls of higher layers, and against the order of files, each with its reason: made when they are used."""

FACES = {
    **dict.fromkeys(("tables", "errors", "messages", "enums", "stream", "system", "compose", "dialogue", "ops"), ()),
    "schema": (
        *(
            "frame",
            "frame_buffer",
            "header",
            "instructions",
            "argument",
            "fields",
            "constructors",
            "discovery",
            "names",
            "reasons",
        ),
        "wire_format",
    ),
    "semantics": (
        *(
            "advice",
            "domain",
            "facts",
            "flow",
            "footprint",
            "identify",
            "judgement",
            "likelihood",
            "mangled",
            "pairing",
            "readings",
            "replies",
            "transfers",
        ),
        *("drafts.functions", "drafts.placeholders"),
    ),
    "checking": ("checking", "codes", "fixing", "nearest", "program_codes", "report", "verdict"),
    "generate.dissector": ("build", "fields", "install"),
}
"""The core, on which the other packages build: who understands it understands the project. They import each package
itself, all of the tables, the enumerations and the generated functions; of the others only these modules."""


def test_every_package_has_a_layer() -> None:
    placed = [package for layer in LAYERS for package in layer]
    assert len(placed) == len(set(placed))
    # ev3proto itself exports names of all layers.
    assert {_package(module) for module in FILES} == {"", *placed}


def test_other_packages_import_only_the_face_of_the_core() -> None:
    single = {f"ev3proto.{package}" for package in FACES}

    def is_core(module: str) -> bool:
        return any(module == each or module.startswith(f"{each}.") for each in single)

    imported = {
        other for module, others in IMPORTS.items() if module != "ev3proto" and not is_core(module) for other in others
    }
    # All of the tables, the enumerations and the functions are public.
    public = tuple(f"ev3proto.{package}." for package in ("tables", "enums", "system", "ops"))
    used = {each for each in imported if is_core(each) and each not in single and not each.startswith(public)}
    assert used == {f"ev3proto.{package}.{name}" for package, names in FACES.items() for name in names}


def test_files_import_from_lower_layers_only() -> None:
    height = {package: number for number, layer in enumerate(LAYERS) for package in layer}
    upward = {
        (module, other)
        for uses in (IMPORTS, NAMED)
        for module, others in uses.items()
        for other in others
        if _package(module) not in ("", _package(other))
        and height.get(_package(other), len(LAYERS)) >= height[_package(module)]
    }
    assert upward == {pair for pair in UPWARD if _package(pair[0]) != _package(pair[1])}


def test_no_file_changes_objects_of_other_packages() -> None:
    """A function that registers itself in a lower layer would be an upward call that no import shows."""
    assert [(module, name) for module, path in FILES.items() for name in _changed(path)] == []


def test_upward_calls_are_made_when_they_are_used() -> None:
    for module, other in UPWARD:
        tree = ast.parse(FILES[module].read_text(encoding="utf-8"))
        at_the_top = [node.module for node in tree.body if isinstance(node, ast.ImportFrom)]
        assert other not in at_the_top, module


def test_no_files_import_each_other_in_a_circle() -> None:
    downward = {
        module: {other for other in others if (module, other) not in UPWARD} for module, others in IMPORTS.items()
    }
    try:
        TopologicalSorter(downward).prepare()
    except CycleError as error:
        raise AssertionError(" -> ".join(reversed(error.args[1]))) from None

"""Packs what Python imports in the browser: ev3proto, its dependencies, and their part of Pyodide's standard library.

The imports are followed in the text of each module, so that the result has no more than what can be imported.
"""

from __future__ import annotations

import importlib.metadata
import re
import zipfile
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path, PurePosixPath

HERE = Path(__file__).parent
PACKAGES = ("construct", "dpkt")

WHOLE = ("bridge", "ev3proto.capture", "ev3proto.generate.captures", "pyodide", "_pyodide")
"""Packages whose modules are all packed: they are imported by names that are computed, or from C and JavaScript."""

ROOTS = (
    "site",
    *(
        f"encodings.{name}"
        for name in ("ascii", "cp437", "latin_1", "utf_16", "utf_16_be", "utf_16_le", "utf_8", "utf_8_sig")
    ),
)
"""Other modules that Python starts with, or that are imported by a computed name."""

NEVER = ("_pyrepl", "doctest", "multiprocessing", "pydoc", "unittest")
"""Modules that others import for what the page never does."""

REPLACED = {"dpkt/__init__.py": "from .dpkt import *\n"}
"""dpkt imports every protocol that it knows; those that are needed are imported by name."""

_IMPORT = re.compile(
    r"^[ \t]*(?:from[ \t]+(?P<origin>\.*[\w.]*)[ \t]+import[ \t]+(?P<names>\([^)]*\)|[^\n#]+)"
    r"|import[ \t]+(?P<modules>[^\n#]+))",
    re.MULTILINE,
)
_NAME = re.compile(r"[\w.]+")
_TIME = (1980, 1, 1, 0, 0, 0)


def pack(path: Path, stdlib: Path) -> None:
    """Writes the archive.

    Args:
        path: The archive.
        stdlib: Pyodide's archive of the standard library.
    """
    with zipfile.ZipFile(stdlib) as library:
        sources = {name: library.read(name).decode() for name in library.namelist() if name.endswith(".py")}
    sources |= {name: file.read_text(encoding="utf-8") for name, file in _own()} | REPLACED
    with zipfile.ZipFile(path, "w") as packed:
        for name in sorted(_needed(sources)):
            packed.writestr(zipfile.ZipInfo(name, _TIME), sources[name], zipfile.ZIP_DEFLATED, 9)


def _own() -> Iterator[tuple[str, Path]]:
    """Yields the modules that are not Pyodide's, each with its name in the archive."""
    own = Path(str(files("ev3proto")))
    for file in own.rglob("*.py"):
        yield f"ev3proto/{file.relative_to(own).as_posix()}", file
    for file in (HERE / "bridge").rglob("*.py"):
        yield file.relative_to(HERE).as_posix(), file
    for package in PACKAGES:
        for entry in importlib.metadata.files(package) or ():
            if entry.parts[0] != ".." and entry.suffix == ".py":
                yield entry.as_posix(), Path(str(entry.locate()))


def _needed(sources: dict[str, str]) -> set[str]:
    """Returns the files of the modules that can be imported."""
    names = {_module(name): name for name in sources}
    waiting = [*ROOTS, *(module for module in names if f"{module}.".startswith(tuple(f"{it}." for it in WHOLE)))]
    found: set[str] = set()
    while waiting:
        module = waiting.pop()
        file = names.get(module)
        if file is None or file in found or module.partition(".")[0] in NEVER:
            continue
        found.add(file)
        waiting += _imported(sources[file], module if file.endswith("/__init__.py") else module.rpartition(".")[0])
        waiting.append(module.rpartition(".")[0])
    return found


def _module(file: str) -> str:
    """Returns the name of the module in a file."""
    return ".".join(PurePosixPath(file).with_suffix("").parts).removesuffix(".__init__")


def _imported(source: str, package: str) -> Iterator[str]:
    """Yields the names that a module of a package may import, whether they are modules or not."""
    for found in _IMPORT.finditer(source):
        if found["modules"]:
            yield from (part.split()[0] for part in found["modules"].split(",") if part.strip())
            continue
        origin = found["origin"]
        dots = len(origin) - len(origin.lstrip("."))
        if dots:
            above = package.split(".")[: len(package.split(".")) - dots + 1]
            origin = ".".join([*above, *filter(None, [origin.lstrip(".")])])
        yield origin
        yield from (f"{origin}.{name}" for name in _NAME.findall(found["names"]))

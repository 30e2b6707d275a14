"""The page of the Python API: all public names, with signatures and docstrings."""

from __future__ import annotations

import dataclasses
import enum
import inspect
import re
from collections.abc import Container, Iterable, Iterator, Mapping
from functools import cached_property
from importlib import import_module
from types import ModuleType
from typing import Any

from ev3proto.generate.pages.markdown import block, link, listed, plain, table

_PLAIN = (bool, int, float, str, bytes, tuple, type(None))
_WIDTH = 100
_SECTIONS = ("Args", "Returns", "Raises", "Yields", "Attributes")


def blocks(names: Iterable[str]) -> Iterator[str]:
    """Yields the blocks of the page, for the names of the public modules; each lists its names in `__all__`."""
    yield (
        "The public names of the package. The functions of `ev3proto.ops` are listed with their operations in the"
        " reference of the instruction set, those of `ev3proto.enums` with the [enumerations](enumerations.md)."
    )
    modules = [import_module(name) for name in names]
    offered = {id(found) for module in modules for found in vars(module).values()}
    yield listed(f"{link(module.__name__, module.__name__)}: {plain(_first_line(module))}" for module in modules)
    for module in modules:
        yield from _module(module, offered)


def _first_line(value: object) -> str:
    return (inspect.getdoc(value) or "").partition("\n")[0]


def _module(module: ModuleType, offered: Container[int]) -> Iterator[str]:
    yield f"## {module.__name__}"
    public = [(name, getattr(module, name)) for name in module.__all__]
    shown = [(name, value) for name, value in public if inspect.isclass(value) or inspect.isroutine(value)]
    rows = ((link(name, f"{module.__name__}.{name}"), plain(_first_line(value))) for name, value in shown)
    yield table(("name", "what it is"), rows)
    for name, value in shown:
        yield f"### {module.__name__}.{name}"
        if inspect.isclass(value):
            yield from _class(name, value, offered)
        else:
            yield block("python", _signature(f"def {name}", value))
            yield from _docstring(value)


def _class(name: str, value: type, offered: Container[int]) -> Iterator[str]:
    if issubclass(value, enum.Enum):
        yield from _docstring(value)
        yield ", ".join(f"`{member}`" for member in value.__members__)
        return
    bases = [base.__name__ for base in value.__bases__ if base.__module__.startswith("ev3proto")]
    if dataclasses.is_dataclass(value) or "__init__" not in vars(value):
        yield block("python", [f"class {name}" + (f"({', '.join(bases)})" if bases else "")])
    else:
        yield block("python", _signature(f"class {name}", value.__init__))
    yield from _docstring(value)
    if "__init__" in vars(value) and not dataclasses.is_dataclass(value):
        yield from _docstring(value.__init__)
    for member, found in _members(value, offered).items():
        if member.startswith("_"):
            continue
        if isinstance(found, property | cached_property):
            yield f"`.{member}`: {plain(_first_line(found))}"
        elif inspect.isfunction(found) or isinstance(found, classmethod | staticmethod):
            function = getattr(found, "__func__", found)
            yield block("python", _signature(f".{member}", function))
            yield from _docstring(function)


def _members(value: type, offered: Container[int]) -> dict[str, Any]:
    """Returns what a class defines, then what it inherits from bases that no module exports."""
    ours = [each for each in value.__mro__ if each.__module__.startswith("ev3proto.")]
    told = [each for each in ours if each is value or id(each) not in offered]
    names = dict.fromkeys(name for each in told for name in vars(each))
    return {name: next(vars(each)[name] for each in told if name in vars(each)) for name in names}


def _signature(head: str, function: Any) -> Iterator[str]:
    """Returns `def name(first: type = default) -> type`, on one line or with a parameter a line."""
    signature = inspect.signature(function)
    constants = vars(import_module(function.__module__))
    own = [each for each in signature.parameters.values() if each.name not in ("self", "cls")]
    parameters = [_parameter(each, constants) for each in own]
    kinds = [each.kind for each in own]
    if inspect.Parameter.KEYWORD_ONLY in kinds and inspect.Parameter.VAR_POSITIONAL not in kinds:
        parameters.insert(kinds.index(inspect.Parameter.KEYWORD_ONLY), "*")
    end = "" if signature.return_annotation is inspect.Signature.empty else f" -> {_type(signature.return_annotation)}"
    line = f"{head}({', '.join(parameters)}){end}"
    if len(line) <= _WIDTH:
        yield line
    else:
        yield f"{head}("
        yield from (f"    {each}," for each in parameters)
        yield f"){end}"


_STARS: dict[Any, str] = {inspect.Parameter.VAR_POSITIONAL: "*", inspect.Parameter.VAR_KEYWORD: "**"}


def _parameter(parameter: inspect.Parameter, constants: Mapping[str, object]) -> str:
    """Returns a parameter as written in a signature; a default without a short text is named by a constant."""
    text = _STARS.get(parameter.kind, "") + parameter.name
    has_type = parameter.annotation is not inspect.Parameter.empty
    if has_type:
        text += f": {_type(parameter.annotation)}"
    if parameter.default is not inspect.Parameter.empty:
        text += " = " if has_type else "="
        text += _default(parameter.default, constants)
    return text


def _default(value: Any, constants: Mapping[str, object]) -> str:
    if hasattr(value, "__name__"):
        return str(value.__name__)
    names = [] if type(value) in _PLAIN else [name for name, other in constants.items() if other is value]
    return names[0] if names else repr(value)


def _type(annotation: Any) -> str:
    if isinstance(annotation, str):
        return annotation
    # Hypothesis's representation of an annotation contains references, and names of its own modules.
    return re.sub(r"ForwardRef\('(\w+)'\)|hypothesis\.strategies\.", r"\1", inspect.formatannotation(annotation))


def _docstring(value: object) -> Iterator[str]:
    """Returns a docstring as Markdown: its sections become lists, its tables and examples stay unchanged."""
    for paragraph in re.split(r"\n\n+", inspect.getdoc(value) or ""):
        lines = paragraph.splitlines()
        title = lines[0].removesuffix(":") if lines else ""
        if title in _SECTIONS:
            yield f"**{title}**"
            # An entry continues in lines that are indented further.
            yield listed(map(_item, re.sub(r"\n {8,}", " ", "\n".join(lines[1:])).splitlines()))
        elif any(line.startswith("    ") or re.match(r"\w+ {2,}\S", line) for line in lines):
            yield block("text", lines)
        elif lines:
            yield _prose(" ".join(lines))


def _item(line: str) -> str:
    entry = line.strip()
    name, colon, meaning = entry.partition(": ")
    if colon and re.fullmatch(r"[\w.*, ]+", name) and len(name.split()) <= 2:
        return f"`{name}`: {_prose(meaning)}"
    return _prose(entry)


def _prose(text: str) -> str:
    """Returns a text of a docstring, in which only what is between backquotes is markup."""
    pieces = re.split(r"(`[^`]*`)", text)
    return "".join(piece if piece.startswith("`") else plain(piece) for piece in pieces)

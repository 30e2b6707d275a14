"""All names that users can use, as text: a line for each function, class, attribute and option of the command line.

Functions, enumerations and constants that are generated from the tables are left out: their files are checked in, too.

`tests/public_face.txt` is this text after the last intended change. test_public_face.py compares the two, so that
a change of the public face shows as a diff in a review. To renew the file:

    .venv/bin/python tests/support/public_face.py

The text is the same with every supported release of Python, click and hypothesis: annotations are as in the
source, and additions of those packages are omitted.
"""

from __future__ import annotations

import enum
import inspect
import re
import sys
from collections.abc import Callable, Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import click
from scapy.packet import Packet

import ev3proto.cli.commands
from ev3proto.scapy.operations import operation_names
from ev3proto.scapy.system import SYSTEM_LAYERS

FILE = Path(__file__).parents[1] / "public_face.txt"
RENEW = ".venv/bin/python tests/support/public_face.py"

MODULES = (
    "ev3proto.capture",
    "ev3proto.checking",
    "ev3proto.compose",
    "ev3proto.dialogue",
    "ev3proto.messages",
    "ev3proto.stream",
    "ev3proto.schema",
    "ev3proto.schema.constructors",
    "ev3proto.schema.discovery",
    "ev3proto.schema.instructions",
    "ev3proto.schema.wire_format",
    "ev3proto.testing",
    "ev3proto.sampling",
)
"""Modules whose public names are all listed. What is generated from the tables is in its own files."""

MOST_CHARACTERS = 40
"""Maximum length of a default value; a longer one is `...`."""

_MODULE_PATH = re.compile(r"\b(?:[a-z_]\w*\.)+(?=[A-Z])")
_FORWARD = re.compile(r"ForwardRef\('([^']*)'\)")
_OBJECT = re.compile(r"<.*>", re.DOTALL)


def text() -> str:
    """Returns the whole public face."""
    sections = [
        *_Listing().sections(),
        ("ev3proto.scapy", _scapy()),
        ("The command line", _commands(ev3proto.cli.commands.cli, "ev3proto")),
    ]
    return "\n".join(line for title, lines in sections for line in (f"# {title}", "", *lines, ""))


# Modules and classes


class _Listing:
    """The public names of modules. A class or function is listed once, in the first module that has it."""

    def __init__(self) -> None:
        self._modules = {name: import_module(name) for name in ("ev3proto", *MODULES)}
        self._home: dict[int, str] = {}
        for path, module in self._modules.items():
            for name in _names(module):
                self._home.setdefault(id(getattr(module, name)), path)

    def sections(self) -> Iterator[tuple[str, Iterator[str]]]:
        yield from ((path, self._module(path, module)) for path, module in self._modules.items())

    def _module(self, path: str, module: ModuleType) -> Iterator[str]:
        known: dict[str, list[str]] = {}
        for name in _names(module):
            value = getattr(module, name)
            home = self._home[id(value)]
            if home != path and callable(value):
                known.setdefault(home, []).append(name)
            elif isinstance(value, type):
                yield from self._class(name, value)
            elif callable(value):
                yield f"{name}{_signature(value)}"
            elif name in getattr(module, "__all__", ()):
                yield f"{name}: {type(value).__name__}"
        yield from (f"as in {home}: {' '.join(names)}" for home, names in known.items())

    def _class(self, name: str, found: type) -> Iterator[str]:
        """A class with its additions to those of its bases that are also listed."""
        bases = ", ".join(base.__name__ for base in found.__bases__ if base is not object)
        head = f"class {name}({bases})" if bases else f"class {name}"
        if issubclass(found, enum.Enum):
            yield f"{head}: {_members(found)}"
            ours = [found]
        else:
            ours = [each for each in found.__mro__ if each.__module__.startswith("ev3proto")]
            is_made = not getattr(found, "_is_protocol", False) and any(
                each in vars(one) for one in ours for each in ("__init__", "__new__")
            )
            yield f"{head}: {name}{_signature(found)}" if is_made else head
        own = [each for each in ours if each is found or id(each) not in self._home]
        attributes = {attribute: value for each in reversed(own) for attribute, value in vars(each).items()}
        members = getattr(found, "__members__", {})
        public = sorted(each for each in attributes if not each.startswith("_") and each not in members)
        told = {each: _attribute(attributes[each]) for each in public}
        plain = [f".{each}" for each in public if not told[each]]
        if plain:
            yield f"  {' '.join(plain)}"
        yield from (f"  .{each}{told[each]}" for each in public if told[each])


def _names(module: ModuleType) -> list[str]:
    """The names in `__all__`, or else those defined in the module, without modules."""
    own = [name for name, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__]
    names = sorted(getattr(module, "__all__", own))
    return [name for name in names if not name.startswith("_") and not isinstance(getattr(module, name), ModuleType)]


def _attribute(value: Any) -> str:
    if isinstance(value, property | cached_property):
        read = value.fget if isinstance(value, property) else value.func
        return f": {_annotation(inspect.signature(read).return_annotation)}" if read else ""
    if isinstance(value, classmethod | staticmethod):
        return f"{_signature(value.__func__)} ({type(value).__name__})"
    return _signature(value) if inspect.isfunction(value) else ""


def _members(found: type[enum.Enum]) -> str:
    return " ".join(f"{name}={member.value!r}" for name, member in found.__members__.items())


def _signature(function: Callable[..., Any]) -> str:
    signature = inspect.signature(function)
    words: list[str] = []
    last: int = inspect.Parameter.POSITIONAL_ONLY
    for parameter in signature.parameters.values():
        if parameter.kind is inspect.Parameter.KEYWORD_ONLY and last < inspect.Parameter.VAR_POSITIONAL:
            words.append("*")
        words.append(_parameter(parameter))
        last = parameter.kind
    answer = _annotation(signature.return_annotation)
    return f"({', '.join(words)})" + (f" -> {answer}" if answer else "")


def _parameter(parameter: inspect.Parameter) -> str:
    stars = "*" * (parameter.kind is parameter.VAR_POSITIONAL) + "**" * (parameter.kind is parameter.VAR_KEYWORD)
    annotation = _annotation(parameter.annotation)
    told = f"{stars}{parameter.name}" + (f": {annotation}" if annotation else "")
    if parameter.default is inspect.Parameter.empty:
        return told
    return f"{told} = {_value(parameter.default)}" if annotation else f"{told}={_value(parameter.default)}"


def _annotation(annotation: Any) -> str:
    """An annotation as in the source, without the modules of its names."""
    if annotation is inspect.Signature.empty:
        return ""
    words = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    return _MODULE_PATH.sub("", _FORWARD.sub(r"\1", words).strip("'\""))


def _value(value: Any) -> str:
    if isinstance(value, enum.Enum):
        return f"{type(value).__name__}.{value.name}"
    if isinstance(value, set | frozenset):
        return "{" + ", ".join(sorted(map(_value, value))) + "}"
    words = repr(value)
    return "..." if _OBJECT.search(words) or len(words) > MOST_CHARACTERS else words


# Scapy


def _scapy() -> Iterator[str]:
    module = import_module("ev3proto.scapy")
    for name in sorted(set(module.__all__) - {*operation_names(), *SYSTEM_LAYERS}):
        value = getattr(module, name)
        if isinstance(value, type) and issubclass(value, Packet):
            yield f"{name}({', '.join(field.name for field in value.fields_desc)})"
        elif callable(value) and not isinstance(value, type):
            yield f"{name}{_signature(value)}"
        else:
            yield name


# The command line


def _commands(command: click.Command, path: str) -> Iterator[str]:
    yield path
    for parameter in sorted(command.params, key=lambda each: (isinstance(each, click.Option), each.opts[-1])):
        yield f"  {_cli_parameter(parameter)}"
    if isinstance(command, click.Group):
        context = click.Context(command)
        for name in sorted(command.list_commands(context)):
            found = command.get_command(context, name)
            assert found is not None
            yield from _commands(found, f"{path} {name}")


def _cli_parameter(parameter: click.Parameter) -> str:
    words = [
        "/".join(parameter.opts) + "".join(f" or {other}" for other in parameter.secondary_opts)
        if isinstance(parameter, click.Option)
        else str(parameter.name).upper()
    ]
    if isinstance(parameter, click.Option) and parameter.is_flag:
        words.append("(a flag)")
    elif isinstance(parameter.type, click.Choice):
        words.append("|".join(map(str, parameter.type.choices)))
    else:
        words.append(parameter.type.name)
    if parameter.multiple or parameter.nargs == -1:
        words.append("...")
    if parameter.required:
        words.append("required")
    if isinstance(parameter.default, int | float | str) and parameter.default is not False:
        words.append(f"default {parameter.default}")
    if isinstance(parameter, click.Option) and parameter.hidden:
        words.append("hidden")
    return " ".join(words)


if __name__ == "__main__":
    FILE.write_text(text())
    sys.stdout.write(f"{FILE} is written\n")

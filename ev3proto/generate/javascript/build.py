"""Assembles the JavaScript module and its types: numbers, the part written by hand, functions."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping
from importlib import resources

from ev3proto.generate.javascript.tables import Function, enumerations, families, integers, requests
from ev3proto.tables.encoding import HANDLE_BIT, IDENTIFICATIONS, NAN_FLOAT
from ev3proto.tables.frame import GLOBAL_BITS, LENGTH_FIELD, MAX_FRAME, MAX_GLOBALS, MAX_LOCALS
from ev3proto.version import VERSION

MODULE_NAME = "ev3.mjs"
TYPES_NAME = "ev3.d.ts"
TYPES_OF_MODULE_NAME = "ev3.d.mts"
"""The file in which TypeScript looks for the types of ev3.mjs."""

WIDTH = 120

_HEAD = """\
/**
 * The protocol of the LEGO MINDSTORMS EV3 for JavaScript: numbers by name, functions that make frames. Licence: MIT.
 *
 *     import { GV, directCommand, ops } from "./ev3.mjs";
 *
 *     directCommand([ops.SOUND.TONE(1, 440, 1000)], { counter: 42 });
 *     directCommand([ops.UI_READ.GET_VBATT(GV(0))], { counter: 43, globals: 4 });
 *
 * Names are the firmware's. A number gets its shortest encoding; what cannot be encoded is a RangeError.
 *
 * This file is made by ev3proto $VERSION from its tables (ev3proto export javascript): change those, not this.
 */
"""

_OPS = "A function for each operation, which returns its bytes."
_SYSTEM = "A function for each system command, which returns what follows the message type."


def build() -> str:
    """Returns the text of ev3.mjs."""
    lines = [
        _HEAD.replace("$VERSION", VERSION),
        *_facts(),
        "",
        *_numbers(declared=False),
        written_file("runtime.mjs"),
        *_kinds(),
        "",
    ]
    lines += [f"/** {_OPS} */", "export const ops = Object.freeze({"]
    for family, functions in families().items():
        body = _functions(functions, "    " if family else "  ")
        lines += [f"  {family}: Object.freeze({{", *body, "  }),"] if family else body
    lines += [
        "});",
        "",
        f"/** {_SYSTEM} */",
        "export const system = Object.freeze({",
        *_functions(requests(), "  "),
        "});",
    ]
    return "\n".join(lines) + "\n"


def build_types() -> str:
    """Returns the text of ev3.d.ts."""
    lines = [_HEAD.replace("$VERSION", VERSION), *_numbers(declared=True), written_file("runtime.d.ts")]
    lines += [f"/** {_OPS} */", "export declare const ops: {"]
    for family, functions in families().items():
        body = _signatures(functions, "    " if family else "  ")
        lines += [f"  readonly {family}: {{", *body, "  };"] if family else body
    lines += ["};", "", f"/** {_SYSTEM} */", "export declare const system: {", *_signatures(requests(), "  "), "};"]
    return "\n".join(lines) + "\n"


def build_types_of_module(name: str = MODULE_NAME) -> str:
    """Returns the text of the file in which TypeScript looks for the types of a module: ev3.d.mts."""
    return f'export * from "./{name.removesuffix(".mjs")}.js";\n'


def written_file(name: str) -> str:
    """Returns a part of a module that is written by hand, a file of this folder."""
    return (resources.files(__package__) / name).read_text(encoding="utf-8")


def _facts() -> Iterator[str]:
    heads = {
        row.encoding.name: row.first for row in IDENTIFICATIONS if not (row.encoding.handle or row.encoding.address)
    }
    yield f"const ENCODING = Object.freeze({{ {', '.join(f'{name}: 0x{head:02x}' for name, head in heads.items())} }});"
    facts = {
        "HANDLE_BIT": HANDLE_BIT,
        "NAN_FLOAT": list(NAN_FLOAT),
        "LENGTH_FIELD": LENGTH_FIELD,
        "MAX_FRAME": MAX_FRAME,
        "MAX_GLOBALS": MAX_GLOBALS,
        "MAX_LOCALS": MAX_LOCALS,
        "GLOBAL_BITS": GLOBAL_BITS,
    }
    yield from (f"const {name} = {value};" for name, value in facts.items())


def _kinds() -> Iterator[str]:
    yield from (f"const {name} = integer({low}, {high});" for name, (low, high) in integers().items())


def _numbers(*, declared: bool) -> Iterator[str]:
    for name, (text, members) in enumerations().items():
        yield f"/** {text} */"
        if declared:
            yield f"export declare const {name}: {{"
            yield from _wrapped((f"readonly {member}: {number};" for member, number in _keys(members)))
            yield "};"
        else:
            yield f"export const {name} = Object.freeze({{"
            yield from _wrapped((f"{member}: {number}," for member, number in _keys(members)))
            yield "});"
        yield ""


def _keys(members: Mapping[str, int]) -> Iterator[tuple[str, int]]:
    """Yields the members of an enumeration, with quotes around names that are not words."""
    return ((name if name.isidentifier() else f'"{name}"', number) for name, number in members.items())


def _wrapped(pieces: Iterable[str], width: int = WIDTH - 2) -> list[str]:
    """Returns pieces in lines, indented, that end between two pieces."""
    joined = " ".join(piece.replace(" ", "\0") for piece in pieces)
    lines = textwrap.wrap(joined, width, break_long_words=False, break_on_hyphens=False)
    return [f"  {line}".replace("\0", " ") for line in lines]


def _functions(functions: Iterable[Function], margin: str) -> list[str]:
    lines = []
    for each in functions:
        names = ", ".join(name for name, _, _ in each.parameters)
        lines.append(f"{margin}/** {each.text} */")
        head = f"{margin}{each.name}: ({names}) =>"
        line = f"{head} {each.builder}({', '.join(each.parts)}),"
        if len(line) <= WIDTH:
            lines.append(line)
        else:
            parts = _wrapped((f"{part}," for part in each.parts), width=WIDTH - len(margin) - 4)
            lines += [f"{head} {each.builder}(", *(margin + part for part in parts), f"{margin}),"]
    return lines


def _signatures(functions: Iterable[Function], margin: str) -> list[str]:
    lines = []
    for each in functions:
        lines.append(f"{margin}/**")
        lines.append(f"{margin} * {each.text}")
        lines += [f"{margin} * @param {name} {text}" for name, _, text in each.parameters]
        lines.append(f"{margin} */")
        given = ", ".join(f"{name}: {kind}" for name, kind, _ in each.parameters)
        lines.append(f"{margin}{each.name}({given}): Uint8Array;")
    return lines

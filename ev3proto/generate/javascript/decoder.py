"""The decoder in JavaScript: a part of ev3-tables.json, in the same shape, before what is written by hand; texts."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from ev3proto.generate.javascript.build import written_file
from ev3proto.generate.javascript.typescript import declarations_of_messages
from ev3proto.generate.tables_json.build import build_tables
from ev3proto.schema.reasons import REASONS
from ev3proto.tables.declaration import Role
from ev3proto.version import VERSION

DECODER_NAME, DECODER_TYPES_NAME = "ev3-decode.mjs", "ev3-decode.d.ts"
TEXTS_NAME, TEXTS_TYPES_NAME = "ev3-texts.mjs", "ev3-texts.d.ts"

Json = dict[str, Any]

_HEAD = """\
/**
 * $TITLE Licence: MIT.
 *
$EXAMPLE
 *
 * This file is made by ev3proto $VERSION from its tables (ev3proto export javascript $OPTION): change those, not this.
 */

"""
_DECODER = """\
 *     import { decode } from "./ev3-decode.mjs";
 *
 *     decode(reply, { request }).values; // [{ op: "UI_READ", command: "GET_VBATT", name: "VALUE", value: 7.5 }]"""
_TEXTS = """\
 *     import { texts } from "./ev3-texts.mjs";
 *
 *     texts.operations["SOUND.TONE"].text; // Plays one tone and returns at once"""

_ENTRY = ("number", "name", "dialects", "parameters", "commands")
_PARAMETER = (
    *("name", "type", "direction", "unit", "enum", "length", "length_from"),
    *("element", "element_from", "elements", "indexed_by", "role"),
)
_FIELD = ("name", "kind", "counts", "optional", "is_message")
_KEYS: dict[str, tuple[str, ...]] = {
    "message_types": ("number", "name", "kind", "is_error", "wants_reply"),
    "types": ("name", "size"),
    "encodings": ("name", "first", "last", "kind", "value", "width", "handle", "address"),
    "format_types": ("format", "type"),
    "system_commands": ("number", "name", "request", "reply", "bootloader", "is_long", "statuses"),
    "system_statuses": ("number", "name", "is_failure"),
    "daisy_commands": ("number", "name", "carries_operations"),
    "devices": ("number", "modes"),
    "modes": ("is_scaled", "values"),
    "commands": _ENTRY,
    "parameters": _PARAMETER,
    "request": _FIELD,
    "reply": _FIELD,
}
"""The keys that the decoder needs of the entries of each list."""

_USUAL: Json = {"direction": "in", "is_error": False, "wants_reply": False, "is_failure": False, "parameters": []}
"""What is omitted, besides what says nothing."""

_READINGS = (Role.SI_READING.name, Role.RAW_READING.name)


def build_decoder() -> str:
    """Returns the text of ev3-decode.mjs; pages wait for it, so only what is exported has its comment."""
    tables: Json = json.loads(build_tables())
    found = {key: tables[key] for key in ("dialects", "frame")} | {"reasons": REASONS}
    found |= {key: _kept(tables[key], keys) for key, keys in _KEYS.items() if key in tables}
    found["areas"] = {area: _kept(entries, _ENTRY) for area, entries in tables["areas"].items()}
    named = set(re.findall(r'"enum": "(\w+)"', json.dumps(found["areas"])))
    found["enumerations"] = {
        name: {key: each[key] for key in ("members", "flags") if key in each}
        for name, each in tables["enumerations"].items()
        if name in named
    }
    tables_text = f"/** A part of ev3-tables.json, and the words of faults. */\nconst TABLES = {_parsed(found)};\n\n"
    return _decoder_head() + tables_text + re.sub(r"/\*\* .* \*/\n(?=const)", "", written_file("decode.mjs"))


def _kept(entries: list[Json], keys: tuple[str, ...]) -> list[Json]:
    """Returns entries without the ones that no firmware has, and without keys that the decoder does not need."""
    return [dict(_needed(entry, keys)) for entry in entries if entry.get("dialects") != []]


def _needed(entry: Json, keys: tuple[str, ...]) -> Iterator[tuple[str, Any]]:
    for key in keys:
        value = entry.get(key)
        if value is None or value == _USUAL.get(key) or (key == "role" and value not in _READINGS):
            continue
        yield key, _kept(value, _KEYS[key]) if key in _KEYS else value


def build_texts() -> str:
    """Returns the text of ev3-texts.mjs: what the tables say of everything for people."""
    tables: Json = json.loads(build_tables())
    found: Json = {
        key: {each["name"]: each["text"] for each in tables[key]} for key in ("message_types", "daisy_commands")
    }
    # By number: the bootloader has names of the firmware again.
    found["system_commands"] = {each["number"]: each["text"] for each in tables["system_commands"]}
    areas: Json = {area: dict(_said(entries)) for area, entries in tables["areas"].items()}
    return f"{_texts_head()}const found = {_parsed(found | {'areas': areas})};\n{written_file('texts.mjs')}"


def _said(opcodes: list[Json]) -> Iterator[tuple[str, list[Any]]]:
    """Yields the name of each operation with its texts, as texts.mjs reads them."""
    for opcode in opcodes:
        for command in opcode.get("commands", [{}]):
            entry = command or opcode
            parameters = [
                [each["text"], each["special"]] if "special" in each else each["text"] for each in entry["parameters"]
            ]
            elements = [each["each"] for each in entry["parameters"] if "each" in each]
            yield ".".join(filter(None, (opcode["name"], command.get("name")))), [entry["text"], parameters, *elements]


def build_decoder_types() -> str:
    """Returns the text of ev3-decode.d.ts."""
    return _decoder_head() + written_file("decode.d.ts") + declarations_of_messages()


def build_texts_types() -> str:
    """Returns the text of ev3-texts.d.ts."""
    return _texts_head() + written_file("texts.d.ts")


def _decoder_head() -> str:
    return _head("Reads frames of the LEGO MINDSTORMS EV3, in Node and browsers.", _DECODER, "--decoder")


def _texts_head() -> str:
    return _head("What operations, parameters and messages of the EV3 are, in words.", _TEXTS, "--texts")


def _head(title: str, example: str, option: str) -> str:
    head = _HEAD.replace("$TITLE", title).replace("$EXAMPLE", example)
    return head.replace("$VERSION", VERSION).replace("$OPTION", option)


def _parsed(value: Json) -> str:
    """Returns an expression for an object, which JavaScript reads much faster than a literal."""
    text = json.dumps(value, separators=(",", ":"), ensure_ascii=False)
    escaped = re.sub(r"[`$\\]", r"\\\g<0>", text)
    return f"JSON.parse(`{escaped}`)"

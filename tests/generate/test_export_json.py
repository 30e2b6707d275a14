"""The tables as JSON: every entry of the tables is there, and the schema describes it."""

from __future__ import annotations

import copy
import json
from typing import Any

import jsonschema  # type: ignore[import-untyped]
import pytest
from support.built import built_export

from ev3proto.schema.wire_format import ENCODED
from ev3proto.tables import AREAS, OPCODES, enumerations
from ev3proto.tables.declaration import Enumeration, Parameter, Type
from ev3proto.tables.system import SYSTEM

TEXTS = [built_export(f"ev3-tables.{name}").read_text() for name in ("json", "schema.json")]
TABLES: dict[str, Any]
SCHEMA: dict[str, Any]
TABLES, SCHEMA = map(json.loads, TEXTS)
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def entry(area: str, name: str) -> dict[str, Any]:
    found: dict[str, Any] = next(opcode for opcode in TABLES["areas"][area] if opcode["name"] == name)
    return found


def test_the_tables_match_the_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert [error.message for error in VALIDATOR.iter_errors(TABLES)] == []


def test_a_list_typed_by_another_parameter() -> None:
    values = entry("input", "INPUT_READEXT")["parameters"][-1]
    assert (values["type"], values["element_from"], values["elements"]) == ("count", "FORMAT", "out")


def test_operations_say_whether_they_have_a_list() -> None:
    assert entry("input", "INPUT_READEXT")["has_list"]
    assert entry("move", "INIT_BYTES")["has_list"]
    assert "has_list" not in entry("input", "INPUT_READSI")


def test_dialects() -> None:
    assert "dialects" not in entry("sound", "SOUND")
    assert entry("output", "OUTPUT_POSITION")["dialects"] == []
    assert entry("input", "INPUT_SET_CONN")["dialects"] == ["xtended", "compat"]


def parameters(declared: tuple[Parameter, ...], found: list[dict[str, Any]]) -> None:
    assert [(one.name, one.label, one.direction.value, one.text) for one in declared] == [
        (one["name"], one["type"], one["direction"], one["text"]) for one in found
    ]
    for one, other in zip(declared, found, strict=True):
        assert one.unit == other.get("unit")
        assert list(one.range or ()) == other.get("range", [])
        assert (one.enum and one.enum.name) == other.get("enum")
        assert {str(value): text for value, text in one.special.items()} == other.get("special", {})
        assert one.length == other.get("length", other.get("length_from"))
        element = one.element.label if isinstance(one.element, Type) else one.element
        assert element == other.get("element", other.get("element_from"))


def test_all_opcodes_and_cmds_are_exported() -> None:
    assert list(TABLES["areas"]) == list(AREAS)
    found = [opcode for area in TABLES["areas"].values() for opcode in area]
    assert [(one.number, one.name, one.text) for one in OPCODES] == [
        (one["number"], one["name"], one["text"]) for one in found
    ]
    for opcode, other in zip(OPCODES, found, strict=True):
        parameters(opcode.parameters, other.get("parameters", []))
        commands = other.get("commands", [])
        assert [(one.number, one.name) for one in opcode.commands] == [(one["number"], one["name"]) for one in commands]
        for command, told in zip(opcode.commands, commands, strict=True):
            parameters(command.parameters, told["parameters"])


def test_all_enumerations_and_system_commands_are_exported() -> None:
    declared = [enum for enum in vars(enumerations).values() if isinstance(enum, Enumeration)]
    assert {enum.name: dict(enum.members) for enum in declared} == {
        name: enum["members"] for name, enum in TABLES["enumerations"].items()
    }
    assert TABLES["enumerations"]["WARNING"]["flags"] is True
    assert [(one.number, one.name, [field.name for field in one.request]) for one in SYSTEM] == [
        (one["number"], one["name"], [field["name"] for field in one["request"]]) for one in TABLES["system_commands"]
    ]


def test_all_identification_bytes_are_exported() -> None:
    told: dict[int, tuple[str, int | None]] = {}
    for run in TABLES["encodings"]:
        for byte in range(run["first"], run["last"] + 1):
            told[byte] = (run["name"], run["value"] + byte - run["first"] if "value" in run else None)
    for byte in range(0x100):
        argument = ENCODED.parse(bytes((byte, *range(5))))
        if "rest" in argument:
            assert byte not in told
        else:
            assert told[byte][1] == (None if argument.identification.is_long else argument.value)
    assert told[0x3F] == ("LC0", -1)
    assert told[0x82] == ("LC2", None)


@pytest.mark.parametrize(
    ("place", "wrong"),
    [
        (("areas", "sound", 0), {"txt": "misspelt"}),
        (("areas", "sound", 0), {"parameters": []}),  # besides commands
        (("areas", "sound", 1, "parameters", 0), {"type": "DATA64"}),
        (("system_commands", 0), {"number": 256}),
        (("areas", "sound", 1, "parameters", 0), {"enum": "COLOURS"}),
    ],
)
def test_the_schema_finds_mistakes(place: tuple[str | int, ...], wrong: dict[str, object]) -> None:
    tables = copy.deepcopy(TABLES)
    found: Any = tables
    for key in place:
        found = found[key]
    found.update(wrong)
    assert not VALIDATOR.is_valid(tables)


def test_the_form_of_the_files() -> None:
    for text in TEXTS:
        assert text.endswith("}\n")
        assert [line for line in text.split("\n") if line != line.rstrip()] == []
    # What fits in one line is in one.
    assert '\n    {"name": "DATA8", "size": 1, "range": [-127, 127], "nan": -128},\n' in TEXTS[0]

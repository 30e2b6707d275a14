"""The tables are complete: the size of the instruction set, and the fields that every entry needs."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.cases import each

from ev3proto.tables import OPCODES, clashes, enumerations, operations
from ev3proto.tables.declaration import DIALECTS, Declaration, Effect, Enumeration, Parameter, Role, Type, declarations
from ev3proto.tables.system import SYSTEM, FieldKind

pytestmark = pytest.mark.portable

EVERYTHING = [entry for entry in declarations(OPCODES) if entry.dialects]
PARAMETERS = [(entry, parameter) for entry in EVERYTHING for parameter in entry.parameters]


def test_the_official_firmware_counts() -> None:
    """LEGO's own operations; an entry that is added is one more."""
    entries = operations("official").values()
    assert len(entries) >= 458
    assert len({entry.opcode.number for entry in entries if entry.command is None}) >= 187
    assert len({entry.opcode.number for entry in entries if entry.command is not None}) >= 18
    assert len([entry for entry in entries if entry.command is not None]) >= 271


def test_the_other_firmwares_add_and_rename() -> None:
    official, xtended, compat = (set(operations(dialect)) for dialect in DIALECTS)
    assert len({name for name in xtended | compat if "." not in name} - official) == 20
    assert {name for name in xtended | compat if "." in name} - official == {
        "PROGRAM_INFO.GET_PRGNAME",
        "UI_DRAW.RECTANGLE",
        "ARRAY.DESTROY",
        "ARRAY.SET_SIZE",
        "UI_BUTTON.GET_BUMPED",
        "COM_GET.LIST_STATE",
    }
    assert official - xtended == {"UI_DRAW.RECT", "ARRAY.DELETE", "ARRAY.SIZE"}
    assert official - compat == {"UI_DRAW.RECT", "ARRAY.DELETE", "ARRAY.SIZE", "UI_BUTTON.GET_BUMBED"}


def test_an_unknown_dialect_names_the_known_ones() -> None:
    with pytest.raises(ValueError, match="official, xtended, compat"):
        operations("leJOS")


def test_no_number_means_two_operations() -> None:
    assert clashes() == []


@each("entry", EVERYTHING)
def test_every_operation_says_what_it_does(entry: Declaration) -> None:
    assert entry.text[0].isupper()
    assert len(entry.text) > 10
    assert not entry.text.endswith(".")
    assert len({parameter.name for parameter in entry.parameters}) == len(entry.parameters)


@each("entry, parameter", PARAMETERS)
def test_every_parameter_is_consistent(entry: Declaration, parameter: Parameter) -> None:
    names = [other.name for other in entry.parameters]
    assert len(parameter.text) > 2
    assert not parameter.text.endswith(".")
    referred = {parameter.length, parameter.indexed_by, parameter.element}
    assert {name for name in referred if isinstance(name, str)} <= set(names)
    if parameter.range is not None:
        assert parameter.range[0] <= parameter.range[1]
    if parameter.is_list:
        assert parameter.element is not None
        assert parameter is entry.parameters[-1]
    if parameter.is_list and not parameter.counts:
        assert entry.parameters[-2].type is Type.DATA32


@pytest.mark.parametrize(
    ("enumeration", "value", "name"),
    [
        (enumerations.LEDPATTERN, 5, "LED_RED_FLASH"),
        (enumerations.BUTTONTYPE, 6, "BACK_BUTTON"),
        (enumerations.TYPE, 126, "TYPE_NONE"),
        (enumerations.RESULT, 2, "FAIL"),
        (enumerations.WARNING, 64, "WARNING_BATTLOW"),
        (enumerations.WARNING, 5, "WARNING_TEMP|WARNING_VOLTAGE"),
        (enumerations.LEDPATTERN, 10, None),
        (enumerations.LEDPATTERN, "1", None),
    ],
)
def test_names_of_numbers(enumeration: Enumeration, value: object, name: str | None) -> None:
    assert enumeration.name_of(value) == name


def test_system_commands() -> None:
    assert [entry.number for entry in SYSTEM] == [*range(0x92, 0xA3), *range(0xF0, 0xF7)]
    assert [entry.name for entry in SYSTEM if not entry.answered] == ["WRITEMAILBOX", "ENTERFWUPDATE"]
    for entry in SYSTEM:
        for fields in (entry.request, entry.reply):
            names = [field.name for field in fields]
            assert all(field.counts in (None, *names) for field in fields)
            # A value without a length takes all remaining bytes, so it must be the last.
            assert all(field.kind not in (FieldKind.DATA, FieldKind.LISTING) for field in fields[:-1])


def test_what_harms_a_brick_is_named() -> None:
    """The effects in the entries, by which commands are checked before they are sent."""
    harmful = {Effect.DELETES_FILES, Effect.RENAMES, Effect.RUNS_SHELL, Effect.WRITES_FIRMWARE, Effect.RESTARTS}
    assert {name for name, entry in operations().items() if harmful & set(entry.effects)} == {
        "COM_SET.SET_BRICKNAME",
        "FILE.DEL_SUBFOLDER",
        "FILE.MOVE",
        "FILE.REMOVE",
        "SYSTEM",
    }
    assert {entry.number for entry in SYSTEM if harmful & set(entry.effects)} == {
        *(0x9C, 0xA0),
        *(0xF0, 0xF1, 0xF2, 0xF3, 0xF4),
    }


def test_every_effect_and_role_is_some_entry_s() -> None:
    declared = list(declarations(OPCODES))
    effects = {effect for entry in declared for effect in entry.effects}
    assert effects | {effect for entry in SYSTEM for effect in entry.effects} == set(Effect)
    assert {parameter.role for entry in declared for parameter in entry.parameters} == {None, *Role}


def test_effects_are_decisions() -> None:
    """The operations and system commands of today are in the file with their effects, so that none gets lost."""
    entries = [(declaration.name, declaration.effects) for declaration in declarations(OPCODES)]
    entries += [(f"{entry.number:02X} {entry.name}", entry.effects) for entry in SYSTEM]
    lines = [f"{name}: {', '.join(effect.name for effect in effects) or '-'}" for name, effects in entries]
    decided = Path(__file__).with_name("effects.txt").read_text().splitlines()
    assert [line for line in decided if line not in lines] == []


def limits_of_parameter(entry: Declaration, parameter: Parameter) -> str:
    """What a parameter accepts, in one line."""
    facts = [f"{entry.name}.{parameter.name}", parameter.direction.value, parameter.label]
    facts += [] if parameter.range is None else ["{}..{}".format(*parameter.range)]
    facts += [f"{number}" for number in parameter.special]
    facts += [] if parameter.enum is None else [parameter.enum.name]
    facts += [f"{name}={value}" for name, value in (("length", parameter.length), ("most", parameter.most)) if value]
    return " ".join([*facts, *(["unsigned"] * parameter.unsigned)])


def test_limits_are_decisions() -> None:
    """What the parameters of today accept is in the file, so that no number changes by mistake."""
    entries = declarations(OPCODES)
    lines = {limits_of_parameter(entry, parameter) for entry in entries for parameter in entry.parameters}
    decided = Path(__file__).with_name("limits.txt").read_text().splitlines()
    assert len(decided) > 1000
    assert [line for line in decided if line not in lines] == []

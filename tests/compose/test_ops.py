"""Operations as functions: values by position and by name, enumerations, outputs omitted, and what is refused."""

from __future__ import annotations

import copy
import inspect
import pickle
from collections.abc import Callable
from typing import Any

import pytest

import ev3proto
from ev3proto import GV, LV, BuildError, Draft, Global, Local, enums, ops
from ev3proto.enums import BUTTON, DEVCMD, LED, LEDPATTERN, WARNING
from ev3proto.ops import compat, xtended
from ev3proto.tables import operations as operations_of

pytestmark = pytest.mark.portable


def called(path: str, dialect: str = "official") -> Callable[..., Draft]:
    """The function for a path such as `sound.tone`, as programs that work from names find it."""
    found: Any = {"official": ops, "xtended": xtended, "compat": compat}[dialect]
    for name in path.split("."):
        found = getattr(found, name)
    assert callable(found)
    function: Callable[..., Draft] = found
    return function


# The same bytes, whichever way they are asked for

TONE = bytes.fromhex("9401 01 82b801 82e803")


def test_the_tone_of_the_lesson() -> None:
    assert ops.sound.tone(volume=1, frequency=440, duration=1000).raw == TONE
    assert ops.sound.tone(1, 440, 1000).raw == TONE
    assert ops.sound.tone(1, 440, duration=1000).raw == TONE
    assert ops.sound.tone(duration=1000, frequency=440, volume=1).operation == ev3proto.operation(
        "SOUND.TONE", 1, 440, 1000
    )


def test_opcodes_without_a_family() -> None:
    assert ops.output_speed(layer=0, nos=1, speed=50).raw == bytes.fromhex("a5 00 01 8132")
    assert ops.output_start(0, 1).raw == bytes.fromhex("a6 00 01")
    assert ops.ui_flush().raw == b"\x80"
    assert ops.or8(1, 2, LV(0)).raw == bytes.fromhex("20 01 02 40")


def test_words_of_python() -> None:
    assert ops.sound.break_().raw == bytes.fromhex("94 00")
    assert ops.return_().raw == b"\x08"
    assert ops.ui_read.textbox_read("a", 2, del_="DEL_NONE", length=8, line=1).name == "UI_READ.TEXTBOX_READ"


def test_a_command_that_needs_two_bytes() -> None:
    box = ops.ui_draw.textbox(0, 0, 10, 10, "a", 2, "DEL_NONE", LV(0))
    assert box.raw == bytes.fromhex("84 8120 00 00 0a 0a 846100 02 00 40")


def test_variables_and_encoded_arguments() -> None:
    assert ops.ui_read.get_vbatt(value=GV(0)).raw == bytes.fromhex("81 01 60")
    assert ops.ui_read.get_vbatt(LV(4)).raw == bytes.fromhex("81 01 44")
    assert ops.sound.tone(ev3proto.LC2(1), 440, 1000).raw == bytes.fromhex("9401 820100 82b801 82e803")


def test_lists() -> None:
    assert ops.init_bytes(LV(0), 2, [5, 6]).raw == bytes.fromhex("2f 40 02 05 06")
    assert ops.init_bytes(destination=LV(0), source=[5, 6]).raw == bytes.fromhex("2f 40 02 05 06")
    assert ops.call(1, [2, 3]).raw == bytes.fromhex("09 01 02 02 03")
    outputs = ops.input_device.ready_si(0, 0, 0, -1, [GV(0), GV(4)])
    assert outputs.raw == bytes.fromhex("99 1d 00 00 00 3f 02 60 64")


def test_a_list_whose_type_another_argument_tells() -> None:
    written = ops.mailbox_write("", "HW_BT", "abc", "DATA_F", [1.0])
    assert written.raw == bytes.fromhex("d9 8400 02 8461626300 03 01 83 0000803f")


# Enumerations


@pytest.mark.parametrize("pattern", [LED.RED_FLASH, LEDPATTERN.LED_RED_FLASH, "LED_RED_FLASH", 5])
def test_a_member_of_an_enumeration_in_any_form(pattern: Any) -> None:
    assert ops.ui_write.led(pattern=pattern).raw == bytes.fromhex("82 1b 05")


def test_enumerations_have_the_names_of_the_firmware_and_short_ones() -> None:
    assert LED is LEDPATTERN
    assert (LED.RED_FLASH.name, int(LED.RED_FLASH)) == ("LED_RED_FLASH", 5)
    assert LEDPATTERN["RED_PULSE"].name == "LED_RED_PULSE"
    assert repr(BUTTON.ENTER) == "<BUTTONTYPE.ENTER_BUTTON: 2>"
    with pytest.raises(AttributeError, match=r"^TYPE has no member TOUCH: did you mean TYPE_TOUCH\?$"):
        _ = enums.TYPE.TOUCH  # type: ignore[attr-defined]
    assert [member.name for member in enums.TYPE][:3] == ["MODE_KEEP", "TYPE_KEEP", "TYPE_NXT_TOUCH"]
    assert repr(DEVCMD.FIRE) == repr(DEVCMD.RESET)
    assert (WARNING.TEMP | WARNING.BUSY) == 129
    assert pickle.loads(pickle.dumps(LED.RED)) is LED.RED
    assert "LED" in dir(enums)
    assert "LEDPATTERN" in dir(enums)


def test_the_flat_constants_stay_what_they_are() -> None:
    assert (ev3proto.LED_RED, ev3proto.LED) == (b"\x02", b"\x1b")


# What is refused at the call


@pytest.mark.parametrize(
    ("path", "values", "named", "sentence"),
    [
        ("sound.tone", (1, 440), {}, "tone() missing 1 required positional argument: 'duration'"),
        ("sound.tone", (1,), {"frequncy": 2}, "tone() got an unexpected keyword argument 'frequncy'"),
        ("init_bytes", (), {}, "INIT_BYTES also needs SOURCE"),
        ("init_bytes", (None, 2), {}, "INIT_BYTES also needs SOURCE"),
    ],
)
def test_wrong_calls(path: str, values: tuple[Any, ...], named: dict[str, Any], sentence: str) -> None:
    with pytest.raises(TypeError) as raised:
        called(path)(*values, **named)
    # Python 3.13 has a guess at what was meant behind it.
    assert str(raised.value).startswith(sentence)


UNCHECKED = "; pass unchecked=True to allow it"


@pytest.mark.parametrize(
    ("path", "values", "sentence"),
    [
        ("sound.tone", (101, 440, 1000), f"SOUND.TONE: VOLUME must be 0 to 100 %, not 101{UNCHECKED}"),
        ("sound.tone", (1, 249, 1000), f"SOUND.TONE: FREQUENCY must be 250 to 10000 Hz, not 249{UNCHECKED}"),
        ("sound.tone", (1.5, 440, 1000), "VOLUME cannot be 1.5: use 0 to 100 %; a DATA8 is a whole number"),
        ("sound.tone", (float("nan"), 440, 1000), f"SOUND.TONE: VOLUME must be 0 to 100 %, not nan{UNCHECKED}"),
        ("sound.tone", ("loud", 440, 1000), "VOLUME takes a number or a variable, not 'loud'"),
        ("input_device.ready_si", (0, 0, 0, 8), f"MODE must be 0 to 7 or -1 (keep the mode), not 8{UNCHECKED}"),
        ("ui_write.led", (10,), f"9 LED_ORANGE_PULSE, not 10{UNCHECKED}"),
        ("ui_write.led", ("LED_RED_FLSH",), "PATTERN cannot be 'LED_RED_FLSH': did you mean LED_RED_FLASH or"),
        ("ui_write.led", ("blue",), "PATTERN must be one of 0 LED_BLACK, 1 LED_GREEN, 2 LED_RED"),
        ("ui_write.led", (BUTTON.UP,), "PATTERN takes a member of LEDPATTERN, not <BUTTONTYPE.UP_BUTTON: 1>"),
        ("output_set_type", (0, 0, 120), "TYPE must be one of -1 MODE_KEEP, 0 TYPE_KEEP, 1 TYPE_NXT_TOUCH,"),
        ("or8", (-128, 1), f'SOURCE1 must be -127 to 127 (-128 means "not a number"), not -128{UNCHECKED}'),
        ("math.acos", (1.5,), f"X must be -1 to 1, not 1.5{UNCHECKED}"),
        ("math.sqrt", (10**400,), "a DATAF is from -3.4028235e38 to 3.4028235e38"),
        ("sound.play", (1, b"\x05"), f"NAME takes a string or a variable, not 5{UNCHECKED}"),
        ("jr", (-(2**31),), "OFFSET must be -2147483647 to 2147483647 (-2147483648 means"),
        ("ui_read.get_vbatt", (8,), "VALUE is an output and cannot be 8: use a variable such as GV(0) or LV(0)"),
        ("ui_read.get_vbatt", (GV(2),), "VALUE cannot be GV(2): as DATAF it must be at a multiple of 4"),
        ("ui_draw.notification", (1, 0, 0, 0, 0, 0, "a", 0), "STATE cannot be 0: the brick writes to it, so it takes"),
        ("ui_read.get_os_vers", (-1,), "DESTINATION cannot be omitted: its length is unknown"),
        ("strings.add", ("a", "b"), "Pass its size, Global(32), or its place, GV(0)"),
        ("init_bytes", (LV(0), 3, [1, 2]), "INIT_BYTES: LENGTH says 3, but 2 values follow"),
        ("init_bytes", (LV(0), 3, 1), "INIT_BYTES: SOURCE takes a list, not 1"),
        ("input_device.ready_si", (0, 0, 0, 0, 128), "VALUES must be 0 to 127 as a number of outputs, not 128"),
        ("com_set.set_brickname", ("\u1234",), "the brick's strings are ISO-8859-1"),
    ],
)
def test_wrong_values(path: str, values: tuple[Any, ...], sentence: str) -> None:
    with pytest.raises(BuildError) as raised:
        called(path)(*values)
    assert sentence in str(raised.value)


@pytest.mark.parametrize(
    ("path", "values", "raw"),
    [
        ("sound.tone", (101, 20, 1000), "9401 8165 14 82e803"),
        ("ui_write.led", (10,), "82 1b 0a"),
        ("or8", (-128, 1, LV(0)), "20 8180 01 40"),
        ("ui_read.get_vbatt", (GV(2),), "81 01 62"),
        ("ui_draw.notification", (1, 0, 0, 0, 0, 0, "a", 0), "84 0b 01 00 00 00 00 00 846100 00"),
    ],
)
def test_unchecked_values(path: str, values: tuple[Any, ...], raw: str) -> None:
    with pytest.raises(BuildError):
        called(path)(*values)
    assert called(path)(*values, unchecked=True).raw == bytes.fromhex(raw)


def test_special_values_outside_the_range() -> None:
    assert ops.input_device.clr_all(layer=-1).raw == bytes.fromhex("99 0a 3f")
    assert ops.output_set_type(0, 0, 60).raw == bytes.fromhex("a1 00 00 813c")  # a type of a third party
    assert ops.math.exp(float("nan"), LV(0)).raw == bytes.fromhex("8d 01 83 0000c07f 40")


# Every operation, and how it looks


@pytest.mark.parametrize("dialect", ["official", "xtended", "compat"])
def test_every_operation_has_its_function(dialect: str) -> None:
    missing = []
    for name, declaration in operations_of(dialect).items():
        path = ".".join(part + "_" * (part in ("return", "break")) for part in name.lower().split("."))
        function = called(path, dialect)
        found = [each.rstrip("_").upper() for each in inspect.signature(function).parameters]
        if found != [parameter.name.upper() for parameter in declaration.parameters] + ["UNCHECKED"]:
            missing.append((name, found))
    assert missing == []


def test_dialects_have_their_own() -> None:
    assert xtended.ui_draw.rectangle(1, 0, 0, 5, 5).raw == ops.ui_draw.rect(1, 0, 0, 5, 5).raw
    with pytest.raises(AttributeError, match="rectangle"):
        called("ui_draw.rectangle")
    with pytest.raises(AttributeError, match="rect"):
        called("ui_draw.rect", "xtended")


@pytest.mark.parametrize(
    ("dialect", "made"),
    [
        ("xtended", lambda: xtended.sound.tone(1, 440, 1000)),
        ("xtended", lambda: xtended.ui_draw.rectangle(1, 0, 0, 5, 5)),
        ("compat", lambda: compat.com_get.list_state("HW_BT", GV(0))),
        ("compat", lambda: ops.sound.tone(1, 440, 1000)),
    ],
)
def test_an_operation_equals_the_one_that_is_parsed_in_a_dialect(dialect: str, made: Callable[[], Draft]) -> None:
    message = ev3proto.command(made())
    assert ev3proto.parse(message.build(), dialect=dialect) == message


def test_the_help_of_a_function() -> None:
    assert str(inspect.signature(ops.sound.tone)) == (
        "(volume: 'Number', frequency: 'Number', duration: 'Number', *, unchecked: 'bool' = False) -> 'Draft'"
    )
    assert inspect.getdoc(ops.sound.tone) == (
        "Plays one tone and returns at once.\n"
        "\n"
        "Args:\n"
        "    volume: Volume; 0 to 100 %; 0: silent; DATA8.\n"
        "    frequency: Pitch; the driver clamps it to the range; 250 to 10000 Hz; DATA16.\n"
        "    duration: Duration, read unsigned (-1 is 65535); ms; 0: until BREAK or the next sound; DATA16.\n"
        "    unchecked: Accept values that mean nothing to the brick, as far as they can be encoded."
    )
    assert "in global memory when omitted" in (inspect.getdoc(ops.ui_read.get_vbatt) or "")
    assert str(inspect.signature(ops.init_bytes)).startswith(
        "(destination: 'Output' = None, length: 'Number | None' = None, source: 'Sequence[Number]' = required, *,"
    )
    assert inspect.getsource(ops.sound.tone).startswith("def tone(volume: Number,")
    assert {"sound", "ui_read", "output_start"} < set(dir(ops))
    assert ops.sound.__all__ == ["break_", "play", "repeat", "service", "tone"]


def test_a_draft_tells_what_is_open() -> None:
    open_draft = ops.ui_read.get_vbatt()
    assert (open_draft.name, open_draft.is_complete) == ("UI_READ.GET_VBATT", False)
    assert repr(open_draft) == "<UI_READ.GET_VBATT(VALUE=omitted)>"
    assert (
        repr(ops.strings.add("a", "b", Global(12))) == "<STRINGS.ADD(SOURCE1='a', SOURCE2='b', DESTINATION=Global(12))>"
    )
    with pytest.raises(
        BuildError, match=r"^UI_READ\.GET_VBATT: VALUE has no place in memory yet: use ev3proto\.command"
    ):
        _ = open_draft.raw
    assert ops.sound.tone(1, 440, 1000).is_complete


def test_places() -> None:
    assert [repr(place) for place in (Local(), Global(4), Local().as_handle())] == [
        "Local()",
        "Global(4)",
        "Local().as_handle()",
    ]
    for size in (0, -1, 1.5, True, "4"):
        with pytest.raises(BuildError, match="must be a number of bytes, 1 or more"):
            Local(size)  # type: ignore[arg-type]


def test_drafts_are_copied_and_pickled() -> None:
    tone = ops.sound.tone(1, 440, 1000)
    assert copy.deepcopy(tone).raw == pickle.loads(pickle.dumps(tone)).raw == TONE

"""What a frame may do to a brick: everything harmful that runs is named by `harms_of`."""

from __future__ import annotations

import pytest

import ev3proto
from ev3proto import GV, LV, Operation, check, operation
from ev3proto.link.harm import Harm, harms_of
from ev3proto.messages import Message
from ev3proto.schema.argument import encode_as


def harms(frame: bytes) -> set[Harm]:
    return set(harms_of(ev3proto.parse(frame, strict=False)))


def command(*operations: Operation) -> bytes:
    return ev3proto.direct_command(*operations, local_size=4).build()


SKIPPED = operation("MOVE8_8", 1, LV(0))


@pytest.mark.parametrize(
    ("frame", "found"),
    [
        ("1500010000020440037d0184a4400f8132a6400f0a0060", Harm.MOTORS),  # into a text that contains OUTPUT_START
        ("1300010000041030034040407d0184a6440f0a0060", Harm.UNKNOWN),  # by a variable
    ],
)
def test_hidden_code(frame: str, found: Harm) -> None:
    assert found in harms(bytes.fromhex(frame))


def test_a_command_of_the_operating_system() -> None:
    assert harms(command(operation("SYSTEM", "reboot", LV(0)))) == {Harm.SHELL}


HIDDEN = operation("STRINGS.GET_SIZE", "\xa6\x40\x0f\x40\x02", GV(0))
"""OUTPUT_START(LV(0), 15) and a jump over the rest are in its text, three bytes after its start."""


@pytest.mark.parametrize(
    "jumps",
    [
        [operation("JR", 3)],
        [operation("JR_TRUE", LV(0), 3)],
        [operation("JR_LT8", 1, 2, 3)],
        [operation("JR", 0), operation("JR", 3)],
        [operation("JR", encode_as("LC4", 3))],
        [operation("JR", encode_as("LAB1", 35)), bytes(32)],
    ],
)
def test_code_in_a_text_is_read(jumps: list[Operation | bytes]) -> None:
    if isinstance(jumps[-1], bytes):
        jumps = [jumps[0], *[operation("NOP")] * 32]
    assert harms(command(*jumps, HIDDEN)) == {Harm.MOTORS}  # type: ignore[arg-type]


def test_a_jump_back_into_code_is_read() -> None:
    assert harms(command(HIDDEN, operation("JR", -HIDDEN.length - 2 + 3))) == {Harm.MOTORS}


def test_a_label_in_a_text_is_none() -> None:
    """The firmware places labels when it reads the code from its start."""
    text = operation("STRINGS.GET_SIZE", "\x0d\x03", GV(0))
    assert harms(command(text, operation("JR", encode_as("LAB1", 3)))) == {Harm.UNKNOWN}


@pytest.mark.parametrize(
    "jump",
    [
        operation("JR", 1),  # into SKIPPED, where 0x01 is NOP and 0x40 a jump that is cut off
        operation("JR", -1),  # into itself
        operation("JR", 100),
        operation("JR", -100),
        operation("JR_TRUE", 1, LV(0)),
        operation("JR", encode_as("LAB1", 3)),  # unknown label
        operation("JR", encode_as("LAB1", 100)),  # not a label, but a distance
        operation("JR", bytes((0x91, 3))),  # a handle, though a constant
    ],
)
def test_what_cannot_be_followed_is_unknown(jump: Operation) -> None:
    assert harms(command(jump, SKIPPED)) == {Harm.UNKNOWN}


@pytest.mark.parametrize(
    "jump",
    [
        operation("JR", 0),
        operation("JR", SKIPPED.length),
        operation("JR", 2 * SKIPPED.length),  # to the end
        operation("JR_TRUE", LV(0), -3),
        operation("JR", encode_as("LAB1", 2)),
    ],
)
def test_jumps_to_operations_are_harmless(jump: Operation) -> None:
    assert harms(command(jump, SKIPPED, SKIPPED)) == (set() if jump.arguments[-1].kind != "label" else {Harm.UNKNOWN})
    assert harms(command(jump, SKIPPED, SKIPPED, operation("LABEL", 2))) == set()


@pytest.mark.parametrize(
    "writer",
    [
        # Four bytes of code are written over an empty text and what follows it: OUTPUT_START(0, 1) runs.
        operation("MOVE32_32", encode_as("LC4", 0x0100A601), encode_as("LCS", "")),
        operation("STRINGS.DUPLICATE", "abc", encode_as("LCS", "xyz")),
        operation("WRITE8", 1, 0, encode_as("LCS", "x")),
        operation("MOVE32_32", 1, encode_as("LV4", 1 << 20)),
        operation("MOVE32_32", 1, encode_as("GV2", 1020)),
        operation("MOVE32_32", 1, bytes((0xC9, 0))),  # by an address
        operation("WRITE8", 1, 100, LV(0)),
        operation("WRITE8", 1, -1, LV(0)),
        operation("WRITE8", 1, LV(4), LV(0)),
    ],
)
def test_code_that_may_rewrite_code_is_unknown(writer: Operation) -> None:
    assert harms(command(writer, operation("NOP"), operation("NOP"))) == {Harm.UNKNOWN}


@pytest.mark.parametrize(
    "writer",
    [
        operation("WRITE8", 1, 3, LV(0)),
        operation("MOVE32_32", 1, LV(56)),
        operation("UI_READ.GET_FW_VERS", 100, GV(0)),
        operation("STRINGS.ADD", "a", "b", GV(0)),
        operation("MOVE32_32", 1, b"\x00"),  # what is written to a number is lost
    ],
)
def test_what_writes_to_variables_is_harmless(writer: Operation) -> None:
    assert harms(command(writer)) == set()


def test_code_that_older_firmware_reads_otherwise_is_unknown() -> None:
    """It does not know UI_READ.GET_POWER and runs NOP, NOP, NOP, UI_BUTTON.FLUSH, OUTPUT_START(0, 1)."""
    frame = bytes.fromhex("0f0001000000 00811d010101 8304a60001".replace(" ", ""))
    assert check(frame).accepted
    assert harms(frame) == {Harm.UNKNOWN}


def test_what_can_run_counts() -> None:
    motor = operation("OUTPUT_START", 0, 1)
    assert harms(command(operation("JR_TRUE", LV(0), motor.length), motor)) == {Harm.MOTORS}
    assert harms(command(operation("JR", SKIPPED.length), SKIPPED, motor)) == {Harm.MOTORS}
    assert harms(command(operation("JR", motor.length), motor)) == set()
    assert harms(command(operation("JR", motor.length), motor, operation("JR", -motor.length - 2))) == {Harm.MOTORS}


@pytest.mark.parametrize(
    ("message", "harm"),
    [
        (ev3proto.command(operation("ARRAY.WRITE_CONTENT", 1, 1, 0, 4, GV(0))), Harm.PROGRAMS),
        (ev3proto.command(operation("COM_SET.SET_PASSKEY", 2, 1)), Harm.SETTINGS),
        (ev3proto.command(operation("OUTPUT_STOP", 0, 15, 0)), Harm.MOTORS),
        (ev3proto.command(operation("OUTPUT_SPEED", 0, 15, 50)), Harm.MOTORS),
        (ev3proto.command(operation("OUTPUT_POLARITY", 0, 15, -1)), Harm.MOTORS),
        (ev3proto.system_command("WRITEMAILBOX", name="a", payload=b"x"), Harm.MESSAGES),
    ],
)
def test_effects(message: Message, harm: Harm) -> None:
    assert set(harms_of(message)) == {harm}


def test_effects_in_extensions() -> None:
    frame = ev3proto.direct_command(operation("INPUT_IIC_WRITE", 0, 0, 1, GV(0), 1, GV(4), dialect="xtended")).build()
    assert set(harms_of(ev3proto.parse(frame, dialect="xtended"), dialect="xtended")) == {Harm.DEVICES}

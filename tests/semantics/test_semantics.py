"""The meaning of arguments: the memory that an operation uses, shared by composing, checking and reading replies."""

from __future__ import annotations

import pytest

import ev3proto
from ev3proto import GV, LV, Draft, check, command, ops
from ev3proto.semantics.footprint import footprints

# The requested memory is what a check wants


@pytest.mark.parametrize(
    ("draft", "globals_", "locals_"),
    [
        (ops.read8(GV(0), 5, GV(6)), 7, 0),
        (ops.read16(LV(0), 5, GV(0)), 2, 12),
        (ops.read32(LV(0), 5, GV(0)), 4, 24),
        (ops.readf(LV(4), 2, GV(0)), 4, 16),
        (ops.write8(7, 9, LV(0)), 0, 10),
        (ops.write16(7, 9, LV(0)), 0, 20),
        (ops.write32(7, 9, LV(0)), 0, 40),
        (ops.writef(7.0, 9, GV(0)), 40, 0),
        (ops.array.fill(LV(0), LV(4)), 0, 8),
        (ops.array_read(LV(0), 3, GV(0)), 4, 2),
        (ops.array_write(LV(0), 3, LV(4)), 0, 8),
        (ops.array_append(LV(0), LV(4)), 0, 8),
        (ops.mailbox_read(0, 4, [GV(0), GV(4)]), 8, 0),
        (ops.ui_read.get_os_vers(0), 0, 0),
    ],
    ids=lambda value: value.name if isinstance(value, Draft) else None,
)
def test_a_command_asks_for_the_memory_that_a_check_wants(draft: Draft, globals_: int, locals_: int) -> None:
    message = command(draft)
    assert (message.global_size, message.local_size) == (globals_, locals_)
    assert [finding.message for finding in check(message.build()).findings if finding.code[1] == "4"] == []


def test_an_element_that_is_stored_in_global_memory_asks_for_a_reply() -> None:
    assert command(ops.write8(1, 2, GV(0))).wants_reply
    assert not command(ops.write8(1, 2, LV(0))).wants_reply


# Footprints


def test_the_footprint_of_an_array_of_which_one_element_is_read() -> None:
    source, destination = footprints(ev3proto.operation("READ16", LV(4), 3, GV(0)))
    assert (source.start, source.end, source.most) == (4, 12, 8)
    assert (source.facts.is_read, source.facts.is_written, source.is_array, source.facts.is_result) == (
        True,
        False,
        True,
        False,
    )
    assert (destination.start, destination.end, destination.is_exact) == (0, 2, True)
    assert (destination.facts.is_read, destination.facts.is_written, destination.facts.is_result) == (False, True, True)
    assert source.full_name == "SOURCE of READ16"


def test_an_array_whose_element_a_variable_tells_is_open_ended() -> None:
    (_, destination) = footprints(ev3proto.operation("WRITE32", 7, LV(0), LV(4)))
    assert (destination.size, destination.most, destination.is_open) == (4, None, True)
    assert destination.facts.is_written


def test_an_element_of_an_array_of_unknown_type_takes_one_to_four_bytes() -> None:
    _, value = footprints(ev3proto.operation("ARRAY_READ", LV(0), 0, GV(0)))
    assert (value.size, value.most, value.room, value.facts.alignment) == (1, 4, 4, 4)
    assert (value.facts.validator_alignment, value.facts.cpu_alignment) == (1, 1)


def test_a_value_of_a_mailbox_may_be_a_text() -> None:
    (value,) = footprints(ev3proto.operation("MAILBOX_READ", 0, 0, [GV(0)]))
    assert (value.size, value.most, value.room) == (1, None, 4)


@pytest.mark.parametrize(
    ("operation", "size", "most"),
    [
        (ev3proto.operation("UI_READ.GET_OS_VERS", 16, GV(0)), 16, 16),
        (ev3proto.operation("UI_READ.GET_OS_VERS", -1, GV(0)), 1, None),
        (ev3proto.operation("INPUT_DEVICE.SETUP", 0, 0, 1, 0, 2, LV(0), -3, GV(0)), 3, 3),
        (ev3proto.operation("INPUT_DEVICE.SETUP", 0, 0, 1, 0, 2, LV(0), -1, GV(0)), 1, 1),
    ],
)
def test_lengths_below_zero(operation: ev3proto.Operation, size: int, most: int | None) -> None:
    """-1 means unlimited for a text; other arrays are read in reverse order."""
    *_, last = footprints(operation)
    assert (last.size, last.most) == (size, most)


def test_a_variable_that_holds_a_handle_or_an_address_takes_the_bytes_of_that() -> None:
    name = ev3proto.operation("SOUND.PLAY", 1, LV(2, handle=True))
    assert [(found.size, found.facts.validator_alignment, found.facts.cpu_alignment) for found in footprints(name)] == [
        (2, 2, 2)
    ]
    level = ev3proto.operation("SOUND.PLAY", LV(4, address=True), "a")
    assert [
        (found.size, found.facts.validator_alignment, found.facts.cpu_alignment) for found in footprints(level)
    ] == [(4, 1, 4)]


def test_a_variable_that_holds_a_handle_is_one_value() -> None:
    """The footprint says two bytes, whatever the length; the array is not in the reply."""
    asked = ev3proto.operation("TST.TST_READ_PINS", 0, 5, GV(2, handle=True))
    assert [(found.start, found.size) for found in footprints(asked)] == [(2, 2)]
    message = ev3proto.direct_command(asked, reply=True, global_size=8)
    dialogue = ev3proto.Dialogue()
    dialogue.feed(message)
    (value,) = dialogue.feed(ev3proto.direct_reply(bytes((0, 0, 7, 1, 5, 5, 5, 5))))
    assert (value.value, value.type, value.offset, value.length) == (0x107, "handle", 7, 2)

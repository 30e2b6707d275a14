"""The meaning of arguments: the memory that an operation uses, shared by composing, checking and reading replies."""

from __future__ import annotations

import struct

import pytest

import ev3proto
from ev3proto import GV, LV, Draft, check, command, ops
from ev3proto.semantics.domain import facts
from ev3proto.semantics.replies import guesses
from ev3proto.tables import operations

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
        (ops.input_device.setup(0, 0, 1, 0, 2, LV(0), -3, GV(0)), 3, 2),  # in reverse order
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


def test_a_variable_that_holds_a_handle_is_one_value() -> None:
    """Two bytes, whatever the length; the array is not in the reply."""
    asked = ev3proto.operation("TST.TST_READ_PINS", 0, 5, GV(2, handle=True))
    message = ev3proto.direct_command(asked, reply=True, global_size=8)
    dialogue = ev3proto.Dialogue()
    dialogue.feed(message)
    (value,) = dialogue.feed(ev3proto.direct_reply(bytes((0, 0, 7, 1, 5, 5, 5, 5))))
    assert (value.value, value.type, value.offset, value.length) == (0x107, "handle", 7, 2)


@pytest.mark.parametrize(
    ("number", "is_likely"),
    [(9_999_999.0, True), (1e7, False), (-1e7, False), (1.1e-6, True), (0.9e-6, False), (0.0, True)],
)
def test_a_reply_of_unknown_meaning_holds_a_likely_float(number: float, is_likely: bool) -> None:
    assert ("DATAF" in guesses(struct.pack("<f", number))) is is_likely


def test_the_longest_text_of_a_parameter() -> None:
    """The buffer of 50 bytes for the name of a mailbox has room for its zero."""
    parameters = operations("official")["MAILBOX_OPEN"].parameters
    texts = {each.name: set(facts(each)) for each in parameters}
    assert "at most 49 characters" in texts["BOXNAME"]


@pytest.mark.parametrize(
    ("name", "parameter", "words"),
    [
        ("UI_READ.GET_STRING", "DESTINATION", "as many bytes as LENGTH says"),
        ("FILE.READ_BYTES", "DESTINATION", "as many values as BYTES says"),
        ("UI_DRAW.GRAPH_SETUP", "MIN", "as many values as ITEMS says"),
    ],
)
def test_the_length_of_a_text_and_of_an_array(name: str, parameter: str, words: str) -> None:
    (found,) = (each for each in operations("official")[name].parameters if each.name == parameter)
    assert list(facts(found)) == [words]

"""Jumps to labels in Python: how far they are, by hand, and what is said where that cannot be worked out."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import ev3proto
from ev3proto import LV, BuildError, DirectCommand, Label, Local, ops
from ev3proto.schema.argument import encode_integer
from ev3proto.semantics.drafts.placeholders import settle


def code(command: DirectCommand) -> str:
    """The byte code of a command, in hex."""
    return command.build()[7:].hex(" ").upper()


def test_back_and_forth() -> None:
    again, end = Label("again"), Label("end")
    number = Local()
    loop = ev3proto.command(
        again, ops.add8(number, 1, number), ops.jr_lt8(number, 10, again), ops.jr(end), ops.nop(), end
    )
    # The loop's two operations have four bytes each, so back it is -8; over NOP it is 1.
    assert code(loop) == "10 40 01 40 64 40 0A 38 40 01 01"
    assert loop.local_size == 1


def test_a_label_is_known_by_its_name() -> None:
    assert code(ev3proto.command(Label("a"), ops.nop(), ops.jr_false(0, Label("a")))) == "01 41 00 3C"


@pytest.mark.parametrize(
    ("nops", "back", "forth"),
    [
        (30, "40 20", "40 1E"),
        (31, "40 81 DE", "40 1F"),
        (32, "40 81 DD", "40 81 20"),
        (124, "40 81 81", "40 81 7C"),
        (125, "40 82 7F FF", "40 81 7D"),
        (128, "40 82 7C FF", "40 82 80 00"),
    ],
)
def test_a_jump_is_as_long_as_it_needs(nops: int, back: str, forth: str) -> None:
    place = Label("place")
    between = [ops.nop()] * nops
    assert code(ev3proto.command(place, *between, ops.jr(place))).endswith(back)
    assert code(ev3proto.command(ops.jr(place), *between, place)).startswith(forth)


def test_jumps_over_jumps_and_variables_without_a_place() -> None:
    end = Label("end")
    command = ev3proto.command(ops.jr_true(1, end), ops.ui_read.get_vbatt(), ops.jr_nan(LV(0), end), end)
    # JR_TRUE jumps over UI_READ, 81 01 60, and JR_NAN, 43 40 00.
    assert code(command) == "42 01 06 81 01 60 43 40 00"
    assert command.wants_reply


def test_the_label_of_a_draft() -> None:
    draft = ops.jr(Label("again"))
    assert repr(draft) == "<JR(OFFSET=Label('again'))>"
    assert not draft.is_complete


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: ev3proto.command(ops.jr(Label("a"))), "Label('a') has no place: pass it to command() before"),
        (lambda: ev3proto.command(Label("a"), Label("a"), ops.nop()), "Label('a') occurs twice"),
        (lambda: ev3proto.command(Label("a")), "a command needs at least one operation"),
        (lambda: ops.jr(Label("a")).raw, "JR: the distance to Label('a') is known only in ev3proto.command"),
        (lambda: ops.move8_8(Label("a"), LV(0)), "MOVE8_8: SOURCE cannot be Label('a')"),  # type: ignore[arg-type]
        (lambda: ops.jr("again"), "JR: OFFSET takes a number, a variable or Label('again'), not 'again'"),  # type: ignore[arg-type]
        (lambda: Label(""), "the name of a label must be a text, such as Label('again'), not ''"),
    ],
)
def test_errors_about_labels(call: Callable[[], object], sentence: str) -> None:
    with pytest.raises(BuildError) as caught:
        call()
    assert str(caught.value).startswith(sentence)


@pytest.mark.parametrize(
    ("between", "size"), [(30, 1), (31, 1), (32, 2), (126, 2), (127, 2), (128, 3), (32767, 3), (32768, 5)]
)
def test_a_jump_forwards_has_the_bytes_that_its_distance_needs(between: int, size: int) -> None:
    """EV3-G begins with the longest jumps, and shortens them; other assemblers begin with the shortest."""
    for first, is_shrinking in ((5, True), (1, False)):
        sizes = [first, between]
        settle(sizes, {0: 2}, lambda distance: len(encode_integer(distance)), is_shrinking=is_shrinking)
        assert sizes == [size, between]

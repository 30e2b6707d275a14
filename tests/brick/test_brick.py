"""The virtual brick from frame to reply: what is answered, what survives, what is refused, what takes time."""

from __future__ import annotations

import pytest
from support.bricks import FAIL, OK, command, op, run, taken_apart

from ev3proto.brick import Brick
from ev3proto.messages import GV, LV

pytestmark = pytest.mark.portable


def exchange(brick: Brick, frame: str) -> list[str]:
    """Sends a frame written in hex, with bars between its fields, and returns the replies in hex."""
    return [reply.hex(" ") for reply in brick.receive(bytes.fromhex(frame.replace("|", " ")))]


REMEMBERED = "0C 00|01 00|80|04 00|3A 83 9B 27 17 2A 60"
"""MOVE32_32 of a constant to GV0, without a reply."""


def test_global_memory_survives_from_one_direct_command_to_the_next(brick: Brick) -> None:
    assert exchange(brick, REMEMBERED) == []
    assert exchange(brick, "06 00|02 00|00|04 00|01") == ["07 00 02 00 02 9b 27 17 2a"]


def test_a_refused_command_is_answered_with_the_old_memory(brick: Brick) -> None:
    exchange(brick, REMEMBERED)
    assert exchange(brick, "06 00|03 00|00|04 00|00") == ["07 00 03 00 04 9b 27 17 2a"]


def test_a_later_command_with_more_memory_sees_what_was_ever_written(brick: Brick) -> None:
    run(brick, op("INIT_BYTES", GV(0), 6, [1, 2, 3, 4, 5, 6]), globals=6)
    run(brick, op("MOVE8_8", 9, GV(0)), globals=1)
    assert run(brick, op("NOP"), globals=8) == (OK, bytes((9, 2, 3, 4, 5, 6, 0, 0)))


def test_locals_arrays_and_files_do_not_survive(brick: Brick) -> None:
    run(brick, op("MOVE8_8", 9, LV(0)), op("ARRAY.CREATE8", 4, LV(2)), locals=4)
    found = run(brick, op("MOVE8_8", LV(0), GV(0)), op("ARRAY.SIZE", 1, GV(4)), globals=8, locals=4)
    assert found == (OK, bytes(8))


def test_a_command_that_fails_half_way_answers_what_it_had_written(brick: Brick) -> None:
    closed = op("TST.TST_CLOSE")
    found = run(brick, op("MOVE8_8", 1, GV(0)), closed, op("MOVE8_8", 2, GV(1)), globals=4)
    assert found == (FAIL, bytes((1, 0, 0, 0)))


@pytest.mark.parametrize(
    ("frame", "reply"),
    [
        ("05 00|09 00|00|00 00", "03 00 09 00 04"),
        ("06 00|09 00|00|FE 03|01", "03 00 09 00 04"),
        ("03 00|09 00|00", "03 00 09 00 04"),
    ],
)
def test_header_errors_are_answered_and_the_brick_lives_on(brick: Brick, frame: str, reply: str) -> None:
    assert exchange(brick, frame) == [reply]
    assert exchange(brick, "06 00|0A 00|00|00 00|01") == ["03 00 0a 00 02"]


def test_a_command_without_reply_is_answered_by_nothing_whatever_happens(brick: Brick) -> None:
    assert brick.receive(command(b"\0", reply=False)) == []
    assert brick.receive(command(op("TST.TST_CLOSE"), reply=False)) == []
    assert exchange(brick, "05 00|09 00|80|00 00") == []


@pytest.mark.parametrize(
    "frame", ["00 00|00 00|00", "02 00|01 00", "06 00|01 00|0B|00 00|01", "", "00", "FF FF 00 00 00"]
)
def test_polls_and_unknown_types_are_ignored(brick: Brick, frame: str) -> None:
    assert exchange(brick, frame) == []


def test_bytes_behind_the_frame_are_ignored_as_those_of_a_report(brick: Brick) -> None:
    frame = command(op("MOVE8_8", 7, GV(0)), globals=1)
    assert brick.receive(frame.ljust(1024, b"\xaa")) == [bytes.fromhex("04 00 01 00 02 07")]


@pytest.mark.parametrize("name", ["COM_READDATA", "COM_WRITEDATA"])
def test_operations_that_the_machine_has_not_fail(brick: Brick, name: str) -> None:
    assert run(brick, op("MOVE8_8", 1, GV(0)), op(name, 0, 0, 0, 0), globals=1) == (FAIL, b"\x01")


def test_unknown_commands_do_nothing_and_their_parameters_are_operations(brick: Brick) -> None:
    # MATH 31, then what a parameter would have been: NOP. STRINGS 30 and INFO 20 likewise.
    unknown = bytes.fromhex("8D 1F 01 7D 1E 01 7C 14 01")
    assert run(brick, unknown, op("MOVE8_8", 5, GV(0)), globals=1) == (OK, b"\x05")


@pytest.mark.parametrize("code", ["C0 1F", "82 1F", "0C 1F", "D3 1F", "D4 1F"])
def test_unknown_commands_of_some_opcodes_fail(brick: Brick, code: str) -> None:
    assert run(brick, bytes.fromhex(code))[0] == FAIL


@pytest.mark.parametrize(
    "ending",
    [op("OBJECT_STOP", 1), op("PROGRAM_STOP", 2), op("PROGRAM_STOP", -1)],
    ids=["object 1", "slot 2", "current slot"],
)
def test_what_ends_a_command_is_fine_and_nothing_behind_it_is_run(brick: Brick, ending: bytes) -> None:
    assert run(brick, ending, op("MOVE8_8", 1, GV(0)), globals=1) == (OK, b"\0")


def test_object_end_is_fine_at_the_end(brick: Brick) -> None:
    assert run(brick, op("MOVE8_8", 1, GV(0)), op("OBJECT_END"), globals=1) == (OK, b"\x01")


@pytest.mark.parametrize(
    "without_effect",
    [
        op("SLEEP"),
        op("NOP"),
        op("OBJECT_START", 7),
        op("OBJECT_STOP", 7),
        op("OBJECT_START", 1),
        op("OBJECT_TRIG", 1),
        op("BP3"),
        op("LABEL", 3),
        op("BP_SET", 1, 0, 0),
        op("PROBE", 2, 0, 0, 0),
        op("PROGRAM_STOP", 1),
        op("PROGRAM_START", 1, 0, 0, 0),
    ],
)
def test_operations_without_an_effect(brick: Brick, without_effect: bytes) -> None:
    assert run(brick, without_effect, op("MOVE8_8", 1, GV(0)), globals=1) == (OK, b"\x01")


@pytest.mark.parametrize("name", ["RETURN", "OBJECT_TRIG", "OBJECT_WAIT", "CALL"])
def test_operations_that_would_crash_the_machine_fail(brick: Brick, name: str) -> None:
    values: dict[str, tuple[object, ...]] = {"RETURN": (), "CALL": (7, [])}
    assert run(brick, op(name, *values.get(name, (7,))))[0] == FAIL


def test_waiting_for_itself_waits_for_ever(brick: Brick) -> None:
    assert brick.receive(command(op("OBJECT_WAIT", 1))) == []
    assert brick.advance(5) == []


# Parameters


def test_a_constant_is_read_in_the_type_of_the_parameter(brick: Brick) -> None:
    assert run(brick, bytes.fromhex("34 82 2C 01 60"), globals=1) == (OK, bytes((44 + 83,)))  # clamped: 300 as 16 bits
    # After a first parameter that passes, a 16-bit 300 as DATA8 is 44.
    assert run(brick, bytes.fromhex("10 00 82 2C 01 60"), globals=1) == (OK, bytes((44,)))


def test_a_short_constant_as_a_float_is_its_bits(brick: Brick) -> None:
    assert run(brick, bytes.fromhex("3F 01 60"), globals=4) == (OK, bytes((1, 0, 0, 0)))


def test_an_output_that_is_a_constant_is_dropped(brick: Brick) -> None:
    assert run(brick, bytes.fromhex("10 01 02 05"), op("MOVE8_8", 3, GV(0)), globals=1) == (OK, b"\x03")
    text = bytes.fromhex("7D 05 84") + b"longer than any number\0" + bytes((5,))
    assert run(brick, text, op("MOVE8_8", 4, GV(0)), globals=1) == (OK, b"\x04")


def test_variables_beyond_what_the_header_asks_for_are_there_within_the_buffer(brick: Brick) -> None:
    assert run(brick, op("MOVE8_8", 7, GV(200)), op("MOVE8_8", GV(200), GV(0)), globals=4)[1][0] == 7


def test_variables_beyond_the_buffer_fail(brick: Brick) -> None:
    assert run(brick, op("MOVE8_8", 7, GV(1020)))[0] == OK
    assert run(brick, op("MOVE8_8", 7, GV(1021)))[0] == FAIL
    assert run(brick, op("MOVE32_32", 7, LV(4000)))[0] == FAIL


def test_a_handle_is_the_first_element_of_its_array(brick: Brick) -> None:
    found = run(
        brick,
        op("ARRAY.CREATE8", 2, LV(0)),
        op("ARRAY_WRITE", LV(0), 0, 42),
        op("MOVE8_8", LV(0, handle=True), GV(0)),
        op("MOVE8_8", 43, LV(0, handle=True)),
        op("ARRAY_READ", LV(0), 0, GV(1)),
        globals=2,
        locals=2,
    )
    assert found == (OK, bytes((42, 43)))


def test_an_unknown_handle_is_the_place_of_the_handle_itself(brick: Brick) -> None:
    code = op("MOVE16_16", 77, LV(0)), op("MOVE8_8", LV(0, handle=True), GV(0))
    assert run(brick, *code, globals=1, locals=2) == (OK, b"\x4d")


def test_an_address_fails(brick: Brick) -> None:
    assert run(brick, op("MOVE8_8", LV(0, address=True), GV(0)), globals=1, locals=4)[0] == FAIL


def test_labels_are_distances_before_and_behind_the_jump(brick: Brick) -> None:
    forward = bytes.fromhex("40 A0 01"), op("MOVE8_8", 1, GV(0)), op("LABEL", 1), op("MOVE8_8", 2, GV(1))
    assert run(brick, *forward, globals=2) == (OK, bytes((0, 2)))
    backward = (
        op("MOVE8_8", 0, GV(0)),
        op("LABEL", 2),
        op("ADD8", GV(0), 1, GV(0)),
        bytes.fromhex("64 60 05 A0 02"),  # JR_LT8 GV0, 5, label 2
    )
    assert run(brick, *backward, globals=1) == (OK, b"\x05")


def test_label_0_is_the_number_0_and_one_that_is_nowhere_set_fails(brick: Brick) -> None:
    assert run(brick, bytes.fromhex("40 A0 00"), op("MOVE8_8", 1, GV(0)), globals=1) == (OK, b"\x01")
    assert run(brick, bytes.fromhex("40 A0 09"), op("MOVE8_8", 1, GV(0)), globals=1)[0] == FAIL


def test_a_label_constant_beyond_the_labels_is_a_short_jump(brick: Brick) -> None:
    backward = op("ADD8", GV(0), 1, GV(0)), bytes.fromhex("64 60 05 A0 F7")  # JR_LT8 GV0, 5, -9
    assert run(brick, op("MOVE8_8", 0, GV(0)), *backward, globals=1) == (OK, b"\x05")


# Time


def test_a_busy_command_is_answered_when_it_is_done(brick: Brick) -> None:
    wait = command(op("TIMER_WAIT", 120, LV(0)), op("TIMER_READY", LV(0)), locals=4)
    assert brick.receive(wait) == []
    assert brick.advance(0.119) == []
    assert brick.advance(0.011) == [bytes.fromhex("03 00 01 00 02")]


def test_frames_that_come_meanwhile_are_served_afterwards_in_order(brick: Brick) -> None:
    wait = command(op("TIMER_WAIT", 50, LV(0)), op("TIMER_READY", LV(0)), locals=4, counter=1)
    assert brick.receive(wait) == []
    assert brick.receive(command(op("NOP"), counter=2)) == []
    assert brick.receive(bytes.fromhex("04 00 03 00 01 9D")) == []
    assert [reply[2] for reply in brick.advance(0.1)] == [1, 2, 3]


def test_replies_go_to_the_connections_that_they_belong_to(brick: Brick) -> None:
    wait = command(op("TIMER_WAIT", 50, LV(0)), op("TIMER_READY", LV(0)), locals=4)
    assert brick.receive_from("a", wait) == []
    assert brick.receive_from("b", command(op("NOP"), counter=2)) == []
    assert [(reply.channel, reply.frame[2]) for reply in brick.advance_all(0.1)] == [("a", 1), ("b", 2)]


def test_a_command_runs_on_when_its_client_has_gone(brick: Brick) -> None:
    """Then the light turns red and the next client is served; the first one has gone."""
    wait = (op("TIMER_WAIT", 50, LV(0)), op("TIMER_READY", LV(0)), op("UI_WRITE.LED", 2))
    assert brick.receive_from("a", command(*wait, locals=4)) == []
    assert brick.receive_from("b", command(op("NOP"), counter=2)) == []
    assert brick.disconnect("a") == []
    assert [reply.channel for reply in brick.advance_all(0.1)] == ["b"]
    assert brick.leds == 2


def test_an_endless_loop_is_ended_and_fails(brick: Brick, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.brick.MOST_OPERATIONS", 10_000)
    assert run(brick, op("JR", -2))[0] == FAIL
    assert run(brick, op("SLEEP"), op("JR", -3))[0] == FAIL


def test_a_command_that_waits_too_long_is_ended_and_fails(brick: Brick, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.brick.MOST_SECONDS", 2)
    assert brick.receive(command(op("OBJECT_WAIT", 1))) == []
    assert brick.advance(1.9) == []
    assert [taken_apart(reply)[0] for reply in brick.advance(0.2)] == [FAIL]


def test_a_loop_of_100_000_rounds_is_done_at_once(brick: Brick) -> None:
    loop = (
        op("MOVE32_32", 0, LV(0)),
        op("ADD32", LV(0), 1, LV(0)),
        bytes.fromhex("66 40 83 A0 86 01 00 81 F3"),  # JR_LT32 LV0, 100000, -13
        op("MOVE32_32", LV(0), GV(0)),
    )
    assert run(brick, *loop, globals=4, locals=4) == (OK, (100_000).to_bytes(4, "little"))


def test_stopping_all_slots_leaves_a_dead_brick(brick: Brick) -> None:
    assert brick.receive(command(op("PROGRAM_STOP", 0))) == []
    assert brick.receive(command(op("NOP"))) == []
    assert brick.advance(1) == []


def test_states_of_the_slots_seen_from_a_direct_command(brick: Brick) -> None:
    code = [
        *(op("PROGRAM_INFO.GET_STATUS", slot, GV(slot)) for slot in range(5)),
        *(op("PROGRAM_INFO.GET_PRGRESULT", slot, GV(slot + 5)) for slot in range(1, 5)),
    ]
    assert run(brick, *code, globals=10) == (OK, bytes((0x10, 0x40, 0x10, 0x40, 0x40, 0, 0, 1, 0, 0)))


def test_an_instruction_count_eats_the_bytes_behind_it(brick: Brick) -> None:
    # SET_INSTR has one parameter in the tables, and the machine reads two: MOVE8_8 1, GV0 is no more whole.
    code = op("PROGRAM_INFO.SET_INSTR", 2), bytes.fromhex("01"), op("MOVE8_8", 4, GV(0))
    assert run(brick, *code, globals=1) == (OK, b"\x04")


def test_a_shell_command_is_never_run(brick: Brick, tmp_path: object) -> None:
    found = run(brick, op("SYSTEM", f"touch {tmp_path}/made", GV(0)), globals=4)
    assert found == (OK, b"\xff\xff\xff\xff")


def test_a_wait_of_minutes_is_not_endless(brick: Brick) -> None:
    wait = command(op("TIMER_WAIT", 120_000, LV(0)), op("TIMER_READY", LV(0)), locals=4)
    assert brick.receive(wait) == []
    assert brick.advance(119) == []
    assert brick.spent == 0
    assert [taken_apart(reply)[0] for reply in brick.advance(2)] == [OK]

"""Mailboxes, information about the brick, and programs that run on the virtual brick."""

from __future__ import annotations

import struct
from pathlib import Path
from time import monotonic

import pytest
from support.bricks import FAIL, OK, command, op, run
from support.server import Client, served

from ev3proto import system
from ev3proto.brick import Brick
from ev3proto.brick.servers.server import Options
from ev3proto.messages import GV, LV

BLINK = bytes.fromhex(
    "4C45474F 65000000 6D00 0200 08000000"
    "28000000 0000 0000 0A000000"
    "51000000 0000 0100 10000000"
    "300060 821B02 8582F40140 8640 10600160"
    "64600282ECFF 09020280646F6E65270064 7D0580780044 0A"
    "02840843 358280FF4E 3F0048 840501044E40 080A"
)
"""Two rounds of half a second, a subcall that draws a text, in a thread and a subcall."""


def image(*objects: tuple[int, int, int, bytes], globals: int = 0) -> bytes:
    """An image of objects: owner, triggers, bytes of locals, code."""
    at = 16 + 12 * len(objects)
    table, codes = b"", b""
    for owner, triggers, locals_, code in objects:
        table += struct.pack("<IHHI", at + len(codes), owner, triggers, locals_)
        codes += code
    size = at + len(codes)
    return b"LEGO" + struct.pack("<IHHI", size, 0x68, len(objects), globals) + table + codes


def start(brick: Brick, data: bytes, name: str = "../prjs/Test/test.rbf") -> None:
    """Downloads an image and starts it in the user's slot."""
    for message in system.download(name, data):
        assert brick.receive(message.build())[0][4] == 3
    kind, memory = run(
        brick,
        op("FILE.LOAD_IMAGE", 1, name.removesuffix(".rbf"), GV(0), GV(4)),
        op("PROGRAM_START", 1, GV(0), GV(4), 0),
        globals=8,
    )
    assert (kind, memory[:4]) == (OK, len(data).to_bytes(4, "little"))


def state(brick: Brick) -> tuple[int, int]:
    """Status and result of the user's slot, as a direct command reads them."""
    code = op("PROGRAM_INFO.GET_STATUS", 1, GV(0)), op("PROGRAM_INFO.GET_PRGRESULT", 1, GV(1))
    return tuple(run(brick, *code, globals=2)[1])  # type: ignore[return-value]


def globals_of(brick: Brick, count: int) -> bytes:
    """The first global variables of the user's program, as a direct command reads them."""
    brick.receive(command(op("INIT_BYTES", GV(0), count, [0] * count), reply=False))
    return run(brick, op("MEMORY_READ", 1, 0, 0, count, GV(0)), globals=count)[1]


RUNNING, STOPPED = 0x10, 0x40


SLOW = op("NOP") * 20 + op("UI_DRAW.LINE", 1, -16000, -100, 16000, 128) * 25 + op("UI_DRAW.CIRCLE", 1, 0, 0, 30000) * 5


def endless(objects: int, code: bytes = SLOW) -> bytes:
    """A program of many objects, each of which draws what takes long, for ever."""
    starts = b"".join(op("OBJECT_START", number) for number in range(2, objects + 2))
    loop = code + b"\x40\x82" + struct.pack("<h", -len(code) - 4)
    return image((0, 0, 0, starts + b"\x0a"), *[(0, 0, 0, loop + b"\x0a")] * objects)


def test_a_turn_counts_the_operations_that_it_has_executed(brick: Brick) -> None:
    start(brick, image((0, 0, 0, op("NOP") * 250 + op("TIMER_READY", 1000) + op("NOP") * 5 + b"\x0a")))
    program = brick.machine.slots[1]
    assert program is not None
    program.executed = 0
    program.objects[1].reset()
    assert brick.machine.turn(program, 200) == (200, False)
    assert brick.machine.turn(program, 200) == (51, True)  # it waits at TIMER_READY
    assert brick.machine.turn(program, 200) == (1, True)
    brick.advance(1.0)
    assert program.status == STOPPED
    program.executed = 0
    program.objects[1].start()
    program.status = RUNNING
    assert brick.machine.turn(program, 7) == (7, False)
    assert program.executed == 7


def test_slow_programs_keep_no_client_waiting(tmp_path: Path) -> None:
    with served(tmp_path, Options(port=0, beacon=False)) as brick, Client(brick.port) as client:
        for message in system.download("../prjs/T/t.rbf", endless(30)):
            client.ask(message.build())
        load = op("FILE.LOAD_IMAGE", 1, "../prjs/T/t", GV(0), GV(4)) + op("PROGRAM_START", 1, GV(0), GV(4), 0)
        client.ask(command(load, globals=8))
        begin = monotonic()
        for _ in range(5):
            assert client.ask(command(op("NOP"))) == bytes.fromhex("0300010002")
        # A turn of each object would take 20 s.
        assert monotonic() - begin < 15
        begin = monotonic()
    assert monotonic() - begin < 15


def test_turns_are_the_same_with_a_budget(tmp_path: Path) -> None:
    """A turn that was interrupted goes on later: the objects take their turns in the same order."""
    starts = op("OBJECT_START", 2) + op("OBJECT_START", 3)
    counts = [(op("MUL32", GV(0), factor, GV(0)) + op("ADD32", GV(0), 1, GV(0))) * 160 for factor in (3, 5)]
    program = image((0, 0, 0, starts + b"\x0a"), *[(0, 0, 0, count + b"\x0a") for count in counts], globals=4)
    results = []
    for stretch in (None, 0.02, 0.0):
        brick = Brick(tmp_path, stretch=stretch)
        ended = brick.start(program)
        assert ended is not None
        for _ in range(2000):
            brick.advance(0.001)
        results.append((ended.status, ended.executed, bytes(ended.global_memory[:4])))
    # Two starts and an end, then 320 operations and an end twice.
    assert results[0][:2] == (STOPPED, 645)
    assert results == [results[0]] * 3


def test_a_program_with_a_subcall_runs_to_its_end(brick: Brick) -> None:
    start(brick, BLINK)
    assert state(brick) == (RUNNING, 1)
    brick.advance(0.9)
    assert brick.leds == 2
    assert state(brick) == (RUNNING, 1)
    brick.advance(0.2)
    assert state(brick) == (STOPPED, 0)
    assert brick.leds == 1
    assert run(brick, op("INFO.GET_ERROR", GV(0)), globals=1) == (OK, b"\0")


def test_a_second_program_is_not_started_while_one_runs(brick: Brick) -> None:
    start(brick, image((0, 0, 0, bytes.fromhex("40 3E"))))
    address = op("FILE.LOAD_IMAGE", 1, "../prjs/Test/test", GV(0), GV(4))
    found = run(brick, op("INIT_BYTES", GV(0), 8, [9] * 8), address, globals=8)
    assert found == (OK, b"\x09" * 8)
    brick.advance(0.01)
    assert state(brick) == (RUNNING, 1)
    assert run(brick, op("PROGRAM_STOP", 1))[0] == OK
    assert state(brick) == (STOPPED, 0)


def test_a_user_program_is_stopped_by_the_back_button(brick: Brick) -> None:
    start(brick, image((0, 0, 0, bytes.fromhex("40 3E"))))
    brick.advance(0.1)
    brick.press("back")
    brick.advance(0.1)
    assert state(brick)[0] == STOPPED


def test_threads_take_turns_and_wait_for_each_other(brick: Brick) -> None:
    first = op("OBJECT_START", 2) + op("OBJECT_WAIT", 2) + op("MOVE8_8", GV(0), GV(1)) + op("OBJECT_END")
    second = op("SLEEP") + op("MOVE8_8", 7, GV(0)) + op("TIMER_WAIT", 20, LV(0)) + op("TIMER_READY", LV(0))
    last = op("JR", -2)
    start(brick, image((0, 0, 0, first[:-1] + last), (0, 0, 4, second + op("OBJECT_END")), globals=2))
    brick.advance(0.015)
    assert globals_of(brick, 2) == bytes((7, 0))
    brick.advance(0.02)
    assert globals_of(brick, 2) == bytes((7, 7))


def test_a_block_runs_in_its_owners_memory_when_it_has_all_its_triggers(brick: Brick) -> None:
    thread = (
        op("MOVE8_8", 5, LV(0))
        + op("OBJECT_TRIG", 2)
        + op("TIMER_WAIT", 10, LV(4))
        + op("TIMER_READY", LV(4))
        + op("OBJECT_TRIG", 2)
        + op("OBJECT_WAIT", 2)
        + op("JR", -2)
    )
    block = op("MOVE8_8", LV(0), GV(0)) + op("OBJECT_END")
    start(brick, image((0, 0, 8, thread), (1, 2, 8, block), globals=1))
    brick.advance(0.005)
    assert globals_of(brick, 1) == b"\0"
    brick.advance(0.02)
    assert globals_of(brick, 1) == b"\x05"


def test_parameters_go_to_a_subcall_and_come_back(brick: Brick) -> None:
    # IN_8 at 0, IN_16 at 2, IO_32 at 4, OUT_F at 8, IN_S 6 at 12, OUT_S 6 at 18
    table = bytes((6, 0x80, 0x81, 0xC2, 0x43, 0x84, 6, 0x44, 6))
    body = (
        op("MOVE8_32", LV(0), LV(24))
        + op("ADD32", LV(4), LV(24), LV(4))
        + op("MOVE16_F", LV(2), LV(8))
        + op("STRINGS.DUPLICATE", LV(12), LV(18))
        + op("RETURN")
        + op("OBJECT_END")
    )
    call = (
        op("MOVE32_32", 1000, GV(0))
        + bytes.fromhex("09 02 06 05 81 2A 60 64 80")  # CALL 2: 5, 42, GV0, GV4, text, GV8
        + b"longer\0"
        + bytes.fromhex("68")
        + op("JR", -2)
        + op("OBJECT_END")
    )
    start(brick, image((0, 0, 0, call), (0, 1, 28, table + body), globals=16))
    brick.advance(0.01)
    memory = globals_of(brick, 16)
    assert memory[:4] == (1005).to_bytes(4, "little")
    assert memory[4:8] == struct.pack("<f", 42.0)
    assert memory[8:14] == b"longe\0"


def test_names_without_a_folder_are_looked_up_where_the_program_came_from(brick: Brick, tmp_path: Path) -> None:
    code = op("FILE.OPEN_WRITE", "note.rtf", LV(0)) + op("FILE.WRITE_TEXT", LV(0), 0, "here") + op("OBJECT_END")
    start(brick, image((0, 0, 2, code)))
    brick.advance(0.01)
    assert (tmp_path / "prjs" / "Test" / "note.rtf").read_bytes() == b"here"


def test_a_program_that_fails_says_so_in_the_log(brick: Brick) -> None:
    start(brick, image((0, 0, 2, op("FILE.CLOSE", 9) + op("OBJECT_END"))))
    brick.advance(0.01)
    assert state(brick) == (STOPPED, 2)
    found = run(brick, op("INFO.GET_ERROR", GV(0)), op("INFO.GET_ERROR", GV(1)), globals=2)
    assert found == (OK, bytes((29, 21)))


@pytest.mark.parametrize("data", [b"LEGO", b"none at all, but long enough", BLINK[:-9], BLINK[:12] + b"\xff" * 28])
def test_damaged_images_are_not_started(brick: Brick, data: bytes) -> None:
    start(brick, data)
    assert state(brick)[0] == STOPPED


def test_images_that_the_validator_accepts_are_loaded(brick: Brick) -> None:
    """An unknown CMD is accepted, and does nothing; bytes after the last object are ignored."""
    code = bytes.fromhex("8D 1F") + op("MOVE8_8", 7, GV(0)) + op("JR", -2)
    start(brick, image((0, 0, 0, code + op("OBJECT_END")), globals=1) + b"more")
    brick.advance(0.01)
    assert globals_of(brick, 1) == b"\x07"


def test_an_unknown_address_does_nothing(brick: Brick) -> None:
    assert run(brick, op("PROGRAM_START", 1, 100, 12345, 0))[0] == OK
    assert state(brick) == (STOPPED, 0)


def test_objects_of_a_program_are_stopped_and_started_from_outside(brick: Brick) -> None:
    count = op("ADD8", GV(0), 1, GV(0)) + op("TIMER_WAIT", 10, LV(0)) + op("TIMER_READY", LV(0)) + op("JR", -11)
    start(brick, image((0, 0, 4, op("JR", -2)), (0, 0, 4, count), globals=1))
    brick.advance(0.05)
    assert globals_of(brick, 1) == b"\0"
    run(brick, op("PROGRAM_INFO.OBJ_START", 1, 2))
    brick.advance(0.055)
    before = globals_of(brick, 1)[0]
    assert before > 3
    run(brick, op("PROGRAM_INFO.OBJ_STOP", 1, 2))
    brick.advance(0.05)
    assert globals_of(brick, 1)[0] == before


# Mailboxes


def write_mailbox(brick: Brick, name: str, payload: bytes) -> None:
    assert brick.receive(system.writemailbox(name=name, payload=payload).build()) == []


def test_a_message_is_read_by_the_box_of_its_name(brick: Brick) -> None:
    run(brick, op("MAILBOX_OPEN", 3, "abc", "DATA_F", 0, 0))
    assert run(brick, op("MAILBOX_TEST", 3, GV(0)), globals=1) == (OK, b"\x01")
    write_mailbox(brick, "ABC", bytes(4))
    assert run(brick, op("MAILBOX_TEST", 3, GV(0)), globals=1) == (OK, b"\x01")
    write_mailbox(brick, "abc", struct.pack("<ff", 1.5, 2.5))
    assert run(brick, op("MAILBOX_TEST", 3, GV(0)), globals=1) == (OK, b"\0")
    code = op("MAILBOX_READ", 3, 4, [GV(0), GV(4)])
    assert run(brick, code, globals=8) == (OK, struct.pack("<ff", 1.5, 2.5))
    assert run(brick, op("MAILBOX_TEST", 3, GV(0)), globals=1) == (OK, b"\x01")
    assert run(brick, code, globals=8) == (OK, struct.pack("<ff", 1.5, 2.5))


def test_of_two_messages_only_the_second_can_be_read(brick: Brick) -> None:
    run(brick, op("MAILBOX_OPEN", 0, "abc", "DATA_S", 0, 0))
    write_mailbox(brick, "abc", b"first\0")
    write_mailbox(brick, "abc", b"second\0")
    read = op("MAILBOX_READ", 0, 20, [GV(0)]), op("MAILBOX_TEST", 0, GV(10))
    assert run(brick, *read, globals=11) == (OK, b"second\0\0\0\0\0")
    assert run(brick, *read, globals=11) == (OK, b"second\0\0\0\0\x01")


def test_an_open_box_cannot_be_opened_and_a_closed_one_still_gets_messages(brick: Brick) -> None:
    box = op("MAILBOX_OPEN", 1, "abc", "DATA_8", 0, 0)
    assert run(brick, box)[0] == OK
    assert run(brick, box)[0] == FAIL
    run(brick, op("MAILBOX_CLOSE", 1))
    write_mailbox(brick, "abc", b"\x07")
    assert run(brick, op("MAILBOX_TEST", 1, GV(0)), globals=1) == (OK, b"\0")
    # The bytes after the number of values are skipped: this brick does not execute them.
    skipped = op("MOVE8_8", 9, GV(0)), op("MAILBOX_READ", 1, 4, [GV(0)])
    assert run(brick, *skipped, globals=1) == (OK, b"\x09")
    assert run(brick, box, op("MAILBOX_TEST", 1, GV(0)), globals=1) == (OK, b"\x01")


def test_the_first_of_two_boxes_of_one_name_gets_the_message(brick: Brick) -> None:
    run(brick, *(op("MAILBOX_OPEN", number, "abc", "DATA_8", 0, 0) for number in (4, 2)))
    write_mailbox(brick, "abc", b"\x07")
    found = run(brick, op("MAILBOX_TEST", 2, GV(0)), op("MAILBOX_TEST", 4, GV(1)), globals=2)
    assert found == (OK, bytes((0, 1)))


def test_waiting_for_a_message(brick: Brick) -> None:
    run(brick, op("MAILBOX_OPEN", 0, "abc", "DATA_8", 0, 0))
    assert brick.receive(command(op("MAILBOX_READY", 0))) == []
    # The message waits as well: the brick does not read while a direct command runs.
    assert brick.receive(system.writemailbox(name="abc", payload=b"\x07").build()) == []
    assert brick.advance(1) == []


def test_names_are_cut_and_numbers_checked(brick: Brick) -> None:
    run(brick, op("MAILBOX_OPEN", 0, "n" * 60, "DATA_8", 0, 0))
    write_mailbox(brick, "n" * 49, b"\x01")
    assert run(brick, op("MAILBOX_TEST", 0, GV(0)), globals=1) == (OK, b"\0")
    assert run(brick, op("MAILBOX_TEST", 30, GV(0)), globals=1)[0] == FAIL
    assert run(brick, op("MAILBOX_TEST", -1, GV(0)), globals=1)[0] == FAIL


def test_sending_without_a_receiver_succeeds(brick: Brick) -> None:
    assert run(brick, op("MAILBOX_WRITE", "", 2, "abc", "DATA_8", [1]))[0] == OK


# What the brick says of itself


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        (op("COM_GET.GET_BRICKNAME", 20, GV(0)), (OK, b"EV3")),
        (op("COM_GET.GET_BRICKNAME", 3, GV(0)), (OK, b"EV")),
        (op("COM_GET.GET_PIN", 2, "any", 20, GV(0)), (OK, b"1234")),
        (op("COM_GET.GET_ID", 2, 14, GV(0)), (OK, b"0016530f0c1e")),
        (op("COM_GET.GET_ID", 1, 14, GV(0)), (FAIL, b"")),
        (op("COM_GET.GET_ID", 3, 14, GV(0)), (FAIL, b"")),
        (op("COM_GET.GET_NETWORK", 3, 16, GV(0), GV(20), GV(40)), (OK, b"NONE")),
        (op("COM_GET.GET_NETWORK", 2, 16, GV(0), GV(20), GV(40)), (OK, b"")),
        (op("COM_GET.GET_PRESENT", 1, GV(0)), (OK, b"\x01")),
        (op("COM_GET.GET_PRESENT", 2, GV(0)), (OK, b"\x01")),
        (op("COM_GET.GET_ON_OFF", 1, GV(0)), (FAIL, b"")),
        (op("COM_GET.SEARCH_ITEMS", 1, GV(0)), (FAIL, b"")),
        (op("COM_GET.FAVOUR_ITEMS", 1, GV(0)), (FAIL, b"")),
        (op("COM_GET.CONNEC_ITEMS", 1, GV(0)), (OK, b"")),
        (op("COM_GET.GET_RESULT", 1, 0, GV(0)), (FAIL, b"")),
        (op("COM_GET.GET_RESULT", 2, 0, GV(0)), (OK, b"")),
        (op("COM_GET.GET_MODE2", 3, GV(0)), (FAIL, b"")),
        (op("COM_TEST", 2, "", GV(0)), (OK, b"")),
        (op("COM_READY", 2, ""), (OK, b"")),
    ],
)
def test_com_get(brick: Brick, code: bytes, expected: tuple[int, bytes]) -> None:
    kind, memory = run(brick, code, globals=60)
    assert (kind, memory.partition(b"\0")[0]) == expected


def test_switches_are_remembered(brick: Brick) -> None:
    code = (
        op("COM_SET.SET_ON_OFF", 2, 0),
        op("COM_SET.SET_VISIBLE", 2, 0),
        op("COM_SET.SET_ON_OFF", 3, 1),
        op("COM_GET.GET_ON_OFF", 2, GV(0)),
        op("COM_GET.GET_VISIBLE", 1, GV(1)),
        op("COM_GET.GET_ON_OFF", 3, GV(2)),
    )
    assert run(brick, *code, globals=3) == (OK, bytes((0, 0, 1)))


@pytest.mark.parametrize(
    ("name", "kind", "then"),
    [
        ("my-EV3_1", OK, "my-EV3_1"),
        ("", OK, ""),
        ("my EV3", FAIL, "EV3"),
        ("n" * 118, OK, "n" * 118),
        ("n" * 119, FAIL, "EV3"),
    ],
)
def test_renaming_the_brick(brick: Brick, name: str, kind: int, then: str) -> None:
    assert run(brick, op("COM_SET.SET_BRICKNAME", name))[0] == kind
    assert brick.equipment.settings.name == then


def test_forbidden_characters_are_replaced_in_the_callers_own_text(brick: Brick) -> None:
    code = op("STRINGS.DUPLICATE", "a b", GV(0)), op("COM_SET.SET_BRICKNAME", GV(0))
    assert run(brick, *code, globals=4) == (FAIL, b"a_b\0")


@pytest.mark.parametrize(
    ("code", "memory"),
    [
        (op("COM_GET.GET_RESULT", 1, 0, GV(0)), b"\0"),
        (op("COM_GET.SEARCH_ITEMS", 1, GV(0)), b"\0"),
        (op("COM_GET.FAVOUR_ITEMS", 3, GV(0)), b"\0"),
        (op("COM_GET.CONNEC_ITEMS", 0, GV(0)), b"\0"),
        (op("COM_GET.GET_MODE2", 3, GV(0)), b"\0"),
        (op("COM_GET.GET_ENCRYPT", 2, 0, GV(0)), b"\0"),
        (op("COM_GET.GET_INCOMING", 3, 4, GV(0), GV(1)), b"\x09"),
        (op("COM_SET.SET_MOVEUP", 2, 0), b"\x09"),
        (op("COM_SET.SET_PASSKEY", 3, 0), b"\x09"),
    ],
)
def test_hardware_without_a_property_answers_0_and_fails(brick: Brick, code: bytes, memory: bytes) -> None:
    brick.receive(command(op("MOVE8_8", 9, GV(0)), reply=False))
    assert run(brick, code, globals=1) == (FAIL, memory)


def test_visibility_of_other_hardware_does_not_fail(brick: Brick) -> None:
    assert run(brick, op("COM_SET.SET_VISIBLE", 1, 1))[0] == OK


def test_addresses_are_not_cut(brick: Brick) -> None:
    code = op("COM_GET.GET_NETWORK", 3, 2, GV(0), GV(4), GV(8))
    assert run(brick, code, globals=12) == (OK, b"N\0\0\0??\0\0??\0\0")


def test_an_array_gets_the_length_that_was_asked_for(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 1, LV(0)),
        op("COM_GET.GET_BRICKNAME", 50, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(0)),
        op("COM_GET.GET_BRICKNAME", -1, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(4)),
    )
    assert run(brick, *code, globals=8, locals=2) == (OK, bytes((50, 0, 0, 0, 120, 0, 0, 0)))


def test_every_text_of_a_mailbox_is_the_first(brick: Brick) -> None:
    run(brick, op("MAILBOX_OPEN", 0, "abc", "DATA_S", 0, 0))
    brick.receive(system.writemailbox("abc", b"one\0two\0", reply=False).build())
    assert run(brick, op("MAILBOX_READ", 0, 20, [GV(0), GV(4)]), globals=8) == (OK, b"one\0one\0")


def test_a_mailbox_of_an_array_fills_the_array_that_a_value_names(brick: Brick) -> None:
    run(brick, op("MAILBOX_OPEN", 0, "abc", "DATA_A", 0, 0))
    brick.receive(system.writemailbox("abc", bytes((5, 6, 7)), reply=False).build())
    code = (
        op("ARRAY.CREATE8", 1, LV(0)),
        op("MAILBOX_READ", 0, 20, [LV(0)]),
        op("ARRAY.SIZE", LV(0), GV(0)),
        op("ARRAY.READ_CONTENT", -1, LV(0), 0, 3, GV(4)),
    )
    assert run(brick, *code, globals=7, locals=2) == (OK, bytes((3, 0, 0, 0, 5, 6, 7)))

"""EV3 and AsyncEV3, against a virtual brick on a socket, and against one that misbehaves."""

from __future__ import annotations

import asyncio
import hashlib
import logging
import re
import socket
import struct
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from support.effort import effort
from support.full_disk import full_disk
from support.server import served
from support.stub_brick import HangUp, reply, stub_brick

import ev3proto
from ev3proto import EV3, AsyncEV3, ops, system
from ev3proto.link.printing import meaning_line
from ev3proto.semantics.transfers import File, Listing

NOP = ev3proto.opNop


@pytest.fixture
def port(tmp_path: Path) -> Iterator[int]:
    with served(tmp_path / "brick") as brick:
        yield brick.port


@pytest.fixture
def my_ev3(port: int) -> Iterator[EV3]:
    with EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port)) as connected:
        yield connected


def stubbed(port: int, **arguments: Any) -> EV3:
    return EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port), **{"timeout": 30.0, **arguments})


def echo(number: int) -> bytes:
    """Byte code that writes a number to global memory."""
    return b"".join([ev3proto.opMove32_32, ev3proto.LC4(number), ev3proto.GVX(0)])


# Results, as ev3_dc has them


def test_std_waits_where_there_is_global_memory(my_ev3: EV3) -> None:
    assert my_ev3.send_direct_cmd(NOP) == b"\x2a\x00"
    assert my_ev3.send_direct_cmd(echo(7), global_mem=4) == b"\x07\0\0\0"


def test_sync_waits_always(my_ev3: EV3) -> None:
    my_ev3.sync_mode = ev3proto.SYNC
    assert my_ev3.send_direct_cmd(NOP) == b""


def test_async_waits_when_it_is_asked_to(my_ev3: EV3) -> None:
    my_ev3.sync_mode = ev3proto.ASYNC
    first = my_ev3.send_direct_cmd(echo(1), global_mem=4)
    second = my_ev3.send_direct_cmd(echo(2), global_mem=4)
    assert isinstance(first, bytes)
    assert my_ev3.wait_for_reply(second) == b"\x02\0\0\0"
    assert my_ev3.wait_for_reply(first) == b"\x01\0\0\0"
    with pytest.raises(ev3proto.LinkError, match="no command with the counter 42 waits for its reply"):
        my_ev3.wait_for_reply(first)


def test_a_whole_frame_is_not_sent_as_operations(my_ev3: EV3) -> None:
    frame = bytes.fromhex("0800 2a00 00 0100 8112 60")
    with pytest.raises(ValueError, match=r"^these bytes are a whole frame, with length and counter; expected only its"):
        my_ev3.send_direct_cmd(frame, global_mem=1)
    message = ev3proto.parse(frame)
    assert isinstance(message, ev3proto.DirectCommand)
    (value,) = my_ev3.send_direct_cmd(message)
    assert value.name == "PCT"
    for almost in (frame + NOP, bytes.fromhex("0900") + frame[2:], bytes.fromhex("0700 2a00 00 0100 81 60")):
        with pytest.raises(ev3proto.DirCmdError):
            my_ev3.send_direct_cmd(almost, global_mem=1)


def test_system_commands_in_bytes(my_ev3: EV3) -> None:
    assert my_ev3.send_system_cmd(ev3proto.CREATE_DIR + b"/home/root/lms2012/prjs/a\0") == b"\0"
    with pytest.raises(ev3proto.SysCmdError, match="CREATE_DIR with NO_PERMISSION: it cannot be created: it exists,"):
        my_ev3.send_system_cmd(ev3proto.CREATE_DIR + b"/home/root/lms2012/prjs/a\0")
    assert my_ev3.send_system_cmd(ev3proto.CREATE_DIR + b"/home/root/lms2012/prjs/b\0", reply=False) == b"\x2c\0"


def test_operations_give_named_values(my_ev3: EV3) -> None:
    values = my_ev3.send_direct_cmd([ops.info.get_volume(), ops.ui_read.get_fw_vers(16)])
    assert [(value.command, value.name, value.value) for value in values] == [
        ("GET_VOLUME", "VALUE", 100),
        ("GET_FW_VERS", "DESTINATION", "V1.04H"),
    ]
    assert my_ev3.send_direct_cmd(ops.sound.break_()) == b"\x2b\0"
    assert my_ev3.send_direct_cmd(ops.sound.break_(), sync_mode=ev3proto.SYNC) == []


def test_operations_can_be_waited_for(my_ev3: EV3) -> None:
    counter = my_ev3.send_direct_cmd(ops.info.get_volume(), sync_mode=ev3proto.ASYNC)
    assert isinstance(counter, bytes)
    (value,) = my_ev3.wait_for_reply(counter)
    assert value.value == 100


def test_messages_give_named_values(my_ev3: EV3) -> None:
    (value,) = my_ev3.send_direct_cmd(ev3proto.command(ops.info.get_volume()))
    assert value.value == 100
    values = my_ev3.send_system_cmd(system.begin_download("../prjs/a.txt", 3))
    assert [(value.name, value.value) for value in values] == [("handle", 0)]


def test_frames_are_printed_as_the_lessons_show_them(my_ev3: EV3, capsys: pytest.CaptureFixture[str]) -> None:
    my_ev3.verbosity = 1
    my_ev3.send_direct_cmd(echo(7), global_mem=4)
    my_ev3.send_system_cmd(ev3proto.LIST_OPEN_HANDLES)
    my_ev3.send_direct_cmd(NOP, verbosity=0)
    my_ev3.send_direct_cmd(ops.info.get_volume(), verbosity=2)
    lines = [re.sub(r"^\d\d:\d\d:\d\d\.\d{6} ", "", line) for line in capsys.readouterr().out.splitlines()]
    assert lines == [
        "Sent 0x|0C:00|2A:00|00|04:00|3A:83:07:00:00:00:60|",
        "Recv 0x|07:00|2A:00|02|07:00:00:00|",
        "Sent 0x|04:00|2B:00|01|9D|",
        "Recv 0x|0E:00|2B:00|03|9D|00|00:00:00:00:00:00:00:00:00|",
        "Sent 0x|08:00|2D:00|00|01:00|7C:04:60|",
        "    INFO.GET_VOLUME(VALUE=GV(0))",
        "Recv 0x|04:00|2D:00|02|64|",
        "    VALUE=100 %",
    ]


def test_frames_are_logged(my_ev3: EV3, caplog: pytest.LogCaptureFixture, capsys: pytest.CaptureFixture[str]) -> None:
    with caplog.at_level(logging.DEBUG, "ev3proto.link"):
        my_ev3.send_direct_cmd(b"\x81\x01\x60", global_mem=4)
    sent, received = caplog.messages
    assert re.fullmatch(r"Sent 0x\|08:00\|..:..\|00\|04:00\|81:01:60\|", sent)
    assert received.startswith("Recv 0x|07:00|")
    assert capsys.readouterr().out == ""
    my_ev3.send_direct_cmd(b"\x81\x01\x60", global_mem=4)
    assert len(caplog.messages) == 2


def test_what_is_printed_steers_no_terminal() -> None:
    """Names of bricks and files are in a character set in which 80 to 9F control a terminal like ESC."""
    command = ev3proto.system_command("LIST_FILES", reply=True, max_bytes=500, path="/\x1b[2J\x9b2J\x85\x7f").build()
    assert meaning_line(command, None, "official") == (
        '    LIST_FILES max_bytes=500 path="/\\u001b[2J\\u009b2J\\u0085\\u007f"'
    )
    answered = ev3proto.system_reply("LIST_FILES", list_size=4, handle=1, list="\x9b2J\n").build()
    assert meaning_line(answered, command, "official") == '    SUCCESS list_size=4 handle=1 list="\\u009b2J\\n"'


def test_what_is_said_about_which_brick_must_make_sense(monkeypatch: pytest.MonkeyPatch) -> None:
    for arguments, sentence in (
        ({}, "no brick is named"),
        ({"protocol": "x"}, "protocol must be WIFI, BLUETOOTH or USB, not 'x'"),
        ({"protocol": ev3proto.BLUETOOTH}, "host must be the brick's MAC address"),
        ({"protocol": ev3proto.USB, "address": ("a", 1)}, "address is for WIFI"),
        ({"target": "wfi"}, "unknown target 'wfi': did you mean wifi?"),
        ({"target": "usb", "host": "x"}, "must be omitted"),
        ({"protocol": ev3proto.USB, "sync_mode": "x"}, "sync_mode must be one of STD, ASYNC, SYNC, not 'x'"),
        ({"protocol": ev3proto.USB, "verbosity": 3}, "verbosity must be 0, 1 or 2, not 3"),
    ):
        with pytest.raises(ValueError, match=re.escape(sentence)):
            EV3(**arguments)
    monkeypatch.setenv("EV3PROTO_TARGET", "wifi:127.0.0.1:0")
    with pytest.raises(ValueError, match="invalid port"):
        EV3(protocol=ev3proto.USB)


def test_objects_share_a_connection_until_the_last_is_closed(my_ev3: EV3) -> None:
    other = EV3(ev3_obj=my_ev3, sync_mode=ev3proto.SYNC)
    my_ev3.close()
    assert other.send_direct_cmd(NOP) == b""
    other.close()
    other.close()
    with pytest.raises(ev3proto.ConnectionLostError, match="was closed"):
        other.send_direct_cmd(NOP)


def test_a_forgotten_object_ends_its_connection(port: int) -> None:
    EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port)).send_direct_cmd(NOP)
    # The brick serves one client at a time: this one would wait for the other for ever.
    with EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port)) as second:
        assert second.volume == 100


def test_no_frame_can_carry_too_much(my_ev3: EV3) -> None:
    sizes: Any = ({"local_mem": 64}, {"global_mem": 1024})
    for arguments in sizes:
        with pytest.raises(ev3proto.BuildError):
            my_ev3.send_direct_cmd(NOP, **arguments)
    with pytest.raises(ev3proto.BuildError, match="1024"):
        my_ev3.send_direct_cmd(NOP * 1018)
    nothings: Any = (b"", "opNop", 7, [7])
    for nothing in nothings:
        with pytest.raises(ev3proto.BuildError):
            my_ev3.send_direct_cmd(nothing)


# Information and settings of the brick


def test_properties(my_ev3: EV3) -> None:
    my_ev3.name = "myEV3"
    my_ev3.volume = 42
    my_ev3.sleep = 60
    assert (my_ev3.name, my_ev3.volume, my_ev3.sleep) == ("myEV3", 42, 60)
    assert my_ev3.system.fw_version == "V1.04H"
    assert 6 < my_ev3.battery.voltage < 10
    assert 0 <= my_ev3.battery.percentage <= 100
    assert my_ev3.memory.total >= my_ev3.memory.free > 0
    assert (my_ev3.protocol, my_ev3.host) == ("WiFi", "127.0.0.1")


def test_sensors(tmp_path: Path) -> None:
    with served(tmp_path) as brick, stubbed(brick.port) as my_ev3:
        brick.now.brick.plug(1, 16, {0: (0,)})
        brick.now.brick.plug("B", 7)
        sensors = my_ev3.sensors
        assert tuple(sensors) == (16, None, None, None, None, 7, None, None)
        assert sensors.Port_B == ev3proto.EV3_LARGE_MOTOR


# Files


def test_files_there_and_back(my_ev3: EV3, tmp_path: Path) -> None:
    data = bytes(range(256)) * 12
    steps: list[tuple[int, int]] = []
    digest = hashlib.md5(data).hexdigest()
    my_ev3.mkdir("../prjs/a")
    assert my_ev3.download(data, "../prjs/a/x.bin", lambda *step: steps.append(step)) == File("x.bin", 3072, digest)
    assert steps == [(0, 3072), (1017, 3072), (2034, 3072), (3051, 3072), (3072, 3072)]
    assert my_ev3.list_dir("../prjs/a") == Listing((), (File("x.bin", 3072, digest),))
    assert my_ev3.upload("../prjs/a/x.bin", tmp_path / "x.bin") == data
    assert (tmp_path / "x.bin").read_bytes() == data
    my_ev3.delete("../prjs/a/x.bin")
    my_ev3.delete("../prjs/a")
    with pytest.raises(ev3proto.SysCmdError, match="LIST_FILES with UNKNOWN_ERROR: no such fold"):
        my_ev3.list_dir("../prjs/a")


def test_a_full_brick_takes_no_file(my_ev3: EV3) -> None:
    with pytest.raises(ev3proto.SysCmdError, match="SIZE_ERROR: there is not enough room for a file of that size"):
        my_ev3.download(bytes(1 << 23), "../prjs/x.bin")


def test_a_full_disk_leaves_nothing_behind(my_ev3: EV3, tmp_path: Path) -> None:
    my_ev3.download(b"new", "../prjs/x.bin")
    (tmp_path / "here").mkdir()
    (tmp_path / "here" / "x.bin").write_bytes(b"old")
    with full_disk(2), pytest.raises(OSError, match="File too large"):
        my_ev3.upload("../prjs/x.bin", tmp_path / "here" / "x.bin")
    assert [(path.name, path.read_bytes()) for path in (tmp_path / "here").iterdir()] == [("x.bin", b"old")]


def test_a_file_that_changed_on_its_way_is_noticed() -> None:
    part = b""

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        nonlocal part
        part = frame[10:-1] if frame[5] == 0x92 else part
        listing = b"0" * 32 + b" 00000003 " + part + b"\n"
        status = {
            0x92: b"\0\x05",
            0x93: b"\x08\x05",
            0x99: b"\x08" + struct.pack("<I", len(listing)) + b"\x07" + listing,
            0x9C: b"\0",
        }
        send(reply(frame, frame[5:6] + status[frame[5]], 3))

    with (
        stub_brick(answer) as port,
        stubbed(port) as my_ev3,
        pytest.raises(
            ev3proto.TransferError,
            match=r"x: 3 bytes with the MD5 .* were copied, but the brick has 3 bytes with 0{32}",
        ),
    ):
        my_ev3.download(b"abc", "x")


# Faults


def test_a_brick_that_never_answers() -> None:
    with stub_brick(lambda *_: None) as port, stubbed(port, timeout=0.05) as my_ev3:
        with pytest.raises(ev3proto.NoAnswerError, match=r"to the command with the counter 42 within 0\.05 s"):
            my_ev3.send_direct_cmd(NOP, global_mem=1)
        with pytest.raises(TimeoutError, match=r"within 0\.01 s"):
            my_ev3.send_direct_cmd(NOP, sync_mode=ev3proto.SYNC, timeout=0.01)


def test_a_late_answer_is_dropped() -> None:
    frames: list[bytes] = []

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        frames.append(frame)
        if len(frames) == 2:
            send(reply(frames[0], b"\x01") + reply(frames[1], b"\x02"))

    with stub_brick(answer) as port, stubbed(port) as my_ev3:
        with pytest.raises(ev3proto.NoAnswerError):
            my_ev3.send_direct_cmd(NOP, global_mem=1, timeout=0.01)
        assert my_ev3.send_direct_cmd(NOP, global_mem=1) == b"\x02"


def test_a_reply_can_be_waited_for_again() -> None:
    ready = threading.Event()

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        ready.wait(30)
        send(reply(frame, b"\x07"))

    with stub_brick(answer) as port, stubbed(port, sync_mode=ev3proto.ASYNC) as my_ev3:
        counter = my_ev3.send_direct_cmd(NOP, global_mem=1)
        assert isinstance(counter, bytes)
        with pytest.raises(ev3proto.NoAnswerError):
            my_ev3.wait_for_reply(counter, timeout=0.01)
        ready.set()
        assert my_ev3.wait_for_reply(counter) == b"\x07"


@pytest.mark.parametrize("sent", [b"\0\0\0\0", b"\0\0", b"\xff\xff\xff\xff"])
def test_a_brick_that_goes_away_after_other_bytes(sent: bytes) -> None:
    def answer(_: bytes, send: Callable[[bytes], None]) -> None:
        send(sent)
        raise HangUp

    with stub_brick(answer) as port, stubbed(port) as my_ev3:
        with pytest.raises(ev3proto.ConnectionLostError) as raised:
            my_ev3.send_direct_cmd(NOP, global_mem=1)
        assert "did not" not in str(raised.value)


def test_a_brick_that_goes_away_in_the_middle_of_a_reply() -> None:
    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        send(reply(frame, bytes(9))[:8])
        raise HangUp

    with stub_brick(answer) as port, stubbed(port) as my_ev3:
        with pytest.raises(ev3proto.ConnectionLostError, match="within a reply: 8 bytes arrived, 6 are missing"):
            my_ev3.send_direct_cmd(NOP, global_mem=9)
        with pytest.raises(ConnectionError, match="connect again"):
            my_ev3.send_direct_cmd(NOP)
        assert not my_ev3.is_open


@pytest.mark.parametrize(
    "extra",
    [
        lambda frame: reply(frame, b"\x07"),
        lambda frame: reply(frame[:2] + b"\x99\x99"),
        lambda frame: b"\0" * 9,
        lambda frame: b"HTTP/1.1 200 OK\r\n\r\n",
    ],
    ids=["the same again", "another counter", "zeros", "another protocol"],
)
def test_bytes_between_answers_are_dropped(extra: Callable[[bytes], bytes]) -> None:
    numbers = iter(range(1, 9))

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        send(extra(frame[:2] + b"\x10\x27") + reply(frame, bytes((next(numbers),))) + extra(frame))

    with stub_brick(answer) as port, stubbed(port) as my_ev3:
        assert [my_ev3.send_direct_cmd(NOP, global_mem=1) for _ in range(3)] == [b"\x01", b"\x02", b"\x03"]


def test_the_error_shows_the_last_bytes_received() -> None:
    there = threading.Event()

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        send(bytes.fromhex("0300999902"))
        there.set()

    with stub_brick(answer) as port, stubbed(port) as my_ev3:
        my_ev3.send_direct_cmd(NOP)
        assert there.wait(30)
        with pytest.raises(ev3proto.NoAnswerError, match="a frame that answers no waiting command, 03:00:99:99"):
            my_ev3.send_direct_cmd(NOP, global_mem=1, timeout=1)


def test_messages_of_the_bricks_programs_are_kept() -> None:
    mail = ev3proto.system.writemailbox("abc", b"hello\0", counter=7, reply=False)
    with stub_brick(lambda frame, send: send(mail.build() + reply(frame))) as port, stubbed(port) as my_ev3:
        assert my_ev3.send_direct_cmd(NOP, sync_mode=ev3proto.SYNC) == b""
        assert my_ev3.take_messages() == [mail]
        assert my_ev3.take_messages() == []


def test_an_error_comes_with_what_check_says(my_ev3: EV3) -> None:
    with pytest.raises(ev3proto.DirCmdError, match=r"DIRECT_REPLY_ERROR: at offset 8: .* \(E\d+\)") as caught:
        my_ev3.send_direct_cmd(b"\xff\x01", global_mem=4)
    assert caught.value.report.rejected_at == 7
    assert len(caught.value.memory) == 4


def test_an_operation_that_failed_is_told_from_a_wrong_frame() -> None:
    with (
        stub_brick(lambda frame, send: send(reply(frame, b"\0", 4))) as port,
        stubbed(port) as my_ev3,
        pytest.raises(ev3proto.DirectCommandError, match="`ev3proto check` accepts the command"),
    ):
        my_ev3.send_direct_cmd(NOP, global_mem=1)


@pytest.mark.parametrize(
    ("accept", "patience", "sentence"),
    [
        (b"HTTP/1.1 400 Bad\r\n", 5.0, "is not a brick: it answered b'HTTP/1.1 400"),
        (b"", 0.1, "did not answer the unlock text"),
    ],
)
def test_a_server_that_is_not_a_brick(
    accept: bytes, patience: float, sentence: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ev3proto.link.ev3.CONNECT_TIMEOUT", patience)
    with stub_brick(lambda *_: None, accept) as port, pytest.raises(ev3proto.NoBrickError, match=re.escape(sentence)):
        stubbed(port)


def test_the_zero_after_the_accepted_text_is_skipped() -> None:
    with stub_brick(lambda frame, send: send(reply(frame)), b"Accept:EV340\r\n\r\n\0") as port, stubbed(port) as my_ev3:
        assert my_ev3.send_direct_cmd(NOP, sync_mode=ev3proto.SYNC) == b""


def test_a_port_without_a_server() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listening:
        port = listening.getsockname()[1]
    with pytest.raises(ev3proto.NoEV3, match=rf"nothing is listening on 127\.0\.0\.1:{port}; is the brick's WiFi on\?"):
        stubbed(port)


# Many at the same time


def test_fifty_threads_on_one_connection(my_ev3: EV3) -> None:
    rounds = effort(20, 400)

    def talk(number: int) -> bool:
        return all(
            my_ev3.send_direct_cmd(echo(number * 1000 + turn), global_mem=4) == struct.pack("<i", number * 1000 + turn)
            for turn in range(rounds)
        )

    with ThreadPoolExecutor(50) as pool:
        assert list(pool.map(talk, range(50))) == [True] * 50


def test_replies_in_any_order_find_their_threads() -> None:
    held: list[bytes] = []

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        held.append(reply(frame, frame[9:13]))
        if len(held) == 20:
            send(b"".join(reversed(held)))

    with stub_brick(answer) as port, stubbed(port) as my_ev3, ThreadPoolExecutor(20) as pool:
        found = pool.map(lambda number: my_ev3.send_direct_cmd(echo(number), global_mem=4), range(20))
        assert list(found) == [struct.pack("<i", number) for number in range(20)]


def test_a_thousand_commands_in_flight(port: int) -> None:
    async def talk() -> list[Any]:
        async with AsyncEV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port), sync_mode=ev3proto.ASYNC) as my_ev3:
            sent = [my_ev3.send_direct_cmd(echo(number), global_mem=4) for number in range(1000)]
            counters: Any = await asyncio.gather(*sent)
            assert len(set(counters)) == 1000
            return await asyncio.gather(*(my_ev3.wait_for_reply(counter) for counter in counters))

    assert asyncio.run(talk()) == [struct.pack("<i", number) for number in range(1000)]


def test_async_has_the_same_methods_and_properties(port: int, tmp_path: Path) -> None:
    async def talk() -> None:
        async with AsyncEV3(target=f"wifi:127.0.0.1:{port}") as my_ev3:
            await my_ev3.set_name("other")
            await my_ev3.set_volume(7)
            await my_ev3.set_sleep(20)
            assert (await my_ev3.name, await my_ev3.volume, await my_ev3.sleep) == ("other", 7, 20)
            assert (await my_ev3.system).fw_version == "V1.04H"
            assert (await my_ev3.battery).voltage > 6
            assert (await my_ev3.memory).free > 0
            assert (await my_ev3.sensors).Port_1 is None
            await my_ev3.mkdir("../prjs/a")
            await my_ev3.download(b"abc", "../prjs/a/x")
            assert await my_ev3.upload("../prjs/a/x", tmp_path / "x") == b"abc"
            assert (await my_ev3.list_dir("../prjs/a")).files[0].size == 3
            await my_ev3.delete("../prjs/a/x")
            assert await my_ev3.send_system_cmd(ev3proto.LIST_OPEN_HANDLES) == bytes(10)
            assert (my_ev3.target, my_ev3.protocol, my_ev3.host) == (f"wifi:127.0.0.1:{port}", "WiFi", "127.0.0.1")
            my_ev3.sync_mode, my_ev3.verbosity = ev3proto.SYNC, 0
            assert await my_ev3.send_direct_cmd(NOP) == b""
            assert my_ev3.is_open
        assert not my_ev3.is_open

    names = {name for name in dir(EV3) if not name.startswith("_")} - {"channel", "printer"}
    assert names <= set(dir(AsyncEV3))
    asyncio.run(talk())


def test_async_times_out() -> None:
    async def talk(port: int) -> None:
        async with AsyncEV3(target=f"wifi:127.0.0.1:{port}", timeout=0.05) as my_ev3:
            with pytest.raises(ev3proto.NoAnswerError):
                await my_ev3.send_direct_cmd(NOP, global_mem=1)
            with pytest.raises(RuntimeError, match="there is no connection yet"):
                await AsyncEV3(target="usb").send_direct_cmd(NOP)

    with stub_brick(lambda *_: None) as port:
        asyncio.run(talk(port))


@pytest.mark.parametrize("commands", [1, 1000])
def test_a_cancelled_command_is_given_up(commands: int) -> None:
    async def talk(port: int) -> None:
        async with AsyncEV3(target=f"wifi:127.0.0.1:{port}", timeout=60) as my_ev3:
            for cancel_after in (0.0, 0.1):
                sent = [asyncio.create_task(my_ev3.send_direct_cmd(NOP, global_mem=1)) for _ in range(commands)]
                with pytest.raises(TimeoutError):
                    async with asyncio.timeout(cancel_after):
                        await asyncio.gather(*sent)
                await asyncio.gather(*sent, return_exceptions=True)
            await my_ev3.send_direct_cmd(NOP, sync_mode=ev3proto.ASYNC)  # all others are sent by now
            channel = my_ev3.connected.channel
            assert channel._session.outstanding == []
            assert (len(channel._by_request), len(channel._tickets)) == (0, 0)

    with stub_brick(lambda *_: None) as port:
        asyncio.run(talk(port))


def test_a_listing_that_no_brick_has_is_refused() -> None:
    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        head = b"\0" + (1 << 27).to_bytes(4, "little") + b"\1" if frame[5] == 0x99 else b"\x08\1"
        send(reply(frame, frame[5:6] + head, 3))

    with stub_brick(answer) as port, stubbed(port) as my_ev3:
        with pytest.raises(ev3proto.TransferError) as raised:
            my_ev3.list_dir("../prjs")
        assert str(raised.value) == ("../prjs: the brick reports 134217728 bytes, which is more than a brick can store")


def test_the_virtual_brick_in_this_process(tmp_path: Path) -> None:
    with EV3(target=f"virtual:{tmp_path}") as my_ev3:
        my_ev3.download(b"abc", "../prjs/x")
        assert (tmp_path / "prjs" / "x").read_bytes() == b"abc"
        tone = [ops.sound.tone(1, 440, 100), ops.sound_ready()]
        assert my_ev3.send_direct_cmd(tone, sync_mode=ev3proto.SYNC) == []
    with pytest.raises(ev3proto.NoBrickError, match="is not a folder"):
        EV3(target=f"virtual:{tmp_path}/none")

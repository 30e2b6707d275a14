"""Attacks on the policy of `proxy --read-only`, end to end: what a client might try, and what the brick gets of it."""

from __future__ import annotations

import contextlib
import socket
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from support.cases import each
from support.cli import ROOT, run_ev3proto_text
from support.relays import Relay, relay
from support.sent import sent_in
from support.server import Client, Served, served, system, until
from support.stub_brick import reply, stub_brick

import ev3proto
from ev3proto import GV, LV, Operation, operation
from ev3proto.brick.servers.server import Options
from ev3proto.link.harm import harms_of
from ev3proto.schema.argument import encode_as

BEGIN_DOWNLOAD, BEGIN_UPLOAD, CONTINUE_UPLOAD, CLOSE, LIST, CONTINUE_LIST = 0x92, 0x94, 0x95, 0x98, 0x99, 0x9A
BATTERY = ev3proto.command(operation("UI_READ.GET_LBATT", GV(0)), counter=0x777).build()


def direct(*operations: Operation, counter: int = 7) -> bytes:
    return ev3proto.command(*operations, counter=counter, reply=True).build()


def begin(path: str = "../prjs/x.rtf", size: int = 10, number: int = BEGIN_UPLOAD) -> bytes:
    return system(number, size.to_bytes(2, "little") + path.encode() + b"\0")


@contextlib.contextmanager
def guarded(folder: Path) -> Iterator[tuple[Served, Relay]]:
    """Serves a brick with a file of 3,000 bytes, and a proxy before it."""
    (folder / "prjs").mkdir(exist_ok=True)
    (folder / "prjs/x.rtf").write_bytes(bytes(3000))
    with (
        served(folder, Options(port=0, beacon=False, clients=3)) as brick,
        relay(f"wifi:127.0.0.1:{brick.port}", is_read_only=True) as found,
    ):
        yield brick, found


class Stub:
    """A brick that answers as told, and what it got."""

    def __init__(self, answer: Callable[[bytes], bytes | None]) -> None:
        self.got: list[bytes] = []
        self._answer = answer

    def __call__(self, frame: bytes, send: Callable[[bytes], None]) -> None:
        self.got.append(frame)
        answer = self._answer(frame)
        if answer:
            send(answer)

    @property
    def commands(self) -> list[int]:
        """The numbers of the system commands that it got."""
        return [frame[5] for frame in self.got if frame[4] & 0x7F == 1]


@contextlib.contextmanager
def before(answer: Callable[[bytes], bytes | None]) -> Iterator[tuple[Stub, Relay]]:
    stub = Stub(answer)
    with stub_brick(stub) as port, relay(f"wifi:127.0.0.1:{port}", is_read_only=True) as found:
        yield stub, found


def answered(frame: bytes, *body: int, type: int = 3) -> bytes:
    """Returns the reply to a system command."""
    return reply(frame, bytes((frame[5], *body)), type)


# 1 to 5: what operations do


def test_a_foreign_type_does_not_reset_a_motor(tmp_path: Path) -> None:
    with guarded(tmp_path) as (brick, found), Client(found.proxy.port) as client:
        brick.now.brick.plug("A", 7, tacho=1234, count=370, speed=0)
        for number in (7, 8, 16, 29, 33, 125):
            # The value is that of the motor, whatever the client takes it for.
            ready = client.ask(direct(operation("INPUT_DEVICE.READY_RAW", 0, 16, number, 0, [GV(0)])))
            assert (ready[4], ready[5:]) == (2, (370).to_bytes(4, "little"))
        # A variable may be any type.
        assert client.ask(direct(operation("INPUT_DEVICE.READY_RAW", 0, 16, GV(33), 0, [GV(0)])))[4] == 4
    wrong = operation("INPUT_DEVICE.READY_RAW", 0, 16, 33, 0, [GV(0)])
    with before(lambda frame: reply(frame, b"\0\0\0\0")) as (stub, found), Client(found.proxy.port) as client:
        client.ask(direct(wrong))
        assert stub.got == [direct(operation("INPUT_DEVICE.READY_RAW", 0, 16, encode_as("LC1", 0), 0, [GV(0)]))]
        # What is shown is the client's own.
        assert found.shown[0].startswith("INPUT_DEVICE.READY_RAW(LAYER=0, NO=16, TYPE=TYPE_IR")


ATTACKS = {
    "nine waits": [operation("INPUT_DEVICE.READY_RAW", 0, port, 0, 0, [GV(0)]) for port in (0, 1, 2, 3) * 2 + (0,)],
    "addresses over memory": [operation("COM_GET.GET_NETWORK", 3, 1, GV(0), GV(1), GV(2))],
    "the memory of the program is freed": [
        operation("FILE.OPEN_READ", "../prjs/none.rtf", LV(0), LV(4)),
        operation("FILE.CLOSE", LV(0)),
    ],
    "a missing file is read": [
        operation("FILE.OPEN_READ", "../prjs/none.rtf", LV(0), LV(4)),
        operation("FILE.READ_BYTES", LV(0), 4, GV(0)),
    ],
    "the handle is written over": [
        operation("FILE.OPEN_READ", "../prjs/x.rtf", LV(0), LV(4)),
        operation("MOVE16_16", 0, LV(0)),
        operation("FILE.READ_BYTES", LV(0), 4, GV(0)),
    ],
    "a device is opened": [operation("FILE.OPEN_READ", "/dev/lms_pwm", LV(0), LV(4))],
}


@each("attack", ATTACKS)
def test_operations(attack: str, tmp_path: Path) -> None:
    with guarded(tmp_path) as (_, found), Client(found.proxy.port) as client:
        assert client.ask(direct(*ATTACKS[attack]))[4] == 4


# 6 to 10: handles, and commands in flight


def test_handles_are_not_taken_for_good(tmp_path: Path) -> None:
    with guarded(tmp_path) as (brick, found), Client(found.proxy.port) as client, Client(brick.port) as other:
        silent = bytearray(begin())
        silent[4] = 0x81
        client.send(bytes(silent) * 64)
        assert client.ask(BATTERY)[4] == 2
        assert len(set(found.said)) == 1
        assert other.ask(begin())[11] == 0


def test_one_command_is_in_flight() -> None:
    waiting: list[bytes] = []
    with before(lambda frame: waiting.append(frame)) as (stub, found), Client(found.proxy.port) as client:
        client.send(BATTERY * 50)
        until(lambda: len(stub.got) == 1)
        time.sleep(0.2)
        assert stub.got == [BATTERY]


def test_a_client_that_waits_is_not_read() -> None:
    with before(lambda frame: None) as (stub, found), Client(found.proxy.port) as client:
        client.socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 16)
        client.send(BATTERY)
        until(lambda: len(stub.got) == 1)
        client.socket.settimeout(0.5)
        with pytest.raises(TimeoutError):
            client.send(BATTERY * 2_000_000)
        assert stub.got == [BATTERY]


LISTED = b"0" * 32 + b" 00000009 x.rtf\n"


def with_a_file(frame: bytes) -> bytes:
    """Answers as a brick does that has one file of nine bytes, whose handle is 7."""
    if frame[5] == LIST:
        return answered(frame, 8, len(LISTED), 0, 0, 0, 5, *LISTED)
    return answered(frame, *((0, 9, 0, 0, 0, 7) if frame[5] == BEGIN_UPLOAD else (0, 7)))


def test_a_listing_is_neither_read_as_a_file_nor_closed(tmp_path: Path) -> None:
    commands: list[int] = []

    def listing(frame: bytes) -> bytes:
        if frame[5] == LIST:
            return answered(frame, 0, 99, 0, 0, 0, 5, *b"./\n")
        commands.append(frame[5])
        return answered(frame, 0 if len(commands) < 3 else 8, 5, *b"../")

    with before(listing) as (stub, found), Client(found.proxy.port) as client:
        begun = client.ask(begin("../prjs/", 3, LIST))
        assert begun[6] == 0
        assert client.ask(system(CONTINUE_UPLOAD, begun[11:12] + b"\x0a\0"))[6] == 1
        assert client.ask(system(CLOSE, begun[11:12]))[6] == 1
        # Of another client, or not open at all.
        assert client.ask(system(CONTINUE_LIST, b"\5\x0a\0"))[6] == 1
        assert set(stub.commands) == {LIST, CONTINUE_LIST}


def test_a_listing_that_is_left_is_read_to_its_end() -> None:
    count = 0

    def listing(frame: bytes) -> bytes | None:
        nonlocal count
        if frame[4] == 0:
            return reply(frame, b"\x64")
        if frame[5] == LIST:
            return answered(frame, 0, 9, 0, 0, 0, 5, *b"./\n")
        count += 1
        return answered(frame, 0 if count < 4 else 8, 5, *b"../")

    with before(listing) as (stub, found):
        with Client(found.proxy.port) as client:
            assert client.ask(begin("../prjs/", 3, LIST))[6] == 0
        with Client(found.proxy.port) as client:
            assert client.ask(BATTERY)[5:] == b"\x64"
        assert stub.commands == [LIST, *[CONTINUE_LIST] * 4]
        assert stub.got[-1] == BATTERY
        count = 0
        with Client(found.proxy.port) as client:
            assert client.ask(begin("../prjs/", 3, LIST))[6] == 0
            # The proxy ends while this client is connected.
            found.proxy.stop()
            found.thread.join(30)
        assert stub.commands == [LIST, *[CONTINUE_LIST] * 4] * 2


def test_a_handle_is_one_of_an_own_reply(tmp_path: Path) -> None:
    def mixed(frame: bytes) -> bytes:
        # Replies to another program, with another counter and to another command, come first.
        other = bytearray(answered(frame, 0, 9, 0, 0, 0, 33))
        other[2] ^= 1
        strange = reply(frame, bytes((BEGIN_DOWNLOAD, 0, 34)), 3)
        return bytes(other) + strange + answered(frame, 0, 9, 0, 0, 0, 7)

    with before(mixed) as (stub, found), Client(found.proxy.port) as client:
        handle = client.ask(begin("../prjs", 10, LIST))[11]
        for other in {33, 34, 7} - {handle}:
            assert client.ask(system(CONTINUE_LIST, bytes((other, 9, 0))))[6] == 1
        assert CLOSE not in stub.commands


# 11 and 12: paths and sizes


def test_paths() -> None:
    with before(lambda frame: answered(frame, 0, 9, 0, 0, 0, 7)) as (stub, found), Client(found.proxy.port) as client:
        for path in ("/proc/self/environ", "/dev/mtdblock0", "../../../../etc/shadow", "../../x", "a/" * 50):
            for number in (BEGIN_UPLOAD, 0x96, LIST):
                assert client.ask(begin(path, 10, number))[6] != 0
        assert stub.got == []


def test_a_folder_is_not_opened_as_a_file() -> None:
    """The firmware would; the folder above is listed first, and it names only files that may be opened."""
    with_a_folder = LISTED + b"inner/\n"

    def listed(frame: bytes) -> bytes:
        return answered(frame, 8, len(with_a_folder), 0, 0, 0, 5, *with_a_folder)

    with before(listed) as (stub, found), Client(found.proxy.port) as client:
        for path, status in (("../prjs/inner", 11), ("../prjs/none.rtf", 1), ("../prjs", 1), ("../prjs/inner/", 1)):
            for number in (BEGIN_UPLOAD, 0x96):
                reply = client.ask(begin(path, 10, number))
                assert (reply[4], reply[6]) == (5, status), path
        assert set(stub.commands) <= {LIST}


def test_sizes_are_the_proxy_s_own() -> None:
    with before(with_a_file) as (stub, found), Client(found.proxy.port) as client:
        for asked in (0, 1, 100, 1012, 1024, 4096, 65535):
            assert client.ask(begin("../prjs/x.rtf", asked))[6] == 0
            assert client.ask(begin("../prjs", asked, LIST))[6] in (0, 8)
        begun = [frame for frame in stub.got if frame[5] in (BEGIN_UPLOAD, LIST)]
        assert {frame[6:8] for frame in begun} == {(1012).to_bytes(2, "little")}


def test_a_large_file_of_frames_comes_back_whole(tmp_path: Path) -> None:
    # Its contents look like replies to commands that another client might have sent.
    contents = bytes.fromhex("04 00 77 07 02 64") * 2000
    with guarded(tmp_path) as (_, found), Client(found.proxy.port) as client:
        (tmp_path / "prjs/x.rtf").write_bytes(contents)
        first = client.ask(begin(size=4096))
        data, handle = first[12:], first[11]
        while len(data) < len(contents):
            data += client.ask(system(CONTINUE_UPLOAD, bytes((handle, 0, 16))))[8:]
        assert data == contents


# 13 to 15: who gets a reply


def test_a_reply_belongs_to_the_client_that_asked() -> None:
    has_gone = threading.Event()

    def late(frame: bytes) -> bytes:
        if frame[4] == 0:
            return reply(frame, b"\x64")
        if frame[5] == BEGIN_UPLOAD:
            assert has_gone.wait(10)
        return with_a_file(frame)

    with before(late) as (stub, found):
        with Client(found.proxy.port) as client:
            client.send(begin())
            until(lambda: BEGIN_UPLOAD in stub.commands)
        has_gone.set()
        with Client(found.proxy.port) as client:
            # The counter is that of the upload.
            assert client.ask(system(0x9D, b""))[5:7] == b"\x9d\0"
            assert client.is_silent()
        until(lambda: CLOSE in stub.commands)
        assert stub.commands[:3] == [LIST, BEGIN_UPLOAD, CONTINUE_UPLOAD]
        assert {frame[4:] for frame in stub.got[3:]} == {bytes.fromhex("01 98 07"), bytes.fromhex("01 9d")}


def test_a_lost_reply_renews_the_connection(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.link.relays.PATIENCE", 0.3)
    battery_asked = 0

    def lossy(frame: bytes) -> bytes | None:
        nonlocal battery_asked
        battery_asked += 1
        return reply(frame, b"\x64") if battery_asked > 1 else None

    with before(lossy) as (_, found), Client(found.proxy.port) as client:
        client.send(BATTERY)
        assert client.is_silent(0.6)
        assert client.ask(BATTERY)[5:] == b"\x64"
        assert found.said == ["no answer from the brick within 0.3 s; the connection to it is made anew"]
        assert found.shown[0].startswith("UI_READ.GET_LBATT(PCT=GV(0)) -> no reply")


# 16 to 19: several clients


def whole(client: Client, path: str, asked: int) -> Iterator[bytes]:
    """Reads a file in pieces of a size, one at each step."""
    reply = client.ask(begin(path, asked))
    assert reply[6] in (0, 8), reply.hex()
    handle, data, status = reply[11:12], reply[12:], reply[6]
    size = int.from_bytes(reply[7:11], "little")
    yield data
    while status != 8:
        reply = client.ask(system(CONTINUE_UPLOAD, handle + asked.to_bytes(2, "little")))
        status = reply[6]
        assert status in (0, 8), (len(data), size)
        data += reply[8:]
        yield data
    assert len(data) == size


def test_clients_that_read_at_once_get_their_own_files(tmp_path: Path) -> None:
    """A brick continues the file that was opened last, whatever the handle."""
    with guarded(tmp_path) as (brick, found), contextlib.ExitStack() as stack:
        files = {f"{number}.rtf": bytes((number,)) * (5000 + number) for number in range(8)}
        for name, data in files.items():
            (tmp_path / "prjs" / name).write_bytes(data)
        clients = [stack.enter_context(Client(found.proxy.port)) for _ in files]
        readers = [
            whole(client, f"../prjs/{name}", asked)
            for client, name, asked in zip(clients, files, (90, 97, 100, 500, 1000, 1012, 1016, 4096), strict=True)
        ]
        got = dict.fromkeys(files, b"")
        for turn in range(20):
            for name, reader, client in zip(files, readers, clients, strict=True):
                got[name] = next(reader, got[name])
                assert len(brick.now.brick._system._transfers) <= 1
                if turn % 5 == 0:
                    assert client.ask(BATTERY)[4] == 2
        for name, reader in zip(files, readers, strict=True):
            for got[name] in reader:
                pass
        assert got == files
        assert found.said == []


def test_a_client_in_turn_waits_for_one_command_of_each_other(tmp_path: Path) -> None:
    order: list[int] = []

    def slow(frame: bytes) -> bytes:
        order.append(frame[2])
        time.sleep(0.02)
        return reply(frame, b"\x64")

    with before(slow) as (_, found), Client(found.proxy.port) as greedy, Client(found.proxy.port) as other:
        greedy.send(b"".join(direct(operation("UI_READ.GET_LBATT", GV(0)), counter=1) for _ in range(40)))
        until(lambda: len(order) > 2)
        for _ in range(5):
            begun = len(order)
            assert other.ask(direct(operation("UI_READ.GET_LBATT", GV(0)), counter=2))[4] == 2
            assert 2 in order[begun : begun + 3]


def test_more_than_is_kept_for_a_client_ends_its_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.link.reader.MOST_KEPT", 5000)
    pieces = 0

    def long(frame: bytes) -> bytes:
        nonlocal pieces
        if frame[4] == 0:
            return reply(frame, b"\x64")
        if frame[5] == LIST:
            pieces = 0
            return answered(frame, 0, 255, 255, 0, 0, 5, *b"./\n")
        pieces += 1
        return answered(frame, 8 if pieces > 9 else 0, 5, *bytes(900))

    with (
        before(long) as (_, found),
        Client(found.proxy.port) as first,
        Client(found.proxy.port) as second,
        Client(found.proxy.port) as third,
    ):
        handle = first.ask(begin("../prjs", 10, LIST))[11:12]
        second.send(begin("../prjs", 10, LIST))
        for _ in range(4):
            assert third.ask(BATTERY)[4] == 2
        assert second.reply()[6] == 0
        got = [first.ask(system(CONTINUE_LIST, handle + b"\xf4\x03")) for _ in range(9)]
        assert sum(len(one) - 8 for one in got) < 6500
        assert got[-1][6] != 0


@pytest.mark.parametrize("is_read_only", [False, True])
def test_half_a_frame_is_given_up_while_others_wait(is_read_only: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.link.proxy.SILENCE", 0.4)
    monkeypatch.setattr("ev3proto.link.proxy._LOOK", 0.05)
    with relay("virtual", is_read_only=is_read_only) as found, Client(found.proxy.port) as half:
        half.send(BATTERY[:-1])
        assert half.is_silent(1.0)  # it is the only client
        with Client(found.proxy.port) as other:
            assert other.ask(BATTERY)[4] == 2
            with pytest.raises(ConnectionError):
                half.read(1)
        assert "sent no whole frame for 0.4 s, and others wait" in found.said[0]


def test_the_quietest_of_many_clients_gives_way(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.link.proxy.MOST_CLIENTS", 3)
    monkeypatch.setattr("ev3proto.link.proxy.SILENCE", 0.4)
    monkeypatch.setattr("ev3proto.link.proxy._LOOK", 0.05)
    with relay("virtual", is_read_only=True) as found, contextlib.ExitStack() as stack:
        clients = [stack.enter_context(Client(found.proxy.port)) for _ in range(3)]
        time.sleep(0.5)
        assert [client.ask(BATTERY)[4] for client in clients[1:]] == [2, 2]
        with Client(found.proxy.port) as late:
            assert late.ask(BATTERY)[4] == 2
            with pytest.raises(ConnectionError):
                clients[0].read(1)


# replay


def test_replay_uses_the_handles_of_this_brick(tmp_path: Path) -> None:
    """The recorded brick had a file under handle 0; at this one that is another client's."""
    with guarded(tmp_path) as (brick, _), Client(brick.port) as other:
        assert other.ask(begin())[11] == 0
        done = run_ev3proto_text(
            "replay", ROOT / "captures/wifi.pcapng", "--to", f"wifi:127.0.0.1:{brick.port}", "--fast"
        )
        sent = [line for line in done.stdout.splitlines() if "CONTINUE_UPLOAD" in line]
        assert len(sent) == 3
        assert all(line.startswith("omitted") for line in sent)
        assert other.ask(system(CONTINUE_UPLOAD, b"\0\x0a\0"))[6] == 0


# What people use it for


def test_what_reads_in_captures_of_clients_passes(tmp_path: Path) -> None:
    devices: dict[int | str, int] = {1: 16, 3: 33, "A": 7, "B": 7, "C": 8, "D": 7}
    with guarded(tmp_path) as (brick, found), Client(found.proxy.port) as client:
        for port, number in devices.items():
            brick.now.brick.plug(port, number)
        for name in ("ev3_dc.pcap", "real-bricks.log", "wifi.pcapng", "usb.pcapng"):
            # Port 2 had the colour sensor, or the gyro sensor of the bricks that pcapng files are from.
            brick.now.brick.plug(2, 32 if name.endswith("pcapng") else 29)
            reading = [one for one in sent_in(name) if not harms_of(one)]
            assert len(reading) >= 5
            for message in reading:
                client.ask(message.build())
    assert set(found.said) <= {
        # Files that the brick of the recording had.
        "blocked by --read-only: CONTINUE_UPLOAD names a handle that this client has not opened",
        "blocked by --read-only: CONTINUE_LIST_FILES names a handle that this client has not opened",
    }

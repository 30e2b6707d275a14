"""A full disk, a full quota and defects: one operation fails, and the brick goes on for everybody."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.bricks import FAIL, OK, command, op, run
from support.full_disk import full_disk
from support.server import Client, served, system, upload

import ev3proto
from ev3proto.brick import Brick
from ev3proto.brick.storage import Storage
from ev3proto.messages import GV, LV
from ev3proto.tables.system import SystemStatus

NOP = command(op("NOP"), counter=7)
NOP_REPLY = bytes.fromhex("0300070002")


def on_disk(root: Path) -> int:
    return sum(path.stat().st_size for path in root.rglob("*") if path.is_file())


@pytest.fixture
def root(tmp_path: Path) -> Path:
    Brick(tmp_path)
    (tmp_path / "prjs/a").mkdir()
    (tmp_path / "prjs/a/noise").write_bytes(bytes(range(256)) * 40)
    return tmp_path


PACK = op("FILENAME.PACK", "../prjs/a")
COPY = op("FILE.MOVE", "../prjs/a/noise", "../prjs/b")


@pytest.mark.parametrize("size", [0, 100])
@pytest.mark.parametrize("code", [PACK, COPY])
def test_an_operation_on_a_full_disk(root: Path, code: bytes, size: int) -> None:
    brick = Brick(root)
    with full_disk(size):
        (reply,) = brick.receive(command(code))
        assert reply[4] in (OK, FAIL)
        assert run(brick, op("NOP"))[0] == OK
    assert brick.equipment.files.used == on_disk(root)


@pytest.mark.parametrize("size", [0, 100])
@pytest.mark.parametrize("code", [PACK, COPY])
def test_clients_on_a_full_disk(root: Path, code: bytes, size: int) -> None:
    with served(root) as brick, full_disk(size):
        for _ in range(2):
            with Client(brick.port) as client:
                assert client.ask(command(code))[4] in (OK, FAIL)
                assert client.ask(NOP) == NOP_REPLY
        with Client(brick.port) as client:
            assert upload(client, b"../prjs/c", bytes(5000)) == SystemStatus.SIZE_ERROR
            assert client.ask(NOP) == NOP_REPLY
        assert brick.said == []


class Broken:
    """A part of the brick with a defect."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.is_broken = True

    def __call__(self, *_: object) -> None:
        if self.is_broken:
            raise RuntimeError(f"{self.name} is broken")


def test_a_defect_in_an_operation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with served(tmp_path) as brick:
        monkeypatch.setattr(brick.now.brick.equipment.sound, "tone", Broken("the sound"))
        for _ in range(2):
            with Client(brick.port) as client:
                assert client.ask(command(op("SOUND.TONE", 1, 440, 100)))[4] == FAIL
                assert client.ask(NOP) == NOP_REPLY
        assert [sentence[:38] for sentence in brick.said] == ["a defect of the virtual brick, please "]


def test_a_defect_while_time_passes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with served(tmp_path) as brick:
        broken = Broken("a part")
        monkeypatch.setattr(brick.now.brick.equipment.inputs, "advance", broken)
        with Client(brick.port) as client:
            assert client.is_silent(0.2)
            broken.is_broken = False
            assert client.ask(NOP) == NOP_REPLY
        assert any("a part is broken" in sentence for sentence in brick.said)


def test_a_defect_at_the_end_of_a_connection(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with served(tmp_path) as brick:
        with Client(brick.port) as client:
            assert client.ask(NOP) == NOP_REPLY
            monkeypatch.setattr(brick.now.brick, "disconnect", Broken("the end"))
        with Client(brick.port) as client:
            assert client.ask(NOP) == NOP_REPLY
        assert any("the end is broken" in sentence for sentence in brick.said)


@pytest.mark.parametrize("length", [4, 254, 255])
def test_a_long_pin_is_answered(tmp_path: Path, length: int) -> None:
    pin = ev3proto.system_command("BLUETOOTHPIN", mac="001653120001", pin="1" * min(length, 254)).build()
    body = pin[5:] if length < 255 else b"\x9f\x0d" + b"001653120001\0" + b"\xff" + b"1" * 255 + b"\0"
    (reply,) = Brick(tmp_path).receive(system(body[0], body[1:]))
    assert (reply[4], reply[6]) == (0x03, SystemStatus.ILLEGAL_CONNECTION)


def test_a_defect_in_a_system_command_is_answered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with served(tmp_path) as brick, Client(brick.port) as client:
        monkeypatch.setattr(brick.now.brick.equipment.mailboxes, "deliver", Broken("a mailbox"))
        monkeypatch.setattr(brick.now.brick.equipment.files, "make_folder", Broken("a folder"))
        assert client.ask(system(0x9B, b"../prjs/x\0"))[4:] == bytes((0x05, 0x9B, SystemStatus.UNKNOWN_ERROR))
        assert client.ask(NOP) == NOP_REPLY


# The quota


OPEN = op("FILE.OPEN_WRITE", "../prjs/x", LV(0))
WRITE = op("FILE.WRITE_BYTES", LV(0), 127, GV(0))


def test_a_file_that_is_opened_twice_counts_as_it_is_on_disk(tmp_path: Path) -> None:
    brick = Brick(tmp_path)
    brick.equipment.files.quota = 2000
    opened_again = op("FILE.OPEN_WRITE", "../prjs/x", LV(2))
    for _ in range(20):
        run(brick, OPEN, *([WRITE] * 12), opened_again, *([WRITE] * 12), locals=4, globals=127)
        assert on_disk(tmp_path) <= 2000
        assert brick.equipment.files.used == on_disk(tmp_path)


def test_a_deleted_file_counts_while_it_is_open(tmp_path: Path) -> None:
    storage = Storage(tmp_path, quota=1000)
    files = []
    for number in range(5):
        file = storage.open_to_write(b"../prjs/%d" % number)
        assert file is not None
        files.append(file)
        assert file.put(bytes(300)) == (number < 3)
        storage.delete(b"../prjs/%d" % number)
    assert storage.used == 900
    for file in files:
        file.close()
        file.close()
    assert (storage.used, storage.free) == (0, 1000)


def test_a_file_that_is_opened_twice_and_deleted_counts_until_both_are_closed(tmp_path: Path) -> None:
    storage = Storage(tmp_path, quota=1000)
    writer, reader = storage.open_to_write(b"../prjs/x"), None
    assert writer is not None
    assert writer.put(bytes(300))
    reader = storage.open_to_read(b"../prjs/x")
    assert reader is not None
    storage.delete(b"../prjs/x")
    writer.close()
    assert storage.used == 300
    reader.close()
    assert storage.used == 0


def test_what_is_written_over_takes_no_more_room(tmp_path: Path) -> None:
    storage = Storage(tmp_path, quota=100)
    first = storage.open_to_write(b"../prjs/x")
    second = storage.open_to_write(b"../prjs/x")
    assert first is not None
    assert second is not None
    assert first.put(bytes(60))
    assert second.put(bytes(60))
    assert storage.used == 60
    assert not second.put(bytes(60))
    assert storage.used == on_disk(tmp_path) <= 100
    first.close()
    second.close()


def test_two_downloads_at_once_have_one_quota(tmp_path: Path) -> None:
    brick = Brick(tmp_path)
    brick.equipment.files.quota = 310 * 1024
    begin = system(0x92, (9000).to_bytes(4, "little") + b"../prjs/x\0")
    handles = [brick.receive(begin)[0][7] for _ in range(8)]
    for handle in handles:
        for _ in range(9):
            brick.receive(system(0x93, bytes((handle,)) + bytes(1000)))
    assert brick.equipment.files.used == on_disk(tmp_path) <= 310 * 1024

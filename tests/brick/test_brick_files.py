"""Files on the virtual brick: FILE and FILENAME, system commands, and nothing outside its folder."""

from __future__ import annotations

import hashlib
import os
import struct
from pathlib import Path

import pytest
from support.bricks import FAIL, OK, command, op, run

from ev3proto import system
from ev3proto.brick import Brick
from ev3proto.brick.storage import Storage
from ev3proto.messages import GV, LV, SystemCommand

REPLY, ERROR = 0x03, 0x05


@pytest.fixture
def projects(tmp_path: Path, brick: Brick) -> Path:
    """The folder ../prjs of the brick."""
    return tmp_path / "prjs"


def answer(brick: Brick, message: SystemCommand) -> tuple[int, bytes]:
    """The type of the reply, and what follows the command in it."""
    [reply] = brick.receive(message.build())
    assert reply[5] == message.build()[5]
    return reply[4], reply[6:]


def text(brick: Brick, *code: bytes, at: int = 0) -> bytes:
    brick.receive(command(op("INIT_BYTES", GV(0), 64, [0] * 64), reply=False))
    kind, memory = run(brick, *code, globals=64)
    assert kind == OK
    return memory[at:].partition(b"\0")[0]


# System commands


def test_a_file_goes_to_the_brick_and_back(brick: Brick, projects: Path) -> None:
    data = bytes(range(256)) * 12
    for message in system.download("../prjs/Demo/data.rtf", data):
        kind, contents = answer(brick, message)
        assert kind == REPLY
    assert contents == bytes((8, 0))
    assert (projects / "Demo" / "data.rtf").read_bytes() == data
    kind, contents = answer(brick, system.begin_upload("/home/root/lms2012/prjs/Demo/data.rtf", 1012))
    assert (kind, contents[:6]) == (REPLY, bytes((0,)) + len(data).to_bytes(4, "little") + bytes((0,)))
    found = contents[6:]
    while contents[0] == 0:
        kind, contents = answer(brick, system.continue_upload(0, 1016))
        found += contents[2:]
    assert (contents[0], found) == (8, data)
    assert answer(brick, system.continue_upload(0, 10)) == (ERROR, bytes((1, 0xFF)))


def test_pieces_fill_a_frame_and_no_more(brick: Brick, projects: Path) -> None:
    """A reply with the size of the file has four bytes less of it: the first ones, and all of GETFILE's."""
    projects.mkdir(exist_ok=True)
    data = bytes(range(251)) * 12
    (projects / "data.rtf").write_bytes(data)
    path = "/home/root/lms2012/prjs/data.rtf"
    (first,) = brick.receive(system.begin_upload(path, 2000).build())
    (second,) = brick.receive(system.continue_upload(first[11], 2000).build())
    assert (len(first), len(second)) == (1024, 1024)
    assert (first[12:], second[8:]) == (data[:1012], data[1012:2028])
    (first,) = brick.receive(system.begin_getfile(path, 2000).build())
    (second,) = brick.receive(system.continue_getfile(first[11], 2000).build())
    assert (len(first), len(second)) == (1024, 1024)
    assert (first[12:], second[12:]) == (data[:1012], data[1012:2024])


@pytest.mark.parametrize("asked", [3, 4, 5])
def test_what_is_appended_during_an_upload_is_not_sent(brick: Brick, projects: Path, asked: int) -> None:
    """The size is told with the first piece: 2 + 4 bytes."""
    projects.mkdir(exist_ok=True)
    (projects / "data.rtf").write_bytes(b"abcdef")
    (first,) = brick.receive(system.begin_upload("/home/root/lms2012/prjs/data.rtf", 2).build())
    assert (first[7:11], first[12:]) == (b"\x06\0\0\0", b"ab")
    with (projects / "data.rtf").open("ab") as file:
        file.write(b"ghi")
    (second,) = brick.receive(system.continue_upload(first[11], asked).build())
    assert (second[6], second[8:]) == ((0, b"cde") if asked == 3 else (8, b"cdef"))


def test_all_of_a_file_in_the_first_frame(brick: Brick, projects: Path) -> None:
    frame = bytearray(system.begin_download("../prjs/a.rtf", 3).build() + b"abcdef")
    frame[:2] = (len(frame) - 2).to_bytes(2, "little")
    assert brick.receive(bytes(frame)) == [bytes.fromhex("06 00 00 00 03 92 08 00")]
    assert (projects / "a.rtf").read_bytes() == b"abc"
    assert answer(brick, system.begin_download("../prjs/empty.rtf", 0)) == (REPLY, bytes((8, 0)))


def test_only_the_stated_size_is_written(brick: Brick, projects: Path) -> None:
    answer(brick, system.begin_download("../prjs/a.rtf", 3))
    assert answer(brick, system.continue_download(0, b"abcdef")) == (REPLY, bytes((8, 0)))
    assert (projects / "a.rtf").read_bytes() == b"abc"


@pytest.mark.parametrize(
    ("message", "contents"),
    [
        (system.begin_download("../prjs/b*d.rtf", 3), (4, 0xFF)),
        (system.begin_download("../prjs/" + "n" * 32, 3), (4, 0xFF)),
        (system.begin_download("../prjs/a.abcd", 3), (4, 0xFF)),
        (system.begin_download("../prjs/a.rtf", 0x7FFFFFFF), (9, 0xFF)),
        (system.begin_download("/etc/passwd", 3), (1, 0xFF)),
        (system.begin_download("../../../../etc/passwd", 3), (1, 0xFF)),
        (system.continue_download(7, b"abc"), (1, 0xFF)),
        (system.begin_upload("../prjs/none.rtf", 10), (1, 0, 0, 0, 0, 0xFF)),
        (system.begin_upload("../prjs/b*d.rtf", 10), (4, 0, 0, 0, 0, 0xFF)),
        (system.begin_upload("/etc/passwd", 10), (1, 0, 0, 0, 0, 0xFF)),
        (system.begin_upload("../prjs", 10), (1, 0, 0, 0, 0, 0xFF)),
        (system.continue_upload(7, 10), (1, 0xFF)),
        (system.begin_getfile("../prjs/none.rtf", 10), (2, 0, 0, 0, 0, 0xFF)),
        (system.begin_getfile("../prjs/b*d.rtf", 10), (1, 0, 0, 0, 0, 0xFF)),
        (system.continue_getfile(7, 10), (1, 0, 0, 0, 0, 0xFF)),
        (system.list_files("../none", 100), (10, 0, 0, 0, 0, 0xFF)),
        (system.list_files("/etc", 100), (10, 0, 0, 0, 0, 0xFF)),
        (system.continue_list_files(7, 100), (10, 0xFF)),
        (system.close_filehandle(7), (1, 7)),
        (system.create_dir("../none/below"), (5,)),
        (system.create_dir("../prjs"), (5,)),
        (system.delete_file("../none"), (5,)),
        (system.delete_file("/"), (5,)),
        (system.setbundleid("x" * 23), None),
    ],
)
def test_errors_keep_the_layout_of_the_reply(
    brick: Brick, message: SystemCommand, contents: tuple[int, ...] | None
) -> None:
    expected = (REPLY, b"\0") if contents is None else (ERROR, bytes(contents))
    assert answer(brick, message) == expected


@pytest.mark.parametrize(("code", "most"), [(0xA1, 23), (0xA2, 10)])
def test_bundle_names_have_their_room(brick: Brick, code: int, most: int) -> None:
    for length, expected in ((most, "03 {:02x} 00"), (most + 1, "05 {:02x} 09")):
        body = bytes((1, 0, 1, code)) + b"x" * length + b"\0"
        reply = brick.receive(len(body).to_bytes(2, "little") + body)
        assert [found.hex(" ") for found in reply] == ["05 00 01 00 " + expected.format(code)]


def test_the_size_of_an_upload_can_be_asked_without_data(brick: Brick, projects: Path) -> None:
    (projects / "a.rtf").write_bytes(b"abc")
    assert answer(brick, system.begin_upload("../prjs/a.rtf", 0)) == (REPLY, bytes((0, 3, 0, 0, 0, 0)))
    assert answer(brick, system.continue_upload(0, 2)) == (REPLY, bytes((0, 0)) + b"ab")
    assert answer(brick, system.close_filehandle(0)) == (REPLY, bytes((0, 0)))
    assert answer(brick, system.continue_upload(0, 2)) == (ERROR, bytes((1, 0xFF)))


def test_a_file_that_a_program_has_open_to_write_never_ends(brick: Brick, projects: Path) -> None:
    answer(brick, system.begin_download("../prjs/grow.rtf", 3))
    answer(brick, system.continue_download(0, b"abc"))
    assert answer(brick, system.begin_getfile("../prjs/grow.rtf", 10)) == (REPLY, bytes((8, 3, 0, 0, 0, 0)) + b"abc")


def test_a_listing(brick: Brick, projects: Path) -> None:
    (projects / "Demo").mkdir()
    (projects / "Demo" / "hello.rtf").write_bytes(b"hello")
    line = hashlib.md5(b"hello").hexdigest().upper().encode() + b" 00000005 hello.rtf\n"
    whole = line + b"../\n./\n"
    kind, contents = answer(brick, system.list_files("../prjs/Demo/", 10))
    assert (kind, contents) == (REPLY, bytes((0,)) + len(whole).to_bytes(4, "little") + b"\0" + whole[:10])
    kind, contents = answer(brick, system.continue_list_files(0, 1000))
    assert (kind, contents) == (REPLY, bytes((8, 0)) + whole[10:])
    assert answer(brick, system.continue_list_files(0, 1000)) == (ERROR, bytes((10, 0xFF)))


@pytest.mark.parametrize(
    ("path", "only"),
    [
        ("/", b"home"),
        ("/home", b"root"),
        ("/home/", b"root"),
        ("/home/root/", b"lms2012"),
        ("../..", b"lms2012"),
        ("/home/root/lms2012/../..", b"root"),
    ],
)
def test_the_folders_above_are_listed_and_nothing_else(brick: Brick, path: str, only: bytes) -> None:
    listing = only + b"/\n../\n./\n"
    size = len(listing).to_bytes(4, "little")
    assert answer(brick, system.list_files(path)) == (REPLY, b"\x08" + size + b"\0" + listing)
    assert run(brick, op("FILENAME.EXIST", path, GV(0)), globals=1) == (OK, b"\1")
    assert run(brick, op("FILE.GET_FOLDERS", path, GV(0)), globals=1) == (OK, b"\1")
    assert text(brick, op("FILE.GET_SUBFOLDER_NAME", path, 1, 20, GV(0))) == only
    assert answer(brick, system.create_dir(path.rstrip("/") + "/x"))[0] == ERROR
    assert answer(brick, system.delete_file(path))[0] == ERROR
    assert answer(brick, system.begin_upload(path))[0] == ERROR


def test_other_folders_outside_are_not_listed(brick: Brick) -> None:
    for path in ("/etc", "/home/x", "/root", "/homes", "", "/home/roo"):
        assert answer(brick, system.list_files(path))[0] == ERROR
    assert answer(Brick(), system.list_files("/"))[0] == ERROR


def test_folders_are_made_and_deleted_one_at_a_time(brick: Brick, projects: Path) -> None:
    assert answer(brick, system.create_dir("../prjs/New")) == (REPLY, b"\0")
    (projects / "New" / "file").write_bytes(b"")
    assert answer(brick, system.delete_file("../prjs/New")) == (ERROR, b"\x05")
    assert answer(brick, system.delete_file("../prjs/New/file")) == (REPLY, b"\0")
    assert answer(brick, system.delete_file("../prjs/New")) == (REPLY, b"\0")


def test_open_handles_are_always_zeros(brick: Brick) -> None:
    answer(brick, system.begin_download("../prjs/a.rtf", 3))
    assert answer(brick, system.list_open_handles()) == (REPLY, bytes(10))


def test_handles_are_the_lowest_free_and_run_out(brick: Brick) -> None:
    for number in range(64):
        message = system.begin_download(f"../prjs/{number}.rtf", 3)
        assert answer(brick, message) == (REPLY, bytes((0, number)))
    assert answer(brick, system.begin_download("../prjs/last.rtf", 3)) == (ERROR, bytes((4, 0xFF)))
    answer(brick, system.close_filehandle(5))
    assert answer(brick, system.begin_download("../prjs/last.rtf", 3)) == (REPLY, bytes((0, 5)))


def test_handles_of_a_connection_that_ends_are_freed(brick: Brick) -> None:
    brick.receive_from("one", system.begin_download("../prjs/a.rtf", 3).build())
    brick.disconnect("one")
    assert answer(brick, system.begin_download("../prjs/b.rtf", 3)) == (REPLY, bytes((0, 0)))


def test_handles_of_other_connections_stay(brick: Brick) -> None:
    brick.receive_from("one", system.begin_download("../prjs/a.rtf", 3).build())
    assert answer(brick, system.begin_download("../prjs/b.rtf", 3)) == (REPLY, bytes((0, 1)))
    brick.disconnect("one")
    assert answer(brick, system.continue_download(1, b"abc")) == (REPLY, bytes((8, 1)))


def test_what_has_no_reply(brick: Brick, projects: Path) -> None:
    assert brick.receive(system.begin_download("../prjs/a.rtf", 3, reply=False).build()) == []
    assert brick.receive(system.continue_download(0, b"abc", reply=False).build()) == []
    assert (projects / "a.rtf").read_bytes() == b"abc"
    for code in (0x9E, 0xA0, 0x42, 0xF6):
        assert brick.receive(bytes((4, 0, 0, 0, 1, code))) == []
    assert brick.receive(bytes((3, 0, 0, 0, 1))) == []


@pytest.mark.parametrize("code", range(0x92, 0xA3))
def test_commands_that_are_cut_short_are_answered_or_ignored(brick: Brick, code: int) -> None:
    for rest in (b"", b"\x01", b"\x01\x02", b"\x01\x02\x03\x04\x05"):
        body = bytes((0, 0, 1, code)) + rest
        assert len(brick.receive(len(body).to_bytes(2, "little") + body)) <= 1


# FILE


def test_texts_values_and_bytes_are_written_and_read(brick: Brick, projects: Path) -> None:
    write = (
        op("FILE.OPEN_WRITE", "../prjs/a.rtf", LV(0)),
        op("FILE.WRITE_TEXT", LV(0), "DEL_CRLF", "first"),
        op("FILE.WRITE_VALUE", LV(0), "DEL_COMMA", 1.5, 6, 2),
        op("FILE.WRITE_BYTES", LV(0), 2, b"\x84hi\0"),
        op("FILE.CLOSE", LV(0)),
        op("FILE.OPEN_APPEND", "../prjs/a.rtf", LV(0)),
        op("FILE.WRITE_TEXT", LV(0), "DEL_NONE", "!"),
    )
    assert run(brick, *write, locals=2)[0] == OK
    assert (projects / "a.rtf").read_bytes() == b"first\r\n  1.50,hi!"
    read = (
        op("FILE.OPEN_READ", "../prjs/a.rtf", LV(0), GV(0)),
        op("FILE.READ_TEXT", LV(0), "DEL_CRLF", 10, GV(4)),
        op("FILE.READ_VALUE", LV(0), "DEL_COMMA", GV(16)),
        op("FILE.READ_BYTES", LV(0), 8, GV(20)),
    )
    brick.receive(command(op("INIT_BYTES", GV(0), 32, [-1] * 32), reply=False))
    kind, memory = run(brick, *read, globals=28, locals=2)
    assert (kind, memory[:4], memory[4:12]) == (OK, (17).to_bytes(4, "little"), b"first\r\0\xff")
    assert (memory[16:20], memory[20:25]) == (bytes.fromhex("0000c03f"), b"hi!\0\xff")


@pytest.mark.parametrize(("count", "size"), [(0, 4), (1, 1), (6, 6)])
def test_an_array_gets_as_many_bytes_as_are_asked_for(brick: Brick, projects: Path, count: int, size: int) -> None:
    """Nothing is asked for by 0, so the array stays."""
    (projects / "a.rtf").write_bytes(b"abcdefgh")
    code = (
        op("ARRAY.CREATE8", 4, LV(0)),
        op("FILE.OPEN_READ", "../prjs/a.rtf", LV(2), LV(4)),
        op("FILE.READ_BYTES", LV(2), count, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(0)),
    )
    assert run(brick, *code, globals=4, locals=8) == (OK, size.to_bytes(4, "little"))


def test_a_text_stops_at_its_room(brick: Brick, projects: Path) -> None:
    (projects / "a.rtf").write_bytes(b"abcdef,gh")
    code = (
        op("FILE.OPEN_READ", "../prjs/a.rtf", LV(0), LV(4)),
        op("FILE.READ_TEXT", LV(0), "DEL_COMMA", 4, GV(0)),
        op("FILE.READ_TEXT", LV(0), "DEL_COMMA", 4, GV(4)),
        op("FILE.READ_TEXT", LV(0), "DEL_COMMA", 4, GV(8)),
        op("FILE.READ_TEXT", LV(0), "DEL_COMMA", 4, GV(12)),
    )
    kind, memory = run(brick, *code, globals=16, locals=8)
    assert kind == OK
    assert [memory[at : at + 4].partition(b"\0")[0] for at in (0, 4, 8, 12)] == [b"abcd", b"ef", b"gh", b""]


def test_a_missing_file_does_not_fail(brick: Brick) -> None:
    code = op("MOVE32_32", -1, GV(0)), op("FILE.OPEN_READ", "../prjs/none", GV(0), GV(4))
    kind, memory = run(brick, *code, op("INFO.GET_ERROR", GV(8)), globals=9)
    assert (kind, memory[:2], memory[4:]) == (OK, bytes(2), bytes(5))


@pytest.mark.parametrize(
    ("failing", "error"),
    [
        (op("FILE.OPEN_WRITE", "../none/a.rtf", LV(2)), 26),
        (op("FILE.CLOSE", 9), 29),
        (op("FILE.WRITE_TEXT", LV(0), 0, "x"), 28),
        (op("FILE.WRITE_TEXT", 9, 0, "x"), 28),
        (op("FILE.READ_BYTES", 9, 1, LV(2)), 27),
    ],
)
def test_failures_of_files(brick: Brick, projects: Path, failing: bytes, error: int) -> None:
    (projects / "a.rtf").write_bytes(b"abc")
    opened = op("FILE.OPEN_READ", "../prjs/a.rtf", LV(0), LV(4))
    assert run(brick, opened, failing, locals=8)[0] == FAIL
    assert run(brick, op("INFO.GET_ERROR", GV(0)), globals=1) == (OK, bytes((error,)))


def test_a_file_to_write_cannot_be_read(brick: Brick) -> None:
    code = op("FILE.OPEN_WRITE", "../prjs/a.rtf", LV(0)), op("FILE.READ_BYTES", LV(0), 1, LV(2))
    assert run(brick, *code, locals=4)[0] == FAIL
    assert run(brick, op("INFO.GET_ERROR", GV(0)), globals=1) == (OK, bytes((27,)))


def test_closing_frees_arrays_too(brick: Brick) -> None:
    code = op("ARRAY.CREATE8", 4, LV(0)), op("FILE.CLOSE", LV(0)), op("ARRAY.SIZE", LV(0), GV(0))
    assert run(brick, *code, globals=4, locals=2) == (OK, bytes(4))


def test_forbidden_characters_become_underscores_before_opening(brick: Brick, projects: Path) -> None:
    assert run(brick, op("FILE.OPEN_WRITE", "../prjs/a*b.rtf", LV(0)), locals=2)[0] == OK
    assert (projects / "a_b.rtf").exists()
    assert run(brick, op("INFO.GET_ERROR", GV(0)), globals=1) == (OK, bytes((31,)))


def test_a_system_command_with_a_forbidden_name_leaves_an_error(brick: Brick) -> None:
    for command_ in (system.begin_upload("../prjs/a*b.rtf"), system.begin_download("../prjs/a*b.rtf", 1)):
        brick.receive(command_.build())
        assert run(brick, op("INFO.GET_ERROR", GV(0)), globals=1) == (OK, bytes((31,)))
        assert run(brick, op("INFO.GET_ERROR", GV(0)), globals=1) == (OK, bytes(1))


@pytest.mark.parametrize("name", ["../prjs/a.abcd", "../prjs/" + "n" * 32, "../" + "f" * 90 + "/a"])
def test_a_name_that_is_too_long_is_tried_for_ever(brick: Brick, name: str) -> None:
    assert brick.receive(command(op("FILE.OPEN_WRITE", name, LV(0)), locals=2)) == []
    assert brick.advance(1) == []


def test_folders(brick: Brick, projects: Path) -> None:
    code = (
        op("FILE.MAKE_FOLDER", "../prjs/New/", GV(0)),
        op("FILE.MAKE_FOLDER", "../prjs/New", GV(1)),
        op("FILE.MAKE_FOLDER", "../none/New", GV(2)),
    )
    assert run(brick, *code, globals=3) == (OK, bytes((1, 1, 0)))
    for name in ("b.rtf", "a.rtf", "z.rbf", "Sub", ".hidden", "CVS"):
        (projects / "New" / name).mkdir() if name == "Sub" else (projects / "New" / name).write_bytes(b"x")
    assert run(brick, op("FILE.GET_FOLDERS", "../prjs/New/", GV(0)), globals=1) == (OK, b"\x04")
    names = [text(brick, op("FILE.GET_SUBFOLDER_NAME", "../prjs/New/", item, 10, GV(0))) for item in range(1, 6)]
    assert names == [b"z", b"a", b"b", b"Sub", b""]
    assert run(brick, op("FILE.GET_ITEM", "../prjs/New/", "b", GV(0)), globals=1) == (OK, b"\x03")
    assert run(brick, op("FILE.DEL_SUBFOLDER", "../prjs/New/", 4))[0] == OK
    assert not (projects / "New" / "Sub").exists()


def test_removing_takes_a_folder_with_its_direct_files(brick: Brick, projects: Path) -> None:
    (projects / "Old").mkdir()
    (projects / "Old" / "a").write_bytes(b"x")
    assert run(brick, op("FILE.REMOVE", "../prjs/Old"))[0] == OK
    assert not (projects / "Old").exists()


def test_moving_copies(brick: Brick, projects: Path) -> None:
    (projects / "From" / "Below").mkdir(parents=True)
    (projects / "From" / "Below" / "a").write_bytes(b"x")
    (projects / "To").mkdir()
    (projects / "To" / "old").write_bytes(b"y")
    assert run(brick, op("FILE.MOVE", "../prjs/From", "../prjs/To"))[0] == OK
    assert (projects / "From" / "Below" / "a").read_bytes() == b"x"
    assert (projects / "To" / "Below" / "a").read_bytes() == b"x"
    assert not (projects / "To" / "old").exists()


def test_recent_files(brick: Brick) -> None:
    for number in range(12):
        run(brick, op("FILE.PUT_CACHE_FILE", f"../prjs/{number}"))
    run(brick, op("FILE.PUT_CACHE_FILE", "../prjs/5"), op("FILE.DEL_CACHE_FILE", "../prjs/4"))
    assert run(brick, op("FILE.GET_CACHE_FILES", GV(0)), globals=1) == (OK, b"\x09")
    assert text(brick, op("FILE.GET_CACHE_FILE", 1, 20, GV(0))) == b"../prjs/5"
    assert text(brick, op("FILE.GET_CACHE_FILE", 10, 20, GV(0))) == b""


def test_the_handle_of_an_open_file(brick: Brick, projects: Path) -> None:
    code = (
        op("FILE.OPEN_WRITE", "../prjs/a.rtf", LV(0)),
        op("FILE.GET_HANDLE", "../prjs/a.rtf", GV(0), GV(2)),
        op("FILE.GET_HANDLE", "../prjs/b.rtf", GV(4), GV(3)),
    )
    assert run(brick, *code, globals=6, locals=2) == (OK, bytes((1, 0, 1, 0, 0xFF, 0xFF)))


@pytest.mark.parametrize(
    ("code", "memory"),
    [
        (op("FILE.OPEN_WRITE", "../none/a.rtf", GV(0)), bytes((0, 0, 9, 9))),
        (op("FILE.READ_VALUE", 7, "DEL_NONE", GV(0)), bytes(4)),
        (op("FILE.GET_POOL", 0, GV(0), GV(4)), bytes((0xFF, 0xFF, 9, 9))),
        (op("FILE.GET_CACHE_FILE", 0, 4, GV(0)), bytes((9, 9, 9, 9))),
        (op("FILE.GET_CACHE_FILE", 11, 4, GV(0)), bytes((9, 9, 9, 9))),
        (op("ARRAY.CREATE8", 7_000_000, GV(0)), bytes((0xFF, 0xFF, 9, 9))),
        (op("ARRAY.READ_CONTENT", -1, 7, 0, 4, GV(0)), bytes((9, 9, 9, 9))),
    ],
)
def test_what_a_failure_leaves_in_memory(brick: Brick, code: bytes, memory: bytes) -> None:
    brick.receive(command(op("INIT_BYTES", GV(0), 4, [9] * 4), reply=False))
    assert run(brick, code, globals=4) == (FAIL, memory)


def test_an_unknown_delimiter_fails_after_the_text(brick: Brick, projects: Path) -> None:
    code = op("FILE.OPEN_WRITE", "../prjs/a.rtf", LV(0)), op("FILE.WRITE_TEXT", LV(0), 8, "text")
    assert run(brick, *code, locals=2)[0] == FAIL
    assert (projects / "a.rtf").read_bytes() == b"text"


def test_a_subfolder_is_deleted_by_what_its_name_shows(brick: Brick, projects: Path) -> None:
    (projects / "Old").mkdir()
    (projects / "Old" / "a.rtf").write_bytes(b"x")
    run(brick, op("FILE.DEL_SUBFOLDER", "../prjs/Old/", 1))
    assert (projects / "Old" / "a.rtf").exists()
    run(brick, op("FILE.DEL_SUBFOLDER", "../prjs/", 1))
    assert not (projects / "Old").exists()


def test_removed_files_leave_the_list_of_recent_ones(brick: Brick, projects: Path) -> None:
    (projects / "a.rtf").write_bytes(b"x")
    code = (
        op("FILE.PUT_CACHE_FILE", "../prjs/a.rtf"),
        op("FILE.REMOVE", "../prjs/a.rtf"),
        op("FILE.GET_CACHE_FILES", GV(0)),
    )
    assert run(brick, *code, globals=1) == (OK, b"\0")


def test_making_a_folder_where_a_file_is_counts_as_done(brick: Brick, projects: Path) -> None:
    (projects / "a").write_bytes(b"x")
    assert run(brick, op("FILE.MAKE_FOLDER", "../prjs/a", GV(0)), globals=1) == (OK, b"\1")


def test_a_name_that_is_not_allowed_leaves_size_and_address(brick: Brick) -> None:
    brick.receive(command(op("INIT_BYTES", GV(0), 8, [9] * 8), reply=False))
    assert run(brick, op("FILE.LOAD_IMAGE", 1, "../prjs/a:b", GV(0), GV(4)), globals=8) == (OK, bytes([9] * 8))


def test_a_file_is_found_by_the_name_that_opened_it(brick: Brick) -> None:
    code = (
        op("FILE.OPEN_WRITE", "a.rtf", LV(0)),
        op("FILE.GET_HANDLE", "../sys/a.rtf", GV(0), GV(2)),
        op("FILE.GET_HANDLE", "a.rtf", GV(4), GV(3)),
    )
    assert run(brick, *code, globals=6, locals=2) == (OK, bytes((0xFF, 0xFF, 0, 1, 1, 0)))


def test_moving_a_missing_file_empties_the_target(brick: Brick, projects: Path) -> None:
    (projects / "a.rtf").write_bytes(b"x")
    assert run(brick, op("FILE.MOVE", "../prjs/none.rtf", "../prjs/a.rtf"))[0] == OK
    assert not (projects / "a.rtf").exists()


def test_a_path_that_is_put_together_is_cut(brick: Brick) -> None:
    code = op("FILENAME.MERGE", "f" * 100, "n" * 30, ".rtf", -1, GV(0)), op("STRINGS.GET_SIZE", GV(0), GV(200))
    assert run(brick, *code, globals=202)[1][200] == 118


def test_arrays_take_all_of_a_path(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 1, LV(0)),
        op("FILENAME.MERGE", "../prjs", "name", ".rtf", 3, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(0)),
        op("STRINGS.DUPLICATE", LV(0, handle=True), GV(4)),
    )
    assert run(brick, *code, globals=21, locals=2) == (OK, (17).to_bytes(4, "little") + b"../prjs/name.rtf\0")


@pytest.mark.parametrize("pin", [b"1234\0", b"1234", b"123456789"])
def test_a_pin_comes_back_with_the_address(brick: Brick, pin: bytes) -> None:
    """As many bytes of it as the request counts, with a zero or without."""
    body = b"\x01\0\x01\x9f\x0d0016533f0c1e\0" + bytes((len(pin),)) + pin
    (reply,) = brick.receive(len(body).to_bytes(2, "little") + body)
    assert reply[4:] == bytes((REPLY, 0x9F, 12, 13)) + b"0016530f0c1e\0" + bytes((len(pin),)) + pin


def test_a_download_leaves_room(brick: Brick) -> None:
    most = 5700 * 1024
    assert answer(brick, system.begin_download("../prjs/big.rtf", most))[1] == bytes((0, 0))
    assert answer(brick, system.begin_download("../prjs/big.rtf", most + 1)) == (ERROR, bytes((9, 0xFF)))


@pytest.mark.parametrize(("interval", "handle"), [(10, 1), (9, 2)], ids=["written as it comes", "gathered in memory"])
def test_a_data_log(brick: Brick, projects: Path, interval: int, handle: int) -> None:
    code = (
        op("FILE.OPEN_LOG", "../prjs/log", 1, 2, 3, interval, 1000, "x", LV(0)),
        op("MOVEF_F", 0.5, LV(4)),
        op("FILE.WRITE_LOG", LV(0), 5, 1, LV(4)),
        op("MOVE16_16", LV(0), GV(20)),
        op("FILE.GET_LOG_NAME", 20, GV(0)),
        op("FILE.CLOSE_LOG", LV(0), "../prjs/log"),
    )
    kind, memory = run(brick, *code, globals=22, locals=8)
    assert (kind, memory.partition(b"\0")[0], memory[20]) == (OK, b"../prjs/log.rdf", handle)
    head = b"Sync data\t1\t2\t3\t%d\t1000\r\nx" % interval
    row = struct.pack("<ff", 5.0, 0.5)
    assert (projects / "log.rdf").read_bytes() == head + row + b"\xff" * 8


@pytest.mark.parametrize(("items", "size"), [(-1, 0), (0, 0), (1, 8), (2, 12)])
def test_a_row_of_a_data_log_has_samples(brick: Brick, projects: Path, items: int, size: int) -> None:
    code = (
        op("FILE.OPEN_LOG", "../prjs/log", 1, 2, 3, 10, 1000, "", LV(0)),
        op("FILE.WRITE_LOG", LV(0), 5, items, LV(4)),
        op("FILE.CLOSE_LOG", LV(0), "../prjs/log"),
    )
    assert run(brick, *code, locals=12)[0] == OK
    rows = (projects / "log.rdf").read_bytes().partition(b"1000\r\n")[2].removesuffix(b"\xff" * 8)
    assert len(rows) == size


def test_logging_never_fails(brick: Brick) -> None:
    code = (
        op("FILE.WRITE_LOG", 7, 0, 1, GV(0)),
        op("FILE.CLOSE_LOG", 7, "../prjs/log"),
        op("INFO.GET_ERROR", GV(0)),
        op("INFO.GET_ERROR", GV(1)),
        op("INFO.GET_ERROR", GV(2)),
    )
    assert run(brick, *code, globals=4) == (OK, bytes((28, 28, 29, 0)))


def test_synchronised_time(brick: Brick) -> None:
    code = op("FILE.SET_LOG_SYNC_TIME", 5, 6), op("FILE.GET_LOG_SYNC_TIME", GV(0), GV(4))
    assert run(brick, *code, globals=8) == (OK, bytes((5, 0, 0, 0, 6, 0, 0, 0)))


def test_a_missing_image_does_not_fail(brick: Brick) -> None:
    code = op("FILE.LOAD_IMAGE", 1, "../prjs/none", GV(0), GV(4))
    assert run(brick, op("INIT_BYTES", GV(0), 8, [9] * 8), code, globals=8) == (OK, bytes(8))


# FILENAME


@pytest.mark.parametrize(
    ("path", "parts"),
    [
        ("../prjs/Demo/a.b.c", (b"../prjs/Demo/", b"a", b".b.c")),
        ("name", (b"", b"name", b"")),
        ("./ui/x.rsf", (b"./ui/", b"x", b".rsf")),
    ],
)
def test_splitting(brick: Brick, path: str, parts: tuple[bytes, ...]) -> None:
    code = op("FILENAME.SPLIT", path, 20, GV(0), GV(20), GV(40))
    assert tuple(text(brick, code, at=at) for at in (0, 20, 40)) == parts


def test_merging_always_puts_a_slash(brick: Brick) -> None:
    assert text(brick, op("FILENAME.MERGE", "../prjs/", "a", ".rtf", 40, GV(0))) == b"../prjs//a.rtf"
    assert text(brick, op("FILENAME.MERGE", "", "a", "", 3, GV(0))) == b"/a"


@pytest.mark.parametrize(
    ("name", "is_allowed"),
    [("../prjs/a.rbf", 1), ("a b~-_.rtf", 1), ("a.abcd", 0), ("a*b", 0), ("n" * 31, 1), ("n" * 32, 0)],
)
def test_checking(brick: Brick, name: str, is_allowed: int) -> None:
    assert run(brick, op("FILENAME.CHECK", name, GV(0)), globals=1) == (OK, bytes((is_allowed,)))


def test_what_is_there_and_how_much(brick: Brick, projects: Path) -> None:
    (projects / "a.rtf").write_bytes(bytes(1025))
    code = (
        op("FILENAME.EXIST", "../prjs/a.rtf", GV(0)),
        op("FILENAME.EXIST", "../prjs", GV(1)),
        op("FILENAME.EXIST", "../none", GV(2)),
        op("FILENAME.EXIST", "/etc/passwd", GV(3)),
        op("FILENAME.TOTALSIZE", "../prjs/a.rtf", GV(4), GV(8)),
        op("FILENAME.TOTALSIZE", "../prjs", GV(12), GV(16)),
    )
    numbers = [0, 2, 3, 2]
    expected = bytes((1, 1, 0, 0)) + b"".join(number.to_bytes(4, "little") for number in numbers)
    assert run(brick, *code, globals=20) == (OK, expected)


def test_archives_come_back_as_they_were(brick: Brick, projects: Path) -> None:
    (projects / "Demo" / "Below").mkdir(parents=True)
    (projects / "Demo" / "Below" / "a").write_bytes(b"hello")
    assert run(brick, op("FILENAME.PACK", "../prjs/Demo"))[0] == OK
    assert (projects / "Demo.raf").exists()
    (projects / "Demo" / "Below" / "a").write_bytes(b"changed")
    assert run(brick, op("FILENAME.UNPACK", "../prjs/Demo"))[0] == OK
    assert (projects / "Demo" / "Below" / "a").read_bytes() == b"hello"


# Nothing outside


@pytest.fixture
def secret(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("outside") / "secret"
    path.write_bytes(b"secret")
    return path


def test_links_are_listed_as_folders_and_never_followed(brick: Brick, projects: Path, secret: Path) -> None:
    (projects / "link").symlink_to(secret)
    (projects / "way").symlink_to(secret.parent)
    assert b"link/\n" in answer(brick, system.list_files("../prjs", 1000))[1]
    assert answer(brick, system.begin_upload("../prjs/link", 100))[1][0] == 1
    assert answer(brick, system.begin_upload("../prjs/way/secret", 100))[1][0] == 1
    assert answer(brick, system.begin_download("../prjs/link", 3))[1][0] == 1
    assert answer(brick, system.list_files("../prjs/way", 100))[1][0] == 10
    assert run(brick, op("FILE.OPEN_WRITE", "../prjs/link", LV(0)), locals=2)[0] == FAIL
    assert answer(brick, system.delete_file("../prjs/link")) == (REPLY, b"\0")
    assert secret.read_bytes() == b"secret"


def test_pipes_are_neither_opened_nor_listed(brick: Brick, projects: Path) -> None:
    os.mkfifo(projects / "pipe")
    assert b"pipe" not in answer(brick, system.list_files("../prjs", 1000))[1]
    assert answer(brick, system.begin_upload("../prjs/pipe", 100))[1][0] == 1
    assert answer(brick, system.begin_download("../prjs/pipe", 3))[1][0] == 1


def test_archives_with_names_that_lead_outside_are_not_unpacked(brick: Brick, projects: Path) -> None:
    import io
    import tarfile

    for name, kind in (("../../evil", tarfile.REGTYPE), ("/evil", tarfile.REGTYPE), ("way", tarfile.SYMTYPE)):
        with tarfile.open(projects / "x.raf", "w:gz") as archive:
            entry = tarfile.TarInfo(name)
            entry.type, entry.linkname, entry.size = kind, "/etc", 1 if kind == tarfile.REGTYPE else 0
            archive.addfile(entry, io.BytesIO(b"x"))
        assert run(brick, op("FILENAME.UNPACK", "../prjs/x"))[0] == OK
        assert sorted(path.name for path in projects.iterdir()) == ["x.raf"]
    assert not (projects.parent / "evil").exists()


@pytest.mark.parametrize("name", ["a/" * 17 + "b", "a/" * 600, "/".join(["n" * 63] * 4) + "x"])
def test_archives_with_long_or_deep_names_are_not_unpacked(brick: Brick, projects: Path, name: str) -> None:
    import io
    import tarfile

    with tarfile.open(projects / "x.raf", "w:gz") as archive:
        entry = tarfile.TarInfo(name)
        entry.size = 1
        archive.addfile(entry, io.BytesIO(b"x"))
    assert run(brick, op("FILENAME.UNPACK", "../prjs/x"))[0] == OK
    assert sorted(path.name for path in projects.iterdir()) == ["x.raf"]


def test_archives_with_hostile_headers_are_refused_at_once(brick: Brick, projects: Path) -> None:
    """A length of 88 bits, digits in place of a name, and a chain of names, on which a TarFile of Python fails."""
    import gzip
    import tarfile
    import time

    def header(kind: bytes, contents: bytes = b"") -> bytes:
        entry = tarfile.TarInfo("x")
        entry.type, entry.size = kind, len(contents)
        return entry.tobuf() + contents + bytes(-len(contents) % tarfile.BLOCKSIZE)

    plain = bytearray(header(tarfile.GNUTYPE_LONGNAME))
    plain[124:136] = b"\x80" + b"\x7f" * 11
    plain[148:156] = b"%06o\0 " % (sum(plain[:148]) + 8 * 0x20 + sum(plain[156:]))
    for head in (bytes(plain), header(tarfile.XHDTYPE, b"1" * 60_000), header(tarfile.GNUTYPE_LONGNAME) * 5_000):
        (projects / "x.raf").write_bytes(gzip.compress(head + header(tarfile.DIRTYPE) + bytes(1024)))
        begun = time.thread_time()
        assert run(brick, op("FILENAME.UNPACK", "../prjs/x"))[0] == OK
        assert time.thread_time() - begun < 0.5
        assert {path.name for path in projects.iterdir()} <= {"x.raf", "x"}


def test_a_full_folder_takes_no_more(tmp_path: Path) -> None:
    storage = Storage(tmp_path, quota=10)
    file = storage.open_to_write(b"../prjs/a")
    assert file is not None
    with file:
        assert file.put(b"12345678")
        assert not file.put(b"123")
    assert Storage(tmp_path, quota=10).free == 2
    assert storage.delete(b"../prjs/a")
    assert storage.free == 10


def test_a_brick_without_a_folder_has_no_files() -> None:
    brick = Brick()
    assert answer(brick, system.list_files("../prjs", 100))[1][0] == 10
    assert answer(brick, system.begin_download("../prjs/a.rtf", 3))[1][0] == 1

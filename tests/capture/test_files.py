"""Files reassembled from a capture: their bytes, their names, and that nothing else is touched."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from support.cli import run_ev3proto_text
from support.effort import effort

import ev3proto
from ev3proto import SystemStatus
from ev3proto.capture import Carrier, Event, Record, Route, read
from ev3proto.capture import files as module
from ev3proto.capture.files import FileState, RecoveredFile, recover, survey
from ev3proto.capture.record import CaptureError
from ev3proto.capture.safe_paths import MOST_BYTES, parts_of, safe_name
from ev3proto.capture.timeline import MarkState, collect
from ev3proto.dialogue import Dialogue
from ev3proto.messages import FieldValue, Message
from ev3proto.schema.frame import frame_reader

CAPTURES = Path(__file__).parents[2] / "captures"

CONTENTS = "47720ad53d60d2a2b17377501929f739f02a3bb7a7d8c07284bc48f505d3852d"
"""SHA-256 of 2710 bytes: lines of numbers, as a data log has them."""

IMAGE = "de81ab23fa9ca98471ad147225e394d30170c68c684e4fb8e28103c559a94433"
"""SHA-256 of 2500 bytes: the start of a program, then bytes by a rule."""


class Brick:
    """A computer and a brick that transfer files, recorded as a capture."""

    def __init__(self, peer: str = "1.7", handle: int = 0) -> None:
        self.peer = peer
        self.handle = handle
        self.events: list[Event] = []
        self._dialogue = Dialogue()
        self._requests: dict[Message, Record] = {}
        self._counter = 0

    def says(self, message: Message) -> None:
        exchange = self._dialogue.follow(message)
        route = Route(Carrier.USB, "host", self.peer, None, None, self.peer)
        number = len(self.events) + 1
        request = None if exchange.request is None else self._requests[exchange.request]
        record = Record(message.build(), (number,), number, route, frame_reader(), request, exchange.transfer)
        self._requests[message] = record
        self.events.append(record)

    def exchange(
        self, name: str | int, status: int = 0, answer: dict[str, FieldValue] | None = None, **asked: FieldValue
    ) -> None:
        self._counter += 1
        self.says(ev3proto.system_command(name, counter=self._counter, reply=True, **asked))
        failed = SystemStatus(status).is_failure
        self.says(ev3proto.system_reply(name, counter=self._counter, status=status, error=failed, **(answer or {})))

    def upload(self, path: str, *pieces: bytes, size: int | None = None) -> None:
        """A file from the brick. With a larger size, the transfer ends early."""
        first, *rest = pieces
        whole = sum(map(len, pieces)) if size is None else size
        self.exchange(
            "BEGIN_UPLOAD", 0, {"size": whole, "handle": self.handle, "data": first}, max_bytes=1000, path=path
        )
        for piece in rest:
            self.exchange(
                "CONTINUE_UPLOAD", 0, {"handle": self.handle, "data": piece}, handle=self.handle, max_bytes=1000
            )

    def download(self, path: str, *pieces: bytes) -> None:
        """A file to the brick."""
        self.exchange("BEGIN_DOWNLOAD", 0, {"handle": self.handle}, size=sum(map(len, pieces)), path=path)
        for piece in pieces:
            self.exchange("CONTINUE_DOWNLOAD", 0, {"handle": self.handle}, handle=self.handle, data=piece)


def written(folder: Path) -> dict[str, bytes]:
    """All files below a folder, by their paths in it."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()
    }


def told(found: Iterator[RecoveredFile] | list[RecoveredFile]) -> list[tuple[str, int, str]]:
    return [(file.path, file.bytes, file.outcome.value) for file in found]


# Contents


def test_data_in_the_first_command_are_the_first_of_the_file(tmp_path: Path) -> None:
    brick = Brick()
    brick.exchange("BEGIN_DOWNLOAD", 8, {"handle": 0}, size=5, path="../prjs/q/a.txt", data=b"hello")
    brick.exchange("BEGIN_DOWNLOAD", 0, {"handle": 0}, size=5, path="../prjs/q/b.txt", data=b"he")
    brick.exchange("CONTINUE_DOWNLOAD", 8, {"handle": 0}, handle=0, data=b"llo")
    found = list(recover(brick.events, tmp_path))
    assert told(found) == [("../prjs/q/a.txt", 5, "complete"), ("../prjs/q/b.txt", 5, "complete")]
    assert written(tmp_path) == {"prjs/q/a.txt": b"hello", "prjs/q/b.txt": b"hello"}


def test_a_file_in_one_long_command(tmp_path: Path) -> None:
    brick, contents = Brick(), bytes(range(256)) * 5
    brick.download("../prjs/q/program.rbf", contents)
    assert told(recover(brick.events, tmp_path)) == [("../prjs/q/program.rbf", 1280, "complete")]
    assert written(tmp_path) == {"prjs/q/program.rbf": contents}


def test_files_both_ways(tmp_path: Path) -> None:
    brick = Brick()
    brick.download("../prjs/hello/hello.rbf", b"LEGO", b"", b"\x00\x01")
    brick.upload("../prjs/hello/log.rtf", b"1;2\r\n", b"3;4\r\n")
    first, second = recover(brick.events, tmp_path)
    assert written(tmp_path) == {"prjs/hello/hello.rbf": b"LEGO\x00\x01", "prjs/hello/log.rtf": b"1;2\r\n3;4\r\n"}
    assert first == RecoveredFile(
        "../prjs/hello/hello.rbf",
        "BEGIN_DOWNLOAD",
        "to brick",
        "1.7",
        6,
        6,
        FileState.COMPLETE,
        None,
        (1, 8),
        tmp_path / "prjs/hello/hello.rbf",
    )
    assert (second.command, second.direction, second.packets) == ("BEGIN_UPLOAD", "from brick", (9, 12))


def test_a_complete_file_takes_no_more(tmp_path: Path) -> None:
    """If the reply to the next file's beginning is missing, its pieces have the handle of the file before."""
    brick = Brick()
    brick.download("../prjs/first.rtf", b"ab")
    brick.says(ev3proto.system_command("BEGIN_DOWNLOAD", counter=9, reply=True, size=2, path="../prjs/second.rtf"))
    brick.says(ev3proto.system_command("CONTINUE_DOWNLOAD", counter=10, reply=True, handle=0, data=b"cd"))
    found = told(recover(brick.events, tmp_path))
    assert found == [
        ("../prjs/first.rtf", 2, "complete"),
        ("../prjs/second.rtf", 0, "incomplete"),
        ("handle 0, its path was not captured", 2, "incomplete"),
    ]
    assert (tmp_path / "prjs/first.rtf").read_bytes() == b"ab"


def test_a_survey_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    brick = Brick()
    brick.upload("a", b"1")
    (found,) = survey(brick.events)
    assert (found.path, found.bytes, found.outcome, found.file) == ("a", 1, FileState.COMPLETE, None)
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_is_empty(tmp_path: Path) -> None:
    brick = Brick()
    brick.download("empty.txt")
    assert told(recover(brick.events, tmp_path)) == [("empty.txt", 0, "complete")]
    assert written(tmp_path) == {"empty.txt": b""}


def test_a_file_that_grows_while_it_is_fetched(tmp_path: Path) -> None:
    brick = Brick()
    brick.exchange("BEGIN_GETFILE", 0, {"size": 4, "handle": 0, "data": b"1234"}, max_bytes=4, path="log.rdf")
    brick.exchange("CONTINUE_GETFILE", 0, {"size": 6, "handle": 0, "data": b"56"}, handle=0, max_bytes=4)
    assert told(recover(brick.events, tmp_path)) == [("log.rdf", 6, "complete")]
    assert written(tmp_path) == {"log.rdf": b"123456"}


def test_what_is_not_whole(tmp_path: Path) -> None:
    brick = Brick()
    brick.upload("../prjs/long.rtf", b"12345", size=10)
    brick.exchange("BEGIN_DOWNLOAD", SystemStatus.ILLEGAL_PATH, size=3, path="/none/a")
    brick.exchange("BEGIN_DOWNLOAD", 0, {"handle": 1}, size=9, path="full.rtf")
    brick.exchange("CONTINUE_DOWNLOAD", 0, {"handle": 1}, handle=1, data=b"123")
    brick.exchange("CONTINUE_DOWNLOAD", SystemStatus.SIZE_ERROR, {"handle": 1}, handle=1, data=b"45")
    brick.exchange("BEGIN_DOWNLOAD", 0, {"handle": 2}, size=2, path="twice.rtf")
    brick.exchange("CONTINUE_DOWNLOAD", 0, {"handle": 2}, handle=2, data=b"abc")
    found = list(recover(brick.events, tmp_path))
    assert [(file.path, file.outcome.value, file.trouble) for file in found] == [
        ("../prjs/long.rtf", "incomplete", "5 of 10 bytes were captured"),
        ("/none/a", "refused", "the brick refused it: ILLEGAL_PATH"),
        ("full.rtf", "incomplete", "5 of 9 bytes were moved, then the brick said SIZE_ERROR"),
        ("twice.rtf", "incomplete", "it has 2 bytes, but 3 were moved"),
    ]
    assert written(tmp_path) == {
        "prjs/long.rtf.part": b"12345",
        "full.rtf.part": b"12345",
        "twice.rtf.part": b"abc",
    }


def test_a_piece_that_was_asked_for_again(tmp_path: Path) -> None:
    brick = Brick()
    brick.exchange("BEGIN_UPLOAD", 0, {"size": 4, "handle": 3, "data": b"12"}, max_bytes=2, path="a")
    brick.says(ev3proto.system_command("CONTINUE_UPLOAD", counter=90, handle=3, max_bytes=2))
    brick.says(ev3proto.system_command("CONTINUE_UPLOAD", counter=91, handle=3, max_bytes=2))
    brick.says(ev3proto.system_reply("CONTINUE_UPLOAD", counter=91, handle=3, data=b"34"))
    # Closing a handle that is already closed is an error that does not affect the file.
    brick.exchange("CLOSE_FILEHANDLE", SystemStatus.UNKNOWN_HANDLE, handle=3)
    assert told(recover(brick.events, tmp_path)) == [("a", 4, "complete")]


def test_pieces_whose_beginning_was_not_captured(tmp_path: Path) -> None:
    brick = Brick()
    brick.upload("lost", b"1", b"2", b"3")
    other = Brick()
    for event in brick.events[2:]:
        assert isinstance(event, Record)
        other.says(event.message)
    (found,) = recover(other.events, tmp_path)
    assert (found.path, found.command, found.size) == ("handle 0, its path was not captured", None, None)
    assert found.trouble == "2 bytes of it were captured"
    assert written(tmp_path) == {"handle-0.part": b"23"}


def test_a_handle_of_several_unknown_files(tmp_path: Path) -> None:
    brick = Brick()
    for data in (b"one", b"two"):
        # Only replies: none of their commands was captured.
        brick.says(ev3proto.system_reply("BEGIN_UPLOAD", size=3, handle=0, data=data[:1]))
        brick.says(ev3proto.system_reply("CONTINUE_UPLOAD", status=8, handle=0, data=data[1:]))
    assert [file.outcome for file in recover(brick.events, tmp_path)] == [
        FileState.COMPLETE,
        FileState.COMPLETE,
    ]
    assert written(tmp_path) == {"handle-0": b"one", "handle-0 (2)": b"two"}


def test_listings_on_demand(tmp_path: Path) -> None:
    brick = Brick()
    listing: dict[str, FieldValue] = {"list_size": 6, "handle": 0, "list": "a/\nb/\n"}
    brick.exchange("LIST_FILES", 0, listing, max_bytes=100, path="../prjs/log/")
    brick.exchange("LIST_FILES", 0, listing, max_bytes=100, path="/")
    assert list(recover(brick.events, tmp_path)) == []
    assert told(recover(brick.events, tmp_path, listings=True)) == [
        ("../prjs/log/", 6, "complete"),
        ("/", 6, "complete"),
    ]
    assert written(tmp_path) == {"prjs/log/listing.txt": b"a/\nb/\n", "listing.txt": b"a/\nb/\n"}


def test_two_bricks_have_a_folder_each(tmp_path: Path) -> None:
    one, other = Brick("192.0.2.10:5555"), Brick("192.0.2.11:5555")
    one.upload("../prjs/a", b"1")
    other.upload("../prjs/a", b"2")
    list(recover([*one.events, *other.events], tmp_path))
    assert written(tmp_path) == {"192.0.2.10_5555/prjs/a": b"1", "192.0.2.11_5555/prjs/a": b"2"}


def test_many_files_at_once(tmp_path: Path) -> None:
    bricks = [Brick(handle=number) for number in range(10)]
    for number, brick in enumerate(bricks):
        brick.upload(str(number), b"ab", b"cd", b"ef")
    # One piece of each, in turn.
    mixed = [event for events in zip(*(brick.events for brick in bricks), strict=True) for event in events]
    list(recover(mixed, tmp_path))
    assert written(tmp_path) == {str(number): b"abcdef" for number in range(10)}


def test_the_limit_of_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_FILES", 2)
    brick = Brick()
    for number in range(4):
        brick.upload(str(number), b"x")
    found = recover(brick.events, tmp_path)
    assert [next(found).path, next(found).path] == ["0", "1"]
    with pytest.raises(CaptureError, match="more than 2 files"):
        next(found)
    assert written(tmp_path) == {"0": b"x", "1": b"x"}


def test_a_capture_that_is_damaged(tmp_path: Path) -> None:
    brick = Brick()
    brick.upload("a", b"x")

    def events() -> Iterator[Event]:
        yield from brick.events
        raise CaptureError("the file ends inside a packet")

    found = recover(events(), tmp_path)
    assert next(found).path == "a"
    with pytest.raises(CaptureError, match="ends inside"):
        next(found)
    assert written(tmp_path) == {"a": b"x"}


def test_a_reader_who_loses_interest_leaves_no_rubbish(tmp_path: Path) -> None:
    brick = Brick()
    brick.upload("a", b"x")
    brick.upload("b", b"x")
    found = recover(brick.events, tmp_path)
    next(found)
    del found
    assert written(tmp_path) == {"a": b"x"}
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


# Names


@pytest.mark.parametrize(
    ("path", "parts"),
    [
        ("../prjs/hello/hello.rbf", ("prjs", "hello", "hello.rbf")),
        ("/home/root/lms2012/prjs/hello/hello.rbf", ("prjs", "hello", "hello.rbf")),
        ("hello.rbf", ("hello.rbf",)),
        ("/mnt/ramdisk/prjs/a", ("mnt", "ramdisk", "prjs", "a")),
        ("../../etc/passwd", ("etc", "passwd")),
        ("../prjs/../../../etc/passwd", ("etc", "passwd")),
        ("a/./b//c/", ("a", "b", "c")),
        ("..\\..\\windows\\system.ini", ("windows", "system.ini")),
        ("C:\\autoexec.bat", ("C_", "autoexec.bat")),
        ("a\0b", ("a_b",)),
        ("a\x1b[2Jb", ("a_[2Jb",)),
        ("", ("unnamed",)),
        ("..", ("unnamed",)),
        ("/home/root/lms2012", ("unnamed",)),
        ("...", ("___",)),
        ("a. ", ("a__",)),
        (" .. /a", ("___", "a")),
        ("nul", ("_nul",)),
        ("Con.rbf", ("_Con.rbf",)),
        (" lpt1", ("_lpt1",)),
        ("console", ("console",)),
        ("été.rsf", ("été.rsf",)),
        ("/".join("abcdefghijklmnopqrst"), tuple("efghijklmnopqrst")),
    ],
)
def test_names_for_this_computer(path: str, parts: tuple[str, ...]) -> None:
    assert parts_of(path) == parts


def test_long_names_keep_their_extension() -> None:
    assert safe_name("a" * 200 + ".rbf") == "a" * (MOST_BYTES - 4) + ".rbf"
    assert safe_name("é" * 200) == "é" * (MOST_BYTES // 2)
    assert safe_name("a." + "b" * 200) == "a." + "b" * (MOST_BYTES - 2)


def test_the_same_path_twice_and_names_that_differ_in_case(tmp_path: Path) -> None:
    brick = Brick()
    for number, path in enumerate(("a.rbf", "a.rbf", "A.rbf", "./a.rbf", "b", "B")):
        brick.upload(path, bytes((number,)))
    list(recover(brick.events, tmp_path))
    assert written(tmp_path) == {
        "a.rbf": b"\0",
        "a (2).rbf": b"\1",
        "A (3).rbf": b"\2",
        "a (4).rbf": b"\3",
        "b": b"\4",
        "B (2)": b"\5",
    }


def test_a_file_where_a_folder_is_needed_and_the_other_way_round(tmp_path: Path) -> None:
    brick = Brick()
    for number, path in enumerate(("a", "a/b", "A/c", "d/e", "d")):
        brick.upload(path, bytes((number,)))
    list(recover(brick.events, tmp_path))
    assert written(tmp_path) == {"a": b"\0", "a (2)/b": b"\1", "a (2)/c": b"\2", "d/e": b"\3", "d (2)": b"\4"}


def test_files_that_were_there_are_kept_unless_they_are_not_to_be(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"old")
    (tmp_path / "b").mkdir()
    brick = Brick()
    brick.upload("a", b"new")
    brick.upload("b", b"file")
    list(recover(brick.events, tmp_path))
    assert written(tmp_path) == {"a": b"old", "a (2)": b"new", "b (2)": b"file"}
    list(recover(brick.events, tmp_path, force=True))
    assert written(tmp_path) == {"a": b"new", "a (2)": b"new", "b (2)": b"file"}


@pytest.mark.parametrize("force", [False, True])
def test_a_file_never_takes_the_place_of_a_folder(tmp_path: Path, force: bool) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "kept").write_bytes(b"old")
    brick = Brick()
    for path in ("empty", "full"):
        brick.upload(path, b"new")
    found = list(recover(brick.events, tmp_path, force=force))
    assert [(each.file, each.trouble) for each in found] == [
        (tmp_path / "empty (2)", None),
        (tmp_path / "full (2)", None),
    ]
    assert written(tmp_path) == {"empty (2)": b"new", "full (2)": b"new", "full/kept": b"old"}
    assert (tmp_path / "empty").is_dir()


@pytest.mark.parametrize("force", [False, True])
def test_symbolic_links_in_the_folder_are_not_followed(tmp_path: Path, force: bool) -> None:
    outside, folder = tmp_path / "outside", tmp_path / "folder"
    outside.mkdir()
    folder.mkdir()
    (outside / "kept").write_bytes(b"old")
    (folder / "prjs").symlink_to(outside)
    (folder / "kept").symlink_to(outside / "kept")
    (folder / "new").symlink_to(outside / "made")
    brick = Brick()
    for path in ("prjs/a", "kept", "new"):
        brick.upload(path, b"x")
    list(recover(brick.events, folder, force=force))
    assert written(outside) == {"kept": b"old"}
    assert (folder / "prjs (2)" / "a").read_bytes() == b"x"
    assert (folder / "kept").is_symlink() is not force


NASTY = st.lists(
    st.sampled_from(
        [
            "..",
            ".",
            "",
            "/",
            "\\",
            "a",
            "A",
            "b.rbf",
            "C:",
            "\0",
            "~",
            "nul",
            "link",
            "file",
            "etc",
            " ",
            "x" * 300,
            "-rf",
            "*",
        ]
    )
    | st.text(st.characters(codec="latin-1"), max_size=8),
    max_size=6,
)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=effort(30, 500))
@given(
    st.lists(st.builds(lambda parts, mark: mark.join(parts), NASTY, st.sampled_from("/\\")), min_size=1, max_size=4),
    st.booleans(),
)
@example(["../../outside/kept", "/etc/passwd", "link/kept", "file/x"], True)
def test_whatever_the_path_nothing_outside_the_folder_is_touched(
    tmp_path_factory: pytest.TempPathFactory, paths: list[str], force: bool
) -> None:
    home = tmp_path_factory.mktemp("home")
    outside, folder = home / "outside", home / "files"
    for made in (outside, folder):
        made.mkdir()
    (outside / "kept").write_bytes(b"old")
    (folder / "link").symlink_to(outside)
    (folder / "file").write_bytes(b"old")
    brick = Brick()
    for path in paths:
        brick.upload(path.replace("\0", "\x01")[:900], b"new")
    found = list(recover(brick.events, folder, force=force))
    assert sorted(path.name for path in home.iterdir()) == ["files", "outside"]
    assert written(outside) == {"kept": b"old"}
    assert force or (folder / "file").read_bytes() == b"old"
    # Every file has its own place, which is inside, even if links are followed.
    places = [file.file for file in found if file.file is not None]
    assert len(set(places)) == len(places) == len(paths)
    for place in places:
        assert place.resolve().is_relative_to(folder.resolve())
        assert place.read_bytes() == b"new"
    assert not [path for path in folder.iterdir() if path.name.startswith(".ev3proto")]


# Complete captures


def hashes(folder: Path) -> dict[str, str]:
    return {name: hashlib.sha256(data).hexdigest() for name, data in written(folder).items()}


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("wifi.pcapng", {"prjs/log/values.rtf": CONTENTS, "prjs/log/first.rbf": IMAGE}),
        ("usb-bootloader.pcapng", {"flash-0x00000000.bin": IMAGE}),
    ],
)
def test_the_bytes_that_were_moved(tmp_path: Path, name: str, expected: dict[str, str]) -> None:
    with read(CAPTURES / name) as capture:
        list(recover(capture.events(), tmp_path))
    assert hashes(tmp_path) == expected


def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return run_ev3proto_text("files", *words)


def test_a_list_of_the_files() -> None:
    done = run(CAPTURES / "wifi.pcapng")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "path                      direction   bytes    of  state     packets",
        "../prjs/log/values.rtf    from brick   2710  2710  complete    35-39",
        "../prjs/log/first.rbf     to brick     2500  2500  complete    41-49",
        "/home/root/none/here.rtf  to brick        0     3  refused     50-51",
    ]


def test_writing_them(tmp_path: Path) -> None:
    out = tmp_path / "made" / "here"
    done = run(CAPTURES / "wifi.pcapng", "-o", out, "--listings")
    assert done.returncode == 0
    assert done.stdout.splitlines() == [
        f"{out}/prjs/log/listing.txt: 112 bytes from brick, /home/root/lms2012/prjs/log/",
        f"{out}/prjs/log/values.rtf: 2710 bytes from brick, ../prjs/log/values.rtf",
        f"{out}/prjs/log/first.rbf: 2500 bytes to brick, ../prjs/log/first.rbf",
    ]
    assert done.stderr.endswith(
        "wifi.pcapng, packet 50: /home/root/none/here.rtf: the brick refused it: ILLEGAL_PATH\n"
    )
    assert hashes(out)["prjs/log/first.rbf"] == IMAGE


def test_a_file_that_is_cut_off(tmp_path: Path) -> None:
    done = run(CAPTURES / "wifi.pcapng", "-o", tmp_path, "--filter", "packet>40 && packet<45", "--json")
    assert done.returncode == 1
    assert "packet 41: ../prjs/log/first.rbf: 2034 of 2500 bytes were captured" in done.stderr
    (entry,) = map(json.loads, done.stdout.splitlines())
    assert (entry["outcome"], entry["file"]) == ("incomplete", str(tmp_path / "prjs/log/first.rbf.part"))
    assert len(written(tmp_path)["prjs/log/first.rbf.part"]) == 2034


def test_complaints(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for words, status, complaint in (
        ((CAPTURES / "wifi.pcapng", "-o", tmp_path / "file"), 2, "is a file"),
        ((CAPTURES / "wifi.pcapng", "-o", tmp_path / "file" / "below"), 1, "below: cannot be written: Not a directory"),
        ((CAPTURES / "wifi.pcapng", "--force"), 2, "--force needs -o"),
        ((CAPTURES / "daisy.pcap",), 0, "no file is moved"),
        ((tmp_path / "none.pcap",), 1, "cannot be read"),
    ):
        done = run(*words)
        assert (done.returncode, done.stdout) == (status, "")
        assert complaint in done.stderr
        assert "Traceback" not in done.stderr


@pytest.mark.skipif(os.geteuid() == 0, reason="nothing is forbidden to root")
def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    done = run(CAPTURES / "wifi.pcapng", "-o", tmp_path)
    assert done.returncode == 1
    assert "cannot be written: Permission denied" in done.stderr


# What the brick answered

BEGUN = "send 1B 00 01 00 01 92 10 00 00 00 2E 2E 2F 70 72 6A 73 2F 74 65 73 74 2F 74 2E 72 62 66 00\n"
HANDLE = "recv 06 00 01 00 03 92 00 00\n"
PIECE = "send 15 00 02 00 {} 93 00 4C 45 47 4F 6B 00 00 00 68 00 01 00 04 00 00 00\n"


@pytest.mark.parametrize(
    ("text", "outcome", "trouble", "status"),
    [
        (
            PIECE.format("01"),
            "last piece never answered",
            ": ../prjs/test/t.rbf: 16 bytes sent, the last piece never answered\n",
            1,
        ),
        (PIECE.format("01") + "recv 06 00 02 00 03 93 08 00\n", "complete", "", 0),
        (PIECE.format("81"), "sent, no reply wanted", "", 0),
    ],
)
def test_a_file_is_complete_only_if_the_brick_answered_its_last_piece(
    text: str, outcome: str, trouble: str, status: int, tmp_path: Path
) -> None:
    text = BEGUN + HANDLE + text
    shown = run_ev3proto_text("files", "--json", "-o", tmp_path, "-", stdin=text)
    assert (json.loads(shown.stdout)["outcome"], shown.returncode) == (outcome, status)
    assert shown.stderr.partition("line 1")[2] == trouble
    assert list(written(tmp_path)) == ["prjs/test/t.rbf"]
    (moved,) = json.loads(run_ev3proto_text("stats", "--json", "-", stdin=text).stdout)["transfers"]
    assert moved["complete"] is (status == 0)
    drawn = collect(event for event in ev3proto.read(text.splitlines()) if isinstance(event, Record))
    assert drawn is not None
    assert (MarkState.MOVED in [mark.outcome for mark in drawn.marks]) is (status == 0)


LINE = "CAAC1DF308631609D0BAA6B2A5DAA084 00000010 t.rbf\n"
LISTED = "send 14 00 09 00 01 99 e8 03 2e 2e 2f 70 72 6a 73 2f 74 65 73 74 2f 00\n"
LISTED += f"recv 3a 00 09 00 03 99 08 30 00 00 00 01 {LINE.encode().hex(' ')}\n"
"""The folder, in which t.rbf has 16 bytes and the MD5 of the piece."""


def test_a_listing_proves_that_a_file_has_arrived() -> None:
    piece = PIECE.format("01")
    for text, outcome in (
        (BEGUN + HANDLE + piece + LISTED, "complete"),
        (BEGUN + HANDLE + LISTED + piece, "last piece never answered"),
        (BEGUN + HANDLE + piece.replace("4C 45", "4C 46") + LISTED, "last piece never answered"),
        (BEGUN + HANDLE + PIECE.format("81") + LISTED, "complete"),
    ):
        assert json.loads(run_ev3proto_text("files", "--json", "-", stdin=text).stdout)["outcome"] == outcome

"""`ev3proto.read`: whatever it is given, it yields records, images, sources and problems, and prints nothing."""

from __future__ import annotations

import gzip
import io
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, cast

import pytest
from support.cases import each
from support.chunks import Pipe, assert_read

import ev3proto
from ev3proto.reading import ProblemCode, Severity, SourceKind, assembled

CAPTURES = Path(__file__).parents[2] / "captures"
ASK, ANSWER = bytes.fromhex("08002a00000400810160"), bytes.fromhex("07002a0002a470fd40")
IMAGE = ev3proto.program.assemble("vmthread MAIN\n{\n  UI_WRITE(LED, 3)\n}").image


def records(*sources: ev3proto.reading.Readable) -> list[ev3proto.Record]:
    found = list(ev3proto.read(*sources))
    assert all(isinstance(item, ev3proto.Record) for item in found), found
    return [item for item in found if isinstance(item, ev3proto.Record)]


def problem(source: ev3proto.reading.Readable) -> ev3proto.Problem:
    (found,) = ev3proto.read(source)
    assert isinstance(found, ev3proto.Problem)
    return found


@pytest.fixture(autouse=True)
def nothing_is_printed(capfd: pytest.CaptureFixture[str]) -> Iterator[None]:
    yield
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    "source",
    [
        ASK,
        bytearray(ASK),
        ASK.hex(),
        "0x|08:00|2A:00|00|04:00|81|01|60|",
        f"09:12:31 sent {ASK.hex(' ')}\n",
        ["a heading\n", f"{ASK.hex(':')}\n"],
        io.StringIO(f"{ASK.hex()}\n"),
        io.BytesIO(ASK),
        io.BytesIO(ASK.hex().encode()),
    ],
    ids=["bytes", "bytearray", "hex", "lesson", "log", "lines", "text file", "binary file", "file of hex"],
)
def test_a_frame_in_any_form(source: ev3proto.reading.Readable) -> None:
    (record,) = records(source)
    assert record.message.build() == ASK
    assert (record.direction, record.carrier) == ("sent", None)
    assert repr(record) == f"<Record {record.place} sent {ASK.hex()}>"


def test_sources_share_a_dialogue() -> None:
    command, reply = records(ASK, ANSWER.hex())
    assert reply.request is command
    (value,) = reply.values
    assert (value.full_name, value.unit, round(value.number, 2)) == ("UI_READ.GET_VBATT", "V", 7.92)


def test_a_path_is_a_file_and_so_is_a_text_with_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("robot.log").write_text(f"start\n09:12:31.5 {ASK.hex()}\n09:12:31.6 {ANSWER.hex()}\n")
    for source in ("robot.log", Path("robot.log")):
        command, reply = records(source)
        assert (str(command.place), str(reply.place)) == ("robot.log, line 2", "robot.log, line 3")
        assert reply.latency == pytest.approx(0.1)


def test_captures_of_all_kinds(tmp_path: Path) -> None:
    path = CAPTURES / "usb-plugged.pcap"
    packed = tmp_path / "robot.gz"
    packed.write_bytes(gzip.compress(path.read_bytes()))
    expected = [record.frame for record in ev3proto.capture.read(path)]
    for source in (path, str(path), path.read_bytes(), io.BytesIO(path.read_bytes()), packed):
        assert [record.frame for record in records(source)] == expected
    assert str(records(path)[0].place) == f"{path}, packet 1"


def test_a_temporary_file_is_read_as_bytes() -> None:
    with tempfile.TemporaryFile() as plain, tempfile.NamedTemporaryFile() as named:
        for file in (plain, named):
            file.write(ASK + ANSWER)
            file.seek(0)
            assert [record.frame for record in records(cast(BinaryIO, file))] == [ASK, ANSWER]
            assert not file.closed


def test_frames_in_bytes_are_numbered() -> None:
    assert [record.place for record in records(ASK + ANSWER)] == [
        ev3proto.reading.Place("the bytes", frame=1),
        ev3proto.reading.Place("the bytes", frame=2),
    ]
    assert [str(record.place) for record in records(ASK[:-1])] == ["the bytes, frame 1"]


def test_the_time_is_unknown_in_a_text_without_times() -> None:
    (record,) = records(ASK)
    assert record.time is None
    (record,) = records(f"2026-01-31T09:12:31.5Z {ASK.hex()}\n")
    assert record.time == 1769850751.5


def test_what_a_text_says_besides_bytes() -> None:
    frame = f"{ASK.hex(' ')} 00 00\n"
    (record,) = records(["08 00 xx xx 00 04 00 81 01 60\n"])
    assert record.unknown == {2, 3}
    (record,) = records([frame])
    assert (record.rest, record.missing) == (bytes(2), 0)
    (record,) = records(["sent 0e 00 2a 00 80 00 00 94 01 01 82 ...\n"])
    assert record.missing == 5


def test_a_program_and_sources(tmp_path: Path) -> None:
    (image,) = ev3proto.read(IMAGE)
    assert isinstance(image, ev3proto.Image)
    assert ev3proto.program.parse(image.data).build() == IMAGE
    path = tmp_path / "hello.lms"
    path.write_text("vmthread MAIN\n{\n  UI_WRITE(LED, 3)\n}")
    (source,) = ev3proto.read(path)
    assert isinstance(source, ev3proto.Source)
    assert (source.kind, ev3proto.program.assemble(source.text).image) == (SourceKind.PROGRAM, IMAGE)


def test_assembly_is_a_source_of_frames() -> None:
    (source,) = ev3proto.read("UI_READ(GET_VBATT, GV0(0))")
    assert isinstance(source, ev3proto.Source)
    (record,) = assembled(source, counter=42)
    assert isinstance(record, ev3proto.Record)
    assert record.frame == ASK
    (source,) = ev3proto.read(["UI_READ(GET_VBATT, GV0(0))\n", "UI_REED(GET_VBATT)\n"])
    assert isinstance(source, ev3proto.Source)
    *_, error = assembled(source)
    assert isinstance(error, ev3proto.Problem)
    assert (error.place.line, error.place.column, error.severity) == (2, 1, Severity.ERROR)
    assert error.excerpt == "UI_REED(GET_VBATT)\n^"


def test_problems_have_a_place_and_a_code(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text("sent 08 00 2a 00 00 04 00 81 01 6G\n")
    wrong = next(item for item in ev3proto.read(log) if isinstance(item, ev3proto.Problem))
    assert (wrong.code, wrong.severity, wrong.place.line, wrong.place.column) == (ProblemCode.TEXT, "error", 1, 33)
    assert str(wrong) == f"{log}, line 1, column 33: {wrong.message}"
    wrong = problem("zz")
    assert (wrong.code, wrong.place.name, wrong.place.column) == (ProblemCode.TEXT, "'zz'", 1)
    assert str(wrong) == "'zz' is neither a file nor a frame: 'zz' is not hex"


@pytest.mark.parametrize(
    ("source", "code"),
    [
        (b"", ProblemCode.EMPTY),
        ("", ProblemCode.EMPTY),
        ("nothing here\n", ProblemCode.EMPTY),
        ([], ProblemCode.EMPTY),
        (io.BytesIO(b"PK\x03\x04" + bytes(20)), ProblemCode.KIND),
        (io.BytesIO(bytes.fromhex("0a0d0d0a ffffffff")), ProblemCode.DAMAGED),
    ],
)
def test_a_source_without_anything_is_one_problem(source: ev3proto.reading.Readable, code: ProblemCode) -> None:
    assert problem(source).code == code


def test_the_log_in_a_bug_report_is_named() -> None:
    """Base64 of a compressed log, in which nothing is taken for a frame; lines around it are read."""
    text = f"""dumpstate
--- BEGIN:BTSNOOP_LOG_SUMMARY (64 bytes in) ---
AgBo5c+LAQAAeJyTY5BjeMHMwKDIqCDJIMrgwMD9XpmfgYGhgYFhCmMjU9MLZiCaJcQgBFYlyKjA
--- END:BTSNOOP_LOG_SUMMARY ---
{ASK.hex(" ")}
"""
    record, problem = ev3proto.read(text)
    assert isinstance(record, ev3proto.Record)
    assert (record.frame, record.place.line) == (ASK, 5)
    assert isinstance(problem, ev3proto.Problem)
    assert (problem.place.line, problem.code) == (2, ProblemCode.KIND)
    assert problem.message.startswith("Android's compressed log of Bluetooth (btsnooz), which is not read here; ")


def test_a_filter_that_nothing_matches() -> None:
    (found,) = ev3proto.read(CAPTURES / "usb-plugged.pcap", filter="op == SOUND.PLAY")
    assert isinstance(found, ev3proto.Problem)
    assert found.code is ProblemCode.NO_MATCH
    voltages = list(ev3proto.read(CAPTURES / "usb-plugged.pcap", filter="op == UI_READ.GET_VBATT"))
    assert len(voltages) == 4


def test_only_a_file_that_cannot_be_opened_raises(tmp_path: Path) -> None:
    for source in (tmp_path / "robot.log", str(tmp_path / "robot.log"), tmp_path):
        with pytest.raises(OSError, match=str(tmp_path)):
            list(ev3proto.read(source))


def test_wrong_calls() -> None:
    with pytest.raises(ValueError, match="dialect must be one of"):
        ev3proto.read(ASK, dialect="nxt")
    with pytest.raises(ValueError, match="unknown engine"):
        ev3proto.read(ASK, engine="pyshark")
    with pytest.raises(TypeError, match="cannot read int"):
        ev3proto.read(42)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="cannot read bytes as a line"):
        list(ev3proto.read([ASK]))  # type: ignore[list-item]
    with pytest.raises(ValueError, match="TOEN"):
        ev3proto.read(ASK, filter="op == SOUND.TOEN")


def test_lines_are_read_as_they_come() -> None:
    read: list[str] = []

    def typed() -> Iterator[str]:
        for line in (f"{ASK.hex()}\n", f"{ANSWER.hex()}\n"):
            read.append(line)
            yield line

    items = ev3proto.read(typed())
    next(items)
    assert len(read) == 1


def test_a_faulty_frame_is_a_record() -> None:
    (record,) = records(ASK[:-1])
    assert record.message.fault is not None
    assert record.message.build() == ASK[:-1]


def test_a_record_as_other_tools_get_it() -> None:
    (record,) = records(f"09:12:31 sent {ASK.hex()}\n")
    entry = record.as_dict()
    assert (entry["kind"], entry["direction"], entry["time"], entry["hex"]) == (
        "direct-command",
        "sent",
        "09:12:31",
        ASK.hex(),
    )
    entry = records(CAPTURES / "usb-plugged.pcap")[1].as_dict()
    assert (entry["packets"], entry["carrier"], entry["answers"]) == ([3], "usb", 1)


def test_a_slip_has_its_line_and_column() -> None:
    (problem, record) = ev3proto.read(["a log\n", "Sent 0x|08:00|2A:00|00|01:00|81|12:6G|\n"])
    assert isinstance(problem, ev3proto.Problem)
    assert (problem.place.line, problem.place.column) == (2, 36)
    assert problem.message == "'6G' is not hex"
    assert isinstance(record, ev3proto.Record)


def test_a_slip_in_a_dump_has_the_line_of_its_row() -> None:
    problem, *_ = ev3proto.read(["a log\n", "0000  0e 00 2a 00 80 00 00\n", "0007  94 0g 01\n"])
    assert isinstance(problem, ev3proto.Problem)
    assert (problem.place.line, problem.place.column) == (3, 10)
    assert str(problem).endswith("line 3, column 10: '0g' is not hex")


# Chunks


CHUNKED = {
    "raw frames": bytes.fromhex("0e002a0080000094010182b80182e803 0600010080000001"),
    "a log": b"# A log\n12:30:45.5 Sent 0x|06:00|01:00|80|00:00|01|\n12:30:45.6 Sent 08 00 zz\n",
    "an array": b"byte[] data = {\n  0x06, 0x00, 0x2a, 0x00,\n  0x80, 0x00, 0x00, 0x01\n};\n",
    "assembly": b"SOUND(TONE, 1, 440, 1000)\nUI_WRITE(LED, 2)\n",
    "a source": b"vmthread MAIN\n{\n  UI_WRITE(LED, LED_RED)\n}\n",
    "a capture": (CAPTURES / "daisy.pcap").read_bytes(),
}


def told(chunks: list[bytes]) -> list[str]:
    return [f"{item!r} at {item.place}" for item in ev3proto.read(io.BufferedReader(Pipe(chunks)))]


@each("name", CHUNKED)
def test_what_is_found_does_not_depend_on_the_chunks(name: str) -> None:
    data = CHUNKED[name]
    found = told([data])
    assert found
    assert_read(told, data, found)

"""Programs on the command line: `decode` shows them, `encode` makes them, `check` says what is wrong."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.cli import run_ev3proto, run_ev3proto_text
from support.programs import IMAGE, SHORTEST, SOURCE, image_of

import ev3proto
from ev3proto import SystemStatus


@pytest.fixture
def image(tmp_path: Path) -> Path:
    path = tmp_path / "robot.rbf"
    path.write_bytes(IMAGE)
    return path


@pytest.fixture
def source(tmp_path: Path) -> Path:
    path = tmp_path / "robot.lms"
    path.write_text(SOURCE)
    return path


def test_decode_lists_a_program(image: Path) -> None:
    result = run_ev3proto_text("decode", image)
    assert result.returncode == 0
    lines = [" ".join(line.split()) for line in result.stdout.splitlines()]
    assert "program version 0x6D (the sources of release 1.09), 2 objects, 8 bytes of globals" in lines
    assert "57 JR_LT8(g0, 2, to1)" in lines
    assert r"63 CALL(sub2, 'done\q', g4)" in lines
    assert "p0 in, string of 8 bytes, local 0" in lines
    assert "calls 2" in lines
    assert "99 RETURN()" in lines


def test_decode_as_json(image: Path) -> None:
    (line,) = run_ev3proto_text("decode", "--json", image).stdout.splitlines()
    entry = json.loads(line)
    assert (entry["kind"], entry["version"], entry["size"], entry["globals"]) == ("program", 0x6D, 101, 8)
    main, say = entry["objects"]
    assert (main["kind"], main["offset"], main["locals"], main["calls"]) == ("vmthread", 40, 10, [2])
    assert (say["kind"], say["offset"], say["locals"], say["triggers"]) == ("subcall", 81, 16, 1)
    assert say["parameters"] == [
        {"type": "string", "direction": "in", "offset": 0, "size": 8},
        {"type": "DATAF", "direction": "out", "offset": 8, "size": 4},
    ]
    jump = main["operations"][5]
    assert (jump["op"], jump["offset"], jump["target"]) == ("JR_LT8", 57, 43)
    assert [argument["value"] for argument in main["operations"][6]["args"]] == [2, 2, "done'", 4]


@pytest.mark.parametrize("bytes_", [IMAGE, SHORTEST])
def test_a_source_that_decode_wrote_becomes_the_same_image(tmp_path: Path, bytes_: bytes) -> None:
    (tmp_path / "a.rbf").write_bytes(bytes_)
    (tmp_path / "a.lms").write_text(run_ev3proto_text("decode", "--format", "lego", tmp_path / "a.rbf").stdout)
    result = run_ev3proto_text("encode", tmp_path / "a.lms", "-o", tmp_path / "b.rbf")
    assert result.returncode == 0
    assert (tmp_path / "b.rbf").read_bytes() == bytes_


def test_encode_makes_a_program(source: Path, tmp_path: Path) -> None:
    target = tmp_path / "made.rbf"
    result = run_ev3proto_text("encode", source, "-o", target)
    assert result.stderr == f"{target}: 101 bytes, 2 objects, from a source in the strict dialect\n"
    assert target.read_bytes() == IMAGE
    assert run_ev3proto("encode", source, "--to", "rbf").stdout == IMAGE
    assert run_ev3proto("encode", source, "--shortest").stdout == SHORTEST
    assert "in LEGO's dialect" in run_ev3proto_text("encode", source, "-o", target, "--source", "lego").stderr
    assert run_ev3proto("encode", source, "--version", "0x39").stdout[8] == 0x39


def test_encode_without_a_name_for_the_image_says_how_to_make_one(source: Path) -> None:
    result = run_ev3proto_text("encode", source)
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr == f"{source}: this is a program, not a frame; add -o FILE.rbf to make its image\n"
    source.write_text("subcall Say\n{\n}\n")
    assert "add -o FILE.rbf" in run_ev3proto_text("encode", source).stderr
    source.write_text("vmthread MAIN\n{\n  DATAS text 70\n  STRINGS(DUPLICATE, 'x', text)\n}\n")
    result = run_ev3proto_text("encode", source)
    assert "line 3" in result.stderr
    assert "add -o FILE.rbf" in result.stderr


def test_decode_of_a_source_says_how_to_make_the_image(source: Path) -> None:
    result = run_ev3proto_text("decode", source)
    assert result.returncode == 1
    assert "`ev3proto encode -o FILE.rbf` makes its image" in result.stderr


def test_a_direct_command_written_as_a_thread_is_still_a_frame(source: Path) -> None:
    source.write_text("vmthread MAIN\n{\n  UI_DRAW(UPDATE)\n}\n")
    assert run_ev3proto_text("encode", source).stdout == "0x|07:00|00:00|80|00:00|84:00|\n"


@pytest.mark.parametrize(
    ("name", "words"),
    [("missing.lms", "missing.lms: cannot be read: No such file or directory"), ("a.rbf", "is an image already")],
)
def test_invalid_sources(tmp_path: Path, name: str, words: str) -> None:
    (tmp_path / "a.rbf").write_bytes(IMAGE)
    result = run_ev3proto_text("encode", tmp_path / name, "-o", tmp_path / "b.rbf")
    assert result.returncode == 1
    assert words in result.stderr
    assert len(result.stderr.splitlines()) == 1


def test_encode_reports_errors_of_a_source(source: Path, tmp_path: Path) -> None:
    source.write_text(SOURCE.replace("LED_RED", "LED_RAD"))
    result = run_ev3proto_text("encode", source, "-o", tmp_path / "made.rbf")
    assert result.returncode == 1
    assert result.stderr.splitlines() == [
        f"{source}, line 12, column 17: unknown name LED_RAD: did you mean LED_RED or LED_RR or LED_RG?",
        "    UI_WRITE(LED, LED_RAD)",
        "                  ^",
    ]
    assert not (tmp_path / "made.rbf").exists()


def test_encode_prints_warnings(source: Path, tmp_path: Path) -> None:
    source.write_text(SOURCE.replace("MOVE8_8(0, count)", "MOVE8_8(0, timer)"))
    result = run_ev3proto_text("encode", source, "-o", tmp_path / "made.rbf")
    assert result.returncode == 0
    assert "line 10, column 14: DESTINATION of MOVE8_8 is a DATA8, not a DATA32: timer (warning)" in result.stderr


def test_check_counts_warnings_when_that_is_asked_for(source: Path) -> None:
    source.write_text(SOURCE.replace("MOVE8_8(0, count)", "MOVE8_8(0, timer)"))
    assert run_ev3proto_text("check", source).returncode == 0
    assert run_ev3proto_text("check", "--strict", source).returncode == 1


@pytest.mark.parametrize("options", [("--version", "70000"), ("--version", "x"), ("--shortest", "--to", "hex")])
def test_a_call_that_makes_no_sense_is_refused(source: Path, options: tuple[str, ...]) -> None:
    assert run_ev3proto_text("encode", source, *options).returncode == 2


def test_a_damaged_program_is_shown_as_far_as_it_goes(image: Path) -> None:
    image.write_bytes(IMAGE[:70])
    result = run_ev3proto_text("decode", image)
    assert result.returncode == 1
    assert "TIMER_READY" in result.stdout
    assert "fault at offset 4: the header says 101 bytes; the image has 70" in result.stderr
    image.write_bytes(IMAGE[:9])
    result = run_ev3proto_text("decode", image)
    assert result.returncode == 1
    assert "an image starts with a header of 16 bytes" in result.stderr


def test_check_takes_programs_and_their_sources(image: Path, source: Path) -> None:
    for path in (image, source):
        result = run_ev3proto_text("check", path)
        assert (result.returncode, result.stdout) == (0, "the brick takes the program\n")
    image.write_bytes(IMAGE[:12] + b"\x04" + IMAGE[13:])
    result = run_ev3proto_text("check", image)
    assert result.returncode == 1
    assert "error[E007]: offset 73: PARAMETERS[1] ends at global byte 8, and there are 4" in result.stdout
    (line,) = run_ev3proto_text("check", "--json", image).stdout.splitlines()
    assert json.loads(line)["findings"][0]["code"] == "E007"
    source.write_text(SOURCE.replace("CALL(Say", "CALL(Sayy"))
    result = run_ev3proto_text("check", source)
    assert result.returncode == 1
    assert "unknown name Sayy: did you mean Say?" in result.stderr


def test_check_explains_the_codes_of_programs() -> None:
    result = run_ev3proto_text("check", "--explain", "E005")
    assert result.stdout.startswith("error[E005]: a call with a wrong number of parameters")
    assert "E005" in run_ev3proto_text("check", "--explain", "all").stdout


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    """A capture in which the example is sent to a brick."""
    lines = []
    for sent, received in (
        (
            ev3proto.system_command("BEGIN_DOWNLOAD", size=len(IMAGE), path="../prjs/robot/robot.rbf", counter=1),
            ev3proto.system_reply("BEGIN_DOWNLOAD", handle=0, counter=1),
        ),
        (
            ev3proto.system_command("CONTINUE_DOWNLOAD", handle=0, data=IMAGE, counter=2),
            ev3proto.system_reply("CONTINUE_DOWNLOAD", handle=0, counter=2, status=SystemStatus.END_OF_FILE),
        ),
    ):
        lines += [f"Sent {sent.build().hex(':')}", f"Recv {received.build().hex(':')}"]
    (tmp_path / "robot.log").write_text("\n".join(lines))
    target = tmp_path / "robot.pcapng"
    done = run_ev3proto_text("export", "pcapng", tmp_path / "robot.log", "-o", target)
    assert done.returncode == 0, done.stderr
    return target


def test_decode_shows_the_programs_that_a_capture_moves(capture: Path) -> None:
    result = run_ev3proto_text("decode", "--programs", capture)
    assert result.returncode == 0, result.stderr
    first, second, *_ = result.stdout.splitlines()
    assert first.endswith(": ../prjs/robot/robot.rbf")
    assert second.startswith("program  version 0x6D")
    entry = json.loads(run_ev3proto_text("decode", "--programs", "--json", capture).stdout)
    assert entry["origin"].endswith(": ../prjs/robot/robot.rbf")
    assert len(entry["objects"]) == 2


def test_programs_are_looked_for_in_captures_only(image: Path) -> None:
    assert run_ev3proto_text("decode", "--programs", image).returncode == 2


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("30 05 64 40 01 30 05 60 40 60 0A", "E007 E008 W015 W011"),
        ("30 01 60", "W010"),
        ("DF 0A", "E002 W011"),
    ],
)
def test_run_and_check_say_the_same(tmp_path: Path, code: str, words: str) -> None:
    path = tmp_path / "x.rbf"
    path.write_bytes(image_of((0, 0, code), global_size=1) + (b"\xff" if "W011" in words else b""))
    said = run_ev3proto_text("check", path).stdout
    assert all(f"[{word}]: offset " in said for word in words.split()), said
    assert run_ev3proto_text("run", path, "--limit", "1").stderr.startswith(said)


def test_a_damaged_program_is_not_taken_for_a_frame_with_a_slip(tmp_path: Path) -> None:
    path = tmp_path / "damaged.rbf"
    path.write_bytes(bytes.fromhex("4c45474f1f0000001b0000006a0000001c000000000001000000000000080a"))
    assert "nearest" not in json.loads(run_ev3proto_text("check", "--json", path).stdout)

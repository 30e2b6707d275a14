"""`ev3proto encode`: its input and output; the forms of frames, and JSON back to frames."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result
from hypothesis import given
from support.cli import run_ev3proto

from ev3proto import direct_reply, parse
from ev3proto.cli.encode import encode
from ev3proto.dialogue import Dialogue, Exchange
from ev3proto.testing import frames, mutated_frames
from ev3proto.text.assembly import assemble
from ev3proto.text.forms import as_c, as_hex, as_python
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.json_format.to_messages import RecordError, frame_of, frames_of_json, read_records
from ev3proto.text.paste import read_text
from ev3proto.text.phrases import Seen

ROOT = Path(__file__).parents[2]
CAPTURES = [*sorted((ROOT / "captures").glob("*.pcap*")), *sorted((ROOT / "captures").glob("*.log"))]

TONE = "SOUND(TONE, 1, 440, 1000)"
TONE_HEX = "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|\n"
TONE_BYTES = bytes.fromhex("0e002a0080000094010182b80182e803")
LIST = bytes.fromhex("0C 00 01 00 01 99 E8 03") + b"/prjs\0"
LISTED = bytes.fromhex("12 00 01 00 03 99 08 07 00 00 00 00") + b"a*/b.rbf"


def run(*words: str) -> Result:
    """The subcommand in this process."""
    return CliRunner().invoke(encode, words, catch_exceptions=False)


def pipe(program: str, *words: str, stdin: bytes = b"") -> subprocess.CompletedProcess[bytes]:
    """A subcommand that reads standard input."""
    return run_ev3proto(program, *words, stdin=stdin)


# What it writes


def test_every_form() -> None:
    expected = {
        "hex": TONE_HEX,
        "c": (
            "/* DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes */\n"
            "const unsigned char frame_1[16] = {\n"
            "    0x0E, 0x00,                                            /* length 14 */\n"
            "    0x2A, 0x00,                                            /* counter 42 */\n"
            "    0x80,                                                  /* DIRECT_COMMAND_NO_REPLY */\n"
            "    0x00, 0x00,                                            /* 0 bytes of global memory, 0 of local */\n"
            "    0x94, 0x01, 0x01, 0x82, 0xB8, 0x01, 0x82, 0xE8, 0x03, "
            " /* SOUND.TONE: VOLUME 1 %, FREQUENCY 440 Hz, DURATION 1000 ms */\n"
            "};\n"
        ),
        "python": (
            "# DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes\n"
            "frame_1 = b'\\x0e\\x00*\\x00\\x80\\x00\\x00\\x94\\x01\\x01\\x82\\xb8\\x01\\x82\\xe8\\x03'\n"
        ),
        "asm": (
            "// DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes\n"
            "message DIRECT_COMMAND_NO_REPLY counter 42 globals 0 locals 0\n"
            "opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)\n"
        ),
    }
    for form, text in expected.items():
        done = run("--counter", "42", "--to", form, TONE)
        assert (done.exit_code, done.output) == (0, text)
    done = run("--counter", "42", "--to", "json", TONE)
    assert json.loads(done.output)["hex"] == TONE_BYTES.hex()


def test_raw_bytes_to_a_pipe_and_a_file(tmp_path: Path) -> None:
    done = pipe("encode", "--counter", "42", "--to", "raw", TONE)
    assert (done.returncode, done.stdout, done.stderr) == (0, TONE_BYTES, b"")
    target = tmp_path / "tone.bin"
    assert run("--counter", "42", "--to", "raw", "-o", str(target), TONE).output == ""
    assert target.read_bytes() == TONE_BYTES


def test_a_text_in_a_file(tmp_path: Path) -> None:
    target = tmp_path / "tone.h"
    run("--to", "c", "-o", str(target), "COM_SET(SET_BRICKNAME, 'Ä')")
    assert 'COM_SET.SET_BRICKNAME: NAME "Ä" */' in target.read_text(encoding="utf-8")


def test_without_a_frame_no_file_is_left(tmp_path: Path) -> None:
    done = run("-o", str(tmp_path / "nothing"), "SUOND(TONE)")
    assert done.exit_code == 1
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    done = pipe("encode", "-o", str(tmp_path), TONE)
    assert done.returncode == 1
    assert done.stderr.decode() == f"{tmp_path}: cannot be written: Is a directory\n"


def test_counters_go_on_over_all_that_is_given() -> None:
    assert [line[9:14] for line in run("--counter", "65535", "NOP", TONE).output.splitlines()] == ["FF:FF", "00:00"]


def test_a_reply_where_it_is_wanted() -> None:
    assert run("--reply", "NOP").output == "0x|06:00|00:00|00|00:00|01|\n"
    assert run("DATAF v\nUI_READ(GET_VBATT, v)").output == "0x|08:00|00:00|00|04:00|81:01:60|\n"
    assert run("--no-reply", "DATAF v\nUI_READ(GET_VBATT, v)").output == "0x|08:00|00:00|80|04:00|81:01:60|\n"
    assert run("--no-reply", "CREATE_DIR('a')").output == "0x|06:00|00:00|81|9B:61:00|\n"


# What it takes


@pytest.mark.parametrize(
    "text",
    [
        "message counter 42\nSOUND(TONE, 1, 440, 1000)",
        "/*\n * 0E 00 2A 00\n */\n// and another\n\nmessage counter 42\nopSOUND,LC0(TONE),LC0(1),LC2(440),LCX(1000)",
        "0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|",
        "Sent 0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|",
        TONE_BYTES.hex(),
        json.dumps({"type": "DIRECT_COMMAND_NO_REPLY", "hex": TONE_BYTES.hex()}),
        json.dumps({"type": "DIRECT_COMMAND_NO_REPLY", "hex": TONE_BYTES.hex()}, indent=2),
    ],
)
def test_everything_that_can_be_encoded(text: str, tmp_path: Path) -> None:
    path = tmp_path / "input"
    path.write_text(f"{text}\n")
    for done in (run(text), run(str(path))):
        assert (done.exit_code, done.output) == (0, TONE_HEX)
    piped = pipe("encode", stdin=f"{text}\n".encode())
    assert (piped.returncode, piped.stdout.decode(), piped.stderr) == (0, TONE_HEX, b"")


@pytest.mark.parametrize("path", CAPTURES, ids=[path.name for path in CAPTURES])
@pytest.mark.parametrize("form", ["--json", "--format=asm"])
def test_what_decode_prints_gives_the_same_bytes(path: Path, form: str) -> None:
    decoded = pipe("decode", form, str(path)).stdout
    expected = run("--to", "hex", str(path)).output
    encoded = pipe("encode", stdin=decoded)
    assert (encoded.returncode, encoded.stderr) == (0, b"")
    assert encoded.stdout.decode() == expected
    assert expected.count("0x|") == expected.count("\n") > 0


def test_the_dialogues_of_a_capture() -> None:
    capture = str(ROOT / "captures" / "wifi.pcapng")
    decoded = pipe("decode", "--json", "--dialogues", capture).stdout
    encoded = pipe("encode", stdin=decoded).stdout.decode().splitlines()
    assert sorted(encoded) == sorted(run(capture).output.splitlines())


def test_every_form_can_be_encoded_again(tmp_path: Path) -> None:
    log = str(ROOT / "captures" / "lesson-02.log")
    expected = run(log).output
    assert expected.count("\n") == 20
    for form in ("hex", "c", "python", "json", "asm"):
        path = tmp_path / form
        assert run("--to", form, "-o", str(path), log).exit_code == 0
        assert run(str(path)).output == expected, form


def test_a_filter_chooses_frames_of_a_capture() -> None:
    capture = str(ROOT / "captures" / "wifi.pcapng")
    done = run("--filter", "op==SOUND.TONE", capture)
    assert done.output.splitlines()[0] == "0x|0E:00|01:00|80|00:00|94:01:05:82:B8:01:82:FA:00|"
    assert run("--filter", "op==SOUND.TONE", TONE).exit_code == 2


# What is wrong


def test_bad_assembly_is_shown_with_its_place(tmp_path: Path) -> None:
    path = tmp_path / "tone.lms"
    path.write_text("NOP\n  SOUND(TOEN, 1, 440, 1000)\nSUOND(TONE)\n")
    done = pipe("encode", str(path))
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode() == (
        f"{path}, line 2, column 9: SOUND has no CMD TOEN: did you mean TONE?\n"
        "    SOUND(TOEN, 1, 440, 1000)\n"
        "          ^\n"
        f"{path}, line 3, column 1: unknown operation SUOND: did you mean SOUND?\n"
        "  SUOND(TONE)\n"
        "  ^\n"
    )
    assert run("SUOND(TONE)").output == (
        "line 1, column 1: unknown operation SUOND: did you mean SOUND?\n  SUOND(TONE)\n  ^\n"
    )


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (
            "",
            "standard input: nothing to encode; expected assembly such as SOUND(",
        ),
        ("define A 1\n", "standard input: nothing to encode; expected assembly such as"),
        ('{"kind": "beacon", "hex": "00"}\n', "standard input: nothing to encode"),
        ('{"kind": 1}\n', "standard input, line 1: not a message: the object has neither type nor hex"),
        ('{"kind": 1\n', "standard input, line 1, column 11: invalid JSON: Expecting ',' delimiter"),
        ('{"type": "DIRECT_REPLY", "hex": "0"}\n', 'standard input, line 1: hex takes bytes in hex, not "0"'),
        ("06:00|01:00|80|00:00|FE\n", "standard input, line 1: fault at offset 7: unknown opcode 0xFE"),
        (
            "Sent 0x|0E:00|2A:00|80|00:...\n",
            "standard input, line 1: cannot encode a frame that is cut off after 6 bytes",
        ),
        ("\x00\x01\x02", "standard input: neither text nor a capture: it starts with 00 01 02; what can be encoded is"),
    ],
)
def test_input_at_fault(text: str, sentence: str) -> None:
    done = pipe("encode", stdin=text.encode())
    assert done.returncode == 1
    assert done.stderr.decode().startswith(sentence)


# JSON


def entry_of(frame: bytes) -> dict[str, Any]:
    """The object of a frame, read back from a file."""
    message = parse(frame, strict=False)
    entry: dict[str, Any] = json.loads(json.dumps(record(Exchange(message), Seen())))
    return entry


@given(frames() | mutated_frames())
def test_every_frame_comes_back_from_json(frame: bytes) -> None:
    assert frame_of(entry_of(frame)) == frame


@pytest.mark.parametrize(
    "frame",
    [
        TONE_BYTES,
        LIST,
        LISTED,
        bytes.fromhex("08 00 01 00 00 04 00 81 01 60"),
        bytes.fromhex("08 00 01 00 00 00 10 81 01 40"),
        bytes.fromhex("07 00 01 00 02 A4 70 FD 40"),
        bytes.fromhex("09 00 01 00 0A A0 00 01 A6 00 0F"),
        bytes.fromhex("08 00 01 00 0A A1 00 01 DE AD"),
        bytes.fromhex("07 00 01 00 08 00 01 DE AD"),
        bytes.fromhex("0A 00 01 00 00 04 00 81 81 01 E1 00"),
        bytes.fromhex("0E 00 01 00 80 00 00 3F 83 00 00 C0 7F D1 04 01"),
        bytes.fromhex("0E 00 01 00 80 00 00 94 01 01 FF"),
    ],
)
def test_the_keys_alone_give_the_frame_too(frame: bytes) -> None:
    entry = entry_of(frame)
    del entry["hex"]
    assert frame_of(entry) == frame


def test_what_is_changed_is_made_anew() -> None:
    entry = entry_of(TONE_BYTES)
    entry["counter"] = 7
    entry["operations"][0]["args"][1]["value"] = 880
    entry["operations"].append({"op": "UI_WRITE", "command": "LED", "args": ["LED_RED"]})
    assert frame_of(entry).hex(" ") == "11 00 07 00 80 00 00 94 01 01 82 70 03 82 e8 03 82 1b 02"
    listing = entry_of(LIST)
    listing["fields"]["path"] = "/a"
    assert frame_of(listing).hex(" ") == "09 00 01 00 01 99 e8 03 2f 61 00"


def test_an_object_written_by_hand() -> None:
    entry = {
        "type": "DIRECT_COMMAND_REPLY",
        "counter": 1,
        "globals": 4,
        "operations": [{"op": "UI_READ", "command": "GET_VBATT", "args": [{"value": 0, "kind": "global"}]}],
    }
    assert frame_of(entry).hex(" ") == "08 00 01 00 00 04 00 81 01 60"
    listing = {"type": "SYSTEM_COMMAND_REPLY", "command": "LIST_FILES", "fields": {"max_bytes": 5, "path": "/"}}
    assert frame_of(listing).hex(" ") == "08 00 00 00 01 99 05 00 2f 00"


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"type": "DIRECT_COMAND_REPLY"}, 'unknown message type "DIRECT_COMAND_REPLY": did you mean DIRECT_'),
        ({"counter": 65536}, "counter cannot be 65536: it is a whole number from 0 to 65535"),
        ({"globals": "4"}, 'globals cannot be "4": it is a whole number from 0 to 1023'),
        ({"operations": 1}, "operations takes a list, not 1"),
        ({"operations": [{"op": "SUOND"}]}, "operations[0]: the official firmware has no operation SUOND: did you"),
        ({"operations": [{"op": "NOP", "args": [1]}]}, "operations[0]: NOP takes 0 values (none), not 1"),
        (
            {"operations": [{"op": "SOUND", "command": "TONE", "args": [{"value": 500, "encoding": "LC1"}, 1, 1]}]},
            "operations[0]: LC1 cannot hold 500: it is limited to -128 to 127",
        ),
        (
            {"operations": [{"op": "SOUND", "command": "TONE", "args": [True, 1, 1]}, {"op": "NOP"}]},
            "operations[0]: VOLUME cannot be true: it is a number or a text",
        ),
        ({"operations": [{"op": "NOP"}] * 1018}, "the frame would have 1025 bytes; the brick accepts at most 1024"),
    ],
)
def test_objects_at_fault(change: dict[str, Any], sentence: str) -> None:
    with pytest.raises(RecordError) as caught:
        frame_of(entry_of(TONE_BYTES) | change)
    assert str(caught.value).startswith(sentence)


def test_texts_on_wifi_are_not_frames() -> None:
    assert list(frames_of_json({"kind": "beacon", "text": {}, "hex": "00"})) == []


def test_json_that_is_bad_or_endless() -> None:
    for text, line, sentence in (
        ("[" * 100_000, 1, "this JSON cannot be read: it is nested too deep"),
        ("{\n" + '"a": 1,\n' * 3, 1, "the object that starts here never ends"),
        ('{"a": ' + "9" * 5000 + "}", 1, "this JSON cannot be read"),
        ("{\n" + "\n" * 5_000_000, 1, "the object has more than 4194304 characters"),
        ('{}\n{"a": ?}', 2, "invalid JSON: Expecting value"),
    ):
        with pytest.raises(RecordError) as caught:
            list(read_records(text.splitlines(keepends=True)))
        assert caught.value.line == line
        assert str(caught.value).startswith(sentence)
    nothings: tuple[Any, ...] = (None, [], 5, "text")
    for nothing in nothings:
        with pytest.raises(RecordError, match="expected an object"):
            list(frames_of_json(nothing))


# Forms


@given(frames() | mutated_frames())
def test_hex_has_all_bytes(frame: bytes) -> None:
    text = as_hex(parse(frame, strict=False))
    assert bytes.fromhex(text.removeprefix("0x|").replace("|", " ").replace(":", " ")) == frame


@given(frames() | mutated_frames())
def test_an_array_and_a_byte_string_have_all_bytes(frame: bytes) -> None:
    message = parse(frame, strict=False)
    names: dict[str, bytes] = {}
    exec(as_python(message), names)
    assert names["frame"] == frame
    # Bytes whose length field does not fit may contain a frame; a leading zero may be the number of a HID report.
    if len(frame) >= 7 and frame[0] != 0 and message.stated_length is None:
        assert [pasted.data for pasted in read_text(as_c(message).split("\n"))] == [frame]


@pytest.mark.parametrize(("language", "standard"), [("c", "c99"), ("c++", "c++11")])
def test_a_compiler_takes_the_arrays(language: str, standard: str, tmp_path: Path) -> None:
    messages = [parse(TONE_BYTES), parse(LIST), parse(LISTED), direct_reply(bytes(range(256)), counter=7)]
    messages += assemble("COM_SET(SET_BRICKNAME, 'a /* ??/ b \\\\')\nmessage DIRECT_REPLY\nframe\nbytes 01 02")
    arrays = "\n".join(as_c(message, f"frame_{number}") for number, message in enumerate(messages))
    prints = "".join(
        f"    fwrite(frame_{number}, 1, sizeof frame_{number}, stdout);\n" for number in range(len(messages))
    )
    source = tmp_path / "frames.txt"
    source.write_text(f"#include <stdio.h>\n{arrays}\nint main(void) {{\n{prints}    return 0;\n}}\n", encoding="utf-8")
    program = tmp_path / "frames"
    flags = ["-Wall", "-Wextra", "-Werror", "-pedantic", f"-std={standard}", "-x", language]
    subprocess.run(["gcc", *flags, str(source), "-o", str(program)], check=True, timeout=60, env={**os.environ})
    done = subprocess.run([str(program)], check=True, capture_output=True, timeout=60)
    assert done.stdout == b"".join(message.build() for message in messages)


def test_json_of_a_conversation_reads_replies_by_their_commands() -> None:
    done = run(
        "--to",
        "json",
        "message counter 1 globals 4\nUI_READ(GET_VBATT, GV0(0))\nmessage DIRECT_REPLY counter 1\nbytes A4 70 FD 40",
    )
    reply = json.loads(done.output.splitlines()[1])
    assert reply["values"][0]["name"] == "VALUE"
    dialogue = Dialogue()
    dialogue.feed(parse(bytes.fromhex(json.loads(done.output.splitlines()[0])["hex"])))
    assert dialogue.feed(parse(bytes.fromhex(reply["hex"])))[0].value == pytest.approx(7.92)


def test_motors_in_step_are_two() -> None:
    said = b"note: OUTPUT_STEP_SYNC synchronizes two motors, but NOS has 1 motor: what that does is unknown"
    result = run_ev3proto("encode", "OUTPUT_STEP_SYNC(0, A, 50, 0, 360, 1)")
    assert (result.returncode, result.stderr.startswith(said)) == (0, True)
    assert run_ev3proto("encode", "OUTPUT_STEP_SYNC(0, A+B, 50, 0, 360, 1)").stderr == b""

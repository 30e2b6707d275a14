"""The Python side of the playground, without a browser."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playground import bridge
from playground.bridge.connection import PATIENCE
from playground.bridge.real_brick import RealBrick
from support.cli import run_ev3proto_text
from support.effort import effort
from support.frames import drawn
from support.scripts import PLAYGROUND

from ev3proto.brick import Brick
from ev3proto.testing import frames, mutated_frames

ROOT = Path(__file__).parents[2]

AFTER_THE_SNAPSHOT = """\
import json, sys
import bridge
warm_up, texts = json.load(sys.stdin)
for call, *given in warm_up:
    getattr(bridge, call)(*given)
known = set(sys.modules)
for text in texts:
    bridge.look(text)
    bridge.to_send()
    new = set(sys.modules) - known
    assert not new, (text, new)
"""


def test_the_snapshot_has_every_module_that_reading_needs(tmp_path: Path) -> None:
    """Modules that are not in the snapshot come later, in python.zip."""
    for script in PLAYGROUND.glob("*.js"):
        shutil.copy(script, tmp_path)
    (tmp_path / "package.json").write_text('{"type": "module"}')
    program = "import { WARM_UP } from './boot.js'; console.log(JSON.stringify(WARM_UP))"
    command = ["node", "--input-type=module", "--eval", program]
    warm_up = json.loads(subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True).stdout)
    texts = [
        "0x|08:00|2A:00|00|04:00|81:01:60|\n0x|07:00|2A:00|02|66:66:F6:40|",
        "0x|0B:00|2A:00|80|00:00|94:02:01:84:1B:00|",  # an escape, which is shown as \u001b
        "OUTPUT_POWR(0, 1, 50)",
        "Hello!",
        "vmthread MAIN\n{\n  UI_WRIT(LED, 1)\n}\n",
        *[each.hex() for strategy in (frames(), mutated_frames()) for each in drawn(strategy, effort(100, 2000))],
    ]
    environment = {**os.environ, "PYTHONPATH": str(PLAYGROUND)}
    done = subprocess.run(
        [sys.executable, "-c", AFTER_THE_SNAPSHOT],
        env=environment,
        input=json.dumps([warm_up, texts]),
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")


# The headline

TONE = "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
BATTERY = "0x|08:00|2A:00|00|04:00|81:01:60|"
PROGRAM = "vmthread MAIN\n{\n  UI_WRITE(LED, LED_ORANGE)\n}\n"
HOW_FRAMES_ARE_WRITTEN = (
    "Frames are written in hex, such as 06 00 2A 00 80 00 00 01. Operations are read, too: OUTPUT_POWER(0, 1, 50)."
)
BOTH = "The brick takes both commands."
HEADER_FIRST = "A brick needs its header first: length, counter, type and memory."


def read(text: str) -> dict[str, Any]:
    """What the page shows of a text."""
    answer: dict[str, Any] = json.loads(bridge.look(text))
    return answer


def offered() -> list[str]:
    """The labels of the buttons for what was read last."""
    return [each["label"] for each in json.loads(bridge.remedies())]


@pytest.mark.parametrize(
    ("text", "sentence", "kind", "verdict", "buttons"),
    [
        ("", "", "none", "", []),
        (TONE, "Plays 440 Hz for 1 s at volume 1 %.", "takes", "The brick takes it.", []),
        (
            "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03",
            "Plays 440 Hz for 1 s at volume 1 %.",
            "takes",
            "The brick takes it.",
            [],
        ),
        (
            TONE.replace("0E", "0F"),
            "Plays 440 Hz for 1 s at volume 1 %.",
            "refuses",
            "The brick refuses it at byte 16: the length field says that 15 bytes follow it, but there are 14: 14 is"
            " written 0E 00.",
            ["Set the length to 14"],
        ),
        (
            "0x|08:00|2A:00|00|05:00|81:01:61|",
            "Reads the battery voltage.",
            "refuses",
            "The brick refuses it at byte 7: VALUE of UI_READ.GET_VBATT must start at a multiple of 4: GV(0) is written"
            " 60.",
            ["Change 61 at byte 9 to 60"],
        ),
        (
            "0x|08:00|2A:00|00|01:00|81:01:60|",
            "Reads the battery voltage.",
            "takes",
            "The brick takes it, but it has an error: VALUE takes bytes 0 to 3 of global memory, but the header"
            " requests 1 byte of global memory.",
            ["Request 4 bytes of global and 0 of local memory"],
        ),
        (
            "0x|0D:00|2A:00|80|00:00|A5:00:01:32:A6:00:01|",
            "Sets the speed of motor A to -14 %, backward, then starts motor A.",
            "refuses",
            "The brick refuses it at byte 14: SPEED of OUTPUT_SPEED is a raw number: 50 is written 81 32.",
            ["Insert 81 at byte 10"],
        ),
        (
            "0x|0E:00|2A:00|80|00:00|94:01:01:82:0A:00:82:E8:03|",
            "Plays 10 Hz for 1 s at volume 1 %.",
            "takes",
            "The brick takes it, but it has a warning: FREQUENCY is 10 Hz, outside of 250 to 10000 Hz.",
            ["Write it in fewer bytes"],
        ),
        # Hints are not in the verdict.
        ("OUTPUT_POWER(0, 1, 50)", "Sets the power of motor A to 50 %.", "takes", "The brick takes it.", []),
        # Replies are not judged as commands.
        (
            "03 00 2A 00 04",
            "An error reply: command 42 failed.",
            "none",
            "It does not say why: check the command that it answers.",
            [],
        ),
        ("07 00 2A 00 02 66 66 F6 40", "A reply that answers command 42: ok, with 4 bytes of memory.", "none", "", []),
        (
            "08 00 2A 00 02 66 66 F6 40",
            "A reply that answers command 42: ok, with 4 bytes of memory.",
            "none",
            "The frame is cut off: its length field says that 8 bytes follow, but 7 do.",
            [],
        ),
        (
            "04 00 2A 00 05 9D",
            "An error reply.",
            "none",
            "The frame ends before the command answered and the status.",
            [],
        ),
        (
            "A5 00 01 32",
            "A frame without its header: sets the speed of motor A to -14 %, backward.",
            "none",
            f"{HEADER_FIRST} SPEED is -14 %, backward: that is what 32 by itself means; 50 is written 81 32.",
            ["Add a header"],
        ),
        (
            "94 01 01 82 B8 01 82 E8 03",
            "A frame without its header: plays 440 Hz for 1 s at volume 1 %.",
            "none",
            HEADER_FIRST,
            ["Add a header"],
        ),
        (
            "2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03",
            "A frame without its length: plays 440 Hz for 1 s at volume 1 %.",
            "none",
            "A brick needs its length first.",
            ["Add the length"],
        ),
        (
            "0A 2A 00 00 04 00 81 01 60",
            "A frame with a length of one byte: reads the battery voltage.",
            "none",
            "A brick needs its length first, in two bytes.",
            ["Write the length in two bytes"],
        ),
        (
            "0F:00:00:00:80",
            "A command of 5 bytes.",
            "refuses",
            "The brick refuses it at byte 5: the length field says that 15 bytes follow it, but there are 3.",
            [],
        ),
        (
            f"09:12:31.0 Sent {BATTERY}\n09:12:31.1 Recv 0x|07:00|2A:00|02|66:66:F6:40|\n09:12:31.2 Sent {BATTERY}\n",
            "A log of 3 frames: 2 commands and 1 reply.",
            "takes",
            BOTH,
            [],
        ),
        (
            f"Sent {BATTERY}\nSent 0x|08:00|2A:00|00|01:00|81:01:60|\nSent 0x|0A:00|2B:00|00|04:00|81:01:60|\n",
            "A log of 3 frames.",
            "refuses",
            "The brick refuses 1 of 3 commands; in line 3: the length does not count its own two bytes: it is 8"
            " (08 00).",
            ["Line 2: Request 4 bytes of global and 0 of local memory", "Line 3: Set the length to 8"],
        ),
        (
            "UI_WRITE(LED, 1)\nUI_WRITE(LED, 2)\n",
            "Sets the light around the buttons to LED_GREEN, then sets the light around the buttons to LED_RED.",
            "takes",
            "The brick takes it.",
            [],
        ),
        (
            f"{TONE}\n0x|zz:00|\n",
            "Plays 440 Hz for 1 s at volume 1 %.",
            "none",
            "The brick takes it, but not all of the input could be read.",
            [],
        ),
        (PROGRAM, "A program of 1 object and 32 bytes.", "takes", "The brick takes it.", []),
        (
            PROGRAM.replace("UI_WRITE", "UI_WRIT"),
            "A program with a mistake.",
            "none",
            "",
            ["Line 3: Change UI_WRIT to UI_WRITE"],
        ),
        (
            "OUTPUT_POWR(0, 1, 50)",
            "Operations with a mistake.",
            "none",
            "",
            ["Change OUTPUT_POWR to OUTPUT_POWER"],
        ),
        ("UI_WRITE(LED, LED_RDE)", "Operations with a mistake.", "none", "", ["Change LED_RDE to LED_RED"]),
        (
            "08 00 2A O0 00 04 00 81 0l 60",
            "A frame with letters for digits: reads the battery voltage.",
            "none",
            "Bytes are written with the digits 0 to 9 and the letters A to F.",
            ["Read O as 0 and l as 1"],
        ),
        # A right input has no button, in any notation.
        (
            "00000110 00000000 00101010 00000000 10000000 00000000 00000000 00000001",
            "Does nothing.",
            "takes",
            "The brick takes it.",
            [],
        ),
        ("06 00 2A 00 02 00 00 01", "A reply that answers command 42: ok, with 3 bytes of memory.", "none", "", []),
        # What a reply says, and what is wrong with it.
        (
            "06 00 2A 00 05 92 09 01",
            "An error reply that answers command 42: BEGIN_DOWNLOAD SIZE_ERROR (there is not enough room for a file of"
            " that size, or the frame had more data than announced).",
            "none",
            "",
            [],
        ),
        ("04 00 2A 00 02 01", "A reply that answers command 42: ok, with 1 byte of memory.", "none", "", []),
        (
            "03 00 2A 00 02 FF",
            "A reply that answers command 42: ok.",
            "none",
            "1 byte follows it that its length field does not count.",
            [],
        ),
        (
            "2A 00 02 66 66 F6 40",
            "A reply without its length, which answers command 42: ok, with 4 bytes of memory.",
            "none",
            "A reply begins with its length.",
            ["Add the length"],
        ),
        (f"Recv {TONE}", "A command that came from the brick: plays 440 Hz for 1 s at volume 1 %.", "none", "", []),
        (
            f"Sent {BATTERY}\nRecv 03 00 2A 00 04\n",
            "A log of 2 frames: 1 command and 1 reply.",
            "takes",
            "The brick takes the command. 1 reply says that a command failed.",
            [],
        ),
        (
            f"Sent {BATTERY}\nRecv 08 00 2A 00 02 66 66 F6 40\n",
            "A log of 2 frames: 1 command and 1 reply.",
            "takes",
            "The brick takes the command. 1 reply cannot be right.",
            [],
        ),
        (
            "03 00 2A 00 04\n03 00 2B 00 04",
            "A log of 2 frames: 2 replies.",
            "none",
            "2 replies say that a command failed.",
            [],
        ),
        # Two frames in a line are a log.
        (
            "08002A0000040081016007002A00026666F640",
            "A log of 2 frames: 1 command and 1 reply.",
            "takes",
            "The brick takes the command.",
            [],
        ),
        # Bytes that lack a part of a frame.
        (
            "82 1B 02",
            "A frame without its header: sets the light around the buttons to LED_RED.",
            "none",
            HEADER_FIRST,
            ["Add a header"],
        ),
        (
            "165 0 1 129 50",
            "A frame without its header: sets the speed of motor A to 50 %.",
            "none",
            HEADER_FIRST,
            ["Add a header"],
        ),
        (
            "08 00 2A 00 00 04 00 81 01 60 AA BB CC DD EE FF 11 22",
            "Reads the battery voltage.",
            "takes",
            "The brick takes it, but it has an error: 8 bytes at the end are not part of the frame.",
            ["Remove 8 bytes at byte 10"],
        ),
        (
            "A4 00 01 81 32\nA6 00 01\n",
            "A frame without its header: sets the power of motor A to 50 %, then starts motor A.",
            "none",
            HEADER_FIRST,
            ["Add a header"],
        ),
        (
            "Sent: A5 00 01 81 32",
            "A text without a frame.",
            "none",
            "",
            ["Add a header"],
        ),
        (
            "06 2A 00 80 00 00 01",
            "A frame with a length of one byte: does nothing.",
            "none",
            "A brick needs its length first, in two bytes.",
            ["Write the length in two bytes"],
        ),
        (
            "00 00 2A 00 80 00 00 01",
            "A command of 8 bytes.",
            "refuses",
            "The brick refuses it at byte 7: the length field says that 0 bytes follow it, but there are 6: 6 is"
            " written 06 00.",
            ["Set the length to 6"],
        ),
        (
            "06 00 2A",
            "3 bytes, not a frame.",
            "refuses",
            "The brick refuses it at byte 0: a frame has at least 5 bytes (length, counter, type), this one has 3.",
            [],
        ),
        (
            "04 00 2A 00 01 42",
            "Sends the unknown system command 0x42.",
            "refuses",
            "The brick refuses it at byte 5: unknown system command 0x42.",
            [],
        ),
        (
            "vmthread MAIN\n{\n  DATA8 x\n  MOVE8_8(300, x)\n}\n",
            "A program of 1 object and 34 bytes.",
            "refuses",
            "The brick refuses it at byte 28: MOVE8_8 of object 1: its first constant is out of range.",
            [],
        ),
        (
            "0B 00 00 00 00 01 00 99 1D 00 00 00 02 01 60",
            "Reads port 1 in SI units, when it is ready.",
            "refuses",
            "The brick refuses it at byte 7: the length field says that 11 bytes follow it, but there are 13: 13 is"
            " written 0D 00.",
            ["Request 4 bytes of global and 0 of local memory, and set the length to 13"],
        ),
        (
            f"1. {BATTERY}\n2. 0x|08:00|2A:00|00|01:00|81:01:60|\n3. 0x|08:00|2B:00|00|01:00|81:01:60|\n",
            "A log of 3 frames.",
            "takes",
            "The brick takes all 3 commands, but 2 of them have errors; in line 2: VALUE takes bytes 0 to 3 of global"
            " memory, but the header requests 1 byte of global memory.",
            [
                "Line 2: Request 4 bytes of global and 0 of local memory",
                "Line 3: Request 4 bytes of global and 0 of local memory",
            ],
        ),
        ("1. 08 00 2A 00 00 04 00 81 01 60\n2. 08 00 2B 00 00 04 00 81 01 60", "A log of 2 frames.", "takes", BOTH, []),
        ("http://192.168.0.1:5555", "A text without a frame.", "none", HOW_FRAMES_ARE_WRITTEN, []),
        ("Hello, how does a robot drive?", "A text without a frame.", "none", HOW_FRAMES_ARE_WRITTEN, []),
    ],
)
def test_a_headline(text: str, sentence: str, kind: str, verdict: str, buttons: list[str]) -> None:
    headline = read(text)["headline"]
    assert (headline["sentence"], headline["kind"], headline["verdict"]) == (sentence, kind, verdict)
    assert offered() == buttons


@pytest.mark.parametrize(
    ("text", "made"),
    [
        (TONE.replace("0E", "0F"), TONE),
        # Each in its own notation.
        (
            "{0x0A, 0x00, 0x2A, 0x00, 0x00, 0x04, 0x00, 0x81, 0x01, 0x60}",
            "{0x08, 0x00, 0x2A, 0x00, 0x00, 0x04, 0x00, 0x81, 0x01, 0x60}",
        ),
        ("A5 00 01 32", "0x|09:00|00:00|80|00:00|A5:00:01:32|"),
        ("08 00 2A O0 00 04 00 81 0l 60", BATTERY),
        ("OUTPUT_POWR(0, 1, 50)  // mine", "OUTPUT_POWER(0, 1, 50)  // mine"),
        ("SOUND(TOEN, 1, 440, 1000)", "SOUND(TONE, 1, 440, 1000)"),
        (PROGRAM.replace("_ORANGE", "_ORANG"), PROGRAM),
        (
            "# mine\n2026-01-01 Sent 0x|0A:00|2B:00|00|04:00|81:01:60|\n",
            "# mine\n2026-01-01 Sent 0x|08:00|2B:00|00|04:00|81:01:60|\n",
        ),
    ],
)
def test_a_button_makes_the_change_that_it_names(text: str, made: str) -> None:
    read(text)
    (remedy,) = json.loads(bridge.remedies())
    assert remedy["text"] == made
    assert read(made)["error"] == ""


def test_several_certain_changes_are_also_made_together() -> None:
    wrong = "Sent 0x|0A:00|2A:00|00|04:00|81:01:60|\nSent 0x|0A:00|2B:00|00|04:00|81:01:60|\n"
    read(wrong)
    assert offered() == ["Line 1: Set the length to 8", "Line 2: Set the length to 8", "Make all of these changes"]
    assert json.loads(bridge.remedies())[2]["text"] == wrong.replace("0A", "08")


def test_what_is_wrong_is_said_once() -> None:
    """Findings have no verdict of their own, and errors are what cannot be read."""
    for text in (TONE, TONE.replace("0E", "0F"), "03 00 2A 00 04", "07 00 2A 00 02 66 66 F6 40", BATTERY + "\n" + TONE):
        answer = read(text)
        assert answer["error"] == ""
        lines = ["".join(piece[0] for piece in line) for block in answer["findings"] for line in block["lines"]]
        assert [line for line in lines if "the brick" in line or "did you mean" in line or "accepted" in line] == []
        assert [block["codes"] for block in answer["findings"]] == ([["E102"]] if "0F" in text else [])


LOG = f"Sent {BATTERY}\nRecv 07 00 2A 00 02 66 66 F6 40\nSent 0x|0A:00|2B:00|00|04:00|81:01:60|\n"


@pytest.mark.parametrize(
    ("text", "kind", "commands", "frames"),
    [
        (TONE, "takes", [True], 1),
        (TONE.replace("0E", "0F"), "refuses", [False], 1),
        ("6,0,42,0,128,0,0,1", "takes", [True], 1),
        ("0x|08:00|2A:00|00|01:00|81:01:60|", "takes", [True], 1),
        ("03 00 2A 00 04", "none", [], 1),
        (LOG, "refuses", [True, False], 3),
        (f"{BATTERY} {TONE}", "takes", [True, True], 2),
        ("82 1B 02", "none", [], 0),
        ("2A 00 02 66 66 F6 40", "none", [], 0),
        ("http://192.168.0.1:5555", "none", [], 0),
        ("Hello, how does a robot drive?", "none", [], 0),
    ],
)
def test_the_command_line_says_the_same(text: str, kind: str, commands: list[bool], frames: int) -> None:
    answer = read(text)
    assert (answer["headline"]["kind"], answer["count"]) == (kind, frames)
    checked = run_ev3proto_text("check", "--json", "-", stdin=text).stdout.splitlines()
    assert [json.loads(line)["accepted"] for line in checked] == commands
    assert len(run_ev3proto_text("decode", "--json", "-", stdin=text).stdout.splitlines()) == frames


@pytest.mark.parametrize("text", ["OUTPUT_POWER(0, 16, 50)", "INFO(GET_VOLUME, GV0(0))", "ADD8(1, 2, GV0(0))"])
def test_the_command_line_takes_the_same_operations(text: str) -> None:
    """Values outside of a range are a warning of the check; letters of hex in a name are not bytes."""
    assert read(text)["headline"]["kind"] == "takes"
    assert json.loads(run_ev3proto_text("check", "--json", text).stdout)["accepted"]


def opened(name: str, contents: bytes, expression: str = "") -> dict[str, Any]:
    """What the page shows of a file."""
    Path(json.loads(bridge.place(name))).write_bytes(contents)
    number = json.loads(bridge.start("open_file", name, expression))
    step: dict[str, Any] = {"part": 0}
    while "part" in step:
        step = json.loads(bridge.go_on(number))
    answer: dict[str, Any] = step["answer"]
    return answer


@pytest.fixture
def folder() -> Iterator[None]:
    """The folder of the file that is opened, which is gone afterwards."""
    yield
    bridge.begin()


@pytest.mark.usefixtures("folder")
def test_a_file_and_a_filter() -> None:
    captures = ROOT / "captures"
    for name, expression, sentence in (
        ("wifi.pcapng", "", "A capture of 42 frames: 24 commands and 18 replies."),
        ("wifi.pcapng", "op==SOUND.TONE", "The filter matches 1 of the 42 frames of a capture."),
        ("lesson-02.log", "", "A log of 20 frames: 19 commands and 1 reply."),
        ("README.md", "", "A file without a frame."),
    ):
        assert opened(name, (captures / name).read_bytes(), expression)["headline"]["sentence"] == sentence


@pytest.mark.usefixtures("folder")
def test_a_damaged_program_has_a_headline() -> None:
    answer = opened("robot.rbf", b"LEGO\x10\x00")
    assert answer["headline"]["verdict"] == (
        "The brick refuses it at byte 0: an image starts with a header of 16 bytes, not 6."
    )
    assert answer["error"] == ""


def test_frames_in_the_notations_of_other_programs() -> None:
    made = read(BATTERY)["made"]
    assert (made["lesson"], made["hex"]) == (BATTERY, "08 00 2A 00 00 04 00 81 01 60")
    assert made["javascript"] == (
        "const frame = new Uint8Array([0x08, 0x00, 0x2a, 0x00, 0x00, 0x04, 0x00, 0x81, 0x01, 0x60]);"
    )
    assert "const unsigned char frame[10] = {" in made["c"]
    assert made["python"].endswith("frame = b'\\x08\\x00*\\x00\\x00\\x04\\x00\\x81\\x01`'")
    assert made["operations"].endswith("\nUI_READ(GET_VBATT,GV0(0))")
    both = read(f"{BATTERY}\n{TONE}\n")["made"]
    assert both["hex"].split("\n")[1] == "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"
    assert both["javascript"].split("\n")[1].startswith("const frame_2 = new Uint8Array([0x0e, 0x00,")


# A real brick


def test_a_session_with_a_brick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Commands wait for the answers of those before them; an answer may come late, or unasked, or not at all."""
    battery = bytes.fromhex("08002a00000400810160")
    now = 1000.0
    carried: list[str] = []
    news: list[dict[str, Any]] = []
    monkeypatch.setattr("time.monotonic", lambda: now)
    real = RealBrick("bluetooth", carried.append, lambda said: news.append(json.loads(said)))
    brick = Brick(tmp_path)

    def shown() -> list[str]:
        return ["".join(piece[0] for piece in line) for answer in news[-1]["answers"] for line in answer]

    assert real.send([battery, battery], is_allowed=False) == {}
    assert carried == [battery.hex()]
    real.sent(10.0)
    (reply,) = brick.receive(battery)
    real.heard(reply, 12.5)
    assert carried == [battery.hex()] * 2
    assert shown()[1] == "answered after 2.5 ms:"
    now += PATIENCE + 1
    real.turn()
    assert shown()[-1] == "no answer within 5 s; a late one is shown when it comes"
    real.heard(reply, 7000.0)
    assert "answered late, after 7000.0 ms:" in shown()
    # What moves is asked about first, and motors stop without a question.
    start = bytes.fromhex("08002c00800000a60001")
    assert list(real.send([start], is_allowed=False)) == ["ask"]
    real.stop_motors()
    assert carried[-1][8:] == "800000a3000f01"
    real.gone("unplugged")
    assert not real.connection.is_open
    assert real.connection.recording().startswith(b"\x0a\x0d\x0d\x0a")

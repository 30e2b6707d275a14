"""The playground's first frame without Python: its lines and its header are those that Python's bridge makes."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from random import Random

from playground import bridge
from support.built import built_export
from support.cases import each
from support.effort import effort
from support.frames import drawn
from support.scripts import PLAYGROUND

from ev3proto.testing import frames, mutated_frames

PROGRAM = """\
import { readFileSync } from "node:fs";
import { firstAnswer } from "./first.js";
const answers = JSON.parse(readFileSync(0, "utf8")).map(firstAnswer);
const shown = ({ lines, about, headline }) => ({ lines, parts: about?.parts, sentence: headline.sentence });
console.log(JSON.stringify(answers.map((answer) => answer && shown(answer))));
"""


def first_answers(folder: Path, texts: list[str]) -> list[dict[str, object] | None]:
    """What the page shows of each text before Python is there."""
    for name in ("ev3-decode.mjs", "ev3-texts.mjs"):
        shutil.copy(built_export(name), folder)
    for name in ("first.js", "places.js", "rows.js"):
        shutil.copy(PLAYGROUND / name, folder)
    (folder / "package.json").write_text('{"type": "module"}')
    words = ["node", "--input-type=module", "--eval", PROGRAM]
    done = subprocess.run(words, input=json.dumps(texts), cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    answers: list[dict[str, object] | None] = json.loads(done.stdout)
    return answers


RANDOM = Random(80)


def with_a_wrong_length(frame: bytes) -> bytes:
    """One that says 1 to 3 bytes too many or too few, or one that is cut off."""
    length = max(int.from_bytes(frame[:2], "little") + RANDOM.choice([-2, -1, 1, 2, 3]), 3)
    cut = frame[: RANDOM.randrange(5, len(frame) + 1)]
    return RANDOM.choice([length.to_bytes(2, "little") + frame[2:], cut])


def test_drawn_frames_are_shown_as_python_shows_them(tmp_path: Path) -> None:
    strategies, count = (frames(), mutated_frames()), effort(150, 5000)
    # A shorter text is not taken for a frame.
    given = [one for strategy in strategies for one in drawn(strategy, count) if len(one) > 4]
    given += map(with_a_wrong_length, given[: effort(40, 2000)])
    shown = 0
    for frame, answer in zip(given, first_answers(tmp_path, [frame.hex() for frame in given]), strict=True):
        if answer is None or not answer["lines"]:
            continue  # Python may see something else in it
        shown += 1
        page = json.loads(bridge.look(frame.hex()))
        assert answer["lines"] == page["lines"], frame.hex()
        assert page["frames"] == {"0": frame.hex()}
        assert answer["parts"] == json.loads(bridge.about(frame.hex()))["parts"], frame.hex()
    assert shown > 0.6 * len(given)


TONE_SAID = "DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes"
LONGER = "fault at offset {}: the frame is longer than its length field says: {} bytes should follow it, but {} do"
SHORTER = "fault at offset 0: the frame is cut off: its length field says that {} bytes follow, but {} do"


@each(
    "text, said, is_whole",
    [
        ("0e002a0080000094010182b80182e803", TONE_SAID, True),
        (" 0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|\n", TONE_SAID, True),
        ("0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03", TONE_SAID, True),
        # Its length counts itself; it counts far too many bytes; its end is cut off.
        ("0x|10:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|", SHORTER.format(16, 14), False),
        ("20002a0080000094010182b80182e803", SHORTER.format(32, 14), False),
        ("0e002a0080000094010182b801", SHORTER.format(14, 11), False),
        # Its length counts too few, and far too many.
        ("0c002a0080000094010182b80182e803", LONGER.format(14, 12, 14), False),
        ("0700a4d500", SHORTER.format(7, 3), False),
        # It says how much of a file came.
        ("0d0001000192030000002e2e2f6100", "SYSTEM_COMMAND_REPLY, counter 1, 15 bytes: BEGIN_DOWNLOAD", False),
    ],
)
def test_one_frame_in_hex_is_read(text: str, said: str, is_whole: bool, tmp_path: Path) -> None:
    """What may be another frame for Python has its headline and no more."""
    (answer,) = first_answers(tmp_path, [text])
    assert answer is not None
    assert (answer["sentence"], bool(answer["lines"])) == (said, is_whole)


def test_no_other_text_is_read(tmp_path: Path) -> None:
    waiting = [
        "05 00 01 00 02 10 20",  # may be decimal
        "SOUND(TONE, 1, 440, 1000)",
        "Sent 0x|08:00|2A:00|00|04:00|81:01:60|",
        "0e002a0080000094010182b80182e803\n0e002a0080000094010182b80182e803",
        "0e002a0077000094010182b80182e803",  # there is no such type
        "",
    ]
    assert first_answers(tmp_path, waiting) == [None] * len(waiting)

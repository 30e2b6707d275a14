"""The playground's first frame without Python: its lines and its header are those that Python's bridge makes."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

from playground import bridge
from support.built import built_export
from support.effort import effort
from support.frames import drawn
from support.scripts import PLAYGROUND

from ev3proto.testing import frames, mutated_frames

PROGRAM = """\
import { readFileSync } from "node:fs";
import { firstAnswer } from "./first.js";
const answers = JSON.parse(readFileSync(0, "utf8")).map(firstAnswer);
const shown = ({ lines, about: { parts, sentence } }) => ({ lines, parts, sentence });
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


def test_drawn_frames_are_shown_as_python_shows_them(tmp_path: Path) -> None:
    # A shorter text is not taken for a frame.
    given = [
        each
        for strategy in (frames(), mutated_frames())
        for each in drawn(strategy, effort(150, 5000))
        if len(each) > 4
    ]
    shown = 0
    for frame, answer in zip(given, first_answers(tmp_path, [frame.hex() for frame in given]), strict=True):
        if answer is None:
            continue  # Python may see something else in it
        shown += 1
        page = json.loads(bridge.look(frame.hex()))
        assert answer["lines"] == page["lines"], frame.hex()
        assert page["frames"] == {"0": frame.hex()}
        assert answer["parts"] == json.loads(bridge.about(frame.hex()))["parts"], frame.hex()
    assert shown > 0.6 * len(given)


def test_only_one_frame_in_hex_is_read(tmp_path: Path) -> None:
    read = [
        "0e002a0080000094010182b80182e803",
        " 0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|\n",
        "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03",
    ]
    waiting = [
        "05 00 01 00 02 10 20",  # may be decimal
        "SOUND(TONE, 1, 440, 1000)",
        "Sent 0x|08:00|2A:00|00|04:00|81:01:60|",
        "0e002a0080000094010182b80182e803\n0e002a0080000094010182b80182e803",
        "0c002a0080000094010182b80182e803",  # its length is too short: Python may see another frame behind it
        "0700a4d500",  # its length is too long: Python sees a text that lost its zeros
        "",
    ]
    answers = first_answers(tmp_path, read + waiting)
    assert [answer and answer["sentence"] for answer in answers] == [
        *["DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes"] * len(read),
        *[None] * len(waiting),
    ]

"""What `cat /sys/kernel/debug/usb/usbmon/1u` prints is a capture, of which each report has 32 bytes."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text

from ev3proto.capture import CaptureError, read

ASKED = (
    "ffff8ec5c6c0f0c0 4095999800 S Io:1:007:1 -115:4 1024 = "
    "08000100 00040081 01600000 00000000 00000000 00000000 00000000 00000000\n"
    "ffff8ec5c6c0f0c0 4095999900 C Io:1:007:1 0:4 1024 >\n"
    "ffff8ec5c6c0f180 4095999950 S Ii:1:007:1 -115:4 1024 <\n"
)
ANSWERED = (
    "ffff8ec5c6c0f180 3000 C Ii:1:007:1 0:4 1024 = "
    "07000100 02a470fd 40000000 00000000 00000000 00000000 00000000 00000000\n"
)
PLUGGED_IN = (
    "dfbf8000 4095999000 S Ci:1:007:0 s 80 06 0100 0000 0012 18 <\n"
    "dfbf8000 4095999200 C Ci:1:007:0 0 18 = 12010002 00000040 94060500 16020102 0301\n"
)
OF_OTHERS = (
    "d5ea89a0 4095999210 S Zi:1:004:3 -115:1:0 2 -18:0:192 -18:192:192 384 <\n"
    "d5ea89a0 4095999220 C Zi:1:004:3 0:1:123:0 2 0:0:192 0:192:4 384 = 00112233 44\n"
    "dd65f0e8 4095999230 E Bo:1:005:2 -22 31 <\n"
    "dd65f0e8 4095999240 S Ci:1:002:0 - __ __ ____ ____ ____ 4 <\n"
    "dd65f0e8 4095999250 C Ci:1:002:0 -32 0\n"
)
DIALOGUE = "    0.000000     #1 UI_READ.GET_VBATT(VALUE=GV(0)) -> VALUE=7.92 V  3.200 ms\n"


@pytest.mark.parametrize("before", ["", "\n", "# sudo cat 1u > robot.txt\n\n", "\ufeff", "#" * 4000 + "\n"])
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_a_command_and_its_reply(before: str, newline: str) -> None:
    """The kernel's time starts again after 4096 s, here between command and reply."""
    text = (before + ASKED + ANSWERED).replace("\n", newline)
    shown = run_ev3proto_text("decode", "--dialogues", "-", stdin=text)
    assert (shown.returncode, shown.stdout, shown.stderr) == (0, f"usb 1.7\n{DIALOGUE}", "")


def test_requests_of_all_kinds_are_packets() -> None:
    text = PLUGGED_IN + OF_OTHERS + ASKED + ANSWERED
    with read(io.BytesIO(text.encode())) as capture:
        records = list(capture)
    assert [(each.number, each.time_ns, each.peer) for each in records] == [
        (8, 800_000, "1.7"),
        (11, 4_000_000, "1.7"),
    ]
    assert (capture.account.packets, capture.account.cut, capture.account.balance) == (11, 3, 0)


def test_a_known_brick_is_shown_whatever_it_says() -> None:
    wrong = ASKED.replace("00040081", "000400ff")
    assert "no frame in 3 packets" in run_ev3proto_text("decode", "-", stdin=wrong).stderr
    shown = run_ev3proto_text("decode", "-", stdin=PLUGGED_IN + wrong)
    assert "usb 1.7 sent DIRECT_COMMAND_REPLY, counter 1, 10 bytes" in shown.stdout


def test_lines_that_cannot_be_read_are_told_after_the_others() -> None:
    text = "\n" + ASKED + "ffff8ec5c6c0f180 2500 C Ii:1:007:1 0:4 10\xb94 = 0700\n" + ANSWERED + ANSWERED[:60]
    capture = read(io.BytesIO(text.encode()))
    frames: list[str] = []
    with pytest.raises(CaptureError, match=r"^2 lines cannot be read, the first is line 5$"):
        frames.extend(record.frame.hex() for record in capture)
    assert frames == ["08000100000400810160", "0700010002a470fd40"]


def test_frames_in_hex_are_not_usbmons_text(tmp_path: Path) -> None:
    for text in (
        "080001000004 00810160\n",
        "0800 0100 0004 0081 0160",
        "08000100000400810160",
        "#\n08000100000400810160",
    ):
        path = tmp_path / "robot.log"
        path.write_text(text)
        assert "UI_READ.GET_VBATT" in run_ev3proto_text("decode", path).stdout

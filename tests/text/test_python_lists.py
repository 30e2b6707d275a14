"""`encode` makes frames of operations in Python, as in programs for ev3_dc, and of assembly in full-width signs."""

from __future__ import annotations

import pytest
from support.cli import run_ev3proto_text

TONE = "0x|0E:00|00:00|80|00:00|94:01:01:82:B8:01:82:E8:03|\n"
PROGRAMS = {
    "ops = b''.join([\n    ev3.opSound,\n    ev3.TONE,\n    ev3.LCX(1),    # VOLUME\n    ev3.LCX(440),\n"
    "    ev3.LCX(1000),\n])\nmy_ev3.send_direct_cmd(ops)\n": TONE,
    'import ev3_dc as ev3\n\nmy_ev3 = ev3.EV3(protocol=ev3.USB)\nops = b"".join((ev3.opSound, ev3.TONE, ev3.LCX(1), '
    "ev3.LCX(440), ev3.LCX(1000)))\n": TONE,
    "ops = ev3.opUI_Write + ev3.LED + ev3.LED_RED": "0x|08:00|00:00|80|00:00|82:1B:02|\n",
    "from ev3_dc import *\nops = opUI_Read + GET_VBATT + GVX(0)\n": "0x|08:00|00:00|00|04:00|81:01:60|\n",
    "# a car\nops = b''.join([ev3.opOutput_Power, ev3.LCX(0), ev3.LCX(ev3.PORT_A + ev3.PORT_D),\n ev3.LCX(50),"
    "\n ev3.opOutput_Start, ev3.LCX(0), ev3.LCX(9)])": "0x|0D:00|00:00|80|00:00|A4:00:09:81:32:A6:00:09|\n",
    "a = ev3.opUI_Write + ev3.LED + ev3.LED_RED\nb = ev3.opUI_Read + ev3.GET_VBATT + ev3.GVX(0)\n": (
        "0x|08:00|00:00|80|00:00|82:1B:02|\n0x|08:00|01:00|00|04:00|81:01:60|\n"
    ),
    "my_ev3.send_direct_cmd(ev3.opSound + ev3.TONE + ev3.LCX(1) + ev3.LCX(440) + ev3.LCX(1000))": TONE,
    "ops = ev3.opNop\nops += ev3.opSound + ev3.BREAK\nmy_ev3.send_direct_cmd(ops)": (
        "0x|08:00|00:00|80|00:00|01:94:00|\n"
    ),
    "SOUND(TONE\u30011\u3001440\u30011000)": TONE,
    "SOUND\uff08TONE\uff0c1\uff0c440\uff0c1000\uff09": TONE,
}


@pytest.mark.parametrize("text", PROGRAMS)
def test_operations_in_python_become_frames(text: str) -> None:
    done = run_ev3proto_text("encode", "-", stdin=text)
    assert (done.stdout, done.stderr) == (PROGRAMS[text], "")


def test_an_unknown_name_has_its_place_in_the_program() -> None:
    done = run_ev3proto_text(
        "encode",
        "-",
        stdin="ops = b''.join([\n  ev3.opSound, ev3.TONE, # loud\n    ev3.LCX(volume), ev3.LCX(440), ev3.LCX(9)])\n",
    )
    assert done.returncode == 1
    assert "standard input, line 3, column 13: unknown variable or constant volume" in done.stderr


def test_bytes_in_python_stay_frames() -> None:
    done = run_ev3proto_text(
        "encode", "-", stdin="b''.join([\n  b'\\x06\\x00\\x2a\\x00',\n  b'\\x80\\x00\\x00\\x01'])\n"
    )
    assert done.stdout == "0x|06:00|2A:00|80|00:00|01|\n"

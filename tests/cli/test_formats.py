"""The formats of `decode --format`: what each shows, and CSV in detail."""

from __future__ import annotations

import csv
import io
import sys
from pathlib import Path

from support.cases import each
from support.cli import run_ev3proto_text as run
from support.cli import run_program
from support.programs import image_of

TONE = "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"
BATTERY = "08 00 01 00 00 04 00 81 01 60"
VOLTS = "07 00 01 00 02 A4 70 FD 40"


def table(*words: str | Path) -> list[list[str]]:
    return list(csv.reader(io.StringIO(run("decode", "--format", "csv", *words).stdout)))


def test_csv_has_a_row_for_each_argument_value_and_field(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(
        f"09:12:31.5 sent {TONE}\n09:12:32.0 sent {BATTERY}\n09:12:32.1 received {VOLTS}\n"
        "09:12:33.0 sent 0C 00 02 00 01 99 E8 03 2F 70 72 6A 73 00\n"
        "09:12:33.1 received 0F 00 02 00 03 99 08 05 00 00 00 00 61 2E 72 62 66\n"
    )
    assert table(log) == [
        ["time", "direction", "connection", "counter", "offset", "operation", "name", "value", "unit"],
        ["09:12:31.5", "sent", "1", "42", "9", "SOUND.TONE", "VOLUME", "1", "%"],
        ["09:12:31.5", "sent", "1", "42", "10", "SOUND.TONE", "FREQUENCY", "440", "Hz"],
        ["09:12:31.5", "sent", "1", "42", "13", "SOUND.TONE", "DURATION", "1000", "ms"],
        ["09:12:32.0", "sent", "1", "1", "9", "UI_READ.GET_VBATT", "VALUE", "GV(0)", ""],
        ["09:12:32.1", "received", "1", "1", "5", "UI_READ.GET_VBATT", "VALUE", "7.92", "V"],
        ["09:12:33.0", "sent", "1", "2", "6", "LIST_FILES", "max_bytes", "1000", ""],
        ["09:12:33.0", "sent", "1", "2", "8", "LIST_FILES", "path", "/prjs", ""],
        ["09:12:33.1", "received", "1", "2", "6", "LIST_FILES", "status", "END_OF_FILE", ""],
        ["09:12:33.1", "received", "1", "2", "7", "LIST_FILES", "list_size", "5", ""],
        ["09:12:33.1", "received", "1", "2", "11", "LIST_FILES", "handle", "0", ""],
        ["09:12:33.1", "received", "1", "2", "12", "LIST_FILES", "list", "a.rbf", ""],
    ]


@each(
    "frame, rows",
    [
        ("06 00 2A 00 80 00 00 01", ["7,NOP,,,"]),  # nothing but an operation
        ("05 00 2A 00 80 00 00", ["4,,,,"]),
        ("03 00 2A 00 02", ["4,,status,ok,"]),
        ("03 00 2A 00 04", ["4,,status,error,"]),
        ("05 00 01 00 05 99 06", ["6,LIST_FILES,status,ILLEGAL_PATH,"]),
        ("07 00 2A 00 02 AA BB CC DD", ["5,,memory,AA BB CC DD,"]),
        ("08 00 2A 00 0A A2 01 00 01 94", ["6,INFO,layer_from,1,", "7,INFO,layer_to,0,", "8,INFO,payload,01 94,"]),
        ("06 00 2A 00 80 00 00 FE", ["7,,fault,unknown opcode 0xFE for the official firmware,"]),
        ("02 00 2A 00", ['4,,fault,"a frame has at least 5 bytes (length, counter, type), this one has 4",']),
        (
            "05 00 2A 00 03 99 ",
            ['0,,fault,"the frame is cut off: its length field says that 5 bytes follow, but 4 do",'],
        ),
        (
            "0E 00 xx 00 80 00 00 94 01 xx 82 B8 01 82 E8 03",
            ["9,SOUND.TONE,VOLUME,?,%", "10,SOUND.TONE,FREQUENCY,440,Hz", "13,SOUND.TONE,DURATION,1000,ms"],
        ),
    ],
)
def test_csv_has_at_least_one_row_for_each_message(frame: str, rows: list[str]) -> None:
    shown = run("decode", "--format", "csv", frame).stdout.splitlines()[1:]
    assert [line.split(",", 4)[4] for line in shown] == rows


def test_a_text_in_csv_is_never_a_formula(tmp_path: Path) -> None:
    """Spreadsheets calculate cells that begin so; a capture may come from anybody."""
    for text in ("=cmd", "+1+1", "-1-cmd", "@SUM", "\tx"):
        fields = bytes.fromhex("02 00 01 99 E8 03") + text.encode() + b"\0"
        (path,) = [row[7] for row in table((bytes((len(fields), 0)) + fields).hex(" ")) if row[6] == "path"]
        assert path in (f"'{text}", "\\u0009x")
    assert table("0A 00 02 00 01 99 E8 03 2D 30 37 00")[2][7] == "-07"  # a number
    minus = table("09 00 2A 00 80 00 00 A4 00 01 32")
    assert [row[7] for row in minus if row[6] == "POWER"] == ["-14"]


def test_a_text_in_the_csv_of_values_is_never_a_formula(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    name = b"=HYPERLINK(1)\0"
    asked = bytes.fromhex("09 00 01 00 00 10 00 D3 0D 10 60")
    log.write_text(
        f"sent {asked.hex(' ')}\nreceived {(bytes((3 + 16, 0, 1, 0, 2)) + name.ljust(16, bytes(1))).hex(' ')}\n"
    )
    shown = run("values", "--csv", log).stdout.splitlines()
    assert shown[1].endswith(",'=HYPERLINK(1)"), shown


def test_a_format_that_does_not_show_programs_or_messages_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "robot.rbf"
    path.write_bytes(image_of((0, 0, "0A")))
    for style in ("table", "sentence", "csv"):
        done = run("decode", "--format", style, path)
        assert done.returncode == 2
        assert (
            f"--format {style} is for messages; for programs there is tree, asm, lego, json or listing" in done.stderr
        )
        assert done.stdout == ""
    done = run("decode", "--format", "listing", TONE)
    assert done.returncode == 2
    assert "--format listing is for programs; for messages there is tree, table, sentence" in done.stderr


INVENTED = """
import sys
from ev3proto.cli.formats import OUTPUT_FORMATS, Format
from ev3proto.cli.main import main

class Sizes(Format):
    def message(self, exchange, seen, rest=b""):
        self._printer.text(f"{len(exchange.message.build())} bytes")

OUTPUT_FORMATS["sizes"] = Sizes
main()
"""


def test_an_invented_format_is_one_class_and_one_line(tmp_path: Path) -> None:
    """The recipe of CONTRIBUTING."""
    program = tmp_path / "invented.py"
    program.write_text(INVENTED)
    assert run_program(sys.executable, program, "decode", "--format", "sizes", TONE).stdout == "16 bytes\n"
    assert "sizes" in run_program(sys.executable, program, "decode", "--help").stdout
    refused = run_program(sys.executable, program, "decode", "--format", "listing", TONE)
    assert "json, csv or sizes" in refused.stderr

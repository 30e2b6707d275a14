"""`ev3proto values`: the values in replies over time, as a table, CSV, JSON and a picture."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text as run

import ev3proto.capture.series
import ev3proto.cli.values
from ev3proto.capture.plot import draw
from ev3proto.capture.series import Row, Series

pytestmark = pytest.mark.portable

CAPTURES = Path(__file__).parents[2] / "captures"
PLUGGED = str(CAPTURES / "usb-plugged.pcap")
BATTERY = ("--filter", "op == UI_READ.GET_VBATT")


def test_a_table() -> None:
    done = run("values", PLUGGED, *BATTERY)
    assert done.returncode == 0
    assert [line.split("  ") for line in re.sub(r" {3,}", "  ", done.stdout).splitlines()] == [
        ["time [s]", "packet", "latency [s]", "UI_READ.GET_VBATT.VALUE [V]"],
        ["0.004000", "3", "0.004", "7.92"],
        ["0.076790", "34", "0.004", "7.88"],
    ]


def test_comma_separated_values() -> None:
    done = run("values", PLUGGED, *BATTERY, "--csv")
    first, *rows = csv.reader(io.StringIO(done.stdout))
    assert first == ["time", "packet", "peer", "latency [s]", "UI_READ.GET_VBATT.VALUE [V]"]
    assert rows[0] == ["2026-01-01T10:00:00.006500Z", "3", "1.7", "0.004", "7.92"]
    assert [row[4] for row in rows] == ["7.92", "7.88"]


def test_json() -> None:
    done = run("values", PLUGGED, "--json")
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert [row["packet"] for row in rows] == [3, 21, 25, 34]
    assert rows[1]["values"] == {"latency": 0.004, "INPUT_READ(0,0,0,0).PCT": 100}


def test_readings_of_devices_have_their_names_and_units(tmp_path: Path) -> None:
    log = tmp_path / "gyro.log"
    log.write_text(
        "09:00:00 sent 0f 00 2a 00 00 08 00 99 1d 00 00 81 20 03 02 60 64\n"
        "09:00:01 received 0b 00 2a 00 02 00 00 b4 42 00 00 80 bf\n"
    )
    column = "INPUT_DEVICE.READY_SI(0,0,32,3,2).VALUES"
    titles, row = csv.reader(io.StringIO(run("values", str(log), "--csv").stdout))
    assert titles[-2:] == [f"{column}[0] angle [degrees]", f"{column}[1] rate [degrees/s]"]
    assert row[-2:] == ["90", "-1"]
    (entry,) = map(json.loads, run("values", str(log), "--json").stdout.splitlines())
    assert entry["values"] == {"latency": 1.0, f"{column}[0]": 90.0, f"{column}[1]": -1.0}
    entries = [json.loads(line) for line in run("decode", "--json", str(log)).stdout.splitlines()]
    readings = [("VALUES[0]", "angle", "degrees"), ("VALUES[1]", "rate", "degrees/s")]
    for found in (entries[0]["operations"][0]["args"][-2:], entries[1]["values"]):
        assert [(one["name"], one["quantity"], one["unit"]) for one in found] == readings


def test_messages_to_mailboxes(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(
        "09:00:00 sent 0f 00 01 00 81 9e 04 61 62 63 00 04 00 00 00 c0 3f\n"
        "09:00:01 sent 0c 00 02 00 81 9e 04 61 62 63 00 01 00 01\n"
        "09:00:02 sent 0e 00 03 00 81 9e 04 61 62 63 00 03 00 68 69 00\n"
        "09:00:03 sent 0d 00 03 00 81 9e 04 61 62 63 00 02 00 68 69\n"
    )
    done = run("values", str(log), "--json")
    assert [json.loads(line)["values"] for line in done.stdout.splitlines()] == [
        {"WRITEMAILBOX(abc).number": 1.5},
        {"WRITEMAILBOX(abc).logic": 1},
        {"WRITEMAILBOX(abc).text": "hi"},
    ]
    assert "hi" in run("values", str(log), "--filter", 'command == "WRITEMAILBOX"').stdout


def test_a_picture_has_units_and_names(tmp_path: Path) -> None:
    path = tmp_path / "battery.svg"
    done = run("values", PLUGGED, *BATTERY, "--plot", str(path))
    assert (done.returncode, done.stdout) == (0, f"{path}: written\n")
    svg = path.read_text()
    for text in ("seconds since the first message", ">V<", ">s<", "UI_READ.GET_VBATT.VALUE", "usb-plugged.pcap"):
        assert text in svg, text


def test_values_that_never_change_have_an_axis(tmp_path: Path) -> None:
    path = tmp_path / "battery.svg"
    assert run("values", PLUGGED, *BATTERY, "--plot", str(path)).returncode == 0
    svg = path.read_text()
    # Both replies came after 4 ms.
    assert {"0.0036", "0.0040", "0.0044"} <= set(re.findall(r">(0\.00\d+)<", svg))


def test_a_picture_of_many_values_names_all_of_them() -> None:
    names = [f"INPUT_READ(0,{number},0,0).A_NAME_THAT_IS_LONGER_THAN_LEGENDS_USUALLY_SHOW" for number in range(40)]
    rows = [Row(second * 10**9, second, "1.7", dict.fromkeys(names, second)) for second in (5, 6)]
    found = Series(dict.fromkeys(names), rows)
    svg = draw(found, ".svg", "x", start_ns=10**9).decode()
    assert all(name in svg for name in names)
    assert len(set(re.findall(r'stroke="(#\w+)" stroke-width="2"', svg))) == 10
    assert len(set(re.findall(r'stroke-dasharray="([\d,]+)"', svg))) >= 4
    # Seconds since the first message, which was not a reply.
    assert {"4.00", "5.00"} <= set(re.findall(r">(\d\.\d\d)<", svg))


def test_a_picture_of_another_kind(tmp_path: Path) -> None:
    done = run("values", PLUGGED, "--plot", str(tmp_path / "x.gif"))
    assert done.returncode == 2
    assert "unknown suffix of a plot: .gif; expected .svg or .png" in done.stderr


def test_nothing_to_show() -> None:
    done = run("values", str(CAPTURES / "daisy.pcap"), *BATTERY)
    assert (done.returncode, done.stdout) == (1, "")
    assert "no frame in 17 packets matches the filter" in done.stderr


def test_several_files_name_the_file_of_each_row(tmp_path: Path) -> None:
    logs = [tmp_path / name for name in ("first.log", "second.log")]
    for log in logs:
        log.write_text(LOG)
    done = run("values", *map(str, logs), "--csv")
    first, *rows = csv.reader(io.StringIO(done.stdout))
    assert first == ["file", "time", "packet", "peer", "UI_READ.GET_VBATT.VALUE [V]"]
    assert [(row[0], row[2], row[4]) for row in rows] == [(str(log), "2", "8") for log in logs]


def test_one_of_several_files_cannot_be_read() -> None:
    done = run("values", PLUGGED, "missing.pcap", *BATTERY, "--json")
    assert done.returncode == 1
    assert [json.loads(line)["packet"] for line in done.stdout.splitlines()] == [3, 34]
    assert "missing.pcap: cannot be read" in done.stderr


LOG = """\
sent 09 00 01 00 00 04 00 81 01 60 00
received 07 00 01 00 02 00 00 00 41
"""
"""A battery of 8 V, in a log without times."""


def test_a_log_without_times_has_none(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(LOG)
    assert json.loads(run("values", str(log), "--json").stdout)["time"] is None
    assert run("values", str(log), "--csv").stdout.splitlines()[1] == ",2,brick,8"
    records = run("decode", str(log), "--dialogues", "--json").stdout
    assert records
    assert '"time"' not in records


def test_a_picture_without_times_is_in_their_order(tmp_path: Path) -> None:
    log, path = tmp_path / "robot.log", tmp_path / "battery.svg"
    log.write_text(2 * LOG)
    assert run("values", str(log), "--plot", str(path)).returncode == 0
    svg = path.read_text()
    assert ">order<" in svg
    assert "seconds" not in svg


def log_of_columns(count: int) -> str:
    """A log of replies to INPUT_READ, each asked with another NO and TYPE: a column each, the last with two."""
    lines = []
    for number in [*range(count), count - 1]:
        counter = number.to_bytes(2, "little").hex()
        lines.append(f"sent 0b00{counter}0001009a00{number % 32:02x}{number // 32:02x}0060")
        lines.append(f"received 0400{counter}0205")
    return "\n".join(lines)


def test_a_table_has_no_more_columns_than_people_read(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(log_of_columns(60))
    done = run("values", str(log))
    assert done.returncode == 0
    titles = done.stdout.splitlines()[0].split("  ")
    assert len([title for title in titles if "INPUT_READ" in title]) == 50
    # The one with two values is among them, and so are those that came first.
    assert "INPUT_READ(0,27,1,0).PCT [%]" in done.stdout
    assert "INPUT_READ(0,0,0,0).PCT [%]" in done.stdout
    assert "INPUT_READ(0,26,1,0).PCT [%]" not in done.stdout
    assert "there are 60 columns: the 50 with the most values are shown; --filter chooses" in done.stderr


def test_comma_separated_values_have_a_thousand_columns_at_most(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(log_of_columns(1_010))
    done = run("values", str(log), "--csv")
    rows = list(csv.reader(io.StringIO(done.stdout)))
    assert {len(row) for row in rows} == {3 + 1_000}
    assert "there are 1,010 columns: the 1,000 with the most values are shown" in done.stderr
    everything = run("values", str(log), "--json")
    assert (len(everything.stdout.splitlines()), everything.stderr) == (1_011, "")


def test_rows_beyond_what_is_kept_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ev3proto.cli.values, "MOST_CELLS", 5)
    done = run("values", PLUGGED, "--json")
    assert [json.loads(line)["packet"] for line in done.stdout.splitlines()] == [3, 21]
    assert done.stderr == "2 rows omitted: 5 cells are kept; --filter chooses others\n"
    assert done.returncode == 1


def test_a_table_has_only_as_many_rows_as_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ev3proto.cli.values, "MOST_PRINTED", 4)
    done = run("values", PLUGGED, *BATTERY)
    assert len(done.stdout.splitlines()) == 2
    assert done.stderr == "and 1 row more: --csv and --json print all of them\n"
    assert len(run("values", PLUGGED, *BATTERY, "--csv").stdout.splitlines()) == 3


def test_long_texts_count_for_several_cells(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log = tmp_path / "names.log"
    # COM_GET.GET_BRICKNAME, for which there are 500 bytes, and a name of 480 letters.
    asks, says = "0b00{:02x}0000f401d30d82f40160", f"f701{{:02x}}0002{'78' * 480}{'00' * 20}"
    log.write_text("".join(f"{asks.format(number)}\n{says.format(number)}\n" for number in range(4)))
    assert len(run("values", str(log), "--json").stdout.splitlines()) == 4
    with monkeypatch.context() as patch:
        patch.setattr(ev3proto.cli.values, "MOST_PRINTED", 8)
        shown = run("values", str(log))
        assert shown.stdout.count("x" * 480) == 1
        assert shown.stderr == "and 3 rows more: --csv and --json print all of them\n"
    monkeypatch.setattr(ev3proto.cli.values, "MOST_CELLS", 10)
    kept = run("values", str(log), "--json")
    assert len(kept.stdout.splitlines()) == 2
    assert kept.stderr == "2 rows omitted: 10 cells are kept; --filter chooses others\n"

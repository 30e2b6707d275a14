"""The recipes of CONTRIBUTING.md are enough: each is followed with an invented thing, and all parts then know it.

The invented things are added to one copy of the project, in the files that the recipes list and in no others.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
from support.cases import each
from support.invented import ROOT, Change, copied, files_of, is_in, run_in, titles
from support.messages import tone
from support.packets import RAW_IP, Connection
from support.packets import Capture as Packets
from support.wireshark import Tshark

from ev3proto.generate.captures import write_pcapng
from ev3proto.tables import OPCODES
from ev3proto.version import VERSION

FREE, OTHER, *_ = (number for number in range(0x100) if all(number != opcode.number for opcode in OPCODES))
"""Numbers that no opcode has."""

ENTRIES = f"""
    Opcode(
        {FREE},
        "TIMER_LAP",
        "Notes the time of a lap",
        (
            In("NO", DATA8, "which lap", range=(0, 9)),
            Out("TIME", DATA32, "time of the lap", unit="ms"),
        ),
    ),
    Opcode(
        {OTHER},
        "WATCH",
        "Works with stopwatches",
        commands=(
            Command(1, "STOP", "Stops a stopwatch", (In("NO", DATA8, "which stopwatch", range=(0, 3)),)),
            Command(
                2,
                "LAPS",
                "Reads the times of laps",
                (
                    In("LENGTH", DATA8, "how many laps", range=(0, 20)),
                    Out("LAPS", DATA32, "their times", unit="ms", length="LENGTH"),
                ),
            ),
        ),
    ),
"""

TONE = bytes.fromhex("0f0000008000009401810282e80382e803")
MARK = "@"

DEVICE = """
    _device(
        40,
        "weather station",
        "CONN_NXT_IIC",
        1,
        _mode("WEATHER", _BITS16, "5.1", (0, 2000), "", Dataset("pressure", "hPa"), Dataset("humidity", "%")),
    ),
"""

RULE = """

LUCKY = _code(
    "H999",
    "a lucky counter",
    "The counter is 7, which means nothing to the brick.",
    _sized("07:00|80|00:00|01"),
    _sized("06:00|80|00:00|01"),
    words=Words("the counter is {counter}", "use another one"),
)
"""

CHECKED = """

def check_luck(context: CheckContext) -> Iterator[Finding]:
    if context.message.counter == 7:
        yield codes.LUCKY.at(2, 2, counter=7)
"""

FORMAT = '''"""Captures behind a lucky word."""

from ev3proto.capture.formats import pcapng
from ev3proto.capture.packets import Format, begins_with


def packets(stream):
    """Yields the packets."""
    stream.read(5)
    yield from pcapng.packets(stream)


FORMAT = Format("lucky", (".luck",), 5, begins_with(b"LUCKY"), packets)
'''

EXPORT = '''"""Opcodes for spreadsheets."""

from ev3proto.tables import OPCODES

FILE_NAME = "opcodes.csv"


def build() -> str:
    """Returns the text."""
    return "".join(f"{opcode.number},{opcode.name}\\n" for opcode in OPCODES)
'''

RECIPES: dict[str, tuple[Change, ...]] = {
    "An opcode": (
        Change("ev3proto/tables/timer.py", "TIMER = (\n", f"TIMER = ({ENTRIES}"),
        Change("ev3proto/tables/timer.py", "import DATA32", "import Command, DATA8, DATA32"),
        Change(
            "ev3proto/brick/operations/timers.py",
            "computes(\n    {\n",
            'computes(\n    {\n        "TIMER_LAP": lambda vm, lap: 100 * lap,\n',
        ),
    ),
    "A device": (Change("ev3proto/tables/devices.py", "\n_DEVICES = (\n", f"\n_DEVICES = ({DEVICE}"),),
    "A rule of the checker": (
        Change("ev3proto/checking/codes.py", "\n# 9: encodings\n", f"{RULE}\n# 9: encodings\n"),
        Change("ev3proto/checking/rules/header.py", "\n\ndef check_system(", f"{CHECKED}\n\ndef check_system("),
        Change(
            "ev3proto/checking/rules/header.py",
            "    yield from _length(",
            "    yield from check_luck(context)\n    yield from _length(",
        ),
    ),
    "A kind of slip": (
        Change(
            "ev3proto/checking/slips.py",
            "    # Copying.\n",
            '    "digit": Slip(1, "{0} of {1} is the character {2}",\n'
            '        "0E00 0100 80 0000 94 01 35 82E803 82F401", "0E00 0100 80 0000 94 01 05 82E803 82F401"),\n'
            "    # Copying.\n",
        ),
        Change(
            "ev3proto/checking/edits.py",
            "\n\n_AT_ARGUMENT = (",
            "\n\ndef _digit(place: _Place) -> Iterator[Edit]:\n"
            "    digit = place.code.data[place.at] - 0x30\n"
            "    if place.takes_number and 0 <= digit <= 9:\n"
            '        yield Edit("digit", place.at, place.at + 1, place.number(digit), (*place.names, digit))\n'
            "\n\n_AT_ARGUMENT = (_digit, ",
        ),
        Change(
            "benchmarks/slips.py",
            "\n\n@slip\ndef length_swapped(",
            "\n\n@slip\ndef digit(frame: bytes, _: Random) -> Wrong:\n"
            '    return (changed(frame, 9, 1, b"5"), 9, 10) if frame[7:9] == b"\\x94\\1" else None\n'
            "\n\n@slip\ndef length_swapped(",
        ),
    ),
    "A notation": (
        Change(
            "ev3proto/text/paste/elements.py",
            '    Form("blank", "(byte)",',
            '    Form("blank", "0f |@|", "@"),\n    Form("blank", "(byte)",',
        ),
        Change(
            "docs/notations.md",
            "\nF 0 0 0 80 ",
            f"\n{TONE.hex(MARK).replace(MARK, MARK + chr(32))}{MARK}\nF 0 0 0 80 ",
        ),
    ),
    "Damage to a frame on its way into a text": (
        Change(
            "ev3proto/text/paste/repairs.py",
            "\n\nREPAIRS = (",
            "\n\ndef _doubled(line: str) -> Iterator[str]:\n    yield line[::2]\n"
            '\n\nREPAIRS = (\n    Repair("00ff", _doubled, "each digit is doubled"),',
        ),
    ),
    "A capture format": (
        Change("ev3proto/capture/formats/lucky.py", "", FORMAT),
        Change("ev3proto/capture/formats/__init__.py", "for each in (pcap, ", "for each in (lucky, pcap, "),
        Change("ev3proto/capture/formats/__init__.py", "import btsnoop, ", "import btsnoop, lucky, "),
    ),
    "A rule of claims": (
        Change("ev3proto/tables/claims.py", "\nNXT_WRITE, ", "\nNEVER_COUNTED = 777\n\nNXT_WRITE, "),
        Change(
            "ev3proto/capture/evidence.py",
            "    if not isinstance(message, DirectCommand):\n        return False\n    if _fits",
            "    if not isinstance(message, DirectCommand) or message.counter == NEVER_COUNTED:\n"
            "        return False\n    if _fits",
        ),
        Change("ev3proto/capture/evidence.py", "import NEVER_SENT, ", "import NEVER_COUNTED, NEVER_SENT, "),
        Change(
            "ev3proto/generate/dissector/tables.py",
            '        "most_held": ',
            '        "never_counted": claims.NEVER_COUNTED,\n        "most_held": ',
        ),
        Change(
            "ev3proto/generate/dissector/runtime/claims.lua",
            "            if stop < COMMAND_HEADER_SIZE then",
            "            if stop < COMMAND_HEADER_SIZE or message.counter == CLAIMS.never_counted then",
        ),
    ),
    "A field of the dissector": (
        Change(
            "ev3proto/generate/dissector/fields.py",
            '    ProtoField("type", ',
            '    ProtoField("lucky", "bool", "lucky", "Lucky counter", generated=True),\n    ProtoField("type", ',
        ),
        Change(
            "ev3proto/generate/dissector/runtime/message.lua",
            "        add(item, field.type, ",
            "        set_generated(add(item, field.lucky, message.counter == 7))\n        add(item, field.type, ",
        ),
    ),
    "A statistic": (
        Change(
            "ev3proto/capture/statistics.py",
            "    faults: int = 0  # faulty frames\n",
            "    faults: int = 0  # faulty frames\n    lucky: int = 0  # frames whose counter is 7\n",
        ),
        Change(
            "ev3proto/capture/statistics.py",
            "        self.counts.faults += ",
            "        self.counts.lucky += message.counter == 7\n        self.counts.faults += ",
        ),
        Change(
            "ev3proto/cli/stats.py",
            "        if whole.orphans:\n",
            "        if whole.lucky:\n"
            '            self._tables.heading(f"Lucky counters: {whole.lucky}")\n'
            "        if whole.orphans:\n",
        ),
    ),
    "An export": (
        Change("ev3proto/generate/opcodes_csv/__init__.py", "", '"""Opcodes for spreadsheets."""\n'),
        Change("ev3proto/generate/opcodes_csv/build.py", "", EXPORT),
        Change(
            "ev3proto/generate/exported.py",
            "    cheader.FILE_NAME: ",
            "    opcodes_csv.FILE_NAME: opcodes_csv.build,\n    cheader.FILE_NAME: ",
        ),
        Change(
            "ev3proto/generate/exported.py",
            "from ev3proto.generate.tables_json ",
            "from ev3proto.generate.opcodes_csv import build as opcodes_csv\nfrom ev3proto.generate.tables_json ",
        ),
        Change(
            "ev3proto/cli/export.py",
            "_FILES = {\n",
            '_FILES = {\n    "csv": (opcodes_csv.build, "Writes opcodes.csv, for spreadsheets.", "-o opcodes.csv"),\n',
        ),
        Change(
            "ev3proto/cli/export.py",
            "from ev3proto.generate.tables_json ",
            "from ev3proto.generate.opcodes_csv import build as opcodes_csv\nfrom ev3proto.generate.tables_json ",
        ),
    ),
    "A subcommand": (
        Change(
            "ev3proto/cli/count.py",
            "",
            '"""`ev3proto count`."""\n\nimport click\n\nfrom ev3proto.cli.output import say\n\n\n'
            '@click.command()\n@click.argument("frame")\ndef count(frame: str) -> None:\n'
            '    """Counts the bytes of a frame."""\n    say(f"{len(bytes.fromhex(frame))} bytes")\n',
        ),
        Change("ev3proto/cli/commands.py", '    "copy": ', '    "count": "Counts the bytes of a frame",\n    "copy": '),
    ),
    "A page": (
        Change(
            "ev3proto/generate/pages/luck.py",
            "",
            '"""The page about luck."""\n\nfrom collections.abc import Iterator\n\n\n'
            'def blocks() -> Iterator[str]:\n    """Yields the blocks."""\n    yield "Seven is lucky."\n',
        ),
        Change("ev3proto/generate/pages/build.py", "    house,\n", "    house,\n    luck,\n"),
        Change(
            "ev3proto/generate/pages/build.py",
            '        "read-only.md": ',
            '        "luck.md": page("Luck", luck.blocks()),\n        "read-only.md": ',
        ),
        Change("ev3proto/generate/pages/build.py", "OTHERS = {\n", 'OTHERS = {\n    "luck.md": "Luck",\n'),
    ),
    "A release": (
        Change("ev3proto/version.py", f'VERSION = "{VERSION}"', 'VERSION = "98.7.6"'),
        Change("CHANGELOG.md", f"\n## {VERSION}\n", f"\n## 98.7.6\n\n### Luck\n\n- Seven.\n\n## {VERSION}\n"),
        Change("docs/howto/install.md", "", "ev3proto-98.7.6\n"),
    ),
}
"""By the title of the recipe."""

ELSEWHERE = {
    "A carrier": "tests/tables/test_carriers.py",
    "An output format": "tests/cli/test_formats.py",
}
"""Recipes that other tests follow."""

FRAME = f"0f000800000c00{FREE:02x}0360{OTHER:02x}020264{OTHER:02x}0101"
"""TIMER_LAP 3 into GV(0), WATCH LAPS 2 into GV(4), WATCH STOP 1, with 12 bytes of global memory."""

USER = """
import json
import ev3proto
from ev3proto import GV, check, command, ops
from ev3proto.brick import Brick
from ev3proto.text.assembly import assemble, operation_line

message = command(ops.timer_lap(3), ops.watch.laps(2), ops.watch.stop(no=1), counter=8)
frame = message.build()
parsed = ev3proto.parse(frame)
assert parsed == message
assert parsed.build() == frame
dialogue = ev3proto.Dialogue()
dialogue.feed(parsed)
values = dialogue.feed(ev3proto.direct_reply(bytes(range(12)), counter=8))
text = "\\n".join(operation_line(operation) for operation in parsed.operations)
(assembled,) = assemble(text, counter=8)
wrong = check(ev3proto.direct_command(ev3proto.operation("WATCH.STOP", 9)).build())
(answer,) = Brick().receive(command(ops.timer_lap(3), counter=8).build())
print(json.dumps({
    "hex": frame.hex(),
    "names": [operation.full_name for operation in parsed.operations],
    "accepted": check(frame).accepted,
    "findings": [finding.code for finding in check(frame).findings],
    "wrong": [[finding.code, finding.message] for finding in wrong.findings],
    "values": [[value.op, value.command, value.name, value.value, value.unit] for value in values],
    "text": text,
    "assembled": assembled.build().hex(),
    "help": ops.watch.laps.__doc__,
    "answer": answer.hex(),
}))
"""


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project with the invented things, generated again."""
    root = tmp_path_factory.mktemp("project")
    changed = copied(root, (change for recipe in RECIPES.values() for change in recipe)).split()
    assert {"ev3proto/ops/watch.py", "dissector/ev3.lua", "exports/ev3-tables.json"} <= set(changed)
    return root


def test_every_recipe_is_followed() -> None:
    assert {*titles()} == {*RECIPES, *ELSEWHERE}
    assert all((ROOT / path).exists() for path in ELSEWHERE.values())


@each("recipe", RECIPES)
def test_a_recipe_lists_the_files_that_it_takes(recipe: str) -> None:
    listed, changed = files_of(recipe), {change.path for change in RECIPES[recipe]}
    assert [path for path in changed if not any(is_in(path, each) for each in listed)] == []
    assert [each for each in listed if not any(is_in(path, each) for path in changed)] == []


def _run(root: Path, *arguments: str, status: int = 0) -> str:
    return run_in(root, "-m", "ev3proto", *arguments, status=status)


def test_an_opcode_is_known_to_the_package(copy: Path) -> None:
    known = json.loads(run_in(copy, "-c", USER))
    assert known["hex"] == FRAME
    assert known["names"] == ["TIMER_LAP", "WATCH.LAPS", "WATCH.STOP"]
    assert (known["accepted"], known["findings"]) == (True, [])
    assert known["wrong"] == [["W303", "NO is 9, outside of 0 to 3"]]
    assert known["values"] == [
        ["TIMER_LAP", None, "TIME", 0x03020100, "ms"],
        ["WATCH", "LAPS", "LAPS", [0x07060504, 0x0B0A0908], "ms"],
    ]
    assert "opWATCH, LC0(LAPS), LC0(2), GV0(4)" in known["text"]
    assert known["assembled"] == known["hex"]
    assert "Reads the times of laps." in known["help"]
    assert known["answer"] == "0700080002" + "2c010000"


@each(
    "written, instead, sentence",
    [
        (f"{FREE},", "0x97,", "0x97 is already INPUT_SAMPLE: give TIMER_LAP a number that is free\n"),
        (f"{OTHER},", "0x94,", "0x94 is already SOUND: give WATCH a number that is free\n"),
        (
            '2,\n                "LAPS"',
            '1,\n                "LAPS"',
            "CMD 1 is already WATCH.STOP: give WATCH.LAPS a number that is free\n",
        ),
    ],
)
def test_a_number_that_is_taken_is_named_before_anything_is_written(
    copy: Path, tmp_path: Path, written: str, instead: str, sentence: str
) -> None:
    root = tmp_path / "project"
    shutil.copytree(copy / "ev3proto", root / "ev3proto", dirs_exist_ok=True)
    shutil.copytree(ROOT / "exports", root / "exports", dirs_exist_ok=True)
    Change("ev3proto/tables/timer.py", written, instead).make(root)
    assert run_in(root, "-m", "ev3proto.generate", status=1) == sentence
    assert not (root / "dissector").exists()


def test_an_opcode_is_known_to_the_command_line(copy: Path) -> None:
    assert f"0x{OTHER:02X}" in _run(copy, "ops", "WATCH")
    shown = _run(copy, "decode", FRAME)
    assert "WATCH" in shown
    assert "LAPS" in shown


@each(
    "path",
    [
        *("dissector/ev3.lua", "exports/ev3proto.h", "exports/ev3.ksy", "exports/ev3-tables.json"),
        "ev3proto/ops/watch.py",
    ],
)
def test_an_opcode_is_in_what_is_generated(copy: Path, path: str) -> None:
    text = (copy / path).read_text().upper()
    assert "WATCH" in text
    assert "LAPS" in text


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    """A capture of the frame, whose counter is 8, and of a NOP whose counter is 7."""
    path = tmp_path / "watch.pcapng"
    with path.open("wb") as stream:
        write_pcapng([bytes.fromhex(FRAME), bytes.fromhex("0600070080000001")], stream)
    return path


def test_wireshark_knows_an_opcode_and_a_field(copy: Path, capture: Path) -> None:
    with Tshark.from_setting(copy / "dissector" / "ev3.lua") as tshark:
        tree = tshark.run(capture, "-V")
    assert "TIMER_LAP" in tree
    assert "LAPS" in tree
    assert "STOP" in tree
    assert re.findall(r"\[Lucky counter: (\w+)\]", tree) == ["False", "True"]


def test_a_capture_format_is_read(copy: Path, capture: Path) -> None:
    capture.write_bytes(b"LUCKY" + capture.read_bytes())
    assert "TIMER_LAP" in _run(copy, "decode", str(capture))
    assert "lucky" in run_in(copy, "-c", "from ev3proto.capture.formats import LISTED; print(LISTED)")


def test_both_readers_of_captures_follow_a_rule_of_claims(copy: Path, tmp_path: Path) -> None:
    packets, path = Packets(RAW_IP), tmp_path / "claims.pcap"
    for port, counter in ((10_001, 777), (10_002, 778)):
        Connection(packets, port).send(tone(counter))
    path.write_bytes(packets.data())
    assert [json.loads(line)["counter"] for line in _run(copy, "decode", "--json", str(path)).splitlines()] == [778]
    with Tshark.from_setting(copy / "dissector" / "ev3.lua") as tshark:
        assert tshark.run(path, "-Y", "ev3", "-T", "fields", "-e", "ev3.msg_num").split() == ["778"]


def test_a_statistic_is_in_both_outputs(copy: Path, capture: Path) -> None:
    assert "Lucky counters: 1\n" in _run(copy, "stats", str(capture))
    assert json.loads(_run(copy, "stats", "--json", str(capture)))["whole"]["lucky"] == 1
    assert '"lucky"' in (copy / "exports" / "ev3-output.schema.json").read_text()


STATION = """
import json
from pathlib import Path
from ev3proto import Dialogue, check, command, ops, parse
from ev3proto.brick import Brick
from ev3proto.brick.servers.page.state import Changes
from ev3proto.brick.servers.page.watcher import Unshown
from ev3proto.brick.servers.script import read_script

script = Path("station.toml")
script.write_text("[ports.3]\\ntype = 40\\nreadings.0 = [1013, 55]\\n")
brick = Brick()
read_script(script).set_up(brick)
asked = command(ops.input_device.ready_si(0, 2, 40, 0, 2), ops.input_device.get_name(0, 2, 8))
(reply,) = brick.receive(asked.build())
dialogue = Dialogue()
dialogue.feed(asked)
values = dialogue.feed(parse(reply))
facts = Changes(brick, Unshown(()), list).take()["facts"]
print(json.dumps({
    "values": [[value.value, value.quantity, value.unit] for value in values],
    "findings": [str(finding) for finding in check(asked).findings],
    "page": [type for type in facts["types"] if type["number"] == 40],
}))
"""


def test_a_device_is_known_everywhere(copy: Path, tmp_path: Path) -> None:
    known = json.loads(run_in(copy, "-c", STATION))
    assert known["values"] == [[1013, "pressure", "hPa"], [55, "humidity", "%"], ["WEATHER", None, None]]
    assert known["findings"] == []
    (shown,) = known["page"]
    assert (shown["title"], shown["modes"][0]["values"]) == (
        "weather station",
        [["pressure", "hPa"], ["humidity", "%"]],
    )
    assert "weather station, mode 0 of type 40" in _run(copy, "help", "WEATHER")
    assert "type 40" in _run(copy, "ops", "weather", "station")
    panel = (
        "import sys; sys.path.append('docs/playground'); from bridge.watching import shown; print(shown(40, 0, 1013))"
    )
    assert run_in(copy, "-c", panel) == "('weather station', '1013.0 hPa')\n"
    capture = tmp_path / "weather.pcapng"
    command = bytes.fromhex("0f00 0800 00 0800 99 1d 00 02 81 28 00 02 60 64")
    with capture.open("wb") as stream:
        write_pcapng([command, bytes.fromhex("0b00 0800 02 0040 7d44 0000 5c42")], stream)
    assert "TYPE      = 40 weather station" in _run(copy, "decode", command.hex())
    with Tshark.from_setting(copy / "dissector" / "ev3.lua") as tshark:
        tree = tshark.run(capture, "-V")
    assert "VALUES[0]: 1013 hPa (pressure)" in tree
    assert "VALUES[1]: 55 % (humidity)" in tree


def test_a_rule_is_checked_explained_and_documented(copy: Path) -> None:
    assert "H999" in _run(copy, "check", "0600070080000001")
    assert "a lucky counter" in _run(copy, "check", "--explain", "H999")
    assert "H999" in (copy / "docs" / "reference" / "checker-codes.md").read_text()


def test_a_slip_is_what_was_meant(copy: Path) -> None:
    assert "did you mean: VOLUME of SOUND.TONE is the character 5\n" in _run(
        copy, "check", "0e00010080000094013582e80382f401"
    )
    program = "from benchmarks.slips import SLIPS; print(SLIPS['digit'](b'2345678\\x94\\1\\5', None)[0][7:])"
    assert run_in(copy, "-c", program) == "b'\\x94\\x015'\n"


def test_a_notation_is_read(copy: Path) -> None:
    (line,) = (
        line
        for line in (copy / "docs" / "notations.md").read_text().splitlines()
        if "@" in line and line.startswith("0f@")
    )
    assert "SOUND.TONE" in _run(copy, "decode", line)


def test_damage_is_undone(copy: Path) -> None:
    doubled = "".join(digit * 2 for digit in TONE.hex())
    assert "SOUND.TONE" in _run(copy, "decode", doubled)


def test_an_export_is_checked_in_and_has_a_subcommand(copy: Path) -> None:
    text = (copy / "exports" / "opcodes.csv").read_text()
    assert f"\n{OTHER},WATCH\n" in text
    assert _run(copy, "export", "csv") == text


def test_a_subcommand_runs_and_is_documented(copy: Path) -> None:
    assert _run(copy, "count", FRAME) == "17 bytes\n"
    assert "Counts the bytes of a frame" in (copy / "docs" / "reference" / "command-line.md").read_text()


def test_a_page_is_in_the_reference(copy: Path) -> None:
    assert "# Luck\n\nSeven is lucky.\n" in (copy / "docs" / "reference" / "luck.md").read_text()
    assert "[Luck](luck.md)" in (copy / "docs" / "reference" / "index.md").read_text()


def test_a_release_has_its_version_everywhere(copy: Path) -> None:
    assert _run(copy, "--version").split()[-1] == "98.7.6"
    assert 'version = "98.7.6"' in (copy / "dissector" / "ev3.lua").read_text()
    assert "for ev3proto 98.7.6" in (copy / "docs" / "reference" / "luck.md").read_text()

"""The dissector's file is generated from the tables, Wireshark has a field for everything, and its README is right."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from support.cli import run_ev3proto, run_program
from support.pictures import dissector_texts
from support.wireshark import DISSECTOR, Tshark

from ev3proto.generate.dissector.build import files
from ev3proto.generate.dissector.fields import HEXADECIMAL, filter_name
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Enumeration, Parameter, Type
from ev3proto.tables.system import SYSTEM, FieldKind

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "captures"
README = (ROOT / "dissector" / "README.md").read_text(encoding="utf-8")
HOWTO = (ROOT / "docs" / "howto" / "wireshark.md").read_text(encoding="utf-8")


class Field(NamedTuple):
    """Wireshark's description of a field."""

    name: str
    type: str
    base: str
    text: str


@pytest.fixture(scope="module")
def fields(tshark: Tshark) -> dict[str, Field]:
    """Every field of the dissector by its name in filters; each name is unique."""
    rows = [line.split("\t") for line in report(tshark, "fields")]
    found = [(row[2], Field(row[1], row[3], row[5], row[7])) for row in rows if row[0] == "F" and row[4] == "ev3"]
    assert [name for name, count in Counter(name for name, _ in found).items() if count > 1] == []
    return dict(found)


@pytest.fixture(scope="module")
def values(tshark: Tshark) -> dict[str, dict[int, str]]:
    """Wireshark's names of numbers, by field."""
    found: dict[str, dict[int, str]] = {}
    for line in report(tshark, "values"):
        if line.startswith("V\tev3."):
            _, field, digits, text = line.split("\t")
            number = int(digits, 0)
            found.setdefault(field, {})[number - 2**32 if number >= 2**31 else number] = text
    return found


def report(tshark: Tshark, what: str) -> list[str]:
    done = run_program(tshark.path, "-G", what, *tshark.words)
    assert ".lua:" not in done.stderr
    return done.stdout.splitlines()


def parameters() -> Iterator[tuple[str, Parameter]]:
    """Every parameter of every operation, with the name of its field."""
    for opcode in OPCODES:
        for parameter in opcode.parameters:
            yield f"ev3.{opcode.name}.{parameter.name}".lower(), parameter
        for command in opcode.commands:
            for parameter in command.parameters:
                yield f"ev3.{opcode.name}.{command.name}.{parameter.name}".lower(), parameter


def run(*words: str) -> subprocess.CompletedProcess[bytes]:
    return run_ev3proto("dissector", "build", *words)


def test_the_command_writes_the_same_every_time(tmp_path: Path) -> None:
    file = tmp_path / "ev3.lua"
    assert run("-o", str(file)).returncode == 0
    done = run()
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout == file.read_bytes() == DISSECTOR.read_bytes()


def test_the_command_checks_a_file(tmp_path: Path) -> None:
    file = tmp_path / "ev3.lua"
    done = run("--check", "-o", str(file))
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode() == f"{file}: cannot be read: No such file or directory\n"
    file.write_bytes(DISSECTOR.read_bytes())
    done = run("--check", "-o", str(file))
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
    file.write_text("-- old\n")
    done = run("--check", "-o", str(file))
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.decode() == f"{file} is out of date; run this without --check to write it again\n"
    assert file.read_text() == "-- old\n"


def test_calls_that_are_wrong(tmp_path: Path) -> None:
    done = run("--check")
    assert done.returncode == 2
    assert "--check needs -o" in done.stderr.decode()
    done = run("-o", str(tmp_path / "none" / "ev3.lua"))
    assert done.returncode == 1
    assert done.stderr.decode().endswith("ev3.lua: cannot be written: No such file or directory\n")


def test_the_form_of_the_file() -> None:
    data = DISSECTOR.read_bytes()
    assert not data.startswith(b"\xef\xbb\xbf")
    assert b"\r" not in data
    assert b"\t" not in data
    assert data.endswith(b"\n")
    lines = data.decode().split("\n")
    assert [line for line in lines if len(line) > 160] == []
    runtime = lines[lines.index(next(line for line in lines if line.startswith("-- Fields --"))) :]
    assert [line for line in runtime if len(line) > 120] == []
    assert [line for line in lines if line != line.rstrip()] == []


def expected_type(type: Type | str | None) -> str:
    return {Type.DATAF: "FT_FLOAT", Type.STRING: "FT_STRING"}.get(type, "FT_INT32")  # type: ignore[arg-type]


def test_every_parameter_has_its_field(fields: dict[str, Field]) -> None:
    declared = dict(parameters())
    assert len(declared) > 1000
    wrong = []
    for name, parameter in declared.items():
        element = parameter.element
        field = fields.get(name)
        # Some whole numbers are never negative: a test below has examples.
        found = field and (field.name.split()[-1], field.type.replace("UINT", "INT"))
        if found != (parameter.name, expected_type(parameter.type)):
            wrong.append((name, field))
        if parameter.counts:
            item = fields.get(f"{name}.item")
            # If another argument gives the type, a double holds any number.
            type_of_item = expected_type(element) if isinstance(element, Type) else "FT_DOUBLE"
            if item is None or (item.name, item.type) != (parameter.name, type_of_item):
                wrong.append((f"{name}.item", item))
    assert wrong == []


def test_names_that_say_little_have_a_word_before_them(fields: dict[str, Field]) -> None:
    assert fields["ev3.output_speed.layer"].name == "Daisy chain LAYER"
    assert fields["ev3.output_speed.nos"].name == "Ports NOS"
    assert fields["ev3.input_device.ready_si.no"].name == "Port NO"
    assert fields["ev3.mailbox_open.no"].name == "NO"  # a mailbox


def test_numbers_are_unsigned_where_none_is_negative(fields: dict[str, Field]) -> None:
    types = {
        name: fields[f"ev3.{name}"].type for name in ("output_speed.nos", "sound.tone.frequency", "output_speed.speed")
    }
    assert list(types.values()) == ["FT_UINT32", "FT_UINT32", "FT_INT32"]
    assert fields["ev3.output_get_count.tacho"].type == "FT_INT32"


def test_every_parameter_tells_what_it_means(fields: dict[str, Field]) -> None:
    # An operation that has two forms in dialects has one field for both.
    meanings: dict[str, set[str]] = {}
    for name, parameter in parameters():
        meanings.setdefault(name, set()).add(parameter.text)
    assert {name: fields[name].text for name in meanings if fields[name].text not in meanings[name]} == {}


def test_enumerations_have_their_names(values: dict[str, dict[int, str]]) -> None:
    wrong = []
    for name, parameter in parameters():
        if parameter.enum is not None and not parameter.enum.flags and values.get(name) != names_of(parameter.enum):
            wrong.append((name, values.get(name)))
    assert wrong == []


def names_of(enum: Enumeration) -> dict[int, str]:
    names: dict[int, str] = {}
    for name, number in enum.members.items():
        names.setdefault(number, name)
    return names


SYSTEM_TYPES = {
    FieldKind.U8: "FT_UINT8",
    FieldKind.U16: "FT_UINT16",
    FieldKind.U32: "FT_UINT32",
    FieldKind.TEXT: "FT_STRING",
    FieldKind.COUNTED_TEXT: "FT_STRING",
    FieldKind.LISTING: "FT_STRING",
    FieldKind.DATA: "FT_BYTES",
}


def test_every_field_of_system_messages(fields: dict[str, Field]) -> None:
    for command in SYSTEM:
        for field in (*command.request, *command.reply):
            known = fields[f"ev3.{filter_name(command, field)}"]
            assert known.type == SYSTEM_TYPES[field.kind], (command.name, field.name)
            assert (known.base == "BASE_HEX") == (field.name in HEXADECIMAL), (command.name, field.name)


FAMILIAR = {
    "msg_len": "FT_UINT16",
    "msg_num": "FT_UINT16",
    "cmd_type": "FT_UINT8",
    "sys_cmd": "FT_UINT8",
    "vars": "FT_UINT16",
    "op": "FT_UINT8",
    "reply_status": "FT_UINT8",
    "file_len": "FT_UINT32",
    "file_name": "FT_STRING",
    "max_bytes": "FT_UINT16",
    "path_name": "FT_STRING",
    "handle": "FT_UINT8",
    "list_size": "FT_UINT32",
    "list": "FT_STRING",
    "address": "FT_UINT32",
    "image_size": "FT_UINT32",
    "checksum": "FT_UINT32",
    "hw_id": "FT_UINT32",
    "fw_id": "FT_UINT32",
}
"""The names in users' filters, from the dissector that was public before."""


def test_familiar_names(fields: dict[str, Field]) -> None:
    types = {name: fields[f"ev3.{name}"].type for name in FAMILIAR}
    assert types == FAMILIAR
    section = README.split("## Filters from earlier dissectors")[1].split("##")[0]
    assert set(re.findall(r"`ev3\.(\w+)`", section)) == set(FAMILIAR)


def test_names_of_the_header(fields: dict[str, Field], values: dict[str, dict[int, str]]) -> None:
    assert fields["ev3.cmd"].type == "FT_STRING"
    assert fields["ev3.globals"].type == fields["ev3.locals"].type == "FT_UINT16"
    assert values["ev3.cmd_type"][0x80] == "DIRECT_COMMAND_NO_REPLY"
    assert values["ev3.sys_cmd"] == {command.number: command.name for command in SYSTEM}
    assert values["ev3.op"].items() >= {0x94: "SOUND", 0x81: "UI_READ"}.items()
    assert values["ev3.op"].keys() == {opcode.number for opcode in OPCODES}
    assert values["ev3.reply_status"][6] == "ILLEGAL_PATH"


ROWS = re.findall(
    r"^\| [^|`]+?(?: \((-2)\))? \| `(.*)` \|(?: `([\w.-]+)`: (\d+))? \|$", f"{README}\n{HOWTO}", re.MULTILINE
)
"""Whether tshark must read the capture twice, the filter, the capture, the number of packets."""
SESSIONS = [
    re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.MULTILINE)
    for block in re.findall(r"^```(?:console|text)\n(.*?)^```$", f"{README}\n{HOWTO}", re.MULTILINE | re.DOTALL)
    if "$ tshark " in block
]
"""Commands with their output."""


def test_there_is_something_to_test() -> None:
    readme = README.count("\n| ", README.index("| question"), README.index("The same names")) - 1
    howto = HOWTO.count("\n| ", HOWTO.index("| question"), HOWTO.index("Any line in the packet")) - 1
    assert len(ROWS) == readme + howto >= 40
    assert len(SESSIONS) == 5


@pytest.fixture(scope="module")
def filtered(tshark: Tshark) -> dict[tuple[str, str, str], int]:
    """The number of packets that match each filter, by the option -2, filter and capture."""
    found = {}
    for name in {capture or "wifi.pcapng" for _, _, capture, _ in ROWS}:
        texts = list({text for _, text, capture, _ in ROWS if (capture or "wifi.pcapng") == name})
        for twice in ("", "-2"):
            for text, packets in tshark.matches(CAPTURES / name, texts, *twice.split()).items():
                found[twice, text, name] = len(packets)
    return found


@pytest.mark.parametrize(("twice", "filter", "capture", "count"), ROWS)
def test_every_filter_finds_all_by_the_documented_command(
    filtered: dict[tuple[str, str, str], int], twice: str, filter: str, capture: str, count: str
) -> None:
    once, in_two_passes = (filtered[words, filter, capture or "wifi.pcapng"] for words in ("", "-2"))
    assert in_two_passes == int(count or 0)
    assert (once < in_two_passes) == bool(twice)


@pytest.fixture(scope="module")
def shell(tshark: Tshark) -> dict[str, str]:
    """An environment in which `tshark` loads the dissector. Its work folder has the captures."""
    programs = tshark.folder / "programs"
    shutil.copytree(CAPTURES, tshark.folder / "captures")
    programs.mkdir()
    (programs / "tshark").write_text(
        f'#!/bin/sh\nexec {shlex.join([str(tshark.path), *tshark.words, *tshark.statistics])} "$@"\n'
    )
    (programs / "tshark").chmod(0o755)
    return {**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"}


@pytest.mark.parametrize("session", SESSIONS)
def test_the_commands_print_what_is_shown(
    tshark: Tshark, shell: dict[str, str], session: list[tuple[str, str]]
) -> None:
    for command, output in session:
        done = subprocess.run(
            ["bash", "-c", command], cwd=tshark.folder, env=shell, capture_output=True, text=True, check=False
        )
        # Since 4.6, a float of four bytes has nine digits: 7.92000008.
        assert re.sub(r"(?m)(\.\d\d)0000\d\d$", r"\1", done.stdout) == output, command


def test_no_picture_is_out_of_date(tshark: Tshark) -> None:
    for path, text in dissector_texts(tshark).items():
        assert path.with_suffix(".png").exists()
        assert path.read_text(encoding="utf-8") == text, "run docs/pictures, and look at the pictures"


def test_every_name_in_the_readme(tshark: Tshark, fields: dict[str, Field]) -> None:
    names = set(re.findall(r"`(ev3\.[a-z0-9_.]+)`", README)) - {*("ev3.lua", "ev3.tcp_ports", "ev3.firmware")}
    assert len(names) > 50
    experts = {line.split("\t")[2] for line in report(tshark, "fields") if "\tev3.expert." in line}
    assert names - fields.keys() - experts == set()
    assert {name for name in names if ".expert." in name} == experts


def test_the_preferences_in_the_readme(tshark: Tshark) -> None:
    words = [word for option in re.findall(r"`-o (ev3\S+?)`", README) for word in ("-o", option)]
    assert len(words) == 10
    said = tshark.run(CAPTURES / "wifi.pcapng", *tshark.statistics, *words, "-Y", "ev3.sound.tone.volume")
    assert said.count("volume=5") == 1
    assert "Operation " in said


def test_what_the_readme_says_of_other_ports(tshark: Tshark) -> None:
    capture = (CAPTURES / "wifi.pcapng").read_bytes().replace((5555).to_bytes(2, "big"), (6000).to_bytes(2, "big"))
    moved = tshark.place(capture, "port-6000.pcapng")
    assert tshark.run(moved, "-Y", "ev3.cmd") == ""
    for words in (["-d", "tcp.port==6000,ev3"], ["-o", "ev3.tcp_ports:5555,6000"]):
        assert words[1] in README
        assert tshark.run(moved, *words, "-Y", "ev3.cmd") != ""


def test_what_the_readme_says_of_channels(tshark: Tshark) -> None:
    whole = CAPTURES / "bluetooth.log"
    begun_late = tshark.folder / "begun-late.pcapng"
    tshark.run(whole, "-Y", "frame.number > 30", "-w", str(begun_late), dissector=False)
    found = re.search(r"`(-d btl2cap\S+ -d btl2cap\S+)`", README)
    assert found
    assert tshark.run(begun_late, "-Y", "ev3") == ""
    form = ["-Y", "ev3.cmd", "-T", "fields", "-e", "ev3.cmd"]
    assert tshark.run(begun_late, *found[1].split(), *form) == tshark.run(whole, *form) != ""


def test_a_second_copy_is_ignored(tshark: Tshark) -> None:
    """As with a copy in the global plugins folder, and another in the personal one."""
    copies = [tshark.place(data.encode(), f"{index}-{name}") for index in "12" for name, data in files().items()]
    words = [word for path in copies for word in ("-X", f"lua_script:{path}")]
    path = tshark.place((CAPTURES / "wifi.pcapng").read_bytes(), "wifi.pcapng")
    done = subprocess.run([tshark.path, *words, "-r", path, "-c", "1"], capture_output=True, text=True, check=True)
    said = [line for line in done.stderr.splitlines() if ".lua" in line or "Lua" in line]
    assert said == [
        f"ev3.lua is loaded already; this copy is ignored: {copies[2]}",
        f"ev3_statistics.lua is loaded already; this copy is ignored: {copies[3]}",
    ]
    assert "EV3 111 beacon" in done.stdout


def test_the_protocol_hierarchy_counts_us_in_one_pass(tshark: Tshark) -> None:
    shown = tshark.run(CAPTURES / "wifi.pcapng", "-q", "-z", "io,phs")
    assert re.search(r"^ +ev3 +frames:3 bytes:265$", shown, re.MULTILINE)
    # Before 4.6, segments count that only continue a frame.
    assert re.search(r"^ +ev3 +frames:(41 bytes:8181|38 bytes:8009)$", shown, re.MULTILINE)

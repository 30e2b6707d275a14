"""Help: every subcommand has complete help, with examples that work; versions; the search for operations."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from unittest import mock

import click
import pytest
from support.cli import run_ev3proto_text as run

from ev3proto.cli.commands import SUBCOMMANDS, cli, first_sentence
from ev3proto.version import VERSION

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("flag", ["-V", "--version"])
def test_the_version(flag: str) -> None:
    assert run(flag).stdout == f"ev3proto, version {VERSION}\n"


def test_the_list_of_subcommands_has_the_first_sentence_of_each() -> None:
    context = click.Context(cli)
    found = {name: cli.get_command(context, name) for name in SUBCOMMANDS}
    assert {name: command and first_sentence(command) for name, command in found.items()} == SUBCOMMANDS


@pytest.mark.parametrize(
    ("words", "start"),
    [
        (["decode"], "Usage: ev3proto decode "),
        (["export", "pcapng"], "Usage: ev3proto export pcapng "),
        ([], "Usage: ev3proto [OPTIONS] COMMAND"),
        (["sound.tone"], "SOUND.TONE  Plays one tone and returns at once\n"),
        (["E205"], "error[E205]: a misaligned variable\n"),
    ],
)
def test_help_of_anything(words: list[str], start: str) -> None:
    done = run("help", *words)
    assert done.returncode == 0
    assert done.stdout.startswith(start)


@pytest.mark.parametrize(
    ("word", "lines"),
    [
        ("LC1", ["LC1  A number of -127 to 127 in two bytes", "  identification byte 0x81"]),
        ("gv0", ["GV0  A variable in the first 32 bytes of global memory, which the reply carries"]),
        ("LCX", ["LCX  The shortest encoding of a number"]),
        ("COL-COLOR", ["COL-COLOR  EV3 colour sensor, mode 2 of TYPE_COLOR"]),
        ("US-DIST-CM", ["US-DIST-CM  EV3 ultrasonic sensor, mode 0 of TYPE_ULTRASONIC"]),
        ("VM_PROGRAM_VALIDATION", ["VM_PROGRAM_VALIDATION  An error of the firmware, as INFO.GET_ERROR reports it"]),
    ],
)
def test_help_of_what_people_ask_for(word: str, lines: list[str]) -> None:
    assert run("help", word).stdout.splitlines()[: len(lines)] == lines


def test_help_of_a_number_has_all_of_its_meanings() -> None:
    said = run("help", "0x81").stdout
    assert said == run("help", "129").stdout
    for name in ("LC1 (identification byte)", "SYSTEM_COMMAND_NO_REPLY (message type)", "UI_READ.GET_VBATT "):
        assert f"0x81 {name}" in said
    assert "0x08 END_OF_FILE (status)" in run("help", "8").stdout
    assert "0x1D TYPE_COLOR (type of a sensor or motor)" in run("help", "29").stdout


@pytest.mark.parametrize(
    ("said", "names"),
    [
        ("beep", ["SOUND.TONE"]),
        ("infrared", ["TYPE_IR", "IR-SEEK"]),
        ("encoder", ["OUTPUT_READ", "OUTPUT_CLR_COUNT", "OUTPUT_GET_COUNT"]),
        ("reset gyro", ["INPUT_DEVICE.CLR_ALL", "INPUT_WRITE"]),
        ("pairing", ["COM_GET.GET_PIN", "COM_SET.SET_PIN"]),
        ("stop", ["OUTPUT_STOP", "SOUND.BREAK"]),
        ("turn", ["OUTPUT_START", "OUTPUT_STEP_SPEED", "OUTPUT_TIME_SPEED", "OUTPUT_STEP_SYNC"]),
    ],
)
def test_help_by_what_people_call_it(said: str, names: list[str]) -> None:
    found = run("help", *said.split()).stdout
    assert found == run("ops", *said.split()).stdout
    assert [name for name in names if not re.search(rf"(^|0x.. ){re.escape(name)} ", found, re.MULTILINE)] == []


def test_help_suggests_what_is_known() -> None:
    assert "did you mean COL-COLOR" in run("help", "COL-COLR").stderr
    assert "did you mean US-DIST-CM" in run("help", "US-DISTCM").stderr


def test_help_of_a_status_says_what_it_means_for_each_command() -> None:
    assert run("help", "UNKNOWN_HANDLE").stdout.splitlines()[:4] == [
        "UNKNOWN_HANDLE  The system command failed",
        "  status 0x01",
        "  BEGIN_DOWNLOAD: the file cannot be created: it is a folder, or the file system refuses the name",
        "  CONTINUE_DOWNLOAD: no file is open under that handle: it is complete, closed, or was never opened",
    ]
    never = "no command of the published firmware answers with it"
    for name in ("CORRUPT_FILE", "ILLEGAL_PATH", "FILE_EXITS", "ILLEGAL_FILENAME"):
        assert run("help", name).stdout.splitlines()[2].strip() == never


def test_help_of_a_refused_command_says_what_to_do() -> None:
    said = run("help", "DIRECT_REPLY_ERROR").stdout
    assert "message type 0x04" in said
    assert "`ev3proto check FRAME` says which byte of the command the brick refuses" in said


def test_help_of_what_is_documented_and_never_implemented() -> None:
    said = run("help", "OUTPUT_GET_TYPE").stdout
    assert "documented, but not implemented by any firmware" in said
    assert "INPUT_DEVICE.GET_TYPEMODE with ports 16 to 19" in said


def test_ops_searches_words() -> None:
    def found(*words: str) -> list[str]:
        return [line.split()[1] for line in run("ops", *words).stdout.splitlines()]

    assert run("ops", "led").stdout.startswith("UI_WRITE.LED  ")
    assert "OUTPUT_STOP" in found("motor", "stops")
    assert "UI_READ.GET_VBATT" in found("battery", "voltage")
    assert run("ops", "LED_RED_FLASH").stdout.startswith("UI_WRITE.LED  ")
    assert run("ops", "148").stdout == run("ops", "0x94").stdout


def commands(command: click.Command, context: click.Context) -> Iterator[tuple[str, str]]:
    yield context.command_path, command.get_help(context)
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            below = command.get_command(context, name)
            assert below is not None
            yield from commands(below, click.Context(below, parent=context, info_name=name))


HELPS = dict(commands(cli, click.Context(cli, info_name="ev3proto")))


def examples(text: str) -> list[str]:
    return re.findall(r"^    (ev3proto .*)$", text, re.MULTILINE)


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_help_is_not_cut_off(columns: int) -> None:
    with mock.patch.dict(os.environ, COLUMNS=str(columns)):
        shown = dict(commands(cli, click.Context(cli, info_name="ev3proto")))
    for path, text in shown.items():
        # Of the three dots only those that mean "one or more" are left.
        assert not re.search(r"(?<!\])\.\.\.(?!\])", re.sub(r"(FILE|BEGIN_|WORDS|NAMES)\.\.\.", "", text)), path
        for line in text.splitlines():
            assert len(line) <= max(columns, 80), line


@pytest.mark.parametrize("path", HELPS)
def test_every_help_ends_with_examples_of_commands_that_there_are(path: str) -> None:
    text = HELPS[path]
    found = examples(text)
    assert found, path
    assert re.search(r"^    \S.*\n\nOptions:", text, re.MULTILINE), "the examples come last"
    for example in found:
        words = re.split(r"[|;>]", re.sub(r"'[^']*'|\"[^\"]*\"", "x", example))[0].split()
        command: click.Command = cli
        context = click.Context(cli, info_name="ev3proto")
        rest = words[1:]
        while isinstance(command, click.Group) and rest and not rest[0].startswith("-"):
            below = command.get_command(context, rest[0])
            assert below is not None, example
            command, rest = below, rest[1:]
        options = {name for each in command.params for name in (*each.opts, *each.secondary_opts)}
        used = {word.partition("=")[0] for word in rest if word.startswith("-") and word != "-"}
        assert used <= {*options, "--help", "-h"}, example


NEEDS_MORE = re.compile(
    r"ev3proto (brick|copy|live|proxy|send)\b"  # they need a brick, an interface, or Ctrl-C
    r"|--http|--to (usb|wifi)|\| (my_decoder|tshark)"
)
"""Examples that need more than a computer with ev3proto."""

MAY_FIND = ("ev3proto check", "ev3proto decode", "ev3proto replay")
"""Commands whose exit status reports a result: a fault, a different reply."""

NOT_AS_ROOT = "as root, Wireshark 4.4 and later load no Lua plugins"
"""What `dissector install` says to root, who has everything in its place then, and no Wireshark that would load it."""


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files that the examples name."""
    folder = tmp_path_factory.mktemp("desk")
    shutil.copy(ROOT / "captures" / "wifi.pcapng", folder / "robot.pcapng")
    shutil.copy(ROOT / "captures" / "lesson-02.log", folder / "robot.log")
    for name in ("hello.lms", "robot.lms"):
        (folder / name).write_text("vmthread MAIN { SOUND(TONE, 1, 440, 10) SOUND_READY() }\n")
    (folder / "tone.lms").write_text("SOUND(TONE, 1, 440, 1000)\n")
    for name in ("dissector", ".local/lib/wireshark/plugins"):
        (folder / name).mkdir(parents=True)
    for words in (["encode", "robot.lms", "-o", "robot.rbf"], ["dissector", "build", "-o", "dissector/ev3.lua"]):
        assert run(words[0], *(str(folder / word) if "." in word else word for word in words[1:])).returncode == 0
    return folder


@pytest.mark.parametrize("path", HELPS)
def test_the_examples_run(path: str, desk: Path) -> None:
    environment = {**os.environ, "HOME": str(desk), "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    # `ev3proto dissector` and `export` repeat what their subcommands show.
    for example in examples(HELPS[path]) if path not in ("ev3proto", "ev3proto export", "ev3proto dissector") else ():
        if NEEDS_MORE.search(example):
            continue
        if re.search(r"[|;<>~]", re.sub(r"'[^']*'|\"[^\"]*\"", "", example)):
            words = ["bash", "-o", "pipefail", "-c", example]
            done = subprocess.run(
                words, cwd=desk, env=environment, capture_output=True, text=True, check=False, timeout=60
            )
        else:
            done = run(*shlex.split(example)[1:], cwd=desk, env=environment)
        # What is checked may have a fault: that is what the example shows.
        expected = {0, 1} if path in MAY_FIND else {0}
        if os.geteuid() == 0 and NOT_AS_ROOT in done.stderr:
            expected = {1}
        assert done.returncode in expected, (example, done.stderr)
        assert "Traceback" not in done.stderr

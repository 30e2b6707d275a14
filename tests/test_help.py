"""Help: of every subcommand, whole and with examples that work; versions; the search for operations."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import click
import pytest
from support.cli import run_ev3proto_text as run

from ev3proto.cli.main import SUBCOMMANDS, cli
from ev3proto.version import VERSION


@pytest.mark.parametrize("flag", ["-V", "--version"])
def test_the_version(flag: str) -> None:
    assert run(flag).stdout == f"ev3proto, version {VERSION}\n"


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


def test_help_is_not_cut_off() -> None:
    for words in ([], ["export"], ["dissector"]):
        assert "..." not in run(*words, "--help").stdout.partition("Commands:")[2]


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
GROUPS = ("ev3proto export", "ev3proto dissector")
"""What has subcommands; `export` and `dissector` say by themselves how their subcommands are used."""

EXAMPLES = [path for path in HELPS if " " in path and not path.startswith(GROUPS)]


def examples(text: str) -> list[str]:
    return re.findall(r"^    (ev3proto .*)$", text, re.MULTILINE)


@pytest.mark.parametrize("path", EXAMPLES)
def test_every_subcommand_shows_how_it_is_used(path: str) -> None:
    found = examples(HELPS[path])
    assert found, path
    for example in found:
        words = re.split(r"[|;>]", re.sub(r"'[^']*'|\"[^\"]*\"", "x", example))[0].split()
        command: click.Command = cli
        context = click.Context(cli, info_name="ev3proto")
        rest = words[1:]
        while isinstance(command, click.Group) and rest:
            below = command.get_command(context, rest[0])
            assert below is not None, example
            command, rest = below, rest[1:]
        options = {name for each in command.params for name in (*each.opts, *each.secondary_opts)}
        used = {word.partition("=")[0] for word in rest if word.startswith("-") and word != "-"}
        assert used <= {*options, "--help", "-h"}, example


RUNNABLE = ("check", "decode", "encode", "files", "ops", "sample", "stats", "values")


@pytest.mark.parametrize("name", RUNNABLE)
def test_the_examples_run(name: str, tmp_path: Path) -> None:
    """Those that need nothing but files that a capture and a log stand for."""
    assert name in SUBCOMMANDS
    files = {"robot.pcapng": "captures/wifi.pcapng", "robot.log": "captures/lesson-02.log"}
    ran = 0
    for example in examples(HELPS[f"ev3proto {name}"]):
        words = shlex.split(example)[1:]
        if re.search(r"[|;><]", example) or any(word.endswith((".lms", ".rbf", ".bin")) for word in words):
            continue
        words = [files.get(word, word) for word in words]
        for option in ("-o", "--plot"):
            if option in words:
                at = words.index(option) + 1
                words[at] = str(tmp_path / words[at])
        done = run(*words)
        assert done.returncode in (0, 1), (example, done.stderr)
        assert "Traceback" not in done.stderr
        ran += 1
    assert ran, name

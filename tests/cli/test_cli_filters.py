"""Filters on the command line: only matching frames are shown, errors are underlined, all names are listed."""

from __future__ import annotations

import json
import re
from pathlib import Path

import click
import pytest
from support.cli import run_ev3proto_text as run

from ev3proto.capture import read
from ev3proto.capture.filter import compile_filter
from ev3proto.capture.filter.names import NAMES
from ev3proto.capture.timeline import collect
from ev3proto.cli.commands import SUBCOMMANDS, cli

CAPTURES = Path(__file__).parents[2] / "captures"
WIFI = str(CAPTURES / "wifi.pcapng")
TONE = "0f 00 2a 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03"


def commands_with_filters() -> list[list[str]]:
    found = []
    for name in SUBCOMMANDS:
        command = cli.get_command(click.Context(cli), name)
        below = command.commands.items() if isinstance(command, click.Group) else [(None, command)]
        for sub, each in below:
            assert each is not None
            if any("--filter" in parameter.opts for parameter in each.params):
                found.append([name] if sub is None else [name, sub])
    return found


@pytest.mark.parametrize("words", commands_with_filters(), ids=" ".join)
def test_every_subcommand_with_a_filter_lists_what_it_can_ask_for(words: list[str]) -> None:
    done = run(*words, "--help-filter")
    assert (done.returncode, done.stderr) == (0, "")
    lines = [line.split() for line in done.stdout.splitlines()]
    assert {line[0] for line in lines if line} >= {*NAMES}
    assert all(len(line) <= 100 for line in done.stdout.splitlines())
    assert {"FREQUENCY", "max_bytes", "LED_RED"} - {*done.stdout.split()} == {"LED_RED"}


def kinds(*words: str) -> list[str]:
    return [json.loads(line)["kind"] for line in run("decode", "--json", *words).stdout.splitlines()]


def test_nothing_but_frames_that_match_is_let_through() -> None:
    assert "beacon" in kinds(WIFI)
    for text in ("size > 0", "!error", "carrier == wifi", "time >= 0", "op || not op"):
        found = kinds("--filter", text, WIFI)
        assert found
        assert {*found} <= {*NAMES["kind"].kind.names}, text
    assert {*kinds("--filter", "kind == system-reply", WIFI)} == {"system-reply"}


def test_statistics_are_about_what_is_let_through() -> None:
    found = json.loads(run("stats", "--json", "--filter", "op == SOUND.TONE", WIFI).stdout)
    assert found["texts"] == {}
    assert found["transfers"] == []
    assert found["skipped"] == []


def test_texts_are_filtered_as_captures_are() -> None:
    text = f"{TONE}\n09:00|2B:00|00|04:00|81|01|60|\n07 00 2c 00 00 04 00 81 01 60\n06 00 2d 00 80 00 00 01\n"
    done = run("decode", "--json", "--filter", "op == SOUND.TONE && FREQUENCY == 1000", "-", stdin=text)
    assert [json.loads(line)["counter"] for line in done.stdout.splitlines()] == [42]
    assert [
        json.loads(line)["counter"]
        for line in run("decode", "--json", "--filter", "counter == 42", TONE).stdout.splitlines()
    ] == [42]


def test_raw_frames_are_filtered_too() -> None:
    raw = bytes.fromhex(TONE) + bytes.fromhex("06 00 2d 00 80 00 00 01") + bytes.fromhex("06 00 2e 00 80 00 00 01")
    done = run("decode", "--json", "--filter", "op == NOP", "-", stdin=raw)
    assert [json.loads(line)["counter"] for line in done.stdout.splitlines()] == [0x2D, 0x2E]
    assert len(run("decode", "--dialogues", "-", stdin=raw).stdout.splitlines()) == 3
    assert run("check", "--quiet", "--filter", "op == SOUND", "-", stdin=raw).stdout.startswith("1 frame: ")


def shown_times(*words: str) -> list[float]:
    return [float(time) for time in re.findall(r"^(\d+\.\d{6}) #", run("decode", *words).stdout, re.MULTILINE)]


def test_time_is_the_time_that_is_shown() -> None:
    late = shown_times("--filter", "time > 5.25s", WIFI)
    early = shown_times("--filter", "time <= 5250ms", WIFI)
    assert min(late) > 5.25
    assert max(early) <= 5.25
    assert early + late == shown_times("--filter", "size", WIFI)
    # Each file is read independently.
    assert shown_times("--filter", "time > 5.25s", WIFI, WIFI) == late + late


def test_dialogues_are_filtered_together() -> None:
    every = run("decode", "--dialogues", WIFI).stdout.splitlines()
    # A command whose reply does not match the filter was still answered.
    shown = run("decode", "--dialogues", "--filter", "kind == direct-command && !unanswered", WIFI).stdout.splitlines()
    assert {*shown} < {*every}
    assert not any("no reply" in line for line in shown)
    unanswered = run("decode", "--dialogues", "--filter", "unanswered", WIFI).stdout.splitlines()
    assert unanswered[1:] == [line for line in every if "no reply" in line] != []


@pytest.mark.parametrize("text", ["unanswered || size > 30", "failed || op == UI_READ", "!late"])
def test_the_order_stays_where_commands_wait_for_their_replies(text: str) -> None:
    found = [json.loads(line) for line in run("decode", "--json", "--filter", text, WIFI).stdout.splitlines()]
    numbers = [max(entry["packets"]) for entry in found]
    assert numbers
    assert numbers == sorted(numbers)


@pytest.mark.parametrize(
    ("text", "underlined"),
    [
        ("FREQENCY > 400", "FREQENCY"),
        ("op == SOUND.TOEN && error", "SOUND.TOEN"),
        ("error && latency > 5kg", "5kg"),
        ('path matches "(a"', '(a"'),
        ("error || " * 20 + "eror" + " || error" * 20, "eror"),
        ("error &&\terror\n&& eror", "eror"),
    ],
)
def test_an_error_is_underlined(text: str, underlined: str) -> None:
    done = run("decode", "--filter", text, WIFI)
    assert done.returncode == 2
    *_, shown, signs = done.stderr.splitlines()
    start, end = signs.index("^"), len(signs)
    assert signs[start:] == "^" * (end - start)
    assert shown[start:end] == underlined
    assert len(shown) < 140


def test_a_hostile_expression_is_refused() -> None:
    done = run("decode", "--filter", 'path matches "(a+)+$" || VALUE>1e60', WIFI)
    assert done.returncode == 2
    *_, shown, signs = done.stderr.splitlines()
    assert shown[signs.index("^") :] == '+$" || VALUE>1e60'


def test_a_timeline_of_unanswered_commands() -> None:
    with read(WIFI) as capture:
        drawn = collect(capture.events(), compile_filter("unanswered"))
    assert drawn is not None
    assert [mark.number for mark in drawn.marks] == [54]

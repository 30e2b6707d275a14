"""Samples: the requested frames, the same for the same seed, on any machine."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from itertools import islice
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from hypothesis import given, settings
from hypothesis import strategies as st
from support.cli import run_ev3proto_text, run_program
from support.effort import effort
from support.messages import frame_of

import ev3proto
from ev3proto import DaisyCommand, DirectCommand, MessageType, SystemCommand, SystemReply
from ev3proto.cli.sample import sample
from ev3proto.extras import install_command
from ev3proto.sampling import samples
from ev3proto.tables import OPCODES, area_of, operations
from ev3proto.tables.carriers import CARRIERS
from ev3proto.testing import accepted_frames, choice, frames, values_for

ROOT = Path(__file__).parents[2]
AREA = {opcode.name: area_of(opcode) for opcode in OPCODES}


@pytest.fixture(autouse=True)
def folder_of_hypothesis(monkeypatch: pytest.MonkeyPatch) -> None:
    """The other tests of this process keep theirs."""
    monkeypatch.setenv("HYPOTHESIS_STORAGE_DIRECTORY", ".hypothesis")


def run(*words: str) -> Result:
    return CliRunner().invoke(sample, words)


def drawn(*words: str) -> list[ev3proto.Message]:
    """The messages of a sample in hex, each of which must be correct."""
    done = run(*words)
    assert done.exit_code == 0
    return [ev3proto.parse(frame_of(line)) for line in done.stdout.splitlines()]


def test_frames_of_every_kind() -> None:
    messages = drawn("--count", "300")
    assert len(messages) == 300
    assert {message.type for message in messages} == set(MessageType)
    assert len({message.build() for message in messages}) > 290


def test_the_same_seed_gives_the_same_examples_everywhere() -> None:
    """Written out, because the promise is about all machines, not about another run in this process."""
    strategy = st.tuples(st.integers(0, 255), st.booleans(), st.text("abc", max_size=4), st.sampled_from("xyz"))
    assert list(islice(samples(strategy, 7), 4)) == [
        (56, True, "cbc", "y"),
        (168, True, "baac", "x"),
        (223, False, "acb", "y"),
        (39, False, "cbab", "y"),
    ]
    assert list(islice(samples(strategy, 8), 1)) == [(51, False, "", "z")]
    numbers = st.floats(width=32) | st.integers(-(2**31), 2**31) | st.binary(max_size=3)
    assert list(islice(samples(numbers, 1), 6)) == [
        -1338089011,
        -3.353839244463309e16,
        5.501497770939232e-42,
        -1022774389,
        b"\xc5",
        -1313649174,
    ]


def test_a_strategy_that_has_no_example() -> None:
    assert list(samples(st.integers().filter(lambda _: False), 1)) == []


def test_another_program_around_it_changes_nothing(tmp_path: Path) -> None:
    """Hypothesis by itself would draw numbers and texts that it finds in the modules of the program."""
    (tmp_path / "program.py").write_text(
        "numbers = [77777, 88888]\nfrom ev3proto.cli.sample import sample\nsample(['-n', '150', '--seed', '7'])\n"
    )
    variables = {"PATH": os.defpath, "PYTHONPATH": str(ROOT), "PYTHONHASHSEED": "5"}
    call = [sys.executable, "program.py"]
    done = subprocess.run(call, cwd=tmp_path, env=variables, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == run("-n", "150", "--seed", "7").stdout
    # And nothing is left behind.
    assert [path.name for path in tmp_path.iterdir()] == ["program.py"]


# What is asked for


def test_several_operations_and_a_family() -> None:
    names = {
        operation.full_name
        for message in drawn("-n", "100", "--op", "SOUND", "--op", "UI_FLUSH")
        if isinstance(message, DirectCommand)
        for operation in message.operations
    }
    assert names == {"SOUND.BREAK", "SOUND.TONE", "SOUND.PLAY", "SOUND.REPEAT", "SOUND.SERVICE", "UI_FLUSH"}


def test_an_area() -> None:
    operations = [
        operation.name
        for message in drawn("-n", "50", "--area", "timer", "--area", "output")
        if isinstance(message, DirectCommand)
        for operation in message.operations
    ]
    assert {AREA[name] for name in operations} == {"timer", "output"}


def test_what_is_named_and_of_the_area_too() -> None:
    names = {
        operation.full_name
        for message in drawn("-n", "100", "--op", "SOUND.TONE", "--op", "UI_FLUSH", "--area", "sound")
        if isinstance(message, DirectCommand)
        for operation in message.operations
    }
    assert names == {"SOUND.TONE"}
    messages = drawn("-n", "30", "--op", "LIST_FILES", "--op", "SOUND", "--area", "system")
    assert {type(message) for message in messages} == {SystemCommand, SystemReply}


def test_system_commands_and_their_replies() -> None:
    messages = drawn("-n", "60", "--op", "LIST_FILES")
    assert {type(message) for message in messages} == {SystemCommand, SystemReply}
    assert {message.command for message in messages if isinstance(message, SystemCommand | SystemReply)} == {
        "LIST_FILES"
    }
    assert len({message.type for message in drawn("-n", "60", "--area", "system")}) == 4


def test_types_of_messages() -> None:
    assert {message.type for message in drawn("-n", "30", "--type", "SYSTEM_REPLY_ERROR")} == {
        MessageType.SYSTEM_REPLY_ERROR
    }
    assert {message.kind for message in drawn("-n", "60", "--type", "direct-reply", "--type", "daisy-reply")} == {
        "direct-reply",
        "daisy-reply",
    }
    for message in drawn("-n", "30", "--op", "SOUND", "--type", "daisy_command_reply"):
        assert isinstance(message, DaisyCommand)
        assert {operation.name for operation in message.operations} <= {"SOUND"}


def test_frames_that_became_wrong() -> None:
    done = run("-n", "200", "--mutate", "--op", "UI_DRAW")
    faults = 0
    for line in done.stdout.splitlines():
        frame = frame_of(line)
        message = ev3proto.parse(frame, strict=False)
        assert message.build() == frame
        faults += message.fault is not None
    assert 100 < faults < 200


def test_other_dialects() -> None:
    done = run("-n", "5", "--op", "UI_DRAW.RECTANGLE", "--dialect", "xtended", "--format", "asm")
    assert done.exit_code == 0
    assert "RECTANGLE" in done.stdout


# What the brick accepts


@pytest.mark.parametrize("dialect", ["official", "xtended", "compat"])
@given(data=st.data())
@settings(max_examples=effort(100, 1000))
def test_accepted_frames_have_no_errors(dialect: str, data: st.DataObject) -> None:
    report = ev3proto.check(data.draw(accepted_frames(dialect)), dialect=dialect)
    assert report.accepted
    assert report.errors == ()


def test_accepted_frames_are_commands_of_every_kind() -> None:
    messages = drawn("--accepted", "-n", "300")
    assert {message.kind for message in messages} == {"direct-command", "system-command", "daisy-command"}
    counts = {len(message.operations) for message in messages if isinstance(message, DirectCommand)}
    assert counts == {1, 2, 3, 4, 5, 6}
    for message in drawn("--accepted", "--area", "move", "-n", "20"):
        assert isinstance(message, DirectCommand)
        assert message.operations


def test_accepted_frames_have_operations_of_every_name() -> None:
    """All except those that the firmware of 2013 refuses."""
    refused = {"ERROR", "UI_READ.GET_POWER", "UI_WRITE.ADDRESS"}
    for name in operations("official"):
        found = islice(samples(accepted_frames(chosen=choice(names=[name], types=["direct-command"])), 1), 1)
        assert (next(found, None) is None) == (name in refused), name


def test_accepted_frames_are_accepted_by_every_carrier() -> None:
    """As `check` judges with --carrier: the commands of the updater reach a brick only by USB."""
    frames = [frame_of(line) for line in run("--accepted", "-n", "100", "--seed", "1").stdout.splitlines()]
    assert [frame for frame in frames for carrier in CARRIERS if ev3proto.check(frame, carrier=carrier).errors] == []
    updater = run("--accepted", "-n", "5", "--op", "BEGIN_DOWNLOAD_WITH_ERASE", "--carrier", "usb")
    assert len(updater.stdout.splitlines()) == 5
    assert "Error: --carrier belongs to --accepted" in run("--carrier", "usb").output


def test_check_counts_no_errors_in_accepted_frames() -> None:
    done = run_ev3proto_text("check", "--quiet", stdin=run("--accepted", "-n", "200", "--seed", "7").stdout)
    assert done.returncode == 0
    assert done.stdout.startswith("200 frames: 0 errors, ")


# Forms


def test_every_form_is_the_same_frames() -> None:
    words = ("-n", "40", "--seed", "5", "--op", "SOUND")
    found = [frame_of(line) for line in run(*words).stdout.splitlines()]
    assert run(*words, "--format", "raw").stdout_bytes == b"".join(found)
    told = [json.loads(line) for line in run(*words, "--format", "json").stdout.splitlines()]
    assert [bytes.fromhex(entry["hex"]) for entry in told] == found
    assert "opSOUND" in run(*words, "--format", "asm").stdout
    assert "Plays one tone" in run(*words, "--format", "tree").stdout


# What is wrong


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--op", "SOND"), "unknown operation or system command SOND for the official firmware: did you mean SOUND?"),
        (("--op", "SOUND.TOEN"), "did you mean SOUND.TONE"),
        (("--type", "foo"), "unknown type of message foo: the kinds are direct-command, system-command, direct-reply"),
        (("--type", "DIRECT_REPLAY"), "unknown type of message DIRECT_REPLAY: did you mean DIRECT_REPLY"),
        (
            ("--op", "SOUND", "--type", "system-reply"),
            "no SYSTEM_REPLY or SYSTEM_REPLY_ERROR matches the choice: possible are DIRECT_COMMAND_REPLY",
        ),
        (
            ("--op", "SOUND", "--op", "LIST_FILES", "--area", "timer", "--area", "output"),
            "no given name is in the area timer or output: SOUND and LIST_FILES are of sound, system",
        ),
        (("--area", "none"), "'none' is not one of"),
        (("--accepted", "--mutate"), "--accepted and --mutate cannot be used together"),
        (("--accepted", "--type", "direct-reply"), "the brick accepts only commands"),
        (("--count", "0"), "0 is not in the range x>=1"),
        (("--seed", "-1"), "-1 is not in the range"),
    ],
)
def test_calls_that_are_wrong(words: tuple[str, ...], sentence: str) -> None:
    done = run(*words)
    assert done.exit_code == 2
    assert sentence in done.output


def test_without_hypothesis() -> None:
    program = (
        "import sys\nsys.modules['hypothesis'] = None\nfrom ev3proto.cli.sample import sample\nsample(['-n', '1'])\n"
    )
    done = run_program(sys.executable, "-c", program)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == (f"samples need hypothesis, which is not installed or too old: {install_command('sample')}\n")


def test_strategies_take_a_choice() -> None:
    """The same in users' own tests."""
    chosen = choice(areas=["sound"], types=["DIRECT_COMMAND_REPLY"])
    for frame in islice(samples(frames("official", chosen), 1), 30):
        message = ev3proto.parse(frame, expect=DirectCommand)
        assert message.wants_reply
        assert {AREA[operation.name] for operation in message.operations} == {"sound"}
    with pytest.raises(ValueError, match=r"^unknown area sond: the areas are vm, math"):
        choice(areas=["sond"])


def test_values_of_a_parameter_include_not_a_number() -> None:
    volume = operations()["SOUND.TONE"].parameters[0]
    assert -128 in islice(samples(values_for(volume), 1), 300)


def test_failed_draws_with_examples_between_them_do_not_end_the_samples() -> None:
    sometimes = st.booleans().filter(lambda drawn: drawn)
    assert len(list(islice(samples(sometimes, 1), 2500))) == 2500


def test_replies_follow_their_commands_and_have_values() -> None:
    done = run(
        "--op", "UI_READ.GET_VBATT", "--type", "DIRECT_COMMAND_REPLY", "--replies", "-n", "20", "--format", "json"
    )
    assert done.exit_code == 0
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [each["kind"] for each in found] == ["direct-command", "direct-reply"] * 20
    assert all(command["counter"] == reply["counter"] for command, reply in zip(found[::2], found[1::2], strict=True))
    assert {value["name"] for reply in found[1::2] for value in reply["values"]} == {"VALUE"}

"""How the command line ends: by signals, closed pipes and closed streams. Silently, and never with a traceback."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from support.cli import ROOT

from ev3proto.cli.commands import Commands, cli
from ev3proto.cli.ending import Ended, ended_by_signals

TONE = "0e002a0080000094010182b80182e803"
CAPTURE = "captures/wifi.pcapng"
SCRIPT = Path(sys.executable).with_name("ev3proto")

INTERRUPTS_ITSELF = """
import os, signal, sys
class AtImport:
    left = int(sys.argv.pop(1))
    def find_spec(self, name, path, target=None):
        AtImport.left -= 1
        if AtImport.left == 0:
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, AtImport())
sys.argv[0] = "ev3proto"
from ev3proto.cli.main import main
main()
"""
"""`ev3proto` as a program that gets Ctrl-C after a number of modules were looked for."""


@pytest.mark.parametrize("number", [30, 60, 100, 140])
def test_ctrl_c_while_modules_are_loaded(number: int) -> None:
    words = [sys.executable, "-c", INTERRUPTS_ITSELF, str(number), "decode", TONE]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (130, "")


@pytest.mark.parametrize("words", [[SCRIPT], [sys.executable, "-m", "ev3proto"]], ids=["script", "module"])
@pytest.mark.parametrize("milliseconds", [5, 60])
def test_ctrl_c_at_any_moment_once_the_package_is_begun(words: list[str], milliseconds: int) -> None:
    environment = {**os.environ, "PYTHONPROFILEIMPORTTIME": "1"}
    with subprocess.Popen(
        [*words, "decode"], stdin=subprocess.PIPE, stderr=subprocess.PIPE, env=environment, text=True
    ) as process:
        assert process.stderr is not None
        for line in process.stderr:  # Python prints each module there once it is loaded
            if "ev3proto.cli.main" in line:
                break
        time.sleep(milliseconds / 1000)
        process.send_signal(signal.SIGINT)
        said = process.stderr.read()
    assert process.returncode == 130
    assert [line for line in said.splitlines() if not line.startswith("import time:")] == []


def test_what_comes_before_is_nothing_but_the_package_itself() -> None:
    words = [sys.executable, "-X", "importtime", "-m", "ev3proto", "--version"]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    names = [line.rpartition("|")[2].strip() for line in done.stderr.splitlines()]
    before = names[: names.index("ev3proto.cli.main")]
    assert [
        name for name in before if name.startswith(("ev3proto.tables", "ev3proto.schema", "click", "construct"))
    ] == []


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ([SCRIPT], signal.SIGINT),
        ([sys.executable, "-m", "ev3proto"], signal.SIGINT),
        ([SCRIPT], signal.SIGTERM),
        ([SCRIPT], signal.SIGHUP),
    ],
)
def test_a_signal_while_input_is_awaited(words: list[str], number: signal.Signals) -> None:
    with subprocess.Popen(
        [*words, "decode"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(TONE.encode() + b"\n")
        process.stdin.flush()
        process.stdout.readline()
        process.send_signal(number)
        _, said = process.communicate(timeout=30)
    assert (process.returncode, said) == (128 + number, b"")


NEVER_ENDS = """
import threading
from ev3proto.cli import ending
ending.PATIENCE = 0.2
taken = threading.Lock()
taken.acquire()
with ending.ended_by_signals(), ending.stopped_by_signals(lambda: None):
    print("ready", flush=True)
    try:
        threading.Event().wait()
    finally:
        taken.acquire()
"""
"""A server that does not stop, and whose cleanup waits for a blocked thread, such as one that prints."""


def test_one_signal_is_enough_whatever_hangs() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", NEVER_ENDS], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline() == b"ready\n"
            process.send_signal(signal.SIGTERM)
            _, said = process.communicate(timeout=10)
        finally:
            process.kill()
    assert (process.returncode, said) == (128 + signal.SIGTERM, b"")


@pytest.mark.parametrize("words", [[SCRIPT], [sys.executable, "-m", "ev3proto"]])
def test_a_closed_pipe_is_not_a_fault(words: list[str], tmp_path: Path) -> None:
    (tmp_path / "long").write_text(f"{TONE}\n" * 20_000)
    call = " ".join(map(str, words))
    for command in (
        "decode --json long",
        f"decode {ROOT / CAPTURE}",
        "ops",
        "ops --json",
        "--help",
        "export json",
        "stats --help",
    ):
        line = f"set -o pipefail; {call} {command} | head -n 1"
        done = subprocess.run(["bash", "-c", line], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr, done.stdout.count("\n")) == (0, "", 1), command


def redirected(words: str, redirection: str) -> tuple[int, str]:
    """Runs `ev3proto WORDS REDIRECTION` in a shell. Returns the exit status and standard error."""
    line = f"{SCRIPT} {words} {redirection}"
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False, cwd=ROOT)
    return done.returncode, done.stderr


@pytest.mark.parametrize(
    "words",
    [
        f"decode {TONE}",
        f"stats {CAPTURE}",
        f"check {CAPTURE}",
        "ops",
        "--version",
        "--help",
        "",
        "decode --help",
        "export pcapng -h",
        "help ops",
    ],
)
def test_standard_output_that_is_closed_or_full(words: str) -> None:
    for redirection, reason in ((">&-", "standard output is closed"), (">/dev/full", "No space left on device")):
        assert redirected(words, redirection) == (1, f"the output cannot be written: {reason}\n"), redirection


def test_other_streams_that_are_closed_or_full() -> None:
    for redirection in ("2>&-", "<&-", "2>/dev/full"):
        assert redirected(f"decode {TONE}", redirection) == (0, ""), redirection
    assert redirected("decode", "<&-") == (1, "standard input: cannot be read: standard input is closed\n")


def test_a_signal_while_a_class_is_made_is_not_an_internal_error(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Python 3.11 turns such an exception into a RuntimeError, for example while a subcommand is being loaded."""

    class Part:
        def __set_name__(self, _owner: type, _name: str) -> None:
            raise Ended(signal.SIGTERM)

    monkeypatch.setattr(Commands, "get_command", lambda *_: type("Whole", (), {"part": Part()}))
    with pytest.raises(SystemExit) as ended, ended_by_signals():
        cli.main(["decode"])
    assert ended.value.code == 128 + signal.SIGTERM
    assert capsys.readouterr() == ("", "")

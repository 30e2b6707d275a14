"""What is said where nothing is found: every subcommand has the same sentence and exit status."""

from __future__ import annotations

from pathlib import Path

from support.cases import each
from support.cli import run_ev3proto_text as run

CAPTURE = "captures/usb-plugged.pcap"  # 35 packets with commands and replies, in which no file is transferred
NO_FRAME = "no frame found; frames are written in hex, such as 06:00|2A:00|80|00:00|01"
TONE = "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"

SUBCOMMANDS = (
    "decode",
    "decode --json",
    "decode --format csv",
    "decode --dialogues",
    "stats",
    "stats --json",
    "files",
    "files --json",
    "values",
    "values --csv",
    "timeline -o {folder}/x.json",
    "replay --to virtual --dry-run",
    "export pcapng -o {folder}/x.pcapng",
)
NOUNS = {"check": "command", "decode --programs": "program"}


@each("subcommand", [*SUBCOMMANDS, *NOUNS])
def test_a_filter_that_matches_nothing(subcommand: str, tmp_path: Path) -> None:
    words = subcommand.format(folder=tmp_path).split()
    done = run(*words, CAPTURE, "--filter", "FREQUENCY > 99999")
    wanted = NOUNS.get(subcommand, "frame")
    assert done.stderr == f"{CAPTURE}: no {wanted} in 35 packets matches the filter\n"
    assert (done.returncode, done.stdout) == (1, "")
    assert not list(tmp_path.iterdir())


@each("subcommand", [*SUBCOMMANDS, *NOUNS])
@each("chosen", [(), ("--filter", "op == SOUND")])
def test_a_text_without_frames(subcommand: str, chosen: tuple[str, ...], tmp_path: Path) -> None:
    log = tmp_path / "hello.txt"
    log.write_text("hello\n")
    done = run(*subcommand.format(folder=tmp_path).split(), log, *chosen)
    assert (done.returncode, done.stdout, done.stderr) == (1, "", f"{log}: {NO_FRAME}\n")


def test_of_several_files_the_one_in_which_nothing_matches_is_named(tmp_path: Path) -> None:
    log = tmp_path / "tone.log"
    log.write_text(f"sent {TONE}\n")
    for words in (("decode",), ("stats",), ("files",), ("values",)):
        done = run(*words, CAPTURE, log, "--filter", "op == UI_READ")
        assert done.returncode == 1
        assert f"{log}: no frame in 1 frame matches the filter\n" in done.stderr
        assert (CAPTURE in done.stderr) == (words == ("files",))  # which moves no file
        assert bool(done.stdout) == (words != ("files",))


def test_what_is_found_but_not_what_is_looked_for(tmp_path: Path) -> None:
    """An input without transferred files is not at fault."""
    for chosen in ((), ("--filter", "op == UI_READ")):
        done = run("files", CAPTURE, *chosen)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", f"{CAPTURE}: no file is moved\n")
    done = run("values", CAPTURE, "--filter", "op == UI_READ && direction == sent")
    assert (done.returncode, done.stderr) == (1, f"{CAPTURE}: no reply with its command found\n")
    done = run("timeline", "-o", tmp_path / "x.json", CAPTURE, "--from", "1000")
    assert (done.returncode, done.stderr) == (1, f"{CAPTURE}: no frame found from 1000 s\n")

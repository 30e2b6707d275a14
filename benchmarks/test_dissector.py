"""The cost of the dissector, compared with tshark without it in the same run: time as a ratio, memory as a difference.

    pytest benchmarks -k dissector -s

Each capture has 30,000 packets of one TCP connection: 15,000 commands that want a reply, and their replies. In the
usual capture, commands repeat, as programs send them; in the random one, almost all commands differ; in
the unanswered one, there are 30,000 commands and no replies. Times are CPU times, so that other programs on the
machine matter little; the shortest round counts. EV3PROTO_TSHARK selects the tshark to measure, as for the
tests.

The goals are 2.0 for one line, 3.0 for -V and 5.5 for two passes, all of the usual capture, and 450 bytes per packet in
a capture of 300,000. The limits below must not be exceeded; they are looser because machines differ.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import pytest
from support.frames import Segment, tcp_capture
from support.packets import HCI_WITH_DIRECTION, USBMON, Capture, Device, SerialPort, over
from support.wireshark import Tshark

from benchmarks.dialogue import dialogue, unanswered, usual_dialogue

COMMANDS = 15_000
ROUNDS = 5
OUTPUTS: dict[str, tuple[list[str], list[str]]] = {
    "one line": ([], []),
    "-V": (["-V"], ["-V"]),
    "two passes": (["-2", "-Y", "tcp"], ["-2", "-Y", "ev3"]),  # as Wireshark's window reads a file that it filters
}
"""The options of tshark without the dissector, and with it."""
MOST = {
    ("usual", "one line"): 2.2,
    ("usual", "-V"): 3.9,
    ("usual", "two passes"): 4.5,
    ("random", "one line"): 4.2,
    ("random", "-V"): 5.8,
    ("random", "two passes"): 9.0,
    ("unanswered", "one line"): 4.2,
    ("unanswered", "-V"): 6.0,
    ("unanswered", "two passes"): 9.0,
}
"""Limit of each kind of output, as a multiple of tshark's own time."""
MOST_BYTES = 2400
"""Bytes of memory per packet: in a capture as short as these, much of it is the dissector itself, and the contents of
commands that do not repeat, as of the random ones."""
MOST_EACH = {"one line": 60, "-V": 250}
"""Additional microseconds per packet on any carrier. It is not a ratio, as tshark without the dissector does almost
nothing with the contents of USB and Bluetooth packets."""
LONG, LONG_ROUNDS, MOST_LONG, MOST_LONG_BYTES = 150_000, 2, 3.2, 400
"""The same for a long capture: commands, rounds, and the limit for one line."""


def cost(command: list[str]) -> tuple[float, float]:
    """CPU seconds, and the maximum memory in bytes, of a program."""
    to_nothing = [
        (os.POSIX_SPAWN_OPEN, 0, os.devnull, os.O_RDONLY, 0),
        (os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0),
        (os.POSIX_SPAWN_OPEN, 2, os.devnull, os.O_WRONLY, 0),
    ]
    process = os.posix_spawn(command[0], command, os.environ, file_actions=to_nothing)
    _, status, usage = os.wait4(process, 0)
    assert status == 0, command
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


@pytest.mark.parametrize(
    ("name", "segments"),
    [("usual", usual_dialogue), ("random", dialogue), ("unanswered", unanswered)],
)
def test_dissector_ratios(
    name: str,
    segments: Callable[[int], Iterator[Segment]],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Prints the ratios; rounds alternate."""
    capture = tmp_path / "commands.pcap"
    capture.write_bytes(tcp_capture(segments(COMMANDS)))
    seconds: dict[tuple[str, bool], list[float]] = {}
    memory: dict[tuple[str, bool], list[float]] = {}
    with Tshark.from_setting() as tshark:
        placed = tshark.place(capture)
        for _ in range(ROUNDS):
            for output, options in OUTPUTS.items():
                for loaded in (False, True):
                    own_words = tshark.words if loaded else ["-n"]
                    took, most = cost([str(tshark.path), *own_words, "-r", str(placed), *options[loaded]])
                    seconds.setdefault((output, loaded), []).append(took)
                    memory.setdefault((output, loaded), []).append(most)
        version = ".".join(map(str, tshark.version))
    for output in OUTPUTS:
        bare, own = (min(seconds[output, loaded]) for loaded in (False, True))
        each = (max(memory[output, True]) - max(memory[output, False])) / (2 * COMMANDS)
        with capsys.disabled():
            times = f"{own / bare:.2f} x ({bare:.2f} s without, {own:.2f} s with)"
            print(f"\ntshark {version}, {name}, {output}: {times}, {each:.0f} bytes a packet", end="")
        assert own / bare <= MOST[name, output]
        assert each <= MOST_BYTES or output != "one line"


def usb_capture(segments: Iterable[Segment]) -> bytes:
    """The same in USB reports of an unknown device, as in most captures."""
    capture = Capture(USBMON)
    return over(capture, Device(capture), segments)


def rfcomm_capture(segments: Iterable[Segment]) -> bytes:
    """The same on a Bluetooth channel."""
    capture = Capture(HCI_WITH_DIRECTION)
    return over(capture, SerialPort(capture), segments)


@pytest.mark.parametrize(
    ("name", "capture"), [("WiFi", tcp_capture), ("USB", usb_capture), ("Bluetooth", rfcomm_capture)]
)
def test_dissector_on_each_carrier(
    name: str, capture: Callable[[Iterable[Segment]], bytes], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The additional time per packet of the usual dialogue, on USB and Bluetooth next to WiFi."""
    path = tmp_path / "commands.pcap"
    path.write_bytes(capture(usual_dialogue(COMMANDS)))
    with Tshark.from_setting() as tshark:
        placed = str(tshark.place(path))
        for output in ("one line", "-V"):
            words = OUTPUTS[output][0]
            commands = [[str(tshark.path), *own, "-r", placed, *words] for own in (["-n"], tshark.words)]
            rounds = [[cost(command)[0] for command in commands] for _ in range(ROUNDS)]
            bare, own = map(min, zip(*rounds, strict=True))
            each = 1e6 * (own - bare) / (2 * COMMANDS)
            with capsys.disabled():
                print(f"\n{name}, {output}: {each:.0f} microseconds more a packet", end="")
            assert each <= MOST_EACH[output]


def test_dissector_in_a_long_capture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One line of 300,000 packets: this measures what is kept of messages."""
    capture = tmp_path / "commands.pcap"
    capture.write_bytes(tcp_capture(usual_dialogue(LONG)))
    with Tshark.from_setting() as tshark:
        words = ["-r", str(tshark.place(capture))]
        commands = [[str(tshark.path), *own_words, *words] for own_words in (["-n"], tshark.words)]
        rounds = [[cost(command) for command in commands] for _ in range(LONG_ROUNDS)]
        version = ".".join(map(str, tshark.version))
    bare, own = (min(seconds) for seconds in zip(*([took for took, _ in costs] for costs in rounds), strict=True))
    bare_most, own_most = (max(most) for most in zip(*([most for _, most in costs] for costs in rounds), strict=True))
    each = (own_most - bare_most) / (2 * LONG)
    with capsys.disabled():
        times = f"{own / bare:.2f} x ({bare:.2f} s without, {own:.2f} s with)"
        print(f"\ntshark {version}, 300,000 packets, one line: {times}, {each:.0f} bytes a packet", end="")
    assert own / bare <= MOST_LONG
    assert each <= MOST_LONG_BYTES

"""`ev3proto replay`: the commands of a capture sent again, and how the replies differ."""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

import click

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.cli.formats import made
from ev3proto.cli.output import Printer, complain
from ev3proto.cli.reading import Problems, captures_of, reading_options
from ev3proto.cli.show import Dialogues
from ev3proto.cli.targets import channel_to, target_option, timeout_option
from ev3proto.errors import counted, near_misses
from ev3proto.link.channel import Channel
from ev3proto.link.errors import ConnectionLostError, NoAnswerError
from ev3proto.link.harm import Harm
from ev3proto.link.policy import conduct
from ev3proto.link.records import Records
from ev3proto.link.replay import Likeness, Replay, Step, compare, firmware_of, plan, steps
from ev3proto.link.targets import Target
from ev3proto.reading.options import Options
from ev3proto.tables import operations
from ev3proto.tables.system import SYSTEM
from ev3proto.text.phrases import command_spans
from ev3proto.text.spans import Role

_EVERYTHING = "all"
_NANOSECONDS = 1_000_000_000


def _allowed(_context: click.Context, _parameter: click.Parameter, given: tuple[str, ...]) -> frozenset[str]:
    """Returns what is allowed: groups in lower case, operations in upper case. Raises click.BadParameter."""
    known = {*operations(), *(entry.name for entry in SYSTEM)}
    found: set[str] = set()
    for name in (part.strip() for text in given for part in text.split(",")):
        if name.lower() == _EVERYTHING:
            found |= set(Harm)
        elif name.lower() in set(Harm):
            found.add(Harm[name.upper()])
        elif name.upper() in known:
            found.add(name.upper())
        else:
            hint = near_misses(name, known) or f"; expected an operation, {_EVERYTHING}, or one of {', '.join(Harm)}"
            raise click.BadParameter(f"unknown operation or group {name[:60]!r}{hint}")
    return frozenset(found)


@click.command()
@click.argument("name", metavar="CAPTURE")
@target_option
@click.option(
    "--allow",
    "allowed",
    multiple=True,
    callback=_allowed,
    metavar="NAME",
    help=f"Send also commands of this group ({', '.join(Harm)}), {_EVERYTHING}, or an operation such as OUTPUT_START,"
    " besides those that read; can be repeated.",
)
@click.option("--dry-run", is_flag=True, help="Send nothing; show which commands would be sent or omitted.")
@click.option("--differences", is_flag=True, help="Show only the dialogues that differ from the recorded ones.")
@click.option("--fast", is_flag=True, help="Send as fast as replies arrive, not at the pace of the capture.")
@timeout_option
@reading_options
def replay(
    name: str,
    target: Target,
    allowed: frozenset[str],
    dry_run: bool,
    differences: bool,
    fast: bool,
    timeout: float,
    reading: Options,
) -> None:
    """Sends the commands of a capture again, and compares the replies with the recorded ones.

    Values that differ between bricks or moments are shown, but count as recorded: times, the battery, sensors, names,
    the contents of files. The last lines count the replies, and name the brick's firmware if a command asks for it.

    Commands that only read are sent. Others are omitted and listed, unless --allow names what they do: see its list.
    `computing` may do anything: texts, arrays, jumps and variables can run hidden code and write over memory. Without
    it, the type of a sensor is sent as 0, which keeps what is plugged in, and files are read in pieces of its own.
    File handles are those that are assigned now; message counters are new.

    Exit status: 0 if every reply is of the recorded kind, whatever its values; 1 if one is missing or of another kind.

    \b
      ev3proto replay robot.pcapng --to virtual
      ev3proto replay robot.pcapng --to usb --dry-run
      ev3proto replay robot.pcapng --to wifi --fast --allow motors,settings
      ev3proto replay talk.pcapng --to usb --differences --allow computing
    """  # noqa: D301 - the mark by which click leaves lines as they are
    captures, problems = captures_of([name], reading), Problems()
    found = list(steps(dialogues(problems.captured(captures.events()))))
    if not found:
        problems.end_without(f"{captures.part.label}: no command found")
    if dry_run:
        _show_plan(found, allowed)
        sys.exit(problems.status)
    # Nothing is plugged into a virtual brick: the recorded one had its own equipment.
    with channel_to(replace(target, is_bare=True)) as channel:
        replaying = _Replaying(
            channel, str(target), timeout, reading.dialect, allowed, fast=fast, only_different=differences
        )
        is_fine = replaying.run(found)
    sys.exit(0 if is_fine and not problems.errors else 1)


def _show_plan(found: list[Step], allowed: frozenset[str]) -> None:
    printer = Printer()
    left_out = 0
    for step, harms in plan(found, allowed):
        command = command_spans(step.command.message)
        left_out += bool(harms)
        if harms:
            printer.lines([[("omitted   ", Role.FAULT), *command, (_why(harms), Role.ASIDE)]])
        else:
            printer.lines([[("sent      ", Role.VALUE), *command]])
    complain(f"{counted(len(found) - left_out, 'command')} would be sent, {left_out} omitted")


def _why(harms: Mapping[Harm, str]) -> str:
    return "".join(f"; {name} {harm.text} (--allow {harm})" for harm, name in harms.items())


class _Replaying:
    def __init__(
        self,
        channel: Channel,
        peer: str,
        timeout: float,
        dialect: str,
        allowed: frozenset[str],
        *,
        fast: bool,
        only_different: bool,
    ) -> None:
        self._channel = channel
        self._records = Records(channel.carrier, peer, dialect)
        self._replay = Replay(allowed)
        self._timeout = timeout
        self._dialect = dialect
        self._fast = fast
        self._only_different = only_different
        self._firmware: str | None = None
        self._dialogues = Dialogues(made(None), is_known=True)
        self._printer = Printer()
        self._counts: Counter[str] = Counter()

    def run(self, found: list[Step]) -> bool:
        """Sends all steps. Returns whether every reply is of the recorded kind."""
        begin, begin_ns = time.monotonic(), found[0].command.time_ns
        try:
            for step in found:
                if not self._fast:
                    due = begin + (step.command.time_ns - begin_ns) / _NANOSECONDS
                    time.sleep(max(0.0, due - time.monotonic()))
                self._step(step)
            conduct(self._replay.leave(), self._exchange)
        except ConnectionLostError as error:
            complain(str(error))
            return False
        counts = self._counts
        if self._firmware is not None:
            complain(f"the firmware of the brick is {self._firmware}")
        complain(
            f"{counted(len(found) - counts['omitted'], 'command')} sent, {counts['omitted']} omitted; answered"
            f" {', '.join(f'{counts[each.value]} {each.value}' for each in Likeness)}"
        )
        return not counts[Likeness.KIND.value]

    def _step(self, step: Step) -> None:
        outcome = conduct(self._replay.talk(step), self._exchange)
        if outcome.harms:
            self._counts["omitted"] += 1
            line = [("omitted: ", Role.FAULT), *command_spans(step.command.message), (_why(outcome.harms), Role.ASIDE)]
            self._printer.lines([line])
            return
        frame, reply = outcome.frame, outcome.reply
        command = self._records.sent(frame)
        received = None if reply is None else self._records.received(reply, command)
        if received is not None:
            self._firmware = firmware_of(received) or self._firmware
        likeness, difference = compare(step, frame, reply, self._dialect)
        self._counts[likeness.value] += 1
        if self._only_different and likeness is Likeness.SAME:
            return
        self._dialogues.show(RequestReply(command, received), self._records.start_ns)
        if difference:
            role = Role.FAULT if likeness is Likeness.KIND else Role.MEANING
            self._printer.lines([[(f"{'':20} {difference}", role)]])

    def _exchange(self, frame: bytes) -> bytes | None:
        ticket = self._channel.send_again(frame)
        try:
            return self._channel.wait(ticket, self._timeout) or None
        except NoAnswerError as error:
            complain(str(error))
            return None

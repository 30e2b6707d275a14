"""The headline of an input in words: what it is and does, what is wrong with it, and which change each button makes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ev3proto.checking.report import Report, Severity, difference
from ev3proto.errors import counted
from ev3proto.messages import DirectReply
from ev3proto.program.report import ProgramReport
from ev3proto.reading.headline import Headline, Proposal, Subject
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, read_memory
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.phrases import spaced_hex
from ev3proto.text.sentence import deed, sentence
from ev3proto.text.spans import visible

NONE, TAKES, REFUSES = "none", "takes", "refuses"

_MOST_BYTES = 6
"""Maximum number of bytes that a button names."""

_SEVERITIES = list(Severity)


def headline(known: Headline) -> dict[str, Any]:
    """Returns the headline, for JSON.

    sentence  what the input is and does
    verdict   what is wrong with it; empty for an input that is not judged
    kind      what the brick does: TAKES, REFUSES, or NONE
    severity  of the worst finding, but for hints; empty without one
    """
    kind, severity, verdict = _judged(known)
    if known.unread and known.commands and kind == TAKES:
        kind, verdict = NONE, f"{verdict[:-1]}, but not all of the input could be read."
    return {
        "sentence": visible(_SENTENCES[known.subject](known)),
        "verdict": visible(verdict),
        "kind": kind,
        "severity": severity,
    }


# What it is


def _capital(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}"


def _frame(known: Headline) -> str:
    assert known.exchange is not None
    message, done = known.exchange.message, deed(known.exchange)
    if known.missing:
        return sentence(known.exchange, known.missing)
    name = "not an EV3 message" if message.type is None else f"a command of {counted(len(message.build()), 'byte')}"
    return f"{_capital(done or name)}."


def _reply(known: Headline) -> str:
    assert known.exchange is not None
    message = known.exchange.message
    is_error = message.type is not None and message.type.is_error
    name = "An error reply" if is_error else "A reply"
    if is_error and isinstance(message, DirectReply):
        return f"{name}: command {message.counter} failed."
    return f"{name} that {deed(known.exchange)}."


def _many(name: str) -> Callable[[Headline], str]:
    def said(known: Headline) -> str:
        parts = [
            counted(known.commands, "command") if known.commands else "",
            _replies(known.frames - known.commands),
        ]
        of = f": {' and '.join(filter(None, parts))}" if all(parts) else ""
        if known.read:
            return f"The filter matches {_number(known.frames)} of the {_number(known.read)} frames of {name}{of}."
        return f"{_capital(name)} of {_number(known.frames)} frame{'s' * (known.frames != 1)}{of}."

    return said


def _replies(count: int) -> str:
    return "" if not count else "1 reply" if count == 1 else f"{_number(count)} replies"


def _number(count: int) -> str:
    return f"{count:,}"


def _bare(lacks: str) -> Callable[[Headline], str]:
    return lambda known: f"A frame without its {lacks}: {deed(known.exchange) if known.exchange else ''}."


_SENTENCES: dict[Subject, Callable[[Headline], str]] = {
    Subject.EMPTY: lambda _: "",
    Subject.TEXT: lambda _: "A text without a frame.",
    Subject.FILE: lambda _: "A file without a frame.",
    Subject.MISTAKEN: lambda known: f"Operations with {'a mistake' if known.unread == 1 else 'mistakes'}.",
    Subject.NO_HEADER: _bare("header"),
    Subject.NO_LENGTH: _bare("length"),
    Subject.FRAME: _frame,
    Subject.REPLY: _reply,
    Subject.PART: lambda _: "A frame that cannot be read to its end.",
    Subject.FRAMES: _many("a series"),
    Subject.LOG: _many("a log"),
    Subject.CAPTURE: _many("a capture"),
    Subject.PROGRAM: lambda known: f"A program of {counted(known.frames, 'object')} and {counted(known.read, 'byte')}.",
}


# What is wrong


def _judged(known: Headline) -> tuple[str, str, str]:
    """Returns what the brick does, the severity of the worst finding, and a sentence."""
    by_itself = _BY_ITSELF.get(known.subject)
    if by_itself is not None:
        return NONE, "", by_itself(known)
    if known.subject is Subject.PROGRAM or known.frames == known.commands == 1:
        return _one(known.worst)
    return _several(known) if known.commands else (NONE, "", "")


def _of_reply(known: Headline) -> str:
    assert known.exchange is not None
    message = known.exchange.message
    if message.fault is not None:
        return f"{_capital(message.fault.reason)}."
    is_error = message.type is not None and message.type.is_error
    return "It does not say why: check the command that it answers." if is_error else ""


def _of_bare(known: Headline) -> str:
    """Returns what is missing, and a hint about a value, which is often what such bytes were copied for."""
    hints = [] if known.worst is None else [each for each in known.worst.findings if each.parameter]
    header = ": length, counter, type and memory" if known.subject is Subject.NO_HEADER else ""
    needs = f"A brick needs its {'header' if header else 'length'} first{header}."
    return " ".join([needs, *(f"{each.message}; {each.help}." for each in hints[:1])])


_BY_ITSELF: dict[Subject, Callable[[Headline], str]] = {
    Subject.EMPTY: lambda _: "",
    Subject.MISTAKEN: lambda _: "",
    Subject.FILE: lambda _: "",
    Subject.TEXT: lambda _: (
        "Frames are written in hex, such as 06 00 2A 00 80 00 00 01. Operations are read, too: OUTPUT_POWER(0, 1, 50)."
    ),
    Subject.NO_HEADER: _of_bare,
    Subject.NO_LENGTH: _of_bare,
    Subject.PART: lambda _: "",
    Subject.REPLY: _of_reply,
}
"""What is said of what the brick does not judge."""


def _one(report: Report | None) -> tuple[str, str, str]:
    if report is not None and not report.accepted:
        return REFUSES, Severity.ERROR, f"The brick refuses it at byte {report.rejected_at or 0}{_because(report)}."
    if report is None or not (severity := _worst(report)):
        return TAKES, "", "The brick takes it."
    return TAKES, severity, f"The brick takes it, but {_reason(report)}."


def _several(known: Headline) -> tuple[str, str, str]:
    where = f"; in {known.place}, {_reason(known.worst)}" if known.worst is not None else ""
    commands = "the command" if known.commands == 1 else f"all {_number(known.commands)} commands"
    if known.refused:
        refused = "the command" if known.commands == 1 else f"{_number(known.refused)} of {known.commands:,} commands"
        return REFUSES, Severity.ERROR, f"The brick refuses {refused}{where}."
    for severity, count in ((Severity.ERROR, known.wrong), (Severity.WARNING, known.doubtful)):
        if count:
            some = "it" if known.commands == 1 else f"{_number(count)} of them"
            have = f"{some} {'has' if count == 1 else 'have'} {severity}s"
            return TAKES, severity, f"The brick takes {commands}, but {have}{where}."
    return TAKES, "", f"The brick takes {commands}."


def _because(report: Report) -> str:
    return f", because {_reason(report)}" if report.findings else ""


def _reason(report: Report) -> str:
    """Returns what was probably meant, or else the finding at which the brick stops, or the worst one."""
    meant = () if isinstance(report, ProgramReport) or not report.errors else report.nearest
    if len(meant) == 1:
        return meant[0].message
    stops = [each for each in report.findings if each.offset == report.rejected_at]
    return min(stops or report.findings, key=lambda each: (_SEVERITIES.index(each.severity), each.offset)).message


def _worst(report: Report) -> str:
    """Returns the worst severity; empty without a finding, and for hints."""
    found = [each.severity for each in report.findings if each.severity is not Severity.HINT]
    return min(found, key=_SEVERITIES.index, default="")


# What was meant


def label(proposal: Proposal, *, has_lines: bool) -> str:
    """Returns the text of a button that makes a change; in a text of several lines, it names the line."""
    return f"Line {proposal.line}: {_change(proposal)}" if has_lines and proposal.line else _change(proposal)


def _change(proposal: Proposal) -> str:
    if proposal.kind in _LABELS:
        return _LABELS[proposal.kind].format(before=proposal.before, after=proposal.after)
    before, after = proposal.before, proposal.after
    assert isinstance(before, bytes)
    assert isinstance(after, bytes)
    if before[LENGTH_FIELD:] == after[LENGTH_FIELD:]:
        return f"Set the length to {frame_size(after) - LENGTH_FIELD}"
    at, end, new = difference(before, after)
    if HEADER_SIZE <= at < end <= COMMAND_HEADER_SIZE and len(before) == len(after):
        return "Request {} bytes of global and {} of local memory".format(*read_memory(after))
    old = before[at:end]
    if max(len(old), len(new)) > _MOST_BYTES:
        return f"Change {counted(max(len(old), len(new)), 'byte')} from byte {at} on"
    if not old or not new:
        return f"{'Insert' if new else 'Remove'} {spaced_hex(old or new)} at byte {at}"
    return f"Change {spaced_hex(old)} at byte {at} to {spaced_hex(new)}"


_LABELS = {
    "length-missing": "Add the length",
    "header-missing": "Add a header",
    "digits": "Read the digits",
    "letters": "Read O as 0 and l as 1",
    "name": "Change {before} to {after}",
    "shorter": "Write it in fewer bytes",
    "all": "Make all of these changes",
}
"""The labels of changes that are not just of some bytes."""

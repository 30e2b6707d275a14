"""The headline of an input in words: what it is and does, what is wrong with it, and which change each button makes."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ev3proto.checking.report import Report, Severity, difference
from ev3proto.messages import DirectReply
from ev3proto.program.report import ProgramReport
from ev3proto.reading.headline import Headline, Proposal, Subject
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, read_memory
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.phrases import spaced_hex
from ev3proto.text.sentence import deed, sentence
from ev3proto.text.spans import visible

from .overview import is_answer

NONE, TAKES, REFUSES = "none", "takes", "refuses"

_MOST_BYTES = 6
"""Maximum number of bytes that a button names."""


def headline(known: Headline) -> dict[str, str]:
    """Returns the headline, for JSON.

    sentence  what the input is and does
    verdict   what is wrong with it; empty for an input that is not judged
    kind      what the brick does: TAKES, REFUSES, or NONE
    severity  of the worst finding, but for hints; empty without one
    """
    say, name, judge, advice = _SUBJECTS[known.subject]
    kind, severity, verdict = judge(known, advice)
    if known.unread and kind == TAKES:
        kind, verdict = NONE, f"{verdict[:-1]}, but not all of the input could be read."
    verdict = " ".join([*filter(None, [verdict]), *_replies(known)])
    return {"sentence": visible(say(known, name)), "verdict": visible(verdict), "kind": kind, "severity": severity}


Verdict = tuple[str, str, str]
"""What the brick does, the severity of the worst finding, and a sentence."""

# What it is


def _capital(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}"


def _counted(count: int, noun: str) -> str:
    return f"{count:,} {noun if count == 1 else f'{noun}s'.replace('ys', 'ies')}"


def _said(_: Headline, sentence: str) -> str:
    return sentence


def _frame(known: Headline, part: str) -> str:
    message, done = known.exchange.message, deed(known.exchange)
    if known.missing and not (part and message.type):
        return sentence(known.exchange, known.missing)
    size = len(message.build())
    if message.type is None:
        return f"{_counted(size, 'byte')}, not a frame." if size < HEADER_SIZE else "Not an EV3 message."
    return part or f"{_capital(done or f'a command of {size} bytes')}."


def _reply(known: Headline, name: str) -> str:
    message, done = known.exchange.message, deed(known.exchange)
    is_error = message.type is not None and message.type.is_error
    name = "An error reply" if is_error else name
    if message.type is not None and message.type.is_command:
        return f"A command that came from the brick: {done}."
    if is_error and isinstance(message, DirectReply):
        return f"{name}: command {message.counter} failed."
    return f"{name} that {done}." if done else f"{name}."


def _many(known: Headline, name: str) -> str:
    counts = [(known.commands, "command"), (known.frames - known.commands, "reply")]
    has_replies = known.frames > known.commands
    of = f": {' and '.join(_counted(*each) for each in counts if each[0])}" if has_replies else ""
    if known.read:
        return f"The filter matches {known.frames:,} of the {_counted(known.read, 'frame')} of {name}{of}."
    return f"{_capital(name)} of {_counted(known.frames, 'frame')}{of}."


def _bare(known: Headline, lacks: str) -> str:
    name, then = ("reply", ", which") if is_answer(known.exchange.message) else ("frame", ":")
    return f"A {name} {lacks}{then} {deed(known.exchange)}."


def _mistaken(known: Headline, name: str) -> str:
    return f"{name} with {'a mistake' if known.unread == 1 else 'mistakes'}."


def _program(known: Headline, name: str) -> str:
    return f"{name} of {_counted(known.frames, 'object')} and {_counted(known.read, 'byte')}."


# What is wrong


def _of_reply(known: Headline, advice: str) -> Verdict:
    message = known.exchange.message
    if message.fault is not None:
        return NONE, Severity.ERROR, f"{_capital(message.fault.reason)}."
    if known.rest:
        more = f"{_counted(known.rest, 'byte')} {'follows' if known.rest == 1 else 'follow'} it"
        return NONE, Severity.ERROR, f"{more} that its length field does not count."
    says_why = not isinstance(message, DirectReply) or not message.is_error
    return NONE, "", "" if says_why else advice


def _advised(known: Headline, advice: str) -> Verdict:
    """Returns what could be read instead; an error that is shown says more."""
    return NONE, "", "" if known.unread else advice


def _of_bare(known: Headline, lacks: str) -> Verdict:
    """Has a hint about a value, which such bytes are often tried for."""
    if is_answer(known.exchange.message):
        return NONE, "", "A reply begins with its length."
    hints = [] if known.worst is None else [each for each in known.worst.findings if each.parameter]
    said = [f"A brick needs its {lacks}.", *(f"{each.message}; {each.help}." for each in hints[:1])]
    return NONE, "", " ".join(said)


def _of_one(known: Headline, _: str) -> Verdict:
    report = known.worst
    if report is not None and not report.accepted:
        at = report.rejected_at or 0
        return REFUSES, Severity.ERROR, f"The brick refuses it at byte {at}: {_reason(report)}."
    if report is None or not (severity := _worst(report)):
        return TAKES, "", "The brick takes it."
    return TAKES, severity, f"The brick takes it, but it has {_ONE[severity]}: {_reason(report)}."


_ONE = {"error": "an error", "warning": "a warning"}


def _of_frames(known: Headline, _: str) -> Verdict:
    if known.frames == known.commands == 1:
        return _of_one(known, "")
    if not known.commands:
        return NONE, "", ""
    where = f"; in {known.place}: {_reason(known.worst)}" if known.worst is not None else ""
    every = {1: "the command", 2: "both commands"}.get(known.commands, f"all {known.commands:,} commands")
    if known.refused:
        refused = every if known.refused == known.commands else f"{known.refused:,} of {known.commands:,} commands"
        return REFUSES, Severity.ERROR, f"The brick refuses {refused}{where}."
    if not (count := known.wrong or known.doubtful):
        return TAKES, "", f"The brick takes {every}."
    severity = Severity.ERROR if known.wrong else Severity.WARNING
    return TAKES, severity, f"The brick takes {every}, but {_some(known, count, severity)}{where}."


def _some(known: Headline, count: int, severity: Severity) -> str:
    """Returns how many commands have findings of a severity: `2 of them have errors`."""
    is_one = count == 1 and known.worst is not None and len(known.worst.of(severity)) == 1
    what = _ONE[severity] if is_one else f"{severity}s"
    return f"{'it' if known.commands == 1 else f'{count:,} of them'} {'has' if count == 1 else 'have'} {what}"


def _replies(known: Headline) -> Iterator[str]:
    """Yields what is to be known of replies among other frames."""
    if known.frames > 1 and known.failed:
        yield f"{_counted(known.failed, 'reply')} {'says' if known.failed == 1 else 'say'} that a command failed."
    if known.frames > 1 and known.faulty:
        yield f"{_counted(known.faulty, 'reply')} cannot be right."


_SUBJECTS: dict[Subject, tuple[Callable[[Headline, str], str], str, Callable[[Headline, str], Verdict], str]] = {
    Subject.EMPTY: (_said, "", _advised, ""),
    Subject.TEXT: (
        _said,
        "A text without a frame.",
        _advised,
        "Frames are written in hex, such as 06 00 2A 00 80 00 00 01. Operations are read, too: OUTPUT_POWER(0, 1, 50).",
    ),
    Subject.FILE: (_said, "A file without a frame.", _advised, ""),
    Subject.PART: (_frame, "A frame that cannot be read to its end.", _advised, ""),
    Subject.MISTAKEN: (_mistaken, "Operations", _advised, ""),
    Subject.SOURCE: (_mistaken, "A program", _advised, ""),
    Subject.NO_HEADER: (_bare, "without its header", _of_bare, "header first: length, counter, type and memory"),
    Subject.NO_LENGTH: (_bare, "without its length", _of_bare, "length first"),
    Subject.HALF_LENGTH: (_bare, "with a length of one byte", _of_bare, "length first, in two bytes"),
    Subject.LETTERS: (
        _bare,
        "with letters for digits",
        _advised,
        "Bytes are written with the digits 0 to 9 and the letters A to F.",
    ),
    Subject.FRAME: (_frame, "", _of_frames, ""),
    Subject.REPLY: (_reply, "A reply", _of_reply, "It does not say why: check the command that it answers."),
    Subject.FRAMES: (_many, "a series", _of_frames, ""),
    Subject.LOG: (_many, "a log", _of_frames, ""),
    Subject.CAPTURE: (_many, "a capture", _of_frames, ""),
    Subject.PROGRAM: (_program, "A program", _of_one, ""),
}
"""What is said of each kind of input: what it is, and what is wrong with it; each with its own words."""


def _reason(report: Report) -> str:
    """Returns what was probably meant, or else the finding at which the brick stops, or the worst one."""
    meant = () if isinstance(report, ProgramReport) or not report.errors else report.nearest
    if len(meant) == 1 and meant[0].kind != "memory-size":
        return meant[0].message
    stops = [each for each in report.findings if each.offset == report.rejected_at]
    return next(each for severity in Severity for each in stops or report.findings if each.severity is severity).message


def _worst(report: Report) -> str:
    """Returns the worst severity; empty without a finding, and for hints."""
    return next((severity for severity in (Severity.ERROR, Severity.WARNING) if report.of(severity)), "")


# What was meant


def label(proposal: Proposal, *, has_lines: bool) -> str:
    """Returns the text of a button that makes a change; in a text of several lines, it names the line."""
    return f"Line {proposal.line}: {_change(proposal)}" if has_lines and proposal.line else _change(proposal)


def _change(proposal: Proposal) -> str:
    before, after = proposal.before, proposal.after
    if proposal.kind in _LABELS or not (isinstance(before, bytes) and isinstance(after, bytes)):
        return _LABELS[proposal.kind].format(before=before, after=after)
    length = f"et the length to {frame_size(after) - LENGTH_FIELD}"
    if before[LENGTH_FIELD:] == after[LENGTH_FIELD:]:
        return f"S{length}"
    # The length of a right one changes with the bytes.
    is_wrong = before[:LENGTH_FIELD] != after[:LENGTH_FIELD] and frame_size(before) != len(before)
    return f"{_change_of_bytes(before, after)}{f', and s{length}' if is_wrong else ''}"


def _change_of_bytes(before: bytes, after: bytes) -> str:
    at, end, new = difference(before, after)
    if HEADER_SIZE <= at < end <= COMMAND_HEADER_SIZE and len(before) == len(after):
        global_size, local_size = read_memory(after)
        return f"Request {_counted(global_size, 'byte')} of global and {local_size} of local memory"
    old = before[at:end]
    count = max(len(old), len(new))
    if not old or not new:
        named = spaced_hex(old or new) if count <= _MOST_BYTES else _counted(count, "byte")
        return f"{'Insert' if new else 'Remove'} {named} at byte {at}"
    if count > _MOST_BYTES:
        return f"Change {_counted(count, 'byte')} from byte {at} on"
    return f"Change {spaced_hex(old)} at byte {at} to {spaced_hex(new)}"


_LABELS = {
    "length-missing": "Add the length",
    "length-half": "Write the length in two bytes",
    "header-missing": "Add a header",
    "digits": "Read the digits",
    "letters": "Read O as 0 and l as 1",
    "name": "Change {before} to {after}",
    "shorter": "Write it in fewer bytes",
    "all": "Make all of these changes",
}
"""The labels of changes that are not just of some bytes."""

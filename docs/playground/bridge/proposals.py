"""What was probably meant by a wrong input: changes of a line each, and one that makes all that are certain."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

from ev3proto.checking.checking import check
from ev3proto.dialogue import Exchange
from ev3proto.reading.headline import Headline, Proposal, Subject
from ev3proto.reading.items import Problem, ProblemCode
from ev3proto.schema.frame import parse
from ev3proto.schema.header import frame_size
from ev3proto.semantics.identify import Kind, identify
from ev3proto.text.fixed_text import fix_text
from ev3proto.text.forms import as_hex
from ev3proto.text.paste import Pasted
from ev3proto.text.paste.near import bytes_in

from .overview import is_answer
from .words import meant

MOST_LINES = 12
"""Maximum number of lines of a log for which proposals are looked for."""

_LETTERS = str.maketrans("OolI", "0011")
"""Letters that look like digits."""

_LETTER = re.compile("[G-WYZg-wyz]")
"""A letter that numbers in decimals and hex do not have."""

_BETWEEN = re.compile(r"0[xX]|\\x|\W")
"""What may be between the bytes of a frame in hex."""

_BARE = {
    Kind.NO_LENGTH: (Subject.NO_LENGTH, "length-missing"),
    Kind.HALF_LENGTH: (Subject.HALF_LENGTH, "length-half"),
    Kind.OPERATIONS: (Subject.NO_HEADER, "header-missing"),
}
"""What bytes are that lack something, and the kind of what is added to them."""


def bare(text: str, pieces: Sequence[Pasted]) -> tuple[Headline, Proposal] | None:
    """Returns what hex is that is a frame but for its header, its length or some letters, and the frame; or None.

    With a whole frame among the `pieces` of a text, it is not one that lacks something.
    """
    if _bytes_of(text) is None and _is_right(frame := _bytes_of(text.translate(_LETTERS)) or b""):
        return _known(Subject.LETTERS, "letters", b"", frame, text)
    data = _bare_bytes(text, pieces)
    found = identify(data)
    if found.frame is None or found.kind not in _BARE:
        return None
    if not (is_answer(parse(found.frame, strict=False)) or _is_right(found.frame)):
        return None
    return _known(*_BARE[found.kind], data, found.frame, text)


def _bare_bytes(text: str, pieces: Sequence[Pasted]) -> bytes:
    """Returns the bytes of a text without a whole frame, in hex or as decimals; empty for any other text."""
    if any(piece.data and len(piece.data) == frame_size(piece.data) for piece in pieces):
        return b""
    is_line = "\n" not in text.strip() and not _LETTER.search(text)
    is_wrong = any(piece.problem for piece in pieces)
    return bytes_in(text.strip()) if is_line and is_wrong else _bytes_of(text) or b""


def _known(subject: Subject, kind: str, data: bytes, frame: bytes, text: str) -> tuple[Headline, Proposal]:
    """Returns the headline of a text that is nearly a frame, and the proposal of the frame."""
    message = parse(frame, strict=False)
    made = Proposal(kind, 0, data, frame, as_hex(message) + "\n" * text.endswith("\n"))
    return Headline(subject, exchange=Exchange(message), worst=check(frame, alone=True)), made


def proposals(text: str, wrong: Mapping[int, bytes | None], problems: Sequence[Problem]) -> list[Proposal]:
    """Returns what was probably meant by a text.

    Args:
        text: The text.
        wrong: The numbers of its wrong lines, from 1 on, each with the frame in it, if there is one.
        problems: What is wrong with it, if all of it is the source of something.
    """
    if any(problem.code is ProblemCode.SOURCE for problem in problems):
        return list(_respelt(text, problems))
    return list(_of_lines(text, wrong)) if wrong else []


def _of_lines(text: str, wrong: Mapping[int, bytes | None]) -> Iterator[Proposal]:
    lines = text.split("\n")
    if "\n" not in text.strip():
        wrong = {text[: len(text) - len(text.lstrip())].count("\n") + 1: next(iter(wrong.values()))}
    fixed = fix_text(text)
    certain = {each.line: each.fix.frame for each in fixed.frames if each.is_written and each.line in fixed.lines}
    for number, frame in islice(sorted(wrong.items()), MOST_LINES):
        line, edited = lines[number - 1], fixed.text.split("\n")[number - 1]
        for made, (kind, new) in _candidates(line, frame, certain.get(number), edited).items():
            whole = "\n".join([*lines[: number - 1], new, *lines[number:]])
            yield Proposal(kind, number, frame or bytes_in(line), made, whole)
    if len(fixed.lines) > 1:
        yield Proposal("all", 0, "", "", fixed.text)


def _candidates(line: str, frame: bytes | None, made: bytes | None, edited: str) -> dict[bytes, tuple[str, str]]:
    """Returns the frames that a line may mean, each with its kind of slip and the line that has it.

    `frame` is what is in it, if that is a frame; `made` the certain fix, and `edited` the line with it.
    """
    found = _of_line(line, frame)
    if made is not None and (made in found or not found):
        kind = "shorter" if _is_right(frame or b"") else ""  # of a right frame
        found[made] = found[made][0] if found else kind, edited
    return found


def _of_line(line: str, frame: bytes | None) -> dict[bytes, tuple[str, str]]:
    """Returns the candidates but for the certain fix."""
    # Bytes may start after each word that is not bytes.
    starts = [word.end() for word in re.finditer(r"(\S+)\s+", line) if _bytes_of(word[1]) is None]
    for start in (0, *starts):
        text = line[start:]
        data = _bytes_of(text)
        if data is not None and _is_right(data):
            break  # what its end may mean is not what was meant
        found: dict[bytes, tuple[str, str]] = {}
        for kind, new in _meant(text) if frame in (None, data) else ():
            found.setdefault(new, (kind, line[:start] + as_hex(parse(new))))
        if found:
            return found
    return {}


def _respelt(text: str, problems: Sequence[Problem]) -> Iterator[Proposal]:
    """Yields the nearest known name in place of each one that is unknown."""
    lines = text.split("\n")
    for problem in problems[:MOST_LINES]:
        line, column = problem.place.line or 1, problem.place.column or 1
        given = lines[line - 1]
        word = re.compile(r"[\w.]*").match(given, column - 1)
        assert word is not None
        for name in meant(given[: word.end()])[:1]:
            edited = [*lines[: line - 1], given[: column - 1] + name + given[word.end() :], *lines[line:]]
            yield Proposal("name", line, word[0], name, "\n".join(edited))


def _meant(text: str) -> Iterator[tuple[str, bytes]]:
    """Yields frames that a brick accepts and that a text may mean, the likeliest first, each with its kind of slip."""
    data = _bytes_of(text)
    if data is None:
        data = _bytes_of(text.translate(_LETTERS))
        if data is None or _is_right(data):
            yield from () if data is None else [("letters", data)]
            return
    found = identify(data)
    candidates = [] if found.frame is None or found.kind not in _BARE else [(_BARE[found.kind][1], found.frame)]
    candidates += [(each.kind, each.frame) for each in check(data, alone=True).nearest if not each.unknown]
    yield from (each for each in candidates if _is_right(each[1]))


def _bytes_of(text: str) -> bytes | None:
    """Returns the bytes of a text that has nothing but hex."""
    digits = _BETWEEN.sub("", text.strip())
    if not digits or len(digits) % 2 or not re.fullmatch(r"[0-9A-Fa-f]+", digits):
        return None
    return bytes.fromhex(digits)


def _is_right(frame: bytes) -> bool:
    """Returns whether a brick accepts a frame, without errors."""
    report = check(frame, alone=True)
    return parse(frame, strict=False).fault is None and report.accepted and not report.errors

"""The nearest right frame: what was meant by a frame with one slip.

Every slip is undone by an edit of `edits`. A candidate costs its edit and what is read then; `check` judges the
cheapest few. Silence has a cost, too: that of the findings. So the answer is the cheapest right frame, if it is cheaper
than to say nothing, and not so dear that many other slips would explain the bytes as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import accumulate, takewhile
from operator import ne
from typing import NamedTuple

from ev3proto.checking import codes
from ev3proto.checking.checking import check
from ev3proto.checking.dangers import acts_of, warning
from ev3proto.checking.edits import DIRECT, SYSTEM, Edit, header_edits, left_over, operation_edits, spaced, system_edits
from ev3proto.checking.habits import habitual
from ev3proto.checking.report import Report, Suggestion
from ev3proto.checking.slips import CHOICES, HABITS, SLIPS
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand
from ev3proto.schema.frame import frame_reader, read_last
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    MEMORY_SIZE,
    MOST_IN_REPLY,
    TYPE_AT,
    frame_size,
    read_memory,
    with_length,
    write_memory,
)
from ev3proto.semantics.footprint import NO_MEMORY, Memory, memory_of
from ev3proto.semantics.identify import NOTHING, Kind, foreign, identify
from ev3proto.semantics.likelihood import CommandCode
from ev3proto.semantics.mangled import Mangled, mangled
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, REPLY_TYPES, MessageType

SURE = 3.6
"""The cost up to which a suggestion without a guess is certain enough for a fix."""

_MOST = 8.2  # the cost above which nothing is said: too many other slips are as likely
_MARGIN = 0.4  # how much better than silence
_CLEAR = 1.1  # how much better than all others a fix is
_MOST_OF_CANDIDATE = 13.0  # the cost of a candidate, besides that of the frame's operations themselves
_LESS_WITH_MEMORY = 2.0  # how much less a candidate costs for which other memory is requested
_LIKELY = 0.5  # the further cost of an edit below which a slip is likely at its place
_ELSEWHERE = 1.0  # the cost of a place without the slip, where it could be
_TIE = 0.7  # the difference up to which two are equally likely
_MOST_OF_FIRST = 5.0  # the cost of one slip from which on the same slip in several places is looked for
_OTHER_LENGTH = 3.5  # the cost of a length that is wrong besides
_COPIED = -1.5  # the length was right before a slip in copying
_MOST_OF_REPLY = 11  # the cost of a long reply where commands are expected
_DIGIT_OF_MEMORY = 1.0  # the cost of more memory than is used, by one digit
_WITH_MEMORY = 0.5  # the cost of global memory for a variable that was local
_LARGE_COUNTER = 1.5  # a counter of 32768 and more

_OF_MEMORY = {"memory-swapped": (0.0, -1.5), "memory-shift": (0.0, -1.5), "header-order": (3.0, -3.3)}
"""Edits after which the header requests other memory: what speaks for them if it is not, or is, what is used."""

# Bounds on what is tried for one frame.
_SHORTEST, _LONGEST = HEADER_SIZE, MAX_FRAME + 64
_MOST_READ = 25_000  # bytes of all operations that are read with an edit
_MOST_JUDGED = 24  # candidates that `check` judges in a round
_MOST_CHECKED = 9_000  # bytes of all candidates that `check` judges
_MOST_OPERATIONS = 8  # operations in which edits are tried, around the first suspicious one
_SUSPICIOUS = 2.0  # the cost of an operation from which on it is

_WEIGHTS = {
    **{"E": 10.0, "E207": 1.0, "E212": 1.0, "E502": 1.0, "E6": 4.0, "E803": 1.0, "E804": 1.0},
    **{"W": 5.0, "W101": 0.0, "W201": 0.5, "W407": 8.0, "W303": 3.0, "W304": 3.0, "W5": 2.0, "W6": 2.0, "W7": 1.0},
    **{"W709": 6.0, "W804": 1.0, "W805": 2.0, "W806": 1.0},
    **{"H": 1.0, "H301": 3.5, "H401": 1.5, "H702": 1.5, "H708": 3.5, "H901": 0.3},
}
"""Costs of findings by the beginnings of their codes. An operation's effect, or a text's length, is rarely a slip."""
_NO_SLIPS = frozenset(code for code, weight in _WEIGHTS.items() if code[0] == "E" and weight <= 1)
_REFUSED = 6.0
_BEYOND = {codes.BEYOND_LOCALS.code, codes.BEYOND_GLOBALS.code}


_CHANGED = {"utf-8": 2, "text-mode": 2, "replaced": 3, "ascii": 1}
"""Bytes for one that went through a text."""


class _Candidate(NamedTuple):
    """A frame that may have been meant.

    edits   what leads to it, one after the other, of one kind
    price   the cost of the edits
    read    the cost of what is read then
    """

    edits: tuple[Edit, ...]
    price: float
    read: float
    frame: bytes


class _Judged(NamedTuple):
    """A candidate with what `check` says of it.

    cost   of all
    doubt  the same without the rarity of its operations
    """

    cost: float
    doubt: float
    candidate: _Candidate
    is_right: bool


_MOST_IN_RUN = 100


@lru_cache(2 * _MOST_IN_RUN)
def nearest(report: Report) -> tuple[Suggestion, ...]:
    """Returns what was probably meant by a frame: nothing, one frame, or two that are equally likely."""
    if not _SHORTEST <= len(report.frame) <= _LONGEST or not report.findings:
        return ()
    if any(finding.code == "H101" for finding in report.findings):
        frame = report.frame[: frame_size(report.frame)]  # without the padding of a USB report
        return check(frame, dialect=report.dialect, carrier=report.carrier, alone=report.alone).nearest
    return tuple(_with_warning(report, one) for one in _meant(report))


def _with_warning(report: Report, one: Suggestion) -> Suggestion:
    """Returns a suggestion that tells what it would do that the given frame does not."""
    harm = warning(acts_of(one.frame, report.dialect) - acts_of(report.frame, report.dialect))
    return replace(one, message=f"{one.message}; {harm}", harm=harm) if harm else one


def _meant(report: Report) -> tuple[Suggestion, ...]:
    reader = frame_reader(report.dialect)
    found = foreign(report.frame, reader)
    if found.kind is Kind.DIGITS and found.frame is not None:
        sentence = SLIPS["digits"].sentence
        return (Suggestion("digits", 0, len(report.frame), sentence, found.frame, is_sure=True),)
    if found is not NOTHING:
        return ()
    text = mangled(report.frame, reader)
    meant = _Search(report).suggestions() if text is None else (_before_text(report.frame, text),)
    bare = NOTHING if meant else identify(report.frame, reader=reader)
    if bare.kind is Kind.OPERATIONS and bare.frame is not None:
        return (Suggestion("header-missing", 0, 0, SLIPS["header-missing"].sentence, bare.frame),)
    return meant


class Suggestions:
    """The suggestions for the frames of one run: one search for each distinct content, at most 100 of them.

    is_stopped  whether there were more
    """

    def __init__(self) -> None:
        self._known: dict[bytes, Report] = {}
        self.is_stopped = False

    def of(self, report: Report) -> tuple[Suggestion, ...]:
        """Returns what was probably meant by a frame, whose counter does not matter."""
        frame, end = report.frame, TYPE_AT
        if not report.findings:
            return ()
        body = frame[:LENGTH_FIELD] + frame[end:]
        if body not in self._known:
            if len(self._known) == _MOST_IN_RUN:
                self.is_stopped = True
                return ()
            self._known[body] = report
        known = self._known[body]
        found = known.nearest
        if known.frame == frame:
            return found
        return tuple(
            replace(one, frame=one.frame[:LENGTH_FIELD] + frame[LENGTH_FIELD:end] + one.frame[end:])
            for one in found
            if one.frame[LENGTH_FIELD:end] == known.frame[LENGTH_FIELD:end]
        )


def _before_text(frame: bytes, text: Mangled) -> Suggestion:
    """Returns the frame before it went through a text, which explains all its bytes."""
    places = enumerate(zip(frame, text.original, strict=False))
    at = next(place for place, (one, other) in places if one != other)
    words = (spaced(frame[at : at + 2]), spaced(text.original[at : at + 1]))
    message = SLIPS[text.kind].sentence.format(*words)
    lost = tuple((one, 1) for one in text.lost)
    return Suggestion(text.kind, at, _CHANGED[text.kind], message, text.original, lost, is_sure=not lost)


class _Search:
    """The search for what one frame was meant to be."""

    def __init__(self, report: Report) -> None:
        self._report = report
        self._frame, self._dialect = report.frame, report.dialect
        self._unread, self._unchecked = _MOST_READ, _MOST_CHECKED
        self._acts = acts_of(self._frame, self._dialect)
        self._known: dict[bytes, tuple[float, float]] = {}

    def suggestions(self) -> tuple[Suggestion, ...]:
        """Returns the best candidates, if they are better than silence."""
        rarity, doubt = self._costs(self._frame, self._report)
        is_good_reply = _is_reply(self._frame) and not doubt
        if _is_reply(self._frame):
            # Any bytes are a reply, but only few are a command but for its type or its counter.
            doubt += min(len(self._frame) - HEADER_SIZE, _MOST_OF_REPLY)
        right = [one for one in self._right(doubt) if not (is_good_reply and _is_reply(one.candidate.frame))]
        if not right or right[0].cost > rarity + doubt - _MARGIN or right[0].doubt > _MOST:
            return ()
        return _told(right)

    def _right(self, doubt: float) -> list[_Judged]:
        """Returns the right candidates, the best first, for a frame that costs as much as it is in doubt."""
        right = [one for one in self._best(self._frame) if one.is_right]
        is_found = bool(right) and right[0].doubt <= _MOST_OF_FIRST and right[0].candidate.edits[0].kind not in HABITS
        if doubt < _MOST_OF_FIRST or is_found:
            return right
        habits = list(self._habits())
        return sorted([*(_once(one, habits) for one in right), *habits], key=_by_cost)

    # Judging

    def _costs(self, frame: bytes, report: Report) -> tuple[float, float]:
        """Returns the costs of a frame: of its operations themselves, and the worse of its values and its findings."""
        weight = sum([_weight(finding.code) for finding in report.findings])
        if not (report.accepted or _is_reply(frame) or any(one.code in _NO_SLIPS for one in report.errors)):
            weight += _REFUSED
        if len(frame) <= COMMAND_HEADER_SIZE or frame[TYPE_AT] not in DIRECT:
            return 0.0, weight
        rarity, rest = self._code_costs(frame)
        return rarity, max(weight, rest - rarity)

    def _code_costs(self, frame: bytes) -> tuple[float, float]:
        """Returns the costs of a frame's operations themselves and of its whole code, computed once for each code."""
        key = frame[HEADER_SIZE:]
        if key not in self._known:
            code = CommandCode(frame, self._dialect)
            self._known[key] = code.rarity, code.rest()
        return self._known[key]

    def _check(self, frame: bytes) -> Report:
        self._unchecked -= len(frame)
        return check(frame, dialect=self._dialect, carrier=self._report.carrier, alone=self._report.alone)

    def _judged(self, candidate: _Candidate) -> _Judged:
        candidate, report = self._fitted(candidate, self._check(candidate.frame))
        rarity, doubt = self._costs(candidate.frame, report)
        acts = acts_of(candidate.frame, self._dialect) - self._acts
        doubt += candidate.price + sum({one: one.cost for one, _ in acts}.values())
        is_right = not report.errors and (report.accepted or (_is_reply(candidate.frame) and _is_reply(self._frame)))
        is_worse = self._report.accepted and not all(one.is_told for one, _ in acts)
        return _Judged(rarity + doubt, doubt, candidate, is_right and not is_worse)

    def _fitted(self, candidate: _Candidate, report: Report) -> tuple[_Candidate, Report]:
        """Returns a candidate and its report; it requests more memory if only that is wrong with it."""
        beyond = {finding.code for finding in report.errors}
        if not beyond or not beyond <= _BEYOND or candidate.edits[0].kind == "digit":
            return candidate, report
        frame = _with_memory(candidate.frame, self._dialect)
        if frame == candidate.frame:
            return candidate, report
        return candidate._replace(frame=frame, price=candidate.price + SLIPS["memory-size"].cost), self._check(frame)

    def _best(self, frame: bytes) -> list[_Judged]:
        """Returns the best candidates one edit away, as `check` judges them."""
        best: dict[bytes, _Candidate] = {}
        for one in self._candidates(frame):
            other = best.get(one.frame)
            if len(one.frame) < _SHORTEST:
                continue
            if other is None or one.price + one.read < other.price + other.read:
                best[one.frame] = one
        best.pop(frame, None)
        found: list[_Judged] = []
        most = self._costs(frame, self._report)[0] + _MOST_OF_CANDIDATE
        for one in sorted(best.values(), key=lambda each: each.price + each.read)[:_MOST_JUDGED]:
            # A candidate costs what is read, or less if other memory is requested for it.
            if self._unchecked <= 0 or one.price + one.read > most:
                break
            found.append(self._judged(one))
            if found[-1].is_right:
                most = min(most, found[-1].cost + _CLEAR + _LESS_WITH_MEMORY)
        return sorted(found, key=_by_cost)

    def _habits(self) -> Iterator[_Judged]:
        """Yields right frames that edits of one kind in several places lead to: a slip out of habit."""
        frame = self._frame
        if len(frame) <= COMMAND_HEADER_SIZE or frame[TYPE_AT] not in DIRECT:
            return
        for edits, price, read in habitual(CommandCode(frame, self._dialect)):
            new = frame
            for edit in reversed(edits):
                new = new[: edit.at] + edit.new + new[edit.end :]
            new, other = self._resized(frame, new)
            judged = self._judged(_Candidate(edits, price + other, read, new))
            if judged.is_right:
                yield judged

    # Candidates

    def _candidates(self, frame: bytes) -> Iterator[_Candidate]:
        """Yields the candidates one edit away."""
        yield from self._with_other_length(frame)
        for edit in header_edits(frame):
            yield self._with_header(frame, edit)
        if len(frame) <= COMMAND_HEADER_SIZE:
            return
        if frame[TYPE_AT] in DIRECT:
            yield from self._with_other_memory(frame)
            yield from self._with_code(frame)
        elif frame[TYPE_AT] in SYSTEM:
            for edit in system_edits(frame):
                new, price = self._applied(frame, edit)
                yield _Candidate((edit,), price, 0.0, new)

    def _applied(self, frame: bytes, edit: Edit) -> tuple[bytes, float]:
        """Returns a frame after an edit, with a length that fits, and the cost of both."""
        new = frame[: edit.at] + edit.new + frame[edit.end :]
        price = SLIPS[edit.kind].cost + edit.extra
        if edit.at < LENGTH_FIELD:
            return with_length(new[LENGTH_FIELD:]), price
        if edit.kind == "left-over" and frame_size(frame) == len(new):
            return new, price
        new, other = self._resized(frame, new)
        return new, price + other

    def _resized(self, frame: bytes, new: bytes) -> tuple[bytes, float]:
        """Returns what a frame became, with a length that fits, and what the given one speaks for or against it."""
        stated = frame_size(frame)
        if stated == len(new) and stated != len(frame):
            return new, _COPIED
        return with_length(new[LENGTH_FIELD:]), 0.0 if stated == len(frame) else _OTHER_LENGTH

    def _read(self, frame: bytes) -> float:
        """Returns the cost of a frame's code."""
        is_code = len(frame) > COMMAND_HEADER_SIZE and frame[TYPE_AT] in DIRECT
        return self._code_costs(frame)[1] if is_code else 0.0

    def _with_other_length(self, frame: bytes) -> Iterator[_Candidate]:
        stated, size = frame_size(frame) - LENGTH_FIELD, len(frame) - LENGTH_FIELD
        if stated == size:
            return
        new = with_length(frame[LENGTH_FIELD:])
        kind = "length"
        if stated == size + LENGTH_FIELD:
            kind = "length-self"
        elif frame[1::-1] == new[:LENGTH_FIELD]:
            kind = "length-swapped"
        elif f"{stated:x}" == str(size):
            kind = "length-decimal"
        follow = f"{counted(stated, 'byte')} {'follows' if stated == 1 else 'follow'}"
        words = (size, spaced(new[:LENGTH_FIELD]), stated, spaced(frame[:LENGTH_FIELD]), follow)
        edit = Edit(kind, 0, LENGTH_FIELD, new[:LENGTH_FIELD], words)
        yield _Candidate((edit,), SLIPS[kind].cost, self._read(new), new)
        at = stated + LENGTH_FIELD
        if HEADER_SIZE < at < len(frame):
            edit = left_over(frame, at)
            new, price = self._applied(frame, edit)
            yield _Candidate((edit,), price, self._read(new), new)

    def _with_header(self, frame: bytes, edit: Edit) -> _Candidate:
        new, price = self._applied(frame, edit)
        price += _LARGE_COUNTER if new[3] >= 0x80 else 0.0
        if edit.kind in ("memory-missing", "memory-half"):
            new = _with_memory(new, self._dialect)
        elif edit.kind in _OF_MEMORY and new[TYPE_AT] in DIRECT:
            shared, local, _ = _needed_memory(new, self._dialect) or NO_MEMORY
            other, exact = _OF_MEMORY[edit.kind]
            is_exact = (shared, local) == read_memory(new)
            is_none = not shared and not local and edit.kind != "header-order"
            price += 5.0 if is_none else exact if is_exact else other
        return _Candidate((edit,), price, self._read(new), new)

    def _with_other_memory(self, frame: bytes) -> Iterator[_Candidate]:
        """Yields the frame with the memory that its operations use, and with a reply if they have results."""
        base = _OTHER_LENGTH if frame_size(frame) != len(frame) else 0.0
        whole = with_length(frame[LENGTH_FIELD:])
        needed = _needed_memory(whole, self._dialect) or NO_MEMORY
        message = read_last(whole, self._dialect)
        operations = message.operations if isinstance(message, DirectCommand) else ()
        storing = next((one.full_name for one in operations if one.has_outputs), None)
        yield from self._with_sizes(whole, needed, base, has_results=storing is not None)
        if frame[TYPE_AT] == MessageType.DIRECT_COMMAND_NO_REPLY and storing is not None and needed.globals:
            reply = bytes((MessageType.DIRECT_COMMAND_REPLY,))
            edit = Edit("no-reply", TYPE_AT, HEADER_SIZE, reply, (storing,))
            new = whole[:TYPE_AT] + reply + whole[HEADER_SIZE:]
            yield _Candidate((edit,), SLIPS[edit.kind].cost + base, self._read(new), new)

    def _with_sizes(self, frame: bytes, needed: Memory, base: float, *, has_results: bool) -> Iterator[_Candidate]:
        """Yields the frame with more memory, or with less if one digit is wrong and no result may be meant for it."""
        (shared, local, is_exact), asked = needed, read_memory(frame)
        at, end = HEADER_SIZE, COMMAND_HEADER_SIZE
        new, price = _with_memory(frame, self._dialect), SLIPS["memory-size"].cost
        if new == frame:
            new, price = frame[:at] + write_memory(shared, local) + frame[end:], _DIGIT_OF_MEMORY
            is_meant = has_results and asked[0] > shared == 0
            if is_meant or not is_exact or sum(map(ne, new.hex(), frame.hex())) != 1:
                return
        words = counted(shared, "byte"), counted(local, "byte"), *asked
        edit = Edit("memory-size", at, end, new[at:end], words, guess=0 if is_exact else MEMORY_SIZE)
        yield _Candidate((edit,), price + base, self._read(new), new)

    def _with_code(self, frame: bytes) -> Iterator[_Candidate]:
        code = CommandCode(frame, self._dialect)
        costs = [reading.cost for _, reading in code.first]
        is_clean = max(costs, default=0.0) < _SUSPICIOUS
        for number in _suspicious(code, costs):
            start, reading = code.first[number]
            for edit in operation_edits(code, start, reading):
                if self._unread <= 0:
                    return
                self._unread -= reading.end - start + 4
                cost = code.edited(start, edit.at, edit.end, edit.new, is_guess=edit.guess > 0)
                if cost is None:
                    continue
                new, price = self._applied(frame, edit)
                read = sum(costs[:number]) + cost
                if edit.kind == "scope":
                    new, read, price = *self._moved(new, read), price + _WITH_MEMORY
                if is_clean and edit.guess:
                    price = max(price, SLIPS[edit.kind].cost + edit.extra) + 1.0
                yield _Candidate((edit,), price, read, new)

    def _moved(self, frame: bytes, read: float) -> tuple[bytes, float]:
        """Returns a frame whose results were in local memory with global memory for them, and what is read."""
        new = _with_memory(frame, self._dialect)
        if new == frame:
            return frame, read - _WITH_MEMORY
        new = _with_memory(frame, self._dialect, keeps_locals=False)  # which is not needed then
        return new, self._read(new)


def _weight(code: str) -> float:
    """Returns the cost of a finding."""
    return next(_WEIGHTS[key] for key in (code, code[:2], code[0]) if key in _WEIGHTS)


def _is_reply(frame: bytes) -> bool:
    return frame[TYPE_AT] in REPLY_TYPES


def _by_cost(one: _Judged) -> float:
    return one.cost


def _told(right: list[_Judged]) -> tuple[Suggestion, ...]:
    """Returns the first of some right candidates, and another one that is as likely."""
    best = right[0]
    others = [one for one in right if one.cost <= best.cost + _TIE and _place(one) != _place(best)]
    is_clear = all(one.cost > best.cost + _CLEAR for one in right[1:])
    return tuple(_suggestion(one, is_clear=is_clear) for one in (best, *others[:1]))


def _once(one: _Judged, habits: list[_Judged]) -> _Judged:
    """Returns a candidate with one slip; it is dearer if the same slip is as likely in other places."""
    edit = one.candidate.edits[0]
    alike = [habit.candidate.edits for habit in habits if edit in habit.candidate.edits]
    is_likely = any(sum(other.extra < _LIKELY and not other.guess for other in edits) > 1 for edits in alike)
    return one._replace(cost=one.cost + _ELSEWHERE, doubt=one.doubt + _ELSEWHERE) if is_likely else one


def _place(one: _Judged) -> object:
    """Returns what two suggestions of which only one is worth saying have in common: what is missing, or the frame."""
    edit = one.candidate.edits[0]
    return (edit.kind, edit.at) if edit.guess else one.candidate.frame


def _suspicious(code: CommandCode, costs: list[float]) -> Iterable[int]:
    """Returns the numbers of the operations in which edits are tried, the last first."""
    last = len(costs) - 1
    bad = [number for number, cost in enumerate(costs) if cost >= _SUSPICIOUS]
    if not bad:
        bad = [0, last]
    first = max(bad[0] - 3, 0)
    numbers = set(range(first, min(bad[-1], first + _MOST_OPERATIONS) + 1))
    if code.first and code.first[-1][1].is_fault:
        numbers |= set(range(max(last - 3, 0), last + 1))
    # An edit explains nothing that is before it.
    doubts = accumulate((one.cost - one.rarity for _, one in code.first), initial=0.0)
    explained = sum(1 for _ in takewhile((_MOST + _LESS_WITH_MEMORY).__ge__, doubts))
    return sorted((number for number in numbers if number < explained), reverse=True)


def _needed_memory(frame: bytes, dialect: str) -> Memory | None:
    """Returns the memory that the operations of a frame use; None if they cannot be read, or use more than there is."""
    message = read_last(frame, dialect)
    if not isinstance(message, DirectCommand) or message.fault is not None:
        return None
    used = memory_of(message.operations)
    return used if used.excess is None else None


def _with_memory(frame: bytes, dialect: str, *, keeps_locals: bool = True) -> bytes:
    """Returns a frame that requests the memory that its operations use, or more where it did and may."""
    found = _needed_memory(frame, dialect)
    if found is None:
        return frame
    asked = read_memory(frame)
    shared = max(found.globals, asked[0]) if asked[0] <= MOST_IN_REPLY else found.globals
    word = write_memory(shared, max(found.locals, asked[1] if keeps_locals else 0))
    return frame[:HEADER_SIZE] + word + frame[COMMAND_HEADER_SIZE:]


def _suggestion(judged: _Judged, *, is_clear: bool) -> Suggestion:
    edits, frame = judged.candidate.edits, judged.candidate.frame
    first = edits[0]
    unknown: list[tuple[int, int]] = []
    moved = 0
    for edit in edits:
        if edit.guess:
            unknown.append((edit.at + moved, edit.guess))
        moved += len(edit.new) - edit.end + edit.at
    message = SLIPS[first.kind].sentence.format(*first.words)
    if len(edits) > 1:
        more = f"the same in {counted(len(edits) - 1, 'more place')}"
        message += "; so is {} of {}".format(*edits[1].words) if unknown else f"; {more}"
    is_sure = is_clear and not unknown and judged.doubt <= SURE and first.kind not in CHOICES
    return Suggestion(first.kind, first.at, first.end - first.at, message, frame, tuple(unknown), is_sure)

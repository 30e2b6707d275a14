"""Frames fixed where only one fix is possible: the length field, memory sizes, the type, encodings.

What a program computes is left alone: no constant gets another value, no variable or operation another place. Whatever
cannot be fixed with certainty is said, and stays.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import Flag, auto
from itertools import chain

from ev3proto.checking.checking import check, swapped
from ev3proto.checking.context import operation_facts
from ev3proto.checking.report import Change, Fix, Report, uses
from ev3proto.checking.rules.arguments import is_longer, shortest
from ev3proto.checking.rules.header import MOST_IN_REPLY, TYPE_OFFSET
from ev3proto.errors import as_bytes, counted
from ev3proto.messages import Argument, DirectCommand, Message, Operation, Variable
from ev3proto.schema.argument import SHORT
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, may_be_long, with_length, write_memory
from ev3proto.semantics.footprint import Footprint, Taken, footprints
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MAX_FRAME, MAX_LOCALS, MAX_LONG_FRAME, MessageType

_MOST_NAMED = 3
"""Changes that are named where they are not made."""


def fix(
    frame: bytes | bytearray | memoryview | Message, *, dialect: str = "official", carrier: str | None = None
) -> Fix:
    """The frame with everything fixed that can be fixed with certainty. Never raises for what is in a frame.

    Args:
        frame: From its length field to its last byte; or a message, whose frame is fixed.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set to read by.
        carrier: "usb", "bluetooth" or "wifi": what is to carry it; None where that does not matter.

    Returns:
        The frame, what was fixed in it, what was not and why, and what a check says of it.

    Raises:
        ValueError: The dialect or the carrier is unknown.
    """
    given = frame.build() if isinstance(frame, Message) else as_bytes(frame, "a frame")
    report = check(given, dialect=dialect, carrier=carrier)
    changes: list[Change] = []
    unswapped = swapped(report)
    if unswapped is not None:
        before, after = (data[HEADER_SIZE:COMMAND_HEADER_SIZE].hex(":").upper() for data in (given, unswapped))
        changes.append(Change("memory", before, after, "the low byte of the two is first"))
        report = check(unswapped, dialect=dialect, carrier=carrier)
    while report.findings:
        tried = _Fixing(report.frame, dialect, _ALL)
        better = _better(report, tried)
        if better is None:
            return Fix(report.frame, tuple(changes), tuple(tried.unfixed + _not_made(tried.changes)), report)
        fixing, report = better
        changes += fixing.changes
        if fixing is tried:
            return Fix(report.frame, tuple(changes), tuple(fixing.unfixed), report)
        # Steps that made it worse may be what it needs now.
    return Fix(report.frame, tuple(changes), (), report)


uses.fix = fix


class _Step(Flag):
    """What is fixed together, because one without the other may make a frame worse."""

    LENGTH = auto()
    TYPE = auto()
    MEMORY = auto()
    ENCODINGS = auto()


_ALL = ~_Step(0)
_FEWER = sorted((_Step(bits) for bits in range(1, _ALL.value)), key=len, reverse=True)


def _better(report: Report, tried: _Fixing) -> tuple[_Fixing, Report] | None:
    """The first fix, with as many steps as possible, that makes a frame better, and what a check says then.

    That is: the brick accepts it, with fewer findings and no more errors.
    """
    if not tried.changes:
        return None
    fewer = (steps for steps in _FEWER if steps in tried.made and steps != tried.made)
    seen = {report.frame}
    for fixing in chain((tried,), (_Fixing(report.frame, report.dialect, steps) for steps in fewer)):
        if fixing.frame not in seen:
            seen.add(fixing.frame)
            after = check(fixing.frame, dialect=report.dialect, carrier=report.carrier)
            is_better = len(after.findings) < len(report.findings) and len(after.errors) <= len(report.errors)
            if after.accepted and is_better:
                return fixing, after
    return None


def _not_made(changes: Sequence[Change]) -> list[str]:
    """Why changes that could be made are not, as at most one sentence."""
    if not changes:
        return []
    named = ", ".join(change.what for change in changes[:_MOST_NAMED])
    more = f" and {len(changes) - _MOST_NAMED} more" if len(changes) > _MOST_NAMED else ""
    return [f"{named}{more}: another value would not leave a frame that the brick accepts with fewer findings"]


class _Fixing:
    """One frame on its way from what was given to what is meant.

    frame    what it is now
    changes  what was fixed
    unfixed  what was not and why, in sentences
    made     the steps that changed anything
    """

    def __init__(self, frame: bytes, dialect: str, steps: _Step) -> None:
        self.frame = frame
        self.changes: list[Change] = []
        self.unfixed: list[str] = []
        self.made = _Step(0)
        self._dialect = dialect
        self._step = _Step(0)
        self._places: dict[str, list[Footprint]] = {GLOBAL: [], LOCAL: []}
        self._run(steps)

    def _run(self, steps: _Step) -> None:
        """Every step in turn, each on what the one before made."""
        if self._begins(_Step.LENGTH, steps):
            self._length_field()
        message = self._parsed(self.frame)
        if not isinstance(message, DirectCommand):
            return
        if message.fault is not None:
            if not self.unfixed:
                at = message.fault.offset
                self.unfixed.append(f"cannot parse past offset {at}; the rest is left unchanged")
            return
        for operation in message.operations:
            for place in footprints(operation):
                self._places[place.argument.form.kind].append(place)
        self._tell_misaligned()
        if self._begins(_Step.TYPE, steps):
            message = self._reply_type(message)
        if self._begins(_Step.MEMORY, steps):
            self._memory(message)
        if self._begins(_Step.ENCODINGS, steps):
            # Only now is it read again, once for all that was done; a check reads the same.
            message = self._parsed(self.frame)
            assert isinstance(message, DirectCommand)
            self._shorten(message)

    def _begins(self, step: _Step, steps: _Step) -> bool:
        self._step = step
        return step in steps

    def _parsed(self, frame: bytes) -> Message:
        return read_last(frame, self._dialect)

    def _length_field(self) -> None:
        size = len(self.frame) - LENGTH_FIELD
        most = MAX_LONG_FRAME if may_be_long(self.frame) else MAX_FRAME
        if not HEADER_SIZE <= len(self.frame) <= most or frame_size(self.frame) == len(self.frame):
            return
        stated = frame_size(self.frame) - LENGTH_FIELD
        fixed = with_length(self.frame[LENGTH_FIELD:])
        whole = self._parsed(fixed)
        what = f"the length field says {stated}, and {size} bytes follow it"
        if whole.type is None or not whole.type.is_command or whole.fault is not None:
            self.unfixed.append(f"{what}; they cannot be read to their end either, so either may be wrong")
        elif self._is_padded(stated):
            self.unfixed.append(f"{what}, zeros at the end: they look like padding of a USB report")
        else:
            self.frame = fixed
            self._changed("length field", str(stated), str(size), "the bytes that follow it, which read to their end")

    def _is_padded(self, stated: int) -> bool:
        """Whether the frame is whole as far as its length field says, and zeros follow."""
        end = stated + LENGTH_FIELD
        return not any(self.frame[end:]) and self._parsed(self.frame[:end]).fault is None

    def _changed(self, what: str, before: str, after: str, why: str) -> None:
        self.changes.append(Change(what, before, after, why))
        self.made |= self._step

    def _tell_misaligned(self) -> None:
        """Which variables need another place; where there is a free one, only their author knows."""
        needed: dict[Variable, tuple[int, str]] = {}
        for place in chain.from_iterable(self._places.values()):
            many = max(place.validator_alignment, place.cpu_alignment)
            if place.start % many and many > needed.get(place.variable, (0, ""))[0]:
                needed[place.variable] = many, place.full_name
        self.unfixed += [
            f"{variable} is not a multiple of {many}, as {name} needs it: give it another place"
            for variable, (many, name) in needed.items()
        ]

    def _reply_type(self, command: DirectCommand) -> DirectCommand:
        if command.type is not MessageType.DIRECT_COMMAND_NO_REPLY:
            return command
        found = self._places[GLOBAL]
        read = Taken((place.start, place.end) for place in found if place.is_read)
        for place in found:
            if not place.is_written or place.end > MOST_IN_REPLY or read.has_some_of(place.start, place.end):
                continue
            member = MessageType.DIRECT_COMMAND_REPLY
            self._set(TYPE_OFFSET, bytes((member,)))
            why = f"{place.operation.full_name} writes {place.variable}, which only a reply brings"
            self._changed("type", command.type.name, member.name, why)
            return replace(command, type=member)
        return command

    def _memory(self, command: DirectCommand) -> None:
        """Asks for the memory that is needed."""
        sizes = {GLOBAL: command.global_size, LOCAL: command.local_size}
        for scope, stated in sizes.items():
            most = _most(command, scope)
            beyond = [place for place in self._places[scope] if place.start + place.size > stated]
            if not beyond:
                self._cut(command, scope, sizes)
                continue
            certain = {place.start + place.most: place for place in reversed(beyond) if place.most is not None}
            ends = [end for end in certain if end <= most]
            if ends:
                sizes[scope] = end = max(ends)
                why = f"{certain[end].full_name} takes them up to there"
                self._changed(f"{scope} memory", f"{stated} bytes", f"{end} bytes", why)
            self.unfixed += dict.fromkeys(
                f"{place.full_name} would need {place.end} bytes of {scope} memory, and there are {most} at most"
                if place.end > most
                else f"it is not known how many bytes of {scope} memory {place.full_name} takes, so none were added"
                " for it"
                for place in beyond
                if place.start + place.size > sizes[scope]
            )
        self._set(HEADER_SIZE, write_memory(sizes[GLOBAL], sizes[LOCAL]))

    def _cut(self, command: DirectCommand, scope: str, sizes: dict[str, int]) -> None:
        """Asks for less where more was asked for than there is."""
        stated, most, needed = sizes[scope], _most(command, scope), _used(self._places[scope])
        if stated > most and all(place.end <= most for place in self._places[scope]):
            sizes[scope] = most if needed is None else min(needed, most)
            why = "the most that there is" if sizes[scope] == most else "no more of them are used"
            self._changed(f"{scope} memory", f"{stated} bytes", f"{sizes[scope]} bytes", why)

    def _shorten(self, command: DirectCommand) -> None:
        longer = [
            (operation, argument)
            for operation in command.operations
            for argument in _in_long_forms(operation)
            if is_longer(argument)
        ]
        if not longer:
            return
        keeps_size = _spanned(command, len(self.frame))
        pieces: list[tuple[Argument, bytes]] = []
        for operation, argument in longer:
            if keeps_size[argument.offset]:
                continue
            shorter = shortest(argument)
            saved = argument.length - len(shorter)
            pieces.append((argument, shorter))
            what = f"{argument.name} of {operation.full_name} at offset {argument.offset}"
            before, after = argument.raw.hex(":").upper(), shorter.hex(":").upper()
            self._changed(what, before, after, f"the same in {counted(saved, 'byte')} less")
        spanned = len(longer) - len(pieces)
        if spanned:
            are = "longer encodings stay" if spanned > 1 else "longer encoding stays"
            self.unfixed.append(f"{spanned} {are}: a jump counts {'their' if spanned > 1 else 'its'} bytes")
        if pieces:
            self.frame = _replaced(self.frame, pieces)

    def _set(self, offset: int, data: bytes) -> None:
        self.frame = self.frame[:offset] + data + self.frame[offset + len(data) :]


def _most(command: DirectCommand, scope: str) -> int:
    """Bytes of a memory that a command can ask for."""
    if scope == LOCAL:
        return MAX_LOCALS
    return MOST_IN_REPLY if command.wants_reply else GRANTED_GLOBALS


def _used(places: Iterable[Footprint]) -> int | None:
    """Bytes of a memory up to the last one that is used, None where that is not known."""
    needed = 0
    for place in places:
        if place.most is None:
            return None
        needed = max(needed, place.start + place.most)
    return needed


def _in_long_forms(operation: Operation) -> list[Argument]:
    """CMD and the arguments, those that are a single byte left out."""
    _, data, start, end, *_ = operation
    found = [argument for argument in operation.arguments if argument[1].width]
    if end - start > 1 and data[start + 1] >= len(SHORT):
        cmd = operation.cmd
        return found if cmd is None else [cmd, *found]
    return found


def _spanned(command: DirectCommand, size: int) -> bytearray:
    """For each byte of the frame, whether it lies between a jump and where that goes: its length must stay."""
    spanned = bytearray(size)
    for operation in command.operations:
        if not operation_facts(operation[0]).is_jump:
            continue
        jump = operation.arguments[-1]
        if jump.kind not in (CONSTANT, JUMP):
            return bytearray(b"\1" * size)
        end = operation.offset + operation.length
        target = min(max(end + int(jump.value), 0), size)
        first, last = min(target, end), max(target, end)
        spanned[first:last] = b"\1" * (last - first)
    return spanned


def _replaced(frame: bytes, pieces: Iterable[tuple[Argument, bytes]]) -> bytes:
    """The frame with other bytes for some arguments, and the length field that this gives."""
    done, at = [], LENGTH_FIELD
    for argument, new in sorted(pieces, key=_by_offset):
        offset = argument.offset
        done += [frame[at:offset], new]
        at = offset + argument.length
    return with_length(b"".join((*done, frame[at:])))


def _by_offset(piece: tuple[Argument, bytes]) -> int:
    return piece[0].offset

"""Fixes of frames that have only one possible fix: the length field, memory sizes, the type, encodings.

The meaning of a program is kept: no constant changes its value, no variable or operation its place. A problem without
a certain fix is reported and kept.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import Flag, auto
from itertools import chain

from ev3proto.checking.checking import check, swapped
from ev3proto.checking.codes import RAW_BYTE
from ev3proto.checking.report import Change, Fix, Report
from ev3proto.checking.rules.arguments import longer_arguments, shortest
from ev3proto.checking.rules.header import MOST_IN_REPLY, TYPE_OFFSET, is_plausible
from ev3proto.errors import as_bytes, counted
from ev3proto.messages import Argument, DirectCommand, Message, Variable
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, may_be_long, with_length, write_memory
from ev3proto.semantics.facts import operation_facts
from ev3proto.semantics.footprint import Footprint, footprints, needed, unread
from ev3proto.semantics.mangled import unmangled
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MAX_FRAME, MAX_LOCALS, MAX_LONG_FRAME, MessageType

_MOST_NAMED = 3
"""Maximum number of changes named when they are not made."""


def fix(
    frame: bytes | bytearray | memoryview | Message,
    *,
    dialect: str = "official",
    carrier: str | None = None,
    shorten: bool = True,
) -> Fix:
    """Fixes everything in a frame that can be fixed with certainty. No content of a frame makes it raise.

    Args:
        frame: The bytes from the length field to the last one; or a message, whose frame is fixed.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set is used.
        carrier: "usb", "bluetooth" or "wifi": the carrier of the frame; None if it does not matter.
        shorten: Whether to shorten encodings that are longer than needed; without it, the frame keeps its size.

    Returns:
        The frame, what was fixed, what was not and why, and the report of a check of the result.

    Raises:
        ValueError: The dialect or the carrier is unknown.
    """
    given = frame.build() if isinstance(frame, Message) else as_bytes(frame, "a frame")
    report = check(given, dialect=dialect, carrier=carrier)
    changes: list[Change] = []
    undone = unmangled(given)
    if undone is not None and (after := check(undone[0], dialect=dialect, carrier=carrier)).accepted:
        before, cause = f"{len(given)} bytes", undone[1]
        changes.append(Change("frame", before, f"{len(undone[0])} bytes", f"a text had changed it: {cause}"))
        given, report = undone[0], after
    unswapped = swapped(report)
    if unswapped is not None:
        old, new = (data[HEADER_SIZE:COMMAND_HEADER_SIZE].hex(":").upper() for data in (given, unswapped))
        changes.append(Change("memory", old, new, "the low byte comes first"))
        report = check(unswapped, dialect=dialect, carrier=carrier)
    steps = _ALL if shorten else _ALL & ~_Step.ENCODINGS
    while report.findings:
        tried = _Fixing(report, steps)
        better = _better(report, tried)
        if better is None:
            return Fix(report.frame, tuple(changes), tuple(tried.unfixed + _not_made(tried.changes)), report)
        fixing, report = better
        changes += fixing.changes
        if fixing is tried:
            return Fix(report.frame, tuple(changes), tuple(fixing.unfixed), report)
        # Steps that made it worse before may help now.
    return Fix(report.frame, tuple(changes), (), report)


class _Step(Flag):
    """Steps of a fix; some help only together."""

    LENGTH = auto()
    TYPE = auto()
    MEMORY = auto()
    ENCODINGS = auto()


_ALL = ~_Step(0)
_FEWER = sorted((_Step(bits) for bits in range(1, _ALL.value)), key=len, reverse=True)


def _better(report: Report, tried: _Fixing) -> tuple[_Fixing, Report] | None:
    """Returns the fix with the most steps whose result is accepted with fewer findings and no more errors, if any."""
    if not tried.changes:
        return None
    fewer = (steps for steps in _FEWER if steps in tried.made and steps != tried.made)
    seen = {report.frame}
    for fixing in chain((tried,), (_Fixing(report, steps) for steps in fewer)):
        if fixing.frame not in seen:
            seen.add(fixing.frame)
            after = check(fixing.frame, dialect=report.dialect, carrier=report.carrier)
            is_better = len(after.findings) < len(report.findings) and len(after.errors) <= len(report.errors)
            if after.accepted and is_better:
                return fixing, after
    return None


def _not_made(changes: Sequence[Change]) -> list[str]:
    """Returns why possible changes were not made, in at most one sentence."""
    if not changes:
        return []
    named = ", ".join(change.what for change in changes[:_MOST_NAMED])
    more = f" and {len(changes) - _MOST_NAMED} more" if len(changes) > _MOST_NAMED else ""
    return [f"{named}{more}: changing it would not give a frame that the brick accepts with fewer findings"]


class _Fixing:
    """The state of a frame while it is fixed."""

    def __init__(self, report: Report, steps: _Step) -> None:
        self.frame = report.frame  # its current bytes
        self.changes: list[Change] = []  # the changes made
        self.unfixed: list[str] = []  # what was not fixed and why, in sentences
        self.made = _Step(0)  # the steps that changed something
        self._dialect = report.dialect
        self._raw = {finding.offset: finding for finding in report.findings if finding.code == RAW_BYTE.code}
        self._step = _Step(0)
        self._places: dict[str, list[Footprint]] = {GLOBAL: [], LOCAL: []}
        self._run(steps)

    def _run(self, steps: _Step) -> None:
        """Runs the steps in order, each on the result of the one before."""
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
        self._tell_raw()
        if self._begins(_Step.TYPE, steps):
            message = self._reply_type(message)
        if self._begins(_Step.MEMORY, steps):
            self._memory(message)
        if self._begins(_Step.ENCODINGS, steps):
            # Parsed again only once, after all steps; a check shares the result.
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
        what = f"the length field says {stated}, but {size} bytes follow it"
        if not is_plausible(whole):
            self.unfixed.append(f"{what}; they cannot be parsed to the end, so either may be wrong")
        elif self._is_padded(stated):
            self.unfixed.append(f"{what}, with zeros at the end that look like padding of a USB report")
        else:
            self.frame = fixed
            self._changed("length field", str(stated), str(size), "the number of bytes that follow it")

    def _is_padded(self, stated: int) -> bool:
        """Returns whether the frame is complete by its length field, with zeros after it."""
        end = stated + LENGTH_FIELD
        return not any(self.frame[end:]) and self._parsed(self.frame[:end]).fault is None

    def _changed(self, what: str, before: str, after: str, why: str) -> None:
        self.changes.append(Change(what, before, after, why))
        self.made |= self._step

    def _tell_misaligned(self) -> None:
        """Reports variables that need another place; only the author knows a free one."""
        needed: dict[Variable, tuple[int, str]] = {}
        for place in chain.from_iterable(self._places.values()):
            many = max(place.facts.validator_alignment, place.facts.cpu_alignment)
            if place.start % many and many > needed.get(place.variable, (0, ""))[0]:
                needed[place.variable] = many, place.full_name
        self.unfixed += [
            f"{variable} is not at a multiple of {many}, as {name} requires; move it"
            for variable, (many, name) in needed.items()
        ]

    def _tell_raw(self) -> None:
        """Reports bytes that may be a number or a variable; only the author knows what was meant."""
        self.unfixed += [
            f"{finding.parameter} of {finding.operation} at offset {at}: {finding.help}"
            for at, finding in self._raw.items()
        ]

    def _reply_type(self, command: DirectCommand) -> DirectCommand:
        if command.type is not MessageType.DIRECT_COMMAND_NO_REPLY:
            return command
        place = next((place for place in unread(self._places[GLOBAL]) if place.end <= MOST_IN_REPLY), None)
        if place is None:
            return command
        member = MessageType.DIRECT_COMMAND_REPLY
        self._set(TYPE_OFFSET, bytes((member,)))
        why = f"{place.operation.full_name} writes {place.variable}, which only a reply carries"
        self._changed("type", command.type.name, member.name, why)
        return replace(command, type=member)

    def _memory(self, command: DirectCommand) -> None:
        """Sets the memory sizes to what is needed."""
        sizes = {GLOBAL: command.global_size, LOCAL: command.local_size}
        for scope, stated in sizes.items():
            most = _most(command, scope)
            beyond = [place for place in self._places[scope] if place.start + place.size > stated]
            if any(place.argument.offset in self._raw for place in beyond):
                # More memory would hide the mistake.
                continue
            if not beyond:
                self._cut(command, scope, sizes)
                continue
            certain = {place.start + place.most: place for place in reversed(beyond) if place.most is not None}
            ends = [end for end in certain if end <= most]
            if ends:
                sizes[scope] = end = max(ends)
                why = f"{certain[end].full_name} uses them up to there"
                self._changed(f"{scope} memory", f"{stated} bytes", f"{end} bytes", why)
            self.unfixed += dict.fromkeys(
                f"{place.full_name} would need {place.end} bytes of {scope} memory; the maximum is {most}"
                if place.end > most
                else f"{place.full_name} takes an unknown number of bytes of {scope} memory, so none were added for it"
                for place in beyond
                if place.start + place.size > sizes[scope]
            )
        self._set(HEADER_SIZE, write_memory(sizes[GLOBAL], sizes[LOCAL]))

    def _cut(self, command: DirectCommand, scope: str, sizes: dict[str, int]) -> None:
        """Lowers a memory size that is above the maximum."""
        stated, most, used = sizes[scope], _most(command, scope), needed(self._places[scope])
        if stated > most and all(place.end <= most for place in self._places[scope]):
            sizes[scope] = most if used is None else min(used, most)
            why = "the maximum" if sizes[scope] == most else "the rest is unused"
            self._changed(f"{scope} memory", f"{stated} bytes", f"{sizes[scope]} bytes", why)

    def _shorten(self, command: DirectCommand) -> None:
        longer = [(operation, argument) for operation in command.operations for argument in longer_arguments(operation)]
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
            self._changed(what, before, after, f"the same value in {counted(saved, 'byte')} less")
        spanned = len(longer) - len(pieces)
        if spanned:
            are = "longer encodings are kept" if spanned > 1 else "longer encoding is kept"
            self.unfixed.append(f"{spanned} {are}: a jump counts {'their' if spanned > 1 else 'its'} bytes")
        if pieces:
            self.frame = _replaced(self.frame, pieces)

    def _set(self, offset: int, data: bytes) -> None:
        self.frame = self.frame[:offset] + data + self.frame[offset + len(data) :]


def _most(command: DirectCommand, scope: str) -> int:
    """Returns the maximum size of a memory, in bytes."""
    if scope == LOCAL:
        return MAX_LOCALS
    return MOST_IN_REPLY if command.wants_reply else GRANTED_GLOBALS


def _spanned(command: DirectCommand, size: int) -> bytearray:
    """Returns 1 for each byte of the frame between a jump and its target, where no encoding may be shortened."""
    spanned = bytearray(size)
    for operation in command.operations:
        if not operation_facts(operation.schema).is_jump:
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
    """Returns the frame with new bytes for some arguments, and an updated length field."""
    done, at = [], LENGTH_FIELD
    for argument, new in sorted(pieces, key=_by_offset):
        offset = argument.offset
        done += [frame[at:offset], new]
        at = offset + argument.length
    return with_length(b"".join((*done, frame[at:])))


def _by_offset(piece: tuple[Argument, bytes]) -> int:
    return piece[0].offset

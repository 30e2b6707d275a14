"""Variables: beyond the memory that the header asks for, misaligned, overlapping, or without anybody to read them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from ev3proto.checking import codes
from ev3proto.checking.places import Place, places_of
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.header import MOST_IN_REPLY, TYPE_OFFSET, plural
from ev3proto.checking.subject import Subject
from ev3proto.messages import DirectCommand
from ev3proto.schema.frame import HEADER_SIZE, MEMORY_SIZE
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS, MessageType

_LARGEST = 4
"""Bytes of the largest value, to whose multiples people round sizes up."""


def check_memory(subject: Subject, command: DirectCommand) -> Iterator[Finding]:
    """All variables of a command."""
    steps = subject.steps
    places = places_of(steps)
    sizes = (command.local_size, command.global_size)
    for place in places:
        if place.start % place.noticed or place.start % place.wanted:
            yield _misaligned(place)
        if place.end > sizes[place.is_global]:
            yield _beyond(place, sizes[place.is_global])
    if not subject.is_whole:
        # Of what is not read nobody knows which memory it uses.
        return
    if len(places) > 1 and not any(step.traits.is_jump for step in steps):
        # With jumps nobody knows what comes first.
        yield from _overlaps([place for place in places if not place.is_global], is_kept=False)
        yield from _overlaps([place for place in places if place.is_global], is_kept=command.wants_reply)
    yield from _asked_for(command, places)


def _name(place: Place) -> str:
    return f"{'G' if place.is_global else 'L'}V({place.start})"


def _misaligned(place: Place) -> Finding:
    argument = place.argument
    noticed, wanted = place.noticed, place.wanted
    code, multiple, aside = (
        (codes.MISALIGNED, noticed, "")
        if place.start % noticed
        else (codes.UNALIGNED, wanted, ", though the firmware does not look at it here")
    )
    better = place.start + -place.start % multiple
    return place.step.finding_at(
        code,
        argument,
        f"{argument.name} is {_name(place)}, and has to start at a multiple of {multiple}{aside}",
        f"use {'G' if place.is_global else 'L'}V({better}), or another multiple of {multiple}",
    )


def _beyond(place: Place, asked: int) -> Finding:
    """A variable that lies beyond its memory, in whole or in part."""
    scope, most = ("global", MOST_IN_REPLY) if place.is_global else ("local", MAX_LOCALS)
    last = place.end - 1
    bytes_taken = f"byte {last}" if place.start == last else f"bytes {place.start} to {last}"
    has = f"{plural(asked, 'byte')} of" if asked else "no"
    if place.end > most:
        mend = f"use a lower index; there are {plural(most, 'byte')} of {scope} memory at most"
    else:
        mend = f"ask for {plural(place.end, 'byte')} of {scope} memory, or use a lower index"
    return place.step.finding_at(
        codes.BEYOND_GLOBALS if place.is_global else codes.BEYOND_LOCALS,
        place.argument,
        f"{place.argument.name} takes {bytes_taken} of {scope} memory, and the header asks for {has} {scope} memory",
        mend,
    )


def _overlaps(places: list[Place], *, is_kept: bool) -> Iterator[Finding]:
    """Results that destroy one another, in one memory.

    is_kept  whether a reply brings what is in that memory in the end
    """
    if sum(place.is_written for place in places) < 2:
        return
    results: dict[int, Place] = {}
    for _, found in groupby(places, key=lambda place: place.step.start):
        together = list(found)
        for place in together:
            if place.is_read:
                end = MAX_FRAME if place.is_open else place.end
                for byte in range(place.start, min(end, MAX_FRAME)):
                    results.pop(byte, None)
        for place in together:
            if not place.is_written:
                continue
            taken = range(place.start, min(place.end, MAX_FRAME))
            before = next((results[byte] for byte in taken if byte in results), None)
            if before is not None:
                yield from _destroyed(before, place, is_kept)
            results.update(dict.fromkeys(taken, place))


def _destroyed(before: Place, place: Place, is_kept: bool) -> Iterator[Finding]:
    """A result where another one was that nobody has read."""
    other = f"{before.argument.name} of {before.step.name}"
    is_same = before.start == place.start and (before.end == place.end or before.is_open or place.is_open)
    if is_same:
        if is_kept:
            yield place.step.finding_at(
                codes.OVERWRITTEN,
                place.argument,
                f"{place.argument.name} is stored in {_name(place)}, where {other} was: the reply brings only the last",
                "store them in different places",
            )
        return
    if (before.is_array or place.is_array) and (_is_within(before, place) or _is_within(place, before)):
        # An array is often filled element by element.
        return
    yield place.step.finding_at(
        codes.OVERLAP,
        place.argument,
        f"{place.argument.name} takes bytes {place.start} to {place.end - 1}, and {other} takes {before.start} to"
        f" {before.end - 1}: the later one destroys the other",
        "store them in places that have no byte in common",
    )


def _is_within(inner: Place, outer: Place) -> bool:
    return inner.start >= outer.start and (outer.is_open or inner.end <= outer.end)


def _asked_for(command: DirectCommand, places: list[Place]) -> Iterator[Finding]:
    """Memory in the header that nobody uses, and results that nobody gets."""
    local = [place for place in places if not place.is_global]
    shared = [place for place in places if place.is_global]
    yield from _unused("local", command.local_size, local)
    if command.wants_reply:
        yield from _unused("global", command.global_size, shared)
        return
    lost = _unread(shared)
    if lost is not None:
        yield codes.NO_REPLY.finding(
            TYPE_OFFSET,
            1,
            f"{lost.step.name} stores {lost.argument.name} in {_name(lost)}, which only a reply brings, and the type"
            " says that none is wanted",
            f"give the type 0x{MessageType.DIRECT_COMMAND_REPLY:02X}, or store it in local memory",
        )
    elif command.global_size and not shared:
        yield codes.UNWANTED_GLOBALS.finding(
            HEADER_SIZE,
            MEMORY_SIZE,
            f"the header asks for {plural(command.global_size, 'byte')} of global memory, which no operation uses and"
            " no reply brings",
            f"ask for none, or give the type 0x{MessageType.DIRECT_COMMAND_REPLY:02X}",
        )


def _unread(places: list[Place]) -> Place | None:
    """The first result that no operation reads."""
    read = [place for place in places if place.is_read]
    for place in places:
        if place.is_written and not any(_have_common(place, other) for other in read):
            return place
    return None


def _have_common(place: Place, other: Place) -> bool:
    return place.start < other.end and other.start < place.end


def _unused(scope: str, asked: int, places: list[Place]) -> Iterator[Finding]:
    if not asked or asked > MOST_IN_REPLY or any(place.is_open for place in places):
        return
    used = max((place.end for place in places), default=0)
    left = asked - used
    if left <= 0 or (left < _LARGEST and used and asked % _LARGEST == 0):
        return
    told = f"{used} of them are" if used else "none of them is"
    yield codes.UNUSED_MEMORY.finding(
        HEADER_SIZE,
        MEMORY_SIZE,
        f"the header asks for {plural(asked, 'byte')} of {scope} memory, and {told} used",
        f"ask for {used}",
    )

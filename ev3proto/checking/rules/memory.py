"""Rules on variables: beyond the requested memory, misaligned, overlapping, or never read."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand, Variable
from ev3proto.schema.header import HEADER_SIZE, MEMORY_SIZE, MOST_IN_REPLY, TYPE_AT
from ev3proto.semantics.footprint import MEMORY_LIMITS, Footprint, Taken, needed, unread
from ev3proto.semantics.judgement import judge
from ev3proto.tables.declaration import Effect
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL
from ev3proto.tables.frame import MAX_FRAME

_LARGEST = 4
"""Bytes of the largest value; requested sizes are often rounded up to its multiples."""


Use = tuple[CheckedOperation, Footprint]
"""A variable: its operation, the bytes that it takes."""


def check_memory(
    context: CheckContext, command: DirectCommand, local: list[Use], shared: list[Use]
) -> Iterator[Finding]:
    """Checks all variables of a command, in local and in global memory."""
    for used, asked, is_kept in (
        (local, command.local_size, False),
        (shared, command.global_size, command.wants_reply),
    ):
        if used:
            yield from _places(used, asked)
            if context.is_whole and not context.has_jumps:
                # With jumps the order is unknown.
                yield from _overlaps(used, is_kept=is_kept)
    if not context.is_whole:
        # The memory use of unreadable operations is unknown.
        return
    if local:
        yield from _unwritten(local, command.local_size)
    yield from _asked_for(command, local, shared)


def _unwritten(used: list[Use], asked: int) -> Iterator[Finding]:
    """Yields findings about local variables that no operation writes, where 0 or an empty text is not legal."""
    written = Taken((place.start, _furthest(place)) for _, place in used if place.facts.is_written)
    for operation, place in used:
        parameter = place.argument.parameter
        domain = place.facts.domain
        is_legal = parameter.most is None if domain is None else judge(place.facts, CONSTANT, 0) is None
        is_beyond = place.end > asked or not place.size
        if is_legal or is_beyond or place.facts.is_written or written.has_some_of(place.start, place.end):
            continue
        key, legal = ("text", "") if domain is None else ("", domain.choice)
        yield operation.finding_of(codes.UNWRITTEN, place.argument, key, variable=place.variable, legal=legal)


def _places(used: list[Use], asked: int) -> Iterator[Finding]:
    """Yields findings about variables that are misaligned or beyond the requested memory."""
    for operation, place in used:
        multiple = max(place.facts.validator_alignment, place.facts.cpu_alignment)
        if place.start % multiple:
            code, step = codes.UNALIGNED, multiple
            if place.start % place.facts.validator_alignment:
                code, step = codes.MISALIGNED, place.facts.validator_alignment
            yield operation.finding_of(code, place.argument, variable=place.variable, step=step, multiple=multiple)
        if place.end > asked:
            yield _beyond(operation, place, asked)


def _furthest(place: Footprint) -> int:
    return MAX_FRAME if place.most is None else place.start + place.most


def _beyond(operation: CheckedOperation, place: Footprint, asked: int) -> Finding:
    """Returns the finding about a variable beyond the requested memory."""
    start, end, scope = place.start, place.end, GLOBAL if place.is_global else LOCAL
    room, most = start + place.reserved, MEMORY_LIMITS[scope]
    parts = {
        "bytes": f"byte {start}" if start == end - 1 else f"bytes {start} to {end - 1}",
        "scope": scope,
        "asked": f"{counted(asked, 'byte')} of" if asked else "no",
        "room": counted(room, "byte") if room <= most else None,
        "limit": counted(most, "byte") if room > most else None,
    }
    code = codes.BEYOND_GLOBALS if place.is_global else codes.BEYOND_LOCALS
    return operation.finding_of(code, place.argument, **parts)


def _identity(use: Use) -> tuple[object, ...]:
    """Returns the key that variables with the same finding share."""
    operation, place = use
    return operation.name, place.number, place.argument.form, place.start, place.size, place.most


def _overlaps(used: list[Use], *, is_kept: bool) -> Iterator[Finding]:
    """Yields findings about results that overwrite each other; `is_kept`: a reply carries the final contents."""
    # The user of each byte, in slices: arrays may take a thousand bytes each.
    size = min(max(place.end for _, place in used), MAX_FRAME)
    results: list[tuple[tuple[object, ...], Use] | None] = [None] * size
    # The same mistake may occur a thousand times, so its finding is made once.
    said: dict[tuple[tuple[object, ...], ...], Finding | None] = {}
    for _, group in groupby(used, lambda use: use[0].start):
        together = list(group)
        for place in [place for _, place in together if place.facts.is_read]:
            start, end = place.start, min(_furthest(place), size)
            results[start:end] = [None] * (end - start)
        for use in [use for use in together if use[1].facts.is_written]:
            _, place = use
            start, end = place.start, min(place.end, size)
            key, before = _identity(use), next(filter(None, results[start:end]), None)
            if before is not None:
                both = before[0], key
                if both not in said:
                    said[both] = _destroyed(before[1], use, is_kept)
                finding = said[both]
                if finding is not None:
                    yield replace(finding, offset=place.argument.offset)
            results[start:end] = [(key, use)] * (end - start)


def _destroyed(before: Use, use: Use, is_kept: bool) -> Finding | None:
    """Returns the finding about a result that overwrites an unread one."""
    (_, first), (operation, place) = before, use
    parts: dict[str, object]
    if first.start == place.start and (first.size == place.size or not (first.is_exact and place.is_exact)):
        if not is_kept:
            return None
        parts = {"variable": place.variable, "first": first.full_name}
        return operation.finding_of(codes.OVERWRITTEN, place.argument, **parts)
    if (first.is_array or place.is_array) and (_is_within(first, place) or _is_within(place, first)):
        # Arrays are often filled element by element.
        return None
    parts = {
        "bytes": f"bytes {place.start} to {place.end - 1}",
        "first": first.full_name,
        "others": f"{first.start} to {first.end - 1}",
    }
    return operation.finding_of(codes.OVERLAP, place.argument, **parts)


def _is_within(inner: Footprint, outer: Footprint) -> bool:
    is_before_end = outer.most is None or inner.end <= outer.start + outer.most
    return inner.start >= outer.start and is_before_end


def _asked_for(command: DirectCommand, local: list[Use], shared: list[Use]) -> Iterator[Finding]:
    """Yields findings about unused memory, and about results without a reply."""
    if command.local_size:
        yield from _unused("local", command.local_size, local)
    if command.wants_reply:
        hidden = [] if shared else list(_hidden(local))
        yield from hidden or _unused("global", command.global_size, shared)
        return
    lost = next(unread([place for _, place in shared]), None)
    if lost is not None:
        parts = {"storing": lost.operation.full_name, "result": lost.argument.name, "variable": lost.variable}
        yield codes.NO_REPLY.at(TYPE_AT, 1, **parts)
    elif command.global_size and not shared:
        yield codes.UNWANTED_GLOBALS.at(HEADER_SIZE, MEMORY_SIZE, asked=counted(command.global_size, "byte"))


def _hidden(local: list[Use]) -> Iterator[Finding]:
    """Yields findings about the results of readings in local memory that no operation reads."""
    unseen = {place.argument.offset for place in unread([place for _, place in local])}
    read = {place.operation.offset for _, place in local if place.argument.offset not in unseen}
    end = 0
    for operation, place in local:
        # A file that is opened, or an array, may be used by its number.
        is_reading = not operation.facts.has_handles and any(map(operation.has, (Effect.READS, Effect.COMPUTES)))
        if is_reading and operation.start not in read and place.argument.offset in unseen:
            start = end + -end % place.facts.alignment
            end = start + place.reserved
            parts = {
                "variable": place.variable,
                "other": Variable(GLOBAL, start),
                "bytes": counted(end, "byte"),
            }
            yield operation.finding_of(codes.RESULT_IN_LOCAL, place.argument, **parts)


def _unused(scope: str, asked: int, used: list[Use]) -> Iterator[Finding]:
    if not asked or asked > MOST_IN_REPLY:
        return
    end = needed([place for _, place in used])
    if end is None or end >= asked or (asked - end < _LARGEST and asked % _LARGEST == 0):
        return
    key = "" if end else "none"
    yield codes.UNUSED_MEMORY.at(HEADER_SIZE, MEMORY_SIZE, key, asked=counted(asked, "byte"), scope=scope, end=end)

"""Variables: beyond the memory that the header asks for, misaligned, overlapping, or without anybody to read them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding, Severity
from ev3proto.checking.rules.header import MOST_IN_REPLY, TYPE_OFFSET, plural
from ev3proto.messages import Argument, DirectCommand, Variable
from ev3proto.schema.header import HEADER_SIZE, MEMORY_SIZE
from ev3proto.semantics.footprint import Footprint, MemoryFacts, Taken, footprint
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS, MessageType

_MOST_TEXTS = 4096
"""Variables whose texts are kept."""

_LARGEST = 4
"""Bytes of the largest value, to whose multiples people round sizes up."""


Use = tuple[int, int, int | None, MemoryFacts | Footprint, CheckedOperation, int]
"""A variable: its first byte, where it ends for sure, where at most (None where that is not known), what else is known
of it, its operation, the number of the argument."""


def check_memory(
    context: CheckContext, command: DirectCommand, local: list[Use], shared: list[Use]
) -> Iterator[Finding]:
    """All variables of a command: those in local memory, and those in global memory."""
    if local:
        yield from _places(local, command.local_size)
    if shared:
        yield from _places(shared, command.global_size)
    if not context.is_whole:
        # Of what is not read nobody knows which memory it uses.
        return
    if not context.has_jumps:
        # With jumps nobody knows what comes first.
        if len(local) > 1 and _have_results_in_common(local):
            yield from _overlaps(list(map(_footprint, local)), is_kept=False)
        if len(shared) > 1 and _have_results_in_common(shared):
            yield from _overlaps(list(map(_footprint, shared)), is_kept=command.wants_reply)
    yield from _asked_for(command, local, shared)


def _footprint(use: Use) -> Footprint:
    *_, operation, number = use
    return footprint(operation.parsed, number, operation.arguments)


class _Remark(NamedTuple):
    """What is said of a variable wherever it stands: a finding without its offset."""

    severity: Severity
    code: str
    length: int
    message: str
    help: str
    operation: str
    parameter: str

    def at(self, offset: int) -> Finding:
        severity, code, length, message, help_, operation, parameter = self
        return Finding(severity, code, offset, length, message, help_, operation, parameter)


def _remark(found: Footprint, code: codes.Code, message: str, help_: str) -> _Remark:
    argument = found.argument
    width = argument.form.width
    assert width is not None  # a variable is no text
    return _Remark(
        code.severity, code.code, 1 + width, message, help_, found.operation.full_name, argument.parameter.name
    )


def _places(used: list[Use], asked: int) -> Iterator[Finding]:
    """Variables that are misaligned, or beyond the bytes of memory that are asked for."""
    # One variable may be misaligned in a thousand places: what is said of it is made once.
    said: dict[tuple[object, ...], _Remark] = {}
    for use in used:
        start, end, _, known, operation, number = use
        if start % known.validator_alignment or start % known.cpu_alignment:
            found = _footprint(use)
            key = _identity(found)
            remark = said.get(key)
            if remark is None:
                remark = said[key] = _misaligned(found, asked)
            yield remark.at(found.argument.offset)
        if end > asked:
            yield _beyond(start, end, operation, operation.arguments[number], asked)


def _misaligned(found: Footprint, asked: int) -> _Remark:
    is_validated = found.start % found.validator_alignment != 0
    multiples = found.validator_alignment, found.cpu_alignment
    texts = _misaligned_texts(found.argument.name, found.is_global, found.start, found.size, multiples, asked)
    return _remark(found, codes.MISALIGNED if is_validated else codes.UNALIGNED, *texts)


# Senders use the same variables again and again: what is said of one is kept.
@lru_cache(_MOST_TEXTS)
def _misaligned_texts(
    name: str, is_global: bool, start: int, size: int, multiples: tuple[int, int], asked: int
) -> tuple[str, str]:
    """What is wrong with a misaligned variable, and what to do.

    multiples  what the validator and the processor want its index to be a multiple of
    """
    for_validator, for_cpu = multiples
    is_validated = start % for_validator != 0
    multiple = for_validator if is_validated else for_cpu
    aside = "" if is_validated else ", though the firmware does not look at it here"
    message = f"{name} is {_variable(is_global, start)}, and must start at a multiple of {multiple}{aside}"
    return message, _aligned(is_global, start, size, max(multiples), asked)


def _aligned(is_global: bool, start: int, size: int, multiple: int, asked: int) -> str:
    """Where a misaligned variable could start: upwards, if its memory has room there, or else below."""
    scope, most = _memory(is_global)
    asked = min(asked, most)
    start += -start % multiple
    if start + size > asked and asked >= size and start + size > most:
        start = (asked - size) // multiple * multiple
    elif start + size > most:
        start = 0
    better = f"use {_variable(is_global, start)}"
    end = start + size
    if end > most:
        return f"use a multiple of {multiple}"
    if end > asked:
        return f"{better}, and ask for {plural(end, 'byte')} of {scope} memory"
    return f"{better}, or another multiple of {multiple}"


def _variable(is_global: bool, index: int) -> Variable:
    return Variable(GLOBAL if is_global else LOCAL, index)


def _memory(is_global: bool) -> tuple[str, int]:
    """The name of a memory, and how many bytes of it there are at most."""
    return ("global", MOST_IN_REPLY) if is_global else ("local", MAX_LOCALS)


def _beyond(start: int, end: int, operation: CheckedOperation, argument: Argument, asked: int) -> Finding:
    """A variable that lies beyond its memory, in whole or in part."""
    is_global = argument.form.kind == GLOBAL
    texts = _beyond_texts(argument.parameter.name, is_global, start, end, asked)
    return operation.finding_at(codes.BEYOND_GLOBALS if is_global else codes.BEYOND_LOCALS, argument, *texts)


@lru_cache(_MOST_TEXTS)
def _beyond_texts(name: str, is_global: bool, start: int, end: int, asked: int) -> tuple[str, str]:
    """What is wrong with a variable beyond its memory, and what to do."""
    scope, most = _memory(is_global)
    bytes_taken = f"byte {start}" if start == end - 1 else f"bytes {start} to {end - 1}"
    has = f"{plural(asked, 'byte')} of" if asked else "no"
    message = f"{name} takes {bytes_taken} of {scope} memory, and the header asks for {has} {scope} memory"
    if end > most:
        return message, f"use a lower index; there are {plural(most, 'byte')} of {scope} memory at most"
    return message, f"ask for {plural(end, 'byte')} of {scope} memory, or use a lower index"


def _overlaps(used: list[Footprint], *, is_kept: bool) -> Iterator[Finding]:
    """Results that destroy one another, in one memory.

    is_kept  whether a reply brings what is in that memory in the end
    """
    # What stands in each byte, written and searched in slices: with arrays there may be a thousand bytes each time.
    results: list[Footprint | None] = [None] * MAX_FRAME
    said: dict[tuple[object, ...], _Remark | None] = {}
    for together in _by_operation(used):
        # Arguments that may take all bytes from their start on are a thousand at worst: the first one is enough.
        open_from = MAX_FRAME
        for found in together:
            if not found.is_read:
                continue
            if found.most is None:
                open_from = min(open_from, found.start)
            else:
                end = min(found.start + found.most, MAX_FRAME)
                results[found.start : end] = [None] * (end - found.start)
        results[open_from:] = [None] * (MAX_FRAME - open_from)
        for found in together:
            if not found.is_written:
                continue
            end = min(found.end, MAX_FRAME)
            before = next(filter(None, results[found.start : end]), None)
            if before is not None:
                key = (*_identity(before), *_identity(found))
                if key not in said:
                    said[key] = _destroyed(before, found, is_kept)
                remark = said[key]
                if remark is not None:
                    yield remark.at(found.argument.offset)
            results[found.start : end] = [found] * (end - found.start)


def _identity(found: Footprint) -> tuple[object, ...]:
    """What is the same of two variables of which the same is to be said."""
    return found.operation[0], found.number, id(found.argument.form), found.start, found.size, found.most


def _by_operation(used: list[Footprint]) -> Iterator[list[Footprint]]:
    """The variables of each operation."""
    together: list[Footprint] = []
    for found in used:
        if together and together[0].operation is not found.operation:
            yield together
            together = []
        together.append(found)
    yield together


def _have_results_in_common(used: list[Use]) -> bool:
    """Whether there are two results at least that have a byte in common. Most commands have none."""
    taken = sorted([(start, end) for start, end, _, known, _, _ in used if known.is_written])
    last = 0
    for start, end in taken:
        if start < last:
            return True
        last = end
    return False


def _destroyed(before: Footprint, found: Footprint, is_kept: bool) -> _Remark | None:
    """A result where another one was that nobody has read."""
    is_vague = not before.is_exact or not found.is_exact
    if before.start == found.start and (before.end == found.end or is_vague):
        if not is_kept:
            return None
        return _remark(
            found,
            codes.OVERWRITTEN,
            f"{found.argument.name} is stored in {found.variable}, where {before.full_name} was: the reply brings only"
            " the last",
            "store them in different places",
        )
    if (before.is_array or found.is_array) and (_is_within(before, found) or _is_within(found, before)):
        # An array is often filled element by element.
        return None
    return _remark(
        found,
        codes.OVERLAP,
        f"{found.argument.name} takes bytes {found.start} to {found.end - 1}, and {before.full_name} takes"
        f" {before.start} to {before.end - 1}: the later one destroys the other",
        "store them in places that have no byte in common",
    )


def _is_within(inner: Footprint, outer: Footprint) -> bool:
    return inner.start >= outer.start and (outer.most is None or inner.end <= outer.start + outer.most)


def _asked_for(command: DirectCommand, local: list[Use], shared: list[Use]) -> Iterator[Finding]:
    """Memory in the header that nobody uses, and results that nobody gets."""
    if command.local_size:
        yield from _unused("local", command.local_size, local)
    if command.wants_reply:
        yield from _unused("global", command.global_size, shared)
        return
    unread = _unread(shared)
    if unread is not None:
        lost = _footprint(unread)
        yield codes.NO_REPLY.finding(
            TYPE_OFFSET,
            1,
            f"{lost.operation.full_name} stores {lost.argument.name} in {lost.variable}, which only a reply brings, and"
            " the type says that none is wanted",
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


def _unread(used: list[Use]) -> Use | None:
    """The first result that no operation reads."""
    read: Taken | None = None
    for use in used:
        start, end, _, known, _, _ = use
        if not known.is_written or end == start:
            continue
        read = read or Taken([(it[0], it[1]) for it in used if it[3].is_read])
        if not read.has_some_of(start, end):
            return use
    return None


def _unused(scope: str, asked: int, used: list[Use]) -> Iterator[Finding]:
    if not asked or asked > MOST_IN_REPLY:
        return
    needed = 0
    for _, _, end, _, _, _ in used:
        if end is None:
            # Nobody knows how many bytes it takes.
            return
        if end > needed:
            needed = end
    left = asked - needed
    if left <= 0 or (left < _LARGEST and needed and asked % _LARGEST == 0):
        return
    yield codes.UNUSED_MEMORY.finding(HEADER_SIZE, MEMORY_SIZE, *_unused_texts(scope, asked, needed))


@lru_cache(_MOST_TEXTS)
def _unused_texts(scope: str, asked: int, needed: int) -> tuple[str, str]:
    """What is wrong with memory of which only some is needed, and what to do."""
    share = f"{needed} of them are" if needed else "none of them is"
    return f"the header asks for {plural(asked, 'byte')} of {scope} memory, and {share} used", f"ask for {needed}"

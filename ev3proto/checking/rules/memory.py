"""Rules on variables: beyond the requested memory, misaligned, overlapping, or never read."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.header import MOST_IN_REPLY, TYPE_OFFSET
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand, Variable
from ev3proto.schema.header import HEADER_SIZE, MEMORY_SIZE
from ev3proto.semantics.footprint import Footprint, MemoryFacts, Taken
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS, MessageType

_LARGEST = 4
"""Bytes of the largest value; requested sizes are often rounded up to its multiples."""


Use = tuple[int, int, int | None, MemoryFacts | Footprint, CheckedOperation, int]
"""A variable: its first byte, its certain end, its largest possible end (None if unknown), what else is known
of it, its operation, the index of the argument."""


def check_memory(
    context: CheckContext, command: DirectCommand, local: list[Use], shared: list[Use]
) -> Iterator[Finding]:
    """Checks all variables of a command, in local and in global memory."""
    if local:
        yield from _places(local, command.local_size)
    if shared:
        yield from _places(shared, command.global_size)
    if not context.is_whole:
        # The memory use of unreadable operations is unknown.
        return
    if not context.has_jumps:
        # With jumps the order is unknown.
        if len(local) > 1 and _have_results_in_common(local):
            yield from _overlaps(local, is_kept=False)
        if len(shared) > 1 and _have_results_in_common(shared):
            yield from _overlaps(shared, is_kept=command.wants_reply)
    yield from _asked_for(command, local, shared)


_Identity = tuple[str, int, int, int, int, int | None]


def _identity(use: Use) -> _Identity:
    """Returns the key by which two variables have the same finding."""
    start, end, most, _, operation, number = use
    return operation.name, number, id(operation.arguments[number][1]), start, end, most


def _again(finding: Finding, offset: int) -> Finding:
    """Returns the finding about a variable, moved to another offset."""
    return Finding(
        finding.severity,
        finding.code,
        offset,
        finding.length,
        finding.message,
        finding.help,
        finding.operation,
        finding.parameter,
    )


def _places(used: list[Use], asked: int) -> Iterator[Finding]:
    """Yields findings about variables that are misaligned or beyond the requested memory."""
    # One variable may be wrong in a thousand places: its finding is made once.
    said: dict[_Identity, list[Finding]] = {}
    for use in used:
        start, end, _, known, operation, number = use
        if end > asked or start % known.validator_alignment or start % known.cpu_alignment:
            key = _identity(use)
            found = said.get(key)
            if found is None:
                found = said[key] = list(_wrongly_placed(use, asked))
            offset = operation.arguments[number][3]
            for finding in found:
                yield _again(finding, offset)


def _wrongly_placed(use: Use, asked: int) -> Iterator[Finding]:
    start, end, _, known, operation, number = use
    argument = operation.arguments[number]
    is_global = argument.form.kind == GLOBAL
    multiples = known.validator_alignment, known.cpu_alignment
    if start % max(multiples):
        code = codes.MISALIGNED if start % known.validator_alignment else codes.UNALIGNED
        texts = _misaligned_texts(argument.name, is_global, start, end - start, multiples, asked)
        yield operation.finding_at(code, argument, *texts)
    if end > asked:
        code = codes.BEYOND_GLOBALS if is_global else codes.BEYOND_LOCALS
        yield operation.finding_at(code, argument, *_beyond_texts(argument.name, is_global, start, end, asked))


def _misaligned_texts(
    name: str, is_global: bool, start: int, size: int, multiples: tuple[int, int], asked: int
) -> tuple[str, str]:
    """Returns message and help for a misaligned variable.

    Args:
        name: The parameter's name.
        is_global: Whether the variable is in global memory.
        start: Its index.
        size: Its size in bytes.
        multiples: The multiples required by the validator and by the processor.
        asked: Bytes of that memory that the command requests.
    """
    for_validator, for_cpu = multiples
    is_validated = start % for_validator != 0
    multiple = for_validator if is_validated else for_cpu
    aside = "" if is_validated else ", though the firmware does not check it here"
    message = f"{name} is {_variable(is_global, start)}, and must start at a multiple of {multiple}{aside}"
    return message, _aligned(is_global, start, size, max(multiples), asked)


def _aligned(is_global: bool, start: int, size: int, multiple: int, asked: int) -> str:
    """Returns where a misaligned variable could start: above if the memory has room, else below."""
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
        return f"{better}, and request {counted(end, 'byte')} of {scope} memory"
    return f"{better}, or another multiple of {multiple}"


def _variable(is_global: bool, index: int) -> Variable:
    return Variable(GLOBAL if is_global else LOCAL, index)


def _memory(is_global: bool) -> tuple[str, int]:
    """Returns the name of a memory and its maximum size in bytes."""
    return ("global", MOST_IN_REPLY) if is_global else ("local", MAX_LOCALS)


def _beyond_texts(name: str, is_global: bool, start: int, end: int, asked: int) -> tuple[str, str]:
    """Returns message and help for a variable beyond its memory."""
    scope, most = _memory(is_global)
    bytes_taken = f"byte {start}" if start == end - 1 else f"bytes {start} to {end - 1}"
    has = f"{counted(asked, 'byte')} of" if asked else "no"
    message = f"{name} takes {bytes_taken} of {scope} memory, but the header requests {has} {scope} memory"
    if end > most:
        return message, f"use a lower index; {scope} memory has at most {counted(most, 'byte')}"
    return message, f"request {counted(end, 'byte')} of {scope} memory, or use a lower index"


def _overlaps(used: list[Use], *, is_kept: bool) -> Iterator[Finding]:
    """Yields findings about results that overwrite each other in one memory.

    Args:
        used: The variables in that memory.
        is_kept: Whether a reply carries the final contents of that memory.
    """
    # The user of each byte, in slices: arrays may take a thousand bytes each.
    results: list[tuple[_Identity, Use] | None] = [None] * MAX_FRAME
    said: dict[tuple[_Identity, _Identity], Finding | None] = {}
    for together in _by_operation(used):
        # Up to a thousand arguments may take all bytes from their start on: the first one is enough.
        open_from = MAX_FRAME
        for start, _, most, known, _, _ in together:
            if not known.is_read:
                continue
            if most is None:
                open_from = min(open_from, start)
            else:
                end = min(most, MAX_FRAME)
                results[start:end] = [None] * (end - start)
        results[open_from:] = [None] * (MAX_FRAME - open_from)
        for use in together:
            start, end, _, known, operation, number = use
            if not known.is_written:
                continue
            if end > MAX_FRAME:
                end = MAX_FRAME
            key = _identity(use)
            before = next(filter(None, results[start:end]), None)
            if before is not None:
                both = before[0], key
                if both not in said:
                    said[both] = _destroyed(before[1], use, is_kept)
                finding = said[both]
                if finding is not None:
                    yield _again(finding, operation.arguments[number][3])
            results[start:end] = [(key, use)] * (end - start)


def _by_operation(used: list[Use]) -> Iterator[list[Use]]:
    """Yields the variables of each operation."""
    together: list[Use] = []
    for use in used:
        if together and together[0][4] is not use[4]:
            yield together
            together = []
        together.append(use)
    yield together


def _have_results_in_common(used: list[Use]) -> bool:
    """Returns whether any two results share a byte, which is rare."""
    taken = sorted([(start, end) for start, end, _, known, _, _ in used if known.is_written])
    last = 0
    for start, end in taken:
        if start < last:
            return True
        last = end
    return False


def _destroyed(before: Use, use: Use, is_kept: bool) -> Finding | None:
    """Returns the finding about a result that overwrites an unread one."""
    first, first_end, first_most, first_known, *_ = before
    start, end, most, known, operation, number = use
    argument = operation.arguments[number]
    is_vague = first_most != first_end or most != end
    if first == start and (first_end == end or is_vague):
        if not is_kept:
            return None
        return operation.finding_at(
            codes.OVERWRITTEN,
            argument,
            f"{argument.name} is stored in {_of(use)}, like {_full_name(before)} before: the reply has only the last",
            "store them in different variables",
        )
    if (first_known.is_array or known.is_array) and (_is_within(before, use) or _is_within(use, before)):
        # Arrays are often filled element by element.
        return None
    return operation.finding_at(
        codes.OVERLAP,
        argument,
        f"{argument.name} takes bytes {start} to {end - 1}, and {_full_name(before)} takes {first} to {first_end - 1}:"
        " the later one destroys the other",
        "store them in variables that do not overlap",
    )


def _is_within(inner: Use, outer: Use) -> bool:
    return inner[0] >= outer[0] and (outer[2] is None or inner[1] <= outer[2])


def _full_name(use: Use) -> str:
    """`VALUE of UI_READ.GET_VBATT`."""
    *_, operation, number = use
    return f"{operation.arguments[number].name} of {operation.name}"


def _of(use: Use) -> Variable:
    """Returns the variable."""
    start, _, _, _, operation, number = use
    form = operation.arguments[number].form
    return Variable(form.kind, start, form.handle, form.address)


def _asked_for(command: DirectCommand, local: list[Use], shared: list[Use]) -> Iterator[Finding]:
    """Yields findings about unused memory, and about results without a reply."""
    if command.local_size:
        yield from _unused("local", command.local_size, local)
    if command.wants_reply:
        yield from _unused("global", command.global_size, shared)
        return
    unread = _unread(shared)
    if unread is not None:
        *_, operation, number = unread
        yield codes.NO_REPLY.finding(
            TYPE_OFFSET,
            1,
            f"{operation.name} stores {operation.arguments[number].name} in {_of(unread)}, which only a reply carries,"
            " but the type does not ask for one",
            f"use type 0x{MessageType.DIRECT_COMMAND_REPLY:02X}, or store it in local memory",
        )
    elif command.global_size and not shared:
        yield codes.UNWANTED_GLOBALS.finding(
            HEADER_SIZE,
            MEMORY_SIZE,
            f"the header requests {counted(command.global_size, 'byte')} of global memory, which no operation uses and"
            " no reply carries",
            f"request none, or use type 0x{MessageType.DIRECT_COMMAND_REPLY:02X}",
        )


def _unread(used: list[Use]) -> Use | None:
    """Returns the first result that no operation reads."""
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
            # Its size is unknown.
            return
        if end > needed:
            needed = end
    left = asked - needed
    if left <= 0 or (left < _LARGEST and needed and asked % _LARGEST == 0):
        return
    yield codes.UNUSED_MEMORY.finding(HEADER_SIZE, MEMORY_SIZE, *_unused_texts(scope, asked, needed))


def _unused_texts(scope: str, asked: int, needed: int) -> tuple[str, str]:
    """Returns message and help for partly used memory."""
    share = f"only {needed} are" if needed else "none are"
    return f"the header requests {counted(asked, 'byte')} of {scope} memory, but {share} used", f"request {needed}"

"""Composition of commands from operations. Omitted parts (places in memory, sizes, reply type) are computed.

An operation of `ev3proto.ops` is a `Draft`: its values are checked and encoded, but omitted variables,
and `Local()` and `Global()`, get their place only in `command`, which knows all users of the memory.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache

from ev3proto.errors import BuildError
from ev3proto.messages import DirectCommand, Operation, Variable
from ev3proto.schema.argument import encode_variable
from ev3proto.schema.constructors import EMPTY_COMMAND, placed_in_frame
from ev3proto.semantics.drafts.draft import STAND_IN, Draft, draft_of
from ev3proto.semantics.drafts.placeholders import (
    Allocator,
    Global,
    Label,
    Local,
    Need,
    Placeholder,
    aligned,
    joined,
    with_jumps,
)
from ev3proto.semantics.footprint import MEMORY_LIMITS, Footprint
from ev3proto.tables.encoding import GLOBAL, LOCAL

__all__ = ["Draft", "Global", "Label", "Local", "Placeholder", "command"]


Layout = tuple[list[bytes], int, int, bool]
"""The bytes of each operation, with all variables placed; the bytes of global and of local memory that the operations
use; whether any of them writes to global memory."""


def _layout_of_omitted(drafts: Sequence[Draft], omitted: str) -> Layout | None:
    """Returns the layout of operations whose only variables are omitted outputs, None for all others."""
    # Nearly every command is one of these. With two operations and one output this takes 1 us, the general way 15 us.
    size = 0
    encoded = []
    for draft in drafts:
        if draft.needs is None:
            return None
        if not draft.needs:
            encoded.append(draft.encoded)
            continue
        pieces = [draft.encoded[: -len(draft.needs) * len(STAND_IN)]]
        for _, wanted, alignment in draft.needs:
            start = aligned(size, alignment)
            size = start + wanted
            if size > MEMORY_LIMITS[omitted]:
                return None
            pieces.append(_variable(omitted, start))
        encoded.append(b"".join(pieces))
    return (encoded, size, 0, size > 0) if omitted == GLOBAL else (encoded, 0, size, False)


@cache
def _variable(scope: str, index: int) -> bytes:
    """Returns the encoded variable; cached, since commands use few different ones."""
    return encode_variable(Variable(scope, index))


class _LayoutOfAll:
    """The layout of any command: explicit places are reserved first, then the others are assigned in order."""

    def __init__(self, drafts: Sequence[Draft], omitted: str) -> None:
        self._drafts = [(draft, draft.footprints) for draft in drafts]
        self._omitted = omitted
        self._memories = {scope: Allocator(scope, limit) for scope, limit in MEMORY_LIMITS.items()}
        self._places: dict[Placeholder, Variable] = {}
        self._writes_globals = False
        self._shared: dict[Placeholder, list[Footprint]] = {}
        for draft, found in self._drafts:
            for footprint in found:
                place = draft.place_of(footprint)
                if place is None:
                    self._take(footprint)
                elif isinstance(place, Placeholder):
                    # Uses of a variable with a handle or address mark count, too.
                    self._shared.setdefault(place.origin, []).append(footprint)

    def _take(self, footprint: Footprint) -> None:
        memory = self._memories[footprint.argument.kind]
        is_open = footprint.room is None
        memory.take(footprint.start, footprint.reserved, footprint.full_name, is_open=is_open)
        self._writes_globals |= _is_stored(footprint) and footprint.is_global

    def layout(self, labels: Mapping[Label, int]) -> Layout:
        """Returns the layout for labels in front of operations. Raises BuildError."""
        encoded = [self._placed(draft, found) for draft, found in self._drafts]
        jumps = {number: draft.label for number, (draft, _) in enumerate(self._drafts) if draft.label is not None}
        if jumps:
            encoded = with_jumps(encoded, jumps, labels)
        return encoded, self._memories[GLOBAL].size, self._memories[LOCAL].size, self._writes_globals

    def _placed(self, draft: Draft, found: Iterable[Footprint]) -> bytes:
        variables: dict[int, Variable] = {}
        for footprint in found:
            number = footprint.number
            place = draft.place_of(footprint)
            if isinstance(place, Placeholder):
                at = self._variable(place)
                variables[number] = Variable(at.scope, at.index, place.handle, place.address)
            elif place is not None:
                variables[number] = self._memories[self._omitted].give(_need_of(footprint))
            if number in variables:
                self._writes_globals |= _is_stored(footprint) and variables[number].scope == GLOBAL
        return draft.placed(variables)

    def _variable(self, place: Placeholder) -> Variable:
        origin = place.origin
        if origin not in self._places:
            self._places[origin] = self._memories[origin.scope].give(_need(origin, self._shared[origin]))
        return self._places[origin]


def _need(place: Placeholder, found: Sequence[Footprint]) -> Need:
    """Returns what a variable needs by all its uses."""
    known = [each for each in found if each.room is not None]
    vague = [each for each in found if each.room is None and (_is_stored(each) or not known)]
    need = joined(_need_of(each) for each in known or found)
    if place.size is not None:
        least = max(each.size for each in known or found)
        if place.size < least:
            raise BuildError(f"{place!r} is too small: {need.name} takes {least} bytes")
        return need._replace(size=place.size)
    if vague:
        raise BuildError(
            f"the size of {vague[0].full_name} is unknown: pass one, such as {place.scope.capitalize()}(32)"
        )
    return need


def _need_of(footprint: Footprint) -> Need:
    return Need(footprint.full_name, footprint.reserved, footprint.facts.alignment)


def _is_stored(footprint: Footprint) -> bool:
    """Returns whether a reply would carry a result of the operation."""
    return footprint.facts.is_written or footprint.facts.is_result


def command(
    *operations: Draft | Operation | Label,
    counter: int = 0,
    reply: bool | None = None,
    global_size: int | None = None,
    local_size: int | None = None,
) -> DirectCommand:
    """Composes a direct command from operations; omitted parts are computed.

    Omitted outputs follow each other in global memory, in order, each aligned for its type.
    Explicit places are kept. `Local()` and `Global()` variables get a place, too.

    Args:
        operations: From `ev3proto.ops` or `ev3proto.operation`. A `Label` among them is the target of the jumps
            that name it.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer; by default, if anything is written to global memory. With
            False, omitted outputs go to local memory, since no reply carries them.
        global_size: Bytes of global memory, 0 to 1023; by default, as many as the operations use.
        local_size: Bytes of local memory, 0 to 63; by default, as many as the operations use.

    Returns:
        The command. Each operation has its offset in the frame.

    Raises:
        BuildError: It does not fit into a frame, or an explicit size is less than the operations use.
    """
    drafts = [each if type(each) is Draft else _drafted(each) for each in operations if type(each) is not Label]
    if not drafts:
        raise BuildError(EMPTY_COMMAND)
    omitted = LOCAL if reply is False else GLOBAL
    found = _layout_of_omitted(drafts, omitted) if len(drafts) == len(operations) else None
    if found is None:
        found = _LayoutOfAll(drafts, omitted).layout(_places(operations))
    encoded, globals_used, locals_used, writes_globals = found
    if reply is None:
        reply = writes_globals or bool(global_size)
    global_size = _size(GLOBAL, globals_used, global_size)
    local_size = _size(LOCAL, locals_used, local_size)
    return placed_in_frame(drafts, encoded, counter, reply, global_size, local_size)


def _places(operations: Sequence[Draft | Operation | Label]) -> dict[Label, int]:
    """Returns the number of the operation after each label."""
    found: dict[Label, int] = {}
    count = 0
    for each in operations:
        if not isinstance(each, Label):
            count += 1
        elif each in found:
            raise BuildError(f"{each!r} occurs twice, but a jump has only one target")
        else:
            found[each] = count
    return found


def _drafted(operation: Draft | Operation | Label) -> Draft:
    if isinstance(operation, Draft):
        return operation
    if isinstance(operation, Operation):
        return draft_of(operation)
    raise BuildError(f"{operation!r} is not an operation: use ev3proto.ops, for example ops.sound.tone(1, 440, 1000)")


def _size(scope: str, needed: int, by_hand: int | None) -> int:
    """Returns the size of a memory to request."""
    if by_hand is None:
        if needed > MEMORY_LIMITS[scope]:
            most = MEMORY_LIMITS[scope]
            raise BuildError(f"the operations use {scope} memory up to byte {needed}, but it has at most {most} bytes")
        return needed
    if isinstance(by_hand, int) and by_hand < needed:
        raise BuildError(
            f"{scope}_size must be {needed} or more, not {by_hand}: the operations use that much {scope} memory"
        )
    return by_hand

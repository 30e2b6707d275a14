"""Where each variable of a command goes, and how much memory the command needs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

from ev3proto.errors import BuildError
from ev3proto.messages import Variable
from ev3proto.schema.argument import encode_variable
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.drafts.allocation import Allocator, Need, aligned, joined
from ev3proto.semantics.drafts.draft import STAND_IN, Draft
from ev3proto.semantics.drafts.placeholders import Placeholder
from ev3proto.semantics.footprint import Footprint
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS

LIMITS = {LOCAL: MAX_LOCALS, GLOBAL: MAX_FRAME - HEADER_SIZE}
"""Bytes of each memory: the header has no room for more locals, a reply none for more globals."""


Layout = tuple[list[bytes], int, int, bool]
"""The bytes of each operation, every variable in its place; how many bytes of global and of local memory the operations
use; whether one of them stores anything in global memory."""


def layout(drafts: Sequence[Draft], omitted: str) -> Layout:
    """Finds a place for each variable that has none.

    Args:
        drafts: The operations.
        omitted: The memory that outputs go to which were omitted.

    Raises:
        BuildError: There is no room, or it is not known how much a variable takes.
    """
    return _layout_of_omitted(drafts, omitted) or _LayoutOfAll(drafts, omitted).layout()


def _layout_of_omitted(drafts: Sequence[Draft], omitted: str) -> Layout | None:
    """The layout of a command that has no variables but outputs that were omitted, None for all others.

    Nearly every command is one of these. It takes a tenth of the time that looking at every argument takes.
    """
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
            if size > LIMITS[omitted]:
                return None
            pieces.append(_variable(omitted, start))
        encoded.append(b"".join(pieces))
    return (encoded, size, 0, size > 0) if omitted == GLOBAL else (encoded, 0, size, False)


@cache
def _variable(scope: str, index: int) -> bytes:
    """A variable of a command, of which there are not many."""
    return encode_variable(Variable(scope, index))


class _LayoutOfAll:
    """The layout of any command: first what has a place by hand is taken, then the others get theirs in order."""

    def __init__(self, drafts: Sequence[Draft], omitted: str) -> None:
        self._drafts = [(draft, draft.footprints) for draft in drafts]
        self._omitted = omitted
        self._memories = {scope: Allocator(scope, limit) for scope, limit in LIMITS.items()}
        self._places: dict[Placeholder, Variable] = {}
        self._writes_globals = False
        self._shared: dict[Placeholder, list[Footprint]] = {}
        for draft, found in self._drafts:
            for footprint in found:
                place = draft.place_of(footprint)
                if place is None:
                    self._take(footprint)
                elif isinstance(place, Placeholder):
                    # Marked uses of a variable are uses of it, too.
                    self._shared.setdefault(place.origin, []).append(footprint)

    def _take(self, footprint: Footprint) -> None:
        memory = self._memories[footprint.argument.kind]
        is_open = footprint.room is None
        memory.take(footprint.start, _room(footprint), footprint.full_name, is_open=is_open)
        self._writes_globals |= _is_stored(footprint) and footprint.is_global

    def layout(self) -> Layout:
        """All of it."""
        encoded = [self._placed(draft, found) for draft, found in self._drafts]
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
    """What a variable needs by all its uses. BuildError where they do not tell, or the size given is too small."""
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
            f"it is not known how many bytes {vague[0].full_name} takes: give a size, such as"
            f" {place.scope.capitalize()}(32)"
        )
    return need


def _need_of(footprint: Footprint) -> Need:
    return Need(footprint.full_name, _room(footprint), footprint.alignment)


def _room(footprint: Footprint) -> int:
    """Bytes to set aside for a variable, or those that it takes for sure."""
    return footprint.size if footprint.room is None else footprint.room


def _is_stored(footprint: Footprint) -> bool:
    """Whether a reply would bring something that the operation stores."""
    return footprint.is_written or footprint.is_result

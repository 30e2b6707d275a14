"""`command`: a direct command of operations, whose variables, memory sizes and reply type are worked out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from ev3proto.compose.drafts import Draft, Open, draft_of
from ev3proto.compose.memory import Memory, Need, joined
from ev3proto.compose.places import Place
from ev3proto.errors import BuildError
from ev3proto.messages import DirectCommand, Operation, Variable
from ev3proto.schema.constructors import direct_command
from ev3proto.schema.frame import HEADER_SIZE
from ev3proto.semantics.footprint import Footprint
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS

_LIMITS = {LOCAL: MAX_LOCALS, GLOBAL: MAX_FRAME - HEADER_SIZE}
"""Bytes of each memory: the header has no room for more locals, a reply none for more globals."""


def command(
    *operations: Draft | Operation,
    counter: int = 0,
    reply: bool | None = None,
    global_size: int | None = None,
    local_size: int | None = None,
) -> DirectCommand:
    """A direct command of these operations; what is not said is worked out.

    Outputs that were left away follow each other in global memory, in their order, each aligned as its type wants it;
    what has a place by hand stays there and is left alone. Variables that are `Local()` or `Global()` get a place, too.

    operations   of `ev3proto.ops`, or of `ev3proto.operation`
    counter      0 to 65535
    reply        whether the brick is to answer; left away, it is where anything is written to global memory. With
                 False, outputs that were left away go to local memory: nobody would read them.
    global_size  bytes of global memory; left away, as many as the operations use
    local_size   bytes of local memory; left away, as many as the operations use

    Raises BuildError where no frame can carry it, or a size given by hand is less than the operations use.
    """
    drafts = [_drafted(operation) for operation in operations]
    if not drafts:
        raise BuildError("a command needs an operation: the brick refuses an empty one")
    layout = _Layout(drafts, left_away=LOCAL if reply is False else GLOBAL)
    placed = layout.operations()
    if reply is None:
        reply = layout.writes_globals or bool(global_size)
    return direct_command(
        *placed,
        counter=counter,
        reply=reply,
        global_size=layout.size(GLOBAL, global_size),
        local_size=layout.size(LOCAL, local_size),
    )


def _drafted(operation: Draft | Operation) -> Draft:
    if isinstance(operation, Draft):
        return operation
    if isinstance(operation, Operation):
        return draft_of(operation)
    raise BuildError(f"{operation!r} is no operation: ev3proto.ops has them all, such as ops.sound.tone(1, 440, 1000)")


class _Open(NamedTuple):
    """A use of a variable that has no place yet."""

    draft: Draft
    footprint: Footprint
    place: Place | Open


class _Layout:
    """Where each variable of a command goes."""

    def __init__(self, drafts: Sequence[Draft], left_away: str) -> None:
        self._drafts = drafts
        self._left_away = left_away
        self._memories = {scope: Memory(scope, limit) for scope, limit in _LIMITS.items()}
        self._places: dict[Place, Variable] = {}
        self.writes_globals = False
        found = []
        for draft in drafts:
            for footprint in draft.footprints:
                place = draft.place_of(footprint)
                if place is None:
                    self._take(footprint)
                else:
                    found.append(_Open(draft, footprint, place))
        self._shared = _shared(found)

    def _take(self, footprint: Footprint) -> None:
        memory = self._memories[footprint.argument.kind]
        is_open = footprint.room is None
        memory.take(footprint.start, _room(footprint), footprint.full_name, is_open=is_open)
        self.writes_globals |= _is_stored(footprint) and footprint.is_global

    def operations(self) -> list[Operation]:
        """The operations, every variable in its place."""
        return [self._placed(draft) for draft in self._drafts]

    def _placed(self, draft: Draft) -> Operation:
        if draft.is_complete:
            return draft.operation
        variables: dict[int, Variable] = {}
        for footprint in draft.footprints:
            number = footprint.number
            place = draft.place_of(footprint)
            if isinstance(place, Place):
                at = self._variable(place)
                variables[number] = Variable(at.scope, at.index, place.handle, place.address)
            elif place is not None:
                variables[number] = self._memories[self._left_away].give(_need_of(footprint))
            if number in variables:
                self.writes_globals |= _is_stored(footprint) and variables[number].scope == GLOBAL
        return draft.placed(variables)

    def _variable(self, place: Place) -> Variable:
        origin = place.origin
        if origin not in self._places:
            self._places[origin] = self._memories[origin.scope].give(_need(origin, self._shared[origin]))
        return self._places[origin]

    def size(self, scope: str, by_hand: int | None) -> int:
        """Bytes of a memory to ask for. BuildError where fewer are asked for by hand than are used."""
        needed = self._memories[scope].size
        if by_hand is None:
            if needed > _LIMITS[scope]:
                raise BuildError(
                    f"the operations use {scope} memory up to byte {needed}, and there are {_LIMITS[scope]} at most"
                )
            return needed
        if isinstance(by_hand, int) and by_hand < needed:
            raise BuildError(f"{scope}_size cannot be {by_hand}: the operations use {needed} of {scope} memory")
        return by_hand


def _shared(found: Iterable[_Open]) -> dict[Place, list[Footprint]]:
    """The uses of each variable, marked ones among those of the variable that they mark."""
    shared: dict[Place, list[Footprint]] = {}
    for use in found:
        if isinstance(use.place, Place):
            shared.setdefault(use.place.origin, []).append(use.footprint)
    return shared


def _need(place: Place, found: Sequence[Footprint]) -> Need:
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
            f"nobody can tell how many bytes {vague[0].full_name} takes: give a size, such as"
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

"""`command`: a direct command of operations, whose variables, memory sizes and reply type are worked out."""

from __future__ import annotations

from collections.abc import Sequence

from ev3proto.compose.layout import LIMITS, layout
from ev3proto.errors import BuildError
from ev3proto.messages import DirectCommand, Operation
from ev3proto.schema.constructors import EMPTY_COMMAND
from ev3proto.schema.header import COMMAND_HEADER_SIZE, build_frame, write_memory
from ev3proto.semantics.drafts.draft import Draft, draft_of
from ev3proto.semantics.drafts.labels import Label, with_jumps
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES


def command(
    *operations: Draft | Operation | Label,
    counter: int = 0,
    reply: bool | None = None,
    global_size: int | None = None,
    local_size: int | None = None,
) -> DirectCommand:
    """Composes a direct command of operations; what is not given is worked out.

    Outputs that were omitted follow each other in global memory, in their order, each aligned as its type wants it.
    What has a place by hand stays there. Variables that are `Local()` or `Global()` get a place, too.

    Args:
        operations: Of `ev3proto.ops`, or of `ev3proto.operation`. A `Label` among them is the place to which those jump
            that name it.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick is to answer; when omitted, it is where anything is written to global memory. With
            False, outputs that were omitted go to local memory: nobody would read them.
        global_size: Bytes of global memory, 0 to 1023; when omitted, as many as the operations use.
        local_size: Bytes of local memory, 0 to 63; when omitted, as many as the operations use.

    Returns:
        The command. Each operation has the offset that it has in the frame.

    Raises:
        BuildError: No frame can carry it, or a size given by hand is less than the operations use.
    """
    drafts = [each if type(each) is Draft else _drafted(each) for each in operations if type(each) is not Label]
    if not drafts:
        raise BuildError(EMPTY_COMMAND)
    encoded, globals_used, locals_used, writes_globals = layout(drafts, LOCAL if reply is False else GLOBAL)
    jumps = {number: draft.label for number, draft in enumerate(drafts) if draft.label is not None}
    if jumps or len(drafts) < len(operations):
        encoded = with_jumps(encoded, jumps, _places(operations))
    if reply is None:
        reply = writes_globals or bool(global_size)
    kind = DIRECT_COMMAND_TYPES[bool(reply)]
    global_size = _size(GLOBAL, globals_used, global_size)
    local_size = _size(LOCAL, locals_used, local_size)
    frame = build_frame(kind, counter, write_memory(global_size, local_size) + b"".join(encoded))
    end = COMMAND_HEADER_SIZE
    placed = []
    for draft, raw in zip(drafts, encoded, strict=True):
        start, end = end, end + len(raw)
        placed.append(Operation((draft.schema, frame, start, end)))
    return DirectCommand(
        type=kind, counter=counter, global_size=global_size, local_size=local_size, operations=tuple(placed)
    )


def _places(operations: Sequence[Draft | Operation | Label]) -> dict[Label, int]:
    """The number of the operation that each label stands in front of. BuildError for one that stands in two places."""
    found: dict[Label, int] = {}
    count = 0
    for each in operations:
        if not isinstance(each, Label):
            count += 1
        elif each in found:
            raise BuildError(f"{each!r} stands in two places, and a jump leads to one")
        else:
            found[each] = count
    return found


def _drafted(operation: Draft | Operation | Label) -> Draft:
    if isinstance(operation, Draft):
        return operation
    if isinstance(operation, Operation):
        return draft_of(operation)
    raise BuildError(f"{operation!r} is no operation: ev3proto.ops has them all, such as ops.sound.tone(1, 440, 1000)")


def _size(scope: str, needed: int, by_hand: int | None) -> int:
    """Bytes of a memory to ask for. BuildError where fewer are asked for by hand than are used."""
    if by_hand is None:
        if needed > LIMITS[scope]:
            raise BuildError(
                f"the operations use {scope} memory up to byte {needed}, and there are {LIMITS[scope]} at most"
            )
        return needed
    if isinstance(by_hand, int) and by_hand < needed:
        raise BuildError(
            f"{scope}_size must be {needed} or more, not {by_hand}: the operations use that much {scope} memory"
        )
    return by_hand

"""Rules on operations together: programs that are loaded, started and stopped; motors in step."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.messages import Argument
from ev3proto.semantics.footprint import Footprint, Taken, footprints, whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import LOCAL

_LOAD, _START = "FILE.LOAD_IMAGE", "PROGRAM_START"
_MENU = 0
"""The slot of the brick's menu."""


def check_programs(context: CheckContext) -> Iterator[Finding]:
    """Checks the operations of a direct command on programs and on motors in step."""
    if Effect.SYNCHRONIZES in context.effects:
        yield from _synchronized(context.operations)
    if Effect.CONTROLS_PROGRAMS in context.effects:
        yield from _slots(context.operations, has_jumps=context.has_jumps)


def _synchronized(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    for operation in operations:
        for argument in operation.arguments if operation.has(Effect.SYNCHRONIZES) else ():
            mask = whole_number(argument) if argument.parameter.role is Role.MOTORS else None
            count = (mask or 0).bit_count()
            if mask and mask > 0 and count != _PAIR:
                yield operation.finding_of(codes.NOT_TWO_MOTORS, argument, count=counted(count, "motor"))


_PAIR = 2


def _slots(operations: tuple[CheckedOperation, ...], *, has_jumps: bool) -> Iterator[Finding]:
    loaded: set[int | None] = set()
    for place, operation in enumerate(operations):
        slot = next(iter(operation.arguments), None)
        number = whole_number(slot)
        if slot is not None and number == _MENU and operation.name in codes.SLOT_OF_MENU.words:
            yield operation.finding_of(codes.SLOT_OF_MENU, slot, operation.name)
        elif operation.name == _LOAD:
            loaded.add(number)
        elif operation.name == _START and slot is not None:
            # With jumps the order is unknown.
            before = operations[: None if has_jumps else place + 1]
            yield from _misplaced(operation, before)
            if number is not None:
                yield from _start(operation, slot, number, loaded, before)


def _start(
    operation: CheckedOperation,
    slot: Argument,
    number: int,
    loaded: set[int | None],
    operations: tuple[CheckedOperation, ...],
) -> Iterator[Finding]:
    """Yields what is wrong with the start of a program, after some operations that loaded programs into slots."""
    address = next((one for one in operation.arguments if one.name == "IP"), None)
    if address is not None and (whole_number(address) == 0 or _is_empty(address, operations)):
        yield operation.finding_of(codes.STARTED_UNLOADED, address)
    elif loaded and not {number, None} & loaded:
        yield operation.finding_of(codes.OTHER_SLOT, slot, loaded=next(iter(loaded)), slot=number)


def _is_empty(address: Argument, operations: tuple[CheckedOperation, ...]) -> bool:
    """Returns whether an argument is a local variable that none of the operations fills."""
    places: list[Footprint] = [place for one in operations for place in footprints(one.parsed)]
    written = Taken((one.start, one.end) for one in places if one.facts.is_written and not one.is_global)
    own = [one for one in places if one.argument is address and one.argument.kind == LOCAL]
    return any(not written.has_some_of(one.start, one.end) for one in own)


def _misplaced(operation: CheckedOperation, operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """Yields what is wrong with a start of a program whose slot or address is another result of loading it."""
    outputs = [one for other in operations if other.name == _LOAD for one in other.arguments if one.is_variable]
    results = {(one.kind, one.value): one.name for one in outputs if one.parameter.is_output}
    for argument in operation.arguments:
        result = results.get((argument.kind, argument.value), argument.name)
        if argument.name in _USED and result != argument.name:
            yield operation.finding_of(codes.OTHER_RESULT, argument, result=result)


_USED = ("PRGID", "IP")
"""What PROGRAM_START does not ignore, and FILE.LOAD_IMAGE may have stored."""

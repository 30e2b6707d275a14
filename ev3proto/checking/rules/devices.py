"""Hints about motors, sounds and readings that do something else than a sender expects.

Each rule knows some operations by their names or effects; another one that may change the matter ends its knowledge.
"""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation, MotorAt
from ev3proto.checking.report import Finding
from ev3proto.messages import DirectCommand
from ev3proto.semantics.footprint import Footprint, Taken
from ev3proto.tables.declaration import Effect
from ev3proto.tables.encoding import TEXT
from ev3proto.tables.sound import OWN_FOLDERS

_LARGER = {"INPUT_READ": "INPUT_READSI", "INPUT_DEVICE.READY_PCT": "INPUT_DEVICE.READY_SI"}
"""Operations that write the same in one byte and as a float, which programs confuse."""

_FLOAT = 4
_DRIVES = ("OUTPUT_POWER", "OUTPUT_SPEED")


def check_devices(context: CheckContext, shared: list[tuple[CheckedOperation, Footprint]]) -> Iterator[Finding]:
    """Checks the operations of a direct command; `shared` are their variables in global memory."""
    if not context.is_whole:
        return
    if not context.effects.isdisjoint((Effect.STARTS_MOVE, Effect.STARTS_MOTORS)):
        operations = [(operation, operation.motors) for operation in context.operations]
        yield from _reads_after_moves(operations)
        yield from _other_drives(operations)
    if Effect.AWAITS_SOUND in context.effects:
        yield from _waits_for_files(context.operations)
    if any(operation.name in _LARGER for operation, _ in shared):
        yield from _partly_written(context.message, shared)


def _forget(found: dict[MotorAt, CheckedOperation], ports: list[MotorAt] | None) -> None:
    """Removes what is known of some ports; of all if they are not known."""
    for port in list(found) if ports is None else ports:
        found.pop(port, None)


def _reads_after_moves(operations: list[tuple[CheckedOperation, list[MotorAt] | None]]) -> Iterator[Finding]:
    moved: dict[MotorAt, CheckedOperation] = {}
    for operation, ports in operations:
        if operation.has(Effect.STARTS_MOVE):
            moved.update(dict.fromkeys(ports or (), operation))
        elif operation.name == "OUTPUT_READ":
            for move in [moved[port] for port in ports or () if port in moved]:
                yield operation.finding(codes.READ_AFTER_MOVE, move=move.name, at=move.start)
        elif _drives(operation):
            _forget(moved, ports)


def _drives(operation: CheckedOperation) -> bool:
    """Returns whether an operation changes how motors turn."""
    return any(map(operation.has, (Effect.STOPS_MOTORS, Effect.SETS_MOTORS, Effect.RUNS_MOTORS)))


def _other_drives(operations: list[tuple[CheckedOperation, list[MotorAt] | None]]) -> Iterator[Finding]:
    chosen: dict[MotorAt, CheckedOperation] = {}
    running: dict[MotorAt, CheckedOperation] = {}
    for operation, ports in operations:
        known = ports or ()
        idle = [port for port in known if port not in running]
        if operation.name in _DRIVES:
            others = [running[port] for port in known if running.get(port, operation).name != operation.name]
            for other in others[:1]:
                parts = {"other": other.name, "at": other.start, "opcode": codes.opcode(other.name)}
                yield operation.finding(codes.OTHER_DRIVE, **parts)
            chosen.update(dict.fromkeys(idle, operation))
        elif operation.has(Effect.STARTS_MOTORS):
            running.update({port: chosen[port] for port in idle if port in chosen})
        elif any(map(operation.has, (Effect.STOPS_MOTORS, Effect.STARTS_MOVE))):
            _forget(running, ports)
            _forget(chosen, ports)


def _waits_for_files(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    file = ""
    for operation in operations:
        if operation.has(Effect.AWAITS_SOUND) and file and not file.startswith(OWN_FOLDERS):
            yield operation.finding(codes.MAY_WAIT_FOREVER, file=file)
        if any(map(operation.has, (Effect.STARTS_SOUND, Effect.ENDS_SOUND, Effect.AWAITS_SOUND))):
            files = [str(one.value) for one in operation.arguments if one.parameter.suffix and one.kind == TEXT]
            file = next(iter(files), "")


def _partly_written(message: object, shared: list[tuple[CheckedOperation, Footprint]]) -> Iterator[Finding]:
    assert isinstance(message, DirectCommand)
    room = message.global_size if message.wants_reply else 0
    # More memory than that is a finding of its own.
    if room >= max(place.end for _, place in shared) + _FLOAT:
        return
    taken = Taken((place.start, place.end) for _, place in shared)
    for operation, place in shared:
        first, end = place.start + 1, place.start + _FLOAT
        if _may_be_float(operation, place) and end <= room and not taken.has_some_of(first, end):
            parts = {"first": first, "last": end - 1, "larger": _LARGER[operation.name]}
            yield operation.finding_of(codes.PARTLY_WRITTEN, place.argument, **parts)


def _may_be_float(operation: CheckedOperation, place: Footprint) -> bool:
    """Returns whether an operation writes a byte where the larger one of the two would write a float."""
    is_byte = operation.name in _LARGER and place.facts.is_written and place.size == 1
    return is_byte and not place.start % _FLOAT

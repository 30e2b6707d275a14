"""Sounds, drawings and moves that cut one another off, and drawings that nobody sees."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables import with_effect
from ev3proto.tables.declaration import Effect, Role

_AWAITS_SOUND = with_effect(Effect.AWAITS_SOUND)
_AWAITS_MOVE = with_effect(Effect.AWAITS_MOVE)
_SHOWS = with_effect(Effect.SHOWS)

_LOOKED_AT = frozenset((Effect.STARTS_SOUND, Effect.SHOWS, Effect.STARTS_MOVE, Effect.DRAWS))

_PORTS = 4
"""Motor ports of a brick."""


def check_effects(context: CheckContext) -> Iterator[Finding]:
    """The operations of a command in their order."""
    operations = context.operations
    present = context.effects
    if present.isdisjoint(_LOOKED_AT):
        return
    if Effect.STARTS_SOUND in present:
        yield from _sounds(operations)
    if Effect.SHOWS in present:
        yield from _pictures(operations)
    if Effect.STARTS_MOVE in present:
        yield from _moves(operations)
    if Effect.DRAWS in present and context.is_whole:
        yield from _not_shown(operations)


def _waits(operation: CheckedOperation) -> bool:
    """Whether what was begun gets some time here. A loop may be one that waits."""
    return operation.has(Effect.WAITS) or operation.facts.is_jump


def _sounds(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    playing: CheckedOperation | None = None
    for operation in operations:
        starts, ends = operation.has(Effect.STARTS_SOUND), operation.has(Effect.ENDS_SOUND)
        if playing is not None and (starts or ends):
            yield playing.finding(
                codes.SOUND_INTERRUPTED,
                f"{operation.name} at offset {operation.start} cuts this sound off as soon as it starts",
                f"put {_AWAITS_SOUND.name} (0x{_AWAITS_SOUND.opcode.number:02X}) after it, which waits until the sound"
                " has ended",
            )
        if starts:
            playing = operation
        elif ends or _waits(operation):
            playing = None


def _pictures(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """Pictures that are shown, and at once replaced by another one."""
    shown: CheckedOperation | None = None
    wiping: CheckedOperation | None = None
    is_drawn = False
    for operation in operations:
        if operation.has(Effect.SHOWS):
            if shown is not None and wiping is not None:
                yield shown.finding(
                    codes.PICTURE_REPLACED,
                    f"{wiping.name} and {operation.name} at offset {operation.start} replace this picture at once",
                    "wait in between, with TIMER_WAIT and TIMER_READY",
                )
            shown, wiping, is_drawn = (operation if is_drawn else None), None, False
        elif operation.has(Effect.WIPES) and shown is not None:
            wiping = operation
        elif _waits(operation):
            shown = None
        is_drawn = is_drawn or operation.has(Effect.DRAWS)


def _not_shown(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """What is drawn after the last UPDATE; one finding for all of it."""
    hidden: CheckedOperation | None = None
    for operation in operations:
        if operation.has(Effect.SHOWS) or operation.has(Effect.DIALOG):
            hidden = None
        elif operation.has(Effect.DRAWS):
            hidden = operation
    if hidden is not None:
        assert _SHOWS.command is not None
        code = f"{_SHOWS.opcode.number:02X}:{_SHOWS.command.number:02X}"
        yield hidden.finding(
            codes.NOT_SHOWN,
            f"{hidden.name} draws on the canvas, and nothing shows it",
            f"put {_SHOWS.name} ({code}) after the last drawing, unless a later command does that",
        )


def _moves(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    moving: dict[tuple[int, int], CheckedOperation] = {}
    for operation in operations:
        starts = operation.has(Effect.STARTS_MOVE)
        if not starts and not operation.has(Effect.STOPS_MOTORS):
            if _waits(operation):
                moving.clear()
            continue
        ports = _ports(operation)
        interrupted = {moving[port].start: moving[port] for port in ports if port in moving}
        for before in interrupted.values():
            yield before.finding(
                codes.MOVE_INTERRUPTED,
                f"{operation.name} at offset {operation.start} ends this move as soon as it starts",
                f"put {_AWAITS_MOVE.name} (0x{_AWAITS_MOVE.opcode.number:02X}) after it, which waits until the motors"
                " are done",
            )
        for port in ports:
            moving.pop(port, None)
        if starts:
            moving.update(dict.fromkeys(ports, operation))


def _ports(operation: CheckedOperation) -> list[tuple[int, int]]:
    """Layer and bit of the motors that an operation is about; none where that is not known."""
    known = {argument.parameter.role: whole_number(argument) for argument in operation.arguments}
    layer, mask = known.get(Role.LAYER), known.get(Role.MOTORS)
    if layer is None or mask is None:
        return []
    return [(layer, 1 << bit) for bit in range(_PORTS) if mask & 1 << bit]

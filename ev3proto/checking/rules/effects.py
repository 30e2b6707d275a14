"""Sounds, drawings and moves that cut one another off, and drawings that nobody sees."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.places import number_of
from ev3proto.checking.report import Finding
from ev3proto.checking.subject import Step, Subject
from ev3proto.tables import operations
from ev3proto.tables.behaviour import DIALOGUES, DRAWS, MOVES, SHOWS, SOUND_ENDS, SOUNDS, STOPS, WAITS, WIPES

_SOUND_READY = operations()["SOUND_READY"].opcode.number
_OF_INTEREST = SOUNDS | SOUND_ENDS | DRAWS | SHOWS | DIALOGUES | MOVES | STOPS


def check_effects(subject: Subject) -> Iterator[Finding]:
    """The operations of a command in their order."""
    steps = subject.steps
    if not any(step.name in _OF_INTEREST for step in steps):
        return
    yield from _sounds(steps)
    yield from _pictures(steps)
    yield from _moves(steps)
    if subject.is_whole:
        yield from _not_shown(steps)


def _waits(step: Step) -> bool:
    """Whether what was begun gets some time here. A loop may be one that waits."""
    return step.name in WAITS or step.traits.is_jump


def _sounds(steps: tuple[Step, ...]) -> Iterator[Finding]:
    playing: Step | None = None
    for step in steps:
        if playing is not None and step.name in SOUNDS | SOUND_ENDS:
            yield playing.finding(
                codes.SOUND_INTERRUPTED,
                f"{step.name} at offset {step.start} cuts this sound off as soon as it starts",
                f"put SOUND_READY (0x{_SOUND_READY:02X}) behind it, which waits until the sound has ended",
            )
        if step.name in SOUNDS:
            playing = step
        elif step.name in SOUND_ENDS or _waits(step):
            playing = None


def _pictures(steps: tuple[Step, ...]) -> Iterator[Finding]:
    """Pictures that are shown, and at once replaced by another one."""
    shown: Step | None = None
    wiping: Step | None = None
    is_drawn = False
    for step in steps:
        if step.name in SHOWS:
            if shown is not None and wiping is not None:
                yield shown.finding(
                    codes.PICTURE_REPLACED,
                    f"{wiping.name} and {step.name} at offset {step.start} replace this picture at once",
                    "wait in between, with TIMER_WAIT and TIMER_READY",
                )
            shown, wiping, is_drawn = (step if is_drawn else None), None, False
        elif step.name in WIPES and shown is not None:
            wiping = step
        elif _waits(step):
            shown = None
        is_drawn = is_drawn or step.name in DRAWS


def _not_shown(steps: tuple[Step, ...]) -> Iterator[Finding]:
    """What is drawn behind the last UPDATE; one finding for all of it."""
    hidden: Step | None = None
    for step in steps:
        if step.name in SHOWS or step.name in DIALOGUES:
            hidden = None
        elif step.name in DRAWS:
            hidden = step
    if hidden is not None:
        yield hidden.finding(
            codes.NOT_SHOWN,
            f"{hidden.name} draws on the canvas, and nothing shows it",
            "put UI_DRAW UPDATE (84:00) behind the last drawing, unless a later command does that",
        )


def _moves(steps: tuple[Step, ...]) -> Iterator[Finding]:
    moving: dict[tuple[int, int], Step] = {}
    for step in steps:
        if step.name not in MOVES and step.name not in STOPS:
            if _waits(step):
                moving.clear()
            continue
        ports = _ports(step)
        interrupted = {moving[port].start: moving[port] for port in ports if port in moving}
        for before in interrupted.values():
            yield before.finding(
                codes.MOVE_INTERRUPTED,
                f"{step.name} at offset {step.start} ends this move as soon as it starts",
                "put OUTPUT_READY (0xAA) behind it, which waits until the motors are done",
            )
        for port in ports:
            moving.pop(port, None)
        if step.name in MOVES:
            moving.update(dict.fromkeys(ports, step))


def _ports(step: Step) -> list[tuple[int, int]]:
    """Layer and bit of the motors that an operation is about; none where nobody can tell."""
    if len(step.arguments) < 2:
        return []
    layer, mask = number_of(step.arguments[0]), number_of(step.arguments[1])
    if layer is None or mask is None:
        return []
    return [(layer, 1 << bit) for bit in range(4) if mask & 1 << bit]

"""Long dialogues with a brick, one frame per TCP packet: random ones, and typical ones of programs."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace

from support.frames import Segment

import ev3proto
from benchmarks.commands import commands
from ev3proto import ops


def dialogue(count: int) -> Iterator[Segment]:
    """This number of random commands with their replies, each with its direction. Almost all are different."""
    rng = random.Random(1)
    for number, frame in enumerate(commands(count)):
        command = ev3proto.parse(frame)
        assert isinstance(command, ev3proto.DirectCommand)
        counter = number & 0xFFFF
        asked = ev3proto.direct_command(
            *command.operations,
            counter=counter,
            reply=True,
            global_size=command.global_size,
            local_size=command.local_size,
        )
        yield Segment(True, asked.build())
        yield Segment(False, ev3proto.direct_reply(rng.randbytes(command.global_size), counter=counter).build())


def unanswered(count: int) -> Iterator[Segment]:
    """Twice this number of commands without replies: as many packets as in the dialogues."""
    return (segment for segment in dialogue(2 * count) if segment.from_host)


def usual_dialogue(count: int) -> Iterator[Segment]:
    """This number of typical commands with replies: sensors, motors, the battery, now and then a new speed."""
    rng = random.Random(1)
    asked = [
        ev3proto.command(*(ops.input_readsi(0, port, 0, 0) for port in range(4))),
        ev3proto.command(*(ops.output_get_count(0, port) for port in range(4))),
        ev3proto.command(ops.ui_read.get_vbatt()),
    ]
    for number in range(count):
        counter = number & 0xFFFF
        command = rng.choice(asked)
        if rng.random() < 0.3:
            speed = rng.randint(-100, 100)
            command = ev3proto.command(ops.output_speed(0, "B+C", speed), ops.output_start(0, "B+C"), reply=True)
        yield Segment(True, replace(command, counter=counter).build())
        yield Segment(False, ev3proto.direct_reply(rng.randbytes(command.global_size), counter=counter).build())

"""A long dialogue with a brick: random commands that want a reply, each with its reply, a frame a packet of TCP."""

from __future__ import annotations

import random
from collections.abc import Iterator

from support.frames import Segment

import ev3proto
from benchmarks.commands import commands


def dialogue(count: int) -> Iterator[Segment]:
    """So many commands with their replies, and whether each comes from the host."""
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

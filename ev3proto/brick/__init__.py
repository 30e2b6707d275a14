"""A virtual brick that answers as the firmware does: `Brick` is the brick, without any sockets, on a virtual clock.

The facts it goes by are those of the firmware of 2013, version 1.04H. How operations are added is said at the head of
`ev3proto.brick.handlers`.
"""

from ev3proto.brick.brick import Brick

__all__ = ["Brick"]

"""A virtual brick that answers like the firmware: `Brick` is the brick, without sockets, on a virtual clock.

It follows the firmware of 2013, version 1.04H. `ev3proto.brick.handlers` explains how to add operations.
"""

from ev3proto.brick.brick import Brick

__all__ = ["Brick"]

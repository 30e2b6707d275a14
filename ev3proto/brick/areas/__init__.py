"""What every operation does, one function an operation, in files by the firmware's areas.

Importing this package registers them all. A new file is imported here.
"""

from ev3proto.brick.areas import move, programs

__all__ = ["move", "programs"]

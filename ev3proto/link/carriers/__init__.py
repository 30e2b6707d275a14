"""The carriers of frames to a brick, a module each, and the module that opens the right one.

They do not know commands and replies. Packages that only one carrier needs are imported by it alone.
"""

from ev3proto.link.carriers.opening import open_wire
from ev3proto.link.carriers.wire import Wire

__all__ = ["Wire", "open_wire"]

"""The carriers of frames to a brick, a module each, and the module that opens the right one.

They know nothing of commands and replies. Packages that only one carrier needs are imported only by it.
"""

from ev3proto.link.carriers.opening import open_wire
from ev3proto.link.carriers.wire import Wire

__all__ = ["Wire", "open_wire"]

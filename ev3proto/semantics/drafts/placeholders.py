"""Variables whose place in memory is not chosen by the one who writes them down, but by `command`.

    speed = ev3proto.Local()
    ev3proto.command(ops.output_read(0, 0, speed=speed), ops.output_power(0, 2, speed), ops.output_start(0, 2))

The same object is the same variable in every operation of a command. Its size and alignment follow from what the
operations do with it; where the size does not follow from them (texts without a length), it must be given.
"""

from __future__ import annotations

from ev3proto.errors import BuildError
from ev3proto.tables.encoding import GLOBAL, LOCAL


class Placeholder:
    """A variable without an index yet; made by `Local` and `Global`.

    scope    "local" or "global"
    size     bytes it takes, None where the operations tell
    handle   this use of it is marked: it holds a handle to a memory object
    address  this use of it is marked: it holds an absolute address
    origin   the variable that this is a marked use of; itself where it has no mark
    """

    __slots__ = ("address", "handle", "origin", "scope", "size")

    def __init__(
        self,
        scope: str,
        size: int | None = None,
        *,
        handle: bool = False,
        address: bool = False,
        origin: Placeholder | None = None,
    ) -> None:
        if size is not None and (isinstance(size, bool) or not isinstance(size, int) or size < 1):
            raise BuildError(f"the size of a variable must be a number of bytes, 1 or more, not {size!r}")
        self.scope = scope
        self.size = size
        self.handle = handle
        self.address = address
        self.origin = self if origin is None else origin

    def as_handle(self) -> Placeholder:
        """The same variable where an operation is to take it as a handle to a memory object, as `HND(...)` does."""
        return Placeholder(self.scope, self.size, handle=True, origin=self.origin)

    def as_address(self) -> Placeholder:
        """The same variable where an operation is to take it as an absolute address, as `ADR(...)` does."""
        return Placeholder(self.scope, self.size, address=True, origin=self.origin)

    def __repr__(self) -> str:
        size = "" if self.size is None else str(self.size)
        mark = ".as_handle()" if self.handle else ".as_address()" if self.address else ""
        return f"{'Global' if self.scope == GLOBAL else 'Local'}({size}){mark}"


def Local(size: int | None = None) -> Placeholder:  # noqa: N802 - stands beside LV
    """A new local variable, for what one operation hands to another.

    Args:
        size: Bytes, 1 or more; omitted where the operations tell, as all do but those with texts without a length.

    Raises:
        BuildError: It is another size.
    """
    return Placeholder(LOCAL, size)


def Global(size: int | None = None) -> Placeholder:  # noqa: N802 - stands beside GV
    """A new global variable: the reply carries it.

    Args:
        size: Bytes, 1 or more; omitted where the operations tell, as all do but those with texts without a length.

    Raises:
        BuildError: It is another size.
    """
    return Placeholder(GLOBAL, size)

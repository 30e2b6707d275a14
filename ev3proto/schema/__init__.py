"""Bytes to messages and back.

`FRAME` and `OPERATIONS` declare the wire format of LEGO's firmware in Construct's own words, complete for parsing and
building; `declared` has those of the other dialects. The readers and writers of this package are its fast form.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from construct import Construct

    from ev3proto.schema.wire_format import WireFormat

    FRAME: Construct
    OPERATIONS: dict[str, Construct]

__all__ = ["FRAME", "OPERATIONS", "declared"]


def declared(dialect: str = "official") -> WireFormat:
    """Returns the wire format of a dialect, declared in Construct; created once.

    Args:
        dialect: "official", "xtended" or "compat".

    Returns:
        FRAME, the Construct of a frame, and OPERATIONS, those of the arguments of each operation, by its name.

    Raises:
        ValueError: The dialect is unknown.
    """
    from ev3proto.schema.argument import shortest  # 30 ms with construct and the tables
    from ev3proto.schema.wire_format import wire_format

    return wire_format(dialect, shortest)


def __getattr__(name: str) -> Any:
    """Creates FRAME and OPERATIONS on first use: that takes 20 ms."""
    if name not in ("FRAME", "OPERATIONS"):
        raise AttributeError(f"module 'ev3proto.schema' has no attribute {name!r}")
    return getattr(declared(), name)

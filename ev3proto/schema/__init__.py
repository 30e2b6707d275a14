"""The wire format in Construct (`FRAME`, `OPERATIONS`), and the readers and writers of messages, its fast form."""

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

    `FRAME` and `OPERATIONS` of this module are those of LEGO's firmware. They are complete, for parsing and building;
    `ev3proto.parse` and the rest use readers and writers that are much faster, held to them by tests.

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


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

"""What tshark is asked to print of each packet, and how to read it."""

from __future__ import annotations

from ev3proto.capture.record import NANOSECONDS

FIELDS = (
    "frame.number",
    "frame.time_epoch",
    "frame.len",
    "frame.cap_len",
    "frame.interface_name",
    "frame.protocols",
    "ev3.bytes",
)
"""What is printed of every packet; each carrier has further fields."""

_NAMELESS = "unknown"
"""What Wireshark calls an interface without a name."""


class Row:
    """The fields of one packet, each with all its values in their order, innermost last."""

    __slots__ = ("_values", "protocols")

    def __init__(self, values: dict[str, list[str]]) -> None:
        self._values = values
        self.protocols = (self.text("frame.protocols") or "").split(":")

    def all(self, field: str) -> list[str]:
        """All values of a field, none where the packet has none."""
        return self._values.get(field.replace(".", "_"), [])

    def text(self, field: str) -> str | None:
        """The innermost value of a field."""
        values = self._values.get(field.replace(".", "_"))
        return values[-1] if values else None

    def number(self, field: str) -> int | None:
        """The same as a number."""
        text = self.text(field)
        return None if text is None else int(text, 0)

    def numbers(self, field: str) -> list[int]:
        """All values of a field as numbers."""
        return [int(text, 0) for text in self.all(field)]

    def bytes(self, field: str) -> list[bytes]:
        """All values of a field that are bytes."""
        return [bytes.fromhex(text.replace(":", "")) for text in self.all(field)]

    @property
    def packet(self) -> int:
        """The packet's number."""
        return self.number("frame.number") or 0

    @property
    def time_ns(self) -> int:
        """When it was captured, in nanoseconds since 1970-01-01 UTC."""
        seconds, _, fraction = (self.text("frame.time_epoch") or "0").partition(".")
        nanoseconds = int(fraction[:9].ljust(9, "0"))
        return int(seconds) * NANOSECONDS + (-nanoseconds if seconds.startswith("-") else nanoseconds)

    @property
    def captured(self) -> int:
        """How many bytes of it were captured."""
        return self.number("frame.cap_len") or 0

    @property
    def missing(self) -> int:
        """How many bytes of it were not captured."""
        return max((self.number("frame.len") or 0) - self.captured, 0)

    @property
    def interface(self) -> str | None:
        """The name of its interface."""
        name = self.text("frame.interface_name")
        return None if name == _NAMELESS else name

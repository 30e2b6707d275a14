"""Where every captured byte went, so that nothing is dropped in silence."""

from __future__ import annotations

from dataclasses import dataclass, field, fields


@dataclass(slots=True)
class Account:
    """What became of the captured bytes of all packets; the parts add up to `captured`.

    packets   packets in the file
    captured  bytes of them in the file
    first_ns  when the first packet was captured, in nanoseconds since 1970-01-01 UTC; None where there is none
    last_ns   when the last one was
    forgotten  commands and other things that were no longer waited for, because all that waited took too much memory
    cut       packets of which not all bytes were captured
    packed    packets that the built-in engine does not take apart, by what they are packed into, such as "VXLAN"
    frames    bytes of frames
    texts     bytes of beacons, unlock texts and the answers to them
    padding   bytes after the frame in USB reports, and polls between the frames of a stream
    headers   bytes of what carries frames: Ethernet, IP, TCP, USB and Bluetooth headers
    repeated  bytes that were sent again
    other     bytes of packets that have nothing to do with a brick
    skipped   bytes among frames that could not be read
    """

    packets: int = 0
    captured: int = 0
    first_ns: int | None = None
    last_ns: int | None = None
    forgotten: int = 0
    cut: int = 0
    packed: dict[str, int] = field(default_factory=dict)
    frames: int = 0
    texts: int = 0
    padding: int = 0
    headers: int = 0
    repeated: int = 0
    other: int = 0
    skipped: int = 0

    @property
    def parts(self) -> dict[str, int]:
        """The bytes of each part by its name."""
        return {each.name: getattr(self, each.name) for each in fields(self)[7:]}

    def meet_packed(self, name: str) -> None:
        """Counts a packet that has others in it, which are not taken apart, by what they are packed into."""
        self.packed[name] = self.packed.get(name, 0) + 1

    def add(self, other: Account) -> None:
        """Adds what became of the bytes of another capture."""
        for each in fields(self):
            if each.name not in ("first_ns", "last_ns", "packed"):
                setattr(self, each.name, getattr(self, each.name) + getattr(other, each.name))
        for name, count in other.packed.items():
            self.packed[name] = self.packed.get(name, 0) + count
        self.first_ns = min((ns for ns in (self.first_ns, other.first_ns) if ns is not None), default=None)
        self.last_ns = max((ns for ns in (self.last_ns, other.last_ns) if ns is not None), default=None)

    @property
    def balance(self) -> int:
        """Captured bytes that stand in no part: 0 once all was read."""
        return self.captured - sum(self.parts.values())

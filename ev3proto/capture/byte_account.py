"""The account of all captured bytes, so that none is dropped silently."""

from __future__ import annotations

from dataclasses import dataclass, field, fields

from ev3proto.errors import counted

ACCESSORY = "in Apple's accessory protocol (iAP), in which iPhones and iPads speak to a brick,"
"""The place of packets that are known, and not read."""


_MOST_PORTS = 64
"""Maximum number of other TCP ports whose packets are counted."""

_TELLING = 2
"""Number of commands on another port that cannot be coincidence."""


@dataclass(slots=True)
class Account:
    """The captured bytes of all packets by kind; the kinds add up to `captured`.

    packets    packets in the file
    captured   their bytes in the file
    first_ns   the first packet's time, in nanoseconds since 1970-01-01 UTC; None without packets
    last_ns    the last packet's time
    forgotten  pending commands and bytes that were evicted at the memory limit
    cut        packets of which some bytes were not captured
    strange    unrecognised packets in a brick's usual place, such as "on TCP port 5555", by that place
    elsewhere  packets that are an EV3's command each, by the TCP port that they went to and that is not read
    frames     bytes of frames
    texts      bytes of beacons, unlock texts and their answers
    padding    bytes after the frame in USB reports, and polls between the frames of a stream
    headers    bytes of the headers before frames: Ethernet, IP, TCP, USB, Bluetooth
    repeated   bytes of retransmissions
    other      bytes of packets unrelated to bricks
    skipped    bytes among frames that could not be read
    """

    packets: int = 0
    captured: int = 0
    first_ns: int | None = None
    last_ns: int | None = None
    forgotten: int = 0
    cut: int = 0
    strange: dict[str, int] = field(default_factory=dict)
    elsewhere: dict[int, int] = field(default_factory=dict)
    frames: int = 0
    texts: int = 0
    padding: int = 0
    headers: int = 0
    repeated: int = 0
    other: int = 0
    skipped: int = 0

    @property
    def parts(self) -> dict[str, int]:
        """The bytes of each kind by its name."""
        return {name: getattr(self, name) for name in _PARTS}

    @property
    def passed_over(self) -> str:
        """Which packets may have frames that were not found, for messages; empty if none has."""
        said = ""
        for place, count in self.strange.items():
            was, them = ("was", "it as it is") if count == 1 else ("were", "them as they are")
            option = f"--port {place.rpartition(' ')[2]}" if "TCP" in place else "--all"
            reason = f"{was} not recognised; {option} shows {them}"
            if place == ACCESSORY:
                reason = f"{was} not read; --engine wireshark does not know the messages in it either"
            said += f"; {counted(count, 'packet')} {place} {reason}"
        for port, count in self.elsewhere.items() if not self.frames else ():
            said += f"; TCP port {port} has frames of an EV3; --port {port} shows them" if count >= _TELLING else ""
        if self.cut:
            said += f"; of {counted(self.cut, 'packet')} only the first bytes were captured (snap length)"
        return said

    def count_packet(self, time_ns: int, captured: int, size: int) -> None:
        """Counts a packet, of whose bytes a number was captured."""
        if self.first_ns is None:
            self.first_ns = time_ns
        self.last_ns = time_ns
        self.packets += 1
        self.captured += captured
        self.cut += captured < size

    def count_strange(self, place: str, count: int = 1) -> None:
        """Counts packets that were not recognised, by their place; a negative number for those that are now."""
        self.strange[place] = self.strange.get(place, 0) + count
        if not self.strange[place]:
            del self.strange[place]

    def count_elsewhere(self, port: int) -> None:
        """Counts a packet that is an EV3's command, by the port that it went to."""
        if port in self.elsewhere or len(self.elsewhere) < _MOST_PORTS:
            self.elsewhere[port] = self.elsewhere.get(port, 0) + 1

    def add(self, other: Account) -> None:
        """Adds the account of another capture."""
        for each in fields(self):
            if each.name not in ("first_ns", "last_ns", "strange", "elsewhere"):
                setattr(self, each.name, getattr(self, each.name) + getattr(other, each.name))
        for place, count in other.strange.items():
            self.count_strange(place, count)
        for port, count in other.elsewhere.items():
            self.elsewhere[port] = self.elsewhere.get(port, 0) + count
        self.first_ns = min((ns for ns in (self.first_ns, other.first_ns) if ns is not None), default=None)
        self.last_ns = max((ns for ns in (self.last_ns, other.last_ns) if ns is not None), default=None)

    @property
    def balance(self) -> int:
        """Captured bytes of no kind: 0 once everything was read."""
        return self.captured - sum(self.parts.values())


_PARTS = ("frames", "texts", "padding", "headers", "repeated", "other", "skipped")
"""The fields that count the bytes of one kind each; together they are all bytes of a capture."""

"""Captures that tshark takes apart: `read` runs it; the rest is for programs that read or capture with pyshark.

    import pyshark
    import ev3proto.pyshark

    packets = pyshark.FileCapture("robot.pcapng", custom_parameters=ev3proto.pyshark.parameters())
    for packet in packets:
        for record in ev3proto.pyshark.messages(packet):
            print(packet.number, record.message, record.values)

The same goes for `LiveCapture`. This needs `pip install 'ev3proto[wireshark]'` and tshark.
"""

from __future__ import annotations

import json
from collections.abc import Collection
from contextlib import ExitStack
from typing import Any

from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Record
from ev3proto.capture.wireshark.events import Events, fields
from ev3proto.capture.wireshark.pyshark_packets import frame_of, row_of
from ev3proto.pyshark.program import Program
from ev3proto.pyshark.reading import read
from ev3proto.tables import check_dialect
from ev3proto.tables.discovery import TCP_PORT

__all__ = ["Messages", "messages", "parameters", "read"]

_KEPT = ExitStack()
"""The dissector's file, which is there as long as the program runs."""


def parameters(
    *,
    dialect: str = "official",
    ports: Collection[int] = (TCP_PORT,),
    tshark: str | None = None,
    use_ek: bool = False,
) -> list[str]:
    """What pyshark is to give to tshark, so that it has the dissector, installed or not.

    Args:
        dialect: The firmware whose instruction set to read by.
        ports: TCP ports on which bricks listen.
        tshark: Path of the tshark that pyshark uses (its `tshark_path`), where it is not on the path.
        use_ek: Whether pyshark uses it, too. By itself it does not know the fields of a dissector in Lua in that
            mode, and raises when one is asked for. This tells it.

    Returns:
        Words for `custom_parameters` of `pyshark.FileCapture` and `pyshark.LiveCapture`.

    Raises:
        ev3proto.capture.CaptureError: There is no tshark that can be used.
        ValueError: The dialect is not known.
    """
    program = Program(tshark)
    words = _KEPT.enter_context(program.words(check_dialect(dialect), ports))
    if use_ek:
        import pyshark.ek_field_mapping  # an extra; without `use_ek` only the caller needs it

        said = json.loads(program.ask("-G", "elastic-mapping", *words), object_pairs_hook=_merged)
        known = said["mappings"]["properties"]["layers"]["properties"]
        # There is no public way: pyshark itself asks tshark without the parameters that a capture has.
        pyshark.ek_field_mapping.MAPPING._protocol_to_mapping = known
    return words


def _merged(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of tshark's JSON, in which a protocol may come twice, once without fields."""
    found: dict[str, Any] = {}
    for name, value in pairs:
        if name not in found or value != {"properties": {}}:
            found[name] = value
    return found


class Messages:
    """The messages of one capture, packet by packet. Call it with each packet, in their order.

    Args of a call: a packet of pyshark. It returns the records of the frames that end in that packet.
    """

    def __init__(self, *, dialect: str = "official", ports: Collection[int] = (TCP_PORT,)) -> None:
        """Starts before the first packet.

        Args:
            dialect: The firmware whose instruction set to read by.
            ports: TCP ports on which bricks listen.

        Raises:
            ValueError: The dialect is not known.
        """
        self._events = Events(Account(), check_dialect(dialect), ports)
        self._names = fields()
        self.last_packet = 0

    def __call__(self, packet: Any) -> list[Record]:
        """The records of the frames that end in a packet, each with the record of the command that it answers."""
        row = row_of(packet, self._names)
        self.last_packet = row.packet
        return [event for event in self._events.events(row) if isinstance(event, Record)]


_default = Messages()


def messages(packet: Any) -> list[Record]:
    """The messages that end in a packet, each linked to its command.

    Give it every packet of one capture after the other, in their order. It starts anew with a packet whose number is
    not higher than the last one's. For captures at the same time, or another dialect, make a `Messages` for each.

    Args:
        packet: A packet of pyshark, in its XML or EK mode, captured with `parameters()`.

    Returns:
        A record for each frame: its `message`, for a reply its `values` and `request`, the record of the command.

    Raises:
        TypeError: It is no packet of pyshark.
    """
    global _default
    if int(frame_of(packet).number) <= _default.last_packet:
        _default = Messages()
    return _default(packet)

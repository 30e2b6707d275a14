"""Packets of pyshark as events, for programs that have pyshark read or capture. Only its public ways are used."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import Any

from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Event
from ev3proto.capture.wireshark.events import Events, fields
from ev3proto.capture.wireshark.row import Row

_LOOSE = "DATA"
"""What pyshark calls a layer of fields that stand beside the tree of their protocol, such as those of reassembly."""


def pyshark_events(
    packets: Iterable[Any], account: Account, *, dialect: str, ports: Collection[int]
) -> Iterator[Event]:
    """Everything in the packets of a capture of pyshark; `from_pyshark` says what is needed for that."""
    making = Events(account, dialect, ports)
    names = fields()
    for packet in packets:
        yield from making.events(_row(packet, names))
    yield from making.end()


def _row(packet: Any, names: Iterable[str]) -> Row:
    values: dict[str, list[str]] = {}
    for layer in (packet.frame_info, *packet.layers):
        for field in names:
            is_here = layer.layer_name in (field.partition(".")[0], _LOOSE)
            found = layer.get_field(field) if is_here else None
            if found is not None:
                values.setdefault(field.replace(".", "_"), []).extend(each.show for each in found.all_fields)
    return Row(values)

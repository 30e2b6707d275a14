"""Packets of pyshark as events, for programs that have pyshark read or capture. Only its public ways are used."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from datetime import UTC, datetime
from typing import Any

from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Event
from ev3proto.capture.wireshark.events import Events, fields
from ev3proto.capture.wireshark.row import Row

_LOOSE = "DATA"
"""What pyshark calls a layer of fields that stand beside the tree of their protocol, such as those of reassembly."""

_MOMENT = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z?")


def pyshark_events(
    packets: Iterable[Any], account: Account, *, dialect: str, ports: Collection[int]
) -> Iterator[Event]:
    """Everything in the packets of a capture of pyshark; `from_pyshark` says what is needed for that."""
    making = Events(account, dialect, ports)
    names = fields()
    for packet in packets:
        yield from making.events(row_of(packet, names))
    yield from making.end()


def row_of(packet: Any, names: Iterable[str]) -> Row:
    """The fields of a packet.

    Args:
        packet: Of pyshark, in its XML or EK mode.
        names: The fields, as tshark calls them.

    Returns:
        Those that the packet has.

    Raises:
        TypeError: It is no packet of pyshark.
    """
    layers = (frame_of(packet), *packet.layers)
    is_ek = not hasattr(layers[0], "_all_fields")
    read = _ek_values if is_ek else _xml_values
    values: dict[str, list[str]] = {}
    for layer in layers:
        for field in names:
            if layer.layer_name in (field.partition(".")[0], _LOOSE):
                found = read(layer, field)
                if found:
                    values.setdefault(field.replace(".", "_"), []).extend(found)
    return Row(values)


def frame_of(packet: Any) -> Any:
    """The layer of a packet that says when it came, and which number it has.

    Args:
        packet: Of pyshark.

    Returns:
        The layer.

    Raises:
        TypeError: It is no packet of pyshark.
    """
    frame = getattr(packet, "frame_info", None)
    if frame is None:
        raise TypeError(f"a packet is one that pyshark gives, such as those of a FileCapture, not {packet!r}")
    return frame


def _xml_values(layer: Any, field: str) -> list[str]:
    found = layer.get_field(field)
    return [] if found is None else [each.show for each in found.all_fields]


def _ek_values(layer: Any, field: str) -> list[str]:
    # Its public ways fail where a protocol comes twice in a packet, as RFCOMM does.
    parts = layer._fields_dict
    name = f"{layer.layer_name}_{field.replace('.', '_')}"
    found = [part[name] for part in (parts if isinstance(parts, list) else [parts]) if name in part]
    return [_ek_text(each) for value in found for each in (value if isinstance(value, list) else [value])]


def _ek_text(value: Any) -> str:
    """A value as XML has it: a truth as a number, a moment in seconds."""
    if isinstance(value, bool) or value in ("true", "false"):
        return str(int(value in (True, "true")))
    text = str(value)
    if _MOMENT.fullmatch(text):
        moment, _, fraction = text.removesuffix("Z").partition(".")
        return f"{int(datetime.fromisoformat(moment).replace(tzinfo=UTC).timestamp())}.{fraction}"
    return text

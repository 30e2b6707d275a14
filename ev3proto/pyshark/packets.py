"""Access to the fields of a pyshark packet, by its public interface where possible."""

from __future__ import annotations

from typing import Any

from ev3proto.pyshark.events import FIELDS, Row


def frame_of(packet: Any) -> Any:
    """Returns the layer with a packet's time and number. Raises TypeError."""
    frame = getattr(packet, "frame_info", None)
    if frame is None:
        raise TypeError(f"expected a packet of pyshark, such as those of a FileCapture, not {packet!r}")
    return frame


def row_of(packet: Any) -> Row:
    """Returns the fields of a packet in pyshark's XML or EK mode. Raises TypeError."""
    layers = (frame_of(packet), *packet.layers)
    read = _xml_values if hasattr(layers[0], "_all_fields") else _ek_values
    values: dict[str, list[str]] = {}
    for layer in layers:
        for field in FIELDS:
            found = read(layer, field) if layer.layer_name == field.partition(".")[0] else []
            if found:
                values.setdefault(field.replace(".", "_"), []).extend(found)
    return Row(values)


def _xml_values(layer: Any, field: str) -> list[str]:
    found = layer.get_field(field)
    return [] if found is None else [each.show for each in found.all_fields]


def _ek_values(layer: Any, field: str) -> list[str]:
    # The public interface fails if a protocol occurs twice in a packet, as RFCOMM does.
    parts = layer._fields_dict
    name = f"{layer.layer_name}_{field.replace('.', '_')}"
    found = [part[name] for part in (parts if isinstance(parts, list) else [parts]) if name in part]
    return [_ek_text(each) for value in found for each in (value if isinstance(value, list) else [value])]


def _ek_text(value: Any) -> str:
    """Returns a value as in XML mode: booleans as numbers."""
    return str(int(value in (True, "true"))) if value in (True, False, "true", "false") else str(value)

"""What is said to a name that filters do not have: the name that was meant, as far as one can tell."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from ev3proto.capture.filter.fields import (
    ANY,
    command_names,
    find_fields,
    is_parameter,
    operation_names,
    parameter_names,
)

_OF_WIRESHARK = {
    "op": "_ws.col.info ev3.answers ev3.cmd ev3.op ev3.opcode",
    "fault": "_ws.expert _ws.malformed ev3.expert.fault ev3.expert.unknown_opcode",
    "peer": "btatt.handle bluetooth.addr ip.addr ipv6.addr tcp.port usb.addr usb.bus_id usb.device_address",
    "target": "bluetooth.dst ip.dst ipv6.dst",
    "source": "bluetooth.src ip.src ipv6.src",
    "type": "ev3.cmd_type ev3.type",
    "counter": "ev3.counter ev3.msg_num",
    "command": "ev3.daisy.command ev3.sys_cmd",
    "failed": "ev3.expert.error_reply",
    "orphan": "ev3.expert.orphan",
    "unanswered": "ev3.expert.unanswered",
    "latency": "ev3.latency ev3.request_in ev3.response_in ev3.response_time frame.time_delta",
    "size": "ev3.msg_len ev3.length frame.len",
    "status": "ev3.reply_status ev3.status",
    "path": "ev3.transfer.path",
    "interface": "frame.interface_name",
    "packet": "frame.number",
    "time": "frame.time frame.time_relative",
}
"""The fields of Wireshark to which a name here comes nearest."""

OF_WIRESHARK = {field: name for name, fields in _OF_WIRESHARK.items() for field in fields.split()}

_PREFIX = "ev3."

_LIKENESS = 0.6
"""How like another a name must be to be named instead of it, from 0 to 1."""


def unknown(text: str, names: Iterable[str]) -> str:
    """A sentence about a name that there is not.

    Args:
        text: The name as it was written.
        names: What can be asked about every frame.
    """
    lower = text.lower()
    field = OF_WIRESHARK.get(lower) or _parameter(lower.removeprefix(_PREFIX) if lower.startswith(_PREFIX) else "")
    if field is not None:
        return f"{text} is a name of Wireshark: here it is {field}"
    owner, _, name = text.upper().rpartition(".")
    if owner in operation_names() and is_parameter(name):
        return f"{owner} has no parameter {name}"
    if text.upper() in operation_names():
        return f"{text} is an operation, which is asked for so: op=={text.upper()}"
    if text.upper() in command_names():
        return f"{text} is a command, which is asked for so: command=={text.upper()}"
    near = _near(lower.rpartition(".")[2], (*parameter_names(), *names))
    if owner and owner.lower() != ANY and is_parameter(name):
        owners = [found for found in _near(owner.lower(), operation_names()) if find_fields(f"{found}.{name}".lower())]
        near = [f"{found}.{name}" for found in owners] or near
    near = [found for found in near if found.lower() != lower]
    hint = f"did you mean {' or '.join(near)}?" if near else "--help-filter lists the names that there are"
    return f"nothing is called {text}: {hint}"


def _near(lower: str, known: Iterable[str]) -> list[str]:
    by_lower = {name.lower(): name for name in known}
    return [by_lower[found] for found in difflib.get_close_matches(lower, by_lower, 3, _LIKENESS)]


def _parameter(dotted: str) -> str | None:
    """`SOUND.TONE.FREQUENCY` for `sound.tone.frequency`; None for what is no parameter of an operation."""
    owner, _, name = dotted.rpartition(".")
    if is_parameter(name) and (not owner or owner.upper() in operation_names()):
        return dotted.upper() if owner else name
    return None

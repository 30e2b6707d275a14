"""A configuration profile for Wireshark: columns and colours for a dialogue with a brick.

A profile is a folder with files in Wireshark's own formats. When a user changes a setting, Wireshark rewrites the
file without our first line; the checksum in that line tells whether a file is still as ev3proto wrote it.
"""

from __future__ import annotations

import hashlib
from typing import NamedTuple

from ev3proto.tables import AREAS
from ev3proto.tables.frame import TYPES_BY_KIND, MessageType

NAME = "EV3"

_MARK = "# Made by ev3proto dissector install --profile; checksum of what follows: "


class Column(NamedTuple):
    """A column of the packet list: its title, Wireshark's format of its contents, and its width in pixels."""

    title: str
    format: str
    width: int = 100


COLUMNS = (
    Column("No.", "%m", 50),
    Column("Time", "%t", 90),
    Column("Source", "%s", 110),
    Column("Destination", "%d", 110),
    Column("Protocol", "%p", 60),
    Column("Length", "%L", 50),
    Column("Counter", "%Cus:ev3.msg_num:0:R", 60),
    Column("Response time", "%Cus:ev3.response_time:0:R", 100),
    Column("Info", "%i", 900),
)


_DIRECT_COMMANDS = ", ".join(f"{member:d}" for member in TYPES_BY_KIND["direct-command"])


class Rule(NamedTuple):
    """A colouring rule: packets that match the filter get these colours, written as in HTML."""

    name: str
    filter: str
    background: str
    foreground: str = "12272e"


RULES = (
    Rule(
        "EV3: refused or failed",
        "ev3.expert.error_reply || ev3.expert.failed",
        "f4a9a3",
        "5c0000",
    ),
    Rule(
        "EV3: fault",
        "ev3.expert.fault || ev3.expert.cut_off || ev3.expert.no_boundary || ev3.expert.unknown_opcode"
        " || ev3.expert.unknown_cmd || ev3.expert.bootloader_fault || ev3.expert.misaligned || ev3.expert.refused",
        "a40000",
        "ffffff",
    ),
    Rule(
        "EV3: doubtful",
        "ev3.expert.misread || ev3.expert.beyond_memory || ev3.expert.orphan || ev3.expert.unanswered"
        " || ev3.expert.unsure || ev3.expert.waiting || ev3.expert.incomplete_file",
        "fce2a9",
    ),
    Rule("Bad TCP", "tcp.analysis.flags && !tcp.analysis.window_update", "12272e", "f78787"),
    Rule("EV3: file transfer", "ev3.transfer.path", "e3dbf3"),
    Rule("EV3: system command", "ev3.sys_cmd", "d3ddf2"),
    Rule("EV3: daisy chain", "ev3.daisy.layer_to", "ece7d4"),
    Rule("EV3: reply", f"ev3.cmd_type == {MessageType.DIRECT_REPLY:d}", "dcf0d9"),
    Rule("EV3: direct command", f"ev3.cmd_type in {{{_DIRECT_COMMANDS}}}", "d8eef6"),
    Rule("EV3: beacon and unlocking", "ev3.beacon.serial || ev3.beacon.answer || ev3.unlock || ev3.accept", "f3eef8"),
    Rule("EV3: part of a frame", "ev3.fragment", "ffffff"),
    Rule("Not EV3", "frame", "ffffff", "6b7072"),
)
"""The first rule that matches gives the colours."""


# Not all of _ws.expert: in a capture begun after the Bluetooth connection, Wireshark complains about each packet.
_TROUBLE = " || ".join(rule.filter for rule in RULES if "ev3.expert." in rule.filter)

BUTTONS = (
    ("EV3 only", "ev3", "no bare ACKs, keep-alives or USB enumeration"),
    ("Trouble", _TROUBLE, "everything wrong, refused, failed or doubtful"),
    ("Replies", "ev3.response_time", "replies whose commands were captured"),
    ("Slow", "ev3.response_time > 0.05", "replies that took longer than 50 ms"),
    ("Files", "ev3.transfer.path", "transfers of files and listings"),
    ("Motors", f"ev3.op in {{{', '.join(str(opcode.number) for opcode in AREAS['output'])}}}", "commands for motors"),
)
"""Buttons in the filter toolbar: label, filter, comment."""


def files() -> dict[str, str]:
    """Returns the files of the profile: name and text."""
    return {
        "preferences": _signed(_preferences()),
        "colorfilters": _signed(_colours()),
        "dfilter_buttons": _signed(_buttons()),
        "recent": _signed(_recent()),
    }


def is_unchanged(text: str) -> bool:
    """Tells whether a file of the profile is unchanged since some version of ev3proto wrote it."""
    head, _, body = text.partition("\n")
    return head.startswith(_MARK) and head.removeprefix(_MARK).strip() == _checksum(body)


def _signed(body: str) -> str:
    return f"{_MARK}{_checksum(body)}\n{body}"


def _checksum(body: str) -> str:
    return hashlib.sha256(body.encode()).hexdigest()[:16]


def _preferences() -> str:
    columns = ",\n".join(f'\t"{column.title}", "{column.format}"' for column in COLUMNS)
    return f"""\
gui.column.format:
{columns}
"""


def _recent() -> str:
    """Returns the widths of the columns, by which the info column begins left of the middle."""
    widths = ",\n".join(f'\t"{column.format}", {column.width}' for column in COLUMNS)
    return f"""\
column.width:
{widths}
"""


def _colours() -> str:
    return "".join(
        f"@{rule.name}@{rule.filter}@[{_numbers(rule.background)}][{_numbers(rule.foreground)}]\n" for rule in RULES
    )


def _buttons() -> str:
    return "".join(f'"TRUE","{label}","{text}","{shows}"\n' for label, text, shows in BUTTONS)


def _numbers(colour: str) -> str:
    """Returns red, green and blue in 16 bits each."""
    return ",".join(str(byte * 0x101) for byte in bytes.fromhex(colour))

"""What bytes and lines are that are not frames of an EV3: telegrams of other bricks, the WiFi handshake, text."""

from __future__ import annotations

import re

from ev3proto.schema.header import frame_size
from ev3proto.text.paste.frames import is_prose

_NXT_DIRECT = {
    0x00: ("STARTPROGRAM", 22),
    0x01: ("STOPPROGRAM", 2),
    0x02: ("PLAYSOUNDFILE", 23),
    0x03: ("PLAYTONE", 6),
    0x04: ("SETOUTPUTSTATE", 12),
    0x05: ("SETINPUTMODE", 5),
    0x06: ("GETOUTPUTSTATE", 3),
    0x07: ("GETINPUTVALUES", 3),
    0x08: ("RESETINPUTSCALEDVALUE", 3),
    0x0A: ("RESETMOTORPOSITION", 4),
    0x0B: ("GETBATTERYLEVEL", 2),
    0x0C: ("STOPSOUNDPLAYBACK", 2),
    0x0D: ("KEEPALIVE", 2),
    0x0E: ("LSGETSTATUS", 3),
    0x10: ("LSREAD", 3),
    0x11: ("GETCURRENTPROGRAMNAME", 2),
    0x13: ("MESSAGEREAD", 5),
}
_NXT_SYSTEM = {
    0x80: ("OPENREAD", 22),
    0x81: ("OPENWRITE", 26),
    0x82: ("READ", 5),
    0x84: ("CLOSE", 3),
    0x85: ("DELETE", 22),
    0x86: ("FINDFIRST", 22),
    0x87: ("FINDNEXT", 3),
    0x88: ("GETFIRMWAREVERSION", 2),
    0x98: ("SETBRICKNAME", 18),
    0x9B: ("GETDEVICEINFO", 2),
}
"""The commands of LEGO's NXT, with the bytes of their telegrams."""

_NXT = {0x00: _NXT_DIRECT, 0x80: _NXT_DIRECT, 0x01: _NXT_SYSTEM, 0x81: _NXT_SYSTEM}
_NXT_LENGTHS = {0x09: ("MESSAGEWRITE", 4, 3), 0x0F: ("LSWRITE", 5, 3)}
"""Those with contents: the bytes in front of these, and the place of their length."""

_LEAST_NXT_WITHOUT_LENGTH = 5
_HUB_MESSAGES = frozenset(
    (*range(0x01, 0x09), *range(0x10, 0x14), *range(0x21, 0x25), *range(0x41, 0x49), 0x61, 0x81, 0x82)
)
"""The types of messages of LEGO's Wireless Protocol 3.0."""
_LEAST_HUB_MESSAGE = 5
_LEAST_PROSE = 8
_SHOWN = 24

_HANDSHAKE = (
    "this is the text that unlocks a brick on WiFi, not a frame; frames follow the brick's answer, Accept:EV340"
)
_TEXTS = (
    (re.compile(r"GET /target\?sn=|Accept:\s?EV340|VMTP1\.0"), _HANDSHAKE),
    (
        re.compile(
            r"47\W{0,4}(?:0x)?45\W{0,4}(?:0x)?54\W{0,4}(?:0x)?20\W{0,4}(?:0x)?2f\W{0,4}(?:0x)?74", re.IGNORECASE
        ),
        _HANDSHAKE,
    ),
    (
        re.compile(r"0000162[34]-1212-efde-162[34]-785feabcd123", re.IGNORECASE),
        "this is about LEGO's Wireless Protocol, for hubs with Bluetooth Low Energy; an EV3 does not have it",
    ),
    (
        re.compile(r"c5f5000[1-3]-8280-46da-89f4-6d8051e4aeef|\b(?:from|import) pybricks\b", re.IGNORECASE),
        "this is about Pybricks, a firmware with a protocol of its own; its hubs do not take frames of an EV3",
    ),
)


_MARKS = ("/target", "EV340", "VMTP", "785feabcd123", "6d8051e4aeef", "785FEABCD123", "6D8051E4AEEF", "pybricks", "47")


def strange_text(line: str) -> str | None:
    """Returns what a line without a frame is about, as a sentence; None for any other."""
    if not any(mark in line for mark in _MARKS):
        return None
    return next((said for pattern, said in _TEXTS if pattern.search(line)), None)


def strange_bytes(data: bytes) -> str | None:
    """Returns what bytes are that are not a frame, as a sentence; None where they may have been meant as one."""
    text = data.decode("ascii") if is_prose(data) else ""
    if len(text) >= _LEAST_PROSE and sum(map(str.isalpha, text)) * 2 > len(text):
        return strange_text(text) or f"no frame found: the bytes are text, {text[:_SHOWN]!r}"
    name = nxt_telegram(data)
    if name is not None:
        return f"this is a telegram for an NXT ({name}), LEGO's earlier brick; an EV3 does not know it"
    if len(data) >= _LEAST_HUB_MESSAGE and data[0] == len(data) and not data[1] and data[2] in _HUB_MESSAGES:
        return (
            "this is a message of LEGO's Wireless Protocol, for hubs with Bluetooth Low Energy (its first byte counts"
            " all bytes, the second is the hub, the third the type); an EV3 does not know it"
        )
    return None


def nxt_telegram(data: bytes) -> str | None:
    """Returns the name of a command for an NXT, as Bluetooth carries it or without its length; None for other bytes."""
    has_length = len(data) >= 4 and frame_size(data) == len(data)
    telegram = data[2:] if has_length else data
    if len(telegram) < (2 if has_length else _LEAST_NXT_WITHOUT_LENGTH):
        return None
    kind, code = telegram[:2]
    if kind == 0x02 and has_length and len(telegram) > 2 and (code in _NXT_DIRECT or code in _NXT_SYSTEM):
        name, _ = _NXT_DIRECT.get(code) or _NXT_SYSTEM[code]
        return f"the reply to {name}"
    name, size = _NXT.get(kind, {}).get(code, ("", -1))
    if size > 2 and not any(telegram[2:]):
        return None
    if size < 0 and kind in (0x00, 0x80) and code in _NXT_LENGTHS:
        name, before, at = _NXT_LENGTHS[code]
        size = before + telegram[at] if len(telegram) > at else -1
    return name if len(telegram) == size or (name == "SETOUTPUTSTATE" and len(telegram) == size + 1) else None

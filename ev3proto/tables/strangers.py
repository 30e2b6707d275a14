"""What people send to an EV3 or take for its frames: telegrams of LEGO's other products, and lines of text."""

from __future__ import annotations

from typing import NamedTuple


class Telegram(NamedTuple):
    """A telegram of another product.

    name      as its documentation calls it
    contents  a pattern of all bytes after its number
    reply     for the NXT: how many bytes its reply has, from the type on
    """

    name: str
    contents: bytes
    reply: int = 3


def _counted(most: int, between: bytes = b"") -> bytes:
    """Returns the pattern of a count from 1 on, and after it, and some bytes between, as many bytes."""
    return b"(?:" + b"|".join(rb"\x%02x%b.{%d}" % (size, between, size) for size in range(1, most + 1)) + b")"


_FILE = rb"(?=[ -~]+\0).{20}"
_MOTOR, _SENSOR = rb"[\0-\2\xff]", rb"[\0-\3]"
_PERCENT = rb"[\0-\x64\x9c-\xff]"

_NXT_DIRECT = {
    0x00: Telegram("STARTPROGRAM", _FILE),
    0x01: Telegram("STOPPROGRAM", b""),
    0x02: Telegram("PLAYSOUNDFILE", rb"[\0\1]" + _FILE),
    0x03: Telegram("PLAYTONE", rb".[\0-\x36].."),
    0x04: Telegram("SETOUTPUTSTATE", _MOTOR + _PERCENT + rb"[\0-\7][\0-\2]" + _PERCENT + rb"[\x00\x10\x20\x40].{4}\0?"),
    0x05: Telegram("SETINPUTMODE", _SENSOR + rb"[\0-\x11][\x00\x20\x40\x60\x80\xa0\xc0\xe0]"),
    0x06: Telegram("GETOUTPUTSTATE", _MOTOR, 25),
    0x07: Telegram("GETINPUTVALUES", _SENSOR, 16),
    0x08: Telegram("RESETINPUTSCALEDVALUE", _SENSOR),
    0x09: Telegram("MESSAGEWRITE", rb"[\0-\x13]" + _counted(59)),
    0x0A: Telegram("RESETMOTORPOSITION", _MOTOR + rb"[\0\1]"),
    0x0B: Telegram("GETBATTERYLEVEL", b"", 5),
    0x0C: Telegram("STOPSOUNDPLAYBACK", b""),
    0x0D: Telegram("KEEPALIVE", b"", 7),
    0x0E: Telegram("LSGETSTATUS", _SENSOR, 4),
    0x0F: Telegram("LSWRITE", _SENSOR + _counted(16, rb"[\0-\x10]")),
    0x10: Telegram("LSREAD", _SENSOR, 20),
    0x11: Telegram("GETCURRENTPROGRAMNAME", b"", 23),
    0x13: Telegram("MESSAGEREAD", rb"[\0-\x13][\0-\x13][\0\1]", 64),
}
_NXT_SYSTEM = {
    0x80: Telegram("OPENREAD", _FILE, 8),
    0x81: Telegram("OPENWRITE", _FILE + rb".{4}", 4),
    0x82: Telegram("READ", rb"[\0-\x0f].."),
    0x84: Telegram("CLOSE", rb"[\0-\x0f]", 4),
    0x85: Telegram("DELETE", _FILE, 23),
    0x86: Telegram("FINDFIRST", _FILE, 28),
    0x87: Telegram("FINDNEXT", rb"[\0-\x0f]", 28),
    0x88: Telegram("GETFIRMWAREVERSION", b"", 7),
    0x98: Telegram("SETBRICKNAME", rb"(?=[ -~]+\0).{16}"),
    0x9B: Telegram("GETDEVICEINFO", b"", 33),
}

NXT = {0x00: _NXT_DIRECT, 0x80: _NXT_DIRECT, 0x01: _NXT_SYSTEM, 0x81: _NXT_SYSTEM}
"""The commands of LEGO's NXT by their type, with or without a reply, and by their number."""

NXT_REPLY, NXT_ANSWERS = 0x02, {**_NXT_DIRECT, **_NXT_SYSTEM}
"""The type of the NXT's replies, and the commands that they answer."""

NXT_STATUS = frozenset(
    b"\x00\x20\x40\xbd\xbe\xbf\xc0\xc1\xdd\xde\xdf\xe0\xec\xed\xee\xf0\xf9\xfa\xfb\xff" + bytes(range(0x81, 0x97))
)
"""What a reply of an NXT may have as its status."""

HUB = {
    0x01: Telegram("hub properties", rb"[\1-\x0f][\1-\6].*"),
    0x02: Telegram("hub actions", rb"[\1-\7\x2f-\x32]"),
    0x03: Telegram("hub alerts", rb"[\1-\4][\1-\4][\0\xff]?"),
    0x04: Telegram("hub attached I/O", rb".[\0-\2].*"),
    0x05: Telegram("error", rb".[\1-\x08]"),
    0x08: Telegram("hardware network commands", rb"[\1-\x0d].*"),
    0x10: Telegram("go into boot mode", rb"LPF2-Boot"),
    0x11: Telegram("lock memory", rb"Lock-Mem"),
    0x13: Telegram("lock status", rb"[\0\xff]"),
    0x21: Telegram("port information request", rb".[\0-\2]"),
    0x22: Telegram("port mode information request", rb"..[\0-\x08\x80]"),
    0x41: Telegram("port input format setup", rb".{6}[\0\1]"),
    0x42: Telegram("port input format setup, combined", rb".[\1-\6].*"),
    0x43: Telegram("port information", rb".[\1\2].+"),
    0x44: Telegram("port mode information", rb"..[\0-\x08\x80].+"),
    0x45: Telegram("port value", rb"..+"),
    0x46: Telegram("port value, combined", rb"...+"),
    0x47: Telegram("port input format", rb".{6}[\0\1]"),
    0x48: Telegram("port input format, combined", rb"...+"),
    0x61: Telegram("virtual port setup", rb"[\0\1].+"),
    0x81: Telegram("port output command", rb".[\x00\x01\x10\x11].+"),
    0x82: Telegram("port output command feedback", rb"(?:.[\0-\x1f])+"),
}
"""The messages of LEGO's Wireless Protocol 3.0 by their type: all bytes counted, the hub (0), the type, contents."""


class StrangeLine(NamedTuple):
    """A line of text that people paste as if it had a frame.

    example  one of them
    mark     a part of every such line, which is looked for first
    pattern  what else it has
    says     what it is
    """

    example: str
    mark: str
    pattern: str
    says: str


_HANDSHAKE = (
    "this is the text that unlocks a brick on WiFi, not a frame; frames follow the brick's answer, Accept:EV340"
)
_BEACON = (
    "this is the beacon with which a brick announces itself on WiFi, not a frame: it names the TCP port for frames"
)
_HUB = "this is about LEGO's Wireless Protocol, for hubs with Bluetooth Low Energy; an EV3 does not have it"
_PYBRICKS = "this is about Pybricks, a firmware with a protocol of its own; its hubs do not take frames of an EV3"
_PYTHON = "bytes(data).hex(' ')"


def _printed(example: str, mark: str, pattern: str, language: str, how: str) -> StrangeLine:
    """Returns the row of an object that was printed in place of its bytes."""
    says = f"this is what {language} prints for an array, not its bytes; print {how}"
    return StrangeLine(example, mark, pattern, says)


LINES = (
    StrangeLine("GET /target?sn=0016533f0c1e", "/target", r"GET /target\?sn=", _HANDSHAKE),
    StrangeLine("Accept:EV340", "EV340", r"Accept:\s?EV340", _HANDSHAKE),
    StrangeLine("Protocol VMTP1.0", "VMTP", r"VMTP1\.0", _HANDSHAKE),
    StrangeLine("47 45 54 20 2f 74", "47", r"\W{0,4}(?:0x)?".join(["47", "45", "54", "20", "2f", "74"]), _HANDSHAKE),
    StrangeLine("Serial-Number: 0016533f0c1e", "erial-", r"Serial-Number:\s?[0-9a-f]{12}", _BEACON),
    StrangeLine("00001624-1212-efde-1623-785feabcd123", "-1212-", r"0000162[34]-1212-efde-162[34]-785feabcd123", _HUB),
    StrangeLine(
        "c5f50002-8280-46da-89f4-6d8051e4aeef", "-8280-", r"c5f5000[1-3]-8280-46da-89f4-6d8051e4aeef", _PYBRICKS
    ),
    StrangeLine("from pybricks.hubs import EV3Brick", "pybricks", r"\b(?:from|import) pybricks\b", _PYBRICKS),
    _printed("[B@40e3f9b8", "@", r"\[(?:[BCIS]|Ljava\.lang\.Byte;)@[0-9a-f]{5,8}\b", "Java", "Arrays.toString(bytes)"),
    _printed("HeapByteBuffer[pos=0 lim=9]", "Buffer[", r"ByteBuffer\[pos=", "Java", "Arrays.toString(buffer.array())"),
    _printed(
        "System.Byte[]",
        "System.",
        r"\bSystem\.[\w.`<\[]*S?Byte[\[\]>]",
        ".NET",
        "BitConverter.ToString(bytes.ToArray())",
    ),
    _printed("[object Blob]", "[object", r"\[object \w+\]", "JavaScript", "new Uint8Array(buffer).join(' ')"),
    _printed("<memory at 0x7f2b8c>", "<memory", r"<memory at 0x", "Python", _PYTHON),
    _printed("<zip object at 0x7f2b>", "object at", r"<[\w. ]+ object at 0x", "Python", _PYTHON),
    _printed(
        "table: 0x5581c3a0", ": 0x", r"(?<!\w)(?:table|userdata): 0x[0-9a-f]{6,}", "Lua", "table.concat(bytes, ' ')"
    ),
    _printed("ARRAY(0x55d0c8a3f0)", "ARRAY(", r"\bARRAY\(0x[0-9a-f]{6,}\)", "Perl", "join(' ', @$bytes)"),
    _printed(
        "Instance of 'Uint8List'",
        "Instance",
        r"Instance of '\w*(?:Byte|Uint8)\w*'",
        "Dart",
        "data.buffer.asUint8List()",
    ),
    _printed("#<StringIO:0x0000>", "#<", r"#<(?:Enumerator|StringIO)\b", "Ruby", "bytes.to_a"),
)

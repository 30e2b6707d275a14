r"""String literals to bytes: the escapes of C, Python, Ruby, JavaScript, Rust and Haskell, and Lua's decimal ones.

Two readings differ: `\128` is a byte in Lua, OCaml and Haskell, and in all others an octal escape and a digit.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from ev3proto.text.late_pattern import late_pattern

_CHARACTERS = {"a": 7, "b": 8, "t": 9, "n": 10, "v": 11, "f": 12, "r": 13, "e": 27, "s": 32}
# The names of the control characters from 0 on, which Haskell shows.
_CONTROLS = (
    "NUL SOH STX ETX EOT ENQ ACK BEL BS HT LF VT FF CR SO SI DLE DC1 DC2 DC3 DC4 NAK SYN ETB CAN EM SUB ESC FS GS RS US"
)
_CODES = {name: number for number, name in enumerate(_CONTROLS.split(" "))} | {"DEL": 127}
_NAMES = "|".join(sorted(_CODES, key=len, reverse=True))

_ESCAPE = late_pattern(
    r"\\(?:[xX]\{?(?P<hex>[0-9a-fA-F]{1,2})\}?|u(?:00|\{)(?P<unicode>[0-9a-fA-F]{1,2})\}?"
    rf"|(?P<digits>\d{{1,3}})|(?P<control>{_NAMES})|(?P<character>[^\w])|(?P<letter>[A-Za-z]))"
)


def literal(body: str, *, is_decimal: bool) -> bytes | None:
    r"""The bytes of what stands between two quotes.

    Args:
        body: The characters between the quotes.
        is_decimal: `\128` is one byte, as in Lua; otherwise digits are octal.

    Returns:
        The bytes, or None where a character is no byte.
    """
    out = bytearray()
    at = 0
    escape: Callable[[str, int], re.Match[str] | None] = _ESCAPE.match
    while at < len(body):
        if body[at] != "\\":
            if ord(body[at]) > 255:
                return None
            out.append(ord(body[at]))
            at += 1
            continue
        found = escape(body, at)
        if found is None:
            return None
        at = found.end()
        kind = found.lastgroup or ""
        if kind in ("hex", "unicode"):
            out.append(int(found[kind], 16))
        elif kind == "digits":
            digits = found[kind]
            if not is_decimal:
                octal = re.match(r"[0-3]?[0-7]{1,2}", digits)
                if octal is None:
                    return None
                at -= len(digits) - octal.end()
                out.append(int(octal[0], 8))
            elif int(digits) > 255:
                return None
            else:
                out.append(int(digits))
        elif kind == "control":
            out.append(_CODES[found[kind]])
        elif kind == "letter":
            number = _CHARACTERS.get(found[kind])
            # A letter without a meaning stands for itself after its backslash, as in Python.
            out += b"\\" + found[kind].encode() if number is None else bytes((number,))
        elif found[kind] == "&" and is_decimal:
            continue
        elif ord(found["character"]) < 256:
            out.append(ord(found["character"]))
        else:
            return None
    return bytes(out)

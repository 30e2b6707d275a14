r"""The notations in which programs, logs, debuggers and forum posts write bytes.

`EXAMPLES` are those of `docs/notations.md`, which all hold the same frame; `NOTATIONS` write any bytes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

PAGE = (Path(__file__).parents[2] / "docs" / "notations.md").read_text(encoding="utf-8")
_LINES, _BLOCKS = (re.findall(r"```text\n(.*?)\n```", part, re.DOTALL) for part in PAGE.split("## Over several lines"))
EXAMPLES: list[str] = [line for block in _LINES for line in block.split("\n")] + _BLOCKS


def _signed(byte: int) -> int:
    return byte - 256 if byte > 127 else byte


def _rows(data: bytes, width: int) -> Iterator[tuple[int, bytes]]:
    for offset in range(0, len(data), width):
        yield offset, data[offset : offset + width]


def _text(row: bytes) -> str:
    return "".join(chr(byte) if 32 <= byte < 127 else "." for byte in row)


def _list(data: bytes, form: str = "{}", separator: str = ", ") -> str:
    return separator.join(form.format(byte) for byte in data)


def _in_rows(data: bytes, width: int, end: str) -> str:
    return "\n".join("  " + _list(row, "0x{:02x}") + end for _, row in _rows(data, width))


def _canonical(data: bytes) -> str:
    lines = [
        f"{offset:08x}  {row[:8].hex(' '):<23}  {row[8:].hex(' '):<23}  |{_text(row)}|"
        for offset, row in _rows(data, 16)
    ]
    return "\n".join([*lines, f"{len(data):08x}"])


NOTATIONS: dict[str, Callable[[bytes], str]] = {
    "hex": bytes.hex,
    "blanks": lambda data: data.hex(" "),
    "colons": lambda data: data.hex(":"),
    "dashes": lambda data: data.hex("-").upper(),
    "commas without 0x": lambda data: data.hex(","),
    "pairs of bytes": lambda data: data.hex(" ", -2),
    "lesson": lambda data: "0x|" + data.hex(":").upper() + "|",
    "0x and commas": lambda data: _list(data, "0x{:02X}"),
    "0x, unpadded": lambda data: _list(data, "{:#x}", ","),
    "decimals": lambda data: _list(data, "{}", ","),
    "signed decimals": lambda data: " ".join(str(_signed(byte)) for byte in data),
    "C": lambda data: f"unsigned char cmd[{len(data)}] = {{{_list(data, '0x{:02x}', ',')}}};",
    "Java": lambda data: f"byte[] cmd = new byte[] {{{_list(data, '(byte)0x{:02X}')}}};",
    "Kotlin": lambda data: (
        "byteArrayOf(" + ", ".join(f"0x{byte:02x}" + (".toByte()" if byte > 127 else "") for byte in data) + ")"
    ),
    "Go": lambda data: f"[{_list(data, '{}', ' ')}]",
    "Rust": lambda data: f"[{_list(data)}]",
    "Erlang": lambda data: f"<<{_list(data, '{}', ',')}>>",
    "Visual Basic": lambda data: f"Dim b() As Byte = {{{_list(data, '&H{:X}')}}}",
    "Pascal": lambda data: f"const Cmd: array[0..{len(data) - 1}] of Byte = ({_list(data, '${:02X}')});",
    "Chr()": lambda data: _list(data, "Chr({})", " & "),
    "calls": lambda data: _list(data, "buf.put((byte)0x{:02x});", ""),
    "repr": repr,
    "bytearray": lambda data: repr(bytearray(data)),
    "bytes()": lambda data: f"bytes(({_list(data)}))",
    "fromhex": lambda data: f"bytes.fromhex('{data.hex(' ')}')",
    "hex escapes": lambda data: _list(data, "\\x{:02x}", ""),
    "octal escapes": lambda data: '"' + _list(data, "\\{:03o}", "") + '"',
    "C in rows": lambda data: "char cmd[] = {\n" + _in_rows(data, 4, ",") + "\n};",
    "C with remarks": lambda data: "{\n" + _in_rows(data, 3, ", // 12 of them") + "\n};",
    "Wireshark": lambda data: "\n".join(
        f"{offset:04x}   {row.hex(' '):<47}   {_text(row)}" for offset, row in _rows(data, 16)
    ),
    "xxd": lambda data: "\n".join(
        f"{offset:08x}: {row.hex(' ', -2):<39}  {_text(row)}" for offset, row in _rows(data, 16)
    ),
    "hexdump -C": _canonical,
}

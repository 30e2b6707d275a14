r"""The notations in which programs, logs, debuggers and forum posts write bytes.

`EXAMPLES` are those of `docs/notations.md`, which all hold the same frame; `NOTATIONS` write any bytes.
"""

from __future__ import annotations

import base64
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


def _each(data: bytes, form: str, separator: str = "") -> str:
    """Returns one text for each byte, which may name its index."""
    return separator.join(form.format(byte, at=at, signed=_signed(byte)) for at, byte in enumerate(data))


def _grouped(data: bytes, size: int, separator: str = " ") -> str:
    return separator.join(row.hex() for _, row in _rows(data, size))


def _dump(data: bytes, width: int, offset: str, row: Callable[[bytes], str], last: str = "") -> str:
    lines = [offset.format(at) + row(part) for at, part in _rows(data, width)]
    return "\n".join([*lines, *([last.format(len(data))] if last else [])])


def _words(row: bytes) -> str:
    padded = row + bytes(len(row) % 2)
    return " ".join(f"{padded[at + 1]:02x}{padded[at]:02x}" for at in range(0, len(padded), 2))


def _boxed(row: bytes) -> str:
    return f"{row.hex(' '):<47} |{_text(row):<16}|"


FORMS: dict[str, Callable[[bytes], str]] = {
    **NOTATIONS,
    "semicolons": lambda data: data.hex(";"),
    "underscores": lambda data: data.hex("_"),
    "bars": lambda data: data.hex("|"),
    "dots": lambda data: data.hex("."),
    "dotted pairs": lambda data: _grouped(data, 2, "."),
    "groups of four": lambda data: _grouped(data, 4),
    "0x in front": lambda data: "0x" + data.hex(),
    "0x without blanks": lambda data: _each(data, "0x{:02x}"),
    "0x with the number": lambda data: _each(data, "0x{0:02x} ({0})", " "),
    "percent": lambda data: _each(data, "%{:02X}"),
    "nbsp": lambda data: data.hex(" ").replace(" ", "&nbsp;"),
    "unpadded hex": lambda data: _each(data, "{:X}", " "),
    "decimals and blanks": lambda data: _each(data, "{}", " "),
    "decimals of three digits": lambda data: _each(data, "{:03}", " "),
    "octal": lambda data: _each(data, "{:03o}", " "),
    "bits": lambda data: _each(data, "{:08b}", " "),
    "0b": lambda data: _each(data, "0b{:08b}", ", "),
    "base64": lambda data: base64.b64encode(data).decode(),
    "log": lambda data: f"2024-01-31 12:30:45,123 DEBUG ev3: TX {data.hex(' ')}",
    "Markdown": lambda data: f"| 12 | sent | `{data.hex(' ')}` |",
    "USB monitor": lambda data: f"ffff88007c1b6600 3575914555 S Io:1:005:1 -115 {len(data)} = {_grouped(data, 4)} >",
    "angle brackets": lambda data: _each(data, "<{:02X}>"),
    "square brackets": lambda data: _each(data, "[0x{:02X}]"),
    "field": lambda data: f'<field name="data" showname="Data" size="{len(data)}" value="{data.hex()}"/>',
    "assignments": lambda data: _each(data, "cmd[{at}] = 0x{:02X};", " "),
    "characters in hex": lambda data: "char cmd[] = {" + _each(data, "'\\x{:02x}'", ", ") + "};",
    "gdb": lambda data: "$1 = {" + _each(data, "{0} '\\{0:03o}'", ", ") + "}",
    ".byte": lambda data: "\t.byte " + _each(data, "0x{:02x}", ", "),
    "db": lambda data: "frame: db " + _each(data, "{:02X}h", ", "),
    ".byte $": lambda data: "  .byte " + _each(data, "${:02x}", ","),
    "casts of some": lambda data: (
        "byte[] b = {" + ", ".join(f"(byte)0x{byte:02X}" if byte > 127 else f"0x{byte:02X}" for byte in data) + "};"
    ),
    "casts of decimals": lambda data: "byte[] b = {" + _each(data, "(byte) {signed}", ", ") + "};",
    "signed list": lambda data: "[" + _each(data, "{signed}", ", ") + "]",
    "signed hex": lambda data: " ".join(f"{_signed(byte) & 0xFFFFFFFF:x}" for byte in data),
    "suffix u": lambda data: "ubyteArrayOf(" + _each(data, "0x{:02x}u", ", ") + ")",
    "Scala": lambda data: "Array[Byte](" + _each(data, "{signed}", ", ") + ")",
    "Uint8Array": lambda data: f"Uint8Array({len(data)}) [" + _each(data, "{}", ", ") + "]",
    "object": lambda data: "Uint8Array { " + _each(data, "{at}: {}", ", ") + " }",
    "JSON object": lambda data: "{" + _each(data, '"{at}": {}', ", ") + "}",
    "JSON buffer": lambda data: '{"type": "Buffer", "data": [' + _each(data, "{}", ", ") + "]}",
    "fromCharCode": lambda data: "String.fromCharCode(" + _each(data, "{}", ", ") + ")",
    "quoted hex": lambda data: "[" + _each(data, '"{:02x}"', ", ") + "]",
    "XML": lambda data: _each(data, "<byte>{}</byte>"),
    "Buffer": lambda data: f"<Buffer {data.hex(' ')}>",
    "Buffer.from": lambda data: f"port.write(Buffer.from('{data.hex()}', 'hex'))",
    "JSON string": lambda data: '"' + _each(data, "\\u{:04x}") + '"',
    "joined strings": lambda data: f"{data[:8]!r} + {data[8:]!r}",
    "array of Python": lambda data: f"array('B', [{_each(data, '{}', ', ')}])",
    "numpy": lambda data: f"array([{_each(data, '{:3}', ', ')}], dtype=uint8)",
    "strings of hex": lambda data: "(" + _each(data, "'{:#x}'", ", ") + ")",
    "Perl": lambda data: '"' + _each(data, "\\x{{{:02x}}}") + '"',
    "pack": lambda data: f'pack("H*", "{data.hex()}")',
    "PHP": lambda data: "$cmd = array(" + _each(data, "0x{:02x}", ", ") + ");",
    "print_r": lambda data: "Array ( " + _each(data, "[{at}] => {}", " ") + " )",
    "chr": lambda data: _each(data, "chr({})", "."),
    "chr of hex": lambda data: _each(data, "chr(0x{:02x})", "+"),
    "string.char": lambda data: "string.char(" + _each(data, "{}", ", ") + ")",
    "[]byte": lambda data: "[]byte{" + _each(data, "{:#x}", ", ") + "}",
    "vec!": lambda data: "let frame = vec![" + _each(data, "0x{:02x}", ", ") + "];",
    "Rust's escapes": lambda data: '"' + _each(data, "\\u{{{:x}}}") + '"',
    "Swift": lambda data: "let frame: [UInt8] = [" + _each(data, "{}", ", ") + "]",
    "NSData": lambda data: f"<{_grouped(data, 4)}>",
    "MATLAB": lambda data: "uint8([" + _each(data, "{}", " ") + "])",
    "hex2dec": lambda data: "hex2dec({" + _each(data, "'{:02X}'", ",") + "})",
    "DATA": lambda data: "100 DATA " + _each(data, "{}", ","),
    "printf": lambda data: "printf '" + _each(data, "\\x{:02x}") + "' > /dev/rfcomm0",
    "PowerShell": lambda data: "[byte[]](" + _each(data, "0x{:02X}", ", ") + ")",
    "rows": lambda data: _dump(data, 8, "", lambda row: row.hex(" ")),
    "rows of strings": lambda data: "(" + _dump(data, 5, " ", repr) + ")",
    "hexdump": lambda data: _dump(data, 16, "{:07x} ", _words, "{:07x}"),
    "od -t x1": lambda data: _dump(data, 16, "{:07o} ", lambda row: row.hex(" "), "{:07o}"),
    "od -t d1": lambda data: _dump(data, 16, "{:07o} ", lambda row: "".join(f"{_signed(b):5}" for b in row)),
    "xxd -b": lambda data: _dump(
        data, 6, "{:08x}: ", lambda row: f"{' '.join(f'{b:08b}' for b in row):<53}  {_text(row)}"
    ),
    "hexyl": lambda data: _dump(data, 16, "│{:08x}│ ", _boxed),
    "follow stream": lambda data: (
        "char peer0_0[] = { /* Packet 5 */\n"
        + _dump(data, 8, "", lambda row: _each(row, "0x{:02x}", ", ")).replace("\n", ",\n")
        + " };"
    ),
    "openssl": lambda data: _dump(data, 15, "    ", lambda row: row.hex(":") + ":"),
    "gdb's x": lambda data: _dump(data, 8, "0x{:x} <cmd>:\t", lambda row: _each(row, "0x{:02x}", "\t")),
    "Android": lambda data: _dump(data, 8, "D/EV3 ( 1234): ", lambda row: row.hex(" ")),
    "comments": lambda data: _dump(data, 8, "//   ", lambda row: _each(row, "0x{:02x}, ")),
    "continued": lambda data: f"x = {data[:8]!r} + \\\n    {data[8:]!r}",
    "remarks of assembly": lambda data: (
        "frame:\n" + _dump(data, 8, "    db ", lambda row: _each(row, "{:02X}h", ", ") + "  ; part")
    ),
    "DATA rows": lambda data: _dump(data, 8, "100 DATA ", lambda row: _each(row, "{}", ",")),
    "Add": lambda data: _each(data, "    data.Add(0x{:02X});", "\n"),
    "index and number": lambda data: _each(data, "buf[{at}] = 0x{0:02x} ({0})", "\n"),
    "digit in front of h": lambda data: "frame db " + _each(data, "0{:02X}h", ","),
    "unhexlify": lambda data: f"binascii.unhexlify(b'{data.hex()}')",
    "SQL": lambda data: f"INSERT INTO log VALUES (12, X'{data.hex().upper()}');",
    "PostgreSQL": lambda data: f" 12 | \\x{data.hex()}",
    "MySQL": lambda data: f"| 12 | 0x{data.hex().upper()} |",
    "portmon": lambda data: f"12\tapp.exe\tIRP_MJ_WRITE\tSerial0\tSUCCESS\tLength {len(data)}: {data.hex(' ')}",
    "column of the size": lambda data: f"2024-01-31T12:30:45Z;tx;{data.hex(' ')};{len(data)}",
    "number of a port": lambda data: "echo -ne '" + _each(data, "\\x{:02x}") + "' | nc 192.168.1.5 5555",
    "slashes": lambda data: data.hex("/"),
    "tcpdump": lambda data: _dump(data, 16, "\t0x{:04x}:  ", lambda row: f"{_grouped(row, 2):<39}  {_text(row)}"),
    "Format-Hex": lambda data: _dump(data, 16, "{:016X} ", lambda row: f"{row.hex(' ').upper():<47} {_text(row)}"),
    "jpnevulator": lambda data: (
        "2024-01-31 12:30:45.123456:\n" + _dump(data, 16, "", lambda row: f"{row.hex(' '):<47} {_text(row)}")
    ),
    "PHP's var_dump": lambda data: (
        f"array({len(data)}) {{\n" + "".join(f"  [{at}]=>\n  int({byte})\n" for at, byte in enumerate(data)) + "}"
    ),
    "socat": lambda data: (
        "> 2024/01/31 12:00:00.123456  length=17 from=0 to=16\n"
        + _dump(data, 16, " ", lambda row: f"{row.hex(' '):<48} {_text(row)}")
    ),
}
"""All forms of `docs/notations.md`, in which the bytes behind a frame belong to it."""

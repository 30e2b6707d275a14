r"""The ways in which programs, logs, debuggers and forum posts write bytes, as functions from bytes to text.

Each follows the output of a real program, or its source. `EVERY` takes any bytes; notations with limits are listed
separately in the tests.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Iterator

Notation = Callable[[bytes], str]


def _signed(byte: int) -> int:
    return byte - 256 if byte > 127 else byte


def _rows(data: bytes, width: int) -> Iterator[tuple[int, bytes]]:
    for offset in range(0, len(data), width):
        yield offset, data[offset : offset + width]


def _shown(row: bytes) -> str:
    return "".join(chr(byte) if 32 <= byte < 127 else "." for byte in row)


def _words(row: bytes) -> list[int]:
    padded = row + bytes(len(row) % 2)
    return [padded[at] | padded[at + 1] << 8 for at in range(0, len(padded), 2)]


def _list(data: bytes, form: str = "{}", separator: str = ", ") -> str:
    return separator.join(form.format(byte) for byte in data)


def _in_rows(data: bytes, width: int, form: str, separator: str, start: str, end: str) -> str:
    return "\n".join(start + _list(row, form, separator) + end for _, row in _rows(data, width))


def _od(data: bytes, form: str) -> str:
    lines = [f"{offset:07o} " + " ".join(form.format(byte) for byte in row) for offset, row in _rows(data, 16)]
    return "\n".join([*lines, f"{len(data):07o}"])


def _wireshark(data: bytes, *, text: bool = True) -> str:
    return "\n".join(
        f"{offset:04x}   {row.hex(' '):<47}" + (f"   {_shown(row)}" if text else "") for offset, row in _rows(data, 16)
    )


def _canonical(data: bytes) -> str:
    lines = [
        f"{offset:08x}  {row[:8].hex(' '):<23}  {row[8:].hex(' '):<23}  |{_shown(row)}|"
        for offset, row in _rows(data, 16)
    ]
    return "\n".join([*lines, f"{len(data):08x}"])


def _xxd(data: bytes) -> str:
    return "\n".join(f"{offset:08x}: {row.hex(' ', -2):<39}  {_shown(row)}" for offset, row in _rows(data, 16))


def _javascript(data: bytes) -> str:
    return '"' + "".join(f"\\u{byte:04x}" for byte in data) + '"'


def _python2(data: bytes) -> str:
    return repr(data)[1:]


def _c_string(data: bytes) -> str:
    return '"' + "".join(f"\\{byte:03o}" for byte in data) + '"'


def _ruby(data: bytes) -> str:
    named = {7: r"\a", 8: r"\b", 9: r"\t", 10: r"\n", 11: r"\v", 12: r"\f", 13: r"\r", 27: r"\e", 34: r"\"", 92: r"\\"}
    return '"' + "".join(named.get(b) or (chr(b) if 32 <= b < 127 else f"\\x{b:02X}") for b in data) + '"'


def _halves(data: bytes, join: Callable[[bytes, bytes], str]) -> str:
    middle = len(data) // 2
    return join(data[:middle], data[middle:])


def _nsdata(data: bytes) -> str:
    return " ".join(row.hex() for _, row in _rows(data, 4))


def _rfcomm(data: bytes) -> bytes:
    """What a Bluetooth adapter is given: ACL data, L2CAP, RFCOMM and its check sum around a frame."""
    size = len(data)
    field = bytes((size << 1 | 1,)) if size < 128 else bytes(((size & 0x7F) << 1, size >> 7))
    rfcomm = b"\x0b\xef" + field + data + b"\x9a"
    l2cap = len(rfcomm).to_bytes(2, "little") + b"\x40\x00" + rfcomm
    return b"\x02\x2a\x20" + len(l2cap).to_bytes(2, "little") + l2cap


def _hcidump(data: bytes) -> str:
    rows = [row.hex(" ").upper() for _, row in _rows(_rfcomm(data), 20)]
    return "< " + " \n  ".join(rows)


def _tcpdump(data: bytes) -> str:
    packet = bytes.fromhex("4500 0045 1c46 4000 4006 b1e6 c0a8 0165 c0a8 0166 15b3 c001 0000 0001 0000 0001 5018 2000")
    packet += bytes.fromhex("917c 0000") + data
    rows = "\n".join(f"\t0x{offset:04x}:  {row.hex(' ', -2):<39}  {_shown(row)}" for offset, row in _rows(packet, 16))
    return f"09:12:31.011558 IP 192.168.1.101.5555 > 192.168.1.102.49153: Flags [P.], seq 1:18, length 17\n{rows}"


LINE: dict[str, Notation] = {
    "hex": bytes.hex,
    "HEX": lambda data: data.hex().upper(),
    "blanks": lambda data: data.hex(" "),
    "BLANKS": lambda data: data.hex(" ").upper(),
    "colons": lambda data: data.hex(":"),
    "dashes (BitConverter)": lambda data: data.hex("-").upper(),
    "commas without 0x": lambda data: data.hex(","),
    "dots": lambda data: data.hex("."),
    "bars": lambda data: data.hex("|"),
    "pairs of bytes": lambda data: data.hex(" ", -2),
    "groups of four": _nsdata,
    "0x and all": lambda data: "0x" + data.hex(),
    "lesson": lambda data: "0x|" + data.hex(":").upper() + "|",
    "0x and commas": lambda data: _list(data, "0x{:02X}"),
    "0x, unpadded": lambda data: _list(data, "{:#x}", ","),
    "unpadded hex": lambda data: _list(data, "{:X}", " "),
    "toHexString of Java": lambda data: " ".join(f"{_signed(byte) & 0xFFFFFFFF:x}" for byte in data),
    "decimals": lambda data: _list(data, "{}", " "),
    "decimals, commas": lambda data: _list(data, "{}", ","),
    "decimals, padded": lambda data: _list(data, "{:03}", " "),
    "signed decimals": lambda data: " ".join(str(_signed(byte)) for byte in data),
    "octal": lambda data: _list(data, "{:03o}", " "),
    "bits": lambda data: _list(data, "{:08b}", " "),
    "0b": lambda data: _list(data, "0b{:08b}"),
    "%": lambda data: _list(data, "%{:02X}", ""),
    "Node's Buffer": lambda data: f"<Buffer {data.hex(' ')}>",
    "Uint8Array": lambda data: f"Uint8Array({len(data)}) [{_list(data)}]",
    "Uint8Array of Chrome": lambda data: f"Uint8Array({len(data)}) [{_list(data)}, buffer: ArrayBuffer({len(data)})]",
    "Buffer.from hex": lambda data: f"port.write(Buffer.from('{data.hex()}', 'hex'))",
    "Buffer's JSON": lambda data: json.dumps({"type": "Buffer", "data": list(data)}),
    "expanded": lambda data: "Uint8Array { " + ", ".join(f"{i}: {byte}" for i, byte in enumerate(data)) + " }",
    "expanded JSON": lambda data: json.dumps({str(index): byte for index, byte in enumerate(data)}),
    "String.fromCharCode": lambda data: f"String.fromCharCode({_list(data)})",
    "JavaScript string": _javascript,
    "Java array": lambda data: f"byte[] cmd = new byte[] {{{_list(data, '(byte)0x{:02X}')}}};",
    "Arrays.toString": lambda data: str([_signed(byte) for byte in data]),
    "Kotlin, some": lambda data: (
        "byteArrayOf(" + ", ".join(f"0x{byte:02x}" + (".toByte()" if byte > 127 else "") for byte in data) + ")"
    ),
    "Kotlin ubytes": lambda data: f"ubyteArrayOf({_list(data, '0x{:02x}u')})",
    "Go": lambda data: f"[{_list(data, '{}', ' ')}]",
    "Go literal": lambda data: f"[]byte{{{_list(data, '{:#x}')}}}",
    "Rust {:?}": lambda data: f"[{_list(data)}]",
    "Rust {:x?}": lambda data: f"[{_list(data, '{:x}')}]",
    "Rust suffix on the first": lambda data: f"[{data[0]}u8, {_list(data[1:])}]",
    "Rust string": lambda data: '"' + "".join(f"\\u{{{byte:x}}}" for byte in data) + '"',
    "Visual Basic": lambda data: f"Dim b() As Byte = {{{_list(data, '&H{:X}')}}}",
    "BASIC DATA": lambda data: f"100 DATA {_list(data, '{}', ',')}",
    "Chr()": lambda data: _list(data, "Chr({})", " & "),
    "chr()": lambda data: _list(data, "chr(0x{:02x})", "+"),
    "Pascal": lambda data: f"const Cmd: array[0..{len(data) - 1}] of Byte = ({_list(data, '${:02X}')});",
    "assembler": lambda data: f"frame: db {_list(data, '{:02X}h')}",
    "NSData": lambda data: f"<{_nsdata(data)}>",
    "C": lambda data: f"unsigned char cmd[{len(data)}] = {{{_list(data, '0x{:02x}', ',')}}};",
    "C assignments": lambda data: " ".join(f"cmd[{index}] = 0x{byte:02X};" for index, byte in enumerate(data)),
    "octal escapes": _c_string,
    "hex escapes, no quotes": lambda data: "".join(f"\\x{byte:02x}" for byte in data),
    "bash $''": lambda data: "frame=$'" + "".join(f"\\x{byte:02x}" for byte in data) + "'",
    "repr": repr,
    "bytearray": lambda data: repr(bytearray(data)),
    "b'' + b''": lambda data: _halves(data, lambda one, two: f"{one!r} + {two!r}"),
    "Python 2": _python2,
    "Ruby": _ruby,
    "Lua": lambda data: '"' + "".join(f"\\{byte}" for byte in data) + '"',
    "string.char": lambda data: f"string.char({_list(data)})",
    "Perl pack": lambda data: f'pack("H*", "{data.hex()}")',
    "Perl escapes": lambda data: '"' + "".join(f"\\x{{{byte:02x}}}" for byte in data) + '"',
    "PHP": lambda data: f"$cmd = array({_list(data, '0x{:02x}')});",
    "print_r": lambda data: "Array ( " + " ".join(f"[{index}] => {byte}" for index, byte in enumerate(data)) + " )",
    "Erlang": lambda data: f"<<{_list(data, '{}', ',')}>>",
    "MATLAB": lambda data: f"uint8([{_list(data, '{}', ' ')}])",
    "hex2dec": lambda data: f"hex2dec({{{_list(data, chr(39) + '{:02X}' + chr(39), ',')}}})",
    "strings of hex": lambda data: json.dumps([f"{byte:02x}" for byte in data]),
    "terminal": lambda data: _list(data, "<{:02X}>", ""),
    "terminal, 0x": lambda data: _list(data, "[0x{:02X}]", ""),
    "base64": lambda data: base64.b64encode(data).decode(),
    "fromhex": lambda data: f"bytes.fromhex('{data.hex(' ')}')",
    "bytes()": lambda data: f"bytes(({_list(data)}))",
    "array()": lambda data: f"array('B', [{_list(data)}])",
    "numpy": lambda data: f"array([{_list(data, '{:3}')}], dtype=uint8)",
    "YAML": lambda data: f"frame: [{_list(data)}]",
    "XML": lambda data: f'<field name="data.data" showname="Data" size="{len(data)}" value="{data.hex()}"/>',
    "tuple of hex": lambda data: str(tuple(hex(byte) for byte in data)),
    "HID report, padded": lambda data: (b"\0" + data + bytes(64 - len(data) % 64)).hex(" "),
    "padded": lambda data: (data + bytes(64 - len(data) % 64)).hex(" "),
    "calls": lambda data: "".join(f"buf.put((byte)0x{byte:02x});" for byte in data),
    "chr() in PHP": lambda data: _list(data, "chr({})", "."),
    "elements of XML": lambda data: "".join(f"<byte>{byte}</byte>" for byte in data),
    "non-breaking blanks": lambda data: data.hex(" ").replace(" ", "\u00a0"),
    "entities": lambda data: _list(data, "{:02x}", "&nbsp;"),
    "groups with full stops": lambda data: ".".join(row.hex() for _, row in _rows(data, 2)),
    "octal of C": lambda data: f"{{{_list(data, '0{:03o}')}}}",
    "0x glued": lambda data: _list(data, "0x{:02x}", ""),
    "bytea": lambda data: f"\\x{data.hex()}",
    "bytes joined": lambda data: _halves(data, lambda one, two: f"b''.join([{one!r}, {two!r}])"),
    "gdb print": lambda data: "$1 = {" + ", ".join(f"{byte} '\\{byte:03o}'" for byte in data) + "}",
    "fields by name": lambda data: (
        f"len={data[:2].hex()} cnt={data[2:4].hex()} type={data[4]:02x} rest={data[5:].hex()}"
    ),
    "the same in decimal": lambda data: _list(data, "0x{0:02x} ({0})", " "),
}
"""Notations of one line."""

LINES: dict[str, Notation] = {
    "hex, wrapped": lambda data: _in_rows(data, 8, "{:02x}", " ", "", ""),
    "colons, wrapped": lambda data: _in_rows(data, 9, "{:02x}", ":", "", ":"),
    "lesson, wrapped": lambda data: "0x|" + _in_rows(data, 5, "{:02X}", ":", "", "|"),
    "decimals, wrapped": lambda data: "[" + _in_rows(data, 10, "{:3}", " ", " ", "") + "]",
    "C rows": lambda data: "char cmd[] = {\n" + _in_rows(data, 4, "0x{:02x}", ", ", "    ", ",") + "\n};",
    "C rows, remarks": lambda data: "{\n" + _in_rows(data, 3, "0x{:02x}", ", ", "  ", ", // 12 of them") + "\n};",
    "C rows, long comment": lambda data: _halves(
        data, lambda one, two: f"{{{_list(one)}, /* the\n  other 12 bytes\n*/\n {_list(two)}}}"
    ),
    "one a line": lambda data: "[\n" + ",\n".join(f"    {byte}" for byte in data) + "\n]",
    "one a line, remarks": lambda data: "\n".join(f"  0x{byte:02x}, # byte {i}" for i, byte in enumerate(data)),
    "Python rows": lambda data: "frame = bytes([\n" + _in_rows(data, 8, "{:3}", ", ", "    ", ",  # row") + "\n])",
    "assignments": lambda data: "\n".join(f"  cmd[{index}] = 0x{byte:02X};" for index, byte in enumerate(data)),
    "expanded": lambda data: "\n".join(f"  {index}: {byte}" for index, byte in enumerate(data)),
    "print_r": lambda data: "Array\n(\n" + "\n".join(f"    [{i}] => {byte}" for i, byte in enumerate(data)) + "\n)",
    "commented out": lambda data: f"# {data.hex(' ')}",
    "commented out, rows": lambda data: _in_rows(data, 8, "0x{:02x}", ", ", "//   ", ","),
    "joined strings": lambda data: "(" + "\n ".join(repr(row) for _, row in _rows(data, 5)) + ")",
    "joined with +": lambda data: _halves(data, lambda one, two: f"x = {one!r} + \\\n    {two!r}"),
    "Wireshark's escaped string": lambda data: " \\\n".join(
        '"' + "".join(f"\\x{byte:02x}" for byte in row) + '"' for _, row in _rows(data, 15)
    ),
    "Wireshark's C array": lambda data: (
        "char peer0_0[] = { /* Packet 5 */\n" + ",\n".join(_list(row, "0x{:02x}") for _, row in _rows(data, 8)) + " };"
    ),
    "Wireshark's YAML": lambda data: "    data: !!binary |\n      " + base64.b64encode(data).decode(),
    "Wireshark's hex and text": _wireshark,
    "hexdump -C": _canonical,
    "hexdump": lambda data: "\n".join(
        [
            *(f"{offset:07x} " + " ".join(f"{w:04x}" for w in _words(row)) for offset, row in _rows(data, 16)),
            f"{len(data):07x}",
        ]
    ),
    "od -t x1": lambda data: _od(data, "{:02x}"),
    "od -t x1z": lambda data: "\n".join(
        f"{offset:07o} {row.hex(' '):<47}  >{_shown(row)}<" for offset, row in _rows(data, 16)
    ),
    "od -An -t x1": lambda data: _in_rows(data, 16, "{:02x}", " ", " ", ""),
    "od -t d1": lambda data: "\n".join(
        f"{offset:07o} " + " ".join(f"{_signed(byte):4}" for byte in row) for offset, row in _rows(data, 16)
    ),
    "xxd": _xxd,
    "xxd -i": lambda data: (
        "unsigned char frame_bin[] = {\n"
        + ",\n".join("  " + _list(row, "0x{:02x}") for _, row in _rows(data, 12))
        + f"\n}};\nunsigned int frame_bin_len = {len(data)};"
    ),
    "xxd -b": lambda data: "\n".join(
        f"{offset:08x}: {_list(row, '{:08b}', ' ')}  {_shown(row)}" for offset, row in _rows(data, 6)
    ),
    "btmon": lambda data: (
        "> ACL Data RX: Handle 42 flags 0x02 dlen 25           #12 [hci0] 5.123456\n"
        "      Channel: 64 len 21 [PSM 3 mode 0] {chan 0}\n"
        "      RFCOMM: Unnumbered Info with Header Check (UIH) (0xef)\n"
        "         Address: 0x0b cr 1 dlci 0x02\n         Control: 0xef poll/final 0\n         Length: 17\n"
        "         FCS: 0x9a\n" + "\n".join(f"        {row.hex(' '):<47}  {_shown(row)}" for _, row in _rows(data, 16))
    ),
    "hcidump -R": _hcidump,
    "hcidump -X": lambda data: (
        "      RFCOMM(d): UIH: cr 1 dlci 2 pf 0 ilen 17 fcs 0x9a\n"
        + "\n".join(f"      {offset:04x}: {row.hex(' '):<47}  {_shown(row)}" for offset, row in _rows(data, 16))
    ),
    "tcpdump -X": _tcpdump,
    "logcat rows": lambda data: "\n".join(f"D/EV3 ( 1234): {row.hex(' ')}" for _, row in _rows(data, 8)),
    "assembler rows": lambda data: "frame:\n" + _in_rows(data, 8, "{:02X}h", ", ", "    db ", "  ; part"),
    "BASIC rows": lambda data: "\n".join(
        f"{100 + 10 * index} DATA {_list(row, '{}', ',')}" for index, (_, row) in enumerate(_rows(data, 8))
    ),
    "numpy rows": lambda data: (
        "array([" + ",\n       ".join(_list(row, "{:3}") for _, row in _rows(data, 8)) + "], dtype=uint8)"
    ),
    "numbered": lambda data: "n,byte\n" + "\n".join(f"{index},{byte}" for index, byte in enumerate(data)),
    "printed by index": lambda data: "\n".join(f"buf[{i}] = 0x{byte:02x} ({byte})" for i, byte in enumerate(data)),
    "Visual Studio": lambda data: "\n".join(f"\t[{i}]\t0x{byte:02x}\tbyte" for i, byte in enumerate(data)),
    "gdb x/xb, with a name": lambda data: "\n".join(
        f"0x{0x601040 + at:x} <cmd+{at}>:\t" + _list(row, "0x{:02x}", "\t") for at, row in _rows(data, 8)
    ),
    "Netty": lambda data: (
        "         +-------------------------------------------------+\n"
        "         |  0  1  2  3  4  5  6  7  8  9  a  b  c  d  e  f |\n"
        + "\n".join(f"|{at:08x}| {row.hex(' '):<47} |{_shown(row):<16}|" for at, row in _rows(data, 16))
    ),
    "hexyl": lambda data: "\n".join(
        f"\u2502{at:08x}\u2502 {row[:8].hex(' '):<23} \u250a {row[8:].hex(' '):<23} \u2502{_shown(row):<16}\u2502"
        for at, row in _rows(data, 16)
    ),
    "Format-Hex of PowerShell 7": lambda data: "\n".join(
        f"{at:016X} {row.hex(' ').upper():<47} {_shown(row).replace('.', chr(0xFFFD))}" for at, row in _rows(data, 16)
    ),
    "socat -x -v": lambda data: (
        f"> 2024/01/31 12:00:00.123456  length={len(data)} from=0 to={len(data) - 1}\n"
        + "\n".join(f" {row.hex(' '):<47}  {_shown(row)}" for _, row in _rows(data, 16))
        + "\n--"
    ),
    "btmon, with the check sum": lambda data: (
        f"< ACL Data TX: Handle 42 flags 0x00 dlen {len(data) + 8}   #12 [hci0] 5.123456\n"
        "      RFCOMM: Unnumbered Info with Header Check (UIH) (0xef)\n"
        f"         Length: {len(data)}\n         FCS: 0x9a\n"
        + "\n".join(f"        {row.hex(' '):<47}  {_shown(row)}" for _, row in _rows(data + b"\x9a", 16))
    ),
    "interceptty": lambda data: "\n".join(
        f">\t0x{byte:02x} ({chr(byte) if 32 <= byte < 127 else '^' + chr(byte + 64) if byte < 32 else 'M-'})"
        for byte in data
    ),
    "XML, hex": lambda data: "<data>\n" + "\n".join(f"  <b>{byte:02X}</b>" for byte in data) + "\n</data>",
    "DataView": lambda data: "\n".join(f"view.setUint8({at}, 0x{byte:02x});" for at, byte in enumerate(data)),
    "println(HEX)": lambda data: "\n".join(f"{byte:X}" for byte in data),
    "strace -e write": lambda data: (
        f"write(3, {_c_string(data)}, {len(data)}) = {len(data)}\n"
        + "\n".join(
            f" | {at:05x}  {row[:8].hex(' '):<23}  {row[8:].hex(' '):<23}  {_shown(row):<16} |"
            for at, row in _rows(data, 16)
        )
    ),
    "explained": lambda data: (
        f"{data[:2].hex()} length\n{data[2:4].hex()} counter\n{data[4]:02x} type\n{data[5:].hex()} all the rest"
    ),
}
"""Notations of several lines."""

EVERY = LINE | LINES

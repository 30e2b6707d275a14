"""Names in the places of bytes: those of operations and types in any spelling, and others, which are unknown bytes."""

from __future__ import annotations

from support.cases import each

from ev3proto.text.paste import read_text

FRAME = bytes.fromhex("0D000100800000A500028132A60002")
"""DIRECT_COMMAND_NO_REPLY; OUTPUT_SPEED 50 of motor B; OUTPUT_START of motor B."""
BYTES = [f"0x{byte:02X}" for byte in FRAME]

LISTS = (
    ("C#", "new byte[] {{ {} }}", "(byte)CommandType.DirectNoReply", "(byte)Op.OutputSpeed", "(byte)Op.OutputStart"),
    ("Rust", "vec![{}]", "CommandType::DirectNoReply as u8", "OpCode::OutputSpeed as u8", "OpCode::OutputStart as u8"),
    (
        "Swift",
        "let cmd: [UInt8] = [{}]",
        "CommandType.directNoReply.rawValue",
        "Op.outputSpeed.rawValue",
        "Op.outputStart.rawValue",
    ),
    (
        "C++",
        "std::vector<uint8_t> v{{{}}};",
        "static_cast<uint8_t>(CommandType::DirectNoReply)",
        "static_cast<uint8_t>(Op::OutputSpeed)",
        "static_cast<uint8_t>(Op::OutputStart)",
    ),
    ("Go", "cmd := []byte{{{}}}", "byte(DirectCommandNoReply)", "byte(OpOutputSpeed)", "byte(OpOutputStart)"),
    (
        "Kotlin",
        "byteArrayOf({})",
        "CommandType.DIRECT_COMMAND_NO_REPLY.code.toByte()",
        "OpCode.OUTPUT_SPEED.code.toByte()",
        "OpCode.OUTPUT_START.code.toByte()",
    ),
)


@each("language, array, kind, speed, start", LISTS)
def test_a_name_in_a_list(language: str, array: str, kind: str, speed: str, start: str) -> None:
    values = [*BYTES[:4], kind, "0", "0", speed, *BYTES[8:12], start, *BYTES[13:]]
    (piece,) = read_text([array.format(", ".join(values))])
    assert (piece.data, piece.unknown) == (FRAME, ())


ROWS = (
    ("list.Add({});", "(byte)CommandType.DirectNoReply", "(byte)Op.OutputSpeed", "(byte)speed"),
    ("v.push_back({});", "DIRECT_COMMAND_NO_REPLY", "opOUTPUT_SPEED", "speed"),
    ("buf = append(buf, {})", "byte(DirectCommandNoReply)", "byte(OpOutputSpeed)", "byte(speed)"),
    ("data.append({})", "ev3.DIRECT_COMMAND_NO_REPLY", "Op.OUTPUT_SPEED.value", "speed"),
    ("arr.push({});", "CommandType.DIRECT_NO_REPLY", "Op.OUTPUT_SPEED", "speed"),
    ("cmd << {}", "CommandType::DIRECT_NO_REPLY", "Op::OUTPUT_SPEED", "speed"),
    ("$data[] = {};", "CommandType::DIRECT_NO_REPLY", "Op::OUTPUT_SPEED", "$speed"),
    ("buffer.put((byte) {});", "DIRECT_COMMAND_NO_REPLY", "opOUTPUT_SPEED", "speed"),
    ("msg[{at}] = {};", "(byte)CommandType.DirectNoReply", "(byte) Op.OutputSpeed", "(byte)speed"),
    ("view.setUint8({at}, {});", "DIRECT_COMMAND_NO_REPLY", "Op.OUTPUT_SPEED", "speed"),
)


@each("row, kind, speed, variable", ROWS)
def test_a_name_in_a_row(row: str, kind: str, speed: str, variable: str) -> None:
    values = [*BYTES[:4], kind, *BYTES[5:7], speed, *BYTES[8:11], variable, *BYTES[12:]]
    lines = [row.replace("{at}", str(at)).replace("{}", value) for at, value in enumerate(values)]
    (piece,) = read_text(lines)
    assert piece.data == FRAME.replace(b"\x32", b"\0")
    assert [(one.offset, one.line) for one in piece.unknown] == [(11, 12)]


UNKNOWN = (
    "{0x0D, 0, lo, hi, DIRECT_COMMAND_NO_REPLY, g, l, opOUTPUT_SPEED, LAYER_0, port, LC1, n, opOUTPUT_START, 0, port}",
    "cmd = [0x0D, 0x00, msg_lo, msg_hi, 0x80, g_lo, g_hi, 0xA5, LAYER, PORTS, LC1, speed, 0xA6, 0, PORTS]",
)


@each("text", UNKNOWN)
def test_names_that_mean_nothing_are_never_left_out(text: str) -> None:
    (piece,) = read_text([text])
    assert piece.data.hex() == "0d000000800000a500000000a60000"
    assert [one.offset for one in piece.unknown if one.text.lower().startswith("lc1")] == [10]


def test_calls_with_names_that_mean_nothing_are_not_a_frame() -> None:
    calls = "begin_direct(&frame, 42, DIRECT_COMMAND_REPLY, 4, 0);\noperation(&frame, opUI_READ, GET_VBATT);\n"
    assert not [piece for piece in read_text(calls.splitlines()) if piece.data]

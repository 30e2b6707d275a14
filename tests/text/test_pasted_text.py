from __future__ import annotations

from collections.abc import Iterator

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from support.notations import NOTATIONS

from ev3proto.text.paste import Pasted, read_argument, read_text

# SOUND TONE 1, 440, 1000, the lesson's tone.
TONE = bytes([14, 0, 42, 0, 128, 0, 0, 148, 1, 1, 130, 184, 1, 130, 232, 3])
REPLY = b"\x03\x00\x2a\x00\x02"


def pieces(text: str) -> list[Pasted]:
    return list(read_text(text.splitlines(keepends=True)))


def only(text: str) -> Pasted:
    found = pieces(text)
    assert len(found) == 1, found
    return found[0]


WAYS = {
    "underscores": "0e_00_2a_00_80_00_00_94_01_01_82_b8_01_82_e8_03",
    "lesson, no 0x": "0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|",
    "remark behind": "0e002a0080000094010182b80182e803  # a tone",
    "C array": """unsigned char cmd[] = {
        0x0E, 0x00,             // length
        0x2A, 0x00, 0x80, 0x00, 0x00,

        0x94, /* SOUND, {TONE} */ 0x01, 0x01,
        0x82, 0xB8, 0x01, 0x82, 0xE8, 0x03,
    };
    """,
    "dump of two lines": "0000  0e 00 2a 00 80 00 00 94                            ..*.....\n"
    "0008  01 01 82 b8 01 82 e8 03                            ab cd ef\n",
    "dump of three lines": "00000000: 0e00 2a00 80  ..*..\n"
    "00000005: 0000 9401 01  .....\n"
    "0000000a: 82b8 0182 e803  ......\n",
}
"""In addition to those of `docs/notations.md`."""


@pytest.mark.parametrize("way", WAYS.values(), ids=WAYS.keys())
def test_every_way_to_write_a_frame(way: str) -> None:
    pasted, argument = only(way), read_argument(way)
    assert (pasted.data, pasted.problem, pasted.cut, pasted.time, pasted.direction) == (TONE, None, False, None, None)
    assert pasted.line == 1 + (way.partition("\n")[0].strip()[-1:] == "{")
    assert (argument.data, argument.problem) == (TONE, None)


LOG = {
    "09:12:31.011558 Sent 0x|03:00|2A:00|02|": ("sent", "09:12:31.011558"),
    "19:45:30.898732 Recv 0x|03:00|2A:00|02|": ("received", "19:45:30.898732"),
    "[09:12:31] SENDING: 03002a0002": ("sent", "09:12:31"),
    "2024-01-31T09:12:31.5Z rx 03 00 2a 00 02": ("received", "2024-01-31T09:12:31.5Z"),
    "2024-01-31 09:12:31,011 DEBUG Received 5 bytes: 03 00 2a 00 02": ("received", "2024-01-31 09:12:31,011"),
    "INFO:ev3:Sent 0x|03:00|2A:00|02|": ("sent", None),
    r"Sent b'\x03\x00*\x00\x02'": ("sent", None),
    r"my_ev3.send(b'\x03\x00*\x00\x02')": ("sent", None),
    "09:12:31 read bytearray([3, 0, 42, 0, 2])": ("received", "09:12:31"),
    "bytes_read = {3, 0, 42, 0, 2};": ("received", None),
    # An arrow may point either way, but only bricks reply.
    "<- 03 00 2a 00 02": ("received", None),
    "> 03002a0002": ("received", None),
}


@pytest.mark.parametrize("line", LOG)
def test_log_lines(line: str) -> None:
    pasted = only(line)
    assert (pasted.data, pasted.problem) == (REPLY, None)
    assert (pasted.direction, pasted.time) == LOG[line]


@pytest.mark.parametrize(
    "line",
    [
        "11:39:49.039902 Sent 0x|3C:00|2A:00|80|00:00|82:1B:...",
        "11:39:49.039902 Sent 0x|3C:00|2A:00|80|00:00|82:1B:...\nThis is less than 6% of its maximum length.",
        "Sent 0x|3C:00|2A:00|80|00:00|82:1B:0...",
        "3c002a0080000082 1b ...",
        r"b'<\x00*\x00\x80\x00\x00\x82\x1b...",
        r"\x3c\x00*\x00\x80\x00\x00\x82\x1b…",
        "{60, 0, 42, 0, 128, 0, 0, 130, 27, ...}",
        "bytes.fromhex('3c002a0080000082 1b...')",
    ],
)
def test_lines_that_were_cut(line: str) -> None:
    pasted = only(line)
    assert pasted.data == b"\x3c\x00\x2a\x00\x80\x00\x00\x82\x1b"
    assert pasted.cut
    assert pasted.problem is None


def test_dots_inside_a_byte_string_are_bytes() -> None:
    pasted = only(r"b'\x06\x00*\x00\x80...'")
    assert (pasted.data, pasted.cut) == (b"\x06\x00*\x00\x80...", False)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "# 0e002a00",
        "d41d8cd98f00b204e9800998ecf8427e  empty.rbf",
        "read 00:16:53:42:2B:99",
        "09:12:31 09:12:32 09:12:33 09:12:34",
        "           00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F",
        r"\ len \ cnt \ty\ hd \op\cd\ Name \ ",
        r"\ 14 \ 42 \Re\ 0,0 \C \S \ \"myEV3\" \ ",
        "add face",
        "dead beef cafe is what they add",
        "We read 10 20 30 40 50 values",
        "Received 1234567890 bytes",
        "09:12:31 12 34",
        "But in fact, we send0x|84:6D:79:45:56:33:00|",
        "opCom_Set = 0x|D4|",
        "0x|84|",
        "0b 1000 0100 VVVV VVVV ... 0000 0000",
        "range: -2,147,483,647 – 2,147,483,647, length: 5 byte",
        "my_ev3 = ev3.EV3(protocol=ev3.BLUETOOTH, host='00:16:53:42:2B:99')",
        "ops = b''.join([",
        "if name == b'something long': pass",
        "as others found [1, 2, 3, 4, 5]",
        "VOLUME: in percent [0 - 100]",
        'Sent {"op": "SOUND", "args": []}',
        "void play(int volume) {\n  if (volume > 100) {\n    return;\n  }\n}",
        "colours = [\n  'red',\n  'green',\n]",
        "Don't add b'elieve",
    ],
)
def test_prose_yields_nothing(text: str) -> None:
    assert pieces(text) == []


def test_the_lines_of_a_block_that_is_not_an_array() -> None:
    text = (
        "void play() {\n\n  // 1, 2\n  send(b'\\x03\\x00*\\x00\\x02');\n  char nop[] = {6, 0, 42, 0, 128, 0, 0, 1};\n}"
    )
    assert [(piece.line, piece.data) for piece in pieces(text)] == [
        (4, REPLY),
        (5, b"\x06\x00\x2a\x00\x80\x00\x00\x01"),
    ]


NUMBERS_OF_PROSE = (
    "{} <script>alert(1)</script>",
    "{} <td>1</td>",
    "{} = 16 bytes",
    "sent {} (16)",
    "say '{}' (16)",
    "{} took(3)",
    "['{}'].pack('C*')",
)


@pytest.mark.parametrize("form", NUMBERS_OF_PROSE)
def test_a_number_of_prose_is_not_the_last_byte(form: str) -> None:
    assert [(piece.data, piece.problem) for piece in pieces(form.format(TONE.hex()))] == [(TONE, None)]
    assert only("[6, 0, 42, 0, 128, 0, 0, 1] (8)").data == b"\x06\x00*\x00\x80\x00\x00\x01"


def test_a_byte_in_brackets_or_a_call_is_one() -> None:
    assert only("x = [6, 0, 42, 0, 128, 0, 0, chr(1)]").data == b"\x06\x00*\x00\x80\x00\x00\x01"
    assert only("x = [6, 0, 42, 0, 128, 0, 0, (byte)1]").data == b"\x06\x00*\x00\x80\x00\x00\x01"
    assert only("0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 (03)").data == TONE


def test_several_frames_in_a_line() -> None:
    assert [piece.data for piece in pieces(f"frames = [{TONE!r}, {REPLY!r}]")] == [TONE, REPLY]
    assert [piece.data for piece in pieces(f"frames = [{list(TONE)}, {list(REPLY)}]")] == [TONE, REPLY]
    both = pieces("Sent 0x|06:00|2A:00|00|00:00|01| Recv 0x|03:00|2A:00|02|")
    assert [(piece.data, piece.direction) for piece in both] == [
        (b"\x06\x00\x2a\x00\x00\x00\x00\x01", "sent"),
        (REPLY, "received"),
    ]


def test_frames_among_other_lines_know_their_lines() -> None:
    text = "The reply is:\n----------------\n0x|03:00|2A:00|02|\n----------------\n\n0000  03 00 2a 00 02\n03002a0002\n"
    assert [(piece.line, piece.data) for piece in pieces(text)] == [(3, REPLY), (6, REPLY), (7, REPLY)]


def test_a_dump_that_starts_anew_is_another_one() -> None:
    text = "0000  03 00 2a 00 02\n0000  03 00 2a 00 02\n0005  03 00 2a 00 02\n"
    assert [(piece.line, piece.data) for piece in pieces(text)] == [(1, REPLY), (2, REPLY), (3, REPLY)]


def test_a_dump_in_words_that_breaks_off_is_the_start_of_a_frame() -> None:
    assert read_argument("0000000 000e 002a 0080 9400 0101 b882 8201 03e8").data == TONE
    assert read_argument("0000000 000e 002a 0080 9400 0101 b882 8201").data == TONE[:14]


SHORT_OF_A_FRAME = {
    TONE.hex()[:-2]: None,
    TONE.hex() + "00": None,
    TONE.hex()[:-1]: "odd number of hex digits (31)",
    "03002a007f": None,
    "0e 0 02a0080000094010182b80182e803": "odd number of hex digits",
}


@pytest.mark.parametrize("text", SHORT_OF_A_FRAME)
def test_hex_that_is_not_a_frame_is_read_as_bytes(text: str) -> None:
    found, problem = read_argument(text), SHORT_OF_A_FRAME[text]
    if problem is None:
        assert (found.data.hex(), found.problem) == (text, None)
    else:
        assert problem in (found.problem or "")


ARGUMENTS = {
    "0E": b"\x0e",
    "0x|03:00|": b"\x03\x00",
    "[14, 0]": b"\x0e\x00",
    r"b'\x0e'": b"\x0e",
    r"\x0e": b"\x0e",
    "dead beef cafe": b"\xde\xad\xbe\xef\xca\xfe",
    "0e 00 2a\n00 80": b"\x0e\x00\x2a\x00\x80",
}


@pytest.mark.parametrize("text", ARGUMENTS)
def test_an_argument_may_be_short(text: str) -> None:
    pasted = read_argument(text)
    assert (pasted.data, pasted.problem) == (ARGUMENTS[text], None)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "empty"),
        ("hello", "column 1: 'hello' is not hex"),
        ("robot.log", "column 1: 'robot.log' is not hex"),
        ("0e0", "odd number"),
        (
            "0e002a0080000094010182b80182e80",
            "'0e002a0080000094010182b…' has an odd number of hex digits (31)",
        ),
        ("0e002a0080000094010182b80182e80g", "column 32: 'g' is not a hex digit"),
        ("0x0e002a0080000094010182b80182eg", "column 32: 'g' is not a hex digit"),
        ("[300]", "more than 255"),
        ("0x0E, 0x1FF", "column 7: '0x1FF' is more than 255"),
        ("--", "column 1"),
        ("some\nprose", "column 1"),
        ("Sent 03002a0002\nSent 03002a0002", "2 frames"),
    ],
)
def test_an_argument_that_cannot_be_read_has_a_problem(text: str, reason: str) -> None:
    assert reason in (read_argument(text).problem or "")


def framed(content: bytes) -> bytes:
    return len(content).to_bytes(2, "little") + content


FORMATS = (
    *("lesson", "hex", "blanks", "colons", "dashes", "commas without 0x", "0x, unpadded"),
    *("hex escapes", "repr", "bytearray", "Rust", "bytes()", "fromhex", "Erlang"),
    *("C in rows", "Wireshark", "xxd"),
)


@pytest.mark.parametrize("form", FORMATS)
@given(data=st.binary(min_size=2, max_size=100).map(lambda body: framed(b"\x2a\x00\x80" + body)))
@example(data=framed(b"00\x80000"))
@example(data=framed(b"\xaa\xaa\x80" + b"\xaa" * 16))
@example(data=framed(b"ab\x80 cd ef 00 11 22"))
@example(data=framed(b"\0" * 40))
def test_any_bytes_in_any_form(form: str, data: bytes) -> None:
    text = NOTATIONS[form](data)
    pasted = only(text)
    assert (pasted.data, pasted.problem, pasted.cut) == (data, None, False)
    argument = read_argument(text)
    assert (argument.data, argument.problem, argument.cut) == (data, None, False)


SCRAPS = st.sampled_from(
    [
        "0x|",
        "0e:00|",
        "b'",
        "\\x",
        "\\x0e",
        "'",
        '"',
        "{",
        "[",
        "}",
        "]",
        "14, ",
        "//",
        "/*",
        "*/",
        "Sent ",
        "09:12:31 ",
        "...",
        "…",
        "0000  ",
        "00000010: ",
        "\n",
        "*",
        "fromhex('",
        "0e ",
        "\\",
        "\x00",
        "\ud800",
        "²",
        "300",
        "->",
        "|",
    ]
)


@given(text=st.one_of(st.text(), st.lists(SCRAPS).map("".join)))
def test_no_text_raises(text: str) -> None:
    for pasted in [*pieces(text), *read_text([text]), read_argument(text)]:
        assert pasted.line >= 1
        assert len(pasted.text) <= 200
        assert pasted.problem is None or pasted.problem


def test_a_frame_above_an_empty_line_in_an_open_call() -> None:
    text = 'assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")\n\n'
    assert [(piece.line, piece.data) for piece in pieces(text)] == [(1, b"\x03\x00\x07\x00\x02")]


def test_frames_in_consecutive_calls() -> None:
    lines = (
        '(system_7(0x9B, b"x\\0"), "05 00 07 00 05 9b 05", "creates or changes files"),',
        '(system_7(0x92, b"\\5\\0\\0\\0x\\0"), "06 00 07 00 05 92 05 ff", "creates or changes files"),',
        '(system_7(0x55, b""), "05 00 07 00 05 55 05", "the frame may do anything"),',
    )
    assert [piece.line for piece in read_text(lines)] == [1, 2, 3]


def test_collected_text_is_bounded() -> None:
    row = "0x01, " * 16 + "\n"
    pasted = only("uint8_t x[] = {\n" + row * 700 + "};")
    assert "64 KiB" in (pasted.problem or "")
    rows = (f"{offset:08x}  {'01 ' * 16}\n" for offset in range(0, 1 << 15, 16))
    (dump,) = read_text(rows)
    assert "64 KiB" in (dump.problem or "")


def test_a_line_of_a_megabyte_is_read_and_a_longer_one_is_not() -> None:
    long = pieces(TONE.hex() * (1 << 15))
    assert [len(piece.data) for piece in long] == [16] * (1 << 15)
    too_long = only("00" * (1 << 19) + "0")
    assert too_long.data == b""
    assert "was not read" in (too_long.problem or "")


AT_ONCE = {
    "03 00 2a 00 02": 1,
    TONE.hex(): 1,
    "Sent 0x|06:00|2A:00|80|00:00|01|": 1,
    "12:30:45 sent 06 00 2a 00 80 00 00 82": 1,
    # The last operation is unknown, so no line below can complete it.
    "07 00 2a 00 80 00 00 01 fb": 1,
    # Bytes are missing, or follow the frame: the next line may continue it.
    "06 00 2a 00 80 00 00 82": 2,
    "06 00 2a 00 80 00 00 82 e8 03": 2,
    "Sent 0x|09:00|2A:00|80|00:00|01|": 2,
}
"""Lines with a frame, and how many are read before it is given out."""


@pytest.mark.parametrize("line", AT_ONCE)
def test_lines_are_read_as_they_come(line: str) -> None:
    given_out: list[int] = []

    def lines() -> Iterator[str]:
        for number in range(3):
            given_out.append(number)
            yield f"{line}\n"

    found = read_text(lines())
    assert next(found).line == 1
    assert len(given_out) == AT_ONCE[line]


def test_a_dump_is_shown_with_its_last_row() -> None:
    given_out: list[int] = []

    def lines() -> Iterator[str]:
        for number, line in enumerate((TONE[:8].hex(" "), TONE[8:].hex(" "), "and later", "more")):
            given_out.append(number)
            yield f"{line}\n"

    assert next(read_text(lines())).data == TONE
    assert given_out == [0, 1]


@pytest.mark.parametrize(
    ("line", "data"),
    [
        ("Sent 0x|03:00|", b"\x03\x00"),
        ("0x|0E:00|2A", b"\x0e\x00\x2a"),
        ("0x|0E:00|2A...", b"\x0e\x00\x2a"),
    ],
)
def test_a_frame_that_lost_most_of_itself_is_not_lost_too(line: str, data: bytes) -> None:
    (pasted,) = read_text(["some words about it\n", f"{line}\n"])
    assert (pasted.data, pasted.problem, pasted.line) == (data, None, 2)


def test_a_long_truncated_frame_is_not_read_as_operations() -> None:
    body = "82:1B:02:94:01:01:82:06:01:82:F4:01:96:82:1B:01:94:01:01:82:4A:01:82:F4:01:96:82:1B:02"
    pasted = only(f"Sent 0x|3C:00|2A:00|80|00:00|{body}:...")
    assert (len(pasted.data), pasted.cut, pasted.direction) == (36, True, "sent")

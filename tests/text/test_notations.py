"""Every notation in which real programs write bytes, with all that people write around them."""

from __future__ import annotations

import random
from itertools import product

import pytest
from support.cases import each
from support.notations import EXAMPLES, NOTATIONS

from ev3proto.text.paste import Pasted, read_argument, read_text
from ev3proto.text.paste.elements import FORMS, Form, elements_of

TONE = bytes.fromhex("0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03")
NOTHING = bytes.fromhex("06 00 2a 00 00 00 00 01")
NAME = bytes.fromhex("0e 00 2a 00 00 00 00 d4 08 84 6d 79 45 56 33 00")
REPLY = bytes.fromhex("07 00 2a 00 02 00 00 d0 41")
LIST = bytes.fromhex("1f 00 01 00 01 99 e8 03") + b"/home/root/lms2012/prjs/\0"
TEXT = bytes.fromhex("2e 00 10 27 80 00 00 84 05 01 00 0a 84") + b'He said: "it\'s 0f 00", (0x12)\\n!\0\x84\0'
TEXT = (len(TEXT) - 2).to_bytes(2, "little") + TEXT[2:]
FRAMES = {"tone": TONE, "name": NAME, "reply": REPLY, "list": LIST, "text": TEXT}


def pieces(text: str) -> list[Pasted]:
    return list(read_text(text.splitlines(keepends=True)))


def frame_of(piece: Pasted) -> bytes:
    """A piece without the padding that may follow its frame."""
    size = int.from_bytes(piece.data[:2], "little") + 2
    return piece.data if any(piece.data[size:]) else piece.data[:size]


def the_only(text: str) -> bytes:
    """Reads a text in which there is one frame, without a problem."""
    (piece,) = pieces(text)
    assert piece.problem is None
    return frame_of(piece)


@each("example", EXAMPLES)
def test_the_examples_on_the_page_of_notations(example: str) -> None:
    assert len(EXAMPLES) > 150
    assert the_only(example) == TONE
    assert frame_of(read_argument(example)) == TONE
    assert (
        the_only(f"I tried it on 2024-01-31 at 12:30:\n\n{example}\n\nand my EV3 (00:16:53:42:2B:99) was silent.\n")
        == TONE
    )


@each("name, frame", product(NOTATIONS, FRAMES.values()))
def test_a_notation_of_other_frames(name: str, frame: bytes) -> None:
    assert the_only(NOTATIONS[name](frame)) == frame


BYTE_ON_A_LINE = (
    "  {at}: {byte}",
    "    [{at}] => {byte}",
    "    {byte},",
    "  0x{byte:02x}, # byte {at}",
    "  cmd[{at}] = 0x{byte:02X};",
    "{at},{byte}",
    "\t[{at}]\t0x{byte:02x}\tbyte",
    ">\t0x{byte:02x} (M-)",
    "  <b>{byte:02X}</b>",
    "view.setUint8({at}, 0x{byte:02x});",
    "{byte:X}",
)


@each("form, frame", product(BYTE_ON_A_LINE, FRAMES.values()))
def test_a_byte_on_each_line(form: str, frame: bytes) -> None:
    assert the_only("\n".join(form.format(at=at, byte=byte) for at, byte in enumerate(frame))) == frame


PREFIXES = {
    "robot send: {}": "sent",
    "EV3 <- {}": "by type",
    "D/EV3 ( 1234): send {}": "sent",
    "brick >> {}": "by type",
    "frame 12: {}": None,
    "Sent to EV3: {}": "sent",
    "<- {}": "by type",
    ">>> {}": "by type",
    "< {}": "by type",
    "12:30:45 PC => {}": "by type",
    "{}.": None,
    "It was {}, I think.": None,
    "12:30:45.123 -> {}": "by type",
    "2024-01-31T12:30:45 ev3[1234]: recv {}": "received",
    "to 00:16:53:42:2B:99: {}": None,
    "len=17 data={} ok": None,
    "{} (17 bytes)": None,
    "| {} |": None,
    "\x1b[32mINFO\x1b[0m {}": None,
    '{{"t": 12, "data": "{}"}}': None,
}

PLAIN = ("blanks", "0x and commas", "dashes", "lesson", "Go", "repr")


@each("prefix, name", product(PREFIXES, PLAIN))
def test_text_around_a_frame(prefix: str, name: str) -> None:
    for frame in (TONE, REPLY, NAME):
        text = prefix.format(NOTATIONS[name](frame))
        found = pieces(f"once\n{text}\nagain\n")
        assert [(piece.data, piece.problem, piece.line) for piece in found] == [(frame, None, 2)], text
        said = PREFIXES[prefix]
        if said == "by type":
            said = "received" if frame is REPLY else "sent"
        assert found[0].direction == said, text


@each("name", [name for name, notation in NOTATIONS.items() if "\n" not in notation(TONE)])
def test_lines_that_hold_a_whole_frame_each_stay_apart(name: str) -> None:
    text = "\n".join(f"x: {NOTATIONS[name](frame)}" for frame in (TONE, NAME, TONE))
    assert [(frame_of(piece), piece.line) for piece in pieces(text)] == [(TONE, 1), (NAME, 2), (TONE, 3)], text


NAMES = {
    "{0x0f, 0, 0, 0, DIRECT_COMMAND_NO_REPLY, 0, 0, opSOUND, LC0(TONE), LC1(2), LC2(1000), LC2(1000)}": TONE,
    "cmd = [15, 0, 0, 0, 0x80, 0, 0,\n  opSOUND, LC0(1),  # the tone\n  LC1(2), LC2(1000),\n  LC2(1000)]": TONE,
    'byte[] x = { 0x0e, 0, 0x2a, 0, 0, 0, 0, opCOM_SET, LC0(SET_BRICKNAME), LCS("myEV3") };': NAME,
    "{\n 0x0D, 0, 1, 0, 0x80, 0, 0,\n opOUTPUT_POWER, LC0(0), LC0(1), LC1(50),\n opOUTPUT_START, LC0(0), LC0(1)\n}": (
        bytes.fromhex("0d 00 01 00 80 00 00 a4 00 01 81 32 a6 00 01")
    ),
    # As docs/howto/c.md has it.
    "static const uint8_t tone[] = {\n    EV3_HEADER(17, 0, DIRECT_COMMAND_NO_REPLY), EV3_MEMORY(0, 0),\n"
    "    opSOUND, LC0(TONE), LC1(2), LC2(1000), LC2(1000)\n};\n": TONE,
    "{EV3_HEADER(10, 0x2A, DIRECT_COMMAND_REPLY), EV3_MEMORY(4, 0), opUI_READ, LC0(GET_VBATT), GV0(0)}": bytes.fromhex(
        "08 00 2a 00 00 04 00 81 01 60"
    ),
}


@pytest.mark.parametrize("text", NAMES)
def test_names_of_constants_in_arrays(text: str) -> None:
    assert [piece.data for piece in pieces(text)] == [NAMES[text]]


def test_an_omitted_counter() -> None:
    frame = TONE[:2] + b"\0\0" + TONE[4:]
    rest = TONE[4:].hex()
    for text in (
        f"0F00xxxx{rest}",
        f"0F 00 xx xx {TONE[4:].hex(' ')}",
        f"0F 00 ?? ?? {TONE[4:].hex(' ')}",
        f"0F00 XXXX {rest}",
        f"0F:00:xxxx:{TONE[4:].hex(':')}",
    ):
        assert [piece.data for piece in pieces(f"Start: {text}")] == [frame], text


ANNOTATED = (
    "0E00 (length) 2A00 (counter) 80 (type) 0000 94 01 01 82 B801 82 E803",
    "0E00 (length) 2A00 (counter) 80 (type) 0000 (memory) 94 01 01 82B801 82E803",
    "0E 00 [length] 2A 00 [counter] 80 [type] 00 00 [memory] 94 01 01 82 B8 01 82 E8 03 [tone]",
    "length 0E 00, counter 2A 00, type 80, memory 00 00, tone 94 01 01 82 B8 01 82 E8 03",
)


@pytest.mark.parametrize("text", ANNOTATED)
def test_annotated_hex_of_forums(text: str) -> None:
    assert [piece.data.hex() for piece in pieces(text)] == ["0e002a0080000094010182b80182e803"]


NO_FRAMES = (
    "00:16:53:42:2B:99",
    "da39a3ee5e6b4b0d3255bfef95601890afd80709",
    "00001101-0000-1000-8000-00805F9B34FB",
    "2024-01-31T12:30:45.123456Z",
    "2024-01-31 12:30:45.123 INFO  sha1 da39a3ee5e6b4b0d3255bfef95601890afd80709",
    "192.168.1.100:5555",
    "2001:0db8:85a3:0000:0000:8a2e:0370:7334",
    "[1, 2, 3, 4, 5, 6, 7, 8]",
    "x = 3.14, y = 2.71, 100%",
    "00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F",
    "the face of a bad cab faded",
    "font-size: 12px; color: #0f0000; #ffffff",
    "9c2e79b57d0c4d70045d080062aa0918524ac0f7  file7444.bin",
    '         rx="0.56326956"',
    "inet6 fe80::e39b:05ff:fe28:1a50/64 scope link",
    "const odd = _.without([1, 2, 1, 0, 3, 1, 4], 0, 1);",
    r"3[0-1]|[1-2]\d|0[1-9]|[1-9]| [1-9]",
    'd="M15 7a4,4 0 0 1 4,4 V 58 H 18 V 37 a 4,4 0 0 1 4,-4 z"',
    "rusersd\t\t100002\trusers\nnfs\t\t100003\tnfsprog\nypserv\t\t100004\typprog\nmountd\t\t100005\tmount\n"
    "ypbind\t\t100007\nwalld\t\t100008\trwall shutdown\nyppasswdd\t100009\typpasswd",
    "(C) 1992, 1997-2002, 2004-2022",
    "d. Sections 1, 5, 6, 7, a",
    "for (i = 0; i < 10; i++) a[i] = f(x, y, 0, 0, 0, n);",
    "12:30:45 read 2,040,294 bytes",
    "TEMPLATE=/tmp/XXXXXXXXXX",
    "// Prints: <Buffer 04 03 02 01 08 07 06 05>",
    "regex [012][0-9][0-9][0-9]-[012][0-9]-[0123][0-9]",
)


@pytest.mark.parametrize("text", NO_FRAMES)
def test_text_that_does_not_look_like_a_frame(text: str) -> None:
    assert pieces(f"first\n{text}\nlast\n") == []


def test_long_lists_of_addresses_have_no_frames() -> None:
    addresses = [":".join(f"{(13 * place + line) % 251:02x}" for place in range(6)) for line in range(4000)]
    assert pieces("\n".join(addresses)) == []


BATTERY = "08 00 01 00 00 04 00 81 01 60"
ANSWER = "07 00 01 00 02 a4 70 fd 40"
DIALOGUES = (
    "sending {}\ngot {}",
    "out: {}\nin: {}",
    "Sending:\n{}\nReceived:\n{}",
    "12:30:45.123 Outgoing\n  {}\n12:30:45.133 Incoming\n  {}",
    "TX: {} RX: {}",
    "> 2024/01/31 12:00:00.123456  length=10 from=0 to=9\n {}\n< 2024/01/31 12:00:00.133456  length=9 from=0 to=8\n {}",
    "> 00000000 {} # ..........\n< 00000000 {} # ......p.@",
    "| 1 | sent | `{}` |\n| 2 | received | `{}` |",
    "0.000,TX,{}\n0.010,RX,{}",
)


@pytest.mark.parametrize("text", DIALOGUES)
def test_sent_and_received(text: str) -> None:
    found = pieces(text.format(BATTERY, ANSWER))
    assert [(piece.data.hex(" "), piece.direction) for piece in found] == [(BATTERY, "sent"), (ANSWER, "received")]


def test_a_frame_that_a_line_shows_twice_is_one() -> None:
    text = f'<field showname="Data: {TONE.hex()}" show="{TONE.hex(":")}" value="{TONE.hex()}"/>'
    assert [piece.data for piece in pieces(text)] == [TONE]
    assert [piece.data for piece in pieces(f"sent {TONE.hex()}, then {TONE.hex()}")] == [TONE, TONE]


def test_a_dump_of_strace_is_only_dropped_where_its_string_is() -> None:
    dump = " | 00000  06 00 2a 00 00 00 00 01                           ..*..... |"
    string = r'write(3, "\6\0*\0\0\0\0\1", 8) = 8'
    assert [piece.line for piece in pieces(f"{string}\n{dump}\n{string}\n{dump}\n")] == [1, 3]
    assert [piece.data for piece in pieces(f"write(3, ...) = 8\n{dump}\n")] == [NOTHING]


@each("form", [form for form in FORMS if form.kind == "run"])
def test_the_example_of_a_run_is_many_values(form: Form) -> None:
    assert [(token.kind, token.text) for token in elements_of(form.example)[0]] == [
        ("digits", text) for text in form.example.split()
    ]


@each("form", [form for form in FORMS if form.kind not in ("blank", "other", "word", "run")])
def test_the_example_of_a_value_is_one(form: Form) -> None:
    before, value, after = form.example.split("|") if form.example.count("|") == 2 else ("", form.example, "")
    assert (form.kind, value) in [(token.kind, token.text) for token in elements_of(f"{before}{value}{after}")[0]]


@each("form", [form for form in FORMS if form.kind in ("blank", "other")])
def test_the_example_of_other_things_is_stepped_over(form: Form) -> None:
    before, what, after = form.example.split("|") if form.example.count("|") == 2 else ("", form.example, "")
    values = elements_of(f"{before or '0f '}{what}{after}")[0]
    assert [token.text for token in values] in (["0f"], ["0x0f"], ["97"])


def test_rows_of_bytes_of_which_some_are_db() -> None:
    """Assemblers write db before bytes, and among pairs of digits it is a byte."""
    frame = bytes.fromhex("5b022a000193000400") + bytes(range(0xDB, 0x100)) * 16 + bytes([0xDB] * 4)
    assert len(frame) == 0x25B + 2
    for width in (8, 16, 20):
        rows = [frame[at : at + width].hex(" ") for at in range(0, len(frame), width)]
        for text in ("\n".join(rows), "\n".join(rows).upper()):
            assert the_only(text) == frame
    for last in ("db", "db 41", "db 41 42 43"):
        row = b"\x11\x00*\0\x80" + bytes(11)
        data = (len(row) + len(bytes.fromhex(last)) - 2).to_bytes(2, "little") + row[2:] + bytes.fromhex(last)
        for name in ("xxd", "Wireshark", "hexdump -C"):
            assert the_only(NOTATIONS[name](data)) == data


@pytest.mark.parametrize("directive", ["db", "DB", "fcb", ".byte", "dc.b", "defb", "  DATA"])
def test_directives_of_assemblers_in_front_of_each_row(directive: str) -> None:
    rows = [TONE[:7], TONE[7:]]
    for form in ("0x{:02x}", "{}"):
        text = "\n".join(f"  {directive} {', '.join(map(form.format, row))}" for row in rows)
        assert the_only(text) == TONE, text
    hexadecimal = "\n".join(f"   {directive} {', '.join(map('0x{:02x}'.format, row))}" for row in rows)
    assert the_only(f"tone:{hexadecimal}") == TONE


@pytest.mark.parametrize("size", [1_100, 5_000])
def test_downloads_longer_than_other_frames(size: int) -> None:
    data = random.Random(size).randbytes(size)
    frame = (size + 5).to_bytes(2, "little") + bytes.fromhex("2a00019300") + data
    rows = [frame[at : at + 16] for at in range(0, len(frame), 16)]
    dump = [f"{16 * number:08x}: {row.hex(' ', 2)}" for number, row in enumerate(rows)]
    for text in (frame.hex(), "\n".join(row.hex(" ") for row in rows), "\n".join(dump)):
        (piece,) = pieces(text)
        assert piece.data == frame


def test_a_frame_with_a_wrong_length_is_not_dropped_for_the_next_line() -> None:
    lines = ["09:00|2A:00|80|00:00|81|01|60|", "06:00|2A:00|00|00:00|01|"]
    assert [(piece.line, len(piece.data)) for piece in read_text(iter(lines))] == [(1, 10), (2, 8)]


MAILBOX = bytes.fromhex("0c 00 01 00 81 9e 04 61 62 63 00 01 00 01")
CHARACTERS = (
    "byte msg[] = {0x0C, 0x00, 0x01, 0x00, 0x81, 0x9E, 0x04, 'a', 'b', 'c', 0x00, 0x01, 0x00, 0x01};",
    "new byte[] { 0x0C, 0, 1, 0, (byte)0x81, (byte)0x9E, 4, (byte)'a', (byte)'b', (byte)'c', 0, 1, 0, 1 };",
    "[12, 0, 1, 0, 0x81, 0x9E, 4, ord('a'), ord('b'), ord('c'), 0, 1, 0, 1]",
    "<<12,0,1,0,129,158,4,$a,$b,$c,0,1,0,1>>",
    "m[0]=12;m[1]=0;m[2]=1;m[3]=0;m[4]=0x81;m[5]=0x9e;m[6]=4;m[7]='a';m[8]='b';m[9]='c';m[10]=0;m[11]=1;m[12]=0;m[13]=1;",
    "bytes([12, 0, 1, 0, 0x81, 0x9e, 4]) + b'abc\\0' + bytes([1, 0, 1])",
    "".join(f"BT.write(0x{byte:02X}); " for byte in MAILBOX).replace(
        "BT.write(0x61); BT.write(0x62); BT.write(0x63); ", 'BT.print("abc"); '
    ),
    "".join(f"BT.write((byte)0x{byte:02X});\n" for byte in MAILBOX).replace(
        "BT.write((byte)0x61);\nBT.write((byte)0x62);\nBT.write((byte)0x63);\n", 'BT.print("abc");\n'
    ),
)


@pytest.mark.parametrize("text", CHARACTERS)
def test_characters_in_quotes_are_their_codes(text: str) -> None:
    assert the_only(text) == MAILBOX


def test_a_character_alone_in_quotes_may_be_a_digit() -> None:
    assert (
        the_only("['f', '0', '0', '0', '80', '0', '0', '94', '1', '81', '2', '82', 'e8', '3', '82', 'e8', '3']") == TONE
    )


@pytest.mark.parametrize("form", ["data[{at}] = {value};\n", "data[{at}] = {value}; "])
def test_the_size_in_a_variable(form: str) -> None:
    values = ["totalLength", *(f"0x{byte:02X}" for byte in MAILBOX[1:])]
    (piece,) = pieces("".join(form.format(at=at, value=value) for at, value in enumerate(values)))
    assert piece.data == MAILBOX
    assert [(one.offset, one.line, one.text) for one in piece.unknown] == [(0, 1, "totalLength")]


SCANNED = {
    "06 00 2a 00 8O 00 00 01": "column 13: '8O' is not hex; did you mean '80'?",
    "0e 00 2a 00 80 00 00 94 0l 01 82 b8 01 82 e8 03": "column 25: '0l' is not hex; did you mean '01'?",
    "O6002a0080000001": "column 1: 'O6002a0080000001' is not hex; did you mean '06002a0080000001'?",
}


@pytest.mark.parametrize("text", SCANNED)
def test_letters_for_digits_as_pictures_are_scanned(text: str) -> None:
    (piece,) = pieces(text)
    assert piece.problem == SCANNED[text]


def test_rows_of_matlab_that_are_printed_in_blocks() -> None:
    rows = "\n".join("".join(f"{byte:6}" for byte in part) for part in (TONE[:13],))
    rest = "".join(f"{byte:6}" for byte in TONE[13:])
    assert the_only(f"  Columns 1 through 13\n\n{rows}\n\n  Columns 14 through 17\n\n{rest}\n") == TONE


@pytest.mark.parametrize(
    "text", ["{length = 17, bytes = 0x0f000000 80000094 ... e80382e8 03}", "<0f000000 80000094 ... 03>"]
)
def test_data_of_objective_c_that_is_cut_in_the_middle(text: str) -> None:
    (piece,) = pieces(text)
    assert (piece.data, piece.cut) == (TONE[:8], True)
    assert "NSData" in piece.notes[0]

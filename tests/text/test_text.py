"""The output of messages: tree, annotated table, assembly, JSON."""

from __future__ import annotations

import json
from typing import Any

import pytest
from support.cli import run_ev3proto_text

from ev3proto import Dialogue, parse
from ev3proto.text.forms import as_c
from ev3proto.text.phrases import Seen, dialogue_line, plain, short_float
from ev3proto.text.spans import plain_text
from ev3proto.text.table import table
from ev3proto.text.tree import tree

pytestmark = pytest.mark.portable

TONE = bytes.fromhex("0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03")
NAME = bytes.fromhex("0E 00 2A 00 00 00 00 D4 08 84 6D 79 45 56 33 00")
ASK = bytes.fromhex("08 00 01 00 00 04 00 81 01 60")
ANSWER = bytes.fromhex("07 00 01 00 02 A4 70 FD 40")
LIST = bytes.fromhex("0C 00 01 00 01 99 E8 03") + b"/prjs\0"
LISTED = bytes.fromhex("0F 00 01 00 03 99 08 07 00 00 00 00") + b"a.rbf"
REFUSED = bytes.fromhex("05 00 01 00 05 99 06")
DOWNSTREAM = bytes.fromhex("09 00 01 00 0A A0 00 01 A6 00 0F")
UNKNOWN = bytes.fromhex("06 00 01 00 80 00 00 FE")


def shown(frame: bytes, seen: Seen | None = None, *, before: bytes | None = None) -> list[str]:
    dialogue = Dialogue()
    if before is not None:
        dialogue.feed(parse(before))
    lines = tree(dialogue.follow(parse(frame, strict=False)), seen or Seen())
    return [plain_text(line) for line in lines]


def as_json(*frames: bytes | str) -> list[dict[str, Any]]:
    """Returns the output of `decode --json` for frames, or for a log line."""
    words = [frame if isinstance(frame, str) else frame.hex() for frame in frames]
    return list(map(json.loads, run_ev3proto_text("decode", "--json", *words).stdout.splitlines()))


def drawn(frame: bytes) -> list[str]:
    return [plain_text(line) for line in table(Dialogue().follow(parse(frame, strict=False)), Seen())]


def test_the_tree_of_a_command() -> None:
    assert shown(TONE, Seen("sent", "09:12:31.011558")) == [
        "09:12:31.011558 sent DIRECT_COMMAND_NO_REPLY, counter 42, 16 bytes",
        "     7  SOUND.TONE  Plays one tone and returns at once",
        "     9    VOLUME    = 1 %  LC0: volume",
        "    10    FREQUENCY = 440 Hz  LC2: pitch; the driver clamps it to the range",
        "    13    DURATION  = 1000 ms  LC2: duration, read unsigned (-1 is 65535)",
    ]


def test_the_byte_of_a_small_negative_number_is_shown() -> None:
    power = bytes.fromhex("09 00 2A 00 80 00 00 A4 00 01 32")
    assert shown(power)[-1] == "    10    POWER = -14 %  LC0 0x32: unregulated power; negative: backward"


def test_the_tree_of_a_reply_reads_its_memory() -> None:
    assert shown(ANSWER, before=ASK) == [
        "DIRECT_REPLY, counter 1, 9 bytes: ok",
        "     5  UI_READ.GET_VBATT VALUE = 7.92 V  DATAF",
    ]
    assert shown(ANSWER) == [
        "DIRECT_REPLY, counter 1, 9 bytes: ok (the command it answers was not seen)",
        "     5  global memory: A4 70 FD 40  DATAF 7.92 or DATA32 1090351268",
    ]


def test_an_error_alone_names_the_next_step() -> None:
    """It does not say what is wrong with the command."""
    assert shown(bytes.fromhex("03 00 2A 00 04")) == [
        "DIRECT_REPLY_ERROR, counter 42, 5 bytes: error"
        " (the command it answers was not seen: check that one to find the fault)"
    ]


def mailbox(payload: bytes) -> bytes:
    body = bytes.fromhex("2A 00 81 9E 04") + b"abc\0" + len(payload).to_bytes(2, "little") + payload
    return len(body).to_bytes(2, "little") + body


def test_messages_to_mailboxes_are_shown_as_all_that_they_can_mean() -> None:
    def last(payload: bytes) -> str:
        return shown(mailbox(payload))[-1]

    assert last(b"hi\0") == '        payload        = 68 69 00  text "hi"'
    assert last(bytes.fromhex("0000C03F")) == "        payload        = 00 00 C0 3F  number 1.5"
    assert last(b"abc\0") == '        payload        = 61 62 63 00  number 9.127006e-39 or text "abc"'
    assert last(b"\0") == '        payload        = 00  logic false or text ""'
    assert last(b"\1") == "        payload        = 01  logic true"
    assert last(b"hi") == "        payload        = 68 69"
    assert drawn(mailbox(b"hi\0"))[-1] == 'WRITEMAILBOX payload = text "hi"'
    assert drawn(mailbox(b"hi"))[-1].startswith("---")


def test_messages_to_mailboxes_are_read_in_json_too() -> None:
    def read(payload: bytes) -> object:
        (entry,) = as_json(mailbox(payload))
        assert entry["fields"]["payload"] == payload.hex()
        return entry.get("readings")

    assert read(b"hi\0") == {"text": "hi"}
    assert read(b"\0") == {"logic": False, "text": ""}
    assert read(bytes.fromhex("0000C03F")) == {"number": 1.5}
    assert read(bytes.fromhex("0000C07F")) == {"number": "nan"}
    assert read(b"hi") is None


def test_messages_to_mailboxes_are_read_in_dialogues_and_comments() -> None:
    line = plain_text(dialogue_line(parse(mailbox(b"a text that is so long that it is cut somewhere\0")), None, None))
    assert line.startswith('WRITEMAILBOX name_length=4 name="abc" payload_length=48 payload=61 20 74')
    assert line.endswith(' (text "a text that is so long that it is cut somewhere")')
    assert '/* payload 68 69 00 (text "hi") */' in as_c(parse(mailbox(b"hi\0")))


def test_a_dialogue_says_why_a_command_was_refused() -> None:
    def refused(command: str, type: str = "04") -> str:
        dialogue, frame = Dialogue(), bytes.fromhex(command)
        asked = parse(frame, strict=False)
        dialogue.follow(asked)
        reply = parse(b"\x03\0" + frame[2:4] + bytes.fromhex(type), strict=False)
        return plain_text(dialogue_line(asked, dialogue.follow(reply), None)).rpartition(" -> ")[2]

    # A place that is not a multiple of 4; a correct operation; an unknown opcode, reported next to the command.
    assert refused("08002a00000500810161") == "error (E205: VALUE is GV(1), and must start at a multiple of 4)"
    assert refused("08002a00000400810160") == "error"
    assert refused("06002a00000000fe") == "error"
    assert refused("06002a0000000001", "02") == "ok"


def test_readings_of_devices_are_described() -> None:
    """By type and mode of the command: the gyro sensor's mode 3."""
    command = bytes.fromhex("0f00 2a00 00 0800 991d 0000 8120 03 02 60 64")
    reply = bytes.fromhex("0b00 2a00 02 0000b442 000080bf")
    said = [*shown(command), *shown(reply, before=command)]
    assert said[-6:-3] == [
        "    14    VALUES    = 2  LC0: number of values that follow, each in SI units",
        "    15    VALUES[0] = GV(0)  GV0: angle, in degrees",
        "    16    VALUES[1] = GV(4)  GV0: rate, in degrees/s",
    ]
    assert said[-2:] == [
        "     5  INPUT_DEVICE.READY_SI VALUES[0] = 90.0 degrees  DATAF: angle",
        "     9  INPUT_DEVICE.READY_SI VALUES[1] = -1.0 degrees/s  DATAF: rate",
    ]


def test_the_tree_shows_a_cmd_that_is_encoded_longer() -> None:
    assert "     8    CMD = 1  LC1" in shown(bytes.fromhex("09 00 01 00 00 04 00 81 81 01 60"))


def test_the_tree_of_a_faulty_frame() -> None:
    lines = shown(bytes.fromhex("0B 00 2A 00 80 00 00 94 01 01 82 B8 01"))
    assert lines[-2:] == [
        "    10    FREQUENCY = 440 Hz  LC2: pitch; the driver clamps it to the range",
        "  fault at offset 13: the frame ends before the argument DURATION",
    ]


def test_the_tree_of_system_messages() -> None:
    assert shown(LIST) == [
        "SYSTEM_COMMAND_REPLY, counter 1, 14 bytes: LIST_FILES",
        "        Lists a folder and fetches the first piece of the listing",
        "        max_bytes = 1000",
        '        path      = "/prjs"',
        '        "/prjs": 0 of an unknown number of bytes',
    ]
    assert shown(LISTED, before=LIST)[0] == "SYSTEM_REPLY, counter 1, 17 bytes: LIST_FILES END_OF_FILE"
    assert shown(LISTED, before=LIST)[-1] == '        "/prjs": 5 of 7 bytes'


def test_the_tree_of_daisy_messages() -> None:
    assert shown(DOWNSTREAM)[:3] == [
        "DAISY_COMMAND_REPLY, counter 1, 11 bytes: DOWNSTREAM",
        "        Forwards operations to a brick further down",
        "        from layer 0 to layer 1",
    ]
    assert shown(DOWNSTREAM)[3].startswith("     8  OUTPUT_START")


def test_the_annotated_table() -> None:
    assert drawn(NAME) == [
        "DIRECT_COMMAND_REPLY, counter 42, 16 bytes",
        "---------------------------------------------------",
        "  \\len  \\cnt  \\ty\\hd   \\op\\cd\\NAME                \\",
        "---------------------------------------------------",
        "0x|0E:00|2A:00|00|00:00|D4|08|84:6D:79:45:56:33:00|",
        "---------------------------------------------------",
        '  \\14   \\42   \\Re\\0,0  \\C \\S \\"myEV3"             \\',
        *(
            f"  \\     \\     \\  \\     \\{left} \\{right} \\                    \\"
            for left, right in zip("OM_SET      ", "ET_BRICKNAME", strict=True)
        ),
        "---------------------------------------------------",
    ]


def test_the_table_holds_every_byte_of_every_kind_of_message() -> None:
    for frame in (NAME, ASK, ANSWER, LIST, LISTED, REFUSED, DOWNSTREAM, UNKNOWN, b"\x03\x00\x01"):
        rows = [line for line in drawn(frame) if line.startswith(("0x|", "  |"))]
        text = "".join(rows).replace("0x|", "").replace("|", " ").replace(":", " ")
        if "..." not in text:
            assert bytes.fromhex(text) == frame
        else:
            assert frame.startswith(bytes.fromhex(text.partition("...")[0]))


def test_json_of_a_command_has_the_promised_keys() -> None:
    assert as_json(TONE) == [
        {
            "kind": "direct-command",
            "type": "DIRECT_COMMAND_NO_REPLY",
            "length": 14,
            "counter": 42,
            "globals": 0,
            "locals": 0,
            "operations": [
                {
                    "op": "SOUND",
                    "opcode": 148,
                    "command": "TONE",
                    "offset": 7,
                    "length": 9,
                    "args": [
                        {"name": "VOLUME", "kind": "constant", "encoding": "LC0", "value": 1, "offset": 9, "length": 1},
                        {
                            "name": "FREQUENCY",
                            "kind": "constant",
                            "encoding": "LC2",
                            "value": 440,
                            "offset": 10,
                            "length": 3,
                        },
                        {
                            "name": "DURATION",
                            "kind": "constant",
                            "encoding": "LC2",
                            "value": 1000,
                            "offset": 13,
                            "length": 3,
                        },
                    ],
                }
            ],
            "hex": "0e002a0080000094010182b80182e803",
        }
    ]


def test_json_of_variables_handles_and_replies() -> None:
    asked, entry = as_json(ASK, f"received: {ANSWER.hex()}")
    argument = asked["operations"][0]["args"][0]
    assert (argument["kind"], argument["encoding"], argument["value"]) == ("global", "GV0", 0)
    assert (entry["status"], entry["direction"]) == ("ok", "received")
    assert {key: entry["values"][0][key] for key in ("op", "command", "name", "unit")} == {
        "op": "UI_READ",
        "command": "GET_VBATT",
        "name": "VALUE",
        "unit": "V",
    }
    (handle,) = as_json(bytes.fromhex("09 00 01 00 80 00 04 C0 07 D1 02"))
    assert handle["operations"][0]["args"][0]["handle"] is True


def test_json_of_a_fault() -> None:
    (entry,) = as_json(UNKNOWN)
    assert entry["fault"] == {"offset": 7, "reason": "unknown opcode 0xFE for the official firmware"}
    assert entry["rest"] == "fe"


def test_json_of_system_messages() -> None:
    request, reply = as_json(LIST, REFUSED)
    assert (request["kind"], request["command"]) == ("system-command", "LIST_FILES")
    assert request["fields"] == {"max_bytes": 1000, "path": "/prjs"}
    assert (reply["kind"], reply["command"], reply["status"]) == ("system-reply", "LIST_FILES", "error")
    assert reply["status_name"] == "ILLEGAL_PATH"


def test_floats_have_no_more_digits_than_they_need() -> None:
    assert short_float(7.920000076293945) == "7.92"
    assert short_float(1.0) == "1.0"
    assert short_float(0.10000000149011612) == "0.1"
    assert short_float(16777216.0) == "16777216.0"
    assert short_float(3.4028234663852886e38) == "3.4028235e+38"
    assert short_float(float("nan")) == "nan"
    assert plain([1.5, 2.0]) == "[1.5, 2.0]"
    assert plain('quo"te\n') == '"quo\\"te\\n"'


def test_lines_of_the_tree_know_their_bytes_and_their_operation() -> None:
    reading = parse(bytes.fromhex("08002a00000100810160"))
    lines = list(tree(Dialogue().follow(reading), Seen()))
    assert [(line.offset, line.length, line.target) for line in lines] == [
        (0, 10, ""),
        (5, 2, ""),
        (7, 3, "UI_READ.GET_VBATT"),
        (9, 1, ""),
    ]
    cut = parse(bytes.fromhex("0e002a0080000094010182b8"), strict=False)
    *_, rest, fault = tree(Dialogue().follow(cut), Seen())
    assert (rest.offset, rest.length) == (10, 2)
    assert fault.offset is not None


@pytest.mark.parametrize(
    ("memory", "meaning"),
    [
        ("00 00 C0 40", "DATAF 6.0 or DATA32 1086324736"),
        ("00 00 C0 40 00 00 80 3F", "DATAF [6.0, 1.0] or DATA32 [1086324736, 1065353216]"),
        ("10 27 00 00", "DATA32 10000"),
        ("6D 79 45 56 33 00 00 00", 'string "myEV3" or DATA32 [1447393645, 51]'),
        ("E8 03", "DATA16 1000"),
        ("41", "DATA8 65"),
    ],
)
def test_the_memory_of_a_lone_reply_has_the_readings_that_fit(memory: str, meaning: str) -> None:
    data = bytes.fromhex(memory)
    frame = (3 + len(data)).to_bytes(2, "little") + b"\x2a\x00\x02" + data
    assert shown(frame)[-1] == f"     5  global memory: {memory}  {meaning}"


def test_a_reply_that_ends_before_its_status_has_none() -> None:
    lines = [
        plain_text(line) for line in tree(Dialogue().follow(parse(bytes.fromhex("040052db039b"), strict=False)), Seen())
    ]
    assert lines[0] == "SYSTEM_REPLY, counter 56146, 6 bytes: no status (the command it answers was not seen)"

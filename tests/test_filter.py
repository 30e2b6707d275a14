"""Filters: which records they let through, and what they say to a text that is none."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import ev3proto
from ev3proto import GV, LV
from ev3proto.capture import Carrier, Direction, Record, Route, read
from ev3proto.capture.filter import FilterError, compile_filter
from ev3proto.capture.filter.grammar import MAX_DEPTH, MAX_LENGTH
from ev3proto.dialogue import Transfer
from ev3proto.messages import DaisyReply, Message, SensorReport
from ev3proto.schema.frame import frame_schema
from ev3proto.tables.frame import MessageType

CAPTURES = Path(__file__).parent.parent / "captures"
WIFI = Route(Carrier.WIFI, "192.0.2.1:49152", "192.0.2.10:5555", Direction.SENT, "eth0", "192.0.2.10:5555")
BLUETOOTH = Route(Carrier.BLUETOOTH, "host", "00:16:53:00:00:0a", None, None, "00:16:53:00:00:0a")
START = 1_767_261_600_000_000_000


def seen(
    message: Message | bytes,
    *,
    numbers: tuple[int, ...] = (1,),
    after: float = 0,
    route: Route = WIFI,
    request: Record | None = None,
    transfer: Transfer | None = None,
) -> Record:
    frame = message if isinstance(message, bytes) else message.build()
    return Record(frame, numbers, START + round(after * 1e9), route, frame_schema(), request, transfer)


def holds(text: str, record: Record) -> bool:
    return compile_filter(text)(record)


TONE = ev3proto.operation("SOUND.TONE", VOLUME=5, FREQUENCY=440, DURATION=250)
LIGHT = ev3proto.operation("UI_WRITE.LED", "LED_RED_FLASH")
COMMAND = seen(ev3proto.direct_command(TONE, LIGHT, counter=42))
VOLTAGE = seen(
    ev3proto.direct_command(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=7, reply=True, global_size=4),
    numbers=(3,),
    after=1,
)
ANSWER = seen(ev3proto.direct_reply(struct.pack("<f", 7.92), counter=7), numbers=(4, 5), after=1.25, request=VOLTAGE)
TYPES = seen(
    ev3proto.direct_command(
        ev3proto.operation("INPUT_DEVICE_LIST", LENGTH=4, ARRAY=GV(0), CHANGED=GV(4)), reply=True, global_size=5
    )
)
TYPES_ANSWER = seen(ev3proto.direct_reply(bytes((16, 32, 29, 126, 1))), request=TYPES)
BEGIN = seen(
    ev3proto.system_command("BEGIN_DOWNLOAD", size=2500, path="../prjs/hello/hello.rbf", counter=9),
    transfer=Transfer("BEGIN_DOWNLOAD", "../prjs/hello/hello.rbf", 2500),
)
PIECE = seen(
    ev3proto.system_command("CONTINUE_DOWNLOAD", handle=0, data=b"LEGO\x01\x02", counter=10), transfer=BEGIN.transfer
)
REFUSED = seen(
    ev3proto.system_reply("BEGIN_DOWNLOAD", counter=9, status=6, error=True, handle=255), request=BEGIN, numbers=(8,)
)
ORPHAN = seen(ev3proto.direct_reply(b"\x01", counter=3), route=BLUETOOTH)
FAULTY = seen(bytes.fromhex("0600010080000094"))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("op == SOUND.TONE", True),
        ("op == sound.tone", True),
        ("op == SOUND", True),
        ("op == SOUND.PLAY", False),
        ("op == 0x94", True),
        ("op == 148", True),
        ("op eq UI_WRITE.LED", True),
        ("op != SOUND.TONE", False),
        ("op != SOUND.PLAY", True),
        ("op ne SOUND.PLAY", True),
        ("op in {SOUND.PLAY, UI_WRITE}", True),
        ("op not in {SOUND.PLAY, UI_WRITE}", False),
        ('op contains "tone"', True),
        ("op like SOUND.*", True),
        ("op like UI_READ.*", False),
        ("command == TONE", True),
        ("command == PLAY", False),
        ("FREQUENCY == 440", True),
        ("frequency == 0x1b8", True),
        ("FREQUENCY != 440", False),
        ("FREQUENCY > 440", False),
        ("FREQUENCY gt 439.5", True),
        ("FREQUENCY >= 440 and FREQUENCY <= 440", True),
        ("FREQUENCY ge 441 or FREQUENCY le 440", True),
        ("FREQUENCY < 440 || FREQUENCY lt 441", True),
        ("FREQUENCY in {100, 400..500}", True),
        ("FREQUENCY in {100, 441..500}", False),
        ("SOUND.TONE.FREQUENCY == 440", True),
        ("SOUND.FREQUENCY == 440", True),
        ("arg.FREQUENCY == 440", True),
        ("PATTERN == LED_RED_FLASH", True),
        ("PATTERN == led_red_flash", True),
        ('PATTERN == "LED_RED_FLASH"', True),
        ("PATTERN == LED_GREEN", False),
        ("PATTERN == 5", True),
        ("PATTERN in {LED_RED_FLASH, LED_GREEN}", True),
        ("LED == LED_RED_FLASH", True),
        ("LED", True),
        ("FREQUENCY", True),
        ("path", False),
        ("path != 'x'", False),
        ("error", False),
        ("not error", True),
        ("!error && !fault", True),
        ("error == false", True),
        ("wants_reply", False),
        ("type == DIRECT_COMMAND_NO_REPLY", True),
        ("type == 0x80", True),
        ("type != DIRECT_REPLY", True),
        ("kind == direct-command", True),
        ("counter == 42", True),
        ("size == 19", True),
        ("size > 19", False),
        ("peer == 192.0.2.10", True),
        ("peer == 192.0.2.10:5555", True),
        ("peer == 192.0.2.10:5556", False),
        ("peer != 192.0.2.10", False),
        ("peer != 192.0.2.11", True),
        ("target == 192.0.2.10", True),
        ("source == 192.0.2.10", False),
        ('source contains "49152"', True),
        ("carrier == wifi", True),
        ("carrier == USB", False),
        ("direction == sent", True),
        ("interface == eth0", True),
        ("packet == 1", True),
        ("packet in {2..9}", False),
        ("status", False),
        ("latency", False),
        ("orphan", False),
        # "and" binds tighter than "or", "not" tighter than both.
        ("error && error || op", True),
        ("error && (error || op)", False),
        ("not error and op", True),
        ("not (error or op)", False),
    ],
)
def test_a_command(text: str, expected: bool) -> None:
    assert holds(text, COMMAND) is expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("op == UI_READ.GET_VBATT", True),
        ("command == GET_VBATT", True),
        ("kind == direct-reply", True),
        # The frame's four bytes hold 7.92 as 7.9200000762939453.
        ("VALUE == 7.92", True),
        ("VALUE <= 7.92", True),
        ("VALUE > 7.92", False),
        ("VALUE != 8", True),
        ("UI_READ.GET_VBATT.VALUE > 7", True),
        ("UI_READ.GET_IBATT.VALUE > 7", False),
        ("latency == 0.25", True),
        ("latency > 0.25", False),
        ("packet == 4 && packet == 5", True),
        ("packet != 4", False),
        ("orphan", False),
        ("wants_reply", False),
    ],
)
def test_a_reply(text: str, expected: bool) -> None:
    assert holds(text, ANSWER) is expected


def test_a_variable_is_there_but_has_no_value_that_anybody_knows() -> None:
    assert holds("VALUE", VOLTAGE)
    assert not holds("VALUE == 0", VOLTAGE)
    assert not holds("VALUE != 0", VOLTAGE)
    local = seen(ev3proto.direct_command(ev3proto.operation("SOUND.TONE", 5, LV(0), 250), local_size=2))
    assert not holds("FREQUENCY < 1", local)


def test_any_element_of_an_array_will_do() -> None:
    assert holds("ARRAY == TYPE_GYRO", TYPES_ANSWER)
    assert holds("ARRAY in {30..32}", TYPES_ANSWER)
    assert not holds("ARRAY == TYPE_IR", TYPES_ANSWER)
    # As in Wireshark: != is true where all are different.
    assert not holds("ARRAY != TYPE_GYRO", TYPES_ANSWER)
    assert holds("ARRAY != TYPE_IR", TYPES_ANSWER)


def test_the_elements_of_a_list() -> None:
    request = seen(
        ev3proto.direct_command(
            ev3proto.operation("INPUT_DEVICE.READY_SI", 0, 1, 32, 3, [GV(0), GV(4)]), reply=True, global_size=8
        )
    )
    reply = seen(ev3proto.direct_reply(struct.pack("<2f", -12.0, 3.0)), request=request)
    assert holds("VALUES == 3", reply)
    assert holds("VALUES[1] == 3", reply)
    assert not holds("VALUES[0] == 3", reply)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("path == '../prjs/hello/hello.rbf'", [BEGIN, PIECE]),
        ('path like "*.RBF"', [BEGIN, PIECE]),
        ("arg.path", [BEGIN]),
        ("arg.size > 2000", [BEGIN]),
        ("BEGIN_DOWNLOAD.size == 2500", [BEGIN]),
        ("data contains 'LEGO'", [PIECE]),
        ("data contains 4c:45:47:4F", [PIECE]),
        ("data == 4c45474f0102", [PIECE]),
        (r"data contains '\x01\x02'", [PIECE]),
        (r"data contains r'\x01'", []),
        ("handle == 0", [PIECE]),
        ("command == BEGIN_DOWNLOAD", [BEGIN, REFUSED]),
        ("status == ILLEGAL_PATH", [REFUSED]),
        ("status == 6", [REFUSED]),
        ("status != SUCCESS", [REFUSED]),
        ("status in {SUCCESS, END_OF_FILE}", []),
        ("error", [REFUSED]),
        ("kind like system-*", [BEGIN, PIECE, REFUSED]),
        ("type == SYSTEM_REPLY_ERROR", [REFUSED]),
        ("op", []),
    ],
)
def test_system_messages(text: str, found: list[Record]) -> None:
    assert [record for record in (BEGIN, PIECE, REFUSED) if holds(text, record)] == found


def test_a_reply_whose_command_was_not_seen() -> None:
    assert holds("orphan", ORPHAN)
    assert not holds("op", ORPHAN)
    assert not holds("latency", ORPHAN)
    assert holds("peer == 00:16:53:00:00:0a && !direction && !interface", ORPHAN)
    # An address of Bluetooth has colons, but no port.
    assert not holds("peer == 00:16:53:00:00", ORPHAN)


def test_faults() -> None:
    assert holds("fault", FAULTY)
    assert holds("error", FAULTY)
    assert FAULTY.message.fault is not None
    assert FAULTY.message.fault.reason.startswith("the frame ends ")
    assert holds('fault contains "the frame ends"', FAULTY)
    assert not holds('fault contains "is no opcode"', FAULTY)
    assert holds('fault like "The Frame Ends *"', FAULTY)
    nothing = seen(b"\x01")
    assert holds("fault && kind == unknown && !type && !counter && size == 1", nothing)


def test_daisy_messages() -> None:
    report = SensorReport(0, 16, 0, 7, 0, bytes(32), 0)
    payload = bytes((0, 16, 0, 7, 0)) + bytes(33)
    reply = seen(DaisyReply(type=MessageType.DAISY_REPLY, layer_from=1, layer_to=0, payload=payload, report=report))
    assert holds("layer_from == 1 && port == 16 && arg.type == 7", reply)
    assert not holds("port == 17", reply)


def test_time_counts_from_the_first_record() -> None:
    early = compile_filter("time < 1.1")
    assert [early(record) for record in (COMMAND, VOLTAGE, ANSWER)] == [True, True, False]
    # Also where the first one was decided without it.
    late = compile_filter("op == UI_READ && time >= 1.25")
    assert [late(record) for record in (COMMAND, VOLTAGE, ANSWER)] == [False, False, True]


@pytest.mark.parametrize(
    ("lower", "upper", "record"),
    [
        ("type == DIRECT_COMMAND_NO_REPLY", "TYPE == TYPE_TOUCH", ev3proto.operation("INPUT_READ", 0, 0, 16, 0, LV(0))),
        ("size == 12", "SIZE == 12", ev3proto.operation("MEMORY_WRITE", 1, 0, 0, 12, LV(0))),
    ],
)
def test_names_that_both_the_frame_and_a_parameter_have(lower: str, upper: str, record: ev3proto.Operation) -> None:
    made = seen(ev3proto.direct_command(record, local_size=12))
    assert holds(upper, made)
    assert holds(f"arg.{upper}", made)
    assert holds(lower, made) == (lower.startswith("type"))


@pytest.mark.parametrize(
    ("text", "column", "reason"),
    [
        ("op==SOUND.TOEN", 5, "SOUND.TOEN is no operation: did you mean SOUND.TONE"),
        ("op==TONE", 5, "TONE is no operation: it is a command, command==TONE"),
        ("op==SOUND.*", 5, "like takes patterns"),
        ("op>SOUND", 4, "has no order"),
        ("command==SOUND.TONE", 10, "it is an operation, op==SOUND.TONE"),
        ("FREQENCY>400", 1, "nothing is called FREQENCY: did you mean FREQUENCY"),
        ("size>1 && wants_replay", 11, "nothing is called wants_replay: did you mean wants_reply?"),
        ("SOUND.TONE", 1, "an operation, which is asked for so: op==SOUND.TONE"),
        ("TONE", 1, "a command, which is asked for so: command==TONE"),
        ("SOUND.TONE.PATTERN==1", 1, "SOUND.TONE has no parameter PATTERN"),
        ("PATTERN==LED_RDE", 10, "LED_RDE is no name that PATTERN has: did you mean LED_RED"),
        ("FREQUENCY==LED_RED", 12, "FREQUENCY is a number, LED_RED is none"),
        ("FREQUENCY=='440'", 12, "FREQUENCY is a number"),
        ("FREQUENCY contains 4", 20, "FREQUENCY is a number"),
        ("latency>10ms", 9, "latency is a number of seconds, 10ms is none"),
        ("path==hello", 7, 'texts stand in quotes: path == "hello"'),
        ("status==SUCESS", 9, "SUCESS is no system status: did you mean SUCCESS?"),
        ("type==TYPE_TOUCH", 7, "it is a value of the parameter TYPE, in upper case"),
        ("kind==direct", 7, "direct is no kind of message: there are direct-command, "),
        ("direction==in", 12, "in is no direction: there are sent, received"),
        ("error>1", 7, "error is true or false: write error or not error"),
        ("op=SOUND.TONE", 3, "= stands where a comparison such as ==, in, && or || should; equal is =="),
        ("path matches 'x'", 6, "there is like, which takes a pattern with * and ?"),
        ("error & fault", 7, "& stands where a comparison such as ==, in, && or || should; and is &&"),
        ("error fault", 7, "fault stands where"),
        ("(error", 7, "the filter ends where ) should stand"),
        ("error)", 6, ") stands where the end should"),
        ("op in {SOUND, 0x94", 19, "the filter ends where , or } should stand"),
        ("op in {}", 8, "} stands where a value should"),
        ("packet in {1..}", 12, "1.. is no range"),
        ("packet in {5, a..b}", 15, "packet is a number, a is none"),
        ("op==", 5, "the filter ends where a value should stand"),
        ("path contains 'abc", 15, "the text that starts here has no ' at its end"),
        (r"path == 'a\qb'", 11, r"\q is no escape"),
        ("", 1, "the filter is empty"),
        (" ", 1, "the filter is empty"),
        ("error || ", 10, "the filter ends where a name or ( should stand"),
        ("\0", 1, "stands where a name or ( should"),
        ("é", 1, "stands where a name or ( should"),
    ],
)
def test_what_is_no_filter(text: str, column: int, reason: str) -> None:
    with pytest.raises(FilterError) as caught:
        compile_filter(text)
    assert caught.value.column == column
    assert reason in caught.value.reason
    assert str(caught.value) == f"column {column}: {caught.value.reason}"


def test_long_and_deep_filters() -> None:
    longest = "error".ljust(MAX_LENGTH)
    assert not holds(longest, COMMAND)
    with pytest.raises(FilterError, match="at most 4096"):
        compile_filter(longest + " ")
    # 24 times not and and, around an error that is not there.
    assert not holds("!(op && " * 24 + "error" + ")" * 24, COMMAND)
    for deep in ("!" * 4000 + "op", "!(op && " * (MAX_DEPTH + 1) + "error" + ")" * (MAX_DEPTH + 1)):
        with pytest.raises(FilterError, match="in each other more than 50 deep"):
            compile_filter(deep)
    # Parentheses around parentheses say nothing, and many conditions side by side are not deep.
    assert holds("(" * 2000 + "op" + ")" * 2000, COMMAND)
    assert holds("||".join(["error"] * 500) + "||op", COMMAND)


def test_a_pattern_takes_no_ages() -> None:
    text = seen(ev3proto.direct_command(ev3proto.operation("UI_DRAW.TEXT", 1, 0, 0, "a" * 900)))
    assert not holds(f"STRING like '{'*a' * 60}b'", text)


def test_the_words_of_the_language_are_no_reserved_words() -> None:
    record = seen(COMMAND.frame, route=replace(WIFI, interface="in"))
    assert holds("interface == in and op", record)
    assert not holds("interface == or or error", record)


def numbers_of(name: str, text: str) -> Iterable[int]:
    keep = compile_filter(text)
    with read(CAPTURES / name) as capture:
        return [record.number for record in capture if keep(record)]


def test_a_capture() -> None:
    assert numbers_of("wifi.pcapng", "op==SOUND.TONE && FREQUENCY>400") == [11]
    assert numbers_of("wifi.pcapng", "error") == [29, 51]
    assert numbers_of("wifi.pcapng", "status==END_OF_FILE") == [34, 39, 49]
    assert numbers_of("wifi.pcapng", 'path contains "first.rbf"') == [41, 42, 43, 44, 46, 47, 48, 49]


@given(st.text(st.sampled_from("op=!<>&|()\"'\\{},.[] inotradSUN0x9*\n"), max_size=40) | st.text(max_size=40))
@example('"')
@example("\\")
def test_any_text_is_a_filter_or_an_error_with_a_column(text: str) -> None:
    column = 1
    try:
        assert compile_filter(text)(COMMAND) in (True, False)
    except FilterError as error:
        column = error.column
    assert 1 <= column <= len(text) + 1

"""Filters: the records that match, and the errors for texts that are not filters."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from support.cpu_time import milliseconds

import ev3proto
from ev3proto import GV, LV
from ev3proto.capture import Carrier, Direction, Event, Record, Route, read
from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.filter import Choosing, FilterError, compile_filter
from ev3proto.capture.filter.fields import operation_names, places_of
from ev3proto.capture.filter.language import MAX_DEPTH, MAX_LENGTH
from ev3proto.capture.filter.manual import ManualEntry, sections
from ev3proto.capture.filter.names import NAMES
from ev3proto.capture.filter.pattern import PatternError, compile_pattern
from ev3proto.capture.record import Outcome
from ev3proto.dialogue import Transfer
from ev3proto.messages import DaisyReply, Message, SensorReport
from ev3proto.schema.frame import frame_reader
from ev3proto.tables.frame import MessageType

pytestmark = pytest.mark.portable

CAPTURES = Path(__file__).parents[2] / "captures"
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
    return Record(frame, numbers, START + round(after * 1e9), route, frame_reader(), request, transfer)


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
        ("op == sound.tone", True),
        ("op == SOUND", True),
        ("op == SOUND.PLAY", False),
        ("op == 0x94", True),
        ("op eq UI_WRITE.LED", True),
        ("op != SOUND.TONE", False),
        ("op ne SOUND.PLAY", True),
        ("op in {SOUND.PLAY, UI_WRITE}", True),
        ("op not in {SOUND.PLAY, UI_WRITE}", False),
        ('op contains "tone"', True),
        ("op like SOUND.*", True),
        ("command == TONE", True),
        ("frequency == 0x1b8", True),
        ("FREQUENCY != 440", False),
        ("FREQUENCY > 440", False),
        ("FREQUENCY gt 439.5", True),
        ("FREQUENCY >= 440 and FREQUENCY <= 440", True),
        ("FREQUENCY ge 441 or FREQUENCY le 440", True),
        ("FREQUENCY < 440 || FREQUENCY lt 441", True),
        ("FREQUENCY in {100, 400..500}", True),
        ("SOUND.TONE.FREQUENCY == 440", True),
        ("SOUND.FREQUENCY == 440", True),
        ("PATTERN == led_red_flash", True),
        ('PATTERN == "LED_RED_FLASH"', True),
        ("PATTERN == 5", True),
        ("PATTERN in {LED_RED_FLASH, LED_GREEN}", True),
        ("LED == LED_RED_FLASH", True),
        ("FREQUENCY", True),
        ("path", False),
        ("path != 'x'", False),
        ("error", False),
        ("!error && !fault", True),
        ("error == false", True),
        ("wants_reply", False),
        ("type == DIRECT_COMMAND_NO_REPLY", True),
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


def test_a_variable_is_present_and_its_value_unknown() -> None:
    assert holds("VALUE", VOLTAGE)
    assert not holds("VALUE == 0", VOLTAGE)
    assert not holds("VALUE != 0", VOLTAGE)
    local = seen(ev3proto.direct_command(ev3proto.operation("SOUND.TONE", 5, LV(0), 250), local_size=2))
    assert not holds("FREQUENCY < 1", local)


def test_any_element_of_an_array_will_do() -> None:
    assert holds("ARRAY == TYPE_GYRO", TYPES_ANSWER)
    assert holds("ARRAY in {30..32}", TYPES_ANSWER)
    assert not holds("ARRAY == TYPE_IR", TYPES_ANSWER)
    # As in Wireshark: != is true if all values differ.
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
    # A Bluetooth address has colons, but no port.
    assert not holds("peer == 00:16:53:00:00", ORPHAN)


def test_faults() -> None:
    assert holds("fault", FAULTY)
    assert holds("error", FAULTY)
    assert FAULTY.message.fault is not None
    assert FAULTY.message.fault.reason.startswith("the frame ends ")
    assert holds('fault contains "the frame ends"', FAULTY)
    assert not holds('fault contains "unknown opcode"', FAULTY)
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
    # Also if the first one was decided without it.
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
        ("op==SOUND.TOEN", 5, "unknown operation SOUND.TOEN: did you mean SOUND.TONE"),
        ("op==TONE", 5, "unknown operation TONE; it is a command: command==TONE"),
        ("op==SOUND.*", 5, "unknown operation SOUND.*; use like for patterns"),
        ("op>SOUND", 4, "op cannot be compared by >; use == or !="),
        ("peer>5", 6, "peer cannot be compared by >; use == or !="),
        ("command==SOUND.TONE", 10, "it is an operation: op==SOUND.TONE"),
        ("command==5", 10, "unknown command 5"),
        ("FREQENCY>400", 1, "unknown field 'FREQENCY': did you mean FREQUENCY"),
        ("size>1 && wants_replay", 11, "unknown field 'wants_replay': did you mean wants_reply?"),
        ("SOUND.TONE", 1, "unknown field 'SOUND.TONE'; it is an operation: op==SOUND.TONE"),
        ("TONE", 1, "unknown field 'TONE'; it is a command: command==TONE"),
        ("SOUND.TONE.PATTERN==1", 1, "SOUND.TONE has no parameter PATTERN"),
        ("PATTERN==LED_RDE", 10, "PATTERN has no value LED_RDE: did you mean LED_RED"),
        ("FREQUENCY==LED_RED", 12, "FREQUENCY is a number; it cannot be compared by == with LED_RED"),
        ("FREQUENCY=='440'", 12, 'FREQUENCY is a number; it cannot be compared by == with "440"'),
        ("FREQUENCY contains 4", 20, "FREQUENCY is a number; it cannot be compared by contains with 4"),
        (
            "CONTINUE_DOWNLOAD.data==zz",
            25,
            "CONTINUE_DOWNLOAD.data is bytes such as 4c:45:47:4f; it cannot be compared by == with zz",
        ),
        ("latency>10kg", 9, "latency is measured in s, not in kg"),
        ("latency>soon", 9, "latency is a time in seconds, such as 4ms; it cannot be compared by > with soon"),
        ("latency>10 ms", 12, "expected no space between a number and its unit: 4ms"),
        ("FREQUENCY>10ms", 11, "FREQUENCY is measured in Hz, not in ms"),
        ("ev3.msg_num==4", 1, "ev3.msg_num is a name of Wireshark; here it is counter"),
        ("ev3.counter==4", 1, "here it is counter"),
        ("ev3.sound.tone.frequency==4", 1, "here it is SOUND.TONE.FREQUENCY"),
        ("frame.number==4", 1, "here it is packet"),
        ("SUOND.TONE.FREQUENCY>4", 1, "did you mean SOUND.TONE.FREQUENCY"),
        ("zzzzzzz", 1, "unknown field 'zzzzzzz'; see --help-filter"),
        ("path==hello", 7, 'texts need quotes: path == "hello"'),
        ("status==SUCESS", 9, "unknown system status SUCESS: did you mean SUCCESS?"),
        ("type==TYPE_TOUCH", 7, "it is a value of the parameter TYPE, in upper case"),
        ("kind==direct", 7, "unknown kind of message direct: known are direct-command"),
        ("direction==in", 12, "unknown direction in: known are sent, received"),
        ("error>1", 7, "error cannot be compared by >"),
        ("error contains 'a'", 16, "error cannot be compared by contains"),
        ("error==yes", 8, "unknown truth value yes: known are true, false"),
        ("op=SOUND.TONE", 3, "expected a comparison; did you mean ==?"),
        ("path matches 'x('", 16, "not a regular expression: missing ), unterminated subpattern"),
        ('path matches "[a"', 15, "not a regular expression: unterminated character set"),
        ("path ~ 'x'", 6, "expected a comparison; did you mean matches?"),
        ("error & fault", 7, "expected a comparison; did you mean &&?"),
        ("error fault", 7, "expected a comparison, &&, || or the end"),
        ("(error", 7, "the filter ends early: expected a comparison, &&, || or )"),
        ("error)", 6, "expected a comparison, &&, || or the end"),
        ("op in {SOUND, 0x94", 19, "the filter ends early: expected , or }"),
        ("op in {}", 8, "expected a value"),
        ("packet in {1..}", 12, "a range needs a number on each side of the dots, not 1.."),
        ("packet in {5, a..b}", 15, "packet is a number; it cannot be compared by >= with a"),
        ("op==", 5, "the filter ends early: expected a value"),
        ("path contains 'abc", 15, "missing ' at the end of this text"),
        (r"path == 'a\qb'", 11, r"unknown escape \q: known are"),
        ("", 1, "empty filter; write a condition such as op==SOUND.TONE"),
        (" ", 1, "empty filter"),
        ("error || ", 10, "the filter ends early: expected a name"),
        ("\0", 1, "expected a name"),
        ("é", 1, "expected a name"),
    ],
)
def test_errors(text: str, column: int, reason: str) -> None:
    with pytest.raises(FilterError) as caught:
        compile_filter(text)
    assert caught.value.column == column
    assert reason in caught.value.reason
    assert str(caught.value) == f"column {column}: {caught.value.reason}"


def test_long_and_deep_filters() -> None:
    longest = "error".ljust(MAX_LENGTH)
    assert not holds(longest, COMMAND)
    with pytest.raises(FilterError, match="at most 4096 are allowed"):
        compile_filter(longest + " ")
    # 24 alternating nots and ands, around an error that does not exist.
    assert not holds("!(op && " * 24 + "error" + ")" * 24, COMMAND)
    for deep in ("!" * 4000 + "op", "(" * 4000, "!(op && " * (MAX_DEPTH + 1) + "error" + ")" * (MAX_DEPTH + 1)):
        with pytest.raises(FilterError, match="conditions are nested more than 50 deep"):
            compile_filter(deep)
    # Many conditions in a row do not count as depth.
    assert holds("||".join(["error"] * 500) + "||op", COMMAND)


def test_a_pattern_is_fast() -> None:
    text = seen(ev3proto.direct_command(ev3proto.operation("UI_DRAW.TEXT", 1, 0, 0, "a" * 900)))
    assert not holds(f"STRING like '{'*a' * 60}b'", text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("path matches 'HELLO/'", True),
        ("path matches r'hel+o\\.rbf$'", True),
        ("path matches '^/'", False),
        ("path matches '(?-i)HELLO'", False),
        ("path matches r'(prjs|apps)/\\w{5}/'", True),
        ("arg.size matches '2'", None),
        ("command matches '^begin_'", True),
        ("kind matches 'reply$'", False),
        ("target matches r'192\\.0\\.2\\.[0-9]+'", True),
    ],
)
def test_regular_expressions(text: str, expected: bool | None) -> None:
    if expected is None:
        with pytest.raises(FilterError, match="size is a number"):
            compile_filter(text)
    else:
        assert holds(text, BEGIN) is expected


def test_a_regular_expression_in_data() -> None:
    assert holds(r"data matches r'^LEGO\x01'", PIECE)
    assert not holds(r"data matches r'^lego$'", PIECE)


@pytest.mark.parametrize(
    "pattern", ["a*?b", "(?:ab)+", "(?P<x>a)c", "[*+?]{2}", "(a|b)c", r"\(\*\+\)*", "a{2,3}", "(?=a)a"]
)
def test_a_regular_expression_finds_what_python_finds(pattern: str) -> None:
    for text in ("ab", "ABAB", "ac", "**", "bc", "(*+)", "aa", ""):
        assert compile_pattern(pattern)(text) is (re.search(pattern, text, re.IGNORECASE) is not None), text


@pytest.mark.parametrize(
    ("pattern", "position", "reason"),
    [
        ("(a+)+$", 4, "+ repeats a group with *, +, ?, { } or | in it, which can take very long"),
        ("(a|a)*b", 5, "* repeats a group"),
        ("(?:.*a){20}b", 7, "{20} repeats a group"),
        ("((a{0,5}){0,5}){0,5}b", 9, "{0,5} repeats a group"),
        (".*a.*b.*c", 7, "more than 2 of * and +, or 4 of *, +, ?, { , } and | can take very long; use like with *"),
        ("a?" * 5 + "a" * 5, 9, "more than 2 of * and +, or 4 of"),
        ("a{0,256}" * 4 + "!", 17, "more than 2 of * and +, or 4 of"),
        ("a{,99}a{1,99}a{4}a*", 18, "more than 2 of * and +, or 4 of"),
        (r"(a)\1", 3, r"\1 refers to a group, which can take very long"),
        ("(?P<x>a)(?P=x)", 8, "(?P= refers to a group"),
        ("(a)?(?(1)b|c)", 4, "(?( refers to a group"),
        ("a**", 2, "not a regular expression: multiple repeat"),
        ("*", 0, "not a regular expression: nothing to repeat"),
        ("(?-i)[z-a]", 6, "not a regular expression: bad character range z-a"),
        ("\\", 0, "not a regular expression: bad escape (end of pattern)"),
        ("x{99999999999999999999}", 0, "not a regular expression"),
        pytest.param("x{" + "9" * 5000 + "}", 0, "not a regular expression", id="more digits than int takes"),
    ],
)
def test_invalid_and_slow_regular_expressions(pattern: str, position: int, reason: str) -> None:
    with pytest.raises(PatternError) as caught:
        compile_pattern(pattern)
    assert reason in str(caught.value)
    assert caught.value.position == position


@pytest.mark.parametrize(
    "pattern", ["a+a+$", ".*.*c", "a?a?a*a*c", "a{2,}[ab]*(a|ab)b$", "(a|aa)(a|aa)a*a*c", "a{0,256}a{1,99}a{0,3}!"]
)
def test_regular_expressions_are_fast(pattern: str) -> None:
    find = compile_pattern(pattern)
    assert milliseconds(lambda: find("a" * 60_000 + "b"), 2000) <= 2000


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("latency == 250ms", True),
        ("latency > 250000us", False),
        ("latency < 1min", True),
        ("latency in {200ms..300ms}", True),
        ("VALUE == 7.92v", True),
        ("VALUE < 1e60V", True),
        # Nothing here is measured in percent.
        ("VALUE < 100%", False),
        ("VALUE > 1e60", False),
        ("VALUE < 1e999", True),
        (f"VALUE < {10**400}", True),
        ("latency < 1e999s", True),
    ],
)
def test_quantities(text: str, expected: bool) -> None:
    assert holds(text, ANSWER) is expected


def test_times_of_parameters_in_any_unit() -> None:
    assert holds("DURATION == 0.25s && DURATION == 250ms && DURATION == 250", COMMAND)
    assert not holds("DURATION > 1s", COMMAND)


def test_a_time_in_units_is_the_same_number_as_in_seconds() -> None:
    for number in (4.1, 0.07, 2.3, 1.1, 16.7):
        assert holds(f"latency == {number}ms", seen(ANSWER.frame, after=1 + float(f"{number}e-3"), request=VOLTAGE))


def answered(command: Record, after: float, *, failed: bool = False) -> Record:
    """A command and its reply, which are linked as in a capture."""
    reply = seen(
        ev3proto.direct_reply(b"" if failed else bytes(4), counter=command.message.counter, error=failed),
        after=after,
        request=command,
    )
    command.answered = Outcome(reply.time_ns, failed)
    return reply


def asked(counter: int, after: float) -> Record:
    question = ev3proto.operation("UI_READ.GET_VBATT", GV(0))
    return seen(
        ev3proto.direct_command(question, counter=counter, reply=True, global_size=4), numbers=(counter,), after=after
    )


def test_what_is_only_known_with_the_reply() -> None:
    events: list[Record] = []
    fine, lost, broken, slow = (asked(number, number) for number in range(4))

    def arriving() -> Iterator[Record]:
        # A capture gives a command before its reply is known.
        yield fine
        yield answered(fine, 0.01)
        yield lost
        yield broken
        yield answered(broken, 2.01, failed=True)
        yield slow
        yield answered(slow, 3.2)

    for text, expected in (
        ("unanswered", [1]),
        ("not unanswered && wants_reply", [0, 2, 3]),
        ("failed", [2, 2]),
        ("late", [3, 3]),
        ("late || unanswered || failed", [1, 2, 2, 3, 3]),
        ("unanswered || op", [0, 0, 1, 2, 2, 3, 3]),
    ):
        for record in (fine, lost, broken, slow):
            record.answered = None
        events = list(Choosing(compile_filter(text)).chosen(arriving()))
        assert [record.message.counter for record in events] == expected, text
        assert events == sorted(events, key=lambda record: record.time_ns), text


def test_what_waits_for_replies_has_a_limit() -> None:
    commands = [asked(number, number) for number in range(1000)]
    given: list[int] = []

    def arriving() -> Iterator[Record]:
        for command in commands:
            yield command
            given.append(len(found))

    found: list[Record] = []
    choosing = Choosing(compile_filter("unanswered"), memory=100_000)
    for record in choosing.chosen(arriving()):
        found.append(record)
    assert found == commands
    # A record counts for 900 bytes besides its frame.
    assert choosing.given_up == 1000 - 100_000 // (900 + len(commands[0].frame))
    assert max(number - before for number, before in enumerate(given)) < 110


def test_a_command_with_its_reply() -> None:
    command = asked(1, 0)
    pair = RequestReply(command, answered(command, 0.01))
    for text, expected in (
        ("op == UI_READ && latency > 4ms", True),
        ("kind == direct-command && kind == direct-reply", True),
        ("unanswered", False),
        ("!error", True),
        ("failed", False),
    ):
        assert compile_filter(text).of_dialogue(pair) is expected, text
    lost = RequestReply(asked(2, 1), None)
    assert compile_filter("unanswered").of_dialogue(lost)
    failed = asked(3, 2)
    assert not compile_filter("!error").of_dialogue(RequestReply(failed, answered(failed, 2.1, failed=True)))


def test_the_words_of_the_language_are_not_reserved() -> None:
    record = seen(COMMAND.frame, route=replace(WIFI, interface="in"))
    assert holds("interface == in and op", record)
    assert not holds("interface == or or error", record)


MATCHES_NOTHING = {'fault contains "opcode"', "interface", "missing", "orphan"}
"""Examples that no capture here has."""


@cache
def captured() -> list[list[Event]]:
    """Examples that match all captures here."""
    found = []
    for path in CAPTURES.glob("*.pcap*"):
        with read(path) as capture:
            found.append(list(capture.events()))
    found.append([event for event in ev3proto.read(CAPTURES / "real-bricks.log") if isinstance(event, Record)])
    return found


@pytest.mark.parametrize("entry", sum(sections().values(), ()), ids=lambda entry: entry.example)
def test_every_example_of_the_manual_finds_something(entry: ManualEntry) -> None:
    found = any(any(Choosing(compile_filter(entry.example)).chosen(events)) for events in captured())
    assert found is (entry.example not in MATCHES_NOTHING)


@given(st.sampled_from([*NAMES, *places_of(), *operation_names()]), st.integers(0, 30), st.sampled_from("AXe_."))
def test_no_suggestion_is_the_word_that_was_wrong(name: str, at: int, letter: str) -> None:
    word = f"{name[:at]}{letter}{name[at:]}"
    reason = ""
    try:
        compile_filter(word)
    except FilterError as error:
        reason = error.reason
    assert word.lower() not in re.findall(r"[\w.]+", reason.partition("did you mean")[2].lower())


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

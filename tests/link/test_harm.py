"""What a message may do to a brick besides reading: everything that is not on the list is named by `harms_of`."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from support.cases import each
from support.effort import effort
from support.sent import sent_in

import ev3proto
from ev3proto import GV, LV, DirectCommand, Operation, operation
from ev3proto.link.harm import Harm, harms_of
from ev3proto.messages import Message, SystemCommand
from ev3proto.schema.argument import encode_as
from ev3proto.tables import OPCODES, operations
from ev3proto.tables import system as tables
from ev3proto.tables.declaration import Effect, declarations
from ev3proto.tables.system import SYSTEM
from ev3proto.testing import frames

UNKNOWN, COMPUTING = {Harm.UNKNOWN}, {Harm.COMPUTING}
RUNS_AS_CODE = {Harm.COMPUTING, Harm.UNKNOWN}


def command(*operations: Operation | bytes, globals_: int = 16, locals_: int = 16) -> bytes:
    code = b"".join(one if isinstance(one, bytes) else one.raw for one in operations)
    body = b"\0\0\0" + (globals_ | locals_ << 10).to_bytes(2, "little") + code
    return len(body).to_bytes(2, "little") + body


def harms(frame: bytes, *allowed: str, dialect: str = "official") -> set[Harm]:
    return set(harms_of(ev3proto.parse(frame, strict=False, dialect=dialect), allowed))


# The list


READING = [
    operation("NOP"),
    operation("UI_READ.GET_VBATT", GV(0)),
    operation("UI_READ.GET_FW_VERS", 16, GV(0)),
    operation("UI_BUTTON.PRESSED", 1, GV(0)),
    operation("INPUT_DEVICE_LIST", 4, GV(0), GV(4)),
    operation("INPUT_DEVICE.GET_NAME", 0, 2, 16, GV(0)),
    operation("INPUT_DEVICE.READY_SI", 0, 1, 0, 3, [GV(0), GV(4)]),
    operation("INPUT_DEVICE.READY_RAW", 0, 16, 0, -1, [GV(0)]),
    operation("INPUT_READ", 0, 0, 0, 0, GV(0)),
    operation("INPUT_READEXT", 0, 0, 0, -1, 16, [GV(0), GV(1)]),
    operation("OUTPUT_GET_COUNT", 0, 0, GV(0)),
    operation("OUTPUT_TEST", 0, 15, GV(0)),
    operation("COM_GET.GET_BRICKNAME", 16, GV(0)),
    operation("FILE.GET_FOLDERS", "../prjs/", GV(0)),
    operation("FILE.GET_SUBFOLDER_NAME", "../prjs/", 1, 16, GV(0)),
    operation("FILENAME.EXIST", "../prjs/a.rbf", GV(0)),
    operation("MEMORY_USAGE", GV(0), GV(4)),
    operation("MOVE8_8", 3, GV(0)),
    operation("ADD32", 2, 5, GV(0)),
    operation("INIT_BYTES", GV(0), 3, [1, 2, 3]),
]


@each("reading", READING)
def test_reading_is_on_the_list(reading: Operation) -> None:
    assert harms(command(reading)) == set()


# What depends on the brick


READY = operation("INPUT_DEVICE.READY_RAW", 0, 0, 0, 0, [GV(0)])
TOUCH, LARGE, MEDIUM, EMPTY = 16, 7, 8, 126


def test_a_command_may_wait_for_a_sensor_eight_times() -> None:
    assert harms(command(*[READY] * 8)) == set()
    assert harms(command(*[READY] * 9)) == COMPUTING


@each("reading", READING)
def test_reading_wants_a_reply(reading: Operation) -> None:
    frame = bytearray(command(reading))
    frame[4] = 0x80
    assert harms(bytes(frame)) == COMPUTING


READERS = {
    "GET_", "READY_", "INPUT_READ", "INPUT_DEVICE_LIST", "OUTPUT_READ", "OUTPUT_TEST", "MEMORY_USAGE", "PRESSED", "NOP"
}  # fmt: skip


@pytest.mark.parametrize(
    ("capture", "least", "wrong"),
    [("wifi.pcapng", 6, 0), ("usb.pcapng", 5, 0), ("ev3_dc.pcap", 30, 1), ("real-bricks.log", 90, 0)],
)
def test_the_reading_frames_of_clients_are_on_the_list(capture: str, least: int, wrong: int) -> None:
    reading = [
        message
        for message in sent_in(capture)
        if isinstance(message, DirectCommand)
        and all(any(word in one.full_name for word in READERS) for one in message.operations)
        and not {"UI_READ.GET_EVENT", "FILE.GET_ITEM"} & {one.full_name for one in message.operations}
    ]
    assert len(reading) >= least
    # A client of ev3_dc.pcap gives a type as a variable, by mistake.
    refused = [str(one)[1:].split(" at ")[0] for message in reading if harms_of(message) for one in message.operations]
    assert refused == ["INPUT_DEVICE.READY_RAW(LAYER=0, NO=2, TYPE=GV(33), MODE=0, VALUES=1, VALUES[0]=GV(0))"] * wrong


def test_computing_is_all_that_the_conformance_capture_needs() -> None:
    sent = list(sent_in("conformance.pcapng"))
    assert len(sent) == 300
    assert [message for message in sent if harms_of(message, {Harm.COMPUTING})] == []
    assert {harm for message in sent for harm in harms_of(message)} == COMPUTING


def test_every_operation_reads_or_is_in_a_group() -> None:
    grouped = {effect for harm in Harm for effect in harm.effects} | {Effect.READS}
    entries = [
        *((one.name, one.effects) for one in declarations(OPCODES)),
        *((one.name, one.effects) for one in SYSTEM),
    ]
    assert {name for name, effects in entries if grouped.isdisjoint(effects)} == {
        "ERROR",
        "PROBE",
        "DYNLOAD_GET_VM",
        "UI_WRITE.ADDRESS",
        "UI_WRITE.CODE",
        "UI_READ.GET_CODE",
        "OUTPUT_GET_TYPE",
        "OUTPUT_POSITION",
        "COM_READ.COMMAND",
        "COM_WRITE.REPLY",
    }


def test_what_reads_has_no_other_effect() -> None:
    all_effects = [*(one.effects for one in declarations(OPCODES)), *(one.effects for one in SYSTEM)]
    found = {effect for effects in all_effects if Effect.READS in effects for effect in effects}
    assert found == {Effect.READS, Effect.VARIES, Effect.WAITS}
    assert not any(one.is_newer for one in operations().values() if Effect.READS in one.effects)


# Attacks


HIDDEN = operation("STRINGS.GET_SIZE", "\xa6\x40\x0f\x40\x02", GV(0))
"""OUTPUT_START(LV(0), 15), and a jump over the rest, are in its text, three bytes after its start."""

LONG = "x" * 60

ATTACKS: dict[str, list[Operation | bytes]] = {
    # Programs that a direct command does not have: the firmware runs whatever is there.
    "CALL 2": [operation("CALL", 2, [])],
    "OBJECT_TRIG 2": [operation("OBJECT_TRIG", 2)],
    "OBJECT_WAIT 1": [operation("OBJECT_WAIT", 1)],
    "RETURN": [operation("RETURN")],
    "PROGRAM_STOP 0": [operation("PROGRAM_STOP", 0)],
    "PROGRAM_INFO of slot 90": [operation("PROGRAM_INFO.GET_STATUS", 90, GV(0))],
    # Texts over memory.
    "a long copy": [operation("STRINGS.DUPLICATE", LONG, GV(0))],
    "a long sum": [operation("STRINGS.ADD", LONG, LONG, GV(0))],
    "a long text without blanks": [operation("STRINGS.STRIP", LONG, GV(0))],
    "a copy of unknown length": [operation("STRINGS.DUPLICATE", LV(0), GV(0))],
    "a format that writes": [operation("STRINGS.NUMBER_FORMATTED", 5, "%n", 16, GV(0))],
    "a format that reads": [operation("STRINGS.VALUE_FORMATTED", 1.0, "%s", 16, GV(0))],
    "a format in a variable": [operation("STRINGS.NUMBER_FORMATTED", 5, LV(0), 16, GV(0))],
    "a text without limit": [operation("UI_READ.GET_FW_VERS", -1, GV(0))],
    "a text of negative length": [operation("UI_READ.GET_FW_VERS", encode_as("LC1", -5), GV(0))],
    "a text of length 255": [operation("UI_READ.GET_FW_VERS", encode_as("LC2", 255), GV(0))],
    "a text of length 0": [operation("INPUT_DEVICE.GET_NAME", 0, 0, 0, GV(0))],
    "a text longer than the memory": [operation("UI_READ.GET_VERSION", 17, GV(0))],
    "a length in a variable": [operation("INPUT_DEVICE_LIST", GV(8), GV(0), GV(4))],
    "a list longer than the memory": [operation("INPUT_DEVICE_LIST", 32, GV(0), GV(4))],
    "an output behind the memory": [operation("UI_READ.GET_VBATT", encode_as("GV1", 16))],
    "an output far behind the memory": [operation("MOVE32_32", 1, encode_as("LV4", 1 << 20))],
    "an input far behind the memory": [operation("MOVE32_32", encode_as("GV4", 1 << 20), GV(0))],
    "an element behind the memory": [operation("WRITE8", 1, 100, GV(0))],
    "an element before the memory": [operation("WRITE8", 1, -1, GV(0))],
    "an element by a variable": [operation("WRITE8", 1, LV(4), GV(0))],
    "bytes behind the memory": [operation("INIT_BYTES", GV(0), 17, [1] * 17)],
    "an output into a text": [operation("MOVE32_32", 1, encode_as("LCS", "abcdef"))],
    "an output into a number": [operation("UI_READ.GET_VERSION", 100, b"\0")],
    "an output by an address": [operation("MOVE32_32", 1, bytes((0xC9, 0)))],
    "an output by a handle": [operation("INPUT_DEVICE_LIST", 32, bytes((0xD1, 0)), GV(0))],
    "an input by an address": [operation("MOVE32_32", bytes((0xC9, 0)), GV(0))],
    "a name of 200 characters": [operation("FILE.GET_FOLDERS", "x" * 200, GV(0))],
    "a name that is tried for ever": [operation("FILE.OPEN_READ", "a.toolong", LV(0), LV(4))],
    "a name in a variable": [operation("FILE.GET_FOLDERS", LV(0), GV(0))],
    "a name in a number": [operation("FILE.GET_FOLDERS", b"\x05", GV(0))],
    # Code that the frame does not show.
    "a jump into a text": [operation("JR", 3), HIDDEN],
    "a jump back into a text": [HIDDEN, operation("JR", -HIDDEN.length + 1)],
    "a jump into an operation": [operation("JR", 1), operation("MOVE8_8", 1, LV(0))],
    "a jump out of the frame": [operation("JR", 100)],
    "a jump before the frame": [operation("JR_TRUE", LV(0), -100)],
    "a jump by a variable": [operation("JR_TRUE", 1, LV(0))],
    "a jump by a handle": [operation("JR", bytes((0x91, 3)))],
    "a jump to a missing label": [operation("JR", encode_as("LAB1", 3))],
    "a jump to label 100": [operation("JR", encode_as("LAB1", 100))],
    "a jump to itself": [operation("JR", -2)],
    "a label in an argument": [operation("MOVE8_8", encode_as("LAB1", 3), GV(0))],
    "a count in a variable": [b"\x99\x1d\x00\x00\x00\x3f\x40", operation("NOP")],
    "a count of values in a variable": [b"\x2f\x60\x40"],
    "a count that is a label": [b"\x99\x1d\x00\x00\x00\x3f\xa0\x01\x60"],
    "a CMD by a handle": [b"\x81\x91\x01\x60"],
    "GET_POWER, which older firmware runs as code": [bytes.fromhex("811d0101018304a60001")],
    # What changes the state of the brick, or makes it wait.
    "CLR_ALL": [operation("INPUT_DEVICE.CLR_ALL", 0)],
    "CLR_CHANGES": [operation("INPUT_DEVICE.CLR_CHANGES", 0, 0)],
    "STOP_ALL": [operation("INPUT_DEVICE.STOP_ALL", 0)],
    "MAILBOX_CLOSE": [operation("MAILBOX_CLOSE", 0)],
    "MAILBOX_OPEN": [operation("MAILBOX_OPEN", 0, "a", 4, 1, 1)],
    "MAILBOX_READ": [operation("MAILBOX_READ", 0, 4, [GV(0)])],
    "MAILBOX_TEST of box 100": [operation("MAILBOX_TEST", 100, GV(0))],
    "a wait for ever": [operation("INPUT_READY", 0, 3)],
    "a wait for a button": [operation("UI_BUTTON.WAIT_FOR_PRESS")],
    "a walk through all folders": [operation("FILENAME.TOTALSIZE", "/", GV(0), GV(4))],
    "many waits": [operation("INPUT_DEVICE.READY_SI", 0, 3, 0, number % 2, [GV(0)]) for number in range(40)],
    "addresses over memory": [operation("COM_GET.GET_NETWORK", 3, 4, GV(0), GV(4), GV(8))],
    "an address over memory": [operation("COM_GET.GET_NETWORK", 3, 4, LV(0), LV(12), GV(0))],
    "memory that is freed": [operation("FILE.CLOSE", 0)],
    "a device": [operation("FILE.OPEN_READ", "/dev/lms_pwm", LV(0), LV(4))],
    "a file of processes": [operation("FILE.OPEN_READ", "../../../../proc/1/mem", LV(0), LV(4))],
    "a folder of processes": [operation("FILE.GET_FOLDERS", "/proc", GV(0))],
    "a path that is too long": [operation("FILENAME.EXIST", "../prjs/" + "a/" * 38 + "b", GV(0))],
    "a division by zero": [operation("MATH.MOD32", 1, 0, GV(0))],
    "sound": [operation("SOUND.TONE", 1, 440, 1)],
    "light": [operation("UI_WRITE.LED", 1)],
    "display": [operation("UI_DRAW.UPDATE")],
    "terminal": [operation("UI_WRITE.PUT_STRING", "x")],
    "a taken press": [operation("UI_BUTTON.SHORTPRESS", 1, GV(0))],
    "a taken error": [operation("INFO.GET_ERROR", GV(0))],
    "a port that no brick has": [operation("INPUT_READ", 0, -1, 0, -1, GV(0))],
    "a port in a variable": [operation("INPUT_READ", 0, LV(0), 0, -1, GV(0))],
    "an array": [operation("ARRAY.CREATE8", 5000000, LV(0))],
    "an image": [operation("FILE.LOAD_IMAGE", 1, "../prjs/a.rbf", GV(0), GV(4))],
    "a handle of nothing": [operation("FILE.READ_TEXT", LV(0), 0, 16, GV(0))],
    "the shell": [operation("SYSTEM", "reboot", GV(0))],
}


@each("attack", ATTACKS)
def test_attacks_are_not_on_the_list(attack: str) -> None:
    assert harms(command(*ATTACKS[attack]))


@pytest.mark.parametrize(
    "computing",
    [
        [operation("JR", 0)],
        [operation("JR", 3), operation("MOVE8_8", 1, LV(0))],
        [operation("JR_TRUE", LV(0), -3)],
        [operation("LABEL", 2), operation("JR", encode_as("LAB1", 2))],
        [operation("STRINGS.ADD", "a", "b", GV(0))],
        [operation("STRINGS.NUMBER_FORMATTED", 255, "%04x", 10, GV(0))],
        [operation("TIMER_WAIT", 20, LV(0)), operation("TIMER_READY", LV(0))],
        [operation("ARRAY.CREATE8", 3, LV(0)), operation("ARRAY_READ", LV(0), 2, GV(0))],
        [operation("UI_READ.GET_VERSION", 100, GV(0))],
    ],
)
def test_computing_is_a_group(computing: list[Operation]) -> None:
    assert harms(command(*computing)) == COMPUTING
    assert harms(command(*computing), "computing") == set()


@pytest.mark.parametrize(
    "frame",
    [
        command(),  # the firmware answers no more commands after these two
        command(operation("NOP"), globals_=1022),
        command(operation("NOP"), globals_=1020),  # the reply is longer than the firmware's buffer
        command(operation("NOP"))[:-1],
        bytes.fromhex("0300000002"),
        bytes.fromhex("050000000398 00"),
        bytes.fromhex("06000000 0a a0 00 01"),
        bytes.fromhex("040000007700"),
        bytes.fromhex("05000000 01 55 00"),
    ],
)
def test_what_is_not_a_readable_command_is_unknown(frame: bytes) -> None:
    assert Harm.UNKNOWN in harms(frame)


# System commands


@pytest.mark.parametrize(
    "command",
    [
        ev3proto.system.list_files("../prjs/", reply=False),
        ev3proto.system.begin_upload("../prjs/a.rbf", reply=False),
        ev3proto.system.begin_getfile("../prjs/a.rbf", reply=False),
        ev3proto.system.list_open_handles(reply=False),
        ev3proto.system.close_filehandle(3, reply=False),
    ],
)
def test_reading_files_wants_a_reply(command: SystemCommand) -> None:
    assert set(harms_of(command)) == COMPUTING


@pytest.mark.parametrize(
    ("path", "is_read"),
    [
        ("../prjs/everstorm", True),
        ("../prjs/../prjs/everstorm", False),
        ("/home/root/lms2012", True),
        ("/home/root/lms2012/../lms2012/prjs/a", False),
        ("../prjs//a", False),
        ("./../prjs/a", False),
        ("prjs/a", False),
        ("", False),
        ("/", False),
        ("..//../", False),
        ("/proc/self/mem", False),
        ("/dev/lms_pwm", False),
        ("/home/root/lms2012/../../../dev/ttyS1", False),
        ("../../../../../proc/cpuinfo", False),
        ("/home/root/lms2012x/a", False),
        ("/home/root/lms2012/prjs/" + "a/" * 38 + "b", False),
        ("/home/root/lms2012/prjs/" + "a/" * 37 + "bb", True),
        ("./" * 50 + "a", False),
    ],
)
def test_paths_are_below_the_brick_s_own_folder(path: str, is_read: bool) -> None:
    expected = set() if is_read else COMPUTING
    assert set(harms_of(ev3proto.system.list_files(path))) == expected
    if len(path) < 70:
        assert set(harms_of(ev3proto.system.begin_upload(path))) == expected


def test_a_name_that_leaves_an_error_behind() -> None:
    assert not harms_of(ev3proto.system.list_files("../prjs/a.abcd"))
    assert set(harms_of(ev3proto.system.begin_upload("../prjs/a*.rbf"))) == COMPUTING
    assert set(harms_of(ev3proto.system.begin_getfile("../prjs/a.abcd"))) == COMPUTING


def test_a_frame_that_is_longer_than_a_report() -> None:
    # CLOSE_FILEHANDLE of handle 3, with 1,100 bytes in place of a hash.
    frame = (1105).to_bytes(2, "little") + bytes.fromhex("0000 01 98 03") + bytes(1100)
    assert set(harms_of(ev3proto.parse(frame, strict=False))) == UNKNOWN


@each("entry", [entry for entry in SYSTEM if Effect.READS not in entry.effects])
def test_other_system_commands_are_not_on_the_list(entry: tables.SystemDeclaration) -> None:
    assert harms_of(SystemCommand(type=ev3proto.MessageType.SYSTEM_COMMAND_REPLY, number=entry.number))


# Groups


@pytest.mark.parametrize(
    ("message", "harm"),
    [
        (ev3proto.command(operation("ARRAY.WRITE_CONTENT", 1, 1, 0, 4, GV(0))), Harm.PROGRAMS),
        (ev3proto.command(operation("COM_SET.SET_PASSKEY", 2, 1)), Harm.SETTINGS),
        (ev3proto.command(operation("OUTPUT_STOP", 0, 15, 0)), Harm.MOTORS),
        (ev3proto.command(operation("OUTPUT_SPEED", 0, 15, 50)), Harm.MOTORS),
        (ev3proto.command(operation("OUTPUT_POLARITY", 0, 15, -1)), Harm.MOTORS),
        (ev3proto.command(operation("INPUT_DEVICE.CLR_ALL", 0)), Harm.MOTORS),
        (ev3proto.command(operation("INPUT_DEVICE.CLR_CHANGES", 0, 0)), Harm.DEVICES),
        (ev3proto.command(operation("SOUND.BREAK")), Harm.SOUNDS),
        (ev3proto.command(operation("UI_DRAW.CLEAN")), Harm.DISPLAY),
        (ev3proto.command(operation("UI_WRITE.LED", 1)), Harm.LIGHTS),
        (ev3proto.command(operation("MAILBOX_CLOSE", 0)), Harm.MESSAGES),
        (ev3proto.command(operation("SYSTEM", "reboot", LV(0)), local_size=4), Harm.SHELL),
        (ev3proto.system_command("WRITEMAILBOX", name="a", payload=b"x"), Harm.MESSAGES),
    ],
)
def test_effects(message: Message, harm: Harm) -> None:
    assert set(harms_of(message)) == {harm}
    assert harms_of(message, {harm}) == {}


def test_the_gravest_effect_of_a_group_is_named() -> None:
    message = ev3proto.command(operation("OUTPUT_SPEED", 0, 1, 50), operation("OUTPUT_START", 0, 1))
    assert harms_of(message) == {Harm.MOTORS: "OUTPUT_START"}
    assert harms_of(message, {"OUTPUT_START"}) == {Harm.MOTORS: "OUTPUT_SPEED"}
    assert harms_of(message, {"OUTPUT_START", "OUTPUT_SPEED"}) == {}


def test_effects_in_extensions() -> None:
    frame = ev3proto.direct_command(operation("INPUT_IIC_WRITE", 0, 0, 1, GV(0), 1, GV(4), dialect="xtended")).build()
    assert harms(frame, dialect="xtended") == {Harm.DEVICES}


@settings(max_examples=effort(75, 2000))
@given(frames())
def test_what_passes_only_reads(frame: bytes) -> None:
    message = ev3proto.parse(frame, strict=False)
    if not harms_of(message):
        assert isinstance(message, DirectCommand | SystemCommand)
        assert message.fault is None
        for one in getattr(message, "operations", ()):
            assert Effect.READS in one.declaration.effects


@pytest.mark.parametrize(
    ("changing", "words"),
    [
        (operation("INPUT_READ", 0, 0, GV(1), 0, GV(0)), "INPUT_READ with TYPE"),
        (operation("OUTPUT_GET_COUNT", 0, 9, GV(0)), "OUTPUT_GET_COUNT with NOS 9"),
        (operation("FILE.OPEN_READ", "/etc/passwd", LV(0), LV(4)), "FILE.OPEN_READ"),
        (operation("TIMER_WAIT", 5, LV(0)), "TIMER_WAIT"),
    ],
)
def test_the_argument_that_does_more_than_read_is_named(changing: Operation, words: str) -> None:
    assert harms_of(ev3proto.parse(command(changing)))[Harm.COMPUTING] == words


@pytest.mark.parametrize(
    ("frame", "expected"),
    [
        (command(operation("NOP"), globals_=1019), set()),
        (command(operation("NOP"), globals_=1020), UNKNOWN),
        (command(b"\x01" * 1017), set()),
        (command(b"\x01" * 1018), UNKNOWN),
    ],
    ids=[
        "the longest reply",
        "a longer one",
        "the longest command",
        "a longer one",
    ],
)
def test_limits(frame: bytes, expected: set[Harm]) -> None:
    """A reply and a command have 1,024 bytes: what the firmware does beyond is not known."""
    assert harms(frame) == expected

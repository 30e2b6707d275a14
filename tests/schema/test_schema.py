"""The protocol by example: the meaning of published frames, messages about faulty ones, refusals of the builder.

Every expected value is written out from the description of the protocol.
"""

from __future__ import annotations

import copy
import dataclasses
import pickle
from collections.abc import Callable
from typing import Any

import pytest
from support.cpu_time import seconds
from support.messages import frame_of

import ev3proto
from ev3proto import GV, LV, BuildError, DecodeError
from ev3proto.schema.argument import encode_as, encode_integer
from ev3proto.schema.header import read_memory, write_memory
from ev3proto.schema.instructions import instruction_set
from ev3proto.tables.encoding import ENCODINGS

pytestmark = pytest.mark.portable


def operation_of(text: str) -> ev3proto.Operation:
    code = frame_of(text)
    (operation,), fault = instruction_set().scan(code, 0, len(code))
    assert fault is None
    return operation


def direct_command(text: str) -> ev3proto.DirectCommand:
    return ev3proto.parse(frame_of(text), expect=ev3proto.DirectCommand)


def direct_reply(text: str) -> ev3proto.DirectReply:
    return ev3proto.parse(frame_of(text), expect=ev3proto.DirectReply)


def arguments_of(operation: ev3proto.Operation) -> list[tuple[str, object, str]]:
    return [(argument.name, argument.value, argument.encoding) for argument in operation.arguments]


def test_a_misspelt_operation_gets_a_suggestion() -> None:
    with pytest.raises(KeyError, match=r"SOUND\.TONE"):
        instruction_set()["SOUND.TON"]


# Identification bytes, header, memory


@pytest.mark.parametrize(
    ("byte", "handle", "address"), [(0x91, True, False), (0x89, False, True), (0xF9, True, True), (0xD2, True, False)]
)
def test_handle_and_address_bits(byte: int, handle: bool, address: bool) -> None:
    encoding = ENCODINGS[byte]
    assert encoding is not None
    assert (encoding.handle, encoding.address) == (handle, address)


@pytest.mark.parametrize(
    ("text", "global_size", "local_size"),
    [
        ("00:00", 0, 0),
        ("00:14", 0, 5),
        ("00:04", 0, 1),
        ("FD:0B", 1021, 2),
        ("FF:FF", 1023, 63),
    ],
)
def test_memory(text: str, global_size: int, local_size: int) -> None:
    """Bits 0 to 9 are global memory, bits 10 to 15 local memory."""
    assert read_memory(frame_of(text), 0) == (global_size, local_size)
    assert write_memory(global_size, local_size) == frame_of(text)
    command = direct_command(f"05:00|2A:00|00|{text}")
    assert (command.global_size, command.local_size) == (global_size, local_size)
    nothing = ev3proto.operation("NOP")
    built = ev3proto.direct_command(nothing, counter=42, reply=True, global_size=global_size, local_size=local_size)
    assert built.build() == frame_of(f"06:00|2A:00|00|{text}|01")


# Direct commands, the published examples


def test_set_brickname() -> None:
    command = direct_command("0E:00|2A:00|00|00:00|D4:08:84:6D:79:45:56:33:00")
    assert command.type is ev3proto.MessageType.DIRECT_COMMAND_REPLY
    assert (command.kind, command.counter, command.length) == ("direct-command", 42, 14)
    assert command.wants_reply
    (operation,) = command.operations
    assert (operation.name, operation.command, operation.offset, operation.length) == ("COM_SET", "SET_BRICKNAME", 7, 9)
    assert arguments_of(operation) == [("NAME", "myEV3", "LCS")]
    (name,) = operation.arguments
    assert (name.offset, name.length, name.raw) == (9, 7, b"\x84myEV3\x00")
    reply = direct_reply("03:00|2A:00|02")
    assert (reply.kind, reply.counter, reply.memory, reply.is_error) == ("direct-reply", 42, b"", False)


@pytest.mark.parametrize(
    ("text", "sizes", "operations"),
    [
        (
            "0C:00|00:00|80|00:00|A4:00:01:14:A6:00:01",
            (0, 0),
            [("OUTPUT_POWER", 7, "LAYER=0 NOS=1 POWER=20"), ("OUTPUT_START", 11, "LAYER=0 NOS=1")],
        ),
        ("09:00|00:00|80|00:00|A3:00:01:00", (0, 0), [("OUTPUT_STOP", 7, "LAYER=0 NOS=1 BRAKE=0")]),
        ("07:00|01:00|80|00:00|02:01", (0, 0), [("PROGRAM_STOP", 7, "PRGID=1")]),
        (
            "0B:00|01:00|00|01:00|9A:00:00:00:00:60",
            (1, 0),
            [("INPUT_READ", 7, "LAYER=0 NO=0 TYPE=0 MODE=0 PCT=GV(0)")],
        ),
        (
            "0B:00|01:00|00|10:00|99:15:00:00:10:60",
            (16, 0),
            [("INPUT_DEVICE.GET_NAME", 7, "LAYER=0 NO=0 LENGTH=16 DESTINATION=GV(0)")],
        ),
        (
            "0B:00|01:00|00|05:00|7F:01:00:04:05:60",
            (5, 0),
            [("MEMORY_READ", 7, "PRGID=1 OBJID=0 OFFSET=4 SIZE=5 ARRAY=GV(0)")],
        ),
        (
            "13:00|01:00|80|00:14|2F:40:05:01:02:03:04:05:7E:01:00:04:05:40",
            (0, 5),
            [
                ("INIT_BYTES", 7, "DESTINATION=LV(0) LENGTH=5 " + " ".join(f"SOURCE[{n}]={n + 1}" for n in range(5))),
                ("MEMORY_WRITE", 15, "PRGID=1 OBJID=0 OFFSET=4 SIZE=5 ARRAY=LV(0)"),
            ],
        ),
    ],
)
def test_published_commands(text: str, sizes: tuple[int, int], operations: list[tuple[str, int, str]]) -> None:
    command = direct_command(text)
    assert (command.global_size, command.local_size) == sizes
    assert command.wants_reply == (command.type is ev3proto.MessageType.DIRECT_COMMAND_REPLY)
    assert [(found.full_name, found.offset, shown(found)) for found in command.operations] == operations
    assert {argument.length for found in command.operations for argument in found.arguments} == {1}


def shown(operation: ev3proto.Operation) -> str:
    """`POWER=20 PCT=GV(0)`."""
    letters = {"local": "LV({})", "global": "GV({})"}
    return " ".join(f"{it.name}={letters.get(it.kind, '{}').format(it.value)}" for it in operation.arguments)


def test_an_error_reply_has_no_memory() -> None:
    reply = direct_reply("03:00|2A:00|04")
    assert reply.type is ev3proto.MessageType.DIRECT_REPLY_ERROR
    assert reply.is_error
    assert reply.memory == b""


def test_a_list_whose_counter_is_missing() -> None:
    """INIT_BYTES ends after its destination, before the number of bytes that follow."""
    message = ev3proto.parse(frame_of("07:00|01:00|80|00:14|2F:40"), strict=False)
    assert message.fault is not None
    assert (message.fault.offset, message.fault.truncated) == (9, True)
    assert "the frame ends before the argument LENGTH" in message.fault.reason


def test_a_long_list_is_read_whole() -> None:
    """The counter is an LC1 if there are more than 31 elements."""
    elements = list(range(1, 41))
    (operation,) = ev3proto.direct_command(
        ev3proto.operation("INIT_BYTES", LV(0), 40, elements), local_size=40
    ).operations
    assert [argument.value for argument in operation.arguments] == [0, 40, *elements]
    command = ev3proto.direct_command(operation, operation, local_size=40)
    assert ev3proto.parse(command.build()) == command


@pytest.mark.parametrize("faulty", ["FF", "94:01:FF", "94:01:85", "2F:40:01:85", "2F:40:3F", "2F:40:85"])
def test_an_early_fault_in_a_long_frame(faulty: str) -> None:
    """Undefined bytes are found, even if many bytes follow them."""
    frame = frame_of(f"FF:FF|01:00|80|00:00|{faulty}") + bytes(9000)
    message = ev3proto.parse(frame, strict=False, expect=ev3proto.DirectCommand)
    assert message.fault is not None
    assert "at offset" in message.fault.reason
    assert message.build() == frame


def test_dialects_share_schemas() -> None:
    """An operation made for one firmware equals the one in another firmware's frame; so do copies."""
    made = ev3proto.operation("SOUND.TONE", 1, 440, 1000)
    assert made == ev3proto.operation("SOUND.TONE", 1, 440, 1000, dialect="xtended")
    assert instruction_set()["SOUND.TONE"] is instruction_set("compat")["SOUND.TONE"]
    frame = ev3proto.direct_command(made, counter=42).build()
    assert ev3proto.parse(frame) == ev3proto.parse(frame, dialect="compat")
    assert pickle.loads(pickle.dumps(made)) == copy.deepcopy(made) == made
    other = ev3proto.operation("ARRAY.DESTROY", LV(0), dialect="xtended")
    assert pickle.loads(pickle.dumps(other)) == other
    assert other.command == "DESTROY"
    assert ev3proto.operation("ARRAY.DELETE", LV(0)) != other


def test_a_cmd_above_31_takes_two_bytes() -> None:
    """UI_DRAW TEXTBOX is 32, which LC0 cannot hold."""
    operation = ev3proto.operation("UI_DRAW.TEXTBOX", 0, 0, 178, 128, "text", 10, 1, LV(0))
    assert operation.raw[:3] == b"\x84\x81\x20"


@pytest.mark.parametrize("cmd", ["01", "81:01", "82:01:00", "83:01:00:00:00"])
def test_cmd_is_a_parameter_like_any_other(cmd: str) -> None:
    code = frame_of(f"94:{cmd}:01:82:B8:01:82:E8:03")
    frame = (5 + len(code)).to_bytes(2, "little") + frame_of("2A:00|80|00:00") + code
    message = ev3proto.parse(frame, expect=ev3proto.DirectCommand)
    (operation,) = message.operations
    assert operation.full_name == "SOUND.TONE"
    assert operation.cmd is not None
    assert (operation.cmd.value, operation.cmd.raw) == (1, frame_of(cmd))
    assert [argument.value for argument in operation.arguments] == [1, 440, 1000]


@pytest.mark.parametrize(
    ("text", "encoding", "value"),
    [
        ("05", "LC0", 5),
        ("20", "LC0", -32),
        ("81:05", "LC1", 5),
        ("81:FF", "LC1", -1),
        ("82:18:FC", "LC2", -1000),
        ("83:05:00:00:00", "LC4", 5),
        ("A0:FB", "LAB1", -5),
        ("5F", "LV0", 31),
        ("C1:FF", "LV1", 255),
        ("C2:00:01", "LV2", 256),
        ("C3:00:00:01:00", "LV4", 65536),
        ("7F", "GV0", 31),
        ("E1:20", "GV1", 32),
        ("E2:00:01", "GV2", 256),
        ("E3:00:00:01:00", "GV4", 65536),
        ("80:48:69:00", "LCS_OLD", "Hi"),
        ("84:E4:00", "LCS", "ä"),
        ("84:00", "LCS", ""),
    ],
)
def test_encodings(text: str, encoding: str, value: object) -> None:
    """As the argument of a jump, which accepts anything."""
    (argument,) = operation_of("40:" + text).arguments
    assert (argument.encoding, argument.value, argument.raw) == (encoding, value, frame_of(text))


def test_a_float_is_an_lc4_where_the_parameter_is_a_dataf() -> None:
    assert ev3proto.operation("MOVEF_F", 1.0, LV(0)).raw == frame_of("3F:83:00:00:80:3F:40")
    as_float = operation_of("3F:83:00:00:80:3F:40")
    as_number = operation_of("3A:83:00:00:80:3F:40")
    assert as_float.arguments[0].value == 1.0
    assert as_number.arguments[0].value == 0x3F800000


@pytest.mark.parametrize(
    ("name", "raw"),
    [
        ("MOVE8_8", "30:81:80:40"),
        ("MOVE16_16", "35:82:00:80:40"),
        ("MOVE32_32", "3A:83:00:00:00:80:40"),
        ("MOVEF_F", "3F:83:00:00:C0:7F:40"),
    ],
)
def test_not_a_number(name: str, raw: str) -> None:
    assert ev3proto.operation(name, float("nan"), LV(0)).raw == frame_of(raw)


@pytest.mark.parametrize(
    ("value", "raw"),
    [
        (31, "1F"),
        (32, "81:20"),
        (-32, "20"),
        (-33, "81:DF"),
        (127, "81:7F"),
        (128, "82:80:00"),
        (-127, "81:81"),
        (-128, "82:80:FF"),
        (32767, "82:FF:7F"),
        (32768, "83:00:80:00:00"),
        (-32768, "83:00:80:FF:FF"),
        (2147483647, "83:FF:FF:FF:7F"),
        (LV(31), "5F"),
        (LV(32), "C1:20"),
        (LV(256), "C2:00:01"),
        (GV(31), "7F"),
        (GV(255), "E1:FF"),
        (GV(65536), "E3:00:00:01:00"),
        (GV(3, handle=True), "F1:03"),
        (LV(3, address=True), "C9:03"),
    ],
)
def test_the_shortest_encoding_is_built(value: object, raw: str) -> None:
    assert ev3proto.operation("MOVE32_32", value, LV(0)).raw == b"\x3a" + frame_of(raw) + b"\x40"


# System commands


@pytest.mark.parametrize(
    ("text", "command", "fields"),
    [
        ("0B:00|01:00|01|92|10:00:00:00:2E:2E:00", "BEGIN_DOWNLOAD", {"size": 16, "path": ".."}),
        ("07:00|01:00|01|93|02:AA:BB", "CONTINUE_DOWNLOAD", {"handle": 2, "data": b"\xaa\xbb"}),
        ("09:00|01:00|01|94|E8:03:2E:2E:00", "BEGIN_UPLOAD", {"max_bytes": 1000, "path": ".."}),
        ("07:00|01:00|01|95|02:E8:03", "CONTINUE_UPLOAD", {"handle": 2, "max_bytes": 1000}),
        ("05:00|01:00|01|98|02", "CLOSE_FILEHANDLE", {"handle": 2}),
        ("15:00|01:00|01|98|02" + ":11" * 16, "CLOSE_FILEHANDLE", {"handle": 2, "hash": b"\x11" * 16}),
        ("09:00|01:00|01|99|E8:03:2E:2E:00", "LIST_FILES", {"max_bytes": 1000, "path": ".."}),
        ("07:00|01:00|01|9A|02:E8:03", "CONTINUE_LIST_FILES", {"handle": 2, "max_bytes": 1000}),
        ("06:00|01:00|01|9B|61:00", "CREATE_DIR", {"path": "a"}),
        ("06:00|01:00|01|9C|61:00", "DELETE_FILE", {"path": "a"}),
        ("04:00|01:00|01|9D", "LIST_OPEN_HANDLES", {}),
        (
            # The name's length counts its zero, as the firmware sends it ...
            "0C:00|01:00|81|9E|03:61:62:00:02:00:31:00",
            "WRITEMAILBOX",
            {"name_length": 3, "name": "ab", "payload_length": 2, "payload": b"1\x00"},
        ),
        (
            # ... and does not, as the published text has it.
            "0C:00|01:00|81|9E|02:61:62:00:02:00:31:00",
            "WRITEMAILBOX",
            {"name_length": 2, "name": "ab", "payload_length": 2, "payload": b"1\x00"},
        ),
        (
            "0D:00|01:00|01|9F|03:30:31:00:04:31:32:33:00",
            "BLUETOOTHPIN",
            {"mac_length": 3, "mac": "01", "pin_length": 4, "pin": "123"},
        ),
        ("04:00|01:00|81|A0", "ENTERFWUPDATE", {}),
        ("07:00|01:00|01|A1|61:62:00", "SETBUNDLEID", {"id": "ab"}),
        (
            "0C:00|01:00|01|F0|00:00:01:00:00:02:00:00",
            "BEGIN_DOWNLOAD_WITH_ERASE",
            {"address": 0x10000, "image_size": 512},
        ),
        ("0C:00|01:00|01|F1|00:00:01:00:00:02:00:00", "BEGIN_DOWNLOAD", {"address": 0x10000, "image_size": 512}),
        ("06:00|01:00|01|F2|AA:BB", "DOWNLOAD_DATA", {"data": b"\xaa\xbb"}),
        ("04:00|01:00|01|F3", "CHIP_ERASE", {}),
        ("04:00|01:00|01|F4", "START_APP", {}),
        ("0C:00|01:00|01|F5|00:00:01:00:00:02:00:00", "GET_CHECKSUM", {"address": 0x10000, "image_size": 512}),
        ("04:00|00:00|01|F6", "GET_VERSION", {}),
    ],
)
def test_system_commands(text: str, command: str, fields: dict[str, object]) -> None:
    frame = frame_of(text)
    message = ev3proto.parse(frame, expect=ev3proto.SystemCommand)
    assert (message.command, message.number, dict(message.fields)) == (command, frame[5], fields)
    assert message.wants_reply == (frame[4] == 0x01)
    built = ev3proto.system_command(frame[5], counter=message.counter, reply=frame[4] == 0x01, **message.fields)
    assert built == message
    assert built.build() == frame


@pytest.mark.parametrize(
    ("text", "command", "status", "fields"),
    [
        ("06:00|01:00|03|92:00|02", "BEGIN_DOWNLOAD", "SUCCESS", {"handle": 2}),
        ("05:00|01:00|05|92:06", "BEGIN_DOWNLOAD", "ILLEGAL_PATH", {}),
        ("06:00|01:00|03|93:08|02", "CONTINUE_DOWNLOAD", "END_OF_FILE", {"handle": 2}),
        (
            "0C:00|01:00|03|94:00|10:00:00:00:02:AA:BB",
            "BEGIN_UPLOAD",
            "SUCCESS",
            {"size": 16, "handle": 2, "data": b"\xaa\xbb"},
        ),
        ("07:00|01:00|03|95:08|02:AA", "CONTINUE_UPLOAD", "END_OF_FILE", {"handle": 2, "data": b"\xaa"}),
        ("05:00|01:00|03|98:00", "CLOSE_FILEHANDLE", "SUCCESS", {}),
        ("06:00|01:00|03|98:00|02", "CLOSE_FILEHANDLE", "SUCCESS", {"handle": 2}),
        (
            "0D:00|01:00|03|99:08|03:00:00:00:02:61:2F:0A",
            "LIST_FILES",
            "END_OF_FILE",
            {"list_size": 3, "handle": 2, "list": "a/\n"},
        ),
        ("09:00|01:00|03|9A:08|02:61:2F:0A", "CONTINUE_LIST_FILES", "END_OF_FILE", {"handle": 2, "list": "a/\n"}),
        ("05:00|01:00|05|9B:07", "CREATE_DIR", "FILE_EXITS", {}),
        ("09:00|01:00|03|F5:00|78:56:34:12", "GET_CHECKSUM", "SUCCESS", {"checksum": 0x12345678}),
    ],
)
def test_system_replies(text: str, command: str, status: str, fields: dict[str, object]) -> None:
    message = ev3proto.parse(frame_of(text), expect=ev3proto.SystemReply)
    assert message.command == command
    assert message.status is ev3proto.SystemStatus[status]
    assert dict(message.fields) == fields
    assert message.build() == frame_of(text)


def test_begin_download_of_the_bootloader() -> None:
    assert ev3proto.system_command("BEGIN_DOWNLOAD", size=1, path="a").number == 0x92
    assert ev3proto.system_command(0xF1, address=0, image_size=1).command == "BEGIN_DOWNLOAD"


# The daisy chain


def test_daisy_operations_downstream() -> None:
    message = ev3proto.parse(frame_of("0A:00|01:00|8A|A0:00:01|A3:00:01:00"), expect=ev3proto.DaisyCommand)
    assert (message.kind, message.command, message.number) == ("daisy-command", "DOWNSTREAM", 0xA0)
    assert (message.layer_from, message.layer_to) == (0, 1)
    assert message.payload == frame_of("A3:00:01:00")
    (operation,) = message.operations
    assert (operation.full_name, operation.offset) == ("OUTPUT_STOP", 8)


@pytest.mark.parametrize(
    ("number", "name"),
    [
        (0xA0, "DOWNSTREAM"),
        (0xA1, "UPSTREAM"),
        (0xA2, "INFO"),
        (0xA3, "UNLOCK_SLAVE"),
        (0xA4, "SET_TYPE"),
        (0xA5, "DOWNSTREAM_WITH_BUSY"),
    ],
)
def test_daisy_commands(number: int, name: str) -> None:
    message = ev3proto.parse(frame_of("06:00|01:00|0A") + bytes((number, 1, 2)), expect=ev3proto.DaisyCommand)
    assert (message.command, message.layer_from, message.layer_to, message.payload) == (name, 1, 2, b"")
    assert message.wants_reply


def test_daisy_sensor_report() -> None:
    data = bytes(range(32))
    body = frame_of("01:00|01:02:00:10:03") + data + frame_of("5A|0F")
    message = ev3proto.parse(
        (3 + len(body)).to_bytes(2, "little") + frame_of("01:00|08") + body, expect=ev3proto.DaisyReply
    )
    assert (message.kind, message.layer_from, message.layer_to) == ("daisy-reply", 1, 0)
    report = message.report
    assert report is not None
    assert (report.layer, report.port, report.status, report.type, report.mode) == (1, 2, 0, 16, 3)
    assert (report.data, report.checksum, report.busy) == (data, 0x5A, b"\x0f")


# Faults and their places


@pytest.mark.parametrize(
    ("text", "offset", "reason"),
    [
        # The envelope
        ("", 0, "at least 5 bytes"),
        ("03:00|2A", 3, "at least 5 bytes"),
        ("04:00|2A:00|02", 0, "cut off"),
        ("03:00|2A:00|02|FF", 5, "longer than its length field says"),
        ("02:00|2A:00|02", 0, "length field says 2"),
        ("FF:04|2A:00|02", 0, "length field says 1279"),
        ("03:00|2A:00|77", 4, "unknown message type 0x77"),
        # Direct commands
        ("04:00|2A:00|00|00", 6, "ends before the two bytes that request memory"),
        ("06:00|2A:00|00|00:00|FE", 7, "unknown opcode 0xFE"),
        ("07:00|2A:00|00|00:00|94:1F", 8, "SOUND has no CMD 31"),
        ("07:00|2A:00|00|00:00|94:60", 8, "CMD of SOUND is GV(0), but must be a constant"),
        ("06:00|2A:00|00|00:00|94", 8, "CMD"),
        ("08:00|2A:00|00|00:00|A4:00:01", 10, "the frame ends before the argument POWER"),
        ("0A:00|2A:00|00|00:00|A4:00:01:82:14", 10, "POWER runs past the end of the frame"),
        ("0B:00|2A:00|00|00:00|96|94:02:01:84:41", 11, "its terminating zero is missing"),
        # A count that would keep a careless decoder busy for minutes
        ("0C:00|2A:00|00|00:00|2F:40:83:FF:FF:FF:7F", 9, "LENGTH cannot be 2147483647"),
        ("08:00|2A:00|00|00:00|2F:40:3F", 9, "LENGTH cannot be -1"),
        ("09:00|2A:00|00|00:00|2F:40:41:01", 9, "LENGTH must be a constant"),
        ("0A:00|2A:00|00|00:00|C1:0A:40:00:3F", 11, "ELEMENTS cannot be -1"),
        # Identification bytes that the firmware does not define
        ("09:00|2A:00|00|00:00|A3:00:01:85", 10, "undefined identification byte 0x85"),
        ("09:00|2A:00|00|00:00|A3:00:01:C0", 10, "undefined identification byte 0xC0"),
        # System messages
        ("03:00|2A:00|01", 5, "ends before the system command"),
        ("04:00|2A:00|01|77", 5, "unknown system command 0x77"),
        ("06:00|2A:00|01|9B|61:62", 6, "path runs past the end"),
        ("06:00|2A:00|01|95|02:E8", 7, "max_bytes"),
        ("05:00|2A:00|01|9D|00", 6, "1 byte left over"),
        ("0C:00|2A:00|81|9E|03:61:62:00:03:00:31:00", 12, "payload_length says 3 bytes, but 2 follow"),
        ("04:00|2A:00|03|92", 6, "ends before the command answered and the status"),
        # The daisy chain
        ("05:00|2A:00|0A|A0:00", 7, "two layers"),
        ("06:00|2A:00|0A|77:00:01", 5, "unknown daisy sub-command 0x77"),
        ("04:00|2A:00|08|00", 6, "two layers"),
    ],
)
def test_faults(text: str, offset: int, reason: str) -> None:
    frame = frame_of(text)
    with pytest.raises(DecodeError) as raised:
        ev3proto.parse(frame)
    assert (raised.value.offset, reason in raised.value.reason) == (offset, True), str(raised.value)
    lenient = ev3proto.parse(frame, strict=False)
    assert lenient.fault == raised.value.fault
    assert lenient.build() == frame
    assert seconds(lambda: ev3proto.parse(frame, strict=False)) < 0.5


def test_a_fault_is_a_value_error() -> None:
    with pytest.raises(ValueError, match=r"^offset 7: unknown opcode 0xFE for the official firmware$"):
        ev3proto.parse(frame_of("06:00|2A:00|00|00:00|FE"))


def test_a_frame_has_at_most_1024_bytes() -> None:
    assert len(ev3proto.parse(b"\xfe\x03\x2a\x00\x02" + bytes(1019)).build()) == 1024
    with pytest.raises(DecodeError, match="length field says 1023"):
        ev3proto.parse(b"\xff\x03\x2a\x00\x02" + bytes(1020))


def test_operations_before_a_fault_are_kept() -> None:
    frame = frame_of("0D:00|2A:00|80|01:00|A6:00:01|94:01:81:14:85")
    message = ev3proto.parse(frame, strict=False, expect=ev3proto.DirectCommand)
    assert message.fault is not None
    assert message.fault.offset == 14
    assert message.global_size == 1
    start, tone = message.operations
    assert (start.full_name, start.is_complete) == ("OUTPUT_START", True)
    assert (tone.full_name, tone.is_complete) == ("SOUND.TONE", False)
    assert arguments_of(tone) == [("VOLUME", 20, "LC1")]
    assert message.rest == b"\x85"
    assert message.build() == frame


def test_the_bootloader_fault_is_named() -> None:
    """The request written over the first bytes of the reply, as observed on a USB 3 port."""
    frame = frame_of("04:00:00:00:01:F6:7F:B6:00:00:00:06:00:00")
    message = ev3proto.parse(frame, strict=False)
    assert message.fault is not None
    assert message.fault.offset == 6
    for words in ("bootloader", "USB 3", "GET_VERSION", "request written over"):
        assert words in message.fault.reason
    assert message.build() == frame


# What the builder refuses


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (lambda: ev3proto.operation("SOUND.TONE", 300, 440, 1000), ["VOLUME", "300", "-127 to 127"]),
        (lambda: ev3proto.operation("SOUND.TONE", 1.5, 440, 1000), ["VOLUME", "1.5", "whole number"]),
        (lambda: ev3proto.operation("SOUND.TONE", "loud", 440, 1000), ["VOLUME", "'loud'", "number"]),
        (lambda: ev3proto.operation("SOUND.TONE", None, 440, 1000), ["VOLUME", "None", "DATA8"]),
        (lambda: ev3proto.operation("SOUND.TONE", 1, 440), ["SOUND.TONE", "DURATION"]),
        (lambda: ev3proto.operation("SOUND.TONE", VOLUME=1, PITCH=440), ["PITCH", "FREQUENCY"]),
        (lambda: ev3proto.operation("SOUND.TONE", LV(-1), 440, 1000), ["VOLUME", "LV(-1)", "0 to 4294967295"]),
        (lambda: ev3proto.operation("SOUND.PLAY", 1, "a\0b"), ["NAME", r"'a\x00b'", "zero"]),
        (lambda: ev3proto.operation("SOUND.PLAY", 1, "€"), ["NAME", "'€'", "ISO-8859-1"]),
        (lambda: ev3proto.operation("SOUND_TEST", 1), ["BUSY", "output", "GV(0)"]),
        (lambda: ev3proto.operation("MOVEF_F", 1e39, LV(0)), ["SOURCE", "1e+39", "3.4028235e38"]),
        (lambda: ev3proto.operation("INIT_BYTES", LV(0), 3, [1, 2]), ["LENGTH", "3", "2 values follow"]),
        (lambda: ev3proto.operation("CALL", 1, [0] * 128), ["PARAMETERS", "128", "0 to 127"]),
        (lambda: ev3proto.operation("SOUND.TON", 1), ["SOUND.TON", "SOUND.TONE"]),
        (lambda: ev3proto.direct_command(local_size=64), ["local_size", "64", "0 to 63"]),
        (lambda: ev3proto.direct_command(counter=65536), ["counter", "65536", "0 to 65535"]),
        (lambda: ev3proto.direct_command(*[ev3proto.operation("SOUND_READY")] * 1018), ["1025 bytes", "1024"]),
        (lambda: ev3proto.direct_reply(bytes(1020)), ["1025 bytes", "1024"]),
        (lambda: ev3proto.system_command("CREATE_DIR", path="a\0"), ["path", r"'a\x00'", "zero"]),
        (lambda: ev3proto.system_command("CREATE_DIR"), ["path", "missing"]),
        (lambda: ev3proto.system_command("CLOSE_FILEHANDLE", handle=256), ["handle", "256", "0 to 255"]),
        (lambda: ev3proto.system_command("LIST_FILE", path="a"), ["LIST_FILE", "LIST_FILES"]),
        (lambda: ev3proto.operation("MOVEF_F", 10**400, GV(0)), ["a DATAF is from"]),
        (lambda: ev3proto.operation("SOUND.TONE", 10**400, 1, 1), ["VOLUME cannot be 1000"]),
        (lambda: ev3proto.operation("MOVEF_F", 1.0, GV("x")), ["the index of a variable must be"]),  # type: ignore[arg-type]
        (lambda: ev3proto.direct_reply("abc"), ["memory takes bytes"]),  # type: ignore[arg-type]
        (lambda: ev3proto.direct_command(b"\x01"), ["is not an operation"]),  # type: ignore[arg-type]
        (lambda: ev3proto.system_command("CONTINUE_DOWNLOAD", handle=0, data=5), ["data takes bytes"]),
    ],
)
def test_refusals(build: Callable[[], object], words: list[str]) -> None:
    """The message names the parameter, the value, and the legal values."""
    with pytest.raises(BuildError) as raised:
        build()
    for word in words:
        assert word in str(raised.value)


@pytest.mark.parametrize(
    ("value", "constant"),
    [
        (-32, "20"),
        (-1, "3F"),
        (31, "1F"),
        (-33, "81 DF"),
        (32, "81 20"),
        (-127, "81 81"),
        (127, "81 7F"),
        (-128, "82 80 FF"),
        (128, "82 80 00"),
        (-32767, "82 01 80"),
        (32767, "82 FF 7F"),
        (-32768, "83 00 80 FF FF"),
        (32768, "83 00 80 00 00"),
        (-2147483648, "83 00 00 00 80"),
        (2147483647, "83 FF FF FF 7F"),
    ],
)
def test_the_shortest_constant(value: int, constant: str) -> None:
    assert encode_integer(value) == bytes.fromhex(constant)


@pytest.mark.parametrize("value", [-2147483649, 2147483648])
def test_a_constant_has_at_most_32_bits(value: int) -> None:
    with pytest.raises(BuildError, match=f"a constant cannot be {value}"):
        encode_integer(value)


@pytest.mark.parametrize("field", ["counter", "number", "layer_from", "layer_to"])
@pytest.mark.parametrize("is_low", [True, False], ids=["low", "high"])
def test_the_numbers_of_a_message_have_limits(field: str, is_low: bool) -> None:
    message = ev3proto.parse(bytes.fromhex("0700 2A00 0A A0 00 01 01"), strict=False)
    most = 65535 if field == "counter" else 255
    legal: dict[str, Any]
    wrong: dict[str, Any]
    legal, wrong = ({field: 0}, {field: -1}) if is_low else ({field: most}, {field: most + 1})
    assert len(dataclasses.replace(message, **legal).build()) == 9
    with pytest.raises(BuildError, match=f"{field} cannot be {wrong[field]}: it is a whole number from 0 to {most}"):
        dataclasses.replace(message, **wrong).build()


@pytest.mark.parametrize(
    "frame", ["0e002a0080000094010182b80182e803", "0c000100 0199 e803 2f70726a7300", "05000100059906"]
)
def test_every_beginning_of_a_frame_is_a_message_of_its_kind(frame: str) -> None:
    whole = bytes.fromhex(frame)
    for size in range(len(whole)):
        message = ev3proto.parse(whole[:size], strict=False)
        assert message.build() == whole[:size]
        assert message.fault is not None
        assert message.fault.truncated
        if size >= 5:
            assert type(message) is type(ev3proto.parse(whole))
        with pytest.raises(DecodeError) as error:
            ev3proto.parse(whole[:size])
        assert error.value.fault == message.fault


def test_only_bytes_are_parsed() -> None:
    with pytest.raises(TypeError):
        ev3proto.parse(5)  # type: ignore[call-overload]
    assert ev3proto.parse(bytearray.fromhex("0600010080000001")).counter == 1


def test_a_length_that_is_too_small_is_told_with_both_numbers() -> None:
    with pytest.raises(DecodeError) as caught:
        ev3proto.parse(frame_of("03:00|2A:00|02|FF:00"))
    assert caught.value.reason == "the frame is longer than its length field says: 3 bytes should follow it, but 5 do"


@pytest.mark.parametrize(
    ("name", "values", "limits"),
    [
        ("LC0", (-33, 32), "-32 to 31"),
        ("LC1", (-129, 128), "-128 to 127"),
        ("LC2", (-32769, 32768), "-32768 to 32767"),
        ("LC4", (-2147483649, 2147483648), "-2147483648 to 2147483647"),
        ("GV0", (-1, 32), "0 to 31"),
        ("LV1", (-1, 256), "0 to 255"),
        ("GV2", (-1, 65536), "0 to 65535"),
        ("LV4", (-1, 4294967296), "0 to 4294967295"),
    ],
)
def test_an_encoding_names_its_limits(name: str, values: tuple[int, int], limits: str) -> None:
    for value in values:
        with pytest.raises(BuildError) as caught:
            encode_as(name, value)
        assert str(caught.value) == f"{name} cannot hold {value}: it is limited to {limits}"

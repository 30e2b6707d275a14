"""The dissector's fields for filters, besides those of parameters, and its expert information.

Their names are a public interface: people have filters, columns and colouring rules with them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.schema.wire_format import SENSOR_REPORT
from ev3proto.tables.discovery import BEACON_LINES
from ev3proto.tables.output import MOTOR_LETTERS
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemField

FAMILIAR = {
    "size": "file_len",
    "hardware_version": "hw_id",
    "firmware_version": "fw_id",
    "name": "mailbox",
    "name_length": "mailbox_length",
}
"""Filter names that differ from the tables: people have used them since the first dissectors for the EV3."""

HEXADECIMAL = ("address", "checksum", "hardware_version", "firmware_version")
"""Numbers usually written in hexadecimal."""


def filter_name(command: SystemDeclaration, field: SystemField) -> str:
    """Returns what follows `ev3.` in the filter name of a system message's field."""
    if field.name == "path":
        # A path belongs to a file if the command or its reply gives the file's length.
        fields = (*command.request, *command.reply)
        return "file_name" if any(other.name == "size" for other in fields) else "path_name"
    return FAMILIAR.get(field.name, field.name)


def label(field: SystemField) -> str:
    """Returns the label of a field in the packet tree: `Max bytes`."""
    return field.name.replace("_", " ").capitalize()


_PIECES = ("data", "busy")
"""The parts of a daisy reply that are not numbers."""

_BYTES = 'base.UNIT_STRING, { " byte", " bytes" }'


class ProtoField(NamedTuple):
    """A field.

    key        its name in the runtime
    kind       its type, a function of `ProtoField`
    name       its name in filters, after `ev3.`
    title      its name in the packet tree
    rest       further arguments of the function, in Lua
    generated  whether it is computed: no bytes of the frame are its value
    """

    key: str
    kind: str
    name: str
    title: str
    rest: str = ""
    generated: bool = False


_KINDS = {
    **{FieldKind.U8: "uint8", FieldKind.U16: "uint16", FieldKind.U32: "uint32", FieldKind.DATA: "bytes"},
    **dict.fromkeys((FieldKind.TEXT, FieldKind.COUNTED_TEXT, FieldKind.LISTING), "string"),
}


def _of_system_messages() -> Iterator[ProtoField]:
    """Yields the fields of system messages; several messages share one."""
    made = set[str]()
    for command in SYSTEM:
        for each in (*command.request, *command.reply):
            name = filter_name(command, each)
            if name not in made:
                made.add(name)
                shown = "base.HEX" if each.name in HEXADECIMAL else ""
                yield ProtoField(f"system_{name}", _KINDS[each.kind], name, label(each), shown)


class Expert(NamedTuple):
    """Expert information: its name in filters after `ev3.expert.`, its title, Wireshark's group and severity."""

    name: str
    title: str
    group: str
    severity: str


FIELDS = (
    ProtoField("bytes", "bytes", "bytes", "Bytes", 'base.NONE, "all bytes of a frame, or of a text between frames"'),
    ProtoField("brick", "string", "brick", "Brick", '"the brick that it goes to or comes from"', generated=True),
    ProtoField(
        "connection",
        "uint32",
        "connection",
        "Connection",
        'base.DEC, nil, nil, "the number of its conversation in the capture, from 1"',
        generated=True,
    ),
    ProtoField("length", "uint16", "msg_len", "Length", 'base.DEC, nil, nil, "bytes that follow this field"'),
    ProtoField(
        "counter",
        "uint16",
        "msg_num",
        "Message counter",
        'base.DEC, nil, nil, "chosen by the sender, echoed in the reply"',
    ),
    ProtoField("type", "uint8", "cmd_type", "Type", "base.HEX, NAMES.message_types"),
    ProtoField("memory_sizes", "uint16", "vars", "Requested memory", "base.HEX"),
    ProtoField(
        "globals", "uint16", "globals", "Global memory", _BYTES + ', GLOBAL_MASK, "bytes of the reply\'s payload"'
    ),
    ProtoField("locals", "uint16", "locals", "Local memory", _BYTES + ", LOCAL_MASK"),
    ProtoField("opcode", "uint8", "op", "Opcode", "base.HEX, NAMES.opcodes"),
    ProtoField("cmd", "string", "cmd", "CMD", '"opcode and CMD by name, such as SOUND.TONE"'),
    ProtoField("encoding", "string", "argument.encoding", "Encoding", '"how the argument is encoded"'),
    ProtoField(
        "variable",
        "string",
        "argument.variable",
        "Variable",
        '"the variable that is used as an argument, such as GV(0)"',
    ),
    *(
        ProtoField(f"port_{bit}", "bool", f"ports.{port.lower()}", port, f'8, nil, 0x{1 << bit:02X}, "a motor in NOS"')
        for bit, port in MOTOR_LETTERS.items()
    ),
    ProtoField("other", "string", "argument.value", "Value", '"a constant whose type differs from its parameter\'s"'),
    ProtoField("memory", "bytes", "memory", "Global memory"),
    ProtoField(
        "answers",
        "string",
        "answers",
        "Answers",
        '"the operation that these values of a reply belong to, such as UI_READ.GET_VBATT"',
    ),
    ProtoField("list", "none", "values", "Values"),
    ProtoField("system_command", "uint8", "sys_cmd", "System command", "base.HEX, NAMES.system_commands"),
    ProtoField("status", "uint8", "reply_status", "Status", "base.HEX, STATUS.names"),
    ProtoField("message_text", "string", "payload.text", "Text", '"a mailbox\'s message as text"'),
    ProtoField("message_number", "float", "payload.number", "Number", '"a mailbox\'s message as a number"'),
    ProtoField(
        "message_logic", "bool", "payload.logic", "Logic", 'base.NONE, nil, 0, "a mailbox\'s message as true or false"'
    ),
    ProtoField("daisy_command", "uint8", "daisy.command", "Sub-command", "base.HEX, DAISY.names"),
    ProtoField("layer_from", "uint8", "daisy.layer_from", "From layer"),
    ProtoField("layer_to", "uint8", "daisy.layer_to", "To layer"),
    ProtoField("daisy_payload", "bytes", "daisy.payload", "Payload"),
    ProtoField("rest", "bytes", "rest", "Not read", 'base.SPACE, "bytes that could not be read"'),
    ProtoField("padding", "bytes", "padding", "Padding", 'base.SPACE, "the unused rest of a USB report"'),
    ProtoField("fragment", "bytes", "fragment", "Part of a frame", "base.SPACE"),
    ProtoField("fragment_of", "framenum", "fragment_of", "Frame complete in", generated=True),
    ProtoField("fragments", "framenum", "fragments", "Began in", generated=True),
    ProtoField(
        "response_in", "framenum", "response_in", "Response in", "base.NONE, frametype.RESPONSE", generated=True
    ),
    ProtoField("request_in", "framenum", "request_in", "Request in", "base.NONE, frametype.REQUEST", generated=True),
    ProtoField("response_time", "relative_time", "response_time", "Response time", generated=True),
    ProtoField("transfer_path", "string", "transfer.path", "File", generated=True),
    ProtoField("transfer_done", "uint32", "transfer.done", "Transferred", _BYTES, generated=True),
    ProtoField("transfer_size", "uint32", "transfer.size", "Size", _BYTES, generated=True),
    ProtoField("beacon_answer", "bytes", "beacon.answer", "Answer to a beacon", "base.SPACE"),
    ProtoField("unlock", "string", "unlock", "Unlock"),
    ProtoField("unlock_serial", "string", "unlock.serial", "Serial number"),
    ProtoField("accept", "string", "accept", "Accept"),
    *(ProtoField(f"beacon_{name}", "string", f"beacon.{name}", label) for name, label in BEACON_LINES.items()),
    *_of_system_messages(),
    # A daisy reply carries a sensor's data part by part.
    *(
        ProtoField(f"daisy_{part.name}", "bytes" if part.name in _PIECES else "uint8", f"daisy.{part.name}", part.name)
        for part in SENSOR_REPORT.subcons
    ),
)

EXPERTS = (
    Expert("fault", "Faulty frame", "MALFORMED", "ERROR"),
    Expert("unknown_opcode", "Unknown opcode", "MALFORMED", "ERROR"),
    Expert("unknown_cmd", "Unknown CMD", "MALFORMED", "ERROR"),
    Expert("cut_off", "Cut off", "MALFORMED", "ERROR"),
    Expert("cut_by_capture", "Cut by the capture", "UNDECODED", "NOTE"),
    Expert("misaligned", "Misaligned variable", "PROTOCOL", "ERROR"),
    Expert("beyond_memory", "Variable beyond the requested memory", "PROTOCOL", "WARN"),
    Expert("refused", "Argument that the brick refuses", "PROTOCOL", "ERROR"),
    Expert("misread", "Value that the brick misreads, or that is not documented", "PROTOCOL", "WARN"),
    Expert("no_boundary", "No frame starts here", "MALFORMED", "ERROR"),
    Expert("error_reply", "The brick refused the command, or it failed", "RESPONSE_CODE", "WARN"),
    Expert("failed", "The command failed", "RESPONSE_CODE", "WARN"),
    Expert("orphan", "The command that this reply answers was not seen", "SEQUENCE", "NOTE"),
    Expert("locked", "A connection without the unlock text", "SEQUENCE", "WARN"),
    Expert("unanswered", "No reply to this command was seen", "SEQUENCE", "WARN"),
    Expert("waiting", "No reply to this command was seen so far", "SEQUENCE", "NOTE"),
    Expert("incomplete_file", "A file with another size than announced", "SEQUENCE", "WARN"),
    Expert("unsure", "The pairing is unsure", "SEQUENCE", "NOTE"),
    Expert("other_size", "Another size than the command requests", "PROTOCOL", "WARN"),
    Expert("bootloader_fault", "Bootloader fault on USB 3", "PROTOCOL", "ERROR"),
)

"""The dissector's fields for filters, besides those of parameters, and its expert information.

Their names are a public interface: people have filters, columns and colouring rules with them.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.generate.dissector.names import HEXADECIMAL, filter_name, label
from ev3proto.schema.wire_format import SENSOR_REPORT
from ev3proto.tables.discovery import BEACON_LINES
from ev3proto.tables.system import SYSTEM, Kind

_PIECES = ("data", "busy")
"""The parts of a daisy reply that are not numbers."""

_BYTES = 'base.UNIT_STRING, { " byte", " bytes" }'


class Field(NamedTuple):
    """A field.

    key    its name in the runtime
    kind   its type, a function of `ProtoField`
    name   its name in filters, after `ev3.`
    title  its name in the packet tree
    rest   further arguments of the function, in Lua
    """

    key: str
    kind: str
    name: str
    title: str
    rest: str = ""


_KINDS = {
    **{Kind.U8: "uint8", Kind.U16: "uint16", Kind.U32: "uint32", Kind.DATA: "bytes"},
    **dict.fromkeys((Kind.TEXT, Kind.COUNTED_TEXT, Kind.LISTING), "string"),
}


def _of_system_messages() -> Iterator[Field]:
    """Yields the fields of system messages; several messages share one."""
    made = set[str]()
    for command in SYSTEM:
        for each in (*command.request, *command.reply):
            name = filter_name(command, each)
            if name not in made:
                made.add(name)
                shown = "base.HEX" if each.name in HEXADECIMAL else ""
                yield Field(f"system_{name}", _KINDS[each.kind], name, label(each), shown)


class Expert(NamedTuple):
    """Expert information: its name in filters after `ev3.expert.`, its title, Wireshark's group and severity."""

    name: str
    title: str
    group: str
    severity: str


FIELDS = (
    Field("bytes", "bytes", "bytes", "Bytes", 'base.NONE, "all bytes of a frame, or of a text between frames"'),
    Field("brick", "string", "brick", "Brick", '"the brick that it goes to or comes from"'),
    Field("length", "uint16", "msg_len", "Length", 'base.DEC, nil, nil, "bytes that follow this field"'),
    Field(
        "counter",
        "uint16",
        "msg_num",
        "Message counter",
        'base.DEC, nil, nil, "chosen by the sender, echoed in the reply"',
    ),
    Field("type", "uint8", "cmd_type", "Type", "base.HEX, NAMES.message_types"),
    Field("memory_sizes", "uint16", "vars", "Requested memory", "base.HEX"),
    Field("globals", "uint16", "globals", "Global memory", _BYTES + ', GLOBAL_MASK, "bytes of the reply\'s payload"'),
    Field("locals", "uint16", "locals", "Local memory", _BYTES + ", LOCAL_MASK"),
    Field("opcode", "uint8", "op", "Opcode", "base.HEX, NAMES.opcodes"),
    Field("cmd", "string", "cmd", "CMD", '"opcode and CMD by name, such as SOUND.TONE"'),
    Field("encoding", "string", "argument.encoding", "Encoding", '"how the argument is encoded"'),
    Field(
        "variable",
        "string",
        "argument.variable",
        "Variable",
        '"the variable that is used as an argument, such as GV(0)"',
    ),
    Field("other", "string", "argument.value", "Value", '"a constant whose type differs from its parameter\'s"'),
    Field("memory", "bytes", "memory", "Global memory"),
    Field(
        "answers",
        "string",
        "answers",
        "Answers",
        '"the operation that these values of a reply belong to, such as UI_READ.GET_VBATT"',
    ),
    Field("list", "none", "values", "Values"),
    Field("system_command", "uint8", "sys_cmd", "System command", "base.HEX, NAMES.system_commands"),
    Field("status", "uint8", "reply_status", "Status", "base.HEX, STATUS.names"),
    Field("message_text", "string", "payload.text", "Text", '"a mailbox\'s message as text"'),
    Field("message_number", "float", "payload.number", "Number", '"a mailbox\'s message as a number"'),
    Field(
        "message_logic", "bool", "payload.logic", "Logic", 'base.NONE, nil, 0, "a mailbox\'s message as true or false"'
    ),
    Field("daisy_command", "uint8", "daisy.command", "Sub-command", "base.HEX, DAISY.names"),
    Field("layer_from", "uint8", "daisy.layer_from", "From layer"),
    Field("layer_to", "uint8", "daisy.layer_to", "To layer"),
    Field("daisy_payload", "bytes", "daisy.payload", "Payload"),
    Field("rest", "bytes", "rest", "Not read", 'base.SPACE, "bytes that could not be read"'),
    Field("padding", "bytes", "padding", "Padding", 'base.SPACE, "the unused rest of a USB report"'),
    Field("fragment", "bytes", "fragment", "Part of a frame", "base.SPACE"),
    Field("fragment_of", "framenum", "fragment_of", "Frame complete in"),
    Field("fragments", "framenum", "fragments", "Began in"),
    Field("response_in", "framenum", "response_in", "Response in", "base.NONE, frametype.RESPONSE"),
    Field("request_in", "framenum", "request_in", "Request in", "base.NONE, frametype.REQUEST"),
    Field("response_time", "relative_time", "response_time", "Response time"),
    Field("transfer_path", "string", "transfer.path", "File"),
    Field("transfer_done", "uint32", "transfer.done", "Transferred", _BYTES),
    Field("transfer_size", "uint32", "transfer.size", "Size", _BYTES),
    Field("beacon_answer", "bytes", "beacon.answer", "Answer to a beacon", "base.SPACE"),
    Field("unlock", "string", "unlock", "Unlock"),
    Field("unlock_serial", "string", "unlock.serial", "Serial number"),
    Field("accept", "string", "accept", "Accept"),
    *(Field(f"beacon_{name}", "string", f"beacon.{name}", label) for name, label in BEACON_LINES.items()),
    *_of_system_messages(),
    # A daisy reply carries a sensor's data part by part.
    *(
        Field(f"daisy_{part.name}", "bytes" if part.name in _PIECES else "uint8", f"daisy.{part.name}", part.name)
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
    Expert("misread", "Value that the brick reads otherwise, or that is not documented", "PROTOCOL", "WARN"),
    Expert("no_boundary", "No frame starts here", "MALFORMED", "ERROR"),
    Expert("error_reply", "The brick refused the command, or it failed", "RESPONSE_CODE", "WARN"),
    Expert("failed", "The command failed", "RESPONSE_CODE", "WARN"),
    Expert("orphan", "The command that this reply answers was not seen", "SEQUENCE", "NOTE"),
    Expert("unanswered", "No reply to this command was seen", "SEQUENCE", "NOTE"),
    Expert("unsure", "The pairing is unsure", "SEQUENCE", "NOTE"),
    Expert("bootloader_fault", "Bootloader fault on USB 3", "PROTOCOL", "ERROR"),
)

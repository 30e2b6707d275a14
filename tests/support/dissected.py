"""Messages as plain records, from two sources: the output of tshark, and ev3proto's reading of the frames.

`packets` reads a capture through pyshark and keeps the EV3 layers of each packet as tshark nests them; `shown` makes a
record from such a layer. `Follower` makes the same record from the bytes alone, by `ev3proto.parse` and a `Dialogue`. A
record names fields as filters do, and all offsets count from the start of the frame.

If both present the same thing differently on purpose, the codec's form is converted:

- Texts are ISO-8859-1 on the brick and UTF-8 in Wireshark. PDML writes control characters as `\\x1f`, except tab and
  line ends, which become spaces in XML attributes. A zero, which can only occur in a listing, is shown as a symbol.
- tshark prints six digits of a single and fifteen of a double: `Float` compares only these digits.
- A variable is shown as `GV(0)`, and a constant whose type is not that of its parameter as a text.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, fields, replace
from functools import cache
from pathlib import Path
from typing import Any, ClassVar, NamedTuple
from unittest import mock

import pyshark.tshark.output_parser.tshark_xml
from pyshark.packet.layers.xml_layer import XmlLayer

import ev3proto
from ev3proto.dialogue import Exchange, Value, reply_values
from ev3proto.generate.dissector.fields import FIELDS, filter_name
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    Operation,
    SensorReport,
    SystemCommand,
    SystemReply,
    Variable,
)
from ev3proto.semantics.domain import domain_of
from ev3proto.tables import operations
from ev3proto.tables.daisy import SENSOR_DATA_SIZE
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter, Type
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, FieldKind
from support.wireshark import Tshark

# Records


class Float(float):
    """A float that equals another if the six printed digits of a single could be those of both."""

    PRECISION: ClassVar = 5.1e-6

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, float):
            return NotImplemented
        if math.isnan(self) or math.isnan(other):
            return math.isnan(self) and math.isnan(other)
        return math.isclose(self, other, rel_tol=self.PRECISION)

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = None  # type: ignore[assignment]


class Double(Float):
    """A float that is compared by the fifteen printed digits of a double."""

    PRECISION: ClassVar = 5.1e-15


Shown = int | str | bytes | Float | None


class Item(NamedTuple):
    """A field with a value, of a system message, a reply or a daisy message. `said` is the line without the name."""

    field: str
    value: Shown
    offset: int
    length: int
    name: str = ""
    said: str | None = None


class ArgumentItem(NamedTuple):
    """An argument of an operation."""

    field: str
    name: str
    value: Shown
    encoding: str
    offset: int
    length: int
    said: str | None = None


class OperationItem(NamedTuple):
    """An operation; `cmd` is the offset, length and, if it has more than one byte, encoding of its CMD."""

    opcode: int
    name: str
    offset: int
    length: int
    cmd: tuple[int, int, str | None] | None
    arguments: tuple[ArgumentItem, ...]


class Answer(NamedTuple):
    """A value of an operation in a reply; a list is an item without value before its elements."""

    name: str
    offset: int
    length: int
    values: tuple[Item, ...]


class Transfer(NamedTuple):
    """The file that a message is about."""

    path: str
    done: int
    size: int | None


@dataclass(frozen=True, slots=True)
class Record:
    """The whole reading of a message.

    packet      the packet in which it is complete
    size        its number of bytes
    fields      those of system and daisy messages, the memory of replies, unread bytes, padding
    complaints  faults, refusals, missing partners; not those of single arguments
    """

    packet: int
    size: int
    type: int
    counter: int
    length: int
    globals: int | None = None
    locals: int | None = None
    operations: tuple[OperationItem, ...] = ()
    fields: tuple[Item, ...] = ()
    answers: tuple[Answer, ...] = ()
    transfer: Transfer | None = None
    request_in: int | None = None
    response_in: int | None = None
    milliseconds: Float | None = None
    complaints: tuple[str, ...] = ()


def difference(shown_record: Record, expected: Record) -> str:
    """Returns the differences line by line; empty if there are none."""
    lines: list[str] = []

    def compare(where: str, one: Any, other: Any) -> None:
        if one == other:
            return
        if isinstance(one, tuple) and isinstance(other, tuple) and len(one) == len(other):
            names = getattr(one, "_fields", range(len(one)))
            for name, left, right in zip(names, one, other, strict=True):
                compare(f"{where}.{name}", left, right)
        else:
            lines.append(f"{where}: tshark shows {one!r}, the codec gives {other!r}")

    for declared in fields(Record):
        compare(declared.name, getattr(shown_record, declared.name), getattr(expected, declared.name))
    return "\n".join(lines)


# The output of tshark


class Tree(NamedTuple):
    """An item of tshark's tree, as in PDML; `bytes` is None if it has none of the packet."""

    name: str
    line: str
    show: str
    bytes: bytes | None
    position: int
    size: int
    children: tuple[Tree, ...]

    def walk(self) -> Iterator[Tree]:
        """Yields this item and all below it."""
        yield self
        for child in self.children:
            yield from child.walk()


class Layer(XmlLayer):  # type: ignore[misc]
    """pyshark's layer, which also keeps the nesting of its fields, and its index in the packet."""

    __slots__ = ("tree",)

    def __init__(self, xml_obj: Any = None, raw_mode: bool = False) -> None:
        super().__init__(xml_obj, raw_mode)
        self.tree = _tree(xml_obj) if xml_obj.get("name") == "ev3" else None


def _tree(element: Any) -> Tree:
    value = element.get("value")
    return Tree(
        element.get("name"),
        element.get("showname", ""),
        element.get("show", ""),
        bytes.fromhex(value) if value and element.get("unmaskedvalue") is None else None,
        int(element.get("pos", 0)),
        int(element.get("size", 0)),
        tuple(_tree(child) for child in element.iterchildren("field")),
    )


def packets(tshark: Tshark, capture: Path, *words: str) -> list[tuple[int, Tree]]:
    """Yields the EV3 layers of a capture, each with the number of its packet."""
    with mock.patch.object(pyshark.tshark.output_parser.tshark_xml, "XmlLayer", Layer):
        found = tshark.packets(capture, "-J", "frame ev3", *words)
    return [(int(packet.number), layer.tree) for packet in found for layer in packet.layers if layer.tree is not None]


def is_message(layer: Tree) -> bool:
    """Returns whether a layer is a message, not one of the texts before them or a part of a frame."""
    return any(child.name == "ev3.msg_len" for child in layer.children[:3])


def shown(packet: int, layer: Tree) -> Record:
    """Returns the record of a message in tshark's output."""
    return _Reading(packet, layer).record()


def unshown(layer: Tree, data: bytes) -> str:
    """Returns the bytes of a frame that no item covers, or an item whose bytes differ from those at its place."""
    left = set(range(layer.size))
    for item in layer.walk():
        start = item.position - layer.position
        if item.bytes is not None and item.bytes != data[start : start + item.size]:
            return f"{item.name} at offset {start} has the bytes {item.bytes.hex(' ')}"
        if item.name.startswith("ev3."):
            # The opcode is the heading of its operation: it spans all of it, but covers one byte.
            left -= set(range(start, start + (1 if item.name == "ev3.op" else item.size)))
    return f"the bytes at {sorted(left)} are not shown" if left else ""


GENERATED = {f"ev3.{field.name}" for field in FIELDS if field.generated}
ABOUT_CONTENTS = ("misaligned", "beyond_memory", "refused", "misread", "incomplete_file")
FAULTS = ("fault", "unknown_opcode", "unknown_cmd", "cut_off", "no_boundary")


class _Reading:
    """The layer of a message being read; what has no place of its own in the record goes to `fields`."""

    def __init__(self, packet: int, layer: Tree) -> None:
        self.layer = layer
        self.values: dict[str, Any] = {"packet": packet, "size": layer.size}
        self.operations: list[OperationItem] = []
        self.fields: list[Item] = []
        self.answers: list[Answer] = []
        self.generated: dict[str, str] = {}
        for child in layer.children:
            self.read(child)

    def record(self) -> Record:
        found = self.generated
        transfer = None
        if "ev3.transfer.path" in found:
            size = found.get("ev3.transfer.size")
            done = int(found["ev3.transfer.done"])
            transfer = Transfer(found["ev3.transfer.path"], done, None if size is None else int(size))
        time = found.get("ev3.response_time")
        links = {name: int(found[f"ev3.{name}"]) for name in ("request_in", "response_in") if f"ev3.{name}" in found}
        complaints = {
            "fault" if kind in FAULTS else "unanswered" if kind == "waiting" else kind
            for item in self.layer.walk()
            if item.name.startswith("ev3.expert.") and (kind := item.name[11:]) not in ABOUT_CONTENTS
        }
        return Record(
            operations=tuple(self.operations),
            fields=tuple(self.fields),
            answers=tuple(self.answers),
            transfer=transfer,
            milliseconds=None if time is None else Float(1000 * float(time)),
            complaints=tuple(sorted(complaints)),
            **self.values,
            **links,
        )

    def read(self, item: Tree) -> None:
        match item.name:
            case "ev3.msg_len" | "ev3.msg_num" | "ev3.cmd_type":
                name = {"ev3.msg_len": "length", "ev3.msg_num": "counter", "ev3.cmd_type": "type"}[item.name]
                self.values[name] = int(item.show, 0)
            case "ev3.vars":
                for child in item.children:
                    self.values[child.name.removeprefix("ev3.")] = int(child.show)
            case "ev3.op":
                self.operations.append(self.operation(item))
            case "ev3.answers":
                values = tuple(self.answer_values(item))
                self.answers.append(Answer(item.show, self.offset(item), item.size, values))
            case "ev3.daisy.payload":
                self.fields.append(self.item(item))
                for child in item.children:
                    self.read(child)
            case name if name in GENERATED:
                self.generated[name] = item.show
            case "_ws.expert":
                pass
            case _:
                self.fields.append(self.item(item))

    def offset(self, item: Tree) -> int:
        return item.position - self.layer.position

    def item(self, item: Tree, with_name: bool = False) -> Item:
        name, said = _said(item) if with_name else ("", None)
        return Item(item.name, _value(item), self.offset(item), item.size, name, said)

    def answer_values(self, group: Tree) -> Iterator[Item]:
        for item in group.children:
            if item.name == "ev3.values":
                yield Item(item.name, None, self.offset(item), item.size, _said(item)[0])
                yield from (self.item(child, True) for child in item.children)
            else:
                yield self.item(item, True)

    def operation(self, heading: Tree) -> OperationItem:
        name, cmd = heading.line.split()[1], None
        arguments: list[ArgumentItem] = []
        for item in heading.children:
            encoding = next((child.show for child in item.children if child.name == "ev3.argument.encoding"), None)
            if item.name == "ev3.cmd":
                name, cmd = item.show, (self.offset(item), item.size, encoding)
            elif item.name != "_ws.expert":
                label, said = _said(item)
                place = self.offset(item), item.size
                arguments.append(ArgumentItem(item.name, label, _value(item), encoding or "none", *place, said))
        return OperationItem(int(heading.show, 0), name, self.offset(heading), heading.size, cmd, tuple(arguments))


def _said(item: Tree) -> tuple[str, str | None]:
    """Returns the firmware's name at the start of a line, and the value after it if that is a whole number."""
    name, _, said = item.line.partition(": ")
    for mark in (" [truncated]", " […]"):
        name = name.removesuffix(mark)
    for label in ("Daisy chain ", "Port ", "Ports "):
        name = name.removeprefix(label)
    return name, said if kinds()[item.name] is int else None


def _value(item: Tree) -> Shown:
    kind = kinds()[item.name]
    if kind is int:
        return int(item.show, 0)
    if issubclass(kind, Float):
        return kind(item.show)
    if kind is bytes:
        return bytes.fromhex(item.show.replace(":", " "))
    return item.show


@cache
def kinds() -> dict[str, type]:
    """The type of each field, from the tables."""
    found: dict[str, type] = {
        "ev3.argument.variable": str,
        "ev3.argument.value": str,
        "ev3.values": str,
        "ev3.sys_cmd": int,
        "ev3.reply_status": int,
        "ev3.memory": bytes,
        "ev3.rest": bytes,
        "ev3.padding": bytes,
        "ev3.daisy.command": int,
        "ev3.daisy.layer_from": int,
        "ev3.daisy.layer_to": int,
        "ev3.daisy.payload": bytes,
    }
    for part in SensorReport._fields:
        found[f"ev3.daisy.{part}"] = bytes if part in ("data", "busy") else int
    for command in SYSTEM:
        for declared in (*command.request, *command.reply):
            _tell(found, f"ev3.{filter_name(command, declared)}", _KINDS[declared.kind])
    for dialect in DIALECTS:
        for declaration in operations(dialect).values():
            for parameter in declaration.parameters:
                name = f"ev3.{declaration.name}.{parameter.name}".lower()
                if parameter.counts:
                    element = parameter.element
                    _tell(found, f"{name}.item", _kind(element) if isinstance(element, Type) else Double)
                _tell(found, name, _kind(parameter.type))
    return found


_KINDS = {FieldKind.U8: int, FieldKind.U16: int, FieldKind.U32: int, FieldKind.DATA: bytes}
_KINDS |= dict.fromkeys((FieldKind.TEXT, FieldKind.COUNTED_TEXT, FieldKind.LISTING), str)


def _kind(declared: Type) -> type:
    return {Type.DATAF: Float, Type.STRING: str}.get(declared, int)


def _tell(found: dict[str, type], name: str, kind: type) -> None:
    assert found.setdefault(name, kind) is kind, f"{name} would be a field of two kinds"


# The output of the codec


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame taken from a capture, or put into one.

    packet         the packet in which it is complete
    milliseconds   its time
    from_host      its direction
    data           its bytes
    padding        the bytes after it in a USB report
    talk           the conversation that it belongs to
    """

    packet: int
    milliseconds: float
    from_host: bool
    data: bytes
    padding: bytes = b""
    talk: str = ""


@dataclass(slots=True)
class Follower:
    """Makes the records of a conversation's frames, in order; tshark reads the capture `passes` times."""

    dialect: str = "official"
    passes: int = 1
    records: list[Record] = field(default_factory=list)
    _dialogues: dict[str, ev3proto.Dialogue] = field(default_factory=dict)
    _asked: dict[int, tuple[int, Frame, Message]] = field(default_factory=dict)

    def follow(self, frames: Iterable[Frame]) -> list[Record]:
        """Returns the records of new frames, which come after all earlier ones."""
        for frame in frames:
            self._follow(frame)
        return self.records

    def _follow(self, frame: Frame) -> None:
        message = ev3proto.parse(frame.data, strict=False, dialect=self.dialect)
        record = Record(
            frame.packet,
            len(frame.data),
            frame.data[4],
            message.counter,
            message.length,
            complaints=("fault",) if message.fault else (),
        )
        if _is_overwritten(message, frame):
            record = replace(record, complaints=("bootloader_fault",))
            exchange = Exchange(message)
        else:
            dialogue = self._dialogues.setdefault(frame.talk, ev3proto.Dialogue())
            exchange = dialogue.follow(message, frame.milliseconds / 1000)
            record = self._linked(record, exchange, frame)
        body = _body(exchange, frame.data)
        if message.rest:
            at = len(frame.data) - len(message.rest)
            body.setdefault("fields", []).append(Item("ev3.rest", message.rest, at, len(message.rest)))
        if frame.padding:
            place = len(frame.data), len(frame.padding)
            body.setdefault("fields", []).append(Item("ev3.padding", frame.padding, *place))
            # The padding is within the message.
            body["size"] = sum(place)
        body = {name: tuple(value) if isinstance(value, list) else value for name, value in body.items()}
        self.records.append(replace(record, **body))

    def _linked(self, record: Record, exchange: Exchange, frame: Frame) -> Record:
        """Returns the message with its relations to others; the record of a command gets its reply."""
        message, complaints = exchange.message, list(record.complaints)
        if isinstance(message, DirectReply) and message.is_error:
            complaints.append("error_reply")
        if isinstance(message, SystemReply) and message.is_error:
            complaints.append("failed")
        if exchange.is_orphan:
            complaints.append("orphan")
        if exchange.note is not None:
            complaints.append("unsure" if "pairing" in exchange.note else "other_size")
        links: dict[str, Any] = {}
        if exchange.request is not None:
            index, asked, _ = self._asked.pop(id(exchange.request))
            links["request_in"] = asked.packet
            links["milliseconds"] = Float(frame.milliseconds - asked.milliseconds)
            if self.passes == 2:
                kept = tuple(it for it in self.records[index].complaints if it != "unanswered")
                self.records[index] = replace(self.records[index], response_in=frame.packet, complaints=kept)
        elif message.wants_reply:
            # Keep the message, so that its identity is not reused.
            self._asked[id(message)] = len(self.records), frame, message
            if self.passes == 2:
                complaints.append("unanswered")
        if exchange.transfer is not None:
            found = exchange.transfer
            links["transfer"] = Transfer(shown_text(found.path), found.transferred, found.size)
        return replace(record, complaints=tuple(sorted(complaints)), **links)


def _is_overwritten(message: Message, frame: Frame) -> bool:
    """Returns whether this is the known fault of the bootloader: a request from the brick."""
    if frame.from_host or not isinstance(message, SystemCommand):
        return False
    entry = SYSTEM_BY_NUMBER.get(message.number)
    return entry is not None and entry.bootloader


def shown_text(text: str) -> str:
    """Returns a text as Wireshark, PDML and an XML parser change it."""
    return "".join(_shown_letter(letter) for letter in text.replace("\r\n", "\n"))


def _shown_letter(letter: str) -> str:
    if letter == "\0":
        return "\N{SYMBOL FOR NULL}"
    if letter in "\t\n\r":
        return " "
    return f"\\x{ord(letter):x}" if letter < " " or letter == "\x7f" else letter


def _body(exchange: Exchange, data: bytes) -> dict[str, Any]:
    message = exchange.message
    match message:
        case DirectCommand() if len(data) >= 7:
            return {
                "globals": message.global_size,
                "locals": message.local_size,
                "operations": [_operation(it) for it in message.operations],
            }
        case DirectReply():
            memory = message.memory
            items = [Item("ev3.memory", memory, 5, len(memory))] if memory else []
            return {"fields": items, "answers": list(_answers(exchange))}
        case SystemCommand() if len(data) >= 6:
            items = [Item("ev3.sys_cmd", message.number, 5, 1)]
            return {"fields": items + list(_system_fields(message, 6))}
        case SystemReply() if len(data) >= 7:
            items = [Item("ev3.sys_cmd", message.number, 5, 1), Item("ev3.reply_status", message.status_code, 6, 1)]
            return {"fields": items + list(_system_fields(message, 7))}
        case DaisyCommand() if len(data) >= 8:
            items = [Item("ev3.daisy.command", message.number, 5, 1), *_daisy_items(message, 6)]
            return {"fields": items, "operations": [_operation(it) for it in message.operations]}
        case DaisyReply() if len(data) >= 7:
            items = list(_daisy_items(message, 5))
            if message.report is not None:
                items += _report(message.report, 7)
            return {"fields": items}
    return {}


def _operation(operation: Operation) -> OperationItem:
    cmd = operation.cmd
    place = None if cmd is None else (cmd.offset, cmd.length, _encoding(cmd) if cmd.length > 1 else None)
    arguments = tuple(_argument(operation, argument) for argument in operation.arguments)
    return OperationItem(operation.opcode, operation.full_name, operation.offset, operation.length, place, arguments)


def _encoding(argument: Argument) -> str:
    form = argument.form
    return form.name + " HND" * form.handle + " ADR" * form.address


def _argument(operation: Operation, argument: Argument) -> ArgumentItem:
    if argument.is_variable:
        value: Shown = str(Variable(argument.kind, int(argument.value)))
        name, said = "ev3.argument.variable", None
    else:
        name, value, said = _typed(operation, argument, argument.value)
    return ArgumentItem(name, argument.name, value, _encoding(argument), argument.offset, argument.length, said)


def _declared(operation: Operation, name: str) -> Parameter:
    """Returns a parameter of the tables; `VALUES[0]` is one of `VALUES`."""
    plain = name.partition("[")[0]
    return next(it for it in operation.declaration.parameters if it.name == plain)


def _is_natural(declared: Parameter) -> bool:
    """Returns whether the tables allow no negative number for an input: its field is unsigned."""
    domain = domain_of(declared)
    if declared.direction is not Direction.IN or domain is None or not domain.spans:
        return False
    return min(domain.spans)[0] >= 0 and all(number >= 0 for number in declared.special)


def _typed(operation: Operation, argument: Argument, value: int | float | str) -> tuple[str, Shown, str | None]:
    """The field of a parameter, its value, and its line: for constants, and for values in a reply."""
    declared = _declared(operation, argument.name)
    is_element = "[" in argument.name
    name = f"ev3.{operation.full_name}.{declared.name}".lower()
    if is_element and declared.counts:
        name += ".item"
    kind = kinds()[name]
    if isinstance(value, str) != (kind is str):
        return "ev3.argument.value", shown_text(str(value)), None
    if isinstance(value, str):
        return name, shown_text(value), None
    if issubclass(kind, Float):
        return name, kind(value), None
    assert isinstance(value, int)
    if value < 0 and not is_element and _is_natural(declared):
        return "ev3.argument.value", str(value), None
    return name, value, str(value) if is_element else _line(declared, value)


def _line(parameter: Parameter, value: int, in_list: bool = False) -> str:
    """Wireshark's text for a whole number: its name, or its unit (only once in a list), and its meaning."""
    enum, line = parameter.enum, str(value)
    if enum is not None and not enum.flags:
        name = enum.name_of(value) or ("" if in_list else "Unknown")
        line = f"{name} ({value})" if name else line
    elif parameter.unit and not in_list:
        line = f"{value} {parameter.unit}"
    meaning = parameter.special.get(value) if parameter.special else None
    if enum is not None and enum.flags and 0 < value <= 0xFF:
        names = {number: name for name, number in reversed(list(enum.members.items()))}
        bits = (1 << bit for bit in range(8) if value >> bit & 1)
        meaning = "|".join(names.get(bit, f"0x{bit:02X}") for bit in bits)
    return f"{line} ({meaning})" if meaning else line


def _answers(exchange: Exchange) -> Iterator[Answer]:
    """Yields the values of the dialogue, operation by operation."""
    message, request = exchange.message, exchange.request
    if not exchange.values:
        return
    assert isinstance(message, DirectReply)
    assert isinstance(request, DirectCommand)
    left = list(exchange.values)
    for operation in request.operations:
        values = list(reply_values(replace(request, operations=(operation,)), message))
        if not values:
            continue
        assert repr(left[: len(values)]) == repr(values)  # "not a number" does not equal itself
        del left[: len(values)]
        start = min(value.offset for value in values)
        length = max(value.offset + value.length for value in values) - start
        items = tuple(item for value in values for item in _answer(operation, value))
        yield Answer(operation.full_name, start, length, items)
    assert not left


def _answer(operation: Operation, value: Value) -> Iterator[Item]:
    argument = next(it for it in operation.arguments if it.name == value.name)
    if not isinstance(value.value, list):
        assert not isinstance(value.value, bytes)
        name, shown_value, said = _typed(operation, argument, value.value)
        if argument.form.handle and name != "ev3.argument.value":
            said = f"handle {value.value}" if kinds()[name] is int else None
        elif value.quantity is not None and said is not None:
            said = " ".join(filter(None, [said, value.unit, f"({value.quantity})"]))
        yield Item(name, shown_value, value.offset, value.length, value.name, said)
        return
    yield Item("ev3.values", None, value.offset, value.length, value.name)
    step = value.length // len(value.value)
    for index, number in enumerate(value.value):
        name, shown_value, said = _typed(operation, argument, number)
        if said is not None:
            said = _line(_declared(operation, argument.name), int(number), in_list=True)
        yield Item(name, shown_value, value.offset + index * step, step, f"{value.name}[{index}]", said)


def _system_fields(message: SystemCommand | SystemReply, at: int) -> Iterator[Item]:
    entry = SYSTEM_BY_NUMBER.get(message.number)
    if entry is None:
        return
    for declared in entry.request if isinstance(message, SystemCommand) else entry.reply:
        if declared.name in message.fields:
            value = message.fields[declared.name]
            length = _size(declared.kind, value)
            shown_value = shown_text(value) if isinstance(value, str) else value
            yield Item(f"ev3.{filter_name(entry, declared)}", shown_value, at, length)
            at += length


def _size(kind: FieldKind, value: FieldValue) -> int:
    if isinstance(value, int):
        return {FieldKind.U8: 1, FieldKind.U16: 2, FieldKind.U32: 4}[kind]
    return len(value) + (kind in (FieldKind.TEXT, FieldKind.COUNTED_TEXT))


def _daisy_items(message: DaisyCommand | DaisyReply, at: int) -> Iterator[Item]:
    yield Item("ev3.daisy.layer_from", message.layer_from, at, 1)
    yield Item("ev3.daisy.layer_to", message.layer_to, at + 1, 1)
    if message.payload:
        yield Item("ev3.daisy.payload", message.payload, at + 2, len(message.payload))


def _report(report: SensorReport, at: int) -> Iterator[Item]:
    for name, value in report._asdict().items():
        length = len(value) if isinstance(value, bytes) else 1
        assert name != "data" or length == SENSOR_DATA_SIZE
        if length:
            yield Item(f"ev3.daisy.{name}", value, at, length)
        at += length

"""A packet for every operation of the tables, and which of them byte code starts with."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any, NamedTuple

from scapy.config import conf
from scapy.fields import Field, PacketListField, XByteEnumField
from scapy.packet import Packet

from ev3proto.compose import command
from ev3proto.errors import BuildError, DecodeError
from ev3proto.messages import Operation
from ev3proto.scapy.arguments import ArgumentField, ArgumentsField, CountField, default_of
from ev3proto.schema.argument import ArgumentSchema
from ev3proto.schema.instructions import CMD, instruction_set
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import DIALECTS, Declaration, Type, declarations
from ev3proto.tables.encoding import CONSTANT
from ev3proto.tables.frame import MAX_FRAME

COUNT = "_COUNT"
"""What is put after the name of a list, for the field that tells how many there are."""

conf.contribs.setdefault("ev3", {"dialect": DIALECTS[0]})


class EV3Operation(Packet):
    """What all operations have: nothing follows one but the next one."""

    name = "EV3 operation"

    def __init__(self, *arguments: Any, **fields: Any) -> None:
        try:
            super().__init__(*arguments, **fields)
        except AttributeError as error:
            # scapy says no more than the name.
            names = [field.name for field in self.fields_desc]
            if not any(name not in names for name in fields):
                raise
            parameters = ", ".join(names[1:]) or "none"
            raise AttributeError(f"{self.name} has no parameter {error}: it has {parameters}") from None

    def extract_padding(self, s: bytes) -> tuple[bytes, bytes]:
        """Everything after an operation is the next one's."""
        return b"", s


@cache
def _declarations() -> dict[str, Declaration]:
    """The operations that any firmware has, by their layers' names."""
    return {entry.name.replace(".", "_"): entry for entry in declarations(OPCODES) if entry.dialects}


def operation_names() -> dict[str, Declaration]:
    """Every operation by the name of its layer: `SOUND_TONE`."""
    return _declarations()


@cache
def operation_layer(declaration: Declaration) -> type[EV3Operation]:
    """The layer of an operation, made once."""
    opcode, command = declaration.opcode, declaration.command
    fields: list[Field[Any, Any]] = [XByteEnumField("opcode", opcode.number, {opcode.number: opcode.name})]
    if command is not None:
        fields.append(ArgumentField(CMD, command.number, {command.number: command.name}))
    for number, parameter in enumerate(declaration.parameters):
        schema = ArgumentSchema(parameter)
        following = declaration.parameters[number + 1 : number + 2]
        if parameter.type is Type.COUNT:
            counter = parameter.name + COUNT
            fields += [CountField(schema, counter, parameter.name), ArgumentsField(parameter, counter)]
        elif parameter.type is Type.VALUES:
            fields.append(ArgumentsField(parameter, fields[-1].name))
        elif following and following[0].type is Type.VALUES:
            fields.append(CountField(schema, parameter.name, following[0].name))
        else:
            fields.append(ArgumentField(schema, default_of(parameter)))
    described = {"name": declaration.name, "fields_desc": fields, "__doc__": declaration.text}
    make: Any = type(EV3Operation)
    name = declaration.name.replace(".", "_")
    layer: type[EV3Operation] = make(name, (EV3Operation,), {**described, "__module__": __package__})
    return layer


class OperationsField(PacketListField):
    """Operations one after the other. Those that `ev3proto.operation` makes will do, too."""

    def __init__(self, name: str) -> None:
        super().__init__(name, [], next_cls_cb=next_operation, max_count=MAX_FRAME)

    def any2i(self, pkt: Packet | None, x: Any) -> list[Any]:
        """A list of packets, also of a single one."""
        given = x if isinstance(x, list) else [x]
        packets = [operation_layer(one.declaration)(one.raw) if isinstance(one, Operation) else one for one in given]
        found: list[Any] = super().any2i(pkt, packets)
        return found


def next_operation(pkt: Packet, before: Any, last: Any, remain: bytes) -> type[EV3Operation] | None:  # noqa: ARG001
    """The layer of the operation that bytes start with, None where the dialect has none such. For PacketListField."""
    if not remain:
        return None
    instructions = instruction_set(conf.contribs["ev3"]["dialect"])
    schema = instructions.opcodes[remain[0]]
    family = instructions.families[remain[0]]
    if family is not None:
        try:
            cmd, _ = CMD.read(remain, 1)
        except DecodeError:
            return None
        schema = family.commands.get(int(cmd.value)) if cmd.kind == CONSTANT else None
    return None if schema is None else operation_layer(schema.declaration)


def in_a_row(packet: Packet) -> list[Packet]:
    """An operation and those that were put after it with `/`, each by itself."""
    found: list[Packet] = []
    while isinstance(packet, EV3Operation):
        single = packet.copy()
        single.remove_payload()
        found.append(single)
        packet = packet.payload
    return found


class MemorySizes(NamedTuple):
    """What operations use of a command's memory, in bytes, and whether they write to what the reply carries."""

    local_size: int
    global_size: int
    wants_reply: bool


def memory_of(packets: Iterable[Packet]) -> MemorySizes:
    """The memory that operations use; none where they cannot be read as they are."""
    data = b"".join(bytes(packet) for packet in packets)
    operations, fault = instruction_set(conf.contribs["ev3"]["dialect"]).scan(data, 0, len(data))
    try:
        made = command(*(operations if fault is None else ()))
    except BuildError:
        return MemorySizes(0, 0, False)
    return MemorySizes(made.local_size, made.global_size, made.wants_reply)

"""System commands and their replies to bytes: `LIST_FILES(max_bytes=1000, path="/home")`."""

from __future__ import annotations

from ev3proto.errors import BuildError
from ev3proto.messages import FieldValue
from ev3proto.schema.fields import NUMBERS, REPLIES, REQUESTS, Fields
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.system import SYSTEM, Field, Kind, SystemCommand, SystemStatus
from ev3proto.text.assembly.errors import SourceError
from ev3proto.text.assembly.names import suggestion
from ev3proto.text.assembly.notations import STATUS, command_name
from ev3proto.text.assembly.syntax import Call, Name, Raw, WrittenArgument
from ev3proto.text.assembly.values import Encoder

_LOGIC = {"true": True, "false": False}

_BY_NAME = {entry.name: entry for entry in reversed(SYSTEM)} | {command_name(entry): entry for entry in SYSTEM}


def find_command(name: str) -> SystemCommand | None:
    """The system command of that name; the firmware's where the bootloader has one too."""
    return _BY_NAME.get(name)


def system_body(call: Call, encoder: Encoder, *, is_reply: bool, may_fail: bool) -> bytes:
    """The bytes after the message type. Raises SourceError.

    Args:
        call: The command as it was written.
        encoder: What makes bytes of its values.
        is_reply: Whether it is a reply.
        may_fail: Fields may be missing: the reply says that the command failed.
    """
    entry = find_command(call.name)
    if entry is None:
        hint = suggestion(call.name, _BY_NAME)
        raise SourceError(call.at, f"unknown system command {call.name}{hint}")
    arguments = list(call.arguments)
    head = bytes((entry.number,))
    if is_reply:
        status = _status(arguments, encoder)
        head += bytes((status,))
        may_fail |= status != SystemStatus.SUCCESS
    schema = (REPLIES if is_reply else REQUESTS)[entry.number]
    values = _values(entry.name, schema, arguments, encoder)
    try:
        completed = schema.completed(values)
        for field in schema.fields:
            if field.name not in completed and not (field.optional or may_fail) and call.is_complete:
                raise SourceError(call.end, f"{entry.name} needs {field.name} too: {field.text}")
        return head + schema.write_present(completed)
    except BuildError as error:
        raise SourceError(call.at, str(error)) from None


def _status(arguments: list[WrittenArgument], encoder: Encoder) -> int:
    """The status of a reply, which is taken out of its arguments."""
    for index, argument in enumerate(arguments):
        if argument.name is not None and argument.name.text == STATUS:
            value = arguments.pop(index).value
            if isinstance(value, Name):
                members = {member.name: int(member) for member in SystemStatus}
                if value.text not in members:
                    hint = suggestion(value.text, members) or f": it is one of {', '.join(members)}, or a number"
                    raise SourceError(value.at, f"unknown status {value.text}{hint}")
                return members[value.text]
            return encoder.whole(value, STATUS, 0, 0xFF)
    return SystemStatus.SUCCESS


def _values(
    name: str, schema: Fields, arguments: list[WrittenArgument], encoder: Encoder
) -> dict[str, FieldValue | float]:
    """The fields by name. Values without names are those of the fields in order, lengths omitted."""
    in_order = iter([field for field in schema.fields if field.counts is None])
    values: dict[str, FieldValue | float] = {}
    for argument in arguments:
        if argument.name is None:
            field = next(in_order, None)
            if field is None:
                raise SourceError(argument.at, f"{name} takes no further value: it has {_names(schema)}")
        else:
            field = schema.by_name.get(argument.name.text)
            if field is None:
                hint = suggestion(argument.name.text, schema.by_name) or f": it has {_names(schema)}"
                raise SourceError(argument.name.at, f"{name} has no field {argument.name.text}{hint}")
        if field.name in values:
            raise SourceError(argument.at, f"{field.name} is given already")
        values[field.name] = _value(field, argument, encoder)
    return values


def _value(field: Field, argument: WrittenArgument, encoder: Encoder) -> FieldValue | float:
    value = argument.value
    if field.kind in NUMBERS:
        return encoder.whole(value, field.name, 0, (1 << 8 * NUMBERS[field.kind].sizeof()) - 1)
    if isinstance(value, Raw):
        return value.data if field.kind is Kind.DATA else value.data.decode(STRING_CODING)
    if field.is_message and isinstance(value, Name) and value.text.lower() in _LOGIC:
        return _LOGIC[value.text.lower()]
    found = encoder.meaning(value)
    if field.is_message:
        if isinstance(found, str | int | float):
            return found
        raise SourceError(value.at, f"{field.name} takes a text, a number, true, false or bytes(01 FF), not {found!r}")
    if not isinstance(found, str):
        expected = "a text or bytes(01 FF)" if field.kind is Kind.DATA else "a text"
        raise SourceError(value.at, f"{field.name} takes {expected}, not {found!r}")
    if field.kind is not Kind.DATA:
        return found
    try:
        return found.encode(STRING_CODING)
    except UnicodeEncodeError as error:
        raise SourceError(
            value.at,
            f"{field.name} cannot be {found!r}: the brick's texts are ISO-8859-1, which has no {found[error.start]!r}",
        ) from None


def _names(schema: Fields) -> str:
    return ", ".join(schema.by_name) or "no fields"

"""The fields of a system message, read and written one by one through their declaration in Construct."""

from __future__ import annotations

import io
from collections.abc import Mapping
from functools import cached_property
from typing import Any

from construct import Construct
from construct.core import ConstructError

from ev3proto.errors import BuildError, DecodeError, counted, near_misses
from ev3proto.messages import FieldValue
from ev3proto.schema.argument import text_bytes
from ev3proto.schema.reasons import REASONS, unreadable
from ev3proto.schema.wire_format import NUMBERS, fields_of
from ev3proto.tables.mailboxes import message_of
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration, SystemField


def _text(value: Any, name: str, zeros: bool = False) -> bytes:
    if not isinstance(value, str):
        raise BuildError(f"{name} takes a text, not {value!r}")
    return text_bytes(value, name, zeros=zeros)


class Fields:
    """Reads and writes a system message's fields, one after the other to the end of the frame."""

    def __init__(self, fields: tuple[SystemField, ...]) -> None:
        self.fields = fields
        self.by_name = {field.name: field for field in fields}
        self._counters = {field.counts: field.name for field in fields if field.counts is not None}

    @cached_property
    def _declared(self) -> dict[str, Construct]:
        return {node.name: node for node in fields_of(self.fields).subcons if node.name}

    def read_leniently(
        self, data: bytes, at: int, *, complete: bool
    ) -> tuple[dict[str, FieldValue], int, DecodeError | None]:
        """Reads the fields up to the first faulty one.

        Args:
            data: The bytes that contain the fields.
            at: The offset of the first field.
            complete: False if the frame may end before any field, as in replies to failed commands.

        Returns:
            The values by field name, the offset after them, and what is wrong with the next field.
        """
        values: dict[str, FieldValue] = {}
        stream = io.BytesIO(data)
        stream.seek(at)
        for field in self.fields:
            if at == len(data) and (field.optional or not complete):
                break
            try:
                values[field.name] = self._declared[field.name].parse_stream(stream, **values)
            except ConstructError:
                return values, at, self._fault(field, values, data, at)
            at = stream.tell()
        if at < len(data):
            return values, at, unreadable(at, "left_over", bytes=counted(len(data) - at, "byte"))
        return values, at, None

    def _fault(self, field: SystemField, before: Mapping[str, FieldValue], data: bytes, at: int) -> DecodeError:
        """Returns why a field cannot be read."""
        counter = self._counters.get(field.name)
        if counter is None:
            key = "endless_text" if field.kind is FieldKind.TEXT else "no_field"
            return unreadable(at, key, True, name=field.name, kind=field.kind.value)
        length, left = before[counter], len(data) - at
        assert isinstance(length, int)
        if field.kind is FieldKind.DATA:
            return unreadable(at, "wrong_count", counter=counter, stated=length, size=left)
        if left <= length:
            return unreadable(at, "cut_text" if left < length else "no_zero", True, length=length)
        return unreadable(at + length, "other_zero", length=length, byte=data[at + length])

    def write(self, value: Mapping[str, Any]) -> bytes:
        """Writes fields.

        Args:
            value: Values by field name. Omitted lengths are computed.

        Returns:
            The bytes of all fields.

        Raises:
            BuildError: A field is missing, unknown or cannot have its value.
        """
        completed = self.completed(value)
        for field in self.fields:
            if field.name not in completed and not field.optional:
                raise BuildError(f"{field.name} is missing: {field.text}")
            if field.most is not None and field.name in completed:
                size = len(self._piece(field, completed[field.name], completed))
                if size > field.most:
                    raise BuildError(f"{field.name} would have {size} bytes; the firmware takes at most {field.most}")
        return self.write_present(completed)

    def write_present(self, value: Mapping[str, Any]) -> bytes:
        """Writes the given fields, possibly only the first few.

        Args:
            value: Values by field name.

        Returns:
            Their bytes.

        Raises:
            BuildError: A field is unknown or cannot have its value.
        """
        self._refuse_unknown(value)
        return b"".join(self._piece(field, value[field.name], value) for field in self.fields if field.name in value)

    def completed(self, value: Mapping[str, Any]) -> dict[str, Any]:
        """Computes omitted lengths, and the bytes of a mailbox's message.

        Args:
            value: Values by field name.

        Returns:
            The same values with those lengths and bytes, in the order of the frame.

        Raises:
            BuildError: A field is unknown, or its value cannot be counted.
        """
        self._refuse_unknown(value)
        found = {name: _message(name, one) if self.by_name[name].is_message else one for name, one in value.items()}
        for field in self.fields:
            if field.counts is not None and field.counts in value and field.name not in value:
                found[field.name] = self._size(field.counts, found)
        return {field.name: found[field.name] for field in self.fields if field.name in found}

    def _refuse_unknown(self, value: Mapping[str, Any]) -> None:
        for name in value:
            if name not in self.by_name:
                raise BuildError(f"unknown field {name}: the fields are {', '.join(self.by_name) or 'none'}")

    def _size(self, name: str, value: Mapping[str, Any]) -> int:
        """Returns the size of a counted field in bytes, including a text's zero, as in the firmware."""
        if self.by_name[name].kind is FieldKind.COUNTED_TEXT:
            return len(_text(value[name], name)) + 1
        if not isinstance(value[name], bytes):
            raise BuildError(f"{name} takes bytes, not {value[name]!r}")
        return len(value[name])

    def _piece(self, field: SystemField, value: Any, values: Mapping[str, Any]) -> bytes:
        counter = self._counters.get(field.name)
        if field.kind in NUMBERS:
            high = (1 << 8 * NUMBERS[field.kind].sizeof()) - 1
            if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= high:
                raise BuildError(f"{field.name} cannot be {value!r}: it is a whole number from 0 to {high}")
        elif field.kind is FieldKind.DATA:
            if not isinstance(value, bytes):
                raise BuildError(f"{field.name} takes bytes, not {value!r}")
            if counter is not None and len(value) != values[counter]:
                stated = values[counter]
                raise BuildError(REASONS["wrong_count"].format(counter=counter, stated=stated, size=len(value)))
        else:
            size = len(_text(value, field.name, zeros=field.kind is not FieldKind.TEXT))
            if counter is not None and values[counter] not in (size, size + 1):
                raise BuildError(
                    f"{value!r} has {size} bytes, {size + 1} with its zero, but its length says {values[counter]}"
                )
        built: bytes = self._declared[field.name].build(value, **values)
        return built


def _message(name: str, value: Any) -> bytes:
    """Returns the bytes of a mailbox's message."""
    if isinstance(value, str):
        _text(value, name, zeros=True)
    elif not isinstance(value, bytes | int | float):
        raise BuildError(f"{name} takes a text, a number, True, False or bytes, not {value!r}")
    try:
        return message_of(value)
    except OverflowError:
        raise BuildError(f"{name} cannot be {value!r}: a number in a message is a single (4 bytes)") from None


REQUESTS = {command.number: Fields(command.request) for command in SYSTEM}
REPLIES = {command.number: Fields(command.reply) for command in SYSTEM}
"""The fields of system commands and of the replies to them, by the command's number."""


def system_entry(command: Any) -> SystemDeclaration:
    """Returns a system command of the tables by its name or number. Raises BuildError for an unknown one."""
    if isinstance(command, int):
        if command in SYSTEM_BY_NUMBER:
            return SYSTEM_BY_NUMBER[command]
        raise BuildError(f"unknown system command 0x{command:02X}")
    if not isinstance(command, str):
        raise BuildError(f"the name of a system command is a text, such as LIST_FILES, not {command!r}")
    for entry in SYSTEM:
        if entry.name == command.upper():
            return entry
    hint = near_misses(command, [entry.name for entry in SYSTEM])
    raise BuildError(f"unknown system command {command}{hint}")

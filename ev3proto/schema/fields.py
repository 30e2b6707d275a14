"""The fields of a system message: numbers, texts, lengths with what they count, and the remaining bytes."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any

from construct import Construct, GreedyBytes, Int8ul, Int16ul, Int32ul, NullTerminated, StringEncoded
from construct.core import ConstructError

from ev3proto.errors import BuildError, DecodeError, counted, near_misses
from ev3proto.messages import FieldValue
from ev3proto.schema.argument import text_bytes
from ev3proto.schema.bytewise import Bytewise
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.mailboxes import message_of
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, Field, Kind, SystemCommand

NUMBERS: dict[Kind, Construct] = {Kind.U8: Int8ul, Kind.U16: Int16ul, Kind.U32: Int32ul}

KINDS: dict[Kind, Construct] = {
    **NUMBERS,
    Kind.TEXT: StringEncoded(NullTerminated(GreedyBytes), STRING_CODING),
    Kind.DATA: GreedyBytes,
    Kind.LISTING: StringEncoded(GreedyBytes, STRING_CODING),
}
"""The Construct of each kind of field. A counted text needs its length and has its own node."""


class CountedText(Bytewise):
    """A text after its length. Some senders include its zero in the length, some do not; the zero is always present."""

    def __init__(self, length: int) -> None:
        super().__init__()
        self.length = length

    def read(self, data: bytes, at: int) -> tuple[str, int]:
        """Returns the text at an offset, and the offset after its zero. Raises DecodeError."""
        text = data[at : at + self.length]
        end = at + self.length
        if len(text) < self.length:
            raise DecodeError(at, f"a text of {self.length} bytes runs past the end of the frame", truncated=True)
        if text.endswith(b"\0"):
            return text[:-1].decode(STRING_CODING), end
        if end >= len(data):
            raise DecodeError(at, "the terminating zero of a text is missing", truncated=True)
        if data[end]:
            raise DecodeError(end, f"a text of {self.length} bytes must end with a zero, not with 0x{data[end]:02X}")
        return text.decode(STRING_CODING), end + 1

    def write(self, value: str) -> bytes:
        """Returns the text and its zero. Raises BuildError if it does not have the stated length."""
        text = _text(value, "the text", zeros=True)
        if self.length not in (len(text), len(text) + 1):
            raise BuildError(
                f"{value!r} has {len(text)} bytes, {len(text) + 1} with its zero, but its length says {self.length}"
            )
        return text + b"\0"


def _text(value: Any, name: str, zeros: bool = False) -> bytes:
    if not isinstance(value, str):
        raise BuildError(f"{name} takes a text, not {value!r}")
    return text_bytes(value, name, zeros=zeros)


class Fields(Bytewise):
    """The schema of a system message's fields, one after the other to the end of the frame."""

    def __init__(self, fields: tuple[Field, ...]) -> None:
        super().__init__()
        self.fields = fields
        self.by_name = {field.name: field for field in fields}

    def read(self, data: bytes, at: int) -> tuple[dict[str, FieldValue], int]:
        """Reads all fields, up to the end of the bytes.

        Args:
            data: The bytes that contain the fields.
            at: The offset of the first field.

        Returns:
            The values by field name, and the end.

        Raises:
            DecodeError: A field is faulty, or bytes are left over.
        """
        values, at, fault = self.read_leniently(data, at, complete=True)
        if fault is not None:
            raise fault
        return values, at

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
        for field in self.fields:
            if at == len(data) and (field.optional or not complete):
                break
            try:
                values[field.name], at = self._field(field, values, data, at)
            except DecodeError as fault:
                return values, at, fault
        if at < len(data):
            left = len(data) - at
            return values, at, DecodeError(at, f"{counted(left, 'byte')} left over after the last field")
        return values, at, None

    def _field(self, field: Field, before: Mapping[str, FieldValue], data: bytes, at: int) -> tuple[FieldValue, int]:
        if field.kind is Kind.COUNTED_TEXT:
            return CountedText(self._length_of(field, before)).read(data, at)
        stream = io.BytesIO(data)
        stream.seek(at)
        try:
            value: FieldValue = KINDS[field.kind].parse_stream(stream)
        except ConstructError:
            raise DecodeError(at, _too_short(field), truncated=True) from None
        if field.kind in (Kind.DATA, Kind.LISTING):
            self._check_count(field, before, len(data) - at, at)
        return value, stream.tell()

    def _length_of(self, field: Field, before: Mapping[str, FieldValue]) -> int:
        length = next(before[counter.name] for counter in self.fields if counter.counts == field.name)
        assert isinstance(length, int)
        return length

    def _check_count(self, field: Field, before: Mapping[str, FieldValue], size: int, at: int) -> None:
        counter = next((counter for counter in self.fields if counter.counts == field.name), None)
        if counter is not None and before[counter.name] != size:
            stated = before[counter.name]
            raise DecodeError(at, f"{counter.name} says {stated!r} bytes, but {size} follow to the end of the frame")

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
        if self.by_name[name].kind is Kind.COUNTED_TEXT:
            return len(_text(value[name], name)) + 1
        if not isinstance(value[name], bytes):
            raise BuildError(f"{name} takes bytes, not {value[name]!r}")
        return len(value[name])

    def _piece(self, field: Field, value: Any, values: Mapping[str, Any]) -> bytes:
        if field.kind in NUMBERS:
            high = (1 << 8 * NUMBERS[field.kind].sizeof()) - 1
            if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= high:
                raise BuildError(f"{field.name} cannot be {value!r}: it is a whole number from 0 to {high}")
        elif field.kind is Kind.COUNTED_TEXT:
            counter = next(counter.name for counter in self.fields if counter.counts == field.name)
            return CountedText(values[counter]).write(value)
        elif field.kind is Kind.DATA:
            if not isinstance(value, bytes):
                raise BuildError(f"{field.name} takes bytes, not {value!r}")
        else:
            _text(value, field.name, zeros=field.kind is Kind.LISTING)
        built: bytes = KINDS[field.kind].build(value)
        return built


def _message(name: str, value: Any) -> bytes:
    """Returns the bytes of a mailbox's message. Raises BuildError for a value of another kind."""
    if isinstance(value, str):
        _text(value, name, zeros=True)
    elif not isinstance(value, bytes | int | float):
        raise BuildError(f"{name} takes a text, a number, True, False or bytes, not {value!r}")
    try:
        return message_of(value)
    except OverflowError:
        raise BuildError(f"{name} cannot be {value!r}: a number in a message is a single (4 bytes)") from None


def _too_short(field: Field) -> str:
    if field.kind is Kind.TEXT:
        return f"the text {field.name} runs past the end of the frame: its terminating zero is missing"
    return f"the frame ends before the field {field.name} ({field.kind.value})"


REQUESTS = {command.number: Fields(command.request) for command in SYSTEM}
REPLIES = {command.number: Fields(command.reply) for command in SYSTEM}
"""The fields of system commands and of the replies to them, by the command's number."""


def system_entry(command: Any) -> SystemCommand:
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

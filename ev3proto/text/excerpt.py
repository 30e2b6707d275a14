"""The bytes of a frame as findings show them: the rows they stand in, a line under them, what they say.

One frame may have dozens of findings, so what they share is made once: its hex, its message, its operations as text.
"""

from __future__ import annotations

from bisect import bisect_right

from ev3proto.checking.report import Finding
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Operation
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD
from ev3proto.text.assembly import operation_line
from ev3proto.text.dialogues import command_spans
from ev3proto.text.phrases import argument_meaning, argument_value, spaced_hex
from ev3proto.text.spans import Line, Role, plain_text

ROW = 16
"""Bytes in a row."""

MOST_ROWS = 4
"""Rows of one span that are shown; a longer one is cut in the middle."""

_MOST_OPERATION = 108
_MOST_LABEL = 60
_BYTE = 3
"""Columns of a byte: a blank and two digits."""


class Excerpt:
    """A frame from which spans are shown, and what it says there."""

    def __init__(self, frame: bytes, dialect: str) -> None:
        self._size = len(frame)
        self._hex = f" {spaced_hex(frame)}"
        self._message = message = read_last(frame, dialect)
        self._operations = message.operations if isinstance(message, (DirectCommand, DaisyCommand)) else None
        self._starts = [operation.offset for operation in self._operations or ()]
        self._lines: dict[int, str] = {}
        self._width = 2 + len(str(max(len(frame) - 1, 10)))
        self.margin = " " * self._width

    def show(self, finding: Finding, role: str) -> list[Line]:
        """The rows that a finding's bytes are in, each underlined, and what these say, alone and as a whole."""
        lines: list[Line] = [[(f"{self.margin} |", Role.ASIDE)], *self._rows(finding, role)] if self._size else []
        text = self._decoded(finding)
        if text:
            lines.append([(f"{self.margin} = {text}", Role.ASIDE)])
        return lines

    def _rows(self, finding: Finding, role: str) -> list[Line]:
        lines: list[Line] = []
        size, start = self._size, min(finding.offset, self._size)
        end = start + (finding.length or 1)
        # A span after the last byte is shown where the next byte would stand.
        if end > size:
            end = size if size > start else start + 1
        last = (end - 1) // ROW if end - 1 < size or start % ROW else (start - 1) // ROW
        first = min(start // ROW, last)
        for number in range(first, last + 1):
            if first + MOST_ROWS - 1 <= number < last:
                if number == first + MOST_ROWS - 1:
                    lines.append([("...".rjust(self._width) + " | ...", Role.ASIDE)])
                continue
            lines += self._row(number * ROW, start, end, role, self._label(finding) if number == last else "")
        return lines

    def _row(self, row: int, start: int, end: int, role: str, label: str) -> tuple[Line, Line]:
        """A row of bytes, and the line under a span of it."""
        digits, stop = self._hex, _BYTE * (row + ROW)
        # What is missing after a full row is marked after that row.
        first, after = _BYTE * max(start, row), _BYTE * min(end, row + ROW)
        marks = "^" * (max(after - first, _BYTE) - 1)
        row_line: Line = [
            # The plus keeps who reads frames out of texts from taking the row for one.
            (f"{f'+{row}'.rjust(self._width)} |", Role.ASIDE),
            (digits[_BYTE * row : min(first, stop)], Role.PLAIN),
            (digits[first:after], role),
            (digits[max(after, first) : stop], Role.PLAIN),
        ]
        under: Line = [
            (f"{self.margin} |", Role.ASIDE),
            (" " * (first - _BYTE * row + 1), Role.PLAIN),
            (marks, role),
            (f" {label}" if label else "", Role.PLAIN),
        ]
        return row_line, under

    def _label(self, finding: Finding) -> str:
        """What the bytes of a span say: `VOLUME = 200 %`."""
        span = finding.offset, finding.length
        if not finding.length:
            return ""
        if finding.offset < COMMAND_HEADER_SIZE:
            return self._header(finding.offset)
        operation = self._operation_at(finding.offset)
        if operation is None:
            return ""
        cmd = operation.cmd
        if span == (operation.offset, operation.length):
            return _cut(operation.full_name, _MOST_LABEL)
        if cmd is not None and span == (cmd.offset, cmd.length):
            return _cut(f"CMD = {cmd.value} {operation.command}", _MOST_LABEL)
        said = [_said(one) for one in operation.arguments if one.offset == finding.offset and one.length == span[1]]
        return _cut("".join(said), _MOST_LABEL)

    def _header(self, offset: int) -> str:
        message = self._message
        if self._size < HEADER_SIZE:
            return ""
        if offset < LENGTH_FIELD:
            return f"length = {message.length}, {self._size - LENGTH_FIELD} bytes follow"
        if offset < LENGTH_FIELD + COUNTER_SIZE:
            return f"counter = {message.counter}"
        if offset < HEADER_SIZE:
            return f"type = {'?' if message.type is None else message.type.name}"
        if isinstance(message, DirectCommand) and offset < HEADER_SIZE + MEMORY_SIZE:
            return f"memory: {message.global_size} bytes global, {message.local_size} bytes local"
        return ""

    def _decoded(self, finding: Finding) -> str:
        """What the span belongs to: an operation, or all of the command."""
        message, offset = self._message, finding.offset
        if self._operations is None:
            if message.type is None or offset < HEADER_SIZE:
                return ""
            return _cut(plain_text(command_spans(message)), _MOST_OPERATION)
        operation = self._operation_at(offset)
        if not finding.length and (operation is None or operation.full_name != finding.operation):
            # What is missing at the end of an operation stands where the next one starts.
            operation = self._operation_at(offset - 1)
        if operation is None:
            return ""
        # One operation may have a thousand arguments and dozens of findings.
        line = self._lines.get(operation.offset)
        if line is None:
            line = self._lines[operation.offset] = _cut(operation_line(operation), _MOST_OPERATION)
        return line

    def _operation_at(self, offset: int) -> Operation | None:
        number = bisect_right(self._starts, offset) - 1
        if number < 0:
            return None
        assert self._operations is not None
        operation = self._operations[number]
        # Of an operation that is cut short, what could not be read belongs to it, too.
        is_there = offset < operation.offset + operation.length or not operation.is_complete
        return operation if is_there else None


def _said(argument: Argument) -> str:
    meaning = argument_meaning(argument)
    return f"{argument.name} = {argument_value(argument)}{f' {meaning}' if meaning else ''}"


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else f"{text[: most - 3]}..."

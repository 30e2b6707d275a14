"""The bytes of a frame as findings show them: the rows they stand in, a line under them, what they say.

One frame may have dozens of findings, so what they share is made once: its hex, its message, its operations as text.
"""

from __future__ import annotations

from bisect import bisect_right
from functools import cache

from ev3proto.checking.report import Finding
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Operation, OperationReader
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE
from ev3proto.tables.declaration import Type
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD
from ev3proto.text.assembly import operation_line
from ev3proto.text.dialogues import command_spans
from ev3proto.text.patterns import Around, Pattern
from ev3proto.text.phrases import argument_meaning, around_value, plain, spaced_hex
from ev3proto.text.spans import Line, Role, plain_text

ROW = 16
"""Bytes in a row."""

MOST_ROWS = 4
"""Rows of one span that are shown; a longer one is cut in the middle."""

_MOST_OPERATION = 108
_MOST_LABEL = 60
_BYTE = 3
"""Columns of a byte: a blank and two digits."""

_BEFORE = tuple(" " * (_BYTE * count + 1) for count in range(ROW + 1))
_MARKS = tuple("^" * (_BYTE * count - 1) for count in range(ROW + 1))
"""What stands before a line under some bytes of a row, and the line, by the number of bytes."""


class Excerpt:
    """A frame from which spans are shown, and what it says there."""

    def __init__(self, frame: bytes, dialect: str) -> None:
        self._size = len(frame)
        self._hex = f" {spaced_hex(frame)}"
        self._message = message = read_last(frame, dialect)
        self._has_operations = isinstance(message, (DirectCommand, DaisyCommand))
        self._operations = message.operations if isinstance(message, (DirectCommand, DaisyCommand)) else ()
        self._starts = [operation.offset for operation in self._operations]
        self._lines: dict[int, str] = {}
        self._arguments: dict[int, dict[int, tuple[int, Argument]]] = {}
        width = 2 + len(str(max(len(frame) - 1, 10)))
        self._width = width
        self.margin = " " * width
        self._bar = f"{self.margin} |"
        self._row_texts: dict[int, str] = {}

    def show(self, finding: Finding, role: Role, lines: list[Line]) -> None:
        """Adds the rows that a finding's bytes are in, each underlined, and what these say, alone and as a whole."""
        if self._size:
            lines.append([(self._bar, Role.ASIDE)])
            self._rows(finding, role, lines)
        text = self._decoded(finding, self._operation_at(finding.offset))
        if text:
            lines.append([(f"{self.margin} = ", Role.ASIDE), (_cut(text, _MOST_OPERATION), Role.ASIDE)])

    def show_texts(self, finding: Finding, texts: list[str]) -> None:
        """Adds the same lines as texts."""
        operation = self._operation_at(finding.offset)
        if self._size:
            texts.append(self._bar)
            self._add_row_texts(finding, self._label(finding, operation), texts)
        text = self._decoded(finding, operation)
        if text:
            texts.append(f"{self.margin} = {_cut(text, _MOST_OPERATION)}".rstrip())

    def _span(self, finding: Finding) -> tuple[int, int, int, int]:
        """Where the bytes that are shown start and end, and their first and last row."""
        size, start = self._size, finding.offset
        if start > size:
            start = size
        end = start + (finding.length or 1)
        # A span after the last byte is shown where the next byte would stand.
        if end > size:
            end = size if size > start else start + 1
        last_row = (end - 1) // ROW if end - 1 < size or start % ROW else (start - 1) // ROW
        return start, end, min(start // ROW, last_row), last_row

    def _rows(self, finding: Finding, role: Role, lines: list[Line]) -> None:
        start, end, first_row, last_row = self._span(finding)
        label = self._label(finding, self._operation_at(finding.offset))
        for number in _shown_rows(first_row, last_row):
            if number is None:
                lines.append([("...".rjust(self._width) + " |", Role.ASIDE), (" ...", Role.ASIDE)])
            else:
                self._row(number * ROW, start, end, role, label if number == last_row else "", lines)

    def _row(self, row: int, start: int, end: int, role: Role, label: str, lines: list[Line]) -> None:
        """A row of bytes, and the line under a span of it."""
        stop = row + ROW
        first, after = max(start, row), min(max(end, row), stop)
        digits = self._hex
        # The plus keeps who reads frames out of texts from taking the row for one.
        line: Line = [(f"{f'+{row}'.rjust(self._width)} |", Role.ASIDE)]
        if first > row:
            line.append((digits[_BYTE * row : _BYTE * first], Role.PLAIN))
        if after > first:
            line.append((digits[_BYTE * first : _BYTE * after], role))
        if after < stop:
            line.append((digits[_BYTE * after : _BYTE * stop], Role.PLAIN))
        lines.append(line)
        # What is missing after a full row is marked after that row.
        marked = _BYTE * max(min(end, stop) - first, 1) - 1
        under: Line = [(self._bar, Role.ASIDE), (" " * (_BYTE * (first - row) + 1), Role.PLAIN), ("^" * marked, role)]
        if label:
            under.append((f" {label}", Role.PLAIN))
        lines.append(under)

    def _add_row_texts(self, finding: Finding, label: str, texts: list[str]) -> None:
        start, length = finding.offset, finding.length
        row = start - start % ROW
        if not 0 < length <= min(row + ROW, self._size) - start:
            self._add_several_row_texts(finding, label, texts)
            return
        # Nearly all spans are of this kind: some bytes of the frame, all of them in one row.
        texts.append(self._row_texts.get(row) or self._row_text(row))
        texts.append(f"{self._bar}{_BEFORE[start - row]}{_MARKS[length]}{f' {label}' if label else ''}")

    def _add_several_row_texts(self, finding: Finding, label: str, texts: list[str]) -> None:
        start, end, first_row, last_row = self._span(finding)
        for number in _shown_rows(first_row, last_row):
            if number is None:
                texts.append("...".rjust(self._width) + " | ...")
                continue
            row = number * ROW
            first, after = max(start, row), max(min(end, row + ROW), max(start, row) + 1)
            said = f" {label}" if label and number == last_row else ""
            texts.append(self._row_text(row))
            texts.append(f"{self._bar}{_BEFORE[first - row]}{_MARKS[after - first]}{said}")

    def _row_text(self, row: int) -> str:
        text = f"{f'+{row}'.rjust(self._width)} |{self._hex[_BYTE * row : _BYTE * (row + ROW)]}"
        self._row_texts[row] = text
        return text

    def _label(self, finding: Finding, operation: Operation | None) -> str:
        """What the bytes of a span say: `VOLUME = 200 %`."""
        if not finding.length:
            return ""
        if finding.offset < COMMAND_HEADER_SIZE:
            text = self._header(finding)
        else:
            text = "" if operation is None else self._argument(finding, operation)
        return text if len(text) <= _MOST_LABEL else _cut(text, _MOST_LABEL)

    def _header(self, finding: Finding) -> str:
        message, offset = self._message, finding.offset
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

    def _argument(self, finding: Finding, operation: Operation) -> str:
        offset, length = finding.offset, finding.length
        if offset == operation.offset:
            return operation.full_name if length == operation.length else ""
        arguments = self._arguments.get(operation.offset)
        if arguments is None:
            arguments = {argument[3]: (number, argument) for number, argument in enumerate(operation.arguments)}
            self._arguments[operation.offset] = arguments
        found = arguments.get(offset)
        if found is not None:
            number, argument = found
            return _said(operation, number, argument) if length == argument.length else ""
        cmd = operation.cmd
        if cmd is not None and (offset, length) == (cmd.offset, cmd.length):
            return f"CMD = {cmd.value} {operation.command}"
        return ""

    def _decoded(self, finding: Finding, operation: Operation | None) -> str:
        """What the span belongs to: an operation, or all of the command.

        operation  the one at the offset of the finding
        """
        message, offset = self._message, finding.offset
        if self._has_operations:
            if not finding.length and (operation is None or operation.full_name != finding.operation):
                # What is missing at the end of an operation stands where the next one starts.
                operation = self._operation_at(offset - 1)
            return "" if operation is None else self._line(operation)
        return "" if message.type is None or offset < HEADER_SIZE else plain_text(command_spans(message))

    def _line(self, operation: Operation) -> str:
        """An operation as assembly, made once."""
        line = self._lines.get(operation.offset)
        if line is None:
            line = self._lines[operation.offset] = operation_line(operation)
        return line

    def _operation_at(self, offset: int) -> Operation | None:
        number = bisect_right(self._starts, offset) - 1
        if number < 0:
            return None
        operation = self._operations[number]
        # Of an operation that is cut short, what could not be read belongs to it, too.
        is_there = offset < operation.offset + operation.length or not operation.is_complete
        return operation if is_there else None


def _shown_rows(first: int, last: int) -> list[int | None]:
    """The numbers of the rows of a span that are shown; None stands for those that are not."""
    numbers: list[int | None] = list(range(first, last + 1))
    if len(numbers) > MOST_ROWS:
        numbers[MOST_ROWS - 1 : -1] = [None]
    return numbers


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else f"{text[: most - 3]}..."


def _said(operation: Operation, number: int, argument: Argument) -> str:
    """`VOLUME = 200 %`, of an argument by its number."""
    patterns = _patterns(operation[0])
    _, form, value, _, _ = argument
    if number >= len(patterns) or type(value) is not int:
        before, after = _split(argument)
        return f"{before}{plain(value)}{after}"
    pattern = patterns[number]
    named = pattern.named
    before, after = pattern.get((id(form), value) if named is None or value in named else id(form)) or pattern.around(
        argument
    )
    return f"{before}{value}{after}"


@cache
def _patterns(schema: OperationReader) -> tuple[Pattern, ...]:
    """How the arguments before the elements of a list are said."""
    parameters = schema.declaration.parameters
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return tuple(Pattern(parameter, _split) for parameter in fixed)


def _split(argument: Argument) -> Around:
    before, after = around_value(argument.form)
    meaning = argument_meaning(argument)
    return f"{argument.name} = {before}", f"{after}{f' {meaning}' if meaning else ''}"

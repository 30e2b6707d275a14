"""The bytes of a frame as findings show them: the rows they stand in, a line under them, what they say.

One frame may have dozens of findings, so what they share is made once: its hex, its message, its operations as text.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from functools import cache

from ev3proto.checking.report import Finding
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Operation, OperationReader
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE
from ev3proto.tables.declaration import Parameter, Type
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

_NOWHERE = 1 << 32
"""An offset, and a number of an argument, that no frame has."""


class Excerpt:
    """A frame from which spans are shown, and what it says there."""

    def __init__(self, frame: bytes, dialect: str) -> None:
        self._size = len(frame)
        self._hex = f" {spaced_hex(frame)}"
        self._message = message = read_last(frame, dialect)
        self._has_operations = isinstance(message, (DirectCommand, DaisyCommand))
        self._operations = message.operations if isinstance(message, (DirectCommand, DaisyCommand)) else ()
        self._starts = [operation.offset for operation in self._operations]
        # The operation that is shown, and what is said of it.
        self._start = self._end = 0
        self._operation: Operation | None = None
        self._line = self._line_text = ""
        self._arguments: tuple[Argument, ...] = ()
        self._numbers: dict[int, int] = {}
        self._labels: tuple[_Label, ...] = ()
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
        text = self._decoded(finding)
        if text:
            lines.append([(f"{self.margin} = ", Role.ASIDE), (text, Role.ASIDE)])

    def texts(self, finding: Finding) -> Sequence[str]:
        """The same lines as texts."""
        start, length = finding.offset, finding.length
        row = start % ROW
        if not 0 < length <= ROW - row or start + length > self._size or not self._has_operations:
            return self._unusual_texts(finding)
        # Nearly all spans are of this kind: some bytes of a direct command, all of them in one row.
        bar, line = self._bar, ""
        if start < COMMAND_HEADER_SIZE:
            label = self._header(finding)
        else:
            if not self._start <= start < self._end:
                self._turn_to(start)
            line = self._line_text
            number = self._numbers.get(start, _NOWHERE)
            if number < len(self._labels):
                label = self._labels[number].text(self._arguments[number], length)
            else:
                label = self._said(start, length)
        digits = self._row_texts.get(start - row) or self._row_text(start - row)
        under = f"{bar}{_BEFORE[row]}{_MARKS[length]} {label}" if label else f"{bar}{_BEFORE[row]}{_MARKS[length]}"
        return (bar, digits, under, line) if line else (bar, digits, under)

    def _unusual_texts(self, finding: Finding) -> list[str]:
        texts: list[str] = []
        if self._size:
            texts.append(self._bar)
            self._add_row_texts(finding, texts)
        decoded = self._decoded(finding)
        if decoded:
            texts.append(f"{self.margin} = {decoded}".rstrip())
        return texts

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
        label = self._label(finding)
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

    def _add_row_texts(self, finding: Finding, texts: list[str]) -> None:
        label = self._label(finding)
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

    def _label(self, finding: Finding) -> str:
        """What the bytes of a span say: `VOLUME = 200 %`."""
        start, length = finding.offset, finding.length
        if not length:
            return ""
        if start < COMMAND_HEADER_SIZE:
            return self._header(finding)
        self._turn_to(start)
        return self._said(start, length)

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

    def _said(self, start: int, length: int) -> str:
        """What some bytes of an operation say: an argument, CMD, or all of it."""
        number, operation = self._numbers.get(start), self._operation
        if operation is None:
            return ""
        if number is not None:
            argument = self._arguments[number]
            if number < len(self._labels):
                return self._labels[number].text(argument, length)
            return _cut(_text(argument), _MOST_LABEL) if length == argument.length else ""
        if start == operation.offset:
            return _cut(operation.full_name, _MOST_LABEL) if length == operation.length else ""
        cmd = operation.cmd
        if cmd is not None and (start, length) == (cmd.offset, cmd.length):
            return _cut(f"CMD = {cmd.value} {operation.command}", _MOST_LABEL)
        return ""

    def _decoded(self, finding: Finding) -> str:
        """What the span belongs to: an operation, or all of the command."""
        message, offset = self._message, finding.offset
        if self._has_operations:
            self._turn_to(offset)
            operation = self._operation
            if not finding.length and (operation is None or operation.full_name != finding.operation):
                # What is missing at the end of an operation stands where the next one starts.
                self._turn_to(offset - 1)
            return self._line
        if message.type is None or offset < HEADER_SIZE:
            return ""
        return _cut(plain_text(command_spans(message)), _MOST_OPERATION)

    def _turn_to(self, start: int) -> None:
        """Makes the operation at an offset the one that is shown. Findings are in order, so that each is made once."""
        if self._start <= start < self._end:
            return
        operation = self._operation = self._operation_at(start)
        if operation is None:
            self._start = self._end = 0
            self._line = self._line_text = ""
            self._arguments, self._numbers = (), {}
            return
        self._start = operation.offset
        self._end = operation.offset + operation.length if operation.is_complete else _NOWHERE
        self._line = _cut(operation_line(operation), _MOST_OPERATION)
        self._line_text = f"{self.margin} = {self._line}"
        self._arguments = operation.arguments
        self._numbers = {argument[3]: number for number, argument in enumerate(self._arguments)}
        self._labels = _labels(operation[0])

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


class _Label(Pattern):
    """How an argument is said: `VOLUME = 200 %`."""

    __slots__ = ()

    def __init__(self, parameter: Parameter) -> None:
        super().__init__(parameter, _split)

    def text(self, argument: Argument, length: int) -> str:
        """The text of an argument; none where it has another length."""
        _, form, value, _, _ = argument
        if type(value) is not int:
            return _cut(_text(argument), _MOST_LABEL) if length == argument.length else ""
        width = form.width
        assert width is not None  # only texts have none
        if length != 1 + width:
            return ""
        named = self.named
        before, after = self.get((id(form), value) if named is None or value in named else id(form)) or self.around(
            argument
        )
        return _cut(f"{before}{value}{after}", _MOST_LABEL)


@cache
def _labels(schema: OperationReader) -> tuple[_Label, ...]:
    """How the arguments before the elements of a list are said."""
    parameters = schema.declaration.parameters
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return tuple(map(_Label, fixed))


def _text(argument: Argument) -> str:
    before, after = _split(argument)
    return f"{before}{plain(argument.value)}{after}"


def _split(argument: Argument) -> Around:
    before, after = around_value(argument.form)
    meaning = argument_meaning(argument)
    return f"{argument.name} = {before}", f"{after}{f' {meaning}' if meaning else ''}"

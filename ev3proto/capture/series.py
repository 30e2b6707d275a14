"""Values over time, from the replies of a capture and its messages to mailboxes, a column for each value."""

from __future__ import annotations

import math
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import TypeAlias

from ev3proto.capture.record import Event, Record, utc
from ev3proto.dialogue import Value
from ev3proto.messages import DirectCommand, SystemCommand
from ev3proto.semantics.pairing import UNSURE

LATENCY = "latency"
"""The column of each reply's latency, in seconds."""

MOST_CELLS = 1_000_000
"""Maximum number of rows and their values together: about 160 MiB."""

_CELL = 160
"""Number of characters of texts and names that take the memory of a cell."""

Cell: TypeAlias = float | str
Column: TypeAlias = tuple[str, Value | None, Cell]
"""The name of a column, the value of the reply that it is in, the cell."""


@dataclass(frozen=True, slots=True)
class Row:
    """The values of one reply, or of one message to a mailbox."""

    time_ns: int  # its time, in nanoseconds since 1970-01-01 UTC
    packet: int
    peer: str  # address of the brick, in a text its label if it has one
    cells: dict[str, Cell]  # its values by the names of their columns
    is_timed: bool = True  # its time is known
    file: str | None = None  # the name of its file, if given

    @property
    def time(self) -> str | None:
        """Its time as `2024-01-31T09:12:31.011558Z`; None if unknown."""
        return utc(self.time_ns) if self.is_timed else None


@dataclass(slots=True)
class Series:
    """The values of a capture."""

    # the columns in order of appearance, each with its unit, if any
    units: dict[str, str | None] = field(default_factory=dict)
    rows: list[Row] = field(default_factory=list)  # in the order of the capture
    size: int = 0  # number of rows and their values together; long texts count as several
    omitted: int = 0  # number of rows beyond MOST_CELLS, which are not kept
    unsure: int = 0  # number of rows of replies that another command may have asked for
    quantities: dict[str, str] = field(default_factory=dict)  # of columns with readings of devices: what they are

    def extend(self, other: Series) -> None:
        """Appends the rows of another capture, and its additional columns."""
        self.units = {**self.units, **other.units}
        self.quantities |= other.quantities
        self.rows += other.rows
        self.unsure += other.unsure
        self.size += other.size
        self.omitted += other.omitted

    def cells_of(self, columns: Iterable[Column], latency: float | None) -> dict[str, Cell]:
        """Returns the cells of a row to be added, and counts them; new columns are added."""
        cells: dict[str, Cell] = {} if latency is None else {LATENCY: latency}
        for name, value, cell in columns:
            column = sys.intern(name)
            if column not in self.units:
                self.units[column] = None if value is None else value.unit
                if value is not None and value.quantity:
                    self.quantities[column] = value.quantity
                self.size += len(column) // _CELL
            cells[column] = cell
            self.size += len(cell) // _CELL if isinstance(cell, str) else 0
        self.size += 1 + len(cells)
        return cells

    def narrowed(self, most: int) -> Series:
        """Returns the columns with the most values, in their order, and the rows that have some of them.

        With a different request each time, each reply has a column of its own, and a table of all is too large.
        """
        if len(self.units) <= most:
            return self
        counts = Counter(name for row in self.rows for name in row.cells)
        chosen = {name for name, _ in counts.most_common(most)}
        units = {name: unit for name, unit in self.units.items() if name in chosen}
        kept = (
            replace(row, cells={name: row.cells[name] for name in row.cells if name in chosen}) for row in self.rows
        )
        return replace(self, units=units, rows=[row for row in kept if row.cells])


def series_of(events: Iterable[Event], file: str | None = None, most: int = MOST_CELLS) -> Series:
    """Returns the values of all replies and of messages to mailboxes, without NaN; `most` limits rows and values."""
    found = Series({LATENCY: "s"})
    for event in events:
        columns = list(_columns(event)) if isinstance(event, Record) else []
        if not isinstance(event, Record) or (event.request is None and not columns):
            continue
        if found.size >= most:
            found.omitted += 1
            continue
        found.unsure += event.note == UNSURE
        cells = found.cells_of(columns, event.latency)
        found.rows.append(
            Row(event.time_ns, event.number, event.label or event.peer, cells, event.route.is_timed, file)
        )
    if not any(LATENCY in row.cells for row in found.rows):
        del found.units[LATENCY]
    return found


def _columns(event: Record) -> Iterator[Column]:
    if event.request is not None:
        for value, name in _named(event):
            for suffix, cell in _cells(value):
                yield name + suffix, value, cell
    elif isinstance(event.message, SystemCommand):
        prefix = f"{event.message.command}({event.message.fields.get('name', '')!s})"
        for kind, reading in event.message.readings.items():
            if isinstance(reading, str):
                yield f"{prefix}.{kind}", None, reading
            elif math.isfinite(reading):
                yield f"{prefix}.{kind}", None, +reading


def _named(reply: Record) -> list[tuple[Value, str]]:
    """Returns the values of a reply with their columns: operation, inputs of the command such as a port, name."""
    request = None if reply.request is None else reply.request.message
    asked: dict[tuple[str, str | None], list[str]] = {}
    if isinstance(request, DirectCommand):
        for operation in request.operations:
            inputs = [str(it.value) for it in operation.arguments if not it.is_variable and it.kind == "constant"]
            asked.setdefault((operation.name, operation.command), []).append(",".join(inputs))
    named = []
    used: dict[tuple[str, str | None, str], int] = {}
    for value in reply.values:
        key = (value.op, value.command, value.name)
        number = used[key] = used.get(key, -1) + 1
        inputs = asked.get(key[:2], [])
        inside = inputs[number] if number < len(inputs) else ""
        arguments = f"({inside})" if inside else ""
        named.append((value, f"{value.full_name}{arguments}.{value.name}"))
    return named


def _cells(value: Value) -> list[tuple[str, Cell]]:
    if value.is_nan or isinstance(value.value, bytes):
        return []
    if isinstance(value.value, list):
        cells: list[tuple[str, Cell]] = [(f"[{number}]", each) for number, each in enumerate(value.value)]
    else:
        cells = [("", value.value)]
    return [(name, cell) for name, cell in cells if isinstance(cell, str) or math.isfinite(cell)]

"""Byte code without a fault as a regular expression, drawn from the schemas of an instruction set.

Many frames are only counted, paired with their replies or cut out of a stream. All that must be known of their byte
code is whether anything is wrong with it. The expression tells that in a fifth of the time in which operations and
their arguments can be made.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable

from ev3proto.schema.argument import SHORT
from ev3proto.schema.identification import ENCODINGS
from ev3proto.schema.operation import OperationSchema
from ev3proto.tables.encoding import CONSTANT

MOST_LISTED = 8
"""Elements of the longest list that the expression knows. Longer ones are rare, and each length is an alternative."""


def byte_code_pattern(schemas: Iterable[OperationSchema]) -> re.Pattern[bytes]:
    """Makes the expression for operations one after the other.

    Args:
        schemas: The operations that there are.

    Returns:
        The expression. It matches as many operations as are without a fault, and stops before the first that it does
        not know. That one may be without a fault all the same: where a CMD or the counter of a list is longer than it
        need be, or a list has more than `MOST_LISTED` elements.

    """
    heads: defaultdict[tuple[bool, int], list[bytes]] = defaultdict(list)
    for schema in schemas:
        heads[schema.list_parameter is not None, len(schema.readers)].append(schema.head)
    # Operations with as many arguments share an alternative, the largest group first: most operations are in it.
    groups = sorted(heads.items(), key=lambda group: len(group[1]), reverse=True)
    plain = [_one_of(starts) + _arguments(count) for (has_list, count), starts in groups if not has_list]
    listing = [_one_of(starts) + _arguments(count - 1) for (has_list, count), starts in groups if has_list]
    operation = b"|".join([*plain, b"(?:%b)%b" % (b"|".join(listing), _LIST)] if listing else plain)
    return re.compile(b"(?:%b)*+" % operation, re.DOTALL)


def _one_of(heads: Iterable[bytes]) -> bytes:
    """Any of these opcodes, and opcodes with their CMD."""
    commands: defaultdict[bytes, set[int]] = defaultdict(set)
    for head in heads:
        commands[head[:-1]].add(head[-1])
    return b"(?:%b)" % b"|".join(re.escape(opcode) + _byte_of(numbers) for opcode, numbers in commands.items())


def _byte_of(values: Iterable[int]) -> bytes:
    """One byte of these values, neighbours written as a range."""
    runs: list[list[int]] = []
    for value in sorted(values):
        if runs and value == runs[-1][1] + 1:
            runs[-1][1] = value
        else:
            runs.append([value, value])
    return b"[%b]" % b"".join(
        re.escape(bytes((first,))) + (b"-" + re.escape(bytes((last,))) if last > first else b"") for first, last in runs
    )


def _argument() -> bytes:
    """Any argument: for each width, the identification bytes and what follows them."""
    widths: defaultdict[int | None, list[int]] = defaultdict(list)
    for byte, encoding in enumerate(ENCODINGS):
        if encoding is not None:
            widths[encoding.width].append(byte)
    return b"(?:%b)" % b"|".join(
        _byte_of(starts) + (rb"[^\0]*+\0" if width is None else b"." * width) for width, starts in widths.items()
    )


_ARGUMENT = _argument()


def _arguments(count: int) -> bytes:
    return b"%b{%d}+" % (_ARGUMENT, count) if count else b""


def _list() -> bytes:
    """A list's counter, a constant of one byte, and its elements."""
    counters = {value: byte for byte, (encoding, value) in enumerate(SHORT) if encoding.kind == CONSTANT}
    lengths = range(MOST_LISTED + 1)
    return b"(?:%b)" % b"|".join(_byte_of((counters[length],)) + _arguments(length) for length in lengths)


_LIST = _list()

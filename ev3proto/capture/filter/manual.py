"""The description of the filter language that `--help-filter` and a page of the reference print.

The names of frames come from `NAMES`, the names of parameters from the tables.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.capture.filter.fields import places_of
from ev3proto.capture.filter.names import NAMES

_WIDTH = 100
_COLUMN = 12


class ManualEntry(NamedTuple):
    """One element of the language."""

    written: str
    text: str
    example: str  # a filter that uses it


COMPARISONS = (
    ManualEntry("NAME", "the frame has it", "FREQUENCY"),
    ManualEntry("==", "some value is equal; also eq", "FREQUENCY == 440"),
    ManualEntry("!=", "the frame has values, and none is equal; also ne", "FREQUENCY != 440"),
    ManualEntry("< <= > >=", "some value is less, ... ; also lt le gt ge", "FREQUENCY >= 440"),
    ManualEntry("contains", "some text or data contains it", 'path contains "prjs"'),
    ManualEntry(
        "like", "some text is like a pattern: * any characters, ? one, [abc] one of these", 'path like "*.rbf"'
    ),
    ManualEntry("matches", "a regular expression is found in some text, in any case", r'path matches r"\.r[bt]f$"'),
    ManualEntry(
        "in { }", "some value is equal to one of these, or in a range; also not in", "FREQUENCY in {262, 400..880}"
    ),
    ManualEntry("!", "it does not hold; also not", "!error"),
    ManualEntry("&&", "both hold; also and", "op == SOUND.TONE && FREQUENCY > 400"),
    ManualEntry("||", "one holds or both do; also or", "error || fault"),
    ManualEntry("( )", "grouping", "op == SOUND.TONE && (VOLUME > 50 || DURATION > 100)"),
)
"""Comparisons of names and values, and joined conditions."""

VALUES = (
    ManualEntry("440, 0x1b8", "a number, also 7.92 and 1e3", "FREQUENCY == 0x1b8"),
    ManualEntry(
        "4ms, 7.9V", "a quantity: ns, us, ms, s and min for times, or the parameter's own unit", "VALUE > 7.9V"
    ),
    ManualEntry("SOUND.TONE", "a name from the tables, in any case", "PATTERN == LED_ORANGE_PULSE"),
    ManualEntry(
        '"text"', "a text; also 'text', and r\"text\" without escapes such as \\n or \\x41", "STRING contains 'world'"
    ),
    ManualEntry("4c:45:47", "bytes", "data contains 3b:30"),
    ManualEntry("192.0.2.10", "an address; also 192.0.2.10:5555 and 00:16:53:00:00:0a", "peer == 192.0.2.10"),
)
"""Notations of values."""

PARAMETERS = (
    ManualEntry("FREQUENCY", "a parameter of any operation, in any case", "frequency > 400"),
    ManualEntry("SOUND.TONE.FREQUENCY", "the parameter of one operation", "SOUND.TONE.FREQUENCY > 400"),
    ManualEntry("VALUES[1]", "one element of a list", "VALUES[0] < 0"),
    ManualEntry("path", "a field of system messages; all messages of a transfer have its path", 'path like "*.rtf"'),
    ManualEntry("TYPE, arg.type", "a parameter that has the name of something above", "TYPE == TYPE_GYRO"),
)
"""Names of parameters and fields."""


def sections() -> dict[str, tuple[ManualEntry, ...]]:
    """Returns all elements by the titles of their sections."""
    names = (ManualEntry(name, known.text, known.example) for name, known in NAMES.items())
    return {
        "Every frame": tuple(names),
        "Parameters and fields": PARAMETERS,
        "Comparisons": COMPARISONS,
        "Values": VALUES,
    }


def _shown(entry: ManualEntry) -> Iterator[str]:
    indent = " " * (_COLUMN + 3)
    start = f"  {entry.written:{_COLUMN}} "
    if len(entry.written) > _COLUMN:
        yield start.rstrip()
        start = indent
    yield from textwrap.wrap(entry.text, _WIDTH, initial_indent=start, subsequent_indent=indent)
    yield f"{indent}{entry.example}"


def manual() -> Iterator[str]:
    """Yields the lines that `--help-filter` prints."""
    yield "A filter selects frames:"
    yield ""
    yield "  ev3proto decode --filter 'op == SOUND.TONE && FREQUENCY > 400' robot.pcapng"
    yield ""
    yield "With --dialogues, it applies to a command together with its reply."
    for title, listed in sections().items():
        yield ""
        yield f"{title}:"
        yield ""
        for entry in listed:
            yield from _shown(entry)
    yield ""
    yield "All parameters and fields, which `ev3proto ops NAME` explains:"
    yield ""
    yield from textwrap.wrap(" ".join(places_of()), _WIDTH, initial_indent="  ", subsequent_indent="  ")

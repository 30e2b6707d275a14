"""What the page offers in place of a wrong input: what was probably meant, each under a button of its own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import islice

from ev3proto.checking.checking import check
from ev3proto.schema.frame import parse
from ev3proto.semantics.identify import Kind, identify
from ev3proto.text.forms import as_hex
from ev3proto.text.paste.frames import NO_LENGTH, OPERATIONS

MOST_LINES = 12
"""Maximum number of lines of a log for which remedies are looked for."""

_LETTERS = str.maketrans("OolI", "0011")
"""Letters that look like digits."""

_BETWEEN = re.compile(r"0[xX]|\\x|[\s,:;|.'\"{}()\[\]-]")
"""What may be between the bytes of a frame in hex."""

_ADD_LENGTH, _ADD_HEADER = "Add the length", "Add a header"
_MISSING = {Kind.NO_LENGTH: _ADD_LENGTH, Kind.OPERATIONS: _ADD_HEADER}
"""The labels of what is added to bytes."""

_LABELS = {"length-missing": _ADD_LENGTH, "digits": "Read the digits"}
"""The labels of slips whose remedy has a better name than "Use this"."""


def with_buttons(advice: str) -> str:
    """Returns advice with buttons of the page in place of options of the command line."""
    return advice.replace(NO_LENGTH, f'"{_ADD_LENGTH}"').replace(OPERATIONS, f'"{_ADD_HEADER}"')


def remedies(text: str, wrong: Mapping[int, bytes | None]) -> list[dict[str, str]]:
    """Returns what can be done about a wrong text, for JSON.

    Args:
        text: One line of hex, or a log.
        wrong: The numbers of wrong lines of a log, from 1, each with the frame in it, if there is one.

    Returns:
        The `label` of each button, the `line` that it makes, and the whole `text` with that line.
    """
    lines = text.strip().split("\n")
    if len(lines) == 1:
        return [{"label": label, "line": line, "text": line} for label, line in _of_line(text.strip(), None)]
    lines, shown = text.split("\n"), []
    for number, frame in islice(sorted(wrong.items()), MOST_LINES):
        for label, line in _of_line(lines[number - 1], frame):
            whole = "\n".join([*lines[: number - 1], line, *lines[number:]])
            shown.append({"label": f"Line {number}: {label}", "line": line, "text": whole})
    return shown


def _of_line(line: str, frame: bytes | None) -> list[tuple[str, str]]:
    """Returns what can be done about a line: labels, and the lines that they make of it."""
    for start in (0, *(each.end() for each in re.finditer(r"\s+", line))):
        text = line[start:]
        if frame not in (None, _bytes_of(text)):
            continue
        if found := {made: label for label, made in reversed(list(_meant(text)))}:
            return [(label, line[:start] + as_hex(parse(made))) for made, label in reversed(found.items())]
    return []


def _meant(text: str) -> Iterator[tuple[str, bytes]]:
    """Yields frames that a brick accepts and that a wrong text may mean, the likeliest first."""
    data = _bytes_of(text)
    if data is None:
        data, label = _bytes_of(text.translate(_LETTERS)), "Read O as 0 and l as 1"
        if data is not None and _is_right(data):
            yield label, data
    if data is None or _is_right(data):
        return
    found = identify(data)
    if found.frame is not None and found.kind in _MISSING and _is_right(found.frame):
        yield _MISSING[found.kind], found.frame
    for each in check(data, alone=True).nearest:
        if not each.unknown and _is_right(each.frame):
            yield _LABELS.get(each.kind, "Use this"), each.frame


def _bytes_of(text: str) -> bytes | None:
    """Returns the bytes of a text that has nothing but one line of hex."""
    digits = _BETWEEN.sub("", text.strip())
    if "\n" in text.strip() or not digits or len(digits) % 2 or not re.fullmatch(r"[0-9A-Fa-f]+", digits):
        return None
    return bytes.fromhex(digits)


def _is_right(frame: bytes) -> bool:
    """Returns whether a brick accepts a frame, without errors."""
    report = check(frame, alone=True)
    return parse(frame, strict=False).fault is None and report.accepted and not report.errors

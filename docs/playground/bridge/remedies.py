"""What the page offers in place of a wrong input: what was probably meant, each under a button of its own."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

from ev3proto.checking.checking import check
from ev3proto.schema.frame import parse
from ev3proto.text.forms import as_hex
from ev3proto.text.paste.frames import NO_LENGTH, OPERATIONS, with_header, without_length

_LETTERS = str.maketrans("OolI", "0011")
"""Letters that look like digits."""

_BETWEEN = re.compile(r"0[xX]|\\x|[\s,:;|.'\"{}()\[\]-]")
"""What may be between the bytes of a frame in hex."""

_ADD_LENGTH, _ADD_HEADER = "Add the length", "Add a header"
_LABELS = {"length-missing": _ADD_LENGTH}
"""The labels of slips whose remedy has a better name than "Use this"."""


def with_buttons(advice: str) -> str:
    """Returns advice with buttons of the page in place of options of the command line."""
    return advice.replace(NO_LENGTH, f'"{_ADD_LENGTH}"').replace(OPERATIONS, f'"{_ADD_HEADER}"')


def remedies(text: str) -> str:
    """Returns what can be done about a wrong line of hex, as JSON: a list of `label` and `text`, which replaces it."""
    found = {frame: label for label, frame in reversed(list(_meant(text)))}
    shown = [{"label": label, "text": as_hex(parse(frame))} for frame, label in reversed(found.items())]
    return json.dumps(shown)


def _meant(text: str) -> Iterator[tuple[str, bytes]]:
    """Yields frames that a brick accepts and that a wrong text may mean, the likeliest first."""
    data = _bytes_of(text)
    if data is None:
        data, label = _bytes_of(text.translate(_LETTERS)), "Read O as 0 and l as 1"
        if data is not None and _is_right(data):
            yield label, data
    if data is None or _is_right(data):
        return
    for label, frame in ((_ADD_LENGTH, without_length(data)), (_ADD_HEADER, with_header(data))):
        if frame is not None and _is_right(frame):
            yield label, frame
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

"""What a run of values may represent: its bytes in each reading, and the frames in them."""

from __future__ import annotations

import binascii
from collections.abc import Callable, Mapping
from typing import NamedTuple

from ev3proto.text.paste.fitting import HASHES, LOOKS, frames_in, is_flawless, is_something
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.values import Run, Style, Value, literal

_MANY_GAPS = 4


class Stretch(NamedTuple):
    """A part of a run that one reading gives bytes for: these, and the value that each of them belongs to."""

    name: str
    data: bytes
    places: list[int]


class Frame(NamedTuple):
    """A frame in a run: its bytes and its padding, its first and its last value, whether it is between boundaries."""

    data: bytes
    padding: bytes
    first: int
    last: int
    is_natural: bool


class Reading(NamedTuple):
    """A reading of a run.

    stretches    its bytes
    frames       the frames in them
    is_whole     they are all of the run, but for padding
    is_complete  every value of the run has bytes in it
    """

    stretches: list[Stretch]
    frames: list[Frame]
    is_whole: bool
    is_complete: bool

    @property
    def worth(self) -> tuple[bool, int, bool, int]:
        """What tells the likelier of two readings: whether its frames are all, their bytes, whether it is complete."""
        natural = sum(len(frame.data) for frame in self.frames if frame.is_natural)
        return self.is_whole, natural, self.is_complete, sum(len(frame.data) for frame in self.frames)

    @property
    def is_flawless(self) -> bool:
        """Whether none of its frames has a flaw."""
        return all(is_flawless(frame.data) for frame in self.frames)


def _sized(text: str, base: int, size: int) -> bytes | None:
    number = int(text, base) if text.isdecimal() and (base == 10 or not {"8", "9"} & {*text}) else 1 << 16
    return number.to_bytes(size, "little") if number < 1 << 8 * size else None


def _number(text: str) -> bytes | None:
    """Returns the byte of an unpadded number, also where the sign of a negative one was spread over 32 bits."""
    number = int(text, 16) if len(text) in (1, 2, 8) else -1
    return bytes((number & 0xFF,)) if 0 <= number < 256 or number >= 0xFFFFFF80 else None


def _bits(text: str) -> bytes | None:
    is_bits = len(text) % 8 == 0 and {*text} <= {"0", "1"}
    return int(text, 2).to_bytes(len(text) // 8, "big") if is_bits else None


def _base64(text: str) -> bytes | None:
    """Returns the bytes of base64, with either alphabet, padded or not."""
    digits = text.rstrip("=").replace("-", "+").replace("_", "/")
    try:
        return binascii.a2b_base64(digits + "=" * (-len(digits) % 4), strict_mode=True)
    except binascii.Error:
        return None


_UNLIKELY = ("octal", "number", "words", "decimal words", "octal words")
"""The readings whose frames must not have a flaw."""
_OF_TEXT: Mapping[str, Callable[[str], bytes | None]] = {
    "hex": lambda text: bytes.fromhex(text.zfill(2)) if len(text) == 1 or len(text) % 2 == 0 else None,
    "decimal": lambda text: _sized(text, 10, 1) if len(text) <= 3 else None,
    "octal": lambda text: _sized(text, 8, 1) if len(text) <= 3 or (len(text) == 4 and text[0] == "0") else None,
    "number": _number,
    "bits": _bits,
    "words": lambda text: bytes.fromhex(text)[::-1] if len(text) in (2, 4, 6, 8) else None,
    "decimal words": lambda text: _sized(text, 10, 2) if len(text) == 5 else None,
    "octal words": lambda text: _sized(text, 8, 2) if len(text) == 6 else None,
    "string": literal,
    "decimal string": lambda text: literal(text, is_decimal=True),
}
_OF_WIDTH = {
    "octal": {3, 4},
    "number": {1, 8},
    "bits": {1, 8},
    "words": {4, 8},
    "decimal words": {5},
    "octal words": {6},
}
"""Widths of digits one of which must be in a run to be read so."""


def readings(run: Run) -> list[str]:
    """Returns the readings that a run may have, the likeliest first."""
    if run.values[0].style is Style.BASE64:
        return ["base64"]
    if run.is_text:
        return ["string", "decimal string"] if any("\\" in value.text for value in run.values) else ["string"]
    bare = [value.text for value in run.values if value.style is Style.BARE]
    widths = set(map(len, bare))
    if not widths:
        return ["hex"]
    if not min(widths) % 8 and all({*text} <= {"0", "1"} for text in bare):
        return ["bits"] if len(run.values) > 2 else ["bits", "hex"]
    has_marks = any(value.style is Style.MARKED for value in run.values)
    is_padded = widths <= {2} or max(widths) >= 4 or any(len(text) == 2 and text[0] == "0" for text in bare)
    found = ["hex", "decimal"] if is_padded and not has_marks else ["decimal", "hex"]
    return found + [name for name, needed in _OF_WIDTH.items() if widths & needed]


def _bytes_of(name: str, value: Value) -> bytes | None:
    if value.data is not None:
        return value.data
    if value.style is Style.BASE64 or (value.style is Style.STRING) is not name.endswith("string"):
        return None
    return _OF_TEXT[name](value.text)


def _stretches(run: Run, name: str) -> list[Stretch]:
    """Returns the parts of a run that a reading gives bytes for."""
    if name == "base64":
        content = _base64("".join(value.text for value in run.values)) or b""
        last = len(run.values) - 1
        return [Stretch(name, content, [min(at, last) for at in range(len(content))])]
    found: list[Stretch] = []
    data, places = bytearray(), list[int]()
    for index, value in enumerate([*run.values, None]):
        part = None if value is None else _bytes_of(name, value)
        if part is not None:
            data += part
            places += [index] * len(part)
        elif data:
            found.append(Stretch(name, bytes(data), places))
            data, places = bytearray(), []
    return found


def whole_bytes(run: Run, name: str) -> bytes | None:
    """Returns the bytes of all values of a run in a reading; None where a value has none."""
    parts = _stretches(run, name)
    return parts[0].data if len(parts) == 1 and len({*parts[0].places}) == len(run.values) else None


def likely_bytes(run: Run) -> bytes | None:
    """Returns the bytes of a run in the likeliest reading that gives bytes for all of it."""
    return next((data for name in readings(run) if (data := whole_bytes(run, name)) is not None), None)


def boundaries(run: Run, stretch: Stretch) -> tuple[set[int], set[int]]:
    """Returns where frames may naturally start and end in a stretch."""
    places, changes = stretch.places, changes_in(run)
    # Where a value has no bytes in this reading, the stretch has no natural boundary.
    starts = {0} if places[0] == 0 or places[0] in changes else set[int]()
    ends = {len(places)} if places[-1] + 1 == len(run.values) or places[-1] + 1 in changes else set[int]()
    for offset in range(1, len(places)):
        place = places[offset]
        if place != places[offset - 1]:
            is_line = run.gaps[place] == "\n" and not run.is_array
            if is_line or (run.is_text and run.gaps[place] == ",") or place in changes:
                starts.add(offset)
                ends.add(offset)
    if run.is_text and run.values[0].text[:1] not in ("\\", ""):
        starts.add(1)
    if (run.check_sum is not None and stretch.data[-1:] == bytes((run.check_sum,))) or stretch.name.endswith("words"):
        # A check sum follows; a dump in words has an even number of bytes.
        ends.add(len(places) - 1)
    return starts, ends


def changes_in(run: Run) -> frozenset[int]:
    """Returns the values in front of which the way of separating or writing values changes."""
    if run.changes is None:
        run.changes = frozenset(_changes(run))
    return run.changes


def _changes(run: Run) -> set[int]:
    values, gaps = run.values, [None, *run.gaps[1:], None]
    found: set[int] = set()
    for place in range(1, len(values)):
        gap, before, after, left, right = (
            gaps[place],
            gaps[place - 1],
            gaps[place + 1],
            values[place - 1],
            values[place],
        )
        if gap == before and left.style is right.style is not Style.BARE:
            continue
        # Gaps that alternate, as between keys and values, are not a change.
        is_alternating = place > 2 and gaps[place - 2] == gap and before == after
        if is_alternating or (run.is_array and "\n" in (gap, before)):
            continue
        if before is None:
            is_change = after not in (None, gap)
        else:
            # After a single gap of another kind it continues as before.
            is_back = place - 1 in found and gap == (gaps[place - 2] if place > 2 else after)
            is_change = gap != before and not is_back
        if left.style is right.style is Style.BARE:
            widths = sorted((len(left.text), len(right.text)))
            is_change = is_change or widths[0] < LEAST <= widths[1] // 2
        if is_change or (left.style is not right.style and Style.UNKNOWN not in (left.style, right.style)):
            found.add(place)
    return found


def tried(run: Run) -> list[Reading]:
    """Returns the readings of a run that were tried.

    The first is worth most; among equals it is one without a flaw, then the likelier one.
    """
    if run.tried is None:
        run.tried = []
        for name in readings(run):
            one = _reading(run, name)
            run.tried.append(one)
            if one.is_whole and (run.is_text or name == "hex" or one.is_flawless):
                # No other reading is worth more.
                break
        most = max(one.worth for one in run.tried)
        equals = [one for one in run.tried if one.worth == most]
        best = next((one for one in equals if len(equals) > 1 and one.frames and one.is_flawless), equals[0])
        run.tried.sort(key=lambda one: one is not best)
    found: list[Reading] = run.tried
    return found


def _reading(run: Run, name: str) -> Reading:
    parts = _stretches(run, name)
    is_complete = sum(len({*part.places}) for part in parts) == len(run.values)
    frames: list[Frame] = []
    is_whole = False
    for stretch in parts:
        found, is_all = _frames(run, stretch, is_complete=is_complete and len(parts) == 1)
        frames += found
        is_whole = is_whole or (is_all and bool(found))
    return Reading(parts, frames, is_whole, is_complete)


def _frames(run: Run, stretch: Stretch, *, is_complete: bool) -> tuple[list[Frame], bool]:
    """Returns the frames in a part of a run, which may be all of it, and whether they are all of it."""
    name, data, places = stretch
    if len(data) < LEAST:
        return [], False
    starts, ends = boundaries(run, stretch)
    unknown = {offset for offset, place in enumerate(places) if run.values[place].style is Style.UNKNOWN}
    spans = frames_in(data, starts, ends, unknown, is_hid=name != "base64" and 0 in starts and data[0] == 0)
    if not spans or (name in _UNLIKELY and not all(is_flawless(data[start:end]) for start, end, _ in spans)):
        return [], False
    last = spans[-1][1]
    is_padded = not any(data[last:])
    is_whole = is_complete and is_padded and sum(end - start for start, end, _ in spans) == last
    if name == "base64" and not is_whole:
        return [], False
    # Padding belongs to the frame in front of it, which is how it is reported.
    padding = data[last:] if is_padded and len(spans) == 1 else b""
    frames = [Frame(data[start:end], padding, places[start], places[end - 1], natural) for start, end, natural in spans]
    if len(run.values) == 1:
        return frames if is_whole or len(data) not in HASHES else [], is_whole
    is_likely = [
        name == "base64" or _is_likely(run, frame, places[start:end], is_whole=is_whole)
        for frame, (start, end, _) in zip(frames, spans, strict=True)
    ]
    return [frame for frame, likely in zip(frames, is_likely, strict=True) if likely], is_whole and all(is_likely)


def _is_likely(run: Run, frame: Frame, places: list[int], *, is_whole: bool) -> bool:
    """Whether a frame is meant as one, be it all of a run or among other values.

    Unpadded numbers with all kinds of marks between them, as in expressions and drawings, are a frame by chance.
    """
    gaps = {run.gaps[place] for place in places[1:]} - {"", "\n"}
    if len(gaps) < (_MANY_GAPS if is_whole else 2) or all(len(run.values[place].text) == 2 for place in places):
        return True
    return len(frame.data) >= LOOKS and is_something(frame.data) and is_flawless(frame.data)

"""What a run of values may represent: its bytes in each reading, and the frames in them."""

from __future__ import annotations

import base64
import binascii
from collections.abc import Callable, Mapping
from typing import NamedTuple

from ev3proto.text.paste.fitting import HASHES, LOOKS, Span, covered, frames_in, is_flawless, is_something, is_whole
from ev3proto.text.paste.literals import literal
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.values import Run, Style, Value

_MANY_GAPS = 4
_OCTAL = frozenset("01234567")


class Stretch(NamedTuple):
    """A part of a run that one reading gives bytes for: these, and the value that each of them belongs to."""

    name: str
    data: bytes
    places: list[int]


class Reading(NamedTuple):
    """A reading of a run and the frames that it gives.

    stretches    its bytes
    is_complete  every value of the run has bytes in it
    spans        the frames in the stretches that have some
    """

    stretches: list[Stretch]
    is_complete: bool
    spans: list[tuple[Stretch, list[Span]]]

    @property
    def worth(self) -> tuple[bool, int, bool, int]:
        """What tells the likelier of two readings: whether its frames are all, their bytes, whether it is complete."""
        natural = sum(span.end - span.start for _, spans in self.spans for span in spans if span.is_natural)
        return self.is_whole, natural, self.is_complete, sum(covered(spans) for _, spans in self.spans)

    @property
    def is_natural(self) -> bool:
        """Whether it has frames, all from one natural boundary to another."""
        return bool(self.spans) and all(span.is_natural for _, spans in self.spans for span in spans)

    @property
    def is_flawless(self) -> bool:
        """Whether none of its frames has a flaw."""
        return all(is_flawless(stretch.data[span.start : span.end]) for stretch, spans in self.spans for span in spans)

    @property
    def is_whole(self) -> bool:
        """Whether its frames are all of the run."""
        is_one = len(self.spans) == len(self.stretches) == 1 and self.is_complete
        return is_one and is_whole(self.spans[0][0].data, self.spans[0][1])


Tried = tuple[Reading, list[Reading]]
"""The best reading of a run, and all that were tried."""


def _hex(text: str) -> bytes | None:
    if len(text) == 1:
        return bytes((int(text, 16),))
    return None if len(text) % 2 else bytes.fromhex(text)


def _decimal(text: str) -> bytes | None:
    return _sized(text, 10, 1) if len(text) <= 3 and text.isdecimal() else None


def _octal(text: str) -> bytes | None:
    is_octal = (len(text) <= 3 or (len(text) == 4 and text[0] == "0")) and set(text) <= _OCTAL
    return _sized(text, 8, 1) if is_octal else None


def _number(text: str) -> bytes | None:
    """Returns the byte of an unpadded number, also where the sign of a negative one was spread over 32 bits."""
    number = int(text, 16) if len(text) in (1, 2, 8) else 0
    return bytes((number & 0xFF,)) if len(text) < 3 or number >= 0xFFFFFF80 else None


def _words(text: str) -> bytes | None:
    return bytes.fromhex(text)[::-1] if len(text) in (2, 4, 6, 8) else None


def _bits(text: str) -> bytes | None:
    is_bits = len(text) % 8 == 0 and set(text) <= {"0", "1"}
    return int(text, 2).to_bytes(len(text) // 8, "big") if is_bits else None


def _sized(text: str, base: int, size: int) -> bytes | None:
    number = int(text, base)
    return number.to_bytes(size, "little") if number < 1 << 8 * size else None


def _base64(text: str) -> bytes | None:
    """Returns the bytes of base64, with either alphabet, padded or not."""
    digits = text.rstrip("=").replace("-", "+").replace("_", "/")
    try:
        return base64.b64decode(digits + "=" * (-len(digits) % 4), validate=True)
    except binascii.Error:
        return None


_UNLIKELY = ("octal", "number", "words", "decimal words", "octal words")
"""The readings whose frames must not have a flaw."""
STRING, DECIMAL_STRING, BASE64 = "string", "decimal string", "base64"
_OF_TEXT: Mapping[str, Callable[[str], bytes | None]] = {
    "hex": _hex,
    "decimal": _decimal,
    "octal": _octal,
    "number": _number,
    "bits": _bits,
    "words": _words,
    "decimal words": lambda text: _sized(text, 10, 2) if len(text) == 5 and text.isdecimal() else None,
    "octal words": lambda text: _sized(text, 8, 2) if len(text) == 6 and set(text) <= _OCTAL else None,
    STRING: lambda text: literal(text, is_decimal=False),
    DECIMAL_STRING: lambda text: literal(text, is_decimal=True),
    BASE64: _base64,
}


def readings(run: Run) -> list[str]:
    """Returns the readings that a run may have, the likeliest first."""
    if run.values[0].style is Style.BASE64:
        return [BASE64]
    if run.is_text:
        return [STRING, DECIMAL_STRING] if any("\\" in value.text for value in run.values) else [STRING]
    bare = [value.text for value in run.values if value.style is Style.BARE]
    widths = set(map(len, bare))
    if not widths:
        return ["hex"]
    if not min(widths) % 8 and all(set(text) <= {"0", "1"} for text in bare):
        return ["bits"] if len(run.values) > 2 else ["bits", "hex"]
    has_marks = any(value.style is Style.MARKED for value in run.values)
    is_padded = widths <= {2} or max(widths) >= 4
    has_zeros = any(len(text) == 2 and text[0] == "0" for text in bare)
    found = ["decimal", "hex"] if has_marks or not (is_padded or has_zeros) else ["hex", "decimal"]
    for names, needed in (
        (("octal",), {3, 4}),
        (("number", "bits"), {1, 8}),
        (("words",), {4, 8}),
        (("decimal words",), {5}),
        (("octal words",), {6}),
    ):
        if widths & needed:
            found += names
    return found


def _bytes_of(name: str, value: Value) -> bytes | None:
    if value.data is not None:
        return value.data
    if value.style is Style.BASE64 or (value.style is Style.STRING) is not (name in (STRING, DECIMAL_STRING)):
        return None
    return _OF_TEXT[name](value.text)


def stretches(run: Run, name: str) -> list[Stretch]:
    """Returns the parts of a run that a reading gives bytes for."""
    if name == BASE64:
        content = _base64("".join(value.text for value in run.values)) or b""
        return [Stretch(name, content, [min(at, len(run.values) - 1) for at in range(len(content))])]
    found: list[Stretch] = []
    data, places = bytearray(), list[int]()
    for index, value in enumerate(run.values):
        part = _bytes_of(name, value)
        if part is not None:
            data += part
            places += [index] * len(part)
        elif data:
            found.append(Stretch(name, bytes(data), places))
            data, places = bytearray(), []
    return [*found, Stretch(name, bytes(data), places)] if data else found


def whole_bytes(run: Run, name: str) -> bytes | None:
    """Returns the bytes of all values of a run in a reading; None where a value has none."""
    parts = stretches(run, name)
    is_all = len(parts) == 1 and (name == BASE64 or len({*parts[0].places}) == len(run.values))
    return parts[0].data if is_all else None


def likely_bytes(run: Run) -> bytes | None:
    """Returns the bytes of a run in the likeliest reading that gives bytes for all of it."""
    return next((data for name in readings(run) if (data := whole_bytes(run, name)) is not None), None)


def plain_bytes(run: Run) -> bytes | None:
    """Returns the bytes of a run that has padded hex or marked numbers only; None for any other."""
    is_plain = all(
        value.style is Style.MARKED or (value.style is Style.BARE and len(value.text) % 2 == 0) for value in run.values
    )
    return whole_bytes(run, "hex") if is_plain else None


def boundaries(run: Run, stretch: Stretch) -> tuple[set[int], set[int], set[int]]:
    """Returns where frames may naturally start and end in a stretch, and which of its bytes are not given."""
    places, values, gaps = stretch.places, run.values, run.gaps
    changes = changes_in(run)
    # Where a value has no bytes in this reading, the stretch has no natural boundary.
    starts = {0} if places and (places[0] == 0 or places[0] in changes) else set[int]()
    ends = {len(places)} if places and (places[-1] + 1 == len(values) or places[-1] + 1 in changes) else set[int]()
    unknown = set[int]()
    before = places[0] if places else 0
    for offset, place in enumerate(places):
        if values[place].style is Style.UNKNOWN:
            unknown.add(offset)
        if place == before:
            continue
        before = place
        is_line = gaps[place] == "\n" and not run.is_array
        if is_line or (run.is_text and gaps[place] == ",") or place in changes:
            starts.add(offset)
            ends.add(offset)
    if run.is_text and run.values[0].text[:1] not in ("\\", ""):
        starts.add(1)
    if (run.check_sum is not None and stretch.data[-1] == run.check_sum) or stretch.name.endswith("words"):
        # A check sum follows; a dump in words has an even number of bytes.
        ends.add(len(places) - 1)
    return starts, ends, unknown


def changes_in(run: Run) -> frozenset[int]:
    """Returns the values in front of which the way of separating or writing values changes."""
    if run.changes is None:
        run.changes = frozenset(_changes(run))
    return run.changes


def _changes(run: Run) -> set[int]:
    values, gaps = run.values, run.gaps
    found: set[int] = set()
    for place in range(1, len(values)):
        gap, left, right = gaps[place], values[place - 1], values[place]
        before = gaps[place - 1] if place > 1 else None
        after = gaps[place + 1] if place + 1 < len(gaps) else None
        if gap == before and left.style is right.style and left.style is not Style.BARE:
            continue
        if place > 1 and gaps[place - 2] == gap and before == after:
            # Gaps that alternate, as between keys and values, are not a change.
            continue
        if run.is_array and "\n" in (gap, before):
            continue
        if before is None:
            is_change = after is not None and after != gap
        else:
            # After a single gap of another kind it continues as before.
            is_back = place - 1 in found and (gap == gaps[place - 2] if place > 2 else gap == after)
            is_change = gap != before and not is_back
        if left.style is right.style is Style.BARE:
            widths = sorted((len(left.text), len(right.text)))
            is_change = is_change or widths[0] < LEAST <= widths[1] // 2
        if is_change or (left.style is not right.style and Style.UNKNOWN not in (left.style, right.style)):
            found.add(place)
    return found


def best_reading(run: Run) -> Tried:
    """Returns the reading of a run that is worth most; among equals one without a flaw, then the likelier one."""
    if run.tried is None:
        run.tried = _best(run)
    tried: Tried = run.tried
    return tried


def _best(run: Run) -> Tried:
    tried: list[Reading] = []
    for name in readings(run):
        parts = stretches(run, name)
        is_complete = name == BASE64 or sum(len({*part.places}) for part in parts) == len(run.values)
        one = Reading(parts, is_complete, [])
        for stretch in parts:
            if len(stretch.data) < LEAST:
                continue
            starts, ends, unknown = boundaries(run, stretch)
            is_hid = name != BASE64 and 0 in starts and stretch.data[:1] == b"\0"
            spans = frames_in(stretch.data, starts, ends, unknown, is_hid=is_hid)
            if name in _UNLIKELY and not all(is_flawless(stretch.data[span.start : span.end]) for span in spans):
                spans = []
            if name == BASE64 and not is_whole(stretch.data, spans):
                spans = []
            is_all = is_complete and len(parts) == 1 and is_whole(stretch.data, spans)
            spans = [span for span in spans if name == BASE64 or _is_likely(run, stretch, span, is_all=is_all)]
            if spans:
                one.spans.append((stretch, spans))
        tried.append(one)
        if one.is_whole and (run.is_text or name == "hex" or one.is_flawless):
            # No other reading is worth more.
            return one, tried
    most = max(one.worth for one in tried)
    equals = [one for one in tried if one.worth == most]
    return next((one for one in equals if len(equals) > 1 and one.spans and one.is_flawless), equals[0]), tried


def _is_likely(run: Run, stretch: Stretch, span: Span, *, is_all: bool) -> bool:
    """Whether a frame is meant as one, be it all of a run (`is_all`) or among other values.

    Unpadded numbers with all kinds of marks between them, as in expressions and drawings, are a frame by chance; so are
    some of the digits of a hash.
    """
    if len(run.values) == 1:
        return is_all or len(stretch.data) not in HASHES
    places = stretch.places[span.start : span.end]
    gaps = {run.gaps[place] for place in places[1:]} - {"", "\n"}
    if len(gaps) < (_MANY_GAPS if is_all else 2) or all(len(run.values[place].text) == 2 for place in places):
        return True
    data = stretch.data[span.start : span.end]
    return len(data) >= LOOKS and is_something(data) and is_flawless(data)

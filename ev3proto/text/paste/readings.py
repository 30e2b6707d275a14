"""What a run of values may represent: its bytes in each reading, and the frames in them.

Frames are the bytes whose length field fits, from one natural boundary to the next. A boundary is natural where the run
begins or ends, and where the way of separating or writing its values changes. Between other boundaries a frame must
have no flaw, or any number among many would make one.
"""

from __future__ import annotations

import binascii
from collections.abc import Callable, Mapping, Set
from itertools import pairwise
from typing import NamedTuple

from ev3proto.messages import DirectCommand, SystemCommand, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    MEMORY_SIZE,
    build_frame,
    frame_size,
    is_frame_size,
    may_have_length,
    with_length,
    write_memory,
)
from ev3proto.semantics.footprint import footprints
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, LENGTH_FIELD, MAX_GLOBALS, MAX_LOCALS, MessageType
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.values import Run, Style, Value, literal

_TYPES = frozenset(map(int, MessageType))
_COMMANDS = frozenset(int(member) for member in MessageType if member.is_command)
LOOKS = 7
"""The fewest bytes that look like a frame."""
_NEARLY = 2
_MOST_MISSING = 8
"""How many times as many bytes as a text has may be those of the frame that it begins."""
HASHES = (16, 20, 28, 32, 48, 64)
"""Bytes of the sums that people print beside files: MD5, SHA-1, SHA-2."""
_TYPE_AT = HEADER_SIZE - 1
_TRIES = 16
_RFCOMM = (0xEF, 0xFF)
"""The control byte of RFCOMM packets that carry data."""


def is_flawless(frame: bytes) -> bool:
    """Whether a brick could read all of a frame, and knows its command."""
    message = parse(frame, strict=False)
    if message.fault is not None:
        return False
    return not isinstance(message, SystemCommand | SystemReply) or message.command is not None


def is_something(frame: bytes) -> bool:
    """Whether more is in a frame than zeros and ones, which are operations without a flaw that programs do not send."""
    return len(set(frame[HEADER_SIZE:])) > 2


def is_one_frame(data: bytes) -> bool:
    """Whether bytes that were gathered among words are one frame, without a flaw and not by chance."""
    return len(data) >= HEADER_SIZE and frame_size(data) == len(data) and is_something(data) and is_flawless(data)


def frames_in(
    data: bytes, starts: Set[int], ends: Set[int], unknown: Set[int], *, is_hid: bool
) -> list[tuple[int, int, bool]]:
    """Returns the frames in the bytes of a run, in their order; they do not overlap.

    Args:
        data: The bytes.
        starts: Offsets of natural boundaries at which a frame may start.
        ends: Offsets of natural boundaries at which a frame may end.
        unknown: Offsets of bytes that are not given; only those of a counter may be.
        is_hid: A report number of zero may be in front.

    Returns:
        Of each frame its first byte, the byte after its last, and whether both are natural boundaries.
    """
    found: list[tuple[int, int, bool]] = []
    size, padded = len(data), len(data.rstrip(b"\0"))
    budget = _TRIES * size + 1024
    at = after = 0
    while at + HEADER_SIZE <= size:
        end = _end(data, at)
        if end is None:
            at += 1
            continue
        # RFCOMM has its control byte and its length in front of a frame, and one byte of a check sum after it.
        is_carried = end + 1 == size and any(byte in _RFCOMM for byte in data[max(at - 3, 0) : max(at - 1, 0)])
        starts_well = is_carried or at in starts or (at == after and bool(found)) or (is_hid and at == 1)
        ends_well = is_carried or end in ends or (end >= padded and size in ends) or _end(data, end) is not None
        takes = starts_well and ends_well
        if not takes and budget > 0:
            budget -= end - at
            is_long = end - at >= LOOKS
            is_lone = data[at + _TYPE_AT] in _COMMANDS and 0 < at < HEADER_SIZE
            may = not starts_well and (ends_well or is_lone) and (is_long or at <= 2)
            takes = may and (not is_long or is_something(data[at:end])) and is_flawless(data[at:end])
        if takes and not any(at <= place < at + 2 or at + 4 <= place < end for place in unknown):
            found.append((at, end, starts_well and ends_well))
            at = after = end
        else:
            at += 1
    return found


def _end(data: bytes, at: int) -> int | None:
    """Returns where the frame ends that may start there, by its length and its type; None for no frame."""
    if at + HEADER_SIZE > len(data) or data[at + _TYPE_AT] not in _TYPES:
        return None
    size = frame_size(data, at)
    return at + size if at + size <= len(data) and may_have_length(data, at) else None


def may_begin(data: bytes | bytearray) -> bool:
    """Whether a frame may begin there: its length and its type are possible, as far as they are there."""
    if len(data) < LENGTH_FIELD or not may_have_length(data) or frame_size(data) > _MOST_MISSING * len(data):
        return False
    return len(data) <= _TYPE_AT or data[_TYPE_AT] in _TYPES


def reason(data: bytes, *, is_dense: bool, is_decimal: bool) -> str | None:
    """Returns why bytes that are not a frame look like one, as a sentence; None where they do not.

    Args:
        data: The bytes of a run, from a natural boundary to the next.
        is_dense: They are written without blanks, as hashes and fingerprints are.
        is_decimal: They are decimal numbers, of which prose and tables have many.
    """
    if len(data) < LOOKS or _counts_up(data):
        return None
    says, has_type = frame_size(data), data[_TYPE_AT] in _TYPES
    is_near = abs(says - len(data)) <= _NEARLY
    if is_dense and len(data) in HASHES and not (is_near and has_type):
        return None
    if _swapped(data):
        return (
            f"the length field says {says - LENGTH_FIELD}: did you swap these two bytes, {data[:2].hex(' ').upper()}?"
        )
    if says > _MOST_MISSING * len(data) or (is_decimal and not any(data[2:])):
        return None
    if not is_near and not (has_type and (is_frame_size(says) or is_flawless(with_length(data[LENGTH_FIELD:])))):
        return None
    here = f"{len(data)} bytes"
    if says > len(data):
        is_own = says - len(data) == LENGTH_FIELD
        return f"{here} begin a frame of {says}" + ": does the length count its own two bytes?" * is_own
    if is_frame_size(says):
        return f"{here} are here, and the length field is that of a frame of {says}"
    return f"{here} are here, and the length field says {says - LENGTH_FIELD}"


def is_nearly(data: bytes) -> bool:
    """Whether bytes are a frame but for a length field that is wrong by a little, and does not count itself."""
    says = frame_size(data) if len(data) >= LOOKS and data[_TYPE_AT] in _TYPES else 0
    return is_frame_size(says) and -_NEARLY <= says - len(data) < LENGTH_FIELD


def _swapped(data: bytes) -> bool:
    """Whether the length field fits once its two bytes are swapped, and the rest is a frame without a flaw."""
    right = data[1::-1] + data[2:]
    return len(data) >= LOOKS and frame_size(right) == len(data) and data[_TYPE_AT] in _TYPES and is_flawless(right)


def bare_reason(data: bytes) -> str | None:
    """Returns what bytes without a header are, as a sentence, and which option reads them; None for other bytes."""
    if len(data) < HEADER_SIZE or _counts_up(data) or _swapped(data):
        return None
    end = _end(data, 0)
    if abs(frame_size(data) - len(data)) <= _NEARLY or (end is not None and not any(data[end:])):
        return None
    for text, make in _BARE:
        frame = make(data)
        if frame is not None and is_flawless(frame):
            return text
    return None


def without_length(data: bytes) -> bytes | None:
    """Returns the bytes as a message that lost its length field; None where they are too few or too many."""
    if not is_frame_size(len(data) + LENGTH_FIELD) or data[_TYPE_AT - LENGTH_FIELD] not in _TYPES:
        return None
    return with_length(data)


def with_header(data: bytes) -> bytes | None:
    """Returns the bytes as the operations of a direct command with the memory that they use for sure."""
    if not data or not is_frame_size(COMMAND_HEADER_SIZE + len(data)):
        return None
    plain = build_frame(MessageType.DIRECT_COMMAND_NO_REPLY, 0, bytes(MEMORY_SIZE) + data)
    message = parse(plain, strict=False)
    if not isinstance(message, DirectCommand):
        return None
    used = {GLOBAL: 0, LOCAL: 0}
    for found in (place for operation in message.operations for place in footprints(operation)):
        scope = found.argument.kind
        used[scope] = max(used[scope], found.start + (found.room or found.size))
    if not any(used.values()) or used[GLOBAL] > MAX_GLOBALS or used[LOCAL] > MAX_LOCALS:
        return plain
    return build_frame(DIRECT_COMMAND_TYPES[bool(used[GLOBAL])], 0, write_memory(used[GLOBAL], used[LOCAL]) + data)


_BARE: tuple[tuple[str, Callable[[bytes], bytes | None]], ...] = (
    ("this is a frame without its length bytes: --no-length reads it", without_length),
    ("these are operations without the header of a frame: --operations reads them", with_header),
)


def _counts_up(data: bytes) -> bool:
    """Whether the values are all the same, or count up or down, as the head of a dump does."""
    step = (data[1] - data[0]) & 0xFF
    return step in (0, 1, 255) and all((b - a) & 0xFF == step for a, b in pairwise(data))


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

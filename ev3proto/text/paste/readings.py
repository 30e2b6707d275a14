"""What a run of values may stand for: its bytes in each reading, and the frames in them."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from ev3proto.text.paste.fitting import HASHES, LOOKS, Span, covered, frames_in, is_flawless, is_something, is_whole
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.values import BASES, Run, Style, reading, readings

_MANY_GAPS = 4


@dataclass(slots=True)
class Stretch:
    """A part of a run that one reading gives bytes for.

    data     the bytes
    places   the value that each of them belongs to
    name     the reading
    """

    name: str
    data: bytes
    places: list[int]


@dataclass(slots=True)
class Reading:
    """A reading of a run and the frames that it gives.

    stretches    its bytes
    is_complete  every value of the run has bytes in it
    spans        the frames in the stretches that have some
    """

    stretches: list[Stretch] = field(default_factory=list)
    is_complete: bool = True
    spans: list[tuple[Stretch, list[Span]]] = field(default_factory=list)

    @property
    def covered(self) -> int:
        """How many bytes its frames have."""
        return sum(covered(spans) for _, spans in self.spans)

    @property
    def worth(self) -> tuple[bool, int, bool, int]:
        """What tells the likelier of two readings: whether its frames are all, their bytes, whether it is complete."""
        natural = sum(span.end - span.start for _, spans in self.spans for span in spans if span.is_natural)
        return self.is_whole, natural, self.is_complete, self.covered

    @property
    def is_natural(self) -> bool:
        """Whether it has frames, all from one natural boundary to another."""
        return bool(self.spans) and all(span.is_natural for _, spans in self.spans for span in spans)

    @property
    def is_flawless(self) -> bool:
        """Whether nothing is wrong with any of its frames."""
        return all(is_flawless(stretch.data[span.start : span.end]) for stretch, spans in self.spans for span in spans)

    @property
    def is_whole(self) -> bool:
        """Whether its frames are all there is."""
        return (
            len(self.spans) == len(self.stretches) == 1
            and self.is_complete
            and is_whole(self.spans[0][0].data, self.spans[0][1])
        )


def stretches(run: Run, name: str) -> list[Stretch]:
    """The parts of a run that a reading gives bytes for."""
    found: list[Stretch] = []
    data = bytearray()
    places: list[int] = []
    if name in BASES:
        joined = replace(run.values[0], text="".join(value.text for value in run.values))
        content = reading(name, joined) or b""
        return [Stretch(name, content, [min(at, len(run.values) - 1) for at in range(len(content))])]
    for index, value in enumerate(run.values):
        part = reading(name, value)
        if part is None:
            if data:
                found.append(Stretch(name, bytes(data), places))
            data, places = bytearray(), []
            continue
        data += part
        places += [index] * len(part)
    if data:
        found.append(Stretch(name, bytes(data), places))
    return found


def boundaries(run: Run, stretch: Stretch) -> tuple[set[int], set[int], set[int]]:
    """Where frames may naturally start and end in a stretch, and which of its bytes were not written."""
    places, values, gaps = stretch.places, run.values, run.gaps
    changes = changes_in(run)
    # Where a value has no bytes in this reading, the stretch has no natural boundary.
    starts = {0} if places and (places[0] == 0 or places[0] in changes) else set[int]()
    ends = {len(places)} if places and (places[-1] + 1 == len(values) or places[-1] + 1 in changes) else set[int]()
    unknown = set[int]()
    for offset, place in enumerate(places):
        if values[place].style is Style.UNKNOWN:
            unknown.add(offset)
        is_line = gaps[place] == "\n" and not run.is_array
        is_listed = run.is_text and gaps[place] == ","
        if offset and place != places[offset - 1] and (is_line or is_listed or place in changes):
            starts.add(offset)
            ends.add(offset)
    if stretch.name in ("string", "decimal string") and run.values[0].text[:1] not in ("\\", ""):
        starts.add(1)
    if run.check_sum is not None and stretch.data[-1] == run.check_sum:
        ends.add(len(places) - 1)
    if stretch.name in ("words", "octal words", "decimal words"):
        # A dump in words has an even number of bytes.
        ends.add(len(places) - 1)
    return starts, ends, unknown


def changes_in(run: Run) -> frozenset[int]:
    """The values in front of which the way of separating or writing values changes."""
    if run.changes is None:
        run.changes = frozenset(_found_changes(run))
    return run.changes


def _found_changes(run: Run) -> set[int]:
    values, gaps = run.values, run.gaps
    found: set[int] = set()
    for place in range(1, len(values)):
        gap = gaps[place]
        before = gaps[place - 1] if place > 1 else None
        after = gaps[place + 1] if place + 1 < len(gaps) else None
        kinds = (values[place - 1].style, values[place].style)
        if place > 1 and gaps[place - 2] == gap and before == after:
            # Gaps that take turns, as between keys and values, are no change.
            continue
        if before is None:
            is_change = after is not None and after != gap
        else:
            # After a single gap of another kind it goes on as before.
            is_back = place - 1 in found and (gap == gaps[place - 2] if place > 2 else gap == after)
            is_change = gap != before and not is_back
        if "\n" in (gap, before) and run.is_array:
            continue
        widths = sorted((len(values[place - 1].text), len(values[place].text)))
        is_change = is_change or (kinds == (Style.BARE, Style.BARE) and widths[0] < LEAST <= widths[1] // 2)
        if is_change or (kinds[0] is not kinds[1] and Style.UNKNOWN not in kinds):
            found.add(place)
    return found


def best_reading(run: Run) -> tuple[Reading, list[Reading]]:
    """The reading of a run whose frames have the most bytes, and all that were tried."""
    if run.known is None:
        run.known = _found_best(run)
    found: tuple[Reading, list[Reading]] = run.known
    return found


def _found_best(run: Run) -> tuple[Reading, list[Reading]]:
    """The reading that is worth most; among equals the one whose frames have no flaw, then the likelier one."""
    tried: list[Reading] = []
    for name in readings(run):
        parts = stretches(run, name)
        one = Reading(parts, name in BASES or sum(len({*part.places}) for part in parts) == len(run.values))
        for stretch in one.stretches:
            starts, ends, unknown = boundaries(run, stretch)
            is_hid = name not in BASES and 0 in starts and stretch.data[:1] == b"\0"
            spans = frames_in(stretch.data, starts, ends, unknown, is_hid=is_hid)
            if name in BASES and not is_whole(stretch.data, spans):
                spans = []
            elif spans:
                is_all = one.is_complete and len(parts) == 1 and is_whole(stretch.data, spans)
                spans = [span for span in spans if is_likely(run, stretch, span, is_all=is_all)]
            if spans:
                one.spans.append((stretch, spans))
        tried.append(one)
        if one.is_whole and (run.is_text or name == "hex" or one.is_flawless):
            # No other reading is worth more.
            return one, tried
    most = max(one.worth for one in tried)
    equals = [one for one in tried if one.worth == most]
    if len(equals) > 1 and equals[0].spans:
        return next((one for one in equals if one.is_flawless), equals[0]), tried
    return equals[0], tried


def is_likely(run: Run, stretch: Stretch, span: Span, *, is_all: bool) -> bool:
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


def plain_bytes(run: Run) -> bytes | None:
    """The bytes of a run that has padded hex or marked numbers only; None for any other."""
    found = b""
    for value in run.values:
        if value.data is not None and value.style is Style.MARKED:
            found += value.data
        elif value.style in (Style.BARE, Style.LONG) and len(value.text) % 2 == 0:
            found += bytes.fromhex(value.text)
        else:
            return None
    return found


def mixed_bytes(run: Run) -> bytes | None:
    """The bytes of a run in the likeliest reading that gives bytes for all of it; None where there is none."""
    for name in readings(run):
        parts = stretches(run, name)
        if len(parts) == 1 and len({*parts[0].places}) == len(run.values):
            return parts[0].data
    return None

"""What a run is worth: the frames in it, and one explicit order of worth."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import NamedTuple

from ev3proto.schema.frame import is_flawless
from ev3proto.schema.header import HEADER_SIZE, frame_size, may_start
from ev3proto.semantics.identify import is_sure
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.elements import UNLIKELY
from ev3proto.text.paste.frames import FrameSpan, frames_in, is_command
from ev3proto.text.paste.pieces import LEAST
from ev3proto.text.paste.runs import Part, Run


class Worth(NamedTuple):
    """What makes one reading likelier than another; the first that differs decides.

    is_whole  all frames begin where the text suggests it, and nothing is left but zeros: hardly by chance
    natural   the bytes of frames that begin where the text suggests it: others may be a part of something else
    size      the bytes of all frames: what explains more is likelier
    """

    is_whole: bool = False
    natural: int = 0
    size: int = 0


class Reading(NamedTuple):
    """A run in a base, and its parts that have frames."""

    worth: Worth
    run: Run
    base: str
    parts: list[tuple[Part, list[FrameSpan]]]


def best(runs: Iterable[Run]) -> Reading | None:
    """Returns the likeliest reading with frames; the first of those that are worth the same."""
    found: Reading | None = None
    for run in runs:
        for base in run.bases:
            reading = _read(run, base)
            if reading.worth.size and (found is None or reading.worth > found.worth):
                found = reading
                if reading.worth.is_whole:
                    return found
    return found


def _read(run: Run, base: str) -> Reading:
    """Returns the frames in a run, in one base."""
    widths = {*run.widths}
    is_decimal = base == "decimal"
    is_trusted = 1 not in widths and not run.has_string and (not is_decimal or widths == {3})
    is_doubtful = base in UNLIKELY or is_decimal or 1 in widths
    found = ((part, _frames(run, base, part, is_trusted, is_doubtful)) for part in run.parts(base))
    parts = [(part, frames) for part, frames in found if frames]
    return Reading(_worth(run, parts), run, base, parts)


def _frames(run: Run, base: str, part: Part, is_trusted: bool, is_doubtful: bool) -> list[FrameSpan]:
    """Returns the frames in a part of a run that are hardly ones by chance."""
    if run.is_cut(part) and _goes_on(part.data):
        return []  # the frame goes on where the text was cut: what looks like one in it is not
    frames = frames_in(part.data, partial(run.edges, part), is_trusted=is_trusted)
    if is_doubtful:
        frames = [one for one in frames if one.is_natural]
    if run.is_torn(part):
        frames = _those(frames, part, is_sure)
    if base in UNLIKELY or run.is_guess:
        is_all = part.last == len(run.elements) and [one[:2] for one in frames] == [(0, len(part.data))]
        frames = _those(frames, part, lambda frame: _is_likely(frame, run, base, is_all=is_all))
    return frames


def _goes_on(data: bytes) -> bool:
    return len(data) >= LEAST and may_start(data) and frame_size(data) > len(data)


def _those(frames: list[FrameSpan], part: Part, test: Callable[[bytes], bool]) -> list[FrameSpan]:
    return [one for one in frames if test(part.data[one.start : one.end])]


def _is_likely(frame: bytes, run: Run, base: str, *, is_all: bool) -> bool:
    """Returns whether a frame is hardly one by chance, in elements that may be anything."""
    if run.is_guess and run.has_unknown:
        return is_command(frame) and _is_known(frame, run, is_all=is_all)
    if (is_all or not run.is_guess) and base != "base64":
        return is_flawless(frame)
    return is_sure(frame) and (is_all or is_command(frame))


def _is_known(frame: bytes, run: Run, *, is_all: bool) -> bool:
    """Returns whether enough is known; where an opcode is not, the operations can't be read: the length decides."""
    known = [one.kind != "unknown" for one in run.elements]
    if is_all and all(known[:LENGTH_FIELD] + known[HEADER_SIZE - 1 : HEADER_SIZE]):
        return True
    return sum(known) * 2 > len(known) and known[:LENGTH_FIELD] != [True, False] and is_sure(frame)


def _worth(run: Run, parts: list[tuple[Part, list[FrameSpan]]]) -> Worth:
    if not parts:
        return Worth()
    size = sum(one.end - one.start for _, frames in parts for one in frames)
    natural = sum(one.end - one.start for _, frames in parts for one in frames if one.is_natural)
    last, frames = parts[-1]
    has_rest = last.last < len(run.elements) or any(last.data[frames[-1].end :])
    return Worth(natural == size and not has_rest, natural, size)

"""Where packets are missing in a capture, the messages that are whole are found: by both readers, in the same way."""

from __future__ import annotations

import io
from collections import Counter
from collections.abc import Callable, Iterator

import pytest
from support.frames import Segment
from support.losses import lossy

import ev3proto
from benchmarks.dialogue import dialogue, usual_dialogue
from ev3proto.capture import Direction, Record, read

COUNT = 300
SIZES = {"bytes": (1, 5), "pieces": (1, 20), "parts": (8, 60), "segments": (50, 400)}

# The shares are those that were found, a little less. On RFCOMM nothing tells of a gap: where one or two bytes of a
# frame are missing, what is left may well be a frame that ends in the next one.
LEAST = {"tcp": 0.998, "rfcomm": 0.986}
LEAST_IN_BYTES = {"tcp": 0.99, "rfcomm": 0.93}
MOST_INVENTED = {"tcp": 0.01, "rfcomm": 0.03}
MOST_INVENTED_IN_BYTES = {"tcp": 0.02, "rfcomm": 0.15}


def speeds(count: int) -> Iterator[Segment]:
    """Commands without a reply of the same operation again and again, in whose middle others seem to begin."""
    for number in range(count):
        speed = ev3proto.operation("OUTPUT_SPEED", 0, 1, number % 100)
        yield Segment(True, ev3proto.direct_command(*[speed] * (number % 30 + 1), counter=number).build())


DIALOGUES: dict[str, Callable[[int], Iterator[Segment]]] = {
    "usual": usual_dialogue,
    "random": dialogue,
    "speeds": speeds,
}


def found(data: bytes) -> Counter[Segment]:
    """What the built-in reader finds in a capture."""
    records = (event for event in read(io.BytesIO(data)).events() if isinstance(event, Record))
    return Counter(Segment(record.direction is Direction.SENT, record.frame) for record in records)


@pytest.mark.parametrize("carrier", ["tcp", "rfcomm"])
@pytest.mark.parametrize("size", SIZES)
def test_the_built_in_reader_finds_what_is_whole(carrier: str, size: str) -> None:
    whole: Counter[Segment] = Counter()
    records: Counter[Segment] = Counter()
    for seed, said in enumerate(DIALOGUES.values()):
        capture = lossy(carrier, SIZES[size], said(COUNT), seed)
        whole += capture.whole
        records += found(capture.data)
    least, most = (LEAST_IN_BYTES, MOST_INVENTED_IN_BYTES) if size == "bytes" else (LEAST, MOST_INVENTED)
    assert (whole - records).total() <= (1 - least[carrier]) * whole.total()
    assert (records - whole).total() <= most[carrier] * whole.total()

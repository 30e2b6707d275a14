"""How a timeline says durations, counts and times."""

from __future__ import annotations

from collections import Counter

from ev3proto.capture.record import NANOSECONDS, utc
from ev3proto.capture.timeline.marks import MarkState, Tally, Timeline

_MILLISECOND = NANOSECONDS // 1000


def duration(nanoseconds: float) -> str:
    """`0.35 ms`, `41 ms`, `1.23 s`: three digits."""
    unit, of_it = ("ms", _MILLISECOND) if nanoseconds < NANOSECONDS else ("s", NANOSECONDS)
    number = nanoseconds / of_it
    return f"{number:,.0f} {unit}" if number >= 100 else f"{number:.3g} {unit}"


def exact(nanoseconds: int) -> str:
    """`41.250 ms`: every microsecond."""
    return f"{nanoseconds / _MILLISECOND:,.3f} ms"


def clock(time_ns: int) -> str:
    """`2024-01-31 09:12:31.011558 UTC`."""
    return f"{utc(time_ns).removesuffix('Z').replace('T', ' ')} UTC"


def count(number: int, what: str, plural: str | None = None) -> str:
    """`1 message`, `20,000 messages`."""
    return f"{number:,} {what if number == 1 else plural or f'{what}s'}"


def extent(timeline: Timeline, nanoseconds: int) -> str:
    """A part of the axis: `1.23 s`, or without times `12 lines`."""
    return duration(nanoseconds) if timeline.is_timed else count(-(-nanoseconds // NANOSECONDS), "line")


def summary(timeline: Timeline) -> list[str]:
    """The lines under the title: when, how long, how much, how it went; what is not shown one by one."""
    length = timeline.end_ns - timeline.begin_ns
    when = (
        f"from {clock(timeline.begin_ns)}, {duration(length)}" if timeline.is_timed else "in their order, without times"
    )
    lines = [f"{when}: {', '.join((count(timeline.messages, 'message'), *_troubles(timeline.outcomes)))}"]
    if timeline.bin_ns:
        below = ", and below is the slowest answer in that time" if timeline.is_timed else ""
        lines.append(
            f"Too much to mark one by one: the darker, the more in {extent(timeline, timeline.bin_ns)};"
            f" what went wrong has marks{below}."
        )
    else:
        lines.append("A mark stands where a command was sent, and its bar reaches to the reply.")
    if timeline.unshown:
        lines.append(f"{count(timeline.unshown, 'mark')} of errors and files omitted: there are too many.")
    return lines


def _troubles(outcomes: Counter[MarkState]) -> list[str]:
    words = {
        MarkState.ERROR: ("answered with an error", "answered with an error"),
        MarkState.UNANSWERED: ("never answered", "never answered"),
        MarkState.FAULTY: ("faulty frame", "faulty frames"),
        MarkState.SKIPPED: ("gap with bytes skipped", "gaps with bytes skipped"),
        MarkState.CUT_SHORT: ("file not moved whole", "files not moved whole"),
    }
    return [count(outcomes[outcome], *said) for outcome, said in words.items() if outcomes[outcome]]


def brick_summary(tally: Tally) -> str:
    """The line beside a brick's name: how much, and how long it took to answer."""
    said = [count(tally.messages, "message")]
    latency = tally.latencies.percentiles()
    if latency is not None:
        said.append(f"median answer {duration(latency.median * NANOSECONDS)}")
        said.append(f"slowest {duration(latency.max * NANOSECONDS)}")
    return ", ".join(said)

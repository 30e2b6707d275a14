"""`ev3proto stats`: the contents of captures, counted, as tables or JSON."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence

import click

from ev3proto.capture import Account
from ev3proto.capture.latencies import ACCURACY, EXACT, Percentiles
from ev3proto.capture.statistics import Amount, Noted, PeerSummary, Statistics, Summary, TransferSummary
from ev3proto.cli.output import say, say_json
from ev3proto.cli.reading import Problems, captures_of, reading_options
from ev3proto.cli.tables import Tables
from ev3proto.errors import counted
from ev3proto.reading.options import Options

_MILLISECONDS = 1000


@click.command()
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@reading_options
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def stats(files: tuple[str, ...], reading: Options, as_json: bool) -> None:
    """Counts the messages, errors and files in captures and logs.

    Shows messages by kind and by operation, latencies, errors, unanswered commands, transferred files, and what each
    captured byte is, for all files together. --filter applies to all but the last.

    \b
      ev3proto stats robot.pcapng
      ev3proto stats robot.pcapng --filter 'op==UI_READ' --json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    statistics, captures, problems = Statistics(), captures_of(files, reading), Problems()
    for event in problems.captured(captures.events()):
        statistics.add(event)
    account = captures.account
    summary = statistics.summary(account)
    has_matches = reading.filter is None or summary.whole.messages.messages > 0
    if account.packets and has_matches:
        if as_json:
            say_json(summary.as_dict())
        else:
            _Page(summary, captures.unit).show()
    sys.exit(problems.status)


class _Page:
    def __init__(self, summary: Summary, unit: str) -> None:
        self._summary = summary
        self._unit = unit
        # With only one brick, its column is omitted.
        self._tables = Tables(hidden=() if len({peer.name for peer in summary.peers}) > 1 else ("brick",))

    def show(self) -> None:
        """Prints all sections that are not empty."""
        summary = self._summary
        if summary.whole.messages.messages:
            self._whole(summary.whole)
            self._connections()
        self._section("Texts around frames", ("text", "number", "bytes"), _amounts(summary.texts))
        self._transfers()
        self._noted("Commands without a reply", summary.whole.unanswered, summary.unanswered)
        self._noted("Frames with a fault", summary.whole.faults, summary.faults)
        self._noted(_skipped_title(summary), summary.skipped_pieces, summary.skipped)
        if summary.account is not None:
            self._account(summary.account)

    def _whole(self, whole: PeerSummary) -> None:
        if whole.first is not None:
            self._tables.heading(f"Time: {whole.first} to {whole.last}, {whole.seconds:.6f} s")
        kinds = _amounts(whole.kinds)
        if len(kinds) > 1:
            kinds += _amounts({"all": whole.messages})
        self._section("Messages", ("kind", "messages", "bytes"), kinds)
        self._operations(whole)
        if whole.orphans:
            self._tables.heading(f"Replies whose command was not seen: {whole.orphans}")

    def _operations(self, whole: PeerSummary) -> None:
        titles = ("operation", "uses", "commands", "replies", "errors", "no reply", "bytes")
        rows = [
            (
                entry.name,
                *map(str, (entry.uses, entry.commands, entry.replies)),
                *map(_some, (entry.errors, entry.unanswered)),
                str(entry.bytes),
            )
            for entry in whole.operations
        ]
        self._section("Operations", titles, rows)
        latencies = [(entry.name, entry.latency) for entry in whole.operations]
        if len(latencies) > 1:
            latencies.append(("all replies", whole.latency))
        times = [(name, *_milliseconds(latency)) for name, latency in latencies if latency is not None]
        self._section("Milliseconds from command to reply", ("operation", "replies", *_LATENCY), times)
        if whole.latency is not None and not whole.latency.exact:
            say(f"Of more than {EXACT} replies, median, p90 and p99 are right to {ACCURACY:.0%}.")

    def _connections(self) -> None:
        titles = ("connection", "brick", "messages", "bytes", "errors", "no reply", "max ms", "longest gap ms")
        rows = [
            (
                str(peer.connection),
                peer.name,
                *map(str, (peer.messages.messages, peer.messages.bytes)),
                *map(_some, (peer.errors, peer.unanswered)),
                "" if peer.latency is None else f"{peer.latency.max * _MILLISECONDS:.3f}",
                "" if peer.gap is None else f"{peer.gap * _MILLISECONDS:.3f}",
            )
            for peer in self._summary.peers
        ]
        self._section("Connections; a gap is the time between two replies", titles, rows)
        if self._summary.peers_left_out:
            say(f"{self._summary.peers_left_out} messages of further connections are only counted in all")

    def _transfers(self) -> None:
        rows = [
            (
                entry.path,
                entry.direction,
                str(entry.bytes),
                "" if entry.size is None else str(entry.size),
                _state(entry),
                f"{entry.seconds:.6f}",
                "" if entry.rate is None else f"{entry.rate:.0f}",
                str(entry.packet),
                entry.peer,
            )
            for entry in self._summary.transfers
        ]
        titles = ("path", "direction", "bytes", "of", "state", "seconds", "bytes/s", self._unit, "brick")
        self._section("Files and listings", titles, rows, self._summary.transfers_left_out)

    def _noted(self, title: str, count: int, noted: Sequence[Noted]) -> None:
        rows = [(str(entry.packet), entry.peer, entry.text) for entry in noted]
        self._section(f"{title}: {count}", (self._unit, "brick", "what"), rows, count - len(noted))

    def _account(self, account: Account) -> None:
        rows = [(name, str(count), _share(count, account.captured)) for name, count in account.parts.items() if count]
        if account.balance:
            rows.append(("not read", str(account.balance), _share(account.balance, account.captured)))
        rows.append(("all", str(account.captured), ""))
        many = counted(account.packets, "packet" if self._unit == "packet" else "frame")
        self._section(f"Captured bytes, in {many}", ("part", "bytes", "share"), rows)

    def _section(self, heading: str, titles: Sequence[str], rows: Sequence[Sequence[str]], more: int = 0) -> None:
        """Prints a heading, a table, and the number of omitted rows; without rows, nothing."""
        if rows:
            self._tables.heading(heading)
            self._tables.table(titles, rows)
        if more:
            say(f"and {more} more")


_LATENCY = ("min", "median", "p90", "p99", "max")


def _amounts(amounts: Mapping[str, Amount]) -> list[tuple[str, str, str]]:
    return [(name, str(amount.messages), str(amount.bytes)) for name, amount in amounts.items()]


def _some(count: int) -> str:
    return str(count or "")


def _milliseconds(latency: Percentiles) -> Iterator[str]:
    yield str(latency.count)
    for name in _LATENCY:
        yield f"{getattr(latency, name) * _MILLISECONDS:.3f}"


def _state(transfer: TransferSummary) -> str:
    if transfer.complete:
        return ""
    return "refused" if transfer.failed and not transfer.bytes else "failed" if transfer.failed else "incomplete"


def _skipped_title(summary: Summary) -> str:
    missing = f", {summary.missing_bytes} more were not captured" if summary.missing_bytes else ""
    return f"Skipped, {summary.skipped_bytes} bytes{missing}"


def _share(count: int, whole: int) -> str:
    return f"{count / whole:.1%}"

"""`ev3proto proxy`: a relay between a program and a brick that shows and records the dialogues."""

from __future__ import annotations

import ipaddress
import sys
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, closing, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO, cast

import click

from ev3proto.brick.servers.host import Faults
from ev3proto.capture.dialogues import RequestReply
from ev3proto.cli.ending import stopped_by_signals
from ev3proto.cli.faults import fault_options
from ev3proto.cli.formats import made
from ev3proto.cli.options import SerialNumber, dialect_option, exclusive, json_option
from ev3proto.cli.output import Failure, complain, failing_to, flush, refuse_terminal, say, writing_output
from ev3proto.cli.show import Dialogues
from ev3proto.cli.targets import target_option
from ev3proto.cli.unblocked import unblocked_output
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import open_wire
from ev3proto.link.errors import LinkError
from ev3proto.link.masking import masked_note
from ev3proto.link.proxy import Proxy, ProxyOptions
from ev3proto.link.serial_number import announced_number
from ev3proto.link.targets import Target, Way
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.whole_files import GrowingFile

_LOOPBACK = "127.0.0.1"


@click.command()
@click.option(
    "--listen",
    default="wifi",
    show_default=True,
    metavar="wifi[:ADDRESS[:PORT]]",
    help="Address to listen on; by default only this computer's, and port 5555.",
)
@target_option
@click.option("--beacon/--no-beacon", default=True, help="Announce the proxy by UDP beacon, as a brick does.")
@click.option(
    "--serial-number",
    type=SerialNumber(),
    metavar="HEX",
    help="Serial number that the beacon announces, 12 hexadecimal digits; by default the brick's own.",
)
@click.option("--record", metavar="FILE", help="Record to this capture file (pcapng); - is standard output.")
@click.option("--force", is_flag=True, help="Overwrite the file of --record, if it exists.")
@click.option("--read-only", is_flag=True, help="Forward only commands that read.")
@click.option(
    "--hide",
    is_flag=True,
    help="Mask names, addresses, PINs, contents of files and messages in what is recorded and shown. Replies show"
    " values only if their commands only read, and have counters of their own. Paths are not masked.",
)
@click.option("--from", "only_from", metavar="ADDRESS", help="Serve only clients with this address.")
@fault_options
@json_option
@dialect_option
@exclusive("--record=-", "--json", reason="both write to standard output")
def proxy(
    listen: str,
    target: Target,
    beacon: bool,
    serial_number: str | None,
    record: str | None,
    force: bool,
    read_only: bool,
    hide: bool,
    only_from: str | None,
    faults: Faults,
    as_json: bool,
    dialect: str,
) -> None:
    """Relays between a program and a brick, shows the dialogues and records them.

    The program connects to the proxy as to a WiFi brick; the real one may be on USB, Bluetooth or WiFi. This needs
    neither a sniffer nor special permissions. One client is served at a time, with --read-only many are served in turn.
    The first line of the output says where the proxy listens; Ctrl-C ends it.

    \b
      ev3proto proxy --to usb
      ev3proto proxy --listen wifi:127.0.0.1:5556 --to wifi --record talk.pcapng
      ev3proto proxy --to usb --record - | wireshark -k -i -
    """  # noqa: D301 - the mark by which click leaves lines as they are
    address, port = _place(listen)
    options = ProxyOptions(address, port, _address(only_from), read_only, hide, faults, dialect)
    with unblocked_output(), ExitStack() as stack:
        recording = _recording(record, stack, force)
        shown = _Shown(as_json=as_json, is_quiet=record == "-")
        with _failing(target, is_masked=hide):
            wire = open_wire(target)
            stack.callback(wire.close)
            if beacon:
                options = replace(options, announced=serial_number or announced_number(target, wire))
            relay = Proxy(
                wire,
                str(target),
                options,
                show=shown,
                say=complain,
                recording=recording,
                reopen=lambda: open_wire(target),
            )
            if recording is not None:
                # Only now: a proxy that cannot begin leaves the old file as it was.
                with _recording_to(record):
                    recording.flush()
        shown.start_ns = relay.records.start_ns
        if not ipaddress.ip_address(address).is_loopback:
            complain(f"Anyone who can reach {address} can control the brick through this proxy (--from, --read-only).")
        tell = complain if record == "-" else say
        with stopped_by_signals(relay.stop):
            tell(f"listening on {f'[{address}]' if ':' in address else address}:{relay.port}")
            flush()
            relay.serve()
    if relay.lost is not None:
        raise Failure(str(relay.lost))


class _Shown:
    def __init__(self, *, as_json: bool, is_quiet: bool) -> None:
        self.start_ns = 0
        self._dialogues = None if is_quiet else Dialogues(made("json" if as_json else None))

    def __call__(self, pair: RequestReply) -> None:
        if self._dialogues is not None:
            self._dialogues.show(pair, self.start_ns)
            flush()


@contextmanager
def _failing(target: Target, *, is_masked: bool) -> Iterator[None]:
    """Ends the program if the brick cannot be reached, without naming it if names are masked."""
    try:
        yield
    except LinkError as error:
        text = str(error)
        raise Failure(masked_note(text.replace(target.host or "\0", "x")) if is_masked else text) from None


def _place(listen: str) -> tuple[str, int]:
    try:
        found = Target.parse(listen) if not listen.endswith(":0") else Target.parse(listen[:-2])
        if found.way is not Way.WIFI:
            raise ValueError(f"cannot listen at {listen!r}; expected wifi, wifi:ADDRESS or wifi:ADDRESS:PORT")
        address = found.host or _LOOPBACK
        ipaddress.ip_address(address)
    except ValueError as error:
        raise click.BadParameter(str(error), param_hint="'--listen'") from None
    return address, 0 if listen.endswith(":0") else found.port or TCP_PORT


def _address(text: str | None) -> str | None:
    if text is None:
        return None
    try:
        return str(ipaddress.ip_address(text))
    except ValueError:
        expected = "expected one such as 192.0.2.1"
        raise click.BadParameter(f"invalid address {text[:60]!r}; {expected}", param_hint="'--from'") from None


def _recording(record: str | None, stack: ExitStack, force: bool) -> Recording | None:
    """Starts the recording, if there is one. Ends the program if it cannot be written."""
    if record is None:
        return None
    with _recording_to(record):
        if record == "-":
            refuse_terminal(None, "a capture", option="--record")
            return Recording(sys.stdout.buffer)
        return Recording(cast(BinaryIO, stack.enter_context(closing(GrowingFile(Path(record), force=force)))))


def _recording_to(record: str | None) -> AbstractContextManager[object]:
    return writing_output() if record in ("-", None) else failing_to("written", record)

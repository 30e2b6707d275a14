"""`ev3proto extcap`: the proxy in Wireshark's list of interfaces, by Wireshark's extcap."""

from __future__ import annotations

import errno
from contextlib import closing, suppress
from dataclasses import replace
from pathlib import Path
from threading import Event
from typing import BinaryIO, cast

import click

from ev3proto.cli.ending import stopped_by_signals
from ev3proto.cli.options import PATH, PORT
from ev3proto.cli.output import Failure, complain, failing_on, failing_to, say
from ev3proto.cli.targets import TargetType
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import Wire, open_wire
from ev3proto.link.errors import ConnectionLostError, LinkError
from ev3proto.link.proxy import Proxy, ProxyOptions
from ev3proto.link.serial_number import announced_number
from ev3proto.link.targets import Target
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.version import VERSION

INTERFACE = "ev3proxy"
"""The name of the interface; Wireshark shows it as "EV3 proxy"."""

_ETHERNET = 1
"""The link type of recordings, as libpcap numbers it."""

_LOOPBACK = "127.0.0.1"

_RETRY = 1.0
"""Seconds between attempts to connect to a brick that vanished."""

_CONFIGURATION = (
    "arg {number=0}{call=--target}{display=Brick}{type=string}{default=usb}{required=true}"
    "{tooltip=usb, wifi, wifi:HOST, bluetooth:MAC, serial:PORT or virtual}",
    f"arg {{number=1}}{{call=--port}}{{display=Port}}{{type=unsigned}}{{range=1,65535}}{{default={TCP_PORT}}}"
    "{tooltip=Programs connect to this port of 127.0.0.1}",
    "arg {number=2}{call=--read-only}{display=Read only}{type=boolflag}{default=false}"
    "{tooltip=Block commands that change the brick}",
)


_FIFOS: list[BinaryIO] = []


def _opened(fifo: Path) -> BinaryIO:
    """Opens the FIFO until this process ends: once it is closed, Wireshark shows no error message. Raises OSError."""
    if fifo.is_file() and fifo.stat().st_size:
        raise FileExistsError(errno.EEXIST, "it is a file with contents; expected a FIFO", str(fifo))
    stream = fifo.open("wb")
    _FIFOS.append(stream)
    return stream


class _Extcap(click.Command):
    """A command that opens the FIFO also if it refuses its options: until then Wireshark waits, and shows no error."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        words = list(args)
        try:
            return super().parse_args(ctx, args)
        except click.UsageError:
            for word, following in zip(words, [*words[1:], ""], strict=True):
                name, _, path = word.partition("=")
                if name == "--fifo":
                    with suppress(OSError):
                        _opened(Path(path or following))
            raise


@click.command(cls=_Extcap, context_settings={"ignore_unknown_options": True, "allow_extra_args": True})
@click.option("--extcap-interfaces", "lists_interfaces", is_flag=True, help="List the interfaces.")
@click.option("--extcap-dlts", "lists_link_types", is_flag=True, help="List the link types of the interface.")
@click.option("--extcap-config", "lists_options", is_flag=True, help="List the options of the interface.")
@click.option("--extcap-interface", "interface", metavar="NAME", help=f"Name of the interface: {INTERFACE}.")
@click.option("--capture", is_flag=True, help="Capture until interrupted.")
@click.option("--fifo", type=PATH, metavar="PATH", help="Where to write the capture.")
@click.option("--target", type=TargetType(), default="usb", show_default=True, help="Brick, as for `ev3proto send`.")
@click.option("--port", type=PORT, default=TCP_PORT, show_default=True, help="TCP port to listen on.")
@click.option("--read-only", is_flag=True, help="Block commands that change the brick.")
def extcap(
    lists_interfaces: bool,
    lists_link_types: bool,
    lists_options: bool,
    interface: str | None,
    capture: bool,
    fifo: Path | None,
    target: Target,
    port: int,
    read_only: bool,
) -> None:
    """Captures for Wireshark through `ev3proto proxy`; Wireshark runs this, users do not.

    `ev3proto dissector install` writes a launcher to Wireshark's personal extcap folder. Then "EV3 proxy" is in the
    list of interfaces. Start it, and connect a program to port 5555 of this computer, as to a brick. This needs neither
    root nor a sniffer.

    \b
      ev3proto extcap --extcap-interfaces
      ev3proto extcap --extcap-interface ev3proxy --extcap-config
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if lists_interfaces:
        say(f"extcap {{version={VERSION}}}{{display=ev3proto}}")
        say(f"interface {{value={INTERFACE}}}{{display=EV3 proxy}}")
        return
    if interface != INTERFACE:
        raise click.UsageError(f"give --extcap-interfaces, or --extcap-interface {INTERFACE}")
    if lists_link_types:
        say(f"dlt {{number={_ETHERNET}}}{{name=EN10MB}}{{display=Ethernet}}")
    elif lists_options:
        for line in _CONFIGURATION:
            say(line)
    elif capture and fifo is not None:
        _capture(fifo, target, ProxyOptions(_LOOPBACK, port, is_read_only=read_only))
    else:
        raise click.UsageError("give --extcap-dlts, --extcap-config, or --capture with --fifo PATH")


def _capture(fifo: Path, target: Target, options: ProxyOptions) -> None:
    """Runs the proxy until Wireshark ends it or stops reading. When the brick vanishes, waits until it is back."""
    with failing_to("written", fifo):
        pipe = _Pipe(_opened(fifo))
    wire: Wire | None = _wire_to(target)
    recording: Recording | None = None
    while wire is not None:
        with closing(wire):
            if recording is None:
                with failing_on(LinkError):
                    options = replace(options, announced=announced_number(target, wire))
                with failing_to("written", fifo):
                    recording = Recording(cast(BinaryIO, pipe))
                    recording.flush()
            lost = _serve(wire, target, options, recording, pipe)
        if lost is None:
            return
        complain(f"{lost}; waiting for the brick, then listening again")
        wire = _wire_again(target)


def _serve(
    wire: Wire, target: Target, options: ProxyOptions, recording: Recording, pipe: _Pipe
) -> ConnectionLostError | None:
    """Runs the proxy. Returns why the connection to the brick was lost, None if the capture is over."""
    with failing_on(LinkError):
        proxy = Proxy(
            wire,
            str(target),
            options,
            show=lambda _pair: None,
            say=complain,
            recording=recording,
            reopen=lambda: open_wire(target),
        )
    pipe.proxy = proxy
    with stopped_by_signals(proxy.stop):
        proxy.serve()
    return proxy.lost


def _wire_again(target: Target) -> Wire | None:
    """Connects to a brick that vanished, as soon as it is back. Returns None if the capture ends before."""
    over = Event()
    with stopped_by_signals(over.set):
        while not over.wait(_RETRY):
            with suppress(LinkError, OSError):
                return open_wire(target)
    return None


def _wire_to(target: Target) -> Wire:
    """Connects to the brick. Ends the program if that fails, also if a library's files cannot be read."""
    try:
        return open_wire(target)
    except LinkError as error:
        raise Failure(str(error)) from None
    except OSError as error:
        raise Failure(f"cannot connect to {target}: {error}") from None


class _Pipe:
    """The pipe to Wireshark. It stops the proxy when Wireshark has stopped the capture."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self.proxy: Proxy | None = None

    def write(self, data: bytes) -> int:
        """Writes bytes. Raises OSError."""
        return self._stream.write(data)

    def flush(self) -> None:
        """Flushes the pipe. Raises OSError."""
        try:
            self._stream.flush()
        except OSError:
            if self.proxy is not None:
                self.proxy.stop()
            raise

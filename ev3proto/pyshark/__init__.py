"""Captures dissected by tshark: `read` runs it; the rest is for programs that read or capture with pyshark.

    import pyshark
    import ev3proto.pyshark

    packets = pyshark.FileCapture("robot.pcapng", custom_parameters=ev3proto.pyshark.parameters())
    for packet in packets:
        for record in ev3proto.pyshark.messages(packet):
            print(packet.number, record.message, record.values)

`LiveCapture` works the same way. This needs `pip install 'ev3proto[wireshark]'` and tshark; `read` needs only tshark.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Collection, Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, BinaryIO

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture import Account, Capture, CaptureError, Event, Record
from ev3proto.capture.formats import CaptureFile
from ev3proto.pyshark.events import FIELDS, Events, Row
from ev3proto.pyshark.packets import frame_of, row_of
from ev3proto.pyshark.tshark import Run, Tshark
from ev3proto.tables import check_dialect
from ev3proto.temporary import temporary_folder

__all__ = ["Messages", "messages", "parameters", "read"]

_KEPT = ExitStack()
"""The dissector's file, which exists while the program runs."""


def parameters(
    *,
    dialect: str = "official",
    ports: Collection[int] = (),
    tshark: str | None = None,
    use_ek: bool = False,
) -> list[str]:
    """Returns the parameters with which pyshark runs tshark with the dissector, installed or not.

    Args:
        dialect: The firmware whose instruction set is used.
        ports: TCP ports on which bricks listen: all their traffic is read, recognised or not. Without any, traffic on
            port 5555 is read if it is recognised.
        tshark: Path of the tshark that pyshark uses (its `tshark_path`), if it is not on PATH.
        use_ek: Whether pyshark uses that option, too. By default it does not know the fields of a Lua dissector in that
            mode, and raises when one is requested. This adds them.

    Returns:
        Words for `custom_parameters` of `pyshark.FileCapture` and `pyshark.LiveCapture`.

    Raises:
        ev3proto.capture.CaptureError: No usable tshark was found.
        ValueError: The dialect is unknown.
    """
    program = Tshark(tshark)
    words = _KEPT.enter_context(program.parameters(check_dialect(dialect), ports))
    if use_ek:
        import pyshark.ek_field_mapping  # an extra; without `use_ek` only the caller needs it

        said = json.loads(program.ask("-G", "elastic-mapping", *words), object_pairs_hook=_merged)
        known = said["mappings"]["properties"]["layers"]["properties"]
        # There is no public way: pyshark asks tshark without the parameters of a capture.
        pyshark.ek_field_mapping.MAPPING._protocol_to_mapping = known
    return words


def _merged(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Returns an object of tshark's JSON, in which a protocol may occur twice, once without fields."""
    found: dict[str, Any] = {}
    for name, value in pairs:
        if name not in found or value != {"properties": {}}:
            found[name] = value
    return found


class Messages:
    """The messages of one capture, packet by packet. Call it with each packet, in order.

    Args of a call: a packet of pyshark. It returns the records of the frames that end in that packet.
    """

    def __init__(self, *, dialect: str = "official") -> None:
        """Starts before the first packet.

        Args:
            dialect: The firmware whose instruction set is used.

        Raises:
            ValueError: The dialect is unknown.
        """
        self._events = Events(Account(), check_dialect(dialect))
        self.last_packet = 0

    def __call__(self, packet: Any) -> list[Record]:
        """Returns the records of the frames that end in a packet, each with the record of the command it answers."""
        row = row_of(packet)
        self.last_packet = row.packet
        return [event for event in self._events.of(row) if isinstance(event, Record)]


_default = Messages()


def messages(packet: Any) -> list[Record]:
    """Returns the messages that end in a packet, each linked to its command.

    Pass every packet of one capture, in order. A packet whose number is not higher than the last one's starts a new
    capture. For simultaneous captures, or another dialect, create a `Messages` for each.

    Args:
        packet: A packet of pyshark, in its XML or EK mode, captured with `parameters()`.

    Returns:
        A record for each frame: its `message`, for a reply its `values` and `request`, the record of the command. Its
        `numbers` and `time` are those of the packet in which the frame ends.

    Raises:
        TypeError: It is not a packet of pyshark.
    """
    global _default
    if int(frame_of(packet).number) <= _default.last_packet:
        _default = Messages()
    return _default(packet)


def read(
    source: str | os.PathLike[str] | BinaryIO | CaptureFile,
    *,
    dialect: str = "official",
    ports: Collection[int] = (),
    tshark: str | None = None,
    memory: int = DEFAULT_MEMORY,
) -> Capture:
    """Reads the records of a capture file, like `ev3proto.capture.read`, in all formats and link types of Wireshark.

    It requests only a few fields of each packet, which takes a tenth of the time of pyshark.

    Args:
        source: A path, a stream at its start, or a CaptureFile. A stream is copied into a temporary file for tshark.
        dialect: The firmware whose instruction set is used.
        ports: TCP ports on which bricks listen: all their traffic is read, recognised or not. Without any, traffic on
            port 5555 is read if it is recognised.
        tshark: Path of tshark, if it is not on PATH.
        memory: Memory limit for unanswered commands, in bytes.

    Returns:
        The capture. A record has the number and time of the packet in which its frame ends. Bytes that are not
        frames to Wireshark are counted in `account` as `other`. Reading raises CaptureError, after everything
        readable, with tshark's message.

    Raises:
        OSError: The file cannot be opened.
        CaptureError: No usable tshark was found.
        ValueError: The dialect is unknown.
    """
    account = Account()
    events = Events(account, check_dialect(dialect), memory)
    with ExitStack() as stack:
        path = _file(source, stack)
        program = Tshark(tshark)
        words = stack.enter_context(program.parameters(dialect, ports))
        if _is_cut(path):
            words += ["-o", "tcp.reassemble_out_of_order:FALSE"]  # which never goes on after a cut segment
        for field in FIELDS:
            words += ["-e", field]
        return Capture(_events(program, [*words, "-T", "ek", "-r", str(path)], events, stack.pop_all()), account)


def _is_cut(path: Path) -> bool:
    """Returns whether a packet was captured in part, as far as the file is read here."""
    with CaptureFile.at(path) as file, suppress(CaptureError):
        return file.is_capture and any(len(packet.data) < packet.size for packet in file.packets())
    return False


def _events(program: Tshark, words: list[str], events: Events, stack: ExitStack) -> Iterator[Event]:
    with stack, Run(program, *words) as run:
        for line in run.output:
            if line.startswith(b'{"timestamp"'):  # between them are lines for an index
                yield from events.of(Row(json.loads(line.decode("utf-8", "replace"))["layers"]))
        run.check()


def _file(source: str | os.PathLike[str] | BinaryIO | CaptureFile, stack: ExitStack) -> Path:
    """Returns a file that tshark can read: the given one, or a temporary copy of a stream."""
    if isinstance(source, CaptureFile):
        stack.callback(source.close)
        source = source.contents
    if isinstance(source, str | os.PathLike):
        with Path(source).open("rb"):
            return Path(source).absolute()
    copy = stack.enter_context(temporary_folder()) / "capture"
    with copy.open("wb") as stream:
        shutil.copyfileobj(source, stream)
    return copy

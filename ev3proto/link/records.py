"""Records of the frames to and from a brick, like those from a capture."""

from __future__ import annotations

import time
from collections.abc import Callable

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.record import HOST, Direction, Outcome, Record, Route
from ev3proto.schema.frame import frame_reader
from ev3proto.tables.carriers import Carrier


class Records:
    """Makes records of one connection, numbered in their order or by the packets of its recording."""

    def __init__(
        self, carrier: Carrier, peer: str, dialect: str = "official", packets: Callable[[], int] | None = None
    ) -> None:
        """Starts at number 1; `packets` returns the number of recorded packets, the frame's own included."""
        self._packets = packets
        self.start_ns = time.time_ns()
        self._sent = Route(carrier, HOST, peer, Direction.SENT, None, peer)
        self._received = Route(carrier, peer, HOST, Direction.RECEIVED, None, peer)
        self._schema = frame_reader(dialect)
        self._count = 0

    def sent(self, frame: bytes) -> Record:
        """Returns a frame that goes to the brick now."""
        return self._record(frame, self._sent, None)

    def received(self, frame: bytes, request: Record | None, note: str | None = None) -> Record:
        """Returns a frame that comes from the brick now; `request` is the command that it answers."""
        record = self._record(frame, self._received, request)
        record.note = note
        return record

    def _record(self, frame: bytes, route: Route, request: Record | None) -> Record:
        self._count += 1
        number = self._packets() if self._packets is not None else self._count
        record = Record(frame, (number,), time.time_ns(), route, self._schema, request)
        if request is not None:
            request.answered = Outcome(record.time_ns, failed=is_error(record.message))
        return record

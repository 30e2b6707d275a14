"""What a carrier transports: frames, each with its direction, and the packets around them."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from ev3proto.errors import BuildError
from ev3proto.schema.header import HEADER_SIZE, frame_size, may_be_long
from ev3proto.tables.frame import LENGTH_FIELD, MAX_LENGTH, MIN_LENGTH, REPLY_TYPES


class TimedFrame(NamedTuple):
    """A frame and the time when it was captured, in nanoseconds since 1970-01-01 UTC."""

    frame: bytes
    time_ns: int


class CarrierWriter(Protocol):
    """The packets that one carrier puts around the frames of a conversation, in the order of the calls."""

    def opening(self) -> list[bytes]:
        """Returns the packets before the first frame."""

    def between(self, is_from_host: bool) -> list[bytes]:
        """Returns the packets after a frame and before the next one, whose direction is given."""

    def frame(self, frame: bytes, is_from_host: bool) -> list[bytes]:
        """Returns the packets that carry a frame; the last one completes it."""

    def closing(self) -> list[bytes]:
        """Returns the packets after the last frame."""

    def stamped(self, packet: bytes, time_ns: int) -> bytes:
        """Returns a packet with its time, for carriers whose packets include it."""


def goes_to_brick(frame: bytes) -> bool:
    """Tells whether a frame goes to the brick, by its message type: everything except replies does."""
    return frame[HEADER_SIZE - 1] not in REPLY_TYPES


def check_frame(frame: bytes) -> None:
    """Checks that a receiver sees where a frame ends. Raises BuildError."""
    length = frame_size(frame) - LENGTH_FIELD if len(frame) >= LENGTH_FIELD else 0
    if len(frame) < HEADER_SIZE or length + LENGTH_FIELD != len(frame):
        raise BuildError(
            f"it cannot be carried: its length field says that {length} bytes follow, but"
            f" {max(len(frame) - LENGTH_FIELD, 0)} do"
        )
    if length > MAX_LENGTH and not may_be_long(frame):
        raise BuildError(
            f"it cannot be carried: its length field says {length}, but it can be {MIN_LENGTH} to {MAX_LENGTH}"
        )

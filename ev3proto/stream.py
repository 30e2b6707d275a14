"""A byte stream in any chunks to whole messages. No I/O: somebody else reads the socket, the port or the file."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.errors import DecodeError, Fault
from ev3proto.messages import Message
from ev3proto.schema.frame import frame_schema
from ev3proto.schema.header import frame_size, impossible_length, is_frame_size
from ev3proto.tables.frame import LENGTH_FIELD


class StreamError(DecodeError):
    """The stream cannot be cut into frames any more; `offset` counts from the stream's first byte."""


class Decoder:
    """Cuts a stream into frames and yields their messages.

    strict   False: contents never raise, `message.fault` tells; a length that no frame can have raises all the same,
             because nobody can say where the next frame starts
    dialect  the firmware whose instruction set to read by

    It keeps at most one unfinished frame beside the chunk it was last given.
    """

    def __init__(self, *, strict: bool = True, dialect: str = "official") -> None:
        self._schema = frame_schema(dialect)
        self._strict = strict
        self._buffer = bytearray()
        self._position = 0
        self._lost: StreamError | None = None

    @property
    def position(self) -> int:
        """Offset in the stream of the first byte that belongs to no message yet."""
        return self._position

    @property
    def pending(self) -> bytes:
        """The bytes of the frame that is not complete yet."""
        return bytes(self._buffer)

    def feed(self, chunk: bytes) -> Iterator[Message]:
        """The messages that are complete with this chunk. What is not taken from the iterator comes with the next one.

        The iterator raises StreamError for a length that no frame can have (and again whenever it is fed after that),
        and in strict mode DecodeError for a faulty frame; the frames behind that one can still be read.
        """
        if self._lost is None:
            self._buffer += chunk
        return self._messages()

    def _messages(self) -> Iterator[Message]:
        if self._lost is not None:
            raise self._lost
        buffer = self._buffer
        while len(buffer) >= LENGTH_FIELD:
            size = frame_size(buffer)
            if not is_frame_size(size):
                self._lost = StreamError(self._position, impossible_length(size - LENGTH_FIELD))
                raise self._lost
            if len(buffer) < size:
                return
            frame = bytes(buffer[:size])
            del buffer[:size]
            start, self._position = self._position, self._position + size
            yield self._message(frame, start)

    def _message(self, frame: bytes, start: int) -> Message:
        if not self._strict:
            return self._schema.read_frame(frame, strict=False)
        try:
            return self._schema.read_frame(frame)
        except DecodeError as error:
            reason = f"in the frame that starts at offset {start} of the stream: {error.reason}"
            raise DecodeError(start + error.offset, reason, error.truncated) from None

    def close(self) -> Fault | None:
        """Says that nothing more will come.

        Returns None when the stream ended between two frames. Otherwise raises StreamError, or with `strict=False`
        returns what is wrong.
        """
        if not self._buffer:
            return None
        left = len(self._buffer)
        error = StreamError(
            self._position,
            f"the stream ends inside a frame, of which {left} byte{'s' * (left > 1)} came",
            truncated=True,
        )
        if self._strict:
            raise error
        return error.fault

"""The decoder of byte streams: chunks of any size to whole messages. No I/O: the caller reads the socket or file."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.errors import DecodeError, Fault, as_bytes, counted
from ev3proto.messages import Message
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.frame_buffer import FrameBuffer, OutOfStep


class StreamError(DecodeError):
    """A stream that cannot be split into frames any further; `offset` counts from the start of the stream."""


class Decoder:
    """A decoder that splits a stream into frames and yields their messages.

    It keeps at most one unfinished frame besides the last chunk. A frame has at most 1024 bytes, those
    of BEGIN_DOWNLOAD and CONTINUE_DOWNLOAD at most 65537. Two zeros between frames are a poll and are skipped.
    """

    def __init__(self, *, strict: bool = True, dialect: str = "official") -> None:
        """Starts at the beginning of a stream.

        Args:
            strict: If False, contents never raise, and `message.fault` says what is wrong. An impossible length
                still raises, because the start of the next frame is unknown.
            dialect: "official", "xtended" or "compat": the firmware whose instruction set is used.

        Raises:
            ValueError: The dialect is unknown.
        """
        self._schema = frame_reader(dialect)
        self._strict = strict
        self._buffer = FrameBuffer()
        self._lost: StreamError | None = None

    @property
    def position(self) -> int:
        """The offset in the stream of the first byte that is not yet part of a message."""
        return self._buffer.position

    @property
    def pending(self) -> bytes:
        """The bytes of the unfinished frame."""
        return self._buffer.pending

    def feed(self, chunk: bytes) -> Iterator[Message]:
        """Takes the next bytes of the stream.

        Args:
            chunk: Any number of bytes.

        Returns:
            An iterator over the messages completed by this chunk. Messages not taken from it come with the
            next chunk. The iterator raises StreamError for an impossible length, and again whenever
            the decoder is fed after that. In strict mode it raises DecodeError for a faulty frame; the frames after
            it can still be read.
        """
        if type(chunk) is not bytes:
            chunk = as_bytes(chunk, "a chunk of a stream")
        if self._lost is None:
            self._buffer.append(chunk)
        return self._messages()

    def _messages(self) -> Iterator[Message]:
        if self._lost is not None:
            raise self._lost
        while (frame := self._buffer.next()) is not None:
            if isinstance(frame, OutOfStep):
                self._lost = StreamError(self.position, frame.reason)
                raise self._lost
            yield self._message(frame, self.position - len(frame))

    def _message(self, frame: bytes, start: int) -> Message:
        try:
            return self._schema.read_frame(frame, strict=self._strict)
        except DecodeError as error:
            reason = f"in the frame that starts at offset {start} of the stream: {error.reason}"
            raise DecodeError(start + error.offset, reason, error.truncated) from None

    def close(self) -> Fault | None:
        """Ends the stream.

        Returns:
            None if the stream ended between two frames. With `strict=False`, otherwise what is wrong.

        Raises:
            StreamError: The stream ended inside a frame, and the decoder is strict.
        """
        if not self._buffer:
            return None
        left = len(self._buffer)
        error = StreamError(
            self.position,
            f"the stream ends inside a frame, after {counted(left, 'byte')} of it",
            truncated=True,
        )
        if self._strict:
            raise error
        return error.fault

"""Lines of text as they come, and the silence between them."""

from __future__ import annotations

import codecs
import io
import select
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from ev3proto.tables.encoding import STRING_CODING
from ev3proto.text.paste import MAX_LINE

if TYPE_CHECKING:
    from _typeshed import WriteableBuffer

SILENCE = 0.5
"""Seconds without input after which a dump counts as complete."""

_CHUNK = io.DEFAULT_BUFFER_SIZE


def _as_latin_1(error: UnicodeError) -> tuple[str, int]:
    """Returns the characters that bytes mean in ISO-8859-1, and where reading continues."""
    assert isinstance(error, UnicodeDecodeError)
    return error.object[error.start : error.end].decode(STRING_CODING), error.end


LATIN_1 = "ev3proto-latin-1"
"""The name of the error handler that reads bytes which are not UTF-8 as ISO-8859-1."""
codecs.register_error(LATIN_1, _as_latin_1)


class IncomingFile(io.FileIO):
    """A file, a pipe or a terminal that tells whether nothing comes for a while."""

    _count = 0

    def readinto(self, buffer: WriteableBuffer, /) -> int | None:
        """Reads the available bytes, at least one, or none at the end."""
        count = super().readinto(buffer)
        self._count += count or 0
        return count

    def is_silent(self, count: int) -> bool:
        """Returns whether no more than `count` bytes were read, and half a second passes without another.

        Windows does not tell this of pipes and terminals: there, it is False.
        """
        if count < self._count:
            return False
        with suppress(OSError):
            return not select.select([self], [], [], SILENCE)[0]
        return False


class IncomingLines:
    """The lines of a text, those that are too long only as far as it takes to see that.

    Text is UTF-8, or UTF-16 if it starts with that mark, as PowerShell writes it. Bytes that are not UTF-8 are read as
    ISO-8859-1, which many sources of programs use.

    Args:
        stream: Where the text comes from.
        waits: Tells whether nothing comes for a while behind a number of bytes; for a file, something always does.
    """

    def __init__(self, stream: io.BufferedReader[Any], waits: Callable[[int], bool] = lambda _: False) -> None:
        self._stream, self._waits = stream, waits
        self._whole = deque[str]()
        self._count = 0

    def __iter__(self) -> Iterator[str]:
        """Yields the lines with their ends, each as soon as it is whole."""
        is_utf_16 = self._stream.peek(2)[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
        encoding, errors = ("utf-16", "replace") if is_utf_16 else ("utf-8-sig", LATIN_1)
        decoder = io.IncrementalNewlineDecoder(codecs.getincrementaldecoder(encoding)(errors), translate=True)
        begun, is_end = "", False
        while not is_end:
            data = self._stream.read1(_CHUNK)
            self._count, is_end = self._count + len(data), not data
            first, *others = decoder.decode(data, final=is_end).split("\n")
            begun += first if len(begun) <= MAX_LINE else ""
            if others:
                self._whole += (begun, *others[:-1])
                begun = others[-1]
            while self._whole:
                yield self._whole.popleft() + "\n"
        if begun:
            yield begun

    def is_silent(self) -> bool:
        """Returns whether the next line does not begin to come within half a second."""
        return not self._whole and self._waits(self._count)

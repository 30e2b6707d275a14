"""The words of a command line: files, standard input, frames."""

from __future__ import annotations

import io
import os
import re
import stat
import sys
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, NamedTuple

from ev3proto.cli.output import Advance, flush
from ev3proto.text.paste import Pasted
from ev3proto.text.spans import visible

if TYPE_CHECKING:
    from _typeshed import WriteableBuffer

_PATH = re.compile(r"[^()'\"|{}]*(/[^()'\"|{}]*|\w\.[a-z]\w{0,9})", re.IGNORECASE)
_GROUP = re.compile(r"(0x)?([0-9a-f]{2}:?){1,4},?", re.IGNORECASE)
"""Whole bytes in hex, which are taken for bytes even if a file has that name."""
_NUMBER = re.compile(r"[\[{]?((0x)?[0-9a-f]{1,2}|[0-9]{3})[\]}]?[,;]?", re.IGNORECASE)
"""One byte as numbers are written, also at an end of an array."""


class _Awaited(io.FileIO):
    """Input that may come slowly: standard output is flushed, and the bar redrawn, before waiting for more."""

    def __init__(self, file: str | int, advance: Advance) -> None:
        super().__init__(file, closefd=isinstance(file, str))
        self._advance = advance
        found = os.fstat(self.fileno())
        self._size = found.st_size if stat.S_ISREG(found.st_mode) else 0

    def readinto(self, buffer: WriteableBuffer, /) -> int | None:
        """Reads the available bytes, at least one, or none at the end."""
        flush()
        self._advance(self._done)
        return super().readinto(buffer)

    def _done(self) -> float | None:
        return min(self.tell() / self._size, 1.0) if self._size else None


def _nowhere(_done: Callable[[], float | None]) -> None:
    """Draws no bar."""


class Source(NamedTuple):
    """A word of the command line: a file, standard input, or a frame itself.

    lines  what was read already, for a text without a file
    """

    name: str
    is_frame: bool = False
    lines: Iterable[str] | None = None

    @property
    def label(self) -> str:
        """Its name in messages, on one line."""
        return "standard input" if self.name == "-" else visible(self.name)

    @property
    def looks_like_a_path(self) -> bool:
        """Whether its name has a folder or a suffix, like that of a file."""
        return _PATH.fullmatch(self.name) is not None

    def open(self, advance: Advance = _nowhere) -> BinaryIO:
        """Opens a file or standard input, and redraws a bar while it is read. Raises OSError."""
        if self.name != "-":
            return io.BufferedReader(_Awaited(self.name, advance))
        if sys.stdin is None:
            raise OSError("standard input is closed")
        raw = getattr(sys.stdin.buffer, "raw", None)
        return io.BufferedReader(_Awaited(raw.fileno(), advance)) if isinstance(raw, io.FileIO) else sys.stdin.buffer

    def read(self, most: int) -> bytes:
        """Reads at most this number of bytes of a file or standard input. Raises OSError."""
        with self.open() as stream:
            return stream.read(most)

    def where(self, pasted: Pasted) -> str:
        """Returns the start of a message about a piece of it."""
        return f"{self.name[:60]!r}" if self.is_frame else f"{self.label}, line {pasted.line}"


def sources(names: Sequence[str]) -> list[Source]:
    """Returns what the words name; bytes that were typed without quotes around them are one frame."""
    if len(names) > 1 and _are_bytes(names):
        return [Source(" ".join(names), is_frame=True)]
    return [Source(name, is_frame=name != "-" and (not name or not _exists(name))) for name in names or ("-",)]


def files_named(names: Sequence[str]) -> list[Source]:
    """Returns the files that the words name, or standard input."""
    return [Source(name) for name in names]


def _are_bytes(names: Sequence[str]) -> bool:
    """Whether each word is one byte or a few."""
    if all(_GROUP.fullmatch(name) for name in names):
        return True
    return all(_NUMBER.fullmatch(name) for name in names) and not any(_exists(name) for name in names)


def _exists(name: str) -> bool:
    try:
        return Path(name).exists()
    except (OSError, ValueError):
        return False

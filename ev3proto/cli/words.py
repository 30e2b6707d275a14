"""The words of a command line: files, standard input, frames."""

from __future__ import annotations

import io
import os
import re
import stat
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

from ev3proto.cli.output import ProgressBar, flush
from ev3proto.reading.given import Given, given_word, is_file
from ev3proto.reading.incoming import IncomingFile
from ev3proto.text.spans import visible

if TYPE_CHECKING:
    from _typeshed import WriteableBuffer

STANDARD_INPUT = "-"

_GROUP = re.compile(r"(0x)?([0-9a-f]{2}:?){1,4},?", re.IGNORECASE)
"""Whole bytes in hex, which are taken for bytes even if a file has that name."""
_NUMBER = re.compile(r"[\[{]?((0x)?[0-9a-f]{1,2}|[0-9]{3})[\]}]?[,;]?", re.IGNORECASE)
"""One byte as numbers are written, also at an end of an array."""


class _Awaited(IncomingFile):
    """Input that may come slowly: standard output is flushed, and the bar redrawn, before waiting for more."""

    def __init__(self, file: str | int, bar: ProgressBar) -> None:
        super().__init__(file, closefd=isinstance(file, str))
        self._bar = bar
        found = os.fstat(self.fileno())
        self._size = found.st_size if stat.S_ISREG(found.st_mode) else 0

    def readinto(self, buffer: WriteableBuffer, /) -> int | None:
        """Reads the available bytes, at least one, or none at the end."""
        flush()
        if self._size:
            self._bar.advance(lambda: min(self.tell() / self._size, 1.0))
        count = super().readinto(buffer)
        if not count:
            self._bar.end()
        return count

    def is_silent(self, count: int) -> bool:
        """Returns whether nothing more comes for half a second."""
        flush()
        return super().is_silent(count)

    def close(self) -> None:
        """Closes the file, and ends the bar."""
        self._bar.end()
        super().close()


def named(names: Sequence[str], *, is_quiet: bool = False) -> list[Given]:
    """Returns what the words name; bytes that were typed without quotes around them are one frame.

    `is_quiet`: nothing is printed while it is read, so that a progress bar may be drawn.
    """
    if len(names) > 1 and _are_bytes(names):
        return [given_word(" ".join(names))]
    return [
        file(name, is_quiet=is_quiet) if name == STANDARD_INPUT or is_file(name) else given_word(name)
        for name in names or (STANDARD_INPUT,)
    ]


def file(name: str, *, is_quiet: bool = True) -> Given:
    """Returns a file or standard input."""
    is_standard = name == STANDARD_INPUT
    label = "standard input" if is_standard else visible(name)

    def opened() -> BinaryIO:
        bar = ProgressBar(label, is_quiet=is_quiet)
        if not is_standard:
            return io.BufferedReader(_Awaited(name, bar))
        if sys.stdin is None:
            raise OSError("standard input is closed")
        raw = getattr(sys.stdin.buffer, "raw", None)
        return io.BufferedReader(_Awaited(raw.fileno(), bar)) if isinstance(raw, io.FileIO) else sys.stdin.buffer

    return Given(label, None if is_standard else Path(name), opened, is_lent=is_standard)


def files(names: Sequence[str]) -> list[Given]:
    """Returns the files that the words name, or standard input."""
    return [file(name) for name in names]


def _are_bytes(names: Sequence[str]) -> bool:
    """Whether each word is one byte or a few."""
    if all(_GROUP.fullmatch(name) for name in names):
        return True
    return all(_NUMBER.fullmatch(name) for name in names) and not any(is_file(name) for name in names)

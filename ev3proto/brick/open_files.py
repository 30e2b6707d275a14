"""Files that programs have opened by FILE, and the list of the files that were run last."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ev3proto.brick.storage import StoredFile

MOST_RECENT = 10
"""Files in the list of those run last."""


@dataclass(eq=False)
class OpenFile:
    """A file that a program has opened."""

    place: Path  # path of the file, to compare
    stream: StoredFile
    for_writing: bool  # whether it was opened to write or to append
    name: bytes  # the name used to open it
    is_log: bool = False  # whether it is a data log

    def read(self, most: int) -> bytes:
        """Reads a number of bytes, fewer at the end of the file."""
        return self.stream.read(max(0, most)) or b""

    def read_until(self, delimiter: bytes, most: int) -> bytes:
        """Reads up to a delimiter, which is consumed, or at most this number of bytes; an empty delimiter never occurs.

        Only the last byte of a delimiter is omitted: the firmware keeps the CR of a CR LF. A delimiter that ends
        beyond the limit is not seen.
        """
        begin = self.stream.tell()
        data = self.read(most + 1)
        at = data.find(delimiter) if delimiter else -1
        last = at + len(delimiter) - 1
        text = data[:last] if at >= 0 and last < most else data[:most]
        self.stream.seek(begin + len(text) + (at >= 0 and last < most))
        return text


class RecentFiles:
    """The files that were run last, the latest first, each once."""

    def __init__(self) -> None:
        self.paths: list[bytes] = []

    def put(self, path: bytes) -> None:
        """Puts a file first."""
        self.paths = [path, *(other for other in self.paths if other != path)][:MOST_RECENT]

    def forget(self, path: bytes) -> None:
        """Removes a file."""
        self.paths = [other for other in self.paths if other != path]

"""A text that is printed with changes: its encoding, its line ends and all other bytes stay."""

from __future__ import annotations

import codecs
from typing import NamedTuple

from ev3proto.cli.output import is_terminal, put, say

_BY_MARK = ((codecs.BOM_UTF8, "utf-8"), (codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be"))
_TAB = 8


class EditedFile(NamedTuple):
    """The contents of a file of text.

    text      its characters; bytes that are not text are kept as surrogates
    encoding  UTF-8, or UTF-16 if the file starts with that mark
    mark      the byte order mark
    """

    text: str
    encoding: str
    mark: bytes

    @classmethod
    def read(cls, data: bytes) -> EditedFile:
        """Returns the file for its bytes."""
        mark, encoding = next(((mark, name) for mark, name in _BY_MARK if data.startswith(mark)), (b"", "utf-8"))
        return cls(data[len(mark) :].decode(encoding, _errors(encoding)), encoding, mark)

    def write(self, text: str) -> None:
        """Prints a changed text as the file was written. On a terminal, what could steer it is escaped."""
        if is_terminal():
            say(text.removesuffix("\n").expandtabs(_TAB))
            return
        put(self.mark + text.encode(self.encoding, _errors(self.encoding)), None)


def _errors(encoding: str) -> str:
    return "surrogateescape" if encoding == "utf-8" else "surrogatepass"

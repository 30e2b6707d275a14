"""What is given to read: a file, a text, bytes, lines, an open file."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import IO, BinaryIO, NamedTuple, TypeAlias, cast

from ev3proto.text.spans import visible

Readable: TypeAlias = str | bytes | os.PathLike[str] | IO[str] | IO[bytes] | Iterable[str]
"""What `ev3proto.read` takes."""

PATH = re.compile(r"[^()'\"|{}]*(/[^()'\"|{}]*|\w\.[a-z]\w{0,9})", re.IGNORECASE)
"""A word with a folder or a suffix, like the name of a file."""
_MOST_QUOTED = 60

SOURCE_SUFFIX = ".lms"
"""The suffix of the sources of programs."""


class Given(NamedTuple):
    """Something to read. It has one of `open`, `word`, `lines` and `frames`.

    label    its name in problems
    path     of a file; None for anything else
    open     opens the file; raises OSError
    is_lent  whether it stays open
    word     a text that is known to be meant as bytes or assembly
    is_name  whether the word may be the name of a file instead
    lines    of a text
    frame    bytes that are known to be meant as a frame, unless they are something else by their start
    """

    label: str
    path: Path | None = None
    open: Callable[[], BinaryIO] | None = None
    word: str | None = None
    lines: Iterable[str] | None = None
    frame: bytes | None = None
    is_lent: bool = False
    is_name: bool = True

    def opened(self) -> BinaryIO:
        """Opens the file. Raises OSError."""
        assert self.open is not None, "only files are opened"
        return self.open()

    @property
    def is_program_source(self) -> bool:
        """Whether it is named like the source of a program."""
        return self.path is not None and self.path.suffix.lower() == SOURCE_SUFFIX

    @property
    def name(self) -> str | None:
        """The word, if it may be the name of a file instead of a text."""
        return self.word if self.is_name else None

    @property
    def quoted(self) -> str:
        """A word in quotes, for problems."""
        return self.label if self.name is None else f"{self.name[:_MOST_QUOTED]!r}"


def given_word(text: str) -> Given:
    """Returns a text that is meant as bytes or assembly."""
    return Given(visible(text), word=text)


def given_file(path: Path) -> Given:
    """Returns a file."""
    return Given(visible(str(path)), path, lambda: path.open("rb"))


def given(source: Readable) -> Given:
    """Returns anything that can be read. Raises TypeError for anything else."""
    if isinstance(source, str):
        return _given_text(source)
    if isinstance(source, bytes | bytearray | memoryview):
        return Given("the bytes", frame=bytes(source))
    if isinstance(source, os.PathLike):
        return given_file(Path(source))
    name = getattr(source, "name", None)
    label = visible(name) if isinstance(name, str) else "the input"
    if isinstance(getattr(source, "read", lambda _: None)(0), bytes):
        return Given(label, open=lambda: cast(BinaryIO, source), is_lent=True)
    if isinstance(source, Iterable):
        return Given(label, lines=map(_line, source))
    raise TypeError(f"cannot read {type(source).__name__}; expected a path, text, bytes, lines or an open file")


def _line(line: object) -> str:
    if not isinstance(line, str):
        raise TypeError(f"cannot read {type(line).__name__} as a line; give bytes as a source of their own")
    return line


def _given_text(text: str) -> Given:
    if "\n" in text or "\r" in text:
        return Given("the text", lines=text.splitlines(keepends=True))
    return given_file(Path(text)) if is_file(text) else given_word(text)


def is_file(name: str) -> bool:
    """Whether a text is the name of a file or folder."""
    try:
        return bool(name) and Path(name).exists()
    except (OSError, ValueError):
        return False

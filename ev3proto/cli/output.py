"""What people and other programs are shown. Everything that is printed goes through here.

Standard output is written in blocks, and line by line on a terminal. What was printed is also written before anything
goes to standard error, and before more input is waited for. No control character gets through, wherever it comes from.
Standard output and standard error may both be closed, full, or a pipe that nobody reads. A progress bar is drawn where
a terminal watches.
"""

from __future__ import annotations

import io
import os
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, TextIO, cast

import click

from ev3proto.text.spans import Line, Role, plain_text, visible, visible_lines

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer, WriteableBuffer


STYLES = {
    Role.PLAIN: "",
    Role.HEADING: "bold",
    Role.OPERATION: "bold cyan",
    Role.NAME: "green",
    Role.VALUE: "yellow",
    Role.MEANING: "magenta",
    Role.ASIDE: "dim",
    Role.FAULT: "bold red",
}

_BLOCK = 1 << 16
"""Characters that are written together."""


class OutputError(Exception):
    """Standard output cannot be written. It is no OSError, so that nobody takes it for one about what is read.

    number  the number of the error (errno), None where there is none
    reason  a few words
    """

    def __init__(self, number: int | None, reason: str) -> None:
        super().__init__(f"the output cannot be written: {reason}")
        self.number = number

    @classmethod
    def of(cls, error: OSError) -> OutputError:
        """What an error of the operating system means where it comes from standard output."""
        return cls(error.errno, error.strerror or str(error))


class _Output:
    """Standard output, written in blocks."""

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream
        self.is_terminal = stream.isatty()
        self._waiting: list[str] = []
        self._size = 0
        if isinstance(stream, io.TextIOWrapper):
            # What the terminal's character set does not have is written as an escape, too.
            stream.reconfigure(errors="backslashreplace")

    def write(self, text: str) -> None:
        """Writes a text, now or with what follows it."""
        self._waiting.append(text)
        self._size += len(text)
        if self.is_terminal or self._size > _BLOCK:
            self.flush()

    def flush(self) -> None:
        """Writes what waits. Raises OutputError; nothing waits any more then."""
        if self._waiting:
            text = "".join(self._waiting)
            self._waiting, self._size = [], 0
            try:
                self.stream.write(text)
                self.stream.flush()
            except OSError as error:
                raise OutputError.of(error) from None


_outputs: list[_Output] = []
"""The one for what is standard output at the moment."""


def _output() -> _Output:
    stream = sys.stdout
    if stream is None:
        raise OutputError(None, "standard output is closed")
    if not _outputs or _outputs[0].stream is not stream:
        _outputs[:] = [_Output(stream)]
        context = click.get_current_context(silent=True)
        if context is not None:
            context.find_root().call_on_close(flush)
    return _outputs[0]


def flush() -> None:
    """Writes what waits to be written to standard output. Raises OutputError where that is not possible."""
    for output in _outputs:
        if output.stream is sys.stdout:
            output.flush()


class Printer:
    """Prints lines: coloured on a terminal, plain into a pipe and where NO_COLOR is set.

    at_once  what is printed is to be seen at once, because nobody knows when more will come
    """

    def __init__(self, *, at_once: bool = False) -> None:
        self._output = _output()
        self._at_once = at_once
        is_coloured = self._output.is_terminal and not os.environ.get("NO_COLOR")
        self._text: Callable[[Line], str] = _Paint() if is_coloured else plain_text

    def lines(self, lines: Iterable[Line]) -> None:
        """Prints lines that are made of pieces."""
        text = self._text
        self._output.write("".join([f"{text(line)}\n" for line in lines]))
        if self._at_once:
            self._output.flush()

    def text(self, text: str) -> None:
        """Prints one line."""
        self._output.write(visible(text) + "\n")
        if self._at_once:
            self._output.flush()


class _Paint:
    """Gives the pieces of lines the colours of their roles."""

    def __init__(self) -> None:
        from rich.console import Console  # takes 30 ms, which only terminals have a use for
        from rich.text import Text

        self._text = Text
        self._console = Console(highlight=False, soft_wrap=True)

    def __call__(self, line: Line) -> str:
        """A line with the sequences that colour it."""
        with self._console.capture() as captured:
            self._console.print(self._text.assemble(*((visible(text), STYLES[role]) for text, role in line)), end="")
        return captured.get()


def say(text: str = "") -> None:
    """Prints lines to standard output."""
    _output().write(visible_lines(text) + "\n")


def draw(lines: Iterable[str]) -> None:
    """Prints lines as they are: they have colours of ours in them, and only `visible` texts beside these."""
    _output().write("".join(f"{line}\n" for line in lines))


def complain(sentence: str) -> None:
    """Prints a sentence to standard error, after all that was printed before it.

    Where standard error cannot be written, there is nobody left to say so to, and the exit status has to do.
    """
    flush()
    if sys.stderr is not None:
        with suppress(OSError):
            sys.stderr.write(visible_lines(sentence) + "\n")
            sys.stderr.flush()


def is_terminal() -> bool:
    """Whether standard output is a terminal."""
    return sys.stdout is not None and sys.stdout.isatty()


@contextmanager
def binary_output() -> Iterator[BinaryIO]:
    """Standard output for bytes, after all that was printed before, and written when the `with` ends.

    Raises:
        OutputError: It cannot be written.
    """
    flush()
    if sys.stdout is None:
        raise OutputError(None, "standard output is closed")
    stream = _Bytes(sys.stdout.buffer)
    yield cast(BinaryIO, stream)
    stream.flush()


def put(data: bytes, path: Path | None, *, check: bool = False) -> bool:
    """Writes what a file is to have: whole, or not at all. Complains where that fails.

    Args:
        data: Its contents.
        path: The file; None for standard output.
        check: Write nothing, and compare.

    Returns:
        Whether the file has them now.

    Raises:
        OutputError: Standard output cannot be written.
    """
    if path is None:
        with binary_output() as stream:
            stream.write(data)
        return True
    from ev3proto.whole_files import write_whole  # takes 2 ms, which commands that print have no use for

    try:
        if not check:
            write_whole(path, data)
        elif path.read_bytes() != data:
            complain(f"{path} is out of date: write it anew, without --check")
            return False
    except OSError as error:
        complain(f"{path}: cannot be {'read' if check else 'written'}: {error.strerror or error}")
        return False
    return True


class _Bytes(io.BufferedIOBase):
    """Standard output, whose errors are not taken for those of what is read."""

    def __init__(self, stream: BinaryIO) -> None:
        super().__init__()
        self._stream = stream

    def writable(self) -> bool:
        """True, as for every output."""
        return True

    def write(self, data: ReadableBuffer, /) -> int:
        """Writes bytes, now or with what follows them. Raises OutputError."""
        try:
            return self._stream.write(data)
        except OSError as error:
            raise OutputError.of(error) from None

    def flush(self) -> None:
        """Writes what waits. Raises OutputError."""
        try:
            self._stream.flush()
        except OSError as error:
            raise OutputError.of(error) from None

    def close(self) -> None:
        """Nothing is closed: standard output belongs to whoever opened it."""


class Awaited(io.RawIOBase):
    """Input that may come slowly: what was printed is written before more of it is waited for.

    stream   what is read
    is_ours  closing this closes the stream, too
    """

    def __init__(self, stream: io.RawIOBase | io.BytesIO, *, is_ours: bool = False) -> None:
        super().__init__()
        self._stream = stream
        self._is_ours = is_ours

    def close(self) -> None:
        """Nothing more is read."""
        if self._is_ours and not self.closed:
            self._stream.close()
        super().close()

    def readable(self) -> bool:
        """True, as for every input."""
        return True

    def fileno(self) -> int:
        """The number of the open file."""
        return self._stream.fileno()

    def readinto(self, buffer: WriteableBuffer, /) -> int | None:
        """Reads what there is, at least a byte, or nothing at the end."""
        flush()
        return self._stream.readinto(buffer)


EVERY = 2048
"""Lines or frames after which the bar is drawn again."""

PATIENCE = 1.0
"""Seconds of reading after which there is a bar."""


def progress_bar(
    done: Callable[[], float | None], name: str, *, is_quiet: bool
) -> AbstractContextManager[Callable[[], None]]:
    """A bar, where a terminal watches and nothing else is printed on it.

    Args:
        done: How much of the input was read, 0 to 1; None where its size is not known.
        name: What is read.
        is_quiet: Nothing is printed on standard output while it is read.

    Returns:
        A context that gives what draws the bar when it is called.
    """
    watched = sys.stderr is not None and sys.stderr.isatty() and (is_quiet or not is_terminal())
    return _Bar(done, name) if watched else nullcontext(lambda: None)


def advancing(lines: Iterator[str], advance: Callable[[], None]) -> Iterator[str]:
    """The lines, with a call now and then that draws the bar."""
    for count, line in enumerate(lines):
        if count % EVERY == 0:
            advance()
        yield line


class _Bar:
    """A bar that is drawn once reading takes longer than people like to wait without a word."""

    def __init__(self, done: Callable[[], float | None], name: str) -> None:
        from rich.console import Console  # takes 30 ms, which only terminals have a use for
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

        self._done = done
        self._started = time.monotonic()
        console = Console(stderr=True)
        text = TextColumn("{task.description}", markup=False)
        columns = (text, BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
        self._progress = Progress(*columns, console=console, transient=True)
        self._task = self._progress.add_task(name, total=None)
        self._is_drawn = False

    def __enter__(self) -> Callable[[], None]:
        return self._advance

    def __exit__(self, *_: object) -> None:
        if self._is_drawn:
            self._progress.stop()

    def _advance(self) -> None:
        if not self._is_drawn:
            if time.monotonic() - self._started < PATIENCE:
                return
            self._progress.start()
            self._is_drawn = True
        done = self._done()
        if done is not None:
            self._progress.update(self._task, total=1.0, completed=done)

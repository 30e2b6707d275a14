"""Text that comes slowly: what is whole is shown, and a dump waits for its next row or for silence."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import closing
from typing import Any

import pytest

from ev3proto.reading import incoming
from ev3proto.reading.incoming import IncomingFile, IncomingLines
from ev3proto.text.paste import read_text

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
ROW = f"0000  {TONE.hex(' ')}\n"
FIRST, SECOND = f"0000  {TONE[:8].hex(' ')}\n", f"0008  {TONE[8:].hex(' ')}\n"


class Typed:
    """Lines with pauses between them, and what was found when."""

    def __init__(self, *lines: str | None) -> None:
        self.lines = list(lines)
        self.found: list[tuple[int, bytes]] = []

    def __iter__(self) -> Iterator[str]:
        self.given = 0
        while self.lines:
            line = self.lines.pop(0)
            if line is not None:
                self.given += 1
                yield line

    def is_silent(self) -> bool:
        return self.lines[:1] == [None]

    def read(self) -> list[tuple[int, bytes]]:
        """Returns the frames, each with the number of lines that were typed before it was shown."""
        return [(self.given, piece.data) for piece in read_text(self, self.is_silent)]


def test_a_line_that_is_whole_waits_for_nothing() -> None:
    assert Typed(TONE.hex(), "a word", f"sent {TONE.hex(' ')}").read() == [(1, TONE), (3, TONE)]


def test_the_first_row_of_a_dump_waits_for_the_next_line() -> None:
    assert Typed(ROW, "then nothing").read() == [(2, TONE)]


def test_the_first_row_of_a_dump_waits_no_longer_than_for_silence() -> None:
    assert Typed(ROW, None, "then nothing").read() == [(1, TONE)]


def test_a_dump_in_rows_is_one_frame() -> None:
    assert Typed(FIRST, SECOND, None, ROW, None).read() == [(2, TONE), (3, TONE)]


def test_a_dump_that_stops_is_what_it_is() -> None:
    assert Typed(FIRST, None, "then nothing").read() == [(1, TONE[:8])]


@pytest.mark.parametrize("opening", ["byte a[] = {", "byte a[] = { /* one"])
def test_a_list_that_is_open_waits_in_silence(opening: str) -> None:
    rows = [", ".join(map(hex, part)) for part in (TONE[:8], TONE[8:])]
    texts = [f"{opening} */ {rows[0]}," if "/*" in opening else f"{opening}{rows[0]},", None, f"{rows[1]} }};"]
    assert Typed(*texts).read() == [(2, TONE)]


Piped = tuple[Callable[[bytes], object], IncomingFile]


@pytest.fixture
def piped(monkeypatch: pytest.MonkeyPatch) -> Iterator[Piped]:
    monkeypatch.setattr(incoming, "SILENCE", 0)
    end, start = os.pipe()
    with closing(IncomingFile(end, closefd=True)) as file:
        yield lambda data: os.write(start, data), file
        os.close(start)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not tell whether a pipe is empty")
def test_lines_of_a_pipe_come_one_by_one(piped: Piped) -> None:
    write, file = piped
    incoming_lines = IncomingLines(io.BufferedReader(file), file.is_silent)
    write(b"one\ntwo\r\nthr")
    lines = iter(incoming_lines)
    assert next(lines) == "one\n"
    assert not incoming_lines.is_silent()  # the second line is there
    assert next(lines) == "two\n"
    assert incoming_lines.is_silent()
    write(b"ee\n")
    assert not incoming_lines.is_silent()
    assert next(lines) == "three\n"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not tell whether a pipe is empty")
def test_bytes_in_a_buffer_are_not_silence(piped: Piped) -> None:
    write, file = piped
    stream = io.BufferedReader(file)
    write(b"one\ntwo\n")
    assert stream.peek(1)
    assert not file.is_silent(4)
    assert file.is_silent(8)


@pytest.mark.parametrize("size", [2, 3, 5, 1 << 20])
@pytest.mark.parametrize(
    ("data", "lines"),
    [
        (b"one\r\ntwo\rthree", ["one\n", "two\n", "three"]),
        ("\ufeff\u00e4\n".encode(), ["\u00e4\n"]),
        (b"\xe4\n\xe4", ["\u00e4\n", "\u00e4"]),
        ("a\r\n\u00e4\n".encode("utf-16"), ["a\n", "\u00e4\n"]),
        (b"", []),
    ],
)
def test_lines_are_the_same_in_chunks_of_any_size(size: int, data: bytes, lines: list[str]) -> None:
    class Slow(io.BytesIO):
        def readinto(self, buffer: Any) -> int:
            return super().readinto(memoryview(buffer)[:size])

    assert list(IncomingLines(io.BufferedReader(Slow(data)))) == lines


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not tell whether a pipe is empty")
def test_decode_shows_the_row_of_a_dump_while_it_waits_for_more() -> None:
    call = [sys.executable, "-m", "ev3proto", "decode", "--json"]
    with subprocess.Popen(call, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(ROW)
        process.stdin.flush()
        assert TONE.hex() in process.stdout.readline()  # standard input is still open

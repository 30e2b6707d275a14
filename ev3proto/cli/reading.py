"""How input is read: the options of subcommands, the lines of texts, and what a file is by its first bytes.

Nothing here loads a part that reads captures: a frame needs this, too.
"""

from __future__ import annotations

import codecs
import functools
import io
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import chain, islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import click

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.cli.options import dialect_option, incompatible, tshark_option
from ev3proto.cli.output import say
from ev3proto.messages import Message
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE, frame_size, may_have_length
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import LENGTH_FIELD, REPORT_SIZES, MessageType
from ev3proto.tables.program import SIGN
from ev3proto.text.paste import MAX_LINE, Missing, Pasted, read_bare, read_text

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter, FilterError
    from ev3proto.text.paste import Missing


class Piece(NamedTuple):
    """A message out of pasted bytes; `padding` bytes without meaning followed it."""

    message: Message
    padding: int = 0


def split(data: bytes, *, dialect: str = "official") -> Iterator[Piece]:
    """The messages in pasted bytes. Never raises; what is wrong stands in each message's fault."""
    first = next(_ends(data), 0)
    if first < max(_ends(data), default=0) == len(data):
        start = 0
        for end in _ends(data):
            yield Piece(parse(data[start:end], strict=False, dialect=dialect))
            start = end
        return
    if 0 < first < len(data) and (len(data) in REPORT_SIZES or not any(data[first:])):
        yield Piece(parse(data[:first], strict=False, dialect=dialect), len(data) - first)
        return
    yield Piece(parse(data, strict=False, dialect=dialect))


def _ends(data: bytes) -> Iterator[int]:
    """Where the frames end when each starts where the one before ended."""
    at = 0
    while at + LENGTH_FIELD <= len(data):
        is_frame = may_have_length(data, at)
        at += frame_size(data, at)
        if not is_frame or at > len(data):
            return
        yield at


_ZIP = b"PK\x03\x04"
_UF2 = b"UF2\n"
_SOUND = (b"\x01\x00", b"\x01\x01")
_LEAST_FIRMWARE = 1 << 20
_BY_SUFFIX = {
    ".ev3": "a project of LEGO's EV3 software, a zip of diagrams without byte code: download it to a brick and copy"
    " the program's .rbf from there",
    ".uf2": "a UF2 image for a brick in bootloader mode, which holds ARM code: copy it to the brick's drive",
    ".rgf": "an image for the brick's display: `ev3proto copy` puts it on a brick, UI_DRAW.BMPFILE shows it",
    ".rsf": "a sound file: `ev3proto copy` puts it on a brick, SOUND.PLAY plays it",
    ".bin": "a firmware image, perhaps: it holds ARM code, which the firmware updater of LEGO's software writes",
}


def kind_of(name: str, start: bytes) -> str | None:
    """Returns what a file is that cannot be read, and what to do with it; None for an unknown kind.

    Args:
        name: The path of a file; `-` for standard input.
        start: Its first bytes.
    """
    suffix = Path(name).suffix.lower()
    if start.startswith(_UF2):
        return _BY_SUFFIX[".uf2"]
    if start.startswith(_ZIP):
        return _BY_SUFFIX[suffix] if suffix == ".ev3" else "a zip archive: unpack it, and give the files in it"
    if suffix == ".bin" and Path(name).stat().st_size < _LEAST_FIRMWARE:
        return None
    if suffix == ".rsf" and not start.startswith(_SOUND):
        return None
    return _BY_SUFFIX.get(suffix) if suffix in (".rgf", ".rsf", ".bin") else None


MOST_RAW = 1 << 26
"""Bytes of frames that are read from a file which has nothing else; a longer one is refused."""

HOW_FRAMES_ARE_WRITTEN = "; frames are written in hex, such as 06:00|2A:00|80|00:00|01"

START = 8
"""Bytes by which a file is recognised."""

SOURCE_SUFFIX = ".lms"
"""What the names of programs' sources end in."""

_MOST_UNREAD = 8

_MOST_LOOKED_AT = 500
"""Lines of comments before the first line that says what a text is."""


class Unread:
    """What looks like frames in a text and was not read."""

    def __init__(self) -> None:
        self.count = 0
        self._first: list[str] = []

    def add(self, pasted: Pasted) -> None:
        """Takes one more; only the first ones are named."""
        self.count += 1
        if len(self._first) < _MOST_UNREAD:
            self._first.append(f"line {pasted.line}, column {pasted.column}: {pasted.problem}")

    def __str__(self) -> str:
        many = f"{self.count} lines look like frames and were"
        lines = "1 line looks like a frame and was" if self.count == 1 else many
        more = self.count - len(self._first)
        return f"{lines} not read: {'; '.join(self._first)}" + (f"; and {more} more" if more else "")


def pieces(lines: Iterator[str], missing: Missing | None, complain: Callable[[str], None]) -> Iterator[Pasted]:
    """What there is in the lines of a text.

    Args:
        lines: The lines.
        missing: What the bytes of each line lack to be a frame.
        complain: Is called at the end with a sentence on what looks like frames and was not read.

    Yields:
        Pieces that have bytes, or a problem.
    """
    unread = Unread()
    for pasted in read_text(lines) if missing is None else read_bare(lines, missing):
        if pasted.unread:
            unread.add(pasted)
        else:
            yield pasted
    if unread.count:
        complain(str(unread))


def introduction(lines: Iterator[str]) -> Iterator[str]:
    """The lines up to the first that is neither empty nor a comment, that one too."""
    is_comment = False
    for line in islice(lines, _MOST_LOOKED_AT):
        yield line
        text = line.strip()
        if is_comment or text.startswith("/*"):
            is_comment = "*/" not in text
        elif text and not text.startswith("//") and not (text.startswith("#") and "define" not in text):
            return


def is_image(start: bytes) -> bool:
    """Whether a file that starts so is a program image."""
    return start.startswith(SIGN)


def _as_latin_1(error: UnicodeError) -> tuple[str, int]:
    """The characters that bytes mean in ISO-8859-1, and where reading goes on."""
    assert isinstance(error, UnicodeDecodeError)
    return error.object[error.start : error.end].decode(STRING_CODING), error.end


_LATIN_1 = "ev3proto-latin-1"
codecs.register_error(_LATIN_1, _as_latin_1)


def text_lines(stream: io.BufferedReader[Any]) -> Iterator[str]:
    """The lines of a file, those that are too long only as far as it takes to see that.

    Text is UTF-8, or UTF-16 where the file starts with that mark, as PowerShell writes it. Bytes that are no UTF-8 are
    ISO-8859-1, as in many sources of programs.
    """
    start = stream.peek(2)[:2]
    encoding = "utf-16" if start in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE) else "utf-8-sig"
    text = io.TextIOWrapper(stream, encoding, _LATIN_1 if encoding == "utf-8-sig" else "replace")
    while line := text.readline(MAX_LINE + 1):
        yield line
        while len(line) > MAX_LINE and not line.endswith("\n"):
            line = text.readline(MAX_LINE + 1)


def raw_frames(stream: io.BufferedReader[Any], dialect: str) -> Iterator[Piece] | None:
    """Frames that stand one after the other as they are.

    Args:
        stream: A file that is neither a text nor a capture. It is not read where it does not start with a frame.
        dialect: The firmware whose instruction set to read by.

    Returns:
        The frames, one by one; None where there is none.
    """
    start = stream.peek(HEADER_SIZE)[:HEADER_SIZE]
    if len(start) < HEADER_SIZE or not may_have_length(start) or start[-1] not in frozenset(MessageType):
        return None
    found = split(stream.read(MOST_RAW + 1), dialect=dialect)
    begin = list(islice(found, 2))
    if len(begin) == 1 and begin[0].message.fault is not None:
        return None
    return chain(begin, found)


def hex_lines(found: Iterator[Piece]) -> Iterator[str]:
    """Frames as the lines of a text."""
    return (piece.message.build().hex(" ") for piece in found)


def is_binary(start: bytes) -> bool:
    """Whether bytes are no text: it has no control characters but those that break lines, or is UTF-16."""
    if start.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return False
    return any(byte < ord(" ") and byte not in b"\t\n\r\f\x1b" for byte in start)


BUILTIN = "builtin"
"""The engine that needs no other program."""

MIB = 1 << 20
"""Bytes in which --memory counts."""


@dataclass
class CaptureOptions:
    """How captures are to be read.

    dialect  the firmware whose instruction set to read by
    ports    TCP ports on which bricks listen
    engine   builtin or wireshark
    tshark   path of the tshark for that engine
    filter   which records to show, None for all
    missing  what the bytes in a text lack in front of them to be frames
    memory   MiB that all that waits may take
    """

    dialect: str = DIALECTS[0]
    ports: tuple[int, ...] = (TCP_PORT,)
    engine: str = BUILTIN
    tshark: str | None = None
    filter: Filter | None = None
    missing: Missing | None = None
    memory: int = DEFAULT_MEMORY // MIB


def given_up(label: str, count: int, memory: int) -> str:
    """What to say where too much waited.

    Args:
        label: What was read.
        count: How many things had to go.
        memory: MiB that all that waits may take.
    """
    return (
        f"{label}: {count} parts of frames, transfers and commands without a reply were given up: what waits may take"
        f" {memory} MiB (--memory)"
    )


def _compiled(_context: click.Context, _parameter: click.Parameter, text: str | None) -> Filter | None:
    if text is None:
        return None
    from ev3proto.capture.filter import FilterError, compile_filter  # takes 8 ms, which only filters need

    try:
        return compile_filter(text)
    except FilterError as error:
        raise click.BadParameter(f"{error}\n{_underlined(text, error)}") from None


_WINDOW = 60
"""Characters of a filter that are shown on either side of what is wrong in it."""


def _underlined(text: str, error: FilterError) -> str:
    """Two lines: the filter, and below it what is wrong in it."""
    at = error.column - 1
    start, end = max(at - _WINDOW, 0), at + _WINDOW
    shown = "".join(character if character.isprintable() else " " for character in text[start:end])
    before, after = "..." * (start > 0), "..." * (end < len(text))
    sign = "^" * min(error.length, max(len(shown) - (at - start), 1))
    return f"  {before}{shown}{after}\n  {' ' * (len(before) + at - start)}{sign}"


def _explain_filters(context: click.Context, _parameter: click.Parameter, is_wanted: bool) -> None:
    if not is_wanted or context.resilient_parsing:
        return
    from ev3proto.capture.filter.manual import manual  # the same

    say("\n".join(manual()))
    context.exit()


F = TypeVar("F", bound=Callable[..., Any])

_OPTIONS = (
    dialect_option,
    click.option(
        "--port",
        "ports",
        type=click.IntRange(1, 65535),
        multiple=True,
        default=(TCP_PORT,),
        show_default=True,
        metavar="PORT",
        help="TCP port of the brick; can be repeated.",
    ),
    click.option(
        "--engine",
        type=click.Choice((BUILTIN, "wireshark")),
        default=BUILTIN,
        show_default=True,
        help="Program that dissects packets: ev3proto itself, or tshark.",
    ),
    tshark_option,
    click.option(
        "--filter",
        "chosen",
        callback=_compiled,
        metavar="EXPRESSION",
        help="Only frames that match this, such as 'op==SOUND.TONE && FREQUENCY>400'.",
    ),
    click.option(
        "--help-filter",
        is_flag=True,
        is_eager=True,
        expose_value=False,
        callback=_explain_filters,
        help="Explain filters and list their fields, with examples, and exit.",
    ),
    click.option(
        "--no-length",
        is_flag=True,
        help="Read each line of a text as a frame without the two bytes of its length field.",
    ),
    click.option(
        "--operations",
        "only_operations",
        is_flag=True,
        help="Read each line of a text as operations without the header of a frame.",
    ),
    click.option(
        "--memory",
        type=click.IntRange(1, 1 << 16),
        default=DEFAULT_MEMORY // MIB,
        show_default=True,
        metavar="MIB",
        help="Memory limit for unfinished frames, transfers and unanswered commands; the oldest are dropped first.",
    ),
)


def reading_options(command: F) -> F:
    """Adds the options on how to read captures to a command, which gets them as one argument, `reading`."""

    @functools.wraps(command)
    def called(
        *arguments: Any,
        dialect: str,
        ports: tuple[int, ...],
        engine: str,
        tshark: str | None,
        chosen: Filter | None,
        no_length: bool,
        only_operations: bool,
        memory: int,
        **others: Any,
    ) -> Any:
        if no_length and only_operations:
            raise incompatible("--no-length", "--operations")
        missing: Missing | None = "length" if no_length else "header" if only_operations else None
        reading = CaptureOptions(dialect, ports, engine, tshark, chosen, missing, memory)
        return command(*arguments, reading=reading, **others)

    for option in reversed(_OPTIONS):
        option(called)
    return called  # type: ignore[return-value]

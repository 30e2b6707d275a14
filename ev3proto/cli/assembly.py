"""Assembly in the input of subcommands: its messages, and errors with a mark below the place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from ev3proto.cli.output import complain
from ev3proto.cli.words import Source
from ev3proto.messages import Message
from ev3proto.text.assembly import AssemblyError
from ev3proto.text.assembly.assembling import MAX_TEXT, assembled
from ev3proto.text.assembly.recognising import OBJECT

_SUBROUTINE = "subcall"


def assembled_messages(
    source: Source,
    lines: Iterable[str],
    complain_of: Callable[[str], None],
    *,
    dialect: str,
    counter: int = 0,
    reply: bool | None = None,
    unchecked: bool = False,
) -> Iterator[Message]:
    """Yields the messages of a text in assembly, whose lines end in a newline if it is a file; reports errors."""
    text = _joined(lines, "\n" if source.is_frame else "", MAX_TEXT + 1)
    try:
        yield from assembled(text, dialect=dialect, counter=counter, reply=reply, unchecked=unchecked)
    except AssemblyError as error:
        objects = OBJECT.findall(text)
        if len(objects) <= 1 and _SUBROUTINE not in objects:
            show_errors("" if source.is_frame else f"{source.label}, ", (error, *error.others), complain_of)
        if objects:
            label = "" if source.is_frame else f"{source.label}: "
            complain_of(f"{label}this is a program, not a frame; add -o FILE.rbf to make its image")


def show_errors(place: str, errors: Iterable[AssemblyError], complain_of: Callable[[str], None] = complain) -> None:
    """Prints errors, `place` before each, and below that its line with a mark."""
    for one in errors:
        complain_of(f"{place}{one}")
        if one.text.strip():
            complain("\n".join(f"  {line}" for line in one.excerpt.split("\n")))


def _joined(lines: Iterable[str], between: str, most: int) -> str:
    """Joins lines to one text, and stops reading once it has `most` characters."""
    kept: list[str] = []
    size = 0
    for line in lines:
        kept.append(line)
        size += len(line) + len(between)
        if size >= most:
            break
    return between.join(kept)

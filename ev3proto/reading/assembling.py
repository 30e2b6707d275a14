"""The frames that are made of assembly."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.capture.record import Place, Record
from ev3proto.capture.text_log import TextLog
from ev3proto.reading.incoming import LATIN_1
from ev3proto.reading.items import Problem, ProblemCode, Source
from ev3proto.text.assembly.assembling import assembled as messages_of
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.python_lists import assembly_in, is_python
from ev3proto.text.assembly.recognising import OBJECT

_SUBROUTINE = "subcall"


def assembled(
    source: Source, *, dialect: str = "official", counter: int = 0, reply: bool | None = None, unchecked: bool = False
) -> Iterator[Record | Problem]:
    """Yields the frames of assembly, then its errors.

    Args:
        source: What `ev3proto.read` yields for assembly.
        dialect: The firmware whose instruction set is used.
        counter: Message counter of the first message that states none, 0 to 65535.
        reply: Whether messages without a header want a reply; None: if their operations return values.
        unchecked: Accept values that mean nothing to the brick, such as motor port 16.
    """
    text = source.text if isinstance(source.text, str) else source.text.decode("utf-8-sig", LATIN_1)
    log, name, number = TextLog(dialect), source.place.name, 0
    try:
        for part in assembly_in(text) if is_python(text) else (text,):
            for message in messages_of(part, dialect=dialect, counter=counter, reply=reply, unchecked=unchecked):
                number, counter = number + 1, message.counter + 1
                yield log.made(message, Place(name, frame=number), number)
    except AssemblyError as error:
        objects = OBJECT.findall(text)
        if len(objects) <= 1 and _SUBROUTINE not in objects:
            for one in (error, *error.others):
                yield Problem.in_source(name, one)
        if objects:
            sentence = "this is a program, not a frame; add -o FILE.rbf to make its image"
            yield Problem(Place(name), ProblemCode.SOURCE, sentence)

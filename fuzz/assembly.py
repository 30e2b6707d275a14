"""Assembly: each text is refused with a place inside it, or makes frames whose assembly makes the same frames."""

from __future__ import annotations

from ev3proto.dialogue import Exchange
from ev3proto.text.assembly import AssemblyError, assemble
from ev3proto.text.assembly.disassembly import assembly


def one_input(data: bytes) -> None:
    """Takes the text of any number of frames."""
    text = data.decode("utf-8", "replace")
    try:
        messages = assemble(text)
    except AssemblyError as error:
        assert str(error)
        assert error.excerpt is not None
        return
    for message in messages:
        again = assemble("\n".join(assembly(Exchange(message), "fuzzed")))
        assert [each.build() for each in again] == [message.build()]

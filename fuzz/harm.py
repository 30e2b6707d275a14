"""Direct commands: what counts as reading runs the operations that it shows, all of which read."""

from __future__ import annotations

from functools import cache

import ev3proto
from ev3proto.brick import Brick
from ev3proto.brick.dispatch import dispatch_table
from ev3proto.brick.handlers import Dispatch, DispatchEntry, Family
from ev3proto.brick.machine import Machine
from ev3proto.link.harm import harms_of
from ev3proto.messages import DirectCommand
from ev3proto.tables import operations
from ev3proto.tables.declaration import Effect

_DIALECT = "official"
_SECONDS = 0.02

_ran: set[str] = set()


def one_input(data: bytes) -> None:
    """Takes a frame."""
    message = ev3proto.parse(data, strict=False)
    if not isinstance(message, DirectCommand) or harms_of(message):
        return
    _ran.clear()
    brick = Brick(stretch=_SECONDS)
    brick.machine = Machine(brick.equipment, _recording())
    brick.receive(data)
    brick.advance(_SECONDS)
    # The firmware puts an OBJECT_END after each command.
    ran = _ran - {"OBJECT_END"}
    assert ran <= {operation.full_name for operation in message.operations}
    assert all(Effect.READS in operations(_DIALECT)[name].effects for name in ran)


@cache
def _recording() -> Dispatch:
    """The brick's table, whose functions also record their effects."""
    names = {
        (declaration.opcode.number, declaration.command.number if declaration.command else None): name
        for name, declaration in operations(_DIALECT).items()
    }

    def noted(entry: DispatchEntry, name: str) -> DispatchEntry:
        def function(*arguments: object) -> None:
            _ran.add(name)
            entry.function(*arguments)

        return DispatchEntry(function, entry.readers)

    found: list[DispatchEntry | Family] = []
    for number, entry in enumerate(dispatch_table(_DIALECT)):
        if isinstance(entry, Family):
            entries = {command: noted(each, names[number, command]) for command, each in entry.entries.items()}
            found.append(Family(entries, entry.unknown))
        else:
            name = names.get((number, None))
            found.append(noted(entry, name) if name else entry)
    return tuple(found)

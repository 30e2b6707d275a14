"""System commands whose fields may be omitted: what the functions of `ev3proto.system` call."""

from __future__ import annotations

from ev3proto.messages import FieldValue, SystemCommand
from ev3proto.schema.constructors import system_command


def request(number: int, counter: int, reply: bool, **fields: FieldValue | float | None) -> SystemCommand:
    """A system command; a field that is None is omitted. Raises BuildError, which names the field at fault."""
    given = {name: value for name, value in fields.items() if value is not None}
    return system_command(number, counter=counter, reply=reply, **given)

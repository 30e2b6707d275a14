"""Operations whose values are checked and encoded, with places in memory that may still be open."""

from __future__ import annotations

from collections.abc import Mapping

from ev3proto.errors import BuildError
from ev3proto.messages import GV, Operation, OperationReader, Variable
from ev3proto.schema.argument import encode_variable
from ev3proto.semantics.drafts.placeholders import Label, Need, Placeholder
from ev3proto.semantics.footprint import Footprint, footprints
from ev3proto.tables.declaration import Declaration

STAND_IN = encode_variable(GV(0))
"""What stands in a draft for an output that was omitted: the shortest variable that there is."""


class Open:
    """An output that was omitted: `command` makes a variable of it, in each command that has it."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "omitted"


OMITTED = Open()


class Draft:
    """An operation that was asked for: what `ev3proto.ops` makes and `ev3proto.command` takes.

    Its values are checked and encoded. What is open are the places of its outputs that were omitted and of variables
    that are `Local()` or `Global()`; a command gives them theirs.

    Attributes:
        schema: The operation's.
        encoded: Its bytes, opcode first, with a stand-in for each variable whose place is open.
        label: The place that it jumps to, where that is a label.
        needs: What each of its variables needs, where they are its last arguments and were omitted, all of them. None
            where that has to be found out by the footprints.
    """

    __slots__ = ("_places", "encoded", "label", "needs", "schema")

    def __init__(
        self,
        schema: OperationReader,
        encoded: bytes,
        places: Mapping[int, Placeholder | Open],
        needs: tuple[Need, ...] | None = None,
        label: Label | None = None,
    ) -> None:
        self.schema = schema
        self.encoded = encoded
        self.needs = needs
        self.label = label
        self._places = places

    @property
    def declaration(self) -> Declaration:
        """What the tables say of the operation."""
        return self.schema.declaration

    @property
    def name(self) -> str:
        """`SOUND.TONE`, or the opcode's name alone."""
        return self.declaration.name

    @property
    def is_complete(self) -> bool:
        """True when no place is open."""
        return not self._places and self.label is None

    @property
    def footprints(self) -> list[Footprint]:
        """The memory that it uses; variables whose place is open start at 0 here."""
        return footprints(self._standing)

    @property
    def operation(self) -> Operation:
        """The operation, by itself at offset 0. Raises BuildError while a place is open."""
        if self.label is not None:
            raise BuildError(f"{self.name}: only ev3proto.command knows how far it is to {self.label!r}")
        if self._places:
            names = ", ".join(found.argument.name for found in self.footprints if found.number in self._places)
            raise BuildError(
                f"{self.name}: {names} has no place in memory yet: ev3proto.command gives it one, or GV(0) and the like"
            )
        return self._standing

    @property
    def raw(self) -> bytes:
        """Its bytes, opcode first. Raises BuildError while a place is open."""
        return self.operation.raw

    @property
    def _standing(self) -> Operation:
        return Operation((self.schema, self.encoded, 0, len(self.encoded)))

    def place_of(self, footprint: Footprint) -> Placeholder | Open | None:
        """What stands in the place of a variable that is open; None for one that has an index."""
        return self._places.get(footprint.number)

    def placed(self, variables: Mapping[int, Variable]) -> bytes:
        """Its bytes with variables, by the number of the argument, in the places that are open."""
        if not self._places:
            return self.encoded
        arguments = self._standing.arguments
        pieces = [self.encoded[: arguments[0].offset]]
        for number, argument in enumerate(arguments):
            variable = variables.get(number)
            pieces.append(argument.raw if variable is None else encode_variable(variable, argument.name))
        return b"".join(pieces)

    def __repr__(self) -> str:
        shown: dict[int, object] = dict(self._places)
        if self.label is not None:
            shown[len(self.declaration.parameters) - 1] = self.label
        arguments = ", ".join(
            f"{argument.name}={shown.get(number, argument.value)!r}"
            for number, argument in enumerate(self._standing.arguments)
        )
        return f"<{self.name}({arguments})>"


def draft_of(operation: Operation) -> Draft:
    """An operation that was made otherwise, as a draft in which nothing is open."""
    schema, *_ = operation
    return Draft(schema, operation.raw, {})

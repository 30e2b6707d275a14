"""Operations whose values are checked and encoded, while variables may not have a place in memory yet."""

from __future__ import annotations

from collections.abc import Mapping

from ev3proto.errors import BuildError
from ev3proto.messages import GV, Operation, OperationReader, Variable
from ev3proto.schema.argument import encode_variable
from ev3proto.semantics.drafts.placeholders import Label, Need, Placeholder
from ev3proto.semantics.footprint import Footprint, footprints
from ev3proto.tables.declaration import Declaration

STAND_IN = encode_variable(GV(0))
"""The stand-in for an omitted output in a draft: the shortest variable."""


class Open:
    """An omitted output, for which `command` creates a variable in each command."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "omitted"


OMITTED = Open()


class Draft:
    """A requested operation: the result of `ev3proto.ops`, the input of `ev3proto.command`.

    Its values are checked and encoded. Still open are the places of omitted outputs and of
    `Local()` and `Global()` variables, which a command assigns.

    Attributes:
        schema: The schema of the operation.
        encoded: Its bytes, opcode first, with a stand-in for each variable whose place is open.
        label: The label that it jumps to, or None.
        needs: What each of its variables needs, if they are its last arguments and all omitted; else None,
            and the footprints tell.
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
        """Its declaration in the tables."""
        return self.schema.declaration

    @property
    def name(self) -> str:
        """`SOUND.TONE`, or the opcode's name alone."""
        return self.declaration.name

    @property
    def is_complete(self) -> bool:
        """Whether all places are assigned."""
        return not self._places and self.label is None

    @property
    def footprints(self) -> list[Footprint]:
        """Returns the memory that it uses; variables without a place start at 0."""
        return footprints(self._standing)

    @property
    def operation(self) -> Operation:
        """Returns the operation, alone at offset 0. Raises BuildError while a place is open."""
        if self.label is not None:
            raise BuildError(f"{self.name}: the distance to {self.label!r} is known only in ev3proto.command")
        if self._places:
            names = ", ".join(found.argument.name for found in self.footprints if found.number in self._places)
            raise BuildError(
                f"{self.name}: {names} has no place in memory yet: use ev3proto.command, or a variable such as GV(0)"
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
        """Returns the stand-in of a variable without a place; None if it has an index."""
        return self._places.get(footprint.number)

    def placed(self, variables: Mapping[int, Variable]) -> bytes:
        """Returns its bytes with variables, by number of the argument, in the open places."""
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
    """Returns any operation as a draft without open places."""
    return Draft(operation.schema, operation.raw, {})

"""The values of operations to bytes: names looked up, expressions worked out, macros obeyed, jumps left open."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ev3proto.errors import BuildError, counted
from ev3proto.messages import Variable
from ev3proto.schema.argument import (
    ArgumentSchema,
    encode_as,
    encode_float,
    encode_integer,
    encode_label,
    encode_string,
    encode_variable,
    with_bits,
)
from ev3proto.tables.declaration import DATA8, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL, RANGES
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.lexing import Token, TokenKind, unescaped
from ev3proto.text.assembly.parser import (
    TYPES,
    Chain,
    Element,
    Expression,
    Literal,
    Macro,
    Marked,
    Named,
    Negative,
    Raw,
    Value,
    error_at,
)
from ev3proto.text.assembly.symbols import NOT_NUMBERS, Constant, Names, Pattern, firmware_constant, suggestion

_LARGEST = 1 << 64
"""No number on the way to a value may be larger."""

_BITS = {"LC0": 6, "LC1": 8, "LC2": 16, "LC4": 32, "LAB1": 8}
"""Of the constants that fix their encoding."""

_JUMPS = ("LC0", "LC1", "LC2", "LC4", "LAB1")
_BY_SIZE = {1: "LC0", 2: "LC1", 3: "LC2", 5: "LC4"}
_SCOPES = {"L": LOCAL, "G": GLOBAL}
_MOST_MEMBERS = 6
_FLOATS = {"inf": math.inf, "nan": math.nan}

_ANYTHING = ArgumentSchema(Parameter("the value", Type.ARRAY_TYPED, "whatever an argument can be"))


@dataclass(frozen=True, slots=True)
class PendingJump:
    """How far it is to a label, which is known when all operations have their place.

    token  the label's name
    form   the encoding asked for, None for the shortest
    """

    token: Token
    form: str | None

    def encoded(self, distance: int, least: int = 1) -> bytes:
        """Its bytes, at least so many where the encoding is free. Raises AssemblyError where no encoding holds it."""
        try:
            if self.form is None:
                shortest = encode_integer(distance)
                return shortest if len(shortest) >= least else encode_as(_BY_SIZE[least], distance)
            return encode_label(distance) if self.form == "LAB1" else encode_as(self.form, distance)
        except BuildError as error:
            raise error_at(self.token, f"{self.token.text} is {distance} bytes away: {error}") from None


CodePiece = bytes | PendingJump


class Encoder:
    """Works values out with the names of a text."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def define(self, token: Token, value: Value) -> None:
        """Gives a constant, or an encoded argument, a name. It is worked out here and now. Raises AssemblyError."""
        if isinstance(value, Literal | Named | Negative | Chain):
            self.names.define(token, self.constant(value))
            return
        piece = self.argument(value, _ANYTHING)
        if isinstance(piece, PendingJump):
            raise error_at(value.token, "a label cannot be defined by another name")
        self.names.define(token, piece)

    # Numbers and texts

    def constant(self, value: Value, parameter: Parameter | None = None) -> Constant:
        """The number or text of a value that is no variable. Raises AssemblyError."""
        match value:
            case Literal(token):
                return _literal(token)
            case Named(token):
                return self._named_constant(token, parameter)
            case Negative(token, part):
                number = self._number(part, parameter)
                return _bounded(-number, token)
            case Chain(_, first, rest):
                return self._chain(first, rest, parameter)
        raise error_at(value.token, f"{value.token.text} cannot stand where a constant should")

    def whole(self, value: Value, what: str, low: int, high: int, parameter: Parameter | None = None) -> int:
        """A whole number in a range. Raises AssemblyError, which says of what."""
        found = self.constant(value, parameter)
        if not isinstance(found, int) or not low <= found <= high:
            raise error_at(value.token, f"{what} cannot be {found!r}: it is a whole number from {low} to {high}")
        return int(found)

    def whole_or_none(self, value: Value) -> int | None:
        """A whole number that stands in the text or has a name, in a macro or not; None for all other values."""
        while isinstance(value, Macro):
            value = value.part
        try:
            found = self.constant(value)
        except AssemblyError:
            return None
        return found if isinstance(found, int) else None

    def _named_constant(self, token: Token, parameter: Parameter | None) -> Constant:
        name = token.text
        if name in self.names.constants:
            defined = self.names.constants[name]
            if isinstance(defined, bytes):
                raise error_at(token, f"{name} is an encoded argument; a plain constant should stand here")
            return defined
        found = firmware_constant(name, parameter)
        if found is not None:
            return found
        if name in self.names.variables:
            raise error_at(token, f"{name} is a variable; a constant should stand here")
        if name in _FLOATS:
            return _FLOATS[name]
        raise self._unknown(token, parameter)

    def _is_constant(self, token: Token, parameter: Parameter | None) -> bool:
        name = token.text
        return name in self.names.constants or name in _FLOATS or firmware_constant(name, parameter) is not None

    def _unknown(self, token: Token, parameter: Parameter | None) -> AssemblyError:
        """The error of a name that means nothing here."""
        return error_at(token, f"there is no {token.text}{suggestion(token.text, self.names.known(parameter))}")

    def _undeclared(self, token: Token, parameter: Parameter) -> AssemblyError:
        """The error of a name that stands for nothing that the parameter can be."""
        name, enum = token.text, parameter.enum
        if parameter.is_output:
            what, known = f"variable {name}", list(self.names.variables)
        elif parameter.role is Role.OBJECT:
            what, known = f"object {name}", list(self.names.constants)
        elif enum is not None:
            what, known = f"{name} in {enum.name}, the values of {parameter.name}", self.names.known(parameter)
        else:
            what, known = f"variable or constant {name}", self.names.known(parameter)
        hint = suggestion(name, known)
        if parameter.role is Role.OBJECT:
            hint = hint or f": `define {name} 2` in front of it tells the number of the object, counted from 1"
        elif enum is None or parameter.is_output:
            kind = parameter.type.label if parameter.type.label in TYPES else DATA8.label
            declares = f"`{kind} {name}` in front of it declares a variable"
            hint = f"{hint} Or {declares}" if hint else f": {declares}"
        elif not hint:
            hint = f": it has {', '.join(list(enum.members)[:_MOST_MEMBERS])}, ..."
        return error_at(token, f"there is no {what}{hint}")

    def _number(self, value: Expression, parameter: Parameter | None) -> int | float:
        found = self.constant(value, parameter)
        if isinstance(found, str):
            raise error_at(value.token, f"{found!r} is a text: it cannot be reckoned with")
        return found

    def _chain(
        self, first: Expression, rest: tuple[tuple[Token, Expression], ...], parameter: Parameter | None
    ) -> int | float:
        total = self._number(first, parameter)
        for operator, part in rest:
            total = _bounded(_joined(operator, total, self._number(part, parameter)), operator)
        return total

    # Arguments

    def argument(self, value: Value, schema: ArgumentSchema) -> CodePiece:
        """The bytes of one argument of an operation. Raises AssemblyError."""
        try:
            return self._argument(value, schema)
        except BuildError as error:
            raise error_at(value.token, str(error)) from None

    def element(self, value: Value, schema: ArgumentSchema) -> CodePiece:
        """The bytes of one value of a list. A letter may stand for its number. Raises AssemblyError."""
        if isinstance(value, Literal) and schema.parameter.type is Type.DATA8:
            found = self.constant(value)
            if isinstance(found, str) and len(found) == 1:
                return schema.write(ord(found))
        return self.argument(value, schema)

    def _argument(self, value: Value, schema: ArgumentSchema) -> CodePiece:
        match value:
            case Raw(_, data):
                return schema.write(data)
            case Named(token) if isinstance(encoded := self.names.constants.get(token.text), bytes):
                return schema.write(encoded)
            case Macro():
                return self._macro(value, schema)
            case Marked(token, part):
                return schema.write(self._variable(part, None, handle=token.text == "@", address=token.text == "&"))
            case Element():
                return schema.write(self._variable(value, schema))
            case Named(token) if token.text in self.names.variables:
                return schema.write(self._variable(value, schema))
            case Named(token) if self._is_label(token, schema):
                return PendingJump(token, None)
            case Named(token) if token.text in NOT_NUMBERS and schema.parameter.type is not Type.STRING:
                return schema.write(math.nan)
            case Named(token) if not self._is_constant(token, schema.parameter):
                raise self._undeclared(token, schema.parameter)
        return self._plain(self.constant(value, schema.parameter), schema)

    def _plain(self, found: Constant, schema: ArgumentSchema) -> bytes:
        kind = schema.parameter.type
        if isinstance(found, Pattern) and kind in RANGES and kind.size:
            found = _signed(found, 8 * kind.size)
        return schema.write(found)

    def _is_label(self, token: Token, schema: ArgumentSchema) -> bool:
        """Whether a name is one to jump to, which may stand further down. Raises AssemblyError where none can stand."""
        name = token.text
        if schema.parameter.role is Role.JUMP:
            return name not in self.names.constants and name not in self.names.variables
        if name in self.names.labels:
            raise error_at(token, f"{name} is a label, which cannot stand for {schema.parameter.name}")
        return False

    def _variable(
        self, value: Named | Element, schema: ArgumentSchema | None, *, handle: bool = False, address: bool = False
    ) -> Variable:
        """The place of a declared variable or of one of its elements. Raises AssemblyError."""
        name = value.token.text
        declared = self.names.variables.get(name)
        if declared is None:
            known = suggestion(name, self.names.variables)
            raise error_at(
                value.token, f"there is no variable {name}{known or ': DATA8, DATAF and others declare one'}"
            )
        index = declared.variable.index
        if isinstance(value, Element):
            number = self.whole(value.index, f"an index of {name}", 0, declared.count - 1)
            index += number * declared.type.size
        if schema is not None:
            self._check_room(value.token, declared.end - index, schema)
        return Variable(declared.variable.scope, index, handle=handle, address=address)

    def _check_room(self, token: Token, room: int, schema: ArgumentSchema) -> None:
        """Raises AssemblyError where a parameter is larger than the variable: what stands after it would be hit."""
        parameter = schema.parameter
        if parameter.type.size > room and not parameter.any_type:
            verb = "is read as" if parameter.direction is Direction.IN else "would be overwritten by"
            raise error_at(
                token,
                f"{token.text} has {counted(room, 'byte')} here and {verb} {parameter.name}, a {parameter.type}"
                f" of {parameter.type.size}",
            )

    def _macro(self, value: Macro, schema: ArgumentSchema) -> CodePiece:
        name = value.token.text
        part = value.part
        if name in ("HND", "ADR"):
            inner = self.argument(part, schema)
            if isinstance(inner, PendingJump):
                raise error_at(part.token, f"{name} takes no label")
            return with_bits(inner, handle=name == "HND", address=name == "ADR")
        if isinstance(part, Named) and name in _JUMPS and self._is_label(part.token, schema):
            return PendingJump(part.token, name)
        return self.form(value, schema.parameter)

    def form(self, value: Macro, parameter: Parameter | None) -> bytes:
        """The bytes of a macro that fixes the encoding. Raises AssemblyError, BuildError."""
        name, part = value.token.text, value.part
        if name[:2] in ("LV", "GV"):
            return self._variable_form(name, part)
        found = self.constant(part, parameter)
        if name in ("LCS", "LCS_OLD"):
            if not isinstance(found, str):
                raise error_at(part.token, f"{name} takes a text in quotes, not {found!r}")
            return encode_string(found) if name == "LCS" else encode_as(name, found)
        if isinstance(found, str) and len(found) == 1:
            found = ord(found)
        if isinstance(found, str):
            raise error_at(part.token, f"{name} takes a number, not {found!r}")
        if name == "LCF":
            is_none = isinstance(part, Named) and part.token.text in NOT_NUMBERS
            return encode_float(math.nan if is_none else found, "the number")
        if isinstance(found, float):
            raise error_at(part.token, f"{name} takes a whole number, not {found!r}; LCF takes this one")
        if name == "LCX":
            return encode_integer(found)
        if isinstance(found, Pattern):
            found = _signed(found, _BITS[name])
        return encode_label(found, name) if name == "LAB1" else encode_as(name, found)

    def _variable_form(self, name: str, part: Value) -> bytes:
        scope = _SCOPES[name[0]]
        if isinstance(part, Element) or (isinstance(part, Named) and part.token.text in self.names.variables):
            variable = self._variable(part, None)
            if variable.scope != scope:
                raise error_at(
                    part.token, f"{part.token.text} is a {variable.scope} variable, {name} is for {scope} ones"
                )
            index = variable.index
        else:
            index = self.whole(part, f"the index of {name}", 0, 0xFFFFFFFF)
        return encode_variable(Variable(scope, index)) if name[2:] in ("", "X") else encode_as(name, index)


def _literal(token: Token) -> Constant:
    if token.kind is TokenKind.TEXT:
        return unescaped(token)[0]
    text = token.text.lower()
    if text.startswith("0x"):
        return Pattern(text, 16)
    if text.startswith("0b"):
        return Pattern(text, 2)
    return int(text) if text.isdigit() else float(text.rstrip("f"))


def _bounded(number: int | float, token: Token) -> int | float:
    if isinstance(number, int) and abs(number) >= _LARGEST:
        raise error_at(token, "the numbers become larger than anything in a frame")
    return number


def _joined(operator: Token, left: int | float, right: int | float) -> int | float:
    match operator.text:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            if right == 0:
                raise error_at(operator, "a division by zero has no value")
            if isinstance(left, int) and isinstance(right, int):
                return abs(left) // abs(right) * (1 if (left < 0) == (right < 0) else -1)
            return left / right
    if isinstance(left, int) and isinstance(right, int):
        return left | right
    raise error_at(operator, "| joins the bits of whole numbers")


def _signed(pattern: int, bits: int) -> int:
    """A pattern of so many bits as a number with a sign; itself where it has more bits."""
    return pattern - (1 << bits) if 1 << (bits - 1) <= pattern < 1 << bits else int(pattern)

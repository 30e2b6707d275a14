"""The most common mistake by hand: a number as a raw byte, where the firmware expects an identification byte.

75 as `4B` is the variable LV(11), -100 as `9C` is a text up to the next zero, and -20 as `EC` is undefined. The
documented values of a parameter decide whether a byte may be meant as a number.
"""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.checking import codes
from ev3proto.checking.context import CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.messages import Argument
from ev3proto.schema.argument import LABEL_BYTE, encode_integer
from ev3proto.semantics.facts import ParameterFacts
from ev3proto.semantics.flow import is_label
from ev3proto.semantics.footprint import Footprint
from ev3proto.tables.declaration import Direction, Parameter, Role, Type
from ev3proto.tables.encoding import CONSTANT, ENCODINGS, GLOBAL, JUMP, TEXT, Encoding
from ev3proto.tables.validation import LABELS

_BYTE = 1 << 8
_WORD = 1 << 16
_NUMBERS = (Type.DATA8, Type.DATA16, Type.DATA32)
_FIRST_ODD_LABEL = LABEL_BYTE + 4
"""The first identification byte that the firmware reads as a label, but no program writes for one."""
_NOT_NUMBERS = (Role.JUMP, Role.LABEL)


def takes_a_number(parameter: Parameter) -> bool:
    """Returns whether a parameter reads a number that is not the target of a jump."""
    is_single = parameter.length is None and parameter.indexed_by is None
    is_read = parameter.direction is Direction.IN and is_single
    return is_read and parameter.type in _NUMBERS and parameter.role not in _NOT_NUMBERS


def raw_numbers(known: ParameterFacts, data: bytes, at: int) -> list[int]:
    """Returns the documented values of a parameter that raw bytes at an offset may mean.

    One byte, unsigned or else signed; for a parameter of more bytes also two, as in `B8 01` for 440.
    """
    return [] if known.domain is None else _numbers(known, data, at, known.domain.covers)


def _numbers(known: ParameterFacts, data: bytes, at: int, is_legal: Callable[[int], bool]) -> list[int]:
    if not takes_a_number(known.parameter):
        return []
    ways = [(data[at], _BYTE)]
    if known.parameter.type is not Type.DATA8 and at + 1 < len(data):
        ways.append((int.from_bytes(data[at : at + 2], "little"), _WORD))
    found = (next(filter(is_legal, (number, number - above)), None) for number, above in ways)
    return list(dict.fromkeys(number for number in found if number is not None))


def _sure_numbers(known: ParameterFacts, data: bytes, at: int) -> list[int]:
    """Returns the same for a byte that cannot begin an argument, where undocumented values count, too."""
    limits = known.limits
    if known.domain is None and limits is not None:
        found = _numbers(known, data, at, lambda number: limits.low <= number <= limits.high)
    else:
        found = raw_numbers(known, data, at)
    return found[::-1]


def written_as(number: int) -> str:
    """Returns `the number 75 is written 81 4B`."""
    return f"the number {number} is written {_hex(number)}"


def how_to_write(numbers: list[int]) -> str:
    """Returns `write the number 75 as 81 4B`, or more of them."""
    return f"write the number {', or '.join(f'{number} as {_hex(number)}' for number in numbers)}"


def _hex(number: int) -> str:
    return encode_integer(number).hex(" ").upper()


def raw_variable(operation: CheckedOperation, place: Footprint, asked: int, most: int) -> Finding | None:
    """Returns the finding about a variable beyond the requested memory, if it may be a raw byte."""
    argument, form = place.argument, place.argument.form
    if form.width and not (form.handle or form.address):
        return None  # a GV1 is written on purpose
    numbers = raw_numbers(place.facts, operation.parsed.raw, argument.offset - operation.start)
    if not numbers:
        return None
    scope = "global" if form.kind == GLOBAL else "local"
    has = f"of which the header requests {counted(asked, 'byte')}" if asked else "which the header does not request"
    more = f", or request {counted(place.end, 'byte')} of {scope} memory" if place.end <= most else ""
    variable = place.variable
    return operation.finding_at(
        codes.RAW_BYTE,
        argument,
        f"0x{argument.raw[0]:02X} is {variable}, a variable at byte {variable.index} of {scope} memory, {has};"
        f" {written_as(numbers[0])}",
        f"{how_to_write(numbers)}{more}",
    )


def also_a_number(place: Footprint) -> str:
    """Returns the second advice about a variable beyond its memory: `, or write the number 75 as 81 4B`; or nothing."""
    argument = place.argument
    numbers = raw_numbers(place.facts, argument.raw, 0)[:1]
    if not numbers and not argument.form.width and takes_a_number(argument.parameter):
        numbers = [argument.raw[0]]
    return f", or {how_to_write(numbers)} if that is meant" if numbers else ""


def raw_constant(operation: CheckedOperation, argument: Argument, known: ParameterFacts) -> Finding | None:
    """Returns the finding about a text, a handle or an address where a number belongs, if it may be a raw byte."""
    form = argument.form
    if form.kind != TEXT and not (form.kind == CONSTANT and (form.handle or form.address)):
        return None
    numbers = raw_numbers(known, argument.raw, 0)
    is_plain = form.kind == TEXT and not (form.handle or form.address)
    if not numbers or (is_plain and str(argument.value).isprintable() and argument.value):
        return None
    taken = argument.length - 1
    return operation.finding_at(
        codes.RAW_BYTE,
        argument,
        f"0x{argument.raw[0]:02X} begins {_said(form)}, which takes the next {counted(taken, 'byte')};"
        f" {written_as(numbers[0])}",
        how_to_write(numbers),
    )


def raw_start(operation: CheckedOperation, known: ParameterFacts, data: bytes, at: int) -> Finding | None:
    """Returns the finding about an argument that cannot be read, if its first byte may be a raw byte."""
    if at >= len(data):
        return None
    form = ENCODINGS[data[at]]
    numbers = (_sure_numbers if form is None else raw_numbers)(known, data, at)
    if not numbers:
        return None
    if form is not None and form.kind != TEXT and not (form.handle or form.address):
        return None  # a real argument that is cut off
    what = "begins no argument" if form is None else f"begins {_said(form)}, which the frame does not end"
    return codes.RAW_BYTE.finding(
        at,
        1,
        f"0x{data[at]:02X} {what}; {written_as(numbers[0])}",
        how_to_write(numbers),
        operation.name,
        known.parameter.name,
    )


def label_for_number(operation: CheckedOperation, argument: Argument, known: ParameterFacts) -> Finding | None:
    """Returns the finding about a label where a number belongs."""
    if argument.form.kind != JUMP or not takes_a_number(known.parameter):
        return None
    value = int(argument.value)
    numbers = [value, -value] if value > 0 else [value]
    if argument.raw[0] >= _FIRST_ODD_LABEL:
        numbers = raw_numbers(known, argument.raw, 0) + numbers
    numbers = [number for number in numbers if known.domain is None or known.domain.covers(number)] or numbers
    advice = how_to_write(list(dict.fromkeys(numbers)))
    first = f"0x{argument.raw[0]:02X} is LAB1, a label"
    if is_label(argument):
        sentence = f"{first}: the brick puts the place of label {value} here, not a number"
        return operation.finding_at(codes.LABEL_FOR_NUMBER, argument, sentence, advice)
    # The brick takes the byte of another label without its sign.
    number = value if known.parameter.type is Type.DATA8 else argument.raw[1]
    sentence = f"{first}, but labels are 1 to {LABELS - 1}: the brick takes this one as the number {number}"
    return operation.finding_at(codes.NUMBER_AS_LABEL, argument, sentence, advice)


def _said(form: Encoding) -> str:
    bits = " and ".join(name for name, is_set in (("handle", form.handle), ("address", form.address)) if is_set)
    kind = "text" if form.kind == TEXT else "constant" if form.kind == CONSTANT else "variable"
    what = f"a {kind} ({form.name})"
    return f"{what} with the {bits} bit{'s' if ' ' in bits else ''}" if bits else what


def is_swallowing(finding: Finding) -> bool:
    """Returns whether a finding is about a raw byte that is read as an argument of several bytes."""
    return (
        finding.code in (codes.RAW_BYTE.code, codes.LABEL_FOR_NUMBER.code, codes.NUMBER_AS_LABEL.code)
        and finding.length > 1
    )

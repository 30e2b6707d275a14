"""What a message does, in one sentence for people: `Plays 440 Hz for 1 s at volume 1 %.`

The words are in the tables: an operation has a sentence with places for its arguments, or else its line of description.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from ev3proto.dialogue import Exchange
from ev3proto.errors import counted
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
    own_fault,
)
from ev3proto.tables.declaration import Role
from ev3proto.tables.encoding import GLOBAL, LOCAL, TEXT
from ev3proto.tables.output import LETTERS
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.text.phrases import (
    argument_value,
    command_name,
    plain,
    refusal_meaning,
    short_text,
    status_name,
    value_text,
)

MOST_OPERATIONS = 4
"""Maximum number of operations that a sentence describes."""

MOST_VALUES = 6
"""Maximum number of values of a reply in a sentence."""

_CLAUSE = re.compile(r"\[([^\]]*)\]")
_PLACE = re.compile(r"\{([\w+]+)\}")
_ASIDE = re.compile(r" and returns at once| \([^)]*\)|[;,:] .*")
_MILLISECONDS = 1000
_UNITS = {"degrees": "°"}
_FIRST_MOTOR = 16
"""The number of motor port A where sensors and motors are counted together."""


def sentence(exchange: Exchange, missing: int = 0) -> str:
    """Returns what a message does, or what it answers.

    Args:
        exchange: The message, with what its dialogue tells about it.
        missing: The number of bytes at its end that the text or the capture left out.

    Returns:
        A sentence that begins with a capital letter and ends with a full stop.
    """
    text, fault = deed(exchange), own_fault(exchange.message, missing)
    if fault is not None:
        wrong = f"wrong at offset {fault.offset}: {fault.reason.partition(': ')[0]}"
        text = f"{text}; but it is {wrong}" if text else wrong
    elif missing:
        text = f"{text or 'a frame'}; its last {counted(missing, 'byte')} are missing"
    text = text or "not an EV3 message"
    return f"{text[0].upper()}{text[1:]}."


def deed(exchange: Exchange) -> str:
    """Returns what a message does or answers, as the end of a sentence; empty where nothing of it could be read."""
    return "".join(_deed(exchange))


def _deed(exchange: Exchange) -> Iterator[str]:
    message = exchange.message
    if message.flaw.headless:
        return
    if isinstance(message, DirectCommand):
        yield _operations(message.operations) or ("" if message.fault is not None else "does nothing")
    elif isinstance(message, SystemCommand):
        yield _system(message)
    elif isinstance(message, DaisyCommand):
        asked = _operations(message.operations) or command_name(message)
        yield f"asks brick {message.layer_to} of the daisy chain: {asked}"
    elif isinstance(message, DirectReply | DaisyReply | SystemReply) and message.type is not None:
        yield _answer(exchange, message)


def _operations(operations: tuple[Operation, ...]) -> str:
    shown = [operation_sentence(operation) for operation in operations[:MOST_OPERATIONS]]
    left = len(operations) - len(shown)
    if left:
        shown.append(f"{left} more operations" if left > 1 else "one more operation")
    return ", then ".join(shown)


def operation_sentence(operation: Operation) -> str:
    """Returns what an operation does: `plays 440 Hz for 1 s at volume 1 %`."""
    declaration = operation.declaration
    arguments: dict[str, Argument] = {argument.name: argument for argument in operation.arguments}
    if not declaration.sentence:
        given = [f"{argument.name} {_value(argument)}" for argument in arguments.values() if _is_told(argument)]
        return _with_given(declaration.text, given)
    text = _CLAUSE.sub(lambda found: _clause(found[1], arguments), declaration.sentence)
    text = _PLACE.sub(lambda found: _place(found[1], arguments), text)
    return text + "".join(_layers(arguments))


def _clause(text: str, arguments: dict[str, Argument]) -> str:
    """Returns a clause in the form that fits its value; nothing for a variable."""
    usual, _, special = text.partition("|")
    (name,) = _PLACE.findall(usual)
    argument = arguments.get(name)
    if argument is None or argument.is_variable:
        return ""
    return special if special and _number(argument) in argument.parameter.special else usual


def _place(names: str, arguments: dict[str, Argument]) -> str:
    """Returns a value, or the sum of several."""
    found = [arguments[name] for name in names.split("+") if name in arguments]
    if not found:
        return "?"
    if len(found) == 1:
        return _value(found[0])
    if any(argument.is_variable for argument in found):
        return " + ".join(map(_value, found))
    return _with_unit(sum(map(_number, found)), found[0].parameter.unit)


def _layers(arguments: dict[str, Argument]) -> Iterator[str]:
    """Yields which brick of a daisy chain is meant, if that is not the first one."""
    for argument in arguments.values():
        if argument.parameter.role is Role.LAYER and (argument.is_variable or _number(argument)):
            yield f" on layer {_value(argument)}"


def _is_told(argument: Argument) -> bool:
    """Returns whether an argument of an operation without a sentence says something: inputs, but for layer 0."""
    parameter = argument.parameter
    if parameter.is_output or parameter.role in (Role.JUMP, Role.LABEL):
        return False
    return parameter.role is not Role.LAYER or argument.is_variable or _number(argument) != 0


def _number(argument: Argument) -> int:
    return argument.value if isinstance(argument.value, int) else 0


def _value(argument: Argument) -> str:
    """Returns a value in words."""
    parameter, value = argument.parameter, argument.value
    if argument.form.kind in (LOCAL, GLOBAL, TEXT) or not isinstance(value, int):
        return short_text(argument_value(argument))
    if parameter.role in _BY_ROLE:
        return _BY_ROLE[parameter.role](value)
    return parameter.special.get(value) or argument.symbol or _with_unit(value, parameter.unit)


def _motors(mask: int) -> str:
    names = [letter for letter, number in LETTERS.items() if mask & 1 << number]
    if not names:
        return "no motor"
    return f"motor {names[0]}" if len(names) == 1 else f"motors {', '.join(names[:-1])} and {names[-1]}"


def _motor(number: int) -> str:
    letter = _letter(number)
    return "no motor" if letter is None else f"motor {letter}"


def _port(number: int) -> str:
    letter = _letter(number - _FIRST_MOTOR)
    return f"port {number + 1}" if letter is None else f"port {letter}"


def _letter(number: int) -> str | None:
    return next((letter for letter, at in LETTERS.items() if at == number), None)


def _drive(percent: int) -> str:
    return f"{percent} %, backward" if percent < 0 else f"{percent} %"


_BY_ROLE = {Role.MOTORS: _motors, Role.MOTOR: _motor, Role.PORT: _port, Role.DRIVE: _drive}


def _with_unit(value: int, unit: str | None) -> str:
    """Returns a number with its unit; milliseconds as seconds, where there are many."""
    if unit == "ms" and abs(value) >= _MILLISECONDS:
        return f"{value / _MILLISECONDS:g} s"
    if unit in _UNITS:
        return f"{value}{_UNITS[unit]}"
    return f"{value} {unit}" if unit and unit != "px" else str(value)


def _system(message: SystemCommand) -> str:
    declared = SYSTEM_BY_NUMBER.get(message.number)
    if declared is None:
        return f"sends the unknown system command 0x{message.number:02X}"
    given = [f"{name} {short_text(plain(value))}" for name, value in message.fields.items() if value not in (b"", None)]
    return _with_given(declared.text, given)


def _with_given(text: str, given: list[str]) -> str:
    """Returns the start of a line of description, with the values that are given."""
    start = _ASIDE.sub("", text)
    values = f" ({', '.join(given)})" if given else ""
    return f"{start[0].lower()}{start[1:]}{values}"


def _answer(exchange: Exchange, message: DirectReply | DaisyReply | SystemReply) -> str:
    what = f"answers command {message.counter}"
    if isinstance(message, SystemReply):
        return f"{what}: {command_name(message)} {status_name(message)}{refusal_meaning(message)}"
    if message.type is not None and message.type.is_error:
        return f"{what}: it failed"
    shown = [
        f"{value.quantity or value.name} is {short_text(value_text(value))}" for value in exchange.values[:MOST_VALUES]
    ]
    left = len(exchange.values) - len(shown)
    return f"{what}: {', '.join(shown) or _unknown(message)}{f', and {left} more values' if left else ''}"


def _unknown(message: Message) -> str:
    """Returns what is said of a reply without known values."""
    memory = getattr(message, "memory", b"")
    return f"ok, with {counted(len(memory), 'byte')} of memory" if memory else "ok"

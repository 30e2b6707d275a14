"""Calls that do not fit a generated function's parameters: a sentence says what would fit."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from ev3proto.errors import near_misses

_Parameters = ParamSpec("_Parameters")
_Result = TypeVar("_Result")


class _Required:
    """The default of a parameter that has to be given, where another before it may be omitted."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "required"


REQUIRED: Any = _Required()


class MissingValueError(TypeError):
    """A parameter has no value, and its default is REQUIRED."""


def explained(function: Callable[_Parameters, _Result]) -> Callable[_Parameters, _Result]:
    """The same function; where a call does not fit its parameters, the TypeError names the nearest ones."""

    @wraps(function)
    def call(*values: _Parameters.args, **named: _Parameters.kwargs) -> _Result:
        try:
            return function(*values, **named)
        except TypeError as error:
            # Without a frame of its own the function was never entered: the call did not fit.
            was_entered = error.__traceback__ is not None and error.__traceback__.tb_next is not None
            if was_entered and not isinstance(error, MissingValueError):
                raise
            sentence = _misfit(function, values, named) or str(error)
        raise TypeError(sentence)

    return call


def _misfit(function: Callable[..., Any], values: Sequence[Any], named: Mapping[str, Any]) -> str | None:
    """Why a call does not fit, None where it does."""
    parameters = inspect.signature(function).parameters.values()
    ordered = [each for each in parameters if each.kind is inspect.Parameter.POSITIONAL_OR_KEYWORD]
    names = [each.name for each in ordered]
    name = _called(function)
    if len(values) > len(names):
        known = ", ".join(names) or "none"
        return f"{name}() takes at most {len(names)} values ({known}), not {len(values)}"
    given = dict(zip(names, values, strict=False))
    options = [each.name for each in parameters if each.kind is inspect.Parameter.KEYWORD_ONLY]
    for parameter in named:
        if parameter in options:
            continue
        if parameter not in names:
            hint = near_misses(parameter, [other.upper() for other in (*names, *options)]).lower()
            known = f": it has {', '.join(names) or 'none'}"
            return f"{name}() has no parameter {parameter}{hint or known}"
        if parameter in given:
            return f"{name}() has two values for {parameter}"
    given |= named
    missing = [
        each.name
        for each in ordered
        if each.default in (inspect.Parameter.empty, REQUIRED) and given.get(each.name) is None
    ]
    return f"{name}() needs {' and '.join(missing)}, too" if missing else None


def _called(function: Callable[..., Any]) -> str:
    """A function as it is called in a program: `sound.tone`; `output_start` where it is in no family."""
    package, _, module = function.__module__.rpartition(".")
    is_alone = package == "ev3proto" or package.endswith(".plain")
    return function.__name__ if is_alone else f"{module}.{function.__name__}"

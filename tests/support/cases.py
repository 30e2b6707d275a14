"""Many small cases in one test: for such cases, pytest's overhead per test is larger than the test."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any

import pytest

_MOST_SHOWN = 10


def each(names: str, cases: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Like `pytest.mark.parametrize`, but all cases are one test. It tries all of them and reports those that fail.

    Args:
        names: The names of the parameters, separated by commas.
        cases: A value for each case, or a tuple with a value for each name.
    """
    parameters = [name.strip() for name in names.split(",")]
    given = [case if len(parameters) > 1 else (case,) for case in cases]
    assert given, "there are no cases"

    def decorated(test: Callable[..., None]) -> Callable[..., None]:
        @wraps(test, updated=())
        def tries_all(**fixtures: Any) -> None:
            failed: list[BaseException] = []
            for case in given:
                try:
                    test(**dict(zip(parameters, case, strict=True)), **fixtures)
                except (Exception, pytest.fail.Exception) as error:
                    error.add_note(f"case: {', '.join(map(_shown, case))}")
                    failed.append(error)
            if failed:
                raise BaseExceptionGroup(f"{len(failed)} of {len(given)} cases failed", failed[:_MOST_SHOWN])

        signature = inspect.signature(test)
        left = [parameter for name, parameter in signature.parameters.items() if name not in parameters]
        tries_all.__signature__ = signature.replace(parameters=left)  # type: ignore[attr-defined]
        return tries_all

    return decorated


def _shown(value: object) -> str:
    name = getattr(value, "name", None)
    return name if isinstance(name, str) else repr(value)

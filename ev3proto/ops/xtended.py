"""Every operation of the community's extended firmware as a function, as `ev3proto.ops` has those of LEGO's own."""

from typing import Any

from ev3proto.ops.making import Operations

_OPERATIONS = Operations("xtended")


def __getattr__(name: str) -> Any:
    """A function, or a family of them."""
    value = globals()[name] = getattr(_OPERATIONS, name)
    return value


def __dir__() -> list[str]:
    return dir(_OPERATIONS)

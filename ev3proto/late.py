"""Names of a module: those that are loaded when they are first used, and hints for those that do not exist.

The generated modules end in functions of these, as their `__getattr__` and `__dir__` (PEP 562).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from typing import Any

from ev3proto.errors import near_misses

ModuleFunctions = tuple[Callable[[str], Any], Callable[[], list[str]]]
"""`__getattr__` and `__dir__` of a module."""


def listed(names: Iterable[str], unknown: str) -> ModuleFunctions:
    """For a module that has its names: it lists those, and suggests the nearest for any other.

    Args:
        names: What the module is for.
        unknown: What an AttributeError says before the name: `there is no enumeration `.
    """
    known = sorted(names)

    def get(name: str) -> Any:
        raise _unknown(name, known, unknown)

    return get, lambda: list(known)


def late(
    namespace: dict[str, Any], modules: Mapping[str, str], contents: Mapping[str, Iterable[str]], unknown: str
) -> ModuleFunctions:
    """For a module whose names are in others, which are loaded when one of their names is first used.

    Args:
        namespace: The module's own, where a name stays once it is loaded.
        modules: Names that are modules themselves, and the path of each.
        contents: The paths of modules, and the names that they have.
        unknown: What an AttributeError says before a name that does not exist.
    """
    homes = {name: path for path, names in contents.items() for name in names}
    known = sorted([*modules, *homes])

    def get(name: str) -> Any:
        if name in modules:
            found = import_module(modules[name])
        elif name in homes:
            found = getattr(import_module(homes[name]), name)
        else:
            raise _unknown(name, known, unknown)
        namespace[name] = found
        return found

    return get, lambda: list(known)


def _unknown(name: str, known: Sequence[str], unknown: str) -> AttributeError:
    # Python and its tools ask modules for names of their own, such as __path__: no hint would be right.
    if name.startswith("__"):
        return AttributeError(name)
    hint = near_misses(name, [other.upper() for other in known])
    return AttributeError(f"{unknown}{name}{hint.lower() if known[0].islower() else hint}")

"""Errors, described in a sentence: of decoding (with the offset) and of building (with the parameter)."""

from __future__ import annotations

from collections.abc import Iterable
from enum import EnumType
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

from construct.core import ConstructError


class Fault(NamedTuple):
    """A fault of a frame that was read with `strict=False`.

    offset     of the faulty byte, from the start of the frame
    reason     one sentence
    truncated  whether the frame ended before its contents did
    """

    offset: int
    reason: str
    truncated: bool = False

    def __str__(self) -> str:
        return f"offset {self.offset}: {self.reason}"


class Error(Exception):
    """The base of the errors that this package raises about frames, files, texts and connections."""


class DecodeError(ConstructError, ValueError, Error):  # type: ignore[misc]
    """Bytes that are not a valid frame; `offset` counts from the start of the frame or stream."""

    def __init__(self, offset: int, reason: str, truncated: bool = False, path: str | None = None) -> None:
        self.fault = Fault(offset, reason, truncated)
        super().__init__(str(self.fault), path)

    @property
    def offset(self) -> int:
        """The offset of the faulty byte."""
        return self.fault.offset

    @property
    def reason(self) -> str:
        """What is wrong, as a sentence."""
        return self.fault.reason

    @property
    def truncated(self) -> bool:
        """Whether the bytes ended before their contents did."""
        return self.fault.truncated

    def __reduce__(self) -> tuple[type[DecodeError], tuple[int, str, bool, str | None]]:
        return (type(self), (*self.fault, self.path))


class BuildError(ConstructError, ValueError, Error):  # type: ignore[misc]
    """Values that do not fit into a frame; the message names the parameter, the value and what would be right."""


def as_bytes(data: Any, what: str) -> bytes:
    """Returns the bytes of a bytes-like object.

    Args:
        data: The object.
        what: Its name in the error message.

    Returns:
        The bytes.

    Raises:
        TypeError: It is not bytes-like. For a text with hex, the message shows how to convert it.
    """
    try:
        return bytes(memoryview(data))
    except TypeError:
        pass
    if isinstance(data, str):
        raise TypeError(f"{what} must be bytes, not text: convert hex by bytes.fromhex({shortened(data)})")
    raise TypeError(f"{what} must be bytes, not {type(data).__name__}")


def shortened(text: str) -> str:
    """Returns a text in quotes, shortened to its first letters."""
    most = 16
    return repr(text) if len(text) <= most else repr(f"{text[:most]}...")


def counted(count: int, noun: str) -> str:
    """Returns a number with its noun, whose plural ends in s: `1 byte`, `2 bytes`."""
    return f"{count} {noun}{'s' * (count != 1)}"


_LIKENESS = 0.67
_SHORT = 3
_LIKENESS_OF_SHORT = 0.8
_MOST_GUESSED = 60
_MOST_KNOWN = 5000


def near_misses(name: str, known: Iterable[str]) -> str:
    """Returns `: did you mean SOUND.TONE?` for a name that `near_names` finds known ones for; or nothing."""
    near = near_names(name, known)
    return f": did you mean {' or '.join(near)}?" if near else ""


def near_names(name: str, known: Iterable[str]) -> list[str]:
    """Returns the known names that a name, or a part of it, is close to: at most three.

    The case of letters does not count. Names of more than 60 characters are not compared, and of the known ones 5000.
    """
    if len(name) > _MOST_GUESSED:
        return []
    import difflib  # takes 1 ms, which only a misspelt name should cost

    names = list(islice(known, _MOST_KNOWN))
    targets = {full.upper(): full for full in reversed(names)}
    for full in names:
        head, _, last = full.rpartition(".")
        targets.setdefault(last.upper(), full)
        if head:
            targets.setdefault(head.upper(), head)
    upper = name.upper()
    least = _LIKENESS if len(name) > _SHORT else _LIKENESS_OF_SHORT
    close = [upper] if upper in targets else difflib.get_close_matches(upper, targets, 3, least)
    return [full for full in dict.fromkeys(targets[found] for found in close) if full != name]


class MemberNames(EnumType):
    """The class of an enumeration: an unknown member is reported with the nearest one."""

    if not TYPE_CHECKING:  # where an unknown member is an error

        def __getattr__(cls, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            members = list(cls.__members__)
            if name in members:
                return cls.__members__[name]
            # The first word is often left out; a dot makes the rest a name of its own.
            near = near_misses(name, [member.replace("_", ".", 1) for member in members]).replace(".", "_")
            raise AttributeError(f"{cls.__name__} has no member {name}{near}")

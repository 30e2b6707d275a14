"""What goes wrong, said in a sentence: while decoding (with the offset), while building (with the parameter)."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice
from typing import Any, NamedTuple

from construct.core import ConstructError


class Fault(NamedTuple):
    """What is wrong with a frame that was read with `strict=False`.

    offset     of the byte at fault, counted from the frame's first
    reason     one sentence
    truncated  True when the frame ended before its contents did
    """

    offset: int
    reason: str
    truncated: bool = False

    def __str__(self) -> str:
        return f"offset {self.offset}: {self.reason}"


class DecodeError(ConstructError, ValueError):  # type: ignore[misc]
    """Bytes that are no frame; `offset` says where, counted from the frame's first byte or the stream's."""

    def __init__(self, offset: int, reason: str, truncated: bool = False) -> None:
        self.fault = Fault(offset, reason, truncated)
        super().__init__(str(self.fault))

    @property
    def offset(self) -> int:
        """Where the byte at fault is."""
        return self.fault.offset

    @property
    def reason(self) -> str:
        """What is wrong, as a sentence."""
        return self.fault.reason

    @property
    def truncated(self) -> bool:
        """True when the bytes ended before their contents did."""
        return self.fault.truncated

    def __reduce__(self) -> tuple[type[DecodeError], tuple[int, str, bool]]:
        return (type(self), (self.offset, self.reason, self.truncated))


class BuildError(ConstructError, ValueError):  # type: ignore[misc]
    """Values that no frame can carry; the sentence names the parameter, the value and what would be right."""


def as_bytes(data: Any, what: str) -> bytes:
    """What bytes are in a bytes-like object.

    Args:
        data: The object.
        what: What it should be, for the sentence.

    Returns:
        The bytes.

    Raises:
        TypeError: There are none in it. For hex in a text, the sentence says how bytes are made of it.
    """
    try:
        return bytes(memoryview(data))
    except TypeError:
        pass
    if isinstance(data, str):
        raise TypeError(f"{what} is bytes, not text: bytes.fromhex({shortened(data)}) makes bytes of hex")
    raise TypeError(f"{what} is bytes, not {type(data).__name__}")


def shortened(text: str) -> str:
    """A text in quotes, of which a sentence shows no more than its first letters."""
    most = 16
    return repr(text) if len(text) <= most else repr(f"{text[:most]}...")


def counted(count: int, noun: str) -> str:
    """`1 byte`, `2 bytes`: a number of things whose plural ends in s."""
    return f"{count} {noun}{'s' * (count != 1)}"


_LIKENESS = 0.67
_MOST_GUESSED = 60
_MOST_KNOWN = 5000


def near_misses(name: str, known: Iterable[str]) -> str:
    """Returns `: did you mean SOUND.TONE?` for a name close to a known one, or to a part of it; or nothing.

    The case of letters does not count. Names of more than 60 characters are not compared, and of the known ones 5000.
    """
    if len(name) > _MOST_GUESSED:
        return ""
    import difflib  # it takes a millisecond, which only a misspelt name should cost

    names = list(islice(known, _MOST_KNOWN))
    targets = {full.upper(): full for full in reversed(names)}
    for full in names:
        head, _, last = full.rpartition(".")
        targets.setdefault(last.upper(), full)
        if head:
            targets.setdefault(head.upper(), head)
    upper = name.upper()
    close = [upper] if upper in targets else difflib.get_close_matches(upper, targets, 3, _LIKENESS)
    near = [full for full in dict.fromkeys(targets[found] for found in close) if full != name]
    return f": did you mean {' or '.join(near)}?" if near else ""

"""YAML as a person would write it: on one line if it fits."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

WIDTH = 120
INDENT = "  "

_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_ ./()-]*")
_BOOLEANS = {"y", "n", "yes", "no", "on", "off", "true", "false", "null"}


class Hexadecimal(int):
    """A number written with at least two hexadecimal digits."""


class Block(str):
    """A text of several lines, emitted verbatim."""

    __slots__ = ()


Value = str | int | bool | list["Value"] | dict[str | int, "Value"]


def as_yaml(value: dict[str | int, Value]) -> str:
    """Returns a mapping as the text of a file."""
    return "".join(f"{line}\n" for line in _mapping(value, 0))


def _scalar(value: Value) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Hexadecimal):
        return f"0x{value:02X}"
    if isinstance(value, int):
        return str(value)
    text = str(value)
    is_plain = _PLAIN.fullmatch(text) and text == text.strip() and text.lower() not in _BOOLEANS
    return text if is_plain else json.dumps(text, ensure_ascii=False)


def _flow(value: Value) -> str | None:
    """Returns the value on one line; None if part of it needs several."""
    if isinstance(value, Block):
        return None
    if isinstance(value, dict):
        pieces = [(f"{_scalar(key)}: ", _flow(item)) for key, item in value.items()]
        opening, closing = "{", "}"
    elif isinstance(value, list):
        pieces = [("", _flow(item)) for item in value]
        opening, closing = "[", "]"
    else:
        return _scalar(value)
    if any(piece is None for _, piece in pieces):
        return None
    return opening + ", ".join(f"{head}{piece}" for head, piece in pieces) + closing


def _mapping(value: dict[str | int, Value], depth: int) -> Iterator[str]:
    for key, item in value.items():
        yield from _entry(f"{INDENT * depth}{_scalar(key)}:", item, depth)


def _entry(head: str, item: Value, depth: int) -> Iterator[str]:
    """Returns a key with its value: on the same line if it fits and is not nested deeply, else below."""
    flow = _flow(item)
    is_deep = depth < 3 and isinstance(item, dict | list) and bool(item)
    if flow is not None and not is_deep and (len(head) + len(flow) < WIDTH or not isinstance(item, dict | list)):
        yield f"{head} {flow}"
    elif isinstance(item, Block):
        yield f"{head} |"
        yield from (f"{INDENT * (depth + 1)}{line}".rstrip() for line in item.splitlines())
    elif isinstance(item, dict):
        yield head
        yield from _mapping(item, depth + 1)
    else:
        yield head
        assert isinstance(item, list)
        for element in item:
            yield from _element(element, depth + 1)


def _element(element: Value, depth: int) -> Iterator[str]:
    flow = _flow(element)
    if flow is not None and len(flow) + len(INDENT) * depth + 2 <= WIDTH:
        yield f"{INDENT * depth}- {flow}"
        return
    assert isinstance(element, dict)
    lines = list(_mapping(element, depth + 1))
    yield f"{INDENT * depth}- {lines[0].lstrip()}"
    yield from lines[1:]

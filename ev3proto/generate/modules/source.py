"""Python source in pieces: docstrings, signatures, imports, lists, laid out as the formatter would."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap

from ev3proto.tables.declaration import DIALECTS

WIDTH = 120
INDENT = "    "

MARK = "Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate."
"""A line for the docstring of every generated module."""

FIRMWARES = {
    "official": "LEGO's own firmware",
    "xtended": "the community's extended firmware",
    "compat": "the community's compatible firmware",
}
assert tuple(FIRMWARES) == DIALECTS


def python_name(name: str) -> str:
    """Returns a firmware name in Python: in lower case, with a trailing `_` if it is a keyword."""
    lowered = name.lower()
    return f"{lowered}_" if keyword.iskeyword(lowered) else lowered


def natural(name: str) -> list[tuple[int, str]]:
    """Returns the key that sorts `move8_8` before `move16_8`, as the formatter sorts imports."""
    return [(int(piece), "") if piece.isdigit() else (-1, piece) for piece in re.findall(r"\d+|\D+", name)]


def indented(lines: Iterable[str]) -> Iterator[str]:
    """Indents lines by one level."""
    return (f"{INDENT}{line}" if line else "" for line in lines)


def docstring(lines: Sequence[str]) -> Iterator[str]:
    """Returns a docstring of these lines."""
    first, *rest = [line.replace("\\", r"\\").replace('"""', r"\"\"\"") for line in lines]
    if rest:
        yield f'"""{first}'
        yield from rest
        yield '"""'
    else:
        yield f'"""{first}"""'


def sentence(*pieces: str) -> str:
    """Joins pieces of text to one sentence: `How loud; 0 to 100 %; DATA8.`"""
    text = "; ".join(pieces)
    return f"{text[:1].upper()}{text[1:]}."


def described(text: str, arguments: Sequence[tuple[str, str]], indent: str) -> Iterator[str]:
    """Returns the docstring of a function: its effect and its parameters.

    Args:
        text: One sentence without its full stop.
        arguments: Each parameter's name and a sentence.
        indent: The indentation of the lines in the file.
    """
    lines = [sentence(text)]
    if arguments:
        lines += ["", "Args:"]
    for name, meaning in arguments:
        lines += wrap(
            f"{name}: {meaning}",
            WIDTH - len(indent),
            initial_indent=INDENT,
            subsequent_indent=INDENT * 2,
            break_long_words=False,
            break_on_hyphens=False,
        )
    yield from docstring(lines)


def bracketed(start: str, items: Sequence[str], end: str, indent: str = "") -> Iterator[str]:
    """Returns `start` and `end` with the items between them: on one line if they fit, else one item a line."""
    line = f"{start}{', '.join(items)}{end}"
    if len(indent) + len(line) <= WIDTH:
        yield line
    else:
        yield start
        yield from (f"{INDENT}{item}," for item in items)
        yield end


def imported(module: str, names: Iterable[str]) -> Iterator[str]:
    """Returns `from module import name, ...`."""
    found = sorted(set(names), key=_import_order)
    line = f"from {module} import {', '.join(found)}"
    if len(line) <= WIDTH:
        yield line
    else:
        yield from bracketed(f"from {module} import (", found, ")", indent=" " * WIDTH)


def _import_order(name: str) -> tuple[int, list[tuple[int, str]]]:
    """Returns the sort key of `__all__`: constants, then classes, then functions."""
    return (0 if name.isupper() and len(name) > 1 else 1 if name[0].isupper() else 2), natural(name.lower())


def exported(names: Iterable[str]) -> Iterator[str]:
    """Returns `__all__`."""
    yield from bracketed("__all__ = [", [f'"{name}"' for name in sorted(names, key=natural)], "]")


def joined(lines: Iterable[str]) -> str:
    """Returns the text of a file."""
    return "\n".join(lines) + "\n"

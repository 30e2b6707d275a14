"""Python source in pieces: functions with their signatures and docstrings, as the project's formatter leaves them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

WIDTH = 120
INDENT = "    "

HEAD = "Generated from ev3proto/tables by ev3proto.generate.stubs: edit those."


def indented(lines: Iterable[str]) -> Iterator[str]:
    """The same lines one step further in."""
    return (f"{INDENT}{line}" if line else "" for line in lines)


def docstring(text: str) -> Iterator[str]:
    """A text as a docstring."""
    text = text.replace("\\", r"\\").replace('"""', r"\"\"\"")
    if "\n" in text:
        yield from f'"""{text}'.split("\n")
        yield '"""'
    else:
        yield f'"""{text}"""'


def function(name: str, parameters: Sequence[str], result: str, text: str) -> Iterator[str]:
    """A function that has nothing but a docstring.

    parameters  with their types and defaults, in order
    result      type of what it gives
    """
    line = f"def {name}({', '.join(parameters)}) -> {result}:"
    # A docstring is shown with one step less, and a method's signature has one step more.
    if len(line) + len(INDENT) <= WIDTH:
        yield line
    else:
        yield f"def {name}("
        yield from (f"{INDENT}{parameter}," for parameter in parameters)
        yield f") -> {result}:"
    yield from indented(docstring(text))


def literal(names: Sequence[str]) -> Iterator[str]:
    """`Literal["A", "B"]`, a name a line."""
    yield "Literal["
    yield from (f'{INDENT}"{name}",' for name in names)
    yield "]"

"""The page of the checker's codes: each with its explanation, a frame that triggers it and one that does not."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ev3proto.checking.codes import CODES, FindingCode
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.generate.pages.markdown import block, link, plain, table


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield (
        "Each finding of `ev3proto check` and `ev3proto.check` has a code, whose meaning never changes. `E` is an"
        " error: the command will not do what was meant. `W` is a warning: it may not. `H` is a hint: something could"
        " be done better. The first digit is the topic: 0 program files, 1 the frame, 2 operations, 3 values, 4"
        " memory, 5 texts and arrays, 6 the way through the code, 7 sounds, drawings and moves, 8 system"
        " messages, 9 encodings."
    )
    yield "`ev3proto check --explain E205` prints the explanation of a code."
    codes = {**PROGRAM_CODES, **CODES}
    yield table(("code", "what it is"), ((link(it.code, it.code), plain(it.title)) for it in codes.values()))
    for entry in codes.values():
        yield from _entry(entry)


def _entry(entry: FindingCode) -> Iterator[str]:
    yield f"## {entry.code}"
    yield f"**{plain(entry.title[:1].upper() + entry.title[1:])}** ({entry.severity})"
    for paragraph in re.split(r"\n\s*\n", entry.explanation):
        yield plain(" ".join(paragraph.split()))
    carrier = f" (by {entry.carrier})" if entry.carrier else ""
    yield f"Found in{carrier}:"
    yield block("text", _hex(entry.example))
    yield "Not found in:"
    yield block("text", _hex(entry.counterexample))


def _hex(data: bytes) -> Iterator[str]:
    for at in range(0, len(data), 32):
        yield data[at : at + 32].hex(" ").upper()

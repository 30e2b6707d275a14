"""Operations in Python, as programs for ev3_dc have them, as assembly.

    ops = b''.join([ev3.opSound, ev3.TONE, ev3.LCX(1), ev3.LCX(440), ev3.LCX(1000)])
    ops = ev3.opUI_Write + ev3.LED + ev3.LED_RED

Only their marks differ from those of the C macros. Each character of the assembly is where it is in the program, so
errors name the place in it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

_GAP = r"(?>(?:\s|\#[^\n]*|\\\n)*)"
_INSIDE = r"""(?:"[^"\n]*"|'[^'\n]*'|[^()"'])*"""
_ELEMENT = rf"(?:\w+\.)?[A-Za-z_]\w*(?:\({_INSIDE}(?:\({_INSIDE}\){_INSIDE})*\))?"
_LIST = re.compile(rf"(?<!\w)(?:\w+\.)?op[A-Z]\w*(?:{_GAP}(?:[,+]|\w+\s\+=){_GAP}{_ELEMENT})*")
_MARK = re.compile(
    r"""(?P<kept>"[^"\n]*"|'[^'\n]*')|(?P<comma>(?:\w+\s(?=\+=))?\+=?(?![^()]*\)))|\#[^\n]*|\\(?=\n)|(?<!\w)[A-Za-z_]\w*\.(?=[A-Za-z_])"""
)
"""What differs: a plus between operations or before more of them, a comment, the end of a line, the module."""
_BEGIN = re.compile(
    r"\bimport\s+ev3_dc\b|\bfrom\s+ev3_dc\b|\bb(?:''|\"\")\.join\([\[(]\s*(?:\w+\.)?op[A-Z]"
    r"|^\s*(?:\w+\s*=\s*\(?\s*(?:\w+\.)?|\w+\.|\w+\.send_\w+\(\s*(?:\w+\.)?)op[A-Z]\w*\s*[+,]"
    r"|^\s*\w+\s*=\s*\w+\.op[A-Z]\w*\s*$",
    re.MULTILINE,
)


def is_python(text: str) -> bool:
    """Returns whether the first lines of a text are operations in Python, or import ev3_dc."""
    return _BEGIN.search(text) is not None


def _marked(found: re.Match[str]) -> str:
    return found["kept"] or ("," if found["comma"] else "").ljust(len(found[0]))


def assembly_in(text: str) -> Iterator[str]:
    """Yields the assembly of each list of operations in Python, at the same places; the rest is blank."""
    for found in _LIST.finditer(text):
        before, after = (re.sub(r"[^\n]", " ", part) for part in (text[: found.start()], text[found.end() :]))
        yield before + _MARK.sub(_marked, found[0]) + after

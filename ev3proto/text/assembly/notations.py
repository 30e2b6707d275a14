r"""The notations of assembly, each as settings of one grammar.

    MACROS   frames: the C macros of the firmware and LEGO's notation, freely mixed
    STRICT   programs, as the public assembler lmsasm reads them; what `decode` writes of an image
    LEGO     programs, as LEGO's own assembler reads its sources: a statement a line, blanks between words
    BASIC    programs, as EV3 Basic's compiler writes them

An assembler's `Rules` say how it encodes what its notation says.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

from ev3proto.tables.source import (
    BACKSLASH,
    ESCAPES,
    LEGO_ESCAPES,
    OBJECT_WORDS,
    OLD_WORDS,
    PARAMETER_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.tables.system import SystemDeclaration
from ev3proto.text.assembly.errors import NEWLINE

NUMBER_PATTERN = r"(?:0[xX]|\$)[0-9a-fA-F]+|0[bB][01]+|(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?[fF]?"
"""Pattern of a number."""

TEMPLATES = ("INIT", "INLINE")
"""Words of EV3 Basic that begin templates for its compiler, which are not objects."""

_BLANK = r"[ \t\f\v\x1a\ufeff]"

MESSAGE = "message"
"""Begins a message, with the facts of its header."""

FRAME = "frame"
"""Begins a message that is nothing but bytes."""

FORMS = (
    *("LC0", "LC1", "LC2", "LC4", "LCX", "LCF", "LCS", "LCS_OLD", "LAB1"),
    *("LV0", "LV1", "LV2", "LV4", "LVX", "LV", "GV0", "GV1", "GV2", "GV4", "GVX", "GV"),
)
"""The macros that name the encoding of a value."""

SHORTEST = ("LCX", "LVX", "LV", "GVX", "GV")
"""Those that name only the kind, and leave the width to the assembler."""

MARKS = ("HND", "ADR")
"""The macros that set a bit in the encoding of the enclosed value."""

CUT = "..."
"""Ends an operation or a system command that is cut short."""

STATUS = "status"
"""The name of a system reply's status."""


def declared_name(entry: SystemDeclaration) -> str:
    """Returns the name of a system command. BEGIN_DOWNLOAD is the firmware's and the bootloader's."""
    return f"BOOTLOADER.{entry.name}" if entry.bootloader else entry.name


class Jumps(Enum):
    """The width of the distance to a label."""

    SHORTEST = "shortest"  # as short as it can be; each starts short and only grows
    SHRUNK = "shrunk"  # the same by EV3-G's way: each starts with three bytes and only shrinks
    THREE = "three"  # always three bytes
    FORWARD = "forward"  # as short as it can be backwards, five bytes forwards


class Rules(NamedTuple):
    """How an assembler encodes values, and where it puts variables."""

    name: str  # as a setting in a source has it
    jumps: Jumps  # how long they are
    lowest: tuple[int, int, int] = (-31, -127, -32767)  # the lowest numbers that LC0, LC1 and LC2 take
    # the first variables' indexes that need more than LV0, LV1 and LV2
    indexes: tuple[int, int, int] = (32, 128, 32768)
    long_floats: bool = False  # all floats have four bytes, even those whose bits are a small number
    shares: bool = False  # equal objects share their code
    # a variable starts at a multiple of its element's size; else of its own if that is 2 or 4
    aligns_elements: bool = False


OF_FRAMES = Rules("frames", Jumps.SHORTEST, lowest=(-32, -127, -32767), indexes=(32, 256, 65536), aligns_elements=True)
OF_LEGO = Rules("lego", Jumps.THREE)
OF_EV3_G = Rules("shortest", Jumps.SHRUNK, long_floats=True, shares=True)
OF_BASIC = Rules("basic", Jumps.FORWARD, lowest=(-32, -128, -32768), long_floats=True)
"""EV3 Basic also aligns elements; only its notation has that, because sources written from images have fixed places."""


class Known(Enum):
    """Where a name is looked up; a notation has them in its order."""

    LOCALS = "variables and defines of the object"
    GLOBALS = "global variables above"
    OBJECTS = "objects"
    OBJECTS_ABOVE = "objects above"
    DEFINES = "defines"
    DEFINES_ABOVE = "defines above"
    FIRMWARE = "the firmware's names"
    LABELS = "labels"
    GOALS = "labels, where the parameter is a jump"
    CALLED = "objects, where the parameter is one"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Notation:
    """The syntax of one notation."""

    name: str  # as users choose it
    blank: str = rf"{_BLANK}|//[^\r\n]*+"  # pattern of what separates tokens, comments to the end of the line included
    text: str = r"'[^'\r\n]*'"  # pattern of a text in quotes
    marks: str = r"[-+*/(){},:@&!]"  # pattern of the characters that are tokens
    heads: tuple[str, ...] = OBJECT_WORDS  # words that begin objects
    # those in single quotes, replaced kind after kind; None: as in C
    escapes: tuple[tuple[str, str], ...] | None = None
    lookup: tuple[Known, ...]  # where names are looked up
    rules: Rules  # how values are encoded
    # frames: headers, macros, bytes, names in front of values, expressions everywhere, unlimited numbers
    has_messages: bool = False
    # a statement a line, blanks between arguments, unknown escapes stay; else tokens with parentheses
    by_line: bool = False
    # LEGO's: the last of several declarations counts, numbers are cut, defines may have expressions
    last_counts: bool = False
    folds: bool = False  # EV3 Basic's: names are read in upper case, no expressions

    @property
    def declaring(self) -> tuple[str, ...]:
        """The words that declare variables and parameters."""
        if self.has_messages:
            return tuple(VARIABLE_WORDS)
        return (*VARIABLE_WORDS, *PARAMETER_WORDS, *(OLD_WORDS if self.last_counts else ()))


MACRO_NOTATION = Notation(
    name="macros",
    text=r"""'(?:[^'\\\r\n]|\\[^\r\n])*'""",
    marks=r"\.\.\.|[-+*/|()\[\]{},:;=@&#]",
    heads=("vmthread",),
    lookup=(Known.DEFINES, Known.LOCALS, Known.GOALS, Known.FIRMWARE),
    rules=OF_FRAMES,
    has_messages=True,
)

STRICT = Notation(
    name="strict",
    escapes=(*ESCAPES, BACKSLASH),
    lookup=(
        *(Known.LOCALS, Known.GLOBALS, Known.OBJECTS_ABOVE, Known.DEFINES_ABOVE),
        *(Known.FIRMWARE, Known.LABELS, Known.OBJECTS, Known.DEFINES),
    ),
    rules=OF_LEGO,
)

LEGO_NOTATION = Notation(
    name="lego",
    blank=rf"[(),]|{_BLANK}|=[ \t]*(?://[^\r\n]*)?(?:{NEWLINE})|//[^\r\n]*+",
    text=r"'(?>(?:''|\\\\|\\'|[^'\r\n])*)'",
    marks=r"[-+*/{}:;@&]",
    heads=("vmthread", "subcall"),
    escapes=(*ESCAPES, *LEGO_ESCAPES),
    lookup=(Known.LOCALS, Known.GLOBALS, Known.LABELS, Known.OBJECTS, Known.DEFINES, Known.FIRMWARE),
    rules=OF_LEGO,
    by_line=True,
    last_counts=True,
)

BASIC = Notation(
    name="basic",
    blank=rf"[(),{{]|{_BLANK}|/[^\r\n]*+",
    marks=r"[-+}:]",
    heads=("vmthread", "subcall"),
    escapes=((r"\n", "\n"), (r"\t", "\t"), *((rf"\{code:03o}", chr(code)) for code in range(1, 256))),
    lookup=(Known.GOALS, Known.CALLED, Known.LOCALS, Known.GLOBALS, Known.FIRMWARE),
    rules=OF_BASIC._replace(aligns_elements=True),
    by_line=True,
    folds=True,
)

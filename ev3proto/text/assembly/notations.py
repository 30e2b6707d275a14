r"""The notations of assembly, each as settings of one grammar.

    MACROS   frames: the C macros of the firmware and LEGO's notation, mixed as people like
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
    HANDLE_PARAMETERS,
    LEGO_ESCAPES,
    OBJECT_WORDS,
    OLD_WORDS,
    PARAMETER_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.tables.system import SystemCommand

MESSAGE = "message"
"""Begins a message, with the facts of its header."""

FRAME = "frame"
"""Begins a message that is nothing but bytes."""

FORMS = (
    *("LC0", "LC1", "LC2", "LC4", "LCX", "LCF", "LCS", "LCS_OLD", "LAB1"),
    *("LV0", "LV1", "LV2", "LV4", "LVX", "LV", "GV0", "GV1", "GV2", "GV4", "GVX", "GV"),
)
"""The macros that fix how a value is encoded."""

SHORTEST = ("LCX", "LVX", "LV", "GVX", "GV")
"""Those of them that leave it to us."""

MARKS = ("HND", "ADR")
"""The macros that set a bit of what they enclose."""

CUT = "..."
"""Ends an operation or a system command that is cut short."""

STATUS = "status"
"""The name by which a system reply's status is given."""


def command_name(entry: SystemCommand) -> str:
    """Returns the name of a system command. BEGIN_DOWNLOAD is the firmware's and the bootloader's."""
    return f"BOOTLOADER.{entry.name}" if entry.bootloader else entry.name


class Jumps(Enum):
    """How long the distance to a label is.

    SHORTEST  as short as it can be; each starts short and only grows
    SHRUNK    the same by EV3-G's way: each starts with three bytes and only shrinks
    THREE     always three bytes
    FORWARD   as short as it can be backwards, five bytes forwards
    """

    SHORTEST = "shortest"
    SHRUNK = "shrunk"
    THREE = "three"
    FORWARD = "forward"


class Rules(NamedTuple):
    """How an assembler encodes values, and where it puts variables.

    name              as a setting in a source has it
    jumps             how long they are
    lowest            the lowest numbers that LC0, LC1 and LC2 take
    indexes           the first variables' indexes that need more than LV0, LV1 and LV2
    long_floats       all floats have four bytes, even those whose bits are a small number
    shares            equal objects share their code
    aligns_elements   a variable starts at a multiple of its element's size; else of its own if that is 2 or 4
    """

    name: str
    jumps: Jumps
    lowest: tuple[int, int, int] = (-31, -127, -32767)
    indexes: tuple[int, int, int] = (32, 128, 32768)
    long_floats: bool = False
    shares: bool = False
    aligns_elements: bool = False


OF_FRAMES = Rules("frames", Jumps.SHORTEST, lowest=(-32, -127, -32767), indexes=(32, 256, 65536), aligns_elements=True)
OF_LEGO = Rules("lego", Jumps.THREE)
OF_EV3_G = Rules("shortest", Jumps.SHRUNK, long_floats=True, shares=True)
OF_BASIC = Rules("basic", Jumps.FORWARD, lowest=(-32, -128, -32768), long_floats=True)
"""EV3 Basic aligns elements, too, which its notation says: a source that was written back has its places already."""


class Point(Enum):
    """What a number with a point and without an F is."""

    FLOAT = "a float"
    WHOLE = "cut to a whole number"
    WRONG = "an error"


class Octal(Enum):
    """What a number with a 0 in front is."""

    WRONG = "an error, but for 00 to 07"
    READ = "octal, or an error"
    LENIENT = "octal where its digits are, else decimal"
    DECIMAL = "decimal"


class Arithmetic(Enum):
    """How expressions are worked out.

    USUAL  anywhere, products before sums, floats too
    LEFT   in parentheses, from left to right, each step cut to 32 bits
    EXACT  in defines and sizes, products before sums, with fractions; parentheses are blanks
    NONE   nothing is worked out
    """

    USUAL = "usual"
    LEFT = "left"
    EXACT = "exact"
    NONE = "none"


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


@dataclass(frozen=True, slots=True, kw_only=True)
class Notation:
    """A notation.

    name             as people choose it
    newline          what ends a line
    blank            what separates tokens
    comment          what starts a comment to the line's end
    text             a text in quotes
    marks            single characters that are tokens
    number           what a number looks like
    folds            names are read in upper case
    by_line          a statement a line, blanks between arguments; else statements are tokens with parentheses
    has_messages     frames: headers, macro operations, bytes, names in front of values
    needs_commas     between arguments
    needs_braces     `{` after the head of an object
    heads            the words that begin objects
    declaring        the words that declare variables and parameters
    templates        the words that begin pieces of code for a compiler, which become no object
    escapes          those in single quotes, replaced kind after kind; None: as in C
    keeps_escapes    an unknown escape is left as it is, else an error
    octal, point     see there
    bits             size of whole numbers in bits; 0: unlimited
    cuts             longer ones are cut to that, else refused
    hex_is_bits      hex is a pattern of bits: 0xFF may be -1
    arithmetic       see there
    lookup           where names are looked up
    last_counts      of what is declared twice the last one counts; else that is an error
    rules            how values are encoded
    """

    name: str
    newline: str = r"\r\n|\r|\n"
    blank: str = r"[ \t\f\v\x1a\ufeff]"
    comment: str = "//"
    text: str = r"'[^'\r\n]*'"
    marks: str = r"[-+*/(){},:@&!]"
    number: str = r"0[xX][0-9a-fA-F]+|(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?F?"
    folds: bool = False
    by_line: bool = False
    has_messages: bool = False
    needs_commas: bool = False
    needs_braces: bool = False
    heads: tuple[str, ...] = OBJECT_WORDS
    declaring: tuple[str, ...] = (*VARIABLE_WORDS, *PARAMETER_WORDS)
    templates: tuple[str, ...] = ()
    escapes: tuple[tuple[str, str], ...] | None = None
    keeps_escapes: bool = False
    octal: Octal = Octal.WRONG
    point: Point = Point.WRONG
    bits: int = 32
    cuts: bool = False
    hex_is_bits: bool = False
    arithmetic: Arithmetic = Arithmetic.NONE
    lookup: tuple[Known, ...]
    last_counts: bool = False
    rules: Rules


_WITHOUT_HANDLES = tuple(word for word in PARAMETER_WORDS if word not in HANDLE_PARAMETERS)

MACROS = Notation(
    name="macros",
    newline=r"\n",
    blank=r"[ \t\r\f\v\ufeff]",
    text=r"""'(?:[^'\\\n]|\\[^\n])*'""",
    marks=r"\.\.\.|[-+*/|()\[\]{},:;=@&#]",
    number=r"0[xX][0-9a-fA-F]+|0[bB][01]+|(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?[fF]?",
    has_messages=True,
    needs_commas=True,
    needs_braces=True,
    heads=("vmthread",),
    declaring=tuple(VARIABLE_WORDS),
    octal=Octal.WRONG,
    point=Point.FLOAT,
    bits=0,
    hex_is_bits=True,
    arithmetic=Arithmetic.USUAL,
    lookup=(Known.DEFINES, Known.LOCALS, Known.GOALS, Known.FIRMWARE),
    rules=OF_FRAMES,
)

STRICT = Notation(
    name="strict",
    needs_braces=True,
    escapes=(*ESCAPES, BACKSLASH),
    octal=Octal.READ,
    arithmetic=Arithmetic.LEFT,
    lookup=(
        Known.LOCALS,
        Known.GLOBALS,
        Known.OBJECTS_ABOVE,
        Known.DEFINES_ABOVE,
        Known.FIRMWARE,
        Known.LABELS,
        Known.OBJECTS,
        Known.DEFINES,
    ),
    rules=OF_LEGO,
)

LEGO = Notation(
    name="lego",
    blank=r"[ \t(),\f\v\x1a\ufeff]|=[ \t]*(?://[^\r\n]*)?(?:\r\n|\r|\n)",
    text=r"'(?>(?:''|\\\\|\\'|[^'\r\n])*)'",
    marks=r"[-+*/{}:;@&]",
    number=r"(?:0x|\$)[0-9a-fA-F]+|(?:\d+(?:\.\d*)?|\.\d+)(?:[eE]\d+)?F?",
    by_line=True,
    heads=("vmthread", "subcall"),
    declaring=(*VARIABLE_WORDS, *_WITHOUT_HANDLES, *OLD_WORDS),
    escapes=(*ESCAPES, *LEGO_ESCAPES),
    keeps_escapes=True,
    octal=Octal.LENIENT,
    point=Point.WHOLE,
    cuts=True,
    arithmetic=Arithmetic.EXACT,
    lookup=(Known.LOCALS, Known.GLOBALS, Known.LABELS, Known.OBJECTS, Known.DEFINES, Known.FIRMWARE),
    last_counts=True,
    rules=OF_LEGO,
)

BASIC = Notation(
    name="basic",
    blank=r"[ \t(),{\f\v\x1a\ufeff]",
    comment="/",
    marks=r"[-+}:]",
    number=r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?",
    folds=True,
    by_line=True,
    heads=("vmthread", "subcall"),
    declaring=(*VARIABLE_WORDS, *_WITHOUT_HANDLES),
    templates=("INIT", "INLINE"),
    escapes=((r"\n", "\n"), (r"\t", "\t"), *((rf"\{code:03o}", chr(code)) for code in range(1, 256))),
    keeps_escapes=True,
    octal=Octal.DECIMAL,
    point=Point.FLOAT,
    lookup=(Known.GOALS, Known.CALLED, Known.LOCALS, Known.GLOBALS, Known.FIRMWARE),
    rules=OF_BASIC._replace(aligns_elements=True),
)

OF_PROGRAMS = (STRICT, LEGO, BASIC)
"""The notations of programs, in the order in which they are tried."""

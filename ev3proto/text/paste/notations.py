r"""The notations: how values are written, what is between them, and what only looks like values.

Each form is a row with a name, an example, and a verbose pattern. To add a notation, add a row and its example here,
and its bytes in `values.py`; a test reads every example.

A notation joins the rows: its `run` finds values in one search, which skips the times, dates and addresses on its way;
its `value` steps through a run from one value to the next.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import cache
from typing import NamedTuple

from ev3proto.text.paste.values import EXPRESSION, WIDTH


class Form(NamedTuple):
    """A form of values, of what separates them, or of something else: its name, an example, its pattern."""

    name: str
    example: str
    pattern: str


def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.VERBOSE | re.DOTALL)


def _any_of(forms: Iterable[Form]) -> str:
    return "|".join(form.pattern for form in forms)


# Numbers

_H = "[0-9a-fA-F]"
_HEX_SUFFIX = r"(?: _?u8 | [uU]?[yYlL] | [lL]?[uU] | [hH] | \.to(?:U?Byte|Char)\(\) )?&?(?!\w)"
_UNKNOWN = r"(?:[xX]{2}|[mM]{2})"
_MACRO = r"(?:\w{1,20}\.)?(?:LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\("

NUMBER_FORMS = (
    # Most values have the first form, so it comes first.
    Form("digits", "0f", rf"(?<!\w){_H}+(?![\w'\#&.])"),
    Form("0x", "0x0f", rf"0[xX](?:{_H}{{1,2}}(?!\w)|{_H}{{2}}(?=0[xX]{_H}{{2}}))(?!['\#&])"),
    Form(
        "hex with a mark",
        "&H0F",
        rf"(?<![\w$])(?:\\?0[xX] | \\[xX] | \$ | &[hH] | \#[xX] | [xX](?={_H}{{2}}(?!\w)|'))'?{_H}+{_HEX_SUFFIX}",
    ),
    Form("bits", "0b00001111", r"(?<!\w)(?:0[bB]|\#b|B)[01]{4}_?[01]{4}(?!\w)"),
    Form(
        "unknown",
        "0F00xxxx",
        rf"(?<!\w)(?: (?:0[xX]|\\x)(?:[xX]{{2}}|MM) | (?:{_H}{{2}})+{_UNKNOWN}(?:{_UNKNOWN}|{_H}{{2}})*"
        rf" | (?:[xX]{{2}}|[mM]{{4}}|MM)(?:{_UNKNOWN}|{_H}{{2}})* )(?!\w)"
        rf" | {EXPRESSION}",
    ),
    Form("negative", "-128", r"(?: (?<![\w)\]<>=-]) | (?<=[a-z]\)) )-\d{1,3}(?![\w.])"),
    Form("digits with a suffix", "0Fh", rf"(?<!\w){_H}+{_HEX_SUFFIX}"),
    Form(
        "name",
        "LC2(1000)",
        rf"(?<![^,{{(\[\s])(?: {_MACRO}[^()]{{0,80}}\) | (?:[a-z]\w{{0,20}}\.)?(?:op[A-Z]\w+|[A-Z][A-Z0-9_]+) )"
        r"(?=\s{0,80}+(?:[,}\])]|$))",
    ),
)
"""How a number is written."""

_BYTE_TYPE = r"(?:(?:un)?signed\s)?(?:s?byte|char|u?int8_?t?|u8|[US]?Byte|SByte|UInt8|BYTE)"
GAPS = (
    Form("separators", ", ", rf"[\s,:|]+(?={_H})"),
    Form("cast", "(byte)", rf"\({_BYTE_TYPE}\s?\)"),
    Form("character after its number", "'a'", r"(?<=\d\s)'(?:\\(?:[0-7]{1,3}|x[0-9a-fA-F]{2}|.)|[^'\\])'"),
    Form("tag", "</byte><byte>", rf"</?(?!{_H}{{2}}>)[A-Za-z_][\w:.-]{{0,30}}\s?/?>"),
    Form(
        "sign",
        "] = [",
        r"[\s,;:|+\"`<>()\[\]{}_/=%]|\.(?!\.)|(?<=\w)-|-(?!\d)|&(?![hH\#\w])|\\(?![xX])|\#(?![xXb])|'(?!h)",
    ),
    Form("entity", "&nbsp;", r"&\#?\w{2,5};"),
    Form("the lesson's mark", "0x|", r"0[xX](?=\|)"),
    Form("type behind", " as u8", r"(?<!\w)as\s(?:u8|byte)\b"),
    Form("call", "data.Add(", rf"(?<!\w)(?!{_MACRO}|{_H}{{2}}\s)(?:[A-Za-z_]\w*\.)?[A-Za-z_]\w*\s?\("),
)
"""What separates two numbers of a run."""

_CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_ZONE = r"(?:Z|\s?[+-]\d\d:?\d\d)?"
FOREIGN = (
    Form(
        "UUID",
        "00001101-0000-1000-8000-00805F9B34FB",
        rf"(?<![\w-]){_H}{{8}}-{_H}{{4}}-{_H}{{4}}-{_H}{{4}}-{_H}{{12}}(?![\w-])",
    ),
    Form(
        "date",
        "2024-01-31 12:30:45",
        r"(?<![\w.:|-])(?: (?:(?:19|20)\d\d[-/.])?[01]\d[-/.][0-3]\d | [0-3]\d[./][01]\d[./](?:19|20)\d\d )"
        rf"(?: [T\ ]\s?{_CLOCK}{_ZONE}(?![\w:|]) | (?<=[\d/.-]{{8}})(?![\w:|./-]) )",
    ),
    Form("time", "12:30:45.123", rf"(?<![\w.:|-]){_CLOCK}{_ZONE}(?=[\])>:;,-]?(?:\s|$))"),
    Form(
        "IPv6",
        "fe80::1/64",
        rf"(?<![\w:.])(?:{_H}{{1,4}}:){{1,6}}:(?:{_H}{{1,4}}:){{0,5}}{_H}{{1,4}}(?:%\w+|/\d{{1,3}})?(?![\w:])",
    ),
    Form("tag of a letter", "</b>", r"</?[a-fA-F]>"),
    Form(
        "fraction",
        "192.168.1.100",
        r"(?<![\w.-])(?!\d{4}(?:\.\d{4}){2}\.\d\d)[-+]?\d+(?:\.\d+){1,3}(?:e[-+]?\d+)?(?![\w.])",
    ),
)
"""What looks like numbers of a run, and never is."""

_NUMBER, _GAP, _FOREIGN = map(_any_of, (NUMBER_FORMS, GAPS, FOREIGN))
# Groups are repeated as (?>(?:x)*), not as (?:x)*+: before 3.11.5, Python matches that wrongly, as in Debian 12.
_MAY_BEGIN = rf"(?=[0-9a-fA-Zxmo:$&\#'\\+<{EXPRESSION}-]|[a-z]\w{{0,20}}\.(?:op|[A-Z]))"
_PLAIN = rf"(?>(?:[\s,:|]{{1,4}}(?:0x)?{_H}{{1,8}}(?![\w'\#&.]))+)"
"""Most of most runs, which the regex engine takes in one loop."""

# Strings


def _quoted(*, has_escape: bool) -> str:
    # A string inside another is skipped.
    ahead = r"(?=[^{0}\\]*\\)(?!b?{1}[^{0}]*{1}{0})" if has_escape else ""
    body = "|".join(
        f"{{0}}{ahead}(?>(?:[^{{0}}\\\\]|\\\\.)*){{0}}".replace("{0}", mark).replace("{1}", other)
        for mark, other in ("\"'", "'\"", "`'")
    )
    return rf"(?: (?: (?<![\w\\]) (?:b|B|rb|br|u8|u|U|L|@|\$|c) )? (?:{body}) )"


_ESCAPE = (
    rf"\\(?: [xX]\{{?{_H}{{1,2}}\}}? | u00{_H}{{2}} | u\{{{_H}{{1,2}}\}} | [0-3]?[0-7]{{1,2}} | [abtnvfre\\\"'\ \#] )"
)
_BARE = rf"(?: (?:{_ESCAPE}){{2}} (?>(?: {_ESCAPE} | [!\#-&(-\[\]-~](?=[^\s]) )*) )"
STRING_FORMS = (
    Form("string", r"b'\x0f\x00'", _quoted(has_escape=True)),
    Form("escapes without quotes", r"\x0f\x00", rf"(?<!\w){_BARE}"),
)
"""How a string with bytes is written."""

_ANY_STRING = _quoted(has_escape=False)
_BETWEEN = r"(?>(?: [\s+&()\[\],;] | \\(?=\s|$) | \.(?=\s?[bB\"'$]) | bytes\( | bytearray\( )*)"
"""What joins two strings."""

# Base64

_DIGIT = "[A-Za-z0-9+/_-]"
_FRAME_IN_BASE64 = rf"{_DIGIT}[AQgw][A-P]{_DIGIT}{{2}}(?:[AQgwIYo4][A-Xg-r]{_DIGIT}+|{_DIGIT}{{6,}})={{0,3}}"
"""The length of a frame is below 1024. Its fifth byte is a type, which may be wrong in longer words."""


# Notations


class Notation(NamedTuple):
    """A way of writing bytes.

    example   a frame in it
    run       finds a run of values; a match without its group `run` is to be skipped
    value     finds the next value of a run, and what is in front of it
    readings  returns the names of the readings that the values of a run may have, the likeliest first
    more      finds a run in a line that continues a frame
    """

    example: str
    run: re.Pattern[str]
    value: re.Pattern[str]
    readings: Callable[[list[str], frozenset[int]], tuple[str, ...]]
    more: re.Pattern[str]


_WIDTHS = {"octal": {3, 4}, "number": {1, 8}, "bits": {8}, "words": {4, 8}}
"""Widths of digits one of which must be in a run to be read so."""


def _of_numbers(tokens: list[str], widths: frozenset[int]) -> tuple[str, ...]:
    if 8 in widths and {*"".join(token for token in tokens if WIDTH[token] > 0)} <= {"0", "1"}:
        return ("bits",) if len(tokens) > 2 else ("bits", "hex")
    has_zero = {1, 2} < widths and any(len(token) == 2 and token[0] == "0" for token in tokens)
    return _by_width(widths, has_zero=has_zero)


@cache
def _by_width(widths: frozenset[int], *, has_zero: bool) -> tuple[str, ...]:
    bare = widths - {0, -1}
    if not bare:
        return ("hex",)
    is_padded = bare == {2} or max(bare) >= 4 or has_zero
    found = ("hex", "decimal") if is_padded and 0 not in widths else ("decimal", "hex")
    return (*found, *(name for name, needed in _WIDTHS.items() if bare & needed))


_DIGIT_ESCAPE = re.compile(r"\\\d")


def _of_strings(tokens: list[str], _: frozenset[int]) -> tuple[str, ...]:
    return ("string", "decimal string") if any(map(_DIGIT_ESCAPE.search, tokens)) else ("string",)


_NUMBER_RUN = _compiled(
    rf"{_MAY_BEGIN}(?: (?a:{_FOREIGN})"
    rf" | (?P<run> (?:{_NUMBER}) (?>(?: {_PLAIN} | (?>(?:{_GAP}){{0,160}}) (?:{_NUMBER}) )*) ) )"
)
NUMBERS = Notation(
    "0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03",
    _NUMBER_RUN,
    _compiled(rf"(?>(?:{_GAP})*)({_NUMBER})"),
    _of_numbers,
    _NUMBER_RUN,
)
STRINGS = Notation(
    r"b'\x0e\x00*\x00\x80\x00\x00\x94\x01\x01\x82\xb8\x01\x82\xe8\x03'",
    _compiled(
        rf"(?P<run> {STRING_FORMS[0].pattern}(?>(?:{_BETWEEN}{_ANY_STRING})*)"
        rf" | (?<!\w){_BARE}(?>(?:[\s,]{{0,4}}{_BARE})*) )"
    ),
    _compiled(rf"{_BETWEEN}( {_ANY_STRING} | {_BARE} | {_ESCAPE} )"),
    _of_strings,
    _compiled(rf"(?P<run> {_ANY_STRING}(?>(?:{_BETWEEN}{_ANY_STRING})*) | (?>(?: {_ESCAPE} | {_BARE} )+) )"),
)
BASE64 = Notation(
    "DgAqAIAAAJQBAYK4AYLoAw==",
    _compiled(rf"(?<![\w+/.-])(?P<run>{_FRAME_IN_BASE64})(?![\w+/=.])"),
    _compiled(rf"\s*({_DIGIT}+={{0,3}})"),
    lambda *_: ("base64",),
    _compiled(rf"\s*(?P<run>{_DIGIT}+={{0,3}})\s*$"),
)
EACH = _compiled(rf"{_MAY_BEGIN}(?: (?a:{_FOREIGN}) | ({_NUMBER}) )")
"""Each number of a line, whatever is between them."""

_IS_PLAIN = re.compile(r"[0-9a-fA-F\s,:|]*+")
_WORDS = re.compile(r"\w+")


def values_in(notation: Notation, line: str, start: int, end: int) -> list[str]:
    """Returns the values in a run."""
    # Where nothing but digits and separators is in a run, each word is a value.
    is_plain = _IS_PLAIN.fullmatch(line, start, end)
    return _WORDS.findall(line, start, end) if is_plain else notation.value.findall(line, start, end)


_NUMBER_OF_PROSE = re.compile(
    r"""
    (?P<bytes> (?> (?: (?:0[xX])? (?P<last>[0-9a-fA-F]+) (?!\w) [\s,:|]* )+ ) )
    [\])}"'`]?\s*
    (?: (?:</?\w+>\s*)* \.? [A-Za-z_][\w.]*\s?\( | = | </?\w{2,}> | \( ) [^\w)]* (?P<number>\w+)
    """,
    re.VERBOSE,
)
"""Bytes, and a number in the words after them: `0f002a80 <script>alert(1)`, `0f 00 2a 80 = 4`, `0f002a80 (4)`."""
_LEAST_DIGITS = 8


def end_of_bytes(line: str, start: int, end: int) -> int:
    """Returns where a run of numbers ends whose last number may belong to the words that follow the bytes."""
    if all(line.find(sign, start, end) < 0 for sign in "(=>"):
        return end
    found = _NUMBER_OF_PROSE.fullmatch(line, start, end)
    if found is None or len(found["bytes"]) < _LEAST_DIGITS or found["bytes"].rstrip().endswith(","):
        return end
    if len(found["last"]) == len(found["number"]) and line[found.end("bytes")] == "(":
        return end
    return start + len(found["bytes"].rstrip(" \t,:|"))


# Expressions

_PART_OF_ELEMENT = r"""(?: [^,()\[\]{}"'`;=\\] | \([^()]*\) )"""
_EXPRESSION = re.compile(rf"(?! \s | $ ){_PART_OF_ELEMENT}+? (?= \s* (?: [,\]}})] | $ ) )", re.VERBOSE)
_ELEMENT = re.compile(rf"(?P<before> ^\s* | [\[{{(,] \s*+ )(?P<element>{_EXPRESSION.pattern})", re.VERBOSE)
_IDENTIFIER = re.compile(r"(?<!\w)(?!0[xX])[A-Za-z_]\w*")
_OPENING = re.compile(r"[\[{(]")
_WORDS_OF_PROSE = re.compile(r"\w\s+\w")
_KNOWN = _compiled(rf"(?>(?:{_GAP})*)(?:{_NUMBER})(?:{_GAP})*")


def without_expressions(line: str, *, is_inside: bool = False) -> str:
    """Returns the line with an unknown byte for each element of an array that is an expression: `msgId & 0xFF`.

    Args:
        line: A line.
        is_inside: It begins inside an array; otherwise its first bracket opens one.
    """
    opening = None if is_inside else _OPENING.search(line)
    start = 0 if is_inside else len(line) if opening is None else opening.start()
    if line.find(",", start) < 0 or _IDENTIFIER.search(line, start) is None:
        return line
    return line[:start] + _ELEMENT.sub(_unknown, line[start:])


def expression_at(line: str, column: int) -> str:
    """Returns the expression that begins in a column."""
    found = _EXPRESSION.match(line, column)
    return found[0] if found else ""


def _unknown(found: re.Match[str]) -> str:
    element = found["element"]
    if _IDENTIFIER.search(element) is None or _WORDS_OF_PROSE.search(element) or _KNOWN.fullmatch(element):
        return found[0]
    return found["before"] + EXPRESSION.ljust(len(element))

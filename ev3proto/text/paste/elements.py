r"""A line of text -> its elements, by one table of forms, and the bytes of an element in each base.

An element is a number of a base that is not known yet (`0f`, `15`), or something that says itself what it is: `0x0f`,
`'a'`, `"\x0f\0"`, `opSOUND`, `LC1(20)`, `xx`, an ellipsis. Between two is a gap. To add a notation, add a row to
`FORMS`; if its bytes are written in a new way, a row to `_WAYS`.
"""

from __future__ import annotations

import binascii
import re
from collections.abc import Callable
from functools import cache, lru_cache
from itertools import groupby
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.schema import names
from ev3proto.schema.argument import encode_as
from ev3proto.schema.header import build_frame, write_memory
from ev3proto.tables import OPCODES
from ev3proto.tables.frame import LENGTH_FIELD, MessageType
from ev3proto.text.paste.heads import CLOCK


class TextElement(NamedTuple):
    """A value of a line.

    kind   "digits" have any base; "marked" says itself what it is; "string" has many bytes; "character" is one;
           "unknown" has bytes that are not given; "cut" is an ellipsis and "open" a string without its end
    gap    what is in front of it, without comments and casts
    """

    kind: str
    text: str
    start: int
    end: int
    gap: str
    line: int


class Form(NamedTuple):
    """How something is written: a kind of element, "blank" for what means nothing, "other" for all else."""

    kind: str
    example: str
    pattern: str


EXPRESSION, TEXT = "\ufffc", "\ufffb"
"""What is read in place of each character of an expression; of the first quote of a text whose characters are bytes."""

_H = "[0-9a-fA-F]"
_SUFFIX = r"(?:_?u8|[uU]?[yYL]|L?[uU]|\.to(?:U?Byte|Char)\(\))"
_ESCAPE = rf"\\(?:[xX]\{{?{_H}{{1,2}}\}}?|u00{_H}{{2}}|u\{{{_H}{{1,2}}\}}|[0-3]?[0-7]{{1,2}}|[abtnvfre\\\"'\ \#])"
_CHARACTER = rf"(?:\\(?:[xX]{_H}{{1,2}}|[0-7]{{1,3}}|[^\dxX])|[^'\\])"
_MACRO = r"(?:LC[0124SXF]|[LG]V[0124X]|LAB1|EV3_(?:HEADER|MEMORY))\s?\([^()]{0,80}\)"
_BEFORE = r"(?<![^,{(\[\s])"
_AFTER = r"(?=\s{0,80}(?:[,}\])]|$))"
_TYPE = r"(?:(?:un)?signed\s)?(?:s?byte|char|u?int8(?:_?t)?|u8|U?Int8|[US]?Byte|BYTE)"
_DATE = r"(?:(?:(?:19|20)\d\d[-/.])?[01]\d[-/.][0-3]\d|[0-3]\d[./][01]\d[./](?:19|20)\d\d)"

_REST_OF_ADDRESS = rf"(?:[:-]{_H}{{2}}){{4}}(?![:-]?\w)"
_DOTTED = r"\d{4}(?:\.\d{4}){2}\.\d\d"
"""Pairs of bytes with dots between them: `0f00.0000.8000.00`."""


def _has_bytes(mark: str) -> str:
    return rf"(?>(?:[^{mark}\\]|\\[^xX0-9u])*)\\[xX0-9u]"


def _quoted(mark: str, other: str) -> str:
    """Returns the pattern of a string that has bytes as escapes; one with another string in it is code."""
    return rf"{mark}(?={_has_bytes(mark)})(?!b?{other}[^{mark}]*{other}{mark})(?>(?:[^{mark}\\]|\\.)*){mark}"


_DIRECTIVE = rf"(?:\.byte|\.db|(?:db|DB)(?!\s+{_H}{{2}}(?:\s|$))|dc\.b|DC\.B|defb|DEFB|fcb|FCB|BYTE|\.ascii|DATA)"

FORMS = (
    # Many pairs of digits at once, which are split behind this table: they take a fifth of the time so.
    Form("run", "0f 00 2a 00 80 00 00 94", rf"(?<![\w.])(?:{_H}{{2}}[ :|,-]){{7,}}{_H}{{2}}(?=[\s,|]|$)"),
    # Most values have the first form. After a time or a date come other signs, so it does not take a part of one.
    Form("digits", "0f", rf"(?<!\w){_H}+(?=[\s,|]|$)(?<!0[bB][01]{{8}})|(?<=[:|]){_H}{{2}}(?=[:|])"),
    Form("blank", "byte cmd|[17]| = {0f}", r"(?<=\w)\[\d+(?:\.\.\d+)?\](?!\s?=\s?[^{\s])"),  # a size
    Form("word", "x.|add|(0f)", r"(?<=\.)[a-fA-F]+(?=\()"),  # a method, not a number
    Form("blank", "0f |b''.join|(", r"(?<!\w)b?(?:\"\"|'')\.join(?=\()"),
    # Strings: those without an escape are read as what is in them.
    Form(
        "string",
        r"b'\x0f\0'",
        r"(?:(?<![\w\\])(?:rb|br|b|B|u8?|U|L|@|c)|\$)?"
        rf"(?:{_quoted(chr(34), chr(39))}|{_quoted(chr(39), chr(34))}|{_quoted('`', chr(39))})",
    ),
    Form("open", r"b'\x0f\0", rf"(?<![\w\\])b?(?:\"(?={_has_bytes(chr(34))})[^\"]*|'(?={_has_bytes(chr(39))})[^']*)$"),
    Form(
        "string", "b'it'", rf"(?<!\w)b(?![\"'](?:{_H}{{2}}){{5,}}[\"'])(?:'[^'\\]*'|\"[^\"\\]*\")"
    ),  # hex digits, as in unhexlify(b'0f00'), are read as such
    Form("string", f'{TEXT}abc"', f'{TEXT}[^"]*"'),
    Form("string", r"\x0f\0", rf"(?<!\w)(?:{_ESCAPE}){{2}}(?>(?:{_ESCAPE}|[!\#-&(-\[\]-~](?=\S))*)"),
    # Characters in quotes are their codes: `'a'`, Erlang's `$a`.
    Form("blank", "97| 'a'|", rf"(?<=[\da-fA-F]\s)'{_CHARACTER}'"),
    Form("character", "'a'", rf"(?<!\w)'{_CHARACTER}'(?=\s{{0,80}}(?:[,;\])}}+&.]|$))"),
    Form("character", "$a", r"(?<!\w)\$(?!\d)[^\W_](?!\w)"),
    # What means nothing.
    Form("blank", "\x1b[32m", r"\x1b\[[0-9;?]{0,20}[A-Za-z]"),
    Form("blank", "/* length */", r"/\*.*?(?:\*/|$)"),
    Form("blank", "// length", r"//.*"),
    Form("blank", "0f |# length|", r"(?<=[\s,;)}\]])\#(?![xX$\d]).*"),
    Form("blank", "0f |; length|", r"(?<=[\s,;)}\]]);(?=\s*[^\W\d_]{2}[^()\[\]=;]*$).*"),
    Form("blank", "0f |-- length|", r"(?<=[\s,;)}\]])(?:--\s|%\s|'(?=\s*[A-Za-z]{3}[^']*$)).*"),
    Form("blank", "(byte)", rf"\({_TYPE}\s?\)\s?"),
    Form("blank", "as u8", r"(?<!\w)as\s(?:u8|byte)\b"),
    Form("blank", "&nbsp;", r"&\#?\w{2,5};"),
    Form("blank", "Columns 1 through 13", r"Columns?\s\d+(?:\s(?:through|and)\s\d+)?\s*$"),
    Form("blank", "</byte>", rf"</?(?!{_H}{{2}}>)[A-Za-z_][\w:.-]{{1,30}}\s?/?>"),
    Form("blank", "[0]=>", r"\[\d+\]\s?=>\s*$"),  # a key, whose value is in the next line
    # What looks like values, and are not
    Form("other", "00001101-0000-1000-8000-00805F9B34FB", rf"(?<!\w){_H}{{8}}(?:-{_H}{{4}}){{3}}-{_H}{{12}}(?!\w)"),
    Form(
        "other",
        "2024-01-31 12:30:45",
        rf"(?<![\w.:|/-]){_DATE}(?:[T\ ]\s?{CLOCK}(?![\w:|])|(?<=[\d/.-]{{8}})(?![\w:|./-]))",
    ),
    Form("other", "12:30:45.123", rf"(?<![\w.:|-]){CLOCK}(?=[\])>:;,-]?(?:\s|$))"),
    # The second byte of a frame is 0 to 3.
    Form("other", "00:16:53:42:2B:99", rf"(?<![\w:-]){_H}{{2}}[:-](?!0[0-3]){_H}{{2}}{_REST_OF_ADDRESS}"),
    Form("other", "fe80::1", rf"(?<![\w:.])(?:{_H}{{1,4}}:){{1,6}}:(?:{_H}{{1,4}}:){{0,5}}{_H}{{1,4}}(?![\w:])"),
    Form("other", "192.168.1.100", rf"(?<![\w.-])(?!{_DOTTED})[-+]?\d+(?:\.\d+){{1,3}}(?:e[-+]?\d+)?(?![\w.])"),
    Form("other", "</b>", r"</?[a-fA-F]>"),
    # All other values.
    Form("marked", "|0x0f|0x0", rf"0[xX]{_H}{{1,2}}?(?=0[xX]{_H}|(?!\w|\.to))"),
    Form(
        "marked",
        "0x0fu8",
        rf"(?<![\w$])(?:\\?0[xX]|\\[xX]|\$|&[hH]|\#[xX$]|[xX](?={_H}{{2}}(?!\w))){_H}+{_SUFFIX}?(?!\w)",
    ),
    Form("marked", "X'0f00'", rf"(?<!\w)[xX]'{_H}+'"),
    Form("marked", "0b00001111", r"(?<!\w)(?:0[bB]|\#b|B)[01]{4}_?[01]{4}(?!\w)"),
    Form("marked", "0f_00", rf"(?<!\w){_H}{{2}}(?:_{_H}{{2}})+(?!\w)"),
    Form("digits", "|0f|.", rf"(?<!\w){_H}+(?!\w|\.to)"),
    Form("marked", "0Fh", rf"(?<!\w){_H}+(?:[hH]|{_SUFFIX})(?!\w)"),
    Form("marked", "-128", r"(?<![\w\]<>=-])(?<![^a-z]\))-\d{1,3}(?![\w.])"),
    Form(
        "unknown",
        "0F00xxxx",
        rf"(?<!\w)(?:0[xX]|\\x)?(?:{_H}{{2}})*(?:[xX]{{2}}|MM|\?\?)(?:{_H}{{2}}|[xX]{{2}}|[mM]{{2}}|\?\?)*(?![\w?])",
    ),
    Form("unknown", EXPRESSION, f"{EXPRESSION}+"),
    Form("marked", "LC1(20)", rf"{_BEFORE}(?:\w{{1,20}}\.)?{_MACRO}"),
    Form("marked", "opNOP", rf"{_BEFORE}(?:[a-z]\w{{0,20}}\.)?(?:op[A-Z]\w+|[A-Z][A-Z0-9_]+){_AFTER}"),
    Form("cut", "... 12 more bytes", r"(?:\.{3}|\u2026)\s?\(?\d{1,5}\s(?:more\s)?(?:bytes|items)(?:\smore)?\)?"),
    Form(
        "cut",
        "(+235 bytes)",
        r"[\[(<](?:\+\d{1,5}\sbytes|\d{1,5}\s(?:more\sbytes|bytes\s(?:more|omitted|skipped|truncated)))[\])>]",
    ),
    Form("cut", "(truncated)", r"[\[(<](?:truncated|snip(?:ped)?)[\])>]"),
    Form("cut", "...", r"(?<![.>])(?<!\s\|)(?<!\s\s)\.{3}(?!\.)|[\u2026\u22ee]"),
    # Words are stepped over at once.
    Form("word", "length", r"[^\W\d]\w*"),
)  # fmt: skip
"""How values are written, and what is between them; the first form that matches at a place counts."""


@cache
def _splitter() -> tuple[re.Pattern[str], dict[str, str]]:
    # Compiled for the first line that has more than digits.
    runs = [(kind, [form.pattern for form in run]) for kind, run in groupby(FORMS, lambda form: form.kind)]
    forms = "|".join(f"(?P<{kind}_{number}>{'|'.join(run)})" for number, (kind, run) in enumerate(runs))
    pattern = re.compile(rf"(?=[^\s,:|])(?:{forms})", re.VERBOSE | re.DOTALL)
    return pattern, {name: name.rpartition("_")[0] for name in pattern.groupindex}


_PLAIN = re.compile(r"[0-9a-fA-F\s,|]*+|\s*(?:[0-9a-fA-F]{2}:)+\s*")
"""Lines of nothing but digits need no other form: they take a third of the time so."""
_DIGITS = re.compile(r"[0-9a-fA-F]+")
_LEAD = re.compile(rf"[\s/#;*>]*(?:(?:[\w.$@]{{1,40}}:?\s{{1,40}})?{_DIRECTIVE}(?:[ ]{{1,3}}|\t)(?=\S))?")
"""Marks of comments and quotations at the start of a line; `label: db ` of assemblers."""
_LOOKALIKES = str.maketrans(
    "\u2502\u2503\u250a\u00a0\u202f\u201c\u201d\u201e\u2018\u2019\u2010\u2011\u2013\u2212", '||   """\'\'----'
)


_WIDE = {code: chr(code - 0xFEE0) for code in range(0xFF01, 0xFF5F)} | {0x3000: " ", 0x3001: ","}


def narrow(text: str) -> str:
    """Returns the text with letters, digits and signs of usual width; it keeps its length."""
    return text if text.isascii() else text.translate(_WIDE)


def clean(line: str) -> str:
    """Returns the line with plain quotes, blanks and dashes; it keeps its length."""
    return line if line.isascii() else line.translate(_LOOKALIKES)


def elements_of(line: str, number: int = 0) -> tuple[list[TextElement], str]:
    """Returns the elements of a line, and what is behind the last one, without comments."""
    found: list[TextElement] = []
    new, at, gap = tuple.__new__, 0, ""  # as TextElement(...), in half its time: lines have many
    if _PLAIN.fullmatch(line) and "0b" not in line:
        return _plain_digits(line, number), ""
    lead = _LEAD.match(line)
    at = lead.end() if lead else 0
    pattern, kinds = _splitter()
    for match in pattern.finditer(line, at):
        kind = kinds[match.lastgroup or ""]
        if kind == "word":
            continue
        begin, end = match.span()
        gap, at = gap + line[at:begin], end
        if kind == "run":
            for start in range(begin, end, 3):
                found.append(new(TextElement, ("digits", line[start : start + 2], start, start + 2, gap, number)))
                gap = line[start + 2 : start + 3]
            gap = ""
        elif kind == "other":
            gap += "~"
        elif kind != "blank":
            found.append(new(TextElement, (kind, match[0], begin, end, gap, number)))
            gap = ""
    return found, gap + line[at:]


def _plain_digits(line: str, number: int) -> list[TextElement]:
    found: list[TextElement] = []
    new, at = tuple.__new__, 0
    for match in _DIGITS.finditer(line):
        begin, end = match.span()
        found.append(new(TextElement, ("digits", match[0], begin, end, line[at:begin], number)))
        at = end
    return found


# Unknown elements: expressions and texts in the places of others

_PART = r"""(?:[^,()\[\]{}"'`;=\\#]|\([^()]*\))"""
_CAST = rf"\({_TYPE}\s?\*?\)"
_SLOT = re.compile(
    rf"(?:^\s*|(?<!=\sappend)[\[{{(,]\s*+|\]\s?=\s?|<<\s)(?:{_CAST}\s*+)?"
    rf"((?!\s|$|[/#]|{_CAST})(?!(?<=\[)\w+\]|(?<=\(){_TYPE}\s?\*?\)){_PART}+?)(?=\s*(?:[,\]}});]|$))"
)
"""What is between two commas or brackets; a name alone in square brackets is a type: `let b: [UInt8] = [0x0f]`."""
_OPENING = re.compile(r"[\[{(]|<<\s")
_FIRST = re.compile(r"\s*(?:0[xX])?[0-9a-fA-F]+\s?,")
_IDENTIFIER = re.compile(r"(?<!\w)(?!0[xX])[A-Za-z_]\w*")
_WORDS = re.compile(r"[\w)]\s+\w")
_OPERATOR = re.compile(r"[+*/&|^%<>-]")
_TEXT_IN_CALL = re.compile(r"(?<=[\w\])]\()\"(?=[^\"\\]+\"\s?\))")


def widened(line: str, number: int, *, is_inside: bool) -> tuple[list[TextElement], str] | None:
    """Returns what `elements_of` does, with expressions and texts: `{size, 0}`, `m[0] = size;`, `print("abc")`.

    None if there are none but those of `elements_of`. `is_inside` tells that the line begins inside a list.
    """
    opening = _FIRST.match(line) or _OPENING.search(line)
    start = 0 if is_inside else len(line) if opening is None else opening.start()
    if _IDENTIFIER.search(line, start) is None:
        return None
    parts, at = [line[:start]], start
    for found in _SLOT.finditer(line, start):
        begin, end = found.span(1)
        if known_name(found[1]) is not None or _is_expression(found[1]):
            parts += (line[at:begin], EXPRESSION * (end - begin))
            at = end
    wide = _TEXT_IN_CALL.sub(TEXT, "".join([*parts, line[at:]]))
    if wide == line:
        return None
    elements, after = elements_of(wide, number)
    return [_named(one, line) for one in elements], after


def _named(element: TextElement, line: str) -> TextElement:
    """Returns an expression that is the name of an operation or a type as its byte."""
    data = known_name(line[element.start : element.end]) if element.text[0] == EXPRESSION else None
    return element if data is None else element._replace(kind="marked", text=f"0x{data.hex()}")


def _is_expression(text: str) -> bool:
    if _IDENTIFIER.search(text) is None or _WORDS.search(text):
        return False
    known = elements_of(text)[0]
    if len(known) != 1 or (known[0].kind == "marked" and BYTES["hex"][known[0].text] is None):
        return True  # a name without a meaning is one, too
    return _OPERATOR.search(text[: known[0].start] + text[known[0].end :]) is not None


# Bytes

BASES = ("hex", "decimal", "bits", "octal", "words", "base64", "unquoted")
"""What bare digits may be. A run has one base; for `'a'` it says if it is a digit."""

UNLIKELY = ("bits", "octal", "words", "base64", "unquoted")
"""The bases in which a frame must be without a flaw, as any numbers have them."""

_ONLY_DIGITS = re.compile(rf"(?!0[bB][01]{{8}}$){_H}+")
_UNKNOWN = re.compile(rf"(?:0[xX]|\\x)?((?:{_H}{{2}}|[xX]{{2}}|[mM]{{2}}|\?\?)+)")
_NAMED = {"a": "\a", "b": "\b", "t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b"}
MISSPELT = re.compile(r"(?<!\\)(?:\\\\)*(?P<word>\\[xX](?!\{?[0-9a-fA-F]).{0,2})")
r"""An escape without hex digits, such as `\xof`."""
_LONGEST_KEPT, _MOST_KEPT, _MOST_ESCAPES = 8, 1 << 14, 1 << 12


def unknown_bytes(element: TextElement) -> list[bool]:
    """Returns for each byte of an element with unknown ones whether it is unknown; nothing for any other."""
    if element.kind != "unknown":
        return []
    if element.text[0] == EXPRESSION:
        return [True]
    found = _UNKNOWN.fullmatch(element.text)
    return [pair[0] in "xXmM?" for pair in re.findall("..", found[1] if found else "")]


class _Table(dict[str, bytes | None]):
    """The bytes of elements in one base; None where one has none."""

    def __init__(self, base: str) -> None:
        self._base = base

    def __missing__(self, text: str) -> bytes | None:
        if len(text) > _LONGEST_KEPT or len(self) >= _MOST_KEPT:
            return _of_long(text, self._base)
        return self.setdefault(text, _bytes_of(text, self._base))


def _byte(number: int, least: int = 0) -> bytes | None:
    return bytes((number & 0xFF,)) if least <= number < 256 else None


def _hex(digits: str) -> bytes | None:
    if len(digits) in (8, 16) and not digits[:-2].strip("fF"):
        return bytes.fromhex(digits[-2:])  # a negative byte of Java or C, spread over 32 or 64 bits
    return bytes.fromhex(digits.zfill(2)) if len(digits) == 1 or len(digits) % 2 == 0 else None


def _decimal(digits: str) -> bytes | None:
    return _byte(int(digits)) if len(digits) <= 3 and digits.isdecimal() else None


def _bits(digits: str) -> bytes | None:
    return int(digits, 2).to_bytes(len(digits) // 8, "big") if len(digits) % 8 == 0 and {*digits} <= {*"01"} else None


def _octal(digits: str) -> bytes | None:
    return _byte(int(digits, 8)) if len(digits) in (3, 4) and {*digits} <= {*"01234567"} else None


def _words(digits: str) -> bytes | None:
    return bytes.fromhex(digits)[::-1] if len(digits) in (2, 4, 6, 8) else None


def _base64(text: str) -> bytes | None:
    digits = text.rstrip("=").replace("-", "+").replace("_", "/")
    try:
        return binascii.a2b_base64(digits + "=" * (-len(digits) % 4), strict_mode=True)
    except (binascii.Error, ValueError):
        return None


_OF_DIGITS = {
    "hex": _hex,
    "unquoted": _hex,
    "decimal": _decimal,
    "bits": _bits,
    "octal": _octal,
    "words": _words,
    "base64": _base64,
}


class Way(NamedTuple):
    """How an element says what it is: an example, the pattern of all of it, and its bytes in a base."""

    example: str
    pattern: str
    bytes_of: Callable[[re.Match[str], str], bytes | None]


_WAYS = (
    Way("'0f'", r"'([0-9a-fA-F]+)'", lambda found, base: _unquoted(found[1], base)),
    Way(f'{TEXT}ab"', rf"{TEXT}([^\"]*)\"", lambda found, _: string_bytes(found[1])),
    Way(r"b'\x0f'", r"""[^'"`\\xX]*(["'`])(.*)\1""", lambda found, _: string_bytes(found[2])),
    Way("$a", r"\$([^0-9a-fA-F]|[a-fA-F])", lambda found, base: _character(found[1], base)),
    Way(
        "0xf",
        rf"(?:\\?0[xX]|\\[xX]|\#?\$|&[hH]|\#[xX]|[xX])'?({_H}+)(?:'|{_SUFFIX})?",
        lambda found, _: _hex(found[1]),
    ),
    # Assemblers want a digit first: `0A3h`.
    Way("0A3h", rf"(?:0(?=(?:{_H}{{2}})+[hH]))?({_H}+)[hH]", lambda found, _: _hex(found[1])),
    Way("0b00001111", r"(?:0[bB]|#b|B)([01]{4})_?([01]{4})", lambda found, _: _byte(int(found[1] + found[2], 2))),
    Way("-128", rf"(-?\d{{1,9}}){_SUFFIX}?", lambda found, _: _byte(int(found[1]), -128)),
    Way(EXPRESSION, f"{EXPRESSION}+", lambda *_: b"\0"),
    Way("0fxx", _UNKNOWN.pattern, lambda found, _: bytes.fromhex(re.sub("[xXmM?]", "0", found[1]))),
    Way("0f_00", rf"{_H}{{2}}(?:_{_H}{{2}})+", lambda found, _: bytes.fromhex(found[0].replace("_", ""))),
    Way(r"\17\0", r"\\.*", lambda found, _: string_bytes(found[0])),
    Way("opNOP", r".*", lambda found, _: _of_name(found[0])),
)
"""The first row that fits counts."""


def _unquoted(text: str, base: str) -> bytes | None:
    return _hex(text) if base == "unquoted" else string_bytes(text)


def _character(letter: str, base: str) -> bytes | None:
    return (
        _hex(letter) if base != "decimal" and letter in "abcdefABCDEF" else letter.encode("latin-1", "ignore") or None
    )


_compiled = cache(lambda pattern: re.compile(pattern, re.DOTALL))


def _bytes_of(text: str, base: str) -> bytes | None:
    if _ONLY_DIGITS.fullmatch(text):
        return _OF_DIGITS[base](text)
    if base == "base64":
        return _base64(text)
    ways = ((way, _compiled(way.pattern).fullmatch(text)) for way in _WAYS)
    return next((way.bytes_of(found, base) for way, found in ways if found is not None), None)


_of_long = lru_cache(64)(_bytes_of)


_ESCAPES = re.compile(
    rf"\\(?:u00({_H}{{2}})|[xXu](?:\{{({_H}{{1,2}})\}}|({_H}{{1,2}}))|([0-3]?[0-7]{{1,2}})|(.))", re.DOTALL
)


@lru_cache(_MOST_ESCAPES)
def _unescaped(escape: str) -> str:
    """Returns the character of an escape; a letter without a meaning is itself after its backslash, as in Python."""
    found = _ESCAPES.fullmatch(escape)
    assert found is not None
    *digits, octal, other = found.groups()
    if other is not None:
        return _NAMED.get(other, escape if other.isalpha() else other)
    return chr(int(octal, 8) if octal else int("".join(filter(None, digits)), 16))


def string_bytes(body: str) -> bytes | None:
    """Returns the bytes of what is between two quotes; None where an escape is wrong, or a character is not a byte."""
    try:
        return None if MISSPELT.search(body) else _ESCAPES.sub(lambda one: _unescaped(one[0]), body).encode("latin-1")
    except UnicodeEncodeError:
        return None


_MACRO_CALL = re.compile(r"(?:\w+\.)?(LC[0124SXF]|[LG]V[0124X]|LAB1|EV3_\w+)\s?\(\s*([^()]*?)\s*\)")


_NAME = re.compile(
    rf"(?P<cast>(?:static_cast<)?{_TYPE}>?\()?(?P<owner>(?:\w+(?:\.|::))*?)(?P<name>[A-Za-z]\w+?)"
    r"(?:\.(?:\w+\(\)|rawValue|value|code|byte)|\sas\s\w+)*(?(cast)\))"
)
"""A name of another program: `Op.OutputSpeed`, `Op::OutputSpeed as u8`, `X.opY.code.toByte()`, `byte(OpNop)`."""
_OWN = re.compile(r"[oO]p[A-Z]|[A-Z][a-z]+[A-Z]|[A-Za-z]+_")
"""How a name begins that is not a variable's: `opNop`, `DirectReply`, `TYPE_`."""


def _plain(name: str) -> str:
    return name.replace("_", "").upper()


@cache
def _constants() -> dict[str, bytes]:
    """Returns the bytes of the names of LEGO's headers, operations and types of frames, as `_plain` writes names."""
    found: dict[str, object] = {name: names.constant(name) for name in names.constant_names()}
    types: dict[str, object] = {**MessageType.__members__}
    # `CommandType.DirectReply` is a command, `ReplyType.DirectReply` a reply.
    commands = {name.replace("_COMMAND", ""): types[name] for name in types if "_COMMAND" in name}
    found |= {f"OP{one.name}": one.number for one in OPCODES} | types
    plain = {_plain(name): value for name, value in (commands | found).items()}
    plain |= {f"COMMAND{_plain(name)}": value for name, value in commands.items()}
    encoded = {name: bytes((value,)) for name, value in plain.items() if isinstance(value, int) and 0 <= value <= 255}
    return encoded | {name: value for name, value in plain.items() if isinstance(value, bytes)}


def known_name(text: str) -> bytes | None:
    """Returns the byte of an operation, a CMD, a type of a frame, a constant, however a program writes its name."""
    name = _NAME.fullmatch(text.strip())
    if name is None or not (name["owner"][:1].isupper() or name["name"].isupper() or _OWN.match(name["name"])):
        return None
    plain, known = _plain(name["name"]), _constants()
    # An operation alone in capital letters is a word of a table.
    is_other = bool(name["owner"]) or not name["name"].isupper()
    of_owner = known.get("COMMAND" * ("ommand" in name["owner"]) + plain)
    return of_owner or known.get(plain) or (known.get(f"OP{plain}") if is_other else None)


def _of_name(text: str) -> bytes | None:
    """Returns the bytes of a name, of one of LEGO's macros, or of one of those that begin a frame in `ev3proto.h`."""
    call = _MACRO_CALL.fullmatch(text)
    if call is None:
        return known_name(text)
    macro, value = call.groups()
    try:
        if macro in _OF_HEADER:
            return _OF_HEADER[macro](*map(_value, value.split(",")))
        if macro == "LCS":
            return names.LCS(value[1:-1]) if len(value) > 1 and value[0] == value[-1] in "\"'" else None
        encode = getattr(names, macro, None)
        return encode_as(macro, _number(value)) if encode is None else encode(_number(value))
    except (BuildError, KeyError, TypeError, ValueError):
        return None


_OF_HEADER: dict[str, Callable[..., bytes]] = {
    "EV3_HEADER": lambda size, counter, code: build_frame(code, counter, b"", size - LENGTH_FIELD),
    "EV3_MEMORY": write_memory,
}
"""The macros of `ev3proto.h` that begin a frame."""


def _value(text: str) -> int:
    """Returns a number or the byte of a name."""
    data = known_name(text)
    return int(text, 0) if data is None else data[0]


def _number(text: str) -> int:
    """Returns the number in a macro, which may have a name; that of a constant is encoded already."""
    data = _constants().get(_plain(text))
    if data is None:
        return int(text, 0)
    number = int.from_bytes(data[1:] or bytes((data[0] << 2 & 0xFF,)), "little", signed=True)
    return number >> 2 * (len(data) == 1)


BYTES = {base: _Table(base) for base in BASES}
"""The bytes of elements, by base."""

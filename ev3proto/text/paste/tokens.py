r"""A line of text -> the values in it, and the bytes of a value.

A line is split once, by the table `FORMS`. A value is a group of bare digits (`0f`, `15`, `0f00`), whose base is not
known yet, or something that says itself what it is: `0x0f`, `0Fh`, `-128`, `'a'`, `"\x0f\0"`, `LC1(20)`, `xx`. Between
two values is a gap. To add a notation, add a row here, and its bytes in `_bytes_of`; a test reads every example.
"""

from __future__ import annotations

import binascii
import re
from collections.abc import Iterator
from functools import cache
from itertools import groupby
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.schema import names
from ev3proto.schema.argument import encode_as
from ev3proto.tables import OPCODES
from ev3proto.tables.frame import MessageType
from ev3proto.text.paste.heads import CLOCK


class Token(NamedTuple):
    """A value of a line.

    kind   "digits" have any base; "marked" says itself what it is; "string" has many bytes; "character" is one, in
           single quotes; "unknown" has bytes that are not given; "cut" is an ellipsis, and "open" a string without
           its second quote, which have none
    text   as it is written
    start  where it is in its line
    end
    gap    what is in front of it, without comments and casts
    line   the number of its line
    """

    kind: str
    text: str
    start: int
    end: int
    gap: str
    line: int


class Form(NamedTuple):
    """How something is written: a kind of value, "blank" for what means nothing, "other" for all else.

    In examples, the value is between bars if there is something around it.
    """

    kind: str
    example: str
    pattern: str


EXPRESSION = "\ufffc"
"""What is read in place of each character of an expression, which is an unknown value."""
TEXT = "\ufffb"
"""What is read in place of the first quote of a string without escapes, if its characters are bytes."""

_H = "[0-9a-fA-F]"
_SUFFIX = r"(?:_?u8|[uU]?[yYL]|L?[uU]|\.to(?:U?Byte|Char)\(\))"
_ESCAPE = rf"\\(?:[xX]\{{?{_H}{{1,2}}\}}?|u00{_H}{{2}}|u\{{{_H}{{1,2}}\}}|[0-3]?[0-7]{{1,2}}|[abtnvfre\\\"'\ \#])"
_CHARACTER = rf"(?:\\(?:[xX]{_H}{{1,2}}|[0-7]{{1,3}}|[^\dxX])|[^'\\])"
_MACRO = r"(?:LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\([^()]{0,80}\)"
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
    Form("marked", r"\x0f0000008000", rf"\\x{_H}{{10,}}(?![\w\\])"),
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
    Form("marked", "|0x0f|0x00", rf"0[xX]{_H}{{2}}(?=0[xX]{_H}{{2}}|(?!\w|\.to))"),
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
        rf"(?<!\w)(?:0[xX]|\\x)?(?:{_H}{{2}})*(?:[xX]{{2}}|MM)(?:{_H}{{2}}|[xX]{{2}}|[mM]{{2}})*(?!\w)",
    ),
    Form("unknown", EXPRESSION, f"{EXPRESSION}+"),
    Form("marked", "LC1(20)", rf"{_BEFORE}(?:\w{{1,20}}\.)?{_MACRO}"),
    Form("marked", "opNOP", rf"{_BEFORE}(?:[a-z]\w{{0,20}}\.)?(?:op[A-Z]\w+|[A-Z][A-Z0-9_]+){_AFTER}"),
    Form("cut", "...", r"(?<![.>])(?<!\s\|)(?<!\s\s)\.{3}(?!\.)|\u2026"),
    # Words are stepped over at once.
    Form("word", "length", r"[^\W\d]\w*"),
)  # fmt: skip
"""How values are written, and what is between them; the first form that matches at a place counts."""


class _Splitter(NamedTuple):
    pattern: re.Pattern[str]
    kinds: dict[str, str]


@cache
def _splitter() -> _Splitter:
    # Compiled for the first line that has more than digits.
    runs = [(kind, [form.pattern for form in run]) for kind, run in groupby(FORMS, lambda form: form.kind)]
    forms = "|".join(f"(?P<{kind}_{number}>{'|'.join(run)})" for number, (kind, run) in enumerate(runs))
    pattern = re.compile(rf"(?=[^\s,:|])(?:{forms})", re.VERBOSE | re.DOTALL)
    return _Splitter(pattern, {name: name.rpartition("_")[0] for name in pattern.groupindex})


_PLAIN = re.compile(r"[0-9a-fA-F\s,|]*+|\s*(?:[0-9a-fA-F]{2}:)+\s*")
"""Lines of nothing but digits: they need no other form. A line that ends with a colon is not a time."""
_DIGITS = re.compile(r"[0-9a-fA-F]+")
_LEAD = re.compile(rf"[\s/#;*>]*(?:(?:[\w.$@]{{1,40}}:?\s{{1,40}})?{_DIRECTIVE}(?:[ ]{{1,3}}|\t)(?=\S))?")
"""Marks of comments and quotations at the start of a line, in which there may be bytes; `label: db ` of assemblers.

Among pairs of digits, `db` is a byte.
"""
_LOOKALIKES = str.maketrans(
    "\u2502\u2503\u250a\u00a0\u202f\u201c\u201d\u201e\u2018\u2019\u2010\u2011\u2013\u2212", '||   """\'\'----'
)
"""Frames of tables, blanks that do not break, smart quotes, dashes."""


def clean(line: str) -> str:
    """Returns the line with plain quotes, blanks and dashes; it keeps its length."""
    return line if line.isascii() else line.translate(_LOOKALIKES)


def tokens_in(line: str, number: int = 0) -> list[Token]:
    """Returns the values of a line."""
    return split(line, number)[0]


def split(line: str, number: int) -> tuple[list[Token], str]:
    """Returns the values of a line, and what is behind the last one, without comments."""
    if _PLAIN.fullmatch(line) and "0b" not in line:
        return list(_plain_tokens(line, number)), ""
    found: list[Token] = []
    lead = _LEAD.match(line)
    at, gap = (0 if lead is None else lead.end()), ""
    pattern, kinds = _splitter()
    for match in pattern.finditer(line, at):
        kind = kinds[match.lastgroup or ""]
        if kind == "word":
            continue
        begin, end = match.span()
        gap += line[at:begin]
        at = end
        if kind == "run":
            gaps = [gap, *line[begin + 2 : end : 3]]
            found += [
                tuple.__new__(Token, ("digits", line[start : start + 2], start, start + 2, gap, number))
                for start, gap in zip(range(begin, end, 3), gaps, strict=True)
            ]
            gap = ""
        elif kind == "other":
            gap += "~"
        elif kind != "blank":
            # As Token(...), in half its time: lines have many.
            found.append(tuple.__new__(Token, (kind, match[0], begin, end, gap, number)))
            gap = ""
    return found, gap + line[at:]


def _plain_tokens(line: str, number: int) -> Iterator[Token]:
    at = 0
    for match in _DIGITS.finditer(line):
        yield Token("digits", match[0], match.start(), match.end(), line[at : match.start()], number)
        at = match.end()


# Expressions and texts

_PART = r"""(?:[^,()\[\]{}"'`;=\\]|\([^()]*\))"""
_ELEMENT = re.compile(rf"(?:^\s*|[\[{{(,]\s*+|\]\s?=\s?)((?!\s|$)(?!(?<=\[)\w+\]){_PART}+?)(?=\s*(?:[,\]}});]|$))")
"""A name alone in square brackets is a type or an index: `let b: [UInt8] = [0x0f]`."""
_OPENING = re.compile(r"[\[{(]")
_IDENTIFIER = re.compile(r"(?<!\w)(?!0[xX])[A-Za-z_]\w*")
_WORDS = re.compile(r"[\w)]\s+\w")
_OPERATOR = re.compile(r"[+*/&|^%<>-]")
_TEXT_IN_CALL = re.compile(r"(?<=[\w\])]\()\"(?=[^\"\\]+\"\s?\))")


def widened(line: str, number: int, *, is_inside: bool) -> list[Token] | None:
    """Returns the values with expressions and texts among them: `{size, 0}`, `m[0] = size;`, `print("abc")`.

    Args:
        line: A line.
        number: Its number.
        is_inside: It begins inside a list; otherwise its first bracket opens one.

    Returns:
        The values; None if there are none but those of `tokens_in`.
    """
    opening = _OPENING.search(line)
    start = 0 if is_inside else len(line) if opening is None else opening.start()
    if _IDENTIFIER.search(line, start) is None:
        return None
    count = 0
    parts, at = [line[:start]], start
    for found in _ELEMENT.finditer(line, start):
        begin, end = found.span(1)
        if _is_expression(found[1]):
            parts += (line[at:begin], EXPRESSION * (end - begin))
            at, count = end, count + 1
    wide = "".join([*parts, line[at:]])
    if count * 2 > line.count(",", start) + 1 and count != 1:
        wide = line
    wide = _TEXT_IN_CALL.sub(TEXT, wide)
    return None if wide == line else tokens_in(wide, number)


def _is_expression(value: str) -> bool:
    if _IDENTIFIER.search(value) is None or _WORDS.search(value):
        return False
    known = tokens_in(value)
    return len(known) != 1 or _OPERATOR.search(value[: known[0].start] + value[known[0].end :]) is not None


# Bytes

BASES = ("hex", "decimal", "bits", "octal", "words", "base64", "unquoted")
"""What bare digits may be. A sequence has one base; in strings it says what `\128` is, for `'a'` if it is a digit."""

UNLIKELY = ("bits", "octal", "words", "base64", "unquoted")
"""The bases in which a frame must be without a flaw, as any numbers have them."""

_ONLY_DIGITS = re.compile(rf"(?!0[bB][01]{{8}}$){_H}+")
_UNKNOWN = re.compile(rf"(?:0[xX]|\\x)?((?:{_H}{{2}}|[xX]{{2}}|[mM]{{2}})+)")
_MARKED_HEX = re.compile(
    rf"(?:\\?0[xX]|\\[xX]|\#?\$|&[hH]|\#[xX]|[xX])'?({_H}+)(?:'|{_SUFFIX})?|(?:0(?=(?:{_H}{{2}})+[hH]))?({_H}+)[hH]"
)
"""Assemblers want a digit first: `0A3h`."""
_MARKED_BITS = re.compile(r"(?:0[bB]|#b|B)([01]{4})_?([01]{4})")
_MARKED_DECIMAL = re.compile(rf"(-?\d+){_SUFFIX}?")
_CALL = re.compile(r"(LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\(\s*([^()]*?)\s*\)")
_NAMED = {"a": "\a", "b": "\b", "t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b"}
MISSPELT = re.compile(r"(?<!\\)(?:\\\\)*(?P<escape>\\[xX](?!\{?[0-9a-fA-F]).{0,2})")
r"""An escape without hex digits, such as `\xof`."""
_SHORT = 8
_LONGEST_KEPT, _MOST_LONG = 1 << 12, 16
_MOST_KEPT = 1 << 14


def unknown_bytes(token: Token) -> list[bool]:
    """Returns for each byte of a value with unknown ones whether it is unknown; nothing for any other value."""
    if token.kind != "unknown":
        return []
    if token.text[0] == EXPRESSION:
        return [True]
    found = _UNKNOWN.fullmatch(token.text)
    return [pair[0] in "xXmM" for pair in re.findall("..", found[1] if found else "")]


class _Table(dict[str, bytes | None]):
    """The bytes of values in one base; None where a value has none."""

    def __init__(self, base: str) -> None:
        self._base, self._long = base, dict[str, bytes | None]()

    def __missing__(self, text: str) -> bytes | None:
        if text in self._long:
            return self._long[text]
        data = _bytes_of(text, self._base)
        if len(text) <= _SHORT and len(self) < _MOST_KEPT:
            self[text] = data
        elif _SHORT < len(text) <= _LONGEST_KEPT:
            # A long one is asked for several times while its line is read, then hardly ever.
            if len(self._long) >= _MOST_LONG:
                self._long.clear()
            self._long[text] = data
        return data


def _bytes_of(text: str, base: str) -> bytes | None:
    if _ONLY_DIGITS.fullmatch(text):
        return _of_digits(text, base)
    if base == "base64":
        return _of_base64(text)
    if text[0] == "'" and base == "unquoted":
        return _of_digits(text[1:-1], "hex") if _ONLY_DIGITS.fullmatch(text[1:-1]) else None
    quote = text[text[0] == "b" : 1 + (text[0] == "b")]
    if text[0] in (".", "\u2026") or (quote in ("'", '"') and text[-1] != quote):
        return None  # an ellipsis, a string without its second quote
    if text[-1] in "\"'`" and text[0] not in "xX":
        return string_bytes(text[1 if text[0] == TEXT else text.index(text[-1]) + 1 : -1], base)
    if text[0] == "$" and len(text) == 2 and (base == "decimal" or text[1] not in "abcdefABCDEF"):
        return text[1].encode("latin-1", "ignore") or None
    return _of_marked(text) or (string_bytes(text, base) if text[0] == "\\" else _of_name(text))


def _of_marked(text: str) -> bytes | None:
    if found := _MARKED_HEX.fullmatch(text):
        return _of_digits(found[1] or found[2], "hex")
    if found := _MARKED_BITS.fullmatch(text):
        return bytes((int(found[1] + found[2], 2),))
    if found := _MARKED_DECIMAL.fullmatch(text):
        return bytes((int(found[1]) & 0xFF,)) if -128 <= int(found[1][:9]) < 256 else None
    if text[0] == EXPRESSION:
        return b"\0"
    if found := _UNKNOWN.fullmatch(text):
        return bytes.fromhex(re.sub("[xXmM]", "0", found[1]))
    joined = text.replace("_", "")
    return bytes.fromhex(joined) if text[2:3] == "_" and _ONLY_DIGITS.fullmatch(joined) else None


def _of_digits(digits: str, base: str) -> bytes | None:
    size = len(digits)
    if base in ("hex", "unquoted"):
        if size == 8 and digits[:6] in ("ffffff", "FFFFFF"):
            return bytes.fromhex(digits[6:])  # a negative byte of Java or C, spread over 32 bits
        return bytes.fromhex(digits.zfill(2)) if size == 1 or size % 2 == 0 else None
    if base == "decimal":
        return bytes((int(digits),)) if size <= 3 and digits.isdecimal() and int(digits) < 256 else None
    if base == "bits":
        return int(digits, 2).to_bytes(size // 8, "big") if size % 8 == 0 and {*digits} <= {"0", "1"} else None
    if base == "octal":
        is_octal = size in (3, 4) and {*digits} <= {*"01234567"} and int(digits, 8) < 256
        return bytes((int(digits, 8),)) if is_octal else None
    if base == "words":
        return bytes.fromhex(digits)[::-1] if size in (2, 4, 6, 8) else None
    return _of_base64(digits)


def _of_base64(text: str) -> bytes | None:
    digits = text.rstrip("=").replace("-", "+").replace("_", "/")
    try:
        return binascii.a2b_base64(digits + "=" * (-len(digits) % 4), strict_mode=True)
    except (binascii.Error, ValueError):
        return None


def string_bytes(body: str, base: str) -> bytes | None:
    r"""Returns the bytes of what is between two quotes; in the base "decimal", `\128` is one byte, as in Lua."""
    known = _CHARACTERS["decimal" if base == "decimal" else "hex"]
    try:
        return (
            None if MISSPELT.search(body) else known.escapes.sub(lambda found: known[found[0]], body).encode("latin-1")
        )
    except UnicodeEncodeError:
        return None


class _Characters(dict[str, str]):
    """The characters of escapes, with octal or with decimal digits."""

    def __init__(self, base: int, digits: str) -> None:
        self._base = base
        self.escapes = re.compile(
            rf"\\(?:u00({_H}{{2}})|[xXu](?:\{{({_H}{{1,2}})\}}|({_H}{{1,2}}))|({digits})|(.))", re.DOTALL
        )

    def __missing__(self, escape: str) -> str:
        found = self.escapes.fullmatch(escape)
        assert found is not None
        *digits, number, other = found.groups()
        if other is not None:
            # A letter without a meaning is itself after its backslash, as in Python.
            return _NAMED.get(other, escape if other.isalpha() else other)
        code = int(next(filter(None, digits)), 16) if number is None else int(number, self._base)
        return self.setdefault(escape, chr(code))


_CHARACTERS = {"hex": _Characters(8, "[0-3]?[0-7]{1,2}"), "decimal": _Characters(10, r"\d{1,3}")}


@cache
def _constants() -> dict[str, bytes]:
    """Returns the bytes of the names of LEGO's headers."""
    found = {f"op{opcode.name}": bytes((opcode.number,)) for opcode in OPCODES}
    for name in names.constant_names():
        value = names.constant(name)
        if isinstance(value, bytes) or (isinstance(value, int) and 0 <= value <= 255):
            found[name] = value if isinstance(value, bytes) else bytes((value,))
    return found | {name: bytes((member,)) for name, member in MessageType.__members__.items()}


def _of_name(text: str) -> bytes | None:
    """Returns the bytes of a name of LEGO's headers, or of one of their macros."""
    text = text.rpartition(".")[2] if text[:1].islower() and not text.startswith("op") and "(" not in text else text
    call = _CALL.fullmatch(text.partition(".")[2] if re.match(r"\w+\.\w+\s?\(", text) else text)
    if call is None:
        return _constants().get(text)
    macro, value = call.groups()
    try:
        if macro == "LCS":
            return names.LCS(value[1:-1]) if len(value) > 1 and value[0] == value[-1] in "\"'" else None
        encode = getattr(names, macro, None)
        return encode_as(macro, _number(value)) if encode is None else encode(_number(value))
    except (BuildError, KeyError, ValueError):
        return None


def _number(text: str) -> int:
    """Returns the number in a macro, which may have a name; that of a constant is encoded already."""
    data = _constants().get(text)
    if data is None:
        return int(text, 0)
    number = int.from_bytes(data[1:] or bytes((data[0] << 2 & 0xFF,)), "little", signed=True)
    return number >> 2 * (len(data) == 1)


BYTES = {base: _Table(base) for base in BASES}
"""The bytes of values, by base."""

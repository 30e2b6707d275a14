"""The strict dialect: tokens in free form, and the grammar that the public assembler lmsasm has.

Beyond that it takes what a decompiled program needs: the forms that name an encoding, `bytes(...)`, and strings in
double quotes with the escapes of JSON. No other assembler has them, and none takes them for something else.
"""

from __future__ import annotations

import json
import re

from ev3proto.program.source.errors import SourceError
from ev3proto.program.source.numbers import fits, single_bits, strict_text, wrapped
from ev3proto.program.source.statements import (
    DefineStatement,
    EncodedValue,
    Float,
    Item,
    LabelStatement,
    MarkedName,
    Name,
    Number,
    ObjectSource,
    OperationStatement,
    RawArgument,
    Statement,
    Sum,
    Text,
    Unchecked,
    Value,
    VariableStatement,
)
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.source import (
    BYTES,
    DEFINE,
    FORMS,
    OBJECT_WORDS,
    PARAMETER_WORDS,
    SIZED_PARAMETERS,
    SIZED_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.text.assembly.errors import MOST_ERRORS
from ev3proto.text.assembly.symbols import suggestion

MAX_DEPTH = 50
"""How deep expressions may stand in each other."""

_TOKEN = re.compile(
    r"""(?>(?:[ \t\r\n\f\v\x1a\ufeff]++ | //[^\r\n]*+)*)
      (?:(?P<name>[A-Za-z_]\w*+)
      | (?P<mark>[{}(),:@&!+*-])
      | (?P<float>(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE][+-]?\d+)?F(?![\w.]))
      | (?P<number>(?:0[xX][0-9a-fA-F]+|\d+)(?![\w.]))
      | (?P<text>'[^'\r\n]*')
      | (?P<comment>/\*)
      | (?P<quoted>"(?:[^"\\\r\n]|\\[^\r\n])*")
      | (?P<slash>/)
      | (?P<end>\Z))""",
    re.VERBOSE | re.ASCII,
)
_RAW = re.compile(r"bytes\((?>(?:[0-9A-Fa-f]{2}|\s)*)\)")
_BLANK = re.compile(r"(?>(?:[ \t\r\n\f\v\x1a\ufeff]++|//[^\r\n]*+)*)")
_STRAY_WORD = re.compile(r"[\w.]+")
_ESCAPED = re.compile(r"\\(?P<known>[nqrt\\])?", re.DOTALL)
_END = ""
_MARKS = frozenset("{}(),:@&!+-*/")
_SIZED = frozenset((*SIZED_WORDS, *SIZED_PARAMETERS))
_DECLARING = frozenset((*VARIABLE_WORDS, *PARAMETER_WORDS))
_KEYWORDS = (DEFINE, *OBJECT_WORDS, *VARIABLE_WORDS)


class StrictParser:
    """Reads one source.

    items     declarations, defines, objects, in their order
    errors    what is wrong with the text
    warnings  what is right and may not be meant: offset and sentence
    """

    def __init__(self, text: str, coding: str) -> None:
        self.items: list[Item] = []
        self.errors: list[SourceError] = []
        self.warnings: list[tuple[int, str]] = []
        self._text = text
        self._coding = coding
        self._kinds: list[str] = []
        self._texts: list[str] = []
        self._ats: list[int] = []
        self._at = 0
        self._depth = 0
        self._tokenize()
        self._file()

    # Tokens

    def _tokenize(self) -> None:
        text = self._text
        kinds, texts, ats = self._kinds, self._texts, self._ats
        match = _TOKEN.match
        at, size = 0, len(text)
        while True:
            found = match(text, at)
            if found is None:
                blank = _BLANK.match(text, at)
                at = blank.end() if blank else at
                if len(self.errors) < MOST_ERRORS:
                    self.errors.append(SourceError(at, self._stray(at)))
                at = self._behind_stray(at)
                continue
            kind = found.lastgroup or ""
            start = found.start(kind)
            at = found.end()
            if kind == "name":
                if found[kind] == BYTES and text.startswith("(", at):
                    raw = _RAW.match(text, start)
                    if raw is not None:
                        kinds.append("raw")
                        texts.append(raw[0])
                        ats.append(start)
                        at = raw.end()
                        continue
            elif kind == "comment":
                end = text.find("*/", at)
                if end < 0:
                    self.errors.append(SourceError(start, "the comment that starts here has no */"))
                    break
                at = end + 2
                continue
            elif kind == "end":
                break
            kinds.append("mark" if kind == "slash" else kind)
            texts.append(found[kind])
            ats.append(start)
        kinds.append("end")
        texts.append(_END)
        ats.append(size)

    def _stray(self, at: int) -> str:
        """What to say of a place where no token starts."""
        character = self._text[at]
        if character in "'\"":
            return f"the string that starts here has no {character} at its end"
        word = _STRAY_WORD.match(self._text, at)
        if word is None:
            return f"{character!r} cannot stand here"
        if "." in word[0] or word[0][0].isdigit():
            return f"{word[0][:40]} is no number: floats end in F, hexadecimal starts with 0x"
        return f"{word[0][:40]} cannot stand here"

    def _behind_stray(self, at: int) -> int:
        """Where reading goes on after a place where no token starts: after the word, or the string without an end."""
        if self._text[at] in "'\"":
            return self._behind_line(at)
        word = _STRAY_WORD.match(self._text, at)
        return word.end() if word else at + 1

    def _behind_line(self, at: int) -> int:
        found = re.compile(r"[\r\n]").search(self._text, at)
        return found.start() if found else len(self._text)

    # The file

    def _file(self) -> None:
        while self._texts[self._at] or self._kinds[self._at] != "end":
            start = self._at
            try:
                self.items.append(self._item())
            except SourceError as error:
                self._recover(error, start)
            if len(self.errors) >= MOST_ERRORS:
                return

    def _recover(self, error: SourceError, start: int) -> None:
        """Keeps an error, and goes on with the next line."""
        self.errors.append(error)
        self._depth = 0
        self._at = max(self._at, start + 1)
        end = self._behind_line(self._ats[min(self._at, len(self._ats) - 1) - 1])
        while self._kinds[min(self._at, len(self._kinds) - 1)] != "end" and self._ats[self._at] < end:
            self._at += 1
        self._at = min(self._at, len(self._ats) - 1)

    def _item(self) -> Item:
        word, at = self._texts[self._at], self._ats[self._at]
        if word == DEFINE:
            return self._define()
        if word in OBJECT_WORDS:
            return self._object()
        if word in VARIABLE_WORDS:
            return self._declaration()
        if word in PARAMETER_WORDS:
            raise SourceError(at, f"{word} declares a parameter, which only a subcall has")
        if self._kinds[self._at] == "name" and self._texts[self._at + 1] in ("(", ":"):
            raise SourceError(at, f"{word[:40]} stands outside of any object: put it into a vmthread or a subcall")
        hint = suggestion(word, _KEYWORDS) if self._kinds[self._at] == "name" else ""
        raise SourceError(at, f"a declaration, a define or an object should start here, not {self._shown()}{hint}")

    def _object(self) -> ObjectSource:
        at = self._ats[self._at]
        kind = self._texts[self._at]
        self._at += 1
        name = self._name(f"the name of the {kind}")
        self._expect("{", f"after {kind} {name}")
        body: list[Statement] = []
        while self._texts[self._at] != "}" or self._kinds[self._at] != "mark":
            if self._kinds[self._at] == "end":
                if self.errors:  # What is wrong above may have taken the } with it.
                    break
                raise SourceError(at, f"{kind} {name} has no }} at its end")
            start = self._at
            try:
                body.append(self._statement())
            except SourceError as error:
                self._recover(error, start)
                if len(self.errors) >= MOST_ERRORS:
                    break
        self._at = min(self._at + 1, len(self._kinds) - 1)
        return ObjectSource(at, kind, name, body)

    def _define(self) -> DefineStatement:
        at = self._ats[self._at]
        self._at += 1
        name = self._name("the name to define")
        return DefineStatement(at, name, self._value())

    def _declaration(self) -> VariableStatement:
        word = self._texts[self._at]
        self._at += 1
        at = self._ats[self._at]
        name = self._name("the name of the variable")
        return VariableStatement(at, word, name, self._value() if word in _SIZED else None)

    # Statements

    def _statement(self) -> Statement:
        i = self._at
        kind, word, at = self._kinds[i], self._texts[i], self._ats[i]
        if kind == "name":
            following = self._texts[i + 1]
            if following == "(" and word not in _DECLARING:
                self._at = i + 2
                return OperationStatement(at, word, self._arguments(word))
            if following == ":":
                self._at = i + 2
                return LabelStatement(at, word)
            if word in _DECLARING:
                return self._declaration()
            if word == DEFINE:
                return self._define()
            if word in OBJECT_WORDS:
                raise SourceError(at, f"a {word} cannot stand in another object: a }} is missing in front of it")
            raise SourceError(at + len(word), f"a ( should stand after {word[:40]}, not {self._shown(i + 1)}")
        if kind == "raw":
            self._at = i + 1
            return _raw(at, word)
        raise SourceError(at, f"an operation, a label or a declaration should start here, not {self._shown()}")

    def _arguments(self, operation: str) -> tuple[Value, ...]:
        found: list[Value] = []
        kinds, texts, ats = self._kinds, self._texts, self._ats
        while True:
            i = self._at
            word = texts[i]
            if kinds[i] == "name" and word not in FORMS:
                found.append(Name(ats[i], word))
                self._at = i + 1
            elif kinds[i] != "mark":
                if kinds[i] == "end":
                    raise SourceError(ats[i], f"the ) of {operation} is missing")
                found.append(self._value())
            elif word == ")":
                self._at = i + 1
                return tuple(found)
            elif word == ",":
                self._at = i + 1
            elif word == "+" and found and texts[i - 1] != ",":
                found.append(self._more(found.pop()))
            elif word in "{}:":
                raise SourceError(ats[i], f"the ) of {operation} is missing in front of {word}")
            else:
                found.append(self._value())

    def _more(self, first: Value) -> Value:
        """A value and those that are added to it without parentheses around them: `A+B`."""
        values = [first]
        while self._texts[self._at] == "+" and self._kinds[self._at] == "mark":
            self._at += 1
            values.append(self._term())
        return Sum(first.at, tuple(values), ("+",) * (len(values) - 1))

    # Values

    def _value(self) -> Value:
        i = self._at
        kind, word, at = self._kinds[i], self._texts[i], self._ats[i]
        self._at = i + 1
        if kind == "name":
            if word in FORMS and self._texts[i + 1] == "(":
                return self._form(at, word)
            return Name(at, word)
        if kind == "number":
            return Number(at, self._number(at, word, 1))
        if kind == "float":
            return _float(at, word, 1)
        if kind == "text":
            return self._string(at, word)
        if kind == "quoted":
            return _quoted(at, word)
        if kind == "raw":
            return _raw(at, word)
        if kind == "mark":
            if word == "-":
                return self._negative(at)
            if word == "(":
                return self._sum(at)
            if word == "@":
                return MarkedName(at, word, Name(self._ats[self._at], self._name("the variable that holds a handle")))
            if word == "!":
                self._deeper(at)
                unchecked = Unchecked(at, self._value())
                self._depth -= 1
                return unchecked
        self._at = i
        raise SourceError(at, f"a value should stand here, not {self._shown()}")

    def _negative(self, at: int) -> Value:
        i = self._at
        kind, word = self._kinds[i], self._texts[i]
        self._at = i + 1
        if kind == "number":
            return Number(at, self._number(at, word, -1))
        if kind == "float":
            return _float(at, word, -1)
        self._at = i
        raise SourceError(at, "only a number can stand after a -; put an expression into parentheses")

    def _number(self, at: int, word: str, sign: int) -> int:
        if word[:2] in ("0x", "0X"):
            value = int(word, 16)
            if value >> 32:
                raise SourceError(at, f"{word[:40]} has more than 32 bits")
            return sign * value if sign > 0 else wrapped(-value)
        if word[0] == "0" and len(word) > 1:
            try:
                value = int(word, 8)
            except ValueError:
                raise SourceError(at, f"{word[:40]} is no number: a 0 in front makes it octal") from None
            self.warnings.append((at, f"{word[:40]} is octal, because of the 0 in front: {value}"))
        else:
            value = int(word) if len(word) < 20 else 1 << 63
        if not fits(sign * value):
            raise SourceError(at, f"{word[:40]} has more than 32 bits: the largest number is 2147483647")
        return sign * value

    def _string(self, at: int, word: str) -> Text:
        body = word[1:-1]
        if "\\" in body:
            unknown = next((it for it in _ESCAPED.finditer(body) if it["known"] is None), None)
            if unknown is not None:
                shown = body[unknown.start() : unknown.start() + 2]
                raise SourceError(
                    at + 1 + unknown.start(), rf"{shown} is no escape: there are \n, \r, \t, \q (the quote) and \\"
                )
            if re.search(r"\\\\[nqrt]", body):
                self.warnings.append(
                    (at, r"escapes are replaced kind after kind: of \\n stays a backslash with the line end after it")
                )
        return Text(at, strict_text(body, self._coding))

    def _form(self, at: int, name: str) -> EncodedValue:
        self._at += 1
        self._deeper(at)
        value = self._value()
        self._depth -= 1
        self._expect(")", f"after the value of {name}")
        return EncodedValue(at, name, value)

    def _sum(self, at: int) -> Value:
        """An expression, whose ( is read."""
        self._deeper(at)
        values = [self._term()]
        operators = []
        while self._kinds[self._at] == "mark" and self._texts[self._at] in "+-*/":
            operators.append(self._texts[self._at])
            self._at += 1
            values.append(self._term())
        self._expect(")", "at the end of the expression")
        self._depth -= 1
        return Sum(at, tuple(values), tuple(operators))

    def _term(self) -> Value:
        i = self._at
        kind, word, at = self._kinds[i], self._texts[i], self._ats[i]
        self._at = i + 1
        if kind == "number":
            return Number(at, self._number(at, word, 1))
        if kind == "name":
            return Name(at, word)
        if word == "(" and kind == "mark":
            return self._sum(at)
        self._at = i
        raise SourceError(at, f"a number or a name should stand in the expression, not {self._shown()}")

    def _deeper(self, at: int) -> None:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise SourceError(at, f"values are more than {MAX_DEPTH} deep in each other")

    # Helpers

    def _name(self, what: str) -> str:
        if self._kinds[self._at] != "name":
            raise SourceError(self._ats[self._at], f"{what} should stand here, not {self._shown()}")
        self._at += 1
        return self._texts[self._at - 1]

    def _expect(self, mark: str, where: str) -> None:
        if self._texts[self._at] != mark or self._kinds[self._at] != "mark":
            raise SourceError(self._ats[self._at], f"a {mark} should stand {where}, not {self._shown()}")
        self._at += 1

    def _shown(self, place: int | None = None) -> str:
        place = self._at if place is None else place
        return "the end of the source" if self._kinds[place] == "end" else self._texts[place][:40]


def _float(at: int, word: str, sign: int) -> Float:
    try:
        return Float(at, single_bits(sign * float(word[:-1])))
    except ValueError:
        raise SourceError(at, f"{word[:40]} is beyond 3.4028235e38, which is as far as a DATAF reaches") from None


def _raw(at: int, word: str) -> RawArgument:
    return RawArgument(at, bytes.fromhex(word[word.index("(") + 1 : -1]))


def _quoted(at: int, word: str) -> Text:
    try:
        body = json.loads(word)
    except ValueError:
        raise SourceError(at, r"a string in double quotes has the escapes of JSON: \n, \", \\, \u00e9") from None
    try:
        return Text(at, body.encode(STRING_CODING))
    except UnicodeEncodeError as error:
        raise SourceError(at, f"the brick's strings are ISO-8859-1, which has no {body[error.start]!r}") from None

"""LEGO's own dialect: a statement a line, words between blanks, and whatever its assembler let pass.

Parentheses and commas are blanks. Stray signs that it only complained about are an error here, but for the semicolon at
a line's end, which published sources have.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from ev3proto.program.source.errors import SourceError
from ev3proto.program.source.numbers import lego_text, pattern, single_bits
from ev3proto.program.source.statements import (
    DefineStatement,
    Float,
    Item,
    LabelStatement,
    MarkedName,
    Name,
    Number,
    ObjectSource,
    OperationStatement,
    Sum,
    Text,
    Value,
    VariableStatement,
)
from ev3proto.tables.source import (
    DEFINE,
    HANDLE_PARAMETERS,
    OBJECT_WORDS,
    OLD_WORDS,
    PARAMETER_WORDS,
    SIZED_PARAMETERS,
    SIZED_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.text.assembly.errors import MOST_ERRORS

_WORD = re.compile(
    r"""(?P<newline>\r\n|\r|\n)
      | (?P<blank>[ \t(),\f\v\x1a\ufeff]+ | //[^\r\n]*)
      | (?P<comment>/\*)
      | (?P<text>'(?>(?:''|\\\\|\\'|[^'\r\n])*)')
      | (?P<brace>[{}])
      | (?P<word>(?>(?:(?!//|/\*)[^\s(),'{}])+))""",
    re.VERBOSE,
)
_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_FLOAT = re.compile(r"[+-]?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE]\d++)?F", re.ASCII)
_HEX = re.compile(r"(?:0x|\$)([0-9A-Fa-f]+)")
_WHOLE = re.compile(r"([+-]?)(\d+)", re.ASCII)
_POINT = re.compile(r"([+-]?)(\d*)\.\d*", re.ASCII)
_OCTAL = re.compile(r"0[0-7]+")
_SUM = re.compile(r"[A-Za-z_]\w*(?:\+[A-Za-z_]\w*)+", re.ASCII)
_OPERATORS = frozenset("+-*/")
_BEYOND = 1 << 32
_CODE = re.compile(r"_.", re.DOTALL)
_SIZED = frozenset((*SIZED_WORDS, *SIZED_PARAMETERS, *OLD_WORDS))
_PARAMETERS = frozenset(PARAMETER_WORDS) - frozenset(HANDLE_PARAMETERS)
_DECLARING = frozenset((*VARIABLE_WORDS, *_PARAMETERS, *OLD_WORDS))
_OBJECTS = frozenset(OBJECT_WORDS) - {"block"}


class _Word(NamedTuple):
    """A word of a line: where it starts, what it is, what was written."""

    at: int
    is_text: bool
    text: str


class LegoParser:
    """Reads one source; attributes as those of `StrictParser`."""

    def __init__(self, text: str) -> None:
        self.items: list[Item] = []
        self.errors: list[SourceError] = []
        self.warnings: list[tuple[int, str]] = []
        self._text = text
        self._object: ObjectSource | None = None
        self._is_open = False
        for line in self._lines():
            try:
                self._line(line)
            except SourceError as error:
                self._keep(error)
            if len(self.errors) >= MOST_ERRORS:
                return
        if self._object is not None and not self.errors:
            name = f"{self._object.kind} {self._object.name}"
            self._keep(SourceError(self._object.at, f"{name} has no }} at its end"))

    def _keep(self, error: SourceError) -> None:
        self.errors.append(error)

    # Words

    def _lines(self) -> list[list[_Word]]:
        """The words of every statement; a line that ends in = goes on in the next."""
        text, size = self._text, len(self._text)
        lines: list[list[_Word]] = []
        words: list[_Word] = []
        at = 0
        while at < size:
            found = _WORD.match(text, at)
            kind = None if found is None else found.lastgroup
            if found is None:
                # An error only where somebody looks at it: after a label or a brace nobody does.
                end = re.compile(r"[\r\n]").search(text, at)
                words.append(_Word(at, False, text[at : end.start() if end else size]))
                at = end.start() if end else size
                continue
            if kind == "newline":
                words = self._ended(words, lines)
            elif kind == "comment":
                end_of_comment = text.find("*/", at + 2)
                if end_of_comment < 0:
                    self._keep(SourceError(at, "the comment that starts here has no */"))
                    break
                if re.search(r"[\r\n]", text[at:end_of_comment]):
                    words = self._ended(words, lines)
                at = end_of_comment + 2
                continue
            elif kind != "blank":
                words.append(_Word(at, kind == "text", found[0]))
            at = found.end()
        if words:
            lines.append(words)
        return lines

    def _ended(self, words: list[_Word], lines: list[list[_Word]]) -> list[_Word]:
        """The words that the next line goes on from, where the last one ends in =; else none."""
        if not words:
            return words
        last = words[-1]
        if not last.is_text and last.text.endswith("="):
            kept = words[:-1]
            return [*kept, last._replace(text=last.text[:-1])] if len(last.text) > 1 else kept
        if not last.is_text and last.text.endswith(";"):
            self.warnings.append((last.at + len(last.text) - 1, "a ; means nothing: it is omitted"))
            stripped = last.text.rstrip(";")
            words = [*words[:-1], last._replace(text=stripped)] if stripped else words[:-1]
        if words:
            lines.append(words)
        return []

    # Lines

    def _line(self, words: list[_Word]) -> None:
        first = words[0]
        word = "" if first.is_text else first.text
        if word == "{":
            if self._object is None or self._is_open:
                raise SourceError(first.at, "there is no vmthread or subcall that this { could begin")
            self._is_open = True
        elif word == "}":
            if self._object is None:
                raise SourceError(first.at, "there is no { that this } could end")
            self._object = None
        elif word.endswith(":") and _NAME.fullmatch(word[:-1]):
            if len(words) > 1:
                self.warnings.append((words[1].at, f"what stands after the label {word[:40]} on its line is omitted"))
            self._inside(first, "a label").body.append(LabelStatement(first.at, word[:-1]))
        elif word == DEFINE:
            self._define(words)
        elif word in _OBJECTS:
            self._begin(words)
        elif word in _DECLARING:
            self._declare(words)
        elif not _NAME.fullmatch(word):
            raise SourceError(
                first.at, f"an operation, a label or a declaration should start here, not {first.text[:40]}"
            )
        else:
            arguments = tuple(self._value(it) for it in words[1:])
            self._inside(first, "an operation").body.append(OperationStatement(first.at, word, arguments))

    def _inside(self, word: _Word, what: str) -> ObjectSource:
        if self._object is None:
            raise SourceError(word.at, f"{what} cannot stand outside of a vmthread or subcall")
        return self._object

    def _begin(self, words: list[_Word]) -> None:
        first = words[0]
        if self._object is not None:
            raise SourceError(
                first.at, f"a {first.text} cannot stand in another object: a }} is missing in front of it"
            )
        name = self._name(words, 1, f"the name of the {first.text}")
        self._object = ObjectSource(first.at, first.text, name, [])
        self._is_open = any(it.text == "{" and not it.is_text for it in words[2:])
        self.items.append(self._object)

    def _define(self, words: list[_Word]) -> None:
        name = self._name(words, 1, "the name to define")
        if self._object is not None:
            self.warnings.append((words[0].at, "a define inside an object is known in the whole file"))
        self.items.append(DefineStatement(words[1].at, name, self._expression(words, 2, f"what {name} stands for")))

    def _declare(self, words: list[_Word]) -> None:
        first = words[0]
        name = self._name(words, 1, "the name of the variable")
        size = self._expression(words, 2, f"the size of {name}") if first.text in _SIZED else None
        declaration = VariableStatement(words[1].at, first.text, name, size)
        if self._object is None or first.text == "global":
            self.items.append(declaration)
        else:
            self._object.body.append(declaration)

    def _name(self, words: list[_Word], place: int, what: str) -> str:
        if len(words) <= place:
            raise SourceError(words[-1].at, f"{what} should stand after {words[-1].text[:40]}")
        word = words[place]
        if word.is_text or not _NAME.fullmatch(word.text):
            raise SourceError(word.at, f"{what} should stand here, not {word.text[:40]}")
        return word.text

    # Values

    def _expression(self, words: list[_Word], start: int, what: str) -> Value:
        """The value of a define or a size: one, or some with operators between them."""
        if len(words) <= start:
            raise SourceError(words[-1].at, f"{what} is missing")
        values = [self._value(words[start])]
        operators = []
        for operator, operand in zip(words[start + 1 :: 2], words[start + 2 :: 2], strict=False):
            if operator.text not in _OPERATORS or operator.is_text:
                raise SourceError(operator.at, f"an operator should stand here, not {operator.text[:40]}")
            operators.append(operator.text)
            values.append(self._value(operand))
        if len(words) - start != len(values) + len(operators):
            raise SourceError(words[-1].at, f"nothing can stand after {what}, and here is {words[-1].text[:40]}")
        return values[0] if not operators else Sum(words[start].at, tuple(values), tuple(operators), is_usual=True)

    def _value(self, word: _Word) -> Value:
        at, text = word.at, word.text
        if text.startswith("'") and not word.is_text:
            raise SourceError(at, "the string that starts here has no ' at its end")
        if word.is_text:
            body = text[1:-1]
            return Number(at, ord(body[1]) & 0xFF) if _CODE.fullmatch(body) else Text(at, lego_text(body))
        if _NAME.fullmatch(text):
            return Name(at, text)
        if text[0] in "@&" and _NAME.fullmatch(text, 1):
            return MarkedName(at, text[0], Name(at + 1, text[1:]))
        if _SUM.fullmatch(text):
            return _sum(at, text)
        number = self._number(at, text)
        if number is None:
            raise SourceError(at, f"{text[:40]} is no number, no name and no string")
        return number

    def _number(self, at: int, text: str) -> Value | None:
        found = _HEX.fullmatch(text)
        if found:
            _refuse_long(at, text, found[1])
            return Number(at, self._cut(at, text, int(found[1], 16)))
        if _FLOAT.fullmatch(text):
            try:
                return Float(at, single_bits(float(text[:-1])))
            except ValueError:
                raise SourceError(
                    at, f"{text[:40]} is beyond 3.4028235e38, which is as far as a DATAF reaches"
                ) from None
        if _OCTAL.fullmatch(text):
            _refuse_long(at, text, text)
            value = int(text, 8)
            self.warnings.append((at, f"{text[:40]} is octal, because of the 0 in front: {value}"))
            return Number(at, pattern(value))
        found = _WHOLE.fullmatch(text) or _POINT.fullmatch(text)
        if found is None or text in ("+.", "-.", "."):
            return None
        if "." in text and text[-1] != ".":
            self.warnings.append((at, f"{text[:40]} is a whole number here: a float ends in F"))
        _refuse_long(at, text, found[2])
        value = int(found[2] or "0")
        return Number(at, self._cut(at, text, -value if found[1] == "-" else value))

    def _cut(self, at: int, text: str, value: int) -> int:
        """The lowest 32 bits of a number that was written."""
        if not -_BEYOND // 2 <= value < _BEYOND:
            self.warnings.append((at, f"{text[:40]} has more than 32 bits, and only the lowest 32 are taken"))
        return pattern(value)


def _sum(at: int, text: str) -> Sum:
    """Names with nothing but plus signs between them: `A+B`."""
    names = text.split("+")
    return Sum(at, tuple(Name(at, name) for name in names), ("+",) * (len(names) - 1), is_usual=True)


_MOST_DIGITS = 40


def _refuse_long(at: int, text: str, digits: str) -> None:
    if len(digits) > _MOST_DIGITS:
        raise SourceError(at, f"{text[:40]}... has more digits than any number needs")

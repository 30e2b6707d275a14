"""The grammar: tokens to statements, in one of four notations. Names are resolved later.

Written by hand: the end of a macro operation depends on what follows its last comma, bytes are hex without quotes,
and to LEGO's assembler a line is a list of words. A parser generator does not fit any of these, and its errors would
need translating.
"""

from __future__ import annotations

import re
import struct
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import ClassVar

from ev3proto.errors import near_misses
from ev3proto.tables.source import (
    BYTES,
    DEFINE,
    OBJECT_WORDS,
    OLD_WORDS,
    PARAMETER_WORDS,
    SIZED_PARAMETERS,
    SIZED_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.text.assembly.errors import SourceError, cited
from ev3proto.text.assembly.lexing import BAD, END, MARK, NAME, NUMBER, TEXT, WORD, Lexeme, text_of, tokens
from ev3proto.text.assembly.notations import CUT, FORMS, FRAME, MARKS, MESSAGE, TEMPLATES, Notation
from ev3proto.text.assembly.syntax import (
    Call,
    Closing,
    Define,
    Distance,
    Element,
    Label,
    Marked,
    MessageHeader,
    Name,
    NamedEncoding,
    Number,
    Opening,
    Pattern,
    Raw,
    RawFrame,
    Statement,
    Sum,
    Text,
    Unchecked,
    Value,
    VariableDeclaration,
    WrittenArgument,
)

MAX_DEPTH = 50
"""Maximum nesting depth of values."""

MAX_PARTS = 1 << 16
"""Maximum number of values of an operation, or parts of an expression: more than any frame has bytes."""

MAX_DIGITS = 64
"""Maximum number of characters of a number."""

_SIZED = frozenset((*SIZED_WORDS, *SIZED_PARAMETERS))
_AS_VARIABLE = {"8": "DATA8", "16": "DATA16", "32": "DATA32", "F": "DATAF", "S": "DATAS", "H": "HANDLE"}
"""By the suffix of the word that declares a parameter: the word for a variable of that type."""

_OPERATION = re.compile(r"op[A-Z_]\w*", re.ASCII)
_HEX = re.compile(r"(?:0[xX])?(?:[0-9a-fA-F]{2})+", re.ASCII)


def is_operation_word(name: str) -> bool:
    """Returns whether a name is an operation in the macro notation: `opSOUND`."""
    return _OPERATION.match(name) is not None


class Parser:
    """A recursive-descent parser with two tokens of lookahead."""

    def __init__(self, text: str, notation: Notation, coding: str = "latin-1") -> None:
        self.notation = notation
        self.warnings: list[tuple[int, str]] = []  # (offset, message) of valid but probably unintended code
        self._coding = coding
        self._tokens = tokens(text, notation)
        self._ahead: deque[Lexeme] = deque()
        self._depth = 0
        self._last = Lexeme(END, "", 0, True)
        self._heads = {word.upper() if notation.folds else word: word for word in notation.heads}

    def statements(self) -> Iterator[Statement | SourceError]:
        """Yields the statements of the text, and errors; after an error, parsing resumes at the next line."""
        while not self._is_at_end():
            start = self._peek()
            try:
                yield from self._statement()
            except SourceError as error:
                yield error
                self._depth = 0
                if self._peek() is start:
                    self._next()
                self._skip_line()

    def _is_at_end(self) -> bool:
        """Returns whether no statement follows. In frames, marks between statements are skipped."""
        while self.notation.has_messages and self._skips(",", ";"):
            pass
        return self._peek().kind == END

    def _skip_line(self) -> None:
        while not self._peek().is_first:
            self._next()

    def _statement(self) -> Iterator[Statement]:
        """Parses one statement, or several heads."""
        token, following, by_line = self._peek(), self._peek(1), self.notation.by_line
        if self._skips("}"):
            yield Closing(token.at)
            self._omit_rest("}")
        elif token.kind != NAME:
            yield self._directive(token)
        elif following.is_mark(":") and (not by_line or following.at == token.end):
            self._next()
            self._next()
            self._check_blank(token)
            yield Label(token.at, token.text)
            self._omit_rest(f"the label {cited(token.text)}")
        elif token.text in self._heads and not following.is_mark("("):
            yield from self._head()
        elif by_line:
            yield from self._line()
        else:
            yield self._between_marks(token)

    def _directive(self, token: Lexeme) -> Define:
        """Parses #define, the only statement that does not start with a name."""
        if token.is_mark("{") and self.notation.by_line:
            raise SourceError(token.at, "unexpected {: a vmthread or subcall has to precede it")
        if not token.is_mark("#"):
            raise self._unexpected(
                "an operation such as SOUND(TONE, 1, 440, 1000)"
                if self.notation.has_messages
                else "an operation, a label or a declaration"
            )
        self._next()
        if self._peek().text != DEFINE:
            raise SourceError(token.at, "unknown directive; of the lines that start with # there is only #define")
        return self._define()

    # Statements between marks

    def _between_marks(self, token: Lexeme) -> Statement:
        word, has_messages = token.text, self.notation.has_messages
        if word in self.notation.declaring or (has_messages and word in OLD_WORDS):
            return self._declaration()
        if word == DEFINE:
            return self._define()
        if word == BYTES:
            self._next()
            return self._raw(token) if self._peek().is_mark("(") else Raw(token.at, self._hex(until_mark=False))
        if self._peek(1).is_mark("("):
            return self._call()
        if has_messages:
            return self._of_message(token)
        raise SourceError(token.end, f"expected ( after {cited(word)}, found {self._shown(self._peek(1))}")

    def _of_message(self, token: Lexeme) -> Statement:
        """Parses a statement that only frames have."""
        word = token.text
        if word == MESSAGE:
            return self._header()
        if word == FRAME:
            self._next()
            return RawFrame(token.at)
        if word in OBJECT_WORDS or word in PARAMETER_WORDS:
            declared = _AS_VARIABLE.get(word.partition("_")[2])
            hint = f"; {declared} declares a variable" if declared is not None else ""
            raise SourceError(token.at, f"a direct command has no subroutines: it is one piece, as a vmthread is{hint}")
        return self._macro_operation() if is_operation_word(word) else self._bare()

    def _header(self) -> MessageHeader:
        at = self._next().at
        kind = self._taken_name() if self._is_name_here() and self._peek().text.isupper() else None
        facts: list[tuple[Name, Number | Name]] = []
        while not self._peek().is_first:
            name = self._expect_name("counter, globals, locals or length")
            value = self._peek()
            if value.is_first or value.kind not in (NUMBER, NAME):
                raise self._line_end(f"the value of {name.text}")
            facts.append((name, self._number() if value.kind == NUMBER else self._taken_name()))
        return MessageHeader(at, kind, tuple(facts))

    def _define(self) -> Define:
        self._next()
        name = self._expect_name("the name to define")
        if self._peek().is_first and (self.notation.by_line or self.notation.has_messages):
            raise self._line_end(f"the value of {name.text}")
        return Define(name.at, name.text, self._value())

    def _head(self) -> Iterator[Statement]:
        """Parses the head of an object, or several heads in a row for the same code."""
        notation = self.notation
        opening: Opening | None = None
        while opening is None or (self._peek().text in self._heads and self._peek().kind == NAME):
            at = self._peek().at
            word = self._heads[self._next().text]
            name = self._expect_name(f"the name of the {word}", is_same_line=notation.by_line).text
            opening = Opening(at, word, name, is_alias=opening is not None)
            yield opening
            if notation.by_line:
                found = False
                while not self._peek().is_first:
                    found |= self._next().is_mark("{")
                if found:
                    return
        if not notation.by_line:
            self._expect("{", f"{{ after {opening.word} {cited(opening.name)}")
        elif self._skips("{"):
            self._skip_line()

    def _declaration(self) -> VariableDeclaration:
        notation = self.notation
        scope = None
        if notation.has_messages and self._peek().text in OLD_WORDS:
            scope = self._next().text
        kind = self._peek()
        if kind.kind != NAME or kind.text not in self.notation.declaring:
            raise self._line_end(f"a type ({', '.join(VARIABLE_WORDS)})")
        self._next()
        name = self._expect_name("the name of the variable", is_same_line=notation.by_line or notation.has_messages)
        is_old = notation.last_counts and kind.text in OLD_WORDS
        is_sized = is_old or kind.text in _SIZED
        size = self._size() if is_sized or notation.has_messages else None
        if size is None and is_sized:
            raise self._line_end(f"the number of elements of {name.text}")
        return VariableDeclaration(name.at, kind.text, name.text, size, kind.text if is_old else scope)

    def _size(self) -> Value | None:
        """Parses the number of elements after the name of a variable, `name[3]` or `name 3`, if there is one."""
        following, has_messages = self._peek(), self.notation.has_messages
        if has_messages and following.is_mark("["):
            return self._element(Name(following.at, "")).number
        is_here = not following.is_first or not (self.notation.by_line or has_messages)
        return self._value() if is_here and not following.is_mark(",", ";", "}") else None

    def _call(self) -> Call:
        """Parses `NAME(value, value)`. In frames the ) may be missing at the end of a line; doubled commas are one."""
        token, notation = self._next(), self.notation
        self._expect("(")
        arguments: list[WrittenArgument] = []
        while not self._peek().is_mark(")", CUT):
            if self._skips(","):
                continue
            if self._peek().is_mark("{", "}", ":") or (self._peek().kind == END and not notation.has_messages):
                raise SourceError(self._peek().at, f"the ) of {cited(token.text)} is missing")
            arguments.append(self._argument(arguments))
            if notation.has_messages and not self._peek().is_mark(")", ","):
                if self._ends_without_mark():
                    return Call(token.at, token.text, tuple(arguments), self._peek().at)
                raise self._unexpected(", or )")
            self._skips(",")
        is_complete = not self._skips(CUT)
        return Call(token.at, token.text, tuple(arguments), self._expect(")").at, is_complete)

    def _ends_without_mark(self) -> bool:
        """Returns whether the line ends here, and the next statement could follow."""
        token = self._peek()
        return token.is_first and (token.kind in (NAME, END) or token.is_mark("}", "#"))

    def _macro_operation(self) -> Call:
        """Parses `opNAME, value, value`, which continues on the next line after a comma."""
        token = self._next()
        arguments: list[WrittenArgument] = []
        while self._skips(","):
            if self._peek().is_mark(CUT) or self._starts_statement():
                break
            arguments.append(self._argument(arguments))
        is_complete = not self._skips(CUT)
        end = self._peek()
        if not end.is_first and not end.is_mark(";", "}") and not self._starts_statement():
            raise self._unexpected("a comma" if is_complete else "the end of the line")
        return Call(token.at, token.text, tuple(arguments), end.at, is_complete)

    def _bare(self) -> Call:
        """Parses an operation without values: its name."""
        token = self._next()
        following = self._peek()
        if not following.is_first and not following.is_mark(",", ";", "}"):
            raise self._unexpected(f"(, as in {token.text}(...)")
        return Call(token.at, token.text, (), following.at)

    def _starts_statement(self) -> bool:
        """Returns whether a statement starts here, after the comma of a macro operation."""
        token, following = self._peek(), self._peek(1)
        if token.kind == END or token.is_mark("}", "#"):
            return True
        if token.kind != NAME:
            return False
        if is_operation_word(token.text) or following.is_mark(":"):
            return True
        if not token.is_first:
            return False
        if following.is_mark("("):
            return token.text not in (*FORMS, *MARKS, BYTES)
        return token.text in (MESSAGE, FRAME, BYTES, DEFINE, "vmthread", *OLD_WORDS, *VARIABLE_WORDS)

    # Lines

    def _line(self) -> Iterator[Statement]:
        """Parses a line of a notation that separates words by blanks, other than a label or a head."""
        word, notation = self._peek().text, self.notation
        if notation.folds and word in TEMPLATES:
            self._template()
            return
        if word == DEFINE and notation.last_counts:
            yield self._define()
        elif word in notation.declaring:
            declaration = self._declaration()
            self._check_blank(self._last)
            yield declaration
            if notation.last_counts and declaration.size is None:
                self._omit_rest(cited(declaration.name))
        else:
            yield self._words()
        if self._peek().is_mark(";"):
            self.warnings.append((self._next().at, "a ; means nothing: it is omitted"))
        if not self._peek().is_first:
            raise self._unexpected("the end of the line")

    def _words(self) -> Call:
        """Parses an operation and its arguments, to the end of the line."""
        token = self._next()
        arguments: list[WrittenArgument] = []
        self._check_blank(token)
        while not self._peek().is_first and not self._peek().is_mark(";"):
            start = self._peek()
            arguments.append(WrittenArgument(None, self._word()))
            self._check_blank(start)
        return Call(token.at, token.text, tuple(arguments), self._last.end)

    def _check_blank(self, start: Lexeme) -> None:
        """Raises SourceError if a word continues after the part that was parsed, where blanks separate words."""
        if not self.notation.by_line:
            return
        following = self._peek()
        is_glued = not following.is_first and following.at == self._last.end and following.kind != TEXT
        if is_glued and self._last.kind != TEXT and not following.is_mark(";", "}"):
            shown = cited(f"{start.text}{following.text}")
            raise SourceError(start.at, f"expected a number, a name or a text, found {shown}")

    def _omit_rest(self, after: str) -> None:
        """Skips the rest of a line, which assemblers that read by lines ignore."""
        if not self.notation.by_line:
            return
        if not self._peek().is_first:
            self.warnings.append((self._peek().at, f"what follows {after} on its line is omitted"))
        while not self._peek().is_first:
            if self._next().text.startswith("the comment"):
                raise SourceError(self._last.at, self._last.text)

    def _template(self) -> None:
        """Skips a template of EV3 Basic's compiler, which becomes no object."""
        token = self._next()
        self.warnings.append((token.at, f"{token.text.lower()} is a template of the compiler: it is omitted"))
        while self._peek().kind != END and not self._peek().is_mark("}"):
            self._next()
        self._next()

    def _word(self) -> Value:
        """Parses a single value: a number with its sign, a name, a text, or names joined by signs without blanks."""
        token = self._peek()
        if token.is_first:
            raise self._line_end("a value")
        if token.is_mark("-", "+") and self._peek(1).kind == NUMBER and self._peek(1).at == token.end:
            self._next()
            return self._number(-1 if token.text == "-" else 1, token.at)
        if token.is_mark("@", "&") and self._peek(1).kind == NAME and self._peek(1).at == token.end:
            self._next()
            return Marked(token.at, token.text, self._taken_name())
        if token.kind != NAME:
            return self._plain()
        return self._from_name(self._taken_name())

    def _from_name(self, name: Name) -> Value:
        """Parses what follows a name without blanks: `x+3`, `a:b`, `A+B`."""
        if self._is_glued("+") and self._peek(1).kind == NUMBER:
            self._next()
            number = self._number()
            if not isinstance(number.value, int):
                raise SourceError(number.at, f"expected a number of bytes after {cited(name.text)}+")
            return Element(name.at, name.text, number, is_byte=True)
        if self._is_glued(":") and self._peek(1).kind == NAME:
            self._next()
            return Distance(name.at, name.text, self._next().text)
        return self._joined(name)

    def _joined(self, first: Value) -> Value:
        """Parses the rest of a sum without parentheses: `A+B`."""
        values: list[Value] = [first]
        operators: list[tuple[int, str]] = []
        while self._peek().is_mark("+") and self._peek(1).kind in (NAME, NUMBER):
            if self.notation.by_line and not self._is_glued("+"):
                break
            operators.append((self._next().at, "+"))
            values.append(self._plain())
        return Sum(first.at, tuple(values), tuple(operators)) if operators else first

    def _is_glued(self, mark: str) -> bool:
        """Returns whether a mark follows without blanks around it."""
        token = self._peek()
        return token.is_mark(mark) and token.at == self._last.end and self._peek(1).at == token.end

    # Values

    def _argument(self, before: list[WrittenArgument]) -> WrittenArgument:
        if len(before) >= MAX_PARTS:
            raise SourceError(self._peek().at, f"more than {MAX_PARTS} values")
        if self._peek().kind == NAME and self._peek(1).is_mark("="):
            name = self._taken_name()
            self._next()
            return WrittenArgument(name, self._value())
        value = self._value()
        if not self.notation.has_messages and isinstance(value, Name):
            value = self._joined(value)
        return WrittenArgument(None, value)

    def _value(self) -> Value:
        """Parses a value: an expression if the notation has them outside of parentheses."""
        if self.notation.by_line:
            return self._chain("+-*/", self._word) if self.notation.last_counts else self._word()
        return self._expression() if self.notation.has_messages else self._factor()

    def _expression(self) -> Value:
        """Parses values with operators between them, in their order."""
        with self._deeper(self._peek()):
            return self._chain("+-*/|" if self.notation.has_messages else "+-*/", self._factor)

    def _chain(self, marks: str, part: Callable[[], Value]) -> Value:
        at = self._peek().at
        values = [part()]
        operators: list[tuple[int, str]] = []
        while self._peek().is_mark(*marks) and not (self.notation.by_line and self._peek().is_first):
            if len(values) >= MAX_PARTS:
                raise SourceError(self._peek().at, f"the expression has more than {MAX_PARTS} parts")
            operators.append((self._peek().at, self._next().text))
            values.append(part())
        return Sum(at, tuple(values), tuple(operators)) if operators else values[0]

    def _factor(self) -> Value:
        token = self._peek()
        if token.kind == MARK and token.text in self._FACTORS:
            return self._FACTORS[token.text](self, token)
        return self._named() if token.kind == NAME else self._plain()

    def _signed(self, token: Lexeme) -> Value:
        is_minus, is_frame = token.text == "-", self.notation.has_messages
        if not is_minus and not is_frame:
            raise self._unexpected("a value")
        self._next()
        if self._peek().kind == NUMBER:
            return self._number(-1 if is_minus else 1, token.at)
        if not is_frame:
            raise SourceError(token.at, "only a number can follow a -; put an expression into parentheses")
        with self._deeper(token):
            part = self._factor()
        return Sum(token.at, (Number(token.at, 0), part), ((token.at, "-"),)) if is_minus else part

    def _parenthesized(self, token: Lexeme) -> Value:
        self._next()
        inner, is_frame = self._expression(), self.notation.has_messages
        if is_frame and not isinstance(inner, Number | Text | Name | Sum):
            raise SourceError(inner.at, "expected a number or a name in parentheses")
        self._expect(")")
        return inner if is_frame or isinstance(inner, Sum) else Sum(token.at, (inner,), ())

    def _dereferenced(self, token: Lexeme) -> Value:
        if token.text == "&" and not self.notation.has_messages:
            raise self._unexpected("a value")
        self._next()
        name = self._expect_name("the name of a variable", is_same_line=False)
        return Marked(token.at, token.text, self._element(name) if self._peek().is_mark("[") else name)

    def _unchecked(self, token: Lexeme) -> Value:
        self._next()
        with self._deeper(token):
            return Unchecked(token.at, self._factor())

    _FACTORS: ClassVar = {
        "-": _signed,
        "+": _signed,
        "(": _parenthesized,
        "@": _dereferenced,
        "&": _dereferenced,
        "!": _unchecked,
    }
    """What parses a value by the mark that it begins with."""

    def _plain(self) -> Value:
        """Parses a number, a text or a name."""
        token = self._peek()
        if token.kind == NUMBER:
            return self._number()
        if token.kind == NAME:
            return self._taken_name()
        if token.kind != TEXT:
            raise self._unexpected("a value")
        text = text_of(token, self.notation, self._coding, self.warnings)
        self._next()
        if self.notation.last_counts and token.text.startswith("'_") and len(text) == 2:
            return Number(token.at, ord(text[1]) & 0xFF)
        return Text(token.at, text)

    def _named(self) -> Value:
        """Parses a value that starts with a name."""
        token, following = self._peek(), self._peek(1)
        if following.is_mark("["):
            return self._element(self._taken_name())
        if following.is_mark("(") and token.text == BYTES:
            self._next()
            return self._raw(token)
        if following.is_mark("(") and token.text in (*FORMS, *MARKS):
            self._next()
            self._next()
            with self._deeper(token):
                value = self._value()
            self._expect(")")
            return NamedEncoding(token.at, token.text, value)
        if following.is_mark("(") and self.notation.has_messages:
            known = ", ".join((*FORMS, *MARKS))
            raise SourceError(token.at, f"unknown macro {cited(token.text)}: there are {known} and {BYTES}(01 FF)")
        if token.text == "LCS" and following.is_mark(","):
            return self._spelled_text()
        return self._taken_name()

    def _element(self, name: Name) -> Element:
        self._expect("[")
        index = self._value()
        self._expect("]")
        return Element(name.at, name.text, index)

    def _raw(self, token: Lexeme) -> Raw:
        self._expect("(")
        data = self._hex(until_mark=True)
        self._expect(")")
        return Raw(token.at, data)

    def _spelled_text(self) -> NamedEncoding:
        """Parses `LCS, 'L','E','G','O', 0`, which is how C writes a text."""
        token = self._next()
        letters: list[str] = []
        while True:
            self._expect(",")
            letter = self._peek()
            if letter.kind == NUMBER and letter.text in ("0", "0x00"):
                self._next()
                break
            body = text_of(letter, self.notation, self._coding, self.warnings) if letter.kind == TEXT else ""
            if len(body) != 1:
                raise self._unexpected("a letter such as 'L', or the 0 that ends the text")
            letters.append(body)
            self._next()
        return NamedEncoding(token.at, token.text, Text(token.at, "".join(letters)))

    def _number(self, sign: int = 1, at: int | None = None) -> Number:
        """Parses a number; `at` is the place of its sign."""
        token, is_frame = self._next(), self.notation.has_messages
        text, at = token.text, token.at if at is None else at
        if len(text) > MAX_DIGITS:
            limit = f"a number has at most {MAX_DIGITS} characters"
            raise SourceError(at, limit if is_frame else f"{cited(text)} has more than 32 bits")
        prefix = text[:2].lower()
        if text[0] == "$" or prefix in ("0x", "0b"):
            value = int(text, 2) if prefix == "0b" else int(text.lstrip("$"), 16)
            return Number(at, self._pattern(at, text, sign, value))
        if not text.isdigit():
            return Number(at, self._real(at, text, sign))
        value = int(text) if text[0] != "0" else self._with_zero(at, text)
        return Number(at, sign * value if is_frame else self._in_32_bits(at, text, sign * value, 1 << 31))

    def _pattern(self, at: int, text: str, sign: int, value: int) -> int:
        """Returns a number that was written as its bits; 0xFF may be -1 in a frame."""
        if not self.notation.has_messages:
            return self._in_32_bits(at, text, sign * value, 1 << 32)
        return Pattern(value) if sign > 0 else -value

    def _in_32_bits(self, at: int, text: str, value: int, end: int) -> int:
        """Returns a number of a program. LEGO's assembler cuts a longer one to 32 bits; else it is refused."""
        if not self.notation.last_counts and not -1 << 31 <= value < end:
            raise SourceError(at, f"{cited(text)} has more than 32 bits: the largest number is 2147483647")
        if not -1 << 31 <= value < 1 << 32:
            self.warnings.append((at, f"{cited(text)} has more than 32 bits, and only the lowest 32 are taken"))
        return value % (1 << 32) if value >= 0 else (value + (1 << 31)) % (1 << 32) - (1 << 31)

    def _real(self, at: int, text: str, sign: int) -> int | float:
        """Parses a number with a point, an exponent or an F. Without F it is a float only in frames and EV3 Basic."""
        notation = self.notation
        if text[-1] not in "fF" and not (notation.has_messages or notation.folds):
            if not notation.last_counts or "e" in text.lower():
                raise SourceError(at, f"{cited(text)} is not a whole number, and floats end in F")
            if text[-1] != ".":
                self.warnings.append((at, f"{cited(text)} is a whole number here: a float ends in F"))
            return self._in_32_bits(at, text, sign * int(text.partition(".")[0] or "0"), 1 << 31)
        value = sign * float(text.rstrip("fF"))
        try:
            struct.pack("<f", value)
        except OverflowError:
            if not notation.has_messages:
                raise SourceError(at, f"{cited(text)} is beyond 3.4028235e38, the largest DATAF") from None
        return value

    def _with_zero(self, at: int, text: str) -> int:
        """Parses a number that starts with 0: octal in programs if its digits are, an error in frames."""
        digits = text.lstrip("0") or "0"
        if len(digits) < 2 and digits not in ("8", "9"):
            return int(digits)
        if self.notation.has_messages:
            raise SourceError(at, f"{text} is octal in C and decimal to most readers: write it as 0x..")
        if set(digits) & {"8", "9"}:
            return int(digits)
        self.warnings.append((at, f"{cited(text)} is octal, because of the 0 in front: {int(digits, 8)}"))
        return int(digits, 8)

    def _hex(self, *, until_mark: bool) -> bytes:
        """Parses bytes in hex, to the end of the line or to the next mark."""
        data = bytearray()
        while until_mark or not self._peek().is_first:
            found = self._peek()
            if until_mark and found.is_mark(")"):
                break
            if self._skips(":", "|"):
                continue
            if found.kind not in (NUMBER, NAME, WORD) or not _HEX.fullmatch(found.text):
                raise self._unexpected("bytes in hex, two digits each")
            data += bytes.fromhex(self._next().text.removeprefix("0x").removeprefix("0X"))
        return bytes(data)

    # Tokens

    def _peek(self, count: int = 0) -> Lexeme:
        ahead = self._ahead
        if len(ahead) > count:
            return ahead[count]
        while len(ahead) <= count and not (ahead and ahead[-1].kind == END):
            ahead.append(next(self._tokens))
        return ahead[-1]

    def _next(self) -> Lexeme:
        token = self._peek()
        if token.kind != END:
            self._ahead.popleft()
        self._last = token
        return token

    def _skips(self, *marks: str) -> bool:
        """Skips a mark if it is one of these, and returns whether it is."""
        is_there = self._peek().is_mark(*marks)
        if is_there:
            self._next()
        return is_there

    def _taken_name(self) -> Name:
        token = self._next()
        return Name(token.at, token.text)

    def _is_name_here(self, *, is_same_line: bool = True) -> bool:
        token = self._peek()
        return token.kind == NAME and not (is_same_line and token.is_first)

    def _expect_name(self, what: str, *, is_same_line: bool = True) -> Name:
        if not self._is_name_here(is_same_line=is_same_line):
            raise self._line_end(what) if is_same_line else self._unexpected(what)
        return self._taken_name()

    def _expect(self, mark: str, what: str | None = None) -> Lexeme:
        if not self._peek().is_mark(mark):
            raise self._unexpected(what or mark)
        return self._next()

    @contextmanager
    def _deeper(self, token: Lexeme) -> Iterator[None]:
        """Counts one level of nesting within the context."""
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise SourceError(token.at, f"values are nested more than {MAX_DEPTH} deep")
        yield
        self._depth -= 1

    def _line_end(self, expected: str) -> SourceError:
        """Returns the error for something that is missing on the line."""
        if self._peek().kind != END and not self._peek().is_first:
            return self._unexpected(expected)
        return SourceError(self._last.end, f"expected {expected}, found the end of the line")

    def _unexpected(self, expected: str) -> SourceError:
        token = self._peek()
        if token.kind == BAD:
            return SourceError(token.at, token.text)
        hint = near_misses(token.text, (*self._heads, *self.notation.declaring)) if token.kind == NAME else ""
        return SourceError(token.at, f"expected {expected}, found {self._shown(token)}{hint}")

    @staticmethod
    def _shown(token: Lexeme) -> str:
        return "the end of the text" if token.kind == END else cited(token.text)

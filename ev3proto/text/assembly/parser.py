"""The grammar: tokens to statements. What names mean is no matter here, only what can stand where.

A parser of its own: where an operation of the macro notation ends depends on what follows its last comma, and bytes are
written in hex without quotes. Both would need a tool's grammar to be bent, and its errors to be translated back.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ev3proto.tables.declaration import Type
from ev3proto.text.assembly.errors import AssemblyError
from ev3proto.text.assembly.lexing import ESCAPES, Token, TokenKind, tokens, unescaped
from ev3proto.text.assembly.words import BYTES, CUT, FRAME, MESSAGE
from ev3proto.text.late_pattern import late_pattern

MAX_DEPTH = 50
"""How deep expressions may stand in each other."""

MAX_PARTS = 1 << 16
"""Values of one operation, parts of one expression: more than any frame has bytes."""

MAX_BYTES = 1 << 16
"""Bytes that one statement can say: more than any length field does."""

MAX_NUMBER = 40
"""Characters of a number."""

TYPES = {
    **{kind.label: kind for kind in (Type.DATA8, Type.DATA16, Type.DATA32, Type.DATAF)},
    "DATAS": Type.DATA8,
    "ARRAY8": Type.DATA8,
    "ARRAY16": Type.DATA16,
    "ARRAY32": Type.DATA32,
    "ARRAYF": Type.DATAF,
    "HANDLE": Type.HANDLE,
}
"""The words that declare variables, as LEGO's sources have them, and the type of one element."""

SIZED = ("DATAS", "ARRAY8", "ARRAY16", "ARRAY32", "ARRAYF")
"""Those that need a size."""

FORMS = (
    *("LC0", "LC1", "LC2", "LC4", "LCX", "LCF", "LCS", "LCS_OLD", "LAB1"),
    *("LV0", "LV1", "LV2", "LV4", "LVX", "LV", "GV0", "GV1", "GV2", "GV4", "GVX", "GV"),
)
"""The macros that fix how a value is encoded."""

SHORTEST = ("LCX", "LVX", "LV", "GVX", "GV")
"""Those of them that leave it to us."""

MARKS = ("HND", "ADR")
"""The macros that set a bit of what they stand around."""

GLOBAL_WORD, LOCAL_WORD = "global", "local"
_SUBROUTINES = ("subcall", "IN_", "OUT_", "IO_")
_DECLARED_AS = {"8": "DATA8", "16": "DATA16", "32": "DATA32", "F": "DATAF", "S": "DATAS", "H": "HANDLE"}
"""By the end of the word that declares a subroutine's parameter: the word for a variable of that type."""


# Values


@dataclass(frozen=True, slots=True)
class Literal:
    """A number or a text as it was written."""

    token: Token


@dataclass(frozen=True, slots=True)
class Named:
    """A name: a constant, a variable, a label, a CMD."""

    token: Token


@dataclass(frozen=True, slots=True)
class Negative:
    """A value with a minus sign in front of it."""

    token: Token
    part: Expression


@dataclass(frozen=True, slots=True)
class Chain:
    """Values joined by operators of the same rank, worked out from left to right."""

    token: Token
    first: Expression
    rest: tuple[tuple[Token, Expression], ...]


Expression = Literal | Named | Negative | Chain


@dataclass(frozen=True, slots=True)
class Element:
    """`name[3]`: one element of a variable."""

    token: Token
    index: Expression


@dataclass(frozen=True, slots=True)
class Marked:
    """`@name`: the memory object that a variable is a handle to; `&name`: what is at the address in it."""

    token: Token
    part: Named | Element


@dataclass(frozen=True, slots=True)
class Macro:
    """`LC2(440)`, `HND(LV1(4))`."""

    token: Token
    part: Value


@dataclass(frozen=True, slots=True)
class Raw:
    """`bytes(A3 05)`: bytes as they are."""

    token: Token
    data: bytes


Value = Expression | Element | Marked | Macro | Raw


@dataclass(frozen=True, slots=True)
class WrittenArgument:
    """A value, and the name in front of it where it has one: `max_bytes=1000`."""

    name: Token | None
    value: Value

    @property
    def token(self) -> Token:
        """Where it starts."""
        return self.name or self.value.token


# Statements


@dataclass(frozen=True, slots=True)
class Header:
    """`message TYPE counter 42 globals 4`: what follows is a message of its own. Without a type: a direct command."""

    token: Token
    type: Token | None
    facts: tuple[tuple[Token, Literal | Named], ...]


@dataclass(frozen=True, slots=True)
class RawFrame:
    """`frame`: what follows are the bytes of a whole frame, its length field included."""

    token: Token


@dataclass(frozen=True, slots=True)
class RawBytes:
    """`bytes 01 02`: bytes of a message as they are."""

    token: Token
    data: bytes


@dataclass(frozen=True, slots=True)
class Define:
    """`define NAME value`: a name for a constant, a text or a macro."""

    token: Token
    value: Value


@dataclass(frozen=True, slots=True)
class VariableDeclaration:
    """`DATA8 name`, `ARRAY8 name 20`, `global DATAF name`: a variable.

    scope  the word in front of it, None where there is none
    """

    token: Token
    type: Token
    size: Expression | None
    scope: str | None


@dataclass(frozen=True, slots=True)
class Label:
    """`Loop:`: a place to jump to."""

    token: Token


@dataclass(frozen=True, slots=True)
class Call:
    """An operation or a system command with its values, in either notation.

    end          where the next value would stand
    is_complete  False where it ends in `...`
    """

    token: Token
    arguments: tuple[WrittenArgument, ...]
    end: Token
    is_complete: bool


@dataclass(frozen=True, slots=True)
class Opening:
    """`vmthread NAME {`: what follows has local variables."""

    token: Token


@dataclass(frozen=True, slots=True)
class Closing:
    """`}`: the end of it."""

    token: Token


Statement = Header | RawFrame | RawBytes | Define | VariableDeclaration | Label | Call | Opening | Closing


def error_at(token: Token, reason: str) -> AssemblyError:
    """An error where a token stands."""
    return AssemblyError(token.line, token.column, reason)


def statements(text: str) -> Iterator[Statement | AssemblyError]:
    """The statements of a text. What is wrong comes as an error; reading goes on with the next line."""
    parser = _Parser(text)
    while not parser.is_at_end():
        try:
            yield parser.statement()
        except AssemblyError as error:
            yield error
            parser.skip_line()


_OPERATION = late_pattern(r"op[A-Z_]\w*")


def is_operation_word(name: str) -> bool:
    """Whether a name is an operation in the macro notation: `opSOUND`."""
    return _OPERATION.match(name) is not None


class _Parser:
    """Reads statement after statement, three tokens ahead at most."""

    def __init__(self, text: str) -> None:
        self._tokens = tokens(text)
        self._ahead: deque[Token] = deque()
        self._depth = 0
        self._last: Token | None = None

    def is_at_end(self) -> bool:
        """Whether there is no further statement. Marks that people put between statements are passed over."""
        while self._peek().is_mark(",", ";"):
            self._next()
        return self._peek().kind is TokenKind.END

    def skip_line(self) -> None:
        """Goes on to the first token of another line; at least one token is passed over."""
        self._depth = 0
        if self._peek().kind is TokenKind.END:
            return
        self._next()
        while not self._peek().is_first:
            self._next()

    def statement(self) -> Statement:
        """The next statement. Raises AssemblyError."""
        token = self._peek()
        if token.is_mark("}"):
            return Closing(self._next())
        if token.is_mark("#"):
            self._next()
            if self._peek().text == "define":
                return self._define()
            raise error_at(token, "of the lines that start with # there is only #define")
        if token.kind is not TokenKind.NAME:
            raise self._unexpected("an operation such as SOUND(TONE, 1, 440, 1000)")
        if self._peek(1).is_mark(":"):
            self._next()
            self._next()
            return Label(token)
        word = token.text
        if self._peek(1).is_mark("(") and word != BYTES:
            return self._call()
        if word == MESSAGE:
            return self._header()
        if word == FRAME:
            return RawFrame(self._next())
        if word == BYTES:
            self._next()
            return RawBytes(token, self._hex(token, until_mark=False))
        if word == "define":
            return self._define()
        if word == "vmthread":
            return self._thread()
        if word in TYPES or word in (GLOBAL_WORD, LOCAL_WORD):
            return self._declaration()
        if word.startswith(_SUBROUTINES):
            declared = _DECLARED_AS.get(word.partition("_")[2])
            hint = f"; {declared} declares a variable" if declared is not None else ""
            raise error_at(token, f"a direct command has no subroutines: it is one piece, as a vmthread is{hint}")
        return self._macro_operation() if is_operation_word(word) else self._bare()

    # Statements, one by one

    def _header(self) -> Header:
        token = self._next()
        kind = self._next() if self._is_name_here() and self._peek().text.isupper() else None
        facts: list[tuple[Token, Literal | Named]] = []
        while not self._peek().is_first:
            name = self._expect_name("counter, globals, locals or length")
            value = self._peek()
            if value.is_first or value.kind not in (TokenKind.NUMBER, TokenKind.NAME):
                raise self._line_end(f"the value of {name.text}")
            facts.append((name, Literal(self._number()) if value.kind is TokenKind.NUMBER else Named(self._next())))
        return Header(token, kind, tuple(facts))

    def _define(self) -> Define:
        self._next()
        token = self._expect_name("the name to define")
        if self._peek().is_first:
            raise self._line_end(f"what {token.text} stands for")
        return Define(token, self._value())

    def _thread(self) -> Opening:
        token = self._next()
        self._expect_name("the name of the thread", is_same_line=False)
        self._expect("{")
        return Opening(token)

    def _declaration(self) -> VariableDeclaration:
        scope = self._next().text if self._peek().text in (GLOBAL_WORD, LOCAL_WORD) else None
        kind = self._peek()
        if kind.kind is not TokenKind.NAME or kind.text not in TYPES:
            raise self._line_end(f"a type ({', '.join(TYPES)})")
        self._next()
        token = self._expect_name("the name of the variable")
        size: Expression | None = None
        if self._peek().is_mark("["):
            self._next()
            size = self._expression()
            self._expect("]")
        elif not self._peek().is_first and not self._peek().is_mark(",", ";", "}"):
            size = self._expression()
        if size is None and kind.text in SIZED:
            raise self._line_end(f"the number of elements of {token.text}")
        return VariableDeclaration(token, kind, size, scope)

    def _call(self) -> Call:
        """`NAME(value, value)`. LEGO's sources have lines without the ) and with two commas in a row."""
        token = self._next()
        self._expect("(")
        arguments: list[WrittenArgument] = []
        while not self._peek().is_mark(")", CUT):
            if self._peek().is_mark(","):
                self._next()
                continue
            arguments.append(self._argument(arguments))
            if not self._peek().is_mark(")", ","):
                if self._ends_without_mark():
                    return Call(token, tuple(arguments), self._peek(), True)
                raise self._unexpected(", or )")
            if self._peek().is_mark(","):
                self._next()
        is_complete = self._is_complete()
        return Call(token, tuple(arguments), self._expect(")"), is_complete)

    def _ends_without_mark(self) -> bool:
        """Whether the line ends here, and what follows could be the next statement."""
        token = self._peek()
        return token.is_first and (token.kind in (TokenKind.NAME, TokenKind.END) or token.is_mark("}", "#"))

    def _macro_operation(self) -> Call:
        """`opNAME, value, value`, over as many lines as commas lead."""
        token = self._next()
        arguments: list[WrittenArgument] = []
        while self._peek().is_mark(","):
            self._next()
            if self._peek().is_mark(CUT) or self._starts_statement():
                break
            arguments.append(self._argument(arguments))
        is_complete = self._is_complete()
        end = self._peek()
        if not end.is_first and not end.is_mark(";", "}") and not self._starts_statement():
            raise self._unexpected("a comma" if is_complete else "the end of the line")
        return Call(token, tuple(arguments), end, is_complete)

    def _bare(self) -> Call:
        """A name alone, for an operation without values."""
        token = self._next()
        following = self._peek()
        if not following.is_first and not following.is_mark(",", ";", "}"):
            raise error_at(following, f"{_shown(following)} stands where ( should: {token.text}(...)")
        return Call(token, (), following, True)

    def _is_complete(self) -> bool:
        if not self._peek().is_mark(CUT):
            return True
        self._next()
        return False

    def _starts_statement(self) -> bool:
        """Whether a statement starts here, after the comma of an operation in the macro notation."""
        token, following = self._peek(), self._peek(1)
        if token.kind is TokenKind.END or token.is_mark("}", "#"):
            return True
        if token.kind is not TokenKind.NAME:
            return False
        if is_operation_word(token.text) or following.is_mark(":"):
            return True
        if not token.is_first:
            return False
        if following.is_mark("("):
            return token.text not in (*FORMS, *MARKS, BYTES)
        words = (MESSAGE, FRAME, BYTES, "define", "vmthread", GLOBAL_WORD, LOCAL_WORD)
        return token.text in TYPES or token.text in words

    # Values

    def _argument(self, before: list[WrittenArgument]) -> WrittenArgument:
        if len(before) >= MAX_PARTS:
            raise error_at(self._peek(), f"these are more than {MAX_PARTS} values")
        if self._is_name_here(is_same_line=False) and self._peek(1).is_mark("="):
            name = self._next()
            self._next()
            return WrittenArgument(name, self._value())
        return WrittenArgument(None, self._value())

    def _value(self) -> Value:
        token = self._peek()
        if token.is_mark("@", "&"):
            self._next()
            name = self._expect_name("the name of a variable", is_same_line=False)
            return Marked(token, self._element(name) if self._peek().is_mark("[") else Named(name))
        if token.kind is TokenKind.NAME:
            following = self._peek(1)
            if following.is_mark("["):
                return self._element(self._next())
            if following.is_mark("("):
                return self._macro()
            if token.text == "LCS" and following.is_mark(","):
                return self._spelled_text()
        return self._expression()

    def _element(self, name: Token) -> Element:
        self._expect("[")
        index = self._expression()
        self._expect("]")
        return Element(name, index)

    def _macro(self) -> Value:
        token = self._next()
        self._expect("(")
        if token.text == BYTES:
            data = self._hex(token, until_mark=True)
            self._expect(")")
            return Raw(token, data)
        if token.text not in (*FORMS, *MARKS):
            raise error_at(
                token, f"{token.text} is no macro: there are {', '.join((*FORMS, *MARKS))} and {BYTES}(01 FF)"
            )
        with self._deeper(token):
            part = self._value()
        self._expect(")")
        return Macro(token, part)

    def _spelled_text(self) -> Macro:
        """`LCS, 'L','E','G','O', 0`: how C has to write a text."""
        token = self._next()
        letters: list[str] = []
        while len(letters) <= MAX_BYTES:
            self._expect(",")
            letter = self._peek()
            if letter.kind is TokenKind.NUMBER and letter.text in ("0", "0x00"):
                self._next()
                break
            body, unknown = unescaped(letter) if letter.kind is TokenKind.TEXT else ("", None)
            if len(body) != 1 or unknown is not None:
                raise self._unexpected("a letter such as 'L', or the 0 that ends the text,")
            letters.append(body)
            self._next()
        text = "".join(f"\\u{ord(letter):04x}" for letter in letters)
        return Macro(token, Literal(Token(TokenKind.TEXT, f'"{text}"', token.line, token.column, False)))

    def _expression(self) -> Expression:
        with self._deeper(self._peek()):
            return self._chain(("|",), lambda: self._chain(("+", "-"), lambda: self._chain(("*", "/"), self._factor)))

    def _chain(self, marks: tuple[str, ...], part: Callable[[], Expression]) -> Expression:
        token = self._peek()
        first = part()
        rest: list[tuple[Token, Expression]] = []
        while self._peek().is_mark(*marks):
            if len(rest) >= MAX_PARTS:
                raise error_at(self._peek(), f"the expression has more than {MAX_PARTS} parts")
            operator = self._next()
            rest.append((operator, part()))
        return Chain(token, first, tuple(rest)) if rest else first

    def _factor(self) -> Expression:
        token = self._peek()
        if token.is_mark("-", "+"):
            self._next()
            with self._deeper(token):
                part = self._factor()
            return Negative(token, part) if token.text == "-" else part
        if token.is_mark("("):
            self._next()
            part = self._expression()
            self._expect(")")
            return part
        if token.kind is TokenKind.TEXT:
            _, unknown = unescaped(token)
            if unknown is not None:
                escape = token.text[unknown : unknown + 2]
                raise AssemblyError(token.line, token.column + unknown, f"{escape} is no escape: there are {ESCAPES}")
            return Literal(self._next())
        if token.kind is TokenKind.NUMBER:
            return Literal(self._number())
        if token.kind is TokenKind.NAME:
            return Named(self._next())
        raise self._unexpected("a value")

    def _number(self) -> Token:
        token = self._next()
        if len(token.text) > MAX_NUMBER:
            raise error_at(token, f"a number has at most {MAX_NUMBER} characters")
        if re.fullmatch(r"0\d+", token.text) and not re.fullmatch(r"0+[0-7]?", token.text):
            raise error_at(token, f"{token.text} is octal in C and decimal to most readers: write it as 0x..")
        return token

    def _hex(self, token: Token, *, until_mark: bool) -> bytes:
        """Bytes in hex: to the end of the line, or up to the next mark."""
        data = bytearray()
        while until_mark or not self._peek().is_first:
            found = self._peek()
            if until_mark and found.is_mark(")"):
                break
            if found.is_mark(":", "|"):
                self._next()
                continue
            if not re.fullmatch(r"(?:0[xX])?(?:[0-9a-fA-F]{2})+", found.text, re.ASCII):
                raise self._unexpected("bytes in hex, two digits each,")
            data += bytes.fromhex(self._next().text.removeprefix("0x").removeprefix("0X"))
            if len(data) > MAX_BYTES:
                raise error_at(token, f"these are more than {MAX_BYTES} bytes")
        return bytes(data)

    # Tokens

    def _peek(self, count: int = 0) -> Token:
        while len(self._ahead) <= count:
            if self._ahead and self._ahead[-1].kind is TokenKind.END:
                return self._ahead[-1]
            self._ahead.append(next(self._tokens))
        return self._ahead[count]

    def _next(self) -> Token:
        token = self._peek()
        if token.kind is not TokenKind.END:
            self._ahead.popleft()
        self._last = token
        return token

    def _is_name_here(self, *, is_same_line: bool = True) -> bool:
        token = self._peek()
        return token.kind is TokenKind.NAME and not (is_same_line and token.is_first)

    def _expect_name(self, what: str, *, is_same_line: bool = True) -> Token:
        if not self._is_name_here(is_same_line=is_same_line):
            raise self._line_end(what) if is_same_line else self._unexpected(what)
        return self._next()

    def _expect(self, mark: str) -> Token:
        if not self._peek().is_mark(mark):
            raise self._unexpected(mark)
        return self._next()

    def _deeper(self, token: Token) -> _Deeper:
        return _Deeper(self, token)

    def enter(self, token: Token) -> None:
        """One level deeper. Raises AssemblyError where that is too deep."""
        if self._depth >= MAX_DEPTH:
            raise error_at(token, f"the values stand in each other more than {MAX_DEPTH} deep")
        self._depth += 1

    def leave(self) -> None:
        """One level back."""
        self._depth -= 1

    def _line_end(self, expected: str) -> AssemblyError:
        """The error where something should stand in the same line."""
        last = self._last
        if last is None or not self._peek().is_first:
            return self._unexpected(expected)
        return AssemblyError(last.line, last.column + len(last.text), f"the line ends where {expected} should stand")

    def _unexpected(self, expected: str) -> AssemblyError:
        token = self._peek()
        if token.kind is TokenKind.BAD:
            return error_at(token, token.text)
        if token.kind is TokenKind.END:
            return error_at(token, f"the text ends where {expected} should stand")
        return error_at(token, f"{_shown(token)} stands where {expected} should")


class _Deeper:
    """Counts a level of nesting while it lasts."""

    def __init__(self, parser: _Parser, token: Token) -> None:
        self._parser = parser
        self._token = token

    def __enter__(self) -> None:
        self._parser.enter(self._token)

    def __exit__(self, *_: object) -> None:
        self._parser.leave()


def _shown(token: Token) -> str:
    return token.text if len(token.text) <= MAX_NUMBER else f"{token.text[:MAX_NUMBER]}..."

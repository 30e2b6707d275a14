"""Lines of text to pieces: frames by the rule, and the forms for what is none."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.blanking import without_record
from ev3proto.text.paste.familiar import Familiar
from ev3proto.text.paste.fitting import bare_reason, reason
from ev3proto.text.paste.forms import Forms
from ev3proto.text.paste.labelled import Labelled
from ev3proto.text.paste.pieces import LEAST, MAX_LINE, MAX_TEXT, Pasted, Wants, check_text, short
from ev3proto.text.paste.scanner import Row, Scanner

_ADDRESS = late_pattern(r"(?:[0-9a-fA-F]{2}([:-]))(?:[0-9a-fA-F]{2}\1){4}[0-9a-fA-F]{2}")
_UUID = late_pattern(r"[{(\"']*[0-9a-fA-F]{8}-(?:[0-9a-fA-F]{4}-){3}[0-9a-fA-F]{12}[})\"'.,;]*")
_SHORT_IPV6 = late_pattern(r"\W*[0-9a-fA-F:]*::[0-9a-fA-F:]*(?:[%/]\w+)?\W*")
_DECIMALS = late_pattern(r"[\[({]?(?:\d{1,3}(?:\s*[,;]\s*|\s+|(?=[\])}]|$)))+[\])}]?;?")
_STRACE_DUMP = late_pattern(r" \| 00000  ")
"""The first row of what `strace -e write` prints below a call which has the same bytes as a string."""
_DENSE = late_pattern(r"[\"'<(]*(?:[0-9a-fA-F]{2}[:-]?)+[\"'>),;.]*")


class Reader:
    """Reads the frames of a text, and says of the rest what looks like one."""

    def __init__(self) -> None:
        self._scanner = Scanner()
        self._forms = Forms(Wants(LEAST, is_sure=False))
        self._familiar = Familiar()
        self._labelled = Labelled()
        self._held: list[Pasted] = []
        # The lines in which the last two dumps of strace began, and the line of the last frames, with their bytes.
        self._dumps = (0, 0)
        self._shown: tuple[int, list[bytes]] = (0, [])

    def read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """All pieces in the lines, in their order."""
        for piece in self._read(lines):
            line, shown = self._shown
            if piece.line in self._dumps and piece.line == line + 1 and piece.data in shown:
                continue
            if piece.data:
                self._shown = piece.line, [*(shown if piece.line == line else []), piece.data]
            yield piece

    def _read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """All pieces, those of dumps that repeat a string among them."""
        number = 0
        for number, line in enumerate(lines, 1):
            check_text(line)
            if line.startswith(" |") and _STRACE_DUMP.match(line):
                self._dumps = self._dumps[1], number
            if len(line) > MAX_LINE:
                yield from self._all(self._scanner.close())
                yield from self._kept(self._forms.close())
                problem = f"the line has {len(line)} characters, more than {MAX_LINE}, and was not read"
                yield Pasted(b"", number, short(line, MAX_TEXT), problem=problem)
            elif self._forms.is_open or self._scanner.is_open:
                yield from self._all(self._scanner.feed(line.rstrip("\r\n"), number))
            elif (piece := self._familiar.read(line, number)) is not None:
                self._scanner.skip()
                self._labelled.clear()
                yield piece
            else:
                pieces = [*self._all(self._scanner.feed(line.rstrip("\r\n"), number))]
                self._familiar.learn(pieces)
                yield from pieces
        yield from self._all(self._scanner.close())
        yield from self._kept(self._forms.close())

    def _all(self, found: Iterator[Pasted | Row]) -> Iterator[Pasted]:
        for one in found:
            if isinstance(one, Pasted):
                self._labelled.clear()
                yield one
                continue
            piece = self._labelled.take(one)
            if piece is not None:
                yield piece
                continue
            if one.looks is not None:
                self._held.append(one.looks)
            yield from self._kept(self._forms.feed(without_record(one.line), one.number))

    def _kept(self, pieces: Iterator[Pasted]) -> Iterator[Pasted]:
        """The pieces that are worth reporting, and what looks like a frame where there is none of them."""
        for piece in pieces:
            bare = None if piece.cut else bare_reason(piece.data)
            is_bare = bare is not None and any(
                (looks.line, looks.problem) == (piece.line, bare) for looks in self._held
            )
            if _is_worth(piece) and not is_bare:
                self._held = [looks for looks in self._held if looks.line < piece.line]
                yield piece
        if not self._forms.is_open:
            held, self._held = self._held, []
            yield from held


def _is_worth(piece: Pasted) -> bool:
    """Whether a piece that is no frame is reported: the text says that it is meant as one, or it looks like one."""
    text = piece.text.strip()
    if _ADDRESS.fullmatch(text) or _UUID.fullmatch(text) or _SHORT_IPV6.fullmatch(text):
        return False
    if not piece.data and piece.time is not None and piece.direction is None:
        # A log has many other numbers.
        return False
    if piece.problem is not None or piece.cut or piece.direction is not None or piece.text.startswith("0x|"):
        return True
    is_dense = _DENSE.fullmatch(piece.text) is not None
    is_decimal = _DECIMALS.fullmatch(text) is not None
    return reason(piece.data, is_dense=is_dense, is_decimal=is_decimal) is not None

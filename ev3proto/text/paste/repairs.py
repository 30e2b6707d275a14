"""What happened to a frame on its way into a text: each row of `REPAIRS` undoes one thing; a flawless frame proves it.

A repair gives candidates for a line. The protocol judges: a candidate counts only if all of it is a flawless frame, and
of several the one with the fewest findings wins. A new mishap is a row with its example.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import islice
from typing import NamedTuple

from ev3proto.schema.frame import is_flawless
from ev3proto.schema.header import COMMAND_HEADER_SIZE, frame_size
from ev3proto.semantics.identify import Kind, identify
from ev3proto.semantics.likelihood import FAULT, CommandCode
from ev3proto.tables.frame import MESSAGE_TYPES, MessageType
from ev3proto.text.paste.elements import MISSPELT, elements_of, narrow, string_bytes
from ev3proto.text.paste.heads import is_head
from ev3proto.text.paste.judge import Reading, best
from ev3proto.text.paste.pieces import MAX_TEXT, SlipPlace, short
from ev3proto.text.paste.runs import AROUND, Row

_MOST_TRIED = 500
"""Candidates of a line: frames of 60 bytes have no more of one digit, and each costs a parse."""
_LONGEST = 4096
_DIRECT = (MessageType.DIRECT_COMMAND_REPLY, MessageType.DIRECT_COMMAND_NO_REPLY)
_SPREAD = re.compile(r"(?<![\w.-])(?:ff([89a-f]\w)|(65[45]\d\d|4294967[12]\d\d)|-([\da-f]{1,2}))(?!\w)", re.IGNORECASE)
"""A byte above 7f as more digits, or with its sign: `ffa4`, `65444`, `4294967204`, `-5c`."""
_HEX_WORD = re.compile(r"(?<!\w)(?:0[xX])?([0-9a-fA-F]{9,})(?!\w)")
LOOKALIKES = str.maketrans("OolIiSZАВСЕасеОоХхЗбΑΒΕΟΧ", "0011152ABCEace00Xx36ABE0X")
"""Letters that are read for digits in scanned pictures, or were typed on a Russian or Greek keyboard."""
_ALIKE = "".join(map(chr, LOOKALIKES))
_MISREAD = re.compile(rf"(?<![^\W_])(?=\w*[0-9])[0-9a-fA-FxX{_ALIKE}]+(?![^\W_])")
_DIGIT = re.compile(r"[0-9\uff10-\uff19]{2}")
_SUSPECT = re.compile(r"\\[0-9A-F]{2}|(?:ffffff|FFFFFF)[89a-fA-F]")
_LABVIEW = {"n": "0A", "r": "0D", "t": "09", "b": "08", "f": "0C", "s": "20", "\\": "5C"}


class Repair(NamedTuple):
    """What may have happened: an example, the candidates of a line, what to say; {} is the candidate."""

    example: str
    candidates: Callable[[str], Iterable[str]]
    says: str
    is_read: bool = True


class Repaired(NamedTuple):
    """The frame in a line after a repair."""

    reading: Reading
    text: str
    says: str
    is_read: bool
    slip: SlipPlace | None


def _signed(line: str) -> Iterator[str]:
    yield _HEX_WORD.sub(lambda found: re.sub("(?i)(?:ffffffff)?ffffff(?=[89a-f])", "", found[0]), line)
    yield _SPREAD.sub(lambda one: one[1] or (f"{int(one[2]) & 255}" if one[2] else f"{-int(one[3], 16) & 255:x}"), line)


def _marked(mark: re.Pattern[str], line: str) -> Iterator[str]:
    """Yields the bytes of what has some of them between marks, as digits, and all others as characters."""
    found = next((one for one in mark.finditer(line) if len(one[1]) == 2), None)
    before, text = ("", "") if found is None else (line[: found.start()], line[found.start() :])
    if text and not elements_of(before)[0]:
        text = text.partition(before[-1])[0] if before[-1:] in ("'", '"') else text
        codes = mark.sub(lambda one: rf"\x{_LABVIEW.get(one[1], one[1])}", text)
        yield f'{before}"{codes}"'


def _lost_zero(line: str) -> Iterator[str]:
    for word in _HEX_WORD.finditer(line):
        if len(word[1]) % 2:
            yield word[1] + "0"  # the last digit was cut off, as likely as any other
            yield from (word[1][:at] + "0" + word[1][at:] for at in range(0, len(word[1]), 2))


def _unpadded(line: str) -> Iterator[str]:
    word = _HEX_WORD.search(line)
    before, after = (line[: word.start()], line[word.end() :]) if word is not None else ("", line)
    if word is None or after.strip(AROUND) or _is_wrong_frame(word[1]):
        return
    if is_head(before) or before.endswith(("'", '"')):
        yield from islice(_parted(word[1], (int(word[1][0], 16), int(word[1][:2], 16))), _MOST_TRIED)


def _is_wrong_frame(digits: str) -> bool:
    """Returns whether digits are a frame with a slip as they are: that is likelier than that zeros are lost."""
    return len(digits) % 2 == 0 and identify(bytes.fromhex(digits), missing=False).kind is Kind.SLIP


def _parted(digits: str, lengths: tuple[int, int]) -> Iterator[str]:
    """Yields hex digits as bytes without their leading zeros, as many as the first one says."""
    for width, length in enumerate(lengths, 1):
        yield from _rest(digits[width:], digits[:width].zfill(2), length + 1)


def _rest(digits: str, done: str, count: int) -> Iterator[str]:
    if not count <= len(digits) <= 2 * count:
        return
    if not digits:
        yield done
        return
    for width in (1,) if digits[0] == "0" else (2, 1):
        byte = digits[:width].zfill(2)
        is_length, is_type = len(done) == 2, len(done) == 8
        if (byte < "04" or not is_length) and (int(byte, 16) in MESSAGE_TYPES or not is_type):
            yield from _rest(digits[width:], done + byte, count - 1)


REPAIRS = (
    Repair(
        "\uff10\uff16002a0080000001",
        lambda line: [narrow(line)],
        "its letters are as wide as an ideograph (full-width)",
    ),
    Repair(
        "O6 00 2a 00 8O 00 00 01",
        lambda line: [_MISREAD.sub(lambda found: found[0].translate(LOOKALIKES), line)],
        "{word!r} is not hex; did you mean {meant!r}?",
        is_read=False,
    ),
    Repair("06002a00ffffff80000001", _signed, "a byte above 7f is spread over 32 bits (ffffff80); print it & 0xff"),
    Repair(
        r"\06\00*\00\80\00\00\01",
        partial(_marked, re.compile(r"\\([0-9A-F]{2}|[nrtbfs\\])")),
        "these are '\\' codes of LabVIEW",
    ),
    Repair(
        "<06><00>*<00><80><00><00><01>",
        partial(_marked, re.compile(r"[<{\[%=]([\dA-Fa-f]{2})[>}\]]?")),
        "characters that are not in brackets are bytes, too",
    ),
    Repair(
        "{0xd, 0x0, 0x2a, 0x0, 0x2, 0x0 <repeats 10 times>}",
        lambda line: [re.sub(r"(\w+) <repeats (\d{1,3}) times>", lambda one: ", ".join([one[1]] * int(one[2])), line)],
        "the debugger shows equal bytes once",
    ),
    Repair(
        "F0000008000009401810282E80382E803",
        _lost_zero,
        "{quoted!r} has an odd number of hex digits ({count}); with a zero it is {}",
        is_read=False,
    ),
    Repair(
        "f000800094181282e8382e83",
        _unpadded,
        "the bytes lost their leading zeros (print with %02x): {}",
        is_read=False,
    ),
)


class Slip(NamedTuple):
    """What is wrong with an element without bytes: an example, a pattern, what to say; `front` is what has bytes."""

    example: str
    pattern: re.Pattern[str]
    says: str
    bytes_of: Callable[[str], bytes | None] = bytes.fromhex


_H = "[0-9a-fA-F]"
SLIPS = (
    Slip(r"\xof", MISSPELT, "{word!r} is not an escape: two hex digits follow \\x", string_bytes),
    Slip("0x1ff", re.compile(rf"^(?P<word>\d{{3}}|0[xX]{_H}+)$"), "{word!r} is more than 255, which a byte cannot be"),
    Slip(
        "0f0",
        re.compile(rf"^(?P<word>(?P<front>(?:{_H}{{2}}){{2,}})?(?:{_H}{{2}})?{_H})$"),
        "{word!r} has an odd number of hex digits ({count}); two make a byte",
    ),
    Slip(
        "8O",
        re.compile(rf"^(?P<word>(?=.*[{_ALIKE}])(?:0[xX])?[0-9a-fA-F{_ALIKE}]+)$"),
        "{word!r} is not {kind}; did you mean {meant!r}?",
    ),
    Slip("zz", re.compile("(?P<word>.+)", re.DOTALL), "{word!r} is not {kind}"),
)
"""The first row that fits counts."""


def slip_in(text: str, *, is_hex: bool = True) -> tuple[bytes, int, str]:
    """Returns the bytes in front of a slip in an element that has none, where it is, and what it is, as a sentence."""
    row, found = next((row, found) for row in SLIPS if (found := row.pattern.search(text)))
    word, kind = found["word"], "hex" if is_hex else "a number"
    said = row.says.format(word=short(word), count=len(word), meant=word.translate(LOOKALIKES), kind=kind)
    before = text[: found.start("word")]
    front = found.groupdict().get("front") or re.sub("^[^\"'`]*[\"'`]", "", before)
    return row.bytes_of(front) or b"", len(before), said


def may_be_mended(line: str) -> bool:
    """Returns whether a line that was read may mean something else: it has LabVIEW's codes, or bytes of 32 bits."""
    return _SUSPECT.search(line) is not None


def repaired(row: Row) -> Repaired | None:
    """Returns the frame that a line has after one repair; None if none makes it one."""
    line = row.line
    if len(line) > _LONGEST or not _DIGIT.search(line):
        return None
    for repair in REPAIRS:
        tried = dict.fromkeys(islice(repair.candidates(line), _MOST_TRIED))
        found = [(text, reading) for text in tried if text != line and (reading := _flawless(text, row.number))]
        if found:
            text, reading = min(found, key=lambda one: _oddness(_frame(one[1]))) if len(found) > 1 else found[0]
            if repair.candidates is _lost_zero and text[:-1] in line:
                return None  # its last digit was cut off, and is not known
            return _told(repair, line, text, reading, row.number)
    return None


def _oddness(frame: bytes) -> tuple[int, float]:
    """Returns how unlikely a frame is: of two that fit, the ordinary one was meant, with a small counter."""
    is_direct = frame[4] in _DIRECT and len(frame) > COMMAND_HEADER_SIZE
    cost = CommandCode(frame, "official").rest() if is_direct else FAULT
    return (frame[3] > 0) + (frame[4] not in MESSAGE_TYPES), cost


def _frame(reading: Reading) -> bytes:
    part, frames = reading.parts[0]
    return part.data[frames[0].start : frames[0].end]


def _flawless(text: str, number: int) -> Reading | None:
    is_word = _HEX_WORD.fullmatch(text) is not None
    if is_word and (len(text) % 2 or frame_size(bytes.fromhex(text[:4])) * 2 != len(text)):
        return None
    reading = best(Row(text, number).of_line())
    return reading if reading is not None and reading.worth.is_whole and is_flawless(_frame(reading)) else None


def _told(repair: Repair, line: str, text: str, reading: Reading, number: int) -> Repaired:
    column = next((at for at, (old, new) in enumerate(zip(line, text, strict=False)) if old != new), 0)
    says, slip = repair.says, None
    if "{quoted" in says:
        odd = next(one[1] for one in _HEX_WORD.finditer(line) if len(one[1]) % 2)
        says = says.replace("{}", "{{}}").format(quoted=short(odd), count=len(odd))
    if "{word" in says:
        word = next(one for one in _MISREAD.finditer(line) if one.end() > column)
        says = says.format(word=short(word[0]), meant=short(word[0].translate(LOOKALIKES)))
        slip = SlipPlace(number, word.start() + 1)
        says = f"column {slip.column}: {says}"
    says = says.replace("{}", short(_frame(reading).hex(" ").upper(), MAX_TEXT))
    return Repaired(reading, text, says, repair.is_read, slip)

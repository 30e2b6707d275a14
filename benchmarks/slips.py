"""One human slip away from a right frame: does `check` lead back to it?

    python -m benchmarks.slips [N]     a table, N frames a slip (default 50)
    python -m benchmarks.slips KIND    the frames of one kind that it does not, with what is said

Of each wrong frame, the suggestions of `check` are judged:

    right       the first is the frame that was meant
    value       so is one of them, but for bytes that it says can only be guessed
    misleading  it is another one, and names a place where nothing is wrong
    fixed       `--fix` takes it; wrongly, if it is another one

A new kind of slip is a function here and a row in `ev3proto/checking/slips.py`.
"""

from __future__ import annotations

import struct
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import NamedTuple

import ev3proto
from ev3proto import Argument, DirectCommand, Operation, Record, SystemCommand, check
from ev3proto.checking.report import Suggestion
from ev3proto.schema.argument import encode_integer
from ev3proto.schema.header import with_length
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind
from ev3proto.text.assembly import assemble

REAL = Path(__file__).parent.parent / "captures" / "real-bricks.log"
TYPICAL = """
OUTPUT_SPEED(0, A, 50) OUTPUT_START(0, A)
OUTPUT_SPEED(0, B+C, -75) OUTPUT_START(0, B+C)
OUTPUT_POWER(0, A+B+C+D, 100) OUTPUT_START(0, A+B+C+D)
OUTPUT_STOP(0, A, 1)
OUTPUT_RESET(0, B+C)
OUTPUT_POLARITY(0, A+B, -1) OUTPUT_SPEED(0, A+B, 60) OUTPUT_START(0, A+B)
OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 1) OUTPUT_READY(0, A)
OUTPUT_STEP_SPEED(0, B+C, -40, 30, 660, 30, 1)
OUTPUT_STEP_POWER(0, B, 80, 0, 900, 180, 1)
OUTPUT_TIME_SPEED(0, A, 50, 0, 1500, 0, 0) OUTPUT_READY(0, A)
OUTPUT_TIME_POWER(0, C, 65, 100, 2000, 100, 1)
OUTPUT_STEP_SYNC(0, B+C, 40, 100, 720, 1) OUTPUT_READY(0, B+C)
OUTPUT_TIME_SYNC(0, B+C, 75, -50, 3000, 0)
OUTPUT_READ(0, D, GV0(0), GV0(4))
OUTPUT_GET_COUNT(0, A, GV0(0))
OUTPUT_CLR_COUNT(0, A+B+C+D)
OUTPUT_SPEED(0, B+C, 35) OUTPUT_START(0, B+C) TIMER_WAIT(2000, LV0(0)) TIMER_READY(LV0(0)) OUTPUT_STOP(0, B+C, 1)
SOUND(TONE, 50, 440, 1000)
SOUND(TONE, 2, 262, 500) SOUND_READY() SOUND(TONE, 2, 330, 500) SOUND_READY() SOUND(TONE, 2, 523, 1000)
SOUND(PLAY, 100, './ui/DownloadSucces')
SOUND(REPEAT, 60, '../prjs/demo/hello')
UI_WRITE(LED, 2)
UI_WRITE(LED, 5) TIMER_WAIT(1000, LV0(0)) TIMER_READY(LV0(0)) UI_WRITE(LED, 0)
UI_DRAW(TOPLINE, 0) UI_DRAW(BMPFILE, 1, 0, 0, '../apps/Motor Control/MotorCtlAD.rgf') UI_DRAW(UPDATE)
UI_DRAW(FILLWINDOW, 0, 0, 0) UI_DRAW(SELECT_FONT, 1) UI_DRAW(TEXT, 1, 20, 50, 'Hello') UI_DRAW(UPDATE)
UI_DRAW(CLEAN) UI_DRAW(LINE, 1, 10, 10, 100, 80) UI_DRAW(RECT, 1, 40, 20, 90, 60) UI_DRAW(UPDATE)
UI_DRAW(CIRCLE, 1, 89, 64, 40) UI_DRAW(UPDATE)
UI_DRAW(VALUE, 1, 10, 60, 3.5F, 5, 1) UI_DRAW(UPDATE)
MATH(POW, 2.0F, 10.0F, GV0(0))
MATH(SQRT, 2.0F, GV0(0))
INPUT_READSI(0, 0, 16, 0, GV0(0))
INPUT_READ(0, 2, 29, 0, GV0(0))
INPUT_DEVICE(READY_SI, 0, 0, 16, 0, 1, GV0(0))
INPUT_DEVICE(READY_RAW, 0, 3, 29, 4, 3, GV0(0), GV0(4), GV0(8))
INPUT_DEVICE(GET_TYPEMODE, 0, 0, GV0(0), GV0(1))
INPUT_DEVICE(GET_NAME, 0, 1, 32, GV0(0))
INPUT_DEVICE_LIST(16, GV0(0), GV0(16))
UI_READ(GET_VBATT, GV0(0))
UI_READ(GET_LBATT, GV0(0))
UI_READ(GET_FW_VERS, 16, GV0(0))
COM_GET(GET_BRICKNAME, 16, GV0(0))
COM_SET(SET_BRICKNAME, 'myEV3')
UI_BUTTON(PRESSED, 2, GV0(0))
FILE(LOAD_IMAGE, 1, '../prjs/demo/demo.rbf', LV0(0), LV0(4)) PROGRAM_START(1, LV0(0), LV0(4), 0)
FILE(OPEN_READ, '../prjs/a.txt', GV0(0), GV0(4)) FILE(READ_BYTES, GV0(0), 20, GV0(8)) FILE(CLOSE, GV0(0))
WRITEMAILBOX(name="abc", payload="hi!\\0")
BEGIN_DOWNLOAD(size=1532, path="../prjs/demo/demo.rbf")
BEGIN_UPLOAD(max_bytes=900, path="../prjs/demo/demo.rbf")
CONTINUE_UPLOAD(handle=0, max_bytes=900)
LIST_FILES(max_bytes=1000, path="../prjs/")
DELETE_FILE(path="../prjs/old.txt")
"""
"""What people send: motors, sounds, drawings, sensors, files; a command a line."""


class Case(NamedTuple):
    """A right frame, the wrong one, and the bytes of that where the slip is."""

    kind: str
    right: bytes
    wrong: bytes
    place: range


Wrong = tuple[bytes, int, int] | None
SLIPS: dict[str, Callable[[bytes, Random], Wrong]] = {}


def slip(make: Callable[[bytes, Random], Wrong]) -> Callable[[bytes, Random], Wrong]:
    """Registers a slip under the name of its function: frame, random numbers -> wrong frame, start and end, or None."""
    SLIPS[make.__name__] = make
    return make


def is_clean(frame: bytes) -> bool:
    report = check(frame, alone=True)
    return report.accepted and not report.findings


@cache
def frames() -> list[bytes]:
    """Typical frames, and real ones of each different content."""
    found = {}
    for line in TYPICAL.strip().splitlines():
        for message in assemble(line, unchecked=True):
            found[message.build()[2:]] = message.build()
    for item in ev3proto.read(REAL):
        if isinstance(item, Record) and item.message.type is not None and item.message.type.is_command:
            found.setdefault(item.message.build()[4:], item.message.build())
    return [frame for frame in found.values() if is_clean(frame) and len(frame) < 200]


def cases(count: int, seed: int = 9) -> Iterator[Case]:
    """Yields different wrong frames of each kind, at most `count`; not those that are right in another sense."""
    for kind, make in SLIPS.items():
        rng, seen = Random(f"{seed}{kind}"), {*frames()}
        for _ in range(40 * count):
            right = rng.choice(frames())
            made = make(right, rng)
            if made is not None and made[0] not in seen and not is_clean(made[0]):
                seen.add(made[0])
                yield Case(kind, right, made[0], range(*made[1:]))
            if len(seen) == len(frames()) + count:
                break


# The slips


def changed(frame: bytes, at: int, size: int, new: bytes = b"", *, is_counted: bool = True) -> bytes:
    """Returns a frame with other bytes at a place, with a length that fits unless it is not counted."""
    made = frame[:at] + new + frame[at + size :]
    return with_length(made[2:]) if is_counted else made


def is_direct(frame: bytes) -> bool:
    return frame[4] in (0x00, 0x80)


def operations(frame: bytes) -> tuple[Operation, ...]:
    message = ev3proto.parse(frame)
    return message.operations if isinstance(message, DirectCommand) else ()


def argument(
    frame: bytes, rng: Random, keep: Callable[[Argument], bool] = lambda _: True
) -> tuple[Operation, Argument] | None:
    """Returns one of the arguments for which `keep` is true."""
    found = [(one, each) for one in operations(frame) for each in one.arguments if keep(each)]
    return rng.choice(found) if found else None


@slip
def length_left_out(frame: bytes, _: Random) -> Wrong:
    return frame[2:], 0, 2


@slip
def length_counts_itself(frame: bytes, _: Random) -> Wrong:
    return struct.pack("<H", len(frame)) + frame[2:], 0, 2


@slip
def length_swapped(frame: bytes, _: Random) -> Wrong:
    return frame[1::-1] + frame[2:], 0, 2


@slip
def length_stale(frame: bytes, rng: Random) -> Wrong:
    return struct.pack("<H", len(frame) - 2 + rng.choice((-3, -2, -1, 1, 2, 3))) + frame[2:], 0, 2


@slip
def length_in_decimal(frame: bytes, _: Random) -> Wrong:
    return bytes((int(str(len(frame) - 2)[-2:], 16), 0)) + frame[2:], 0, 2


@slip
def length_of_four_bytes(frame: bytes, _: Random) -> Wrong:
    return struct.pack("<I", len(frame) - 2) + frame[2:], 0, 4


@slip
def line_end_behind(frame: bytes, rng: Random) -> Wrong:
    return frame + rng.choice((b"\n", b"\r\n", b"\0")), len(frame) - 1, len(frame) + 2


@slip
def report_number_in_front(frame: bytes, _: Random) -> Wrong:
    return b"\0" + frame, 0, 1


@slip
def counter_left_out(frame: bytes, _: Random) -> Wrong:
    return changed(frame, 2, 2), 0, 5


@slip
def type_wrong(frame: bytes, rng: Random) -> Wrong:
    others = {0x00: (0x01, 0x02), 0x80: (0x81, 0x08, 0x01), 0x01: (0x00, 0x10, 0x80), 0x81: (0x80, 0x18, 0x00)}
    return changed(frame, 4, 1, bytes((rng.choice(others[frame[4]]),))), 4, 5


@slip
def reply_not_asked(frame: bytes, _: Random) -> Wrong:
    has_results = frame[4] == 0 and any(one.has_outputs for one in operations(frame))
    return (changed(frame, 4, 1, b"\x80"), 4, 5) if has_results else None


@slip
def memory_left_out(frame: bytes, _: Random) -> Wrong:
    return (changed(frame, 5, 2), 4, 7) if is_direct(frame) else None


@slip
def memory_swapped(frame: bytes, _: Random) -> Wrong:
    return (changed(frame, 5, 2, frame[6:4:-1]), 5, 7) if is_direct(frame) and frame[5] != frame[6] else None


@slip
def memory_too_small(frame: bytes, rng: Random) -> Wrong:
    word = int.from_bytes(frame[5:7], "little")
    shared, local = word & 1023, word >> 10
    if not is_direct(frame) or not word:
        return None
    if shared:
        shared = rng.choice((0, shared // 2, shared - 1))
    else:
        local = rng.choice((0, local - 1))
    return changed(frame, 5, 2, struct.pack("<H", shared | local << 10)), 5, 7


@slip
def locals_not_shifted(frame: bytes, _: Random) -> Wrong:
    is_local = is_direct(frame) and frame[6] > 3 and not frame[6] & 3
    return (changed(frame, 6, 1, bytes((frame[6] >> 2,))), 5, 7) if is_local else None


@slip
def argument_left_out(frame: bytes, rng: Random) -> Wrong:
    found = argument(frame, rng)
    if found is None:
        return None
    operation, one = found
    end = operation.offset + operation.length - one.length + 1
    return changed(frame, one.offset, one.length), operation.offset, end


@slip
def two_arguments_left_out(frame: bytes, rng: Random) -> Wrong:
    found = [one for one in operations(frame) if len(one.arguments) > 1]
    if not found:
        return None
    operation = rng.choice(found)
    first, second = sorted(rng.sample(operation.arguments, 2), key=lambda one: one.offset)
    without = changed(frame, second.offset, second.length)
    return changed(without, first.offset, first.length), operation.offset, operation.offset + operation.length


@slip
def argument_twice(frame: bytes, rng: Random) -> Wrong:
    found = argument(frame, rng)
    if found is None:
        return None
    operation, one = found
    end = operation.offset + operation.length + one.length
    return changed(frame, one.offset, 0, one.raw), operation.offset, end


@slip
def neighbours_swapped(frame: bytes, rng: Random) -> Wrong:
    pairs = [
        (one, other)
        for each in operations(frame)
        for one, other in zip(each.arguments, each.arguments[1:], strict=False)
        if one.raw != other.raw
    ]
    if not pairs:
        return None
    one, other = rng.choice(pairs)
    end = other.offset + other.length
    return changed(frame, one.offset, end - one.offset, other.raw + one.raw), one.offset, end


@slip
def results_left_out(frame: bytes, rng: Random) -> Wrong:
    """As a library does it that returns values by itself."""
    found = [one for one in operations(frame) if one.arguments and one.arguments[-1].parameter.is_output]
    if not found or int.from_bytes(frame[5:7], "little") & 1023 == 0 or len(operations(frame)) > 1:
        return None
    first = next(one for one in rng.choice(found).arguments if one.parameter.is_output)
    return changed(frame, first.offset, len(frame)), first.offset - 1, first.offset + 1


@slip
def cmd_third(frame: bytes, rng: Random) -> Wrong:
    """As LEGO's Communication Developer Kit prints it."""
    found = [one for one in operations(frame) if one.command and one.full_name.startswith("INPUT_DEVICE.")]
    at = rng.choice(found).offset + 1 if found else 0
    is_short = found and all(byte < 32 for byte in frame[at : at + 3]) and len(found[0].arguments) > 2
    return (changed(frame, at, 3, frame[at + 1 : at + 3] + frame[at : at + 1]), at, at + 3) if is_short else None


@slip
def header_in_another_order(frame: bytes, rng: Random) -> Wrong:
    if not is_direct(frame):
        return frame[:2] + frame[4:6] + frame[2:4] + frame[6:], 2, 6
    if rng.random() < 0.5:
        return frame[:4] + frame[5:7] + frame[4:5] + frame[7:], 4, 7
    return frame[:2] + frame[4:5] + frame[2:4] + frame[5:], 2, 5


@slip
def prefix_of_hex_forgotten(frame: bytes, _: Random) -> Wrong:
    """The digits of hex are taken for decimals; those with a letter stay, and texts are written as such."""
    if any(one.kind == "string" for each in operations(frame) for one in each.arguments) or frame[5] > 0x90:
        return None
    return bytes(int(text) if (text := f"{byte:x}").isdecimal() else byte for byte in frame), 0, len(frame)


@slip
def cmd_left_out(frame: bytes, rng: Random) -> Wrong:
    found = [one for one in operations(frame) if one.command]
    at = rng.choice(found).offset if found else 0
    return (changed(frame, at + 1, 1), at, at + 2) if found else None


def _of_argument(
    keep: Callable[[Argument], bool], new: Callable[[Argument], bytes]
) -> Callable[[bytes, Random], Wrong]:
    """Returns the slip that writes one argument in another way."""

    def make(frame: bytes, rng: Random) -> Wrong:
        found = argument(frame, rng, keep)
        if found is None:
            return None
        _, one = found
        return changed(frame, one.offset, one.length, new(one)), one.offset, one.offset + one.length

    return make


def _is(*encodings: str) -> Callable[[Argument], bool]:
    return lambda one: one.encoding in encodings


def _is_whole_float(one: Argument) -> bool:
    return isinstance(one.value, float) and one.value == round(one.value) != 0


def _is_wide(one: Argument) -> bool:
    return one.encoding in ("GV0", "LV0") and one.parameter.type.size > 1


def _is_negative(one: Argument) -> bool:
    return one.encoding == "LC1" and isinstance(one.value, int) and one.value < 0


def _is_result(one: Argument) -> bool:
    return one.encoding in ("GV0", "LV0") and one.parameter.is_output


SLIPS |= {
    "raw_byte": _of_argument(_is("LC1", "LC2"), lambda one: one.raw[1:]),
    "number_swapped": _of_argument(_is("LC2", "LC4"), lambda one: one.raw[:1] + one.raw[:0:-1]),
    "lc1_for_lc2": _of_argument(_is("LC2"), lambda one: b"\x81" + one.raw[1:]),
    "lc2_for_lc1": _of_argument(_is("LC1"), lambda one: b"\x82" + one.raw[1:]),
    "text_zero_missing": _of_argument(_is("LCS"), lambda one: one.raw[:-1]),
    "text_id_missing": _of_argument(_is("LCS"), lambda one: one.raw[1:]),
    "text_with_length": _of_argument(_is("LCS"), lambda one: bytes((one.length - 2,)) + one.raw[1:]),
    "int_for_float": _of_argument(_is_whole_float, lambda one: encode_integer(round(float(one.value)))),
    "float_raw": _of_argument(_is_whole_float, lambda one: one.raw[1:]),
    "sign_not_extended": _of_argument(_is_negative, lambda one: b"\x82" + one.raw[1:] + b"\0"),
    "variable_unaligned": _of_argument(_is_wide, lambda one: bytes((one.raw[0] + 1,))),
    "constant_for_variable": _of_argument(_is_result, lambda one: bytes((one.raw[0] & 0x1F,))),
    "variable_with_81": _of_argument(_is_result, lambda one: b"\x81" + one.raw),
}


def _everywhere(keep: Callable[[Argument], bool], new: Callable[[bytes], bytes]) -> Callable[[bytes, Random], Wrong]:
    """Returns the slip that writes all arguments of a kind in another way, two or more."""

    def make(frame: bytes, _: Random) -> Wrong:
        found = [each for one in operations(frame) for each in one.arguments if keep(each)]
        wrong = frame
        for one in reversed(found):
            wrong = changed(wrong, one.offset, one.length, new(one.raw))
        return (wrong, found[0].offset, len(wrong)) if len(found) > 1 else None

    return make


SLIPS |= {
    "layer_never": _everywhere(lambda one: one.name == "LAYER", lambda _: b""),
    "raw_always": _everywhere(_is("LC1", "LC2"), lambda raw: raw[1:]),
    "big_endian_always": _everywhere(_is("LC2"), lambda raw: raw[:1] + raw[:0:-1]),
}


@slip
def byte_lost(frame: bytes, rng: Random) -> Wrong:
    at = rng.randrange(2, len(frame))
    return changed(frame, at, 1, is_counted=False), at - 1, at + 1


@slip
def digit_wrong(frame: bytes, rng: Random) -> Wrong:
    at = rng.randrange(4, len(frame))
    other = frame[at] ^ rng.randrange(1, 16) << rng.choice((0, 4))
    return changed(frame, at, 1, bytes((other,))), at, at + 1


@slip
def byte_doubled(frame: bytes, rng: Random) -> Wrong:
    at = rng.randrange(2, len(frame))
    return changed(frame, at, 0, frame[at : at + 1], is_counted=False), at, at + 2


@slip
def system_field_left_out(frame: bytes, rng: Random) -> Wrong:
    message = ev3proto.parse(frame)
    if not isinstance(message, SystemCommand):
        return None
    at, found = 6, []
    for field in SYSTEM_BY_NUMBER[message.number].request:
        size = {FieldKind.U8: 1, FieldKind.U16: 2, FieldKind.U32: 4}.get(field.kind)
        if size is None:
            break
        found.append((at, size))
        at += size
    at, size = rng.choice(found) if found else (0, 0)
    return (changed(frame, at, size), at - 1, at + size) if found else None


@slip
def went_through_utf8(frame: bytes, _: Random) -> Wrong:
    return frame.decode("latin-1").encode(), 0, len(frame)


# Judging


def is_right(case: Case, said: Suggestion) -> bool:
    """Returns whether a suggestion is what was meant, but for its unknown bytes; more or less memory serves as well."""
    right, frame = case.right, said.frame
    if is_direct(right) and frame[2:5] + frame[7:] == right[2:5] + right[7:]:
        return True
    for at, size in said.unknown:
        head, tail = frame[2:at], frame[at + size :]
        if len(head) >= 5:
            head = head[:3] + right[5:7] + head[5:]
        if right[2:].startswith(head) and right.endswith(tail) and len(right) >= len(head) + len(tail) + 2:
            return True
    return frame == right


def judged(case: Case) -> Counter[str]:
    """Returns what is true of what is said about a case."""
    said = check(case.wrong, alone=True).nearest
    if not said:
        return Counter(cases=1, silent=1)
    first, is_value = said[0], any(is_right(case, one) for one in said)
    is_near = first.offset <= case.place.stop and first.offset + max(first.length, 1) >= case.place.start
    is_near |= first.offset < 2 and case.kind in ("byte_lost", "byte_doubled")  # the length does not fit, either
    return Counter(
        cases=1,
        right=first.frame == case.right,
        value=is_value,
        misleading=not is_value and not is_near,
        fixed=first.is_sure,
        wrongly=first.is_sure and not is_right(case, first),
    )


def table(count: int) -> Iterator[tuple[str, Counter[str]]]:
    """Yields what is true of the cases of each kind, in numbers, and at last of all."""
    rows = {kind: Counter[str]() for kind in SLIPS}
    for case in cases(count):
        rows[case.kind] += judged(case)
    yield from rows.items()
    yield "all", sum(rows.values(), Counter())


def main(argument: str) -> None:
    """Prints the table, or the cases of one kind without the right suggestion."""
    if argument in SLIPS:
        for case in cases(50):
            if case.kind == argument and not judged(case)["value"]:
                print(f"right {case.right.hex(' ')}\nwrong {case.wrong.hex(' ')}")
                for one in check(case.wrong, alone=True).nearest:
                    print(f"  {one.message}: {one.frame.hex(' ')}")
        return
    names = ("right", "value", "misleading", "silent", "fixed", "wrongly")
    print(f"{'slip':24} cases" + "".join(f"{name:>11}" for name in names) + "  in %")
    for kind, row in table(int(argument)):
        print(
            f"{kind:24} {row['cases']:5}" + "".join(f"{100 * row[name] / max(row['cases'], 1):11.0f}" for name in names)
        )


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "50")

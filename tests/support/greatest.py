"""Every handler of the virtual brick with the greatest arguments that the limits let through, on the fullest folder.

As a program, it runs all of them in its own process, and prints for each frame a line: the CPU seconds until another
client's question about the battery is answered, the most memory in KiB that the process had meanwhile, and the name.
"""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Iterator
from itertools import groupby
from operator import itemgetter
from pathlib import Path

from ev3proto import GV, LV
from ev3proto.brick import Brick
from ev3proto.brick.dispatch import coverage
from ev3proto.brick.limits import STRETCH
from ev3proto.messages import Variable
from ev3proto.tables import operations
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import LOCAL
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration
from support.bricks import command, op

BATTERY = command(op("UI_READ.GET_LBATT", GV(0)), globals=1, counter=99)
FILES = 900
LARGE = 5_000_000
FULL = "../prjs/Full"
PATHS = (FULL, "a/" * 15_000, "../prjs/large.rtf")

ARRAY = Variable(LOCAL, 0, handle=True)
"""The array that a command creates first."""

OPERATIONS = [name for name, is_handled in coverage() if is_handled]
WITHOUT_FILES = {
    name
    for name in OPERATIONS
    if not name.startswith("FILE") and not any(one.most for one in operations()[name].parameters)
}
SYSTEM_COMMANDS = [entry for entry in SYSTEM if not entry.bootloader]


def fill(folder: Path) -> None:
    """Makes the fullest folder, a large file, and a large program, unless they are there."""
    full = folder / "prjs/Full"
    full.mkdir(parents=True, exist_ok=True)
    if len(os.listdir(full)) < FILES:  # noqa: PTH208 - in a tenth of the time of iterdir
        for number in range(FILES):
            with open(f"{full}/f{number:05}.rtf", "wb") as file:  # noqa: PTH123 - as above
                file.write(b"x")
    for path in (folder / "prjs").iterdir():
        if path.name not in ("Full", "large.rtf", "large.rbf"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    (folder / "prjs/large.rtf").write_bytes(bytes(1_000_000))
    # One object, whose operations are NOP.
    codes = b"\1" * 400_000 + b"\x0a"
    head = (len(codes) + 28).to_bytes(4, "little") + bytes.fromhex("6800 0100 00000000 1c000000 0000 0000 00000000")
    (folder / "prjs/large.rbf").write_bytes(b"LEGO" + head + codes)


# What is sent

NUMBERS = {"most": (127, 32767, 2**31 - 1), "least": (-127, -32767, -(2**31) + 1), "fitting": (100, 32000, LARGE)}

PREPARED = {
    "PROGRAM_START": [
        op("FILE.LOAD_IMAGE", 1, "../prjs/large.rbf", LV(8), LV(12)),
        op("PROGRAM_START", 1, LV(8), LV(12), 0),
    ],
    "FILENAME.UNPACK": [op("FILENAME.PACK", FULL), op("FILENAME.UNPACK", FULL)],
    "FILE.MOVE": [op("FILE.MOVE", FULL, "../prjs/Copy")],
}
"""Commands whose greatest arguments do not follow from the declaration."""


def value_of(parameter: Parameter, size: str) -> object:
    """Returns the greatest argument, or the least one, for a parameter."""
    small, middle, large = NUMBERS[size]
    if parameter.direction is not Direction.IN or parameter.stores:
        return LV(16)
    if parameter.type is Type.STRING:
        if parameter.role is Role.FORMAT:
            return "%4095d" * 100
        return FULL if parameter.most is not None else ARRAY
    if parameter.length is not None:
        return ARRAY
    numbers = {Type.DATA8: small, Type.DATA16: middle, Type.DATA32: large, Type.HANDLE: LV(0), Type.DATAF: 3.0e38}
    return numbers.get(parameter.type, 1)


def codes_of(declaration: Declaration) -> Iterator[list[bytes]]:
    """Returns the operations of commands: an array as large as it may be, if it is used, then the operation."""
    if declaration.name in PREPARED:
        yield PREPARED[declaration.name]
        return
    for size in NUMBERS:
        values: list[object] = [value_of(parameter, size) for parameter in declaration.fixed]
        if declaration.tail is not None:
            counts_others = declaration.fixed[-1] is not declaration.parameters[-1]
            at = declaration.fixed.index(declaration.tail.counter)
            values[at:] = [*([8] if counts_others else []), [LV(16)] * 8]
        code = op(declaration.name, *values)
        if ARRAY in values:
            yield from ([op("ARRAY.CREATE8", LARGE, LV(0)), op("ARRAY.FILL", LV(0), one), code] for one in b"1\r/")
        else:
            yield [code]


def system_frame(entry: SystemDeclaration, path: str) -> bytes:
    """Returns the frame of a system command with the greatest numbers, and a path."""
    greatest: dict[FieldKind, int | str] = {
        FieldKind.U8: 255,
        FieldKind.U16: 65535,
        FieldKind.U32: 2**32 - 1,
        FieldKind.TEXT: path,
        FieldKind.COUNTED_TEXT: "n" * 200,
    }
    sizes = {255: 1, 65535: 2, 2**32 - 1: 4}
    body = bytes((1, 0, 1, entry.number))
    for field in entry.request:
        value = greatest.get(field.kind)
        if isinstance(value, int):
            body += value.to_bytes(sizes[value], "little")
        else:
            body += bytes(16) if value is None else value.encode() + b"\0"
    return len(body).to_bytes(2, "little") + body


FILLED = [op("ARRAY.CREATE8", LARGE, LV(0)), op("ARRAY.FILL", LV(0), ord("/"))]

GREEDY: dict[str, list[bytes]] = {
    "arrays": [*FILLED, op("ARRAY.CREATE8", 900_000, LV(2))],
    "a format": [op("ARRAY.CREATE8", 100, LV(2)), op("STRINGS.NUMBER_FORMATTED", 1, "%99999999d" * 25, -1, ARRAY)],
    "images": [op("FILE.LOAD_IMAGE", 1, "../prjs/large.rbf", LV(8), LV(12))] * 40,
    "a long path": [
        *[op("ARRAY.CREATE8", LARGE, LV(0)), op("ARRAY.FILL", LV(0), 47)],
        op("FILE.GET_FOLDERS", ARRAY, LV(8)),
    ],
    "a text": [*FILLED, op("UI_WRITE.PUT_STRING", ARRAY)],
}
"""Commands of several operations that together want much memory."""


def cases() -> Iterator[tuple[str, bytes]]:
    """Returns the frames of all handlers, each with the handler's name."""
    for name in OPERATIONS:
        frames = (command(*code, globals=64, locals=63) for code in codes_of(operations()[name]))
        yield from ((name, frame) for frame in dict.fromkeys(frames))
    for entry in SYSTEM_COMMANDS:
        yield from ((entry.name, frame) for frame in dict.fromkeys(system_frame(entry, path) for path in PATHS))
    yield from ((name, command(*code, locals=63)) for name, code in GREEDY.items())


def cpu_seconds_until_the_battery_is_answered(brick: Brick, frame: bytes) -> float:
    """Sends a frame, then another client's question. Returns how long that waits; 0 where the brick itself waits."""
    begin = time.thread_time()
    brick.receive_from("client", frame)
    replies = brick.receive_from("other", BATTERY)
    while not any(reply.channel == "other" for reply in replies):
        if brick.is_busy and not brick.is_computing:
            brick.end_command()
            return 0.0
        replies += brick.advance_all(0.001)
        if time.thread_time() - begin > 10:
            break
    waited = time.thread_time() - begin
    while brick.is_computing:
        brick.advance_all(0.001)
    return waited


def peak(is_begin: bool = False) -> int:
    """Returns the most memory in KiB that this process has had since the last beginning, or begins anew."""
    if is_begin:
        Path("/proc/self/clear_refs").write_text("5")
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM"))


def main(root: Path) -> None:
    """Runs all handlers in a folder."""
    for name, frames in groupby(cases(), key=itemgetter(0)):
        if name not in WITHOUT_FILES:
            fill(root)
        # A new brick counts all files, which takes longer than most handlers.
        brick = Brick(None if name in WITHOUT_FILES else root, stretch=STRETCH)
        for _, frame in frames:
            peak(is_begin=True)
            seconds = cpu_seconds_until_the_battery_is_answered(brick, frame)
            print(f"{seconds:.3f}\t{peak()}\t{name}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))

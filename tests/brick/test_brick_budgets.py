"""No operation and no system command keeps other clients waiting for long, whatever its arguments are.

Each one, from the tables, gets the greatest arguments that the limits let through, on the fullest folder, while another
client asks for the battery. Operations that wait for time, a button or a motor block a brick, as in the firmware.
"""

from __future__ import annotations

import time
import tracemalloc
from pathlib import Path

import pytest
from support.bricks import command, op
from support.cases import each

from ev3proto import GV, LV
from ev3proto.brick import Brick
from ev3proto.brick.dispatch import coverage
from ev3proto.brick.servers.limits import STRETCH
from ev3proto.messages import Variable
from ev3proto.tables import operations
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import LOCAL
from ev3proto.tables.system import SYSTEM, Kind, SystemDeclaration

BATTERY = command(op("UI_READ.GET_LBATT", GV(0)), globals=1, counter=99)
FILES = 9_900
LARGE = 5_000_000
FULL = "../prjs/Full"

MOST_SECONDS = 0.3
"""CPU seconds until the battery is answered."""

MOST_MEMORY = 200 << 20

ARRAY = Variable(LOCAL, 0, handle=True)
"""The array that each command creates first."""


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("budgets")
    fill(folder)
    return folder


def fill(folder: Path) -> None:
    """Makes the fullest folder, a large file, and a large program, unless they are there."""
    full = folder / "prjs/Full"
    full.mkdir(parents=True, exist_ok=True)
    if len(list(full.iterdir())) < FILES:
        for number in range(FILES):
            (full / f"f{number:05}.rtf").write_bytes(b"x")
    for path in (folder / "prjs").iterdir():
        if path.name not in ("Full", "large.rtf", "large.rbf"):
            _remove(path)
    (folder / "prjs/large.rtf").write_bytes(bytes(1_000_000))
    # One object, whose operations are NOP.
    codes = b"\1" * 1_000_000 + b"\x0a"
    head = (len(codes) + 28).to_bytes(4, "little") + bytes.fromhex("6800 0100 00000000 1c000000 0000 0000 00000000")
    (folder / "prjs/large.rbf").write_bytes(b"LEGO" + head + codes)


def _remove(path: Path) -> None:
    if path.is_dir():
        for below in path.iterdir():
            _remove(below)
        path.rmdir()
    else:
        path.unlink()


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


def code_of(declaration: Declaration, size: str, filler: int) -> list[bytes]:
    """Returns the operations of a command: an array as large as it may be, then the operation with it."""
    array = [op("ARRAY.CREATE8", LARGE, LV(0)), op("ARRAY.FILL", LV(0), filler)]
    prepared = PREPARED.get(declaration.name)
    if prepared is not None:
        return prepared
    values: list[object] = [value_of(parameter, size) for parameter in declaration.fixed]
    if declaration.tail is not None:
        counts_others = declaration.fixed[-1] is not declaration.parameters[-1]
        at = declaration.fixed.index(declaration.tail.counter)
        values[at:] = [*([8] if counts_others else []), [LV(16)] * 8]
    return [*array, op(declaration.name, *values)]


def cpu_seconds_until_the_battery_is_answered(brick: Brick, frame: bytes) -> float:
    """Sends a frame, then another client's question. Returns how long that waits; 0 where the brick itself waits."""
    brick.receive_from("client", frame)
    begin = time.thread_time()
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


HANDLED = [name for name, is_handled in coverage() if is_handled]
OF_FILES = [
    name for name in HANDLED if name.startswith("FILE") or any(one.most for one in operations()[name].parameters)
]


@each("name", [name for name in HANDLED if name not in OF_FILES])
def test_operations(name: str) -> None:
    for size in NUMBERS:
        for filler in b"1\r":
            frame = command(*code_of(operations()[name], size, filler), globals=64, locals=63)
            assert cpu_seconds_until_the_battery_is_answered(Brick(stretch=STRETCH), frame) < MOST_SECONDS


@each("name", OF_FILES)
def test_operations_on_the_fullest_folder(name: str, root: Path) -> None:
    fill(root)
    frame = command(*code_of(operations()[name], "most", ord("/")), globals=64, locals=63)
    assert cpu_seconds_until_the_battery_is_answered(Brick(root, stretch=STRETCH), frame) < MOST_SECONDS


@each("entry", [entry for entry in SYSTEM if not entry.bootloader])
def test_system_commands(entry: SystemDeclaration, root: Path) -> None:
    fill(root)
    brick = Brick(root, stretch=STRETCH)
    for path in (FULL, "a/" * 15_000, "../prjs/large.rtf"):
        greatest = {Kind.U8: 255, Kind.U16: 65535, Kind.U32: 2**32 - 1, Kind.TEXT: path, Kind.COUNTED_TEXT: "n" * 200}
        fields = [greatest.get(field.kind, bytes(16)) for field in entry.request]
        frame = system_frame(entry.number, fields)
        assert cpu_seconds_until_the_battery_is_answered(brick, frame) < MOST_SECONDS


def system_frame(number: int, fields: list[object]) -> bytes:
    sizes = {255: 1, 65535: 2, 2**32 - 1: 4}
    body = bytes((1, 0, 1, number))
    for value in fields:
        if isinstance(value, int):
            body += value.to_bytes(sizes[value], "little")
        else:
            body += value.encode() + b"\0" if isinstance(value, str) else bytes(16)
    return len(body).to_bytes(2, "little") + body


FILLED = [op("ARRAY.CREATE8", LARGE, LV(0)), op("ARRAY.FILL", LV(0), ord("/"))]

GREEDY = {
    "arrays": [*FILLED, op("ARRAY.CREATE8", 900_000, LV(2))],
    "a format": [op("ARRAY.CREATE8", 100, LV(2)), op("STRINGS.NUMBER_FORMATTED", 1, "%99999999d" * 25, -1, ARRAY)],
    "images": [op("FILE.LOAD_IMAGE", 1, "../prjs/large.rbf", LV(8), LV(12))] * 40,
    "a program": PREPARED["PROGRAM_START"],
    "an archive": [op("FILENAME.PACK", FULL)],
    "a long path": [
        *[op("ARRAY.CREATE8", LARGE, LV(0)), op("ARRAY.FILL", LV(0), 47)],
        op("FILE.GET_FOLDERS", ARRAY, LV(8)),
    ],
    "a text": [*FILLED, op("UI_WRITE.PUT_STRING", ARRAY)],
}


@each("name", GREEDY)
def test_memory(name: str, root: Path) -> None:
    fill(root)
    brick = Brick(root)
    tracemalloc.start()
    try:
        brick.receive(command(*GREEDY[name], locals=63))
        assert tracemalloc.get_traced_memory()[1] < MOST_MEMORY
    finally:
        tracemalloc.stop()

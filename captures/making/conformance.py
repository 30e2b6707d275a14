"""300 harmless conversations from all areas: they show where a real brick answers differently than the virtual one.

No motor turns, no file is written or deleted, no setting changes, nothing is drawn or played.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from itertools import chain

from ev3proto import system
from ev3proto.brick import Brick
from ev3proto.messages import Message
from ev3proto.text.assembly import assemble
from making.files import SECOND, Wire
from making.wifi import Connection

_PACE, _TICK = 100_000, 2_000
"""Microseconds between commands, and between checks for a reply."""

_TYPES = {"8": "DATA8", "16": "DATA16", "32": "DATA32", "F": "DATAF"}
_PAIRS = {"8": ((7, 5), (-100, 3)), "16": ((1000, 7), (-30000, 2)), "32": ((100000, 70), (-2000000000, 3))}
_SINGLE = "7.5F, 2.5F"


def _numbers() -> Iterator[str]:
    """Arithmetic, bits, moves from type to type, comparisons."""
    for name in ("ADD", "SUB", "MUL", "DIV"):
        for width, pairs in _PAIRS.items():
            for left, right in pairs:
                yield f"{_TYPES[width]} x\n{name}{width}({left}, {right}, x)"
        yield f"DATAF x\n{name}F({_SINGLE}, x)"
    for name in ("OR", "AND", "XOR", "RL"):
        for width, pairs in _PAIRS.items():
            left, right = pairs[0]
            yield f"{_TYPES[width]} x\n{name}{width}({left}, {right}, x)"
    for source in _TYPES:
        for target in _TYPES:
            for value in ("100.5F", "-1000000.0F") if source == "F" else ("-100", "127"):
                yield f"{_TYPES[target]} x\nMOVE{source}_{target}({value}, x)"
    for name in ("LT", "GT", "EQ", "NEQ", "LTEQ", "GTEQ"):
        for width in ("8", "32"):
            left, right = _PAIRS[width][1]
            yield f"DATA8 x\nCP_{name}{width}({left}, {right}, x)"
        yield f"DATA8 x\nCP_{name}F(1.5F, 1.5F, x)"
    for width, kind in _TYPES.items():
        values = "1.5F, 2.5F" if width == "F" else "11, 22"
        yield f"{kind} x\nSELECT{width}(0, {values}, x)"
        yield f"{kind} x\nSELECT{width}(1, {values}, x)"


def _functions() -> Iterator[str]:
    """MATH."""
    for name in ("EXP", "FLOOR", "CEIL", "ROUND", "ABS", "NEGATE", "SQRT", "LOG", "LN", "SIN", "COS", "TAN", "ATAN"):
        yield f"DATAF x\nMATH({name}, 2.75F, x)"
    for name in ("FLOOR", "CEIL", "ROUND", "ABS", "NEGATE", "SQRT", "LOG", "LN", "SIN"):
        yield f"DATAF x\nMATH({name}, -2.5F, x)"
    for name in ("ASIN", "ACOS"):
        yield f"DATAF x\nMATH({name}, 0.5F, x)"
    for left, right in (("7.5F", "2.0F"), ("-7.5F", "2.0F")):
        yield f"DATAF x\nMATH(MOD, {left}, {right}, x)"
        yield f"DATAF x\nMATH(POW, {left}, {right}, x)"
        yield f"DATAF x\nMATH(TRUNC, {left}, 0, x)"
    for width in ("8", "16", "32"):
        yield f"{_TYPES[width]} x\nMATH(MOD{width}, -17, 5, x)"


def _jumps() -> Iterator[str]:
    """Jumps that are taken, and jumps that are not."""
    for name, values in (
        ("JR_FALSE", "0"),
        ("JR_TRUE", "0"),
        ("JR_NAN", "1.5F"),
        ("JR_LT8", "-1, 1"),
        ("JR_GT16", "-1, 1"),
        ("JR_EQ32", "70000, 70000"),
        ("JR_NEQF", "1.0F, 1.0F"),
        ("JR_LTEQ8", "5, 5"),
        ("JR_GTEQ16", "5, 6"),
    ):
        yield f"DATA8 x\nMOVE8_8(1, x)\n{name}({values}, end)\nMOVE8_8(2, x)\nend:"


def _texts() -> Iterator[str]:
    """Texts and notes."""
    for text in ("", "a", "myEV3", "\\n", "a b"):
        yield f"DATA16 x\nSTRINGS(GET_SIZE, '{text}', x)"
    for left, right in (("a", "a"), ("a", "b"), ("abc", "ab"), ("", "")):
        yield f"DATA8 x\nSTRINGS(COMPARE, '{left}', '{right}', x)"
    for value in ("1.5", "-20", "1e3", "x", "", " 7"):
        yield f"DATAF x\nSTRINGS(STRING_TO_VALUE, '{value}', x)"
    for value, figures, decimals in (("3.14159F", 5, 2), ("-1.5F", 6, 1), ("1000.0F", 3, 0), ("0.0F", 4, 4)):
        yield f"DATAS x 20\nSTRINGS(VALUE_TO_STRING, {value}, {figures}, {decimals}, x)"
    for number, figures in ((42, 5), (-7, 4), (12345, 3)):
        yield f"DATAS x 20\nSTRINGS(NUMBER_TO_STRING, {number}, {figures}, x)"
    yield "DATAS x 20\nSTRINGS(ADD, 'my', 'EV3', x)"
    yield "DATAS x 20\nSTRINGS(DUPLICATE, 'myEV3', x)"
    yield "DATAS x 20\nSTRINGS(STRIP, ' a b ', x)"
    yield "DATAS x 20\nSTRINGS(SUB, 'myEV3', 'EV', x)"
    yield "DATAS x 10\nSTRINGS(VALUE_FORMATTED, 2.5F, '%6.2f', 10, x)"
    yield "DATAS x 10\nSTRINGS(NUMBER_FORMATTED, 255, '%04x', 10, x)"
    for note in ("C4", "A4", "D#5", "H9"):
        yield f"DATA16 x\nNOTE_TO_FREQ('{note}', x)"


def _memory() -> Iterator[str]:
    """Arrays, memory, ports, timers."""
    for width in ("8", "16", "32", "F"):
        yield f"HANDLE h\nDATA32 n\nARRAY(CREATE{width}, 3, h)\nARRAY(SIZE, h, n)"
    yield "HANDLE h\nDATA8 x\nARRAY(CREATE8, 3, h)\nARRAY(FILL, h, 7)\nARRAY_READ(h, 2, x)"
    yield "HANDLE h\nDATA8 x\nARRAY(CREATE8, 3, h)\nARRAY_WRITE(h, 1, 9)\nARRAY_READ(h, 1, x)"
    yield "HANDLE h\nDATA32 n\nARRAY(CREATE8, 3, h)\nARRAY_APPEND(h, 9)\nARRAY(SIZE, h, n)"
    yield "HANDLE h\nDATA32 n\nARRAY(CREATE8, 3, h)\nARRAY(RESIZE, h, 9)\nARRAY(SIZE, h, n)"
    yield "HANDLE h\nDATA8 x\nARRAY(CREATE8, 3, h)\nARRAY_READ(h, 3, x)"
    yield "DATA8 x 4\nINIT_BYTES(x, 4, 1, 2, 3, 4)"
    for number in (0, 98):
        yield f"DATA8 a\nDATA8 b\nPORT_CNV_INPUT({number}, a, b)"
        yield f"DATA8 a\nDATA8 b\nDATA8 c\nPORT_CNV_OUTPUT({number}, a, b, c)"
    yield "DATA32 t\nTIMER_WAIT(20, t)\nTIMER_READY(t)"
    yield "DATA32 t\nTIMER_READ(t)"
    yield "DATA32 t\nTIMER_READ_US(t)"
    yield "DATA16 x\nRANDOM(1, 6, x)"
    yield "DATA32 a\nDATA32 b\nMEMORY_USAGE(a, b)"
    for slot in (0, 1, 2):
        yield f"DATA8 x\nPROGRAM_INFO(GET_STATUS, {slot}, x)"
    yield "NOP"


def _states() -> Iterator[str]:
    """The battery, versions, buttons, sensors, motors, sounds, connections."""
    for name in ("GET_VBATT", "GET_IBATT", "GET_TBATT", "GET_IINT", "GET_IMOTOR"):
        yield f"DATAF x\nUI_READ({name}, x)"
    for name in ("GET_LBATT", "GET_SHUTDOWN", "GET_EVENT"):
        yield f"DATA8 x\nUI_READ({name}, x)"
    for name in ("GET_OS_VERS", "GET_HW_VERS", "GET_FW_VERS", "GET_FW_BUILD", "GET_OS_BUILD", "GET_VERSION"):
        yield f"DATAS x 40\nUI_READ({name}, 40, x)"
    yield "DATA8 a\nDATA32 b\nDATA32 c\nUI_READ(GET_SDCARD, a, b, c)"
    yield "DATA8 a\nDATA32 b\nDATA32 c\nUI_READ(GET_USBSTICK, a, b, c)"
    for button in range(7):
        yield f"DATA8 x\nUI_BUTTON(PRESSED, {button}, x)"
    yield "DATA8 x\nSOUND_TEST(x)"
    yield "DATA8 x\nINFO(GET_VOLUME, x)"
    yield "DATA8 x\nINFO(GET_MINUTES, x)"
    yield "DATA8 x\nINFO(GET_ERROR, x)"
    for number in (0, 1, 31):
        yield f"DATAS x 40\nINFO(ERRORTEXT, {number}, 40, x)"
    for port in (0, 1, 2, 3, 16, 17, 18, 19):
        yield f"DATA8 a\nDATA8 b\nINPUT_DEVICE(GET_TYPEMODE, 0, {port}, a, b)"
    for port in (0, 16):
        yield f"DATAS x 20\nINPUT_DEVICE(GET_NAME, 0, {port}, 20, x)"
        yield f"DATAS x 20\nINPUT_DEVICE(GET_SYMBOL, 0, {port}, 20, x)"
        yield f"DATA8 x\nINPUT_DEVICE(GET_CONNECTION, 0, {port}, x)"
        yield f"DATA8 a\nDATA8 b\nDATA8 c\nDATA8 d\nINPUT_DEVICE(GET_FORMAT, 0, {port}, a, b, c, d)"
        yield f"DATA8 a\nDATA8 b\nINPUT_DEVICE(GET_FIGURES, 0, {port}, a, b)"
        yield f"DATAF a\nDATAF b\nINPUT_DEVICE(GET_MINMAX, 0, {port}, a, b)"
        yield f"DATA8 x\nINPUT_READ(0, {port}, 0, -1, x)"
        yield f"DATAF x\nINPUT_READSI(0, {port}, 0, -1, x)"
        yield f"DATA8 x\nINPUT_TEST(0, {port}, x)"
    yield "DATA8 x 20\nDATA8 y\nINPUT_DEVICE_LIST(20, x, y)"
    for motor in range(4):
        yield f"DATA32 x\nOUTPUT_GET_COUNT(0, {motor}, x)"
    yield "DATA8 x\nOUTPUT_TEST(0, 15, x)"
    yield "DATA8 a\nDATA32 b\nOUTPUT_READ(0, 0, a, b)"
    # LC0 lets USB through, which a brick answers with an error.
    for hardware in ("LC0(1)", 2, 3):
        yield f"DATA8 x\nCOM_GET(GET_ON_OFF, {hardware}, x)"
        yield f"DATA8 x\nCOM_GET(GET_PRESENT, {hardware}, x)"
    yield "DATA8 x\nCOM_GET(GET_VISIBLE, 2, x)"
    yield "DATAS x 20\nCOM_GET(GET_BRICKNAME, 20, x)"


def _names() -> Iterator[str]:
    """Names of files, and names without a file."""
    for name in ("../prjs", "../sys", "/none", "../prjs/none/x.rbf"):
        yield f"DATA8 x\nFILENAME(EXIST, '{name}', x)"
    for name in ("a", "ab c", "a.rbf", "a*b"):
        yield f"DATA8 x\nFILENAME(CHECK, '{name}', x)"
    yield "DATAS a 20\nDATAS b 20\nDATAS c 20\nFILENAME(SPLIT, '../prjs/x/y.rbf', 20, a, b, c)"
    yield "DATAS x 40\nFILENAME(MERGE, '../prjs/x', 'y', '.rbf', 40, x)"
    yield "DATAS x 40\nFILENAME(GET_FOLDERNAME, 40, x)"
    yield "HANDLE h\nDATA32 x\nFILE(OPEN_READ, '/none/x.txt', h, x)"
    yield "DATAF x\nFILE(READ_VALUE, 20, 6, x)"
    yield "FILE(CLOSE, 20)"


def _transfers() -> Iterator[Message]:
    """System commands, most of which are refused."""
    for path in ("../prjs/", "../sys/", "/none/"):
        yield system.list_files(path)
    for path in ("/none/x.rbf", "../prjs/none.rbf", "../prjs/*.rbf", "../none/x.rtf"):
        yield system.begin_upload(path)
        yield system.begin_getfile(path)
    for handle in (63, 255):
        yield system.continue_upload(handle)
        yield system.continue_getfile(handle)
        yield system.continue_list_files(handle)
        yield system.close_filehandle(handle)
    yield system.list_open_handles()


def commands() -> list[bytes]:
    """All conversations, in order."""
    texts = chain(_numbers(), _functions(), _jumps(), _texts(), _memory(), _states(), _names())
    direct = (message for text in texts for message in assemble(text, reply=True))
    frames = [message.build() for message in chain(direct, _transfers())]
    return [frame[:2] + number.to_bytes(2, "little") + frame[4:] for number, frame in enumerate(frames, 1)]


def whole() -> Wire:
    """A connection in which the virtual brick answers each command."""
    wire = Wire()
    connection = Connection(wire)
    connection.open()
    connection.unlock()
    with tempfile.TemporaryDirectory() as folder:
        brick = Brick(root=folder)
        brick.equipment.random.seed(1)
        for command in commands():
            begun = wire.now
            connection.write(connection.host, command)
            replies = brick.receive(command)
            while not replies:
                wire.wait(_TICK)
                replies = brick.advance(_TICK / SECOND)
            for reply in replies:
                connection.write(connection.brick, reply)
            wire.wait(begun + _PACE - wire.now)
            brick.advance(_PACE / SECOND)
    connection.close()
    return wire

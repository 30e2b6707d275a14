"""The C header: it compiles without a warning, and what C programs make with it are the codec's bytes."""

from __future__ import annotations

import re
import struct
import subprocess
from functools import cache
from pathlib import Path

import pytest
from support.built import built_export
from support.effort import effort
from support.frames import drawn

from ev3proto import Argument, Operation, direct_command, operation, parse, system_command
from ev3proto.messages import DirectCommand
from ev3proto.schema.argument import encode_as, encode_float, encode_integer, encode_string, encode_variable, with_bits
from ev3proto.tables import OPCODES, enumerations
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, SystemStatus
from ev3proto.testing import raw_operations

GCC = ["gcc", "-std=c99", "-x", "c"]
GXX = ["g++", "-std=c++11", "-x", "c++"]
WARNINGS = ["-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wpadded", "-Werror"]


def run(program: str, folder: Path, compiler: list[str]) -> list[str]:
    """The lines that a program prints."""
    (folder / "ev3proto.h").symlink_to(built_export("ev3proto.h"))
    (folder / "program.c").write_text(program)
    binary = folder / "program"
    words = [*compiler, *WARNINGS, str(folder / "program.c"), "-o", str(binary), "-lm"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120, check=False)
    assert (done.returncode, done.stderr[:2000]) == (0, "")
    return subprocess.run([binary], capture_output=True, text=True, timeout=30, check=True).stdout.splitlines()


HEAD = """\
#include <errno.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "ev3proto.h"

static void show(const uint8_t *bytes, size_t size)
{
    size_t at;
    for (at = 0; at < size; at++)
        printf("%02x", bytes[at]);
    puts("");
}

int main(void)
{
    (void)show;
"""


@pytest.mark.parametrize("compiler", [GCC, GXX])
def test_the_frame_of_the_lesson(tmp_path: Path, compiler: list[str]) -> None:
    program = f"""{HEAD}
    static const uint8_t tone[] = {{
        EV3_HEADER(16, 42, DIRECT_COMMAND_NO_REPLY), EV3_MEMORY(0, 0),
        opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)
    }};
    ev3_frame frame;
    show(tone, sizeof tone);
    ev3_begin_direct(&frame, 42, DIRECT_COMMAND_NO_REPLY, 0, 0);
    ev3_operation(&frame, opSOUND, TONE);
    ev3_integer(&frame, 1);
    ev3_integer(&frame, 440);
    ev3_integer(&frame, 1000);
    show(frame.bytes, ev3_end(&frame));
    return 0;
}}
"""
    assert run(program, tmp_path, compiler) == ["0e002a0080000094010182b80182e803"] * 2


@pytest.mark.parametrize("compiler", [GCC, GXX])
def test_a_small_buffer_for_a_small_processor(tmp_path: Path, compiler: list[str]) -> None:
    """An ATmega has 2 kB of memory; a frame that does not fit is not sent."""
    calls = "ev3_opcode(&frame, opUI_FLUSH); " * 9
    program = f"""#define EV3_MAX_FRAME 16
{HEAD}
    ev3_frame frame;
    printf("%d\\n", (int)sizeof frame);
    ev3_begin_direct(&frame, 42, DIRECT_COMMAND_NO_REPLY, 0, 0);
    {calls}
    show(frame.bytes, ev3_end(&frame));
    ev3_opcode(&frame, opUI_FLUSH);
    printf("%d\\n", (int)ev3_end(&frame));
    return 0;
}}
"""
    assert run(program, tmp_path, compiler) == ["20", "0e002a00800000" + "80" * 9, "0"]


def test_enumerators_fit_into_16_bits() -> None:
    """As an int has them where the processor has 8; compilers warn of others."""
    numbers = [
        int(number, 0)
        for number in re.findall(r"^    \w+ = (-?\w+),", built_export("ev3proto.h").read_text(), re.MULTILINE)
    ]
    assert len(numbers) > 800
    assert [number for number in numbers if not -32768 <= number <= 32767] == []


def macro(argument: Argument) -> str:
    """An argument in the macros; where its first byte has bits that no macro sets, its bytes."""
    plain = encode_as(argument.encoding, "" if argument.kind == "string" else 0)
    if plain[0] > 0x7F:
        plain = with_bits(plain, handle=argument.form.handle, address=argument.form.address)
    if plain[0] != argument.raw[0] and plain[0] > 0x7F:
        return ", ".join(f"0x{byte:02X}" for byte in argument.raw)
    value = argument.value
    if isinstance(value, str):
        text = ", ".join([argument.encoding, *(f"0x{byte:02X}" for byte in argument.raw[1:])])
    elif isinstance(value, float):
        is_exact = value == value and abs(value) != float("inf")
        text = f"LCF({value!r})" if is_exact else f"LC4(0x{struct.unpack('<I', argument.raw[1:])[0]:08X}u)"
    else:
        text = f"{argument.encoding}({value if value > -(2**31) else '-2147483647 - 1'})"
    if argument.form.handle:
        text = f"HND({text})"
    return f"ADR({text})" if argument.form.address else text


def line(told: Operation) -> str:
    """An operation as C programmers write it."""
    pieces = [f"op{told.name}"]
    if told.cmd is not None:
        pieces.append(f"{told.cmd.encoding}({told.command})" if not told.cmd.form.handle else macro(told.cmd))
    return ", ".join(pieces + [macro(argument) for argument in told.arguments])


@cache
def commands(dialect: str, count: int) -> list[DirectCommand]:
    found = []
    for raw in drawn(raw_operations(dialect), count):
        frame = struct.pack("<HHBH", len(raw) + 5, 0, MessageType.DIRECT_COMMAND_NO_REPLY, 0) + raw
        message = parse(frame, dialect=dialect, expect=DirectCommand)
        found.append(message)
    return found


@pytest.mark.parametrize("compiler", [GCC, GXX])
@pytest.mark.parametrize("dialect", ["official", "xtended", "compat"])
def test_operations_of_any_kind_in_macros(tmp_path: Path, compiler: list[str], dialect: str) -> None:
    told = [message.operations[0] for message in commands(dialect, effort(100, 1000))]
    body = "".join(f"    {{ const uint8_t op[] = {{{line(one)}}}; show(op, sizeof op); }}\n" for one in told)
    assert run(f"{HEAD}{body}    return 0;\n}}\n", tmp_path, compiler) == [one.raw.hex() for one in told]


INTEGERS = (0, 31, 32, -32, -33, 127, 128, -127, -128, 32767, 32768, -32767, -32768, 2147483647, -2147483647)
INDEXES = (0, 31, 32, 255, 256, 65535, 65536, 4294967295)
FLOATS = (0.0, 1.5, -0.1, 3.4e38, 1e-45)


@pytest.mark.parametrize("compiler", [GCC, GXX])
def test_functions_choose_the_shortest_encoding(tmp_path: Path, compiler: list[str]) -> None:
    from ev3proto import GV, LV

    lines = ["    ev3_frame frame;", "    volatile float nothing = 0;"]
    expected = []

    def expect(call: str, data: bytes) -> None:
        lines.append(f"    ev3_begin(&frame, 0, 0); {call} show(frame.bytes + 5, frame.size - 5);")
        expected.append(data.hex())

    for number in INTEGERS:
        expect(f"ev3_integer(&frame, {number});", encode_integer(number))
    for index in INDEXES:
        expect(f"ev3_local(&frame, {index}u);", encode_variable(LV(index)))
        expect(f"ev3_global(&frame, {index}u);", encode_variable(GV(index)))
    for value in FLOATS:
        expect(f"ev3_float(&frame, (float){value!r});", encode_float(value))
    expect("ev3_float(&frame, nothing / nothing);", encode_float(float("nan")))
    expect('ev3_string(&frame, "myEV3");', encode_string("myEV3"))
    expect("ev3_opcode(&frame, opUI_FLUSH);", operation("UI_FLUSH").raw)
    expect("ev3_operation(&frame, opUI_DRAW, TEXTBOX);", b"\x84\x81\x20")
    assert run(HEAD + "\n".join(lines) + "\n    return 0;\n}\n", tmp_path, compiler) == expected


def test_frames_from_functions(tmp_path: Path) -> None:
    program = f"""{HEAD}
    static const char large[2000] = "";
    ev3_frame frame;
    ev3_begin_direct(&frame, 0xFFFF, DIRECT_COMMAND_REPLY, 1023, 63);
    ev3_operation(&frame, opUI_READ, GET_VBATT);
    ev3_global(&frame, 0);
    show(frame.bytes, ev3_end(&frame));
    ev3_begin_system(&frame, 7, SYSTEM_COMMAND_REPLY, LIST_FILES);
    ev3_number(&frame, 1000, 2);
    ev3_text(&frame, "/home/root/lms2012/sys/");
    show(frame.bytes, ev3_end(&frame));
    printf("%d\\n", (int)ev3_end(&frame));
    ev3_begin_system(&frame, 7, SYSTEM_COMMAND_REPLY, CONTINUE_DOWNLOAD);
    ev3_raw(&frame, large, 1018);
    printf("%d\\n", (int)ev3_end(&frame));
    ev3_raw(&frame, large, 1);
    printf("%d\\n", (int)ev3_end(&frame));
    ev3_raw(&frame, large, sizeof large);
    printf("%d\\n", (int)frame.size);
    ev3_begin_direct(&frame, 0, DIRECT_COMMAND_REPLY, 1024, 0);
    printf("%d\\n", (int)ev3_end(&frame));
    return 0;
}}
"""
    from ev3proto import GV

    vbatt = operation("UI_READ.GET_VBATT", GV(0))
    asked = direct_command(vbatt, counter=0xFFFF, reply=True, global_size=1023, local_size=63).build()
    listed = system_command("LIST_FILES", counter=7, max_bytes=1000, path="/home/root/lms2012/sys/").build()
    assert run(program, tmp_path, GCC) == [asked.hex(), listed.hex(), str(len(listed)), "1024", "0", "1024", "0"]


@pytest.mark.parametrize("compiler", [GCC, GXX])
def test_replies_are_read(tmp_path: Path, compiler: list[str]) -> None:
    program = f"""{HEAD}
    static const uint8_t reply[] = {{0x0E, 0, 0x2A, 0x01, DIRECT_REPLY, 0xA4, 0x70, 0xFD, 0x40,
                                    0xFE, 0, 0x9C, 0xFF, 0x80, 0xFF, 0xFF, 0xFF}};
    uint16_t counter = 0; int8_t small = 7; int16_t middle = 0; int32_t large = 0; float volts = 0; int had;
    printf("%d\\n", (int)ev3_size(reply, sizeof reply));
    had = ev3_counter(reply, sizeof reply, &counter); printf("%d %d\\n", had, counter);
    printf("%d %d\\n", ev3_type(reply, sizeof reply), ev3_type(reply, 4));
    had = ev3_replyf(reply, sizeof reply, 0, &volts); printf("%d %.2f\\n", had, volts);
    had = ev3_reply8(reply, sizeof reply, 4, &small); printf("%d %d\\n", had, small);
    had = ev3_reply16(reply, sizeof reply, 6, &middle); printf("%d %d\\n", had, middle);
    had = ev3_reply32(reply, sizeof reply, 7, &large); printf("%d %d\\n", had, (int)large);
    had = ev3_reply32(reply, sizeof reply, 8, &large); printf("%d %d\\n", had, (int)large);
    had = ev3_reply8(reply, 8, 4, &small); printf("%d %d\\n", had, small);
    printf("%d\\n", ev3_status(reply, 6));
    return 0;
}}
"""
    assert run(program, tmp_path, compiler) == [
        "16",
        "1 298",
        "2 -1",
        "1 7.92",
        "1 -2",
        "1 -100",
        "1 -32513",
        "0 -32513",
        "0 -2",
        "-1",
    ]


def numbers() -> dict[str, int]:
    """Every name of the header with its number."""
    found = {member.name: member.value for member in MessageType}
    for opcode in OPCODES:
        found[f"op{opcode.name}"] = opcode.number
        found |= {command.name: command.number for command in opcode.commands}
    for enum in vars(enumerations).values():
        if isinstance(enum, Enumeration):
            found |= dict(enum.members) | ({enum.end[0]: enum.end[1]} if enum.end else {})
    found |= {("BOOTLOADER_" if one.bootloader else "") + one.name: one.number for one in SYSTEM}
    found |= {f"SYSTEM_{status.name}": status.value for status in SystemStatus}
    return found | {name: value for name, value in CONSTANTS.items() if isinstance(value, int)}


@pytest.mark.parametrize("compiler", [GCC, GXX])
def test_every_name_has_its_number(tmp_path: Path, compiler: list[str]) -> None:
    told = numbers()
    assert len(told) > 850
    body = "".join(f'    printf("%lld\\n", (long long){name});\n' for name in told)
    texts = {name: value for name, value in CONSTANTS.items() if isinstance(value, str)}
    body += "".join(f"    puts({name});\n" for name in texts)
    lines = run(f"{HEAD}{body}    return 0;\n}}\n", tmp_path, compiler)
    assert dict(zip([*told, *texts], lines, strict=True)) == {
        name: str(told.get(name, texts.get(name))) for name in [*told, *texts]
    }


@pytest.mark.parametrize("standard", ["c99", "c11", "c17", "c2x", "c++11", "c++17", "c++20"])
def test_every_standard(tmp_path: Path, standard: str) -> None:
    compiler = ["g++", "-x", "c++"] if "++" in standard else ["gcc", "-x", "c"]
    assert run(f"{HEAD}    return 0;\n}}\n", tmp_path, [*compiler, f"-std={standard}"]) == []


def test_the_form_of_the_file() -> None:
    text = built_export("ev3proto.h").read_text()
    assert text.isascii()
    lines = text.split("\n")
    assert [one for one in lines if len(one) > 120 or one != one.rstrip() or "\t" in one] == []
    assert text.endswith("#endif /* EV3PROTO_H */\n")
    assert "$" not in text

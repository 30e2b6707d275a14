"""The JavaScript module: what programs make with it in Node are the codec's bytes, and TypeScript knows its types."""

from __future__ import annotations

import json
import subprocess
from typing import Any

import pytest
from support.built import built_export
from support.effort import effort
from support.frames import drawn

from ev3proto import Argument, Operation
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Type, declarations
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.testing import operations

EACH = """\
import { readFileSync } from "node:fs";
import * as ev3 from "MODULE";
const hex = (bytes) => Buffer.from(bytes).toString("hex");
const made = [];
for (const source of JSON.parse(readFileSync(0, "utf8"))) {
  try {
    made.push(hex(new Function(...Object.keys(ev3), `return ${source}`)(...Object.values(ev3))));
  } catch (error) {
    made.push(`${error.name}: ${error.message}`);
  }
}
console.log(JSON.stringify(made));
"""


def evaluated(sources: list[str]) -> list[str]:
    """What each expression gives in Node: bytes in hex, or an error."""
    program = EACH.replace("MODULE", built_export("ev3.mjs").as_uri())
    words = ["node", "--input-type=module", "--eval", program]
    done = subprocess.run(words, input=json.dumps(sources), capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    made: list[str] = json.loads(done.stdout)
    return made


def test_the_frames_of_the_page() -> None:
    assert evaluated(
        [
            "directCommand([ops.SOUND.TONE(1, 440, 1000)], { counter: 42 })",
            "directCommand([ops.UI_READ.GET_VBATT(GV(0))], { counter: 43, globals: 4 })",
            "directCommand([ops.INPUT_READEXT(0, 0, 0, 0, 0, [GV(0), LV(40)])], { globals: 4, locals: 44 })",
            "systemCommand(system.LIST_FILES(1012, '/home/'), { counter: 1 })",
            "systemCommand(system.WRITEMAILBOX('abc', 1.5), { reply: false })",
        ]
    ) == [
        "0e002a0080000094010182b80182e803",
        "08002b00000400810160",
        "0f0000000004b09e0000000000026" + "0c128",
        "0d0001000199f4032f686f6d652f00",
        "0f000000819e046162630004000000c03f",
    ]


NOT_A_NUMBER = (-128, -32768, -2147483648)
"""The whole numbers of 1, 2 and 4 bytes that mean it."""


def in_javascript(argument: Argument, kind: Type | None) -> str:
    """An argument as JavaScript programmers write it."""
    value: Any = argument.value
    # The module has no names for these: no program uses them.
    if argument.form.address or value in NOT_A_NUMBER:
        return f"new Argument([{', '.join(map(str, argument.raw))}])"
    if argument.kind in ("local", "global"):
        place = f"{'LV' if argument.kind == 'local' else 'GV'}({value})"
        return f"HND({place})" if argument.form.handle else place
    if isinstance(value, float):
        text = {"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity", "-0.0": "-0"}.get(str(value), repr(value))
        return text if kind is Type.DATAF else f"LCF({text})"
    return json.dumps(value)


def call(told: Operation) -> str:
    """The call that makes an operation."""
    declared = next(each for each in declarations(OPCODES) if each.name == told.full_name)
    types = [parameter.type for parameter in declared.fixed]
    given = [in_javascript(*pair) for pair in zip(told.arguments, types, strict=False)]
    if declared.tail:
        count = len(declared.fixed)
        element = declared.tail.element
        listed = [in_javascript(each, element.type) for each in told.arguments[count:]]
        given = [*given[: count - 1], f"[{', '.join(listed)}]"]
    return f"ops.{told.full_name}({', '.join(given)})"


@pytest.mark.parametrize("dialect", ["official", "xtended", "compat"])
def test_drawn_operations(dialect: str) -> None:
    told = drawn(operations(dialect), effort(300, 3000))
    made = evaluated([call(one) for one in told])
    wrong = [(call(one), one.raw.hex(), got) for one, got in zip(told, made, strict=True) if got != one.raw.hex()]
    assert wrong[:5] == []


def test_what_cannot_be_encoded_is_refused_by_name() -> None:
    assert evaluated(
        [
            "ops.SOUND.TONE(300, 440, 1000)",
            "ops.UI_READ.GET_VBATT(1)",
            "ops.INPUT_DEVICE.READY_SI(0, 1, 0, 0, GV(0))",
            "ops.COM_SET.SET_BRICKNAME('Ωmega')",
            "GV(-1).bytes",
            "directCommand([], { globals: 1024 })",
            "directCommand(Array(300).fill(ops.SOUND.TONE(1, 440, 1000)))",
        ]
    ) == [
        "RangeError: VOLUME: 300 is not a whole number from -127 to 127",
        "TypeError: VALUE is an output: give GV(0), LV(0), or another variable",
        "TypeError: VALUES is a list: give an array",
        'RangeError: NAME: "Ωmega" has a character that the brick lacks: code 937',
        "RangeError: -1 is not an index",
        "RangeError: globals: 1024 is not a whole number from 0 to 1023",
        "RangeError: a frame has at most 1024 bytes, this one has 2707",
    ]


def test_every_number_has_its_name() -> None:
    program = f"import * as ev3 from '{built_export('ev3.mjs').as_uri()}'; console.log(JSON.stringify(ev3))"
    words = ["node", "--input-type=module", "--eval", program]
    known = json.loads(subprocess.run(words, capture_output=True, text=True, timeout=60, check=True).stdout)
    assert known["Opcode"] == {opcode.name: opcode.number for opcode in OPCODES}
    assert {each.name: known[each.name] for each in ENUMERATIONS} == {each.name: each.members for each in ENUMERATIONS}

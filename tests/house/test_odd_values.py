"""Values that a function of the package cannot take: each is refused with a sentence that says what it takes.

A caller's mistake is a TypeError or a ValueError (a BuildError is one), never an error of the code inside.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import ev3proto
from ev3proto import GV, LV, capture, ops, program, pyshark, testing
from ev3proto.brick import Brick
from ev3proto.capture.filter import compile_filter
from ev3proto.dialogue import reply_values
from ev3proto.errors import BuildError
from ev3proto.generate.captures import write_pcapng
from ev3proto.link.targets import Target
from ev3proto.messages import Argument, Flaw, Operation, PartialOperation
from ev3proto.sampling import samples
from ev3proto.schema.constructors import any_direct_command
from ev3proto.schema.discovery import UNLOCK, Unlock, is_beacon
from ev3proto.schema.instructions import instruction_set
from ev3proto.text.assembly import assembly, operation_line
from ev3proto.text.paste import read_argument, read_bare, read_text

COMMAND = ev3proto.parse(bytes.fromhex("08000100000400810160"), expect=ev3proto.DirectCommand)
REPLY = ev3proto.parse(bytes.fromhex("0700010002a470fd40"), expect=ev3proto.DirectReply)
ODD = "odd"


@pytest.mark.parametrize(
    ("call", "error", "sentence"),
    [
        (lambda: reply_values(None, REPLY), TypeError, "a reply is read through a DirectCommand, not NoneType"),  # type: ignore[arg-type]
        (lambda: reply_values(COMMAND, None), TypeError, "values are in a DirectReply, not in NoneType"),  # type: ignore[arg-type]
        (lambda: program.build(None), TypeError, "an image is made of a Program, not of NoneType"),  # type: ignore[arg-type]
        (lambda: program.source_of(b"LEGO"), TypeError, "a source is made of a Program, not of bytes"),  # type: ignore[arg-type]
        (lambda: capture.read(1), TypeError, "a capture is a path or a binary stream, not int"),  # type: ignore[arg-type]
        (lambda: capture.read(object()), TypeError, "a capture is a path or a binary stream, not object"),  # type: ignore[arg-type]
        (lambda: compile_filter(None), TypeError, "a filter is a text, not NoneType"),  # type: ignore[arg-type]
        (lambda: Target.parse(None), TypeError, "a target is a text, not NoneType"),  # type: ignore[arg-type]
        (lambda: ev3proto.EV3(target={}), TypeError, "a target is a text, not dict"),  # type: ignore[arg-type]
        (lambda: samples(testing.frames(), "x"), TypeError, "a seed is a whole number, not 'x'"),  # type: ignore[arg-type]
        (lambda: testing.choice(names=[None]), TypeError, "a name is a text, not None"),  # type: ignore[list-item]
        (lambda: testing.choice(types=[5]), TypeError, "a type of message is a text, not 5"),  # type: ignore[list-item]
        (lambda: any_direct_command([], counter=0, reply=True, global_size=0, local_size=0), BuildError, "[] is no op"),  # type: ignore[arg-type]
        (lambda: instruction_set().write([b"\x01"]), BuildError, r"b'\x01' is no operation"),
        (lambda: testing.frames(chosen="tone"), TypeError, "chosen is what ev3proto.testing.choice makes, not 'tone'"),  # type: ignore[arg-type]
        (lambda: testing.direct_replies(None), TypeError, "chosen is what ev3proto.testing.choice makes, not None"),  # type: ignore[arg-type]
        (lambda: testing.values_for("FREQUENCY"), TypeError, "a parameter is a Parameter of the tables, not str"),
        (lambda: testing.encoded_arguments(5), TypeError, "a parameter is a Parameter of the tables, not int"),
        (lambda: write_pcapng([], "x"), TypeError, "a capture is written to a binary stream, not str"),  # type: ignore[arg-type]
        (lambda: Brick(stretch=-1), ValueError, "stretch must be seconds, 0 or more, or None, not -1"),
        (lambda: Brick(stretch="1"), ValueError, "stretch must be seconds, 0 or more, or None, not '1'"),  # type: ignore[arg-type]
        (lambda: Brick().plug(1, 16, b"x"), ValueError, "readings are numbers by mode, such as {0: (1900,)}, not b'x'"),  # type: ignore[arg-type]
        (lambda: Brick().plug(1, 16, {0: 5}), ValueError, "readings are numbers by mode, such as {0: (1900,)}, not {0"),  # type: ignore[dict-item]
        (lambda: UNLOCK.write(b"001653"), BuildError, "an unlock text is made of an Unlock, not of bytes"),
        (lambda: Unlock("001653", endings=1 << 70).build(), BuildError, "has 0 to 2 line ends after its last line"),
        (lambda: Unlock("001653", endings="2").build(), BuildError, "has 0 to 2 line ends after its last line"),  # type: ignore[arg-type]
        (lambda: is_beacon("Serial-Number: "), TypeError, "a datagram is bytes, not text"),  # type: ignore[arg-type]
        (lambda: assembly(COMMAND, ODD), TypeError, "an Exchange, not DirectCommand: ev3proto.Dialogue().follow("),  # type: ignore[arg-type]
        (lambda: operation_line(None), TypeError, "a line is made of an Operation, not of NoneType"),  # type: ignore[arg-type]
        (lambda: read_argument(None), TypeError, "what was pasted is a text, not NoneType"),  # type: ignore[arg-type]
        (lambda: capture.from_pyshark("robot.pcapng").events(), TypeError, "a packet is one that pyshark gives"),
        (lambda: capture.from_pyshark([None]).events(), TypeError, "such as those of a FileCapture, not None"),
        (lambda: pyshark.messages(b""), TypeError, "such as those of a FileCapture, not b''"),
        (lambda: ev3proto.Report(b"", True, None, (ODD,)), TypeError, "is a Finding, not 'odd'"),  # type: ignore[arg-type]
        (lambda: ev3proto.Fix(b"", (), (), None), TypeError, "a fix has a Report of the fixed frame, not None"),  # type: ignore[arg-type]
        (lambda: read_text([None]), TypeError, "what was pasted is a text, not NoneType"),  # type: ignore[list-item]
        (lambda: read_bare([b"01"], "length"), TypeError, "what was pasted is a text, not bytes"),  # type: ignore[list-item]
    ],
)
def test_what_cannot_be_taken_is_refused(
    call: Callable[[], Iterator[Any]], error: type[Exception], sentence: str
) -> None:
    with pytest.raises(error) as caught:
        next(call(), None)
    assert sentence in str(caught.value)


@pytest.mark.parametrize("seconds", [float("inf"), float("nan"), -1, 1e40, 10**400, None, "9999", b"1", [0.5]])
def test_seconds_that_cannot_pass(seconds: Any) -> None:
    brick = Brick()
    for advance in (brick.advance, brick.advance_all):
        with pytest.raises((ValueError, TypeError), match=r"^seconds are a number from 0 to \d+, not "):
            advance(seconds)
    assert brick.microseconds == 0


@pytest.mark.parametrize("kind", [0, "DIRECT_COMMAND_REPLY", 1.5, object, b"\x00"])
def test_a_message_of_a_type_that_is_none(kind: Any) -> None:
    for make in (ev3proto.DirectCommand, ev3proto.DirectReply, ev3proto.SystemCommand, ev3proto.Message):
        with pytest.raises(TypeError, match=r"^type is a MessageType or None, not "):
            make(type=kind)


@pytest.mark.parametrize("flaw", [None, "x", 5, (), b""])
def test_a_message_with_a_flaw_that_is_none(flaw: Any) -> None:
    with pytest.raises(TypeError, match=r"^flaw is a Flaw, not "):
        ev3proto.DirectReply(type=ev3proto.MessageType.DIRECT_REPLY, flaw=flaw)
    assert ev3proto.DirectReply(type=ev3proto.MessageType.DIRECT_REPLY, flaw=Flaw(rest=b"\x01")).rest == b"\x01"


@pytest.mark.parametrize(
    "made", [Argument(), Operation(), PartialOperation(), Argument("odd values"), Operation("odd")]
)
def test_what_nobody_makes_by_hand_can_be_shown(made: tuple[Any, ...]) -> None:
    assert repr(made) == f"<{type(made).__name__} without contents>"


def test_a_program_of_odd_parts() -> None:
    with pytest.raises(BuildError, match=r"^objects cannot have None: each is a CodeObject$"):
        program.build(program.Program(objects=(None,)))  # type: ignore[arg-type]
    with pytest.raises(BuildError, match=r"^defects cannot be 'x': they are Defects$"):
        program.build(program.Program(defects="x"))  # type: ignore[arg-type]


def test_a_path_is_still_a_capture() -> None:
    assert len(list(capture.read(Path(__file__).parents[2] / "captures" / "wifi.pcapng"))) > 0


@pytest.mark.parametrize("timeout", ["", -1, float("nan"), b"1", [1]])
def test_a_timeout_that_is_none_is_refused_before_anything_is_sent(timeout: Any) -> None:
    with pytest.raises(ValueError, match=r"^timeout must be seconds, 0 or more, or None, not "):
        ev3proto.EV3(target="virtual", timeout=timeout)
    with ev3proto.EV3(target="virtual") as ev3:
        for send in (lambda: ev3.send_direct_cmd(ops.nop(), timeout=timeout), lambda: ev3.list_dir("/")):
            ev3.timeout = timeout
            with pytest.raises(ValueError, match=r"^timeout must be seconds, 0 or more, or None, not "):
                send()
        ev3.timeout = 30
        assert ev3.send_direct_cmd(ops.info.get_volume(), sync_mode=ev3proto.ASYNC) == b"\x2a\x00"


@pytest.mark.parametrize("timeout", [None, 1 << 70, float("inf"), 1e30])
def test_a_timeout_may_be_as_long_as_it_likes(timeout: float | None) -> None:
    with ev3proto.EV3(target="virtual", timeout=timeout) as ev3:
        assert ev3.send_direct_cmd(ev3proto.opInfo + ev3proto.GET_VOLUME + ev3proto.GVX(0), global_mem=1) == b"\x64"


@pytest.mark.parametrize("number", [10**400, -(10**400)], ids=["above", "below"])
def test_an_argument_of_400_digits(number: int) -> None:
    calls: list[Callable[[], Any]] = [
        lambda: ops.info.set_volume(number),
        lambda: ops.sound.tone(1, number, 1000),
        lambda: ops.movef_f(number, LV(0)),
        lambda: ops.input_device.setup(0, 0, number, 0, 0, b"\x80", 0, GV(0)),
        lambda: ops.output_start(0, number),
    ]
    for call in calls:
        with pytest.raises(BuildError, match="0000"):
            call()

"""All who judge a constant are asked about the same ones, and agree: no part of the project drifts from the others.

What each says is a row of `ROOMS`, by what is wrong with it. Where they rightly differ, the row has the reason. The
validator (`checking/verdict.py`) and lmsasm's types (`text/assembly/objects.py`) are other questions, with other tests.
"""

from __future__ import annotations

import json
from functools import cache
from typing import NamedTuple

from support.cases import each
from support.constants import Constant, every_constant
from support.effort import effort
from support.frames import drawn
from support.packets import RAW_IP, Capture, Connection
from support.wireshark import Tshark

import ev3proto
from ev3proto import BuildError
from ev3proto.capture.evidence import is_plausible
from ev3proto.dialogue import Exchange
from ev3proto.schema.argument import ArgumentSchema
from ev3proto.schema.frame import frame_reader
from ev3proto.semantics.drafts.functions import drafts
from ev3proto.semantics.facts import facts_of, operation_facts
from ev3proto.semantics.judgement import Wrong, judge, judged
from ev3proto.semantics.likelihood import CommandCode
from ev3proto.tables.declaration import Parameter, Role
from ev3proto.tables.encoding import CONSTANT, JUMP, TEXT
from ev3proto.testing import _accepted_values
from ev3proto.text.assembly import AssemblyError, assemble
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.json_format.to_messages import frame_of
from ev3proto.text.phrases import Seen


class Row(NamedTuple):
    """What the rooms say of a constant.

    code      the finding of `check`, and of the dissector; empty: none
    is_taken  `ops` and the assembler of frames take it without `unchecked`
    is_sent   it may be in a command by which a capture is claimed, in Python and in the dissector
    cost      the least and the largest cost by which `nearest` holds it for a slip
    """

    code: str
    is_taken: bool = False
    is_sent: bool = False
    cost: tuple[float, float] = (3, 11)


ROOMS = {
    # Variables that nothing fills cost something, too.
    None: Row("", True, True, (-4, 2.5)),
    Wrong.LABEL: Row("E307"),
    Wrong.LABEL_BYTE: Row("W305"),
    Wrong.WRITTEN: Row("E302"),
    Wrong.TEXT: Row("E304"),
    Wrong.NUMBER: Row("E303"),
    # Programs of beginners send whole numbers for floats.
    Wrong.WHOLE: Row("E305", is_sent=True),
    Wrong.LABEL_NUMBER: Row("E206"),
    # The rules on lists word it, and the reader ends there.
    Wrong.COUNT: Row(""),
    Wrong.REFUSED: Row("E204"),
    Wrong.NAN: Row("W302"),
    # "Not a number" as a float may be sent on purpose.
    Wrong.NAN_FLOAT: Row("W302", is_taken=True, is_sent=True),
    Wrong.NEGATIVE: Row("W301"),
    Wrong.TRUNCATED: Row("E301"),
    Wrong.MASK: Row("W303"),
    Wrong.NO_MEMBER: Row("W304"),
    Wrong.OUTSIDE: Row("W303"),
    # A text has the length that it has: that is rarely a slip, and no other protocol's.
    Wrong.LONG: Row("E502", is_sent=True, cost=(0, 2.5)),
}

UNLOCK = ev3proto.Unlock("06165300000a").build()

CODES = {row.code for row in ROOMS.values()} - {""}


@cache
def cases() -> list[tuple[Constant, Wrong | None]]:
    """The constants, and what is wrong with each."""
    found: list[tuple[Constant, Wrong | None]] = []
    for constant in every_constant():
        argument = constant.argument
        known = operation_facts(constant.schema).of(constant.number, argument.parameter)
        judgement = judged(known, argument)
        found.append((constant, None if judgement is None else judgement.wrong))
    return found


def test_there_is_a_row_for_everything_that_can_be_wrong() -> None:
    assert set(ROOMS) == {None, *Wrong}
    assert {wrong for _, wrong in cases()} == set(ROOMS) - {Wrong.COUNT}
    assert len(cases()) > 6000


@each("constant, wrong", cases())
def test_check(constant: Constant, wrong: Wrong | None) -> None:
    offset = constant.argument.offset
    report = ev3proto.check(constant.frame, dialect=constant.dialect)
    found = {one.code for one in report.findings if one.offset == offset} & CODES
    assert found == {ROOMS[wrong].code} - {""}


def _refusal(constant: Constant, *, unchecked: bool = False) -> str:
    """Returns what `ops` says against the constant; empty if it takes it."""
    try:
        drafts(constant.dialect)[constant.schema.declaration.name].draft(constant.given, unchecked)
    except BuildError as error:
        return str(error)
    return ""


def _as_encoded(constant: Constant) -> Wrong | str | None:
    """Returns what is wrong with a plain value as it is encoded; a sentence if it cannot be encoded."""
    argument = constant.argument
    try:
        written = ArgumentSchema(argument.parameter).write(constant.value)
    except BuildError as error:
        return str(error)
    read, _ = ArgumentSchema(argument.parameter).read(written, 0)
    known = operation_facts(constant.schema).of(constant.number, argument.parameter)
    judgement = judged(known, read)
    return None if judgement is None else judgement.wrong


@each("constant, wrong", cases())
def test_ops(constant: Constant, wrong: Wrong | None) -> None:
    """Plain values and encoded ones are judged alike; what can be encoded, `unchecked` lets through."""
    encoded = constant._replace(value=None)
    refused = _refusal(encoded)
    assert bool(refused) is not ROOMS[wrong].is_taken
    assert not refused or "unchecked=True" in refused
    assert not _refusal(encoded, unchecked=True)
    if constant.value is not None:
        meant = _as_encoded(constant)
        refused = _refusal(constant)
        if isinstance(meant, str):
            assert refused
            assert "unchecked" not in refused
            assert _refusal(constant, unchecked=True)
        else:
            assert bool(refused) is not ROOMS[meant].is_taken
            assert not refused or "unchecked=True" in refused
            assert not _refusal(constant, unchecked=True)


@each("constant, wrong", [(one, wrong) for one, wrong in cases() if one.is_written])
def test_assembler(constant: Constant, wrong: Wrong | None) -> None:
    """The assembler of frames takes what `ops` takes."""
    values = [f"bytes({data.hex(' ')})" for data in constant.written]
    values[constant.number] = json.dumps(constant.value)
    said = ""
    try:
        assemble(f"{constant.schema.declaration.name}({', '.join(values)})", dialect=constant.dialect)
    except AssemblyError as error:
        said = str(error)
    assert bool(said) is bool(_refusal(constant)) or "bytes of global memory" in said, said


@each("constant, wrong", cases())
def test_json(constant: Constant, wrong: Wrong | None) -> None:
    """JSON judges nothing: what `decode` prints, `encode` makes again, legal or not; only "nan" has one form."""
    frame = constant.frame
    message = ev3proto.parse(frame, dialect=constant.dialect)
    entry = record(Exchange(message, None, [], None), Seen())
    del entry["hex"]
    made = frame_of(json.loads(json.dumps(entry)), dialect=constant.dialect)
    assert made == frame or '"nan"' in json.dumps(entry)


@each("constant, wrong", cases())
def test_likelihood(constant: Constant, wrong: Wrong | None) -> None:
    """Legal, but rare: handles, addresses, labels out of programs, floats of odd bits, other layers, no motor."""
    argument = constant.argument
    form, value = argument.form, argument.value
    least, most = ROOMS[wrong].cost
    ((_, reading),) = CommandCode(constant.frame, constant.dialect).first
    ((_, usually),) = CommandCode(constant.with_usual().frame, constant.dialect).first
    is_odd = isinstance(value, float) and value != 0 and not 1e-5 < abs(value) < 1e9
    is_unusual = argument.parameter.role is Role.LAYER or _is_no_motor(constant)
    is_rare = form.handle or form.address or form.kind == JUMP or is_odd or is_unusual
    assert least <= reading.cost - usually.cost <= (11 if is_rare else most)


@each("constant, wrong", cases())
def test_claims(constant: Constant, wrong: Wrong | None) -> None:
    assert _is_plausible(constant.frame, constant.dialect) is _is_sent(constant, wrong)


@cache
def _is_plausible(frame: bytes, dialect: str) -> bool:
    return is_plausible(ev3proto.parse(frame, strict=False, dialect=dialect), frame_reader(dialect))


def _is_sent(constant: Constant, wrong: Wrong | None) -> bool:
    """Returns whether it may claim a capture: some operations never do, and a set of no motors proves nothing."""
    sent = ROOMS[wrong].is_sent and not _is_no_motor(constant)
    return sent and _is_plausible(constant.with_usual().frame, constant.dialect)


def _is_no_motor(constant: Constant) -> bool:
    return constant.argument.parameter.role is Role.MOTORS and constant.argument.value == 0


@each("parameter, declared", {one.argument.parameter: one for one, _ in cases()}.items())
def test_strategies(parameter: Parameter, declared: Constant) -> None:
    """What is drawn as accepted is taken by `ops`."""
    known = facts_of(parameter)
    values = [one for one in drawn(_accepted_values(parameter), effort(4, 40)) if isinstance(one, int | float | str)]
    judgements = [judge(known, TEXT if isinstance(one, str) else CONSTANT, one) for one in values]
    assert {one.wrong for one in judgements if one is not None} <= {Wrong.NAN_FLOAT}


def test_dissector_words(tshark: Tshark) -> None:
    """The dissector says of each what `check` says."""
    frames = [constant.frame for constant, _ in cases() if constant.dialect == "official"]
    # Values whose type is in another argument, from DATA_8 to DATA_S.
    for number, sent in enumerate((1, 1000, 100_000, 0.5, "text", "t" * 250)):
        written = ev3proto.operation("MAILBOX_WRITE", "", 0, "box", min(number, 4), 1, sent)
        frames.append(ev3proto.direct_command(written).build())
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    for frame in frames:
        connection.send(frame)
    fields = ("-e", "_ws.expert.message", "-E", "aggregator=~")
    path = tshark.place(capture.data(), "constants.pcap")
    shown = tshark.run(path, "-Y", "ev3.msg_num", "-T", "fields", *fields).splitlines()
    ends = tuple(f"({code})" for code in CODES)
    wrong = []
    for frame, line in zip(frames, shown, strict=True):
        told = {text for text in line.split("~") if text.endswith(ends)}
        found = {f"{one.message} ({one.code})" for one in ev3proto.check(frame).findings if one.code in CODES}
        if told != found:
            wrong.append(f"{frame.hex(' ')}: {told} {found}")
    assert not wrong, "\n".join(wrong[:10])


def test_dissector_claims(tshark: Tshark) -> None:
    """The dissector claims a connection by the same commands."""
    sent = [constant for constant, _ in cases() if constant.dialect == "official"]
    capture = Capture(RAW_IP)
    for number, constant in enumerate(sent):
        Connection(capture, 20_000 + number).send(constant.frame)
    path = tshark.place(capture.data(), "claims.pcap")
    claimed = set(tshark.matches(path, ["ev3"])["ev3"])
    wrong = [
        f"{constant.name}: {'' if number in claimed else 'not '}claimed"
        for number, constant in enumerate(sent, 1)
        if (number in claimed) is not _is_plausible(constant.frame, constant.dialect)
    ]
    assert not wrong, "\n".join(wrong[:20])

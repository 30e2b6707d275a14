"""Properties of every frame: a check never raises, gives the reason of a refusal, and accepts what is right."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st
from support.careful import KNOWN, ROOM, careful_frames, careful_operation
from support.cases import each
from support.cpu_time import milliseconds
from support.effort import effort

import ev3proto
from ev3proto import GV, check
from ev3proto.checking.codes import CODES
from ev3proto.checking.verdict import verdict
from ev3proto.messages import DirectCommand, Variable
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.declaration import DIALECTS, Declaration
from ev3proto.testing import direct_commands, frames, mutated_frames, system_commands
from ev3proto.text.diagnostics import diagnostics
from ev3proto.text.spans import plain_text

many = settings(max_examples=effort(80, 1000))

ANYTHING = frames() | mutated_frames() | st.binary(max_size=40) | st.binary(max_size=1100)


@many
@given(ANYTHING, st.sampled_from(DIALECTS), st.sampled_from((None, *CARRIERS)))
def test_a_check_never_raises_and_points_into_the_frame(frame: bytes, dialect: str, carrier: str | None) -> None:
    report = check(frame, dialect=dialect, carrier=carrier)
    assert report.frame == frame
    assert report.accepted == (report.rejected_at is None)
    assert report.rejected_at is None or 0 <= report.rejected_at <= len(frame)
    for finding in report.findings:
        assert CODES[finding.code].severity is finding.severity
        assert 0 <= finding.offset <= finding.offset + finding.length <= len(frame)
        assert finding.message
        assert finding.help
    assert [it.offset for it in report.findings] == sorted(it.offset for it in report.findings)
    assert len(set(report.findings)) == len(report.findings)


@many
@given(ANYTHING, st.sampled_from(DIALECTS))
def test_every_report_can_be_shown(frame: bytes, dialect: str) -> None:
    report = check(frame, dialect=dialect)
    lines = [plain_text(line) for line in diagnostics(report, place="frame 3", dialect=dialect)]
    assert lines[0].startswith("frame 3: ")
    assert {finding.code for finding in report.findings} == {code for code in CODES if f"[{code}]" in "".join(lines)}


@many
@given(ANYTHING)
def test_what_is_refused_has_a_reason(frame: bytes) -> None:
    report = check(frame)
    kind = ev3proto.parse(frame, strict=False).type
    if kind is not None and not kind.is_command:
        return
    if not report.accepted:
        assert report.errors
    if kind is not None and kind.kind == "direct-command":
        assert (report.accepted, report.rejected_at) == verdict(frame)[:2]


@many
@given(careful_frames())
def test_what_is_built_from_valid_values_has_no_errors(frame: bytes) -> None:
    report = check(frame)
    assert report.accepted
    assert report.errors == ()


@each("declaration", KNOWN)
@settings(max_examples=effort(3, 30))
@given(st.data())
def test_no_operation_raises_a_false_alarm(declaration: Declaration, data: st.DataObject) -> None:
    """Every operation with legal values has no finding about its values or encodings."""
    operation = data.draw(careful_operation(declaration))
    frame = ev3proto.direct_command(operation, reply=True, global_size=ROOM, local_size=ROOM).build()
    found = {finding.code for finding in check(frame).findings}
    # A single operation uses less than all memory, may store two results in one place, or only draw. Some fail on every
    # brick, need a handle or a program from another operation, or a value in their variables; its slot or its motors
    # may be any, and its results local.
    alone = {"W407", "W706", "W708", "H707"}
    assert found <= {"H401", "W401", "W402", "W405", "W603", "W702", "W202", "W406", "W502", "W503"} | alone


@many
@given(system_commands(), st.booleans())
def test_system_commands_from_valid_values(command: ev3proto.SystemCommand, is_usb: bool) -> None:
    codes = {finding.code for finding in check(command.build(), carrier="usb" if is_usb else None).errors}
    # Texts without meaning are long extensions and empty names, too.
    assert codes <= {"E803"}


@many
@given(careful_frames(), st.data())
def test_a_changed_byte_is_another_meaning_or_is_reported(frame: bytes, data: st.DataObject) -> None:
    at, flip = data.draw(st.integers(0, len(frame) - 1)), data.draw(st.integers(1, 255))
    changed = frame[:at] + bytes((frame[at] ^ flip,)) + frame[at + 1 :]
    report = check(changed)
    if report.findings and not report.accepted:
        return
    message = ev3proto.parse(changed, strict=False)
    if report.errors:
        return
    # What raises no error reads to its end, and means what its bytes say.
    assert report.accepted
    assert message.fault is None
    assert message.build() == changed


def test_every_changed_byte_of_a_tone() -> None:
    """All 4080 of them: without an error, it is another tone, another counter, or requests other memory or a reply."""
    frame = bytes.fromhex("0E002A0080000094010182B80182E803")
    silent: set[int] = set()
    for at in range(len(frame)):
        for value in range(256):
            changed = frame[:at] + bytes((value,)) + frame[at + 1 :]
            report = check(changed)
            if changed != frame and not report.errors and report.accepted:
                assert ev3proto.parse(changed) != ev3proto.parse(frame)
                silent.add(at)
    # Neither the length field nor CMD is among them.
    assert silent == set(range(16)) - {0, 1, 8}


@many
@given(direct_commands())
def test_verdicts_do_not_depend_on_counter_and_type(command: DirectCommand) -> None:
    frame = command.build()
    other = frame[:2] + b"\x12\x34" + bytes((frame[4] ^ 0x80,)) + frame[5:]
    assert verdict(frame) == verdict(other)


def test_a_command_full_of_results_is_checked_at_once() -> None:
    """Everything in it overlaps: the work grows no faster than the frame."""
    crowded = [ev3proto.operation("INPUT_DEVICE_LIST", 127, Variable("global", 0), GV(200)) for _ in range(160)]
    frame = ev3proto.direct_command(*crowded, reply=True, global_size=1000).build()
    assert len(check(frame).findings) >= 159
    assert milliseconds(lambda: check(frame), 400) <= 400

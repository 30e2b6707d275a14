"""The findings of a check: every code by its own example, then each topic, by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from support.messages import raw

import ev3proto
from ev3proto import GV, LV, Finding, Operation, Report, Severity, check, operation, system
from ev3proto.checking.codes import CODES
from ev3proto.schema.argument import encode_as
from ev3proto.text.paste import read_text

pytestmark = pytest.mark.portable

CAPTURES = Path(__file__).parents[2] / "captures"


def command(*operations: Operation, **header: int) -> bytes:
    return ev3proto.direct_command(*operations, **header).build()  # type: ignore[arg-type]


def asking(*operations: Operation, **header: int) -> bytes:
    return ev3proto.direct_command(*operations, reply=True, **header).build()


def codes(frame: bytes, **options: Any) -> list[str]:
    return [finding.code for finding in check(frame, **options).findings]


def only(frame: bytes, **options: Any) -> Finding:
    """The only finding."""
    (finding,) = check(frame, **options).findings
    return finding


def span(finding: Finding, frame: bytes) -> str:
    """The bytes of a finding."""
    return frame[finding.offset : finding.offset + finding.length].hex(" ")


# The table of codes


@pytest.mark.parametrize("name", CODES)
def test_every_code_has_a_frame_that_raises_it_and_one_that_does_not(name: str) -> None:
    code = CODES[name]
    carrier = code.carrier
    found = [
        finding for finding in check(code.example, carrier=carrier, alone=code.alone).findings if finding.code == name
    ]
    assert found
    assert {finding.severity for finding in found} == {code.severity}
    assert name not in [finding.code for finding in check(code.counterexample, carrier=carrier).findings]


@pytest.mark.parametrize("name", CODES)
def test_a_counterexample_has_no_findings(name: str) -> None:
    report = check(CODES[name].counterexample, carrier=CODES[name].carrier)
    assert (report.accepted, report.findings) == (True, ())


@pytest.mark.parametrize("name", CODES)
def test_names_and_explanations(name: str) -> None:
    code = CODES[name]
    assert code.code == name
    assert {"E": Severity.ERROR, "W": Severity.WARNING, "H": Severity.HINT}[name[0]] is code.severity
    assert len(name) == 4
    assert name[1:].isdigit()
    assert 5 < len(code.title) < 70
    assert code.explanation.endswith(".")
    assert len(code.explanation) > 80
    for finding in check(code.example, carrier=code.carrier, alone=code.alone).findings:
        assert not finding.message.endswith(".")
        assert not finding.help.removesuffix("...").endswith(".")


# What a report says


def test_a_frame_that_is_right() -> None:
    frame = bytes.fromhex("0E002A0080000094010182B80182E803")
    assert check(frame) == Report(frame, True, None, ())
    assert check(bytearray(frame)) == check(memoryview(frame)) == check(frame)
    assert check(frame).as_dict() == {"accepted": True, "rejected_at": None, "findings": [], "hex": frame.hex()}


def test_the_fields_of_a_finding() -> None:
    report = check(raw("94 01 01 82C800 82E803"))
    assert report.findings == (
        Finding(
            Severity.WARNING,
            "W303",
            10,
            3,
            "FREQUENCY is 200 Hz, outside of 250 to 10000 Hz",
            "use 250 to 10000 Hz",
            "SOUND.TONE",
            "FREQUENCY",
        ),
    )
    assert (report.accepted, report.errors, len(report.warnings)) == (True, (), 1)


def test_options() -> None:
    with pytest.raises(ValueError, match="carrier must be one of usb, bluetooth, wifi, not 'pigeon'"):
        check(b"", carrier="pigeon")
    with pytest.raises(ValueError, match="dialect"):
        check(b"", dialect="nxt")
    frame = raw("E4 00 00 01")
    assert codes(frame, dialect="xtended") == []
    assert only(frame).message == (
        "0xE4 is INPUT_SET_AUTOID in the dialects xtended and compat, but not an opcode of official firmware"
    )


def test_what_is_documented_and_never_implemented() -> None:
    (finding,) = check(bytes.fromhex("08000100000400A00060")).findings
    assert (finding.code, finding.offset) == ("E201", 7)
    assert finding.message == "0xA0 is OUTPUT_GET_TYPE, which is documented but not implemented by any firmware"
    assert finding.help == "INPUT_DEVICE.GET_TYPEMODE with ports 16 to 19 reports the type of the motor at A to D"


def test_mailbox_write_takes_the_hardware_that_compilers_write() -> None:
    """opMAILBOX_WRITE("", 0, "abc", DATA_S, 1, "hi")."""
    assert codes(bytes.fromhex("1400 0000 80 0000 D9 8400 00 8461626300 04 01 84686900")) == []


# The corpus


def test_the_frames_of_the_lesson() -> None:
    """All are right, except the triad, of which only the last tone is heard."""
    found = {}
    for pasted in read_text((CAPTURES / "lesson-02.log").read_text().splitlines()):
        if pasted.direction != "received":
            report = check(pasted.data)
            assert report.accepted
            if report.findings:
                found[pasted.data] = report.findings
    ((frame, findings),) = found.items()
    assert frame.count(b"\x94\x01") == 4
    assert [(finding.code, finding.offset, finding.length) for finding in findings] == [
        ("W701", 7, 9),
        ("W701", 16, 9),
        ("W701", 25, 9),
    ]


FAILING = {("W303", "HARDWARE"), ("W502", "HANDLE")}


@pytest.mark.parametrize(
    "path", sorted({*CAPTURES.glob("*.pcap*")} - {CAPTURES / "ev3_dc.pcap"}), ids=lambda path: path.name
)
def test_the_frames_of_captures(path: Path) -> None:
    """They have one command that the brick refuses, on purpose, and nothing else to improve.

    `ev3_dc.pcap` is from another program, and unchanged. `conformance.pcapng` also shows what fails: hardware that
    lacks a property, handles of nothing.
    """
    for record in ev3proto.capture.read(path):
        if not isinstance(record, ev3proto.capture.Record):
            continue
        kind = record.message.type
        if kind is None or not kind.is_command or record.direction == "received":
            continue
        report = check(record.frame, carrier=str(record.carrier))
        found = {(it.code, it.parameter) for it in report.findings} - FAILING
        assert found == (set() if report.accepted else {("E205", "VALUE")})


# 1: the frame


@pytest.mark.parametrize("size", range(5))
def test_too_short(size: int) -> None:
    frame = b"\x06\0\x2a\0"[:size]
    assert (only(frame).code, only(frame).length, check(frame).accepted) == ("E101", size, False)


def test_one_cause_one_finding() -> None:
    """A frame that is cut off anywhere is reported once."""
    frame = bytes.fromhex("1E002A00800000940281648 42E2F75692F446F776E6C6F616453756363657300".replace(" ", ""))
    assert codes(frame) == []
    for size in range(5, len(frame)):
        assert codes(frame[:size]) == ["E102"], size


def test_length_and_padding() -> None:
    frame = raw("82 1B 01")
    assert codes(frame + bytes(1014)) == ["H101"]
    assert codes(frame + bytes(1014), carrier="wifi") == ["E103"]
    assert codes(frame + bytes(1013)) == ["E103"]
    assert codes(frame + bytes(1013) + b"\1") == ["E103"]
    assert only(frame + b"\1").message == "the length field says that 8 bytes follow it, but there are 9"
    assert only(frame + b"\1").help == "set the length to 9, or omit the last 1 byte"


def test_empty_commands() -> None:
    assert (only(raw("")).code, check(raw("")).rejected_at) == ("E106", 7)
    assert codes(bytes.fromhex("03002A0080")) == ["E106"]
    assert codes(bytes.fromhex("04002A008000")) == ["E106"]


def test_replies_are_not_checked() -> None:
    report = check(bytes.fromhex("07002A00020000F040"))
    assert ([finding.code for finding in report.findings], report.accepted, report.errors) == (["W101"], False, ())


# 2: operations


def test_what_cannot_be_read() -> None:
    frame = raw("82 1B 01 B5 01")
    assert (only(frame).code, span(only(frame), frame)) == ("E201", "b5")
    frame = raw("94 01 01 82B801")
    assert (only(frame).code, only(frame).parameter, only(frame).length) == ("E203", "DURATION", 0)
    assert only(frame).message == "SOUND.TONE: the frame ends before the argument DURATION"
    frame = raw("94 01 01 82B801 82E8")
    assert (only(frame).code, span(only(frame), frame)) == ("E203", "82 e8")
    frame = raw("94")
    assert (only(frame).code, only(frame).operation, only(frame).parameter) == ("E203", "SOUND", "CMD")
    frame = raw("A3 00 01 86")
    assert (only(frame).code, only(frame).parameter, span(only(frame), frame)) == ("E210", "BRAKE", "86")
    frame = raw("94 85")
    assert (only(frame).code, only(frame).parameter) == ("E210", "CMD")


def test_an_unknown_cmd_is_one_finding_whatever_the_brick_makes_of_it() -> None:
    frame = raw("94 07 01 00")
    finding, report = only(frame), check(frame)
    assert (finding.code, finding.operation, span(finding, frame)) == ("E208", "SOUND", "07")
    assert report.rejected_at == 10
    assert finding.message == (
        "SOUND has no CMD 7; the brick reads the next bytes as operations, and refuses the command at offset 10"
    )
    assert finding.help == "use a CMD of SOUND; `ev3proto ops SOUND` lists them"
    assert check(raw("94 07 01")).accepted
    assert only(raw("94 07 01")).message.endswith("; the brick does not notice, and runs the next bytes as operations")
    assert only(raw("94 820101 01")).message == "SOUND has no CMD 257"
    assert only(raw("94 3F")).message.startswith("SOUND has no CMD -1;")
    assert only(raw("FF 04 60")).operation == "TST"


def test_counts() -> None:
    frame = raw("2F 40 83FFFFFFFF 01", memory=4 << 10)
    assert (only(frame).code, span(only(frame), frame)) == ("E207", "83 ff ff ff ff")
    assert only(frame).message == ("LENGTH is -1: the brick reads millions of values before it does anything else")
    frame = raw("2F 40 05 01 02", memory=5 << 10)
    assert (only(frame).code, only(frame).message) == (
        "E203",
        "LENGTH says 5 values, but only 2 bytes follow",
    )
    frame = raw("2F 40 82F401 01 02", memory=500 % 64 << 10)
    assert "LENGTH says 500 values, but only 2 bytes follow" in [it.message for it in check(frame).findings]
    frame = raw("94 07 2F 40 3F 01", memory=4 << 10)
    assert codes(frame) == ["E208", "E207"]
    frame = raw("99 1D 00 00 00 3F 3F 01", type=0)
    assert (only(frame).code, only(frame).parameter) == ("E211", "VALUES")


def test_what_newer_firmware_has() -> None:
    frame = asking(operation("UI_READ.GET_POWER", GV(0), GV(4), GV(8), GV(12)), global_size=16)
    assert (only(frame).code, check(frame).rejected_at) == ("E212", 12)
    assert codes(frame, dialect="compat") == []


def test_the_first_parameter_and_the_others() -> None:
    """The same mistake, which the firmware notices once."""
    assert codes(raw("A6 82C801 01")) == ["E204"]
    assert codes(raw("A3 00 82C801 00")) == ["E301"]
    assert codes(raw("A4 00 01 8180")) == ["W302"]
    assert codes(raw("A6 8180 01")) == ["E204"]
    assert only(raw("30 82C801 40", memory=1 << 10)).help == "use -127 to 127"
    assert codes(raw("A6 8A0001 01")) == ["E204"]
    assert only(raw("60 8AC801 40", memory=4 << 10)).help == "use a text"


def test_misaligned() -> None:
    frame = asking(operation("UI_READ.GET_VBATT", GV(2)), global_size=6)
    assert (only(frame).code, only(frame).help) == ("E205", "use a multiple of 4")
    frame = asking(operation("INPUT_DEVICE.READY_SI", 0, 0, 0, -1, [GV(1)]), global_size=5)
    assert (only(frame).code, check(frame).accepted) == ("W405", True)
    frame = command(operation("UI_DRAW.TEXTBOX", 0, 0, 9, 9, LV(0), 1, 0, LV(3)), local_size=8)
    assert "W405" in codes(frame)


# 3: values


def test_what_the_brick_cuts_down() -> None:
    frame = raw("A4 00 01 82C800")
    assert (only(frame).code, only(frame).message) == (
        "W301",
        "POWER is 200, which the brick reads as -56: it is a DATA8, -127 to 127",
    )
    assert only(frame).help == "write -56 if these bits are meant, otherwise a number that fits"
    frame = raw("A4 00 01 822C01")
    assert (only(frame).code, only(frame).message) == (
        "E301",
        "POWER is 300, which the brick truncates to 44: it is a DATA8, -127 to 127",
    )
    assert only(frame).help == "use -100 to 100 %"
    frame = raw("94 01 82C800 82B801 82E803")
    assert (only(frame).code, only(frame).message) == (
        "W303",
        "VOLUME is 200 %, outside of 0 to 100 %; the brick reads it as -56",
    )


def test_names_and_special_values() -> None:
    frame = command(operation("UI_WRITE.LED", 9), operation("UI_WRITE.LED", 10))
    assert (only(frame).code, only(frame).offset) == ("W304", 12)
    assert codes(asking(operation("INPUT_READ", 0, 0, 55, -1, GV(0)), global_size=1)) == []
    assert codes(asking(operation("INPUT_READ", 0, 0, 45, 8, GV(0)), global_size=1)) == ["W304", "W303"]
    assert codes(command(operation("INPUT_DEVICE.CLR_ALL", -1))) == []
    assert codes(command(operation("INPUT_DEVICE.CLR_ALL", 4))) == ["W303"]


def test_constants_in_place_of_variables() -> None:
    assert codes(raw("81 01 00")) == ["E302"]
    assert codes(raw("81 0A 05 84 78 00")) == ["E302"]
    assert codes(raw("94 02 01 05")) == ["E303"]
    assert codes(raw("A3 00 843100 01")) == ["E304"]
    assert codes(raw("82 02 05 04 02")) == ["E305"]
    assert codes(raw("82 02 00 04 02")) == []
    assert codes(raw("82 02 830000A040 04 02")) == []
    assert codes(raw("82 02 830000C07F 04 02")) == ["W302"]


def test_a_text_for_a_number_of_any_width() -> None:
    assert codes(raw("85 84 31 00 40 86 40", memory=4 << 10)) == ["E304"]
    assert codes(raw("A4 00 01 84 31 00")) == ["E304"]


def test_handles_and_addresses_are_not_looked_into() -> None:
    """Only the brick knows whether it exists."""
    assert codes(raw("7D 05 9105 9106")) == []
    assert codes(raw("A3 00 8B00000000 01")) == []


# 4: memory


def test_variables_beyond_their_memory() -> None:
    frame = asking(operation("UI_READ.GET_VBATT", GV(0)), global_size=3)
    assert (only(frame).code, only(frame).message) == (
        "E402",
        "VALUE takes bytes 0 to 3 of global memory, but the header requests 3 bytes of global memory",
    )
    assert only(frame).help == "request 4 bytes of global memory, or use a lower index"
    frame = asking(operation("UI_READ.GET_VBATT", GV(1020)), global_size=1019)
    assert only(frame).help == "use a lower index; global memory has at most 1019 bytes"
    assert only(asking(operation("UI_READ.GET_LBATT", GV(0)))).message == (
        "PCT takes byte 0 of global memory, but the header requests no global memory"
    )
    assert codes(command(operation("TIMER_READ", LV(0)), local_size=3)) == ["E401"]


def test_arrays_take_as_much_as_their_length_says() -> None:
    names = operation("INPUT_DEVICE.GET_NAME", 0, 0, 12, GV(0))
    assert codes(asking(names, global_size=12)) == []
    assert codes(asking(names, global_size=11)) == ["E402"]
    samples = operation("INPUT_SAMPLE", 0, 2, LV(0), LV(4), LV(6), LV(8), LV(10), GV(0))
    assert codes(asking(samples, global_size=8, local_size=12)) == []
    assert codes(asking(samples, global_size=7, local_size=11)) == ["E401", "E402"]
    read = operation("READ32", LV(0), 3, GV(0))
    assert codes(asking(read, global_size=4, local_size=16)) == []
    assert codes(asking(read, global_size=4, local_size=15)) == ["E401"]


def test_elements_of_arrays() -> None:
    write = operation("WRITE16", 7, 2, LV(0))
    assert codes(command(write, local_size=6)) == []
    assert codes(command(write, local_size=5)) == ["E401"]
    assert codes(command(operation("WRITE16", 7, LV(6), LV(0)), local_size=8)) == []
    assert codes(command(operation("WRITE16", 7, 2, GV(0)), global_size=6)) == ["W404"]
    digest = ev3proto.operation("FILE_MD5SUM", "x", GV(0), GV(16), dialect="xtended")
    assert codes(asking(digest, global_size=17), dialect="xtended") == []
    assert codes(asking(digest, global_size=15), dialect="xtended") == ["E402", "E402"]


def test_handles_are_two_bytes_and_addresses_four() -> None:
    handle, address = (LV(2, handle=True), LV(4, address=True))
    frame = command(operation("UI_DRAW.TEXT", 1, 0, 0, handle), operation("UI_DRAW.UPDATE"), local_size=4)
    assert codes(frame) == []
    assert codes(frame.replace(b"\x10\x84", b"\x0c\x84")) == ["E401"]
    assert codes(command(operation("UI_WRITE.PUT_STRING", address), local_size=8)) == []
    assert codes(command(operation("UI_WRITE.PUT_STRING", address), local_size=7)) == ["E401"]
    assert codes(command(operation("UI_WRITE.PUT_STRING", LV(3, handle=True)), local_size=5)) == ["E205"]


def test_results_that_overlap() -> None:
    battery, level = operation("UI_READ.GET_VBATT", GV(0)), operation("UI_READ.GET_LBATT", GV(3))
    assert only(asking(battery, level, global_size=4)).message == (
        "PCT takes bytes 3 to 3, and VALUE of UI_READ.GET_VBATT takes 0 to 3: the later one destroys the other"
    )
    assert codes(asking(battery, battery, global_size=4)) == ["W402"]
    used = operation("MOVEF_F", GV(0), LV(0))
    assert codes(asking(battery, used, battery, global_size=4, local_size=4)) == []
    assert codes(asking(battery, operation("JR", 0), battery, global_size=4)) == []
    filled = operation("INIT_BYTES", GV(0), 3, [1, 2, 3])
    assert codes(asking(filled, operation("MOVE8_8", 5, GV(1)), global_size=3)) == []
    scratch = operation("TIMER_WAIT", 5, LV(0)), operation("TIMER_READY", LV(0))
    assert codes(command(*scratch, *scratch, local_size=4)) == []


def test_results_that_are_not_sent() -> None:
    frame = command(operation("UI_READ.GET_VBATT", GV(0)), global_size=4)
    assert (only(frame).code, span(only(frame), frame)) == ("W404", "80")
    motor = operation("INPUT_READ", 0, 0, 0, 0, GV(0)), operation("OUTPUT_POWER", 0, 1, GV(0))
    assert codes(command(*motor, global_size=1)) == []
    assert codes(command(operation("UI_READ.GET_VBATT", LV(0)), local_size=4)) == []
    assert codes(command(operation("NOP"), global_size=4)) == ["W403"]


def test_memory_that_nothing_uses() -> None:
    assert only(asking(operation("UI_READ.GET_LBATT", GV(0)), global_size=20)).help == "request 1"
    assert codes(asking(operation("UI_READ.GET_LBATT", GV(0)), global_size=4)) == []
    assert codes(command(operation("NOP"), local_size=1)) == ["H401"]
    unknown = operation("STRINGS.ADD", "a", "b", GV(0))
    assert codes(asking(unknown, global_size=50)) == []


@pytest.mark.parametrize(
    ("used", "requested", "help_text"),
    [
        (1, 4, None),  # rounded up to the largest number
        (5, 8, None),
        (4, 5, "request 4"),
        (4, 7, "request 4"),
        (4, 8, "request 4"),  # a whole number more
        (8, 8, None),
        (0, 4, "request none"),
    ],
)
def test_memory_may_be_rounded_up_to_whole_numbers(used: int, requested: int, help_text: str | None) -> None:
    outputs = [operation("UI_READ.GET_LBATT", GV(used - 1))] if used else [operation("NOP")]
    found = check(asking(*outputs, global_size=requested)).findings
    about = [finding.help for finding in found if finding.code == "H401"]
    assert about == ([] if help_text is None else [help_text.replace("none", "0")])


def test_a_label_in_a_variable_needs_no_alignment() -> None:
    assert codes(command(operation("LABEL", LV(1)), local_size=5)) == codes(
        command(operation("LABEL", LV(4)), local_size=8)
    )


# 5: texts and arrays


def test_arrays_in_the_command_itself() -> None:
    assert codes(command(operation("INPUT_WRITE", 0, 0, 3, "AB"))) == []
    assert codes(command(operation("INPUT_WRITE", 0, 0, 2, "AB"))) == []
    assert codes(command(operation("INPUT_WRITE", 0, 0, 4, "AB"))) == ["E501"]
    assert codes(command(operation("INPUT_WRITE", 0, 0, 1, "AB"))) == ["W501"]
    assert codes(command(operation("INPUT_WRITE", 0, 0, 1, 65))) == []
    assert codes(command(operation("INPUT_WRITE", 0, 0, 5, 65))) == ["E501"]
    assert codes(command(operation("INPUT_WRITE", 0, 0, LV(0), "AB"), local_size=1)) == ["W406"]


def test_names_that_are_too_long() -> None:
    assert codes(command(operation("COM_SET.SET_BRICKNAME", "x" * 118))) == []
    frame = command(operation("COM_SET.SET_BRICKNAME", "x" * 119))
    assert (only(frame).code, only(frame).help) == ("E502", "shorten it by 1")


def test_mailboxes_have_limits() -> None:
    def written(name: int, text: int) -> list[str]:
        return codes(command(operation("MAILBOX_WRITE", "", 0, "n" * name, 4, 1, "t" * text)))

    assert codes(command(operation("MAILBOX_OPEN", 0, "n" * 49, 4, 0, 0))) == written(49, 249) == []
    assert codes(command(operation("MAILBOX_OPEN", 0, "n" * 50, 4, 0, 0))) == written(50, 249) == ["E502"]
    assert written(49, 250) == ["E502"]


# 6: the way through the code


def test_jumps() -> None:
    assert codes(raw("41 40 03 82 1B 01", memory=1 << 10)) == []
    assert only(raw("41 40 04 82 1B 01", memory=1 << 10)).message == (
        "OFFSET is 4, which leads to offset 14, but the operations are at 7 to 12"
    )
    assert (
        only(raw("41 40 3C", memory=1 << 10)).help
        == "use -3 to jump to the first operation, or 0 to jump to the end, counted from the end of the jump"
    )
    assert only(raw("41 40 02 82 1B 01", memory=1 << 10)).help == ("use 0 to run UI_WRITE.LED, or 3 to skip it")
    assert codes(raw("41 40 A005 82 1B 01 0D 05", memory=1 << 10)) == []
    assert codes(raw("41 40 A006 82 1B 01 0D 05", memory=1 << 10)) == ["E603"]
    assert codes(raw("41 40 A000 82 1B 01", memory=1 << 10)) == []


def test_dead_ends() -> None:
    frame = raw("40 03 82 1B 01 01")
    assert (only(frame).code, span(only(frame), frame)) == ("W601", "82 1b 01")
    assert codes(raw("01 40 3D")) == ["W602"]
    assert codes(raw("40 3E")) == ["W602"]
    assert codes(raw("40 3E 01")) == ["W602", "W601"]
    assert codes(raw("02 02 40 3C")) == []
    assert codes(raw("40 41", memory=5 << 10)) == ["E205", "W604"]


def test_operations_after_the_end() -> None:
    frame = raw("82 1B 01 0A 82 1B 02")
    assert (only(frame).code, span(only(frame), frame)) == ("E202", "82 1b 02")
    assert codes(raw("82 1B 01 0A")) == ["H601"]
    assert codes(raw("82 1B 01 0A B5 81", memory=4)) == ["E202"]


# 7: sounds, drawings, moves


def test_sounds() -> None:
    tone, wait = operation("SOUND.TONE", 1, 440, 100), operation("SOUND_READY")
    timer = operation("TIMER_WAIT", 100, LV(0)), operation("TIMER_READY", LV(0))
    assert codes(command(tone, tone)) == ["W701"]
    assert codes(command(tone, wait, tone)) == []
    assert codes(command(tone, *timer, tone, local_size=4)) == []
    assert codes(command(tone, timer[0], tone, local_size=4)) == ["W701"]
    assert codes(command(tone, operation("SOUND.BREAK"))) == ["W701"]
    assert codes(command(operation("SOUND.BREAK"), tone)) == []


def test_drawings() -> None:
    dot, update = operation("UI_DRAW.PIXEL", 1, 5, 5), operation("UI_DRAW.UPDATE")
    clean = operation("UI_DRAW.CLEAN")
    assert codes(command(dot, update)) == []
    assert (only(command(dot, dot)).code, only(command(dot, dot)).offset) == ("W702", 12)
    assert codes(command(clean, dot, update, dot, update)) == []
    assert codes(command(dot, update, clean, update)) == ["W703"]
    assert codes(command(operation("UI_DRAW.TOPLINE", 0), update)) == []


def test_moves() -> None:
    move, other = (operation("OUTPUT_STEP_SPEED", 0, ports, 30, 0, 90, 0, 1) for ports in (3, 2))
    third = operation("OUTPUT_STEP_SPEED", 0, 4, 30, 0, 90, 0, 1)
    ready, stop = operation("OUTPUT_READY", 0, 3), operation("OUTPUT_STOP", 0, 1, 1)
    assert codes(command(move, other)) == ["W704"]
    assert codes(command(move, third)) == []
    assert codes(command(move, ready, other)) == []
    assert codes(command(move, stop)) == ["W704"]
    assert codes(command(stop, move)) == []


# 8: system messages


def test_system_commands() -> None:
    frame = ev3proto.system_command("LIST_FILES", max_bytes=1000, path="../prjs/").build()
    assert codes(frame) == []
    short = b"\x05" + frame[1:7]
    assert (only(short).code, check(short).rejected_at) == ("E802", 6)
    assert codes(frame[:4] + b"\x81" + frame[5:]) == ["W802"]
    assert codes(bytes.fromhex("04002A000142")) == ["E801"]
    assert codes(bytes.fromhex("03002A0001")) == ["E801"]
    assert codes(ev3proto.system_command("CLOSE_FILEHANDLE", handle=1).build()) == []


@pytest.mark.parametrize(
    ("frame", "found"),
    [
        ("0300 2A00 01", ["E801"]),
        ("0400 2A00 01", ["E102"]),
        ("0200 2A00 01", ["E103"]),
        ("0400 2A00 01 98", ["E802"]),
        ("0500 2A00 01 98", ["E102"]),
        ("0300 2A00 01 98", ["E103"]),
        ("0500 2A00 01 98 00", []),
        ("0600 2A00 01 98 00", ["E102"]),
        ("0400 2A00 01 98 00", ["E103"]),
    ],
)
def test_a_wrong_length_is_one_finding(frame: str, found: list[str]) -> None:
    """CLOSE_FILEHANDLE has its number and a handle; what lacks because of the length is not said again."""
    assert codes(bytes.fromhex(frame)) == found


@pytest.mark.parametrize(
    ("path", "part"),
    [
        ("../prjs/" + "x" * 31 + ".rbf", None),
        ("../prjs/" + "x" * 32 + ".rbf", "x" * 32),
        ("../prjs/x.rbfs", ".rbfs"),
        ("../prjs/123456789.rbfs", ".rbfs"),
        ("../prjs/" + "x" * 31 + ".rbfs", ".rbfs"),
        ("../" + "p" * 79 + "/x.rbf", None),
        ("../" + "p" * 80 + "/x.rbf", "../" + "p" * 80 + "/"),
        ("x" * 120, "x" * 120),
        ("", "\0"),
    ],
)
def test_paths(path: str, part: str | None) -> None:
    frame = ev3proto.system_command("BEGIN_DOWNLOAD", size=1, path=path).build()
    report = check(frame)
    if part is None:
        assert report.findings == ()
        return
    (finding,) = report.findings
    assert (finding.code, finding.parameter, report.accepted) == ("E803", "path", False)
    assert frame[finding.offset : finding.offset + finding.length] == part.encode()
    assert report.rejected_at == finding.offset


def test_what_goes_by_usb_only() -> None:
    for frame in (
        bytes.fromhex("04002A0001F6"),
        ev3proto.system_command("BLUETOOTHPIN", mac="00165342AABB", pin="1234").build(),
    ):
        assert codes(frame) == codes(frame, carrier="usb") == []
        assert codes(frame, carrier="bluetooth") == codes(frame, carrier="wifi") == ["E805"]


# 9: encodings


def test_longer_forms() -> None:
    frame = command(operation("SOUND.TONE", encode_as("LC4", 5), 440, encode_as("LC4", 1000)))
    assert codes(frame) == ["H901", "H901"]
    assert check(frame).findings[0].help == "write it as 05"
    frame = asking(operation("UI_READ.GET_VBATT", encode_as("GV2", 0)), global_size=4)
    assert only(frame).help == "write it as 60"
    assert only(raw("82 811B 01")).parameter == "CMD"
    assert codes(command(operation("MOVEF_F", 0.5, LV(0)), local_size=4)) == []


def test_jumps_into_operations_are_followed() -> None:
    """A text may end before it, or a jump may lead back for ever."""
    ends = "40 03 7D 01 84 01 01 40 02 00 60"
    assert codes(raw(ends, type=0, memory=2)) == ["E602"]
    endless = "40 03 7D 01 84 01 01 40 3C 00 60"
    assert codes(raw(endless + "01", type=0, memory=2)) == ["W602", "E602", "W601"]


def test_a_jump_by_a_variable_is_told() -> None:
    frame = bytes.fromhex("1300010000041030034040407d0184a6440f0a0060")
    assert (only(frame).code, span(only(frame), frame)) == ("W604", "40")
    assert codes(raw("41 40 81 41", memory=4 << 10)) != ["W604"]


def test_messages_to_mailboxes() -> None:
    def found(name: str, payload: bytes) -> list[tuple[str, int, int, str]]:
        report = check(system.writemailbox(name, payload).build())
        assert report.accepted
        return [(one.code, one.offset, one.length, one.message) for one in report.findings]

    for fits in (b"hi\0", b"", b"\0", b"\1", bytes.fromhex("0000C03F"), b"@@HB", b"\x05", b"a" * 249 + b"\0"):
        assert found("a" * 49, fits) == []
    assert found("a", b"hi") == [("W805", 11, 2, NO_ZERO)]
    assert found("a", b"stop") == [("W805", 11, 4, NO_ZERO)]
    assert found("a", b"b" * 250 + b"\0") == [
        ("W804", 11, 251, "the message has 251 bytes, but a mailbox has room for only 250")
    ]
    assert found("a" * 50, b"\1") == [("W804", 7, 50, "the name has 50 characters; that of a mailbox has at most 49")]


@pytest.mark.parametrize(
    ("payload", "number", "kind", "right"),
    [
        ("0A 00 00 00", "10", "a whole number of 4 bytes", "00 00 20 41"),
        ("00 00 03 E8", "1000", "a big-endian whole number of 4 bytes", "00 00 7A 44"),
        ("41 20 00 00", "10", "a big-endian float", "00 00 20 41"),
        ("00 00 00 00 00 00 F8 3F", "1.5", "a double", "00 00 C0 3F"),
        ("3F F8 00 00 00 00 00 00", "1.5", "a big-endian double", "00 00 C0 3F"),
        ("05 00", "5", "a whole number of 2 bytes", "00 00 A0 40"),
    ],
)
def test_numbers_of_other_types_in_mailboxes(payload: str, number: str, kind: str, right: str) -> None:
    (found,) = check(system.writemailbox("abc", bytes.fromhex(payload)).build()).findings
    assert (found.code, found.offset, found.length) == ("W806", 13, len(bytes.fromhex(payload)))
    assert (
        found.message
        == f"the message is {number} as {kind}; a program reads a number as a float of 4 bytes, little-endian"
    )
    assert found.help == f"send {right} for {number}"


NO_ZERO = "the message looks like a text without a zero at its end"


def test_downloads_may_be_longer_than_other_frames_but_not_on_usb() -> None:
    long = system.continue_download(0, bytes(1100)).build()
    for carrier in (None, "wifi", "bluetooth"):
        report = check(long, carrier=carrier)
        assert report.accepted
        assert report.findings == ()
    finding = only(long, carrier="usb")
    assert (finding.code, finding.offset, finding.length) == ("E104", 1024, 83)
    assert finding.message == "a frame has at most 1024 bytes on USB, this one has 1107"
    cut = only(long[:900])
    assert (cut.code, cut.offset) == ("E102", 0)
    assert "1105 bytes follow it, but there are 898" in cut.message


@pytest.mark.parametrize("operations", ["A1 A1 14 00 01", "A5 00 01 A1 14 A6 00 01", "A5 00 01 A1 1F A6 00 01"])
def test_a_label_for_a_number(operations: str) -> None:
    (found,) = check(raw(operations)).findings
    assert found.code == "E307"
    assert " is LAB1, a label: the brick puts the place of label " in found.message


@pytest.mark.parametrize(
    ("operations", "number"),
    [
        ("A5 00 01 A1 00 A6 00 01", 0),  # jumps name labels from 1 on
        ("A5 00 01 A1 20 A6 00 01", 32),
        ("A5 00 01 A1 32 A6 00 01", 50),
        ("A5 00 01 A1 CE A6 00 01", -50),  # SPEED has one byte
        ("94 01 01 A1 C8 82 E8 03", 200),  # FREQUENCY has two
    ],
)
def test_labels_from_32_on_are_numbers(operations: str, number: int) -> None:
    (found,) = check(raw(operations)).findings
    assert found.code == "W305"
    assert f"labels are 1 to 31: the brick takes this one as the number {number}" in found.message


def test_labels_of_jumps_are_labels() -> None:
    assert codes(raw("0D 01 40 A0 01")) == ["W602"]


def test_a_text_with_other_bits_is_a_text_too() -> None:
    assert "E304" in codes(raw("A5 00 01 9C A6 00 01"))


@pytest.mark.parametrize(("characters", "sentence"), [(119, None), (120, "120 characters"), (125, "125 characters")])
def test_a_text_that_is_too_long_is_counted(characters: int, sentence: str | None) -> None:
    frame = command(operation("UI_DRAW.BMPFILE", 1, 0, 0, "a" * characters))
    about = [(finding.message, finding.help) for finding in check(frame).findings if finding.code == "E502"]
    if sentence is None:
        assert about == []
    else:
        over = characters - 119
        assert about == [(f"NAME has {sentence}; the firmware accepts at most 119", f"shorten it by {over}")]


def requesting(globals_: int) -> bytes:
    contents = bytes.fromhex("2A00 00") + globals_.to_bytes(2, "little") + b"\x01"
    return len(contents).to_bytes(2, "little") + contents


def stating(size: int, length: int) -> bytes:
    return length.to_bytes(2, "little") + bytes.fromhex("2A00 80 0000") + b"\x01" * (size - 7)


def mailing(name: int, message: int) -> bytes:
    return ev3proto.system_command("WRITEMAILBOX", name="a" * name, payload=bytes(message), reply=False).build()


def downloading(size: int) -> bytes:
    return ev3proto.system_command("BEGIN_DOWNLOAD", path="../prjs/a.rbf", size=size).build()


@pytest.mark.parametrize(
    ("frame", "found"),
    [
        (requesting(0), []),
        (requesting(1019), ["H401"]),
        (requesting(1020), ["W102"]),
        (requesting(1021), ["W102"]),
        (requesting(1022), ["E107"]),
        (requesting(1023), ["E107"]),
        (stating(1024, 1021), ["E103"]),
        (stating(1024, 1022), []),
        (stating(1024, 1023), ["E102"]),
        (stating(1025, 1022), ["E103"]),
        (stating(1025, 1023), ["E104"]),
        (stating(1025, 1024), ["E104"]),
        (mailing(49, 250), []),
        (mailing(49, 251), ["W804"]),
        (mailing(50, 250), ["W804"]),
        (downloading(1 << 24), []),
        (downloading((1 << 24) + 1), ["W807"]),
    ],
)
def test_limits(frame: bytes, found: list[str]) -> None:
    """A reply carries 1,019 bytes, the firmware grants 1,021; a frame has 1,024, a mailbox 250, a brick 16 MB."""
    assert codes(frame) == found


@pytest.mark.parametrize("distance", ["00", "01", "02"])
def test_a_jump_to_what_cannot_be_read_is_not_one_into_an_operation(distance: str) -> None:
    """To NOP, to the unknown opcode FE, and to the end."""
    assert codes(bytes.fromhex(f"0900 2A00 80 0000 40 {distance} 01 FE")) == ["E201"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("80|00:20|C0:08:00:84:61:00:40:44", ["W706"]),  # loaded into the slot of the menu
        ("80|00:00|02:00", ["W706"]),
        ("80|00:00|02:01", []),
        ("80|08:00|C0:08:01:84:61:00:60:64|03:02:60:64:00", ["W707"]),
        ("80|00:20|03:01:40:44:00", ["W708"]),  # a local variable that nothing fills
        ("80|08:00|C0:08:01:84:61:00:60:64|03:01:64:60:00", ["W709"]),  # its size for its address
        ("80|08:00|C0:08:01:84:61:00:60:64|03:01:01:64:00", []),  # the size is ignored
        ("80|08:00|03:01:60:64:00", []),  # global memory may hold what an earlier command stored
        ("80|00:00|B0:00:07:1E:00:82:68:01:01", ["H707"]),
        ("80|00:00|B1:00:06:1E:00:82:68:01:01", []),
        ("80|00:10|85:0A:40|86:40", []),  # a result that the command itself reads
        ("00|00:10|81:01:40", ["W407"]),
        ("00|00:04|0C:16:01:40", ["W407"]),  # PROGRAM_INFO.GET_STATUS
        # Started before it was loaded.
        ("80|00:20|03:01:40:44:00|C0:08:01:84:61:00:40:44", ["W708"]),
    ],
)
def test_operations_together(text: str, said: list[str]) -> None:
    frame = bytes.fromhex(f"2A00{text}".replace("|", "").replace(":", ""))
    report = check(len(frame).to_bytes(2, "little") + frame)
    assert [one.code for one in report.findings if one.code in ("W706", "W707", "W708", "W709", "H707", "W407")] == said

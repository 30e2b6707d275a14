"""What was meant by a wrong frame: each kind of slip by its example, and what holds for every frame."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.effort import effort

import ev3proto
from ev3proto.checking import nearest as search
from ev3proto.checking.checking import check
from ev3proto.checking.codes import CODES
from ev3proto.checking.dangers import acts_of
from ev3proto.checking.report import Suggestion
from ev3proto.checking.slips import SLIPS
from ev3proto.schema.header import with_length
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.declaration import DIALECTS
from ev3proto.testing import frames, mutated_frames

many = settings(max_examples=effort(50, 1000), deadline=None)


def nearest(text: str) -> tuple[Suggestion, ...]:
    return ev3proto.check(bytes.fromhex(text), alone=True).nearest


def code(text: str, *, header: str = "0100 80 0000") -> tuple[Suggestion, ...]:
    return nearest(with_length(bytes.fromhex(f"{header} {text}")).hex())


@pytest.mark.parametrize("kind", SLIPS)
def test_every_slip_leads_to_the_frame_that_was_meant(kind: str) -> None:
    first = nearest(SLIPS[kind].wrong)[0]
    right = bytearray(bytes.fromhex(SLIPS[kind].right))
    for at, size in first.unknown:
        right[at : at + size] = first.frame[at : at + size]
    assert (first.kind, first.frame) == (kind, bytes(right))
    assert "{" not in first.message


@pytest.mark.parametrize("kind", SLIPS)
def test_nothing_is_said_of_the_frame_that_was_meant(kind: str) -> None:
    report = ev3proto.check(bytes.fromhex(SLIPS[kind].right), alone=True)
    assert report.accepted
    assert not report.errors
    assert not report.nearest


def test_a_suggestion_tells_place_and_sentence() -> None:
    (one,) = code("94 02 02 68656C6C00")
    assert (one.kind, one.offset, one.length) == ("no-84", 10, 0)
    assert one.message == "the text NAME of SOUND.PLAY begins with its identification byte, 84"
    assert one.frame == bytes.fromhex("0E00 0100 80 0000 94 02 02 84 68656C6C00")
    assert (one.unknown, one.is_sure) == ((), True)


def test_bytes_that_can_only_be_guessed_are_unknown() -> None:
    one = nearest("1100 0100 80 0000 AE 00 01 8132 00 828403 00 A6 00 01")[0]
    assert one.message == "BRAKE of OUTPUT_STEP_SPEED is missing"
    assert (one.unknown, one.is_sure) == (((17, 1),), False)


def test_two_arguments_that_are_missing_are_both_named() -> None:
    """OUTPUT_TIME_SYNC without LAYER and NOS; SOUND.TONE without VOLUME and FREQUENCY."""
    (one,) = nearest("0D00 0100 80 0000 B1 00 814B 82B80B 00")
    assert one.message.startswith("LAYER of OUTPUT_TIME_SYNC is missing; so is NOS of OUTPUT_TIME_SYNC")
    assert not one.is_sure
    (one,) = nearest("0A00 0100 80 0000 94 01 82B801")
    assert (one.message, one.unknown) == (
        "VOLUME of SOUND.TONE is missing; so is FREQUENCY of SOUND.TONE",
        ((9, 1), (10, 3)),
    )


def test_a_wrong_digit() -> None:
    """LAYER 0E for 00; CMD 0C of SOUND for 02; the local memory 0E for 00; GV(0) as C0."""
    for wrong, right in (
        ("0D00 0100 80 0000 A5 0E 01 8132 A6 00 01", "0D00 0100 80 0000 A5 00 01 8132 A6 00 01"),
        ("0F00 0100 80 0000 94 0C 19 84 68656C6C6F00", "0F00 0100 80 0000 94 02 19 84 68656C6C6F00"),
        ("0800 0200 80 000E 82 1B 09", "0800 0200 80 0000 82 1B 09"),
        ("0B00 0100 00 0100 9A 00 02 1D 00 C0", "0B00 0100 00 0100 9A 00 02 1D 00 60"),
    ):
        assert nearest(wrong)[0].frame == bytes.fromhex(right), wrong


def test_two_that_are_equally_likely_are_both_said() -> None:
    found = nearest("0D00 0100 08 0000 A5 00 01 8132 A6 00 01")
    assert [one.frame[4] for one in found] == [0x80, 0x00]
    assert not any(one.is_sure for one in found)


def test_labels_end_at_31_so_a_larger_number_is_rather_itself() -> None:
    assert [one.frame[10:12].hex() for one in code("A5 00 01 A1 32 A6 00 01")] == ["8132", "81ce"]
    assert [one.frame[10:11].hex() for one in code("A5 00 01 A1 14 A6 00 01")] == ["2c", "14"]


def test_a_habit_is_said_once() -> None:
    (one,) = code("94 01 02 82 03 E8 82 01 F4 96 94 01 02 82 02 0B 82 01 F4")
    assert one.frame[7:] == bytes.fromhex("94 01 02 82 E8 03 82 F4 01 96 94 01 02 82 0B 02 82 F4 01")


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("94 01 50 68 01 78", "94 01 8150 826801 8178"),
        ("84 18 01 50 64 19 84 09 01 64 64 3C 28 84 00", "84 18 01 8150 8164 19 84 09 01 8164 8164 813C 8128 84 00"),
        ("A5 01 8132 A6 01", "A5 00 01 8132 A6 00 01"),
    ],
)
def test_a_slip_out_of_habit(wrong: str, right: str) -> None:
    first = code(wrong)[0]
    assert first.frame[7:] == bytes.fromhex(right)
    assert "; the same in " in first.message


def test_a_length_in_decimal_names_both_forms() -> None:
    (one,) = nearest("1500 0000 80 0000 94 01 8102 82E803 82E803")
    assert one.message == "the length is written in hex: 15 is 0F 00, but 15 00 is 21"


def test_the_size_of_a_file_with_its_bytes_swapped() -> None:
    (one,) = nearest("1800 0000 01 92 000004D2 2E2E2F70726A732F612F612E72626600")
    assert (
        one.message == "the bytes of size of BEGIN_DOWNLOAD are swapped: 1234 is written D2 04 00 00, the low one first"
    )


@pytest.mark.parametrize(
    "text",
    [
        "0b00 2a00 02 0000c040 0000803f",
        "1300 2a00 02 00000000 00000000 00000000 00000000",
        "0b00 2a00 02 01010000 00000000",
    ],
)
def test_a_right_reply_was_meant(text: str) -> None:
    assert nearest(text) == ()


def test_a_number_of_another_type_is_not_a_missing_field() -> None:
    assert nearest("0f00 0100 81 9e 04 61626300 0400 05000000") == ()


def test_a_command_that_seems_to_be_a_reply() -> None:
    """Without its counter, the third byte of the mailbox's command is that of a reply's type."""
    (one,) = nearest("0A00 81 9E 04 61626300 0100 01")
    assert (one.kind, one.frame) == ("counter-missing", bytes.fromhex("0C00 0000 81 9E 04 61626300 0100 01"))
    assert nearest("0600 2A00 02 D0A500") == ()


def test_an_opcode_is_rarely_a_counter() -> None:
    """Behind the type and the memory, 82 and 1B begin the next operation."""
    (one, *_) = nearest("0600 80 0000 821B01")
    assert (one.kind, one.frame) == ("counter-missing", bytes.fromhex("0800 0000 80 0000 821B01"))


def test_a_result_left_out_before_a_program_starts() -> None:
    one, *_ = nearest("1100 0100 80 0020 C0 08 01 80 61 00 44 03 01 40 44 00")
    assert one.message == "SIZE of FILE.LOAD_IMAGE is missing; this would start, stop or change programs"


@pytest.mark.parametrize("name", CODES)
def test_right_frames_are_left_alone(name: str) -> None:
    entry = CODES[name]
    report = ev3proto.check(entry.counterexample, carrier=entry.carrier, alone=True)
    assert not report.nearest or report.findings


def test_frames_among_others_are_left_alone_unless_they_are_refused_or_have_errors() -> None:
    frame = bytes.fromhex("0E00 0100 80 0000 94 01 02 82C800 82F401")
    assert [finding.code for finding in ev3proto.check(frame).findings] == ["W303"]
    assert ev3proto.check(frame).nearest == ()


@many
@given(st.binary(max_size=12), st.sampled_from(DIALECTS), st.sampled_from((None, *CARRIERS)))
def test_no_bytes_make_it_raise(data: bytes, dialect: str, carrier: str | None) -> None:
    report = ev3proto.check(data, dialect=dialect, carrier=carrier, alone=True)
    assert all(len(one.frame) >= 5 for one in report.nearest)


@many
@given(frames() | mutated_frames())
def test_what_is_suggested_is_accepted_without_errors(frame: bytes) -> None:
    report = ev3proto.check(frame, alone=True)
    found = report.nearest
    assert len(found) <= 2
    assert not found or report.findings
    for one in found:
        after = ev3proto.check(one.frame, alone=True)
        assert one.frame != frame
        assert after.accepted or frame[4] not in (0, 1, 0x80, 0x81)
        assert not after.errors
        assert 0 <= one.offset <= one.offset + one.length <= len(frame)
        assert all(0 <= at < at + size <= len(one.frame) for at, size in one.unknown)


@pytest.mark.parametrize(
    ("operations", "meant"),
    [
        ("A4 00 0F 4B A6 00 0F", "A4 00 0F 814B A6 00 0F"),  # a variable beyond the memory
        ("A5 00 01 64 A6 00 01", "A5 00 01 8164 A6 00 01"),
        ("A5 00 01 9C A6 00 01", "A5 00 01 819C A6 00 01"),  # a text that takes the bytes after it
        ("A5 00 01 9C A6 01 01", "A5 00 01 819C A6 01 01"),  # one that does not end
        ("A5 00 01 EC A6 00 01", "A5 00 01 2C A6 00 01"),  # no argument at all
        ("A5 00 01 B5 A6 00 01", "A5 00 01 81B5 A6 00 01"),  # a label
        ("94 01 01 B8 01 82 E8 03", "94 01 01 82B801 82E803"),
        ("94 01 01 82 B8 01 E8 03", "94 01 01 82B801 82E803"),
        ("AE 00 01 1E 00 68 00 01", "AE 00 01 1E 00 8168 00 01"),
        ("82 1B 50", "82 1B 50"),  # the light has no pattern 80: more memory is likelier
        ("A5 00 01 E1 9C A6 00 01", "A5 00 01 E1 9C A6 00 01"),  # a long index is written on purpose
        ("30 05 4B A4 00 01 4B A6 00 01", "30 05 4B A4 00 01 4B A6 00 01"),  # the command itself writes it
    ],
)
def test_a_number_without_identification_byte(operations: str, meant: str) -> None:
    (one,) = code(operations)
    assert one.frame[7:] == bytes.fromhex(meant)


def test_the_counter_of_a_log_does_not_matter() -> None:
    """The suggestions are those of the first frame with this content, with the counter of each."""
    suggestions = search.Suggestions()
    for counter in ("0100", "0200"):
        frame = bytes.fromhex(f"0C00 {counter} 80 0000 A5 01 8132 A6 00 01")
        (one,) = suggestions.of(ev3proto.check(frame, alone=True))
        assert one.frame == bytes.fromhex(f"0D00 {counter} 80 0000 A5 00 01 8132 A6 00 01")


def test_the_type_of_a_frame_of_a_log_matters() -> None:
    """Only with a reply, a result in global memory may have been meant."""
    suggestions = search.Suggestions()
    for type_, kinds in (("80", []), ("00", ["variable"]), ("80", [])):
        frame = bytes.fromhex(f"0B00 0100 {type_} 0000 9A 00 00 00 00 1F")
        assert [one.kind for one in suggestions.of(ev3proto.check(frame, alone=True))] == kinds


@pytest.mark.parametrize(("size", "codes"), [("07", []), ("08", ["64 60", "60 64"]), ("09", ["64 60", "60 64"])])
def test_a_missing_result_takes_the_memory_that_is_left(size: str, codes: list[str]) -> None:
    """MEMORY_USAGE writes two numbers of four bytes; GV(4) ends at byte 8."""
    found = code("C5 60", header=f"0100 00 {size}00")
    assert [one.frame.hex(" ")[-5:] for one in found] == codes


@pytest.mark.parametrize(
    ("kind", "written"), [("width", "81 00 00 C0 3F"), ("width", "82 00 00 C0 3F"), ("raw", "00 00 C0 3F")]
)
def test_a_float_that_is_written_in_another_way(kind: str, written: str) -> None:
    """MOVEF_F takes 1.5 as 83 00 00 C0 3F."""
    (one, *_) = code(f"3F {written} 60", header="0100 00 0400")
    assert (one.kind, one.frame[7:]) == (kind, bytes.fromhex("3F 83 00 00 C0 3F 60"))


def test_an_element_of_a_mailbox_may_be_a_number_or_a_text() -> None:
    frame = bytes.fromhex("0A00 0100 00 0000 DA 01 04 01 60")
    report = ev3proto.check(frame, alone=True)
    assert report.nearest[0].frame == bytes.fromhex("0A00 0100 00 0400 DA 01 04 01 60")
    assert "request 4 bytes of global memory" in str(report)


def test_a_run_has_a_limit() -> None:
    suggestions = search.Suggestions()
    for number in range(101):
        assert not suggestions.is_stopped
        suggestions.of(ev3proto.check(bytes.fromhex(f"0C00 0100 80 0000 A5 01 81{number:02X} A6 00 01"), alone=True))
    assert suggestions.is_stopped


def test_a_result_is_taken_for_the_variable_of_a_short_number() -> None:
    """0 to 31 are written like the index of a variable; 20 is -32."""
    (one,) = code("9A 00 00 00 00 1F", header="0100 00 2000")
    assert (one.kind, one.frame.hex()[-2:]) == ("variable", "7f")
    assert "variable" not in [one.kind for one in code("9A 00 00 00 00 20", header="0100 00 2000")]
    (one,) = code("9A 00 00 00 00 1F", header="0100 00 00A0")
    assert (one.kind, one.frame.hex()[-2:]) == ("variable", "7f")
    assert "variable" not in [one.kind for one in code("9A 00 00 00 00 20", header="0100 00 00A0")]


@pytest.mark.parametrize(("locals_", "kinds"), [("0000", []), ("0004", ["variable"]), ("0008", ["variable"])])
def test_a_result_is_taken_for_a_local_variable_if_there_are_any(locals_: str, kinds: list[str]) -> None:
    """The header requests 0, 1 and 2 bytes of local memory."""
    assert [one.kind for one in code("9A 00 00 00 00 00", header=f"0100 80 {locals_}")] == kinds


def test_the_shortest_command_with_a_header_that_is_too_long() -> None:
    (one,) = nearest("0800 2A000000 80 0000 01")
    assert (one.kind, one.frame) == ("header-long", bytes.fromhex("0600 2A00 80 0000 01"))


STRANGE = {
    "06 00 80 03 B8 01 E8 03": (
        "this is a telegram of the NXT (PLAYTONE), LEGO's earlier brick; an EV3 does not know it"
    ),
    "04 00 80 0A 01 00": (
        "this is a telegram of the NXT (RESETMOTORPOSITION), LEGO's earlier brick; an EV3 does not know it"
    ),
    "08 00 81 32 11 51 00 64": (
        "this is a message of LEGO's Wireless Protocol (port output command), for hubs with Bluetooth Low Energy (its"
        " first byte counts all bytes, the second is the hub, the third the type); an EV3 does not know it"
    ),
    b"forward\r\n".hex(): (
        "this is the text 'forward', not a frame; a Messaging block needs WRITEMAILBOX: for its mailbox 'abc', send"
        " 13 00 00 00 81 9E 04 61 62 63 00 08 00 66 6F 72 77 61 72 64 00"
    ),
}


@pytest.mark.parametrize("data", STRANGE)
def test_what_was_not_meant_as_a_frame_has_one_finding_and_no_suggestion(data: str) -> None:
    report = ev3proto.check(bytes.fromhex(data), alone=True)
    (finding,) = report.findings
    assert (finding.code, finding.offset, finding.message) == ("E108", 0, STRANGE[data])
    assert (report.accepted, report.rejected_at, report.nearest) == (False, 0, ())


def test_the_digits_of_a_frame_are_fixed_to_the_frame() -> None:
    right = bytes.fromhex("0E 00 00 00 80 00 00 94 01 02 82 E8 03 82 E8 03")
    for text in (
        right.hex(),
        right.hex(" ").upper(),
        ",".join(map(str, right)),
        ", ".join(f"0x{one:02X}" for one in right),
    ):
        report = ev3proto.check(text.encode())
        assert [finding.code for finding in report.findings] == ["E108"], text
        (one,) = report.nearest
        assert (one.kind, one.offset, one.length, one.frame) == ("digits", 0, len(text), right)
        assert report.fixed.frame == right


@pytest.mark.parametrize(
    "text",
    [
        "0700 0100 80 F200 01 01",  # erases the firmware, if its type were another
        "0700 0100 00 9300 01 01",
        "0800 0100 00 F204 81 01 60",
        "0C00 0100 00 0008 02 03 04 64 3D 00 01",  # stops a program, and would start one, too
        "0900 0100 00 0800 C0 02 02 03",  # FILE.OPEN_LOG, and would write
        "0D00 0100 80 0000 0F 00 01 81 32 A6 00 01",  # an operation of programs, and would stop an object
    ],
)
def test_no_danger_is_suggested_for_a_frame_that_the_brick_accepts(text: str) -> None:
    report = check(bytes.fromhex(text), alone=True)
    assert not report.accepted or not [one for one in report.nearest if one.harm]
    before = bytes.fromhex(text)
    assert not [one for one in report.nearest if acts_of(one.frame, "official") - acts_of(before, "official")]


@many
@given(frames() | mutated_frames())
def test_what_is_worse_than_an_accepted_frame_is_motion_or_a_name(frame: bytes) -> None:
    report = check(frame, alone=True)
    for one in report.nearest if report.accepted else ():
        new = acts_of(one.frame, "official") - acts_of(frame, "official")
        assert {each.words for each, _ in new} <= {"make motors turn", "give the brick another name"}
        assert one.harm in one.message
        assert bool(one.harm) == bool(new)


@pytest.mark.parametrize(
    ("wrong", "right", "kind"),
    [
        # As LEGO's Communication Developer Kit prints it: the CMD after LAYER and NO.
        ("0B00 0000 00 1000 99 00 00 15 10 60", "0B00 0000 00 1000 99 15 00 00 10 60", "cmd-place"),
        ("0900 0100 00 0200 99 05 00 10", "0B00 0100 00 0200 99 05 00 10 60 61", "no-results"),
        ("0B00 0100 00 0400 99 1D 00 00 00 00", "0D00 0100 00 0400 99 1D 00 00 00 00 01 60", "no-results"),
        # INPUT_READEXT, whose FORMAT 12 is a float.
        ("0C00 0100 00 0400 9E 00 01 1D 02 12 01", "0D00 0100 00 0400 9E 00 01 1D 02 12 01 60", "no-results"),
        ("0B00 0100 00 0010 99 1E 00 02 40 44", "0B00 0100 00 0800 99 1E 00 02 60 64", "scope"),
        ("0900 0100 00 0104 83 01 01 40", "0900 0100 00 0104 83 01 01 60", "scope"),
        ("0400 01 9D 0100", "0400 0100 01 9D", "header-order"),
        ("0C00 0100 00 0800 99 1D 00 00 00 00 02", "0E00 0100 00 0800 99 1D 00 00 00 00 02 60 64", "no-results"),
        ("0800 0100 00 0010 81 01 40", "0800 0100 00 0400 81 01 60", "scope"),
        ("0B00 0100 00 0208 99 05 00 00 40 41", "0B00 0100 00 0208 99 05 00 00 60 61", "scope"),
        ("0D00 0100 0000 80 A5 00 01 81 32 A6 00 01", "0D00 0100 80 0000 A5 00 01 81 32 A6 00 01", "header-order"),
        ("0D00 80 2A01 0000 A5 00 01 81 32 A6 00 01", "0D00 2A01 80 0000 A5 00 01 81 32 A6 00 01", "header-order"),
        ("0C00 81 9E 0100 04 61626300 0100 01", "0C00 0100 81 9E 04 61626300 0100 01", "header-order"),
        ("0800 00 2A01 0400 81 01 60", "0800 2A01 00 0400 81 01 60", "header-order"),
        ("0800 00 0400 2A00 81 01 60", "0800 2A00 00 0400 81 01 60", "header-order"),
        ("0D00 80 0000 2A00 A5 00 01 81 32 A6 00 01", "0D00 2A00 80 0000 A5 00 01 81 32 A6 00 01", "header-order"),
        ("0D00 0000 2A00 80 A5 00 01 81 32 A6 00 01", "0D00 2A00 80 0000 A5 00 01 81 32 A6 00 01", "header-order"),
        ("0C00 81 2A00 9E 04 61626300 0100 01", "0C00 2A00 81 9E 04 61626300 0100 01", "header-order"),
        ("0400 2A00 9D 01", "0400 2A00 01 9D", "header-order"),
        ("0F00 0000 50 0000 5E 01 51 02 52 E803 52 E803", "0F00 0000 80 0000 94 01 81 02 82 E803 82 E803", "decimals"),
        ("0C00 0100 51 9E 04 61626300 0100 01", "0C00 0100 81 9E 04 61626300 0100 01", "decimals"),
    ],
)
def test_a_slip_of_another_way_to_write(wrong: str, right: str, kind: str) -> None:
    (one,) = nearest(wrong)
    assert (one.kind, one.frame) == (kind, bytes.fromhex(right))


def test_results_of_loading_a_program_in_another_place() -> None:
    """The proposal is another order, never a made-up address."""
    load = "C008 01 84612E72626600 40 44"
    right = bytes.fromhex(f"1600 0100 80 0020 {load} 03 01 40 44 00")
    address, stored = nearest(f"1600 0100 80 0020 {load} 03 01 44 40 00")
    assert (address.kind, address.frame, stored.kind) == ("order", right, "order")
    (slot,) = nearest(f"1600 0100 80 0020 {load} 03 40 01 44 00")
    assert (slot.kind, slot.frame) == ("order", right)
    assert nearest("0A00 0100 80 0020 03 01 40 44 00") == ()


def test_memory_asked_for_in_vain_is_not_another_order() -> None:
    for frame in ("0600 0000 00 0840 01", "0600 0500 00 0400 01", "0800 0400 00 0840 81 01 60"):
        assert not [one for one in nearest(frame) if one.kind == "header-order"]

"""Faults of programs: every code with its example, and the brick's verdict on whole programs."""

from __future__ import annotations

import pytest
from support.programs import IMAGE, SHORTEST, image_of

from ev3proto import GV, operation
from ev3proto.checking.codes import CODES
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Severity
from ev3proto.program import check_program


@pytest.mark.parametrize("image", [IMAGE, SHORTEST])
def test_the_example_has_no_findings(image: bytes) -> None:
    report = check_program(image)
    assert report.accepted
    assert report.findings == ()


@pytest.mark.parametrize("name", PROGRAM_CODES)
def test_the_example_of_a_code_raises_it(name: str) -> None:
    code = PROGRAM_CODES[name]
    assert name in {finding.code for finding in check_program(code.example).findings}
    assert name not in {finding.code for finding in check_program(code.counterexample).findings}
    assert {finding.severity for finding in check_program(code.example).findings if finding.code == name} == {
        code.severity
    }


def test_codes_of_programs_and_of_frames_do_not_meet() -> None:
    assert not set(PROGRAM_CODES) & set(CODES)
    assert all(code[1] == "0" for code in PROGRAM_CODES)
    assert {code.severity for code in PROGRAM_CODES.values()} == {Severity.ERROR, Severity.WARNING}


def test_a_finding_has_its_offset_in_the_image() -> None:
    image = image_of((0, 0, "30 05 64 0A"), global_size=4)
    (finding,) = check_program(image).findings
    assert (finding.code, finding.offset, finding.length) == ("E007", 30, 1)
    assert (finding.operation, finding.parameter) == ("MOVE8_8", "DESTINATION")


def test_a_block_has_the_locals_of_its_owner() -> None:
    # MOVE8_8(1, LV2) in a block whose owner has four bytes of locals
    image = bytearray(image_of((0, 0, "06 02 0A"), (1, 1, "30 01 42 0A"), local_size=4))
    image[36:40] = bytes(4)
    assert check_program(bytes(image)).findings == ()


def test_bytes_after_the_image_are_reported_once() -> None:
    for image in (IMAGE, SHORTEST):
        (finding,) = check_program(image + bytes((1, 2, 3))).findings
        assert (finding.code, finding.offset, finding.length) == ("W011", len(image), 3)
        assert finding.message == f"the header says that the image has {len(image)} bytes; 3 more follow"


def test_nothing_in_an_image_raises() -> None:
    for size in range(len(IMAGE)):
        assert not check_program(IMAGE[:size]).accepted


def help_of(name: str, image: bytes) -> str | None:
    return next((finding.help for finding in check_program(image).findings if finding.code == name), None)


def test_the_numbers_in_helps_were_tried() -> None:
    image = PROGRAM_CODES["E003"].example
    assert help_of("E003", image) == "give 1 to 2"
    at = image.index(bytes.fromhex("05 03 0A")) + 1
    for number in (1, 2):
        assert help_of("E003", image[:at] + bytes((number,)) + image[at + 1 :]) is None
    image = PROGRAM_CODES["E007"].example
    assert help_of("E007", image) == "ask for 5 bytes of global memory, or use a lower index"
    assert help_of("E007", image[:12] + (5).to_bytes(4, "little") + image[16:]) is None
    assert help_of("E005", PROGRAM_CODES["E005"].example) == "give 1 parameter"
    assert help_of("E005", PROGRAM_CODES["E005"].counterexample) is None


# The firmware's walk


def words_of(image: bytes) -> tuple[bool, int | None, list[str]]:
    report = check_program(image)
    return report.accepted, report.rejected_at, [finding.code for finding in report.findings]


def with_word(image: bytes, at: int, value: int, size: int = 4) -> bytes:
    return image[:at] + value.to_bytes(size, "little") + image[at + size :]


THREAD = image_of((0, 0, "01 0A"))
SUBCALL = image_of((0, 0, "01 0A"), (0, 1, "02 84 08 43 08 0A"))
PAIR = image_of((0, 0, "01 0A"), (0, 0, "01 01 0A"))


@pytest.mark.parametrize(
    ("image", "accepted", "position", "codes"),
    [
        # The size is the end: bytes after it are ignored, missing ones are not.
        (THREAD + b"\xff\xff", True, None, ["W011"]),
        (THREAD[:-1], False, 4, ["E001"]),
        (with_word(THREAD, 4, 27), False, 4, ["E001"]),
        (image_of(), False, 4, ["E001"]),
        # An offset of 0 is the next code, every other one is not followed.
        (with_word(PAIR, 16, 0), True, None, []),
        (with_word(with_word(PAIR, 16, 0), 28, 0), True, None, []),
        (with_word(PAIR, 28, 41), True, None, ["W010", "W011", "W012"]),
        (with_word(PAIR, 28, 40), True, None, ["W011"]),
        (with_word(PAIR, 28, 900), True, None, ["W011", "W012"]),
        # A subcall in front of the index is an alias; at the index, or after it, its table is read there.
        (image_of((0, 0, "01 0A"), (0, 1, "00 08 0A"), (0, 1, None)), True, None, []),
        (SUBCALL, True, None, []),
        (
            with_word(image_of((0, 0, "01 0A"), (0, 1, "02 84 08 43 08 0A")), 28, 45),
            True,
            None,
            ["W010", "W011", "W012"],
        ),
        # Code without its end runs on into what follows; gaps between codes are code.
        (image_of((0, 0, "01"), (0, 0, "01 0A")), True, None, ["W010", "W012"]),
        (image_of((0, 0, "01 30")), False, 29, ["E002"]),
        (image_of((0, 0, "0A 01")), False, 28, ["E002", "W011"]),
        (image_of((0, 0, "0A 01 DF 0A")), False, 28, ["E002", "W011"]),
        (image_of((0, 0, "01 DF 0A"), (0, 0, "DF 0A")), False, 41, ["E002"]),
        # An operation may read on into the next object.
        (image_of((0, 0, "30 01"), (0, 0, "60 0A"), global_size=1), True, None, ["W010", "W012"]),
        # Nothing is read at all.
        (bytes.fromhex("4c45474f1e0000006a0001006a0000001c000000000001006a000000080a"), True, None, ["W013"]),
        (image_of((0, 0, "")), True, None, ["W013"]),
        # Versions before the release of 2013 are objected to, and accepted.
        (with_word(THREAD, 8, 103, 2), True, 8, []),
        (with_word(THREAD, 8, 104, 2), True, None, []),
        (with_word(THREAD, 8, 0, 2), True, None, []),
        (with_word(image_of((0, 0, "DF 0A")), 8, 57, 2), False, 28, ["E002"]),
        # An unknown CMD has no parameters.
        (image_of((0, 0, "8D 1F 0A")), True, None, ["W014"]),
    ],
)
def test_the_verdict_is_that_of_the_firmware(
    image: bytes, accepted: bool, position: int | None, codes: list[str]
) -> None:
    found = words_of(image)
    assert found[:2] == (accepted, position)
    assert sorted(set(found[2])) == codes


def test_newer_commands_are_known_to_the_firmware_that_the_image_is_for() -> None:
    code = operation("UI_READ.GET_POWER", *map(GV, (0, 4, 8, 12))).raw.hex()
    image = image_of((0, 0, f"{code} 0A"), global_size=16)
    assert check_program(with_word(image, 8, 0x6D, 2)).accepted
    assert not check_program(with_word(image, 8, 0x68, 2)).accepted


def test_jumps_of_programs_are_followed() -> None:
    """A jump by a variable is reported; the target of a jump into an operation is read there."""
    (by_variable,) = check_program(PROGRAM_CODES["W015"].example).findings
    assert (by_variable.code, by_variable.operation) == ("W015", "JR")
    assert check_program(PROGRAM_CODES["W015"].counterexample).findings == ()

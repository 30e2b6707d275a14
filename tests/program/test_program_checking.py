"""What is wrong with programs: every code with its example, and the brick's verdict on whole programs."""

from __future__ import annotations

import pytest
from support.programs import IMAGE, SHORTEST, image_of

from ev3proto import GV, operation
from ev3proto.checking.codes import CODES
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Severity
from ev3proto.program import check_program
from ev3proto.tables import operations


@pytest.mark.parametrize("image", [IMAGE, SHORTEST])
def test_there_is_nothing_to_say_about_the_example(image: bytes) -> None:
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


def test_the_brick_refuses_a_program_with_an_operation_that_it_does_not_know() -> None:
    report = check_program(image_of((0, 0, "01 DF 0A")))
    assert not report.accepted
    assert report.rejected_at == 29


def test_a_block_has_the_locals_of_its_owner() -> None:
    # MOVE8_8(1, LV2) in a block whose owner has four bytes of locals
    image = bytearray(image_of((0, 0, "06 02 0A"), (1, 1, "30 01 42 0A"), local_size=4))
    image[36:40] = bytes(4)
    assert check_program(bytes(image)).findings == ()


def test_nothing_in_an_image_raises() -> None:
    for size in range(len(IMAGE)):
        assert not check_program(IMAGE[:size]).accepted


def test_programs_may_have_the_commands_of_the_latest_firmware() -> None:
    # UI_READ(GET_POWER, GV0, GV4, GV8, GV12), which the release of 2013 does not know
    assert operations()["UI_READ.GET_POWER"].is_newer
    image = image_of((0, 0, f"{operation('UI_READ.GET_POWER', *map(GV, (0, 4, 8, 12))).raw.hex()} 0A"), global_size=16)
    assert check_program(image).accepted


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

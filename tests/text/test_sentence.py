"""A message in one sentence: `decode --format sentence`, and the playground's first line."""

from __future__ import annotations

import re

import pytest
from support.cli import run_ev3proto

from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Declaration, declarations

DECLARATIONS = tuple(declarations(OPCODES))


def said(*words: str) -> str:
    """What the command line prints."""
    return run_ev3proto("decode", "--format", "sentence", *words).stdout.decode()


@pytest.mark.parametrize(
    ("frame", "sentence"),
    [
        ("0e002a0080000094010182b80182e803", "Plays 440 Hz for 1 s at volume 1 %."),
        # Without an end, and silent: the words of the tables in place of a number.
        ("0c002a0080000094010082060100", "Plays 262 Hz, until BREAK or the next sound, silent."),
        # A variable has no volume to name.
        ("0e002a0080010094016082b80182e803", "Plays 440 Hz for 1 s."),
        ("08002a00800000821b02", "Sets the light around the buttons to LED_RED."),
        ("08002a00000400810160", "Reads the battery voltage."),
        ("09002a00800000a3000f01", "Stops motors A, B, C and D (brake and hold)."),
        # Three parts of an angle are one angle; a layer is told if it is not the first brick.
        (
            "10002a00800000ae00018132008268011e01",
            "Turns motor A by 390° at speed 50 %, then brake and hold.",
        ),
        ("08002a00800000a60104", "Starts motor C on layer 1."),
        ("0b002a000001009a0000000060", "Reads port 1 in percent."),
        # A number of a motor that no brick has.
        ("0a000100000300a8003f6064", "Reads speed and count of no motor."),
        ("0e000100000300a80083ffffff7f6064", "Reads speed and count of no motor."),
        (
            "0e002a0080000094010182b80182e8",
            "Plays 440 Hz at volume 1 %; but it is wrong at offset 0: the frame is cut off.",
        ),
    ],
)
def test_a_command_is_a_sentence(frame: str, sentence: str) -> None:
    assert said(frame).startswith(sentence)


def test_every_mask_of_motors_has_a_sentence() -> None:
    """OUTPUT_STOP with each number that one byte holds, and the ends of four."""
    masks = [f"81{number:02x}" for number in range(0x100)] + ["83ffffff7f", "8300000080"]
    frames = [f"{8 + len(mask) // 2:02x}002a00800000a300{mask}01" for mask in masks]
    lines = said(*frames).splitlines()
    assert {line.split()[0] for line in lines} == {"Stops"}
    assert len(lines) == len(masks)


def test_an_operation_without_a_sentence_is_described_with_what_it_is_given() -> None:
    frame = run_ev3proto("encode", 'FILE(OPEN_APPEND, "notes.rtf", LV0(0))').stdout.decode().strip()
    assert said(frame) == 'Opens a file for appending (NAME "notes.rtf").\n'


def test_a_log_tells_what_was_answered() -> None:
    log = "Sent 0x|08:00|2A:00|00|04:00|81:01:60|\nRecv 0x|07:00|2A:00|02|66:66:F6:40|\n"
    assert run_ev3proto("decode", "--format", "sentence", "-", stdin=log.encode()).stdout.decode() == (
        "sent Reads the battery voltage.\nreceived Answers command 42: VALUE is 7.7 V.\n"
    )


@pytest.mark.parametrize(
    "declaration", [each for each in DECLARATIONS if each.sentence], ids=lambda declaration: declaration.name
)
def test_the_places_of_a_sentence_are_parameters_of_its_operation(declaration: Declaration) -> None:
    names = {parameter.name for parameter in declaration.parameters}
    assert {name for place in re.findall(r"\{(.*?)\}", declaration.sentence) for name in place.split("+")} <= names
    for clause in re.findall(r"\[(.*?)\]", declaration.sentence):
        assert len(set(re.findall(r"\{(.*?)\}", clause))) == 1
    assert declaration.sentence[0].islower()
    assert not declaration.sentence.endswith(".")

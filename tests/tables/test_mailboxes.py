"""The messages of mailboxes: the possible meanings of their bytes, and the bytes of texts, numbers and logic values."""

import pytest
from support.cases import each

from ev3proto import BuildError, SystemCommand, parse, system, system_command
from ev3proto.tables.mailboxes import readings

READINGS: dict[str, dict[str, str | float | bool]] = {
    "": {},
    "00": {"logic": False, "text": ""},
    "01": {"logic": True},
    "02": {},
    "41": {},
    "6100": {"text": "a"},
    "0001": {},
    "686900": {"text": "hi"},
    "6869": {},
    "610000": {},
    "0000c03f": {"number": 1.5},
    "00000000": {"number": 0.0},
    "00004842": {"number": 50.0},
    "61626300": {"number": 9.12700582146515e-39, "text": "abc"},
    "61e4f600": {"number": 2.2673458969582588e-38, "text": "aäö"},
    "61076300": {"number": 9.09436117244024e-39},
    "61620063": {"number": 2.3682721887232805e21},
    "0761626300": {"text": "\aabc"},
    "68656c6c6f00": {"text": "hello"},
    "68656c006f00": {},
}
"""Payloads, each with all readings that fit."""


@each("payload, expected", READINGS.items())
def test_the_readings_that_fit_a_message(payload: str, expected: dict[str, str | float | bool]) -> None:
    assert readings(bytes.fromhex(payload)) == expected


def test_a_message_knows_its_readings() -> None:
    message = parse(bytes.fromhex("0d00 0000 81 9e 02 6100 0400 0000c03f"), expect=SystemCommand)
    assert message.readings == {"number": 1.5}
    other = parse(bytes.fromhex("0400 0000 01 9d"), expect=SystemCommand)
    assert other.readings == {}


def payload_of(value: str | float | bytes) -> str:
    message = system.writemailbox("a", value)
    assert message.build() == system_command("WRITEMAILBOX", reply=False, name="a", payload=value).build()
    payload = message.fields["payload"]
    assert isinstance(payload, bytes)
    assert message.fields["payload_length"] == len(payload)
    return payload.hex()


def test_messages_are_made_of_values() -> None:
    assert payload_of("hi") == "686900"
    assert payload_of("hi\0") == "686900"
    assert payload_of("") == "00"
    assert payload_of("ä") == "e400"
    assert payload_of(1.5) == "0000c03f"
    assert payload_of(2) == "00000040"
    assert payload_of(True) == "01"
    assert payload_of(False) == "00"
    assert payload_of(b"\x01\x02") == "0102"


def test_what_no_message_is_made_of() -> None:
    with pytest.raises(BuildError, match=r"payload cannot be '€': the brick's strings are ISO-8859-1"):
        system.writemailbox("a", "€")
    with pytest.raises(BuildError, match=r"payload cannot be 1e\+99: a number in a message is a single \(4 bytes\)"):
        system.writemailbox("a", 1e99)
    with pytest.raises(BuildError, match=r"payload takes a text, a number, True, False or bytes, not \[1\]"):
        system.writemailbox("a", [1])  # type: ignore[arg-type]

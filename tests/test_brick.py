"""The virtual brick's machine: frames in, frames out, as they were measured on the firmware."""

import pytest

from ev3proto.brick import Brick


def exchange(brick: Brick, frame: str) -> list[str]:
    """Sends a frame written in hex, with bars between its fields, and returns the replies alike."""
    return [reply.hex(" ") for reply in brick.receive(bytes.fromhex(frame.replace("|", " ")))]


@pytest.fixture
def brick() -> Brick:
    return Brick()


def test_global_memory_survives_from_one_direct_command_to_the_next(brick: Brick) -> None:
    assert exchange(brick, "0C 00|01 00|80|04 00|3A 83 9B 27 17 2A 60") == []
    assert exchange(brick, "06 00|02 00|00|04 00|01") == ["07 00 02 00 02 9b 27 17 2a"]


def test_a_refused_command_is_answered_with_the_old_memory(brick: Brick) -> None:
    exchange(brick, "0C 00|01 00|80|04 00|3A 83 9B 27 17 2A 60")
    assert exchange(brick, "06 00|03 00|00|04 00|00") == ["07 00 03 00 04 9b 27 17 2a"]

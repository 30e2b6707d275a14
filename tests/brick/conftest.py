"""The brick of most tests here."""

from pathlib import Path

import pytest

from ev3proto.brick import Brick


@pytest.fixture
def brick(tmp_path: Path) -> Brick:
    """A brick with nothing plugged in, whose files are in an empty folder."""
    return Brick(tmp_path)

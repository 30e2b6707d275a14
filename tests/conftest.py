"""The fixture `tshark`, and a marker on all tests that use it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from support.wireshark import Tshark


@pytest.fixture(scope="session")
def tshark() -> Iterator[Tshark]:
    """The tshark that EV3PROTO_TSHARK names, with the dissector loaded."""
    with Tshark.from_setting() as tshark:
        yield tshark


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Lets `pytest -m wireshark` select what another tshark can change."""
    for item in items:
        if "tshark" in getattr(item, "fixturenames", ()):
            item.add_marker("wireshark")

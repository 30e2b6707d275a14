"""The public face is that of tests/public_face.txt, so that a change of it shows in a review."""

from __future__ import annotations

import difflib

import pytest
from support.public_face import FILE, RENEW, text


def test_the_public_face_is_as_recorded() -> None:
    recorded, found = FILE.read_text().splitlines(), text().splitlines()
    changes = list(difflib.unified_diff(recorded, found, "recorded", "now", lineterm="", n=0))
    if changes:
        pytest.fail(
            "\n".join(["the public face has changed:", *changes, f"If that is meant: {RENEW}"]),
            pytrace=False,
        )

"""The effort of the tests: small by default, so that they are quick, and large if EV3PROTO_THOROUGH is set."""

from __future__ import annotations

import os

SETTING = "EV3PROTO_THOROUGH"
THOROUGH = bool(os.environ.get(SETTING))


def effort(usual: int, thorough: int) -> int:
    """Returns a number of examples, frames or rounds, for the usual or the thorough tests."""
    return thorough if THOROUGH else usual

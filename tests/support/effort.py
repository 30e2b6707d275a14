"""How much the tests try: little by default, so that they are quick, and a lot where EV3PROTO_THOROUGH is set."""

from __future__ import annotations

import os

SETTING = "EV3PROTO_THOROUGH"
THOROUGH = bool(os.environ.get(SETTING))


def effort(usual: int, thorough: int) -> int:
    """A number of examples, frames or rounds, for the usual tests and for the thorough ones."""
    return thorough if THOROUGH else usual

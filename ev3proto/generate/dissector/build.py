"""Puts the dissector together: a head, the data, the runtime."""

from __future__ import annotations

from importlib import resources

from ev3proto.generate.dissector.tables import data
from ev3proto.tables.carriers import CARRIERS
from ev3proto.version import VERSION

FILE_NAME = "ev3.lua"

RUNTIME = (
    "fields",
    "instructions",
    "memory",
    "reading",
    "phrases",
    "statistics",
    "dialogue",
    "values",
    "operations",
    "message",
    "frames",
    "claims",
    "carriers",
    "streams",
    *CARRIERS,
    "registration",
)
"""The parts written by hand, in the order in which they stand in the file: each uses only what stands before it.

Each carrier has one, with its name.
"""

HEAD = f"""\
-- LEGO MINDSTORMS EV3 dissector for Wireshark 4.0 and later (Lua 5.2 and 5.4). Licence: MIT.
--
-- To install it put this one file into the personal Lua plugins folder, which Wireshark names under Help, About,
-- Folders; or run: ev3proto dissector install
--
-- This file is made by ev3proto {VERSION}, of its tables of the EV3's protocol and its runtime for Wireshark.
-- Change those, not this.

set_plugin_info({{
    version = "{VERSION}",
    description = "LEGO MINDSTORMS EV3: direct and system commands over WiFi, USB and Bluetooth",
    author = "the ev3proto authors",
}})

"""


def build() -> str:
    """The text of ev3.lua."""
    folder = resources.files(__package__) / "runtime"
    parts = [(folder / f"{name}.lua").read_text(encoding="utf-8") for name in RUNTIME]
    return HEAD + "\n".join([data(), *parts])

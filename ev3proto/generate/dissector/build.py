"""Assembles the dissector: head, data, runtime."""

from __future__ import annotations

import hashlib
from importlib import resources

from ev3proto.generate.dissector.tables import data
from ev3proto.tables.carriers import CARRIERS
from ev3proto.version import VERSION

FILE_NAME = "ev3.lua"
STATISTICS_NAME = "ev3_statistics.lua"

RUNTIME = (
    "fields",
    "instructions",
    "memory",
    "reading",
    "phrases",
    "dialogue",
    "values",
    "operations",
    "message",
    "frames",
    "claims",
    "finding",
    "streams",
    *CARRIERS,
    "registration",
)
"""The hand-written parts, in the order of the file: each uses only earlier parts.

Each carrier has one, with its name.
"""

_MADE_BY = f"This file is made by ev3proto {VERSION}"


def _proto(variable: str, name: str, title: str, file: str) -> str:
    """Returns the Lua that makes a protocol. A second copy of a file, as in the global plugins folder, ends there."""
    return f"""\
if package.loaded["{file}"] then
    io.stderr:write("{file} is loaded already; this copy is ignored: ", debug.getinfo(1, "S").short_src, "\\n")
    return
end
package.loaded["{file}"] = true
local {variable} = Proto("{name}", "{title}")

"""


HEAD = f"""\
-- LEGO MINDSTORMS EV3 dissector for Wireshark 4.0 and later (Lua 5.2 and 5.4). Licence: MIT.
--
-- To install it, put this file into the personal Lua plugins folder, which Wireshark names under Help, About,
-- Folders; or run: ev3proto dissector install
--
-- {_MADE_BY}, from its tables of the EV3's protocol and its runtime for Wireshark.
-- Change those, not this file.

set_plugin_info({{
    version = "{VERSION}",
    description = "LEGO MINDSTORMS EV3: direct and system commands over WiFi, USB and Bluetooth",
    author = "the ev3proto authors",
}})

{_proto("ev3", "EV3", "LEGO MINDSTORMS EV3", FILE_NAME)}"""

STATISTICS_HEAD = f"""\
-- Statistics and export of files for the LEGO MINDSTORMS EV3 dissector, ev3.lua. Licence: MIT.
--
-- To install it, put it beside ev3.lua into the personal Lua plugins folder; or run: ev3proto dissector install
--
-- {_MADE_BY}, from its runtime for Wireshark. Change that, not this file.

set_plugin_info({{
    version = "{VERSION}",
    description = "LEGO MINDSTORMS EV3: statistics, and export of transferred files",
    author = "the ev3proto authors",
}})

{_proto("script", "EV3_statistics", "EV3 statistics", STATISTICS_NAME)}"""


def build() -> str:
    """Returns the text of ev3.lua, which dissects."""
    return _signed(HEAD + "\n".join([data(), *map(_part, RUNTIME)]))


def files() -> dict[str, str]:
    """Returns the Lua files by name, in the order in which Wireshark loads them."""
    return {FILE_NAME: build(), STATISTICS_NAME: build_statistics()}


def build_statistics() -> str:
    """Returns the text of ev3_statistics.lua, which adds statistics and the export of files. It is optional."""
    return _signed(STATISTICS_HEAD + _part("statistics"))


_MARK = "-- Checksum of the lines above, by which a changed file is recognised: "


def _signed(text: str) -> str:
    return f"{text}{_MARK}{_checksum(text)}\n"


def _checksum(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def is_unchanged(text: str) -> bool:
    """Returns whether a Lua file is unchanged since some version of ev3proto wrote it."""
    above, _, checksum = text.rpartition(_MARK)
    return checksum == f"{_checksum(above)}\n"


def _part(name: str) -> str:
    return (resources.files(__package__) / "runtime" / f"{name}.lua").read_text(encoding="utf-8")

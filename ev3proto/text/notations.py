"""The notations in which operations can be written as assembly, by the names that people choose them by.

They stand apart from what writes them, which only those who choose one have to load.
"""

from __future__ import annotations

MACROS = "asm"
"""With the macro of every encoding, so that the same bytes can be made of it."""

LEGO = "lego"
"""As LEGO's sources have them."""

NOTATIONS = (MACROS, LEGO)

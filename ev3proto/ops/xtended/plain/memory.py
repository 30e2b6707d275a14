"""Opcodes without a CMD in the firmware's area `memory`; `ops.xtended` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Output, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["file_md5sum"]

_OPERATIONS = drafts("xtended")


def file_md5sum(name: Text, md5sum: Output = None, success: Output = None, *, unchecked: bool = False) -> Draft:
    """Computes the MD5 digest of a file.

    Args:
        name: Path of the file; string.
        md5sum: The digest, as 16 bytes; 16 values; DATA8; an output, in global memory when omitted.
        success: Whether the file could be read; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE_MD5SUM"].draft((name, md5sum, success), unchecked)

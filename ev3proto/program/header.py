"""Constructs of an image's header, of its table of objects, and of the table of parameters that starts a subcall."""

from __future__ import annotations

import struct

from construct import Array, BitsInteger, BitStruct, Bytes, Const, Flag, If, Int8ul, Int16ul, Int32ul, Struct, this

from ev3proto.tables.program import SIGN, STRING_CODE

IMAGE_HEADER = Struct(
    "sign" / Const(SIGN),
    "size" / Int32ul,
    "version" / Int16ul,
    "count" / Int16ul,
    "globals" / Int32ul,
)
"""The start of an image: its size, version, number of objects, bytes of global memory."""

OBJECT_HEADER = Struct(
    "offset" / Int32ul,
    "owner" / Int16ul,
    "triggers" / Int16ul,
    "locals" / Int32ul,
)
"""One object: where its code starts in the image, its owner's number, its triggers, bytes of local memory."""

HEADER = Struct(*IMAGE_HEADER.subcons, "objects" / Array(this.count, OBJECT_HEADER))
"""Everything before the codes."""

IMAGE = Struct(
    *HEADER.subcons,
    "code" / Bytes(this.size - IMAGE_HEADER.sizeof() - this.count * OBJECT_HEADER.sizeof()),
)
"""A whole image: `code` has the codes of all objects. `ev3proto.program.parse` reads the operations in them."""

PARAMETER_CODE = BitStruct("is_in" / Flag, "is_out" / Flag, "reserved" / BitsInteger(3), "type" / BitsInteger(3))
"""The byte that declares a parameter."""

PARAMETER = Struct("code" / PARAMETER_CODE, "size" / If(this.code.type == STRING_CODE, Int8ul))
"""A parameter of a subcall; of a string, its size modulo 256 follows."""

PARAMETERS = Struct("count" / Int8ul, "parameters" / Array(this.count, PARAMETER))
"""The start of the code of a subcall."""

PACKED_HEADER = struct.Struct("<IHHI")
PACKED_OBJECT = struct.Struct("<IHHI")
"""The header after its sign, and an object, for fast reading: an image may have thousands of objects."""

IMAGE_HEADER_SIZE = IMAGE_HEADER.sizeof()
OBJECT_HEADER_SIZE = OBJECT_HEADER.sizeof()

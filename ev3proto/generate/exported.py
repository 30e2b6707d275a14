"""The files that describe the protocol for other tools, by name: what `export all` writes, and `exports/` has."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ev3proto.generate import output_schemas, vectors
from ev3proto.generate.cheader import build as cheader
from ev3proto.generate.javascript import build as javascript
from ev3proto.generate.javascript import decoder
from ev3proto.generate.kaitai import build as kaitai
from ev3proto.generate.tables_json import build as tables_json

EXPORTED: dict[str, Callable[[], str]] = {
    cheader.FILE_NAME: cheader.build,
    kaitai.FILE_NAME: partial(kaitai.build),
    javascript.MODULE_NAME: javascript.build,
    javascript.TYPES_NAME: javascript.build_types,
    javascript.TYPES_OF_MODULE_NAME: javascript.build_types_of_module,
    decoder.DECODER_NAME: decoder.build_decoder,
    decoder.DECODER_TYPES_NAME: decoder.build_decoder_types,
    "ev3-decode.d.mts": partial(javascript.build_types_of_module, decoder.DECODER_NAME),
    decoder.TEXTS_NAME: decoder.build_texts,
    decoder.TEXTS_TYPES_NAME: decoder.build_texts_types,
    "ev3-texts.d.mts": partial(javascript.build_types_of_module, decoder.TEXTS_NAME),
    tables_json.TABLES_NAME: tables_json.build_tables,
    tables_json.SCHEMA_NAME: tables_json.build_schema,
    output_schemas.FILE_NAME: output_schemas.build,
    vectors.FILE_NAME: vectors.build,
}
"""Each file's name and the function that makes its text."""

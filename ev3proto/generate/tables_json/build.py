"""The two files: the tables, and their schema."""

from __future__ import annotations

from ev3proto.generate.tables_json.data import tables
from ev3proto.generate.tables_json.json_text import written
from ev3proto.generate.tables_json.schema import schema

TABLES_NAME = "ev3-tables.json"
SCHEMA_NAME = "ev3-tables.schema.json"


def build_tables() -> str:
    """Returns the text of ev3-tables.json."""
    return written({"$schema": SCHEMA_NAME, **tables()})


def build_schema() -> str:
    """Returns the text of ev3-tables.schema.json."""
    return written(schema())

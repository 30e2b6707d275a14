"""JSON files: the schema of each property and where its value comes from, and writing them as a person would."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Any

JsonSchema = dict[str, Any]
Object = dict[str, Any]
Property = JsonSchema | tuple[JsonSchema, Any]

NAME = "^[A-Za-z][A-Za-z0-9_]*$"


class Shape:
    """The properties of one kind of object."""

    def __init__(self, text: str, properties: Mapping[str, Property], optional: tuple[str, ...] = ()) -> None:
        """Describes an object.

        A property is a schema alone where the value is the attribute of that name, else with a function of the entry
        or the value itself. Optional ones are omitted where they are None, false, or empty texts and objects.
        """
        pairs = {name: it if isinstance(it, tuple) else (it, attrgetter(name)) for name, it in properties.items()}
        self._optional = optional
        self._reads = {name: read for name, (_, read) in pairs.items()}
        # the JSON Schema of such an object; other properties are refused
        self.schema: JsonSchema = {
            "type": "object",
            "description": text,
            "properties": {name: schema for name, (schema, _) in pairs.items()},
            "required": [name for name in pairs if name not in optional],
            "additionalProperties": False,
        }

    def data(self, entry: object = None) -> Object:
        """Returns the object of an entry of the tables."""
        found = {name: read(entry) if callable(read) else read for name, read in self._reads.items()}
        return {name: value for name, value in found.items() if name not in self._optional or _is_there(value)}

    @property
    def nested(self) -> tuple[JsonSchema, Callable[[object], Object]]:
        """The shape as a property of another, of the same entry."""
        return self.schema, self.data


def _is_there(value: object) -> bool:
    return value is not None and value is not False and value != "" and value != {}


def map_of(values: JsonSchema, text: str) -> JsonSchema:
    """Returns the schema of an object whose keys are names."""
    return {"type": "object", "description": text, "propertyNames": {"pattern": NAME}, "additionalProperties": values}


def array(items: JsonSchema, text: str, **more: Any) -> JsonSchema:
    """Returns the schema of a list."""
    return {"type": "array", "description": text, "items": items, **more}


def pair(text: str) -> JsonSchema:
    """Returns the schema of two whole numbers."""
    return array({"type": "integer"}, text, minItems=2, maxItems=2)


def ref(name: str) -> JsonSchema:
    """Returns a reference to a definition."""
    return {"$ref": f"#/$defs/{name}"}


def text(meaning: str, pattern: str | None = None) -> JsonSchema:
    """Returns the schema of a text."""
    return {"type": "string", "description": meaning} | ({"pattern": pattern} if pattern else {})


def name(meaning: str) -> JsonSchema:
    """Returns the schema of a name."""
    return text(meaning, NAME)


def number(meaning: str, low: int | None = None, high: int | None = None) -> JsonSchema:
    """Returns the schema of a whole number, with its limits if it has any."""
    limits = {name: value for name, value in (("minimum", low), ("maximum", high)) if value is not None}
    return {"type": "integer", "description": meaning, **limits}


def byte(meaning: str) -> JsonSchema:
    """Returns the schema of a byte."""
    return number(meaning, 0, 0xFF)


def flag(meaning: str) -> JsonSchema:
    """Returns the schema of a truth value."""
    return {"type": "boolean", "description": meaning}


def one_of(names: list[str], meaning: str) -> JsonSchema:
    """Returns the schema of one of some texts."""
    return {"enum": names, "description": meaning}


WIDTH = 120
INDENT = "  "


def written(value: object) -> str:
    """Returns a value as the text of a file. Raises TypeError for values that JSON lacks."""
    return f"{_literal(value, 0, 0, 0)}\n"


def _literal(value: object, depth: int, used: int, after: int) -> str:
    """Returns a value at an indentation, with columns taken before its first line and after its last."""
    line = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, dict | list) or not value or used + len(line) + after <= WIDTH:
        return line
    margin = INDENT * (depth + 1)
    if isinstance(value, dict):
        heads = [f"{json.dumps(str(key), ensure_ascii=False)}: " for key in value]
        items = list(value.values())
    else:
        heads, items = [""] * len(value), value
    rows = [
        f"{margin}{head}{_literal(item, depth + 1, len(margin) + len(head), 1)}"
        for head, item in zip(heads, items, strict=True)
    ]
    opening, closing = "{}" if isinstance(value, dict) else "[]"
    return f"{opening}\n" + ",\n".join(rows) + f"\n{INDENT * depth}{closing}"

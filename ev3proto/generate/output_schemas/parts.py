"""The building blocks of schemas."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from types import NoneType, UnionType
from typing import Any, get_args, get_origin, get_type_hints

Schema = dict[str, Any]

WHOLE: Schema = {"type": "integer", "minimum": 0}
TEXT: Schema = {"type": "string"}
NUMBER: Schema = {"type": "number"}
FLAG: Schema = {"type": "boolean"}
HEX: Schema = {"type": "string", "pattern": "^([0-9a-f]{2})*$"}
TIME: Schema = {"type": "string", "pattern": "^([0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:.]+Z|-?[0-9]+[.][0-9]{6,9})$"}
NOT_FINITE: Schema = {"enum": ["nan", "inf", "-inf"]}

_PLAIN = {int: {"type": "integer"}, float: NUMBER, str: TEXT, bool: FLAG}


def object_of(properties: Schema, *optional: str) -> Schema:
    """Returns an object with these keys and no others."""
    required = [name for name in properties if name not in optional]
    return {"type": "object", "properties": properties, "required": required, "additionalProperties": False}


def by_name(values: Schema, names: Iterable[str] | None = None) -> Schema:
    """Returns an object whose keys are names: any, or some of these."""
    found: Schema = {"type": "object", "additionalProperties": values}
    return found if names is None else found | {"propertyNames": {"enum": sorted(set(names))}}


def reference(name: str) -> Schema:
    """Returns a reference to a schema under `$defs`."""
    return {"$ref": f"#/$defs/{name}"}


def list_of(items: Schema) -> Schema:
    """Returns a list."""
    return {"type": "array", "items": items}


def maybe(schema: Schema) -> Schema:
    """Returns the same schema, or null."""
    return {"anyOf": [schema, {"type": "null"}]}


def of_dataclass(kind: type) -> Schema:
    """Returns the schema of what `dataclasses.asdict` makes of a class, by its annotations."""
    hints = get_type_hints(kind)
    return object_of({field.name: _of_type(hints[field.name]) for field in fields(kind)})


def _of_type(hint: Any) -> Schema:
    if hint in _PLAIN:
        return _PLAIN[hint]
    if is_dataclass(hint) and isinstance(hint, type):
        return of_dataclass(hint)
    arguments = get_args(hint)
    match get_origin(hint):
        case origin if origin is list:
            return list_of(_of_type(arguments[0]))
        case origin if origin is dict:
            return by_name(_of_type(arguments[1]))
        case origin if origin is UnionType:
            (inner,) = (argument for argument in arguments if argument is not NoneType)
            return maybe(_of_type(inner))
    raise TypeError(f"cannot describe {hint} by a schema")

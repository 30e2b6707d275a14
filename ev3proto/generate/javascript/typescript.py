"""The objects of `decode --json` as types of TypeScript, made from their JSON Schema."""

from __future__ import annotations

import json

from ev3proto.generate.output_schemas.build import Schema, definitions
from ev3proto.messages import Message
from ev3proto.tables.frame import TYPES_BY_KIND

_PLAIN = {"integer": "number", "number": "number", "string": "string", "boolean": "boolean", "null": "null"}


def declarations_of_messages() -> str:
    """Returns the declarations of the types: Message, one for each kind of it, and Operation, Argument, Value."""
    shapes = definitions()
    names = ("message", *TYPES_BY_KIND, Message().kind, "operation", "argument", "value")
    return "\n".join(f"export type {_named(name)} = {_declared(shapes[name])};\n" for name in names)


def _named(name: str) -> str:
    """Returns `DirectCommand` for `direct-command`."""
    return name.title().replace("-", "")


def _declared(schema: Schema) -> str:
    if "properties" in schema:
        return "\n  ".join(["{", *_properties(schema)]) + "\n}"
    return _type(schema)


def _properties(schema: Schema) -> list[str]:
    required = schema["required"]
    return [f"{name}{'' if name in required else '?'}: {_type(each)};" for name, each in schema["properties"].items()]


def _type(schema: Schema) -> str:
    match schema:
        case {"$ref": str(reference)}:
            return _named(reference.rpartition("/")[2])
        case {"anyOf": list(several)}:
            return " | ".join(map(_type, several))
        case {"enum": list(values)}:
            return " | ".join(map(json.dumps, values))
        case {"const": value}:
            return json.dumps(value)
        case {"type": list(kinds)}:
            return " | ".join(_PLAIN[kind] for kind in kinds)
        case {"type": "array", "items": items}:
            return f"Array<{_type(items)}>"
        case {"properties": _}:
            return " ".join(["{", *_properties(schema), "}"])
        case {"additionalProperties": values}:
            names = schema.get("propertyNames", {}).get("enum")
            key = "string" if names is None else " | ".join(map(json.dumps, names))
            return f"Partial<Record<{key}, {_type(values)}>>"
    return _PLAIN[schema["type"]]

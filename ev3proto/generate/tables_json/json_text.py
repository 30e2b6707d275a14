"""JSON as a person would write it: on one line if it fits."""

from __future__ import annotations

import json

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

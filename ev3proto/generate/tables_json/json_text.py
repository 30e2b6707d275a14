"""JSON as a person would write it: what fits one line stands on one."""

from __future__ import annotations

import json

WIDTH = 120
INDENT = "  "


def written(value: object) -> str:
    """A value as the text of a file. TypeError for what JSON has not."""
    return f"{_literal(value, 0, 0, 0)}\n"


def _literal(value: object, depth: int, used: int, after: int) -> str:
    """A value that is indented so deep, with so many columns taken before its first line and after its last."""
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

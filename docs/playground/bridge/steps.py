"""What takes long, and is done in steps."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

OFTEN = 0.05
"""Seconds between two steps."""

Steps = Iterator[dict[str, Any]]
"""The steps: `part` and `count` of what was read so far, or an `answer`; the last one is final."""

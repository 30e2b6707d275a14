"""Regular expressions that are compiled when they are first used.

There are dozens of them for all that people paste, and most inputs need a few. To compile them all takes longer than to
decode a frame.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any


class _LatePattern:
    """Stands for a compiled expression, and has what it has as soon as that is asked for."""

    def __init__(self, pattern: str, flags: int = 0) -> None:
        self.pattern = pattern
        self._flags = flags

    def __getattr__(self, name: str) -> Any:
        # What was asked for once is found without this function from then on.
        found = self.__dict__[name] = getattr(re.compile(self.pattern, self._flags), name)
        return found


if TYPE_CHECKING:

    def late_pattern(pattern: str, flags: int = 0) -> re.Pattern[str]:
        """An expression that is compiled when it is first used.

        Args:
            pattern: The expression.
            flags: Those of `re.compile`.

        """
else:
    late_pattern = _LatePattern

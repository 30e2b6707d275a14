"""What is wrong with a filter, and in which column."""

from __future__ import annotations


class FilterError(ValueError):
    """A text that is no filter.

    column  of the character where the trouble starts; the first one is 1
    reason  one sentence: what stands there, what was expected
    """

    def __init__(self, column: int, reason: str) -> None:
        self.column = column
        self.reason = reason
        super().__init__(f"column {column}: {reason}")

    def __reduce__(self) -> tuple[type[FilterError], tuple[int, str]]:
        return (type(self), (self.column, self.reason))

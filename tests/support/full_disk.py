"""A full disk: in this block, no file of this process can grow beyond a number of bytes."""

from __future__ import annotations

import resource
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from unittest import mock


@contextmanager
def full_disk(most: int) -> Iterator[None]:
    """Writing more raises OSError, because Python ignores the signal that comes with the limit.

    Args:
        most: The maximum bytes of a file.
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, hard))
    try:
        # Some Pythons leave half of a compiled module, and then cannot load it.
        with mock.patch.object(sys, "dont_write_bytecode", True):
            yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))

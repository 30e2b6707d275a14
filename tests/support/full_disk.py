"""A disk that is full: while it lasts, no file of this process can grow beyond so many bytes."""

from __future__ import annotations

import resource
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from unittest import mock


@contextmanager
def full_disk(most: int) -> Iterator[None]:
    """Python ignores the signal that goes with the limit, so that writing more is an OSError.

    Args:
        most: Bytes of a file for which there is room.
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, hard))
    try:
        # Some Pythons leave half of a compiled module behind, and cannot load it any more.
        with mock.patch.object(sys, "dont_write_bytecode", True):
            yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))

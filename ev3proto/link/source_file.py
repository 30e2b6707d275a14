"""The file of this computer that goes to a brick, read into memory as far as a brick could have room for it."""

from __future__ import annotations

import errno
from pathlib import Path

from ev3proto.link.file_moves import MOST_FILE


def read_source(path: str | Path) -> bytes:
    """The contents of a file that goes to a brick.

    Args:
        path: Any file of this computer, a device as well, which may never end.

    Returns:
        Its bytes, `MOST_FILE` at most.

    Raises:
        OSError: It cannot be read, or has more bytes than that.

    """
    with Path(path).open("rb") as stream:
        data = stream.read(MOST_FILE + 1)
    if len(data) > MOST_FILE:
        raise OSError(errno.EFBIG, f"more than {MOST_FILE >> 20} MiB, for which no brick has room", str(path))
    return data

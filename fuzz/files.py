"""Files of the virtual brick, opened, written, deleted and moved in any order: the quota equals the use of the disk."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

from ev3proto import GV, LV, direct_command, operation, system_command
from ev3proto.brick import Brick
from ev3proto.messages import Operation

_QUOTA = 1000
_FILES = ("../prjs/a", "../prjs/b")
_MOST_ACTIONS = 200
_MOST_OPERATIONS = 30


def one_input(data: bytes) -> None:
    """Takes actions, one per byte: the low half selects the action, the high half the file or handle."""
    # Downloads must leave more space free than there is here.
    with TemporaryDirectory() as folder, patch("ev3proto.brick.system_commands.RESERVE", 0):
        root = Path(folder)
        brick = Brick(root)
        brick.equipment.files.quota = _QUOTA
        batch: list[Operation] = []
        for byte in data[:_MOST_ACTIONS]:
            kind, number = byte & 0x0F, byte >> 4
            path, handle = _FILES[number % len(_FILES)], LV(2 * (number % 4))
            found = _operation(kind, path, handle)
            if found is not None:
                batch.append(found)
            if found is None or len(batch) == _MOST_OPERATIONS:
                _send(brick, batch)
                batch = []
                if found is None:
                    brick.receive(_system(kind, path, number))
                assert _on_disk(root) <= _QUOTA
        _send(brick, batch)
        brick.disconnect(None)
        assert brick.equipment.files.used == _on_disk(root) <= _QUOTA


def _operation(kind: int, path: str, handle: object) -> Operation | None:
    if kind == 0:
        return operation("FILE.OPEN_WRITE", path, handle)
    if kind == 1:
        return operation("FILE.OPEN_APPEND", path, handle)
    if kind == 2:
        return operation("FILE.OPEN_READ", path, handle, LV(8))
    if kind in (3, 4, 5):
        return operation("FILE.WRITE_BYTES", handle, 100, GV(0))
    if kind == 6:
        return operation("FILE.CLOSE", handle)
    if kind == 7:
        return operation("FILE.REMOVE", path)
    if kind == 8:
        return operation("FILE.MOVE", *_FILES)
    return operation("FILENAME.PACK", path) if kind == 9 else None


def _system(kind: int, path: str, number: int) -> bytes:
    if kind in (10, 11):
        return system_command("BEGIN_DOWNLOAD", size=300, path=path).build()
    if kind in (12, 13):
        return system_command("CONTINUE_DOWNLOAD", handle=number % 4, data=bytes(150)).build()
    if kind == 14:
        return system_command("CLOSE_FILEHANDLE", handle=number % 4).build()
    return system_command("DELETE_FILE", path=path).build()


def _send(brick: Brick, batch: list[Operation]) -> None:
    if batch:
        brick.receive(direct_command(*batch, local_size=16, global_size=100).build())
        brick.advance(0.01)


def _on_disk(root: Path) -> int:
    return sum(path.stat().st_size for path in root.rglob("*") if path.is_file())

"""The files of a real brick: listed, fetched, put, deleted."""

from __future__ import annotations

import base64
from collections.abc import Callable
from typing import Any

from ev3proto.link import file_moves
from ev3proto.link.errors import LinkError
from ev3proto.link.file_moves import Task
from ev3proto.link.policy import Outcome, Talk
from ev3proto.schema.frame import parse
from ev3proto.semantics.transfers import Listing

from .connection import Connection

TASKS: dict[str, Callable[[str, bytes], Task[Any]]] = {
    "list": lambda path, _: file_moves.list_dir(path),
    "fetch": lambda path, _: file_moves.upload(path),
    "put": lambda path, data: file_moves.download(data, path),
    "delete": lambda path, _: file_moves.delete(path),
}
"""What can be done with files."""


def move(connection: Connection, action: str, path: str, data: bytes, done: Callable[[dict[str, Any]], object]) -> None:
    """Does something with a file.

    Args:
        connection: The connection to the brick.
        action: One of TASKS.
        path: The folder or file.
        data: What is written.
        done: Takes what came of it, for JSON: `action`, `path`, `error`, `result`.
    """
    task = TASKS[action](path, data)
    said: dict[str, Any] = {"action": action, "path": path, "error": ""}

    def talk() -> Talk:
        try:
            command = next(task)
            while (reply := (yield command.build())) is not None:
                command = task.send(parse(reply, strict=False))
            said["error"] = "the brick does not answer"
        except StopIteration as end:
            said["result"] = _as_json(end.value)
        except LinkError as error:
            said["error"] = str(error)
        return Outcome()

    connection.converse(talk(), lambda *_: done(said))
    connection.advance()


def _as_json(value: Any) -> Any:
    """Returns what a task found: a folder's names, with sizes of files, or the bytes of a file in base64."""
    if isinstance(value, Listing):
        return {"folders": value.folders, "files": [[each.name, each.size] for each in value.files]}
    return base64.b64encode(value).decode() if isinstance(value, bytes) else None

"""The files and listings that one client has open on a brick, according to the replies to its own commands."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from typing import TypeAlias

from ev3proto.messages import Message, SystemCommand, SystemReply
from ev3proto.semantics.transfers import LISTINGS, ends, handle_of, step_of
from ev3proto.system import close_filehandle, continue_list_files

Ending: TypeAlias = Generator[SystemCommand, Message | None, None]
"""What ends the transfers that are open, and is sent the replies."""

_MOST_PIECES = 10_000
"""Pieces of a listing that is read to its end; the largest folder has fewer."""


def is_of(command: SystemCommand, transfers: Mapping[int, str]) -> bool:
    """Returns whether a command continues a transfer of its own kind, or closes one that is not a listing."""
    handle, name = handle_of(command), str(command.command)
    begun = None if handle is None else transfers.get(handle)
    if begun is None:
        return False
    if name.startswith("CONTINUE_"):
        return name.removeprefix("CONTINUE_") == begun.removeprefix("BEGIN_")
    return begun not in LISTINGS


class OpenTransfers(dict[int, str]):
    """The open transfers: for each handle the name of the command that began it."""

    def ending(self) -> Ending:
        """Yields what ends each transfer, and is sent the replies.

        A listing is read to its end, as the firmware would close another descriptor.
        """
        for handle, name in list(self.items()):
            pieces = _MOST_PIECES if name in LISTINGS else 1
            while handle in self and pieces:
                command = (continue_list_files if name in LISTINGS else close_filehandle)(handle)
                self.learn(command, (yield command))
                pieces -= 1
            self.pop(handle, None)

    def learn(self, command: Message, reply: Message | None) -> None:
        """Takes a command and its reply: the brick ends a transfer with its last piece, and after an error.

        Without a reply it may have been the last piece, after which the handle is another client's.
        """
        if not isinstance(command, SystemCommand):
            return
        answer = reply if isinstance(reply, SystemReply) and reply.number == command.number else None
        begun = answer if step_of(command) == "begin" else None
        handle = handle_of(begun or command)
        if handle is None:
            return
        if answer is None or ends(answer):
            self.pop(handle, None)
        elif begun is not None:
            self[handle] = str(command.command)


def next_of(ending: Ending, reply: Message | None) -> SystemCommand | None:
    """Returns the next command that ends a transfer; None after the last."""
    try:
        return ending.send(reply)
    except StopIteration:
        return None

"""The commands of `EV3` and `AsyncEV3`: their types and texts, which differ only in the type of the result."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from typing import Any, Generic, TypeVar, overload

from ev3proto.compose import Draft, Label
from ev3proto.link.commands import Operations, Prepared, SyncMode, direct, system
from ev3proto.messages import DirectCommand, Operation, SystemCommand

Bytes = TypeVar("Bytes")
Values = TypeVar("Values")


class Verbs(ABC, Generic[Bytes, Values]):
    """The commands. The type parameters are the results for joined bytes, and for operations and messages."""

    @overload
    def send_direct_cmd(
        self,
        ops: bytes | bytearray,
        *,
        local_mem: int = 0,
        global_mem: int = 0,
        sync_mode: str | None = None,
        verbosity: int | None = None,
        timeout: float | None = None,
    ) -> Bytes: ...

    @overload
    def send_direct_cmd(
        self,
        ops: Draft | Operation | DirectCommand | Iterable[Draft | Operation | Label],
        *,
        local_mem: int = 0,
        global_mem: int = 0,
        sync_mode: str | None = None,
        verbosity: int | None = None,
        timeout: float | None = None,
    ) -> Values: ...

    def send_direct_cmd(
        self,
        ops: Operations,
        *,
        local_mem: int = 0,
        global_mem: int = 0,
        sync_mode: str | None = None,
        verbosity: int | None = None,
        timeout: float | None = None,
    ) -> Bytes | Values:
        """Sends a direct command.

        Args:
            ops: Joined byte code; or operations of `ev3proto.ops`, for which memory and reply type are computed.
            local_mem: Bytes of local memory, 0 to 63.
            global_mem: Bytes of global memory, which the reply carries, 0 to 1019.
            sync_mode: STD, ASYNC or SYNC for this command.
            verbosity: 0, 1 or 2 for this command.
            timeout: Seconds to wait for the reply to this command; by default those of this object.

        Returns:
            After waiting for a reply: its memory for joined bytes, its named values for operations. Otherwise the
            message counter, as two bytes.

        Raises:
            BuildError: No frame can carry the command, or the bytes are a whole frame.
            DirectCommandError: The brick refused the command, or it failed; the message has the report of `check`.
            NoAnswerError: The reply did not come in time.
            ConnectionLostError: The connection is lost.
        """
        given: Bytes | Values = self._send(
            lambda: direct(ops, local_mem, global_mem, *self._settings(sync_mode)), verbosity, timeout
        )
        return given

    @overload
    def send_system_cmd(
        self,
        cmd: bytes | bytearray,
        *,
        reply: bool = True,
        verbosity: int | None = None,
        timeout: float | None = None,
    ) -> Bytes: ...

    @overload
    def send_system_cmd(
        self,
        cmd: SystemCommand,
        *,
        reply: bool = True,
        verbosity: int | None = None,
        timeout: float | None = None,
    ) -> Values: ...

    def send_system_cmd(
        self,
        cmd: bytes | bytearray | SystemCommand,
        *,
        reply: bool = True,
        verbosity: int | None = None,
        timeout: float | None = None,
    ) -> Bytes | Values:
        """Sends a system command.

        Args:
            cmd: Its number and its fields as joined bytes; or a message of `ev3proto.system`.
            reply: Whether the brick should answer.
            verbosity: 0, 1 or 2 for this command.
            timeout: Seconds to wait for the reply to this command; by default those of this object.

        Returns:
            The reply: status and fields for joined bytes, named values for a message. Without a reply, the message
            counter, as two bytes.

        Raises:
            BuildError: No frame can carry the command.
            SystemCommandError: The command failed according to the brick.
            NoAnswerError: The reply did not come in time.
            ConnectionLostError: The connection is lost.
        """
        given: Bytes | Values = self._send(lambda: system(cmd, reply), verbosity, timeout)
        return given

    def wait_for_reply(
        self, msg_cnt: bytes | int, *, verbosity: int | None = None, timeout: float | None = None
    ) -> Values:
        """Waits for the reply to a command that was sent with ASYNC. After a timeout, it can be waited for again.

        Args:
            msg_cnt: The counter that sending it returned.
            verbosity: 0, 1 or 2 for this reply.
            timeout: Seconds to wait; by default those of this object.

        Returns:
            The result that sending it with STD would have returned.

        Raises:
            LinkError: As for `send_direct_cmd`; also if no such command waits for its reply.
        """
        given: Values = self._fetch(msg_cnt, verbosity, timeout)
        return given

    @abstractmethod
    def _settings(self, sync_mode: str | None) -> tuple[SyncMode, str]:
        """Returns the mode of one command, and the dialect."""

    @abstractmethod
    def _send(self, prepare: Callable[[], Prepared], verbosity: int | None, timeout: float | None) -> Any:
        """Sends a command, and waits for its reply if its mode says so."""

    @abstractmethod
    def _fetch(self, msg_cnt: bytes | int, verbosity: int | None, timeout: float | None) -> Any:
        """Waits for a reply."""

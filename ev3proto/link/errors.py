"""Errors of the connection to a brick. Each says what to do about it."""

from __future__ import annotations

from ev3proto.checking.report import Report
from ev3proto.errors import Error, counted
from ev3proto.messages import SystemReply
from ev3proto.tables.system import status_meaning


class LinkError(Error):
    """The base of the errors of a connection to a brick."""


class NoBrickError(LinkError):
    """No brick can be reached: none is there, or the program lacks permission."""


class PortInUseError(LinkError):
    """Another program uses the UDP port of the beacon, or the serial port."""


class NoAnswerError(LinkError, TimeoutError):
    """The brick did not answer in time."""


class ConnectionLostError(LinkError, ConnectionError):
    """The connection to the brick is gone."""


class DirectCommandError(LinkError):
    """The brick answered a direct command with DIRECT_REPLY_ERROR.

    Attributes:
        frame: The command.
        memory: The global memory in the reply.
        report: What `check` says about the command.
    """

    def __init__(self, frame: bytes, memory: bytes, report: Report) -> None:
        self.frame = frame
        self.memory = memory
        self.report = report
        super().__init__(_refusal(report))


class SystemCommandError(LinkError):
    """The brick answered that a system command failed.

    Attributes:
        reply: The answer, with its status.
    """

    def __init__(self, reply: SystemReply, about: str = "") -> None:
        self.reply = reply
        super().__init__(_failure(reply, about))


class TransferError(LinkError):
    """A file did not arrive as it was sent."""


NoEV3, PortInUse = NoBrickError, PortInUseError
DirCmdError, SysCmdError = DirectCommandError, SystemCommandError
"""The same by the names under which programs for ev3_dc catch them."""

_MOST_FINDINGS = 3


def _refusal(report: Report) -> str:
    sentence = "the brick answered DIRECT_REPLY_ERROR"
    errors = report.errors
    if report.accepted and not errors:
        return f"{sentence}: an operation failed while it was executed; `ev3proto check` accepts the command"
    found = [f"at offset {finding.offset}: {finding.message} ({finding.code})" for finding in errors]
    if len(found) > _MOST_FINDINGS:
        found[_MOST_FINDINGS:] = [f"and {counted(len(found) - _MOST_FINDINGS, 'error')} more"]
    if not found:
        found = [f"the brick refuses the command at offset {report.rejected_at}"]
    return f"{sentence}: {'; '.join(found)}. For more, run `ev3proto check {report.frame.hex()}`"


def _failure(reply: SystemReply, about: str) -> str:
    name = f"status {reply.status_code}" if reply.status is None else reply.status.name
    what = reply.command or f"system command 0x{reply.number:02X}"
    meaning = status_meaning(reply.number, reply.status_code)
    return f"{about}{': ' if about else ''}the brick answered {what} with {name}{f': {meaning}' if meaning else ''}"

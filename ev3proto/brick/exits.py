"""The exits of an operation that do not continue with the next one."""

from __future__ import annotations


class OperationExit(Exception):  # noqa: N818 - not errors of this package
    """The base of the exits of operations."""


class Failure(OperationExit):
    """The operation failed: its program stops, a direct command is answered with DIRECT_REPLY_ERROR."""


class WildAccess(Failure):
    """An access outside a program's memory. The firmware reads or writes other memory; here the operation fails."""


class NoOperation(Failure):
    """Unknown opcode."""


class Busy(OperationExit):
    """The operation has to wait: it is executed again, with its parameters, at the program's next turn.

    An argument says in words what it waits for in vain.
    """


class Pause(OperationExit):
    """The time of the turn is over: the program continues with its next turn."""


class Leave(OperationExit):
    """The running object is left: it has ended, called another one, or its program was stopped."""


class Sleep(OperationExit):
    """The rest of the turn is given up; the program continues with its next turn."""

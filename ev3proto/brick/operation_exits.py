"""How an operation can end other than by reaching the next one. Handlers raise these; the machine catches them."""


class OperationExit(Exception):  # noqa: N818 - not errors of this package
    """The reason why an operation ends before the next one follows."""


class Failure(OperationExit):
    """The operation failed: its program stops, a direct command is answered with DIRECT_REPLY_ERROR."""


class WildAccess(Failure):
    """Memory that no program owns. The firmware would read or write something else; here the operation fails."""


class NoOperation(Failure):
    """Unknown opcode."""


class Busy(OperationExit):
    """The operation has to wait: it is executed again, parameters and all, when the program has its next turn."""


class Leave(OperationExit):
    """The running object is left: it has ended, called another one, or its program was stopped."""


class Sleep(OperationExit):
    """The rest of the turn is given away; the next operation follows at the next one."""

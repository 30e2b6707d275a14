"""The question to a brick that comes before a command: what is plugged in at its ports, and which of its files exist.

It is a direct command that only reads. Its answers are at the end of global memory, because commands may read what
earlier ones left there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ev3proto.compose import command
from ev3proto.errors import BuildError
from ev3proto.link.arguments import References, Use, path_of, port_of, type_value
from ev3proto.link.known import NOTHING, Known
from ev3proto.messages import GV, DirectCommand, DirectReply, Message, Operation
from ev3proto.schema.frame import parse
from ev3proto.schema.header import MOST_IN_REPLY
from ev3proto.schema.instructions import operation
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import TYPE


@dataclass(frozen=True)
class Inquiry:
    """The ports and files that a command depends on."""

    ports: tuple[tuple[int, int], ...]  # each as layer and number
    paths: tuple[bytes, ...]

    def build(self) -> bytes | None:
        """Returns the frame that asks; None if one frame is too short."""
        at = MOST_IN_REPLY - 2 * len(self.ports) - len(self.paths)
        ask = []
        for layer, port in self.ports:
            ask.append(operation("INPUT_DEVICE.GET_TYPEMODE", layer, port, GV(at), GV(at + 1)))
            at += 2
        for path in self.paths:
            ask.append(operation("FILENAME.EXIST", path.decode(STRING_CODING), GV(at)))
            at += 1
        try:
            return command(*ask, reply=True).build()
        except BuildError:
            return None

    def read(self, reply: bytes | None) -> Known:
        """Returns the answers in a reply."""
        message = None if reply is None else parse(reply, strict=False)
        if not isinstance(message, DirectReply) or message.is_error or len(message.memory) != MOST_IN_REPLY:
            return NOTHING
        at = MOST_IN_REPLY - 2 * len(self.ports) - len(self.paths)
        answers = message.memory[at:]
        exist = answers[2 * len(self.ports) :]
        return Known(
            dict(zip(self.ports, answers[: 2 * len(self.ports) : 2], strict=True)),
            {path for path, is_there in zip(self.paths, exist, strict=True) if is_there},
            message.memory[:at],
        )


def question_about(message: Message) -> Inquiry | None:
    """Returns what has to be asked before a command is sent; None if nothing has to."""
    if not isinstance(message, DirectCommand) or message.fault is not None:
        return None
    code = References(message)
    ports = (port_of(one) for one in message.operations if _sets_type(one, code))
    opening = message.operations if _uses_files(message) else ()
    paths = (path_of(one) for one in opening if one.full_name == "FILE.OPEN_READ")
    question = Inquiry(
        tuple(dict.fromkeys(port for port in ports if port is not None)),
        tuple(dict.fromkeys(path for path in paths if path is not None)),
    )
    return question if question.ports or question.paths else None


def _uses_files(command: DirectCommand) -> bool:
    parameters = (argument.parameter for operation in command.operations for argument in operation.arguments)
    return any(parameter.type is Type.HANDLE and not parameter.is_output for parameter in parameters)


def _sets_type(operation: Operation, code: References) -> bool:
    """Returns whether an operation gives the type of a device, and not 0, which keeps it."""
    return any(
        type_value(Use(argument, operation, code, NOTHING)) != 0
        for argument in operation.arguments
        if argument.parameter.enum is TYPE and not argument.parameter.is_output
    )

"""Random frames of an untrusted client, most of them nearly right, and a proxy without sockets that they go through."""

from __future__ import annotations

import struct
from collections import deque
from collections.abc import Callable, Sequence
from random import Random

from ev3proto.brick import Brick
from ev3proto.link.records import Records
from ev3proto.link.relays import Client, Guard, Sent
from ev3proto.messages import DirectCommand, Message
from ev3proto.stream import Decoder, StreamError
from ev3proto.tables import OPCODES
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.declaration import Declaration, Effect, Parameter, Type, declarations

OPERATIONS = [one for one in declarations(OPCODES) if "official" in one.dialects]
READING = [one for one in OPERATIONS if Effect.READS in one.effects]

PATHS = (
    "../prjs/",
    "../prjs/p",
    "../prjs/p/a.rtf",
    "/home/root/lms2012/prjs/p/a.rtf",
    "../prjs/none.rtf",
    "/dev/x",
    "../../..",
    "../prjs/../../x",
    "/home/root/lms2012",
    "../prjs/p/..",
    "a" * 130,
    "../prjs/a*b",
    "../prjs/p/long_name_that_is_more_than_thirty_two.rtf",
    "",
    "/",
    "lib",
    "../prjs/p/./a.rtf",
)
_NUMBERS = (0, 0, 1, 2, 3, 4, 8, 16, 16, 16, 17, 29, 33, 60, 126, 127, -1, -128, 255, 1000)
_FLOATS = (0.0, 1.0, -2.5, 0.5, 3e38, float("inf"), float("nan"))
_SIZES = (0, 1, 3, 10, 100, 1012, 1016, 4096, 65535)
_SYSTEM = (0x94, 0x94, 0x95, 0x95, 0x96, 0x97, 0x98, 0x99, 0x99, 0x9A, 0x9A, 0x9D, 0x92, 0x93, 0x9B, 0x9C, 0x9E)


class Attacker:
    """Draws frames: most have operations that read, with plausible arguments."""

    def __init__(self, seed: int, operations: Sequence[Declaration] = OPERATIONS, changed: float = 0.05) -> None:
        """`operations`: those that are drawn, mostly the ones that read; `changed`: the share with a changed byte."""
        self._changed = changed
        self._reading = [one for one in operations if one in READING]
        self._operations = operations
        self.handle = 0  # the newest handle of a client
        self._random = Random(seed)

    def frame(self) -> bytes:
        """Returns a frame whose length field is right."""
        draw = self._random
        body = self._system() if draw.random() < 0.25 else self._direct()
        body = struct.pack("<H", draw.randrange(9)) + body
        return struct.pack("<H", len(body)) + body

    def chunks(self, frames: int) -> list[bytes]:
        """Returns frames in segments of any size; the length of a few is wrong."""
        data = b"".join(self.frame()[: None if self._random.random() < 0.99 else -1] for _ in range(frames))
        cuts = sorted(self._random.randrange(len(data) + 1) for _ in range(self._random.randrange(9)))
        return [data[start:end] for start, end in zip([0, *cuts], [*cuts, len(data)], strict=True)]

    def _direct(self) -> bytes:
        draw = self._random
        count = draw.choice((1, 1, 2, 6))
        chosen = [draw.choice(self._reading if draw.random() < 0.85 else self._operations) for _ in range(count)]
        code = bytearray(b"".join(map(self._operation, chosen)))
        if draw.random() < self._changed:
            code[draw.randrange(len(code))] = draw.randrange(256)
        memory = draw.choice((16, 64, 64, 200, 1019)) | draw.choice((16, 16, 40, 63)) << 10
        return struct.pack("<BH", draw.choice((0,) * 19 + (0x80,)), memory) + bytes(code)

    def _system(self) -> bytes:
        draw = self._random
        number, path = draw.choice((*_SYSTEM, draw.randrange(256))), draw.choice(PATHS).encode() + b"\0"
        size = struct.pack("<H", draw.choice(_SIZES))
        begins = {0x94: size, 0x96: size, 0x99: size, 0x92: struct.pack("<I", 10), 0x9B: b"", 0x9C: b""}
        handle = bytes((draw.choice((0, 1, 63, 64, 255, *[self.handle] * 5)),))
        rest = begins[number] + path if number in begins else handle + size
        return bytes((draw.choice((1,) * 9 + (0x81,)), number)) + rest

    def _operation(self, declaration: Declaration) -> bytes:
        code = bytes((declaration.opcode.number,))
        if declaration.command is not None:
            code += self._constant(declaration.command.number)[:3]
        tail = declaration.tail
        code += b"".join(map(self._argument, declaration.fixed[: -1 if tail else None]))
        if tail is not None:
            count = self._random.choice((0, 1, 1, 2, 3))
            code += self._constant(count) + b"".join(self._argument(tail.element) for _ in range(count))
        return code

    def _argument(self, parameter: Parameter) -> bytes:
        draw, is_odd = self._random, self._random.random() < 0.06
        if parameter.is_output or parameter.stores:
            return self._constant(3) if is_odd else self._variable()
        if is_odd:
            return self._variable()
        if parameter.type is Type.STRING:
            return b"\x84" + draw.choice(PATHS).encode() + b"\0"
        if parameter.type is Type.DATAF:
            return b"\x83" + struct.pack("<f", draw.choice(_FLOATS))
        if parameter.enum is not None and draw.random() < 0.7:
            return self._constant(draw.choice(list(parameter.enum.members.values())))
        if parameter.range is not None and draw.random() < 0.9:
            return self._constant(draw.randint(*map(int, parameter.range)))
        return self._constant(draw.choice(_NUMBERS))

    def _constant(self, value: int) -> bytes:
        kind = self._random.random()
        if -32 <= value <= 31 and kind < 0.6:
            return bytes((value & 0x3F,))
        if -128 <= value <= 127 and kind < 0.8:
            return bytes((0x81, value & 0xFF))
        if kind < 0.9:
            return b"\x82" + struct.pack("<h", max(-32768, min(32767, value)))
        return b"\x83" + struct.pack("<i", value)

    def _variable(self) -> bytes:
        draw = self._random
        base, kind = draw.choice((0x40, 0x60)), draw.random()
        if kind < 0.9:
            return bytes((base | draw.choice((0, 0, 1, 2, 4, 8, 12, 16, 20, 31)),))
        if kind < 0.95:
            return bytes((0x81 | base, draw.randrange(256)))
        return bytes((0x91 | base, draw.choice((0, 4, 8))))  # a handle


class _Line:
    """The connection of a client that takes whatever comes."""

    def send(self, data: bytes) -> None: ...

    def pause(self) -> None: ...

    def resume(self) -> None: ...

    def drop(self) -> None: ...


class Guarded:
    """A brick behind `proxy --read-only` with several clients, without sockets and with a virtual clock."""

    carrier = Carrier.WIFI

    def __init__(self, brick: Brick, passed: Callable[[float], object], clients: int) -> None:
        """`passed` is called with the seconds that have passed for the brick."""
        self.records = Records(Carrier.WIFI, "brick")
        self.clients = [self._client() for _ in range(clients)]
        self.answered: list[Message] = []  # the commands that the brick, or a reader, has answered without an error
        self.handle = 0  # the newest handle that one of them was given
        self._brick, self._passed = brick, passed
        self._replies: deque[bytes] = deque()
        self._guard = Guard(self)

    def feed(self, number: int, data: bytes) -> None:
        """Takes bytes from a client. One that gets out of step connects again."""
        client = self.clients[number]
        try:
            for message in client.decoder.feed(data):
                frame = message.build()
                self._guard.forward(Sent(client, message, self.records.sent(frame), frame))
                self._run()
        except StreamError:
            self.leave(number)

    def leave(self, number: int) -> None:
        """Disconnects a client, and connects another one."""
        client = self.clients[number]
        self.clients[number] = self._client()
        self._guard.gone(client)
        self._run()
        assert self._guard.is_idle

    def _client(self) -> Client:
        return Client(_Line(), "a client", Decoder(strict=False), 0.0)

    def _run(self) -> None:
        """Lets time pass until all replies have come."""
        for _ in range(400):
            while self._replies:
                self._guard.heard(self._replies.popleft())
            if self._guard._talk is None:
                return
            self._replies += self._brick.advance(0.05)
            self._passed(0.05)
        raise AssertionError("a command that passed does not end")

    # For the guard

    def send(self, frame: bytes) -> None:
        self._replies += self._brick.receive(frame)

    def answer(self, sent: Sent | None, _client: Client, frame: bytes, _note: str | None = None) -> None:
        if sent is not None and frame[4] in (2, 3):
            self.answered.append(sent.message)
            self.handle = frame[11] if frame[5:6] in (b"\x94", b"\x96", b"\x99") else self.handle

    def unanswered(self, _sent: Sent) -> None: ...

    def say_once(self, _sentence: str) -> None: ...

    def renew(self) -> None: ...

    def later(self, _seconds: float, _call: Callable[[], None]) -> Callable[[], None]:
        return lambda: None

    def now(self) -> float:
        return 0.0


def names_of(message: Message) -> set[str]:
    """Returns the operations of a command, or the name of a system command."""
    if isinstance(message, DirectCommand):
        return {operation.full_name for operation in message.operations}
    return {str(getattr(message, "command", None))}

"""The messages of host and brick: frames, built by ev3proto, without a carrier around them."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Mapping
from typing import NamedTuple

from ev3proto import (
    GV,
    Operation,
    SystemStatus,
    direct_command,
    direct_reply,
    operation,
    system_command,
    system_reply,
)
from ev3proto.messages import FieldValue
from ev3proto.tables.enumerations import LEDPATTERN, TYPE

HANDLE = 0
"""The handle that the brick gives for the only open file."""

NO_HANDLE = 0xFF
"""The handle in a reply if the brick opens nothing."""

CONTENTS = "".join(f"{number};{number * number / 7:.3f}\r\n" for number in range(210)).encode()
"""A file: lines of numbers, as a data log has them."""

IMAGE = b"LEGO" + bytes(number * 7 % 251 for number in range(2496))
"""A file of 2500 bytes: the start of a program, then bytes by a rule."""


class Exchange(NamedTuple):
    """A command and its reply, each a frame."""

    command: bytes
    reply: bytes


class Host:
    """Makes commands, each with the next counter, and the replies of the brick."""

    def __init__(self, counter: int = 1) -> None:
        self.counter = counter

    def _count(self) -> int:
        self.counter += 1
        return self.counter - 1

    def tell(self, *operations: Operation) -> bytes:
        """A direct command without reply."""
        return direct_command(*operations, counter=self._count()).build()

    def ask(self, *operations: Operation, memory: bytes = b"", refused: int = 0) -> Exchange:
        """A direct command and its reply, which carries this memory; `refused` bytes are requested and refused."""
        counter = self._count()
        command = direct_command(*operations, counter=counter, reply=True, global_size=refused or len(memory))
        reply = direct_reply(memory, counter=counter, error=bool(refused))
        return Exchange(command.build(), reply.build())

    def system(
        self,
        command: int | str,
        answer: Mapping[str, FieldValue] | None = None,
        status: SystemStatus = SystemStatus.SUCCESS,
        **fields: FieldValue,
    ) -> Exchange:
        """A system command with its reply."""
        counter = self._count()
        asked = system_command(command, counter=counter, reply=True, **fields)
        reply = system_reply(asked.number, counter=counter, status=status, error=status.is_failure, **(answer or {}))
        return Exchange(asked.build(), reply.build())

    def mail(self, name: str, payload: bytes) -> bytes:
        """A message to a mailbox, which is never answered."""
        return system_command("WRITEMAILBOX", counter=self._count(), reply=False, name=name, payload=payload).build()


# Direct commands


def tone(frequency: int = 440, duration: int = 250) -> Operation:
    """A tone."""
    return operation("SOUND.TONE", VOLUME=5, FREQUENCY=frequency, DURATION=duration)


def light(pattern: str) -> Operation:
    """The light around the buttons."""
    return operation("UI_WRITE.LED", PATTERN=LEDPATTERN.members[pattern])


def start_motors() -> tuple[Operation, ...]:
    """Motors B and C at half speed."""
    return operation("OUTPUT_SPEED", LAYER=0, NOS=6, SPEED=50), operation("OUTPUT_START", LAYER=0, NOS=6)


def stop_motors() -> Operation:
    """Motors B and C brake."""
    return operation("OUTPUT_STOP", LAYER=0, NOS=6, BRAKE=1)


def voltage(host: Host, value: float = 7.92) -> Exchange:
    """The battery's voltage: one number."""
    return host.ask(operation("UI_READ.GET_VBATT", GV(0)), memory=struct.pack("<f", value))


def motor_angles(host: Host, *angles: int) -> Exchange:
    """The angles of motors B and C: two numbers."""
    reads = (operation("OUTPUT_GET_COUNT", LAYER=0, NOS=1 + index, TACHO=GV(4 * index)) for index in range(len(angles)))
    return host.ask(*reads, memory=struct.pack(f"<{len(angles)}i", *angles))


def touch(host: Host, percent: int) -> Exchange:
    """The touch sensor on port 1: one byte."""
    return host.ask(operation("INPUT_READ", LAYER=0, NO=0, TYPE=0, MODE=0, PCT=GV(0)), memory=bytes((percent,)))


def sensors(host: Host) -> Exchange:
    """Several operations with several outputs: an array, a byte, a text, a float."""
    types = [TYPE.members[name] for name in ("TYPE_TOUCH", "TYPE_GYRO", "TYPE_COLOR", "TYPE_NONE")]
    return host.ask(
        operation("INPUT_DEVICE_LIST", LENGTH=4, ARRAY=GV(0), CHANGED=GV(4)),
        operation("INPUT_DEVICE.GET_NAME", LAYER=0, NO=2, LENGTH=16, DESTINATION=GV(5)),
        operation("UI_READ.GET_VBATT", VALUE=GV(24)),
        memory=bytes((*types, 1)) + b"COL-REFLECT    \0" + bytes(3) + struct.pack("<f", 7.9),
    )


def gyro(host: Host, angle: float = -12.0, rate: float = 3.0) -> Exchange:
    """Angle and rate of the gyro sensor on port 2 in SI units: the number of outputs is an argument."""
    ready = operation(
        "INPUT_DEVICE.READY_SI", LAYER=0, NO=1, TYPE=TYPE.members["TYPE_GYRO"], MODE=3, VALUES=[GV(0), GV(4)]
    )
    return host.ask(ready, memory=struct.pack("<2f", angle, rate))


def versions(host: Host) -> Exchange:
    """Two texts: the brick's name and its firmware's version."""
    return host.ask(
        operation("COM_GET.GET_BRICKNAME", LENGTH=13, NAME=GV(0)),
        operation("UI_READ.GET_FW_VERS", LENGTH=8, DESTINATION=GV(13)),
        memory=b"myEV3".ljust(13, b"\0") + b"V1.04H\0\0",
    )


def misaligned(host: Host) -> Exchange:
    """A command that the brick refuses: a float at an odd place in its memory."""
    return host.ask(operation("UI_READ.GET_VBATT", GV(1)), refused=5)


# System commands


def status_at(end: int, size: int) -> SystemStatus:
    """The brick's status when this much of a file was transferred."""
    return SystemStatus.END_OF_FILE if end >= size else SystemStatus.SUCCESS


def listing(host: Host, path: str, piece: int) -> list[Exchange]:
    """The contents of a folder, in pieces."""
    files = {"values.rtf": CONTENTS, "first.rbf": IMAGE}
    lines = [
        "../",
        "./",
        *(f"{hashlib.md5(data).hexdigest().upper()} {len(data):08X} {name}" for name, data in files.items()),
    ]
    data = "".join(f"{line}\n" for line in lines)
    found = []
    for at in range(0, len(data), piece):
        answer: dict[str, FieldValue] = {"handle": HANDLE, "list": data[at : at + piece]}
        status = status_at(at + piece, len(data))
        if at == 0:
            answer["list_size"] = len(data)
            found.append(host.system("LIST_FILES", answer, status, max_bytes=piece, path=path))
        else:
            found.append(host.system("CONTINUE_LIST_FILES", answer, status, handle=HANDLE, max_bytes=piece))
    return found


def upload(host: Host, path: str, data: bytes, piece: int) -> list[Exchange]:
    """A file from the brick, in pieces."""
    found = []
    for at in range(0, len(data), piece):
        answer: dict[str, FieldValue] = {"handle": HANDLE, "data": data[at : at + piece]}
        status = status_at(at + piece, len(data))
        if at == 0:
            answer["size"] = len(data)
            found.append(host.system("BEGIN_UPLOAD", answer, status, max_bytes=piece, path=path))
        else:
            found.append(host.system("CONTINUE_UPLOAD", answer, status, handle=HANDLE, max_bytes=piece))
    return found


def download(host: Host, path: str, data: bytes, piece: int = 1017) -> list[Exchange]:
    """A file to the brick, in pieces."""
    found = [host.system("BEGIN_DOWNLOAD", {"handle": HANDLE}, size=len(data), path=path)]
    for at in range(0, len(data), piece):
        status = status_at(at + piece, len(data))
        part = data[at : at + piece]
        found.append(host.system("CONTINUE_DOWNLOAD", {"handle": HANDLE}, status, handle=HANDLE, data=part))
    return found


def long_download(host: Host, path: str, data: bytes, first: int) -> list[Exchange]:
    """A file to the brick: its first bytes with its name, the rest in one frame."""
    begin: dict[str, FieldValue] = {"size": len(data), "path": path, "data": data[:first]}
    found = [host.system("BEGIN_DOWNLOAD", {"handle": HANDLE}, status_at(first, len(data)), **begin)]
    if data[first:]:
        status = SystemStatus.END_OF_FILE
        found.append(host.system("CONTINUE_DOWNLOAD", {"handle": HANDLE}, status, handle=HANDLE, data=data[first:]))
    return found


def illegal_download(host: Host) -> Exchange:
    """A file that the brick refuses."""
    return host.system(
        "BEGIN_DOWNLOAD", {"handle": NO_HANDLE}, SystemStatus.ILLEGAL_PATH, size=3, path="/home/root/none/here.rtf"
    )

"""The virtual brick: frames in, frames out, and a clock that only the caller advances. No I/O.

It consists of the machine, which executes direct commands and programs, and of the parts that operations act on. As on
the real brick, a waiting direct command keeps the whole brick from reading: frames that arrive meanwhile are served in
order once it has ended.
"""

from __future__ import annotations

import math
import re
from collections import deque
from collections.abc import Hashable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from ev3proto.brick.devices.display.display import Display
from ev3proto.brick.devices.motors import Reading
from ev3proto.brick.dispatch import dispatch_table
from ev3proto.brick.equipment import Equipment
from ev3proto.brick.images import Image
from ev3proto.brick.limits import (
    MOST_OPERATIONS,
    MOST_PROCESSOR_SECONDS,
    MOST_SECONDS,
    MOST_WAITING,
    OPERATIONS_OF_A_TURN,
    OPERATIONS_PER_TICK,
    OPERATIONS_PER_TURN,
    TICK,
    thread_time,
)
from ev3proto.brick.machine import Machine
from ev3proto.brick.plugs import CORE_SET, port_name
from ev3proto.brick.running_programs import (
    CMD_SLOT,
    FAIL,
    OK,
    RUNNING,
    STOP,
    STOPPED,
    USER_SLOT,
    Program,
    ProgramObject,
)
from ev3proto.brick.system_commands import SystemCommands
from ev3proto.checking.verdict import Reason, verdict
from ev3proto.errors import as_bytes
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, Header, build_frame, frame_size, read_memory
from ev3proto.tables import check_dialect, operations
from ev3proto.tables.devices import NO_DEVICE, DeviceType
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, TYPES_BY_KIND, MessageType
from ev3proto.tables.system import SystemStatus

_OBJECT_END = operations()["OBJECT_END"].opcode.number

_DIRECT = {int(member): member.wants_reply for member in TYPES_BY_KIND["direct-command"]}
_SYSTEM = {int(member): member.wants_reply for member in TYPES_BY_KIND["system-command"]}

AFTER_CODE = bytes((_OBJECT_END,)) + bytes(8)
"""The bytes that the firmware adds after the operations of a direct command, and some of the zeros that follow."""

LOCALS = 64
"""Local memory of every direct command: always the maximum, whatever it requests."""


_MOST_NAME = 20

_MOST_SECONDS = 10**12
"""The longest step of the clock, 31,700 years: infinity would never end."""


class Addressed(NamedTuple):
    """A waiting frame or a reply, with its connection."""

    channel: Hashable
    frame: bytes


class Brick:
    """A brick that has just been switched on.

    root     the folder that serves as /home/root/lms2012; None for no files
    dialect  the firmware whose instruction set it has. ValueError for an unknown one.
    stretch  CPU seconds of this computer after which a call returns, between two operations of a direct command; the
             next call continues it. None: a call returns when the command ends or waits

    `has_ended_command`: a limit has ended a direct command. `is_computing`: a command is ready to continue.
    """

    def __init__(
        self, root: str | Path | None = None, *, dialect: str = "official", stretch: float | None = None
    ) -> None:
        if stretch is not None and (not isinstance(stretch, int | float) or not stretch >= 0):
            raise ValueError(f"stretch must be seconds, 0 or more, or None, not {stretch!r}")
        self.equipment = Equipment(root, check_dialect(dialect), self.stop)
        self._has_core_set = False
        self.has_ended_command = False
        self.is_computing = False
        self.machine = Machine(self.equipment, dispatch_table(self.equipment.dialect))
        self._global_memory = bytearray(GRANTED_GLOBALS)
        self._waiting: deque[Addressed] = deque()
        self._waiting_bytes = 0
        self._replies: list[Addressed] = []
        self._command: _Command | None = None
        self._stretch = math.inf if stretch is None else min(stretch, _MOST_SECONDS)
        self._deadline = math.inf
        self._system = SystemCommands(self.equipment, self.machine)

    # The parts around the machine

    @property
    def microseconds(self) -> int:
        """The clock, counted from when the brick was switched on."""
        return self.equipment.microseconds

    @property
    def display(self) -> Display:
        """The display: `display.rows` is what it shows."""
        return self.equipment.display

    @property
    def leds(self) -> int:
        """The pattern of the light behind the buttons, 0 to 9."""
        return self.equipment.panel.light

    @property
    def terminal(self) -> bytes:
        """The contents of UI_WRITE's text buffer since the last flush."""
        return bytes(self.equipment.console.text)

    def plug(
        self,
        port: int | str,
        type: int | Mapping[str, Any] | DeviceType,
        readings: Mapping[int, Sequence[float]] | None = None,
        *,
        tacho: int | None = None,
        count: int | None = None,
        speed: int | None = None,
    ) -> None:
        """Plugs in a sensor or motor, or changes the readings of the one on the port.

        Args:
            port: 1 to 4 or a SensorPort for sensors, "A" to "D" or a MotorPort for motors.
            type: Type of the device; TYPE_NONE unplugs it. Or a sensor of one's own, as `ev3proto.brick.declared` says:
                `{"type": 60, "modes": [{"name": "COMPASS", "format": "DATA_16", "raw": (0, 359)}]}`.
            readings: Raw readings of a sensor by mode, one for each dataset.
            tacho: Degrees that OUTPUT_READ returns. `tacho`, `count` and `speed` are shown until a command moves the
                motor; it counts on from `count`, and a move begins at 0.
            count: Degrees that OUTPUT_GET_COUNT returns.
            speed: Percent.

        Raises:
            ValueError: Unknown port, mode unknown to the type, readings that are not numbers by mode, or a key of a
                declaration that is missing, unknown or wrong.
        """
        port, inputs = port_name(port), self.equipment.inputs
        found = inputs.device_type(port, type)
        if self._has_core_set and inputs.has_new(port, found):
            self._unplug_all()
        inputs.plug(port, found, readings)
        if isinstance(port, str):
            is_fixed = any(value is not None for value in (tacho, speed, count))
            self.equipment.outputs.plug(
                port, found.number, Reading(tacho or 0, speed or 0, count or 0) if is_fixed else None
            )

    def plug_core_set(self) -> None:
        """Plugs in the equipment of LEGO's core set; a device that is plugged in afterwards replaces all of it."""
        for plug in CORE_SET:
            self.plug(plug.port, plug.type, plug.readings)
        self._has_core_set = True

    def _unplug_all(self) -> None:
        self._has_core_set = False
        for port in self.equipment.inputs.plugged():
            self.plug(port, NO_DEVICE.number)

    def press(self, button: str) -> None:
        """Presses a button by hand: up, enter, down, right, left or back. ValueError for any other name."""
        self.equipment.buttons.press(button, self.microseconds)

    def release(self, button: str) -> None:
        """Releases a button. ValueError for an unknown name."""
        self.equipment.buttons.release(button, self.microseconds)

    def stop(self) -> None:
        """Stops the user's program, as the back button does."""
        program = self.machine.slots[USER_SLOT]
        if program is not None:
            self.machine.end_program(program, STOP)

    def start(self, image: bytes, name: str = "program", slot: int = USER_SLOT) -> Program | None:
        """Starts a program as PROGRAM_START would; it replaces one that runs in the slot.

        Args:
            image: Contents of an .rbf file.
            name: The name of its folder in prjs: letters, digits, _ and -; other characters become _.
            slot: Number of the slot; by default the one for user programs.

        Returns:
            The program; None if the brick refuses the image.
        """
        project = f"../prjs/{re.sub(r'[^A-Za-z0-9_-]', '_', name)[:_MOST_NAME] or 'program'}/"
        self.equipment.files.make_folder(project.rstrip("/").encode())
        if not self.machine.start_program(slot, Image(image, project)):
            return None
        return self.machine.program_in(slot)

    # Frames

    def receive(self, frame: bytes) -> list[bytes]:
        """Takes a frame.

        Args:
            frame: One whole frame; bytes after it are ignored, like the padding of a USB report.

        Returns:
            The replies that are due at once; none while a command is busy or wants none.

        Raises:
            TypeError: The frame is not made of bytes.
        """
        return [reply.frame for reply in self.receive_from(None, frame)]

    def advance(self, seconds: float) -> list[bytes]:
        """Advances the clock.

        Args:
            seconds: 0 to 1000000000000, counted in whole microseconds. An hour of a motor that runs takes some 5 s.

        Returns:
            The replies that became due.

        Raises:
            ValueError: The number is out of range.
        """
        return [reply.frame for reply in self.advance_all(seconds)]

    def receive_from(self, channel: Hashable, frame: bytes) -> list[Addressed]:
        """Does the same as `receive` for a brick with several connections.

        Args:
            channel: Names the connection; every reply has the name of its own.
            frame: One whole frame.
        """
        if type(frame) is not bytes:
            frame = as_bytes(frame, "a frame")
        if self._waiting_bytes + len(frame) <= MOST_WAITING:
            self._waiting.append(Addressed(channel, frame))
            self._waiting_bytes += len(frame)
        if self._command is None:
            self._begin_stretch()
            self._serve()
        return self._take()

    def advance_all(self, seconds: float) -> list[Addressed]:
        """Does the same as `advance` for a brick with several connections."""
        if not 0 <= seconds <= _MOST_SECONDS:
            raise ValueError(f"seconds are a number from 0 to {_MOST_SECONDS}, not {seconds!r}")
        target = self.microseconds + round(seconds * 1_000_000)
        self._begin_stretch()
        is_first = True
        while self.microseconds < target:
            # Whole ticks while anything runs, so that results do not depend on the size of the steps.
            now = self.microseconds
            step = TICK - now % TICK if self._is_running() else target - now
            self.equipment.microseconds = min(target, now + step)
            for part in self.equipment.parts:
                part.advance(self.microseconds)
            if self.microseconds % TICK == 0 or not self._is_running():
                self._turn_programs(always=is_first)
                is_first = False
                if not self.is_computing or thread_time() < self._deadline:
                    self._serve()
        if self.is_computing:
            self._serve()
        return self._take()

    @property
    def is_busy(self) -> bool:
        """Whether a direct command is in progress: a real brick reads from no connection until it has ended."""
        return self._command is not None

    @property
    def waits_for(self) -> str:
        """What the direct command in progress waits for in vain, such as a motor that is not plugged in, in words."""
        return "" if self._command is None else self._command.program.waits_for

    @property
    def spent(self) -> float:
        """CPU seconds that the direct command in progress has computed; looking whether a wait is over takes none."""
        return 0.0 if self._command is None else self._command.spent

    def end_command(self) -> list[Addressed]:
        """Ends the direct command in progress as failed. Returns the replies that became due."""
        if self._command is not None:
            self.machine.end_program(self._command.program, FAIL)
        self._serve()
        return self._take()

    def disconnect(self, channel: Hashable) -> list[Addressed]:
        """Ends a connection: its waiting frames are dropped; its command in progress continues, but is not answered.

        Returns the replies that became due to others.
        """
        self._waiting = deque(waiting for waiting in self._waiting if waiting.channel != channel)
        self._waiting_bytes = sum(len(waiting.frame) for waiting in self._waiting)
        self._system.disconnect(channel)
        if self._command is not None and self._command.channel == channel:
            self._command.wants_reply = False
        self._serve()
        return self._take()

    def _begin_stretch(self) -> None:
        self._deadline = thread_time() + self._stretch

    def _take(self) -> list[Addressed]:
        replies, self._replies = self._replies, []
        return replies

    def _serve(self) -> None:
        """Continues the current command, then the waiting frames, until one of them has to wait for time."""
        while (self._command is not None or self._begin_next()) and (self._command is None or self._continue()):
            pass

    def _begin_next(self) -> bool:
        """Takes up the next frame. Returns False if there is none."""
        if not self._waiting:
            return False
        channel, frame = self._waiting.popleft()
        self._waiting_bytes -= len(frame)
        if not self.equipment.is_dead:
            self._take_up(channel, frame)
        return True

    def _take_up(self, channel: Hashable, frame: bytes) -> None:
        if len(frame) < HEADER_SIZE:
            return
        _, counter, code = Header.read(frame)
        end = frame_size(frame)
        if end > len(frame) or end < HEADER_SIZE:
            return
        if code in _DIRECT:
            self._take_direct(channel, frame[:end], counter, _DIRECT[code])
        elif code in _SYSTEM:
            self._take_system(channel, frame[:end], counter, _SYSTEM[code])

    # Direct commands

    def _take_direct(self, channel: Hashable, frame: bytes, counter: int, wants_reply: bool) -> None:
        found = verdict(frame, self.equipment.dialect)
        if found.reason in (Reason.EMPTY, Reason.TOO_LONG, Reason.GLOBALS):
            # The firmware never reads again after such a header; this brick answers and continues.
            if wants_reply:
                self._reply(channel, counter, MessageType.DIRECT_REPLY_ERROR, b"")
            return
        global_size, local_size = read_memory(frame)
        code = bytearray(frame[COMMAND_HEADER_SIZE:])
        code += AFTER_CODE
        end = len(frame) - COMMAND_HEADER_SIZE
        only = ProgramObject(1, 0, bytearray(LOCALS), local_size, status=RUNNING)
        program = Program(CMD_SLOT, code, end, self._global_memory, global_size, {1: only}, started=self.microseconds)
        command = _Command(channel, counter, wants_reply, program, global_size)
        if not found.accepted:
            program.status, program.result = STOPPED, FAIL
            self._answer(command, program)
            return
        self._command = command

    def _continue(self) -> bool:
        """Executes the command in progress until it ends, waits or takes too long. Returns whether it has ended."""
        command = self._command
        assert command is not None
        program = command.program
        self.machine.slots[CMD_SLOT] = program
        now = thread_time()
        has_waited = False
        while program.status == RUNNING:
            if command.is_endless(self.microseconds):
                self.machine.end_program(program, FAIL)
                self.has_ended_command = True
                break
            deadline = min(self._deadline, now + MOST_PROCESSOR_SECONDS - command.spent)
            executed, is_waiting = self.machine.turn(program, OPERATIONS_PER_TURN, deadline)
            begun, now = now, thread_time()
            if not is_waiting:
                command.executed += max(OPERATIONS_OF_A_TURN, executed)
                command.spent += now - begun
            if program.status == RUNNING and (now > self._deadline or (is_waiting and has_waited)):
                self.is_computing = not is_waiting
                return False
            # Repeated once immediately: some operations wait only for what they have changed themselves.
            has_waited = is_waiting
        self._command = None
        self.is_computing = False
        if not self.equipment.is_dead:
            self._answer(command, program)
        # A real brick takes some milliseconds for a frame, during which its programs continue.
        self._turn_programs(always=False)
        return True

    def _answer(self, command: _Command, program: Program) -> None:
        if command.wants_reply:
            is_fine = program.result == OK
            kind = MessageType.DIRECT_REPLY if is_fine else MessageType.DIRECT_REPLY_ERROR
            self._reply(command.channel, command.counter, kind, bytes(self._global_memory[: command.global_size]))

    def _reply(self, channel: Hashable, counter: int, kind: MessageType, contents: bytes) -> None:
        # The firmware grants more global memory than a frame of the usual size carries.
        length = HEADER_SIZE - LENGTH_FIELD + len(contents)
        self._replies.append(Addressed(channel, build_frame(kind, counter, contents, length)))

    # System commands

    def _take_system(self, channel: Hashable, frame: bytes, counter: int, wants_reply: bool) -> None:
        found: tuple[bool, bytes] | None
        found = True, frame[HEADER_SIZE : HEADER_SIZE + 1] + bytes((SystemStatus.UNKNOWN_ERROR,))
        try:
            with suppress(OSError):  # such as a full disk
                found = self._system.answer(channel, frame)
        finally:
            if found is not None and wants_reply:
                is_error, contents = found
                kind = MessageType.SYSTEM_REPLY_ERROR if is_error else MessageType.SYSTEM_REPLY
                self._reply(channel, counter, kind, contents)

    # Time and programs

    def _is_running(self) -> bool:
        return any(program is not None and program.status == RUNNING for program in self.machine.slots)

    def _turn_programs(self, *, always: bool) -> None:
        """Gives every program its turns of a tick, in equal shares; with `always`, at least a few operations."""
        running = [program for program in self.machine.slots if program is not None and program.slot != CMD_SLOT]
        for number, program in enumerate(running):
            deadline = math.inf
            if self._deadline < math.inf:
                now = thread_time()
                deadline = now + (self._deadline - now) / (len(running) - number)
            self._turn_program(program, deadline, always=always)

    def _turn_program(self, program: Program, deadline: float, *, always: bool) -> None:
        left, waiting = program.due or OPERATIONS_PER_TICK, 0
        program.due, begin = 0, left
        # When all objects in turn have waited, nothing more can happen before the next tick.
        while left > 0 and program.status == RUNNING and waiting <= len(program.objects):
            if deadline < math.inf and not (always and left == begin) and thread_time() > deadline:
                program.due = left
                break
            executed, is_waiting = self.machine.turn(program, min(left, OPERATIONS_PER_TURN), deadline)
            left -= max(executed, 1)
            waiting = waiting + 1 if is_waiting else 0


@dataclass
class _Command:
    """A direct command in progress."""

    channel: Hashable
    counter: int
    wants_reply: bool
    program: Program
    global_size: int
    executed: int = 0  # operations so far, without those that waited
    spent: float = 0.0  # CPU seconds of this computer that it has computed

    def is_endless(self, now: int) -> bool:
        """Returns whether it is to be ended, at a time in microseconds."""
        has_computed = self.executed >= MOST_OPERATIONS or self.spent > MOST_PROCESSOR_SECONDS
        return has_computed or now - self.program.started >= MOST_SECONDS * 1_000_000

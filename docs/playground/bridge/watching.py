"""What is asked of a real brick every second: name, firmware, battery, and the devices at its ports."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from ev3proto.link import questions
from ev3proto.link.commands import SyncMode, direct
from ev3proto.link.errors import LinkError
from ev3proto.link.policy import Outcome, Talk
from ev3proto.link.questions import Question
from ev3proto.ops import input_readsi
from ev3proto.schema.header import Header, build_frame
from ev3proto.tables.devices import DEVICE_TYPES, NO_DEVICE
from ev3proto.tables.input import MOTOR_PORTS, SENSOR_PORTS
from ev3proto.tables.ports import MotorPort

from .connection import Connection

PERIOD = 1.0
"""Seconds between two rounds of questions."""

DIALECT = "official"

_NO_CHANGE = -1
_PORTS = (*SENSOR_PORTS, *MOTOR_PORTS)
_PORT_NAMES = (*(str(port + 1) for port in SENSOR_PORTS), *MotorPort.__members__)
_TYPES_AND_MODES = Question(
    questions.SENSORS.operations, lambda values: list(zip(map(int, values[::2]), map(int, values[1::2]), strict=True))
)


class Watch:
    """The facts about a brick.

    is_wanted  whether they are asked for every second
    facts      those that are known
    """

    def __init__(self, connection: Connection, tell: Callable[..., object]) -> None:
        """Begins without questions; `tell` takes `facts` for the page."""
        self._connection = connection
        self._tell = tell
        self._due = 0.0
        self.is_wanted = False
        self.facts: dict[str, Any] = {}

    def want(self, is_wanted: bool) -> None:
        """Begins or ends asking."""
        self.is_wanted = is_wanted
        self._due = 0.0

    def turn(self) -> None:
        """Lets time pass: asks, if it is time and no other command waits."""
        now = time.monotonic()
        if not self.is_wanted or not self._connection.is_idle or now < self._due:
            return
        self._due = now + PERIOD
        self._ask(questions.NAME, lambda name: self._know(name=name))
        self.ask_firmware()
        self._ask(
            questions.BATTERY,
            lambda found: self._know(battery=f"{found.voltage:.2f} V, {found.current:.2f} A, {found.percentage} %"),
        )
        self._ask(_TYPES_AND_MODES, self._ask_values)

    def ask_firmware(self) -> None:
        """Asks for the version of the firmware."""
        self._ask(questions.SYSTEM, lambda system: self._know(firmware=system.fw_version))

    def _ask_values(self, found: list[tuple[int, int]]) -> None:
        """Asks for the values of the devices that are plugged in."""
        plugged = [(at, kind, mode) for at, (kind, mode) in enumerate(found) if kind != NO_DEVICE.number]
        drafts = tuple(input_readsi(0, _PORTS[at], 0, _NO_CHANGE) for at, _, _ in plugged)
        if not drafts:
            self._know(ports=[])
            return

        def know(values: list[float]) -> None:
            rows = zip(plugged, values, strict=True)
            self._know(ports=[[_PORT_NAMES[at], *shown(kind, mode, value)] for (at, kind, mode), value in rows])

        self._ask(Question(drafts, lambda values: values), know)

    def _ask(self, question: Question[Any], know: Callable[[Any], None]) -> None:
        prepared = direct(question.operations, 0, 0, SyncMode.SYNC, DIALECT)

        def talk() -> Talk:
            reply = yield build_frame(prepared.kind, 0, prepared.body)
            return Outcome(reply=reply)

        def done(outcome: Outcome, _: float, reason: str) -> None:
            reply = outcome.reply
            if reply is None:
                self._know(silence=reason)
                return
            sent = build_frame(prepared.kind, Header.read(reply).counter, prepared.body)
            with suppress(LinkError):
                values = prepared.result(sent, reply)
                assert isinstance(values, list)
                know(question.read(values))

        self._connection.converse(talk(), done)

    def _know(self, *, silence: str = "", **facts: Any) -> None:
        self.facts |= facts
        self._tell(facts=self.facts | {"silence": silence})


def shown(kind: int, mode: int, value: float) -> tuple[str, str]:
    """Returns what a device is called, and its value with the decimals that the brick shows."""
    device = DEVICE_TYPES.get(kind)
    title = f"type {kind}" if device is None else device.title
    if value != value:
        return title, "-"
    if device is None or not 0 <= mode < len(device.modes):
        return title, f"{value:g}"
    chosen = device.modes[mode]
    unit = chosen.labels[0].unit if chosen.labels else ""
    return title, f"{value:.{chosen.decimals}f} {unit}".strip()

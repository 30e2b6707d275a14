"""WiFi: programs that do not wait for a reply, or that never change their counter, each in a connection of its own."""

from __future__ import annotations

from dataclasses import dataclass

from making import dialogue
from making.dialogue import Exchange, Host
from making.files import SECOND, Wire
from making.wifi import Connection

MILLISECOND = SECOND // 1000


@dataclass(frozen=True)
class Sender:
    """How a program sends commands, and how the brick answers.

    counters  how many counters it uses in turn
    period    milliseconds from one command to the next
    lag       milliseconds until the reply
    at_once   commands that are sent together
    lost      commands that are not answered, by number
    """

    counters: int
    period: int
    lag: int
    at_once: int = 1
    lost: tuple[int, ...] = ()


SENDERS = (
    # Counters of their own, a reply before the next command.
    Sender(counters=65536, period=100, lag=10),
    # Scratch's extension: always counter 0, and a timer that does not wait.
    Sender(counters=1, period=100, lag=150),
    Sender(counters=1, period=50, lag=300),
    Sender(counters=1, period=100, lag=10, at_once=2),
    Sender(counters=1, period=100, lag=10, lost=(6, 13)),
    Sender(counters=1, period=100, lag=10, at_once=2, lost=(6,)),
)


def whole(commands: int = 20) -> Wire:
    """The connections, one after the other. Commands ask for the battery and the motors in turn."""
    wire = Wire()
    for number, sender in enumerate(SENDERS):
        connection = Connection(wire)
        connection.host.port += number
        connection.open()
        connection.unlock()
        _poll(connection, sender, commands)
        connection.close()
    return wire


def _poll(connection: Connection, sender: Sender, commands: int) -> None:
    """Sends commands by a timer. The angle of motor B is the number of the command that asks for it."""
    wire = connection.wire
    start = wire.now + 20 * MILLISECOND
    events: list[tuple[int, int, Exchange]] = []
    for number in range(commands):
        host = Host(number % sender.counters)
        exchange = dialogue.motor_angles(host, number) if number % 2 else dialogue.voltage(host)
        sent = start + number // sender.at_once * sender.period * MILLISECOND
        events.append((sent, 0, exchange))
        if number not in sender.lost:
            # A brick answers in order, one after the other.
            events.append((sent + (sender.lag + 2 * (number % sender.at_once)) * MILLISECOND, 1, exchange))
    for time, is_reply, exchange in sorted(events, key=lambda event: event[:2]):
        end, frame = (connection.brick, exchange.reply) if is_reply else (connection.host, exchange.command)
        wire.wait(max(time - wire.now, 0))
        connection.deliver(end, connection.segment(end, frame, "PA"))

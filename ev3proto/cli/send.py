"""`ev3proto send`: sends frames to a brick, real or virtual, and shows the replies."""

from __future__ import annotations

import sys
from dataclasses import replace
from functools import partial

import click

from ev3proto.brick.plugs import CORE_SET_SENTENCE
from ev3proto.capture.dialogues import RequestReply, is_error
from ev3proto.cli.encode import Making, encoded
from ev3proto.cli.formats import Format, made
from ev3proto.cli.options import bare_option, dialect_option, json_option, reply_option
from ev3proto.cli.output import Failure, complain
from ev3proto.cli.reading import Problems
from ev3proto.cli.show import Dialogues
from ev3proto.cli.targets import TargetType, channel_to, is_refused, timeout_option
from ev3proto.errors import counted
from ev3proto.link.channel import Channel
from ev3proto.link.errors import LinkError
from ev3proto.link.records import Records
from ev3proto.link.targets import Target, Way
from ev3proto.messages import DirectCommand, Message
from ev3proto.reading.options import Options
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.declaration import Role

_PORTS = (Role.MOTOR, Role.MOTORS, Role.PORT, Role.PORTS)


@click.command()
@click.argument("target", type=TargetType())
@click.argument("names", nargs=-1, metavar="[FRAME|TEXT|FILE|-]...")
@json_option
@click.option("--force", is_flag=True, help="Send also frames that the brick would refuse.")
@bare_option
@timeout_option
@reply_option
@dialect_option
def send(
    target: Target,
    names: tuple[str, ...],
    as_json: bool,
    force: bool,
    bare: bool,
    timeout: float,
    reply: bool | None,
    dialect: str,
) -> None:
    """Sends frames to a brick and shows the replies.

    TARGET is the brick: wifi, wifi:ADDRESS, wifi:ADDRESS:PORT, usb, usb:SERIALNUMBER, bluetooth:MAC, serial:PORT, or
    virtual for a temporary virtual brick with LEGO's core set: a medium motor on A, large motors on B and C; touch,
    gyro, colour and ultrasonic sensor on 1 to 4. The input is the same as for `encode`: hex, assembly, files, captures,
    or - (or nothing) for standard input. A brick's replies in it are skipped.

    All frames are checked first, and their errors are shown; if the brick would refuse one, nothing is sent. A single
    frame is sent with the hints of `check` for frames that do nothing by themselves. Each reply is awaited before the
    next frame is sent.

    \b
      ev3proto send wifi 'SOUND(TONE, 1, 440, 1000)'
      ev3proto send usb 'UI_READ(GET_VBATT, GV0(0))'
      ev3proto send wifi:127.0.0.1 "0x|06:00|2A:00|00|00:00|01|"
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if bare and target.way is not Way.VIRTUAL:
        raise click.UsageError("--bare is for a virtual brick")
    problems = Problems()
    found = encoded(names, Options(dialect, raises=False), Making(reply=reply), problems, faults=False)
    commands = _commands(list(found), problems, is_forced=force)
    if not force and _refused(commands, dialect, target.carrier):
        raise Failure("nothing was sent; --force sends it anyway")
    if target.way is Way.VIRTUAL and not bare and any(map(_uses_ports, commands)):
        complain(CORE_SET_SENTENCE)
    with channel_to(replace(target, is_bare=bare)) as channel:
        is_fine = _talk(channel, commands, made("json" if as_json else None), timeout, dialect, str(target))
    sys.exit(problems.status if is_fine else 1)


def _commands(found: list[Message], problems: Problems, *, is_forced: bool) -> list[Message]:
    """Returns the messages that can be sent. Ends the program without any, or if not all of the input was read."""
    commands = [message for message in found if message.type is None or message.type.is_command]
    if not commands:
        problems.end_without("nothing to send; expected frames in hex, or assembly")
    if problems.errors and not is_forced:
        raise Failure("nothing was sent, because part of the input cannot be read; --force sends the rest")
    if len(commands) < len(found):
        complain(f"skipped {counted(len(found) - len(commands), 'frame')} from a brick")
    return commands


def _refused(commands: list[Message], dialect: str, carrier: str) -> list[Message]:
    """Returns the commands that the brick would refuse; what is wrong with each one is printed."""
    checked = partial(is_refused, dialect=dialect, carrier=carrier, alone=len(commands) == 1)
    return [each for number, each in enumerate(commands, 1) if checked(each.build(), f"frame {number}")]


def _uses_ports(message: Message) -> bool:
    """Returns whether the result of a command may depend on what is plugged in."""
    return isinstance(message, DirectCommand) and any(
        parameter.role in _PORTS for operation in message.operations for parameter in operation.declaration.parameters
    )


def _talk(channel: Channel, messages: list[Message], show: Format, timeout: float, dialect: str, peer: str) -> bool:
    """Sends the messages, and shows each with its reply. Returns whether all went well."""
    records, dialogues = Records(channel.carrier, peer, dialect), Dialogues(show, is_known=True)
    is_fine = True
    for message in messages:
        frame = message.build()
        if len(frame) < HEADER_SIZE:
            complain(f"{frame.hex(':').upper()} is too short to send: the brick would wait for the rest of it")
            is_fine = False
            continue
        command = records.sent(frame)
        try:
            ticket = channel.send_frame(frame)
            answer = channel.wait(ticket, timeout) if ticket.request.wants_reply else b""
        except LinkError as error:
            dialogues.show(RequestReply(command, None), records.start_ns)
            complain(str(error))
            return False
        received = records.received(answer, command) if answer else None
        dialogues.show(RequestReply(command, received), records.start_ns)
        is_fine &= received is None or not is_error(received.message)
    return is_fine

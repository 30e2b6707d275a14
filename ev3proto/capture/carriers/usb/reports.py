"""USB: reports that each have one frame at their start, to and from devices that are bricks or behave like one."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.bounded import Bounded
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.carriers.usb.requests import IN, INTERRUPT, Urb, urb
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.finding import makes_sense
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import HOST, Direction, Event, Route, Skipped
from ev3proto.schema.header import HEADER_SIZE, frame_size, is_frame_size
from ev3proto.tables import system
from ev3proto.tables.carriers import USB_PRODUCTS, Carrier
from ev3proto.tables.claims import FAULTS_IN_A_ROW, ODD_REPORTS
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, MAX_LENGTH, MIN_LENGTH, REPORT_SIZES, MessageType

MOST_DEVICES = 4096
"""Devices of which something is remembered: more than any computer has."""

_BIG_REPORT = MAX_FRAME
_TYPES = {int(member): member for member in MessageType}
_BOOTLOADER = frozenset(command.number for command in system.SYSTEM if command.bootloader)

MOST_CLAIMED = 64
"""Devices nobody knows as bricks of which is remembered what they were asked."""

MOST_ASKED = 16
"""Commands of a device nobody knows as a brick whose reply is awaited."""

OVERWRITTEN = "a known fault of the EV3's bootloader on USB 3 ports: the reply with the request written over its start"


class _Claim:
    """What is known of a device that nobody knows as a brick."""

    __slots__ = ("_asked", "_faults", "_is_answered", "_odd")

    def __init__(self) -> None:
        self._asked: dict[tuple[str, bytes], None] = {}
        self._is_answered = False
        self._faults = 0
        self._odd = 0

    def meet_odd(self) -> None:
        """Meets a report that begins with a frame's length and is none."""
        self._odd += 1

    def take(self, member: MessageType, frame: bytes) -> bool:
        """Takes a flawless frame that goes the right way.

        A reply must answer a command, and a command of a device with odd reports must follow such a reply.
        """
        counter_and_number = frame[LENGTH_FIELD : HEADER_SIZE - 1] + frame[HEADER_SIZE:][: member.carries == "system"]
        key = member.carries, counter_and_number
        if not member.is_command:
            is_answer = key in self._asked
            self._asked.pop(key, None)
            self._is_answered |= is_answer
            return is_answer
        is_alone = self._odd > ODD_REPORTS and not self._is_answered
        if member.wants_reply:
            if is_alone:
                self._asked.clear()
            self._asked[key] = None
            if len(self._asked) > MOST_ASKED:
                del self._asked[next(iter(self._asked))]
        return not is_alone

    def judge(self, is_flawless: bool) -> bool:
        """Says whether a frame is ours that is known to be flawless or not: after a dialogue faults are, too."""
        self._faults = 0 if is_flawless else self._faults + 1
        self._is_answered &= self._faults < FAULTS_IN_A_ROW
        return is_flawless or self._is_answered


class Reports:
    """Follows the interrupt transfers of all devices."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._products: Bounded[str, bool] = Bounded(MOST_DEVICES)
        self._conversations: Bounded[str, Conversation] = Bounded(MOST_DEVICES)
        self._routes: Bounded[tuple[str, bool, str | None], Route] = Bounded(MOST_DEVICES)
        self._claims: Bounded[str, _Claim] = Bounded(MOST_CLAIMED)

    def feed(self, packet: Packet) -> Iterable[Event]:
        """The events in a packet: at most one."""
        found = urb(packet)
        if found is None:
            self._account.other += len(packet.data)
            return ()
        if found.transfer != INTERRUPT:
            if found.product is not None:
                self._products.add(found.device, found.product in USB_PRODUCTS)
            self._account.other += len(packet.data)
            return ()
        if len(found.data) < HEADER_SIZE:
            self._account.other += len(packet.data)
            return ()
        is_from_host = not found.endpoint & IN
        size = frame_size(found.data)
        frame = found.data[:size]
        is_length = is_frame_size(size)
        is_brick = self._products.get(found.device, False)
        if not is_brick and not self._is_claimed(found, frame, size, is_from_host, packet):
            self._account.other += len(packet.data)
            return ()
        self._account.headers += len(packet.data) - len(found.data)
        route = self._route(found.device, is_from_host, packet)
        if not is_length:
            self._account.skipped += len(found.data)
            reason = (
                f"the report holds no frame: its length field would say {size - LENGTH_FIELD}, a frame has {MIN_LENGTH}"
                f" to {MAX_LENGTH} bytes after it"
            )
            return (Skipped(found.data, 0, reason, packet.number, packet.time_ns, route),)
        self._account.frames += len(frame)
        self._account.padding += len(found.data) - len(frame)
        conversation = self._conversation(found.device)
        if _is_overwritten(frame, is_from_host):
            record = conversation.overwritten(frame, (packet.number,), packet.time_ns, route)
            record.note = OVERWRITTEN
            return (record,)
        return (conversation.record(frame, (packet.number,), packet.time_ns, route),)

    def end(self) -> Iterable[Event]:
        """Nothing waits for more: a report is whole in its packet."""
        return ()

    def _conversation(self, device: str) -> Conversation:
        if device not in self._conversations:
            self._conversations.add(device, self._context.conversation())
        return self._conversations[device]

    def _route(self, device: str, is_from_host: bool, packet: Packet) -> Route:
        key = device, is_from_host, packet.interface.name
        if key not in self._routes:
            ends = (HOST, device) if is_from_host else (device, HOST)
            direction = Direction.SENT if is_from_host else Direction.RECEIVED
            self._routes.add(key, Route(Carrier.USB, *ends, direction, packet.interface.name, device))
        return self._routes[key]

    def _is_claimed(self, found: Urb, frame: bytes, size: int, is_from_host: bool, packet: Packet) -> bool:
        """Whether a report of a device that is not known to be a brick is one of ours.

        Other devices have reports, too, and some of them begin like a frame: it must fit in every respect.
        """
        reported = len(found.data) + packet.size - len(packet.data)
        is_whole = reported in REPORT_SIZES and is_frame_size(size) and len(frame) == size
        member = _TYPES.get(frame[HEADER_SIZE - 1]) if is_whole else None
        is_big = reported == _BIG_REPORT
        is_right = member is not None and (member.carries == "daisy" or is_big)
        claim = self._claims.get(found.device)
        if is_whole and (not is_right or _is_backwards(member, is_from_host)):
            claim = claim or self._claims.use(found.device, _Claim)[0]
            claim.meet_odd()
        if member is None or not is_right:
            if claim is not None:
                claim.judge(is_flawless=False)
            return False
        message = self._context.schema.read_frame(frame, strict=False)
        if _is_overwritten(frame, is_from_host):
            return message.fault is None
        is_taken = message.fault is None and makes_sense(message)
        # Bricks in a chain send commands both ways. They are no computers, whose reports are larger.
        if is_big:
            is_taken = is_taken and member.is_command == is_from_host
            if is_taken and (member.wants_reply or claim is not None):
                claim = claim or self._claims.use(found.device, _Claim)[0]
                is_taken = claim.take(member, frame)
            elif not member.is_command:
                is_taken = False
        if is_big and member.carries == "daisy" and not is_taken:
            claim = claim or self._claims.use(found.device, _Claim)[0]
            claim.meet_odd()
        return is_taken if claim is None else claim.judge(is_taken)


def _is_backwards(member: MessageType | None, is_from_host: bool) -> bool:
    """Whether a direct command comes from the device, or a reply to one goes to it."""
    return member is not None and member.carries == "direct" and member.is_command != is_from_host


def _is_overwritten(frame: bytes, is_from_host: bool) -> bool:
    """Whether a reply came with the request written over its first bytes: from the device, yet of a command's type."""
    member = _TYPES.get(frame[HEADER_SIZE - 1]) if len(frame) > HEADER_SIZE else None
    if member is None or is_from_host:
        return False
    return member.kind == "system-command" and frame[HEADER_SIZE] in _BOOTLOADER

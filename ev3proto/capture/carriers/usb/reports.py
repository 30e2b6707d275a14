"""USB: reports to and from bricks, each with one frame at its start."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.bounded import Bounded
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.carriers.usb.requests import IN, INTERRUPT, Urb, urb
from ev3proto.capture.claims import Claim, is_plausible, is_sensible
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import HOST, Direction, Event, Route, Skipped
from ev3proto.schema.header import HEADER_SIZE, frame_size, is_frame_size
from ev3proto.tables import system
from ev3proto.tables.carriers import USB_PRODUCTS, Carrier
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, MAX_LENGTH, MIN_LENGTH, REPORT_SIZES, MessageType

MOST_DEVICES = 4096
"""Maximum number of remembered devices; no computer has more."""

_BIG_REPORT = MAX_FRAME
_TYPES = {int(member): member for member in MessageType}
_BOOTLOADER = frozenset(command.number for command in system.SYSTEM if command.bootloader)

OVERWRITTEN = "a known fault of the EV3's bootloader on USB 3 ports: the reply with the request written over its start"


class Reports:
    """A reader of the interrupt transfers of all devices."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._products: Bounded[str, bool] = Bounded(MOST_DEVICES)
        self._conversations: Bounded[str, Conversation] = Bounded(MOST_DEVICES)
        self._routes: Bounded[tuple[str, bool, str | None], Route] = Bounded(MOST_DEVICES)
        self._claims: Bounded[str, Claim] = Bounded(MOST_DEVICES)

    def feed(self, packet: Packet) -> Iterable[Event]:
        """Returns the event in a packet, if any."""
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
        claim = None if is_brick else self._claims.use(found.device, Claim)[0]
        if claim is not None and not self._is_claimed(claim, found, frame, is_from_host, packet):
            self._account.other += len(packet.data)
            return ()
        self._account.headers += len(packet.data) - len(found.data)
        route = self._route(found.device, is_from_host, packet)
        if not is_length:
            self._account.skipped += len(found.data)
            reason = (
                f"the report has no frame: its length field is {size - LENGTH_FIELD}, but the range is {MIN_LENGTH} to"
                f" {MAX_LENGTH}"
            )
            return (Skipped(found.data, 0, reason, packet.number, packet.time_ns, route),)
        self._account.frames += len(frame)
        self._account.padding += len(found.data) - len(frame)
        conversation = self._conversation(found.device)
        if _is_overwritten(frame, is_from_host):
            record = conversation.overwritten(frame, (packet.number,), packet.time_ns, route)
            record.note = OVERWRITTEN
            return (record,)
        record = conversation.record(frame, (packet.number,), packet.time_ns, route)
        if claim is not None and claim.is_claimed:
            claim.count(is_good=claim.is_ours(record))
        return (record,)

    def end(self) -> Iterable[Event]:
        """Returns nothing: reports are never pending."""
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

    def _is_claimed(self, claim: Claim, found: Urb, frame: bytes, is_from_host: bool, packet: Packet) -> bool:
        """Returns whether a report of a device that may not be a brick is claimed.

        Reports of other devices may begin like a frame, so its size must be that of its type.
        """
        reported = len(found.data) + packet.size - len(packet.data)
        is_whole = reported in REPORT_SIZES and is_frame_size(len(frame)) and len(frame) == frame_size(frame)
        member = _TYPES.get(frame[HEADER_SIZE - 1]) if is_whole else None
        is_big = reported == _BIG_REPORT
        if member is None or not (is_big or member.carries == "daisy"):
            claim.count(is_good=False, unread=len(found.data))
            return False
        message = self._context.schema.read_frame(frame, strict=False)
        # Bricks in a chain send commands both ways, in smaller reports than computers.
        if not is_big or _is_overwritten(frame, is_from_host):
            return is_sensible(message)
        if member.is_command != is_from_host:
            claim.count(is_good=False, unread=len(found.data))
            return False
        if not claim.is_claimed and is_plausible(message, self._context.schema):
            claim.begin()
        return claim.is_claimed


def _is_overwritten(frame: bytes, is_from_host: bool) -> bool:
    """Returns whether a reply has the request written over its start: it is from the device, with a command's type."""
    member = _TYPES.get(frame[HEADER_SIZE - 1]) if len(frame) > HEADER_SIZE else None
    if member is None or is_from_host:
        return False
    return member.kind == "system-command" and frame[HEADER_SIZE] in _BOOTLOADER

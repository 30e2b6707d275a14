"""USB: reports to and from bricks, each with one frame at its start."""

from __future__ import annotations

from collections.abc import Iterable

from ev3proto.bounded import Bounded
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.carriers.usb.requests import INTERRUPT, Urb, urb
from ev3proto.capture.claims import Claim, State
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.evidence import is_sensible
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import HOST, Direction, Event, Route, Skipped, missing_of
from ev3proto.schema.header import HEADER_SIZE, frame_size, is_frame_size
from ev3proto.tables import system
from ev3proto.tables.carriers import USB_PRODUCTS, Carrier
from ev3proto.tables.frame import (
    LENGTH_FIELD,
    MAX_FRAME,
    MAX_LENGTH,
    MESSAGE_TYPES,
    MIN_LENGTH,
    REPORT_SIZES,
)

MOST_DEVICES = 1024
"""Maximum number of remembered devices; no computer has more."""

_BOOTLOADER = frozenset(command.number for command in system.SYSTEM if command.bootloader)

_STRANGE = f"with a USB report of {MAX_FRAME} bytes"


class Reports:
    """A reader of the interrupt transfers of all devices."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._account = context.account
        self._claims: Bounded[str, Claim] = Bounded(MOST_DEVICES)
        self._conversations: Bounded[str, Conversation] = Bounded(MOST_DEVICES)
        self._routes: Bounded[tuple[str, bool, str | None], Route] = Bounded(MOST_DEVICES)

    def feed(self, packet: Packet) -> Iterable[Event]:
        """Returns the events that a packet completes."""
        found = urb(packet)
        events = [] if found is None else self._events(packet, found)
        if not events:
            self._account.other += len(packet.data)
        return events

    def end(self) -> Iterable[Event]:
        """Returns nothing: reports are never pending."""
        return ()

    def _events(self, packet: Packet, found: Urb) -> list[Event]:
        if found.product is not None:
            self._claims.add(found.device, self._claim(is_sure=found.product in USB_PRODUCTS))
        if found.transfer != INTERRUPT or len(found.data) < HEADER_SIZE:
            return []
        claim = self._claims.use(found.device, self._claim)[0]
        is_big = len(found.data) + packet.missing == MAX_FRAME
        is_sure = claim.state is State.SURE or (is_big and self._context.is_all)
        earlier = [] if is_sure else self._earlier(claim, packet, found, is_big=is_big)
        if earlier is not None:
            return [*earlier, self._event(claim, packet, found)]
        if is_big:
            self._account.count_strange(_STRANGE)
        return []

    def _route(self, device: str, is_from_host: bool, packet: Packet) -> Route:
        key = device, is_from_host, packet.interface.name
        if key not in self._routes:
            ends = (HOST, device) if is_from_host else (device, HOST)
            direction = Direction.SENT if is_from_host else Direction.RECEIVED
            self._routes.add(key, Route(Carrier.USB, *ends, direction, packet.interface.name, device))
        return self._routes[key]

    def _claim(self, *, is_sure: bool = False) -> Claim:
        return Claim(self._context.schema, lambda member: member.is_command, is_sure=is_sure)

    def _earlier(self, claim: Claim, packet: Packet, found: Urb, *, is_big: bool) -> list[Event] | None:
        """Returns the events of the earlier commands that a report proves, if the report is claimed; else None."""
        # Reports of other devices may begin like a frame, so the report's size must be that of the frame's type.
        frame, reported = found.frame, len(found.data) + packet.missing
        fits = reported in REPORT_SIZES and is_frame_size(frame_size(frame)) and frame_size(frame) <= reported
        member = MESSAGE_TYPES.get(frame[HEADER_SIZE - 1]) if fits else None
        if member is not None and (member.carries == "daisy" if not is_big else _is_overwritten(found)):
            # Bricks in a chain send commands both ways, in smaller reports than computers.
            return [] if is_sensible(self._context.schema.read_frame(frame, strict=False)) else None
        if member is None or not is_big or member.is_command != found.is_from_host:
            claim.count((), len(found.data))
            return None
        return [] if claim.is_claimed else self._proved(claim, packet, found)

    def _proved(self, claim: Claim, packet: Packet, found: Urb) -> list[Event] | None:
        def adopt() -> list[Event]:
            self._account.other -= len(packet.data)
            self._account.count_strange(_STRANGE, -1)
            return [self._event(claim, packet, found)]

        frame = found.frame
        missing = missing_of(frame)
        _, _, earlier = claim.judge(
            found.is_from_host, frame, lambda _: adopt, missing=missing, needs_reply=missing > 0
        )
        return earlier if claim.is_claimed else None

    def _event(self, claim: Claim, packet: Packet, found: Urb) -> Event:
        data, frame = found.data, found.frame
        self._account.headers += len(packet.data) - len(data)
        route = self._route(found.device, found.is_from_host, packet)
        if not is_frame_size(frame_size(data)):
            self._account.skipped += len(data)
            reason = (
                f"the report has no frame: its length field is {frame_size(data) - LENGTH_FIELD}, but the range is"
                f" {MIN_LENGTH} to {MAX_LENGTH}"
            )
            return Skipped(data, 0, reason, packet.number, packet.time_ns, route)
        self._account.frames += len(frame)
        self._account.padding += len(data) - len(frame)
        if found.device not in self._conversations:
            self._conversations.add(found.device, self._context.conversation())
        conversation = self._conversations[found.device]
        if _is_overwritten(found):
            return conversation.overwritten(frame, (packet.number,), packet.time_ns, route)
        record = conversation.record(frame, (packet.number,), packet.time_ns, route)
        if packet.missing:
            record.missing = missing_of(frame)
        claim.count((record,))
        return record


def _is_overwritten(found: Urb) -> bool:
    """Returns whether a reply has the request written over its start: it is from the device, with a command's type."""
    frame = found.frame
    member = MESSAGE_TYPES.get(frame[HEADER_SIZE - 1]) if len(frame) > HEADER_SIZE else None
    if member is None or found.is_from_host:
        return False
    return member.kind == "system-command" and frame[HEADER_SIZE] in _BOOTLOADER

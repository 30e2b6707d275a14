"""Targets select a brick: `wifi:192.0.2.10`, `usb`, `bluetooth:00:16:53:42:2B:99`, `serial:/dev/rfcomm0`, `virtual`."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from enum import StrEnum

from ev3proto.errors import near_misses
from ev3proto.tables.carriers import DEFAULT_CARRIER, Carrier
from ev3proto.tables.discovery import TCP_PORT

TARGET_VARIABLE = "EV3PROTO_TARGET"
"""Environment variable that names the brick for every program, and overrides the program's own choice."""

_PORT_NAME = re.compile(r"/|COM\d+$|cu\.|tty", re.IGNORECASE)
_SERIAL_NUMBER = re.compile(r"(?:[0-9a-f]{2}[:-]?){5}[0-9a-f]{2}", re.IGNORECASE)
_MOST_PORT = 65535


class Way(StrEnum):
    """How a brick is reached."""

    WIFI = "wifi"
    USB = "usb"
    BLUETOOTH = "bluetooth"
    SERIAL = "serial"
    VIRTUAL = "virtual"


_EXAMPLES = {Way.BLUETOOTH: "bluetooth:00:16:53:42:2B:99", Way.SERIAL: "serial:/dev/rfcomm0"}
"""Targets of the ways on which the brick has to be named."""

_CARRIERS = {Way.USB: Carrier.USB, Way.BLUETOOTH: Carrier.BLUETOOTH, Way.SERIAL: Carrier.BLUETOOTH}


@dataclass(frozen=True, slots=True)
class Target:
    """A brick and the way to it."""

    way: Way  # how it is reached
    # WiFi: address or serial number, None for the first brick whose beacon arrives. USB: serial number, None for the
    # only brick. Bluetooth: MAC address. Serial: the port. Virtual: the folder of its files, None for no files.
    host: str | None = None
    port: int | None = None  # WiFi: the TCP port, None for the usual one
    is_bare: bool = False  # Virtual: whether nothing is plugged in, instead of LEGO's core set

    def __str__(self) -> str:
        host = f"[{self.host}]" if self.port is not None and ":" in (self.host or "") else self.host
        return ":".join(str(part) for part in (self.way, host, self.port) if part is not None)

    @property
    def carrier(self) -> Carrier:
        """What carries the frames, as captures call it."""
        return _CARRIERS.get(self.way, DEFAULT_CARRIER)

    @property
    def serial_number(self) -> str | None:
        """The host as a serial number in the brick's own form, 12 lower-case hex digits; None for any other host."""
        if self.host is None or not _SERIAL_NUMBER.fullmatch(self.host):
            return None
        return re.sub("[:-]", "", self.host).lower()

    @classmethod
    def parse(cls, text: str) -> Target:
        """Reads a target as on the command line, such as `wifi:HOST:PORT` or `usb:SERIAL`. Raises ValueError."""
        name, _, rest = text.partition(":")
        if name.lower() not in set(Way):
            hint = near_misses(name, [each.upper() for each in Way]).lower() or (
                "; expected wifi, wifi:ADDRESS, wifi:ADDRESS:PORT, usb, usb:SERIALNUMBER, bluetooth:MAC, serial:PORT or"
                " virtual"
            )
            raise ValueError(f"unknown target {text!r}{hint}")
        way = Way(name.lower())
        if way is Way.WIFI:
            return cls(way, *_address(rest, text))
        if way in _EXAMPLES and not rest:
            raise ValueError(f"{text!r} does not name a brick; expected its address, such as {_EXAMPLES[way]}")
        return cls(Way.SERIAL if way is Way.BLUETOOTH and is_port_name(rest) else way, rest or None)


def is_port_name(host: str) -> bool:
    """Returns whether a host names a serial port such as `/dev/rfcomm0` or `COM5`, not a MAC address."""
    return _SERIAL_NUMBER.fullmatch(host) is None and _PORT_NAME.match(host) is not None


def target_from_environment() -> Target | None:
    """Returns the brick that EV3PROTO_TARGET names; None if it is not set. Raises ValueError."""
    text = os.environ.get(TARGET_VARIABLE)
    if not text:
        return None
    try:
        return Target.parse(text)
    except ValueError as error:
        raise ValueError(f"{TARGET_VARIABLE}: {error}") from None


def _address(rest: str, text: str) -> tuple[str | None, int | None]:
    """Returns host and port of `192.0.2.10:5555`, `[::1]:5555`, `00:16:53:42:2B:99`. Raises ValueError."""
    if not rest:
        return None, None
    if _SERIAL_NUMBER.fullmatch(rest):
        return rest, None
    found = re.fullmatch(r"(?:\[([^\]]+)\]|([^:]+))(?::(\d+))?", rest)
    if found is None:
        if rest.count(":") > 1:
            return rest, None  # an IPv6 address without brackets
        raise ValueError(f"invalid port in {text!r}; expected a number, such as {TCP_PORT}")
    port = None if found[3] is None else int(found[3])
    if port is not None and not 1 <= port <= _MOST_PORT:
        raise ValueError(f"invalid port {port} in {text!r}; expected 1 to {_MOST_PORT}")
    return found[1] or found[2], port


_WAYS = {"wifi": Way.WIFI, "usb": Way.USB, "bluetooth": Way.BLUETOOTH}


def chosen_target(
    protocol: str | None, host: str | None, address: tuple[str, int] | None, target: str | Target | None
) -> Target:
    """Returns the brick that a program names; EV3PROTO_TARGET overrides it. Raises ValueError."""
    overriding = target_from_environment()
    if overriding is not None:
        return overriding
    if target is not None:
        if protocol is not None or host is not None or address is not None:
            raise ValueError("target says which brick: protocol, host and address must be omitted with it")
        return target if isinstance(target, Target) else Target.parse(target)
    if protocol is None:
        raise ValueError(
            f"no brick is named; give protocol (WIFI, BLUETOOTH or USB), ev3_obj, or target, or set {TARGET_VARIABLE}"
        )
    return _of_protocol(protocol, host, address)


def _of_protocol(protocol: str, host: str | None, address: tuple[str, int] | None) -> Target:
    """Returns the brick that the arguments of the lesson name. Raises ValueError."""
    way = _WAYS.get(protocol.lower()) if isinstance(protocol, str) else None
    if way is None:
        raise ValueError(f"protocol must be WIFI, BLUETOOTH or USB, not {protocol!r:.60}")
    if address is not None:
        if way is not Way.WIFI:
            raise ValueError("address is for WIFI: USB and BLUETOOTH take host")
        return Target(way, address[0], address[1])
    if way is Way.BLUETOOTH and host is None:
        raise ValueError("with BLUETOOTH, host must be the brick's MAC address or the serial port of the connection")
    if way is Way.BLUETOOTH and host is not None and is_port_name(host):
        return Target(Way.SERIAL, host)
    return Target(way, host)

"""A serial port, which the operating system provides for a Bluetooth connection. It needs pyserial."""

from __future__ import annotations

import errno
import os
from typing import TYPE_CHECKING

from ev3proto.extras import install_command
from ev3proto.link.carriers.wire import SEND_TIMEOUT
from ev3proto.link.errors import ConnectionLostError, LinkError, NoBrickError, PortInUseError
from ev3proto.link.targets import Target
from ev3proto.tables.carriers import Carrier

if TYPE_CHECKING:
    import serial

_TURN = 0.1
"""Seconds after which a read without data checks whether the port was closed."""


class SerialWire:
    """An open port; `Wire` documents its methods."""

    def __init__(self, port: serial.Serial) -> None:
        """Takes over an open port."""
        self.carrier = Carrier.BLUETOOTH
        self.label = f"the brick at {port.name}"
        self._port = port

    def send(self, frame: bytes) -> None:
        """Sends one whole frame. Raises ConnectionLostError."""
        import serial  # an extra

        try:
            self._port.write(frame)
        except serial.SerialTimeoutException:
            raise ConnectionLostError(f"{self.label} has accepted no data for {SEND_TIMEOUT:g} s; restart it") from None
        except (OSError, TypeError) as error:
            raise self._gone(error) from None

    def receive(self, timeout: float) -> bytes:  # noqa: ARG002 - the port has its own, changing it takes long
        """Waits for bytes, for a tenth of a second at most. Raises ConnectionLostError."""
        try:
            return self._port.read(max(1, self._port.in_waiting))
        except (OSError, TypeError) as error:
            raise self._gone(error) from None

    def stop(self) -> None:
        """Does nothing: `receive` returns soon enough."""

    def close(self) -> None:
        """Ends the connection. A second call does nothing."""
        self._port.close()

    def _gone(self, error: Exception) -> ConnectionLostError:
        # pyserial raises TypeError if another thread has closed the port.
        number = _number(error)
        reason = "it was closed" if number is None else os.strerror(number)
        return ConnectionLostError(f"the connection to {self.label} was lost ({reason}); connect again")


def open_serial(target: Target) -> SerialWire:
    """Opens the serial port to a brick. Raises LinkError, also if pyserial is not installed."""
    try:
        import serial  # an extra
    except ImportError:
        raise LinkError(
            f"a serial port needs the package pyserial, which is not installed: {install_command('serial')}"
        ) from None
    try:
        port = serial.Serial(target.host, timeout=_TURN, write_timeout=SEND_TIMEOUT, exclusive=True)
    except (OSError, ValueError) as error:
        raise _why(error, str(target.host)) from None
    return SerialWire(port)


def _number(error: BaseException | None) -> int | None:
    """Returns the system's error number, which pyserial often has only in its text or in the error it caught."""
    while error is not None:
        number = error.args[0] if error.args else None
        if isinstance(number, int):
            return number
        error = error.__context__
    return None


def _why(error: Exception, name: str) -> LinkError:
    code = _number(error)
    if code == errno.ENOENT:
        return NoBrickError(
            f"no such serial port: {name}; pair the brick with this computer first (on Linux, `rfcomm bind 0 MAC` then"
            " creates /dev/rfcomm0)"
        )
    if code in (errno.EACCES, errno.EPERM):
        return NoBrickError(
            f"no permission to open {name}; join the group that owns it (on Linux `sudo usermod -aG dialout $USER`,"
            " then log in again). On Windows, another program may have it open"
        )
    if code in (errno.EBUSY, errno.EAGAIN):
        return PortInUseError(f"another program has {name} open; end it, then try again")
    if code in (errno.ENOTTY, errno.EISDIR):
        return NoBrickError(f"{name} is not a serial port; give the brick's, such as /dev/rfcomm0 or COM5")
    if code == errno.EHOSTDOWN:
        return NoBrickError(f"the brick at {name} does not answer; is it on and near, and is its Bluetooth on?")
    reason = "no port has this name, or it is in use" if code is None else os.strerror(code)
    return NoBrickError(f"{name} cannot be opened: {reason}")

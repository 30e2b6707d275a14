"""Bluetooth: the traffic between host and controller, and the serial ports in it."""

from ev3proto.capture.carriers.bluetooth.serial_ports import SerialPorts as Reader

__all__ = ["Reader"]

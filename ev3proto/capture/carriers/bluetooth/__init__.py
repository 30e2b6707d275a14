"""Bluetooth: what adapters exchange with their controllers, and the serial ports in it that carry frames."""

from ev3proto.capture.carriers.bluetooth.serial_ports import SerialPorts as Reader

__all__ = ["Reader"]

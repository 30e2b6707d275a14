"""TST: tests the hardware, as the factory does; all fail before TST_OPEN.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Elements, Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "tst_accu_switch",
    "tst_boot_mode2",
    "tst_close",
    "tst_close_mode2",
    "tst_disable_uart",
    "tst_enable_uart",
    "tst_open",
    "tst_poll_mode2",
    "tst_ram_check",
    "tst_read_adc",
    "tst_read_pins",
    "tst_read_uart",
    "tst_write_pins",
    "tst_write_uart",
]

_OPERATIONS = drafts("official")


def tst_open(*, unchecked: bool = False) -> Draft:
    """Allows test commands for 10 seconds; each one restarts the timer."""
    return _OPERATIONS["TST.TST_OPEN"].draft((), unchecked)


def tst_close(*, unchecked: bool = False) -> Draft:
    """Ends the test mode."""
    return _OPERATIONS["TST.TST_CLOSE"].draft((), unchecked)


def tst_read_pins(port: Number, length: Number, string: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the pins of a connector.

    Args:
        port: Connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D; 0 to 19; DATA8.
        length: Number of pins to read, usually 5; DATA8.
        string: One character per pin: 0 low, 1 high; as many values as LENGTH says; DATA8; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_READ_PINS"].draft((port, length, string), unchecked)


def tst_write_pins(port: Number, length: Number, string: Elements, *, unchecked: bool = False) -> Draft:
    """Sets the pins of a connector.

    Args:
        port: Connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D; 0 to 19; DATA8.
        length: Number of pins to set, usually 5; DATA8.
        string: One character per pin: 0 low, 1 high, X floating, - unchanged; as many values as LENGTH says; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_WRITE_PINS"].draft((port, length, string), unchecked)


def tst_read_adc(index: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the analog converter.

    Args:
        index: Channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports; 0 to 15; 12: battery
            temperature; 13: motor current; 14: battery current; 15: battery voltage; DATA8.
        value: Raw reading; 0 to 4095 counts; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_READ_ADC"].draft((index, value), unchecked)


def tst_write_uart(port: Number, length: Number, string: Elements, *, unchecked: bool = False) -> Draft:
    """Sends bytes on a sensor port's serial line.

    Args:
        port: Sensor port minus one; 0 to 3; DATA8.
        length: Number of bytes to send; 0 to 63 bytes; DATA8.
        string: The bytes; as many values as LENGTH says; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_WRITE_UART"].draft((port, length, string), unchecked)


def tst_read_uart(port: Number, length: Number, string: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the bytes received on a sensor port's serial line.

    Args:
        port: Sensor port minus one; 0 to 3; DATA8.
        length: Number of bytes to read; 0 to 63 bytes; DATA8.
        string: The bytes, padded with zeros; as many values as LENGTH says; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_READ_UART"].draft((port, length, string), unchecked)


def tst_enable_uart(bitrate: Number, *, unchecked: bool = False) -> Draft:
    """Switches the serial lines of all sensor ports on.

    Args:
        bitrate: Speed of the line; 2400 to 115200 bit/s; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_ENABLE_UART"].draft((bitrate,), unchecked)


def tst_disable_uart(*, unchecked: bool = False) -> Draft:
    """Switches the serial lines of all sensor ports off."""
    return _OPERATIONS["TST.TST_DISABLE_UART"].draft((), unchecked)


def tst_accu_switch(active: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the switch that senses the rechargeable battery.

    Args:
        active: State of the switch; 0 to 1; 0: other batteries; 1: rechargeable battery; DATA8; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_ACCU_SWITCH"].draft((active,), unchecked)


def tst_boot_mode2(*, unchecked: bool = False) -> Draft:
    """Starts Bluetooth mode 2, for Apple devices."""
    return _OPERATIONS["TST.TST_BOOT_MODE2"].draft((), unchecked)


def tst_poll_mode2(status: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks for the state of the start of Bluetooth mode 2.

    Args:
        status: OK, BUSY (still starting) or FAIL; 0 to 2; a member of RESULT; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_POLL_MODE2"].draft((status,), unchecked)


def tst_close_mode2(*, unchecked: bool = False) -> Draft:
    """Ends Bluetooth mode 2."""
    return _OPERATIONS["TST.TST_CLOSE_MODE2"].draft((), unchecked)


def tst_ram_check(status: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks for the result of the memory test at power-on.

    Args:
        status: OK or FAIL; 0 to 2; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TST.TST_RAM_CHECK"].draft((status,), unchecked)

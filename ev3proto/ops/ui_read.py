"""UI_READ: reads the state of the brick or what the terminal received.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyDEL, Number, Output, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "get_address",
    "get_code",
    "get_event",
    "get_fw_build",
    "get_fw_vers",
    "get_hw_vers",
    "get_ibatt",
    "get_iint",
    "get_imotor",
    "get_ip",
    "get_lbatt",
    "get_os_build",
    "get_os_vers",
    "get_power",
    "get_sdcard",
    "get_shutdown",
    "get_string",
    "get_tbatt",
    "get_usbstick",
    "get_vbatt",
    "get_version",
    "get_warning",
    "key",
    "textbox_read",
]

_OPERATIONS = drafts("official")


def get_vbatt(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the battery voltage.

    Args:
        value: Voltage; V; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_VBATT"].draft((value,), unchecked)


def get_ibatt(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the battery current.

    Args:
        value: Current; A; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_IBATT"].draft((value,), unchecked)


def get_os_vers(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads name and version of the operating system.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: System and kernel release, such as Linux 2.6.33-rc4; as many bytes as LENGTH says; string; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_OS_VERS"].draft((length, destination), unchecked)


def get_event(event: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads and clears the pending event (used by the brick's own menus).

    Args:
        event: What happened; 0: nothing; 1: Bluetooth asks for a PIN; 2: Bluetooth asks to confirm a connection; DATA8;
            an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_EVENT"].draft((event,), unchecked)


def get_tbatt(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the rise in battery temperature, estimated from the current.

    Args:
        value: Estimated rise in temperature; °C; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_TBATT"].draft((value,), unchecked)


def get_iint(iint: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the battery current smoothed over time.

    Args:
        iint: Integrated current; A; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_IINT"].draft((iint,), unchecked)


def get_imotor(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the current of all motors together.

    Args:
        value: Current; A; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_IMOTOR"].draft((value,), unchecked)


def get_string(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Waits for a line typed at the terminal and reads it.

    Args:
        length: Maximum number of bytes to return, not including the zero; 0 to 127 bytes; DATA8.
        destination: The line; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_STRING"].draft((length, destination), unchecked)


def get_hw_vers(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the hardware version.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: Hardware version, such as V0.60; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_HW_VERS"].draft((length, destination), unchecked)


def get_fw_vers(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the firmware version.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: Firmware version, such as V1.04H; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_FW_VERS"].draft((length, destination), unchecked)


def get_fw_build(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the build time of the firmware.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: Build time as yymmddhhmm; as many bytes as LENGTH says; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_FW_BUILD"].draft((length, destination), unchecked)


def get_os_build(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the build time of the operating system.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: Build time as yymmddhhmm; as many bytes as LENGTH says; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_OS_BUILD"].draft((length, destination), unchecked)


def get_address(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Waits for a decimal number typed at the terminal and reads it (debugging).

    Args:
        value: The number, meant as an address; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_ADDRESS"].draft((value,), unchecked)


def get_code(
    length: Number,
    image: Number,
    global_: Output = None,
    flag: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Waits for byte code typed as hex at the terminal and builds a program from it (debugging).

    Args:
        length: Maximum number of bytes of the program, including headers; bytes; DATA32.
        image: Address of the memory where the program is built; DATA32.
        global_: Address of the program's global variables; DATA32; an output, in global memory when omitted.
        flag: Whether the program can be started; 1 or unchanged; 1: ready; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_CODE"].draft((length, image, global_, flag), unchecked)


def key(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one key from the terminal without waiting.

    Args:
        value: Character code of the key; 0: no key; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.KEY"].draft((value,), unchecked)


def get_shutdown(flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads and clears the request to shut down (used by the brick's own menus).

    Args:
        flag: Whether the brick wants to shut down; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_SHUTDOWN"].draft((flag,), unchecked)


def get_warning(warnings: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the brick's warnings.

    Args:
        warnings: One bit for each warning; 0: none; a member of WARNING; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_WARNING"].draft((warnings,), unchecked)


def get_lbatt(pct: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the battery level, derived from its voltage.

    Args:
        pct: Battery level; 0 to 100 %; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_LBATT"].draft((pct,), unchecked)


def textbox_read(
    text: Text,
    size: Number,
    del_: AnyDEL,
    length: Number,
    line: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads one line of the text of a text box.

    Args:
        text: Whole text of the box, its lines separated by DEL; string.
        size: Size of the box's text buffer, including the zero; bytes; DATA32.
        del_: What separates the lines; a member of DEL; DATA8.
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        line: Which line, counted from 1; DATA16.
        destination: The line, empty if there is no such line; as many bytes as LENGTH says; string; an output, in
            global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.TEXTBOX_READ"].draft((text, size, del_, length, line, destination), unchecked)


def get_version(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads name, version and build date of the firmware in one string.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: Such as LMS2012 V1.04H(Jul 26 2013 12:00:00); as many bytes as LENGTH says; string; an output, in
            global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_VERSION"].draft((length, destination), unchecked)


def get_ip(length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the brick's IP address.

    Args:
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; -1: no limit; DATA8.
        destination: Address in dotted notation; as many bytes as LENGTH says; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_IP"].draft((length, destination), unchecked)


def get_power(
    vbatt: Output = None,
    ibatt: Output = None,
    iint: Output = None,
    imotor: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads all values of the power supply at once.

    Args:
        vbatt: Battery voltage; V; DATAF; an output, in global memory when omitted.
        ibatt: Battery current; A; DATAF; an output, in global memory when omitted.
        iint: Battery current smoothed over time; A; DATAF; an output, in global memory when omitted.
        imotor: Current of all motors together; A; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_POWER"].draft((vbatt, ibatt, iint, imotor), unchecked)


def get_sdcard(state: Output = None, total: Output = None, free: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads whether an SD card is present, and its space.

    Args:
        state: Whether one is present; 0 to 1; 0: absent; 1: present; DATA8; an output, in global memory when omitted.
        total: Size; KiB; DATA32; an output, in global memory when omitted.
        free: Free space; KiB; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_SDCARD"].draft((state, total, free), unchecked)


def get_usbstick(state: Output = None, total: Output = None, free: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads whether a USB stick is present, and its space.

    Args:
        state: Whether one is present; 0 to 1; 0: absent; 1: present; DATA8; an output, in global memory when omitted.
        total: Size; KiB; DATA32; an output, in global memory when omitted.
        free: Free space; KiB; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_READ.GET_USBSTICK"].draft((state, total, free), unchecked)

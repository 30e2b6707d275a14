"""COM_GET: asks about the brick's connections and the devices around it.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyHWTYPE, Number, Output, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "connec_item",
    "connec_items",
    "favour_item",
    "favour_items",
    "get_brickname",
    "get_encrypt",
    "get_id",
    "get_incoming",
    "get_mode2",
    "get_network",
    "get_on_off",
    "get_pin",
    "get_present",
    "get_result",
    "get_visible",
    "search_item",
    "search_items",
]

_OPERATIONS = drafts("official")


def get_on_off(hardware: AnyHWTYPE, active: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether Bluetooth or WiFi is on.

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        active: Whether it is on; 0 to 1; 0: off; 1: on; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_ON_OFF"].draft((hardware, active), unchecked)


def get_visible(hardware: AnyHWTYPE, visible: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether other devices can see the brick by Bluetooth.

    Args:
        hardware: Carrier to use; 1 to 3; a member of HWTYPE; DATA8.
        visible: Whether it is visible; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_VISIBLE"].draft((hardware, visible), unchecked)


def get_result(hardware: AnyHWTYPE, item: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports the state of a search or connection request.

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        item: Place in the list, ignored by the firmware; DATA8.
        result: State of the request; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_RESULT"].draft((hardware, item, result), unchecked)


def get_pin(
    hardware: AnyHWTYPE,
    name: Text,
    length: Number,
    pincode: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads the PIN for a device, always 1234.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        name: Name of the other device or network; string.
        length: Size of the PIN's buffer, including the zero; bytes; DATA8.
        pincode: The PIN; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_PIN"].draft((hardware, name, length, pincode), unchecked)


def search_items(hardware: AnyHWTYPE, items: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the devices or networks that a search found.

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        items: Number of entries in the list; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.SEARCH_ITEMS"].draft((hardware, items), unchecked)


def search_item(
    hardware: AnyHWTYPE,
    item: Number,
    length: Number,
    name: Output = None,
    paired: Output = None,
    connected: Output = None,
    type: Output = None,
    visible: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Describes one device or network that a search found.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        item: Place in the list, counted from 0; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        name: Name of the other device or network; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        paired: Whether it is paired (Bluetooth) or known (WiFi); 0 to 1; 0: no; 1: yes; DATA8; an output, in global
            memory when omitted.
        connected: Whether it is connected; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        type: Kind of device (Bluetooth) or encryption (WiFi); 0: WiFi, not encrypted; 1: WiFi, WPA2; a member of
            BTTYPE; DATA8; an output, in global memory when omitted.
        visible: Whether it is in range; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.SEARCH_ITEM"].draft(
        (hardware, item, length, name, paired, connected, type, visible), unchecked
    )


def favour_items(hardware: AnyHWTYPE, items: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the paired devices, in range or not.

    Args:
        hardware: Carrier to use; 2 to 2; a member of HWTYPE; DATA8.
        items: Number of entries in the list; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.FAVOUR_ITEMS"].draft((hardware, items), unchecked)


def favour_item(
    hardware: AnyHWTYPE,
    item: Number,
    length: Number,
    name: Output = None,
    paired: Output = None,
    connected: Output = None,
    type: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Describes one paired device or known network.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        item: Place in the list, counted from 0; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        name: Name of the other device or network; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        paired: Whether it is paired (Bluetooth) or known (WiFi); 0 to 1; 0: no; 1: yes; DATA8; an output, in global
            memory when omitted.
        connected: Whether it is connected; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        type: Kind of device (Bluetooth) or encryption (WiFi); 0: WiFi, not encrypted; 1: WiFi, WPA2; a member of
            BTTYPE; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.FAVOUR_ITEM"].draft((hardware, item, length, name, paired, connected, type), unchecked)


def get_id(hardware: AnyHWTYPE, length: Number, string: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the brick's Bluetooth address.

    Args:
        hardware: Carrier to use; 2 to 2; a member of HWTYPE; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        string: 12 hex digits; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_ID"].draft((hardware, length, string), unchecked)


def get_brickname(length: Number, name: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the brick's name.

    Args:
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        name: Name of the brick; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_BRICKNAME"].draft((length, name), unchecked)


def get_network(
    hardware: AnyHWTYPE,
    length: Number,
    name: Output = None,
    mac: Output = None,
    ip: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads network name and addresses, WiFi only.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        length: Buffer size for each of the three texts, including the zero; bytes; -1: unlimited (handles only); DATA8.
        name: Name of the network, NONE without one; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        mac: MAC address of the brick, ?? when WiFi is off; at most 17 characters; as many bytes as LENGTH says; string;
            an output, in global memory when omitted.
        ip: IP address of the brick, ?? when not connected; at most 15 characters; as many bytes as LENGTH says; string;
            an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_NETWORK"].draft((hardware, length, name, mac, ip), unchecked)


def get_present(hardware: AnyHWTYPE, ok: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether the hardware is present (for WiFi: a known dongle).

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        ok: Whether it is present; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_PRESENT"].draft((hardware, ok), unchecked)


def get_encrypt(hardware: AnyHWTYPE, item: Number, type: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports the encryption of a network, WiFi only.

    Args:
        hardware: Carrier to use; 3 to 3; a member of HWTYPE; DATA8.
        item: Place in the list, counted from 0; DATA8.
        type: Kind of encryption; always none in the 2013 firmware; a member of ENCRYPT; DATA8; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_ENCRYPT"].draft((hardware, item, type), unchecked)


def connec_items(hardware: AnyHWTYPE, items: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the connected devices, Bluetooth only.

    Args:
        hardware: Carrier to use; 1 to 3; a member of HWTYPE; DATA8.
        items: Number of entries in the list; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.CONNEC_ITEMS"].draft((hardware, items), unchecked)


def connec_item(
    hardware: AnyHWTYPE,
    item: Number,
    length: Number,
    name: Output = None,
    type: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Describes one connected device, Bluetooth only.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        item: Place in the list, counted from 0; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        name: Name of the device; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        type: Kind of device; a member of BTTYPE; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.CONNEC_ITEM"].draft((hardware, item, length, name, type), unchecked)


def get_incoming(
    hardware: AnyHWTYPE,
    length: Number,
    name: Output = None,
    type: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reports which device asks for a connection, Bluetooth only.

    Args:
        hardware: Carrier to use; 2 to 2; a member of HWTYPE; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        name: Name of the device; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        type: Kind of device; a member of BTTYPE; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_INCOMING"].draft((hardware, length, name, type), unchecked)


def get_mode2(hardware: AnyHWTYPE, active: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether Bluetooth is in its mode for Apple devices.

    Args:
        hardware: Carrier to use; 2 to 2; a member of HWTYPE; DATA8.
        active: Whether it is on; 0 to 1; 0: off; 1: on; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.GET_MODE2"].draft((hardware, active), unchecked)

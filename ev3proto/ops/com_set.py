"""COM_SET: changes the brick's name, its connections and its lists of devices.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyENCRYPT, AnyHWTYPE, Number, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "set_brickname",
    "set_connection",
    "set_encrypt",
    "set_mode2",
    "set_movedown",
    "set_moveup",
    "set_on_off",
    "set_passkey",
    "set_pin",
    "set_search",
    "set_ssid",
    "set_visible",
]

_OPERATIONS = drafts("official")


def set_on_off(hardware: AnyHWTYPE, active: Number, *, unchecked: bool = False) -> Draft:
    """Switches Bluetooth or WiFi on or off.

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        active: Whether to switch it on; 0 to 1; 0: off; 1: on; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_ON_OFF"].draft((hardware, active), unchecked)


def set_visible(hardware: AnyHWTYPE, visible: Number, *, unchecked: bool = False) -> Draft:
    """Makes the brick visible or invisible, Bluetooth only.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        visible: Whether other devices can see it; 0 to 1; 0: invisible; 1: visible; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_VISIBLE"].draft((hardware, visible), unchecked)


def set_search(hardware: AnyHWTYPE, search: Number, *, unchecked: bool = False) -> Draft:
    """Starts or stops the search for devices or networks.

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        search: Whether to search; 0 to 1; 0: stop (Bluetooth only); 1: start; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_SEARCH"].draft((hardware, search), unchecked)


def set_pin(hardware: AnyHWTYPE, name: Text, pincode: Text, *, unchecked: bool = False) -> Draft:
    """Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi).

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        name: Name of the other device or network; string.
        pincode: PIN or password; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_PIN"].draft((hardware, name, pincode), unchecked)


def set_passkey(hardware: AnyHWTYPE, accept: Number, *, unchecked: bool = False) -> Draft:
    """Answers the request to confirm a passkey, Bluetooth only.

    Args:
        hardware: Carrier to use; 2 to 2; a member of HWTYPE; DATA8.
        accept: The answer; 0 to 1; 0: reject; 1: accept; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_PASSKEY"].draft((hardware, accept), unchecked)


def set_connection(hardware: AnyHWTYPE, name: Text, connection: Number, *, unchecked: bool = False) -> Draft:
    """Connects a device or network, or ends a Bluetooth connection.

    Args:
        hardware: Carrier to use; 2 to 3; a member of HWTYPE; DATA8.
        name: Name of the other device or network; string.
        connection: What to do; 0 to 1; 0: disconnect; 1: connect; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_CONNECTION"].draft((hardware, name, connection), unchecked)


def set_brickname(name: Text, *, unchecked: bool = False) -> Draft:
    """Renames the brick.

    Args:
        name: New name, at most 118 characters, else refused; at most 118 characters; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_BRICKNAME"].draft((name,), unchecked)


def set_moveup(hardware: AnyHWTYPE, item: Number, *, unchecked: bool = False) -> Draft:
    """Moves a network up in the list, WiFi only.

    Args:
        hardware: Carrier to use; 3 to 3; a member of HWTYPE; DATA8.
        item: Place in the list, counted from 0; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_MOVEUP"].draft((hardware, item), unchecked)


def set_movedown(hardware: AnyHWTYPE, item: Number, *, unchecked: bool = False) -> Draft:
    """Moves a network down in the list, WiFi only.

    Args:
        hardware: Carrier to use; 3 to 3; a member of HWTYPE; DATA8.
        item: Place in the list, counted from 0; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_MOVEDOWN"].draft((hardware, item), unchecked)


def set_encrypt(hardware: AnyHWTYPE, item: Text, encrypt: AnyENCRYPT, *, unchecked: bool = False) -> Draft:
    """Sets the encryption of a network, WiFi only.

    Args:
        hardware: Carrier to use; 3 to 3; a member of HWTYPE; DATA8.
        item: Name of the network; string.
        encrypt: Kind of encryption; a member of ENCRYPT; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_ENCRYPT"].draft((hardware, item, encrypt), unchecked)


def set_ssid(hardware: AnyHWTYPE, name: Text, *, unchecked: bool = False) -> Draft:
    """Adds a network to the end of the list, WiFi only.

    Args:
        hardware: Carrier to use; 3 to 3; a member of HWTYPE; DATA8.
        name: Name of the network; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_SSID"].draft((hardware, name), unchecked)


def set_mode2(hardware: AnyHWTYPE, active: Number, *, unchecked: bool = False) -> Draft:
    """Switches the Bluetooth mode for Apple devices on or off.

    Args:
        hardware: Carrier to use; 2 to 2; a member of HWTYPE; DATA8.
        active: Whether to switch it on; 0 to 1; 0: off; 1: on; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_SET.SET_MODE2"].draft((hardware, active), unchecked)

"""INFO: reads and sets the error log, the volume and the time to power off.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["errortext", "get_error", "get_minutes", "get_volume", "set_error", "set_minutes", "set_volume"]

_OPERATIONS = drafts("official")


def set_error(number: Number, *, unchecked: bool = False) -> Draft:
    """Adds an error to the brick's error log.

    Args:
        number: Number of the error; 0: nothing is logged; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.SET_ERROR"].draft((number,), unchecked)


def get_error(number: Output = None, *, unchecked: bool = False) -> Draft:
    """Removes and returns the oldest error of the brick's error log.

    Args:
        number: Number of the error; 0: the log is empty; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.GET_ERROR"].draft((number,), unchecked)


def errortext(number: Number, length: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts the number of an error to its name.

    Args:
        number: Number of the error; 0: gives an empty text; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: no limit; DATA8.
        destination: Name of the error, at most 31 characters; as many bytes as LENGTH says; string; an output, in
            global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.ERRORTEXT"].draft((number, length, destination), unchecked)


def get_volume(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the volume setting.

    Args:
        value: Volume; 0 to 100 %; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.GET_VOLUME"].draft((value,), unchecked)


def set_volume(value: Number, *, unchecked: bool = False) -> Draft:
    """Changes the volume setting.

    Args:
        value: Volume; 0 to 100 %; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.SET_VOLUME"].draft((value,), unchecked)


def get_minutes(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the idle time after which the brick powers off.

    Args:
        value: Idle time; 0 to 120 min; 0: never; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.GET_MINUTES"].draft((value,), unchecked)


def set_minutes(value: Number, *, unchecked: bool = False) -> Draft:
    """Changes the idle time after which the brick powers off.

    Args:
        value: Idle time; 0 to 120 min; 0: never; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INFO.SET_MINUTES"].draft((value,), unchecked)

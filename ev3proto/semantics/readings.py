"""What the readings of devices mean: the name and unit of each value, where type and mode of the command tell them."""

from __future__ import annotations

from collections.abc import Sequence

from ev3proto.messages import Argument
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import READINGS, Role
from ev3proto.tables.devices import DEVICE_TYPES, Dataset


def dataset_of(arguments: Sequence[Argument], number: int) -> Dataset | None:
    """Returns what an argument of an operation receives from a device.

    Args:
        arguments: The arguments of the operation.
        number: The argument, from 0.

    Returns:
        Its name and unit; None for any other argument, if type or mode are kept or in a variable, and for a raw value
        that is not in the unit.
    """
    role = arguments[number].parameter.role
    if role not in READINGS or arguments[number].parameter.is_list or arguments[number].form.handle:
        return None
    named = {argument.name: whole_number(argument) for argument in arguments}
    device, mode_number = DEVICE_TYPES.get(named.get("TYPE") or 0), named.get("MODE")
    if device is None or mode_number is None or not 0 <= mode_number < len(device.modes):
        return None
    mode = device.modes[mode_number]
    first = next(at for at, one in enumerate(arguments) if one.parameter.role is role and not one.parameter.is_list)
    if number - first >= len(mode.values) or (role is Role.RAW_READING and mode.raw != mode.si):
        return None
    return mode.values[number - first]

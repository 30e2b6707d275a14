"""What the readings of devices mean: the name and unit of each value, where type and mode of the command tell them."""

from __future__ import annotations

from ev3proto.messages import Operation
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Role
from ev3proto.tables.devices import DEVICE_TYPES, Dataset


def datasets_of(operation: Operation) -> dict[int, Dataset]:
    """Returns what the arguments of an operation receive from a device, by their numbers.

    Returns:
        Name and unit of each; nothing for an operation of another kind, if type or mode are kept or in a variable, and
        for raw values that are not in the unit.
    """
    if not operation.declaration.has_readings:
        return {}
    arguments, fixed = operation.arguments, operation.declaration.fixed
    named = dict(zip((parameter.name for parameter in fixed), map(whole_number, arguments), strict=False))
    device, mode_number = DEVICE_TYPES.get(named.get("TYPE") or 0), named.get("MODE")
    if device is None or mode_number is None or not 0 <= mode_number < len(device.modes):
        return {}
    mode, first = device.modes[mode_number], len(fixed) - (operation.declaration.tail is None)
    if fixed[-1].role is Role.RAW_READING and mode.raw != mode.si:
        return {}
    received = enumerate(zip(arguments[first:], mode.values, strict=False), first)
    return {number: dataset for number, (argument, dataset) in received if not argument.form.handle}

"""The daisy chain: messages between bricks that are joined by USB."""

from enum import IntEnum


class DaisySubCommand(IntEnum):
    """The sub-command after the message type of a daisy message."""

    DOWNSTREAM = 0xA0
    UPSTREAM = 0xA1
    INFO = 0xA2
    UNLOCK_SLAVE = 0xA3
    SET_TYPE = 0xA4
    DOWNSTREAM_WITH_BUSY = 0xA5

    @property
    def carries_operations(self) -> bool:
        """True where the payload is byte code for a brick further down."""
        return self in (DaisySubCommand.DOWNSTREAM, DaisySubCommand.DOWNSTREAM_WITH_BUSY)


TEXTS = {
    DaisySubCommand.DOWNSTREAM: "Forwards operations to a brick further down",
    DaisySubCommand.UPSTREAM: "Passes sensor data up towards the first brick",
    DaisySubCommand.INFO: "Asks which sensors a brick further down has",
    DaisySubCommand.UNLOCK_SLAVE: "Allows the brick below to answer again",
    DaisySubCommand.SET_TYPE: "Sets type and mode of a sensor further down",
    DaisySubCommand.DOWNSTREAM_WITH_BUSY: "Forwards operations, and names the motors to report as busy",
}
"""A one-line description of each sub-command."""

SENSOR_DATA_SIZE = 32
"""Bytes of a sensor's raw data in a layered report."""

MOST_LAYERS = 4
"""Bricks in a chain; senders count their layers from 0 or from 1."""

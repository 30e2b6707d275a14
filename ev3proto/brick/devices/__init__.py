"""The parts beside the machine: display, buttons, motors, ..."""

from __future__ import annotations

from ev3proto.brick.running_programs import Program


class Part:
    """A part on which operations act and which changes with time.

    A part is an attribute of the brick, and listed in its `parts`. While a program
    runs or waits, time advances by a millisecond at most; otherwise it may advance by hours at once.
    """

    def advance(self, microseconds: int) -> None:
        """Advances to a time, in microseconds since the brick was switched on."""

    def program_started(self, program: Program) -> None:
        """Learns that a program was started in a slot. Direct commands are not reported."""

    def program_ended(self, program: Program) -> None:
        """Learns that a program in a slot has ended. Direct commands are not reported."""

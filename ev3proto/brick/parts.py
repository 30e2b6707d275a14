"""What the brick is made of beside its machine: display, buttons, motors, ... and what the machine tells them."""

from __future__ import annotations

from ev3proto.brick.running_programs import Program


class Part:
    """Something on which operations act and which changes with time.

    A part is made by `Brick.__init__`, is an attribute of the brick, and stands in `Brick.parts`. While a program
    runs or waits, time advances by a millisecond at most; otherwise it may advance by hours at once.
    """

    def advance(self, microseconds: int) -> None:
        """Time has passed; `microseconds` is what the clock says now, counted from when the brick was switched on."""

    def program_started(self, program: Program) -> None:
        """A program was started in a slot. Direct commands are not reported."""

    def program_ended(self, program: Program) -> None:
        """A program in a slot has ended. Direct commands are not reported."""

"""A brick's parts besides its machine: clock, files, display, buttons, motors, sensors, ..."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from random import Random

from ev3proto.brick.boxes import Mailboxes
from ev3proto.brick.devices import Part
from ev3proto.brick.devices.buttons import Buttons
from ev3proto.brick.devices.display import Display
from ev3proto.brick.devices.display.screen_dialog import ScreenDialog
from ev3proto.brick.devices.motors import Outputs
from ev3proto.brick.devices.panel import Panel
from ev3proto.brick.devices.sensors import Inputs
from ev3proto.brick.devices.speaker import Sound
from ev3proto.brick.devices.terminal import Terminal
from ev3proto.brick.open_files import RecentFiles
from ev3proto.brick.running_programs import CMD_SLOT, USER_SLOT, Program
from ev3proto.brick.settings import Settings
from ev3proto.brick.storage import Storage


class Equipment:
    """What operations act on: `vm.brick` in their handlers.

    microseconds  the clock, counted from when the brick was switched on
    is_dead       a program has switched it off
    tests_until   the clock's time at which the permission for factory tests ends
    parts         everything that changes with time
    """

    def __init__(self, root: str | Path | None, dialect: str, stop: Callable[[], None]) -> None:
        """Creates what a brick has that was just switched on; `stop` is what the back button does."""
        self.dialect = dialect
        self.microseconds = 0
        self.is_dead = False
        self.tests_until = 0
        self.settings = Settings()
        self.files = Storage(root)
        self.recent = RecentFiles()
        self.mailboxes = Mailboxes()
        self.log_sync = (0, 0)
        self.random = Random()
        self.panel = Panel()
        self.display = Display(self.settings, self.panel.battery)
        self.dialog: ScreenDialog | None = None
        self.buttons = Buttons(stop)
        self.console = Terminal()
        self.sound = Sound()
        self.outputs = Outputs()
        self.inputs = Inputs(self.outputs)
        self.parts: list[Part] = [self.display, self.buttons, self.panel, self.sound, self.outputs, self.inputs]

    def program_started(self, program: Program) -> None:
        """Notifies the parts that a program, not a direct command, has started."""
        for part in self.parts:
            part.program_started(program)

    def program_ended(self, program: Program) -> None:
        """Frees the resources of a program or direct command, and notifies the parts that a program has ended."""
        if program.slot == USER_SLOT:
            self.mailboxes.close_all()
        if program.slot != CMD_SLOT:
            for part in self.parts:
                part.program_ended(program)

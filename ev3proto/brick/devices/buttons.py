"""The six buttons: who holds them down, and the presses that the firmware keeps until a program reads them.

A button is held by hand (`Brick.press`) or by the virtual finger of UI_BUTTON.PRESS. The firmware looks at the
buttons every 10 ms: what an operation presses shows later, or to the next command. A press by hand shows at once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from ev3proto.brick.devices import Part
from ev3proto.brick.running_programs import USER_SLOT, Program
from ev3proto.tables.enumerations import BUTTONTYPE

SAMPLE_PERIOD = 10_000
"""Microseconds between two polls of the buttons."""

REPEAT_AFTER, REPEAT_EVERY = 400_000, 200_000
"""Microseconds that a button is held before it counts as pressed again, and from then on."""

LONG_PRESS = 3_000_000
"""Microseconds after which a press is a long one."""

BUTTONS = {
    name.removesuffix("_BUTTON").lower(): number
    for name, number in BUTTONTYPE.members.items()
    if name not in ("NO_BUTTON", "ANY_BUTTON")
}
"""The buttons' numbers by name: up, enter, down, right, left, back."""

NO_BUTTON, ANY_BUTTON = BUTTONTYPE.members["NO_BUTTON"], BUTTONTYPE.members["ANY_BUTTON"]
_NOT_REPEATED = (BUTTONS["enter"], BUTTONS["back"])


@dataclass
class Button:
    """One button: whether it is down, and its presses that no program has read yet."""

    held: set[str] = field(default_factory=set)  # "hand" and "finger", an operation
    down: bool = False  # as the firmware saw it last
    activated: bool = False  # it was pressed, or held long enough to count once more
    long: bool = False  # it was held for 3 s; set again as long as it is held
    bumped: bool = False  # it was released
    since: int = 0  # when it went down, in microseconds
    counted: int = 0  # repeats of `activated` so far in this press


@dataclass
class _Touch:
    """The effect of an operation on a button, which the firmware has not noticed yet."""

    button: int
    is_press: bool
    program: Program
    due: int


class Buttons(Part):
    """The buttons of a brick."""

    def __init__(self, back_pressed: Callable[[], None]) -> None:
        """Creates released buttons; `back_pressed` is called for the back button unless it is blocked."""
        self.click = False  # a program asked for a press and found one: the brick has to click
        self.back_block = 0  # the value of SET_BACK_BLOCK
        self._buttons = {number: Button() for number in BUTTONS.values()}
        self._touches: list[_Touch] = []
        self._back_pressed = back_pressed

    # Pressing

    def press(self, name: str, microseconds: int) -> None:
        """Presses a button by hand: up, enter, down, right, left or back. ValueError for any other name."""
        self._sample(self._named(name), "hand", True, microseconds)

    def release(self, name: str, microseconds: int) -> None:
        """Releases a button by hand. ValueError for an unknown name."""
        self._sample(self._named(name), "hand", False, microseconds)

    @staticmethod
    def _named(name: str) -> int:
        if name not in BUTTONS:
            raise ValueError(f"unknown button {name!r}; expected one of {', '.join(BUTTONS)}")
        return BUTTONS[name]

    def touch(self, number: int, is_press: bool, program: Program, microseconds: int) -> None:
        """Presses or releases a button for an operation; 0 means none, an unknown number all of them."""
        if number != NO_BUTTON:
            due = (microseconds // SAMPLE_PERIOD + 1) * SAMPLE_PERIOD
            self._touches += [_Touch(button, is_press, program, due) for button in self._meant(number)]

    def _sample(self, number: int, holder: str, is_press: bool, microseconds: int) -> None:
        button = self._buttons[number]
        (button.held.add if is_press else button.held.discard)(holder)
        if bool(button.held) == button.down:
            return
        button.down = not button.down
        if button.down:
            button.activated = True
            button.since, button.counted = microseconds, 0
            if number == BUTTONS["back"] and not self.back_block:
                self._back_pressed()
        else:
            button.bumped = True

    # Time

    def advance(self, microseconds: int) -> None:
        """Polls the buttons."""
        self._settle(microseconds, lambda touch: touch.due <= microseconds)
        for number, button in self._buttons.items():
            if not button.down:
                continue
            held = microseconds - button.since
            if held >= LONG_PRESS:
                button.long = True
            repeats = (held - REPEAT_AFTER) // REPEAT_EVERY + 1 if held >= REPEAT_AFTER else 0
            if repeats > button.counted and number not in _NOT_REPEATED:
                button.counted = repeats
                button.activated = True

    def look(self, program: Program, microseconds: int) -> None:
        """Makes what earlier commands did visible to a program that is about to ask."""
        self._settle(microseconds, lambda touch: touch.program is not program)

    def _settle(self, microseconds: int, is_seen: Callable[[_Touch], bool]) -> None:
        while self._touches and is_seen(self._touches[0]):
            touch = self._touches.pop(0)
            self._sample(touch.button, "finger", touch.is_press, min(touch.due, microseconds))

    def program_started(self, program: Program) -> None:
        """Forgets all presses before a user program."""
        if program.slot == USER_SLOT:
            self.flush()

    def program_ended(self, program: Program) -> None:
        """Forgets the presses and the block that a user program leaves."""
        if program.slot == USER_SLOT:
            self.flush()
            self.back_block = 0

    # Asking

    def _meant(self, number: int) -> list[int]:
        return [number] if number in self._buttons else list(self._buttons)

    def _flag(self, number: int, name: str, forget: bool) -> bool:
        """Returns whether a button, or any, has a flag; for number 0 whether no button has it."""
        found = [button for button in map(self._buttons.__getitem__, self._meant(number)) if getattr(button, name)]
        if forget:
            for button in found:
                setattr(button, name, False)
        return not found if number == NO_BUTTON else bool(found)

    def is_down(self, number: int) -> bool:
        """Returns whether a button, or any, is down now."""
        return number != NO_BUTTON and self._flag(number, "down", False)

    def short_press(self, number: int, forget: bool = True) -> bool:
        """Returns whether a button, or any, was pressed; for 0 whether none was."""
        found = self._flag(number, "activated", forget)
        self.click |= found and forget
        return found

    def long_press(self, number: int, forget: bool = True) -> bool:
        """Returns whether a button, or any, was held for 3 s; for 0 whether none was."""
        found = self._flag(number, "long", forget)
        self.click |= found and forget
        return found

    def bump(self, number: int) -> bool:
        """Returns whether a button, or any, was released; for 0 whether none was."""
        return self._flag(number, "bumped", True)

    def take_click(self) -> bool:
        """Returns whether a press was found since the last call."""
        click, self.click = self.click, False
        return click

    def axis(self, negative: str, positive: str) -> int:
        """Returns which of two buttons was pressed: -1, 1, or 0 for none; the positive one wins. Both are forgotten."""
        result = -1 if self.short_press(BUTTONS[negative]) else 0
        return 1 if self.short_press(BUTTONS[positive]) else result

    def flush(self) -> None:
        """Forgets all presses that no program has read."""
        for button in self._buttons.values():
            button.activated = button.long = button.bumped = False

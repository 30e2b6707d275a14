"""UI_BUTTON: reading the buttons, and pressing them."""

from __future__ import annotations

from ev3proto.brick.devices.buttons import ANY_BUTTON, Buttons
from ev3proto.brick.exits import Busy
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.machine import Machine


def _buttons(vm: Machine) -> Buttons:
    """Returns the buttons as they are when the running program asks."""
    buttons = vm.brick.buttons
    buttons.look(vm.program, vm.microseconds)
    return buttons


computes(
    {
        # PRESS holds a button until RELEASE.
        "UI_BUTTON.PRESS": lambda vm, button: _buttons(vm).touch(button, True, vm.program, vm.microseconds),
        "UI_BUTTON.RELEASE": lambda vm, button: _buttons(vm).touch(button, False, vm.program, vm.microseconds),
        "UI_BUTTON.PRESSED": lambda vm, button: _buttons(vm).is_down(button),
        # Reading a press clears it, except by the TEST commands.
        "UI_BUTTON.SHORTPRESS": lambda vm, button: _buttons(vm).short_press(button),
        "UI_BUTTON.TESTSHORTPRESS": lambda vm, button: _buttons(vm).short_press(button, forget=False),
        "UI_BUTTON.LONGPRESS": lambda vm, button: _buttons(vm).long_press(button),
        "UI_BUTTON.TESTLONGPRESS": lambda vm, button: _buttons(vm).long_press(button, forget=False),
        "UI_BUTTON.GET_BUMBED": lambda vm, button: _buttons(vm).bump(button),
        "UI_BUTTON.FLUSH": lambda vm: _buttons(vm).flush(),
        "UI_BUTTON.GET_HORZ": lambda vm: _buttons(vm).axis("left", "right"),
        "UI_BUTTON.GET_VERT": lambda vm: _buttons(vm).axis("up", "down"),
        # Whether the back button leaves programs alone.
        "UI_BUTTON.SET_BACK_BLOCK": lambda vm, is_blocked: setattr(vm.brick.buttons, "back_block", is_blocked),
        "UI_BUTTON.GET_BACK_BLOCK": lambda vm: vm.brick.buttons.back_block,
        "UI_BUTTON.GET_CLICK": lambda vm: _buttons(vm).take_click(),
    }
)


@handles("UI_BUTTON.WAIT_FOR_PRESS")
def wait_for_press(vm: Machine) -> None:
    """Waits for any button; the press can still be read."""
    if not _buttons(vm).short_press(ANY_BUTTON, forget=False):
        raise Busy

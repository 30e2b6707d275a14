"""UI_BUTTON: what was pressed, and the virtual finger."""

from __future__ import annotations

from ev3proto.brick.devices.buttons import ANY_BUTTON, Buttons
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place


def _buttons(vm: Machine) -> Buttons:
    """The buttons as they are when the running program asks."""
    buttons = vm.brick.buttons
    buttons.look(vm.program, vm.microseconds)
    return buttons


@handles("UI_BUTTON.PRESS")
def press(vm: Machine, button: int) -> None:
    """Presses a button and holds it."""
    _buttons(vm).touch(button, True, vm.program, vm.microseconds)


@handles("UI_BUTTON.RELEASE")
def release(vm: Machine, button: int) -> None:
    """Releases what PRESS holds."""
    _buttons(vm).touch(button, False, vm.program, vm.microseconds)


@handles("UI_BUTTON.PRESSED")
def pressed(vm: Machine, button: int, state: Place) -> None:
    """Whether it is down."""
    state.write8(_buttons(vm).is_down(button))


@handles("UI_BUTTON.SHORTPRESS")
def shortpress(vm: Machine, button: int, state: Place) -> None:
    """Whether it was pressed; forgets it."""
    state.write8(_buttons(vm).short_press(button))


@handles("UI_BUTTON.TESTSHORTPRESS")
def testshortpress(vm: Machine, button: int, state: Place) -> None:
    """Whether it was pressed."""
    state.write8(_buttons(vm).short_press(button, forget=False))


@handles("UI_BUTTON.LONGPRESS")
def longpress(vm: Machine, button: int, state: Place) -> None:
    """Whether it was held; forgets it."""
    state.write8(_buttons(vm).long_press(button))


@handles("UI_BUTTON.TESTLONGPRESS")
def testlongpress(vm: Machine, button: int, state: Place) -> None:
    """Whether it was held."""
    state.write8(_buttons(vm).long_press(button, forget=False))


@handles("UI_BUTTON.GET_BUMBED")
def get_bumbed(vm: Machine, button: int, state: Place) -> None:
    """Whether it was released; forgets it."""
    state.write8(_buttons(vm).bump(button))


@handles("UI_BUTTON.FLUSH")
def flush(vm: Machine) -> None:
    """Forgets everything."""
    _buttons(vm).flush()


@handles("UI_BUTTON.WAIT_FOR_PRESS")
def wait_for_press(vm: Machine) -> None:
    """Waits for any button, and leaves it to others to ask for it."""
    if not _buttons(vm).short_press(ANY_BUTTON, forget=False):
        vm.wait()


@handles("UI_BUTTON.GET_HORZ")
def get_horz(vm: Machine, value: Place) -> None:
    """Left or right."""
    value.write16(_buttons(vm).axis("left", "right"))


@handles("UI_BUTTON.GET_VERT")
def get_vert(vm: Machine, value: Place) -> None:
    """Up or down."""
    value.write16(_buttons(vm).axis("up", "down"))


@handles("UI_BUTTON.SET_BACK_BLOCK")
def set_back_block(vm: Machine, is_blocked: int) -> None:
    """Whether the back button leaves programs alone."""
    vm.brick.buttons.back_block = is_blocked


@handles("UI_BUTTON.GET_BACK_BLOCK")
def get_back_block(vm: Machine, is_blocked: Place) -> None:
    """What SET_BACK_BLOCK set."""
    is_blocked.write8(vm.brick.buttons.back_block)


@handles("UI_BUTTON.GET_CLICK")
def get_click(vm: Machine, click: Place) -> None:
    """Whether a press was found since last asked."""
    buttons = _buttons(vm)
    click.write8(buttons.click)
    buttons.click = False

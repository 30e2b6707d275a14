"""UI_DRAW's dialogues: they draw a window and keep the program waiting for a button."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import islice

from ev3proto.brick.devices.buttons import BUTTONS
from ev3proto.brick.devices.display.screen_dialog import ScreenDialog
from ev3proto.brick.exits import Busy
from ev3proto.brick.handlers import handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.text_lines import DELIMITERS, lines_of
from ev3proto.tables import paths
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import FILETYPE

_LARGE_ICONS = 32
"""Bits of ICON_QUESTION's set of icons."""

_SHOWN_LINES = 200
_MOST_SHOWN = 1 << 16
"""Lines and bytes of a text box that are shown."""

_KINDS = {
    str(CONSTANTS[extension]).encode(STRING_CODING): FILETYPE.members[kind]
    for extension, kind in (
        ("EXT_SOUND", "TYPE_SOUND"),
        ("EXT_BYTECODE", "TYPE_BYTECODE"),
        ("EXT_GRAPHICS", "TYPE_GRAPHICS"),
        ("EXT_DATALOG", "TYPE_DATALOG"),
        ("EXT_PROGRAM", "TYPE_PROGRAM"),
        ("EXT_TEXT", "TYPE_TEXT"),
    )
}


def _pressed(vm: Machine, name: str) -> bool:
    return vm.brick.buttons.short_press(BUTTONS[name])


def _open(vm: Machine) -> ScreenDialog:
    """Opens a dialog; earlier presses do not answer it."""
    vm.brick.buttons.flush()
    vm.brick.dialog = ScreenDialog(vm.brick.display, vm.program)
    return vm.brick.dialog


def _current(vm: Machine) -> ScreenDialog | None:
    """Returns the running program's dialog, not one that an ended program left; waits while the display is blocked."""
    if vm.brick.display.is_blocked_for(vm.program.slot, vm.object.number):
        raise Busy
    vm.brick.buttons.look(vm.program, vm.microseconds)
    dialog = vm.brick.dialog
    return dialog if dialog is not None and dialog.owner is vm.program else None


def _close(vm: Machine) -> None:
    """Closes the dialog and shows what was drawn before."""
    if vm.brick.dialog is not None:
        vm.brick.dialog.close()
        vm.brick.dialog = None


def _under_way(vm: Machine, state: Location) -> ScreenDialog | None:
    """Returns the open dialog; None if it has to be opened, which is noted in the state."""
    dialog = _current(vm)
    if state.read8() and dialog is not None:
        return dialog
    state.write8(1)
    return None


def _moved(vm: Machine, dialog: ScreenDialog, back: str, forward: str, count: int) -> bool:
    """Moves the selection by two buttons; returns whether one was pressed."""
    step = _pressed(vm, forward) - _pressed(vm, back)
    dialog.choice = max(0, min(dialog.choice + step, count - 1))
    return bool(step)


@handles("UI_DRAW.NOTIFICATION")
def notification(
    vm: Machine, _: int, __: int, ___: int, icon1: int, icon2: int, icon3: int, text: bytes, state: Location
) -> None:
    """Shows a text until enter is pressed."""
    dialog = _under_way(vm, state)
    if dialog is None:
        _open(vm).show_message((icon1, icon2, icon3), text)
    elif _pressed(vm, "enter"):
        state.write8(0)
        _close(vm)
        return
    raise Busy


@handles("UI_DRAW.QUESTION")
def question(
    vm: Machine, _: int, __: int, ___: int, icon1: int, icon2: int, ____: bytes, state: Location, answer: Location
) -> None:
    """Asks a question: left or right for no or yes, then enter; back for neither."""
    icons = (icon1, icon2)
    dialog = _under_way(vm, state)
    if dialog is None:
        dialog = _open(vm)
        dialog.choice = 1 if answer.read8() > 0 else 0
        dialog.show_choice(icons)
        raise Busy
    chosen = _chosen(vm, dialog, icons, state)
    answer.write8(-1 if chosen is None else chosen)


def _chosen(vm: Machine, dialog: ScreenDialog, icons: Sequence[int], state: Location) -> int | None:
    """Returns the icon that enter chooses, counted from 0; None for back. Waits for one of the two."""
    if _moved(vm, dialog, "left", "right", len(icons)):
        dialog.show_choice(icons)
        raise Busy
    is_back = _pressed(vm, "back")
    if not is_back and not _pressed(vm, "enter"):
        raise Busy
    state.write8(0)
    _close(vm)
    return None if is_back or not icons else dialog.choice


@handles("UI_DRAW.ICON_QUESTION")
def icon_question(vm: Machine, _: int, __: int, ___: int, state: Location, icons: Location) -> None:
    """Asks for one of several icons."""
    shown = [icon for icon in range(_LARGE_ICONS) if icons.read_bits() >> icon & 1]
    dialog = _under_way(vm, state)
    if dialog is None:
        _open(vm).show_choice(shown)
        raise Busy
    chosen = _chosen(vm, dialog, shown, state)
    icons.write32(0 if chosen is None else 1 << shown[chosen])


@handles("UI_DRAW.KEYBOARD")
def keyboard(
    vm: Machine, _: int, __: int, ___: int, icon: int, length: int, caption: bytes, characters: Location, text: Location
) -> None:
    """Edits a text; enter accepts it, back empties it."""
    dialog = _current(vm)
    if characters.read8() or dialog is None:
        dialog = _open(vm)
        dialog.text = text.read_text()
        characters.write8(0)
        dialog.show_input(icon, caption)
        raise Busy
    if _pressed(vm, "back"):
        vm.write_limited(text, b"", length)
        _close(vm)
    elif _pressed(vm, "enter"):
        vm.write_limited(text, dialog.text, length)
        _close(vm)
    else:
        up, down, left, right = (_pressed(vm, name) for name in ("up", "down", "left", "right"))
        if up or down or left or right:
            dialog.type_key(up, down, left, right)
            dialog.show_input(icon, caption)
        raise Busy


def _choose(vm: Machine, begins: bool, lines: Callable[[], Sequence[bytes]], box: tuple[int, int, int, int]) -> int:
    """Returns the number of the chosen line, counted from 0; -1 for none. Waits for the choice.

    The lines are read once, when the dialog is opened.
    """
    dialog = _current(vm)
    if begins or dialog is None:
        dialog = _open(vm)
        dialog.lines = lines()
        dialog.show_list(*box, dialog.lines)
        raise Busy
    if _moved(vm, dialog, "up", "down", len(dialog.lines)):
        dialog.show_list(*box, dialog.lines)
    is_back = _pressed(vm, "back")
    if not is_back and not _pressed(vm, "enter"):
        raise Busy
    _close(vm)
    return -1 if is_back or not dialog.lines else dialog.choice


@handles("UI_DRAW.BROWSE")
def browse(
    vm: Machine, _: int, x: int, y: int, width: int, height: int, length: int, kind: Location, path: Location
) -> None:
    """Asks for a file or folder in a folder."""
    folder = path.read_text()
    files, dialog = vm.brick.files, vm.brick.dialog
    chosen = _choose(vm, False, lambda: files.shown(folder), (x, y, width, height))
    if chosen < 0 or dialog is None:
        kind.write8(0)
        vm.write_limited(path, b"", length)
        return
    whole = folder.rstrip(b"/") + b"/" + dialog.lines[chosen]
    is_folder = files.is_folder(whole)
    extension = paths.split(whole).extension
    kind.write8(FILETYPE.members["TYPE_FOLDER"] if is_folder else _KINDS.get(extension, 0))
    vm.write_limited(path, whole, length)


@handles("UI_DRAW.TEXTBOX")
def textbox(
    vm: Machine, x: int, y: int, width: int, height: int, text: bytes, size: int, delimiter: int, line: Location
) -> None:
    """Shows the lines of a text and asks for one."""
    ends = DELIMITERS.get(delimiter, b"")
    whole = text[: max(min(size, _MOST_SHOWN), 0)]

    def lines() -> list[bytes]:
        return list(islice(lines_of(whole, ends), _SHOWN_LINES))

    begins = line.read16() < 0
    if begins:
        line.write16(0)
    chosen = _choose(vm, begins, lines, (x, y, width, height))
    line.write16(chosen + 1 if chosen >= 0 else -1)

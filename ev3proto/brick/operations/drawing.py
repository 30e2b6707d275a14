"""Drawing: UI_DRAW without the dialogues that wait for somebody."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar

from ev3proto.brick import path_names
from ev3proto.brick.devices.display import Display
from ev3proto.brick.devices.display.graph import Graph, Scale
from ev3proto.brick.devices.display.pictures import read_picture
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import WildAccess
from ev3proto.brick.operations.files import checked_name
from ev3proto.brick.places import Place
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DATA16, DATAF
from ev3proto.tables.encoding import STRING_CODING

Drawing = TypeVar("Drawing", bound=Callable[..., None])

_EXTENSION = str(CONSTANTS["EXT_GRAPHICS"]).encode(STRING_CODING)


def _drawer(vm: Machine) -> tuple[int, int]:
    """Who draws: program slot and object."""
    return vm.program.slot, vm.object.number


def draws(name: str, *, in_use: bool | None = True) -> Callable[[Drawing], Drawing]:
    """Registers what an operation does with the display, unless somebody has blocked it.

    Args:
        name: Of the operation.
        in_use: Whether the display is in use from then on, until what was drawn is shown; None: as it was.
    """

    def register(function: Drawing) -> Drawing:
        @handles(name)
        def draw(vm: Machine, *parameters: Any) -> None:
            display = vm.brick.display
            if not display.is_blocked_for(vm.program.slot, vm.object.number):
                function(display, *parameters)
                if in_use is not None:
                    display.is_in_use = in_use

        return function

    return register


@draws("UI_DRAW.UPDATE", in_use=False)
def update(display: Display) -> None:
    """Shows what was drawn."""
    display.update()


@draws("UI_DRAW.CLEAN")
def clean(display: Display) -> None:
    """Clears everything."""
    display.clean()


@draws("UI_DRAW.PIXEL")
def pixel(display: Display, color: int, x: int, y: int) -> None:
    """One pixel."""
    display.canvas.pixel(color, x, y)


@draws("UI_DRAW.LINE")
def line(display: Display, color: int, x0: int, y0: int, x1: int, y1: int) -> None:
    """A straight line."""
    display.canvas.line(color, x0, y0, x1, y1)


@draws("UI_DRAW.DOTLINE")
def dotline(display: Display, color: int, x0: int, y0: int, x1: int, y1: int, on: int, off: int) -> None:
    """A dotted line."""
    display.canvas.dotline(color, x0, y0, x1, y1, on, off)


@draws("UI_DRAW.RECT")
def rect(display: Display, color: int, x: int, y: int, width: int, height: int) -> None:
    """The outline of a rectangle."""
    display.canvas.rect(color, x, y, width, height)


@draws("UI_DRAW.FILLRECT")
def fillrect(display: Display, color: int, x: int, y: int, width: int, height: int) -> None:
    """A filled rectangle."""
    display.canvas.fillrect(color, x, y, width, height)


@draws("UI_DRAW.INVERSERECT")
def inverserect(display: Display, x: int, y: int, width: int, height: int) -> None:
    """Turns the pixels of a rectangle over."""
    display.canvas.inverserect(x, y, width, height)


@draws("UI_DRAW.CIRCLE")
def circle(display: Display, color: int, x: int, y: int, radius: int) -> None:
    """The outline of a circle."""
    display.canvas.circle(color, x, y, radius)


@draws("UI_DRAW.FILLCIRCLE")
def fillcircle(display: Display, color: int, x: int, y: int, radius: int) -> None:
    """A filled circle."""
    display.canvas.fillcircle(color, x, y, radius)


@draws("UI_DRAW.FILLWINDOW")
def fillwindow(display: Display, color: int, y: int, height: int) -> None:
    """Fills whole rows."""
    display.fillwindow(color, y, height)


@handles("UI_DRAW.SCROLL")
def scroll(vm: Machine, rows: int) -> None:
    """Moves everything up."""
    vm.brick.display.canvas.scroll(rows)


@draws("UI_DRAW.VERTBAR", in_use=None)
def vertbar(
    display: Display, color: int, x: int, y: int, width: int, height: int, least: int, most: int, actual: int
) -> None:
    """A scroll bar."""
    display.canvas.vertbar(color, x, y, width, height, least, most, actual)


@draws("UI_DRAW.STORE", in_use=None)
def store(display: Display, level: int) -> None:
    """Saves what is drawn."""
    display.store(level)


@draws("UI_DRAW.RESTORE")
def restore(display: Display, level: int) -> None:
    """Brings back what was saved."""
    display.restore(level)


@handles("UI_DRAW.POPUP")
def popup(vm: Machine, is_open: int) -> None:
    """Opens a window over what is drawn, or closes it. Waits while something is drawn that was not shown yet."""
    display = vm.brick.display
    if display.is_blocked_for(*_drawer(vm)) or (is_open and display.is_in_use):
        vm.wait()
    if is_open:
        display.open_popup(*_drawer(vm))
    else:
        display.close_popup()


@handles("UI_WRITE.SCREEN_BLOCK")
def screen_block(vm: Machine, is_blocked: int) -> None:
    """Keeps everybody from drawing, but who has opened a popup."""
    vm.brick.display.is_blocked = bool(is_blocked)


@handles("UI_DRAW.TOPLINE")
def topline(vm: Machine, is_on: int) -> None:
    """Switches the line at the top on or off."""
    vm.brick.display.is_headed = bool(is_on)


# Letters, icons, pictures


@draws("UI_DRAW.SELECT_FONT", in_use=None)
def select_font(display: Display, font: int) -> None:
    """Selects the font of what follows."""
    display.select_font(font)


@draws("UI_DRAW.TEXT")
def text(display: Display, color: int, x: int, y: int, string: bytes) -> None:
    """A text."""
    display.text(color, x, y, string)


@draws("UI_DRAW.VALUE")
def value(display: Display, color: int, x: int, y: int, number: float, figures: int, decimals: int) -> None:
    """A number."""
    display.value(color, x, y, number, figures, decimals)


@draws("UI_DRAW.VIEW_VALUE")
def view_value(display: Display, color: int, x: int, y: int, number: float, figures: int, decimals: int) -> None:
    """A number, centred."""
    display.view_value(color, x, y, number, figures, decimals)


@draws("UI_DRAW.VIEW_UNIT")
def view_unit(
    display: Display, color: int, x: int, y: int, number: float, figures: int, decimals: int, length: int, unit: bytes
) -> None:
    """A number with its unit."""
    display.view_unit(color, x, y, number, figures, decimals, unit[: max(length - 1, 0)])


@draws("UI_DRAW.ICON")
def icon(display: Display, color: int, x: int, y: int, kind: int, number: int) -> None:
    """An icon."""
    display.icon(color, x, y, kind, number)


def _picture(vm: Machine, color: int, x: int, y: int, data: bytes) -> None:
    display = vm.brick.display
    if not display.is_blocked_for(*_drawer(vm)):
        display.picture(color, x, y, read_picture(data))
        display.is_in_use = True


@handles("UI_DRAW.BMPFILE", places=("NAME",))
def bmpfile(vm: Machine, color: int, x: int, y: int, name: Place) -> None:
    """A picture from a file; nothing without such a file, or where its name is not allowed."""
    display = vm.brick.display
    path = None if display.is_blocked_for(*_drawer(vm)) else checked_name(vm, name)
    if path is None:
        return
    data = vm.brick.files.read(path if path_names.split(path).extension else path + _EXTENSION)
    if data is not None:
        _picture(vm, color, x, y, data)


@handles("UI_DRAW.PICTURE")
def picture(vm: Machine, color: int, x: int, y: int, address: int) -> None:
    """A picture from memory, where FILE.LOAD_IMAGE has put it; nothing for address 0."""
    image = vm.images.get(address)
    if image is not None:
        _picture(vm, color, x, y, image.data)
    elif address:
        raise WildAccess


# Graphs


@draws("UI_DRAW.GRAPH_SETUP", in_use=None)
def graph_setup(
    display: Display,
    x: int,
    size: int,
    items: int,
    offset: Place,
    span: Place,
    least: Place,
    most: Place,
    sample: Place,
) -> None:
    """Begins a graph; the arrays are read at every use of it."""

    def scale(item: int) -> Scale:
        short, long = item * DATA16.size, item * DATAF.size
        return Scale(
            offset.moved(short).read16(),
            span.moved(short).read16(),
            least.moved(long).read_float(),
            most.moved(long).read_float(),
            sample.moved(long).read_float(),
        )

    display.graph = Graph(x, size, tuple(partial(scale, item) for item in range(items)))


@handles("UI_WRITE.GRAPH_SAMPLE")
def graph_sample(vm: Machine) -> None:
    """Stores a sample of each item."""
    vm.brick.display.graph.sample()


@handles("UI_DRAW.GRAPH_DRAW")
def graph_draw(vm: Machine, view: int, actual: Place, lowest: Place, highest: Place, average: Place) -> None:
    """Draws one item, or all; nothing at all on a blocked display."""
    display = vm.brick.display
    graph = Graph() if display.is_blocked else display.graph
    display.is_in_use |= bool(graph.items)
    for place, number in zip((actual, lowest, highest, average), graph.draw(display.canvas, view), strict=True):
        place.write_float(number)

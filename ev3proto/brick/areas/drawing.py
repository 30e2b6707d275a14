"""Drawing: UI_DRAW without the dialogues that wait for somebody."""

from __future__ import annotations

from functools import partial

from ev3proto.brick import filenames
from ev3proto.brick.areas.files import in_own_folder
from ev3proto.brick.display.graph import Graph, Scale
from ev3proto.brick.display.pictures import read_picture
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.memory import Place
from ev3proto.brick.outcomes import WildAccess
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DATA16, DATAF
from ev3proto.tables.encoding import STRING_CODING

_EXTENSION = str(CONSTANTS["EXT_GRAPHICS"]).encode(STRING_CODING)


@handles("UI_DRAW.UPDATE")
def update(vm: Machine) -> None:
    """Shows what was drawn."""
    vm.brick.display.update()


@handles("UI_DRAW.CLEAN")
def clean(vm: Machine) -> None:
    """Clears everything."""
    vm.brick.display.clean()


@handles("UI_DRAW.PIXEL")
def pixel(vm: Machine, color: int, x: int, y: int) -> None:
    """One pixel."""
    vm.brick.display.canvas.pixel(color, x, y)


@handles("UI_DRAW.LINE")
def line(vm: Machine, color: int, x0: int, y0: int, x1: int, y1: int) -> None:
    """A straight line."""
    vm.brick.display.canvas.line(color, x0, y0, x1, y1)


@handles("UI_DRAW.DOTLINE")
def dotline(vm: Machine, color: int, x0: int, y0: int, x1: int, y1: int, on: int, off: int) -> None:
    """A dotted line."""
    vm.brick.display.canvas.dotline(color, x0, y0, x1, y1, on, off)


@handles("UI_DRAW.RECT")
def rect(vm: Machine, color: int, x: int, y: int, width: int, height: int) -> None:
    """The outline of a rectangle."""
    vm.brick.display.canvas.rect(color, x, y, width, height)


@handles("UI_DRAW.FILLRECT")
def fillrect(vm: Machine, color: int, x: int, y: int, width: int, height: int) -> None:
    """A filled rectangle."""
    vm.brick.display.canvas.fillrect(color, x, y, width, height)


@handles("UI_DRAW.INVERSERECT")
def inverserect(vm: Machine, x: int, y: int, width: int, height: int) -> None:
    """Turns the pixels of a rectangle over."""
    vm.brick.display.canvas.inverserect(x, y, width, height)


@handles("UI_DRAW.CIRCLE")
def circle(vm: Machine, color: int, x: int, y: int, radius: int) -> None:
    """The outline of a circle."""
    vm.brick.display.canvas.circle(color, x, y, radius)


@handles("UI_DRAW.FILLCIRCLE")
def fillcircle(vm: Machine, color: int, x: int, y: int, radius: int) -> None:
    """A filled circle."""
    vm.brick.display.canvas.fillcircle(color, x, y, radius)


@handles("UI_DRAW.FILLWINDOW")
def fillwindow(vm: Machine, color: int, y: int, height: int) -> None:
    """Fills whole rows."""
    vm.brick.display.fillwindow(color, y, height)


@handles("UI_DRAW.SCROLL")
def scroll(vm: Machine, rows: int) -> None:
    """Moves everything up."""
    vm.brick.display.canvas.scroll(rows)


@handles("UI_DRAW.VERTBAR")
def vertbar(
    vm: Machine, color: int, x: int, y: int, width: int, height: int, least: int, most: int, actual: int
) -> None:
    """A scroll bar."""
    vm.brick.display.canvas.vertbar(color, x, y, width, height, least, most, actual)


@handles("UI_DRAW.STORE")
def store(vm: Machine, level: int) -> None:
    """Saves what is drawn."""
    vm.brick.display.store(level)


@handles("UI_DRAW.RESTORE")
def restore(vm: Machine, level: int) -> None:
    """Brings back what was saved."""
    vm.brick.display.restore(level)


@handles("UI_DRAW.POPUP")
def popup(vm: Machine, is_open: int) -> None:
    """Opens a window over what is drawn, or closes it."""
    vm.brick.display.popup(bool(is_open))


@handles("UI_DRAW.TOPLINE")
def topline(vm: Machine, is_on: int) -> None:
    """Switches the line at the top on or off."""
    vm.brick.display.is_headed = bool(is_on)


# Letters, icons, pictures


@handles("UI_DRAW.SELECT_FONT")
def select_font(vm: Machine, font: int) -> None:
    """Selects the font of what follows."""
    vm.brick.display.select_font(font)


@handles("UI_DRAW.TEXT")
def text(vm: Machine, color: int, x: int, y: int, string: bytes) -> None:
    """A text."""
    vm.brick.display.text(color, x, y, string)


@handles("UI_DRAW.VALUE")
def value(vm: Machine, color: int, x: int, y: int, number: float, figures: int, decimals: int) -> None:
    """A number."""
    vm.brick.display.value(color, x, y, number, figures, decimals)


@handles("UI_DRAW.VIEW_VALUE")
def view_value(vm: Machine, color: int, x: int, y: int, number: float, figures: int, decimals: int) -> None:
    """A number, centred."""
    vm.brick.display.view_value(color, x, y, number, figures, decimals)


@handles("UI_DRAW.VIEW_UNIT")
def view_unit(
    vm: Machine, color: int, x: int, y: int, number: float, figures: int, decimals: int, length: int, unit: bytes
) -> None:
    """A number with its unit."""
    vm.brick.display.view_unit(color, x, y, number, figures, decimals, unit[: max(length - 1, 0)])


@handles("UI_DRAW.ICON")
def icon(vm: Machine, color: int, x: int, y: int, kind: int, number: int) -> None:
    """An icon."""
    vm.brick.display.icon(color, x, y, kind, number)


@handles("UI_DRAW.BMPFILE")
def bmpfile(vm: Machine, color: int, x: int, y: int, name: bytes) -> None:
    """A picture from a file; nothing without such a file."""
    path = in_own_folder(vm, name)
    data = vm.brick.files.read(path if filenames.split(path).extension else path + _EXTENSION)
    if data is not None:
        vm.brick.display.picture(color, x, y, read_picture(data))


@handles("UI_DRAW.PICTURE")
def picture(vm: Machine, color: int, x: int, y: int, address: int) -> None:
    """A picture from memory, where FILE LOAD_IMAGE has put it."""
    image = vm.images.get(address)
    if image is None:
        raise WildAccess
    vm.brick.display.picture(color, x, y, read_picture(image.data))


# Graphs


@handles("UI_DRAW.GRAPH_SETUP")
def graph_setup(
    vm: Machine, x: int, size: int, items: int, offset: Place, span: Place, least: Place, most: Place, sample: Place
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

    vm.brick.display.graph = Graph(x, size, tuple(partial(scale, item) for item in range(items)))


@handles("UI_WRITE.GRAPH_SAMPLE")
def graph_sample(vm: Machine) -> None:
    """Stores a sample of each item."""
    vm.brick.display.graph.sample()


@handles("UI_DRAW.GRAPH_DRAW")
def graph_draw(vm: Machine, view: int, actual: Place, lowest: Place, highest: Place, average: Place) -> None:
    """Draws one item, or all."""
    display = vm.brick.display
    for place, number in zip((actual, lowest, highest, average), display.graph.draw(display.canvas, view), strict=True):
        place.write_float(number)

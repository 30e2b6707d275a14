"""Drawing: UI_DRAW without the dialogues that wait for a button."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from ev3proto.brick.devices.display import Canvas, Display
from ev3proto.brick.devices.display.graph import Graph, Scale, Summary
from ev3proto.brick.devices.display.pictures import read_picture
from ev3proto.brick.exits import Busy, WildAccess
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.operations.files import checked_name
from ev3proto.tables import paths
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DATA16, DATAF
from ev3proto.tables.encoding import STRING_CODING

_EXTENSION = str(CONSTANTS["EXT_GRAPHICS"]).encode(STRING_CODING)


def _is_blocked(vm: Machine) -> bool:
    """Returns whether the running object may not draw."""
    return vm.brick.display.is_blocked_for(vm.program.slot, vm.object.number)


def _drawing(function: Callable[..., None], in_use: bool | None = True) -> Callable[..., None]:
    """Changes the display, unless that is blocked; `in_use` says whether it is in use from then on."""

    def draw(vm: Machine, *parameters: Any) -> None:
        if not _is_blocked(vm):
            function(vm.brick.display, *parameters)
            if in_use is not None:
                vm.brick.display.is_in_use = in_use

    return draw


def _on_canvas(method: Callable[..., None]) -> Callable[..., None]:
    return lambda display, *numbers: method(display.canvas, *numbers)


def _register(drawings: Mapping[str, Callable[..., None]]) -> None:
    for name, draw in drawings.items():
        handles(f"UI_DRAW.{name}")(draw)


def _view_unit(
    display: Display, color: int, x: int, y: int, number: float, figures: int, decimals: int, length: int, unit: bytes
) -> None:
    """Draws a number with its unit."""
    display.view_unit(color, x, y, number, figures, decimals, unit[: max(length - 1, 0)])


_register(
    {
        "PIXEL": _drawing(_on_canvas(Canvas.pixel)),
        "LINE": _drawing(_on_canvas(Canvas.line)),
        "DOTLINE": _drawing(_on_canvas(Canvas.dotline)),
        "RECT": _drawing(_on_canvas(Canvas.rect)),
        "FILLRECT": _drawing(_on_canvas(Canvas.fillrect)),
        "INVERSERECT": _drawing(_on_canvas(Canvas.inverserect)),
        "CIRCLE": _drawing(_on_canvas(Canvas.circle)),
        "FILLCIRCLE": _drawing(_on_canvas(Canvas.fillcircle)),
        "VERTBAR": _drawing(_on_canvas(Canvas.vertbar), in_use=None),
        "UPDATE": _drawing(Display.update, in_use=False),
        "CLEAN": _drawing(Display.clean),
        "FILLWINDOW": _drawing(Display.fillwindow),
        "STORE": _drawing(Display.store, in_use=None),
        "RESTORE": _drawing(Display.restore),
        "SELECT_FONT": _drawing(Display.select_font, in_use=None),
        "TEXT": _drawing(Display.text),
        "VALUE": _drawing(Display.value),
        "VIEW_VALUE": _drawing(Display.view_value),
        "VIEW_UNIT": _drawing(_view_unit),
        "ICON": _drawing(Display.icon),
    }
)

computes(
    {
        "UI_DRAW.SCROLL": lambda vm, rows: vm.brick.display.canvas.scroll(rows),
        "UI_DRAW.TOPLINE": lambda vm, is_on: setattr(vm.brick.display, "is_headed", bool(is_on)),
        # Keeps every object from drawing, except the one that has opened a popup.
        "UI_WRITE.SCREEN_BLOCK": lambda vm, is_blocked: setattr(vm.brick.display, "is_blocked", bool(is_blocked)),
        "UI_WRITE.GRAPH_SAMPLE": lambda vm: vm.brick.display.graph.sample(),
    }
)


@handles("UI_DRAW.POPUP")
def popup(vm: Machine, is_open: int) -> None:
    """Opens a window over the canvas, or closes it. Waits until everything drawn before is shown."""
    display = vm.brick.display
    if _is_blocked(vm) or (is_open and display.is_in_use):
        raise Busy
    if is_open:
        display.open_popup(vm.program.slot, vm.object.number)
    else:
        display.close_popup()


# Pictures

_draw_picture = _drawing(Display.picture)


@handles("UI_DRAW.BMPFILE", places=("NAME",))
def bmpfile(vm: Machine, color: int, x: int, y: int, name: Location) -> None:
    """Draws a picture from a file; nothing if the file is missing or its name is not allowed."""
    path = None if _is_blocked(vm) else checked_name(vm, name)
    if path is None:
        return
    data = vm.brick.files.read(path if paths.split(path).extension else path + _EXTENSION)
    if data is not None:
        _draw_picture(vm, color, x, y, read_picture(data))


@handles("UI_DRAW.PICTURE")
def picture(vm: Machine, color: int, x: int, y: int, address: int) -> None:
    """Draws a picture that FILE.LOAD_IMAGE has put into memory; nothing for address 0."""
    image = vm.images.get(address)
    if image is not None:
        _draw_picture(vm, color, x, y, read_picture(image.data))
    elif address:
        raise WildAccess


# Graphs


def _graph_setup(display: Display, x: int, size: int, items: int, *arrays: Location) -> None:
    """Begins a graph; the arrays are read at every use of it: offsets, spans, least, most and sample values."""
    offset, span, least, most, sample = arrays

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


_register({"GRAPH_SETUP": _drawing(_graph_setup, in_use=None)})


@handles("UI_DRAW.GRAPH_DRAW", computes=True)
def graph_draw(vm: Machine, view: int) -> Summary:
    """Draws one item, or all, and returns the last, lowest, highest and mean sample; nothing on a blocked display."""
    display = vm.brick.display
    graph = Graph() if display.is_blocked else display.graph
    display.is_in_use |= bool(graph.items)
    return graph.draw(display.canvas, view)

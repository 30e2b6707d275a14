"""The display of the virtual brick: pixels, letters, icons, pictures, graphs, and its output as braille or PNG."""

from ev3proto.brick.devices.display.canvas import HEIGHT, WIDTH, Canvas
from ev3proto.brick.devices.display.display import Display

__all__ = ["HEIGHT", "WIDTH", "Canvas", "Display"]

"""The display of the virtual brick: pixels, letters, icons, pictures, graphs, and how to look at it."""

from ev3proto.brick.display.canvas import HEIGHT, WIDTH, Canvas
from ev3proto.brick.display.display import Display, TopLine

__all__ = ["HEIGHT", "WIDTH", "Canvas", "Display", "TopLine"]

"""Titles of the firmware's areas, in the words of a table of contents."""

AREA_TITLES = {
    "vm": "Programs and the virtual machine",
    "math": "Arithmetic",
    "move": "Moving and converting values",
    "branch": "Jumps",
    "compare": "Comparisons",
    "ui": "Display, buttons, lights, battery",
    "timer": "Timers",
    "sound": "Sound",
    "input": "Sensors",
    "output": "Motors",
    "memory": "Files and arrays",
    "com": "Communication",
}

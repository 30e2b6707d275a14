"""The four motor ports: a model of LEGO's motor driver, in steps of its tick, and of motors without load.

`rotor` turns, `tachometer` measures speed from the times of degrees, `motor` is one port of the driver, `move` the
moves that end by themselves, `pair` two motors in step, and `outputs` the four ports.
"""

from ev3proto.brick.devices.motors.motor import Motor, Reading
from ev3proto.brick.devices.motors.outputs import PORT_LETTERS, Outputs, are_busy

__all__ = ["PORT_LETTERS", "Motor", "Outputs", "Reading", "are_busy"]

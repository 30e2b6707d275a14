"""Type stubs of what is made from the tables when a program runs: operations, system commands, enumerations.

With them editors complete `ops.sound.tone(`, show what each parameter means, and type checkers find what is wrong.
"""

from ev3proto.generate.stubs.build import build

__all__ = ["build"]

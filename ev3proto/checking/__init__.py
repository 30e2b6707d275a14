"""Checks of frames: whether the brick will accept a frame, and what a careful sender would change in it.

`checking.check` returns a report: the firmware's verdict (`verdict`), and findings of the rules, whose codes are all
in one table (`codes`). `fixing` fixes what can be fixed with certainty.
"""

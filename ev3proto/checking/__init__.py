"""Checks of frames: whether the brick will accept a frame, and what a careful sender would change in it.

`checking.check` returns a report: the firmware's verdict (`verdict`), and findings of the rules, whose codes are all
in one table (`codes`). `nearest` finds what was meant by a wrong frame: `slips` is the table of what people do wrong,
`edits` undoes it, and `check` judges the results. `fixing` takes what is certain.
"""

"""The C header: the numbers of the tables by name, the firmware's encoding macros, functions that fill a frame.

`tables` turns the tables into enumerations with comments, `parts` holds what is written by hand, `build` joins them
into a file.
"""

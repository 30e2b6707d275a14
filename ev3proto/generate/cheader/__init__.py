"""The C header: names of all numbers in the tables, the firmware's encoding macros, functions that fill a frame.

`tables` turns the tables into enumerations with comments, `parts` holds what is written by hand, `build` puts the file
together.
"""

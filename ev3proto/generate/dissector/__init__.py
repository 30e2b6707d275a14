"""The Wireshark dissector: a Lua file of data from the tables and a small runtime that walks it, and one for
statistics.

`tables` turns the tables into Lua, `names` has the filter names of system messages' fields, `lua` writes Lua values,
`runtime/` holds the parts written by hand, `profile` the matching Wireshark profile, `build` joins the parts into
files.
"""

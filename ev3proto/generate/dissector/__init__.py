"""The Wireshark dissector: a Lua file, made of data that the tables say and a small runtime that walks it, and one for
statistics.

`tables` turns the tables into Lua, `names` says what the fields of system messages are called in filters, `lua` writes
Lua values, `runtime/` holds the parts written by hand, `profile` the Wireshark profile that goes with it, `build` puts
the files together.
"""

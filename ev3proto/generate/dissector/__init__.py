"""The Wireshark dissector: one Lua file, made of data that the tables say and a small runtime that walks it.

`tables` turns the tables into Lua, `names` says what the fields of system messages are called in filters, `lua` writes
Lua values, `runtime/` holds the parts written by hand, `profile` the Wireshark profile that goes with it, `build` puts
the file together.
"""

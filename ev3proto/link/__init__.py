"""The connection of a program to a real or virtual brick.

`session` is the protocol without I/O: counters, pairing, pending replies. `carriers` transfer bytes to a brick and
back. `channel` joins the two for any number of threads; users work with `EV3` and `AsyncEV3`. `replay` and `proxy`
connect a capture or another program with a brick.
"""

"""To a brick: what a program needs to talk to a real brick or a virtual one.

`session` is the protocol without I/O: counters, pairing, what is outstanding. `carriers` bring bytes to a brick and
back. `channel` joins the two for any number of threads; `EV3` and `AsyncEV3` are what people hold. `replay` and `proxy`
connect a capture or another program with a brick.
"""

"""The JavaScript module: the numbers of the tables by name, and a function for each operation and system command.

`runtime.mjs` and `runtime.d.ts` are written by hand, `tables` writes the rest, `build` joins them into two files.
"""

"""The frames as a Kaitai Struct description, from which its compiler makes parsers in a dozen languages.

`messages` describes frames and everything around operations, `build` the operations and the file, `naming` makes the
names, `yaml` writes the lines.
"""

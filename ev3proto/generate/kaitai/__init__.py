"""The frames as a Kaitai Struct description, from which its compiler makes parsers in a dozen languages.

`messages` describes frames and what is around operations, `operations` every operation of a dialect, `naming` says what
things are called, `yaml` writes the lines, `build` puts the file together.
"""

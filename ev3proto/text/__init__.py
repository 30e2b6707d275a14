"""Frames as text: the notations people paste, and the output formats tree, table, assembly and JSON."""

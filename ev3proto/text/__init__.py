"""Frames as text: the notations people paste, and the tree, table, assembly and records they are shown in."""

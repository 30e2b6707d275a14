"""Helpers shared by the tests: captures built by hand, random frames, tshark, the command line."""

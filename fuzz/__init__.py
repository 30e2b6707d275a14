"""Fuzzing: targets, which accept any bytes and must not fail, and their driver. See `python -m fuzz --help`."""

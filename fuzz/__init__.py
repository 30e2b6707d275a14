"""Fuzzing: functions that take any bytes and must not fail, and what drives them. `python -m fuzz --help` says how."""

"""Benchmarks: run them with `pytest benchmarks`. The tests do not run them, as times depend on the machine."""

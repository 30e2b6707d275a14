"""Benchmarks: run them with `pytest benchmarks`; nothing here is a test that a clock could fail."""

"""The built-in engine: packets into records, without any other program."""

"""Bytes to messages and back, as Construct schemas generated from the tables.

Each schema is a Construct and works in both directions: `instruction_set()["SOUND.TONE"].build([1, 440, 1000])`.
"""

"""Bytes to messages and back, as Construct schemas drawn from the tables.

One schema serves both directions, and each is a Construct: `instruction_set()["SOUND.TONE"].build([1, 440, 1000])`.
"""

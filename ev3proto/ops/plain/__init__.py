"""Opcodes without a CMD of LEGO's own firmware: a module for each area of the firmware that has any.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

"""Dialogues: which reply answers which command, and what the reply therefore says.

A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
says what stands in it and where, so a `Dialogue` remembers the commands it saw. Replies to system commands have fields
of their own; there it remembers which file each handle stands for.
"""

from ev3proto.dialogue.dialogue import Dialogue, Exchange
from ev3proto.semantics.replies import Value, ValueType, reply_values, values_of
from ev3proto.semantics.transfers import Transfer

__all__ = ["Dialogue", "Exchange", "Transfer", "Value", "ValueType", "reply_values", "values_of"]

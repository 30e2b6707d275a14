"""Commands put together from operations: what is left open (places in memory, sizes, reply type) is worked out here.

An operation of `ev3proto.ops` is a `Draft`: its values are checked and encoded, but variables that were omitted, and
those that are `Local()` or `Global()`, get their place only when `command` knows all that shares the memory.
"""

from ev3proto.compose.commands import command
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.labels import Label
from ev3proto.semantics.drafts.placeholders import Global, Local, Placeholder

__all__ = ["Draft", "Global", "Label", "Local", "Placeholder", "command"]

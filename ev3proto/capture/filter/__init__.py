"""Filters: which records somebody wants to see, in the language that users of Wireshark know.

    keep = compile_filter("op==SOUND.TONE && FREQUENCY>400")
    loud = [record for record in capture if keep(record)]

Conditions
    NAME                      the record has it: `error`, `fault`, `orphan`, `FREQUENCY`
    NAME == VALUE             some value of the name is equal; also `eq`
    NAME != VALUE             the record has values of the name and none is equal, as in Wireshark 4; also `ne`
    NAME < VALUE              some value is less; so are <= > >=, and `lt le gt ge`
    NAME contains VALUE       some text or data has it in it
    NAME like PATTERN         some text is like a pattern: * is any characters, ? one, [abc] one of these; in any case
    NAME matches PATTERN      a regular expression is found in some text; in any case
    NAME in {VALUE, 1..5}     some value is equal to one of these or in one of these ranges; also `not in`
    && || !, and or not, ( )  `not` binds tighter than `and`, `and` tighter than `or`

Values are numbers (440, 0x94, 7.92), quantities (4ms, 7.9V), texts ("text", 'text', or r"text" without escapes), names
of an operation, an enumeration's member, a status, ... (SOUND.TONE, LED_RED, END_OF_FILE), addresses (192.0.2.10,
192.0.2.10:5555), bytes (4c:45:47:4f). `ev3proto.capture.filter.names` says which names there are, and
`ev3proto decode --help-filter` lists them.
"""

from __future__ import annotations

from ev3proto.capture.filter.choosing import Choosing
from ev3proto.capture.filter.compiling import Filter, compile_filter
from ev3proto.capture.filter.grammar import FilterError

__all__ = ["Choosing", "Filter", "FilterError", "compile_filter"]

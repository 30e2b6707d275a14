"""Filters: expressions that select records, like Wireshark's display filters.

    keep = compile_filter("op==SOUND.TONE && FREQUENCY>400")
    loud = [record for record in capture if keep(record)]

`manual` describes the language with examples; `ev3proto decode --help-filter` prints it.
"""

from __future__ import annotations

from ev3proto.capture.filter.choosing import Choosing
from ev3proto.capture.filter.language import Filter, compile_filter
from ev3proto.capture.filter.values import FilterError

__all__ = ["Choosing", "Filter", "FilterError", "compile_filter"]

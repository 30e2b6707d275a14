"""The page of filters: the whole filter language, with the examples of `--help-filter`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ev3proto.capture.filter.fields import places_of
from ev3proto.capture.filter.manual import ManualEntry, sections
from ev3proto.generate.pages.markdown import code, plain, table

_MOST_PLACES = 4
"""Number of operations named as examples of a parameter."""


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield (
        "This page lists everything that `--filter` accepts. [Filters](../filters.md) shows filters on captures;"
        " `ev3proto decode --help-filter` prints this list."
    )
    for title, entries in sections().items():
        yield f"## {title}"
        yield table(("written", "what it means", "example"), _rows(entries))
    yield "## All parameters and fields"
    yield table(("name", "of"), ((code(name), _owners(owners)) for name, owners in places_of().items()))


def _rows(entries: Iterable[ManualEntry]) -> Iterator[tuple[str, str, str]]:
    for entry in entries:
        yield _cell(entry.written), plain(entry.text), _cell(entry.example)


def _cell(text: str) -> str:
    """Returns code for a table cell, in which | would end the column."""
    return code(text.replace("|", "\\|"))


def _owners(owners: list[str]) -> str:
    named = ", ".join(map(plain, owners[:_MOST_PLACES]))
    return f"{named} and {len(owners) - _MOST_PLACES} more" if len(owners) > _MOST_PLACES else named

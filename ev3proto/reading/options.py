"""How sources are read, and how problems speak of them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, NamedTuple

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.tables.declaration import DIALECTS
from ev3proto.text.paste import Missing

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter

BUILTIN, WIRESHARK = "builtin", "wireshark"
"""The engines: the readers of this package, and tshark."""

ENGINES = (BUILTIN, WIRESHARK)

MIB = 1 << 20
"""The unit of the memory limit in sentences, in bytes."""

HOW_FRAMES_ARE_WRITTEN = "; frames are written in hex, such as 06:00|2A:00|80|00:00|01"


class Sources(Enum):
    """Whether a text can be a source instead of bytes."""

    NO = 0  # assembly is a problem
    YES = 1  # unless it has bytes
    FIRST = 2  # before it is bytes; JSON objects of messages are read, too


class Words(NamedTuple):
    """How problems speak of what is wanted.

    nothing   about a source in which nothing is; empty for advice by its contents
    argument  what a text can be besides a file
    accepted  what can be read, for problems about anything else, with a place for the formats of captures
    """

    nothing: str
    argument: str
    accepted: str


READ = Words("", "nor a frame", "captures are {captures}, packed with gzip or not")
ENCODED = Words(
    "nothing to encode; expected assembly such as SOUND(TONE, 1, 440, 1000), objects as `decode --json` prints"
    " them, or frames in hex such as 06:00|2A:00|80|00:00|01",
    "nor assembly nor a frame",
    "what can be encoded is assembly, JSON, frames in hex, or a capture",
)


@dataclass(frozen=True, slots=True)
class Options:
    """How sources are read.

    dialect     the firmware whose instruction set to use
    ports       TCP ports on which bricks listen; none for 5555, if its traffic is recognised
    everything  unrecognised traffic is read, too
    engine      BUILTIN or WIRESHARK
    tshark      path of the tshark for that engine
    filter      which records to yield; None for all
    missing     what frames in a text lack at their start
    memory      memory limit for incomplete and unanswered messages, in bytes
    sources     whether a text can be assembly, and a file an .lms
    images      images of programs are wanted; else they are a problem
    whole       texts are yielded whole as a `Source`, up to this number of bytes and one more; 0: their frames
    wanted      the name of what is looked for in captures
    raises      a file that cannot be opened raises OSError; else it is a problem
    """

    dialect: str = DIALECTS[0]
    ports: tuple[int, ...] = ()
    everything: bool = False
    engine: str = BUILTIN
    tshark: str | None = None
    filter: Filter | None = None
    missing: Missing | None = None
    memory: int = DEFAULT_MEMORY
    sources: Sources = Sources.YES
    images: bool = True
    whole: int = 0
    wanted: str = "frame"
    raises: bool = True

    @property
    def words(self) -> Words:
        """How problems speak."""
        return ENCODED if self.sources is Sources.FIRST else READ

    def given_up(self, count: int) -> str:
        """Returns the sentence about the number of things that were dropped at the memory limit."""
        return (
            f"{count} unfinished frames, transfers and unanswered commands were dropped: the memory limit is"
            f" {self.memory // MIB} MiB (--memory)"
        )

"""The Python side of the playground: what is read, a virtual brick, and a session with a real one.

Every function takes and returns types that JavaScript also has; answers are JSON. It runs in Pyodide and in CPython.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable
from functools import cache
from itertools import count
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from ev3proto.capture.filter import FilterError, compile_filter
from ev3proto.dialogue import Dialogue
from ev3proto.schema.frame import parse
from ev3proto.text.assembly.assembling import assembled
from ev3proto.text.assembly.disassembly import assembly
from ev3proto.text.paste import read_argument
from ev3proto.text.phrases import MACROS, Seen, heading
from ev3proto.text.spans import plain_text, visible

from .reading import Input, Steps
from .virtual_brick import VirtualBrick
from .words import about as about
from .words import complete as complete
from .words import explain as explain

if TYPE_CHECKING:
    from .real_brick import RealBrick

_FILE_NAME = re.compile(r"\w[\w .()-]{0,80}", re.ASCII)

_STOP = "OUTPUT_STOP(0, A+B+C+D, 1)"


def begin() -> None:
    """Begins anew: in a Python that comes from a snapshot, files are gone, and random numbers would repeat."""
    random.seed()
    _folder().cleanup()
    _folder.cache_clear()
    _virtual.cache_clear()


# The input

_now = Input()
_numbers = count(1)
_jobs: dict[int, Steps] = {}
"""What takes long and has begun, by number."""


def look(text: str, expression: str = "") -> str:
    """Reads what was typed or pasted to its end, with a filter or an empty one. Returns the `Input.answer`."""
    *_, last = _read("look", text, expression)
    return json.dumps(last["answer"])


def start(name: str, *given: Any) -> str:
    """Begins something that takes long.

    It is called as `name` says: "look", with a text and a filter; "open_file", with the name of a file that is in its
    `place`, and a filter; "timeline", without anything.

    What was begun before is given up, unless it reads the same input.

    Returns:
        The number of the job, for `go_on`.
    """
    number = next(_numbers)
    if name != "timeline":
        _jobs.clear()
    _jobs[number] = _now.timeline() if name == "timeline" else _read(name, *given)
    return json.dumps(number)


def go_on(number: int) -> str:
    """Does the next step of a job. Returns a report, as JSON: see `Steps`; null if the job was given up."""
    return json.dumps(next(_jobs[number]) if number in _jobs else None)


def give_up() -> str:
    """Ends what takes long."""
    _jobs.clear()
    return "null"


def place(name: str) -> str:
    """Returns the path at which a file with this name is to be written, to be opened. There is no other one then."""
    path = _path(name)
    for old in path.parent.iterdir():
        old.unlink()
    return json.dumps(str(path))


@cache
def _folder() -> TemporaryDirectory[str]:
    return TemporaryDirectory()


def _path(name: str) -> Path:
    is_plain = _FILE_NAME.fullmatch(name) is not None
    return Path(_folder().name) / (name if is_plain else f"file{Path(name).suffix if name.isprintable() else ''}")


def _read(call: str, given: str, expression: str = "") -> Steps:
    """Reads a text, or a file that has its place."""
    global _now
    try:
        wanted = compile_filter(expression) if expression.strip() else None
    except FilterError as error:
        return iter([{"answer": Input().answer() | {"error": f"the filter: {error}\n"}}])
    _now = Input(wanted)
    return _now.type(given) if call == "look" else _now.open(_path(given))


def _asks(of: Callable[[], object], name: str) -> Callable[..., str]:
    """Returns a function that asks the input or the brick."""
    return lambda *given: json.dumps(getattr(of(), name)(*given))


page, remedies = _asks(lambda: _now.pages, "page"), _asks(lambda: _now, "proposals")
made, to_send = _asks(lambda: _now.frames, "made"), _asks(lambda: _now.frames, "to_send")
"""The page that has a frame, by its number; proposals; the frames in a notation; what there is to send."""


def as_assembly(frame: str) -> str:
    """Returns a frame, in any notation, as text that can be edited and encoded again."""
    exchange = Dialogue().follow(parse(read_argument(frame).data, strict=False))
    lines = assembly(exchange, plain_text(heading(exchange, Seen())), MACROS)
    return json.dumps("".join(f"{visible(line)}\n" for line in lines))


def frames_of(operations: str) -> str:
    """Returns the frames that operations make, as JSON: `text` in the lesson's notation, and `error`, sentences."""
    *_, last = Input().type(f"{operations}\n")
    answer = last["answer"]
    return json.dumps({"text": answer["made"]["lesson"], "error": answer["error"]})


# The virtual brick


@cache
def _virtual() -> VirtualBrick:
    """Returns the brick, which is switched on at its first use."""
    return VirtualBrick()


def tick(seconds: float) -> str:
    """Advances the clock of the virtual brick. Returns what is new on it; empty if nothing is."""
    return _virtual().tick(seconds)


def rests() -> bool:
    """Returns whether nothing happens on the bricks by itself."""
    return _virtual().rests and not (_real is not None and _real.connection.is_open)


act, play = _asks(_virtual, "act"), _asks(_virtual, "play")
"""See `VirtualBrick`."""


# A real brick

_real: RealBrick | None = None


def connect(carrier: str, carry: Callable[[str], object], tell: Callable[[str], object]) -> str:
    """Begins a session: see `RealBrick`."""
    global _real
    from .real_brick import RealBrick  # takes 60 ms, which only a real brick needs

    _real = RealBrick(carrier, carry, tell)
    return "null"


def real(call: str, *given: Any) -> str:
    """Calls a method of the session with a real brick; null without one. Its answer is JSON; arrays become bytes."""
    plain = [each.to_bytes() if hasattr(each, "to_bytes") and not isinstance(each, int) else each for each in given]
    return json.dumps(None if _real is None else getattr(_real, call)(*plain))


def turn() -> None:
    """Lets time pass for the session."""
    if _real is not None and _real.connection.is_open:
        _real.turn()


def stop_motors() -> str:
    """Stops all motors without a question: of the real brick if one is connected, else of the virtual one."""
    if _real is not None and _real.connection.is_open:
        _real.stop_motors()
        return "null"
    _virtual().stop()
    (stopping,) = assembled(_STOP)
    return json.dumps(_virtual().send(stopping.build()))

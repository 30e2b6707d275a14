"""The page of what `proxy --read-only` lets through: the policy, and the list."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.pages.markdown import code, listed
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Effect, declarations
from ev3proto.tables.input import MOST_WAITS
from ev3proto.tables.system import SYSTEM

_RULES = (
    "**Operations.** A command passes if all of its operations are on the list below, every input is a constant in its"
    " documented range, and every result goes to a variable within the memory that the command requests. Handles,"
    " arrays, addresses, jumps and labels do not pass.",
    "**Types of devices.** A sensor's mode may be switched: that is reading. Its type may not: the firmware resets a"
    " port that is given another type, which lets a motor float. A type is sent as 0, which keeps what is plugged in.",
    f"**Waiting.** At most {MOST_WAITS} operations of a command may wait.",
    "**Paths** are `..` or `/home/root/lms2012` and names below it, without `.` and `..`, at most 100 characters.",
    "**Replies are required.**",
    "**One command at a time** of each client in turn. A file or listing is read in pieces of the proxy's own; sizes"
    " and handles of a client do not reach the brick. Before another client begins one, the open one is read to its"
    " end, and kept for its client. What a client leaves open is ended.",
)


def blocks() -> Iterator[str]:
    """Yields the blocks of the page."""
    yield (
        "Through `proxy --read-only`, by `replay` without `--allow`, and from the playground without a"
        " question, a client may read. It changes nothing but the mode of a sensor, keeps nothing, holds up"
        " no other client, and leaves nothing behind when it goes. What the firmware does decides what that means."
    )
    yield listed(_RULES)
    yield (
        "`replay` follows the same rules as it sends, by the replies of the brick that it talks to; handles of"
        " the recording are never sent. In the playground anything else asks first, except the button that stops"
        " all motors: it sends one `OUTPUT_STOP` of all four ports, with the brake."
    )
    yield "## The list"
    names = [one.name for one in declarations(OPCODES) if Effect.READS in one.effects]
    yield ", ".join(map(code, names))
    yield "System commands:"
    yield ", ".join(code(one.name) for one in SYSTEM if Effect.READS in one.effects)

"""The page of what `proxy --read-only` lets through: the policy, and the list with its reasons."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ev3proto.generate.pages.markdown import code, listed, plain, table
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Effect, declarations
from ev3proto.tables.reading import MOST_FILES, MOST_PATH, MOST_WAITS, READING, ReadOnly, reading_of
from ev3proto.tables.system import SYSTEM

_RULES = (
    "**Operations.** A command passes if all of its operations are on the list below. Results go to variables"
    " within the memory that the command requests; counts and lengths are constants; numbers are in their"
    " documented range; texts are paths. Arrays, addresses, jumps and labels do not pass.",
    "**Types of devices.** A sensor's mode may be switched: that is reading. Its type may not: the firmware"
    " resets a port that is given another type, which lets a motor float. Many programs give a type, so the"
    " brick is asked before such a command what is plugged in (`INPUT_DEVICE.GET_TYPEMODE`); it passes if the"
    " type is that, 0, or if the port is empty. Where a variable has the type, its value is asked for as well.",
    f"**Waiting.** A command waits for at most {MOST_WAITS} sensors (`READY_RAW`, `READY_SI`, `READY_PCT`), 1.2"
    " s for each.",
    f"**Files in a command.** At most {MOST_FILES} are opened. A file is read only if the brick says that it"
    " exists, by the handle that the same command got for it. `FILE.CLOSE` does not pass: the end of the command"
    " closes its files.",
    f"**Paths** are below `/home/root/lms2012` once `.` and `..` are resolved, and have at most {MOST_PATH}"
    " characters.",
    "**Replies are required.** A command that reads and wants none is blocked: a file that it opens stays open"
    " for good.",
    "**One command at a time.** The next one goes to the brick after the reply to the one before, and what a"
    " client sends meanwhile is not read. If there is no reply within 15 s, the connection to the brick is made"
    " anew.",
    "**One file or listing at a time**, as the firmware goes on with the one that was opened last, whatever handle a"
    " command names. With the next one the one before ends. A handle is the client's own if it was in the reply to its"
    " own command; it is used for what it was opened for.",
    "**Listings are never closed**, as the firmware would close a file of its own. They are read to their end instead.",
    "**Sizes.** Where a client asks for more than fits a reply, 1,012 bytes, or 1,016 in `CONTINUE_UPLOAD` and"
    " `CONTINUE_LIST_FILES`, less is asked for. Longer replies come in parts, which look like frames.",
    "**Nothing is left behind.** When a client goes, its last command is answered first, its file is closed and its"
    " listing read to its end. Then the next client is served.",
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
    yield "An operation is on the list if it is in one of these rows."
    yield table(("operations", "why"), _rows(names))
    yield "System commands:"
    yield table(("commands", "why"), _rows(one.name for one in SYSTEM if Effect.READS in one.effects))


def _rows(names: Iterable[str]) -> Iterator[tuple[str, str]]:
    listed_names = list(names)
    for row in READING:
        own = [name for name in listed_names if reading_of(name) is row]
        if own:
            yield ", ".join(map(code, own)), plain(row.reason + _limits(row))


def _limits(row: ReadOnly) -> str:
    """Returns the limits of a row besides its reason, as sentences."""
    limits = [f" {name} needs {size} bytes." for name, size in row.room.items()]
    limits += [f" {name} is {value}." for name, value in row.only.items()]
    if row.most is not None:
        limits.append(f" At most {row.most} in a command.")
    return "".join(limits)

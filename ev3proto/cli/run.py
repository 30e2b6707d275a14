"""`ev3proto run`: a program on a virtual brick, with its display in the terminal or on a web page."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from ev3proto.brick import Brick
from ev3proto.brick.devices.display.canvas import WIDTH
from ev3proto.brick.devices.display.pictures import braille
from ev3proto.brick.running_programs import DEBUG_SLOT, FAIL, RUNNING, USER_SLOT, Program
from ev3proto.brick.servers.host import ServerError
from ev3proto.brick.servers.server import Options, Running, running
from ev3proto.cli.brick import (
    folder,
    interrupted,
    page_option,
    read_script_file,
    root_option,
    screenshot_option,
    script_option,
)
from ev3proto.cli.options import PATH, FiniteRange, exclusive
from ev3proto.cli.output import complain, failing_on, failing_to, flush, is_terminal, say
from ev3proto.cli.programs import assembled
from ev3proto.program import check_program
from ev3proto.reading.kinds import is_image
from ev3proto.tables.enumerations import LEDPATTERN
from ev3proto.tables.errors import ERRORS
from ev3proto.tables.program import MAX_IMAGE
from ev3proto.text.spans import visible

_SLOTS = {"user": USER_SLOT, "debug": DEBUG_SLOT}

_PERIOD = 0.05
_PRESS = 0.1
"""Seconds between two checks of the program, and seconds for which a key presses a button."""

_KEYS = {
    b"\x1b[A": "up",
    b"\x1b[B": "down",
    b"\x1b[C": "right",
    b"\x1b[D": "left",
    b"\r": "enter",
    b"\n": "enter",
    b" ": "enter",
    b"\x7f": "back",
    b"\x08": "back",
    b"\x1b": "back",
}


@click.command()
@click.argument("file", type=PATH)
@page_option
@root_option
@script_option
@screenshot_option
@click.option(
    "--slot",
    type=click.Choice(list(_SLOTS)),
    default="user",
    show_default=True,
    help="Slot to run it in; LEGO's own self-tests run in the one for debugging.",
)
@click.option("--limit", type=FiniteRange(0), metavar="SECONDS", help="End the program after this time.")
@exclusive("--http", "--limit")
def run(
    file: Path,
    page: int | None,
    root: Path | None,
    script: Path | None,
    screenshot: Path | None,
    slot: str,
    limit: float | None,
) -> None:
    """Runs a program (.rbf or .lms) on a virtual brick until it ends.

    On a terminal, the display is shown while the program runs, and the arrow keys, Enter and Backspace are the brick's
    buttons; otherwise the display is printed at the end. With --http, the program starts when the page is opened, and
    Ctrl-C ends it. Exit status 1: the program failed.

    \b
      ev3proto run hello.lms
      ev3proto run robot.rbf --script robot.toml --http
    """  # noqa: D301 - the mark by which click leaves lines as they are
    image = _image(file)
    options = Options(port=None, page=page, screenshot=screenshot, script=read_script_file(script))
    with folder(root) as place:
        sys.exit(asyncio.run(_run(image, file.stem, options, place, limit, _SLOTS[slot])))


def _image(file: Path) -> bytes:
    """Returns the image in a file, or that of its source. Ends the command if it is neither."""
    label = visible(str(file))
    with failing_to("read", file), file.open("rb") as stream:
        found = stream.read(MAX_IMAGE + 1)
    if is_image(found):
        return found
    made = assembled(found, label)
    if made is None:
        sys.exit(1)
    return made.image


async def _run(image: bytes, name: str, options: Options, root: Path, limit: float | None, slot: int) -> int:
    with failing_on(ServerError):
        async with running(options, root, complain) as now:
            with interrupted() as ended:
                if now.link:
                    say(f"page at {now.link}")
                    flush()
                    await _first(now.looked, ended)
                program = _start(now.brick, image, name, slot)
                if program is None:
                    return 1
                if now.link:
                    await ended.wait()
                else:
                    await _show(now, program, ended, limit)
            return _ending(now.brick, program)


async def _first(*events: asyncio.Event) -> None:
    waiting = [asyncio.create_task(event.wait()) for event in events]
    await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
    for task in waiting:
        task.cancel()


def _start(brick: Brick, image: bytes, name: str, slot: int) -> Program | None:
    """Starts the program as PROGRAM_START does, and prints the findings of `check`; None if the brick refuses it."""
    report = check_program(image, dialect=brick.equipment.dialect)
    if report.findings:
        complain(str(report))
    program = brick.start(image, name, slot)
    if program is None and report.accepted:
        complain("the brick refuses the program: it needs more memory than there is")
    return program


def _ending(brick: Brick, program: Program) -> int:
    if program.status == RUNNING:
        complain("the program was ended before its own end")
        return 0
    if program.result == FAIL:
        named = [ERRORS[number] for number in brick.equipment.settings.errors if number < len(ERRORS)]
        complain(f"the program failed: {', '.join(named) or 'an operation failed'}")
        return 1
    return 0


async def _show(now: Running, program: Program, ended: asyncio.Event, limit: float | None) -> None:
    """Shows the display until the program ends: live on a terminal, else at the end."""
    loop = asyncio.get_running_loop()
    until = None if limit is None else loop.time() + limit
    with _keyboard(now), _screen(now.brick) as draw:
        # The clock runs in the tasks of the brick.
        while program.status == RUNNING and not ended.is_set() and (until is None or loop.time() < until):
            draw()
            await asyncio.sleep(_PERIOD)
        draw()
    if not is_terminal():
        say("\n".join(_lines(now.brick)))


def _lines(brick: Brick) -> list[str]:
    return braille(brick.display.rows, WIDTH)


@contextmanager
def _screen(brick: Brick) -> Iterator[Callable[[], None]]:
    """Yields a function that draws the display and the light on the terminal, if there is one."""
    if not is_terminal():
        yield lambda: None
        return
    from rich.console import Group  # these three take 42 ms, which only terminals need
    from rich.live import Live
    from rich.text import Text

    leds = {number: name for name, number in LEDPATTERN.members.items()}

    def state() -> tuple[object, ...]:
        playing = brick.equipment.sound.playing
        return brick.display.rows, leds[brick.leds], playing.frequency if playing is not None else 0

    shown = state()

    def picture() -> Group:
        lines = [Text(line, no_wrap=True, overflow="crop") for line in _lines(brick)]
        _, light, frequency = shown
        return Group(Text(f"{light}, {frequency} Hz" if frequency else f"{light}", no_wrap=True), *lines)

    def draw() -> None:
        nonlocal shown
        if shown != state():
            shown = state()
            live.update(picture(), refresh=True)

    with Live(picture(), auto_refresh=False, vertical_overflow="crop") as live:
        yield draw


@contextmanager
def _keyboard(now: Running) -> Iterator[None]:
    """Lets keys of the terminal press the brick's buttons for the length of the context."""
    try:
        import termios  # Windows has neither
        import tty
    except ImportError:
        yield
        return
    if sys.stdin is None or not sys.stdin.isatty():
        yield
        return
    loop = asyncio.get_running_loop()
    keys = sys.stdin.fileno()
    before = termios.tcgetattr(keys)

    def release(button: str) -> None:
        now.brick.release(button)
        now.host.wake()

    def pressed() -> None:

        button = _KEYS.get(os.read(keys, 16))
        if button is not None:
            now.brick.press(button)
            now.host.wake()
            loop.call_later(_PRESS, release, button)

    # Keys that were typed before count.
    tty.setcbreak(keys, termios.TCSADRAIN)
    loop.add_reader(keys, pressed)
    try:
        yield
    finally:
        loop.remove_reader(keys)
        termios.tcsetattr(keys, termios.TCSADRAIN, before)

"""A virtual brick with the servers and observers of its options, from power-on to power-off."""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import os
from collections.abc import AsyncIterator
from contextlib import AbstractAsyncContextManager, AsyncExitStack, asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ev3proto.brick.brick import Brick
from ev3proto.brick.devices.display.canvas import WIDTH
from ev3proto.brick.devices.display.pictures import write_png
from ev3proto.brick.limits import STRETCH
from ev3proto.brick.servers.host import Faults, Host, Say, ServerError
from ev3proto.brick.servers.recording import Recorder
from ev3proto.brick.servers.reporting import Reporter
from ev3proto.brick.servers.script import Script
from ev3proto.brick.servers.serial_port import SerialPort
from ev3proto.brick.servers.wifi import Wifi
from ev3proto.extras import install_command
from ev3proto.schema.discovery import Beacon
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.tables.paths import USUAL_FOLDERS
from ev3proto.version import REPORT_IT
from ev3proto.whole_files import write_whole

LOOPBACK = "127.0.0.1"
SCREENSHOT_SCALE = 3

NETWORK = "ev3proto"
"""Name of the network that the brick reports."""


@dataclass(frozen=True)
class Options:
    """The options of a brick's server."""

    address: str = LOOPBACK  # where clients connect; loopback unless another one is named
    port: int | None = TCP_PORT  # TCP port of WiFi, 0 for any that is free; None: no WiFi
    beacon: bool = True  # whether it sends beacons
    clients: int = 1  # number of clients that are served at once
    serial: Path | None = None  # where the link to a serial port is to be; None: no such port
    page: int | None = None  # TCP port of the page, 0 for any that is free; None: no page
    faults: Faults = field(default_factory=Faults)  # the deliberate faults of replies
    record: Path | None = None  # file for a capture of the connections
    force: bool = False  # whether that file may exist
    report: bool = False  # whether clients' frames are checked
    screenshot: Path | None = None  # file for a picture of the display at the end
    script: Script = field(default_factory=Script)  # the devices, and events over time
    core_set: bool = False  # whether LEGO's core set is plugged in, unless the script plugs something in
    dialect: str = "official"  # the firmware's instruction set
    serial_number: str | None = None  # 12 hexadecimal digits; None: the usual ones

    @property
    def has_core_set(self) -> bool:
        """Whether LEGO's core set is plugged in."""
        return self.core_set and not self.script.plugs


@dataclass(frozen=True)
class Running:
    """A brick that is on."""

    brick: Brick
    host: Host  # what drives it
    address: str = ""  # where WiFi listens
    port: int = 0  # of WiFi; 0 without WiFi
    link: str = ""  # the page's address with its token; empty without a page
    looked: asyncio.Event = field(default_factory=asyncio.Event)  # set when the page was opened
    reporter: Reporter | None = None  # the checks of the frames so far; None if not requested


@asynccontextmanager
async def running(options: Options, root: Path, say: Say) -> AsyncIterator[Running]:
    """Switches a brick on, and off at the end. Raises ServerError, also for a file or a library."""
    loop = asyncio.get_running_loop()
    async with AsyncExitStack() as stack:
        brick = Brick(root, dialect=options.dialect, stretch=STRETCH)
        if options.has_core_set:
            brick.plug_core_set()
        options.script.set_up(brick)
        if options.serial_number is not None:
            brick.equipment.settings.bluetooth_address = options.serial_number
        _make_usual_folders(root)
        host = Host(brick, say, options.faults)
        loop.set_exception_handler(lambda _, context: host.say_once(f"a defect, {REPORT_IT}: {_told(context)}"))
        stack.callback(host.stop)
        if options.screenshot is not None:
            _expect_place(options.screenshot)
            stack.callback(_save_screenshot, brick, options.screenshot, say)
        recorder = None if options.record is None else _recorder(options.record, say, options.force)
        if recorder is not None:
            host.observers.append(recorder)
            stack.callback(recorder.close)
        reporter = None
        if options.report:
            reporter = Reporter(options.dialect, None if recorder is None else lambda: recorder.packets)
            host.observers.append(reporter)
        stack.callback(host.end_all)
        link, looked = "", asyncio.Event()
        if options.page is not None:
            link, looked = await stack.enter_async_context(_page(host, options.address, options.page))
        if options.serial is not None:
            stack.callback(SerialPort(host, options.serial).close)
        address, port = "", 0
        if options.port is not None:
            wifi = Wifi(host, options.clients)
            stack.push_async_callback(wifi.close)
            await wifi.listen(options.address, options.port)
            address, port = wifi.address, wifi.port
            settings = brick.equipment.settings
            settings.wifi, settings.network, settings.ip = True, NETWORK, address
            if options.beacon:
                wifi.announce(lambda: _beacon(brick, port))
        if not is_loopback(options.address):
            say(f"anyone who can reach {options.address} can use this brick and its files; WiFi has no password")
        steps = asyncio.create_task(_follow(options.script, host))
        stack.callback(steps.cancel)
        yield Running(brick, host, address, port, link, looked, reporter)


def _beacon(brick: Brick, port: int) -> Beacon:
    return Beacon(brick.equipment.settings.bluetooth_address, str(port), brick.equipment.settings.name)


def _make_usual_folders(root: Path) -> None:
    """Creates the folders of LEGO's bricks, in which programs look for files."""
    for name in USUAL_FOLDERS:
        with contextlib.suppress(OSError):
            (root / name).mkdir(parents=True, exist_ok=True)


def _told(context: dict[str, Any]) -> str:
    """Returns asyncio's message about an unhandled exception."""
    error = context.get("exception")
    return f"{context['message']}" if error is None else f"{context['message']}: {error!r}"


def is_loopback(address: str) -> bool:
    """Returns whether only this computer reaches an address."""
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        return address == "localhost"


def save_screenshot(brick: Brick, path: Path) -> None:
    """Writes the display as a picture. Raises OSError."""
    write_whole(path, write_png(brick.display.rows, WIDTH, SCREENSHOT_SCALE))


def _save_screenshot(brick: Brick, path: Path, say: Say) -> None:
    try:
        save_screenshot(brick, path)
    except OSError as error:
        say(f"{path}: the display cannot be saved: {error.strerror or error}")


def _expect_place(path: Path) -> None:
    """Raises ServerError at the start, not at the end, if a file cannot be written."""
    if not os.access(path.parent, os.W_OK):
        reason = "Permission denied" if path.parent.exists() else "No such file or directory"
        raise ServerError(f"{path}: cannot be written: {reason}")


def _recorder(path: Path, say: Say, force: bool) -> Recorder:
    try:
        return Recorder(path, say, force=force)
    except OSError as error:
        raise ServerError(f"{path}: cannot be written: {error.strerror or error}") from None


def _page(host: Host, address: str, port: int) -> AbstractAsyncContextManager[tuple[str, asyncio.Event]]:
    """Serves the page while the brick is on. Yields the link to it, and the event that is set when it was opened."""
    try:
        from ev3proto.brick.servers.page.server import serving  # aiohttp is an extra
    except ImportError:
        raise ServerError(
            f"the page needs the package aiohttp, which is not installed: {install_command('page')}"
        ) from None
    return serving(host, address, port)


async def _follow(script: Script, host: Host) -> None:
    """Does the steps of a script, each at its time."""
    loop = asyncio.get_running_loop()
    begin = loop.time()
    for at, step in script.times():
        await asyncio.sleep(max(0.0, begin + at - loop.time()))
        script.do(step, host.brick)
        host.wake()

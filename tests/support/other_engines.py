"""Tries the playground in one engine: `other_engines.py firefox|webkit SITE`, called by tests/browsers.

It runs in environments of their own, so it imports nothing from the project. Each engine has its driver; what is common
to them is that they open an address and run a script.
"""

from __future__ import annotations

import functools
import http.server
import json
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

TONE = "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
WRONG = "0x|08:00|01:00|00|05:00|81:01:61|"
PATIENCE = 120.0
"""Seconds to wait for anything."""


class Engine(NamedTuple):
    """A browser."""

    open: Callable[[str], object]
    run: Callable[..., Any]


@contextmanager
def firefox() -> Iterator[Engine]:
    """Yields Debian's Firefox, by Mozilla's own driver."""
    from marionette_driver.marionette import Marionette

    with tempfile.TemporaryDirectory() as folder:
        browser = Marionette(bin="/usr/bin/firefox-esr", headless=True, gecko_log=str(Path(folder) / "log"))
        browser.start_session()
        try:
            yield Engine(browser.navigate, lambda script, *given: browser.execute_script(script, given, sandbox=None))
        finally:
            browser.quit()


@contextmanager
def webkit() -> Iterator[Engine]:
    """Yields the browser of WebKitGTK, on whatever display there is."""
    from selenium.webdriver import WebKitGTK, WebKitGTKOptions
    from selenium.webdriver.webkitgtk.service import Service

    options = WebKitGTKOptions()
    options.binary_location = str(next(Path("/usr/lib").glob("*/webkit2gtk-4.*/MiniBrowser")))
    options.add_argument("--automation")
    browser = WebKitGTK(options=options, service=Service("/usr/bin/WebKitWebDriver"))
    try:
        yield Engine(browser.get, browser.execute_script)
    finally:
        browser.quit()


class Tour:
    """What a visitor does, step by step."""

    def __init__(self, engine: Engine, address: str) -> None:
        self._engine = engine
        self._address = address

    def text(self, name: str) -> str:
        """Returns all text of an element."""
        return str(self._engine.run("return document.getElementById(arguments[0]).textContent", name))

    def wait(self, condition: Callable[[], object]) -> None:
        """Waits until a condition holds."""
        end = time.monotonic() + PATIENCE
        while not condition():
            if time.monotonic() > end:
                shown = {name: self.text(name) for name in ("status", "error", "sentence", "verdict", "frame")}
                raise AssertionError(f"this does not come; the page shows {json.dumps(shown)}")
            time.sleep(0.02)

    def type(self, text: str) -> None:
        """Puts a text into the input, as pasting does."""
        self._engine.run(
            "const input = document.getElementById('input'); input.value = arguments[0];"
            "input.dispatchEvent(new Event('input'))",
            text,
        )

    def click(self, selector: str) -> None:
        """Clicks an element."""
        self._engine.run("document.querySelector(arguments[0]).click()", selector)

    def a_link_is_opened(self) -> None:
        """Python starts, from the snapshot, and reads what the link has."""
        begun = time.monotonic()
        self._engine.open(f"{self._address}#text={quote(TONE)}")
        self.wait(lambda: self._engine.run("return document.body.dataset.ready") == "true")
        self.wait(lambda: self.text("sentence") == "Plays 440 Hz for 1 s at volume 1 %.")
        started = self._engine.run("return document.body.dataset.started")
        assert started == "snapshot", started
        print(f"  first frame after {time.monotonic() - begun:.1f} s, from a {started}")
        assert self.text("verdict") == "The brick takes it."
        assert self.text("frame") == TONE

    def a_wrong_frame_is_refused(self) -> None:
        """A finding marks its bytes."""
        self.type(WRONG)
        self.wait(lambda: "error[" in self.text("findings"))
        assert self.text("verdict").startswith("The brick refuses it at byte 7: VALUE of UI_READ")
        self.click("#findings .error")
        marked = self._engine.run("return [...document.querySelectorAll('#bytes .chosen')].map((it) => it.textContent)")
        assert marked == ["61"], marked

    def operations_become_a_frame(self) -> None:
        """Assembly is read, too."""
        self.type("UI_WRITE(LED, LED_RED)")
        self.wait(lambda: self.text("frame") == "0x|08:00|00:00|80|00:00|82:1B:02|")

    def the_virtual_brick_obeys(self) -> None:
        """The light becomes red."""
        self.click("#send")
        self.wait(lambda: self.text("leds") == "LED_RED")

    def it_says_whether_it_reaches_a_brick(self) -> None:
        """What the browser lacks, WebHID or Web Serial, is in a sentence in place of the button that needs it."""
        can = self._engine.run("return Boolean(navigator.hid || navigator.serial)")
        said = self.text("brick-status")
        assert ("neither WebHID nor Web Serial" in said) != can, said
        for carrier, needed, name in (("usb", "hid", "WebHID"), ("bluetooth", "serial", "Web Serial")):
            has = self._engine.run("return Boolean(navigator[arguments[0]])", needed)
            shown = "return document.getElementById(arguments[0]).getClientRects().length > 0"
            assert self._engine.run(shown, f"connect-{carrier}") == has, carrier
            assert (name in said) != has, said

    def a_second_visit_starts_from_what_is_kept(self) -> None:
        """The page is there again without a network."""
        if self._engine.run("return 'serviceWorker' in navigator"):
            state = "return document.body.dataset.kept"
            self._engine.run(
                "navigator.serviceWorker.ready.then((it) => { document.body.dataset.kept = it.active ? 'yes' : ''; })"
            )
            self.wait(lambda: self._engine.run(state) == "yes")
        self._engine.open("about:blank")
        self.a_link_is_opened()


STEPS = (
    Tour.a_link_is_opened,
    Tour.a_wrong_frame_is_refused,
    Tour.operations_become_a_frame,
    Tour.the_virtual_brick_obeys,
    Tour.it_says_whether_it_reaches_a_brick,
    Tour.a_second_visit_starts_from_what_is_kept,
)


class _Quiet(http.server.SimpleHTTPRequestHandler):
    """The site as a folder."""

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing."""


def main(name: str, site: str) -> int:
    """Takes the tour. Returns the number of steps that fail."""
    engines = {"firefox": firefox, "webkit": webkit}
    failed = 0
    handler = functools.partial(_Quiet, directory=site)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server, engines[name]() as engine:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        tour = Tour(engine, f"http://127.0.0.1:{server.server_port}/playground/index.html")
        for step in STEPS:
            try:
                step(tour)
                print(f"{name}: {step.__name__}: passed", flush=True)
            except AssertionError as error:
                failed += 1
                print(f"{name}: {step.__name__}: FAILED: {error}", flush=True)
        server.shutdown()
    return failed


if __name__ == "__main__":
    sys.exit(min(1, main(sys.argv[1], sys.argv[2])))

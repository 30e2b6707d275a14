"""The playground in a browser: the built site on a server that also has a brick, and the page as a user sees it."""

from __future__ import annotations

import http.server
import json
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from selenium.webdriver import Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from ev3proto.brick import Brick

FAKES = Path(__file__).parent / "fakes.js"
STEP, MOST_STEPS = 0.05, 200
TYPE_OFFSET, NO_REPLY = 4, 0x80


class Handler(http.server.SimpleHTTPRequestHandler):
    """The site as a folder, and a brick that answers what is posted to it."""

    def __init__(self, *arguments: Any, brick: Brick, lock: threading.Lock, **others: Any) -> None:
        self._brick = brick
        self._lock = lock
        super().__init__(*arguments, **others)

    def do_POST(self) -> None:
        """Gives a frame to the brick; the answer is its replies, in hex."""
        frame = bytes.fromhex(self.rfile.read(int(self.headers["Content-Length"])).decode())
        with self._lock:
            replies = self._brick.receive(frame)
            wants_reply = not frame[TYPE_OFFSET] & NO_REPLY
            for _ in range(MOST_STEPS if wants_reply else 0):
                if replies:
                    break
                replies = self._brick.advance(STEP)
        body = json.dumps([reply.hex() for reply in replies]).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing."""


@contextmanager
def served_site(site: Path) -> Iterator[str]:
    """Serves the site with a fresh brick. Yields the address of the playground."""
    with tempfile.TemporaryDirectory() as root:
        handler = partial(Handler, directory=str(site), brick=Brick(root), lock=threading.Lock())
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            yield f"http://127.0.0.1:{server.server_port}/playground/index.html"
            server.shutdown()


class Page(NamedTuple):
    """The page in a browser."""

    browser: Chrome
    address: str

    def open(self, fragment: str = "", *, wait: bool = True) -> None:
        """Opens the page anew."""
        self.browser.get("about:blank")
        self.browser.get(f"{self.address}{fragment}")
        if wait:
            self.wait(lambda: "cannot" in self.text("status") or self.is_ready, 120)
            assert self.is_ready, self.text("status")
            self.wait(lambda: self.is_read)

    def run(self, script: str, *arguments: object) -> Any:
        """Runs a script in the page."""
        return self.browser.execute_script(script, *arguments)

    def text(self, name: str) -> str:
        """Returns all text of an element, shown or not."""
        return str(self.run("return document.getElementById(arguments[0]).textContent", name))

    def texts(self, selector: str) -> list[str]:
        """Returns all text of each element."""
        found: list[str] = self.run(
            "return [...document.querySelectorAll(arguments[0])].map((each) => each.textContent)", selector
        )
        return found

    def is_shown(self, name: str) -> bool:
        """Returns whether an element takes room."""
        return bool(self.run("return document.getElementById(arguments[0]).getClientRects().length > 0", name))

    def wait(self, condition: Callable[[], object], seconds: float = 60) -> None:
        """Waits until a condition holds. The machine may be busy: the time is generous. To ask costs CPU time, too."""
        WebDriverWait(self.browser, seconds, 0.05).until(lambda _: condition())

    @property
    def is_ready(self) -> bool:
        """Whether Python answers."""
        return bool(self.run("return document.body.dataset.ready === 'true'"))

    @property
    def is_read(self) -> bool:
        """Whether all of the input is read: what is shown is neither of an older one nor a part."""
        return self.text("status") == "" and not self.run("return document.body.matches('.stale')")

    @property
    def input(self) -> str:
        """The text in the input."""
        return str(self.browser.find_element(By.ID, "input").get_property("value"))

    def type(self, text: str) -> None:
        """Puts a text into the input, as pasting does."""
        self.run(
            "const input = document.getElementById('input'); input.value = arguments[0];"
            "input.dispatchEvent(new Event('input'))",
            text,
        )

    def read(self, text: str) -> None:
        """Types a text, and waits until it is read, and its frame is made."""
        self.type("")
        self.wait(lambda: self.text("frame") == "" and self.text("tree") == "")
        self.type(text)
        self.wait(lambda: self.is_read and (self.text("frame") or self.text("error")))

    def click(self, name: str) -> None:
        """Clicks an element, wherever it is on the page."""
        element = self.browser.find_element(By.ID, name)
        self.run("arguments[0].scrollIntoView({block: 'center'})", element)
        element.click()

    def pixel(self, x: int, y: int) -> bool:
        """Returns whether a pixel of the display is dark."""
        script = "return document.getElementById('display').getContext('2d').getImageData(...arguments, 1, 1).data[0]"
        return int(self.run(script, x, y)) < 100

    @property
    def connection(self) -> str:
        """The carrier of the real brick."""
        return str(self.run("return document.body.dataset.connection"))

    def fact(self, name: str) -> Any:
        """Returns a fact of the fakes."""
        return self.run("return fake[arguments[0]]", name)

    def steer(self, **facts: object) -> None:
        """Steers the fakes."""
        self.run("Object.assign(fake, arguments[0])", facts)

    def connect(self, carrier: str) -> None:
        """Connects the fake of a brick."""
        self.click(f"connect-{carrier}")
        self.wait(lambda: self.connection == carrier)

    def disconnect(self) -> None:
        """Ends the connection, if there is one."""
        if self.connection != "none":
            self.click("disconnect")
            self.wait(lambda: self.connection == "none" and self.is_shown("connect-usb"))


def fragment(text: str) -> str:
    """Returns the fragment of a link to a text."""
    return f"#text={quote(text)}"


def put_fakes(browser: Chrome) -> None:
    """Has every page of the browser begin with the fakes for USB and Bluetooth."""
    source = FAKES.read_text(encoding="utf-8")
    browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": source})

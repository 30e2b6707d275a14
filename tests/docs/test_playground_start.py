"""How the playground starts: what is seen first, what is loaded, and what is said where a file is missing."""

from __future__ import annotations

import gzip
import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from selenium.webdriver import Chrome
from support.browser import chromium, emulated
from support.effort import effort
from support.frames import drawn
from support.playground import Page, fragment

from ev3proto.testing import frames, mutated_frames

pytest_plugins = ["support.playground_fixtures"]

TONE = "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
LOG = "Sent 0x|08:00|2A:00|00|04:00|81:01:60|\nRecv 0x|07:00|2A:00|02|66:66:F6:40|\n"
OVER = """
    const plain = setTimeout;
    window.areOver = false;
    setTimeout = (then, time, ...given) => {
        if (time !== 15000) return plain(then, time, ...given);
        const turn = setInterval(() => { if (window.areOver) { clearInterval(turn); then(); } }, 20);
        return turn;
    }"""
"""Has 15 seconds be over when `areOver` says so."""
MISSING = """
    const { document, performance } = frames[0];
    const there = performance.getEntriesByType('resource').map(({ name }) => name);
    const files = [...document.querySelectorAll('link[href]:not([rel=icon]), script[src]')];
    return files.map((each) => each.href ?? each.src).filter((each) => !there.includes(each))"""
"""The files of the page in a frame that have not arrived."""


class Line:
    """What happens to files on their way.

    lacking  those that are not there
    held     those that are on their way as long as they are here
    slow     the seconds that a file takes after its first bytes
    instead  other bytes of a file
    """

    def __init__(self) -> None:
        self.lacking: set[str] = set()
        self.held: set[str] = set()
        self.slow: dict[str, float] = {}
        self.instead: dict[str, bytes] = {}


class Handler(SimpleHTTPRequestHandler):
    """The site as a folder, of which a browser keeps nothing."""

    def __init__(self, *given: Any, line: Line, **others: Any) -> None:
        self._line = line
        super().__init__(*given, **others)

    def do_GET(self) -> None:
        """Answers as the line lets it."""
        name = self.path.removeprefix("/playground/")
        while name in self._line.held:
            time.sleep(0.02)
        file = Path(self.directory) / "playground" / name
        if name in self._line.lacking or not file.is_file():
            self.send_error(404)
            return
        data = self._line.instead.get(name, file.read_bytes())
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(name))
        self.send_header("Content-Length", str(len(data)))
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        self.wfile.write(data[:1000])
        time.sleep(self._line.slow.get(name, 0))
        self.wfile.write(data[1000:])

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing."""


@contextmanager
def served(site: Path) -> Iterator[tuple[str, Line]]:
    """Serves the site. Yields the address of the playground, and the line."""
    line = Line()
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Handler, directory=str(site), line=line)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/playground/index.html", line
        line.held.clear()
        server.shutdown()


@pytest.fixture(scope="module")
def visitor(built: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Page, Line]]:
    """A page that is not opened yet, in a browser of its own that keeps nothing, and the line to it."""
    forgetful = "Object.defineProperty(navigator, 'serviceWorker', {value: undefined})"
    with (
        chromium(tmp_path_factory.mktemp("browser") / "profile") as browser,
        served(built) as (address, line),
        before_the_page(browser, forgetful),
    ):
        yield Page(browser, address), line


@contextmanager
def before_the_page(browser: Chrome, script: str) -> Iterator[None]:
    """Has pages begin with a script."""
    put = browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})
    yield
    browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", put)


def says(page: Page, name: str, beginning: str) -> bool:
    """Whether the text of an element begins so."""
    return page.text(name).startswith(beginning)


def has_contents(page: Page, expected: list[str]) -> bool:
    """Whether bytes, header and tree are these."""
    return bool(page.run(CONTENTS) == expected)


# The first frame

WRONG = "0x|08:00|01:00|00|05:00|81:01:61|"
"""It begins as TONE does, without a fault that its bytes alone show; Python finds a variable outside of the memory."""
SHORT = "0x|10:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
"""Its length counts itself."""
LONG = "0x|0C:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
"""Its length is too small: only its headline is there before Python."""

PLACES = (
    "return ['send', 'bytes', 'header', 'tree'].map((id) => document.getElementById(id).getBoundingClientRect().top)"
)
CONTENTS = "return ['bytes', 'header', 'tree'].map((id) => document.getElementById(id).innerHTML)"
FIRST_PIXEL = "return [...document.getElementById('display').getContext('2d').getImageData(0, 0, 1, 1).data]"


def test_nothing_moves_when_python_answers(visitor: tuple[Page, Line]) -> None:
    page, line = visitor
    for width, most in ((1400, 1), (390, 2)):
        with emulated(page.browser, width, 900, is_phone=width < 1000):
            for text in (TONE, WRONG, SHORT, LONG, None):
                line.held = {"worker.js"}
                page.open("" if text is None else fragment(text), wait=False)
                page.wait(lambda: page.text("verdict") == "It is being checked.")
                before, contents = page.run(PLACES), page.run(CONTENTS)
                assert page.run(FIRST_PIXEL) == [210, 217, 195, 255]  # an empty display, not a white one
                line.held = set()
                page.wait(lambda: page.is_ready and page.text("verdict") != "It is being checked.")
                if text in (WRONG, SHORT, LONG):
                    page.wait(lambda: page.texts("#remedies button"))
                moved = [abs(one - other) for one, other in zip(before, page.run(PLACES), strict=True) if one]
                assert max(moved) <= most
                assert text in (SHORT, LONG) or page.run(CONTENTS) == contents
                if text is None:
                    # The example is there as if it were typed, but the page is as good as empty.
                    assert (page.input, page.is_shown("start"), page.browser.current_url) == (TONE, True, page.address)
                    assert page.run("return input.selectionEnd - input.selectionStart") == len(TONE)
                    assert page.run("return Object.keys(sessionStorage)") == []


def test_frames_look_the_same_before_python_is_there_and_after(visitor: tuple[Page, Line]) -> None:
    page, line = visitor
    line.held = {"worker.js"}
    page.open(fragment(TONE), wait=False)
    page.wait(lambda: page.text("verdict") == "It is being checked.")
    count = effort(10, 500)
    given = [each for strategy in (frames(), mutated_frames()) for each in drawn(strategy, count) if len(each) > 4]
    early = {}
    for frame in given:
        page.type(frame.hex())
        if page.run("return document.body.matches('.early')"):
            early[frame] = page.run(CONTENTS)
    assert len(early) > len(given) / 2
    line.held = set()
    page.wait(lambda: page.is_ready)
    for frame, shown in early.items():
        page.type(frame.hex())
        page.wait(lambda: not page.run("return document.body.matches('.stale')"))
        page.wait(partial(has_contents, page, shown))


# Missing files

PYODIDE = tuple(f"pyodide/pyodide.{name}" for name in ("mjs", "asm.js", "asm.wasm"))


def test_each_missing_file_is_named(visitor: tuple[Page, Line], built: Path) -> None:
    page, line = visitor
    index = (built / "playground" / "index.html").read_text(encoding="utf-8")
    own = re.findall(r'(?:href|src)="([\w-]+\.(?:css|m?js))"', index)
    assert {"playground.css", "playground.js"} <= set(own)
    own.remove("missing.js")
    for name in own:
        line.lacking = {name}
        page.open(fragment(TONE), wait=False)
        page.wait(partial(says, page, "late", f"{name} is missing. Reload the page"))
        assert page.is_shown("late")
        assert name.endswith(".css") or page.text("status") == page.text("late")
    for name in ("worker.js", *PYODIDE):
        line.lacking = {name}
        page.open(fragment(TONE), wait=False)
        page.wait(partial(says, page, "status", f"Python cannot be loaded: {name} is missing"))
        # What needs no Python is there all the same.
        assert page.input == TONE
        assert "SOUND.TONE" in page.text("tree")
    # Without the snapshot, Python needs its modules.
    line.lacking = {"snapshot.bin", "snapshot_brotli.bin", "python.zip"}
    page.open(fragment(TONE), wait=False)
    page.wait(lambda: "python.zip is missing (404" in page.text("status"))


def test_a_file_that_is_late_is_named_and_may_still_come(visitor: tuple[Page, Line]) -> None:
    page, line = visitor
    with before_the_page(page.browser, OVER):
        for name in ("worker.js", "pyodide/pyodide.asm.wasm"):
            line.lacking, line.held = set(), {name}
            page.open(fragment(TONE), wait=False)
            page.run("areOver = true")
            page.wait(partial(says, page, "status", f"Still waiting for {name} after 15 seconds"))
            line.held = set()
            page.wait(lambda: page.is_ready and page.text("status") == "")
        # The driver waits for a page as a whole, but not for one inside another.
        line.held = {"playground.js"}
        page.browser.get(page.address.replace("index.html", "licences.txt"))
        page.run(
            "document.body.append(document.createElement('iframe')); frames[0].location = arguments[0]", page.address
        )
        page.wait(lambda: [each.rpartition("/")[2] for each in page.run(MISSING)] == ["playground.js"])
        page.run("frames[0].areOver = true")
        said = "return frames[0].document.getElementById('status').textContent"
        page.wait(lambda: str(page.run(said)).startswith("playground.js has not arrived after 15 seconds"))
        line.held = set()
        page.wait(lambda: page.run("return frames[0].document.body.dataset.begun"))


def test_all_that_is_loaded_is_counted(visitor: tuple[Page, Line]) -> None:
    page, line = visitor
    line.lacking = set()
    watch = """
        addEventListener('DOMContentLoaded', () => {
            const status = document.getElementById('status');
            window.said = [];
            new MutationObserver(() => said.push(status.textContent)).observe(status, {childList: true});
        })"""
    with before_the_page(page.browser, watch):
        page.open()
    said: list[str] = page.run("return said")
    left = [float(found[1]) for each in said if (found := re.match(r"Loading Python: ([\d.]+) MB left", each))]
    assert left == sorted(left, reverse=True)
    assert left[0] > 14
    assert left[-1] < 3, left
    assert "Starting Python …" in said


def test_python_starts_from_a_snapshot_or_without_it_all_the_same(visitor: tuple[Page, Line], built: Path) -> None:
    page, line = visitor
    snapshot = (built / "playground" / "snapshot.bin").read_bytes()
    other = bytearray(gzip.decompress(snapshot))
    other[16] ^= 1  # a byte of Pyodide's build number, which its snapshots begin with
    harmed = [gzip.compress(other, 1), b"", snapshot[: len(snapshot) // 2]]
    for data in (snapshot, *harmed[: effort(1, 3)]):
        line.instead = {} if data == snapshot else dict.fromkeys(("snapshot.bin", "snapshot_brotli.bin"), data)
        page.open(fragment(TONE))
        assert page.run("return document.body.dataset.started") == ("snapshot" if data == snapshot else "plain")
        page.wait(lambda: page.text("frame") == TONE)
        page.read(LOG)
        page.click("send")
        page.wait(lambda: "UI_READ.GET_VBATT" in page.text("talks"))
    line.instead = {}


def test_on_a_slow_line_the_snapshot_comes_for_the_next_visit(built: Path, tmp_path: Path) -> None:
    with chromium(tmp_path / "profile") as browser, served(built) as (address, line):
        line.slow = {"pyodide/pyodide.asm.js": 2}
        page = Page(browser, address)
        page.open()
        assert page.run("return document.body.dataset.started") == "plain"
        active = "return navigator.serviceWorker.ready.then((it) => it.active.state)"
        page.wait(lambda: page.run(active) == "activated", 120)
        page.open()
        assert page.run("return document.body.dataset.started") == "snapshot"

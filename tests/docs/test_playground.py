"""The playground, as it is built: in a real browser, on a phone's window and a desktop's."""

from __future__ import annotations

import http.server
import json
import os
import re
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

import pytest
from selenium.webdriver import Chrome, Keys
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select, WebDriverWait
from support.browser import chromium, complaints, scrolls_sideways
from support.cli import run_ev3proto
from support.site import built_site

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "captures"
TONE = "0e002a0080000094010182b80182e803"
HOSTILE = "<img src=x onerror=alert(1)> 0e002a0080000094010182b80182e803 <script>alert(1)</script>"


def printed(*words: str | Path) -> str:
    """What the command line prints."""
    done = run_ev3proto(*words)
    assert (done.returncode, done.stderr) == (0, b"")
    return done.stdout.decode()


class _Silent(http.server.SimpleHTTPRequestHandler):
    def log_message(self, format: str, *arguments: object) -> None:
        pass


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The documentation, as it is built."""
    return built_site(tmp_path_factory)


@pytest.fixture(scope="module")
def address(built: Path) -> Iterator[str]:
    """The site, served as a folder is by Python."""
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), partial(_Silent, directory=str(built))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/playground/index.html"
        server.shutdown()


class Page(NamedTuple):
    """The page in a browser."""

    browser: Chrome

    def text(self, name: str) -> str:
        """All text of an element, shown or not."""
        return str(self.browser.execute_script("return document.getElementById(arguments[0]).textContent", name))

    def wait(self, condition: Callable[[], object], seconds: float = 30) -> None:
        WebDriverWait(self.browser, seconds, 0.02).until(lambda _: condition())

    @property
    def is_ready(self) -> bool:
        return bool(self.browser.execute_script("return document.body.dataset.ready === 'true'"))

    def type(self, text: str) -> None:
        """Puts a text into the input, as pasting does."""
        self.browser.execute_script(
            "const input = document.getElementById('input'); input.value = arguments[0];"
            "input.dispatchEvent(new Event('input'))",
            text,
        )

    def click(self, name: str) -> None:
        self.browser.find_element(By.ID, name).click()

    def pixel(self, x: int, y: int) -> bool:
        """Whether a pixel of the display is dark."""
        script = "return document.getElementById('display').getContext('2d').getImageData(...arguments, 1, 1).data[0]"
        return int(self.browser.execute_script(script, x, y)) < 100

    @property
    def input(self) -> str:
        return str(self.browser.find_element(By.ID, "input").get_property("value"))


@contextmanager
def opened(address: str, folder: Path, *, width: int = 1400) -> Iterator[Page]:
    with chromium(folder / "profile", width) as browser:
        page = Page(browser)
        begin = time.monotonic()
        browser.get(address)
        page.wait(lambda: "cannot" in page.text("status") or page.is_ready, 60)
        assert page.is_ready, page.text("status")
        # Other tests run beside this one; alone it takes 3 s.
        assert time.monotonic() - begin < 30
        yield page
        assert complaints(browser) == []


@pytest.mark.parametrize("width", [390, 1400])
def test_a_link_opens_with_its_frame_read(address: str, tmp_path: Path, width: int) -> None:
    with opened(f"{address}#text={TONE}", tmp_path, width=width) as page:
        page.wait(lambda: page.text("tree"))
        assert page.text("tree") == printed("decode", TONE)
        assert page.text("findings") == printed("check", TONE)
        assert page.text("frame") == "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
        assert page.text("hex") == "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"
        assert page.text("javascript").startswith("const frame = new Uint8Array([0x0e, 0x00, 0x2a,")
        assert "unsigned char" in page.text("c")
        assert "b'" in page.text("python")
        assert page.text("error") == ""
        assert page.text("leds") == "LED_GREEN"
        assert not scrolls_sideways(page.browser)


def test_what_is_typed_is_read_and_stands_in_the_link(address: str, tmp_path: Path) -> None:
    with opened(address, tmp_path) as page:
        page.type("UI_WRITE(LED, LED_RED)")
        page.wait(lambda: page.text("frame") == "0x|08:00|00:00|80|00:00|82:1B:02|")
        assert page.browser.current_url.endswith("#text=" + quote("UI_WRITE(LED, LED_RED)", safe="()"))
        page.type("UI_WRITE(LED, LED_RDE)")
        page.wait(lambda: "did you mean LED_RED" in page.text("error"))
        assert page.text("tree") == page.text("frame") == ""
        page.type("09:00|2A:00|80|00:00|81|01|60|")
        page.wait(lambda: "error[E102]" in page.text("findings"))
        page.browser.find_element(By.CSS_SELECTOR, "#findings summary").click()
        page.wait(lambda: "the length field" in page.text("findings").partition("What E102 means")[2])
        page.click("fix")
        page.wait(lambda: page.input == "0x|08:00|2A:00|00|04:00|81:01:60|")
        page.wait(lambda: page.text("findings") == "accepted: no findings\n")
        page.type("")
        page.wait(lambda: page.text("tree") == "")
        assert "#" not in page.browser.current_url


def test_the_tutorial_begins_with_what_the_page_shows(address: str, tmp_path: Path) -> None:
    tutorial = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
    (fragment,) = re.findall(r'href="playground/index.html(#text=[^"]+)"', tutorial)
    shown = tutorial.partition("```text\n")[2].partition("```")[0]
    with opened(address + fragment, tmp_path) as page:
        page.wait(lambda: page.text("tree"))
        assert f"\n    {page.input}\n" in tutorial
        assert page.text("tree") == shown
        frame = page.input
        page.type(frame.replace("0E", "0F", 1))
        page.wait(lambda: "error[E102]" in page.text("findings"))
        page.click("fix")
        page.wait(lambda: page.input == frame)
        page.type("UI_WRITE(LED, LED_ORANGE)")
        page.wait(lambda: page.text("c"))
        page.click("send")
        page.wait(lambda: page.text("leds") == "LED_ORANGE")


def test_lines_mark_their_bytes_and_bytes_their_lines(address: str, tmp_path: Path) -> None:
    with opened(f"{address}#text={TONE}", tmp_path) as page:
        page.wait(lambda: page.text("tree"))

        def chosen(name: str) -> str:
            return "".join(each.text for each in page.browser.find_elements(By.CSS_SELECTOR, f"#{name} .chosen"))

        tree = page.browser.find_element(By.ID, "tree")
        tree.send_keys(Keys.ARROW_DOWN)
        assert (chosen("tree").split()[1], chosen("bytes")) == ("SOUND.TONE", "94010182B80182E803")
        page.browser.find_elements(By.CSS_SELECTOR, "#bytes span")[11].click()
        assert (chosen("tree").split()[1], chosen("bytes")) == ("FREQUENCY", "82B801")
        page.browser.find_element(By.ID, "bytes").send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        assert (chosen("tree").split()[1], chosen("bytes")) == ("DURATION", "82E803")


def test_completion(address: str, tmp_path: Path) -> None:
    with opened(address, tmp_path) as page:
        field = page.browser.find_element(By.ID, "input")
        field.send_keys("sound.to")
        page.wait(lambda: "SOUND(TONE, VOLUME, FREQUENCY, DURATION)" in page.text("words"))
        field.send_keys(Keys.ARROW_DOWN, Keys.ENTER)
        page.wait(lambda: page.input == "SOUND(TONE, ")
        field.send_keys("1, ")
        page.wait(lambda: "FREQUENCY: pitch" in page.text("words"))
        field.send_keys("440, 1000)", Keys.ENTER, "UI_WRITE(LED, LED_GREEN_F")
        page.wait(lambda: page.text("words").startswith("LED_GREEN_FLASH"))
        field.send_keys(Keys.ARROW_DOWN, Keys.TAB, ")")
        page.wait(lambda: "82:1B:04" in page.text("frame"))


def test_the_lesson_draws_its_triangle(address: str, tmp_path: Path) -> None:
    with opened(address, tmp_path) as page:
        lesson = Select(page.browser.find_element(By.ID, "lesson"))
        assert len(lesson.options) == 20
        lesson.select_by_visible_text("A triangle, timed by the brick")
        page.wait(lambda: "opUI_DRAW, LC0(LINE)" in page.input)
        page.wait(lambda: page.text("tree"))
        page.click("send")
        page.wait(lambda: page.pixel(2, 125) and page.pixel(88, 2))
        page.wait(lambda: page.pixel(174, 125))
        assert "UI_DRAW.LINE" in page.text("talks")
        assert not page.pixel(88, 60)
        lesson.select_by_visible_text("Tones and lights")
        page.wait(lambda: "LED" in page.input)
        page.click("send")
        page.wait(lambda: page.text("leds") == "LED_RED")


def test_files(address: str, tmp_path: Path) -> None:
    source = ROOT / "tests" / "support" / "sources" / "menu.lms"
    image = tmp_path / "menu.rbf"
    assert run_ev3proto("encode", source, "-o", image).returncode == 0
    with opened(address, tmp_path) as page:
        file = page.browser.find_element(By.ID, "file")
        file.send_keys(str(CAPTURES / "ev3_dc.pcap"))
        page.wait(lambda: "received beacon" in page.text("tree"))
        shown, _, rest = page.text("tree").partition("... and ")
        assert printed("decode", CAPTURES / "ev3_dc.pcap").startswith(shown)
        assert (len(shown) > 190_000, rest.split(" ", 1)[1]) == (
            True,
            "more lines; ev3proto on the command line shows all\n",
        )
        page.browser.find_element(By.CSS_SELECTOR, "#dialogues summary").click()
        row = [each.text for each in page.browser.find_elements(By.CSS_SELECTOR, "#dialogues tbody tr:nth-child(2) td")]
        assert row[0] == "0.004973"
        assert row[1].endswith("COM_GET.GET_NETWORK(HARDWARE=HW_WIFI, LENGTH=42, NAME=GV(0), MAC=GV(42), IP=GV(84))")
        assert row[2:] == ['NAME="ev3proto", MAC="44:49:94:0F:0C:1E", IP="127.0.0.1"', "0.273 ms"]
        page.browser.find_element(By.CSS_SELECTOR, "#timeline summary").click()
        page.wait(lambda: page.browser.find_elements(By.CSS_SELECTOR, "#timeline canvas"))
        assert int(page.browser.find_element(By.CSS_SELECTOR, "#timeline canvas").size["height"]) > 300
        file.send_keys(str(image))
        page.wait(lambda: "vmthread" in page.text("tree"))
        file.send_keys(str(source))
        page.wait(lambda: page.input == source.read_text(encoding="utf-8"))
        page.wait(lambda: "vmthread" in page.text("tree"))
        page.click("send")
        page.wait(lambda: page.pixel(8, 109))
        assert page.text("error") == ""
        assert "a ; means nothing: it is omitted (warning)" in page.text("findings")


def test_hostile_text_stays_text(address: str, tmp_path: Path) -> None:
    with opened(f"{address}#text={quote(HOSTILE)}", tmp_path) as page:
        page.wait(lambda: page.text("tree"))
        assert page.input == HOSTILE
        page.type(HOSTILE.replace("0e002a", "0f002a"))
        page.wait(lambda: page.text("error"))
        page.type('UI_DRAW(<script>, "<img src=x>", 1)')
        page.wait(lambda: "<script>" in page.text("error"))
        assert page.browser.find_elements(By.CSS_SELECTOR, "main img, main script, main b") == []


def test_nothing_inline_and_nothing_from_elsewhere(built: Path) -> None:
    page = (built / "playground" / "index.html").read_text(encoding="utf-8")
    assert "default-src 'none'" in page
    assert "unsafe" not in page
    assert not re.search(r"<script(?![^>]*src=)|<style|\sstyle=|\son\w+=", page)
    own = [each for each in (built / "playground").iterdir() if each.suffix in (".html", ".js", ".css")]
    assert len(own) == 6
    for file in own:
        assert "//" not in re.sub(r"^ *//.*$| // .*$", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE), file
    lesson: list[Any] = json.loads((built / "playground" / "lesson.json").read_text(encoding="utf-8"))
    assert lesson[0]["title"].startswith("Setting the name of the brick")


def test_the_licences_of_what_it_contains_are_there_in_full(built: Path) -> None:
    text = (built / "playground" / "licences.txt").read_text(encoding="utf-8")
    parts = text.split(f"\n{'-' * 80}\n")
    entries = {
        title.split()[0]: licence
        for titles, licence in zip(parts[1::2], parts[2::2], strict=True)
        for title in titles.splitlines()
    }
    assert "Mozilla Public License Version 2.0" in entries["pyodide"]
    assert "3.2. Distribution of Executable Form" in entries["pyodide"]
    assert "github.com/pyodide/pyodide" in text
    assert "PYTHON SOFTWARE FOUNDATION LICENSE" in entries["Python"]
    for name, owner in {
        "vega": "University of Washington Interactive Data Lab",
        "vega-lite": "University of Washington Interactive Data Lab",
        "d3-array": "Mike Bostock",
        "construct": "Arkadiusz Bulski",
        "click": "Pallets",
        "dpkt": "Dug Song",
        "ev3proto": "MIT License",
    }.items():
        assert owner in entries[name], name
    page = (built / "playground" / "index.html").read_text(encoding="utf-8")
    assert '<a href="licences.txt">' in page


def test_its_python_runs_here_too() -> None:
    command = [sys.executable, "-c", f"import bridge; print(bridge.look({TONE!r}))"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "docs" / "playground")}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["lines"][3] == [
        "    10    FREQUENCY = 440 Hz  LC2: pitch; the driver clamps it to the range",
        0,
        10,
        3,
    ]


def test_without_npm_the_rest_can_be_built(tmp_path: Path) -> None:
    (tmp_path / "index.rst").write_text("Title\n=====\n")
    environment = {**os.environ, "PATH": "/nowhere", "PYTHONPATH": str(ROOT / "docs")}
    command = [sys.executable, "-m", "sphinx", "-q", "-C", "-D", "extensions=playground.build"]

    def build(*options: str) -> subprocess.CompletedProcess[str]:
        arguments = [*command, *options, str(tmp_path), str(tmp_path / "site")]
        return subprocess.run(arguments, env=environment, capture_output=True, text=True, check=False)

    refused = build()
    assert refused.returncode != 0
    assert "npm is not installed, which the playground needs; -t no_playground builds the rest" in refused.stderr
    done = build("-t", "no_playground")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "site" / "index.html").exists()

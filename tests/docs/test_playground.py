"""The playground, as it is built: in a real browser, on a phone's window and a desktop's."""

from __future__ import annotations

import base64
import json
import os
import random
import re
import struct
import subprocess
import sys
import time
import zlib
from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import quote, urljoin
from urllib.request import urlopen

import pytest
from playground.bridge import watching
from playground.bridge.words import _LINKS
from selenium.common.exceptions import TimeoutException
from selenium.webdriver import ActionChains, Chrome, Keys
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select
from support.browser import chromium, complaints, emulated, scrolls_sideways
from support.cases import each
from support.cli import run_ev3proto
from support.pictures import PLAYGROUND, open_playground
from support.playground import Page, fragment, put_fakes, served_site

from ev3proto.generate.captures.packets import write_pcapng

pytest_plugins = ["support.playground_fixtures"]

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "captures"
TONE = "0e002a0080000094010182b80182e803"
HOSTILE = "<img src=x onerror=alert(1)> 0e002a0080000094010182b80182e803 <script>alert(1)</script>"
LOG = """\
# Lesson 2, at home
09:12:31.011558 Sent 0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|
09:12:31.5 Sent 0x|08:00|01:00|00|01:00|81:01:60|
09:12:31.6 Recv 0x|07:00|01:00|02|66:66:F6:40|
"""
BATTERY = "0x|08:00|2A:00|00|04:00|81:01:60|"


def printed(*words: str | Path) -> str:
    """What the command line prints."""
    done = run_ev3proto(*words)
    assert (done.returncode, done.stderr) == (0, b"")
    return done.stdout.decode()


@pytest.fixture(scope="module")
def loaded(browser: Chrome, address: str) -> Page:
    """The page, loaded once."""
    page = Page(browser, address)
    page.open()
    return page


@pytest.fixture
def page(loaded: Page) -> Iterator[Page]:
    """The loaded page, with an empty input and without a real brick."""
    loaded.disconnect()
    loaded.run("fake.sent.length = 0")
    loaded.steer(isRefused=False, isSilent=False, isUnplugged=False, isBusy=False, isHeld=False, requests=0)
    loaded.type("")
    loaded.wait(lambda: loaded.text("tree") == "" and loaded.is_read)
    complaints(loaded.browser)
    yield loaded
    assert complaints(loaded.browser) == []


# The input


def test_a_link_opens_with_its_frame_read_on_a_phone(browser: Chrome, address: str) -> None:
    with emulated(browser, 390, 900, is_phone=True):
        page = Page(browser, address)
        page.open(fragment(TONE))
        _look_at_the_tone(page)
        _look_at_a_phone(page)
        assert complaints(browser) == []


def test_the_picture_of_the_playground_shows_what_it_says(browser: Chrome, address: str) -> None:
    text = PLAYGROUND.with_suffix(".txt").read_text(encoding="utf-8")
    assert open_playground(Page(browser, address)) == text, "run docs/pictures, and look at the picture"


def test_a_link_opens_with_its_frame_read(page: Page) -> None:
    page.run("location.hash = arguments[0]", fragment(TONE))
    _look_at_the_tone(page)


def _look_at_the_tone(page: Page) -> None:
    page.wait(lambda: page.text("verdict") == "The brick takes it.")
    assert page.text("tree") == printed("decode", TONE)
    assert page.text("findings") == ""
    assert page.text("frame") == "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"
    assert page.text("hex") == "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"
    assert page.text("javascript").startswith("const frame = new Uint8Array([0x0e, 0x00, 0x2a,")
    assert "unsigned char" in page.text("c")
    assert "b'" in page.text("python")
    assert page.text("error") == ""
    page.wait(lambda: page.text("leds"))
    assert not scrolls_sideways(page.browser)


def _look_at_a_phone(page: Page) -> None:
    """What can be tapped is large enough."""
    small = """
        return [...document.querySelectorAll('button, select, summary, nav a, #bytes [data-at], #tree [role]')]
            .filter((each) => each.getClientRects().length && each.getBoundingClientRect().height < 44)
            .map((each) => each.outerHTML)"""
    assert page.run(small) == []
    assert not scrolls_sideways(page.browser)


def test_what_is_typed_is_read_and_is_in_the_link(page: Page) -> None:
    page.type("UI_WRITE(LED, LED_RED)")
    page.wait(lambda: page.text("frame") == "0x|08:00|00:00|80|00:00|82:1B:02|")
    assert page.browser.current_url.endswith("#text=" + quote("UI_WRITE(LED, LED_RED)", safe="()"))
    page.type("UI_WRITE(LED, LED_RDE)")
    page.wait(lambda: "did you mean LED_RED" in page.text("error"))
    assert page.text("error").splitlines()[1:] == ["  UI_WRITE(LED, LED_RDE)", "                ^"]
    assert page.text("tree") == page.text("frame") == ""
    page.type("09:00|2A:00|80|00:00|81|01|60|")
    page.wait(lambda: "error[E102]" in page.text("findings"))
    page.browser.find_element(By.CSS_SELECTOR, "#findings summary").click()
    page.wait(lambda: "the length field" in page.text("findings").partition("What E102 means")[2])
    page.browser.find_element(By.CSS_SELECTOR, "#remedies button").click()
    page.wait(lambda: page.input == "0x|08:00|2A:00|00|04:00|81:01:60|")
    page.wait(lambda: page.text("verdict") == "The brick takes it." and page.text("findings") == "")
    page.type("")
    page.wait(lambda: page.text("tree") == "")
    assert "#" not in page.browser.current_url
    for name in ("check", "read", "make", "say"):
        assert not page.is_shown(name)


@pytest.mark.parametrize(
    ("text", "button", "frame"),
    [
        ("94 01 01 82 B8 01 82 E8 03", "Add a header", "0x|0E:00|00:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"),
        (
            "2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03",
            "Add the length",
            "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|",
        ),
        ("08 00 2A O0 00 04 00 81 0l 60", "Read O as 0 and l as 1", "0x|08:00|2A:00|00|04:00|81:01:60|"),
        (
            "0x|08:00|01:00|00|01:00|81:01:60|",
            "Request 4 bytes of global and 0 of local memory",
            "0x|08:00|01:00|00|04:00|81:01:60|",
        ),
    ],
)
def test_buttons_offer_what_was_meant(page: Page, text: str, button: str, frame: str) -> None:
    page.type(text)
    page.wait(lambda: page.texts("#remedies button") == [button])
    assert "--" not in page.text("error")
    page.browser.find_element(By.CSS_SELECTOR, "#remedies button").click()
    page.wait(lambda: page.input == frame)
    page.wait(lambda: page.text("verdict") == "The brick takes it.")
    page.wait(lambda: page.texts("#remedies button") == [])


def test_buttons_offer_what_was_meant_in_the_lines_of_a_log(page: Page) -> None:
    log = """\
09:12:31.0 Sent 0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|
09:12:31.5 Sent 0x|08:00|01:00|00|01:00|81:01:60|
09:12:31.6 Recv 0x|07:00|01:00|02|66:66:F6:40|
09:12:31.7 Sent 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03
"""
    memory = "Line 2: Request 4 bytes of global and 0 of local memory"
    page.type(log)
    page.wait(lambda: page.texts("#remedies button") == [memory, "Line 4: Add the length"])
    page.browser.find_elements(By.CSS_SELECTOR, "#remedies button")[1].click()
    whole = log.replace("2A 00 80 00 00 94 01 01 82 B8", "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8").replace(
        "82:B8 01 82 E8 03", "82:B8:01:82:E8:03|"
    )
    page.wait(lambda: page.input == whole)
    page.wait(lambda: page.texts("#remedies button") == [memory])
    page.browser.find_element(By.CSS_SELECTOR, "#remedies button").click()
    page.wait(lambda: page.input == whole.replace("01:00|00|01:00", "01:00|00|04:00"))
    page.wait(lambda: page.texts("#remedies button") == [])


def test_the_tutorial_begins_with_what_the_page_shows(page: Page) -> None:
    tutorial = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
    (link,) = re.findall(r'href="playground/index.html(#text=[^"]+)"', tutorial)
    shown = tutorial.partition("```text\n")[2].partition("```")[0]
    page.run("location.hash = arguments[0]", link)
    page.wait(lambda: page.text("tree") and page.is_read)
    assert f"\n    {page.input}\n" in tutorial
    assert page.text("tree") == shown
    frame = page.input
    page.type(frame.replace("0E", "0F", 1))
    page.wait(lambda: page.texts("#remedies button") == ["Set the length to 14"])
    page.browser.find_element(By.CSS_SELECTOR, "#remedies button").click()
    page.wait(lambda: page.input == frame)
    page.type("UI_WRITE(LED, LED_ORANGE)")
    page.wait(lambda: page.text("c"))
    page.click("send")
    page.wait(lambda: page.text("leds") == "LED_ORANGE")
    assert page.text("answer") == "UI_WRITE.LED(PATTERN=LED_ORANGE)\n"


def test_a_fix_changes_the_line_that_it_fixes_and_can_be_undone(page: Page) -> None:
    field = page.browser.find_element(By.ID, "input")
    log, fixed = (LOG.replace("08:00|01:00|00|01:00", f"{length}:00|01:00|00|04:00") for length in ("0A", "08"))
    page.type(log)
    page.wait(lambda: page.texts("#remedies button") == ["Line 3: Set the length to 8"])
    page.browser.find_element(By.CSS_SELECTOR, "#remedies button").click()
    page.wait(lambda: page.input == fixed)
    page.wait(lambda: page.texts("#remedies button") == [])
    field.send_keys(Keys.CONTROL, "z")
    page.wait(lambda: page.input == log)
    page.wait(lambda: page.texts("#remedies button"))
    # Without anything to fix, or in assembly, there is nothing to press.
    for text in (TONE, "UI_READ(GET_VBATT, GV0(1))"):
        page.read(text)
        page.wait(lambda: page.text("verdict"))
        assert page.texts("#remedies button") == []


def test_choosing_an_example_can_be_undone(page: Page) -> None:
    field = page.browser.find_element(By.ID, "input")
    field.send_keys("UI_WRITE(LED, LED_RED) // mine")
    Select(page.browser.find_element(By.ID, "lesson")).select_by_visible_text("Tones and lights")
    page.wait(lambda: "// mine" not in page.input and "opUI_WRITE" in page.input)
    field.send_keys(Keys.CONTROL, "z")
    page.wait(lambda: page.input == "UI_WRITE(LED, LED_RED) // mine")


def test_an_empty_page_offers_three_examples(page: Page) -> None:
    titles = page.texts("#start button")
    assert len(titles) == 3
    for title in titles:
        page.type("")
        page.wait(lambda: page.is_shown("start") and page.text("tree") == "")
        page.browser.find_element(By.XPATH, f"//button[text()='{title}']").click()
        page.wait(lambda: page.text("tree"))
        page.wait(lambda: page.text("verdict"))
        if "mistake" in title:
            page.wait(lambda: page.texts("#remedies button"))
        assert (page.text("error"), page.is_shown("start")) == ("", False)


def test_findings_come_first_by_line_errors_before_warnings(page: Page) -> None:
    warning, error = "0x|0E:00|2A:00|80|00:00|94:01:01:82:0A:00:82:E8:03|", "0x|08:00|01:00|00|01:00|81:01:60|"
    page.read("\n".join([TONE] * 3 + [warning, error] + [TONE] * 16 + [error]))
    places = [found for text in page.texts("#findings .finding") for found in re.findall(r"--> line (\d+),", text)]
    assert places == ["5", "22", "4"]
    assert page.text("sentence") == "A log of 22 frames."
    # Choosing a finding selects its line.
    page.browser.find_elements(By.CSS_SELECTOR, "#findings .error")[1].click()
    assert page.run("return input.value.slice(input.selectionStart, input.selectionEnd)") == error


def test_findings_come_before_the_tree_and_beside_the_brick(page: Page) -> None:
    page.type("0x|08:00|01:00|00|05:00|81:01:61|")
    page.wait(lambda: page.text("findings"))
    tops = page.run(
        "return ['write', 'check', 'read', 'make', 'display'].map((id) => {"
        " const box = document.getElementById(id).getBoundingClientRect(); return [box.left, box.top]; })"
    )
    lefts, heights = zip(*tops, strict=True)
    assert list(heights[:4]) == sorted(heights[:4])
    assert len(set(lefts[:4])) == 1
    assert lefts[4] > 700
    page.run("scrollTo(0, document.body.scrollHeight)")
    assert page.run("return document.getElementById('display').getBoundingClientRect().bottom > 100")
    # Long lines of help wrap.
    assert page.run("return findings.scrollWidth <= findings.clientWidth")


# Marks


def test_lines_mark_their_bytes_and_bytes_their_lines(page: Page) -> None:
    page.read(TONE)

    def chosen(name: str) -> str:
        return "".join(each.text for each in page.browser.find_elements(By.CSS_SELECTOR, f"#{name} .chosen"))

    tree = page.browser.find_element(By.ID, "tree")
    tree.send_keys(Keys.ARROW_DOWN)
    assert (chosen("tree").split()[1], chosen("bytes")) == ("SOUND.TONE", "94010182B80182E803")
    page.browser.find_element(By.CSS_SELECTOR, "#bytes [data-at='11']").click()
    assert (chosen("tree").split()[1], chosen("bytes")) == ("FREQUENCY", "82B801")
    page.browser.find_element(By.ID, "bytes").send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
    assert (chosen("tree").split()[1], chosen("bytes")) == ("DURATION", "82E803")
    # Pointing marks for as long as it lasts.
    page.run("scrollTo(0, 0)")
    ActionChains(page.browser).move_to_element(page.browser.find_elements(By.CSS_SELECTOR, "#tree [role]")[2]).perform()
    assert (chosen("tree").split()[1], chosen("bytes")) == ("VOLUME", "01")
    ActionChains(page.browser).move_to_element(page.browser.find_element(By.TAG_NAME, "h1")).perform()
    assert (chosen("tree").split()[1], chosen("bytes")) == ("DURATION", "82E803")
    assert page.texts("#bytes i") == ["0000"]
    assert page.texts("#bytes code") == ["··*·············"]
    links = page.run("return [...document.querySelectorAll('#tree a')].map((each) => each.getAttribute('href'))")
    assert links == ["../reference/sound.html#sound-tone"]


def test_a_finding_marks_its_bytes_and_its_line(page: Page) -> None:
    page.read("0x|08:00|01:00|00|05:00|81:01:61|")
    finding = page.browser.find_element(By.CSS_SELECTOR, "#findings .error")
    ActionChains(page.browser).move_to_element(finding).perform()
    assert page.texts("#bytes .chosen") == ["61"]
    assert page.texts("#tree .chosen") == ["     9    VALUE = GV(1)  GV0: voltage\n"]
    page.browser.find_element(By.CSS_SELECTOR, "#bytes [data-at='9']").click()
    assert "chosen" in str(finding.get_attribute("class"))


def test_the_headline_is_one_region_under_the_input(page: Page) -> None:
    colours = []
    for text, said in (
        (TONE, ["takes", ""]),
        ("0x|0E:00|2A:00|80|00:00|94:01:01:82:0A:00:82:E8:03|", ["takes", "warning"]),
        ("0x|08:00|01:00|00|05:00|81:01:61|", ["refuses", "error"]),
        ("03 00 2A 00 04", ["none", ""]),
    ):
        page.read(text)
        assert page.run("return [verdict.dataset.kind, verdict.dataset.severity]") == said
        colours.append(page.run("return getComputedStyle(verdict).color"))
    assert len(set(colours)) == 4
    page.read(f"{TONE}\n0x|zz:00|\n")
    assert "but not all" in page.text("verdict")
    assert page.texts("#say[role=status] > *") == [page.text(name) for name in ("sentence", "verdict", "error")]
    assert page.run("return say.getBoundingClientRect().top - sheet.getBoundingClientRect().bottom") < 30
    # Of several frames, the chosen one has a sentence of its own.
    page.read(LOG)
    page.wait(lambda: page.text("about") == "Plays 440 Hz for 1 s at volume 1 %.")
    assert page.text("sentence") == "A log of 3 frames: 2 commands and 1 reply."


def test_the_headline_of_a_program_says_where_it_runs(page: Page) -> None:
    page.type("vmthread MAIN\n{\n  UI_WRITE(LED, LED_RED)\n}\n")
    page.wait(lambda: page.text("sentence") == "A program of 1 object and 32 bytes.")
    page.click("send")
    page.wait(lambda: page.text("note") == "Sent to the virtual brick, which runs it.")


def test_each_byte_of_the_header_explains_itself(page: Page) -> None:
    page.read("0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|")
    page.wait(lambda: len(page.texts("#header [role=treeitem]")) == 4)
    assert [row.split()[:2] for row in page.texts("#header [role=treeitem]")] == [
        ["0", "length"],
        ["2", "counter"],
        ["4", "type"],
        ["5", "memory"],
    ]
    colours = page.run(
        "return ['length', 'counter', 'type', 'memory'].map((name) =>"
        " [...document.querySelectorAll(`.field-${name}`)].map((each) => getComputedStyle(each).backgroundColor))"
    )
    assert all(len(set(each)) == 1 for each in colours)
    assert len({each[0] for each in colours}) == 4
    # Each byte is marked together with its row and its digits in the input, and says what it is.
    for at, byte in enumerate(bytes.fromhex(TONE)):
        page.browser.find_element(By.CSS_SELECTOR, f"#bytes [data-at='{at}']").click()
        assert page.text("byte").startswith(f"Byte {at}: 0x{byte:02X}")
        assert len(page.texts("#tree .chosen, #header .chosen")) == 1
        assert page.texts("#paint .chosen") == page.texts("#bytes .chosen") != []
    page.browser.find_element(By.CSS_SELECTOR, "#bytes [data-at='10']").click()
    assert page.text("byte") == "Byte 10: 0x82 = 1 0 0 0 0 010, long constant, 2 bytes after it (LC2): FREQUENCY = 440"
    page.browser.find_element(By.CSS_SELECTOR, "#header [data-part='1']").click()
    assert page.texts("#bytes .chosen") == page.texts("#paint .chosen") == ["2A", "00"]


class _Ids(HTMLParser):
    """The ids of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.found: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Takes an element."""
        self.found |= {value for name, value in attrs if name == "id" and value}


def test_every_operation_has_its_place_in_the_reference(built: Path) -> None:
    pages: dict[str, set[str]] = {}
    for name, link in _LINKS.items():
        page, _, anchor = link.partition("#")
        if page not in pages:
            parser = _Ids()
            parser.feed((built / "reference" / page).read_text(encoding="utf-8"))
            pages[page] = parser.found
        assert anchor in pages[page], name
    assert len(_LINKS) > 300


# Completion


def test_completion(page: Page) -> None:
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


@pytest.mark.parametrize(
    ("wrong", "rest", "right"),
    [
        ("UI_WRTE", "(LED, 1)", "UI_WRITE"),
        ("SOUND(TOEN", ", 1, 440, 1000)", "TONE"),
        ("UI_WRITE(LED, LED_RDE", ")", "LED_RED"),
    ],
)
def test_a_misspelt_name_is_completed_as_the_error_says(page: Page, wrong: str, rest: str, right: str) -> None:
    page.browser.find_element(By.ID, "input").send_keys(wrong)
    page.wait(lambda: page.text("words").startswith(f"{right}: did you mean this?"))
    page.type(wrong + rest)
    page.wait(lambda: f"did you mean {right}" in page.text("error"))


# Links


def test_long_texts_are_deflated_in_the_address(page: Page) -> None:
    long = "\n".join(f"# line {number}\n{TONE}" for number in range(200))
    for _ in range(5):
        # A browser drops changes of the address that come too often, as after the tests before this one.
        page.type(long)
        with suppress(TimeoutException):
            page.wait(lambda: "#z=" in page.browser.current_url, 15)
            break
    packed = page.browser.current_url.partition("#z=")[2]
    assert len(page.browser.current_url) < 8192
    assert zlib.decompress(base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4)), -15).decode() == long
    page.type("")
    page.wait(lambda: "#" not in page.browser.current_url)
    page.run("location.hash = arguments[0]", f"#z={packed}")
    page.wait(lambda: page.input == long)
    # What is too long for a link is not in the address, and a sentence says so.
    noise = random.Random(1).randbytes(8000).hex()
    page.type(noise)
    page.wait(lambda: "#" not in page.browser.current_url)
    page.click("link")
    page.wait(lambda: "too long for a link" in page.text("note"))


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (zlib.compress(bytes(1 << 24), wbits=-15), "more than 1 MiB"),
        (b"\xff\xff\xff", "The link is damaged"),
    ],
)
def test_a_link_that_cannot_be_unpacked(page: Page, data: bytes, sentence: str) -> None:
    page.run("location.hash = arguments[0]", f"#z={base64.urlsafe_b64encode(data).decode().rstrip('=')}")
    page.wait(lambda: sentence in page.text("error"))


def test_there_is_no_link_to_nothing_or_to_a_file(page: Page) -> None:
    page.click("link")
    page.wait(lambda: "nothing to link to" in page.text("note"))
    assert page.text("link") == "Copy a link"
    page.browser.find_element(By.ID, "file").send_keys(str(CAPTURES / "usb.pcapng"))
    page.wait(lambda: page.text("tree"))
    page.click("link")
    page.wait(lambda: "A file is not part of a link" in page.text("note"))
    assert page.run("return input.placeholder") == "usb.pcapng"
    page.type(TONE)
    page.wait(lambda: page.text("note") == "")
    assert page.run("return input.placeholder + file.value") == ""


# Notations


def test_make_has_a_tab_for_each_notation_and_remembers_it(page: Page) -> None:
    page.read(TONE)
    for tab, panel in (("hex", "hex"), ("c", "c"), ("python", "python"), ("javascript", "javascript")):
        page.browser.find_element(By.CSS_SELECTOR, f"#tabs [data-tab={tab}]").click()
        assert page.is_shown(panel)
        assert not page.is_shown("frame")
        assert page.text("frame").startswith("0x|0E:00|")
    page.open(fragment(TONE))
    page.wait(lambda: page.text("frame"))
    assert page.is_shown("javascript")
    page.browser.find_element(By.CSS_SELECTOR, "#tabs [data-tab=lesson]").click()
    assert page.is_shown("frame")


# The virtual brick


def test_the_lesson_draws_its_triangle(page: Page) -> None:
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


def test_a_motor_of_the_core_set_turns(page: Page) -> None:
    page.type("OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 1)")
    page.click("send")
    page.wait(lambda: re.search(r"3[56]\d°, 0 %B", page.text("motors")) is not None)
    page.type("OUTPUT_STEP_SPEED(0, D, 50, 0, 360, 0, 1)")
    page.click("send")
    page.wait(lambda: page.text("waiting") == "a move on D does not end: no motor is plugged in there")


def test_a_running_program_is_said_and_can_be_stopped(page: Page) -> None:
    page.browser.find_element(By.XPATH, "//button[text()='A program that blinks']").click()
    page.wait(lambda: "vmthread" in page.text("tree"))
    assert not page.is_shown("running")
    page.click("send")
    page.wait(lambda: page.is_shown("running"))
    page.click("stop")
    page.wait(lambda: not page.is_shown("running"))
    # Programs have bytes, too.
    page.browser.find_element(By.XPATH, "//*[@id='tree']//*[text()='UI_WRITE']").find_element(By.XPATH, "..").click()
    page.wait(lambda: page.texts("#bytes .chosen")[:2] == ["82", "1B"])


def test_the_light_blinks_in_steps(page: Page) -> None:
    # A light that changes with each frame of the screen costs a sixth of a core for as long as a program runs.
    for name in ("LED_GREEN_PULSE", "LED_GREEN_FLASH"):
        page.read(f"UI_WRITE(LED, {name})")
        page.click("send")
        page.wait(partial(_is_lit, page, name))
        easing: list[str] = page.run("return pad.getAnimations()[0].effect.getKeyframes().map((each) => each.easing)")
        assert easing[0].startswith("steps("), name


def _is_lit(page: Page, name: str) -> bool:
    return page.text("leds") == name


def test_nothing_runs_while_nothing_happens(page: Page) -> None:
    # After the last news the worker sleeps until it is asked; it may collect garbage once.
    page.browser.find_element(By.XPATH, "//button[text()='A program that blinks']").click()
    page.wait(lambda: "vmthread" in page.text("tree"))
    page.click("send")
    page.wait(lambda: page.is_shown("running"))
    page.click("stop")
    page.wait(lambda: not page.is_shown("running"))
    page.wait(lambda: _seconds_of_workers(page, 2.5) < 0.0015)
    # Its time has passed all the same.
    page.type("OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 1)")
    page.click("send")
    page.wait(lambda: "50 %" in page.text("motors"))
    page.wait(lambda: "50 %" not in page.text("motors"))


def _seconds_of_workers(page: Page, during: float) -> float:
    """Seconds for which the browser's workers use a processor, in some seconds from now."""

    def used() -> int:
        profile, sum_of_all = page.browser.capabilities["chrome"]["userDataDir"].encode(), 0
        for thread in Path("/proc").glob("[0-9]*/task/[0-9]*"):
            with suppress(OSError):  # it has ended
                is_worker = (thread / "comm").read_text().startswith("DedicatedWorker")
                if is_worker and profile in (thread / "cmdline").read_bytes():
                    sum_of_all += int((thread / "schedstat").read_text().split()[0])
        return sum_of_all

    before = used()
    assert before > 0
    time.sleep(during)
    return (used() - before) / 1e9


# Files


def test_files(page: Page, tmp_path: Path) -> None:
    source = ROOT / "tests" / "support" / "sources" / "menu.lms"
    image = tmp_path / "menu.rbf"
    assert run_ev3proto("encode", source, "-o", image).returncode == 0
    file = page.browser.find_element(By.ID, "file")
    file.send_keys(str(CAPTURES / "ev3_dc.pcap"))
    page.wait(lambda: "received beacon" in page.text("tree") and page.text("status") == "")
    everything = printed("decode", CAPTURES / "ev3_dc.pcap")
    first = page.text("tree")
    assert everything.startswith(first)
    page.click("next-page")
    page.wait(lambda: page.text("tree") != first)
    assert first + page.text("tree") == everything
    page.click("previous-page")
    page.wait(lambda: page.text("tree") == first)
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
    assert len(page.browser.find_elements(By.CSS_SELECTOR, "#bytes [data-at]")) == image.stat().st_size
    file.send_keys(str(source))
    page.wait(lambda: page.input == source.read_text(encoding="utf-8"))
    page.wait(lambda: "vmthread" in page.text("tree") and page.text("status") == "")
    page.click("send")
    page.wait(lambda: page.pixel(8, 109))
    assert page.text("error") == ""
    assert "a ; means nothing: it is omitted" in page.text("findings")


_DROP = """
    const data = new DataTransfer();
    data.items.add(new File([arguments[0]], 'robot.log'));
    document.body.dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: data}))"""


def test_a_file_can_be_dropped_anywhere(page: Page) -> None:
    page.run(_DROP, LOG)
    page.wait(lambda: page.input == LOG)
    # A long one, too, is an edit that can be undone.
    long = "\n".join(f"# line {number}" for number in range(5000))
    page.run(_DROP, long)
    page.wait(lambda: page.input == long, 20)
    page.browser.find_element(By.ID, "input").send_keys(Keys.CONTROL, "z")
    page.wait(lambda: page.input == LOG, 20)


_DROP_BYTES = """
    const data = new DataTransfer();
    const bytes = new Uint8Array(arguments[1]);
    const noise = arguments[2] ? (at) => crypto.getRandomValues(bytes.subarray(at, at + 65536)) : () => {};
    for (let at = 0; at < bytes.length; at += 65536) noise(at);
    data.items.add(new File([bytes], arguments[0]));
    document.body.dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: data}))"""
"""Drops a file of zeros, or of noise: its name, its size in bytes, whether it is noise."""


@each(
    "name, size, said",
    [
        ("nothing.pcapng", 0, "nothing.pcapng is empty."),
        ("class.pcapng", 33_000_000, "class.pcapng has 33.0 MB, and this page reads at most 32 MB"),
    ],
)
def test_a_refused_file_says_so_and_nothing_older_is_left(page: Page, name: str, size: int, said: str) -> None:
    page.read(TONE)
    page.run(_DROP_BYTES, name, size, False)
    page.wait(lambda: said in page.text("error"))
    shown = [page.input, *(page.text(name) for name in ("tree", "findings", "sentence", "frame"))]
    assert shown == [""] * 5
    # It can be undone.
    page.browser.find_element(By.ID, "input").send_keys(Keys.CONTROL, "z")
    page.wait(lambda: page.input == TONE and not page.text("error"))


def test_the_input_outlives_a_reload(page: Page) -> None:
    def reload(expected: str) -> None:
        page.browser.refresh()
        page.wait(lambda: page.is_ready)
        page.wait(lambda: expected in page.text("tree"))

    def keeps(beginning: str) -> bool:
        return str(page.run("return sessionStorage.getItem('input')")).startswith(beginning)

    # A browser drops changes of the address that come too often, as after other tests, but not on a new page.
    page.open()
    # A text that is too long for the address, and a capture.
    long = f"# {random.Random(1).randbytes(8000).hex()}\n{BATTERY}"
    page.type(long)
    page.wait(lambda: "a reload does not lose it" in page.text("kept"))
    assert "#" not in page.browser.current_url
    reload("UI_READ.GET_VBATT")
    assert page.input == long
    page.browser.find_element(By.ID, "file").send_keys(str(CAPTURES / "usb.pcapng"))
    page.wait(lambda: keeps("usb.pcapng\n"))
    reload("GET_BRICKNAME")
    assert page.run("return input.placeholder") == "usb.pcapng"
    assert not page.is_shown("start")
    # A link wins, and another tab knows nothing of it.
    page.open(fragment(TONE))
    page.wait(lambda: "SOUND.TONE" in page.text("tree"))
    assert page.input == TONE
    page.browser.find_element(By.ID, "file").send_keys(str(CAPTURES / "usb.pcapng"))
    page.wait(lambda: keeps("usb.pcapng\n"))
    first = page.browser.current_window_handle
    page.browser.switch_to.new_window("tab")
    try:
        page.open()
        assert "GET_BRICKNAME" not in page.text("tree")
    finally:
        page.browser.close()
        page.browser.switch_to.window(first)
    # A page that is opened anew is empty.
    page.open()
    assert page.is_shown("start")
    # What is too large says so; what was forgotten is gone.
    page.run(_DROP_BYTES, "noise.bin", 9_000_000, True)
    page.wait(lambda: "too large to be kept (9.0 MB)" in page.text("kept"))
    page.click("forget")
    page.wait(lambda: not page.is_shown("kept") and page.run("return input.placeholder") == "")
    assert page.run("return sessionStorage.length") == 0
    page.browser.refresh()
    page.wait(lambda: page.is_ready)
    assert page.is_shown("start")


def test_a_long_capture_has_pages_and_a_finding_opens_its_own(page: Page, tmp_path: Path) -> None:
    wrong = bytes.fromhex("08000100000500810161")  # of 1,001 frames the 951st
    capture = tmp_path / "long.pcapng"
    with capture.open("wb") as stream:
        write_pcapng([bytes.fromhex(TONE)] * 950 + [wrong] + [bytes.fromhex(TONE)] * 50, stream)
    page.browser.find_element(By.ID, "file").send_keys(str(capture))
    page.wait(lambda: page.text("sentence") == "A capture of 1,001 frames." and page.text("status") == "")
    assert page.text("shown-frames") == "Frames 1 to 200 of 1,001"
    assert "UI_READ.GET_VBATT" not in page.text("tree")
    # Its finding is shown on every page, and opens the frame on its own.
    # By keyboard, with the mouse beside everything: what is under it after the page has moved would be marked.
    title = page.browser.find_element(By.TAG_NAME, "h1")
    ActionChains(page.browser).move_to_element(title).move_by_offset(-title.size["width"] // 2 - 10, 0).perform()
    page.browser.find_element(By.CSS_SELECTOR, "#findings .error").send_keys(Keys.ENTER)
    page.wait(lambda: page.text("shown-frames") == "Frames 801 to 1,000 of 1,001")
    page.wait(lambda: page.texts("#tree .chosen") == ["     9    VALUE = GV(1)  GV0: voltage\n"])
    assert page.texts("#bytes .chosen") == ["61"]
    page.wait(lambda: page.text("about") == "Reads the battery voltage.")
    # Keys reach the other pages, and the focus stays.
    page.browser.find_element(By.ID, "next-page").send_keys(Keys.ENTER)
    page.wait(lambda: page.text("shown-frames") == "Frames 1,001 to 1,001 of 1,001")
    assert page.run("return document.activeElement.id") == "next-page"
    assert page.run("return document.getElementById('next-page').ariaDisabled") == "true"
    page.click("first-page")
    page.wait(lambda: page.text("shown-frames") == "Frames 1 to 200 of 1,001")
    page.click("last-page")
    page.wait(lambda: page.text("shown-frames") == "Frames 1,001 to 1,001 of 1,001")
    # A filter has pages of its own.
    page.browser.find_element(By.ID, "filter").send_keys("op==UI_READ.GET_VBATT", Keys.ENTER)
    page.wait(lambda: page.text("tree").count("DIRECT_COMMAND") == 1)
    assert not page.is_shown("pages")


def test_a_filter_chooses_frames_of_logs_and_captures(page: Page) -> None:
    field = page.browser.find_element(By.ID, "filter")
    assert not field.is_displayed()
    page.type(LOG)
    page.wait(lambda: "A log of 3 frames" in page.text("sentence"))
    field.send_keys("op==SOUND.TONE && FREQUENCY>400", Keys.ENTER)
    page.wait(lambda: "SOUND.TONE" in page.text("tree") and "UI_READ" not in page.text("tree"))
    assert page.input == LOG
    field.clear()
    field.send_keys("op===", Keys.ENTER)
    page.wait(lambda: "the filter:" in page.text("error"))
    field.clear()
    field.send_keys(Keys.ENTER)
    page.wait(lambda: "A log of 3 frames" in page.text("sentence") and not page.text("error"))
    page.browser.find_element(By.ID, "file").send_keys(str(CAPTURES / "usb.pcapng"))
    page.wait(lambda: page.run("return input.placeholder") == "usb.pcapng" and "GET_BRICKNAME" in page.text("tree"))
    field.send_keys("op==UI_READ.GET_VBATT", Keys.ENTER)
    page.wait(lambda: "GET_VBATT" in page.text("tree") and "GET_BRICKNAME" not in page.text("tree"))


# Never blocked


def test_long_texts_are_read_beside_the_brick_and_can_be_cancelled(page: Page) -> None:
    draw = random.Random(1)
    starts = ((number, draw.randrange(250, 5000), draw.randrange(1, 2000)) for number in range(1010))
    lines = [
        struct.pack("<HHBHBBBBHBH", 14, number, 0x80, 0, 0x94, 1, 1, 0x82, hertz, 0x82, time).hex()
        for number, hertz, time in starts
    ]
    # Much more than is read to its end below, so that it is still being read when it is cancelled.
    page.type("\n".join(20 * lines))
    assert (page.input, page.text("note")) == (
        "",
        "The text is too long to be edited here (0.7 MB): it is read as a file.",
    )
    page.wait(lambda: page.is_shown("progress"))
    # The brick plays on meanwhile, and what was read is shown as it comes.
    button = "document.querySelector('[data-button=right]')"
    page.run(f"{button}.dispatchEvent(new Event('pointerdown'))")
    page.wait(lambda: page.run(f"return {button}.classList.contains('down')"))
    page.run(f"{button}.dispatchEvent(new Event('pointerup'))")
    assert page.is_shown("progress")
    page.click("cancel")
    page.wait(lambda: "Cancelled" in page.text("note"))
    assert not page.is_shown("progress")
    page.read("UI_WRITE(LED, LED_RED)")
    page.click("send")
    page.wait(lambda: page.text("leds") == "LED_RED")
    page.type("\n".join(lines))
    page.wait(lambda: page.text("verdict") == "The brick takes all 1,010 commands.", 120)
    assert page.text("shown-frames") == "Frames 1 to 200 of 1,010"
    assert page.text("frame").startswith("0x|0E:00|00:00|80|00:00|94:01:01:82:")
    assert page.text("sentence") == "A log of 1,010 frames."
    page.browser.find_element(By.CSS_SELECTOR, "#tabs [data-tab=c]").click()
    page.wait(lambda: "frame_1[16]" in page.text("c"))
    page.browser.find_element(By.CSS_SELECTOR, "#tabs [data-tab=lesson]").click()


def is_said(page: Page, sentence: str) -> bool:
    """Whether the headline is this one."""
    return page.text("sentence") == sentence


def test_a_long_log_is_read_quickly(page: Page) -> None:
    lines = ["Sent 0x|08:00|2A:00|00|04:00|81:01:60|", "Recv 0x|07:00|2A:00|02|66:66:F6:40|"]
    # Twice the milliseconds that a part and all of it may take.
    for count, first, whole in ((300, 2000, 2000), (5100, 3000, 16000)):
        page.read(TONE)
        page.type("\n".join(lines * (count // 2)))
        begun = page.run("return performance.now()")
        page.wait(lambda: "UI_READ" in page.text("tree"))
        assert page.run("return performance.now()") - begun < first
        sentence = f"A log of {count:,} frames: {count // 2:,} commands and {count // 2:,} replies."
        page.wait(partial(is_said, page, sentence))
        assert page.run("return performance.now()") - begun < whole


# A real brick


@pytest.mark.parametrize("carrier", ["usb", "bluetooth"])
def test_a_real_brick(page: Page, carrier: str, tmp_path: Path) -> None:
    assert page.connection == "none"
    page.read(BATTERY)
    page.connect(carrier)
    assert "Connected by" in page.text("brick-status")
    page.click("send")
    page.wait(lambda: "VALUE = 7.5 V" in page.text("answer"))
    assert re.search(
        r"answered (late, )?after \d+\.\d ms:\nDIRECT_REPLY, counter 42, 9 bytes: ok\n", page.text("answer")
    )
    assert page.fact("sent") == ["08002a00000400810160"]
    page.click("watch")
    page.wait(lambda: "Battery" in page.text("facts") and "Firmware" in page.text("facts"))
    assert "7.50 V, 0.20 A, 100 %" in page.text("facts")
    page.click("watch")
    page.run(
        "URL.createObjectURL = (blob) => { blob.arrayBuffer().then((data) => {"
        " saved = [...new Uint8Array(data)]; }); return 'about:blank#'; }; saved = null;"
        "HTMLAnchorElement.prototype.click = () => {}"
    )
    page.click("record")
    page.wait(lambda: page.run("return saved"))
    capture = tmp_path / "ev3.pcapng"
    capture.write_bytes(bytes(page.run("return saved")))
    assert f"{carrier} " in printed("decode", "--dialogues", capture)
    assert "UI_READ.GET_VBATT(VALUE=GV(0)) -> VALUE=7.5 V" in printed("decode", "--dialogues", capture)
    page.click("disconnect")
    page.wait(lambda: page.connection == "none")
    # The next one is another one: the browser asks again.
    page.connect(carrier)
    assert page.fact("requests") >= 1


def test_a_known_brick_is_connected_without_asking(page: Page) -> None:
    page.run("navigator.hid.permitted = [navigator.hid.device]")
    page.open(fragment(BATTERY))
    page.run("navigator.hid.permitted = [navigator.hid.device]")
    page.connect("usb")
    assert page.fact("requests") == 0


def test_a_short_listing_is_read_to_its_end_at_once(page: Page) -> None:
    # LIST_FILES of ../, a byte of it.
    page.read("0A 00 2A 00 01 99 01 00 2E 2E 2F 00")
    page.connect("usb")
    page.click("send")
    page.wait(lambda: "handle" in page.text("answer"))
    page.click("disconnect")
    page.wait(lambda: page.connection == "none")
    # A listing is opened with the largest size, so that this one is read to its end at once.
    last = page.fact("sent")[-1]
    assert last[10:16] == "99f403"


def test_a_file_that_is_open_is_closed_before_disconnecting(page: Page) -> None:
    # The brick has a file of 2,000 bytes.
    path = b"../prjs/x/long.rtf\0"
    for body in (b"\x92\xd0\x07\0\0" + path, b"\x93\0" + bytes(1000), b"\x93\0" + bytes(1000)):
        urlopen(urljoin(page.address, "/brick"), system_command(body).hex().encode()).close()
    # BEGIN_DOWNLOAD of 100 bytes and none of them; BEGIN_UPLOAD of 10.
    for begin, asks in ((b"\x92\x64\0\0\0../prjs/x/x.txt\0", True), (b"\x94\x0a\0" + path, False)):
        page.read(system_command(begin).hex(" "))
        page.connect("usb")
        page.click("send")
        if asks:
            page.wait(lambda: page.is_shown("allow"))
            page.click("allow")
        page.wait(lambda: "handle" in page.text("answer"))
        assert page.fact("sent")[-1][10:12] == f"{begin[0]:02x}"
        page.disconnect()
        assert page.fact("sent")[-1][10:12] == "98"


def system_command(body: bytes) -> bytes:
    """A system command that wants a reply."""
    return (len(body) + 3).to_bytes(2, "little") + b"\x2a\0\x01" + body


def test_in_a_frame_of_another_page_no_brick_is_reached(page: Page) -> None:
    page.browser.get(page.address.replace("playground/", ""))
    page.run(
        "const frame = document.createElement('iframe'); frame.id = 'framed'; frame.allow = 'hid; serial';"
        " frame.src = arguments[0]; document.body.replaceChildren(frame)",
        page.address,
    )
    page.browser.switch_to.frame("framed")
    try:
        page.wait(lambda: page.run("return !!document.getElementById('brick-status')?.textContent"), 60)
        page.run("navigator.hid.permitted = [navigator.hid.device]")
        assert "in a frame of another page" in page.text("brick-status")
        for carrier in ("usb", "bluetooth"):
            page.run("document.getElementById(arguments[0]).click()", f"connect-{carrier}")
            page.wait(lambda: not page.run("return document.getElementById('connect-usb').disabled"))
            assert "does not connect to a real brick" in page.text("brick-status")
            assert page.connection == "none"
        assert (page.fact("requests"), page.fact("sent")) == (0, [])
    finally:
        page.browser.switch_to.default_content()
        page.open()


@pytest.mark.parametrize("carrier", ["usb", "bluetooth"])
def test_a_refused_or_busy_brick_is_a_sentence(page: Page, carrier: str) -> None:
    page.run("navigator.hid.permitted = []; navigator.serial.permitted = []")
    page.steer(isRefused=True)
    page.click(f"connect-{carrier}")
    page.wait(lambda: "was chosen" in page.text("brick-status"))
    assert page.connection == "none"
    page.steer(isRefused=False, isBusy=True)
    page.click(f"connect-{carrier}")
    page.wait(lambda: "cannot be opened" in page.text("brick-status"))
    assert page.is_shown(f"connect-{carrier}")


@pytest.mark.parametrize("carrier", ["usb", "bluetooth"])
def test_a_brick_that_is_unplugged_during_a_command(page: Page, carrier: str) -> None:
    page.read(BATTERY)
    page.connect(carrier)
    page.steer(isUnplugged=True)
    page.click("send")
    page.wait(lambda: page.connection == "none")
    assert "unplugged or switched off" in page.text("brick-status")
    page.wait(lambda: "no answer: the brick was unplugged" in page.text("answer"))
    page.steer(isUnplugged=False)
    page.connect(carrier)
    page.click("send")
    page.wait(lambda: "VALUE = 7.5 V" in page.text("answer"))


@pytest.mark.parametrize("carrier", ["usb", "bluetooth"])
def test_a_brick_that_answers_late_or_never(page: Page, carrier: str) -> None:
    page.read(BATTERY)
    page.connect(carrier)
    page.steer(isHeld=True)
    page.click("send")
    page.wait(lambda: "waiting for the answer" in page.text("answer"))
    page.wait(lambda: "no answer within 5 s" in page.text("answer"))
    page.run("fake.release()")
    page.wait(lambda: "answered late, after" in page.text("answer"))
    assert "VALUE = 7.5 V" in page.text("answer")
    assert page.connection == carrier


def test_what_does_not_only_read_asks_first(page: Page) -> None:
    page.read("OUTPUT_START(0, 1)")
    page.connect("usb")
    page.click("send")
    page.wait(lambda: page.is_shown("allow"))
    assert "OUTPUT_START makes motors turn or stop" in page.text("ask")
    page.browser.switch_to.active_element.send_keys(Keys.ESCAPE)
    page.wait(lambda: not page.is_shown("allow"))
    page.click("send")
    page.wait(lambda: page.is_shown("allow"))
    page.click("cancel")
    page.wait(lambda: not page.is_shown("allow"))
    assert page.fact("sent") == []
    page.click("send")
    page.wait(lambda: page.is_shown("allow"))
    page.click("allow")
    page.wait(lambda: page.fact("sent") == ["08000000800000a60001"])
    # What the brick would wait for is not sent at all.
    page.read("09:00|2A:00|80|00:00|81|01|60|")
    page.click("send")
    page.wait(lambda: "would wait for the rest" in page.text("error"))
    assert len(page.fact("sent")) == 1


def test_the_button_says_where_a_frame_goes_and_whether_it_was_sent(page: Page) -> None:
    def wait_for(*texts: str) -> None:
        expected.extend(texts)
        page.wait(lambda: page.run("return heard") == expected)

    expected: list[str] = []
    page.wait(lambda: page.text("send") == "Send to the brick")  # a test before this one may have sent
    page.run("heard = []; new MutationObserver(() => heard.push(send.textContent)).observe(send, {childList: true})")
    page.read("OUTPUT_START(0, 1)")
    page.click("send")
    wait_for("Sent", "Send to the brick")
    # What it said before a connection is not said again.
    page.connect("usb")
    wait_for("Send to the real brick")
    page.read(BATTERY)
    page.click("send")
    wait_for("Sent", "Send to the real brick")
    # Nor is "Sent" said of what was not.
    page.read("OUTPUT_START(0, 1)")
    for key in (Keys.ENTER, Keys.ESCAPE):
        page.click("send")
        page.wait(lambda: page.is_shown("allow"))
        page.browser.switch_to.active_element.send_keys(key)
        page.wait(lambda: not page.is_shown("allow"))
    page.click("disconnect")
    wait_for("Send to the brick")


def test_what_belongs_to_an_older_input_is_not_shown(page: Page) -> None:
    page.read(TONE)
    page.wait(lambda: page.text("verdict"))
    # Before Python has had its turn.
    long = "\n".join([f"0x|{BATTERY[2:]}"] * 3000)
    seen = page.run(
        "input.value = arguments[0]; input.dispatchEvent(new Event('input'));"
        "return [verdict, tree, frame].map((each) => each.textContent)",
        long,
    )
    assert seen == ["", "", ""]
    page.type("")
    page.read(TONE)
    dim = "input.value = ''; input.dispatchEvent(new Event('input')); return document.body.classList.contains('stale')"
    assert page.run(dim)
    page.wait(lambda: not page.run("return document.body.classList.contains('stale')"))


def test_all_motors_stop_without_a_question(page: Page) -> None:
    page.click("stop-motors")  # a motor that an earlier test started by power takes no speed
    page.type("OUTPUT_SPEED(0, A, 50)\nOUTPUT_START(0, A)")
    page.click("send")
    page.wait(lambda: re.search(r"°, 50 %.*B", page.text("motors")))
    page.click("stop-motors")
    page.wait(lambda: re.search(r"°, 0 %B", page.text("motors")))
    page.wait(lambda: page.text("answer").endswith("OUTPUT_STOP(LAYER=0, NOS=15, BRAKE=1)\n"))
    page.read(BATTERY)
    page.connect("usb")
    assert not page.is_shown("display")
    page.steer(isHeld=True)
    page.click("send")
    page.wait(lambda: len(page.fact("sent")) == 1)
    # It does not wait for the answer that is still to come.
    page.click("stop-motors")
    page.wait(lambda: len(page.fact("sent")) == 2)
    assert page.fact("sent")[1][8:] == "800000a3000f01"
    assert not page.is_shown("allow")
    assert "OUTPUT_STOP" in page.text("answer")
    page.run("fake.release()")
    page.steer(isHeld=False)
    page.click("disconnect")
    page.wait(lambda: page.is_shown("display"))


def test_files_of_a_real_brick_are_listed_and_what_changes_them_asks(page: Page, tmp_path: Path) -> None:
    note = tmp_path / "note.rtf"
    note.write_text("hello")
    page.connect("usb")
    page.browser.find_element(By.CSS_SELECTOR, "#brick-files summary").click()
    page.wait(lambda: page.text("brick-path") == "/home/root/lms2012/prjs")
    page.browser.find_element(By.ID, "upload").send_keys(str(note))
    page.wait(lambda: page.is_shown("allow"))
    assert "Writes /home/root/lms2012/prjs/note.rtf on the brick." in page.text("ask")
    page.click("allow")
    page.wait(lambda: "note.rtf" in page.text("brick-list"))
    page.run(
        "URL.createObjectURL = (blob) => { blob.text().then((text) => { saved = text; }); return 'about:blank#'; };"
        "saved = null; HTMLAnchorElement.prototype.click = () => {}"
    )
    page.browser.find_element(By.XPATH, "//ul[@id='brick-list']//button[text()='note.rtf']").click()
    page.wait(lambda: page.run("return saved") == "hello")
    page.browser.find_element(By.XPATH, "//button[text()='Delete note.rtf']").click()
    page.wait(lambda: page.is_shown("allow"))
    page.click("allow")
    page.wait(lambda: "note.rtf" not in page.text("brick-list"))
    page.browser.find_element(By.ID, "new-name").send_keys("desk7")
    page.click("rename")
    page.wait(lambda: page.is_shown("allow"))
    page.click("cancel")
    page.wait(lambda: not page.is_shown("allow"))


def test_operations_can_be_edited_and_the_frame_follows(page: Page) -> None:
    page.read("0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|")
    page.browser.find_element(By.CSS_SELECTOR, "#tabs [data-tab=operations]").click()
    operations = page.browser.find_element(By.CSS_SELECTOR, "#operations textarea")
    page.wait(lambda: "SOUND(TONE,1,440,1000)" in str(operations.get_property("value")))
    edit = "arguments[0].focus(); arguments[0].value = arguments[0].value.replace(arguments[1], arguments[2]);"
    edit += "arguments[0].dispatchEvent(new Event('input'))"
    page.run(edit, operations, "440", "880")
    page.wait(lambda: page.text("frame") == "0x|0E:00|2A:00|80|00:00|94:01:01:82:70:03:82:E8:03|")
    page.wait(lambda: page.text("sentence").startswith("Plays 880 Hz"))
    page.run(edit, operations, "TONE", "TOEN")
    page.wait(lambda: "did you mean TONE" in page.text("operations"))
    assert "82:70:03" in page.text("frame")
    page.run(edit, operations, "TOEN", "TONE")
    page.wait(lambda: "did you mean" not in page.text("operations"))
    page.browser.find_element(By.CSS_SELECTOR, "#tabs [data-tab=lesson]").click()


def test_one_operation_is_assembly_whatever_its_letters(page: Page) -> None:
    page.type("INFO(GET_VOLUME, GV0(0))")
    page.wait(lambda: page.text("frame") == "0x|08:00|00:00|00|01:00|7C:04:60|")


def test_a_brick_is_compared_with_the_virtual_one(page: Page) -> None:
    page.connect("usb")
    page.click("computes")
    page.click("compare")
    page.wait(lambda: "answers differ" in page.text("comparison"), 120)
    assert re.match(r"0 of (\d+) answers differ\.", page.text("comparison"))
    page.click("computes")
    page.steer(isSilent=True)
    page.click("compare")
    page.wait(lambda: "ended early: the brick does not answer" in page.text("comparison"))
    assert page.text("comparison").startswith("3 of 3 answers differ")


def test_two_tabs_do_not_disturb_each_other(page: Page) -> None:
    page.read(BATTERY)
    page.connect("usb")
    first = page.browser.current_window_handle
    page.browser.switch_to.new_window("tab")
    try:
        put_fakes(page.browser)
        page.open(fragment(BATTERY))
        page.connect("usb")
        page.click("send")
        page.wait(lambda: "VALUE = 7.5 V" in page.text("answer"))
    finally:
        page.browser.close()
        page.browser.switch_to.window(first)
    assert page.text("answer") == ""
    # What another tab was answered is not an answer here.
    page.run(
        "const data = new DataView(new ArrayBuffer(1024)); data.setUint16(0, 3, true); data.setUint8(4, 2);"
        "navigator.hid.device.dispatchEvent(Object.assign(new Event('inputreport'), {reportId: 0, data}))"
    )
    page.click("send")
    page.wait(lambda: "VALUE = 7.5 V" in page.text("answer"))
    assert "unasked" not in page.text("answer")


def test_a_browser_without_usb_and_bluetooth(page: Page) -> None:
    page.run("for (const name of ['hid', 'serial']) Object.defineProperty(navigator, name, {value: undefined})")
    page.click("connect-usb")
    page.wait(lambda: "neither WebHID nor Web Serial" in page.text("brick-status"))
    # Without them from the start there is nothing to click, and one sentence: Safari has neither, Firefox no WebHID.
    for lacking, shown, said in (
        (["hid", "serial"], [False, False], "it has neither WebHID nor Web Serial"),
        (["hid"], [False, True], "This browser has no WebHID, which USB needs."),
    ):
        script = f"for (const name of {lacking}) Object.defineProperty(navigator, name, {{value: undefined}})"
        added = page.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})
        page.open()
        page.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)
        assert [page.is_shown("connect-usb"), page.is_shown("connect-bluetooth")] == shown
        assert said in page.text("brick-status")
        assert page.is_shown("stop-motors")
    page.open()


# Without a network


def test_the_page_is_kept_for_use_without_a_network(built: Path, tmp_path: Path) -> None:
    with chromium(tmp_path / "profile") as browser:
        with served_site(built) as address:
            page = Page(browser, address)
            page.open()
            active = "return navigator.serviceWorker.ready.then((it) => it.active.state)"
            page.wait(lambda: page.run(active) == "activated", 120)
        page.open(fragment(TONE))
        page.wait(lambda: page.text("tree"))
        assert page.run("return caches.keys().then((names) => names.length)") == 1


# Its files


def test_hostile_text_stays_text(page: Page) -> None:
    page.run("location.hash = arguments[0]", fragment(HOSTILE))
    page.wait(lambda: page.text("tree"))
    assert page.input == HOSTILE
    page.type(HOSTILE.replace("0e002a", "ff7f2a"))
    page.wait(lambda: page.text("sentence") == "A text without a frame.")
    page.type('UI_DRAW(<script>, "<img src=x>", 1)')
    page.wait(lambda: "<script>" in page.text("error"))
    assert page.browser.find_elements(By.CSS_SELECTOR, "main img, main script, main b") == []


def test_nothing_inline_and_nothing_from_elsewhere(built: Path) -> None:
    site = built / "playground"
    page = (site / "index.html").read_text(encoding="utf-8")
    assert "default-src 'none'" in page
    assert "connect-src 'self'" in page
    assert "worker-src 'self'" in page
    assert "unsafe" not in page
    assert not re.search(r"<script(?![^>]*src=)|<style|\sstyle=|\son\w+=", page)
    own = [each for each in PLAYGROUND.with_suffix("").iterdir() if each.suffix in (".html", ".js", ".css")]
    for file in own:
        text = file.read_text(encoding="utf-8")
        assert "//" not in re.sub(r"^ *//.*$| // .*$", "", text, flags=re.MULTILINE), file
        assert "innerHTML" not in text
    # Of the snapshots, a browser loads one.
    sizes = {each.name: each.stat().st_size for each in site.rglob("*") if each.is_file()}
    assert sum(sizes.values()) - sizes["snapshot_brotli.bin"] < 23_000_000
    lesson: list[Any] = json.loads((site / "lesson.json").read_text(encoding="utf-8"))
    assert lesson[0]["title"].startswith("Setting the name of the brick")
    worker = (site / "service-worker.js").read_text(encoding="utf-8")
    kept: dict[str, str] = json.loads(worker.partition("JSON.parse(`")[2].partition("`")[0])
    there = {each.relative_to(site).as_posix() for each in site.rglob("*") if each.is_file()}
    assert set(kept) == there - {"service-worker.js"}


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
        "dpkt": "Dug Song",
        "ev3proto": "MIT License",
    }.items():
        assert owner in entries[name], name
    assert "click" not in entries  # only the command line needs it
    page = (built / "playground" / "index.html").read_text(encoding="utf-8")
    assert '<a href="licences.txt">' in page


def test_each_type_of_a_device_on_a_real_brick_is_shown() -> None:
    """Also those that no device has, and those that no table has."""
    found = [watching.shown(number, 0, 1.5) for number in range(256)]
    assert found[7] == ("large motor", "2 degrees")
    assert found[17] == ("unused type 17", "2")
    assert found[30] == ("EV3 ultrasonic sensor", "1.5 cm")
    assert found[60] == ("type 60", "1.5")


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

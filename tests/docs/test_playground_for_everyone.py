"""The playground for everyone: by keyboard, with a screen reader, in the dark, on a phone, enlarged."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from selenium.webdriver import ActionChains, Chrome, Keys
from selenium.webdriver.common.by import By
from support.browser import chromium, complaints, emulated, scrolls_sideways
from support.cases import each
from support.playground import Page, fragment
from support.scripts import node_modules

pytest_plugins = ["support.playground_fixtures"]

CAPTURES = Path(__file__).parents[2] / "captures"
WRONG = "0x|08:00|01:00|00|05:00|81:01:61|"
LOG = """\
09:12:31.5 Sent 0x|08:00|01:00|00|01:00|81:01:60|
09:12:31.6 Recv 0x|07:00|01:00|02|66:66:F6:40|
09:12:31.7 Sent 0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|
"""


@pytest.fixture
def page(browser: Chrome, address: str) -> Iterator[Page]:
    """The page, just opened."""
    page = Page(browser, address)
    page.open()
    yield page
    assert complaints(browser) == []


def focus(page: Page) -> str:
    """The id of what has the focus."""
    return str(page.run("return document.activeElement.id || document.activeElement.tagName"))


def violations(page: Page, *without: str, in_dark: bool = True) -> list[Any]:
    """What axe finds on the page as it is now, without some elements: rules, each with some of the elements.

    In the dark, only colours differ.
    """
    axe = (node_modules() / "axe-core" / "axe.min.js").read_text(encoding="utf-8")
    page.browser.execute_cdp_cmd("Runtime.evaluate", {"expression": axe})
    page.browser.set_script_timeout(300)
    # What was dimmed is pale for a moment.
    fading = "return document.getAnimations().some((each) => each.playState === 'running')"
    page.wait(lambda: page.is_read and not page.run(fading))
    run = "axe.run({exclude: arguments[0]}, arguments[1]).then((it) => arguments[2](it.violations))"
    found: list[Any] = []
    for scheme, rules in (("light", {}), ("dark", {"runOnly": ["color-contrast"]}))[: 1 + in_dark]:
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        page.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        found += page.browser.execute_async_script(run, [[selector] for selector in without], rules)
    page.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
    return [(rule["id"], [node["html"][:200] for node in rule["nodes"][:3]]) for rule in found]


LONG = "0x|18:00|01:00|00|05:00|84:05:01:81:0A:81:32:84:67:67:67:67:67:67:67:67:67:67:00|"
"""A wrong frame, of which an excerpt is wider than a phone."""


@each("text", [WRONG, LOG, LONG, "", "UI_WRITE(LED, LED_RDE)\n" * 20])
def test_axe_finds_nothing(page: Page, text: str) -> None:
    for width, height, is_phone in ((390, 844, True), (1280, 720, False)):
        with emulated(page.browser, width, height, is_phone=is_phone):
            page.type("")
            page.wait(lambda: not page.text("findings") and not page.text("error"))
            page.type(text)
            if text:
                page.wait(lambda: page.text("findings") or page.text("error"))
            else:
                page.browser.find_element(By.ID, "input").send_keys("UI_")
                page.wait(lambda: len(page.texts("#words li")) == 11)
            assert violations(page, in_dark=not is_phone) == [], width
            if text != LOG:
                continue
            page.click("send")
            page.wait(lambda: "VALUE" in page.text("answer"))
            assert page.is_shown("desk")
            assert violations(page, in_dark=False) == [], width


def test_axe_finds_nothing_in_what_is_opened(page: Page) -> None:
    # A capture of several pages, its dialogues and timeline; the operations; the panel of a brick, its files.
    page.browser.find_element(By.ID, "file").send_keys(str(CAPTURES / "ev3_dc.pcap"))
    page.wait(lambda: page.is_shown("pages") and page.text("status") == "")
    for name in ("dialogues", "timeline"):
        page.run("document.querySelector(arguments[0]).click()", f"#{name} > summary")
    page.wait(lambda: page.texts("#timeline canvas"))
    page.run("document.querySelector('#tabs [data-tab=operations]').click()")
    page.connect("usb")
    page.click("watch")
    page.wait(lambda: "Battery" in page.text("facts"))
    page.run("document.querySelector('#brick-files > summary').click()")
    page.wait(lambda: page.text("brick-path"))
    # Its lines are thousands, of the same kinds as those of the log above.
    found = violations(page, "#tree", "#findings")
    page.click("watch")
    page.disconnect()
    page.run("document.querySelector('#tabs [data-tab=lesson]').click()")
    assert found == []


def tip(page: Page) -> str:
    """The explanation that is shown."""
    return page.text("tip") if page.is_shown("tip") else ""


def wait_for_tip(page: Page, said: str) -> None:
    """Waits for an explanation with these words."""
    page.wait(lambda: said in tip(page))


WORDS = {
    "//h2/button[text()='Check']": "What a brick would say to this: each error, warning and hint",
    "//h2/button[text()='Read']": "What each byte means.",
    "//h2/button[text()='Make']": "The same frames in other notations",
    "//*[@data-tab='lesson']": "the lessons on EV3 direct commands",
    "//*[@id='tree']//*[starts-with(text(), 'NOS')]": "NOS: ports as a bit mask: A 1, B 2, C 4, D 8",
    "//*[@id='tree']//*[contains(text(), 'LC1')]": "LC1: A number of -127 to 127 in two bytes",
    "//*[@id='tree']//*[contains(text(), 'GV0')]": "GV0: A variable in the first 32 bytes of global memory",
    "//*[@id='tree']//*[normalize-space()='10']": "offset: the number of bytes before this one in the frame",
    "//*[@id='findings']//*[contains(text(), 'offset')]": "offset: the number of bytes before this one in the frame",
}
"""The words that explain themselves, as XPath, with the beginning of their explanation."""


def test_words_explain_themselves_where_they_are(page: Page) -> None:
    page.type("0x|10:00|00:00|00|04:00|A5:00:01:81:78:A6:00:01:81:01:60|")  # a speed of 120 %
    page.wait(lambda: "offset" in page.text("findings"))
    for path, said in WORDS.items():
        element = page.browser.find_element(By.XPATH, path)
        ActionChains(page.browser).scroll_to_element(element).move_to_element(element).perform()
        wait_for_tip(page, said)
        assert not scrolls_sideways(page.browser)
        ActionChains(page.browser).move_to_element(page.browser.find_element(By.TAG_NAME, "h1")).perform()
        page.wait(lambda: not tip(page))
    # With the keyboard, where the focus is; Escape takes it away.
    page.run("document.querySelector('#check .term').focus()")
    page.wait(lambda: tip(page).startswith("What a brick would say"))
    page.browser.switch_to.active_element.send_keys(Keys.ESCAPE)
    assert not tip(page)
    page.browser.find_element(By.ID, "tree").send_keys(*[Keys.ARROW_DOWN] * 5)
    page.wait(lambda: all(word in tip(page) for word in ("SPEED: regulated", "LC1: A number", "offset: ")))
    assert violations(page, in_dark=False) == []
    # On a phone, when they are tapped.
    with emulated(page.browser, 390, 844, is_phone=True):
        for path, said in WORDS.items():
            page.run("arguments[0].click()", page.browser.find_element(By.XPATH, path))
            wait_for_tip(page, said)
            box = page.run("const { left, right } = tip.getBoundingClientRect(); return [left, right]")
            assert 0 <= box[0] < box[1] <= 390


def test_the_input_has_the_focus_and_keys_reach_everything(page: Page) -> None:
    assert focus(page) == "input"
    page.type(WRONG)
    page.wait(lambda: page.texts("#findings [tabindex='0']"))
    # Enter on a finding marks its bytes; in the tree, lines have levels.
    finding = page.browser.find_element(By.CSS_SELECTOR, "#findings .error")
    page.run("arguments[0].focus()", finding)
    finding.send_keys(Keys.ENTER)
    assert page.texts("#bytes .chosen") == ["61"]
    levels = page.run("return [...document.querySelectorAll('#tree [role]')].map((each) => each.ariaLevel)")
    assert levels[:2] == ["1", "2"]
    page.wait(lambda: page.is_shown("header"))
    page.browser.find_element(By.ID, "header").send_keys(Keys.ARROW_DOWN, Keys.ARROW_DOWN)
    assert page.texts("#header .chosen")[0].split()[:2] == ["2", "counter"]


def test_the_focus_is_not_lost_with_a_button(page: Page) -> None:
    page.type("0x|08:00|01:00|00|01:00|81:01:60|")
    page.wait(lambda: page.texts("#remedies button"))
    page.browser.find_element(By.CSS_SELECTOR, "#remedies button").send_keys(Keys.ENTER)
    page.wait(lambda: page.text("verdict") == "The brick takes it.")
    assert focus(page) == "input"
    page.browser.find_element(By.ID, "connect-usb").send_keys(Keys.ENTER)
    page.wait(lambda: page.connection == "usb")
    page.wait(lambda: focus(page) not in ("BODY", "connect-usb"))
    page.browser.find_element(By.ID, "disconnect").send_keys(Keys.ENTER)
    page.wait(lambda: page.connection == "none" and focus(page) == "connect-usb")


def test_screen_readers_hear_a_short_status(page: Page) -> None:
    live = page.run(
        "return [...document.querySelectorAll('[role=status], [role=alert], [aria-live]')].map((it) => it.id)"
    )
    assert {"say", "note"} <= set(live)
    assert not {"sentence", "verdict", "error", "findings"} & set(live)


def test_pasting_and_dropping_work_anywhere(page: Page) -> None:
    page.run("document.activeElement.blur()")
    script = """
        const data = new DataTransfer();
        data.setData('text/plain', arguments[1]);
        const [kind, name] = arguments[0] === 'paste' ? [ClipboardEvent, 'clipboardData'] : [DragEvent, 'dataTransfer'];
        document.body.dispatchEvent(new kind(arguments[0], {bubbles: true, cancelable: true, [name]: data}))"""
    page.run(script, "paste", WRONG)
    page.wait(lambda: page.input == WRONG)
    page.run(script, "drop", LOG)
    page.wait(lambda: page.input == LOG)


def test_a_link_of_its_own_is_opened_where_it_is_pasted(page: Page) -> None:
    page.type(f"https://example.org/docs/playground/index.html{fragment(WRONG)}")
    page.wait(lambda: page.input == WRONG)
    page.wait(lambda: page.text("sentence") == "Reads the battery voltage.")


def test_on_a_phone_nothing_is_covered(browser: Chrome, address: str) -> None:
    with emulated(browser, 390, 900, is_phone=True):
        page = Page(browser, address)
        page.open(fragment(WRONG))
        page.wait(lambda: page.texts("#findings .error") and page.text("sentence"))
        assert not scrolls_sideways(browser)
        for name in ("bytes", "findings", "header", "tree"):
            assert page.run(f"return {name}.scrollWidth <= {name}.clientWidth"), name


MOVE = """\
UI_WRITE(LED, LED_RED)
OUTPUT_SPEED(0, A, 50)
OUTPUT_START(0, A)
UI_DRAW(TEXT, 1, 10, 50, "go")
UI_DRAW(UPDATE)
"""
EFFECT = ("display", "motors", "leds", "stop-motors")
"""Where it is seen what a frame does."""
NAME_ROOMS = """
    const pen = document.createElement('canvas').getContext('2d');
    return [...motors.querySelectorAll('select')].map((each) => {
        const { font, paddingLeft, paddingRight } = getComputedStyle(each);
        pen.font = font;
        const { width } = pen.measureText(each.selectedOptions[0].text);
        return each.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - width;
    })"""
"""The pixels that are left beside the name of each motor."""


def test_what_a_frame_does_is_seen_at_once(browser: Chrome, address: str) -> None:
    page = Page(browser, address)
    # A phone, a projector with 1280 x 720 pixels at 150 %, a small and a large window.
    for width, height, is_phone in ((360, 740, True), (853, 480, False), (1000, 720, False), (1600, 1000, False)):
        with emulated(browser, width, height, is_phone=is_phone):
            page.open(fragment(MOVE))
            page.wait(lambda: page.text("sentence") and page.text("verdict"))
            if width >= 1000:
                assert in_sight(page) >= {*EFFECT, "input", "sentence"}, width
            page.click("send")
            page.wait(lambda: page.text("leds") == "LED_RED" and "OUTPUT_START" in page.text("answer"))
            assert in_sight(page) >= {*EFFECT, "answer", "sentence", "verdict"}, width
            assert not scrolls_sideways(browser)
            assert min(page.run(NAME_ROOMS)) >= 0, width
            page.click("stop-motors")
            page.wait(lambda: "OUTPUT_STOP" in page.text("answer"))
    # It follows the window: with less room it is under the headline, with more beside the input again.
    parent = "return effect.parentElement.id"
    with emulated(browser, 390, 900):
        page.wait(lambda: page.run(parent) == "write")
    page.wait(lambda: page.run(parent) == "bench")


def in_sight(page: Page) -> set[str]:
    """The ids of what is in the window as a whole."""
    script = """
        return [...document.querySelectorAll('[id]')].filter((each) => {
            const { top, bottom } = each.getBoundingClientRect();
            return each.getClientRects().length && top >= 0 && bottom <= innerHeight;
        }).map((each) => each.id)"""
    return set(page.run(script))


def test_at_twice_the_size_everything_fits(browser: Chrome, address: str) -> None:
    # A window of 780 pixels, enlarged to twice the size, has 390.
    with emulated(browser, 390, 450, 2):
        page = Page(browser, address)
        page.open(fragment(WRONG))
        page.wait(lambda: page.texts("#findings .error"))
        assert not scrolls_sideways(browser)
        for name in ("bytes", "findings", "tree"):
            assert page.run(f"return {name}.scrollWidth <= {name}.clientWidth"), name


def test_where_it_cannot_start_a_sentence_says_why(built: Path, tmp_path: Path) -> None:
    with chromium(tmp_path / "profile") as browser:
        browser.get((built / "playground" / "index.html").as_uri())
        page = Page(browser, "")
        page.wait(lambda: page.is_shown("late"), 20)
        assert "python3 -m http.server" in page.text("late")
        assert "Firefox 114" in page.text("late")


def test_no_path_of_the_browsers_files_is_shown(page: Page, tmp_path: Path) -> None:
    cut = tmp_path / "cut.pcapng"
    cut.write_bytes((CAPTURES / "usb.pcapng").read_bytes()[:3001])
    page.browser.find_element(By.ID, "file").send_keys(str(cut))
    page.wait(lambda: page.text("error"))
    assert "cut.pcapng" in page.text("error")
    assert "/tmp" not in page.run("return document.body.textContent")

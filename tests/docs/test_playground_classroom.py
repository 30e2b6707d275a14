"""A school's desk: the panel of a brick, several bricks and wrong ones, and a lesson by keyboard alone."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from selenium.webdriver import ActionChains, Chrome, Keys
from selenium.webdriver.common.by import By
from support.browser import complaints
from support.playground import Page

from ev3proto.program import parse as parse_program

pytest_plugins = ["support.playground_fixtures"]

BLINKS = "vmthread MAIN\n{\n  UI_WRITE(LED, LED_RED)\n}\n"
PROGRAM = "/home/root/lms2012/prjs/playground/playground.rbf"


@pytest.fixture
def page(browser: Chrome, address: str) -> Iterator[Page]:
    """The page, just opened, which asks a brick for battery and ports every second, as it does for users."""
    page = Page(browser, address)
    page.open(wait=False)
    page.run("sessionStorage.setItem('talks', 'yes'); localStorage.removeItem('quiet')")
    page.open()
    yield page
    page.disconnect()
    page.run("sessionStorage.clear(); localStorage.clear()")
    assert complaints(browser) == []


def is_fact(page: Page, *words: str) -> bool:
    """Whether the panel says all of this."""
    return all(word in page.text("facts") for word in words)


def allow(page: Page, question: str) -> None:
    """Waits for a question, and answers it with yes."""
    page.wait(lambda: page.is_shown("allow"))
    assert question in page.text("ask")
    page.click("allow")
    page.wait(lambda: not page.is_shown("allow"))


@pytest.mark.parametrize("carrier", ["usb", "bluetooth"])
def test_the_panel_of_a_brick_appears_when_it_is_connected(page: Page, carrier: str) -> None:
    assert page.is_shown("display")
    assert not page.is_shown("facts")
    page.connect(carrier)
    page.wait(lambda: is_fact(page, "Name", "Firmware", "Battery", "7.50 V, 0.20 A, 100 %"))
    assert page.is_shown("facts")
    assert page.is_shown("stop-motors")
    # The virtual brick is folded away, and can be opened.
    assert not page.is_shown("display")
    page.browser.find_element(By.CSS_SELECTOR, "#virtual > summary").click()
    page.wait(lambda: page.is_shown("display"))
    # It may be told to be quiet, and keeps to that.
    page.click("watch")
    page.wait(lambda: not page.is_shown("facts"))
    page.disconnect()
    page.connect(carrier)
    assert not page.is_shown("facts")
    assert not page.run("return watch.checked")


def test_a_program_is_downloaded_sent_started_and_stopped(page: Page) -> None:
    page.read("0x|08:00|01:00|00|04:00|81:01:60|")
    assert not page.is_shown("download")
    page.type(BLINKS)
    page.wait(lambda: page.is_shown("download"))
    page.run(
        "URL.createObjectURL = (blob) => { blob.arrayBuffer().then((data) => {"
        " saved = [...new Uint8Array(data)]; }); return 'about:blank#'; };"
        "saved = null; names = []; HTMLAnchorElement.prototype.click = function () { names.push(this.download); }"
    )
    page.click("download")
    page.wait(lambda: page.run("return saved"))
    assert page.run("return names") == ["program.rbf"]
    assert len(parse_program(bytes(page.run("return saved"))).objects) == 1
    page.connect("usb")
    page.wait(lambda: is_fact(page, "Battery"))
    page.click("send")
    allow(page, f"Writes {PROGRAM} on the brick, and starts it.")
    page.wait(lambda: "PROGRAM_START" in page.text("answer"))
    # It is among the files of the brick, from where it can be started again, and stopped.
    page.browser.find_element(By.CSS_SELECTOR, "#brick-files summary").click()
    page.wait(lambda: "playground/" in page.text("brick-list"))
    page.browser.find_element(By.XPATH, "//ul[@id='brick-list']//button[text()='playground/']").click()
    page.wait(lambda: "playground.rbf" in page.text("brick-list"))
    page.browser.find_element(By.XPATH, "//button[text()='Start playground.rbf']").click()
    allow(page, "starts, stops or changes programs")
    page.wait(lambda: "PROGRAM_START" in page.text("answer"))
    page.click("stop-program")
    allow(page, "starts, stops or changes programs")
    page.wait(lambda: "PROGRAM_STOP" in page.text("answer"))


def test_among_two_bricks_the_browser_asks_which(page: Page) -> None:
    page.run("navigator.hid.permitted = [navigator.hid.device, new navigator.hid.device.constructor()]")
    page.connect("usb")
    assert page.fact("requests") == 1


def test_the_port_of_another_device_is_a_sentence(page: Page) -> None:
    page.steer(isStrange=True)
    page.connect("bluetooth")
    page.wait(lambda: "does not answer" in page.text("brick-status"))
    assert "is this the port of a brick?" in page.text("brick-status")
    page.disconnect()
    assert "Not connected" in page.text("brick-status")


def test_a_brick_that_falls_asleep_is_a_sentence_until_it_wakes(page: Page) -> None:
    page.connect("bluetooth")
    page.wait(lambda: is_fact(page, "Battery"))
    page.steer(isSilent=True)
    page.wait(lambda: "does not answer. Is it asleep" in page.text("brick-status"))
    page.steer(isSilent=False)
    page.wait(lambda: "Connected by Bluetooth" in page.text("brick-status"))


class Keyboard:
    """Someone who has no mouse."""

    def __init__(self, page: Page) -> None:
        self._page = page

    def press(self, *keys: str) -> None:
        """Presses keys one after the other."""
        ActionChains(self._page.browser).send_keys(*keys).perform()

    def reach(self, selector: str) -> None:
        """Presses Tab until an element has the focus."""
        has = "return Boolean(document.activeElement.matches(arguments[0]))"
        for _ in range(150):
            if self._page.run(has, selector):
                return
            self.press(Keys.TAB)
        raise AssertionError(f"Tab does not reach {selector}")

    def push(self, selector: str) -> None:
        """Pushes a button."""
        self.reach(selector)
        self.press(Keys.ENTER)

    def write(self, text: str) -> None:
        """Replaces the input."""
        self.reach("#input")
        ActionChains(self._page.browser).key_down(Keys.CONTROL).send_keys("a").key_up(Keys.CONTROL).perform()
        self.press(text)

    def agree(self, question: str) -> None:
        """Reads a question, and agrees."""
        page = self._page
        page.wait(lambda: page.is_shown("allow"))
        assert question in page.text("ask")
        self.push("#allow")
        page.wait(lambda: not page.is_shown("allow"))


def test_a_lesson_by_keyboard(page: Page) -> None:
    keyboard = Keyboard(page)
    # The brick is connected, and its panel tells of it.
    keyboard.push("#connect-usb")
    page.wait(lambda: page.connection == "usb" and is_fact(page, "Name", "Battery"))
    # Reading needs no question: the battery.
    keyboard.write("UI_READ(GET_VBATT, GV0(0))")
    page.wait(lambda: page.text("sentence") == "Reads the battery voltage.")
    keyboard.push("#send")
    page.wait(lambda: "VALUE = 7.5 V" in page.text("answer"))
    # A mistake, and its remedy.
    keyboard.write("0x|08:00|2A:00|00|01:00|81:01:60|")
    page.wait(lambda: page.texts("#remedies button") == ["Request 4 bytes of global and 0 of local memory"])
    keyboard.push("#remedies button")
    page.wait(lambda: page.text("verdict") == "The brick takes it.")
    # A tone as bytes, which the operations make an octave higher.
    keyboard.write("0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|")
    page.wait(lambda: page.text("sentence") == "Plays 440 Hz for 1 s at volume 1 %.")
    keyboard.reach("#tabs [aria-selected=true]")
    keyboard.press(Keys.ARROW_LEFT)
    page.wait(lambda: page.is_shown("operations"))
    keyboard.reach("#operations textarea")
    page.wait(lambda: page.run("return document.activeElement.value").endswith("SOUND(TONE,1,440,1000)"))
    ActionChains(page.browser).key_down(Keys.CONTROL).send_keys(Keys.END).key_up(Keys.CONTROL).perform()
    keyboard.press(*[Keys.ARROW_LEFT] * len(",1000)"), *[Keys.BACKSPACE] * 3, "880")
    page.wait(lambda: page.text("sentence") == "Plays 880 Hz for 1 s at volume 1 %.")
    keyboard.push("#send")
    keyboard.agree("SOUND.TONE")
    page.wait(lambda: any(sent.endswith("94010182700382e803") for sent in page.fact("sent")))
    # Motors run when that is allowed, and stop without a question.
    keyboard.write("OUTPUT_SPEED(0, A, 50)\nOUTPUT_START(0, A)")
    page.wait(lambda: page.text("sentence") == "Sets the speed of motor A to 50 %, then starts motor A.")
    keyboard.push("#send")
    keyboard.agree("makes motors turn or stop")
    keyboard.push("#stop-motors")
    page.wait(lambda: any(sent.endswith("a3000f01") for sent in page.fact("sent")))
    # A program.
    keyboard.write(BLINKS)
    page.wait(lambda: page.is_shown("download"))
    keyboard.push("#send")
    keyboard.agree("and starts it.")
    page.wait(lambda: "PROGRAM_START" in page.text("answer"))
    # Its file is deleted, unless it is thought over.
    keyboard.push("#brick-files summary")
    page.wait(lambda: "playground/" in page.text("brick-list"))
    keyboard.reach("#brick-list li:last-child button")
    keyboard.press(Keys.ENTER)
    page.wait(lambda: "Delete playground.rbf" in page.text("brick-list"))
    keyboard.push("#brick-list li:last-child button:last-child")
    page.wait(lambda: page.is_shown("allow"))
    keyboard.press(Keys.ESCAPE)
    page.wait(lambda: not page.is_shown("allow"))
    assert "playground.rbf" in page.text("brick-list")
    # And good-bye.
    keyboard.push("#disconnect")
    page.wait(lambda: page.connection == "none" and page.is_shown("display"))

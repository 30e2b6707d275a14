"""The page of `ev3proto timeline` in a real browser: it fits the window, also of a phone, and takes a finger."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest
from selenium.webdriver import Chrome
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.support.ui import WebDriverWait
from support.browser import chromium, complaints
from support.cli import run_ev3proto_text as run

CAPTURE = "captures/wifi.pcapng"
RED = (208, 0, 0)
"""The colour of what was answered with an error."""

DRAWN = """
const canvas = document.querySelector("#timeline canvas");
if (!canvas || !canvas.width) return null;
const box = canvas.getBoundingClientRect();
const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
const scale = canvas.width / box.width;
const red = [];
let left = Infinity, right = 0;
for (let at = 0; at < data.length; at += 4) {
  const x = at / 4 % canvas.width / scale, y = Math.floor(at / 4 / canvas.width) / scale;
  if (Math.min(data[at], data[at + 1], data[at + 2]) < 235) { left = Math.min(left, x); right = Math.max(right, x); }
  if ([0, 1, 2].every((c) => Math.abs(data[at + c] - arguments[0][c]) < 16)) red.push([x + box.left, y + box.top]);
}
const page = document.documentElement, place = document.getElementById("timeline");
return { left: left + box.left, right: right + box.left, red, page: [page.scrollWidth, page.clientWidth],
         place: [place.scrollWidth, place.clientWidth] };
"""


class Look(NamedTuple):
    """What a window shows.

    left, right  pixels of the window between which something is drawn
    red          where there is red
    """

    left: float
    right: float
    red: list[tuple[float, float]]


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("timeline") / "wifi.html"
    assert run("timeline", CAPTURE, "-o", str(path)).returncode == 0
    return path.as_uri()


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chrome]:
    with chromium(tmp_path_factory.mktemp("browser") / "profile") as browser:
        yield browser


def opened(browser: Chrome, page: str, width: int, is_phone: bool = False) -> Look:
    """Opens the page in a window of a width, and looks whether it fits."""
    window = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": is_phone}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", window)
    browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": is_phone, "maxTouchPoints": 1})
    browser.get(page)
    return looked(browser)


def looked(browser: Chrome) -> Look:
    found: Any = WebDriverWait(browser, 60, 0.05).until(lambda _: browser.execute_script(DRAWN, RED))
    # Nothing is wider than the window, and nothing has to be scrolled sideways.
    assert found["page"][0] <= found["page"][1]
    assert found["place"][0] <= found["place"][1]
    return Look(found["left"], found["right"], [(x, y) for x, y in found["red"]])


@pytest.mark.parametrize("width", [1280, 800, 360])
def test_it_uses_the_window_and_no_more(browser: Chrome, page: str, width: int) -> None:
    look = opened(browser, page, width, is_phone=width < 500)
    assert look.left < 40
    assert width - 60 < look.right <= width
    assert complaints(browser) == []


def test_it_follows_the_window(browser: Chrome, page: str) -> None:
    opened(browser, page, 1280)
    window = {"width": 640, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", window)
    WebDriverWait(browser, 60, 0.05).until(lambda _: browser.execute_script(DRAWN, RED)["right"] <= 640)
    looked(browser)


def touch(browser: Chrome, kind: str, *points: tuple[float, float]) -> None:
    found = [{"x": x, "y": y} for x, y in points]
    browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": found})


def test_a_tap_shows_what_a_mark_says(browser: Chrome, page: str) -> None:
    look = opened(browser, page, 360, is_phone=True)
    # The legend has the first red there is; below it come the marks.
    first = min(y for _, y in look.red)
    x, y = min((place for place in look.red if place[1] > first + 40), key=lambda place: place[1])
    touch(browser, "touchStart", (x + 1, y + 3))
    touch(browser, "touchEnd")
    tip = "return document.querySelector('#vg-tooltip-element.visible')?.innerText"
    said: Any = WebDriverWait(browser, 60, 0.05).until(lambda _: browser.execute_script(tip))
    assert "UI_READ.GET_VBATT" in said
    assert "answered with an error" in said


def test_words_in_the_legend_choose_marks(browser: Chrome, page: str) -> None:
    look = opened(browser, page, 1280)
    x, y = min(look.red, key=lambda place: place[1])
    blue = (0, 114, 178)
    assert browser.execute_script(DRAWN, blue)["red"]
    ActionChains(browser).move_by_offset(int(x) + 30, int(y) + 3).click().perform()
    WebDriverWait(browser, 60, 0.05).until(lambda _: not browser.execute_script(DRAWN, blue)["red"])
    assert len(looked(browser).red) > 20


def test_a_finger_moves_time_sideways_and_the_page_up(browser: Chrome, page: str) -> None:
    before = opened(browser, page, 360, is_phone=True)
    touch(browser, "touchStart", (200, 500))
    for x in range(205, 245, 5):
        touch(browser, "touchMove", (x, 500))
    touch(browser, "touchEnd")
    lowest = max(y for _, y in before.red)

    def reds() -> list[float]:
        return [x for x, y in browser.execute_script(DRAWN, RED)["red"] if y == lowest]

    WebDriverWait(browser, 60, 0.05).until(
        lambda _: reds() and min(reds()) > 20 + min(x for x, y in before.red if y == lowest)
    )
    touch(browser, "touchStart", (200, 500))
    for y in range(490, 300, -10):
        touch(browser, "touchMove", (200, y))
    touch(browser, "touchEnd")
    WebDriverWait(browser, 60, 0.05).until(lambda _: browser.execute_script("return window.scrollY") > 100)

"""A real browser, Chromium, without a window."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from selenium.webdriver import Chrome, ChromeOptions
from selenium.webdriver.chrome.service import Service

LEAST_WINDOW = 500
"""Pixels below which Chromium makes no window narrower."""


def scrolls_sideways(browser: Any) -> bool:
    """Whether the page is wider than the window."""
    script = "return document.documentElement.scrollWidth > document.documentElement.clientWidth"
    return bool(browser.execute_script(script))


@contextmanager
def chromium(profile: Path, width: int = 1400) -> Iterator[Chrome]:
    """A browser that has never been used, and ends with the block.

    Args:
        profile: A folder that does not exist yet.
        width: Of its window, in pixels; one narrower than 500 is a phone's.
    """
    options = ChromeOptions()
    for argument in (
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
        f"--window-size={width},1000",
        f"--user-data-dir={profile}",
    ):
        options.add_argument(argument)
    if width < LEAST_WINDOW:
        metrics = {"width": width, "height": 900, "pixelRatio": 1}
        options.add_experimental_option("mobileEmulation", {"deviceMetrics": metrics})
    options.binary_location = "/usr/bin/chromium"
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = Chrome(options, Service("/usr/bin/chromedriver"))
    try:
        yield browser
    finally:
        browser.quit()


def complaints(browser: Any) -> list[str]:
    """What pages complained of on the console since the last call."""
    return [entry["message"] for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]

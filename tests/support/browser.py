"""A real browser, Chromium, without a window."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from selenium.webdriver import Chrome, ChromeOptions
from selenium.webdriver.chrome.service import Service

LEAST_WINDOW = 500
"""The minimum width of Chromium's windows, in pixels."""


def scrolls_sideways(browser: Any) -> bool:
    """Returns whether the page is wider than the window."""
    script = "return document.documentElement.scrollWidth > document.documentElement.clientWidth"
    return bool(browser.execute_script(script))


@contextmanager
def chromium(profile: Path, width: int = 1400) -> Iterator[Chrome]:
    """Yields a browser with a new profile, which is closed at the end of the block.

    Args:
        profile: A folder that does not exist yet.
        width: The width of its window, in pixels; less than 500 emulates a phone.
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


@contextmanager
def emulated(browser: Any, width: int, height: int, scale: int = 1, *, is_phone: bool = False) -> Iterator[None]:
    """Gives the page a screen of this size, in pixels of CSS, until the end of the block."""
    metrics = {"width": width, "height": height, "deviceScaleFactor": scale, "mobile": is_phone}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    try:
        yield
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def complaints(browser: Any) -> list[str]:
    """Returns the complaints of pages on the console since the last call."""
    return [entry["message"] for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]

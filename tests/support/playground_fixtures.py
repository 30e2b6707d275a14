"""The documentation as it is built, its address, and a browser, for all tests of the playground."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from selenium.webdriver import Chrome

from support.browser import chromium
from support.playground import put_fakes, served_site
from support.site import built_site


@pytest.fixture(scope="session")
def built() -> Path:
    """The documentation, as it is built."""
    return built_site()


@pytest.fixture(scope="module")
def address(built: Path) -> Iterator[str]:
    """The site, served as a folder is by Python."""
    with served_site(built) as address:
        yield address


@pytest.fixture(scope="session")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chrome]:
    """One browser for all tests, whose pages find fakes for USB and Bluetooth."""
    with chromium(tmp_path_factory.mktemp("browser") / "profile") as browser:
        put_fakes(browser)
        yield browser

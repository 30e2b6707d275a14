"""Makes docs/playground.png, the picture on the first page: `python docs/playground/screenshot.py SITE`.

SITE is the folder of the built documentation. The script needs chromium and chromium-driver, as the tests do.
"""

from __future__ import annotations

import http.server
import sys
import tempfile
import threading
from functools import partial
from pathlib import Path
from urllib.parse import quote

from selenium.webdriver.support.ui import WebDriverWait

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from support.browser import chromium  # noqa: E402

TEXT = "0x|08:00|01:00|00|05:00|81:01:61|"
SIZE = (1200, 920)
"""Pixels of the window."""


def main(site: Path, picture: Path) -> None:
    """Takes the picture: a frame that a brick refuses."""
    with (
        http.server.ThreadingHTTPServer(
            ("127.0.0.1", 0), partial(http.server.SimpleHTTPRequestHandler, directory=str(site))
        ) as server,
        tempfile.TemporaryDirectory() as folder,
        chromium(Path(folder) / "profile", SIZE[0]) as browser,
    ):
        threading.Thread(target=server.serve_forever, daemon=True).start()
        browser.set_window_size(*SIZE)
        browser.get(f"http://127.0.0.1:{server.server_port}/playground/index.html#text={quote(TEXT)}")
        found = "return document.querySelector('#findings').textContent.includes('help:')"
        WebDriverWait(browser, 60).until(lambda _: browser.execute_script(found))
        browser.save_screenshot(str(picture))
        server.shutdown()


if __name__ == "__main__":
    main(Path(sys.argv[1]), ROOT / "docs" / "playground.png")

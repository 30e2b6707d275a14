"""What the pages' pictures show, as the texts beside them: by these, tests see that a picture is out of date.

`docs/pictures` runs this module, which writes the texts and takes the picture of the playground.
"""

from __future__ import annotations

import re
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from urllib.parse import quote

from support.browser import chromium
from support.playground import Page, put_fakes, served_site
from support.wireshark import Tshark

ROOT = Path(__file__).parents[2]
PLAYGROUND = ROOT / "docs" / "playground.png"
DISSECTOR = ROOT / "dissector"
CAPTURE = ROOT / "captures" / "wifi.pcapng"
PACKETS = {"command": 13, "wireshark": 14}
"""The packet that a picture of Wireshark shows, by its name."""
COLUMNS = ("frame.number", "ip.src", "ip.dst", "ev3.msg_num", "_ws.col.Info")
FRAME = "0x|08:00|01:00|00|05:00|81:01:61|"
SIZE = (1200, 1250)
"""Pixels of the browser's window."""
_SHOWN = """
const options = new Set([...document.querySelectorAll("option")].map((each) => each.text));
const lines = document.getElementById("desk").innerText.split("\\n").filter((line) => !options.has(line));
// What follows is below the picture, and comes later.
lines.length = lines.indexOf("Dialogue");
const chosen = [...document.querySelectorAll("select")].map((each) => each.selectedOptions[0].text);
return [...lines, ...chosen].filter((line) => line.trim()).map((line) => `${line}\\n`).join("");
"""


def open_playground(page: Page) -> str:
    """Opens the playground with a frame that a brick refuses. Returns its text; of lists, what is chosen."""
    page.open(f"#text={quote(FRAME)}")
    page.wait(lambda: "help:" in page.text("findings") and page.texts("#remedies button") and page.text("sentence"))
    page.wait(lambda: page.text("status") == "" and page.text("battery"))
    return str(page.run(_SHOWN))


def dissector_texts(tshark: Tshark) -> dict[Path, str]:
    """Returns the packet list and the details of a message, the statistics and the exported files, by path."""
    fields = [word for column in COLUMNS for word in ("-e", column)]
    listed = tshark.run(CAPTURE, "-2", "-Y", "ev3", "-T", "fields", *fields)
    exported = tshark.folder / "exported"
    exported.mkdir()
    exported.chmod(0o777)
    settings = ("-o", "ev3_statistics.print:TRUE", "-o", f"ev3_statistics.export:{exported}")
    said = tshark.run(CAPTURE, *tshark.statistics, "-q", *settings).splitlines(keepends=True)
    texts = {"statistics": "", "export": ""}
    for line in said:
        name = "export" if line.startswith(str(exported)) else "statistics"
        texts[name] += line.replace(str(exported), exported.name)
    for name, packet in PACKETS.items():
        details = tshark.run(CAPTURE, "-2", "-Y", f"frame.number == {packet}", "-V", "-O", "ev3")
        # Releases of Wireshark write times differently.
        shown = re.sub(r"^ *\[Response time: .*\n", "", details[details.index("EV3: ") :], flags=re.MULTILINE)
        texts[name] = f"{listed}\n{shown}"
    return {DISSECTOR / f"{name}.txt": text for name, text in texts.items()}


def write(texts: Mapping[Path, str]) -> None:
    """Writes the texts beside their pictures."""
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8")
        print(path.relative_to(ROOT))


def main(site: Path) -> None:
    """Writes all texts, and takes the picture of the playground in a folder of the built documentation."""
    with Tshark.from_setting() as tshark:
        write(dissector_texts(tshark))
    with (
        tempfile.TemporaryDirectory() as folder,
        served_site(site) as address,
        chromium(Path(folder) / "profile", SIZE[0]) as browser,
    ):
        put_fakes(browser)
        browser.set_window_size(*SIZE)
        write({PLAYGROUND.with_suffix(".txt"): open_playground(Page(browser, address))})
        browser.save_screenshot(str(PLAYGROUND))
        print(PLAYGROUND.relative_to(ROOT))


if __name__ == "__main__":
    main(Path(sys.argv[1]))

"""The documentation: it builds without a warning, its links lead somewhere, its search finds what people look for."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from selenium.webdriver import Chrome
from selenium.webdriver.support.ui import WebDriverWait
from support.browser import chromium
from support.wireshark import Tshark

import ev3proto
from ev3proto.capture.filter.fields import places_of
from ev3proto.capture.filter.names import NAMES
from ev3proto.checking.checking import check
from ev3proto.generate.pages.examples import example_of, explained, system_example
from ev3proto.generate.pages.markdown import anchor
from ev3proto.generate.pages.operations import dialect_of, filter_name
from ev3proto.tables import AREAS, OPCODES
from ev3proto.tables.declaration import Effect, declarations
from ev3proto.tables.system import SYSTEM
from ev3proto.version import VERSION

pytest_plugins = ["support.playground_fixtures"]

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = sorted([*DOCS.rglob("*.md"), *ROOT.glob("*.md"), *ROOT.glob("*/README.md")])
LINK = re.compile(r"!?\[(?:[^\]\\]|\\.)*\]\(([^)\s]+)\)")


def without_code(text: str) -> str:
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE))


def headings(path: Path) -> list[str]:
    text = re.sub(r"^```.*?^```$", "", path.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    return [re.sub(r"`", "", found) for found in re.findall(r"^#+ (.*)$", text, re.MULTILINE)]


@pytest.fixture(scope="module")
def searching(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chrome]:
    """A browser for all searches."""
    with chromium(tmp_path_factory.mktemp("browser") / "profile") as browser:
        yield browser


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ("0x94", "sound.html#sound"),
        ("SOUND", "sound.html#sound"),
        ("tone", "sound.html#sound-tone"),
        ("SOUND.TONE", "sound.html#sound-tone"),
        ("LED_RED_FLASH", "ui.html#ui-write-led"),
        ("TYPE_COLOR", "enumerations.html#type"),
        ("0x9E", "input.html#input-readext"),
        ("WRITEMAILBOX", "system-commands.html#writemailbox"),
        ("BEGIN_DOWNLOAD", "system-commands.html#begin-download"),
    ],
)
def test_the_first_place_that_a_search_finds_is_the_entry_itself(
    searching: Chrome, built: Path, words: str, first: str
) -> None:
    """In a browser, as people search."""
    searching.get(f"{(built / 'search.html').as_uri()}?q={words}")
    shown = "return document.querySelector('#search-results li a')?.getAttribute('href')"
    link = WebDriverWait(searching, 10, 0.1).until(lambda browser: browser.execute_script(shown))
    assert link == f"reference/{first}"
    page, _, place = link.partition("#")
    assert f'id="{place}"' in (built / page).read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "place"),
    [
        ("battery", "reference/ui.html#ui-read-get-vbatt"),
        ("voltage", "reference/ui.html#ui-read-get-vbatt"),
        ("read a sensor", "reference/input.html#input-readsi"),
        ("light", "reference/ui.html#ui-write-led"),
        ("motor does not turn", "howto/first-steps.html"),
    ],
)
def test_a_search_finds_operations_by_what_they_do(searching: Chrome, built: Path, words: str, place: str) -> None:
    searching.get(f"{(built / 'search.html').as_uri()}?q={words}")
    shown = "return [...document.querySelectorAll('#search-results li a')].map(link => link.getAttribute('href'))"
    WebDriverWait(searching, 10, 0.1).until(lambda browser: place in browser.execute_script(shown))


def test_the_site_has_the_files_that_its_pages_tell_people_to_copy(built: Path) -> None:
    page = (built / "downloads.html").read_text(encoding="utf-8")
    files = {link.rpartition("/")[2]: built / link for link in re.findall(r'href="(_downloads/[^"]+)"', page)}
    for file in (*(ROOT / "exports").glob("ev3*"), *(ROOT / "dissector").glob("*.lua")):
        assert files[file.name].read_bytes() == file.read_bytes()


def test_pages_of_the_repository_are_pages_of_the_site(built: Path) -> None:
    assert "Each word has one meaning" in (built / "contributing.html").read_text(encoding="utf-8")
    assert 'href="exit-status.html"' in (built / "changelog.html").read_text(encoding="utf-8")


def test_every_place_that_the_search_knows_is_there(built: Path) -> None:
    index = (built / "searchindex.js").read_text(encoding="utf-8")
    known = json.loads(index.removeprefix("Search.setIndex(").removesuffix(")"))
    places = {(known["docnames"][row[0]], row[3]) for rows in known["objects"].values() for row in rows}
    assert len(places) > 500
    for page in {name for name, _ in places}:
        ids = set(re.findall(r'id="([^"]+)"', (built / f"{page}.html").read_text(encoding="utf-8")))
        assert {place for name, place in places if name == page} - ids == set(), page


def test_every_page_of_the_html_says_its_version(built: Path) -> None:
    pages = sorted(built.rglob("*.html"))
    assert len(pages) > 20
    for page in pages:
        assert f"ev3proto {VERSION}" in page.read_text(encoding="utf-8"), page


def test_every_page_of_the_html_has_an_icon(built: Path) -> None:
    for page in sorted(built.rglob("*.html")):
        (icon,) = re.findall(r'<link rel="(?:shortcut )?icon" href="([^"]+)"', page.read_text(encoding="utf-8"))
        assert (page.parent / icon).is_file(), page


@pytest.mark.parametrize("name", ["index.md", "tutorial.md", "reference/index.md", "reference/sound.md"])
def test_pages_have_their_version_without_a_build(name: str) -> None:
    assert re.findall(r"for ev3proto ([0-9.]+\d)", (DOCS / name).read_text(encoding="utf-8")) == [VERSION]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_links_anchors_and_images_lead_somewhere(page: Path) -> None:
    for target in LINK.findall(without_code(page.read_text(encoding="utf-8"))):
        if re.match(r"https?:", target):
            continue
        name, _, place = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        assert file.exists(), target
        if place:
            assert place in map(anchor, headings(file)), target


EXAMPLES = [(each, dialect) for each in declarations(OPCODES) if (dialect := dialect_of(each)) is not None]


def test_every_example_builds_and_the_brick_takes_it() -> None:
    assert len(EXAMPLES) > 450
    refused = set()
    for declaration, dialect in EXAMPLES:
        example = example_of(declaration, dialect)
        lines = [line.split("  ")[0] for line in explained(example.frame, dialect)]
        assert bytes.fromhex(" ".join(lines)) == example.frame, declaration.name
        if not check(example.frame, dialect=dialect).accepted:
            refused.add(declaration)
    assert all(each.is_newer or Effect.NEVER_RUNS in each.effects for each in refused)
    assert len(refused) < 10


def test_the_calls_of_the_examples_give_their_frames() -> None:
    from ev3proto import LV, Global, ops, system
    from ev3proto.ops import compat, xtended

    names: dict[str, Any] = {"ev3proto": ev3proto, "ops": ops, "system": system, "compat": compat, "xtended": xtended}
    names |= {"LV": LV, "Global": Global}
    for declaration, dialect in EXAMPLES:
        example = example_of(declaration, dialect)
        assert eval(example.call, dict(names)).build() == example.frame
    for entry in SYSTEM:
        example = system_example(entry)
        assert eval(example.call, dict(names)).build() == example.frame
        lines = [line.split("  ")[0] for line in explained(example.frame)]
        assert bytes.fromhex(" ".join(lines)) == example.frame


def test_every_name_of_filters_is_on_their_page() -> None:
    text = (DOCS / "reference" / "filters.md").read_text(encoding="utf-8")
    every_frame = text.partition("## Every frame\n")[2].partition("\n## ")[0]
    assert re.findall(r"^\| `(\w+)` \|", every_frame, re.MULTILINE) == [*NAMES]
    listed = re.findall(r"^\| `(\w+)` \|", text.partition("## All parameters and fields\n")[2], re.MULTILINE)
    assert listed == list(places_of())


def entries(page: str) -> dict[str, str]:
    """The text under each heading of a page of the reference."""
    text = (DOCS / "reference" / f"{page}.md").read_text(encoding="utf-8")
    parts = re.split(r"^#{2,3} (.+)$", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


@pytest.mark.parametrize("area", AREAS)
def test_every_operation_has_all_that_the_tables_know(area: str) -> None:
    found = entries(area)
    for each in declarations(AREAS[area]):
        entry = found[each.name]
        # Marks of Markdown are not part of the text.
        said = re.sub(r"\\(.)", r"\1", entry).lower()
        assert f"0x{each.opcode.number:02x}" in said, each.name
        assert each.text.lower() in said
        assert all(f"it {effect.value.lower()}." in said for effect in each.effects), each.name
        assert each.note is None or each.note.lower() in said
        rows = {row.split("`")[1]: row for row in re.findall(r"^\| `.*$", entry, re.MULTILINE)}
        assert list(rows) == [it.name for it in each.parameters]
        for it in each.parameters:
            row = re.sub(r"\\(.)", r"\1", rows[it.name])
            assert it.text.lower() in row.lower(), (each.name, it.name)
            assert it.unit is None or it.unit in row, (each.name, it.name)
            assert it.note is None or it.note.lower() in row.lower(), (each.name, it.name)
            assert it.enum is None or f"(enumerations.md#{anchor(it.enum.name)})" in row, (each.name, it.name)
            assert all(str(limit) in row for limit in it.range or ()), (each.name, it.name)
            assert all(f"{number}: {meaning}" in row for number, meaning in it.special.items()), (each.name, it.name)
        if each.dialects:
            assert "```python\nev3proto.command(" in entry
            assert re.search(r"```text\n(?:[0-9A-F]{2} )+ +length: ", entry), each.name
        assert "- In Wireshark: `ev3." in entry


def test_an_entry_in_full() -> None:
    text = (DOCS / "reference" / "sound.md").read_text(encoding="utf-8")
    entry = text.partition("### SOUND.TONE\n")[2].partition("\n### ")[0]
    assert "- Opcode `0x94`, CMD 1: it starts with `94 01`." in entry
    assert "| `FREQUENCY` | in | DATA16 | Pitch; the driver clamps it to the range (250 to 10000 Hz). |" in entry
    assert "ev3proto.command(ops.sound.tone(volume=50, frequency=440, duration=1000), counter=1)" in entry
    assert "82 B8 01  FREQUENCY = 440 Hz  LC2" in entry
    assert "`ev3.sound.tone.frequency`" in entry


def test_the_fields_are_those_of_the_dissector(tshark: Tshark) -> None:
    command = [str(tshark.path), "-G", "fields", *tshark.words]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    known = {line.split("\t")[2] for line in listed.splitlines() if line.startswith("F\t") and "\tev3." in line}
    named = {filter_name(each, it) for each in declarations(OPCODES) if each.dialects for it in each.parameters}
    assert named - known == set()
    text = (DOCS / "reference" / "system-commands.md").read_text(encoding="utf-8")
    assert set(re.findall(r"`(ev3\.\w+)`", text)) - known == set()

"""The contents of a release. tests/release.py tries one that was built; building takes a minute and the network."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from ev3proto.version import VERSION

ROOT = Path(__file__).parents[2]


def test_a_tag_that_is_not_the_version() -> None:
    done = subprocess.run([ROOT / "bin" / "release", "v9.9.9"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == (f"bin/release: the tag is v9.9.9, and ev3proto/version.py has {VERSION}: make them agree\n")


def test_the_change_log_has_the_version() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.findall(r"^## (.*)", text, re.MULTILINE)[0] == VERSION


def test_the_change_log_has_a_line_for_each_thing_under_its_area() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    for area in text.split("\n## ")[1:]:
        before, *areas = area.split("\n### ")
        assert "\n-" not in before
        assert all(line.startswith("- ") for each in areas for line in each.splitlines()[2:] if line)


def test_the_documentation_names_the_files_of_this_version() -> None:
    text = (ROOT / "docs" / "howto" / "install.md").read_text(encoding="utf-8")
    assert set(re.findall(r"ev3proto-(\d+\.\d+\.\d+)", text)) == {VERSION}

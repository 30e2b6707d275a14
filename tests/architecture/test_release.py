"""The contents of a release. tests/release.py tries one that was built; building takes a minute and the network."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

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


def released(tmp_path: Path, origin: str, **environment: str) -> tuple[dict[str, str], str, str]:
    """Returns the addresses in pyproject.toml, the request for reports, and how SECURITY.md says where to report."""
    clone, sources = tmp_path / "clone", tmp_path / "sources"
    (clone / "bin").mkdir(parents=True)
    shutil.copy2(ROOT / "bin" / "addresses", clone / "bin")
    (sources / "ev3proto").mkdir(parents=True)
    for name in ("pyproject.toml", "ev3proto/version.py", "SECURITY.md"):
        shutil.copy2(ROOT / name, sources / name)
    subprocess.run(["git", "init", "-q", clone], check=True)
    if origin:
        subprocess.run(["git", "-C", clone, "remote", "add", "origin", origin], check=True)
    variables = {name: text for name, text in os.environ.items() if not name.startswith("GITHUB_")} | environment
    subprocess.run([clone / "bin" / "addresses", sources], env=variables, check=True)
    assert sorted(path.name for path in sources.rglob("*") if path.is_file()) == [
        *("SECURITY.md", "pyproject.toml", "version.py"),
    ]
    names: dict[str, str] = {}
    exec((sources / "ev3proto" / "version.py").read_text(), names)
    project = tomllib.loads((sources / "pyproject.toml").read_text())["project"]
    (how,) = re.findall(r"privately through (.*?),", (sources / "SECURITY.md").read_text())
    return project.get("urls", {}), names["REPORT_IT"], how


@pytest.mark.parametrize(
    ("origin", "environment"),
    [
        ("https://example.org/fork.git", {"GITHUB_REPOSITORY": "me/it", "GITHUB_SERVER_URL": "https://git.example"}),
        ("git@git.example:me/it.git", {}),
        ("ssh://git@git.example/me/it.git", {}),
        ("https://me:secret@git.example/me/it/", {}),
    ],
)
def test_a_release_has_the_address_of_its_repository(tmp_path: Path, origin: str, environment: dict[str, str]) -> None:
    urls, request, how = released(tmp_path, origin, **environment)
    assert urls == {
        "Source": "https://git.example/me/it",
        "Issues": "https://git.example/me/it/issues",
        "Changelog": "https://git.example/me/it/blob/main/CHANGELOG.md",
    }
    assert request == "please report it at https://git.example/me/it/issues"
    assert how == "<https://git.example/me/it/security/advisories/new>"


@pytest.mark.parametrize("origin", ["", "/srv/git/it", "https://git.example", "https://git.example/$(id)/x"])
def test_a_release_without_an_address_has_none(tmp_path: Path, origin: str) -> None:
    assert released(tmp_path, origin) == ({}, "please report it", "the security advisories of the repository")

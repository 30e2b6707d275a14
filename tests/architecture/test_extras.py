"""The command that installs an extra fits how ev3proto was installed; every message about a missing package has it."""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

import pytest
from support.cli import run_program

from ev3proto.extras import fitting_command, install_command

ROOT = Path(__file__).parents[2]


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """A clone in which bin/ev3proto was called."""
    setup = tmp_path / "ev3 clone" / "bin" / "setup"
    setup.parent.mkdir(parents=True)
    setup.touch()
    environment(setup.parents[1] / ".venv")
    return setup.parents[1]


def environment(folder: Path) -> Path:
    """The interpreter of a new virtual environment."""
    python = folder / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.touch()
    return python


def test_in_a_clone(clone: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    prefix = clone / ".venv"
    python = prefix / "bin" / "python"
    elsewhere = fitting_command("usb", clone, prefix, python, is_windows=False)
    assert elsewhere == f"'{clone}/bin/setup' usb"
    monkeypatch.chdir(clone)
    assert fitting_command("usb", clone, prefix, python, is_windows=False) == "bin/setup usb"


def test_in_an_environment_that_pipx_made(tmp_path: Path) -> None:
    prefix = tmp_path / "pipx" / "venvs" / "ev3proto"
    python = environment(prefix)
    (prefix / "pipx_metadata.json").touch()
    assert fitting_command("usb", tmp_path, prefix, python, is_windows=False) == "pipx inject ev3proto 'ev3proto[usb]'"
    assert fitting_command("usb", tmp_path, prefix, python, is_windows=True) == 'pipx inject ev3proto "ev3proto[usb]"'


def test_in_an_environment_of_your_own(clone: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    prefix = tmp_path / "mine"
    python = environment(prefix)
    monkeypatch.setenv("PATH", f"{prefix / 'bin'}:/usr/bin")
    assert fitting_command("usb", clone, prefix, python, is_windows=False) == "python -m pip install 'ev3proto[usb]'"
    monkeypatch.setenv("PATH", "/usr/bin")
    expected = f"{python} -m pip install 'ev3proto[usb]'"
    assert fitting_command("usb", clone, prefix, python, is_windows=False) == expected


def test_in_an_environment_on_windows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    prefix = tmp_path / "mine"
    expected = f'{prefix / "python.exe"} -m pip install "ev3proto[usb]"'
    assert fitting_command("usb", tmp_path, prefix, prefix / "python.exe", is_windows=True) == expected
    monkeypatch.setenv("PATH", str(prefix))
    prefix.mkdir()
    (prefix / "python.exe").touch()
    expected = 'python -m pip install "ev3proto[usb]"'
    assert fitting_command("usb", tmp_path, prefix, prefix / "python.exe", is_windows=True) == expected


@pytest.mark.parametrize(
    ("missing", "program", "extra"),
    [
        ("hypothesis", "import ev3proto.testing", "sample"),
        ("scapy", "import ev3proto.scapy", "scapy"),
        ("hid", "import ev3proto; ev3proto.EV3(protocol=ev3proto.USB)", "usb"),
        ("serial", "import ev3proto; ev3proto.EV3(target='serial:/dev/null')", "serial"),
        ("aiohttp", "from ev3proto.cli.commands import cli; cli(['brick', '--port', '0', '--http'])", "page"),
    ],
)
def test_a_missing_package_is_reported_with_the_command(missing: str, program: str, extra: str) -> None:
    done = run_program(sys.executable, "-c", f"import sys; sys.modules[{missing!r}] = None; {program}")
    assert done.returncode == 1
    assert f"which is not installed: {install_command(extra)}" in done.stderr.splitlines()[-1]


def test_the_extras_that_are_named_are_those_of_the_project() -> None:
    known = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "ev3proto").rglob("*.py"))
    named = set(re.findall(r"""install_command\(["'](\w+)["']\)""", sources))
    assert len(named) == 6
    assert named <= set(known)

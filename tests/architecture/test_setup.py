"""bin/setup survives: interrupted, twice at once, in a checkout that was moved, without rights. And the tests' lock.

A program takes the place of Python and pip here, and quickly makes something that looks like an environment.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
import urllib.request
from importlib.metadata import PackageNotFoundError, requires
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[2]
LOCK = ROOT / "tests" / "requirements.lock"

PYTHON = r"""#!/bin/bash
here=$(cd "$(dirname "$0")" && pwd)
case "$*" in
"-m venv "*) mkdir -p "$3/bin"; cp "$0" "$3/bin/python"; echo "command = $PWD/$3" >"$3/pyvenv.cfg" ;;
"-m pip install "*)
    echo "$*" >>"$CALLS"
    for _ in $(seq "$TAKES"); do [ -e "$CALLS.enough" ] || sleep 0.1; done
    case "$here" in
    *" "*) printf '#!/bin/sh\nexec "%s/python" "$0" "$@"\n' "$here" ;;  # as pip does it
    *) printf '#!%s/python\n' "$here" ;;
    esac >"$here/ev3proto"
    chmod +x "$here/ev3proto" ;;
esac
"""
"""Records what it installs. It takes some tenths of a second, at most until `calls.enough` exists."""


class Checkout:
    """A copy of what bin/setup needs, with a fake Python."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "checkout"
        (self.folder / "bin").mkdir(parents=True)
        (self.folder / "tests").mkdir()
        for name in ("bin/setup", "pyproject.toml", "tests/requirements.lock"):
            shutil.copy2(ROOT / name, self.folder / name)
            os.utime(self.folder / name, (1, 1))
        (folder / "python3").write_text(PYTHON)
        (folder / "python3").chmod(0o755)
        self.calls = folder / "calls"
        self.calls.touch()
        self.env = {"PATH": f"{folder}:{os.environ['PATH']}", "CALLS": str(self.calls)}

    def start(self, *words: str, takes: int = 0) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [self.folder / "bin" / "setup", *words],
            env={**self.env, "TAKES": str(takes)},
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )

    def run(self, *words: str) -> str:
        process = self.start(*words)
        _, said = process.communicate(timeout=30)
        assert process.returncode == 0, said
        assert self.works()
        return said

    def works(self) -> bool:
        script = self.folder / ".venv" / "bin" / "ev3proto"
        return subprocess.run([script, "--version"], check=False).returncode == 0

    @property
    def installed(self) -> list[str]:
        return self.calls.read_text().splitlines()

    def wait_for_pip(self) -> None:
        until = time.monotonic() + 30
        while not self.installed:
            assert time.monotonic() < until
            time.sleep(0.01)


@pytest.fixture
def checkout(tmp_path: Path) -> Checkout:
    return Checkout(tmp_path)


def test_the_second_time_there_is_nothing_to_do(checkout: Checkout) -> None:
    assert "making .venv" in checkout.run()
    assert checkout.run() == ""
    assert len(checkout.installed) == 1
    assert "up to date" in checkout.run("test")
    assert len(checkout.installed) == 2


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_interrupted_while_it_is_brought_up_to_date(checkout: Checkout, number: signal.Signals) -> None:
    """The packages of the existing environment may be half removed by then."""
    checkout.run()
    checkout.calls.write_text("")
    process = checkout.start("test", takes=600)
    checkout.wait_for_pip()
    os.killpg(process.pid, number)
    process.communicate(timeout=30)
    assert process.returncode
    assert "making .venv" in checkout.run()
    assert not (checkout.folder / ".venv.new").exists()
    assert checkout.run() == ""


def test_twice_at_once(checkout: Checkout) -> None:
    first = checkout.start(takes=600)
    checkout.wait_for_pip()
    second = checkout.start()
    assert second.stderr is not None
    assert "another one is at work here" in second.stderr.readline()
    checkout.calls.with_suffix(".enough").touch()
    for process in (first, second):
        process.communicate(timeout=30)
        assert process.returncode == 0
    assert checkout.works()
    assert len(checkout.installed) == 1


def test_a_checkout_that_was_moved(checkout: Checkout) -> None:
    checkout.run()
    checkout.folder = checkout.folder.rename(checkout.folder.with_name("[old] issue #1 & Übung a.*"))
    assert "making .venv" in checkout.run()
    assert checkout.run() == ""
    assert str(checkout.folder) in (checkout.folder / ".venv" / "bin" / "ev3proto").read_text()


def test_without_the_module_venv_and_the_right_to_install_it(checkout: Checkout, tmp_path: Path) -> None:
    """As on a bare Debian, for a user whom sudo refuses: what an administrator has to do, not what this user tried."""
    for name, does in {
        "id": "echo 1000",
        "sudo": "exit 1",
        "python3": 'case "$*" in *ensurepip*) exit 1 ;; esac',
    }.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{does}\n")
        (tmp_path / name).chmod(0o755)
    process = checkout.start()
    _, said = process.communicate(timeout=30)
    assert process.returncode == 2
    assert said.splitlines()[-1] == (
        "bin/setup: python3-venv could not be installed; have an administrator run:"
        " apt-get install --no-install-recommends python3-venv"
    )


def test_the_playground_is_served_and_its_link_printed(tmp_path: Path) -> None:
    """The last step of bin/playground, in a folder that takes the place of the built site."""
    (tmp_path / "playground").mkdir()
    (tmp_path / "playground" / "index.html").write_text("the page")
    server = subprocess.Popen(
        [sys.executable, ROOT / "docs" / "playground" / "serve.py", tmp_path],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert server.stdout is not None
    link = server.stdout.readline().strip()
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/playground/", link)
    with urllib.request.urlopen(link, timeout=30) as page:
        assert page.read() == b"the page"
    server.send_signal(signal.SIGINT)
    _, said = server.communicate(timeout=30)
    assert (server.returncode, said) == (0, "Open this link in a browser; Ctrl-C ends the server.\n")


def test_the_tests_get_the_versions_of_the_lock(checkout: Checkout) -> None:
    checkout.run("test")
    assert checkout.installed[-1].endswith("--editable .[test] --constraint tests/requirements.lock")
    os.utime(checkout.folder / "tests" / "requirements.lock")
    checkout.run("test")
    assert len(checkout.installed) == 2
    checkout.run()
    assert "--constraint" not in checkout.installed[-1]


# The lock


def wanted() -> dict[str, list[Requirement]]:
    """The dependencies of the tests and their dependencies, with the versions that fit."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    left = [(Requirement(text), "") for text in [*project["dependencies"], "ev3proto[test]"]]
    found: dict[str, list[Requirement]] = {}
    seen = set()
    while left:
        need, extra = left.pop()
        name = canonicalize_name(need.name)
        if (need.marker is not None and not need.marker.evaluate({"extra": extra})) or (str(need), extra) in seen:
            continue
        seen.add((str(need), extra))
        if name == "ev3proto":
            left += [(Requirement(text), "") for one in need.extras for text in extras[one]]
            continue
        found.setdefault(name, []).append(need)
        try:
            texts = requires(name) or []
        except PackageNotFoundError:
            continue  # the lock is looked up by this name
        left += [(Requirement(text), one) for text in texts for one in ("", *need.extras)]
    return found


def locked() -> dict[str, str]:
    lines = [line for line in LOCK.read_text().splitlines() if not line.startswith("#")]
    assert all(re.fullmatch(r"[A-Za-z0-9._-]+==[A-Za-z0-9.+!]+", line) for line in lines), lines
    return {canonicalize_name(name): version for name, version in (line.split("==") for line in lines)}


def test_the_lock_has_what_the_tests_need() -> None:
    found, needs = locked(), wanted()
    stale = [
        f"{need} is not met by {name} {found.get(name, 'at all')}"
        for name, several in needs.items()
        for need in several
        if name not in found or not need.specifier.contains(found[name], prereleases=True)
    ]
    stale += [f"{name} is not needed any more" for name in sorted(found.keys() - needs.keys())]
    assert not stale, f"tests/requirements.lock is out of date, and tests/lock writes it anew: {stale}"


def test_dependencies_are_bound_to_tested_major_versions() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    texts = [*project["dependencies"], *(text for extra in project["optional-dependencies"].values() for text in extra)]
    open_ended = [
        text
        for text in texts
        if not any(one.operator in ("<", "==") for one in Requirement(text).specifier)
        and Requirement(text).name != project["name"]
    ]
    assert open_ended == []


def test_several_extras_at_once(checkout: Checkout) -> None:
    checkout.run("plot", "scapy")
    assert checkout.installed[-1].endswith("--editable .[plot,scapy]")
    checkout.run("scapy", "test")
    assert "--constraint" in checkout.installed[-1]
    process = checkout.start("plots")
    _, said = process.communicate(timeout=30)
    assert process.returncode == 2
    assert said.startswith("bin/setup: unknown extra 'plots'; it must be one of: docs page plot sample scapy")


def test_a_script_beside_the_clone_imports_the_package(tmp_path: Path) -> None:
    """And not the folder of the clone, as a namespace package."""
    (tmp_path / "ev3proto").symlink_to(ROOT)
    (tmp_path / "script.py").write_text("import ev3proto\nprint(ev3proto.parse(bytes.fromhex('06002a0000000001')))\n")
    done = subprocess.run([sys.executable, tmp_path / "script.py"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, ""), "with an older .venv, run tests/run once"
    assert "counter=42" in done.stdout


def test_the_first_call_installs_every_extra_that_users_need() -> None:
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    (words,) = re.findall(r'^"\$here/setup" (.*)$', (ROOT / "bin" / "ev3proto").read_text(), re.MULTILINE)
    assert words.split() == sorted(extras.keys() - {"docs", "test"})

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
from support.scripts import DESCRIPTIONS

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

NPM = r"""#!/bin/bash
echo "$*" >>"$CALLS.npm"
for word; do case "$word" in *@*) mkdir -p ".kaitai/node_modules/${word%@*}" ;; esac; done
"""
"""Records what it installs."""

FAILS = "#!/bin/sh\nexit 1\n"


class Checkout:
    """A copy of what bin/setup needs, with a fake Python."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "checkout"
        (self.folder / "bin").mkdir(parents=True)
        (self.folder / "tests").mkdir()
        (self.folder / "docs" / "playground").mkdir(parents=True)
        described = [f"docs/playground/{name}" for name in DESCRIPTIONS]
        for name in ("bin/setup", "bin/ev3proto", "pyproject.toml", "tests/requirements.lock", *described):
            shutil.copy2(ROOT / name, self.folder / name)
            os.utime(self.folder / name, (1, 1))
        self.programs = folder / "programs"
        self.programs.mkdir()
        self.program("python3", PYTHON)
        self.program("npm", NPM)
        self.calls = folder / "calls"
        self.calls.touch()
        self.env = {"PATH": f"{self.programs}:{os.environ['PATH']}", "CALLS": str(self.calls)}

    def program(self, name: str, text: str) -> None:
        """Puts a program before those of the system."""
        (self.programs / name).unlink(missing_ok=True)
        (self.programs / name).write_text(text)
        (self.programs / name).chmod(0o755)

    def leave_only(self, *names: str) -> None:
        """Takes away the programs of the system, except these."""
        for name in names:
            (self.programs / name).symlink_to(str(shutil.which(name)))
        self.env["PATH"] = str(self.programs)

    def fail(self, *words: str) -> tuple[int, str]:
        """The exit status of a call that fails, and the last line that it says."""
        process = self.start(*words)
        _, said = process.communicate(timeout=30)
        assert process.returncode, said
        return process.returncode, said.splitlines()[-1]

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

    @property
    def installed_by_npm(self) -> list[str]:
        return self.calls.with_suffix(".npm").read_text().splitlines()

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


BARE = ("bash", "sed", "tr", "dirname", "readlink", "basename", "cat", "cmp", "seq")
"""What the script needs of a bare Debian until it installs something."""


@pytest.mark.parametrize(
    ("extra", "missing"),
    [
        ("plot", "python3-venv"),
        ("docs", "npm python3-venv"),
        ("test", "npm tshark gcc libc6-dev g++ jq chromium chromium-driver python3-venv"),
    ],
)
def test_all_missing_packages_are_named_at_once(checkout: Checkout, extra: str, missing: str) -> None:
    """As on a bare Debian, for a user whom sudo refuses: what an administrator has to do, not what this user tried."""
    (checkout.programs / "npm").unlink()
    checkout.leave_only(*BARE)
    checkout.program("id", "#!/bin/sh\necho 1000\n")
    checkout.program("sudo", FAILS)
    checkout.program("python3", '#!/bin/sh\ncase "$*" in *ensurepip*) exit 1 ;; esac\n')
    assert checkout.fail(extra) == (
        2,
        "bin/setup: what is missing could not be installed; have an administrator run:"
        f" apt-get install --no-install-recommends {missing}",
    )


def test_without_a_network(checkout: Checkout) -> None:
    """After what pip and npm say: where they look may as well be wrong."""
    needs = "could not be installed: the first set-up, and one after an update, needs a network"
    pip = PYTHON.replace('    echo "$*" >>"$CALLS"', "    exit 1")
    checkout.program("python3", pip)
    assert checkout.fail("test") == (1, f"bin/setup: the Python packages {needs}")
    checkout.program("python3", PYTHON)
    checkout.program("npm", FAILS)
    assert checkout.fail("test") == (1, f"bin/setup: the compiler of Kaitai Struct {needs}")
    checkout.program("npm", NPM)
    checkout.run("test")


def test_the_tests_need_packages_of_npm(checkout: Checkout) -> None:
    versions = "kaitai-struct-compiler@0.11 kaitai-struct@0.11 js-yaml@4"
    kaitai = f"install --silent --no-audit --no-fund --prefix .kaitai {versions}"
    checks = "ci --silent --ignore-scripts --no-audit --no-fund"
    checkout.run("test")
    assert checkout.installed_by_npm == [kaitai, checks]
    assert checkout.run("test") == ""
    lock = checkout.folder / "docs" / "playground" / "package-lock.json"
    lock.write_text(lock.read_text() + "\n")
    checkout.run("test")
    assert checkout.installed_by_npm == [kaitai, checks, checks]
    assert len(checkout.installed) == 1, "pip is not called again"


@pytest.mark.parametrize("locale", ["C", "POSIX"])
def test_a_locale_without_umlauts(checkout: Checkout, locale: str) -> None:
    """Python 3.11 reads the path of an editable install in the encoding of the locale."""
    checkout.folder = checkout.folder.rename(checkout.folder.with_name("Übung"))
    environment = checkout.folder / ".venv"
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", environment], check=True)
    (packages,) = environment.glob("lib/python3*/site-packages")
    (packages / "editable.pth").write_text(f"{checkout.folder}\n", encoding="utf-8")
    script = environment / "bin" / "ev3proto"
    script.write_text(f'#!/bin/sh\nexec "{environment}/bin/python" -c "print(\'it starts\')"\n', encoding="utf-8")
    script.chmod(0o755)
    (environment / "installed-page,plot,sample,scapy,serial,usb,wireshark").touch()
    done = subprocess.run(
        [checkout.folder / "bin" / "ev3proto"],
        env={**checkout.env, "LC_ALL": locale},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "it starts\n", "")


def test_the_documentation_is_built_again_when_a_source_changes(tmp_path: Path) -> None:
    """A folder takes the place of the clone, and a program that of Sphinx: it counts."""
    for name in ("docs", "ev3proto", "sphinx"):
        (tmp_path / name).mkdir()
    shutil.copy(ROOT / "docs" / "building.py", tmp_path / "docs")
    (tmp_path / "README.md").write_text("read me")
    (tmp_path / "sphinx" / "__init__.py").touch()
    (tmp_path / "sphinx" / "__main__.py").write_text(
        "import pathlib, sys\nfolder = pathlib.Path(sys.argv[-1])\nfolder.mkdir(exist_ok=True)\n"
        "with (folder / 'built').open('a') as file:\n    file.write('x')\n"
    )

    def built() -> int:
        command = [sys.executable, str(tmp_path / "docs" / "building.py"), str(tmp_path / "site")]
        subprocess.run(command, check=True, capture_output=True, env={**os.environ, "PYTHONPATH": str(tmp_path)})
        return len((tmp_path / "site" / "built").read_text())

    assert [built(), built()] == [1, 1]
    (tmp_path / "README.md").touch()
    assert built() == 1
    (tmp_path / "README.md").write_text("read it")
    assert built() == 2
    (tmp_path / "ev3proto" / "new.py").touch()
    assert built() == 3


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

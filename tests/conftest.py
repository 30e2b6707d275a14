"""What all tests share: tshark, the marker of tests that use it, the settings of hypothesis, temporary files.

By default, hypothesis draws the same few examples in every run, so that a test fails by a change and not by chance.
With EV3PROTO_THOROUGH it draws many, new ones each time, and keeps those that fail.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, core, settings
from hypothesis.internal import reflection
from hypothesis.internal.conjecture import providers
from hypothesis.internal.constants_ast import Constants
from support import scratch
from support.digests import digest_of
from support.effort import THOROUGH
from support.wireshark import Tshark

from ev3proto.brick import Brick
from ev3proto.pyshark.tshark import Tshark as Engine

pytest_plugins = ["support.costs"]

# Hundreds of processes are started; without compiled modules, each would compile the package.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

# Few users set it, and without it output waits in a buffer, which reveals faults at the end of a program.
os.environ.pop("PYTHONUNBUFFERED", None)

# Processes that a shell starts in the background ignore Ctrl-C, and so do their children: tests that interrupt would
# wait forever.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Under nohup, processes and their children ignore that their terminal has gone.
if signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

settings.register_profile(
    "usual", max_examples=50, derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile(
    "thorough", max_examples=500, deadline=None, suppress_health_check=[HealthCheck.too_slow], print_blob=True
)
settings.load_profile("thorough" if THOROUGH else "usual")
if not THOROUGH:
    # Hypothesis takes some values from the source of all imported modules. Without that, a test has
    # the same examples whatever runs before it.
    providers._get_local_constants = Constants

# The examples of a test depend on its source, which is read again for each test that is made within another one.
vars(core)["function_digest"] = digest_of(reflection.function_digest)

# The folder where bin/setup installs the compiler of Kaitai Struct.
COMPILER = Path(__file__).parents[1] / ".kaitai" / "node_modules" / "kaitai-struct-compiler"
if COMPILER.is_dir():
    os.environ.setdefault("EV3PROTO_KSC", str(COMPILER))


def pytest_configure(config: pytest.Config) -> None:
    """Gives the session its own folder for temporary files, which must be empty at the end."""
    if not hasattr(config, "workerinput"):
        scratch.begin()


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Fails the session if files were left."""
    left = [] if hasattr(session.config, "workerinput") else scratch.end()
    if left:
        print(f"\nleft in the folder for temporary files: {', '.join(left)}")
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.fixture(scope="session")
def tshark() -> Iterator[Tshark]:
    """The tshark of EV3PROTO_TSHARK, or the default, with the dissector loaded.

    What it says of itself never changes, so ev3proto, which asks before each capture, really asks once.
    """
    with Tshark.from_setting() as tshark, pytest.MonkeyPatch.context() as patch:
        ask, answers = Engine.ask, dict[tuple[str, ...], str]()

        def ask_once(engine: Engine, *words: str) -> str:
            if engine.path != str(tshark.path):
                return ask(engine, *words)
            if words not in answers:
                answers[words] = ask(engine, *words)
            return answers[words]

        patch.setattr(Engine, "ask", ask_once)
        yield tshark


@pytest.fixture
def brick(tmp_path: Path) -> Brick:
    """A virtual brick with nothing plugged in, whose files are in an empty folder."""
    return Brick(tmp_path)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Lets `pytest -m wireshark` select the tests that depend on the version of tshark."""
    for item in items:
        if "tshark" in getattr(item, "fixturenames", ()):
            item.add_marker("wireshark")

"""What the documentation shows works: console blocks are run, programs are run and type-checked, C is compiled."""

from __future__ import annotations

import json
import os
import pdb
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from unittest import mock
from urllib.parse import urljoin

import pytest
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait
from support.announcing import Announcing, free_udp_port
from support.browser import chromium
from support.cli import run_ev3proto_text, run_program
from support.playground import put_fakes, served_site
from support.wireshark import Tshark

from ev3proto import DecodeError
from ev3proto.brick import Brick

ROOT = Path(__file__).parents[2]
PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "howto").glob("*.md")])
NAMES = [page.relative_to(ROOT).as_posix() for page in PAGES]
PORT = 5555
"""Where a brick listens in the texts; the tests take a free port."""


def blocks(page: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


def has(language: str) -> list[Path]:
    return [page for page in PAGES if blocks(page, language)]


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """A folder that looks like a clone, in which commands may write."""
    for name in ("bin", "captures", "dissector", "exports", "tests"):
        (tmp_path / name).symlink_to(ROOT / name)
    return tmp_path


class Session:
    """Commands one after the other, as in a terminal. A virtual brick goes on until the end, at a free port."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.port = PORT
        self._bricks: list[subprocess.Popen[str]] = []
        path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
        self._environment = {**os.environ, "PATH": path}

    def run(self, command: str) -> str:
        """What a command prints on standard output."""
        command = command.replace("bin/ev3proto", "ev3proto").replace(f":{PORT}", f":{self.port}")
        if command.startswith("ev3proto brick"):
            return self._brick(command)
        if command.startswith("ev3proto ") and not re.search(r"[|;<>&$*]", re.sub(r"'[^']*'|\"[^\"]*\"", "", command)):
            # No shell is needed, and no process.
            done = run_ev3proto_text(*shlex.split(command)[1:], cwd=self._folder)
        else:
            done = run_program("bash", "-c", command, cwd=self._folder, env=self._environment)
        return done.stdout.replace(f":{self.port}", f":{PORT}")

    def _brick(self, command: str) -> str:
        words = [*command.split(), "--port", "0", "--no-beacon", "--root", str(self._folder / "root")]
        brick = subprocess.Popen(words, env=self._environment, stdout=subprocess.PIPE, text=True)
        self._bricks.append(brick)
        assert brick.stdout is not None
        line = brick.stdout.readline()
        self.port = int(line.rpartition(":")[2])
        return line.replace(str(self.port), str(PORT))

    def end(self) -> None:
        """Switches the bricks off."""
        for brick in self._bricks:
            brick.terminate()
            brick.communicate(timeout=30)


@pytest.fixture
def session(clone: Path) -> Iterator[Session]:
    found = Session(clone)
    yield found
    found.end()


@pytest.mark.parametrize("page", has("console"), ids=lambda page: page.relative_to(ROOT).as_posix())
def test_the_commands_print_what_is_shown(page: Path, session: Session) -> None:
    for block in blocks(page, "console"):
        command, _, output = block.removeprefix("$ ").partition("\n")
        assert session.run(command) == output, command


@pytest.mark.parametrize("page", has("python"), ids=lambda page: page.relative_to(ROOT).as_posix())
def test_the_programs_run_one_after_the_other(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    names: dict[str, object] = {}
    for program in blocks(page, "python"):
        if page.name == "README.md":
            names = {}  # readers copy one of them
        exec(compile(program, page.name, "exec"), names)


def test_the_tests_with_the_virtual_brick_pass() -> None:
    page = ROOT / "docs" / "howto" / "test-your-library.md"
    names: dict[str, Any] = {}
    exec("\n".join(blocks(page, "python")), names)
    tests = [name for name in names if name.startswith("test_")]
    assert len(tests) == 4
    for name in tests:
        names[name]()


def test_the_picture_of_voltages_has_their_values(monkeypatch: pytest.MonkeyPatch) -> None:
    """A module that records takes the place of matplotlib, which no other test needs."""
    (program,) = blocks(ROOT / "docs" / "howto" / "read.md", "py")
    drawn = mock.MagicMock()
    monkeypatch.setitem(sys.modules, "matplotlib", drawn)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", drawn.pyplot)
    monkeypatch.chdir(ROOT)
    exec(program, {})
    (times, voltages), _ = drawn.pyplot.plot.call_args
    assert times == [0, pytest.approx(0.07279, abs=1e-6)]
    assert voltages == [pytest.approx(7.92, abs=0.01), pytest.approx(7.88, abs=0.01)]
    drawn.pyplot.savefig.assert_called_once_with("battery.png")


def test_the_test_of_the_tutorial_prints_what_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    page = ROOT / "docs" / "tutorial.md"
    exec("\n".join(blocks(page, "python")), {})
    assert capsys.readouterr().out == blocks(page, "text")[-1]


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the programs of each page in one file."""
    folder = tmp_path_factory.mktemp("programs")
    for page, name in zip(PAGES, NAMES, strict=True):
        if blocks(page, "python"):
            file = folder / f"{re.sub(r'[^a-z]', '_', name.lower())}.py"
            file.write_text("\n".join(blocks(page, "python")))
    return folder


def test_mypy_finds_nothing_in_the_programs(programs: Path) -> None:
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file", str(ROOT / "pyproject.toml")]
    done = run_program(*command, *sorted(programs.glob("*.py")))
    assert done.returncode == 0, done.stdout


def test_pyright_finds_nothing_in_the_programs(programs: Path) -> None:
    settings = {"extraPaths": [str(ROOT)], "include": ["*.py"], "reportMissingModuleSource": False}
    (programs / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, "--project", str(programs)]
    done = run_program(*command)
    assert done.returncode == 0, done.stdout


def test_the_generator_writes_functions_of_all_operations(clone: Path) -> None:
    page = ROOT / "docs" / "howto" / "your-language.md"
    (program,) = blocks(page, "py")
    assert run_program(sys.executable, "-c", program, cwd=clone).stdout == blocks(page, "text")[0]
    functions = (clone / "operations.go").read_text()
    assert (
        "func SoundTone(aVolume Arg, aFrequency Arg, aDuration Arg) []byte "
        "{ return op(0x94, LC(1), aVolume, aFrequency, aDuration) }\n"
    ) in functions
    assert "func InitBytes(aDestination Arg, values ...Arg) []byte" in functions


@pytest.mark.parametrize("number", [-2, -1], ids=["make", "read"])
def test_the_modules_make_and_read_what_is_shown(tmp_path: Path, number: int) -> None:
    page = ROOT / "docs" / "howto" / "javascript.md"
    for name in ("ev3.mjs", "ev3-decode.mjs"):
        (tmp_path / name).symlink_to(ROOT / "exports" / name)
    (tmp_path / "program.mjs").write_text(blocks(page, "javascript")[number])
    done = run_program("node", "program.mjs", cwd=tmp_path)
    assert done.stdout == blocks(page, "text")[number]


def test_the_c_programs_print_what_is_shown(tmp_path: Path) -> None:
    page = ROOT / "docs" / "howto" / "c.md"
    for program, shown in zip(blocks(page, "c"), blocks(page, "text"), strict=True):
        source = tmp_path / "program.c"
        source.write_text(program)
        made = tmp_path / "program"
        words = ["cc", "-std=c99", "-Wall", "-Werror", f"-I{ROOT / 'exports'}", str(source), "-o", str(made)]
        subprocess.run(words, check=True)
        assert subprocess.run([str(made)], capture_output=True, text=True, check=True).stdout == shown


def test_the_javascript_program_reads_the_frame(tmp_path: Path) -> None:
    page = ROOT / "docs" / "howto" / "javascript.md"
    compiling, reading, *_ = blocks(page, "javascript")
    shown, *_ = blocks(page, "text")
    (tmp_path / "ev3.ksy").symlink_to(ROOT / "exports" / "ev3.ksy")
    # Where bin/setup has installed what the page tells its readers to install.
    compiler = os.environ.get("EV3PROTO_KSC")
    assert compiler is not None, "run bin/setup test"
    environment = {"NODE_PATH": str(Path(compiler).parent)}
    for name, program in (("compile.js", compiling), ("read.js", reading)):
        (tmp_path / name).write_text(program)
        done = run_program("node", name, cwd=tmp_path, env=environment)
        assert (done.returncode, done.stderr) == (0, ""), "run bin/setup test"
    assert done.stdout == shown


def test_the_transfer_on_the_page_of_the_protocol_is_what_a_brick_says(tmp_path: Path) -> None:
    page = (ROOT / "docs" / "protocol.md").read_text(encoding="utf-8")
    lines = page.partition("sends three bytes to the brick:")[2].partition("A listing is text")[0]
    begin, begun, continued, ended = [
        bytes.fromhex(line.replace(":", "").replace("|", "")) for line in re.findall(r"^0x\|(\S+)", lines, re.MULTILINE)
    ]
    brick = Brick(root=tmp_path)
    assert brick.receive(begin) == [begun]
    assert brick.receive(continued) == [ended]


@pytest.fixture
def node_client(tmp_path: Path) -> Path:
    """A folder with the client that docs/howto/client.md shows."""
    page = ROOT / "docs" / "howto" / "client.md"
    for name, program in zip(("client.mjs", "robot.mjs"), blocks(page, "javascript"), strict=True):
        (tmp_path / name).write_text(program)
    for name in ("ev3.mjs", "ev3-decode.mjs"):
        (tmp_path / name).symlink_to(ROOT / "exports" / name)
    assert (tmp_path / "client.mjs").read_text().count("\n") == 94
    return tmp_path


def node(folder: Path, *words: str) -> str:
    done = run_program("node", *words, cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def test_the_client_in_javascript_works_with_the_virtual_brick(node_client: Path, session: Session) -> None:
    brick = session.run("ev3proto brick --no-beacon --quiet")
    (shown,) = blocks(ROOT / "docs" / "howto" / "client.md", "text")
    address = f"127.0.0.1:{session.port}"
    assert brick == f"listening on 127.0.0.1:{PORT}\n"
    assert node(node_client, "robot.mjs", address) == shown
    assert node(node_client, "robot.mjs", address) == shown, "the brick serves the next client"


def test_the_client_in_javascript_gives_each_command_its_reply(node_client: Path, session: Session) -> None:
    session.run("ev3proto brick --no-beacon --quiet --delay 0.05")
    program = f"""
        import {{ Brick }} from "./client.mjs";
        import {{ GV, ops }} from "./ev3.mjs";
        const brick = await Brick.connect({{ host: "127.0.0.1", port: {session.port} }});
        const move = (n) => ops.MOVE32_32(n, GV(40));
        const asked = [7, 300, -70000].map((n) => brick.direct([move(n)], {{ globals: 44 }}));
        asked.push(brick.direct([ops.UI_WRITE.PUT_STRING("text")]));
        for (const [output] of await Promise.all(asked)) console.log(output?.name, output?.value);
        console.log(await brick.direct([move(1)], {{ reply: false }}));
        brick.close();
    """
    expected = "DESTINATION 7\nDESTINATION 300\nDESTINATION -70000\nundefined undefined\nnull\n"
    assert node(node_client, "--input-type=module", "-e", program) == expected


def test_the_client_in_javascript_finds_a_brick_by_its_beacon(node_client: Path) -> None:
    port = free_udp_port()
    program = f"import {{ find }} from './client.mjs'; console.log(JSON.stringify(await find({port})))"
    with Announcing("0016533f0c1e", 5556, to=port):
        found = json.loads(node(node_client, "--input-type=module", "-e", program))
    assert found == {"host": "127.0.0.1", "port": 5556, "serial": "0016533f0c1e", "name": "robot"}


def test_the_page_asks_a_brick_in_a_browser(tmp_path: Path) -> None:
    """The virtual brick is behind a fake of Web Serial, which gives replies in small pieces."""
    (program,) = blocks(ROOT / "docs" / "howto" / "client.md", "html")
    folder = tmp_path / "site"
    folder.mkdir()
    (folder / "brick.html").write_text(f"<!doctype html>{program}")
    for name in ("ev3.mjs", "ev3-decode.mjs"):
        (folder / name).symlink_to(ROOT / "exports" / name)
    with served_site(folder) as address, chromium(tmp_path / "profile") as browser:
        put_fakes(browser)
        browser.get(urljoin(address, "/brick.html"))
        browser.find_element(By.ID, "ask").click()
        said = WebDriverWait(browser, 60, 0.05).until(lambda _: browser.find_element(By.ID, "said").text)
        assert (said, browser.execute_script("return fake.sent")) == ("VALUE 7.5 V", ["08000100000400810160"])


CLIENT = """\
#!/usr/bin/env python3
import sys
import ev3proto

with ev3proto.EV3(target=f"wifi:{sys.argv[2]}") as brick:
    print(brick.battery.voltage > 6)
    brick.send_direct_cmd(bytes.fromhex("9401 0a 82 0000 82 e803".replace(" ", "")))
"""
"""The tests of a user's library: they ask, and send a tone of an impossible pitch."""


REFUSED = CLIENT.replace("82 0000 82 e803", "82 0000 82")
"""The same with a byte missing, so that the brick refuses the command."""


@pytest.mark.parametrize(("client", "status", "said"), [(CLIENT, 0, "FREQUENCY"), (REFUSED, 1, "error[")])
def test_the_lines_for_ci_run(tmp_path: Path, client: str, status: int, said: str) -> None:
    (script,) = blocks(ROOT / "docs" / "howto" / "test-your-library.md", "sh")
    (tmp_path / "your-tests").write_text(client)
    (tmp_path / "your-tests").chmod(0o755)
    path = f"{tmp_path}{os.pathsep}{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = run_program("bash", "-e", "-c", script, cwd=tmp_path, env={"PATH": path})
    assert (done.returncode, done.stdout.splitlines()[0]) == (status, "True"), done.stderr
    assert said in done.stdout, "the report names what check finds"


def test_the_program_for_pyshark_prints_what_is_in_packets(tshark: Tshark) -> None:
    (program,) = blocks(ROOT / "docs" / "howto" / "pyshark.md", "py")
    capture = tshark.place(ROOT / "captures" / "usb-plugged.pcap")
    assert program.count('"robot.pcapng"') == 1
    program = program.replace('"robot.pcapng"', f'"{capture}", tshark_path="{tshark.path}"')
    program = program.replace("parameters()", f'parameters(tshark="{tshark.path}")')
    # A tshark with a root of its own sees the dissector in its work folder only.
    done = run_program(sys.executable, "-c", program, env={"TMPDIR": str(tshark.folder)})
    # Standard error may speak of a tshark that pyshark killed while it was ending by itself.
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0].startswith("1 DirectCommand(DIRECT_COMMAND_REPLY, counter=1000")
    assert lines[1].startswith("3 DirectReply(DIRECT_REPLY, counter=1000")
    assert lines[2].startswith("answers DirectCommand(DIRECT_COMMAND_REPLY, counter=1000")


def test_construct_stops_at_a_fault(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    programs = [block for language in ("python", "py") for block in blocks(ROOT / "docs" / "construct.md", language)]
    stops: list[object] = []
    monkeypatch.setattr(pdb, "post_mortem", stops.append)
    with pytest.raises(DecodeError, match="argument FREQUENCY"):
        exec("\n".join(programs), {})
    assert len(stops) == 1
    assert "offset 10: undefined identification byte 0x85" in capsys.readouterr().out


def test_there_are_commands_and_programs() -> None:
    assert sum(len(blocks(page, "console")) for page in PAGES) > 20
    assert sum(len(blocks(page, "python")) for page in PAGES) > 12

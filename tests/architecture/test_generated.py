"""What is generated from the tables is up to date; its modules are light, readable, and typed."""

from __future__ import annotations

import inspect
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from types import FunctionType, ModuleType

import pytest
from support.cases import each
from support.cli import run_program

from ev3proto import ops, system
from ev3proto.cli.generate import reference_pages
from ev3proto.generate import everything
from ev3proto.ops import compat, xtended

ROOT = Path(__file__).parents[2]
FILES = everything.build(reference_pages())
MODULES = {
    path.removesuffix(".py").removesuffix("/__init__").replace("/", "."): path for path in FILES if path.endswith(".py")
}


def generate(*arguments: str) -> subprocess.CompletedProcess[str]:
    return run_program(sys.executable, "-m", "ev3proto.generate", *arguments)


# The files


@each("path", FILES)
def test_the_files_are_up_to_date(path: str) -> None:
    if (ROOT / path).read_bytes() != FILES[path].encode():
        pytest.fail(f"{path} is out of date: run {everything.COMMAND}", pytrace=False)


def test_one_command_brings_all_of_it_up_to_date(tmp_path: Path) -> None:
    for path in FILES:
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / "exports" / "ev3.ksy").write_text("old\n")
    left_over = tmp_path / "ev3proto" / "ops" / "gone.py"
    left_over.write_text((ROOT / "ev3proto" / "ops" / "sound.py").read_text())
    by_hand = tmp_path / "ev3proto" / "system" / "moving.py"
    by_hand.write_text("by hand\n")
    stale = generate("--check", "--root", str(tmp_path))
    assert stale.returncode == 1
    assert "exports/ev3.ksy is out of date: run python -m ev3proto.generate" in stale.stderr.splitlines()
    written = generate("--root", str(tmp_path))
    assert (written.returncode, set(written.stdout.splitlines())) == (0, {*FILES, "ev3proto/ops/gone.py"})
    assert {path: (tmp_path / path).read_text() for path in FILES} == FILES
    assert (left_over.exists(), by_hand.read_text()) == (False, "by hand\n")
    again = generate("--check", "--root", str(tmp_path))
    assert (again.returncode, again.stdout, again.stderr) == (0, "", "")


def test_the_form_of_the_modules() -> None:
    for tool in (("check",), ("format", "--check")):
        done = run_program(sys.executable, "-m", "ruff", *tool, *MODULES.values())
        assert done.returncode == 0, done.stdout


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "ev3proto").write_text("a file\n")
    done = generate("--root", str(tmp_path))
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith(f"{tmp_path}/ev3proto/enums: cannot be written: ")
    assert len(done.stderr.splitlines()) == 1


# Their contents


@each("name", MODULES)
def test_every_name_is_there_and_has_a_text(name: str) -> None:
    module = import_module(name)
    assert inspect.getdoc(module)
    for exported in getattr(module, "__all__", ()):
        found = getattr(module, exported)
        assert isinstance(found, FunctionType | ModuleType | type), exported
        assert inspect.getdoc(found), exported


@pytest.mark.parametrize("module", [ops, xtended, compat], ids=lambda module: module.__name__)
def test_every_name_of_a_dialect_can_be_loaded(module: ModuleType) -> None:
    assert len(dir(module)) > 180
    assert all(getattr(module, name) is not None for name in dir(module))


def test_what_dialects_share_is_the_same_function() -> None:
    assert compat.sound is xtended.sound is ops.sound
    assert compat.output_start is xtended.output_start is ops.output_start
    assert compat.com_get is not ops.com_get
    assert compat.com_get.get_id is ops.com_get.get_id
    assert compat.file_md5sum is xtended.file_md5sum


def test_a_function_is_found_in_its_file() -> None:
    assert inspect.getsourcefile(ops.sound.tone) == str(ROOT / "ev3proto" / "ops" / "sound.py")
    assert inspect.getsourcefile(system.list_files) == str(ROOT / "ev3proto" / "system" / "__init__.py")


# When they are loaded


def test_the_generated_modules_are_loaded_when_they_are_first_named() -> None:
    code = "import sys, ev3proto; print(*sys.modules); ev3proto.ops, ev3proto.enums, ev3proto.system"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    assert {"ev3proto.ops", "ev3proto.enums", "ev3proto.system"}.isdisjoint(done.stdout.split())


# What a type checker finds

GOOD = """\
import ev3proto
from ev3proto import GV, DirectCommand, Draft, Local, SystemCommand, enums, ops, system
from ev3proto.enums import BUTTON, LED
from ev3proto.ops import compat, xtended

speed = Local()
tone: Draft = ops.sound.tone(volume=1, frequency=440, duration=1000)
message: DirectCommand = ev3proto.command(
    tone,
    ops.ui_read.get_vbatt(),
    ops.ui_read.get_vbatt(value=GV(0)),
    ops.ui_write.led(pattern=LED.RED_FLASH),
    ops.ui_write.led(enums.LEDPATTERN.LED_RED),
    ops.ui_write.led("LED_RED_FLASH"),
    ops.ui_button.pressed(BUTTON.UP),
    ops.output_read(0, 0, speed=speed),
    ops.output_power(0, 1, speed),
    ops.init_bytes(source=[1, 2]),
    ops.init_bytes(None, None, [1, 2]),
    ops.array.init8(speed, 0, values=[1, 2]),
    ops.input_device.ready_si(0, 0, 0, 0, 2),
    ops.math.exp(2.5),
    ops.sound.tone(101, 440, 1000, unchecked=True),
    ops.sound.break_(),
    counter=42,
)
length: int = len(message.build())
listing: SystemCommand = system.list_files("/home/root/lms2012/sys/")
pieces: list[SystemCommand] = list(system.download("a", b"abc"))
system.bootloader.chip_erase()
xtended.ui_draw.rectangle(1, 2, 3, 4, 5)
compat.add8(1, 2)
compat.com_get.list_state("HW_BT")
ops.init_bytes(destination=speed, source=[1])
"""

BAD = """\
from ev3proto import enums, ops, system
ops.sound.toen(1, 440, 1000)
ops.sound.tone(1, 440)
ops.sound.tone(1, frequncy=440, duration=1000)
ops.sound.tone("loud", 440, 1000)
ops.ui_write.led("LED_RED_FLSH")
ops.ui_read.get_vbatt(5)
ops.ui_draw.rectangle(1, 2, 3, 4, 5)
ops.init_bytes()
enums.LED.PURPLE
system.list_files(3)
system.list_file("a")
"""


@pytest.fixture(scope="module")
def complaints(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    """The errors of mypy in each of the two programs."""
    folder = tmp_path_factory.mktemp("programs")
    programs = {"good": GOOD, "bad": BAD}
    for name, source in programs.items():
        (folder / f"{name}.py").write_text(source)
    mypy = [sys.executable, "-m", "mypy", "--strict", "--config-file", "", "--cache-dir", folder / "cache"]
    done = run_program(*mypy, *(folder / f"{name}.py" for name in programs))
    assert done.stdout.splitlines()[-1].startswith("Found "), done.stdout + done.stderr
    return {
        name: [line.split(f"{name}.py:")[1] for line in done.stdout.splitlines() if f"{name}.py:" in line]
        for name in programs
    }


def test_a_type_checker_is_content_with_what_is_right(complaints: dict[str, list[str]], tmp_path: Path) -> None:
    assert complaints["good"] == []
    program = tmp_path / "program.py"
    program.write_text(GOOD)
    done = run_program(sys.executable, program)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_type_checker_finds_what_is_wrong(complaints: dict[str, list[str]]) -> None:
    errors = [line for line in complaints["bad"] if " error: " in line]
    assert [int(line.split(":")[0]) for line in errors] == list(range(2, 13))
    told = "\n".join(errors)
    assert '2: error: Module has no attribute "toen"' in told
    assert '3: error: Missing positional argument "duration" in call to "tone"' in told
    assert 'did you mean "frequency"?' in told
    assert "LED_RED_FLASH" in told

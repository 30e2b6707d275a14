"""The stubs say what the tables say and what programs find when they run; type checkers find by them what is wrong."""

from __future__ import annotations

import ast
import inspect
import subprocess
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from ev3proto.generate.stubs import build

ROOT = Path(__file__).parent.parent
STUBS = build()


@pytest.mark.parametrize("name", STUBS)
def test_the_files_are_up_to_date(name: str) -> None:
    if (ROOT / name).read_bytes() != STUBS[name].encode():
        pytest.fail(f"{name} is out of date: write what ev3proto.generate.stubs.build() gives", pytrace=False)


def test_there_are_no_others() -> None:
    assert sorted(str(path.relative_to(ROOT)) for path in (ROOT / "ev3proto").rglob("*.pyi")) == sorted(STUBS)


def test_the_form_of_the_files() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "ruff", "format", "--check", *STUBS],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, f"{len(STUBS)} files already formatted\n")


# What a program finds when it runs


def functions(body: list[ast.stmt], path: str = "") -> Iterator[tuple[str, ast.FunctionDef]]:
    """Functions, and those of families under the family's name; the last form of those that have several."""
    families = {
        statement.annotation.id: statement.target.id
        for statement in body
        if isinstance(statement, ast.AnnAssign)
        and isinstance(statement.annotation, ast.Name)
        and isinstance(statement.target, ast.Name)
    }
    for statement in body:
        if isinstance(statement, ast.FunctionDef):
            yield f"{path}{statement.name}", statement
        elif isinstance(statement, ast.ClassDef) and statement.name in families:
            yield from functions(statement.body, f"{families[statement.name]}.")


@pytest.mark.parametrize("name", [name for name in STUBS if "enums" not in name])
def test_functions_have_the_parameters_and_the_text_that_the_stub_says(name: str) -> None:
    module: Any = import_module(name.removesuffix(".pyi").removesuffix("/__init__").replace("/", "."))
    found = dict(functions(ast.parse(STUBS[name]).body))
    assert len(found) > 20
    for path, stub in found.items():
        function = module
        for part in path.split("."):
            function = getattr(function, part)
        parameters = inspect.signature(function).parameters
        names = [each.arg for each in (*stub.args.args, *stub.args.kwonlyargs) if each.arg != "self"]
        assert names == list(parameters), path
        assert ast.get_docstring(stub) == inspect.getdoc(function), path
        required = len(stub.args.args) - len(stub.args.defaults) - ("self" in [each.arg for each in stub.args.args])
        defaults = [each.default for each in list(parameters.values())[:required]]
        assert defaults == [inspect.Parameter.empty] * required, path


def test_every_member_of_every_enumeration() -> None:
    module = import_module("ev3proto.enums")
    body = ast.parse(STUBS["ev3proto/enums/__init__.pyi"]).body
    classes = [statement for statement in body if isinstance(statement, ast.ClassDef)]
    assert len(classes) == 27
    for each in classes:
        made = getattr(module, each.name)
        names = [
            target.id
            for statement in each.body
            if isinstance(statement, ast.Assign)
            for target in statement.targets
            if isinstance(target, ast.Name)
        ]
        assert names == list(made.__members__)
    aliases = {
        statement.targets[0].id: statement.value.id
        for statement in body
        if isinstance(statement, ast.Assign)
        and isinstance(statement.targets[0], ast.Name)
        and isinstance(statement.value, ast.Name)
    }
    assert aliases["LED"] == "LEDPATTERN"
    assert all(getattr(module, alias) is getattr(module, name) for alias, name in aliases.items())


# What a type checker makes of them

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


def checked(source: str, folder: Path) -> tuple[int, list[str]]:
    """Exit status and complaints of mypy about a program."""
    program = folder / "program.py"
    program.write_text(source)
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--config-file", "", "--cache-dir", str(folder), str(program)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    ours = [line.split("program.py:")[1] for line in done.stdout.splitlines() if line.startswith(str(program))]
    return done.returncode, [line for line in ours if " error: " in line]


def test_a_type_checker_is_content_with_what_is_right(tmp_path: Path) -> None:
    assert checked(GOOD, tmp_path)[1] == []
    (tmp_path / "run").mkdir()
    program = tmp_path / "run" / "program.py"
    program.write_text(GOOD)
    done = subprocess.run([sys.executable, str(program)], capture_output=True, text=True, check=False, cwd=ROOT)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_type_checker_finds_what_is_wrong(tmp_path: Path) -> None:
    status, complaints = checked(BAD, tmp_path)
    assert status == 1
    assert [int(line.split(":")[0]) for line in complaints] == list(range(2, 13))
    told = "\n".join(complaints)
    assert '2: error: "_Sound" has no attribute "toen"' in told
    assert '3: error: Missing positional argument "duration" in call to "tone"' in told
    assert 'did you mean "frequency"?' in told
    assert "LED_RED_FLASH" in told

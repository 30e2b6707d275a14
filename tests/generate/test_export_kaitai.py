"""The Kaitai Struct description: its compiler accepts it, and the generated parser agrees with the codec.

The compiler is the npm package kaitai-struct-compiler, run by node: the one in the folder that the variable
EV3PROTO_KSC names, the one that bin/setup installed, or the one that node itself finds.
"""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml
from support.cli import run_ev3proto_text
from support.effort import effort
from support.frames import drawn

from ev3proto import DaisyCommand, DaisyReply, DirectCommand, DirectReply, SystemCommand, SystemReply, parse
from ev3proto.generate.kaitai.naming import RESERVED
from ev3proto.tables import operations
from ev3proto.tables.declaration import DIALECTS
from ev3proto.testing import frames

SETTING = "EV3PROTO_KSC"
CAPTURES = Path(__file__).parents[2] / "captures"
TONE = bytes.fromhex("0e002a0080000094010182b80182e803")

_COMPILE = """
const fs = require("fs");
const [module_, source, target, ...languages] = process.argv.slice(1);
const found = require(module_);
const compiler = found.compile ? found : new found();
(async () => {
    for (const language of languages) {
        const files = await compiler.compile(language, JSON.parse(fs.readFileSync(source)), null, false);
        fs.mkdirSync(target + "/" + language);
        for (const name in files)
            fs.writeFileSync(target + "/" + language + "/" + name.replaceAll("/", ""), files[name]);
    }
})().catch((error) => { console.error(String(error)); process.exit(1); });
"""


@cache
def read_yaml(dialect: str) -> Any:
    """The description of a dialect as a reader of YAML has it."""
    # With libyaml it takes a tenth of the time.
    return yaml.load(
        run_ev3proto_text("export", "kaitai", "--dialect", dialect).stdout,
        getattr(yaml, "CSafeLoader", yaml.SafeLoader),
    )


def compile_for(languages: Iterable[str], dialect: str, folder: Path) -> None:
    """Compiles the description of a dialect into a folder for each language."""
    source = folder / "ev3.json"
    # node has no reader of YAML.
    source.write_text(json.dumps(read_yaml(dialect)))
    module = os.environ.get(SETTING, "kaitai-struct-compiler")
    words = ["node", "-e", _COMPILE, module, str(source), str(folder), *languages]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120, check=False)
    assert "Cannot find module" not in done.stderr, f"run bin/setup test, or name the compiler's folder in {SETTING}"
    assert (done.returncode, done.stderr) == (0, "")


def parser_of(dialect: str, folder: Path) -> Any:
    """The class that the compiler made for Python."""
    compile_for(["python"], dialect, folder)
    specification = importlib.util.spec_from_file_location(f"ev3_{dialect}", folder / "python" / "ev3.py")
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module.Ev3


@pytest.fixture(scope="module")
def parser(tmp_path_factory: pytest.TempPathFactory) -> Any:
    return parser_of("official", tmp_path_factory.mktemp("kaitai"))


def test_the_frame_of_the_lesson(parser: Any) -> None:
    (frame,) = parser.from_bytes(TONE).frames
    assert (frame.length, frame.message.counter, frame.message.kind.name) == (14, 42, "direct_command_no_reply")
    (sound,) = frame.message.body.operations
    assert (sound.opcode.name, sound.arguments.cmd_name.name) == ("sound", "tone")
    tone = sound.arguments.parameters
    assert (tone.volume.value, tone.frequency.value, tone.duration.value) == (1, 440, 1000)
    assert len(parser.from_bytes(TONE * 3).frames) == 3


def values(operation: Any) -> list[Any]:
    """The values of an operation's arguments, one after the other."""
    found = []
    body = getattr(operation, "arguments", None)
    body = getattr(body, "parameters", None) if type(body).__name__.startswith("Family") else body
    for name, told in vars(body).items() if body is not None and not isinstance(body, bytes) else ():
        if not name.startswith("_"):
            found += [value(one) for one in (told if isinstance(told, list) else [told]) if hasattr(one, "is_long")]
    return found


def value(argument: Any) -> Any:
    if hasattr(argument, "text"):
        return argument.text
    return argument.float_value if hasattr(argument, "float_value") else argument.value


def same(told: list[Any], expected: list[Any]) -> bool:
    """Whether values are the same; "not a number" equals itself here."""
    return [repr(one) for one in told] == [repr(one) for one in expected]


def check(parser: Any, frame: bytes, dialect: str) -> None:
    expected = parse(frame, dialect=dialect)
    message = parser.from_bytes(frame).frames[0].message
    assert expected.type is not None
    assert (message.kind.value, message.counter) == (expected.type.value, expected.counter)
    body = message.body
    if isinstance(expected, DirectCommand):
        assert (body.global_size, body.local_size) == (expected.global_size, expected.local_size)
    if isinstance(expected, DirectCommand | DaisyCommand) and expected.operations:
        for told, operation in zip(body.operations, expected.operations, strict=True):
            assert told.opcode.value == operation.opcode
            if operation.cmd is not None:
                assert told.arguments.cmd.value == operation.cmd.value
            assert same(values(told), [argument.value for argument in operation.arguments])
    elif isinstance(expected, DirectReply):
        assert body.memory == expected.memory
    elif isinstance(expected, SystemCommand | SystemReply):
        fields = getattr(body, "fields", None)
        for name, one in expected.fields.items():
            told = getattr(fields, name, type(one)())
            assert getattr(told, "text", told) == one
    elif isinstance(expected, DaisyReply):
        assert (body.layer_from, body.layer_to) == (expected.layer_from, expected.layer_to)
        assert hasattr(body, "report") == (expected.report is not None)
        if expected.report is not None:
            assert (body.report.data, body.report.busy) == (expected.report.data, expected.report.busy)


def test_any_frame(parser: Any) -> None:
    for frame in drawn(frames(), effort(200, 2000)):
        check(parser, frame, "official")


@pytest.mark.parametrize("dialect", ["xtended", "compat"])
def test_any_frame_of_other_dialects(dialect: str, tmp_path: Path) -> None:
    other = parser_of(dialect, tmp_path)
    for frame in drawn(frames(dialect), effort(60, 500)):
        check(other, frame, dialect)


@pytest.mark.parametrize(
    "frame",
    [
        "0e002a0080000094010182b80182e8",  # cut off
        "02002a00",  # impossible length
        "03002a0077",  # unknown message type
        "06002a00800000ff"[:-2] + "fe",  # unknown opcode
        "09002a00800000940185b8",  # unknown identification byte
        "0a002a0080000094028084616200"[:-2] + "61",  # a string without its zero
    ],
)
def test_faulty_frames_are_refused(parser: Any, frame: str) -> None:
    with pytest.raises(Exception, match=r"validation|bytes|end of stream"):
        parser.from_bytes(bytes.fromhex(frame))


# The captures of this repository


@cache
def captured() -> dict[str, list[bytes]]:
    """The frames in each capture and log that the codec reads, by the name of the file."""
    found: dict[str, list[bytes]] = {}
    for path in sorted(CAPTURES.iterdir()):
        if path.suffix in (".pcap", ".pcapng", ".log"):
            lines = run_ev3proto_text("decode", "--json", str(path)).stdout.splitlines()
            found[path.name] = [
                bytes.fromhex(told["hex"])
                for told in map(json.loads, lines)
                if told.get("kind", "").endswith(("command", "reply")) and "fault" not in told
            ]
    return found


def test_every_frame_of_the_captures(parser: Any) -> None:
    assert len(captured()) >= 12
    for frames_of_file in captured().values():
        for frame in frames_of_file:
            check(parser, frame, "official")
    assert max(len(frame) for frame in captured()["wifi-long.pcapng"]) > 2500


def test_zero_lengths_between_frames(parser: Any) -> None:
    for name, frames_of_file in captured().items():
        stream = b"".join(bytes(2 * (number % 3)) + frame for number, frame in enumerate(frames_of_file))
        counters = [frame.message.counter for frame in parser.from_bytes(stream + bytes(4)).frames[:-1]]
        assert counters == [int.from_bytes(frame[2:4], "little") for frame in frames_of_file], name


LANGUAGES = ["java", "javascript", "cpp_stl", "csharp", "go", "ruby"]


def test_other_languages(tmp_path: Path) -> None:
    compile_for(LANGUAGES, "official", tmp_path)
    for language in LANGUAGES:
        sizes = [path.stat().st_size for path in (tmp_path / language).iterdir()]
        assert max(sizes) > 100_000, language


@pytest.mark.parametrize("dialect", DIALECTS)
def test_every_operation_is_described(dialect: str) -> None:
    types: Any = read_yaml(dialect)["types"]
    for name, declaration in operations(dialect).items():
        told = types.get(f"op_{name.replace('.', '_').lower()}")
        assert (told is not None) == bool(declaration.parameters)
        if told is not None:
            names = [field["id"] for field in told["seq"]]
            assert len(names) == len(set(names)) >= len(declaration.parameters)


def test_names_are_unique_and_not_reserved() -> None:
    told: Any = read_yaml("official")
    types, enums = set(told["types"]), set(told["enums"])
    assert not types & enums
    for kind in told["types"].values():
        names = [field["id"] for field in kind["seq"]] + list(kind.get("instances", {}))
        assert len(names) == len(set(names))
        assert not RESERVED & set(names)


def test_the_form_of_the_file() -> None:
    text = run_ev3proto_text("export", "kaitai").stdout
    assert text.endswith("\n")
    assert [line for line in text.split("\n") if line != line.rstrip() or "\t" in line] == []
    assert '      - {id: volume, type: argument(false), doc: "volume (0 to 100 %; 0: silent)"}\n' in text
    assert sys.getsizeof(text) < 300_000

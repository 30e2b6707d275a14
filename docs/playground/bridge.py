"""The Python side of the playground: it runs the command line on the input, and a virtual brick.

Every function takes and returns types that JavaScript also has. It runs in Pyodide and in CPython.
"""

from __future__ import annotations

import io
import json
import re
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from ev3proto.brick import Brick
from ev3proto.brick.servers.page.state import Changes, answer
from ev3proto.brick.servers.page.watcher import Watcher
from ev3proto.cli.commands import cli
from ev3proto.schema.header import frame_size
from ev3proto.semantics.domain import facts
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import Declaration, declarations
from ev3proto.text.assembly.recognising import OBJECT

MOST_SHOWN = 200_000
"""Maximum characters shown of an answer."""

MOST_DIALOGUES = 1000

MOST_SENT = 100
"""Maximum number of frames sent to the brick at once."""

MOST_COMPLETIONS = 40

MOST_STEP = 0.25
"""Maximum seconds that the brick's clock advances per tick: a page that was asleep does not catch up."""

STRETCH = 0.02
"""Seconds that a command or program may run before the page gets its turn."""

_FOLDERS = [TemporaryDirectory() for _ in range(2)]
_PLACE, _ROOT = (Path(folder.name) for folder in _FOLDERS)
_TEXT, _SOURCE, _IMAGE, _FRAMES, _CHART = (
    _PLACE / name for name in ("input", "input.lms", "input.rbf", "frames", "chart.json")
)
_OFFSET = re.compile(r" +(\d+)  +\S")
"""The start of a line of the tree that is about bytes: the offset of the first."""

_FINDING = re.compile(r"^(?:error|warning|hint)\[(\w+)\]")
_FILE_NAME = re.compile(r"\w[\w .()-]{0,80}", re.ASCII)
_CALL = re.compile(r"([A-Za-z_]\w*)\s*\(([^()]*)$")
_WORD = re.compile(r"[A-Za-z_][\w.]*$")


class Said(NamedTuple):
    """The output of a command, and its exit status."""

    out: str
    errors: str
    status: int


def command(*arguments: str) -> Said:
    """Runs a subcommand of ev3proto."""
    with io.TextIOWrapper(io.BytesIO(), "utf-8") as out, io.TextIOWrapper(io.BytesIO(), "utf-8") as errors:
        status = 0
        with redirect_stdout(out), redirect_stderr(errors):
            try:
                cli(arguments, prog_name="ev3proto")
            except SystemExit as end:
                status = int(end.code or 0)
        texts = []
        for stream in (out, errors):
            stream.flush()
            stream.seek(0)
            texts.append(stream.read().replace(f"{_PLACE}/", ""))
    return Said(texts[0], texts[1], status)


# The input


class Input(NamedTuple):
    """The current input.

    names   the input, or the files with it, as arguments of subcommands
    image   the image of a program
    source  the source of a program, as arguments of subcommands
    errors  the errors of the assembler
    """

    names: tuple[str, ...] = ()
    image: bytes | None = None
    source: tuple[str, ...] = ()
    errors: str = ""


_now = Input()


def look(text: str) -> str:
    """Reads what was typed or pasted.

    Returns:
        An object as JSON: `lines` of the tree, each with its text, the number of its frame (-1 for none), the offset
        and number of the bytes that it is about; `frames`, in hex; `findings`, each with its text and code; `error`;
        `made`, the frames in several notations; `dialogues`, each with time, text, latency.
    """
    global _now
    _now = _typed(text)
    return json.dumps(_looked())


def open_file(name: str, data: Any) -> str:
    """Reads a file, as `look` reads a text.

    Args:
        name: The name of the file, which is shown.
        data: The contents, as bytes or as a JavaScript array.
    """
    global _now
    contents = data if isinstance(data, bytes) else data.to_bytes()
    path = _PLACE / (name if _FILE_NAME.fullmatch(name) else f"file{Path(name).suffix if name.isprintable() else ''}")
    path.write_bytes(contents)
    ending = path.suffix.lower()
    _now = _source(path) if ending == ".lms" else Input((str(path),), contents if ending == ".rbf" else None)
    return json.dumps(_looked())


def _typed(text: str) -> Input:
    if not text.strip():
        return Input()
    if OBJECT.search(text):
        _SOURCE.write_text(text, encoding="utf-8")
        return _source(_SOURCE)
    if "\n" in text.strip():
        _TEXT.write_text(text, encoding="utf-8")
        names: tuple[str, ...] = (str(_TEXT),)
    else:
        names = ("--", text.strip())
    said = command("decode", *names)
    if said.out or "assembly" not in said.errors:
        return Input(names)
    made = command("encode", *names)
    return Input(_as_names(made.out), errors=made.errors)


def _as_names(frames: str) -> tuple[str, ...]:
    """Frames as arguments: a single frame itself, so that messages about it do not name a file."""
    if frames.count("\n") == 1:
        return ("--", frames.strip())
    if frames:
        _FRAMES.write_text(frames, encoding="utf-8")
        return (str(_FRAMES),)
    return ()


def _source(path: Path) -> Input:
    _IMAGE.unlink(missing_ok=True)
    errors = command("encode", str(path), "-o", str(_IMAGE)).errors
    if not _IMAGE.exists():
        return Input(errors=errors)
    return Input((str(_IMAGE),), _IMAGE.read_bytes(), (str(path),))


def _looked() -> dict[str, Any]:
    names = _now.names
    if not names:
        return {"lines": [], "frames": [], "findings": [], "error": _now.errors, "made": {}, "dialogues": []}
    decoded = command("decode", *names)
    checked = command("check", *(_now.source or names))
    said: dict[str, Any] = {
        "error": _now.errors or decoded.errors,
        "findings": _findings(_shortened(checked.out + ("" if checked.errors == decoded.errors else checked.errors))),
    }
    if _now.image is not None:
        lines = [[line, -1, 0, 0] for line in _shortened(decoded.out).splitlines()]
        return said | {"lines": lines, "frames": [], "made": {}, "dialogues": []}
    records = _records(names)
    made = {form: _shortened(command("encode", "--to", form, *names).out) for form in ("hex", "c", "python")}
    return said | {
        "lines": _lines(_shortened(decoded.out), records),
        "frames": [record.get("hex", "") for record in records],
        "made": made,
        "dialogues": _dialogues(names) if len(records) > 1 else [],
    }


def _records(names: tuple[str, ...]) -> list[dict[str, Any]]:
    return [json.loads(line) for line in command("decode", "--json", *names).out.splitlines()]


def _shortened(text: str) -> str:
    if len(text) <= MOST_SHOWN:
        return text
    kept = text[: text.rindex("\n", 0, MOST_SHOWN) + 1]
    return f"{kept}... and {text.count(chr(10), len(kept))} more lines; ev3proto on the command line shows all\n"


def _lines(tree: str, records: list[dict[str, Any]]) -> list[list[Any]]:
    """The lines of the tree, each with its bytes: messages are not indented, bytes begin with an offset."""
    lines: list[list[Any]] = []
    number = -1
    lengths: dict[int, int] = {}
    for text in tree.splitlines():
        offset, length = 0, 0
        if text and not text.startswith(" "):
            number = min(number + 1, len(records) - 1)
            lengths = dict(_spans(records[number])) if records else {}
            length = len(records[number].get("hex", "")) // 2 if records else 0
        elif found := _OFFSET.match(text):
            offset = int(found[1])
            length = lengths.get(offset, 1)
        lines.append([text, number if length else -1, offset, length])
    return lines


def _spans(record: dict[str, Any]) -> list[tuple[int, int]]:
    """Offset and length of each part of a message."""
    parts = [*record.get("operations", ()), *(record.get("values") or ())]
    return [(part["offset"], part["length"]) for each in parts for part in (each, *each.get("args", ()))]


def _findings(text: str) -> list[dict[str, str]]:
    """The output of `check`, split before each finding."""
    found = [{"text": "", "code": ""}]
    for line in text.splitlines(keepends=True):
        if begin := _FINDING.match(line):
            found.append({"text": "", "code": begin[1]})
        found[-1]["text"] += line
    return [each for each in found if each["text"]]


def _dialogues(names: tuple[str, ...]) -> list[dict[str, Any]]:
    # A line without the number of a packet names a connection.
    printed = command("decode", "--dialogues", *names).out.splitlines()
    texts = [text for text in printed if re.match(r"[ \d.]*#\d", text)]
    records = command("decode", "--dialogues", "--json", *names).out.splitlines()
    return [
        {"text": text.strip(), "latency": json.loads(record).get("latency")}
        for text, record in list(zip(texts, records, strict=True))[:MOST_DIALOGUES]
    ]


def timeline() -> str:
    """Returns the timeline of the input as a Vega-Lite specification with its data: JSON; null if it is empty."""
    command("timeline", *_now.names, "-o", str(_CHART))
    if not _CHART.exists():
        return "null"
    chart = _CHART.read_text(encoding="utf-8")
    _CHART.unlink()
    return chart


def explain(code: str) -> str:
    """Returns what a code of `check` means, as a JSON string."""
    return json.dumps(command("check", "--explain", code).out)


def fix() -> str:
    """Returns the input with every certain fix applied, in the lesson's notation, as a JSON string."""
    fixed = [json.loads(line) for line in command("check", "--fix", "--json", *_now.names).out.splitlines()]
    frames = [each["hex"] for each in fixed if each.get("hex")]
    _FRAMES.write_text("\n".join(frames), encoding="utf-8")
    return json.dumps(command("encode", str(_FRAMES)).out.strip())


def as_assembly(frame: str) -> str:
    """Returns a frame as text that can be edited and encoded again, as a JSON string."""
    return json.dumps(command("decode", "--format", "asm", "--", frame).out)


# Completion


def complete(before: str) -> str:
    """Returns the completions at the cursor.

    Args:
        before: The line up to the cursor.

    Returns:
        JSON: `word`, the letters that a completion replaces; `words`, each with what to insert and what to show; `hint`
        about the parameter at the cursor.
    """
    found = _WORD.search(before)
    word = found[0] if found else ""
    call = _CALL.search(before)
    hint, options = "", _OPERATIONS if call is None else []
    if call is not None:
        hint, options = _inside(call[1].upper().removeprefix("OP"), call[2].split(","))
    if not word and call is None:
        options = []
    wanted = word.upper()
    words = [option for option in options if option[0].upper().startswith(wanted) and option[0] != word]
    return json.dumps({"word": word, "words": words[:MOST_COMPLETIONS], "hint": hint})


def _signature(declaration: Declaration) -> str:
    names = [parameter.name for parameter in declaration.parameters]
    head = [] if declaration.command is None else [declaration.command.name]
    return f"{declaration.opcode.name}({', '.join([*head, *names])})"


_DECLARATIONS = list(declarations(OPCODES))
_OPERATIONS = [
    (each.name, f"{_signature(each)}  {each.text}") for each in sorted(_DECLARATIONS, key=lambda each: each.name)
]


def _inside(opcode: str, given: list[str]) -> tuple[str, list[tuple[str, str]]]:
    """The hint and the names for the last argument of a call."""
    matching = [each for each in _DECLARATIONS if each.opcode.name == opcode or each.name == opcode]
    if not matching:
        return "", []
    if matching[0].command is not None and matching[0].name != opcode:
        if len(given) == 1:
            return "", [(each.command.name, f"{_signature(each)}  {each.text}") for each in matching if each.command]
        chosen = given.pop(0).strip().upper()
        matching = [each for each in matching if each.command and each.command.name == chosen]
    if not matching or len(given) > len(matching[0].parameters):
        return "", []
    parameter = matching[0].parameters[len(given) - 1]
    said = "; ".join([parameter.text, *facts(parameter)])
    members = parameter.enum.members if parameter.enum else parameter.names
    return f"{parameter.name}: {said}", [(name, f"{name} = {number}") for name, number in members.items()]


# The brick


class _Page:
    """The one client of the brick."""

    number = 1
    name = "playground"


_page = _Page()
_brick = Brick(_ROOT, stretch=STRETCH)
_watcher = Watcher(lambda: _brick.microseconds / 1_000_000)
_changes = Changes(_brick, _watcher.open(), tuple)


def tick(seconds: float) -> str:
    """Advances the brick's clock. Returns what is new on it as JSON; empty if nothing is."""
    for _, reply in _brick.advance_all(min(seconds, MOST_STEP)):
        _watcher.frame(_page, reply, False)
    new = _changes.take()
    return json.dumps(new) if new else ""


def act(action: str) -> str:
    """Runs an action on the brick, given as JSON. Returns the answer for the page, as JSON."""
    return json.dumps(answer(_brick, action))


def send() -> str:
    """Sends the commands in the input, or starts the program. Returns an error message or "", as a JSON string."""
    if _now.image is not None:
        program = _brick.start(_now.image)
        return json.dumps("" if program is not None else "The brick refuses the program; see the findings.")
    records = (
        [json.loads(line) for line in command("decode", "--json", *_now.names).out.splitlines()] if _now.names else []
    )
    frames = [bytes.fromhex(each["hex"]) for each in records if each["kind"].endswith("command") and each.get("hex")]
    if not frames:
        return json.dumps("The input has no command to send.")
    for frame in frames[:MOST_SENT]:
        if len(frame) < frame_size(frame):
            return json.dumps("The frame is cut off: a brick would wait for the rest.")
        _watcher.frame(_page, frame, True)
        for _, reply in _brick.receive_from(_page, frame):
            _watcher.frame(_page, reply, False)
    sent = f"Only the first {MOST_SENT} of {len(frames)} commands were sent."
    return json.dumps(sent if len(frames) > MOST_SENT else "")

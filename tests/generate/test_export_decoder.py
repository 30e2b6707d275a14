"""The decoder in JavaScript says what Python says of any frame: the same objects, the same faults, the same pairs."""

from __future__ import annotations

import gzip
import json
import subprocess
from pathlib import Path
from random import Random
from typing import Any

import pytest
from support.built import built_export
from support.effort import effort
from support.frames import drawn

from ev3proto import Decoder, Dialogue, StreamError, parse
from ev3proto.dialogue import Exchange, values_of
from ev3proto.messages import DirectCommand
from ev3proto.tables.frame import MessageType
from ev3proto.testing import choice, frames, mutated_frames
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import Seen

PROGRAM = """\
import { readFileSync } from "node:fs";
import { Dialogue, Frames, decode } from "MODULE";
const bytes = (hex) => Uint8Array.from(Buffer.from(hex, "hex"));
const hex = (frame) => Buffer.from(frame).toString("hex");
const TOOLS = {
  decode: ([frame, request, dialect]) => (
    decode(bytes(frame), { request: request === null ? null : bytes(request), dialect })
  ),
  stream: (chunks) => {
    const stream = new Frames(), found = [];
    try {
      for (const chunk of chunks) for (const frame of stream.feed(bytes(chunk))) found.push(hex(frame));
    } catch (error) {
      return [...found, error.name];
    }
    return [...found, hex(stream.pending)];
  },
  dialogue: (given) => {
    const dialogue = new Dialogue();
    return [given.map((frame) => dialogue.feed(bytes(frame))), dialogue.unanswered.map(({ hex }) => hex)];
  },
};
for (const line of readFileSync(0, "utf8").split("\\n")) {
  if (line) console.log(JSON.stringify(TOOLS[process.argv[1]](JSON.parse(line))));
}
"""


def answers(tool: str, given: list[Any]) -> list[Any]:
    """What the module says of each case, in Node."""
    program = PROGRAM.replace("MODULE", built_export("ev3-decode.mjs").as_uri())
    words = ["node", "--input-type=module", "--eval", program, tool]
    lines = "\n".join(map(json.dumps, given))
    done = subprocess.run(words, input=lines, capture_output=True, text=True, timeout=600, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return [json.loads(line, parse_int=number) for line in done.stdout.split("\n") if line]


def number(digits: str) -> float:
    """A whole number; JavaScript writes large floats in the same way."""
    return int(digits) if len(digits) < 17 else float(digits)


def in_python(frame: str, request: str | None = None, dialect: str = "official") -> dict[str, Any]:
    message = parse(bytes.fromhex(frame), strict=False, dialect=dialect)
    asked = None if request is None else parse(bytes.fromhex(request), strict=False, dialect=dialect)
    return record(Exchange(message, asked, values_of(message, asked)), Seen())


def assert_equal(cases: list[tuple[str, str | None, str]]) -> None:
    told = answers("decode", [list(case) for case in cases])
    wrong = [(found, in_python(*case)) for case, found in zip(cases, told, strict=True) if found != in_python(*case)]
    for found, expected in wrong[:1]:
        assert found == expected


def test_drawn_frames_of_all_kinds() -> None:
    random, cases = Random(80), list[tuple[str, str | None, str]]()
    for dialect in ("official", "xtended", "compat"):
        cases += [(frame.hex(), None, dialect) for frame in drawn(frames(dialect), effort(200, 15000))]
        cases += [(frame.hex(), None, dialect) for frame in drawn(mutated_frames(dialect), effort(200, 15000))]
    for _ in range(effort(2000, 30000)):
        body = random.randbytes(random.choice([*range(12), 40, 1100]))
        head = random.randbytes(2) + bytes((random.choice([*MessageType, random.randrange(256)]),))
        size = len(head + body) + random.choice([0, 0, 0, 1, -1])
        cases.append(((max(size, 0).to_bytes(2, "little") + head + body).hex(), None, "official"))
    cases += [(random.randbytes(size).hex(), None, "official") for size in range(8)]
    assert_equal(cases)


def test_the_test_vectors() -> None:
    vectors = [json.loads(line) for line in built_export("ev3-vectors.jsonl").read_text().splitlines()]
    told = answers("decode", [[each["frame"], each.get("request"), "official"] for each in vectors])
    assert [found for found, each in zip(told, vectors, strict=True) if found != each["message"]][:1] == []
    assert len({each["message"]["kind"] for each in vectors}) == 7, "every kind, and unknown"
    assert {"fault" in each["message"] for each in vectors} == {"request" in each for each in vectors} == {True, False}


READING = ("INPUT_DEVICE", "INPUT_READ", "INPUT_READSI", "INPUT_READEXT")


def test_drawn_replies_by_their_commands() -> None:
    random, cases = Random(81), list[tuple[str, str | None, str]]()
    commands = [("official", each) for each in drawn(frames(chosen=choice(names=READING)), effort(150, 5000))]
    for dialect in ("official", "xtended", "compat"):
        direct = frames(dialect, chosen=choice(types=("direct-command",)))
        commands += [(dialect, each) for each in drawn(direct, effort(100, 7000))]
    for dialect, command in commands:
        asked = parse(command, expect=DirectCommand, dialect=dialect)
        memory = random.randbytes(
            min(random.choice([asked.global_size, asked.global_size, 64, random.randrange(1019)]), 1019)
        )
        if random.random() < 0.3:
            memory = bytes(byte * random.randrange(2) for byte in memory)
        body = asked.counter.to_bytes(2, "little") + bytes((random.choice([2, 2, 2, 4]),)) + memory
        cases.append(((len(body).to_bytes(2, "little") + body).hex(), command.hex(), dialect))
    # A request of another kind tells nothing.
    cases += [(cases[0][0], frame.hex(), "official") for frame in drawn(frames(), 50)]
    assert_equal(cases)


@pytest.mark.parametrize(
    ("mode", "quantity", "unit"), [(0, "angle", "degrees"), (1, "rate", "degrees/s"), (9, None, None)]
)
def test_a_reading_has_name_and_unit(mode: int, quantity: str | None, unit: str | None) -> None:
    """INPUT_DEVICE.READY_SI of the gyro sensor, type 32."""
    command = f"0e002a00000400991d00008120{mode:02x}0160"
    reply = "07002a00020000b442"
    (answer,) = answers("decode", [[reply, command, "official"]])
    (value,) = answer["values"]
    assert (value["value"], value.get("quantity"), value.get("unit")) == (90, quantity, unit)
    assert answer == in_python(reply, command)


REPLY = "0300010002"
STREAMS = [
    "0e002a0080000094010182b80182e803" + REPLY,
    "0000" + REPLY + "000000000300020002" + "0500",  # polls between, an unfinished frame at the end
    REPLY + "0200",  # a length that no frame has
    REPLY + "ff0700010092" + "00" * 2043 + REPLY,  # not a system command
    REPLY + "ff070001000192" + "00" * 2042 + REPLY,  # a long download
    "ff0701",
    "48656c6c6f2c2045",
]


def in_python_stream(chunks: list[str]) -> list[str]:
    decoder, found = Decoder(strict=False), list[str]()
    try:
        for chunk in chunks:
            for message in decoder.feed(bytes.fromhex(chunk)):
                found.append(message.build().hex())
    except StreamError:
        return [*found, "RangeError"]
    return [*found, decoder.pending.hex()]


def test_streams_in_any_chunks() -> None:
    random, cases = Random(82), list[list[str]]()
    for stream in STREAMS:
        cuts = sorted(random.sample(range(0, len(stream), 2), 3))
        cases += [[stream], [stream[at : at + 2] for at in range(0, len(stream), 2)]]
        cases.append([stream[start:end] for start, end in zip([0, *cuts], [*cuts, None], strict=True)])
    assert answers("stream", [[each] for each in STREAMS[:3]]) == [
        [STREAMS[0][:32], REPLY, ""],
        [REPLY, "0300020002", "0500"],
        [REPLY, "RangeError"],
    ]
    assert answers("stream", cases) == [in_python_stream(case) for case in cases]


def test_a_reply_answers_the_oldest_command_that_it_fits() -> None:
    """Counters that repeat, replies that come in no order, lost and repeated ones: as Python pairs them."""
    random, cases = Random(83), list[list[str]]()
    commands = drawn(frames(chosen=choice(types=("direct-command", "system-command"))), 60)
    for _ in range(effort(100, 2000)):
        given = list[bytes]()
        for _ in range(random.randrange(2, 12)):
            counter = random.randrange(3).to_bytes(2, "little")
            command = random.choice(commands)
            if random.random() < 0.5 or not given:
                given.append(command[:2] + counter + command[4:])
                continue
            body = counter + random.choice(
                [b"\2" + bytes(random.choice([0, 4, 8])), b"\4", b"\3" + command[5:6] + b"\0", b"\x08\0\1"]
            )
            given.append(len(body).to_bytes(2, "little") + body)
        cases.append([frame.hex() for frame in given])
    for case, (told, unanswered) in zip(cases, answers("dialogue", cases), strict=True):
        dialogue = Dialogue()
        expected = []
        for frame in case:
            exchange = dialogue.follow(parse(bytes.fromhex(frame), strict=False))
            expected.append(record(exchange, Seen()))
        assert told == expected
        assert unanswered == [message.build().hex() for message in dialogue.unanswered]


def test_typescript_knows_the_objects(tmp_path: Path) -> None:
    types = built_export("ev3-decode.d.ts").read_text()
    assert "export type Message = DirectCommand | DirectReply | SystemCommand" in types
    assert '  kind: "constant" | "string" | "local" | "global" | "label";\n' in types


def test_the_modules_are_small() -> None:
    """In bytes, as servers compress them: a page waits for them before it shows a frame."""
    decoder, texts = (
        len(gzip.compress(built_export(f"ev3-{name}.mjs").read_bytes(), 9)) for name in ("decode", "texts")
    )
    assert (decoder <= 22_000, decoder + texts <= 40_000) == (True, True)


def test_the_texts() -> None:
    program = f"import {{ texts }} from '{built_export('ev3-texts.mjs').as_uri()}'; console.log(JSON.stringify(texts))"
    words = ["node", "--input-type=module", "--eval", program]
    texts = json.loads(subprocess.run(words, capture_output=True, text=True, timeout=60, check=True).stdout)
    assert texts["system_commands"]["153"] == "Lists a folder and fetches the first piece of the listing"
    assert texts["operations"]["SOUND.TONE"]["parameters"][0].startswith("volume")

"""What passes the validator and fails when it runs: `check` says so, unless the state of the brick decides."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import pytest
from support.effort import effort

import ev3proto
from ev3proto.brick import Brick
from ev3proto.messages import DirectCommand, Operation
from ev3proto.sampling import samples
from ev3proto.schema.header import with_length
from ev3proto.tables.encoding import GLOBAL
from ev3proto.tables.frame import MessageType
from ev3proto.testing import accepted_frames

SECOND = 1.0


def found(operations: str, memory: str = "00 00") -> list[tuple[str, str]]:
    frame = with_length(bytes.fromhex(f"2A 00 00 {memory} {operations}"))
    return [(each.code, each.message) for each in ev3proto.check(frame).findings]


OPEN_A_TO_LV0 = "C0 01 84 61 00 40 44"
CREATE_4_TO_LV0 = "C1 01 04 40"


@pytest.mark.parametrize(
    ("operations", "memory", "expected"),
    [
        ("D1 01 00 00 00", "00 00", "W202"),
        ("C0 12 84 61 00 01 01 60", "04 00", "W202"),
        ("C0 07 01", "00 00", "W502"),
        ("C0 05 01 00 04 60", "04 00", "W502"),
        ("C3 01 00 60", "04 00", "W502"),
        (f"{OPEN_A_TO_LV0} C0 07 02", "00 20", "W502"),
        (f"{OPEN_A_TO_LV0} C3 01 00 60", "04 20", "W502"),
        ("C1 02 83 C1 C6 2D 00 40", "00 08", "W303"),  # 3,000,001 elements of two bytes
        ("D4 08 84 6D 79 20 45 00", "00 00", "W503"),
        ("D3 0C 01 0D 60", "10 00", "W303"),  # the address of USB
        ("D4 01 01 01", "00 00", "W303"),  # USB is always on
        ("D3 01 40 60", "04 04", "W406"),
        ("94 02 01 40", "00 20", "W406"),
    ],
)
def test_a_finding(operations: str, memory: str, expected: str) -> None:
    assert expected in [code for code, _ in found(operations, memory)]


@pytest.mark.parametrize(
    ("operations", "memory"),
    [
        (f"{OPEN_A_TO_LV0} C0 07 40", "00 20"),
        (f"{OPEN_A_TO_LV0} C0 07 01", "00 20"),
        (f"{CREATE_4_TO_LV0} C3 40 00 60 C1 00 40", "04 08"),
        ("C1 0F 01 01 60", "04 00"),  # an array of another program
        ("D4 08 84 6D 79 5F 45 00", "00 00"),
        ("D3 0C 02 0D 60", "10 00"),
        ("30 02 40 D3 01 40 60", "04 04"),
        ("2F 40 02 01 02 D3 01 41 60", "04 08"),  # written as a part of an array
        ("D3 01 64 60", "08 00"),  # global memory may be left from another command
        ("A6 00 40", "00 04"),  # no port is legal
    ],
)
def test_no_finding(operations: str, memory: str) -> None:
    assert [code for code, _ in found(operations, memory) if code not in ("H401", "W404")] == []


def test_what_the_findings_say() -> None:
    assert found("C0 07 01") == [
        ("W502", "no operation before FILE.CLOSE opens a file: handles end with their command")
    ]
    assert found("D4 08 84 6D 79 20 45 00") == [("W503", "NAME contains ' ', which the firmware refuses")]
    assert found("D3 01 40 60", "01 04") == [("W406", "no operation writes LV(0), so HARDWARE is always 0")]


EXPLAINED = {
    "TST.": "the tests of the factory are closed",
    "FILE.GET_CACHE_FILE": "no program has been run",
    "FILE.OPEN_LOG": "its folder does not exist",
    "FILE.OPEN_WRITE": "its folder does not exist",
    "FILE.OPEN_APPEND": "its folder does not exist",
    "ARRAY.READ_CONTENT": "no such array in the program of that slot",
    "ARRAY.WRITE_CONTENT": "no such array in the program of that slot",
    "MAILBOX_": "the mailbox is open or closed",
    "UI_DRAW.": "an address or a place outside of this brick's memory, which a real one does not notice",
    "STRINGS.": "a text beyond the memory of the command, which a real brick does not notice",
    "ARRAY": "an array that is too small, or full memory",
    "INPUT_WRITE": "nothing is plugged in",
}
"""Why a brick refuses a command without findings: its state, by the start of the operation's name."""


def commands_without_findings(seed: int) -> Iterator[bytes]:
    for frame in samples(accepted_frames(), seed):
        if frame[4] == MessageType.DIRECT_COMMAND_REPLY and not ev3proto.check(frame).findings:
            yield frame


def is_refused(frame: bytes, root: Path) -> bool:
    """Whether a brick that was just switched on answers with an error, at once or within a second."""
    brick = Brick(root=root)
    replies = brick.receive(frame) or brick.advance(SECOND)
    return bool(replies) and replies[0][4] == MessageType.DIRECT_REPLY_ERROR


def refused_operation(frame: bytes, root: Path) -> Operation | None:
    command = ev3proto.parse(frame, expect=DirectCommand)
    for operation in command.operations:
        end = operation.offset + operation.length
        if is_refused(with_length(frame[2:end]), root):
            return operation
    return None


def explanation(command: DirectCommand, operation: Operation) -> str | None:
    """Why the brick refuses an operation: its state, or the global memory, which holds what earlier commands left."""
    by_name = (why for name, why in EXPLAINED.items() if operation.full_name.startswith(name))
    if (why := next(by_name, None)) is not None:
        return why
    before = [each for each in command.operations if each.offset < operation.offset]
    written = {
        argument.value
        for each in before
        for argument in each.arguments
        if argument.kind == GLOBAL and argument.parameter.is_output
    }
    for argument in operation.arguments:
        if argument.kind == GLOBAL and argument.value not in written and not argument.parameter.is_output:
            return "the global memory is zero"
    return None


def test_what_has_no_finding_is_refused_only_for_the_state_of_the_brick(tmp_path: Path) -> None:
    unexplained = []
    for frame in islice(commands_without_findings(effort(3, 5)), effort(60, 3000)):
        if is_refused(frame, tmp_path):
            operation = refused_operation(frame, tmp_path)
            command = ev3proto.parse(frame, expect=DirectCommand)
            if operation is None or explanation(command, operation) is None:
                unexplained.append(f"{frame.hex()}: {operation}")
    assert unexplained == []

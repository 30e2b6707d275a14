"""Random attacks on `proxy --read-only` and `--hide`: twin bricks stay alike, memory full of a secret stays hidden."""

from __future__ import annotations

import hashlib
import os
import re
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any

import pytest
from support.attackers import PATHS, READING, Attacker, Guarded, names_of
from support.brick_state import state_of
from support.cases import each
from support.effort import THOROUGH, effort

import ev3proto
from ev3proto.brick import Brick
from ev3proto.link.masking import masked
from ev3proto.link.whitelist import Blame, blamed
from ev3proto.messages import Message

ROUND = 250
"""Frames after which new bricks are compared."""

SEED = int.from_bytes(os.urandom(4), "little") if THOROUGH else 1

LEFT_OUT = re.compile(
    # What a direct command leaves of itself, which the next one writes over,
    r"global_memory|local_memory|machine\.slots\.2\.|machine\._(left|scratch)"
    # and the mode of a sensor.
    r"|inputs\._changed|inputs\._devices\.\d+\.(mode|busy_until)$"
)


def switched_on(root: Path) -> Brick:
    """A brick with files and devices, whose motor A turns."""
    for folder in ("prjs/p", "sys/lib", "apps", "tools"):
        (root / folder).mkdir(parents=True)
    (root / "prjs/p/a.rtf").write_bytes(bytes(range(256)) * 12)
    (root / "prjs/b.rbf").write_bytes(b"LEGO" + bytes(40))
    brick = Brick(root)
    for port, number in ((1, 16), (2, 29), (3, 33), (4, 32), ("A", 7), ("B", 7), ("C", 8)):
        brick.plug(port, number)
    run = [ev3proto.operation("OUTPUT_SPEED", 0, 1, 30), ev3proto.operation("OUTPUT_START", 0, 1)]
    brick.receive(ev3proto.command(*run, counter=1).build())
    return brick


def state(brick: Brick, root: Path) -> dict[str, str]:
    """Everything that a client of a brick could have changed."""
    found = {name: value.replace(str(root), "") for name, value in state_of(brick).items() if not LEFT_OUT.search(name)}
    for path in root.rglob("*"):
        found[f"disk/{path.relative_to(root)}"] = "" if path.is_dir() else hashlib.md5(path.read_bytes()).hexdigest()
    return found


def attacked(frames: int, root: Path) -> Iterator[set[str]]:
    """Yields the operations that passed in each round. Fails if the brick then differs from its twin."""
    for number in range(frames // ROUND):
        seed = SEED + number
        attacker, draw = Attacker(seed), Random(seed)
        roots = root / f"{number}", root / f"{number}.twin"
        brick, twin = map(switched_on, roots)
        proxy = Guarded(brick, twin.advance, clients=3)
        for _ in range(ROUND // 2):
            client = draw.randrange(3)
            for chunk in attacker.chunks(draw.choice((1, 1, 2, 4))):
                proxy.feed(client, chunk)
            attacker.handle = proxy.handle
            if draw.random() < 0.02:
                proxy.leave(client)
        for client in range(3):
            proxy.leave(client)
        brick.advance(2.0)
        twin.advance(2.0)
        one, other = state(brick, roots[0]), state(twin, roots[1])
        assert {name for name in one.keys() | other.keys() if one.get(name) != other.get(name)} == set(), f"seed {seed}"
        yield {name for message in proxy.answered for name in names_of(message)}


def test_what_passes_changes_nothing(tmp_path: Path) -> None:
    passed = set[str]().union(*attacked(effort(3000, 50_000), tmp_path))
    assert len(passed & {one.name for one in READING}) > 100
    assert {"BEGIN_UPLOAD", "LIST_FILES"} <= passed
    assert passed & {"CONTINUE_UPLOAD", "CONTINUE_LIST_FILES"}


def all_but(*names: str) -> Callable[[Message], Iterator[Blame]]:
    return lambda message: (blame for blame in blamed(message) if not blame.name.startswith(names))


HOLES: list[tuple[str, Any]] = [
    ("ev3proto.link.harm.blamed", all_but("OUTPUT_")),
    ("ev3proto.link.harm.blamed", all_but("UI_DRAW")),
    ("ev3proto.link.harm.blamed", all_but("DELETE_FILE")),
    ("ev3proto.link.harm.blamed", all_but("CREATE_DIR")),
    ("ev3proto.link.policy.with_types_kept", lambda command: command),
]


@each("place, hole", HOLES)
def test_a_hole_in_the_list_is_noticed(place: str, hole: Any, tmp_path: Path) -> None:
    with pytest.MonkeyPatch.context() as patched, tempfile.TemporaryDirectory(dir=tmp_path) as root:
        patched.setattr(place, hole)
        with pytest.raises(AssertionError):
            for _ in attacked(5000, Path(root)):
                pass


# Hide


SECRET = b"S"


def leaks(frames: int, root: Path) -> Iterator[tuple[bytes, bytes]]:
    """Yields the messages that show a secret: texts of commands, and memory that a command has not written."""
    attacker, values = Attacker(SEED), 0
    brick = switched_on(root)
    for number in range(frames):
        if number % ROUND == ROUND - 1 or brick.is_busy:
            brick = switched_on(root / f"{number}")
        brick._global_memory[:] = SECRET * len(brick._global_memory)
        frame = attacker.frame()
        replies = brick.receive(frame)
        if brick.is_busy:
            replies += brick.advance(3.0)
        hidden = masked(frame)
        if frame[4] & 1 == 0 and any(path.encode() in hidden for path in PATHS if len(path) > 6):
            yield frame, hidden
        for reply in replies:
            hidden = masked(reply, frame)
            values += any(byte not in b"x\0" for byte in hidden[5:])
            if reply[4] in (2, 4) and SECRET * 2 in hidden[5:]:
                yield frame, hidden
    assert values > frames // 10


def test_memory_full_of_a_secret_stays_hidden(tmp_path: Path) -> None:
    assert list(leaks(effort(3000, 20_000), tmp_path)) == []


@each("place", ["ev3proto.link.masking.blamed", "ev3proto.link.masking._is_public"])
def test_a_hole_in_the_mask_is_noticed(place: str, tmp_path: Path) -> None:
    with pytest.MonkeyPatch.context() as patched, tempfile.TemporaryDirectory(dir=tmp_path) as root:
        patched.setattr(place, lambda *_: [place] if place.endswith("_is_public") else [])
        assert next(leaks(5000, Path(root)), None) is not None

"""The initial inputs of the targets: the seeds in this folder, the captures, and inputs that made a target fail."""

from __future__ import annotations

from pathlib import Path
from random import Random

TARGETS = ("codec", "captures", "text", "lines", "filter", "assembly", "programs", "harm", "files")

HERE = Path(__file__).parent
REGRESSIONS = HERE / "regressions"

CAPTURES = HERE.parent / "captures"
_MOST_SEED = 1 << 14
_MOST_CHANGES = 4
_INTERESTING = (0, 1, 0x7F, 0x80, 0x81, 0xFE, 0xFF)


def inputs(target: str) -> list[bytes]:
    """The seeds of a target and its regressions."""
    found = [path.read_bytes() for path in sorted((HERE / "seeds" / target).glob("*"))]
    found += [path.read_bytes() for path in sorted((REGRESSIONS / target).glob("[!.]*"))]
    if target in ("codec", "text", "lines", "harm", "files"):
        # In a file of seeds, each line is a seed, so that people can read them.
        found = [line for data in found for line in _lines(target, data)]
    if target == "captures":
        found += [path.read_bytes()[:_MOST_SEED] for path in sorted(CAPTURES.glob("*.pcap*"))]
    return found


def _lines(target: str, data: bytes) -> list[bytes]:
    if target == "text":
        return [data]
    if target == "lines":
        return data.split(b"\n")
    try:
        return [bytes.fromhex(line) for line in data.decode().split("\n") if line]
    except ValueError:  # a regression, which is the frame itself
        return [data]


def mutated(data: bytes, random: Random, others: list[bytes]) -> bytes:
    """Changes an input in a few places: bytes are replaced, removed, doubled, or taken from another input."""
    found = bytearray(data)
    for _ in range(random.randint(1, _MOST_CHANGES)):
        at = random.randint(0, len(found))
        end = min(len(found), at + random.choice((1, 1, 2, 4, 16, 64)))
        kind = random.randrange(6)
        if kind == 0 and at < len(found):
            found[at] = random.choice(_INTERESTING)
        elif kind == 1 and at < len(found):
            found[at] ^= 1 << random.randrange(8)
        elif kind == 2:
            del found[at:end]
        elif kind == 3:
            found[at:at] = found[at:end] * random.choice((1, 2, 30))
        elif kind == 4:
            other = random.choice(others)
            start = random.randint(0, len(other))
            found[at:end] = other[start : start + random.choice((1, 4, 16, 200))]
        else:
            found[at:at] = bytes(random.randrange(256) for _ in range(random.randint(1, 4)))
    return bytes(found[: 4 * _MOST_SEED])

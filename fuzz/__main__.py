"""Drives a target: `python -m fuzz codec --seconds 60`.

With atheris (`pip install atheris`), inputs are chosen by code coverage. Without it, or with --plain, seeds are
changed at random. An input that makes a target fail is written into fuzz/regressions, which the tests try.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from random import Random

from fuzz.corpus import REGRESSIONS, TARGETS, inputs, mutated

_SLOW = 2.0
"""Maximum seconds for one input."""


def main() -> None:
    """Runs a target."""
    parser = argparse.ArgumentParser("python -m fuzz", description=__doc__)
    parser.add_argument("target", choices=TARGETS)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--plain", action="store_true", help="change seeds at random, also where atheris is installed")
    chosen = parser.parse_args()
    try:
        if chosen.plain:
            raise ImportError
        import atheris
    except ImportError:
        _plainly(chosen.target, _target(chosen.target), chosen.seconds, chosen.seed)
        return
    with atheris.instrument_imports(include=["ev3proto"]):
        target = _target(chosen.target)
    folder = str(REGRESSIONS / chosen.target)
    words = [f"-max_total_time={chosen.seconds:g}", f"-artifact_prefix={folder}/", f"-timeout={_SLOW * 5:g}"]
    atheris.Setup([sys.argv[0], *words, "-rss_limit_mb=2048", *_corpus(chosen.target)], target)
    atheris.Fuzz()


def _target(name: str) -> Callable[[bytes], None]:
    target: Callable[[bytes], None] = import_module(f"fuzz.{name}").one_input
    return target


def _corpus(name: str) -> list[str]:
    """Folders of inputs; the first also collects new inputs, and is temporary."""
    found = Path("build") / "fuzz" / name
    found.mkdir(parents=True, exist_ok=True)
    seeds = found.with_name(f"{name}-seeds")
    seeds.mkdir(exist_ok=True)
    for data in inputs(name):
        (seeds / sha256(data).hexdigest()[:16]).write_bytes(data)
    return [str(found), str(seeds)]


def _plainly(name: str, target: Callable[[bytes], None], seconds: float, seed: int) -> None:
    random = Random(seed)
    seeds = inputs(name)
    until = time.monotonic() + seconds
    count = failed = 0
    while time.monotonic() < until:
        data = mutated(random.choice(seeds), random, seeds)
        started = time.process_time()
        try:
            target(data)
            took = time.process_time() - started
            assert took < _SLOW, f"it took {took:.1f} s"
        except Exception as error:
            failed += 1
            path = REGRESSIONS / name / sha256(data).hexdigest()[:16]
            path.write_bytes(data)
            print(f"{path}: {type(error).__name__}: {error}")
        count += 1
    print(f"{name}: {count} inputs, {failed} made it fail")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

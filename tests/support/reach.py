"""Which tests to run before a commit: `bin/check` asks here, and pytest-testmon then leaves out what is not reached.

    python tests/support/reach.py [COMMIT]

prints the test files and folders for what differs from a commit, by default the last one, and before them --testmon, if
all of that is Python: testmon knows which functions each test has run, but neither what else it reads nor what runs in
another process. So the table names the tests of each part; the whole suite is for `tests/run`.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).parents[2]

_DISSECTOR = tuple(f"tests/dissector/test_dissector{name}.py" for name in ("", "_build", "_dialogues", "_statistics"))

TESTS: dict[str, tuple[str, ...]] = {
    "benchmarks": ("tests/checking/test_slips.py",),
    "bin": ("tests/architecture/test_setup.py",),
    "docs": ("tests/docs/test_docs_examples.py",),
    "docs/playground": ("tests/docs/test_playground_scripts.py",),
    "ev3proto": ("tests/schema", "tests/semantics", "tests/compose"),
    "ev3proto/brick": ("tests/brick",),
    "ev3proto/capture": tuple(
        f"tests/capture/test_{name}.py"
        for name in ("captures", "capture_formats", "claims", "filter", "statistics", "values")
    ),
    "ev3proto/capture/filter": ("tests/capture/test_filter.py", "tests/cli/test_cli_filters.py"),
    "ev3proto/checking": ("tests/checking", "tests/cli/test_cli_check.py"),
    "ev3proto/cli": ("tests/cli",),
    "ev3proto/generate": ("tests/generate", "tests/architecture/test_generated.py"),
    "ev3proto/generate/dissector": _DISSECTOR,
    "ev3proto/generate/modules": ("tests/compose", "tests/architecture/test_generated.py"),
    "ev3proto/generate/pages": ("tests/architecture/test_generated.py",),
    "ev3proto/link": ("tests/link",),
    "ev3proto/program": ("tests/program",),
    "ev3proto/pyshark": ("tests/tools",),
    "ev3proto/reading": ("tests/reading", "tests/cli/test_cli_texts.py"),
    "ev3proto/sampling.py": ("tests/tools/test_sample.py",),
    "ev3proto/scapy": ("tests/tools",),
    "ev3proto/semantics": ("tests/semantics", "tests/compose", "tests/checking"),
    "ev3proto/tables": ("tests/tables", "tests/schema", "tests/semantics", "tests/compose", "tests/checking"),
    "ev3proto/text": ("tests/text",),
    "fuzz": ("tests/architecture/test_fuzz.py",),
}
"""The tests of a file, by the longest beginning of its path. A test file is run itself."""


def reached_by(path: str) -> tuple[str, ...]:
    """Returns the test files and folders for a changed file; none for one that no test reads."""
    parts = PurePosixPath(path)
    if parts.name.startswith("test_"):
        return (path,)
    found = (TESTS[name] for each in (parts, *parts.parents) if (name := each.as_posix()) in TESTS)
    return next(found, ())


def changed(commit: str, root: Path = ROOT) -> list[str]:
    """Returns the files that differ from a commit and still exist, new ones too."""
    found: list[str] = []
    for command in (("diff", "--name-only", "--diff-filter=d", commit), ("ls-files", "--others", "--exclude-standard")):
        done = subprocess.run(("git", *command), cwd=root, capture_output=True, text=True, check=True)
        found += done.stdout.splitlines()
    return found


if __name__ == "__main__":
    found = {path: reached_by(path) for path in changed(sys.argv[1] if len(sys.argv) > 1 else "HEAD")}
    tests = dict.fromkeys(test for each in found.values() for test in each)
    if tests and all(path.endswith(".py") for path, each in found.items() if each):
        print("--testmon")
    print("".join(f"{test}\n" for test in tests), end="")

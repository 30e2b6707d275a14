"""What `bin/check` runs: the tests of a changed file, by a table of the parts of the project."""

from __future__ import annotations

import subprocess
from pathlib import Path

from support.cases import each
from support.reach import ROOT, TESTS, changed, reached_by


@each("path", TESTS)
def test_the_table_names_what_there_is(path: str) -> None:
    assert (ROOT / path).exists()
    assert all((ROOT / test).exists() for test in TESTS[path])


@each(
    "path, tests",
    [
        ("ev3proto/checking/rules/header.py", ("tests/checking", "tests/cli/test_cli_check.py")),
        ("ev3proto/capture/filter/names.py", ("tests/capture/test_filter.py", "tests/cli/test_cli_filters.py")),
        ("ev3proto/messages.py", ("tests/schema", "tests/semantics", "tests/compose")),
        ("tests/text/test_notations.py", ("tests/text/test_notations.py",)),
        ("CHANGELOG.md", ()),
    ],
)
def test_a_file_has_the_reached_by_its_nearest_part(path: str, tests: tuple[str, ...]) -> None:
    assert reached_by(path) == tests


def test_new_files_are_changes_too_and_deleted_ones_have_no_tests(tmp_path: Path) -> None:
    def git(*words: str) -> None:
        subprocess.run(("git", "-c", "user.name=a", "-c", "user.email=a@b", *words), cwd=tmp_path, check=True)

    for name in ("same.py", "changed.py", "deleted.py"):
        (tmp_path / name).write_text("1\n")
    git("init", "-q")
    git("add", ".")
    git("commit", "-q", "-m", "first")
    (tmp_path / "changed.py").write_text("2\n")
    (tmp_path / "deleted.py").unlink()
    (tmp_path / "new.py").write_text("3\n")
    assert changed("HEAD", tmp_path) == ["changed.py", "new.py"]

"""The output of servers while it is not read."""

from __future__ import annotations

import io
import os
import sys

import pytest

from ev3proto.cli.unblocked import unblocked_output


def test_output_that_is_not_read_is_dropped_and_counted(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("ev3proto.cli.unblocked.MOST_UNREAD", 300_000)
    monkeypatch.setattr("ev3proto.cli.unblocked._GRACE", 0.1)
    reading, writing = os.pipe()
    with os.fdopen(reading, "rb") as pipe, io.TextIOWrapper(os.fdopen(writing, "wb")) as stream:
        monkeypatch.setattr(sys, "stdout", stream)
        with unblocked_output():
            for _ in range(1000):
                sys.stdout.write("x" * 999 + "\n")
        monkeypatch.undo()
        said = capsys.readouterr().err
        number, _, rest = said.partition(" ")
        dropped = int(number.replace(",", ""))
        # As many as wait, and up to 64 KiB that the pipe holds, are kept until they are read, in whole lines.
        assert 600_000 <= dropped <= 700_000
        assert pipe.read(1_000_000 - dropped) == (b"x" * 999 + b"\n") * (1000 - dropped // 1000)
    assert rest == "bytes of output were dropped: the reader was 300,000 bytes behind\n"

"""tshark on this computer: how it is found and run, and its errors as sentences."""

from __future__ import annotations

import io
import re
import shutil
import subprocess
from collections.abc import Collection, Iterator
from contextlib import contextmanager, suppress
from tempfile import TemporaryFile
from typing import Self, cast

from ev3proto.capture import CaptureError
from ev3proto.generate.dissector.build import FILE_NAME, build
from ev3proto.generate.dissector.install import USUAL_PLACES
from ev3proto.temporary import temporary_folder

OLDEST = (4, 0)
"""The oldest Wireshark that the dissector runs in."""

TIMEOUT = 60
"""Timeout of a query, in seconds."""

GRACE_PERIOD = 10
"""Shutdown grace period of tshark, in seconds."""

_PREFERENCES = (
    "ev3.bytes:TRUE",
    "tcp.desegment_tcp_streams:TRUE",
    "tcp.reassemble_out_of_order:TRUE",
    "tcp.check_checksum:FALSE",  # which network cards fill in after the capture
    "ip.defragment:TRUE",
)
"""Required preferences, which override the user's."""

_COMPLAINT = re.compile(r"^(?:\S*[/\\])?tshark(?:\.exe)?: *(\S.*)$", re.MULTILINE)
_UNKNOWN = re.compile(r"unknown preference|not a valid (protocol|field)|aren't valid", re.IGNORECASE)
_ANY_FILE = re.compile(r'[Tt]he file "[^"\n]*"')
_NO_DEVICE = re.compile(r"no device named|no interface|no such device", re.IGNORECASE)
_NO_RIGHTS = re.compile(r"not permitted|permission to capture|sufficient permissions|dumpcap.*permission denied", re.I)

RIGHTS = (
    "on Debian and Ubuntu run sudo dpkg-reconfigure wireshark-common, choose Yes, join the group with"
    " sudo usermod -aG wireshark $USER, and log in again; elsewhere run this as a user who may"
)
"""Advice on the permission to capture."""


class EngineError(CaptureError):
    """The reason why tshark cannot be used, and what to do."""


class Tshark:
    """A tshark on this computer."""

    def __init__(self, name: str | None = None) -> None:
        """Finds tshark, by default on PATH and in the usual places. Raises EngineError."""
        found = next(filter(None, map(shutil.which, [name] if name else ["tshark", *USUAL_PLACES])), None)
        if found is None:
            missing = f"{name}: no such program" if name else "tshark is not on the path"
            raise EngineError(f"{missing}: install tshark, which is part of Wireshark, or pass its path by --tshark")
        self.path = found

    @contextmanager
    def parameters(self, dialect: str, ports: Collection[int]) -> Iterator[list[str]]:
        """Yields the arguments for reading frames; files that they name exist inside the `with`. Raises EngineError.

        An installed dissector is used, since Wireshark refuses a second one of the same name.
        """
        found = re.search(r"^TShark .*?(\d+)\.(\d+)", self.ask("-v"))
        if found is None:
            raise EngineError(f"{self.path} is not tshark: its version output does not name Wireshark")
        if (int(found[1]), int(found[2])) < OLDEST:
            raise EngineError(
                f"{self.path} is version {found[1]}.{found[2]}: the dissector runs in Wireshark"
                f" {'.'.join(map(str, OLDEST))} and later"
            )
        words = []
        said = [f"ev3.tcp_ports:{_ranges(ports)}"] if ports else []
        for preference in (*_PREFERENCES, f"ev3.firmware:{dialect}", *said):
            words += ["-o", preference]
        if re.search(r"\tev3(\t|$)", self.ask("-G", "protocols"), re.MULTILINE):
            yield words
            return
        with temporary_folder() as folder:
            folder.chmod(0o755)  # tshark may run as another user, after dropping the rights of root
            script = folder / FILE_NAME
            script.write_text(build(), encoding="utf-8")
            script.chmod(0o644)
            yield ["-X", f"lua_script:{script}", *words]

    def ask(self, *words: str) -> str:
        """Returns the output of a run with these arguments. Raises EngineError."""
        try:
            done = subprocess.run(
                [self.path, *words], stdin=subprocess.DEVNULL, capture_output=True, timeout=TIMEOUT, check=False
            )
        except OSError as error:
            raise EngineError(f"{self.path} cannot be run: {error.strerror or error}") from error
        except subprocess.TimeoutExpired as error:
            raise EngineError(f"{self.path} {' '.join(words)} took longer than {TIMEOUT} seconds") from error
        if done.returncode != 0:
            complaint = _said_last(done.stderr.decode("utf-8", "replace"), done.returncode)
            raise EngineError(f"{self.path} {' '.join(words)} failed: {complaint}")
        return done.stdout.decode("utf-8", "replace")


class Run:
    """A run of tshark, which ends with the `with`."""

    def __init__(self, tshark: Tshark, *words: str) -> None:
        """Starts tshark. Raises EngineError."""
        self._path = tshark.path
        self._said = TemporaryFile()  # noqa: SIM115 - closed at the end of the `with`
        self.is_stopped = False  # whether it was asked to stop
        try:
            self._process = subprocess.Popen(
                [self._path, "-n", *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self._said
            )
        except OSError as error:
            raise EngineError(f"{self._path} cannot be run: {error.strerror or error}") from error
        assert self._process.stdout is not None
        # its output
        self.output = cast(io.BufferedReader, self._process.stdout)

    def stop(self) -> None:
        """Asks tshark to stop: the output ends after the packets captured so far. Signal handlers may call it."""
        self.is_stopped = True
        with suppress(ProcessLookupError):
            self._process.terminate()  # it also ends its capturing child

    def check(self) -> None:
        """Raises EngineError if tshark failed. Call it when the output has ended."""
        status = self._process.wait(GRACE_PERIOD)
        if not status or self.is_stopped:
            return
        self._said.seek(0)
        said = self._said.read().decode("utf-8", "replace")
        if _UNKNOWN.search(said):
            raise EngineError(
                f"{self._path} does not load the dissector: the one that is installed is older than this ev3proto"
                " (install it again with: ev3proto dissector install), this Wireshark was built without Lua, or it is"
                " version 4.4 or later and runs as root"
            )
        if _NO_RIGHTS.search(said):
            raise EngineError(f"{self._path} is not allowed to capture: {RIGHTS}")
        if status < 0:
            raise EngineError(f"tshark ended by signal {-status} before the end of the input")
        hint = "; tshark -D lists the interfaces, sudo modprobe usbmon adds USB" if _NO_DEVICE.search(said) else ""
        raise EngineError(f"tshark: {_said_last(said, status)}{hint}")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()
        self.output.close()  # remaining output is not waited for
        try:
            self._process.wait(GRACE_PERIOD)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._said.close()


def _said_last(said: str, status: int) -> str:
    """Returns the last error on standard error, among warnings and notes."""
    complaints = _COMPLAINT.findall(said)
    return _ANY_FILE.sub("the file", complaints[-1]).strip().rstrip(".") if complaints else f"exit status {status}"


def _ranges(ports: Collection[int]) -> str:
    """Returns ports as ranges, `5555,6000-6003`, as in Wireshark: a command line cannot list thousands."""
    spans: list[tuple[int, int]] = []
    for port in sorted(set(ports)):
        if spans and spans[-1][1] == port - 1:
            spans[-1] = spans[-1][0], port
        else:
            spans.append((port, port))
    return ",".join(str(first) if first == last else f"{first}-{last}" for first, last in spans)

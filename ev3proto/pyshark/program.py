"""The tshark on this computer: found, asked for its version, and given the arguments for reading."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Collection, Iterator
from contextlib import contextmanager

from ev3proto.capture.record import CaptureError
from ev3proto.generate.dissector.build import FILE_NAME, build
from ev3proto.generate.dissector.install import USUAL_PLACES
from ev3proto.temporary import temporary_folder

OLDEST = (4, 0)
"""The oldest Wireshark that the dissector runs in."""

TIMEOUT = 60
"""Seconds that a question may take."""

_NO_LUA_AS_ROOT = (4, 4)
_AS_ROOT = 'Running as user "root"'

_CARRIERS = (
    "tcp.desegment_tcp_streams:TRUE",
    "tcp.reassemble_out_of_order:TRUE",
    "tcp.analyze_sequence_numbers:TRUE",
    "tcp.check_checksum:FALSE",  # which network cards fill in after the packet was captured
    "ip.defragment:TRUE",
)
"""Preferences that must be so, whatever the user's are."""

_COMPLAINT = re.compile(r"^(?:\S*[/\\])?tshark(?:\.exe)?: *(\S.*)$", re.MULTILINE)
_UNKNOWN = re.compile(r"unknown preference|not a valid (protocol|field)|aren't valid|Unknown preference", re.IGNORECASE)
_LUA_FAULT = re.compile(r"^.*\.lua:\d+: .*$", re.MULTILINE)
_ANY_FILE = re.compile(r'[Tt]he file "[^"\n]*"')
_NO_RIGHTS = re.compile(r"not permitted|permission to capture|sufficient permissions|dumpcap.*permission denied", re.I)
_INTERFACE = re.compile(r"^(\d+)\. (.+?)(?: \((.*)\))?$", re.MULTILINE)
_INTERNET_LINKS = re.compile(r"^\s*(EN10MB|LINUX_SLL2?|NULL|LOOP|RAW|IPV4|IPV6|IEEE802_11\w*|PPP\w*)\b", re.MULTILINE)

RIGHTS = (
    "on Debian and Ubuntu run sudo dpkg-reconfigure wireshark-common, choose Yes, join the group with"
    " sudo usermod -aG wireshark $USER, and log in again; elsewhere run this as a user who may"
)
"""What gives somebody the right to capture."""


class EngineError(CaptureError):
    """Why tshark cannot be used, and what to do, in a sentence."""


class Program:
    """A tshark on this computer."""

    def __init__(self, name: str | None = None) -> None:
        """Looks for it, and asks for its version.

        Args:
            name: Its path; None for the one on the path of programs, or where it usually is.

        Raises:
            EngineError: There is none, or one that cannot be used.
        """
        self.path = _find(name)
        found = re.search(r"^TShark .*?(\d+)\.(\d+)", self.ask("-v"))
        if found is None:
            raise EngineError(f"{self.path} is no tshark: it does not say which Wireshark it belongs to")
        self.version = int(found[1]), int(found[2])
        if self.version < OLDEST:
            raise EngineError(
                f"{self.path} is version {'.'.join(map(str, self.version))}: the dissector runs in Wireshark"
                f" {'.'.join(map(str, OLDEST))} and later"
            )

    @contextmanager
    def words(self, dialect: str, ports: Collection[int]) -> Iterator[list[str]]:
        """The arguments with which it reads frames; what they name is there as long as the `with`.

        The dissector that its user has installed is used, because a second one by the same name is refused.
        """
        words = ["-o", "ev3.bytes:TRUE", "-o", f"ev3.firmware:{dialect}"]
        words += ["-o", f"ev3.tcp_ports:{_ranges(ports)}"]
        for preference in _CARRIERS:
            words += ["-o", preference]
        if self._has_dissector():
            yield words
            return
        with temporary_folder() as folder:
            # What runs tshark may be somebody else, such as a program that drops the rights of root.
            folder.chmod(0o755)
            script = folder / FILE_NAME
            script.write_text(build(), encoding="utf-8")
            script.chmod(0o644)
            yield ["-X", f"lua_script:{script}", *words]

    def _has_dissector(self) -> bool:
        return re.search(r"\tev3(\t|$)", self.ask("-G", "protocols"), re.MULTILINE) is not None

    def ask(self, *words: str) -> str:
        """What it prints when it is run with those arguments.

        Raises:
            EngineError: It fails.
        """
        done = self._run(*words)
        if done.returncode != 0:
            raise EngineError(f"{self.path} {' '.join(words)} failed: {_said_last(done.stderr, done.returncode)}")
        return done.stdout

    def check_interface(self, name: str) -> bool:
        """Whether what is captured on an interface is internet traffic.

        Raises:
            EngineError: Nothing can be captured there.
        """
        done = self._run("-i", name, "-L")
        if done.returncode != 0:
            raise EngineError(self._why_no_capture(name, done))
        return _INTERNET_LINKS.search(done.stdout + done.stderr) is not None

    def _why_no_capture(self, name: str, done: subprocess.CompletedProcess[str]) -> str:
        found = _INTERFACE.findall(self._run("-D").stdout)
        names = [name for _, name, _ in found]
        is_there = any(name in entry for entry in found)
        if names and not is_there:
            hint = "; USB is captured after sudo modprobe usbmon" if name.startswith("usbmon") else ""
            return f"there is no interface {name}: there are {', '.join(names)}{hint}"
        if _NO_RIGHTS.search(done.stderr) or not names:
            return f"{self.path} may not capture on {name}: {RIGHTS}"
        return f"{self.path} cannot capture on {name}: {_said_last(done.stderr, done.returncode)}"

    def _run(self, *words: str) -> subprocess.CompletedProcess[str]:
        try:
            return subprocess.run(
                [self.path, *words],
                stdin=subprocess.DEVNULL,
                capture_output=True,
                encoding="utf-8",
                errors="replace",
                timeout=TIMEOUT,
                check=False,
            )
        except OSError as error:
            raise EngineError(f"{self.path} cannot be run: {error.strerror or error}") from error
        except subprocess.TimeoutExpired as error:
            raise EngineError(f"{self.path} {' '.join(words)} took longer than {TIMEOUT} seconds") from error

    def complaint(self, said: str, status: int) -> str:
        """Why it ended, in a sentence, from what it said on standard error and its exit status."""
        if _UNKNOWN.search(said):
            return self._why_no_dissector(said)
        if status < 0:
            return f"tshark ended by signal {-status} before it had read everything"
        if _NO_RIGHTS.search(said):
            return f"{self.path} may not capture: {RIGHTS}"
        return f"tshark says: {_said_last(said, status)}"

    def _why_no_dissector(self, said: str) -> str:
        fault = _LUA_FAULT.search(said)
        if fault:
            return f"{self.path} does not load the dissector, Lua says: {fault[0].strip()}"
        if self.version >= _NO_LUA_AS_ROOT and _AS_ROOT in said:
            return (
                f"{self.path} does not load the dissector: as root, Wireshark 4.4 and later load no Lua; run this as"
                " an ordinary user"
            )
        return (
            f"{self.path} does not load the dissector: the one that is installed is older than this ev3proto (install"
            " it again with: ev3proto dissector install), or this Wireshark was built without Lua"
        )


def _said_last(said: str, status: int) -> str:
    """The last complaint in what it printed on standard error, where warnings and remarks stand, too."""
    complaints = _COMPLAINT.findall(said)
    return _ANY_FILE.sub("the file", complaints[-1]).strip().rstrip(".") if complaints else f"exit status {status}"


def _find(name: str | None) -> str:
    for candidate in [name] if name else ["tshark", *USUAL_PLACES]:
        found = shutil.which(candidate)
        if found:
            return found
    missing = f"there is no program {name}" if name else "there is no tshark on the path"
    raise EngineError(f"{missing}: install tshark, which is part of Wireshark, or name it with --tshark")


def _ranges(ports: Collection[int]) -> str:
    """Ports as Wireshark's preferences have them, `5555,6000-6003`: a command line has no room for thousands."""
    spans: list[tuple[int, int]] = []
    for port in sorted(set(ports)):
        if spans and spans[-1][1] == port - 1:
            spans[-1] = spans[-1][0], port
        else:
            spans.append((port, port))
    return ",".join(str(first) if first == last else f"{first}-{last}" for first, last in spans)

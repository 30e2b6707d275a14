"""Runs tshark with the dissector: the distribution's, or the one that the variable EV3PROTO_TSHARK names.

As root, tshark 4.4 and later do not load Lua scripts. Then the user `nobody` runs it, and captures and scripts
are in a work folder that all users can read.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, Self

import pyshark
import pyshark.ek_field_mapping

from support.built import built_dissector

SETTING = "EV3PROTO_TSHARK"
DISSECTOR = built_dissector()

# A capture without packets, and a script that prints the version of Lua.
_EMPTY = bytes.fromhex("d4c3b2a1 0200 0400 00000000 00000000 00000400 01000000")
_PROBE = b'print("loaded by " .. _VERSION)\n'
# Lua errors, and what Wireshark calls bugs of a dissector; 4.6 also reports errors inside dissect_tcp_pdus this way.
_BUG_GROUP = 0x11000000
_ERRORS = f"_ws.lua.error || _ws.expert.group == {_BUG_GROUP}"
_TROUBLE = re.compile(r"\bLua\b|\.lua:\d|[Dd]issector bug")
# Prints the packets that match filters. The fields of other scripts exist when the reading begins.
_TAPS = """\
local filters = {{ {filters} }}
local taps = Proto("filter_taps", "Taps")
function taps.init()
    for number, filter in ipairs(filters) do
        local tap = Listener.new("frame", filter)
        function tap.packet(pinfo) print("filter " .. number .. " packet " .. pinfo.number) end
    end
    filters = {{}}
end
"""
# Run as `nobody` if root runs the tests, and without any user's preferences and plugins.
_AS_NOBODY = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--"]
_CLEAN = ["env", "-u", "XDG_CONFIG_HOME", "-u", "WIRESHARK_CONFIG_DIR", "-u", "WIRESHARK_PLUGIN_DIR"]
_CLEAN += ["HOME=/nonexistent", "LC_ALL=C.UTF-8", "TZ=UTC"]


class _Reader(pyshark.FileCapture):  # type: ignore[misc]
    """pyshark kills tshark when its output ends; if it was just ending by itself, its exit status is lost (255).

    So this class waits for it.
    """

    async def _cleanup_subprocess(self, process: asyncio.subprocess.Process) -> None:
        self._running_processes.discard(process)
        if self._eof_reached:
            await asyncio.wait_for(process.wait(), 60)
        await super()._cleanup_subprocess(process)


@dataclass(eq=False)
class Tshark:
    """A tshark that loads `script`; use it in a `with`."""

    program: Path
    script: Path | None = None
    timeout: float = 120

    folder: Path = field(init=False)  # the work folder, with everything that tshark reads
    path: Path = field(init=False)  # the path of a script that runs tshark as required, also for pyshark
    version: tuple[int, int] = field(init=False)
    lua: str = field(init=False)  # "Lua 5.2"; empty if no script is loaded
    _fields: dict[str, Any] | None = field(init=False, repr=False, default=None)
    _cleanup: contextlib.ExitStack = field(init=False, repr=False, default_factory=contextlib.ExitStack)

    @classmethod
    def from_setting(cls, script: Path | None = DISSECTOR) -> Self:
        """Yields the tshark of EV3PROTO_TSHARK, or the one on the path; `script` is copied into its work folder."""
        setting = os.environ.get(SETTING) or "tshark"
        found = shutil.which(setting)
        assert found, f"there is no {setting}: install tshark, or set {SETTING} to the path of one"
        return cls(Path(found).absolute(), script)

    def __enter__(self) -> Self:
        with contextlib.ExitStack() as stack:
            self._open(stack)
            self._cleanup = stack.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self._cleanup.close()

    def _open(self, stack: contextlib.ExitStack) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="ev3proto-", dir="/tmp"))
        stack.callback(shutil.rmtree, self.folder, ignore_errors=True)
        self.path = self._plain()
        self.folder.chmod(0o777)
        self.version = self._version()
        self.lua = self._lua()
        if not self.lua:
            number = ".".join(map(str, self.version))
            raise AssertionError(
                f"tshark {number}, {self.program}, loads no Lua script, which 4.4 and later never do as root: run the "
                "tests as an ordinary user"
            )
        if self.script is not None:
            self.load(self.script)

    def _plain(self) -> Path:
        """Creates a program in the work folder that runs a tshark of this system, as `nobody` if we are root."""
        words = [*_CLEAN, str(self.program)]
        if os.geteuid() == 0:
            as_nobody = [*_AS_NOBODY, *words]
            with contextlib.suppress(OSError, subprocess.TimeoutExpired):
                if subprocess.run([*as_nobody, "-v"], capture_output=True, timeout=self.timeout).returncode == 0:
                    words = as_nobody
        # pyshark takes the folder of its path, and looks for "tshark" there.
        path = self.folder / "tshark"
        path.write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n')
        path.chmod(0o755)
        return path

    def _version(self) -> tuple[int, int]:
        said = self._execute("-v").stdout
        found = re.match(r"TShark \(Wireshark\) (\d+)\.(\d+)", said)
        assert found, f"{self.program} -v does not say which Wireshark it is: {said[:200]!r}"
        return int(found[1]), int(found[2])

    def _lua(self) -> str:
        probe = self.place(_PROBE, "probe.lua")
        said = self._execute("-n", "-X", f"lua_script:{probe}", "-r", str(self.place(_EMPTY, "empty.pcap"))).stdout
        found = re.search(r"^loaded by (Lua \S+)", said, re.MULTILINE)
        return found[1] if found else ""

    def _execute(self, *words: str) -> subprocess.CompletedProcess[str]:
        """Runs tshark; fails if its exit status reports an error."""
        done = subprocess.run(
            [str(self.path), *words],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            errors="backslashreplace",
            timeout=self.timeout,
        )
        assert done.returncode == 0, f"{shlex.join(done.args)}: exit status {done.returncode}\n{done.stderr}"
        return done

    @property
    def words(self) -> list[str]:
        """The arguments that make tshark load the script, in pyshark's form: `custom_parameters=tshark.words`."""
        return ["-n", *([] if self.script is None else ["-X", f"lua_script:{self.script}"])]

    @property
    def statistics(self) -> list[str]:
        """Further arguments, which make it load ev3_statistics.lua."""
        return ["-X", f"lua_script:{self.place(DISSECTOR.with_name('ev3_statistics.lua'))}"]

    def place(self, source: Path | bytes, name: str = "") -> Path:
        """Copies a file, or bytes, into the work folder; returns a path that is valid for tshark and for us."""
        data, own_name = (source, "") if isinstance(source, bytes) else (source.read_bytes(), source.name)
        assert name or own_name, "bytes need a name"
        path = self.folder / (name or own_name)
        path.write_bytes(data)
        path.chmod(0o644)
        return path

    def load(self, source: Path | bytes, name: str = "") -> None:
        """Loads this script from now on, instead of the one before."""
        self._fields = None
        self.script = self.place(source, name or ("script.lua" if isinstance(source, bytes) else source.name))

    def _within(self, capture: Path) -> Path:
        return capture if capture.is_relative_to(self.folder) else self.place(capture)

    def run(self, capture: Path, *words: str, dissector: bool = True) -> str:
        """Returns the output of `tshark -n -X lua_script:... -r capture words`.

        A capture from elsewhere is first copied into the work folder. Lua errors make it fail if tshark reports them on
        standard error or in a tree. One-line output and fields do not show them; `lua_errors` finds all.
        """
        done = self._execute(*(self.words if dissector else ["-n"]), "-r", str(self._within(capture)), *words)
        assert not _TROUBLE.search(done.stderr), f"{shlex.join(done.args)}:\n{done.stderr}"
        if dissector:
            found = re.search(r"^.*Lua Error.*$", done.stdout, re.MULTILINE)
            assert not found, f"{shlex.join(done.args)}:\n{found and found[0].strip()}"
        return done.stdout

    def matches(self, capture: Path, filters: Sequence[str], *words: str) -> dict[str, list[int]]:
        """Returns the numbers of the packets that match each of many display filters, by one run of tshark."""
        taps = _TAPS.format(filters=", ".join(f"[==[{text}]==]" for text in filters))
        script = self.place(taps.encode(), "taps.lua")
        found: dict[str, list[int]] = {text: [] for text in filters}
        for line in self.run(capture, "-q", "-X", f"lua_script:{script}", *words).splitlines():
            if match := re.fullmatch(r"filter (\d+) packet (\d+)", line):
                found[filters[int(match[1]) - 1]].append(int(match[2]))
        return found

    def lua_errors(self, capture: Path, *words: str) -> list[str]:
        """Returns every Lua error of loading the script and reading `capture`: "frame 1: Lua Error: ...".

        `words` may change how tshark reads it: "-2" reads twice, "-V" makes the whole tree visible.
        """
        form = ["-T", "fields", "-E", "aggregator=\x1f", "-e", "frame.number", "-e", "_ws.expert.message"]
        done = self._execute(*self.words, "-r", str(self._within(capture)), "-Y", _ERRORS, *form, *words)
        errors: list[str] = []
        for line in done.stdout.split("\n"):
            number, tab, text = line.partition("\t")
            if tab and number.isdigit():  # a script may print lines, too
                messages = text.split("\x1f")
                told = [message for message in messages if _TROUBLE.search(message)] or messages
                errors += [f"frame {number}: {message}" for message in told]
        if _TROUBLE.search(done.stderr):
            errors.insert(0, done.stderr.strip())
        return errors

    def packets(self, capture: Path, *words: str, output: Literal["xml", "json", "ek"] = "xml") -> list[Any]:
        """Yields the packets as pyshark's objects, which reads tshark's output in one of three forms."""
        captured = self._within(capture)
        if output == "ek":
            self._tell_pyshark_the_fields()
        if sys.version_info < (3, 14):
            # A reader that was created without a loop leaves asyncio unable to run programs in other loops.
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)
                asyncio.set_child_watcher(None)  # type: ignore[arg-type]
        with contextlib.ExitStack() as stack:
            loop = asyncio.new_event_loop()
            stack.callback(loop.close)
            reader = _Reader(
                str(captured),
                tshark_path=str(self.path),
                custom_parameters=[*self.words, *words],
                use_json=output == "json",
                use_ek=output == "ek",
                eventloop=loop,
            )
            stack.callback(reader.close)
            return list(reader)

    def _tell_pyshark_the_fields(self) -> None:
        """Gives pyshark the types of the script's fields, which it needs when a field of a packet is read.

        By itself, pyshark 0.6 calls `tshark -G elastic-mapping` without our arguments, so that it lacks the fields of a
        script, keeps the answer in a file for each version of tshark, and does not know the answer's format since 4.6.
        """
        if self._fields is None:
            said = json.loads(self._execute("-G", "elastic-mapping", *self.words).stdout, object_pairs_hook=_merge)
            self._fields = said["mappings"]["properties"]["layers"]["properties"]
        pyshark.ek_field_mapping.MAPPING._protocol_to_mapping = dict(self._fields)


def _merge(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of tshark's JSON, in which a protocol may occur twice, once without fields."""
    merged: dict[str, Any] = {}
    for name, value in pairs:
        if name not in merged or value != {"properties": {}}:
            merged[name] = value
    return merged

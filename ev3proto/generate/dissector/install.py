"""Installs the dissector, its profile and the launcher of `ev3proto extcap` in Wireshark's personal folders.

Wireshark is then asked whether it loads the dissector.
"""

from __future__ import annotations

import contextlib
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from ev3proto.generate.dissector import profile
from ev3proto.generate.dissector.build import files, is_unchanged
from ev3proto.version import VERSION
from ev3proto.whole_files import write_whole

TIMEOUT = 60
PLATFORM = sys.platform
USUAL_PLACES = (
    "/Applications/Wireshark.app/Contents/MacOS/tshark",
    r"C:\Program Files\Wireshark\tshark.exe",
)
"""Where tshark is on systems that do not put it on the path."""

_OURS = "This file is made by ev3proto "
_LAUNCHER = "ev3proxy"
_OLD_EXTCAP = (4, 0)
_AS_ROOT = 'Running as user "root"'
_NO_LUA_AS_ROOT = (4, 4)


class InstallError(Exception):
    """Why the dissector cannot be installed, and what to do, in a sentence."""


class NoTsharkError(InstallError):
    """No tshark was found to ask."""


class InstallResult(Enum):
    """The outcome for one file."""

    NEW = "written"
    REPLACED = "written in place of an older one"
    FORCED = "written in place of another one"
    SAME = "there already, the same"
    KEPT = "kept, because it was changed"
    REMOVED = "removed"
    ABSENT = "not there"


@dataclass(frozen=True, slots=True)
class Folders:
    """Wireshark's folders: for Lua plugins, configuration profiles, and capture programs (extcap).

    `extcap` is None if only a folder for Lua plugins is known.
    """

    plugins: Path
    profiles: Path
    extcap: Path | None = None

    @classmethod
    def below(cls, folder: Path) -> Folders:
        """Returns folders that are all one folder, which the user named."""
        return cls(folder, folder / "profiles")

    @classmethod
    def documented(cls) -> Folders:
        """Returns the folders that Wireshark's manual names, for systems without a tshark to ask."""
        named = os.environ.get("WIRESHARK_CONFIG_DIR")
        if PLATFORM == "win32":
            roaming = Path(os.environ.get("APPDATA") or Path.home() / "AppData" / "Roaming") / "Wireshark"
            return cls(roaming / "plugins", (Path(named) if named else roaming) / "profiles", roaming / "extcap")
        configuration = Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config") / "wireshark"
        older = Path.home() / ".wireshark"
        if named:
            configuration = Path(named)
        elif older.is_dir() and not configuration.is_dir():
            configuration = older
        library = Path.home() / ".local" / "lib" / "wireshark"
        return cls(library / "plugins", configuration / "profiles", library / "extcap")


def install_dissector(folder: Path, *, force: bool) -> Iterator[tuple[Path, InstallResult]]:
    """Writes ev3.lua and ev3_statistics.lua into a folder; yields the outcome for each."""
    for name, text in files().items():
        yield folder / name, _write(folder / name, text, is_ours=is_unchanged, force=force)


def reason_to_keep(path: Path) -> str:
    """Returns why a file was kept: it `was changed`, or is another program's."""
    is_ours = _OURS in path.read_text(encoding="utf-8", errors="replace")
    return "was changed" if is_ours else "belongs to another program"


def install_profile(profiles: Path, *, force: bool) -> Iterator[tuple[Path, InstallResult]]:
    """Writes the profile's files; yields the outcome for each."""
    for name, text in profile.files().items():
        path = profiles / profile.NAME / name
        yield path, _write(path, text, is_ours=profile.is_unchanged, force=force)


def install_launcher(folder: Path, *, force: bool) -> tuple[Path, InstallResult]:
    """Writes the program that Wireshark starts for the interface "EV3 proxy"; yields the outcome."""
    path = _launcher_in(folder)
    outcome = _write(path, _launcher(), is_ours=lambda text: _OURS in text, force=force)
    if outcome is not InstallResult.KEPT:
        with contextlib.suppress(OSError):  # a file system may lack permission bits
            path.chmod(path.stat().st_mode | 0o111)
    return path, outcome


def _launcher_in(folder: Path) -> Path:
    return folder / (f"{_LAUNCHER}.bat" if PLATFORM == "win32" else _LAUNCHER)


def _launcher() -> str:
    """Returns a script that starts this Python's ev3proto, without imports from Wireshark's current folder (-P)."""
    if PLATFORM == "win32":
        python = sys.executable.replace("%", "%%")
        return f'@echo off\r\nrem {_OURS}{VERSION}.\r\n"{python}" -P -m ev3proto extcap %*\r\n'
    return f'#!/bin/sh\n# {_OURS}{VERSION}.\nexec {shlex.quote(sys.executable)} -P -m ev3proto extcap "$@"\n'


def uninstall(folders: Folders, *, force: bool) -> Iterator[tuple[Path, InstallResult]]:
    """Removes what the functions above write; `force`: also files of others and changed ones. Raises InstallError."""
    for name in files():
        plugin = folders.plugins / name
        yield plugin, _remove(plugin, is_ours=is_unchanged, force=force)
    if folders.extcap is not None:
        launcher = _launcher_in(folders.extcap)
        yield launcher, _remove(launcher, is_ours=lambda text: _OURS in text, force=force)
    place = folders.profiles / profile.NAME
    for name in profile.files():
        yield place / name, _remove(place / name, is_ours=profile.is_unchanged, force=force)
    with contextlib.suppress(OSError):  # other files in it are the user's
        place.rmdir()


def _remove(path: Path, is_ours: Callable[[str], bool], *, force: bool) -> InstallResult:
    try:
        text = path.read_bytes().decode("utf-8", "replace").replace("\r\n", "\n")
        if not is_ours(text) and not force:
            return InstallResult.KEPT
        path.unlink()
    except FileNotFoundError:
        return InstallResult.ABSENT
    except OSError as error:
        raise InstallError(f"{error.filename or path} cannot be removed: {error.strerror or error}") from error
    return InstallResult.REMOVED


def _write(path: Path, text: str, is_ours: Callable[[str], bool], *, force: bool) -> InstallResult:
    """Writes a file completely or not at all. A file that is not ours stays, unless `force` is given."""
    data = text.encode()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        outcome = _outcome(path, data, is_ours, force=force)
        if outcome not in (InstallResult.SAME, InstallResult.KEPT):
            if path.is_symlink():
                path.unlink()  # what it points to stays
            write_whole(path, data)
    except OSError as error:
        raise InstallError(f"{error.filename or path} cannot be written: {error.strerror or error}") from error
    return outcome


def _outcome(path: Path, data: bytes, is_ours: Callable[[str], bool], *, force: bool) -> InstallResult:
    try:
        found = path.read_bytes()
    except FileNotFoundError:
        return InstallResult.NEW
    if found == data:
        return InstallResult.SAME
    if is_ours(found.decode("utf-8", "replace").replace("\r\n", "\n")):
        return InstallResult.REPLACED
    return InstallResult.FORCED if force else InstallResult.KEPT


class Tshark:
    """A tshark that tells what its Wireshark knows. Raises InstallError if it cannot be run."""

    def __init__(self, name: str | None = None) -> None:
        self.path = _find(name)

    def folders(self) -> Folders:
        """Returns the personal folders."""
        said = self._ask("folders").stdout
        plugins, configuration = (self._folder(said, f"Personal {name}") for name in ("Lua Plugins", "configuration"))
        return Folders(plugins, configuration / "profiles", self._extcap(said, configuration))

    def _extcap(self, said: str, configuration: Path) -> Path:
        """Returns the folder for capture programs, which only later releases name."""
        found = re.search(r"^Personal Extcap path:[ \t]+(\S.*?)\s*$", said, re.MULTILINE | re.IGNORECASE)
        if found:
            return Path(found[1])
        if PLATFORM == "win32" or self._version() <= _OLD_EXTCAP:
            return configuration / "extcap"
        return Path.home() / ".local" / "lib" / "wireshark" / "extcap"

    def _folder(self, said: str, name: str) -> Path:
        found = re.search(rf"^{name}:[ \t]+(\S.*?)\s*$", said, re.MULTILINE)
        if not found:
            raise InstallError(
                f"{self.path} -G folders does not name the folder '{name}': is this a Wireshark with Lua? "
                "Name the folder for Lua plugins with --dir"
            )
        return Path(found[1])

    def trouble(self, plugin: Path) -> str | None:
        """Returns why it has not loaded a plugin, in a sentence; None if it has."""
        protocols = self._ask("protocols")
        plugins = self._ask("plugins").stdout.splitlines()
        loaded = [Path(line.rpartition("\t")[2].strip()) for line in plugins if "\tlua script\t" in line.lower()]
        has_protocol = re.search(r"\tev3(\t|$)", protocols.stdout, re.MULTILINE) is not None
        if has_protocol and any(_is_same(path, plugin) for path in loaded):
            return None
        complaint = re.search(r"^.*\.lua:\d+: .*$", protocols.stderr, re.MULTILINE)
        if complaint:
            return f"Lua says: {complaint[0].strip()}"
        if _AS_ROOT in protocols.stderr and self._version() >= _NO_LUA_AS_ROOT:
            return "as root, Wireshark 4.4 and later load no Lua plugins; run this, and Wireshark, as an ordinary user"
        return "it looks for Lua plugins elsewhere, or was built without Lua: see Help, About, Folders in Wireshark"

    def _version(self) -> tuple[int, int]:
        found = re.search(r"(\d+)\.(\d+)", self._run("-v").stdout)
        return (int(found[1]), int(found[2])) if found else (0, 0)

    def _ask(self, what: str) -> subprocess.CompletedProcess[str]:
        return self._run("-G", what)

    def _run(self, *words: str) -> subprocess.CompletedProcess[str]:
        try:
            done = subprocess.run(
                [self.path, *words],
                stdin=subprocess.DEVNULL,
                capture_output=True,
                encoding="utf-8",
                errors="surrogateescape",
                timeout=TIMEOUT,
                check=False,
            )
        except OSError as error:
            raise InstallError(f"{self.path} cannot be run: {error.strerror or error}") from error
        except subprocess.TimeoutExpired as error:
            raise InstallError(f"{self.path} {' '.join(words)} took longer than {TIMEOUT} seconds") from error
        if done.returncode != 0:
            said = done.stderr.strip().splitlines()
            reason = said[-1] if said else f"exit status {done.returncode}"
            raise InstallError(f"{self.path} {' '.join(words)} failed: {reason}")
        return done


def _find(name: str | None) -> str:
    """Returns the path of tshark: the one given, the one on the path, or one in a usual place."""
    candidates = [name] if name else ["tshark", *USUAL_PLACES]
    for candidate in candidates:
        found = shutil.which(candidate)
        if found:
            return found
    missing = f"{name}: no such program" if name else "tshark is not on the path"
    raise NoTsharkError(
        f"{missing}: install tshark, which is part of Wireshark, or pass its path by --tshark, or the folder for Lua "
        "plugins with --dir (Wireshark shows it under Help, About, Folders)"
    )


def _is_same(path: Path, other: Path) -> bool:
    try:
        return path.samefile(other)
    except OSError:
        return False

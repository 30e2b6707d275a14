"""How to install an extra: the command that fits how ev3proto itself was installed.

Optional features need packages that ev3proto does not install by default. `pyproject.toml` groups them as extras.
If one is missing, the user is shown a single command that works in that environment.
"""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

_SOURCES = Path(__file__).resolve().parents[1]


def install_command(extra: str) -> str:
    """Returns the shell command that installs an extra into the environment that runs this program.

    It is `bin/setup usb` in a clone that bin/ev3proto set up, `pipx inject ...` where pipx installed ev3proto,
    `python -m pip install ...` anywhere else.
    """
    return fitting_command(extra, _SOURCES, Path(sys.prefix), Path(sys.executable), is_windows=os.name == "nt")


def fitting_command(extra: str, sources: Path, prefix: Path, python: Path, *, is_windows: bool) -> str:
    """Returns the command for an installation: its sources, its environment and its interpreter."""
    setup = sources / "bin" / "setup"
    if setup.is_file() and prefix.resolve() == (sources / ".venv").resolve() and not is_windows:
        near = Path("bin/setup") if Path.cwd() == sources else setup
        return f"{shlex.quote(str(near))} {extra}"
    # Single quotes do not work in all shells of Windows.
    named = f'"ev3proto[{extra}]"' if is_windows else f"'ev3proto[{extra}]'"
    if (prefix / "pipx_metadata.json").is_file():
        return f"pipx inject ev3proto {named}"
    return f"{_called(python, is_windows)} -m pip install {named}"


def _called(python: Path, is_windows: bool) -> str:
    """Returns the name of an interpreter if the shell finds it by that, else its path."""
    first = next((each for each in _on_the_path() if (each / python.name).is_file()), None)
    if first is not None and first.resolve() == python.parent.resolve():
        return python.stem if is_windows else python.name
    if not is_windows:
        return shlex.quote(str(python))
    # PowerShell runs a quoted path only after an ampersand; a path without spaces needs neither.
    return f'& "{python}"' if " " in str(python) else str(python)


def _on_the_path() -> list[Path]:
    return [Path(each) for each in os.environ.get("PATH", "").split(os.pathsep) if each]

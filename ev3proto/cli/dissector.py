"""`ev3proto dissector`: builds the dissector for Wireshark, and installs it where Wireshark looks for it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import click

from ev3proto.cli.commands import Group
from ev3proto.cli.options import FOLDER, tshark_option
from ev3proto.cli.output import failing_on, output_options, say, write_text
from ev3proto.generate.dissector.build import FILE_NAME, build
from ev3proto.generate.dissector.install import (
    Folders,
    InstallError,
    InstallResult,
    NoTsharkError,
    Tshark,
    install_dissector,
    install_launcher,
    install_profile,
    reason_to_keep,
    uninstall,
)


@click.group(cls=Group)
def dissector() -> None:
    """Builds, installs or removes the dissector for Wireshark.

    It is a Lua file that lets Wireshark read the frames; a second one adds statistics.

    \b
      ev3proto dissector install --profile
      ev3proto dissector build -o ev3.lua
    """  # noqa: D301 - the mark by which click leaves lines as they are


@dissector.command("build")
@output_options
def build_command(output: Path | None, check: bool) -> None:
    """Writes the dissector, ev3.lua, which is the same every time.

    \b
      ev3proto dissector build > ev3.lua
      ev3proto dissector build -o dissector/ev3.lua --check
    """  # noqa: D301 - the mark by which click leaves lines as they are
    write_text(build(), output, check=check)


_folder_option = click.option(
    "--dir",
    "folder",
    type=FOLDER,
    help="Folder for Lua plugins; by default the one that tshark names, or else Wireshark's usual one.",
)


@dissector.command()
@_folder_option
@click.option("--profile", "with_profile", is_flag=True, help="Install the profile EV3, too: columns and colours.")
@tshark_option
@click.option("--force", is_flag=True, help="Overwrite also files that ev3proto did not write, or that were changed.")
def install(folder: Path | None, with_profile: bool, tshark: str | None, force: bool) -> None:
    """Installs the dissector for the current user.

    ev3.lua, the dissector, and ev3_statistics.lua, with statistics and the export of files, are written to the
    personal folder for Lua plugins that tshark names, and tshark is asked whether it loads ev3.lua. The program
    ev3proxy, with which Wireshark captures through `ev3proto extcap`, is written to the personal extcap folder, and the
    profile to tshark's personal configuration. Without tshark, the folders are those of Wireshark's manual.

    With --dir, everything is written below that folder, the profile to profiles/EV3, but not ev3proxy; tshark is not
    needed then, and asked only if --tshark names it.

    \b
      ev3proto dissector install --profile
      ev3proto dissector install --dir ~/.local/lib/wireshark/plugins
    """  # noqa: D301
    with failing_on(InstallError):
        _install(folder, with_profile, tshark, force)


@dissector.command("uninstall")
@_folder_option
@tshark_option
@click.option("--force", is_flag=True, help="Remove also files that ev3proto did not write, or that were changed.")
def uninstall_command(folder: Path | None, tshark: str | None, force: bool) -> None:
    """Removes what `install` wrote: the dissector, ev3proxy, and the profile EV3 where it is unchanged.

    \b
      ev3proto dissector uninstall
      ev3proto dissector uninstall --dir ~/.local/lib/wireshark/plugins
    """  # noqa: D301
    with failing_on(InstallError):
        if folder is not None:
            folders = Folders.below(folder)
        else:
            try:
                folders = Tshark(tshark).folders()
            except InstallError:
                if tshark:
                    raise
                folders = Folders.documented()
        outcomes = list(uninstall(folders, force=force))
    _say(outcomes, "remove")


def _install(folder: Path | None, with_profile: bool, tshark: str | None, force: bool) -> None:
    asked = _asked(tshark) if tshark or folder is None else None
    folders = _folders(folder, asked)
    for path, outcome in install_dissector(folders.plugins, force=force):
        if outcome is InstallResult.KEPT:
            raise InstallError(f"{path} {reason_to_keep(path)}; move it away, or overwrite it with --force")
        say(f"{path}: {outcome.value}")
    outcomes = [install_launcher(folders.extcap, force=force)] if folders.extcap else []
    if with_profile:
        outcomes += install_profile(folders.profiles, force=force)
    _say(outcomes, "overwrite")
    if asked is not None:
        if trouble := asked.trouble(folders.plugins / FILE_NAME):
            raise InstallError(f"{asked.path} does not load it: {trouble}")
        say(f"{asked.path} loads it.")
    _say_what_is_left(folder, with_profile=with_profile, is_loaded=asked is not None)


def _asked(tshark: str | None) -> Tshark | None:
    """Returns the tshark that is named or on the path; None if there is none, and none was named."""
    try:
        return Tshark(tshark)
    except NoTsharkError:
        if tshark:
            raise
        return None


def _folders(folder: Path | None, asked: Tshark | None) -> Folders:
    """Returns Wireshark's folders: below the one that was named, or as tshark says, or as documented."""
    if folder is not None:
        return Folders.below(folder)
    return Folders.documented() if asked is None else asked.folders()


def _say_what_is_left(folder: Path | None, *, with_profile: bool, is_loaded: bool) -> None:
    """Prints what the user still has to do."""
    if not is_loaded and folder is None:
        say("tshark was not found, so these are Wireshark's usual folders; compare Help, About, Folders in Wireshark.")
    say("Restart Wireshark, or choose Analyze, Reload Lua Plugins.")
    if with_profile and folder is None:
        say("For the profile, choose EV3 under Edit, Configuration Profiles.")
    elif with_profile:
        say("The profile belongs in the folder profiles of the personal configuration: Help, About, Folders.")


def _say(outcomes: Iterable[tuple[Path, InstallResult]], do: str) -> None:
    """Prints what became of each file, and how to change also what the user changed."""
    is_kept = False
    for path, outcome in outcomes:
        say(f"{path}: {outcome.value}")
        is_kept |= outcome is InstallResult.KEPT
    if is_kept:
        say(f"To {do} what was changed, add --force.")

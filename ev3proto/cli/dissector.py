"""`ev3proto dissector`: writes the dissector for Wireshark, or puts it where Wireshark looks for it."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from ev3proto.cli.commands import Group
from ev3proto.cli.output import failing_on, put, say
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
    uninstall,
)


@click.group(cls=Group)
def dissector() -> None:
    """The dissector for Wireshark: a Lua file that lets Wireshark read frames, and one for statistics.

    \b
      ev3proto dissector install --profile
      ev3proto dissector build -o ev3.lua
    """  # noqa: D301 - the mark by which click leaves lines as they are


@dissector.command("build")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="Write to this file, not standard output."
)
@click.option("--check", is_flag=True, help="Write nothing; exit status 1 if the file is not what would be written.")
def build_command(output: Path | None, check: bool) -> None:
    """Writes ev3.lua, the same bytes every time.

    \b
      ev3proto dissector build > ev3.lua
      ev3proto dissector build -o dissector/ev3.lua --check
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if check and output is None:
        raise click.UsageError("--check needs -o")
    if not put(build().encode(), output, check=check):
        sys.exit(1)


@dissector.command()
@click.option(
    "--dir",
    "folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder for Lua plugins; without it, tshark is asked, or Wireshark's usual folders are taken.",
)
@click.option("--profile", "with_profile", is_flag=True, help="Also add the profile EV3: columns and colours.")
@click.option("--tshark", metavar="PATH", help="The tshark to ask, where it is not on the path.")
@click.option("--force", is_flag=True, help="Overwrite files that are not ours, or that you changed.")
def install(folder: Path | None, with_profile: bool, tshark: str | None, force: bool) -> None:
    """Installs the dissector for the user who runs this.

    ev3.lua, which dissects, and ev3_statistics.lua, which adds statistics and the export of files, go into the
    personal folder for Lua plugins that tshark names, and tshark is asked whether it loads ev3.lua. The program
    ev3proxy, which lets Wireshark capture through `ev3proto extcap`, goes into the personal folder for extcap.
    The profile goes into tshark's personal configuration. Where there is no tshark, the folders are those that
    Wireshark's manual names for this system.

    With --dir, all goes below that folder, the profile into profiles/EV3, and there is no ev3proxy; no tshark is
    needed, and none is asked, unless --tshark names it.

    \b
      ev3proto dissector install --profile
      ev3proto dissector install --dir ~/.local/lib/wireshark/plugins
    """  # noqa: D301
    with failing_on(InstallError):
        _install(folder, with_profile, tshark, force)


@dissector.command("uninstall")
@click.option(
    "--dir",
    "folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder for Lua plugins; without it, tshark is asked, or Wireshark's usual folders are taken.",
)
@click.option("--tshark", metavar="PATH", help="The tshark to ask, where it is not on the path.")
@click.option("--force", is_flag=True, help="Remove files that are not ours, or that you changed, too.")
def uninstall_command(folder: Path | None, tshark: str | None, force: bool) -> None:
    """Removes what install has written: the dissector, ev3proxy, and the profile EV3 as far as it is unchanged.

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
    for path, outcome in outcomes:
        say(f"{path}: {outcome.value}")
    if any(outcome is InstallResult.KEPT for _, outcome in outcomes):
        say("To remove what was changed, add --force.")


def _install(folder: Path | None, with_profile: bool, tshark: str | None, force: bool) -> None:
    asked = None
    try:
        asked = Tshark(tshark) if tshark or folder is None else None
    except NoTsharkError:
        if tshark:
            raise
    named = Folders.below(folder) if folder is not None else None
    folders = named or (asked.folders() if asked else Folders.documented())
    plugin = folders.plugins / FILE_NAME
    for path, outcome in install_dissector(folders.plugins, force=force):
        if outcome is InstallResult.KEPT:
            raise InstallError(f"{path} belongs to another program; move it away, or overwrite it with --force")
        say(f"{path}: {outcome.value}")
    outcomes = [install_launcher(folders.extcap, force=force)] if folders.extcap else []
    if with_profile:
        outcomes += install_profile(folders.profiles, force=force)
    for path, outcome in outcomes:
        say(f"{path}: {outcome.value}")
    if any(outcome is InstallResult.KEPT for _, outcome in outcomes):
        say("To overwrite what was changed, add --force.")
    trouble = asked.trouble(plugin) if asked else None
    if asked and trouble:
        raise InstallError(f"{asked.path} does not load it: {trouble}")
    if asked:
        say(f"{asked.path} loads it.")
    elif folder is None:
        say("tshark was not found, so these are Wireshark's usual folders; compare Help, About, Folders in Wireshark.")
    say("Restart Wireshark, or choose Analyze, Reload Lua Plugins.")
    if with_profile and folder is None:
        say("For the profile, choose EV3 under Edit, Configuration Profiles.")
    elif with_profile:
        say("The profile belongs in the folder profiles of the personal configuration: Help, About, Folders.")

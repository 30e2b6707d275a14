"""`ev3proto dissector install`, with the real tshark: the files and messages it writes, and that Wireshark loads them.

Each test has its own home folder. It is in the work folder of the fixture `tshark`: a tshark that runs inside a folder
cannot read our other files.
"""

from __future__ import annotations

import os
import re
import shlex
import struct
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.cli import run_ev3proto_text, run_program
from support.packets import RAW_IP, Capture, Connection
from support.wireshark import DISSECTOR, Tshark

from ev3proto.cli.dissector import dissector
from ev3proto.generate.dissector import build, install, profile

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "captures"
README = (ROOT / "dissector" / "README.md").read_text(encoding="utf-8")
RELOAD = "Restart Wireshark, or choose Analyze, Reload Lua Plugins."
ELSEWHERE = "it looks for Lua plugins elsewhere, or was built without Lua: see Help, About, Folders in Wireshark"


def run(*words: str, path: str | None = None, **variables: str) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, "PATH": os.environ["PATH"] if path is None else path, **variables}
    return run_ev3proto_text("dissector", "install", *words, env=env)


def tree(folder: Path) -> list[str]:
    """All files below a folder."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir())


@dataclass
class Home:
    """A home folder with a tshark that uses it."""

    folder: Path
    tshark: Tshark

    def __post_init__(self) -> None:
        self.set()

    def set(self, **variables: Path) -> None:
        """Creates the tshark; `variables` are in its environment."""
        words = shlex.join(f"{name}={value}" for name, value in {"HOME": self.folder, **variables}.items())
        text = self.tshark.path.read_text()
        assert "HOME=/nonexistent" in text
        text = text.replace("HOME=/nonexistent", words)
        self.program.parent.mkdir(exist_ok=True)
        self.program.write_text(text)
        self.program.chmod(0o755)

    @property
    def program(self) -> Path:
        return self.folder / "bin" / "tshark"

    @property
    def plugin(self) -> Path:
        return self.folder / ".local" / "lib" / "wireshark" / "plugins" / "ev3.lua"

    @property
    def statistics(self) -> Path:
        return self.plugin.with_name("ev3_statistics.lua")

    @property
    def launcher(self) -> Path:
        """The program that Wireshark starts to capture through the proxy."""
        folder = ".config/wireshark" if self.tshark.version == (4, 0) else ".local/lib/wireshark"
        return self.folder / folder / "extcap" / "ev3proxy"

    @property
    def profile(self) -> Path:
        return self.folder / ".config" / "wireshark" / "profiles" / "EV3"

    def install(self, *words: str) -> subprocess.CompletedProcess[str]:
        """With our tshark first on the path."""
        return run(*words, path=f"{self.program.parent}{os.pathsep}{os.environ['PATH']}")

    def read(self, capture: str | Path, *words: str) -> str:
        """The output of tshark for a capture, without naming a script, and without errors."""
        placed = self.tshark.place(CAPTURES / capture)
        done = run_program(self.program, "-n", "-r", placed, *words)
        assert done.returncode == 0
        complaints = [line for line in done.stderr.splitlines() if not line.startswith("Running as user")]
        assert complaints == []
        return done.stdout

    def files(self) -> list[str]:
        """The files except tshark itself and the launcher."""
        return [name for name in tree(self.folder) if name != "bin/tshark" and not name.endswith("extcap/ev3proxy")]


def make_home(tshark: Tshark) -> Home:
    folder = Path(tempfile.mkdtemp(prefix="home-", dir=tshark.folder))
    folder.chmod(0o755)
    return Home(folder, tshark)


@pytest.fixture
def home(tshark: Tshark) -> Home:
    return make_home(tshark)


@pytest.fixture(scope="module")
def with_profile(tshark: Tshark) -> Home:
    """A home folder in which the profile is installed, for tests that only look at it."""
    home = make_home(tshark)
    assert home.install("--profile").returncode == 0
    return home


def test_installed_it_is_loaded_and_decodes(home: Home) -> None:
    done = home.install()
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        f"{home.plugin}: written",
        f"{home.statistics}: written",
        f"{home.launcher}: written",
        f"{home.program} loads it.",
        RELOAD,
    ]
    assert home.plugin.read_bytes() == DISSECTOR.read_bytes()
    assert home.statistics.read_bytes() == DISSECTOR.with_name("ev3_statistics.lua").read_bytes()
    assert home.files() == [f".local/lib/wireshark/plugins/{name}.lua" for name in ("ev3", "ev3_statistics")]
    assert home.plugin.stat().st_mode & 0o444 == 0o444
    assert home.read("wifi.pcapng") == home.tshark.run(CAPTURES / "wifi.pcapng")
    assert "SOUND.TONE" in home.read("wifi.pcapng")


def test_the_two_files_load_in_any_order(home: Home) -> None:
    home.install()
    words = ("wifi.pcapng", "-q", "-o", "ev3_statistics.print:TRUE")
    said = home.read(*words)
    home.statistics.rename(home.statistics.with_name("a.lua"))
    assert "\nSOUND.TONE " in said
    assert home.read(*words) == said


def test_an_older_one_is_replaced(tmp_path: Path) -> None:
    plugin = tmp_path / "ev3.lua"
    run("--dir", str(tmp_path))
    assert run("--dir", str(tmp_path)).stdout.startswith(f"{plugin}: there already, the same\n")
    plugin.write_text(build._signed("-- This file is made by ev3proto 0.0.1\n"))
    assert run("--dir", str(tmp_path)).stdout.startswith(f"{plugin}: written in place of an older one\n")
    assert plugin.read_bytes() == DISSECTOR.read_bytes()


@pytest.mark.parametrize("change", [lambda text: text.replace("SOUND", "NOISE"), lambda text: text + "-- mine\n"])
def test_a_changed_one_stays(tmp_path: Path, change: Callable[[str], str]) -> None:
    plugin = tmp_path / "ev3.lua"
    changed = change(DISSECTOR.read_text())
    plugin.write_text(changed)
    done = run("--dir", str(tmp_path))
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"{plugin} was changed; move it away, or overwrite it with --force\n"
    assert plugin.read_text() == changed
    done = run("--dir", str(tmp_path), "--force")
    assert done.stdout.startswith(f"{plugin}: written in place of another one\n")
    assert plugin.read_bytes() == DISSECTOR.read_bytes()


def test_another_program_keeps_its_file(tmp_path: Path) -> None:
    plugin = tmp_path / "ev3.lua"
    plugin.write_text("-- mine\n")
    done = run("--dir", str(tmp_path), "--profile")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"{plugin} belongs to another program; move it away, or overwrite it with --force\n"
    assert plugin.read_text() == "-- mine\n"
    assert tree(tmp_path) == ["ev3.lua"]
    done = run("--dir", str(tmp_path), "--force")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{plugin}: written in place of another one\n")


def test_what_a_link_points_to_stays(tmp_path: Path) -> None:
    elsewhere, plugin = tmp_path / "mine.lua", tmp_path / "plugins" / "ev3.lua"
    older = build._signed("-- This file is made by ev3proto 0.0.1\n")
    elsewhere.write_text(older)
    plugin.parent.mkdir()
    plugin.symlink_to(elsewhere)
    assert run("--dir", str(plugin.parent)).returncode == 0
    assert elsewhere.read_text() == older
    assert not plugin.is_symlink()


def test_a_folder_of_ones_own_needs_no_tshark(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "plugins"
    done = run("--dir", str(folder), "--profile", path="", HOME=str(tmp_path / "home"))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        f"{folder / 'ev3.lua'}: written",
        f"{folder / 'ev3_statistics.lua'}: written",
        f"{folder / 'profiles' / 'EV3' / 'preferences'}: written",
        f"{folder / 'profiles' / 'EV3' / 'colorfilters'}: written",
        f"{folder / 'profiles' / 'EV3' / 'dfilter_buttons'}: written",
        f"{folder / 'profiles' / 'EV3' / 'recent'}: written",
        RELOAD,
        "The profile belongs in the folder profiles of the personal configuration: Help, About, Folders.",
    ]
    assert len(tree(tmp_path)) == 6


def test_a_folder_and_a_tshark(home: Home, tmp_path: Path) -> None:
    done = run("--dir", str(home.plugin.parent), "--tshark", str(home.program))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[2] == f"{home.program} loads it."
    done = run("--dir", str(tmp_path / "plugins"), "--tshark", str(home.program))
    assert (tmp_path / "plugins" / "ev3.lua").exists()
    assert (done.returncode, done.stderr) == (1, f"{home.program} does not load it: {ELSEWHERE}\n")


def test_a_tshark_that_is_not_there(tmp_path: Path) -> None:
    advice = (
        "install tshark, which is part of Wireshark, or pass its path by --tshark, or the folder for Lua plugins with "
        "--dir (Wireshark shows it under Help, About, Folders)\n"
    )
    done = run("--tshark", "no-such-program")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"no-such-program: no such program: {advice}"
    assert tree(tmp_path) == []


@pytest.mark.parametrize(
    ("script", "complaint"),
    [
        ("#!/bin/sh\necho hello\n", "does not name the folder 'Personal Lua Plugins': is this a Wireshark with Lua?"),
        ("#!/bin/sh\necho broken >&2; exit 3\n", "-G folders failed: broken"),
        ("#!/no/such/shell\n", "cannot be run: No such file or directory"),
    ],
)
def test_another_program_than_tshark(tmp_path: Path, script: str, complaint: str) -> None:
    program = tmp_path / "tshark"
    program.write_text(script)
    program.chmod(0o755)
    done = run("--tshark", str(program))
    assert (done.returncode, done.stdout) == (1, "")
    assert complaint in done.stderr
    assert "Traceback" not in done.stderr
    assert tree(tmp_path) == ["tshark"]


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("")
    done = run("--dir", str(file / "plugins"))
    assert (done.returncode, done.stdout) == (1, "")
    assert re.fullmatch(rf"{re.escape(str(file))}\S* cannot be written: Not a directory\n", done.stderr)
    (tmp_path / "ev3.lua").mkdir()
    done = run("--dir", str(tmp_path))
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == f"{tmp_path / 'ev3.lua'} cannot be written: Is a directory\n"
    assert run("--dir", str(file)).returncode == 2


def test_another_dissector_of_the_same_name(home: Home) -> None:
    home.plugin.parent.mkdir(parents=True)
    (home.plugin.parent / "a-first.lua").write_text('local other = Proto("EV3", "another")\n')
    done = home.install()
    assert done.returncode == 1
    assert done.stdout == f"{home.plugin}: written\n{home.statistics}: written\n{home.launcher}: written\n"
    assert done.stderr.startswith(f"{home.program} does not load it: Lua says: ")
    assert "there cannot be two protocols with the same name" in done.stderr


def test_newer_ones_load_nothing_as_root(home: Home) -> None:
    if os.geteuid() != 0 or home.tshark.version < (4, 4):
        pytest.skip("needs root, and a tshark since 4.4")
    text, changes = re.subn(r"setpriv .* -- ", "", home.program.read_text())
    assert changes == 1
    home.program.write_text(text)
    done = home.install()
    assert done.returncode == 1
    assert done.stdout == f"{home.plugin}: written\n{home.statistics}: written\n{home.launcher}: written\n"
    assert done.stderr == (
        f"{home.program} does not load it: as root, Wireshark 4.4 and later load no Lua plugins; run this, and "
        "Wireshark, as an ordinary user\n"
    )


def test_the_profile(home: Home) -> None:
    done = home.install("--profile")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        f"{home.plugin}: written",
        f"{home.statistics}: written",
        f"{home.launcher}: written",
        f"{home.profile / 'preferences'}: written",
        f"{home.profile / 'colorfilters'}: written",
        f"{home.profile / 'dfilter_buttons'}: written",
        f"{home.profile / 'recent'}: written",
        f"{home.program} loads it.",
        RELOAD,
        "For the profile, choose EV3 under Edit, Configuration Profiles.",
    ]
    lines = home.read("wifi.pcapng", "-C", "EV3").splitlines()
    assert re.search(r" EV3 87 2 0\.0043\d* reply to ", lines[13]), lines[13]


def test_the_preferences_of_the_profile(with_profile: Home) -> None:
    done = run_program(with_profile.program, "-G", "currentprefs", "-C", "EV3")
    # With it a single segment that the capture lacks hides all that follow.
    assert "\n#tcp.reassemble_out_of_order: FALSE\n" in done.stdout
    # Only changed settings have no # before them.
    columns = re.search(r"^gui\.column\.format: ?\n((?:\t.*\n)+)", done.stdout, re.MULTILINE)
    assert columns
    pairs = re.findall(r'"(.*?)", "(.*?)"', columns[1])
    assert pairs == [(column.title, column.format) for column in profile.COLUMNS]


def test_the_colours_of_the_profile(with_profile: Home) -> None:
    form = ["-C", "EV3", "--color", "-2", "-T", "fields", "-e", "frame.number", "-e", "frame.coloring_rule.name"]
    rules: dict[tuple[str, int], str] = {}
    for capture in ("wifi.pcapng", "wifi-reordered.pcap", "usb-bootloader.pcapng", "daisy.pcap", "bluetooth.pcapng"):
        for line in with_profile.read(capture, *form).splitlines():
            number, _, rule = line.partition("\t")
            rules[capture, int(number)] = rule
    assert set(rules.values()) == {rule.name for rule in profile.RULES}
    assert rules["wifi.pcapng", 1] == "EV3: beacon and unlocking"
    assert rules["wifi.pcapng", 11] == "EV3: direct command"
    assert rules["wifi.pcapng", 14] == "EV3: reply"
    assert rules["bluetooth.pcapng", 20] == "EV3: part of a frame"
    assert rules["wifi.pcapng", 29] == "EV3: refused or failed"
    assert rules["wifi.pcapng", 36] == "EV3: file transfer"
    assert rules["wifi.pcapng", 51] == "EV3: refused or failed"
    assert rules["wifi.pcapng", 52] == "EV3: system command"
    assert rules["wifi.pcapng", 54] == "EV3: doubtful"
    assert rules["usb-bootloader.pcapng", 24] == "EV3: fault"


def edited(text: str) -> str:
    """As Wireshark writes a file: completely, without our first line."""
    return "# Written by Wireshark\n" + text.partition("\n")[2]


def older(text: str) -> str:
    """As another version of ours may have written it."""
    body = text.partition("\n")[2] + "# An older one.\n"
    return profile._signed(body)


def test_the_button_for_trouble_shows_what_is_wrong_with_ev3_alone(with_profile: Home) -> None:
    """Wireshark reports an error for every packet of a Bluetooth connection whose beginning is not in the capture."""
    trouble = {label: text for label, text, _ in profile.BUTTONS}["Trouble"]

    def found(capture: str, text: str) -> list[int]:
        return [
            int(number)
            for number in with_profile.read(capture, "-2", "-Y", text, "-T", "fields", "-e", "frame.number").split()
        ]

    assert len(found("bluetooth.pcapng", "ev3 && _ws.expert")) == 13
    assert found("bluetooth.pcapng", trouble) == [28, 29]
    assert found("wifi.pcapng", trouble) == found("wifi.pcapng", "ev3 && _ws.expert") != []


def test_the_button_for_motors_shows_all_that_works_on_motors(with_profile: Home, tmp_path: Path) -> None:
    """OUTPUT_STOP, _STEP_SPEED, _TIME_SYNC, _SPEED of ports in a variable, _READ; then a tone."""
    motors = ["A3 00 0F 01", "AE 00 01 14 00 83 E8030000 00 01", "B1 00 06 14 00 83 E8030000 01", "A5 00 40 14"]
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for body in (*motors, "A8 00 01 60 64", "94 01 01 82B801 82E803"):
        operation = bytes.fromhex(body)
        connection.send(struct.pack("<HHBH", 5 + len(operation), 1, 0x80, 0x0408) + operation)
    path = tmp_path / "motors.pcap"
    path.write_bytes(capture.data())
    button = {label: text for label, text, _ in profile.BUTTONS}["Motors"]
    assert with_profile.read(path, "-Y", button, "-T", "fields", "-e", "frame.number").split() == list("12345")


@pytest.mark.parametrize(
    ("change", "words", "said", "stays"),
    [
        (edited, (), "kept, because it was changed", True),
        (lambda text: text + "# mine\n", (), "kept, because it was changed", True),
        (edited, ("--force",), "written in place of another one", False),
        (older, (), "written in place of an older one", False),
        (str, (), "there already, the same", True),
    ],
    ids=["edited", "appended", "forced", "older", "same"],
)
@pytest.mark.parametrize("name", ["preferences", "colorfilters", "dfilter_buttons", "recent"])
def test_what_was_changed_stays(
    tmp_path: Path, name: str, change: Callable[[str], str], words: tuple[str, ...], said: str, stays: bool
) -> None:
    run("--dir", str(tmp_path), "--profile", path="")
    file = tmp_path / "profiles" / "EV3" / name
    before = change(file.read_text())
    file.write_text(before)
    done = run("--dir", str(tmp_path), "--profile", *words, path="")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"\n{file}: {said}\n" in done.stdout
    assert file.read_text() == (before if stays else profile.files()[name])
    assert ("add --force" in done.stdout) == (said.startswith("kept"))


@pytest.mark.parametrize(
    ("variable", "profiles"),
    [("XDG_CONFIG_HOME", "settings/wireshark/profiles"), ("WIRESHARK_CONFIG_DIR", "settings/profiles")],
)
def test_configuration_in_another_place(home: Home, variable: str, profiles: str) -> None:
    home.set(**{variable: home.folder / "settings"})
    done = home.install("--profile")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"{profiles}/EV3/preferences" in home.files()
    assert len(home.files()) == 6
    assert re.search(r" EV3 70 1 ", home.read("wifi.pcapng", "-C", "EV3"))


def test_the_session_in_the_readme(home: Home) -> None:
    found = re.search(r"^\$ ev3proto dissector install (.*)\n((?:(?!```).*\n)*)", README, re.MULTILINE)
    assert found
    said = home.install(*found[1].split()).stdout
    said = said.replace(str(home.program), "/usr/bin/tshark").replace(str(home.folder), "/home/me")
    # Wireshark 4.0 looks for the launcher elsewhere.
    assert said.replace("/.config/wireshark/extcap/", "/.local/lib/wireshark/extcap/") == found[2]


def test_uninstall_removes_what_install_wrote_and_no_more(tmp_path: Path) -> None:
    plugins = tmp_path / "plugins"
    assert run_ev3proto_text("dissector", "install", "--dir", str(plugins), "--profile").returncode == 0
    profile = plugins / "profiles" / "EV3"
    (profile / "preferences").write_text("gui.column.format: mine\n")
    done = run_ev3proto_text("dissector", "uninstall", "--dir", str(plugins))
    assert done.returncode == 0
    assert f"{plugins / 'ev3.lua'}: removed" in done.stdout
    assert f"{profile / 'preferences'}: kept, because it was changed" in done.stdout
    assert [path.name for path in plugins.rglob("*") if path.is_file()] == ["preferences"]
    assert run_ev3proto_text("dissector", "uninstall", "--dir", str(plugins), "--force").returncode == 0
    assert not profile.exists()
    assert "ev3.lua: not there" in run_ev3proto_text("dissector", "uninstall", "--dir", str(plugins)).stdout


def test_uninstall_leaves_the_plugin_of_others(tmp_path: Path) -> None:
    plugin = tmp_path / "ev3.lua"
    plugin.write_text("-- from another program\n")
    assert "kept" in run_ev3proto_text("dissector", "uninstall", "--dir", str(tmp_path)).stdout
    assert plugin.exists()


UNIX = (
    "home/.local/lib/wireshark/plugins",
    "home/.config/wireshark/profiles/EV3",
    "home/.local/lib/wireshark/extcap/ev3proxy",
)
USUAL = {
    "linux": UNIX,
    "darwin": UNIX,
    "win32": ("roaming/Wireshark/plugins", "roaming/Wireshark/profiles/EV3", "roaming/Wireshark/extcap/ev3proxy.bat"),
}
"""By platform: where Wireshark's manual says that plugins and profiles are, and programs that capture."""


@pytest.mark.parametrize("platform", USUAL)
def test_without_a_tshark_the_usual_folders_are_taken(
    platform: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(install, "PLATFORM", platform)
    monkeypatch.setenv("PATH", "")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("APPDATA", str(tmp_path / "roaming"))
    for name in ("XDG_CONFIG_HOME", "WIRESHARK_CONFIG_DIR"):
        monkeypatch.delenv(name, raising=False)
    plugins, profile, launcher = USUAL[platform]
    files = [
        f"{plugins}/ev3.lua",
        f"{plugins}/ev3_statistics.lua",
        launcher,
        *(f"{profile}/{name}" for name in ("colorfilters", "dfilter_buttons", "preferences", "recent")),
    ]
    done = CliRunner().invoke(dissector, ["install", "--profile"])
    assert done.exit_code == 0
    assert "tshark was not found" in done.output
    assert sorted(tree(tmp_path)) == sorted(files)
    text = (tmp_path / launcher).read_text()
    assert sys.executable in text
    assert ("%*" in text, '"$@"' in text) == (platform == "win32", platform != "win32")
    done = CliRunner().invoke(dissector, ["uninstall"])
    assert (done.exit_code, done.output.count(": removed\n")) == (0, 7)
    assert tree(tmp_path) == []


# The launcher of `ev3proto extcap`


def interfaces(home: Home) -> str:
    """What tshark lists, as the user who runs the tests: others may not start this Python."""
    return run_program("tshark", "-D", env={"HOME": str(home.folder)}).stdout


def test_the_proxy_is_among_the_interfaces(home: Home) -> None:
    home.install()
    assert os.access(home.launcher, os.X_OK)
    assert "ev3proxy (EV3 proxy)" in interfaces(home)
    path = f"{home.program.parent}{os.pathsep}{os.environ['PATH']}"
    done = run_ev3proto_text("dissector", "uninstall", env={**os.environ, "PATH": path})
    assert f"{home.launcher}: removed" in done.stdout
    assert "ev3proxy" not in interfaces(home)


def test_another_program_keeps_its_launcher(home: Home) -> None:
    home.launcher.parent.mkdir(parents=True)
    home.launcher.write_text("#!/bin/sh\n# mine\n")
    done = home.install()
    assert done.returncode == 0
    assert f"{home.launcher}: kept, because it was changed" in done.stdout
    assert home.launcher.read_text() == "#!/bin/sh\n# mine\n"
    assert not os.access(home.launcher, os.X_OK)
    assert f"{home.launcher}: written in place of another one" in home.install("--force").stdout
    assert os.access(home.launcher, os.X_OK)

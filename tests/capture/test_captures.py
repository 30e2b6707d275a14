"""The captures in `captures/`: made by the script there, described, and read by tshark without errors."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.portable

CAPTURES = Path(__file__).parents[2] / "captures"
README = (CAPTURES / "README.md").read_text(encoding="utf-8")
ROWS = dict(re.findall(r"^\| `([\w.-]+)` \| .+ \| (.+) \|$", README, re.MULTILINE))
MADE = sorted(name for name, how in ROWS.items() if "`make.py`" in how)

# The frames do not matter here, and Wireshark gives port 5555 to another protocol.
PLAIN = ("-d", "tcp.port==5555,data", "-o", "tcp.check_checksum:TRUE", "-o", "udp.check_checksum:TRUE")
COMPLAINTS = (
    '_ws.malformed || tcp.checksum.status == "Bad" || udp.checksum.status == "Bad" || ip.checksum.status == "Bad"'
)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the output of the script."""
    folder = tmp_path_factory.mktemp("captures")
    subprocess.run([sys.executable, str(CAPTURES / "make.py"), str(folder)], check=True, timeout=60)
    return folder


def tshark(capture: Path, *words: str) -> str:
    command = ["tshark", "-r", str(capture), *PLAIN, "-o", "ip.check_checksum:TRUE", *words]
    return subprocess.run(command, text=True, check=True, capture_output=True, timeout=60).stdout


def test_all_files_are_described() -> None:
    files = {path.name for path in CAPTURES.iterdir() if path.is_file() and path.name not in ("README.md", "make.py")}
    assert files == set(ROWS)


def test_the_script_makes_what_it_is_said_to_make(made: Path) -> None:
    assert sorted(path.name for path in made.iterdir()) == MADE


@pytest.mark.parametrize("name", MADE)
def test_the_same_bytes_every_time(name: str, made: Path) -> None:
    assert (made / name).read_bytes() == (CAPTURES / name).read_bytes()


@pytest.mark.parametrize("name", MADE)
def test_tshark_has_no_complaints(name: str) -> None:
    assert tshark(CAPTURES / name, "-Y", COMPLAINTS) == ""


@pytest.mark.parametrize(
    ("name", "packets"),
    [
        ("wifi.pcapng", "tcp.len > 0"),
        ("wifi-reordered.pcap", "tcp.len > 0"),
        ("usb.pcapng", "usb.data_len == 1024 && usb.bInterfaceClass == 3"),
        ("usb-plugged.pcap", 'usb.data_len == 1024 && usb.addr == "1.7.1"'),
        ("usb-windows.pcap", "usb.data_len == 1024"),
        ("usb-bootloader.pcapng", "usb.data_len == 1024 && usb.bInterfaceClass == 3"),
        ("daisy.pcap", "usb.data_len == 64"),
        ("bluetooth.log", "btspp.data"),
        ("bluetooth.pcapng", "btrfcomm.dlci == 2 && btrfcomm.len > 0"),
    ],
)
def test_tshark_finds_what_carries_frames(name: str, packets: str) -> None:
    assert len(tshark(CAPTURES / name, "-Y", packets).splitlines()) >= 7


def test_each_kind_of_carrier_is_tried() -> None:
    files = [str(CAPTURES / name) for name in MADE]
    table = subprocess.run(
        ["capinfos", "-r", "-T", "-E", *files], text=True, check=True, capture_output=True, timeout=60
    )
    kinds = {row.split("\t")[1] for row in table.stdout.splitlines()}
    assert len(kinds) == 5

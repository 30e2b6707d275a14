"""The carriers to a brick: WiFi and the serial port for real, USB and Bluetooth up to the last call."""

from __future__ import annotations

import errno
import os
import socket
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from support.announcing import Announcing, free_udp_port
from support.server import served

import ev3proto
from ev3proto import EV3
from ev3proto.brick.servers.server import Options
from ev3proto.link.carriers import open_wire, wifi
from ev3proto.link.carriers.usb import UDEV_RULE
from ev3proto.link.targets import Target, Way

SERIAL = "0016533f0c1e"


# Targets


@pytest.mark.parametrize(
    ("text", "target"),
    [
        ("wifi", Target(Way.WIFI)),
        ("wifi:192.0.2.10", Target(Way.WIFI, "192.0.2.10")),
        ("wifi:127.0.0.1:5556", Target(Way.WIFI, "127.0.0.1", 5556)),
        ("wifi:[::1]:5556", Target(Way.WIFI, "::1", 5556)),
        ("wifi:00:16:53:3F:0C:1E", Target(Way.WIFI, "00:16:53:3F:0C:1E")),
        ("USB", Target(Way.USB)),
        ("usb:0016533f0c1e", Target(Way.USB, "0016533f0c1e")),
        ("bluetooth:00:16:53:42:2B:99", Target(Way.BLUETOOTH, "00:16:53:42:2B:99")),
        ("bluetooth:/dev/rfcomm0", Target(Way.SERIAL, "/dev/rfcomm0")),
        ("serial:COM5", Target(Way.SERIAL, "COM5")),
        ("virtual", Target(Way.VIRTUAL)),
    ],
)
def test_targets(text: str, target: Target) -> None:
    assert Target.parse(text) == target
    assert Target.parse(str(target)) == target


@pytest.mark.parametrize("text", ["", "wlan", "wifi:a:b", "wifi:a:0", "wifi:a:65536", "serial", "bluetooth:"])
def test_no_targets(text: str) -> None:
    with pytest.raises(ValueError, match=r"unknown target|does not name a brick|invalid port"):
        Target.parse(text)


# WiFi: the beacon


def test_a_brick_is_found_by_its_beacon(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    port = free_udp_port()
    monkeypatch.setitem(wifi.discover.__kwdefaults__, "port", port)  # type: ignore[arg-type]
    with (
        served(tmp_path, Options(port=0, beacon=False)) as brick,
        Announcing(SERIAL, brick.port, port),
        EV3(protocol=ev3proto.WIFI, host="00:16:53:3F:0C:1E") as my_ev3,
    ):
        assert my_ev3.volume == 100


def test_the_beacon_of_another_brick_is_passed_over() -> None:
    port = free_udp_port()
    with Announcing(SERIAL.upper(), 5555, port, b"no beacon"):
        found = wifi.discover(None, 5.0, interface="127.0.0.1", port=port)
        assert found == wifi.Found("127.0.0.1", 5555, SERIAL, "robot")
        with pytest.raises(ev3proto.NoBrickError, match=f"001653000001 was found .* {SERIAL} is at 127.0.0.1"):
            wifi.discover("001653000001", 0.2, interface="127.0.0.1", port=port)


def test_without_a_beacon_no_brick_is_found() -> None:
    with pytest.raises(ev3proto.NoBrickError, match=r"no brick was found within 0\.05 s\. Is the brick's WiFi on"):
        wifi.discover(None, 0.05, interface="127.0.0.1", port=free_udp_port())


def test_the_port_of_the_beacon_is_in_use() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        with pytest.raises(ev3proto.PortInUse, match="another program waits for a brick's beacon"):
            wifi.discover(None, 1.0, interface="127.0.0.1", port=other.getsockname()[1])


def test_an_unknown_host_name() -> None:
    with pytest.raises(ev3proto.NoBrickError, match="no computer or brick has this name"):
        open_wire(Target(Way.WIFI, "brick..local"))


# The serial port


def test_the_serial_port(tmp_path: Path) -> None:
    port = tmp_path / "ev3"
    with served(tmp_path / "brick", Options(port=None, serial=port)):
        with EV3(protocol=ev3proto.BLUETOOTH, host=str(port)) as my_ev3:
            my_ev3.name = "robot"
            assert my_ev3.protocol == "Bluetooth"
            my_ev3.download(bytes(3000), "../prjs/x")
            assert my_ev3.upload("../prjs/x") == bytes(3000)
        with EV3(target=f"serial:{port}") as my_ev3:
            assert my_ev3.name == "robot"


def test_the_brick_behind_the_serial_port_goes_away() -> None:
    import pty

    master, slave = pty.openpty()
    with EV3(target=f"serial:{os.ttyname(slave)}") as my_ev3:
        os.close(slave)
        os.close(master)
        with pytest.raises(ev3proto.ConnectionLostError, match=r"was lost \([^\[\]]+\); connect again"):
            my_ev3.send_direct_cmd(ev3proto.opNop, sync_mode=ev3proto.SYNC)


@pytest.mark.parametrize(
    ("number", "kind", "sentence"),
    [
        (errno.EACCES, ev3proto.NoBrickError, "dialout"),
        (errno.EBUSY, ev3proto.PortInUseError, "another program has /dev/rfcomm0 open"),
        (errno.EHOSTDOWN, ev3proto.NoBrickError, "does not answer; is it on and near"),
        (errno.EIO, ev3proto.NoBrickError, "^/dev/rfcomm0 cannot be opened: Input/output error$"),
    ],
)
def test_a_serial_port_that_cannot_be_opened(
    monkeypatch: pytest.MonkeyPatch, number: int, kind: type[Exception], sentence: str
) -> None:
    import serial

    def refuse(*_: object, **__: object) -> None:
        raise serial.SerialException(number, os.strerror(number))

    monkeypatch.setattr(serial, "Serial", refuse)
    with pytest.raises(kind, match=sentence):
        open_wire(Target(Way.SERIAL, "/dev/rfcomm0"))


def test_a_file_that_is_not_a_serial_port(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for place in (str(tmp_path / "file"), str(tmp_path)):
        with pytest.raises(ev3proto.NoBrickError) as caught:
            open_wire(Target(Way.SERIAL, place))
        assert str(caught.value) == f"{place} is not a serial port; give the brick's, such as /dev/rfcomm0 or COM5"


def test_packages_that_are_not_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, target, hint in (
        ("serial", "serial:/dev/rfcomm0", r"needs the package pyserial, which is not installed: .*\bserial\b"),
        ("hid", "usb", r"needs the package hidapi, which is not installed: .*\busb\b"),
    ):
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(ev3proto.LinkError, match=hint):
            open_wire(Target.parse(target))


# USB: calls of hidapi and their results


class Device:
    """The used part of hidapi's device: a brick that answers with given memory."""

    def __init__(self) -> None:
        self.reports: list[bytes] = []
        self.answers: list[bytes] = []
        self.is_gone = False
        self.path = b""

    def open_path(self, path: bytes) -> None:
        if path == b"/dev/not-allowed":
            raise OSError("open failed")
        self.path = path

    def write(self, report: bytes) -> int:
        self.reports.append(report)
        frame = report[1:]
        if frame[4] == 0:
            self.answers.append((b"\x04\x00" + frame[2:4] + b"\x02\x07").ljust(1024, b"\xaa"))
        return -1 if self.is_gone else len(report)

    def read(self, size: int, timeout_ms: int) -> list[int]:
        if self.is_gone:
            raise OSError("read error")
        if not self.answers:
            threading.Event().wait(0.001)
            return []
        return list(self.answers.pop(0)[:size])

    def close(self) -> None:
        self.path = b"closed"


@pytest.fixture
def hid(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Device]:
    def plugged(*bricks: tuple[str, bytes], is_updating: bool = False) -> Device:
        device = Device()

        def listed(vendor: int, product: int) -> list[dict[str, Any]]:
            assert vendor == 0x0694
            if product == 0x0006:
                return [{}] if is_updating else []
            assert product == 0x0005
            return [{"serial_number": number, "path": path} for number, path in bricks]

        monkeypatch.setitem(sys.modules, "hid", SimpleNamespace(enumerate=listed, device=lambda: device))
        return device

    return plugged


def test_usb_reports_have_one_frame_each_and_no_number(hid: Callable[..., Device]) -> None:
    device = hid((SERIAL, b"/dev/hidraw0"))
    with EV3(protocol=ev3proto.USB, host="00:16:53:3F:0C:1E") as my_ev3:
        assert my_ev3.send_direct_cmd(ev3proto.opNop, global_mem=1) == b"\x07"
    assert device.reports == [b"\0" + bytes.fromhex("06002a0000010001").ljust(1024, b"\0")]
    assert device.path == b"closed"


def test_usb_is_unplugged(hid: Callable[..., Device]) -> None:
    device = hid((SERIAL, b"/dev/hidraw0"))
    with EV3(protocol=ev3proto.USB) as my_ev3:
        device.is_gone = True
        with pytest.raises(
            ev3proto.ConnectionLostError, match=f"the brick {SERIAL} was unplugged or switched off; plug it in"
        ):
            my_ev3.send_direct_cmd(ev3proto.opNop, sync_mode=ev3proto.SYNC)


def test_usb_says_what_to_do(hid: Callable[..., Device]) -> None:
    hid()
    with pytest.raises(ev3proto.NoEV3, match="no brick found on USB; is the cable in the port marked PC"):
        EV3(protocol=ev3proto.USB)
    hid(is_updating=True)
    with pytest.raises(ev3proto.NoEV3, match="in its firmware updater"):
        EV3(protocol=ev3proto.USB)
    hid((SERIAL, b"/dev/hidraw0"), ("001653000001", b"/dev/hidraw1"))
    with pytest.raises(ev3proto.NoEV3, match=f"2 bricks are plugged in \\({SERIAL}, 001653000001\\); choose one"):
        EV3(protocol=ev3proto.USB)
    with pytest.raises(ev3proto.NoEV3, match="no brick with the serial number 001653000002 is plugged in"):
        EV3(protocol=ev3proto.USB, host="001653000002")
    hid((SERIAL, b"/dev/not-allowed"))
    with pytest.raises(ev3proto.NoEV3, match=r"99-ev3\.rules") as caught:
        EV3(protocol=ev3proto.USB)
    assert UDEV_RULE in str(caught.value)
    assert UDEV_RULE == 'SUBSYSTEMS=="usb", ATTRS{idVendor}=="0694", ATTRS{idProduct}=="0005", MODE="0666"'


# Bluetooth: calls of the socket


def test_bluetooth_connects_to_channel_1(monkeypatch: pytest.MonkeyPatch) -> None:
    ours, bricks = socket.socketpair()
    asked: list[Any] = []

    class Rfcomm:
        def __init__(self, *arguments: int) -> None:
            asked.append(arguments)

        def connect(self, address: tuple[str, int]) -> None:
            asked.append(address)

        def __getattr__(self, name: str) -> Any:
            return getattr(ours, name)

    monkeypatch.setattr(socket, "AF_BLUETOOTH", 31, raising=False)
    monkeypatch.setattr(socket, "BTPROTO_RFCOMM", 3, raising=False)
    monkeypatch.setattr(socket, "socket", Rfcomm)
    with bricks, EV3(protocol=ev3proto.BLUETOOTH, host="00:16:53:42:2b:99") as my_ev3:
        my_ev3.send_direct_cmd(ev3proto.opNop)
        assert bricks.recv(99) == bytes.fromhex("06002a0080000001")
    assert asked == [(31, socket.SOCK_STREAM, 3), ("00:16:53:42:2B:99", 1)]


@pytest.mark.parametrize(
    ("number", "kind", "sentence"),
    [
        (errno.EBUSY, ev3proto.PortInUseError, "another program is connected to this brick"),
        (errno.EHOSTDOWN, ev3proto.NoBrickError, "is the brick on and near"),
        (errno.ECONNREFUSED, ev3proto.NoBrickError, "pair it with this computer first"),
    ],
)
def test_bluetooth_says_what_to_do(
    monkeypatch: pytest.MonkeyPatch, number: int, kind: type[Exception], sentence: str
) -> None:
    class Rfcomm:
        def __init__(self, *arguments: int) -> None: ...

        def connect(self, address: tuple[str, int]) -> None:
            raise OSError(number, os.strerror(number))

        def settimeout(self, seconds: float) -> None: ...

        def close(self) -> None: ...

    monkeypatch.setattr(socket, "AF_BLUETOOTH", 31, raising=False)
    monkeypatch.setattr(socket, "BTPROTO_RFCOMM", 3, raising=False)
    monkeypatch.setattr(socket, "socket", Rfcomm)
    with pytest.raises(kind, match=sentence):
        open_wire(Target(Way.BLUETOOTH, "00:16:53:42:2B:99"))


def test_a_python_without_bluetooth_asks_for_the_serial_port(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(socket, "AF_BLUETOOTH", raising=False)
    with pytest.raises(ev3proto.NoBrickError, match="Give the serial port of the connection in place of the MAC"):
        open_wire(Target(Way.BLUETOOTH, "00:16:53:42:2B:99"))
    with pytest.raises(ev3proto.NoBrickError, match="invalid MAC address"):
        open_wire(Target(Way.BLUETOOTH, "my brick"))


# The virtual brick


def test_a_virtual_brick_has_the_core_set() -> None:
    with EV3(target="virtual") as brick:
        assert tuple(brick.sensors) == (16, 32, 29, 30, 8, 7, 7, None)
    with EV3(target=Target(Way.VIRTUAL, is_bare=True)) as brick:
        assert tuple(brick.sensors) == (None,) * 8


def test_a_virtual_brick_has_files_until_it_is_gone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with EV3(target="virtual") as brick:
        brick.download(b"abc", "../prjs/demo/x.rtf")
        assert brick.upload("../prjs/demo/x.rtf") == b"abc"
        assert len(list(tmp_path.iterdir())) == 1
    assert list(tmp_path.iterdir()) == []

"""WiFi discovery: the beacon, the unlock text and its variants, both ways."""

from __future__ import annotations

import pytest

import ev3proto
from ev3proto import Beacon, Unlock
from ev3proto.schema.discovery import is_beacon
from ev3proto.tables.discovery import ACCEPT

BEACON = b"Serial-Number: 0016533f0c1e\r\nPort: 5555\r\nName: EV3\r\nProtocol: EV3\r\n"


def test_a_beacon_both_ways() -> None:
    beacon = Beacon.parse(BEACON)
    assert beacon == Beacon(serial="0016533f0c1e", port="5555", name="EV3", protocol="EV3")
    assert beacon.build() == BEACON


def test_a_beacon_with_a_name() -> None:
    assert Beacon("0016533f0c1e", name="Käthe").build().splitlines()[2] == b"Name: K\xe4the"
    with pytest.raises(ev3proto.BuildError, match="one line of ISO-8859-1"):
        Beacon("0016533f0c1e", name="two\nlines").build()


@pytest.mark.parametrize(
    ("datagram", "offset", "reason"),
    [
        (b"", 0, "Serial-Number"),
        (b"Serial-Number: 1\r\nPort 5555\r\n", 18, "Port"),
        (BEACON[:-1], 52, "Protocol"),
        (BEACON + b"x", 67, "1 bytes follow"),
    ],
)
def test_faulty_beacons(datagram: bytes, offset: int, reason: str) -> None:
    with pytest.raises(ev3proto.DecodeError, match=reason) as error:
        Beacon.parse(datagram)
    assert error.value.offset == offset


@pytest.mark.parametrize(
    ("datagram", "is_whole", "is_cut"),
    [
        (BEACON, True, True),
        (BEACON + b"x", True, True),
        (BEACON[:-3], True, True),
        (BEACON[:35], True, True),
        (BEACON.replace(b"Name: EV3\r\n", b""), True, True),
        (BEACON[:34], False, True),
        (BEACON[:20], False, True),
        (BEACON[:14], False, False),
        (BEACON.replace(b"Port", b"Type"), False, False),
        (BEACON.replace(b"Protocol: EV3", b"Protocol: IPP"), False, False),
        (BEACON.replace(b"Protocol: EV3", b"Protocol: EV3000"), False, False),
        (b"", False, False),
    ],
)
def test_is_beacon(datagram: bytes, is_whole: bool, is_cut: bool) -> None:
    assert is_beacon(datagram) is is_whole
    assert is_beacon(datagram, is_cut=True) is is_cut


@pytest.mark.parametrize(
    ("text", "unlock"),
    [
        (
            b"GET /target?sn=0016533f0c1e VMTP1.0\r\nProtocol: EV3\r\n\r\n",
            Unlock("0016533f0c1e", space=True, newline="\r\n", endings=2),
        ),
        (
            b"GET /target?sn=0016533f0c1eVMTP1.0\nProtocol: EV3\n",
            Unlock("0016533f0c1e", space=False, newline="\n", endings=1),
        ),
        (b"GET /target?sn=1 VMTP1.0\nProtocol: EV3", Unlock("1", newline="\n", endings=0)),
        (b"GET /target?sn=VMTP1.0\nProtocol: EV3\n\n", Unlock("", space=False, newline="\n", endings=2)),
        (b"GET /target?sn=\r\nProtocol: EV3\r\n\r\n", Unlock("", space=False, version=False)),
        (b"GET /target?sn=0016533f0c1e \nProtocol:EV3\n", Unlock("0016533f0c1e", True, "\n", 1, False, False)),
        (b"GET /target?sn=1 VMTP1.0\r\nProtocol:EV3\r\n\r\n", Unlock("1", gap=False)),
    ],
)
def test_unlock_texts_both_ways(text: bytes, unlock: Unlock) -> None:
    assert Unlock.parse(text) == unlock
    assert unlock.build() == text


@pytest.mark.parametrize("text", [b"", b"GET / HTTP/1.1\r\n\r\n", b"GET /target?sn=00 VMTP1.0\r\nProtocol: EV3\n"])
def test_faulty_unlock_texts(text: bytes) -> None:
    with pytest.raises(ev3proto.DecodeError):
        Unlock.parse(text)


@pytest.mark.parametrize("unlock", [Unlock("two words"), Unlock("1", newline="\r"), Unlock("☃")])
def test_refused_unlock_texts(unlock: Unlock) -> None:
    with pytest.raises(ev3proto.BuildError, match="serial number"):
        unlock.build()


def test_the_answer_of_the_brick() -> None:
    assert ACCEPT == b"Accept:EV340\r\n\r\n"


@pytest.mark.parametrize("port", ["555*", "", "0", "65536", "-1", " 5555", "\xb2", "9" * 5000])
def test_a_beacon_with_an_impossible_port(port: str) -> None:
    beacon = Beacon("001653", port)
    assert beacon.tcp_port is None
    assert Beacon.parse(beacon.build()) == beacon


@pytest.mark.parametrize("port", [1, 5555, 65535])
def test_the_port_of_a_beacon_as_a_number(port: int) -> None:
    assert Beacon("001653", str(port)).tcp_port == port


def test_a_beacon_has_the_characters_of_one_byte() -> None:
    assert b"Name: \xff\r\n" in Beacon("001653", name="\xff").build()
    with pytest.raises(ev3proto.BuildError, match="ISO-8859-1"):
        Beacon("001653", name="\u0100").build()

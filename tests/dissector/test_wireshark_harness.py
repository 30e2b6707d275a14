"""The harness runs a script in tshark, notices its errors, and leaves no files behind."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.wireshark import SETTING, Tshark

# A dissector with one field, which is the first byte.
SCRIPT = """
local toy = Proto("ev3toy", "Toy")
local first = ProtoField.uint8("ev3toy.first", "First", base.DEC)
toy.fields = { first }
function toy.dissector(tvb, pinfo, tree)
    pinfo.cols.protocol = "TOY"
    local item = tree:add(toy, tvb())
    item:add(first, tvb(0, 1))
end
DissectorTable.get("udp.port"):add(5555, toy)
DissectorTable.get("tcp.port"):add(5555, toy)
"""
BROKEN = {
    "arithmetic": "local missing; missing = missing + 1",
    "beyond the packet": "item:add(first, tvb(100, 1))",
    "in the length of a PDU": "dissect_tcp_pdus(tvb, tree, 2, function() return nil + 1 end, function() return 4 end)",
    "in a PDU": "dissect_tcp_pdus(tvb, tree, 2, function() return 4 end, function() return nil + 1 end)",
}


@pytest.fixture(scope="module")
def tshark() -> Iterator[Tshark]:
    with Tshark.from_setting(None) as tshark:
        yield tshark


@pytest.fixture
def toy(tshark: Tshark) -> Tshark:
    tshark.load(SCRIPT.encode())
    return tshark


def packets(path: Path, *words: str) -> Path:
    """A capture of two packets."""
    dump = "O 0000 2a 01 02 03\nI 0000 2b 04 05 06\n"
    subprocess.run(["text2pcap", "-q", "-D", *words, "-", str(path)], input=dump.encode(), check=True, timeout=60)
    return path


@pytest.fixture
def udp(tmp_path: Path) -> Path:
    return packets(tmp_path / "udp.pcap", "-u", "40000,5555")


@pytest.fixture
def tcp(tmp_path: Path) -> Path:
    return packets(tmp_path / "tcp.pcap", "-T", "40000,5555")


@pytest.mark.parametrize("fault", BROKEN)
def test_an_error_in_a_packet_is_noticed(toy: Tshark, tcp: Path, fault: str) -> None:
    toy.load(SCRIPT.replace("item:add(first, tvb(0, 1))", BROKEN[fault]).encode())
    for words in ((), ("-2",), ("-V",)) if fault == "arithmetic" else ((),):
        errors = toy.lua_errors(tcp, *words)
        for number in ("frame 1", "frame 2"):
            assert [error for error in errors if error.startswith(f"{number}: Lua Error: ")], words
    with pytest.raises(AssertionError, match=r"Lua Error|Dissector bug"):
        toy.run(tcp, "-V")


@pytest.mark.parametrize(
    "fault", ["local x = = 1", "error('on loading')", "function toy.init() error('at the start') end"]
)
def test_an_error_outside_of_packets_is_noticed(toy: Tshark, udp: Path, fault: str) -> None:
    toy.load((SCRIPT + fault).encode())
    assert len(toy.lua_errors(udp)) == 1
    with pytest.raises(AssertionError, match="Lua: "):
        toy.run(udp)


def test_no_tshark_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(SETTING, "/nowhere/tshark")
    with pytest.raises(AssertionError, match="there is no /nowhere/tshark"):
        Tshark.from_setting()

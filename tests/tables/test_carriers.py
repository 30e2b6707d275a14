"""A carrier is one entry in the tables; its reader, writer and dissector are found by the entry's name."""

from __future__ import annotations

import io
from importlib import import_module
from pathlib import Path

import pytest

from ev3proto import generate
from ev3proto.capture import Carrier, Record, read
from ev3proto.generate.captures import write_pcapng

RUNTIME = Path(generate.__file__).parent / "dissector" / "runtime"
TONE = bytes.fromhex("0e002a0080000094010182b80182e803")


@pytest.mark.parametrize("carrier", Carrier)
def test_what_is_written_is_read_as_the_same_carrier(carrier: Carrier) -> None:
    stream = io.BytesIO()
    write_pcapng([TONE], stream, carrier=carrier)
    stream.seek(0)
    (record,) = [event for event in read(stream).events() if isinstance(event, Record)]
    assert (record.carrier, record.interface) == (carrier, carrier.facts.interface)


@pytest.mark.parametrize("carrier", Carrier)
def test_every_carrier_has_its_parts(carrier: Carrier) -> None:
    """Both engines, the writer, and the dissector."""
    assert callable(import_module(f"ev3proto.capture.carriers.{carrier}").Reader)
    assert callable(import_module(f"ev3proto.generate.captures.{carrier}").Writer)
    assert (RUNTIME / f"{carrier}.lua").exists()


def test_a_packet_has_one_carrier() -> None:
    links = [link for carrier in Carrier for link in carrier.facts.links]
    assert len(links) == len(set(links))
    protocols = [protocol for carrier in Carrier for protocol in carrier.facts.protocols]
    assert len(protocols) == len(set(protocols))

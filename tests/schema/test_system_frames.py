"""System commands as functions, and files split into the commands that send them to the brick."""

from __future__ import annotations

import inspect
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.effort import effort

import ev3proto
from ev3proto import BuildError, Dialogue, SystemCommand, parse, system, system_reply
from ev3proto.tables.system import SYSTEM

pytestmark = pytest.mark.portable


def build(message: SystemCommand) -> str:
    """A frame in hex, without its header."""
    frame = message.build()
    return f"{frame[:5].hex()} {frame[5:].hex()}"


def test_a_listing() -> None:
    message = system.list_files("/home/root/lms2012/sys/", counter=42)
    # 1024 bytes minus header, command and status, size of the listing, handle: at most 1012 fit into a reply.
    path = b"/home/root/lms2012/sys/\0".hex()
    assert build(message) == "1e002a0001 " + "99" + "f403" + path
    assert build(system.list_files("a", max_bytes=100)) == "0800000001 9964006100"
    assert build(system.list_files("a", 100, reply=False)) == "0800000081 9964006100"


def test_default_values() -> None:
    """The most that a reply can carry, and a reply from every command that the brick answers."""
    assert build(system.begin_upload("a")) == "0800000001 94f4036100"
    assert build(system.continue_upload(1)) == "0700000001 9501f803"
    assert build(system.writemailbox("abc", b"x\0")) == "0d00000081 9e046162630002007800"
    assert build(system.enterfwupdate()) == "0400000081 a0"


def test_functions_of_the_bootloader() -> None:
    assert build(system.bootloader.begin_download(0x1000, 2)) == "0c00000001 f10010000002000000"
    assert build(system.bootloader.get_version()) == "0400000001 f6"
    assert system.bootloader.__all__ == [
        "begin_download",
        "begin_download_with_erase",
        "chip_erase",
        "download_data",
        "get_checksum",
        "get_version",
        "start_app",
    ]


def test_each_command_has_a_function() -> None:
    for entry in SYSTEM:
        function = getattr(system.bootloader if entry.bootloader else system, entry.name.lower())
        fields = set(inspect.signature(function).parameters) - {"counter", "reply"}
        assert fields == {field.name for field in entry.request}
        assert (inspect.getdoc(function) or "").startswith(entry.text)


def test_the_help_of_a_function() -> None:
    assert str(inspect.signature(system.list_files)).startswith(
        "(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool"
    )
    assert "name_length: Bytes of the name, with or without its zero; 0 to 255; computed from name when omitted." in (
        inspect.getdoc(system.writemailbox) or ""
    )


@pytest.mark.parametrize(
    ("name", "values", "named", "error", "sentence"),
    [
        ("list_files", (), {}, TypeError, "list_files() missing 1 required positional argument: 'path'"),
        ("list_files", (3,), {}, BuildError, "path takes a text, not 3"),
        ("list_files", ("a", 65536), {}, BuildError, "max_bytes cannot be 65536: it is a whole number from 0 to 65535"),
        ("list_files", ("a\0b",), {}, BuildError, "a text cannot contain a zero, which ends it"),
        ("list_files", ("a",), {"counter": -1}, BuildError, "counter cannot be -1"),
        ("setbundleid", ("a" * 24,), {}, BuildError, "id would have 25 bytes; the firmware takes at most 24"),
        ("writemailbox", ("a", bytes(1014)), {}, BuildError, "the brick accepts at most 1024 in one frame"),
        ("continue_download", (0, bytes(65_531)), {}, BuildError, "the brick accepts at most 65537 in one frame"),
        ("writemailbox", ("a", b"x"), {"payload_length": 2}, BuildError, "payload_length says 2 bytes, but 1 follow"),
    ],
)
def test_errors_of_functions(
    name: str, values: tuple[Any, ...], named: dict[str, Any], error: type[Exception], sentence: str
) -> None:
    with pytest.raises(error) as raised:
        getattr(system, name)(*values, **named)
    assert sentence in str(raised.value)


# Files


def test_a_file_in_pieces() -> None:
    data = bytes(range(256)) * 10
    found = list(system.download("../prjs/a.rsf", data, counter=65534))
    assert [message.counter for message in found] == [65534, 65535, 0, 1]
    assert found[0].build()[5:] == b"\x92" + (2560).to_bytes(4, "little") + b"../prjs/a.rsf\0"
    assert [len(message.build()) for message in found[1:]] == [1024, 1024, 533]
    assert b"".join(message.build()[7:] for message in found[1:]) == data
    assert {message.build()[6] for message in found[1:]} == {0}


def test_a_file_with_the_handle_of_the_brick() -> None:
    dialogue = Dialogue()
    begin = next(system.download("a", b"abcdef"))
    dialogue.follow(begin)
    reply = system_reply("BEGIN_DOWNLOAD", handle=7)
    handle = dialogue.feed(reply)[0].value
    assert isinstance(handle, int)
    exchanges = [dialogue.follow(message) for message in system.pieces(handle, b"abcdef", counter=1, piece=4)]
    transfer = exchanges[-1].transfer
    assert transfer is not None
    assert (transfer.path, transfer.transferred, transfer.is_complete) == ("a", 6, True)
    assert [exchange.message.build().hex() for exchange in exchanges] == [
        "09000100019307" + "61626364",
        "070002000193076566",
    ]


def test_an_empty_file() -> None:
    assert [message.command for message in system.download("a", b"")] == ["BEGIN_DOWNLOAD"]


@settings(max_examples=effort(40, 500))
@given(st.binary(max_size=3000), st.integers(1, 1017), st.integers(0, 255), st.booleans())
def test_any_file_in_pieces_of_any_size(data: bytes, piece: int, handle: int, reply: bool) -> None:
    begin, *rest = system.download("f", data, handle=handle, reply=reply, piece=piece)
    assert begin.fields["size"] == len(data)
    assert len(rest) == -(-len(data) // piece)
    parsed = [ev3proto.parse(message.build()) for message in rest]
    assert parsed == rest
    assert b"".join(message.build()[7:] for message in rest) == data
    assert {message.wants_reply for message in [begin, *rest]} == {reply}


@pytest.mark.parametrize(
    ("named", "sentence"),
    [
        ({"data": "text"}, "data takes bytes, not 'text'"),
        ({"piece": 0}, "piece cannot be 0: one CONTINUE_DOWNLOAD carries 1 to 1017 bytes"),
        ({"piece": 1018}, "piece cannot be 1018"),
        ({"handle": 256}, "handle cannot be 256: it is a whole number from 0 to 255"),
        ({"counter": 65536}, "counter cannot be 65536"),
        ({"path": "\u1234"}, "path cannot be"),
    ],
)
def test_invalid_pieces(named: dict[str, Any], sentence: str) -> None:
    with pytest.raises(BuildError) as raised:
        system.download(**{"path": "a", "data": b"abc", **named})
    assert sentence in str(raised.value)


def test_the_first_bytes_of_a_file_may_come_with_its_name() -> None:
    frame = "1d0001000192050000002e2e2f70726a732f712f612e7478740068656c6c6f"
    message = parse(bytes.fromhex(frame), expect=SystemCommand)
    assert message.fields == {"size": 5, "path": "../prjs/q/a.txt", "data": b"hello"}
    assert message.build().hex() == frame
    assert system.begin_download("../prjs/q/a.txt", 5, b"hello", counter=1) == message

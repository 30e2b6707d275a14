"""The dissector's statistics and exports at the end of a run of tshark, and the maximum cost of one packet."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from pathlib import Path

from support.cli import run_program
from support.messages import tone, voltage
from support.packets import HCI_WITH_DIRECTION, RAW_IP, Capture, Connection, SerialPort
from support.wireshark import DISSECTOR, Tshark

import ev3proto

CAPTURES = Path(__file__).parents[2] / "captures"


def test_statistics_at_the_end_of_a_run(tshark: Tshark) -> None:
    said = tshark.run(CAPTURES / "wifi.pcapng", "-q", *tshark.statistics, "-o", "ev3_statistics.print:TRUE")
    rows = {re.sub(r" +\d.*", "", line): line.split() for line in said.splitlines() if line}
    assert rows["CONTINUE_UPLOAD"][1:] == ["3", "3", "1861", "3", "4.50", "4.60"]
    assert rows["UI_READ.GET_VBATT"][1:] == ["4", "4", "97", "3", "4.30", "4.30"]
    assert rows["OUTPUT_START"][1:] == ["1", "1", "15", "0"]  # the second operation of its command
    assert rows["1:"][2:] == ["42", "5896", "18", "4.72", "8.80", "13"]
    assert rows["../prjs/log/first.rbf"][1:] == ["2500", "2500"]
    assert "Without a reply: 1 of 19 commands that requested one" in said


def test_statistics_fit_in_a_window(tshark: Tshark) -> None:
    """Wireshark's text window breaks lines after some 70 characters: columns are as wide as their contents."""
    said = tshark.run(
        CAPTURES / "wifi.pcapng", "-q", *tshark.statistics, "-o", "ev3_statistics.print:TRUE"
    ).splitlines()
    assert "Operation             uses messages bytes answers mean ms max ms" in said
    assert "CONTINUE_DOWNLOAD        3        3  2545       3    5.97   8.80" in said
    assert max(map(len, said)) <= 70


def test_a_brick_is_named_by_its_address_alone(tshark: Tshark) -> None:
    said = tshark.run(CAPTURES / "bluetooth.log", "-q", *tshark.statistics, "-o", "ev3_statistics.print:TRUE")
    assert re.search(r"^1: 00:16:53:00:00:0a +24 +2257 +10 ", said, re.MULTILINE)


def test_bytes_are_those_that_are_there(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(bytes.fromhex("0008 0100 00 0400 81 01 60"))  # the two bytes of the length are swapped
    connection.receive(bytes.fromhex("0300 0100 04"))
    path = tshark.place(capture.data(), "swapped.pcap")
    said = tshark.run(path, "-q", *tshark.statistics, "-o", "ev3_statistics.print:TRUE")
    assert re.search(r"^UI_READ.GET_VBATT +1 +1 +15 ", said, re.MULTILINE), said


def test_without_the_preference_nothing_is_printed(tshark: Tshark) -> None:
    assert tshark.run(CAPTURES / "wifi.pcapng", "-q", *tshark.statistics) == ""


def export_folder(tshark: Tshark, name: str) -> Path:
    """A folder that tshark may write to, also as another user."""
    folder = tshark.folder / name
    folder.mkdir()
    folder.chmod(0o777)
    return folder


def test_files_are_exported(tshark: Tshark) -> None:
    folder = export_folder(tshark, "files")
    words = ("-q", *tshark.statistics, "-o", f"ev3_statistics.export:{folder}")
    said = tshark.run(CAPTURES / "wifi.pcapng", *words)
    assert "first.rbf: 2500 bytes" in said
    assert sorted((path.name, path.stat().st_size) for path in folder.iterdir()) == [
        ("first.rbf", 2500),
        ("values.rtf", 2710),
    ]
    assert "first.rbf: exists already, not overwritten" in tshark.run(CAPTURES / "wifi.pcapng", *words)


def test_a_link_in_the_folder_is_not_followed(tshark: Tshark) -> None:
    folder, outside = export_folder(tshark, "linked"), export_folder(tshark, "outside")
    (folder / "first.rbf").symlink_to(Path("..") / outside.name / "first.rbf")
    said = tshark.run(CAPTURES / "wifi.pcapng", "-q", *tshark.statistics, "-o", f"ev3_statistics.export:{folder}")
    assert "first.rbf: exists already, not overwritten" in said
    assert list(outside.iterdir()) == []
    assert (folder / "values.rtf").stat().st_size == 2710


def test_what_cannot_be_exported_is_said_and_leaves_nothing(tshark: Tshark) -> None:
    """A missing folder, and a disk with room for 2,560 bytes per file: first.rbf fits, values.rtf does not."""
    capture = tshark.place(CAPTURES / "wifi.pcapng")
    missing = tshark.folder / "missing"
    said = tshark.run(capture, "-q", *tshark.statistics, "-o", f"ev3_statistics.export:{missing}")
    assert f"{missing}/values.rtf: not written: No such file or directory" in said.splitlines()

    folder = export_folder(tshark, "full")
    full_disk = ["sh", "-c", "trap '' XFSZ; ulimit -f 5; exec \"$@\"", "sh"]
    words = [*tshark.words, "-r", capture, "-q", *tshark.statistics, "-o", f"ev3_statistics.export:{folder}"]
    done = run_program(*full_disk, tshark.path, *words)
    assert f"{folder}/values.rtf: not written: File too large" in done.stdout.splitlines()
    assert f"{folder}/first.rbf: 2500 bytes" in done.stdout.splitlines()
    assert [path.name for path in folder.iterdir()] == ["first.rbf"]


def exported(tshark: Tshark, folder: Path, names: list[str]) -> list[str]:
    """The names under which a file of one byte is written into the folder, for each of these names."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for number, name in enumerate(names):
        sent = [
            ev3proto.system_command("BEGIN_DOWNLOAD", counter=2 * number, size=1, path=name),
            ev3proto.system_reply("BEGIN_DOWNLOAD", counter=2 * number, handle=number),
            ev3proto.system_command("CONTINUE_DOWNLOAD", counter=2 * number + 1, handle=number, data=b"x"),
        ]
        for message, say in zip(sent, (connection.send, connection.receive, connection.send), strict=True):
            say(message.build())
    tshark.run(
        tshark.place(capture.data(), "names.pcap"), "-q", *tshark.statistics, "-o", f"ev3_statistics.export:{folder}"
    )
    return sorted(path.name for path in folder.iterdir())


def moved(tshark: Tshark, messages: Iterable[tuple[bool, ev3proto.Message]], *words: str) -> list[str]:
    """The output at the end of a run for these messages, each with its direction."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for to_brick, message in messages:
        (connection.send if to_brick else connection.receive)(message.build())
    return tshark.run(tshark.place(capture.data(), "moved.pcap"), "-q", *tshark.statistics, *words).splitlines()


def download(
    counter: int, path: str, size: int, *pieces: bytes, handle: int = 0
) -> Iterable[tuple[bool, ev3proto.Message]]:
    """A file that goes to the brick, whose replies come before the next command."""
    yield True, ev3proto.system_command("BEGIN_DOWNLOAD", counter=counter, reply=True, size=size, path=path)
    yield False, ev3proto.system_reply("BEGIN_DOWNLOAD", counter=counter, handle=handle)
    for number, piece in enumerate(pieces, counter + 1):
        yield True, ev3proto.system_command("CONTINUE_DOWNLOAD", counter=number, reply=True, handle=handle, data=piece)


def test_a_file_of_another_size_than_was_said(tshark: Tshark) -> None:
    folder = export_folder(tshark, "sizes")
    messages = [*download(0, "short.rtf", 9, b"12345678"), *download(10, "long.rtf", 3, b"12", b"34")]
    assert moved(tshark, messages, "-o", f"ev3_statistics.export:{folder}") == [
        f"{folder}/short.rtf: 8 of 9 bytes, incomplete",
        f"{folder}/long.rtf: 4 bytes, announced as 3",
    ]


def test_a_file_whose_beginning_comes_with_its_name(tshark: Tshark) -> None:
    """Data after the name is the beginning of the file."""
    folder = export_folder(tshark, "beginning")
    begin = ev3proto.parse(bytes.fromhex("1d0001000192050000002e2e2f70726a732f712f612e7478740068656c6c6f"))
    assert moved(tshark, [(True, begin)], "-o", f"ev3_statistics.export:{folder}") == [f"{folder}/a.txt: 5 bytes"]
    assert (folder / "a.txt").read_bytes() == b"hello"


def test_a_complete_file_takes_no_more(tshark: Tshark) -> None:
    """If the reply to the next file's beginning is missing, its pieces have the handle of the file before."""
    folder = export_folder(tshark, "complete")
    second = [(True, message) for to_brick, message in download(10, "second.rtf", 2, b"cd") if to_brick]
    said = moved(tshark, [*download(0, "first.rtf", 2, b"ab"), *second], "-o", f"ev3_statistics.export:{folder}")
    assert said == [f"{folder}/first.rtf: 2 bytes"]
    assert (folder / "first.rtf").read_bytes() == b"ab"


def test_exported_files_stay_in_their_folder(tshark: Tshark) -> None:
    folder = export_folder(tshark, "named")
    before = {path.name for path in tshark.folder.iterdir()}
    names = ["../../a.rbf", "/etc/a.rbf", "..\\..\\b.rbf", "..", ".hidden", "con.txt", "x\x01\n|y", ""]
    written = exported(tshark, folder, names)
    assert {path.name for path in tshark.folder.iterdir()} == before | {"names.pcap"}
    assert written == ["2-_", "2-a.rbf", "_", "_con.txt", "_hidden", "a.rbf", "b.rbf", "x___y"]


def test_exported_files_have_names_that_windows_keeps(tshark: Tshark) -> None:
    """On Windows, a name is a device's also with blanks before its dot, and loses dots and blanks at its end."""
    names = ["AUX .txt", "com1  .a.b", "x" * 99 + ".", "y" * 98 + ". ."]
    written = exported(tshark, export_folder(tshark, "windows"), names)
    assert written == ["_AUX .txt", "_com1  .a.b", "x" * 99, "y" * 98]


def test_long_names_of_exported_files_keep_their_extension(tshark: Tshark) -> None:
    """100 bytes: the name is truncated before a short extension; a letter of two bytes becomes two underscores."""
    cut = ["n" * 120 + ".rbf", "n" * 121 + ".rbf", "m" * 80 + "é" * 20 + ".rtf", "l." + "e" * 120, ".h" + "i" * 120]
    written = exported(tshark, export_folder(tshark, "long"), cut)
    assert written == [
        "2-" + "n" * 96 + ".rbf",
        "_h" + "i" * 98,
        "l." + "e" * 98,
        "m" * 80 + "_" * 16 + ".rtf",
        "n" * 96 + ".rbf",
    ]


def test_the_info_column_is_bounded(tshark: Tshark) -> None:
    """One packet of many frames: as many as Wireshark shows."""
    capture = Capture(RAW_IP)
    Connection(capture).send(b"".join(tone(number) for number in range(4000)))
    path = tshark.place(capture.data(), "many.pcap")
    (said,) = tshark.run(path, "-T", "fields", "-e", "_ws.col.Info").splitlines()
    assert 4000 < len(said) < 4096


def answered_commands(tshark: Tshark, commands: Iterable[int], replies: Iterable[int]) -> list[str]:
    """Sends commands with these counters, then the replies; returns each reply's counter and its command's packet."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for counter in commands:
        connection.send(voltage(counter))
    for counter in replies:
        connection.receive(struct.pack("<HHBf", 7, counter, 0x02, 7.5))
    path = tshark.place(capture.data(), "waiting.pcap")
    words = ("-Y", "tcp.srcport == 5555", "-T", "fields", "-e", "ev3.msg_num", "-e", "ev3.request_in")
    return tshark.run(path, *words).splitlines()


def test_commands_that_wait_long_keep_those_before_them(tshark: Tshark) -> None:
    """Two with one counter, then 300 with others: the first reply belongs to the older one."""
    said = answered_commands(tshark, (5, 5, *range(1000, 1300)), (5, 1000, 5, 1299))
    assert said == ["5\t1", "1000\t3", "5\t2", "1299\t302"]


def test_pieces_of_frames_cost_little(tshark: Tshark) -> None:
    """A frame of 1000 bytes that comes byte by byte: each packet shows the first, the last one all of them."""
    capture = Capture(HCI_WITH_DIRECTION)
    port = SerialPort(capture)
    first = port.send(tone(1))
    frame = struct.pack("<HHBH", 998, 2, 0x80, 0) + b"\x01" * 993
    numbers = [port.send(frame[at : at + 1]) for at in range(len(frame))]
    path = tshark.place(capture.data(), "bytes.pcap")
    lines = tshark.run(path, "-Y", "ev3", "-T", "fields", "-e", "frame.number", "-e", "ev3.fragments").splitlines()
    assert lines[:3] == [f"{first}\t", f"{numbers[0]}\t", f"{numbers[1]}\t{numbers[0]}"]
    assert lines[-2] == f"{numbers[-2]}\t{numbers[0]}"
    assert lines[-1] == f"{numbers[-1]}\t" + ",".join(map(str, numbers[:-1]))


def test_the_main_chunk_has_room_for_locals(tmp_path: Path) -> None:
    """Lua allows 200 at once in a function, including the main chunk; at the end of a block, those around it count."""
    room = "local " + ", ".join(f"room_{number}" for number in range(20))
    script = tmp_path / "ev3.lua"
    script.write_text(
        re.sub(r"^(do\n.*?)^end$", rf"\1{room}\nend", DISSECTOR.read_text(), flags=re.MULTILINE | re.DOTALL) + room
    )
    with Tshark.from_setting(script) as tshark:
        assert tshark.lua_errors(tshark.place(CAPTURES / "daisy.pcap")) == []

"""The layer for scapy: it dissects and builds like the codec, byte for byte, and finds frames in streams."""

from __future__ import annotations

import socket
import subprocess
import sys
import threading
from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from scapy.config import conf
from scapy.layers.bluetooth import HCI_ACL_Hdr, HCI_Hdr, L2CAP_Hdr
from scapy.layers.inet import IP, TCP
from scapy.packet import Packet, Padding, Raw, fuzz
from scapy.sendrecv import sniff
from scapy.sessions import TCPSession
from scapy.supersocket import StreamSocket
from scapy.utils import rdpcap
from support.effort import effort
from support.frames import drawn

import ev3proto
from ev3proto import GV, LC2, LV, BuildError, direct_command, operation, parse
from ev3proto import scapy as ev3
from ev3proto.extras import install_command
from ev3proto.messages import DaisyCommand, DirectCommand, SystemCommand, SystemReply
from ev3proto.sampling import samples
from ev3proto.scapy import (
    EV3,
    RFCOMM,
    EV3DaisyCommand,
    EV3DaisyReply,
    EV3DirectCommand,
    EV3DirectReply,
    EV3SensorReport,
    EV3Session,
    EV3SystemCommand,
    EV3SystemReply,
    EV3Text,
)
from ev3proto.scapy.system import RENAMED
from ev3proto.schema.names import HND
from ev3proto.tables import operations as operations_of
from ev3proto.tables.discovery import ACCEPT
from ev3proto.testing import frames, mutated_frames

ROOT = Path(__file__).parents[2]
TONE = bytes.fromhex("0e002a0080000094010182b80182e803")


@pytest.fixture(autouse=True)
def _strict() -> Any:
    """Raises errors of dissection instead of hiding them."""
    conf.debug_dissector = True
    yield
    conf.debug_dissector = False
    conf.contribs["ev3"]["dialect"] = "official"


def test_a_frame_is_built() -> None:
    tone = ev3.SOUND_TONE(VOLUME=1, FREQUENCY=440, DURATION=1000)
    assert bytes(EV3(counter=42) / EV3DirectCommand(operations=[tone])) == TONE


def test_an_operation_by_itself_is_put_into_a_command() -> None:
    tone = ev3.SOUND_TONE(VOLUME=1, FREQUENCY=440, DURATION=1000)
    assert bytes(EV3(counter=42) / tone) == TONE
    assert bytes(IP() / TCP() / EV3(counter=42) / tone)[40:] == TONE
    wanted = bytes.fromhex("0b000100000400810160821b02")
    light = ev3.UI_WRITE_LED(PATTERN="LED_RED")
    assert bytes(EV3(counter=1) / ev3.UI_READ_GET_VBATT() / light) == wanted
    assert bytes(EV3(counter=1) / (ev3.UI_READ_GET_VBATT() / light)) == wanted
    assert bytes(EV3(counter=1, type=0x80) / ev3.UI_READ_GET_VBATT()).hex() == "08000100800400810160"
    assert bytes(EV3(counter=1) / EV3DirectCommand(local_size=4) / light).hex() == "08000100800010821b02"


def test_the_star_import_has_all_that_the_command_of_a_packet_names() -> None:
    names: dict[str, Any] = {}
    exec("from ev3proto.scapy import *", names)
    for frame in islice(samples(frames(), seed=1), effort(300, 3000)):
        text = EV3(frame).command()
        assert bytes(eval(text, dict(names))) == frame, text


def test_the_fields_of_a_system_message_get_their_number() -> None:
    listing = ev3.SYS_LIST_FILES(path="/", max_bytes=100)
    assert bytes(EV3() / listing).hex() == "08000000019964002f00"
    assert parse(bytes(EV3(counter=7) / ev3.SYS_LIST_FILES_REPLY(list_size=3, list="a/"))) == (
        ev3proto.system_reply("LIST_FILES", counter=7, list_size=3, handle=0, list="a/")
    )
    assert bytes(EV3() / ev3.SYS_BOOTLOADER_GET_VERSION()).hex() == "0400000001f6"


def test_layers_are_found_and_shown_in_what_is_put_together() -> None:
    packet = EV3() / ev3.SOUND_TONE(VOLUME=1, FREQUENCY=440, DURATION=1000)
    assert packet.haslayer(ev3.SOUND_TONE)
    assert not packet.haslayer(ev3.UI_WRITE_LED)
    assert packet[ev3.SOUND_TONE].FREQUENCY == 440
    shown = packet.show2(dump=True)
    assert shown is not None
    assert "FREQUENCY = 440 Hz" in shown
    assert "length    = 14" in shown


def test_what_is_put_together_can_be_fuzzed() -> None:
    fuzzed = fuzz(EV3(type=0x80) / ev3.SOUND_TONE())
    frames = {bytes(fuzzed) for _ in range(20)}
    assert len(frames) > 10
    assert all(len(frame) == int.from_bytes(frame[:2], "little") + 2 for frame in frames)


def test_a_frame_is_dissected() -> None:
    packet = EV3(TONE)
    assert (packet.length, packet.counter, packet.type) == (14, 42, 0x80)
    (tone,) = packet[EV3DirectCommand].operations
    assert (tone.name, tone.opcode, tone.CMD) == ("SOUND.TONE", 0x94, 1)
    assert (tone.VOLUME, tone.FREQUENCY, tone.DURATION) == (1, 440, 1000)
    assert bytes(packet) == TONE


def test_what_is_shown() -> None:
    shown = EV3(TONE).show(dump=True)
    assert shown is not None
    assert [line.strip() for line in shown.splitlines()] == [
        "###[ EV3 ]###",
        "length    = 14",
        "counter   = 42",
        "type      = DIRECT_COMMAND_NO_REPLY",
        "###[ EV3 direct command ]###",
        "local_size= 0",
        "global_size= 0",
        "\\operations\\",
        "|###[ SOUND.TONE ]###",
        "|  opcode    = SOUND",
        "|  CMD       = TONE (1)",
        "|  VOLUME    = 1 %",
        "|  FREQUENCY = 440 Hz",
        "|  DURATION  = 1000 ms",
    ]


def test_a_dissected_field_can_be_changed() -> None:
    packet = EV3(TONE)
    packet[EV3DirectCommand].operations[0].FREQUENCY = 20
    packet.length = None
    assert bytes(packet) == direct_command(operation("SOUND.TONE", 1, 20, 1000), counter=42).build()


def test_arguments_in_every_form() -> None:
    def built(**values: Any) -> bytes:
        return bytes(ev3.SOUND_TONE(**values))

    assert built(VOLUME=LV(4), FREQUENCY=GV(40)) == bytes.fromhex("940144e12800")
    assert built(VOLUME=LC2(1), FREQUENCY=HND(bytes.fromhex("e128"))) == bytes.fromhex("9401820100f12800")
    assert bytes(ev3.UI_WRITE_LED(PATTERN="LED_RED_FLASH")) == bytes.fromhex("821b05")
    assert bytes(ev3.COM_SET_SET_BRICKNAME(NAME="myEV3")) == bytes.fromhex("d408846d7945563300")
    assert bytes(ev3.INPUT_DEVICE_READY_SI(NO=2, MODE=1, VALUES=[GV(0), GV(4)])) == bytes.fromhex("991d00020001026064")
    assert bytes(ev3.MAILBOX_WRITE(BRICKNAME="b", HARDWARE="HW_BT", BOXNAME="m", TYPE="DATA_F", VALUES=[1.5])) == (
        operation("MAILBOX_WRITE", "b", "HW_BT", "m", "DATA_F", [1.5]).raw
    )
    assert (
        bytes(ev3.INIT_BYTES(DESTINATION=LV(0), SOURCE=[1, 2, 3])) == operation("INIT_BYTES", LV(0), 3, [1, 2, 3]).raw
    )


def test_the_shortest_encoding_is_a_value_and_others_are_bytes() -> None:
    tone = ev3.SOUND_TONE(bytes.fromhex("94 8101 820100 44 8001 00".replace(" ", "")))
    assert (b"\x81\x01", b"\x82\x01\x00", LV(4)) == (tone.CMD, tone.VOLUME, tone.FREQUENCY)
    assert "CMD       = LC1(1)" in str(tone.show(dump=True))
    assert "VOLUME    = LC2(1)" in str(tone.show(dump=True))
    assert "FREQUENCY = LV(4)" in str(tone.show(dump=True))


def test_mistakes_are_found_at_the_call() -> None:
    with pytest.raises(
        BuildError, match="VOLUME cannot be 1000: use 0 to 100 %; a DATA8 is a whole number from -127 to 127"
    ):
        ev3.SOUND_TONE(VOLUME=1000)
    with pytest.raises(
        BuildError, match="PATTERN takes a name of LEDPATTERN or a number or a variable, not 'LED_BLUE'"
    ):
        ev3.UI_WRITE_LED(PATTERN="LED_BLUE")
    with pytest.raises(
        AttributeError, match=r"SOUND\.TONE has no parameter VOLUMEN: it has CMD, VOLUME, FREQUENCY, DURAT"
    ):
        ev3.SOUND_TONE(VOLUMEN=1)
    with pytest.raises(AttributeError, match="unknown layer SOUND_TOEN: did you mean SOUND_TONE"):
        ev3.SOUND_TOEN  # noqa: B018
    with pytest.raises(BuildError, match="global_size cannot be 1024: a header can request 0 to 1023 bytes"):
        EV3DirectCommand(global_size=1024)
    with pytest.raises(BuildError, match="the frame would have 1025 bytes; the brick accepts at most 1024"):
        bytes(EV3() / EV3DirectReply(memory=bytes(1020)))


def test_any_frame_is_built_again() -> None:
    for frame in drawn(frames(), effort(200, 2000)):
        packet = EV3(frame)
        assert bytes(packet) == frame
        # And from its fields alone, without the bytes that scapy keeps.
        assert bytes(rebuilt(packet)) == frame


def rebuilt(packet: Packet) -> Packet:
    """A packet made from the values of another packet's fields."""
    values: dict[str, Any] = {
        name: [rebuilt(one) if isinstance(one, Packet) else one for one in value] if isinstance(value, list) else value
        for name, value in packet.fields.items()
    }
    own: Packet = type(packet)(**values)
    return own / rebuilt(packet.payload) if packet.payload else own


def test_any_frame_says_what_the_codec_says() -> None:
    for frame in drawn(frames(), effort(150, 1000)):
        message, packet = parse(frame), EV3(frame)
        assert message.type is not None
        assert (packet.type, packet.counter) == (message.type.value, message.counter)
        if isinstance(message, DirectCommand):
            body = packet[EV3DirectCommand]
            assert (body.global_size, body.local_size) == (message.global_size, message.local_size)
            assert [one.name for one in body.operations] == [one.full_name for one in message.operations]
            assert [bytes(one) for one in body.operations] == [one.raw for one in message.operations]
        elif isinstance(message, DaisyCommand) and message.operations:
            assert [one.name for one in packet.operations] == [one.full_name for one in message.operations]
        elif isinstance(message, SystemCommand | SystemReply):
            body = packet.payload
            assert body.number == message.number
            told = body.payload
            if not isinstance(told, Raw):
                for name, value in message.fields.items():
                    # What ends before its first field has no packet for them.
                    found = told.getfieldval(RENAMED.get(name, name)) if told else type(value)()
                    assert found == value
        if packet.haslayer(Raw):
            below = packet[Raw].underlayer
            is_failed_reply = isinstance(message, SystemReply) and (message.status_code or message.is_error)
            assert is_failed_reply or isinstance(below, EV3DaisyCommand | EV3DaisyReply)


def test_faulty_frames_keep_their_bytes() -> None:
    conf.debug_dissector = False
    for frame in drawn(mutated_frames(), effort(150, 1000)):
        if len(frame) >= 5:
            assert bytes(EV3(frame)) == frame


@pytest.mark.parametrize("dialect", ["official", "xtended", "compat"])
def test_every_operation_has_a_layer(dialect: str) -> None:
    conf.contribs["ev3"]["dialect"] = dialect
    for name, declaration in operations_of(dialect).items():
        layer = getattr(ev3, name.replace(".", "_"))
        assert layer.__doc__ == declaration.text
        names = {field.name for field in layer.fields_desc}
        assert names >= {parameter.name for parameter in declaration.parameters}
        assert not [one for one in names if hasattr(Packet, one)]
        built = bytes(layer())
        assert (
            bytes(EV3(bytes(EV3() / EV3DirectCommand(operations=[layer()])))[EV3DirectCommand].operations[0]) == built
        )
        assert direct_command(*parse_operations(built, dialect)).build()[7:] == built


def parse_operations(raw: bytes, dialect: str) -> tuple[ev3proto.Operation, ...]:
    frame = (len(raw) + 5).to_bytes(2, "little") + bytes((0, 0, 0x80, 0, 0)) + raw
    message = parse(frame, dialect=dialect, expect=DirectCommand)
    return message.operations


def test_the_dialect_is_a_setting() -> None:
    frame = bytes(EV3() / EV3DirectCommand(operations=[ev3.MAILBOX_SIZE()]))
    assert isinstance(EV3(frame)[EV3DirectCommand].payload, Raw)
    conf.contribs["ev3"]["dialect"] = "xtended"
    assert EV3(frame)[EV3DirectCommand].operations[0].name == "MAILBOX_SIZE"


def test_system_messages() -> None:
    packet = EV3(counter=7) / EV3SystemCommand() / ev3.SYS_LIST_FILES(max_bytes=1000, path="/home/root/lms2012/sys/")
    told = ev3proto.system_command("LIST_FILES", counter=7, max_bytes=1000, path="/home/root/lms2012/sys/")
    assert bytes(packet) == told.build()
    mail = EV3() / EV3SystemCommand() / ev3.SYS_WRITEMAILBOX(mailbox="abc", message=b"hello\0")
    assert bytes(mail) == ev3proto.system_command("WRITEMAILBOX", name="abc", payload=b"hello\0").build()
    reply = EV3(
        bytes(EV3() / EV3SystemReply(status="END_OF_FILE") / ev3.SYS_CONTINUE_UPLOAD_REPLY(handle=3, data=b"x"))
    )
    assert parse(bytes(reply)) == ev3proto.system_reply("CONTINUE_UPLOAD", status=8, handle=3, data=b"x")
    assert bytes(ev3.SYS_BOOTLOADER_BEGIN_DOWNLOAD(address=1, image_size=2)) == bytes.fromhex("0100000002000000")
    failed = EV3(ev3proto.system_reply("LIST_FILES", status=6).build())
    assert (failed[EV3SystemReply].status, failed.lastlayer().name) == (6, "EV3 system reply")


def test_daisy_messages() -> None:
    stop = EV3() / EV3DaisyCommand(operations=[ev3.OUTPUT_STOP(NOS=15)])
    assert bytes(stop) == bytes.fromhex("0a0000000aa00001a3000f00")
    report = EV3(bytes(EV3() / EV3DaisyReply() / EV3SensorReport(layer=1, port=2, data=b"\x01", busy=b"\x02")))
    message = parse(bytes(report), expect=ev3proto.DaisyReply)
    assert message.report == ev3proto.SensorReport(1, 2, 0, 0, 0, b"\x01".ljust(32, b"\0"), 0, b"\x02")


def test_types_follow_from_bodies() -> None:
    bodies = (
        EV3DirectCommand(),
        EV3DirectReply(),
        EV3SystemCommand(),
        EV3SystemReply(),
        EV3DaisyCommand(),
        EV3DaisyReply(),
    )
    assert [(EV3() / body).type for body in bodies] == [0x80, 0x02, 0x01, 0x03, 0x0A, 0x08]
    assert (EV3(type="DIRECT_COMMAND_REPLY") / EV3DirectCommand()).type == 0


def test_what_answers_what() -> None:
    asked = EV3(counter=9, type="DIRECT_COMMAND_REPLY") / EV3DirectCommand()
    told = EV3(counter=9) / EV3DirectCommand()
    reply = EV3(counter=9) / EV3DirectReply()
    assert reply.answers(asked)
    assert reply.hashret() == asked.hashret()
    assert not reply.answers(told)
    assert not asked.answers(reply)
    assert not (EV3(counter=8) / EV3DirectReply()).answers(asked)
    listed = EV3() / EV3SystemCommand() / ev3.SYS_LIST_FILES()
    assert (EV3() / EV3SystemReply(number="LIST_FILES")).answers(listed)
    assert not (EV3() / EV3SystemReply(number="BEGIN_UPLOAD")).answers(listed)


def test_several_frames_in_one_piece() -> None:
    packet = EV3(TONE + TONE)
    assert bytes(packet[EV3]) == TONE + TONE
    assert packet[Padding].load == TONE
    assert len(packet[EV3DirectCommand].operations) == 1


def test_a_stream_in_pieces() -> None:
    assert EV3.tcp_reassemble(b"", {}, {}) is None
    assert EV3.tcp_reassemble(TONE[:1], {}, {}) is None
    assert EV3.tcp_reassemble(TONE[:15], {}, {}) is None
    whole = EV3.tcp_reassemble(TONE + TONE[:3], {}, {})
    assert whole is not None
    assert (whole.counter, whole[Padding].load) == (42, TONE[:3])
    unlock = ev3proto.Unlock("06165300000a").build()
    assert EV3.tcp_reassemble(unlock[:20], {}, {}) is None
    text = EV3.tcp_reassemble(unlock + TONE, {}, {})
    assert text is not None
    assert (text[EV3Text].text, text[Padding].load) == (unlock, TONE)
    accepted = EV3.tcp_reassemble(ACCEPT + b"\0", {}, {})
    assert accepted is not None
    assert accepted[EV3Text].text == ACCEPT + b"\0"
    # The first speaker on a stream may use another protocol.
    assert isinstance(EV3.tcp_reassemble(b"\xff\xff\xff\xff\xff", {}, {}), Raw)
    assert isinstance(EV3.tcp_reassemble(b"GET /target?sn=" + bytes(200), {}, {}), Raw)


def test_the_repository_s_capture() -> None:
    found = list(sniff(offline=str(ROOT / "captures" / "wifi.pcapng"), session=TCPSession, quiet=True))
    assert frames_in(found) == frames_of("wifi.pcapng")
    assert sum(packet.haslayer(EV3Text) for packet in found) == 4


def frames_in(packets: Any) -> list[bytes]:
    """Returns the frames that are layers of packets."""
    found: list[bytes] = []
    for packet in packets:
        layer = packet.getlayer(EV3)
        while layer is not None:
            found.append(bytes(layer)[: layer.length + 2])
            layer = layer.payload.getlayer(EV3)
    return found


def frames_of(capture: str) -> list[bytes]:
    records = ev3proto.capture.read(ROOT / "captures" / capture).events()
    return [event.frame for event in records if isinstance(event, ev3proto.capture.Record)]


USB_CAPTURES = ["usb.pcapng", "usb-plugged.pcap", "usb-windows.pcap", "usb-bootloader.pcapng", "daisy.pcap"]


@pytest.mark.parametrize("capture", USB_CAPTURES)
def test_usb_is_read_without_a_session(capture: str) -> None:
    assert frames_in(rdpcap(str(ROOT / "captures" / capture))) == frames_of(capture)


@pytest.mark.parametrize("capture", ["bluetooth.pcapng", "usb.pcapng", "wifi.pcapng"])
def test_one_session_reads_all_carriers(capture: str) -> None:
    found = sniff(offline=str(ROOT / "captures" / capture), session=EV3Session, quiet=True)
    assert frames_in(found) == frames_of(capture)


def test_a_serial_port_s_packets_are_layers() -> None:
    found = sniff(offline=str(ROOT / "captures" / "bluetooth.pcapng"), session=EV3Session, quiet=True)
    asked = next(packet for packet in found if ev3.UI_READ_GET_VBATT in packet)
    assert asked.summary().endswith("HCI_ACL_Hdr / L2CAP_Hdr / RFCOMM / EV3 / EV3DirectCommand")
    assert (asked[RFCOMM].channel, asked[EV3].counter) == (1, 300)


def test_without_the_session_whole_frames_of_a_serial_port_are_read() -> None:
    found = rdpcap(str(ROOT / "captures" / "bluetooth.pcapng"))
    asked = next(packet for packet in found if ev3.UI_READ_GET_VBATT in packet)
    assert asked[Padding].load == b"\x9a"  # RFCOMM's checksum
    assert bytes(asked).hex().endswith("0b0012000e0051000bef1508002c010004008101609a")
    assert 0 < len(frames_in(found)) < len(frames_of("bluetooth.pcapng"))


def test_pieces_of_a_serial_port_without_a_frame_are_passed_on() -> None:
    session = EV3Session()
    hello = b"hello, brick"
    serial = bytes((0x0B, 0xEF, len(hello) << 1 | 1)) + hello + b"\x9a"
    packet = HCI_Hdr(bytes(HCI_Hdr() / HCI_ACL_Hdr(connection_handle=11) / L2CAP_Hdr(cid=0x51) / Raw(serial)))
    passed = session.process(packet)
    assert passed is not None
    assert (passed[RFCOMM].channel, passed[Raw].load) == (1, hello)


def test_tcp_is_bound() -> None:
    packet = IP(bytes(IP() / TCP() / EV3(TONE)))
    assert packet[TCP].dport == 5555
    assert packet[EV3].counter == 42
    back = IP(bytes(IP() / TCP(sport=5555, dport=49152) / EV3() / EV3DirectReply(memory=b"\x01")))
    assert back[EV3DirectReply].memory == b"\x01"


def test_a_conversation_over_a_socket() -> None:
    host, brick = socket.socketpair()

    def answer() -> None:
        end = StreamSocket(brick, EV3)  # which closes the socket when it is no longer referenced
        asked = end.recv()
        assert asked is not None
        end.send(EV3(counter=asked.counter) / EV3DirectReply(memory=bytes.fromhex("a470fd40")))
        end.close()

    thread = threading.Thread(target=answer)
    thread.start()
    asked = EV3(counter=5, type="DIRECT_COMMAND_REPLY") / EV3DirectCommand(
        global_size=4, operations=[ev3.UI_READ_GET_VBATT(VALUE=GV(0))]
    )
    end = StreamSocket(host, EV3)
    reply = end.sr1(asked, timeout=60, verbose=False)
    thread.join()
    end.close()
    assert reply is not None
    assert reply[EV3DirectReply].memory == bytes.fromhex("a470fd40")


def test_without_scapy_it_says_what_to_install() -> None:
    program = "import sys; sys.modules['scapy'] = None; import ev3proto.scapy"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert f"scapy, which is not installed: {install_command('scapy')}" in done.stderr

"""What a log names beside the direction of its frames: the brick, the port, a thread."""

from __future__ import annotations

from support.cases import each

from ev3proto.text.paste import read_text

HEX = "06 00 2a 00 00 00 00 01"
LABELS = {
    "10:00:00.1 [A] Sent 0x|{lesson}|": "A",
    "INFO leader: >> {hex}": "leader",
    "B recv {hex}": "B",
    "brick 2: sent {hex}": "brick 2",
    "sent to /dev/rfcomm0: {hex}": "/dev/rfcomm0",
    "2026-11-25 22:10:01,123 - robot.leader - DEBUG - sent {hex}": "robot.leader",
    "11-25 22:10:01.123  1234  1250 D Follower: send {hex}": "Follower",
    "D/Follower( 1234): send {hex}": "Follower",
    "COM3 -> PC {hex}": "COM3 PC",
    "PC <- COM3: {hex}": "COM3 PC",
    "00:16:53:42:2B:99 sent {hex}": "00:16:53:42:2B:99",
    "10.0.0.2:5555 rx {hex}": "10.0.0.2:5555",
    "DEBUG:root:[17] send: {hex}": "root",
    'write(3, "{escaped}", 8)': "3",
    "Sent 0x|{lesson}|": None,
    "leader {hex}": None,
    "received <Buffer {hex}>": None,
    "then I tried the other robot and it was sent {hex}": None,
}


@each("line, label", LABELS.items())
def test_a_label_beside_the_direction(line: str, label: str | None) -> None:
    text = line.format(hex=HEX, lesson="06:00|2A:00|00|00:00|01", escaped=r"\6\0*\0\0\0\0\1")
    (piece,) = read_text([text])
    assert (piece.data, piece.label) == (bytes.fromhex(HEX), label)


def test_a_label_in_the_line_above() -> None:
    (piece,) = read_text(["10:00:01.5 leader sending:\n", f"{HEX}\n"])
    assert (piece.direction, piece.time, piece.label) == ("sent", "10:00:01.5", "leader")

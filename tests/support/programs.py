"""The program that the tests of images and sources share: its source, and the expected bytes."""

from __future__ import annotations

SOURCE = r"""// blink twice, then say so
define TIMES  2
define WAIT   (250 * TIMES)
DATA8  count
DATAF  level
vmthread MAIN
{
  DATA32 timer
  DATAS  text 6
  MOVE8_8(0, count)
again:
  UI_WRITE(LED, LED_RED)
  TIMER_WAIT(WAIT, timer)
  TIMER_READY(timer)
  ADD8(count, 1, count)
  JR_LT8(count, TIMES, again)
  CALL(Say, 'done\q', level)
  STRINGS(DUPLICATE, 'x', text)
}
subcall Say
{
  IN_S  what 8
  OUT_F answer
  DATA8 pad
  DATA16 row
  MOVE16_16(-128, row)
  MOVEF_F(0.0F, answer)
  UI_DRAW(TEXT, FG_COLOR, 4, row, what)
}
"""

IMAGE = bytes.fromhex(
    "4C45474F 65000000 6D00 0200 08000000"
    + "28000000 0000 0000 0A000000"
    + "51000000 0000 0100 10000000"
    + "300060 821B02 8582F40140 8640 10600160"
    + "64600282ECFF"
    + "0902028064 6F6E65270064 7D0580780044 0A"
    + "02840843 358280FF4E 3F0048"
    + "84050104 4E40 080A"
)
"""The image of LEGO's assembler, with the version of release 1.09."""

SHORTEST = bytes.fromhex(
    "4C45474F 67000000 6D00 0200 08000000"
    + "28000000 0000 0000 0A000000"
    + "4F000000 0000 0100 10000000"
    + "300060 821B02 8582F40140 8640 10600160"
    + "6460022E"
    + "0902028064 6F6E65270064 7D0580780044 0A"
    + "02840843 358280FF4E 3F830000000048"
    + "840501044E40 080A"
)
"""The image by the rules of EV3-G."""


def image_of(*objects: tuple[int, int, str | None], global_size: int = 0, local_size: int = 0) -> bytes:
    """An image of objects by owner, triggers and code in hex; without code, it shares that of the object before it."""
    at = 16 + 12 * len(objects)
    table = codes = b""
    start = at
    for owner, triggers, code in objects:
        if code is not None:
            start = at + len(codes)
            codes += bytes.fromhex(code)
        table += start.to_bytes(4, "little") + owner.to_bytes(2, "little") + triggers.to_bytes(2, "little")
        table += local_size.to_bytes(4, "little")
    size = at + len(codes)
    head = b"LEGO" + size.to_bytes(4, "little") + b"\x6d\x00" + len(objects).to_bytes(2, "little")
    return head + global_size.to_bytes(4, "little") + table + codes

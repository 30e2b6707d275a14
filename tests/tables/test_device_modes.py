"""The sensors and motors of LEGO, as their firmware describes them."""

from __future__ import annotations

import pytest

from ev3proto.tables.devices import DEVICE_TYPES, Mode, Range

pytestmark = pytest.mark.portable

MODES = """
1 NXT-TOUCH 1 16-bit 1.0 2000..1000 0..1 -
1 NXT-BUMPS 1 32-bit 5.0 0..100 0..100 cnt
2 NXT-REFLECT 1 16-bit 3.0 3372..445 0..100 pct
2 NXT-AMBIENT 1 16-bit 3.0 3411..633 0..100 pct
3 NXT-SND-DB 1 16-bit 3.0 4095..0 0..100 pct
3 NXT-SND-DBA 1 16-bit 3.0 4095..0 0..100 pct
4 NXT-COL-REF 1 32-bit 5.0 200..1500 0..100 pct
4 NXT-COL-AMB 1 32-bit 5.0 200..2900 0..100 pct
4 NXT-COL-COL 1 8-bit 2.0 0..8 0..8 col
4 NXT-COL-GRN 1 32-bit 5.0 200..1500 0..100 pct
4 NXT-COL-BLU 1 32-bit 5.0 200..1500 0..100 pct
5 NXT-US-CM 1 16-bit 5.0 0..255 0..255 cm
5 NXT-US-IN 1 16-bit 5.0 0..255 0..100 inch
6 NXT-TEMP-C 1 16-bit 5.1 -14080..32767 -55..128 c
6 NXT-TEMP-F 1 16-bit 5.1 -14080..32767 -67..262.4 f
7 L-MOTOR-DEG 1 32-bit 4.0 -180..180 -180..180 deg
7 L-MOTOR-ROT 1 32-bit 4.0 -36000..36000 -100..100 rot
7 L-MOTOR-SPD 1 8-bit 3.0 -100..100 -100..100 pct
8 M-MOTOR-DEG 1 32-bit 4.0 -180..180 -180..180 deg
8 M-MOTOR-ROT 1 32-bit 4.0 -36000..36000 -100..100 rot
8 M-MOTOR-SPD 1 8-bit 3.0 -100..100 -100..100 pct
16 TOUCH 1 16-bit 1.0 1000..2000 0..1 -
16 BUMPS 1 32-bit 5.0 0..1 0..1 cnt
29 COL-REFLECT 1 8-bit 3.0 0..100 0..100 pct
29 COL-AMBIENT 1 8-bit 3.0 0..100 0..100 pct
29 COL-COLOR 1 8-bit 2.0 0..8 0..8 col
29 REF-RAW 2 16-bit 4.0 0..1020.2 0..1020.2 -
29 RGB-RAW 3 16-bit 4.0 0..1020.2 0..1020.2 -
29 COL-CAL 4 16-bit 5.0 0..65535 0..65535 -
30 US-DIST-CM 1 16-bit 5.1 0..2550 0..255 cm
30 US-DIST-IN 1 16-bit 5.1 0..1000 0..100 inch
30 US-LISTEN 1 8-bit 1.0 0..1 0..1 -
30 US-SI-CM 1 16-bit 5.1 0..2550 0..255 cm
30 US-SI-IN 1 16-bit 5.1 0..1000 0..100 inch
30 US-DC-CM 1 16-bit 5.1 0..2550 0..255 cm
30 US-DC-IN 1 16-bit 5.1 0..1000 0..100 inch
32 GYRO-ANG 1 16-bit 4.0 -180..180 -180..180 deg
32 GYRO-RATE 1 16-bit 3.0 -440..440 -440..440 d/s
32 GYRO-FAS 1 16-bit 4.0 -2000..2000 -2000..2000 -
32 GYRO-G&A 2 16-bit 5.0 -180..180 -180..180 -
32 GYRO-CAL 4 16-bit 5.0 0..65535 0..65535 -
33 IR-PROX 1 8-bit 3.0 0..100 0..100 pct
33 IR-SEEK 8 8-bit 3.0 -100..100 -100..100 pct
33 IR-REMOTE 4 8-bit 3.0 0..10 0..10 btn
33 IR-REM-A 1 16-bit 6.0 0..65535 0..65535 -
33 IR-S-ALT 4 8-bit 3.0 0..100 0..100 pct
33 IR-CAL 2 16-bit 5.0 0..65535 0..65535 -
99 ES-IN-VOLT 1 16-bit 4.1 0..10000 0..10 V
99 ES-IN-AMP 1 16-bit 5.3 0..10000 0..10 A
99 ES-OUT-VOLT 1 16-bit 4.1 0..10000 0..10 V
99 ES-OUT-AMP 1 16-bit 5.3 0..10000 0..10 A
99 ES-JOULE 1 16-bit 3.0 0..100 0..100 J
99 ES-IN-WATT 1 16-bit 5.3 0..10000 0..10 W
99 ES-OUT-WATT 1 16-bit 5.3 0..10000 0..10 W
"""
"""Type, mode, values of a reading, format, figures and decimals, raw values, values in the unit, unit."""


def _ends(range_: Range) -> str:
    return f"{range_.least:g}..{range_.most:g}"


def _described(mode: Mode) -> str:
    """A mode, written like a line of the table."""
    size = ("8-bit", "16-bit", "32-bit", "float")[mode.format]
    ends = f"{_ends(mode.raw)} {_ends(mode.si)}"
    return f"{mode.name} {mode.datasets} {size} {mode.figures}.{mode.decimals} {ends} {mode.symbol or '-'}"


def test_each_type_has_a_title() -> None:
    titles = {device.number: device.title for device in DEVICE_TYPES.values()}
    assert len(set(titles.values())) == len(titles) == 37
    assert (titles[10], titles[21], titles[33]) == ("unused type 10", "EV3 test device", "EV3 infrared sensor")
    sold = [number for number, device in DEVICE_TYPES.items() if device.is_sold]
    assert sold == [1, 2, 3, 4, 5, 6, 7, 8, 16, 29, 30, 32, 33, 99]


def test_each_value_of_a_device_that_is_sold_has_a_name() -> None:
    """But for calibrations, and modes that LEGO does not describe."""
    modes = [mode for device in DEVICE_TYPES.values() if device.is_sold for mode in device.modes]
    unknown = {mode.name for mode in modes if not mode.values}
    assert unknown == {"REF-RAW", "COL-CAL", "GYRO-FAS", "GYRO-CAL", "IR-S-ALT", "IR-CAL"}
    assert all(len(mode.labels) == mode.datasets for mode in modes)


@pytest.mark.parametrize("number", [1, 2, 3, 4, 5, 6, 7, 8, 16, 29, 30, 32, 33, 99])
def test_the_modes_of_legos_devices(number: int) -> None:
    wanted = [line.partition(" ")[2] for line in MODES.strip().splitlines() if line.startswith(f"{number} ")]
    found = [_described(mode) for mode in DEVICE_TYPES[number].modes]
    assert found[: len(wanted)] == wanted
    assert len(found) - len(wanted) == {4: 1, 99: 1}.get(number, 0)  # NXT-COL-RAW and ES-ALL, of many values

"""Types of sensors and motors with their modes: scaling of raw values, display format, names.

The firmware's own table (type data); EV3 sensors also send theirs when they are plugged in.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

from ev3proto.tables.enumerations import CONN, DATA_FORMAT, TYPE


class Range(NamedTuple):
    """The two ends of a range, scaled to those of another; the larger end comes first for inverted sensors."""

    least: float
    most: float


_PERCENT = Range(0, 100)


@dataclass(frozen=True)
class Mode:
    """One mode of a device.

    name      the firmware's name
    datasets  values per reading
    format    of a raw value, as in DATA_FORMAT: 0 8-bit, 1 16-bit, 2 32-bit, 3 float
    figures   number of characters shown by the firmware, point included
    decimals  how many of them after the point
    raw       raw values that map to `si` and `percent`
    si        values in the unit
    percent   values in percent
    symbol    the unit
    """

    name: str
    datasets: int
    format: int
    figures: int
    decimals: int
    raw: Range
    si: Range
    symbol: str = ""
    percent: Range = _PERCENT


@dataclass(frozen=True)
class DeviceType:
    """A type of sensor or motor.

    number      its number, see TYPE
    connection  how it is connected, see CONN
    views       number of modes, from the first on, in the brick's own menus
    modes       by number
    settling    milliseconds that it is busy after a change of type or mode, until it has a new value
    """

    number: int
    connection: int
    views: int
    modes: tuple[Mode, ...]
    settling: int = 0


_BITS8, _BITS16, _BITS32 = (DATA_FORMAT.members[name] for name in ("DATA_8", "DATA_16", "DATA_32"))
_INVERSE_TOUCH = Range(2000, 1000)
_NOTHING = Range(0, 0)


def _mode(
    name: str,
    format: int,
    shown: str,
    raw: tuple[float, float],
    symbol: str = "",
    *,
    si: tuple[float, float] | None = None,
    datasets: int = 1,
    percent: Range = _PERCENT,
) -> Mode:
    """Builds a mode; `si` defaults to the raw range, `shown` is figures and decimals, as in 5.1."""
    figures, decimals = map(int, shown.split("."))
    return Mode(name, datasets, format, figures, decimals, Range(*raw), Range(*(si or raw)), symbol, percent)


def _device(type: str, connection: str, views: int, *modes: Mode, settling: int = 0) -> DeviceType:
    return DeviceType(TYPE.members[type], CONN.members[connection], views, modes, settling)


def _plain(number: int, connection: str, name: str, format: int = _BITS8, shown: str = "3.0") -> DeviceType:
    """Builds a type without a manual that shows what the converter measures."""
    return DeviceType(number, CONN.members[connection], 1, (_mode(name, format, shown, (0, 4095)),))


def _motor(type: str, name: str) -> DeviceType:
    return _device(
        type,
        "CONN_OUTPUT_TACHO",
        2,
        _mode(f"{name}-DEG", _BITS32, "4.0", (-180, 180), "deg"),
        _mode(f"{name}-ROT", _BITS32, "4.0", (-36000, 36000), "rot", si=(-100, 100)),
        _mode(f"{name}-SPD", _BITS8, "3.0", (-100, 100), "pct", percent=Range(-100, 100)),
    )


_DEVICES = (
    _device(
        "TYPE_NXT_TOUCH",
        "CONN_NXT_DUMB",
        1,
        _mode("NXT-TOUCH", _BITS16, "1.0", _INVERSE_TOUCH, si=(0, 1)),
        _mode("NXT-BUMPS", _BITS32, "5.0", (0, 100), "cnt"),
    ),
    _device(
        "TYPE_NXT_LIGHT",
        "CONN_NXT_DUMB",
        2,
        _mode("NXT-REFLECT", _BITS16, "3.0", (3372, 445), "pct", si=(0, 100)),
        _mode("NXT-AMBIENT", _BITS16, "3.0", (3411, 633), "pct", si=(0, 100)),
        settling=20,
    ),
    _device(
        "TYPE_NXT_SOUND",
        "CONN_NXT_DUMB",
        2,
        _mode("NXT-SND-DB", _BITS16, "3.0", (4095, 0), "pct", si=(0, 100)),
        _mode("NXT-SND-DBA", _BITS16, "3.0", (4095, 0), "pct", si=(0, 100)),
        settling=300,
    ),
    _device(
        "TYPE_NXT_COLOR",
        "CONN_NXT_COLOR",
        5,
        _mode("NXT-COL-REF", _BITS32, "5.0", (200, 1500), "pct", si=(0, 100)),
        _mode("NXT-COL-AMB", _BITS32, "5.0", (200, 2900), "pct", si=(0, 100)),
        _mode("NXT-COL-COL", _BITS8, "2.0", (0, 8), "col"),
        _mode("NXT-COL-GRN", _BITS32, "5.0", (200, 1500), "pct", si=(0, 100)),
        _mode("NXT-COL-BLU", _BITS32, "5.0", (200, 1500), "pct", si=(0, 100)),
        _mode("NXT-COL-RAW", _BITS32, "5.0", (0, 10000), datasets=4),
        settling=300,
    ),
    _device(
        "TYPE_NXT_ULTRASONIC",
        "CONN_NXT_IIC",
        2,
        _mode("NXT-US-CM", _BITS16, "5.0", (0, 255), "cm"),
        _mode("NXT-US-IN", _BITS16, "5.0", (0, 255), "inch", si=(0, 100)),
        settling=300,
    ),
    _device(
        "TYPE_NXT_TEMPERATURE",
        "CONN_NXT_IIC",
        2,
        _mode("NXT-TEMP-C", _BITS16, "5.1", (-14080, 32767), "c", si=(-55, 128)),
        _mode("NXT-TEMP-F", _BITS16, "5.1", (-14080, 32767), "f", si=(-67, 262.4)),
        settling=300,
    ),
    _motor("TYPE_TACHO", "L-MOTOR"),
    _motor("TYPE_MINITACHO", "M-MOTOR"),
    _plain(9, "CONN_OUTPUT_TACHO", "FREE", _BITS16, "4.0"),
    _plain(10, "CONN_OUTPUT_DUMB", "O-#02"),
    _plain(11, "CONN_OUTPUT_DUMB", "O-#03"),
    _plain(12, "CONN_OUTPUT_DUMB", "O-#04"),
    _plain(13, "CONN_OUTPUT_DUMB", "O-#05"),
    _plain(14, "CONN_OUTPUT_DUMB", "O-3th.party"),
    _plain(15, "CONN_INPUT_DUMB", "I-#01"),
    _device(
        "TYPE_TOUCH",
        "CONN_INPUT_DUMB",
        1,
        _mode("TOUCH", _BITS16, "1.0", (1000, 2000), si=(0, 1)),
        _mode("BUMPS", _BITS32, "5.0", (0, 1), "cnt"),
    ),
    _plain(17, "CONN_INPUT_DUMB", "I-#03"),
    _plain(18, "CONN_INPUT_DUMB", "I-#04"),
    _plain(19, "CONN_INPUT_DUMB", "I-#05"),
    DeviceType(
        20,
        CONN.members["CONN_INPUT_DUMB"],
        1,
        (_mode("I-#06", _BITS16, "3.0", (287, 1925), si=(-440, 440), percent=Range(-100, 100)),),
    ),
    DeviceType(
        21, CONN.members["CONN_INPUT_DUMB"], 1, (_mode("TEST", _BITS16, "4.0", (933, 1333), "cnt", si=(0, 1000)),)
    ),
    _plain(22, "CONN_INPUT_DUMB", "I-#08", _BITS16),
    _plain(23, "CONN_INPUT_DUMB", "I-#09", _BITS16),
    _plain(24, "CONN_INPUT_DUMB", "I-#10"),
    _plain(25, "CONN_INPUT_DUMB", "I-#11"),
    _plain(26, "CONN_INPUT_DUMB", "I-#12"),
    _plain(27, "CONN_INPUT_DUMB", "I-#13"),
    DeviceType(
        28,
        CONN.members["CONN_INPUT_DUMB"],
        4,
        (
            _mode("3th.party-1", _BITS16, "4.0", (0, 4095)),
            _mode("3th.party-2", _BITS16, "4.0", (0, 4095), si=(0, 5000)),
            _mode("3th.party-3", _BITS16, "5.0", (0, 4095), si=(0, 10000)),
            _mode("3th.party-4", _BITS16, "5.0", (0, 4095), si=(0, 20000)),
        ),
    ),
    _device(
        "TYPE_COLOR",
        "CONN_INPUT_UART",
        3,
        _mode("COL-REFLECT", _BITS8, "3.0", (0, 100), "pct"),
        _mode("COL-AMBIENT", _BITS8, "3.0", (0, 100), "pct"),
        _mode("COL-COLOR", _BITS8, "2.0", (0, 8), "col"),
        _mode("REF-RAW", _BITS16, "4.0", (0, 1020.2), datasets=2),
        _mode("RGB-RAW", _BITS16, "4.0", (0, 1020.2), datasets=3),
        _mode("COL-CAL", _BITS16, "5.0", (0, 65535), datasets=4),
        settling=10,
    ),
    _device(
        "TYPE_ULTRASONIC",
        "CONN_INPUT_UART",
        3,
        _mode("US-DIST-CM", _BITS16, "5.1", (0, 2550), "cm", si=(0, 255)),
        _mode("US-DIST-IN", _BITS16, "5.1", (0, 1000), "inch", si=(0, 100)),
        _mode("US-LISTEN", _BITS8, "1.0", (0, 1)),
        _mode("US-SI-CM", _BITS16, "5.1", (0, 2550), "cm", si=(0, 255)),
        _mode("US-SI-IN", _BITS16, "5.1", (0, 1000), "inch", si=(0, 100)),
        _mode("US-DC-CM", _BITS16, "5.1", (0, 2550), "cm", si=(0, 255)),
        _mode("US-DC-IN", _BITS16, "5.1", (0, 1000), "inch", si=(0, 100)),
        settling=10,
    ),
    _device(
        "TYPE_GYRO",
        "CONN_INPUT_UART",
        2,
        _mode("GYRO-ANG", _BITS16, "4.0", (-180, 180), "deg"),
        _mode("GYRO-RATE", _BITS16, "3.0", (-440, 440), "d/s"),
        _mode("GYRO-FAS", _BITS16, "4.0", (-2000, 2000)),
        _mode("GYRO-G&A", _BITS16, "5.0", (-180, 180), datasets=2),
        _mode("GYRO-CAL", _BITS16, "5.0", (0, 65535), datasets=4),
        settling=10,
    ),
    _device(
        "TYPE_IR",
        "CONN_INPUT_UART",
        3,
        _mode("IR-PROX", _BITS8, "3.0", (0, 100), "pct"),
        _mode("IR-SEEK", _BITS8, "3.0", (-100, 100), "pct", datasets=8),
        _mode("IR-REMOTE", _BITS8, "3.0", (0, 10), "btn", datasets=4),
        _mode("IR-REM-A", _BITS16, "6.0", (0, 65535)),
        _mode("IR-S-ALT", _BITS8, "3.0", (0, 100), "pct", datasets=4),
        _mode("IR-CAL", _BITS16, "5.0", (0, 65535), datasets=2),
        settling=1100,
    ),
    _device(
        "TYPE_ENERGYMETER",
        "CONN_NXT_IIC",
        7,
        _mode("ES-IN-VOLT", _BITS16, "4.1", (0, 10000), "V", si=(0, 10)),
        _mode("ES-IN-AMP", _BITS16, "5.3", (0, 10000), "A", si=(0, 10)),
        _mode("ES-OUT-VOLT", _BITS16, "4.1", (0, 10000), "V", si=(0, 10)),
        _mode("ES-OUT-AMP", _BITS16, "5.3", (0, 10000), "A", si=(0, 10)),
        _mode("ES-JOULE", _BITS16, "3.0", (0, 100), "J"),
        _mode("ES-IN-WATT", _BITS16, "5.3", (0, 10000), "W", si=(0, 10)),
        _mode("ES-OUT-WATT", _BITS16, "5.3", (0, 10000), "W", si=(0, 10)),
        # Joules come a thousand times as large, so that they are joules in the unit, too.
        _mode("ES-ALL", _BITS16, "7.3", (0, 10000), si=(0, 10), datasets=7),
        settling=100,
    ),
    _device(
        "TYPE_IIC_UNKNOWN",
        "CONN_NXT_IIC",
        2,
        _mode("IIC-BYTE", _BITS16, "3.0", (0, 255)),
        _mode("IIC-WORD", _BITS16, "5.0", (0, 65255), si=(0, 65535)),
        settling=100,
    ),
    _device("TYPE_NXT_TEST", "CONN_NXT_DUMB", 1, _mode("NXT-TEST", _BITS16, "3.0", (1848, 2248), "cnt", si=(0, 1000))),
    _device("TYPE_UNKNOWN", "CONN_UNKNOWN", 1, _mode("UNKNOWN", _BITS16, "4.0", (0, 1023))),
    _device("TYPE_NONE", "CONN_NONE", 1, Mode("NONE", 0, _BITS8, 4, 0, _NOTHING, _NOTHING, "", _NOTHING)),
)

DEVICE_TYPES = MappingProxyType({device.number: device for device in _DEVICES})
"""The types by number."""

NO_DEVICE = DEVICE_TYPES[TYPE.members["TYPE_NONE"]]
"""The type that an empty port reports."""

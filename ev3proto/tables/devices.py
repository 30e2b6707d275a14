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


class Dataset(NamedTuple):
    """One value of a reading: what it measures, and its unit as written, empty where it has none."""

    name: str
    unit: str = ""

    def __str__(self) -> str:
        return f"{self.name}, in {self.unit}" if self.unit else self.name


PERCENT = Range(0, 100)

UNITS = {
    "pct": "%",
    "deg": "degrees",
    "d/s": "degrees/s",
    "rot": "rotations",
    "c": "°C",
    "f": "°F",
    "cm": "cm",
    "inch": "inches",
    "V": "V",
    "A": "A",
    "J": "J",
    "W": "W",
}
"""Units as they are written, by the firmware's symbol; the other symbols are words for counts and choices."""


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
    symbol    the unit, as the firmware shows it
    values    what each value of a reading is; empty where that is not documented
    """

    name: str
    datasets: int
    format: int
    figures: int
    decimals: int
    raw: Range
    si: Range
    symbol: str = ""
    percent: Range = PERCENT
    values: tuple[Dataset, ...] = ()

    @property
    def unit(self) -> str:
        """The unit as written, or the firmware's word for a count or a choice."""
        return UNITS.get(self.symbol, self.symbol)

    @property
    def labels(self) -> tuple[Dataset, ...]:
        """What each value is; `value 1` where that is not documented."""
        return self.values or tuple(Dataset(f"value {number + 1}", self.unit) for number in range(self.datasets))


@dataclass(frozen=True)
class DeviceType:
    """A type of sensor or motor.

    number      its number, see TYPE
    title       what people call it
    connection  how it is connected, see CONN
    views       number of modes, from the first on, in the brick's own menus
    modes       by number
    settling    milliseconds that it is busy after a change of type or mode, until it has a new value
    is_sold     whether there are devices of it: the firmware knows further types
    """

    number: int
    title: str
    connection: int
    views: int
    modes: tuple[Mode, ...]
    settling: int = 0
    is_sold: bool = True

    @property
    def name(self) -> str:
        """Its name in TYPE, `type 10` if it has none."""
        return TYPE.name_of(self.number) or f"type {self.number}"

    @property
    def is_motor(self) -> bool:
        """Whether it is a motor."""
        return self.connection == CONN.members["CONN_OUTPUT_TACHO"]

    @property
    def is_output(self) -> bool:
        """Whether it is for a motor port."""
        return self.is_motor or self.connection == CONN.members["CONN_OUTPUT_DUMB"]


_BITS8, _BITS16, _BITS32 = (DATA_FORMAT.members[name] for name in ("DATA_8", "DATA_16", "DATA_32"))
_INVERSE_TOUCH = Range(2000, 1000)
_NOTHING = Range(0, 0)


def _mode(
    name: str,
    format: int,
    shown: str,
    raw: tuple[float, float],
    symbol: str = "",
    *values: str | Dataset,
    si: tuple[float, float] | None = None,
    datasets: int = 1,
    percent: Range = PERCENT,
) -> Mode:
    """Builds a mode.

    `si` defaults to the raw range, `shown` is figures and decimals, as in 5.1; `values` has the names of all datasets,
    whose unit is that of the symbol, or which have their own.
    """
    figures, decimals = map(int, shown.split("."))
    named = tuple(Dataset(one, UNITS.get(symbol, "")) if isinstance(one, str) else one for one in values)
    count = len(named) or datasets
    return Mode(name, count, format, figures, decimals, Range(*raw), Range(*(si or raw)), symbol, percent, named)


def _device(
    type: str | int, title: str, connection: str, views: int, *modes: Mode, settling: int = 0, is_sold: bool = True
) -> DeviceType:
    """Builds a type by its name in TYPE, or by its number if the firmware has no name for it."""
    number = TYPE.members[type] if isinstance(type, str) else type
    return DeviceType(number, title, CONN.members[connection], views, modes, settling, is_sold)


def _unused(number: int, connection: str, *modes: Mode, title: str = "") -> DeviceType:
    """Builds a type that the firmware knows and that no device has."""
    title = title or f"unused type {number}"
    return DeviceType(number, title, CONN.members[connection], len(modes), modes, is_sold=False)


def _converted(name: str, format: int = _BITS8, shown: str = "3.0") -> Mode:
    """Builds a mode that shows what the converter measures."""
    return _mode(name, format, shown, (0, 4095))


def _motor(type: str, title: str, name: str) -> DeviceType:
    return _device(
        type,
        title,
        "CONN_OUTPUT_TACHO",
        2,
        _mode(f"{name}-DEG", _BITS32, "4.0", (-180, 180), "deg", "angle"),
        _mode(f"{name}-ROT", _BITS32, "4.0", (-36000, 36000), "rot", "angle", si=(-100, 100)),
        _mode(f"{name}-SPD", _BITS8, "3.0", (-100, 100), "pct", "speed", percent=Range(-100, 100)),
    )


_CHANNELS = (1, 2, 3, 4)
_BEACONS = tuple(
    dataset
    for number in _CHANNELS
    for dataset in (Dataset(f"heading on channel {number}"), Dataset(f"distance on channel {number}", "%"))
)
_ENERGY = (
    Dataset("input voltage", "V"),
    Dataset("input current", "A"),
    Dataset("output voltage", "V"),
    Dataset("output current", "A"),
    Dataset("energy", "J"),
    Dataset("input power", "W"),
    Dataset("output power", "W"),
)

_DEVICES = (
    _device(
        "TYPE_NXT_TOUCH",
        "NXT touch sensor",
        "CONN_NXT_DUMB",
        1,
        _mode("NXT-TOUCH", _BITS16, "1.0", _INVERSE_TOUCH, "", "pressed", si=(0, 1)),
        _mode("NXT-BUMPS", _BITS32, "5.0", (0, 100), "cnt", "bumps"),
    ),
    _device(
        "TYPE_NXT_LIGHT",
        "NXT light sensor",
        "CONN_NXT_DUMB",
        2,
        _mode("NXT-REFLECT", _BITS16, "3.0", (3372, 445), "pct", "reflected light", si=(0, 100)),
        _mode("NXT-AMBIENT", _BITS16, "3.0", (3411, 633), "pct", "ambient light", si=(0, 100)),
        settling=20,
    ),
    _device(
        "TYPE_NXT_SOUND",
        "NXT sound sensor",
        "CONN_NXT_DUMB",
        2,
        _mode("NXT-SND-DB", _BITS16, "3.0", (4095, 0), "pct", "loudness", si=(0, 100)),
        _mode("NXT-SND-DBA", _BITS16, "3.0", (4095, 0), "pct", "loudness", si=(0, 100)),
        settling=300,
    ),
    _device(
        "TYPE_NXT_COLOR",
        "NXT colour sensor",
        "CONN_NXT_COLOR",
        5,
        _mode("NXT-COL-REF", _BITS32, "5.0", (200, 1500), "pct", "reflected light", si=(0, 100)),
        _mode("NXT-COL-AMB", _BITS32, "5.0", (200, 2900), "pct", "ambient light", si=(0, 100)),
        _mode("NXT-COL-COL", _BITS8, "2.0", (0, 8), "col", "colour"),
        _mode("NXT-COL-GRN", _BITS32, "5.0", (200, 1500), "pct", "reflected light", si=(0, 100)),
        _mode("NXT-COL-BLU", _BITS32, "5.0", (200, 1500), "pct", "reflected light", si=(0, 100)),
        _mode("NXT-COL-RAW", _BITS32, "5.0", (0, 10000), "", "red", "green", "blue", "ambient light"),
        settling=300,
    ),
    _device(
        "TYPE_NXT_ULTRASONIC",
        "NXT ultrasonic sensor",
        "CONN_NXT_IIC",
        2,
        _mode("NXT-US-CM", _BITS16, "5.0", (0, 255), "cm", "distance"),
        _mode("NXT-US-IN", _BITS16, "5.0", (0, 255), "inch", "distance", si=(0, 100)),
        settling=300,
    ),
    _device(
        "TYPE_NXT_TEMPERATURE",
        "NXT temperature sensor",
        "CONN_NXT_IIC",
        2,
        _mode("NXT-TEMP-C", _BITS16, "5.1", (-14080, 32767), "c", "temperature", si=(-55, 128)),
        _mode("NXT-TEMP-F", _BITS16, "5.1", (-14080, 32767), "f", "temperature", si=(-67, 262.4)),
        settling=300,
    ),
    _motor("TYPE_TACHO", "large motor", "L-MOTOR"),
    _motor("TYPE_MINITACHO", "medium motor", "M-MOTOR"),
    _unused(9, "CONN_OUTPUT_TACHO", _converted("FREE", _BITS16, "4.0"), title="new motor"),
    _unused(10, "CONN_OUTPUT_DUMB", _converted("O-#02")),
    _unused(11, "CONN_OUTPUT_DUMB", _converted("O-#03")),
    _unused(12, "CONN_OUTPUT_DUMB", _converted("O-#04")),
    _unused(13, "CONN_OUTPUT_DUMB", _converted("O-#05")),
    _unused(14, "CONN_OUTPUT_DUMB", _converted("O-3th.party"), title="output device of another maker"),
    _unused(15, "CONN_INPUT_DUMB", _converted("I-#01")),
    _device(
        "TYPE_TOUCH",
        "EV3 touch sensor",
        "CONN_INPUT_DUMB",
        1,
        _mode("TOUCH", _BITS16, "1.0", (1000, 2000), "", "pressed", si=(0, 1)),
        _mode("BUMPS", _BITS32, "5.0", (0, 1), "cnt", "bumps"),
    ),
    _unused(17, "CONN_INPUT_DUMB", _converted("I-#03")),
    _unused(18, "CONN_INPUT_DUMB", _converted("I-#04")),
    _unused(19, "CONN_INPUT_DUMB", _converted("I-#05")),
    _unused(
        20,
        "CONN_INPUT_DUMB",
        _mode("I-#06", _BITS16, "3.0", (287, 1925), si=(-440, 440), percent=Range(-100, 100)),
    ),
    _unused(
        21, "CONN_INPUT_DUMB", _mode("TEST", _BITS16, "4.0", (933, 1333), "cnt", si=(0, 1000)), title="EV3 test device"
    ),
    _unused(22, "CONN_INPUT_DUMB", _converted("I-#08", _BITS16)),
    _unused(23, "CONN_INPUT_DUMB", _converted("I-#09", _BITS16)),
    _unused(24, "CONN_INPUT_DUMB", _converted("I-#10")),
    _unused(25, "CONN_INPUT_DUMB", _converted("I-#11")),
    _unused(26, "CONN_INPUT_DUMB", _converted("I-#12")),
    _unused(27, "CONN_INPUT_DUMB", _converted("I-#13")),
    _unused(
        28,
        "CONN_INPUT_DUMB",
        _mode("3th.party-1", _BITS16, "4.0", (0, 4095)),
        _mode("3th.party-2", _BITS16, "4.0", (0, 4095), si=(0, 5000)),
        _mode("3th.party-3", _BITS16, "5.0", (0, 4095), si=(0, 10000)),
        _mode("3th.party-4", _BITS16, "5.0", (0, 4095), si=(0, 20000)),
        title="analog sensor of another maker",
    ),
    _device(
        "TYPE_COLOR",
        "EV3 colour sensor",
        "CONN_INPUT_UART",
        3,
        _mode("COL-REFLECT", _BITS8, "3.0", (0, 100), "pct", "reflected light"),
        _mode("COL-AMBIENT", _BITS8, "3.0", (0, 100), "pct", "ambient light"),
        _mode("COL-COLOR", _BITS8, "2.0", (0, 8), "col", "colour"),
        _mode("REF-RAW", _BITS16, "4.0", (0, 1020.2), datasets=2),
        _mode("RGB-RAW", _BITS16, "4.0", (0, 1020.2), "", "red", "green", "blue"),
        _mode("COL-CAL", _BITS16, "5.0", (0, 65535), datasets=4),
        settling=10,
    ),
    _device(
        "TYPE_ULTRASONIC",
        "EV3 ultrasonic sensor",
        "CONN_INPUT_UART",
        3,
        _mode("US-DIST-CM", _BITS16, "5.1", (0, 2550), "cm", "distance", si=(0, 255)),
        _mode("US-DIST-IN", _BITS16, "5.1", (0, 1000), "inch", "distance", si=(0, 100)),
        _mode("US-LISTEN", _BITS8, "1.0", (0, 1), "", "other sensor heard"),
        _mode("US-SI-CM", _BITS16, "5.1", (0, 2550), "cm", "distance", si=(0, 255)),
        _mode("US-SI-IN", _BITS16, "5.1", (0, 1000), "inch", "distance", si=(0, 100)),
        _mode("US-DC-CM", _BITS16, "5.1", (0, 2550), "cm", "distance", si=(0, 255)),
        _mode("US-DC-IN", _BITS16, "5.1", (0, 1000), "inch", "distance", si=(0, 100)),
        settling=10,
    ),
    _device(
        "TYPE_GYRO",
        "EV3 gyro sensor",
        "CONN_INPUT_UART",
        2,
        _mode("GYRO-ANG", _BITS16, "4.0", (-180, 180), "deg", "angle"),
        _mode("GYRO-RATE", _BITS16, "3.0", (-440, 440), "d/s", "rate"),
        _mode("GYRO-FAS", _BITS16, "4.0", (-2000, 2000)),
        _mode(
            "GYRO-G&A",
            _BITS16,
            "5.0",
            (-180, 180),
            "",
            Dataset("angle", "degrees"),
            Dataset("rate", "degrees/s"),
        ),
        _mode("GYRO-CAL", _BITS16, "5.0", (0, 65535), datasets=4),
        settling=10,
    ),
    _device(
        "TYPE_IR",
        "EV3 infrared sensor",
        "CONN_INPUT_UART",
        3,
        _mode("IR-PROX", _BITS8, "3.0", (0, 100), "pct", "distance"),
        _mode("IR-SEEK", _BITS8, "3.0", (-100, 100), "pct", *_BEACONS),
        _mode("IR-REMOTE", _BITS8, "3.0", (0, 10), "btn", *(f"buttons on channel {number}" for number in _CHANNELS)),
        _mode("IR-REM-A", _BITS16, "6.0", (0, 65535), "", "buttons"),
        _mode("IR-S-ALT", _BITS8, "3.0", (0, 100), "pct", datasets=4),
        _mode("IR-CAL", _BITS16, "5.0", (0, 65535), datasets=2),
        settling=1100,
    ),
    _device(
        "TYPE_ENERGYMETER",
        "NXT energy meter",
        "CONN_NXT_IIC",
        7,
        _mode("ES-IN-VOLT", _BITS16, "4.1", (0, 10000), "V", "input voltage", si=(0, 10)),
        _mode("ES-IN-AMP", _BITS16, "5.3", (0, 10000), "A", "input current", si=(0, 10)),
        _mode("ES-OUT-VOLT", _BITS16, "4.1", (0, 10000), "V", "output voltage", si=(0, 10)),
        _mode("ES-OUT-AMP", _BITS16, "5.3", (0, 10000), "A", "output current", si=(0, 10)),
        _mode("ES-JOULE", _BITS16, "3.0", (0, 100), "J", "energy"),
        _mode("ES-IN-WATT", _BITS16, "5.3", (0, 10000), "W", "input power", si=(0, 10)),
        _mode("ES-OUT-WATT", _BITS16, "5.3", (0, 10000), "W", "output power", si=(0, 10)),
        # Joules come a thousand times as large, so that they are joules in the unit, too.
        _mode("ES-ALL", _BITS16, "7.3", (0, 10000), "", *_ENERGY, si=(0, 10)),
        settling=100,
    ),
    _device(
        "TYPE_IIC_UNKNOWN",
        "I2C sensor of another maker",
        "CONN_NXT_IIC",
        2,
        _mode("IIC-BYTE", _BITS16, "3.0", (0, 255)),
        _mode("IIC-WORD", _BITS16, "5.0", (0, 65255), si=(0, 65535)),
        settling=100,
        is_sold=False,
    ),
    _unused(
        101,
        "CONN_NXT_DUMB",
        _mode("NXT-TEST", _BITS16, "3.0", (1848, 2248), "cnt", si=(0, 1000)),
        title="NXT test device",
    ),
    _unused(125, "CONN_UNKNOWN", _mode("UNKNOWN", _BITS16, "4.0", (0, 1023)), title="unknown device"),
    _unused(126, "CONN_NONE", Mode("NONE", 0, _BITS8, 4, 0, _NOTHING, _NOTHING, "", _NOTHING), title="no device"),
)

DEVICE_TYPES = MappingProxyType({device.number: device for device in _DEVICES})
"""The types by number."""

NO_DEVICE = DEVICE_TYPES[TYPE.members["TYPE_NONE"]]
"""The type that an empty port reports."""

"""Operations on sensors, and on motors read as sensors: values, types, modes, calibration, raw I2C.

Where the firmware writes several values at once, the entry names the parameter that gives their number and type.
"""

from ev3proto.tables.declaration import (
    DATA8,
    DATA16,
    DATA32,
    DATAF,
    EXTENSIONS,
    STRING,
    Command,
    Count,
    Direction,
    Effect,
    In,
    Opcode,
    Out,
    Role,
)
from ev3proto.tables.devices import DEVICE_TYPES
from ev3proto.tables.enumerations import CONN, DATA_FORMAT, RESULT, TYPE
from ev3proto.tables.ports import MotorPort, SensorPort

SENSOR_PORTS = {port.value: f"port {port + 1}" for port in SensorPort}
MOST_WAITS = 8
"""Sensors that one command of an untrusted client may wait for: the firmware waits 1.2 s for each."""

MOTOR_PORTS = {16 + port: f"motor port {port.name}" for port in MotorPort}

LAYER = In("LAYER", DATA8, "brick in the daisy chain, 0 is the one addressed", range=(0, 3), role=Role.LAYER)
LAYERS = In("LAYER", DATA8, "brick in the daisy chain", range=(0, 3), special={-1: "all layers"}, role=Role.LAYER)
NO = In(
    "NO",
    DATA8,
    "port, counted from 0; 16 to 19 for motors",
    range=(0, 19),
    special=SENSOR_PORTS | MOTOR_PORTS,
    role=Role.PORT,
)
SENSOR_NO = In("NO", DATA8, "sensor port, counted from 0", range=(0, 3), special=SENSOR_PORTS, role=Role.PORT)
_NAMELESS = {
    device.number: device.title
    for device in DEVICE_TYPES.values()
    if device.is_sold and TYPE.name_of(device.number) is None
}
TYPE_TO_SET = In("TYPE", DATA8, "type to set", enum=TYPE, special={0: "keep the type"} | _NAMELESS)
MODE_TO_SET = In("MODE", DATA8, "mode to set", range=(0, 7), special={-1: "keep the mode"})
CAL_TYPE = In("TYPE", DATA8, "type of device the calibration is for", enum=TYPE)
CAL_MODE = In("MODE", DATA8, "mode the calibration is for", range=(0, 7))
TEXT_LENGTH = In(
    "LENGTH",
    DATA8,
    "size of the text buffer, including the zero",
    unit="bytes",
    special={-1: "unlimited (handles only)"},
)
WRLNG = In("WRLNG", DATA8, "number of bytes to write", unit="bytes", range=(0, 32))
WRDATA = In("WRDATA", DATA8, "bytes to write: I2C address, register, data", length="WRLNG")
RDDATA = Out("RDDATA", DATA8, "bytes read", length="RDLNG")
RDLNG = In("RDLNG", DATA8, "number of bytes to read", unit="bytes", range=(0, 32))
REVERSIBLE_RDLNG = In(
    "RDLNG", DATA8, "number of bytes to read, negative: in reverse order", unit="bytes", range=(-32, 32)
)

INPUT = (
    Opcode(
        0x97,
        "INPUT_SAMPLE",
        "Reads one SI value of each of several devices, sampled in the background",
        (
            In("TIME", DATA32, "time between two samples", unit="ms"),
            In("SAMPLES", DATA16, "number of devices the arrays list"),
            In("INIT", DATA16, "place in the sample buffer of each device, -1 starts it anew", length="SAMPLES"),
            In(
                "DEVICES",
                DATA8,
                "ports, 0 to 3 for sensors, 4 to 7 for motors A to D",
                length="SAMPLES",
                role=Role.PORTS,
            ),
            In("TYPES", DATA8, "type to set for each device", enum=TYPE, length="SAMPLES"),
            In("MODES", DATA8, "mode to set for each device", length="SAMPLES"),
            In("DATASETS", DATA8, "index of the value to read from each device, from 0", length="SAMPLES"),
            Out("VALUES", DATAF, "one value per device, NaN if there is none", length="SAMPLES"),
        ),
        effects=(Effect.VARIES, Effect.COMPUTES),
    ),
    Opcode(
        0x98,
        "INPUT_DEVICE_LIST",
        "Lists the types of all devices, sensor ports of each layer first, then motor ports",
        (
            In("LENGTH", DATA8, "size of the array; 32 holds the whole daisy chain", range=(0, 127)),
            Out("ARRAY", DATA8, "type of device at each port", enum=TYPE, length="LENGTH", role=Role.PUBLIC),
            Out("CHANGED", DATA8, "whether devices came or went since the last call", special={0: "no change"}),
        ),
        effects=(Effect.VARIES, Effect.READS),
    ),
    Opcode(
        0x99,
        "INPUT_DEVICE",
        "Asks about devices, calibrates them, reads several values",
        commands=(
            Command(
                1,
                "INSERT_TYPE",
                "Adds a line to the table of device types, for third party types (50 to 98) only",
                (
                    In("TYPEDATA", STRING, "the line as in typedata.rcf, starting with the type's number"),
                    In(
                        "FORCE",
                        DATA8,
                        "whether to replace a known type",
                        range=(0, 1),
                        special={0: "refuse a known type", 1: "replace a known type"},
                    ),
                    Out("ERROR", DATA8, "whether it failed", range=(0, 1), special={0: "done", 1: "failed or known"}),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
                newer=True,
            ),
            Command(
                2,
                "GET_FORMAT",
                "Describes the values of a device in its current mode",
                (
                    LAYER,
                    NO,
                    Out("DATASETS", DATA8, "number of values in one reading"),
                    Out("FORMAT", DATA8, "type of one raw value", range=(0, 3), enum=DATA_FORMAT),
                    Out("MODES", DATA8, "number of modes of the device", range=(1, 8)),
                    Out("VIEWS", DATA8, "number of modes shown to users", range=(1, 8)),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                3,
                "CAL_MINMAX",
                "Sets the raw values that scale a type and mode to percent and SI",
                (
                    CAL_TYPE,
                    CAL_MODE,
                    In("CAL_MIN", DATA32, "raw value at the lower end"),
                    In("CAL_MAX", DATA32, "raw value at full scale"),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
                words="calibrate",
            ),
            Command(
                4,
                "CAL_DEFAULT",
                "Restores the built-in scaling of a type and mode",
                (CAL_TYPE, CAL_MODE),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                5,
                "GET_TYPEMODE",
                "Reports the device at a port and its mode",
                (
                    LAYER,
                    NO,
                    Out("TYPE", DATA8, "type of the device", enum=TYPE),
                    Out("MODE", DATA8, "mode the device is in", range=(0, 7)),
                ),
                effects=(Effect.VARIES, Effect.READS),
                sentence="asks which device is at {NO}, and its mode",
            ),
            Command(
                6,
                "GET_SYMBOL",
                "Reads the symbol of the unit of the current mode",
                (
                    LAYER,
                    NO,
                    TEXT_LENGTH,
                    Out("DESTINATION", STRING, "symbol, padded with blanks", length="LENGTH", role=Role.PUBLIC),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                7,
                "CAL_MIN",
                "Sets the lower end of the scaling of a type and mode",
                (CAL_TYPE, CAL_MODE, In("CAL_MIN", DATA32, "value at the lower end, in SI units once calibrated")),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                8,
                "CAL_MAX",
                "Sets the full scale of a type and mode",
                (CAL_TYPE, CAL_MODE, In("CAL_MAX", DATA32, "value at full scale, in SI units once calibrated")),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                9,
                "SETUP",
                "Writes to an I2C sensor and reads its answer, repeatedly if requested",
                (
                    LAYER,
                    SENSOR_NO,
                    In("REPEAT", DATA8, "number of repeats", special={0: "endless"}),
                    In("TIME", DATA16, "time between repeats", unit="ms", range=(10, 1000), special={0: "10 ms"}),
                    In("WRITE_LEN", DATA8, "number of bytes to write", unit="bytes", range=(0, 32)),
                    In("WRITE_DATA", DATA8, "bytes to write: I2C address, register, data", length="WRITE_LEN"),
                    In(
                        "READ_LEN",
                        DATA8,
                        "number of bytes to read, negative: in reverse order",
                        unit="bytes",
                        range=(-32, 32),
                    ),
                    Out("READ_DATA", DATA8, "bytes read", length="READ_LEN"),
                ),
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                10,
                "CLR_ALL",
                "Clears counters and angles of all devices",
                (LAYERS,),
                effects=(Effect.SETS_MOTORS,),
                words="reset gyro sensor zero",
            ),
            Command(
                11,
                "GET_RAW",
                "Reads the first raw value of a device",
                (LAYER, NO, Out("VALUE", DATA32, "raw value, NaN if there is none")),
                effects=(Effect.VARIES, Effect.READS),
                sentence="reads the raw value of {NO}",
            ),
            Command(
                12,
                "GET_CONNECTION",
                "Reports how the device at a port is connected",
                (LAYER, NO, Out("CONN", DATA8, "kind of connection", enum=CONN)),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(13, "STOP_ALL", "Stops all devices, motors among them", (LAYERS,), effects=(Effect.STOPS_MOTORS,)),
            Command(
                14,
                "SET_TYPEMODE",
                "Renumbers an entry of the table of device types, third party types only",
                (
                    In("TYPE", DATA8, "type of the entry", range=(50, 98), enum=TYPE),
                    In("MODE", DATA8, "mode of the entry", range=(0, 7)),
                    In("NEWTYPE", DATA8, "new type of the entry", range=(50, 98), enum=TYPE),
                    In("NEWMODE", DATA8, "new mode of the entry", range=(0, 7)),
                    Out(
                        "ERROR",
                        DATA8,
                        "whether it failed",
                        range=(0, 1),
                        special={0: "done", 1: "failed or not found"},
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
                newer=True,
            ),
            Command(
                15,
                "READY_IIC",
                "Writes to an I2C sensor once, waits for its answer and reports the result",
                (
                    LAYER,
                    SENSOR_NO,
                    WRLNG,
                    WRDATA,
                    REVERSIBLE_RDLNG,
                    RDDATA,
                    Out("RESULT", DATA8, "how the transfer ended", enum=RESULT),
                ),
                effects=(Effect.WAITS, Effect.WRITES_TO_DEVICES, Effect.VARIES),
                newer=True,
            ),
            Command(
                21,
                "GET_NAME",
                "Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT",
                (
                    LAYER,
                    NO,
                    TEXT_LENGTH,
                    Out("DESTINATION", STRING, "name, padded with blanks", length="LENGTH", role=Role.PUBLIC),
                ),
                effects=(Effect.VARIES, Effect.READS),
                sentence="reads the name of the device at {NO}",
            ),
            Command(
                22,
                "GET_MODENAME",
                "Reads the name of any mode of a device",
                (
                    LAYER,
                    NO,
                    In("MODE", DATA8, "mode to name", range=(0, 7)),
                    TEXT_LENGTH,
                    Out("DESTINATION", STRING, "name, padded with blanks", length="LENGTH", role=Role.PUBLIC),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                23,
                "SET_RAW",
                "Simulates a raw value of a device",
                (LAYER, NO, TYPE_TO_SET, In("VALUE", DATA32, "raw value to simulate")),
                effects=(Effect.WRITES_TO_DEVICES,),
            ),
            Command(
                24,
                "GET_FIGURES",
                "Reports the number of digits that a value of the current mode needs",
                (
                    LAYER,
                    NO,
                    Out("FIGURES", DATA8, "total number of characters, with point and decimals"),
                    Out("DECIMALS", DATA8, "digits after the point"),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                25,
                "GET_CHANGES",
                "Reads how often a touch sensor changed to pressed since CLR_CHANGES",
                (LAYER, NO, Out("VALUE", DATAF, "number of changes, 0 for other sensors")),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                26,
                "CLR_CHANGES",
                "Sets the counts of GET_CHANGES and GET_BUMPS to zero",
                (LAYER, NO),
                effects=(Effect.RESETS_SENSORS,),
            ),
            Command(
                27,
                "READY_PCT",
                "Sets type and mode, waits until the device is ready and reads percent values",
                (
                    LAYER,
                    NO,
                    TYPE_TO_SET,
                    MODE_TO_SET,
                    Count(
                        "VALUES",
                        "number of values that follow, each in percent",
                        DATA8,
                        Direction.OUT,
                        each="value in percent",
                    ),
                ),
                effects=(Effect.WAITS, Effect.VARIES, Effect.READS),
                sentence="reads {NO} in percent, when it is ready",
            ),
            Command(
                28,
                "READY_RAW",
                "Sets type and mode, waits until the device is ready and reads raw values",
                (
                    LAYER,
                    NO,
                    TYPE_TO_SET,
                    MODE_TO_SET,
                    Count(
                        "VALUES",
                        "number of raw values that follow",
                        DATA32,
                        Direction.OUT,
                        each="raw value",
                        role=Role.RAW_READING,
                    ),
                ),
                effects=(Effect.WAITS, Effect.VARIES, Effect.READS),
                sentence="reads the raw values of {NO}, when it is ready",
            ),
            Command(
                29,
                "READY_SI",
                "Sets type and mode, waits until the device is ready and reads SI values",
                (
                    LAYER,
                    NO,
                    TYPE_TO_SET,
                    MODE_TO_SET,
                    Count(
                        "VALUES",
                        "number of values that follow, each in SI units",
                        DATAF,
                        Direction.OUT,
                        each="value in the mode's unit",
                        role=Role.SI_READING,
                    ),
                ),
                effects=(Effect.WAITS, Effect.VARIES, Effect.READS),
                sentence="reads {NO} in SI units, when it is ready",
                words="measure sensor",
            ),
            Command(
                30,
                "GET_MINMAX",
                "Reports the range of SI values of the current mode",
                (
                    LAYER,
                    NO,
                    Out("MIN", DATAF, "smallest value in SI units"),
                    Out("MAX", DATAF, "largest value in SI units"),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                31,
                "GET_BUMPS",
                "Reads how often a touch sensor changed to released since CLR_CHANGES",
                (LAYER, NO, Out("VALUE", DATAF, "number of changes, 0 for other sensors")),
                effects=(Effect.VARIES, Effect.READS),
            ),
        ),
    ),
    Opcode(
        0x9A,
        "INPUT_READ",
        "Sets type and mode and reads the first value in percent at once",
        (LAYER, NO, TYPE_TO_SET, MODE_TO_SET, Out("PCT", DATA8, "value, NaN if there is none", unit="%")),
        effects=(Effect.VARIES, Effect.READS),
        sentence="reads {NO} in percent",
    ),
    Opcode(
        0x9B,
        "INPUT_TEST",
        "Reports whether a device is still changing type or mode",
        (LAYER, NO, Out("BUSY", DATA8, "whether to wait", range=(0, 1), special={0: "ready", 1: "busy"})),
        effects=(Effect.VARIES, Effect.READS),
        sentence="asks whether {NO} is ready",
    ),
    Opcode(
        0x9C,
        "INPUT_READY",
        "Waits until a device has valid values",
        (LAYER, NO),
        effects=(Effect.WAITS, Effect.COMPUTES),
        sentence="waits until {NO} is ready",
    ),
    Opcode(
        0x9D,
        "INPUT_READSI",
        "Sets type and mode and reads the first value in SI units at once",
        (
            LAYER,
            NO,
            TYPE_TO_SET,
            MODE_TO_SET,
            Out("SI", DATAF, "value in the mode's unit, NaN if there is none", role=Role.SI_READING),
        ),
        effects=(Effect.VARIES, Effect.READS),
        sentence="reads {NO} in SI units",
        words="measure sensor",
    ),
    Opcode(
        0x9E,
        "INPUT_READEXT",
        "Sets type and mode and reads several values at once, in the format asked for",
        (
            LAYER,
            NO,
            TYPE_TO_SET,
            MODE_TO_SET,
            In("FORMAT", DATA8, "DATA_PCT, DATA_RAW or DATA_SI; others give NaN", enum=DATA_FORMAT),
            Count(
                "VALUES",
                "number of values that follow, each in FORMAT",
                "FORMAT",
                Direction.OUT,
                each="value in FORMAT",
            ),
        ),
        effects=(Effect.VARIES, Effect.READS),
    ),
    Opcode(
        0x9F,
        "INPUT_WRITE",
        "Sends bytes to a UART sensor",
        (
            LAYER,
            SENSOR_NO,
            In("BYTES", DATA8, "number of bytes to send", unit="bytes", range=(1, 32)),
            In("DATA", DATA8, "bytes to send", length="BYTES"),
        ),
        effects=(Effect.WRITES_TO_DEVICES,),
        words="reset gyro sensor",
    ),
    Opcode(
        0xE0,
        "INPUT_SET_CONN",
        "Sets how a port is connected, for ports whose automatic detection is off",
        (
            LAYER,
            SENSOR_NO,
            In("CONN", DATA8, "CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE", enum=CONN),
        ),
        effects=(Effect.CHANGES_SETTINGS,),
        dialects=EXTENSIONS,
    ),
    Opcode(
        0xE1,
        "INPUT_IIC_READ",
        "Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE",
        (LAYER, SENSOR_NO, RDLNG, RDDATA, Out("RESULT", DATA8, "OK or FAIL", enum=RESULT)),
        dialects=EXTENSIONS,
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0xE2,
        "INPUT_IIC_STATUS",
        "Reports the state of the I2C bus of a port",
        (LAYER, SENSOR_NO, Out("RESULT", DATA8, "state of the bus", enum=RESULT)),
        dialects=EXTENSIONS,
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0xE3,
        "INPUT_IIC_WRITE",
        "Sends bytes to an I2C sensor once, without waiting for its answer",
        (
            LAYER,
            SENSOR_NO,
            WRLNG,
            WRDATA,
            In("RDLNG", DATA8, "number of bytes in the sensor's answer", unit="bytes", range=(0, 32)),
            Out("RESULT", DATA8, "state of the bus after the request", enum=RESULT),
        ),
        effects=(Effect.WRITES_TO_DEVICES,),
        dialects=EXTENSIONS,
    ),
    Opcode(
        0xE4,
        "INPUT_SET_AUTOID",
        "Switches the automatic detection of sensors at a port on or off",
        (
            LAYER,
            SENSOR_NO,
            In("ENABLE", DATA8, "whether to detect", range=(0, 1), special={0: "off", 1: "on"}),
        ),
        effects=(Effect.CHANGES_SETTINGS,),
        dialects=EXTENSIONS,
    ),
)

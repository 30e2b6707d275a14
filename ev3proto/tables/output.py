"""Operations on motors: power, speed, limited and synchronised moves, tacho counts.

Most take a set of ports as a bit mask (NOS), a few the number of one port (NO).
"""

from ev3proto.tables.declaration import DATA8, DATA16, DATA32, UNRELEASED, Effect, In, Opcode, Out, Parameter, Role
from ev3proto.tables.enumerations import TYPE
from ev3proto.tables.ports import MotorPort, MotorPorts

MOST = 2**31 - 1
MOTOR_LETTERS = {port.value: port.name for port in MotorPort}
PORT_SETS = {0: "none"} | {
    mask: "+".join(port.name for port in MotorPort if mask & MotorPorts[port.name])
    for mask in range(1, MotorPorts.ALL + 1)
}
LETTERS = {letter: number for number, letter in MOTOR_LETTERS.items()}
MASKS = {letters: mask for mask, letters in PORT_SETS.items() if mask}

LAYER = In("LAYER", DATA8, "brick in the daisy chain, 0 is the one addressed", range=(0, 3), role=Role.LAYER)
NO = In(
    "NO",
    DATA8,
    "port, counted from 0",
    range=(0, 3),
    special=MOTOR_LETTERS,
    names=LETTERS,
    role=Role.MOTOR,
    note="the number of one port; most operations on motors take a bit mask",
)
NOS = In(
    "NOS",
    DATA8,
    "ports as a bit mask: A 1, B 2, C 4, D 8",
    range=(0, 15),
    special=PORT_SETS,
    names=MASKS,
    role=Role.MOTORS,
)
BRAKE = In("BRAKE", DATA8, "what the motors do at the end", range=(0, 1), special={0: "coast", 1: "brake and hold"})
POWER = In("POWER", DATA8, "unregulated power; negative: backward", unit="%", range=(-100, 100), role=Role.DRIVE)
SPEED = In("SPEED", DATA8, "regulated speed; negative: backward", unit="%", range=(-100, 100), role=Role.DRIVE)
TURN = In(
    "TURN",
    DATA16,
    "how tight the turn is, positive slows the higher port, negative the lower",
    range=(-200, 200),
    special={
        -200: "spin, lower port runs backward",
        -100: "lower port stands still",
        0: "straight",
        100: "higher port stands still",
        200: "spin, higher port runs backward",
    },
)
TACHO_LIMITS = (
    In("STEP1", DATA32, "angle of the ramp up", unit="degrees", range=(0, MOST)),
    In("STEP2", DATA32, "angle at constant drive", unit="degrees", range=(0, MOST)),
    In("STEP3", DATA32, "angle of the ramp down", unit="degrees", range=(0, MOST)),
)
TIME_LIMITS = (
    In("TIME1", DATA32, "time of the ramp up", unit="ms", range=(0, MOST)),
    In("TIME2", DATA32, "time at constant drive", unit="ms", range=(0, MOST)),
    In("TIME3", DATA32, "time of the ramp down", unit="ms", range=(0, MOST)),
)


def limited(number: int, name: str, text: str, drive: Parameter, limits: tuple[Parameter, ...]) -> Opcode:
    """Builds a move of independent motors that ends by itself after ramp up, constant drive and ramp down."""
    way = "runs {NOS} for" if limits is TIME_LIMITS else "turns {NOS} by"
    total = "+".join(limit.name for limit in limits)
    return Opcode(
        number,
        name,
        text,
        (LAYER, NOS, drive, *limits, BRAKE),
        effects=(Effect.STARTS_MOVE, Effect.RUNS_MOTORS),
        sentence=f"{way} {{{total}}} at {drive.name.lower()} {{{drive.name}}}[, then {{BRAKE}}]",
        words="turn rotate drive seconds" if limits is TIME_LIMITS else "turn rotate drive",
    )


OUTPUT = (
    Opcode(
        0xA0,
        "OUTPUT_GET_TYPE",
        "Reports the type of motor at a port; documented, but not implemented by any firmware",
        (LAYER, NO, Out("TYPE", DATA8, "type of the motor", enum=TYPE)),
        dialects=UNRELEASED,
        note="INPUT_DEVICE.GET_TYPEMODE with ports 16 to 19 reports the type of the motor at A to D",
    ),
    Opcode(
        0xA1,
        "OUTPUT_SET_TYPE",
        "Declares which type of motor is at a port",
        (
            LAYER,
            NO,
            In(
                "TYPE",
                DATA8,
                "type of the motor",
                enum=TYPE,
                note="an input that the firmware reads; some published tables call it an output",
            ),
        ),
        effects=(Effect.SETS_MOTORS,),
    ),
    Opcode(
        0xA2,
        "OUTPUT_RESET",
        "Sets the tacho counts that moves and OUTPUT_READ use to zero",
        (LAYER, NOS),
        effects=(Effect.SETS_MOTORS,),
        note="a phase of a move in progress starts over; a synchronous move ends, and both motors coast",
        sentence="resets the counts of {NOS}",
    ),
    Opcode(
        0xA3,
        "OUTPUT_STOP",
        "Stops motors",
        (LAYER, NOS, BRAKE),
        effects=(Effect.STOPS_MOTORS,),
        sentence="stops {NOS}[ ({BRAKE})]",
        words="stop brake halt float coast",
    ),
    Opcode(
        0xA4,
        "OUTPUT_POWER",
        "Sets the power of motors, which run at the next OUTPUT_START",
        (LAYER, NOS, POWER),
        effects=(Effect.SETS_MOTORS, Effect.AWAITS_START),
        note="a motor that runs by speed goes on as before, until OUTPUT_STOP and OUTPUT_START",
        sentence="sets the power of {NOS} to {POWER}",
    ),
    Opcode(
        0xA5,
        "OUTPUT_SPEED",
        "Sets the speed of motors, which run at the next OUTPUT_START",
        (LAYER, NOS, SPEED),
        effects=(Effect.SETS_MOTORS, Effect.AWAITS_START),
        note="a motor that runs by power goes on as before, until OUTPUT_STOP and OUTPUT_START",
        sentence="sets the speed of {NOS} to {SPEED}",
        words="velocity",
    ),
    Opcode(
        0xA6,
        "OUTPUT_START",
        "Starts motors with the power or speed set before",
        (LAYER, NOS),
        effects=(Effect.RUNS_MOTORS, Effect.STARTS_MOTORS),
        note="nothing changes for a motor that runs; after a move by speed a motor creeps until power or speed is set",
        sentence="starts {NOS}",
        words="turn run go",
    ),
    Opcode(
        0xA7,
        "OUTPUT_POLARITY",
        "Sets the direction of motors",
        (
            LAYER,
            NOS,
            In(
                "POL",
                DATA8,
                "direction",
                range=(-1, 1),
                special={-1: "backward", 0: "opposite of the current one", 1: "forward"},
            ),
        ),
        effects=(Effect.SETS_MOTORS,),
        note="the power that was set is put out at once, also without OUTPUT_START; a move in progress may not end, and"
        " synchronous moves ignore it",
        sentence="sets the direction of {NOS} to {POL}",
        words="reverse invert",
    ),
    Opcode(
        0xA8,
        "OUTPUT_READ",
        "Reads speed and tacho count of one motor, 0 on layers other than 0",
        (
            LAYER,
            NO,
            Out("SPEED", DATA8, "current speed", unit="%", range=(-100, 100)),
            Out("TACHO", DATA32, "angle in the current phase of a move; about 0 after one that brakes", unit="degrees"),
        ),
        note="each phase of a move takes its angle off the count; a motor that coasts leaves how far it ran on."
        " OUTPUT_GET_COUNT reads the angle that a motor has turned",
        effects=(Effect.VARIES, Effect.READS),
        sentence="reads speed and count of {NO}",
        words="encoder rotation position",
    ),
    Opcode(
        0xA9,
        "OUTPUT_TEST",
        "Reports whether one of the motors is still in a move that ends by itself",
        (LAYER, NOS, Out("BUSY", DATA8, "whether to wait", range=(0, 1), special={0: "ready", 1: "busy"})),
        effects=(Effect.WAITS, Effect.VARIES, Effect.READS),
        sentence="asks whether a move of {NOS} is still running",
    ),
    Opcode(
        0xAA,
        "OUTPUT_READY",
        "Waits until the moves of the motors have ended; ignores those from OUTPUT_START",
        (LAYER, NOS),
        effects=(Effect.WAITS, Effect.AWAITS_MOVE, Effect.COMPUTES),
        sentence="waits until the moves of {NOS} have ended",
    ),
    Opcode(
        0xAB,
        "OUTPUT_POSITION",
        "Reports the position of motors; documented, but not implemented by any firmware",
        (LAYER, NOS, Out("POS", DATA32, "position", unit="degrees")),
        dialects=UNRELEASED,
        note="OUTPUT_GET_COUNT reads the position of a motor as a sensor, OUTPUT_READ that in the current move",
    ),
    limited(0xAC, "OUTPUT_STEP_POWER", "Turns motors by an angle with unregulated power", POWER, TACHO_LIMITS),
    limited(0xAD, "OUTPUT_TIME_POWER", "Runs motors for a time with unregulated power", POWER, TIME_LIMITS),
    limited(0xAE, "OUTPUT_STEP_SPEED", "Turns motors by an angle with regulated speed", SPEED, TACHO_LIMITS),
    limited(0xAF, "OUTPUT_TIME_SPEED", "Runs motors for a time with regulated speed", SPEED, TIME_LIMITS),
    Opcode(
        0xB0,
        "OUTPUT_STEP_SYNC",
        "Turns two motors in step by an angle",
        (
            LAYER,
            NOS,
            SPEED,
            TURN,
            In("STEP", DATA32, "angle of the faster motor", unit="degrees", range=(0, MOST), special={0: "endless"}),
            BRAKE,
        ),
        effects=(Effect.STARTS_MOVE, Effect.RUNS_MOTORS, Effect.SYNCHRONIZES),
        sentence="turns {NOS} in step by {STEP} at speed {SPEED} with turn ratio {TURN}[, then {BRAKE}]",
        words="turn steer drive curve",
    ),
    Opcode(
        0xB1,
        "OUTPUT_TIME_SYNC",
        "Runs two motors in step for a time",
        (
            LAYER,
            NOS,
            SPEED,
            TURN,
            In("TIME", DATA32, "how long to run", unit="ms", range=(0, MOST), special={0: "endless"}),
            BRAKE,
        ),
        effects=(Effect.STARTS_MOVE, Effect.RUNS_MOTORS, Effect.SYNCHRONIZES),
        sentence="runs {NOS} in step for {TIME} at speed {SPEED} with turn ratio {TURN}[, then {BRAKE}]",
        words="turn steer drive curve seconds",
    ),
    Opcode(
        0xB2,
        "OUTPUT_CLR_COUNT",
        "Sets the tacho counts of motors read as sensors to zero",
        (LAYER, NOS),
        effects=(Effect.SETS_MOTORS,),
        sentence="sets the counts of {NOS} to zero",
        words="reset encoder zero",
    ),
    Opcode(
        0xB3,
        "OUTPUT_GET_COUNT",
        "Reads the tacho count of a motor read as a sensor",
        (
            LAYER,
            In(
                "NOS",
                DATA8,
                "port, counted from 0",
                range=(0, 3),
                special=MOTOR_LETTERS,
                names=LETTERS,
                role=Role.MOTOR,
                note="named like a bit mask, but the firmware reads the number of one port",
            ),
            Out("TACHO", DATA32, "angle since OUTPUT_CLR_COUNT", unit="degrees"),
        ),
        effects=(Effect.VARIES, Effect.READS),
        sentence="reads the count of {NOS}",
        words="encoder rotation position",
    ),
    Opcode(
        0xB4,
        "OUTPUT_PRG_STOP",
        "Stops and resets all motors as the end of a program does",
        effects=(Effect.STOPS_MOTORS,),
    ),
)

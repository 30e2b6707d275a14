"""Arithmetic and bit operations on numbers: adding to shifting in every size, the MATH functions, random numbers.

Most operations exist for every operand size; one line here builds all sizes of a plain one.
"""

from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, NUMBER_TYPES, Command, Effect, In, Opcode, Out


def _by_type(
    name: str, numbers: tuple[int, ...], text: str, first: str, second: str, result: str, unit: str | None = None
) -> tuple[Opcode, ...]:
    """Builds one operation for 8, 16, 32 bits and float, as far as numbers are given; `{}` in the text is the size.

    `unit` applies to the second operand.
    """
    return tuple(
        Opcode(
            number,
            name + suffix,
            text.format(size),
            (
                In("SOURCE1", type_, first),
                In("SOURCE2", type_, second, unit=unit),
                Out("DESTINATION", type_, result),
            ),
            effects=(Effect.READS,),
        )
        for number, (suffix, type_, size) in zip(numbers, NUMBER_TYPES, strict=False)
    )


X = In("X", DATAF, "number to work on")
R = Out("R", DATAF, "result")
ANGLE_IN = In("X", DATAF, "angle", unit="degrees")
ANGLE_OUT = Out("R", DATAF, "angle", unit="degrees")
DIVIDEND = "number to divide"
DIVISOR = "number to divide by"
REMAINDER = "remainder, with the sign of X"

MATH = (
    *_by_type("ADD", (0x10, 0x11, 0x12, 0x13), "Adds two {} numbers", "first number", "second number", "their sum"),
    *_by_type(
        "SUB",
        (0x14, 0x15, 0x16, 0x17),
        "Subtracts one {} number from another",
        "number to subtract from",
        "number to subtract",
        "SOURCE1 less SOURCE2",
    ),
    *_by_type(
        "MUL", (0x18, 0x19, 0x1A, 0x1B), "Multiplies two {} numbers", "first factor", "second factor", "their product"
    ),
    *_by_type(
        "DIV",
        (0x1C, 0x1D, 0x1E),
        "Divides two {} numbers; by zero gives the largest or smallest value",
        DIVIDEND,
        DIVISOR,
        "quotient, cut off towards zero (0 for 0 / 0)",
    ),
    Opcode(
        0x1F,
        "DIVF",
        "Divides two floating-point numbers; by zero gives infinity or NaN",
        (In("SOURCE1", DATAF, DIVIDEND), In("SOURCE2", DATAF, DIVISOR), Out("DESTINATION", DATAF, "quotient")),
        effects=(Effect.READS,),
    ),
    *_by_type(
        "OR", (0x20, 0x21, 0x22), "Combines {} values, bit by bit, by OR", "first", "second", "bits set in either"
    ),
    *_by_type(
        "AND", (0x24, 0x25, 0x26), "Combines {} values, bit by bit, by AND", "first", "second", "bits set in both"
    ),
    *_by_type(
        "XOR",
        (0x28, 0x29, 0x2A),
        "Combines {} values, bit by bit, by exclusive OR",
        "first",
        "second",
        "bits set in just one of the two",
    ),
    *_by_type(
        "RL",
        (0x2C, 0x2D, 0x2E),
        "Shifts {} values left; despite the name (rotate), bits shifted out on the left are lost",
        "value to shift",
        "number of places",
        "shifted value, filled up with zero bits",
        unit="bits",
    ),
    Opcode(
        0x8D,
        "MATH",
        "Applies a mathematical function",
        commands=(
            Command(1, "EXP", "Raises e to a power", (In("X", DATAF, "the power"), R), effects=(Effect.READS,)),
            Command(
                2,
                "MOD",
                "Takes the remainder of a floating-point division",
                (In("X", DATAF, DIVIDEND), In("Y", DATAF, DIVISOR), Out("R", DATAF, REMAINDER)),
                effects=(Effect.READS,),
            ),
            Command(3, "FLOOR", "Rounds down to a whole number", (X, R), effects=(Effect.READS,)),
            Command(4, "CEIL", "Rounds up to a whole number", (X, R), effects=(Effect.READS,)),
            Command(
                5, "ROUND", "Rounds to the nearest whole number, halves away from zero", (X, R), effects=(Effect.READS,)
            ),
            Command(6, "ABS", "Drops the sign", (X, R), effects=(Effect.READS,)),
            Command(7, "NEGATE", "Reverses the sign", (X, R), effects=(Effect.READS,)),
            Command(
                8,
                "SQRT",
                "Takes the square root",
                (In("X", DATAF, "number to work on, not negative"), R),
                effects=(Effect.READS,),
            ),
            Command(
                9,
                "LOG",
                "Takes the logarithm to base 10",
                (In("X", DATAF, "number to work on, above 0"), R),
                effects=(Effect.READS,),
            ),
            Command(
                10,
                "LN",
                "Takes the natural logarithm",
                (In("X", DATAF, "number to work on, above 0"), R),
                effects=(Effect.READS,),
            ),
            Command(
                11,
                "SIN",
                "Takes the sine of an angle in degrees",
                (ANGLE_IN, Out("R", DATAF, "sine, -1 to 1")),
                effects=(Effect.READS,),
            ),
            Command(
                12,
                "COS",
                "Takes the cosine of an angle in degrees",
                (ANGLE_IN, Out("R", DATAF, "cosine, -1 to 1")),
                effects=(Effect.READS,),
            ),
            Command(
                13,
                "TAN",
                "Takes the tangent of an angle in degrees",
                (ANGLE_IN, Out("R", DATAF, "tangent")),
                effects=(Effect.READS,),
            ),
            Command(
                14,
                "ASIN",
                "Finds the angle that has a sine",
                (In("X", DATAF, "sine", range=(-1, 1)), ANGLE_OUT),
                effects=(Effect.READS,),
            ),
            Command(
                15,
                "ACOS",
                "Finds the angle that has a cosine",
                (In("X", DATAF, "cosine", range=(-1, 1)), ANGLE_OUT),
                effects=(Effect.READS,),
            ),
            Command(
                16,
                "ATAN",
                "Finds the angle that has a tangent",
                (In("X", DATAF, "tangent"), ANGLE_OUT),
                effects=(Effect.READS,),
            ),
            Command(
                17,
                "MOD8",
                "Takes the remainder of an 8-bit division",
                (In("X", DATA8, DIVIDEND), In("Y", DATA8, DIVISOR + ", not 0"), Out("R", DATA8, REMAINDER)),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                18,
                "MOD16",
                "Takes the remainder of a 16-bit division",
                (In("X", DATA16, DIVIDEND), In("Y", DATA16, DIVISOR + ", not 0"), Out("R", DATA16, REMAINDER)),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                19,
                "MOD32",
                "Takes the remainder of a 32-bit division",
                (In("X", DATA32, DIVIDEND), In("Y", DATA32, DIVISOR + ", not 0"), Out("R", DATA32, REMAINDER)),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                20,
                "POW",
                "Raises a number to a power",
                (In("X", DATAF, "number to raise"), In("Y", DATAF, "the power"), R),
                effects=(Effect.READS,),
            ),
            Command(
                21,
                "TRUNC",
                "Cuts off decimals without rounding",
                (X, In("P", DATA8, "number of decimals to keep (at most 6 are available)", range=(0, 9)), R),
                effects=(Effect.READS,),
            ),
        ),
    ),
    Opcode(
        0x8E,
        "RANDOM",
        "Draws a random whole number",
        (
            In("MIN", DATA16, "smallest number to draw"),
            In("MAX", DATA16, "largest number to draw"),
            Out("VALUE", DATA16, "the number drawn, MIN to MAX, both included"),
        ),
        effects=(Effect.VARIES, Effect.READS),
    ),
)

"""Jumps inside a program or a direct command: always, on a flag, or on a comparison of two numbers.

Each comparison exists for every operand size; one line here builds all sizes of it.
"""

from ev3proto.tables.declaration import DATA8, DATAF, LABEL, NUMBER_TYPES, Effect, In, Opcode, Role

OFFSET = In(
    "OFFSET",
    LABEL,
    "how far to jump from the end of this operation; negative jumps back; or a label",
    unit="bytes",
    role=Role.JUMP,
)
FLAG = In("FLAG", DATA8, "the condition: anything but 0 is true", special={0: "false", 1: "true"})


def _by_type(name: str, numbers: tuple[int, int, int, int], relation: str) -> tuple[Opcode, ...]:
    """Builds one conditional jump on 8, 16, 32 bits and float."""
    return tuple(
        Opcode(
            number,
            name + suffix,
            f"Jumps if LEFT is {relation} RIGHT, as {size} numbers",
            (
                In("LEFT", type_, "left side of the comparison"),
                In("RIGHT", type_, "right side of the comparison"),
                OFFSET,
            ),
            effects=(Effect.COMPUTES,),
        )
        for number, (suffix, type_, size) in zip(numbers, NUMBER_TYPES, strict=True)
    )


BRANCH = (
    Opcode(
        0x40,
        "JR",
        "Jumps always",
        (OFFSET,),
        effects=(Effect.JUMPS_ALWAYS, Effect.COMPUTES),
    ),
    Opcode(0x41, "JR_FALSE", "Jumps if a flag is 0", (FLAG, OFFSET), effects=(Effect.COMPUTES,)),
    Opcode(0x42, "JR_TRUE", "Jumps if a flag is not 0", (FLAG, OFFSET), effects=(Effect.COMPUTES,)),
    Opcode(
        0x43,
        "JR_NAN",
        "Jumps if a value is not a number, as read from a sensor without data",
        (In("VALUE", DATAF, "value to look at"), OFFSET),
        effects=(Effect.COMPUTES,),
    ),
    *_by_type("JR_LT", (0x64, 0x65, 0x66, 0x67), "less than"),
    *_by_type("JR_GT", (0x68, 0x69, 0x6A, 0x6B), "greater than"),
    *_by_type("JR_EQ", (0x6C, 0x6D, 0x6E, 0x6F), "equal to"),
    *_by_type("JR_NEQ", (0x70, 0x71, 0x72, 0x73), "different from"),
    *_by_type("JR_LTEQ", (0x74, 0x75, 0x76, 0x77), "less than or equal to"),
    *_by_type("JR_GTEQ", (0x78, 0x79, 0x7A, 0x7B), "greater than or equal to"),
)

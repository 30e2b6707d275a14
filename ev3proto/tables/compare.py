"""Comparing two numbers into a flag, and choosing one of two values by a flag, in every size.

The same operation exists once per size of its operands, so all of them are built size by size from one line each.
"""

from ev3proto.tables.declaration import DATA8, NUMBER_TYPES, Effect, In, Opcode, Out


def _by_type(name: str, numbers: tuple[int, int, int, int], relation: str) -> tuple[Opcode, ...]:
    """The same comparison on 8, 16, 32 bits and float."""
    return tuple(
        Opcode(
            number,
            name + suffix,
            f"Tests whether LEFT is {relation} RIGHT, as {size} numbers",
            (
                In("LEFT", type_, "left side of the comparison"),
                In("RIGHT", type_, "right side of the comparison"),
                Out("FLAG", DATA8, "result of the comparison", range=(0, 1), special={0: "false", 1: "true"}),
            ),
            effects=(Effect.READS,),
        )
        for number, (suffix, type_, size) in zip(numbers, NUMBER_TYPES, strict=True)
    )


def _select_by_type(numbers: tuple[int, int, int, int]) -> tuple[Opcode, ...]:
    """SELECT on 8, 16, 32 bits and float."""
    return tuple(
        Opcode(
            number,
            "SELECT" + suffix,
            f"Selects one of two {size} values by a flag",
            (
                In("FLAG", DATA8, "which one: anything but 0 selects SOURCE1", special={0: "SOURCE2", 1: "SOURCE1"}),
                In("SOURCE1", type_, "value selected if the flag is set"),
                In("SOURCE2", type_, "value selected if the flag is 0"),
                Out("RESULT", type_, "the selected value"),
            ),
            effects=(Effect.READS,),
        )
        for number, (suffix, type_, size) in zip(numbers, NUMBER_TYPES, strict=True)
    )


COMPARE = (
    *_by_type("CP_LT", (0x44, 0x45, 0x46, 0x47), "less than"),
    *_by_type("CP_GT", (0x48, 0x49, 0x4A, 0x4B), "greater than"),
    *_by_type("CP_EQ", (0x4C, 0x4D, 0x4E, 0x4F), "equal to"),
    *_by_type("CP_NEQ", (0x50, 0x51, 0x52, 0x53), "different from"),
    *_by_type("CP_LTEQ", (0x54, 0x55, 0x56, 0x57), "less than or equal to"),
    *_by_type("CP_GTEQ", (0x58, 0x59, 0x5A, 0x5B), "greater than or equal to"),
    *_select_by_type((0x5C, 0x5D, 0x5E, 0x5F)),
)

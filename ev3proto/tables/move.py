"""Copying values between variables: between sizes, into consecutive bytes, from and to elements of an array.

All operations but one exist for every operand size and are built for each.
"""

from ev3proto.tables.declaration import (
    DATA8,
    DATA16,
    DATA32,
    DATAF,
    NUMBER_TYPES,
    Effect,
    In,
    Opcode,
    Out,
    Role,
    Type,
    Values,
)

INDEX = In(
    "INDEX",
    DATA8,
    "which element, counted from 0; the firmware does not check it",
    range=(0, 127),
    role=Role.INDEX,
)


def _moves_from(name: str, source: Type, size: str, numbers: tuple[int, int, int, int]) -> tuple[Opcode, ...]:
    """Builds the copies from one type to each of the four."""
    return tuple(
        Opcode(
            number,
            f"MOVE{name}_{suffix}",
            _move_text(source, size, destination, to),
            (In("SOURCE", source, "value to copy"), Out("DESTINATION", destination, "copy of the value")),
            effects=(Effect.READS,),
        )
        for number, (suffix, destination, to) in zip(numbers, NUMBER_TYPES, strict=True)
    )


def _move_text(source: Type, size: str, destination: Type, to: str) -> str:
    if source is destination:
        return f"Copies a value to another variable, both {to}"
    types = [type_ for _, type_, _ in NUMBER_TYPES]
    limited = types.index(destination) < types.index(source)
    return f"Converts a value, {size} to {to}; " + (
        "limited to what fits, NaN stays NaN" if limited else "NaN stays NaN"
    )


def _reads(numbers: tuple[int, int, int, int]) -> tuple[Opcode, ...]:
    """Builds READ on 8, 16, 32 bits and float."""
    return tuple(
        Opcode(
            number,
            "READ" + suffix,
            f"Reads one element of an array of {size} values",
            (
                In("SOURCE", type_, "first element of the array, as a variable", indexed_by="INDEX"),
                INDEX,
                Out("DESTINATION", type_, "the element's value"),
            ),
            effects=(Effect.COMPUTES,),
        )
        for number, (suffix, type_, size) in zip(numbers, NUMBER_TYPES, strict=True)
    )


def _writes(numbers: tuple[int, int, int, int]) -> tuple[Opcode, ...]:
    """Builds WRITE on 8, 16, 32 bits and float."""
    return tuple(
        Opcode(
            number,
            "WRITE" + suffix,
            f"Writes one element of an array of {size} values",
            (
                In("SOURCE", type_, "value to write"),
                INDEX,
                In(
                    "DESTINATION",
                    type_,
                    "first element of the array, as a variable; element INDEX is written",
                    indexed_by="INDEX",
                    stores=True,
                ),
            ),
            effects=(Effect.READS,),
        )
        for number, (suffix, type_, size) in zip(numbers, NUMBER_TYPES, strict=True)
    )


MOVE = (
    Opcode(
        0x2F,
        "INIT_BYTES",
        "Fills consecutive bytes of memory with constant values",
        (
            Out("DESTINATION", DATA8, "first byte to fill", length="LENGTH"),
            In("LENGTH", DATA32, "number of values that follow; a negative count hangs the brick", unit="bytes"),
            Values("SOURCE", "the values, one per byte", DATA8, each="value of one byte"),
        ),
        effects=(Effect.READS,),
    ),
    *_moves_from("8", DATA8, "8-bit", (0x30, 0x31, 0x32, 0x33)),
    *_moves_from("16", DATA16, "16-bit", (0x34, 0x35, 0x36, 0x37)),
    *_moves_from("32", DATA32, "32-bit", (0x38, 0x39, 0x3A, 0x3B)),
    *_moves_from("F", DATAF, "floating-point", (0x3C, 0x3D, 0x3E, 0x3F)),
    *_reads((0xC8, 0xC9, 0xCA, 0xCB)),
    *_writes((0xCC, 0xCD, 0xCE, 0xCF)),
)

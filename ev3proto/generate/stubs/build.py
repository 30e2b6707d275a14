"""All stub files of the package, as text."""

from __future__ import annotations

from ev3proto.generate.stubs import enumerations, operations, system_commands


def build() -> dict[str, str]:
    """Each file by its path below the project's folder; the same text every time."""
    return {
        "ev3proto/enums/__init__.pyi": enumerations.stub(),
        "ev3proto/ops/__init__.pyi": operations.stub("official"),
        "ev3proto/ops/compat.pyi": operations.stub("compat"),
        "ev3proto/ops/xtended.pyi": operations.stub("xtended"),
        "ev3proto/system/__init__.pyi": system_commands.stub(),
    }

"""The generated modules of the package itself: `ev3proto.ops`, `ev3proto.enums`, `ev3proto.system`.

They are Python files that people open, jump to and read, and that type checkers and editors follow without help.
"""

from __future__ import annotations

from ev3proto.generate.modules import argument_types, enumerations, operations, system_commands
from ev3proto.tables.declaration import DIALECTS

FOLDERS = ("ev3proto/ops", "ev3proto/enums", "ev3proto/system")
"""Their folders. A Python file there that has the generated mark and is not generated now is stale."""


def build() -> dict[str, str]:
    """Generates each file by its path in the project's folder; the same text every time."""
    files = {
        "ev3proto/enums/__init__.py": enumerations.module(),
        "ev3proto/ops/argument_types.py": argument_types.module(),
        "ev3proto/system/__init__.py": system_commands.module(),
        "ev3proto/system/bootloader.py": system_commands.bootloader_module(),
    }
    for dialect in DIALECTS:
        files |= operations.modules(dialect)
    return files

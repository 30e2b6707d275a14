"""The generated parts of the package itself: `ev3proto.ops`, `ev3proto.enums`, `ev3proto.system`.

They are Python files that people open, jump to and read, and that type checkers and editors follow without help.
"""

from ev3proto.generate.modules.build import FOLDERS, build

__all__ = ["FOLDERS", "build"]

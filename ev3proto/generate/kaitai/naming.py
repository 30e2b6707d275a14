"""Names in a description: lower case, and never a reserved word of a target language."""

from __future__ import annotations

from ev3proto.tables.declaration import Declaration, Parameter
from ev3proto.tables.system import SystemDeclaration, SystemField

_WORDS = """
    abstract and as assert async await base bool boolean break byte case catch chan char class const continue
    debugger decimal def default defer del delegate delete do double elif else end enum event except explicit
    export extends extern false final finally fixed float fn for foreach from func function global go goto if
    implements implicit import in instanceof int interface internal is lambda let local lock long map match mod
    module mut namespace native new nil none nonlocal not null object operator or out override package params
    parent pass private protected pub public raise range readonly ref register return root sbyte sealed select
    self short signed sizeof stackalloc static string struct super switch synchronized template this throw
    throws to_s trait transient true try type typedef typeof uint ulong unchecked union unsafe unsigned use
    ushort using var virtual void volatile while with yield
"""

RESERVED = frozenset(_WORDS.split())
"""Reserved words of the languages that parsers are generated in."""


def identifier(name: str) -> str:
    """Turns a name of the tables into one that a description may have."""
    lower = name.lower()
    return f"{lower}_" if lower in RESERVED else lower


def parameter_name(parameter: Parameter) -> str:
    """Returns the name of a parameter's argument."""
    return identifier(parameter.name)


def operation_type(declaration: Declaration) -> str:
    """Returns the name of an operation's type: `op_sound_tone`, `op_ui_flush`."""
    return f"op_{declaration.name.replace('.', '_').lower()}"


def family_type(name: str) -> str:
    """Returns the name of a family's type: `family_sound`."""
    return f"family_{name.lower()}"


def system_name(command: SystemDeclaration) -> str:
    """Returns `list_files`, `bootloader_start_app`: the bootloader shares names with the firmware."""
    return ("bootloader_" if command.bootloader else "") + command.name.lower()


def field_name(field: SystemField) -> str:
    """Returns the name of a system message's field."""
    return identifier(field.name)

"""What the fields of system messages are called in Wireshark's filters.

Most are called as in the tables. Some have had other names since the first dissectors for the EV3, and people have
filters, columns and colouring rules with them: those names stay.
"""

from __future__ import annotations

from ev3proto.tables.system import Field, SystemCommand

FAMILIAR = {
    "size": "file_len",
    "hardware_version": "hw_id",
    "firmware_version": "fw_id",
    "name": "mailbox",
    "name_length": "mailbox_length",
}
"""Names of fields that differ from those in the tables."""

HEXADECIMAL = ("address", "checksum", "hardware_version", "firmware_version")
"""Numbers that people write in hexadecimal."""


def filter_name(command: SystemCommand, field: Field) -> str:
    """What follows `ev3.` in the name of a system message's field."""
    if field.name == "path":
        # A path is a file's where the command or its reply says how long the file is.
        fields = (*command.request, *command.reply)
        return "file_name" if any(other.name == "size" for other in fields) else "path_name"
    return FAMILIAR.get(field.name, field.name)


def label(field: Field) -> str:
    """What stands before the value: `Max bytes`."""
    return field.name.replace("_", " ").capitalize()

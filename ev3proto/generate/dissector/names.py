"""The names of system messages' fields in Wireshark's filters.

Most are the names in the tables. Some have had other names since the first dissectors for the EV3, and people have
filters, columns and colouring rules with those: they are kept.
"""

from __future__ import annotations

from ev3proto.tables.system import SystemDeclaration, SystemField

FAMILIAR = {
    "size": "file_len",
    "hardware_version": "hw_id",
    "firmware_version": "fw_id",
    "name": "mailbox",
    "name_length": "mailbox_length",
}
"""Filter names that differ from the tables."""

HEXADECIMAL = ("address", "checksum", "hardware_version", "firmware_version")
"""Numbers usually written in hexadecimal."""


def filter_name(command: SystemDeclaration, field: SystemField) -> str:
    """Returns what follows `ev3.` in the filter name of a system message's field."""
    if field.name == "path":
        # A path belongs to a file if the command or its reply gives the file's length.
        fields = (*command.request, *command.reply)
        return "file_name" if any(other.name == "size" for other in fields) else "path_name"
    return FAMILIAR.get(field.name, field.name)


def label(field: SystemField) -> str:
    """Returns the label of a field in the packet tree: `Max bytes`."""
    return field.name.replace("_", " ").capitalize()

"""FILENAME: splits and checks file names, and packs files.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["check", "exist", "get_foldername", "merge", "pack", "split", "totalsize", "unpack"]

_OPERATIONS = drafts("official")


def exist(name: Text, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a file or folder exists.

    Args:
        name: Path of the file; a bare name is taken from the program's own folder; at most 119 characters; string.
        flag: Whether it exists; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.EXIST"].draft((name, flag), unchecked)


def totalsize(name: Text, files: Output = None, size: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports the number of files in a folder and their size.

    Args:
        name: Path of the folder or file; string.
        files: Number of entries, including . and ..; 0 for a file; DATA32; an output, in global memory when omitted.
        size: Size of all of them, rounded up; KiB; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.TOTALSIZE"].draft((name, files, size), unchecked)


def split(
    filename: Text,
    length: Number,
    folder: Output = None,
    name: Output = None,
    ext: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Splits a path into folder, name and extension.

    Args:
        filename: The path; string.
        length: Buffer size for each of the three parts, including the zero; bytes; DATA8.
        folder: The folder, with its closing slash on LEGO's firmware; as many bytes as LENGTH says; string; an output,
            in global memory when omitted.
        name: The name, without folder and extension; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        ext: The extension with its dot; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.SPLIT"].draft((filename, length, folder, name, ext), unchecked)


def merge(
    folder: Text,
    name: Text,
    ext: Text,
    length: Number,
    filename: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Builds a path from folder, name and extension.

    Args:
        folder: The folder, without a slash at its end; string.
        name: The name; string.
        ext: The extension with its dot; string.
        length: Size of the string's buffer, including the zero; bytes; DATA8.
        filename: The path; as many bytes as LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.MERGE"].draft((folder, name, ext, length, filename), unchecked)


def check(filename: Text, ok: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a path's characters and lengths are allowed; the file need not exist.

    Args:
        filename: The path; string.
        ok: Whether the path can be used; 0: not allowed; 1: allowed; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.CHECK"].draft((filename, ok), unchecked)


def pack(filename: Text, *, unchecked: bool = False) -> Draft:
    """Packs a file or folder into a .raf archive beside it.

    Args:
        filename: Path of the file or folder; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.PACK"].draft((filename,), unchecked)


def unpack(filename: Text, *, unchecked: bool = False) -> Draft:
    """Unpacks a .raf archive into the folder it is in.

    Args:
        filename: Path of the archive; its extension is replaced by .raf; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.UNPACK"].draft((filename,), unchecked)


def get_foldername(length: Number, foldername: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the path of the program's own folder.

    Args:
        length: Size of the string's buffer, including the zero; bytes; DATA8.
        foldername: Path of the folder, without a slash at its end; as many bytes as LENGTH says; string; an output, in
            global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILENAME.GET_FOLDERNAME"].draft((length, foldername), unchecked)

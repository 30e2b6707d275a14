"""FILE: works on files, folders, data logs, program images and the list of recent files.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyDEL, AnySLOT, Elements, Number, Output, Real, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "close",
    "close_log",
    "del_cache_file",
    "del_subfolder",
    "get_cache_file",
    "get_cache_files",
    "get_folders",
    "get_handle",
    "get_image",
    "get_item",
    "get_log_name",
    "get_log_sync_time",
    "get_pool",
    "get_subfolder_name",
    "load_image",
    "make_folder",
    "move",
    "open_append",
    "open_log",
    "open_read",
    "open_write",
    "put_cache_file",
    "read_bytes",
    "read_text",
    "read_value",
    "remove",
    "set_log_sync_time",
    "write_bytes",
    "write_log",
    "write_text",
    "write_value",
]

_OPERATIONS = drafts("official")


def open_append(name: Text, handle: Output = None, *, unchecked: bool = False) -> Draft:
    """Opens a file for appending; creates it if it does not exist.

    Args:
        name: Path of the file; a bare name is taken from the program's own folder; at most 119 characters; string.
        handle: Handle of the opened file; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.OPEN_APPEND"].draft((name, handle), unchecked)


def open_read(name: Text, handle: Output = None, size: Output = None, *, unchecked: bool = False) -> Draft:
    """Opens a file for reading.

    Args:
        name: Path of the file; a bare name is taken from the program's own folder; at most 119 characters; string.
        handle: Handle of the opened file; handle; an output, in global memory when omitted.
        size: Size of the file; bytes; 0: not found; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.OPEN_READ"].draft((name, handle, size), unchecked)


def open_write(name: Text, handle: Output = None, *, unchecked: bool = False) -> Draft:
    """Creates or truncates a file and opens it for writing.

    Args:
        name: Path of the file; a bare name is taken from the program's own folder; at most 119 characters; string.
        handle: Handle of the opened file; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.OPEN_WRITE"].draft((name, handle), unchecked)


def read_value(handle: Number, del_: AnyDEL, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the text up to the next delimiter and turns it into a number.

    Args:
        handle: The open file; handle.
        del_: Separator between two values in the file; a member of DEL; DATA8.
        value: The number, 0 if the text is not a number; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.READ_VALUE"].draft((handle, del_, value), unchecked)


def write_value(
    handle: Number,
    del_: AnyDEL,
    value: Real,
    figures: Number,
    decimals: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes a number as text, and a delimiter after it.

    Args:
        handle: The open file; handle.
        del_: Separator between two values in the file; a member of DEL; DATA8.
        value: The number; DATAF.
        figures: Minimum width in characters, including the decimal point; DATA8.
        decimals: Digits after the decimal point; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.WRITE_VALUE"].draft((handle, del_, value, figures, decimals), unchecked)


def read_text(handle: Number, del_: AnyDEL, length: Number, text: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads text up to the next delimiter.

    Args:
        handle: The open file; handle.
        del_: Separator between two values in the file; a member of DEL; DATA8.
        length: Maximum number of bytes to read; LEGO's firmware keeps the low 8 bits, so 127; bytes; DATA16.
        text: The text, without a zero at its end if it fills the whole buffer; as many bytes as LENGTH says; string; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.READ_TEXT"].draft((handle, del_, length, text), unchecked)


def write_text(handle: Number, del_: AnyDEL, text: Text, *, unchecked: bool = False) -> Draft:
    """Writes text without its zero, and a delimiter after it.

    Args:
        handle: The open file; handle.
        del_: Separator between two values in the file; a member of DEL; DATA8.
        text: The text; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.WRITE_TEXT"].draft((handle, del_, text), unchecked)


def close(handle: Number, *, unchecked: bool = False) -> Draft:
    """Closes a file and frees its handle.

    Args:
        handle: The open file; handle.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.CLOSE"].draft((handle,), unchecked)


def load_image(prgid: AnySLOT, name: Text, size: Output = None, ip: Output = None, *, unchecked: bool = False) -> Draft:
    """Loads a program file into a stopped slot, for PROGRAM_START to run.

    Args:
        prgid: Slot to load it into; 0 to 4; a member of SLOT; DATA16.
        name: Path of the program, relative to /home/root/lms2012/sys; .rbf may be omitted; at most 119 characters;
            string.
        size: Size of the program; bytes; 0: not loaded; DATA32; an output, in global memory when omitted.
        ip: Where it was loaded, for PROGRAM_START; 0: not loaded; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.LOAD_IMAGE"].draft((prgid, name, size, ip), unchecked)


def get_handle(name: Text, handle: Output = None, write: Output = None, *, unchecked: bool = False) -> Draft:
    """Finds the handle of a file that is already open.

    Args:
        name: Path of the file; a bare name is taken from the program's own folder; at most 119 characters; string.
        handle: The open file; -1: not open; handle; an output, in global memory when omitted.
        write: Whether it is open for writing or appending; 0: no; 1: yes; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_HANDLE"].draft((name, handle, write), unchecked)


def make_folder(name: Text, success: Output = None, *, unchecked: bool = False) -> Draft:
    """Creates a folder unless it exists.

    Args:
        name: Path of the folder, relative to /home/root/lms2012/sys; at most 119 characters; string.
        success: Whether the folder exists now; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.MAKE_FOLDER"].draft((name, success), unchecked)


def get_pool(size: Number, handle: Output = None, ip: Output = None, *, unchecked: bool = False) -> Draft:
    """Reserves a block of memory for the program.

    Args:
        size: How much memory; 1 to 6000000 bytes; DATA32.
        handle: Handle of the block; handle; an output, in global memory when omitted.
        ip: Address of the block; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_POOL"].draft((size, handle, ip), unchecked)


def set_log_sync_time(time: Number, tick: Number, *, unchecked: bool = False) -> Draft:
    """Stores the time and tick to which data logs are aligned.

    Args:
        time: The common time; DATA32.
        tick: The brick's tick at that time; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.SET_LOG_SYNC_TIME"].draft((time, tick), unchecked)


def get_folders(name: Text, items: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the entries of a folder, without hidden ones.

    Args:
        name: Path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string.
        items: Number of entries; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_FOLDERS"].draft((name, items), unchecked)


def get_log_sync_time(time: Output = None, tick: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the time and tick to which data logs are aligned.

    Args:
        time: The common time; DATA32; an output, in global memory when omitted.
        tick: The brick's tick at that time; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_LOG_SYNC_TIME"].draft((time, tick), unchecked)


def get_subfolder_name(
    name: Text,
    item: Number,
    length: Number,
    string: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads the name of one entry of a folder.

    Args:
        name: Path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string.
        item: Which entry of the folder, the first is 1; 1 to 127; DATA8.
        length: Size of the string's buffer, including the zero; bytes; DATA8.
        string: Its name without extension, empty if there is no such entry; as many bytes as LENGTH says; string; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_SUBFOLDER_NAME"].draft((name, item, length, string), unchecked)


def write_log(handle: Number, time: Number, items: Number, values: Elements, *, unchecked: bool = False) -> Draft:
    """Adds one row of samples to a data log.

    Args:
        handle: The open data log; handle.
        time: Time of the samples since the log began; ms; DATA32.
        items: Number of samples; with 0 nothing is written; 0 to 127; DATA8.
        values: The samples, in one array; as many values as ITEMS says; DATAF.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.WRITE_LOG"].draft((handle, time, items, values), unchecked)


def close_log(handle: Number, name: Text, *, unchecked: bool = False) -> Draft:
    """Writes the rest of a data log and closes it.

    Args:
        handle: The open data log; handle.
        name: Path of the log as given to OPEN_LOG; .rdf may be omitted; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.CLOSE_LOG"].draft((handle, name), unchecked)


def get_image(name: Text, prgid: AnySLOT, item: Number, ip: Output = None, *, unchecked: bool = False) -> Draft:
    """Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails.

    Args:
        name: Path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string.
        prgid: Slot to load it into; a member of SLOT; DATA16.
        item: Which entry of the folder, the first is 1; 1 to 127; DATA8.
        ip: Where it was loaded; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_IMAGE"].draft((name, prgid, item, ip), unchecked)


def get_item(name: Text, string: Text, item: Output = None, *, unchecked: bool = False) -> Draft:
    """Finds an entry of a folder by its name.

    Args:
        name: Path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string.
        string: Name to look for, without extension; string.
        item: Number of the entry; the first is 1; 1 to 127; 0: not found; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_ITEM"].draft((name, string, item), unchecked)


def get_cache_files(items: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the recently run files.

    Args:
        items: Number of files, at most 10; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_CACHE_FILES"].draft((items,), unchecked)


def put_cache_file(string: Text, *, unchecked: bool = False) -> Draft:
    """Puts a file first in the list of recently run files.

    Args:
        string: Path of the file; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.PUT_CACHE_FILE"].draft((string,), unchecked)


def get_cache_file(item: Number, length: Number, string: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the path of one recently run file.

    Args:
        item: Which one, 1 is the latest; 1 to 10; DATA8.
        length: Size of the string's buffer, including the zero; bytes; DATA8.
        string: Path of the file, empty if there is none; as many bytes as LENGTH says; string; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_CACHE_FILE"].draft((item, length, string), unchecked)


def del_cache_file(string: Text, *, unchecked: bool = False) -> Draft:
    """Removes a file from the list of recently run files.

    Args:
        string: Path of the file, as given to PUT_CACHE_FILE; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.DEL_CACHE_FILE"].draft((string,), unchecked)


def del_subfolder(name: Text, item: Number, *, unchecked: bool = False) -> Draft:
    """Deletes one entry of a folder together with the files in it.

    Args:
        name: Path of the folder with its closing slash, such as ../prjs/; at most 119 characters; string.
        item: Which entry of the folder, the first is 1; 1 to 127; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.DEL_SUBFOLDER"].draft((name, item), unchecked)


def get_log_name(length: Number, name: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the path of the open data log.

    Args:
        length: Size of the string's buffer, including the zero; bytes; DATA8.
        name: Path of the log, empty if none is open; as many bytes as LENGTH says; string; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.GET_LOG_NAME"].draft((length, name), unchecked)


def open_log(
    name: Text,
    syncedtime: Number,
    syncedtick: Number,
    nowtick: Number,
    sample_interval_in_ms: Number,
    duration_in_ms: Number,
    sdata: Text,
    handle: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Creates a data log and writes its header.

    Args:
        name: Path of the log; .rdf may be omitted; with an empty one it stays in memory; string.
        syncedtime: The common time, as GET_LOG_SYNC_TIME returns it; DATA32.
        syncedtick: The brick's tick at that time; DATA32.
        nowtick: The brick's tick at the start of the log; DATA32.
        sample_interval_in_ms: Time between samples; fast logs are kept in memory first; ms; DATA32.
        duration_in_ms: Duration of the log; ms; DATA32.
        sdata: Text that describes the sensors, copied into the header; string.
        handle: Handle of the log; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.OPEN_LOG"].draft(
        (name, syncedtime, syncedtick, nowtick, sample_interval_in_ms, duration_in_ms, sdata, handle), unchecked
    )


def read_bytes(handle: Number, bytes: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads raw bytes from a file.

    Args:
        handle: The open file; handle.
        bytes: Number of bytes; 0 to 32767 bytes; DATA16.
        destination: The bytes; followed by a zero if the file ended early; as many values as BYTES says; DATA8; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.READ_BYTES"].draft((handle, bytes, destination), unchecked)


def write_bytes(handle: Number, bytes: Number, source: Elements, *, unchecked: bool = False) -> Draft:
    """Writes raw bytes to a file.

    Args:
        handle: The open file; handle.
        bytes: Number of bytes; 0 to 32767 bytes; DATA16.
        source: The bytes; as many values as BYTES says; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.WRITE_BYTES"].draft((handle, bytes, source), unchecked)


def remove(name: Text, *, unchecked: bool = False) -> Draft:
    """Deletes a file, or a folder with the files in it.

    Args:
        name: Path of the file; a bare name is taken from the program's own folder; at most 119 characters; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.REMOVE"].draft((name,), unchecked)


def move(source: Text, dest: Text, *, unchecked: bool = False) -> Draft:
    """Copies a file or folder and replaces the destination; the source is kept.

    Args:
        source: Path to copy from; string.
        dest: Path to copy to; any existing one is deleted first; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE.MOVE"].draft((source, dest), unchecked)

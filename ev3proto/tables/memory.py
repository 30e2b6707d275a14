"""Operations on the brick's memory: variables of running programs, files and folders, data logs, arrays.

A handle is the number of an open file, an array or a block of memory; it is valid only in the program slot that
opened it.
"""

from ev3proto.tables import paths
from ev3proto.tables.declaration import (
    ARRAY_TYPED,
    DATA8,
    DATA16,
    DATA32,
    DATAF,
    EXTENSIONS,
    HANDLE,
    STRING,
    Command,
    Effect,
    In,
    Opcode,
    Out,
    Role,
    Type,
    Values,
)
from ev3proto.tables.enumerations import DEL, SLOT

NOT_NEGATIVE = (0, 2**31 - 1)
ARRAY_ROOM = 6_000_000
"""Bytes of memory for the arrays of all programs. 5,000,000 fit in one array, 7,000,000 do not."""
NO_YES = {0: "no", 1: "yes"}

# Access to a program's memory takes numbered slots only; arrays and images also accept CURRENT_SLOT (-1).
PROGRAM = In("PRGID", DATA16, "slot of the program, which must be running", range=(0, 4), enum=SLOT)
OBJECT = In("OBJID", DATA16, "object whose local memory is meant", special={0: "the program's global memory"})
OFFSET = In("OFFSET", DATA32, "first byte in that memory", range=NOT_NEGATIVE, unit="bytes")
MEMORY_SIZE = In("SIZE", DATA32, "number of bytes", range=NOT_NEGATIVE, unit="bytes")

FILE_NAME = In("NAME", STRING, "path of the file; a bare name is taken from the program's own folder", most=paths.WHOLE)
FOLDER_NAME = In("NAME", STRING, "path of the folder with its closing slash, such as ../prjs/", most=paths.WHOLE)
FILE_HANDLE = In("HANDLE", HANDLE, "the open file", role=Role.FILE)
NEW_FILE = Out("HANDLE", HANDLE, "handle of the opened file", role=Role.FILE)
LOG_HANDLE = In("HANDLE", HANDLE, "the open data log")
DELIMITER = In("DEL", DATA8, "separator between two values in the file", enum=DEL)
ROOM = In("LENGTH", DATA8, "size of the string's buffer, including the zero", unit="bytes")
ENTRY = In("ITEM", DATA8, "which entry of the folder, the first is 1", range=(1, 127))
IMAGE_ADDRESS = Out("IP", DATA32, "where it was loaded, for PROGRAM_START", special={0: "not loaded"})

OWNER = In("PRGID", DATA16, "slot of the program that owns the array", enum=SLOT)
ARRAY_HANDLE = In("HANDLE", HANDLE, "the array", role=Role.ARRAY)
ANY_ARRAY_HANDLE = In("HANDLE", HANDLE, "the array")
NEW_ARRAY = Out("HANDLE", HANDLE, "handle of the new array", role=Role.ARRAY)
INDEX = In("INDEX", DATA32, "which element, the first is 0", range=(0, ARRAY_ROOM - 1), role=Role.INDEX)
FIRST_BYTE = In("INDEX", DATA32, "first byte in the array's content, whatever its elements", range=NOT_NEGATIVE)
BYTES_32 = In("BYTES", DATA32, "number of bytes", range=NOT_NEGATIVE, unit="bytes")
BYTES_16 = In("BYTES", DATA16, "number of bytes", range=(0, 32767), unit="bytes")


def _create(number: int, name: str, element: Type) -> Command:
    """Builds an ARRAY command that creates an array of one element type."""
    return Command(
        number,
        name,
        f"Creates an array of {element} elements",
        (
            In("ELEMENTS", DATA32, "initial number of elements", range=(0, ARRAY_ROOM // element.size)),
            NEW_ARRAY,
        ),
        effects=(Effect.COMPUTES,),
    )


def _init(number: int, name: str, element: Type) -> Command:
    """Builds an ARRAY command that writes several elements of one type, each as a separate parameter."""
    return Command(
        number,
        name,
        f"Writes several elements of a {element} array, all within its size",
        (
            ARRAY_HANDLE,
            In("INDEX", DATA32, "first element to write, counted from 0", range=(0, ARRAY_ROOM - 1)),
            # A negative count sends the firmware's validator into an endless loop.
            In("ELEMENTS", DATA32, "number of values that follow", range=NOT_NEGATIVE),
            Values("VALUES", "the values, one parameter each", element, each="value"),
        ),
        effects=(Effect.COMPUTES,),
    )


MEMORY = (
    Opcode(
        0x7E,
        "MEMORY_WRITE",
        "Writes bytes into the variables of a running program",
        (
            PROGRAM,
            OBJECT,
            OFFSET,
            MEMORY_SIZE,
            In("ARRAY", DATA8, "the bytes; those beyond the end of the memory are dropped", length="SIZE"),
        ),
        effects=(Effect.CONTROLS_PROGRAMS,),
    ),
    Opcode(
        0x7F,
        "MEMORY_READ",
        "Reads bytes from the variables of a running program",
        (
            PROGRAM,
            OBJECT,
            OFFSET,
            MEMORY_SIZE,
            Out("ARRAY", DATA8, "the bytes, zeros beyond the end of the memory", length="SIZE"),
        ),
        effects=(Effect.VARIES, Effect.COMPUTES),
    ),
    Opcode(
        0xC0,
        "FILE",
        "Works on files, folders, data logs, program images and the list of recent files",
        commands=(
            Command(
                0,
                "OPEN_APPEND",
                "Opens a file for appending; creates it if it does not exist",
                (
                    FILE_NAME,
                    NEW_FILE,
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                1,
                "OPEN_READ",
                "Opens a file for reading",
                (
                    FILE_NAME,
                    NEW_FILE,
                    Out("SIZE", DATA32, "size of the file", unit="bytes", special={0: "not found"}),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                2,
                "OPEN_WRITE",
                "Creates or truncates a file and opens it for writing",
                (
                    FILE_NAME,
                    NEW_FILE,
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                3,
                "READ_VALUE",
                "Reads the text up to the next delimiter and turns it into a number",
                (
                    FILE_HANDLE,
                    DELIMITER,
                    Out("VALUE", DATAF, "the number, 0 if the text is not a number"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                4,
                "WRITE_VALUE",
                "Writes a number as text, and a delimiter after it",
                (
                    FILE_HANDLE,
                    DELIMITER,
                    In("VALUE", DATAF, "the number"),
                    In("FIGURES", DATA8, "minimum width in characters, including the decimal point"),
                    In("DECIMALS", DATA8, "digits after the decimal point"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                5,
                "READ_TEXT",
                "Reads text up to the next delimiter",
                (
                    FILE_HANDLE,
                    DELIMITER,
                    In(
                        "LENGTH",
                        DATA16,
                        "maximum number of bytes to read; LEGO's firmware keeps the low 8 bits, so 127",
                        unit="bytes",
                    ),
                    Out(
                        "TEXT",
                        STRING,
                        "the text, without a zero at its end if it fills the whole buffer",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                6,
                "WRITE_TEXT",
                "Writes text without its zero, and a delimiter after it",
                (
                    FILE_HANDLE,
                    DELIMITER,
                    In("TEXT", STRING, "the text"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(7, "CLOSE", "Closes a file and frees its handle", (FILE_HANDLE,), effects=(Effect.COMPUTES,)),
            Command(
                8,
                "LOAD_IMAGE",
                "Loads a program file into a stopped slot, for PROGRAM_START to run",
                (
                    In("PRGID", DATA16, "slot to load it into", range=(0, 4), enum=SLOT),
                    In(
                        "NAME",
                        STRING,
                        "path of the program, relative to /home/root/lms2012/sys; .rbf may be omitted",
                        most=paths.WHOLE,
                    ),
                    Out("SIZE", DATA32, "size of the program", unit="bytes", special={0: "not loaded"}),
                    IMAGE_ADDRESS,
                ),
                effects=(Effect.VARIES, Effect.CONTROLS_PROGRAMS),
                sentence="loads the program {NAME} into slot {PRGID}",
            ),
            Command(
                9,
                "GET_HANDLE",
                "Finds the handle of a file that is already open",
                (
                    FILE_NAME,
                    Out("HANDLE", HANDLE, "the open file", special={-1: "not open"}),
                    Out("WRITE", DATA8, "whether it is open for writing or appending", special=NO_YES),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                10,
                "MAKE_FOLDER",
                "Creates a folder unless it exists",
                (
                    In("NAME", STRING, "path of the folder, relative to /home/root/lms2012/sys", most=paths.WHOLE),
                    Out("SUCCESS", DATA8, "whether the folder exists now", special=NO_YES),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                11,
                "GET_POOL",
                "Reserves a block of memory for the program",
                (
                    In("SIZE", DATA32, "how much memory", range=(1, ARRAY_ROOM), unit="bytes"),
                    Out("HANDLE", HANDLE, "handle of the block", role=Role.ARRAY),
                    Out("IP", DATA32, "address of the block"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                12,
                "SET_LOG_SYNC_TIME",
                "Stores the time and tick to which data logs are aligned",
                (
                    In("TIME", DATA32, "the common time"),
                    In("TICK", DATA32, "the brick's tick at that time"),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                13,
                "GET_FOLDERS",
                "Counts the entries of a folder, without hidden ones",
                (
                    FOLDER_NAME,
                    Out("ITEMS", DATA8, "number of entries"),
                ),
                effects=(Effect.VARIES, Effect.READS),
                words="directory",
            ),
            Command(
                14,
                "GET_LOG_SYNC_TIME",
                "Reads the time and tick to which data logs are aligned",
                (
                    Out("TIME", DATA32, "the common time"),
                    Out("TICK", DATA32, "the brick's tick at that time"),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                15,
                "GET_SUBFOLDER_NAME",
                "Reads the name of one entry of a folder",
                (
                    FOLDER_NAME,
                    ENTRY,
                    ROOM,
                    Out(
                        "STRING",
                        STRING,
                        "its name without extension, empty if there is no such entry",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                16,
                "WRITE_LOG",
                "Adds one row of samples to a data log",
                (
                    LOG_HANDLE,
                    In("TIME", DATA32, "time of the samples since the log began", unit="ms"),
                    In("ITEMS", DATA8, "number of samples; with 0 nothing is written", range=(0, 127)),
                    In("VALUES", DATAF, "the samples, in one array", length="ITEMS"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                17,
                "CLOSE_LOG",
                "Writes the rest of a data log and closes it",
                (
                    LOG_HANDLE,
                    In("NAME", STRING, "path of the log as given to OPEN_LOG; .rdf may be omitted"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                18,
                "GET_IMAGE",
                "Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails",
                (
                    FOLDER_NAME,
                    In("PRGID", DATA16, "slot to load it into", enum=SLOT),
                    ENTRY,
                    Out("IP", DATA32, "where it was loaded"),
                ),
                effects=(Effect.FAILS, Effect.VARIES, Effect.CONTROLS_PROGRAMS),
            ),
            Command(
                19,
                "GET_ITEM",
                "Finds an entry of a folder by its name",
                (
                    FOLDER_NAME,
                    In("STRING", STRING, "name to look for, without extension"),
                    Out("ITEM", DATA8, "number of the entry; the first is 1", range=(1, 127), special={0: "not found"}),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                20,
                "GET_CACHE_FILES",
                "Counts the recently run files",
                (Out("ITEMS", DATA8, "number of files, at most 10"),),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                21,
                "PUT_CACHE_FILE",
                "Puts a file first in the list of recently run files",
                (In("STRING", STRING, "path of the file"),),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                22,
                "GET_CACHE_FILE",
                "Reads the path of one recently run file",
                (
                    In("ITEM", DATA8, "which one, 1 is the latest", range=(1, 10)),
                    ROOM,
                    Out("STRING", STRING, "path of the file, empty if there is none", length="LENGTH"),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                23,
                "DEL_CACHE_FILE",
                "Removes a file from the list of recently run files",
                (
                    In(
                        "STRING",
                        STRING,
                        "path of the file, as given to PUT_CACHE_FILE",
                        note="elsewhere an output; the firmware reads the path from it and writes nothing",
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                24,
                "DEL_SUBFOLDER",
                "Deletes one entry of a folder together with the files in it",
                (
                    FOLDER_NAME,
                    ENTRY,
                ),
                effects=(Effect.DELETES_FILES,),
            ),
            Command(
                25,
                "GET_LOG_NAME",
                "Reads the path of the open data log",
                (
                    ROOM,
                    Out(
                        "NAME",
                        STRING,
                        "path of the log, empty if none is open",
                        length="LENGTH",
                        note="elsewhere an input; the firmware writes the path into it",
                    ),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                27,
                "OPEN_LOG",
                "Creates a data log and writes its header",
                (
                    In("NAME", STRING, "path of the log; .rdf may be omitted; with an empty one it stays in memory"),
                    In("syncedTime", DATA32, "the common time, as GET_LOG_SYNC_TIME returns it"),
                    In("syncedTick", DATA32, "the brick's tick at that time"),
                    In("nowTick", DATA32, "the brick's tick at the start of the log"),
                    In(
                        "sample_interval_in_ms",
                        DATA32,
                        "time between samples; fast logs are kept in memory first",
                        unit="ms",
                    ),
                    In("duration_in_ms", DATA32, "duration of the log", unit="ms"),
                    In("SDATA", STRING, "text that describes the sensors, copied into the header"),
                    Out("HANDLE", HANDLE, "handle of the log"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                28,
                "READ_BYTES",
                "Reads raw bytes from a file",
                (
                    FILE_HANDLE,
                    BYTES_16,
                    Out("DESTINATION", DATA8, "the bytes; followed by a zero if the file ended early", length="BYTES"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                29,
                "WRITE_BYTES",
                "Writes raw bytes to a file",
                (
                    FILE_HANDLE,
                    BYTES_16,
                    In("SOURCE", DATA8, "the bytes", length="BYTES"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                30,
                "REMOVE",
                "Deletes a file, or a folder with the files in it",
                (FILE_NAME,),
                effects=(Effect.DELETES_FILES,),
                words="delete erase",
            ),
            Command(
                31,
                "MOVE",
                "Copies a file or folder and replaces the destination; the source is kept",
                (
                    In("SOURCE", STRING, "path to copy from"),
                    In("DEST", STRING, "path to copy to; any existing one is deleted first"),
                ),
                effects=(Effect.WRITES_FILES, Effect.DELETES_FILES),
            ),
        ),
    ),
    Opcode(
        0xC1,
        "ARRAY",
        "Creates, fills, copies and resizes arrays",
        commands=(
            Command(
                0,
                "DELETE",
                "Deletes an array and frees its handle",
                (ARRAY_HANDLE,),
                dialects=("official",),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                0,
                "DESTROY",
                "Deletes an array and frees its handle (LEGO's name for it is DELETE)",
                (ARRAY_HANDLE,),
                dialects=EXTENSIONS,
                effects=(Effect.COMPUTES,),
            ),
            _create(1, "CREATE8", DATA8),
            _create(2, "CREATE16", DATA16),
            _create(3, "CREATE32", DATA32),
            _create(4, "CREATEF", DATAF),
            Command(
                5,
                "RESIZE",
                "Changes the number of elements of an array",
                (
                    ARRAY_HANDLE,
                    In("ELEMENTS", DATA32, "new number of elements", range=(0, ARRAY_ROOM)),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                6,
                "FILL",
                "Sets every element of an array to one value",
                (
                    ARRAY_HANDLE,
                    In("VALUE", ARRAY_TYPED, "the value, of the array's type"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                7,
                "COPY",
                "Copies the content of one array into another of the same type, which is resized to match",
                (
                    In("HSOURCE", HANDLE, "array to copy from", role=Role.ARRAY),
                    In(
                        "HDEST",
                        HANDLE,
                        "array to copy into, which must exist",
                        role=Role.ARRAY,
                        note="elsewhere an output; the firmware reads the handle of an array that exists",
                    ),
                ),
                effects=(Effect.COMPUTES,),
            ),
            _init(8, "INIT8", DATA8),
            _init(9, "INIT16", DATA16),
            _init(10, "INIT32", DATA32),
            _init(11, "INITF", DATAF),
            Command(
                12,
                "SIZE",
                "Counts the elements of an array",
                (
                    ARRAY_HANDLE,
                    Out("ELEMENTS", DATA32, "number of elements, 0 if there is no such array"),
                ),
                dialects=("official",),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                12,
                "SET_SIZE",
                "Counts the elements of an array (LEGO's name for it is SIZE)",
                (
                    ARRAY_HANDLE,
                    Out("ELEMENTS", DATA32, "number of elements, 0 if there is no such array"),
                ),
                dialects=EXTENSIONS,
                effects=(Effect.COMPUTES,),
            ),
            Command(
                13,
                "READ_CONTENT",
                "Reads an array's content as bytes, also of another program",
                (
                    OWNER,
                    ANY_ARRAY_HANDLE,
                    FIRST_BYTE,
                    BYTES_32,
                    Out("ARRAY", DATA8, "the bytes, zeros beyond the end of the array", length="BYTES"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                14,
                "WRITE_CONTENT",
                "Writes an array's content as bytes; the array then ends after them",
                (
                    OWNER,
                    ANY_ARRAY_HANDLE,
                    FIRST_BYTE,
                    BYTES_32,
                    In("ARRAY", DATA8, "the bytes", length="BYTES"),
                ),
                effects=(Effect.CONTROLS_PROGRAMS,),
            ),
            Command(
                15,
                "READ_SIZE",
                "Returns the size of an array's content, also of another program",
                (
                    OWNER,
                    ANY_ARRAY_HANDLE,
                    Out("BYTES", DATA32, "number of bytes, 0 if there is no such array", unit="bytes"),
                ),
                effects=(Effect.COMPUTES,),
            ),
        ),
    ),
    Opcode(
        0xC2,
        "ARRAY_WRITE",
        "Writes one element of an array, which grows where needed",
        (
            ARRAY_HANDLE,
            INDEX,
            In("VALUE", ARRAY_TYPED, "the value, of the array's type"),
        ),
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0xC3,
        "ARRAY_READ",
        "Reads one element of an array",
        (
            ARRAY_HANDLE,
            INDEX,
            Out("VALUE", ARRAY_TYPED, "the value, of the array's type"),
        ),
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0xC4,
        "ARRAY_APPEND",
        "Adds one element to the end of an array",
        (
            ARRAY_HANDLE,
            In("VALUE", ARRAY_TYPED, "the value, of the array's type"),
        ),
        effects=(Effect.COMPUTES,),
    ),
    Opcode(
        0xC5,
        "MEMORY_USAGE",
        "Reports the total and free memory for user files",
        (
            Out("TOTAL", DATA32, "total memory", unit="KiB"),
            Out("FREE", DATA32, "free memory", unit="KiB"),
        ),
        effects=(Effect.VARIES, Effect.READS),
    ),
    Opcode(
        0xC6,
        "FILENAME",
        "Splits and checks file names, and packs files",
        commands=(
            Command(
                16,
                "EXIST",
                "Reports whether a file or folder exists",
                (
                    FILE_NAME,
                    Out("FLAG", DATA8, "whether it exists", special=NO_YES),
                ),
                effects=(Effect.READS,),
            ),
            Command(
                17,
                "TOTALSIZE",
                "Reports the number of files in a folder and their size",
                (
                    In("NAME", STRING, "path of the folder or file"),
                    Out("FILES", DATA32, "number of entries, including . and ..; 0 for a file"),
                    Out("SIZE", DATA32, "size of all of them, rounded up", unit="KiB"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                18,
                "SPLIT",
                "Splits a path into folder, name and extension",
                (
                    In("FILENAME", STRING, "the path"),
                    In("LENGTH", DATA8, "buffer size for each of the three parts, including the zero", unit="bytes"),
                    Out("FOLDER", STRING, "the folder, with its closing slash on LEGO's firmware", length="LENGTH"),
                    Out("NAME", STRING, "the name, without folder and extension", length="LENGTH"),
                    Out("EXT", STRING, "the extension with its dot", length="LENGTH"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                19,
                "MERGE",
                "Builds a path from folder, name and extension",
                (
                    In("FOLDER", STRING, "the folder, without a slash at its end"),
                    In("NAME", STRING, "the name"),
                    In("EXT", STRING, "the extension with its dot"),
                    ROOM,
                    Out("FILENAME", STRING, "the path", length="LENGTH"),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                20,
                "CHECK",
                "Reports whether a path's characters and lengths are allowed; the file need not exist",
                (
                    In("FILENAME", STRING, "the path"),
                    Out("OK", DATA8, "whether the path can be used", special={0: "not allowed", 1: "allowed"}),
                ),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                21,
                "PACK",
                "Packs a file or folder into a .raf archive beside it",
                (In("FILENAME", STRING, "path of the file or folder"),),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                22,
                "UNPACK",
                "Unpacks a .raf archive into the folder it is in",
                (In("FILENAME", STRING, "path of the archive; its extension is replaced by .raf"),),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                23,
                "GET_FOLDERNAME",
                "Reads the path of the program's own folder",
                (
                    ROOM,
                    Out("FOLDERNAME", STRING, "path of the folder, without a slash at its end", length="LENGTH"),
                ),
                effects=(Effect.READS,),
            ),
        ),
        cmd_table="ARRAY",
    ),
    Opcode(
        0xE6,
        "FILE_MD5SUM",
        "Computes the MD5 digest of a file",
        (
            In("NAME", STRING, "path of the file"),
            Out("MD5SUM", DATA8, "the digest, as 16 bytes", length=16),
            Out("SUCCESS", DATA8, "whether the file could be read", special=NO_YES),
        ),
        dialects=EXTENSIONS,
        effects=(Effect.COMPUTES,),
    ),
)

"""What reaches the brick's memory: variables of running programs, files and folders, data logs, arrays.

A handle is a number that one program slot gave to an open file, an array or a block of memory; elsewhere it means
nothing without the slot.
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
NO_YES = {0: "no", 1: "yes"}

# The VM's own memory knows the numbered slots only; arrays and images see CURRENT_SLOT (-1) as well.
PROGRAM = In("PRGID", DATA16, "slot of the program, which must be running", range=(0, 4), enum=SLOT)
OBJECT = In("OBJID", DATA16, "object whose local memory is meant", special={0: "the program's global memory"})
OFFSET = In("OFFSET", DATA32, "first byte in that memory", range=NOT_NEGATIVE, unit="bytes")
MEMORY_SIZE = In("SIZE", DATA32, "how many bytes", range=NOT_NEGATIVE, unit="bytes")

FILE_NAME = In("NAME", STRING, "path of the file; a bare name is taken from the program's own folder", most=paths.WHOLE)
FOLDER_NAME = In("NAME", STRING, "path of the folder with its closing slash, such as ../prjs/", most=paths.WHOLE)
FILE_HANDLE = In("HANDLE", HANDLE, "the open file")
NEW_FILE = Out("HANDLE", HANDLE, "what names the file from now on")
LOG_HANDLE = In("HANDLE", HANDLE, "the open data log")
DELIMITER = In("DEL", DATA8, "what stands between two values in the file", enum=DEL)
ROOM = In("LENGTH", DATA8, "room for the string, its zero included", unit="bytes")
ENTRY = In("ITEM", DATA8, "which entry of the folder, the first is 1", range=(1, 127))
IMAGE_ADDRESS = Out("IP", DATA32, "where it was loaded, to be handed to PROGRAM_START", special={0: "not loaded"})

OWNER = In("PRGID", DATA16, "slot of the program that owns the array", enum=SLOT)
ARRAY_HANDLE = In("HANDLE", HANDLE, "the array")
NEW_ARRAY = Out("HANDLE", HANDLE, "what names the array from now on")
INDEX = In("INDEX", DATA32, "which element, the first is 0", range=NOT_NEGATIVE, role=Role.INDEX)
FIRST_BYTE = In("INDEX", DATA32, "first byte in the array's content, whatever its elements", range=NOT_NEGATIVE)
BYTES_32 = In("BYTES", DATA32, "how many bytes", range=NOT_NEGATIVE, unit="bytes")
BYTES_16 = In("BYTES", DATA16, "how many bytes", range=(0, 32767), unit="bytes")


def _create(number: int, name: str, element: Type) -> Command:
    """An ARRAY command that makes an array of elements of one type."""
    return Command(
        number,
        name,
        f"Creates an array of {element} elements",
        (
            In("ELEMENTS", DATA32, "how many elements it has at first", range=NOT_NEGATIVE),
            NEW_ARRAY,
        ),
    )


def _init(number: int, name: str, element: Type) -> Command:
    """An ARRAY command that writes several elements of one type, each a parameter of its own."""
    return Command(
        number,
        name,
        f"Writes several elements of a {element} array, all within its size",
        (
            ARRAY_HANDLE,
            In("INDEX", DATA32, "first element to write, counted from 0", range=NOT_NEGATIVE),
            # A negative count makes the firmware's validator spin.
            In("ELEMENTS", DATA32, "how many values follow", range=NOT_NEGATIVE),
            Values("VALUES", "the values, one parameter each", element),
        ),
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
        effects=(Effect.VARIES,),
    ),
    Opcode(
        0xC0,
        "FILE",
        "Works on files, folders, data logs, program images and the list of recent files",
        commands=(
            Command(
                0,
                "OPEN_APPEND",
                "Opens a file to write at its end, creates it where there is none",
                (
                    FILE_NAME,
                    NEW_FILE,
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                1,
                "OPEN_READ",
                "Opens a file to read",
                (
                    FILE_NAME,
                    NEW_FILE,
                    Out("SIZE", DATA32, "size of the file", unit="bytes", special={0: "not found"}),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                2,
                "OPEN_WRITE",
                "Creates a file or empties the one there is, and opens it to write",
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
                    Out("VALUE", DATAF, "the number, 0 where the text is none"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                4,
                "WRITE_VALUE",
                "Writes a number as text, and a delimiter after it",
                (
                    FILE_HANDLE,
                    DELIMITER,
                    In("VALUE", DATAF, "the number"),
                    In("FIGURES", DATA8, "least width in characters, the decimal point included"),
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
                        "most bytes to read; LEGO's firmware keeps the low 8 bits, so 127",
                        unit="bytes",
                    ),
                    Out(
                        "TEXT",
                        STRING,
                        "the text, without a zero at its end when it fills all the room",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.VARIES,),
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
            Command(7, "CLOSE", "Closes a file and gives its handle back", (FILE_HANDLE,)),
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
                effects=(Effect.VARIES,),
            ),
            Command(
                9,
                "GET_HANDLE",
                "Finds the handle of a file that is already open",
                (
                    FILE_NAME,
                    Out("HANDLE", HANDLE, "the open file", special={-1: "not open"}),
                    Out("WRITE", DATA8, "whether it is open to write or append", special=NO_YES),
                ),
            ),
            Command(
                10,
                "MAKE_FOLDER",
                "Creates a folder unless it is there",
                (
                    In("NAME", STRING, "path of the folder, relative to /home/root/lms2012/sys", most=paths.WHOLE),
                    Out("SUCCESS", DATA8, "whether the folder is there now", special=NO_YES),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                11,
                "GET_POOL",
                "Reserves a block of memory for the program",
                (
                    In("SIZE", DATA32, "how much memory", range=NOT_NEGATIVE, unit="bytes"),
                    Out("HANDLE", HANDLE, "what names the block from now on"),
                    Out("IP", DATA32, "address of the block"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                12,
                "SET_LOG_SYNC_TIME",
                "Stores the time and tick by which data logs are lined up",
                (
                    In("TIME", DATA32, "the common time"),
                    In("TICK", DATA32, "the brick's tick at that time"),
                ),
            ),
            Command(
                13,
                "GET_FOLDERS",
                "Counts the entries of a folder, without hidden ones",
                (
                    FOLDER_NAME,
                    Out("ITEMS", DATA8, "how many entries there are"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                14,
                "GET_LOG_SYNC_TIME",
                "Tells the time and tick by which data logs are lined up",
                (
                    Out("TIME", DATA32, "the common time"),
                    Out("TICK", DATA32, "the brick's tick at that time"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                15,
                "GET_SUBFOLDER_NAME",
                "Tells the name of one entry of a folder",
                (
                    FOLDER_NAME,
                    ENTRY,
                    ROOM,
                    Out(
                        "STRING",
                        STRING,
                        "its name without extension, empty where there is no such entry",
                        length="LENGTH",
                    ),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                16,
                "WRITE_LOG",
                "Adds one row of samples to a data log",
                (
                    LOG_HANDLE,
                    In("TIME", DATA32, "time of the samples since the log began", unit="ms"),
                    In("ITEMS", DATA8, "how many samples; with 0 nothing is written", range=(0, 127)),
                    In("VALUES", DATAF, "the samples, in one array", length="ITEMS"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                17,
                "CLOSE_LOG",
                "Writes a data log to its end and closes it",
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
                effects=(Effect.VARIES,),
            ),
            Command(
                19,
                "GET_ITEM",
                "Finds an entry of a folder by its name",
                (
                    FOLDER_NAME,
                    In("STRING", STRING, "name to look for, without extension"),
                    Out("ITEM", DATA8, "which entry it is, the first is 1", range=(1, 127), special={0: "not found"}),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                20,
                "GET_CACHE_FILES",
                "Counts the recently run files",
                (Out("ITEMS", DATA8, "how many there are, 10 at most"),),
                effects=(Effect.VARIES,),
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
                "Tells the path of one recently run file",
                (
                    In("ITEM", DATA8, "which one, 1 is the latest", range=(1, 10)),
                    ROOM,
                    Out("STRING", STRING, "path of the file, empty where there is none", length="LENGTH"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                23,
                "DEL_CACHE_FILE",
                "Takes a file off the list of recently run files",
                (
                    In(
                        "STRING",
                        STRING,
                        "path of the file, as PUT_CACHE_FILE got it",
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
                "Tells the path of the data log that is open",
                (
                    ROOM,
                    Out(
                        "NAME",
                        STRING,
                        "path of the log, empty where none is open",
                        length="LENGTH",
                        note="elsewhere an input; the firmware writes the path into it",
                    ),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                27,
                "OPEN_LOG",
                "Creates a data log and writes its header",
                (
                    In("NAME", STRING, "path of the log; .rdf may be omitted; with an empty one it stays in memory"),
                    In("syncedTime", DATA32, "the common time, as GET_LOG_SYNC_TIME tells it"),
                    In("syncedTick", DATA32, "the brick's tick at that time"),
                    In("nowTick", DATA32, "the brick's tick at the start of the log"),
                    In(
                        "sample_interval_in_ms",
                        DATA32,
                        "time between samples; fast logs are kept in memory first",
                        unit="ms",
                    ),
                    In("duration_in_ms", DATA32, "how long the log is to run", unit="ms"),
                    In("SDATA", STRING, "text that describes the sensors, copied into the header"),
                    Out("HANDLE", HANDLE, "what names the log from now on"),
                ),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                28,
                "READ_BYTES",
                "Reads bytes from a file as they are",
                (
                    FILE_HANDLE,
                    BYTES_16,
                    Out("DESTINATION", DATA8, "the bytes; a zero follows where the file ended early", length="BYTES"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                29,
                "WRITE_BYTES",
                "Writes bytes to a file as they are",
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
            ),
            Command(
                31,
                "MOVE",
                "Copies a file or folder over whatever is at the destination; the source stays",
                (
                    In("SOURCE", STRING, "path to copy from"),
                    In("DEST", STRING, "path to copy to; what is there is deleted first"),
                ),
                effects=(
                    Effect.WRITES_FILES,
                    Effect.DELETES_FILES,
                ),
            ),
        ),
    ),
    Opcode(
        0xC1,
        "ARRAY",
        "Makes, fills, copies and resizes arrays",
        commands=(
            Command(0, "DELETE", "Deletes an array and gives its handle back", (ARRAY_HANDLE,), dialects=("official",)),
            Command(
                0,
                "DESTROY",
                "Deletes an array and gives its handle back (LEGO's name for it is DELETE)",
                (ARRAY_HANDLE,),
                dialects=EXTENSIONS,
            ),
            _create(1, "CREATE8", DATA8),
            _create(2, "CREATE16", DATA16),
            _create(3, "CREATE32", DATA32),
            _create(4, "CREATEF", DATAF),
            Command(
                5,
                "RESIZE",
                "Changes how many elements an array has",
                (
                    ARRAY_HANDLE,
                    In("ELEMENTS", DATA32, "how many elements it has from now on", range=NOT_NEGATIVE),
                ),
            ),
            Command(
                6,
                "FILL",
                "Sets every element of an array to one value",
                (
                    ARRAY_HANDLE,
                    In("VALUE", ARRAY_TYPED, "the value, of the array's type"),
                ),
            ),
            Command(
                7,
                "COPY",
                "Copies the content of one array into another of the same type, which takes its size",
                (
                    In("HSOURCE", HANDLE, "array to copy from"),
                    In(
                        "HDEST",
                        HANDLE,
                        "array to copy into, which has to exist",
                        note="elsewhere an output; the firmware reads the handle of an array that exists",
                    ),
                ),
            ),
            _init(8, "INIT8", DATA8),
            _init(9, "INIT16", DATA16),
            _init(10, "INIT32", DATA32),
            _init(11, "INITF", DATAF),
            Command(
                12,
                "SIZE",
                "Tells how many elements an array has",
                (
                    ARRAY_HANDLE,
                    Out("ELEMENTS", DATA32, "how many elements it has, 0 where there is no such array"),
                ),
                dialects=("official",),
            ),
            Command(
                12,
                "SET_SIZE",
                "Tells how many elements an array has (LEGO's name for it is SIZE)",
                (
                    ARRAY_HANDLE,
                    Out("ELEMENTS", DATA32, "how many elements it has, 0 where there is no such array"),
                ),
                dialects=EXTENSIONS,
            ),
            Command(
                13,
                "READ_CONTENT",
                "Reads an array's content as bytes, of another program too",
                (
                    OWNER,
                    ARRAY_HANDLE,
                    FIRST_BYTE,
                    BYTES_32,
                    Out("ARRAY", DATA8, "the bytes, zeros beyond the end of the array", length="BYTES"),
                ),
            ),
            Command(
                14,
                "WRITE_CONTENT",
                "Writes an array's content as bytes; the array then ends with them",
                (
                    OWNER,
                    ARRAY_HANDLE,
                    FIRST_BYTE,
                    BYTES_32,
                    In("ARRAY", DATA8, "the bytes", length="BYTES"),
                ),
                effects=(Effect.CONTROLS_PROGRAMS,),
            ),
            Command(
                15,
                "READ_SIZE",
                "Tells how many bytes an array's content has, of another program too",
                (
                    OWNER,
                    ARRAY_HANDLE,
                    Out("BYTES", DATA32, "how many bytes, 0 where there is no such array", unit="bytes"),
                ),
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
    ),
    Opcode(
        0xC4,
        "ARRAY_APPEND",
        "Adds one element to the end of an array",
        (
            ARRAY_HANDLE,
            In("VALUE", ARRAY_TYPED, "the value, of the array's type"),
        ),
    ),
    Opcode(
        0xC5,
        "MEMORY_USAGE",
        "Tells how much memory for user files there is and how much of it is free",
        (
            Out("TOTAL", DATA32, "all of it", unit="KiB"),
            Out("FREE", DATA32, "what is free", unit="KiB"),
        ),
        effects=(Effect.VARIES,),
    ),
    Opcode(
        0xC6,
        "FILENAME",
        "Takes file names apart, checks them, and packs files",
        commands=(
            Command(
                16,
                "EXIST",
                "Tells whether a file or folder is there",
                (
                    FILE_NAME,
                    Out("FLAG", DATA8, "whether it is there", special=NO_YES),
                ),
            ),
            Command(
                17,
                "TOTALSIZE",
                "Tells how many files a folder has and their size",
                (
                    In("NAME", STRING, "path of the folder or file"),
                    Out("FILES", DATA32, "how many entries, with . and .. counted in; 0 for a file"),
                    Out("SIZE", DATA32, "size of all of them, rounded up", unit="KiB"),
                ),
                effects=(Effect.VARIES,),
            ),
            Command(
                18,
                "SPLIT",
                "Takes a path apart into folder, name and extension",
                (
                    In("FILENAME", STRING, "the path"),
                    In("LENGTH", DATA8, "room for each of the three parts, its zero included", unit="bytes"),
                    Out("FOLDER", STRING, "the folder, on LEGO's firmware with its closing slash", length="LENGTH"),
                    Out("NAME", STRING, "the name, without folder and extension", length="LENGTH"),
                    Out("EXT", STRING, "the extension with its dot", length="LENGTH"),
                ),
            ),
            Command(
                19,
                "MERGE",
                "Puts a path together from folder, name and extension",
                (
                    In("FOLDER", STRING, "the folder, without a slash at its end"),
                    In("NAME", STRING, "the name"),
                    In("EXT", STRING, "the extension with its dot"),
                    ROOM,
                    Out("FILENAME", STRING, "the path", length="LENGTH"),
                ),
            ),
            Command(
                20,
                "CHECK",
                "Tells whether a path has allowed characters and lengths; the file need not exist",
                (
                    In("FILENAME", STRING, "the path"),
                    Out("OK", DATA8, "whether the path can be used", special={0: "not allowed", 1: "allowed"}),
                ),
            ),
            Command(
                21,
                "PACK",
                "Packs a file or folder into a .raf archive beside it",
                (In("FILENAME", STRING, "path of what to pack"),),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                22,
                "UNPACK",
                "Unpacks a .raf archive into the folder it is in",
                (In("FILENAME", STRING, "path of the archive; whatever its extension, .raf is taken"),),
                effects=(Effect.WRITES_FILES,),
            ),
            Command(
                23,
                "GET_FOLDERNAME",
                "Tells the program's own folder",
                (
                    ROOM,
                    Out("FOLDERNAME", STRING, "path of the folder, without a slash at its end", length="LENGTH"),
                ),
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
    ),
)

"""System commands: files, mailboxes, Bluetooth PINs, the bootloader. What each one asks and what comes back.

They are no byte code: a number, then fields of fixed kinds. Replies repeat the number, then have a status and fields.
"""

from enum import Enum, IntEnum
from typing import NamedTuple

from ev3proto.tables.declaration import Effect


class Kind(Enum):
    """How a field stands in the frame."""

    U8 = "u8"
    U16 = "u16"
    U32 = "u32"
    TEXT = "text"
    COUNTED_TEXT = "counted text"
    DATA = "data"
    LISTING = "listing"


class Field(NamedTuple):
    """One field of a system message.

    name      how it is called here, in JSON and in filters
    kind      number, text up to a zero, text with its length in the field before, or all the bytes that are left
    text      one line: what it means
    counts    for lengths: the field whose bytes they count; omitted when building, it is worked out
    optional  True where senders omit it
    most      largest number of bytes, where the firmware has a limit
    is_message  True for the message of a mailbox, a text, a number or a logic value: `tables.mailboxes` reads it
    """

    name: str
    kind: Kind
    text: str
    counts: str | None = None
    optional: bool = False
    most: int | None = None
    is_message: bool = False


class SystemStatus(IntEnum):
    """The byte that says how a system command went. FILE_EXITS is the firmware's spelling."""

    SUCCESS = 0
    UNKNOWN_HANDLE = 1
    HANDLE_NOT_READY = 2
    CORRUPT_FILE = 3
    NO_HANDLES_AVAILABLE = 4
    NO_PERMISSION = 5
    ILLEGAL_PATH = 6
    FILE_EXITS = 7
    END_OF_FILE = 8
    SIZE_ERROR = 9
    UNKNOWN_ERROR = 10
    ILLEGAL_FILENAME = 11
    ILLEGAL_CONNECTION = 12

    @property
    def is_failure(self) -> bool:
        """True when the command did not do what it was asked; END_OF_FILE is how every upload ends."""
        return self not in (SystemStatus.SUCCESS, SystemStatus.END_OF_FILE)


class SystemCommand(NamedTuple):
    """One system command: number, name, one line of meaning, the fields of request and reply.

    answered    False for the ones that the brick never replies to
    bootloader  True for those that only the brick's firmware updater knows (USB only)
    transfer    the part it plays in moving a file: `begin`, `continue` or `close`; None for the others
    usb_only    True for those that the firmware takes by USB only
    effects     what it does to the brick that outlasts it
    is_long     True for those whose frame may be longer than MAX_FRAME: the firmware takes the rest in pieces
    statuses    what the statuses other than SUCCESS mean that the firmware answers with
    """

    number: int
    name: str
    text: str
    request: tuple[Field, ...] = ()
    reply: tuple[Field, ...] = ()
    answered: bool = True
    bootloader: bool = False
    transfer: str | None = None
    usb_only: bool = False
    effects: tuple[Effect, ...] = ()
    is_long: bool = False
    statuses: tuple[tuple[SystemStatus, str], ...] = ()


_PATH = Field("path", Kind.TEXT, "where the file or folder is, absolute or relative to /home/root/lms2012/sys")
_HANDLE = Field("handle", Kind.U8, "the open file on the brick, as its reply to BEGIN_... gave it")
_REPLY_HANDLE = Field("handle", Kind.U8, "the open file, for the messages that continue")
_SIZE = Field("size", Kind.U32, "bytes of the whole file")
_MAX_BYTES = Field("max_bytes", Kind.U16, "most bytes of contents that the reply may carry")
_DATA = Field("data", Kind.DATA, "a piece of the file's contents")
_LIST = Field("list", Kind.LISTING, "a piece of the listing: lines with MD5, size and name, or a folder's name and /")
_ADDRESS = Field("address", Kind.U32, "first byte of the flash memory meant")
_IMAGE_SIZE = Field("image_size", Kind.U32, "bytes of the image or region")
_PIN = (
    Field("mac_length", Kind.U8, "bytes of the MAC address", counts="mac"),
    Field("mac", Kind.COUNTED_TEXT, "MAC address of the other device, in hex"),
    Field("pin_length", Kind.U8, "bytes of the PIN", counts="pin"),
    Field("pin", Kind.COUNTED_TEXT, "the PIN"),
)

SYSTEM = (
    SystemCommand(
        0x92,
        "BEGIN_DOWNLOAD",
        "Opens a file on the brick for writing and says how long it will be",
        (_SIZE, _PATH, Field("data", Kind.DATA, "the first bytes of the file, usually none", optional=True)),
        (_REPLY_HANDLE,),
        transfer="begin",
        effects=(Effect.WRITES_FILES,),
        is_long=True,
        statuses=(
            (SystemStatus.END_OF_FILE, "the file is complete: its size is 0, or all of it came with this frame"),
            (
                SystemStatus.UNKNOWN_HANDLE,
                "no such file can be made: it is a folder, or the file system refuses the name",
            ),
            (
                SystemStatus.SIZE_ERROR,
                "there is not enough room for a file of that size, or the frame had more data than announced",
            ),
            (
                SystemStatus.NO_HANDLES_AVAILABLE,
                "all handles are in use: files were begun and never completed or closed",
            ),
        ),
    ),
    SystemCommand(
        0x93,
        "CONTINUE_DOWNLOAD",
        "Writes the next piece of a file; the file closes itself when it is complete",
        (_HANDLE, _DATA),
        (_REPLY_HANDLE,),
        transfer="continue",
        effects=(Effect.WRITES_FILES,),
        is_long=True,
        statuses=(
            (SystemStatus.END_OF_FILE, "that was the rest, and the file is closed; bytes beyond its size are dropped"),
            (
                SystemStatus.UNKNOWN_HANDLE,
                "no file is open under that handle: it is complete, closed, or was never begun",
            ),
            (SystemStatus.UNKNOWN_ERROR, "the handle is known, but its file is not open"),
        ),
    ),
    SystemCommand(
        0x94,
        "BEGIN_UPLOAD",
        "Opens a file on the brick for reading and fetches its first piece",
        (_MAX_BYTES, _PATH),
        (_SIZE, _REPLY_HANDLE, _DATA),
        transfer="begin",
        effects=(Effect.VARIES,),
        statuses=(
            (SystemStatus.END_OF_FILE, "all of the file is in this reply"),
            (SystemStatus.UNKNOWN_HANDLE, "there is no such file"),
            (SystemStatus.NO_HANDLES_AVAILABLE, "all handles are in use"),
        ),
    ),
    SystemCommand(
        0x95,
        "CONTINUE_UPLOAD",
        "Fetches the next piece of a file",
        (_HANDLE, _MAX_BYTES),
        (_REPLY_HANDLE, _DATA),
        transfer="continue",
        effects=(Effect.VARIES,),
        statuses=(
            (SystemStatus.END_OF_FILE, "that was the rest of the file"),
            (SystemStatus.HANDLE_NOT_READY, "the handle is known, but its file is not open"),
            (SystemStatus.UNKNOWN_HANDLE, "no file is open under that handle"),
        ),
    ),
    SystemCommand(
        0x96,
        "BEGIN_GETFILE",
        "Opens a file that may still be growing, such as a data log, and fetches its first piece",
        (_MAX_BYTES, _PATH),
        (_SIZE, _REPLY_HANDLE, _DATA),
        transfer="begin",
        effects=(Effect.VARIES,),
        statuses=(
            (SystemStatus.END_OF_FILE, "all that the file has so far is in this reply"),
            (SystemStatus.HANDLE_NOT_READY, "there is no such file"),
            (SystemStatus.UNKNOWN_HANDLE, "all handles are in use"),
        ),
    ),
    SystemCommand(
        0x97,
        "CONTINUE_GETFILE",
        "Fetches the next piece of a file that may still be growing",
        (_HANDLE, _MAX_BYTES),
        (_SIZE, _REPLY_HANDLE, _DATA),
        transfer="continue",
        effects=(Effect.VARIES,),
        statuses=(
            (SystemStatus.END_OF_FILE, "that was all that the file has so far"),
            (SystemStatus.HANDLE_NOT_READY, "the handle is known, but its file is not open"),
            (SystemStatus.UNKNOWN_HANDLE, "no file is open under that handle"),
        ),
    ),
    SystemCommand(
        0x98,
        "CLOSE_FILEHANDLE",
        "Closes an open file before its end",
        (_HANDLE, Field("hash", Kind.DATA, "MD5 of the file, often omitted", optional=True, most=16)),
        # The firmware's structure has a handle in the reply, the published text has none: both occur.
        (Field("handle", Kind.U8, "the file that was closed", optional=True),),
        transfer="close",
        statuses=((SystemStatus.UNKNOWN_HANDLE, "no file is open under that handle"),),
    ),
    SystemCommand(
        0x99,
        "LIST_FILES",
        "Lists a folder and fetches the first piece of the listing",
        (_MAX_BYTES, _PATH),
        (Field("list_size", Kind.U32, "bytes of the whole listing"), _REPLY_HANDLE, _LIST),
        transfer="begin",
        effects=(Effect.VARIES,),
        statuses=(
            (SystemStatus.END_OF_FILE, "all of the listing is in this reply"),
            (SystemStatus.UNKNOWN_ERROR, "there is no such folder, or no handle is free"),
        ),
    ),
    SystemCommand(
        0x9A,
        "CONTINUE_LIST_FILES",
        "Fetches the next piece of a listing",
        (_HANDLE, _MAX_BYTES),
        (_REPLY_HANDLE, _LIST),
        transfer="continue",
        effects=(Effect.VARIES,),
        statuses=(
            (SystemStatus.END_OF_FILE, "that was the rest of the listing"),
            (SystemStatus.UNKNOWN_ERROR, "the handle holds no listing"),
        ),
    ),
    SystemCommand(
        0x9B,
        "CREATE_DIR",
        "Makes a folder",
        (_PATH,),
        effects=(Effect.WRITES_FILES,),
        statuses=(
            (
                SystemStatus.NO_PERMISSION,
                "it cannot be made: it exists, its parent does not, or it is not allowed there",
            ),
        ),
    ),
    SystemCommand(
        0x9C,
        "DELETE_FILE",
        "Deletes a file or an empty folder",
        (_PATH,),
        effects=(Effect.DELETES_FILES,),
        statuses=(
            (
                SystemStatus.NO_PERMISSION,
                "it cannot be removed: it does not exist, is not empty, or it is not allowed there",
            ),
        ),
    ),
    SystemCommand(
        0x9D,
        "LIST_OPEN_HANDLES",
        "Asks which file handles are in use",
        (),
        (Field("handles", Kind.DATA, "a bit for every handle, set while it is in use"),),
    ),
    SystemCommand(
        0x9E,
        "WRITEMAILBOX",
        "Puts a message into a mailbox of the program that runs on the brick",
        (
            # Published text counts the name without its zero, the firmware sends and expects it counted in.
            Field("name_length", Kind.U8, "bytes of the name, with or without its zero", counts="name"),
            Field("name", Kind.COUNTED_TEXT, "the mailbox"),
            Field("payload_length", Kind.U16, "bytes of the message", counts="payload"),
            Field(
                "payload",
                Kind.DATA,
                "the message: a text (with its zero), a number (a single), a logic value (one byte), or other bytes",
                is_message=True,
            ),
        ),
        answered=False,
        effects=(Effect.SENDS_MESSAGES,),
    ),
    SystemCommand(
        0x9F,
        "BLUETOOTHPIN",
        "Hands over the PIN for a Bluetooth device (USB only)",
        _PIN,
        _PIN,
        usb_only=True,
        effects=(Effect.CHANGES_SETTINGS,),
        statuses=((SystemStatus.ILLEGAL_CONNECTION, "this works by USB only"),),
    ),
    SystemCommand(
        0xA0,
        "ENTERFWUPDATE",
        "Restarts the brick into its firmware updater",
        answered=False,
        effects=(Effect.RESTARTS,),
    ),
    SystemCommand(
        0xA1,
        "SETBUNDLEID",
        "Sets the bundle identifier with which the brick shows itself to Apple devices",
        (Field("id", Kind.TEXT, "the identifier", most=24),),
        effects=(Effect.CHANGES_SETTINGS,),
    ),
    SystemCommand(
        0xA2,
        "SETBUNDLESEEDID",
        "Sets the bundle seed identifier with which the brick shows itself to Apple devices",
        (Field("id", Kind.TEXT, "the identifier", most=11),),
        effects=(Effect.CHANGES_SETTINGS,),
    ),
    SystemCommand(
        0xF0,
        "BEGIN_DOWNLOAD_WITH_ERASE",
        "Erases a region of the flash memory and makes ready to write it",
        (_ADDRESS, _IMAGE_SIZE),
        bootloader=True,
        effects=(Effect.WRITES_FIRMWARE,),
    ),
    SystemCommand(
        0xF1,
        "BEGIN_DOWNLOAD",
        "Makes ready to write a region of the flash memory that is already erased",
        (_ADDRESS, _IMAGE_SIZE),
        bootloader=True,
        effects=(Effect.WRITES_FIRMWARE,),
    ),
    SystemCommand(
        0xF2,
        "DOWNLOAD_DATA",
        "Writes the next piece of the image",
        (Field("data", Kind.DATA, "a piece of the image", most=1018),),
        bootloader=True,
        effects=(Effect.WRITES_FIRMWARE,),
    ),
    SystemCommand(
        0xF3, "CHIP_ERASE", "Erases the whole flash memory", bootloader=True, effects=(Effect.WRITES_FIRMWARE,)
    ),
    SystemCommand(
        0xF4, "START_APP", "Leaves the updater and starts the firmware", bootloader=True, effects=(Effect.RESTARTS,)
    ),
    SystemCommand(
        0xF5,
        "GET_CHECKSUM",
        "Asks for the checksum of a region of the flash memory",
        (_ADDRESS, _IMAGE_SIZE),
        (Field("checksum", Kind.U32, "CRC-32 of the region"),),
        bootloader=True,
    ),
    SystemCommand(
        0xF6,
        "GET_VERSION",
        "Asks for the versions of hardware and firmware",
        (),
        # Published sources disagree on which of the two comes first.
        (
            Field("hardware_version", Kind.U32, "version of the hardware"),
            Field("firmware_version", Kind.U32, "version of the updater"),
        ),
        bootloader=True,
    ),
)

SYSTEM_BY_NUMBER = {entry.number: entry for entry in SYSTEM}
"""The same by number; names are not unique, BEGIN_DOWNLOAD is the bootloader's too."""


def status_meaning(number: int, status: int) -> str | None:
    """What a status means as the answer to a system command; None where the firmware does not answer so."""
    entry = SYSTEM_BY_NUMBER.get(number)
    return None if entry is None else dict[int, str](entry.statuses).get(status)


LONG_COMMANDS = frozenset(entry.number for entry in SYSTEM if entry.is_long)
"""Numbers of those whose frame may be longer than MAX_FRAME."""

UNUSED_STATUSES = frozenset(
    {
        SystemStatus.CORRUPT_FILE,
        SystemStatus.ILLEGAL_PATH,
        SystemStatus.FILE_EXITS,
        SystemStatus.ILLEGAL_FILENAME,
    }
)
"""Statuses that have a name, and that no command of the published firmware answers with."""

"""System commands: files, mailboxes, Bluetooth PINs, the bootloader. Their fields and those of their replies.

Not byte code: a number and fields of fixed kinds. A reply repeats the number, then has a status and fields.
"""

from enum import Enum, IntEnum
from typing import NamedTuple

from ev3proto.tables.declaration import Effect


class FieldKind(Enum):
    """The encoding of a field in the frame."""

    U8 = "u8"
    U16 = "u16"
    U32 = "u32"
    TEXT = "text"
    COUNTED_TEXT = "counted text"
    DATA = "data"
    LISTING = "listing"


class SystemField(NamedTuple):
    """One field of a system message.

    name      its name in this package, in JSON and in filters
    kind      number, text up to a zero, text with its length in the field before, or all remaining bytes
    text      one line of description
    counts    for lengths: the field whose bytes they count; computed if omitted when building
    optional  senders may omit it
    most      largest number of bytes, where the firmware has a limit
    is_message  the message of a mailbox (text, number or logic value), which `tables.mailboxes` reads
    is_public   a text of files and mailboxes, which `proxy --hide` shows as it shows their contents
    """

    name: str
    kind: FieldKind
    text: str
    counts: str | None = None
    optional: bool = False
    most: int | None = None
    is_message: bool = False
    is_public: bool = False


class SystemStatus(IntEnum):
    """The status of a system command. FILE_EXITS is the firmware's spelling."""

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
        """Whether the command failed. END_OF_FILE, at the end of every upload, is a success."""
        return self not in (SystemStatus.SUCCESS, SystemStatus.END_OF_FILE)


class SystemDeclaration(NamedTuple):
    """One system command: number, name, one line of description, the fields of request and reply.

    answered    False if the brick never replies to it
    bootloader  only the brick's firmware updater knows it (USB only)
    transfer    its part in a file transfer: `begin`, `continue` or `close`, or None
    usb_only    the firmware accepts it only by USB
    effects     its side effects on the brick
    is_long     its frame may be longer than MAX_FRAME: the firmware reads the rest in pieces
    statuses    the meanings of the statuses other than SUCCESS that the firmware answers with
    """

    number: int
    name: str
    text: str
    request: tuple[SystemField, ...] = ()
    reply: tuple[SystemField, ...] = ()
    answered: bool = True
    bootloader: bool = False
    transfer: str | None = None
    usb_only: bool = False
    effects: tuple[Effect, ...] = ()
    is_long: bool = False
    statuses: tuple[tuple[SystemStatus, str], ...] = ()


_PATH = SystemField(
    "path", FieldKind.TEXT, "path of the file or folder, absolute or relative to /home/root/lms2012/sys", is_public=True
)
_HANDLE = SystemField("handle", FieldKind.U8, "the open file on the brick, as its reply to BEGIN_... gave it")
_REPLY_HANDLE = SystemField("handle", FieldKind.U8, "the open file, for the messages that follow")
FLASH_SIZE = 16 << 20
"""Bytes of a brick's flash memory."""

_SIZE = SystemField("size", FieldKind.U32, "bytes of the whole file")
_MAX_BYTES = SystemField("max_bytes", FieldKind.U16, "maximum number of content bytes in the reply")
_DATA = SystemField("data", FieldKind.DATA, "a piece of the file's contents")
_LIST = SystemField(
    "list", FieldKind.LISTING, "a piece of the listing: lines with MD5, size and name, or a folder's name and /"
)
_ADDRESS = SystemField("address", FieldKind.U32, "address of the first byte in flash memory")
_IMAGE_SIZE = SystemField("image_size", FieldKind.U32, "bytes of the image or region")
_PIN = (
    SystemField("mac_length", FieldKind.U8, "bytes of the MAC address", counts="mac"),
    SystemField("mac", FieldKind.COUNTED_TEXT, "MAC address of the other device, in hex"),
    SystemField("pin_length", FieldKind.U8, "bytes of the PIN", counts="pin"),
    SystemField("pin", FieldKind.COUNTED_TEXT, "the PIN"),
)

SYSTEM = (
    SystemDeclaration(
        0x92,
        "BEGIN_DOWNLOAD",
        "Opens a file on the brick for writing and announces its size",
        (_SIZE, _PATH, SystemField("data", FieldKind.DATA, "the first bytes of the file, usually none", optional=True)),
        (_REPLY_HANDLE,),
        transfer="begin",
        effects=(Effect.WRITES_FILES,),
        is_long=True,
        statuses=(
            (SystemStatus.END_OF_FILE, "the file is complete: its size is 0, or this frame held all of it"),
            (
                SystemStatus.UNKNOWN_HANDLE,
                "the file cannot be created: it is a folder, or the file system refuses the name",
            ),
            (
                SystemStatus.SIZE_ERROR,
                "there is not enough room for a file of that size, or the frame had more data than announced",
            ),
            (
                SystemStatus.NO_HANDLES_AVAILABLE,
                "all handles are in use: earlier files were neither completed nor closed",
            ),
        ),
    ),
    SystemDeclaration(
        0x93,
        "CONTINUE_DOWNLOAD",
        "Writes the next piece of a file; the file closes itself when it is complete",
        (_HANDLE, _DATA),
        (_REPLY_HANDLE,),
        transfer="continue",
        effects=(Effect.WRITES_FILES,),
        is_long=True,
        statuses=(
            (SystemStatus.END_OF_FILE, "the file is now complete and closed; bytes beyond its size are dropped"),
            (
                SystemStatus.UNKNOWN_HANDLE,
                "no file is open under that handle: it is complete, closed, or was never opened",
            ),
            (SystemStatus.UNKNOWN_ERROR, "the handle is known, but its file is not open"),
        ),
    ),
    SystemDeclaration(
        0x94,
        "BEGIN_UPLOAD",
        "Opens a file on the brick for reading and fetches its first piece",
        (_MAX_BYTES, _PATH),
        (_SIZE, _REPLY_HANDLE, _DATA),
        transfer="begin",
        effects=(Effect.VARIES, Effect.READS),
        statuses=(
            (SystemStatus.END_OF_FILE, "this reply holds the whole file"),
            (SystemStatus.UNKNOWN_HANDLE, "no such file"),
            (SystemStatus.NO_HANDLES_AVAILABLE, "all handles are in use"),
        ),
    ),
    SystemDeclaration(
        0x95,
        "CONTINUE_UPLOAD",
        "Fetches the next piece of a file",
        (_HANDLE, _MAX_BYTES),
        (_REPLY_HANDLE, _DATA),
        transfer="continue",
        effects=(Effect.VARIES, Effect.READS),
        statuses=(
            (SystemStatus.END_OF_FILE, "that was the last piece of the file"),
            (SystemStatus.HANDLE_NOT_READY, "the handle is known, but its file is not open"),
            (SystemStatus.UNKNOWN_HANDLE, "no file is open under that handle"),
        ),
    ),
    SystemDeclaration(
        0x96,
        "BEGIN_GETFILE",
        "Opens a file that may still be growing, such as a data log, and fetches its first piece",
        (_MAX_BYTES, _PATH),
        (_SIZE, _REPLY_HANDLE, _DATA),
        transfer="begin",
        effects=(Effect.VARIES, Effect.READS),
        statuses=(
            (SystemStatus.END_OF_FILE, "this reply holds all that the file has so far"),
            (SystemStatus.HANDLE_NOT_READY, "no such file"),
            (SystemStatus.UNKNOWN_HANDLE, "all handles are in use"),
        ),
    ),
    SystemDeclaration(
        0x97,
        "CONTINUE_GETFILE",
        "Fetches the next piece of a file that may still be growing",
        (_HANDLE, _MAX_BYTES),
        (_SIZE, _REPLY_HANDLE, _DATA),
        transfer="continue",
        effects=(Effect.VARIES, Effect.READS),
        statuses=(
            (SystemStatus.END_OF_FILE, "that was the last of what the file has so far"),
            (SystemStatus.HANDLE_NOT_READY, "the handle is known, but its file is not open"),
            (SystemStatus.UNKNOWN_HANDLE, "no file is open under that handle"),
        ),
    ),
    SystemDeclaration(
        0x98,
        "CLOSE_FILEHANDLE",
        "Closes an open file before its end",
        (_HANDLE, SystemField("hash", FieldKind.DATA, "MD5 of the file, often omitted", optional=True, most=16)),
        # The firmware's structure has a handle in the reply, the published text has not; both occur.
        (SystemField("handle", FieldKind.U8, "the file that was closed", optional=True),),
        transfer="close",
        statuses=((SystemStatus.UNKNOWN_HANDLE, "no file is open under that handle"),),
        effects=(Effect.READS,),
    ),
    SystemDeclaration(
        0x99,
        "LIST_FILES",
        "Lists a folder and fetches the first piece of the listing",
        (_MAX_BYTES, _PATH),
        (SystemField("list_size", FieldKind.U32, "bytes of the whole listing"), _REPLY_HANDLE, _LIST),
        transfer="begin",
        effects=(Effect.VARIES, Effect.READS),
        statuses=(
            (SystemStatus.END_OF_FILE, "this reply holds the whole listing"),
            (SystemStatus.UNKNOWN_ERROR, "no such folder, or no free handle"),
        ),
    ),
    SystemDeclaration(
        0x9A,
        "CONTINUE_LIST_FILES",
        "Fetches the next piece of a listing",
        (_HANDLE, _MAX_BYTES),
        (_REPLY_HANDLE, _LIST),
        transfer="continue",
        effects=(Effect.VARIES, Effect.READS),
        statuses=(
            (SystemStatus.END_OF_FILE, "that was the last piece of the listing"),
            (SystemStatus.UNKNOWN_ERROR, "the handle holds no listing"),
        ),
    ),
    SystemDeclaration(
        0x9B,
        "CREATE_DIR",
        "Creates a folder",
        (_PATH,),
        effects=(Effect.WRITES_FILES,),
        statuses=(
            (
                SystemStatus.NO_PERMISSION,
                "it cannot be created: it exists, its parent does not, or permission is denied",
            ),
        ),
    ),
    SystemDeclaration(
        0x9C,
        "DELETE_FILE",
        "Deletes a file or an empty folder",
        (_PATH,),
        effects=(Effect.DELETES_FILES,),
        statuses=(
            (
                SystemStatus.NO_PERMISSION,
                "it cannot be removed: it does not exist, is not empty, or permission is denied",
            ),
        ),
    ),
    SystemDeclaration(
        0x9D,
        "LIST_OPEN_HANDLES",
        "Asks which file handles are in use",
        (),
        (SystemField("handles", FieldKind.DATA, "one bit per handle, set while it is in use"),),
        effects=(Effect.READS,),
    ),
    SystemDeclaration(
        0x9E,
        "WRITEMAILBOX",
        "Puts a message into a mailbox of the program that runs on the brick",
        (
            # The published text counts the name without its zero; the firmware counts the zero, too.
            SystemField("name_length", FieldKind.U8, "bytes of the name, with or without its zero", counts="name"),
            SystemField("name", FieldKind.COUNTED_TEXT, "the mailbox", is_public=True),
            SystemField("payload_length", FieldKind.U16, "bytes of the message", counts="payload"),
            SystemField(
                "payload",
                FieldKind.DATA,
                "the message: a text (with its zero), a number (a single), a logic value (one byte), or other bytes",
                is_message=True,
            ),
        ),
        answered=False,
        effects=(Effect.SENDS_MESSAGES,),
    ),
    SystemDeclaration(
        0x9F,
        "BLUETOOTHPIN",
        "Sends the PIN for a Bluetooth device (USB only)",
        _PIN,
        _PIN,
        usb_only=True,
        effects=(Effect.CHANGES_SETTINGS,),
        statuses=((SystemStatus.ILLEGAL_CONNECTION, "this works by USB only"),),
    ),
    SystemDeclaration(
        0xA0,
        "ENTERFWUPDATE",
        "Restarts the brick into its firmware updater",
        answered=False,
        effects=(Effect.RESTARTS,),
    ),
    SystemDeclaration(
        0xA1,
        "SETBUNDLEID",
        "Sets the bundle identifier that the brick shows to Apple devices",
        (SystemField("id", FieldKind.TEXT, "the identifier", most=24),),
        effects=(Effect.CHANGES_SETTINGS,),
    ),
    SystemDeclaration(
        0xA2,
        "SETBUNDLESEEDID",
        "Sets the bundle seed identifier that the brick shows to Apple devices",
        (SystemField("id", FieldKind.TEXT, "the identifier", most=11),),
        effects=(Effect.CHANGES_SETTINGS,),
    ),
    SystemDeclaration(
        0xF0,
        "BEGIN_DOWNLOAD_WITH_ERASE",
        "Erases a region of the flash memory and prepares to write it",
        (_ADDRESS, _IMAGE_SIZE),
        bootloader=True,
        effects=(Effect.WRITES_FIRMWARE,),
    ),
    SystemDeclaration(
        0xF1,
        "BEGIN_DOWNLOAD",
        "Prepares to write a region of the flash memory that is already erased",
        (_ADDRESS, _IMAGE_SIZE),
        bootloader=True,
        effects=(Effect.WRITES_FIRMWARE,),
    ),
    SystemDeclaration(
        0xF2,
        "DOWNLOAD_DATA",
        "Writes the next piece of the image",
        (SystemField("data", FieldKind.DATA, "a piece of the image", most=1018),),
        bootloader=True,
        effects=(Effect.WRITES_FIRMWARE,),
    ),
    SystemDeclaration(
        0xF3, "CHIP_ERASE", "Erases the whole flash memory", bootloader=True, effects=(Effect.WRITES_FIRMWARE,)
    ),
    SystemDeclaration(
        0xF4, "START_APP", "Leaves the updater and starts the firmware", bootloader=True, effects=(Effect.RESTARTS,)
    ),
    SystemDeclaration(
        0xF5,
        "GET_CHECKSUM",
        "Asks for the checksum of a region of the flash memory",
        (_ADDRESS, _IMAGE_SIZE),
        (SystemField("checksum", FieldKind.U32, "CRC-32 of the region"),),
        bootloader=True,
        effects=(Effect.COMPUTES,),
    ),
    SystemDeclaration(
        0xF6,
        "GET_VERSION",
        "Asks for the versions of hardware and firmware",
        (),
        # Published sources disagree on the order of the two.
        (
            SystemField("hardware_version", FieldKind.U32, "version of the hardware"),
            SystemField("firmware_version", FieldKind.U32, "version of the updater"),
        ),
        bootloader=True,
        effects=(Effect.COMPUTES,),
    ),
)

SYSTEM_BY_NUMBER = {entry.number: entry for entry in SYSTEM}
"""System commands by number; names are not unique, the bootloader has a BEGIN_DOWNLOAD, too."""


def status_meaning(number: int, status: int) -> str | None:
    """Returns the meaning of a status as the answer to a system command; None if the firmware never answers with it."""
    entry = SYSTEM_BY_NUMBER.get(number)
    return None if entry is None else dict[int, str](entry.statuses).get(status)


LONG_COMMANDS = frozenset(entry.number for entry in SYSTEM if entry.is_long)
"""Numbers of the commands whose frames may be longer than MAX_FRAME."""

UNUSED_STATUSES = frozenset(
    {
        SystemStatus.CORRUPT_FILE,
        SystemStatus.ILLEGAL_PATH,
        SystemStatus.FILE_EXITS,
        SystemStatus.ILLEGAL_FILENAME,
    }
)
"""Named statuses that no command of the published firmware answers with."""

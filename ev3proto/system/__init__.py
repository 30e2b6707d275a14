"""Every system command as a function: `system.list_files("/home/root/lms2012/sys/")`, and files split into
commands.

Names are the firmware's in lower case; those of the bootloader are in `system.bootloader`. A path comes
first, lengths are computed, and replies are as long as possible by default. `download` and `pieces`
make several commands each.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from ev3proto.messages import SystemCommand
from ev3proto.system import bootloader
from ev3proto.system.moving import download, pieces
from ev3proto.system.requests import request

__all__ = [
    "begin_download",
    "begin_getfile",
    "begin_upload",
    "bluetoothpin",
    "bootloader",
    "close_filehandle",
    "continue_download",
    "continue_getfile",
    "continue_list_files",
    "continue_upload",
    "create_dir",
    "delete_file",
    "download",
    "enterfwupdate",
    "list_files",
    "list_open_handles",
    "pieces",
    "setbundleid",
    "setbundleseedid",
    "writemailbox",
]


def begin_download(
    path: str,
    size: int,
    data: bytes | None = None,
    *,
    counter: int = 0,
    reply: bool = True,
) -> SystemCommand:
    """Opens a file on the brick for writing and announces its size.

    Args:
        path: Path of the file or folder, absolute or relative to /home/root/lms2012/sys.
        size: Bytes of the whole file; 0 to 4294967295.
        data: The first bytes of the file, usually none.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x92, counter, reply, path=path, size=size, data=data)


def continue_download(handle: int, data: bytes, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Writes the next piece of a file; the file closes itself when it is complete.

    Args:
        handle: The open file on the brick, as its reply to BEGIN_... gave it; 0 to 255.
        data: A piece of the file's contents.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x93, counter, reply, handle=handle, data=data)


def begin_upload(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Opens a file on the brick for reading and fetches its first piece.

    Args:
        path: Path of the file or folder, absolute or relative to /home/root/lms2012/sys.
        max_bytes: Maximum number of content bytes in the reply; 0 to 65535.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x94, counter, reply, path=path, max_bytes=max_bytes)


def continue_upload(handle: int, max_bytes: int = 1016, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Fetches the next piece of a file.

    Args:
        handle: The open file on the brick, as its reply to BEGIN_... gave it; 0 to 255.
        max_bytes: Maximum number of content bytes in the reply; 0 to 65535.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x95, counter, reply, handle=handle, max_bytes=max_bytes)


def begin_getfile(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Opens a file that may still be growing, such as a data log, and fetches its first piece.

    Args:
        path: Path of the file or folder, absolute or relative to /home/root/lms2012/sys.
        max_bytes: Maximum number of content bytes in the reply; 0 to 65535.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x96, counter, reply, path=path, max_bytes=max_bytes)


def continue_getfile(handle: int, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Fetches the next piece of a file that may still be growing.

    Args:
        handle: The open file on the brick, as its reply to BEGIN_... gave it; 0 to 255.
        max_bytes: Maximum number of content bytes in the reply; 0 to 65535.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x97, counter, reply, handle=handle, max_bytes=max_bytes)


def close_filehandle(handle: int, hash: bytes | None = None, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Closes an open file before its end.

    Args:
        handle: The open file on the brick, as its reply to BEGIN_... gave it; 0 to 255.
        hash: MD5 of the file, often omitted; at most 16 bytes.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x98, counter, reply, handle=handle, hash=hash)


def list_files(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Lists a folder and fetches the first piece of the listing.

    Args:
        path: Path of the file or folder, absolute or relative to /home/root/lms2012/sys.
        max_bytes: Maximum number of content bytes in the reply; 0 to 65535.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x99, counter, reply, path=path, max_bytes=max_bytes)


def continue_list_files(handle: int, max_bytes: int = 1016, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Fetches the next piece of a listing.

    Args:
        handle: The open file on the brick, as its reply to BEGIN_... gave it; 0 to 255.
        max_bytes: Maximum number of content bytes in the reply; 0 to 65535.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x9A, counter, reply, handle=handle, max_bytes=max_bytes)


def create_dir(path: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Creates a folder.

    Args:
        path: Path of the file or folder, absolute or relative to /home/root/lms2012/sys.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x9B, counter, reply, path=path)


def delete_file(path: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Deletes a file or an empty folder.

    Args:
        path: Path of the file or folder, absolute or relative to /home/root/lms2012/sys.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x9C, counter, reply, path=path)


def list_open_handles(*, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Asks which file handles are in use.

    Args:
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x9D, counter, reply)


def writemailbox(
    name: str,
    payload: str | float | bytes,
    name_length: int | None = None,
    payload_length: int | None = None,
    *,
    counter: int = 0,
    reply: bool = False,
) -> SystemCommand:
    """Puts a message into a mailbox of the program that runs on the brick.

    Args:
        name: The mailbox.
        payload: The message: a text (with its zero), a number (a single), a logic value (one byte), or other bytes.
        name_length: Bytes of the name, with or without its zero; 0 to 255; computed from name when omitted.
        payload_length: Bytes of the message; 0 to 65535; computed from payload when omitted.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer; it never answers this command.
    """
    return request(
        0x9E,
        counter,
        reply,
        name=name,
        payload=payload,
        name_length=name_length,
        payload_length=payload_length,
    )


def bluetoothpin(
    mac: str,
    pin: str,
    mac_length: int | None = None,
    pin_length: int | None = None,
    *,
    counter: int = 0,
    reply: bool = True,
) -> SystemCommand:
    """Sends the PIN for a Bluetooth device (USB only).

    Args:
        mac: MAC address of the other device, in hex.
        pin: The PIN.
        mac_length: Bytes of the MAC address; 0 to 255; computed from mac when omitted.
        pin_length: Bytes of the PIN; 0 to 255; computed from pin when omitted.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0x9F, counter, reply, mac=mac, pin=pin, mac_length=mac_length, pin_length=pin_length)


def enterfwupdate(*, counter: int = 0, reply: bool = False) -> SystemCommand:
    """Restarts the brick into its firmware updater.

    Args:
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer; it never answers this command.
    """
    return request(0xA0, counter, reply)


def setbundleid(id: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Sets the bundle identifier that the brick shows to Apple devices.

    Args:
        id: The identifier; at most 24 bytes with its zero.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xA1, counter, reply, id=id)


def setbundleseedid(id: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Sets the bundle seed identifier that the brick shows to Apple devices.

    Args:
        id: The identifier; at most 11 bytes with its zero.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xA2, counter, reply, id=id)

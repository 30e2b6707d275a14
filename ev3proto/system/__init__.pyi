"""Every system command as a function.

Generated from ev3proto/tables by ev3proto.generate.stubs: edit those.
"""

from ev3proto.messages import SystemCommand
from ev3proto.system.moving import download as download
from ev3proto.system.moving import pieces as pieces

def begin_download(path: str, size: int, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Opens a file on the brick for writing and says how long it will be.

    path     where the file or folder is, absolute or relative to /home/root/lms2012/sys
    size     bytes of the whole file; 0 to 4294967295
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def continue_download(handle: int, data: bytes, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Writes the next piece of a file; the file closes itself when it is complete.

    handle   the open file on the brick, as its reply to BEGIN_... gave it; 0 to 255
    data     a piece of the file's contents
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def begin_upload(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Opens a file on the brick for reading and fetches its first piece.

    path       where the file or folder is, absolute or relative to /home/root/lms2012/sys
    max_bytes  most bytes of contents that the reply may carry; 0 to 65535
    counter    of the message, 0 to 65535
    reply      whether the brick is to answer
    """

def continue_upload(handle: int, max_bytes: int = 1016, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Fetches the next piece of a file.

    handle     the open file on the brick, as its reply to BEGIN_... gave it; 0 to 255
    max_bytes  most bytes of contents that the reply may carry; 0 to 65535
    counter    of the message, 0 to 65535
    reply      whether the brick is to answer
    """

def begin_getfile(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Opens a file that may still be growing, such as a data log, and fetches its first piece.

    path       where the file or folder is, absolute or relative to /home/root/lms2012/sys
    max_bytes  most bytes of contents that the reply may carry; 0 to 65535
    counter    of the message, 0 to 65535
    reply      whether the brick is to answer
    """

def continue_getfile(handle: int, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Fetches the next piece of a file that may still be growing.

    handle     the open file on the brick, as its reply to BEGIN_... gave it; 0 to 255
    max_bytes  most bytes of contents that the reply may carry; 0 to 65535
    counter    of the message, 0 to 65535
    reply      whether the brick is to answer
    """

def close_filehandle(
    handle: int,
    hash: bytes | None = None,
    *,
    counter: int = 0,
    reply: bool = True,
) -> SystemCommand:
    """Closes an open file before its end.

    handle   the open file on the brick, as its reply to BEGIN_... gave it; 0 to 255
    hash     MD5 of the file, often left away; at most 16 bytes
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def list_files(path: str, max_bytes: int = 1012, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Lists a folder and fetches the first piece of the listing.

    path       where the file or folder is, absolute or relative to /home/root/lms2012/sys
    max_bytes  most bytes of contents that the reply may carry; 0 to 65535
    counter    of the message, 0 to 65535
    reply      whether the brick is to answer
    """

def continue_list_files(
    handle: int,
    max_bytes: int = 1016,
    *,
    counter: int = 0,
    reply: bool = True,
) -> SystemCommand:
    """Fetches the next piece of a listing.

    handle     the open file on the brick, as its reply to BEGIN_... gave it; 0 to 255
    max_bytes  most bytes of contents that the reply may carry; 0 to 65535
    counter    of the message, 0 to 65535
    reply      whether the brick is to answer
    """

def create_dir(path: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Makes a folder.

    path     where the file or folder is, absolute or relative to /home/root/lms2012/sys
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def delete_file(path: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Deletes a file or an empty folder.

    path     where the file or folder is, absolute or relative to /home/root/lms2012/sys
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def list_open_handles(*, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Asks which file handles are in use.

    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def writemailbox(
    name: str,
    payload: bytes,
    name_length: int | None = None,
    payload_length: int | None = None,
    *,
    counter: int = 0,
    reply: bool = False,
) -> SystemCommand:
    """Puts a message into a mailbox of the program that runs on the brick.

    name            the mailbox
    payload         the message: a text with its zero, a float, or one byte for a logic value
    name_length     bytes of the name, with or without its zero; 0 to 255; worked out from name when left away
    payload_length  bytes of the message; 0 to 65535; worked out from payload when left away
    counter         of the message, 0 to 65535
    reply           whether the brick is to answer; it never does to this one
    """

def bluetoothpin(
    mac: str,
    pin: str,
    mac_length: int | None = None,
    pin_length: int | None = None,
    *,
    counter: int = 0,
    reply: bool = True,
) -> SystemCommand:
    """Hands over the PIN for a Bluetooth device (USB only).

    mac         MAC address of the other device, in hex
    pin         the PIN
    mac_length  bytes of the MAC address; 0 to 255; worked out from mac when left away
    pin_length  bytes of the PIN; 0 to 255; worked out from pin when left away
    counter     of the message, 0 to 65535
    reply       whether the brick is to answer
    """

def enterfwupdate(*, counter: int = 0, reply: bool = False) -> SystemCommand:
    """Restarts the brick into its firmware updater.

    counter  of the message, 0 to 65535
    reply    whether the brick is to answer; it never does to this one
    """

def setbundleid(id: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Sets the bundle identifier with which the brick shows itself to Apple devices.

    id       the identifier; at most 24 bytes with its zero
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

def setbundleseedid(id: str, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Sets the bundle seed identifier with which the brick shows itself to Apple devices.

    id       the identifier; at most 11 bytes with its zero
    counter  of the message, 0 to 65535
    reply    whether the brick is to answer
    """

class _Bootloader:
    """What only the brick's firmware updater knows (USB only)."""

    def begin_download_with_erase(
        self,
        address: int,
        image_size: int,
        *,
        counter: int = 0,
        reply: bool = True,
    ) -> SystemCommand:
        """Erases a region of the flash memory and makes ready to write it.

        address     first byte of the flash memory meant; 0 to 4294967295
        image_size  bytes of the image or region; 0 to 4294967295
        counter     of the message, 0 to 65535
        reply       whether the brick is to answer
        """

    def begin_download(self, address: int, image_size: int, *, counter: int = 0, reply: bool = True) -> SystemCommand:
        """Makes ready to write a region of the flash memory that is already erased.

        address     first byte of the flash memory meant; 0 to 4294967295
        image_size  bytes of the image or region; 0 to 4294967295
        counter     of the message, 0 to 65535
        reply       whether the brick is to answer
        """

    def download_data(self, data: bytes, *, counter: int = 0, reply: bool = True) -> SystemCommand:
        """Writes the next piece of the image.

        data     a piece of the image; at most 1018 bytes
        counter  of the message, 0 to 65535
        reply    whether the brick is to answer
        """

    def chip_erase(self, *, counter: int = 0, reply: bool = True) -> SystemCommand:
        """Erases the whole flash memory.

        counter  of the message, 0 to 65535
        reply    whether the brick is to answer
        """

    def start_app(self, *, counter: int = 0, reply: bool = True) -> SystemCommand:
        """Leaves the updater and starts the firmware.

        counter  of the message, 0 to 65535
        reply    whether the brick is to answer
        """

    def get_checksum(self, address: int, image_size: int, *, counter: int = 0, reply: bool = True) -> SystemCommand:
        """Asks for the checksum of a region of the flash memory.

        address     first byte of the flash memory meant; 0 to 4294967295
        image_size  bytes of the image or region; 0 to 4294967295
        counter     of the message, 0 to 65535
        reply       whether the brick is to answer
        """

    def get_version(self, *, counter: int = 0, reply: bool = True) -> SystemCommand:
        """Asks for the versions of hardware and firmware.

        counter  of the message, 0 to 65535
        reply    whether the brick is to answer
        """

bootloader: _Bootloader

"""What only the brick's firmware updater knows (USB only).

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from ev3proto.messages import SystemCommand
from ev3proto.system.requests import request

__all__ = [
    "begin_download",
    "begin_download_with_erase",
    "chip_erase",
    "download_data",
    "get_checksum",
    "get_version",
    "start_app",
]


def begin_download_with_erase(address: int, image_size: int, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Erases a region of the flash memory and prepares to write it.

    Args:
        address: Address of the first byte in flash memory; 0 to 4294967295.
        image_size: Bytes of the image or region; 0 to 4294967295.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF0, counter, reply, address=address, image_size=image_size)


def begin_download(address: int, image_size: int, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Prepares to write a region of the flash memory that is already erased.

    Args:
        address: Address of the first byte in flash memory; 0 to 4294967295.
        image_size: Bytes of the image or region; 0 to 4294967295.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF1, counter, reply, address=address, image_size=image_size)


def download_data(data: bytes, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Writes the next piece of the image.

    Args:
        data: A piece of the image; at most 1018 bytes.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF2, counter, reply, data=data)


def chip_erase(*, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Erases the whole flash memory.

    Args:
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF3, counter, reply)


def start_app(*, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Leaves the updater and starts the firmware.

    Args:
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF4, counter, reply)


def get_checksum(address: int, image_size: int, *, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Asks for the checksum of a region of the flash memory.

    Args:
        address: Address of the first byte in flash memory; 0 to 4294967295.
        image_size: Bytes of the image or region; 0 to 4294967295.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF5, counter, reply, address=address, image_size=image_size)


def get_version(*, counter: int = 0, reply: bool = True) -> SystemCommand:
    """Asks for the versions of hardware and firmware.

    Args:
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
    """
    return request(0xF6, counter, reply)

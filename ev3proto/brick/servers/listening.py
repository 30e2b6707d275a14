"""The start of a server: a port on every address that a name stands for."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable


async def listen(client: Callable[[], asyncio.BaseProtocol], address: str, port: int) -> list[asyncio.Server]:
    """Opens a port, 0 for any that is free. Raises OSError, OverflowError and UnicodeError."""
    loop = asyncio.get_running_loop()
    places = await loop.getaddrinfo(address, port, type=socket.SOCK_STREAM)
    sockets = [socket.create_server(place[:2], family=family) for family, *_, place in places]
    return [await loop.create_server(client, sock=each) for each in sockets]

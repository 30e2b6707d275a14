"""Beacons on loopback, sent to a UDP port of the test: the usual port exists once per computer."""

from __future__ import annotations

import socket
import threading

BEACON = b"Serial-Number: %s\r\nPort: %d\r\nName: robot\r\nProtocol: EV3\r\n"


class Announcing:
    """Sends beacons to loopback, as a brick broadcasts them."""

    def __init__(self, serial_number: str, port: int, to: int, noise: bytes = b"") -> None:
        self.over = threading.Event()
        self.thread = threading.Thread(target=self.run, args=(serial_number, port, to, noise))

    def run(self, serial_number: str, port: int, to: int, noise: bytes) -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self.over.wait(0.02):
                if noise:
                    sender.sendto(noise, ("127.0.0.1", to))
                sender.sendto(BEACON % (serial_number.encode(), port), ("127.0.0.1", to))

    def __enter__(self) -> Announcing:
        self.thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.over.set()
        self.thread.join()


def free_udp_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port

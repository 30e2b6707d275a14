"""Clients that load a brick: `python -m benchmarks.load random PORT` or `slow PORT` attacks until it is terminated.

`random` sends random frames from twelve clients, without operations that wait, which keep a real brick waiting, too.
`slow` connects four clients again and again, each for one command of half a second.
"""

from __future__ import annotations

import contextlib
import sys
import threading

from support.attackers import OPERATIONS, Attacker
from support.server import Client, command

from ev3proto.tables.declaration import Effect

RANDOM, SLOW = 12, 4

_WAITING = {Effect.WAITS, Effect.AWAITS_MOVE, Effect.AWAITS_SOUND, Effect.CONTROLS_PROGRAMS}
_MAY_WAIT = ("ARRAY.FILL", "FILE.OPEN", "FILE.GET_HANDLE")
_QUICK = [one for one in OPERATIONS if _WAITING.isdisjoint(one.effects) and not one.name.startswith(_MAY_WAIT)]

HALF_A_SECOND = command("DATA32 timer\nTIMER_WAIT(500, timer)\nTIMER_READY(timer)")


def send_random(port: int, seed: int) -> None:
    """Sends random frames, cut anywhere, and connects again from time to time."""
    attacker = Attacker(seed, _QUICK, changed=0.0)
    while True:
        with contextlib.suppress(OSError), Client(port, timeout=0.02) as client:
            for _ in range(200):
                for chunk in attacker.chunks(3):
                    client.send(chunk)
                with contextlib.suppress(TimeoutError):
                    client.socket.recv(1 << 16)


def send_slow(port: int, _seed: int) -> None:
    """Connects for each command."""
    while True:
        with contextlib.suppress(OSError), Client(port) as client:
            client.ask(HALF_A_SECOND)


ATTACKS = {"random": (send_random, RANDOM), "slow": (send_slow, SLOW)}


def main() -> None:
    """Attacks until it is terminated."""
    attack, clients = ATTACKS[sys.argv[1]]
    for number in range(clients):
        threading.Thread(target=attack, args=(int(sys.argv[2]), number)).start()


if __name__ == "__main__":
    main()

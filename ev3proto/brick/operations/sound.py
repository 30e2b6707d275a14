"""SOUND: tones and files, and waiting for their end."""

from __future__ import annotations

from ev3proto.brick.exits import Busy
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.machine import Machine
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING

_EXTENSION = str(CONSTANTS["EXT_SOUND"]).encode(STRING_CODING)


def _play(vm: Machine, volume: int, name: bytes, *, is_repeated: bool) -> None:
    """Plays a file. One that does not exist keeps the speaker busy, as in the firmware."""
    folder = b"" if name.startswith(b".") else vm.program.folder.encode(STRING_CODING)
    file = vm.brick.files.read(folder + name + _EXTENSION)
    vm.brick.sound.play(volume, file or b"", is_repeated, vm.microseconds)


computes(
    {
        "SOUND.BREAK": lambda vm: vm.brick.sound.stop(),
        "SOUND.TONE": lambda vm, *tone: vm.brick.sound.tone(*tone, vm.microseconds),
        "SOUND.PLAY": lambda vm, volume, name: _play(vm, volume, name, is_repeated=False),
        "SOUND.REPEAT": lambda vm, volume, name: _play(vm, volume, name, is_repeated=True),
        "SOUND_TEST": lambda vm: vm.brick.sound.playing is not None,
    }
)


@handles("SOUND_READY")
def wait_for_silence(vm: Machine) -> None:
    """Waits until nothing is playing."""
    playing = vm.brick.sound.playing
    if playing is None:
        return
    if playing.ends is not None:
        raise Busy
    raise Busy(f"SOUND_READY waits for the end of {playing.kind}, which plays until SOUND.BREAK or another sound")

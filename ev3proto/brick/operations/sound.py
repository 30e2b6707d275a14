"""SOUND: tones and files, and waiting for their end."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING

_EXTENSION = str(CONSTANTS["EXT_SOUND"]).encode(STRING_CODING)


@handles("SOUND.BREAK")
def stop(vm: Machine) -> None:
    """Silence."""
    vm.brick.sound.stop()


@handles("SOUND.TONE")
def tone(vm: Machine, volume: int, frequency: int, duration: int) -> None:
    """A tone; its duration is read without sign."""
    vm.brick.sound.tone(volume, frequency, duration & 0xFFFF, vm.microseconds)


def _play(vm: Machine, volume: int, name: bytes, is_repeated: bool) -> None:
    """Plays a file; without such a file the driver finds out that there is nothing to play."""
    folder = b"" if name.startswith(b".") else vm.program.folder.encode(STRING_CODING)
    file = vm.brick.files.read(folder + name + _EXTENSION)
    vm.brick.sound.play(volume, file or b"", is_repeated and file is not None, vm.microseconds)


@handles("SOUND.PLAY")
def play(vm: Machine, volume: int, name: bytes) -> None:
    """A file, once."""
    _play(vm, volume, name, False)


@handles("SOUND.REPEAT")
def repeat(vm: Machine, volume: int, name: bytes) -> None:
    """A file, over and over."""
    _play(vm, volume, name, True)


@handles("SOUND.SERVICE")
def service(_: Machine) -> None:
    """The firmware's own business."""


@handles("SOUND_TEST")
def is_sounding(vm: Machine, busy: Place) -> None:
    """Whether something is playing."""
    busy.write8(vm.brick.sound.playing is not None)


@handles("SOUND_READY")
def wait_for_silence(vm: Machine) -> None:
    """Waits until nothing is playing."""
    if vm.brick.sound.playing is not None:
        vm.wait()

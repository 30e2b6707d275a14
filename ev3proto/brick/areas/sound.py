"""SOUND: tones and files, and waiting for their end."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.memory import Place


@handles("SOUND.BREAK")
def stop(vm: Machine) -> None:
    """Silence."""
    vm.brick.sound.stop()


@handles("SOUND.TONE")
def tone(vm: Machine, volume: int, frequency: int, duration: int) -> None:
    """A tone; its duration is read without sign."""
    vm.brick.sound.tone(volume, frequency, duration & 0xFFFF, vm.microseconds)


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

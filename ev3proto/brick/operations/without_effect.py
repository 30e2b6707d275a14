"""Operations without effect on a virtual brick: they do nothing, fail, wait forever or return a constant."""

from __future__ import annotations

from ev3proto.brick.exits import Busy, Failure
from ev3proto.brick.handlers import computes, handles, handles_unknown
from ev3proto.brick.machine import Machine


@handles(
    *("NOP", "LABEL", "BP_SET", "BP3", "PROBE", "SOUND.SERVICE"),
    # No other brick and no second program: nothing is sent, and nothing fails.
    *("COM_READY", "COM_REMOVE", "COM_WRITEFILE", "COM_WRITE.REPLY", "MAILBOX_WRITE"),
    # The state of the brick's own menus, of the test pin and of the power supply.
    *("UI_WRITE.INIT_RUN", "UI_WRITE.UPDATE_RUN", "UI_WRITE.DOWNLOAD_END", "UI_WRITE.SET_TESTPIN", "UI_WRITE.POWER"),
    # The I2C bus has no devices: the bytes to read stay as they were.
    "INPUT_DEVICE.SETUP",
    # Only remembered by the firmware.
    "OUTPUT_SET_TYPE",
)
def nothing(_: Machine, *__: object) -> None:
    """Has no effect that a program could see."""


@handles(
    *("ERROR", "FILE.GET_IMAGE", "UI_WRITE.ALLOW_PULSE", "UI_WRITE.SET_PULSE", "UI_WRITE.ADDRESS"),
    # They work on addresses of the real brick's memory.
    *("COM_READDATA", "COM_WRITEDATA", "DO", "UI_WRITE.CODE"),
    raw=True,
)
@handles_unknown("COM_GET", "COM_SET", "FILE", "PROGRAM_INFO", "UI_WRITE")
def fail(_: Machine) -> None:
    """Fails: the firmware of 2013 has no code for it, or none that could work here."""
    raise Failure


# No debugger is attached, no byte code is typed at the terminal; the firmware repeats an unknown ARRAY forever.
@handles("BP0", "BP1", "BP2", "UI_READ.GET_CODE", raw=True)
@handles_unknown("ARRAY")
def wait(_: Machine) -> None:
    """Waits forever."""
    raise Busy


computes(
    {
        # Commands are never run: the status of a brick without a shell.
        "SYSTEM": lambda *_: -1,
        # There is never a waiting direct command that a program could take.
        "COM_READ.COMMAND": lambda *_: (0, 0, 0),
        "COM_TEST": lambda *_: 0,
        "COM_GET.LIST_STATE": lambda *_: 0,
        # A virtual brick has neither a memory card nor a USB stick.
        "UI_READ.GET_SDCARD": lambda *_: (0, 0, 0),
        "UI_READ.GET_USBSTICK": lambda *_: (0, 0, 0),
        "UI_READ.GET_EVENT": lambda *_: 0,
        "UI_READ.GET_SHUTDOWN": lambda *_: 0,
        # No types are added to a virtual brick, and none of them are renumbered.
        "INPUT_DEVICE.INSERT_TYPE": lambda *_: 1,
        "INPUT_DEVICE.SET_TYPEMODE": lambda *_: 1,
    }
)

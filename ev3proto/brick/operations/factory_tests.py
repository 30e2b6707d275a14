"""TST: the factory tests. They have to be opened first, and close after 10 seconds; closed ones fail."""

from __future__ import annotations

from ev3proto.brick.exits import Failure
from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine

OPEN_MICROSECONDS = 10_000_000


@handles("TST.TST_OPEN")
def open_tests(vm: Machine) -> None:
    """Opens the tests for 10 seconds."""
    vm.brick.tests_until = vm.microseconds + OPEN_MICROSECONDS


@handles(
    *("TST.TST_WRITE_PINS", "TST.TST_WRITE_UART", "TST.TST_ENABLE_UART", "TST.TST_DISABLE_UART"),
    *("TST.TST_BOOT_MODE2", "TST.TST_CLOSE_MODE2"),
)
@handles_unknown("TST")
def check_open(vm: Machine, *_: object) -> None:
    """Fails while the tests are closed, else renews the time. The hardware itself does not exist here."""
    if vm.microseconds >= vm.brick.tests_until:
        raise Failure
    open_tests(vm)


@handles("TST.TST_CLOSE")
def close_tests(vm: Machine) -> None:
    """Closes the tests at once."""
    check_open(vm)
    vm.brick.tests_until = 0


@handles("TST.TST_READ_PINS", "TST.TST_READ_UART")
def read_pins(vm: Machine, port: int, length: int, destination: Location) -> None:  # noqa: ARG001 - all ports are alike
    """Writes zeros: every pin is low, and no byte has arrived."""
    check_open(vm)
    destination.write_bytes(bytes(max(0, length)))


@handles("TST.TST_READ_ADC", "TST.TST_ACCU_SWITCH", "TST.TST_POLL_MODE2", "TST.TST_RAM_CHECK", computes=True)
def read_state(vm: Machine, *_: object) -> int:
    """Returns 0: no voltage, no rechargeable battery; or OK, which is 0 too."""
    check_open(vm)
    return 0

"""TST: the tests of the factory. All but opening them fail while they are closed; they close after 10 seconds."""

from __future__ import annotations

from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import Failure
from ev3proto.brick.places import Place
from ev3proto.brick.running_programs import OK

OPEN_MICROSECONDS = 10_000_000


@handles("TST.TST_OPEN")
def open_tests(vm: Machine) -> None:
    """For 10 seconds."""
    vm.brick.tests_until = vm.microseconds + OPEN_MICROSECONDS


@handles_unknown("TST")
def check_open(vm: Machine) -> None:
    """Fails while the tests are closed, else renews the time."""
    if vm.microseconds >= vm.brick.tests_until:
        raise Failure
    open_tests(vm)


@handles("TST.TST_CLOSE")
def close_tests(vm: Machine) -> None:
    """At once."""
    check_open(vm)
    vm.brick.tests_until = 0


@handles("TST.TST_READ_PINS", "TST.TST_READ_UART")
def read_pins(vm: Machine, port: int, length: int, destination: Place) -> None:  # noqa: ARG001 - all ports are alike
    """No pin is high, no byte has come."""
    check_open(vm)
    destination.check(max(0, length))
    destination.write_bytes(bytes(max(0, length)))


@handles("TST.TST_READ_ADC")
def read_adc(vm: Machine, index: int, value: Place) -> None:  # noqa: ARG001 - all channels are alike
    """No voltage."""
    check_open(vm)
    value.write16(0)


@handles("TST.TST_ACCU_SWITCH", "TST.TST_POLL_MODE2", "TST.TST_RAM_CHECK")
def read_state(vm: Machine, state: Place) -> None:
    """No rechargeable battery; everything is fine."""
    check_open(vm)
    state.write8(OK)


@handles(
    "TST.TST_WRITE_PINS",
    "TST.TST_WRITE_UART",
    "TST.TST_ENABLE_UART",
    "TST.TST_DISABLE_UART",
    "TST.TST_BOOT_MODE2",
    "TST.TST_CLOSE_MODE2",
)
def nothing(vm: Machine, *_: object) -> None:
    """There is no such hardware."""
    check_open(vm)

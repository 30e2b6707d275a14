"""Opcodes without a CMD in the firmware's area `vm`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from collections.abc import Sequence

from ev3proto.ops.argument_types import AnySLOT, Number, Output, Text, Untyped
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "bp0",
    "bp1",
    "bp2",
    "bp3",
    "bp_set",
    "call",
    "do",
    "error",
    "label",
    "nop",
    "note_to_freq",
    "object_end",
    "object_start",
    "object_stop",
    "object_trig",
    "object_wait",
    "port_cnv_input",
    "port_cnv_output",
    "probe",
    "program_start",
    "program_stop",
    "return_",
    "sleep",
    "system",
]

_OPERATIONS = drafts("official")


def error(*, unchecked: bool = False) -> Draft:
    """Ends the program with a failure; never valid on the wire."""
    return _OPERATIONS["ERROR"].draft((), unchecked)


def nop(*, unchecked: bool = False) -> Draft:
    """Does nothing; a harmless way to see whether the brick answers."""
    return _OPERATIONS["NOP"].draft((), unchecked)


def program_stop(prgid: AnySLOT, *, unchecked: bool = False) -> Draft:
    """Stops the program of a slot.

    Args:
        prgid: Program slot to stop; 0: all programs; -1: the program that says so; a member of SLOT; DATA16.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_STOP"].draft((prgid,), unchecked)


def program_start(prgid: AnySLOT, size: Number, ip: Number, debug: Number, *, unchecked: bool = False) -> Draft:
    """Starts a loaded program; by direct command only while no user program runs.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        size: Size of the image; read and ignored; bytes; DATA32.
        ip: Address of the image, as FILE.LOAD_IMAGE returned it; DATA32.
        debug: How to run it; 0 to 2; 0: run; 1: debug; 2: load, do not run; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_START"].draft((prgid, size, ip, debug), unchecked)


def object_stop(objid: Number, *, unchecked: bool = False) -> Draft:
    """Stops an object of the own program.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_STOP"].draft((objid,), unchecked)


def object_start(objid: Number, *, unchecked: bool = False) -> Draft:
    """Starts an object of the own program.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_START"].draft((objid,), unchecked)


def object_trig(objid: Number, *, unchecked: bool = False) -> Draft:
    """Counts an object's trigger down; at zero the object starts.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_TRIG"].draft((objid,), unchecked)


def object_wait(objid: Number, *, unchecked: bool = False) -> Draft:
    """Waits until an object has ended.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_WAIT"].draft((objid,), unchecked)


def return_(*, unchecked: bool = False) -> Draft:
    """Returns from a subroutine to its caller."""
    return _OPERATIONS["RETURN"].draft((), unchecked)


def call(objid: Number, parameters: Sequence[Untyped], *, unchecked: bool = False) -> Draft:
    """Calls a subroutine of the own program; waits while another thread is in it.

    Args:
        objid: Object that is the subroutine, counted from 1; DATA16.
        parameters: How many parameters follow; the subroutine declares their types and directions; a list of DATA32.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CALL"].draft((objid, parameters), unchecked)


def object_end(*, unchecked: bool = False) -> Draft:
    """Ends the object; the firmware puts one after every direct command."""
    return _OPERATIONS["OBJECT_END"].draft((), unchecked)


def sleep(*, unchecked: bool = False) -> Draft:
    """Gives up the rest of the thread's time slice."""
    return _OPERATIONS["SLEEP"].draft((), unchecked)


def label(no: Number, *, unchecked: bool = False) -> Draft:
    """Marks a place that jumps can name; does nothing itself.

    Args:
        no: Number of the label; 0 to 31; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["LABEL"].draft((no,), unchecked)


def probe(prgid: AnySLOT, objid: Number, offset: Number, size: Number, *, unchecked: bool = False) -> Draft:
    """Prints a program's memory on the brick's debug terminal.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        objid: Object whose local memory to print; 0: the global memory; DATA16.
        offset: Where to begin; bytes; DATA32.
        size: How much to print; 0 to 1024 bytes; 0: all, 1024 at most; DATA32.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROBE"].draft((prgid, objid, offset, size), unchecked)


def do(prgid: AnySLOT, image: Number, global_: Number, *, unchecked: bool = False) -> Draft:
    """Runs byte code that is already in memory, ending what the slot ran before.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        image: Address of the byte code image; DATA32.
        global_: Address of the global memory it uses; DATA32.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DO"].draft((prgid, image, global_), unchecked)


def system(command: Text, status: Output = None, *, unchecked: bool = False) -> Draft:
    """Runs a shell command on the brick's Linux and waits for its end.

    Args:
        command: The command line; string.
        status: Wait status as C's system() gives it: 256 times the exit code; 0: success; -1: could not run; DATA32; an
            output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SYSTEM"].draft((command, status), unchecked)


def port_cnv_output(
    portin: Number,
    layer: Output = None,
    bitfield: Output = None,
    inverted: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Splits a motor port number as LEGO's editor writes it.

    Args:
        portin: Three decimal digits, each 1-4: layer, first port, second port (123: B and C); DATA32.
        layer: Position in the daisy chain; 0 to 3; 0: this brick; DATA8; an output, in global memory when omitted.
        bitfield: Motor ports as bits: A=1 B=2 C=4 D=8; 0 to 15; DATA8; an output, in global memory when omitted.
        inverted: Whether the first port comes after the second, as in C and A; 0 to 1; 0: no; 1: yes; DATA8; an output,
            in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PORT_CNV_OUTPUT"].draft((portin, layer, bitfield, inverted), unchecked)


def port_cnv_input(portin: Number, layer: Output = None, portout: Output = None, *, unchecked: bool = False) -> Draft:
    """Splits a sensor port number as LEGO's editor writes it.

    Args:
        portin: Three decimal digits: layer 1-4, any, port 1-4 (103: port 3); DATA32.
        layer: Position in the daisy chain; 0 to 3; 0: this brick; DATA8; an output, in global memory when omitted.
        portout: Sensor port less one, as INPUT_* takes it; 0 to 3; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PORT_CNV_INPUT"].draft((portin, layer, portout), unchecked)


def note_to_freq(note: Text, freq: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts the name of a note to its frequency.

    Args:
        note: C4 to B6, sharps as C#4; string.
        freq: Frequency; 440 for a note it does not know; 262 to 1976 Hz; DATA16; an output, in global memory when
            omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["NOTE_TO_FREQ"].draft((note, freq), unchecked)


def bp0(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 0; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP0"].draft((), unchecked)


def bp1(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 1; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP1"].draft((), unchecked)


def bp2(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 2; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP2"].draft((), unchecked)


def bp3(*, unchecked: bool = False) -> Draft:
    """Pulses test pin TP4 and goes on; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP3"].draft((), unchecked)


def bp_set(prgid: AnySLOT, no: Number, address: Number, *, unchecked: bool = False) -> Draft:
    """Sets or removes a breakpoint in a running program.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        no: Number of the breakpoint; 0 to 2; 3: pulse on test pin TP4, no stop; DATA8.
        address: Where in the image; bytes; 0: remove the breakpoint; DATA32.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["BP_SET"].draft((prgid, no, address), unchecked)

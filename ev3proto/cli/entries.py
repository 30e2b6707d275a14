"""What `ops` and `help` explain besides operations: encodings, modes of sensors, errors, meanings of a number."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from ev3proto.errors import counted
from ev3proto.schema.argument import LABEL_BYTE
from ev3proto.tables.devices import DEVICE_TYPES
from ev3proto.tables.encoding import ADDRESS_BIT, ENCODING_TEXTS, ENCODINGS, HANDLE_BIT
from ev3proto.tables.errors import ERRORS
from ev3proto.text.spans import Role, Spans

ENCODING, MODE = "identification byte", "mode of a sensor or motor"


@dataclass(frozen=True)
class Entry:
    """An operation, a system command or a name, as `ops` shows it.

    kind      what it is; empty for operations
    text      its meaning
    searched  further words that find it
    about     yields the lines under its name and text
    record    returns all of it for other tools
    words     what else people call it
    """

    name: str
    number: int
    area: str
    kind: str
    text: str
    searched: str
    about: Callable[[], Iterator[Spans]]
    record: Callable[[], dict[str, Any]]
    words: str = ""

    @property
    def texts(self) -> tuple[str, str, str]:
        """The texts that are searched: the names, the meaning, all else."""
        return f"{self.name} {self.words}", f"{self.text} {self.kind}", self.searched

    def line(self) -> Spans:
        """Returns its line in a list."""
        name = f"{self.name} ({self.kind})" if self.kind else self.name
        return [(f"0x{self.number:02X} ", Role.ASIDE), (name.ljust(32), Role.OPERATION), (f" {self.text}", Role.PLAIN)]

    def page(self) -> Iterator[Spans]:
        """Yields the lines that show it in full."""
        yield [(self.name, Role.OPERATION), (f"  {self.text}", Role.PLAIN)]
        yield from self.about()


def named_entry(name: str, number: int, kind: str, text: str, notes: Iterable[str]) -> Entry:
    """Returns the entry of another name than that of an operation: a status, a message type, an encoding."""
    noted = list(notes)

    def about() -> Iterator[Spans]:
        yield [(f"  {kind} 0x{number:02X}", Role.ASIDE)]
        yield from ([(f"  {note}", Role.MEANING)] for note in noted)

    def record() -> dict[str, Any]:
        return {"name": name, "number": number, "kind": kind, "text": text, "notes": noted}

    return Entry(name, number, "system", kind, text, " ".join(noted), about, record)


_SHORTEST = {
    "LCX": ("The shortest encoding of a number", "LC0", "LC1", "LC2", "LC4"),
    "LVX": ("The shortest encoding of a local variable", "LV0", "LV1", "LV2", "LV4"),
    "GVX": ("The shortest encoding of a global variable", "GV0", "GV1", "GV2", "GV4"),
}
_BITS = {
    "HND": (HANDLE_BIT, "A handle: the variable holds the number of an array, which is meant"),
    "ADR": (ADDRESS_BIT, "An address: the variable holds the place in memory of what is meant"),
}


def encoding(byte: int) -> Entry | None:
    """Returns the entry of an identification byte; None if it is undefined."""
    form = ENCODINGS[byte]
    if form is None:
        return None
    text, note = ENCODING_TEXTS[form.name]
    bits = [name for name, is_set in (("handle", form.handle), ("address", form.address)) if is_set]
    notes = [note, *(f"with the {bit} bit" for bit in bits if byte != LABEL_BYTE)]
    return named_entry(form.name, byte, ENCODING, text, notes)


def _first_byte(name: str) -> int:
    return next(byte for byte, form in enumerate(ENCODINGS) if form is not None and form.name == name)


def encodings() -> Iterator[Entry]:
    """Yields the encodings of arguments, by the names of LEGO's macros."""
    for name in ENCODING_TEXTS:
        entry = encoding(_first_byte(name))
        assert entry is not None
        yield entry
    for name, (text, *forms) in _SHORTEST.items():
        yield named_entry(name, _first_byte(forms[0]), ENCODING, text, [f"{', '.join(forms[:-1])} or {forms[-1]}"])
    for name, (bit, text) in _BITS.items():
        yield named_entry(name, bit, "bit of an identification byte", text, [])


def modes() -> Iterator[Entry]:
    """Yields the modes of sensors and motors, by the names of their manuals."""
    for device in DEVICE_TYPES.values():
        for number, mode in enumerate(device.modes):
            unit = f" {mode.unit}" if mode.unit else ""
            values = f"{counted(mode.datasets, 'value')}, {mode.si.least:g} to {mode.si.most:g}{unit}"
            if mode.values:
                values += f": {'; '.join(map(str, mode.values))}"
            yield named_entry(
                mode.name,
                number,
                MODE,
                f"{device.title}, mode {number} of {device.name}",
                [
                    f"{values}; raw {mode.raw.least:g} to {mode.raw.most:g}",
                    f"INPUT_DEVICE(READY_SI, 0, PORT, {device.number}, {number}, {mode.datasets}, ...) reads it, with"
                    " PORT 0 to 3 for a sensor and 16 to 19 for a motor",
                ],
            )


def error_numbers() -> Iterator[Entry]:
    """Yields the errors that the firmware logs."""
    for number, name in enumerate(ERRORS):
        yield named_entry(name, number, "error number", "An error of the firmware, as INFO.GET_ERROR reports it", [])


def device_types() -> Iterator[Entry]:
    """Yields the types of sensors and motors."""
    for device in DEVICE_TYPES.values():
        notes = [f"modes: {', '.join(f'{number} {mode.name}' for number, mode in enumerate(device.modes))}"]
        notes += [] if device.is_sold else ["no device that is sold has this type"]
        yield named_entry(device.name, device.number, "type of a sensor or motor", device.title, notes)

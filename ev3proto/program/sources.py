"""Assembles sources into images: detects the notation, reports errors and warnings."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from ev3proto.errors import BuildError
from ev3proto.program.image import NewObject, Program, image_of, parse, regular_offsets
from ev3proto.program.objects import Defects
from ev3proto.program.parameters import ProgramParameter, code_of, table_bytes
from ev3proto.tables.declaration import DATA16, Type
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.program import DEFAULT_VERSION, RELEASE_VERSION
from ev3proto.tables.source import BASIC_NAMES
from ev3proto.text.assembly.errors import AssemblyError, Lines, SourceError, SourceWarning
from ev3proto.text.assembly.notations import BASIC, LEGO_NOTATION, OF_EV3_G, STRICT, Notation
from ev3proto.text.assembly.objects import AssembledObject, AssembledProgram, ProgramAssembler

MAX_SOURCE = 1 << 25
"""Maximum length of a source, in characters."""

_MOST_WARNINGS = 1000

_SIGNS_OF_BASIC = re.compile(
    rf"^[ \t]*(?:subcall[ \t]+(?:PROGRAM_MAIN\b|\w+\.\w)|(?:{'|'.join(BASIC_NAMES)})\b|inline[ \t])",
    re.MULTILINE | re.IGNORECASE,
)
"""Marks of EV3 Basic's sources."""


class SourceDialect(StrEnum):
    """The dialects of sources: that of lmsasm, of LEGO's own assembler, and of EV3 Basic's compiler."""

    STRICT = "strict"
    LEGO = "lego"
    BASIC = "basic"


_NOTATIONS = {SourceDialect.STRICT: STRICT, SourceDialect.LEGO: LEGO_NOTATION, SourceDialect.BASIC: BASIC}


@dataclass(frozen=True, slots=True)
class Assembled:
    """The result of assembling a source.

    image     the bytes of the .rbf file
    dialect   the dialect of the source
    warnings  what assembles but may be a mistake, in the order of the text
    """

    image: bytes
    dialect: SourceDialect
    warnings: tuple[SourceWarning, ...] = ()

    @property
    def program(self) -> Program:
        """The image, parsed."""
        return parse(self.image, strict=False)


def assemble(
    source: str | bytes, *, dialect: str | None = None, version: int | None = None, shortest: bool = False
) -> Assembled:
    """Assembles the source of a program.

    Args:
        source: The text, or the bytes of a file in UTF-8 or ISO-8859-1.
        dialect: "strict", "lego" or "basic"; None: EV3 Basic's if the text has names that only that has, else strict,
            or LEGO's if the text is not strict.
        version: The version of the image, 0 to 65535; None: that of the source, or 0x6D (0x68 for EV3 Basic).
        shortest: Use the rules of EV3-G: labels are as short as possible, floats have four bytes, equal objects share
            code.

    Returns:
        The image, the dialect of the source, and the warnings.

    Raises:
        AssemblyError: The source cannot be assembled. The error has line, column, the text of the line, and in `others`
            the other mistakes.
        ValueError: The dialect is unknown.
        TypeError: The source is neither text nor bytes.
    """
    if version is not None and not 0 <= version <= 0xFFFF:
        raise ValueError(f"version cannot be {version}: it is a whole number from 0 to 65535")
    text, coding = _decoded(source)
    wanted = [SourceDialect.STRICT, SourceDialect.LEGO] if dialect is None else [SourceDialect(dialect)]
    if len(text) > MAX_SOURCE:
        raise AssemblyError(1, 1, f"the source has {len(text)} characters; at most {MAX_SOURCE} can be assembled")
    if dialect is None and _SIGNS_OF_BASIC.search(text):
        wanted = [SourceDialect.BASIC]
    lines = Lines(text)
    failed: list[list[SourceError]] = []
    for one in wanted:
        errors, warnings, image = _tried(text, coding, _NOTATIONS[one], version, shortest)
        if not errors:
            return Assembled(image, one, lines.warnings(warnings[:_MOST_WARNINGS]))
        failed.append(errors)
    # The dialect that failed last is probably the right one.
    raise lines.error(max(failed, key=lambda errors: lines.place(min(error.at for error in errors))[0]))


def _decoded(source: str | bytes) -> tuple[str, str]:
    """Returns the text, and the coding in which the strict dialect writes its strings."""
    if isinstance(source, str):
        return source, "utf-8"
    if not isinstance(source, (bytes, bytearray)):
        raise TypeError(f"a source is a text or its bytes, not {source!r}")
    try:
        return source.decode("utf-8-sig"), "utf-8"
    except UnicodeDecodeError:
        return source.decode(STRING_CODING), STRING_CODING


def _tried(
    text: str, coding: str, notation: Notation, version: int | None, shortest: bool
) -> tuple[list[SourceError], list[tuple[int, str]], bytes]:
    """Returns errors, warnings and the image of a text in one notation."""
    written_as = coding if notation is STRICT else STRING_CODING
    assembler = ProgramAssembler(text, notation, written_as, OF_EV3_G if shortest else None)
    image = b""
    program = None if assembler.errors else assembler.program()
    if program is not None and not assembler.errors:
        usual = RELEASE_VERSION if notation is BASIC else DEFAULT_VERSION
        try:
            image = _image(program, program.settings.numbers.get("version", usual) if version is None else version)
        except BuildError as error:
            assembler.errors.append(SourceError(0, str(error)))
    return assembler.errors, assembler.warnings, image


def _image(program: AssembledProgram, version: int) -> bytes:
    """Returns the image of a program. Raises BuildError."""
    said, objects = program.settings, program.objects
    entries = [NewObject(it.owner, it.triggers, it.local_size, _code(it), it.shares) for it in objects]
    offsets = [it.settings.get("offset", usual) for it, usual in zip(objects, regular_offsets(entries), strict=True)]
    headers = [it.settings.get("header", offset) for it, offset in zip(objects, offsets, strict=True)]
    if len({it.last for it in objects}) < len(objects):
        # Objects of the same name share the header of the last one.
        headers = [offsets[it.last] for it in objects]
        entries = [
            entry._replace(local_size=entries[it.last].local_size) for entry, it in zip(entries, objects, strict=True)
        ]
    defects = Defects(offsets=tuple(offsets), gaps=tuple(said.gaps), headers=tuple(headers))
    return image_of(version, said.numbers.get("globals", program.global_size), entries, defects)


def _code(part: AssembledObject) -> bytes:
    """Returns the code of an object with its parameter table; empty if it uses the code of another."""
    if part.parameters is None or part.shares is not None:
        return b"" if part.shares is not None else part.code
    table = table_bytes(
        [
            ProgramParameter(
                code_of(direction, DATA16 if kind is Type.HANDLE else kind),
                size & 0xFF if kind is Type.STRING else None,
            )
            for direction, kind, size in part.parameters
        ]
    )
    return bytes((part.declared,)) + table[1:] + part.code

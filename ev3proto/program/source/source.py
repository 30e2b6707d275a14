"""Sources to images: which dialect a text is in, what is wrong with it, what it becomes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from ev3proto.errors import BuildError
from ev3proto.program.image import Program, parse
from ev3proto.program.source.assembling import Assembler
from ev3proto.program.source.errors import Lines, SourceError, SourceWarning
from ev3proto.program.source.lego import LegoParser
from ev3proto.program.source.settings import SettingsReader
from ev3proto.program.source.strict import StrictParser
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.text.assembly.errors import AssemblyError

MAX_SOURCE = 1 << 25
"""Characters of a source that is assembled."""

_MOST_WARNINGS = 1000


class SourceDialect(StrEnum):
    """How a source is written: as lmsasm has it, or as LEGO's own assembler."""

    STRICT = "strict"
    LEGO = "lego"


@dataclass(frozen=True, slots=True)
class Assembled:
    """What a source became.

    image     the bytes of the .rbf file
    dialect   the one it was read in
    warnings  what assembles and may not be meant, in the order of the text
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
    """Makes the image of a program's source.

    Args:
        source: The text, or the bytes of a file in UTF-8 or ISO-8859-1.
        dialect: "strict" or "lego"; None: strict, or LEGO's where it is not that.
        version: The version of the image, 0 to 65535; None: what the source says, or 0x6D.
        shortest: The rules of EV3-G: labels as short as they can be, floats always in four bytes, equal objects share
            code.

    Returns:
        The image, the dialect by which the source was read, and the warnings.

    Raises:
        AssemblyError: The source cannot be assembled. The error has line, column, the line's text, and in `others` what
            else is wrong.
        ValueError: There is no such dialect.
        TypeError: The source is neither text nor bytes.
    """
    if version is not None and not 0 <= version <= 0xFFFF:
        raise ValueError(f"version cannot be {version}: it is a whole number from 0 to 65535")
    wanted = list(SourceDialect) if dialect is None else [SourceDialect(dialect)]
    text, coding = _decoded(source)
    if len(text) > MAX_SOURCE:
        raise AssemblyError(1, 1, f"the source has {len(text)} characters; at most {MAX_SOURCE} can be assembled")
    lines = Lines(text)
    failed: list[list[SourceError]] = []
    for one in wanted:
        errors, warnings, image = _tried(text, coding, one, version, shortest)
        if not errors:
            return Assembled(image, one, lines.warnings(warnings[:_MOST_WARNINGS]))
        failed.append(errors)
    # What got to a later line is the dialect that was meant.
    raise lines.error(max(failed, key=lambda errors: lines.place(min(error.at for error in errors))[0]))


def _decoded(source: str | bytes) -> tuple[str, str]:
    """The text, and the coding in which the strict dialect writes its strings."""
    if isinstance(source, str):
        return source, "utf-8"
    if not isinstance(source, (bytes, bytearray)):
        raise TypeError(f"a source is a text or its bytes, not {source!r}")
    try:
        return source.decode("utf-8-sig"), "utf-8"
    except UnicodeDecodeError:
        return source.decode(STRING_CODING), STRING_CODING


def _tried(
    text: str, coding: str, dialect: SourceDialect, version: int | None, shortest: bool
) -> tuple[list[SourceError], list[tuple[int, str]], bytes]:
    """Errors, warnings, image of a text in one dialect."""
    parser = StrictParser(text, coding) if dialect is SourceDialect.STRICT else LegoParser(text)
    settings = SettingsReader(text, parser.errors)
    assembler = Assembler(
        parser.items,
        settings,
        parser.errors,
        parser.warnings,
        is_strict=dialect is SourceDialect.STRICT,
        shortest=shortest,
        version=version,
    )
    image = b""
    try:
        image = assembler.image()
    except BuildError as error:
        parser.errors.append(SourceError(0, str(error)))
    return parser.errors, parser.warnings, image

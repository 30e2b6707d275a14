"""`ev3proto check`: whether the brick accepts a frame, which byte is wrong if not, and how to fix it."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING, Any

import click

from ev3proto.checking.checking import check as check_frame
from ev3proto.checking.codes import CODES, Code
from ev3proto.checking.fixing import fix
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Finding, Report
from ev3proto.cli.check_output import SEVERITIES, JsonOutput, Output, Place, Tally, TextOutput
from ev3proto.cli.edited import EditedFile
from ev3proto.cli.inputs import SOURCE_SUFFIX, Source, introduction, pieces, sources
from ev3proto.cli.options import given_options, incompatible, json_option
from ev3proto.cli.output import Printer, complain
from ev3proto.cli.reading import CaptureOptions, reading_options
from ev3proto.cli.sources import SourceReader, looks_like_assembly
from ev3proto.errors import counted, near_misses
from ev3proto.tables.carriers import CARRIERS
from ev3proto.text.diagnostics import explanation
from ev3proto.text.fixed_text import FixedFrame, fix_pieces, is_command, is_whole, unix_lines
from ev3proto.text.paste import Pasted
from ev3proto.text.spans import Role
from ev3proto.text.splitting import Piece

if TYPE_CHECKING:
    from ev3proto.capture.formats import CaptureFile
    from ev3proto.capture.record import Record
    from ev3proto.cli.captures import CaptureSource
    from ev3proto.text.assembly.errors import SourceWarning

# Captures and programs are imported when they are needed, which saves 40 ms for a frame.

FORMATS = ("text", "json", "sarif", "github")
"""The formats of findings."""

_BUT_ERRORS = frozenset(SEVERITIES[1:])

MOST_EDITED = 1 << 26
"""Bytes of a text that --fix prints with its frames fixed; a longer one is refused."""

ALL_CODES = "all"
"""The value of --explain that lists all codes."""


@dataclass(frozen=True, slots=True)
class CheckOptions:
    """The options of `check`.

    style    one of FORMATS
    fixes    print the fixed frame and the remaining findings
    strict   count warnings as errors in the exit status
    carrier  what carries the frames; None: as the capture says, or any
    hidden   severities that are not shown
    quiet    only the summary is printed
    """

    style: str = FORMATS[0]
    fixes: bool = False
    strict: bool = False
    carrier: str | None = None
    hidden: frozenset[str] = frozenset()
    quiet: bool = False

    @property
    def as_json(self) -> bool:
        """Whether one object a line is printed."""
        return self.style == "json"

    def leaves_out(self, report: Report, *, is_alone: bool) -> bool:
        """Whether nothing is printed about a frame: with --errors-only, among many, one without errors."""
        if not self.hidden >= _BUT_ERRORS or is_alone:
            return self.quiet
        return self.quiet or (report.accepted and not report.errors)

    def shown(self, report: Report) -> tuple[Finding, ...]:
        """Returns the findings to show."""
        if not self.hidden:
            return report.findings
        return tuple(finding for finding in report.findings if finding.severity not in self.hidden)


class Checking(SourceReader):
    """Checks the frames of the sources one by one, and counts the findings."""

    wanted = "command"

    def __init__(self, reading: CaptureOptions, options: CheckOptions, output: Output, *, is_single: bool) -> None:
        super().__init__(reading)
        self._options = options
        self._output = output
        self._is_single = is_single
        self._edited: Iterator[FixedFrame] | None = None
        self._first: tuple[bytes, Place] | None = None
        self.tally = Tally()

    def piece(self, piece: Piece, pasted: Pasted, source: Source) -> None:
        """A frame of a text."""
        frame = piece.message.build()
        if pasted.direction == "received" or not (source.is_frame or is_command(piece.message, pasted)):
            self.tally.replies += 1
            return
        if not is_whole(piece.message, pasted):
            self.complain(f"{source.where(pasted)}: cannot check a frame that is cut off after {len(frame)} bytes")
            return
        if source.is_frame:
            self._typed(frame)
            return
        facts = {"source": source.label, "line": pasted.line, "column": pasted.column}
        is_logged = pasted.direction is not None or pasted.time is not None
        self._written(frame, Place(source.where(pasted), facts, is_among=True), is_logged=is_logged)

    def text(self, source: Source, lines: Iterator[str]) -> None:
        """Checks a text. Its first line that is neither empty nor a comment decides whether it is assembly."""
        first = list(introduction(lines))
        whole = chain(first, lines)
        if first and self.reading.missing is None and looks_like_assembly(first[-1]):
            self.assembly(source, whole)
        else:
            super().text(source, whole)

    def text_file(self, source: Source, file: CaptureFile, lines: Iterable[str]) -> None:
        """Checks a text; with --fix, prints it with its frames fixed, and all else on standard error."""
        if not self._options.fixes or self.reading.missing is not None or not isinstance(self._output, TextOutput):
            super().text_file(source, file, lines)
            return
        data = file.contents.read(MOST_EDITED + 1)
        if len(data) > MOST_EDITED:
            self.complain(f"{source.label}: --fix takes a text of at most {MOST_EDITED >> 20} MiB; split it")
            return
        contents = EditedFile.read(data)
        text = contents.text
        if looks_like_assembly("".join([*introduction(unix_lines(text))][-1:])):
            self.text(source, unix_lines(text))
            return
        found = list(pieces(unix_lines(text), None))
        made = fix_pieces(text, found, dialect=self.reading.dialect, carrier=self._options.carrier)
        contents.print(made.text)
        self._output.is_edited = True
        self._edited = iter(made.frames)
        for pasted in found:
            self.pasted(pasted, source)
        self._edited = None

    def assembly(self, source: Source, lines: Iterator[str]) -> None:
        """Checks assembly as `encode` and `send` take it; its values are left to the check."""
        from ev3proto.cli.assembly import assembled_messages  # takes 5 ms, which frames do not need

        self._is_empty = False
        dialect = self.reading.dialect
        messages = assembled_messages(source, lines, self.complain, dialect=dialect, unchecked=True)
        for number, message in enumerate(messages, 1):
            if message.type is not None and not message.type.is_command:
                self.tally.replies += 1
            elif source.is_frame:
                self._typed(message.build())
            else:
                place = Place(f"{source.label}, frame {number}", {"source": source.label}, is_among=True)
                self._written(message.build(), place)

    def _typed(self, frame: bytes) -> None:
        """Checks a frame of an argument."""
        label = "" if self._is_single else f"frame {self.tally.frames + (self._first is not None) + 1}"
        self._written(frame, Place(label, {}))

    def _written(self, frame: bytes, place: Place, *, is_logged: bool = False) -> None:
        """Checks a frame of a text. The first one waits for the second: some hints are for a frame alone."""
        if self._first is None and not self.tally.frames and not is_logged and self._edited is None:
            self._first = frame, place
            return
        self._take_first(is_alone=False)
        self._frame(frame, place, self._options.carrier)

    def _take_first(self, *, is_alone: bool) -> None:
        if self._first is not None:
            (frame, place), self._first = self._first, None
            self._frame(frame, place, self._options.carrier, is_alone=is_alone and not self.tally.replies)

    def capture(self, capture: CaptureSource) -> int:
        """Checks the commands in a capture, each for its carrier."""
        self._take_first(is_alone=False)
        before = self.tally.frames
        for record in capture.records():
            if is_reply(record):
                self.tally.replies += 1
                continue
            place = Place(
                f"{capture.label}, {capture.unit} {record.number}",
                {"source": capture.label, capture.unit: record.number},
                is_among=True,
            )
            self._frame(record.frame, place, self._options.carrier or capture.carrier(record))
        return self.tally.frames - before

    def read(self, source: Source) -> None:
        """Reads everything in a source; one that ends in .lms is the source of a program."""
        if not source.is_frame and source.name.lower().endswith(SOURCE_SUFFIX):
            self._is_empty = False
            self._source(source)
        else:
            super().read(source)

    def program(self, source: Source, image: bytes) -> None:
        """Checks a program image."""
        self._image(source, image, ())

    def _image(self, source: Source, image: bytes, warnings: Sequence[SourceWarning]) -> None:
        """Checks a program image, and shows the warnings of its source."""
        from ev3proto.program import check_program  # takes 30 ms, which frames do not need

        if self._options.fixes:
            raise click.UsageError(f"--fix is for frames, but {source.label[:60]} is a program")
        self._take_first(is_alone=False)
        self.tally.programs += 1
        report = check_program(image, dialect=self.reading.dialect)
        place = Place("" if self._is_single else source.label, {"source": source.label})
        if not self._is_left_out(report, place):
            self._output.program(report, self._options.shown(report), place, warnings)
        self._count(report)

    def _source(self, source: Source) -> None:
        """Shows the errors of a program's source, or checks the image that it assembles to."""
        # These take 30 ms, which frames do not need.
        from ev3proto.cli.programs import read_source
        from ev3proto.program import assemble
        from ev3proto.text.assembly.errors import AssemblyError

        text = read_source(source)
        if text is None:
            self.at_fault = True
            return
        try:
            made = assemble(text)
        except AssemblyError as error:
            self.tally.programs += 1
            self.at_fault = True
            self.tally.findings["error"] += 1 + len(error.others)
            if not self._options.quiet:
                self._output.source_errors(source.label, error)
            return
        self.tally.findings["warning"] += len(made.warnings)
        self.at_fault |= self._options.strict and bool(made.warnings)
        self._image(source, made.image, () if "warning" in self._options.hidden else made.warnings)

    def complain(self, sentence: str) -> None:
        """Prints a message about wrong input, also for a workflow."""
        super().complain(sentence)
        self._output.complaint(sentence)

    def end(self) -> None:
        """Checks the frame that waits, and shows the numbers of frames and findings."""
        self._take_first(is_alone=True)
        self._output.end(self.tally, is_quiet=self._options.quiet)

    def _frame(self, frame: bytes, place: Place, carrier: str | None, *, is_alone: bool = False) -> None:
        self.tally.frames += 1
        dialect = self.reading.dialect
        if self._edited is not None:
            edited = next(self._edited)
            report = edited.report
            if not self._is_left_out(report, place) and isinstance(self._output, TextOutput):
                shown = self._options.shown(edited.fix.report)
                self._output.edited(edited.fix, shown, place, is_written=edited.is_written)
        elif self._options.fixes:
            fixed = fix(frame, dialect=dialect, carrier=carrier)
            report = fixed.report
            if not self._is_left_out(report, place):
                self._output.fixed(fixed, self._options.shown(report), place)
        else:
            report = check_frame(frame, dialect=dialect, carrier=carrier, alone=is_alone)
            if not self._is_left_out(report, place):
                self._output.frame(report, self._options.shown(report), place)
        self._count(report)

    def _is_left_out(self, report: Report, place: Place) -> bool:
        return self._options.leaves_out(report, is_alone=self._is_single and not place.is_among)

    def _count(self, report: Report) -> None:
        self.tally.add(report.findings)
        severities = {finding.severity for finding in report.findings}
        if not report.accepted or "error" in severities or (self._options.strict and "warning" in severities):
            self.at_fault = True


def _output(options: CheckOptions, dialect: str) -> Output:
    """Returns what shows the findings in the format of the options."""
    if options.style in ("github", "sarif"):
        from ev3proto.cli.annotations import Annotations  # takes 30 ms: sources of programs have findings, too

        return Annotations(options.style)
    return JsonOutput(shows_warnings="warning" not in options.hidden) if options.as_json else TextOutput(dialect)


def is_reply(record: Record) -> bool:
    """Whether a frame comes from the brick, by the capture, or else by its type."""
    if record.direction is not None:
        return record.direction == "received"
    return record.message.type is not None and not record.message.type.is_command


@click.command()
@click.argument("names", nargs=-1, metavar="[FRAME|FILE|-]...")
@json_option
@click.option("--strict", is_flag=True, help="Count warnings as errors in the exit status.")
@click.option(
    "--fix", "fixes", is_flag=True, help="Fix what is certain; print the frame, or a text with its fixed frames."
)
@click.option("--no-hints", is_flag=True, help="Show errors and warnings only.")
@click.option("--errors-only", is_flag=True, help="Show errors only; of many frames, only those that have some.")
@click.option("--quiet", is_flag=True, help="Show only the numbers of frames and findings.")
@click.option(
    "--format",
    "style",
    type=click.Choice(FORMATS),
    help="How to show findings (default: text); sarif and github are for continuous integration.",
)
@click.option("--carrier", type=click.Choice(CARRIERS), help="What carries the frames; a capture says so itself.")
@click.option("--explain", "code", metavar="CODE", help=f"Explain a code, with an example; '{ALL_CODES}' lists them.")
@reading_options
def check(
    names: tuple[str, ...],
    as_json: bool,
    strict: bool,
    fixes: bool,
    no_hints: bool,
    errors_only: bool,
    quiet: bool,
    style: str | None,
    carrier: str | None,
    code: str | None,
    reading: CaptureOptions,
) -> None:
    """Checks whether the brick accepts a frame, which byte is wrong if not, and how to fix it.

    The verdict is the firmware's own, quirks included. Findings say what a careful sender would change: an error will
    not do what was meant, a warning may not, a hint marks something that could be done better. Frames can be written in
    any form that decode reads, or as assembly. In logs and captures, the brick's replies are skipped.

    Exit status: 1 if the brick refuses a frame, if there are errors, or if the input cannot be read; else 0.

    \b
      ev3proto check 08 00 2a 00 80 00 00 81 01 60
      ev3proto check 'UI_READ(GET_VBATT, GV0(0))'
      ev3proto check --fix "0x|09:00|2A:00|80|00:00|81|01|60|"
      ev3proto check --strict --no-hints robot.log
      ev3proto check robot.rbf
      ev3proto check robot.lms
      ev3proto check --errors-only --format github robot.log
      ev3proto check --explain E101
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if code is not None:
        if names:
            raise incompatible("--explain", "FRAME")
        given = given_options("strict", "fixes", "no_hints", "errors_only", "quiet", "carrier")
        given += [f"--format {style}"] if style in ("sarif", "github") else []
        if given:
            raise incompatible("--explain", ", ".join(given))
        _explain(code, as_json=as_json or style == "json", dialect=reading.dialect)
        return
    if strict and errors_only:
        raise incompatible("--strict", "--errors-only")
    if as_json and style not in (None, "json"):
        raise incompatible("--json", f"--format {style}")
    if quiet and style in ("sarif", "github"):
        raise incompatible("--quiet", f"--format {style}")
    if fixes and style in ("sarif", "github"):
        raise incompatible("--fix", f"--format {style}")
    hidden = {"hint", "warning"} if errors_only else {"hint"} if no_hints else set()
    style = style or ("json" if as_json else FORMATS[0])
    options = CheckOptions(style, fixes, strict, carrier, frozenset(hidden), quiet)
    found = sources(names)
    checking = Checking(reading, options, _output(options, reading.dialect), is_single=len(found) == 1)
    checking.read_all(found)
    checking.end()
    tally = checking.tally
    if tally.replies and not tally.frames and not tally.programs and not checking.at_fault:
        replies = counted(tally.replies, "frame")
        complain(f"no command found, only {replies} from the brick; `ev3proto check` checks commands")
        checking.at_fault = True
    sys.exit(1 if checking.at_fault else 0)


def _explain(name: str, *, as_json: bool, dialect: str) -> None:
    """Explains a code, or lists all. Raises click.BadParameter for an unknown one."""
    known = PROGRAM_CODES | CODES
    found = list(known.values()) if name == ALL_CODES else [known[name.upper()]] if name.upper() in known else []
    if not found:
        hint = near_misses(name, known) or f"; --explain {ALL_CODES} lists the codes"
        raise click.BadParameter(f"unknown code {name}{hint}", param_hint="'--explain'")
    printer = Printer()
    for code in found:
        if as_json:
            printer.text(json.dumps(_code_entry(code), ensure_ascii=False))
        elif name == ALL_CODES:
            printer.lines(
                [[(f"{code.code}  ", Role.OPERATION), (f"{code.severity!s:8} ", Role.ASIDE), (code.title, Role.PLAIN)]]
            )
        elif code.code in PROGRAM_CODES:
            from ev3proto.cli.programs import program_explanation  # takes 30 ms, which codes of frames do not need

            printer.lines(program_explanation(code, dialect))
        else:
            report = check_frame(code.example, dialect=dialect, carrier=code.carrier, alone=code.alone)
            printer.lines(explanation(code, report, dialect))


def _code_entry(code: Code) -> dict[str, Any]:
    """Returns a code for other tools."""
    return {
        "code": code.code,
        "severity": code.severity,
        "title": code.title,
        "story": code.explanation,
        "example": code.example.hex(),
        "counterexample": code.counterexample.hex(),
    }

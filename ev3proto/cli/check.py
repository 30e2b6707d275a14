"""`ev3proto check`: whether the brick accepts a frame, which byte is wrong if not, and how to fix it."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from ev3proto.checking.checking import check as check_frame
from ev3proto.checking.codes import CODES, Code
from ev3proto.checking.fixing import fix
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Finding, Fix, Report
from ev3proto.cli.edited import EditedFile
from ev3proto.cli.inputs import SOURCE_SUFFIX, Source, introduction, pieces, sources
from ev3proto.cli.options import given_options, incompatible, json_option
from ev3proto.cli.output import Printer, complain
from ev3proto.cli.reading import CaptureOptions, reading_options
from ev3proto.cli.sources import SourceReader, looks_like_assembly
from ev3proto.errors import counted, near_misses
from ev3proto.tables.carriers import CARRIERS
from ev3proto.text.diagnostics import diagnostics, explanation, fixed
from ev3proto.text.fixed_text import FixedFrame, fix_pieces, is_command, is_whole, unix_lines
from ev3proto.text.paste import Pasted
from ev3proto.text.spans import Line, Role, plain_text
from ev3proto.text.splitting import Piece

if TYPE_CHECKING:
    from ev3proto.capture.formats import CaptureFile
    from ev3proto.capture.record import Record
    from ev3proto.cli.annotations import Annotations
    from ev3proto.cli.captures import CaptureSource

# Captures and programs are imported when they are needed, which saves 40 ms for a frame.

FORMATS = ("text", "json", "sarif", "github")
"""The formats of findings."""

SEVERITIES = ("error", "warning", "hint")
"""The severities that are counted, the worst first."""

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


class Place(NamedTuple):
    """The place of a frame.

    label     prefix of every offset, such as `robot.log, line 3`; empty for a single frame
    facts     the same for other tools
    is_among  whether it is one of many frames in a text or a capture
    """

    label: str
    facts: dict[str, Any]
    is_among: bool = False


class Checking(SourceReader):
    """Checks the frames of the sources one by one, and counts the findings."""

    wanted = "command"

    def __init__(self, reading: CaptureOptions, options: CheckOptions, *, is_single: bool) -> None:
        super().__init__(reading)
        self._options = options
        self._is_single = is_single
        self._printer = Printer()
        self._was_long: bool | None = None
        self._annotations = _annotations(options.style, self._printer)
        self._written: Iterator[FixedFrame] | None = None
        self._is_edited = False
        self.frames = 0
        self.programs = 0
        self.replies = 0
        self.counts: Counter[str] = Counter()

    def piece(self, piece: Piece, pasted: Pasted, source: Source) -> None:
        """A frame of a text."""
        frame = piece.message.build()
        if pasted.direction == "received" or not (source.is_frame or is_command(piece.message, pasted)):
            self.replies += 1
            return
        if not is_whole(piece.message, pasted):
            self.complain(f"{source.where(pasted)}: cannot check a frame that is cut off after {len(frame)} bytes")
            return
        if source.is_frame:
            self._typed(frame)
        else:
            facts = {"source": source.label, "line": pasted.line, "column": pasted.column}
            self._frame(frame, Place(source.where(pasted), facts, is_among=True), self._options.carrier)

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
        if not self._options.fixes or self._options.as_json or self.reading.missing is not None:
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
        self._is_edited = True
        self._written = iter(made.frames)
        for pasted in found:
            self.pasted(pasted, source)
        self._written = None

    def assembly(self, source: Source, lines: Iterator[str]) -> None:
        """Checks assembly as `encode` and `send` take it; its values are left to the check."""
        from ev3proto.cli.assembly import assembled_messages  # takes 5 ms, which frames do not need

        self._is_empty = False
        dialect = self.reading.dialect
        messages = assembled_messages(source, lines, self.complain, dialect=dialect, unchecked=True)
        for number, message in enumerate(messages, 1):
            if message.type is not None and not message.type.is_command:
                self.replies += 1
            elif source.is_frame:
                self._typed(message.build())
            else:
                place = Place(f"{source.label}, frame {number}", {"source": source.label}, is_among=True)
                self._frame(message.build(), place, self._options.carrier)

    def _typed(self, frame: bytes) -> None:
        """Checks a frame of an argument."""
        self._frame(frame, Place("" if self._is_single else f"frame {self.frames + 1}", {}), self._options.carrier)

    def capture(self, capture: CaptureSource) -> int:
        """Checks the commands in a capture, each for its carrier."""
        before = self.frames
        for record in capture.records():
            if is_reply(record):
                self.replies += 1
                continue
            place = Place(
                f"{capture.label}, {capture.unit} {record.number}",
                {"source": capture.label, capture.unit: record.number},
                is_among=True,
            )
            self._frame(record.frame, place, self._options.carrier or capture.carrier(record))
        return self.frames - before

    def read(self, source: Source) -> None:
        """Reads everything in a source; one that ends in .lms is the source of a program."""
        if not source.is_frame and source.name.lower().endswith(SOURCE_SUFFIX):
            self._is_empty = False
            self._source(source)
        else:
            super().read(source)

    def program(self, source: Source, image: bytes) -> None:
        """Checks a program image."""
        self._image(source, image, [])

    def _image(self, source: Source, image: bytes, warnings: list[dict[str, Any]]) -> None:
        """Checks a program image, and shows the warnings of its source."""
        from ev3proto.program import check_program  # takes 30 ms, which frames do not need
        from ev3proto.program.report import program_findings  # the same

        if self._options.fixes:
            raise click.UsageError(f"--fix is for frames, but {source.label[:60]} is a program")
        self.programs += 1
        report = check_program(image, dialect=self.reading.dialect)
        place = Place("" if self._is_single else source.label, {"source": source.label})
        if not self._is_shown_otherwise(report, place, report.as_dict, is_file=True, warnings=warnings):
            shown = self._options.shown(report)
            label = f"{place.label}, " if place.label else ""
            self._paragraph(program_findings(report, shown, label), len(shown) > 0)
        self._count(report)

    def _source(self, source: Source) -> None:
        """Shows the errors of a program's source, or checks the image that it assembles to."""
        # These take 30 ms, which frames do not need.
        from ev3proto.cli.assembly import show_errors
        from ev3proto.cli.programs import complain_of_warnings, read_source, source_findings
        from ev3proto.program import assemble
        from ev3proto.text.assembly.errors import AssemblyError

        text = read_source(source)
        if text is None:
            self.at_fault = True
            return
        try:
            made = assemble(text)
        except AssemblyError as error:
            self.programs += 1
            self.at_fault = True
            self.counts["error"] += 1 + len(error.others)
            if self._annotations is not None:
                self._annotations.source(source.label, error)
            elif not self._options.quiet:
                show_errors(f"{source.label}, ", error)
                if self._options.as_json:
                    entry = {"accepted": False, "rejected_at": None, "findings": source_findings(error), "hex": ""}
                    self._print({"source": source.label}, entry)
            return
        self.counts["warning"] += len(made.warnings)
        if self._annotations is not None:
            self._annotations.source(source.label, warnings=made.warnings)
        elif not self._options.hidden >= {"warning"} and not self._options.quiet:
            complain_of_warnings(source.label, made.warnings)
        self.at_fault |= self._options.strict and bool(made.warnings)
        self._image(source, made.image, source_findings(warnings=made.warnings))

    def complain(self, sentence: str) -> None:
        """Prints a message about wrong input, also for a workflow."""
        super().complain(sentence)
        if self._annotations is not None:
            self._annotations.complaint(sentence)

    def summary(self) -> None:
        """Prints the numbers of frames and findings, if there is more than one frame; none for no frame at all."""
        if self._annotations is not None:
            self._annotations.end()
        elif self._options.as_json and self._options.quiet:
            counts = {f"{severity}s": self.counts[severity] for severity in SEVERITIES}
            entry = {"frames": self.frames, "programs": self.programs, "replies": self.replies, **counts}
            self._printer.text(json.dumps(entry))
        many = self.frames + self.programs + self.replies > 1
        is_wanted = (self.frames or self.programs) and (many or self._options.quiet)
        if self._options.style != FORMATS[0] or not is_wanted:
            return
        found = ", ".join(counted(self.counts[severity], severity) for severity in SEVERITIES)
        line: Line = [(f"{self._inputs()}: ", Role.HEADING), (found, Role.PLAIN)]
        if self.replies:
            line.append((f"; {_frames(self.replies)} from the brick not checked", Role.ASIDE))
        if self._is_edited:
            complain(plain_text(line))
        else:
            self._paragraph(iter([line]), False)

    def _inputs(self) -> str:
        """Returns `4 frames`, `2 programs`, `1 frame and 1 program`."""
        programs = [counted(self.programs, "program")] if self.programs else []
        return " and ".join([*([_frames(self.frames)] if self.frames or not programs else []), *programs])

    def _frame(self, frame: bytes, place: Place, carrier: str | None) -> None:
        self.frames += 1
        if self._written is not None:
            written = next(self._written)
            report = written.report
            self._show_written(written, place)
        elif self._options.fixes:
            found = fix(frame, dialect=self.reading.dialect, carrier=carrier)
            report = found.report
            self._show_fix(found, place)
        else:
            report = check_frame(frame, dialect=self.reading.dialect, carrier=carrier)
            self._show(report, place)
        self._count(report)

    def _count(self, report: Report) -> None:
        severities = [finding.severity for finding in report.findings]
        for severity in SEVERITIES:
            self.counts[severity] += severities.count(severity)  # type: ignore[arg-type]
        if not report.accepted or "error" in severities or (self._options.strict and "warning" in severities):
            self.at_fault = True

    def _show(self, report: Report, place: Place) -> None:
        if self._is_shown_otherwise(report, place, report.as_dict):
            return
        shown = self._options.shown(report)
        self._stand_apart(len(shown) > 0)
        label, dialect = place.label, self.reading.dialect
        self._printer.lines(diagnostics(report, shown, place=label, dialect=dialect))

    def _show_fix(self, fix: Fix, place: Place) -> None:
        if self._is_shown_otherwise(fix.report, place, fix.as_dict):
            return
        shown = self._options.shown(fix.report)
        self._paragraph(fixed(fix, shown, place=place.label, dialect=self.reading.dialect), True)

    def _show_written(self, written: FixedFrame, place: Place) -> None:
        """Shows what was fixed in a text, and what remains, on standard error: the text itself is the output."""
        found = written.fix
        if not (found.is_fixed or found.report.findings) or self._options.leaves_out(found.report, is_alone=False):
            return
        shown = self._options.shown(found.report)
        dialect = self.reading.dialect
        lines = fixed(found, shown, place=place.label, dialect=dialect, is_written=written.is_written)
        complain("\n".join(map(plain_text, lines)) + "\n")

    def _is_shown_otherwise(
        self,
        report: Report,
        place: Place,
        entry: Callable[[], dict[str, Any]],
        *,
        is_file: bool = False,
        warnings: Sequence[dict[str, Any]] = (),
    ) -> bool:
        """Shows findings in any format but text; returns whether nothing is left to be shown."""
        if self._options.leaves_out(report, is_alone=self._is_single and not place.is_among):
            return True
        if self._annotations is not None:
            self._annotations.report(report, self._options.shown(report), place.facts, is_file=is_file)
        elif self._options.as_json:
            self._json(place, entry(), report, warnings)
        return self._options.style != FORMATS[0]

    def _json(self, place: Place, entry: dict[str, Any], report: Report, warnings: Sequence[dict[str, Any]]) -> None:
        entry["findings"] = [finding.as_dict() for finding in self._options.shown(report)]
        if warnings and "warning" not in self._options.hidden:
            entry["findings"] = [*warnings, *entry["findings"]]
        self._print(place.facts, entry)

    def _print(self, facts: dict[str, Any], entry: dict[str, Any]) -> None:
        self._printer.text(json.dumps(facts | entry, ensure_ascii=False))

    def _paragraph(self, lines: Iterable[Line], is_long: bool) -> None:
        """Prints lines that belong together."""
        self._stand_apart(is_long)
        self._printer.lines(lines)

    def _stand_apart(self, is_long: bool) -> None:
        """Prints an empty line between two paragraphs if either has several lines."""
        if self._was_long or (is_long and self._was_long is not None):
            self._printer.text("")
        self._was_long = is_long


def _annotations(style: str, printer: Printer) -> Annotations | None:
    """Returns what shows findings to a workflow; None for other formats."""
    if style not in ("github", "sarif"):
        return None
    from ev3proto.cli.annotations import Annotations  # takes 30 ms: sources of programs have findings, too

    return Annotations(style, printer.text)


def is_reply(record: Record) -> bool:
    """Whether a frame comes from the brick, by the capture, or else by its type."""
    if record.direction is not None:
        return record.direction == "received"
    return record.message.type is not None and not record.message.type.is_command


def _frames(count: int) -> str:
    return counted(count, "frame")


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
    checking = Checking(reading, options, is_single=len(found) == 1)
    checking.read_all(found)
    checking.summary()
    if checking.replies and not checking.frames and not checking.programs and not checking.at_fault:
        complain(f"no command found, only {_frames(checking.replies)} from the brick; `ev3proto check` checks commands")
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
            report = check_frame(code.example, dialect=dialect, carrier=code.carrier)
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

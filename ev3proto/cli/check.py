"""`ev3proto check`: whether the brick accepts a frame, which byte is wrong if not, and how to fix it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import click

from ev3proto.capture.record import Record
from ev3proto.checking.checking import check as check_frame
from ev3proto.checking.codes import CODES, FindingCode
from ev3proto.checking.fixing import fix
from ev3proto.checking.nearest import Suggestions
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.cli.annotations import GitHub, Sarif
from ev3proto.cli.check_output import (
    SEVERITIES,
    Checked,
    FramePlace,
    JsonOutput,
    Output,
    SourceFinding,
    Tally,
    TextOutput,
)
from ev3proto.cli.edited import EditedFile
from ev3proto.cli.options import exclusive, gathered, incompatible, json_option
from ev3proto.cli.output import Printer, complain, say_json
from ev3proto.cli.reading import Other, Problems, made_of, named, parts_of, reading_options
from ev3proto.errors import counted, near_misses
from ev3proto.reading.items import Image, Source, SourceKind
from ev3proto.reading.kinds import introduction
from ev3proto.reading.options import Options
from ev3proto.reading.parts import Reading
from ev3proto.reading.texts import looks_like_assembly
from ev3proto.tables.carriers import CARRIERS
from ev3proto.text.fixed_text import fix_pieces, unix_lines
from ev3proto.text.paste import read_text
from ev3proto.text.spans import Role

REPORTS: dict[str, Callable[[str], Output]] = {
    "text": TextOutput,
    "json": lambda _: JsonOutput(),
    "sarif": lambda _: Sarif(),
    "github": lambda _: GitHub(),
}
"""The formats of findings, and what makes the renderer of each for a dialect."""

_BUT_ERRORS = frozenset(SEVERITIES[1:])

MOST_EDITED = 1 << 26
"""Bytes of a text that --fix prints with its frames fixed; a longer one is refused."""

ALL_CODES = "all"
"""The value of --explain that lists all codes."""


@dataclass(frozen=True, slots=True)
class CheckOptions:
    """The options of `check`, as its help explains them; `style` is one of REPORTS, None for the default."""

    as_json: bool = False
    strict: bool = False
    fixes: bool = False
    no_hints: bool = False
    errors_only: bool = False
    whole: bool = False
    quiet: bool = False
    style: str | None = None
    carrier: str | None = None
    code: str | None = None

    @property
    def format(self) -> str:
        """The style to print in."""
        return self.style or ("json" if self.as_json else "text")

    @property
    def hidden(self) -> frozenset[str]:
        """The severities that are not shown."""
        return _BUT_ERRORS if self.errors_only else frozenset({"hint"} if self.no_hints else ())

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


class Checking:
    """Checks what is read, and counts the findings."""

    def __init__(self, reading: Reading, options: CheckOptions, output: Output, problems: Problems) -> None:
        self._reading = reading
        self._options = options
        self._output = output
        self._problems = problems
        self._dialect = reading.options.dialect
        self._is_single = len(reading.parts) == 1
        self._first: tuple[bytes, FramePlace] | None = None
        self._suggestions = Suggestions()
        self.tally = Tally()

    def run(self) -> None:
        """Checks everything, and shows the numbers of frames and findings."""
        tally, problems = self.tally, self._problems
        # Texts without commands are told of together, as replies among them are passed over.
        parts = parts_of(self._reading, problems, lambda: tally.seen, lambda it: None if it.is_text else it.nothing())
        for part in parts:
            for event in problems.beside(part):
                self._check(event)
        self._take_first(is_alone=True)
        if self._suggestions.is_stopped:
            complain("what was meant is said of the first 100 different frames with findings only")
        self._output.end(self.tally, is_quiet=self._options.quiet)

    def _check(self, event: Other) -> None:
        if isinstance(event, Record):
            self._take(event)
        elif isinstance(event, Image):
            self._image(event.place.name, event.data)
        elif isinstance(event, Source):
            _OF_SOURCES[event.kind](self, event)

    def _take(self, record: Record) -> None:
        """Checks a frame. The first one of a text waits for the second: some hints are for a frame alone."""
        if not self._is_checked(record):
            return
        written, place = record.written, self._place(record)
        if written is None:
            self._take_first(is_alone=False)
            self._frame(record.frame, place, self._options.carrier or str(record.carrier))
            return
        is_logged = written.direction is not None or written.time is not None
        if self._first is None and not self.tally.frames and (not place.is_among or not is_logged):
            self._first = record.frame, place
            return
        self._take_first(is_alone=False)
        self._frame(record.frame, place, self._options.carrier)

    def _is_checked(self, record: Record) -> bool:
        """Whether a frame is a whole command; counts others."""
        if record.is_from_brick:
            self.tally.replies += 1
            return False
        if record.missing and record.written is None:
            self.tally.cut += 1
        elif record.missing:
            size = len(record.frame)
            self._problems.wrong(f"{record.place}: cannot check a frame that is cut off after {size} bytes")
        return not record.missing

    def _place(self, record: Record) -> FramePlace:
        where, written = record.place, record.written
        if written is not None and (written.is_typed or not where.name):
            number = self.tally.frames + (self._first is not None) + 1
            return FramePlace("" if self._is_single else f"frame {number}", {})
        facts: dict[str, Any] = {"source": where.name}
        if written is None:
            facts["packet"] = record.number
        elif where.line is not None:
            facts |= {"line": where.line, "column": written.column}
        return FramePlace(str(where), facts, is_among=True)

    def _take_first(self, *, is_alone: bool) -> None:
        if self._first is not None:
            (frame, place), self._first = self._first, None
            self._frame(frame, place, self._options.carrier, is_alone=is_alone and not self.tally.replies)

    def _assembly(self, source: Source) -> None:
        """Checks the frames of assembly as `encode` and `send` make them, but leaves its values to the check."""
        for record in made_of(source, self._reading, self._problems, unchecked=True):
            self._take(record)

    def _edit(self, source: Source) -> None:
        """Prints a text with its frames fixed, and all else on standard error."""
        output, data, problems = self._output, source.text, self._problems
        assert isinstance(output, TextOutput), "only text is edited"
        assert isinstance(data, bytes)
        if len(data) > MOST_EDITED:
            mib = MOST_EDITED >> 20
            problems.wrong(f"{source.place}: --fix takes a text of at most {mib} MiB; split it")
            return
        contents = EditedFile.read(data)
        text = contents.text
        if looks_like_assembly("".join([*introduction(unix_lines(text))][-1:])):
            self._assembly(source._replace(text="".join(unix_lines(text))))
            return
        found = list(read_text(unix_lines(text)))
        made = fix_pieces(text, found, dialect=self._dialect, carrier=self._options.carrier)
        self._take_first(is_alone=False)
        contents.write(made.text)
        output.is_edited = True
        edited = iter(made.frames)
        for record in problems.records(self._reading.part.pieces(found)):
            if self._is_checked(record):
                one, place = next(edited), self._place(record)
                self.tally.frames += 1
                if self._counts(one.report, place):
                    output.edited(one, self._options.shown(one.fix.report), place)

    def _image(self, name: str, image: bytes, found: Sequence[SourceFinding] = ()) -> None:
        from ev3proto.program import check_program  # takes 9 ms, which frames do not need

        if self._options.fixes:
            raise click.UsageError(f"--fix is for frames, but {name[:60]} is a program")
        self._take_first(is_alone=False)
        self.tally.programs += 1
        place = FramePlace("" if self._is_single else name, {"source": name})
        self._show(Checked(place, check_program(image, dialect=self._dialect), is_program=True, source=found))

    def _code(self, source: Source) -> None:
        """Shows the errors of a program's source, or checks the image that it assembles to."""
        from ev3proto.program import assemble  # takes 9 ms, which frames do not need
        from ev3proto.text.assembly.errors import AssemblyError  # a part of that

        name = source.place.name
        try:
            made = assemble(source.text)
        except AssemblyError as error:
            errors = [SourceFinding(Severity.ERROR, one) for one in (error, *error.others)]
            self.tally.programs += 1
            self._problems.errors += 1
            self.tally.findings["error"] += len(errors)
            if not self._options.quiet:
                self._output.show(Checked(FramePlace("", {"source": name}), None, source=errors))
            return
        warnings = [SourceFinding(Severity.WARNING, one) for one in made.warnings]
        self.tally.findings["warning"] += len(warnings)
        self._problems.errors += self._options.strict and bool(warnings)
        self._image(name, made.image, () if "warning" in self._options.hidden else warnings)

    def _frame(self, frame: bytes, place: FramePlace, carrier: str | None, *, is_alone: bool = False) -> None:
        self.tally.frames += 1
        made = fix(frame, dialect=self._dialect, carrier=carrier) if self._options.fixes else None
        if made is not None:
            self._show(Checked(place, made.report, fix=made))
        else:
            report = check_frame(frame, dialect=self._dialect, carrier=carrier, alone=is_alone)
            self._show(Checked(place, report))

    def _show(self, checked: Checked) -> None:
        report = checked.report
        if report is not None and self._counts(report, checked.place):
            is_frame = isinstance(report, Report) and not checked.is_program
            nearest = self._suggestions.of(report) if is_frame and checked.fix is None else ()
            shown = self._options.shown(report)
            self._output.show(checked._replace(shown=shown, nearest=nearest, is_whole=self._options.whole))

    def _counts(self, report: Report, place: FramePlace) -> bool:
        self.tally.add(report.findings)
        severities = {finding.severity for finding in report.findings}
        if not report.accepted or "error" in severities or (self._options.strict and "warning" in severities):
            self._problems.errors += 1
        return not self._options.leaves_out(report, is_alone=self._is_single and not place.is_among)


_OF_SOURCES = {
    SourceKind.FRAMES: Checking._assembly,
    SourceKind.PROGRAM: Checking._code,
    SourceKind.TEXT: Checking._edit,
}


_options = gathered(
    CheckOptions,
    "options",
    json_option,
    click.option("--strict", is_flag=True, help="Count warnings as errors in the exit status."),
    click.option(
        "--fix", "fixes", is_flag=True, help="Fix what is certain; print the frame, or a text with its fixed frames."
    ),
    click.option("--no-hints", is_flag=True, help="Show errors and warnings only."),
    click.option("--errors-only", is_flag=True, help="Show errors only; of many frames, only those that have some."),
    click.option("--all-findings", "whole", is_flag=True, help="Show also findings that a sure suggestion resolves."),
    click.option("--quiet", is_flag=True, help="Show only the numbers of frames and findings."),
    click.option(
        "--format",
        "style",
        type=click.Choice(tuple(REPORTS)),
        help="How to show findings (default: text); sarif and github are for continuous integration.",
    ),
    click.option("--carrier", type=click.Choice(CARRIERS), help="What carries the frames; a capture says so itself."),
    click.option(
        "--explain", "code", metavar="CODE", help=f"Explain a code, with an example; '{ALL_CODES}' lists them."
    ),
)

_CI = ("--format=sarif", "--format=github")


@click.command()
@click.argument("names", nargs=-1, metavar="[FRAME|FILE|-]...")
@_options
@reading_options
@exclusive(
    "--explain",
    *("--strict", "--fix", "--no-hints", "--errors-only", "--all-findings", "--quiet", "--carrier"),
    *_CI,
)
@exclusive("--strict", "--errors-only")
@exclusive("--json", "--format!json")
@exclusive("--quiet", *_CI)
@exclusive("--fix", *_CI)
def check(names: tuple[str, ...], options: CheckOptions, reading: Options) -> None:
    """Checks whether the brick accepts a frame, which byte is wrong if not, and how to fix it.

    The verdict is the firmware's own, quirks included. Findings say what a careful sender would change: an error will
    not do what was meant, a warning may not, a hint marks something that could be done better. Frames can be written in
    any form that decode reads, or as assembly. In logs and captures, the brick's replies are skipped.

    Exit status: 1 if the brick refuses a frame, if there are errors, or if the input cannot be read; else 0.

    \b
      ev3proto check 08 00 2a 00 80 00 00 81 01 60
      ev3proto check 'UI_READ(GET_VBATT, GV0(0))'
      ev3proto check --fix "0x|0E:00|2A:00|80|00:00|94|01|02|82:B8:01|81:E8:03|"
      ev3proto check --strict --no-hints robot.log
      ev3proto check robot.rbf
      ev3proto check robot.lms
      ev3proto check --errors-only --format github robot.log
      ev3proto check --explain E101
    """  # noqa: D301 - the mark by which click leaves lines as they are
    if options.code is not None:
        if names:
            raise incompatible("--explain", "FRAME")
        _explain(options.code, as_json=options.format == "json", dialect=reading.dialect)
        return
    output = REPORTS[options.format](reading.dialect)
    problems = Problems(heard=output.complaint)
    is_edited = options.fixes and options.format == "text" and reading.filter is None and reading.missing is None
    sources = replace(reading, whole=MOST_EDITED * is_edited, wanted="command")
    checking = Checking(Reading(named(names), sources), options, output, problems)
    checking.run()
    tally = checking.tally
    if tally.replies and not tally.frames and not tally.programs and not problems.errors:
        replies = counted(tally.replies, "frame")
        problems.wrong(f"no command found, only {replies} from the brick; `ev3proto check` checks commands")
    sys.exit(problems.status)


def _explain(name: str, *, as_json: bool, dialect: str) -> None:
    """Explains a code, or lists all. Raises click.BadParameter for an unknown one."""
    known = PROGRAM_CODES | CODES
    found = list(known.values()) if name == ALL_CODES else [known[name.upper()]] if name.upper() in known else []
    if not found:
        hint = _near_code(name, known) or f"; --explain {ALL_CODES} lists the codes"
        raise click.BadParameter(f"unknown code {name}{hint}", param_hint="'--explain'")
    printer = Printer()
    for code in found:
        if as_json:
            say_json(_code_entry(code))
        elif name == ALL_CODES:
            printer.lines(
                [[(f"{code.code}  ", Role.OPERATION), (f"{code.severity!s:8} ", Role.ASIDE), (code.title, Role.PLAIN)]]
            )
        else:
            from ev3proto.program.checking import explained  # takes 9 ms, which frames do not need

            printer.lines(explained(code, dialect=dialect))


def _near_code(name: str, known: Iterable[str]) -> str:
    """Returns a hint at the code that is nearest to an unknown one, by letter and number."""
    near = near_misses(name, known)
    same = [code for code in known if code[:1] == name[:1].upper()]
    if near or not same or not name[1:].isdecimal():
        return near
    return f": did you mean {min(same, key=lambda code: abs(int(code[1:]) - int(name[1:])))}?"


def _code_entry(code: FindingCode) -> dict[str, Any]:
    return {
        "code": code.code,
        "severity": code.severity,
        "title": code.title,
        "story": code.explanation,
        "example": code.example.hex(),
        "counterexample": code.counterexample.hex(),
    }

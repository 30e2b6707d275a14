"""The virtual brick's display: shapes pixel for pixel as the firmware draws them, text and icons in their cells."""

import math
import struct
import zlib
from collections.abc import Callable, Iterable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.cpu_time import milliseconds
from support.effort import effort

from ev3proto.brick.devices.display import HEIGHT, WIDTH, Canvas, Display
from ev3proto.brick.devices.display.fonts import FONTS
from ev3proto.brick.devices.display.graph import Graph, Scale
from ev3proto.brick.devices.display.icons import ICONS
from ev3proto.brick.devices.display.pictures import braille, read_picture, write_png

Pixels = set[tuple[int, int]]


def pixels(canvas: Canvas) -> Pixels:
    """The set pixels as (x, y)."""
    return {
        (x, y) for y, row in enumerate(canvas.rows) if row for x, bit in enumerate(f"{row:0{WIDTH}b}") if bit == "1"
    }


def drawn(draw: Callable[[Canvas], None], dark: bool = False) -> Pixels:
    """What a shape sets on a clear canvas, or clears on a dark one."""
    canvas, changed = Canvas(), Canvas()
    if dark:
        canvas.fillrect(1, 0, 0, WIDTH, HEIGHT)
    before = canvas.copy()
    draw(canvas)
    changed.rows = [old ^ new for old, new in zip(before.rows, canvas.rows, strict=True)]
    return pixels(changed)


def picture(text: str, left: int = 0, top: int = 0) -> Pixels:
    """Pixels drawn as text, `#` is set."""
    lines = text.split()
    return {(left + x, top + y) for y, line in enumerate(lines) for x, mark in enumerate(line) if mark == "#"}


def row(y: int, columns: Iterable[int]) -> Pixels:
    return {(x, y) for x in columns}


SHAPES = {
    "a pixel": (lambda c: c.pixel(1, 177, 127), {(177, 127)}),
    "a pixel outside": (lambda c: c.pixel(1, 178, 0), set()),
    "a pixel above": (lambda c: c.pixel(1, 0, -1), set()),
    "a line of one pixel": (lambda c: c.line(1, 5, 5, 5, 5), {(5, 5)}),
    "a flat line": (lambda c: c.line(1, 0, 0, 5, 2), picture("##.... ..##.. ....##")),
    "the same from the other end": (lambda c: c.line(1, 5, 2, 0, 0), picture("##.... ..##.. ....##")),
    "a steep line upward": (lambda c: c.line(1, 0, 5, 2, 0), picture("..# ..# .#. .#. #.. #..")),
    "a diagonal": (lambda c: c.line(1, 0, 0, 3, 3), picture("#... .#.. ..#. ...#")),
    "a line from outside": (lambda c: c.line(1, -2, 3, 2, 3), row(3, range(3))),
    "a line that crosses the corner": (lambda c: c.line(1, -1, 1, 1, -1), {(0, 0)}),
    "a column backwards": (lambda c: c.line(1, 4, 200, 4, 125), {(4, y) for y in (125, 126, 127)}),
    "dots": (lambda c: c.dotline(1, 0, 0, 11, 0, 3, 2), row(0, (0, 1, 2, 5, 6, 7, 10, 11))),
    "dots upward": (lambda c: c.dotline(1, 0, 5, 0, 0, 1, 1), {(0, 5), (0, 3), (0, 1)}),
    "dots of fewer than no pixels": (lambda c: c.dotline(1, 0, 0, 9, 0, 4, -5), {(0, 0)}),
    "oblique dots": (lambda c: c.dotline(1, 0, 0, 3, 3, 1, 1), {(n, n) for n in range(4)}),
    "a rectangle": (lambda c: c.rect(1, 1, 1, 4, 3), picture("#### #..# ####", 1, 1)),
    "a rectangle of no width": (lambda c: c.rect(1, 4, 0, 0, 3), picture("## ## ##", 3, 0)),
    "a filled rectangle": (lambda c: c.fillrect(1, 176, 126, 60, 40), picture("## ##", 176, 126)),
    "a filled rectangle of no height": (lambda c: c.fillrect(1, 4, 4, 5, 0), set()),
    "a filled rectangle of less than no width": (lambda c: c.fillrect(1, 4, 4, -5, 5), set()),
    "an inverted rectangle": (lambda c: c.inverserect(-1, -1, 3, 3), picture("## ##")),
    "a circle of radius 0": (lambda c: c.circle(1, 9, 9, 0), set()),
    "a circle of radius 1": (lambda c: c.circle(1, 1, 1, 1), picture(".#. #.# .#.")),
    "a circle of radius 4": (
        lambda c: c.circle(1, 4, 4, 4),
        picture("...###... .##...##. .#.....#. #.......# #.......# #.......# .#.....#. .##...##. ...###..."),
    ),
    "a disc of radius 2": (lambda c: c.fillcircle(1, 2, 2, 2), picture(".###. ##### ##### ##### .###.")),
    "a disc half outside": (lambda c: c.fillcircle(1, 0, 0, 1), picture("## #.")),
    "a window": (lambda c: c.fillwindow(1, 126, 1), row(126, range(WIDTH))),
    "a window down to the bottom": (lambda c: c.fillwindow(1, 127, 0), row(127, range(WIDTH))),
    "a window that reaches the bottom": (lambda c: c.fillwindow(1, 100, 28), set()),
    "a pattern, its height the row it ends at": (
        lambda c: c.fillwindow(3, 1, 3),
        row(1, (x for x in range(WIDTH) if x % 8 < 2)) | row(2, (x for x in range(WIDTH) if x % 8 >= 2)),
    ),
    "a pattern that ends before it begins": (lambda c: c.fillwindow(0x55, 10, 5), set()),
    "a bar with a knob of five columns": (
        lambda c: c.vertbar(1, 10, 10, 5, 30, 0, 10, 10),
        picture("##### " + "#...# " * 28 + "#####", 10, 10)
        | picture(".###. .#.#. ..#.. .#.#. ..#.. .#.#. .###.", 10, 10 + 23),
    ),
    "a bar with a knob of six columns": (
        lambda c: c.vertbar(1, 0, 0, 6, 12, 0, 4, 0),
        picture("###### ##..## #....# #.##.# #....# #.##.# #....# ##..## #.##.# #....# #....# ######"),
    ),
    "a bar with a plain knob": (
        lambda c: c.vertbar(1, 0, 0, 4, 12, 0, 4, 9),
        picture("#### #..# #..# #..# #..# #..# #..# #..# #..# #### #### ####"),
    ),
}


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape(name: str) -> None:
    draw, expected = SHAPES[name]
    assert drawn(draw) == expected


@pytest.mark.parametrize(
    ("draw", "cleared"),
    [
        (lambda c: c.line(0, 0, 0, 5, 2), picture("##.... ..##.. ....##")),
        (lambda c: c.fillrect(0, 2, 2, 2, 2), picture("## ##", 2, 2)),
        (lambda c: c.fillwindow(0, 3, 1), row(3, range(WIDTH))),
        (lambda c: c.inverserect(5, 5, 1, 2), {(5, 5), (5, 6)}),
        (lambda c: c.dotline(1, 0, 0, 5, 0, 1, 1), row(0, (1, 3, 5))),
        (lambda c: c.scroll(2), {(x, y) for x in range(WIDTH) for y in (126, 127)}),
        (lambda c: c.scroll(128), set()),
        (lambda c: c.scroll(-1), set()),
        (lambda c: c.clean(), {(x, y) for x in range(WIDTH) for y in range(HEIGHT)}),
    ],
)
def test_what_clears_pixels(draw: Callable[[Canvas], None], cleared: Pixels) -> None:
    assert drawn(draw, dark=True) == cleared


def test_a_picture_moves_up() -> None:
    canvas = Canvas()
    canvas.pixel(1, 7, 20)
    canvas.scroll(15)
    assert pixels(canvas) == {(7, 5)}


def test_shapes_of_any_size_end() -> None:
    """16-bit sums overflow in lines longer than 16383 pixels; on a brick some of them never end."""
    canvas = Canvas()
    canvas.line(1, -32768, -32768, 32767, 32000)
    canvas.clean()
    canvas.fillcircle(1, 0, 0, 32767)
    assert len(pixels(canvas)) == WIDTH * HEIGHT


def stepped(x0: int, y0: int, x1: int, y1: int) -> set[tuple[int, int]]:
    """The pixels of a line as the firmware finds them, step by step."""
    dx, dy = abs(x1 - x0), abs(y1 - y0)
    error, found = dx - dy, {(x0, y0)}
    while (x0, y0) != (x1, y1):
        twice = 2 * error
        if twice > -dy:
            error, x0 = error - dy, x0 + (1 if x0 < x1 else -1)
        if twice < dx:
            error, y0 = error + dx, y0 + (1 if y0 < y1 else -1)
        found.add((x0, y0))
    return {(x, y) for x, y in found if 0 <= x < WIDTH and 0 <= y < HEIGHT}


def octant(radius: int) -> list[tuple[int, int]]:
    """One eighth of a circle, as the firmware finds it."""
    x, y, p, found = 0, radius, 3 - 2 * radius, []
    while x < y:
        found.append((x, y))
        p, y = (p + 4 * x + 6, y) if p < 0 else (p + 4 * (x - y) + 10, y - 1)
        x += 1
    return [*found, (x, y)]


places = st.integers(-60, 240) | st.integers(-1500, 1500)


@settings(max_examples=effort(100, 3000), deadline=None)
@given(x0=places, y0=places, x1=places, y1=places)
def test_a_clipped_line_has_the_same_pixels(x0: int, y0: int, x1: int, y1: int) -> None:
    canvas = Canvas()
    canvas.line(1, x0, y0, x1, y1)
    assert pixels(canvas) == stepped(x0, y0, x1, y1)


@settings(max_examples=effort(100, 3000), deadline=None)
@given(x=places, y=places, radius=st.integers(1, 90) | st.integers(1, 3000))
def test_a_clipped_circle_has_the_same_pixels(x: int, y: int, radius: int) -> None:
    outline, disc = Canvas(), Canvas()
    outline.circle(1, x, y, radius)
    disc.fillcircle(1, x, y, radius)
    circle = {(across, down) for dx, dy in octant(radius) for across, down in ((dx, dy), (dy, dx))}
    around = {(x + i * dx, y + j * dy) for dx, dy in circle for i in (-1, 1) for j in (-1, 1)}
    assert pixels(outline) == {(column, row) for column, row in around if 0 <= column < WIDTH and 0 <= row < HEIGHT}
    widths = {dy: max(dx for dx, other in circle if other == dy) for _, dy in circle}
    assert pixels(disc) == {
        (column, row)
        for row in range(HEIGHT)
        if abs(row - y) in widths
        for column in range(max(x - widths[abs(row - y)], 0), min(x + widths[abs(row - y)] + 1, WIDTH))
    }


@settings(max_examples=effort(60, 2000), deadline=None)
@given(x=places, y=places, length=places, on=st.integers(-2, 7), off=st.integers(-2, 7))
def test_a_clipped_dotted_line_has_the_same_pixels(x: int, y: int, length: int, on: int, off: int) -> None:
    canvas = Canvas()
    canvas.dotline(1, x, y, length, y, on, off)
    count, found = 1, {x}
    for column in range(x, length, 1 if x < length else -1):
        if count < min(on, on + off):
            found.add(column + (1 if x < length else -1))
        count = count + 1 if count + 1 < on + off else 0
    assert pixels(canvas) == {(column, y) for column in found if 0 <= column < WIDTH and 0 <= y < HEIGHT}


def test_no_shape_takes_long() -> None:
    """Programs and direct commands draw; each is interrupted only between two operations."""
    canvas = Canvas()
    shapes = [
        lambda: canvas.line(1, -32000, -32000, 32000, 32000),
        lambda: canvas.line(1, -16000, -100, 16000, 128),
        lambda: canvas.dotline(1, -32000, 5, 3000, 5, 3, 2),
        lambda: canvas.circle(1, 0, 0, 32767),
        lambda: canvas.fillcircle(1, 0, 0, 32767),
        lambda: canvas.fillrect(1, -32768, -32768, 32767, 32767),
    ]
    for shape in shapes:
        assert milliseconds(shape, 25) <= 25


class TestShowing:
    def test_what_is_drawn_is_shown_by_update_only(self) -> None:
        display = Display()
        display.canvas.pixel(1, 0, 0)
        display.canvas.pixel(1, 177, 0)
        assert display.rows == [bytes(23)] * 128
        display.update()
        assert display.rows[0].hex() == "80" + "00" * 21 + "40"

    def test_pictures_are_stored_and_restored(self) -> None:
        display = Display()
        display.canvas.pixel(1, 1, 1)
        for level in (2, 3, -1):
            display.store(level)
        display.clean()
        display.restore(3)
        assert pixels(display.canvas) == set()
        display.restore(2)
        assert pixels(display.canvas) == {(1, 1)}
        display.restore(0)
        assert pixels(display.canvas) == set()

    @pytest.mark.parametrize("what", [Display.clean, Display.update, lambda display: display.fillwindow(0, 0, 0)])
    def test_the_normal_font_comes_back(self, what: Callable[[Display], None]) -> None:
        display = Display()
        display.select_font(2)
        what(display)
        assert display.font == 0

    @pytest.mark.parametrize(("number", "selected"), [(-1, 0), (3, 3), (4, 3), (127, 3)])
    def test_font_numbers_are_clamped(self, number: int, selected: int) -> None:
        display = Display()
        display.select_font(number)
        assert display.font == selected

    def test_the_line_at_the_top(self) -> None:
        """The name is in whole cells, in the middle: 22 cells, so 9 before a name of three letters."""
        display = Display()
        display.is_headed = True
        display.canvas.fillrect(1, 0, 0, WIDTH, 20)
        display.update()
        shown = pixels(display.canvas)
        assert row(10, range(WIDTH)) <= shown
        assert not row(0, range(WIDTH)) & shown
        name = Display()
        name.text(1, 72, 1, b"EV3", 1)
        assert {pixel for pixel in shown if 16 <= pixel[0] < 160 and pixel[1] < 9} == pixels(name.canvas)


def inked(draw: Callable[[Display], None]) -> tuple[int, int, int, int] | None:
    """The box of a text in colour 0, in which everything except the letters is set: left, top, right, bottom."""
    display = Display()
    draw(display)
    found = pixels(display.canvas)
    if not found:
        return None
    columns, rows = {x for x, _ in found}, {y for _, y in found}
    return min(columns), min(rows), max(columns), max(rows)


class TestText:
    @pytest.mark.parametrize(
        ("font", "x", "box"),
        [
            (0, 169, (169, 0, 176, 8)),
            (0, 170, None),
            (1, 8, (8, 0, 15, 7)),
            (2, 161, (161, 0, 176, 15)),
            (2, 162, None),
            (3, 172, (172, 0, 176, 6)),
            (3, 173, None),
        ],
    )
    def test_a_cell_must_end_before_the_last_column(
        self, font: int, x: int, box: tuple[int, int, int, int] | None
    ) -> None:
        assert inked(lambda display: display.text(0, x, 0, b" ", font)) == box

    @pytest.mark.parametrize(
        ("x", "y", "box"),
        [
            (16, 125, (16, 125, 23, 127)),
            (3, -4, (3, 0, 10, 4)),
            (-3, 0, (0, 0, 4, 8)),
            (-8, 4, (176, 3, 177, 11)),
            (-8, 120, (176, 119, 177, 127)),
            (-8, 0, (176, 0, 177, 7)),
        ],
    )
    def test_cells_at_the_edges(self, x: int, y: int, box: tuple[int, int, int, int]) -> None:
        """Whole bytes left of the display are drawn at the end of the row above."""
        assert inked(lambda display: display.text(0, x, y, b" ")) == box

    def test_a_character_without_a_glyph_leaves_a_gap(self) -> None:
        display = Display()
        display.text(0, 0, 0, b"\x1f\x80 \xff ")
        assert {x // 8 for x, _ in pixels(display.canvas)} == {2, 4}

    def test_cells_are_opaque(self) -> None:
        display = Display()
        display.canvas.fillrect(1, 0, 0, 20, 20)
        display.text(1, 5, 5, b" ")
        assert pixels(display.canvas) == {(x, y) for x in range(20) for y in range(20)} - {
            (x, y) for x in range(5, 13) for y in range(5, 14)
        }

    def test_every_glyph_is_legible(self) -> None:
        """All printable characters differ and fit their cells, in every font."""
        for font in FONTS.values():
            assert len(font.glyphs) == 96
            assert len(set(font.glyphs)) == 96
            for glyph in font.glyphs:
                assert len(glyph) == font.height
                assert max(glyph) < 1 << font.width

    @pytest.mark.parametrize(
        ("number", "figures", "decimals", "text"),
        [
            (3.14159, 5, 2, b" 3.14"),
            (3.14159, 3, 2, b"3.1"),
            (-3.14159, 4, 2, b"-3.14"),
            (7.0, -4, 0, b"7"),
            (float("nan"), 3, 1, b"---"),
            (float("nan"), -2, 1, b"--"),
        ],
    )
    def test_numbers(self, number: float, figures: int, decimals: int, text: bytes) -> None:
        by_value, by_text = Display(), Display()
        by_value.value(1, 10, 10, number, figures, decimals)
        by_text.text(1, 10, 10, text)
        assert by_value.canvas.rows == by_text.canvas.rows

    @pytest.mark.parametrize(
        ("number", "text", "indent", "sign"),
        [
            (12.0, b"12", 8, 0),
            (-12.0, b"12", 8, 1),
            (12345.0, b">>>>", 0, None),
            (float("nan"), b"----", 0, None),
            (float("-inf"), b"----", 0, None),
            (-1234.0, b"1234", 0, 1),
        ],
    )
    def test_a_number_with_its_sign_as_a_line(self, number: float, text: bytes, indent: int, sign: int | None) -> None:
        by_value, expected = Display(), Display()
        by_value.view_value(1, 20, 10, number, 4, 0)
        expected.text(1, 20 + indent, 10, text)
        if sign is not None:
            expected.canvas.line(sign, 18 + indent, 14, 20 + indent, 14)
        assert by_value.canvas.rows == expected.canvas.rows

    def test_a_number_erases_the_line_behind_it(self) -> None:
        display = Display()
        display.canvas.fillrect(1, 0, 0, WIDTH, HEIGHT)
        display.view_value(1, 20, 10, float("nan"), 1, 0)
        assert set(row(14, range(30))) - pixels(display.canvas) == row(14, range(18, 29))

    def test_a_number_with_its_unit(self) -> None:
        by_value, expected = Display(), Display()
        by_value.view_unit(1, 20, 10, -2.5, 4, 1, b"cm")
        expected.text(1, 20, 10, b"2.5", 2)
        for y in (17, 18):
            expected.canvas.line(1, 15, y, 20, y)
        expected.text(1, 20 + 48, 10, b"cm", 1)
        assert by_value.canvas.rows == expected.canvas.rows
        assert by_value.font == 0


class TestGraphs:
    NAN = float("nan")

    def graph(self, *samples: float) -> Graph:
        """One item in rows 10 to 30, from 0 to 100."""
        values = iter(samples)
        graph = Graph(5, 4, (lambda: Scale(10, 20, 0.0, 100.0, next(values)),))
        for _ in samples:
            graph.sample()
        graph.items = (lambda: Scale(10, 20, 0.0, 100.0, self.NAN),)
        return graph

    @pytest.mark.parametrize(
        ("samples", "view", "expected"),
        [
            ((100.0, 0.0), 0, {(5, 10), (6, 30)}),
            ((100.0, NAN), 0, {(5, 10)}),
            ((100.0, NAN), -1, {(6, 10), (7, 30)}),
            ((500.0, -500.0), 1, {(6, 10), (7, 30)}),
            ((0.0, 50.0, 50.0), 0, {(5, 30), (6, 20), (7, 20), (6, 19), (7, 19), (6, 21), (7, 21)}),
        ],
    )
    def test_what_is_drawn(self, samples: tuple[float, ...], view: int, expected: Pixels) -> None:
        canvas = Canvas()
        self.graph(*samples).draw(canvas, view)
        assert pixels(canvas) == expected

    def test_the_oldest_samples_are_lost(self) -> None:
        assert self.graph(9.0, 1.0, self.NAN, 3.0, 2.0).draw(Canvas(), 0) == (2.0, 1.0, 3.0, 2.0)

    def test_no_samples_give_nan(self) -> None:
        assert [math.isnan(number) for number in self.graph(self.NAN).draw(Canvas(), 0)] == [True] * 4


class TestPictures:
    @pytest.mark.parametrize(
        ("kind", "width", "height", "count"),
        [(0, 24, 12, 35), (1, 16, 8, 22), (2, 24, 22, 28), (3, 16, 12, 11), (4, 8, 12, 3)],
    )
    def test_icons_fill_their_cells(self, kind: int, width: int, height: int, count: int) -> None:
        icons = ICONS[kind]
        assert (icons.width, icons.height, len(icons.pictures)) == (width, height, count)
        display = Display()
        display.canvas.fillrect(1, 0, 0, WIDTH, HEIGHT)
        display.icon(1, 15, 20, kind, 1)
        display.icon(0, 15, 20, kind, 1)
        display.icon(1, 15, 20, kind, count)
        inverted = {(x, y) for x, y in pixels(display.canvas) if 8 <= x < 8 + width and 20 <= y < 20 + height}
        assert len(inverted) == width * height - sum(row.bit_count() for row in icons.pictures[1])
        assert len(pixels(display.canvas)) == WIDTH * HEIGHT - width * height + len(inverted)

    def test_icons_with_a_name_differ(self) -> None:
        for icons in ICONS.values():
            drawings = [picture for picture in icons.pictures if any(picture)]
            assert len(set(drawings)) == len(drawings)

    def test_a_picture_file(self) -> None:
        """Ten columns, two rows; the lowest bit of a byte is the leftmost pixel."""
        found = read_picture(bytes.fromhex("0a02 0102 ff00"))
        assert (found.width, found.rows) == (10, (0b1000000001, 0b1111111100))
        display = Display()
        display.picture(0, -1, 126, found)
        assert pixels(display.canvas) == row(126, range(8)) | row(127, (7, 8))

    @pytest.mark.parametrize("data", ["", "05", "0a02", "ff80"])
    def test_what_is_missing_of_a_file_is_clear(self, data: str) -> None:
        display = Display()
        display.picture(1, 0, 0, read_picture(bytes.fromhex(data)))
        assert pixels(display.canvas) == set()


class TestLookingAtIt:
    def test_as_png(self) -> None:
        """Read back by hand: one bit a pixel, set pixels black, every pixel twice as large."""
        data = write_png([bytes.fromhex("8040"), bytes.fromhex("ff00")], 10, 2)
        assert data.startswith(b"\x89PNG\r\n\x1a\n")
        assert struct.unpack(">II", data[16:24]) == (20, 4)
        at = data.index(b"IDAT")
        body = zlib.decompress(data[at + 4 : at + 4 + int.from_bytes(data[at - 4 : at], "big")])
        assert body.hex() == "003fffcf" * 2 + "000000ff" * 2

    def test_as_braille(self) -> None:
        assert braille([b"\x80", b"\x40", b"\x00", b"\xc0"], 4) == ["⣑⠀"]

"""The virtual brick's operations of display, buttons, light, terminal, battery and sound, sent as direct commands."""

from pathlib import Path

import pytest
from support.brick import RefusedError, answer, ask

from ev3proto.brick import Brick


def rows(brick: Brick, first: int, count: int) -> list[str]:
    """Rows that are shown, in hex."""
    return [row.hex() for row in brick.display.rows[first : first + count]]


class TestDrawing:
    @pytest.mark.parametrize(
        ("draw", "shown"),
        [
            ("UI_DRAW(PIXEL, 1, 1, 0)", ["40", "00", "00"]),
            ("UI_DRAW(LINE, 1, 0, 0, 2, 2)", ["80", "40", "20"]),
            ("UI_DRAW(DOTLINE, 1, 0, 1, 7, 1, 2, 2)", ["00", "cc", "00"]),
            ("UI_DRAW(RECT, 1, 0, 0, 4, 3)", ["f0", "90", "f0"]),
            ("UI_DRAW(FILLRECT, 1, 4, 1, 4, 2)", ["00", "0f", "0f"]),
            ("UI_DRAW(FILLRECT, 1, 0, 0, 8, 3) UI_DRAW(INVERSERECT, 1, 1, 6, 1)", ["ff", "81", "ff"]),
            ("UI_DRAW(CIRCLE, 1, 1, 1, 1)", ["40", "a0", "40"]),
            ("UI_DRAW(FILLCIRCLE, 1, 1, 1, 1)", ["40", "e0", "40"]),
            ("UI_DRAW(FILLWINDOW, 1, 1, 1)", ["00", "ff", "00"]),
            ("UI_DRAW(FILLWINDOW, 3, 0, 2)", ["c0", "3f", "00"]),
            ("UI_DRAW(FILLRECT, 1, 0, 1, 8, 9) UI_DRAW(SCROLL, 8)", ["ff", "ff", "00"]),
            ("UI_DRAW(FILLRECT, 1, 0, 0, 9, 9) UI_DRAW(CLEAN)", ["00", "00", "00"]),
            ("UI_DRAW(VERTBAR, 1, 0, 0, 3, 3, 0, 3, 0)", ["e0", "a0", "e0"]),
            ("UI_DRAW(PIXEL, 1, 0, 0) UI_DRAW(STORE, 1) UI_DRAW(CLEAN) UI_DRAW(RESTORE, 1)", ["80", "00", "00"]),
            ("UI_DRAW(POPUP, 1) UI_DRAW(PIXEL, 1, 0, 0) UI_DRAW(POPUP, 0)", ["00", "00", "00"]),
            ("UI_DRAW(SELECT_FONT, TINY_FONT) UI_DRAW(TEXT, 0, 0, 0, ' ')", ["f8", "f8", "f8"]),
            ("UI_DRAW(TEXT, 0, -4, -7, ' ')", ["f0", "f0", "00"]),
            ("UI_DRAW(VALUE, 0, 0, -7, 2.0F, 0, 0)", ["00", "00", "00"]),
            ("UI_DRAW(ICON, 0, 7, -10, SMALL_ICON, 17)", ["00", "00", "00"]),
            ("UI_DRAW(ICON, 0, 7, -6, SMALL_ICON, 17)", ["ff", "ff", "00"]),
        ],
    )
    def test_what_is_seen_at_the_top_left(self, brick: Brick, draw: str, shown: list[str]) -> None:
        ask(brick, f"{draw} UI_DRAW(UPDATE)")
        assert [row[:2] for row in rows(brick, 0, 3)] == shown

    def test_pictures_survive_the_command_that_stored_them(self, brick: Brick) -> None:
        ask(brick, "UI_DRAW(PIXEL, 1, 0, 0) UI_DRAW(STORE, 2) UI_DRAW(CLEAN)")
        ask(brick, "UI_DRAW(RESTORE, 2) UI_DRAW(UPDATE)")
        assert rows(brick, 0, 1) == ["80" + "00" * 22]

    def test_who_opens_a_popup_draws_alone(self, brick: Brick) -> None:
        """It waits for what others have drawn to be shown, and shows what was there when it is closed."""
        ask(brick, "UI_DRAW(PIXEL, 1, 0, 0) UI_DRAW(UPDATE) UI_DRAW(POPUP, 1) UI_DRAW(CLEAN) UI_DRAW(UPDATE)")
        assert brick.display.is_blocked_for(1, 1)
        assert rows(brick, 0, 1) == ["00" * 23]
        ask(brick, "UI_DRAW(POPUP, 0)")
        assert rows(brick, 0, 1) == ["80" + "00" * 22]
        ask(brick, "UI_DRAW(PIXEL, 1, 1, 0)")
        assert ask(brick, "UI_DRAW(POPUP, 1)", seconds=1) == "busy"

    def test_a_blocked_display_ignores_drawing(self, brick: Brick) -> None:
        ask(brick, "UI_WRITE(SCREEN_BLOCK, 1) UI_DRAW(FILLRECT, 1, 0, 0, 9, 9) UI_DRAW(UPDATE)")
        assert rows(brick, 0, 1) == ["00" * 23]
        ask(brick, "UI_WRITE(SCREEN_BLOCK, 0) UI_DRAW(FILLRECT, 1, 0, 0, 8, 9) UI_DRAW(UPDATE)")
        assert rows(brick, 0, 1) == ["ff" + "00" * 22]

    def test_the_line_at_the_top_is_redrawn(self, brick: Brick) -> None:
        ask(brick, "UI_DRAW(TOPLINE, 1) UI_DRAW(FILLRECT, 1, 0, 9, 8, 3)")
        brick.advance(0.5)
        assert rows(brick, 9, 4) == ["00" * 23, "ff" * 22 + "c0", "ff" + "00" * 22, "00" * 23]

    def test_a_graph_lives_for_one_command(self, brick: Brick) -> None:
        """Three samples of one item: two pixels, then three lines from the second to the third."""
        memory = ask(
            brick,
            """
            DATAF actual  DATAF lowest  DATAF highest  DATAF average
            local DATA16 offset  local DATA16 span  local DATAF min  local DATAF max  local DATAF value
            MOVE16_16(10, offset)  MOVE16_16(20, span)  MOVEF_F(0.0F, min)  MOVEF_F(100.0F, max)
            UI_DRAW(GRAPH_SETUP, 5, 50, 1, offset, span, min, max, value)
            MOVEF_F(50.0F, value) UI_WRITE(GRAPH_SAMPLE)
            MOVEF_F(0.0F, value) UI_WRITE(GRAPH_SAMPLE)
            MOVEF_F(10.0F, value) UI_WRITE(GRAPH_SAMPLE)
            UI_DRAW(GRAPH_DRAW, 0, actual, lowest, highest, average)
            UI_DRAW(UPDATE)
            """,
        )
        assert memory == "00 00 20 41 00 00 00 00 00 00 48 42 00 00 a0 41"
        seen = [f"{int(row[:4], 16):016b}"[4:10] for row in rows(brick, 20, 12)]
        assert seen == [
            "010000",  # the first sample, 50 of 100
            "000000",
            "000000",
            "000000",
            "000000",
            "000000",
            "000000",
            "000010",
            "000100",
            "001100",
            "011000",
            "010000",
        ]

    def test_pictures_from_files(self, tmp_path: Path) -> None:
        """Names without a folder are looked up in sys, those without an extension are pictures."""
        (tmp_path / "sys").mkdir()
        (tmp_path / "sys" / "mark.rgf").write_bytes(bytes.fromhex("0a02 0102 ff00"))
        brick = Brick(root=tmp_path)
        ask(brick, "UI_DRAW(BMPFILE, 1, 1, 0, 'mark') UI_DRAW(BMPFILE, 1, 90, 0, 'none') UI_DRAW(UPDATE)")
        assert [row[:4] for row in rows(brick, 0, 2)] == ["4020", "7f80"]
        memory = ask(
            brick,
            """
            DATA32 size
            local DATA32 address
            FILE(LOAD_IMAGE, 1, './mark.rgf', size, address)
            UI_DRAW(CLEAN) UI_DRAW(PICTURE, 0, -8, 0, address) UI_DRAW(UPDATE)
            """,
        )
        assert memory == "06 00 00 00"
        assert [row[:4] for row in rows(brick, 0, 2)] == ["8000", "c000"]
        with pytest.raises(RefusedError):
            ask(brick, "UI_DRAW(PICTURE, 1, 0, 0, 1)")

    def test_a_popup_waits_until_what_was_drawn_is_shown(self, brick: Brick) -> None:
        assert ask(brick, "UI_DRAW(PIXEL, 1, 0, 0) UI_DRAW(POPUP, 1)", seconds=1) == "busy"


class TestText:
    @pytest.mark.parametrize(
        ("number", "memory"),
        [
            (0, "00"),
            (1, "6f 6e 65 00"),
            (2, "74 77 6f 00"),
            (3, "00"),
        ],
    )
    def test_lines_of_a_text_box(self, brick: Brick, number: int, memory: str) -> None:
        """The second line has the mark of a font before it; the third has no end, so it does not count."""
        text = "one\\n\\x02two\\nthree"
        read = f"UI_READ(TEXTBOX_READ, '{text}', 99, DEL_LINEFEED, 16, {number}, line)"
        assert ask(brick, f"DATAS line 16 {read}").startswith(memory)

    def test_without_a_delimiter_every_line_ends_at_once(self, brick: Brick) -> None:
        assert ask(brick, "DATAS line 4 UI_READ(TEXTBOX_READ, 'one', 99, DEL_NONE, 4, 1, line)") == "00 00 00 00"

    def test_lines_are_appended_within_the_size(self, brick: Brick) -> None:
        append = "UI_WRITE(TEXTBOX_APPEND, text, 8, DEL_COMMA, 'abc')"
        assert ask(brick, f"DATAS text 9 {append}") == "61 62 63 2c 00 00 00 00 00"
        assert ask(brick, f"DATAS text 9 UI_DRAW(SELECT_FONT, 2) {append}") == "61 62 63 2c 02 61 62 63 00"

    @pytest.mark.parametrize(
        ("write", "text"),
        [
            ("UI_WRITE(PUT_STRING, 'abc') UI_WRITE(PUT_STRING, 'd')", b"abcd"),
            ("UI_WRITE(VALUE8, -5)", b"-5"),
            ("UI_WRITE(VALUE16, -1)", b"65535"),
            ("UI_WRITE(VALUE32, -1)", b"-1"),
            ("UI_WRITE(VALUEF, 0.1F)", b"0.100000"),
            ("UI_WRITE(FLOATVALUE, 3.14159F, 6, 2)", b"  3.14"),
            ("UI_WRITE(VALUE8, -128) UI_WRITE(VALUE16, -32768) UI_WRITE(VALUE32, -2147483648)", b"nannannan"),
            ("UI_WRITE(PUT_STRING, 'abc') UI_FLUSH()", b""),
            ("UI_WRITE(PUT_STRING, 'abc') UI_WRITE(WRITE_FLUSH)", b""),
            ("UI_WRITE(STAMP, 'here')", b""),
            (f"UI_WRITE(PUT_STRING, '{'a' * 255}')", b""),
            (f"UI_WRITE(PUT_STRING, '{'a' * 250}') UI_WRITE(PUT_STRING, 'bcdefghi')", b"ghi"),
        ],
    )
    def test_the_terminal_gathers_text(self, brick: Brick, write: str, text: bytes) -> None:
        ask(brick, write)
        assert brick.terminal == text

    def test_the_terminal_prints_when_it_is_on(self, brick: Brick) -> None:
        ask(
            brick,
            "UI_WRITE(PUT_STRING, 'lost') UI_FLUSH() UI_WRITE(TERMINAL, 1) UI_WRITE(PUT_STRING, 'seen') UI_FLUSH()",
        )
        assert bytes(brick.equipment.console.printed) == b"seen"

    def test_what_is_typed_is_waited_for(self, brick: Brick) -> None:
        assert ask(brick, "DATA8 key UI_READ(KEY, key)") == "00"
        assert ask(brick, "DATAS line 6 UI_READ(GET_STRING, 5, line)", seconds=1) == "busy"
        brick.equipment.console.typed += b"hello\rx"
        assert answer(brick.advance(0.01)) == "68 65 6c 6c 6f 00"
        assert ask(brick, "DATA8 key UI_READ(KEY, key)") == "78"


class TestState:
    @pytest.mark.parametrize(
        ("read", "text"),
        [
            ("UI_READ(GET_FW_VERS, 16, text)", b"V1.04H"),
            ("UI_READ(GET_FW_VERS, 4, text)", b"V1."),
            ("UI_READ(GET_FW_VERS, -1, text)", b"V1.04H"),
            ("UI_READ(GET_FW_VERS, 0, text)", b""),
            ("UI_READ(GET_HW_VERS, 16, text)", b"V0.60"),
            ("UI_READ(GET_OS_VERS, 20, text)", b"Linux 2.6.33-rc4"),
            ("UI_READ(GET_OS_BUILD, 20, text)", b"1212131117"),
            ("UI_READ(GET_IP, 16, text)", b""),
        ],
    )
    def test_what_the_brick_says_it_is(self, brick: Brick, read: str, text: bytes) -> None:
        assert bytes.fromhex(ask(brick, f"DATAS text 20 {read}")) == text.ljust(20, b"\0")

    @pytest.mark.parametrize(
        ("read", "memory"),
        [
            ("DATAF volt UI_READ(GET_VBATT, volt)", "00 00 f0 40"),
            ("DATA8 percent UI_READ(GET_LBATT, percent)", "64"),
            ("DATAF ampere UI_READ(GET_IBATT, ampere)", "cd cc 4c 3e"),
            ("DATA8 p DATA32 t DATA32 f UI_READ(GET_SDCARD, p, t, f)", " ".join(["00"] * 12)),
            ("DATA8 flags UI_WRITE(SET_BUSY, 1) UI_READ(GET_WARNING, flags)", "80"),
            ("DATA8 event UI_READ(GET_EVENT, event)", "00"),
        ],
    )
    def test_how_it_is_doing(self, brick: Brick, read: str, memory: str) -> None:
        assert ask(brick, read) == memory

    @pytest.mark.parametrize(("volt", "percent"), [(6.0, 0), (6.85, 50), (9.0, 100)])
    def test_how_full_the_battery_is(self, brick: Brick, volt: float, percent: int) -> None:
        brick.equipment.panel.battery.voltage = volt
        assert ask(brick, "DATA8 percent UI_READ(GET_LBATT, percent)") == f"{percent:02x}"

    @pytest.mark.parametrize(("number", "pattern"), [(-3, 0), (0, 0), (2, 2), (9, 9), (10, 9)])
    def test_the_light(self, brick: Brick, number: int, pattern: int) -> None:
        assert brick.leds == 1
        ask(brick, f"UI_WRITE(LED, {number})")
        assert brick.leds == pattern

    def test_the_light_is_orange_while_there_is_a_warning(self, brick: Brick) -> None:
        brick.equipment.panel.warnings = 4
        ask(brick, "UI_WRITE(LED, LED_RED_FLASH)")
        assert brick.leds == 6

    def test_a_busy_brick_keeps_the_colour_of_its_light(self, brick: Brick) -> None:
        ask(brick, "UI_WRITE(SET_BUSY, 1)")
        assert brick.leds == 1


class TestButtons:
    PRESS, RELEASE = "UI_BUTTON(PRESS, {0})", "UI_BUTTON(RELEASE, {0})"

    @pytest.mark.parametrize(
        ("commands", "memory"),
        [
            # Within a command the firmware has not yet looked; after 20 ms, or in the next command, it has.
            (["UI_BUTTON(PRESS, 2) UI_BUTTON(PRESSED, 2, a)"], "00"),
            (["DATA32 t UI_BUTTON(PRESS, 2) TIMER_WAIT(20, t) TIMER_READY(t) UI_BUTTON(PRESSED, 2, a)"], "01"),
            (["UI_BUTTON(PRESS, 2)", "UI_BUTTON(PRESSED, 2, a)"], "01"),
            (["UI_BUTTON(PRESS, 2)", "UI_BUTTON(PRESSED, 3, a)"], "00"),
            (["UI_BUTTON(PRESS, 2)", "UI_BUTTON(PRESSED, 7, a)"], "01"),
            (["UI_BUTTON(PRESS, 2)", "UI_BUTTON(PRESSED, 99, a)"], "01"),
            (["UI_BUTTON(PRESSED, 0, a)"], "00"),
            (["UI_BUTTON(PRESS, 9)", "UI_BUTTON(PRESSED, 6, a)"], "01"),
            # A press is remembered until a program asks.
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(RELEASE, 1)", "UI_BUTTON(SHORTPRESS, 1, a)"], "01"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(SHORTPRESS, 1, b)", "UI_BUTTON(SHORTPRESS, 1, a)"], "00"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(SHORTPRESS, 7, b)", "UI_BUTTON(SHORTPRESS, 1, a)"], "00"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(TESTSHORTPRESS, 1, b)", "UI_BUTTON(SHORTPRESS, 1, a)"], "01"),
            (["UI_BUTTON(SHORTPRESS, 0, a)"], "01"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(SHORTPRESS, 0, a)"], "00"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(SHORTPRESS, 0, b)", "UI_BUTTON(SHORTPRESS, 1, a)"], "00"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(FLUSH)", "UI_BUTTON(SHORTPRESS, 1, a)"], "00"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(GET_BUMBED, 1, a)"], "00"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(RELEASE, 1)", "UI_BUTTON(GET_BUMBED, 1, a)"], "01"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(SHORTPRESS, 1, b)", "UI_BUTTON(GET_CLICK, a)"], "01"),
            (["UI_BUTTON(PRESS, 1)", "UI_BUTTON(TESTSHORTPRESS, 1, b)", "UI_BUTTON(GET_CLICK, a)"], "00"),
            (["UI_BUTTON(SET_BACK_BLOCK, 5)", "UI_BUTTON(GET_BACK_BLOCK, a)"], "05"),
        ],
    )
    def test_a_virtual_finger(self, brick: Brick, commands: list[str], memory: str) -> None:
        reply = ""
        for command in commands:
            reply = ask(brick, f"DATA8 a local DATA8 b {command.replace('DATA32 t', 'local DATA32 t')}", seconds=0.1)
        assert reply == memory

    @pytest.mark.parametrize(
        ("pressed", "horizontal", "vertical"),
        [("left", "ff ff", "00 00"), ("right", "01 00", "00 00"), ("up", "00 00", "ff ff"), ("down", "00 00", "01 00")],
    )
    def test_two_buttons_as_an_axis(self, brick: Brick, pressed: str, horizontal: str, vertical: str) -> None:
        brick.press(pressed)
        both = ask(brick, "DATA16 h DATA16 v UI_BUTTON(GET_HORZ, h) UI_BUTTON(GET_VERT, v)")
        assert both == f"{horizontal} {vertical}"

    def test_a_press_by_hand_that_is_held(self, brick: Brick) -> None:
        short, long = "DATA8 a UI_BUTTON(SHORTPRESS, 3, a)", "DATA8 a UI_BUTTON(LONGPRESS, 3, a)"
        brick.press("down")
        found = []
        for seconds in (0, 0.3, 0.2, 0.2, 2.1, 0.3):
            brick.advance(seconds)
            found.append(ask(brick, short) + ask(brick, long))
        assert found == ["0100", "0000", "0100", "0100", "0100", "0101"]
        brick.release("down")
        assert ask(brick, "DATA8 a UI_BUTTON(GET_BUMBED, 3, a)") == "01"

    def test_each_press_is_repeated(self, brick: Brick) -> None:
        short = "DATA8 a UI_BUTTON(SHORTPRESS, 1, a)"
        for _ in range(2):
            brick.press("up")
            assert ask(brick, short) == "01"
            brick.advance(0.5)
            assert ask(brick, short) == "01"
            brick.release("up")

    def test_enter_is_not_repeated(self, brick: Brick) -> None:
        brick.press("enter")
        ask(brick, "DATA8 a UI_BUTTON(SHORTPRESS, 2, a)")
        brick.advance(2)
        assert ask(brick, "DATA8 a UI_BUTTON(SHORTPRESS, 2, a)") == "00"

    def test_waiting_for_any_button(self, brick: Brick) -> None:
        assert ask(brick, "UI_BUTTON(WAIT_FOR_PRESS)", seconds=5) == "busy"
        brick.press("left")
        assert answer(brick.advance(0.02)) == ""
        assert ask(brick, "UI_BUTTON(WAIT_FOR_PRESS) UI_BUTTON(FLUSH)") == ""
        assert ask(brick, "UI_BUTTON(WAIT_FOR_PRESS)") == "busy"

    def test_an_unknown_button(self, brick: Brick) -> None:
        with pytest.raises(ValueError, match="unknown button 'start'; expected one of up, enter, down"):
            brick.press("start")


class TestDialogues:
    """Each waits for buttons; the variables say how far it is and what was answered."""

    @pytest.fixture
    def brick(self, tmp_path: Path) -> Brick:
        for name in ("a.rbf", "b.rsf", "c.txt"):
            (tmp_path / "prjs" / "demo").mkdir(parents=True, exist_ok=True)
            (tmp_path / "prjs" / "demo" / name).write_bytes(b"")
        return Brick(root=tmp_path)

    @pytest.mark.parametrize(
        ("dialogue", "buttons", "memory"),
        [
            ("DATA8 s UI_DRAW(NOTIFICATION, 1, 0, 0, 8, -1, -1, 'careful', s)", ["enter"], "00"),
            ("DATA8 s DATA8 ok UI_DRAW(QUESTION, 1, 0, 0, 1, 2, '', s, ok)", ["enter"], "00 00"),
            ("DATA8 s DATA8 ok UI_DRAW(QUESTION, 1, 0, 0, 1, 2, '', s, ok)", ["right", "enter"], "00 01"),
            ("DATA8 s DATA8 ok UI_DRAW(QUESTION, 1, 0, 0, 1, 2, '', s, ok)", ["back"], "00 ff"),
            (
                "DATA32 i local DATA8 s MOVE32_32(0x700, i) UI_DRAW(ICON_QUESTION, 1, 0, 0, s, i)",
                ["right", "right", "left", "enter"],
                "00 02 00 00",
            ),
            ("DATA32 i local DATA8 s MOVE32_32(6, i) UI_DRAW(ICON_QUESTION, 1, 0, 0, s, i)", ["back"], "00 00 00 00"),
            (
                "DATAS t 4 local DATA8 c UI_DRAW(KEYBOARD, 1, 0, 0, 1, 4, 'name', c, t)",
                ["right", "down", "enter"],
                "42 00 00 00",
            ),
            (
                "DATAS t 4 local DATA8 c STRINGS(DUPLICATE, 'ab', t) UI_DRAW(KEYBOARD, 1, 0, 0, 1, 4, 'name', c, t)",
                ["left", "enter"],
                "61 00 00 00",
            ),
            (
                "DATAS t 4 local DATA8 c STRINGS(DUPLICATE, 'ab', t) UI_DRAW(KEYBOARD, 1, 0, 0, 1, 4, 'name', c, t)",
                ["back"],
                "00 62 00 00",
            ),
            (
                "DATA16 n MOVE16_16(-1, n) UI_DRAW(TEXTBOX, 0, 0, 100, 40, 'one\\ntwo\\nthree\\n', 99, 6, n)",
                ["down", "enter"],
                "02 00",
            ),
            ("DATA16 n MOVE16_16(-1, n) UI_DRAW(TEXTBOX, 0, 0, 100, 40, 'one', 99, 6, n)", ["back"], "ff ff"),
            (
                "DATA8 k DATAS p 24 STRINGS(DUPLICATE, '../prjs/demo', p) UI_DRAW(BROWSE, 1, 0, 0, 99, 99, 24, k, p)",
                ["enter"],
                "03 " + b"../prjs/demo/a.rbf".ljust(24, b"\0").hex(" "),
            ),
        ],
    )
    def test_a_dialogue(self, brick: Brick, dialogue: str, buttons: list[str], memory: str) -> None:
        ask(brick, "UI_DRAW(FILLRECT, 1, 3, 3, 99, 99) UI_DRAW(UPDATE)")
        before = brick.display.rows
        brick.press("enter")
        brick.release("enter")
        assert ask(brick, dialogue, seconds=1) == "busy"
        assert brick.display.rows != before
        for button in buttons[:-1]:
            brick.press(button)
            brick.release(button)
            assert answer(brick.advance(0.1)) == "busy"
        brick.press(buttons[-1])
        assert answer(brick.advance(0.1)) == memory
        assert brick.display.rows == before


class TestSound:
    TEST = "DATA8 busy SOUND_TEST(busy)"

    def is_busy(self, brick: Brick) -> bool:
        return ask(brick, self.TEST) == "01"

    @pytest.mark.parametrize(
        ("volume", "hertz", "played"),
        [
            # Volume in steps of an eighth, rounded up; a negative one is loudest.
            (0, 440, (0, 440)),
            (1, 440, (8, 440)),
            (50, 440, (56, 440)),
            (96, 440, (96, 440)),
            (97, 440, (104, 440)),
            (-1, 440, (104, 440)),
            # Hertz within limits; a negative number is a large one.
            (1, 20_000, (8, 10_000)),
            (1, 20, (8, 250)),
            (1, -1, (8, 10_000)),
        ],
    )
    def test_tones(self, brick: Brick, volume: int, hertz: int, played: tuple[int, int]) -> None:
        ask(brick, f"SOUND(TONE, {volume}, {hertz}, 100)")
        assert brick.equipment.sound.playing is not None
        assert (brick.equipment.sound.playing.volume, brick.equipment.sound.playing.frequency) == played
        assert self.is_busy(brick)
        brick.advance(0.1)
        assert not self.is_busy(brick)

    def test_a_tone_without_end_is_broken_off(self, brick: Brick) -> None:
        ask(brick, "SOUND(TONE, 50, 440, 0)")
        brick.advance(3600)
        assert self.is_busy(brick)
        ask(brick, "SOUND(BREAK)")
        assert not self.is_busy(brick)

    def test_waiting_for_silence(self, brick: Brick) -> None:
        assert ask(brick, "SOUND(TONE, 1, 440, 50) SOUND_READY()", seconds=0.045) == "busy"
        assert answer(brick.advance(0.01)) == ""

    @pytest.mark.parametrize(
        ("header", "size", "seconds"),
        [
            # Format, bytes of data, samples a second, mode. The rate is not used: 8000 a second.
            ("0100 0fa0 1f40 0000", 4000, 0.5),
            ("0100 0fa0 3e80 0000", 4000, 0.5),
            ("0101 0fa0 1f40 0000", 4000, 1.0),
            ("7777 0fa0 1f40 0000", 4000, 0.5),
            # It ends with the file.
            ("0100 0fa0 1f40 0000", 800, 0.1),
        ],
    )
    def test_sound_files(self, tmp_path: Path, header: str, size: int, seconds: float) -> None:
        (tmp_path / "sys").mkdir()
        (tmp_path / "sys" / "horn.rsf").write_bytes(bytes.fromhex(header) + bytes(size))
        brick = Brick(root=tmp_path)
        assert ask(brick, "SOUND(PLAY, 100, './horn') SOUND_READY()", seconds=seconds - 0.01) == "busy"
        assert answer(brick.advance(0.02)) == ""
        ask(brick, "SOUND(REPEAT, 100, 'horn')")
        brick.advance(60)
        assert self.is_busy(brick)

    def test_a_missing_file_keeps_the_speaker_busy(self, brick: Brick) -> None:
        ask(brick, "SOUND(PLAY, 100, 'none')")
        brick.advance(3600)
        assert self.is_busy(brick)
        assert ask(brick, "SOUND_READY()", seconds=10) == "busy"
        assert brick.waits_for == (
            "SOUND_READY waits for the end of a sound file that is missing or empty, which plays until SOUND.BREAK or"
            " another sound"
        )

    def test_a_tone_ends_the_wait_for_a_missing_file(self, brick: Brick) -> None:
        ask(brick, "SOUND(PLAY, 100, 'none') SOUND(TONE, 1, 440, 10)")
        brick.advance(0.01)
        assert not self.is_busy(brick)

"""Every operation of the community's extended firmware as a function.

Generated from ev3proto/tables by ev3proto.generate.stubs: edit those.
"""

# ruff: noqa: I001

from collections.abc import Sequence
from typing import Literal, TypeAlias, overload

from ev3proto.compose import Draft
from ev3proto.enums import CONN
from ev3proto.ops import (
    _BROWSERTYPE,
    _DEL,
    _Elements,
    _FONTTYPE,
    _ICONTYPE,
    _L_ICON_NO,
    _N_ICON_NO,
    _Number,
    _Output,
    _Real,
    _SLOT,
    _Text,
    _Variable,
)
from ev3proto.ops import (
    add16 as add16,
    add32 as add32,
    add8 as add8,
    addf as addf,
    and16 as and16,
    and32 as and32,
    and8 as and8,
    array_append as array_append,
    array_read as array_read,
    array_write as array_write,
    bp0 as bp0,
    bp1 as bp1,
    bp2 as bp2,
    bp3 as bp3,
    bp_set as bp_set,
    call as call,
    com_get as com_get,
    com_read as com_read,
    com_readdata as com_readdata,
    com_ready as com_ready,
    com_remove as com_remove,
    com_set as com_set,
    com_test as com_test,
    com_write as com_write,
    com_writedata as com_writedata,
    com_writefile as com_writefile,
    cp_eq16 as cp_eq16,
    cp_eq32 as cp_eq32,
    cp_eq8 as cp_eq8,
    cp_eqf as cp_eqf,
    cp_gt16 as cp_gt16,
    cp_gt32 as cp_gt32,
    cp_gt8 as cp_gt8,
    cp_gteq16 as cp_gteq16,
    cp_gteq32 as cp_gteq32,
    cp_gteq8 as cp_gteq8,
    cp_gteqf as cp_gteqf,
    cp_gtf as cp_gtf,
    cp_lt16 as cp_lt16,
    cp_lt32 as cp_lt32,
    cp_lt8 as cp_lt8,
    cp_lteq16 as cp_lteq16,
    cp_lteq32 as cp_lteq32,
    cp_lteq8 as cp_lteq8,
    cp_lteqf as cp_lteqf,
    cp_ltf as cp_ltf,
    cp_neq16 as cp_neq16,
    cp_neq32 as cp_neq32,
    cp_neq8 as cp_neq8,
    cp_neqf as cp_neqf,
    div16 as div16,
    div32 as div32,
    div8 as div8,
    divf as divf,
    do as do,
    error as error,
    file as file,
    filename as filename,
    info as info,
    init_bytes as init_bytes,
    input_device as input_device,
    input_device_list as input_device_list,
    input_read as input_read,
    input_readext as input_readext,
    input_readsi as input_readsi,
    input_ready as input_ready,
    input_sample as input_sample,
    input_test as input_test,
    input_write as input_write,
    jr as jr,
    jr_eq16 as jr_eq16,
    jr_eq32 as jr_eq32,
    jr_eq8 as jr_eq8,
    jr_eqf as jr_eqf,
    jr_false as jr_false,
    jr_gt16 as jr_gt16,
    jr_gt32 as jr_gt32,
    jr_gt8 as jr_gt8,
    jr_gteq16 as jr_gteq16,
    jr_gteq32 as jr_gteq32,
    jr_gteq8 as jr_gteq8,
    jr_gteqf as jr_gteqf,
    jr_gtf as jr_gtf,
    jr_lt16 as jr_lt16,
    jr_lt32 as jr_lt32,
    jr_lt8 as jr_lt8,
    jr_lteq16 as jr_lteq16,
    jr_lteq32 as jr_lteq32,
    jr_lteq8 as jr_lteq8,
    jr_lteqf as jr_lteqf,
    jr_ltf as jr_ltf,
    jr_nan as jr_nan,
    jr_neq16 as jr_neq16,
    jr_neq32 as jr_neq32,
    jr_neq8 as jr_neq8,
    jr_neqf as jr_neqf,
    jr_true as jr_true,
    keep_alive as keep_alive,
    label as label,
    mailbox_close as mailbox_close,
    mailbox_open as mailbox_open,
    mailbox_read as mailbox_read,
    mailbox_ready as mailbox_ready,
    mailbox_test as mailbox_test,
    mailbox_write as mailbox_write,
    math as math,
    memory_read as memory_read,
    memory_usage as memory_usage,
    memory_write as memory_write,
    move16_16 as move16_16,
    move16_32 as move16_32,
    move16_8 as move16_8,
    move16_f as move16_f,
    move32_16 as move32_16,
    move32_32 as move32_32,
    move32_8 as move32_8,
    move32_f as move32_f,
    move8_16 as move8_16,
    move8_32 as move8_32,
    move8_8 as move8_8,
    move8_f as move8_f,
    movef_16 as movef_16,
    movef_32 as movef_32,
    movef_8 as movef_8,
    movef_f as movef_f,
    mul16 as mul16,
    mul32 as mul32,
    mul8 as mul8,
    mulf as mulf,
    nop as nop,
    note_to_freq as note_to_freq,
    object_end as object_end,
    object_start as object_start,
    object_stop as object_stop,
    object_trig as object_trig,
    object_wait as object_wait,
    or16 as or16,
    or32 as or32,
    or8 as or8,
    output_clr_count as output_clr_count,
    output_get_count as output_get_count,
    output_polarity as output_polarity,
    output_power as output_power,
    output_prg_stop as output_prg_stop,
    output_read as output_read,
    output_ready as output_ready,
    output_reset as output_reset,
    output_set_type as output_set_type,
    output_speed as output_speed,
    output_start as output_start,
    output_step_power as output_step_power,
    output_step_speed as output_step_speed,
    output_step_sync as output_step_sync,
    output_stop as output_stop,
    output_test as output_test,
    output_time_power as output_time_power,
    output_time_speed as output_time_speed,
    output_time_sync as output_time_sync,
    port_cnv_input as port_cnv_input,
    port_cnv_output as port_cnv_output,
    probe as probe,
    program_start as program_start,
    program_stop as program_stop,
    random as random,
    read16 as read16,
    read32 as read32,
    read8 as read8,
    readf as readf,
    return_ as return_,
    rl16 as rl16,
    rl32 as rl32,
    rl8 as rl8,
    select16 as select16,
    select32 as select32,
    select8 as select8,
    selectf as selectf,
    sleep as sleep,
    sound as sound,
    sound_ready as sound_ready,
    sound_test as sound_test,
    strings as strings,
    sub16 as sub16,
    sub32 as sub32,
    sub8 as sub8,
    subf as subf,
    system as system,
    timer_read as timer_read,
    timer_read_us as timer_read_us,
    timer_ready as timer_ready,
    timer_wait as timer_wait,
    tst as tst,
    ui_button as ui_button,
    ui_flush as ui_flush,
    ui_read as ui_read,
    ui_write as ui_write,
    write16 as write16,
    write32 as write32,
    write8 as write8,
    writef as writef,
    xor16 as xor16,
    xor32 as xor32,
    xor8 as xor8,
)

_CONN_name: TypeAlias = Literal[
    "CONN_UNKNOWN",
    "CONN_DAISYCHAIN",
    "CONN_NXT_COLOR",
    "CONN_NXT_DUMB",
    "CONN_NXT_IIC",
    "CONN_INPUT_DUMB",
    "CONN_INPUT_UART",
    "CONN_OUTPUT_DUMB",
    "CONN_OUTPUT_INTELLIGENT",
    "CONN_OUTPUT_TACHO",
    "CONN_NONE",
    "CONN_ERROR",
]
_CONN: TypeAlias = CONN | _CONN_name | _Number

class _ProgramInfo:
    """PROGRAM_INFO: Asks about a program or controls its objects."""

    def obj_stop(self, prgid: _SLOT, objid: _Number, *, unchecked: bool = False) -> Draft:
        """Stops an object of a running program.

        prgid  program slot; a member of SLOT; DATA16
        objid  object of the program, counted from 1; DATA16
        """

    def obj_start(self, prgid: _SLOT, objid: _Number, *, unchecked: bool = False) -> Draft:
        """Starts an object of a running program from its beginning.

        prgid  program slot; a member of SLOT; DATA16
        objid  object of the program, counted from 1; DATA16
        """

    def get_status(self, prgid: _SLOT, data: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks whether a program runs.

        prgid  program slot; a member of SLOT; DATA16
        data   state of the program; a member of OBJSTAT; DATA8; an output, in global memory when left away
        """

    def get_speed(self, prgid: _SLOT, data: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks how fast a program runs.

        prgid  program slot; a member of SLOT; DATA16
        data   speed since the program started; instructions/s; DATA32; an output, in global memory when
               left away
        """

    def get_prgresult(self, prgid: _SLOT, data: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks how a program ended.

        prgid  program slot; a member of SLOT; DATA16
        data   OK, BUSY (still running) or FAIL; a member of RESULT; DATA8; an output, in global memory when
               left away
        """

    def set_instr(self, prgid: _SLOT, *, unchecked: bool = False) -> Draft:
        """Sets how many instructions the calling thread may still run in its time slice.

        prgid  program slot; a member of SLOT; DATA16
        """

    def get_prgname(self, prgid: _SLOT, name: _Output = None, *, unchecked: bool = False) -> Draft:
        """Asks for the name of a program.

        prgid  program slot; a member of SLOT; DATA16
        name   name of the program, ended by its zero; string; an output, in global memory when left away
        """

class _UiDraw:
    """UI_DRAW: Draws on the canvas of the display, or runs a dialogue on it."""

    def update(self, *, unchecked: bool = False) -> Draft:
        """Shows on the display what has been drawn, and returns to the normal font."""

    def clean(self, *, unchecked: bool = False) -> Draft:
        """Wipes the canvas white, and returns to the normal font."""

    def pixel(self, color: _Number, x0: _Number, y0: _Number, *, unchecked: bool = False) -> Draft:
        """Draws one pixel.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column; 0 to 177 px; DATA16
        y0     row; 0 to 127 px; DATA16
        """

    def line(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a line between two points.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the start; 0 to 177 px; DATA16
        y0     row of the start; 0 to 127 px; DATA16
        x1     column of the end; 0 to 177 px; DATA16
        y1     row of the end; 0 to 127 px; DATA16
        """

    def circle(self, color: _Number, x0: _Number, y0: _Number, r: _Number, *, unchecked: bool = False) -> Draft:
        """Draws a circle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the centre; 0 to 177 px; DATA16
        y0     row of the centre; 0 to 127 px; DATA16
        r      radius; px; 0: draws nothing; DATA16
        """

    def text(self, color: _Number, x0: _Number, y0: _Number, string: _Text, *, unchecked: bool = False) -> Draft:
        """Draws text in the font that SELECT_FONT has chosen.

        color   colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0      left edge; 0 to 177 px; DATA16
        y0      top edge; 0 to 127 px; DATA16
        string  text to draw; string
        """

    def icon(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        type: _ICONTYPE,
        no: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws one of the built-in icons.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        type   set of icons; a member of ICONTYPE; DATA8
        no     number of the icon in its set; DATA8
        """

    def picture(self, color: _Number, x0: _Number, y0: _Number, ip: _Number, *, unchecked: bool = False) -> Draft:
        """Draws a picture that is in memory.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        ip     address of the picture; 0: draws nothing; DATA32
        """

    def value(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a number, or dashes where it is not a number.

        color     colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0        left edge; 0 to 177 px; DATA16
        y0        top edge; 0 to 127 px; DATA16
        value     number to draw; DATAF
        figures   characters in all, decimal point included; negative aligns left; DATA8
        decimals  digits after the decimal point; DATA8
        """

    def fillrect(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a filled rectangle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        x1     width; 0 to 178 px; DATA16
        y1     height; 0 to 128 px; DATA16
        """

    def rectangle(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws the outline of a rectangle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        x1     width; 0 to 178 px; DATA16
        y1     height; 0 to 128 px; DATA16
        """

    def notification(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        icon1: _L_ICON_NO,
        icon2: _L_ICON_NO,
        icon3: _L_ICON_NO,
        string: _Text,
        state: _Variable,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows icons and text in a window and waits for the centre button.

        color   colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0      left edge; 0 to 177 px; DATA16
        y0      top edge; 0 to 127 px; DATA16
        icon1   first large icon; -1: none; a member of L_ICON_NO; DATA8
        icon2   second large icon; -1: none; a member of L_ICON_NO; DATA8
        icon3   third large icon; -1: none; a member of L_ICON_NO; DATA8
        string  text beside the icons; may be empty; string
        state   variable the dialogue keeps its progress in; set to 0 before; 0 to 1; 0: start, or done, 1:
                being shown; DATA8, a variable that is read and written
        """

    def question(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        icon1: _L_ICON_NO,
        icon2: _L_ICON_NO,
        string: _Text,
        state: _Variable,
        ok: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows icons in a window and waits for yes or no.

        color   colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0      left edge; 0 to 177 px; DATA16
        y0      top edge; 0 to 127 px; DATA16
        icon1   first large icon; -1: none; a member of L_ICON_NO; DATA8
        icon2   second large icon; -1: none; a member of L_ICON_NO; DATA8
        string  text of the question (LEGO's firmware does not show it); string
        state   variable the dialogue keeps its progress in; set to 0 before; 0 to 1; 0: start, or done, 1:
                being shown; DATA8, a variable that is read and written
        ok      answer; what the variable holds before is selected first; -1 to 1; 0: no, 1: yes, -1: left
                with the back button; DATA8; an output, in global memory when left away
        """

    def keyboard(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        icon: _N_ICON_NO,
        length: _Number,
        default: _Text,
        charset: _Variable,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows a keyboard on the display and waits until a text has been entered.

        color    colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0       left edge; 0 to 177 px; DATA16
        y0       top edge; 0 to 127 px; DATA16
        icon     normal icon before the caption; a member of N_ICON_NO; DATA8
        length   most bytes to return, the zero included; 0 to 127 bytes; DATA8
        default  caption above the text, not a preset as its name says; 0: none; string
        charset  variable with the sum of what may be typed; becomes 0 once the keyboard shows; 0: being
                 shown, 1: brick name, 2: file name, 4: Bluetooth PIN, 8: WiFi password, 16: WiFi name;
                 DATA8, a variable that is read and written
        string   text entered; what the variable holds before is edited, back button empties it; string; an
                 output, in global memory when left away
        """

    def browse(
        self,
        type: _BROWSERTYPE,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        length: _Number,
        item_type: _Output = None,
        string: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows files and folders and waits until one is chosen.

        type       what is listed; a member of BROWSERTYPE; DATA8
        x0         left edge; 0 to 177 px; DATA16
        y0         top edge; 0 to 127 px; DATA16
        x1         width; 0 to 178 px; DATA16
        y1         height; 0 to 128 px; DATA16
        length     most bytes to return, the zero included; 0 to 127 bytes; DATA8
        item_type  kind of what was chosen; set the variable to 0 before; a member of FILETYPE; DATA8; an
                   output, in global memory when left away
        string     path of what was chosen; the variable holds the top folder before; string; an output, in
                   global memory when left away
        """

    def vertbar(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        min: _Number,
        max: _Number,
        act: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a vertical scroll bar.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        x1     width; 0 to 178 px; DATA16
        y1     height; 0 to 128 px; DATA16
        min    value at one end of the bar; DATA16
        max    value at the other end of the bar; DATA16
        act    value that the knob shows; DATA16
        """

    def inverserect(self, x0: _Number, y0: _Number, x1: _Number, y1: _Number, *, unchecked: bool = False) -> Draft:
        """Swaps black and white in a rectangle.

        x0  left edge; 0 to 177 px; DATA16
        y0  top edge; 0 to 127 px; DATA16
        x1  width; 0 to 178 px; DATA16
        y1  height; 0 to 128 px; DATA16
        """

    def select_font(self, type: _FONTTYPE, *, unchecked: bool = False) -> Draft:
        """Chooses the font for text until UPDATE, CLEAN or FILLWINDOW.

        type  font; 0 to 3; a member of FONTTYPE; DATA8
        """

    def topline(self, enable: _Number, *, unchecked: bool = False) -> Draft:
        """Switches the status line at the top on or off.

        enable  whether the status line is shown; 0 to 1; 0: disabled, 1: enabled; DATA8
        """

    def fillwindow(self, color: _Number, y0: _Number, y1: _Number, *, unchecked: bool = False) -> Draft:
        """Fills rows over the whole width, and returns to the normal font.

        color  colour to fill with; any other value makes a test pattern; 0: white, 1: black; DATA8
        y0     top edge; 0 to 127 px; DATA16
        y1     height; nothing is filled where Y0 and it make 128 or more; 0 to 127 px; 0: down to the
               bottom; DATA16
        """

    def scroll(self, y: _Number, *, unchecked: bool = False) -> Draft:
        """Moves the canvas up.

        y  how far; 1 to 127 px; DATA16
        """

    def dotline(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        on: _Number,
        off: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a dashed line between two points.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the start; 0 to 177 px; DATA16
        y0     row of the start; 0 to 127 px; DATA16
        x1     column of the end; 0 to 177 px; DATA16
        y1     row of the end; 0 to 127 px; DATA16
        on     length of a dash; px; DATA16
        off    length of a gap; px; DATA16
        """

    def view_value(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a number centred in its place, with > instead of digits where it does not fit.

        color     colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0        left edge; 0 to 177 px; DATA16
        y0        top edge; 0 to 127 px; DATA16
        value     number to draw; DATAF
        figures   characters in all, decimal point included; DATA8
        decimals  digits after the decimal point; DATA8
        """

    def view_unit(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        value: _Real,
        figures: _Number,
        decimals: _Number,
        length: _Number,
        string: _Text,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws a number in large figures and its unit in small letters.

        color     colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0        left edge; 0 to 177 px; DATA16
        y0        top edge; 0 to 127 px; DATA16
        value     number to draw; DATAF
        figures   characters in all, decimal point included; DATA8
        decimals  digits after the decimal point; DATA8
        length    most bytes of the unit, the zero included; 0 to 127 bytes; DATA8
        string    unit to draw behind the number; string
        """

    def fillcircle(self, color: _Number, x0: _Number, y0: _Number, r: _Number, *, unchecked: bool = False) -> Draft:
        """Draws a filled circle.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     column of the centre; 0 to 177 px; DATA16
        y0     row of the centre; 0 to 127 px; DATA16
        r      radius; px; 0: draws nothing; DATA16
        """

    def store(self, no: _Number, *, unchecked: bool = False) -> Draft:
        """Keeps a copy of the canvas.

        no  memory for one screen; 0 holds the one from before the program ran; 0 to 2; DATA8
        """

    def restore(self, no: _Number, *, unchecked: bool = False) -> Draft:
        """Brings back a canvas kept by STORE.

        no  memory for one screen; 0 holds the one from before the program ran; 0 to 2; DATA8
        """

    def icon_question(
        self,
        color: _Number,
        x0: _Number,
        y0: _Number,
        state: _Variable,
        icons: _Variable,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows a row of icons and waits until one is chosen.

        color  colour to draw in; 0 to 1; 0: white, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        state  variable the dialogue keeps its progress in; set to 0 before; 0 to 1; 0: start, or done, 1:
               being shown; DATA8, a variable that is read and written
        icons  bit n stands for large icon n: before those to show, then the one chosen; 0: none: left with
               the back button; DATA32, a variable that is read and written
        """

    def bmpfile(self, color: _Number, x0: _Number, y0: _Number, name: _Text, *, unchecked: bool = False) -> Draft:
        """Draws a picture file in LEGO's own format .rgf (no .bmp despite the name).

        color  colour of the set pixels; 0 to 1; 0: white, picture inverted, 1: black; DATA8
        x0     left edge; 0 to 177 px; DATA16
        y0     top edge; 0 to 127 px; DATA16
        name   file with extension .rgf, absolute or relative to /home/root/lms2012/sys; at most 119
               characters; string
        """

    def popup(self, open: _Number, *, unchecked: bool = False) -> Draft:
        """Opens a window that only its opener draws on, or closes it and brings back the display.

        open  what to do; 0 to 1; 0: close, 1: open; DATA8
        """

    def graph_setup(
        self,
        x0: _Number,
        x1: _Number,
        items: _Number,
        offset: _Elements,
        span: _Elements,
        min: _Elements,
        max: _Elements,
        sample: _Elements,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Sets up a graph of up to 8 curves; their arrays must outlive it, so useless in direct commands.

        x0      left edge; 0 to 177 px; DATA16
        x1      width; 0 to 178 px; DATA16
        items   how many curves; 0 to 8; DATA8
        offset  top edge of each curve; 0 to 127 px; DATA16
        span    height of each curve; 0 to 128 px; DATA16
        min     value at the bottom of each curve; DATAF
        max     value at the top of each curve; DATAF
        sample  present value of each curve, read anew at each GRAPH_SAMPLE; DATAF
        """

    def graph_draw(
        self,
        view: _Number,
        actual: _Output = None,
        lowest: _Output = None,
        highest: _Output = None,
        average: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Draws the graph and measures the curve it shows.

        view     curve to draw, counted from 0; any other value draws all and measures none; -1: all; DATA8
        actual   latest value, not a number where there is none; DATAF; an output, in global memory when
                 left away
        lowest   lowest value in the graph; DATAF; an output, in global memory when left away
        highest  highest value in the graph; DATAF; an output, in global memory when left away
        average  mean of the values in the graph; DATAF; an output, in global memory when left away
        """

    def textbox(
        self,
        x0: _Number,
        y0: _Number,
        x1: _Number,
        y1: _Number,
        text: _Text,
        size: _Number,
        del_: _DEL,
        line: _Variable,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Shows a text with a scroll bar and waits until a line is chosen.

        x0    left edge; 0 to 177 px; DATA16
        y0    top edge; 0 to 127 px; DATA16
        x1    width; 0 to 178 px; DATA16
        y1    height; 0 to 128 px; DATA16
        text  whole text of the box, its lines separated by DEL; string
        size  bytes that the box has for its text, the zero included; bytes; DATA32
        del_  what separates the lines; a member of DEL; DATA8
        line  variable, set to -1 before; then the line chosen, counted from 1; -1: start, or left with the
              back button, 0: being shown; DATA16, a variable that is read and written
        """

class _Array:
    """ARRAY: Makes, fills, copies and resizes arrays."""

    def destroy(self, handle: _Number, *, unchecked: bool = False) -> Draft:
        """Deletes an array and gives its handle back (LEGO's name for it is DELETE).

        handle  the array; handle
        """

    def create8(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATA8 elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def create16(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATA16 elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def create32(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATA32 elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def createf(self, elements: _Number, handle: _Output = None, *, unchecked: bool = False) -> Draft:
        """Creates an array of DATAF elements.

        elements  how many elements it has at first; 0 to 2147483647; DATA32
        handle    what names the array from now on; handle; an output, in global memory when left away
        """

    def resize(self, handle: _Number, elements: _Number, *, unchecked: bool = False) -> Draft:
        """Changes how many elements an array has.

        handle    the array; handle
        elements  how many elements it has from now on; 0 to 2147483647; DATA32
        """

    def fill(self, handle: _Number, value: _Real, *, unchecked: bool = False) -> Draft:
        """Sets every element of an array to one value.

        handle  the array; handle
        value   the value, of the array's type; array-typed
        """

    def copy(self, hsource: _Number, hdest: _Number, *, unchecked: bool = False) -> Draft:
        """Copies the content of one array into another of the same type, which takes its size.

        hsource  array to copy from; handle
        hdest    array to copy into, which has to exist; handle
        """

    @overload
    def init8(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Number],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA8 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA8
        """

    @overload
    def init8(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Number],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA8 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA8
        """

    @overload
    def init16(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Number],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA16 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA16
        """

    @overload
    def init16(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Number],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA16 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA16
        """

    @overload
    def init32(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Number],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA32 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA32
        """

    @overload
    def init32(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Number],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATA32 array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATA32
        """

    @overload
    def initf(
        self,
        handle: _Number,
        index: _Number,
        elements: _Number | None,
        values: Sequence[_Real],
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATAF array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATAF
        """

    @overload
    def initf(
        self,
        handle: _Number,
        index: _Number,
        *,
        elements: _Number | None = None,
        values: Sequence[_Real],
        unchecked: bool = False,
    ) -> Draft:
        """Writes several elements of a DATAF array, all within its size.

        handle    the array; handle
        index     first element to write, counted from 0; 0 to 2147483647; DATA32
        elements  how many values follow; 0 to 2147483647; DATA32; worked out when left away
        values    the values, one parameter each; a list of DATAF
        """

    def set_size(self, handle: _Number, elements: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many elements an array has (LEGO's name for it is SIZE).

        handle    the array; handle
        elements  how many elements it has, 0 where there is no such array; DATA32; an output, in global
                  memory when left away
        """

    def read_content(
        self,
        prgid: _SLOT,
        handle: _Number,
        index: _Number,
        bytes: _Number,
        array: _Output = None,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Reads an array's content as bytes, of another program too.

        prgid   slot of the program that owns the array; a member of SLOT; DATA16
        handle  the array; handle
        index   first byte in the array's content, whatever its elements; 0 to 2147483647; DATA32
        bytes   how many bytes; 0 to 2147483647 bytes; DATA32
        array   the bytes, zeros beyond the end of the array; DATA8; an output, in global memory when left
                away
        """

    def write_content(
        self,
        prgid: _SLOT,
        handle: _Number,
        index: _Number,
        bytes: _Number,
        array: _Elements,
        *,
        unchecked: bool = False,
    ) -> Draft:
        """Writes an array's content as bytes; the array then ends with them.

        prgid   slot of the program that owns the array; a member of SLOT; DATA16
        handle  the array; handle
        index   first byte in the array's content, whatever its elements; 0 to 2147483647; DATA32
        bytes   how many bytes; 0 to 2147483647 bytes; DATA32
        array   the bytes; DATA8
        """

    def read_size(self, prgid: _SLOT, handle: _Number, bytes: _Output = None, *, unchecked: bool = False) -> Draft:
        """Tells how many bytes an array's content has, of another program too.

        prgid   slot of the program that owns the array; a member of SLOT; DATA16
        handle  the array; handle
        bytes   how many bytes, 0 where there is no such array; bytes; DATA32; an output, in global memory
                when left away
        """

program_info: _ProgramInfo
ui_draw: _UiDraw
array: _Array

def dynload_vmload(vmindex: _Number, result: _Output = None, *, unchecked: bool = False) -> Draft:
    """Loads an additional virtual machine; fails while another one is loaded.

    vmindex  which one; 0 to 1; 0: RobotC, 1: LabVIEW; DATA8
    result   OK or FAIL; a member of RESULT; DATA8; an output, in global memory when left away
    """

def dynload_vmexit(*, unchecked: bool = False) -> Draft:
    """Unloads the additional virtual machine."""

def dynload_entry_0(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 0 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_1(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 1 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_2(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 2 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_3(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 3 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_4(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 4 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_5(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 5 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_6(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 6 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_7(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 7 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_8(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 8 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_entry_9(
    cmd: _Number,
    length_in: _Number,
    length_out: _Output = None,
    value: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 9 of the additional virtual machine that is loaded.

    cmd         function to call, as that machine numbers them; DATA8
    length_in   how much data is handed over; DATA8
    length_out  how many elements came back; DATA16; an output, in global memory when left away
    value       what came back; the type depends on CMD; array-typed; an output, in global memory when
                left away
    """

def dynload_get_vm(result: _Output = None, *, unchecked: bool = False) -> Draft:
    """Asks which additional virtual machine is loaded.

    result  which one; 0 to 1; -1: none, 0: RobotC, 1: LabVIEW; DATA8; an output, in global memory when
            left away
    """

def input_set_conn(layer: _Number, no: _Number, conn: _CONN, *, unchecked: bool = False) -> Draft:
    """Sets how a port is connected, for ports whose automatic detection is off.

    layer  brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no     sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
    conn   CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE; a member of CONN; DATA8
    """

def input_iic_read(
    layer: _Number,
    no: _Number,
    rdlng: _Number,
    rddata: _Output = None,
    result: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE.

    layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no      sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
    rdlng   how many bytes to read; 0 to 32 bytes; DATA8
    rddata  bytes read; DATA8; an output, in global memory when left away
    result  OK or FAIL; a member of RESULT; DATA8; an output, in global memory when left away
    """

def input_iic_status(layer: _Number, no: _Number, result: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells the state of the I2C bus of a port.

    layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no      sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
    result  state of the bus; a member of RESULT; DATA8; an output, in global memory when left away
    """

def input_iic_write(
    layer: _Number,
    no: _Number,
    wrlng: _Number,
    wrdata: _Elements,
    rdlng: _Number,
    result: _Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sends bytes to an I2C sensor once and does not wait for its answer.

    layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no      sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
    wrlng   how many bytes to write; 0 to 32 bytes; DATA8
    wrdata  bytes to write: I2C address, register, data; DATA8
    rdlng   how many bytes the sensor will answer; 0 to 32 bytes; DATA8
    result  state of the bus after the request; a member of RESULT; DATA8; an output, in global memory
            when left away
    """

def input_set_autoid(layer: _Number, no: _Number, enable: _Number, *, unchecked: bool = False) -> Draft:
    """Switches the automatic detection of sensors at a port on or off.

    layer   brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8
    no      sensor port, counted from 0; 0 to 3; 0: port 1, 1: port 2, 2: port 3, 3: port 4; DATA8
    enable  whether to detect; 0 to 1; 0: off, 1: on; DATA8
    """

def file_md5sum(name: _Text, md5sum: _Output = None, success: _Output = None, *, unchecked: bool = False) -> Draft:
    """Computes the MD5 digest of a file.

    name     path of the file; string
    md5sum   the digest, as 16 bytes; DATA8; an output, in global memory when left away
    success  whether the file could be read; 0: no, 1: yes; DATA8; an output, in global memory when left
             away
    """

def mailbox_size(no: _Number, size: _Output = None, *, unchecked: bool = False) -> Draft:
    """Tells how many bytes the content of a mailbox has.

    no    number of the mailbox on this brick; 0 to 29; DATA8
    size  size of the content; bytes; DATA8; an output, in global memory when left away
    """

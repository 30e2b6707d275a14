"""The errors that the firmware logs, by number: as INFO.GET_ERROR returns them and INFO.ERRORTEXT spells them."""

ERRORS: tuple[str, ...] = (
    "TOO_MANY_ERRORS_TO_BUFFER",
    "TYPEDATA_TABEL_FULL",
    "TYPEDATA_FILE_NOT_FOUND",
    "ANALOG_DEVICE_FILE_NOT_FOUND",
    "ANALOG_SHARED_MEMORY",
    "UART_DEVICE_FILE_NOT_FOUND",
    "UART_SHARED_MEMORY",
    "IIC_DEVICE_FILE_NOT_FOUND",
    "IIC_SHARED_MEMORY",
    "DISPLAY_SHARED_MEMORY",
    "UI_SHARED_MEMORY",
    "UI_DEVICE_FILE_NOT_FOUND",
    "LCD_DEVICE_FILE_NOT_FOUND",
    "OUTPUT_SHARED_MEMORY",
    "COM_COULD_NOT_OPEN_FILE",
    "COM_NAME_TOO_SHORT",
    "COM_NAME_TOO_LONG",
    "COM_INTERNAL",
    "VM_INTERNAL",
    "VM_PROGRAM_VALIDATION",
    "VM_PROGRAM_NOT_STARTED",
    "VM_PROGRAM_FAIL_BREAK",
    "VM_PROGRAM_INSTRUCTION_BREAK",
    "VM_PROGRAM_NOT_FOUND",
    "SOUND_DEVICE_FILE_NOT_FOUND",
    "SOUND_SHARED_MEMORY",
    "FILE_OPEN_ERROR",
    "FILE_READ_ERROR",
    "FILE_WRITE_ERROR",
    "FILE_CLOSE_ERROR",
    "FILE_GET_HANDLE_ERROR",
    "FILE_NAME_ERROR",
    "USB_SHARED_MEMORY",
    "OUT_OF_MEMORY",
)
"""By number. Number 0 is shown as an empty text."""

ERROR_NUMBERS: dict[str, int] = {name: number for number, name in enumerate(ERRORS)}
"""The numbers by name."""

LOGGED = 7
"""Capacity of the log, in errors; further ones are dropped."""

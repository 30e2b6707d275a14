"""The firmware's plain numbers and names: sizes, limits, folders, file names, extensions, positions on the display.

Plain constants, since no operation refers to them. Checks, texts and exports share them from here;
the names are the firmware's, without the `vm` prefix of its headers.
"""

CONSTANTS: dict[str, int | str] = {
    # Hardware: ports, buttons and lights of one brick
    "OUTPUTS": 4,
    "INPUTS": 4,
    "BUTTONS": 6,
    "LEDS": 4,
    # Display: pixels, places to store it, colours
    "LCD_WIDTH": 178,
    "LCD_HEIGHT": 128,
    "TOPLINE_HEIGHT": 10,
    "LCD_STORE_LEVELS": 3,
    "FG_COLOR": 1,
    "BG_COLOR": 0,
    # Settings of a brick without stored ones: percent, minutes
    "DEFAULT_VOLUME": 100,
    "DEFAULT_SLEEPMINUTES": 30,
    # Bricks in a daisy chain, the first one included
    "CHAIN_DEPT": 4,
    # Size of string buffers, in bytes, including the zero
    "PATHSIZE": 84,
    "NAMESIZE": 32,
    "EXTSIZE": 5,
    "FILENAMESIZE": 120,
    "MACSIZE": 18,
    "IPSIZE": 16,
    "BTADRSIZE": 13,
    "ERR_STRING_SIZE": 32,
    "BRICKNAMESIZE": 120,
    "BTPASSKEYSIZE": 7,
    "WIFIPASSKEYSIZE": 33,
    # Communication events that wait for the user
    "EVENT_NONE": 0,
    "EVENT_BT_PIN": 1,
    "EVENT_BT_REQ_CONF": 2,
    # The highest number of a device type that a sensor may claim
    "MAX_VALID_TYPE": 101,
    # Folders, most of them relative to /home/root/lms2012/sys, and the limit of entries kept
    "MEMORY_FOLDER": "/mnt/ramdisk",
    "PROGRAM_FOLDER": "../prjs/BrkProg_SAVE",
    "DATALOG_FOLDER": "../prjs/BrkDL_SAVE",
    "SDCARD_FOLDER": "../prjs/SD_Card",
    "USBSTICK_FOLDER": "../prjs/USB_Stick",
    "PRJS_DIR": "../prjs",
    "APPS_DIR": "../apps",
    "TOOLS_DIR": "../tools",
    "TMP_DIR": "../tmp",
    "SETTINGS_DIR": "../sys/settings",
    "DIR_DEEPT": 127,
    # Files that hold settings, without their extension
    "LASTRUN_FILE_NAME": "lastrun",
    "CALDATA_FILE_NAME": "caldata",
    "SLEEP_FILE_NAME": "Sleep",
    "VOLUME_FILE_NAME": "Volume",
    "WIFI_FILE_NAME": "WiFi",
    "BLUETOOTH_FILE_NAME": "Bluetooth",
    # Extensions of file names
    "EXT_SOUND": ".rsf",
    "EXT_GRAPHICS": ".rgf",
    "EXT_BYTECODE": ".rbf",
    "EXT_TEXT": ".rtf",
    "EXT_DATALOG": ".rdf",
    "EXT_PROGRAM": ".rpf",
    "EXT_CONFIG": ".rcf",
    "EXT_ARCHIVE": ".raf",
    # Sets of allowed characters, one bit each
    "CHARSET_NAME": 0x01,
    "CHARSET_FILENAME": 0x02,
    "CHARSET_BTPASSKEY": 0x04,
    "CHARSET_WIFIPASSKEY": 0x08,
    "CHARSET_WIFISSID": 0x10,
    # Smallest and largest values of the types
    "DATA8_MIN": -127,
    "DATA8_MAX": 127,
    "DATA16_MIN": -32767,
    "DATA16_MAX": 32767,
    "DATA32_MIN": -2147483647,
    "DATA32_MAX": 2147483647,
    "DATAF_MIN": -2147483647,
    "DATAF_MAX": 2147483647,
    # "Not a number" of the types, as unsigned bit patterns
    "DATA8_NAN": 0x80,
    "DATA16_NAN": 0x8000,
    "DATA32_NAN": 0x80000000,
    "DATAF_NAN": 0x7FC00000,
    # Activity of the user interface, one bit each; shown by debug builds of the firmware
    "PULSE_GUI_BACKGROUND": 1,
    "PULSE_BROWSER": 2,
    "PULSE_KEY": 4,
    # Pixel positions of a pop-up window and of the parts of a warning in it
    "POP3_ABS_X": 16,
    "POP3_ABS_Y": 50,
    "POP3_ABS_WARN_ICON_X": 64,
    "POP3_ABS_WARN_ICON_X1": 40,
    "POP3_ABS_WARN_ICON_X2": 72,
    "POP3_ABS_WARN_ICON_X3": 104,
    "POP3_ABS_WARN_ICON_Y": 60,
    "POP3_ABS_WARN_SPEC_ICON_X": 88,
    "POP3_ABS_WARN_SPEC_ICON_Y": 60,
    "POP3_ABS_WARN_TEXT_X": 80,
    "POP3_ABS_WARN_TEXT_Y": 68,
    "POP3_ABS_WARN_YES_X": 72,
    "POP3_ABS_WARN_YES_Y": 90,
    "POP3_ABS_WARN_LINE_X": 21,
    "POP3_ABS_WARN_LINE_Y": 89,
    "POP3_ABS_WARN_LINE_ENDX": 155,
}

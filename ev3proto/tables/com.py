"""Operations on Bluetooth, WiFi and USB, and on the mailboxes through which bricks talk to each other.

Names are zero-terminated strings here, though the firmware's own tables show their first byte only.
"""

from ev3proto.tables.declaration import (
    ARRAY_TYPED,
    DATA8,
    DATA16,
    DATA32,
    EXTENSIONS,
    STRING,
    Command,
    Count,
    Direction,
    Effect,
    In,
    Opcode,
    Out,
)
from ev3proto.tables.enumerations import BTTYPE, DATA_FORMAT, ENCRYPT, FILETYPE, HWTYPE, RESULT
from ev3proto.tables.mailboxes import MOST_CONTENT, MOST_NAME

FIRST_BYTE = "a zero-terminated string, whose first byte other tables show as DATA8"
WRITTEN = "written by the firmware, though other tables call it an input"

OFF_ON = {0: "off", 1: "on"}
NO_YES = {0: "no", 1: "yes"}
READY_BUSY = {0: "ready", 1: "busy"}

HARDWARE = In("HARDWARE", DATA8, "carrier to use", enum=HWTYPE)
USB, BLUETOOTH, WIFI = HWTYPE.members.values()
# An operation fails for hardware that lacks the property.
ANY_HARDWARE = HARDWARE._replace(range=(USB, WIFI))
RADIO = HARDWARE._replace(range=(BLUETOOTH, WIFI))
BLUETOOTH_ONLY = HARDWARE._replace(range=(BLUETOOTH, BLUETOOTH))
WIFI_ONLY = HARDWARE._replace(range=(WIFI, WIFI))
NAME_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-"
ITEM = In("ITEM", DATA8, "place in the list, counted from 0")
ITEMS = Out("ITEMS", DATA8, "number of entries in the list")
LENGTH = In(
    "LENGTH",
    DATA8,
    "size of the text buffer, including the zero",
    unit="bytes",
    special={-1: "unlimited (handles only)"},
)
NAME = In("NAME", STRING, "name of the other device or network")
NAME_OUT = Out("NAME", STRING, "name of the other device or network", length="LENGTH")
NAME_TO_TEST = In("NAME", STRING, "name of the other device, empty: the brick's own adapter", note=FIRST_BYTE)
PAIRED = Out("PAIRED", DATA8, "whether it is paired (Bluetooth) or known (WiFi)", range=(0, 1), special=NO_YES)
CONNECTED = Out("CONNECTED", DATA8, "whether it is connected", range=(0, 1), special=NO_YES)
LIST_TYPE = Out(
    "TYPE",
    DATA8,
    "kind of device (Bluetooth) or encryption (WiFi)",
    enum=BTTYPE,
    special={0: "WiFi, not encrypted", 1: "WiFi, WPA2"},
)
IS_ACTIVE = Out("ACTIVE", DATA8, "whether it is on", range=(0, 1), special=OFF_ON)
ACTIVE = In("ACTIVE", DATA8, "whether to switch it on", range=(0, 1), special=OFF_ON)
BOX_NO = In("NO", DATA8, "number of the mailbox on this brick", range=(0, 29))
BOX_NAME = In("BOXNAME", STRING, "name of the mailbox", note=FIRST_BYTE, most=MOST_NAME + 1)
REMOTE_NAME = In("REMOTE_NAME", STRING, "name of the other device or network")
# The firmware reads these four and ignores them; their names are as vague.
UNUSED = (
    In("VALUE1", DATA8, "carrier, ignored", enum=HWTYPE),
    In("VALUE2", DATA8, "name of the other device, ignored"),
    In("VALUE3", DATA16, "number of bytes, ignored", unit="bytes"),
    In("VALUE4", DATA8, "the bytes, ignored"),
)

COM = (
    Opcode(
        0x91,
        "COM_READ",
        "Fetches direct commands, for the brick's own command program",
        commands=(
            Command(
                14,
                "COMMAND",
                "Returns the address of the last direct command received",
                (
                    In("LENGTH", DATA32, "maximum number of bytes of code, ignored by the firmware", unit="bytes"),
                    Out("IMAGE", DATA32, "address of the code"),
                    Out("GLOBAL", DATA32, "address of its global memory"),
                    Out("FLAG", DATA8, "whether one is waiting", range=(0, 1), special={0: "none", 1: "ready to run"}),
                ),
                effects=(Effect.VARIES,),
            ),
        ),
    ),
    Opcode(
        0x92,
        "COM_WRITE",
        "Answers direct commands, for the brick's own command program",
        commands=(
            Command(
                14,
                "REPLY",
                "Sends the global memory of a direct command that has run as its reply",
                (
                    In("IMAGE", DATA32, "address of the code"),
                    In("GLOBAL", DATA32, "address of its global memory"),
                    In("STATUS", DATA8, "how it ended; all but OK give DIRECT_REPLY_ERROR", enum=RESULT),
                ),
            ),
        ),
    ),
    Opcode(
        0xD0,
        "COM_READY",
        "Waits until nothing is being sent to a device",
        (HARDWARE, NAME_TO_TEST),
        effects=(Effect.WAITS, Effect.COMPUTES),
    ),
    Opcode(
        0xD1,
        "COM_READDATA",
        "Does nothing in the firmware; meant to receive data",
        UNUSED,
        effects=(Effect.FAILS, Effect.COMPUTES),
    ),
    Opcode(
        0xD2,
        "COM_WRITEDATA",
        "Does nothing in the firmware; meant to send data",
        UNUSED,
        effects=(Effect.FAILS, Effect.COMPUTES),
    ),
    Opcode(
        0xD3,
        "COM_GET",
        "Asks about the brick's connections and the devices around it",
        commands=(
            Command(
                1,
                "GET_ON_OFF",
                "Reports whether Bluetooth or WiFi is on",
                (RADIO, IS_ACTIVE),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                2,
                "GET_VISIBLE",
                "Reports whether other devices can see the brick by Bluetooth",
                (ANY_HARDWARE, Out("VISIBLE", DATA8, "whether it is visible", range=(0, 1), special=NO_YES)),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                4,
                "GET_RESULT",
                "Reports the state of a search or connection request",
                (
                    RADIO,
                    In("ITEM", DATA8, "place in the list, ignored by the firmware"),
                    Out("RESULT", DATA8, "state of the request", enum=RESULT),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                5,
                "GET_PIN",
                "Reads the PIN for a device, always 1234",
                (
                    HARDWARE,
                    NAME,
                    In("LENGTH", DATA8, "size of the PIN's buffer, including the zero", unit="bytes"),
                    Out("PINCODE", STRING, "the PIN", length="LENGTH"),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
                words="pairing",
            ),
            Command(
                7,
                "LIST_STATE",
                "Reads a counter that changes when a device enters or leaves a list",
                (HARDWARE, Out("STATE", DATA16, "number to compare with the one of the last call")),
                dialects=("compat",),
                effects=(Effect.COMPUTES,),
            ),
            Command(
                8,
                "SEARCH_ITEMS",
                "Counts the devices or networks that a search found",
                (RADIO, ITEMS),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                9,
                "SEARCH_ITEM",
                "Describes one device or network that a search found",
                (
                    HARDWARE,
                    ITEM,
                    LENGTH,
                    NAME_OUT,
                    PAIRED,
                    CONNECTED,
                    LIST_TYPE,
                    Out("VISIBLE", DATA8, "whether it is in range", range=(0, 1), special=NO_YES),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                10,
                "FAVOUR_ITEMS",
                "Counts the paired devices, in range or not",
                (BLUETOOTH_ONLY, ITEMS),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                11,
                "FAVOUR_ITEM",
                "Describes one paired device or known network",
                (HARDWARE, ITEM, LENGTH, NAME_OUT, PAIRED, CONNECTED, LIST_TYPE),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                12,
                "GET_ID",
                "Reads the brick's Bluetooth address",
                (BLUETOOTH_ONLY, LENGTH, Out("STRING", STRING, "12 hex digits", length="LENGTH")),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                13,
                "GET_BRICKNAME",
                "Reads the brick's name",
                (LENGTH, Out("NAME", STRING, "name of the brick", length="LENGTH")),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                14,
                "GET_NETWORK",
                "Reads network name and addresses, WiFi only",
                (
                    HARDWARE,
                    In(
                        "LENGTH",
                        DATA8,
                        "buffer size for each of the three texts, including the zero",
                        unit="bytes",
                        special={-1: "unlimited (handles only)"},
                    ),
                    Out("NAME", STRING, "name of the network, NONE without one", length="LENGTH"),
                    Out("MAC", STRING, "MAC address of the brick, ?? when WiFi is off", length="LENGTH", most=18),
                    Out("IP", STRING, "IP address of the brick, ?? when not connected", length="LENGTH", most=16),
                ),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                15,
                "GET_PRESENT",
                "Reports whether the hardware is present (for WiFi: a known dongle)",
                (HARDWARE, Out("OK", DATA8, "whether it is present", range=(0, 1), special=NO_YES)),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                16,
                "GET_ENCRYPT",
                "Reports the encryption of a network, WiFi only",
                (
                    WIFI_ONLY,
                    ITEM,
                    Out("TYPE", DATA8, "kind of encryption; always none in the 2013 firmware", enum=ENCRYPT),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                17,
                "CONNEC_ITEMS",
                "Counts the connected devices, Bluetooth only",
                (ANY_HARDWARE, ITEMS),
                effects=(Effect.VARIES, Effect.READS),
            ),
            Command(
                18,
                "CONNEC_ITEM",
                "Describes one connected device, Bluetooth only",
                (
                    HARDWARE,
                    ITEM,
                    LENGTH,
                    Out("NAME", STRING, "name of the device", length="LENGTH", note=f"{FIRST_BYTE}; {WRITTEN}"),
                    Out("TYPE", DATA8, "kind of device", enum=BTTYPE),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                19,
                "GET_INCOMING",
                "Reports which device asks for a connection, Bluetooth only",
                (
                    BLUETOOTH_ONLY,
                    LENGTH,
                    Out("NAME", STRING, "name of the device", length="LENGTH", note=WRITTEN),
                    Out(
                        "TYPE",
                        DATA8,
                        "kind of device",
                        enum=BTTYPE,
                        note="a kind of Bluetooth device; other tables give the names of encryptions",
                    ),
                ),
                effects=(Effect.VARIES, Effect.COMPUTES),
            ),
            Command(
                20,
                "GET_MODE2",
                "Reports whether Bluetooth is in its mode for Apple devices",
                (BLUETOOTH_ONLY, IS_ACTIVE),
                effects=(Effect.VARIES, Effect.READS),
            ),
        ),
    ),
    Opcode(
        0xD4,
        "COM_SET",
        "Changes the brick's name, its connections and its lists of devices",
        commands=(
            Command(
                1,
                "SET_ON_OFF",
                "Switches Bluetooth or WiFi on or off",
                (RADIO, ACTIVE),
                effects=(Effect.CHANGES_SETTINGS,),
                words="enable disable",
            ),
            Command(
                2,
                "SET_VISIBLE",
                "Makes the brick visible or invisible, Bluetooth only",
                (
                    HARDWARE,
                    In(
                        "VISIBLE",
                        DATA8,
                        "whether other devices can see it",
                        range=(0, 1),
                        special={0: "invisible", 1: "visible"},
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
                words="discoverable pairing",
            ),
            Command(
                3,
                "SET_SEARCH",
                "Starts or stops the search for devices or networks",
                (
                    RADIO,
                    In(
                        "SEARCH",
                        DATA8,
                        "whether to search",
                        range=(0, 1),
                        special={0: "stop (Bluetooth only)", 1: "start"},
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
                words="scan",
            ),
            Command(
                5,
                "SET_PIN",
                "Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi)",
                (RADIO, NAME, In("PINCODE", STRING, "PIN or password")),
                effects=(Effect.CHANGES_SETTINGS,),
                words="pairing password",
            ),
            Command(
                6,
                "SET_PASSKEY",
                "Answers the request to confirm a passkey, Bluetooth only",
                (
                    BLUETOOTH_ONLY,
                    In("ACCEPT", DATA8, "the answer", range=(0, 1), special={0: "reject", 1: "accept"}),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                7,
                "SET_CONNECTION",
                "Connects a device or network, or ends a Bluetooth connection",
                (
                    RADIO,
                    NAME,
                    In(
                        "CONNECTION",
                        DATA8,
                        "what to do",
                        range=(0, 1),
                        special={0: "disconnect", 1: "connect"},
                    ),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
                words="connect pairing",
            ),
            Command(
                8,
                "SET_BRICKNAME",
                "Renames the brick",
                (In("NAME", STRING, "new name, at most 118 characters, else refused", most=119, letters=NAME_LETTERS),),
                effects=(Effect.RENAMES, Effect.CHANGES_SETTINGS),
                sentence="renames the brick to {NAME}",
                words="rename",
            ),
            Command(
                9,
                "SET_MOVEUP",
                "Moves a network up in the list, WiFi only",
                (WIFI_ONLY, ITEM),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                10,
                "SET_MOVEDOWN",
                "Moves a network down in the list, WiFi only",
                (WIFI_ONLY, ITEM),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                11,
                "SET_ENCRYPT",
                "Sets the encryption of a network, WiFi only",
                (
                    WIFI_ONLY,
                    In(
                        "ITEM",
                        STRING,
                        "name of the network",
                        note="the firmware reads a name; other tables say a place in the list, DATA8",
                    ),
                    In("ENCRYPT", DATA8, "kind of encryption", enum=ENCRYPT),
                ),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                12,
                "SET_SSID",
                "Adds a network to the end of the list, WiFi only",
                (WIFI_ONLY, In("NAME", STRING, "name of the network")),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
            Command(
                13,
                "SET_MODE2",
                "Switches the Bluetooth mode for Apple devices on or off",
                (BLUETOOTH_ONLY, ACTIVE),
                effects=(Effect.CHANGES_SETTINGS,),
            ),
        ),
    ),
    Opcode(
        0xD5,
        "COM_TEST",
        "Reports whether something is still being sent to a device",
        (
            HARDWARE,
            NAME_TO_TEST,
            Out("BUSY", DATA8, "whether to wait", range=(0, 1), special=READY_BUSY),
        ),
        effects=(Effect.VARIES, Effect.COMPUTES),
    ),
    Opcode(
        0xD6,
        "COM_REMOVE",
        "Forgets a paired device or a known network",
        (HARDWARE, REMOTE_NAME),
        effects=(Effect.CHANGES_SETTINGS,),
    ),
    Opcode(
        0xD7,
        "COM_WRITEFILE",
        "Sends a file or a folder to another brick, Bluetooth only",
        (
            HARDWARE,
            REMOTE_NAME,
            In("FILE_NAME", STRING, "path of the file or folder on this brick"),
            In("FILE_TYPE", DATA8, "TYPE_FOLDER for a folder, else a file", enum=FILETYPE),
        ),
        effects=(Effect.WRITES_FILES,),
    ),
    Opcode(
        0xD8,
        "MAILBOX_OPEN",
        f"Opens a mailbox on this brick, at most {MOST_CONTENT} bytes of content",
        (
            BOX_NO,
            BOX_NAME,
            In("TYPES", DATA8, "type of its values", enum=DATA_FORMAT),
            In("FIFOSIZE", DATA8, "depth of the queue, ignored by the firmware"),
            In("VALUES", DATA8, "number of values, ignored by the firmware"),
        ),
        effects=(Effect.USES_MAILBOXES,),
    ),
    Opcode(
        0xD9,
        "MAILBOX_WRITE",
        "Sends values to a mailbox of another brick, Bluetooth only",
        (
            In("BRICKNAME", STRING, "name of the other brick, empty: all connected ones", note=FIRST_BYTE),
            In(
                "HARDWARE",
                DATA8,
                "read by the firmware and never used",
                enum=HWTYPE,
                special={0: "as compilers write"},
            ),
            BOX_NAME,
            In("TYPE", DATA8, "type of the values", enum=DATA_FORMAT),
            Count(
                "VALUES",
                f"number of values of TYPE follow; exactly one for a string, of at most {MOST_CONTENT - 1} characters",
                "TYPE",
                each="value of TYPE",
                most=MOST_CONTENT,
            ),
        ),
        effects=(Effect.SENDS_MESSAGES,),
    ),
    Opcode(
        0xDA,
        "MAILBOX_READ",
        "Reads the content of a mailbox and marks it read",
        (
            BOX_NO,
            In("LENGTH", DATA8, "maximum number of bytes to read, ignored by the firmware", unit="bytes"),
            Count(
                "VALUES",
                "number of values that follow, in the type of MAILBOX_OPEN",
                ARRAY_TYPED,
                Direction.OUT,
                each="value",
            ),
        ),
        effects=(Effect.VARIES, Effect.USES_MAILBOXES),
    ),
    Opcode(
        0xDB,
        "MAILBOX_TEST",
        "Reports whether a mailbox has an unread message",
        (
            BOX_NO,
            Out(
                "BUSY",
                DATA8,
                "whether to wait",
                range=(0, 1),
                special={0: "a new message is there", 1: "nothing new"},
            ),
        ),
        effects=(Effect.VARIES, Effect.USES_MAILBOXES),
    ),
    Opcode(
        0xDC,
        "MAILBOX_READY",
        "Waits for an unread message in a mailbox",
        (BOX_NO,),
        effects=(Effect.WAITS, Effect.USES_MAILBOXES),
        sentence="waits for a message in mailbox {NO}",
    ),
    Opcode(0xDD, "MAILBOX_CLOSE", "Closes a mailbox on this brick", (BOX_NO,), effects=(Effect.USES_MAILBOXES,)),
    Opcode(
        0xE5,
        "MAILBOX_SIZE",
        "Returns the size of a mailbox's content",
        (BOX_NO, Out("SIZE", DATA8, "size of the content", unit="bytes")),
        dialects=EXTENSIONS,
        effects=(Effect.USES_MAILBOXES,),
    ),
)

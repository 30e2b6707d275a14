"""The speaker: tones, sound files, waiting for their end. It plays one sound at a time; the next one interrupts it."""

from ev3proto.tables import paths
from ev3proto.tables.declaration import DATA8, DATA16, STRING, Command, Effect, In, Opcode, Out

VOLUME = In("VOLUME", DATA8, "volume", range=(0, 100), unit="%", special={0: "silent"})
NAME = In(
    "NAME",
    STRING,
    "sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys",
    most=paths.WHOLE,
    suffix=".rsf",
)

FILE_NOTE = (
    "a file that is missing or empty is silent, and keeps the brick playing until BREAK or another sound has ended; all"
    " files are played at 8000 samples a second"
)

OWN_FOLDERS = ("./ui/", "ui/", "../sys/ui/", "/home/root/lms2012/sys/ui/")
"""Beginnings of the names of the sounds that are on every brick."""

SOUND = (
    Opcode(
        0x94,
        "SOUND",
        "Plays or stops a sound",
        commands=(
            Command(
                0,
                "BREAK",
                "Stops the tone or file that is playing",
                effects=(Effect.ENDS_SOUND,),
                words="stop silence mute",
            ),
            Command(
                1,
                "TONE",
                "Plays one tone and returns at once",
                (
                    VOLUME,
                    In(
                        "FREQUENCY",
                        DATA16,
                        "pitch; the driver clamps it to the range",
                        range=(250, 10000),
                        unit="Hz",
                    ),
                    In(
                        "DURATION",
                        DATA16,
                        "duration, read unsigned (-1 is 65535)",
                        unit="ms",
                        special={0: "until BREAK or the next sound"},
                        unsigned=True,
                    ),
                ),
                effects=(Effect.STARTS_SOUND,),
                sentence="plays {FREQUENCY}[ for {DURATION}|, {DURATION}][ at volume {VOLUME}|, {VOLUME}]",
                words="beep note melody music",
            ),
            Command(
                2,
                "PLAY",
                "Plays a sound file once and returns at once",
                (VOLUME, NAME),
                effects=(Effect.STARTS_SOUND,),
                note=FILE_NOTE,
                sentence="plays the sound file {NAME} once[ at volume {VOLUME}|, {VOLUME}]",
                words="music wav",
            ),
            Command(
                3,
                "REPEAT",
                "Plays a sound file over and over until BREAK and returns at once",
                (VOLUME, NAME),
                effects=(Effect.STARTS_SOUND,),
                note=FILE_NOTE,
                sentence="plays the sound file {NAME} over and over[ at volume {VOLUME}|, {VOLUME}]",
            ),
            Command(
                4,
                "SERVICE",
                "Does nothing; the number is used inside the firmware to feed the sound driver",
                effects=(Effect.COMPUTES,),
            ),
        ),
    ),
    Opcode(
        0x95,
        "SOUND_TEST",
        "Reports whether a sound is playing",
        (Out("BUSY", DATA8, "whether a sound is playing", range=(0, 1), special={0: "ready", 1: "busy"}),),
        effects=(Effect.WAITS, Effect.VARIES, Effect.READS),
    ),
    Opcode(
        0x96,
        "SOUND_READY",
        "Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file)",
        effects=(Effect.WAITS, Effect.AWAITS_SOUND, Effect.COMPUTES),
        sentence="waits until the sound has ended",
    ),
)

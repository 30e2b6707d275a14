"""The clocks: waiting for a while, and reading the time that has passed."""

from ev3proto.tables.declaration import DATA32, Effect, In, Opcode, Out

TIMER = (
    Opcode(
        0x85,
        "TIMER_WAIT",
        "Stores the end of a wait and returns at once; TIMER_READY does the waiting",
        (
            In("TIME", DATA32, "duration of the wait", range=(0, 2147483647), unit="ms"),
            Out(
                "TIMER",
                DATA32,
                "variable that gets the end of the wait, on the brick's millisecond clock",
                note="the firmware writes it; its documentation lists it among the inputs",
            ),
        ),
        effects=(Effect.VARIES, Effect.COMPUTES),
        sentence="begins a wait of {TIME}",
        words="sleep delay pause",
    ),
    Opcode(
        0x86,
        "TIMER_READY",
        "Waits until the time that TIMER_WAIT stored",
        (In("TIMER", DATA32, "variable that TIMER_WAIT has set"),),
        effects=(Effect.WAITS, Effect.COMPUTES),
        sentence="waits until its end",
    ),
    Opcode(
        0x87,
        "TIMER_READ",
        "Reads the time since the start of the program or direct command that asks",
        (Out("TIME", DATA32, "time since the start", unit="ms"),),
        effects=(Effect.VARIES, Effect.READS),
    ),
    Opcode(
        0x8F,
        "TIMER_READ_US",
        "Reads the free-running microsecond clock, for differences only",
        (Out("TIME", DATA32, "low 32 bits of the clock, wraps every 71.6 minutes", unit="us"),),
        effects=(Effect.VARIES, Effect.READS),
    ),
)

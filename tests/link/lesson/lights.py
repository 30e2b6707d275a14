import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.USB, host="00:16:53:42:2B:99")
my_ev3.verbosity = 1
ops = b"".join(
    [
        *[ev3.opUI_Write, ev3.LED, ev3.LED_RED],
        *[ev3.opSound, ev3.TONE, ev3.LCX(1), ev3.LCX(262), ev3.LCX(500), ev3.opSound_Ready],
        *[ev3.opUI_Write, ev3.LED, ev3.LED_GREEN],
        *[ev3.opSound, ev3.TONE, ev3.LCX(1), ev3.LCX(330), ev3.LCX(500), ev3.opSound_Ready],
        *[ev3.opUI_Write, ev3.LED, ev3.LED_RED],
        *[ev3.opSound, ev3.TONE, ev3.LCX(1), ev3.LCX(392), ev3.LCX(500), ev3.opSound_Ready],
        *[ev3.opUI_Write, ev3.LED, ev3.LED_RED_FLASH],
        *[ev3.opSound, ev3.TONE, ev3.LCX(2), ev3.LCX(523), ev3.LCX(2000), ev3.opSound_Ready],
        *[ev3.opUI_Write, ev3.LED, ev3.LED_GREEN],
    ]
)
my_ev3.send_direct_cmd(ops)

# 11:39:49.039902 Sent 0x|3C:00|2A:00|80|00:00|82:1B:02:94:01:01:82:06:01:82:F4:01:96:82:1B:01:94:01:01:82:4A:01:82:F4:01:96:82:1B:02:...

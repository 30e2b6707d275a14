import time

import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.USB, host="00:16:53:42:2B:99")
my_ev3.verbosity = 1
ops = b"".join(
    [
        *[ev3.opUI_Draw, ev3.TOPLINE, ev3.LCX(0)],
        *[ev3.opUI_Draw, ev3.BMPFILE, ev3.LCX(1), ev3.LCX(0), ev3.LCX(0)],
        ev3.LCS("../apps/Motor Control/MotorCtlAD.rgf"),
        *[ev3.opUI_Draw, ev3.UPDATE],
    ]
)
my_ev3.send_direct_cmd(ops)
time.sleep(5)
ops = b"".join(
    [
        *[ev3.opUI_Draw, ev3.TOPLINE, ev3.LCX(1)],
        *[ev3.opUI_Draw, ev3.FILLWINDOW, ev3.LCX(0), ev3.LCX(0), ev3.LCX(0)],
        *[ev3.opUI_Draw, ev3.UPDATE],
    ]
)
my_ev3.send_direct_cmd(ops)

# 12:01:00.253855 Sent 0x|35:00|2A:00|80|00:00|84:12:00:84:1C:01:00:00:84:2E:2E:2F:61:70:70:...
# 12:01:05.265584 Sent 0x|0F:00|2B:00|80|00:00|84:12:01:84:13:00:00:00:84:00|

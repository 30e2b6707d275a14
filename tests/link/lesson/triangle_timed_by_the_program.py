import time

import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.BLUETOOTH, host="00:16:53:42:2B:99")
ops = b"".join(
    [
        *[ev3.opUI_Draw, ev3.TOPLINE, ev3.LCX(0)],
        *[ev3.opUI_Draw, ev3.FILLWINDOW, ev3.LCX(0), ev3.LCX(0), ev3.LCX(0)],
        *[ev3.opUI_Draw, ev3.UPDATE],
    ]
)
my_ev3.send_direct_cmd(ops)
time.sleep(1)
ops = b"".join(
    [
        *[ev3.opUI_Draw, ev3.LINE, ev3.LCX(1), ev3.LCX(2), ev3.LCX(125), ev3.LCX(88), ev3.LCX(2)],
        *[ev3.opUI_Draw, ev3.UPDATE],
    ]
)
my_ev3.send_direct_cmd(ops)
time.sleep(0.5)
ops = b"".join(
    [
        *[ev3.opUI_Draw, ev3.LINE, ev3.LCX(1), ev3.LCX(88), ev3.LCX(2), ev3.LCX(175), ev3.LCX(125)],
        *[ev3.opUI_Draw, ev3.UPDATE],
    ]
)
my_ev3.send_direct_cmd(ops)
time.sleep(0.5)
ops = b"".join(
    [
        *[ev3.opUI_Draw, ev3.LINE, ev3.LCX(1), ev3.LCX(175), ev3.LCX(125), ev3.LCX(2), ev3.LCX(125)],
        *[ev3.opUI_Draw, ev3.UPDATE],
    ]
)
my_ev3.send_direct_cmd(ops)

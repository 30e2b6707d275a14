import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.BLUETOOTH, host="00:16:53:42:2B:99")
my_ev3.verbosity = 1
my_ev3.sync_mode = ev3.SYNC
ops = b"".join(
    [
        *[ev3.opUI_Button, ev3.PRESS, ev3.BACK_BUTTON, ev3.opUI_Button, ev3.WAIT_FOR_PRESS],
        *[ev3.opUI_Button, ev3.PRESS, ev3.RIGHT_BUTTON, ev3.opUI_Button, ev3.WAIT_FOR_PRESS],
        *[ev3.opUI_Button, ev3.PRESS, ev3.ENTER_BUTTON],
    ]
)
my_ev3.send_direct_cmd(ops)

# 12:58:00.000000 Sent 0x|12:00|2A:00|00|00:00|83:05:06:83:03:83:05:04:83:03:83:05:02|
# 12:58:00.000000 Recv 0x|03:00|2A:00|02|

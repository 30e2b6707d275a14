import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.USB, host="00:16:53:42:2B:99")
ops = b"".join([ev3.opSound, ev3.TONE, ev3.LCX(1), ev3.LCX(440), ev3.LCX(1000)])
my_ev3.send_direct_cmd(ops)

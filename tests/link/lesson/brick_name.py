import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.BLUETOOTH, host="00:16:53:42:2B:99")
my_ev3.verbosity = 1
ops = b"".join([ev3.opCom_Set, ev3.SET_BRICKNAME, ev3.LCS("myEV3")])
my_ev3.send_direct_cmd(ops)

# 09:12:31.011558 Sent 0x|0E:00|2A:00|80|00:00|D4:08:84:6D:79:45:56:33:00|

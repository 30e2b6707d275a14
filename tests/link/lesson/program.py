import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.USB, host="00:16:53:42:2B:99")
my_ev3.verbosity = 1
ops = b"".join(
    [
        *[ev3.opFile, ev3.LOAD_IMAGE, ev3.LCX(1), ev3.LCS("../apps/Motor Control/Motor Control.rbf")],
        *[ev3.LVX(0), ev3.LVX(4)],
        *[ev3.opProgram_Start, ev3.LCX(1), ev3.LVX(0), ev3.LVX(4), ev3.LCX(0)],
    ]
)
my_ev3.send_direct_cmd(ops, local_mem=8)

# 12:50:45.332826 Sent 0x|38:00|2A:00|80|00:20|C0:08:01:84:2E:2E:2F:61:70:70:73:2F:4D:6F:74:6F:...

import ev3proto as ev3

my_ev3 = ev3.EV3(protocol=ev3.USB, host="00:16:53:42:2B:99")
my_ev3.verbosity = 1
ops = b"".join([ev3.opSound, ev3.PLAY, ev3.LCX(100), ev3.LCS("./ui/DownloadSucces")])
my_ev3.send_direct_cmd(ops)

# 09:42:03.575103 Sent 0x|1E:00|2A:00|80|00:00|94:02:81:64:84:2E:2F:75:69:2F:44:6F:77:6E:6C:6F:61:64:53:75:63:63:65:73:00|

# The calls of ev3_dc's documentation of its lower layer, and the corners of what they give.
import struct

import ev3_dc as ev3

my_ev3 = ev3.EV3(protocol=ev3.WIFI)
my_ev3.verbosity = 1

print("*** SYNC ***")
my_ev3.sync_mode = ev3.SYNC
print(my_ev3.send_direct_cmd(ev3.opNop))
print("*** ASYNC (no reply) ***")
my_ev3.sync_mode = ev3.ASYNC
print(my_ev3.send_direct_cmd(ev3.opNop))
print("*** ASYNC (reply) ***")
first = my_ev3.send_direct_cmd(ev3.opNop, global_mem=1)
print(my_ev3.wait_for_reply(first))
print("*** STD ***")
my_ev3.sync_mode = ev3.STD
print(my_ev3.send_direct_cmd(ev3.opNop))

ops = b"".join(
    (
        *(ev3.opInput_Device, ev3.READY_SI, ev3.LCX(0), ev3.PORT_A_SENSOR),
        *(ev3.LCX(7), ev3.LCX(0), ev3.LCX(1), ev3.GVX(0)),
        *(ev3.opInput_Device, ev3.READY_RAW, ev3.LCX(0), ev3.port_motor_input(ev3.PORT_D)),
        *(ev3.LCX(7), ev3.LCX(0), ev3.LCX(1), ev3.GVX(4)),
    )
)
print(struct.unpack("<fi", my_ev3.send_direct_cmd(ops, global_mem=8)))

ops = b"".join((ev3.opUI_Read, ev3.GET_VBATT, ev3.GVX(0)))
print(struct.unpack("<f", my_ev3.send_direct_cmd(ops, global_mem=4, sync_mode=ev3.SYNC, verbosity=0)))
ops = b"".join((ev3.opMove32_32, ev3.LCX(70000), ev3.LVX(0), ev3.opMove32_32, ev3.LVX(0), ev3.GVX(0)))
print(my_ev3.send_direct_cmd(ops, local_mem=4, global_mem=4))

print(my_ev3.send_system_cmd(ev3.LIST_FILES + struct.pack("<H", 900) + b"../prjs/\x00"))
print(my_ev3.send_system_cmd(ev3.CREATE_DIR + b"../prjs/a\x00"))
print(my_ev3.send_system_cmd(ev3.DELETE_FILE + b"../prjs/a\x00", reply=False))
try:
    my_ev3.send_system_cmd(ev3.CREATE_DIR + b"/none/none\x00")
except ev3.SysCmdError:
    print("SysCmdError")
try:
    my_ev3.send_direct_cmd(ev3.opUI_Read + ev3.GET_VBATT + ev3.LCX(0), global_mem=4)
except ev3.DirCmdError:
    print("DirCmdError")

# Properties ask for the same things in other frames: what they give is compared.
my_ev3.verbosity = 0
my_ev3.name = "robot"
my_ev3.volume = 42
print(my_ev3.name, my_ev3.volume, my_ev3.sleep, my_ev3.protocol, my_ev3.sync_mode, my_ev3.verbosity)
print(my_ev3.memory.total, my_ev3.sensors, my_ev3.system.fw_version, my_ev3.battery.percentage)
other = ev3.EV3(ev3_obj=my_ev3)
print(other.send_direct_cmd(ev3.opNop, sync_mode=ev3.SYNC))

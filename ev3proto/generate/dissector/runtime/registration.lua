-- Registration ------------------------------------------------------------------------------------------------------

ev3.fields = fields

local expert_list = {}
for _, declared in pairs(experts) do
    expert_list[#expert_list + 1] = declared
end
ev3.experts = expert_list

-- The carriers by what Wireshark calls the kind of a packet's ports. One protocol serves all of them, so that "Decode
-- As" offers it everywhere by one name.
local CARRIERS = { [2] = dissect_tcp, [3] = dissect_udp, [8] = dissect_usb, [11] = dissect_rfcomm }

function ev3.dissector(tvb, pinfo, tree)
    local dissect = CARRIERS[pinfo.port_type]
    return dissect and dissect(tvb, pinfo, tree) or 0
end

function ev3.init()
    forget_dialogues()
    forget_streams()
    forget_bricks()
end

local dialect_choices = {}
for number, name in ipairs(DIALECTS) do
    dialect_choices[number] = { number, name, number }
end

ev3.prefs.tcp_ports = Pref.range("TCP ports", tostring(TCP_PORT), "TCP ports on which bricks listen", 65535)
ev3.prefs.firmware = Pref.enum("Firmware", 1, "The firmware whose instruction set to read by", dialect_choices, false)
ev3.prefs.bytes = Pref.bool("Bytes as a field", false, "Give all bytes of each frame in one field, for programs")

local tcp_ports = DissectorTable.get("tcp.port")
local listened = tostring(TCP_PORT)
tcp_ports:add(listened, ev3)

function ev3.prefs_changed()
    if listened ~= ev3.prefs.tcp_ports then
        if listened ~= "" then tcp_ports:remove(listened, ev3) end
        listened = ev3.prefs.tcp_ports
        if listened ~= "" then tcp_ports:add(listened, ev3) end
    end
    gives_bytes = ev3.prefs.bytes
    dialect = DIALECTS[ev3.prefs.firmware]
    instructions = INSTRUCTION_SETS[dialect]
end

DissectorTable.get("udp.port"):add(BEACON_PORT, ev3)
ev3:register_heuristic("udp", guess_udp)

local usb_products = DissectorTable.get("usb.product")
for _, product in ipairs(USB_PRODUCTS) do
    usb_products:add(product, ev3)
end
ev3:register_heuristic("usb.interrupt", guess_usb)

-- The channel of the serial port profile, whichever side opened it.
local rfcomm_channels = DissectorTable.get("btrfcomm.dlci")
rfcomm_channels:add(2 * RFCOMM_CHANNEL, ev3)
rfcomm_channels:add(2 * RFCOMM_CHANNEL + 1, ev3)

-- Every item of a tree is an object that Lua must clean up. Doing that sooner, and all at once, keeps memory small and
-- warm: full output of a busy capture takes a third less time, as `pytest benchmarks -k dissector` shows.
collectgarbage("setpause", 120)
collectgarbage("setstepmul", 2000)

-- Carriers ----------------------------------------------------------------------------------------------------------
--
-- Each carrier is a part of its own further below, which adds itself here.

local carriers, carrier_dissectors = {}, {}

-- It has `dissectors`, by what Wireshark calls the kind of a packet's ports, and `register`, which says where packets
-- of the carrier are found. Some have `forget`, for what they know of the last capture, and `prefs_changed`.
local function add_carrier(carrier)
    carriers[#carriers + 1] = carrier
    for kind, dissect in pairs(carrier.dissectors) do
        carrier_dissectors[kind] = dissect
    end
end

local function each_carrier(task)
    for _, carrier in ipairs(carriers) do
        if carrier[task] then carrier[task]() end
    end
end

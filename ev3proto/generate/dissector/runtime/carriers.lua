-- Carriers ----------------------------------------------------------------------------------------------------------
--
-- Each carrier is a part of its own further below, which adds itself here.

local carriers = { all = {}, dissectors = {} }

-- It has `dissectors`, by what Wireshark calls the kind of a packet's ports, and `register`, which says where packets
-- of the carrier are found. Some have `forget`, for what they know of the last capture, and `prefs_changed`.
function carriers.add(carrier)
    table.insert(carriers.all, carrier)
    for kind, dissect in pairs(carrier.dissectors) do
        carriers.dissectors[kind] = dissect
    end
end

function carriers.each(task)
    for _, carrier in ipairs(carriers.all) do
        if carrier[task] then carrier[task]() end
    end
end

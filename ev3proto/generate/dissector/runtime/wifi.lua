-- WiFi --------------------------------------------------------------------------------------------------------------
--
-- The beacon in UDP datagrams, then the byte stream of a TCP connection.

do
    -- Where beacons came from, and the packets that were sent back there.
    local bricks, answers

    local function forget_bricks()
        bricks, answers = {}, {}
    end
    forget_bricks()

    local function dissect_tcp(tvb, pinfo, tree)
        local captured, reported = tvb:len(), tvb:reported_len()
        local is_last = pinfo.can_desegment == 0 or captured < reported
        local behind, wanted, said = dissect_stream(tvb, tvb:raw(), reported, conversation_key, pinfo, tree, is_last)
        if behind < captured then
            pinfo.desegment_offset = behind
            pinfo.desegment_len = wanted or DESEGMENT_ONE_MORE_SEGMENT
        end
        if said then show(pinfo, tvb, said) end
        return captured
    end

    local function dissect_beacon(tvb, text, tree)
        local item = has_tree(tree) and add_item(tree, tvb())
        local at, values = 0, {}
        for _, line in ipairs(BEACON_LINES) do
            local head = line.label .. ": "
            local stop = find(text, "\r\n", at + 1, true)
            if not stop or sub(text, at + 1, at + #head) ~= head then
                complain(item or tree, "fault", format("at offset %d: a line '%s...' should stand here", at, head))
                break
            end
            local value = sub(text, at + #head + 1, stop - 1)
            values[#values + 1] = on_one_line(value)
            local range = tvb(at + #head, #value)
            if item then item:add(beacon_field[line.name], range, utf8_text(value)) end
            at = stop + 1
        end
        local said = "beacon: " .. concat(values, " ")
        if item then item:set_text("EV3: " .. said) end
        return said
    end

    -- A beacon that a brick broadcasts, or whatever a host answers to it.
    local function dissect_udp(tvb, pinfo, tree)
        local text = tvb:raw()
        local head = BEACON_LINES[1].label .. ": "
        if sub(text, 1, #head) == head then
            if not pinfo.visited then bricks[tostring(pinfo.src) .. " " .. pinfo.src_port] = true end
            show(pinfo, tvb, dissect_beacon(tvb, text, tree))
            return tvb:len()
        end
        if has_tree(tree) then
            add_item(tree, tvb()):set_text("EV3: answer to a beacon"):add(field.beacon_answer, tvb())
        end
        show(pinfo, tvb, "answer to a beacon")
        return tvb:len()
    end

    -- An answer goes to the port that the beacon came from, which is known by nothing else.
    local function guess_udp(tvb, pinfo, tree)
        if not pinfo.visited and next(bricks) and bricks[tostring(pinfo.dst) .. " " .. pinfo.dst_port] then
            answers[pinfo.number] = true
        end
        if not answers[pinfo.number] then return false end
        dissect_udp(tvb, pinfo, tree)
        return true
    end

    local tcp_ports = DissectorTable.get("tcp.port")
    local listened = tostring(TCP_PORT)

    local function follow_ports()
        if listened == ev3.prefs.tcp_ports then return end
        if listened ~= "" then tcp_ports:remove(listened, ev3) end
        listened = ev3.prefs.tcp_ports
        if listened ~= "" then tcp_ports:add(listened, ev3) end
    end

    local function register()
        ev3.prefs.tcp_ports = Pref.range("TCP ports", listened, "TCP ports on which bricks listen", 65535)
        tcp_ports:add(listened, ev3)
        DissectorTable.get("udp.port"):add(BEACON_PORT, ev3)
        ev3:register_heuristic("udp", guess_udp)
    end

    add_carrier({
        dissectors = { [2] = dissect_tcp, [3] = dissect_udp },
        forget = forget_bricks,
        prefs_changed = follow_ports,
        register = register,
    })
end

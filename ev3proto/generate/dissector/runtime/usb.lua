-- USB ---------------------------------------------------------------------------------------------------------------
--
-- Each report has one frame at its start; the rest is padding.

do
    -- The "port" of the host; that of a device is the number of its endpoint.
    local HOST = 0xFFFFFFFF

    local function is_from_host(pinfo) return pinfo.src_port == HOST end

    -- Returns the device that a report comes from or goes to, without its endpoint.
    local function device_key(pinfo)
        local address = tostring(is_from_host(pinfo) and pinfo.dst or pinfo.src)
        return address:match("^(.*)%.%d+$") or address
    end

    -- Detects a known fault of the bootloader: its reply is partly overwritten by the request.
    local function is_overwritten(message, pinfo)
        local type, command = message.type, message.command
        return type and type.is_command and command and command.is_bootloader and not is_from_host(pinfo)
    end

    -- The numbers of our packets, of devices whose product is not known.
    local taken

    -- The number of the last packet from or to a known brick, or a device that the user chose.
    local marked

    local function forget_devices() taken, marked = {}, nil end

    -- Reads the message at the start of a report, without the padding.
    local function read_report(tvb)
        local stop = stop_of(bytes_of(tvb, 0, LENGTH_FIELD), 0)
        return messages.read(bytes_of(tvb, 0, math.min(stop, captured_len(tvb))))
    end

    local function dissect_report(tvb, message, device, pinfo, tree)
        local number, offset, captured = pinfo.number, offset_of(tvb), captured_len(tvb)
        local command, line = message.command, nil
        if is_overwritten(message, pinfo) then
            message.is_overwritten = true
            line = "bootloader fault: reply to " .. command.name .. " overwritten by its request"
        end
        local stop, conversation = message.stop, not pinfo.visited and dialogues.conversation_of(device)
        local brick = has_tree(tree) and device
        local place = storage.place_of(number, offset)
        local said, item = dissect_message(tvb, 0, message, conversation, place, pinfo, tree, brick, line)
        if line then
            local reason = "a known fault of the EV3's bootloader on USB 3 ports: the reply to %s with the request"
                .. " written over its first bytes"
            complain(item or tree, "bootloader_fault", format(reason, command.name))
        end
        if item and stop < captured then
            item:set_len(captured)
            local rest = tvb(stop, captured - stop)
            item:add(field.padding, rest):append_text(format(" (%s)", phrases.plural(captured - stop, "byte")))
        end
        start_line(number, offset)
        say(said)
        show(pinfo, tvb, tree)
        return captured
    end

    -- Dissects any report of a brick, except of control transfers. Returns 0 if it is too short for a frame.
    local function dissect_known(tvb, pinfo, tree)
        local captured, device = captured_len(tvb), device_key(pinfo)
        if pinfo.src_port == 0 or pinfo.dst_port == 0 or captured < HEADER_SIZE then return 0 end
        local text = bytes_of(tvb, 0, LENGTH_FIELD)
        if is_length(text, 0) then return dissect_report(tvb, read_report(tvb), device, pinfo, tree) end
        start_line(pinfo.number, offset_of(tvb))
        local report = { tvb = tvb, text = text, pinfo = pinfo, tree = tree, brick = has_tree(tree) and device }
        say((streaming.add_no_frame(report, 0, captured)))
        show(pinfo, tvb, tree)
        return captured
    end

    -- Wireshark calls this for all transfers of a known or chosen device. Bulk transfers are not ours: other
    -- software on the brick uses them with the same product number. So the packet is only marked here; for interrupt
    -- transfers Wireshark then calls the heuristic below.
    local function mark_known(_, pinfo)
        marked = pinfo.number
        return 0
    end

    -- Returns the message in a report of a device whose product is not known, nil if it is not ours. The report must
    -- have the size for its type, because other devices have reports, too.
    local function claimed_message(tvb, key, pinfo)
        local sort, captured, message = REPORT_SIZES[tvb:reported_len()], captured_len(tvb), nil
        local header = bytes_of(tvb, 0, math.min(captured, HEADER_SIZE))
        local type = MESSAGE_TYPES[byte(header, HEADER_SIZE)]
        if sort and type and (sort == "computer" or type.carries == "daisy")
            and is_usual_length(reading.unsigned16(header, 0)) and stop_of(header, 0) <= tvb:reported_len() then
            message = read_report(tvb)
            -- Bricks in a chain send commands both ways, in smaller reports than computers.
            if sort == "daisy" or is_overwritten(message, pinfo) then
                return claiming.is_sensible(message) and message or nil
            end
        end
        local conversation, number, from_host = dialogues.conversation_of(key), pinfo.number, is_from_host(pinfo)
        if not message or (type.is_command == true) ~= from_host then
            if claiming.is_claimed(conversation) then claiming.count(conversation, captured, number) end
            return nil
        end
        if claiming.is_claimed(conversation) then return message end
        local offset, text = offset_of(tvb), message.text
        local found = claiming.judge(conversation, pinfo, {
            side = from_host, text = text, starts = { 0 }, reported = message.size, begins = is_command,
            needs_reply = #text < message.size,
            adopt = function()
                taken[number] = true
                return offset
            end,
        })
        return found == CHAIN and message or nil
    end

    -- Dissects reports of a known brick, or of a device whose product was not captured, as in most captures that were
    -- started after the brick was plugged in.
    local function guess_usb(tvb, pinfo, tree)
        local number, device, message = pinfo.number, device_key(pinfo), nil
        if number == marked then return dissect_known(tvb, pinfo, tree) > 0 end
        if pinfo.visited then
            message = taken[number] and read_report(tvb)
        else
            message = claimed_message(tvb, device, pinfo)
            if message then taken[number] = true end
        end
        if not message then return false end
        dissect_report(tvb, message, device, pinfo, tree)
        local conversation = not pinfo.visited and dialogues.conversation_of(device)
        if conversation and claiming.is_claimed(conversation) then claiming.count(conversation, 0, number) end
        return true
    end

    local function register()
        local products = DissectorTable.get("usb.product")
        for _, product in ipairs(CARRIERS.usb_products) do products:add(product, ev3) end
        products:add_for_decode_as(ev3_all)
        DissectorTable.get("usb.device"):add_for_decode_as(ev3_all)
        ev3:register_heuristic("usb.interrupt", guess_usb)
    end

    dissectors[8] = mark_known
    carriers[#carriers + 1] = { forget = forget_devices, register = register }
end

-- USB ---------------------------------------------------------------------------------------------------------------
--
-- Each report has one frame at its start, the rest is padding.

do
    -- The "port" of the host; that of a device is the number of its endpoint.
    local HOST = 0xFFFFFFFF

    -- Methods that each packet needs: looking them up takes longer than what they do.
    local bytes_of, captured_len, offset_of = Tvb.raw, Tvb.len, Tvb.offset

    local function is_from_host(pinfo)
        return pinfo.src_port == HOST
    end

    local function is_control(pinfo)
        return pinfo.src_port == 0 or pinfo.dst_port == 0
    end

    -- The device that a report comes from or goes to, whichever of its endpoints.
    local function device_key(pinfo)
        local address = tostring(is_from_host(pinfo) and pinfo.dst or pinfo.src)
        return address:match("^(.*)%.%d+$") or address
    end

    -- A known fault of the bootloader: its reply comes with the request written over its first bytes.
    local function is_overwritten(message, pinfo)
        local type, command = message.type, message.command
        return type and type.is_command and command and command.is_bootloader and not is_from_host(pinfo)
    end

    -- Reports of devices that nobody knows as bricks, of which a frame was taken.
    local taken

    -- The number of the packet that a known brick sent or received last.
    local marked

    local function forget_devices()
        taken, marked = {}, nil
    end
    forget_devices()

    -- The message at the start of a report. Nobody looks at the bytes of the padding: there are more than 1 kB of both.
    local function read_report(tvb)
        local low, high = byte(bytes_of(tvb, 0, LENGTH_FIELD), 1, LENGTH_FIELD)
        return read_message(bytes_of(tvb, 0, math.min(frame_size(low, high), captured_len(tvb))))
    end

    local function dissect_report(tvb, message, device, pinfo, tree)
        local number, offset, is_shown, captured = pinfo.number, offset_of(tvb), has_tree(tree), captured_len(tvb)
        local command, line = message.command, nil
        if is_overwritten(message, pinfo) then
            message.is_overwritten = true
            line = "bootloader fault: reply to " .. command.name .. " overwritten by its request"
        end
        local stop, conversation = message.stop, not pinfo.visited and conversation_of(device)
        brick = is_shown and device
        local place = place_of(number, offset)
        local said, item = dissect_message(tvb, 0, message, conversation, place, pinfo, tree, is_shown, line)
        if line then
            local reason = "a known fault of the EV3's bootloader on USB 3 ports: the reply to %s with the request"
                .. " written over its first bytes"
            complain(item or tree, "bootloader_fault", format(reason, command.name))
        end
        if item and stop < captured then
            local rest = tvb(stop, captured - stop)
            item:add(field.padding, rest):append_text(format(" (%s)", plural(captured - stop, "byte")))
        end
        start_line(number, offset)
        say(said)
        show(pinfo)
        return captured
    end

    -- A report that holds no frame, though its device is a brick.
    local function dissect_other_report(tvb, length, pinfo, tree)
        local captured = captured_len(tvb)
        brick = device_key(pinfo)
        start_line(pinfo.number, offset_of(tvb))
        say((dissect_no_frame(tvb, 0, captured, length, tree, has_tree(tree))))
        show(pinfo)
        return captured
    end

    -- A report of a brick, whatever is in it. Returns 0 where there is no room for a frame.
    local function dissect_known(tvb, pinfo, tree)
        if is_control(pinfo) or captured_len(tvb) < HEADER_SIZE then return 0 end
        local low, high = byte(bytes_of(tvb, 0, LENGTH_FIELD), 1, LENGTH_FIELD)
        if not is_usual_length(low, high) then return dissect_other_report(tvb, low + high * 0x100, pinfo, tree) end
        return dissect_report(tvb, read_report(tvb), device_key(pinfo), pinfo, tree)
    end

    -- Wireshark hands over everything that a known product transfers, without saying how. Bulk transfers are not ours:
    -- other programs for the brick use them under the same product number. So the packet is only marked here; for
    -- interrupt transfers Wireshark then calls the heuristic below.
    local function mark_known(_, pinfo)
        marked = pinfo.number
        return 0
    end

    -- The message of ours that a report holds, if it does, although nobody knows its device as a brick. Other devices
    -- have reports, too: it must have the size of its type's.
    local function claimed_message(tvb, key, pinfo)
        local sort, captured, message = REPORT_SIZES[tvb:reported_len()], captured_len(tvb), nil
        local low, high, _, _, code = byte(bytes_of(tvb, 0, math.min(captured, HEADER_SIZE)), 1, HEADER_SIZE)
        local type = MESSAGE_TYPES[code]
        if sort and type and (sort == "computer" or type.carries == "daisy") and is_usual_length(low, high)
            and frame_size(low, high) <= captured then
            message = read_report(tvb)
            -- Bricks in a chain send commands both ways. They are no computers, whose reports are larger.
            if sort == "daisy" or is_overwritten(message, pinfo) then
                return claiming.is_sensible(message) and message or nil
            end
        end
        if not message or (type.is_command == true) ~= is_from_host(pinfo) then
            local conversation = known_conversation(key)
            if conversation and conversation.is_claimed then claiming.count(conversation, captured, pinfo.number) end
            return nil
        end
        local conversation = conversation_of(key)
        if not conversation.is_claimed and claiming.is_plausible(message) then claiming.begin(conversation) end
        return conversation.is_claimed and message or nil
    end

    -- Reports of a known brick, or of a device whose product is not in the capture, as in most captures that began
    -- after plugging in.
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
        local conversation = not pinfo.visited and conversation_of(device)
        if conversation and conversation.is_claimed then claiming.count(conversation, 0, number) end
        if has_tree(tree) then free_unused() end
        return true
    end

    local function register()
        local products = DissectorTable.get("usb.product")
        for _, product in ipairs(CARRIERS.usb_products) do
            products:add(product, ev3)
        end
        ev3:register_heuristic("usb.interrupt", guess_usb)
    end

    carriers.add({ dissectors = { [8] = mark_known }, forget = forget_devices, register = register })
end

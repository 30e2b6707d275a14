-- USB ---------------------------------------------------------------------------------------------------------------
--
-- Each report has one frame at its start, the rest is padding.

do
    -- The "port" of the host; that of a device is the number of its endpoint.
    local HOST = 0xFFFFFFFF

    local function is_from_host(pinfo)
        return pinfo.src_port == HOST
    end

    local function is_control(pinfo)
        return pinfo.src_port == 0 or pinfo.dst_port == 0
    end

    -- The device that a report comes from or goes to, whichever of its endpoints.
    local function device_key(pinfo)
        local device = tostring(is_from_host(pinfo) and pinfo.dst or pinfo.src)
        return device:match("^(.*)%.%d+$") or device
    end

    -- A known fault of the bootloader: its reply comes with the request written over its first bytes.
    local function is_overwritten(message, pinfo)
        local type, command = message.type, message.command
        return type and type.is_command and command and command.is_bootloader and not is_from_host(pinfo)
    end

    local function dissect_report(tvb, pinfo, tree)
        local text = tvb:raw()
        local low, high = byte(text, 1, 2)
        local stop = math.min(LENGTH_FIELD + low + high * 0x100, #text)
        local message = read_message(sub(text, 1, stop))
        local line
        if is_overwritten(message, pinfo) then
            message.is_overwritten = true
            line = "bootloader fault: reply to " .. message.command.name .. " overwritten by its request"
        end
        local said, item = dissect_message(tvb, 0, message, device_key, pinfo, tree, line)
        if message.is_overwritten then
            local reason = "a known fault of the EV3's bootloader on USB 3 ports: the reply to %s with the request"
                .. " written over its first bytes"
            complain(item or tree, "bootloader_fault", format(reason, message.command.name))
        end
        if item and stop < #text then
            local rest = tvb(stop, #text - stop)
            item:add(field.padding, rest):set_text("Padding: " .. plural(#text - stop, "byte"))
        end
        show(pinfo, tvb, said)
        return tvb:len()
    end

    local function starts_like_frame(tvb)
        return tvb:len() >= HEADER_SIZE and may_be_frame(tvb:raw(0, HEADER_SIZE))
    end

    -- Reports of a product that is known to be a brick. Its control transfers come here, too: they are no frames.
    local function dissect_usb(tvb, pinfo, tree)
        if is_control(pinfo) or tvb:len() < HEADER_SIZE then return 0 end
        local low, high = byte(tvb:raw(0, LENGTH_FIELD), 1, LENGTH_FIELD)
        if is_length(low, high) then return dissect_report(tvb, pinfo, tree) end
        show(pinfo, tvb, dissect_no_frame(tvb, 0, tvb:len(), low + high * 0x100, tree))
        return tvb:len()
    end

    -- Whether a frame is without any fault and goes the way that it should.
    local function is_flawless(message, from_host)
        local type = message.type
        if not type or message.stop < message.size then return false end
        -- Bricks in a chain send commands both ways.
        if type.carries ~= "daisy" and type.is_command ~= (from_host or nil) then return false end
        if type.carries == "daisy" then
            -- In a command the layers stand behind the sub-command.
            local at = type.is_command and HEADER_SIZE + 1 or HEADER_SIZE
            local from, to = byte(message.text, at + 1, at + 2)
            if not to or from > MOST_LAYERS or to > MOST_LAYERS then return false end
        end
        if type.carries == "direct" and type.is_command then
            -- Nobody sends the opcode that stands for a fault; its number is that of the bytes of an empty report.
            local first = byte(message.text, COMMAND_HEADER_SIZE + 1)
            if not first or OPCODE_NAMES[first] == "ERROR" then return false end
            return select(2, count_operations(message.text, COMMAND_HEADER_SIZE, message.stop)) == nil
        end
        show_message(message, 0)
        return not message.fault
    end

    -- Reports of a device whose product is not in the capture, as in most captures that began after plugging in. Other
    -- devices have reports, too: only what fits in every respect is taken.
    local function guess_usb(tvb, pinfo, tree)
        local sort = REPORT_SIZES[tvb:reported_len()]
        if not sort or not starts_like_frame(tvb) then return false end
        local low, high, _, _, code = byte(tvb:raw(0, HEADER_SIZE), 1, HEADER_SIZE)
        local stop = LENGTH_FIELD + low + high * 0x100
        if (MESSAGE_TYPES[code].carries == "daisy") ~= (sort == "daisy") or stop > tvb:len() then return false end
        local message = read_message(tvb:raw(0, stop))
        local is_taken = is_flawless(message, is_from_host(pinfo))
            or is_overwritten(message, pinfo) and not message.fault
        if not is_taken then return false end
        dissect_report(tvb, pinfo, tree)
        return true
    end

    local function register()
        local products = DissectorTable.get("usb.product")
        for _, product in ipairs(USB_PRODUCTS) do
            products:add(product, ev3)
        end
        ev3:register_heuristic("usb.interrupt", guess_usb)
    end

    add_carrier({ dissectors = { [8] = dissect_usb }, register = register })
end

-- Bluetooth ---------------------------------------------------------------------------------------------------------
--
-- RFCOMM hands over one piece of the stream after the other, and nobody but us joins them: a frame that is not whole
-- waits here for its rest. The first pass remembers, packet by packet, what was waiting before it.

do
    local streams, packets

    local function forget_streams()
        streams, packets = {}, {}
    end
    forget_streams()

    -- Devices by the addresses of their hardware: to the others Wireshark adds a device's name as soon as it knows one.
    local function ends(pinfo)
        return tostring(pinfo.dl_src), tostring(pinfo.dl_dst), floor(pinfo.match_uint / 2)
    end

    local function channel_key(pinfo)
        local from, to, channel = ends(pinfo)
        return (from < to and from .. " " .. to or to .. " " .. from) .. " " .. channel
    end

    -- One direction of one channel. `left` is what waits, `numbers` the packets that it came in.
    local function stream_of(pinfo)
        local from, to, channel = ends(pinfo)
        -- A capture begun after the connection has no addresses, but mostly tells what was sent and what received.
        local key = from .. " > " .. to .. " " .. channel .. " " .. pinfo.p2p_dir
        local stream = streams[key]
        if not stream then
            stream = { left = "", numbers = {} }
            streams[key] = stream
        end
        return stream
    end

    -- The first time that a packet is seen: what waits for it. nil for what is not this protocol, as other programs
    -- use the same channels. Less than a header does not tell; whoever types a text sends it letter by letter.
    local function open_packet(stream, piece, number)
        if stream.is_ours then return { waiting = stream.left, numbers = stream.numbers } end
        for _, waiting in ipairs({ stream.left, "" }) do
            local text = waiting .. piece
            if may_be_frame(text) then
                stream.is_ours = #text >= HEADER_SIZE
                if stream.is_ours then
                    return { waiting = waiting, numbers = waiting ~= "" and stream.numbers or {} }
                end
                if waiting == "" then stream.numbers = {} end
                stream.left = text
                table.insert(stream.numbers, number)
                return nil
            end
        end
        stream.left, stream.numbers = "", {}
        return nil
    end

    -- The same packet when it is read: what waits now for the next one.
    local function close_packet(stream, packet, number, rest, is_whole)
        stream.left = rest
        if is_whole then
            for _, earlier in ipairs(packet.numbers) do
                if packets[earlier] then packets[earlier].complete_in = number end
            end
        end
        stream.numbers = {}
        if rest == "" then return end
        if not is_whole then
            -- A frame in more than two pieces comes from all of them.
            for index, earlier in ipairs(packet.numbers) do
                stream.numbers[index] = earlier
            end
        end
        table.insert(stream.numbers, number)
    end

    local function add_joined(tree, tvb, packet)
        local said = "EV3: joined with " .. plural(#packet.waiting, "byte") .. " of earlier packets"
        local item = tree:add(ev3, tvb(), said)
        for _, earlier in ipairs(packet.numbers) do
            item:add(field.fragments, earlier):set_generated()
        end
    end

    local function add_part(tree, tvb, size, packet)
        local range = tvb(math.max(tvb:len() - size, 0))
        local item = tree:add(ev3, range, "EV3: part of a frame")
        item:add(field.fragment, range)
        if packet.complete_in then item:add(field.fragment_of, packet.complete_in):set_generated() end
    end

    local function dissect_rfcomm(tvb, pinfo, tree)
        if tvb:len() == 0 then return 0 end
        local number, piece = pinfo.number, tvb:raw()
        local is_cut = tvb:len() < tvb:reported_len()
        local packet, stream = packets[number], nil
        if not pinfo.visited then
            stream = stream_of(pinfo)
            packet = open_packet(stream, piece, number)
            packets[number] = packet
        end
        if not packet then return 0 end
        local text, whole = packet.waiting .. piece, tvb
        if packet.waiting ~= "" then whole = ByteArray.new(text, true):tvb("EV3 frames") end
        if packet.waiting ~= "" and has_tree(tree) then add_joined(tree, tvb, packet) end
        local behind, _, said = dissect_stream(whole, text, #text, channel_key, pinfo, tree, is_cut)
        if stream then close_packet(stream, packet, number, sub(text, behind + 1), behind > 0) end
        if behind < #text then
            if has_tree(tree) then add_part(tree, tvb, #text - behind, packet) end
            said = said and said .. "; part of a frame" or "part of a frame"
        end
        show(pinfo, tvb, said)
        return tvb:len()
    end

    -- The channel of the serial port profile, whichever side opened it.
    local function register()
        local channels = DissectorTable.get("btrfcomm.dlci")
        channels:add(2 * RFCOMM_CHANNEL, ev3)
        channels:add(2 * RFCOMM_CHANNEL + 1, ev3)
    end

    add_carrier({ dissectors = { [11] = dissect_rfcomm }, forget = forget_streams, register = register })
end

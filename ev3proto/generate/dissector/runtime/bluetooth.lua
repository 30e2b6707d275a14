-- Bluetooth ---------------------------------------------------------------------------------------------------------
--
-- RFCOMM hands over one piece of the stream after the other, and nobody but us joins them: a frame that is not whole
-- waits here for its rest. The first pass remembers, packet by packet, what was waiting before it.

local dissect_rfcomm, forget_streams
do
    local streams, packets

    function forget_streams()
        streams, packets = {}, {}
    end
    forget_streams()

    local function channel_key(pinfo)
        return conversation_key(pinfo) .. " " .. floor(pinfo.match_uint / 2)
    end

    -- One direction of one channel. `left` is what waits, `numbers` the packets that it came in.
    local function stream_of(pinfo)
        local channel = floor(pinfo.match_uint / 2)
        local key = tostring(pinfo.src) .. " > " .. tostring(pinfo.dst) .. " " .. channel
        local stream = streams[key]
        if not stream then
            stream = { left = "", numbers = {} }
            streams[key] = stream
        end
        return stream
    end

    -- The first time that a packet is seen: what waits for it. nil for what is not this protocol, as other programs
    -- use the same channels.
    local function open_packet(stream, piece)
        if not stream.is_ours then
            if not may_be_frame(piece) then return nil end
            stream.is_ours = true
        end
        return { waiting = stream.left, numbers = stream.numbers }
    end

    -- The same packet when it is read: what waits now for the next one.
    local function close_packet(stream, packet, number, rest, is_whole)
        stream.left = rest
        if is_whole then
            for _, earlier in ipairs(packet.numbers) do
                packets[earlier].complete_in = number
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

    function dissect_rfcomm(tvb, pinfo, tree)
        local number, piece = pinfo.number, tvb:raw()
        local packet, stream = packets[number], nil
        if not pinfo.visited then
            stream = stream_of(pinfo)
            packet = open_packet(stream, piece)
            packets[number] = packet
        end
        if not packet then return 0 end
        local text, whole = packet.waiting .. piece, tvb
        if packet.waiting ~= "" then whole = ByteArray.new(text, true):tvb("EV3 frames") end
        if packet.waiting ~= "" and has_tree(tree) then add_joined(tree, tvb, packet) end
        local behind, _, said = dissect_stream(whole, text, #text, channel_key, pinfo, tree, false)
        if stream then close_packet(stream, packet, number, sub(text, behind + 1), behind > 0) end
        if behind < #text then
            if has_tree(tree) then add_part(tree, tvb, #text - behind, packet) end
            said = said and said .. "; part of a frame" or "part of a frame"
        end
        show(pinfo, tvb, said)
        return tvb:len()
    end
end

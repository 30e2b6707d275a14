-- Bluetooth ---------------------------------------------------------------------------------------------------------
--
-- Wireshark passes the stream on in pieces and does not join them: an incomplete frame waits here for its rest. The
-- first pass keeps the bytes that were waiting before each packet.

do
    -- Our packets, by number. `accepts` tells which types go this way. `step` is "lost" if the stream was out of step
    -- before, "sure" if the claim begins here, after `start` bytes that are not ours. For a frame that continues in the
    -- packet, `list` has the numbers of its packets, of which the first `earlier` came before this one; if it is
    -- complete now, `before` has the bytes of those. `begun` is the list of a frame that starts here and is incomplete.
    -- All packets of a frame share its list; its `complete_in` is the packet with the last piece.
    local packets, streams

    local function forget_streams() packets, streams = {}, {} end

    -- Returns the conversation of a packet's channel, and the stream of its direction. Devices are identified by
    -- hardware addresses: Wireshark adds names to the other addresses as soon as it learns them. A capture that was
    -- started after the connection has no addresses, but usually the direction.
    local function channel_of(pinfo)
        local from, to, channel = plain_address(pinfo.dl_src), plain_address(pinfo.dl_dst), floor(pinfo.match_uint / 2)
        local ends = from < to and from .. " " .. to or to .. " " .. from
        local conversation = dialogues.conversation_of(ends .. " " .. channel)
        conversation.sides = conversation.sides or {}
        local key = from .. " > " .. to .. " " .. channel .. " " .. pinfo.p2p_dir
        local stream = streams[key]
        if not stream then
            stream = { left = "", look_at = 0 }
            streams[key] = stream
            table.insert(conversation.sides, stream)
        end
        return conversation, stream
    end

    -- Bricks write into each other's mailboxes, so some commands come from a brick.
    local function is_from_brick(type)
        return not type.is_command or type.carries == "system" and not type.wants_reply
    end

    local function clear(stream)
        stream.left, stream.list, stream.starts, stream.look_at = "", nil, nil, 0
    end

    -- Forgets the waiting bytes of both directions.
    local function clear_sides(conversation)
        for _, stream in ipairs(conversation.sides) do
            clear(stream)
            stream.step = nil
        end
    end

    -- Keeps the waiting bytes and those of the newest packet, from an offset on. `list` has the numbers of their
    -- packets, `starts` where each packet begins in them.
    local function keep(stream, text, place, number)
        local list, starts = {}, {}
        local before = stream.list or {}
        for index, start in ipairs(stream.starts or {}) do
            local stop = stream.starts[index + 1] or #stream.left
            if stop > place then list[#list + 1], starts[#starts + 1] = before[index], math.max(start - place, 0) end
        end
        list[#list + 1], starts[#starts + 1] = number, math.max(#stream.left - place, 0)
        stream.left, stream.list, stream.starts = sub(text, place + 1), list, starts
    end

    -- Makes the records of the packets that a command came in: the newest, in which it ends, and those before it. The
    -- pieces are in the stream; `left` is what waited before the newest.
    local function record_packets(list, left, place, number)
        local packet = { accepts = is_command, step = "sure" }
        packets[number] = packet
        if place >= #left then
            packet.start = place - #left
            return
        end
        list[#list] = nil
        for index, before in ipairs(list) do
            packets[before] = { accepts = is_command, list = list, earlier = index - 1, begun = index == 1 and list }
        end
        list.complete_in = number
        packet.list, packet.earlier, packet.before = list, #list, sub(left, place + 1)
    end

    -- Looks for a reason to claim a channel, and makes the packet's record if it finds one. The beginning of a possible
    -- command is kept: typed text, for example, arrives letter by letter.
    local function claim(conversation, stream, piece, missing, offset, pinfo)
        local number, left, starts = pinfo.number, stream.left, { table.unpack(stream.starts or {}) }
        starts[#starts + 1] = #left
        local text, list = left .. piece, nil
        local found, place = claiming.judge(conversation, pinfo, {
            side = stream, text = text, starts = starts, reported = #text + missing, begins = claiming.begins,
            adopt = function(_, first)
                record_packets(list, left, first, number)
                return first < #left and -first or offset - #left
            end,
        })
        if found then keep(stream, text, place, number) end
        list = stream.list
        if found ~= OPEN then clear(stream) end
        if found == CHAIN and stream == conversation.side_to_brick then
            clear_sides(conversation)
            record_packets(list, left, place, number)
        elseif found == CHAIN then
            packets[number] = { accepts = is_from_brick, step = "sure", start = 0 }
        end
    end

    -- Tells whether all of a text has to wait for more; the newest packet starts at `joint`.
    local function waits(stream, text, accepts, joint)
        if stream.step ~= "lost" then
            local stop = stop_of(text, 0)
            local part = not stop or is_length(text, 0) and stop > #text
            if #text < HEADER_SIZE or part and #text < stream.look_at then return part end
            -- A frame that arrives byte by byte is not examined again at each byte.
            stream.look_at = floor(#text * 1.25) + 1
            if not is_length(text, 0) or finding.slip_of(text, 0, #stream.list == 1 and joint) then return false end
            return finding.judge_split(text, 0, accepts, joint) == PART
        end
        local place, following = finding.find_step(text, 0, accepts, 0, 0)
        return place == 0 and not following
    end

    -- Joins a packet with the bytes that wait for it, in the first pass.
    local function join(stream, piece, packet, number)
        local left = stream.left
        if left == "" then return end
        packet.list, packet.earlier = stream.list, #stream.list
        if waits(stream, left .. piece, packet.accepts, #left) then
            stream.left = left .. piece
            table.insert(stream.list, number)
        else
            packet.before = left
            stream.list.complete_in = number
            clear(stream)
        end
    end

    local function add_joined(tree, tvb, packet)
        local said = "EV3: joined with " .. phrases.plural(#packet.before, "byte") .. " of earlier packets"
        local item = tree:add(ev3, tvb(), said)
        for index = 1, packet.earlier do
            item:add(field.fragments, packet.list[index]):set_generated()
        end
    end

    -- Adds the incomplete frame at the end of a packet.
    local function add_part(tree, tvb, size, packet, brick)
        local range = tvb(math.max(tvb:len() - size, 0))
        local item = tree:add(ev3, range, "EV3: part of a frame")
        item:add(field.brick, brick):set_generated()
        item:add(field.fragment, range)
        local list = packet.begun or packet.list
        if not packet.begun and list then item:add(field.fragments, list[1]):set_generated() end
        if list and list.complete_in then item:add(field.fragment_of, list.complete_in):set_generated() end
    end

    -- Tells whether a direction goes to the brick. If the user claimed the channel, the computer sends to it.
    local function is_to_brick(conversation, stream, pinfo)
        if conversation.side_to_brick then return stream == conversation.side_to_brick end
        return pinfo.p2p_dir == P2P_DIR_SENT
    end

    -- Ends a packet that is a command with a wrong length: the other side sends, so nothing more belongs to it.
    local function end_answered(conversation, stream)
        local alone = #(stream.list or {}) == 1 and stream.alone
        if not alone or not finding.slip_of(stream.left, 0, #stream.left, true) then return end
        dialogues.take_note(alone.place, conversation, messages.read_at(stream.left, 0), alone)
        clear(stream)
    end

    -- Makes the record of a packet in the first pass, if it is ours.
    local function first_look(conversation, stream, piece, missing, offset, pinfo)
        if not claiming.is_claimed(conversation) then
            return claim(conversation, stream, piece, missing, offset, pinfo)
        end
        for _, side in ipairs(conversation.sides) do
            if side ~= stream then end_answered(conversation, side) end
        end
        local accepts = is_to_brick(conversation, stream, pinfo) and is_command or is_from_brick
        packets[pinfo.number] = { accepts = accepts, step = stream.step == "lost" and "lost" or nil }
        join(stream, piece, packets[pinfo.number], pinfo.number)
    end

    local function dissect_rfcomm(tvb, pinfo, tree, is_all)
        local piece, number, missing = tvb:raw(), pinfo.number, tvb:reported_len() - tvb:len()
        if piece == "" then return 0 end
        local conversation, stream
        if not pinfo.visited then
            conversation, stream = channel_of(pinfo)
            if is_all and conversation.state ~= "sure" then claiming.begin(conversation, "sure") end
            first_look(conversation, stream, piece, missing, tvb:offset(), pinfo)
        end
        local packet = packets[number]
        if not packet then return 0 end
        local size, before = #piece, packet.before
        local brick = has_tree(tree) and plain_address(packet.accepts == is_command and pinfo.dl_dst or pinfo.dl_src)
        start_line(number, tvb:offset())
        -- If the packet only continues a frame, there is nothing to dissect yet.
        if before or not packet.list then
            local text, whole = (before or "") .. piece, tvb
            if before then
                whole = ByteArray.new(text, true):tvb("EV3 frames")
                if brick then add_joined(tree, tvb, packet) end
            end
            local joint, begun = before and #before or 0, pinfo.visited and packet.begun
            local state = {
                tvb = whole, text = text, conversation = conversation, number = number, pinfo = pinfo, tree = tree,
                brick = brick, reported = #text, step = packet.step or "likely", start = packet.start,
                is_last = missing > 0 or begun and not begun[2] and not begun.complete_in,
                joint = joint, sent = packet.earlier == 1 and joint, first = not before and 0, may_gap = true,
                accepts = packet.accepts,
            }
            local after = streaming.dissect(state)
            size = #text - after
            if stream then
                if size > 0 then
                    stream.left, stream.list = sub(text, after + 1), { number }
                    packet.begun = stream.list
                    local is_alone = after == math.max(joint, packet.start or 0)
                    local place = storage.place_of(number, whole:offset() + after)
                    stream.alone = is_alone and { place = place, rel_ts = pinfo.rel_ts }
                end
                stream.step = state.step
                claiming.count(conversation, state.lost, number)
                if not claiming.is_claimed(conversation) then clear_sides(conversation) end
            end
        end
        if size > 0 then
            if brick then add_part(tree, tvb, size, packet, brick) end
            say("part of a frame")
        end
        show(pinfo, tvb, tree)
        return #piece
    end

    -- The channel of the serial port profile, opened by either side.
    local function register()
        local channels = DissectorTable.get("btrfcomm.dlci")
        channels:add(2 * CARRIERS.rfcomm_channel, ev3)
        channels:add(2 * CARRIERS.rfcomm_channel + 1, ev3)
        channels:add_for_decode_as(ev3_all)
    end

    dissectors[11] = dissect_rfcomm
    carriers[#carriers + 1] = { forget = forget_streams, register = register }
end

-- Bluetooth ---------------------------------------------------------------------------------------------------------
--
-- RFCOMM hands over one piece of the stream after the other, and nobody but us joins them: a frame that is not whole
-- waits here for its rest. The first pass remembers, packet by packet, what was waiting before it.

do
    -- The packets that a frame came in are one list, which they all share; once the frame is whole, it has the packet
    -- with the last piece as `complete_in`. By packet, of those that are ours: `continued` is the list of the frame
    -- that goes on in it, of which `earlier` packets came before, `waiting` the bytes of those where the frame becomes
    -- whole, and `begun` the list of the frame that begins in it and is not whole. `is_ours` tells of a packet that is
    -- ours which types go its way, `steps` is "lost" where the stream was out of step before it, and "sure" where the
    -- claim begins with it: after `starts` bytes that are others'.
    local streams, is_ours, continued, earlier, waiting, begun, steps, starts

    -- Methods that each packet needs: looking them up takes longer than what they do.
    local bytes_of, offset_of = Tvb.raw, Tvb.offset

    local function forget_streams()
        streams, is_ours, continued, earlier, waiting = {}, {}, {}, {}, {}
        begun, steps, starts = {}, {}, {}
    end
    forget_streams()

    -- What is known of a packet's channel, and of its direction in that. Devices go by the addresses of their hardware:
    -- to the others Wireshark adds a device's name as soon as it knows one. A capture begun after the connection has no
    -- addresses, but mostly tells what was sent and what received.
    local function channel_of(pinfo)
        local from, to, channel = tostring(pinfo.dl_src), tostring(pinfo.dl_dst), floor(pinfo.match_uint / 2)
        local conversation = conversation_of((from < to and from .. " " .. to or to .. " " .. from) .. " " .. channel)
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

    local function is_command(type)
        return type.is_command
    end

    -- Bricks write into each other's mailboxes.
    local function is_from_brick(type)
        return not type.is_command or type.carries == "system" and not type.wants_reply
    end

    local function clear(stream)
        stream.left, stream.list, stream.starts, stream.look_at = "", nil, nil, 0
    end

    -- Nothing is known of what a channel's sides said so far.
    local function clear_sides(conversation)
        for _, stream in ipairs(conversation.sides) do
            clear(stream)
            stream.step = nil
        end
    end

    -- Whether the frame that begins with this text is not whole with it.
    local function is_part(text)
        local low, high = byte(text, 1, 2)
        return not high or is_length(text, 0) and frame_size(low, high) > #text
    end

    -- Keeps the bytes of a stream from an offset on, of those that wait and the packet that came last; `list` are the
    -- packets of those that wait, `starts` where in them each begins.
    local function keep(stream, text, place, number)
        local list, starts = {}, {}
        local before = stream.list or {}
        for index, start in ipairs(stream.starts or {}) do
            local stop = stream.starts[index + 1] or #stream.left
            if stop > place then
                list[#list + 1], starts[#starts + 1] = before[index], math.max(start - place, 0)
            end
        end
        list[#list + 1], starts[#starts + 1] = number, math.max(#stream.left - place, 0)
        stream.left, stream.list, stream.starts = sub(text, place + 1), list, starts
    end

    -- A packet of a channel that is not known to be ours: all of the command that makes it ours, nil where none does.
    -- What may still become a command is kept: whoever types a text sends it letter by letter.
    local function claim(conversation, stream, piece, missing, number)
        local left = stream.left
        local text = left .. piece
        local place, is_whole = claiming.find_command(text, #left, is_command, #text + missing)
        if not place then
            clear(stream)
            return nil
        end
        keep(stream, text, place, number)
        if not is_whole then return nil end
        claiming.begin(conversation)
        local list, joint = stream.list, #left
        clear_sides(conversation)
        if place >= joint then
            starts[number] = place - joint
            return piece
        end
        list[#list] = nil
        for index, before in ipairs(list) do
            is_ours[before] = is_command
            if index == 1 then begun[before] = list end
            if index > 1 then continued[before], earlier[before] = list, index - 1 end
        end
        list.complete_in = number
        continued[number], earlier[number], waiting[number] = list, #list, sub(left, place + 1)
        return waiting[number] .. piece
    end

    -- Whether all of a text waits for more; the newest packet starts at `joint`.
    local function waits(stream, text, joint)
        if stream.step ~= "lost" then
            local part = is_part(text)
            if #text < HEADER_SIZE or part and #text < stream.look_at then return part end
            -- A frame that comes byte by byte is not looked at with each of them.
            stream.look_at = floor(#text * 1.25) + 1
            if not is_length(text, 0) then return false end
            return claiming.judge_split(text, 0, stream.accepts, joint) == PART
        end
        local place, following = claiming.find_step(text, 0, stream.accepts, 0, 0)
        return place == 0 and not following
    end

    -- The first time that a packet is seen: joins it with what waits for it. Returns all of that, and whether some of
    -- it may be whole.
    local function join(stream, piece, number)
        local left = stream.left
        if left ~= "" and is_part(left .. piece) then
            local place, following = claiming.find_step(piece, 0, stream.accepts, 1)
            if place == 0 and following then
                -- Where whole frames begin with the packet, what waits is none.
                clear(stream)
                left = ""
            end
        end
        local text = left .. piece
        if left == "" then return text, true end
        continued[number], earlier[number] = stream.list, #stream.list
        if waits(stream, text, #left) then
            stream.left = text
            table.insert(stream.list, number)
            return text, false
        end
        waiting[number] = left
        stream.list.complete_in = number
        clear(stream)
        return text, true
    end

    local function add_joined(tree, tvb, before, number)
        local said = "EV3: joined with " .. plural(#before, "byte") .. " of earlier packets"
        local item = tree:add(ev3, tvb(), said)
        for index = 1, earlier[number] do
            item:add(field.fragments, continued[number][index]):set_generated()
        end
    end

    -- The part of a frame at the end of a packet.
    local function add_part(tree, tvb, size, number)
        local range = tvb(math.max(tvb:len() - size, 0))
        local item = tree:add(ev3, range, "EV3: part of a frame")
        item:add(field.brick, brick):set_generated()
        item:add(field.fragment, range)
        local list = begun[number] or continued[number]
        if not begun[number] and list then item:add(field.fragments, list[1]):set_generated() end
        if list and list.complete_in then item:add(field.fragment_of, list.complete_in):set_generated() end
    end

    local function dissect_rfcomm(tvb, pinfo, tree)
        local piece, number = bytes_of(tvb), pinfo.number
        if piece == "" then return 0 end
        local is_first = not pinfo.visited
        local conversation, stream, text, may_be_whole
        if is_first then
            conversation, stream = channel_of(pinfo)
            local is_begun = not conversation.is_claimed
            if is_begun then
                text, may_be_whole = claim(conversation, stream, piece, tvb:reported_len() - #piece, number), true
                if not text then return 0 end
                -- It is claimed by a command, so this packet goes to the brick.
                conversation.name, conversation.to_brick = tostring(pinfo.dl_dst), stream
                steps[number] = "sure"
            end
            stream.accepts = stream == conversation.to_brick and is_command or is_from_brick
            if not is_begun then text, may_be_whole = join(stream, piece, number) end
            is_ours[number] = stream.accepts
            if stream.step == "lost" then steps[number] = "lost" end
        elseif is_ours[number] then
            text = (waiting[number] or "") .. piece
            may_be_whole = waiting[number] or not continued[number]
        else
            return 0
        end
        local is_shown, whole, size, offset = has_tree(tree), tvb, #piece, offset_of(tvb)
        brick = is_shown and tostring(is_ours[number] == is_command and pinfo.dl_dst or pinfo.dl_src)
        start_line(number, offset)
        if may_be_whole then
            local before = waiting[number]
            if before then
                whole = ByteArray.new(text, true):tvb("EV3 frames")
                if is_shown then add_joined(tree, tvb, before, number) end
            end
            local state = {
                reported = #text,
                is_last = #piece < tvb:reported_len(),
                step = steps[number] or "likely",
                start = starts[number],
                joint = before and #before or 0,
                first = not before and 0,
                may_gap = true,
                accepts = is_ours[number],
            }
            local after, _, lost, step = dissect_stream(whole, text, state, conversation, number, pinfo, tree, is_shown)
            size = #text - after
            if is_first and size > 0 then
                stream.left, stream.list = sub(text, after + 1), { number }
                begun[number] = stream.list
            end
            if is_first then
                stream.step = step
                if not claiming.count(conversation, lost, number) then clear_sides(conversation) end
            end
        end
        if size > 0 then
            if is_shown then add_part(tree, tvb, size, number) end
            say("part of a frame")
        end
        show(pinfo)
        return #piece
    end

    -- The channel of the serial port profile, whichever side opened it.
    local function register()
        local channels = DissectorTable.get("btrfcomm.dlci")
        channels:add(2 * CARRIERS.rfcomm_channel, ev3)
        channels:add(2 * CARRIERS.rfcomm_channel + 1, ev3)
    end

    carriers.add({ dissectors = { [11] = dissect_rfcomm }, forget = forget_streams, register = register })
end

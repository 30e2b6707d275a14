-- WiFi --------------------------------------------------------------------------------------------------------------
--
-- The beacon in UDP datagrams, and the byte stream of a TCP connection.

do
    local MAX_PORT = 65535

    local tcp_ports = DissectorTable.get("tcp.port")

    -- Lists of addresses by port, each with the `name` of its brick: `announced`, where bricks listen by their beacons;
    -- `bricks`, from where beacons came, at port 0. `answers`: the bricks of the packets to these. `has_found`: whether
    -- connections on other ports were claimed.
    local bricks, answers, announced, has_found

    -- The ports in the preference; without any, the usual one, whose connections are judged.
    local listed = ""

    -- Buffers by place, if unusual: DECLINED if it is not ours; else `asked`, the offset from which on more was
    -- requested before the connection was claimed; or the `step` of the stream, and the number of bytes that were
    -- `done`.
    local buffers
    local DECLINED = {}

    -- The same ports as keys.
    local ports = {}

    -- By both ports: the directions of connections, the newest first, `older` the next one. Their addresses are
    -- compared as objects: the text of an address may become a name. `conversation` is that of both directions.
    -- `pending` has the bytes that wait for the next segment, `step` the step of the stream there, `done` the number of
    -- bytes before them in their buffer; `number` is the last packet. Until the claim, `waits` is the number of waiting
    -- bytes, in which packets begin at `starts`.
    local connections

    local function find_direction(ends, from, to)
        local known = connections[ends]
        while known and (known.from ~= from or known.to ~= to) do known = known.older end
        return known
    end

    -- Returns a packet's conversation, and the packet's direction.
    local function connection_of(pinfo)
        local from, to, port, other = pinfo.src, pinfo.dst, pinfo.src_port, pinfo.dst_port
        local ends = port * 0x10000 + other
        local known = find_direction(ends, from, to)
        if not known then
            local back = find_direction(other * 0x10000 + port, to, from)
            known = { from = from, to = to, older = connections[ends], waits = 0, starts = {} }
            known.conversation = back and back.conversation or dialogues.conversation_of(known)
            if not back then known.conversation.lock = {} end
            connections[ends] = known
        end
        return known.conversation, known
    end

    -- Returns the entry of an address and port in a list of places.
    local function entry_at(places, address, port)
        for _, entry in ipairs(places[port] or {}) do
            if entry.address == address then return entry end
        end
    end

    local function add_entry(places, address, port, name)
        local entry = entry_at(places, address, port)
        if not entry then
            entry = { address = address }
            places[port] = places[port] or {}
            table.insert(places[port], entry)
        end
        entry.name = name
    end

    local function forget_wifi()
        bricks, answers, announced, has_found = {}, {}, {}, false
        buffers, connections = {}, {}
    end

    -- Which types go to the brick and which come from it. Bricks in a chain send commands both ways.
    local function goes_to_brick(type) return type.is_command or type.carries == "daisy" end

    local function comes_from_brick(type) return not type.is_command or type.carries == "daisy" end

    local dissect_claimed
    do
        -- Returns the step of the stream at a buffer in the first pass, how many bytes of the buffer came before, and
        -- how many of these are done: TCP passes bytes on again if a frame in them is incomplete. TCP joins segments
        -- only if nothing is missing between them: then the buffer has the offset 0 and begins with what waits. Bytes
        -- that wait and are not joined were before a gap. Otherwise a frame starts where the last one ended.
        local function first_step(known, text, offset, number)
            local pending, before, is_further = known.pending, known.step, number == known.number
            known.pending, known.number = nil, number
            if offset > 0 then return pending and not is_further and "lost" or before or "sure", 0, 0 end
            for _, done in ipairs({ 0, known.done }) do
                if pending and sub(text, done + 1, done + #pending) == pending then
                    return before, done + #pending, done
                end
            end
            return "sure", 0, 0
        end

        -- The same in any pass; `known`, the direction, is given in the first pass only.
        local function step_of(known, text, offset, number, start)
            local place = storage.place_of(number, offset)
            if not known then
                local buffer = buffers[place] or {}
                return buffer.step or "sure", buffer.joint or 0, buffer.done or 0
            end
            local step, joint, done = "sure", 0, start
            if start then
                known.number = number
            else
                step, joint, done = first_step(known, text, offset, number)
            end
            if step ~= "sure" or done > 0 or joint > 0 then
                buffers[place] = { step = step, done = done, joint = joint }
            end
            return step, joint, done
        end

        -- A command with a wrong length is shown at once, as nothing more may come. If the next segment completes a
        -- right one, they are joined here, unless the brick sent anything in between. Returns the buffer, its bytes,
        -- and how many of them came before.
        local function join(conversation, known, tvb, text, place)
            local short, buffer = known and conversation.short, buffers[place]
            if short then conversation.short = nil end
            local held = short and short.side == known and short
            if held and claiming.is_sensible(messages.read_at(held.text .. text, 0)) then
                buffer, buffers[held.place] = { before = held.text }, { is_part = true }
                buffers[place] = buffer
            end
            local before = buffer and buffer.before
            if not before then return tvb, text, 0 end
            return ByteArray.new(before .. text, true):tvb("EV3 frame"), before .. text, #before
        end

        -- Dissects a buffer of a claimed connection; `start` is where the claim begins, if in this buffer.
        function dissect_claimed(tvb, text, pinfo, tree, number, conversation, known, start)
            local size, offset, earlier = #text, offset_of(tvb), nil
            local place, whole = storage.place_of(number, offset), tvb
            whole, text, earlier = join(conversation, known, tvb, text, place)
            local captured = #text
            if known and known.claims ~= conversation.claims then
                known.claims, known.pending, known.step, known.number = conversation.claims, nil, nil, nil
            end
            local step, joint, done = step_of(known, text, offset, number, start)
            local brick = has_tree(tree) and (conversation or connection_of(pinfo)).name
            start_line(number, offset)
            -- Nearly every buffer is exactly one frame.
            local lost = 0
            if step == "sure" and joint == 0 and done == 0 and MESSAGE_TYPES[byte(text, HEADER_SIZE)]
                and stop_of(text, 0) == captured and is_usual_length(captured - LENGTH_FIELD) then
                say((dissect_message(whole, 0, messages.read(text), conversation, place, pinfo, tree, brick)))
            elseif buffers[place] and buffers[place].is_part then
                say("part of a frame")
                if brick then add_item(tree, tvb(), brick, "part of a frame"):add(field.fragment, tvb()) end
            else
                local reported = whole:reported_len()
                local named = conversation or connection_of(pinfo)
                local is_sent = named.port == pinfo.dst_port and named.address == pinfo.dst
                local stream = {
                    tvb = whole, text = text, conversation = conversation, number = number, pinfo = pinfo, tree = tree,
                    brick = brick, reported = reported, is_last = captured < reported or pinfo.can_desegment == 0,
                    step = step, start = done, joint = joint, sent = joint, first = 0,
                    accepts = is_sent and goes_to_brick or comes_from_brick,
                }
                local after, wanted = streaming.dissect(stream)
                lost = stream.lost
                if after < captured then
                    pinfo.desegment_offset = after - earlier
                    pinfo.desegment_len = wanted or DESEGMENT_ONE_MORE_SEGMENT
                end
                if known then
                    known.pending = after < captured and sub(text, after + 1) or nil
                    known.step, known.done = stream.step, after
                    local is_short = captured == reported and after == captured and (stop_of(text, 0) or 0) > captured
                    conversation.short = is_short and { side = known, text = text, place = place } or nil
                end
            end
            if known then claiming.count(conversation, lost, number) end
            show(pinfo, tvb, tree)
            return size
        end
    end

    -- Tells whether a beacon announced this port.
    local function is_announced(address, port) return entry_at(announced, address, port) ~= nil end

    -- Returns the address and port of the brick to which a packet goes or from which it comes.
    local function brick_end(pinfo, to_brick)
        if to_brick then return pinfo.dst, pinfo.dst_port end
        return pinfo.src, pinfo.src_port
    end

    -- Names a connection after its brick.
    local function name_brick(conversation, pinfo, to_brick)
        local address, port = brick_end(pinfo, to_brick)
        conversation.name = plain_address(address) .. ":" .. port
        conversation.address, conversation.port = address, port
    end

    local dissect_first
    do
        -- Tells whether an end of a connection may be a brick, by its port.
        local function may_be_brick(address, port)
            return ports[port] or is_announced(address, port)
        end

        -- Tells whether data go to the brick, if both ends may be one by their ports.
        local function tells_brick(text, is_text, pinfo)
            if is_text then return byte(text, 1) == byte(UNLOCK.request, 1) end
            local type = MESSAGE_TYPES[byte(text, HEADER_SIZE)]
            if not type or type.carries == "daisy" then return pinfo.match_uint == pinfo.dst_port end
            return type.is_command
        end

        -- Judges a buffer of a connection that is not claimed, in the first pass: CHAIN, with the offset where ours
        -- begins; OPEN, with the offset from which on more is needed; or anything else.
        local function claim(conversation, known, text, reported, offset, pinfo)
            local to_brick = may_be_brick(pinfo.dst, pinfo.dst_port)
            if not to_brick and not may_be_brick(pinfo.src, pinfo.src_port) then return nil end
            local verdict, found, place = streaming.judge_text(text), CHAIN, 0
            if verdict == PART then return OPEN, 0 end
            -- If the preference includes the ports of both ends, as a wide range may, the data tell which is the brick.
            if verdict == OURS or ports[pinfo.src_port] and ports[pinfo.dst_port] then
                to_brick = tells_brick(text, verdict ~= nil, pinfo)
            end
            -- The user's preference, or a beacon, is sure.
            if verdict == OURS or listed ~= "" or is_announced(brick_end(pinfo, to_brick)) then
                claiming.begin(conversation, "sure")
            else
                local function adopt(number, first)
                    buffers[storage.place_of(number, offset)] = { step = "sure", done = first }
                    return offset
                end
                found, place = claiming.judge(conversation, pinfo, {
                    side = known, to_brick = to_brick, text = text, starts = known.starts, reported = reported,
                    begins = claiming.begins, adopt = adopt,
                })
                if found ~= CHAIN then return found, place end
            end
            conversation.claimed_in = pinfo.number
            name_brick(conversation, pinfo, to_brick)
            return CHAIN, place
        end

        -- Requests the rest of a possible frame or text, from an offset on.
        local function ask_for_more(known, text, place, pinfo)
            local starts = {}
            for _, start in ipairs(known.starts) do
                if start >= place then starts[#starts + 1] = start - place end
            end
            pinfo.desegment_offset, pinfo.desegment_len = place, DESEGMENT_ONE_MORE_SEGMENT
            known.waits, known.starts = #text - place, starts
        end

        function dissect_first(tvb, text, pinfo, tree, number, is_all)
            local conversation, known = connection_of(pinfo)
            -- Wireshark may offer a declined buffer again, for the port of the other end.
            local offset, reported = offset_of(tvb), tvb:reported_len()
            local place = storage.place_of(number, offset)
            if buffers[place] == DECLINED then return 0 end
            local port = pinfo.match_uint
            if not conversation.name and (is_all or not ports[port]) then
                name_brick(conversation, pinfo, pinfo.dst_port == port)
                claiming.begin(conversation, "sure")
            end
            if claiming.is_claimed(conversation) then
                return dissect_claimed(tvb, text, pinfo, tree, number, conversation, known)
            end
            if offset > 0 then known.waits, known.starts = 0, {} end
            table.insert(known.starts, known.waits)
            local found, at = claim(conversation, known, text, reported, offset, pinfo)
            if found == OPEN and #text == reported and pinfo.can_desegment > 0 then
                ask_for_more(known, text, at, pinfo)
                buffers[place] = { asked = at }
                return #text
            end
            -- More may have been requested for the same packet before.
            known.waits, known.starts, buffers[place] = 0, {}, nil
            if found ~= CHAIN then
                buffers[place] = DECLINED
                return 0
            end
            return dissect_claimed(tvb, text, pinfo, tree, number, conversation, known, at)
        end
    end

    local function dissect_tcp(tvb, pinfo, tree, is_all)
        local text, number = bytes_of(tvb), pinfo.number
        if not pinfo.visited then return dissect_first(tvb, text, pinfo, tree, number, is_all) end
        local buffer = buffers[storage.place_of(number, offset_of(tvb))]
        if buffer == DECLINED then return 0 end
        if buffer and buffer.asked then
            pinfo.desegment_offset, pinfo.desegment_len = buffer.asked, DESEGMENT_ONE_MORE_SEGMENT
            return #text
        end
        if has_found then
            local conversation = connection_of(pinfo)
            if conversation.is_found and number < conversation.claimed_in then return 0 end
        end
        return dissect_claimed(tvb, text, pinfo, tree, number)
    end

    -- Claims a connection on any other port after a beacon that names the port, or from the unlock text on. Wireshark
    -- then passes all packets of the conversation to us; in later passes also those before.
    local function guess_tcp(tvb, pinfo, tree)
        if pinfo.visited then return false end
        local to_brick, size = is_announced(pinfo.dst, pinfo.dst_port), #UNLOCK.request
        if not to_brick and not is_announced(pinfo.src, pinfo.src_port) then
            if tvb:len() <= size or bytes_of(tvb, 0, size) ~= UNLOCK.request then return false end
            local verdict = streaming.judge_text(bytes_of(tvb))
            if verdict == PART and pinfo.can_desegment > 0 then
                pinfo.desegment_offset, pinfo.desegment_len = 0, DESEGMENT_ONE_MORE_SEGMENT
                return true
            end
            if verdict ~= OURS then return false end
            to_brick = true
        end
        local conversation, known = connection_of(pinfo)
        pinfo.conversation = ev3
        claiming.begin(conversation, "sure")
        conversation.is_found, conversation.claimed_in, has_found = true, pinfo.number, true
        name_brick(conversation, pinfo, to_brick)
        dissect_claimed(tvb, bytes_of(tvb), pinfo, tree, pinfo.number, conversation, known)
        return true
    end

    local dissect_udp
    do
        local function remember_brick(pinfo, named)
            local address = pinfo.src
            local name = plain_address(address) .. ":" .. (named or pinfo.src_port)
            add_entry(bricks, address, 0, name)
            if named then add_entry(announced, address, named, name) end
        end

        local function dissect_beacon(tvb, text, tree, pinfo)
            local item = has_tree(tree) and add_item(tree, tvb(), nil, "beacon")
            local at, values, port = 0, {}, nil
            for _, line in ipairs(CARRIERS.beacon_lines) do
                local head = line.label .. ": "
                local stop = find(text, "\r\n", at + 1, true)
                if not stop or sub(text, at + 1, at + #head) ~= head then
                    local kind = is_cut_by_capture(tvb, tvb:len(), pinfo) and "cut_by_capture" or "fault"
                    complain(item or tree, kind, format("at offset %d: expected a line '%s...'", at, head))
                    break
                end
                local value = sub(text, at + #head + 1, stop - 1)
                values[#values + 1] = phrases.on_one_line(value)
                local number = line.name == "port" and tonumber(value:match("^%d%d?%d?%d?%d?$") or 0) or 0
                if number > 0 and number <= MAX_PORT then port = number end
                local range = tvb(at + #head, #value)
                if item then item:add(field["beacon_" .. line.name], range, reading.utf8_text(value)) end
                at = stop + 1
            end
            local said = "beacon: " .. concat(values, " ")
            if item then item:set_text("EV3: " .. said) end
            if item and port then item:add(field.brick, plain_address(pinfo.src) .. ":" .. port):set_generated() end
            return said, port
        end

        -- Tells whether a datagram is a beacon: it begins with the labels of the first two lines, unless truncated, and
        -- does not name another protocol. With Decode As the first label is enough.
        local function is_beacon(tvb, text, is_forced)
            local lines = CARRIERS.beacon_lines
            local first, second, last = lines[1].label .. ": ", lines[2].label .. ": ", lines[#lines].label .. ": "
            if sub(text, 1, #first) ~= first then return false end
            if is_forced then return true end
            local rest = text:match("\r\n(.*)") or ""
            local is_cut = tvb:len() < tvb:reported_len()
            if sub(rest, 1, #second) ~= second and not (is_cut and sub(second, 1, #rest) == rest) then return false end
            local protocol = rest:match("\r\n" .. last .. "([^\r]*)") or ""
            return sub(CARRIERS.protocol, 1, #protocol) == protocol
        end

        -- Dissects a brick's beacon, or a host's answer to it from or to the port of beacons.
        function dissect_udp(tvb, pinfo, tree)
            local text, number = tvb:raw(), pinfo.number
            local is_forced = pinfo.match_uint ~= CARRIERS.beacon_port and pinfo.match_uint ~= 0
            local said, port
            if is_beacon(tvb, text, is_forced) then
                said, port = dissect_beacon(tvb, text, tree, pinfo)
                if not pinfo.visited then remember_brick(pinfo, port) end
            else
                if not pinfo.visited then answers[number] = (entry_at(bricks, pinfo.dst, 0) or {}).name end
                local brick = answers[number]
                said = "answer to a beacon"
                if not brick and not is_forced then return 0 end
                if has_tree(tree) then add_item(tree, tvb(), brick, said):add(field.beacon_answer, tvb()) end
            end
            start_line(number, tvb:offset())
            say(said)
            show(pinfo, tvb, tree)
            return tvb:len()
        end
    end

    -- Registers the ports of the preference, such as 5555,6000-6003.
    local function take_ports()
        local taken = listed ~= "" and listed or tostring(CARRIERS.tcp_port)
        tcp_ports:add(taken, ev3)
        ports = {}
        for first, last in taken:gmatch("(%d+)%-?(%d*)") do
            for port = tonumber(first), tonumber(last ~= "" and last or first) do
                ports[port] = true
            end
        end
    end

    local function follow_ports()
        if listed == ev3.prefs.tcp_ports then return end
        tcp_ports:remove(listed ~= "" and listed or tostring(CARRIERS.tcp_port), ev3)
        listed = ev3.prefs.tcp_ports
        take_ports()
    end

    local function register()
        local text = "TCP ports on which bricks listen: all their traffic is shown. By default, port "
            .. CARRIERS.tcp_port .. " is judged by its contents"
        ev3.prefs.tcp_ports = Pref.range("TCP ports", listed, text, MAX_PORT)
        take_ports()
        tcp_ports:add_for_decode_as(ev3_all)
        ev3:register_heuristic("tcp", guess_tcp)
        DissectorTable.get("udp.port"):add(CARRIERS.beacon_port, ev3)
    end

    dissectors[2], dissectors[3] = dissect_tcp, dissect_udp
    carriers[#carriers + 1] = { forget = forget_wifi, register = register, prefs_changed = follow_ports }
end

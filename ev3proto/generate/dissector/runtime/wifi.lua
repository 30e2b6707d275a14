-- WiFi --------------------------------------------------------------------------------------------------------------
--
-- The beacon in UDP datagrams, then the byte stream of a TCP connection.

do
    local MAX_PORT = 65535

    local tcp_ports = DissectorTable.get("tcp.port")

    -- Methods that each packet needs: looking them up takes longer than what they do.
    local bytes_of, offset_of = Tvb.raw, Tvb.offset

    -- Where answers to beacons go to, with the brick there, and the packets that went there; the places where bricks
    -- listen by what their beacons say; the buffers that were left to others; whether connections on other ports were
    -- found to be ours.
    local bricks, answers, announced, declined, has_found

    -- The ports that the preference names.
    local listened = tostring(CARRIERS.tcp_port)

    -- By buffer: the `step` of the stream and how many bytes were `done`, where they are not as usual; from where on
    -- more was asked for, before it was ours.
    local steps, asked

    -- The ports on which connections are looked at.
    local ports = {}

    -- By ports: the direction in a connection that was seen last between them. It has what is `pending` of the stream
    -- that way, the bytes that wait for the next segment; the `step` with them; how many bytes of the buffer were
    -- `done` before them; the packet `number` that came last, and at which `offset` its data began.
    local connections

    -- Both ends of a connection, whichever sends, have one key.
    local function conversation_key(pinfo)
        local from = tostring(pinfo.src) .. " " .. pinfo.src_port
        local to = tostring(pinfo.dst) .. " " .. pinfo.dst_port
        return from < to and from .. " " .. to or to .. " " .. from
    end

    -- What is known of a packet's conversation, and of its direction in that. To compare addresses takes less than to
    -- write them.
    local function connection_of(pinfo)
        local from, to, ends = pinfo.src, pinfo.dst, pinfo.src_port * 0x10000 + pinfo.dst_port
        local known = connections[ends]
        if not known or known.from ~= from or known.to ~= to then
            local conversation = conversation_of(conversation_key(pinfo))
            conversation.sides = conversation.sides or {}
            known = conversation.sides[ends] or { from = from, to = to, conversation = conversation }
            conversation.sides[ends], connections[ends] = known, known
        end
        return known.conversation, known
    end

    local function forget_wifi()
        bricks, answers, announced, declined, has_found = {}, {}, {}, {}, false
        steps, asked, connections = {}, {}, {}
    end
    forget_wifi()

    -- Whether the preference names the ports of both ends, as a wide range may: the data tell which end is the brick.
    local function has_two_named(pinfo)
        return ports[pinfo.src_port] and ports[pinfo.dst_port]
    end

    -- Whether a packet goes to the end that its connection is named after.
    local function is_to_named(conversation, pinfo)
        return conversation.name == tostring(pinfo.dst) .. ":" .. pinfo.dst_port
    end

    -- How many bytes a frame wants that was asked for segment by segment, where Wireshark gave one byte of the next one
    -- alone. So it does since 4.4, once the one before came twice; the rest it gives when told how much that is. The
    -- newest segment starts at `joint`, and data in a packet at `offset`.
    local function rest_of(text, joint, offset, pinfo)
        if joint == 0 or #text ~= joint + 1 or #text < HEADER_SIZE then return nil end
        if not offset or pinfo.len <= offset + 1 then return nil end
        local rest = LENGTH_FIELD + unsigned16(text, 0) - #text
        return rest > 0 and rest or nil
    end

    -- Which types go to the brick and which come from it. Bricks in a chain send commands both ways.
    local function is_command(type)
        return type.is_command or type.carries == "daisy"
    end

    local function is_reply(type)
        return not type.is_command or type.carries == "daisy"
    end

    local dissect_claimed
    do
        -- Which types go the way of a packet.
        local function types_of(pinfo, conversation)
            return is_to_named(conversation or connection_of(pinfo), pinfo) and is_command or is_reply
        end

        -- The step of a buffer that is seen for the first time, how many bytes of it were there before, and how many of
        -- these are done: TCP hands some over again if a frame that begins in them is not whole yet. It joins segments
        -- if that was asked for; such a buffer has an offset of 0, others come after their headers.
        local function first_step(known, text, offset, number)
            local pending, before, is_further = known.pending, known.step, number == known.number
            known.pending, known.number = nil, number
            if offset > 0 then
                known.offset = offset
                -- What was asked for did not come if something is pending.
                if before == "lost" or pending and not is_further then return "lost", 0, 0 end
                return is_further and "sure" or "likely", 0, 0
            end
            for _, done in ipairs({ 0, known.done }) do
                if pending and sub(text, done + 1, done + #pending) == pending then
                    return before, done + #pending, done
                end
            end
            return "likely", 0, 0
        end

        -- The step of the stream at a buffer, how many bytes of it were there before, and how many are done. `known` is
        -- what is known of the stream, when the buffer is seen for the first time.
        local function step_of(known, text, offset, number, start)
            local place, usual = place_of(number, offset), offset == 0 and "sure" or "likely"
            if not known then
                local found = steps[place]
                if found then return found.step, 0, found.done end
                return usual, 0, 0
            end
            local step, joint, done = "sure", 0, start
            if start then
                known.number, known.offset = number, offset > 0 and offset or nil
            else
                step, joint, done = first_step(known, text, offset, number)
            end
            if step ~= usual or done > 0 then steps[place] = { step = step, done = done } end
            return step, joint, done
        end

        -- A buffer of a connection that is ours; `start` is where that begins, if it does in this one.
        function dissect_claimed(tvb, text, pinfo, tree, number, conversation, known, start)
            local captured, offset, is_shown = #text, offset_of(tvb), has_tree(tree)
            if known and known.claims ~= conversation.claims then
                known.claims, known.pending, known.step = conversation.claims, nil, nil
                known.number, known.offset = nil, nil
            end
            local step, joint, done = step_of(known, text, offset, number, start)
            brick = is_shown and (conversation or connection_of(pinfo)).name
            start_line(number, offset)
            -- Nearly always one frame is all there is.
            local low, high, _, _, code = byte(text, 1, HEADER_SIZE)
            local lost = 0
            if step ~= "lost" and done == 0 and code and LENGTH_FIELD + low + high * 0x100 == captured
                and is_usual_length(low, high) and MESSAGE_TYPES[code] then
                local place = place_of(number, offset)
                say((dissect_message(tvb, 0, read_message(text), conversation, place, pinfo, tree, is_shown)))
            else
                local reported = tvb:reported_len()
                local stream = {
                    reported = reported,
                    is_last = captured < reported or pinfo.can_desegment == 0,
                    step = step,
                    start = done,
                    joint = joint,
                    first = 0,
                    accepts = types_of(pinfo, conversation),
                }
                local after, wanted
                after, wanted, lost, step =
                    dissect_stream(tvb, text, stream, conversation, number, pinfo, tree, is_shown)
                if after < captured then
                    if not wanted and known and after == 0 and step == "likely" then
                        wanted = rest_of(text, joint, known.offset, pinfo)
                    end
                    pinfo.desegment_offset = after
                    pinfo.desegment_len = wanted or DESEGMENT_ONE_MORE_SEGMENT
                end
                if known then
                    known.pending = after < captured and sub(text, after + 1) or nil
                    known.step, known.done = step, after
                end
            end
            if known then claiming.count(conversation, lost, number) end
            show(pinfo)
            return captured
        end
    end

    -- Whether a beacon said that a brick listens there.
    local function is_announced(address, port)
        return next(announced) ~= nil and announced[tostring(address) .. " " .. port] == true
    end

    -- A connection is named after the end of it that is the brick.
    local function name_brick(conversation, address, port)
        conversation.name = tostring(address) .. ":" .. port
    end

    local dissect_first
    do
        -- Whether a brick listens at an end of a connection, as far as the ports tell.
        local function may_be_brick(address, port)
            return ports[port] or is_announced(address, port)
        end

        -- Whether data go to the brick, where the ports of both ends may be one's.
        local function tells_brick(text, is_text, pinfo)
            if is_text then return byte(text, 1) == byte(UNLOCK.request, 1) end
            local type = MESSAGE_TYPES[byte(text, HEADER_SIZE)]
            if not type or type.carries == "daisy" then return pinfo.match_uint == pinfo.dst_port end
            return type.is_command
        end

        -- Whether the user, or a beacon, says that what is at a port is ours: else it must show.
        local function is_sure(address, port)
            return listened ~= tostring(CARRIERS.tcp_port) or is_announced(address, port)
        end

        -- A buffer of a connection that is not ours so far, when it is seen for the first time: whether it is, with the
        -- offset where that begins, or whether more is needed to tell, from an offset on.
        local function claim(conversation, known, text, reported, pinfo)
            local to_brick = may_be_brick(pinfo.dst, pinfo.dst_port)
            if not to_brick and not may_be_brick(pinfo.src, pinfo.src_port) then return nil end
            local verdict, place = judge_text(text), 0
            if verdict == PART then return PART, 0 end
            if verdict == OURS or has_two_named(pinfo) then to_brick = tells_brick(text, verdict ~= nil, pinfo) end
            local address, port = pinfo.src, pinfo.src_port
            if to_brick then
                address, port = pinfo.dst, pinfo.dst_port
            end
            local joint = known.waits or 0
            if verdict == OURS or is_sure(address, port) then
                claiming.begin(conversation, true)
            elseif to_brick then
                local is_whole
                place, is_whole = claiming.find_command(text, joint, is_command, reported)
                -- Others have their packets at once, unless a command may begin with one.
                local is_waited = place and not is_whole and (conversation.has_ended or place == 0 or place == joint)
                if not is_whole then return is_waited and PART or nil, place end
                claiming.begin(conversation)
            else
                local count = claiming.count_replies(text)
                conversation.replies = count > 0 and (conversation.replies or 0) + count or 0
                if conversation.replies < CLAIMS.replies then return nil end
                claiming.begin(conversation)
                conversation.replies = 0
            end
            conversation.claimed_in = pinfo.number
            name_brick(conversation, address, port)
            return OURS, place
        end

        -- Asks for more of what may become a frame or a text, from an offset on.
        local function ask_for_more(known, text, place, offset, pinfo)
            local joint = offset == 0 and known.waits or 0
            local rest = place == 0 and rest_of(text, joint, known.begins, pinfo)
            pinfo.desegment_offset, pinfo.desegment_len = place, rest or DESEGMENT_ONE_MORE_SEGMENT
            known.waits = #text - place
            if offset > 0 then known.begins = offset end
        end

        function dissect_first(tvb, text, pinfo, tree, number)
            local conversation, known = connection_of(pinfo)
            -- What was left to others comes again, where Wireshark knows which end is the server.
            local place = place_of(number, offset_of(tvb))
            if declined[place] then return 0 end
            local port = pinfo.match_uint
            if not conversation.name and not ports[port] then
                name_brick(conversation, pinfo.dst_port == port and pinfo.dst or pinfo.src, port)
                claiming.begin(conversation, true)
            end
            if conversation.is_claimed then
                return dissect_claimed(tvb, text, pinfo, tree, number, conversation, known)
            end
            if offset_of(tvb) > 0 then known.waits = 0 end
            local verdict, at = claim(conversation, known, text, tvb:reported_len(), pinfo)
            if verdict == PART and #text == tvb:reported_len() and pinfo.can_desegment > 0 then
                ask_for_more(known, text, at, offset_of(tvb), pinfo)
                asked[place] = at
                return #text
            end
            -- The same packet may have been asked for more before.
            known.waits, asked[place] = 0, nil
            if verdict ~= OURS then
                declined[place] = true
                return 0
            end
            return dissect_claimed(tvb, text, pinfo, tree, number, conversation, known, at)
        end
    end

    local function dissect_tcp(tvb, pinfo, tree)
        local text, number = bytes_of(tvb), pinfo.number
        if not pinfo.visited then return dissect_first(tvb, text, pinfo, tree, number) end
        if next(declined) and declined[place_of(number, tvb:offset())] then return 0 end
        local place = next(asked) and asked[place_of(number, offset_of(tvb))]
        if place then
            pinfo.desegment_offset, pinfo.desegment_len = place, DESEGMENT_ONE_MORE_SEGMENT
            return #text
        end
        if has_found then
            local conversation = connection_of(pinfo)
            if conversation.is_found and number < conversation.claimed_in then return 0 end
        end
        return dissect_claimed(tvb, text, pinfo, tree, number)
    end

    -- A connection on any other port is ours after a beacon that names the port, or from the unlock text on. Wireshark
    -- then hands us all packets of the conversation, in later passes those before, too.
    local function guess_tcp(tvb, pinfo, tree)
        if pinfo.visited then return false end
        local to_brick, size = is_announced(pinfo.dst, pinfo.dst_port), #UNLOCK.request
        if not to_brick and not is_announced(pinfo.src, pinfo.src_port) then
            if tvb:len() <= size or bytes_of(tvb, 0, size) ~= UNLOCK.request then return false end
            local verdict = judge_text(bytes_of(tvb))
            if verdict == PART and pinfo.can_desegment > 0 then
                pinfo.desegment_offset, pinfo.desegment_len = 0, DESEGMENT_ONE_MORE_SEGMENT
                return true
            end
            if verdict ~= OURS then return false end
            to_brick = true
        end
        local conversation, known = connection_of(pinfo)
        pinfo.conversation = ev3
        claiming.begin(conversation, true)
        conversation.is_found, conversation.claimed_in, has_found = true, pinfo.number, true
        if to_brick then
            name_brick(conversation, pinfo.dst, pinfo.dst_port)
        else
            name_brick(conversation, pinfo.src, pinfo.src_port)
        end
        dissect_claimed(tvb, bytes_of(tvb), pinfo, tree, pinfo.number, conversation, known)
        return true
    end

    local dissect_udp, guess_udp
    do
        -- Where the host may send its answer: to the port that the beacon came from, the one that it names, or its own.
        local function remember_brick(pinfo, named)
            local address = tostring(pinfo.src) .. " "
            local name = tostring(pinfo.src) .. ":" .. (named or pinfo.src_port)
            bricks[address .. pinfo.src_port], bricks[address .. CARRIERS.beacon_port] = name, name
            if named then bricks[address .. named], announced[address .. named] = name, true end
        end

        -- The port that a beacon names, nil where there can be none of that number.
        local function port_of(value)
            local port = value:match("^%d%d?%d?%d?%d?$") and tonumber(value)
            return port and port > 0 and port <= MAX_PORT and port or nil
        end

        local function dissect_beacon(tvb, text, tree, address)
            local item = has_tree(tree) and add_item(tree, tvb(), "beacon")
            local at, values = 0, {}
            local port
            for _, line in ipairs(CARRIERS.beacon_lines) do
                local head = line.label .. ": "
                local stop = find(text, "\r\n", at + 1, true)
                if not stop or sub(text, at + 1, at + #head) ~= head then
                    complain(item or tree, "fault", format("at offset %d: expected a line '%s...'", at, head))
                    break
                end
                local value = sub(text, at + #head + 1, stop - 1)
                values[#values + 1] = on_one_line(value)
                if line.name == "port" then port = port_of(value) end
                local range = tvb(at + #head, #value)
                if item then item:add(beacon_field[line.name], range, utf8_text(value)) end
                at = stop + 1
            end
            local said = "beacon: " .. concat(values, " ")
            if item then item:set_text("EV3: " .. said) end
            if item and port then item:add(field.brick, address .. ":" .. port):set_generated() end
            return said, port
        end

        -- Whether a datagram begins with the labels of a beacon's first two lines, as far as it was captured, and names
        -- no other protocol. By Decode As the first label is enough.
        local function is_beacon(tvb, text, is_forced)
            local lines = CARRIERS.beacon_lines
            local first, second, last = lines[1].label .. ": ", lines[2].label .. ": ", lines[#lines].label .. ": "
            if sub(text, 1, #first) ~= first then return false end
            if is_forced then return true end
            local _, stop = find(text, "\r\n", 1, true)
            local rest = stop and sub(text, stop + 1) or ""
            local is_cut = tvb:len() < tvb:reported_len()
            if sub(rest, 1, #second) ~= second and not (is_cut and sub(second, 1, #rest) == rest) then return false end
            local _, before = find(rest, "\r\n" .. last, 1, true)
            local protocol = before and rest:match("^[^\r]*", before + 1) or ""
            return sub(CARRIERS.protocol, 1, #protocol) == protocol
        end

        -- The brick whose beacon a packet answers, if it does.
        local function answered_brick(pinfo)
            if not pinfo.visited and next(bricks) then
                answers[pinfo.number] = bricks[tostring(pinfo.dst) .. " " .. pinfo.dst_port]
            end
            return answers[pinfo.number]
        end

        -- A beacon that a brick broadcasts, or whatever a host answers to it.
        function dissect_udp(tvb, pinfo, tree)
            local text, number = tvb:raw(), pinfo.number
            brick = nil
            local is_forced = pinfo.match_uint ~= CARRIERS.beacon_port and pinfo.match_uint ~= 0
            local said
            if is_beacon(tvb, text, is_forced) then
                local port
                said, port = dissect_beacon(tvb, text, tree, tostring(pinfo.src))
                if not pinfo.visited then remember_brick(pinfo, port) end
            else
                brick, said = answered_brick(pinfo), "answer to a beacon"
                if not brick and not is_forced then return 0 end
                if has_tree(tree) then add_item(tree, tvb(), said):add(field.beacon_answer, tvb()) end
            end
            start_line(number, tvb:offset())
            say(said)
            show(pinfo)
            return tvb:len()
        end

        -- An answer goes to the port that the beacon came from, which is known by nothing else.
        function guess_udp(tvb, pinfo, tree)
            if not answered_brick(pinfo) then return false end
            dissect_udp(tvb, pinfo, tree)
            return true
        end
    end

    -- Takes the ports of the preference, such as 5555,6000-6003.
    local function take_ports()
        tcp_ports:add(listened, ev3)
        ports = {}
        for first, last in listened:gmatch("(%d+)%-?(%d*)") do
            for port = tonumber(first), tonumber(last ~= "" and last or first) do
                ports[port] = true
            end
        end
    end

    local function follow_ports()
        if listened == ev3.prefs.tcp_ports then return end
        tcp_ports:remove(listened, ev3)
        listened = ev3.prefs.tcp_ports
        take_ports()
    end

    local function register()
        ev3.prefs.tcp_ports = Pref.range("TCP ports", listened, "TCP ports on which bricks listen", MAX_PORT)
        take_ports()
        ev3:register_heuristic("tcp", guess_tcp)
        DissectorTable.get("udp.port"):add(CARRIERS.beacon_port, ev3)
        ev3:register_heuristic("udp", guess_udp)
    end

    carriers.add({
        dissectors = { [2] = dissect_tcp, [3] = dissect_udp },
        forget = forget_wifi,
        prefs_changed = follow_ports,
        register = register,
    })
end

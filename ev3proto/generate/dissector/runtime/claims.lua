-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Decides which conversations are a brick's, since other protocols use the same ports and channels. The rule is in
-- ev3proto's tables. Decisions are made in the first pass, and kept.

-- Results of judging data: OURS; PART if more is needed to decide; nil if they are not a brick's.
local OURS, PART = "ours", "part"

-- Results of searching them: CHAIN, a plausible command; SINGLE, whole frames that a reply may prove; OPEN, bytes that
-- may become a command.
local CHAIN, SINGLE, OPEN = "chain", "single", "open"

do
    -- Reads operations from an offset on. `judge` gets the opcode of each, `visit` each argument. Returns nil, or the
    -- kind of the fault that ends them, and its operation. `set` has the instructions, by default the preferred ones.
    function claiming.scan(text, at, stop, judge, visit, set)
        while at < stop do
            local code = byte(text, at + 1)
            if code == CLAIMS.never_sent then return "fault" end
            local operation, after, _, reason, kind = reading.read_operation(text, at, visit, set)
            if operation and judge then judge(code) end
            if reason then return kind, operation end
            at = after
        end
    end

    -- Tells whether a frame has no fault and a meaning: empty commands and impossible layers have none.
    function claiming.is_sensible(message)
        local type, text = message.type, message.text
        if not type or message.stop < message.size or message.fault then return false end
        if type.carries == "daisy" then
            local at = HEADER_SIZE + (type.is_command and 2 or 1)
            local from, to = byte(text, at, at + 1)
            if not to or type.is_command and not DAISY.names[byte(text, HEADER_SIZE + 1)] then return false end
            return math.max(from, to) <= DAISY.most_layers
        end
        if type.carries ~= "direct" or not type.is_command then return true end
        return message.stop > COMMAND_HEADER_SIZE and not claiming.scan(text, COMMAND_HEADER_SIZE, message.stop)
    end

    -- Tells whether an argument has a kind and range that its parameter accepts; `sizes` is the requested memory, by
    -- scope.
    local function is_in_place(parameter, encoding, value, sizes)
        if encoding.scope then return value < sizes[encoding.kind] end
        local wrong = phrases.judge(parameter, encoding, value)
        return not (value == 0 and parameter.is_set) and (not wrong or CLAIMS.still_sent[wrong] == true)
    end

    -- The same for all operations of a direct command by a firmware's instructions; at least one must be evidence.
    local function fits(text, stop, is_cut, set)
        local sizes, is_right, is_telling = {}, true, false
        sizes[GLOBAL], sizes[LOCAL] = reading.memory_sizes(text)
        local function visit(parameter, encoding, value)
            is_right = is_right and is_in_place(parameter, encoding, value, sizes)
        end
        local function judge(code)
            if CLAIMS.only_in_programs[code] then is_right = false end
            if not CLAIMS.not_telling[code] then is_telling = true end
        end
        local kind = claiming.scan(text, COMMAND_HEADER_SIZE, stop, judge, visit, set)
        return is_right and is_telling and (not kind or is_cut and kind == "cut_off")
    end

    -- Tells whether a message is a plausible command by the instructions of some firmware. With `is_cut` the capture
    -- has only its beginning, which then counts.
    function claiming.is_plausible(message, is_cut)
        local type, stop = message.type, message.stop
        if not type or not type.is_command then return false end
        if not is_cut and (stop < message.size or message.fault) then return false end
        if type.carries == "direct" then
            if stop < COMMAND_HEADER_SIZE then return false end
            for _, set in pairs(INSTRUCTION_SETS) do
                if fits(message.text, stop, is_cut, set) then return true end
            end
            return false
        end
        if is_cut then return false end
        if type.carries == "daisy" then return claiming.is_sensible(message) end
        local counter = message.counter
        return counter ~= CLAIMS.nxt_write and counter - CLAIMS.nxt_flag ~= CLAIMS.nxt_write
    end

    -- The types with which a claim of a stream begins.
    function claiming.begins(type) return type.is_command and type.carries ~= "daisy" end

    -- The state of a conversation: nil, not claimed; "claimed" from a plausible command, or from replies, on;
    -- "answered", when a reply has proved it: faulty frames keep the claim, too; "sure", for good; "ended", claimed
    -- before: a new claim may begin anywhere in a packet.
    local IS_CLAIMED = { claimed = true, answered = true, sure = true }

    function claiming.is_claimed(conversation) return IS_CLAIMED[conversation.state] == true end

    -- Claims a conversation from now on.
    function claiming.begin(conversation, state)
        conversation.state, conversation.held, conversation.replies = state or "claimed", {}, 0
        conversation.strange, conversation.unread, conversation.has_frame, conversation.is_good = 0, 0, false, false
        conversation.claims = (conversation.claims or 0) + 1
    end

    -- Takes a packet with commands that a reply has proved.
    local function adopt(conversation, packet)
        local offset = packet.adopt(packet.number, packet.frames[1].at)
        for _, frame in ipairs(packet.frames) do
            local place = storage.place_of(packet.number, offset + frame.at)
            dialogues.take_note(place, conversation, frame.message, { rel_ts = packet.time })
        end
    end

    -- Claims a conversation, beginning with a waiting command, if a frame from another side is its reply.
    local function is_proved(conversation, side, reply)
        local held = conversation.held or {}
        for index = #held, 1, -1 do
            local packet = held[index]
            for _, frame in ipairs(packet.side ~= side and packet.frames or {}) do
                if dialogues.proves(reply, frame.message) then
                    claiming.begin(conversation, "answered")
                    conversation.side_to_brick = packet.side
                    for later = index, #held do
                        if held[later].side ~= side then adopt(conversation, held[later]) end
                    end
                    return true
                end
            end
        end
        return false
    end

    -- Counts complete, non-empty replies; they begin a claim if there are enough in a row.
    local function has_replies(conversation, text)
        local places, stop = finding.frames_of(text, 0, #text)
        local count = (conversation.replies or 0) + #places
        for _, at in ipairs(places) do
            local message = messages.read_at(text, at)
            local type = message.type
            local is_empty = type.carries == "direct" and (type.is_error or message.stop == HEADER_SIZE)
            if type.is_command or type.carries == "daisy" or message.fault or is_empty then count = 0 end
        end
        conversation.replies = stop == #text and count or 0
        if conversation.replies < CLAIMS.replies then return false end
        claiming.begin(conversation)
        return true
    end

    -- Judges the newest packet of a conversation that is not claimed, and what waits before it. `packet` has
    --   side       its direction
    --   to_brick   whether that goes to the brick; nil if only commands tell
    --   text       the bytes, in which packets begin at `starts`, the newest last
    --   reported   their number on the wire
    --   begins     tells which types begin a claim
    --   adopt      is called when a reply has proved its commands, with the packet's number and the offset of the first
    --              of them; returns the offset of the text in the packet
    -- Returns CHAIN and the offset from which on it is ours; OPEN and the offset of what waits; SINGLE; or nil.
    function claiming.judge(conversation, pinfo, packet)
        local text, starts, side = packet.text, packet.starts, packet.side
        if not packet.to_brick then
            local newest = starts[#starts]
            -- Its length, counter and type are enough: the rest of a long reply comes in later packets.
            local is_reply = #text - newest >= HEADER_SIZE and is_length(text, newest)
            local reply = is_reply and messages.read_at(text, newest)
            if reply and is_proved(conversation, side, reply) then return CHAIN, newest end
        end
        if packet.to_brick == false then return has_replies(conversation, text) and CHAIN or nil, 0 end
        local is_ended = conversation.state == "ended"
        local found, place = finding.find_command(text, starts, packet.begins, packet.reported, is_ended)
        if found == CHAIN and packet.needs_reply then found = SINGLE end
        if found == CHAIN then
            claiming.begin(conversation)
            conversation.side_to_brick = side
        elseif found == SINGLE then
            packet.frames, packet.number, packet.time = {}, pinfo.number, pinfo.rel_ts
            for index, at in ipairs((finding.frames_of(text, place, packet.reported))) do
                packet.frames[index] = { at = at, message = messages.read_at(text, at) }
            end
            local held = conversation.held or {}
            if #held == CLAIMS.most_held then table.remove(held, 1) end
            held[#held + 1], conversation.held = packet, held
        end
        return found, place
    end

    -- Records a message of a claimed conversation, in the first pass.
    function claiming.note(conversation, message)
        if not claiming.is_claimed(conversation) or conversation.state == "sure" then return end
        conversation.has_frame = true
        local is_answered = conversation.state == "answered"
        conversation.is_good = conversation.is_good or not is_answered
            and (message.slip ~= nil or claiming.is_sensible(message))
    end

    -- Counts a packet of a claimed conversation; `size` is the number of its bytes outside of frames.
    function claiming.count(conversation, size, number)
        local is_good, has_frame = conversation.is_good, conversation.has_frame
        local is_answered = conversation.state == "answered"
        conversation.is_good, conversation.has_frame = false, false
        if conversation.state == "sure" or not has_frame and size == 0 then return end
        if is_good or is_answered and has_frame then
            conversation.strange, conversation.unread, conversation.counted = 0, 0, number
            return
        end
        -- A packet counts once, even if it comes in several buffers.
        if conversation.counted ~= number then conversation.strange = conversation.strange + 1 end
        conversation.unread, conversation.counted = conversation.unread + size, number
        -- In a dialogue, the rest of a frame may come in many packets.
        if conversation.strange >= CLAIMS.strange_packets
            and (not is_answered or conversation.unread > LENGTH_FIELD + MAX_LENGTH) then
            conversation.state, conversation.side_to_brick = "ended", nil
        end
    end
end

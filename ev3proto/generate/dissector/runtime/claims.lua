-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Which conversations are ours: other protocols use the same ports and channels as bricks. The rule is in ev3proto's
-- tables; here it is applied. Decisions are made in the first pass, and kept.

-- What data turn out to be: OURS; PART if more is needed to decide; nil if they are not ours.
local OURS, PART = "ours", "part"

do
    -- Calls a function with each firmware's instructions, the preferred one's first, until it returns true.
    local function by_any(says, ...)
        local said, preferred = says(...), instructions
        if said then return said end
        for _, name in ipairs(DIALECTS) do
            instructions = INSTRUCTION_SETS[name]
            said = said or instructions ~= preferred and says(...)
        end
        instructions = preferred
        return said
    end

    -- Reads operations from an offset on. `judge` gets the opcode of each, `visit` each argument. Returns nil, or the
    -- kind of the fault that ends them, and its operation.
    function claiming.scan(text, at, stop, judge, visit)
        while at < stop do
            local code = byte(text, at + 1)
            if code == CLAIMS.never_sent then return "fault" end
            local operation, after, _, reason, kind = reading.read_operation(text, at, visit)
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
            local number, from, to = byte(text, HEADER_SIZE + 1, HEADER_SIZE + 3)
            if not type.is_command then
                from, to = number, from
            elseif not DAISY.names[number] then
                return false
            end
            return to ~= nil and from <= DAISY.most_layers and to <= DAISY.most_layers
        end
        if type.carries ~= "direct" or not type.is_command then return true end
        return message.stop > COMMAND_HEADER_SIZE and not claiming.scan(text, COMMAND_HEADER_SIZE, message.stop)
    end

    -- Tells whether an argument has a kind and range that its parameter accepts; `sizes` is the requested memory, by
    -- scope.
    local function is_in_place(parameter, encoding, value, sizes)
        if encoding.scope then return value < sizes[encoding.kind] end
        if parameter.is_output then return false end
        local is_text = encoding.kind == CONSTANT_TEXT
        if is_text or parameter.kind == TEXT_VALUE then return is_text and parameter.kind == TEXT_VALUE end
        local range = parameter.range
        if range and value >= range[1] and value <= range[2] then return true end
        local names, special = parameter.names, parameter.special
        if not names and not special then return not range end
        return names and names[value] ~= nil or special and special[value] ~= nil
    end

    -- The same for all operations of a direct command, at least one of which must be evidence.
    local function fits(text, stop, is_cut)
        local memory, is_right, is_telling = reading.unsigned16(text, HEADER_SIZE), true, false
        local globals = memory % (GLOBAL_MASK + 1)
        local sizes = { [GLOBAL] = globals, [LOCAL] = (memory - globals) / (GLOBAL_MASK + 1) }
        local function visit(parameter, encoding, value)
            is_right = is_right and is_in_place(parameter, encoding, value, sizes)
        end
        local function judge(code)
            if CLAIMS.only_in_programs[code] or is_cut and code < CLAIMS.first_of_devices then is_right = false end
            if not CLAIMS.not_telling[code] then is_telling = true end
        end
        local kind = claiming.scan(text, COMMAND_HEADER_SIZE, stop, judge, visit)
        return is_right and is_telling and (not kind or is_cut and kind == "cut_off")
    end

    -- Tells whether a message is a plausible command by the instructions of some firmware. With `is_cut` the capture
    -- has only its beginning, which then counts.
    function claiming.is_plausible(message, is_cut)
        local type, stop = message.type, message.stop
        if not type or not type.is_command then return false end
        if not is_cut and (stop < message.size or message.fault) then return false end
        if type.carries == "direct" then
            return stop >= COMMAND_HEADER_SIZE and by_any(fits, message.text, stop, is_cut)
        end
        if is_cut then return false end
        if type.carries == "daisy" then return claiming.is_sensible(message) end
        local counter = message.counter
        return counter ~= CLAIMS.nxt_write and counter - CLAIMS.nxt_flag ~= CLAIMS.nxt_write
    end

    -- Counts the complete, non-empty replies in a text; 0 if it contains anything else.
    function claiming.count_replies(text)
        local at, count = 0, 0
        while #text - at >= HEADER_SIZE do
            local stop = stop_of(text, at)
            if stop > #text or stop - at < HEADER_SIZE then return 0 end
            local message = messages.read(sub(text, at + 1, stop))
            local type = message.type
            if not type or type.is_command or type.carries == "daisy" or message.fault then return 0 end
            if type.carries == "direct" and (type.is_error or message.stop == HEADER_SIZE) then return 0 end
            at, count = stop, count + 1
        end
        return at == #text and count or 0
    end

    -- Claims a conversation from now on; with `is_sure` for good, whatever it contains.
    function claiming.begin(conversation, is_sure)
        conversation.is_claimed, conversation.is_sure, conversation.is_answered = true, is_sure, false
        conversation.strange, conversation.unread, conversation.has_frame, conversation.is_good = 0, 0, false, false
        conversation.claims = (conversation.claims or 0) + 1
    end

    -- Takes note of a message of a claimed conversation, in the first pass.
    function claiming.note(conversation, message)
        if not conversation.is_claimed or conversation.is_sure then return end
        conversation.has_frame = true
        conversation.is_good = conversation.is_good or not conversation.is_answered and claiming.is_sensible(message)
    end

    -- Counts a packet of a claimed conversation; `size` is the number of its bytes outside of frames. Returns whether
    -- the conversation is still claimed.
    function claiming.count(conversation, size, number)
        local is_good, has_frame = conversation.is_good, conversation.has_frame
        conversation.is_good, conversation.has_frame = false, false
        if conversation.is_sure or not has_frame and size == 0 then return true end
        if is_good or conversation.is_answered and has_frame then
            conversation.strange, conversation.unread, conversation.counted = 0, 0, number
            return true
        end
        -- A packet counts once, even if it comes in several buffers.
        if conversation.counted ~= number then conversation.strange = conversation.strange + 1 end
        conversation.unread, conversation.counted = conversation.unread + size, number
        -- In a dialogue, the rest of a frame may come in many packets.
        local is_over = conversation.strange >= CLAIMS.strange_packets
            and (not conversation.is_answered or conversation.unread > LENGTH_FIELD + MAX_LENGTH)
        if is_over then
            conversation.is_claimed, conversation.is_answered, conversation.has_ended = false, false, true
        end
        return not is_over
    end
end

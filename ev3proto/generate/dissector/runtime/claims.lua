-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Which conversations are ours: other protocols use the same ports and channels as bricks. The rule is in ev3proto's
-- tables; here it is applied, and frames are found in streams. Decisions are made in the first pass, and kept.

-- What data turn out to be: OURS; PART if more is needed to decide; nil if they are not ours.
local OURS, PART = "ours", "part"

do
    -- Maximum number of places in one piece of a stream where a frame is tried.
    local MOST_TRIALS = 64

    -- Maximum number of following headers that are checked.
    local MOST_FOLLOWING = 2

    -- Bytes of a truncated command that must be captured, so that it can be recognised.
    local LEAST_CUT = COMMAND_HEADER_SIZE + 2

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
    local function scan(text, at, stop, judge, visit)
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
    local function is_sensible(message)
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
        return message.stop > COMMAND_HEADER_SIZE and not scan(text, COMMAND_HEADER_SIZE, message.stop)
    end
    claiming.is_sensible = is_sensible

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
        local kind = scan(text, COMMAND_HEADER_SIZE, stop, judge, visit)
        return is_right and is_telling and (not kind or is_cut and kind == "cut_off")
    end

    -- Tells whether a message is a plausible command by the instructions of some firmware. With `is_cut` the capture
    -- has only its beginning, which then counts.
    local function is_plausible(message, is_cut)
        local type, stop = message.type, message.stop
        if not type or not type.is_command then return false end
        if not is_cut and (stop < message.size or message.fault) then return false end
        if type.carries == "direct" then
            return stop >= COMMAND_HEADER_SIZE and by_any(fits, message.text, stop, is_cut)
        end
        if is_cut then return false end
        if type.carries == "daisy" then return is_sensible(message) end
        local counter = message.counter
        return counter ~= CLAIMS.nxt_write and counter - CLAIMS.nxt_flag ~= CLAIMS.nxt_write
    end
    claiming.is_plausible = is_plausible

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
        conversation.is_good = conversation.is_good or not conversation.is_answered and is_sensible(message)
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

    -- Tells whether an incomplete frame at an offset may turn out to have no fault.
    local function may_become(text, at, accepts)
        if not may_start(text, at) then return false end
        local code, number = byte(text, at + HEADER_SIZE, at + HEADER_SIZE + 1)
        local type = MESSAGE_TYPES[code]
        if not type then return true end
        if not accepts(type) then return false end
        if type.carries == "system" then return not number or SYSTEM_COMMANDS[number] ~= nil end
        if type.carries ~= "direct" or not type.is_command then return true end
        local kind, operation = scan(text, at + COMMAND_HEADER_SIZE, #text)
        -- A list that continues in the next packet has the fault of being too long.
        return not kind or kind == "cut_off" or kind == "fault" and operation ~= nil and operation.list ~= nil
    end
    claiming.may_become = may_become

    -- Bytes 1 to 4 of a header, as a pattern. No message type is a special character of patterns.
    local codes = {}
    for code in pairs(MESSAGE_TYPES) do
        codes[#codes + 1] = string.char(code)
    end
    local STARTS = "[\0-" .. string.char(floor(MAX_LENGTH / 0x100)) .. "]..[" .. concat(codes) .. "]"

    -- The system commands that end with arbitrary data.
    local has_data = {}
    for number, command in pairs(SYSTEM_COMMANDS) do
        for _, declared in ipairs(command.request) do
            if declared.kind == BYTES then has_data[number] = true end
        end
    end

    -- Iterates over the places from an offset on where the header of an accepted type may be: place, end of the frame,
    -- type.
    local function each_start(text, at, accepts)
        local hit, trials = at + 1, 0
        return function()
            while trials < MOST_TRIALS do
                hit = find(text, STARTS, hit + 1)
                if not hit then return nil end
                local place = hit - 2
                local type = MESSAGE_TYPES[byte(text, place + HEADER_SIZE)]
                if is_length(text, place) and accepts(type) then
                    trials = trials + 1
                    return place, stop_of(text, place), type
                end
            end
        end
    end

    -- Returns the first place from an offset on where an incomplete header may start at the end of a text, nil if there
    -- is none.
    function claiming.header_at_end(text, at)
        for place = math.max(#text - HEADER_SIZE + 1, at), #text - 1 do
            if may_start(text, place) then return place end
        end
    end

    -- Returns the first place with a plausible command, and true; else the first with what may become one (or nil), and
    -- false. Packets begin at 0 and at `joint`: anything may follow a command there, elsewhere only another frame. A
    -- truncated command counts as whole if it ends at `reported`, where the packet did.
    function claiming.find_command(text, joint, accepts, reported)
        local open = claiming.header_at_end(text, 0)
        for place, stop, type in each_start(text, 0, accepts) do
            local is_cut = reported > #text and stop == reported and #text - place >= LEAST_CUT
            local is_whole = stop <= #text or is_cut
            local is_split = not is_whole or place < joint and joint < stop
            local is_chance = is_split and type.carries == "system" and has_data[byte(text, place + HEADER_SIZE + 1)]
            if type.carries == "daisy" or is_chance then
                -- This proves nothing.
            elseif not is_whole then
                if not (open and open < place) and may_become(text, place, accepts) then open = place end
            elseif place == 0 or place == joint or stop >= #text or may_start(text, stop) then
                if is_plausible(messages.read(sub(text, place + 1, stop)), is_cut) then return place, true end
            end
        end
        return open, false
    end

    -- Counts the headers that follow each other from an offset on; nil if none can start there. A few are enough: the
    -- next gap may come soon.
    local function follow(text, at)
        local size, count = #text, 0
        while at < size and count < MOST_FOLLOWING do
            at = after_polls(text, at)
            if at < size and not may_start(text, at) then return nil end
            if size - at < HEADER_SIZE then break end
            at, count = stop_of(text, at), count + 1
        end
        return count
    end

    claiming.follow = follow

    -- Finds where a stream that is out of step continues, from an offset on. Returns the place of a complete frame
    -- without a fault, and the number of headers after it, at least `least`; else the place of an incomplete frame that
    -- may have no fault; else nil. Packets start at `first` and `second`: a frame there may have faults, or be followed
    -- by anything.
    function claiming.find_step(text, at, accepts, least, first, second)
        local open, single, begun
        for place, stop in each_start(text, at, accepts) do
            local following, is_begin = stop <= #text and follow(text, stop), place == first or place == second
            if stop > #text then
                if not open and may_become(text, place, accepts) then open = place end
            elseif (following or is_begin) and (following or 0) >= least then
                local is_sound = is_sensible(messages.read(sub(text, place + 1, stop)))
                if is_sound and following and following > 0 then return place, following end
                if is_sound and following then
                    single = single or place
                elseif is_begin and (is_sound or following) then
                    begun = begun or place
                end
            end
        end
        if single or begun then return single or begun, 0 end
        return open
    end

    -- Judges a frame that seems to come in several packets, between which packets may be missing: OURS, PART, or nil.
    -- The newest packet starts at `joint`.
    function claiming.judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if may_become(text, at, accepts) then return PART end
            local _, following = claiming.find_step(text, at + 1, accepts, 0)
            return not following and PART or nil
        end
        local message, following = messages.read(sub(text, at + 1, stop)), follow(text, stop)
        local type = message.type
        local is_sound = type and accepts(type) and is_sensible(message)
        if not following then return nil end
        -- Few random bytes are operations.
        if is_sound and (following > 0 or type.is_command and type.carries == "direct") then return OURS end
        -- After a gap between two packets, frames start in the newer one.
        local inside, following_inside = claiming.find_step(text, is_sound and joint or at + 1, accepts, 0, joint)
        local is_inside = inside and inside < stop
        if is_inside and following_inside then return nil end
        return not is_last and following == 0 and (is_inside or not is_sound) and PART or OURS
    end
end

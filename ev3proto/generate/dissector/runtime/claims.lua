-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Ours and not ours: the ports and channels that bricks use belong to others as well. The rule is in ev3proto's tables;
-- here it is applied, and frames are found in streams. Decisions are made the first time a packet is seen, and kept.

-- What the beginning of some data tells: OURS, PART where more is needed to tell, nil for what is not ours.
local OURS, PART = "ours", "part"

do
    -- Places in one piece of a stream where a whole frame is tried, before the piece is given up.
    local MOST_TRIALS = 64

    -- Frames after one that are looked at to tell whether it is one.
    local MOST_FOLLOWING = 2

    -- Bytes of a command that the capture must have to tell what it is.
    local LEAST_CUT = COMMAND_HEADER_SIZE + 2

    -- The offset after the frame that starts at another one, as its length says; nil where its length is not here.
    local function stop_of(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return high and at + frame_size(low, high)
    end

    -- Calls a function with each firmware's instructions, the preferred one's first, until it says anything.
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

    -- Reads operations from an offset on. `judge` gets the opcode of each, `visit` each argument. Returns nothing, or the
    -- kind of the fault that ends them, and the operation that has it.
    local function scan(text, at, stop, judge, visit)
        while at < stop do
            local code = byte(text, at + 1)
            if code == CLAIMS.never_sent then return "fault" end
            local operation, after, _, reason, kind = read_operation(text, at, visit)
            if operation and judge then judge(code) end
            if reason then return kind, operation end
            at = after
        end
    end

    -- Whether a frame has no fault and says something: it is not an empty command, nor for a layer that cannot exist.
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

    -- Whether an argument is of a kind and range that its parameter takes; `sizes` is the memory asked for, by scope.
    local function is_in_place(parameter, encoding, value, sizes)
        if encoding.scope then return value < sizes[encoding.kind] end
        if parameter.is_output then return false end
        local is_text = encoding.kind == CONSTANT_TEXT
        if is_text or parameter.kind == TEXT_VALUE then return is_text and parameter.kind == TEXT_VALUE end
        local range = parameter.range
        if range and value >= range[1] and value <= range[2] then return true end
        if parameter.is_legal then return parameter.is_legal(value) end
        return not range
    end

    -- The same for all operations of a direct command, at least one of which must be evidence.
    local function fits(text, stop, is_cut)
        local memory, is_right, is_telling = unsigned16(text, HEADER_SIZE), true, false
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

    -- Whether a message is a command that somebody would send to a brick, by the instructions of some firmware.
    -- With `is_cut` the capture has only the beginning of it: what is there counts.
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

    -- How many complete replies that bring something a text has and nothing else; 0 where it has anything else.
    function claiming.count_replies(text)
        local at, count = 0, 0
        while #text - at >= HEADER_SIZE do
            local stop = stop_of(text, at)
            if stop > #text or stop - at < HEADER_SIZE then return 0 end
            local message = read_message(sub(text, at + 1, stop))
            local type = message.type
            if not type or type.is_command or type.carries == "daisy" or message.fault then return 0 end
            if type.carries == "direct" and (type.is_error or message.stop == HEADER_SIZE) then return 0 end
            at, count = stop, count + 1
        end
        return at == #text and count or 0
    end

    -- Takes a conversation for ours from now on; with `is_sure` whatever is said in it.
    function claiming.begin(conversation, is_sure)
        conversation.is_claimed, conversation.is_sure, conversation.is_answered = true, is_sure, false
        conversation.strange, conversation.unread, conversation.has_frame, conversation.is_good = 0, 0, false, false
        conversation.claims = (conversation.claims or 0) + 1
    end

    -- Looks at a message of a conversation that is claimed, when it is seen for the first time.
    function claiming.note(conversation, message)
        if not conversation.is_claimed or conversation.is_sure then return end
        conversation.has_frame = true
        conversation.is_good = conversation.is_good or not conversation.is_answered and is_sensible(message)
    end

    -- Counts a packet of a claimed conversation, of which so many bytes are in no frame: whether it is claimed still.
    function claiming.count(conversation, size, number)
        local is_good, has_frame = conversation.is_good, conversation.has_frame
        conversation.is_good, conversation.has_frame = false, false
        if conversation.is_sure or not has_frame and size == 0 then return true end
        if is_good or conversation.is_answered and has_frame then
            conversation.strange, conversation.unread, conversation.counted = 0, 0, number
            return true
        end
        -- A packet counts once, though it be handed over in parts.
        if conversation.counted ~= number then conversation.strange = conversation.strange + 1 end
        conversation.unread, conversation.counted = conversation.unread + size, number
        -- Of a dialogue what is left of a frame may come in many packets.
        local is_over = conversation.strange >= CLAIMS.strange_packets
            and (not conversation.is_answered or conversation.unread > LENGTH_FIELD + MAX_LENGTH)
        if is_over then
            conversation.is_claimed, conversation.is_answered, conversation.has_ended = false, false, true
        end
        return not is_over
    end

    -- Whether the frame at an offset, of which the text has only the beginning, may become one without a fault.
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

    -- The bytes 1 to 4 of a header, as a pattern: no type is a letter that means anything in one.
    local codes = {}
    for code in pairs(MESSAGE_TYPES) do
        codes[#codes + 1] = string.char(code)
    end
    local STARTS = "[\0-" .. string.char(floor(MAX_LENGTH / 0x100)) .. "]..[" .. concat(codes) .. "]"

    -- The system commands that any bytes may follow.
    local has_data = {}
    for number, command in pairs(SYSTEM_COMMANDS) do
        for _, declared in ipairs(command.request) do
            if declared.kind == BYTES then has_data[number] = true end
        end
    end

    -- The places from an offset on where a frame of an accepted type may start, by its header, with the frame's end.
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

    -- The first place from an offset on where the last bytes may be the start of a header; nil without one.
    function claiming.header_at_end(text, at)
        for place = math.max(#text - HEADER_SIZE + 1, at), #text - 1 do
            if may_start(text, place) then return place end
        end
    end

    -- The first place with a plausible command, and true; else the first that may become one, nil without one.
    -- Packets begin at 0 and at `joint`: there anything may follow the command, elsewhere another frame. A command that
    -- ends at `reported`, of which the capture has less, is whole.
    function claiming.find_command(text, joint, accepts, reported)
        local open = claiming.header_at_end(text, 0)
        for place, stop, type in each_start(text, 0, accepts) do
            local is_cut = reported > #text and stop == reported and #text - place >= LEAST_CUT
            local is_whole = stop <= #text or is_cut
            local is_split = not is_whole or place < joint and joint < stop
            local is_chance = is_split and type.carries == "system" and has_data[byte(text, place + HEADER_SIZE + 1)]
            if type.carries == "daisy" or is_chance then
                -- Not enough to tell.
            elseif not is_whole then
                if not (open and open < place) and may_become(text, place, accepts) then open = place end
            elseif place == 0 or place == joint or stop >= #text or may_start(text, stop) then
                if is_plausible(read_message(sub(text, place + 1, stop)), is_cut) then return place, true end
            end
        end
        return open, false
    end

    -- How many frames begin here, one after the other, of those whose headers are here; nil where none can. Few are
    -- enough to tell, as the next gap may come soon.
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

    -- Where a stream goes on that is out of step, from an offset on: the place of a frame that is whole there and
    -- without a fault, and how many frames begin after it, at least `least`; else the place of the first that is not
    -- whole, and may become one. Where a packet starts, at `first` and at `second`, a frame may have faults, or nothing
    -- that can follow it. nil: no frame is here.
    function claiming.find_step(text, at, accepts, least, first, second)
        local open, single, begun
        for place, stop in each_start(text, at, accepts) do
            local following, is_begin = stop <= #text and follow(text, stop), place == first or place == second
            if stop > #text then
                if not open and may_become(text, place, accepts) then open = place end
            elseif (following or is_begin) and (following or 0) >= least then
                local stands = is_sensible(read_message(sub(text, place + 1, stop)))
                if stands and following and following > 0 then return place, following end
                if stands and following then
                    single = single or place
                elseif is_begin and (stands or following) then
                    begun = begun or place
                end
            end
        end
        if single or begun then return single or begun, 0 end
        return open
    end

    -- What a frame is that seems to come in several packets, if a gap may be between them: OURS, PART where more is
    -- needed to tell, nil where it is none. `joint` is where the newest packet starts.
    function claiming.judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if may_become(text, at, accepts) then return PART end
            local _, following = claiming.find_step(text, at + 1, accepts, 0)
            return not following and PART or nil
        end
        local message = read_message(sub(text, at + 1, stop))
        local type, following = message.type, follow(text, stop)
        local stands = type and accepts(type) and is_sensible(message)
        -- Few bytes are operations by chance.
        local tells_itself = stands and type.is_command and type.carries == "direct"
        if tells_itself or stands and following and following > 0 then return OURS end
        if not following then return nil end
        -- After a gap between two packets, frames begin with the newer one, or later.
        local inside, following_inside = claiming.find_step(text, stands and joint or at + 1, accepts, 0, joint)
        local is_inside = inside and inside < stop
        if is_inside and following_inside then return nil end
        local is_unclear = following == 0 or following == 1 and not stands
        if not is_last and (not stands and following == 0 or is_inside and is_unclear) then return PART end
        return OURS
    end
end

-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Ours and not ours: the ports and channels that bricks use belong to others as well. The rule stands in ev3proto's
-- tables; here it is applied. Decisions are made the first time a packet is seen, and kept.

-- What the beginning of some data tells: OURS, PART where more is needed to tell, nil for what is not ours.
local OURS, PART = "ours", "part"

local is_flawless, is_sensible, may_become_flawless, find_frame, find_step, judge_split

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

    -- Whether the operations of a command can be read: all of them, or with `is_part` those that are there.
    local function can_be_read(text, stop, is_part)
        local at = COMMAND_HEADER_SIZE
        while at < stop do
            local operation, after, _, reason, kind = read_operation(text, at)
            -- Of a list that goes on in the next packet the dissector says that it is too long.
            if reason then
                local is_list = kind == "fault" and operation ~= nil and operation.list ~= nil
                return is_part and (kind == "cut_off" or is_list)
            end
            at = after
        end
        return true
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

    -- Whether a frame is without any fault.
    function is_flawless(message)
        local type, text, stop = message.type, message.text, message.stop
        if not type or stop < message.size or message.fault then return false end
        if type.carries == "direct" then
            if not type.is_command then return true end
            return stop >= COMMAND_HEADER_SIZE and can_be_read(text, stop)
        elseif type.carries == "daisy" then
            local at = HEADER_SIZE
            if type.is_command then
                if not DAISY.names[byte(text, at + 1)] then return false end
                at = at + 1
            end
            local from, to = byte(text, at + 1, at + 2)
            return to ~= nil and from <= DAISY.most_layers and to <= DAISY.most_layers
        end
        return true
    end

    -- Whether a frame without a fault says something: not a command of nothing, nor to a layer that is not there.
    function is_sensible(message)
        if not is_flawless(message) then return false end
        local type, text, at = message.type, message.text, COMMAND_HEADER_SIZE
        if type.carries ~= "direct" or not type.is_command then return true end
        if message.stop <= at then return false end
        while at < message.stop do
            if byte(text, at + 1) == CLAIMS.never_sent then return false end
            local _, after = read_operation(text, at)
            at = after
        end
        return true
    end

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

    -- The same for all of a direct command's operations.
    local function fits(text, stop, is_cut)
        local memory, at, is_right = unsigned16(text, HEADER_SIZE), COMMAND_HEADER_SIZE, true
        local is_telling = false
        local globals = memory % (GLOBAL_MASK + 1)
        local sizes = { [GLOBAL] = globals, [LOCAL] = (memory - globals) / (GLOBAL_MASK + 1) }
        local function visit(parameter, encoding, value)
            is_right = is_right and is_in_place(parameter, encoding, value, sizes)
        end
        while at < stop do
            local code = byte(text, at + 1)
            if code == CLAIMS.never_sent or CLAIMS.only_in_programs[code] then return false end
            if is_cut and code < CLAIMS.first_of_devices then return false end
            local operation, after, _, reason, kind = read_operation(text, at, visit)
            if reason and not (is_cut and kind == "cut_off") or not is_right then return false end
            is_telling = is_telling or operation and not CLAIMS.not_telling[code]
            if reason then break end
            at = after
        end
        return is_telling
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

    -- Whether a frame of which only this is there may become one without a fault.
    function may_become_flawless(text, at, accepts)
        local part = sub(text, at + 1)
        if not may_start(part, 0) then return false end
        local type = MESSAGE_TYPES[byte(part, HEADER_SIZE)]
        if not type then return true end
        if accepts and not accepts(type) then return false end
        if type.carries == "system" and #part > HEADER_SIZE then
            return SYSTEM_COMMANDS[byte(part, HEADER_SIZE + 1)] ~= nil
        end
        if type.carries ~= "direct" or not type.is_command or #part <= COMMAND_HEADER_SIZE then return true end
        return can_be_read(part, #part, true)
    end

    -- The bytes 1 to 4 of a header, as a pattern: no type is a letter that means anything in one.
    local codes = {}
    for code in pairs(MESSAGE_TYPES) do
        codes[#codes + 1] = string.char(code)
    end
    local STARTS = "[\0-" .. string.char(floor(MAX_LENGTH / 0x100)) .. "]..[" .. concat(codes) .. "]"

    -- How many frames stand one after the other from an offset on, until one is not whole; nil where the chain breaks.
    local function count_chain(text, at)
        local count = 0
        while at < #text do
            at = after_polls(text, at)
            if at == #text then return count end
            if not may_start(text, at) then return nil end
            local size = frame_size(byte(text, at + 1, at + 2))
            if not size or at + size > #text then return count end
            at, count = at + size, count + 1
        end
        return count
    end

    -- The system commands that any bytes may follow.
    local has_data = {}
    for number, command in pairs(SYSTEM_COMMANDS) do
        for _, declared in ipairs(command.request) do
            if declared.kind == BYTES then has_data[number] = true end
        end
    end

    -- The first place where a plausible command stands, and true; else the first that may become one, nil where there
    -- is none. Packets begin at 0 and at `joint`: there anything may follow the command, elsewhere another frame. A
    -- command that ends at `reported`, of which the capture has less, is whole.
    function claiming.find_command(text, joint, accepts, reported)
        local open
        for place = math.max(#text - HEADER_SIZE + 1, 0), #text - 1 do
            if may_start(text, place) then
                open = place
                break
            end
        end
        local hit = find(text, STARTS, 2)
        for _ = 1, MOST_TRIALS do
            if not hit then break end
            local place, low, high, _, _, code = hit - 2, byte(text, hit - 1, hit + 3)
            local stop, type = place + frame_size(low, high), MESSAGE_TYPES[code]
            local is_cut = reported > #text and stop == reported and #text - place >= LEAST_CUT
            local is_split = stop > #text and not is_cut or place < joint and joint < stop
            local is_chance = is_split and type.carries == "system" and has_data[byte(text, place + HEADER_SIZE + 1)]
            if is_length(text, place) and accepts(type) and type.carries ~= "daisy" and not is_chance then
                if stop > #text and not is_cut then
                    if not (open and open < place) and may_become_flawless(text, place, accepts) then open = place end
                elseif place == 0 or place == joint or stop >= #text or may_start(text, stop) then
                    if is_plausible(read_message(sub(text, place + 1, stop)), is_cut) then return place, true end
                end
            end
            hit = find(text, STARTS, hit + 1)
        end
        return open, false
    end

    -- The first offset, from `at` on, where all of a frame stands without a fault, and where frames follow each other
    -- up to the end, at least two; nil where there is none.
    function find_frame(text, at)
        local hit = find(text, STARTS, at + 2)
        for _ = 1, MOST_TRIALS do
            if not hit then return nil end
            local low, high = byte(text, hit - 1, hit)
            local stop = hit - 2 + frame_size(low, high)
            if is_length(text, hit - 2) and stop <= #text and (count_chain(text, hit - 2) or 0) >= 2
                and is_sensible(read_message(sub(text, hit - 1, stop))) then
                return hit - 2
            end
            hit = find(text, STARTS, hit + 1)
        end
        return nil
    end

    local function accepts_any()
        return true
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
    -- without a fault, and followed by what may be the next one. If frames may go on in the next packet, this is also
    -- the place of the first that may be one as far as it goes, and the second result is true. Where a packet starts,
    -- at `first` and at `second`, a frame may have faults, or nothing that can follow it. nil: no frame is here.
    function find_step(text, at, accepts, may_go_on, first, second)
        accepts = accepts or accepts_any
        local open, single, begun
        local trials, hit = 0, find(text, STARTS, at + 2)
        while hit and trials < MOST_TRIALS do
            local place, low, high, _, _, code = hit - 2, byte(text, hit - 1, hit + 3)
            local stop = place + frame_size(low, high)
            if is_length(text, place) and accepts(MESSAGE_TYPES[code]) then
                trials = trials + 1
                if stop > #text then
                    if may_go_on and not open and may_become_flawless(text, place, accepts) then open = place end
                else
                    local following = follow(text, stop)
                    local is_begin = place == first or place == second
                    if following or is_begin then
                        local message = read_message(sub(text, place + 1, stop))
                        local stands = is_sensible(message)
                        if stands and following and following > 0 then return place end
                        if stands and following then
                            single = single or place
                        elseif is_begin and (stands or following) then
                            begun = begun or place
                        end
                    end
                end
            end
            hit = find(text, STARTS, hit + 1)
        end
        single = single or begun
        if single then return single end
        return open, open ~= nil
    end

    -- What a frame is that seems to come in several packets, if a gap may be between them: OURS, PART where more is
    -- needed to tell, nil where it is none. `joint` is where the newest packet starts.
    function judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if may_become_flawless(text, at, accepts) or not find_step(text, at + 1, accepts) then return PART end
            return nil
        end
        local message = read_message(sub(text, at + 1, stop))
        local type, following = message.type, follow(text, stop)
        local stands = type and (not accepts or accepts(type)) and is_sensible(message)
        -- Few bytes are operations by chance.
        local tells_itself = stands and type.is_command and type.carries == "direct"
        if stands and following and following > 0 or tells_itself then return OURS end
        if not following then
            -- The next frame may be of an unknown type: then the one after it must start.
            local next_low, next_high = byte(text, stop + 1, stop + 2)
            local next_stop = next_high and stop + frame_size(next_low, next_high)
            if not next_stop or not is_length(text, stop) then return nil end
            if next_stop < #text and not may_start(text, next_stop) then return nil end
            following = next_stop < #text and 1 or 0
        end
        local place, is_open = find_step(text, stands and joint or at + 1, accepts, true, joint)
        if not place or place >= stop then place = nil end
        if place and not is_open and following < 2 then return nil end
        if is_last or stands and following > 0 then return OURS end
        if not stands and following == 0 or place and following < 2 then return PART end
        return OURS
    end
end

-- Finding -----------------------------------------------------------------------------------------------------------
--
-- Frames in streams that are not claimed yet, or out of step after a gap: a header alone is often a coincidence, so a
-- frame is also judged by its contents and by what follows it.

local finding = {}
do
    -- Maximum number of places in one piece of a stream where a frame is tried.
    local MOST_TRIALS = 64

    -- Maximum number of following headers that are checked.
    local MOST_FOLLOWING = 2

    -- Bytes of a truncated command that must be captured, so that it can be recognised.
    local LEAST_CUT = COMMAND_HEADER_SIZE + 2

    -- Tells whether an incomplete frame at an offset may turn out to have no fault.
    function finding.may_become(text, at, accepts)
        if not may_start(text, at) then return false end
        local code, number = byte(text, at + HEADER_SIZE, at + HEADER_SIZE + 1)
        local type = MESSAGE_TYPES[code]
        if not type then return true end
        if not accepts(type) then return false end
        if type.carries == "system" then return not number or SYSTEM_COMMANDS[number] ~= nil end
        if type.carries ~= "direct" or not type.is_command then return true end
        local kind, operation = claiming.scan(text, at + COMMAND_HEADER_SIZE, #text)
        -- A list that continues in the next packet has the fault of being too long.
        return not kind or kind == "cut_off" or kind == "fault" and operation ~= nil and operation.list ~= nil
    end

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
    function finding.header_at_end(text, at)
        for place = math.max(#text - HEADER_SIZE + 1, at), #text - 1 do
            if may_start(text, place) then return place end
        end
    end

    -- Returns the first place with a plausible command, and true; else the first with what may become one (or nil), and
    -- false. Packets begin at 0 and at `joint`: anything may follow a command there, elsewhere only another frame. A
    -- truncated command counts as whole if it ends at `reported`, where the packet did.
    function finding.find_command(text, joint, accepts, reported)
        local open = finding.header_at_end(text, 0)
        for place, stop, type in each_start(text, 0, accepts) do
            local is_cut = reported > #text and stop == reported and #text - place >= LEAST_CUT
            local is_whole = stop <= #text or is_cut
            local is_split = not is_whole or place < joint and joint < stop
            local is_chance = is_split and type.carries == "system" and has_data[byte(text, place + HEADER_SIZE + 1)]
            if type.carries == "daisy" or is_chance then
                -- This proves nothing.
            elseif not is_whole then
                if not (open and open < place) and finding.may_become(text, place, accepts) then open = place end
            elseif place == 0 or place == joint or stop >= #text or may_start(text, stop) then
                if claiming.is_plausible(messages.read(sub(text, place + 1, stop)), is_cut) then return place, true end
            end
        end
        return open, false
    end

    -- Counts the headers that follow each other from an offset on; nil if none can start there. A few are enough: the
    -- next gap may come soon.
    function finding.follow(text, at)
        local size, count = #text, 0
        while at < size and count < MOST_FOLLOWING do
            at = after_polls(text, at)
            if at < size and not may_start(text, at) then return nil end
            if size - at < HEADER_SIZE then break end
            at, count = stop_of(text, at), count + 1
        end
        return count
    end

    -- Finds where a stream that is out of step continues, from an offset on. Returns the place of a complete frame
    -- without a fault, and the number of headers after it, at least `least`; else the place of an incomplete frame that
    -- may have no fault; else nil. Packets start at `first` and `second`: a frame there may have faults, or be followed
    -- by anything.
    function finding.find_step(text, at, accepts, least, first, second)
        local open, single, begun
        for place, stop in each_start(text, at, accepts) do
            local following, is_begin = stop <= #text and finding.follow(text, stop), place == first or place == second
            if stop > #text then
                if not open and finding.may_become(text, place, accepts) then open = place end
            elseif (following or is_begin) and (following or 0) >= least then
                local is_sound = claiming.is_sensible(messages.read(sub(text, place + 1, stop)))
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
    function finding.judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if finding.may_become(text, at, accepts) then return PART end
            local _, following = finding.find_step(text, at + 1, accepts, 0)
            return not following and PART or nil
        end
        local message, following = messages.read(sub(text, at + 1, stop)), finding.follow(text, stop)
        local type = message.type
        local is_sound = type and accepts(type) and claiming.is_sensible(message)
        if not following then return nil end
        -- Few random bytes are operations.
        if is_sound and (following > 0 or type.is_command and type.carries == "direct") then return OURS end
        -- After a gap between two packets, frames start in the newer one.
        local inside, following_inside = finding.find_step(text, is_sound and joint or at + 1, accepts, 0, joint)
        local is_inside = inside and inside < stop
        if is_inside and following_inside then return nil end
        return not is_last and following == 0 and (is_inside or not is_sound) and PART or OURS
    end
end

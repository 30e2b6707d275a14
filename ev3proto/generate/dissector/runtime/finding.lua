-- Finding -----------------------------------------------------------------------------------------------------------
--
-- Finds frames in streams that are not claimed yet, or out of step after a gap. A header alone is often a coincidence,
-- so a frame is also judged by its contents and by what follows it.

do
    -- Maximum number of places in one piece of a stream where a frame is parsed.
    local MOST_TRIALS = 64

    -- Number of following headers that confirm a frame, which are checked at most.
    finding.MOST_FOLLOWING = 2

    -- The minimum size of a command that is cut or inside a packet: one byte of operations, as NOP, proves nothing.
    local LEAST = COMMAND_HEADER_SIZE + 2

    -- Tells whether an incomplete frame at an offset may become one without a fault.
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

    -- Iterates over the places from an offset on where the header of an accepted type may be: place, end of the frame,
    -- type.
    local function each_start(text, at, accepts)
        local hit, trials = at + 1, 0
        return function()
            while trials < MOST_TRIALS do
                hit = find(text, HEADER_PATTERN, hit + 1)
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

    -- Returns the offsets of the whole frames that follow each other from an offset on, and the offset after them. The
    -- last one may be cut by the capture: it then ends at `reported`.
    function finding.frames_of(text, at, reported)
        local places = {}
        while #text - at >= HEADER_SIZE and may_start(text, at) do
            local stop = stop_of(text, at)
            if stop > #text and stop ~= reported then break end
            places[#places + 1], at = at, stop
        end
        return places, at
    end

    -- Tells whether whole frames of accepted types fill a text from an offset on, sensible ones if that is asked.
    function finding.is_filled(text, at, accepts, reported, is_sensible)
        local places, stop = finding.frames_of(text, at, reported)
        for _, place in ipairs(places) do
            if not accepts(MESSAGE_TYPES[byte(text, place + HEADER_SIZE)]) then return false end
            if is_sensible and not claiming.is_sensible(messages.read_at(text, place)) then return false end
        end
        return stop == reported and places[1] ~= nil
    end

    local function is_split(starts, place, stop)
        for _, start in ipairs(starts) do
            if place < start and start < stop then return true end
        end
        return false
    end

    -- Counts consecutive headers from an offset on, a few at most; nil if none can start there.
    function finding.follow(text, at)
        local size, count = #text, 0
        while at < size and count < finding.MOST_FOLLOWING do
            at = after_polls(text, at)
            if at < size and not may_start(text, at) then return nil end
            if size - at < HEADER_SIZE then break end
            at, count = stop_of(text, at), count + 1
        end
        return count
    end

    -- Returns the slip in the length field of a command that was sent alone, up to an offset, and the length; nil if it
    -- has none. `accept` judges the command with the right length.
    local function slip_in(text, at, sent, accept)
        local follow = sent and sent - at - LENGTH_FIELD
        if not follow or follow <= MIN_LENGTH then return nil end
        local length, slip = reading.unsigned16(text, at), nil
        local head, more = string.char(follow % 0x100, floor(follow / 0x100)), length - follow
        if more == LENGTH_FIELD then
            slip = "length_self"
        elseif more ~= 0 and head:reverse() == sub(text, at + 1, at + LENGTH_FIELD) then
            slip = "length_swapped"
        elseif more ~= 0 and math.abs(more) <= 2 then
            slip = "length"
        end
        local meant = slip and messages.read(head .. sub(text, at + LENGTH_FIELD + 1, sent))
        return meant and meant.type and meant.type.is_command and accept(meant) and slip, length
    end

    -- Searches for a command with which a claim begins. Packets begin at `starts`: anything may follow a command there,
    -- elsewhere another header must, at least its length. With `anywhere`, as after a gap, frames may begin and end
    -- anywhere. Returns what is found first, of a CHAIN, a SINGLE, what is OPEN, and its offset; or nil.
    function finding.find_command(text, starts, accepts, reported, anywhere)
        local size, is_begin = #text, {}
        local function examine(place)
            local sent = size
            for index = #starts, 1, -1 do
                if starts[index] > place then sent = starts[index] end
            end
            if is_begin[place] and reported == size and slip_in(text, place, sent, claiming.is_plausible) then
                return CHAIN
            end
            local code, number = byte(text, place + HEADER_SIZE, place + HEADER_SIZE + 1)
            local type, stop = MESSAGE_TYPES[code], stop_of(text, place)
            if not may_start(text, place) or type and not accepts(type) then return nil end
            local is_cut = type and reported > size and stop == reported and size - place >= LEAST
            local is_whole = type and stop <= size or is_cut
            local is_data = type and type.carries == "system" and (SYSTEM_COMMANDS[number] or {}).has_data
            if is_data and (not is_whole or is_split(starts, place, stop)) then return nil end
            if not is_whole then
                return (is_begin[place] or anywhere) and finding.may_become(text, place, accepts) and OPEN or nil
            end
            local is_enough = stop - place >= LEAST and (anywhere or size - stop >= LENGTH_FIELD)
            local is_followed = is_enough and (stop == size or may_start(text, stop)) and finding.follow(text, stop)
            local message = (is_begin[place] or is_followed) and messages.read_at(text, place)
            if message and claiming.is_plausible(message, is_cut) then return CHAIN end
            return is_begin[place] and finding.is_filled(text, place, accepts, reported) and SINGLE or nil
        end
        local places, first = {}, {}
        for index, start in ipairs(starts) do places[index], is_begin[start] = start, true end
        for place in each_start(text, 0, accepts) do
            if not is_begin[place] then places[#places + 1] = place end
        end
        for place = math.max(size - HEADER_SIZE + 1, 0), anywhere and size - 1 or -1 do
            if not is_begin[place] then places[#places + 1] = place end
        end
        table.sort(places)
        for _, place in ipairs(places) do
            local found = (is_begin[place] or not first[SINGLE]) and examine(place)
            if found == CHAIN then return CHAIN, place end
            if found then first[found] = first[found] or place end
        end
        if first[SINGLE] then return SINGLE, first[SINGLE] end
        return first[OPEN] and OPEN, first[OPEN]
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
                local is_sound = claiming.is_sensible(messages.read_at(text, place))
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

    -- Returns what is wrong with the length field of a frame, nil if nothing is. Its packet starts with it and ends at
    -- `sent`, and the field says nearly that size; only with the right length the frame makes sense.
    function finding.slip_of(text, at, sent, is_last)
        local slip, length = slip_in(text, at, sent, claiming.is_sensible)
        if not slip then return nil end
        local stop = is_length(text, at) and stop_of(text, at) or #text
        -- An empty command has no fault.
        if stop > #text and not is_last or stop == at + COMMAND_HEADER_SIZE then return nil end
        if is_length(text, at) and claiming.is_sensible(messages.read_at(text, at)) then return nil end
        local said = { length = length, follow = sent - at - LENGTH_FIELD, more = LENGTH_FIELD }
        return phrases.filled(SLIPS[slip], said)
    end

    -- Judges a frame that seems to be split over several packets, with possible gaps between them: OURS, PART, or nil.
    -- The newest packet starts at `joint`.
    function finding.judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if finding.may_become(text, at, accepts) then return PART end
            local _, following = finding.find_step(text, at + 1, accepts, 0)
            return not following and PART or nil
        end
        local message, following = messages.read_at(text, at), finding.follow(text, stop)
        local type = message.type
        local is_sound = type and accepts(type) and claiming.is_sensible(message)
        if not following then return nil end
        -- A whole frame that ends with its packet is complete, whatever its data look like.
        if is_sound and stop == #text and stop > joint then return OURS end
        -- Random bytes are rarely valid operations.
        if is_sound and (following > 0 or type.is_command and type.carries == "direct") then return OURS end
        -- After a gap between two packets, frames start in the newer one.
        local inside, following_inside = finding.find_step(text, is_sound and joint or at + 1, accepts, 0, joint)
        local is_inside = inside and inside < stop
        if is_inside and following_inside then return nil end
        -- A header after a frame without a fault confirms it, two do after another.
        local is_open = is_inside and following <= (is_sound and 0 or 1) or following == 0 and not is_sound
        return is_open and not is_last and PART or OURS
    end
end

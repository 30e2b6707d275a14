-- Memory ------------------------------------------------------------------------------------------------------------
--
-- What is worth keeping of a capture, in little space however long it is.

local new_memory, forget_memories, place_of, number_of, new_notes
do
    local forgetting = {}

    function forget_memories()
        for _, forget in ipairs(forgetting) do
            forget()
        end
    end

    -- Remembers what was found out, by some text, as a dialogue says the same again and again. What was not asked for
    -- since `half` came in is forgotten, so that it holds at most twice as much; `cost_of` says how much a value
    -- counts.
    function new_memory(half, cost_of)
        local recent, before, cost = {}, {}, 0
        local memory = {}

        function memory.put(key, value)
            if cost >= half then recent, before, cost = {}, recent, 0 end
            recent[key], cost = value, cost + (cost_of and cost_of(value) or 1)
        end

        function memory.get(key)
            local value = recent[key]
            if value == nil then
                value = before[key]
                if value ~= nil then memory.put(key, value) end
            end
            return value
        end

        forgetting[#forgetting + 1] = function()
            recent, before, cost = {}, {}, 0
        end
        return memory
    end

    -- A message's place is the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    function place_of(number, offset)
        return number * OFFSETS + offset
    end

    function number_of(place)
        return floor(place / OFFSETS)
    end

    -- Keeps what is known of messages, by place. A long capture has a great many: a table each would take several times
    -- what it says. So all that is known of some packets in a row is joined to one text, as soon as a later packet has
    -- something; what is added to them afterwards is little, and kept beside it. `text_of` makes a text of what is
    -- known, `read` the other way round.
    function new_notes(text_of, read)
        local PAGE = 256 * OFFSETS
        local pages, additions, open, open_number, last, last_number
        local notes = {}

        function notes.forget()
            pages, additions, open, open_number, last, last_number = {}, {}, {}, 0, {}, nil
        end
        notes.forget()

        local function close_page()
            local pieces, count = {}, 0
            for place, known in pairs(open) do
                local text = text_of(known)
                pieces[count + 1], pieces[count + 2] = format("%d %d ", place % PAGE, #text), text
                count = count + 2
            end
            if count > 0 then pages[open_number] = concat(pieces) end
        end

        local function read_page(number)
            local found, text, at = {}, pages[number] or "", 1
            while at <= #text do
                local place, size, start = text:match("^(%d+) (%d+) ()", at)
                at = start + size
                found[number * PAGE + place] = read(sub(text, start, at - 1))
            end
            return found
        end

        function notes.put(place, known)
            local number = floor(place / PAGE)
            if number < open_number then
                additions[place] = text_of(known)
                return
            elseif number > open_number then
                close_page()
                open, open_number = {}, number
            end
            open[place] = known
        end

        function notes.get(place)
            local number = floor(place / PAGE)
            if number == open_number then return open[place] end
            local text = additions[place]
            if text then return read(text) end
            if number ~= last_number then last, last_number = read_page(number), number end
            return last[place]
        end

        return notes
    end
end

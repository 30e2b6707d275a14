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
    -- something; what is added to them afterwards is little, and kept beside it. `write` gives one or two texts for a
    -- place and what is known there, `read` finds in a text at an index the place, what is known, and the next index.
    -- Both are given the first place of those packets, to count from: most numbers are short then.
    function new_notes(write, read)
        local PAGE = 256 * OFFSETS
        -- Of the last packets: place and what is known in turn. The list is used again for those that follow.
        local open, count, open_number = {}, 0, 0
        local pages, additions, last, last_number
        local notes, pieces = {}, {}

        function notes.forget()
            open, count, open_number = {}, 0, 0
            pages, additions, last, last_number = {}, {}, {}, nil
        end
        notes.forget()

        local function close_page()
            local stop, base = 0, open_number * PAGE
            for index = 1, count, 2 do
                local head, rest = write(base, open[index], open[index + 1])
                stop = stop + 1
                pieces[stop] = head
                if rest then
                    stop = stop + 1
                    pieces[stop] = rest
                end
            end
            if stop > 0 then pages[open_number] = concat(pieces, "", 1, stop) end
            count = 0
        end

        local function read_page(number)
            local found, text, at, base = {}, pages[number] or "", 1, number * PAGE
            while at <= #text do
                local place, known
                place, known, at = read(base, text, at)
                found[place] = known
            end
            return found
        end

        function notes.put(place, known)
            local number = floor(place / PAGE)
            if number < open_number then
                local head, rest = write(number * PAGE, place, known)
                additions[place] = rest and head .. rest or head
                return
            elseif number > open_number then
                close_page()
                open_number = number
            end
            open[count + 1] = place
            open[count + 2] = known
            count = count + 2
        end

        function notes.get(place)
            local number = floor(place / PAGE)
            if number == open_number then
                -- Usually it is the last one that was put.
                for index = count - 1, 1, -2 do
                    if open[index] == place then return open[index + 1] end
                end
                return nil
            end
            local text = additions[place]
            if text then
                local _, known = read(number * PAGE, text, 1)
                return known
            end
            if number ~= last_number then last, last_number = read_page(number), number end
            return last[place]
        end

        return notes
    end
end

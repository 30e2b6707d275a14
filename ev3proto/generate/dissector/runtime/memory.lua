-- Memory ------------------------------------------------------------------------------------------------------------
--
-- The places of messages, and memory.

local storage = {}
do
    -- Items and ranges of a tree are garbage after their packet. Lua collects garbage when its memory has doubled, long
    -- after the garbage has left the processor's cache. If it is collected soon, tshark -V takes 2.75 times as long as
    -- without a dissector for 30,000 packets, not 3.34 times; two passes with a filter take 4.6 times as long, not 5.9.
    -- Without a tree there is little garbage, and with much memory held by other scripts a collection takes long.
    do
        local GROWTH, MOST_KILOBYTES = 1.15, 32 * 1024
        local limit = 0

        function storage.free_unused()
            local size = collectgarbage("count")
            if size < limit or size > MOST_KILOBYTES then return end
            -- Finalizers of other scripts may raise errors.
            pcall(collectgarbage)
            limit = GROWTH * collectgarbage("count")
        end
    end

    -- The place of a message: the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    function storage.place_of(number, offset)
        return number * OFFSETS + offset
    end

    function storage.number_of(place)
        return floor(place / OFFSETS)
    end

    -- A compact map from places to texts, for any number of packets. The texts of a page of packets are packed outside
    -- of Lua's memory once a later page begins: Lua visits all of its memory in each collection, and lets it double
    -- before that. Texts that are added to an earlier page stay in `late`. 300,000 packets take 47 bytes each with
    -- this, and 374 without.
    local PAGE = 256 * OFFSETS
    local pack, unpack = Struct.pack, Struct.unpack

    function storage.new_notes()
        local pages, open, open_number, late = {}, {}, 0, {}
        local last, last_number
        local notes = {}

        local function close_page()
            local records = {}
            for place, text in pairs(open) do
                records[#records + 1] = pack("dI2", place, #text) .. text
            end
            if records[1] then pages[open_number] = ByteArray.new(concat(records), true) end
            open = {}
        end

        local function read_page(number)
            local found, page, at = {}, pages[number]:raw(), 1
            while at <= #page do
                local place, size, start = unpack("dI2", page, at)
                at = start + size
                found[place] = sub(page, start, at - 1)
            end
            return found
        end

        function notes.put(place, text)
            local number = floor(place / PAGE)
            if number < open_number then
                late[place] = text
                return
            elseif number > open_number then
                close_page()
                open_number = number
            end
            open[place] = text
        end

        -- Returns the text of a place, or nil.
        function notes.get(place)
            local number = floor(place / PAGE)
            if number == open_number then return open[place] end
            if late[place] then return late[place] end
            if not pages[number] then return nil end
            if number ~= last_number then last, last_number = read_page(number), number end
            return last[place]
        end

        return notes
    end
end

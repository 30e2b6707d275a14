-- Memory ------------------------------------------------------------------------------------------------------------
--
-- What is worth keeping of a capture, in little space however long it is.

local memory, place_of, number_of
do
    memory = {}

    -- What a packet leaves behind, items and ranges of a tree above all, Lua frees when all that it holds has doubled,
    -- in small steps. By then it is in no cache of the processor any more, and that takes up to a quarter of the time.
    -- So it is freed as soon as there is some of it; how Lua frees otherwise stays as it is. Where other scripts hold
    -- much, all is left to Lua: going through that would take long.
    do
        local GROWTH, MOST_KILOBYTES = 1.15, 32 * 1024
        local limit = 0

        function memory.free_unused()
            local size = collectgarbage("count")
            if size < limit or size > MOST_KILOBYTES then return end
            -- Objects of other scripts may raise an error when they are freed.
            pcall(collectgarbage)
            limit = GROWTH * collectgarbage("count")
        end
    end

    -- A message's place is the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    function place_of(number, offset)
        return number * OFFSETS + offset
    end

    function number_of(place)
        return floor(place / OFFSETS)
    end

    -- What is kept for good lies outside of Lua, in byte arrays: Lua goes through all that it holds whenever it frees
    -- something, and lets it double before it does.
    local new_bytes, pack, unpack = ByteArray.new, Struct.pack, Struct.unpack
    local NUMBER_SIZE = 8

    -- Texts that are kept are shorter than this.
    local MOST_LENGTH = 0x10000

    -- Keeps texts, each by a number that tells where it is. Some are joined at once, so that Lua has few to go through:
    -- so many that bodies of commands make less than 1 kB together, nearly always. Before the C library hands out more,
    -- it joins all small blocks that are free, which takes long.
    function memory.new_texts()
        local PAGE, MOST_PIECES = 0x10000, 20
        local pages, parts, pieces, count, size
        local texts = {}

        function texts.forget()
            pages, parts, pieces, count, size = {}, {}, {}, 0, 0
        end
        texts.forget()

        local function join_pieces()
            parts[#parts + 1], count = concat(pieces, "", 1, count), 0
        end

        local function close_page()
            join_pieces()
            pages[#pages + 1] = new_bytes(concat(parts), true)
            parts, size = {}, 0
        end

        function texts.put(text)
            if size >= PAGE / 2 then
                close_page()
            elseif count == MOST_PIECES then
                join_pieces()
            end
            local known = (#pages * PAGE + size) * MOST_LENGTH + #text
            count = count + 1
            pieces[count], size = text, size + #text
            return known
        end

        function texts.get(number)
            local length = number % MOST_LENGTH
            local at = floor(number / MOST_LENGTH)
            local page, start = pages[floor(at / PAGE) + 1], at % PAGE
            if page then return page:raw(start, length) end
            return sub(concat(parts) .. concat(pieces, "", 1, count), start + 1, start + length)
        end

        return texts
    end

    -- Keeps what is known of messages, by place: 1 or 3 numbers each. What is known of some packets in a row is packed
    -- as soon as a later packet has something; what is added to them afterwards is little, and kept beside it.
    function memory.new_notes(width)
        local PAGE = 256 * OFFSETS
        local step = width + 1
        -- Numbers that are packed at once: less than 1 kB, too.
        local most = 30 * step
        local FORMAT, FULL_FORMAT = ("d"):rep(width), ("d"):rep(most)
        -- Of the last packets: place and numbers in turn. The list is used again for those that follow.
        local open, count, open_number = {}, 0, 0
        -- A page by its number: that of a text in `packed`, or a byte array if it is too long for one.
        local pages, packed = nil, memory.new_texts()
        local additions, last, last_number
        local notes, pieces = {}, {}

        function notes.forget()
            open, count, open_number = {}, 0, 0
            pages, additions, last, last_number = {}, {}, {}, nil
            packed.forget()
        end
        notes.forget()

        local function close_page()
            if count == 0 then return end
            local stop = 0
            for first = 1, count, most do
                local size = math.min(most, count - first + 1)
                stop = stop + 1
                pieces[stop] = pack(size == most and FULL_FORMAT or ("d"):rep(size),
                    table.unpack(open, first, first + size - 1))
            end
            local text = concat(pieces, "", 1, stop)
            pages[open_number] = #text < MOST_LENGTH and packed.put(text) or new_bytes(text, true)
            count = 0
        end

        -- A page is by place where its numbers begin.
        local function read_page(number)
            local found, page = {}, pages[number]
            if not page then return found end
            local text = type(page) == "number" and packed.get(page) or page:raw()
            for at = 1, #text, step * NUMBER_SIZE do
                found[unpack("d", text, at)] = sub(text, at + NUMBER_SIZE, at + step * NUMBER_SIZE - 1)
            end
            return found
        end

        function notes.put(place, first, second, third)
            local start = open_number * PAGE
            if place < start then
                additions[place] = pack(FORMAT, first, second, third)
                return
            elseif place >= start + PAGE then
                close_page()
                open_number = floor(place / PAGE)
            end
            local at = count
            open[at + 1], open[at + 2] = place, first
            if second then open[at + 3], open[at + 4] = second, third end
            count = at + step
        end

        -- The numbers of a place; nothing where it has none.
        function notes.get(place)
            local number = floor(place / PAGE)
            if number == open_number then
                for at = count - width, 1, -step do
                    if open[at] == place then return table.unpack(open, at + 1, at + width) end
                end
                return nil
            end
            local text = additions[place]
            if not text then
                if number ~= last_number then last, last_number = read_page(number), number end
                text = last[place]
                if not text then return nil end
            end
            return unpack(FORMAT, text)
        end

        return notes
    end
end

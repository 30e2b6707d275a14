-- Memory ------------------------------------------------------------------------------------------------------------
--
-- What is worth keeping of a capture, in little space however long it is.

local memory, row_of, place_of, number_of
do
    memory = {}

    -- What was found out of the bodies of the last commands, as a dialogue says the same again and again. Each has a
    -- row, which some of its bytes tell, and takes it from the one before; in each column is what is known of it, or
    -- false. So what comes once costs little, and no table grows for it.
    local ROWS = 1024
    local bodies, columns = {}, {}
    local last_body, last_row

    local function clear(column)
        for row = 1, ROWS do
            column[row] = false
        end
        return column
    end
    clear(bodies)

    function memory.new_column()
        local column = clear({})
        columns[#columns + 1] = column
        return column
    end

    -- Bytes near the start and at the end, as bodies are alike in others. A few are so short that some are missing.
    local function new_row(body)
        local a, b, c, d, e = byte(body, 3, 7)
        local y, z = byte(body, -2, -1)
        if not e then return 1 + (31 * (a or 0) + 257 * (b or 0) + 7 * (c or 0) + 61 * (d or 0)) % ROWS end
        return 1 + (#body + 5 * a + 31 * b + 7 * c + 61 * d + 127 * e + 257 * y + 11 * z) % ROWS
    end

    function row_of(body)
        if body == last_body then return last_row end
        local row = new_row(body)
        if bodies[row] ~= body then
            bodies[row] = body
            for index = 1, #columns do
                columns[index][row] = false
            end
        end
        last_body, last_row = body, row
        return row
    end

    function memory.forget_rows()
        last_body = nil
        clear(bodies)
    end

    -- A message's place is the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    function place_of(number, offset)
        return number * OFFSETS + offset
    end

    function number_of(place)
        return floor(place / OFFSETS)
    end

    -- What is kept for good lies outside of Lua, in byte arrays: Lua lets all that it holds double before it frees
    -- anything.
    local new_bytes, pack, unpack = ByteArray.new, Struct.pack, Struct.unpack
    local NUMBER_SIZE = 8

    -- Keeps what is known of messages, by place: 1 or 3 numbers each. What is known of some packets in a row is packed
    -- as soon as a later packet has something; what is added to them afterwards is little, and kept beside it.
    function memory.new_notes(width)
        local PAGE = 256 * OFFSETS
        local step = width + 1
        -- Numbers that are packed at once.
        local most = 60 * step
        local FORMAT, FULL_FORMAT = ("d"):rep(width), ("d"):rep(most)
        -- Of the last packets: place and numbers in turn. The list is used again for those that follow.
        local open, count, open_number = {}, 0, 0
        local pages, additions, last, last_number
        local notes, pieces = {}, {}

        function notes.forget()
            open, count, open_number = {}, 0, 0
            pages, additions, last, last_number = {}, {}, {}, nil
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
            pages[open_number] = new_bytes(concat(pieces, "", 1, stop), true)
            count = 0
        end

        -- A page is by place where its numbers begin.
        local function read_page(number)
            local found, page = {}, pages[number]
            if not page then return found end
            local text = page:raw()
            for at = 1, #text, step * NUMBER_SIZE do
                found[unpack("d", text, at)] = sub(text, at + NUMBER_SIZE, at + step * NUMBER_SIZE - 1)
            end
            return found
        end

        function notes.put(place, first, second, third)
            local number = floor(place / PAGE)
            if number < open_number then
                additions[place] = pack(FORMAT, first, second, third)
                return
            elseif number > open_number then
                close_page()
                open_number = number
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

    -- Keeps texts, each by a number that tells where it is.
    function memory.new_texts()
        local PAGE, MOST_LENGTH = 0x10000, 0x10000
        local pages, pieces, count, size
        local texts = {}

        function texts.forget()
            pages, pieces, count, size = {}, {}, 0, 0
        end
        texts.forget()

        function texts.put(text)
            if size >= PAGE / 2 then
                pages[#pages + 1] = new_bytes(concat(pieces, "", 1, count), true)
                count, size = 0, 0
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
            return sub(concat(pieces, "", 1, count), start + 1, start + length)
        end

        return texts
    end
end

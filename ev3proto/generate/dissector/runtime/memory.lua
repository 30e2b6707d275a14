-- Memory ------------------------------------------------------------------------------------------------------------
--
-- What is worth keeping of a capture, in little space however long it is.

local memory, place_of, number_of
do
    memory = {}

    -- What was found out of the bodies of commands, as a dialogue says the same again and again. A body has a row,
    -- which some of its bytes tell. One that comes to its row twice, with no other between, has an entry there from
    -- then on; so what comes once costs little. An entry has what others find out of it:
    --   line      what is said of it in one line
    --   trouble   what is wrong with it, where something is: `fault`, `complaints`
    --   steps     what it adds to the tree
    --   layout    that of its replies
    --   number    under which it is kept for good
    local ROWS = 8191
    local entries, keys

    -- Once the lists that entries keep have so many elements together, there is no room for another one. After so many
    -- that found none all is forgotten: by then the dialogue may be another one.
    local MOST_ELEMENTS, MOST_REFUSED = 0x10000, 0x2000
    local elements, refused = 0, 0

    -- Steps are long. Where most commands find no room for theirs, what the others keep costs more than it saves, as
    -- Lua goes through all of it whenever it frees something. So once MOST_CROWDED found none, and steps were used less
    -- than twice as often, all is forgotten, and nothing is kept of the next PAUSE commands that are added to the tree.
    local MOST_CROWDED, PAUSE = 0x200, 0x4000
    local used, crowded, pause

    -- Of the body that was asked for last: a command and its reply ask several times.
    local last_body, last_entry

    function memory.forget_entries()
        entries, keys = {}, {}
        elements, refused, last_body, last_entry = 0, 0, nil, nil
        used, crowded, pause = 0, 0, 0
    end
    memory.forget_entries()

    -- Bytes near the start and at the end, as bodies are alike in others. A few are so short that some are missing.
    local function key_of(body)
        local a, b, c, d, e = byte(body, 3, 7)
        local y, z = byte(body, -2, -1)
        if not e then return (a or 0) + 0x100 * (b or 0) + 0x10000 * (c or 0) + 0x1000000 * (d or 0) end
        return #body + 0x101 * a + 0x1003 * b + 0x10007 * c + 0x10000D * d + 0x1000015 * e + 0x3000011 * y
            + 0x700001F * z
    end

    -- Its entry, if it has one.
    function memory.entry_of(body)
        if body == last_body then return last_entry end
        local entry = entries[1 + key_of(body) % ROWS]
        last_body, last_entry = body, entry and entry.body == body and entry or nil
        return last_entry
    end

    -- The same when a command comes, which is added to the tree or not.
    function memory.meet(body, is_shown)
        if is_shown and pause > 0 then
            pause, last_body, last_entry = pause - 1, body, nil
            return nil
        end
        local key = key_of(body)
        local row = 1 + key % ROWS
        local entry = entries[row]
        if not entry or entry.body ~= body then
            if keys[row] == key then
                if entry then elements = elements - entry.count end
                entry = {
                    body = body, line = false, trouble = false, steps = false, layout = false, number = false,
                    count = 0,
                }
                entries[row] = entry
            else
                keys[row], entry = key, nil
            end
        end
        last_body, last_entry = body, entry
        return entry
    end

    -- Whether entries may keep more lists.
    function memory.has_room()
        if elements < MOST_ELEMENTS then return true end
        refused = refused + 1
        if refused > MOST_REFUSED then memory.forget_entries() end
        return false
    end

    -- The steps that an entry keeps, if it does.
    function memory.steps_of(entry)
        local steps = entry.steps
        if steps then used = used + 1 end
        return steps
    end

    -- Whether entries may keep more steps.
    function memory.has_room_for_steps()
        if memory.has_room() then return true end
        crowded = crowded + 1
        if crowded < MOST_CROWDED then return false end
        if used < 2 * crowded then
            memory.forget_entries()
            pause = PAUSE
        else
            used, crowded = 0, 0
        end
        return false
    end

    -- Says that an entry keeps a list of so many elements from now on.
    function memory.count_elements(entry, count)
        entry.count, elements = entry.count + count, elements + count
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

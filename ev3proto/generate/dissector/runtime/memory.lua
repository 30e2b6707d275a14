-- Memory ------------------------------------------------------------------------------------------------------------
--
-- What is worth keeping of a capture, in little space however long it is.

local memory, place_of, number_of
do
    memory = {}

    -- What was found out of the bodies of commands, as a dialogue says the same again and again. A body has a number,
    -- its entry, by which others keep in these tables what they find out:
    --   lines      what is said of it in one line
    --   troubles   what is wrong with it, where something is: `fault`, `complaints`
    --   steps      what it adds to the tree
    --   layouts    that of its replies
    --   numbers    under which it is kept for good
    -- So many bodies have an entry at most, and all but the steps takes so much together, in elements of a list.
    local MOST_ENTRIES, MOST_ELEMENTS = 5000, 0x60000
    local entries, count, elements

    -- The bytes that an element takes, and the elements that an entry takes with nothing kept.
    local ELEMENT_SIZE, ENTRY_ELEMENTS = 16, 8

    -- Where there is no room for another entry, what counts is how many commands had one, of so many at least. If less
    -- than a quarter had, all is forgotten: by then the dialogue is another one. If entries never were of use, commands
    -- hardly repeat, and only one that comes again gets an entry from then on: Lua goes through all that it holds
    -- whenever it frees something.
    local LEAST_MET = 1000
    local met, known, was_of_use, is_choosy

    -- The same holds for commands that are added to the tree, as steps are long. A command comes again where no other
    -- in its row came in between. Some bytes of the body tell the row.
    local ROWS = 8191
    local keys

    -- Where most commands find no room for their steps, what the others keep costs more than it saves. So once
    -- MOST_CROWDED found none, and steps were used less than twice as often, all is forgotten, and nothing is kept of
    -- the next PAUSE commands that are added to the tree.
    local MOST_STEP_ELEMENTS, MOST_CROWDED, PAUSE = 0x10000, 0x200, 0x4000
    local step_elements, used, crowded, pause

    function memory.forget_entries()
        entries, count, elements, keys = {}, 0, 0, {}
        memory.lines, memory.troubles, memory.layouts, memory.numbers = {}, {}, {}, {}
        met, known, was_of_use, is_choosy = 0, 0, false, false
        memory.steps = {}
        step_elements, used, crowded, pause = 0, 0, 0, 0
    end
    memory.forget_entries()

    local function is_full()
        return count >= MOST_ENTRIES or elements >= MOST_ELEMENTS
    end

    local function look_back()
        if known >= met / 4 then
            met, known, was_of_use = 0, 0, true
            return
        end
        local hardly_repeat = not was_of_use
        memory.forget_entries()
        is_choosy = hardly_repeat
    end

    -- Its entry, if it has one.
    function memory.entry_of(body)
        return entries[body]
    end

    -- Bytes near the start and at the end, as bodies are alike in others. A few are so short that some are missing.
    local function key_of(body)
        local a, b, c, d, e, f, g = byte(body, 3, 9)
        local y, z = byte(body, -2, -1)
        if not g then
            return (a or 0) + 0x100 * (b or 0) + 0x10000 * (c or 0) + 0x1000000 * (d or 0) + 0x100000000 * (e or 0)
                + 0x10000000000 * (f or 0)
        end
        return #body + 0x101 * a + 0x1003 * b + 0x10007 * c + 0x10000D * d + 0x1000015 * e + 0x1800037 * f
            + 0x280003D * g + 0x3000011 * y + 0x700001F * z
    end

    local function comes_again(body)
        local key = key_of(body)
        local row = 1 + key % ROWS
        if keys[row] == key then return true end
        keys[row] = key
        return false
    end

    -- The same when a command comes, which is added to the tree or not: it may get one.
    function memory.meet(body, is_shown)
        if is_shown and pause > 0 then
            pause = pause - 1
            return nil
        end
        met = met + 1
        local entry = entries[body]
        if entry then
            known = known + 1
        elseif is_full() then
            if met >= LEAST_MET then look_back() end
        elseif not (is_shown or is_choosy) or comes_again(body) then
            count = count + 1
            elements = elements + ENTRY_ELEMENTS + #body / ELEMENT_SIZE
            entry = count
            entries[body] = entry
        end
        return entry
    end

    -- Whether so many elements more may be kept. They count from then on.
    function memory.take_room(added)
        if elements + added > MOST_ELEMENTS then return false end
        elements = elements + added
        return true
    end

    -- Keeps the line of an entry and what is wrong with the command, if there is room.
    function memory.keep_line(entry, line, fault, complaints)
        local size = #line
        for index = 2, complaints and #complaints or 0, 2 do
            size = size + #complaints[index] + 2 * ELEMENT_SIZE
        end
        if not memory.take_room(size / ELEMENT_SIZE) then return end
        memory.lines[entry] = line
        if fault or complaints then memory.troubles[entry] = { fault = fault, complaints = complaints } end
    end

    -- The steps that an entry keeps, if it does.
    function memory.steps_of(entry)
        local steps = memory.steps[entry]
        if steps then used = used + 1 end
        return steps
    end

    -- Whether entries may keep more steps.
    function memory.has_room_for_steps()
        if step_elements < MOST_STEP_ELEMENTS then return true end
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

    -- Keeps the steps of an entry.
    function memory.keep_steps(entry, steps)
        memory.steps[entry] = steps
        step_elements = step_elements + steps.count
    end

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

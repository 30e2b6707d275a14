-- Memory ------------------------------------------------------------------------------------------------------------
--
-- Where a message is, and how what packets leave behind is freed.

local free_unused, place_of, number_of
do
    -- What a packet leaves behind, items and ranges of a tree above all, Lua frees when all that it holds has doubled,
    -- in small steps. By then it is in no cache of the processor any more, and that takes up to a quarter of the time.
    -- So it is freed as soon as there is some of it; how Lua frees otherwise stays as it is. Where other scripts hold
    -- much, all is left to Lua: going through that would take long.
    do
        local GROWTH, MOST_KILOBYTES = 1.15, 32 * 1024
        local limit = 0

        function free_unused()
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
end

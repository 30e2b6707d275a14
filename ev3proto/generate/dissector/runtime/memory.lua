-- Memory ------------------------------------------------------------------------------------------------------------
--
-- The places of messages, and the garbage of trees.

local storage = {}
do
    -- The place of a message: the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    function storage.place_of(number, offset)
        return number * OFFSETS + offset
    end

    function storage.number_of(place)
        return floor(place / OFFSETS)
    end

    -- Items and ranges of a tree are garbage after their packet. Collected soon, they are still in the processor's
    -- cache. With much memory held, as by other scripts, a collection takes long. Lua's own would wait until twice the
    -- memory is used.
    local SOON, LATER, MUCH_KILOBYTES = 1.15, 1.5, 32 * 1024
    local limit = 0

    function storage.free_unused(is_shown)
        local size = collectgarbage("count")
        if size < limit then return end
        -- Finalizers of other scripts may raise errors.
        pcall(collectgarbage)
        size = collectgarbage("count")
        limit = size * (is_shown and size < MUCH_KILOBYTES and SOON or LATER)
    end
end

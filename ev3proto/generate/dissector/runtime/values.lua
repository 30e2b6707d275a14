-- Reply values ------------------------------------------------------------------------------------------------------
--
-- A reply to a direct command is only memory. The command's output parameters that are global variables tell what it
-- contains and where.

local reply_values = {}
do
    -- Returns the number of bytes or elements of a parameter, by its length parameter, else `most`. `stated` has the
    -- constants that were given for length parameters, and for the type and mode of readings.
    function reply_values.stated_length(parameter, stated, most)
        local length = parameter.length
        if type(length) == "string" then length = stated[length] end
        if not length then return most end
        -- Negative lengths: -1 for no limit, others for bytes in reverse order.
        if length == -1 and parameter.type == STRING then return most end
        return floor(math.abs(length))
    end

    -- Returns what a parameter receives from a device, by the stated type and mode: name, and unit if it has one; or
    -- nil.
    function reply_values.dataset_of(parameter, stated)
        local modes = parameter.reading and READINGS[stated.TYPE]
        local mode = modes and modes[stated.MODE]
        return mode and (parameter.reading == "si" or mode.agrees) and mode[parameter.number] or nil
    end

    -- Returns the type of an output that has the type of an array: the largest that fits before the operation's next
    -- output.
    local function untyped(output, outputs, stop)
        for _, other in ipairs(outputs) do
            if other.at == output.at and output.index < other.index and other.index < stop then stop = other.index end
        end
        local room = stop - output.index
        return room >= 4 and DATA32 or room >= 2 and DATA16 or room >= 1 and DATA8 or DATA32
    end

    -- Reads the `value` of an output, which may be a list, and its `size`. Returns false if the memory ends before it.
    function reply_values.read(output, outputs, memory)
        local parameter, start, stated = output.parameter, output.index, output.stated
        local kind = output.is_handle and HANDLE or parameter.type
        if kind == STRING then
            local stop = math.min(start + reply_values.stated_length(parameter, stated, #memory), #memory)
            output.value = sub(memory, start + 1, stop):match("^[^\0]*")
            output.size = #output.value
            return start < #memory
        end
        local is_list = parameter.length and kind ~= ARRAY_TYPED and not output.is_handle
        if kind == ARRAY_TYPED then kind = untyped(output, outputs, #memory) end
        local read, size = reading.READ_TYPE[kind], SIZE_OF[kind]
        if not read then return false end
        if not is_list then
            output.value, output.size = read(memory, start), size
            return output.value ~= nil
        end
        local room = floor((#memory - start) / size)
        local count = math.min(reply_values.stated_length(parameter, stated, room), room)
        if count < 1 then return false end
        local list = {}
        for index = 1, count do list[index] = read(memory, start + (index - 1) * size) end
        output.value, output.size = list, count * size
        return true
    end
end

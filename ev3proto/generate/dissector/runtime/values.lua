-- Reply values ------------------------------------------------------------------------------------------------------
--
-- A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
-- says what is in it and where.

local stated_length, tells_length, read_output
do
    -- How many bytes or elements a parameter has: what its length parameter says, or `most` where that does not say it.
    -- `lengths` are the constants of those parameters that say one.
    function stated_length(parameter, lengths, most)
        local length = parameter.length
        if type(length) == "string" then length = lengths[length] end
        if not length then return most end
        -- Some lengths are negative: -1 for no limit, others for bytes in reverse order.
        if length == -1 and parameter.type == STRING then return most end
        return floor(math.abs(length))
    end

    -- Whether an argument is a number in the frame itself that says how long another parameter is.
    function tells_length(parameter, encoding)
        return parameter.tells_length and encoding.kind == CONSTANT and not encoding.handle and not encoding.address
    end

    -- The type of an output that has that of the array it comes from: what fits before the next output of its
    -- operation.
    local function untyped(output, outputs, stop)
        for _, other in ipairs(outputs) do
            if other.at == output.at and output.index < other.index and other.index < stop then stop = other.index end
        end
        local room = stop - output.index
        return room >= 4 and DATA32 or room >= 2 and DATA16 or room >= 1 and DATA8 or DATA32
    end

    -- Reads the `value` of an output, which may be a list, and the `size` of that. False where the memory ends before.
    function read_output(output, outputs, memory)
        local parameter, start, lengths = output.parameter, output.index, output.lengths
        local kind = output.is_handle and HANDLE or parameter.type
        if kind == STRING then
            local stop = math.min(start + stated_length(parameter, lengths, #memory), #memory)
            output.value = sub(memory, start + 1, stop):match("^[^\0]*")
            output.size = #output.value
            return start < #memory
        end
        local is_list = parameter.length and kind ~= ARRAY_TYPED and not output.is_handle
        if kind == ARRAY_TYPED then kind = untyped(output, outputs, #memory) end
        local read, size = READ_TYPE[kind], SIZE_OF[kind]
        if not read then return false end
        if not is_list then
            output.value, output.size = read(memory, start), size
            return output.value ~= nil
        end
        local room = floor((#memory - start) / size)
        local count = math.min(stated_length(parameter, lengths, room), room)
        if count < 1 then return false end
        local list = {}
        for index = 1, count do
            list[index] = read(memory, start + (index - 1) * size)
        end
        output.value, output.size = list, count * size
        return true
    end
end

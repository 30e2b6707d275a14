-- Reply values ------------------------------------------------------------------------------------------------------
--
-- A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
-- says what stands in it and where.

-- How many bytes or elements a parameter has: what its length parameter says, or `most` where that does not say it.
-- `lengths` are the constants of those parameters that tell one.
local function stated_length(parameter, lengths, most)
    local length = parameter.length
    if type(length) == "string" then length = lengths[length] end
    if not length then return most end
    -- Some lengths are negative: -1 for no limit, others for bytes in reverse order.
    if length == -1 and parameter.type == STRING then return most end
    return floor(math.abs(length))
end

-- Whether an argument is a number in the frame itself that tells how long another parameter is.
local function tells_length(parameter, encoding)
    return parameter.tells_length and encoding.kind == CONSTANT and not encoding.handle and not encoding.address
end

local read_reply
do
    -- The type of an output that has that of the array it comes from: what fits before the next output.
    local function untyped(outputs, start, stop)
        for _, output in ipairs(outputs) do
            if start < output.index and output.index < stop then stop = output.index end
        end
        local room = stop - start
        return room >= 4 and DATA32 or room >= 2 and DATA16 or room >= 1 and DATA8 or DATA32
    end

    -- Reads an output in a reply: its value (or a list of them) and size. False where the memory ends before. Of a list
    -- so many are read at most.
    local function read_output(output, outputs, reply, most_read)
        -- At an address there is no value but where the value is.
        if output.is_address then return false end
        local parameter, start = output.parameter, output.index
        local most, at = reply.stop - HEADER_SIZE, HEADER_SIZE + start
        local type = output.type
        local read, size = READ_TYPE[type], SIZE_OF[type]
        -- Nearly all are one number.
        if read and not output.is_list then
            if start + size > most then return false end
            output.size, output.value = size, read(reply.text, at)
            return true
        elseif type == STRING then
            local stop = math.min(start + stated_length(parameter, outputs.lengths, most), most)
            output.value = sub(reply.text, at + 1, HEADER_SIZE + stop):match("^[^\0]*")
            output.size = #output.value
            return start < most
        elseif type == ARRAY_TYPED then
            type = untyped(outputs, start, most)
            read, size = READ_TYPE[type], SIZE_OF[type]
        end
        if not read then return false end
        local count = output.is_list and stated_length(parameter, outputs.lengths, floor(most / size)) or 1
        local room = floor((most - start) / size)
        if output.is_list and count > room then count = room end
        if count < 1 or count > room then return false end
        output.size = count * size
        if output.is_list then
            output.list = {}
            for index = 1, math.min(count, most_read) do
                output.list[index] = read(reply.text, at + (index - 1) * size)
            end
        else
            output.value = read(reply.text, at)
        end
        return true
    end

    local function collect(outputs, parameter, encoding, value)
        if encoding.kind == GLOBAL and parameter.is_output then
            local is_handle = encoding.handle
            outputs[#outputs + 1] = {
                parameter = parameter, index = value, is_handle = is_handle, is_address = encoding.address,
                type = is_handle and HANDLE or parameter.type,
                is_list = parameter.length and parameter.type ~= ARRAY_TYPED and parameter.type ~= STRING
                    and not is_handle,
                size = 0, value = false,
            }
        elseif tells_length(parameter, encoding) then
            outputs.lengths[parameter.name] = value
        end
    end

    -- The outputs of a command's operations: { operation, those that are in a reply, all of them }, and the first
    -- operation. `body` is what follows the command's header.
    local function layout_of_body(body)
        local at, layout = MEMORY_FIELD, {}
        local outputs = { lengths = {} }
        while at < #body do
            local operation, behind, fault = read_operation(body, at, #body, collect, outputs, true)
            if outputs[1] then layout[#layout + 1] = { operation = operation, all = outputs, values = {} } end
            layout.first = layout.first or operation
            if outputs[1] or next(outputs.lengths) then outputs = { lengths = {} } end
            if fault then break end
            at = behind
        end
        return layout
    end

    -- Those of the last commands.
    local layouts = new_memory(1024, function(layout) return 1 + #layout end)

    -- Reads what a reply says: the operations of the command that have outputs, each with `values`, those of them that
    -- are in the reply. Valid until the next reply is read. Returns how many values there are, too. Lists have all
    -- their elements where the tree shows them, else no more than a line says.
    function read_reply(body, reply, is_shown)
        local layout = layouts.get(body)
        if not layout then
            layout = layout_of_body(body)
            layouts.put(body, layout)
        end
        local count, most_read = 0, is_shown and math.huge or MOST_VALUES + 1
        for number = 1, #layout do
            local group = layout[number]
            local outputs, values, found = group.all, group.values, 0
            for index = 1, #outputs do
                local output = outputs[index]
                if read_output(output, outputs, reply, most_read) then
                    found = found + 1
                    values[found] = output
                end
            end
            for index = #values, found + 1, -1 do
                values[index] = nil
            end
            count = count + found
        end
        return layout, count
    end
end

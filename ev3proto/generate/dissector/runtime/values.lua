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

local reply_values, forget_layouts
do
    -- The type of an output that has that of the array it comes from: what fits before the next output.
    local function untyped(outputs, start, stop)
        for _, output in ipairs(outputs) do
            if start < output.index and output.index < stop then stop = output.index end
        end
        local room = stop - start
        return room >= 4 and DATA32 or room >= 2 and DATA16 or room >= 1 and DATA8 or DATA32
    end

    -- Reads an output in a reply: its value (or a list of them), offset and size. False where the memory ends before.
    local function read_output(output, outputs, reply)
        -- At an address there is no value but where the value is.
        if output.is_address then return false end
        local parameter, start = output.parameter, output.index
        local type = output.is_handle and HANDLE or parameter.type
        local most, at = reply.stop - HEADER_SIZE, HEADER_SIZE + start
        output.at, output.list, output.value = at, nil, nil
        if type == STRING then
            local stop = math.min(start + stated_length(parameter, outputs.lengths, most), most)
            output.value = sub(reply.text, at + 1, HEADER_SIZE + stop):match("^[^\0]*")
            output.size = #output.value
            return start < most
        end
        local is_list = parameter.length and type ~= ARRAY_TYPED and not output.is_handle
        if type == ARRAY_TYPED then type = untyped(outputs, start, most) end
        local read = READ_TYPE[type]
        if not read then return false end
        local size = SIZE_OF[type]
        local count = is_list and stated_length(parameter, outputs.lengths, floor(most / size)) or 1
        local room = floor((most - start) / size)
        if is_list and count > room then count = room end
        if count < 1 or count > room then return false end
        output.size = count * size
        if is_list then
            output.list = {}
            for index = 1, count do
                output.list[index] = read(reply.text, at + (index - 1) * size)
            end
        else
            output.value = read(reply.text, at)
        end
        return true
    end

    local function collect(outputs, parameter, encoding, value)
        if encoding.kind == GLOBAL and parameter.is_output then
            outputs[#outputs + 1] = {
                parameter = parameter, index = value, is_handle = encoding.handle, is_address = encoding.address,
            }
        elseif tells_length(parameter, encoding) then
            outputs.lengths[parameter.name] = value
        end
    end

    -- The outputs of a command's operations, those of each with the operation.
    local function outputs_of(text)
        local at, layout = COMMAND_HEADER_SIZE, {}
        local outputs = { lengths = {} }
        while at < #text do
            local operation, behind, fault = read_operation(text, at, #text, collect, outputs, true)
            if outputs[1] then
                outputs.operation = operation
                layout[#layout + 1] = outputs
            end
            layout.first = layout.first or operation
            if outputs[1] or next(outputs.lengths) then outputs = { lengths = {} } end
            if fault then break end
            at = behind
        end
        return layout
    end

    -- Those of the last commands, by all that follows their headers: a dialogue asks the same again and again.
    local MOST_REMEMBERED = 1024
    local remembered, count_remembered = {}, 0

    function forget_layouts()
        remembered, count_remembered = {}, 0
    end

    local function layout_of(text)
        local body = sub(text, HEADER_SIZE + 1)
        local layout = remembered[body]
        if not layout then
            layout = outputs_of(text)
            if count_remembered >= MOST_REMEMBERED then forget_layouts() end
            remembered[body], count_remembered = layout, count_remembered + 1
        end
        return layout
    end

    -- What a reply says, operation by operation: { operation, its outputs }. `text` is the frame of the command.
    -- Returns its first operation, too.
    function reply_values(text, reply)
        local found = {}
        local layout = layout_of(text)
        for _, outputs in ipairs(layout) do
            local values = {}
            for _, output in ipairs(outputs) do
                if read_output(output, outputs, reply) then values[#values + 1] = output end
            end
            if values[1] then found[#found + 1] = { operation = outputs.operation, values = values } end
        end
        return found, layout.first
    end
end

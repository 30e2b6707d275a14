-- Reply values ------------------------------------------------------------------------------------------------------
--
-- A reply to a direct command is nothing but memory. Every output parameter of the command that names a global variable
-- says what stands in it and where.

-- How many bytes or elements a parameter has: what its length parameter says, or `most` where that does not say it.
-- `lengths` are the constants of those parameters that say one.
local function stated_length(parameter, lengths, most)
    local length = parameter.length
    if type(length) == "string" then length = lengths[length] end
    if not length then return most end
    -- Some lengths are negative: -1 for no limit, others for bytes in reverse order.
    if length == -1 and parameter.type == STRING then return most end
    return floor(math.abs(length))
end

-- Whether an argument is a number in the frame itself that says how long another parameter is.
local function tells_length(parameter, encoding)
    return parameter.tells_length and encoding.kind == CONSTANT and not encoding.handle and not encoding.address
end

-- Notes what a reply will hold while its command is read: start, note_output, note_lengths, note_first, keep.
local layout_notes = {}

local read_reply
do
    -- The layout of a reply is a list of the outputs of its command, so many entries each: the offset of the operation,
    -- parameter, encoding, index, field, operation; and its `size`, as more may follow. `first` is the first operation;
    -- `lengths`, by the offset of their operation, are constants that say how long outputs are.
    local OUTPUT = 6

    -- The layout of the command that is being read, or was read last.
    local draft = {}
    local draft_size, draft_lengths, draft_first

    -- What follows the header of the command whose layout it is; nil where nobody will ask for it.
    local draft_body

    function layout_notes.start()
        draft_size, draft_lengths, draft_first, draft_body = 0, nil, nil, nil
    end

    -- Notes an output: an output parameter that names a global variable.
    function layout_notes.note_output(view, parameter, encoding, index, declared)
        local size = draft_size
        draft[size + 1] = view.offset
        draft[size + 2] = parameter
        draft[size + 3] = encoding
        draft[size + 4] = index
        draft[size + 5] = declared
        draft[size + 6] = view.operation
        draft_size = size + OUTPUT
    end

    -- Notes the constants of an operation that say how long its outputs are.
    function layout_notes.note_lengths(offset, lengths)
        draft_lengths = draft_lengths or {}
        draft_lengths[offset] = lengths
    end

    function layout_notes.note_first(operation)
        draft_first = operation
    end

    local function finish_draft()
        draft.size, draft.first, draft.lengths = draft_size, draft_first, draft_lengths
        -- Where the outputs of the last operation end.
        draft[draft_size + 1] = false
    end

    -- The type of an output that has that of the array it comes from: what fits before the next output of its
    -- operation.
    local function untyped(layout, at, stop)
        local offset, start = layout[at], layout[at + 3]
        while layout[at - OUTPUT] == offset do
            at = at - OUTPUT
        end
        while layout[at] == offset do
            local index = layout[at + 3]
            if start < index and index < stop then stop = index end
            at = at + OUTPUT
        end
        local room = stop - start
        return room >= 4 and DATA32 or room >= 2 and DATA16 or room >= 1 and DATA8 or DATA32
    end

    local NONE = {}

    -- Reads into `output` what a reply has for one entry of the layout: `value` or `list`, size, and whose it is. False
    -- where the memory ends before. Of a list so many are read at most.
    local function read_output(output, layout, at, reply, most_read)
        local parameter, encoding, start = layout[at + 1], layout[at + 2], layout[at + 3]
        -- At an address there is no value but where the value is.
        if encoding.address then return false end
        local is_handle = encoding.handle
        local type = is_handle and HANDLE or parameter.type
        local text, most = reply.text, reply.stop - HEADER_SIZE
        local read, size = READ_TYPE[type], SIZE_OF[type]
        output.parameter, output.index, output.is_handle = parameter, start, is_handle
        output.field, output.operation, output.offset, output.list =
            layout[at + 4], layout[at + 5], layout[at], false
        local is_list = parameter.length and type ~= ARRAY_TYPED and type ~= STRING and not is_handle
        -- Nearly all are one number.
        if read and not is_list then
            if start + size > most then return false end
            output.size, output.value = size, read(text, HEADER_SIZE + start)
            return true
        end
        local lengths = layout.lengths and layout.lengths[output.offset] or NONE
        if type == STRING then
            local stop = math.min(start + stated_length(parameter, lengths, most), most)
            output.value = sub(text, HEADER_SIZE + start + 1, HEADER_SIZE + stop):match("^[^\0]*")
            output.size = #output.value
            return start < most
        elseif type == ARRAY_TYPED then
            type = untyped(layout, at, most)
            read, size = READ_TYPE[type], SIZE_OF[type]
        end
        if not read then return false end
        local count = is_list and stated_length(parameter, lengths, floor(most / size)) or 1
        local room = floor((most - start) / size)
        if is_list and count > room then count = room end
        if count < 1 or count > room then return false end
        output.size = count * size
        if is_list then
            output.list = {}
            for index = 1, math.min(count, most_read) do
                output.list[index] = read(text, HEADER_SIZE + start + (index - 1) * size)
            end
        else
            output.value = read(text, HEADER_SIZE + start)
        end
        return true
    end

    local function note_argument(view, parameter, encoding, value, declared)
        if encoding.scope then
            if parameter.is_output and encoding.kind == GLOBAL then
                layout_notes.note_output(view, parameter, encoding, value, declared)
            end
        elseif tells_length(parameter, encoding) then
            view.lengths = view.lengths or {}
            view.lengths[parameter.name] = value
        end
    end

    -- `body` is what follows a command's header.
    local function draft_layout(body)
        local at, view = MEMORY_FIELD, {}
        layout_notes.start()
        while at < #body do
            local operation, after = select_operation(body, at, #body)
            if not operation then break end
            draft_first = draft_first or operation
            view.offset, view.operation, view.lengths = at, operation, nil
            local fault
            after, fault = read_arguments(operation, body, after, #body, note_argument, view, true)
            if view.lengths then layout_notes.note_lengths(at, view.lengths) end
            if fault then break end
            at = after
        end
        draft_body = body
        finish_draft()
    end

    -- Says that the layout was noted of which a reply will ask: nearly always before another one is.
    function layout_notes.keep(body)
        draft_body = body
        finish_draft()
    end

    -- The layout of the replies to a command, by what follows its header. It lasts until the next command is read.
    function layout_notes.layout_for(body)
        if body ~= draft_body then draft_layout(body) end
        return draft
    end

    local function head_of(layout)
        return layout.first and "reply to " .. layout.first.title .. ":" or "reply:"
    end

    -- The values found; they are overwritten by those of the next reply.
    local found = {}

    -- The values in a reply by its layout, how many there are, and how the line on it begins. Where the tree is not
    -- shown, no more of them than a line says, and of lists no more elements.
    function read_reply(layout, reply, is_shown)
        local count, most = 0, is_shown and math.huge or MOST_VALUES + 1
        local output = found[1] or {}
        for at = 1, layout.size, OUTPUT do
            found[count + 1] = output
            if read_output(output, layout, at, reply, most) then
                count = count + 1
                if count == most then break end
                output = found[count + 1] or {}
            end
        end
        return found, count, head_of(layout)
    end
end

-- Reading -----------------------------------------------------------------------------------------------------------
--
-- Bytes to operations and fields. A frame is a string. Offsets start at 0, as in all documents about the protocol: the
-- byte at offset 0 is byte(text, 1). Nothing here raises errors: a fault is returned as its offset and reason.

local reading = {}

-- The texts of Phrases below, by which faults are named.
local phrases = {}
do
    local unpack = Struct.unpack

    local NAN = unpack("<f", "\0\0\192\127")

    -- Functions that read a number at an offset, nil if the text ends too early. Most numbers are bytes and words,
    -- which are read faster without Struct.
    local function unsigned8(text, at)
        return byte(text, at + 1)
    end

    function reading.unsigned16(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return high and low + high * 0x100
    end

    -- Returns the bytes of global and local memory that a direct command requests.
    function reading.memory_sizes(text)
        local sizes = reading.unsigned16(text, HEADER_SIZE)
        local globals = sizes % (GLOBAL_MASK + 1)
        return globals, (sizes - globals) / (GLOBAL_MASK + 1)
    end

    local function signed8(text, at)
        local low = byte(text, at + 1)
        return low and low >= 0x80 and low - 0x100 or low
    end

    local function signed16(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return high and low + 0x100 * (high < 0x80 and high or high - 0x100)
    end

    local function reader32(form)
        return function(text, at)
            return at + 4 <= #text and unpack(form, text, at + 1) or nil
        end
    end

    local function single(text, at)
        if at + 4 > #text then return nil end
        local value = unpack("<f", text, at + 1)
        -- All NaNs look the same, also where the machine's own would be printed as -nan.
        return value == value and value or NAN
    end

    local READ_UNSIGNED = { [1] = unsigned8, [2] = reading.unsigned16, [4] = reader32("<I4") }
    local READ_SIGNED = { [1] = signed8, [2] = signed16, [4] = reader32("<i4") }
    reading.READ_TYPE = {
        [DATA8] = signed8, [DATA16] = signed16, [DATA32] = READ_SIGNED[4], [DATAF] = single, [HANDLE] = signed16,
    }

    -- By identification byte: its encoding and, for short forms, the value.
    local SHORT_VALUES = {}
    local ENCODINGS = {}
    reading.ENCODINGS = ENCODINGS
    local SCOPES = { [LOCAL] = "LV(", [GLOBAL] = "GV(" }
    for _, row in ipairs(ENCODING_ROWS) do
        local kind, width = row[4], row[5]
        local scope = SCOPES[kind]
        local encoding = {
            name = row[3], kind = kind, width = width, handle = row.handle, address = row.address, scope = scope,
            label = row[3] .. (row.handle and " HND" or "") .. (row.address and " ADR" or ""),
            -- The value of a variable is its index.
            read = (scope and READ_UNSIGNED or READ_SIGNED)[width], is_long = kind == CONSTANT and width == 4,
        }
        for first = row[1], row[2] do
            ENCODINGS[first] = encoding
            if row.value then SHORT_VALUES[first] = row.value + first - row[1] end
        end
    end

    -- A zero would end the text in Wireshark; its symbol is shown.
    local utf8_of = made_late(function(character)
        local code = byte(character)
        if code == 0 then return "\226\144\128" end
        return string.char(0xC0 + floor(code / 0x40), 0x80 + code % 0x40)
    end)

    -- The brick's strings are ISO-8859-1, Wireshark's are UTF-8.
    function reading.utf8_text(text)
        if not find(text, "[\0\128-\255]") then return text end
        return (gsub(text, "[\0\128-\255]", utf8_of))
    end

    -- Returns the fault of the argument at an offset: its offset, reason and kind.
    local function argument_fault(text, at, name, owner)
        local first = byte(text, at + 1)
        local encoding, values, why = ENCODINGS[first], { name = name, owner = owner }, "cut_argument"
        if first and not encoding then
            values.byte = format("0x%02X", first)
            return at, phrases.finding("UNDEFINED_FORM", values), "fault"
        elseif not first then
            why = "no_argument"
        elseif encoding.kind == CONSTANT_TEXT then
            why = "cut_string"
        else
            values.form, values.more = encoding.name, phrases.plural(at + 1 + encoding.width - #text, "more byte")
        end
        return at, phrases.unreadable("CUT_OFF", owner, why, values), "cut_off"
    end

    -- Returns what is said of an opcode that the firmware lacks.
    local function opcode_reason(code)
        local key, values, others = "UNKNOWN_OPCODE", { byte = format("0x%02X", code), dialect = dialect }, {}
        for _, row in ipairs(OPERATIONS) do
            if row[1] == code and not values.known then
                for _, name in ipairs(DIALECTS) do
                    if row.dialects[name] then others[#others + 1] = name end
                end
                values.known, values.others = row[2], concat(others, " and ")
                key = others[1] and "OTHER_DIALECT" or "UNRELEASED"
            end
        end
        return (phrases.finding(key, values))
    end

    -- Reads the argument at an offset: its encoding, value, and the offset after it; else nil.
    local function read_argument(text, at, is_float)
        local first = byte(text, at + 1)
        local encoding, value = ENCODINGS[first], SHORT_VALUES[first]
        if value then return encoding, value, at + 1 end
        if not encoding then return nil end
        if encoding.kind == CONSTANT_TEXT then
            local zero = find(text, "\0", at + 2, true)
            if not zero then return nil end
            return encoding, sub(text, at + 2, zero - 1), zero
        end
        value = (is_float and encoding.is_long and single or encoding.read)(text, at + 1)
        if value then return encoding, value, at + 1 + encoding.width end
    end

    -- Returns the operation of an opcode and its CMD, and the offset after them; else nil, offset, reason and kind.
    -- `set` has the instructions, by default the preferred ones.
    function reading.select_operation(text, at, set)
        local code = byte(text, at + 1)
        local operation, after = (set or instructions)[code], at + 1
        if not operation then return nil, at, opcode_reason(code), "unknown_opcode" end
        local commands = operation.commands
        if commands then
            local encoding, value
            encoding, value, after = read_argument(text, at + 1)
            if not encoding then return nil, argument_fault(text, at + 1, "CMD", operation.name) end
            if encoding.kind ~= CONSTANT then
                local said = encoding.kind == JUMP and "a label" or "a string"
                if encoding.scope then said = encoding.scope .. value .. ")" end
                local about = { owner = operation.name, value = said }
                return nil, at + 1, phrases.unreadable("VARIABLE_CMD", nil, "variable_cmd", about), "unknown_cmd"
            end
            if not commands[value] then
                local reason = phrases.finding("UNKNOWN_CMD", { owner = operation.name, value = value })
                return nil, at + 1, reason, "unknown_cmd"
            end
            operation = commands[value]
        end
        if not operation.parameters then prepare_operation(operation) end
        return operation, after
    end

    -- Returns the reason why a list cannot have the number of elements in its argument, else nil.
    local function count_fault(list, encoding, value, room)
        local is_number, key = encoding.kind == CONSTANT, "BAD_COUNT"
        if is_number and value >= 0 and value <= room and not (list.is_count and value > MOST_COUNTED) then
            return nil
        end
        if is_number and not list.is_count and (value < 0 or value >= SPINNING) then
            key = "SPINS"
        elseif is_number and value >= 0 and not (list.is_count and value > MOST_COUNTED) then
            key = "CUT_LIST"
        end
        return (phrases.finding(key, {
            name = list.counter.name, value = is_number and value, encoding = not is_number and encoding.name,
            values = is_number and phrases.plural(value, "value"), bytes = phrases.plural(room, "byte"),
        }))
    end

    -- Reads the arguments of an operation, from the offset after its opcode and CMD. `visit` gets each one: its
    -- parameter, encoding, value, the offsets of its first byte and after its last, and `context`. Returns the offset
    -- after the last one that could be read, and after a fault its offset, reason and kind.
    function reading.read_arguments(operation, text, at, visit, context)
        local parameters, list = operation.parameters, operation.list
        local element_type = list and list.element_type
        local index, last, elements = 0, #parameters, nil
        while index < last do
            index = index + 1
            local parameter = parameters[index] or elements[index - #parameters - 1]
            local encoding, value, after = read_argument(text, at, parameter.is_float)
            if not encoding then return at, argument_fault(text, at, parameter.name, operation.name) end
            visit(parameter, encoding, value, at, after, context)
            if list and not elements then
                if parameter.tells_type and encoding.kind == CONSTANT then
                    element_type = FORMAT_TYPES[value] or element_type
                end
                if index == last then
                    local reason = count_fault(list, encoding, value, #text - after)
                    if reason then return after, at, reason, "fault" end
                    elements, last = list.elements_of[element_type], last + value
                end
            end
            at = after
        end
        return at
    end

    local function pass_over() end

    -- Reads one operation with its arguments, as above. Returns the operation, and the same as above.
    function reading.read_operation(text, at, visit, set)
        local operation, after, reason, kind = reading.select_operation(text, at, set)
        if not operation then return nil, at, after, reason, kind end
        return operation, reading.read_arguments(operation, text, after, visit or pass_over)
    end

    -- Reads one field of a system message: its value and the offset after it; else nil, offset and key of the reason.
    local function read_field(text, at, stop, declared, before)
        local kind = declared.kind
        local size = kind == U8 and 1 or kind == U16 and 2 or kind == U32 and 4
        if size then
            if at + size > stop then return nil, at, "no_field" end
            return READ_UNSIGNED[size](text, at), at + size
        elseif kind == TEXT then
            local zero = find(text, "\0", at + 1, true)
            if not zero or zero > stop then return nil, at, "endless_text" end
            return sub(text, at + 1, zero - 1), zero
        elseif kind == COUNTED_TEXT then
            local length = before[declared.name]
            if at + length > stop then return nil, at, "cut_text" end
            -- Some senders count the terminating zero, others do not.
            if length > 0 and byte(text, at + length) == 0 then
                return sub(text, at + 1, at + length - 1), at + length
            elseif at + length >= stop then
                return nil, at, "no_zero"
            elseif byte(text, at + length + 1) ~= 0 then
                return nil, at + length, "other_zero"
            end
            return sub(text, at + 1, at + length), at + length + 1
        end
        if before[declared.name] and before[declared.name] ~= stop - at then return nil, at, "wrong_count" end
        return sub(text, at + 1, stop), stop
    end

    -- Reads the fields of a system message. Returns a list of { declared, value, at, stop }, the offset after them, and
    -- the fault, if any. Replies to failed commands may end before any field: they are not `complete`.
    function reading.read_fields(text, at, stop, declarations, complete, owner)
        local found, counted, counters = {}, {}, {}
        local function fault_at(place, why, name, kind)
            return { at = place, kind = "fault", reason = phrases.unreadable("WRONG_FIELDS", owner, why, {
                name = name, kind = kind and kind:lower(), bytes = phrases.plural(stop - place, "byte"),
                counter = counters[name], stated = counted[name], length = counted[name], size = stop - place,
                byte = format("0x%02X", byte(text, place + 1) or 0),
            }) }
        end
        for _, declared in ipairs(declarations) do
            if at == stop and (declared.optional or not complete) then break end
            local value, after, reason = read_field(text, at, stop, declared, counted)
            if not value then return found, at, fault_at(after, reason, declared.name, declared.kind) end
            found[#found + 1] = { declared = declared, value = value, at = at, stop = after }
            found[declared.name] = value
            if declared.counts then counted[declared.counts], counters[declared.counts] = value, declared.name end
            at = after
        end
        if at < stop then return found, at, fault_at(at, "left_over") end
        return found, at
    end
end

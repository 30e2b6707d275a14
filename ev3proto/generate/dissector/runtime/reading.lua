-- Reading -----------------------------------------------------------------------------------------------------------
--
-- Bytes to operations and fields. A frame is a string; offsets count from its start, as in every text about the
-- protocol, so that the byte at offset 0 is byte(text, 1). What cannot be read comes back as the offset and the reason:
-- nothing here raises an error.

-- What follows a frame's header is its body. That of a direct command begins with the memory it asks for, that of a
-- daisy command with its sub-command and two layers.
local MEMORY_FIELD, DAISY_PAYLOAD = COMMAND_HEADER_SIZE - HEADER_SIZE, 3

local ENCODINGS, READ_TYPE, unsigned16, utf8_text, select_operation, read_arguments, skim_arguments,
    read_operation, read_fields
do
    -- By identification byte: all that it says. Of short forms it is the value, too.
    local SIZES, IS_VARIABLE, SHORT_VALUES = {}, {}, {}
    ENCODINGS = {}
    local SCOPES = { [LOCAL] = "LV(", [GLOBAL] = "GV(" }

    -- How numbers are written, made when asked for: turning a number into a text takes longer than reading it. Those of
    -- one byte are kept.
    local function texts_of(before, after)
        return setmetatable({}, { __index = function(texts, number)
            local text = before .. number .. after
            if number >= -0x80 and number <= 0xFF then texts[number] = text end
            return text
        end })
    end

    local NUMBER_TEXTS = texts_of("", "")
    local VARIABLE_TEXTS = { [LOCAL] = texts_of(SCOPES[LOCAL], ")"), [GLOBAL] = texts_of(SCOPES[GLOBAL], ")") }
    for _, row in ipairs(ENCODING_ROWS) do
        local encoding = {
            name = row[3], kind = row[4], width = row[5], texts = VARIABLE_TEXTS[row[4]] or NUMBER_TEXTS,
            label = row[3] .. (row.handle and " HND" or "") .. (row.address and " ADR" or ""),
            scope = SCOPES[row[4]], is_number = row[4] == CONSTANT, is_short = row.value ~= nil,
            is_special = row.handle or row.address, handle = row.handle, address = row.address,
        }
        for first = row[1], row[2] do
            ENCODINGS[first] = encoding
            if encoding.scope then IS_VARIABLE[first] = true end
            if encoding.is_short then SHORT_VALUES[first] = row.value + first - row[1] end
            -- Bytes of the whole argument; 0 for a string, which ends at its zero.
            SIZES[first] = row[4] == CONSTANT_TEXT and 0 or 1 + row[5]
        end
    end

    function unsigned16(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return low + high * 0x100
    end

    local function unsigned32(text, at)
        local first, second, third, fourth = byte(text, at + 1, at + 4)
        return first + second * 0x100 + third * 0x10000 + fourth * 0x1000000
    end

    local function signed8(text, at)
        local value = byte(text, at + 1)
        return value < 0x80 and value or value - 0x100
    end

    local function signed16(text, at)
        local value = unsigned16(text, at)
        return value < 0x8000 and value or value - 0x10000
    end

    local function signed32(text, at)
        local value = unsigned32(text, at)
        return value < 0x80000000 and value or value - 0x100000000
    end

    -- An IEEE single.
    local unpack = Struct.unpack
    local function single(text, at)
        local value = unpack("<f", text, at + 1)
        -- All that are not a number are alike.
        return value == value and value or 0 / 0
    end

    local READ_UNSIGNED = { [1] = function(text, at) return byte(text, at + 1) end, [2] = unsigned16, [4] = unsigned32 }
    local READ_SIGNED = { [1] = signed8, [2] = signed16, [4] = signed32 }
    READ_TYPE = { [DATA8] = signed8, [DATA16] = signed16, [DATA32] = signed32, [DATAF] = single, [HANDLE] = signed16 }

    -- A zero would end the text there; it is shown as its symbol.
    local utf8_of = made_late(function(character)
        local code = byte(character)
        if code == 0 then return "\226\144\128" end
        return string.char(0xC0 + floor(code / 0x40), 0x80 + code % 0x40)
    end)

    -- The brick's strings are ISO-8859-1, Wireshark's are UTF-8.
    function utf8_text(text)
        if not find(text, "[\0\128-\255]") then return text end
        return (gsub(text, "[\0\128-\255]", utf8_of))
    end

    -- The offset after the argument at an offset; else nil, the offset of the fault and the reason.
    local function measure(text, at, stop, name)
        if at >= stop then
            return nil, stop, "the frame ends where the argument " .. name .. " should start", "cut_off"
        end
        local size = SIZES[byte(text, at + 1)]
        if not size then
            local reason = "0x%02X is no identification byte that the firmware defines (argument %s)"
            return nil, at, format(reason, byte(text, at + 1), name), "fault"
        end
        if size == 0 then
            local zero = find(text, "\0", at + 2, true)
            if not zero or zero > stop then
                local reason = "the string %s runs past the end of the frame: the zero that ends it is missing"
                return nil, at, format(reason, name), "cut_off"
            end
            return zero
        end
        if at + size > stop then
            return nil, at, "the argument " .. name .. " runs past the end of the frame", "cut_off"
        end
        return at + size
    end

    -- What stands in the argument from one offset to another: a number, a text, or the index of a variable.
    local function value_of(text, at, stop, encoding, is_float)
        if encoding.is_short then return SHORT_VALUES[byte(text, at + 1)] end
        local kind, width = encoding.kind, encoding.width
        if kind == CONSTANT_TEXT then return sub(text, at + 2, stop - 1) end
        if encoding.scope then return READ_UNSIGNED[width](text, at + 1) end
        if is_float and width == 4 then return single(text, at + 1) end
        return READ_SIGNED[width](text, at + 1)
    end

    -- The operation that an opcode and its CMD select, and the offset after the two; else nil, offset and reason.
    function select_operation(text, at, stop)
        local code, second = byte(text, at + 1, at + 2)
        local entry = instructions[code]
        if not entry then
            local reason = format("0x%02X is no opcode of the %s firmware", code, dialect)
            return nil, at, reason, "unknown_opcode"
        end
        local commands = entry.commands
        if not commands then return entry, at + 1 end
        -- Nearly every CMD is one byte that is its number.
        local encoding = ENCODINGS[second]
        local operation = encoding and encoding.kind == CONSTANT and commands[SHORT_VALUES[second]]
        if operation then return operation, at + 2 end
        local after, offset, reason, kind = measure(text, at + 1, stop, "CMD")
        if not after then return nil, offset, reason, kind end
        if encoding.kind ~= CONSTANT then
            reason = format("CMD of %s is %s: it must be a constant to say what follows", entry.name, encoding.name)
            return nil, at + 1, reason, "unknown_cmd"
        end
        local value = value_of(text, at + 1, after, encoding)
        operation = commands[value]
        if not operation then
            return nil, at + 1, format("%s has no CMD %d", entry.name, value), "unknown_cmd"
        end
        return operation, after
    end

    -- How many elements a list has; else nil, offset and reason.
    local function count_elements(text, list, counter, at, after, stop)
        local encoding = ENCODINGS[byte(text, at + 1)]
        local value = value_of(text, at, after, encoding)
        if encoding.kind ~= CONSTANT then
            local reason = "%s must be a constant: without it nobody knows how many values follow"
            return nil, at, format(reason, counter.name), "fault"
        end
        local room = stop - after
        if list.type == COUNT and room > MOST_COUNTED then room = MOST_COUNTED end
        if value < 0 or value > room then
            local reason = "%s cannot be %d: there is room for 0 to %d values"
            return nil, at, format(reason, counter.name, value, room), "fault"
        end
        return value
    end

    -- The arguments of an operation, from the offset after its opcode and CMD: the offset after them. Each is handed to
    -- `visit`, if that is given, with its parameter, encoding, value, the parameter's field, and the offsets of its
    -- first byte and after its last; with `is_brief` only variables, and numbers that say how long something is. At a
    -- fault the offset is the one after what could be read, and the fault's offset, reason and kind follow.
    function read_arguments(operation, text, at, stop, visit, context, is_brief)
        local list, start, element_type = operation.list, at, nil
        local after, offset, reason, kind
        for index = 1, #operation, 2 do
            local parameter = operation[index]
            local first, low, high = byte(text, at + 1, at + 3)
            local size = SIZES[first]
            -- Most arguments are numbers and whole; the others go the long way.
            if size and size > 0 and at + size <= stop then
                after = at + size
            else
                after, offset, reason, kind = measure(text, at, stop, parameter.name)
                if not after then return at, offset, reason, kind end
            end
            if visit then
                local encoding = ENCODINGS[first]
                if not is_brief or encoding.scope or parameter.tells_length or parameter.tells_type then
                    local value = SHORT_VALUES[first]
                    if not value then
                        if size == 2 then
                            value = (low < 0x80 or encoding.scope) and low or low - 0x100
                        elseif size == 3 then
                            value = low + high * 0x100
                            if high >= 0x80 and not encoding.scope then value = value - 0x10000 end
                        else
                            value = value_of(text, at, after, encoding, parameter.is_float)
                        end
                    end
                    visit(context, parameter, encoding, value, operation[index + 1], at, after)
                    if list and parameter.tells_type and encoding.kind == CONSTANT then
                        element_type = FORMAT_TYPES[value]
                    end
                end
            end
            start, at = at, after
        end
        if list then
            local count
            count, offset, reason, kind = count_elements(text, list, operation[#operation - 1], start, at, stop)
            if not count then return at, offset, reason, kind end
            local elements = list.elements_of[element_type or list.element_type]
            for index = 0, count - 1 do
                local element = elements[index]
                after, offset, reason, kind = measure(text, at, stop, element.name)
                if not after then return at, offset, reason, kind end
                if visit then
                    local encoding = ENCODINGS[byte(text, at + 1)]
                    if not is_brief or encoding.scope then
                        local value = value_of(text, at, after, encoding, element.is_float)
                        visit(context, element, encoding, value, element.field, at, after)
                    end
                end
                at = after
            end
        end
        return at
    end

    -- The same of an operation that is simple: no argument tells anything of another. Most are read here: each needs
    -- just the size that its first byte tells. With `is_brief` only variables are handed over.
    function skim_arguments(operation, text, at, stop, visit, context, is_brief)
        for index = 1, #operation, 2 do
            local first, low, high = byte(text, at + 1, at + 3)
            local size, after = SIZES[first], nil
            if size and size > 0 and at + size <= stop then
                after = at + size
            else
                local offset, reason, kind
                after, offset, reason, kind = measure(text, at, stop, operation[index].name)
                if not after then return at, offset, reason, kind end
            end
            local is_variable = IS_VARIABLE[first]
            if is_variable or not is_brief then
                local parameter, encoding = operation[index], ENCODINGS[first]
                local value = SHORT_VALUES[first]
                if not value then
                    if size == 2 then
                        value = (low < 0x80 or is_variable) and low or low - 0x100
                    elseif size == 3 then
                        value = low + high * 0x100
                        if high >= 0x80 and not is_variable then value = value - 0x10000 end
                    else
                        value = value_of(text, at, after, encoding, parameter.is_float)
                    end
                end
                visit(context, parameter, encoding, value, operation[index + 1], at, after)
            end
            at = after
        end
        return at
    end

    -- One operation, and its arguments as above: what it is, and the offset after it.
    function read_operation(text, at, stop, visit, context, is_brief)
        local operation, after, reason, kind = select_operation(text, at, stop)
        if not operation then return nil, at, after, reason, kind end
        return operation, read_arguments(operation, text, after, stop, visit, context, is_brief)
    end

    -- One field of a system message: its value and the offset after it; else nil, offset and reason.
    local function read_field(text, at, stop, declared, before)
        local kind = declared.kind
        local size = kind == U8 and 1 or kind == U16 and 2 or kind == U32 and 4
        if size then
            if at + size > stop then
                return nil, at, "the frame ends where the field " .. declared.name .. " should stand"
            end
            return READ_UNSIGNED[size](text, at), at + size
        elseif kind == TEXT then
            local zero = find(text, "\0", at + 1, true)
            if not zero or zero > stop then
                local reason = "the text %s runs past the end of the frame: the zero that ends it is missing"
                return nil, at, format(reason, declared.name)
            end
            return sub(text, at + 1, zero - 1), zero
        elseif kind == COUNTED_TEXT then
            local length = before[declared.name]
            if at + length > stop then
                return nil, at, format("a text of %d bytes runs past the end of the frame", length)
            end
            -- Some senders count the zero, some do not; it is always there.
            if length > 0 and byte(text, at + length) == 0 then
                return sub(text, at + 1, at + length - 1), at + length
            elseif at + length >= stop then
                return nil, at, "the zero that ends a text is missing"
            elseif byte(text, at + length + 1) ~= 0 then
                return nil, at + length, format("a text of %d bytes must end in a zero", length)
            end
            return sub(text, at + 1, at + length), at + length + 1
        end
        if before[declared.name] and before[declared.name] ~= stop - at then
            local reason = "%d bytes should follow to the end of the frame, here are %d"
            return nil, at, format(reason, before[declared.name], stop - at)
        end
        return sub(text, at + 1, stop), stop
    end

    -- The fields of a system message: { declared, value, at, stop }, the offset after them, and the fault if there is
    -- one. Replies to failed commands may end before any field: they are not `complete`.
    function read_fields(text, at, stop, declarations, complete)
        local found, counted = {}, {}
        for _, declared in ipairs(declarations) do
            if at == stop and (declared.optional or not complete) then break end
            local value, after, reason = read_field(text, at, stop, declared, counted)
            if not value then return found, at, { at = after, reason = reason, kind = "fault" } end
            found[#found + 1] = { declared = declared, value = value, at = at, stop = after }
            found[declared.name] = value
            if declared.counts then counted[declared.counts] = value end
            at = after
        end
        if at < stop then
            local reason = format("%d byte%s left over after the last field", stop - at, stop - at > 1 and "s" or "")
            return found, at, { at = at, reason = reason, kind = "fault" }
        end
        return found, at
    end
end

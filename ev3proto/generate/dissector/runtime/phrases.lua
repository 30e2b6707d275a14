-- Phrases -----------------------------------------------------------------------------------------------------------
--
-- What the info column and the headings of the tree say.

local MOST_VALUES, plural, on_one_line, shortened, number_text, meaning_of, variable_text, add_phrase, output_text,
    values_text, transfer_text
do
    -- Wireshark cuts the info column anyway; a list of a hundred values says no more than its start.
    MOST_VALUES = 12
    local MOST_TEXT = 60

    function plural(count, word)
        return count .. " " .. word .. (count == 1 and "" or "s")
    end

    -- The symbol of a control character: a line end would cut the line.
    local function symbol_of(control)
        local code = byte(control)
        return "\226\144" .. string.char(code == 0x7F and 0xA1 or 0x80 + code)
    end

    function on_one_line(text)
        return (gsub(utf8_text(text), "[\1-\31\127]", symbol_of))
    end

    function shortened(text)
        if #text > MOST_TEXT then text = sub(text, 1, MOST_TEXT) .. "..." end
        return '"' .. on_one_line(text) .. '"'
    end

    function number_text(value)
        -- Not a number is the one value that is not equal to itself.
        if value ~= value then return "NaN" end
        if value % 1 == 0 and value > -1e15 and value < 1e15 then return format("%d", value) end
        return format("%.7g", value)
    end

    -- What there is to say of a value beside the name that Wireshark itself shows: its special meaning, or the names of
    -- the flags that it is made of.
    function meaning_of(parameter, value)
        if not parameter.is_flags then return parameter.special[value] end
        local names, flags = {}, parameter.enum.names
        if value < 0 or value > 0xFF then return nil end
        for bit = 0, 7 do
            local flag = 2 ^ bit
            if value % (2 * flag) >= flag then names[#names + 1] = flags[flag] or format("0x%02X", flag) end
        end
        return names[1] and concat(names, "|")
    end

    function variable_text(encoding, index)
        return encoding.text or encoding.scope .. index .. ")"
    end

    -- What stands for an argument in a line; for most numbers the number itself.
    local function argument_text(parameter, encoding, value)
        if encoding.scope then return variable_text(encoding, value) end
        local enum = parameter.enum
        local name = enum and not enum.is_flags and enum.names[value]
        if name or encoding.text then return name or encoding.text end
        if encoding.kind == CONSTANT_TEXT then return shortened(value) end
        return parameter.is_float and number_text(value) or value
    end

    -- A line on an operation is collected piece by piece, `count` of them: SOUND TONE volume=1 frequency=440
    function add_phrase(pieces, parameter, encoding, value)
        if parameter.direction == OUT then return end
        local count = pieces.count
        if count <= 2 * MOST_VALUES then
            pieces[count + 1] = parameter.key
            pieces[count + 2] = argument_text(parameter, encoding, value)
            pieces.count = count + 2
        elseif count == 2 * MOST_VALUES + 1 then
            pieces[count + 1] = " ..."
            pieces.count = count + 1
        end
    end

    local function unit_text(parameter)
        return parameter.unit and " " .. parameter.unit or ""
    end

    local function one_value_text(output, value)
        local parameter = output.parameter
        if type(value) == "string" then return shortened(value) end
        if output.is_handle then return number_text(value) end
        local enum = parameter.enum
        return enum and not enum.is_flags and enum.names[value] or number_text(value) .. unit_text(parameter)
    end

    function output_text(output)
        if not output.is_list then return one_value_text(output, output.value) end
        local pieces = {}
        for index = 1, math.min(#output.list, MOST_VALUES) do
            pieces[index] = one_value_text(output, output.list[index])
        end
        if #output.list > MOST_VALUES then pieces[#pieces + 1] = "..." end
        return "[" .. concat(pieces, ", ") .. "]"
    end

    -- The name of an output: what LEGO calls it where the parameter is only a VALUE.
    local function output_name(operation, output)
        local name = output.parameter.name
        return name == "VALUE" and operation.value_name or name
    end

    -- 7.92 V; of several values VBATT=7.92 V IBATT=0.21 A
    function values_text(layout, count)
        local pieces, pieces_count = {}, 0
        for number = 1, #layout do
            local operation, values = layout[number].operation, layout[number].values
            for index = 1, #values do
                local output = values[index]
                if count == 1 then return output_text(output) end
                if pieces_count == MOST_VALUES then
                    pieces[pieces_count + 1] = "..."
                    return concat(pieces, " ")
                end
                pieces_count = pieces_count + 1
                pieces[pieces_count] = output_name(operation, output) .. "=" .. output_text(output)
            end
        end
        return concat(pieces, " ")
    end

    function transfer_text(transfer)
        local text = shortened(transfer.path)
        if transfer.size then
            text = format("%s %d of %s", text, transfer.done, plural(transfer.size, "byte"))
        end
        return text
    end
end

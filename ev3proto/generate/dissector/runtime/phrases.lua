-- Phrases -----------------------------------------------------------------------------------------------------------
--
-- What the info column and the headings of the tree say.

local MOST_VALUES, plural, on_one_line, shortened, number_text, meaning_of, argument_text, output_text,
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

    -- For those that have none, U+0080 to U+009F: some terminals obey them.
    local REPLACEMENT = "\239\191\189"

    function on_one_line(text)
        if not find(text, "[\0-\31\127-\255]") then return text end
        text = gsub(utf8_text(text), "[\1-\31\127]", symbol_of)
        return (gsub(text, "\194[\128-\159]", REPLACEMENT))
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
        return names[1] and "(" .. concat(names, "|") .. ")"
    end

    -- What stands for an argument in a line; for most numbers the number itself.
    function argument_text(parameter, encoding, value)
        if encoding.scope then return encoding.texts[value] end
        local enum = parameter.enum
        local name = enum and not enum.is_flags and enum.names[value]
        if name or encoding.text then return name or encoding.text end
        if encoding.kind == CONSTANT_TEXT then return shortened(value) end
        return parameter.is_float and number_text(value) or encoding.texts[value]
    end

    local function one_value_text(output, value)
        local parameter = output.parameter
        if type(value) == "string" then return shortened(value) end
        if output.is_handle then return number_text(value) end
        local enum = parameter.enum
        return enum and not enum.is_flags and enum.names[value] or number_text(value) .. (parameter.unit_text or "")
    end

    function output_text(output)
        local list = output.list
        if not list then return one_value_text(output, output.value) end
        local pieces = {}
        for index = 1, math.min(#list, MOST_VALUES) do
            pieces[index] = one_value_text(output, list[index])
        end
        if #list > MOST_VALUES then pieces[#pieces + 1] = "..." end
        return "[" .. concat(pieces, ", ") .. "]"
    end

    -- How `format` writes the value of an output, what it is given for it, and the unit after it. One call of `format`
    -- for a line is much faster than a text for each number.
    local function value_format(output)
        local parameter, value = output.parameter, output.value
        if output.list or type(value) == "string" then return "%s", output_text(output), "" end
        if output.is_handle then return "%d", value, "" end
        local enum = parameter.enum
        local name = enum and not enum.is_flags and enum.names[value]
        if name then return "%s", name, "" end
        if value % 1 == 0 and value > -1e15 and value < 1e15 then return "%d", value, parameter.unit_format or "" end
        return "%s", number_text(value), parameter.unit_format or ""
    end

    local pieces, values = {}, {}

    -- After a head: 7.92 V; of several values VBATT=7.92 V IBATT=0.21 A
    function values_text(head, outputs, count)
        pieces[1] = head
        local stop, shown = 1, math.min(count, MOST_VALUES)
        for index = 1, shown do
            local output = outputs[index]
            pieces[stop + 1] = count == 1 and " " or output.parameter.value_key
            pieces[stop + 2], values[index], pieces[stop + 3] = value_format(output)
            stop = stop + 3
        end
        if count > shown then
            stop = stop + 1
            pieces[stop] = " ..."
        end
        return format(concat(pieces, "", 1, stop), table.unpack(values, 1, shown))
    end

    function transfer_text(transfer)
        local text = shortened(transfer.path)
        if transfer.size then
            text = format("%s %d of %s", text, transfer.done, plural(transfer.size, "byte"))
        end
        return text
    end
end

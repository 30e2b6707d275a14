-- Phrases -----------------------------------------------------------------------------------------------------------
--
-- What the info column and the headings of the tree say.

local MOST_VALUES, plural, on_one_line, shortened, number_text, meaning_of, argument_text, output_text,
    values_text, transfer_text
do
    -- Wireshark cuts the info column anyway; a list of a hundred values says no more than its start.
    MOST_VALUES = 12
    local MOST_TEXT = 60

    -- Counts up to the size of a frame, and numbers of one byte, are written but once: that takes longer than reading
    -- them.
    local MOST_WRITTEN = 0x3FF
    local counted, written = {}, {}

    function plural(count, word)
        local texts = counted[word]
        if not texts then
            texts = {}
            counted[word] = texts
        end
        local text = texts[count]
        if not text then
            text = format("%d %s%s", count, word, count == 1 and "" or "s")
            if count <= MOST_WRITTEN then texts[count] = text end
        end
        return text
    end

    -- What stands in a line for a byte of a text: for a control character its symbol, as a line end would cut the line;
    -- for those that have none, U+0080 to U+009F, a mark, as some terminals obey them; for others their UTF-8.
    local REPLACEMENT = "\239\191\189"
    local in_line = made_late(function(character)
        local code = byte(character)
        if code < 0x20 or code == 0x7F then
            return "\226\144" .. string.char(code == 0x7F and 0xA1 or 0x80 + code)
        elseif code < 0xA0 then
            return REPLACEMENT
        end
        return utf8_text(character)
    end)

    function on_one_line(text)
        if not find(text, "[\0-\31\127-\255]") then return text end
        return (gsub(text, "[\0-\31\127-\255]", in_line))
    end

    function shortened(text)
        if #text > MOST_TEXT then text = sub(text, 1, MOST_TEXT) .. "..." end
        return '"' .. on_one_line(text) .. '"'
    end

    function number_text(value)
        local text = written[value]
        if text then return text end
        -- Not a number is the one value that is not equal to itself.
        if value ~= value then return "NaN" end
        if value % 1 ~= 0 or value <= -1e15 or value >= 1e15 then return format("%.7g", value) end
        text = format("%d", value)
        if value >= -0x80 and value <= 0xFF then written[value] = text end
        return text
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
        if name then return name end
        if encoding.is_short then return encoding.texts[value] end
        if encoding.kind == CONSTANT_TEXT then return shortened(value) end
        return parameter.is_float and number_text(value) or encoding.texts[value]
    end

    local function one_value_text(output, value)
        local parameter = output.parameter
        if type(value) == "string" then return shortened(value) end
        if output.is_handle then return number_text(value) end
        local enum, unit = parameter.enum, parameter.unit
        local name = enum and not enum.is_flags and enum.names[value]
        if name then return name end
        return unit and number_text(value) .. " " .. unit or number_text(value)
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

    local pieces = {}

    -- After a head: 7.92 V; of several values VBATT=7.92 V IBATT=0.21 A
    function values_text(head, outputs, count)
        if count == 1 then return head .. " " .. output_text(outputs[1]) end
        pieces[1] = head
        local stop, shown = 1, math.min(count, MOST_VALUES)
        for index = 1, shown do
            local output = outputs[index]
            pieces[stop + 1], pieces[stop + 2] = output.parameter.value_key, output_text(output)
            stop = stop + 2
        end
        if count > shown then
            stop = stop + 1
            pieces[stop] = " ..."
        end
        return concat(pieces, "", 1, stop)
    end

    function transfer_text(transfer)
        local text = shortened(transfer.path)
        if transfer.size then
            text = format("%s %d of %s", text, transfer.done, plural(transfer.size, "byte"))
        end
        return text
    end
end

-- The instruction set, made ready -----------------------------------------------------------------------------------
--
-- The tables above are written to be read. Here each parameter becomes what the reading of an argument needs.

local INSTRUCTION_SETS, SYSTEM_COMMANDS
do
    local PARAMETER_KINDS = { [DATAF] = FLOAT, [STRING] = TEXT_VALUE }

    -- A typed field of one parameter. Its kind tells which values it takes.
    local function parameter_field(abbreviation, parameter, kind, name, text)
        local made
        if kind == TEXT_VALUE then
            made = ProtoField.string(abbreviation, name, text)
        elseif kind == FLOAT then
            made = ProtoField.float(abbreviation, name, text)
        elseif parameter.enum and not parameter.enum.is_flags then
            made = ProtoField.int32(abbreviation, name, base.DEC, parameter.enum.names, nil, text)
        elseif parameter.unit then
            made = ProtoField.int32(abbreviation, name, base.UNIT_STRING, { " " .. parameter.unit }, nil, text)
        else
            made = ProtoField.int32(abbreviation, name, base.DEC, nil, nil, text)
        end
        fields[#fields + 1] = made
        return made
    end

    -- The field of a system message; several messages share one.
    local system_field
    do
        local MAKE_SYSTEM_FIELD = {
            [U8] = ProtoField.uint8, [U16] = ProtoField.uint16, [U32] = ProtoField.uint32,
            [TEXT] = ProtoField.string, [COUNTED_TEXT] = ProtoField.string, [LISTING] = ProtoField.string,
            [BYTES] = ProtoField.bytes,
        }

        local made_fields = {}

        function system_field(declared)
            local abbreviation = "ev3." .. declared.filter
            local made = made_fields[abbreviation]
            if not made then
                local hex = declared.hexadecimal and base.HEX or nil
                made = MAKE_SYSTEM_FIELD[declared.kind](abbreviation, declared.label, hex)
                made_fields[abbreviation] = made
                fields[#fields + 1] = made
            end
            return made
        end
    end

    -- What special values of a parameter mean, as it is shown after the value.
    local function in_brackets(special)
        local shown = {}
        for value, meaning in pairs(special) do
            shown[value] = "(" .. meaning .. ")"
        end
        return shown
    end

    -- All of a parameter but its field, from its row in the tables; `value_name` is what a reply's line calls it. In
    -- Lua a table doubles beyond 16 entries: what is not so of a parameter, or not asked of it, has no entry.
    local function ready_parameter(row, kind, label, value_name, tells_length, tells_type)
        local name, direction, type = row[1], row[2], row[3]
        local is_flags = row.enum and row.enum.is_flags
        local parameter = {
            name = name, type = type, kind = kind, label_head = label .. ":",
            -- Whether its field says all that there is to say of a number.
            is_plain = kind ~= TEXT_VALUE and not (row.special or is_flags) and not (row.unit and kind == FLOAT),
            size = SIZE_OF[type] or 1,
        }
        -- The index of a variable must be a multiple of its type's size, else the brick refuses the command.
        if row.validated then parameter.alignment = SIZE_OF[row.validated] or 1 end
        if type == DATAF then parameter.is_float = true end
        if direction ~= OUT then parameter.key = " " .. name:lower() .. "=" end
        if row.unit then parameter.unit = row.unit end
        if direction ~= IN then
            parameter.is_output, parameter.value_key = true, " " .. value_name .. "="
            if row.length then parameter.is_long = true end
        end
        if row.enum then parameter.enum = row.enum end
        if is_flags then parameter.is_flags = true end
        if row.special and not is_flags then parameter.special = in_brackets(row.special) end
        if row.length then parameter.length = row.length end
        if tells_length then parameter.tells_length = true end
        if tells_type then parameter.tells_type = true end
        return parameter
    end

    -- There are more than a thousand parameters, and the collector goes through all that Lua holds again and again.
    -- Those that are alike in all but their fields are one table, of which there are a third as many.
    local shared_parameter
    do
        local made = {}

        local function text_of(special)
            local pieces = {}
            for value, meaning in pairs(special or {}) do
                pieces[#pieces + 1] = value .. meaning
            end
            table.sort(pieces)
            return concat(pieces, ",")
        end

        function shared_parameter(row, kind, label, value_name, tells_length, tells_type)
            local key = format("%s|%s|%s|%s|%s|%s|%s|%s|%s|%s|%s|%s", label, row[1], row[2], row[3], value_name,
                tostring(row.unit), tostring(row.enum), text_of(row.special), tostring(row.length),
                tostring(row.validated), tostring(tells_length), tostring(tells_type))
            made[key] = made[key] or ready_parameter(row, kind, label, value_name, tells_length, tells_type)
            return made[key]
        end
    end

    -- The elements of a list by number, for one type of them: all the same but for the number in the name.
    local function numbered(element)
        return setmetatable({}, { __index = function(elements, number)
            local one = setmetatable({}, { __index = element })
            one.name = element.name .. "[" .. number .. "]"
            one.numbered = one.name
            one.value_key = " " .. one.name .. "="
            one.label_head = one.name .. ":"
            elements[number] = one
            return one
        end })
    end

    -- An element of a list, by its type. What a count announces has a field of its own beside the count's.
    local function ready_element(list, abbreviation, type, row, is_any)
        local direction = list.type == COUNT and row.elements or IN
        local name, text = list.name, row[4]
        local element = {
            name = name, type = type, size = SIZE_OF[type] or 1, alignment = 1,
            is_float = type == DATAF, is_output = direction ~= IN,
            key = direction ~= OUT and " " .. name:lower() .. "=" or nil,
        }
        if list.type == VALUES then
            element.field, element.kind = list.field, list.kind
        elseif is_any then
            -- Another argument tells the type: a double holds whatever number it is.
            list.any_field = list.any_field or ProtoField.double(abbreviation .. ".item", name, text)
            element.field, element.kind = list.any_field, FLOAT
        else
            element.kind = PARAMETER_KINDS[type] or NUMBER
            element.field = parameter_field(abbreviation .. ".item", {}, element.kind, name, text)
        end
        return numbered(element)
    end

    -- The list at the end of an operation, whose field is that of its elements or of their count.
    local function ready_list(abbreviation, list, row, declared)
        list.field, list.elements_of = declared, {}
        if TYPE_NAMES[row.element] then
            list.elements_of[row.element] = ready_element(list, abbreviation, row.element, row)
            list.element_type = row.element
        else
            for _, type in pairs(FORMAT_TYPES) do
                list.elements_of[type] = ready_element(list, abbreviation, type, row, true)
            end
            list.element_type = ARRAY_TYPED
            list.elements_of[ARRAY_TYPED] = ready_element(list, abbreviation, ARRAY_TYPED, row, true)
        end
        if list.any_field then
            fields[#fields + 1] = list.any_field
        end
    end

    -- The parameters of an operation that tell of others: how long they are, or of which type.
    local function telling_of(row)
        local lengths, types = {}, {}
        for index = 4, #row do
            local length, element = row[index].length, row[index].element
            if length then lengths[length] = true end
            if element then types[element] = true end
        end
        return lengths, types
    end

    -- The parameters of an operation, each followed by its field, all but a list of values; the list at its end, if it
    -- has one; whether no argument tells anything of another.
    local function ready_parameters(name, cmd_name, row)
        local lengths, types = telling_of(row)
        local fixed, list, is_simple = {}, nil, true
        for index = 4, #row do
            local each = row[index]
            local own, type = each[1], each[3]
            local abbreviation = ("ev3." .. name .. "." .. own):lower()
            local label = each.label and each.label .. " " .. own or own
            local kind = PARAMETER_KINDS[type == VALUES and each.element or type] or NUMBER
            local declared = parameter_field(abbreviation, each, kind, label, each[4])
            -- LEGO names what a command reads after the command: VALUE of GET_VBATT is VBATT.
            local value_name = own == "VALUE" and cmd_name and cmd_name:match("^GET_(.+)$") or own
            local is_list = type == COUNT or type == VALUES
            local make = is_list and ready_parameter or shared_parameter
            local parameter = make(each, kind, label, value_name, lengths[own], types[own])
            if is_list then
                list = parameter
                ready_list(abbreviation, list, each, declared)
            end
            if is_list or lengths[own] or types[own] then is_simple = false end
            if type ~= VALUES then
                fixed[#fixed + 1] = parameter
                fixed[#fixed + 1] = declared
            end
        end
        return fixed, list, is_simple
    end

    -- An operation: its names, and its parameters in turn with their fields. One that stands alone has no `cmd_name`.
    local function ready_operation(opcode_name, cmd_name, row)
        local name = cmd_name and opcode_name .. "." .. cmd_name or opcode_name
        local operation, list, is_simple = ready_parameters(name, cmd_name, row)
        operation.name, operation.title = name, gsub(name, "%.", " ")
        if cmd_name then operation.cmd_name = cmd_name end
        if list then operation.list = list end
        if is_simple then operation.is_simple = true end
        return operation
    end

    local function has_dialect(row, dialect)
        if not row.dialects then return true end
        for _, name in ipairs(row.dialects) do
            if name == dialect then return true end
        end
        return false
    end

    -- Opcode number to operation, or to a table of operations by CMD; one such set for each dialect.
    INSTRUCTION_SETS = {}
    for _, dialect in ipairs(DIALECTS) do
        INSTRUCTION_SETS[dialect] = {}
    end

    for _, row in ipairs(OPERATIONS) do
        local number, name = row[1], row[2]
        local plain = not row.commands and ready_operation(name, nil, row)
        local commands = {}
        for _, command in ipairs(row.commands or {}) do
            commands[#commands + 1] = { row = command, operation = ready_operation(name, command[2], command) }
        end
        for _, dialect in ipairs(DIALECTS) do
            if has_dialect(row, dialect) then
                local entry = plain or { name = name, commands = {} }
                for _, command in ipairs(commands) do
                    if has_dialect(command.row, dialect) then
                        entry.commands[command.row[1]] = command.operation
                    end
                end
                INSTRUCTION_SETS[dialect][number] = entry
            end
        end
    end

    -- System commands by number, with the fields of their messages.
    SYSTEM_COMMANDS = {}
    for _, row in ipairs(SYSTEM) do
        local command = {
            name = row[2], text = row[3], request = row.request or {}, reply = row.reply or {},
            transfer = row.transfer, is_bootloader = row.bootloader,
        }
        for _, side in ipairs({ command.request, command.reply }) do
            for _, declared in ipairs(side) do
                declared.name, declared.kind = declared[1], declared[2]
                declared.filter, declared.label = declared[3], declared[4]
                declared.field = system_field(declared)
            end
        end
        SYSTEM_COMMANDS[row[1]] = command
    end
end

local dialect = DIALECTS[1]
local instructions = INSTRUCTION_SETS[dialect]

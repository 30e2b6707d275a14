-- The instruction set, made ready -----------------------------------------------------------------------------------
--
-- The tables above are written to be read. Here each parameter becomes what the reading of an argument needs.

local INSTRUCTION_SETS, SYSTEM_COMMANDS
do
    local PARAMETER_KINDS = { [DATAF] = FLOAT, [STRING] = TEXT_VALUE }

    -- A typed field of one parameter. Its kind tells which values it takes.
    local function parameter_field(abbreviation, parameter, kind)
        local name, text = parameter.label, parameter.text
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

    local function ready_parameter(abbreviation, row)
        local parameter = {
            name = row[1], field_name = row[1], direction = row[2], type = row[3], text = row[4],
            label = row.label and row.label .. " " .. row[1] or row[1],
            unit = row.unit, enum = row.enum, special = row.special, length = row.length,
            element = row.element, elements = row.elements,
        }
        parameter.is_float = row[3] == DATAF
        parameter.is_output = row[2] ~= IN
        parameter.size = SIZE_OF[row[3]]
        -- The index of a variable must be a multiple of its type's size, else the brick refuses the command.
        parameter.alignment = SIZE_OF[row.validated or row[3]]
        parameter.is_flags = row.enum and row.enum.is_flags
        parameter.key = " " .. row[1]:lower() .. "="
        parameter.value_key = " " .. row[1] .. "="
        parameter.unit_text = row.unit and " " .. row.unit or ""
        parameter.unit_format = gsub(parameter.unit_text, "%%", "%%%%")
        if row[3] == VALUES then
            parameter.kind = PARAMETER_KINDS[row.element] or NUMBER
        else
            parameter.kind = PARAMETER_KINDS[row[3]] or NUMBER
        end
        -- Whether its field says all that there is to say of a number.
        parameter.is_plain = parameter.kind ~= TEXT_VALUE and not (row.special or parameter.is_flags)
            and not (row.unit and parameter.kind == FLOAT)
        parameter.field = parameter_field(abbreviation, parameter, parameter.kind)
        return parameter
    end

    -- The elements of a list by number, for one type of them: all the same but for the number in the name.
    local function numbered(element)
        return setmetatable({}, { __index = function(elements, number)
            local one = setmetatable({}, { __index = element })
            one.name = element.name .. "[" .. number .. "]"
            one.value_key = " " .. one.name .. "="
            elements[number] = one
            return one
        end })
    end

    -- An element of a list, by its type. What a count announces has a field of its own beside the count's.
    local function ready_element(list, abbreviation, type, direction, is_any)
        local element = {
            name = list.name, field_name = list.name, direction = direction, type = type, text = list.text,
            is_float = type == DATAF, is_output = direction ~= IN, size = SIZE_OF[type], key = list.key,
            operation = list.operation, unit_text = "", unit_format = "",
        }
        if list.type == VALUES then
            element.field, element.kind = list.field, list.kind
        elseif is_any then
            -- Another argument tells the type: a double holds whatever number it is.
            list.any_field = list.any_field or ProtoField.double(abbreviation .. ".item", list.name, list.text)
            element.field, element.kind = list.any_field, FLOAT
        else
            element.kind = PARAMETER_KINDS[type] or NUMBER
            local named = { label = list.name, text = list.text }
            element.field = parameter_field(abbreviation .. ".item", named, element.kind)
        end
        return numbered(element)
    end

    local function ready_list(abbreviation, list)
        list.elements_of = {}
        local direction = list.type == COUNT and list.elements or IN
        if TYPE_NAMES[list.element] then
            list.elements_of[list.element] = ready_element(list, abbreviation, list.element, direction)
            list.element_type = list.element
        else
            list.type_named_by = list.element
            for _, type in pairs(FORMAT_TYPES) do
                list.elements_of[type] = ready_element(list, abbreviation, type, direction, true)
            end
            list.element_type = ARRAY_TYPED
            list.elements_of[ARRAY_TYPED] = ready_element(list, abbreviation, ARRAY_TYPED, direction, true)
        end
        if list.any_field then
            fields[#fields + 1] = list.any_field
        end
    end

    -- An operation: its names, its parameters, and the list at its end if it has one.
    local function ready_operation(number, opcode_name, cmd_name, row)
        local name = cmd_name and opcode_name .. "." .. cmd_name or opcode_name
        local title = cmd_name and opcode_name .. " " .. cmd_name or opcode_name
        local operation = {
            name = name,
            title = title, addition = cmd_name and " " .. cmd_name or "",
            cmd_name = cmd_name,
            fixed = {}, reply_head = "reply to " .. title .. ":",
        }
        -- LEGO names what a command reads after the command: VALUE of GET_VBATT is VBATT.
        local value_name = cmd_name and cmd_name:match("^GET_(.+)$")
        for index = 4, #row do
            local abbreviation = ("ev3." .. name .. "." .. row[index][1]):lower()
            local parameter = ready_parameter(abbreviation, row[index])
            parameter.operation = operation
            if value_name and parameter.name == "VALUE" then parameter.value_key = " " .. value_name .. "=" end
            if parameter.type == COUNT or parameter.type == VALUES then
                operation.list = parameter
                ready_list(abbreviation, parameter)
            end
            if parameter.type ~= VALUES then
                operation.fixed[#operation.fixed + 1] = parameter
            end
        end
        for _, parameter in ipairs(operation.fixed) do
            for index = 4, #row do
                parameter.tells_length = parameter.tells_length or row[index].length == parameter.name
                parameter.tells_type = parameter.tells_type or row[index].element == parameter.name
            end
        end
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
        local plain = not row.commands and ready_operation(number, name, nil, row)
        local commands = {}
        for _, command in ipairs(row.commands or {}) do
            commands[#commands + 1] = { row = command, operation = ready_operation(number, name, command[2], command) }
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

-- The instruction set, made ready -----------------------------------------------------------------------------------
--
-- The tables above are written to be read. Here each parameter becomes what the reading of an argument needs. Wireshark
-- wants all fields at the start; an operation gets its parameters when it is first seen, as a capture has few of them
-- and the collector goes through all that Lua holds again and again.

-- A table whose entries are made when they are first asked for; where there is none, it is asked for again.
local function made_late(make)
    return setmetatable({}, { __index = function(made, key)
        local entry = make(key)
        if entry then made[key] = entry end
        return entry
    end })
end

local INSTRUCTION_SETS, SYSTEM_COMMANDS, prepare_operation
do
    local PARAMETER_KINDS = { [DATAF] = FLOAT, [STRING] = TEXT_VALUE }

    -- A typed field of one parameter. Its kind tells which values it takes.
    local function parameter_field(abbreviation, parameter, kind, name, text)
        if kind == TEXT_VALUE then return ProtoField.string(abbreviation, name, text) end
        if kind == FLOAT then return ProtoField.float(abbreviation, name, text) end
        if parameter.enum and not parameter.enum.is_flags then
            return ProtoField.int32(abbreviation, name, base.DEC, parameter.enum.names, nil, text)
        elseif parameter.unit then
            return ProtoField.int32(abbreviation, name, base.UNIT_STRING, { " " .. parameter.unit }, nil, text)
        end
        return ProtoField.int32(abbreviation, name, base.DEC, nil, nil, text)
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

    -- What a parameter is called in filters and in the tree, and which values it takes.
    local function described(name, row)
        local own, type = row[1], row[3]
        local label = row.label and row.label .. " " .. own or own
        local kind = PARAMETER_KINDS[type == VALUES and row.element or type] or NUMBER
        return ("ev3." .. name .. "." .. own):lower(), label, kind
    end

    -- Says which single numbers a parameter takes besides its range: those that have names, and sums of flags.
    local function legal_singles(row)
        local special, names, flags = row.special or {}, row.enum and row.enum.names or {}, {}
        for number in pairs(row.enum and row.enum.is_flags and names or {}) do
            if number > 0 then flags[#flags + 1] = number end
        end
        table.sort(flags, function(one, other) return one > other end)
        return function(value)
            if special[value] or names[value] then return true end
            for _, flag in ipairs(flags) do
                if value >= flag then value = value - flag end
            end
            return flags[1] ~= nil and value == 0
        end
    end

    -- All of a parameter, from its row in the tables; `value_name` is what the line on a reply calls it.
    local function ready_parameter(row, declared, kind, label, value_name)
        local name, direction, type = row[1], row[2], row[3]
        local is_flags = row.enum and row.enum.is_flags
        return {
            name = name, type = type, field = declared, kind = kind, is_float = type == DATAF, label = label,
            size = SIZE_OF[type] or 1,
            -- The index of a variable must be a multiple of its type's size, else the brick refuses the command.
            alignment = SIZE_OF[row.validated or type] or 1,
            -- What precedes the value in a line, where the command or the reply has one.
            key = direction ~= OUT and " " .. name:lower() .. "=" or nil,
            value_key = direction ~= IN and " " .. value_name:lower() .. "=" or nil,
            is_output = direction ~= IN,
            unit = row.unit,
            names = row.enum and not is_flags and row.enum.names or nil,
            flags = is_flags and row.enum.names or nil,
            special = row.special and not is_flags and in_brackets(row.special) or nil,
            length = row.length,
            range = row.range or not row.enum and not row.any and TYPE_RANGES[type] or nil,
            is_legal = (row.special or row.enum) and legal_singles(row) or nil,
        }
    end

    -- The field of what a count announces. Where another argument tells the type, a double holds whatever it is.
    local function element_field(abbreviation, row)
        local name, element, text = row[1], row.element, row[4]
        if not TYPE_NAMES[element] then return ProtoField.double(abbreviation, name, text) end
        return parameter_field(abbreviation, {}, PARAMETER_KINDS[element] or NUMBER, name, text)
    end

    -- The elements of a list of one type, by number.
    local function ready_elements(list, row, declared, type)
        local kind = PARAMETER_KINDS[type] or NUMBER
        if row[3] == COUNT and not TYPE_NAMES[row.element] then kind = FLOAT end
        local direction = row[3] == COUNT and row.elements or IN
        return made_late(function(number)
            local name = format("%s[%d]", list.name, number)
            return {
                name = name, numbered = name, type = type, field = declared, kind = kind, label = name,
                is_float = type == DATAF,
                size = SIZE_OF[type] or 1, alignment = 1, is_output = direction ~= IN,
                range = not row.any and TYPE_RANGES[type] or nil,
                key = direction ~= OUT and format(" %s[%d]=", list.name:lower(), number) or nil,
                value_key = " " .. name:lower() .. "=",
            }
        end)
    end

    -- The list at the end of an operation; `declared` is the field of its elements.
    local function ready_list(parameter, row, declared)
        local list = { is_count = row[3] == COUNT, elements_of = {} }
        local types = { row.element }
        list.element_type = row.element
        if not TYPE_NAMES[row.element] then
            types = { ARRAY_TYPED }
            list.element_type = ARRAY_TYPED
            for _, type in pairs(FORMAT_TYPES) do
                types[#types + 1] = type
            end
        end
        for _, type in ipairs(types) do
            list.elements_of[type] = ready_elements(parameter, row, declared, type)
        end
        return list
    end

    -- Names, directions and types stand for themselves in the text of parameters.
    local WORDS = setmetatable({ ENUMERATIONS = ENUMERATIONS }, { __index = function(_, word) return word end })

    local function read_rows(source)
        return load("return {" .. source .. "}", "=parameters", "t", WORDS)()
    end

    -- An operation, and the fields of its parameters: of each, then, if it is a count, of what it announces.
    local function declare_operation(name, source)
        local operation = { name = name, source = source, first_field = #fields + 1 }
        for _, row in ipairs(read_rows(source)) do
            local abbreviation, label, kind = described(name, row)
            fields[#fields + 1] = parameter_field(abbreviation, row, kind, label, row[4])
            if row[3] == COUNT then
                fields[#fields + 1] = element_field(abbreviation .. ".item", row)
            end
        end
        return operation
    end

    -- Adds the parameters to an operation that is seen for the first time. A list of values is not among them, but is
    -- the operation's `list`. An operation that is not one of a family has no `cmd_name`.
    function prepare_operation(operation)
        local name, at = operation.name, operation.first_field
        local rows, by_name = read_rows(operation.source), {}
        operation.cmd_name, operation.source, operation.parameters = name:match("%.(.+)$"), nil, {}
        for _, row in ipairs(rows) do
            local own, type = row[1], row[3]
            local _, label, kind = described(name, row)
            -- LEGO names what a command reads after the command: VALUE of GET_VBATT is VBATT.
            local value_name = own == "VALUE" and name:match("%.GET_(.+)$") or own
            local parameter = ready_parameter(row, fields[at], kind, label, value_name)
            by_name[own] = parameter
            if type ~= VALUES then
                table.insert(operation.parameters, parameter)
                at = at + 1
            end
            if type == COUNT or type == VALUES then
                operation.list = ready_list(parameter, row, fields[at])
                operation.list.counter = operation.parameters[#operation.parameters]
            end
        end
        for _, row in ipairs(rows) do
            if by_name[row.length] then
                by_name[row.length].tells_length, operation.tells_lengths = true, true
            end
            if by_name[row.element] then by_name[row.element].tells_type = true end
        end
    end

    local function has_dialect(row, dialect)
        if not row.dialects then return true end
        for _, name in ipairs(row.dialects) do
            if name == dialect then return true end
        end
        return false
    end

    -- Opcode to operation, or to a family: its name, and its operations by CMD. One such set for each dialect.
    INSTRUCTION_SETS = {}
    for _, dialect in ipairs(DIALECTS) do
        INSTRUCTION_SETS[dialect] = {}
    end
    for _, row in ipairs(OPERATIONS) do
        local operation = not row.commands and declare_operation(row[2], row[4])
        local operations = {}
        for _, command in ipairs(row.commands or {}) do
            operations[command] = declare_operation(row[2] .. "." .. command[2], command[4])
        end
        for dialect, set in pairs(INSTRUCTION_SETS) do
            if has_dialect(row, dialect) then
                local family = { name = row[2], commands = {} }
                for command, declared in pairs(operations) do
                    if has_dialect(command, dialect) then family.commands[command[1]] = declared end
                end
                set[row[1]] = operation or family
            end
        end
    end

    -- System commands by number, with the fields of their messages.
    SYSTEM_COMMANDS = {}
    for _, row in ipairs(SYSTEM) do
        local command = {
            name = row[2], text = row[3], request = row.request or {}, reply = row.reply or {},
            transfer = row.transfer, is_bootloader = row.bootloader, statuses = row.statuses or {},
            is_long = row.is_long,
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

-- The instruction set, made ready -----------------------------------------------------------------------------------
--
-- The tables above are written for people. Here they become tables for reading arguments. Wireshark needs all fields at
-- startup; an operation gets its parameters when it is first seen, because a capture uses few operations, and the
-- garbage collector visits everything repeatedly.

-- Returns a table whose entries are made on first use.
local function made_late(make)
    return setmetatable({}, { __index = function(made, key)
        local entry = make(key)
        if entry then made[key] = entry end
        return entry
    end })
end

local INSTRUCTION_SETS, prepare_operation
do
    local PARAMETER_KINDS = { [DATAF] = FLOAT, [STRING] = TEXT_VALUE }

    -- Tells whether the tables allow no negative number for a parameter.
    local function is_natural(row)
        for value in pairs(row.special or {}) do
            if value < 0 then return false end
        end
        return row[2] == IN and row.range ~= nil and row.range[1] >= 0
    end

    -- Makes the field of one parameter; `kind` is the kind of its values.
    local function parameter_field(abbreviation, parameter, kind, name, text)
        if kind == TEXT_VALUE then return ProtoField.string(abbreviation, name, text) end
        if kind == FLOAT then return ProtoField.float(abbreviation, name, text) end
        local whole = is_natural(parameter) and ProtoField.uint32 or ProtoField.int32
        if parameter.enum and not parameter.enum.is_flags then
            return whole(abbreviation, name, base.DEC, parameter.enum.names, nil, text)
        elseif parameter.unit then
            return whole(abbreviation, name, base.UNIT_STRING, { " " .. parameter.unit }, nil, text)
        end
        return whole(abbreviation, name, base.DEC, nil, nil, text)
    end

    -- Returns the names of a parameter in filters and in the tree, and the kind of its values.
    local function described(name, row)
        local own, type = row[1], row[3]
        local label = row.label and row.label .. " " .. own or own
        local kind = PARAMETER_KINDS[type == VALUES and row.element or type] or NUMBER
        return ("ev3." .. name .. "." .. own):lower(), label, kind
    end

    -- The validator takes the first character of a text, and the distance of a jump, for numbers.
    local VALIDATED_AS = { [STRING] = DATA8, [LABEL] = DATA32 }

    -- Makes a parameter from its row in the tables; `value_name` is its name in the line of a reply.
    local function ready_parameter(row, value_name)
        local name, direction, type, kind = row[1], row[2], row[3], row.kind
        local is_flags = row.enum and row.enum.is_flags
        return {
            name = name, type = type, field = row.field, kind = kind, is_float = type == DATAF, label = row.label,
            size = SIZE_OF[type] or 1, is_natural = kind == NUMBER and is_natural(row), is_output = direction ~= IN,
            -- The index of a variable must be a multiple of this, else the brick refuses the command.
            alignment = SIZE_OF[row.validated or type] or 1,
            -- What precedes the value in the line of a command and of a reply.
            key = direction ~= OUT and " " .. name:lower() .. "=" or nil,
            value_key = direction ~= IN and " " .. value_name:lower() .. "=" or nil,
            unit = row.unit, names = row.enum and not is_flags and row.enum.names or nil,
            -- The letters of motors, for lines; whether it is a bit mask of ports.
            motors = (row.is_motor or row.is_set) and row.special or nil,
            is_set = row.is_set, is_motor = row.is_motor, is_ranged = row.is_ranged,
            flags = is_flags and row.enum.names or nil, special = not is_flags and row.special or nil,
            length = row.length, most = row.most, any = row.any, is_unsigned = row.unsigned, is_label = row.is_label,
            range = direction == IN and (row.range or not row.enum and not row.any and TYPE_RANGES[type]) or nil,
            -- What is said of a number outside of what the tables document, and the kind of that finding.
            outside = row.outside,
            -- Whether it receives a reading of a device, in its unit or raw, and which of its values.
            reading = type ~= COUNT and row.reading or nil, number = 1,
            limits = SIZE_OF[type] and TYPE_RANGES[type],
        }
    end

    -- Makes the field of the values after a count. If another argument determines their type, it is a double, which
    -- holds any of them.
    local function element_field(abbreviation, row)
        local name, element, text = row[1], row.element, row[4]
        if not TYPE_NAMES[element] then return ProtoField.double(abbreviation, name, text) end
        return parameter_field(abbreviation, {}, PARAMETER_KINDS[element] or NUMBER, name, text)
    end

    -- Makes the elements of a list of one type, by number.
    local function ready_elements(list, row, declared, type)
        local kind = PARAMETER_KINDS[type] or NUMBER
        if row[3] == COUNT and not TYPE_NAMES[row.element] then kind = FLOAT end
        local direction = row[3] == COUNT and row.elements or IN
        return made_late(function(number)
            local name = format("%s[%d]", list.name, number)
            local one = { name, direction, type, any = row.any, most = row.most, reading = row.reading,
                field = declared, kind = kind }
            local element = ready_parameter(one, name)
            element.label, element.numbered, element.number, element.alignment = name, name, number + 1, 1
            return element
        end)
    end

    -- Makes the list at the end of an operation; `declared` is the field of its elements.
    local function ready_list(parameter, row, declared)
        local function make(type)
            return ready_elements(parameter, row, declared, type)
        end
        local type = TYPE_NAMES[row.element] and row.element or ARRAY_TYPED
        return { is_count = row[3] == COUNT, element_type = type, elements_of = made_late(make) }
    end

    -- Makes an operation, and the fields of its parameters: one for each, and one for the values after a count.
    local function declare_operation(name, rows)
        for _, row in ipairs(rows) do
            local abbreviation, label, kind = described(name, row)
            row.label, row.kind, row.field = label, kind, parameter_field(abbreviation, row, kind, label, row[4])
            row.item_field = row[3] == COUNT and element_field(abbreviation .. ".item", row) or row.field
            fields[#fields + 1] = row.field
            if row[3] == COUNT then fields[#fields + 1] = row.item_field end
        end
        return { name = name, rows = rows }
    end

    -- Adds the parameters to an operation on first use. Values after a count are in its `list`. Only operations of a
    -- family have a `cmd_name`.
    function prepare_operation(operation)
        local name, rows, by_name = operation.name, operation.rows, {}
        operation.cmd_name, operation.rows, operation.parameters = name:match("%.(.+)$"), nil, {}
        for _, row in ipairs(rows) do
            local own, type = row[1], row[3]
            -- The line of a reply names a VALUE after its command: VALUE of GET_VBATT is VBATT.
            local value_name = own == "VALUE" and name:match("%.GET_(.+)$") or own
            local parameter = ready_parameter(row, value_name)
            by_name[own] = parameter
            if type ~= VALUES then table.insert(operation.parameters, parameter) end
            if type == COUNT or type == VALUES then
                operation.list = ready_list(parameter, row, row.item_field)
                operation.list.counter = operation.parameters[#operation.parameters]
            end
        end
        for _, row in ipairs(rows) do
            if by_name[row.length] then by_name[row.length].is_stated, operation.has_stated = true, true end
            if row.reading then
                by_name.TYPE.is_stated, by_name.MODE.is_stated, operation.has_stated = true, true, true
            end
            if by_name[row.element] then by_name[row.element].tells_type = true end
        end
        local first = not operation.cmd_name and operation.parameters[1]
        if first then
            first.accepted = first.is_label and first.range
                or TYPE_RANGES[rows[1].validated or VALIDATED_AS[first.type] or first.type]
        end
    end

    -- By dialect and opcode: an operation, or a family, which has a name and `commands`, its operations by CMD.
    INSTRUCTION_SETS = {}
    for _, dialect in ipairs(DIALECTS) do INSTRUCTION_SETS[dialect] = {} end
    for _, row in ipairs(OPERATIONS) do
        local operation = not row.commands and declare_operation(row[2], row[4])
        local operations = {}
        for _, command in ipairs(row.commands or {}) do
            operations[command] = declare_operation(row[2] .. "." .. command[2], command[4])
        end
        for dialect, set in pairs(INSTRUCTION_SETS) do
            if not row.dialects or row.dialects[dialect] then
                local family = { name = row[2], commands = {} }
                for command, declared in pairs(operations) do
                    local dialects = command.dialects
                    if not dialects or dialects[dialect] then family.commands[command[1]] = declared end
                end
                set[row[1]] = operation or family
            end
        end
    end

    for _, command in pairs(SYSTEM_COMMANDS) do
        for _, side in ipairs({ command.request, command.reply }) do
            for _, declared in ipairs(side) do
                declared.field = field["system_" .. declared.filter]
            end
        end
    end
end

local dialect = DIALECTS[1]
local instructions = INSTRUCTION_SETS[dialect]

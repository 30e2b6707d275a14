-- The instruction set, made ready -----------------------------------------------------------------------------------
--
-- The tables above are written to be read. Here each parameter becomes what the reading of an argument needs. Wireshark
-- wants all fields at the start. An operation is made ready when it is first met: a capture has a few of them, and the
-- collector goes through all that Lua holds again and again.

-- A table whose entries are made when they are first asked for; where there is none, it is asked for again.
local function made_late(make)
    return setmetatable({}, { __index = function(made, key)
        local entry = make(key)
        if entry then made[key] = entry end
        return entry
    end })
end

local INSTRUCTION_SETS, SYSTEM_COMMANDS
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

    -- Parameters that are alike in all but their fields are one table, of which there are a third as many.
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
        return made_late(function(number)
            local one = setmetatable({}, { __index = element })
            one.name = element.name .. "[" .. number .. "]"
            one.numbered = one.name
            one.value_key = " " .. one.name .. "="
            one.label_head = one.name .. ":"
            return one
        end)
    end

    -- Which values an element of a list takes. Where another argument tells its type, a double holds whatever it is.
    local function element_kind(row, type)
        if row[3] ~= VALUES and not TYPE_NAMES[row.element] then return FLOAT end
        return PARAMETER_KINDS[type] or NUMBER
    end

    -- The field of what a count announces.
    local function element_field(abbreviation, row)
        local name, element, text = row[1], row.element, row[4]
        if not TYPE_NAMES[element] then return ProtoField.double(abbreviation, name, text) end
        return parameter_field(abbreviation, {}, element_kind(row, element), name, text)
    end

    -- An element of a list, by its type.
    local function ready_element(list, field, type, row)
        local direction = list.type == COUNT and row.elements or IN
        return numbered({
            name = list.name, type = type, size = SIZE_OF[type] or 1, alignment = 1,
            is_float = type == DATAF, is_output = direction ~= IN,
            key = direction ~= OUT and " " .. list.name:lower() .. "=" or nil,
            field = field, kind = element_kind(row, type),
        })
    end

    -- The list at the end of an operation; `field` is that of its elements.
    local function ready_list(list, field, row)
        list.elements_of = {}
        local function add_elements(type)
            list.elements_of[type] = ready_element(list, field, type, row)
        end
        if TYPE_NAMES[row.element] then
            list.element_type = row.element
        else
            list.element_type = ARRAY_TYPED
            for _, type in pairs(FORMAT_TYPES) do
                add_elements(type)
            end
        end
        add_elements(list.element_type)
    end

    -- The parameters of an operation that tell of others: how long they are, or of which type.
    local function telling_of(rows)
        local lengths, types = {}, {}
        for _, row in ipairs(rows) do
            if row.length then lengths[row.length] = true end
            if row.element then types[row.element] = true end
        end
        return lengths, types
    end

    -- What a parameter is called in filters and in the tree, and which values it takes.
    local function described(name, row)
        local own, type = row[1], row[3]
        local label = row.label and row.label .. " " .. own or own
        local kind = PARAMETER_KINDS[type == VALUES and row.element or type] or NUMBER
        return ("ev3." .. name .. "." .. own):lower(), label, kind
    end

    -- Makes the fields of an operation: of each parameter, then, if it is a count, of what it announces.
    local function declare_fields(name, rows)
        for _, row in ipairs(rows) do
            local abbreviation, label, kind = described(name, row)
            fields[#fields + 1] = parameter_field(abbreviation, row, kind, label, row[4])
            if row[3] == COUNT then
                fields[#fields + 1] = element_field(abbreviation .. ".item", row)
            end
        end
    end

    -- All operations by a number of their own: name and parameters in one text, and where the fields begin.
    local sources, first_fields = {}, {}

    -- Names, directions and types stand for themselves in the text of parameters.
    local WORDS = setmetatable({ ENUMERATIONS = ENUMERATIONS }, { __index = function(_, word) return word end })

    local function read_rows(source)
        return load("return {" .. source .. "}", "=parameters", "t", WORDS)()
    end

    -- Notes an operation and makes its fields; its number.
    local function note_operation(name, source)
        local number = #sources + 1
        sources[number], first_fields[number] = name .. " " .. source, #fields + 1
        declare_fields(name, read_rows(source))
        return number
    end

    -- An operation: its names, and its parameters in turn, each followed by its field, all but a list of values; the
    -- list at its end, if it has one; whether it is simple: no argument tells anything of another. One that stands
    -- alone has no `cmd_name`.
    local function ready_operation(number)
        local name, source = sources[number]:match("^(%S+) (.*)$")
        local rows = read_rows(source)
        local cmd_name = name:match("%.(.+)$")
        local operation = { name = name, title = gsub(name, "%.", " "), cmd_name = cmd_name }
        local lengths, types = telling_of(rows)
        local is_simple, at = true, first_fields[number]
        for _, row in ipairs(rows) do
            local own, type = row[1], row[3]
            local _, label, kind = described(name, row)
            -- LEGO names what a command reads after the command: VALUE of GET_VBATT is VBATT.
            local value_name = own == "VALUE" and cmd_name and cmd_name:match("^GET_(.+)$") or own
            local is_list = type == COUNT or type == VALUES
            local make = is_list and ready_parameter or shared_parameter
            local parameter = make(row, kind, label, value_name, lengths[own], types[own])
            if type ~= VALUES then
                operation[#operation + 1] = parameter
                operation[#operation + 1] = fields[at]
                at = at + 1
            end
            if is_list then
                operation.list = parameter
                ready_list(parameter, fields[at], row)
            end
            if is_list or lengths[own] or types[own] then is_simple = false end
        end
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

    -- By number, as dialects share operations.
    local ready_operations = made_late(function(number)
        local operation = ready_operation(number)
        sources[number] = false
        return operation
    end)

    local function ready_entry(known)
        if type(known) == "number" then return ready_operations[known] end
        local numbers = known.commands
        local commands = made_late(function(cmd) return numbers[cmd] and ready_operations[numbers[cmd]] end)
        return { name = known.name, commands = commands }
    end

    -- What an opcode is to a dialect: the number of an operation; or a family's name, and such numbers by CMD.
    local function known_entry(row, numbers, dialect)
        if not row.commands then return numbers[row] end
        local commands = {}
        for _, command in ipairs(row.commands) do
            if has_dialect(command, dialect) then commands[command[1]] = numbers[command] end
        end
        return { name = row[2], commands = commands }
    end

    -- By dialect and opcode.
    local known_entries = {}
    for _, dialect in ipairs(DIALECTS) do
        known_entries[dialect] = {}
    end

    for _, row in ipairs(OPERATIONS) do
        local numbers = {}
        for _, command in ipairs(row.commands or {}) do
            numbers[command] = note_operation(row[2] .. "." .. command[2], command[4])
        end
        if not row.commands then numbers[row] = note_operation(row[2], row[4]) end
        for dialect, entries in pairs(known_entries) do
            if has_dialect(row, dialect) then entries[row[1]] = known_entry(row, numbers, dialect) end
        end
    end

    -- Opcode number to operation, or to a table of operations by CMD; one such set for each dialect.
    INSTRUCTION_SETS = {}
    for dialect, entries in pairs(known_entries) do
        INSTRUCTION_SETS[dialect] = made_late(function(code) return entries[code] and ready_entry(entries[code]) end)
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

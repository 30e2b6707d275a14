-- Operations --------------------------------------------------------------------------------------------------------
--
-- The operations of a direct command, or of a daisy command's payload: their line, their faults, and their items.

local operations = {}
do
    local add, set_len, append_text = TreeItem.add, TreeItem.set_len, TreeItem.append_text
    local new_range = Tvb.range
    local select_operation, read_arguments = reading.select_operation, reading.read_arguments
    local argument_text, plural, misuse_of = phrases.argument_text, phrases.plural, phrases.misuse
    local NOTHING_STATED = {}
    local VARIABLE, OPCODE, CMD, ENCODING = field.variable, field.opcode, field.cmd, field.encoding

    -- Adds a value with the field of its parameter, as text if its type differs from the parameter's. `numbered` is the
    -- name of an element of a list, with its number; `dataset` is what it receives from a device.
    function operations.add_value(tree, parameter, range, value, numbered, dataset)
        local declared, kind, is_text = parameter.field, parameter.kind, type(value) == "string"
        if is_text ~= (kind == TEXT_VALUE) or kind == NUMBER and value % 1 ~= 0 then
            local text = is_text and reading.utf8_text(value) or phrases.number_text(value)
            return add(tree, field.other, range, text, (numbered or parameter.name) .. ": " .. text)
        elseif is_text then
            local label = numbered and numbered .. ": " .. phrases.shortened(value)
            return add(tree, declared, range, reading.utf8_text(value), label)
        end
        local unit, meaning, label = kind == FLOAT and parameter.unit, nil, nil
        if parameter.special or parameter.flags then meaning = phrases.meaning_of(parameter, value) end
        if dataset then unit, meaning = dataset[2], "(" .. dataset[1] .. ")" end
        if numbered then
            local name, text = parameter.names and parameter.names[value], phrases.number_text(value)
            label = numbered .. ": " .. (name and format("%s (%s)", name, text) or text)
        elseif not (unit or meaning) then
            return add(tree, declared, range, value)
        end
        return add(tree, declared, range, value, label, unit, meaning)
    end

    -- The state of reading operations: the `heading` of the operation (nil without a tree), its `buffer`, and the
    -- frame's `base` there; the requested memory; the operation, where it starts, and the constants that its arguments
    -- state; the text `said` so far, and its number of arguments; whether a variable `is_beyond` the memory; the first
    -- `remark` on an argument; without a tree, the `complaints` and the `outputs`; the `content` that is read. Local
    -- variables are faster than a table for the many arguments.
    local heading, buffer, base, globals, locals, operation, start, stated, said, said_count, is_beyond
    local remark, complaints, outputs, content

    local function report(item, kind, at, text)
        remark = remark or format("at offset %d: %s", at, text)
        if item then
            complain(item, kind, text)
        else
            complaints[#complaints + 1] = { kind = kind, text = text }
        end
    end

    -- Adds the expert information for a variable whose index the brick refuses.
    local function complain_of_index(item, at, parameter, encoding, index, alignment)
        local reason = "%s: the index of a %s must be a multiple of %d, the brick refuses %s"
        local sort = encoding.handle and "handle" or TYPE_NAMES[parameter.type]
        local variable = argument_text(parameter, encoding, index)
        report(item, "misaligned", at, format(reason, parameter.name, sort, alignment, variable))
    end

    -- Checks the index of a variable: its alignment, and whether it is within the requested memory. Without a tree only
    -- the first variable beyond that memory is reported.
    local function check_variable(item, at, parameter, encoding, index)
        local size, alignment = parameter.size, parameter.alignment
        if encoding.handle then
            size, alignment = SIZE_OF[HANDLE], SIZE_OF[HANDLE]
        elseif encoding.address then
            size = SIZE_OF[DATA32]
        end
        if index % alignment ~= 0 then complain_of_index(item, at, parameter, encoding, index, alignment) end
        local is_global = encoding.kind == GLOBAL
        local asked = is_global and globals or locals
        if not asked or is_beyond and not item then return end
        if parameter.length and parameter.is_output and not encoding.handle then
            size = size * reply_values.stated_length(parameter, stated, 1)
        end
        if index + size <= asked then return end
        is_beyond = true
        report(item, "beyond_memory", at, format(
            "%s reaches up to byte %d of the %s memory, but the command requests %s",
            parameter.name, index + size, is_global and "global" or "local", plural(asked, "byte")))
    end

    local function check_constant(item, at, reason, code)
        if reason then report(item, REFUSED[code] and "refused" or "misread", at, reason) end
    end

    -- Appends an argument to the line of its operation.
    local function say_argument(parameter, encoding, value)
        said_count = said_count + 1
        if said_count <= phrases.MOST_VALUES then
            said = said .. parameter.key .. argument_text(parameter, encoding, value)
        elseif said_count == phrases.MOST_VALUES + 1 then
            said = said .. " ..."
        end
    end

    -- Keeps an output for the reply: its parameter, the `index` of its variable, its operation, the constants that
    -- the operation's arguments state, and what it receives from a device.
    local function note_output(parameter, encoding, index)
        outputs[#outputs + 1] = {
            parameter = parameter, index = index, is_handle = encoding.handle, operation = operation, at = start,
            stated = stated, dataset = not encoding.handle and reply_values.dataset_of(parameter, stated) or nil,
        }
    end

    local function show_argument(parameter, encoding, value, at, after)
        local item, range
        if heading then
            -- A range costs more than an item: one serves both the argument and its encoding.
            range = new_range(buffer, base + at, 1)
            if encoding.scope then
                local variable = argument_text(parameter, encoding, value)
                item = add(heading, VARIABLE, range, variable, parameter.label .. ": " .. variable)
            else
                item = operations.add_value(heading, parameter, range, value, parameter.numbered)
            end
            if after > at + 1 then set_len(item, after - at) end
        end
        if encoding.scope then
            check_variable(item, at, parameter, encoding, value)
            -- An address is the place of a value, not a value.
            if not item and encoding.kind == GLOBAL and parameter.is_output and not encoding.address then
                note_output(parameter, encoding, value)
            end
        else
            if parameter.is_stated and reply_values.is_stated(parameter, encoding) then
                stated[parameter.name] = value
            end
            local range = not parameter.is_float and parameter.range
            if encoding.kind ~= CONSTANT or not range or not (value >= range[1] and value <= range[2]) then
                check_constant(item, at, misuse_of(parameter, encoding, value, operation.name, byte(content, at + 1)))
            end
        end
        if item then add(item, ENCODING, range, encoding.label) end
        if said and parameter.key then say_argument(parameter, encoding, value) end
    end

    -- Adds the name of a CMD, with its encoding if that takes more than one byte.
    local function add_cmd(heading, selected, text, at, after)
        local range = new_range(buffer, base + at, 1)
        local item = add(heading, CMD, range, selected.name)
        if after > at + 1 then
            set_len(item, after - at)
            add(item, ENCODING, range, reading.ENCODINGS[byte(text, at + 1)].label)
        end
    end

    -- Reads the operations from an offset to the end of a frame; the last two arguments are the requested memory, if
    -- known. With a tree, `item` is the message's, and `view` has the buffer `tvb` and the frame's `base` there.
    -- Returns the line of the operations, which may be empty; the offset after the last one that could be read; the
    -- fault, or nil; and the first operation, or nil.
    local function read(text, at, item, view, asked_globals, asked_locals)
        local first, phrase, others, fault = nil, "", {}, nil
        heading, globals, locals, is_beyond, complaints, outputs = nil, asked_globals, asked_locals, false, {}, {}
        remark, content = nil, text
        if item then buffer, base = view.tvb, view.base end
        while at < #text and not fault do
            if item then heading = add(item, OPCODE, new_range(buffer, base + at, 1)) end
            local selected, after, reason, kind = select_operation(text, at)
            if not selected then
                fault = { at = after, reason = reason, kind = kind }
                break
            end
            if item and selected.cmd_name then add_cmd(heading, selected, text, at + 1, after) end
            operation, start, stated = selected, at, selected.has_stated and {} or NOTHING_STATED
            -- The line has the arguments of the first operation only.
            local is_said = item ~= nil or not first
            said, said_count = is_said and "", 0
            local offset
            after, offset, reason, kind = read_arguments(selected, text, after, show_argument)
            if not first then
                first, phrase = selected, said
            else
                others[#others + 1] = selected.name
            end
            if item then
                if selected.cmd_name then said = " " .. selected.cmd_name .. said end
                if after > at + 1 then set_len(heading, after - at) end
                if said ~= "" then append_text(heading, said) end
            end
            at = after
            if reason then fault = { at = offset, reason = reason, kind = kind } end
        end
        if not first then return "", at, fault end
        local line = first.name .. phrase
        if others[1] then line = line .. " " .. phrases.others_text(others) end
        if remark then line = format("%s [%s]", line, remark) end
        return line, at, fault, first
    end

    local function memory_sizes(text)
        local sizes = reading.unsigned16(text, HEADER_SIZE)
        local asked_globals = sizes % (GLOBAL_MASK + 1)
        return asked_globals, (sizes - asked_globals) / (GLOBAL_MASK + 1)
    end

    -- Summaries of direct commands, by what they depend on: the bytes after the type, and the firmware. Programs repeat
    -- their commands: one line takes 1.9 times as long as without a dissector with this, and 2.3 times without.
    -- Each holds about as much for its tables as the second number, besides its body.
    local MOST_BYTES, SUMMARY_BYTES = 512 * 1024, 512
    local HEADER = ("\0"):rep(HEADER_SIZE)
    local summaries, summary_bytes = {}, 0

    function operations.forget()
        summaries, summary_bytes = {}, 0
    end

    -- Returns the summary of a direct command without a tree, by its bytes after the type: `line`, `after`, `fault` and
    -- `first` as above, its `complaints`, and its `outputs`. Offsets are those in the frame.
    function operations.summary_of(body)
        local summary = summaries[body]
        if summary then return summary end
        local text = HEADER .. body
        if #text < COMMAND_HEADER_SIZE then return { outputs = {} } end
        local line, after, fault, first = read(text, COMMAND_HEADER_SIZE, nil, nil, memory_sizes(text))
        summary = {
            line = line, after = after, fault = fault, first = first, complaints = complaints, outputs = outputs,
            remark = fault and format("at offset %d: %s", fault.at, fault.reason) or remark,
        }
        if summary_bytes > MOST_BYTES then operations.forget() end
        summaries[body], summary_bytes = summary, summary_bytes + #body + SUMMARY_BYTES
        return summary
    end

    local function report_all(root, list)
        for _, complaint in ipairs(list) do
            complain(root, complaint.kind, complaint.text)
        end
    end

    -- Shows the operations of a direct command. Returns their line, the offset after them, and the fault, or nil.
    function operations.show(text, view)
        if view.item then return read(text, COMMAND_HEADER_SIZE, view.item, view, memory_sizes(text)) end
        local summary = operations.summary_of(sub(text, HEADER_SIZE + 1))
        report_all(view.root, summary.complaints)
        return summary.line, summary.after, summary.fault
    end

    -- The same for the payload of a daisy command, from an offset on. Its layout is not certain: operations are shown
    -- only if all of it can be read.
    function operations.show_payload(text, at, view, payload)
        local line, after, fault = read(text, at)
        if fault then return line, after, fault end
        if payload then return read(text, at, payload, view) end
        report_all(view.root, complaints)
        return line, after
    end

    -- Returns the values in a direct reply to a command, up to the end of its memory, and the first operation.
    function operations.read_outputs(body, reply)
        local summary = operations.summary_of(body)
        local memory, found = sub(reply.text, HEADER_SIZE + 1), {}
        for _, output in ipairs(summary.outputs) do
            if reply_values.read(output, summary.outputs, memory) then found[#found + 1] = output end
        end
        return found, summary.first
    end
end

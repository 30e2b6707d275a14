-- Operations --------------------------------------------------------------------------------------------------------
--
-- The operations of a direct command, or of a daisy command's payload: their line, their faults, and their items.

local operations = {}
do
    local add, set_len, new_range = TreeItem.add, TreeItem.set_len, Tvb.range
    local select_operation, read_arguments = reading.select_operation, reading.read_arguments
    local argument_text, plural, misuse_of = phrases.argument_text, phrases.plural, phrases.misuse
    local NOTHING_STATED = {}
    local VARIABLE, OPCODE, CMD, ENCODING = field.variable, field.opcode, field.cmd, field.encoding
    local PORTS, PORT_FIELDS = 1, { field.port_0, field.port_1, field.port_2, field.port_3 }

    -- Returns what the item of a value needs besides its range: the field of its parameter, or one for texts if its
    -- type differs; the value; its label, and what is appended, or nil. `numbered` is the name of an element of a list,
    -- with its number; `dataset` is what it receives from a device.
    local function value_parts(parameter, value, numbered, dataset)
        local declared, kind, is_text = parameter.field, parameter.kind, type(value) == "string"
        local is_other = is_text ~= (kind == TEXT_VALUE)
        if is_other or kind == NUMBER and (value % 1 ~= 0 or parameter.is_natural and value < 0) then
            local text = is_text and reading.utf8_text(value) or phrases.number_text(value)
            return field.other, text, (numbered or parameter.name) .. ": " .. text
        elseif is_text then
            return declared, reading.utf8_text(value), numbered and numbered .. ": " .. phrases.shortened(value)
        end
        local unit, meaning, label = kind == FLOAT and parameter.unit, nil, nil
        if parameter.special or parameter.flags then meaning = phrases.meaning_of(parameter, value) end
        if dataset then unit, meaning = dataset[2], "(" .. dataset[1] .. ")" end
        if numbered then
            local name, text = parameter.names and parameter.names[value], phrases.number_text(value)
            label = numbered .. ": " .. (name and format("%s (%s)", name, text) or text)
        end
        return declared, value, label, unit and meaning and unit .. " " .. meaning or unit or meaning
    end

    -- Adds a value with the field of its parameter.
    function operations.add_value(tree, parameter, range, value, numbered, dataset)
        local declared, shown, label, appended = value_parts(parameter, value, numbered, dataset)
        return add(tree, declared, range, shown, label, appended)
    end

    -- Steps are the items of operations in one list, which costs less than adding the items again by their bytes. An
    -- item is its field, offset, size, value, label, and what is appended; then what is said of it, as false, kind and
    -- text; the set of ports that it is, as PORTS and a number; and its encoding, as true and a label.
    local function add_step(steps, declared, at, size, value, label, appended)
        local last = #steps
        steps[last + 1], steps[last + 2], steps[last + 3], steps[last + 4] = declared, at, size, value
        steps[last + 5], steps[last + 6] = label or false, appended or false
    end

    local function add_mark(steps, mark, value)
        local last = #steps
        steps[last + 1], steps[last + 2] = mark, value
    end

    -- Adds the items of steps to a message's item; `base` is the frame's offset in the buffer.
    local function show_steps(steps, item, tvb, base)
        local index, last, heading, newest, range = 1, #steps, nil, nil, nil
        while index < last do
            local declared = steps[index]
            if declared == true then
                add(newest, ENCODING, range, steps[index + 1])
                index = index + 2
            elseif declared == PORTS then
                for _, port in ipairs(PORT_FIELDS) do add(newest, port, range, steps[index + 1]) end
                index = index + 2
            elseif not declared then
                complain(newest, steps[index + 1], steps[index + 2])
                index = index + 3
            else
                local is_heading, size = declared == OPCODE, steps[index + 2]
                -- A range costs more than an item: one serves both an argument and its encoding.
                range = new_range(tvb, base + steps[index + 1], is_heading and size or 1)
                newest = add(is_heading and item or heading, declared, range,
                    steps[index + 3], steps[index + 4], steps[index + 5])
                if is_heading then
                    heading = newest
                elseif size > 1 then
                    set_len(newest, size)
                end
                index = index + 6
            end
        end
    end

    -- Functions below share a `run` of reading operations: the `text`; the `steps`, nil if they are not wanted; the
    -- requested memory, `global` and `local`; the `operation`, its offset `at`, and the constants `stated` by its
    -- arguments; what was `said` so far, and the number of arguments in it; the first `remark`, the `complaints` for no
    -- tree, whether a variable `is_beyond` the memory, and the `outputs`.

    -- Nothing is said of what follows an OBJECT_END. Without a tree only the first variable beyond the memory is
    -- reported; `is_again` marks others.
    local function report(run, kind, at, text, is_again)
        if run.is_over then return end
        local steps, complaints = run.steps, run.complaints
        run.remark = run.remark or format("at offset %d: %s", at, text)
        if steps then
            local last = #steps
            steps[last + 1], steps[last + 2], steps[last + 3] = false, kind, text
        end
        if is_again then return end
        local last = #complaints
        complaints[last + 1], complaints[last + 2] = kind, text
    end

    -- Checks the index of a variable: its alignment, and whether it is within the requested memory.
    local function check_variable(run, at, parameter, encoding, index)
        local size, alignment = parameter.size, parameter.alignment
        if encoding.handle then
            size, alignment = SIZE_OF[HANDLE], parameter.numbered and 1 or SIZE_OF[HANDLE]
        elseif encoding.address then
            size = SIZE_OF[DATA32]
        end
        if index % alignment ~= 0 then
            local text = argument_text(parameter, encoding, index)
            local said = phrases.finding("MISALIGNED", { name = parameter.name, variable = text, step = alignment })
            report(run, "misaligned", at, said)
        end
        local scope = encoding.kind == GLOBAL and "global" or "local"
        local asked = run[scope]
        if not asked then return end
        if parameter.length and parameter.is_output and not encoding.handle then
            size = size * reply_values.stated_length(parameter, run.stated, 1)
        end
        local is_again = run.is_beyond
        if index + size <= asked or is_again and not run.steps then return end
        run.is_beyond = true
        local said = phrases.finding("BEYOND_" .. scope, {
            name = parameter.name, scope = scope, asked = asked > 0 and plural(asked, "byte") .. " of" or "no",
            bytes = size == 1 and "byte " .. index or format("bytes %d to %d", index, index + size - 1),
        })
        report(run, "beyond_memory", at, said, is_again)
    end

    -- Appends an argument to the line of its operation.
    local function say_argument(run, parameter, encoding, value)
        run.count = run.count + 1
        if run.count <= phrases.MOST_VALUES then
            run.said = run.said .. parameter.key .. argument_text(parameter, encoding, value)
        elseif run.count == phrases.MOST_VALUES + 1 then
            run.said = run.said .. " ..."
        end
    end

    -- Keeps an output for the reply: its parameter, the `index` of its variable, its operation, the constants that
    -- the operation's arguments state, and what it receives from a device.
    local function note_output(run, parameter, encoding, index)
        local stated = run.stated
        run.outputs[#run.outputs + 1] = {
            parameter = parameter, index = index, is_handle = encoding.handle, operation = run.operation, at = run.at,
            stated = stated, dataset = not encoding.handle and reply_values.dataset_of(parameter, stated) or nil,
        }
    end

    local function take_argument(parameter, encoding, value, at, after, run)
        local steps = run.steps
        if steps and encoding.scope then
            local variable = argument_text(parameter, encoding, value)
            add_step(steps, VARIABLE, at, after - at, variable, parameter.label .. ": " .. variable)
        elseif steps then
            local declared, shown, label, appended = value_parts(parameter, value, parameter.numbered)
            add_step(steps, declared, at, after - at, shown, label, appended)
            if parameter.is_set and declared ~= field.other then add_mark(steps, PORTS, value) end
        end
        if encoding.scope then
            check_variable(run, at, parameter, encoding, value)
            -- An address is the place of a value, not a value.
            if encoding.kind == GLOBAL and parameter.is_output and not encoding.address then
                note_output(run, parameter, encoding, value)
            end
        else
            if parameter.is_stated and encoding.kind == CONSTANT and not encoding.handle and not encoding.address then
                run.stated[parameter.name] = value
            end
            local range = not parameter.is_float and parameter.range
            if encoding.kind ~= CONSTANT or not range or not (value >= range[1] and value <= range[2]) then
                local reason, code = misuse_of(parameter, encoding, value, run.operation.name, byte(run.text, at + 1))
                if reason then report(run, REFUSED[code] and "refused" or "misread", at, reason) end
            end
        end
        if steps then add_mark(steps, true, encoding.label) end
        if run.said and parameter.key then say_argument(run, parameter, encoding, value) end
    end

    -- Reads the operations from an offset to the end of a frame; the last two arguments are the requested memory, if
    -- known. Returns the `line` of the operations, which may be empty; the offset `after` the last one that could be
    -- read; the `fault`, or nil; the `first` operation, or nil; `remark`, `complaints`, `outputs`, and with
    -- `wants_steps` the `steps` of their items.
    local function read(text, at, wants_steps, globals, locals)
        local first, phrase, names, fault, line = nil, "", {}, nil, ""
        local steps = wants_steps and {} or nil
        local run = { text = text, steps = steps, global = globals, ["local"] = locals, complaints = {}, outputs = {} }
        while at < #text and not fault do
            local heading = steps and #steps
            if steps then add_step(steps, OPCODE, at, 1, byte(text, at + 1)) end
            local selected, after, reason, kind = select_operation(text, at)
            if not selected then
                fault = { at = after, reason = reason, kind = kind }
                break
            end
            if byte(text, at + 1) == CLAIMS.never_sent then
                report(run, "refused", at, (phrases.finding("NEVER_RUNS", { byte = "0x00", owner = selected.name })))
            elseif selected.name == "OBJECT_END" and after < #text then
                local said = { bytes = plural(#text - after, "byte"), ["end"] = at }
                report(run, "refused", at, (phrases.finding("AFTER_END", said)))
                run.is_over = true
            end
            local cmd = selected.cmd_name
            if steps and cmd then
                add_step(steps, CMD, at + 1, after - at - 1, selected.name)
                if after > at + 2 then add_mark(steps, true, reading.ENCODINGS[byte(text, at + 2)].label) end
            end
            run.operation, run.at, run.stated = selected, at, selected.has_stated and {} or NOTHING_STATED
            -- The line has the arguments of the first operation only.
            run.said, run.count = (steps or not first) and "", 0
            local offset
            after, offset, reason, kind = read_arguments(selected, text, after, take_argument, run)
            local said = run.said
            if not first then first, phrase = selected, said end
            names[#names + 1] = selected.name
            if steps then
                steps[heading + 3] = after - at
                steps[heading + 6] = cmd and cmd .. said or said ~= "" and sub(said, 2)
            end
            at = after
            if reason then fault = { at = offset, reason = reason, kind = kind } end
        end
        if first then line = first.name .. phrase end
        if names[2] then line = line .. " " .. phrases.others_text(names) end
        if first and run.remark then line = format("%s [%s]", line, run.remark) end
        return {
            line = line, after = at, fault = fault, first = first, complaints = run.complaints, outputs = run.outputs,
            remark = fault and format("at offset %d: %s", fault.at, fault.reason) or run.remark, steps = steps,
            names = names[2] and names,
        }
    end

    -- Summaries of direct commands, by their bytes after the type, because programs repeat their commands. Each holds
    -- about as much for its tables as the second number, besides its body.
    local MOST_BYTES, SUMMARY_BYTES = 512 * 1024, 512
    -- The same for steps, of which each value takes as much as the second number.
    local MOST_STEP_BYTES, STEP_BYTES = 2048 * 1024, 20
    local HEADER = ("\0"):rep(HEADER_SIZE)
    local summaries, summary_bytes, step_bytes = {}, 0, 0

    function operations.forget()
        summaries, summary_bytes, step_bytes = {}, 0, 0
    end

    -- Keeps a summary that was read; its steps only from the second time on that its items are shown, because some
    -- programs never repeat a command.
    local function keep(body, summary, is_again)
        if summary_bytes > MOST_BYTES or step_bytes > MOST_STEP_BYTES then operations.forget() end
        if not summaries[body] then summary_bytes = summary_bytes + #body + SUMMARY_BYTES end
        summaries[body], summary.is_shown = summary, summary.steps ~= nil
        if not is_again then summary.steps = nil end
        step_bytes = step_bytes + (summary.steps and #summary.steps * STEP_BYTES or 0)
    end

    -- Returns the summary of a direct command by its bytes after the type, and its steps if they are wanted. Offsets
    -- are those in the frame.
    function operations.summary_of(body, wants_steps)
        local kept = summaries[body]
        if kept and (kept.steps or not wants_steps) then return kept, kept.steps end
        local text = HEADER .. body
        if #text < COMMAND_HEADER_SIZE then return { outputs = {} } end
        local summary = read(text, COMMAND_HEADER_SIZE, wants_steps, reading.memory_sizes(text))
        local steps = summary.steps
        keep(body, summary, kept and kept.is_shown)
        return summary, steps
    end

    -- Shows what was read. Returns its line, the offset after it, and the fault, or nil.
    local function show(summary, shown, item, view)
        if item then
            show_steps(shown, item, view.tvb, view.base)
        else
            local complaints = summary.complaints
            for index = 1, #complaints, 2 do
                complain(view.root, complaints[index], complaints[index + 1])
            end
        end
        return summary.line, summary.after, summary.fault
    end

    -- Shows the operations of a direct command.
    function operations.show(text, view)
        local summary, shown = operations.summary_of(sub(text, HEADER_SIZE + 1), view.item ~= nil)
        return show(summary, shown, view.item, view)
    end

    -- The same for the payload of a daisy command, from an offset on. Its layout is not certain: operations are shown
    -- only if all of it can be read.
    function operations.show_payload(text, at, view, payload)
        local summary = read(text, at, payload ~= nil)
        if summary.fault then return summary.line, summary.after, summary.fault end
        return show(summary, summary.steps, payload, view)
    end

    -- Gives each operation of a list the inputs that tell it apart from the others, as few of the first ones as do.
    local function tell_apart(list, telling)
        local count = 1
        for index = 1, #list[1] do
            local texts, known, distinct = {}, {}, 0
            for number, inputs in ipairs(list) do
                local own = inputs[index] or ""
                texts[number] = telling[inputs.at] and telling[inputs.at] .. " " .. own or own
                if not known[texts[number]] then known[texts[number]], distinct = true, distinct + 1 end
            end
            for number, inputs in ipairs(distinct > count and list or {}) do
                telling[inputs.at] = texts[number]
            end
            count = math.max(count, distinct)
        end
    end

    -- Gives the outputs of operations that have the same name a `telling`: the inputs in which these differ.
    local function add_tellings(summary, body)
        local known, has_twins = {}, false
        for _, name in ipairs(summary.names) do
            has_twins, known[name] = has_twins or known[name], true
        end
        if not has_twins then return end
        local text, at, reason, by_name, telling = HEADER .. body, COMMAND_HEADER_SIZE, nil, {}, {}
        while at < #text and not reason do
            local inputs = { at = at }
            local operation, after, _, fault = reading.read_operation(text, at, function(parameter, encoding, value)
                local key = parameter.key
                if key then inputs[#inputs + 1] = sub(key, 2) .. argument_text(parameter, encoding, value) end
            end)
            local list = operation and by_name[operation.name] or {}
            list[#list + 1] = inputs
            if operation then by_name[operation.name] = list end
            at, reason = after, fault
        end
        for _, list in pairs(by_name) do
            if list[2] then tell_apart(list, telling) end
        end
        for _, output in ipairs(summary.outputs) do output.telling = telling[output.at] end
    end

    -- Returns the values in a direct reply to a command, up to the end of its memory, and the first operation.
    function operations.read_outputs(body, reply)
        local summary = operations.summary_of(body)
        local memory, found, outputs = sub(reply.text, HEADER_SIZE + 1), {}, summary.outputs
        if #outputs > 1 and outputs[1].at ~= outputs[#outputs].at and not summary.is_told then
            summary.is_told = true
            add_tellings(summary, body)
        end
        for _, output in ipairs(outputs) do
            if reply_values.read(output, outputs, memory) then found[#found + 1] = output end
        end
        return found, summary.first
    end
end

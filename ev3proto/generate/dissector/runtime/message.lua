-- Messages ----------------------------------------------------------------------------------------------------------
--
-- One frame, read as far as it goes. Each kind of message has one function, which reads it, returns the line that the
-- info column shows, and adds to the tree if there is one. `item` is the message's item in the tree, or nil; `part`
-- gives the bytes between two offsets in the frame, for Wireshark to highlight.

local read_message, show_message
do
    local add, add_le, set_generated = TreeItem.add, TreeItem.add_le, TreeItem.set_generated
    local set_len, set_text = TreeItem.set_len, TreeItem.set_text
    local new_range = Tvb.range
    local LENGTH, COUNTER, TYPE = field.length, field.counter, field.type

    local report_field = {}
    for _, part in ipairs(DAISY.sensor_report) do
        local make = part.size == 1 and ProtoField.uint8 or ProtoField.bytes
        report_field[part.name] = make("ev3.daisy." .. part.name, part.name)
        fields[#fields + 1] = report_field[part.name]
    end

    local function add_rest(item, tvb, base, at, stop)
        if at < stop then item:add(field.rest, tvb(base + at, stop - at)) end
    end

    -- What is wrong with a message as a whole.
    local function complain_of(message, kind, text)
        message.complaints = message.complaints or {}
        message.complaints[#message.complaints + 1] = kind
        message.complaints[#message.complaints + 1] = text
    end

    -- `said` is said of its operations, nothing where there is none.
    local function line_of(message, said, fault)
        if said ~= "" then return said end
        return fault and message.type.name or "no operations"
    end

    local function say_cut_command(message)
        local reason = "a direct command starts with two bytes that ask for memory"
        message.fault = { at = message.stop, reason = reason, kind = "cut_off" }
        return message.type.name
    end

    -- How many bytes of global and of local memory a direct command asks for.
    local function asked_memory(text)
        local sizes = unsigned16(text, HEADER_SIZE)
        local globals = sizes % (GLOBAL_MASK + 1)
        return globals, (sizes - globals) / (GLOBAL_MASK + 1)
    end

    local function say_direct_command(message)
        local text, body = message.text, message.body
        if message.stop < COMMAND_HEADER_SIZE then return say_cut_command(message) end
        local line, fault, complaints =
            say_operations(text, COMMAND_HEADER_SIZE, message.stop, asked_memory(text))
        if message.type.wants_reply then layout_notes.keep(body) end
        message.fault, message.complaints = fault, complaints
        return line_of(message, line, fault)
    end

    -- A direct command is said and added at once: it is read but once.
    local function show_direct_command(message, item, tvb, base)
        local text, stop = message.text, message.stop
        if stop < COMMAND_HEADER_SIZE then
            add_rest(item, tvb, base, HEADER_SIZE, stop)
            return say_cut_command(message)
        end
        local range = new_range(tvb, base + HEADER_SIZE, MEMORY_FIELD)
        local asked = add_le(item, field.memory_sizes, range)
        add_le(asked, field.globals, range)
        add_le(asked, field.locals, range)
        local globals, locals = asked_memory(text)
        local line, after, fault =
            show_operations(item, tvb, base, text, COMMAND_HEADER_SIZE, stop, globals, locals)
        if message.type.wants_reply then layout_notes.keep(message.body) end
        if fault then
            message.fault = fault
            add_rest(item, tvb, base, after, stop)
        end
        return line_of(message, line, fault)
    end

    local function say_direct_reply(message, place, is_shown)
        local request = request_of(place)
        message.outputs, message.count = nil, 0
        if message.type.is_error then
            complain_of(message, "error_reply", "the brick refused or failed the command; it tells no more")
            local body = request and request.body
            local operation = body and #body > MEMORY_FIELD and read_operation(body, MEMORY_FIELD, #body)
            return operation and "error reply to " .. operation.title or "error reply"
        end
        if not request then
            return "reply: " .. plural(message.stop - HEADER_SIZE, "byte") .. ", command not seen"
        end
        local layout = layout_notes.layout_for(request.body)
        local outputs, count, head = read_reply(layout, message, is_shown)
        message.outputs, message.count = outputs, count
        if count > 0 then return values_text(head, outputs, count) end
        return head .. " " .. (message.stop == HEADER_SIZE and "ok" or plural(message.stop - HEADER_SIZE, "byte"))
    end

    -- `range` is that of its bytes.
    local function add_output(item, tvb, base, output, range)
        local parameter = output.parameter
        -- Most are numbers of which the field says all.
        if parameter.is_plain and not (output.list or output.is_handle) then
            add(item, output.field, range, output.value)
            return
        end
        local name = parameter.name
        if not output.list then
            local declared, value, label, addition =
                value_of_row(parameter, output.field, output.value, parameter.numbered)
            if output.is_handle then label = name .. ": handle " .. output.value end
            add(item, declared, range, value, label, addition)
            return
        end
        local list = add(item, field.list, range):set_text(name .. ": " .. output_text(output))
        local at, step = base + HEADER_SIZE + output.index, output.size / #output.list
        for index, element in ipairs(output.list) do
            local declared, value, label, addition =
                value_of_row(parameter, output.field, element, format("%s[%d]", name, index - 1))
            add(list, declared, tvb(at + (index - 1) * step, step), value, label, addition)
        end
    end

    local function add_direct_reply(message, item, tvb, base)
        local stop, outputs, count = message.stop, message.outputs, message.count
        if stop == HEADER_SIZE then return end
        local memory = new_range(tvb, base + HEADER_SIZE, stop - HEADER_SIZE)
        add(item, field.memory, memory)
        local first = 1
        while first <= count do
            -- The values of one operation stand one after the other.
            local offset, last = outputs[first].offset, first
            while last < count and outputs[last + 1].offset == offset do
                last = last + 1
            end
            local start, after = stop, HEADER_SIZE
            for index = first, last do
                local output = outputs[index]
                local at, size = HEADER_SIZE + output.index, output.size
                if at < start then start = at end
                if at + size > after then after = at + size end
            end
            local name, size = outputs[first].operation.name, after - start
            -- A range costs as much as half an item. Often an operation has one value, and a reply one operation.
            local range = size == stop - HEADER_SIZE and memory or new_range(tvb, base + start, size)
            local added = add(item, field.answers, range, name)
            for index = first, last do
                local output = outputs[index]
                local own = output.size == size and range
                    or new_range(tvb, base + HEADER_SIZE + output.index, output.size)
                add_output(added, tvb, base, output, own)
            end
            first = last + 1
        end
    end

    -- The values that tell most about a system message: its texts, and how much there is.
    local function fields_text(message)
        local pieces = {}
        for _, found in ipairs(message.fields) do
            local declared, value = found.declared, found.value
            local kind = declared.kind
            if kind == TEXT or kind == COUNTED_TEXT then
                pieces[#pieces + 1] = " " .. shortened(value)
            elseif kind == BYTES or kind == LISTING then
                pieces[#pieces + 1] = " " .. plural(#value, "byte")
            elseif not declared.counts and declared.name ~= "handle" then
                pieces[#pieces + 1] = format(declared.hexadecimal and " %s=0x%X" or " %s=%d", declared.filter, value)
            end
        end
        return concat(pieces)
    end

    -- What a system message is about: the pieces of a file are about the file and how far it is.
    local function subject_text(message, place)
        local transfer = transfer_at(place)
        local is_first = message.command.transfer == "begin" and message.type.is_command
        if transfer and transfer.path ~= "" and not is_first then
            return " " .. transfer_text(transfer)
        end
        return fields_text(message)
    end

    local function add_fields(message, item, tvb, base)
        for _, found in ipairs(message.fields) do
            local range, value, kind = tvb(base + found.at, found.stop - found.at), found.value, found.declared.kind
            if kind == BYTES then
                item:add(found.declared.field, range)
            else
                item:add(found.declared.field, range, type(value) == "string" and utf8_text(value) or value)
            end
        end
        add_rest(item, tvb, base, message.rest, message.stop)
    end

    local function status_text(status)
        return STATUS.names[status] or format("status %d", status)
    end

    -- Commands and replies. Their fields were read with the frame, as the notes on files need them.
    local function say_system_message(message, place)
        local command, status = message.command, message.status
        if status and (STATUS.fails[status] ~= false or message.type.is_error) then
            complain_of(message, "failed", "the command failed: " .. status_text(status))
        end
        if not command then
            local number = byte(message.text, HEADER_SIZE + 1)
            return number and format("system command 0x%02X", number) or message.type.name
        end
        local line = command.name .. subject_text(message, place)
        if message.type.is_command then return line end
        return "reply: " .. (status ~= STATUS.success and line .. " " .. status_text(status) or line)
    end

    local function add_system_message(message, item, tvb, base)
        local at, command = HEADER_SIZE, message.command
        local number = byte(message.text, at + 1)
        if number then
            local added = item:add(field.system_command, tvb(base + at, 1))
            if command then added:append_text(": " .. command.text) end
        end
        if message.status then item:add(field.status, tvb(base + at + 1, 1), message.status) end
        add_fields(message, item, tvb, base)
    end

    local function say_daisy_command(message)
        local text, stop, at = message.text, message.stop, HEADER_SIZE
        message.has_operations = false
        if stop < at + DAISY_PAYLOAD then
            local reason = "a daisy command starts with a sub-command and two layers"
            message.fault = { at = stop, reason = reason, kind = "cut_off" }
            return message.type.name
        end
        local number, from, to = byte(text, at + 1, at + 3)
        local name = DAISY.names[number]
        if not name then
            message.fault = { at = at, reason = format("0x%02X is no daisy sub-command", number), kind = "fault" }
        end
        local payload = at + DAISY_PAYLOAD
        local line = format("daisy %s layer %d to %d", name or format("0x%02X", number), from, to)
        -- The payload's layout is not certain: operations are shown only where all of it reads as such.
        if payload < stop and DAISY.carries_operations[number] then
            local said, fault = say_operations(text, payload, stop)
            message.has_operations = not fault
            if not fault then line = line .. ": " .. said end
        end
        return line
    end

    local function add_daisy_command(message, item, tvb, base)
        local stop, at = message.stop, HEADER_SIZE
        local payload = at + DAISY_PAYLOAD
        if stop < payload then return add_rest(item, tvb, base, at, stop) end
        item:add(field.daisy_command, tvb(base + at, 1))
        item:add(field.layer_from, tvb(base + at + 1, 1))
        item:add(field.layer_to, tvb(base + at + 2, 1))
        if payload < stop then
            local added = item:add(field.daisy_payload, tvb(base + payload, stop - payload))
            if message.has_operations then show_operations(added, tvb, base, message.text, payload, stop) end
        end
    end

    local function say_daisy_reply(message)
        local at = HEADER_SIZE
        if message.stop < at + 2 then
            message.fault = { at = message.stop, reason = "a daisy reply starts with two layers", kind = "cut_off" }
            return message.type.name
        end
        return format("daisy reply layer %d to %d", byte(message.text, at + 1, at + 2))
    end

    local function add_daisy_reply(message, item, tvb, base)
        local stop, at = message.stop, HEADER_SIZE
        local payload = at + 2
        if stop < payload then return add_rest(item, tvb, base, at, stop) end
        item:add(field.layer_from, tvb(base + at, 1))
        item:add(field.layer_to, tvb(base + at + 1, 1))
        if payload == stop then return end
        local added = item:add(field.daisy_payload, tvb(base + payload, stop - payload))
        at = payload
        for _, declared in ipairs(stop - payload >= DAISY.sensor_report_size and DAISY.sensor_report or {}) do
            -- The last part takes what is left.
            local after = declared.size and at + declared.size or stop
            if after > at then added:add(report_field[declared.name], tvb(base + at, after - at)) end
            at = after
        end
    end

    local function say_unknown_message(message)
        local code = byte(message.text, HEADER_SIZE)
        message.fault = { at = HEADER_SIZE - 1, reason = format("0x%02X is no message type", code), kind = "fault" }
        return format("message of unknown type 0x%02X", code)
    end

    local function add_unknown_message(message, item, tvb, base)
        add_rest(item, tvb, base, HEADER_SIZE, message.stop)
    end

    -- What each kind of message says in one line, and what it adds to its item in the tree.
    local UNKNOWN = { say = say_unknown_message, add = add_unknown_message }
    local SYSTEM_MESSAGE = { say = say_system_message, add = add_system_message }
    local KINDS = {
        direct = {
            [true] = { say = say_direct_command, show = show_direct_command },
            [false] = { say = say_direct_reply, add = add_direct_reply },
        },
        system = { [true] = SYSTEM_MESSAGE, [false] = SYSTEM_MESSAGE },
        daisy = {
            [true] = { say = say_daisy_command, add = add_daisy_command },
            [false] = { say = say_daisy_reply, add = add_daisy_reply },
        },
    }
    local kind_of = {}
    for _, declared in pairs(MESSAGE_TYPES) do
        kind_of[declared] = KINDS[declared.carries][declared.is_command == true]
    end

    -- A frame that was cut explains what is missing in it.
    local function check_size(message)
        local stop, fault = message.stop, message.fault
        if stop < message.size and not (fault and fault.kind ~= "cut_off") then
            local reason = "the frame is cut off: its length field says %d bytes follow, %d do"
            reason = format(reason, message.size - LENGTH_FIELD, stop - LENGTH_FIELD)
            message.fault = { at = 0, reason = reason, kind = "cut_off" }
        end
    end

    local function add_links(item, target, message, place, is_new)
        local type = message.type
        if not type or message.is_overwritten then return end
        if type.wants_reply then
            -- The first time that a command is seen, its reply is still to come.
            local reply = not is_new and reply_to(place)
            if reply == nil then
                complain(target, "unanswered", "no reply to this command was seen")
            elseif reply and item then
                set_generated(add(item, field.response_in, reply))
            end
        elseif not type.is_command then
            local request = request_of(place)
            if not request then
                complain(target, "orphan", "the command that this reply answers was not seen")
            elseif item then
                local delay, seconds = request.delay, floor(request.delay)
                set_generated(add(item, field.request_in, number_of(request.place)))
                local time = NSTime.new(seconds, floor((delay - seconds) * 1e9 + 0.5))
                set_generated(add(item, field.response_time, time))
            end
        end
        local transfer = item and transfer_at(place)
        if transfer then
            set_generated(add(item, field.transfer_path, utf8_text(transfer.path)))
            set_generated(add(item, field.transfer_done, transfer.done))
            if transfer.size then set_generated(add(item, field.transfer_size, transfer.size)) end
        end
    end

    local function read_system_fields(message)
        local text, at, stop, type = message.text, HEADER_SIZE, message.stop, message.type
        message.fields = {}
        local start = type.is_command and at + 1 or at + 2
        if stop < start then
            message.rest = type.is_command and stop or at
            local reason = type.is_command and "the frame ends where the system command should stand"
                or "a system reply starts with the command answered and a status"
            message.fault = { at = stop, reason = reason, kind = "cut_off" }
            return
        end
        local number = byte(text, at + 1)
        if not type.is_command then message.status = byte(text, at + 2) end
        message.command = SYSTEM_COMMANDS[number]
        if not message.command then
            message.rest = start
            message.fault = { at = at, reason = format("0x%02X is no system command", number), kind = "fault" }
            return
        end
        local declared = type.is_command and message.command.request or message.command.reply
        -- Replies to commands that failed may end before any field.
        local is_complete = type.is_command or (message.status == STATUS.success and not type.is_error)
        message.fields, message.rest, message.fault = read_fields(text, start, stop, declared, is_complete)
    end

    -- One table serves all messages that are no system messages, one after the other.
    local plain = {}

    -- The message in a frame. `text` is all there is of it, which may be less than its length field says.
    function read_message(text)
        local low, high, first, second, code = byte(text, 1, HEADER_SIZE)
        local type = MESSAGE_TYPES[code]
        local message = plain
        if type and type.carries == "system" then
            message = {}
        else
            message.fault, message.complaints, message.is_overwritten = nil, nil, nil
        end
        message.text, message.stop, message.size = text, #text, LENGTH_FIELD + low + high * 0x100
        message.counter, message.type = first + second * 0x100, type
        if message ~= plain then
            read_system_fields(message)
        elseif type and type.is_command then
            message.body = sub(text, HEADER_SIZE + 1)
        else
            message.body = nil
        end
        return message
    end

    -- The item of a message, with its header. Its text may come later.
    local function add_frame(tree, tvb, base, message, line)
        local range = new_range(tvb, base, message.stop)
        local item = add_item(tree, range, line)
        -- A range costs more than an item: the length has none of its own.
        set_len(add(item, LENGTH, range, message.size - LENGTH_FIELD), LENGTH_FIELD)
        add_le(item, COUNTER, new_range(tvb, base + LENGTH_FIELD, 2))
        add(item, TYPE, new_range(tvb, base + HEADER_SIZE - 1, 1))
        return item
    end

    -- The line on a message at a place. If somebody looks at the tree, its item there, too, with the frame at an offset
    -- in the buffer; `said` is said of the message instead of what it says; `is_new`: it is seen for the first time.
    function show_message(message, place, tvb, base, tree, is_shown, said, is_new)
        local kind = kind_of[message.type] or UNKNOWN
        local line, item
        if is_shown and kind.show then
            item = add_frame(tree, tvb, base, message)
            line = kind.show(message, item, tvb, base)
        else
            line = kind.say(message, place, is_shown)
        end
        if message.stop < message.size then check_size(message) end
        local fault, complaints = message.fault, message.complaints
        if said then
            line = said
        elseif fault then
            line = format("%s [fault at offset %d: %s]", line, fault.at, fault.reason)
        end
        if item then
            set_text(item, "EV3: " .. line)
        elseif is_shown then
            item = add_frame(tree, tvb, base, message, line)
            kind.add(message, item, tvb, base)
        end
        local target = item or tree
        if complaints then
            for index = 1, #complaints, 2 do
                complain(target, complaints[index], complaints[index + 1])
            end
        end
        add_links(item, target, message, place, is_new)
        if fault then complain(target, fault.kind, format("at offset %d: %s", fault.at, fault.reason)) end
        return line, item
    end
end

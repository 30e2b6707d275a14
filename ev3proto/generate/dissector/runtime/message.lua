-- Messages ----------------------------------------------------------------------------------------------------------
--
-- One frame, read up to its first fault. Each kind of message has one function, which returns the line for the info
-- column, and adds items if there is a tree. They share a `view`: `root`, the tree; `item`, the message's item, or nil;
-- `target`, for expert information, the item or else the root; `tvb` and `base`, the buffer and the frame's offset in
-- it; `place`, the message's place in the capture.

do
    local add, add_le, set_generated = TreeItem.add, TreeItem.add_le, TreeItem.set_generated
    local set_len, set_text = TreeItem.set_len, TreeItem.set_text
    local new_range = Tvb.range

    -- Bytes of a daisy command before its payload: the sub-command and two layers.
    local DAISY_PAYLOAD = 3

    local function bytes_between(view, at, stop)
        return new_range(view.tvb, view.base + at, stop - at)
    end

    local function add_rest(message, view, at)
        if view.item and at < message.stop then view.item:add(field.rest, bytes_between(view, at, message.stop)) end
    end

    local function set_fault(message, at, reason, kind)
        message.fault = { at = at, reason = reason, kind = kind }
    end

    -- Returns the line of a message that ends before its type's fixed fields.
    local function cut_off(message, view, reason)
        add_rest(message, view, HEADER_SIZE)
        set_fault(message, message.stop, reason, "cut_off")
        return message.type.name
    end

    local function show_direct_command(message, view)
        if message.stop < COMMAND_HEADER_SIZE then return cut_off(message, view, (phrases.finding("NO_MEMORY", {}))) end
        if view.item then
            local range = bytes_between(view, HEADER_SIZE, COMMAND_HEADER_SIZE)
            local asked = add_le(view.item, field.memory_sizes, range)
            add_le(asked, field.globals, range)
            add_le(asked, field.locals, range)
        end
        local line, after, fault = operations.show(message.text, view)
        message.fault = fault
        if fault then add_rest(message, view, after) end
        if line ~= "" then return line end
        if fault then return message.type.name end
        if not message.is_cut then complain(view.target, "refused", (phrases.finding("EMPTY", {}))) end
        return "no operations"
    end

    local function add_output(tree, view, output)
        local parameter, at, name = output.parameter, HEADER_SIZE + output.index, output.parameter.name
        local range = bytes_between(view, at, at + output.size)
        local list = output.value
        if type(list) ~= "table" then
            local item = operations.add_value(tree, parameter, range, list, parameter.numbered, output.dataset)
            if output.is_handle then set_text(item, name .. ": handle " .. list) end
            return
        end
        local item = add(tree, field.list, range):set_text(name .. ": " .. phrases.output_text(output))
        local size = output.size / #list
        for index, element in ipairs(list) do
            local start = at + (index - 1) * size
            local one = bytes_between(view, start, start + size)
            operations.add_value(item, parameter, one, element, format("%s[%d]", name, index - 1))
        end
    end

    -- Adds the values of a reply, grouped by operation.
    local function add_outputs(view, outputs)
        local first = 1
        while first <= #outputs do
            local at, last = outputs[first].at, first
            local start, stop = outputs[first].index, 0
            while outputs[last] and outputs[last].at == at do
                start = math.min(start, outputs[last].index)
                stop = math.max(stop, outputs[last].index + outputs[last].size)
                last = last + 1
            end
            local range = bytes_between(view, HEADER_SIZE + start, HEADER_SIZE + stop)
            local output = outputs[first]
            local item = add(view.item, field.answers, range, output.operation.name, nil, output.telling)
            for index = first, last - 1 do add_output(item, view, outputs[index]) end
            first = last
        end
    end

    local function show_direct_reply(message, view)
        local request, stop = view.request, message.stop
        if view.item and stop > HEADER_SIZE then
            add(view.item, field.memory, bytes_between(view, HEADER_SIZE, stop))
        end
        if message.type.is_error then
            local summary = request and operations.summary_of(request.body) or {}
            local why = summary.remark and "in the command, " .. summary.remark or "it does not say why"
            complain(view.target, "error_reply", "the brick refused the command or failed to execute it; " .. why)
            local first = summary.first
            return first and "error reply to " .. first.name or "error reply"
        end
        local size = phrases.plural(stop - HEADER_SIZE, "byte")
        if not request then return "reply: " .. size .. ", command not seen" end
        local outputs, first = operations.read_outputs(request.body, message)
        if view.item then add_outputs(view, outputs) end
        local head = first and "reply to " .. first.name .. ":" or "reply:"
        if outputs[1] then return phrases.values_text(head, outputs) end
        return head .. " " .. (stop == HEADER_SIZE and "ok" or size)
    end

    -- Returns the possible interpretations of a mailbox's message, whose type is not in the frame: field, value, and
    -- text.
    local function meanings_of(payload)
        local meanings = {}
        local function add_reading(kind, value, text)
            meanings[#meanings + 1] = { field = field["message_" .. kind], value = value, text = kind .. " " .. text }
        end
        if payload == "\0" or payload == "\1" then
            add_reading("logic", payload == "\1", payload == "\1" and "true" or "false")
        end
        if #payload == SIZE_OF[DATAF] then
            local number = reading.READ_TYPE[DATAF](payload, 0)
            add_reading("number", number, phrases.number_text(number))
        end
        local text = payload:match("^([^\0]*)\0$")
        if text and (#payload ~= SIZE_OF[DATAF] or not find(text, "[^\32-\126\160-\255]")) then
            add_reading("text", reading.utf8_text(text), phrases.shortened(text))
        end
        return meanings
    end

    -- Returns the main values of a system message: its texts, and the amount of data.
    local function fields_text(message)
        local pieces = {}
        for _, found in ipairs(message.fields) do
            local declared, value = found.declared, found.value
            local kind = declared.kind
            if kind == TEXT or kind == COUNTED_TEXT then
                pieces[#pieces + 1] = " " .. phrases.shortened(value)
            elseif kind == BYTES or kind == LISTING then
                local texts = {}
                for index, meaning in ipairs(declared.is_message and meanings_of(value) or {}) do
                    texts[index] = meaning.text
                end
                pieces[#pieces + 1] = " " .. (texts[1] and concat(texts, " or ") or phrases.plural(#value, "byte"))
            elseif not declared.counts and declared.name ~= "handle" then
                pieces[#pieces + 1] = format(declared.hexadecimal and " %s=0x%X" or " %s=%d", declared.filter, value)
            end
        end
        return concat(pieces)
    end

    -- Returns the subject of a system message; for a piece of a file, the file and its progress.
    local function subject_text(message, place)
        local transfer = dialogues.transfer_at(place)
        local is_first = message.command.transfer == "begin" and message.type.is_command
        if transfer and transfer.path ~= "" and not is_first then return " " .. phrases.transfer_text(transfer) end
        return fields_text(message)
    end

    local function status_text(status)
        return STATUS.names[status] or format("status %d", status)
    end

    -- Returns the meaning of a status for its command, after a colon; empty if the firmware does not use it there.
    local function status_meaning(message)
        local meaning = message.command and message.command.statuses[message.status]
        return meaning and ": " .. meaning or ""
    end

    local function add_system_message(message, view)
        local item, at, command, text = view.item, HEADER_SIZE, message.command, message.text
        if byte(text, at + 1) then
            local added = item:add(field.system_command, bytes_between(view, at, at + 1))
            if command then added:append_text(": " .. command.text) end
        end
        if message.status then
            local added = item:add(field.status, bytes_between(view, at + 1, at + 2), message.status)
            added:append_text(status_meaning(message))
        end
        for _, found in ipairs(message.fields) do
            local declared, range = found.declared, bytes_between(view, found.at, found.stop)
            local value = found.value
            if type(value) == "string" then value = reading.utf8_text(value) end
            local added = declared.kind == BYTES and item:add(declared.field, range)
                or item:add(declared.field, range, value)
            for _, meaning in ipairs(declared.is_message and meanings_of(found.value) or {}) do
                added:add(meaning.field, range, meaning.value)
            end
            -- A piece of a listing may begin and end within a line.
            for line in (declared.kind == LISTING and found.value or ""):gmatch("[^\n]+") do
                local size, name = line:match("^%x+ (%x+) (.+)$")
                local shown = phrases.on_one_line(name or line)
                if size then shown = format("%s, %s bytes", shown, phrases.number_text(tonumber(size, 16))) end
                added:add(range, shown)
            end
        end
        add_rest(message, view, message.rest)
    end

    -- Complains about a name and a message that are too long for a mailbox.
    local function check_mailbox(fields, target)
        for _, found in ipairs(fields) do
            local key = found.declared.is_message and "MAILBOX_CONTENT" or "MAILBOX_NAME"
            local size = type(found.value) == "string" and #found.value or 0
            if size > MOST_IN_MAILBOX[key] then complain(target, "misread", phrases.finding(key, { size = size })) end
        end
    end

    -- Commands and replies. Their fields were read with the frame, because file transfers need them.
    local function show_system_message(message, view)
        local command, status = message.command, message.status
        if view.item then add_system_message(message, view) end
        if command and command.has_message then check_mailbox(message.fields, view.target) end
        if status and (STATUS.fails[status] ~= false or message.type.is_error) then
            complain(view.target, "failed", "the command failed: " .. status_text(status) .. status_meaning(message))
        end
        if not command then
            local number = byte(message.text, HEADER_SIZE + 1)
            return number and format("system command 0x%02X", number) or message.type.name
        end
        local line = command.name .. subject_text(message, view.place)
        if message.type.is_command then return line end
        return "reply: " .. (status ~= STATUS.success and line .. " " .. status_text(status) or line)
    end

    -- Adds the two layers at an offset, and the payload after them. Returns the payload's item, if any.
    local function add_layers(message, view, at)
        local item, stop = view.item, message.stop
        if not item then return nil end
        item:add(field.layer_from, bytes_between(view, at, at + 1))
        item:add(field.layer_to, bytes_between(view, at + 1, at + 2))
        return at + 2 < stop and item:add(field.daisy_payload, bytes_between(view, at + 2, stop)) or nil
    end

    local function show_daisy_command(message, view)
        local text, at = message.text, HEADER_SIZE
        if message.stop < at + DAISY_PAYLOAD then
            return cut_off(message, view, (phrases.finding("UNKNOWN_DAISY", { reason = REASONS.daisy_command })))
        end
        local number, from, to = byte(text, at + 1, at + 3)
        local name = DAISY.names[number]
        if not name then
            local reason = phrases.filled(REASONS.no_daisy, { byte = format("0x%02X", number) })
            set_fault(message, at, phrases.finding("UNKNOWN_DAISY", { reason = reason }), "fault")
        end
        if view.item then view.item:add(field.daisy_command, bytes_between(view, at, at + 1)) end
        local payload = add_layers(message, view, at + 1)
        local line = format("daisy %s layer %d to %d", name or format("0x%02X", number), from, to)
        at = at + DAISY_PAYLOAD
        if at == message.stop or not DAISY.carries_operations[number] then return line end
        -- The payload's layout is not certain: operations are shown only if all of it can be read.
        local said, _, fault = operations.show_payload(text, at, view, payload)
        return fault and line or line .. ": " .. said
    end

    local function show_daisy_reply(message, view)
        local at, stop = HEADER_SIZE, message.stop
        if stop < at + 2 then return cut_off(message, view, REASONS.daisy_reply) end
        local payload = add_layers(message, view, at)
        local line = format("daisy reply layer %d to %d", byte(message.text, at + 1, at + 2))
        at = at + 2
        if not payload or stop - at < DAISY.sensor_report_size then return line end
        for _, declared in ipairs(DAISY.sensor_report) do
            -- The last part extends to the end.
            local after = declared.size and at + declared.size or stop
            if after > at then payload:add(field["daisy_" .. declared.name], bytes_between(view, at, after)) end
            at = after
        end
        return line
    end

    local function show_unknown_message(message, view)
        local code = byte(message.text, HEADER_SIZE)
        add_rest(message, view, HEADER_SIZE)
        local reason = phrases.finding("UNKNOWN_TYPE", { type = format("0x%02X", code) })
        set_fault(message, HEADER_SIZE - 1, reason, "fault")
        return format("message of unknown type 0x%02X", code)
    end

    local SHOW_COMMAND = { direct = show_direct_command, system = show_system_message, daisy = show_daisy_command }
    local SHOW_REPLY = { direct = show_direct_reply, system = show_system_message, daisy = show_daisy_reply }

    -- Tells whether a fault in the captured beginning of a frame is real: with zeros for the rest, it is the same.
    local function is_real(fault, message)
        local type = message.type
        if not type or type.carries == "daisy" then return fault.kind ~= "cut_off" end
        local whole = messages.read(message.text .. ("\0"):rep(message.size - message.stop))
        local found = whole.fault
        if type.carries == "direct" then found = operations.summary_of(sub(whole.text, HEADER_SIZE + 1)).fault end
        return found ~= nil and found.at == fault.at and found.reason == fault.reason
    end

    -- A truncated frame has no other fault at its end.
    local function check_size(message)
        local stop, size, fault = message.stop, message.size, message.fault
        if stop == size then return end
        if message.is_cut then
            if fault and is_real(fault, message) then return end
            set_fault(message, stop, format("the capture has %d of the frame's %d bytes", stop, size), "cut_by_capture")
        elseif not fault or fault.kind == "cut_off" then
            local stated = phrases.plural(size - LENGTH_FIELD, "byte") .. " follow"
            local reason = phrases.finding("CUT_FRAME", { stated = stated, follow = stop - LENGTH_FIELD })
            set_fault(message, 0, reason, "cut_off")
        end
    end

    -- `reply` is the packet of the reply, nil without one, false if that is not known yet.
    local function add_links(message, view, is_new, reply, is_given_up)
        local type, item, target, place = message.type, view.item, view.target, view.place
        if not type or message.is_overwritten then return end
        if item and dialogues.is_locked(place) then complain(target, "locked", UNLOCK.missing) end
        if type.wants_reply then
            if is_given_up then
                complain(target, "unanswered", "no reply to this command was seen")
            elseif reply == nil then
                complain(target, "waiting", "no reply to this command was seen so far")
            elseif reply and item then
                set_generated(add(item, field.response_in, reply))
            end
        elseif not type.is_command then
            local request = view.request
            if not request then
                complain(target, "orphan", "the command that this reply answers was not seen")
            elseif item then
                local seconds = floor(request.delay / 1e9)
                set_generated(add(item, field.request_in, storage.number_of(request.place)))
                set_generated(add(item, field.response_time, NSTime.new(seconds, request.delay - seconds * 1e9)))
            end
            local asked, size = request and dialogues.asked_size(message, request.body), message.size - HEADER_SIZE
            if asked and asked ~= size then
                local values = { asked = phrases.plural(asked, "byte"), size = size }
                complain(target, "other_size", phrases.filled(PAIRING.other_size, values))
            elseif request and request.is_unsure then
                complain(target, "unsure", PAIRING.unsure)
            end
        end
        local trouble = message.command and dialogues.trouble_at(place, is_new)
        if trouble then complain(target, "incomplete_file", trouble) end
        local transfer = item and dialogues.transfer_at(place)
        if transfer then
            set_generated(add(item, field.transfer_path, reading.utf8_text(transfer.path)))
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
            local reason = type.is_command and phrases.finding("NO_SYSTEM", {}) or REASONS.system_reply
            return set_fault(message, stop, reason, "cut_off")
        end
        local number = byte(text, at + 1)
        if not type.is_command then message.status = byte(text, at + 2) end
        message.command = SYSTEM_COMMANDS[number]
        if not message.command then
            message.rest = start
            local reason = phrases.finding("UNKNOWN_SYSTEM", { number = format("0x%02X", number) })
            return set_fault(message, at, reason, "fault")
        end
        local declared = type.is_command and message.command.request or message.command.reply
        -- Replies to failed commands may end before any field.
        local is_complete = type.is_command or (message.status == STATUS.success and not type.is_error)
        message.fields, message.rest, message.fault =
            reading.read_fields(text, start, stop, declared, is_complete, message.command.name)
    end

    -- Reads a frame. `text` may be shorter than its length field says.
    function messages.read(text)
        local low, high, first, second, code = byte(text, 1, HEADER_SIZE)
        local message = {
            text = text, stop = #text, size = LENGTH_FIELD + low + high * 0x100,
            counter = first + second * 0x100, type = MESSAGE_TYPES[code],
        }
        if message.type and message.type.carries == "system" then read_system_fields(message) end
        return message
    end

    -- Adds the item of a message, with its header. Its text comes later.
    local function add_frame(tree, tvb, base, message, place, brick)
        local range = new_range(tvb, base, message.stop)
        local item = add_item(tree, range, brick)
        set_generated(add(item, field.connection, dialogues.number_at(place)))
        -- A range costs more than an item: the length shares the frame's.
        set_len(add(item, field.length, range, message.size - LENGTH_FIELD), LENGTH_FIELD)
        add_le(item, field.counter, new_range(tvb, base + LENGTH_FIELD, 2))
        add(item, field.type, new_range(tvb, base + HEADER_SIZE - 1, 1))
        return item
    end

    -- Shows a message. Returns its line and, with a tree, its item. The frame is at offset `base` of the buffer; `said`
    -- replaces the message's own line; `is_new` is true in the first pass.
    function messages.show(message, place, tvb, base, tree, brick, said, is_new)
        local type, item = message.type, brick and add_frame(tree, tvb, base, message, place, brick) or nil
        local view = {
            root = tree, item = item, target = item or tree, tvb = tvb, base = base, place = place, request = nil,
        }
        local show = show_unknown_message
        if type and type.is_command then
            show = SHOW_COMMAND[type.carries]
        elseif type then
            show, view.request = SHOW_REPLY[type.carries], dialogues.request_of(place)
        end
        local line = show(message, view)
        check_size(message)
        if message.slip then set_fault(message, 0, message.slip, "fault") end
        local fault = message.fault
        if said then
            line = said
        elseif fault and fault.kind == "cut_by_capture" then
            line = line .. " [cut by the capture]"
        elseif fault then
            line = format("%s [fault at offset %d: %s]", line, fault.at, fault.reason)
        end
        -- In the first pass, the reply is still to come.
        local reply, is_given_up = false, false
        if type and type.wants_reply and not is_new then reply, is_given_up = dialogues.reply_to(place) end
        if is_given_up then line = line .. " (no reply)" end
        if item then set_text(item, "EV3: " .. line) end
        add_links(message, view, is_new, reply, is_given_up)
        if fault then complain(view.target, fault.kind, format("at offset %d: %s", fault.at, fault.reason)) end
        return line, item
    end
end

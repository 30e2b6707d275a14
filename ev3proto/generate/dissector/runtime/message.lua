-- Messages ----------------------------------------------------------------------------------------------------------
--
-- One frame, read as far as it goes. Each kind of message has one function, which reads it, returns the line that the
-- info column shows, and adds to the tree if there is one. `item` is the message's item in the tree, or nil; `part`
-- gives the bytes between two offsets in the frame, for Wireshark to highlight.

local read_message, show_message, complain, forget_lines
do
    -- Wireshark collects expert information also where it makes no tree: `item` is the root of it then, and nil where a
    -- frame is only tried.
    function complain(item, kind, text)
        if item then item:add_proto_expert_info(experts[kind], text) end
    end

    local function add_rest(item, part, at, stop)
        if item and at < stop then item:add(field.rest, part(at, stop)) end
    end

    -- Adds a value as the field of its parameter, or, where its type is another, as text.
    local function add_value(item, range, parameter, name, value)
        local kind, is_text = parameter.kind, type(value) == "string"
        local added
        if is_text ~= (kind == TEXT_VALUE) or (kind == NUMBER and value % 1 ~= 0) then
            local text = is_text and utf8_text(value) or number_text(value)
            return item:add(field.other, range, text):set_text(name .. ": " .. text)
        end
        added = item:add(parameter.field, range, is_text and utf8_text(value) or value)
        if name ~= parameter.field_name then
            -- An element of a list has its number in its name.
            local symbol = parameter.enum and not parameter.is_flags and parameter.enum.names[value]
            local text = is_text and shortened(value) or number_text(value)
            added:set_text(name .. ": " .. (symbol and format("%s (%s)", symbol, text) or text))
        elseif kind == FLOAT and parameter.unit then
            added:append_text(" " .. parameter.unit)
        end
        if parameter.special or parameter.is_flags then
            local meaning = meaning_of(parameter, value)
            if meaning then added:append_text(" (" .. meaning .. ")") end
        end
        return added
    end

    -- Where there is no tree, complaints are collected.
    local function complain_in(view, item, kind, text)
        local complaints = view.complaints
        if complaints then
            complaints[#complaints + 1] = { kind = kind, text = text }
        else
            complain(item, kind, text)
        end
    end

    -- What the brick refuses, or what lies beyond the memory that the command asks for.
    local function check_variable(added, view, parameter, encoding, index)
        local alignment = encoding.handle and SIZE_OF[HANDLE] or parameter.alignment
        if alignment and index % alignment ~= 0 then
            local reason = "%s: the index of a %s must be a multiple of %d, the brick refuses %s"
            local sort = encoding.handle and "handle" or TYPE_NAMES[parameter.type]
            local variable = variable_text(encoding, index)
            complain_in(view, added, "misaligned", format(reason, parameter.name, sort, alignment, variable))
        end
        local size = encoding.handle and SIZE_OF[HANDLE] or encoding.address and SIZE_OF[DATA32] or parameter.size or 1
        if parameter.length and parameter.is_output and not encoding.handle then
            size = size * stated_length(parameter, view.lengths, 1)
        end
        local asked = encoding.kind == GLOBAL and view.globals or view.locals
        -- Without a tree one such variable stands for all: there is nothing to point at.
        if asked and index + size > asked and not view.is_told then
            view.is_told = view.complaints ~= nil
            local reason = "%s reaches up to byte %d of the %s memory, of which the command asks for %s"
            local scope = encoding.kind == GLOBAL and "global" or "local"
            reason = format(reason, parameter.name, index + size, scope, plural(asked, "byte"))
            complain_in(view, added, "beyond_memory", reason)
        end
    end

    local function add_argument(view, parameter, encoding, value, at, stop)
        local item, tvb, name, base = view.item, view.tvb, parameter.name, view.base + at
        local range = tvb(base, stop - at)
        local added
        if encoding.scope then
            local text = variable_text(encoding, value)
            added = item:add(field.variable, range, text):set_text(name .. ": " .. text)
            check_variable(added, view, parameter, encoding, value)
        else
            added = add_value(item, range, parameter, name, value)
            if tells_length(parameter, encoding) then view.lengths[name] = value end
        end
        added:add(field.encoding, stop == at + 1 and range or tvb(base, 1), encoding.label)
        add_phrase(view, parameter, encoding, value)
    end

    -- The operations between two offsets in the tree. Returns the line on the first one, how many there are, the offset
    -- behind what could be read, and the fault where there is one.
    local function add_operations(item, part, message, at, stop, globals, locals)
        local text = message.text
        local line, count = nil, 0
        local view = { tvb = message.tvb, base = message.base, globals = globals, locals = locals, lengths = {} }
        while at < stop do
            local code = byte(text, at + 1)
            -- The opcode is the heading of its operation: it stands for all the bytes of it.
            local heading = item:add(field.opcode, part(at, at + 1), code)
            local operation, offset, reason, kind = select_operation(text, at, stop)
            if not operation then return line, count, at, { at = offset, reason = reason, kind = kind } end
            if operation.cmd_name then
                local cmd = heading:add(field.cmd, part(at + 1, offset), operation.name)
                if offset > at + 2 then
                    cmd:add(field.encoding, part(at + 1, at + 2), ENCODINGS[byte(text, at + 2)].label)
                end
            end
            view.item, view.count, view[1] = heading, 1, operation.heading
            if next(view.lengths) then view.lengths = {} end
            local _, behind
            _, behind, offset, reason, kind = read_operation(text, at, stop, add_argument, view)
            heading:set_text(concat(view, "", 1, view.count)):set_len(behind - at)
            if not line then
                view[1] = operation.title
                line = concat(view, "", 1, view.count)
            end
            count = count + 1
            if reason then return line, count, behind, { at = offset, reason = reason, kind = kind } end
            at = behind
        end
        return line, count, at
    end

    local function say_argument(view, parameter, encoding, value)
        if encoding.scope then
            check_variable(nil, view, parameter, encoding, value)
        elseif tells_length(parameter, encoding) then
            view.lengths[parameter.name] = value
        end
        if view.is_first then add_phrase(view, parameter, encoding, value) end
    end

    -- The same without a tree: all that one line says is the first operation with its arguments, and how many follow.
    local function say_operations(text, at, stop, globals, locals)
        local line, count = nil, 0
        local view = { "", count = 1, complaints = {}, globals = globals, locals = locals, lengths = {} }
        view.is_first = true
        while at < stop do
            local operation, behind, offset, reason, kind = read_operation(text, at, stop, say_argument, view)
            if operation then
                if not line then
                    view[1] = operation.title
                    line = concat(view, "", 1, view.count)
                    view.is_first = false
                end
                if next(view.lengths) then view.lengths = {} end
                count = count + 1
            end
            if reason then
                return line, count, { at = offset, reason = reason, kind = kind }, view.complaints
            end
            at = behind
        end
        return line, count, nil, view.complaints
    end

    local function operations_line(line, count)
        return count > 1 and line .. " (+" .. plural(count - 1, "operation") .. ")" or line
    end

    -- What was said of commands, by all that follows their headers: a dialogue says the same again and again. It is
    -- just the line where there is nothing to complain about.
    local MOST_REMEMBERED = 4096
    local remembered, count_remembered = {}, 0

    function forget_lines()
        remembered, count_remembered = {}, 0
    end

    -- The line on a direct command without a tree; its fault and complaints go to the message.
    local function say_command(message, globals, locals)
        local text = message.text
        local body = sub(text, HEADER_SIZE + 1)
        local known = remembered[body]
        if not known then
            local line, count, fault, complaints = say_operations(text, COMMAND_HEADER_SIZE, #text, globals, locals)
            known = line and operations_line(line, count) or not fault and "no operations" or nil
            if fault or complaints[1] then known = { line = known, fault = fault, complaints = complaints } end
            if count_remembered >= MOST_REMEMBERED then forget_lines() end
            remembered[body], count_remembered = known, count_remembered + 1
        end
        if type(known) == "string" then return known end
        message.fault = known.fault
        for _, complaint in ipairs(known.complaints) do
            complain(message.target, complaint.kind, complaint.text)
        end
        return known.line or message.type.name
    end

    local function direct_command(message, _, item, part)
        local text, at, stop = message.text, HEADER_SIZE, message.stop
        if stop < COMMAND_HEADER_SIZE then
            local reason = "a direct command starts with two bytes that ask for memory"
            message.fault = { at = stop, reason = reason, kind = "cut_off" }
            add_rest(item, part, at, stop)
            return message.type.name
        end
        local sizes = unsigned16(text, at)
        local globals, locals = sizes % (GLOBAL_MASK + 1), floor(sizes / (GLOBAL_MASK + 1))
        if not item then return say_command(message, globals, locals) end
        local line, count, behind
        local range = part(at, at + 2)
        local memory = item:add(field.memory_sizes, range, sizes)
        memory:add_le(field.globals, range)
        memory:add_le(field.locals, range)
        line, count, behind, message.fault =
            add_operations(item, part, message, COMMAND_HEADER_SIZE, stop, globals, locals)
        if message.fault then add_rest(item, part, behind, stop) end
        return line and operations_line(line, count) or message.fault and message.type.name or "no operations"
    end

    local function add_output(item, part, output)
        local parameter = output.parameter
        local name = parameter.name
        local range = part(output.at, output.at + output.size)
        if not output.list then
            local added = add_value(item, range, parameter, name, output.value)
            if output.is_handle then added:set_text(name .. ": handle " .. output.value) end
            return
        end
        local list = item:add(field.list, range):set_text(name .. ": " .. output_text(output))
        local step = output.size / #output.list
        for index, value in ipairs(output.list) do
            local at = output.at + (index - 1) * step
            add_value(list, part(at, at + step), parameter, format("%s[%d]", name, index - 1), value)
        end
    end

    local function direct_reply(message, place, item, part)
        local request, stop = request_of(place), message.stop
        if item and stop > HEADER_SIZE then item:add(field.memory, part(HEADER_SIZE, stop)) end
        if message.type.is_error then
            complain(message.target, "error_reply", "the brick refused or failed the command; it tells no more")
            local operation = request and #request > COMMAND_HEADER_SIZE
                and read_operation(request, COMMAND_HEADER_SIZE, #request)
            return operation and "error reply to " .. operation.title or "error reply"
        end
        local size = plural(stop - HEADER_SIZE, "byte")
        if not request then return "reply: " .. size .. ", command not seen" end
        local found, first = reply_values(request, message)
        for _, group in ipairs(item and found or {}) do
            local start, behind = stop, HEADER_SIZE
            for _, output in ipairs(group.values) do
                start, behind = math.min(start, output.at), math.max(behind, output.at + output.size)
            end
            local range = part(start, behind)
            local added = item:add(field.answers, range, group.operation.name):set_text(group.operation.title)
            for _, output in ipairs(group.values) do
                add_output(added, part, output)
            end
        end
        local head = first and "reply to " .. first.title .. ": " or "reply: "
        if found[1] then return head .. values_text(found) end
        return head .. (stop == HEADER_SIZE and "ok" or size)
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

    local function add_fields(item, part, message)
        for _, found in ipairs(message.fields) do
            local range, value, kind = part(found.at, found.stop), found.value, found.declared.kind
            if kind == BYTES then
                item:add(found.declared.field, range)
            else
                item:add(found.declared.field, range, type(value) == "string" and utf8_text(value) or value)
            end
        end
        add_rest(item, part, message.rest, message.stop)
    end

    -- Commands and replies. Their fields were read with the frame, as the notes on files need them.
    local function system_message(message, place, item, part)
        local at, stop, command, status = HEADER_SIZE, message.stop, message.command, message.status
        local number = at < stop and byte(message.text, at + 1)
        local status_name = status and (STATUS_NAMES[status] or format("status %d", status))
        if item then
            if number then
                local added = item:add(field.system_command, part(at, at + 1), number)
                if command then added:append_text(": " .. command.text) end
            end
            if status then
                item:add(field.status, part(at + 1, at + 2), status)
            end
            add_fields(item, part, message)
        end
        if status and (STATUS_FAILS[status] ~= false or message.type.is_error) then
            complain(message.target, "failed", "the command failed: " .. status_name)
        end
        if not command then return number and format("system command 0x%02X", number) or message.type.name end
        local line = command.name .. subject_text(message, place)
        if message.type.is_command then return line end
        return "reply: " .. (status ~= SUCCESS and line .. " " .. status_name or line)
    end

    local function daisy_command(message, _, item, part)
        local text, stop, at = message.text, message.stop, HEADER_SIZE
        if stop < at + 3 then
            local reason = "a daisy command starts with a sub-command and two layers"
            message.fault = { at = stop, reason = reason, kind = "cut_off" }
            add_rest(item, part, at, stop)
            return message.type.name
        end
        local number, from, to = byte(text, at + 1, at + 3)
        local name = DAISY_NAMES[number]
        if not name then
            message.fault = { at = at, reason = format("0x%02X is no daisy sub-command", number), kind = "fault" }
        end
        local payload = at + 3
        local added
        if item then
            item:add(field.daisy_command, part(at, at + 1), number)
            item:add(field.layer_from, part(at + 1, at + 2), from)
            item:add(field.layer_to, part(at + 2, payload), to)
            if payload < stop then added = item:add(field.daisy_payload, part(payload, stop)) end
        end
        local line = format("daisy %s layer %d to %d", name or format("0x%02X", number), from, to)
        -- The payload's layout is not certain: operations are shown only where all of it reads as such.
        local is_code = payload < stop and DAISY_CARRIES_OPERATIONS[number]
        if is_code and not select(2, count_operations(text, payload, stop)) then
            local said, count = say_operations(text, payload, stop)
            if added then add_operations(added, part, message, payload, stop) end
            line = line .. ": " .. operations_line(said, count)
        end
        return line
    end

    local function daisy_reply(message, _, item, part)
        local text, stop, at = message.text, message.stop, HEADER_SIZE
        if stop < at + 2 then
            message.fault = { at = stop, reason = "a daisy reply starts with two layers", kind = "cut_off" }
            add_rest(item, part, at, stop)
            return message.type.name
        end
        local from, to = byte(text, at + 1, at + 2)
        local payload = at + 2
        if item then
            item:add(field.layer_from, part(at, at + 1), from)
            item:add(field.layer_to, part(at + 1, payload), to)
            local added = payload < stop and item:add(field.daisy_payload, part(payload, stop))
            at = payload
            for _, declared in ipairs(stop - payload >= SENSOR_REPORT_SIZE and SENSOR_REPORT or {}) do
                -- The last part takes what is left.
                local behind = declared.size and at + declared.size or stop
                if behind > at then added:add(report_field[declared.name], part(at, behind)) end
                at = behind
            end
        end
        return format("daisy reply layer %d to %d", from, to)
    end

    local function unknown_message(message, _, item, part)
        local code = byte(message.text, HEADER_SIZE)
        message.fault = { at = HEADER_SIZE - 1, reason = format("0x%02X is no message type", code), kind = "fault" }
        add_rest(item, part, HEADER_SIZE, message.stop)
        return format("message of unknown type 0x%02X", code)
    end

    local COMMANDS = { direct = direct_command, system = system_message, daisy = daisy_command }
    local REPLIES = { direct = direct_reply, system = system_message, daisy = daisy_reply }

    local function shower_of(type)
        if not type then return unknown_message end
        return (type.is_command and COMMANDS or REPLIES)[type.carries]
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

    local function add_links(item, message, place, pinfo)
        local type = message.type
        if not type or message.is_overwritten then return end
        if type.is_command then
            local is_waiting, reply = reply_to(place)
            if is_waiting and not reply and pinfo.visited then
                complain(message.target, "unanswered", "no reply to this command was seen")
            elseif reply and item then
                item:add(field.response_in, reply):set_generated()
            end
        else
            local request, number, delay = request_of(place)
            if not request then
                complain(message.target, "orphan", "the command that this reply answers was not seen")
            elseif item then
                item:add(field.request_in, number):set_generated()
                local seconds = floor(delay)
                local time = NSTime.new(seconds, floor((delay - seconds) * 1e9 + 0.5))
                item:add(field.response_time, time):set_generated()
            end
        end
        local transfer = item and transfer_at(place)
        if transfer then
            item:add(field.transfer_path, utf8_text(transfer.path)):set_generated()
            item:add(field.transfer_done, transfer.done):set_generated()
            if transfer.size then item:add(field.transfer_size, transfer.size):set_generated() end
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
        local is_complete = type.is_command or (message.status == SUCCESS and not type.is_error)
        message.fields, message.rest, message.fault = read_fields(text, start, stop, declared, is_complete)
    end

    -- The message in a frame. `text` is all there is of it, which may be less than its length field says.
    function read_message(text)
        local message = {
            text = text, stop = #text,
            size = LENGTH_FIELD + unsigned16(text, 0),
            counter = unsigned16(text, LENGTH_FIELD),
            type = MESSAGE_TYPES[byte(text, HEADER_SIZE)],
        }
        if message.type and message.type.carries == "system" then read_system_fields(message) end
        return message
    end

    -- The line on a message at a place. With a tree that anybody looks at, its item there too; `said` is said of the
    -- message instead of what it says. Without `tree` a frame is only tried.
    function show_message(message, place, tvb, at, pinfo, tree, is_shown, said)
        local show = shower_of(message.type)
        local item, part, line
        if is_shown then
            function part(start, stop)
                return tvb(at + start, stop - start)
            end
            message.tvb, message.base = tvb, at
            item = add_item(tree, part(0, message.stop))
            item:add(field.length, part(0, 2), message.size - LENGTH_FIELD)
            item:add(field.counter, part(2, 4), message.counter)
            item:add(field.type, part(4, 5), byte(message.text, HEADER_SIZE))
        end
        message.target = item or tree
        line = show(message, place, item, part)
        check_size(message)
        local fault = message.fault
        line = said or fault and format("%s [fault at offset %d: %s]", line, fault.at, fault.reason) or line
        if item then item:set_text("EV3: " .. line) end
        if tree then add_links(item, message, place, pinfo) end
        if fault then complain(message.target, fault.kind, format("at offset %d: %s", fault.at, fault.reason)) end
        return line, item
    end
end

-- Operations --------------------------------------------------------------------------------------------------------
--
-- What a direct command says, or the payload of a daisy command: the line on it, what is wrong with it, and its items
-- in the tree.

local value_of_row, say_operations, show_operations
do
    local note_output, note_lengths = layout_notes.note_output, layout_notes.note_lengths
    local add, set_len, append_text = TreeItem.add, TreeItem.set_len, TreeItem.append_text
    local new_range = Tvb.range
    local VARIABLE, OPCODE, CMD, ENCODING = field.variable, field.opcode, field.cmd, field.encoding

    -- The field of a parameter, the value for it, and what is shown where that is not what the field shows by itself:
    -- instead of it, or after it. A value that has not the type of its parameter is text. Of an element of a list its
    -- name is given, with its number.
    function value_of_row(parameter, declared, value, numbered)
        local kind, is_text = parameter.kind, type(value) == "string"
        if is_text ~= (kind == TEXT_VALUE) or (kind == NUMBER and value % 1 ~= 0) then
            local text = is_text and utf8_text(value) or number_text(value)
            return field.other, text, (numbered or parameter.name) .. ": " .. text, false
        end
        local label, addition = false, false
        if numbered then
            local symbol = parameter.enum and not parameter.is_flags and parameter.enum.names[value]
            local text = is_text and shortened(value) or number_text(value)
            label = numbered .. ": " .. (symbol and format("%s (%s)", symbol, text) or text)
        elseif kind == FLOAT and parameter.unit then
            addition = parameter.unit
        end
        if parameter.special or parameter.is_flags then
            local meaning = meaning_of(parameter, value)
            if meaning then addition = addition and addition .. " " .. meaning or meaning end
        end
        return declared, is_text and utf8_text(value) or value, label, addition
    end

    -- With what is wrong already, one more: its kind and its text. A list is written at once, as one that grows is laid
    -- out anew, and most have no more.
    local function with_complaint(complaints, kind, text)
        if not complaints then return { kind, text } end
        local count = #complaints
        complaints[count + 1], complaints[count + 2] = kind, text
        return complaints
    end

    -- How much memory a command asks for, as a complaint ends.
    local function asked_texts(scope)
        return made_late(function(asked)
            return format(" of the %s memory, of which the command asks for %s", scope, plural(asked, "byte"))
        end)
    end

    local BEYOND_GLOBAL, BEYOND_LOCAL = asked_texts("global"), asked_texts("local")

    -- What the brick refuses, or what lies beyond the memory that the command asks for: kinds and texts in turn, after
    -- those that are in `complaints`, where there are any.
    local function variable_complaints(complaints, view, parameter, encoding, index)
        local is_handle = encoding.handle
        local alignment = is_handle and SIZE_OF[HANDLE] or parameter.alignment or parameter.size
        if index % alignment ~= 0 then
            local reason = "%s: the index of a %s must be a multiple of %d, the brick refuses %s"
            local sort = is_handle and "handle" or TYPE_NAMES[parameter.type]
            local text = encoding.texts[index]
            complaints =
                with_complaint(complaints, "misaligned", format(reason, parameter.name, sort, alignment, text))
        end
        local is_global = encoding.kind == GLOBAL
        local asked = is_global and view.globals or view.locals
        -- Without a tree one such variable stands for all: there is nothing to point at.
        if not asked or view.is_beyond then return complaints end
        local size = is_handle and SIZE_OF[HANDLE] or encoding.address and SIZE_OF[DATA32] or parameter.size
        if parameter.is_long and not is_handle then
            size = size * stated_length(parameter, view.lengths, 1)
        end
        if index + size > asked then
            view.is_beyond = view.is_line
            complaints = with_complaint(complaints, "beyond_memory", parameter.name .. " reaches up to byte "
                .. number_text(index + size) .. (is_global and BEYOND_GLOBAL or BEYOND_LOCAL)[asked])
        end
        return complaints
    end

    -- Nearly all variables are as they should be.
    local function check_variable(view, parameter, encoding, index, declared)
        local is_global = encoding.kind == GLOBAL
        local asked = is_global and view.globals or view.locals
        local size = parameter.size
        if parameter.is_long or asked and index + size > asked or index % (parameter.alignment or size) ~= 0
            or encoding.is_special then
            view.complaints = variable_complaints(view.complaints, view, parameter, encoding, index)
        end
        if is_global and parameter.is_output then note_output(view, parameter, encoding, index, declared) end
    end

    -- What is said of an operation, piece by piece: SOUND TONE volume=1 frequency=440. Two pieces are what it is, the
    -- others the names and values of its arguments. Joined at once, they leave no texts behind that are half of it.
    local pieces, piece_count = {}, 2
    local MOST_PIECES = 2 + 2 * MOST_VALUES

    local function say_phrase(parameter, encoding, value)
        local key, count = parameter.key, piece_count
        if not key or count > MOST_PIECES then return end
        if count < MOST_PIECES then
            pieces[count + 1] = key
            -- Most are short numbers and variables, whose text is made already.
            pieces[count + 2] = not parameter.enum and encoding.is_short and encoding.texts[value]
                or argument_text(parameter, encoding, value)
            piece_count = count + 2
        else
            pieces[count + 1] = " ..."
            piece_count = count + 1
        end
    end

    local function complain_all(item, complaints)
        for index = 1, #complaints, 2 do
            complain(item, complaints[index], complaints[index + 1])
        end
    end

    -- What the items of an operation are added to. There are very many arguments, and each reads these faster here than
    -- in a table.
    local NO_LENGTHS = {}
    local shown = {}
    local heading, buffer, base

    local function show_argument(view, parameter, encoding, value, declared, at, stop)
        local range, size, added = new_range(buffer, base + at, 1), stop - at, nil
        if encoding.scope then
            local own = encoding.texts[value]
            added = add(heading, VARIABLE, range, own, parameter.label_head .. " " .. own)
            check_variable(view, parameter, encoding, value, declared)
            if view.complaints then
                complain_all(added, view.complaints)
                view.complaints = nil
            end
        elseif encoding.is_number and parameter.is_plain then
            added = add(heading, declared, range, value)
        else
            local own_field, own, label, addition = value_of_row(parameter, declared, value, parameter.numbered)
            if label and addition then label, addition = label .. " " .. addition, false end
            added = add(heading, own_field, range, own, label, addition)
        end
        if size > 1 then set_len(added, size) end
        add(added, ENCODING, range, encoding.label)
        if parameter.key then say_phrase(parameter, encoding, value) end
        if parameter.tells_length and tells_length(parameter, encoding) then
            if view.lengths == NO_LENGTHS then view.lengths = {} end
            view.lengths[parameter.name] = value
        end
    end

    -- How many operations follow the first one. Each text is written but once.
    local further = made_late(function(count)
        return count == 1 and "" or " (+" .. plural(count - 1, "operation") .. ")"
    end)

    -- Adds the operations between two offsets of a frame as they are read; the frame starts at an offset in the buffer.
    -- What a reply will hold is noted. Returns the line, empty where there is no operation; the offset after what could
    -- be read; the fault, where there is one.
    function show_operations(item, tvb, start, text, at, stop, globals, locals)
        local first, said, count, fault = nil, "", 0, nil
        buffer, base, shown.globals, shown.locals, shown.lengths = tvb, start, globals, locals, NO_LENGTHS
        layout_notes.start()
        while at < stop and not fault do
            -- The opcode is the heading of its operation: it stands for all the bytes of it.
            heading = add(item, OPCODE, new_range(tvb, start + at, 1))
            local operation, after, reason, kind = select_operation(text, at, stop)
            if not operation then
                fault = { at = after, reason = reason, kind = kind }
                break
            end
            local name = operation.cmd_name
            if name then
                local size = after - at - 1
                local encoding = size > 1 and ENCODINGS[byte(text, at + 2)].label
                local range, own = new_range(tvb, start + at + 1, 1), operation.name
                local added = add(heading, CMD, range, own)
                if size > 1 then
                    set_len(added, size)
                    add(added, ENCODING, range, encoding)
                end
            end
            pieces[1], pieces[2], piece_count = name and " " or "", name or "", 2
            shown.offset, shown.operation = at, operation
            local read, offset = operation.is_simple and skim_arguments or read_arguments, nil
            after, offset, reason, kind = read(operation, text, after, stop, show_argument, shown)
            if after > at + 1 then set_len(heading, after - at) end
            if name or piece_count > 2 then append_text(heading, concat(pieces, "", 1, piece_count)) end
            if not first then
                first, said = operation, concat(pieces, "", 3, piece_count)
                layout_notes.note_first(operation)
            end
            if shown.lengths ~= NO_LENGTHS then
                note_lengths(at, shown.lengths)
                shown.lengths = NO_LENGTHS
            end
            count, at = count + 1, after
            if reason then fault = { at = offset, reason = reason, kind = kind } end
        end
        local line = first and first.title .. said .. further[count] or ""
        return line, at, fault
    end

    -- Without a tree: what is wrong with any argument, and what a reply will hold.
    local function check_argument(view, parameter, encoding, value, declared)
        if encoding.scope then
            check_variable(view, parameter, encoding, value, declared)
        elseif parameter.tells_length and tells_length(parameter, encoding) then
            view.lengths[parameter.name] = value
        end
    end

    local function say_variable(view, parameter, encoding, value, declared)
        if encoding.scope then check_variable(view, parameter, encoding, value, declared) end
        say_phrase(parameter, encoding, value)
    end

    local function say_argument(view, parameter, encoding, value, declared)
        check_argument(view, parameter, encoding, value, declared)
        say_phrase(parameter, encoding, value)
    end

    -- One serves all, as they come one after the other.
    local view = { is_line = true, lengths = {} }

    -- The same without a tree: all that one line says is the first operation with its arguments, and how many follow.
    -- What a reply will hold is noted. Returns the line, empty where there is no operation; the fault; the complaints.
    function say_operations(text, at, stop, globals, locals)
        local first, count, lengths, fault = nil, 0, view.lengths, nil
        view.globals, view.locals, view.complaints, view.is_beyond, piece_count = globals, locals, nil, false, 2
        layout_notes.start()
        while at < stop do
            local operation, after, offset, reason, kind = select_operation(text, at, stop)
            if not operation then
                fault = { at = after, reason = offset, kind = reason }
                break
            end
            view.offset, view.operation = at, operation
            local is_further = first ~= nil
            first = first or operation
            if operation.is_simple then
                after, offset, reason, kind = skim_arguments(operation, text, after, stop,
                    is_further and check_variable or say_variable, view, is_further)
            else
                after, offset, reason, kind = read_arguments(operation, text, after, stop,
                    is_further and check_argument or say_argument, view, is_further)
                if next(lengths) then
                    note_lengths(at, lengths)
                    lengths = {}
                    view.lengths = lengths
                end
            end
            count = count + 1
            if reason then
                fault = { at = offset, reason = reason, kind = kind }
                break
            end
            at = after
        end
        local line = ""
        if first then
            layout_notes.note_first(first)
            pieces[1], pieces[2], pieces[piece_count + 1] = first.title, "", further[count]
            line = concat(pieces, "", 1, piece_count + 1)
        end
        return line, fault, view.complaints
    end
end

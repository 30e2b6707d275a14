-- Operations --------------------------------------------------------------------------------------------------------
--
-- What a direct command says, or the payload of a daisy command: the line on it, what is wrong with it, and its items
-- in the tree.

local value_of_row, say_operations, read_rows, add_rows
do
    local note_output, note_operation = layout_notes.note_output, layout_notes.note_operation
    local add = TreeItem.add

    -- The field of a parameter, the value for it, and what is shown where that is not what the field shows by itself:
    -- instead of it, or after it. A value that has not the type of its parameter is text.
    function value_of_row(parameter, name, value)
        local kind, is_text = parameter.kind, type(value) == "string"
        if is_text ~= (kind == TEXT_VALUE) or (kind == NUMBER and value % 1 ~= 0) then
            local text = is_text and utf8_text(value) or number_text(value)
            return field.other, text, name .. ": " .. text, false
        end
        local label, addition = false, false
        if name ~= parameter.field_name then
            -- An element of a list has its number in its name.
            local symbol = parameter.enum and not parameter.is_flags and parameter.enum.names[value]
            local text = is_text and shortened(value) or number_text(value)
            label = name .. ": " .. (symbol and format("%s (%s)", symbol, text) or text)
        elseif kind == FLOAT and parameter.unit then
            addition = parameter.unit
        end
        if parameter.special or parameter.is_flags then
            local meaning = meaning_of(parameter, value)
            if meaning then addition = (addition and addition .. " (" or "(") .. meaning .. ")" end
        end
        return parameter.field, is_text and utf8_text(value) or value, label, addition
    end

    -- With what is wrong already, one more: its kind and its text. A list is written at once, as one that grows is laid
    -- out anew, and most have no more.
    local function with_complaint(complaints, kind, text)
        if not complaints then return { kind, text } end
        local count = #complaints
        complaints[count + 1], complaints[count + 2] = kind, text
        return complaints
    end

    -- What the brick refuses, or what lies beyond the memory that the command asks for: kinds and texts in turn, after
    -- those that are in `complaints`, where there are any.
    local function variable_complaints(complaints, view, parameter, encoding, index)
        local is_handle = encoding.handle
        local alignment = is_handle and SIZE_OF[HANDLE] or parameter.alignment
        if alignment and index % alignment ~= 0 then
            local reason = "%s: the index of a %s must be a multiple of %d, the brick refuses %s"
            local sort = is_handle and "handle" or TYPE_NAMES[parameter.type]
            local text = variable_text(encoding, index)
            complaints =
                with_complaint(complaints, "misaligned", format(reason, parameter.name, sort, alignment, text))
        end
        local is_global = encoding.kind == GLOBAL
        local asked = is_global and view.globals or view.locals
        -- Without a tree one such variable stands for all: there is nothing to point at.
        if not asked or view.is_beyond then return complaints end
        local size = is_handle and SIZE_OF[HANDLE] or encoding.address and SIZE_OF[DATA32] or parameter.size or 1
        if parameter.length and parameter.is_output and not is_handle then
            size = size * stated_length(parameter, view.lengths, 1)
        end
        if index + size > asked then
            view.is_beyond = view.complaints ~= nil
            local reason = "%s reaches up to byte %d of the %s memory, of which the command asks for %s"
            local scope = is_global and "global" or "local"
            reason = format(reason, parameter.name, index + size, scope, plural(asked, "byte"))
            complaints = with_complaint(complaints, "beyond_memory", reason)
        end
        return complaints
    end

    -- A row is an item of the tree: field, offset, size, value, label, addition, how it is encoded (true for the
    -- heading of an operation, of which the rows after it are the children). All rows are one list, so that they cost
    -- no table each. What is wrong with one is in `wrong` by its index, where anything is.
    local ROW = 7

    -- The phrase on the operation that is being read.
    local phrase = { count = 1 }
    local NO_LENGTHS = {}
    local VARIABLE = field.variable

    local function add_argument(rows, parameter, encoding, value, at, stop)
        local count = rows.count
        rows.count = count + ROW
        rows[count + 2], rows[count + 3], rows[count + 7] = at, stop - at, encoding.label
        if encoding.scope then
            note_output(rows.offset, parameter, encoding, value)
            local text = encoding.text or variable_text(encoding, value)
            rows[count + 1], rows[count + 4] = VARIABLE, text
            rows[count + 5], rows[count + 6] = (parameter.label or parameter.name) .. ": " .. text, false
            local complaints = variable_complaints(nil, rows, parameter, encoding, value)
            if complaints then
                if rows.wrong then
                    rows.wrong[count + 1] = complaints
                else
                    rows.wrong = { [count + 1] = complaints }
                end
            end
        else
            if parameter.is_plain and encoding.kind == CONSTANT then
                rows[count + 1], rows[count + 4], rows[count + 5], rows[count + 6] =
                    parameter.field, value, false, false
            else
                rows[count + 1], rows[count + 4], rows[count + 5], rows[count + 6] =
                    value_of_row(parameter, parameter.name, value)
            end
            if parameter.tells_length and tells_length(parameter, encoding) then
                if rows.lengths == NO_LENGTHS then
                    rows.lengths = { [parameter.name] = value }
                else
                    rows.lengths[parameter.name] = value
                end
            end
        end
        add_phrase(phrase, parameter, encoding, value)
    end

    -- The rows of the operations between two offsets, put into `rows`, with the line on the first operation, how many
    -- there are, the offset after what could be read, and the fault where there is one. What a reply will hold is
    -- noted.
    function read_rows(rows, text, at, stop, globals, locals)
        rows.count, rows.globals, rows.locals, rows.wrong = 0, globals, locals, nil
        rows.lengths, rows.line, rows.operations, rows.fault = NO_LENGTHS, nil, 0, nil
        layout_notes.start()
        while at < stop do
            -- The opcode is the heading of its operation: it stands for all the bytes of it.
            local code, heading = byte(text, at + 1), rows.count
            rows.count = heading + ROW
            rows[heading + 1], rows[heading + 2], rows[heading + 3], rows[heading + 4] = field.opcode, at, 1, code
            rows[heading + 5], rows[heading + 6], rows[heading + 7] = false, false, true
            local operation, offset, reason, kind = select_operation(text, at, stop)
            if not operation then
                rows.fault = { at = offset, reason = reason, kind = kind }
                break
            end
            if operation.cmd_name then
                local cmd = rows.count
                rows.count = cmd + ROW
                rows[cmd + 1], rows[cmd + 2], rows[cmd + 3] = field.cmd, at + 1, offset - at - 1
                rows[cmd + 4], rows[cmd + 5], rows[cmd + 6] = operation.name, false, false
                rows[cmd + 7] = offset > at + 2 and ENCODINGS[byte(text, at + 2)].label
            end
            phrase.count, phrase[1] = 1, operation.addition
            rows.offset = at
            local _, after
            _, after, offset, reason, kind = read_operation(text, at, stop, add_argument, rows)
            -- Wireshark puts a space between the field's own text and what is added to it.
            local addition = sub(concat(phrase, "", 1, phrase.count), 2)
            rows[heading + 3], rows[heading + 6] = after - at, addition ~= "" and addition
            if not rows.line then
                phrase[1] = operation.title
                rows.line = concat(phrase, "", 1, phrase.count)
            end
            local lengths = rows.lengths
            note_operation(at, operation, lengths ~= NO_LENGTHS and lengths)
            rows.lengths = NO_LENGTHS
            rows.operations = rows.operations + 1
            at = after
            if reason then
                rows.fault = { at = offset, reason = reason, kind = kind }
                break
            end
        end
        rows.after = at
    end

    -- Adds rows to the tree. `base` is the offset of the frame in the buffer.
    function add_rows(item, tvb, base, rows)
        local encoding_field, wrong, heading = field.encoding, rows.wrong, item
        for at = 1, rows.count, ROW do
            local start, size, encoding = base + rows[at + 1], rows[at + 2], rows[at + 6]
            local range = tvb(start, size)
            if encoding == true then
                heading = add(item, rows[at], range, rows[at + 3], rows[at + 4], rows[at + 5])
            else
                local added = add(heading, rows[at], range, rows[at + 3], rows[at + 4], rows[at + 5])
                local complaints = wrong and wrong[at]
                if complaints then
                    for index = 1, #complaints, 2 do
                        complain(added, complaints[index], complaints[index + 1])
                    end
                end
                if encoding then add(added, encoding_field, size == 1 and range or tvb(start, 1), encoding) end
            end
        end
    end

    local function say_argument(view, parameter, encoding, value)
        if encoding.scope then
            variable_complaints(view.complaints, view, parameter, encoding, value)
            note_output(view.offset, parameter, encoding, value)
        elseif parameter.tells_length and tells_length(parameter, encoding) then
            view.lengths[parameter.name] = value
        end
        if view.is_first then add_phrase(view.pieces, parameter, encoding, value) end
    end

    -- One serves all, as they come one after the other.
    local view = { complaints = {}, pieces = { count = 1 }, lengths = {} }

    -- The same without a tree: all that one line says is the first operation with its arguments, and how many follow.
    -- What a reply will hold is noted. Returns the line on the first one, how many there are, the fault, and the
    -- complaints.
    function say_operations(text, at, stop, globals, locals)
        local line, count, pieces, fault = nil, 0, view.pieces, nil
        view.globals, view.locals, view.is_beyond, view.is_first, pieces.count = globals, locals, false, true, 1
        layout_notes.start()
        while at < stop do
            view.offset = at
            local operation, after, offset, reason, kind =
                read_operation(text, at, stop, say_argument, view, line ~= nil)
            if operation then
                if not line then
                    pieces[1] = operation.title
                    line = concat(pieces, "", 1, pieces.count)
                    view.is_first = false
                end
                local has_lengths = next(view.lengths) ~= nil
                note_operation(at, operation, has_lengths and view.lengths)
                if has_lengths then view.lengths = {} end
                count = count + 1
            end
            if reason then
                fault = { at = offset, reason = reason, kind = kind }
                break
            end
            at = after
        end
        local complaints = view.complaints
        if not complaints[1] then return line, count, fault, nil end
        view.complaints = {}
        return line, count, fault, complaints
    end
end

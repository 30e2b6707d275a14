-- Statistics --------------------------------------------------------------------------------------------------------
--
-- What was said in a capture, by operation and by brick, and the files that were moved. Wireshark shows it in windows,
-- tshark prints it at the end of a run where the preference says so.

local counts_all
local statistics = {}
do
    -- Whether anybody may ask for them: whoever has a window, and tshark where the preferences say so.
    counts_all = gui_enabled()

    -- Rows, files and bytes that are kept at most: names in a capture may be of anybody's making.
    local MOST_ROWS, MOST_FILES, MOST_BYTES = 1000, 256, 64 * 1024 * 1024
    -- Bytes of the name of a file that is written, and of its extension: file systems take 143, and a number may be
    -- added.
    local MOST_NAME, MOST_EXTENSION = 100, 25
    -- Characters to which a column is widened for a long name.
    local MOST_WIDTH = 60

    -- By name: how many messages, bytes of them, answers, and the seconds until these.
    local operations, bricks
    local row_counts, files, kept_bytes, omitted
    local wanted, answered

    function statistics.forget()
        operations, bricks, row_counts = {}, {}, { 0, 0 }
        files, kept_bytes, omitted = {}, 0, 0
        wanted, answered = 0, 0
    end
    statistics.forget()

    local function row_of(rows, kind, name)
        local row = rows[name]
        if row then return row end
        if row_counts[kind] >= MOST_ROWS then
            name = "(others)"
            if rows[name] then return rows[name] end
        end
        row_counts[kind] = row_counts[kind] + 1
        row = { uses = 0, messages = 0, bytes = 0, answers = 0, total = 0, most = 0, wanted = 0 }
        rows[name] = row
        return row
    end

    local function count(row, message)
        row.messages, row.bytes = row.messages + 1, row.bytes + message.stop
        if message.type.wants_reply then row.wanted = row.wanted + 1 end
    end

    -- Adds the operations from an offset on to `uses`, by name. Returns whether all of them can be read.
    local function add_uses(uses, body, at)
        while at < #body do
            local operation, after, _, reason = read_operation(body, at)
            if operation then uses[operation.name] = (uses[operation.name] or 0) + 1 end
            if reason then return false end
            at = after
        end
        return true
    end

    -- What a command is counted as, and how often each: all its operations, or the system or daisy command that it is.
    -- `body` is what follows its header.
    local function uses_of(message, body)
        if message.command then return { [message.command.name] = 1 } end
        local uses = {}
        if message.type.carries == "direct" then
            add_uses(uses, body, MEMORY_FIELD)
        elseif message.type.carries == "daisy" and DAISY.names[byte(body, 1)] then
            local inside = {}
            local is_code = DAISY.carries_operations[byte(body, 1)] and add_uses(inside, body, DAISY_PAYLOAD)
            uses = is_code and inside or {}
            uses[DAISY.names[byte(body, 1)]] = 1
        end
        if not next(uses) then uses["(no operation)"] = 1 end
        return uses
    end

    -- A message that is seen for the first time, and the conversation it belongs to.
    function statistics.count_message(talk, message)
        count(row_of(bricks, 2, (talk.name or talk.key)), message)
        if not message.type.is_command then return end
        if message.type.wants_reply then wanted = wanted + 1 end
        for name, times in pairs(uses_of(message, body_of(message))) do
            local row = row_of(operations, 1, name)
            row.uses = row.uses + times
            count(row, message)
        end
    end

    local function add_answer(row, delay)
        row.answers, row.total = row.answers + 1, row.total + delay
        if delay > row.most then row.most = delay end
    end

    -- A reply to a command.
    function statistics.count_answer(talk, message, request)
        local delay = request.delay
        answered = answered + 1
        add_answer(row_of(bricks, 2, (talk.name or talk.key)), delay)
        for name in pairs(uses_of(message, body_of(request.message))) do
            local row = row_of(operations, 1, name)
            row.bytes = row.bytes + message.stop
            add_answer(row, delay)
        end
    end

    -- A piece of a file that is moved; `transfer` is where it is kept, an empty file without any.
    function statistics.keep_piece(transfer, data)
        if transfer.is_dropped or data == "" and transfer.size ~= 0 then return end
        if not transfer.pieces then
            if #files >= MOST_FILES then
                transfer.is_dropped, omitted = true, omitted + 1
                return
            end
            transfer.pieces = {}
            files[#files + 1] = transfer
        end
        if data == "" then return end
        if kept_bytes + #data > MOST_BYTES then transfer.is_dropped = true return end
        kept_bytes = kept_bytes + #data
        transfer.pieces[#transfer.pieces + 1] = data
    end

    -- Lines of columns, each as wide as what stands in it: a window of Wireshark breaks lines after some 70 characters.
    -- The first column begins on the left, all others end on the right.
    local function columns_text(lines)
        local widths, out = {}, {}
        for _, line in ipairs(lines) do
            for number, word in ipairs(line) do
                widths[number] = math.min(math.max(widths[number] or 0, #word), MOST_WIDTH)
            end
        end
        for _, line in ipairs(lines) do
            local words = {}
            for number, word in ipairs(line) do
                local blanks = (" "):rep(widths[number] - #word)
                words[number] = number == 1 and word .. blanks or blanks .. word
            end
            out[#out + 1] = gsub(concat(words, " "), " +$", "")
        end
        return concat(out, "\n")
    end

    local function table_text(heading, rows, has_uses)
        local names, lines = {}, {}
        for name in pairs(rows) do
            names[#names + 1] = name
        end
        table.sort(names, function(one, other)
            if rows[one].messages ~= rows[other].messages then return rows[one].messages > rows[other].messages end
            return one < other
        end)
        lines[1] = { heading, has_uses and "uses" or "", "messages", "bytes", "answers", "mean ms", "most ms" }
        for _, name in ipairs(names) do
            local row = rows[name]
            local mean = row.answers > 0 and format("%.2f", 1000 * row.total / row.answers) or ""
            local most = row.answers > 0 and format("%.2f", 1000 * row.most) or ""
            local uses = has_uses and format("%d", row.uses) or ""
            lines[#lines + 1] = { on_one_line(name), uses, format("%d", row.messages), format("%d", row.bytes),
                format("%d", row.answers), mean, most }
        end
        return columns_text(lines)
    end

    -- A text on the files that were kept, and how many there were besides.
    local function with_omitted(text)
        if omitted == 0 then return text end
        return format("%s\nand %s more, of which nothing was kept", text, plural(omitted, "file"))
    end

    local function files_text()
        local lines = { { "File", "moved", "size" } }
        for _, transfer in ipairs(files) do
            local size = transfer.size and format("%d", transfer.size) or ""
            lines[#lines + 1] = { on_one_line(transfer.path), format("%d", transfer.done), size }
        end
        return with_omitted(columns_text(lines))
    end

    local function all_text()
        local of_all = wanted == 1 and "1 command that wants a reply has none"
            or format("%d commands that want a reply have none", wanted)
        local counts = format("%d of %s", wanted - answered, of_all)
        return concat({
            table_text("Operation", operations, true), "", table_text("Brick", bricks), "", files_text(), "", counts,
        }, "\n") .. "\n"
    end

    -- Windows leaves dots and blanks at the end of a name out.
    local function without_end(name)
        return (gsub(name, "[%. ]+$", ""))
    end

    -- A name of at most so many bytes as file systems take, its extension kept where that is a short one.
    local function cut_name(name)
        if #name <= MOST_NAME then return name end
        local extension = name:match("[^%.](%.[^%.]+)$") or ""
        if #extension > MOST_EXTENSION then extension = "" end
        return without_end(sub(name, 1, MOST_NAME - #extension)) .. extension
    end

    -- The name under which a file is written: nothing of its path leads out of the folder.
    local function safe_name(path, taken)
        local name = gsub(gsub(path:match("[^/\\]*$"), "[^%w%._%- ]", "_"), "^[%. ]+", "_")
        name = cut_name(without_end(name))
        -- Windows leaves blanks before the first dot of a device's name out, too.
        local stem = gsub(name:match("^[^%.]*"):upper(), " +$", "")
        if name == "" or stem:match("^CO[MN]%d?$") or stem:match("^LPT%d$") or stem:match("^[PANX][RUL][NXL]$") then
            name = "_" .. name
        end
        local free, number = name, 1
        while taken[free:lower()] do
            number = number + 1
            free = format("%d-%s", number, name)
        end
        taken[free:lower()] = true
        return free
    end

    -- Writes a file whole, or leaves none. Returns why it could not be written, nil where it was.
    local function write_file(path, data)
        local file, why = io.open(path, "wb")
        -- Lua puts the path before what it says of a file that cannot be opened.
        if not file then return (gsub(why, "^.*: ", "")) end
        local written, short = file:write(data)
        local closed, late = file:close()
        if written and closed then return nil end
        os.remove(path)
        return short or late
    end

    -- Says whether there is something of that name. To rename it to its own name changes nothing, and succeeds where to
    -- open it would fail, as with a link to nothing, or wait for ever, as with a pipe. Where a system should not allow
    -- that, it is opened.
    local function is_there(path)
        if os.rename(path, path) then return true end
        local file = io.open(path, "rb")
        if file then file:close() end
        return file ~= nil
    end

    -- What is said of a file that has another size than was announced.
    local function flaw_of(transfer, size)
        if not transfer.size or size == transfer.size then return "" end
        return size < transfer.size and ", not all of it" or format(", but its size was said to be %d", transfer.size)
    end

    -- Writes the files into a folder that exists. Files that are there stay as they are. Returns a line on each.
    local function export_files(folder)
        if not folder:find("%S") then return "Nothing was written: name a folder that exists" end
        local taken, lines = {}, {}
        for _, transfer in ipairs(files) do
            local path = folder .. "/" .. safe_name(transfer.path, taken)
            local outcome
            if is_there(path) then
                outcome = "kept, it was there before"
            else
                local data = concat(transfer.pieces)
                local failure = write_file(path, data)
                outcome = failure and "not written: " .. failure or plural(#data, "byte") .. flaw_of(transfer, #data)
            end
            lines[#lines + 1] = path .. ": " .. outcome
        end
        return lines[1] and with_omitted(concat(lines, "\n")) or "no files were moved in this capture"
    end

    local function show_window(title, text)
        local window = TextWindow.new(title)
        window:set(text)
    end

    function statistics.register()
        ev3.prefs.statistics = Pref.bool("Statistics of tshark", false, "Print statistics at the end of a run")
        ev3.prefs.export = Pref.string("Export folder of tshark", "", "Write the files that were moved to this folder")
        if gui_enabled() then
            -- Wireshark makes submenus of names with a slash under Tools only.
            register_menu("EV3: Operations, Bricks and Files", function()
                show_window("EV3: statistics", all_text())
            end, MENU_STAT_UNSORTED)
            register_menu("EV3: Export Files...", function()
                new_dialog("EV3: export files", function(folder)
                    show_window("EV3: exported files", export_files(folder))
                end, "Into a folder that exists")
            end, MENU_STAT_UNSORTED)
        end
    end

    local at_end

    -- Called before a capture is read.
    function statistics.print_at_end()
        counts_all = gui_enabled() or ev3.prefs.statistics or ev3.prefs.export ~= ""
        if gui_enabled() or at_end or not counts_all then return end
        at_end = Listener.new("frame")
        function at_end.draw()
            if ev3.prefs.statistics then print(all_text()) end
            if ev3.prefs.export ~= "" then print(export_files(ev3.prefs.export)) end
        end
    end
end

-- Statistics and export of files for the LEGO MINDSTORMS EV3 dissector, ev3.lua. Licence: MIT.
--
-- To install it, put it beside ev3.lua into the personal Lua plugins folder; or run: ev3proto dissector install
--
-- This file is made by ev3proto 0.2.0, from its runtime for Wireshark. Change that, not this file.

set_plugin_info({
    version = "0.2.0",
    description = "LEGO MINDSTORMS EV3: statistics, and export of transferred files",
    author = "the ev3proto authors",
})

if package.loaded["ev3_statistics.lua"] then
    io.stderr:write("ev3_statistics.lua is loaded already; this copy is ignored: ", debug.getinfo(1, "S").short_src, "\n")
    return
end
package.loaded["ev3_statistics.lua"] = true
local script = Proto("EV3_statistics", "EV3 statistics")

-- Statistics of a capture by operation and connection, and the transferred files. Wireshark shows them in windows;
-- tshark prints them at the end of a run if the preferences ask for it.
--
-- A listener reads the fields of ev3.lua. It exists only while statistics are needed, so this file costs nothing until
-- then, and the two files can be loaded in any order.

local format, gsub, sub = string.format, string.gsub, string.sub
local concat = table.concat

-- Maximum length of an exported file's name and of its extension, in bytes: file systems allow 143 and more, and a
-- number may be added.
local MOST_NAME, MOST_EXTENSION = 100, 25
-- Maximum width of a column, in characters.
local MOST_WIDTH = 60

script.prefs.print = Pref.bool("Print at the end", false, "Print statistics at the end of a run of tshark")
script.prefs.export = Pref.string("Export folder", "", "Folder for transferred files, written by tshark")

local function plural(count, word)
    return format("%d %s%s", count, word, count == 1 and "" or "s")
end

-- Messages ----------------------------------------------------------------------------------------------------------

-- What a field of a message is called here, or a function that reads it.
local VALUES = {
    ["ev3.msg_num"] = "counter", ["ev3.request_in"] = "request_in", ["ev3.transfer.path"] = "path",
    ["ev3.transfer.done"] = "done", ["ev3.transfer.size"] = "size",
}
local READERS = {
    ["ev3.cmd_type"] = function(message, info)
        message.is_command = info.display:find("COMMAND", 1, true) ~= nil
        message.wants_reply = info.display:find("COMMAND_REPLY", 1, true) ~= nil
    end,
    ["ev3.response_time"] = function(message, info) message.delay = info.value:tonumber() end,
    ["ev3.data"] = function(message, info) message.data = info.value:raw() end,
    -- The field of a CMD has the name of the opcode, too.
    ["ev3.cmd"] = function(message, info) message.names[#message.names] = info.value end,
}

-- Reads an opcode, a system command or a daisy command: its name is before its number, if it has a name.
local function read_name(message, info)
    message.names[#message.names + 1] = info.display:match("^([%u%d_]+) %(")
end

for _, name in ipairs({ "ev3.op", "ev3.sys_cmd", "ev3.daisy.command" }) do
    READERS[name] = read_name
end

-- Returns the messages in a packet. The item of its frame and the fields of brick and connection precede each message,
-- whose first field is its length, which may be wrong.
local function read_messages(number)
    local messages, message, brick, connection, bytes = {}, nil, "(unknown)", 1, 0
    for _, info in ipairs({ all_field_infos() }) do
        local name = info.name
        if name == "ev3" then
            bytes = info.len
        elseif name == "ev3.brick" then
            brick = info.value
        elseif name == "ev3.connection" then
            connection = info.value
        elseif name == "ev3.msg_len" then
            local address = format("%d: %s", connection, brick)
            bytes = math.min(bytes, info.value + info.len) -- without the padding of a USB report
            message = { packet = number, connection = address, bytes = bytes, names = {} }
            messages[#messages + 1] = message
        elseif message and VALUES[name] then
            message[VALUES[name]] = info.value
        elseif message and READERS[name] then
            READERS[name](message, info)
        end
    end
    return messages
end

-- Returns how often a command uses each operation; a system or daisy command counts as one operation.
local function count_uses(command)
    local uses = {}
    for _, name in ipairs(command.names) do uses[name] = (uses[name] or 0) + 1 end
    if not next(uses) then uses["(no operation)"] = 1 end
    return uses
end

-- Counting ----------------------------------------------------------------------------------------------------------

-- Returns empty statistics. Rows are by name; `waiting` has the commands without a reply so far, `open` the current
-- transfers by connection and path.
local function new_survey()
    return { operations = {}, connections = {}, waiting = {}, wanted = 0, answered = 0, open = {}, files = {} }
end

local function row_of(rows, name)
    rows[name] = rows[name] or { uses = 0, messages = 0, bytes = 0, answers = 0, total = 0, most = 0 }
    return rows[name]
end

local function count_message(row, message)
    row.messages, row.bytes = row.messages + 1, row.bytes + message.bytes
end

local function count_answer(row, delay)
    row.answers, row.total, row.most = row.answers + 1, row.total + delay, math.max(row.most, delay)
end

local function count_command(survey, command)
    local uses = count_uses(command)
    for name, times in pairs(uses) do
        local row = row_of(survey.operations, name)
        row.uses = row.uses + times
        count_message(row, command)
    end
    if command.wants_reply then
        survey.wanted = survey.wanted + 1
        survey.waiting[concat({ command.connection, command.packet, command.counter }, " ")] = uses
    end
end

local function count_reply(survey, reply)
    local key = concat({ reply.connection, reply.request_in, reply.counter }, " ")
    survey.answered = survey.answered + 1
    count_answer(row_of(survey.connections, reply.connection), reply.delay)
    for name in pairs(survey.waiting[key] or {}) do
        local row = row_of(survey.operations, name)
        row.bytes = row.bytes + reply.bytes
        count_answer(row, reply.delay)
    end
    survey.waiting[key] = nil
end

-- Returns the file of a message; a command that begins a transfer starts a new file.
local function file_of(survey, message)
    local key = message.connection .. " " .. message.path
    local is_begin = message.is_command and (message.names[1] or ""):find("^BEGIN_")
    if is_begin or not survey.open[key] then survey.open[key] = { path = message.path, pieces = {} } end
    return survey.open[key]
end

-- Keeps a piece of a file, or an empty file. Folder listings are ignored.
local function keep_piece(survey, message)
    if (message.names[1] or ""):find("LIST_FILES", 1, true) then return end
    local file, data = file_of(survey, message), message.data or ""
    file.size, file.done = message.size, message.done
    if data == "" and file.size ~= 0 then return end
    if #file.pieces == 0 then table.insert(survey.files, file) end
    table.insert(file.pieces, data)
end

local function count_packet(survey, number, time)
    for _, message in ipairs(read_messages(number)) do
        local row = row_of(survey.connections, message.connection)
        count_message(row, message)
        if message.is_command then
            count_command(survey, message)
        elseif message.request_in then
            count_reply(survey, message)
        end
        if not message.is_command then
            -- The longest time between two replies.
            if row.newest then row.gap = math.max(row.gap or 0, time - row.newest) end
            row.newest = time
        end
        if message.path then keep_piece(survey, message) end
    end
end

-- Makes a listener that counts all packets, with all of their fields.
local function listen(survey)
    local listener = Listener.new("frame", "ev3", true)
    function listener.packet(pinfo) count_packet(survey, pinfo.number, pinfo.rel_ts) end
    return listener
end

-- Texts -------------------------------------------------------------------------------------------------------------

-- Replaces control characters, including those of two bytes, which would break a line.
local function on_one_line(text)
    return (gsub(gsub(text, "[\0-\31\127]", "?"), "\194[\128-\159]", "?"))
end

-- Counts the characters of a UTF-8 text.
local function width_of(text)
    return select(2, gsub(text, "[^\128-\191]", ""))
end

-- Formats a table with columns as narrow as their contents, because Wireshark's text windows wrap lines after about 70
-- characters. The first column is left-aligned, the others are right-aligned.
local function columns_text(lines)
    local widths, out = {}, {}
    for _, line in ipairs(lines) do
        for number, word in ipairs(line) do
            widths[number] = math.min(math.max(widths[number] or 0, width_of(word)), MOST_WIDTH)
        end
    end
    for _, line in ipairs(lines) do
        local words = {}
        for number, word in ipairs(line) do
            local blanks = (" "):rep(widths[number] - width_of(word))
            words[number] = number == 1 and word .. blanks or blanks .. word
        end
        out[#out + 1] = gsub(concat(words, " "), " +$", "")
    end
    return concat(out, "\n")
end

local function milliseconds(row, seconds)
    return row.answers > 0 and format("%.2f", 1000 * seconds) or ""
end

local function table_text(heading, rows, has_uses)
    local names = {}
    for name in pairs(rows) do names[#names + 1] = name end
    table.sort(names, function(one, other)
        if rows[one].messages ~= rows[other].messages then return rows[one].messages > rows[other].messages end
        return one < other
    end)
    local last = has_uses and "" or "gap ms"
    local lines = { { heading, has_uses and "uses" or "", "messages", "bytes", "answers", "mean ms", "max ms", last } }
    for _, name in ipairs(names) do
        local row = rows[name]
        lines[#lines + 1] = {
            on_one_line(name), has_uses and format("%d", row.uses) or "", format("%d", row.messages),
            format("%d", row.bytes), format("%d", row.answers), milliseconds(row, row.total / row.answers),
            milliseconds(row, row.most), row.gap and format("%.0f", 1000 * row.gap) or "",
        }
    end
    return columns_text(lines)
end

local function files_text(survey)
    local lines = { { "File", "transferred", "size" } }
    for _, file in ipairs(survey.files) do
        local size = file.size and format("%d", file.size) or ""
        lines[#lines + 1] = { on_one_line(file.path), format("%d", file.done), size }
    end
    return columns_text(lines)
end

local function survey_text(survey)
    local unanswered = survey.wanted - survey.answered
    return concat({
        table_text("Operation", survey.operations, true), "", table_text("Connection", survey.connections), "",
        files_text(survey), "",
        format("Without a reply: %d of %s that requested one", unanswered, plural(survey.wanted, "command")),
    }, "\n") .. "\n"
end

-- Export ------------------------------------------------------------------------------------------------------------

-- Windows drops dots and spaces at the end of a name.
local function without_end(name)
    return (gsub(name, "[%. ]+$", ""))
end

-- Truncates a name to the maximum length, but keeps a short extension.
local function cut_name(name)
    if #name <= MOST_NAME then return name end
    local extension = name:match("[^%.](%.[^%.]+)$") or ""
    if #extension > MOST_EXTENSION then extension = "" end
    return without_end(sub(name, 1, MOST_NAME - #extension)) .. extension
end

-- Returns a safe and unused name for an exported file, without its folder.
local function safe_name(path, taken)
    local name = gsub(path:match("[^/\\]*$"), "[\194-\244][\128-\191]+", "_")
    name = gsub(gsub(name, "[^%w%._%- ]", "_"), "^[%. ]+", "_")
    name = cut_name(without_end(name))
    -- Names of devices on Windows, which also drops spaces before the first dot.
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

-- Writes a complete file, or none. Returns the reason for a failure, else nil.
local function write_file(path, data)
    local file, reason = io.open(path, "wb")
    -- Lua puts the path before the reason.
    if not file then return (gsub(reason, "^.*: ", "")) end
    local is_written, write_error = file:write(data)
    local is_closed, close_error = file:close()
    if is_written and is_closed then return nil end
    os.remove(path)
    return write_error or close_error
end

-- Tells whether a path exists. Renaming it to itself changes nothing, and also works for dangling links and for pipes,
-- where opening fails or blocks. If a system refuses that, the path is opened.
local function exists(path)
    if os.rename(path, path) then return true end
    local file = io.open(path, "rb")
    if file then file:close() end
    return file ~= nil
end

local function size_text(file, size)
    local text = plural(size, "byte")
    if not file.size or size == file.size then return text end
    return size < file.size and format("%d of %s, incomplete", size, plural(file.size, "byte"))
        or format("%s, announced as %d", text, file.size)
end

local function export_file(file, path)
    if exists(path) then return "exists already, not overwritten" end
    local data = concat(file.pieces)
    local reason = write_file(path, data)
    return reason and "not written: " .. reason or size_text(file, #data)
end

-- Writes the files into an existing folder, without overwriting any. Returns a line for each.
local function export_files(survey, folder)
    if not folder:find("%S") then return "Nothing was written: choose an existing folder." end
    local taken, lines = {}, {}
    for _, file in ipairs(survey.files) do
        local path = folder .. "/" .. safe_name(file.path, taken)
        lines[#lines + 1] = path .. ": " .. export_file(file, path)
    end
    return lines[1] and concat(lines, "\n") or "No files were transferred in this capture."
end

-- Windows, and the end of a run -------------------------------------------------------------------------------------

-- Returns the statistics of the open capture.
local function survey_of_capture()
    local survey = new_survey()
    local listener = listen(survey)
    retap_packets()
    listener:remove()
    return survey
end

if gui_enabled() then
    -- Wireshark makes submenus of names with a slash only under Tools.
    register_menu("EV3: Operations, Connections and Files", function()
        TextWindow.new("EV3: Statistics"):set(survey_text(survey_of_capture()))
    end, MENU_STAT_UNSORTED)
    register_menu("EV3: Export Files...", function()
        new_dialog("EV3: Export Files", function(folder)
            TextWindow.new("EV3: Exported Files"):set(export_files(survey_of_capture(), folder))
        end, "Existing output folder")
    end, MENU_STAT_UNSORTED)
end

local is_listening

-- Called before a capture is read, when the preferences are known.
function script.init()
    local prefs = script.prefs
    if gui_enabled() or is_listening or not prefs.print and prefs.export == "" then return end
    is_listening = true
    local survey = new_survey()
    local listener = listen(survey)
    function listener.draw()
        if prefs.print then print(survey_text(survey)) end
        if prefs.export ~= "" then print(export_files(survey, prefs.export)) end
    end
end
-- Checksum of the lines above, by which a changed file is recognised: e34a7dac13c2f81e

-- Frames in packets -------------------------------------------------------------------------------------------------
--
-- What all carriers have in common: one frame in a buffer, and the columns of a packet.

-- Tells whether the tree is needed: not for one-line output if filters, columns and colours use only other protocols.
local has_tree
do
    local this_dissector
    local is_referenced = TreeItem.referenced

    function has_tree(tree)
        this_dissector = this_dissector or Dissector.get("ev3")
        return is_referenced(tree, this_dissector)
    end
end

-- The columns of a packet. If frames are split over packets, TCP passes a packet on in several buffers; the text of
-- each is appended to the info column, which Wireshark truncates.
local start_line, say, show
do
    local pieces, shown, last_number, last_offset = {}, 0, 0, 0

    -- Begins a buffer: the first one of a packet, or another one of the same packet.
    function start_line(number, offset)
        if number ~= last_number or offset <= last_offset then pieces, shown = {}, 0 end
        last_number, last_offset = number, offset
    end

    function say(said)
        pieces[#pieces + 1] = said
    end

    function show(pinfo, tvb, tree)
        -- The protocol hierarchy counts items; before 4.6 has_tree does not tell. If there is a tree, Wireshark's own
        -- item for Lua is hidden.
        if tree.hidden and not has_tree(tree) then tree:add(ev3, tvb) end
        local columns, count = pinfo.cols, #pieces
        columns.protocol = "EV3"
        if count == shown then return end
        local text = concat(pieces, "; ", shown + 1, count)
        if shown > 0 then
            columns.info:append("; " .. text)
        else
            columns.info = text
        end
        shown = count
    end
end

-- Claims and Finding below decide which conversations are a brick's, and where frames start.
local claiming, finding = {}, {}

-- Each carrier below adds its dissectors, by Wireshark's type of ports, and a table: `register`, which registers them;
-- `forget`, which drops the state of the last capture and begins each; optionally `prefs_changed`.
local dissectors, carriers = {}, {}

-- Looking up these methods for each packet would take longer than calling them.
local bytes_of, captured_len, offset_of = Tvb.raw, Tvb.len, Tvb.offset

local function is_command(type) return type.is_command end

-- The number of the first packet with data of which the capture has only the beginning, as with a snap length.
local first_cut = math.huge

-- Tells whether data end where the capture cut their packet.
local function is_cut_by_capture(tvb, stop, pinfo)
    if stop < tvb:len() or pinfo.caplen >= pinfo.len then return false end
    first_cut = math.min(first_cut, pinfo.number)
    return true
end

-- Dissects a message in a buffer. `conversation` is given in the first pass only; `said` replaces the message's own
-- line. Returns the line for the info column and, if there is a tree, the message's item.
local function dissect_message(tvb, at, message, conversation, place, pinfo, tree, brick, said)
    if conversation then
        dialogues.take_note(place, conversation, message, pinfo)
        claiming.note(conversation, message)
    end
    message.is_cut = message.stop < message.size and is_cut_by_capture(tvb, at + message.stop, pinfo)
    local line, item = messages.show(message, place, tvb, at, tree, brick, said, conversation)
    storage.free_unused(brick)
    return line, item
end

-- Returns the offset after the frame that starts at an offset, by its length; nil without a length.
local function stop_of(text, at)
    local length = reading.unsigned16(text, at)
    return length and at + LENGTH_FIELD + length
end

-- Reads the frame at an offset of a text.
function messages.read_at(text, at)
    return messages.read(sub(text, at + 1, stop_of(text, at)))
end

local function is_usual_length(length)
    return length >= MIN_LENGTH and length <= MAX_LENGTH
end

-- Tells whether the length field at an offset can be a frame's; those of downloads may be larger than all others.
local function is_length(text, at)
    local length = reading.unsigned16(text, at)
    if is_usual_length(length) then return true end
    local code, number = byte(text, at + HEADER_SIZE, at + HEADER_SIZE + 1)
    local type, command = MESSAGE_TYPES[code], SYSTEM_COMMANDS[number]
    if length < MIN_LENGTH or not type or not type.is_command then return false end
    return type.carries == "system" and (not number or command ~= nil and command.is_long == true)
end

-- Tells whether a frame may start at an offset, judging by as much of its header as is present.
local function may_start(text, at)
    if #text - at < LENGTH_FIELD then return #text > at end
    local type = byte(text, at + HEADER_SIZE)
    return is_length(text, at) and (not type or MESSAGE_TYPES[type] ~= nil)
end

-- Returns the offset after the polls at an offset: lengths of 0 between frames, which the brick ignores.
local function after_polls(text, at)
    while sub(text, at + 1, at + LENGTH_FIELD) == "\0\0" do at = at + LENGTH_FIELD end
    return at
end

-- Frames in packets -------------------------------------------------------------------------------------------------
--
-- What all carriers have in common: one frame of a buffer, and what the columns say of a packet.

-- Whether anybody looks at the tree. In one-line output, and where filters, columns and colours are about other
-- protocols, everything that is done for it would be done in vain.
local has_tree
do
    local this_dissector
    local is_referenced = TreeItem.referenced

    function has_tree(tree)
        this_dissector = this_dissector or Dissector.get("ev3")
        return is_referenced(tree, this_dissector)
    end
end

-- The columns of a packet. TCP hands a packet over in pieces when frames are split over several; what is said of each
-- is added to the info column, which Wireshark cuts where it is full.
local start_line, say, show
do
    local pieces, shown, last_number, last_offset = {}, 0, 0, 0

    -- A buffer of a packet is read: the first one, or a further one of the packet before.
    function start_line(number, offset)
        if number ~= last_number or offset <= last_offset then pieces, shown = {}, 0 end
        last_number, last_offset = number, offset
    end

    function say(said)
        pieces[#pieces + 1] = said
    end

    function show(pinfo)
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

-- What is done for conversations that may be others': further below.
local claiming = {}

-- A message in a buffer: `conversation` is what is known of its conversation, needed the first time only; `said` is the
-- line on it in place of its own. Returns the line for the info column and, if there is a tree, the message's item.
local function dissect_message(tvb, at, message, conversation, place, pinfo, tree, is_shown, said)
    if conversation then
        take_note(place, conversation, message, pinfo)
        claiming.note(conversation, message)
    end
    -- Before 4.6 the protocol alone does not count as looked at, yet the protocol hierarchy counts its items.
    if not is_shown and tree.text then tree:add(ev3, tvb(at, message.stop)) end
    return show_message(message, place, tvb, at, tree, is_shown, said, conversation)
end

-- Bytes of the frame that starts with these two; nil where its length is not here. Where each packet comes by, it is
-- worked out on the spot: a call takes as long as the rest.
local function frame_size(low, high)
    return high and LENGTH_FIELD + low + high * 0x100
end

local function is_usual_length(low, high)
    local length = low + high * 0x100
    return length >= MIN_LENGTH and length <= MAX_LENGTH
end

-- Whether the length field at an offset can be a frame's. Downloads may be longer than all others; their header tells.
local function is_length(text, at)
    local low, high, _, _, code, number = byte(text, at + 1, at + HEADER_SIZE + 1)
    if is_usual_length(low, high) then return true end
    local type, command = MESSAGE_TYPES[code], SYSTEM_COMMANDS[number]
    if low + high * 0x100 < MIN_LENGTH or not type or not type.is_command then return false end
    return type.carries == "system" and (not number or command ~= nil and command.is_long == true)
end

-- Whether a frame may start at an offset, as far as its header goes.
local function may_start(text, at)
    local low, high, _, _, type = byte(text, at + 1, at + HEADER_SIZE)
    if not high then return low ~= nil end
    return is_length(text, at) and (not type or MESSAGE_TYPES[type] ~= nil)
end

-- The offset after the polls at an offset: lengths of 0 between frames, which the brick passes over.
local function after_polls(text, at)
    while sub(text, at + 1, at + LENGTH_FIELD) == "\0\0" do
        at = at + LENGTH_FIELD
    end
    return at
end

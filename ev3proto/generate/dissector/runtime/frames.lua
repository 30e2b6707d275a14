-- Frames in packets -------------------------------------------------------------------------------------------------
--
-- What all carriers have in common: one frame of a buffer, and what the columns say of a packet.

-- Whether anybody looks at the tree. In one-line output, and where filters, columns and colours are about other
-- protocols, everything that is done for it would be done in vain.
local this_dissector

local function has_tree(tree)
    this_dissector = this_dissector or Dissector.get("ev3")
    return tree:referenced(this_dissector)
end

local last_number, last_offset = 0, 0

-- Shows in the columns what a packet says. TCP hands a packet over in pieces when frames are split over several.
local function show(pinfo, tvb, said)
    local columns, offset = pinfo.cols, tvb:offset()
    columns.protocol = "EV3"
    if pinfo.number == last_number and offset > last_offset then
        columns.info:append("; " .. said)
    else
        columns.info = said
    end
    last_number, last_offset = pinfo.number, offset
end

-- A message in a buffer: `key` is the function that tells the conversation it belongs to, `said` what is said of it
-- instead of what it says itself. Returns the line for the info column and, if there is a tree, the message's item in
-- it.
local function dissect_message(tvb, at, message, key, pinfo, tree, said)
    local place = place_of(pinfo.number, tvb:offset() + at)
    if not pinfo.visited then take_note(place, key, message, pinfo) end
    local is_shown = has_tree(tree)
    -- Before 4.6 the protocol alone does not count as looked at, yet the protocol hierarchy counts its items.
    if not is_shown and tree.text then tree:add(ev3, tvb(at, message.stop)) end
    return show_message(message, place, tvb, at, pinfo, tree, is_shown, said)
end

local function is_length(low, high)
    local length = low + high * 0x100
    return length >= MIN_LENGTH and length <= MAX_LENGTH
end

-- Whether a frame may start with these bytes, as far as they go.
local function may_be_frame(text)
    local low, high, _, _, type = byte(text, 1, HEADER_SIZE)
    if not high then return low ~= nil end
    return is_length(low, high) and (not type or MESSAGE_TYPES[type] ~= nil)
end

-- Both directions of a connection have one key.
local function conversation_key(pinfo)
    local from = tostring(pinfo.src) .. " " .. pinfo.src_port
    local to = tostring(pinfo.dst) .. " " .. pinfo.dst_port
    return from < to and from .. " " .. to or to .. " " .. from
end

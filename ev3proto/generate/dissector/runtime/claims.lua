-- Claims ------------------------------------------------------------------------------------------------------------
--
-- Ours and not ours: the ports and channels that bricks use belong to others as well. The rule stands in ev3proto's
-- tables; here it is applied. Decisions are made the first time a packet is seen, and kept.

-- What the beginning of some data tells: OURS, PART where more is needed to tell, nil for what is not ours.
local OURS, PART = "ours", "part"

local is_flawless, may_become_flawless, is_sensible_command, find_frame, find_step, judge_split

-- What is done for connections that may be others': one table, as there is little room for locals. What they tell may
-- also be PERHAPS, where it is ours or a chance.
local claiming = { PERHAPS = "perhaps" }

do
    -- Places in one piece of a stream where a whole frame is tried, before the piece is given up.
    local MOST_TRIALS = 64

    -- Frames after one that are looked at to tell whether it is one.
    local MOST_FOLLOWING = 2

    -- The offset after the frame that starts at another one, as its length says; nil where its length is not here.
    local function stop_of(text, at)
        local low, high = byte(text, at + 1, at + 2)
        return high and at + frame_size(low, high)
    end

    -- Whether the operations of a command can be read: all of them, or with `is_part` those that are there.
    local function can_be_read_now(text, stop, is_part)
        local at = COMMAND_HEADER_SIZE
        while at < stop do
            local operation, after, _, reason, kind = read_operation(text, at)
            -- Of a list that goes on in the next packet the dissector says that it is too long.
            if reason then
                local is_list = kind == "fault" and operation ~= nil and operation.list ~= nil
                return is_part and (kind == "cut_off" or is_list)
            end
            at = after
        end
        return true
    end

    -- Calls a function with each firmware's instructions, the preferred one's first, until it says anything.
    local function by_any(says, ...)
        local said, preferred = says(...), instructions
        if said then return said end
        for _, name in ipairs(DIALECTS) do
            instructions = INSTRUCTION_SETS[name]
            said = said or instructions ~= preferred and says(...)
        end
        instructions = preferred
        return said
    end

    -- The same, whichever firmware has them: that the brick has another one than the preference says is not known
    -- before.
    local function can_be_read(text, stop)
        return by_any(can_be_read_now, text, stop)
    end

    -- Whether a command without a fault says something that somebody would say.
    function is_sensible_command(message)
        local type, text, stop = message.type, message.text, message.stop
        if not type.is_command then return false end
        if type.carries ~= "direct" then return true end
        local at = COMMAND_HEADER_SIZE
        if stop <= at then return false end
        while at < stop do
            if CLAIMS.never_sent[byte(text, at + 1)] then return false end
            local _, after, _, reason = read_operation(text, at)
            -- Operations of another firmware.
            if reason then return true end
            at = after
        end
        return true
    end

    -- The same of any message: replies are what the brick makes of them.
    local function makes_sense(message)
        return not message.type.is_command or is_sensible_command(message)
    end

    -- Whether a frame may be a telegram of LEGO's NXT: its kind and command are where the counter would be.
    local function may_be_of_nxt(text)
        local nxt = CLAIMS.nxt
        local low, high, kind, command = byte(text, 1, 4)
        local count = byte(text, nxt.count_at + 1)
        if not count then return false end
        kind = kind % nxt.reply_flag
        if kind == nxt.system then return command == nxt.any_length end
        if kind == nxt.reply then return nxt.answered[command] ~= nil end
        if kind ~= nxt.direct then return false end
        local fixed = nxt.counted[command]
        return low + high * 0x100 == (fixed and fixed + count or nxt.lengths[command])
    end

    -- Whether a reply that a command failed brings memory all the same: the brick sends none.
    local function is_odd_error(message)
        local type = message.type
        return type.is_error and type.carries == "direct" and message.stop > HEADER_SIZE
    end

    -- Something that no value is written to, or a number and a text in each other's place.
    local is_misplaced
    local function look_for_misplaced(parameter, encoding)
        if encoding.scope then return end
        local is_text = encoding.kind == CONSTANT_TEXT
        if parameter.is_output or is_text ~= (parameter.kind == TEXT_VALUE) then is_misplaced = true end
    end

    local function count_telling_now(text, stop)
        local at, count = COMMAND_HEADER_SIZE, 0
        is_misplaced = false
        while at < stop do
            local code = byte(text, at + 1)
            if CLAIMS.never_sent[code] then return nil end
            local _, after, _, reason = read_operation(text, at, look_for_misplaced)
            if reason or is_misplaced then return nil end
            if code >= CLAIMS.first_telling and not CLAIMS.not_telling[code] then count = count + 1 end
            at = after
        end
        return count
    end

    -- How much a frame without a fault tells that others' bytes hardly ever do: as much as it has operations that tell.
    local function count_telling(message)
        local type = message.type
        if not type.is_command or type.carries == "daisy" then return 0 end
        if type.carries == "system" then return CLAIMS.system_tells end
        return by_any(count_telling_now, message.text, message.stop) or 0
    end

    -- Whether a frame is without any fault; with `is_any` by the instructions of any firmware.
    function is_flawless(message, is_any)
        local type, text, stop = message.type, message.text, message.stop
        if not type or stop < message.size or message.fault then return false end
        if type.carries == "direct" then
            if not type.is_command then return true end
            local is_readable = is_any and can_be_read or can_be_read_now
            return stop >= COMMAND_HEADER_SIZE and is_readable(text, stop)
        elseif type.carries == "daisy" then
            local at = HEADER_SIZE
            if type.is_command then
                if not DAISY.names[byte(text, at + 1)] then return false end
                at = at + 1
            end
            local from, to = byte(text, at + 1, at + 2)
            return to ~= nil and from <= DAISY.most_layers and to <= DAISY.most_layers
        end
        return true
    end

    -- Whether a frame of which only this is there may become one without a fault.
    function may_become_flawless(text, at, accepts)
        local part = sub(text, at + 1)
        if not may_start(part, 0) then return false end
        local type = MESSAGE_TYPES[byte(part, HEADER_SIZE)]
        if not type then return true end
        if accepts and not accepts(type) then return false end
        if type.carries == "system" and #part > HEADER_SIZE then
            return SYSTEM_COMMANDS[byte(part, HEADER_SIZE + 1)] ~= nil
        end
        if type.carries ~= "direct" or not type.is_command or #part <= COMMAND_HEADER_SIZE then return true end
        return can_be_read_now(part, #part, true)
    end

    -- What a text tells, from an offset on, that should begin with a frame of a type that `accepts` takes, as it goes
    -- the right way: OURS where one of its frames tells it, PERHAPS where none does. Then all of them must be without a
    -- fault and make sense. Else the first one must, and the others must look like frames. The second result is how
    -- much they tell. After a frame that tells there may be fewer other bytes than a header has; with `takes_rest` any.
    function claiming.weigh_frames(text, at, accepts, takes_rest)
        local start, is_clean, telling = at, true, 0
        while at < #text do
            if not may_start(text, at) then
                local is_ours = telling > 0 and (takes_rest or #text - at < HEADER_SIZE)
                return is_ours and OURS or nil, is_ours and telling or 0
            end
            local stop = stop_of(text, at)
            if not stop or stop > #text then
                local is_part = may_become_flawless(text, at, accepts)
                if at == start then return is_part and PART or nil, 0 end
                is_clean = is_clean and is_part
                break
            end
            local message = read_message(sub(text, at + 1, stop))
            local stands = is_flawless(message, true) and accepts(message.type) and makes_sense(message)
                and not may_be_of_nxt(message.text) and not is_odd_error(message)
            if at == start and not stands then return nil, 0 end
            is_clean = is_clean and stands
            if is_clean then telling = telling + count_telling(message) end
            at = stop
        end
        return telling > 0 and OURS or is_clean and claiming.PERHAPS or nil, telling
    end

    -- Whether a frame of which only the beginning was captured is one that somebody would send: of a direct command,
    -- its first operation must be there.
    local function may_be_sent(text)
        local message = read_message(text)
        if #text == HEADER_SIZE or not makes_sense(message) or may_be_of_nxt(text) then return false end
        local type = message.type
        return type.carries ~= "direct" or not type.is_command
            or by_any(select_operation, text, COMMAND_HEADER_SIZE) ~= nil
    end

    -- What the beginning of a packet tells of which the capture has no more: PERHAPS where it is that of a frame which
    -- ends with the packet. In a claimed connection the header of that is enough.
    function claiming.weigh_cut(talk, text, reported)
        if #text < HEADER_SIZE or unsigned16(text, 0) + LENGTH_FIELD ~= reported then return nil end
        return (talk.is_claimed or may_be_sent(text)) and claiming.PERHAPS or nil
    end

    -- Whether a text is frames of ours from an offset on and nothing else, whatever is wrong with them: OURS; PART
    -- where the last one has its header and is not whole, nil where there is anything else.
    local function hold_frames(text, at)
        while at < #text do
            if not may_start(text, at) then return nil end
            local stop = stop_of(text, at)
            if not stop or stop > #text then return #text - at >= HEADER_SIZE and PART or nil end
            at = stop
        end
        return OURS
    end

    -- Counts a packet of a claimed connection that frames with faults fill, or misdirected ones. False: it is none, or
    -- one too many. With `may_be_part` the beginning of such a frame is none too many, while there may be another.
    -- `side` is what is known of its direction.
    function claiming.meet_faulty(talk, side, text, at, may_be_part)
        local held = talk.is_claimed and hold_frames(text, at)
        local count, most = talk.faulty or 0, talk.has_command and CLAIMS.strange_packets or CLAIMS.strange_in_a_row
        if held == OURS then
            talk.faulty = count + 1
            if talk.is_weak then talk.proofs = 0 end
        elseif not held or not may_be_part then
            return false
        end
        -- One too many is not what is left of a frame.
        if count >= most then side.strange = CLAIMS.strange_in_a_row end
        return count < most
    end

    -- The claim on a connection is proven.
    function claiming.prove(talk)
        talk.is_claimed, talk.is_proven = true, true
    end

    local function add_proof(talk, verdict, telling)
        talk.strange, talk.unread, talk.proofs = 0, 0, talk.proofs + math.min(1 + telling, CLAIMS.most_proofs)
        if telling > 0 then talk.faulty = 0 end
        talk.is_weak = talk.is_weak and verdict == claiming.PERHAPS
        if talk.proofs >= CLAIMS.proofs then claiming.prove(talk) end
    end

    -- The claim on a connection has ended, or too much was strange before there was one: now more must tell that it is
    -- ours.
    function claiming.end_claim(talk)
        talk.has_ended = talk.is_claimed and talk.is_weak and 1 or 2
        talk.is_claimed, talk.is_proven, talk.telling, talk.strange = false, false, 0, 0
    end

    local function begin_claim(talk, verdict, telling)
        talk.is_claimed, talk.is_weak, talk.proofs, talk.has_command = true, true, 0, false
        add_proof(talk, verdict, telling)
    end

    local function count_strange(talk, size)
        if size > HEADER_SIZE then
            talk.strange = talk.strange + 1
        else
            -- A frame may be cut into packets that are as small.
            talk.unread = (talk.unread or 0) + size
            if talk.unread > LENGTH_FIELD + MAX_LENGTH then talk.strange = CLAIMS.strange_packets end
        end
    end

    -- Whether a strange packet may be what is left of a frame, as it is among the first of its side.
    local function may_be_rest(side)
        side.strange = (side.strange or 0) + 1
        return side.strange <= CLAIMS.strange_in_a_row
    end

    -- Whether a packet is nothing but replies that nobody asked for as far as is known, after strange packets. They are
    -- a chance, unless the packet before it was one as well.
    local function is_chance(side, verdict, is_from_brick)
        local was_reply = side.is_reply
        side.is_reply = verdict == claiming.PERHAPS and is_from_brick
        return side.is_reply and not was_reply and side.is_odd
    end

    -- Whether so much of a connection was strange that only a text would make it ours.
    function claiming.is_left_alone(talk)
        return not talk.is_claimed and not talk.has_ended and (talk.strange or 0) >= CLAIMS.strange_packets
    end

    -- Takes a packet of a connection that is not proven to be ours, by what it tells: OURS, PERHAPS, or nil. `side` is
    -- what is known of its direction. Returns whether it is taken.
    function claiming.weigh_packet(talk, side, verdict, telling, size, is_from_brick)
        talk.strange = talk.strange or 0
        if verdict and talk.is_claimed then
            add_proof(talk, verdict, telling)
        elseif talk.is_claimed then
            if talk.is_weak and may_be_rest(side) then return true end
            count_strange(talk, size)
            if talk.strange >= (talk.is_weak and 1 or CLAIMS.strange_in_a_row) then claiming.end_claim(talk) end
        elseif talk.has_ended then
            talk.telling = verdict and talk.telling + telling or 0
            if talk.telling >= talk.has_ended then begin_claim(talk, verdict, telling) end
        elseif not verdict then
            side.is_odd, side.is_reply = side.is_odd or size > HEADER_SIZE, false
            count_strange(talk, size)
        elseif not is_chance(side, verdict, is_from_brick) then
            begin_claim(talk, verdict, telling)
        end
        if verdict then
            side.strange = CLAIMS.strange_in_a_row
            talk.has_command = talk.has_command or not is_from_brick
        end
        return talk.is_claimed
    end

    -- The bytes 1 to 4 of a header, as a pattern: no type is a letter that means anything in one.
    local codes = {}
    for code in pairs(MESSAGE_TYPES) do
        codes[#codes + 1] = string.char(code)
    end
    local STARTS = "[\0-" .. string.char(floor(MAX_LENGTH / 0x100)) .. "]..[" .. concat(codes) .. "]"

    -- How many frames stand one after the other from an offset on, until one is not whole; nil where the chain breaks.
    local function count_chain(text, at)
        local count = 0
        while at < #text do
            if not may_start(text, at) then return nil end
            local size = frame_size(byte(text, at + 1, at + 2))
            if not size or at + size > #text then return count end
            at, count = at + size, count + 1
        end
        return count
    end

    -- The first offset, from `at` on, where all of a frame stands without a fault, and where what follows it looks like
    -- the next one; nil where there is none. With `least` so many frames must follow each other up to the end.
    function find_frame(text, at, accepts, least)
        local hit = find(text, STARTS, at + 2)
        for _ = 1, MOST_TRIALS do
            if not hit then return nil end
            local low, high = byte(text, hit - 1, hit)
            local stop = hit - 2 + frame_size(low, high)
            if is_length(low, high) and stop <= #text and (stop == #text or may_start(text, stop)) then
                local message = read_message(sub(text, hit - 1, stop))
                if is_flawless(message) and (not accepts or accepts(message.type)) then
                    local is_found = makes_sense(message)
                    if is_found and least then is_found = (count_chain(text, hit - 2) or 0) >= least end
                    if is_found then return hit - 2 end
                end
            end
            hit = find(text, STARTS, hit + 1)
        end
        return nil
    end

    local function accepts_any()
        return true
    end

    -- How many frames begin here, one after the other, of those whose headers are here; nil where none can. Few are
    -- enough to tell, as the next gap may come soon.
    local function follow(text, at)
        local size, count = #text, 0
        while at < size and count < MOST_FOLLOWING do
            if not may_start(text, at) then return nil end
            if size - at < HEADER_SIZE then break end
            at, count = stop_of(text, at), count + 1
        end
        return count
    end

    -- Where a stream goes on that is out of step, from an offset on: the place of a frame that is whole there and
    -- without a fault, and followed by what may be the next one. If frames may go on in the next packet, this is also
    -- the place of the first that may be one as far as it goes, and the second result is true. Where a packet starts,
    -- at `first` and at `second`, a frame may have faults, or nothing that can follow it. nil: no frame is here.
    function find_step(text, at, accepts, may_go_on, first, second)
        accepts = accepts or accepts_any
        local open, single, begun
        local trials, hit = 0, find(text, STARTS, at + 2)
        while hit and trials < MOST_TRIALS do
            local place, low, high, _, _, code = hit - 2, byte(text, hit - 1, hit + 3)
            local stop = place + frame_size(low, high)
            if is_length(low, high) and accepts(MESSAGE_TYPES[code]) then
                trials = trials + 1
                if stop > #text then
                    if may_go_on and not open and may_become_flawless(text, place, accepts) then open = place end
                else
                    local following = follow(text, stop)
                    local is_begin = place == first or place == second
                    if following or is_begin then
                        local message = read_message(sub(text, place + 1, stop))
                        local stands = is_flawless(message) and makes_sense(message)
                        if stands and following and following > 0 then return place end
                        if stands and following then
                            single = single or place
                        elseif is_begin and (stands or following) then
                            begun = begun or place
                        end
                    end
                end
            end
            hit = find(text, STARTS, hit + 1)
        end
        single = single or begun
        if single then return single end
        return open, open ~= nil
    end

    -- What a frame is that seems to come in several packets, if a gap may be between them: OURS, PART where more is
    -- needed to tell, nil where it is none. `joint` is where the newest packet starts.
    function judge_split(text, at, accepts, joint, is_last)
        local stop = stop_of(text, at)
        if stop > #text then
            if may_become_flawless(text, at, accepts) or not find_step(text, at + 1, accepts) then return PART end
            return nil
        end
        local message = read_message(sub(text, at + 1, stop))
        local type, following = message.type, follow(text, stop)
        local stands = type and (not accepts or accepts(type)) and is_flawless(message) and makes_sense(message)
        -- Few bytes are operations by chance.
        local tells_itself = stands and type.is_command and type.carries == "direct"
        if stands and following and following > 0 or tells_itself then return OURS end
        if not following then
            -- The next frame may be of an unknown type: then the one after it must start.
            local next_low, next_high = byte(text, stop + 1, stop + 2)
            local next_stop = next_high and stop + frame_size(next_low, next_high)
            if not next_stop or not is_length(next_low, next_high) then return nil end
            if next_stop < #text and not may_start(text, next_stop) then return nil end
            following = next_stop < #text and 1 or 0
        end
        local place, is_open = find_step(text, stands and joint or at + 1, accepts, true, joint)
        if not place or place >= stop then place = nil end
        if place and not is_open and following < 2 then return nil end
        if is_last or stands and following > 0 then return OURS end
        if not stands and following == 0 or place and following < 2 then return PART end
        return OURS
    end
end

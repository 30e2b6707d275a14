-- Streams -----------------------------------------------------------------------------------------------------------
--
-- The byte stream of a TCP connection or of RFCOMM. Frames may be split over packets and share them; over TCP a text
-- from each side may precede them.

-- `sure_places`: where bytes are in no frame, in conversations that are a brick's for sure.
local streaming = { sure_places = {} }
do
    -- Matches the text that unlocks the brick's port: the offset after it, and the serial number.
    local function match_unlock(text, at)
        local serial, newline, after
        for _, pattern in ipairs(UNLOCK.patterns) do
            if not serial then serial, newline, after = text:match(pattern, at + 1) end
        end
        if not serial then return nil end
        for _ = 1, UNLOCK.endings do
            if sub(text, after, after + #newline - 1) == newline then after = after + #newline end
        end
        return after - 1, serial
    end

    -- Adds bytes that are not a frame. Returns their line, the offset after them, and their item, nil without a tree.
    local function add_bytes(stream, at, stop, said, declared)
        if not stream.brick then return said, stop end
        local range = stream.tvb(at, stop - at)
        local item = add_item(stream.tree, range, stream.brick, said)
        item:add(declared, range)
        return said, stop, item
    end

    -- Dissects one of the texts: its line, and the offset after it; else nil. The firmware also sends the terminating
    -- zero of its answer, unless that zero is the start of a frame's length.
    local function dissect_text(stream, at)
        local text = stream.text
        local after, serial = match_unlock(text, at)
        if after then
            local _, _, item = add_bytes(stream, at, after, "unlock " .. serial, field.unlock)
            if item then item:add(field.unlock_serial, stream.tvb(at + #UNLOCK.request, #serial)) end
            return "unlock " .. serial, after
        end
        after = at + #UNLOCK.answer
        if sub(text, at + 1, after) ~= UNLOCK.answer then return nil end
        local zero, next = byte(text, after + 1, after + 2)
        if zero == 0 and not (next and is_length(text, after)) then after = after + 1 end
        return add_bytes(stream, at, after, "accepted", field.accept)
    end

    -- Tells whether one of the texts may begin here and continue in the next segment.
    local function is_part_of_text(text, at)
        local part = sub(text, at + 1)
        if find(UNLOCK.answer, part, 1, true) == 1 or find(UNLOCK.request, part, 1, true) == 1 then return true end
        return #part < UNLOCK.most_bytes and sub(part, 1, #UNLOCK.request) == UNLOCK.request
    end

    -- Judges data at the start of a connection: OURS if they begin with one of the texts, PART, or nil.
    function streaming.judge_text(text)
        if not UNLOCK.starts[byte(text, 1)] then return nil end
        if sub(text, 1, #UNLOCK.answer) == UNLOCK.answer or match_unlock(text, 0) then return OURS end
        return is_part_of_text(text, 0) and PART or nil
    end

    -- Returns the offset after the newlines or the zero that end a text of an earlier segment; frames must follow.
    local function end_of_text(text, at)
        local after = at == 0 and (text:match("^[\r\n]+()") or text:match("^\0()"))
        local stop = after and after - 1
        while stop and stop < #text do
            if not may_start(text, stop) or #text - stop < HEADER_SIZE then return nil end
            stop = stop_of(text, stop)
        end
        return stop == #text and after - 1 or nil
    end

    local function add_faulty(stream, at, stop, said, kind, reason)
        local _, _, item = add_bytes(stream, at, stop, said, field.rest)
        complain(item or stream.tree, kind, reason)
        return said, stop
    end

    -- Returns the plain text between two offsets, nil if they have other bytes or less than four characters.
    local function plain_text(text, at, stop)
        return sub(text, at + 1, stop):match("^([\32-\126][\32-\126][\32-\126][\32-\126]+)[\r\n]*\0?$")
    end

    -- Returns why bytes are in no frame. `length` is the length field there, `plain` the text that they are,
    -- `left_over` the number of bytes to the end of the packet if a frame in it ends here, and `is_gap` tells whether
    -- bytes may be missing before them.
    local function reason_of(length, plain, left_over, is_gap)
        if plain then return "no frame can start here: this is text; a Messaging block needs WRITEMAILBOX" end
        local is_possible = not length or is_usual_length(length)
        local reason = "no frame can start here: the length field says %d, but it can be %d to %d"
        if left_over then
            reason = is_possible and "no frame can start here" or format(reason, length, MIN_LENGTH, MAX_LENGTH)
            return reason .. "; " .. phrases.filled(SLIPS.left_over, { bytes = phrases.plural(left_over, "byte") })
        elseif is_possible or is_gap then
            return "bytes that are in no frame" .. (is_gap and ", as after a gap in the capture" or "")
        end
        return format(reason, length, MIN_LENGTH, MAX_LENGTH)
    end

    -- Adds the bytes between two offsets, which are outside of frames. They may belong to a frame that the capture cut,
    -- in this packet or before.
    function streaming.add_no_frame(stream, at, stop, plain, left_over, is_gap)
        local said = plain and format("text, not a frame: %.60s", plain)
            or format("no frame (%s)", phrases.plural(stop - at, "byte"))
        local is_cut = is_cut_by_capture(stream.tvb, stop, stream.pinfo) or stream.pinfo.number > first_cut
        local reason = reason_of(reading.unsigned16(stream.text, at), plain, left_over, is_gap)
        return add_faulty(stream, at, stop, said, is_cut and "cut_by_capture" or "no_boundary", reason)
    end

    -- Finds where a stream that is out of step continues: at a frame, a text, or the end; returns that, and whether
    -- more is needed to decide. The last bytes may be the start of a header if there are at least `least`; nil if
    -- nothing more comes.
    local function next_step(text, at, accepts, least, first, second)
        local place, following = finding.find_step(text, at, accepts, 0, first, second)
        local is_open = least and place ~= nil and not following
        if not place and least then
            place = finding.header_at_end(text, at) or #text
            is_open = place <= #text - least
        end
        if not following and not is_open then place = #text end
        for _, start in ipairs({ UNLOCK.request, UNLOCK.answer }) do
            local hit = find(text, start, at + 1, true)
            if hit and hit - 1 < place then place, is_open = hit - 1, false end
        end
        return place, is_open
    end

    -- The steps of a stream in which a frame must be searched for.
    local LOST = { lost = true, astray = true }

    -- Judges the bytes from an offset on: OURS for a frame that can be dissected, with what is wrong with its length;
    -- PART for one that has to wait, with the bytes it needs, if known, and the step of the stream; nil for no frame.
    local function judge_frame(stream, at)
        local text, step = stream.text, stream.step
        local code, stop = byte(text, at + HEADER_SIZE), stop_of(text, at)
        if LOST[step] then return nil end
        local sent = at < stream.joint and stream.sent
        if at == math.max(stream.joint, stream.start or 0) and stream.reported == #text then sent = #text end
        local slip = finding.slip_of(text, at, sent, stream.is_last or stream.joint + at == 0 and not stream.may_gap)
        if slip then return OURS, slip end
        if stop and not is_length(text, at) then return nil end
        if code and at < stream.joint and stream.may_gap then
            local verdict = finding.judge_split(text, at, stream.accepts, stream.joint, stream.is_last)
            if not verdict then return nil end
            if verdict == PART and stop <= #text then return PART, nil, step end
        elseif code and at < stream.joint and stop ~= #text and stop - LENGTH_FIELD ~= stream.joint
            and finding.is_filled(text, stream.joint, stream.accepts, #text, true) then
            -- Whole frames fill the newest packet: the frame before it, which is incomplete, was before a gap.
            return nil
        end
        if stream.is_last or code and stop <= stream.reported then return OURS end
        -- There may be a gap before it, so it is judged again with each packet.
        if step == "likely" and at == 0 then return PART, nil, step end
        -- At the start of a packet there may be one, too: then the whole next packet tells.
        return PART, at > 0 and stop and stop - stream.reported or nil, step == "text" and step or "sure"
    end

    -- Takes a conversation with a text of WiFi for one of a brick: a request begins it anew.
    local function confirm(conversation, text, at)
        local is_request = sub(text, at + 1, at + #UNLOCK.request) == UNLOCK.request
        if is_request and conversation.number then dialogues.renew(conversation) end
        dialogues.unlock(conversation)
        if conversation.state ~= "sure" then claiming.begin(conversation, "sure") end
    end

    -- Each of these takes what is at an offset: its line and the offset after it; PART if it has to wait; nil if
    -- something else is there.
    local takers = {}

    takers[1] = function(stream, at)
        local text = stream.text
        if not UNLOCK.starts[byte(text, at + 1)] then return nil end
        local said, after = dissect_text(stream, at)
        if not said then return not stream.is_last and is_part_of_text(text, at) and PART or nil end
        stream.step = "text"
        if stream.conversation then confirm(stream.conversation, text, at) end
        return said, after
    end

    takers[2] = function(stream, at)
        local after = LOST[stream.step] and at or after_polls(stream.text, at)
        if after == at or after < #stream.text and not may_start(stream.text, after) then return nil end
        return add_bytes(stream, at, after, "poll", field.padding)
    end

    takers[3] = function(stream, at)
        local tvb, text, captured, pinfo = stream.tvb, stream.text, #stream.text, stream.pinfo
        if at == stream.no_frame_at then return nil end
        local verdict, detail, step = judge_frame(stream, at)
        if verdict == PART then stream.wanted, stream.step = detail, step end
        if verdict ~= OURS then return verdict end
        if captured - at < HEADER_SIZE then
            local kind = is_cut_by_capture(tvb, captured, pinfo) and "cut_by_capture" or "cut_off"
            return add_faulty(stream, at, captured, "part of a frame", kind, "the frame is cut off in its header")
        end
        local after, place = math.min(stop_of(text, at), captured), storage.place_of(stream.number, tvb:offset() + at)
        local message = messages.read_at(text, at)
        message.slip = detail
        -- The bytes after it in the packet are the rest of the next frame.
        if detail then stream.no_frame_at = after end
        if stream.step == "text" then stream.step = "sure" end
        return dissect_message(tvb, at, message, stream.conversation, place, pinfo, stream.tree, stream.brick), after
    end

    takers[4] = function(stream, at)
        local after = stream.step == "text" and end_of_text(stream.text, at)
        if not after then return nil end
        return add_bytes(stream, at, after, "end of the text before", field.rest)
    end

    -- Returns the plain text at an offset in a conversation that is a brick's for sure, if a frame may start there, up
    -- to either of two offsets, and its end.
    local function find_plain(stream, at, stop, after)
        local place, conversation = storage.place_of(stream.number, stream.tvb:offset() + at), stream.conversation
        if conversation and conversation.state == "sure" then streaming.sure_places[place] = true end
        if LOST[stream.step] or not streaming.sure_places[place] then return nil, after end
        local plain = plain_text(stream.text, at, stop)
        return plain or plain_text(stream.text, at, after), plain and stop or after
    end

    -- Bytes that are in no frame; `is_open` tells whether more is needed to decide where they end.
    takers[5] = function(stream, at)
        local text, captured, was_lost, joint = stream.text, #stream.text, LOST[stream.step], stream.joint
        -- After a frame in the same packet this is the sender's fault, and ends with the packet.
        local is_after = at == stream.no_frame_at or not (was_lost or stream.may_gap) and at > 0 and at ~= joint
        local stop = is_after and at < joint and joint or captured
        local least = not (stream.is_last or is_after) and (was_lost or stream.may_gap) and 1
        local found, is_open =
            next_step(sub(text, 1, stop), was_lost and at or at + 1, stream.accepts, least, stream.first, joint)
        local plain, after = find_plain(stream, at, stop, found)
        stream.is_open = is_open and after == found
        local is_gap = stream.may_gap or stream.step == "lost"
        local is_sure = not stream.is_open and (after < captured or plain or is_after)
        stream.step = is_sure and "sure" or is_gap and "lost" or "astray"
        stream.lost = stream.lost + after - at
        local said = after > at and streaming.add_no_frame(stream, at, after, plain, is_after and stop - at, is_gap)
        return said, after
    end

    -- Dissects the frames and texts in a piece of a stream. Returns the offset after the last one that is whole, and
    -- how many bytes the next one wants, nil if its length is not known yet. `stream` has `tvb`, `text`, `number`,
    -- `conversation`, `pinfo`, `tree` and `brick`, and
    --   reported   the size of the piece on the wire, of which a capture may have less
    --   is_last    there is nothing more to wait for
    --   step       "sure" if a frame starts with the piece, "likely" if one does unless there is a gap before it,
    --              "text" if the end of a text may come before; if one is searched for, "lost" after a gap, or
    --              "astray"; afterwards the step at the end
    --   start      how many bytes of it are done, if any
    --   joint      where in the piece the newest packet starts; `first` is 0 if a packet starts with the piece, too
    --   sent       the same, if what was sent before can be all of a frame
    --   may_gap    gaps between the packets go unnoticed
    --   accepts    tells which types go in its direction, if that is known
    --   lost       afterwards: how many bytes are in no frame
    function streaming.dissect(stream)
        local at = stream.start or 0
        stream.lost = 0
        while at < #stream.text do
            local said, after
            for _, take in ipairs(takers) do
                said, after = take(stream, at)
                if said == PART then return at, stream.wanted end
                if after then break end
            end
            if said then say(said) end
            at = after
            if stream.is_open then return at, nil end
        end
        return at, 0
    end
end

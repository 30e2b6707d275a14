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

    -- Adds bytes that are not a frame. Returns their item, nil without a tree.
    local function add_bytes(tvb, at, stop, tree, brick, said, declared)
        if not brick then return nil end
        local range = tvb(at, stop - at)
        local item = add_item(tree, range, brick, said)
        item:add(declared, range)
        return item
    end

    -- Dissects one of the texts: its line, and the offset after it; else nil. The firmware also sends the terminating
    -- zero of its answer, unless that zero is the start of a frame's length.
    local function dissect_text(tvb, text, at, tree, brick)
        local after, serial = match_unlock(text, at)
        if after then
            local item = add_bytes(tvb, at, after, tree, brick, "unlock " .. serial, field.unlock)
            if item then item:add(field.unlock_serial, tvb(at + #UNLOCK.request, #serial)) end
            return "unlock " .. serial, after
        end
        after = at + #UNLOCK.answer
        if sub(text, at + 1, after) ~= UNLOCK.answer then return nil end
        local zero, next = byte(text, after + 1, after + 2)
        if zero == 0 and not (next and is_length(text, after)) then after = after + 1 end
        add_bytes(tvb, at, after, tree, brick, "accepted", field.accept)
        return "accepted", after
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

    local function add_faulty(tvb, at, stop, tree, brick, said, kind, reason)
        complain(add_bytes(tvb, at, stop, tree, brick, said, field.rest) or tree, kind, reason)
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
    function streaming.dissect_no_frame(tvb, at, stop, length, pinfo, tree, brick, plain, left_over, is_gap)
        local said = plain and format("text, not a frame: %.60s", plain)
            or format("no frame (%s)", phrases.plural(stop - at, "byte"))
        local is_cut = is_cut_by_capture(tvb, stop, pinfo) or pinfo.number > first_cut
        local kind = is_cut and "cut_by_capture" or "no_boundary"
        return add_faulty(tvb, at, stop, tree, brick, said, kind, reason_of(length, plain, left_over, is_gap))
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
    local function judge_frame(text, at, stream, step)
        local code, stop = byte(text, at + HEADER_SIZE), stop_of(text, at)
        if LOST[step] then return nil end
        local sent = at < stream.joint and stream.sent
        if at == math.max(stream.joint, stream.start or 0) and stream.reported == #text then sent = #text end
        local slip = finding.slip_of(text, at, sent, stream.is_last)
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

    -- The frames and texts in a piece of a stream: the offset after the last one that is whole; how many bytes the
    -- next one wants, nil if its length is not known yet; how many bytes are in no frame; and the step at the end.
    -- `stream` has
    --   reported   the size of the piece on the wire, of which a capture may have less
    --   is_last    there is nothing more to wait for
    --   step       "sure" if a frame starts with the piece, "likely" if one does unless there is a gap before it,
    --              "text" if the end of a text may come before; if one is searched for, "lost" after a gap, or "astray"
    --   start      how many bytes of it are done, if any
    --   joint      where in the piece the newest packet starts; `first` is 0 if a packet starts with the piece, too
    --   sent       the same, if what was sent before can be all of a frame
    --   may_gap    gaps between the packets go unnoticed
    --   accepts    tells which types go in its direction, if that is known
    function streaming.dissect(tvb, text, stream, conversation, number, pinfo, tree, brick)
        local at, captured, lost, start, step, no_frame_at = stream.start or 0, #text, 0, tvb:offset(), stream.step
        while at < captured do
            local said, after, verdict, wanted, step_then, is_open
            if UNLOCK.starts[byte(text, at + 1)] then
                said, after = dissect_text(tvb, text, at, tree, brick)
                if not said and not stream.is_last and is_part_of_text(text, at) then return at, nil, lost, step end
                if said then step = "text" end
                if said and conversation then confirm(conversation, text, at) end
            end
            local polled = LOST[step] and at or after_polls(text, at)
            if polled > at and (polled == captured or may_start(text, polled)) then
                said, after = "poll", polled
                add_bytes(tvb, at, after, tree, brick, said, field.padding)
            end
            if not said and at ~= no_frame_at then
                verdict, wanted, step_then = judge_frame(text, at, stream, step)
                if verdict == PART then return at, wanted, lost, step_then end
            end
            if verdict == OURS and captured - at < HEADER_SIZE then
                local kind, reason = "cut_off", "the frame is cut off in its header"
                if is_cut_by_capture(tvb, captured, pinfo) then kind = "cut_by_capture" end
                said, after = add_faulty(tvb, at, captured, tree, brick, "part of a frame", kind, reason)
            elseif verdict == OURS then
                after = math.min(stop_of(text, at), captured)
                local message, place = messages.read_at(text, at), storage.place_of(number, start + at)
                message.slip = wanted
                -- The bytes after it in the packet are the rest of the next frame.
                if message.slip then no_frame_at = after end
                said = dissect_message(tvb, at, message, conversation, place, pinfo, tree, brick)
                step = step == "text" and "sure" or step
            elseif not said then
                after = step == "text" and end_of_text(text, at)
                if after then
                    said = "end of the text before"
                    add_bytes(tvb, at, after, tree, brick, said, field.rest)
                else
                    -- After a frame in the same packet this is the sender's fault, and ends with the packet.
                    local was_lost, place = LOST[step], storage.place_of(number, start + at)
                    local is_after = at == no_frame_at
                        or not (was_lost or stream.may_gap) and at > 0 and at ~= stream.joint
                    local stop = is_after and at < stream.joint and stream.joint or captured
                    local least = not (stream.is_last or is_after) and (was_lost or stream.may_gap) and 1
                    local from, piece = was_lost and at or at + 1, sub(text, 1, stop)
                    after, is_open = next_step(piece, from, stream.accepts, least, stream.first, stream.joint)
                    if conversation and conversation.state == "sure" then streaming.sure_places[place] = true end
                    local may_be_text = not was_lost and streaming.sure_places[place]
                    local plain = may_be_text and plain_text(text, at, stop)
                    if plain then after, is_open = stop, false end
                    plain = plain or may_be_text and plain_text(text, at, after)
                    local is_gap = stream.may_gap or step == "lost"
                    local is_sure = not is_open and (after < captured or plain or is_after)
                    step = is_sure and "sure" or is_gap and "lost" or "astray"
                    if after > at then
                        said = streaming.dissect_no_frame(tvb, at, after, reading.unsigned16(text, at), pinfo, tree,
                            brick, plain, is_after and stop - at, is_gap)
                        lost = lost + after - at
                    end
                end
            end
            if said then say(said) end
            if is_open then return after, nil, lost, step end
            at = after
        end
        return at, 0, lost, step
    end
end

-- Streams -----------------------------------------------------------------------------------------------------------
--
-- The byte stream of a TCP connection or of RFCOMM, in which frames may be split over packets and share them, after a
-- text from each side.

local dissect_stream, dissect_no_frame
do
    -- The text by which a host unlocks the brick's port: the offset behind it, and the serial number.
    local function match_unlock(text, at)
        local serial, newline, behind = text:match(UNLOCK_PATTERN, at + 1)
        if not serial then return nil end
        for _ = 1, UNLOCK_ENDINGS do
            if sub(text, behind, behind + #newline - 1) == newline then behind = behind + #newline end
        end
        return behind - 1, serial
    end

    local function dissect_unlock(tvb, text, at, tree)
        local behind, serial = match_unlock(text, at)
        if not behind then return nil end
        local said = "unlock " .. serial
        if has_tree(tree) then
            local range = tvb(at, behind - at)
            local item = add_item(tree, range):set_text("EV3: " .. said)
            item:add(field.unlock, range)
            item:add(field.unlock_serial, tvb(at + #UNLOCK_REQUEST, #serial))
        end
        return said, behind
    end

    -- What the brick answers to it. The firmware sends the text's zero, too: it is one where it cannot be the start of
    -- a frame's length.
    local function dissect_accept(tvb, text, at, tree)
        local behind = at + #ACCEPT
        if sub(text, at + 1, behind) ~= ACCEPT then return nil end
        local zero, next = byte(text, behind + 1, behind + 2)
        if zero == 0 and not (next and is_length(zero, next)) then behind = behind + 1 end
        if has_tree(tree) then
            local range = tvb(at, behind - at)
            add_item(tree, range):set_text("EV3: accepted"):add(field.accept, range)
        end
        return "accepted", behind
    end

    local function dissect_text(tvb, text, at, tree)
        local said, behind = dissect_unlock(tvb, text, at, tree)
        if said then return said, behind end
        return dissect_accept(tvb, text, at, tree)
    end

    local function starts_with(text, start)
        return sub(text, 1, #start) == start
    end

    -- Whether one of the texts may have begun here, and goes on in the next segment.
    local function is_part_of_text(text, at)
        local part = sub(text, at + 1)
        if starts_with(ACCEPT, part) or starts_with(UNLOCK_REQUEST, part) then return true end
        return #part < MOST_UNLOCK and starts_with(part, UNLOCK_REQUEST)
    end

    -- What is left of a text that came in an earlier segment: its line ends, or the zero behind the answer. A faulty
    -- frame may start like that, too: so only whole frames may follow.
    local function end_of_text(text, at)
        local behind = at == 0 and (text:match("^[\r\n]+()") or text:match("^\0()"))
        at = behind and behind - 1
        local next = at
        while next and next < #text do
            local low, high, _, _, type = byte(text, next + 1, next + HEADER_SIZE)
            if not type or not is_length(low, high) or not MESSAGE_TYPES[type] then return nil end
            next = next + LENGTH_FIELD + low + high * 0x100
        end
        return next == #text and at or nil
    end

    local function dissect_end_of_text(tvb, at, behind, tree)
        if has_tree(tree) then
            local range = tvb(at, behind - at)
            add_item(tree, range):set_text("EV3: end of the text before"):add(field.rest, range)
        end
        return "end of the text before", behind
    end

    local function add_faulty(tvb, at, stop, tree, said, kind, reason)
        local item
        if has_tree(tree) then
            local range = tvb(at, stop - at)
            item = add_item(tree, range):set_text("EV3: " .. said)
            item:add(field.rest, range)
        end
        complain(item or tree, kind, reason)
        return said, stop
    end

    -- Nobody knows where the next frame starts: the packet is lost, the next one is looked at anew.
    function dissect_no_frame(tvb, at, stop, length, tree)
        local said = format("no frame (%s)", plural(stop - at, "byte"))
        local reason = "no frame can start here: its length field would say %d, a frame has %d to %d bytes after it"
        return add_faulty(tvb, at, stop, tree, said, "no_boundary", format(reason, length, MIN_LENGTH, MAX_LENGTH))
    end

    -- The frames and texts in a piece of a stream: the offset behind the last one that is whole, how many bytes the
    -- next one wants (nil where its length is not known yet), and what was said. `reported` is the size of the piece
    -- on the wire, of which a capture may have less; with `is_last` there is nothing more to wait for.
    function dissect_stream(tvb, text, reported, key, pinfo, tree, is_last)
        local at, captured, all = 0, #text, nil
        while at < captured do
            local low, high = byte(text, at + 1, at + 2)
            local said, behind
            if TEXT_STARTS[low] then
                said, behind = dissect_text(tvb, text, at, tree)
                if not said and not is_last and is_part_of_text(text, at) then return at, nil, all end
            end
            if not said then
                local size = high and LENGTH_FIELD + low + high * 0x100
                if size and not is_length(low, high) then
                    behind = end_of_text(text, at)
                    if behind then
                        said, behind = dissect_end_of_text(tvb, at, behind, tree)
                    else
                        said, behind = dissect_no_frame(tvb, at, captured, size - LENGTH_FIELD, tree)
                    end
                elseif not is_last and (not size or at + size > reported) then
                    return at, size and at + size - reported, all
                elseif captured - at < HEADER_SIZE then
                    local reason = "the frame is cut off in its header"
                    said, behind = add_faulty(tvb, at, captured, tree, "part of a frame", "cut_off", reason)
                else
                    behind = math.min(at + size, captured)
                    local frame = at == 0 and behind == captured and text or sub(text, at + 1, behind)
                    said = dissect_message(tvb, at, read_message(frame), key, pinfo, tree)
                end
            end
            all = all and all .. "; " .. said or said
            at = behind
        end
        return at, 0, all
    end
end

-- Dialogues ---------------------------------------------------------------------------------------------------------
--
-- Which reply answers which command, and which file is on its way. Wireshark dissects all packets once in their order
-- and afterwards whichever one is looked at: what is found out the first time is kept as a note on each message, and
-- later passes only read these notes.

local forget_dialogues, place_of, note_at, take_note
do
    -- Commands with one counter that are remembered, for senders who never change it.
    local MOST_PER_COUNTER = 4

    local talks, notes

    function forget_dialogues()
        talks, notes = {}, {}
    end
    forget_dialogues()

    -- All that is known of the messages between one computer and one brick.
    local function talk_of(key)
        local talk = talks[key]
        if not talk then
            talk = { pending = {}, begun = {}, transfers = {} }
            talks[key] = talk
        end
        return talk
    end

    -- Where a message stands in the capture, as a key: no two messages share it, and every pass finds the same.
    function place_of(number, offset)
        return number * 0x100000 + offset
    end

    function note_at(place)
        return notes[place]
    end

    -- What a reply has in common with the command it answers.
    local function pending_key(message)
        return message.type.carries .. message.counter
    end

    local function remember(talk, message, pinfo)
        local note = { number = pinfo.number, time = pinfo.rel_ts, text = message.text }
        local key = pending_key(message)
        local waiting = talk.pending[key]
        if not waiting then
            talk.pending[key] = { note }
        else
            waiting[#waiting + 1] = note
            if #waiting > MOST_PER_COUNTER then table.remove(waiting, 1) end
        end
        return note
    end

    local function can_answer(message, note)
        return message.type.carries ~= "system" or byte(note.text, HEADER_SIZE + 1) == byte(message.text, HEADER_SIZE + 1)
    end

    local function asked_globals(text)
        local low, high = byte(text, HEADER_SIZE + 1, HEADER_SIZE + 2)
        return high and (low + high * 0x100) % (GLOBAL_MASK + 1)
    end

    -- Whether a reply has just the size that was asked for.
    local function fits(message, note)
        return message.type.carries ~= "direct" or message.type.is_error
            or message.size - HEADER_SIZE == asked_globals(note.text)
    end

    -- The command that a reply answers: of those with its counter the newest of the right size, else the newest. The
    -- newest, because a sender comes back to a counter only after it gave up on the one before.
    local function answered(talk, message)
        local key = pending_key(message)
        local waiting = talk.pending[key]
        if not waiting then return nil end
        local best
        for index = #waiting, 1, -1 do
            if can_answer(message, waiting[index]) then
                if fits(message, waiting[index]) then
                    best = index
                    break
                end
                best = best or index
            end
        end
        if not best then return nil end
        local note = table.remove(waiting, best)
        if #waiting == 0 then talk.pending[key] = nil end
        return note
    end

    local function snapshot(transfer)
        return transfer and { path = transfer.path, size = transfer.size, done = transfer.done }
    end

    -- The file that a system command is about, as far as it is now.
    local function follow_request(talk, message)
        local command, values = message.command, message.fields
        if not command or not command.transfer then return nil end
        if command.transfer == "begin" then
            local transfer = { path = values.path or "", size = values.size, done = 0 }
            talk.begun[message.counter] = transfer
            return transfer
        end
        local transfer = talk.transfers[values.handle]
        if transfer and values.data then transfer.done = transfer.done + #values.data end
        return transfer
    end

    -- The same for a reply.
    local function follow_reply(talk, message, request)
        local command, values = message.command, message.fields
        if not command or not command.transfer then return nil end
        local failed = message.type.is_error or STATUS_FAILS[message.status] ~= false
        local transfer
        if command.transfer == "begin" then
            transfer = talk.begun[message.counter]
            talk.begun[message.counter] = nil
            if failed or not values.handle then return transfer end
            -- Where the command was not seen, the handle stands for another file than before all the same.
            talk.transfers[values.handle] = transfer
        else
            local handle = values.handle or (request and request.handle)
            transfer = handle and talk.transfers[handle]
            -- The brick takes a handle back when a file is closed, complete or in trouble.
            if handle and (command.transfer == "close" or failed or message.status == END_OF_FILE) then
                talk.transfers[handle] = nil
            end
        end
        if transfer then
            transfer.size = values.size or values.list_size or transfer.size
            transfer.done = transfer.done + #(values.data or "") + #(values.list or "")
        end
        return transfer
    end

    -- What becomes known of a message when it is seen for the first time. `key` tells which conversation it belongs to.
    function take_note(place, key, message, pinfo)
        local type = message.type
        if not type or message.is_overwritten then return end
        if type.is_command and not type.wants_reply and type.carries ~= "system" then return end
        local talk, note = talk_of(key(pinfo)), nil
        if type.is_command then
            if type.wants_reply then note = remember(talk, message, pinfo) end
            if type.carries == "system" then
                local transfer = follow_request(talk, message)
                if transfer then
                    note = note or {}
                    note.transfer, note.handle = snapshot(transfer), message.fields.handle
                end
            end
        else
            note = {}
            local request = answered(talk, message)
            if request then
                request.reply = pinfo.number
                note.request = request
                note.time = pinfo.rel_ts - request.time
            end
            if type.carries == "system" then
                note.transfer = snapshot(follow_reply(talk, message, request))
            end
        end
        notes[place] = note
    end
end

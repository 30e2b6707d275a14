-- Dialogues ---------------------------------------------------------------------------------------------------------
--
-- Which reply answers which command, and which file is on its way. Wireshark dissects all packets once in their order
-- and afterwards whichever one is looked at: what is found out the first time is kept, by the place of each message,
-- and later passes only look it up.

local forget_dialogues, place_of, talk_of, talk_if_any, take_note, request_of, reply_to, transfer_at, answers_command
do
    -- Commands with one counter that are remembered, for senders who never change it.
    local MOST_PER_COUNTER = 4

    -- A message's place is the number of its packet and its offset there, in one number.
    local OFFSETS = 0x100000

    local CARRIES = { direct = 0x000000, system = 0x010000, daisy = 0x020000 }

    -- Of commands that want a reply: the frame, the time, the place of the reply. Of replies: the place of the command,
    -- the time that it took. Of messages on files: the file and how far it is. A long capture has a great many of
    -- these: as plain numbers and strings they cost far less to keep than as a table each.
    local frames, times, replies, requests, delays, transfers
    local talks

    function forget_dialogues()
        frames, times, replies, requests, delays, transfers = {}, {}, {}, {}, {}, {}
        talks = {}
    end
    forget_dialogues()

    function place_of(number, offset)
        return number * OFFSETS + offset
    end

    local function number_of(place)
        return place and floor(place / OFFSETS)
    end

    -- The command that a reply answers: its frame, the number of its packet, the time that the reply took in seconds.
    function request_of(place)
        local request = requests[place]
        return frames[request], number_of(request), delays[place]
    end

    -- Whether a command wants a reply, and the number of the packet with it.
    function reply_to(place)
        return frames[place] ~= nil, number_of(replies[place])
    end

    -- The file that a message is about: path, size, bytes done.
    function transfer_at(place)
        return transfers[place]
    end

    -- All that is known of the messages between one computer and one brick, who have that key.
    function talk_of(key)
        local talk = talks[key]
        if not talk then
            talk = { key = key, pending = {}, begun = {}, open = {} }
            talks[key] = talk
        end
        return talk
    end

    -- What a reply has in common with the command it answers.
    local function pending_key(message)
        return CARRIES[message.type.carries] + message.counter
    end

    -- The same, where anything is known of them.
    function talk_if_any(key)
        return talks[key]
    end

    -- Mostly one command waits under its counter: its place alone is kept then, else a list of them.
    local function remember(talk, place, message, pinfo)
        frames[place], times[place] = message.text, pinfo.rel_ts
        local pending, key = talk.pending, pending_key(message)
        local waiting = pending[key]
        if not waiting then
            pending[key] = place
        elseif type(waiting) == "number" then
            pending[key] = { waiting, place }
        else
            waiting[#waiting + 1] = place
            if #waiting > MOST_PER_COUNTER then table.remove(waiting, 1) end
        end
    end

    local function can_answer(message, frame)
        return message.type.carries ~= "system" or byte(frame, HEADER_SIZE + 1) == byte(message.text, HEADER_SIZE + 1)
    end

    -- Whether a reply has just the size that was asked for.
    local function fits(message, frame)
        local type = message.type
        if type.carries ~= "direct" or type.is_error or #frame < COMMAND_HEADER_SIZE then return true end
        return message.size - HEADER_SIZE == unsigned16(frame, HEADER_SIZE) % (GLOBAL_MASK + 1)
    end

    -- The place of the command that a reply answers: of those with its counter the newest of the right size, else the
    -- newest. The newest, because a sender comes back to a counter only after it gave up on the one before.
    local function answered(talk, message)
        local pending, key = talk.pending, pending_key(message)
        local waiting = pending[key]
        if type(waiting) ~= "table" then
            if not waiting or not can_answer(message, frames[waiting]) then return nil end
            pending[key] = nil
            return waiting
        end
        local best
        for index = #waiting, 1, -1 do
            local frame = frames[waiting[index]]
            if can_answer(message, frame) then
                best = best or index
                if fits(message, frame) then
                    best = index
                    break
                end
            end
        end
        if not best then return nil end
        local place = table.remove(waiting, best)
        if #waiting == 0 then pending[key] = nil end
        return place
    end

    -- The file that a system command is about, as far as it is now.
    local function follow_request(talk, message)
        local command, values = message.command, message.fields
        if command.transfer == "begin" then
            local transfer = { path = values.path or "", size = values.size, done = 0 }
            talk.begun[message.counter] = transfer
            return transfer
        end
        local transfer = talk.open[values.handle]
        if transfer and values.data then
            if counts_all then keep_piece(transfer, values.data) end
            transfer.done = transfer.done + #values.data
        end
        return transfer
    end

    -- The handle that a command for an open file has as its first field.
    local function asked_handle(frame)
        return frame and byte(frame, HEADER_SIZE + 2)
    end

    -- The same for a reply. `request` is the frame of the command that it answers.
    local function follow_reply(talk, message, request)
        local command, values = message.command, message.fields
        local failed = message.type.is_error or STATUS_FAILS[message.status] ~= false
        local transfer
        if command.transfer == "begin" then
            transfer = talk.begun[message.counter]
            talk.begun[message.counter] = nil
            if failed or not values.handle then return transfer end
            -- Where the command was not seen, the handle stands for another file than before all the same.
            talk.open[values.handle] = transfer
        else
            local handle = values.handle or asked_handle(request)
            transfer = handle and talk.open[handle]
            -- The brick takes a handle back when a file is closed, complete or in trouble.
            if handle and (command.transfer == "close" or failed or message.status == END_OF_FILE) then
                talk.open[handle] = nil
            end
        end
        if transfer then
            if counts_all and not values.list then keep_piece(transfer, values.data) end
            transfer.size = values.size or values.list_size or transfer.size
            transfer.done = transfer.done + #(values.data or "") + #(values.list or "")
        end
        return transfer
    end

    -- Whether a command waits for this reply.
    function answers_command(talk, message)
        local waiting = talk.pending[pending_key(message)]
        if type(waiting) == "table" then waiting = waiting[#waiting] end
        return waiting ~= nil and can_answer(message, frames[waiting])
    end

    -- What becomes known of a message when it is seen for the first time, in the conversation it belongs to.
    function take_note(place, talk, message, pinfo)
        local type = message.type
        local is_on_file = message.command and message.command.transfer
        if not type or message.is_overwritten then return end
        if counts_all then count_message(talk, message) end
        if type.is_command and not type.wants_reply and not is_on_file then return end
        local transfer, request
        if type.is_command then
            if type.wants_reply then remember(talk, place, message, pinfo) end
            transfer = is_on_file and follow_request(talk, message)
        else
            request = answered(talk, message)
            if request then
                replies[request], requests[place] = place, request
                delays[place] = pinfo.rel_ts - times[request]
                if counts_all then count_answer(talk, message, frames[request], delays[place]) end
                times[request] = nil
            end
            transfer = is_on_file and follow_reply(talk, message, frames[request])
        end
        if transfer then
            transfers[place] = { path = transfer.path, size = transfer.size, done = transfer.done }
        end
    end
end

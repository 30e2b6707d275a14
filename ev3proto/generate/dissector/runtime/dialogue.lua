-- Dialogues ---------------------------------------------------------------------------------------------------------
--
-- Which reply answers which command, and which file is on its way. Wireshark dissects all packets once in their order
-- and afterwards whichever one is looked at: what is found out the first time is kept, by the place of each message,
-- and later passes only look it up.

local forget_dialogues, talk_of, talk_if_any, take_note, request_of, reply_to, transfer_at, answers_command
do
    -- Commands with one counter that are remembered, for senders who never change it.
    local MOST_PER_COUNTER = 4

    -- Commands of one conversation that may wait for their replies. Beyond twice as many the oldest are given up: a
    -- brick has one answer after the other. So many of them are at hand; the others, whose replies are missing nearly
    -- always, are kept outside of Lua, which goes through all that it holds whenever it frees something.
    local MOST_WAITING, MOST_AT_HAND = 4096, 128

    local pack, unpack = Struct.pack, Struct.unpack
    local put_aside = memory.new_texts()

    local CARRIES = { direct = 0x000000, system = 0x010000, daisy = 0x020000 }

    -- Of a command that has a reply: the number of the packet with it.
    local replies = memory.new_notes(1)

    -- Of a reply that has a command: the place of that, the seconds that the reply took, and all that follows the
    -- command's header.
    local requests, bodies = memory.new_notes(3), memory.new_texts()

    -- Of a message on a file: the file's path, by its number here, the bytes done, and the size; -1 where that is not
    -- known.
    local transfers = memory.new_notes(3)
    local paths

    -- The command that the message before this one answered, and the place of that message.
    local answer, answer_place

    local talks

    function forget_dialogues()
        replies.forget()
        requests.forget()
        transfers.forget()
        bodies.forget()
        put_aside.forget()
        paths, talks, answer, answer_place = {}, {}, nil, nil
    end
    forget_dialogues()

    -- The command that a reply answers: `place`, `body`, what follows its header, `delay`, the seconds that the reply
    -- took.
    function request_of(place)
        if place == answer_place then return answer end
        local command, delay, body = requests.get(place)
        return command and { place = command, delay = delay, body = bodies.get(body) }
    end

    -- The number of the packet with the reply to a command.
    function reply_to(place)
        local number = replies.get(place)
        return number and floor(number)
    end

    -- The file that a message is about: path, size, bytes done.
    function transfer_at(place)
        local path, done, size = transfers.get(place)
        if not path then return nil end
        return { path = paths[path], done = floor(done), size = size >= 0 and floor(size) or nil }
    end

    -- All that is known of the messages between one computer and one brick, who have that key.
    function talk_of(key)
        local talk = talks[key]
        if not talk then
            talk = {
                key = key, pending = {}, count = 0, waiting = {}, waiting_before = {}, waiting_count = 0, begun = {},
                open = {},
            }
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

    -- Puts away the commands at hand, each as the number of a text; the few with another one of their counter before
    -- them as they are.
    local function put_away(talk)
        if talk.waiting_count + MOST_AT_HAND > MOST_WAITING then
            talk.waiting, talk.waiting_before, talk.waiting_count = {}, talk.waiting, 0
        end
        local waiting = talk.waiting
        for key, command in pairs(talk.pending) do
            waiting[key] = command.earlier and command
                or put_aside.put(pack("dd", command.place, command.time) .. command.body)
        end
        talk.waiting_count = talk.waiting_count + talk.count
        talk.pending, talk.count = {}, 0
    end

    local function read_command(number)
        local text = put_aside.get(number)
        local place, time, stop = unpack("dd", text)
        return { place = place, time = time, body = sub(text, stop), delay = 0 }
    end

    -- The newest command that waits under a counter; each knows the one before it. One that was put away is at hand
    -- again.
    local function newest(talk, key)
        local command = talk.pending[key]
        if command then return command end
        command = talk.waiting[key] or talk.waiting_before[key]
        if not command then return nil end
        if talk.waiting[key] then talk.waiting_count = talk.waiting_count - 1 end
        talk.waiting[key], talk.waiting_before[key] = nil, nil
        if type(command) == "number" then command = read_command(command) end
        talk.pending[key], talk.count = command, talk.count + 1
        return command
    end

    -- `command` is the newest one now, if there is any.
    local function put_newest(talk, key, command)
        talk.pending[key] = command
        if not command then talk.count = talk.count - 1 end
    end

    -- Puts the commands before one after it, as many as are remembered.
    local function put_earlier(command, earlier)
        command.earlier = earlier
        local oldest = command
        for _ = 2, MOST_PER_COUNTER do
            oldest = oldest.earlier
            if not oldest then break end
        end
        if oldest then oldest.earlier = nil end
    end

    local function remember(talk, place, message, pinfo)
        local key = pending_key(message)
        -- Of a system command its number and handle are enough.
        local body = message.body or sub(message.text, HEADER_SIZE + 1, HEADER_SIZE + 2)
        -- The table of a command that has its reply serves again: of that all is noted.
        local command = answer
        if command then
            answer, answer_place = nil, nil
            command.place, command.time, command.body = place, pinfo.rel_ts, body
        else
            command = { place = place, time = pinfo.rel_ts, body = body, delay = 0 }
        end
        local earlier = newest(talk, key)
        if earlier then put_earlier(command, earlier) end
        if not earlier then
            if talk.count >= MOST_AT_HAND then put_away(talk) end
            talk.count = talk.count + 1
        end
        talk.pending[key] = command
    end

    local function can_answer(message, body)
        return message.type.carries ~= "system" or byte(body, 1) == byte(message.text, HEADER_SIZE + 1)
    end

    -- Whether a reply has just the size that was asked for.
    local function fits(message, body)
        local type = message.type
        if type.carries ~= "direct" or type.is_error or #body < MEMORY_FIELD then return true end
        return message.size - HEADER_SIZE == unsigned16(body, 0) % (GLOBAL_MASK + 1)
    end

    -- Whether a reply shows that both are messages of ours: only a brick gives just the size that was asked for.
    local function is_proof(message, body)
        local type, size = message.type, message.size
        if message.fault or type.carries == "daisy" or #body < MEMORY_FIELD then return false end
        if type.is_error and type.carries == "direct" then return size == HEADER_SIZE end
        return fits(message, body)
    end

    -- The command that a reply answers: of those with its counter the newest of the right size, else the newest. The
    -- newest, because a sender comes back to a counter only after it gave up on the one before.
    local function answered(talk, message)
        local key = pending_key(message)
        local command, later = newest(talk, key), nil
        local best, later_than_best
        while command do
            if can_answer(message, command.body) then
                local is_right = not command.earlier and not best or fits(message, command.body)
                if is_right or not best then best, later_than_best = command, later end
                if is_right then break end
            end
            command, later = command.earlier, command
        end
        if not best then return nil end
        if later_than_best then
            later_than_best.earlier = best.earlier
        else
            put_newest(talk, key, best.earlier)
        end
        return best
    end

    -- Adds a piece to a file and returns that. One that is complete takes no more, as the brick has closed it: then the
    -- handle stands for another one, of which the beginning is missing in the capture, and nothing is known.
    local function add_piece(talk, handle, transfer, piece)
        if #piece > 0 and transfer.size and transfer.done >= transfer.size then
            talk.open[handle] = nil
            return nil
        end
        transfer.done = transfer.done + #piece
        return transfer
    end

    -- The file that a system command is about, as far as it is now.
    local function follow_request(talk, message)
        local command, values = message.command, message.fields
        if command.transfer == "begin" then
            paths[#paths + 1] = values.path or ""
            local transfer = { number = #paths, path = values.path or "", size = values.size, done = 0 }
            talk.begun[message.counter] = transfer
            return transfer
        end
        local transfer = talk.open[values.handle]
        if not transfer or not values.data then return transfer end
        transfer = add_piece(talk, values.handle, transfer, values.data)
        if transfer and counts_all then statistics.keep_piece(transfer, values.data) end
        return transfer
    end

    -- The handle that a command for an open file has as its first field.
    local function asked_handle(body)
        return body and byte(body, 2)
    end

    -- The same for a reply. `request` is what follows the header of the command that it answers.
    local function follow_reply(talk, message, request)
        local command, values = message.command, message.fields
        local failed = message.type.is_error or STATUS.fails[message.status] ~= false
        local handle, transfer = values.handle or asked_handle(request), nil
        if command.transfer == "begin" then
            transfer = talk.begun[message.counter]
            talk.begun[message.counter] = nil
            if failed or not values.handle then return transfer end
            -- Where the command was not seen, the handle stands for another file than before all the same.
            talk.open[handle] = transfer
        else
            transfer = handle and talk.open[handle]
            -- The brick takes a handle back when a file is closed, complete or in trouble.
            if handle and (command.transfer == "close" or failed or message.status == STATUS.end_of_file) then
                talk.open[handle] = nil
            end
        end
        if not transfer then return nil end
        transfer.size = values.size or values.list_size or transfer.size
        transfer = add_piece(talk, handle, transfer, values.data or values.list or "")
        if transfer and counts_all and not values.list then statistics.keep_piece(transfer, values.data or "") end
        return transfer
    end

    -- Whether a command waits for this reply.
    function answers_command(talk, message)
        local command = newest(talk, pending_key(message))
        return command ~= nil and can_answer(message, command.body)
    end

    -- What becomes known of a message when it is seen for the first time, in the conversation it belongs to.
    function take_note(place, talk, message, pinfo)
        local type = message.type
        local is_on_file = message.command and message.command.transfer
        if not type or message.is_overwritten then return end
        if counts_all then statistics.count_message(talk, message) end
        if type.is_command and not type.wants_reply and not is_on_file then return end
        local transfer
        if type.is_command then
            if type.wants_reply then remember(talk, place, message, pinfo) end
            transfer = is_on_file and follow_request(talk, message)
        else
            local request = answered(talk, message)
            if request then
                request.delay = pinfo.rel_ts - request.time
                if request.earlier then request.earlier = nil end
                talk.is_proven = talk.is_proven or is_proof(message, request.body)
                replies.put(request.place, number_of(place))
                requests.put(place, request.place, request.delay, bodies.put(request.body))
                answer, answer_place = request, place
                if counts_all then statistics.count_answer(talk, message, request.body, request.delay) end
            end
            transfer = is_on_file and follow_reply(talk, message, request and request.body)
        end
        if transfer then
            transfers.put(place, transfer.number, transfer.done, transfer.size or -1)
        end
    end
end

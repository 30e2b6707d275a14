-- Dialogues ---------------------------------------------------------------------------------------------------------
--
-- Which reply answers which command, and which file is on its way. Wireshark dissects all packets once in their order
-- and afterwards whichever one is looked at: what is found out the first time is kept, by the place of each message,
-- and later passes only look it up.

local read_message
local forget_dialogues, conversation_of, known_conversation, take_note, request_of, reply_to, transfer_at
do
    -- Commands with one counter that are remembered, for senders who never change it.
    local MOST_PER_COUNTER = 4

    -- Commands of one conversation that may wait for their replies. Beyond twice as many the oldest are given up: a
    -- brick has one answer after the other.
    local MOST_WAITING = 4096

    local CARRIES = { direct = 0x000000, system = 0x010000, daisy = 0x020000 }

    -- By place: of a command the number of the packet with its reply; of a reply the place of its command, the seconds
    -- that it took, and the command's frame, in one text; of a message on a file what is known of that.
    local replies, requests, transfers

    local conversations

    function forget_dialogues()
        replies, requests, transfers, conversations = new_notes(), new_notes(), {}, {}
    end
    forget_dialogues()

    -- The command that a reply answers: `place`, `message`, and `delay`, the seconds that the reply took.
    function request_of(place)
        local known = requests.get(place)
        if not known then return nil end
        local command, delay, start = Struct.unpack("dd", known)
        return { place = command, delay = delay, message = read_message(sub(known, start)) }
    end

    -- The number of the packet with the reply to a command.
    function reply_to(place)
        local number = replies.get(place)
        return number and tonumber(number)
    end

    -- The file that a message is about: path, size, bytes done.
    function transfer_at(place)
        return transfers[place]
    end

    -- All that is known of the messages between one computer and one brick, who have that key: the commands that wait
    -- for replies, by counter, each list oldest first, and what waited `before` those; transfers `begun` by counter,
    -- and `open` by handle.
    function conversation_of(key)
        local conversation = conversations[key]
        if not conversation then
            conversation = { key = key, waiting = {}, waiting_count = 0, waiting_before = {}, begun = {}, open = {} }
            conversations[key] = conversation
        end
        return conversation
    end

    -- The same, where anything is known of them.
    function known_conversation(key)
        return conversations[key]
    end

    -- What a reply has in common with the command it answers.
    local function pending_key(message)
        return CARRIES[message.type.carries] + message.counter
    end

    local function remember(conversation, place, message, pinfo)
        local key = pending_key(message)
        local commands = conversation.waiting[key]
        if not commands then
            if conversation.waiting_count == MOST_WAITING then
                conversation.waiting, conversation.waiting_before = {}, conversation.waiting
                conversation.waiting_count = 0
            end
            commands = conversation.waiting_before[key] or {}
            conversation.waiting[key] = commands
            conversation.waiting_count = conversation.waiting_count + 1
        end
        if #commands == MOST_PER_COUNTER then table.remove(commands, 1) end
        commands[#commands + 1] = { place = place, time = pinfo.rel_ts, message = message }
    end

    local function can_answer(message, command)
        if message.type.carries ~= "system" then return true end
        return byte(command.message.text, HEADER_SIZE + 1) == byte(message.text, HEADER_SIZE + 1)
    end

    -- Whether a reply has just the size that was asked for.
    local function fits(message, command)
        local type, sizes = message.type, unsigned16(command.message.text, HEADER_SIZE)
        if type.carries ~= "direct" or type.is_error or not sizes then return true end
        return message.size - HEADER_SIZE == sizes % (GLOBAL_MASK + 1)
    end

    -- Whether a reply shows that both are messages of ours: only a brick gives just the size that was asked for.
    local function is_proof(message, command)
        local type, size = message.type, message.size
        if message.fault or type.carries == "daisy" then return false end
        if type.carries == "direct" and command.message.stop < COMMAND_HEADER_SIZE then return false end
        if type.is_error and type.carries == "direct" then return size == HEADER_SIZE end
        return fits(message, command)
    end

    -- The command that a reply answers: of those with its counter the newest of the right size, else the newest. The
    -- newest, because a sender comes back to a counter only after it gave up on the one before.
    local function answered(conversation, message)
        local key, best = pending_key(message), nil
        local commands = conversation.waiting[key] or conversation.waiting_before[key] or {}
        for index = #commands, 1, -1 do
            if can_answer(message, commands[index]) then
                best = best or index
                if fits(message, commands[index]) then
                    best = index
                    break
                end
            end
        end
        return best and table.remove(commands, best)
    end

    -- Adds a piece to a file and returns that. One that is complete takes no more, as the brick has closed it: then the
    -- handle stands for another one, of which the beginning is missing in the capture, and nothing is known.
    local function add_piece(conversation, handle, transfer, piece)
        if #piece > 0 and transfer.size and transfer.done >= transfer.size then
            conversation.open[handle] = nil
            return nil
        end
        transfer.done = transfer.done + #piece
        return transfer
    end

    -- The file that a system command is about, as far as it is now.
    local function follow_request(conversation, message)
        local command, values = message.command, message.fields
        if command.transfer == "begin" then
            local transfer = { path = values.path or "", size = values.size, done = #(values.data or "") }
            conversation.begun[message.counter] = transfer
            return transfer
        end
        local transfer = conversation.open[values.handle]
        if not transfer or not values.data then return transfer end
        return add_piece(conversation, values.handle, transfer, values.data)
    end

    -- The handle that a command for an open file has as its first field.
    local function asked_handle(command)
        return command and byte(command.message.text, HEADER_SIZE + 2)
    end

    -- The same for a reply. `request` is the command that it answers, where that was seen.
    local function follow_reply(conversation, message, request)
        local command, values = message.command, message.fields
        local failed = message.type.is_error or STATUS.fails[message.status] ~= false
        local handle, transfer = values.handle or asked_handle(request), nil
        if command.transfer == "begin" then
            transfer = conversation.begun[message.counter]
            conversation.begun[message.counter] = nil
            if failed or not values.handle then return transfer end
            -- Where the command was not seen, the handle stands for another file than before all the same.
            conversation.open[handle] = transfer
        else
            transfer = handle and conversation.open[handle]
            -- The brick takes a handle back when a file is closed, complete or in trouble.
            if handle and (command.transfer == "close" or failed or message.status == STATUS.end_of_file) then
                conversation.open[handle] = nil
            end
        end
        if not transfer then return nil end
        transfer.size = values.size or values.list_size or transfer.size
        return add_piece(conversation, handle, transfer, values.data or values.list or "")
    end

    -- What becomes known of a message when it is seen for the first time, in the conversation it belongs to.
    function take_note(place, conversation, message, pinfo)
        local type = message.type
        local is_on_file = message.command and message.command.transfer
        if not type or message.is_overwritten then return end
        if type.is_command and not type.wants_reply and not is_on_file then return end
        local transfer
        if type.is_command then
            if type.wants_reply then remember(conversation, place, message, pinfo) end
            transfer = is_on_file and follow_request(conversation, message)
        else
            local request = answered(conversation, message)
            if request then
                local text = request.message.text
                request.delay, message.request = pinfo.rel_ts - request.time, request
                conversation.is_answered = conversation.is_answered or is_proof(message, request)
                replies.put(request.place, format("%d", number_of(place)))
                -- Of a system command its number is enough.
                if message.command then text = sub(text, 1, HEADER_SIZE + 1) end
                requests.put(place, Struct.pack("dd", request.place, request.delay) .. text)
            end
            transfer = is_on_file and follow_reply(conversation, message, request)
        end
        if transfer then
            transfers[place] = { path = transfer.path, done = transfer.done, size = transfer.size }
        end
    end
end

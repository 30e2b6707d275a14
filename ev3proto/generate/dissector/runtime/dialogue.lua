-- Dialogues ---------------------------------------------------------------------------------------------------------
--
-- Which reply answers which command, and which file a message belongs to. Wireshark dissects all packets once in order,
-- and afterwards those that are displayed. What the first pass finds is kept by the place of each message; later passes
-- look it up.

-- The functions that read and show one message are defined below.
local messages = {}

local dialogues = {}
do
    local CARRIES = { direct = 0x000000, system = 0x010000, daisy = 0x020000 }
    local NUMBERS = 0x040000

    -- Nanoseconds of a conversation after which a command has no reply.
    local GIVEN_UP = 1e9

    -- By the number of a command that wants a reply, from 1: its place, that of its reply or false, its time in
    -- nanoseconds or, once it is answered, the response time, its conversation until then, the bytes after the type.
    -- `of_packet` has the number for the first message of a packet, `others` for others, by place. Of few: `unsure`, by
    -- number, if several commands waited; by place, the `transfers` of files, and the `locks` of connections.
    local asked, answers, times, bodies, owners, of_packet, others, unsure, transfers, locks, count

    -- One string for equal bodies; conversations by key, the number of the newest one, and by packet that of its
    -- conversation, if it is not the first.
    local shared, conversations, newest_number, numbers

    function dialogues.forget()
        asked, answers, times, bodies, owners, of_packet, others, unsure = {}, {}, {}, {}, {}, {}, {}, {}
        transfers, locks = {}, {}
        count, shared, conversations, newest_number, numbers = 0, {}, {}, 0, {}
    end

    local function set_number(place, number)
        local packet = storage.number_of(place)
        if of_packet[packet] then
            others[place] = number
        else
            of_packet[packet] = number
        end
    end

    local function number_at(place)
        local number = of_packet[storage.number_of(place)]
        return number and (asked[number] == place or answers[number] == place) and number or others[place]
    end

    -- Returns the command that a reply answers: its `place`, the `delay` of the reply in nanoseconds, the `body`, the
    -- bytes after the type (of a system command those that matter here), and whether it `is_unsure`.
    function dialogues.request_of(place)
        local at = number_at(place)
        return at and { place = asked[at], delay = times[at], body = bodies[at], is_unsure = unsure[at] }
    end

    -- Returns the number of the packet with the reply to a command; without one, nil and whether none is expected.
    function dialogues.reply_to(place)
        local at = number_at(place)
        if at and answers[at] then return storage.number_of(answers[at]) end
        return nil, at ~= nil and owners[at].newest - times[at] > GIVEN_UP
    end

    -- Returns the file that a message belongs to: path, size, and bytes done.
    function dialogues.transfer_at(place)
        return transfers[place]
    end

    -- Returns what is wrong with the size of the file that a message belongs to, nil if nothing is. That the file has
    -- no further message is known only after the first pass.
    function dialogues.trouble_at(place, is_new)
        local now = transfers[place]
        local file = now and now.file
        if not file or file.is_listing or not now.size or now.done == now.size then return nil end
        if now.done > now.size then return now.is_longer and phrases.filled(FILES.longer, now) or nil end
        local is_last = not is_new and file.last == place and not file.is_over
        return (now.is_closed or is_last) and phrases.filled(FILES.incomplete, now) or nil
    end

    -- Returns the conversation of a computer and a brick. `waiting` has the numbers of the commands that wait for a
    -- reply: lists by `pending_key`, oldest first; `longest` is the longest time in nanoseconds that a reply took
    -- for which one command waited. Transfers are `begun` by counter, and `open` by handle.
    function dialogues.conversation_of(key)
        local conversation = conversations[key]
        if not conversation then
            conversation = { key = key, waiting = {}, begun = {}, open = {} }
            conversations[key] = conversation
        end
        return conversation
    end

    -- Begins another connection between the same ends: it has replies, files and a number of its own.
    function dialogues.renew(conversation)
        conversation.waiting, conversation.begun, conversation.open = {}, {}, {}
        conversation.number, conversation.longest = nil, nil
    end

    -- Tells whether a message is on a connection that begins without the unlock text, and has no reply. Whether its
    -- beginning was captured is known only where Wireshark shows all fields of a packet in a tree, and is then kept: to
    -- request the field would slow down all captures.
    function dialogues.is_locked(place)
        local lock = locks[place]
        if not lock or lock.is_open then return false end
        for _, info in ipairs(lock.is_begun == nil and { all_field_infos() } or {}) do
            if info.name == "tcp.completeness" then lock.is_begun = info.value % 2 == 1 end
        end
        return lock.is_begun
    end

    -- Ends the lock of a conversation, if it has one: the text or a reply was seen.
    function dialogues.unlock(conversation)
        if conversation.lock then conversation.lock.is_open, conversation.lock = true, nil end
    end

    -- Returns the number of the conversation of a message. It gets the next one with its first message.
    function dialogues.number_at(place)
        return numbers[storage.number_of(place)] or 1
    end

    -- Returns what a reply has in common with its command.
    local function pending_key(message)
        local carries = message.type.carries
        local number = carries == "system" and byte(message.text, HEADER_SIZE + 1) or 0
        return CARRIES[carries] + message.counter + NUMBERS * number
    end

    local function remember(conversation, place, message, now)
        -- Of a system command, its number and a handle are enough.
        local body = sub(message.text, HEADER_SIZE + 1, message.command and HEADER_SIZE + 2 or -1)
        shared[body], count = shared[body] or body, count + 1
        asked[count], answers[count], times[count], bodies[count] = place, false, now, shared[body]
        owners[count] = conversation
        set_number(place, count)
        local key = pending_key(message)
        local commands = conversation.waiting[key] or {}
        conversation.waiting[key] = commands
        if #commands == MOST_PER_COUNTER then table.remove(commands, 1) end
        commands[#commands + 1] = count
    end

    -- Returns the bytes of memory that a direct reply must have by its command's body, nil for others.
    function dialogues.asked_size(message, body)
        local type, sizes = message.type, reading.unsigned16(body, 0)
        if type.carries ~= "direct" or type.is_error or not sizes then return nil end
        return sizes % (GLOBAL_MASK + 1)
    end

    -- Tells whether the reply to a command shows that both are ours: a direct reply has the requested length, or is an
    -- error; a system reply has the command's number, known or not, but not 0. `body` is what follows the type in the
    -- command; zeros prove nothing.
    local function is_proof(reply, body)
        local carries, memory, sizes = reply.type.carries, reply.size - HEADER_SIZE, reading.unsigned16(body, 0)
        if carries == "system" then
            local number = byte(body, 1)
            return number ~= nil and number ~= 0 and number == byte(reply.text, HEADER_SIZE + 1)
        end
        if carries ~= "direct" or find(body, "^..\0+$") then return false end
        return sizes ~= nil and memory == sizes % (GLOBAL_MASK + 1) or reply.type.is_error and memory == 0
    end

    -- Tells whether a message is the reply to a command, and shows that both are ours.
    function dialogues.proves(reply, command)
        local type, asked = reply.type, command.type
        if not type or type.is_command or not asked or not asked.wants_reply then return false end
        return pending_key(reply) == pending_key(command) and is_proof(reply, sub(command.text, HEADER_SIZE + 1))
    end

    -- Returns the number of the command that a reply answers, and whether others may be it. A brick answers in
    -- order: it is the oldest that the reply fits and that has not waited much longer than this brick takes; the
    -- oldest of all if it is slow now; the newest if the reply fits none. Earlier commands are given up.
    local function answered(conversation, message, now)
        local key, fitting = pending_key(message), {}
        local commands, longest = conversation.waiting[key] or {}, conversation.longest
        for index, command in ipairs(commands) do
            local size = dialogues.asked_size(message, bodies[command])
            if not size or message.size - HEADER_SIZE == size then fitting[#fitting + 1] = index end
        end
        local found, is_unsure = fitting[1] or #commands, #fitting > 1 or not fitting[1] and #commands > 1
        if is_unsure then
            local limit = longest and math.max(PAIRING.patience * longest, PAIRING.least) or PAIRING.first
            for index = #fitting, 1, -1 do
                if now - times[commands[fitting[index]]] <= limit then found = fitting[index] end
            end
        elseif commands[1] then
            conversation.longest = math.max(longest or 0, now - times[commands[found]])
        end
        local command = commands[found]
        for _ = 1, found do table.remove(commands, 1) end
        if #commands == 0 then conversation.waiting[key] = nil end
        return command, is_unsure
    end

    -- Adds a piece to a file and returns the file. The brick closes a complete file; more data for its handle belong to
    -- another file, whose beginning was not captured: then returns nil.
    local function add_piece(conversation, handle, transfer, piece)
        if #piece > 0 and transfer.size and transfer.done >= transfer.size then
            conversation.open[handle] = nil
            return nil
        end
        transfer.done = transfer.done + #piece
        return transfer
    end

    -- Returns the file that a system command belongs to, with its progress.
    local function follow_request(conversation, message)
        local command, values = message.command, message.fields
        if command.transfer == "begin" then
            local transfer = {
                path = values.path or "", size = values.size, done = #(values.data or ""),
                is_listing = find(command.name, "^LIST") ~= nil,
            }
            conversation.begun[message.counter] = transfer
            return transfer
        end
        local transfer = conversation.open[values.handle]
        if not transfer or not values.data then return transfer end
        return add_piece(conversation, values.handle, transfer, values.data)
    end

    -- The same for a reply. `asked` is the handle in its command, which is the first field, if that was captured.
    local function follow_reply(conversation, message, asked)
        local command, values = message.command, message.fields
        local failed = message.type.is_error or STATUS.fails[message.status] ~= false
        local handle, transfer = values.handle or asked, nil
        if command.transfer == "begin" then
            transfer = conversation.begun[message.counter]
            conversation.begun[message.counter] = nil
            if failed and transfer then transfer.is_over = true end
            if failed or not values.handle then return transfer end
            -- Even if the command was not captured, the handle now belongs to another file.
            conversation.open[handle] = transfer
        else
            transfer = handle and conversation.open[handle]
            -- The brick releases a handle when its file is closed, complete, or failed.
            if handle and (command.transfer == "close" or failed or message.status == STATUS.end_of_file) then
                conversation.open[handle] = nil
                if failed and transfer then transfer.is_over = true end
            end
        end
        if not transfer then return nil end
        transfer.size = values.size or values.list_size or transfer.size
        return add_piece(conversation, handle, transfer, values.data or values.list or "")
    end

    -- Records a message of a conversation, in the first pass.
    function dialogues.take_note(place, conversation, message, pinfo)
        local type = message.type
        local is_on_file = message.command and message.command.transfer
        local now, transfer = floor(pinfo.rel_ts * 1e9 + 0.5), nil
        conversation.newest = now
        if not conversation.number then newest_number, conversation.number = newest_number + 1, newest_number + 1 end
        if conversation.number > 1 then numbers[storage.number_of(place)] = conversation.number end
        locks[place] = conversation.lock
        if not type or message.is_overwritten then return end
        if not type.is_command then dialogues.unlock(conversation) end
        if type.is_command and not type.wants_reply and not is_on_file then return end
        if type.is_command then
            if type.wants_reply then remember(conversation, place, message, now) end
            transfer = is_on_file and follow_request(conversation, message)
        else
            local request, is_unsure = answered(conversation, message, now)
            local body = bodies[request]
            if request then
                if conversation.state == "claimed" and is_proof(message, body) then conversation.state = "answered" end
                answers[request], times[request], unsure[request] = place, now - times[request], is_unsure or nil
                owners[request] = false
                set_number(place, request)
            end
            transfer = is_on_file and follow_reply(conversation, message, body and byte(body, 2))
        end
        if transfer then
            local is_closed = type.is_command and is_on_file == "close"
            local is_longer = transfer.size and transfer.done > transfer.size
            transfers[place] = {
                path = transfer.path, done = transfer.done, size = transfer.size, file = transfer,
                is_closed = is_closed, is_longer = is_longer and not transfer.is_longer,
            }
            transfer.last, transfer.is_over, transfer.is_longer = place, transfer.is_over or is_closed, is_longer
        end
    end
end

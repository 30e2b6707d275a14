-- Fields ------------------------------------------------------------------------------------------------------------
--
-- Every value in a frame is a field that one can filter for. Those of operations are named after what the firmware
-- calls them: ev3.<opcode>.<cmd>.<parameter>, in lower case.

local byte, find, format, gsub, sub = string.byte, string.find, string.format, string.gsub, string.sub
local concat, floor = table.concat, math.floor

local ev3 = Proto("EV3", "LEGO MINDSTORMS EV3")

local fields = {}

local field = {
    bytes = ProtoField.bytes("ev3.bytes", "Bytes", base.NONE, "all of a frame, or of a text between frames"),
    brick = ProtoField.string("ev3.brick", "Brick", "the brick that it goes to or comes from, whatever carries it"),
    length = ProtoField.uint16("ev3.msg_len", "Length", base.DEC, nil, nil, "bytes that follow this field"),
    counter = ProtoField.uint16("ev3.msg_num", "Message counter", base.DEC, nil, nil,
        "chosen by the sender, echoed in the reply"),
    type = ProtoField.uint8("ev3.cmd_type", "Type", base.HEX, NAMES.message_types),
    memory_sizes = ProtoField.uint16("ev3.vars", "Memory asked for", base.HEX),
    globals = ProtoField.uint16("ev3.globals", "Global memory", base.UNIT_STRING, { " byte", " bytes" }, GLOBAL_MASK,
        "bytes of the reply's payload"),
    locals = ProtoField.uint16("ev3.locals", "Local memory", base.UNIT_STRING, { " byte", " bytes" }, LOCAL_MASK),

    opcode = ProtoField.uint8("ev3.op", "Opcode", base.HEX, NAMES.opcodes),
    cmd = ProtoField.string("ev3.cmd", "CMD", "opcode and CMD by name, such as SOUND.TONE"),
    encoding = ProtoField.string("ev3.argument.encoding", "Encoding", "how the argument is encoded"),
    variable = ProtoField.string("ev3.argument.variable", "Variable",
        "the variable that stands for a value, such as GV(0)"),
    other = ProtoField.string("ev3.argument.value", "Value",
        "a constant that has not the type of its parameter"),

    memory = ProtoField.bytes("ev3.memory", "Global memory"),
    answers = ProtoField.string("ev3.answers", "Answers",
        "in a reply: the operation whose outputs these are, such as UI_READ.GET_VBATT"),
    list = ProtoField.none("ev3.values", "Values"),

    system_command = ProtoField.uint8("ev3.sys_cmd", "System command", base.HEX, NAMES.system_commands),
    status = ProtoField.uint8("ev3.reply_status", "Status", base.HEX, STATUS.names),

    daisy_command = ProtoField.uint8("ev3.daisy.command", "Sub-command", base.HEX, DAISY.names),
    layer_from = ProtoField.uint8("ev3.daisy.layer_from", "From layer"),
    layer_to = ProtoField.uint8("ev3.daisy.layer_to", "To layer"),
    daisy_payload = ProtoField.bytes("ev3.daisy.payload", "Payload"),

    rest = ProtoField.bytes("ev3.rest", "Not read", base.SPACE, "bytes that could not be read"),
    padding = ProtoField.bytes("ev3.padding", "Padding", base.SPACE, "the rest of a USB report, which means nothing"),
    fragment = ProtoField.bytes("ev3.fragment", "Part of a frame", base.SPACE),
    fragment_of = ProtoField.framenum("ev3.fragment_of", "Frame complete in"),
    fragments = ProtoField.framenum("ev3.fragments", "Began in"),

    response_in = ProtoField.framenum("ev3.response_in", "Response in", base.NONE, frametype.RESPONSE),
    request_in = ProtoField.framenum("ev3.request_in", "Request in", base.NONE, frametype.REQUEST),
    response_time = ProtoField.relative_time("ev3.response_time", "Response time"),
    transfer_path = ProtoField.string("ev3.transfer.path", "File"),
    transfer_done = ProtoField.uint32("ev3.transfer.done", "Moved so far", base.UNIT_STRING, { " byte", " bytes" }),
    transfer_size = ProtoField.uint32("ev3.transfer.size", "Size", base.UNIT_STRING, { " byte", " bytes" }),

    beacon_answer = ProtoField.bytes("ev3.beacon.answer", "Answer to a beacon", base.SPACE),
    unlock = ProtoField.string("ev3.unlock", "Unlock"),
    unlock_serial = ProtoField.string("ev3.unlock.serial", "Serial number"),
    accept = ProtoField.string("ev3.accept", "Accept"),
}

for _, declared in pairs(field) do
    fields[#fields + 1] = declared
end

-- Whether a program reads the output, and wants the bytes of whatever is recognised. People see them below anyway.
local gives_bytes = false

-- The brick of the packet that is dissected, where somebody looks at the tree.
local brick

-- The item of a frame, or of a text around frames; without `said` its text comes later.
local add_item
do
    -- Of an item Wireshark looks up its methods each time; where items are many they are at hand instead.
    local add, set_generated, brick_field = TreeItem.add, TreeItem.set_generated, field.brick

    function add_item(tree, range, said)
        local item = said and add(tree, ev3, range, "EV3: " .. said) or add(tree, ev3, range)
        if brick then set_generated(add(item, brick_field, brick)) end
        if gives_bytes then add(item, field.bytes, range) end
        return item
    end
end

local beacon_field = {}
for _, line in ipairs(CARRIERS.beacon_lines) do
    beacon_field[line.name] = ProtoField.string("ev3.beacon." .. line.name, line.label)
    fields[#fields + 1] = beacon_field[line.name]
end

-- What a field can hold, by the type that the tables give a parameter or a system message's field.
local NUMBER, FLOAT, TEXT_VALUE = "number", "float", "text"

-- Expert information, each kind with a name to filter for.
local experts = {
    fault = ProtoExpert.new("ev3.expert.fault", "Faulty frame", expert.group.MALFORMED, expert.severity.ERROR),
    unknown_opcode = ProtoExpert.new("ev3.expert.unknown_opcode", "Unknown opcode",
        expert.group.MALFORMED, expert.severity.ERROR),
    unknown_cmd = ProtoExpert.new("ev3.expert.unknown_cmd", "Unknown CMD",
        expert.group.MALFORMED, expert.severity.ERROR),
    cut_off = ProtoExpert.new("ev3.expert.cut_off", "Cut off", expert.group.MALFORMED, expert.severity.ERROR),
    misaligned = ProtoExpert.new("ev3.expert.misaligned", "Misaligned variable",
        expert.group.PROTOCOL, expert.severity.ERROR),
    beyond_memory = ProtoExpert.new("ev3.expert.beyond_memory", "Variable beyond the memory asked for",
        expert.group.PROTOCOL, expert.severity.WARN),
    no_boundary = ProtoExpert.new("ev3.expert.no_boundary", "No frame starts here",
        expert.group.MALFORMED, expert.severity.ERROR),
    error_reply = ProtoExpert.new("ev3.expert.error_reply", "The brick refused or failed the command",
        expert.group.RESPONSE_CODE, expert.severity.WARN),
    failed = ProtoExpert.new("ev3.expert.failed", "The command failed",
        expert.group.RESPONSE_CODE, expert.severity.WARN),
    orphan = ProtoExpert.new("ev3.expert.orphan", "The command that this reply answers was not seen",
        expert.group.SEQUENCE, expert.severity.NOTE),
    unanswered = ProtoExpert.new("ev3.expert.unanswered", "No reply to this command was seen",
        expert.group.SEQUENCE, expert.severity.NOTE),
    bootloader_fault = ProtoExpert.new("ev3.expert.bootloader_fault", "Bootloader fault on USB 3",
        expert.group.PROTOCOL, expert.severity.ERROR),
}

-- Wireshark collects expert information also where it makes no tree: `item` is the root of it then.
local function complain(item, kind, text)
    item:add_proto_expert_info(experts[kind], text)
end

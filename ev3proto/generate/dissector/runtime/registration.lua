-- Registration ------------------------------------------------------------------------------------------------------

do
    ev3.fields = fields

    do
        local list = {}
        for _, declared in pairs(experts) do
            list[#list + 1] = declared
        end
        ev3.experts = list
    end

    -- One protocol serves all carriers, so that "Decode As" offers it everywhere by one name.
    function ev3.dissector(tvb, pinfo, tree)
        local dissect = carriers.dissectors[pinfo.port_type]
        local taken = dissect and dissect(tvb, pinfo, tree) or 0
        if has_tree(tree) then free_unused() end
        return taken
    end

    function ev3.init()
        forget_dialogues()
        carriers.each("forget")
    end

    carriers.each("register")

    local dialect_choices = {}
    for number, name in ipairs(DIALECTS) do
        dialect_choices[number] = { number, name, number }
    end

    ev3.prefs.firmware = Pref.enum("Firmware", 1, "The firmware whose instruction set to read by",
        dialect_choices, false)
    ev3.prefs.bytes = Pref.bool("Bytes as a field", false, "Give all bytes of each frame in one field, for programs")

    function ev3.prefs_changed()
        carriers.each("prefs_changed")
        gives_bytes = ev3.prefs.bytes
        dialect = DIALECTS[ev3.prefs.firmware]
        instructions = INSTRUCTION_SETS[dialect]
    end
end

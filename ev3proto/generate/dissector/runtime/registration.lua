-- Registration ------------------------------------------------------------------------------------------------------

do
    ev3.fields = fields
    ev3.experts = experts

    -- One protocol serves all carriers, so that "Decode As" offers it everywhere by one name.
    for is_all, protocol in pairs({ [false] = ev3, [true] = ev3_all }) do
        function protocol.dissector(tvb, pinfo, tree)
            local dissect = dissectors[pinfo.port_type]
            return dissect and dissect(tvb, pinfo, tree, is_all) or 0
        end
    end

    function ev3.init()
        dialogues.forget()
        first_cut, streaming.sure_places = math.huge, {}
        for _, carrier in ipairs(carriers) do carrier.forget() end
    end

    -- Wireshark registers only protocols that have a dissector.
    for _, carrier in ipairs(carriers) do carrier.register() end

    local dialect_choices = {}
    for number, name in ipairs(DIALECTS) do dialect_choices[number] = { number, name, number } end

    ev3.prefs.firmware = Pref.enum("Firmware", 1, "Firmware whose instruction set is used", dialect_choices, false)
    ev3.prefs.bytes = Pref.bool("Bytes as a field", false, "Add the bytes of each frame as a field, for other programs")

    function ev3.prefs_changed()
        for _, carrier in ipairs(carriers) do
            if carrier.prefs_changed then carrier.prefs_changed() end
        end
        gives_bytes = ev3.prefs.bytes
        dialect = DIALECTS[ev3.prefs.firmware]
        instructions = INSTRUCTION_SETS[dialect]
        operations.forget()
    end
end

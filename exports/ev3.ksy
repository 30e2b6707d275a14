meta:
  id: ev3
  title: LEGO MINDSTORMS EV3
  license: MIT
  ks-version: "0.11"
  endian: le
  bit-endian: be
  encoding: ISO-8859-1
doc: |
  All frames of a stream between a computer and a brick, from its first frame on. On USB each report starts with one
  frame, and the rest of it is padding. On WiFi two texts precede the frames.

  Operations are those of the official firmware. An argument's type does not say whether its encoding is the shortest.
  Not covered: the meaning of a direct reply's bytes, which only the command tells; CMDs that a family does not have
  (what follows is then read as the next operation); names of sets of bits.

  Made by ev3proto 0.2.0 from its tables (ev3proto export kaitai): change those, not this.
seq:
  - {id: frames, type: frame, repeat: eos}
types:
  frame:
    doc: |
      A length that counts the bytes after it, then these bytes. Zero lengths may precede it, which
      the brick ignores; at the end of a stream, they are a frame without a message.
    seq:
      - {id: lengths, type: u2, repeat: until, repeat-until: "_ != 0 or _io.eof", valid: {expr: "_ == 0 or _ >= 3"}}
      - {id: message, type: message, size: length, if: "length != 0"}
    instances:
      length: {value: lengths.last, doc: "At most 1022, except for downloads of files over WiFi."}
  message:
    seq:
      - {id: counter, type: u2, doc: "Of the sender; the reply has the same."}
      - {id: kind, type: u1, enum: message_type, valid: {in-enum: true}}
      - id: body
        type:
          switch-on: kind
          cases:
            "message_type::direct_command_reply": direct_command
            "message_type::direct_command_no_reply": direct_command
            "message_type::system_command_reply": system_command
            "message_type::system_command_no_reply": system_command
            "message_type::direct_reply": direct_reply
            "message_type::direct_reply_error": direct_reply
            "message_type::system_reply": system_reply
            "message_type::system_reply_error": system_reply
            "message_type::daisy_command_reply": daisy_command
            "message_type::daisy_command_no_reply": daisy_command
            "message_type::daisy_reply": daisy_reply
            "message_type::daisy_reply_error": daisy_reply
  direct_command:
    seq:
      - {id: memory, type: u2}
      - {id: operations, type: operation, repeat: eos}
    instances:
      global_size: {value: "memory & 1023", doc: "Bytes of global memory: the reply's."}
      local_size: {value: "memory >> 10", doc: Bytes of local memory.}
  direct_reply:
    doc: "Only the command tells what these bytes mean, by its outputs in global memory."
    seq:
      - {id: memory, size-eos: true}
  system_command:
    seq:
      - {id: command, type: u1, enum: system_code, valid: {in-enum: true}}
      - id: fields
        type:
          switch-on: command
          cases:
            "system_code::begin_download": request_begin_download
            "system_code::continue_download": request_continue_download
            "system_code::begin_upload": request_begin_upload
            "system_code::continue_upload": request_continue_upload
            "system_code::begin_getfile": request_begin_getfile
            "system_code::continue_getfile": request_continue_getfile
            "system_code::close_filehandle": request_close_filehandle
            "system_code::list_files": request_list_files
            "system_code::continue_list_files": request_continue_list_files
            "system_code::create_dir": request_create_dir
            "system_code::delete_file": request_delete_file
            "system_code::writemailbox": request_writemailbox
            "system_code::bluetoothpin": request_bluetoothpin
            "system_code::setbundleid": request_setbundleid
            "system_code::setbundleseedid": request_setbundleseedid
            "system_code::bootloader_begin_download_with_erase": request_bootloader_begin_download_with_erase
            "system_code::bootloader_begin_download": request_bootloader_begin_download
            "system_code::bootloader_download_data": request_bootloader_download_data
            "system_code::bootloader_get_checksum": request_bootloader_get_checksum
  system_reply:
    doc: A failed one may end before any field.
    seq:
      - {id: command, type: u1, enum: system_code, valid: {in-enum: true}}
      - {id: status, type: u1, enum: system_status}
      - id: fields
        type:
          switch-on: command
          cases:
            "system_code::begin_download": reply_begin_download
            "system_code::continue_download": reply_continue_download
            "system_code::begin_upload": reply_begin_upload
            "system_code::continue_upload": reply_continue_upload
            "system_code::begin_getfile": reply_begin_getfile
            "system_code::continue_getfile": reply_continue_getfile
            "system_code::close_filehandle": reply_close_filehandle
            "system_code::list_files": reply_list_files
            "system_code::continue_list_files": reply_continue_list_files
            "system_code::list_open_handles": reply_list_open_handles
            "system_code::bluetoothpin": reply_bluetoothpin
            "system_code::bootloader_get_checksum": reply_bootloader_get_checksum
            "system_code::bootloader_get_version": reply_bootloader_get_version
        if: not _io.eof
  request_begin_download:
    doc: Opens a file on the brick for writing and announces its size
    seq:
      - {id: size, type: u4, doc: bytes of the whole file}
      - {id: path, type: strz, doc: "path of the file or folder, absolute or relative to /home/root/lms2012/sys"}
      - {id: data, size-eos: true, if: not _io.eof, doc: "the first bytes of the file, usually none"}
  reply_begin_download:
    doc: Opens a file on the brick for writing and announces its size
    seq:
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
  request_continue_download:
    doc: "Writes the next piece of a file; the file closes itself when it is complete"
    seq:
      - {id: handle, type: u1, doc: "the open file on the brick, as its reply to BEGIN_... gave it"}
      - {id: data, size-eos: true, doc: "a piece of the file's contents"}
  reply_continue_download:
    doc: "Writes the next piece of a file; the file closes itself when it is complete"
    seq:
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
  request_begin_upload:
    doc: Opens a file on the brick for reading and fetches its first piece
    seq:
      - {id: max_bytes, type: u2, doc: maximum number of content bytes in the reply}
      - {id: path, type: strz, doc: "path of the file or folder, absolute or relative to /home/root/lms2012/sys"}
  reply_begin_upload:
    doc: Opens a file on the brick for reading and fetches its first piece
    seq:
      - {id: size, type: u4, if: not _io.eof, doc: bytes of the whole file}
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
      - {id: data, size-eos: true, if: not _io.eof, doc: "a piece of the file's contents"}
  request_continue_upload:
    doc: Fetches the next piece of a file
    seq:
      - {id: handle, type: u1, doc: "the open file on the brick, as its reply to BEGIN_... gave it"}
      - {id: max_bytes, type: u2, doc: maximum number of content bytes in the reply}
  reply_continue_upload:
    doc: Fetches the next piece of a file
    seq:
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
      - {id: data, size-eos: true, if: not _io.eof, doc: "a piece of the file's contents"}
  request_begin_getfile:
    doc: "Opens a file that may still be growing, such as a data log, and fetches its first piece"
    seq:
      - {id: max_bytes, type: u2, doc: maximum number of content bytes in the reply}
      - {id: path, type: strz, doc: "path of the file or folder, absolute or relative to /home/root/lms2012/sys"}
  reply_begin_getfile:
    doc: "Opens a file that may still be growing, such as a data log, and fetches its first piece"
    seq:
      - {id: size, type: u4, if: not _io.eof, doc: bytes of the whole file}
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
      - {id: data, size-eos: true, if: not _io.eof, doc: "a piece of the file's contents"}
  request_continue_getfile:
    doc: Fetches the next piece of a file that may still be growing
    seq:
      - {id: handle, type: u1, doc: "the open file on the brick, as its reply to BEGIN_... gave it"}
      - {id: max_bytes, type: u2, doc: maximum number of content bytes in the reply}
  reply_continue_getfile:
    doc: Fetches the next piece of a file that may still be growing
    seq:
      - {id: size, type: u4, if: not _io.eof, doc: bytes of the whole file}
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
      - {id: data, size-eos: true, if: not _io.eof, doc: "a piece of the file's contents"}
  request_close_filehandle:
    doc: Closes an open file before its end
    seq:
      - {id: handle, type: u1, doc: "the open file on the brick, as its reply to BEGIN_... gave it"}
      - {id: hash, size-eos: true, if: not _io.eof, doc: "MD5 of the file, often omitted"}
  reply_close_filehandle:
    doc: Closes an open file before its end
    seq:
      - {id: handle, type: u1, if: not _io.eof, doc: the file that was closed}
  request_list_files:
    doc: Lists a folder and fetches the first piece of the listing
    seq:
      - {id: max_bytes, type: u2, doc: maximum number of content bytes in the reply}
      - {id: path, type: strz, doc: "path of the file or folder, absolute or relative to /home/root/lms2012/sys"}
  reply_list_files:
    doc: Lists a folder and fetches the first piece of the listing
    seq:
      - {id: list_size, type: u4, if: not _io.eof, doc: bytes of the whole listing}
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
      - id: list
        size-eos: true
        type: str
        if: not _io.eof
        doc: "a piece of the listing: lines with MD5, size and name, or a folder's name and /"
  request_continue_list_files:
    doc: Fetches the next piece of a listing
    seq:
      - {id: handle, type: u1, doc: "the open file on the brick, as its reply to BEGIN_... gave it"}
      - {id: max_bytes, type: u2, doc: maximum number of content bytes in the reply}
  reply_continue_list_files:
    doc: Fetches the next piece of a listing
    seq:
      - {id: handle, type: u1, if: not _io.eof, doc: "the open file, for the messages that follow"}
      - id: list
        size-eos: true
        type: str
        if: not _io.eof
        doc: "a piece of the listing: lines with MD5, size and name, or a folder's name and /"
  request_create_dir:
    doc: Creates a folder
    seq:
      - {id: path, type: strz, doc: "path of the file or folder, absolute or relative to /home/root/lms2012/sys"}
  request_delete_file:
    doc: Deletes a file or an empty folder
    seq:
      - {id: path, type: strz, doc: "path of the file or folder, absolute or relative to /home/root/lms2012/sys"}
  reply_list_open_handles:
    doc: Asks which file handles are in use
    seq:
      - {id: handles, size-eos: true, if: not _io.eof, doc: "one bit per handle, set while it is in use"}
  request_writemailbox:
    doc: Puts a message into a mailbox of the program that runs on the brick
    seq:
      - {id: name_length, type: u1, doc: "bytes of the name, with or without its zero"}
      - {id: name, type: counted_text(name_length), doc: the mailbox}
      - {id: payload_length, type: u2, doc: bytes of the message}
      - id: payload
        size: payload_length
        doc: "the message: a text (with its zero), a number (a single), a logic value (one byte), or other bytes"
  request_bluetoothpin:
    doc: Sends the PIN for a Bluetooth device (USB only)
    seq:
      - {id: mac_length, type: u1, doc: bytes of the MAC address}
      - {id: mac, type: counted_text(mac_length), doc: "MAC address of the other device, in hex"}
      - {id: pin_length, type: u1, doc: bytes of the PIN}
      - {id: pin, type: counted_text(pin_length), doc: the PIN}
  reply_bluetoothpin:
    doc: Sends the PIN for a Bluetooth device (USB only)
    seq:
      - {id: mac_length, type: u1, if: not _io.eof, doc: bytes of the MAC address}
      - {id: mac, type: counted_text(mac_length), if: not _io.eof, doc: "MAC address of the other device, in hex"}
      - {id: pin_length, type: u1, if: not _io.eof, doc: bytes of the PIN}
      - {id: pin, type: counted_text(pin_length), if: not _io.eof, doc: the PIN}
  request_setbundleid:
    doc: Sets the bundle identifier that the brick shows to Apple devices
    seq:
      - {id: id, type: strz, doc: the identifier}
  request_setbundleseedid:
    doc: Sets the bundle seed identifier that the brick shows to Apple devices
    seq:
      - {id: id, type: strz, doc: the identifier}
  request_bootloader_begin_download_with_erase:
    doc: Erases a region of the flash memory and prepares to write it
    seq:
      - {id: address, type: u4, doc: address of the first byte in flash memory}
      - {id: image_size, type: u4, doc: bytes of the image or region}
  request_bootloader_begin_download:
    doc: Prepares to write a region of the flash memory that is already erased
    seq:
      - {id: address, type: u4, doc: address of the first byte in flash memory}
      - {id: image_size, type: u4, doc: bytes of the image or region}
  request_bootloader_download_data:
    doc: Writes the next piece of the image
    seq:
      - {id: data, size-eos: true, doc: a piece of the image}
  request_bootloader_get_checksum:
    doc: Asks for the checksum of a region of the flash memory
    seq:
      - {id: address, type: u4, doc: address of the first byte in flash memory}
      - {id: image_size, type: u4, doc: bytes of the image or region}
  reply_bootloader_get_checksum:
    doc: Asks for the checksum of a region of the flash memory
    seq:
      - {id: checksum, type: u4, if: not _io.eof, doc: CRC-32 of the region}
  reply_bootloader_get_version:
    doc: Asks for the versions of hardware and firmware
    seq:
      - {id: hardware_version, type: u4, if: not _io.eof, doc: version of the hardware}
      - {id: firmware_version, type: u4, if: not _io.eof, doc: version of the updater}
  counted_text:
    doc: "A text preceded by its length. Some senders count its zero, some do not; the zero is always there."
    params:
      - {id: length, type: u1}
    seq:
      - {id: bytes, size: length}
      - {id: zero, type: u1, valid: 0, if: not is_counted}
    instances:
      is_counted: {value: "length > 0 and bytes[length - 1] == 0"}
      text: {value: "is_counted ? bytes.to_s(\"ISO-8859-1\").substring(0, length - 1) : bytes.to_s(\"ISO-8859-1\")"}
  daisy_command:
    seq:
      - {id: command, type: u1, enum: daisy_code, valid: {in-enum: true}}
      - {id: layer_from, type: u1}
      - {id: layer_to, type: u1}
      - id: operations
        type: operation
        repeat: eos
        if: "command == daisy_code::downstream or command == daisy_code::downstream_with_busy"
      - id: payload
        size-eos: true
        if: "not (command == daisy_code::downstream or command == daisy_code::downstream_with_busy)"
  daisy_reply:
    seq:
      - {id: layer_from, type: u1}
      - {id: layer_to, type: u1}
      - {id: report, type: sensor_report, if: "_io.size - _io.pos >= 38"}
      - {id: payload, size-eos: true}
  sensor_report:
    seq:
      - {id: layer, type: u1}
      - {id: port, type: u1}
      - {id: status, type: u1}
      - {id: type_, type: u1}
      - {id: mode, type: u1}
      - {id: data, size: 32}
      - {id: checksum, type: u1}
      - {id: busy, size-eos: true}
  argument:
    doc: |
      One argument: constant, string, local or global variable, or label.
      The bits of its first byte say which, and how many bytes follow.
    params:
      - {id: is_float, type: bool, doc: Whether a constant of four bytes is a float.}
    seq:
      - {id: is_long, type: b1}
      - {id: is_variable, type: b1}
      - {id: selector, type: b1, doc: "Of variables: global. Of long constants: label."}
      - {id: is_handle_bit, type: b1, if: is_long}
      - {id: is_address_bit, type: b1, if: is_long}
      - id: width
        type: b3
        if: is_long
        valid:
          expr: "is_label or width == 1 or width == 2 or width == 3 or (not is_variable and (width == 0 or width == 4))"
      - {id: short_value, type: b5, if: not is_long}
      - {id: float_value, type: f4, if: "is_float and form == 3"}
      - id: number
        type: {switch-on: form, cases: {1: s1, 2: s2, 3: s4, 9: u1, 10: u2, 11: u4}}
        if: "form != 0 and form != 8 and not (is_float and form == 3)"
      - {id: text, type: strz, if: "form == 8"}
    instances:
      is_label: {value: is_long and not is_variable and selector}
      is_global: {value: is_variable and selector}
      is_handle: {value: is_long and is_handle_bit}
      is_address: {value: is_long and is_address_bit}
      is_number:
        value: "not is_variable and not is_label and form != 8 and not (is_float and form == 3)"
        doc: "Whether it is a whole number, which may be that of an enumeration's member."
      form: {value: "not is_long ? 0 : is_variable ? 8 + width : is_label ? 1 : (width == 0 or width == 4) ? 8 : width"}
      value:
        value: "is_long ? number : is_variable ? short_value : selector ? short_value - 32 : short_value"
        if: "form != 8 and not (is_float and form == 3)"
        doc: "A number, an index, or how far to jump. Strings are in text, floats in float_value."
  operation:
    seq:
      - {id: opcode, type: u1, enum: opcode, valid: {in-enum: true}}
      - id: arguments
        type:
          switch-on: opcode
          cases:
            "opcode::program_stop": op_program_stop
            "opcode::program_start": op_program_start
            "opcode::object_stop": op_object_stop
            "opcode::object_start": op_object_start
            "opcode::object_trig": op_object_trig
            "opcode::object_wait": op_object_wait
            "opcode::call": op_call
            "opcode::program_info": family_program_info
            "opcode::label": op_label
            "opcode::probe": op_probe
            "opcode::do_": op_do
            "opcode::system": op_system
            "opcode::port_cnv_output": op_port_cnv_output
            "opcode::port_cnv_input": op_port_cnv_input
            "opcode::note_to_freq": op_note_to_freq
            "opcode::info": family_info
            "opcode::strings": family_strings
            "opcode::bp_set": op_bp_set
            "opcode::tst": family_tst
            "opcode::add8": op_add8
            "opcode::add16": op_add16
            "opcode::add32": op_add32
            "opcode::addf": op_addf
            "opcode::sub8": op_sub8
            "opcode::sub16": op_sub16
            "opcode::sub32": op_sub32
            "opcode::subf": op_subf
            "opcode::mul8": op_mul8
            "opcode::mul16": op_mul16
            "opcode::mul32": op_mul32
            "opcode::mulf": op_mulf
            "opcode::div8": op_div8
            "opcode::div16": op_div16
            "opcode::div32": op_div32
            "opcode::divf": op_divf
            "opcode::or8": op_or8
            "opcode::or16": op_or16
            "opcode::or32": op_or32
            "opcode::and8": op_and8
            "opcode::and16": op_and16
            "opcode::and32": op_and32
            "opcode::xor8": op_xor8
            "opcode::xor16": op_xor16
            "opcode::xor32": op_xor32
            "opcode::rl8": op_rl8
            "opcode::rl16": op_rl16
            "opcode::rl32": op_rl32
            "opcode::math": family_math
            "opcode::random": op_random
            "opcode::init_bytes": op_init_bytes
            "opcode::move8_8": op_move8_8
            "opcode::move8_16": op_move8_16
            "opcode::move8_32": op_move8_32
            "opcode::move8_f": op_move8_f
            "opcode::move16_8": op_move16_8
            "opcode::move16_16": op_move16_16
            "opcode::move16_32": op_move16_32
            "opcode::move16_f": op_move16_f
            "opcode::move32_8": op_move32_8
            "opcode::move32_16": op_move32_16
            "opcode::move32_32": op_move32_32
            "opcode::move32_f": op_move32_f
            "opcode::movef_8": op_movef_8
            "opcode::movef_16": op_movef_16
            "opcode::movef_32": op_movef_32
            "opcode::movef_f": op_movef_f
            "opcode::read8": op_read8
            "opcode::read16": op_read16
            "opcode::read32": op_read32
            "opcode::readf": op_readf
            "opcode::write8": op_write8
            "opcode::write16": op_write16
            "opcode::write32": op_write32
            "opcode::writef": op_writef
            "opcode::jr": op_jr
            "opcode::jr_false": op_jr_false
            "opcode::jr_true": op_jr_true
            "opcode::jr_nan": op_jr_nan
            "opcode::jr_lt8": op_jr_lt8
            "opcode::jr_lt16": op_jr_lt16
            "opcode::jr_lt32": op_jr_lt32
            "opcode::jr_ltf": op_jr_ltf
            "opcode::jr_gt8": op_jr_gt8
            "opcode::jr_gt16": op_jr_gt16
            "opcode::jr_gt32": op_jr_gt32
            "opcode::jr_gtf": op_jr_gtf
            "opcode::jr_eq8": op_jr_eq8
            "opcode::jr_eq16": op_jr_eq16
            "opcode::jr_eq32": op_jr_eq32
            "opcode::jr_eqf": op_jr_eqf
            "opcode::jr_neq8": op_jr_neq8
            "opcode::jr_neq16": op_jr_neq16
            "opcode::jr_neq32": op_jr_neq32
            "opcode::jr_neqf": op_jr_neqf
            "opcode::jr_lteq8": op_jr_lteq8
            "opcode::jr_lteq16": op_jr_lteq16
            "opcode::jr_lteq32": op_jr_lteq32
            "opcode::jr_lteqf": op_jr_lteqf
            "opcode::jr_gteq8": op_jr_gteq8
            "opcode::jr_gteq16": op_jr_gteq16
            "opcode::jr_gteq32": op_jr_gteq32
            "opcode::jr_gteqf": op_jr_gteqf
            "opcode::cp_lt8": op_cp_lt8
            "opcode::cp_lt16": op_cp_lt16
            "opcode::cp_lt32": op_cp_lt32
            "opcode::cp_ltf": op_cp_ltf
            "opcode::cp_gt8": op_cp_gt8
            "opcode::cp_gt16": op_cp_gt16
            "opcode::cp_gt32": op_cp_gt32
            "opcode::cp_gtf": op_cp_gtf
            "opcode::cp_eq8": op_cp_eq8
            "opcode::cp_eq16": op_cp_eq16
            "opcode::cp_eq32": op_cp_eq32
            "opcode::cp_eqf": op_cp_eqf
            "opcode::cp_neq8": op_cp_neq8
            "opcode::cp_neq16": op_cp_neq16
            "opcode::cp_neq32": op_cp_neq32
            "opcode::cp_neqf": op_cp_neqf
            "opcode::cp_lteq8": op_cp_lteq8
            "opcode::cp_lteq16": op_cp_lteq16
            "opcode::cp_lteq32": op_cp_lteq32
            "opcode::cp_lteqf": op_cp_lteqf
            "opcode::cp_gteq8": op_cp_gteq8
            "opcode::cp_gteq16": op_cp_gteq16
            "opcode::cp_gteq32": op_cp_gteq32
            "opcode::cp_gteqf": op_cp_gteqf
            "opcode::select8": op_select8
            "opcode::select16": op_select16
            "opcode::select32": op_select32
            "opcode::selectf": op_selectf
            "opcode::ui_read": family_ui_read
            "opcode::ui_write": family_ui_write
            "opcode::ui_button": family_ui_button
            "opcode::ui_draw": family_ui_draw
            "opcode::keep_alive": op_keep_alive
            "opcode::timer_wait": op_timer_wait
            "opcode::timer_ready": op_timer_ready
            "opcode::timer_read": op_timer_read
            "opcode::timer_read_us": op_timer_read_us
            "opcode::sound": family_sound
            "opcode::sound_test": op_sound_test
            "opcode::input_sample": op_input_sample
            "opcode::input_device_list": op_input_device_list
            "opcode::input_device": family_input_device
            "opcode::input_read": op_input_read
            "opcode::input_test": op_input_test
            "opcode::input_ready": op_input_ready
            "opcode::input_readsi": op_input_readsi
            "opcode::input_readext": op_input_readext
            "opcode::input_write": op_input_write
            "opcode::output_set_type": op_output_set_type
            "opcode::output_reset": op_output_reset
            "opcode::output_stop": op_output_stop
            "opcode::output_power": op_output_power
            "opcode::output_speed": op_output_speed
            "opcode::output_start": op_output_start
            "opcode::output_polarity": op_output_polarity
            "opcode::output_read": op_output_read
            "opcode::output_test": op_output_test
            "opcode::output_ready": op_output_ready
            "opcode::output_step_power": op_output_step_power
            "opcode::output_time_power": op_output_time_power
            "opcode::output_step_speed": op_output_step_speed
            "opcode::output_time_speed": op_output_time_speed
            "opcode::output_step_sync": op_output_step_sync
            "opcode::output_time_sync": op_output_time_sync
            "opcode::output_clr_count": op_output_clr_count
            "opcode::output_get_count": op_output_get_count
            "opcode::memory_write": op_memory_write
            "opcode::memory_read": op_memory_read
            "opcode::file": family_file
            "opcode::array": family_array
            "opcode::array_write": op_array_write
            "opcode::array_read": op_array_read
            "opcode::array_append": op_array_append
            "opcode::memory_usage": op_memory_usage
            "opcode::filename": family_filename
            "opcode::com_read": family_com_read
            "opcode::com_write": family_com_write
            "opcode::com_ready": op_com_ready
            "opcode::com_readdata": op_com_readdata
            "opcode::com_writedata": op_com_writedata
            "opcode::com_get": family_com_get
            "opcode::com_set": family_com_set
            "opcode::com_test": op_com_test
            "opcode::com_remove": op_com_remove
            "opcode::com_writefile": op_com_writefile
            "opcode::mailbox_open": op_mailbox_open
            "opcode::mailbox_write": op_mailbox_write
            "opcode::mailbox_read": op_mailbox_read
            "opcode::mailbox_test": op_mailbox_test
            "opcode::mailbox_ready": op_mailbox_ready
            "opcode::mailbox_close": op_mailbox_close
  family_program_info:
    doc: Asks about a program or controls its objects
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            0: op_program_info_obj_stop
            4: op_program_info_obj_start
            22: op_program_info_get_status
            23: op_program_info_get_speed
            24: op_program_info_get_prgresult
            25: op_program_info_set_instr
    instances:
      cmd_name: {value: cmd.value, enum: cmd_program_info}
    enums:
      cmd_program_info:
        0: {id: obj_stop, doc: Stops an object of a running program}
        4: {id: obj_start, doc: Starts an object of a running program from its beginning}
        22: {id: get_status, doc: Asks whether a program runs}
        23: {id: get_speed, doc: "Asks for a program's speed"}
        24: {id: get_prgresult, doc: Asks how a program ended}
        25: {id: set_instr, doc: Sets how many instructions the calling thread may still run in its time slice}
  family_info:
    doc: "Reads and sets the error log, the volume and the time to power off"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_info_set_error
            2: op_info_get_error
            3: op_info_errortext
            4: op_info_get_volume
            5: op_info_set_volume
            6: op_info_get_minutes
            7: op_info_set_minutes
    instances:
      cmd_name: {value: cmd.value, enum: cmd_info}
    enums:
      cmd_info:
        1: {id: set_error, doc: "Adds an error to the brick's error log"}
        2: {id: get_error, doc: "Removes and returns the oldest error of the brick's error log"}
        3: {id: errortext, doc: Converts the number of an error to its name}
        4: {id: get_volume, doc: Reads the volume setting}
        5: {id: set_volume, doc: Changes the volume setting}
        6: {id: get_minutes, doc: Reads the idle time after which the brick powers off}
        7: {id: set_minutes, doc: Changes the idle time after which the brick powers off}
  family_strings:
    doc: "Works with texts: joins, compares, converts from and to numbers"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_strings_get_size
            2: op_strings_add
            3: op_strings_compare
            5: op_strings_duplicate
            6: op_strings_value_to_string
            7: op_strings_string_to_value
            8: op_strings_strip
            9: op_strings_number_to_string
            10: op_strings_sub
            11: op_strings_value_formatted
            12: op_strings_number_formatted
    instances:
      cmd_name: {value: cmd.value, enum: cmd_strings}
    enums:
      cmd_strings:
        1: {id: get_size, doc: Reads the length of a text}
        2: {id: add, doc: Joins two texts}
        3: {id: compare, doc: "Reports whether two texts are equal; case matters"}
        5: {id: duplicate, doc: Copies a text}
        6: {id: value_to_string, doc: "Writes a floating-point number as text, without trailing zeros"}
        7: {id: string_to_value, doc: Reads a number from a text}
        8: {id: strip, doc: Removes every space from a text}
        9: {id: number_to_string, doc: "Writes a whole number as text, with leading zeros"}
        10: {id: sub, doc: Returns the part of a text after another text found in it}
        11: {id: value_formatted, doc: "Writes a floating-point number as text in a format of C's printf"}
        12: {id: number_formatted, doc: "Writes a whole number as text in a format of C's printf"}
  family_tst:
    doc: "Tests the hardware, as the factory does; all fail before TST_OPEN"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            12: op_tst_tst_read_pins
            13: op_tst_tst_write_pins
            14: op_tst_tst_read_adc
            15: op_tst_tst_write_uart
            16: op_tst_tst_read_uart
            17: op_tst_tst_enable_uart
            19: op_tst_tst_accu_switch
            21: op_tst_tst_poll_mode2
            23: op_tst_tst_ram_check
    instances:
      cmd_name: {value: cmd.value, enum: cmd_tst}
    enums:
      cmd_tst:
        10: {id: tst_open, doc: "Allows test commands for 10 seconds; each one restarts the timer"}
        11: {id: tst_close, doc: Ends the test mode}
        12: {id: tst_read_pins, doc: Reads the pins of a connector}
        13: {id: tst_write_pins, doc: Sets the pins of a connector}
        14: {id: tst_read_adc, doc: Reads the analog converter}
        15: {id: tst_write_uart, doc: "Sends bytes on a sensor port's serial line"}
        16: {id: tst_read_uart, doc: "Reads the bytes received on a sensor port's serial line"}
        17: {id: tst_enable_uart, doc: Switches the serial lines of all sensor ports on}
        18: {id: tst_disable_uart, doc: Switches the serial lines of all sensor ports off}
        19: {id: tst_accu_switch, doc: Reads the switch that senses the rechargeable battery}
        20: {id: tst_boot_mode2, doc: "Starts Bluetooth mode 2, for Apple devices"}
        21: {id: tst_poll_mode2, doc: Asks for the state of the start of Bluetooth mode 2}
        22: {id: tst_close_mode2, doc: Ends Bluetooth mode 2}
        23: {id: tst_ram_check, doc: Asks for the result of the memory test at power-on}
  family_math:
    doc: Applies a mathematical function
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_math_exp
            2: op_math_mod
            3: op_math_floor
            4: op_math_ceil
            5: op_math_round
            6: op_math_abs
            7: op_math_negate
            8: op_math_sqrt
            9: op_math_log
            10: op_math_ln
            11: op_math_sin
            12: op_math_cos
            13: op_math_tan
            14: op_math_asin
            15: op_math_acos
            16: op_math_atan
            17: op_math_mod8
            18: op_math_mod16
            19: op_math_mod32
            20: op_math_pow
            21: op_math_trunc
    instances:
      cmd_name: {value: cmd.value, enum: cmd_math}
    enums:
      cmd_math:
        1: {id: exp, doc: Raises e to a power}
        2: {id: mod_, doc: Takes the remainder of a floating-point division}
        3: {id: floor, doc: Rounds down to a whole number}
        4: {id: ceil, doc: Rounds up to a whole number}
        5: {id: round, doc: "Rounds to the nearest whole number, halves away from zero"}
        6: {id: abs, doc: Drops the sign}
        7: {id: negate, doc: Reverses the sign}
        8: {id: sqrt, doc: Takes the square root}
        9: {id: log, doc: Takes the logarithm to base 10}
        10: {id: ln, doc: Takes the natural logarithm}
        11: {id: sin, doc: Takes the sine of an angle in degrees}
        12: {id: cos, doc: Takes the cosine of an angle in degrees}
        13: {id: tan, doc: Takes the tangent of an angle in degrees}
        14: {id: asin, doc: Finds the angle that has a sine}
        15: {id: acos, doc: Finds the angle that has a cosine}
        16: {id: atan, doc: Finds the angle that has a tangent}
        17: {id: mod8, doc: Takes the remainder of an 8-bit division}
        18: {id: mod16, doc: Takes the remainder of a 16-bit division}
        19: {id: mod32, doc: Takes the remainder of a 32-bit division}
        20: {id: pow, doc: Raises a number to a power}
        21: {id: trunc, doc: Cuts off decimals without rounding}
  family_ui_read:
    doc: Reads the state of the brick or what the terminal received
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_ui_read_get_vbatt
            2: op_ui_read_get_ibatt
            3: op_ui_read_get_os_vers
            4: op_ui_read_get_event
            5: op_ui_read_get_tbatt
            6: op_ui_read_get_iint
            7: op_ui_read_get_imotor
            8: op_ui_read_get_string
            9: op_ui_read_get_hw_vers
            10: op_ui_read_get_fw_vers
            11: op_ui_read_get_fw_build
            12: op_ui_read_get_os_build
            13: op_ui_read_get_address
            14: op_ui_read_get_code
            15: op_ui_read_key
            16: op_ui_read_get_shutdown
            17: op_ui_read_get_warning
            18: op_ui_read_get_lbatt
            21: op_ui_read_textbox_read
            26: op_ui_read_get_version
            27: op_ui_read_get_ip
            29: op_ui_read_get_power
            30: op_ui_read_get_sdcard
            31: op_ui_read_get_usbstick
    instances:
      cmd_name: {value: cmd.value, enum: cmd_ui_read}
    enums:
      cmd_ui_read:
        1: {id: get_vbatt, doc: Reads the battery voltage}
        2: {id: get_ibatt, doc: Reads the battery current}
        3: {id: get_os_vers, doc: Reads name and version of the operating system}
        4: {id: get_event, doc: "Reads and clears the pending event (used by the brick's own menus)"}
        5: {id: get_tbatt, doc: "Reads the rise in battery temperature, estimated from the current"}
        6: {id: get_iint, doc: Reads the battery current smoothed over time}
        7: {id: get_imotor, doc: Reads the current of all motors together}
        8: {id: get_string, doc: Waits for a line typed at the terminal and reads it}
        9: {id: get_hw_vers, doc: Reads the hardware version}
        10: {id: get_fw_vers, doc: Reads the firmware version}
        11: {id: get_fw_build, doc: Reads the build time of the firmware}
        12: {id: get_os_build, doc: Reads the build time of the operating system}
        13: {id: get_address, doc: Waits for a decimal number typed at the terminal and reads it (debugging)}
        14:
          id: get_code
          doc: Waits for byte code typed as hex at the terminal and builds a program from it (debugging)
        15: {id: key, doc: Takes one key from the terminal without waiting}
        16: {id: get_shutdown, doc: "Reads and clears the request to shut down (used by the brick's own menus)"}
        17: {id: get_warning, doc: "Reads the brick's warnings"}
        18: {id: get_lbatt, doc: "Reads the battery level, derived from its voltage"}
        21: {id: textbox_read, doc: Reads one line of the text of a text box}
        26: {id: get_version, doc: "Reads name, version and build date of the firmware in one string"}
        27: {id: get_ip, doc: "Reads the brick's IP address"}
        29: {id: get_power, doc: Reads all values of the power supply at once}
        30: {id: get_sdcard, doc: "Reads whether an SD card is present, and its space"}
        31: {id: get_usbstick, doc: "Reads whether a USB stick is present, and its space"}
  family_ui_write:
    doc: Writes to the terminal or sets lights and states of the brick
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            2: op_ui_write_floatvalue
            3: op_ui_write_stamp
            8: op_ui_write_put_string
            9: op_ui_write_value8
            10: op_ui_write_value16
            11: op_ui_write_value32
            12: op_ui_write_valuef
            13: op_ui_write_address
            14: op_ui_write_code
            16: op_ui_write_screen_block
            17: op_ui_write_allow_pulse
            18: op_ui_write_set_pulse
            21: op_ui_write_textbox_append
            22: op_ui_write_set_busy
            24: op_ui_write_set_testpin
            27: op_ui_write_led
            29: op_ui_write_power
            31: op_ui_write_terminal
    instances:
      cmd_name: {value: cmd.value, enum: cmd_ui_write}
    enums:
      cmd_ui_write:
        1: {id: write_flush, doc: "Sends the contents of the terminal's output buffer, like UI_FLUSH"}
        2: {id: floatvalue, doc: Writes a number in a fixed format to the terminal}
        3: {id: stamp, doc: "Writes time, program, object, position and a comment to the terminal"}
        8: {id: put_string, doc: Writes text to the terminal}
        9: {id: value8, doc: Writes a whole number to the terminal}
        10: {id: value16, doc: Writes an unsigned whole number to the terminal}
        11: {id: value32, doc: Writes a whole number to the terminal}
        12: {id: valuef, doc: Writes a number to the terminal}
        13: {id: address, doc: "Not implemented in the firmware: the program that runs it fails"}
        14: {id: code, doc: Writes bytes of memory as hex to the terminal}
        15: {id: download_end, doc: Plays the sound of a finished download and refreshes the file browser}
        16: {id: screen_block, doc: Blocks or unblocks the display and the buttons for programs}
        17: {id: allow_pulse, doc: Selects the debug pulses that are shown (only in debug builds of the firmware)}
        18: {id: set_pulse, doc: Raises debug pulses (only in debug builds of the firmware)}
        21: {id: textbox_append, doc: Appends a line to the text of a text box}
        22: {id: set_busy, doc: Sets or clears the busy bit among the warnings}
        24: {id: set_testpin, doc: "Sets the test pin on the brick's circuit board"}
        25: {id: init_run, doc: Shows the animation of a running program until something draws}
        26: {id: update_run, doc: Does nothing}
        27: {id: led, doc: Sets colour and blinking of the light around the buttons}
        29: {id: power, doc: Sets the flag that makes the power driver switch off when the firmware ends}
        30: {id: graph_sample, doc: Adds the current values to the graph of GRAPH_SETUP}
        31: {id: terminal, doc: Switches the debug terminal on or off}
  family_ui_button:
    doc: Reads or simulates the buttons
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_ui_button_shortpress
            2: op_ui_button_longpress
            5: op_ui_button_press
            6: op_ui_button_release
            7: op_ui_button_get_horz
            8: op_ui_button_get_vert
            9: op_ui_button_pressed
            10: op_ui_button_set_back_block
            11: op_ui_button_get_back_block
            12: op_ui_button_testshortpress
            13: op_ui_button_testlongpress
            14: op_ui_button_get_bumbed
            15: op_ui_button_get_click
    instances:
      cmd_name: {value: cmd.value, enum: cmd_ui_button}
    enums:
      cmd_ui_button:
        1: {id: shortpress, doc: "Reports whether a button was pressed since the last query, and clears the press"}
        2: {id: longpress, doc: "Reports whether a button was held for 3 s since the last query, and clears it"}
        3: {id: wait_for_press, doc: "Waits until any button has been pressed, by hand or by PRESS"}
        4: {id: flush, doc: Clears all pending presses}
        5: {id: press, doc: Presses a button as if by hand and holds it until RELEASE}
        6: {id: release, doc: Releases a button that PRESS holds}
        7: {id: get_horz, doc: "Reads the left and right buttons as one axis, and clears their presses"}
        8: {id: get_vert, doc: "Reads the up and down buttons as one axis, and clears their presses"}
        9: {id: pressed, doc: Reports whether a button is down at the moment}
        10: {id: set_back_block, doc: "Blocks or unblocks the back button, which ends the running program"}
        11: {id: get_back_block, doc: Reports whether the back button is blocked}
        12:
          id: testshortpress
          doc: "Reports, like SHORTPRESS, whether a button was pressed, without clearing the press"
        13: {id: testlongpress, doc: "Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it"}
        14:
          id: get_bumbed
          doc: "Reports whether a button was pressed and released since the last query, and clears it"
        15: {id: get_click, doc: "Reports whether a key click is due for a handled press, and clears it"}
  family_ui_draw:
    doc: "Draws on the canvas of the display, or runs a dialogue on it"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            2: op_ui_draw_pixel
            3: op_ui_draw_line
            4: op_ui_draw_circle
            5: op_ui_draw_text
            6: op_ui_draw_icon
            7: op_ui_draw_picture
            8: op_ui_draw_value
            9: op_ui_draw_fillrect
            10: op_ui_draw_rect
            11: op_ui_draw_notification
            12: op_ui_draw_question
            13: op_ui_draw_keyboard
            14: op_ui_draw_browse
            15: op_ui_draw_vertbar
            16: op_ui_draw_inverserect
            17: op_ui_draw_select_font
            18: op_ui_draw_topline
            19: op_ui_draw_fillwindow
            20: op_ui_draw_scroll
            21: op_ui_draw_dotline
            22: op_ui_draw_view_value
            23: op_ui_draw_view_unit
            24: op_ui_draw_fillcircle
            25: op_ui_draw_store
            26: op_ui_draw_restore
            27: op_ui_draw_icon_question
            28: op_ui_draw_bmpfile
            29: op_ui_draw_popup
            30: op_ui_draw_graph_setup
            31: op_ui_draw_graph_draw
            32: op_ui_draw_textbox
    instances:
      cmd_name: {value: cmd.value, enum: cmd_ui_draw}
    enums:
      cmd_ui_draw:
        0: {id: update, doc: "Shows on the display what has been drawn, and restores the normal font"}
        1: {id: clean, doc: "Clears the canvas to white, and restores the normal font"}
        2: {id: pixel, doc: Draws one pixel}
        3: {id: line, doc: Draws a line between two points}
        4: {id: circle, doc: Draws a circle}
        5: {id: text, doc: Draws text in the font chosen by SELECT_FONT}
        6: {id: icon, doc: Draws one of the built-in icons}
        7: {id: picture, doc: Draws a picture from memory}
        8: {id: value, doc: "Draws a number, or dashes where it is not a number"}
        9: {id: fillrect, doc: Draws a filled rectangle}
        10: {id: rect, doc: Draws the outline of a rectangle}
        11: {id: notification, doc: Shows icons and text in a window and waits for the centre button}
        12: {id: question, doc: Shows icons in a window and waits for yes or no}
        13: {id: keyboard, doc: Shows a keyboard on the display and waits until a text has been entered}
        14: {id: browse, doc: Shows files and folders and waits until one is chosen}
        15: {id: vertbar, doc: Draws a vertical scroll bar}
        16: {id: inverserect, doc: Swaps black and white in a rectangle}
        17: {id: select_font, doc: "Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW"}
        18: {id: topline, doc: Switches the status line at the top on or off}
        19: {id: fillwindow, doc: "Fills rows over the whole width, and restores the normal font"}
        20: {id: scroll, doc: Moves the canvas up}
        21: {id: dotline, doc: Draws a dashed line between two points}
        22: {id: view_value, doc: "Draws a number centred in its place, or > instead of digits if it does not fit"}
        23: {id: view_unit, doc: Draws a number in large figures and its unit in small letters}
        24: {id: fillcircle, doc: Draws a filled circle}
        25: {id: store, doc: Keeps a copy of the canvas}
        26: {id: restore, doc: Restores a canvas kept by STORE}
        27: {id: icon_question, doc: Shows a row of icons and waits until one is chosen}
        28: {id: bmpfile, doc: "Draws a picture file in LEGO's own format .rgf (no .bmp despite the name)"}
        29: {id: popup, doc: "Opens a window that only its opener can draw on, or closes it and restores the display"}
        30:
          id: graph_setup
          doc: "Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it"
        31: {id: graph_draw, doc: Draws the graph and measures the curve it shows}
        32: {id: textbox, doc: Shows a text with a scroll bar and waits until a line is chosen}
  family_sound:
    doc: Plays or stops a sound
    seq:
      - {id: cmd, type: argument(false)}
      - {id: parameters, type: {switch-on: cmd.value, cases: {1: op_sound_tone, 2: op_sound_play, 3: op_sound_repeat}}}
    instances:
      cmd_name: {value: cmd.value, enum: cmd_sound}
    enums:
      cmd_sound:
        0: {id: break_, doc: Stops the tone or file that is playing}
        1: {id: tone, doc: Plays one tone and returns at once}
        2: {id: play, doc: Plays a sound file once and returns at once}
        3: {id: repeat, doc: Plays a sound file over and over until BREAK and returns at once}
        4: {id: service, doc: "Does nothing; the number is used inside the firmware to feed the sound driver"}
  family_input_device:
    doc: "Asks about devices, calibrates them, reads several values"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_input_device_insert_type
            2: op_input_device_get_format
            3: op_input_device_cal_minmax
            4: op_input_device_cal_default
            5: op_input_device_get_typemode
            6: op_input_device_get_symbol
            7: op_input_device_cal_min
            8: op_input_device_cal_max
            9: op_input_device_setup
            10: op_input_device_clr_all
            11: op_input_device_get_raw
            12: op_input_device_get_connection
            13: op_input_device_stop_all
            14: op_input_device_set_typemode
            15: op_input_device_ready_iic
            21: op_input_device_get_name
            22: op_input_device_get_modename
            23: op_input_device_set_raw
            24: op_input_device_get_figures
            25: op_input_device_get_changes
            26: op_input_device_clr_changes
            27: op_input_device_ready_pct
            28: op_input_device_ready_raw
            29: op_input_device_ready_si
            30: op_input_device_get_minmax
            31: op_input_device_get_bumps
    instances:
      cmd_name: {value: cmd.value, enum: cmd_input_device}
    enums:
      cmd_input_device:
        1: {id: insert_type, doc: "Adds a line to the table of device types, for third party types (50 to 98) only"}
        2: {id: get_format, doc: Describes the values of a device in its current mode}
        3: {id: cal_minmax, doc: Sets the raw values that scale a type and mode to percent and SI}
        4: {id: cal_default, doc: Restores the built-in scaling of a type and mode}
        5: {id: get_typemode, doc: Reports the device at a port and its mode}
        6: {id: get_symbol, doc: Reads the symbol of the unit of the current mode}
        7: {id: cal_min, doc: Sets the lower end of the scaling of a type and mode}
        8: {id: cal_max, doc: Sets the full scale of a type and mode}
        9: {id: setup, doc: "Writes to an I2C sensor and reads its answer, repeatedly if requested"}
        10: {id: clr_all, doc: Clears counters and angles of all devices}
        11: {id: get_raw, doc: Reads the first raw value of a device}
        12: {id: get_connection, doc: Reports how the device at a port is connected}
        13: {id: stop_all, doc: "Stops all devices, motors among them"}
        14: {id: set_typemode, doc: "Renumbers an entry of the table of device types, third party types only"}
        15: {id: ready_iic, doc: "Writes to an I2C sensor once, waits for its answer and reports the result"}
        21: {id: get_name, doc: "Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT"}
        22: {id: get_modename, doc: Reads the name of any mode of a device}
        23: {id: set_raw, doc: Simulates a raw value of a device}
        24: {id: get_figures, doc: Reports the number of digits that a value of the current mode needs}
        25: {id: get_changes, doc: Reads how often a touch sensor changed to pressed since CLR_CHANGES}
        26: {id: clr_changes, doc: Sets the counts of GET_CHANGES and GET_BUMPS to zero}
        27: {id: ready_pct, doc: "Sets type and mode, waits until the device is ready and reads percent values"}
        28: {id: ready_raw, doc: "Sets type and mode, waits until the device is ready and reads raw values"}
        29: {id: ready_si, doc: "Sets type and mode, waits until the device is ready and reads SI values"}
        30: {id: get_minmax, doc: Reports the range of SI values of the current mode}
        31: {id: get_bumps, doc: Reads how often a touch sensor changed to released since CLR_CHANGES}
  family_file:
    doc: "Works on files, folders, data logs, program images and the list of recent files"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            0: op_file_open_append
            1: op_file_open_read
            2: op_file_open_write
            3: op_file_read_value
            4: op_file_write_value
            5: op_file_read_text
            6: op_file_write_text
            7: op_file_close
            8: op_file_load_image
            9: op_file_get_handle
            10: op_file_make_folder
            11: op_file_get_pool
            12: op_file_set_log_sync_time
            13: op_file_get_folders
            14: op_file_get_log_sync_time
            15: op_file_get_subfolder_name
            16: op_file_write_log
            17: op_file_close_log
            18: op_file_get_image
            19: op_file_get_item
            20: op_file_get_cache_files
            21: op_file_put_cache_file
            22: op_file_get_cache_file
            23: op_file_del_cache_file
            24: op_file_del_subfolder
            25: op_file_get_log_name
            27: op_file_open_log
            28: op_file_read_bytes
            29: op_file_write_bytes
            30: op_file_remove
            31: op_file_move
    instances:
      cmd_name: {value: cmd.value, enum: cmd_file}
    enums:
      cmd_file:
        0: {id: open_append, doc: "Opens a file for appending; creates it if it does not exist"}
        1: {id: open_read, doc: Opens a file for reading}
        2: {id: open_write, doc: Creates or truncates a file and opens it for writing}
        3: {id: read_value, doc: Reads the text up to the next delimiter and turns it into a number}
        4: {id: write_value, doc: "Writes a number as text, and a delimiter after it"}
        5: {id: read_text, doc: Reads text up to the next delimiter}
        6: {id: write_text, doc: "Writes text without its zero, and a delimiter after it"}
        7: {id: close, doc: Closes a file and frees its handle}
        8: {id: load_image, doc: "Loads a program file into a stopped slot, for PROGRAM_START to run"}
        9: {id: get_handle, doc: Finds the handle of a file that is already open}
        10: {id: make_folder, doc: Creates a folder unless it exists}
        11: {id: get_pool, doc: Reserves a block of memory for the program}
        12: {id: set_log_sync_time, doc: Stores the time and tick to which data logs are aligned}
        13: {id: get_folders, doc: "Counts the entries of a folder, without hidden ones"}
        14: {id: get_log_sync_time, doc: Reads the time and tick to which data logs are aligned}
        15: {id: get_subfolder_name, doc: Reads the name of one entry of a folder}
        16: {id: write_log, doc: Adds one row of samples to a data log}
        17: {id: close_log, doc: Writes the rest of a data log and closes it}
        18: {id: get_image, doc: "Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails"}
        19: {id: get_item, doc: Finds an entry of a folder by its name}
        20: {id: get_cache_files, doc: Counts the recently run files}
        21: {id: put_cache_file, doc: Puts a file first in the list of recently run files}
        22: {id: get_cache_file, doc: Reads the path of one recently run file}
        23: {id: del_cache_file, doc: Removes a file from the list of recently run files}
        24: {id: del_subfolder, doc: Deletes one entry of a folder together with the files in it}
        25: {id: get_log_name, doc: Reads the path of the open data log}
        27: {id: open_log, doc: Creates a data log and writes its header}
        28: {id: read_bytes, doc: Reads raw bytes from a file}
        29: {id: write_bytes, doc: Writes raw bytes to a file}
        30: {id: remove, doc: "Deletes a file, or a folder with the files in it"}
        31: {id: move, doc: "Copies a file or folder and replaces the destination; the source is kept"}
  family_array:
    doc: "Creates, fills, copies and resizes arrays"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            0: op_array_delete
            1: op_array_create8
            2: op_array_create16
            3: op_array_create32
            4: op_array_createf
            5: op_array_resize
            6: op_array_fill
            7: op_array_copy
            8: op_array_init8
            9: op_array_init16
            10: op_array_init32
            11: op_array_initf
            12: op_array_size
            13: op_array_read_content
            14: op_array_write_content
            15: op_array_read_size
    instances:
      cmd_name: {value: cmd.value, enum: cmd_array}
    enums:
      cmd_array:
        0: {id: delete_, doc: Deletes an array and frees its handle}
        1: {id: create8, doc: Creates an array of DATA8 elements}
        2: {id: create16, doc: Creates an array of DATA16 elements}
        3: {id: create32, doc: Creates an array of DATA32 elements}
        4: {id: createf, doc: Creates an array of DATAF elements}
        5: {id: resize, doc: Changes the number of elements of an array}
        6: {id: fill, doc: Sets every element of an array to one value}
        7: {id: copy, doc: "Copies the content of one array into another of the same type, which is resized to match"}
        8: {id: init8, doc: "Writes several elements of a DATA8 array, all within its size"}
        9: {id: init16, doc: "Writes several elements of a DATA16 array, all within its size"}
        10: {id: init32, doc: "Writes several elements of a DATA32 array, all within its size"}
        11: {id: initf, doc: "Writes several elements of a DATAF array, all within its size"}
        12: {id: size, doc: Counts the elements of an array}
        13: {id: read_content, doc: "Reads an array's content as bytes, also of another program"}
        14: {id: write_content, doc: "Writes an array's content as bytes; the array then ends after them"}
        15: {id: read_size, doc: "Returns the size of an array's content, also of another program"}
  family_filename:
    doc: "Splits and checks file names, and packs files"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            16: op_filename_exist
            17: op_filename_totalsize
            18: op_filename_split
            19: op_filename_merge
            20: op_filename_check
            21: op_filename_pack
            22: op_filename_unpack
            23: op_filename_get_foldername
    instances:
      cmd_name: {value: cmd.value, enum: cmd_filename}
    enums:
      cmd_filename:
        16: {id: exist, doc: Reports whether a file or folder exists}
        17: {id: totalsize, doc: Reports the number of files in a folder and their size}
        18: {id: split, doc: "Splits a path into folder, name and extension"}
        19: {id: merge, doc: "Builds a path from folder, name and extension"}
        20: {id: check, doc: "Reports whether a path's characters and lengths are allowed; the file need not exist"}
        21: {id: pack, doc: Packs a file or folder into a .raf archive beside it}
        22: {id: unpack, doc: Unpacks a .raf archive into the folder it is in}
        23: {id: get_foldername, doc: "Reads the path of the program's own folder"}
  family_com_read:
    doc: "Fetches direct commands, for the brick's own command program"
    seq:
      - {id: cmd, type: argument(false)}
      - {id: parameters, type: {switch-on: cmd.value, cases: {14: op_com_read_command}}}
    instances:
      cmd_name: {value: cmd.value, enum: cmd_com_read}
    enums:
      cmd_com_read: {14: {id: command, doc: Returns the address of the last direct command received}}
  family_com_write:
    doc: "Answers direct commands, for the brick's own command program"
    seq:
      - {id: cmd, type: argument(false)}
      - {id: parameters, type: {switch-on: cmd.value, cases: {14: op_com_write_reply}}}
    instances:
      cmd_name: {value: cmd.value, enum: cmd_com_write}
    enums:
      cmd_com_write: {14: {id: reply, doc: Sends the global memory of a direct command that has run as its reply}}
  family_com_get:
    doc: "Asks about the brick's connections and the devices around it"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_com_get_get_on_off
            2: op_com_get_get_visible
            4: op_com_get_get_result
            5: op_com_get_get_pin
            8: op_com_get_search_items
            9: op_com_get_search_item
            10: op_com_get_favour_items
            11: op_com_get_favour_item
            12: op_com_get_get_id
            13: op_com_get_get_brickname
            14: op_com_get_get_network
            15: op_com_get_get_present
            16: op_com_get_get_encrypt
            17: op_com_get_connec_items
            18: op_com_get_connec_item
            19: op_com_get_get_incoming
            20: op_com_get_get_mode2
    instances:
      cmd_name: {value: cmd.value, enum: cmd_com_get}
    enums:
      cmd_com_get:
        1: {id: get_on_off, doc: Reports whether Bluetooth or WiFi is on}
        2: {id: get_visible, doc: Reports whether other devices can see the brick by Bluetooth}
        4: {id: get_result, doc: Reports the state of a search or connection request}
        5: {id: get_pin, doc: "Reads the PIN for a device, always 1234"}
        8: {id: search_items, doc: Counts the devices or networks that a search found}
        9: {id: search_item, doc: Describes one device or network that a search found}
        10: {id: favour_items, doc: "Counts the paired devices, in range or not"}
        11: {id: favour_item, doc: Describes one paired device or known network}
        12: {id: get_id, doc: "Reads the brick's Bluetooth address"}
        13: {id: get_brickname, doc: "Reads the brick's name"}
        14: {id: get_network, doc: "Reads network name and addresses, WiFi only"}
        15: {id: get_present, doc: "Reports whether the hardware is present (for WiFi: a known dongle)"}
        16: {id: get_encrypt, doc: "Reports the encryption of a network, WiFi only"}
        17: {id: connec_items, doc: "Counts the connected devices, Bluetooth only"}
        18: {id: connec_item, doc: "Describes one connected device, Bluetooth only"}
        19: {id: get_incoming, doc: "Reports which device asks for a connection, Bluetooth only"}
        20: {id: get_mode2, doc: Reports whether Bluetooth is in its mode for Apple devices}
  family_com_set:
    doc: "Changes the brick's name, its connections and its lists of devices"
    seq:
      - {id: cmd, type: argument(false)}
      - id: parameters
        type:
          switch-on: cmd.value
          cases:
            1: op_com_set_set_on_off
            2: op_com_set_set_visible
            3: op_com_set_set_search
            5: op_com_set_set_pin
            6: op_com_set_set_passkey
            7: op_com_set_set_connection
            8: op_com_set_set_brickname
            9: op_com_set_set_moveup
            10: op_com_set_set_movedown
            11: op_com_set_set_encrypt
            12: op_com_set_set_ssid
            13: op_com_set_set_mode2
    instances:
      cmd_name: {value: cmd.value, enum: cmd_com_set}
    enums:
      cmd_com_set:
        1: {id: set_on_off, doc: Switches Bluetooth or WiFi on or off}
        2: {id: set_visible, doc: "Makes the brick visible or invisible, Bluetooth only"}
        3: {id: set_search, doc: Starts or stops the search for devices or networks}
        5: {id: set_pin, doc: "Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi)"}
        6: {id: set_passkey, doc: "Answers the request to confirm a passkey, Bluetooth only"}
        7: {id: set_connection, doc: "Connects a device or network, or ends a Bluetooth connection"}
        8: {id: set_brickname, doc: Renames the brick}
        9: {id: set_moveup, doc: "Moves a network up in the list, WiFi only"}
        10: {id: set_movedown, doc: "Moves a network down in the list, WiFi only"}
        11: {id: set_encrypt, doc: "Sets the encryption of a network, WiFi only"}
        12: {id: set_ssid, doc: "Adds a network to the end of the list, WiFi only"}
        13: {id: set_mode2, doc: Switches the Bluetooth mode for Apple devices on or off}
  op_program_stop:
    doc: Stops the program of a slot
    seq:
      - id: prgid
        type: argument(false)
        doc: "program slot to stop (0: all programs; -1: the calling program; a member of SLOT)"
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_program_start:
    doc: "Starts a loaded program; a direct command can do this only while no user program runs"
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: size, type: argument(false), doc: "size of the image; read and ignored (bytes)"}
      - {id: ip, type: argument(false), doc: "address of the image, as FILE.LOAD_IMAGE returned it"}
      - {id: debug, type: argument(false), doc: "how to run it (0 to 2; 0: run; 1: debug; 2: load, do not run)"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_object_stop:
    doc: Stops an object of its own program
    seq:
      - {id: objid, type: argument(false), doc: "object of the program, counted from 1"}
  op_object_start:
    doc: Starts an object of its own program
    seq:
      - {id: objid, type: argument(false), doc: "object of the program, counted from 1"}
  op_object_trig:
    doc: "Counts an object's trigger down; at zero the object starts"
    seq:
      - {id: objid, type: argument(false), doc: "object of the program, counted from 1"}
  op_object_wait:
    doc: Waits until an object has ended
    seq:
      - {id: objid, type: argument(false), doc: "object of the program, counted from 1"}
  op_call:
    doc: "Calls a subroutine of its own program; waits while another thread runs it"
    seq:
      - {id: objid, type: argument(false), doc: "object number of the subroutine, counted from 1"}
      - id: parameters_count
        type: argument(false)
        doc: "number of parameters follow; the subroutine declares their types and directions (each is DATA32)"
      - {id: parameters, type: argument(false), repeat: expr, repeat-expr: parameters_count.value}
  op_program_info_obj_stop:
    doc: Stops an object of a running program
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: objid, type: argument(false), doc: "object of the program, counted from 1"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_program_info_obj_start:
    doc: Starts an object of a running program from its beginning
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: objid, type: argument(false), doc: "object of the program, counted from 1"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_program_info_get_status:
    doc: Asks whether a program runs
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: data, type: argument(false), doc: state of the program (a member of OBJSTAT)}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_program_info_get_speed:
    doc: "Asks for a program's speed"
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: data, type: argument(false), doc: speed since the program started (instructions/s)}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_program_info_get_prgresult:
    doc: Asks how a program ended
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: data, type: argument(false), doc: "OK, BUSY (still running) or FAIL (a member of RESULT)"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_program_info_set_instr:
    doc: Sets how many instructions the calling thread may still run in its time slice
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_label:
    doc: "Marks a place that jumps can name; does nothing itself"
    seq:
      - {id: "no", type: argument(false), doc: number of the label (0 to 31)}
  op_probe:
    doc: "Prints a program's memory on the brick's debug terminal"
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: objid, type: argument(false), doc: "object whose local memory to print (0: the global memory)"}
      - {id: offset, type: argument(false), doc: first byte (bytes)}
      - {id: size, type: argument(false), doc: "number of bytes to print (0 to 1024 bytes; 0: all, 1024 at most)"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_do:
    doc: "Runs byte code that is already in memory, ending the slot's previous program"
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: image, type: argument(false), doc: address of the byte code image}
      - {id: global_, type: argument(false), doc: address of the global memory it uses}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_system:
    doc: "Runs a shell command on the brick's Linux and waits until it ends"
    seq:
      - {id: command, type: argument(false), doc: the command line}
      - id: status
        type: argument(false)
        doc: "wait status as C's system() gives it: 256 times the exit code (0: success; -1: could not run)"
  op_port_cnv_output:
    doc: "Splits a motor port number as LEGO's editor writes it"
    seq:
      - id: portin
        type: argument(false)
        doc: "three decimal digits, each 1-4: layer, first port, second port (123: B and C)"
      - {id: layer, type: argument(false), doc: "position in the daisy chain (0 to 3; 0: this brick)"}
      - {id: bitfield, type: argument(false), doc: "motor ports as bits: A=1 B=2 C=4 D=8 (0 to 15)"}
      - id: inverted
        type: argument(false)
        doc: "whether the first port comes after the second, as in CA (0 to 1; 0: no; 1: yes)"
  op_port_cnv_input:
    doc: "Splits a sensor port number as LEGO's editor writes it"
    seq:
      - {id: portin, type: argument(false), doc: "three decimal digits: layer 1-4, any, port 1-4 (103: port 3)"}
      - {id: layer, type: argument(false), doc: "position in the daisy chain (0 to 3; 0: this brick)"}
      - {id: portout, type: argument(false), doc: "sensor port minus one, as in INPUT_* (0 to 3)"}
  op_note_to_freq:
    doc: Converts the name of a note to its frequency
    seq:
      - {id: note, type: argument(false), doc: "C4 to B6, sharps as C#4"}
      - {id: freq, type: argument(false), doc: "frequency; 440 for an unknown note (262 to 1976 Hz)"}
  op_info_set_error:
    doc: "Adds an error to the brick's error log"
    seq:
      - {id: number, type: argument(false), doc: "number of the error (0: nothing is logged)"}
  op_info_get_error:
    doc: "Removes and returns the oldest error of the brick's error log"
    seq:
      - {id: number, type: argument(false), doc: "number of the error (0: the log is empty)"}
  op_info_errortext:
    doc: Converts the number of an error to its name
    seq:
      - {id: number, type: argument(false), doc: "number of the error (0: gives an empty text)"}
      - {id: length, type: argument(false), doc: "size of the text buffer, including the zero (bytes; -1: no limit)"}
      - id: destination
        type: argument(false)
        doc: "name of the error, at most 31 characters (as many bytes as LENGTH says)"
  op_info_get_volume:
    doc: Reads the volume setting
    seq:
      - {id: value, type: argument(false), doc: "volume (0 to 100 %)"}
  op_info_set_volume:
    doc: Changes the volume setting
    seq:
      - {id: value, type: argument(false), doc: "volume (0 to 100 %)"}
  op_info_get_minutes:
    doc: Reads the idle time after which the brick powers off
    seq:
      - {id: value, type: argument(false), doc: "idle time (0 to 120 min; 0: never)"}
  op_info_set_minutes:
    doc: Changes the idle time after which the brick powers off
    seq:
      - {id: value, type: argument(false), doc: "idle time (0 to 120 min; 0: never)"}
  op_strings_get_size:
    doc: Reads the length of a text
    seq:
      - {id: source1, type: argument(false), doc: text to work on}
      - {id: size, type: argument(false), doc: "its length, not including the zero (bytes)"}
  op_strings_add:
    doc: Joins two texts
    seq:
      - {id: source1, type: argument(false), doc: first part}
      - {id: source2, type: argument(false), doc: second part}
      - {id: destination, type: argument(false), doc: "resulting text, zero-terminated"}
  op_strings_compare:
    doc: "Reports whether two texts are equal; case matters"
    seq:
      - {id: source1, type: argument(false), doc: one text}
      - {id: source2, type: argument(false), doc: the other text}
      - {id: result, type: argument(false), doc: "whether they are equal (0 to 1; 0: different; 1: the same)"}
  op_strings_duplicate:
    doc: Copies a text
    seq:
      - {id: source1, type: argument(false), doc: text to work on}
      - {id: destination, type: argument(false), doc: "resulting text, zero-terminated"}
  op_strings_value_to_string:
    doc: "Writes a floating-point number as text, without trailing zeros"
    seq:
      - {id: value, type: argument(true), doc: "number to write; NaN becomes ----"}
      - {id: figures, type: argument(false), doc: "width, including the point; negative aligns left (characters)"}
      - {id: decimals, type: argument(false), doc: digits after the point}
      - {id: destination, type: argument(false), doc: "resulting text, zero-terminated (at most 128 characters)"}
  op_strings_string_to_value:
    doc: Reads a number from a text
    seq:
      - {id: source1, type: argument(false), doc: "text to read; a comma counts as decimal point"}
      - {id: destination, type: argument(true), doc: the number}
  op_strings_strip:
    doc: Removes every space from a text
    seq:
      - {id: source1, type: argument(false), doc: text to work on}
      - {id: destination, type: argument(false), doc: "resulting text, zero-terminated"}
  op_strings_number_to_string:
    doc: "Writes a whole number as text, with leading zeros"
    seq:
      - {id: value, type: argument(false), doc: number to write}
      - {id: figures, type: argument(false), doc: width of the text (characters)}
      - {id: destination, type: argument(false), doc: "resulting text, zero-terminated (at most 128 characters)"}
  op_strings_sub:
    doc: Returns the part of a text after another text found in it
    seq:
      - {id: source1, type: argument(false), doc: text to search}
      - {id: source2, type: argument(false), doc: "text to find; must occur"}
      - {id: destination, type: argument(false), doc: "resulting text, zero-terminated"}
  op_strings_value_formatted:
    doc: "Writes a floating-point number as text in a format of C's printf"
    seq:
      - {id: value, type: argument(true), doc: number to write}
      - {id: format, type: argument(false), doc: "format, such as %5.2f"}
      - {id: size, type: argument(false), doc: "size of the text buffer, including the zero (bytes)"}
      - {id: destination, type: argument(false), doc: resulting text (as many bytes as SIZE says)}
  op_strings_number_formatted:
    doc: "Writes a whole number as text in a format of C's printf"
    seq:
      - {id: value, type: argument(false), doc: number to write}
      - {id: format, type: argument(false), doc: "format, such as %05d or %X"}
      - {id: size, type: argument(false), doc: "size of the text buffer, including the zero (bytes)"}
      - {id: destination, type: argument(false), doc: resulting text (as many bytes as SIZE says)}
  op_bp_set:
    doc: Sets or removes a breakpoint in a running program
    seq:
      - {id: prgid, type: argument(false), doc: program slot (a member of SLOT)}
      - {id: "no", type: argument(false), doc: "number of the breakpoint (0 to 2; 3: pulse on test pin TP4, no stop)"}
      - {id: address, type: argument(false), doc: "offset in the image (bytes; 0: remove the breakpoint)"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_tst_tst_read_pins:
    doc: Reads the pins of a connector
    seq:
      - id: port
        type: argument(false)
        doc: "connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D (0 to 19)"
      - {id: length, type: argument(false), doc: "number of pins to read, usually 5"}
      - id: string_
        type: argument(false)
        doc: "one character per pin: 0 low, 1 high (as many values as LENGTH says)"
  op_tst_tst_write_pins:
    doc: Sets the pins of a connector
    seq:
      - id: port
        type: argument(false)
        doc: "connector: 0..3 are sensor ports 1-4, 16..19 are motor ports A-D (0 to 19)"
      - {id: length, type: argument(false), doc: "number of pins to set, usually 5"}
      - id: string_
        type: argument(false)
        doc: "one character per pin: 0 low, 1 high, X floating, - unchanged (as many values as LENGTH says)"
  op_tst_tst_read_adc:
    doc: Reads the analog converter
    seq:
      - id: index
        type: argument(false)
        doc: "channel: 0..3 pin 1 and 4..7 pin 6 of sensor ports, 8..11 pin 5 of motor ports (0 to 15; 12: battery temperature; 13: motor current; 14: battery current; 15: battery voltage)"
      - {id: value, type: argument(false), doc: raw reading (0 to 4095 counts)}
  op_tst_tst_write_uart:
    doc: "Sends bytes on a sensor port's serial line"
    seq:
      - {id: port, type: argument(false), doc: sensor port minus one (0 to 3)}
      - {id: length, type: argument(false), doc: number of bytes to send (0 to 63 bytes)}
      - {id: string_, type: argument(false), doc: the bytes (as many values as LENGTH says)}
  op_tst_tst_read_uart:
    doc: "Reads the bytes received on a sensor port's serial line"
    seq:
      - {id: port, type: argument(false), doc: sensor port minus one (0 to 3)}
      - {id: length, type: argument(false), doc: number of bytes to read (0 to 63 bytes)}
      - {id: string_, type: argument(false), doc: "the bytes, padded with zeros (as many values as LENGTH says)"}
  op_tst_tst_enable_uart:
    doc: Switches the serial lines of all sensor ports on
    seq:
      - {id: bitrate, type: argument(false), doc: speed of the line (2400 to 115200 bit/s)}
  op_tst_tst_accu_switch:
    doc: Reads the switch that senses the rechargeable battery
    seq:
      - id: active
        type: argument(false)
        doc: "state of the switch (0 to 1; 0: other batteries; 1: rechargeable battery)"
  op_tst_tst_poll_mode2:
    doc: Asks for the state of the start of Bluetooth mode 2
    seq:
      - {id: status, type: argument(false), doc: "OK, BUSY (still starting) or FAIL (0 to 2; a member of RESULT)"}
  op_tst_tst_ram_check:
    doc: Asks for the result of the memory test at power-on
    seq:
      - {id: status, type: argument(false), doc: "OK or FAIL (0 to 2; a member of RESULT)"}
  op_add8:
    doc: Adds two 8-bit numbers
    seq:
      - {id: source1, type: argument(false), doc: first number}
      - {id: source2, type: argument(false), doc: second number}
      - {id: destination, type: argument(false), doc: their sum}
  op_add16:
    doc: Adds two 16-bit numbers
    seq:
      - {id: source1, type: argument(false), doc: first number}
      - {id: source2, type: argument(false), doc: second number}
      - {id: destination, type: argument(false), doc: their sum}
  op_add32:
    doc: Adds two 32-bit numbers
    seq:
      - {id: source1, type: argument(false), doc: first number}
      - {id: source2, type: argument(false), doc: second number}
      - {id: destination, type: argument(false), doc: their sum}
  op_addf:
    doc: Adds two floating-point numbers
    seq:
      - {id: source1, type: argument(true), doc: first number}
      - {id: source2, type: argument(true), doc: second number}
      - {id: destination, type: argument(true), doc: their sum}
  op_sub8:
    doc: Subtracts one 8-bit number from another
    seq:
      - {id: source1, type: argument(false), doc: number to subtract from}
      - {id: source2, type: argument(false), doc: number to subtract}
      - {id: destination, type: argument(false), doc: SOURCE1 less SOURCE2}
  op_sub16:
    doc: Subtracts one 16-bit number from another
    seq:
      - {id: source1, type: argument(false), doc: number to subtract from}
      - {id: source2, type: argument(false), doc: number to subtract}
      - {id: destination, type: argument(false), doc: SOURCE1 less SOURCE2}
  op_sub32:
    doc: Subtracts one 32-bit number from another
    seq:
      - {id: source1, type: argument(false), doc: number to subtract from}
      - {id: source2, type: argument(false), doc: number to subtract}
      - {id: destination, type: argument(false), doc: SOURCE1 less SOURCE2}
  op_subf:
    doc: Subtracts one floating-point number from another
    seq:
      - {id: source1, type: argument(true), doc: number to subtract from}
      - {id: source2, type: argument(true), doc: number to subtract}
      - {id: destination, type: argument(true), doc: SOURCE1 less SOURCE2}
  op_mul8:
    doc: Multiplies two 8-bit numbers
    seq:
      - {id: source1, type: argument(false), doc: first factor}
      - {id: source2, type: argument(false), doc: second factor}
      - {id: destination, type: argument(false), doc: their product}
  op_mul16:
    doc: Multiplies two 16-bit numbers
    seq:
      - {id: source1, type: argument(false), doc: first factor}
      - {id: source2, type: argument(false), doc: second factor}
      - {id: destination, type: argument(false), doc: their product}
  op_mul32:
    doc: Multiplies two 32-bit numbers
    seq:
      - {id: source1, type: argument(false), doc: first factor}
      - {id: source2, type: argument(false), doc: second factor}
      - {id: destination, type: argument(false), doc: their product}
  op_mulf:
    doc: Multiplies two floating-point numbers
    seq:
      - {id: source1, type: argument(true), doc: first factor}
      - {id: source2, type: argument(true), doc: second factor}
      - {id: destination, type: argument(true), doc: their product}
  op_div8:
    doc: "Divides two 8-bit numbers; by zero gives the largest or smallest value"
    seq:
      - {id: source1, type: argument(false), doc: number to divide}
      - {id: source2, type: argument(false), doc: number to divide by}
      - {id: destination, type: argument(false), doc: "quotient, cut off towards zero (0 for 0 / 0)"}
  op_div16:
    doc: "Divides two 16-bit numbers; by zero gives the largest or smallest value"
    seq:
      - {id: source1, type: argument(false), doc: number to divide}
      - {id: source2, type: argument(false), doc: number to divide by}
      - {id: destination, type: argument(false), doc: "quotient, cut off towards zero (0 for 0 / 0)"}
  op_div32:
    doc: "Divides two 32-bit numbers; by zero gives the largest or smallest value"
    seq:
      - {id: source1, type: argument(false), doc: number to divide}
      - {id: source2, type: argument(false), doc: number to divide by}
      - {id: destination, type: argument(false), doc: "quotient, cut off towards zero (0 for 0 / 0)"}
  op_divf:
    doc: "Divides two floating-point numbers; by zero gives infinity or NaN"
    seq:
      - {id: source1, type: argument(true), doc: number to divide}
      - {id: source2, type: argument(true), doc: number to divide by}
      - {id: destination, type: argument(true), doc: quotient}
  op_or8:
    doc: "Combines 8-bit values, bit by bit, by OR"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in either}
  op_or16:
    doc: "Combines 16-bit values, bit by bit, by OR"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in either}
  op_or32:
    doc: "Combines 32-bit values, bit by bit, by OR"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in either}
  op_and8:
    doc: "Combines 8-bit values, bit by bit, by AND"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in both}
  op_and16:
    doc: "Combines 16-bit values, bit by bit, by AND"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in both}
  op_and32:
    doc: "Combines 32-bit values, bit by bit, by AND"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in both}
  op_xor8:
    doc: "Combines 8-bit values, bit by bit, by exclusive OR"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in just one of the two}
  op_xor16:
    doc: "Combines 16-bit values, bit by bit, by exclusive OR"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in just one of the two}
  op_xor32:
    doc: "Combines 32-bit values, bit by bit, by exclusive OR"
    seq:
      - {id: source1, type: argument(false), doc: first}
      - {id: source2, type: argument(false), doc: second}
      - {id: destination, type: argument(false), doc: bits set in just one of the two}
  op_rl8:
    doc: "Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost"
    seq:
      - {id: source1, type: argument(false), doc: value to shift}
      - {id: source2, type: argument(false), doc: number of places (bits)}
      - {id: destination, type: argument(false), doc: "shifted value, filled up with zero bits"}
  op_rl16:
    doc: "Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost"
    seq:
      - {id: source1, type: argument(false), doc: value to shift}
      - {id: source2, type: argument(false), doc: number of places (bits)}
      - {id: destination, type: argument(false), doc: "shifted value, filled up with zero bits"}
  op_rl32:
    doc: "Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost"
    seq:
      - {id: source1, type: argument(false), doc: value to shift}
      - {id: source2, type: argument(false), doc: number of places (bits)}
      - {id: destination, type: argument(false), doc: "shifted value, filled up with zero bits"}
  op_math_exp:
    doc: Raises e to a power
    seq:
      - {id: x, type: argument(true), doc: the power}
      - {id: r, type: argument(true), doc: result}
  op_math_mod:
    doc: Takes the remainder of a floating-point division
    seq:
      - {id: x, type: argument(true), doc: number to divide}
      - {id: "y", type: argument(true), doc: number to divide by}
      - {id: r, type: argument(true), doc: "remainder, with the sign of X"}
  op_math_floor:
    doc: Rounds down to a whole number
    seq:
      - {id: x, type: argument(true), doc: number to work on}
      - {id: r, type: argument(true), doc: result}
  op_math_ceil:
    doc: Rounds up to a whole number
    seq:
      - {id: x, type: argument(true), doc: number to work on}
      - {id: r, type: argument(true), doc: result}
  op_math_round:
    doc: "Rounds to the nearest whole number, halves away from zero"
    seq:
      - {id: x, type: argument(true), doc: number to work on}
      - {id: r, type: argument(true), doc: result}
  op_math_abs:
    doc: Drops the sign
    seq:
      - {id: x, type: argument(true), doc: number to work on}
      - {id: r, type: argument(true), doc: result}
  op_math_negate:
    doc: Reverses the sign
    seq:
      - {id: x, type: argument(true), doc: number to work on}
      - {id: r, type: argument(true), doc: result}
  op_math_sqrt:
    doc: Takes the square root
    seq:
      - {id: x, type: argument(true), doc: "number to work on, not negative"}
      - {id: r, type: argument(true), doc: result}
  op_math_log:
    doc: Takes the logarithm to base 10
    seq:
      - {id: x, type: argument(true), doc: "number to work on, above 0"}
      - {id: r, type: argument(true), doc: result}
  op_math_ln:
    doc: Takes the natural logarithm
    seq:
      - {id: x, type: argument(true), doc: "number to work on, above 0"}
      - {id: r, type: argument(true), doc: result}
  op_math_sin:
    doc: Takes the sine of an angle in degrees
    seq:
      - {id: x, type: argument(true), doc: angle (degrees)}
      - {id: r, type: argument(true), doc: "sine, -1 to 1"}
  op_math_cos:
    doc: Takes the cosine of an angle in degrees
    seq:
      - {id: x, type: argument(true), doc: angle (degrees)}
      - {id: r, type: argument(true), doc: "cosine, -1 to 1"}
  op_math_tan:
    doc: Takes the tangent of an angle in degrees
    seq:
      - {id: x, type: argument(true), doc: angle (degrees)}
      - {id: r, type: argument(true), doc: tangent}
  op_math_asin:
    doc: Finds the angle that has a sine
    seq:
      - {id: x, type: argument(true), doc: sine (-1 to 1)}
      - {id: r, type: argument(true), doc: angle (degrees)}
  op_math_acos:
    doc: Finds the angle that has a cosine
    seq:
      - {id: x, type: argument(true), doc: cosine (-1 to 1)}
      - {id: r, type: argument(true), doc: angle (degrees)}
  op_math_atan:
    doc: Finds the angle that has a tangent
    seq:
      - {id: x, type: argument(true), doc: tangent}
      - {id: r, type: argument(true), doc: angle (degrees)}
  op_math_mod8:
    doc: Takes the remainder of an 8-bit division
    seq:
      - {id: x, type: argument(false), doc: number to divide}
      - {id: "y", type: argument(false), doc: "number to divide by, not 0"}
      - {id: r, type: argument(false), doc: "remainder, with the sign of X"}
  op_math_mod16:
    doc: Takes the remainder of a 16-bit division
    seq:
      - {id: x, type: argument(false), doc: number to divide}
      - {id: "y", type: argument(false), doc: "number to divide by, not 0"}
      - {id: r, type: argument(false), doc: "remainder, with the sign of X"}
  op_math_mod32:
    doc: Takes the remainder of a 32-bit division
    seq:
      - {id: x, type: argument(false), doc: number to divide}
      - {id: "y", type: argument(false), doc: "number to divide by, not 0"}
      - {id: r, type: argument(false), doc: "remainder, with the sign of X"}
  op_math_pow:
    doc: Raises a number to a power
    seq:
      - {id: x, type: argument(true), doc: number to raise}
      - {id: "y", type: argument(true), doc: the power}
      - {id: r, type: argument(true), doc: result}
  op_math_trunc:
    doc: Cuts off decimals without rounding
    seq:
      - {id: x, type: argument(true), doc: number to work on}
      - {id: p, type: argument(false), doc: number of decimals to keep (at most 6 are available) (0 to 9)}
      - {id: r, type: argument(true), doc: result}
  op_random:
    doc: Draws a random whole number
    seq:
      - {id: min, type: argument(false), doc: smallest number to draw}
      - {id: max, type: argument(false), doc: largest number to draw}
      - {id: value, type: argument(false), doc: "the number drawn, MIN to MAX, both included"}
  op_init_bytes:
    doc: Fills consecutive bytes of memory with constant values
    seq:
      - {id: destination, type: argument(false), doc: first byte to fill (as many values as LENGTH says)}
      - id: length
        type: argument(false)
        doc: "number of values that follow; a negative count hangs the brick (bytes)"
      - id: source
        type: argument(false)
        repeat: expr
        repeat-expr: length.value
        doc: "the values, one per byte (each is DATA8)"
  op_move8_8:
    doc: "Copies a value to another variable, both 8-bit"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move8_16:
    doc: "Converts a value, 8-bit to 16-bit; NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move8_32:
    doc: "Converts a value, 8-bit to 32-bit; NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move8_f:
    doc: "Converts a value, 8-bit to floating-point; NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(true), doc: copy of the value}
  op_move16_8:
    doc: "Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move16_16:
    doc: "Copies a value to another variable, both 16-bit"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move16_32:
    doc: "Converts a value, 16-bit to 32-bit; NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move16_f:
    doc: "Converts a value, 16-bit to floating-point; NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(true), doc: copy of the value}
  op_move32_8:
    doc: "Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move32_16:
    doc: "Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move32_32:
    doc: "Copies a value to another variable, both 32-bit"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_move32_f:
    doc: "Converts a value, 32-bit to floating-point; NaN stays NaN"
    seq:
      - {id: source, type: argument(false), doc: value to copy}
      - {id: destination, type: argument(true), doc: copy of the value}
  op_movef_8:
    doc: "Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN"
    seq:
      - {id: source, type: argument(true), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_movef_16:
    doc: "Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN"
    seq:
      - {id: source, type: argument(true), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_movef_32:
    doc: "Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN"
    seq:
      - {id: source, type: argument(true), doc: value to copy}
      - {id: destination, type: argument(false), doc: copy of the value}
  op_movef_f:
    doc: "Copies a value to another variable, both floating-point"
    seq:
      - {id: source, type: argument(true), doc: value to copy}
      - {id: destination, type: argument(true), doc: copy of the value}
  op_read8:
    doc: Reads one element of an array of 8-bit values
    seq:
      - {id: source, type: argument(false), doc: "first element of the array, as a variable"}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - {id: destination, type: argument(false), doc: "the element's value"}
  op_read16:
    doc: Reads one element of an array of 16-bit values
    seq:
      - {id: source, type: argument(false), doc: "first element of the array, as a variable"}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - {id: destination, type: argument(false), doc: "the element's value"}
  op_read32:
    doc: Reads one element of an array of 32-bit values
    seq:
      - {id: source, type: argument(false), doc: "first element of the array, as a variable"}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - {id: destination, type: argument(false), doc: "the element's value"}
  op_readf:
    doc: Reads one element of an array of floating-point values
    seq:
      - {id: source, type: argument(true), doc: "first element of the array, as a variable"}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - {id: destination, type: argument(true), doc: "the element's value"}
  op_write8:
    doc: Writes one element of an array of 8-bit values
    seq:
      - {id: source, type: argument(false), doc: value to write}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - id: destination
        type: argument(false)
        doc: "first element of the array, as a variable; element INDEX is written"
  op_write16:
    doc: Writes one element of an array of 16-bit values
    seq:
      - {id: source, type: argument(false), doc: value to write}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - id: destination
        type: argument(false)
        doc: "first element of the array, as a variable; element INDEX is written"
  op_write32:
    doc: Writes one element of an array of 32-bit values
    seq:
      - {id: source, type: argument(false), doc: value to write}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - id: destination
        type: argument(false)
        doc: "first element of the array, as a variable; element INDEX is written"
  op_writef:
    doc: Writes one element of an array of floating-point values
    seq:
      - {id: source, type: argument(true), doc: value to write}
      - id: index
        type: argument(false)
        doc: "which element, counted from 0; the firmware does not check it (0 to 127)"
      - id: destination
        type: argument(true)
        doc: "first element of the array, as a variable; element INDEX is written"
  op_jr:
    doc: Jumps always
    seq:
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_false:
    doc: Jumps if a flag is 0
    seq:
      - {id: flag, type: argument(false), doc: "the condition: anything but 0 is true (0: false; 1: true)"}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_true:
    doc: Jumps if a flag is not 0
    seq:
      - {id: flag, type: argument(false), doc: "the condition: anything but 0 is true (0: false; 1: true)"}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_nan:
    doc: "Jumps if a value is not a number, as read from a sensor without data"
    seq:
      - {id: value, type: argument(true), doc: value to look at}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lt8:
    doc: "Jumps if LEFT is less than RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lt16:
    doc: "Jumps if LEFT is less than RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lt32:
    doc: "Jumps if LEFT is less than RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_ltf:
    doc: "Jumps if LEFT is less than RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gt8:
    doc: "Jumps if LEFT is greater than RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gt16:
    doc: "Jumps if LEFT is greater than RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gt32:
    doc: "Jumps if LEFT is greater than RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gtf:
    doc: "Jumps if LEFT is greater than RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_eq8:
    doc: "Jumps if LEFT is equal to RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_eq16:
    doc: "Jumps if LEFT is equal to RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_eq32:
    doc: "Jumps if LEFT is equal to RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_eqf:
    doc: "Jumps if LEFT is equal to RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_neq8:
    doc: "Jumps if LEFT is different from RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_neq16:
    doc: "Jumps if LEFT is different from RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_neq32:
    doc: "Jumps if LEFT is different from RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_neqf:
    doc: "Jumps if LEFT is different from RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lteq8:
    doc: "Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lteq16:
    doc: "Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lteq32:
    doc: "Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_lteqf:
    doc: "Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gteq8:
    doc: "Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gteq16:
    doc: "Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gteq32:
    doc: "Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_jr_gteqf:
    doc: "Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - id: offset
        type: argument(false)
        doc: "how far to jump from the end of this operation; negative jumps back; or a label (bytes)"
  op_cp_lt8:
    doc: "Tests whether LEFT is less than RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_lt16:
    doc: "Tests whether LEFT is less than RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_lt32:
    doc: "Tests whether LEFT is less than RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_ltf:
    doc: "Tests whether LEFT is less than RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gt8:
    doc: "Tests whether LEFT is greater than RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gt16:
    doc: "Tests whether LEFT is greater than RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gt32:
    doc: "Tests whether LEFT is greater than RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gtf:
    doc: "Tests whether LEFT is greater than RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_eq8:
    doc: "Tests whether LEFT is equal to RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_eq16:
    doc: "Tests whether LEFT is equal to RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_eq32:
    doc: "Tests whether LEFT is equal to RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_eqf:
    doc: "Tests whether LEFT is equal to RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_neq8:
    doc: "Tests whether LEFT is different from RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_neq16:
    doc: "Tests whether LEFT is different from RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_neq32:
    doc: "Tests whether LEFT is different from RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_neqf:
    doc: "Tests whether LEFT is different from RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_lteq8:
    doc: "Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_lteq16:
    doc: "Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_lteq32:
    doc: "Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_lteqf:
    doc: "Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gteq8:
    doc: "Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gteq16:
    doc: "Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gteq32:
    doc: "Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers"
    seq:
      - {id: left, type: argument(false), doc: left side of the comparison}
      - {id: right, type: argument(false), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_cp_gteqf:
    doc: "Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers"
    seq:
      - {id: left, type: argument(true), doc: left side of the comparison}
      - {id: right, type: argument(true), doc: right side of the comparison}
      - {id: flag, type: argument(false), doc: "result of the comparison (0 to 1; 0: false; 1: true)"}
  op_select8:
    doc: Selects one of two 8-bit values by a flag
    seq:
      - {id: flag, type: argument(false), doc: "which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)"}
      - {id: source1, type: argument(false), doc: value selected if the flag is set}
      - {id: source2, type: argument(false), doc: value selected if the flag is 0}
      - {id: result, type: argument(false), doc: the selected value}
  op_select16:
    doc: Selects one of two 16-bit values by a flag
    seq:
      - {id: flag, type: argument(false), doc: "which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)"}
      - {id: source1, type: argument(false), doc: value selected if the flag is set}
      - {id: source2, type: argument(false), doc: value selected if the flag is 0}
      - {id: result, type: argument(false), doc: the selected value}
  op_select32:
    doc: Selects one of two 32-bit values by a flag
    seq:
      - {id: flag, type: argument(false), doc: "which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)"}
      - {id: source1, type: argument(false), doc: value selected if the flag is set}
      - {id: source2, type: argument(false), doc: value selected if the flag is 0}
      - {id: result, type: argument(false), doc: the selected value}
  op_selectf:
    doc: Selects one of two floating-point values by a flag
    seq:
      - {id: flag, type: argument(false), doc: "which one: anything but 0 selects SOURCE1 (0: SOURCE2; 1: SOURCE1)"}
      - {id: source1, type: argument(true), doc: value selected if the flag is set}
      - {id: source2, type: argument(true), doc: value selected if the flag is 0}
      - {id: result, type: argument(true), doc: the selected value}
  op_ui_read_get_vbatt:
    doc: Reads the battery voltage
    seq:
      - {id: value, type: argument(true), doc: voltage (V)}
  op_ui_read_get_ibatt:
    doc: Reads the battery current
    seq:
      - {id: value, type: argument(true), doc: current (A)}
  op_ui_read_get_os_vers:
    doc: Reads name and version of the operating system
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - id: destination
        type: argument(false)
        doc: "system and kernel release, such as Linux 2.6.33-rc4 (as many bytes as LENGTH says)"
  op_ui_read_get_event:
    doc: "Reads and clears the pending event (used by the brick's own menus)"
    seq:
      - id: event_
        type: argument(false)
        doc: "what happened (0: nothing; 1: Bluetooth asks for a PIN; 2: Bluetooth asks to confirm a connection)"
  op_ui_read_get_tbatt:
    doc: "Reads the rise in battery temperature, estimated from the current"
    seq:
      - {id: value, type: argument(true), doc: "estimated rise in temperature (°C)"}
  op_ui_read_get_iint:
    doc: Reads the battery current smoothed over time
    seq:
      - {id: iint, type: argument(true), doc: integrated current (A)}
  op_ui_read_get_imotor:
    doc: Reads the current of all motors together
    seq:
      - {id: value, type: argument(true), doc: current (A)}
  op_ui_read_get_string:
    doc: Waits for a line typed at the terminal and reads it
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, not including the zero (0 to 127 bytes)"
      - {id: destination, type: argument(false), doc: the line (as many bytes as LENGTH says)}
  op_ui_read_get_hw_vers:
    doc: Reads the hardware version
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - {id: destination, type: argument(false), doc: "hardware version, such as V0.60 (as many bytes as LENGTH says)"}
  op_ui_read_get_fw_vers:
    doc: Reads the firmware version
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - {id: destination, type: argument(false), doc: "firmware version, such as V1.04H (as many bytes as LENGTH says)"}
  op_ui_read_get_fw_build:
    doc: Reads the build time of the firmware
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - {id: destination, type: argument(false), doc: build time as yymmddhhmm (as many bytes as LENGTH says)}
  op_ui_read_get_os_build:
    doc: Reads the build time of the operating system
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - {id: destination, type: argument(false), doc: build time as yymmddhhmm (as many bytes as LENGTH says)}
  op_ui_read_get_address:
    doc: Waits for a decimal number typed at the terminal and reads it (debugging)
    seq:
      - {id: value, type: argument(false), doc: "the number, meant as an address"}
  op_ui_read_get_code:
    doc: Waits for byte code typed as hex at the terminal and builds a program from it (debugging)
    seq:
      - {id: length, type: argument(false), doc: "maximum number of bytes of the program, including headers (bytes)"}
      - {id: image, type: argument(false), doc: address of the memory where the program is built}
      - {id: global_, type: argument(false), doc: "address of the program's global variables"}
      - {id: flag, type: argument(false), doc: "whether the program can be started; 1 or unchanged (1: ready)"}
  op_ui_read_key:
    doc: Takes one key from the terminal without waiting
    seq:
      - {id: value, type: argument(false), doc: "character code of the key (0: no key)"}
  op_ui_read_get_shutdown:
    doc: "Reads and clears the request to shut down (used by the brick's own menus)"
    seq:
      - {id: flag, type: argument(false), doc: "whether the brick wants to shut down (0 to 1; 0: no; 1: yes)"}
  op_ui_read_get_warning:
    doc: "Reads the brick's warnings"
    seq:
      - {id: warnings, type: argument(false), doc: "one bit for each warning (0: none; a member of WARNING)"}
  op_ui_read_get_lbatt:
    doc: "Reads the battery level, derived from its voltage"
    seq:
      - {id: pct, type: argument(false), doc: "battery level (0 to 100 %)"}
  op_ui_read_textbox_read:
    doc: Reads one line of the text of a text box
    seq:
      - {id: text, type: argument(false), doc: "whole text of the box, its lines separated by DEL"}
      - {id: size, type: argument(false), doc: "size of the box's text buffer, including the zero (bytes)"}
      - {id: del_, type: argument(false), doc: what separates the lines (a member of DEL)}
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - {id: line, type: argument(false), doc: "which line, counted from 1"}
      - id: destination
        type: argument(false)
        doc: "the line, empty if there is no such line (as many bytes as LENGTH says)"
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_ui_read_get_version:
    doc: "Reads name, version and build date of the firmware in one string"
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - id: destination
        type: argument(false)
        doc: "such as LMS2012 V1.04H(Jul 26 2013 12:00:00) (as many bytes as LENGTH says)"
  op_ui_read_get_ip:
    doc: "Reads the brick's IP address"
    seq:
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes; -1: no limit)"
      - {id: destination, type: argument(false), doc: address in dotted notation (as many bytes as LENGTH says)}
  op_ui_read_get_power:
    doc: Reads all values of the power supply at once
    seq:
      - {id: vbatt, type: argument(true), doc: battery voltage (V)}
      - {id: ibatt, type: argument(true), doc: battery current (A)}
      - {id: iint, type: argument(true), doc: battery current smoothed over time (A)}
      - {id: imotor, type: argument(true), doc: current of all motors together (A)}
  op_ui_read_get_sdcard:
    doc: "Reads whether an SD card is present, and its space"
    seq:
      - {id: state, type: argument(false), doc: "whether one is present (0 to 1; 0: absent; 1: present)"}
      - {id: total, type: argument(false), doc: size (KiB)}
      - {id: free, type: argument(false), doc: free space (KiB)}
  op_ui_read_get_usbstick:
    doc: "Reads whether a USB stick is present, and its space"
    seq:
      - {id: state, type: argument(false), doc: "whether one is present (0 to 1; 0: absent; 1: present)"}
      - {id: total, type: argument(false), doc: size (KiB)}
      - {id: free, type: argument(false), doc: free space (KiB)}
  op_ui_write_floatvalue:
    doc: Writes a number in a fixed format to the terminal
    seq:
      - {id: value, type: argument(true), doc: number to write}
      - id: figures
        type: argument(false)
        doc: "total number of characters, including the decimal point; negative aligns left"
      - {id: decimals, type: argument(false), doc: digits after the decimal point}
  op_ui_write_stamp:
    doc: "Writes time, program, object, position and a comment to the terminal"
    seq:
      - {id: value, type: argument(false), doc: remark}
  op_ui_write_put_string:
    doc: Writes text to the terminal
    seq:
      - {id: string_, type: argument(false), doc: text to write}
  op_ui_write_value8:
    doc: Writes a whole number to the terminal
    seq:
      - {id: value, type: argument(false), doc: number to write}
  op_ui_write_value16:
    doc: Writes an unsigned whole number to the terminal
    seq:
      - {id: value, type: argument(false), doc: number to write}
  op_ui_write_value32:
    doc: Writes a whole number to the terminal
    seq:
      - {id: value, type: argument(false), doc: number to write}
  op_ui_write_valuef:
    doc: Writes a number to the terminal
    seq:
      - {id: value, type: argument(true), doc: number to write}
  op_ui_write_address:
    doc: "Not implemented in the firmware: the program that runs it fails"
    seq:
      - {id: value, type: argument(false), doc: "address; never written"}
  op_ui_write_code:
    doc: Writes bytes of memory as hex to the terminal
    seq:
      - {id: array, type: argument(false), doc: address of the bytes}
      - {id: length, type: argument(false), doc: number of bytes (bytes)}
  op_ui_write_screen_block:
    doc: Blocks or unblocks the display and the buttons for programs
    seq:
      - {id: status, type: argument(false), doc: "whether drawing is ignored (0 to 1; 0: normal; 1: blocked)"}
  op_ui_write_allow_pulse:
    doc: Selects the debug pulses that are shown (only in debug builds of the firmware)
    seq:
      - {id: value, type: argument(false), doc: "sum of bits (1: menu background; 2: browser; 4: key)"}
  op_ui_write_set_pulse:
    doc: Raises debug pulses (only in debug builds of the firmware)
    seq:
      - {id: value, type: argument(false), doc: "sum of bits (1: menu background; 2: browser; 4: key)"}
  op_ui_write_textbox_append:
    doc: Appends a line to the text of a text box
    seq:
      - id: text
        type: argument(false)
        doc: "whole text of the box, its lines separated by DEL (as many bytes as SIZE says)"
      - {id: size, type: argument(false), doc: "size of the box's text buffer, including the zero (bytes)"}
      - {id: del_, type: argument(false), doc: what separates the lines (a member of DEL)}
      - {id: source, type: argument(false), doc: line to append}
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_ui_write_set_busy:
    doc: Sets or clears the busy bit among the warnings
    seq:
      - {id: value, type: argument(false), doc: "whether the brick counts as busy (0 to 1; 0: no; 1: yes)"}
  op_ui_write_set_testpin:
    doc: "Sets the test pin on the brick's circuit board"
    seq:
      - {id: state, type: argument(false), doc: "level of the pin (0 to 1; 0: low; 1: high)"}
  op_ui_write_led:
    doc: Sets colour and blinking of the light around the buttons
    seq:
      - {id: pattern, type: argument(false), doc: colour and rhythm (a member of LEDPATTERN)}
    instances:
      pattern_name: {value: pattern.value, enum: ledpattern, if: pattern.is_number}
  op_ui_write_power:
    doc: Sets the flag that makes the power driver switch off when the firmware ends
    seq:
      - {id: value, type: argument(false), doc: the flag (0 to 1)}
  op_ui_write_terminal:
    doc: Switches the debug terminal on or off
    seq:
      - {id: state, type: argument(false), doc: "whether the terminal is on (0 to 1; 0: off; 1: on)"}
  op_ui_button_shortpress:
    doc: "Reports whether a button was pressed since the last query, and clears the press"
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
      - {id: state, type: argument(false), doc: "whether the button was pressed (0 to 1; 0: no; 1: yes)"}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_longpress:
    doc: "Reports whether a button was held for 3 s since the last query, and clears it"
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
      - {id: state, type: argument(false), doc: "whether the button was held for 3 s (0 to 1; 0: no; 1: yes)"}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_press:
    doc: Presses a button as if by hand and holds it until RELEASE
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_release:
    doc: Releases a button that PRESS holds
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_get_horz:
    doc: "Reads the left and right buttons as one axis, and clears their presses"
    seq:
      - {id: value, type: argument(false), doc: "direction (-1 to 1; -1: left; 1: right; 0: not pressed)"}
  op_ui_button_get_vert:
    doc: "Reads the up and down buttons as one axis, and clears their presses"
    seq:
      - {id: value, type: argument(false), doc: "direction (-1 to 1; -1: up; 1: down; 0: not pressed)"}
  op_ui_button_pressed:
    doc: Reports whether a button is down at the moment
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
      - {id: state, type: argument(false), doc: "whether the button is down (0 to 1; 0: no; 1: yes)"}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_set_back_block:
    doc: "Blocks or unblocks the back button, which ends the running program"
    seq:
      - id: blocked
        type: argument(false)
        doc: "whether the back button is blocked (0 to 1; 0: not blocked; 1: blocked)"
  op_ui_button_get_back_block:
    doc: Reports whether the back button is blocked
    seq:
      - id: blocked
        type: argument(false)
        doc: "whether the back button is blocked (0 to 1; 0: not blocked; 1: blocked)"
  op_ui_button_testshortpress:
    doc: "Reports, like SHORTPRESS, whether a button was pressed, without clearing the press"
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
      - {id: state, type: argument(false), doc: "whether the button was pressed (0 to 1; 0: no; 1: yes)"}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_testlongpress:
    doc: "Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it"
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
      - {id: state, type: argument(false), doc: "whether the button was held for 3 s (0 to 1; 0: no; 1: yes)"}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_get_bumbed:
    doc: "Reports whether a button was pressed and released since the last query, and clears it"
    seq:
      - {id: button, type: argument(false), doc: which button (a member of BUTTONTYPE)}
      - {id: state, type: argument(false), doc: "whether the button was pressed and released (0 to 1; 0: no; 1: yes)"}
    instances:
      button_name: {value: button.value, enum: buttontype, if: button.is_number}
  op_ui_button_get_click:
    doc: "Reports whether a key click is due for a handled press, and clears it"
    seq:
      - {id: click, type: argument(false), doc: "whether a click is due (0 to 1; 0: no; 1: yes)"}
  op_ui_draw_pixel:
    doc: Draws one pixel
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: column (0 to 177 px)}
      - {id: y0, type: argument(false), doc: row (0 to 127 px)}
  op_ui_draw_line:
    doc: Draws a line between two points
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: column of the start (0 to 177 px)}
      - {id: y0, type: argument(false), doc: row of the start (0 to 127 px)}
      - {id: x1, type: argument(false), doc: column of the end (0 to 178 px)}
      - {id: y1, type: argument(false), doc: row of the end (0 to 128 px)}
  op_ui_draw_circle:
    doc: Draws a circle
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: column of the centre (0 to 177 px)}
      - {id: y0, type: argument(false), doc: row of the centre (0 to 127 px)}
      - {id: r, type: argument(false), doc: "radius (px; 0: draws nothing)"}
  op_ui_draw_text:
    doc: Draws text in the font chosen by SELECT_FONT
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: string_, type: argument(false), doc: text to draw}
  op_ui_draw_icon:
    doc: Draws one of the built-in icons
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: type_, type: argument(false), doc: set of icons (a member of ICONTYPE)}
      - {id: "no", type: argument(false), doc: number of the icon in its set}
    instances:
      type__name: {value: type_.value, enum: icontype, if: type_.is_number}
  op_ui_draw_picture:
    doc: Draws a picture from memory
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: ip, type: argument(false), doc: "address of the picture (0: draws nothing)"}
  op_ui_draw_value:
    doc: "Draws a number, or dashes where it is not a number"
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: value, type: argument(true), doc: number to draw}
      - id: figures
        type: argument(false)
        doc: "total number of characters, including the decimal point; negative aligns left"
      - {id: decimals, type: argument(false), doc: digits after the decimal point}
  op_ui_draw_fillrect:
    doc: Draws a filled rectangle
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: y1, type: argument(false), doc: height (0 to 128 px)}
  op_ui_draw_rect:
    doc: Draws the outline of a rectangle
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: y1, type: argument(false), doc: height (0 to 128 px)}
  op_ui_draw_notification:
    doc: Shows icons and text in a window and waits for the centre button
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: icon1, type: argument(false), doc: "first large icon (-1: none; a member of L_ICON_NO)"}
      - {id: icon2, type: argument(false), doc: "second large icon (-1: none; a member of L_ICON_NO)"}
      - {id: icon3, type: argument(false), doc: "third large icon (-1: none; a member of L_ICON_NO)"}
      - {id: string_, type: argument(false), doc: "text beside the icons; may be empty"}
      - id: state
        type: argument(false)
        doc: "variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done; 1: being shown)"
    instances:
      icon1_name: {value: icon1.value, enum: l_icon_no, if: icon1.is_number}
      icon2_name: {value: icon2.value, enum: l_icon_no, if: icon2.is_number}
      icon3_name: {value: icon3.value, enum: l_icon_no, if: icon3.is_number}
  op_ui_draw_question:
    doc: Shows icons in a window and waits for yes or no
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: icon1, type: argument(false), doc: "first large icon (-1: none; a member of L_ICON_NO)"}
      - {id: icon2, type: argument(false), doc: "second large icon (-1: none; a member of L_ICON_NO)"}
      - {id: string_, type: argument(false), doc: "text of the question (LEGO's firmware does not show it)"}
      - id: state
        type: argument(false)
        doc: "variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done; 1: being shown)"
      - id: ok
        type: argument(false)
        doc: "answer; the variable's previous value is selected at first (-1 to 1; 0: no; 1: yes; -1: closed with the back button)"
    instances:
      icon1_name: {value: icon1.value, enum: l_icon_no, if: icon1.is_number}
      icon2_name: {value: icon2.value, enum: l_icon_no, if: icon2.is_number}
  op_ui_draw_keyboard:
    doc: Shows a keyboard on the display and waits until a text has been entered
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: icon, type: argument(false), doc: normal icon before the caption (a member of N_ICON_NO)}
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes)"
      - {id: default_, type: argument(false), doc: "caption above the text, not a preset as its name says (0: none)"}
      - id: charset
        type: argument(false)
        doc: "variable with the sum of the allowed kinds of text; becomes 0 once the keyboard is shown"
      - id: string_
        type: argument(false)
        doc: "entered text; the variable's previous text is edited, the back button empties it (as many bytes as LENGTH says)"
    instances:
      icon_name: {value: icon.value, enum: n_icon_no, if: icon.is_number}
  op_ui_draw_browse:
    doc: Shows files and folders and waits until one is chosen
    seq:
      - {id: type_, type: argument(false), doc: what to list (a member of BROWSERTYPE)}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: y1, type: argument(false), doc: height (0 to 128 px)}
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to return, including the zero (0 to 127 bytes)"
      - id: item_type
        type: argument(false)
        doc: "kind of the chosen entry; the variable must be 0 at first (a member of FILETYPE)"
      - id: string_
        type: argument(false)
        doc: "path of the chosen entry; set the variable to the top folder first (as many bytes as LENGTH says)"
    instances:
      type__name: {value: type_.value, enum: browsertype, if: type_.is_number}
  op_ui_draw_vertbar:
    doc: Draws a vertical scroll bar
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: y1, type: argument(false), doc: height (0 to 128 px)}
      - {id: min, type: argument(false), doc: value at one end of the bar}
      - {id: max, type: argument(false), doc: value at the other end of the bar}
      - {id: act, type: argument(false), doc: value that the knob shows}
  op_ui_draw_inverserect:
    doc: Swaps black and white in a rectangle
    seq:
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: y1, type: argument(false), doc: height (0 to 128 px)}
  op_ui_draw_select_font:
    doc: "Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW"
    seq:
      - {id: type_, type: argument(false), doc: "font (0 to 3; a member of FONTTYPE)"}
    instances:
      type__name: {value: type_.value, enum: fonttype, if: type_.is_number}
  op_ui_draw_topline:
    doc: Switches the status line at the top on or off
    seq:
      - {id: enable, type: argument(false), doc: "whether the status line is shown (0 to 1; 0: disabled; 1: enabled)"}
  op_ui_draw_fillwindow:
    doc: "Fills rows over the whole width, and restores the normal font"
    seq:
      - id: color
        type: argument(false)
        doc: "colour to fill with; any other value makes a test pattern (0: white; 1: black)"
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - id: y1
        type: argument(false)
        doc: "height; nothing is filled if Y0 plus it is 128 or more (0 to 127 px; 0: down to the bottom)"
  op_ui_draw_scroll:
    doc: Moves the canvas up
    seq:
      - {id: "y", type: argument(false), doc: distance (1 to 127 px)}
  op_ui_draw_dotline:
    doc: Draws a dashed line between two points
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: column of the start (0 to 177 px)}
      - {id: y0, type: argument(false), doc: row of the start (0 to 127 px)}
      - {id: x1, type: argument(false), doc: column of the end (0 to 178 px)}
      - {id: y1, type: argument(false), doc: row of the end (0 to 128 px)}
      - {id: "on", type: argument(false), doc: length of a dash (px)}
      - {id: "off", type: argument(false), doc: length of a gap (px)}
  op_ui_draw_view_value:
    doc: "Draws a number centred in its place, or > instead of digits if it does not fit"
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: value, type: argument(true), doc: number to draw}
      - {id: figures, type: argument(false), doc: "total number of characters, including the decimal point"}
      - {id: decimals, type: argument(false), doc: digits after the decimal point}
  op_ui_draw_view_unit:
    doc: Draws a number in large figures and its unit in small letters
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: value, type: argument(true), doc: number to draw}
      - {id: figures, type: argument(false), doc: "total number of characters, including the decimal point"}
      - {id: decimals, type: argument(false), doc: digits after the decimal point}
      - id: length
        type: argument(false)
        doc: "maximum number of bytes of the unit, including the zero (0 to 127 bytes)"
      - {id: string_, type: argument(false), doc: unit to draw after the number}
  op_ui_draw_fillcircle:
    doc: Draws a filled circle
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: column of the centre (0 to 177 px)}
      - {id: y0, type: argument(false), doc: row of the centre (0 to 127 px)}
      - {id: r, type: argument(false), doc: "radius (px; 0: draws nothing)"}
  op_ui_draw_store:
    doc: Keeps a copy of the canvas
    seq:
      - id: "no"
        type: argument(false)
        doc: "slot for one screen; 0 holds the screen from before the program ran (0 to 2)"
  op_ui_draw_restore:
    doc: Restores a canvas kept by STORE
    seq:
      - id: "no"
        type: argument(false)
        doc: "slot for one screen; 0 holds the screen from before the program ran (0 to 2)"
  op_ui_draw_icon_question:
    doc: Shows a row of icons and waits until one is chosen
    seq:
      - {id: color, type: argument(false), doc: "colour to draw in (0 to 1; 0: white; 1: black)"}
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - id: state
        type: argument(false)
        doc: "variable for the dialogue's progress; must be 0 at first (0 to 1; 0: start, or done; 1: being shown)"
      - id: icons
        type: argument(false)
        doc: "bit n is large icon n: first the icons to show, then the chosen one (0: none: closed with the back button)"
  op_ui_draw_bmpfile:
    doc: "Draws a picture file in LEGO's own format .rgf (no .bmp despite the name)"
    seq:
      - id: color
        type: argument(false)
        doc: "colour of the set pixels (0 to 1; 0: white, picture inverted; 1: black)"
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - id: name
        type: argument(false)
        doc: "file with extension .rgf, absolute or relative to /home/root/lms2012/sys (at most 119 characters)"
  op_ui_draw_popup:
    doc: "Opens a window that only its opener can draw on, or closes it and restores the display"
    seq:
      - {id: open, type: argument(false), doc: "action (0 to 1; 0: close; 1: open)"}
  op_ui_draw_graph_setup:
    doc: "Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it"
    seq:
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: items, type: argument(false), doc: number of curves (0 to 8)}
      - {id: offset, type: argument(false), doc: "top edge of each curve (0 to 127 px; as many values as ITEMS says)"}
      - {id: span, type: argument(false), doc: "height of each curve (0 to 128 px; as many values as ITEMS says)"}
      - {id: min, type: argument(true), doc: value at the bottom of each curve (as many values as ITEMS says)}
      - {id: max, type: argument(true), doc: value at the top of each curve (as many values as ITEMS says)}
      - id: sample
        type: argument(true)
        doc: "current value of each curve, read again at each GRAPH_SAMPLE (as many values as ITEMS says)"
  op_ui_draw_graph_draw:
    doc: Draws the graph and measures the curve it shows
    seq:
      - id: view
        type: argument(false)
        doc: "curve to draw, counted from 0; any other value draws all and measures none (-1: all)"
      - {id: actual, type: argument(true), doc: "latest value, NaN if there is none"}
      - {id: lowest, type: argument(true), doc: lowest value in the graph}
      - {id: highest, type: argument(true), doc: highest value in the graph}
      - {id: average, type: argument(true), doc: mean of the values in the graph}
  op_ui_draw_textbox:
    doc: Shows a text with a scroll bar and waits until a line is chosen
    seq:
      - {id: x0, type: argument(false), doc: left edge (0 to 177 px)}
      - {id: y0, type: argument(false), doc: top edge (0 to 127 px)}
      - {id: x1, type: argument(false), doc: width (0 to 178 px)}
      - {id: y1, type: argument(false), doc: height (0 to 128 px)}
      - {id: text, type: argument(false), doc: "whole text of the box, its lines separated by DEL"}
      - {id: size, type: argument(false), doc: "size of the box's text buffer, including the zero (bytes)"}
      - {id: del_, type: argument(false), doc: what separates the lines (a member of DEL)}
      - id: line
        type: argument(false)
        doc: "variable, must be -1 at first; then the chosen line, counted from 1 (-1: start, or closed with the back button; 0: being shown)"
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_keep_alive:
    doc: "Restarts the timer that switches off an idle brick, and reads its time"
    seq:
      - {id: minutes, type: argument(false), doc: "idle time before switching off (min; 0: never)"}
  op_timer_wait:
    doc: "Stores the end of a wait and returns at once; TIMER_READY does the waiting"
    seq:
      - {id: time, type: argument(false), doc: duration of the wait (0 to 2147483647 ms)}
      - id: timer
        type: argument(false)
        doc: "variable that gets the end of the wait, on the brick's millisecond clock"
  op_timer_ready:
    doc: Waits until the time that TIMER_WAIT stored
    seq:
      - {id: timer, type: argument(false), doc: variable that TIMER_WAIT has set}
  op_timer_read:
    doc: Reads the time since the start of the program or direct command that asks
    seq:
      - {id: time, type: argument(false), doc: time since the start (ms)}
  op_timer_read_us:
    doc: "Reads the free-running microsecond clock, for differences only"
    seq:
      - {id: time, type: argument(false), doc: "low 32 bits of the clock, wraps every 71.6 minutes (us)"}
  op_sound_tone:
    doc: Plays one tone and returns at once
    seq:
      - {id: volume, type: argument(false), doc: "volume (0 to 100 %; 0: silent)"}
      - {id: frequency, type: argument(false), doc: "pitch; the driver clamps it to the range (250 to 10000 Hz)"}
      - id: duration
        type: argument(false)
        doc: "duration, read unsigned (-1 is 65535) (ms; 0: until BREAK or the next sound)"
  op_sound_play:
    doc: Plays a sound file once and returns at once
    seq:
      - {id: volume, type: argument(false), doc: "volume (0 to 100 %; 0: silent)"}
      - id: name
        type: argument(false)
        doc: "sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys (at most 119 characters)"
  op_sound_repeat:
    doc: Plays a sound file over and over until BREAK and returns at once
    seq:
      - {id: volume, type: argument(false), doc: "volume (0 to 100 %; 0: silent)"}
      - id: name
        type: argument(false)
        doc: "sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys (at most 119 characters)"
  op_sound_test:
    doc: Reports whether a sound is playing
    seq:
      - {id: busy, type: argument(false), doc: "whether a sound is playing (0 to 1; 0: ready; 1: busy)"}
  op_input_sample:
    doc: "Reads one SI value of each of several devices, sampled in the background"
    seq:
      - {id: time, type: argument(false), doc: time between two samples (ms)}
      - {id: samples, type: argument(false), doc: number of devices the arrays list}
      - id: init
        type: argument(false)
        doc: "place in the sample buffer of each device, -1 starts it anew (as many values as SAMPLES says)"
      - id: devices
        type: argument(false)
        doc: "ports, 0 to 3 for sensors, 4 to 7 for motors A to D (as many values as SAMPLES says)"
      - id: types
        type: argument(false)
        doc: "type to set for each device (a member of TYPE; as many values as SAMPLES says)"
      - {id: modes, type: argument(false), doc: mode to set for each device (as many values as SAMPLES says)}
      - id: datasets
        type: argument(false)
        doc: "index of the value to read from each device, from 0 (as many values as SAMPLES says)"
      - id: values
        type: argument(true)
        doc: "one value per device, NaN if there is none (as many values as SAMPLES says)"
    instances:
      types_name: {value: types.value, enum: type_, if: types.is_number}
  op_input_device_list:
    doc: "Lists the types of all devices, sensor ports of each layer first, then motor ports"
    seq:
      - {id: length, type: argument(false), doc: "size of the array; 32 holds the whole daisy chain (0 to 127)"}
      - id: array
        type: argument(false)
        doc: "type of device at each port (a member of TYPE; as many values as LENGTH says)"
      - {id: changed, type: argument(false), doc: "whether devices came or went since the last call (0: no change)"}
  op_input_device_insert_type:
    doc: "Adds a line to the table of device types, for third party types (50 to 98) only"
    seq:
      - {id: typedata, type: argument(false), doc: "the line as in typedata.rcf, starting with the type's number"}
      - id: force
        type: argument(false)
        doc: "whether to replace a known type (0 to 1; 0: refuse a known type; 1: replace a known type)"
      - {id: error, type: argument(false), doc: "whether it failed (0 to 1; 0: done; 1: failed or known)"}
  op_input_device_get_format:
    doc: Describes the values of a device in its current mode
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: datasets, type: argument(false), doc: number of values in one reading}
      - {id: format, type: argument(false), doc: "type of one raw value (0 to 3; a member of DATA_FORMAT)"}
      - {id: modes, type: argument(false), doc: number of modes of the device (1 to 8)}
      - {id: views, type: argument(false), doc: number of modes shown to users (1 to 8)}
  op_input_device_cal_minmax:
    doc: Sets the raw values that scale a type and mode to percent and SI
    seq:
      - {id: type_, type: argument(false), doc: type of device the calibration is for (a member of TYPE)}
      - {id: mode, type: argument(false), doc: mode the calibration is for (0 to 7)}
      - {id: cal_min, type: argument(false), doc: raw value at the lower end}
      - {id: cal_max, type: argument(false), doc: raw value at full scale}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_cal_default:
    doc: Restores the built-in scaling of a type and mode
    seq:
      - {id: type_, type: argument(false), doc: type of device the calibration is for (a member of TYPE)}
      - {id: mode, type: argument(false), doc: mode the calibration is for (0 to 7)}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_get_typemode:
    doc: Reports the device at a port and its mode
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: type of the device (a member of TYPE)}
      - {id: mode, type: argument(false), doc: mode the device is in (0 to 7)}
  op_input_device_get_symbol:
    doc: Reads the symbol of the unit of the current mode
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: destination, type: argument(false), doc: "symbol, padded with blanks (as many bytes as LENGTH says)"}
  op_input_device_cal_min:
    doc: Sets the lower end of the scaling of a type and mode
    seq:
      - {id: type_, type: argument(false), doc: type of device the calibration is for (a member of TYPE)}
      - {id: mode, type: argument(false), doc: mode the calibration is for (0 to 7)}
      - {id: cal_min, type: argument(false), doc: "value at the lower end, in SI units once calibrated"}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_cal_max:
    doc: Sets the full scale of a type and mode
    seq:
      - {id: type_, type: argument(false), doc: type of device the calibration is for (a member of TYPE)}
      - {id: mode, type: argument(false), doc: mode the calibration is for (0 to 7)}
      - {id: cal_max, type: argument(false), doc: "value at full scale, in SI units once calibrated"}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_setup:
    doc: "Writes to an I2C sensor and reads its answer, repeatedly if requested"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - id: "no"
        type: argument(false)
        doc: "sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)"
      - {id: repeat, type: argument(false), doc: "number of repeats (0: endless)"}
      - {id: time, type: argument(false), doc: "time between repeats (10 to 1000 ms; 0: 10 ms)"}
      - {id: write_len, type: argument(false), doc: number of bytes to write (0 to 32 bytes)}
      - id: write_data
        type: argument(false)
        doc: "bytes to write: I2C address, register, data (as many values as WRITE_LEN says)"
      - id: read_len
        type: argument(false)
        doc: "number of bytes to read, negative: in reverse order (-32 to 32 bytes)"
      - {id: read_data, type: argument(false), doc: bytes read (as many values as READ_LEN says)}
  op_input_device_clr_all:
    doc: Clears counters and angles of all devices
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain (0 to 3; -1: all layers)"}
  op_input_device_get_raw:
    doc: Reads the first raw value of a device
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: value, type: argument(false), doc: "raw value, NaN if there is none"}
  op_input_device_get_connection:
    doc: Reports how the device at a port is connected
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: conn, type: argument(false), doc: kind of connection (a member of CONN)}
  op_input_device_stop_all:
    doc: "Stops all devices, motors among them"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain (0 to 3; -1: all layers)"}
  op_input_device_set_typemode:
    doc: "Renumbers an entry of the table of device types, third party types only"
    seq:
      - {id: type_, type: argument(false), doc: "type of the entry (50 to 98; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: mode of the entry (0 to 7)}
      - {id: newtype, type: argument(false), doc: "new type of the entry (50 to 98; a member of TYPE)"}
      - {id: newmode, type: argument(false), doc: new mode of the entry (0 to 7)}
      - {id: error, type: argument(false), doc: "whether it failed (0 to 1; 0: done; 1: failed or not found)"}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
      newtype_name: {value: newtype.value, enum: type_, if: newtype.is_number}
  op_input_device_ready_iic:
    doc: "Writes to an I2C sensor once, waits for its answer and reports the result"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - id: "no"
        type: argument(false)
        doc: "sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)"
      - {id: wrlng, type: argument(false), doc: number of bytes to write (0 to 32 bytes)}
      - id: wrdata
        type: argument(false)
        doc: "bytes to write: I2C address, register, data (as many values as WRLNG says)"
      - {id: rdlng, type: argument(false), doc: "number of bytes to read, negative: in reverse order (-32 to 32 bytes)"}
      - {id: rddata, type: argument(false), doc: bytes read (as many values as RDLNG says)}
      - {id: result, type: argument(false), doc: how the transfer ended (a member of RESULT)}
  op_input_device_get_name:
    doc: "Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: destination, type: argument(false), doc: "name, padded with blanks (as many bytes as LENGTH says)"}
  op_input_device_get_modename:
    doc: Reads the name of any mode of a device
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: mode, type: argument(false), doc: mode to name (0 to 7)}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: destination, type: argument(false), doc: "name, padded with blanks (as many bytes as LENGTH says)"}
  op_input_device_set_raw:
    doc: Simulates a raw value of a device
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: value, type: argument(false), doc: raw value to simulate}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_get_figures:
    doc: Reports the number of digits that a value of the current mode needs
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: figures, type: argument(false), doc: "total number of characters, with point and decimals"}
      - {id: decimals, type: argument(false), doc: digits after the point}
  op_input_device_get_changes:
    doc: Reads how often a touch sensor changed to pressed since CLR_CHANGES
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: value, type: argument(true), doc: "number of changes, 0 for other sensors"}
  op_input_device_clr_changes:
    doc: Sets the counts of GET_CHANGES and GET_BUMPS to zero
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
  op_input_device_ready_pct:
    doc: "Sets type and mode, waits until the device is ready and reads percent values"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: "mode to set (0 to 7; -1: keep the mode)"}
      - {id: values_count, type: argument(false), doc: "number of values that follow, each in percent (each is DATA8)"}
      - {id: values, type: argument(false), repeat: expr, repeat-expr: values_count.value}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_ready_raw:
    doc: "Sets type and mode, waits until the device is ready and reads raw values"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: "mode to set (0 to 7; -1: keep the mode)"}
      - {id: values_count, type: argument(false), doc: number of raw values that follow (each is DATA32)}
      - {id: values, type: argument(false), repeat: expr, repeat-expr: values_count.value}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_ready_si:
    doc: "Sets type and mode, waits until the device is ready and reads SI values"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: "mode to set (0 to 7; -1: keep the mode)"}
      - {id: values_count, type: argument(false), doc: "number of values that follow, each in SI units (each is DATAF)"}
      - {id: values, type: argument(true), repeat: expr, repeat-expr: values_count.value}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_device_get_minmax:
    doc: Reports the range of SI values of the current mode
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: min, type: argument(true), doc: smallest value in SI units}
      - {id: max, type: argument(true), doc: largest value in SI units}
  op_input_device_get_bumps:
    doc: Reads how often a touch sensor changed to released since CLR_CHANGES
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: value, type: argument(true), doc: "number of changes, 0 for other sensors"}
  op_input_read:
    doc: Sets type and mode and reads the first value in percent at once
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: "mode to set (0 to 7; -1: keep the mode)"}
      - {id: pct, type: argument(false), doc: "value, NaN if there is none (%)"}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_test:
    doc: Reports whether a device is still changing type or mode
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: busy, type: argument(false), doc: "whether to wait (0 to 1; 0: ready; 1: busy)"}
  op_input_ready:
    doc: Waits until a device has valid values
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
  op_input_readsi:
    doc: Sets type and mode and reads the first value in SI units at once
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: "mode to set (0 to 7; -1: keep the mode)"}
      - {id: si, type: argument(true), doc: "value in the mode's unit, NaN if there is none"}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_input_readext:
    doc: "Sets type and mode and reads several values at once, in the format asked for"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0; 16 to 19 for motors (0 to 19)"}
      - {id: type_, type: argument(false), doc: "type to set (0: keep the type; a member of TYPE)"}
      - {id: mode, type: argument(false), doc: "mode to set (0 to 7; -1: keep the mode)"}
      - id: format
        type: argument(false)
        doc: "DATA_PCT, DATA_RAW or DATA_SI; others give NaN (a member of DATA_FORMAT)"
      - id: values_count
        type: argument(false)
        doc: "number of values that follow, each in FORMAT (each is what FORMAT says)"
      - id: values
        type: "argument(format.is_number and (format.value == 3 or format.value == 19))"
        repeat: expr
        repeat-expr: values_count.value
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
      format_name: {value: format.value, enum: data_format, if: format.is_number}
  op_input_write:
    doc: Sends bytes to a UART sensor
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - id: "no"
        type: argument(false)
        doc: "sensor port, counted from 0 (0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4)"
      - {id: bytes, type: argument(false), doc: number of bytes to send (1 to 32 bytes)}
      - {id: data, type: argument(false), doc: bytes to send (as many values as BYTES says)}
  op_output_set_type:
    doc: Declares which type of motor is at a port
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)"}
      - {id: type_, type: argument(false), doc: type of the motor (a member of TYPE)}
    instances:
      type__name: {value: type_.value, enum: type_, if: type_.is_number}
  op_output_reset:
    doc: Sets the tacho counts that moves and OUTPUT_READ use to zero
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
  op_output_stop:
    doc: Stops motors
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_power:
    doc: "Sets the power of motors, which run at the next OUTPUT_START"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: power, type: argument(false), doc: "unregulated power; negative: backward (-100 to 100 %)"}
  op_output_speed:
    doc: "Sets the speed of motors, which run at the next OUTPUT_START"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: speed, type: argument(false), doc: "regulated speed; negative: backward (-100 to 100 %)"}
  op_output_start:
    doc: Starts motors with the power or speed set before
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
  op_output_polarity:
    doc: Sets the direction of motors
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - id: pol
        type: argument(false)
        doc: "direction (-1 to 1; -1: backward; 0: opposite of the current one; 1: forward)"
  op_output_read:
    doc: "Reads speed and tacho count of one motor, 0 on layers other than 0"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: "no", type: argument(false), doc: "port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)"}
      - {id: speed, type: argument(false), doc: "current speed (-100 to 100 %)"}
      - id: tacho
        type: argument(false)
        doc: "angle in the current phase of a move; about 0 after one that brakes (degrees)"
  op_output_test:
    doc: Reports whether one of the motors is still in a move that ends by itself
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: busy, type: argument(false), doc: "whether to wait (0 to 1; 0: ready; 1: busy)"}
  op_output_ready:
    doc: "Waits until the moves of the motors have ended; ignores those from OUTPUT_START"
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
  op_output_step_power:
    doc: Turns motors by an angle with unregulated power
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: power, type: argument(false), doc: "unregulated power; negative: backward (-100 to 100 %)"}
      - {id: step1, type: argument(false), doc: angle of the ramp up (0 to 2147483647 degrees)}
      - {id: step2, type: argument(false), doc: angle at constant drive (0 to 2147483647 degrees)}
      - {id: step3, type: argument(false), doc: angle of the ramp down (0 to 2147483647 degrees)}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_time_power:
    doc: Runs motors for a time with unregulated power
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: power, type: argument(false), doc: "unregulated power; negative: backward (-100 to 100 %)"}
      - {id: time1, type: argument(false), doc: time of the ramp up (0 to 2147483647 ms)}
      - {id: time2, type: argument(false), doc: time at constant drive (0 to 2147483647 ms)}
      - {id: time3, type: argument(false), doc: time of the ramp down (0 to 2147483647 ms)}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_step_speed:
    doc: Turns motors by an angle with regulated speed
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: speed, type: argument(false), doc: "regulated speed; negative: backward (-100 to 100 %)"}
      - {id: step1, type: argument(false), doc: angle of the ramp up (0 to 2147483647 degrees)}
      - {id: step2, type: argument(false), doc: angle at constant drive (0 to 2147483647 degrees)}
      - {id: step3, type: argument(false), doc: angle of the ramp down (0 to 2147483647 degrees)}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_time_speed:
    doc: Runs motors for a time with regulated speed
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: speed, type: argument(false), doc: "regulated speed; negative: backward (-100 to 100 %)"}
      - {id: time1, type: argument(false), doc: time of the ramp up (0 to 2147483647 ms)}
      - {id: time2, type: argument(false), doc: time at constant drive (0 to 2147483647 ms)}
      - {id: time3, type: argument(false), doc: time of the ramp down (0 to 2147483647 ms)}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_step_sync:
    doc: Turns two motors in step by an angle
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: speed, type: argument(false), doc: "regulated speed; negative: backward (-100 to 100 %)"}
      - id: turn
        type: argument(false)
        doc: "how tight the turn is, positive slows the higher port, negative the lower (-200 to 200; -200: spin, lower port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands still; 200: spin, higher port runs backward)"
      - {id: step, type: argument(false), doc: "angle of the faster motor (0 to 2147483647 degrees; 0: endless)"}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_time_sync:
    doc: Runs two motors in step for a time
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
      - {id: speed, type: argument(false), doc: "regulated speed; negative: backward (-100 to 100 %)"}
      - id: turn
        type: argument(false)
        doc: "how tight the turn is, positive slows the higher port, negative the lower (-200 to 200; -200: spin, lower port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands still; 200: spin, higher port runs backward)"
      - {id: time, type: argument(false), doc: "how long to run (0 to 2147483647 ms; 0: endless)"}
      - {id: brake, type: argument(false), doc: "what the motors do at the end (0 to 1; 0: coast; 1: brake and hold)"}
  op_output_clr_count:
    doc: Sets the tacho counts of motors read as sensors to zero
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "ports as a bit mask: A 1, B 2, C 4, D 8 (0 to 15)"}
  op_output_get_count:
    doc: Reads the tacho count of a motor read as a sensor
    seq:
      - {id: layer, type: argument(false), doc: "brick in the daisy chain, 0 is the one addressed (0 to 3)"}
      - {id: nos, type: argument(false), doc: "port, counted from 0 (0 to 3; 0: A; 1: B; 2: C; 3: D)"}
      - {id: tacho, type: argument(false), doc: angle since OUTPUT_CLR_COUNT (degrees)}
  op_memory_write:
    doc: Writes bytes into the variables of a running program
    seq:
      - {id: prgid, type: argument(false), doc: "slot of the program, which must be running (0 to 4; a member of SLOT)"}
      - {id: objid, type: argument(false), doc: "object whose local memory is meant (0: the program's global memory)"}
      - {id: offset, type: argument(false), doc: first byte in that memory (0 to 2147483647 bytes)}
      - {id: size, type: argument(false), doc: number of bytes (0 to 2147483647 bytes)}
      - id: array
        type: argument(false)
        doc: "the bytes; those beyond the end of the memory are dropped (as many values as SIZE says)"
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_memory_read:
    doc: Reads bytes from the variables of a running program
    seq:
      - {id: prgid, type: argument(false), doc: "slot of the program, which must be running (0 to 4; a member of SLOT)"}
      - {id: objid, type: argument(false), doc: "object whose local memory is meant (0: the program's global memory)"}
      - {id: offset, type: argument(false), doc: first byte in that memory (0 to 2147483647 bytes)}
      - {id: size, type: argument(false), doc: number of bytes (0 to 2147483647 bytes)}
      - id: array
        type: argument(false)
        doc: "the bytes, zeros beyond the end of the memory (as many values as SIZE says)"
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_file_open_append:
    doc: "Opens a file for appending; creates it if it does not exist"
    seq:
      - id: name
        type: argument(false)
        doc: "path of the file; a bare name is taken from the program's own folder (at most 119 characters)"
      - {id: handle, type: argument(false), doc: handle of the opened file}
  op_file_open_read:
    doc: Opens a file for reading
    seq:
      - id: name
        type: argument(false)
        doc: "path of the file; a bare name is taken from the program's own folder (at most 119 characters)"
      - {id: handle, type: argument(false), doc: handle of the opened file}
      - {id: size, type: argument(false), doc: "size of the file (bytes; 0: not found)"}
  op_file_open_write:
    doc: Creates or truncates a file and opens it for writing
    seq:
      - id: name
        type: argument(false)
        doc: "path of the file; a bare name is taken from the program's own folder (at most 119 characters)"
      - {id: handle, type: argument(false), doc: handle of the opened file}
  op_file_read_value:
    doc: Reads the text up to the next delimiter and turns it into a number
    seq:
      - {id: handle, type: argument(false), doc: the open file}
      - {id: del_, type: argument(false), doc: separator between two values in the file (a member of DEL)}
      - {id: value, type: argument(true), doc: "the number, 0 if the text is not a number"}
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_file_write_value:
    doc: "Writes a number as text, and a delimiter after it"
    seq:
      - {id: handle, type: argument(false), doc: the open file}
      - {id: del_, type: argument(false), doc: separator between two values in the file (a member of DEL)}
      - {id: value, type: argument(true), doc: the number}
      - {id: figures, type: argument(false), doc: "minimum width in characters, including the decimal point"}
      - {id: decimals, type: argument(false), doc: digits after the decimal point}
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_file_read_text:
    doc: Reads text up to the next delimiter
    seq:
      - {id: handle, type: argument(false), doc: the open file}
      - {id: del_, type: argument(false), doc: separator between two values in the file (a member of DEL)}
      - id: length
        type: argument(false)
        doc: "maximum number of bytes to read; LEGO's firmware keeps the low 8 bits, so 127 (bytes)"
      - id: text
        type: argument(false)
        doc: "the text, without a zero at its end if it fills the whole buffer (as many bytes as LENGTH says)"
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_file_write_text:
    doc: "Writes text without its zero, and a delimiter after it"
    seq:
      - {id: handle, type: argument(false), doc: the open file}
      - {id: del_, type: argument(false), doc: separator between two values in the file (a member of DEL)}
      - {id: text, type: argument(false), doc: the text}
    instances:
      del__name: {value: del_.value, enum: del_, if: del_.is_number}
  op_file_close:
    doc: Closes a file and frees its handle
    seq:
      - {id: handle, type: argument(false), doc: the open file}
  op_file_load_image:
    doc: "Loads a program file into a stopped slot, for PROGRAM_START to run"
    seq:
      - {id: prgid, type: argument(false), doc: "slot to load it into (0 to 4; a member of SLOT)"}
      - id: name
        type: argument(false)
        doc: "path of the program, relative to /home/root/lms2012/sys; .rbf may be omitted (at most 119 characters)"
      - {id: size, type: argument(false), doc: "size of the program (bytes; 0: not loaded)"}
      - {id: ip, type: argument(false), doc: "where it was loaded, for PROGRAM_START (0: not loaded)"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_file_get_handle:
    doc: Finds the handle of a file that is already open
    seq:
      - id: name
        type: argument(false)
        doc: "path of the file; a bare name is taken from the program's own folder (at most 119 characters)"
      - {id: handle, type: argument(false), doc: "the open file (-1: not open)"}
      - {id: write, type: argument(false), doc: "whether it is open for writing or appending (0: no; 1: yes)"}
  op_file_make_folder:
    doc: Creates a folder unless it exists
    seq:
      - id: name
        type: argument(false)
        doc: "path of the folder, relative to /home/root/lms2012/sys (at most 119 characters)"
      - {id: success, type: argument(false), doc: "whether the folder exists now (0: no; 1: yes)"}
  op_file_get_pool:
    doc: Reserves a block of memory for the program
    seq:
      - {id: size, type: argument(false), doc: how much memory (1 to 6000000 bytes)}
      - {id: handle, type: argument(false), doc: handle of the block}
      - {id: ip, type: argument(false), doc: address of the block}
  op_file_set_log_sync_time:
    doc: Stores the time and tick to which data logs are aligned
    seq:
      - {id: time, type: argument(false), doc: the common time}
      - {id: tick, type: argument(false), doc: "the brick's tick at that time"}
  op_file_get_folders:
    doc: "Counts the entries of a folder, without hidden ones"
    seq:
      - id: name
        type: argument(false)
        doc: "path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)"
      - {id: items, type: argument(false), doc: number of entries}
  op_file_get_log_sync_time:
    doc: Reads the time and tick to which data logs are aligned
    seq:
      - {id: time, type: argument(false), doc: the common time}
      - {id: tick, type: argument(false), doc: "the brick's tick at that time"}
  op_file_get_subfolder_name:
    doc: Reads the name of one entry of a folder
    seq:
      - id: name
        type: argument(false)
        doc: "path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)"
      - {id: item, type: argument(false), doc: "which entry of the folder, the first is 1 (1 to 127)"}
      - {id: length, type: argument(false), doc: "size of the string's buffer, including the zero (bytes)"}
      - id: string_
        type: argument(false)
        doc: "its name without extension, empty if there is no such entry (as many bytes as LENGTH says)"
  op_file_write_log:
    doc: Adds one row of samples to a data log
    seq:
      - {id: handle, type: argument(false), doc: the open data log}
      - {id: time, type: argument(false), doc: time of the samples since the log began (ms)}
      - {id: items, type: argument(false), doc: "number of samples; with 0 nothing is written (0 to 127)"}
      - {id: values, type: argument(true), doc: "the samples, in one array (as many values as ITEMS says)"}
  op_file_close_log:
    doc: Writes the rest of a data log and closes it
    seq:
      - {id: handle, type: argument(false), doc: the open data log}
      - {id: name, type: argument(false), doc: "path of the log as given to OPEN_LOG; .rdf may be omitted"}
  op_file_get_image:
    doc: "Loads an entry of a folder; LEGO's 2013 firmware has no code for it and fails"
    seq:
      - id: name
        type: argument(false)
        doc: "path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)"
      - {id: prgid, type: argument(false), doc: slot to load it into (a member of SLOT)}
      - {id: item, type: argument(false), doc: "which entry of the folder, the first is 1 (1 to 127)"}
      - {id: ip, type: argument(false), doc: where it was loaded}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_file_get_item:
    doc: Finds an entry of a folder by its name
    seq:
      - id: name
        type: argument(false)
        doc: "path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)"
      - {id: string_, type: argument(false), doc: "name to look for, without extension"}
      - {id: item, type: argument(false), doc: "number of the entry; the first is 1 (1 to 127; 0: not found)"}
  op_file_get_cache_files:
    doc: Counts the recently run files
    seq:
      - {id: items, type: argument(false), doc: "number of files, at most 10"}
  op_file_put_cache_file:
    doc: Puts a file first in the list of recently run files
    seq:
      - {id: string_, type: argument(false), doc: path of the file}
  op_file_get_cache_file:
    doc: Reads the path of one recently run file
    seq:
      - {id: item, type: argument(false), doc: "which one, 1 is the latest (1 to 10)"}
      - {id: length, type: argument(false), doc: "size of the string's buffer, including the zero (bytes)"}
      - id: string_
        type: argument(false)
        doc: "path of the file, empty if there is none (as many bytes as LENGTH says)"
  op_file_del_cache_file:
    doc: Removes a file from the list of recently run files
    seq:
      - {id: string_, type: argument(false), doc: "path of the file, as given to PUT_CACHE_FILE"}
  op_file_del_subfolder:
    doc: Deletes one entry of a folder together with the files in it
    seq:
      - id: name
        type: argument(false)
        doc: "path of the folder with its closing slash, such as ../prjs/ (at most 119 characters)"
      - {id: item, type: argument(false), doc: "which entry of the folder, the first is 1 (1 to 127)"}
  op_file_get_log_name:
    doc: Reads the path of the open data log
    seq:
      - {id: length, type: argument(false), doc: "size of the string's buffer, including the zero (bytes)"}
      - {id: name, type: argument(false), doc: "path of the log, empty if none is open (as many bytes as LENGTH says)"}
  op_file_open_log:
    doc: Creates a data log and writes its header
    seq:
      - id: name
        type: argument(false)
        doc: "path of the log; .rdf may be omitted; with an empty one it stays in memory"
      - {id: syncedtime, type: argument(false), doc: "the common time, as GET_LOG_SYNC_TIME returns it"}
      - {id: syncedtick, type: argument(false), doc: "the brick's tick at that time"}
      - {id: nowtick, type: argument(false), doc: "the brick's tick at the start of the log"}
      - id: sample_interval_in_ms
        type: argument(false)
        doc: "time between samples; fast logs are kept in memory first (ms)"
      - {id: duration_in_ms, type: argument(false), doc: duration of the log (ms)}
      - {id: sdata, type: argument(false), doc: "text that describes the sensors, copied into the header"}
      - {id: handle, type: argument(false), doc: handle of the log}
  op_file_read_bytes:
    doc: Reads raw bytes from a file
    seq:
      - {id: handle, type: argument(false), doc: the open file}
      - {id: bytes, type: argument(false), doc: number of bytes (0 to 32767 bytes)}
      - id: destination
        type: argument(false)
        doc: "the bytes; followed by a zero if the file ended early (as many values as BYTES says)"
  op_file_write_bytes:
    doc: Writes raw bytes to a file
    seq:
      - {id: handle, type: argument(false), doc: the open file}
      - {id: bytes, type: argument(false), doc: number of bytes (0 to 32767 bytes)}
      - {id: source, type: argument(false), doc: the bytes (as many values as BYTES says)}
  op_file_remove:
    doc: "Deletes a file, or a folder with the files in it"
    seq:
      - id: name
        type: argument(false)
        doc: "path of the file; a bare name is taken from the program's own folder (at most 119 characters)"
  op_file_move:
    doc: "Copies a file or folder and replaces the destination; the source is kept"
    seq:
      - {id: source, type: argument(false), doc: path to copy from}
      - {id: dest, type: argument(false), doc: "path to copy to; any existing one is deleted first"}
  op_array_delete:
    doc: Deletes an array and frees its handle
    seq:
      - {id: handle, type: argument(false), doc: the array}
  op_array_create8:
    doc: Creates an array of DATA8 elements
    seq:
      - {id: elements, type: argument(false), doc: initial number of elements (0 to 6000000)}
      - {id: handle, type: argument(false), doc: handle of the new array}
  op_array_create16:
    doc: Creates an array of DATA16 elements
    seq:
      - {id: elements, type: argument(false), doc: initial number of elements (0 to 3000000)}
      - {id: handle, type: argument(false), doc: handle of the new array}
  op_array_create32:
    doc: Creates an array of DATA32 elements
    seq:
      - {id: elements, type: argument(false), doc: initial number of elements (0 to 1500000)}
      - {id: handle, type: argument(false), doc: handle of the new array}
  op_array_createf:
    doc: Creates an array of DATAF elements
    seq:
      - {id: elements, type: argument(false), doc: initial number of elements (0 to 1500000)}
      - {id: handle, type: argument(false), doc: handle of the new array}
  op_array_resize:
    doc: Changes the number of elements of an array
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: elements, type: argument(false), doc: new number of elements (0 to 6000000)}
  op_array_fill:
    doc: Sets every element of an array to one value
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: value, type: argument(false), doc: "the value, of the array's type"}
  op_array_copy:
    doc: "Copies the content of one array into another of the same type, which is resized to match"
    seq:
      - {id: hsource, type: argument(false), doc: array to copy from}
      - {id: hdest, type: argument(false), doc: "array to copy into, which must exist"}
  op_array_init8:
    doc: "Writes several elements of a DATA8 array, all within its size"
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: index, type: argument(false), doc: "first element to write, counted from 0 (0 to 5999999)"}
      - {id: elements, type: argument(false), doc: number of values that follow (0 to 2147483647)}
      - id: values
        type: argument(false)
        repeat: expr
        repeat-expr: elements.value
        doc: "the values, one parameter each (each is DATA8)"
  op_array_init16:
    doc: "Writes several elements of a DATA16 array, all within its size"
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: index, type: argument(false), doc: "first element to write, counted from 0 (0 to 5999999)"}
      - {id: elements, type: argument(false), doc: number of values that follow (0 to 2147483647)}
      - id: values
        type: argument(false)
        repeat: expr
        repeat-expr: elements.value
        doc: "the values, one parameter each (each is DATA16)"
  op_array_init32:
    doc: "Writes several elements of a DATA32 array, all within its size"
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: index, type: argument(false), doc: "first element to write, counted from 0 (0 to 5999999)"}
      - {id: elements, type: argument(false), doc: number of values that follow (0 to 2147483647)}
      - id: values
        type: argument(false)
        repeat: expr
        repeat-expr: elements.value
        doc: "the values, one parameter each (each is DATA32)"
  op_array_initf:
    doc: "Writes several elements of a DATAF array, all within its size"
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: index, type: argument(false), doc: "first element to write, counted from 0 (0 to 5999999)"}
      - {id: elements, type: argument(false), doc: number of values that follow (0 to 2147483647)}
      - id: values
        type: argument(true)
        repeat: expr
        repeat-expr: elements.value
        doc: "the values, one parameter each (each is DATAF)"
  op_array_size:
    doc: Counts the elements of an array
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: elements, type: argument(false), doc: "number of elements, 0 if there is no such array"}
  op_array_read_content:
    doc: "Reads an array's content as bytes, also of another program"
    seq:
      - {id: prgid, type: argument(false), doc: slot of the program that owns the array (a member of SLOT)}
      - {id: handle, type: argument(false), doc: the array}
      - id: index
        type: argument(false)
        doc: "first byte in the array's content, whatever its elements (0 to 2147483647)"
      - {id: bytes, type: argument(false), doc: number of bytes (0 to 2147483647 bytes)}
      - id: array
        type: argument(false)
        doc: "the bytes, zeros beyond the end of the array (as many values as BYTES says)"
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_array_write_content:
    doc: "Writes an array's content as bytes; the array then ends after them"
    seq:
      - {id: prgid, type: argument(false), doc: slot of the program that owns the array (a member of SLOT)}
      - {id: handle, type: argument(false), doc: the array}
      - id: index
        type: argument(false)
        doc: "first byte in the array's content, whatever its elements (0 to 2147483647)"
      - {id: bytes, type: argument(false), doc: number of bytes (0 to 2147483647 bytes)}
      - {id: array, type: argument(false), doc: the bytes (as many values as BYTES says)}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_array_read_size:
    doc: "Returns the size of an array's content, also of another program"
    seq:
      - {id: prgid, type: argument(false), doc: slot of the program that owns the array (a member of SLOT)}
      - {id: handle, type: argument(false), doc: the array}
      - {id: bytes, type: argument(false), doc: "number of bytes, 0 if there is no such array (bytes)"}
    instances:
      prgid_name: {value: prgid.value, enum: slot, if: prgid.is_number}
  op_array_write:
    doc: "Writes one element of an array, which grows where needed"
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: index, type: argument(false), doc: "which element, the first is 0 (0 to 5999999)"}
      - {id: value, type: argument(false), doc: "the value, of the array's type"}
  op_array_read:
    doc: Reads one element of an array
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: index, type: argument(false), doc: "which element, the first is 0 (0 to 5999999)"}
      - {id: value, type: argument(false), doc: "the value, of the array's type"}
  op_array_append:
    doc: Adds one element to the end of an array
    seq:
      - {id: handle, type: argument(false), doc: the array}
      - {id: value, type: argument(false), doc: "the value, of the array's type"}
  op_memory_usage:
    doc: Reports the total and free memory for user files
    seq:
      - {id: total, type: argument(false), doc: total memory (KiB)}
      - {id: free, type: argument(false), doc: free memory (KiB)}
  op_filename_exist:
    doc: Reports whether a file or folder exists
    seq:
      - id: name
        type: argument(false)
        doc: "path of the file; a bare name is taken from the program's own folder (at most 119 characters)"
      - {id: flag, type: argument(false), doc: "whether it exists (0: no; 1: yes)"}
  op_filename_totalsize:
    doc: Reports the number of files in a folder and their size
    seq:
      - {id: name, type: argument(false), doc: path of the folder or file}
      - {id: files, type: argument(false), doc: "number of entries, including . and ..; 0 for a file"}
      - {id: size, type: argument(false), doc: "size of all of them, rounded up (KiB)"}
  op_filename_split:
    doc: "Splits a path into folder, name and extension"
    seq:
      - {id: filename, type: argument(false), doc: the path}
      - {id: length, type: argument(false), doc: "buffer size for each of the three parts, including the zero (bytes)"}
      - id: folder
        type: argument(false)
        doc: "the folder, with its closing slash on LEGO's firmware (as many bytes as LENGTH says)"
      - {id: name, type: argument(false), doc: "the name, without folder and extension (as many bytes as LENGTH says)"}
      - {id: ext, type: argument(false), doc: the extension with its dot (as many bytes as LENGTH says)}
  op_filename_merge:
    doc: "Builds a path from folder, name and extension"
    seq:
      - {id: folder, type: argument(false), doc: "the folder, without a slash at its end"}
      - {id: name, type: argument(false), doc: the name}
      - {id: ext, type: argument(false), doc: the extension with its dot}
      - {id: length, type: argument(false), doc: "size of the string's buffer, including the zero (bytes)"}
      - {id: filename, type: argument(false), doc: the path (as many bytes as LENGTH says)}
  op_filename_check:
    doc: "Reports whether a path's characters and lengths are allowed; the file need not exist"
    seq:
      - {id: filename, type: argument(false), doc: the path}
      - {id: ok, type: argument(false), doc: "whether the path can be used (0: not allowed; 1: allowed)"}
  op_filename_pack:
    doc: Packs a file or folder into a .raf archive beside it
    seq:
      - {id: filename, type: argument(false), doc: path of the file or folder}
  op_filename_unpack:
    doc: Unpacks a .raf archive into the folder it is in
    seq:
      - {id: filename, type: argument(false), doc: "path of the archive; its extension is replaced by .raf"}
  op_filename_get_foldername:
    doc: "Reads the path of the program's own folder"
    seq:
      - {id: length, type: argument(false), doc: "size of the string's buffer, including the zero (bytes)"}
      - id: foldername
        type: argument(false)
        doc: "path of the folder, without a slash at its end (as many bytes as LENGTH says)"
  op_com_read_command:
    doc: Returns the address of the last direct command received
    seq:
      - {id: length, type: argument(false), doc: "maximum number of bytes of code, ignored by the firmware (bytes)"}
      - {id: image, type: argument(false), doc: address of the code}
      - {id: global_, type: argument(false), doc: address of its global memory}
      - {id: flag, type: argument(false), doc: "whether one is waiting (0 to 1; 0: none; 1: ready to run)"}
  op_com_write_reply:
    doc: Sends the global memory of a direct command that has run as its reply
    seq:
      - {id: image, type: argument(false), doc: address of the code}
      - {id: global_, type: argument(false), doc: address of its global memory}
      - id: status
        type: argument(false)
        doc: "how it ended; all but OK give DIRECT_REPLY_ERROR (a member of RESULT)"
    instances:
      status_name: {value: status.value, enum: result, if: status.is_number}
  op_com_ready:
    doc: Waits until nothing is being sent to a device
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: name, type: argument(false), doc: "name of the other device, empty: the brick's own adapter"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_readdata:
    doc: "Does nothing in the firmware; meant to receive data"
    seq:
      - {id: value1, type: argument(false), doc: "carrier, ignored (a member of HWTYPE)"}
      - {id: value2, type: argument(false), doc: "name of the other device, ignored"}
      - {id: value3, type: argument(false), doc: "number of bytes, ignored (bytes)"}
      - {id: value4, type: argument(false), doc: "the bytes, ignored"}
    instances:
      value1_name: {value: value1.value, enum: hwtype, if: value1.is_number}
  op_com_writedata:
    doc: "Does nothing in the firmware; meant to send data"
    seq:
      - {id: value1, type: argument(false), doc: "carrier, ignored (a member of HWTYPE)"}
      - {id: value2, type: argument(false), doc: "name of the other device, ignored"}
      - {id: value3, type: argument(false), doc: "number of bytes, ignored (bytes)"}
      - {id: value4, type: argument(false), doc: "the bytes, ignored"}
    instances:
      value1_name: {value: value1.value, enum: hwtype, if: value1.is_number}
  op_com_get_get_on_off:
    doc: Reports whether Bluetooth or WiFi is on
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: active, type: argument(false), doc: "whether it is on (0 to 1; 0: off; 1: on)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_visible:
    doc: Reports whether other devices can see the brick by Bluetooth
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (1 to 3; a member of HWTYPE)"}
      - {id: visible, type: argument(false), doc: "whether it is visible (0 to 1; 0: no; 1: yes)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_result:
    doc: Reports the state of a search or connection request
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: item, type: argument(false), doc: "place in the list, ignored by the firmware"}
      - {id: result, type: argument(false), doc: state of the request (a member of RESULT)}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_pin:
    doc: "Reads the PIN for a device, always 1234"
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: name, type: argument(false), doc: name of the other device or network}
      - {id: length, type: argument(false), doc: "size of the PIN's buffer, including the zero (bytes)"}
      - {id: pincode, type: argument(false), doc: the PIN (as many bytes as LENGTH says)}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_search_items:
    doc: Counts the devices or networks that a search found
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: items, type: argument(false), doc: number of entries in the list}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_search_item:
    doc: Describes one device or network that a search found
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: item, type: argument(false), doc: "place in the list, counted from 0"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: name, type: argument(false), doc: name of the other device or network (as many bytes as LENGTH says)}
      - id: paired
        type: argument(false)
        doc: "whether it is paired (Bluetooth) or known (WiFi) (0 to 1; 0: no; 1: yes)"
      - {id: connected, type: argument(false), doc: "whether it is connected (0 to 1; 0: no; 1: yes)"}
      - id: type_
        type: argument(false)
        doc: "kind of device (Bluetooth) or encryption (WiFi) (0: WiFi, not encrypted; 1: WiFi, WPA2; a member of BTTYPE)"
      - {id: visible, type: argument(false), doc: "whether it is in range (0 to 1; 0: no; 1: yes)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_favour_items:
    doc: "Counts the paired devices, in range or not"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 2; a member of HWTYPE)"}
      - {id: items, type: argument(false), doc: number of entries in the list}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_favour_item:
    doc: Describes one paired device or known network
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: item, type: argument(false), doc: "place in the list, counted from 0"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: name, type: argument(false), doc: name of the other device or network (as many bytes as LENGTH says)}
      - id: paired
        type: argument(false)
        doc: "whether it is paired (Bluetooth) or known (WiFi) (0 to 1; 0: no; 1: yes)"
      - {id: connected, type: argument(false), doc: "whether it is connected (0 to 1; 0: no; 1: yes)"}
      - id: type_
        type: argument(false)
        doc: "kind of device (Bluetooth) or encryption (WiFi) (0: WiFi, not encrypted; 1: WiFi, WPA2; a member of BTTYPE)"
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_id:
    doc: "Reads the brick's Bluetooth address"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 2; a member of HWTYPE)"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: string_, type: argument(false), doc: "12 hex digits (as many bytes as LENGTH says)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_brickname:
    doc: "Reads the brick's name"
    seq:
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: name, type: argument(false), doc: name of the brick (as many bytes as LENGTH says)}
  op_com_get_get_network:
    doc: "Reads network name and addresses, WiFi only"
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - id: length
        type: argument(false)
        doc: "buffer size for each of the three texts, including the zero (bytes; -1: unlimited (handles only))"
      - {id: name, type: argument(false), doc: "name of the network, NONE without one (as many bytes as LENGTH says)"}
      - id: mac
        type: argument(false)
        doc: "MAC address of the brick, ?? when WiFi is off (at most 17 characters; as many bytes as LENGTH says)"
      - id: ip
        type: argument(false)
        doc: "IP address of the brick, ?? when not connected (at most 15 characters; as many bytes as LENGTH says)"
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_present:
    doc: "Reports whether the hardware is present (for WiFi: a known dongle)"
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: ok, type: argument(false), doc: "whether it is present (0 to 1; 0: no; 1: yes)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_encrypt:
    doc: "Reports the encryption of a network, WiFi only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (3 to 3; a member of HWTYPE)"}
      - {id: item, type: argument(false), doc: "place in the list, counted from 0"}
      - id: type_
        type: argument(false)
        doc: "kind of encryption; always none in the 2013 firmware (a member of ENCRYPT)"
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_connec_items:
    doc: "Counts the connected devices, Bluetooth only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (1 to 3; a member of HWTYPE)"}
      - {id: items, type: argument(false), doc: number of entries in the list}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_connec_item:
    doc: "Describes one connected device, Bluetooth only"
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: item, type: argument(false), doc: "place in the list, counted from 0"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: name, type: argument(false), doc: name of the device (as many bytes as LENGTH says)}
      - {id: type_, type: argument(false), doc: kind of device (a member of BTTYPE)}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_incoming:
    doc: "Reports which device asks for a connection, Bluetooth only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 2; a member of HWTYPE)"}
      - id: length
        type: argument(false)
        doc: "size of the text buffer, including the zero (bytes; -1: unlimited (handles only))"
      - {id: name, type: argument(false), doc: name of the device (as many bytes as LENGTH says)}
      - {id: type_, type: argument(false), doc: kind of device (a member of BTTYPE)}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_get_get_mode2:
    doc: Reports whether Bluetooth is in its mode for Apple devices
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 2; a member of HWTYPE)"}
      - {id: active, type: argument(false), doc: "whether it is on (0 to 1; 0: off; 1: on)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_on_off:
    doc: Switches Bluetooth or WiFi on or off
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: active, type: argument(false), doc: "whether to switch it on (0 to 1; 0: off; 1: on)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_visible:
    doc: "Makes the brick visible or invisible, Bluetooth only"
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: visible, type: argument(false), doc: "whether other devices can see it (0 to 1; 0: invisible; 1: visible)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_search:
    doc: Starts or stops the search for devices or networks
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: search, type: argument(false), doc: "whether to search (0 to 1; 0: stop (Bluetooth only); 1: start)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_pin:
    doc: "Answers the request for a PIN (Bluetooth) or stores a network's password (WiFi)"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: name, type: argument(false), doc: name of the other device or network}
      - {id: pincode, type: argument(false), doc: PIN or password}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_passkey:
    doc: "Answers the request to confirm a passkey, Bluetooth only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 2; a member of HWTYPE)"}
      - {id: accept, type: argument(false), doc: "the answer (0 to 1; 0: reject; 1: accept)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_connection:
    doc: "Connects a device or network, or ends a Bluetooth connection"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 3; a member of HWTYPE)"}
      - {id: name, type: argument(false), doc: name of the other device or network}
      - {id: connection, type: argument(false), doc: "what to do (0 to 1; 0: disconnect; 1: connect)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_brickname:
    doc: Renames the brick
    seq:
      - id: name
        type: argument(false)
        doc: "new name, at most 118 characters, else refused (at most 118 characters)"
  op_com_set_set_moveup:
    doc: "Moves a network up in the list, WiFi only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (3 to 3; a member of HWTYPE)"}
      - {id: item, type: argument(false), doc: "place in the list, counted from 0"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_movedown:
    doc: "Moves a network down in the list, WiFi only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (3 to 3; a member of HWTYPE)"}
      - {id: item, type: argument(false), doc: "place in the list, counted from 0"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_encrypt:
    doc: "Sets the encryption of a network, WiFi only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (3 to 3; a member of HWTYPE)"}
      - {id: item, type: argument(false), doc: name of the network}
      - {id: encrypt, type: argument(false), doc: kind of encryption (a member of ENCRYPT)}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
      encrypt_name: {value: encrypt.value, enum: encrypt, if: encrypt.is_number}
  op_com_set_set_ssid:
    doc: "Adds a network to the end of the list, WiFi only"
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (3 to 3; a member of HWTYPE)"}
      - {id: name, type: argument(false), doc: name of the network}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_set_set_mode2:
    doc: Switches the Bluetooth mode for Apple devices on or off
    seq:
      - {id: hardware, type: argument(false), doc: "carrier to use (2 to 2; a member of HWTYPE)"}
      - {id: active, type: argument(false), doc: "whether to switch it on (0 to 1; 0: off; 1: on)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_test:
    doc: Reports whether something is still being sent to a device
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: name, type: argument(false), doc: "name of the other device, empty: the brick's own adapter"}
      - {id: busy, type: argument(false), doc: "whether to wait (0 to 1; 0: ready; 1: busy)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_remove:
    doc: Forgets a paired device or a known network
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: remote_name, type: argument(false), doc: name of the other device or network}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
  op_com_writefile:
    doc: "Sends a file or a folder to another brick, Bluetooth only"
    seq:
      - {id: hardware, type: argument(false), doc: carrier to use (a member of HWTYPE)}
      - {id: remote_name, type: argument(false), doc: name of the other device or network}
      - {id: file_name, type: argument(false), doc: path of the file or folder on this brick}
      - {id: file_type, type: argument(false), doc: "TYPE_FOLDER for a folder, else a file (a member of FILETYPE)"}
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
      file_type_name: {value: file_type.value, enum: filetype, if: file_type.is_number}
  op_mailbox_open:
    doc: "Opens a mailbox on this brick, at most 250 bytes of content"
    seq:
      - {id: "no", type: argument(false), doc: number of the mailbox on this brick (0 to 29)}
      - {id: boxname, type: argument(false), doc: name of the mailbox (at most 49 characters)}
      - {id: types, type: argument(false), doc: type of its values (a member of DATA_FORMAT)}
      - {id: fifosize, type: argument(false), doc: "depth of the queue, ignored by the firmware"}
      - {id: values, type: argument(false), doc: "number of values, ignored by the firmware"}
    instances:
      types_name: {value: types.value, enum: data_format, if: types.is_number}
  op_mailbox_write:
    doc: "Sends values to a mailbox of another brick, Bluetooth only"
    seq:
      - {id: brickname, type: argument(false), doc: "name of the other brick, empty: all connected ones"}
      - id: hardware
        type: argument(false)
        doc: "read by the firmware and never used (0: as compilers write; a member of HWTYPE)"
      - {id: boxname, type: argument(false), doc: name of the mailbox (at most 49 characters)}
      - {id: type_, type: argument(false), doc: type of the values (a member of DATA_FORMAT)}
      - id: values_count
        type: argument(false)
        doc: "number of values of TYPE follow; exactly one for a string, of at most 249 characters (at most 249 characters; each is what TYPE says)"
      - id: values
        type: "argument(type_.is_number and (type_.value == 3 or type_.value == 19))"
        repeat: expr
        repeat-expr: values_count.value
    instances:
      hardware_name: {value: hardware.value, enum: hwtype, if: hardware.is_number}
      type__name: {value: type_.value, enum: data_format, if: type_.is_number}
  op_mailbox_read:
    doc: Reads the content of a mailbox and marks it read
    seq:
      - {id: "no", type: argument(false), doc: number of the mailbox on this brick (0 to 29)}
      - {id: length, type: argument(false), doc: "maximum number of bytes to read, ignored by the firmware (bytes)"}
      - id: values_count
        type: argument(false)
        doc: "number of values that follow, in the type of MAILBOX_OPEN (each is array-typed)"
      - {id: values, type: argument(false), repeat: expr, repeat-expr: values_count.value}
  op_mailbox_test:
    doc: Reports whether a mailbox has an unread message
    seq:
      - {id: "no", type: argument(false), doc: number of the mailbox on this brick (0 to 29)}
      - {id: busy, type: argument(false), doc: "whether to wait (0 to 1; 0: a new message is there; 1: nothing new)"}
  op_mailbox_ready:
    doc: Waits for an unread message in a mailbox
    seq:
      - {id: "no", type: argument(false), doc: number of the mailbox on this brick (0 to 29)}
  op_mailbox_close:
    doc: Closes a mailbox on this brick
    seq:
      - {id: "no", type: argument(false), doc: number of the mailbox on this brick (0 to 29)}
enums:
  message_type:
    0x00: direct_command_reply
    0x80: direct_command_no_reply
    0x01: system_command_reply
    0x81: system_command_no_reply
    0x02: direct_reply
    0x04: direct_reply_error
    0x03: system_reply
    0x05: system_reply_error
    0x0A: daisy_command_reply
    0x8A: daisy_command_no_reply
    0x08: daisy_reply
    0x09: daisy_reply_error
  system_code:
    0x92:
      id: begin_download
      doc: Opens a file on the brick for writing and announces its size
    0x93:
      id: continue_download
      doc: "Writes the next piece of a file; the file closes itself when it is complete"
    0x94:
      id: begin_upload
      doc: Opens a file on the brick for reading and fetches its first piece
    0x95:
      id: continue_upload
      doc: Fetches the next piece of a file
    0x96:
      id: begin_getfile
      doc: "Opens a file that may still be growing, such as a data log, and fetches its first piece"
    0x97:
      id: continue_getfile
      doc: Fetches the next piece of a file that may still be growing
    0x98:
      id: close_filehandle
      doc: Closes an open file before its end
    0x99:
      id: list_files
      doc: Lists a folder and fetches the first piece of the listing
    0x9A:
      id: continue_list_files
      doc: Fetches the next piece of a listing
    0x9B:
      id: create_dir
      doc: Creates a folder
    0x9C:
      id: delete_file
      doc: Deletes a file or an empty folder
    0x9D:
      id: list_open_handles
      doc: Asks which file handles are in use
    0x9E:
      id: writemailbox
      doc: Puts a message into a mailbox of the program that runs on the brick
    0x9F:
      id: bluetoothpin
      doc: Sends the PIN for a Bluetooth device (USB only)
    0xA0:
      id: enterfwupdate
      doc: Restarts the brick into its firmware updater
    0xA1:
      id: setbundleid
      doc: Sets the bundle identifier that the brick shows to Apple devices
    0xA2:
      id: setbundleseedid
      doc: Sets the bundle seed identifier that the brick shows to Apple devices
    0xF0:
      id: bootloader_begin_download_with_erase
      doc: Erases a region of the flash memory and prepares to write it
    0xF1:
      id: bootloader_begin_download
      doc: Prepares to write a region of the flash memory that is already erased
    0xF2:
      id: bootloader_download_data
      doc: Writes the next piece of the image
    0xF3:
      id: bootloader_chip_erase
      doc: Erases the whole flash memory
    0xF4:
      id: bootloader_start_app
      doc: Leaves the updater and starts the firmware
    0xF5:
      id: bootloader_get_checksum
      doc: Asks for the checksum of a region of the flash memory
    0xF6:
      id: bootloader_get_version
      doc: Asks for the versions of hardware and firmware
  system_status:
    0: success
    1: unknown_handle
    2: handle_not_ready
    3: corrupt_file
    4: no_handles_available
    5: no_permission
    6: illegal_path
    7: file_exits
    8: end_of_file
    9: size_error
    10: unknown_error
    11: illegal_filename
    12: illegal_connection
  daisy_code:
    0xA0:
      id: downstream
      doc: Forwards operations to a brick further down
    0xA1:
      id: upstream
      doc: Passes sensor data up towards the first brick
    0xA2:
      id: info
      doc: Asks which sensors a brick further down has
    0xA3:
      id: unlock_slave
      doc: Allows the brick below to answer again
    0xA4:
      id: set_type
      doc: Sets type and mode of a sensor further down
    0xA5:
      id: downstream_with_busy
      doc: "Forwards operations, and names the motors to report as busy"
  opcode:
    0x00:
      id: error
      doc: "Ends the program with a failure; never valid on the wire"
    0x01:
      id: nop
      doc: "Does nothing; a harmless way to test whether the brick answers"
    0x02:
      id: program_stop
      doc: Stops the program of a slot
    0x03:
      id: program_start
      doc: "Starts a loaded program; a direct command can do this only while no user program runs"
    0x04:
      id: object_stop
      doc: Stops an object of its own program
    0x05:
      id: object_start
      doc: Starts an object of its own program
    0x06:
      id: object_trig
      doc: "Counts an object's trigger down; at zero the object starts"
    0x07:
      id: object_wait
      doc: Waits until an object has ended
    0x08:
      id: return_
      doc: Returns from a subroutine to its caller
    0x09:
      id: call
      doc: "Calls a subroutine of its own program; waits while another thread runs it"
    0x0A:
      id: object_end
      doc: "Ends the object; the firmware appends one to every direct command"
    0x0B:
      id: sleep
      doc: "Gives up the rest of the thread's time slice"
    0x0C:
      id: program_info
      doc: Asks about a program or controls its objects
    0x0D:
      id: label
      doc: "Marks a place that jumps can name; does nothing itself"
    0x0E:
      id: probe
      doc: "Prints a program's memory on the brick's debug terminal"
    0x0F:
      id: do_
      doc: "Runs byte code that is already in memory, ending the slot's previous program"
    0x60:
      id: system
      doc: "Runs a shell command on the brick's Linux and waits until it ends"
    0x61:
      id: port_cnv_output
      doc: "Splits a motor port number as LEGO's editor writes it"
    0x62:
      id: port_cnv_input
      doc: "Splits a sensor port number as LEGO's editor writes it"
    0x63:
      id: note_to_freq
      doc: Converts the name of a note to its frequency
    0x7C:
      id: info
      doc: "Reads and sets the error log, the volume and the time to power off"
    0x7D:
      id: strings
      doc: "Works with texts: joins, compares, converts from and to numbers"
    0x88:
      id: bp0
      doc: "Stops at breakpoint 0; BP_SET puts it over the instruction it replaces"
    0x89:
      id: bp1
      doc: "Stops at breakpoint 1; BP_SET puts it over the instruction it replaces"
    0x8A:
      id: bp2
      doc: "Stops at breakpoint 2; BP_SET puts it over the instruction it replaces"
    0x8B:
      id: bp3
      doc: "Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces"
    0x8C:
      id: bp_set
      doc: Sets or removes a breakpoint in a running program
    0xFF:
      id: tst
      doc: "Tests the hardware, as the factory does; all fail before TST_OPEN"
    0x10:
      id: add8
      doc: Adds two 8-bit numbers
    0x11:
      id: add16
      doc: Adds two 16-bit numbers
    0x12:
      id: add32
      doc: Adds two 32-bit numbers
    0x13:
      id: addf
      doc: Adds two floating-point numbers
    0x14:
      id: sub8
      doc: Subtracts one 8-bit number from another
    0x15:
      id: sub16
      doc: Subtracts one 16-bit number from another
    0x16:
      id: sub32
      doc: Subtracts one 32-bit number from another
    0x17:
      id: subf
      doc: Subtracts one floating-point number from another
    0x18:
      id: mul8
      doc: Multiplies two 8-bit numbers
    0x19:
      id: mul16
      doc: Multiplies two 16-bit numbers
    0x1A:
      id: mul32
      doc: Multiplies two 32-bit numbers
    0x1B:
      id: mulf
      doc: Multiplies two floating-point numbers
    0x1C:
      id: div8
      doc: "Divides two 8-bit numbers; by zero gives the largest or smallest value"
    0x1D:
      id: div16
      doc: "Divides two 16-bit numbers; by zero gives the largest or smallest value"
    0x1E:
      id: div32
      doc: "Divides two 32-bit numbers; by zero gives the largest or smallest value"
    0x1F:
      id: divf
      doc: "Divides two floating-point numbers; by zero gives infinity or NaN"
    0x20:
      id: or8
      doc: "Combines 8-bit values, bit by bit, by OR"
    0x21:
      id: or16
      doc: "Combines 16-bit values, bit by bit, by OR"
    0x22:
      id: or32
      doc: "Combines 32-bit values, bit by bit, by OR"
    0x24:
      id: and8
      doc: "Combines 8-bit values, bit by bit, by AND"
    0x25:
      id: and16
      doc: "Combines 16-bit values, bit by bit, by AND"
    0x26:
      id: and32
      doc: "Combines 32-bit values, bit by bit, by AND"
    0x28:
      id: xor8
      doc: "Combines 8-bit values, bit by bit, by exclusive OR"
    0x29:
      id: xor16
      doc: "Combines 16-bit values, bit by bit, by exclusive OR"
    0x2A:
      id: xor32
      doc: "Combines 32-bit values, bit by bit, by exclusive OR"
    0x2C:
      id: rl8
      doc: "Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost"
    0x2D:
      id: rl16
      doc: "Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost"
    0x2E:
      id: rl32
      doc: "Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost"
    0x8D:
      id: math
      doc: Applies a mathematical function
    0x8E:
      id: random
      doc: Draws a random whole number
    0x2F:
      id: init_bytes
      doc: Fills consecutive bytes of memory with constant values
    0x30:
      id: move8_8
      doc: "Copies a value to another variable, both 8-bit"
    0x31:
      id: move8_16
      doc: "Converts a value, 8-bit to 16-bit; NaN stays NaN"
    0x32:
      id: move8_32
      doc: "Converts a value, 8-bit to 32-bit; NaN stays NaN"
    0x33:
      id: move8_f
      doc: "Converts a value, 8-bit to floating-point; NaN stays NaN"
    0x34:
      id: move16_8
      doc: "Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN"
    0x35:
      id: move16_16
      doc: "Copies a value to another variable, both 16-bit"
    0x36:
      id: move16_32
      doc: "Converts a value, 16-bit to 32-bit; NaN stays NaN"
    0x37:
      id: move16_f
      doc: "Converts a value, 16-bit to floating-point; NaN stays NaN"
    0x38:
      id: move32_8
      doc: "Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN"
    0x39:
      id: move32_16
      doc: "Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN"
    0x3A:
      id: move32_32
      doc: "Copies a value to another variable, both 32-bit"
    0x3B:
      id: move32_f
      doc: "Converts a value, 32-bit to floating-point; NaN stays NaN"
    0x3C:
      id: movef_8
      doc: "Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN"
    0x3D:
      id: movef_16
      doc: "Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN"
    0x3E:
      id: movef_32
      doc: "Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN"
    0x3F:
      id: movef_f
      doc: "Copies a value to another variable, both floating-point"
    0xC8:
      id: read8
      doc: Reads one element of an array of 8-bit values
    0xC9:
      id: read16
      doc: Reads one element of an array of 16-bit values
    0xCA:
      id: read32
      doc: Reads one element of an array of 32-bit values
    0xCB:
      id: readf
      doc: Reads one element of an array of floating-point values
    0xCC:
      id: write8
      doc: Writes one element of an array of 8-bit values
    0xCD:
      id: write16
      doc: Writes one element of an array of 16-bit values
    0xCE:
      id: write32
      doc: Writes one element of an array of 32-bit values
    0xCF:
      id: writef
      doc: Writes one element of an array of floating-point values
    0x40:
      id: jr
      doc: Jumps always
    0x41:
      id: jr_false
      doc: Jumps if a flag is 0
    0x42:
      id: jr_true
      doc: Jumps if a flag is not 0
    0x43:
      id: jr_nan
      doc: "Jumps if a value is not a number, as read from a sensor without data"
    0x64:
      id: jr_lt8
      doc: "Jumps if LEFT is less than RIGHT, as 8-bit numbers"
    0x65:
      id: jr_lt16
      doc: "Jumps if LEFT is less than RIGHT, as 16-bit numbers"
    0x66:
      id: jr_lt32
      doc: "Jumps if LEFT is less than RIGHT, as 32-bit numbers"
    0x67:
      id: jr_ltf
      doc: "Jumps if LEFT is less than RIGHT, as floating-point numbers"
    0x68:
      id: jr_gt8
      doc: "Jumps if LEFT is greater than RIGHT, as 8-bit numbers"
    0x69:
      id: jr_gt16
      doc: "Jumps if LEFT is greater than RIGHT, as 16-bit numbers"
    0x6A:
      id: jr_gt32
      doc: "Jumps if LEFT is greater than RIGHT, as 32-bit numbers"
    0x6B:
      id: jr_gtf
      doc: "Jumps if LEFT is greater than RIGHT, as floating-point numbers"
    0x6C:
      id: jr_eq8
      doc: "Jumps if LEFT is equal to RIGHT, as 8-bit numbers"
    0x6D:
      id: jr_eq16
      doc: "Jumps if LEFT is equal to RIGHT, as 16-bit numbers"
    0x6E:
      id: jr_eq32
      doc: "Jumps if LEFT is equal to RIGHT, as 32-bit numbers"
    0x6F:
      id: jr_eqf
      doc: "Jumps if LEFT is equal to RIGHT, as floating-point numbers"
    0x70:
      id: jr_neq8
      doc: "Jumps if LEFT is different from RIGHT, as 8-bit numbers"
    0x71:
      id: jr_neq16
      doc: "Jumps if LEFT is different from RIGHT, as 16-bit numbers"
    0x72:
      id: jr_neq32
      doc: "Jumps if LEFT is different from RIGHT, as 32-bit numbers"
    0x73:
      id: jr_neqf
      doc: "Jumps if LEFT is different from RIGHT, as floating-point numbers"
    0x74:
      id: jr_lteq8
      doc: "Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers"
    0x75:
      id: jr_lteq16
      doc: "Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers"
    0x76:
      id: jr_lteq32
      doc: "Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers"
    0x77:
      id: jr_lteqf
      doc: "Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers"
    0x78:
      id: jr_gteq8
      doc: "Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers"
    0x79:
      id: jr_gteq16
      doc: "Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers"
    0x7A:
      id: jr_gteq32
      doc: "Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers"
    0x7B:
      id: jr_gteqf
      doc: "Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers"
    0x44:
      id: cp_lt8
      doc: "Tests whether LEFT is less than RIGHT, as 8-bit numbers"
    0x45:
      id: cp_lt16
      doc: "Tests whether LEFT is less than RIGHT, as 16-bit numbers"
    0x46:
      id: cp_lt32
      doc: "Tests whether LEFT is less than RIGHT, as 32-bit numbers"
    0x47:
      id: cp_ltf
      doc: "Tests whether LEFT is less than RIGHT, as floating-point numbers"
    0x48:
      id: cp_gt8
      doc: "Tests whether LEFT is greater than RIGHT, as 8-bit numbers"
    0x49:
      id: cp_gt16
      doc: "Tests whether LEFT is greater than RIGHT, as 16-bit numbers"
    0x4A:
      id: cp_gt32
      doc: "Tests whether LEFT is greater than RIGHT, as 32-bit numbers"
    0x4B:
      id: cp_gtf
      doc: "Tests whether LEFT is greater than RIGHT, as floating-point numbers"
    0x4C:
      id: cp_eq8
      doc: "Tests whether LEFT is equal to RIGHT, as 8-bit numbers"
    0x4D:
      id: cp_eq16
      doc: "Tests whether LEFT is equal to RIGHT, as 16-bit numbers"
    0x4E:
      id: cp_eq32
      doc: "Tests whether LEFT is equal to RIGHT, as 32-bit numbers"
    0x4F:
      id: cp_eqf
      doc: "Tests whether LEFT is equal to RIGHT, as floating-point numbers"
    0x50:
      id: cp_neq8
      doc: "Tests whether LEFT is different from RIGHT, as 8-bit numbers"
    0x51:
      id: cp_neq16
      doc: "Tests whether LEFT is different from RIGHT, as 16-bit numbers"
    0x52:
      id: cp_neq32
      doc: "Tests whether LEFT is different from RIGHT, as 32-bit numbers"
    0x53:
      id: cp_neqf
      doc: "Tests whether LEFT is different from RIGHT, as floating-point numbers"
    0x54:
      id: cp_lteq8
      doc: "Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers"
    0x55:
      id: cp_lteq16
      doc: "Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers"
    0x56:
      id: cp_lteq32
      doc: "Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers"
    0x57:
      id: cp_lteqf
      doc: "Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers"
    0x58:
      id: cp_gteq8
      doc: "Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers"
    0x59:
      id: cp_gteq16
      doc: "Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers"
    0x5A:
      id: cp_gteq32
      doc: "Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers"
    0x5B:
      id: cp_gteqf
      doc: "Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers"
    0x5C:
      id: select8
      doc: Selects one of two 8-bit values by a flag
    0x5D:
      id: select16
      doc: Selects one of two 16-bit values by a flag
    0x5E:
      id: select32
      doc: Selects one of two 32-bit values by a flag
    0x5F:
      id: selectf
      doc: Selects one of two floating-point values by a flag
    0x80:
      id: ui_flush
      doc: "Sends the contents of the terminal's output buffer"
    0x81:
      id: ui_read
      doc: Reads the state of the brick or what the terminal received
    0x82:
      id: ui_write
      doc: Writes to the terminal or sets lights and states of the brick
    0x83:
      id: ui_button
      doc: Reads or simulates the buttons
    0x84:
      id: ui_draw
      doc: "Draws on the canvas of the display, or runs a dialogue on it"
    0x90:
      id: keep_alive
      doc: "Restarts the timer that switches off an idle brick, and reads its time"
    0x85:
      id: timer_wait
      doc: "Stores the end of a wait and returns at once; TIMER_READY does the waiting"
    0x86:
      id: timer_ready
      doc: Waits until the time that TIMER_WAIT stored
    0x87:
      id: timer_read
      doc: Reads the time since the start of the program or direct command that asks
    0x8F:
      id: timer_read_us
      doc: "Reads the free-running microsecond clock, for differences only"
    0x94:
      id: sound
      doc: Plays or stops a sound
    0x95:
      id: sound_test
      doc: Reports whether a sound is playing
    0x96:
      id: sound_ready
      doc: "Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file)"
    0x97:
      id: input_sample
      doc: "Reads one SI value of each of several devices, sampled in the background"
    0x98:
      id: input_device_list
      doc: "Lists the types of all devices, sensor ports of each layer first, then motor ports"
    0x99:
      id: input_device
      doc: "Asks about devices, calibrates them, reads several values"
    0x9A:
      id: input_read
      doc: Sets type and mode and reads the first value in percent at once
    0x9B:
      id: input_test
      doc: Reports whether a device is still changing type or mode
    0x9C:
      id: input_ready
      doc: Waits until a device has valid values
    0x9D:
      id: input_readsi
      doc: Sets type and mode and reads the first value in SI units at once
    0x9E:
      id: input_readext
      doc: "Sets type and mode and reads several values at once, in the format asked for"
    0x9F:
      id: input_write
      doc: Sends bytes to a UART sensor
    0xA1:
      id: output_set_type
      doc: Declares which type of motor is at a port
    0xA2:
      id: output_reset
      doc: Sets the tacho counts that moves and OUTPUT_READ use to zero
    0xA3:
      id: output_stop
      doc: Stops motors
    0xA4:
      id: output_power
      doc: "Sets the power of motors, which run at the next OUTPUT_START"
    0xA5:
      id: output_speed
      doc: "Sets the speed of motors, which run at the next OUTPUT_START"
    0xA6:
      id: output_start
      doc: Starts motors with the power or speed set before
    0xA7:
      id: output_polarity
      doc: Sets the direction of motors
    0xA8:
      id: output_read
      doc: "Reads speed and tacho count of one motor, 0 on layers other than 0"
    0xA9:
      id: output_test
      doc: Reports whether one of the motors is still in a move that ends by itself
    0xAA:
      id: output_ready
      doc: "Waits until the moves of the motors have ended; ignores those from OUTPUT_START"
    0xAC:
      id: output_step_power
      doc: Turns motors by an angle with unregulated power
    0xAD:
      id: output_time_power
      doc: Runs motors for a time with unregulated power
    0xAE:
      id: output_step_speed
      doc: Turns motors by an angle with regulated speed
    0xAF:
      id: output_time_speed
      doc: Runs motors for a time with regulated speed
    0xB0:
      id: output_step_sync
      doc: Turns two motors in step by an angle
    0xB1:
      id: output_time_sync
      doc: Runs two motors in step for a time
    0xB2:
      id: output_clr_count
      doc: Sets the tacho counts of motors read as sensors to zero
    0xB3:
      id: output_get_count
      doc: Reads the tacho count of a motor read as a sensor
    0xB4:
      id: output_prg_stop
      doc: Stops and resets all motors as the end of a program does
    0x7E:
      id: memory_write
      doc: Writes bytes into the variables of a running program
    0x7F:
      id: memory_read
      doc: Reads bytes from the variables of a running program
    0xC0:
      id: file
      doc: "Works on files, folders, data logs, program images and the list of recent files"
    0xC1:
      id: array
      doc: "Creates, fills, copies and resizes arrays"
    0xC2:
      id: array_write
      doc: "Writes one element of an array, which grows where needed"
    0xC3:
      id: array_read
      doc: Reads one element of an array
    0xC4:
      id: array_append
      doc: Adds one element to the end of an array
    0xC5:
      id: memory_usage
      doc: Reports the total and free memory for user files
    0xC6:
      id: filename
      doc: "Splits and checks file names, and packs files"
    0x91:
      id: com_read
      doc: "Fetches direct commands, for the brick's own command program"
    0x92:
      id: com_write
      doc: "Answers direct commands, for the brick's own command program"
    0xD0:
      id: com_ready
      doc: Waits until nothing is being sent to a device
    0xD1:
      id: com_readdata
      doc: "Does nothing in the firmware; meant to receive data"
    0xD2:
      id: com_writedata
      doc: "Does nothing in the firmware; meant to send data"
    0xD3:
      id: com_get
      doc: "Asks about the brick's connections and the devices around it"
    0xD4:
      id: com_set
      doc: "Changes the brick's name, its connections and its lists of devices"
    0xD5:
      id: com_test
      doc: Reports whether something is still being sent to a device
    0xD6:
      id: com_remove
      doc: Forgets a paired device or a known network
    0xD7:
      id: com_writefile
      doc: "Sends a file or a folder to another brick, Bluetooth only"
    0xD8:
      id: mailbox_open
      doc: "Opens a mailbox on this brick, at most 250 bytes of content"
    0xD9:
      id: mailbox_write
      doc: "Sends values to a mailbox of another brick, Bluetooth only"
    0xDA:
      id: mailbox_read
      doc: Reads the content of a mailbox and marks it read
    0xDB:
      id: mailbox_test
      doc: Reports whether a mailbox has an unread message
    0xDC:
      id: mailbox_ready
      doc: Waits for an unread message in a mailbox
    0xDD:
      id: mailbox_close
      doc: Closes a mailbox on this brick
  browsertype:
    0: browse_folders
    1: browse_folds_files
    2: browse_cache
    3: browse_files
  bttype:
    3: bttype_pc
    4: bttype_phone
    5: bttype_brick
    6: bttype_unknown
  buttontype:
    0: no_button
    1: up_button
    2: enter_button
    3: down_button
    4: right_button
    5: left_button
    6: back_button
    7: any_button
  conn:
    111: conn_unknown
    117: conn_daisychain
    118: conn_nxt_color
    119: conn_nxt_dumb
    120: conn_nxt_iic
    121: conn_input_dumb
    122: conn_input_uart
    123: conn_output_dumb
    124: conn_output_intelligent
    125: conn_output_tacho
    126: conn_none
    127: conn_error
  data_format:
    0: data_8
    1: data_16
    2: data_32
    3: data_f
    4: data_s
    5: data_a
    7: data_v
    16: data_pct
    18: data_raw
    19: data_si
  del_:
    0: del_none
    1: del_tab
    2: del_space
    3: del_return
    4: del_colon
    5: del_comma
    6: del_linefeed
    7: del_crlf
  encrypt:
    0: encrypt_none
    1: encrypt_wpa2
  filetype:
    0: filetype_unknown
    1: type_folder
    2: type_sound
    3: type_bytecode
    4: type_graphics
    5: type_datalog
    6: type_program
    7: type_text
    16: type_sdcard
    32: type_usbstick
    -1: type_restart_browser
    -2: type_refresh_browser
  fonttype:
    0: normal_font
    1: small_font
    2: large_font
    3: tiny_font
  hwtype:
    1: hw_usb
    2: hw_bt
    3: hw_wifi
  icontype:
    0: normal_icon
    1: small_icon
    2: large_icon
    3: menu_icon
    4: arrow_icon
  ledpattern:
    0: led_black
    1: led_green
    2: led_red
    3: led_orange
    4: led_green_flash
    5: led_red_flash
    6: led_orange_flash
    7: led_green_pulse
    8: led_red_pulse
    9: led_orange_pulse
  l_icon_no:
    0: yes_notsel
    1: yes_sel
    2: no_notsel
    3: no_sel
    4: "off"
    5: wait_vert
    6: wait_horz
    7: to_manual
    8: warnsign
    9: warn_batt
    10: warn_power
    11: warn_temp
    12: no_usbstick
    13: to_execute
    14: to_brick
    15: to_sdcard
    16: to_usbstick
    17: to_bluetooth
    18: to_wifi
    19: to_trash
    20: to_copy
    21: to_file
    22: char_error
    23: copy_error
    24: program_error
    27: warn_memory
  n_icon_no:
    -1: icon_none
    0: icon_run
    1: icon_folder
    2: icon_folder2
    3: icon_usb
    4: icon_sd
    5: icon_sound
    6: icon_image
    7: icon_settings
    8: icon_onoff
    9: icon_search
    10: icon_wifi
    11: icon_connections
    12: icon_add_hidden
    13: icon_trashbin
    14: icon_visibility
    15: icon_key
    16: icon_connect
    17: icon_disconnect
    18: icon_up
    19: icon_down
    20: icon_wait1
    21: icon_wait2
    22: icon_bluetooth
    23: icon_info
    24: icon_text
    27: icon_questionmark
    28: icon_info_file
    29: icon_disc
    30: icon_connected
    31: icon_obp
    32: icon_obd
    33: icon_openfolder
    34: icon_brick1
  objstat:
    16: running
    32: waiting
    64: stopped
    128: halted
  result:
    0: ok
    1: busy
    2: fail
    4: stop
    8: start
  slot:
    0: gui_slot
    1: user_slot
    2: cmd_slot
    3: term_slot
    4: debug_slot
    -1: current_slot
  type_:
    -1: mode_keep
    0: type_keep
    1: type_nxt_touch
    2: type_nxt_light
    3: type_nxt_sound
    4: type_nxt_color
    5: type_nxt_ultrasonic
    6: type_nxt_temperature
    7: type_tacho
    8: type_minitacho
    9: type_newtacho
    16: type_touch
    29: type_color
    30: type_ultrasonic
    32: type_gyro
    33: type_ir
    50: type_third_party_start
    98: type_third_party_end
    99: type_energymeter
    100: type_iic_unknown
    101: type_nxt_test
    123: type_nxt_iic
    124: type_terminal
    125: type_unknown
    126: type_none
    127: type_error

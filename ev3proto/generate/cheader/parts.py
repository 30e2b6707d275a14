"""The hand-written parts of the C header. `$NAME` is a number from the tables, which `build` inserts."""

HEAD = """\
/*
 * The protocol of the LEGO MINDSTORMS EV3 for C (C99 and later) and C++ (C++11 and later). Licence: MIT.
 *
 * Constant frames are arrays, in the macros of the firmware's own source, which fix every encoding. The length field
 * counts what follows it:
 *
 *     static const uint8_t tone[] = {
 *         EV3_HEADER(16, 42, DIRECT_COMMAND_NO_REPLY), EV3_MEMORY(0, 0),
 *         opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)
 *     };
 *
 * Frames whose values are known later are filled by functions, which choose the shortest encodings:
 *
 *     ev3_frame frame;
 *     ev3_begin_direct(&frame, 42, DIRECT_COMMAND_NO_REPLY, 0, 0);
 *     ev3_operation(&frame, opSOUND, TONE);
 *     ev3_integer(&frame, volume);
 *     ev3_integer(&frame, frequency);
 *     ev3_integer(&frame, duration);
 *     size = ev3_end(&frame);
 *     send(socket, frame.bytes, size, 0);
 *
 * Opcodes, CMDs and enumerations have the firmware's names. Where another header defines one of them as a macro, as
 * windows.h does, include this one first.
 *
 * This file is made by ev3proto $VERSION from its tables (ev3proto export c-header): change those, not this.
 */

#ifndef EV3PROTO_H
#define EV3PROTO_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>
"""

FRAMES = """\
/* Frames --------------------------------------------------------------------------------------------------------- */

/*
 * Bytes of the largest frame, its length field included, and of a report on USB. If memory is scarce, define a smaller
 * even number before you include this file: an ev3_frame takes that many bytes and four.
 */
#ifndef EV3_MAX_FRAME
#define EV3_MAX_FRAME $MAX_FRAME
#endif

/* TCP port on which a brick listens */
#define EV3_TCP_PORT $TCP_PORT

/* One byte of a number, which may be negative */
#define EV3_BYTE(value, bits) ((uint8_t)((uint32_t)(value) >> (bits) & 0xFFu))

/* Two bytes of a number, the lower one first */
#define EV3_WORD(value) EV3_BYTE(value, 0), EV3_BYTE(value, 8)

/* The start of every frame: bytes of the whole frame, message counter (0 to $MAX_COUNTER), message type */
#define EV3_HEADER(size, counter, type) EV3_WORD((size) - $LENGTH_FIELD), EV3_WORD(counter), EV3_BYTE(type, 0)

/* The next part of a direct command: bytes of global (0 to $MAX_GLOBALS) and local (0 to $MAX_LOCALS) memory */
#define EV3_MEMORY(globals, locals) EV3_WORD((uint32_t)(locals) << $GLOBAL_BITS | (uint32_t)(globals))
"""

ENCODINGS = """\
/* Encodings of arguments ----------------------------------------------------------------------------------------- */

/* Constants: LC0 holds -32 to 31, the others 1, 2 and 4 bytes, whose lowest number means "not a number" */
#define LC0(value) ((uint8_t)($LC0 | ((uint32_t)(value) & 0x3Fu)))
#define LC1(value) $LC1, EV3_BYTE(value, 0)
#define LC2(value) $LC2, EV3_BYTE(value, 0), EV3_BYTE(value, 8)
#define LC4(value) $LC4, EV3_BYTE(value, 0), EV3_BYTE(value, 8), EV3_BYTE(value, 16), EV3_BYTE(value, 24)

/* A float. In C, use this in arrays inside functions that are not static; elsewhere give LC4 its bits */
#define LCF(value) \\
    $LC4, ev3_float_byte(value, 0), ev3_float_byte(value, 8), ev3_float_byte(value, 16), ev3_float_byte(value, 24)

/* A string: LCS, 'h', 'i', 0. Some senders still start one with the old byte */
#define LCS $LCS
#define LCS_OLD $LCS_OLD

/* Local and global variables: 0 holds the indexes 0 to 31, the others 1, 2 and 4 bytes */
#define LV0(index) ((uint8_t)($LV0 | ((uint32_t)(index) & 0x1Fu)))
#define LV1(index) $LV1, EV3_BYTE(index, 0)
#define LV2(index) $LV2, EV3_BYTE(index, 0), EV3_BYTE(index, 8)
#define LV4(index) $LV4, EV3_BYTE(index, 0), EV3_BYTE(index, 8), EV3_BYTE(index, 16), EV3_BYTE(index, 24)
#define GV0(index) ((uint8_t)($GV0 | ((uint32_t)(index) & 0x1Fu)))
#define GV1(index) $GV1, EV3_BYTE(index, 0)
#define GV2(index) $GV2, EV3_BYTE(index, 0), EV3_BYTE(index, 8)
#define GV4(index) $GV4, EV3_BYTE(index, 0), EV3_BYTE(index, 8), EV3_BYTE(index, 16), EV3_BYTE(index, 24)

/* A label or a short jump, -128 to 127 */
#define LAB1(value) $LAB1, EV3_BYTE(value, 0)

/* A long form that holds a handle to a memory object, or an absolute address: HND(GV1(40)) */
#define HND(...) $HANDLE_BIT | __VA_ARGS__
#define ADR(...) $ADDRESS_BIT | __VA_ARGS__
"""

FUNCTIONS = """\
/* Filling a frame ------------------------------------------------------------------------------------------------ */

/*
 * A frame being filled. Data that does not fit is omitted, and ev3_end then returns 0.
 *
 *   bytes  the frame, to be sent as it is; on USB it is filled up with zeros to $MAX_FRAME bytes
 *   size   number of bytes so far
 *   full   nonzero once something did not fit or could not be encoded
 */
typedef struct {
    uint8_t bytes[EV3_MAX_FRAME];
    uint16_t size;
    uint16_t full;
} ev3_frame;

/* Raw bytes */
static inline void ev3_raw(ev3_frame *frame, const void *bytes, size_t count)
{
    if (count > (size_t)(EV3_MAX_FRAME - frame->size)) {
        frame->full = 1;
        return;
    }
    memcpy(frame->bytes + frame->size, bytes, count);
    frame->size = (uint16_t)(frame->size + count);
}

/* A number of 1, 2 or 4 bytes without anything around it, as system commands have them */
static inline void ev3_number(ev3_frame *frame, uint32_t value, size_t count)
{
    uint8_t bytes[] = {EV3_BYTE(value, 0), EV3_BYTE(value, 8), EV3_BYTE(value, 16), EV3_BYTE(value, 24)};
    ev3_raw(frame, bytes, count);
}

/* A text and its zero without anything around it, as system commands have them; ISO-8859-1 */
static inline void ev3_text(ev3_frame *frame, const char *text)
{
    ev3_raw(frame, text, strlen(text) + 1);
}

static inline void ev3_begin(ev3_frame *frame, uint16_t counter, int type)
{
    memset(frame, 0, sizeof *frame);
    ev3_number(frame, 0, $LENGTH_FIELD);
    ev3_number(frame, counter, 2);
    ev3_number(frame, (uint32_t)type, 1);
}

/* Starts a direct command: a message type and bytes of memory, global 0 to $MAX_GLOBALS, local 0 to $MAX_LOCALS */
static inline void ev3_begin_direct(ev3_frame *frame, uint16_t counter, int type, unsigned globals, unsigned locals)
{
    ev3_begin(frame, counter, type);
    frame->full = globals > $MAX_GLOBALS || locals > $MAX_LOCALS;
    ev3_number(frame, (uint32_t)locals << $GLOBAL_BITS | globals, $MEMORY_SIZE);
}

/* Starts a system command: a message type and the command's number */
static inline void ev3_begin_system(ev3_frame *frame, uint16_t counter, int type, int command)
{
    ev3_begin(frame, counter, type);
    ev3_number(frame, (uint32_t)command, 1);
}

/* A whole number in its shortest encoding */
static inline void ev3_integer(ev3_frame *frame, int32_t value)
{
    const uint32_t bits = (uint32_t)value;
    const uint8_t lc0[] = {LC0(bits)}, lc1[] = {LC1(bits)}, lc2[] = {LC2(bits)}, lc4[] = {LC4(bits)};
    if (-32 <= value && value <= 31)
        ev3_raw(frame, lc0, sizeof lc0);
    else if (-$DATA8_MAX <= value && value <= $DATA8_MAX)
        ev3_raw(frame, lc1, sizeof lc1);
    else if (-$DATA16_MAX <= value && value <= $DATA16_MAX)
        ev3_raw(frame, lc2, sizeof lc2);
    else
        ev3_raw(frame, lc4, sizeof lc4);
}

/* The bits of a float; of all that are not a number, the one that the firmware knows */
static inline uint32_t ev3_float_bits(float value)
{
    uint32_t bits;
    if (value != value)
        return $NAN_FLOAT;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* One byte of a float, for LCF */
static inline uint8_t ev3_float_byte(double value, unsigned bits)
{
    return EV3_BYTE(ev3_float_bits((float)value), bits);
}

/* A float */
static inline void ev3_float(ev3_frame *frame, float value)
{
    const uint8_t lcf[] = {LC4(ev3_float_bits(value))};
    ev3_raw(frame, lcf, sizeof lcf);
}

/* A string */
static inline void ev3_string(ev3_frame *frame, const char *text)
{
    ev3_number(frame, LCS, 1);
    ev3_text(frame, text);
}

/* The local variable at an index, in its shortest encoding */
static inline void ev3_local(ev3_frame *frame, uint32_t index)
{
    const uint8_t lv0[] = {LV0(index)}, lv1[] = {LV1(index)}, lv2[] = {LV2(index)}, lv4[] = {LV4(index)};
    if (index <= 31)
        ev3_raw(frame, lv0, sizeof lv0);
    else if (index <= 0xFF)
        ev3_raw(frame, lv1, sizeof lv1);
    else if (index <= 0xFFFF)
        ev3_raw(frame, lv2, sizeof lv2);
    else
        ev3_raw(frame, lv4, sizeof lv4);
}

/* The same for a global variable, which the reply carries from byte $HEADER_SIZE + index on */
static inline void ev3_global(ev3_frame *frame, uint32_t index)
{
    const uint8_t gv0[] = {GV0(index)}, gv1[] = {GV1(index)}, gv2[] = {GV2(index)}, gv4[] = {GV4(index)};
    if (index <= 31)
        ev3_raw(frame, gv0, sizeof gv0);
    else if (index <= 0xFF)
        ev3_raw(frame, gv1, sizeof gv1);
    else if (index <= 0xFFFF)
        ev3_raw(frame, gv2, sizeof gv2);
    else
        ev3_raw(frame, gv4, sizeof gv4);
}

/* Starts an operation without a CMD */
static inline void ev3_opcode(ev3_frame *frame, int opcode)
{
    ev3_number(frame, (uint32_t)opcode, 1);
}

/* Starts an operation that has a CMD */
static inline void ev3_operation(ev3_frame *frame, int opcode, int command)
{
    ev3_opcode(frame, opcode);
    ev3_integer(frame, command);
}

/* Writes the length field. Returns the bytes of the frame, 0 if something did not fit */
static inline size_t ev3_end(ev3_frame *frame)
{
    const size_t length = (size_t)(frame->size - $LENGTH_FIELD);
    if (frame->full)
        return 0;
    frame->bytes[0] = EV3_BYTE(length, 0);
    frame->bytes[1] = EV3_BYTE(length, 8);
    return frame->size;
}

/* Reading a reply ------------------------------------------------------------------------------------------------ */

/*
 * Readers take the received bytes, from the length field on, and their count. A reader returns 0 if bytes that it needs
 * are missing, and then leaves its value unchanged.
 */

/* Bytes of the frame that starts here, by its length field; 0 if that is missing */
static inline size_t ev3_size(const uint8_t *bytes, size_t count)
{
    return count < $LENGTH_FIELD ? 0 : (size_t)(bytes[0] | bytes[1] << 8) + $LENGTH_FIELD;
}

/* The message counter, which is that of the command */
static inline int ev3_counter(const uint8_t *bytes, size_t count, uint16_t *counter)
{
    if (count < $HEADER_SIZE)
        return 0;
    *counter = (uint16_t)(bytes[2] | bytes[3] << 8);
    return 1;
}

/* The type: DIRECT_REPLY, DIRECT_REPLY_ERROR, SYSTEM_REPLY, ...; -1 if it is missing */
static inline int ev3_type(const uint8_t *bytes, size_t count)
{
    return count < $HEADER_SIZE ? -1 : bytes[$HEADER_SIZE - 1];
}

/* The status of the reply to a system command, such as SYSTEM_SUCCESS; -1 if it is missing */
static inline int ev3_status(const uint8_t *bytes, size_t count)
{
    return count < $HEADER_SIZE + 2 ? -1 : bytes[$HEADER_SIZE + 1];
}

/* The bytes of a value in global memory, from an index on; NULL if the reply does not have them */
static inline const uint8_t *ev3_memory(const uint8_t *bytes, size_t count, size_t index, size_t wanted)
{
    const size_t end = ev3_size(bytes, count) < count ? ev3_size(bytes, count) : count;
    if (end < $HEADER_SIZE || index > end - $HEADER_SIZE || wanted > end - $HEADER_SIZE - index)
        return NULL;
    return bytes + $HEADER_SIZE + index;
}

/* The value that an operation wrote to GV(index): a number of 8, 16 or 32 bits, or a float */
static inline int ev3_reply8(const uint8_t *bytes, size_t count, size_t index, int8_t *value)
{
    const uint8_t *found = ev3_memory(bytes, count, index, 1);
    if (found != NULL)
        memcpy(value, found, 1);
    return found != NULL;
}

static inline int ev3_reply16(const uint8_t *bytes, size_t count, size_t index, int16_t *value)
{
    const uint8_t *found = ev3_memory(bytes, count, index, 2);
    uint16_t bits;
    if (found == NULL)
        return 0;
    bits = (uint16_t)(found[0] | found[1] << 8);
    memcpy(value, &bits, sizeof bits);
    return 1;
}

static inline int ev3_reply32(const uint8_t *bytes, size_t count, size_t index, int32_t *value)
{
    const uint8_t *found = ev3_memory(bytes, count, index, 4);
    uint32_t bits;
    if (found == NULL)
        return 0;
    bits = (uint32_t)found[0] | (uint32_t)found[1] << 8 | (uint32_t)found[2] << 16 | (uint32_t)found[3] << 24;
    memcpy(value, &bits, sizeof bits);
    return 1;
}

static inline int ev3_replyf(const uint8_t *bytes, size_t count, size_t index, float *value)
{
    int32_t bits = 0;
    if (!ev3_reply32(bytes, count, index, &bits))
        return 0;
    memcpy(value, &bits, sizeof bits);
    return 1;
}
"""

TAIL = """\
#endif /* EV3PROTO_H */
"""

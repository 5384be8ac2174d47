/* SkinWire 1 for devices, in one C99 header: what a skin says becomes frames of bytes in a buffer of yours, and what
 * the host asks is read from the bytes that arrive. README.md beside this file is the protocol, skinwire.proto lists
 * its fields and their units, build_a_cell.md leads from an accelerometer to a skin. Names here are those of the
 * .proto.
 *
 *   uint8_t buffer[SKINWIRE_FRAME_SIZE(SKINWIRE_RAW_BODY(7, 5))];
 *   skinwire_frame frame = skinwire_frame_in(buffer, sizeof buffer, SKINWIRE_COBS);
 *   skinwire_samples samples = {0};
 *   samples.has_sequence = true, samples.sequence = sent;
 *   samples.time_us = time_us, samples.period_us = 10000;
 *   samples.cells = cells, samples.cell_count = 7;
 *   samples.raw_lsb = readings, samples.tick_count = 5;
 *   if (skinwire_put_samples(&frame, &samples) > 0) uart_write(frame.bytes, frame.size);
 *
 *   uint8_t input[SKINWIRE_COMMAND_SIZE];
 *   skinwire_receiver receiver = skinwire_receiver_in(input, sizeof input, SKINWIRE_COBS);
 *   skinwire_command command;
 *   while (uart_read(&byte))
 *     if (skinwire_receive(&receiver, byte, &command) == SKINWIRE_COMMAND) answer(&command);
 *
 * Memory. There is no malloc, no global and no static variable; the only constant data is a table of 64 bytes. The
 * deepest call takes less than 300 bytes of stack on a Cortex-M3. A frame is written once, from the front to the back,
 * in its final form: the buffer can be given to a DMA as it is, and a second one is not needed.
 *
 * Reentrancy. A function touches nothing but its arguments. Two frames, or a frame and a receiver, may be used at the
 * same time from an interrupt and from the main loop; one and the same frame or receiver may not.
 *
 * Demands. Nothing but <stdbool.h>, <stddef.h> and <stdint.h> is included. An int has at least 32 bits, as on every
 * Cortex-M. A float has to be IEEE 754 single; its bits are copied and floats compared; only skinwire_average_take()
 * computes with them, and no double is used. The compiler may call memcpy and memset, as it may in any C program. The
 * header may be included by several sources and by C++; all functions are static inline, and those that are not called
 * take no flash.
 *
 * Texts are UTF-8 and end with a 0; NULL is the empty text. Structs may be set to zero as a whole: every field of value
 * zero means "not there", "not known" or "no".
 */
#ifndef SKINWIRE_H
#define SKINWIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

enum {
  SKINWIRE_MAJOR = 1,
  SKINWIRE_MINOR = 1,
  SKINWIRE_MAX_BODY = 1 << 20,  /* bytes of a body that a host takes */
  SKINWIRE_MAX_DATAGRAM = 1200, /* bytes of a body in a UDP datagram */
  SKINWIRE_MAX_TEXT = 1000,     /* bytes of a text, without the 0 at its end */
  SKINWIRE_MAX_MODEL = 65536,   /* bytes of Hello.cell_model */
  SKINWIRE_MAX_CELLS = 1000000, /* cells of a skin */
  SKINWIRE_MAX_JOINTS = 10000,  /* joints of a robot */
  SKINWIRE_MAX_AVERAGE = 65535, /* samples in a skinwire_average */
  SKINWIRE_COMMAND_SIZE = 64    /* bytes of a receiver's buffer that are enough for every command there is */
};

/* Sizes of buffers, for arrays, in bytes: sizeof(uint8_t) makes them a size_t without a cast. The body of a message is
 * what stands between the framing's own bytes. */
/* A frame with a body of so many bytes, in any framing. */
#define SKINWIRE_FRAME_SIZE(body) (sizeof(uint8_t) * (body) + sizeof(uint8_t) * (body) / 254 + 4)
/* The body of Samples with raw_lsb of 16 bits, at worst. */
#define SKINWIRE_RAW_BODY(cells, ticks) (48 + sizeof(uint8_t) * (cells) * (5 + 9 * (ticks)))
/* The body of Samples with mean_g, variance_g2 and count, at worst. */
#define SKINWIRE_MEANS_BODY(cells) (56 + sizeof(uint8_t) * (cells)*34)

typedef enum {
  SKINWIRE_COBS,    /* serial ports: COBS of the body, then 0x00 */
  SKINWIRE_LENGTH,  /* TCP: length of the body, 4 bytes little-endian, then the body */
  SKINWIRE_DATAGRAM /* UDP: the body alone, at most SKINWIRE_MAX_DATAGRAM bytes */
} skinwire_framing;

/* Why a message was not put into a frame. */
typedef enum {
  SKINWIRE_FINE,
  SKINWIRE_NO_ROOM,      /* the buffer is too small, or the message larger than a host takes */
  SKINWIRE_WRONG_VALUE,  /* a number is not finite or out of its range, or something that must be there is not */
  SKINWIRE_WRONG_LENGTH, /* numbers of cells, ticks and readings don't fit together */
  SKINWIRE_WRONG_TEXT    /* a text is too long, or no UTF-8 */
} skinwire_fault;

/* A frame, in a buffer that belongs to you. Each message that is put takes the place of the one before. */
typedef struct {
  uint8_t* bytes;
  size_t capacity; /* of the buffer */
  size_t size;     /* bytes to send; 0 if the last message was not put */
  skinwire_fault fault;
  skinwire_framing framing;
  /* Private, from here on. */
  size_t body;    /* bytes of the body so far */
  size_t code_at; /* of the COBS block that is being filled */
  uint32_t crc;
} skinwire_frame;

/* ---- the messages of a device */

typedef struct {
  const char* device;     /* a name for people */
  const char* cell_model; /* "hex-bma150", or the JSON text of a cell model; must be there */
  bool can_light_cells;
  bool can_turn;
  float rate_hz;
  uint32_t stream; /* another number after each reset: a boot counter, or random */
} skinwire_hello;

typedef struct {
  uint32_t port;      /* ports are numbered from 1 on */
  uint32_t cell;      /* the neighbour; 0: nothing is connected */
  uint32_t cell_port; /* the neighbour's port; 0: not known */
} skinwire_port;

typedef struct {
  uint32_t id; /* at least 1 */
  const char* body_part;
  const skinwire_port* ports;
  size_t port_count;
} skinwire_cell;

typedef struct {
  uint32_t id; /* another number each time the topology changed */
  uint32_t part;
  uint32_t parts; /* 0 means 1 */
  const skinwire_cell* cells;
  size_t cell_count; /* of this part */
} skinwire_topology;

/* With cells: exactly one of raw_lsb, raw_lsb_32, acceleration_g and mean_g is not NULL. Values follow tick by tick,
 * cell by cell, x y z: 3 * cell_count * tick_count of them. Without cells: temperatures alone. */
typedef struct {
  bool has_sequence;
  uint64_t sequence;     /* samples sent before this message: one cell at one tick is one */
  uint64_t time_us;      /* of the first tick, by the device's clock; of means: of their last sample */
  uint32_t period_us;    /* from tick to tick; needed where there are several */
  const uint32_t* cells; /* IDs, each once */
  size_t cell_count;
  size_t tick_count; /* 1 with mean_g */
  const int16_t* raw_lsb;
  const int32_t* raw_lsb_32; /* the same, for accelerometers of more than 16 bits */
  const float* acceleration_g;
  const float* mean_g;
  const float* variance_g2; /* with mean_g: variance of one sample, cell by cell, x y z */
  const uint32_t* count;    /* with mean_g: samples in the mean of each cell */
  const uint32_t* temperature_cells;
  const float* temperature_c;
  size_t temperature_count;
} skinwire_samples;

typedef struct {
  const char* text;
  bool exploring;
  uint64_t samples_sent;
  uint64_t samples_dropped;
} skinwire_status;

/* Answer to a command: done; or working on it, which is said again at least once a second; or neither, and why not.
 * Over UDP a command comes again until it is done or not. If it is the one that is being done, say working again and do
 * not begin anew. */
typedef struct {
  uint32_t command; /* its number */
  bool done;
  bool working;
  const char* text;
} skinwire_ack;

typedef struct {
  uint64_t time_us;
  const char* const* names; /* NULL: those of the message before */
  const float* position;    /* rad or m */
  size_t joint_count;
} skinwire_joints;

/* ---- the commands of a host */

typedef enum {
  SKINWIRE_UNKNOWN = 0, /* of a later minor version: answer that it is not done */
  SKINWIRE_SET_RATE = 2,
  SKINWIRE_SET_LED = 3,
  SKINWIRE_TURN_TO = 4,
  SKINWIRE_EXPLORE_AGAIN = 5,
  SKINWIRE_DESCRIBE = 6 /* answer with Hello, and with Topology unless the host has it; the only one without an Ack */
} skinwire_request;

typedef struct {
  float rate_hz; /* above 0 */
} skinwire_set_rate;

typedef struct {
  uint32_t cell;
  uint8_t red, green, blue;
} skinwire_set_led;

typedef struct {
  uint32_t cell;
  float up[3]; /* in the frame of the cell; finite, and of length 1 if the host keeps the protocol */
} skinwire_turn_to;

typedef struct {
  bool has_known_topology;
  uint32_t known_topology; /* the id that the host has */
} skinwire_describe;

typedef struct {
  uint32_t number; /* for the Ack; 0 of Describe, which has none */
  skinwire_request request;
  union {
    skinwire_set_rate set_rate;
    skinwire_set_led set_led;
    skinwire_turn_to turn_to;
    skinwire_describe describe;
  } of;
} skinwire_command;

/* What a byte that arrived has brought. */
typedef enum {
  SKINWIRE_NOTHING, /* so far */
  SKINWIRE_COMMAND, /* a command is there */
  SKINWIRE_SKIPPED, /* a whole frame that is no command, or of another major version: leave it out */
  SKINWIRE_BROKEN,  /* a frame that is too long for the buffer, or broken; reading goes on with the next */
  SKINWIRE_LOST /* only SKINWIRE_LENGTH: frames can't be found any more; close the connection, make a new receiver */
} skinwire_event;

typedef struct {
  uint8_t* bytes;
  size_t capacity;
  skinwire_framing framing;
  /* Private, from here on. */
  size_t size;    /* bytes of the body so far, those that did not fit too */
  uint32_t left;  /* bytes of the COBS block, or of the body, that are still to come */
  uint8_t head;   /* the COBS block's code, or how many bytes of the length are there */
  bool is_broken; /* bytes were no COBS */
  bool is_lost;
} skinwire_receiver;

/* ---- floats as bits; byte by byte, which is allowed in C and in C++ */

static inline uint32_t skinwire_bits_of_float(float value) {
  uint32_t bits = 0;
  const unsigned char* from = (const unsigned char*)&value;
  unsigned char* to = (unsigned char*)&bits;
  for (size_t k = 0; k < sizeof bits; ++k) to[k] = from[k];
  return bits;
}

static inline float skinwire_float_of_bits(uint32_t bits) {
  float value = 0;
  const unsigned char* from = (const unsigned char*)&bits;
  unsigned char* to = (unsigned char*)&value;
  for (size_t k = 0; k < sizeof bits; ++k) to[k] = from[k];
  return value;
}

static inline bool skinwire_is_finite(float value) {
  return (skinwire_bits_of_float(value) & 0x7F800000u) != 0x7F800000u;
}

/* IEEE 754 single to double. */
static inline uint64_t skinwire_double_of_float(float value) {
  const uint32_t bits = skinwire_bits_of_float(value);
  const uint64_t sign = (uint64_t)(bits >> 31) << 63;
  uint32_t exponent = bits >> 23 & 0xFFu;
  uint32_t fraction = bits & 0x7FFFFFu;
  if (exponent == 0xFFu) return sign | (uint64_t)0x7FF << 52 | (uint64_t)fraction << 29;
  if (exponent == 0) {
    if (fraction == 0) return sign;
    exponent = 1; /* a subnormal number, which is none as a double */
    while ((fraction & 0x800000u) == 0) {
      fraction <<= 1;
      --exponent; /* may wrap around; the sum below wraps back */
    }
    fraction &= 0x7FFFFFu;
  }
  return sign | (uint64_t)(uint32_t)(exponent + (1023u - 127u)) << 52 | (uint64_t)fraction << 29;
}

/* IEEE 754 double to single, rounded to nearest, ties to even. */
static inline float skinwire_float_of_double(uint64_t bits) {
  const uint32_t sign = (uint32_t)(bits >> 63) << 31;
  const uint32_t exponent = (uint32_t)(bits >> 52) & 0x7FFu;
  const uint64_t fraction = bits & (((uint64_t)1 << 52) - 1);
  if (exponent == 0x7FFu) return skinwire_float_of_bits(sign | 0x7F800000u | (fraction != 0 ? 0x400000u : 0));
  if (exponent > 1023 + 127) return skinwire_float_of_bits(sign | 0x7F800000u);
  if (exponent < 1023 - 150) return skinwire_float_of_bits(sign);
  uint64_t kept = fraction | (uint64_t)1 << 52;
  uint32_t result = 0;
  unsigned drop = 29; /* bits that a single does not have */
  if (exponent > 1023 - 127) {
    result = (exponent - (1023 - 127)) << 23;
    kept = fraction;
  } else {
    drop += 1023 - 126 - exponent; /* subnormal */
  }
  const uint64_t half = (uint64_t)1 << (drop - 1);
  const uint64_t rest = kept & (((uint64_t)1 << drop) - 1);
  result += (uint32_t)(kept >> drop);
  /* A carry runs into the exponent, as it should. */
  if (rest > half || (rest == half && (result & 1u) != 0)) ++result;
  return skinwire_float_of_bits(sign | result);
}

/* ---- CRC-32C */

/* The CRC of bytes so far with one more. Begin with 0xFFFFFFFF; the CRC is the complement of the last value. */
static inline uint32_t skinwire_crc_with(uint32_t crc, uint8_t byte) {
  static const uint32_t table[16] = {0x00000000u, 0x105EC76Fu, 0x20BD8EDEu, 0x30E349B1u, 0x417B1DBCu, 0x5125DAD3u,
                                     0x61C69362u, 0x7198540Du, 0x82F63B78u, 0x92A8FC17u, 0xA24BB5A6u, 0xB21572C9u,
                                     0xC38D26C4u, 0xD3D3E1ABu, 0xE330A81Au, 0xF36E6F75u};
  crc ^= byte;
  crc = crc >> 4 ^ table[crc & 15u];
  return crc >> 4 ^ table[crc & 15u];
}

static inline uint32_t skinwire_crc32c(const uint8_t* bytes, size_t size) {
  uint32_t crc = 0xFFFFFFFFu;
  for (size_t k = 0; k < size; ++k) crc = skinwire_crc_with(crc, bytes[k]);
  return ~crc;
}

/* ---- writing a frame (private) */

static inline void skinwire_store(skinwire_frame* frame, uint8_t byte) {
  if (frame->size < frame->capacity) {
    frame->bytes[frame->size++] = byte;
  } else if (frame->fault == SKINWIRE_FINE) {
    frame->fault = SKINWIRE_NO_ROOM;
  }
}

/* A COBS block begins: its first byte will be the distance to its end. */
static inline void skinwire_open_block(skinwire_frame* frame) {
  frame->code_at = frame->size;
  skinwire_store(frame, 0xFF);
}

static inline void skinwire_close_block(skinwire_frame* frame) {
  if (frame->fault == SKINWIRE_FINE) frame->bytes[frame->code_at] = (uint8_t)(frame->size - frame->code_at);
}

/* A byte of the body, in the framing. */
static inline void skinwire_write(skinwire_frame* frame, uint8_t byte) {
  ++frame->body;
  if (frame->framing != SKINWIRE_COBS) {
    skinwire_store(frame, byte);
    return;
  }
  /* A full block ends without a zero. It stays open until there is another byte, for it may be the last. */
  if (frame->size - frame->code_at == 255) skinwire_open_block(frame);
  if (byte != 0) {
    skinwire_store(frame, byte);
    return;
  }
  skinwire_close_block(frame);
  skinwire_open_block(frame);
}

static inline void skinwire_byte(skinwire_frame* frame, uint8_t byte) {
  frame->crc = skinwire_crc_with(frame->crc, byte);
  skinwire_write(frame, byte);
}

static inline void skinwire_refuse(skinwire_frame* frame, skinwire_fault why) {
  if (frame->fault == SKINWIRE_FINE) frame->fault = why;
}

static inline void skinwire_begin(skinwire_frame* frame, uint8_t type) {
  frame->size = 0;
  frame->body = 0;
  frame->fault = SKINWIRE_FINE;
  frame->crc = 0xFFFFFFFFu;
  frame->code_at = 0;
  if (frame->framing == SKINWIRE_COBS) skinwire_open_block(frame);
  if (frame->framing == SKINWIRE_LENGTH) {
    for (int k = 0; k < 4; ++k) skinwire_store(frame, 0); /* known at the end */
  }
  skinwire_byte(frame, SKINWIRE_MAJOR);
  skinwire_byte(frame, type);
}

static inline size_t skinwire_end(skinwire_frame* frame) {
  const uint32_t crc = ~frame->crc;
  for (int k = 0; k < 4; ++k) skinwire_write(frame, (uint8_t)(crc >> 8 * k));
  if (frame->body > (frame->framing == SKINWIRE_DATAGRAM ? (size_t)SKINWIRE_MAX_DATAGRAM : (size_t)SKINWIRE_MAX_BODY)) {
    skinwire_refuse(frame, SKINWIRE_NO_ROOM);
  }
  if (frame->framing == SKINWIRE_COBS) {
    skinwire_close_block(frame);
    skinwire_store(frame, 0);
  }
  if (frame->framing == SKINWIRE_LENGTH && frame->fault == SKINWIRE_FINE) {
    for (int k = 0; k < 4; ++k) frame->bytes[k] = (uint8_t)((uint32_t)frame->body >> 8 * k);
  }
  if (frame->fault != SKINWIRE_FINE) frame->size = 0;
  return frame->size;
}

/* ---- protobuf (private): a field is its number and kind, then its value; 0 is left out, as proto3 has it */

static inline size_t skinwire_varint_size(uint64_t value) {
  size_t size = 1;
  for (; value >= 0x80; value >>= 7) ++size;
  return size;
}

static inline void skinwire_varint(skinwire_frame* frame, uint64_t value) {
  for (; value >= 0x80; value >>= 7) skinwire_byte(frame, (uint8_t)(value | 0x80));
  skinwire_byte(frame, (uint8_t)value);
}

static inline void skinwire_little_endian(skinwire_frame* frame, uint64_t value, int size) {
  for (int k = 0; k < size; ++k) skinwire_byte(frame, (uint8_t)(value >> 8 * k));
}

static inline void skinwire_number(skinwire_frame* frame, unsigned field, uint64_t value) {
  if (value == 0) return;
  skinwire_varint(frame, field << 3 | 0);
  skinwire_varint(frame, value);
}

static inline size_t skinwire_number_size(uint64_t value) { return value == 0 ? 0 : 1 + skinwire_varint_size(value); }

/* The head of a field that is so many bytes long; they follow. */
static inline void skinwire_length(skinwire_frame* frame, unsigned field, size_t size) {
  skinwire_varint(frame, field << 3 | 2);
  skinwire_varint(frame, size);
}

static inline void skinwire_double(skinwire_frame* frame, unsigned field, float value) {
  if (value == 0) return;
  skinwire_varint(frame, field << 3 | 1);
  skinwire_little_endian(frame, skinwire_double_of_float(value), 8);
}

static inline size_t skinwire_text_size(const char* text) {
  size_t size = 0;
  if (text != NULL) {
    while (text[size] != 0) ++size;
  }
  return size;
}

/* As the Unicode standard has it: no overlong forms, no surrogates, nothing above U+10FFFF. A host refuses the rest. */
static inline bool skinwire_is_utf8(const char* text) {
  const uint8_t* at = (const uint8_t*)text;
  while (at != NULL && *at != 0) {
    const uint8_t first = *at++;
    if (first < 0x80) continue;
    const int more = first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    if (first < 0xC2 || first > 0xF4) return false;
    if ((first == 0xE0 && *at < 0xA0) || (first == 0xED && *at > 0x9F)) return false;
    if ((first == 0xF0 && *at < 0x90) || (first == 0xF4 && *at > 0x8F)) return false;
    for (int k = 0; k < more; ++k) {
      if ((*at++ & 0xC0) != 0x80) return false; /* also at the end of the text */
    }
  }
  return true;
}

static inline void skinwire_text(skinwire_frame* frame, unsigned field, const char* text, size_t most) {
  const size_t size = skinwire_text_size(text);
  if (size == 0) return;
  if (size > most || !skinwire_is_utf8(text)) skinwire_refuse(frame, SKINWIRE_WRONG_TEXT);
  if (frame->fault != SKINWIRE_FINE) return;
  skinwire_length(frame, field, size);
  for (size_t k = 0; k < size; ++k) skinwire_byte(frame, (uint8_t)text[k]);
}

static inline void skinwire_packed_numbers(skinwire_frame* frame, unsigned field, const uint32_t* values,
                                           size_t count) {
  size_t size = 0;
  if (count == 0) return;
  for (size_t k = 0; k < count; ++k) size += skinwire_varint_size(values[k]);
  skinwire_length(frame, field, size);
  for (size_t k = 0; k < count; ++k) skinwire_varint(frame, values[k]);
}

static inline void skinwire_packed_floats(skinwire_frame* frame, unsigned field, const float* values, size_t count) {
  if (count == 0) return;
  skinwire_length(frame, field, 4 * count);
  for (size_t k = 0; k < count; ++k) {
    if (!skinwire_is_finite(values[k])) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
    skinwire_little_endian(frame, skinwire_bits_of_float(values[k]), 4);
  }
}

/* 0, -1, 1, -2 ... become 0, 1, 2, 3 ... */
static inline uint32_t skinwire_zigzag(int32_t value) { return (uint32_t)value << 1 ^ (value < 0 ? 0xFFFFFFFFu : 0u); }

static inline uint32_t skinwire_raw_value(const skinwire_samples* samples, size_t k) {
  return skinwire_zigzag(samples->raw_lsb != NULL ? samples->raw_lsb[k] : samples->raw_lsb_32[k]);
}

static inline size_t skinwire_port_size(const skinwire_port* port) {
  return skinwire_number_size(port->port) + skinwire_number_size(port->cell) + skinwire_number_size(port->cell_port);
}

static inline size_t skinwire_cell_size(const skinwire_cell* cell) {
  const size_t text = skinwire_text_size(cell->body_part);
  size_t size = skinwire_number_size(cell->id) + (text == 0 ? 0 : 1 + skinwire_varint_size(text) + text);
  for (size_t k = 0; k < cell->port_count; ++k) size += 2 + skinwire_port_size(&cell->ports[k]);
  return size;
}

/* ---- what you call: frames. Each returns frame->size, the bytes to send, or 0 with frame->fault set. */

static inline skinwire_frame skinwire_frame_in(uint8_t* bytes, size_t capacity, skinwire_framing framing) {
  skinwire_frame frame;
  frame.bytes = bytes;
  frame.capacity = capacity;
  frame.size = 0;
  frame.fault = SKINWIRE_FINE;
  frame.framing = framing;
  frame.body = 0;
  frame.code_at = 0;
  frame.crc = 0;
  return frame;
}

/* First of all, after Describe, and whenever something in it changed. */
static inline size_t skinwire_put_hello(skinwire_frame* frame, const skinwire_hello* hello) {
  skinwire_begin(frame, 1);
  if (skinwire_text_size(hello->cell_model) == 0) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  if (!(hello->rate_hz >= 0 && hello->rate_hz <= 1000000)) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  skinwire_number(frame, 1, SKINWIRE_MINOR);
  skinwire_text(frame, 2, hello->device, SKINWIRE_MAX_TEXT);
  skinwire_text(frame, 3, hello->cell_model, SKINWIRE_MAX_MODEL);
  skinwire_number(frame, 4, hello->can_light_cells);
  skinwire_number(frame, 5, hello->can_turn);
  skinwire_double(frame, 6, hello->rate_hz);
  skinwire_number(frame, 7, hello->stream);
  return skinwire_end(frame);
}

/* After Hello. A topology that does not fit your buffer goes in parts: see skinwire_cells_that_fit(). */
static inline size_t skinwire_put_topology(skinwire_frame* frame, const skinwire_topology* topology) {
  const uint32_t parts = topology->parts == 0 ? 1 : topology->parts;
  skinwire_begin(frame, 2);
  if (topology->part >= parts || parts > SKINWIRE_MAX_CELLS) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  if (topology->cell_count > SKINWIRE_MAX_CELLS) skinwire_refuse(frame, SKINWIRE_WRONG_LENGTH);
  skinwire_number(frame, 1, topology->id);
  skinwire_number(frame, 2, topology->part);
  skinwire_number(frame, 3, parts);
  for (size_t k = 0; k < topology->cell_count && frame->fault == SKINWIRE_FINE; ++k) {
    const skinwire_cell* cell = &topology->cells[k];
    if (cell->id == 0) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
    skinwire_length(frame, 4, skinwire_cell_size(cell));
    skinwire_number(frame, 1, cell->id);
    skinwire_text(frame, 2, cell->body_part, SKINWIRE_MAX_TEXT);
    for (size_t p = 0; p < cell->port_count; ++p) {
      skinwire_length(frame, 3, skinwire_port_size(&cell->ports[p]));
      skinwire_number(frame, 1, cell->ports[p].port);
      skinwire_number(frame, 2, cell->ports[p].cell);
      skinwire_number(frame, 3, cell->ports[p].cell_port);
    }
  }
  return skinwire_end(frame);
}

/* How many of these cells, from the first on, a Topology in this frame's buffer can hold, whatever its id and parts
 * are. 0 if there are none, or the buffer is too small for the first. To send a topology in parts, walk through the
 * cells twice: the first time to count the parts, the second time to send them. */
static inline size_t skinwire_cells_that_fit(const skinwire_frame* frame, const skinwire_cell* cells, size_t count) {
  const size_t most = frame->framing == SKINWIRE_DATAGRAM && frame->capacity > SKINWIRE_MAX_DATAGRAM
                          ? (size_t)SKINWIRE_MAX_DATAGRAM
                          : frame->capacity;
  size_t body = 2 + 3 * 6 + 4;
  size_t fitting = 0;
  for (; fitting < count; ++fitting) {
    const size_t size = skinwire_cell_size(&cells[fitting]);
    body += 1 + skinwire_varint_size(size) + size;
    if (body > SKINWIRE_MAX_BODY) break;
    if ((frame->framing == SKINWIRE_DATAGRAM ? body : SKINWIRE_FRAME_SIZE(body)) > most) break;
  }
  return fitting;
}

/* Readings. `sequence` counts the samples of messages that could not be sent too: the gap says that they are lost. */
static inline size_t skinwire_put_samples(skinwire_frame* frame, const skinwire_samples* samples) {
  const uint64_t max_time = (uint64_t)1 << 53;
  const bool is_raw = samples->raw_lsb != NULL || samples->raw_lsb_32 != NULL;
  const int kinds = (samples->raw_lsb != NULL) + (samples->raw_lsb_32 != NULL) + (samples->acceleration_g != NULL) +
                    (samples->mean_g != NULL);
  const size_t cells = samples->cell_count;
  const size_t ticks = samples->tick_count;
  const size_t values = 3 * cells * ticks;
  skinwire_begin(frame, 3);
  if (cells == 0 ? kinds != 0 : kinds != 1 || ticks == 0) skinwire_refuse(frame, SKINWIRE_WRONG_LENGTH);
  if ((cells > 0 && samples->cells == NULL) ||
      (samples->temperature_count > 0 && (samples->temperature_cells == NULL || samples->temperature_c == NULL))) {
    skinwire_refuse(frame, SKINWIRE_WRONG_LENGTH);
  }
  /* Every number takes a byte at least. So nothing overflows below. */
  if (cells > SKINWIRE_MAX_BODY || samples->temperature_count > SKINWIRE_MAX_BODY ||
      (cells > 0 && ticks > SKINWIRE_MAX_BODY / cells)) {
    skinwire_refuse(frame, SKINWIRE_NO_ROOM);
  }
  if (samples->mean_g != NULL ? ticks != 1 || samples->variance_g2 == NULL || samples->count == NULL
                              : samples->variance_g2 != NULL || samples->count != NULL) {
    skinwire_refuse(frame, SKINWIRE_WRONG_LENGTH);
  }
  if (samples->time_us > max_time || (samples->has_sequence && samples->sequence > max_time)) {
    skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  } else if (cells > 0 && ticks > 1) {
    const uint64_t span_us = (uint64_t)(ticks - 1) * samples->period_us;
    if (samples->period_us == 0 || span_us > max_time - samples->time_us) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  }
  if (frame->fault != SKINWIRE_FINE) return skinwire_end(frame);

  if (samples->has_sequence) { /* a sequence of 0 is said */
    skinwire_varint(frame, 1 << 3 | 0);
    skinwire_varint(frame, samples->sequence);
  }
  skinwire_number(frame, 2, samples->time_us);
  skinwire_number(frame, 3, samples->period_us);
  skinwire_packed_numbers(frame, 4, samples->cells, cells);
  if (is_raw) {
    size_t size = 0;
    for (size_t k = 0; k < values; ++k) size += skinwire_varint_size(skinwire_raw_value(samples, k));
    skinwire_length(frame, 5, size);
    for (size_t k = 0; k < values; ++k) skinwire_varint(frame, skinwire_raw_value(samples, k));
  }
  if (samples->acceleration_g != NULL) skinwire_packed_floats(frame, 6, samples->acceleration_g, values);
  if (samples->mean_g != NULL) {
    for (size_t k = 0; k < values; ++k) {
      if (samples->variance_g2[k] < 0) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
    }
    for (size_t k = 0; k < cells; ++k) {
      if (samples->count[k] == 0) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
    }
    skinwire_packed_floats(frame, 7, samples->mean_g, values);
    skinwire_packed_floats(frame, 8, samples->variance_g2, values);
    skinwire_packed_numbers(frame, 9, samples->count, cells);
  }
  skinwire_packed_numbers(frame, 10, samples->temperature_cells, samples->temperature_count);
  skinwire_packed_floats(frame, 11, samples->temperature_c, samples->temperature_count);
  return skinwire_end(frame);
}

/* Twice a second while no samples are sent. */
static inline size_t skinwire_put_status(skinwire_frame* frame, const skinwire_status* status) {
  skinwire_begin(frame, 4);
  skinwire_text(frame, 1, status->text, SKINWIRE_MAX_TEXT);
  skinwire_number(frame, 2, status->exploring);
  skinwire_number(frame, 3, status->samples_sent);
  skinwire_number(frame, 4, status->samples_dropped);
  return skinwire_end(frame);
}

static inline size_t skinwire_put_ack(skinwire_frame* frame, const skinwire_ack* ack) {
  skinwire_begin(frame, 6);
  if (ack->done && ack->working) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  skinwire_number(frame, 1, ack->command);
  skinwire_number(frame, 2, ack->done);
  skinwire_text(frame, 3, ack->text, SKINWIRE_MAX_TEXT);
  skinwire_number(frame, 4, ack->working);
  return skinwire_end(frame);
}

/* Of a robot that wears the skin: where its joints stand, at most ten times a second. */
static inline size_t skinwire_put_joints(skinwire_frame* frame, const skinwire_joints* joints) {
  const size_t count = joints->joint_count;
  skinwire_begin(frame, 7);
  if (joints->time_us > (uint64_t)1 << 53) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
  if (count == 0 || count > SKINWIRE_MAX_JOINTS) skinwire_refuse(frame, SKINWIRE_WRONG_LENGTH);
  if (frame->fault != SKINWIRE_FINE) return skinwire_end(frame);
  skinwire_number(frame, 1, joints->time_us);
  for (size_t k = 0; k < count && joints->names != NULL; ++k) {
    if (skinwire_text_size(joints->names[k]) == 0) skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
    skinwire_text(frame, 2, joints->names[k], SKINWIRE_MAX_TEXT);
  }
  skinwire_length(frame, 3, 8 * count);
  for (size_t k = 0; k < count; ++k) {
    if (!(joints->position[k] >= -1000000 && joints->position[k] <= 1000000)) {
      skinwire_refuse(frame, SKINWIRE_WRONG_VALUE);
    }
    skinwire_little_endian(frame, skinwire_double_of_float(joints->position[k]), 8);
  }
  return skinwire_end(frame);
}

/* ---- reading a command (private). Pointers never leave the body, whatever lengths it claims. */

typedef struct {
  const uint8_t* at;
  const uint8_t* end;
  bool failed;
} skinwire_reader;

static inline uint64_t skinwire_read_varint(skinwire_reader* reader) {
  uint64_t value = 0;
  for (unsigned shift = 0; reader->at < reader->end && shift < 64; shift += 7) {
    const uint8_t byte = *reader->at++;
    if (shift == 63 && byte > 1) break; /* more than 64 bits */
    value |= (uint64_t)(byte & 0x7F) << shift;
    if (byte < 0x80) return value;
  }
  reader->failed = true;
  return 0;
}

static inline uint64_t skinwire_read_little_endian(skinwire_reader* reader, unsigned size) {
  uint64_t value = 0;
  if ((size_t)(reader->end - reader->at) < size) {
    reader->failed = true;
    return 0;
  }
  for (unsigned k = 0; k < size; ++k) value |= (uint64_t)*reader->at++ << 8 * k;
  return value;
}

/* What has a length: a reader of so many bytes, which are passed over. */
static inline skinwire_reader skinwire_read_bytes(skinwire_reader* reader) {
  const uint64_t size = skinwire_read_varint(reader);
  skinwire_reader inner;
  if (size > (uint64_t)(reader->end - reader->at)) reader->failed = true;
  inner.at = reader->at;
  inner.end = reader->failed ? reader->at : reader->at + (size_t)size;
  inner.failed = reader->failed;
  reader->at = inner.end;
  return inner;
}

/* The number and kind of the next field; false at the end, and if there is none. */
static inline bool skinwire_read_key(skinwire_reader* reader, uint32_t* field, uint32_t* kind) {
  if (reader->failed || reader->at == reader->end) return false;
  const uint64_t key = skinwire_read_varint(reader);
  if (key > 0xFFFFFFFFu || key >> 3 == 0) reader->failed = true;
  *field = (uint32_t)(key >> 3);
  *kind = (uint32_t)(key & 7u);
  return !reader->failed;
}

/* A field that is not known. Groups, which nobody has used for long, count as broken. */
static inline void skinwire_skip_field(skinwire_reader* reader, uint32_t kind) {
  if (kind == 0) {
    skinwire_read_varint(reader);
  } else if (kind == 1) {
    skinwire_read_little_endian(reader, 8);
  } else if (kind == 2) {
    skinwire_read_bytes(reader);
  } else if (kind == 5) {
    skinwire_read_little_endian(reader, 4);
  } else {
    reader->failed = true;
  }
}

static inline bool skinwire_read_set_rate(skinwire_reader reader, uint64_t* rate) {
  uint32_t field = 0, kind = 0;
  while (skinwire_read_key(&reader, &field, &kind)) {
    if (field == 1 && kind == 1) {
      *rate = skinwire_read_little_endian(&reader, 8);
    } else {
      skinwire_skip_field(&reader, kind);
    }
  }
  return !reader.failed;
}

static inline bool skinwire_read_set_led(skinwire_reader reader, uint32_t led[4]) {
  uint32_t field = 0, kind = 0;
  while (skinwire_read_key(&reader, &field, &kind)) {
    if (field <= 4 && kind == 0) {
      led[field - 1] = (uint32_t)skinwire_read_varint(&reader);
    } else {
      skinwire_skip_field(&reader, kind);
    }
  }
  return !reader.failed;
}

/* `ups` counts the numbers of `up`; the first three are kept. */
static inline bool skinwire_read_turn_to(skinwire_reader reader, skinwire_turn_to* turn, size_t* ups) {
  uint32_t field = 0, kind = 0;
  while (skinwire_read_key(&reader, &field, &kind)) {
    if (field == 1 && kind == 0) {
      turn->cell = (uint32_t)skinwire_read_varint(&reader);
    } else if (field == 2 && (kind == 1 || kind == 2)) {
      skinwire_reader numbers = reader; /* packed, or one by itself */
      if (kind == 2) {
        numbers = skinwire_read_bytes(&reader);
      } else if ((size_t)(reader.end - reader.at) >= 8) {
        numbers.end = reader.at += 8;
      } else {
        reader.failed = true;
      }
      while (!reader.failed && numbers.at < numbers.end) {
        const uint64_t bits = skinwire_read_little_endian(&numbers, 8);
        if (numbers.failed) reader.failed = true;
        if (*ups < 3) turn->up[*ups] = skinwire_float_of_double(bits);
        ++*ups;
      }
    } else {
      skinwire_skip_field(&reader, kind);
    }
  }
  return !reader.failed;
}

static inline bool skinwire_read_describe(skinwire_reader reader, skinwire_describe* describe) {
  uint32_t field = 0, kind = 0;
  while (skinwire_read_key(&reader, &field, &kind)) {
    if (field == 1 && kind == 0) {
      describe->has_known_topology = true;
      describe->known_topology = (uint32_t)skinwire_read_varint(&reader);
    } else {
      skinwire_skip_field(&reader, kind);
    }
  }
  return !reader.failed;
}

static inline bool skinwire_read_nothing(skinwire_reader reader) {
  uint32_t field = 0, kind = 0;
  while (skinwire_read_key(&reader, &field, &kind)) skinwire_skip_field(&reader, kind);
  return !reader.failed;
}

/* The fields of a Command as protobuf has them: the last request counts, and one that comes in pieces is merged. */
static inline bool skinwire_read_command(skinwire_reader reader, skinwire_command* command) {
  uint64_t rate = 0;
  uint32_t led[4] = {0, 0, 0, 0};
  skinwire_turn_to turn = {0, {0, 0, 0}};
  size_t ups = 0;
  skinwire_describe describe = {false, 0};
  uint32_t field = 0, kind = 0;
  command->number = 0;
  command->request = SKINWIRE_UNKNOWN;
  while (skinwire_read_key(&reader, &field, &kind)) {
    if (field == 1 && kind == 0) {
      command->number = (uint32_t)skinwire_read_varint(&reader);
      continue;
    }
    if (field < SKINWIRE_SET_RATE || field > SKINWIRE_DESCRIBE || kind != 2) {
      skinwire_skip_field(&reader, kind);
      continue;
    }
    if (field != (uint32_t)command->request) { /* another request than before, of which nothing stays */
      rate = 0;
      for (int k = 0; k < 4; ++k) led[k] = 0;
      turn.cell = 0;
      ups = 0;
      describe.has_known_topology = false;
      describe.known_topology = 0;
    }
    const skinwire_reader inner = skinwire_read_bytes(&reader);
    command->request = (skinwire_request)field;
    switch (command->request) {
      case SKINWIRE_SET_RATE:
        if (!skinwire_read_set_rate(inner, &rate)) return false;
        break;
      case SKINWIRE_SET_LED:
        if (!skinwire_read_set_led(inner, led)) return false;
        break;
      case SKINWIRE_TURN_TO:
        if (!skinwire_read_turn_to(inner, &turn, &ups)) return false;
        break;
      case SKINWIRE_DESCRIBE:
        if (!skinwire_read_describe(inner, &describe)) return false;
        break;
      case SKINWIRE_EXPLORE_AGAIN:
      case SKINWIRE_UNKNOWN:
        if (!skinwire_read_nothing(inner)) return false;
        break;
    }
  }
  if (reader.failed) return false;
  if (command->request == SKINWIRE_SET_RATE) {
    /* Doubles above 0 have the order of their bits: this is up to 1,000,000, and neither negative nor infinite. */
    if (rate == 0 || rate > 0x412E848000000000u) return false;
    command->of.set_rate.rate_hz = skinwire_float_of_double(rate);
    return command->of.set_rate.rate_hz > 0;
  }
  if (command->request == SKINWIRE_SET_LED) {
    if (led[1] > 255 || led[2] > 255 || led[3] > 255) return false;
    command->of.set_led.cell = led[0];
    command->of.set_led.red = (uint8_t)led[1];
    command->of.set_led.green = (uint8_t)led[2];
    command->of.set_led.blue = (uint8_t)led[3];
  }
  if (command->request == SKINWIRE_TURN_TO) {
    if (ups != 3) return false;
    for (int k = 0; k < 3; ++k) {
      if (!skinwire_is_finite(turn.up[k])) return false;
    }
    command->of.turn_to = turn;
  }
  if (command->request == SKINWIRE_DESCRIBE) command->of.describe = describe;
  return true;
}

/* ---- what you call: receiving */

/* A body alone, as it comes in a datagram. Returns SKINWIRE_COMMAND, SKINWIRE_SKIPPED or SKINWIRE_BROKEN; `command` is
 * only valid with the first. */
static inline skinwire_event skinwire_read_body(const uint8_t* body, size_t size, skinwire_command* command) {
  if (size < 6) return SKINWIRE_BROKEN;
  skinwire_reader tail = {body + size - 4, body + size, false};
  if (skinwire_read_little_endian(&tail, 4) != skinwire_crc32c(body, size - 4)) return SKINWIRE_BROKEN;
  if (body[0] != SKINWIRE_MAJOR || body[1] != 5) return SKINWIRE_SKIPPED;
  const skinwire_reader payload = {body + 2, body + size - 4, false};
  return skinwire_read_command(payload, command) ? SKINWIRE_COMMAND : SKINWIRE_BROKEN;
}

/* With a buffer of SKINWIRE_COMMAND_SIZE bytes or more; `framing` is SKINWIRE_COBS or SKINWIRE_LENGTH. */
static inline skinwire_receiver skinwire_receiver_in(uint8_t* bytes, size_t capacity, skinwire_framing framing) {
  skinwire_receiver receiver;
  receiver.bytes = bytes;
  receiver.capacity = capacity;
  receiver.framing = framing;
  receiver.size = 0;
  receiver.left = 0;
  receiver.head = 0;
  receiver.is_broken = false;
  receiver.is_lost = false;
  return receiver;
}

static inline void skinwire_keep(skinwire_receiver* receiver, uint8_t byte) {
  if (receiver->size < receiver->capacity) {
    receiver->bytes[receiver->size++] = byte;
  } else {
    receiver->is_broken = true; /* too long */
  }
}

/* What the body is, which is whole; begins with the next. */
static inline skinwire_event skinwire_finish_body(skinwire_receiver* receiver, skinwire_command* command) {
  const skinwire_event event =
      receiver->is_broken ? SKINWIRE_BROKEN : skinwire_read_body(receiver->bytes, receiver->size, command);
  receiver->size = 0;
  receiver->left = 0;
  receiver->head = 0;
  receiver->is_broken = false;
  return event;
}

static inline skinwire_event skinwire_receive_cobs(skinwire_receiver* receiver, uint8_t byte,
                                                   skinwire_command* command) {
  if (byte == 0) {
    if (receiver->head == 0) return SKINWIRE_NOTHING; /* nothing came before it, which is allowed */
    if (receiver->left > 0) receiver->is_broken = true;
    return skinwire_finish_body(receiver, command);
  }
  if (receiver->left > 0) {
    --receiver->left;
    skinwire_keep(receiver, byte);
  } else { /* the code of the next block; all but a full one stand for a zero at their end */
    if (receiver->head != 0 && receiver->head != 255) skinwire_keep(receiver, 0);
    receiver->head = byte;
    receiver->left = byte - 1u;
  }
  return SKINWIRE_NOTHING;
}

static inline skinwire_event skinwire_receive_length(skinwire_receiver* receiver, uint8_t byte,
                                                     skinwire_command* command) {
  if (receiver->is_lost) return SKINWIRE_LOST;
  if (receiver->head < 4) {
    receiver->left |= (uint32_t)byte << 8 * receiver->head;
    if (++receiver->head < 4) return SKINWIRE_NOTHING;
    receiver->is_lost = receiver->left < 6 || receiver->left > SKINWIRE_MAX_BODY;
    return receiver->is_lost ? SKINWIRE_LOST : SKINWIRE_NOTHING;
  }
  skinwire_keep(receiver, byte);
  if (--receiver->left > 0) return SKINWIRE_NOTHING;
  if (!receiver->is_broken) { /* a wrong CRC may mean that it was the length that broke */
    skinwire_reader tail = {receiver->bytes + receiver->size - 4, receiver->bytes + receiver->size, false};
    receiver->is_lost = skinwire_read_little_endian(&tail, 4) != skinwire_crc32c(receiver->bytes, receiver->size - 4);
    if (receiver->is_lost) return SKINWIRE_LOST;
  }
  return skinwire_finish_body(receiver, command);
}

/* Give it every byte that arrives, one after the other; `command` is valid if SKINWIRE_COMMAND is returned. */
static inline skinwire_event skinwire_receive(skinwire_receiver* receiver, uint8_t byte, skinwire_command* command) {
  return receiver->framing == SKINWIRE_COBS ? skinwire_receive_cobs(receiver, byte, command)
                                            : skinwire_receive_length(receiver, byte, command);
}

/* ---- means, where the wire is too slow for every sample */

/* Sums of one cell's readings; set it to zero to begin. The sums are whole numbers, so nothing is rounded away. */
typedef struct {
  int32_t sum[3];
  uint64_t sum_of_squares[3];
  uint32_t count;
} skinwire_average;

/* After SKINWIRE_MAX_AVERAGE readings it takes no more. */
static inline void skinwire_average_add(skinwire_average* average, const int16_t raw_lsb[3]) {
  if (average->count >= SKINWIRE_MAX_AVERAGE) return;
  ++average->count;
  for (int axis = 0; axis < 3; ++axis) {
    const int32_t value = raw_lsb[axis];
    const uint32_t size = (uint32_t)(value < 0 ? -value : value);
    average->sum[axis] += value;
    average->sum_of_squares[axis] += (uint64_t)size * size;
  }
}

/* The mean of each axis, the variance of a single reading, and their number, for skinwire_samples; then begins anew.
 * False if there is no reading. Of a single reading the variance is given as 0: the host knows that one tells none. */
static inline bool skinwire_average_take(skinwire_average* average, float lsb_g, float mean_g[3], float variance_g2[3],
                                         uint32_t* count) {
  const uint32_t n = average->count;
  if (n == 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int64_t sum = average->sum[axis];
    const uint64_t scatter = n * average->sum_of_squares[axis] - (uint64_t)(sum * sum); /* n^2 times the mean square */
    mean_g[axis] = lsb_g * (float)average->sum[axis] / (float)n;
    variance_g2[axis] = n < 2 ? 0 : lsb_g * lsb_g * ((float)scatter / ((float)n * (float)(n - 1)));
    average->sum[axis] = 0;
    average->sum_of_squares[axis] = 0;
  }
  *count = n;
  average->count = 0;
  return true;
}

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif

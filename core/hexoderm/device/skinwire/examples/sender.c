/* A skin of two cells on TCP in binary SkinWire 1, in C99 without any library: the few protobuf fields are written by
 * hand, as firmware would.
 *
 *   cc -std=c99 -o sender sender.c
 *   ./sender PORT [SECONDS]        PORT 0 takes any free port; which one is printed
 */
#define _POSIX_C_SOURCE 200112L
#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

enum { TYPE_HELLO = 1, TYPE_TOPOLOGY = 2, TYPE_SAMPLES = 3, TYPE_COMMAND = 5, TYPE_ACK = 6 };
enum { MAJOR = 1, MAX_BODY = 1 << 20, TICKS = 10, PERIOD_US = 1000 };

/* ---- bytes that grow to the right; all messages here are short */

typedef struct {
  uint8_t bytes[1024];
  size_t size;
} buffer;

static void put_byte(buffer* b, uint8_t byte) {
  if (b->size == sizeof b->bytes) abort();
  b->bytes[b->size++] = byte;
}

/* ---- protobuf: a varint is 7 bits a byte, lowest first, the top bit says that more follow */

static void put_varint(buffer* b, uint64_t value) {
  for (; value >= 0x80; value >>= 7) put_byte(b, (uint8_t)(value | 0x80));
  put_byte(b, (uint8_t)value);
}

static void put_number(buffer* b, unsigned field, uint64_t value) {
  put_varint(b, field << 3 | 0);
  put_varint(b, value);
}

static void put_bytes(buffer* b, unsigned field, const void* bytes, size_t size) {
  put_varint(b, field << 3 | 2);
  put_varint(b, size);
  for (size_t k = 0; k < size; ++k) put_byte(b, ((const uint8_t*)bytes)[k]);
}

static void put_text(buffer* b, unsigned field, const char* text) { put_bytes(b, field, text, strlen(text)); }

/* sint32: 0, -1, 1, -2 ... become 0, 1, 2, 3 ... */
static void put_signed(buffer* b, int32_t value) { put_varint(b, (uint32_t)value << 1 ^ (value < 0 ? 0xFFFFFFFFu : 0u)); }

/* ---- frames: length, then major, type, payload, CRC-32C */

static uint32_t crc32c(const uint8_t* bytes, size_t size) {
  uint32_t crc = 0xFFFFFFFFu;
  for (size_t k = 0; k < size; ++k) {
    crc ^= bytes[k];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0x82F63B78u : 0u);
  }
  return ~crc;
}

static void put_u32(buffer* b, uint32_t value) {
  for (int k = 0; k < 4; ++k) put_byte(b, (uint8_t)(value >> 8 * k));
}

static int send_all(int connection, const uint8_t* bytes, size_t size) {
  while (size > 0) {
    const ssize_t sent = send(connection, bytes, size, 0);
    if (sent <= 0) return 0;
    bytes += sent;
    size -= (size_t)sent;
  }
  return 1;
}

/* False once the host is gone. */
static int send_message(int connection, uint8_t type, const buffer* payload) {
  buffer frame = {.size = 0};
  put_u32(&frame, (uint32_t)(1 + 1 + payload->size + 4));
  put_byte(&frame, MAJOR);
  put_byte(&frame, type);
  for (size_t k = 0; k < payload->size; ++k) put_byte(&frame, payload->bytes[k]);
  put_u32(&frame, crc32c(frame.bytes + 4, frame.size - 4));
  return send_all(connection, frame.bytes, frame.size);
}

/* ---- what the skin says */

static int send_hello(int connection) {
  buffer hello = {.size = 0};
  put_text(&hello, 2, "two cells in C");
  put_text(&hello, 3, "hex-bma150");
  put_number(&hello, 4, 1); /* can_light_cells */
  put_number(&hello, 7, (uint64_t)time(NULL) & 0xFFFFFFFFu); /* stream */
  return send_message(connection, TYPE_HELLO, &hello);
}

static void put_cell(buffer* topology, unsigned id, unsigned port, unsigned neighbor, unsigned neighbor_port) {
  buffer link = {.size = 0};
  put_number(&link, 1, port);
  put_number(&link, 2, neighbor);
  put_number(&link, 3, neighbor_port);
  buffer cell = {.size = 0};
  put_number(&cell, 1, id);
  put_bytes(&cell, 3, link.bytes, link.size);
  put_bytes(topology, 4, cell.bytes, cell.size);
}

static int send_topology(int connection) {
  buffer topology = {.size = 0};
  put_number(&topology, 1, 1); /* id */
  put_cell(&topology, 1, 2, 2, 3);
  put_cell(&topology, 2, 3, 1, 2);
  return send_message(connection, TYPE_TOPOLOGY, &topology);
}

/* TICKS ticks of both cells, lying flat: 0, 0, 1 g and a little noise, in LSB of 1/256 g. */
static int send_samples(int connection, uint64_t sequence, uint64_t time_us) {
  const uint8_t cells[] = {1, 2}; /* packed varints; both are below 128 */
  buffer raw = {.size = 0};
  for (int value = 0; value < TICKS * 2 * 3; ++value) put_signed(&raw, (value % 3 == 2 ? 256 : 0) + rand() % 5 - 2);
  buffer samples = {.size = 0};
  put_number(&samples, 1, sequence);
  put_number(&samples, 2, time_us);
  put_number(&samples, 3, PERIOD_US);
  put_bytes(&samples, 4, cells, sizeof cells);
  put_bytes(&samples, 5, raw.bytes, raw.size);
  return send_message(connection, TYPE_SAMPLES, &samples);
}

/* ---- what the host asks */

static int read_varint(const uint8_t** at, const uint8_t* end, uint64_t* value) {
  *value = 0;
  for (unsigned shift = 0; *at < end && shift < 64; shift += 7) {
    const uint8_t byte = *(*at)++;
    *value |= (uint64_t)(byte & 0x7F) << shift;
    if (byte < 0x80) return 1;
  }
  return 0;
}

static int answer_command(int connection, const uint8_t* payload, size_t size) {
  const uint8_t* at = payload;
  const uint8_t* end = payload + size;
  uint64_t number = 0, request = 0, key = 0, value = 0;
  while (at < end && read_varint(&at, end, &key) && read_varint(&at, end, &value)) {
    if (key >> 3 == 1) number = value;
    if ((key & 7) == 2) { /* a request: value is its length */
      if (value > (uint64_t)(end - at)) return 1;
      request = key >> 3;
      at += value;
    }
  }
  if (request == 6) return send_hello(connection) && send_topology(connection); /* Describe */
  buffer ack = {.size = 0};
  put_number(&ack, 1, number);
  if (request == 3) { /* SetLed */
    put_number(&ack, 2, 1);
  } else {
    put_text(&ack, 3, "this example can only light its cells");
  }
  return send_message(connection, TYPE_ACK, &ack);
}

/* Frames that have come whole are answered and taken out of `input`. False for a broken one. */
static int answer_commands(int connection, buffer* input) {
  while (input->size >= 4) {
    const uint8_t* b = input->bytes;
    const uint32_t length = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    if (length < 6 || length > sizeof input->bytes - 4) return 0; /* commands are short */
    if (input->size < 4 + length) return 1;
    const uint8_t* crc = b + 4 + length - 4;
    const uint32_t sent = crc[0] | (uint32_t)crc[1] << 8 | (uint32_t)crc[2] << 16 | (uint32_t)crc[3] << 24;
    if (sent != crc32c(b + 4, length - 4)) return 0;
    if (b[4] == MAJOR && b[5] == TYPE_COMMAND && !answer_command(connection, b + 6, length - 6)) return 0;
    input->size -= 4 + length;
    memmove(input->bytes, input->bytes + 4 + length, input->size);
  }
  return 1;
}

static double now_s(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Waits up to `wait_s` for the descriptor to have something. */
static int has_input(int descriptor, double wait_s) {
  fd_set set;
  FD_ZERO(&set);
  FD_SET(descriptor, &set);
  const long wait_us = wait_s > 0 ? (long)(wait_s * 1e6) : 0;
  struct timeval wait = {wait_us / 1000000, wait_us % 1000000};
  return select(descriptor + 1, &set, NULL, NULL, &wait) > 0;
}

static void stream(int connection, double end_s) {
  if (!send_hello(connection) || !send_topology(connection)) return;
  buffer input = {.size = 0};
  const double start_s = now_s();
  for (uint64_t batch = 0; now_s() < end_s; ++batch) {
    if (!send_samples(connection, batch * TICKS * 2, batch * TICKS * PERIOD_US)) return;
    const double next_s = start_s + 1e-6 * (double)((batch + 1) * TICKS * PERIOD_US);
    while (has_input(connection, next_s - now_s())) {
      const ssize_t count = recv(connection, input.bytes + input.size, sizeof input.bytes - input.size, 0);
      if (count <= 0) return;
      input.size += (size_t)count;
      if (!answer_commands(connection, &input)) return;
    }
  }
}

int main(int argc, char** argv) {
  if (argc < 2) {
    fprintf(stderr, "usage: %s PORT [SECONDS]\n", argv[0]);
    return 2;
  }
  signal(SIGPIPE, SIG_IGN);
  const double end_s = argc > 2 ? now_s() + atof(argv[2]) : 1e300;
  const int server = socket(AF_INET, SOCK_STREAM, 0);
  const int yes = 1;
  setsockopt(server, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  struct sockaddr_in address;
  memset(&address, 0, sizeof address);
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons((uint16_t)atoi(argv[1]));
  socklen_t size = sizeof address;
  if (server < 0 || bind(server, (struct sockaddr*)&address, sizeof address) != 0 || listen(server, 1) != 0 ||
      getsockname(server, (struct sockaddr*)&address, &size) != 0) {
    perror("sender");
    return 1;
  }
  fprintf(stderr, "listening on tcp://127.0.0.1:%u\n", (unsigned)ntohs(address.sin_port));
  while (now_s() < end_s) {
    if (!has_input(server, 0.1)) continue;
    const int connection = accept(server, NULL, NULL);
    if (connection < 0) continue;
    stream(connection, end_s);
    close(connection);
  }
  close(server);
  return 0;
}

/* A skin of two cells on TCP in binary SkinWire 1, in C99 with skinwire.h and no library. firmware/ is the same on a
 * serial port, for a microcontroller.
 *
 *   cc -std=c99 -o sender sender.c
 *   ./sender PORT [SECONDS]        PORT 0 takes any free port; which one is printed
 */
#define _POSIX_C_SOURCE 200112L
#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "../skinwire.h"

enum { TICKS = 10, PERIOD_US = 1000, CELLS = 2 };

static int send_all(int connection, const uint8_t* bytes, size_t size) {
  while (size > 0) {
    const ssize_t sent = send(connection, bytes, size, 0);
    if (sent <= 0) return 0;
    bytes += sent;
    size -= (size_t)sent;
  }
  return 1;
}

/* ---- what the skin says; each is false once the host is gone */

static int send_frame(int connection, const skinwire_frame* frame) {
  return frame->size > 0 && send_all(connection, frame->bytes, frame->size);
}

static int send_hello(int connection, skinwire_frame* frame) {
  skinwire_hello hello = {0};
  hello.device = "two cells in C";
  hello.cell_model = "hex-bma150";
  hello.can_light_cells = true;
  hello.stream = (uint32_t)time(NULL);
  skinwire_put_hello(frame, &hello);
  return send_frame(connection, frame);
}

static int send_topology(int connection, skinwire_frame* frame) {
  static const skinwire_port of_1 = {2, 2, 3}, of_2 = {3, 1, 2}; /* port, the cell there, and its port */
  static const skinwire_cell cells[CELLS] = {{1, NULL, &of_1, 1}, {2, NULL, &of_2, 1}};
  skinwire_topology topology = {0};
  topology.id = 1;
  topology.cells = cells;
  topology.cell_count = CELLS;
  skinwire_put_topology(frame, &topology);
  return send_frame(connection, frame);
}

/* TICKS ticks of both cells, lying flat: 0, 0, 1 g and a little noise, in LSB of 1/256 g. */
static int send_samples(int connection, skinwire_frame* frame, uint64_t sequence, uint64_t time_us) {
  static const uint32_t cells[CELLS] = {1, 2};
  int16_t raw[TICKS * CELLS * 3];
  for (int value = 0; value < TICKS * CELLS * 3; ++value) {
    raw[value] = (int16_t)((value % 3 == 2 ? 256 : 0) + rand() % 5 - 2);
  }
  skinwire_samples samples = {0};
  samples.has_sequence = true;
  samples.sequence = sequence;
  samples.time_us = time_us;
  samples.period_us = PERIOD_US;
  samples.cells = cells;
  samples.cell_count = CELLS;
  samples.tick_count = TICKS;
  samples.raw_lsb = raw;
  skinwire_put_samples(frame, &samples);
  return send_frame(connection, frame);
}

static int answer(int connection, skinwire_frame* frame, const skinwire_command* command) {
  if (command->request == SKINWIRE_DESCRIBE) return send_hello(connection, frame) && send_topology(connection, frame);
  skinwire_ack ack = {0};
  ack.command = command->number;
  ack.done = command->request == SKINWIRE_SET_LED;
  if (!ack.done) ack.text = "this example can only light its cells";
  skinwire_put_ack(frame, &ack);
  return send_frame(connection, frame);
}

/* ---- the connection */

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
  uint8_t output[SKINWIRE_FRAME_SIZE(SKINWIRE_RAW_BODY(CELLS, TICKS))]; /* Hello is shorter */
  uint8_t input[SKINWIRE_COMMAND_SIZE];
  uint8_t received[256];
  skinwire_frame frame = skinwire_frame_in(output, sizeof output, SKINWIRE_LENGTH);
  skinwire_receiver receiver = skinwire_receiver_in(input, sizeof input, SKINWIRE_LENGTH);
  skinwire_command command;
  if (!send_hello(connection, &frame) || !send_topology(connection, &frame)) return;
  const double start_s = now_s();
  for (uint64_t batch = 0; now_s() < end_s; ++batch) {
    if (!send_samples(connection, &frame, batch * TICKS * CELLS, batch * TICKS * PERIOD_US)) return;
    const double next_s = start_s + 1e-6 * (double)((batch + 1) * TICKS * PERIOD_US);
    while (has_input(connection, next_s - now_s())) {
      const ssize_t count = recv(connection, received, sizeof received, 0);
      if (count <= 0) return;
      for (ssize_t k = 0; k < count; ++k) {
        const skinwire_event event = skinwire_receive(&receiver, received[k], &command);
        if (event == SKINWIRE_LOST || (event == SKINWIRE_COMMAND && !answer(connection, &frame, &command))) return;
      }
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

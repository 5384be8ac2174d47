/* A skin on a serial port: describes itself, samples all cells, and does what the host asks.
 *
 * board_write() waits until the port has taken all bytes, which is the simplest there is; sample() leaves out ticks that
 * were missed meanwhile. Where that costs too many, write by DMA or by an interrupt. */
#include "../../skinwire.h"

#include "board.h"
#include "explore.h"
#include "skin.h"

enum { TICKS = 5, RATE_HZ = 100, MOST_HZ = 200, TOPOLOGY_ID = 1 };
enum { WORKING_EVERY_US = 1000000, FAR_BEHIND_US = 250000 };

/* Larger than Samples with all ticks, and than Topology: 50 bytes a cell with four ports. */
static uint8_t output[SKINWIRE_FRAME_SIZE(SKINWIRE_RAW_BODY(SKIN_CELLS, TICKS)) + 50 * SKIN_CELLS];
static uint8_t input[SKINWIRE_COMMAND_SIZE];
static skinwire_frame frame;
static skinwire_receiver receiver;

static uint32_t cell_ids[SKIN_CELLS];
static skinwire_port ports[SKIN_CELLS][SKIN_PORTS];

static float rate_hz = RATE_HZ;
static uint32_t period_us = 1000000 / RATE_HZ;
static uint64_t next_tick_us;
static uint64_t samples_sent;

static int16_t readings[TICKS][SKIN_CELLS][3];
static uint64_t first_tick_us;
static unsigned ticks;

static uint32_t turn_command; /* that is not answered yet; 0: none */
static skinwire_turn_to turn_target;
static uint64_t working_said_us;

/* Asks the lines of all ports, and keeps what they are joined to. */
static void find_neighbors(void) {
  explored_end found[SKIN_CELLS][SKIN_PORTS];
  explore(SKIN_CELLS, SKIN_PORTS, &found[0][0]);
  for (unsigned cell = 0; cell < SKIN_CELLS; ++cell) {
    for (unsigned port = 0; port < SKIN_PORTS; ++port) {
      const skinwire_port joined = {port + 1, found[cell][port].cell, found[cell][port].port};
      ports[cell][port] = joined;
    }
  }
}

static void send(size_t size) { board_write(frame.bytes, size); }

static void send_description(bool has_topology) {
  skinwire_hello hello = {0};
  hello.device = "seven cells on a Cortex-M3";
  hello.cell_model = "hex-bma150";
  hello.can_light_cells = true;
  hello.can_turn = true;
  hello.rate_hz = rate_hz;
  send(skinwire_put_hello(&frame, &hello));
  if (has_topology) return;

  skinwire_cell cells[SKIN_CELLS] = {{0}};
  for (unsigned k = 0; k < SKIN_CELLS; ++k) {
    cells[k].id = cell_ids[k];
    cells[k].ports = ports[k];
    cells[k].port_count = SKIN_PORTS;
  }
  skinwire_topology topology = {0};
  topology.id = TOPOLOGY_ID;
  topology.cells = cells;
  topology.cell_count = SKIN_CELLS;
  send(skinwire_put_topology(&frame, &topology));
}

static void send_readings(void) {
  skinwire_samples samples = {0};
  if (ticks == 0) return;
  samples.has_sequence = true;
  samples.sequence = samples_sent;
  samples.time_us = first_tick_us;
  samples.period_us = period_us;
  samples.cells = cell_ids;
  samples.cell_count = SKIN_CELLS;
  samples.tick_count = ticks;
  samples.raw_lsb = &readings[0][0][0];
  send(skinwire_put_samples(&frame, &samples));
  samples_sent += ticks * SKIN_CELLS;
  ticks = 0;
}

/* One tick whenever it is time. Those that were missed, because the serial port was busy for long, are left out. */
static void sample(uint64_t now_us) {
  if (now_us < next_tick_us) return;
  if (now_us - next_tick_us > FAR_BEHIND_US) {
    send_readings(); /* the ticks of a message follow each other without a gap */
    next_tick_us = now_us;
  }
  if (ticks == 0) first_tick_us = next_tick_us;
  for (unsigned cell = 0; cell < SKIN_CELLS; ++cell) skin_read(cell, next_tick_us, readings[ticks][cell]);
  next_tick_us += period_us;
  if (++ticks == TICKS) send_readings();
}

static void send_ack(uint32_t command, bool done, bool working, const char* text) {
  skinwire_ack ack = {0};
  ack.command = command;
  ack.done = done;
  ack.working = working;
  ack.text = text;
  send(skinwire_put_ack(&frame, &ack));
}

static const char* set_rate(float asked_hz) {
  if (asked_hz < 1 || asked_hz > MOST_HZ) return "the rate is 1 to 200 Hz";
  send_readings(); /* all ticks of a message have one period */
  rate_hz = asked_hz;
  period_us = (uint32_t)(1000000 / asked_hz);
  return NULL;
}

/* Whether the command comes again while it is being done. A host that starts anew counts from 1 again, so the number
 * alone does not tell. */
static bool is_turning_so(const skinwire_command* command) {
  const skinwire_turn_to* to = &command->of.turn_to;
  if (turn_command == 0 || command->number != turn_command || to->cell != turn_target.cell) return false;
  for (int k = 0; k < 3; ++k) {
    if (to->up[k] != turn_target.up[k]) return false;
  }
  return true;
}

static const char* turn(const skinwire_command* command, uint64_t now_us) {
  const skinwire_turn_to* to = &command->of.turn_to;
  if (is_turning_so(command)) { /* and does not begin anew */
    send_ack(turn_command, false, true, NULL);
    working_said_us = now_us;
    return NULL;
  }
  if (to->cell < 1 || to->cell > SKIN_CELLS) return "there is no such cell";
  if (!skin_turn(to->cell - 1, to->up, now_us)) return "up is no direction";
  if (turn_command != 0) send_ack(turn_command, false, false, "another turn was asked for");
  turn_command = command->number;
  turn_target = *to;
  working_said_us = now_us;
  return NULL;
}

static void answer(const skinwire_command* command, uint64_t now_us) {
  const char* why_not = NULL;
  switch (command->request) {
    case SKINWIRE_DESCRIBE:
      send_description(command->of.describe.has_known_topology && command->of.describe.known_topology == TOPOLOGY_ID);
      return;
    case SKINWIRE_TURN_TO:
      why_not = turn(command, now_us);
      if (why_not == NULL) return; /* answered when it is done */
      break;
    case SKINWIRE_SET_LED: {
      const skinwire_set_led* led = &command->of.set_led;
      if (led->cell < 1 || led->cell > SKIN_CELLS) {
        why_not = "there is no such cell";
      } else {
        skin_light(led->cell - 1, led->red, led->green, led->blue);
      }
      break;
    }
    case SKINWIRE_SET_RATE:
      why_not = set_rate(command->of.set_rate.rate_hz);
      if (why_not == NULL) send_description(true);
      break;
    case SKINWIRE_EXPLORE_AGAIN:
      find_neighbors(); /* soldered cells find the same neighbours again, so the topology keeps its id */
      send_description(false);
      break;
    case SKINWIRE_UNKNOWN:
      why_not = "this firmware does not know that command";
      break;
  }
  send_ack(command->number, why_not == NULL, false, why_not);
}

static void tend_turn(uint64_t now_us) {
  if (turn_command == 0) return;
  if (!skin_is_turning(now_us)) {
    send_ack(turn_command, true, false, NULL);
    turn_command = 0;
  } else if (now_us - working_said_us >= WORKING_EVERY_US) {
    send_ack(turn_command, false, true, NULL);
    working_said_us = now_us;
  }
}

int main(void) {
  static const uint8_t end_of_frame = 0;
  board_start();
  frame = skinwire_frame_in(output, sizeof output, SKINWIRE_COBS);
  receiver = skinwire_receiver_in(input, sizeof input, SKINWIRE_COBS);
  for (unsigned k = 0; k < SKIN_CELLS; ++k) cell_ids[k] = k + 1;
  board_write(&end_of_frame, 1); /* ends what a reset may have cut off */
  find_neighbors();
  send_description(false);
  next_tick_us = board_time_us();
  for (;;) {
    uint8_t byte = 0;
    skinwire_command command;
    while (board_read(&byte)) {
      if (skinwire_receive(&receiver, byte, &command) == SKINWIRE_COMMAND) answer(&command, board_time_us());
    }
    sample(board_time_us());
    tend_turn(board_time_us());
    if (board_time_us() < next_tick_us) board_sleep();
  }
}

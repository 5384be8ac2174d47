#include "tests/core/device/skinwire/device_side_in_c.h"

#include "hexoderm/device/skinwire/skinwire.h"
#include "hexoderm/device/skinwire/skinwire.h" /* a second time, which changes nothing */

static const uint32_t cells[2] = {1, 300};

static size_t put_samples(skinwire_frame* frame) {
  static const int16_t raw_lsb[6] = {0, -1, 256, 511, -512, 3};
  skinwire_samples samples = {0};
  samples.has_sequence = true;
  samples.time_us = 1000000;
  samples.cells = cells;
  samples.cell_count = 2;
  samples.tick_count = 1;
  samples.raw_lsb = raw_lsb;
  return skinwire_put_samples(frame, &samples);
}

static size_t put_means(skinwire_frame* frame) {
  static const int16_t readings[2][3] = {{1, 2, 254}, {3, 2, 258}};
  float mean_g[6], variance_g2[6];
  uint32_t count[2];
  skinwire_average average[2] = {{{0}, {0}, 0}, {{0}, {0}, 0}};
  for (int k = 0; k < 2; ++k) {
    skinwire_average_add(&average[k], readings[0]);
    skinwire_average_add(&average[k], readings[1]);
    if (!skinwire_average_take(&average[k], 1.0f / 256, mean_g + 3 * k, variance_g2 + 3 * k, &count[k])) return 0;
  }
  skinwire_samples samples = {0};
  samples.time_us = 2000000;
  samples.cells = cells;
  samples.cell_count = 2;
  samples.tick_count = 1;
  samples.mean_g = mean_g;
  samples.variance_g2 = variance_g2;
  samples.count = count;
  return skinwire_put_samples(frame, &samples);
}

static size_t put_description(skinwire_frame* frame) {
  static const skinwire_port port = {2, 300, 3};
  static const skinwire_cell cell = {1, "forearm", &port, 1};
  skinwire_hello hello = {0};
  hello.cell_model = "hex-bma150";
  hello.rate_hz = 100;
  size_t size = skinwire_put_hello(frame, &hello);
  if (size == 0) return 0;
  skinwire_frame rest = skinwire_frame_in(frame->bytes + size, frame->capacity - size, frame->framing);
  skinwire_topology topology = {0};
  topology.cells = &cell;
  topology.cell_count = skinwire_cells_that_fit(&rest, &cell, 1);
  const size_t topology_size = skinwire_put_topology(&rest, &topology);
  return topology_size == 0 ? 0 : size + topology_size;
}

static size_t put_ack(skinwire_frame* frame) {
  skinwire_ack ack = {0};
  ack.command = 2;
  ack.text = "there is no cell 7";
  return skinwire_put_ack(frame, &ack);
}

static size_t put_status(skinwire_frame* frame) {
  skinwire_status status = {0};
  status.exploring = true;
  return skinwire_put_status(frame, &status);
}

static size_t put_joints(skinwire_frame* frame) {
  static const char* const names[1] = {"elbow"};
  static const float position[1] = {1.25f};
  skinwire_joints joints = {0};
  joints.names = names;
  joints.position = position;
  joints.joint_count = 1;
  return skinwire_put_joints(frame, &joints);
}

size_t skinwire_in_c_every_message(uint8_t* bytes, size_t capacity) {
  size_t (*const put[])(skinwire_frame*) = {put_description, put_samples, put_means, put_status, put_ack, put_joints};
  size_t size = 0;
  for (size_t k = 0; k < sizeof put / sizeof put[0]; ++k) {
    skinwire_frame frame = skinwire_frame_in(bytes + size, capacity - size, SKINWIRE_COBS);
    const size_t added = put[k](&frame);
    if (added == 0) return 0;
    size += added;
  }
  return size;
}

uint32_t skinwire_in_c_command(const uint8_t* bytes, size_t size) {
  uint8_t buffer[SKINWIRE_COMMAND_SIZE];
  skinwire_receiver receiver = skinwire_receiver_in(buffer, sizeof buffer, SKINWIRE_COBS);
  skinwire_command command;
  for (size_t k = 0; k < size; ++k) {
    if (skinwire_receive(&receiver, bytes[k], &command) == SKINWIRE_COMMAND) return command.number;
  }
  return 0;
}

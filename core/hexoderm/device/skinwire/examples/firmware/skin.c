#include "skin.h"

enum { TURN_MS = 1200, LSB_PER_G = 256, RANGE_LSB = 511, OFFSET_LSB = 10 };

const int16_t skin_rotation[SKIN_CELLS][3][3] = {
    {{15932, -713, 3755}, {1138, 16251, -1744}, {-3648, 1957, 15852}},
    {{13422, -1187, 9322}, {450, 16315, 1429}, {-9386, -915, 13398}},
    {{14134, -1071, 8217}, {2802, 15907, -2746}, {-7799, 3774, 13906}},
    {{16285, -1465, -1042}, {1547, 16256, 1335}, {915, -1425, 16296}},
    {{16345, 301, -1085}, {-664, 15327, -5751}, {910, 5781, 15303}},
    {{9797, -2426, 12906}, {-206, 16072, 3177}, {-13131, -2062, 9579}},
    {{14745, -1654, -6948}, {-2609, 13590, -8772}, {6649, 9000, 11967}},
};

const skin_link skin_links[SKIN_LINKS] = {
    {0, 0, 1, 3}, {0, 1, 2, 2}, {0, 2, 3, 1}, {0, 3, 4, 0}, {1, 0, 5, 3}, {4, 3, 6, 0},
};

/* Directions that point up, in the part's frame, of length SKIN_ONE. */
static int32_t from_up[3] = {0, 0, SKIN_ONE};
static int32_t to_up[3] = {0, 0, SKIN_ONE};
static uint64_t turn_began_us;
static bool has_turned; /* since the start; before, there is no time at which a turn began */

static bool is_pulled[SKIN_CELLS][SKIN_PORTS];
static uint8_t lights[SKIN_CELLS][3];
static uint32_t random_state = 2463534242u;

/* Xorshift of 32 bits. */
static uint32_t random_bits(void) {
  random_state ^= random_state << 13;
  random_state ^= random_state >> 17;
  random_state ^= random_state << 5;
  return random_state;
}

/* Noise in 256ths of an LSB: nearly Gaussian, as a sum of four numbers, with a deviation of 2.9 LSB. */
static int32_t noise_in_256ths(void) {
  const uint32_t a = random_bits();
  const uint32_t b = random_bits();
  const uint32_t sum = (a & 1023) + (a >> 10 & 1023) + (b & 1023) + (b >> 10 & 1023); /* deviates by 591 */
  return ((int32_t)sum - 2046) * 5 / 4;
}

/* How far a cell's axis is off, -OFFSET_LSB to OFFSET_LSB; the same in every run. */
static int32_t offset_lsb(unsigned cell, int axis) {
  const uint32_t mixed = (3 * cell + (uint32_t)axis + 1) * 2654435761u;
  return (int32_t)((mixed >> 16) % (2 * OFFSET_LSB + 1)) - OFFSET_LSB;
}

static uint32_t square_root(uint32_t value) {
  uint32_t root = 0;
  for (uint32_t bit = 1u << 15; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return root;
}

/* To length SKIN_ONE; false if there is hardly any. Components are at most 2 * SKIN_ONE. */
static bool normalize(int32_t v[3]) {
  /* In 14 bits, so that the sum of the squares fits 32. */
  const int32_t x = v[0] / 2, y = v[1] / 2, z = v[2] / 2;
  const int32_t length = (int32_t)square_root((uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z));
  if (length < SKIN_ONE / 64) return false;
  for (int k = 0; k < 3; ++k) v[k] = v[k] * (SKIN_ONE / 2) / length;
  return true;
}

bool skin_is_turning(uint64_t time_us) { return has_turned && time_us < turn_began_us + 1000u * TURN_MS; }

/* Up at a time: between the directions that a turn leads from and to, with a smooth beginning and end. */
static void up_at(uint64_t time_us, int32_t up[3]) {
  for (int k = 0; k < 3; ++k) up[k] = to_up[k];
  if (!skin_is_turning(time_us)) return;
  const uint32_t passed_us = time_us > turn_began_us ? (uint32_t)(time_us - turn_began_us) : 0;
  const int32_t part = (int32_t)(passed_us / TURN_MS * SKIN_ONE / 1000); /* of the time; shares are in SKIN_ONE */
  const int32_t square = part * part / SKIN_ONE;
  const int32_t share = square * (3 * SKIN_ONE - 2 * part) / SKIN_ONE;
  for (int k = 0; k < 3; ++k) up[k] = from_up[k] + (to_up[k] - from_up[k]) * share / SKIN_ONE;
  if (!normalize(up)) { /* half way to the opposite direction */
    for (int k = 0; k < 3; ++k) up[k] = to_up[k];
  }
}

void skin_read(unsigned cell, uint64_t time_us, int16_t raw_lsb[3]) {
  int32_t up[3];
  up_at(time_us, up);
  for (int axis = 0; axis < 3; ++axis) {
    int32_t along = 0; /* the part of 1 g along the axis, times SKIN_ONE */
    for (int k = 0; k < 3; ++k) along += skin_rotation[cell][k][axis] * up[k] / SKIN_ONE;
    /* In 256ths of an LSB, then rounded to whole ones. */
    const int32_t fine = along * (256 * LSB_PER_G / SKIN_ONE) + offset_lsb(cell, axis) * 256 + noise_in_256ths();
    int32_t lsb = (fine + (fine < 0 ? -128 : 128)) / 256;
    if (lsb > RANGE_LSB) lsb = RANGE_LSB;
    if (lsb < -RANGE_LSB - 1) lsb = -RANGE_LSB - 1;
    raw_lsb[axis] = (int16_t)lsb;
  }
}

/* The end of a line at the other cell; false if the port is free. */
static bool find_other_end(unsigned cell, unsigned port, unsigned* other_cell, unsigned* other_port) {
  for (unsigned k = 0; k < SKIN_LINKS; ++k) {
    const skin_link* link = &skin_links[k];
    if (link->cell == cell && link->port == port) {
      *other_cell = link->other_cell, *other_port = link->other_port;
      return true;
    }
    if (link->other_cell == cell && link->other_port == port) {
      *other_cell = link->cell, *other_port = link->port;
      return true;
    }
  }
  return false;
}

void skin_pull_line(unsigned cell, unsigned port, bool down) { is_pulled[cell][port] = down; }

bool skin_line_is_low(unsigned cell, unsigned port) {
  unsigned other_cell = 0, other_port = 0;
  if (is_pulled[cell][port]) return true;
  return find_other_end(cell, port, &other_cell, &other_port) && is_pulled[other_cell][other_port];
}

bool skin_turn(unsigned cell, const float up[3], uint64_t time_us) {
  int32_t in_cell[3], in_part[3], now[3];
  for (int k = 0; k < 3; ++k) {
    if (!(up[k] >= -1.1f && up[k] <= 1.1f)) return false;
    in_cell[k] = (int32_t)(up[k] * SKIN_ONE);
  }
  if (!normalize(in_cell)) return false;
  for (int k = 0; k < 3; ++k) {
    in_part[k] = 0;
    for (int axis = 0; axis < 3; ++axis) in_part[k] += skin_rotation[cell][k][axis] * in_cell[axis] / SKIN_ONE;
  }
  up_at(time_us, now);
  for (int k = 0; k < 3; ++k) from_up[k] = now[k], to_up[k] = in_part[k];
  turn_began_us = time_us;
  has_turned = true;
  return normalize(to_up);
}

void skin_light(unsigned cell, uint8_t red, uint8_t green, uint8_t blue) {
  lights[cell][0] = red, lights[cell][1] = green, lights[cell][2] = blue;
}

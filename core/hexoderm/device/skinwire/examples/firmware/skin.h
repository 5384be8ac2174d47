/* A made-up skin of seven cells, in place of a real one: accelerometers that can be read, four lines between each cell
 * and its neighbours, lights, and a motor that turns the part. A real firmware replaces skin.c and leaves the rest.
 *
 * Cells have the shape of the model "hex-bma150". Here they are known by their index, 0 to SKIN_CELLS - 1; their IDs on
 * the wire are one more. */
#ifndef SKIN_H
#define SKIN_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { SKIN_CELLS = 7, SKIN_PORTS = 4, SKIN_ONE = 16384 };

/* A link of the skin: ports are 0 to 3, one less than the model numbers them. */
typedef struct {
  uint8_t cell, port, other_cell, other_port;
} skin_link;

/* The truth, which a real skin does not know: how each cell is turned in the part (its axes are the columns, times
 * SKIN_ONE), and what is joined to what. */
enum { SKIN_LINKS = 6 };
extern const int16_t skin_rotation[SKIN_CELLS][3][3];
extern const skin_link skin_links[SKIN_LINKS];

/* One reading of a cell's accelerometer at a time, x y z in LSB of 1/256 g. */
void skin_read(unsigned cell, uint64_t time_us, int16_t raw_lsb[3]);

/* The line of a port: pulled up, low while one of its two ends pulls it down. */
void skin_pull_line(unsigned cell, unsigned port, bool down);
bool skin_line_is_low(unsigned cell, unsigned port);

/* The part begins to turn until `up`, a vector in the frame of a cell, points up. False if `up` is no direction. */
bool skin_turn(unsigned cell, const float up[3], uint64_t time_us);
bool skin_is_turning(uint64_t time_us);

void skin_light(unsigned cell, uint8_t red, uint8_t green, uint8_t blue);

#ifdef __cplusplus
}
#endif

#endif

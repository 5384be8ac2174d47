#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* skinwire.h as a C compiler sees it (device_side_in_c.c). Returns the size of a frame with one of every message of a
 * device, one after the other, in COBS; 0 if one was not put. */
size_t skinwire_in_c_every_message(uint8_t* bytes, size_t capacity);

/* The number of the command in a frame of COBS, 0 if there is none. */
uint32_t skinwire_in_c_command(const uint8_t* bytes, size_t size);

#ifdef __cplusplus
}
#endif

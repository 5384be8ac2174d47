/* What the firmware needs of a microcontroller. board_mps2.c has it for a board that QEMU emulates; for another one,
 * write these five functions, a linker script and a start-up, or take those of its maker. */
#ifndef BOARD_H
#define BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Starts the clock and the serial port, 115,200 baud, 8N1. Bytes that arrive are kept by an interrupt. */
void board_start(void);

/* Microseconds since board_start(). Must be called once a minute at least. */
uint64_t board_time_us(void);

/* The next byte that arrived; false if there is none. */
bool board_read(uint8_t* byte);

/* Returns when the serial port has taken all bytes. */
void board_write(const uint8_t* bytes, size_t size);

/* Sleeps until something may have happened, at most a few milliseconds. */
void board_sleep(void);

#endif

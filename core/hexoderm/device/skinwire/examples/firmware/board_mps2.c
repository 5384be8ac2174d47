/* Arm MPS2 with the Cortex-M3 image AN385, as "qemu-system-arm -M mps2-an385" emulates it. */
#include "board.h"

enum {
  CLOCK_MHZ = 25,
  BAUD_DIVIDER = CLOCK_MHZ * 1000000 / 115200,
  WAKE_EVERY_US = 2000,
  INPUT_SIZE = 256 /* a power of two */
};

/* CMSDK UART 0, CMSDK timer 0, and of the core SysTick and the first register of the interrupt controller. */
#define UART_DATA (*(volatile uint32_t*)0x40004000u)
#define UART_STATE (*(volatile uint32_t*)0x40004004u)
#define UART_CONTROL (*(volatile uint32_t*)0x40004008u)
#define UART_INTERRUPT (*(volatile uint32_t*)0x4000400Cu)
#define UART_DIVIDER (*(volatile uint32_t*)0x40004010u)
#define TIMER_CONTROL (*(volatile uint32_t*)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t*)0x40000004u)
#define TIMER_RELOAD (*(volatile uint32_t*)0x40000008u)
#define SYSTICK_CONTROL (*(volatile uint32_t*)0xE000E010u)
#define SYSTICK_RELOAD (*(volatile uint32_t*)0xE000E014u)
#define SYSTICK_VALUE (*(volatile uint32_t*)0xE000E018u)
#define INTERRUPT_ENABLE (*(volatile uint32_t*)0xE000E100u)

enum { UART_TX_FULL = 1, UART_RX_FULL = 2, UART_TX_ON = 1, UART_RX_ON = 2, UART_RX_INTERRUPT_ON = 8 };
enum { UART_RX_INTERRUPT = 2, UART_RX_LINE = 0 };

/* The interrupt writes `written` and the main loop `read`: a ring between two that needs no lock. */
static volatile uint8_t input[INPUT_SIZE];
static volatile uint32_t input_written;
static volatile uint32_t input_read;

static uint64_t time_us;
static uint32_t time_at; /* the timer, as it was then */

void systick_handler(void) {} /* only wakes board_sleep() */

void uart0_rx_handler(void) {
  UART_INTERRUPT = UART_RX_INTERRUPT;
  while (UART_STATE & UART_RX_FULL) {
    const uint8_t byte = (uint8_t)UART_DATA;
    if (input_written - input_read < INPUT_SIZE) input[input_written++ % INPUT_SIZE] = byte;
  }
}

void board_start(void) {
  TIMER_RELOAD = 0xFFFFFFFFu;
  TIMER_VALUE = 0xFFFFFFFFu;
  TIMER_CONTROL = 1;
  time_at = ~TIMER_VALUE;
  UART_DIVIDER = BAUD_DIVIDER;
  UART_CONTROL = UART_TX_ON | UART_RX_ON | UART_RX_INTERRUPT_ON;
  INTERRUPT_ENABLE = 1u << UART_RX_LINE;
  SYSTICK_RELOAD = CLOCK_MHZ * WAKE_EVERY_US - 1;
  SYSTICK_VALUE = 0;
  SYSTICK_CONTROL = 7; /* on, with its interrupt, from the core's clock */
}

/* The timer counts down and around, once in 171 s. Whole microseconds are taken off it, and the rest stays for the next
 * time. */
uint64_t board_time_us(void) {
  const uint32_t passed_us = (~TIMER_VALUE - time_at) / CLOCK_MHZ;
  time_at += passed_us * CLOCK_MHZ;
  time_us += passed_us;
  return time_us;
}

bool board_read(uint8_t* byte) {
  if (input_read == input_written) return false;
  *byte = input[input_read++ % INPUT_SIZE];
  return true;
}

void board_write(const uint8_t* bytes, size_t size) {
  for (size_t k = 0; k < size; ++k) {
    while (UART_STATE & UART_TX_FULL) continue;
    UART_DATA = bytes[k];
  }
}

void board_sleep(void) { __asm__ volatile("wfi"); }

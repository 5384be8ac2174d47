/* From reset to main() on a Cortex-M, without a C library: vectors, variables, and the functions that a compiler calls
 * by itself. */
#include <stddef.h>
#include <stdint.h>

extern uint32_t image_data_from[], image_data_begin[], image_data_end[]; /* mps2.ld says where these are */
extern uint32_t image_zero_begin[], image_zero_end[], image_stack_top[];

int main(void);
void systick_handler(void);
void uart0_rx_handler(void);

static void reset(void) {
  const uint32_t* from = image_data_from;
  for (uint32_t* to = image_data_begin; to < image_data_end;) *to++ = *from++;
  for (uint32_t* to = image_zero_begin; to < image_zero_end;) *to++ = 0;
  main();
  for (;;) continue;
}

static void stop(void) {
  for (;;) continue;
}

typedef union {
  void (*handler)(void);
  const uint32_t* stack;
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[] = {
    {.stack = image_stack_top},
    {reset},
    {stop}, /* non-maskable */
    {stop}, /* hard fault */
    {stop},
    {stop},
    {stop},
    {0},
    {0},
    {0},
    {0},
    {stop}, /* supervisor call */
    {stop},
    {0},
    {stop}, /* pending supervisor call */
    {systick_handler},
    {uart0_rx_handler}, /* interrupt 0 of the MPS2 */
};

/* Compiled without the rule by which a compiler makes a call of memcpy of this very loop. */
#define PLAIN __attribute__((used, optimize("no-tree-loop-distribute-patterns")))

PLAIN void* memcpy(void* to, const void* from, size_t size) {
  for (size_t k = 0; k < size; ++k) ((uint8_t*)to)[k] = ((const uint8_t*)from)[k];
  return to;
}

PLAIN void* memset(void* to, int value, size_t size) {
  for (size_t k = 0; k < size; ++k) ((uint8_t*)to)[k] = (uint8_t)value;
  return to;
}

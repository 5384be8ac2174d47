#include "explore.h"

#include "skin.h"

/* The line of a port is pulled down: how many others are low, and the last of them. */
static unsigned listen(unsigned cells, unsigned ports, unsigned cell, unsigned port, explored_end* end) {
  unsigned answers = 0;
  for (unsigned other = 0; other < cells; ++other) {
    for (unsigned other_port = 0; other_port < ports; ++other_port) {
      if ((other == cell && other_port == port) || !skin_line_is_low(other, other_port)) continue;
      end->cell = other + 1;
      end->port = other_port + 1;
      ++answers;
    }
  }
  return answers;
}

unsigned explore(unsigned cells, unsigned ports, explored_end found[]) {
  static const explored_end free_end = {0, 0};
  unsigned joined = 0;
  for (unsigned cell = 0; cell < cells; ++cell) {
    for (unsigned port = 0; port < ports; ++port, ++found) {
      *found = free_end;
      skin_pull_line(cell, port, true);
      const unsigned answers = listen(cells, ports, cell, port, found);
      skin_pull_line(cell, port, false);
      if (answers == 1) {
        ++joined;
      } else {
        *found = free_end;
      }
    }
  }
  return joined;
}

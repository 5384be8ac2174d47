/* Which port of which cell is joined to which, found over the line of each port (build_a_cell.md). */
#ifndef EXPLORE_H
#define EXPLORE_H

/* The other end of a port's line, both numbered from 1 on; 0 and 0: the port is free. */
typedef struct {
  unsigned cell, port;
} explored_end;

/* Fills in `found`, cell by cell, with the ends of all ports. A port at which nothing answers is free; so is one at
 * which several answer, whose wires touch each other. Returns how many ports are joined. */
unsigned explore(unsigned cells, unsigned ports, explored_end found[]);

#endif

#include "hexoderm/geometry/lanes.h"

#include "hexoderm/util/vector_instructions.h"

namespace hexoderm {

bool hasFourLanes() { return hasVectorInstructions(); }

}  // namespace hexoderm

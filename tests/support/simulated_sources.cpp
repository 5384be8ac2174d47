#include "hexoderm/sim/simulated_source.h"

namespace hexoderm {
namespace {

// Tests open "sim:" as the programs do.
[[maybe_unused]] const bool kAreAdded = (addSimulatedSources(), true);

}  // namespace
}  // namespace hexoderm

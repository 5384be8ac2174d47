#pragma once

#include "hexoderm/solve/estimate/estimate.h"

#include <memory>
#include <stop_token>

namespace hexoderm {

/// The steps of reconstruct() up to the description, with its arguments, which must outlive the estimate; null if it
/// was stopped.
std::unique_ptr<const Estimate> solveSkin(const SessionSnapshot& snapshot, const SolverOptions& options,
                                          const Reconstruction* earlier = nullptr, const std::stop_token& stop = {},
                                          SolveProgress* progress = nullptr);

}  // namespace hexoderm

#pragma once

#include <cstdint>

namespace hexoderm {

/// Prints what the factor of a simulated sheet's matrix takes, beside Eigen's and CHOLMOD's of the same matrix, and
/// what the kernels gain by vector instructions.
void compareFactors(std::int64_t rows, std::int64_t columns);

}  // namespace hexoderm

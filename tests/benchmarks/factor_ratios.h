#pragma once

#include <cstddef>

namespace hexoderm {

/// Prints what the factor of a simulated sheet's matrix takes, beside Eigen's and CHOLMOD's of the same matrix, and
/// what the kernels gain by vector instructions.
void compareFactors(std::size_t rows, std::size_t columns);

}  // namespace hexoderm

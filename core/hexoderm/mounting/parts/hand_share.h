#pragma once

// How much of a usual hand there was.

#include <functional>

namespace hexoderm {

/// A usual hand that holds a part swings it and trembles. How much of that there really was shows where several patches
/// saw the same gravity. Of shares of the usual variance, from 1 to 1/64 and each as probable beforehand, the mean by
/// what was seen. `log_evidence`: logarithm of how probable that is with a share, but for a constant.
double meanHandShare(const std::function<double(double hand_share)>& log_evidence);

}  // namespace hexoderm

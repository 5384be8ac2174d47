#include "hexoderm/session/storable.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"

#include <cmath>

namespace hexoderm {

Message problemOf(const GravitySample& sample) {
  if (!isWithin(sample.mean_g, kMaxAcceleration_g)) return message("the mean must be finite and at most 1e6 g");
  if (!isWithin(sample.cov_g2, kMaxVariance_g2)) return message("the covariance must be finite and at most 1e13 g^2");
  if ((sample.cov_g2.diagonal().array() < 0).any()) return message("variances must be at least 0");
  if (!isCovariance(sample.cov_g2)) return message("the covariance must be positive semidefinite");
  if (sample.temperature_c && !std::isfinite(*sample.temperature_c)) return message("the temperature must be finite");
  return {};
}

void requireStorable(const GravitySample& sample) {
  if (const Message problem = problemOf(sample); !problem.empty()) {
    throw InvalidArgument(message("cell {}: {} to be stored", sample.cell, problem));
  }
}

}  // namespace hexoderm

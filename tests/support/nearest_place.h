#pragma once

#include "hexoderm/mounting/place/place.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

namespace hexoderm::test {

/// A candidate, or the place on the ways that it leaves open, where the truth deviates least: by the square of the
/// place's error over its covariance.
struct NearestPlace {
  double squared_deviates = std::numeric_limits<double>::infinity();
  const PlacedPatch* patch = nullptr;
  SE3 T_l_o;
};

inline NearestPlace nearestPlace(const PlaceResult& result, const SE3& truth) {
  NearestPlace nearest;
  for (const PlaceCandidate& candidate : result.candidates) {
    const PlacedPatch& patch = candidate.patches.front();
    // In the patch's frame, which goes with it along the way.
    Eigen::Matrix<double, 6, 6> into = Eigen::Matrix<double, 6, 6>::Identity();
    into.topLeftCorner<3, 3>() = patch.place.T_l_o.R.transpose();
    const Eigen::Matrix<double, 6, 6> C = into * *patch.place.cov_t_r * into.transpose();
    const auto look = [&](const SE3& T_l_o) {
      Eigen::Matrix<double, 6, 1> e;
      e << T_l_o.R.transpose() * (truth.t - T_l_o.t), logSO3(T_l_o.R.transpose() * truth.R);
      const double squared = e.dot(C.ldlt().solve(e));
      if (squared < nearest.squared_deviates) nearest = {squared, &patch, T_l_o};
    };
    look(patch.place.T_l_o);
    for (const FreeDirection& free : patch.free) std::ranges::for_each(free.way, look);
  }
  return nearest;
}

}  // namespace hexoderm::test

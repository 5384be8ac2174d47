#pragma once

#include "hexoderm/solve/checks/calibration_check.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

namespace hexoderm::test {

/// With which probability the best test finds a cell that turned by `turn_o` (patch frame), if it is asked about this
/// cell alone, does not know the axis, and names unchanged ones as rarely as `check` does: what the readings say about
/// a turn is normal about it with the inverse of the information. One pose shows two of its angles, several show three.
inline double turnFoundByBestTest(const CalibrationCheck& check, const CheckedCell& cell,
                                  const Eigen::Vector3d& turn_o) {
  const double angles = check.poses.size() > 1 ? 3 : 2;
  const double false_alarms = 2 * cdf(complement(boost::math::normal(), check.changed_from));
  const double limit = quantile(complement(boost::math::chi_squared(angles), false_alarms));
  const double shift = turn_o.dot(cell.turn_information * turn_o);
  return cdf(complement(boost::math::non_central_chi_squared(angles, shift), limit));
}

}  // namespace hexoderm::test

#include "hexoderm/capture/stillness.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <cmath>

namespace hexoderm {

StillnessOptions::StillnessOptions() : drift_limit_rad_s(1 * kDegree), rearm_angle_rad(5 * kDegree) {}

void StillnessOptions::validate() const {
  const auto within = [](double value, double low, double high, const std::string& name) {
    if (!(value >= low && value <= high)) {
      throw InvalidArgument("stillness: " + name + " must be between " + formatExact(low) + " and " +
                            formatExact(high) + ", found " + formatExact(value));
    }
  };
  within(drift_limit_rad_s, 1e-4, 10, "drift_limit_rad_s");
  within(excess_limit_g, 1e-4, 10, "excess_limit_g");
  within(hold_s, 0.2, 1.5, "hold_s");
  within(drift_window_s, hold_s, 1.5, "drift_window_s");
  within(rearm_angle_rad, 0, kPi, "rearm_angle_rad");
  within(release_factor, 1, 10, "release_factor");
  within(quiet_fraction, 0, 1, "quiet_fraction");
  within(patience_s, 0, 3600, "patience_s");
  within(silent_after_s, 0.1, 3600, "silent_after_s");
}

std::string describe(const OddCell& odd) {
  const std::string cell = "Cell " + toString(odd.cell);
  switch (odd.kind) {
    case OddCellKind::Dead:
      return cell + " is dead: it reads " + formatFixed(odd.value * 1000, 0) + " mg, no gravity";
    case OddCellKind::Stuck:
      return cell + " is stuck: it repeated one reading while the part moved";
    case OddCellKind::Noisy:
      return cell + " is noisy: it scatters by " + formatFixed(odd.value * 1000, 0) + " mg rms while the rest is still";
    case OddCellKind::Restless:
      return cell + " is restless: it turns by " + formatFixed(toDegrees(odd.value), 1) +
             " deg/s while the rest is still";
    case OddCellKind::Silent:
      return cell + " is silent: nothing came from it for " + formatFixed(odd.value, 1) + " s";
  }
  return cell;
}

}  // namespace hexoderm

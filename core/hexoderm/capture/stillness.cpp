#include "hexoderm/capture/stillness.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"

namespace hexoderm {

void StillnessOptions::validate() const {
  const auto within = [](double value, double low, double high, const std::string& name) {
    if (!(value >= low && value <= high)) {
      throw InvalidArgument(
          message("stillness: {} must be between {} and {}, found {}", name, Number{low}, Number{high}, Number{value}));
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

std::string_view blockerName(Blocker blocker) {
  constexpr EnumNames<Blocker> kNames = {{"none", "waiting", "not_moved", "turning", "shaking", "cell_turning"}};
  return kNames.of(blocker);
}

std::string_view oddCellName(OddCellKind kind) {
  constexpr EnumNames<OddCellKind> kNames = {{"dead", "stuck", "noisy", "restless", "silent"}};
  return kNames.of(kind);
}

Message describe(const OddCell& odd) {
  switch (odd.kind) {
    case OddCellKind::Dead:
      return message("Cell {} is dead: it reads {}, no gravity", odd.cell, MilliG{odd.value});
    case OddCellKind::Stuck:
      return message("Cell {} is stuck: it repeated one reading while the part moved", odd.cell);
    case OddCellKind::Noisy:
      return message("Cell {} is noisy: it scatters by {} rms while the rest is still", odd.cell, MilliG{odd.value});
    case OddCellKind::Restless:
      return message("Cell {} is restless: it turns by {} deg/s while the rest is still", odd.cell,
                     Number{toDegrees(odd.value), 1});
    case OddCellKind::Silent:
      return message("Cell {} is silent: nothing came from it for {}", odd.cell, Seconds{odd.value, 1});
  }
  return message("Cell {}", odd.cell);
}

}  // namespace hexoderm

#include "hexoderm/sim/simulated_body.h"

#include "hexoderm/base/error.h"

#include <utility>

namespace hexoderm {

void SimulatedBody::requireCell(CellId cell) const {
  const std::size_t count = neighbors().size();
  if (cell.value() > 0 && cell.value() <= count) return;
  throw InvalidArgument(message("there is no cell {}; cells are 1 to {}", cell, count));
}

Eigen::Vector3d SimulatedBody::unitUp(const Eigen::Vector3d& up) {
  if (up.allFinite() && up.norm() >= 1e-9) return up.normalized();
  throw InvalidArgument(
      message("simulated skin: the direction that points up must be a finite vector other than zero"));
}

std::optional<JointReport> JointReporting::before(const SimulatedBody& body, double time_s) {
  constexpr double kEvery_s = 0.1;
  const bool turns = body.turning();
  const bool came_to_rest = std::exchange(was_turning_, turns) && !turns;
  if (due_s_ && time_s < *due_s_ && !came_to_rest) return std::nullopt;
  due_s_ = time_s + kEvery_s;
  JointReport report{time_s, body.jointAngles()};
  if (report.angles.positions.empty()) return std::nullopt;
  return report;
}

}  // namespace hexoderm

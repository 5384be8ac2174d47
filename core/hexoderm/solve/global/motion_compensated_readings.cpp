#include "hexoderm/solve/global/motion_compensated_readings.h"

#include "hexoderm/base/median.h"
#include "hexoderm/solve/tree/gravity_table.h"

#include <algorithm>

namespace hexoderm {
namespace {

double squaredLever(const GlobalState& state, std::size_t cell) {
  return (state.cells[cell].t - state.middle_o).squaredNorm();
}

/// What one cell's readings leave unexplained.
struct CellNoise {
  double lever_sq = 0;  // m^2
  double variance_g2 = 0;
  double residual_g2 = 0;  // mean square, per axis
};

std::vector<CellNoise> noiseOfCells(const GlobalProblem& problem, const GlobalState& state,
                                    std::span<const SensorState> sensors) {
  std::vector<CellNoise> noise;
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    const std::vector<CellReading>& readings = sensors[cell].readings;
    if (readings.empty()) continue;
    CellNoise of_cell{squaredLever(state, cell)};
    for (std::size_t k = 0; k < readings.size(); ++k) {
      of_cell.variance_g2 += readings[k].variance_g2 / static_cast<double>(readings.size());
      of_cell.residual_g2 += sensors[cell].fit.residual_g[k].squaredNorm() / static_cast<double>(3 * readings.size());
    }
    noise.push_back(of_cell);
  }
  return noise;
}

}  // namespace

MotionCompensatedReadings::MotionCompensatedReadings(const GlobalProblem& problem)
    : as_measured_(problem.readings),
      swings_(PoseAngularAccelerations::unknown(problem.poses, problem.acceleration_sigma)) {}

bool MotionCompensatedReadings::followAngularAccelerations(GlobalProblem& problem, GlobalState& state,
                                                           std::span<const SensorState> sensors) {
  constexpr double kSettled = 0.02 * kTremorAcceleration_rad_s2;
  PoseAngularAccelerations next =
      findAngularAccelerations(problem, state, sensors, swings_, problem.acceleration_sigma);
  if (any_swings_ && next.distanceTo(swings_) <= kSettled) return false;
  any_swings_ = true;
  swings_ = std::move(next);
  problem.acceleration_sigma = accelerationSpread(swings_.acceleration_o, swings_.covariance);
  state.acceleration_o = swings_.acceleration_o;
  for (std::size_t pose = 0; pose < problem.poses; ++pose) state.force_o[pose] += swings_.force_change_o[pose];
  rewrite(problem, state, sensors);
  return true;
}

void MotionCompensatedReadings::rewrite(GlobalProblem& problem, const GlobalState& state,
                                        std::span<const SensorState> sensors) const {
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    for (std::size_t k = 0; k < problem.readings[cell].size(); ++k) {
      const CellReading& measured = as_measured_[cell][k];
      const AngularAccelerationInReading swing =
          swingInReading(problem, state, cell, sensors[cell].fit, swings_, measured.pose);
      CellReading& reading = problem.readings[cell][k];
      reading.y_g = measured.y_g - swing.added_g;
      reading.variance_g2 =
          noise_factor_ * (measured.variance_g2 + swing.variance_g2) + noise_per_lever_sq_ * squaredLever(state, cell);
    }
  }
}

bool MotionCompensatedReadings::widenNoise(GlobalProblem& problem, const GlobalState& state,
                                           std::span<const SensorState> sensors) {
  if (noise_is_widened_) return false;
  std::vector<CellNoise> seen = noiseOfCells(problem, state, sensors);
  if (seen.size() < 2) return false;
  std::ranges::sort(seen, {}, &CellNoise::lever_sq);
  const std::size_t inner = seen.size() / 2;
  std::vector<double> factors;
  for (std::size_t k = 0; k < inner; ++k) factors.push_back(seen[k].residual_g2 / seen[k].variance_g2);
  const double factor = median(std::move(factors));
  std::vector<double> swings_g2;  // (2/3) (s / g)^2, per m^2
  for (std::size_t k = inner; k < seen.size(); ++k) {
    const double excess_g2 = seen[k].residual_g2 - factor * seen[k].variance_g2;
    swings_g2.push_back(seen[k].lever_sq > 0 ? excess_g2 / seen[k].lever_sq : 0);
  }
  const double swing_g2 = median(std::move(swings_g2));
  if (factor <= 1 && swing_g2 <= 0) return false;
  noise_factor_ = std::max(1.0, factor);
  noise_per_lever_sq_ = std::max(0.0, swing_g2);
  rewrite(problem, state, sensors);
  noise_is_widened_ = true;
  return true;
}

}  // namespace hexoderm

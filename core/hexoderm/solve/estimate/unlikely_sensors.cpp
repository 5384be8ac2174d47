#include "hexoderm/solve/estimate/unlikely_sensors.h"

#include "hexoderm/solve/global/sensor_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace hexoderm {
namespace {

constexpr double kMinTimes = 1.5;
/// Fewer are no population.
constexpr std::size_t kFewestCells = 4;
constexpr std::size_t kCellsPerOneLeftOut = 4;
/// The most that healthy cells' sum has left without the worst: of chi-squareds with 2 to 6 degrees of freedom 0.29 to
/// 0.59.
constexpr double kShareLeft = 0.6;

struct Contradiction {
  double deviate = 0;
  double sigma = 0;  ///< that the errors show
};

/// All errors of one kind, see nameUnlikelySensors().
class ErrorsOfKind {
 public:
  void add(const WeighedEvidence& sensor, SensorError kind) {
    double of_cell = 0;
    for (Eigen::Index k = 0; k < kSensorParameters; ++k) {
      if (kindOfParameter(k) != kind) continue;
      of_cell += std::pow(sensor.weighted[k], 2);
      expected_ += sensor.precision(k, k);
      for (Eigen::Index l = 0; l < kSensorParameters; ++l) {
        if (kindOfParameter(l) == kind) squares_ += std::pow(sensor.precision(k, l), 2);
      }
    }
    of_cells_.push_back(of_cell);
  }

  /// How they contradict the model's variance, where they are clearly larger. Sorts.
  std::optional<Contradiction> contradiction(double model_variance) {
    if (of_cells_.size() < kFewestCells || squares_ <= 0) return std::nullopt;
    std::ranges::sort(of_cells_);
    const std::size_t left_out = (of_cells_.size() + kCellsPerOneLeftOut - 1) / kCellsPerOneLeftOut;
    const auto worst = of_cells_.end() - static_cast<std::ptrdiff_t>(left_out);
    const double sum = std::accumulate(of_cells_.begin(), worst, 0.0) / kShareLeft;
    const Misfit misfit{sum * expected_ / squares_, expected_ * expected_ / squares_};
    const double variance = model_variance + (sum - expected_) / squares_;
    const bool contradicts = variance > kMinTimes * kMinTimes * model_variance;
    return contradicts ? std::optional(Contradiction{misfit.deviate(), std::sqrt(variance)}) : std::nullopt;
  }

  [[nodiscard]] std::size_t cells() const { return of_cells_.size(); }

 private:
  std::vector<double> of_cells_;
  double expected_ = 0;
  double squares_ = 0;
};

/// What was taken for a broken sensor may be one of many whose errors are larger than the model says.
bool mayBeLikeOthers(std::span<const Finding> findings, CellId cell) {
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    const bool is_about_readings = finding.code == FindingCode::InconsistentSensor ||
                                   finding.code == FindingCode::WrongGain ||
                                   finding.code == FindingCode::TurnedSensor || finding.code == FindingCode::MovedCell;
    return is_about_readings && std::ranges::count(finding.cells, cell) > 0;
  });
}

/// Of a cell whose readings are not used: turned so that they fit the patch's forces best. None of fewer than two.
std::optional<SensorEvidence> evidenceOfUnused(const SkinLinks& skin, const GlobalRefinement& joint, std::size_t cell) {
  const Eigen::Matrix3d& R_u_a = skin.model().accelerometer.T_u_a.R;
  std::vector<CellReading> readings;
  std::vector<Eigen::Vector3d> forces_o;
  for (std::size_t pose = 0; pose < joint.poses().size(); ++pose) {
    const GravityTable::Entry& entry = skin.table().at(cell, joint.poses()[pose]);
    if (!entry.measured) continue;
    readings.push_back(joint.lot().without({pose, R_u_a.transpose() * entry.mean_g, entry.variance_g2}));
    forces_o.push_back(joint.solution().state.force_o[pose]);
  }
  if (readings.size() < 2) return std::nullopt;
  const AccelerometerPrior prior(skin.model().accelerometer);
  const OwnAttitude own = findAttitude(prior, readings, forces_o, joint.placementOf(cell).R * R_u_a);
  std::vector<Eigen::Vector3d> v_g;
  for (const Eigen::Vector3d& force_o : forces_o) v_g.push_back(own.R.transpose() * force_o);
  return ownEvidence(readings, v_g);
}

std::optional<SensorEvidence> evidenceOf(const SkinLinks& skin, const GlobalRefinement& joint, std::size_t cell,
                                         std::span<const Finding> findings) {
  const std::span<const CellReading> readings = joint.readingsOf(cell);
  if (readings.size() >= 2) return ownEvidence(readings, joint.forcesAt(cell));
  if (!mayBeLikeOthers(findings, skin.graph().cells()[cell].id)) return std::nullopt;
  return evidenceOfUnused(skin, joint, cell);
}

MessageArgument asPercent(double sigma) { return Number{100 * sigma, 1}; }

Message describe(SensorError kind, std::size_t cells, double sigma, const Accelerometer& model) {
  const Message what_to_do = message(
      "Other chips are on the skin than the model is about, or it is too sure of them: the estimate and its "
      "uncertainty suffer. Estimate the sigmas (hexoderm-cli sensors) and use the cell model that comes out.");
  const Message spread =
      kind == SensorError::Offset
          ? message("The offsets of {} accelerometers spread by about {} (1 sigma), and the cell model says {}.", cells,
                    MilliG{sigma}, MilliG{model.largestOffsetSigma_g()})
      : kind == SensorError::Scale
          ? message(
                "The scale errors of {} accelerometers spread by about {} % (1 sigma), and the cell model says {} %.",
                cells, asPercent(sigma), asPercent(model.scale_sigma))
          : message(
                "The cross-axis sensitivities of {} accelerometers spread by about {} % (1 sigma), and the cell "
                "model says {} %.",
                cells, asPercent(sigma), asPercent(model.cross_axis_sigma));
  return inRow({spread, what_to_do});
}

}  // namespace

void nameUnlikelySensors(const SkinLinks& skin, std::span<const PatchSolver> patches, std::vector<Finding>& findings) {
  const Accelerometer& model = skin.model().accelerometer;
  const Eigen::VectorXd prior = priorVariances(model, 1);
  std::array<ErrorsOfKind, kSensorErrors> kinds;
  for (const PatchSolver& patch : patches) {
    if (patch.cells().size() < kFewestCells) continue;  // so few cells decide on the forces that they are compared with
    for (const std::size_t cell : patch.cells()) {
      const std::optional<SensorEvidence> evidence = evidenceOf(skin, *patch.joint(), cell, findings);
      if (!evidence) continue;
      const WeighedEvidence sensor = weigh(*evidence, prior);
      for (std::size_t kind = 0; kind < kSensorErrors; ++kind)
        kinds.at(kind).add(sensor, static_cast<SensorError>(kind));
    }
  }
  // Errors of one kind that are too large spill over into the others where poses are few: the clearest is named.
  std::optional<Contradiction> clearest;
  SensorError of_kind{};
  for (std::size_t kind = 0; kind < kSensorErrors; ++kind) {
    const auto parameter = static_cast<Eigen::Index>(kind);  // of the first axis: offset, scale, cross-axis
    const auto found = kinds.at(kind).contradiction(prior[parameter]);
    if (!found || !(found->deviate > skin.options().max_misfit)) continue;
    if (clearest && found->deviate <= clearest->deviate) continue;
    clearest = found;
    of_kind = static_cast<SensorError>(kind);
  }
  if (!clearest) return;
  findings.push_back(
      makeFinding(FindingCode::SensorsUnlikeModel, describe(of_kind, kinds.front().cells(), clearest->sigma, model)));
}

}  // namespace hexoderm

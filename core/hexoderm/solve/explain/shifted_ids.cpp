#include "hexoderm/solve/explain/explainer.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kMostOfLink = 30;  // squared misfit of what is no skin link, however wrong

/// Squared misfit of a link's angles, in the elastomer's sigmas and the rotation's own.
double squaredMisfitOf(const CellModel& model, const Port& source, const EdgeRotation& edge) {
  const Eigen::Vector3d angles(edge.angles.twist_rad, edge.angles.bend_rad, edge.angles.yaw_rad);
  const Eigen::Matrix3d axes = linkAxes(source);
  Eigen::Matrix3d covariance = axes.transpose() * edge.covariance * axes;
  covariance.diagonal() +=
      Eigen::Vector3d(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad).cwiseAbs2();
  return std::min(kMostOfLink, angles.dot(covariance.ldlt().solve(angles)));
}

/// The links of a skin as the cells read, and as they would if each had the reading of another one.
class OtherReadings {
 public:
  explicit OtherReadings(const SkinLinks& skin) : skin_(skin) {
    for (std::size_t cell = 0; cell < skin.graph().cells().size(); ++cell) {
      if (skin.readings().measured(cell)) measured_.push_back(cell);
    }
    for (std::size_t k = 0; k < skin.graph().links().size(); ++k) {
      const GraphLink& link = skin.graph().links()[k];
      if (!link.muted() && skin.readings().measured(link)) links_.push_back(k);
    }
  }

  /// As large a misfit as that of healthy skins, and a third more.
  [[nodiscard]] double usualMisfit() const { return 2 * static_cast<double>(links_.size()); }

  [[nodiscard]] double misfit() const {
    double sum = 0;
    for (const std::size_t k : links_) {
      sum += squaredMisfitOf(skin_.model(), skin_.sourcePort(skin_.graph().links()[k]), skin_.edges()[k]);
    }
    return sum;
  }

  /// The same if every cell has the reading of the one `on` places further on, in ascending IDs and round.
  [[nodiscard]] double misfitWith(std::size_t on) const {
    std::vector<std::size_t> other(skin_.graph().cells().size());
    for (std::size_t k = 0; k < measured_.size(); ++k) other[measured_[k]] = measured_[(k + on) % measured_.size()];
    double sum = 0;
    for (const std::size_t k : links_) {
      const GraphLink& link = skin_.graph().links()[k];
      GraphLink shifted = link;
      shifted.source = other[link.source];
      shifted.target = other[link.target];
      const EdgeRotation edge = estimateEdgeRotation(skin_.model(), skin_.sourcePort(link), skin_.targetPort(link),
                                                     skin_.readings().readingsOf(shifted), skin_.options());
      sum += squaredMisfitOf(skin_.model(), skin_.sourcePort(link), edge);
    }
    return sum;
  }

  [[nodiscard]] std::size_t cells() const { return measured_.size(); }

 private:
  const SkinLinks& skin_;
  std::vector<std::size_t> measured_;
  std::vector<std::size_t> links_;
};

class ShiftedIds {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    constexpr std::size_t kFewest = 4;
    constexpr double kLeastGain = 40;
    if (std::exchange(asked_, true)) return std::nullopt;
    const OtherReadings readings(estimate.skin());
    const double as_is = readings.misfit();
    if (readings.cells() < kFewest || as_is < readings.usualMisfit()) return std::nullopt;
    const double with = std::min(readings.misfitWith(1), readings.misfitWith(readings.cells() - 1));
    if (as_is - with < kLeastGain || with > readings.usualMisfit()) return std::nullopt;
    Explanation found;
    found.findings.push_back(makeFinding(
        FindingCode::ContradictsModel,
        message("The links fit if every cell has the readings of the cell with the next ID: the IDs of the readings "
                "are shifted by one. Connect the skin again. No other fault was looked for.")));
    found.ends_search = true;
    return found;
  }

 private:
  bool asked_ = false;
};

}  // namespace

Explainer makeShiftedIdExplainer() { return {Estimate::Stage::Links, ShiftedIds()}; }

}  // namespace hexoderm
